# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 3e814aec3a2fdecb
"""kuka_kr210: KUKA KR 210.

Inverse kinematics, generated from robots/kuka_kr210.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kuka_kr210.yaml. The formulas and where they come from: kuka_kr210.md.

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
_wrap = _runtime("angles").wrap
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 6), _runtime("arrays").zeros

NAME = "kuka_kr210"
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

# In formulas below, doubt_limit1 = 0.00042070000000000003 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.75  # joint offset 1 [m]
a1 = 0.35  # link length 2 [m]
a2 = 1.25  # link length 3 [m]
d4 = 1.5  # joint offset 4 [m]
a3 = 0.054  # link length 4 [m]
d7 = 0.303  # z of the tool frame [m]
free_limit1 = 4.207e-12  # a length that fixes no angle [m]
longest3 = 7.567845213189771  # square of the longest reach [m^2]
shortest3 = 0.06298678681022957  # square of the shortest reach [m^2]
longest3_reach = 7.567845213192085  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.06298678681001839  # the shortest, with what rounding adds [m^2]
longest3_apart = 7.567845213189539  # the longest, where branches merge [m^2]
shortest3_apart = 0.06298678681025069  # the shortest, where branches merge [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
k1 = 3.75  # 2 * d4 * a2 [m^2]
k2 = 0.135  # 2 * a3 * a2 [m^2]
k3 = 3.815416  # a2^2 + (d4^2 + a3^2) [m^2]
k4 = 0.07101907039587806  # 1 / (k1^2 + k2^2) [m^-4]
m1 = 1.7698849000000003e-07  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 1.739735510573048e-09
m4 = 0.009587574503443538  # k2 * k4 [m^-2]
m5 = 1.016127365600848  # k1 * k3 * k4
m6 = 0.26632151398454273  # k1 * k4 [m^-2]
m7 = 0.03658058516163053  # k2 * k3 * k4
m8 = 0.4  # k4 * (d4 * k1 + a3 * k2) [m^-1]
m9 = 0.27616640000000003  # d4 * k1 * k3 * k4 + a3 * k2 * k3 * k4 - a2 [m]
m10 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.2377, 0.2377, 0.2377, 1.0, 1.0, 1.0), size=4.207, steps=("follows seed",),
))

# The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.75, 0.0, 0.0),
    (-1.5707963267948966, 0.0, 0.35, -1.5707963267948966),
    (0.0, 0.0, 1.25, 0.0),
    (0.0, 1.5, -0.054, -1.5707963267948966),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, -1.5707963267948966),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="modified",
    tool=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.303),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, v2 = c1 * c2, s1 * c2, c1 * s2
    v3 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v4 = x2_x * c3 - v2 * s3, x2_y * c3 - v3 * s3, s2 * c3 + c2 * s3
    v5, v6, y3_z = v2 * c3 + x2_x * s3, v3 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, v7 = x3_x * c4 + s1 * s4, x3_y * c4 - c1 * s4, v4 * c4
    y4_x, z5_y, y4_z = s1 * c4 - x3_x * s4, c1 * c4 + x3_y * s4, v4 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 - v5 * s5, x4_y * c5 - v6 * s5, y3_z * s5 - v7 * c5
    v8, v9, y5_z = v5 * c5 + x4_x * s5, v6 * c5 + x4_y * s5, y3_z * c5 + v7 * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + y4_x * s6, y4_x * c6 - x5_x * s6, -v8
    T[0, 3] = c1 * a1 + x2_x * a2 - x3_x * a3 - v5 * d4 - v8 * d7
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 - z5_y * s6, -(z5_y * c6 + x5_y * s6), -v9
    T[1, 3] = s1 * a1 + x2_y * a2 - x3_y * a3 - v6 * d4 - v9 * d7
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 + y4_z * s6, y4_z * c6 - x5_z * s6, y5_z
    T[2, 3] = d1 - s2 * a2 + v4 * a3 + y3_z * d4 + y5_z * d7
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p2_x, p2_y, v1 = c1 * a1, s1 * a1, q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, v2 = c1 * c2, s1 * c2, c1 * s2
    v3, p3_x, p3_y = s1 * s2, p2_x + x2_x * a2, p2_y + x2_y * a2
    p3_z = d1 - s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v4 = x2_x * c3 - v2 * s3, x2_y * c3 - v3 * s3, s2 * c3 + c2 * s3
    v5, v6, y3_z = v2 * c3 + x2_x * s3, v3 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    p4_x, p4_y = p3_x - x3_x * a3 - v5 * d4, p3_y - x3_y * a3 - v6 * d4
    p4_z = p3_z + v4 * a3 + y3_z * d4
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    z5_y, y4_z, z5_x = c1 * c4 + x3_y * s4, v4 * s4, x3_x * s4 - s1 * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    v7, v8 = v5 * c5 + (x3_x * c4 + s1 * s4) * s5, v6 * c5 + (x3_y * c4 - c1 * s4) * s5
    y5_z, J21, v9 = y3_z * c5 + v4 * c4 * s5, p4_x - v7 * d7, p4_y - v8 * d7
    v10 = p4_z + y5_z * d7
    v11, v12, v13 = v10 - d1, v10 - p3_z, J21 - p4_x
    v14, v15 = v9 - p4_y, v10 - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -v9, c1 * v11, c1 * v12
    J[0, 3], J[0, 4] = -(v6 * v15 + y3_z * v14), z5_y * v15 + y4_z * v14
    J[0, 5] = -(v8 * v15 + y5_z * v14)
    J[1, 0], J[1, 1], J[1, 2] = J21, s1 * v11, s1 * v12
    J[1, 3], J[1, 4] = y3_z * v13 + v5 * v15, -(y4_z * v13 + z5_x * v15)
    J[1, 5] = y5_z * v13 + v7 * v15
    J[2, 1] = -(s1 * (v9 - p2_y) + c1 * (J21 - p2_x))
    J[2, 2], J[2, 3] = -(s1 * (v9 - p3_y) + c1 * (J21 - p3_x)), v6 * v13 - v5 * v14
    J[2, 4], J[2, 5] = z5_x * v14 - z5_y * v13, v8 * v13 - v7 * v14
    J[3, 1], J[3, 2], J[3, 3] = -s1, -s1, -v5
    J[3, 4], J[3, 5] = z5_x, -v7
    J[4, 1], J[4, 2], J[4, 3] = c1, c1, -v6
    J[4, 4], J[4, 5] = z5_y, -v8
    J[5, 0], J[5, 3], J[5, 4] = 1.0, y3_z, -y4_z
    J[5, 5] = y5_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[2, 4]
    t14 = T14 - d7 * T13
    Y1 = d7 * T23 - T24
    w1 = math.sqrt(t14 * t14 + Y1 * Y1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 6: U1[3, 4] and U1[1, 4]
    t34 = T34 - d7 * T33
    Z1_3 = t34 - d1
    v2 = Z1_3 * Z1_3

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(t14 * factor1)
        s1 = math.sin(seed[0]) if free1 else Y1 * factor1
        q1 = _atan2(s1, c1)

        # theta3
        v1 = w1 * e1 + a1
        N3 = v2 + v1 * v1
        K3 = N3 - k3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        v3, v5 = k1 * K3, k2 * K3

        # theta4, type 2: U4[2, 3]
        v7 = T13 * c1 + T23 * s1
        Y4 = T23 * c1 - T13 * s1
        v8 = Y4 * Y4

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        v9, v10, v12 = T22 * c1 - T12 * s1, T12 * c1 + T22 * s1, T21 * c1 - T11 * s1
        v13 = T11 * c1 + T21 * s1

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            D3 = w3 * e3
            v4 = (v3 + k2 * D3) * k4
            c3 = k4 * (k1 * D3 - v5)
            q3 = _atan2(-v4, c3)

            # theta2, type 3: U1[1, 4] and U1[3, 4]
            v6 = d4 * c3 + a3 * v4
            X2_2 = a3 * c3 - d4 * v4 - a2
            S2 = v1 * v6 - Z1_3 * -X2_2
            C2 = v1 * X2_2 - Z1_3 * v6
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            factor2 = 1.0 / w2
            c2, s2 = C2 * factor2, S2 * factor2

            # theta4
            c23, s23 = c3 * c2 + v4 * s2, c3 * s2 - v4 * c2
            X4 = c23 * v7 - T33 * s23
            w4 = math.sqrt(X4 * X4 + v8)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta6
            v11, v14 = c23 * v10 - T32 * s23, c23 * v13 - T31 * s23

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)

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

                # theta5, type 3: U4[3, 3] and U4[1, 3]
                q5 = _atan2(s5, -(T33 * c23 + s23 * v7))

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

        # theta1, type 2: U1[2, 4]
        t14, Y1 = T14 - d7 * T13, d7 * T23 - T24
        v1 = t14 * t14 + Y1 * Y1
        w1, v2 = math.sqrt(v1), 1.0 / v1

        # theta3, type 6: U1[3, 4] and U1[1, 4]
        Z1_3, v3, v4 = T34 - d7 * T33 - d1, a1 + w1, a1 - w1
        v5 = Z1_3 * Z1_3
        N3_p, N3_m = v5 + v3 * v3, v5 + v4 * v4
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3)
        D3_squared_m, w3_p = (longest3 - N3_m) * (N3_m - shortest3), math.sqrt(D3_squared_p)
        w3_m, v6, v7 = math.sqrt(D3_squared_m), m6 * N3_p - m5, m6 * N3_m - m5
        v8 = m4 * w3_p
        v9, v10, v11 = v6 + v8, v6 - v8, m4 * w3_m
        v12, v13, v14 = v7 + v11, v7 - v11, m7 - m4 * N3_p
        v15, v16 = m7 - m4 * N3_m, m6 * w3_p
        c3_pp, c3_pm, v17 = v14 + v16, v14 - v16, m6 * w3_m
        c3_mp, c3_mm = v15 + v17, v15 - v17

        # theta2, type 3: U1[1, 4] and U1[3, 4]
        X2_2_p, X2_2_m = m9 - m8 * N3_p, m9 - m8 * N3_m
        v18, v19, v20 = Z1_3 * X2_2_p, Z1_3 * X2_2_m, w3_p * (m8 * v3)
        S2_pp, S2_pm, S2_mp = v18 + v20, v18 - v20, v19 + w3_m * (m8 * v4)
        S2_mm, v21, v22 = v19 + w3_m * (m8 * -v4), v3 * X2_2_p, v4 * X2_2_m
        v23, v24 = m8 * Z1_3, m8 * -Z1_3
        C2_pp, C2_pm, C2_mp = v21 - w3_p * v23, v21 - w3_p * v24, v22 - w3_m * v23
        C2_mm, factor2_p, factor2_m = v22 - w3_m * v24, 1.0 / N3_p, 1.0 / N3_m

        # theta4, type 2: U4[2, 3]
        c23_pp, c23_pm = c3_pp * C2_pp + v9 * S2_pp, c3_pm * C2_pm + v10 * S2_pm
        c23_mp, c23_mm = c3_mp * C2_mp + v12 * S2_mp, c3_mm * C2_mm + v13 * S2_mm
        s23_pp, s23_pm = c3_pp * S2_pp - v9 * C2_pp, c3_pm * S2_pm - v10 * C2_pm
        s23_mp, s23_mm = c3_mp * S2_mp - v12 * C2_mp, c3_mm * S2_mm - v13 * C2_mm
        v25 = w1 * (v2 * (T23 * Y1 - T13 * t14))
        X4_pp, X4_pm = c23_pp * v25 - T33 * s23_pp, c23_pm * v25 - T33 * s23_pm
        v26, v27 = c23_mp * v25 + T33 * s23_mp, c23_mm * v25 + T33 * s23_mm
        v28 = w1 * (v2 * (T13 * Y1 + t14 * T23))
        v29 = v28 * v28
        v30 = v29 + factor2_p * (X4_pp * (factor2_p * X4_pp))
        v31, v32 = v29 + factor2_p * (X4_pm * (factor2_p * X4_pm)), factor2_m * v26
        v33, v34 = v29 + factor2_m * (v26 * v32), factor2_m * v27
        v35, v36 = v29 + factor2_m * (v27 * v34), math.copysign(half_turn, -v28)
        v37 = math.copysign(half_turn, v28)

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        v38, v39 = w1 * (v2 * (t14 * T22 + Y1 * T12)), w1 * (v2 * (Y1 * T22 - t14 * T12))
        v40, v41 = w1 * (v2 * (t14 * T21 + Y1 * T11)), w1 * (v2 * (Y1 * T21 - t14 * T11))
        v42 = -X4_pp * v40 + v28 * (c23_pp * v41 - s23_pp * T31)
        v43 = -X4_pm * v40 + v28 * (c23_pm * v41 - s23_pm * T31)
        v44 = v28 * (c23_mp * v41 + s23_mp * T31) - v26 * v40
        v45 = v28 * (c23_mm * v41 + s23_mm * T31) - v27 * v40

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v35 <= m10 or v33 <= m10 or v31 <= m10 or v30 <= m10 or abs(D3_squared_m) <= m3
            or v1 <= m1 or abs(D3_squared_p) <= m3 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = Y1, w3_p, w3_m
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v36, v37, v42
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = v43, v44, v45
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = Y1, -v9, -v10
        turns[3 * w + k], turns[4 * w + k], turns[5 * w + k] = -v12, -v13, -v28
        turns[6 * w + k], turns[7 * w + k], turns[8 * w + k] = -v28, v28, v28
        turns[9 * w + k], turns[10 * w + k] = math.sqrt(v30), math.sqrt(v31)
        turns[11 * w + k], turns[12 * w + k] = math.sqrt(v33), math.sqrt(v35)
        turns[13 * w + k], turns[14 * w + k], turns[15 * w + k] = v42, v43, v44
        turns[16 * w + k], turns[17 * w + k], turns[18 * w + k] = v45, S2_pp, S2_pm
        turns[19 * w + k], turns[20 * w + k], turns[24 * w + k] = S2_mp, S2_mm, -t14
        turns[25 * w + k], turns[26 * w + k], turns[27 * w + k] = c3_pp, c3_pm, c3_mp
        turns[28 * w + k], turns[29 * w + k] = c3_mm, factor2_p * -X4_pp
        turns[30 * w + k], turns[31 * w + k], turns[32 * w + k] = factor2_p * -X4_pm, v32, v34
        turns[33 * w + k] = -(factor2_p * (T33 * c23_pp + s23_pp * v25))
        turns[34 * w + k] = -(factor2_p * (T33 * c23_pm + s23_pm * v25))
        turns[35 * w + k] = -(factor2_m * (T33 * c23_mp - s23_mp * v25))
        turns[36 * w + k] = -(factor2_m * (T33 * c23_mm - s23_mm * v25))
        turns[37 * w + k] = -X4_pp * v38 + v28 * (c23_pp * v39 - s23_pp * T32)
        turns[38 * w + k] = -X4_pm * v38 + v28 * (c23_pm * v39 - s23_pm * T32)
        turns[39 * w + k] = v28 * (c23_mp * v39 + s23_mp * T32) - v26 * v38
        turns[40 * w + k] = v28 * (c23_mm * v39 + s23_mm * T32) - v27 * v38
        turns[41 * w + k], turns[42 * w + k], turns[43 * w + k] = C2_pp, C2_pm, C2_mp
        turns[44 * w + k] = C2_mm
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 21 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(21 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        Y1, w3_p, w3_m = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v36, v37, v42 = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v43, v44, v45 = kept[23 * w + k], kept[24 * w + k], kept[25 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5, angle6 = turns[3 * w + k], turns[4 * w + k], turns[5 * w + k]
        angle7, angle8, angle9 = turns[6 * w + k], turns[7 * w + k], turns[8 * w + k]
        angle10, angle11, angle12 = turns[9 * w + k], turns[10 * w + k], turns[11 * w + k]
        angle13, angle14, angle15 = turns[12 * w + k], turns[13 * w + k], turns[14 * w + k]
        angle16, angle17, angle18 = turns[15 * w + k], turns[16 * w + k], turns[17 * w + k]
        angle19, angle20, angle21 = turns[18 * w + k], turns[19 * w + k], turns[20 * w + k]

        # theta4, type 2: U4[2, 3]
        q4_ppm, q4_pmm, q4_mpm = angle6 - v36, angle7 - v36, angle8 - v37
        q4_mmm = angle9 - v37

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        q6_ppm = angle14 - math.copysign(half_turn, v42)
        q6_pmm = angle15 - math.copysign(half_turn, v43)
        q6_mpm = angle16 - math.copysign(half_turn, v44)
        q6_mmm = angle17 - math.copysign(half_turn, v45)

        # joint values
        v46, v47, v48 = angle18 - offset2, angle19 - offset2, angle20 - offset2
        v49 = angle21 - offset2
        q2_ppp = v46 + (-turn if half_turn < v46 else 0.0)
        q2_pmp = v47 + (-turn if half_turn < v47 else 0.0)
        q2_mpp = v48 + (-turn if half_turn < v48 else 0.0)
        q2_mmp = v49 + (-turn if half_turn < v49 else 0.0)
        q1_ppp = angle1 + (w3_p - w3_p)
        q1_mpp = angle1 - math.copysign(half_turn, Y1) + (w3_m - w3_m)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, q2_ppp, angle2
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle6, angle10, angle14
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, -angle10, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q2_pmp, angle3, angle7
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = angle11, angle15, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = -angle11, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q2_mpp, angle4, angle8
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = angle12, angle16, q4_mpm
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = -angle12, q6_mpm, q2_mmp
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = angle5, angle9, angle13
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = angle17, q4_mmm, -angle13
        rows[33 * w + k] = q6_mmm
        rows[34 * w + k] = rows[35 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[36 * w + k] = rows[37 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[38 * w + k] = rows[39 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[40 * w + k] = rows[41 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 26, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 19, 20, 21, 22], [17, 18, 19, 23, 24, 25], [17, 26, 27, 28, 29, 30],
    [17, 26, 27, 31, 32, 33],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
