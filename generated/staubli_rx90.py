# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: c0b36274375d6e2a
"""staubli_rx90: Stäubli RX90.

Inverse kinematics, generated from robots/staubli_rx90.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/staubli_rx90.yaml. The formulas and where they come from:
staubli_rx90.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Every entry of
a pose counts.
"""

import math
import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType

# The runtime that lies beside this file, by whatever name this is imported, and no other one: it is
# in a package named after the folder. A dot in a name would be one between packages.
_BESIDE = str(Path(__file__).resolve().parent)
_FOLDER = _BESIDE.replace("%", "%25").replace(".", "%2E")
sys.modules.setdefault(_FOLDER, ModuleType(_FOLDER)).__path__ = [_BESIDE]


def _runtime(name):
    return import_module(f"{_FOLDER}.dhgen_runtime.{name}")


_HOW = _runtime("jit").of_file(__file__, interface=1)
_arms, _status, _functions = _runtime("arm"), _runtime("status"), _runtime("functions")
_atan2 = _runtime("angles").atan2
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 6), _runtime("arrays").zeros

NAME = "staubli_rx90"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "back-up-noflip", "back-up-flip", "back-down-noflip", "back-down-flip", "front-down-noflip",
    "front-down-flip", "front-up-noflip", "front-up-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 9e-05 [m], doubt_limit_squared2 = 8.1e-09 [m^2],
# doubt_limit = 9.999999999999999e-05.
a2 = 0.45  # link length 3 [m]
d4 = 0.45  # joint offset 4 [m]
free_limit1 = 9e-13  # a length that fixes no angle [m]
longest3 = 0.81  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
longest3_reach = 0.8100000000001621  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.8099999999999838  # the longest, where branches merge [m^2]
shortest3_apart = 8.099999999999999e-29  # the shortest, where branches merge [m^2]
free_limit_squared2 = 8.1e-25  # square of a length that fixes no angle [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.405  # 2 * d4 * a2 [m^2]
k2 = 6.096631611034903  # 1 / (k1^2) [m^-4]
m1 = 8.100000000000001e-09  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 1.312949748921684e-11
m4 = 1.1111111111111112  # d4 * k1 * k2 [m^-1]
m5 = 6.561e-17  # doubt_limit_squared2^2 [m^4]
m6 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(1.111, 1.111, 1.111, 1.0, 1.0, 1.0), size=0.9, steps=("follows seed",),
))

# The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.45, 0.0),
    (0.0, 0.45, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, -1.5707963267948966),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="modified",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v3, v4, y3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - s1 * s4, x3_y * c4 + c1 * s4, x3_z * c4
    z5_x, y4_y, z5_z = s1 * c4 + x3_x * s4, c1 * c4 - x3_y * s4, x3_z * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 - v3 * s5, x4_y * c5 - v4 * s5, x4_z * c5 + y3_z * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1] = x5_x * c6 - z5_x * s6, -(z5_x * c6 + x5_x * s6)
    T[0, 2], T[0, 3] = -(v3 * c5 + x4_x * s5), x2_x * a2 - v3 * d4
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + y4_y * s6, y4_y * c6 - x5_y * s6, -(v4 * c5 + x4_y * s5)
    T[1, 3] = x2_y * a2 - v4 * d4
    T[2, 0], T[2, 1] = x5_z * c6 - z5_z * s6, -(z5_z * c6 + x5_z * s6)
    T[2, 2], T[2, 3] = y3_z * c5 - x4_z * s5, s2 * a2 + y3_z * d4
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2, p3_x, p3_y = s1 * s2, x2_x * a2, x2_y * a2
    p3_z = s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v3, v4, y3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    p4_x, p4_y, p4_z = p3_x - v3 * d4, p3_y - v4 * d4, p3_z + y3_z * d4
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    c5, s5, v5 = math.cos(q[4]), math.sin(q[4]), p4_z - p3_z
    J[0, 0], J[0, 1], J[0, 2] = -p4_y, -(c1 * p4_z), -(c1 * v5)
    J[1, 0], J[1, 1], J[1, 2] = p4_x, -(s1 * p4_z), -(s1 * v5)
    J[2, 1], J[2, 2] = s1 * p4_y + c1 * p4_x, s1 * (p4_y - p3_y) + c1 * (p4_x - p3_x)
    J[3, 1], J[3, 2], J[3, 3] = s1, s1, -v3
    J[3, 4], J[3, 5] = s1 * c4 + x3_x * s4, -(v3 * c5 + (x3_x * c4 - s1 * s4) * s5)
    J[4, 1], J[4, 2], J[4, 3] = -c1, -c1, -v4
    J[4, 4], J[4, 5] = x3_y * s4 - c1 * c4, -(v4 * c5 + (x3_y * c4 + c1 * s4) * s5)
    J[5, 0], J[5, 3], J[5, 4] = 1.0, y3_z, x3_z * s4
    J[5, 5] = y3_z * c5 - x3_z * c4 * s5
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[2, 4]
    w1 = math.sqrt(T14 * T14 + T24 * T24)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 8: U1[3, 4] and U1[1, 4]
    v1 = T34 * T34

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(T14 * factor1)
        s1 = math.sin(seed[0]) if free1 else -(T24 * factor1)
        q1 = _atan2(s1, c1)
        D1 = w1 * e1

        # theta3
        N3 = v1 + D1 * D1
        K3 = N3 - k1
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        v2 = k1 * K3 * k2

        # theta2, type 3: U1[3, 4] and U1[1, 4]
        X1_2 = a2 + d4 * v2
        v3, v4 = T34 * X1_2, D1 * X1_2

        # theta4, type 2: U4[2, 3]
        v5 = T13 * c1 + T23 * s1
        Y4 = T13 * s1 - T23 * c1
        v6 = Y4 * Y4

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        v7, v8, v10 = T12 * s1 - T22 * c1, T12 * c1 + T22 * s1, T11 * s1 - T21 * c1
        v11 = T11 * c1 + T21 * s1

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            c3 = k2 * (k1 * (w3 * e3))
            q3 = _atan2(-v2, c3)

            # theta2
            Y1_2 = d4 * c3
            S2 = v3 + D1 * Y1_2
            C2 = T34 * Y1_2 - v4
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else S2 * factor2
            q2 = _atan2(s2, c2)

            # theta4
            c23, s23 = c3 * c2 + v2 * s2, c3 * s2 - v2 * c2
            X4 = c23 * v5 + T33 * s23
            w4 = math.sqrt(X4 * X4 + v6)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[3, 3] and U4[1, 3]
            c5 = T33 * c23 - s23 * v5

            # theta6
            v9, v12 = c23 * v8 + T32 * s23, c23 * v11 + T31 * s23

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)
                s5 = w4 * e4

                # theta5
                q5 = _atan2(s5, c5)

                # theta6
                q6 = _atan2(-(c4 * v10 + s4 * v12), -(c4 * v7 + s4 * v9))
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
                q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
                status[row] = FREE_JOINT if free1 or free2 or free4 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T11, T12, T13 = kept[0 * w + k], kept[1 * w + k], kept[2 * w + k]
        T14, T21, T22 = kept[3 * w + k], kept[4 * w + k], kept[5 * w + k]
        T23, T24, T31 = kept[6 * w + k], kept[7 * w + k], kept[8 * w + k]
        T32, T33, T34 = kept[9 * w + k], kept[10 * w + k], kept[11 * w + k]

        # theta1, type 2: U1[2, 4]
        v1 = T14 * T14 + T24 * T24
        w1, v2 = math.sqrt(v1), 1.0 / v1

        # theta3, type 8: U1[3, 4] and U1[1, 4]
        N3 = v1 + T34 * T34
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)
        v3, v4 = w3 - w3, k1 * (N3 - k1)
        v5, v6 = k2 * v4, k1 * w3
        c3 = k2 * v6

        # theta2, type 3: U1[3, 4] and U1[1, 4]
        X1_2, Y1_2 = a2 + d4 * v5, d4 * c3
        v7, v8 = T34 * X1_2, w1 * Y1_2
        v9, v10, v11 = v7 + v8, v7 - v8, m4 * (T34 * N3)
        v12 = w3 * (m4 * w1)
        S2_pp, S2_pm, v13 = v11 + v12, v11 - v12, w1 * X1_2
        v14 = T34 * Y1_2
        v15, v16, v17 = v14 - v13, v13 + v14, w3 * (m4 * T34)
        v18 = m4 * (w1 * N3)
        C2_pp, C2_mp, v19 = v17 - v18, v17 + v18, S2_pp * S2_pp
        v20, v21, v22 = v19 + C2_pp * C2_pp, S2_pm * S2_pm + C2_mp * C2_mp, v19 + -C2_pp * -C2_pp
        w2_pp, w2_pm, w2_mm = math.sqrt(v20), math.sqrt(v21), math.sqrt(v22)
        v23, v24, v25 = 1.0 / v20, 1.0 / v21, 1.0 / v22

        # theta4, type 2: U4[2, 3]
        v26 = v5 * v9
        c23_pp, c23_pm = w2_pp * (v23 * (c3 * v15 + v26)), w2_pm * (v24 * (c3 * v16 + v5 * v10))
        c23_mm, v27 = w2_mm * (v25 * (v26 - c3 * -v15)), c3 * v9
        s23_pp, v28 = w2_pp * (v23 * (v27 - v5 * v15)), v5 * v16 - c3 * v10
        s23_pm, s23_mp = w2_pm * (v24 * v28), w2_pm * (v24 * -v28)
        v29, v30 = w2_mm * (v25 * (v27 + v5 * -v15)), w1 * (v2 * (T14 * T13 + T24 * T23))
        X4_pp, v31 = s23_pp * T33 - c23_pp * v30, c23_pm * v30
        X4_pm, X4_mp, X4_mm = s23_pm * T33 - v31, v31 + s23_mp * T33, c23_mm * v30 - v29 * T33
        Y4 = w1 * (v2 * (T14 * T23 - T24 * T13))
        v32 = Y4 * Y4
        v33, v34, v35 = v32 + X4_pp * X4_pp, v32 + X4_pm * X4_pm, v32 + X4_mp * X4_mp
        v36, w4_pp, w4_pm = v32 + X4_mm * X4_mm, math.sqrt(v33), math.sqrt(v34)
        w4_mp, w4_mm, factor4_pp = math.sqrt(v35), math.sqrt(v36), w4_pp * (1.0 / v33)
        factor4_pm, factor4_mp = w4_pm * (1.0 / v34), w4_mp * (1.0 / v35)
        factor4_mm, v37, v38 = w4_mm * (1.0 / v36), X4_pp * factor4_pp, X4_pm * factor4_pm
        v39, v40, s4_pp = X4_mp * factor4_mp, X4_mm * factor4_mm, Y4 * factor4_pp
        s4_pm, s4_mp, s4_mm = Y4 * factor4_pm, Y4 * factor4_mp, Y4 * factor4_mm
        v41, v42 = math.copysign(half_turn, Y4), math.copysign(half_turn, -Y4)

        # theta5, type 3: U4[3, 3] and U4[1, 3]
        v43 = c23_pm * T33

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        v44, v45 = w1 * (v2 * (T14 * T22 - T24 * T12)), w1 * (v2 * (T14 * T12 + T24 * T22))
        v46, v47 = w1 * (v2 * (T14 * T21 - T24 * T11)), w1 * (v2 * (T14 * T11 + T24 * T21))
        v48, v49 = v37 * v46 - s4_pp * (s23_pp * T31 - c23_pp * v47), c23_pm * v47
        v50 = v38 * v46 - s4_pm * (s23_pm * T31 - v49)
        v51 = s4_mp * (v49 + s23_mp * T31) - v39 * v46
        v52, v53 = s4_mm * (c23_mm * v47 - v29 * T31) - v40 * v46, c23_pm * v45

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v36 <= m6 or v22 <= m5 or v35 <= m6 or v34 <= m6 or v21 <= m5 or v33 <= m6 or v1
            <= m1 or abs(D3_squared) <= m3 or v20 <= m5 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = v3, v4, v41
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v42, v48, v50
        kept[23 * w + k], kept[24 * w + k], turns[0 * w + k] = v51, v52, -T24
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = -v4, S2_pp, S2_pm
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = S2_pm, S2_pp, Y4
        turns[7 * w + k], turns[8 * w + k], turns[9 * w + k] = Y4, -Y4, -Y4
        turns[10 * w + k], turns[11 * w + k], turns[12 * w + k] = w4_pp, w4_pm, w4_mp
        turns[13 * w + k], turns[14 * w + k], turns[15 * w + k] = w4_mm, v48, v50
        turns[16 * w + k], turns[17 * w + k], turns[24 * w + k] = v51, v52, -T14
        turns[25 * w + k], turns[26 * w + k], turns[27 * w + k] = v6, C2_pp, -C2_mp
        turns[28 * w + k], turns[29 * w + k], turns[30 * w + k] = C2_mp, -C2_pp, -X4_pp
        turns[31 * w + k], turns[32 * w + k], turns[33 * w + k] = -X4_pm, -X4_mp, -X4_mm
        turns[34 * w + k], turns[35 * w + k] = c23_pp * T33 + s23_pp * v30, v43 + s23_pm * v30
        turns[36 * w + k], turns[37 * w + k] = v43 - s23_mp * v30, c23_mm * T33 + v29 * v30
        turns[38 * w + k] = v37 * v44 - s4_pp * (s23_pp * T32 - c23_pp * v45)
        turns[39 * w + k] = v38 * v44 - s4_pm * (s23_pm * T32 - v53)
        turns[40 * w + k] = s4_mp * (v53 + s23_mp * T32) - v39 * v44
        turns[41 * w + k] = s4_mm * (c23_mm * v45 - v29 * T32) - v40 * v44
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 18 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(18 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        T24, v3, v4 = kept[7 * w + k], kept[17 * w + k], kept[18 * w + k]
        v41, v42, v48 = kept[19 * w + k], kept[20 * w + k], kept[21 * w + k]
        v50, v51, v52 = kept[22 * w + k], kept[23 * w + k], kept[24 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5, angle6 = turns[3 * w + k], turns[4 * w + k], turns[5 * w + k]
        angle7, angle8, angle9 = turns[6 * w + k], turns[7 * w + k], turns[8 * w + k]
        angle10, angle11, angle12 = turns[9 * w + k], turns[10 * w + k], turns[11 * w + k]
        angle13, angle14, angle15 = turns[12 * w + k], turns[13 * w + k], turns[14 * w + k]
        angle16, angle17, angle18 = turns[15 * w + k], turns[16 * w + k], turns[17 * w + k]

        # theta3, type 8: U1[3, 4] and U1[1, 4]
        q3_pmp = math.copysign(half_turn, -v4) - angle2

        # theta4, type 2: U4[2, 3]
        q4_ppm, q4_pmm, q4_mpm = angle7 - v41, angle8 - v41, angle9 - v42
        q4_mmm = angle10 - v42

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        q6_ppm = angle15 - math.copysign(half_turn, v48)
        q6_pmm = angle16 - math.copysign(half_turn, v50)
        q6_mpm = angle17 - math.copysign(half_turn, v51)
        q6_mmm = angle18 - math.copysign(half_turn, v52)

        # joint values
        q1_ppp, q1_mpp = angle1 + v3, v3 + (angle1 - math.copysign(half_turn, -T24))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, angle3, angle2
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle7, angle11, angle15
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, -angle11, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = angle4, q3_pmp, angle8
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = angle12, angle16, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = -angle12, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = angle5, angle9, angle13
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = angle17, q4_mpm, -angle13
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q6_mpm, angle6, angle10
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = angle14, angle18, q4_mmm
        rows[30 * w + k], rows[31 * w + k] = -angle14, q6_mmm
        rows[32 * w + k] = rows[33 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[34 * w + k] = rows[35 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[36 * w + k] = rows[37 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[38 * w + k] = rows[39 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 25, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 2, 19, 20, 21], [17, 18, 2, 22, 23, 24], [17, 25, 10, 26, 27, 28],
    [17, 25, 10, 29, 30, 31],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
