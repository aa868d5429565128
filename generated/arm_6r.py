# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 5414216a0af071f2
"""arm_6r: Arm with six revolute joints and a spherical wrist.

Inverse kinematics, generated from robots/arm_6r.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/arm_6r.yaml. The formulas and where they come from: arm_6r.md.

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

NAME = "arm_6r"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "back-down-noflip", "back-down-flip", "back-up-noflip", "back-up-flip", "front-up-noflip",
    "front-up-flip", "front-down-noflip", "front-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 0.000125 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.4  # joint offset 1 [m]
a2 = 0.4  # link length 2 [m]
d4 = 0.35  # joint offset 4 [m]
d6 = 0.1  # joint offset 6 [m]
free_limit1 = 1.25e-12  # a length that fixes no angle [m]
longest3 = 0.5625  # square of the longest reach [m^2]
shortest3 = 0.0025000000000000044  # square of the shortest reach [m^2]
longest3_reach = 0.5625000000001875  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.002499999999987505  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.5624999999999812  # the longest, where branches merge [m^2]
shortest3_apart = 0.0025000000000012543  # the shortest, where branches merge [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.27999999999999997  # 2 * d4 * a2 [m^2]
k2 = 0.28250000000000003  # a2^2 + d4^2 [m^2]
k3 = 12.755102040816327  # 1 / (k1^2) [m^-4]
m1 = 1.5625e-08  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 1.050715070505213e-11
m4 = 1.2499999999999998  # d4 * k1 * k3 [m^-1]
m5 = 0.04687500000000003  # a2 - d4 * k1 * k2 * k3 [m]
m6 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.8, 0.8, 0.8, 1.0, 1.0, 1.0), size=1.25, steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.4, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.4, 0.0),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.35, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.1, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
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
    x3_x, x3_y, v3 = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v4, v5, z3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, v6 = x3_x * c4 + s1 * s4, x3_y * c4 - c1 * s4, v3 * c4
    y5_x, z4_y, y5_z = s1 * c4 - x3_x * s4, c1 * c4 + x3_y * s4, v3 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 - v4 * s5, x4_y * c5 - v5 * s5, z3_z * s5 - v6 * c5
    v7, v8, z5_z = v4 * c5 + x4_x * s5, v5 * c5 + x4_y * s5, z3_z * c5 + v6 * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + y5_x * s6, y5_x * c6 - x5_x * s6, -v7
    T[0, 3] = x2_x * a2 - v4 * d4 - v7 * d6
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 - z4_y * s6, -(z4_y * c6 + x5_y * s6), -v8
    T[1, 3] = x2_y * a2 - v5 * d4 - v8 * d6
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 + y5_z * s6, y5_z * c6 - x5_z * s6, z5_z
    T[2, 3] = d1 - s2 * a2 + z3_z * d4 + z5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2, p2_x, p2_y = s1 * s2, x2_x * a2, x2_y * a2
    p2_z = d1 - s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v3 = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v4, v5, z3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    z4_y, y5_z, p4_x = c1 * c4 + x3_y * s4, v3 * s4, p2_x - v4 * d4
    p4_y, p4_z, z4_x = p2_y - v5 * d4, p2_z + z3_z * d4, x3_x * s4 - s1 * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    v6, v7 = v4 * c5 + (x3_x * c4 + s1 * s4) * s5, v5 * c5 + (x3_y * c4 - c1 * s4) * s5
    z5_z, p6_x, p6_y = z3_z * c5 + v3 * c4 * s5, p4_x - v6 * d6, p4_y - v7 * d6
    p6_z = p4_z + z5_z * d6
    v8, v9, v10 = p6_z - d1, p6_x - p2_x, p6_y - p2_y
    v11, v12, v13 = p6_z - p2_z, p6_x - p4_x, p6_y - p4_y
    v14 = p6_z - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, c1 * v8, c1 * v11
    J[0, 3], J[0, 4] = -(v5 * v11 + z3_z * v10), z4_y * v14 + y5_z * v13
    J[0, 5] = -(v7 * v14 + z5_z * v13)
    J[1, 0], J[1, 1], J[1, 2] = p6_x, s1 * v8, s1 * v11
    J[1, 3], J[1, 4] = z3_z * v9 + v4 * v11, -(y5_z * v12 + z4_x * v14)
    J[1, 5] = z5_z * v12 + v6 * v14
    J[2, 1], J[2, 2], J[2, 3] = -(s1 * p6_y + c1 * p6_x), -(s1 * v10 + c1 * v9), v5 * v9 - v4 * v10
    J[2, 4], J[2, 5] = z4_x * v13 - z4_y * v12, v7 * v12 - v6 * v13
    J[3, 1], J[3, 2], J[3, 3] = -s1, -s1, -v4
    J[3, 4], J[3, 5] = z4_x, -v6
    J[4, 1], J[4, 2], J[4, 3] = c1, c1, -v5
    J[4, 4], J[4, 5] = z4_y, -v7
    J[5, 0], J[5, 3], J[5, 4] = 1.0, z3_z, -y5_z
    J[5, 5] = z5_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1 A6^-1 [3, 4]
    wx = T14 - T13 * d6
    Y1 = d6 * T23 - T24
    w1 = math.sqrt(wx * wx + Y1 * Y1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = T34 - d6 * T33
    Z1_3 = wz - d1
    v1 = Z1_3 * Z1_3

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(wx * factor1)
        s1 = math.sin(seed[0]) if free1 else Y1 * factor1
        q1 = _atan2(s1, c1)
        D1 = w1 * e1

        # theta3
        N3 = v1 + D1 * D1
        K3 = N3 - k2
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        v2 = k1 * K3 * k3

        # theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4]
        Y1_2 = a2 + d4 * v2
        v4, v5 = Z1_3 * Y1_2, D1 * Y1_2

        # theta4, type 2: U4[3, 3]
        v7 = T13 * c1 + T23 * s1
        Y4 = T13 * s1 - T23 * c1
        v8 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v9, v10, v12 = T22 * c1 - T12 * s1, T12 * c1 + T22 * s1, T21 * c1 - T11 * s1
        v13 = T11 * c1 + T21 * s1

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            c3 = k3 * (k1 * (w3 * e3))
            q3 = _atan2(-v2, c3)

            # theta2
            v3 = d4 * c3
            S2 = D1 * v3 - v4
            v6 = Z1_3 * v3 + v5
            w2 = math.sqrt(S2 * S2 + v6 * v6)
            factor2 = 1.0 / w2
            c2, s2 = -(v6 * factor2), S2 * factor2
            q2 = _atan2(s2, c2)

            # theta4
            c23, s23 = c3 * c2 + v2 * s2, c3 * s2 - v2 * c2
            X4 = T33 * s23 - c23 * v7
            w4 = math.sqrt(X4 * X4 + v8)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta6
            v11, v14 = c23 * v10 - T32 * s23, c23 * v13 - T31 * s23

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)

                # theta5, type 3: U4[2, 3] and U4[1, 3]
                q5 = _atan2(-(w4 * e4), -(T33 * c23 + s23 * v7))

                # theta6
                q6 = _atan2(-(c4 * v12 + s4 * v14), -(c4 * v9 + s4 * v11))
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
                q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
                status[row] = FREE_JOINT if free1 or free4 else OK


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

        # theta1, type 2: U1 A6^-1 [3, 4]
        wx, Y1 = T14 - d6 * T13, d6 * T23 - T24
        v1 = wx * wx + Y1 * Y1
        w1, v2 = math.sqrt(v1), 1.0 / v1

        # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        Z1_3 = T34 - d6 * T33 - d1
        N3 = v1 + Z1_3 * Z1_3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)
        v3, v4 = w3 - w3, k1 * (N3 - k2)
        v5, v6 = k3 * v4, k1 * w3
        c3 = k3 * v6

        # theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4]
        v7, Y1_2 = d4 * c3, a2 + d4 * v5
        v8, v9 = Z1_3 * Y1_2, w1 * v7
        v10, v11, v12 = v9 - v8, v8 + v9, m5 + m4 * N3
        v13, v14 = Z1_3 * v12, w3 * (m4 * w1)
        S2_pp, v15, v16 = v14 - v13, v13 + v14, w1 * Y1_2
        v17 = Z1_3 * v7
        v18, v19, v20 = v16 + v17, v16 - v17, w3 * (m4 * Z1_3)
        v21, v22 = w3 * (m4 * -Z1_3), w1 * v12
        v23, v24, v25 = v20 + v22, v21 + v22, v20 - v22
        v26, v27 = v21 - v22, S2_pp * S2_pp
        v28, v29 = v27 + v23 * v23, v15 * v15
        v30, v31, v32 = v29 + v24 * v24, v29 + v25 * v25, v27 + v26 * v26
        w2_pp, w2_pm, w2_mp = math.sqrt(v28), math.sqrt(v30), math.sqrt(v31)
        w2_mm, v33, v34 = math.sqrt(v32), 1.0 / v28, 1.0 / v30
        v35, v36 = 1.0 / v31, 1.0 / v32

        # theta4, type 2: U4[3, 3]
        v37 = v5 * v10 - c3 * v18
        c23_pp, v38 = w2_pp * (v33 * v37), v5 * v11
        c23_pm, v39 = w2_pm * (v34 * (c3 * v19 - v38)), w2_mp * (v35 * (v38 + c3 * -v19))
        c23_mm, v40 = w2_mm * (v36 * v37), c3 * v10 + v5 * v18
        s23_pp, v41 = w2_pp * (v33 * v40), c3 * v11
        s23_pm, s23_mp = w2_pm * (v34 * (v41 + v5 * v19)), w2_mp * (v35 * (v5 * -v19 - v41))
        v42, v43 = w2_mm * (v36 * v40), w1 * (v2 * (T23 * Y1 - T13 * wx))
        X4_pp, X4_pm = T33 * s23_pp - c23_pp * v43, T33 * s23_pm - c23_pm * v43
        X4_mp, X4_mm = T33 * s23_mp - v39 * v43, c23_mm * v43 - T33 * v42
        Y4 = w1 * (v2 * (T13 * Y1 + wx * T23))
        v44 = Y4 * Y4
        v45, v46, v47 = v44 + X4_pp * X4_pp, v44 + X4_pm * X4_pm, v44 + X4_mp * X4_mp
        v48, v49 = v44 + X4_mm * X4_mm, math.copysign(half_turn, Y4)
        v50 = math.copysign(half_turn, -Y4)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v51, v52 = w1 * (v2 * (wx * T22 + Y1 * T12)), w1 * (v2 * (Y1 * T22 - wx * T12))
        v53, v54 = w1 * (v2 * (wx * T21 + Y1 * T11)), w1 * (v2 * (Y1 * T21 - wx * T11))
        v55 = -X4_pp * v53 - Y4 * (c23_pp * v54 - s23_pp * T31)
        v56 = -X4_pm * v53 - Y4 * (c23_pm * v54 - s23_pm * T31)
        v57 = Y4 * (v39 * v54 - s23_mp * T31) - -X4_mp * v53
        v58 = Y4 * (v42 * T31 - c23_mm * v54) - -X4_mm * v53

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if abs(D3_squared) <= m3 or v1 <= m1 or v48 <= m6 or v47 <= m6 or v45 <= m6 or v46
            <= m6 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = Y1, v3, v4
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v49, v50, v55
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = v56, v57, v58
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = Y1, -v4, S2_pp
        turns[3 * w + k], turns[4 * w + k], turns[5 * w + k] = -v15, -v15, S2_pp
        turns[6 * w + k], turns[7 * w + k], turns[8 * w + k] = Y4, Y4, -Y4
        turns[9 * w + k], turns[10 * w + k] = -Y4, -math.sqrt(v45)
        turns[11 * w + k], turns[12 * w + k] = -math.sqrt(v46), -math.sqrt(v47)
        turns[13 * w + k], turns[14 * w + k], turns[15 * w + k] = -math.sqrt(v48), v55, v56
        turns[16 * w + k], turns[17 * w + k], turns[24 * w + k] = v57, v58, -wx
        turns[25 * w + k], turns[26 * w + k], turns[27 * w + k] = v6, -v23, -v24
        turns[28 * w + k], turns[29 * w + k], turns[30 * w + k] = -v25, -v26, -X4_pp
        turns[31 * w + k], turns[32 * w + k], turns[33 * w + k] = -X4_pm, -X4_mp, -X4_mm
        turns[34 * w + k] = -(T33 * c23_pp + s23_pp * v43)
        turns[35 * w + k] = -(T33 * c23_pm + s23_pm * v43)
        turns[36 * w + k], turns[37 * w + k] = T33 * v39 + s23_mp * v43, -(T33 * c23_mm + v42 * v43)
        turns[38 * w + k] = -X4_pp * v51 - Y4 * (c23_pp * v52 - s23_pp * T32)
        turns[39 * w + k] = -X4_pm * v51 - Y4 * (c23_pm * v52 - s23_pm * T32)
        turns[40 * w + k] = Y4 * (v39 * v52 - s23_mp * T32) - -X4_mp * v51
        turns[41 * w + k] = Y4 * (v42 * T32 - c23_mm * v52) - -X4_mm * v51
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 18 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(18 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        Y1, v3, v4 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v49, v50, v55 = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v56, v57, v58 = kept[23 * w + k], kept[24 * w + k], kept[25 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5, angle6 = turns[3 * w + k], turns[4 * w + k], turns[5 * w + k]
        angle7, angle8, angle9 = turns[6 * w + k], turns[7 * w + k], turns[8 * w + k]
        angle10, angle11, angle12 = turns[9 * w + k], turns[10 * w + k], turns[11 * w + k]
        angle13, angle14, angle15 = turns[12 * w + k], turns[13 * w + k], turns[14 * w + k]
        angle16, angle17, angle18 = turns[15 * w + k], turns[16 * w + k], turns[17 * w + k]

        # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        q3_pmp = math.copysign(half_turn, -v4) - angle2

        # theta4, type 2: U4[3, 3]
        q4_ppm, q4_pmm, q4_mpm = angle7 - v49, angle8 - v49, angle9 - v50
        q4_mmm = angle10 - v50

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle15 - math.copysign(half_turn, v55)
        q6_pmm = angle16 - math.copysign(half_turn, v56)
        q6_mpm = angle17 - math.copysign(half_turn, v57)
        q6_mmm = angle18 - math.copysign(half_turn, v58)

        # joint values
        q1_ppp, q1_mpp = angle1 + v3, v3 + (angle1 - math.copysign(half_turn, Y1))

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
_FORMULAS = _functions.Formulas(_formulas, 26, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 2, 19, 20, 21], [17, 18, 2, 22, 23, 24], [17, 25, 10, 26, 27, 28],
    [17, 25, 10, 29, 30, 31],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
