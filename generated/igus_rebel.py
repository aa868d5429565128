# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: fbfb60e591c62a5d
"""igus_rebel: igus ReBeL.

Inverse kinematics, generated from robots/igus_rebel.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/igus_rebel.yaml. The formulas and where they come from: igus_rebel.md.

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

NAME = "igus_rebel"
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

# In formulas below, doubt_limit1 = 8.972e-05 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.1  # joint offset 1 [m]
a1 = 0.149  # link length 1 [m]
a2 = 0.2384  # link length 2 [m]
a3 = 0.119  # link length 3 [m]
d4 = 0.17  # joint offset 4 [m]
d6 = 0.1208  # joint offset 6 [m]
free_limit1 = 8.972000000000001e-13  # a length that fixes no angle [m]
longest3 = 0.19883701719889113  # square of the longest reach [m^2]
shortest3 = 0.0009541028011088964  # square of the shortest reach [m^2]
longest3_reach = 0.19883701719897112  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0009541028011033538  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.1988370171988831  # the longest, where branches merge [m^2]
shortest3_apart = 0.0009541028011094507  # the shortest, where branches merge [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset3 = -1.5707963267948966  # offset of joint 3 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
k1 = 0.081056  # 2 * d4 * a2 [m^2]
k2 = 0.0567392  # 2 * a3 * a2 [m^2]
k3 = 0.09989556000000001  # a2^2 + (a3^2 + d4^2) [m^2]
k4 = 102.1511817908859  # 1 / (k1^2 + k2^2) [m^-4]
turn1 = 0.960070362405688  # atan2(k1, k2) [rad]
m1 = 8.049678400000001e-09  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 1.5872903619528408e-12
m4 = 2.097315436241611  # k4 * (d4 * k1 + a3 * k2) [m^-1]
m5 = 0.028887499999999986  # a2 - d4 * k1 * k3 * k4 - a3 * k2 * k3 * k4 [m]
m6 = 1.3817607579944728  # a2 * k2 * k4 [m^-1]
m7 = 1.9739439399921042  # a2 * k1 * k4 [m^-1]
# k1 * k4 * (a2 * k3 + d4 * longest3 * shortest3 * k1 * k4 + a3 * longest3 * shortest3 * k2 * k4 -
# d4 * k1 * k3^2 * k4 - a3 * k2 * k3^2 * k4) [m]
m8 = 0.027188235294117635
# k2 * k4 * (a2 * k3 + d4 * longest3 * shortest3 * k1 * k4 + a3 * longest3 * shortest3 * k2 * k4 -
# d4 * k1 * k3^2 * k4 - a3 * k2 * k3^2 * k4) [m]
m9 = 0.019031764705882342
m10 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(1.115, 1.115, 1.115, 1.0, 1.0, 1.0), size=0.8972000000000001,
    steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.1, 0.149, -1.5707963267948966),
    (-1.5707963267948966, 0.0, 0.2384, 0.0),
    (-1.5707963267948966, 0.0, 0.119, -1.5707963267948966),
    (0.0, 0.17, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.1208, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, v2 = c1 * c2, s1 * c2, c1 * s2
    v3, v4 = s1 * s2, q[2] + offset3
    c3, s3 = math.cos(v4), math.sin(v4)
    x3_x, x3_y, v5 = x2_x * c3 - v2 * s3, x2_y * c3 - v3 * s3, s2 * c3 + c2 * s3
    v6, v7, z3_z = v2 * c3 + x2_x * s3, v3 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, v8 = x3_x * c4 + s1 * s4, x3_y * c4 - c1 * s4, v5 * c4
    z4_y, v9, z4_x = c1 * c4 + x3_y * s4, v5 * s4, x3_x * s4 - s1 * c4
    v10 = q[4] + offset5
    c5, s5 = math.cos(v10), math.sin(v10)
    x5_x, x5_y, x5_z = x4_x * c5 - v6 * s5, x4_y * c5 - v7 * s5, z3_z * s5 - v8 * c5
    z5_x, z5_y, v11 = v6 * c5 + x4_x * s5, v7 * c5 + x4_y * s5, z3_z * c5 + v8 * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + z4_x * s6, z4_x * c6 - x5_x * s6, z5_x
    T[0, 3] = c1 * a1 + x2_x * a2 + x3_x * a3 - v6 * d4 + z5_x * d6
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + z4_y * s6, z4_y * c6 - x5_y * s6, z5_y
    T[1, 3] = s1 * a1 + x2_y * a2 + x3_y * a3 - v7 * d4 + z5_y * d6
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 - v9 * s6, -(v9 * c6 + x5_z * s6), -v11
    T[2, 3] = d1 - s2 * a2 - v5 * a3 + z3_z * d4 - v11 * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y, v1 = c1 * a1, s1 * a1, q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, v2 = c1 * c2, s1 * c2, c1 * s2
    v3, p2_x, p2_y = s1 * s2, p1_x + x2_x * a2, p1_y + x2_y * a2
    p2_z, v4 = d1 - s2 * a2, q[2] + offset3
    c3, s3 = math.cos(v4), math.sin(v4)
    x3_x, x3_y, v5 = x2_x * c3 - v2 * s3, x2_y * c3 - v3 * s3, s2 * c3 + c2 * s3
    v6, v7, z3_z = v2 * c3 + x2_x * s3, v3 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    p3_x, p3_y, p3_z = p2_x + x3_x * a3, p2_y + x3_y * a3, p2_z - v5 * a3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    z4_y, v8, p4_x = c1 * c4 + x3_y * s4, v5 * s4, p3_x - v6 * d4
    p4_y, p4_z, z4_x = p3_y - v7 * d4, p3_z + z3_z * d4, x3_x * s4 - s1 * c4
    v9 = q[4] + offset5
    c5, s5 = math.cos(v9), math.sin(v9)
    z5_x, z5_y = v6 * c5 + (x3_x * c4 + s1 * s4) * s5, v7 * c5 + (x3_y * c4 - c1 * s4) * s5
    v10, p6_x, p6_y = z3_z * c5 + v5 * c4 * s5, p4_x + z5_x * d6, p4_y + z5_y * d6
    p6_z = p4_z - v10 * d6
    v11, v12, v13 = p6_z - d1, p6_z - p2_z, p6_x - p3_x
    v14, v15, v16 = p6_y - p3_y, p6_z - p3_z, p6_x - p4_x
    v17, v18 = p6_y - p4_y, p6_z - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, c1 * v11, c1 * v12
    J[0, 3], J[0, 4] = -(v7 * v15 + z3_z * v14), z4_y * v18 + v8 * v17
    J[0, 5] = z5_y * v18 + v10 * v17
    J[1, 0], J[1, 1], J[1, 2] = p6_x, s1 * v11, s1 * v12
    J[1, 3], J[1, 4] = z3_z * v13 + v6 * v15, -(v8 * v16 + z4_x * v18)
    J[1, 5] = -(v10 * v16 + z5_x * v18)
    J[2, 1] = -(s1 * (p6_y - p1_y) + c1 * (p6_x - p1_x))
    J[2, 2], J[2, 3] = -(s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x)), v7 * v13 - v6 * v14
    J[2, 4], J[2, 5] = z4_x * v17 - z4_y * v16, z5_x * v17 - z5_y * v16
    J[3, 1], J[3, 2], J[3, 3] = -s1, -s1, -v6
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = c1, c1, -v7
    J[4, 4], J[4, 5] = z4_y, z5_y
    J[5, 0], J[5, 3], J[5, 4] = 1.0, z3_z, -v8
    J[5, 5] = -v10
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

    # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = T34 - d6 * T33
    Z1_3 = wz - d1
    v2 = Z1_3 * Z1_3

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(wx * factor1)
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
        v3, v4 = k1 * K3, k2 * K3

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
            D3 = w3 * e3
            s3, c3 = (k2 * D3 - v3) * k4, k4 * (v4 + k1 * D3)

            # theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4]
            v5 = d4 * c3 + a3 * s3
            Y1_2 = a2 + (a3 * c3 - d4 * s3)
            S2 = v1 * v5 - Z1_3 * Y1_2
            v6 = Z1_3 * v5 + v1 * Y1_2
            w2 = math.sqrt(S2 * S2 + v6 * v6)
            factor2 = 1.0 / w2
            c2, s2 = -(v6 * factor2), S2 * factor2

            # theta4
            c23, s23 = c3 * c2 - s3 * s2, c3 * s2 + s3 * c2
            X4 = T33 * s23 - c23 * v7
            w4 = math.sqrt(X4 * X4 + v8)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T33 * c23 + s23 * v7

            # theta6
            v11, v14 = c23 * v10 - T32 * s23, c23 * v13 - T31 * s23

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(s3, c3) - offset3)

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

                # theta6
                c6, s6 = c4 * v9 + s4 * v11, c4 * v12 + s4 * v14
                q6 = _atan2(s6, c6)

                # joint values
                q5 = _wrap(_atan2(s5, c5) - offset5)
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

        # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        Z1_3, v3, v4 = T34 - d6 * T33 - d1, a1 + w1, a1 - w1
        v5 = Z1_3 * Z1_3
        N3_p, N3_m = v5 + v3 * v3, v5 + v4 * v4
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3)
        D3_squared_m, w3_p = (longest3 - N3_m) * (N3_m - shortest3), math.sqrt(D3_squared_p)
        w3_m = math.sqrt(D3_squared_m)

        # theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4]
        Y1_2_p, Y1_2_m = m5 + m4 * N3_p, m5 + m4 * N3_m
        v6, v7, v8 = Z1_3 * Y1_2_p, Z1_3 * Y1_2_m, v3 * Y1_2_p
        v9, v10, v11 = v4 * Y1_2_m, m4 * Z1_3, m4 * -Z1_3
        factor2_p, factor2_m = 1.0 / N3_p, 1.0 / N3_m

        # theta4, type 2: U4[3, 3]
        v12 = m6 * Z1_3
        v13, v14, v15 = v12 - m7 * v3, v12 - m7 * v4, m8 * factor2_p - m7
        v16, v17, v18 = m8 * factor2_m - m7, m9 * factor2_p - m6, m9 * factor2_m - m6
        v19, v20 = Z1_3 * v15 + v3 * v17, Z1_3 * v16 + v4 * v18
        c23_pp, c23_pm = v19 + w3_p * (factor2_p * v13), v19 + w3_p * (factor2_p * -v13)
        c23_mp, c23_mm = v20 + w3_m * (factor2_m * v14), v20 + w3_m * (factor2_m * -v14)
        v21, v22, v23 = m7 * Z1_3, Z1_3 * v17 + v3 * -v15, Z1_3 * v18 + v4 * -v16
        v24 = w3_p * (factor2_p * (v21 + m6 * v3))
        s23_pp, s23_pm, v25 = v22 - v24, v22 + v24, w3_m * (factor2_m * (v21 + m6 * v4))
        s23_mp, s23_mm, v26 = v23 - v25, v23 + v25, w1 * (v2 * (T23 * Y1 - T13 * wx))
        X4_pp, X4_pm = T33 * s23_pp - c23_pp * v26, T33 * s23_pm - c23_pm * v26
        X4_mp, X4_mm = T33 * s23_mp + c23_mp * v26, T33 * s23_mm + c23_mm * v26
        Y4 = w1 * (v2 * (T13 * Y1 + wx * T23))
        v27 = Y4 * Y4
        v28, v29, v30 = v27 + X4_pp * X4_pp, v27 + X4_pm * X4_pm, v27 + X4_mp * X4_mp
        v31, v32 = v27 + X4_mm * X4_mm, math.copysign(half_turn, Y4)
        v33 = math.copysign(half_turn, -Y4)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v34, v35 = w1 * (v2 * (wx * T22 + Y1 * T12)), w1 * (v2 * (Y1 * T22 - wx * T12))
        v36, v37 = w1 * (v2 * (wx * T21 + Y1 * T11)), w1 * (v2 * (Y1 * T21 - wx * T11))
        v38 = Y4 * (c23_pp * v37 - s23_pp * T31) - -X4_pp * v36
        v39 = Y4 * (c23_pm * v37 - s23_pm * T31) - -X4_pm * v36
        v40 = Y4 * (c23_mp * v37 + s23_mp * T31) - X4_mp * v36
        v41 = Y4 * (c23_mm * v37 + s23_mm * T31) - X4_mm * v36

        # joint values
        v42 = w3_p * (m4 * v3)

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v31 <= m10 or v30 <= m10 or v29 <= m10 or v28 <= m10 or abs(D3_squared_m) <= m3
            or v1 <= m1 or abs(D3_squared_p) <= m3 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = Y1, w3_p, w3_m
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v32, v33, v38
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = v39, v40, v41
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = Y1, Y4, Y4
        turns[3 * w + k], turns[4 * w + k], turns[5 * w + k] = -Y4, -Y4, v38
        turns[6 * w + k], turns[7 * w + k], turns[8 * w + k] = v39, v40, v41
        turns[9 * w + k], turns[10 * w + k] = v42 - v6, -(v6 + v42)
        turns[11 * w + k], turns[12 * w + k] = w3_m * (m4 * v4) - v7, w3_m * (m4 * -v4) - v7
        turns[13 * w + k], turns[14 * w + k], turns[15 * w + k] = w3_p, w3_m, math.sqrt(v28)
        turns[16 * w + k], turns[17 * w + k] = math.sqrt(v29), math.sqrt(v30)
        turns[18 * w + k], turns[24 * w + k], turns[25 * w + k] = math.sqrt(v31), -wx, -X4_pp
        turns[26 * w + k], turns[27 * w + k], turns[28 * w + k] = -X4_pm, -X4_mp, -X4_mm
        turns[29 * w + k] = Y4 * (c23_pp * v35 - s23_pp * T32) - -X4_pp * v34
        turns[30 * w + k] = Y4 * (c23_pm * v35 - s23_pm * T32) - -X4_pm * v34
        turns[31 * w + k] = Y4 * (c23_mp * v35 + s23_mp * T32) - X4_mp * v34
        turns[32 * w + k] = Y4 * (c23_mm * v35 + s23_mm * T32) - X4_mm * v34
        turns[33 * w + k], turns[34 * w + k] = -(v8 + w3_p * v10), -(v8 + w3_p * v11)
        turns[35 * w + k], turns[36 * w + k] = -(v9 + w3_m * v10), -(v9 + w3_m * v11)
        turns[37 * w + k], turns[38 * w + k] = N3_p - k3, N3_m - k3
        turns[39 * w + k] = T33 * c23_pp + s23_pp * v26
        turns[40 * w + k] = T33 * c23_pm + s23_pm * v26
        turns[41 * w + k] = T33 * c23_mp - s23_mp * v26
        turns[42 * w + k] = T33 * c23_mm - s23_mm * v26
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 19 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(19 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        Y1, w3_p, w3_m = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v32, v33, v38 = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v39, v40, v41 = kept[23 * w + k], kept[24 * w + k], kept[25 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5, angle6 = turns[3 * w + k], turns[4 * w + k], turns[5 * w + k]
        angle7, angle8, angle9 = turns[6 * w + k], turns[7 * w + k], turns[8 * w + k]
        angle10, angle11, angle12 = turns[9 * w + k], turns[10 * w + k], turns[11 * w + k]
        angle13, angle14, angle15 = turns[12 * w + k], turns[13 * w + k], turns[14 * w + k]
        angle16, angle17, angle18 = turns[15 * w + k], turns[16 * w + k], turns[17 * w + k]
        angle19 = turns[18 * w + k]

        # theta4, type 2: U4[3, 3]
        q4_ppm, q4_pmm, q4_mpm = angle2 - v32, angle3 - v32, angle4 - v33
        q4_mmm = angle5 - v33

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle6 - math.copysign(half_turn, v38)
        q6_pmm = angle7 - math.copysign(half_turn, v39)
        q6_mpm = angle8 - math.copysign(half_turn, v40)
        q6_mmm = angle9 - math.copysign(half_turn, v41)

        # joint values
        v43, v44, v45 = angle10 - offset2, angle11 - offset2, angle12 - offset2
        v46 = angle13 - offset2
        q2_ppp = v43 + (-turn if half_turn < v43 else 0.0)
        q2_pmp = v44 + (-turn if half_turn < v44 else 0.0)
        q2_mpp = v45 + (-turn if half_turn < v45 else 0.0)
        q2_mmp = v46 + (-turn if half_turn < v46 else 0.0)
        v47, v48 = angle14 - turn1 - offset3, offset3 + (turn1 + angle14)
        v49, v50 = angle15 - turn1 - offset3, offset3 + (turn1 + angle15)
        q3_ppp = v47 + (-turn if half_turn < v47 else 0.0)
        q3_pmp = (-turn if half_turn < -v48 else 0.0) - v48
        q3_mpp = v49 + (-turn if half_turn < v49 else 0.0)
        q3_mmp = (-turn if half_turn < -v50 else 0.0) - v50
        v51, v52, v53 = angle16 - offset5, offset5 + angle16, angle17 - offset5
        v54, v55, v56 = offset5 + angle17, angle18 - offset5, offset5 + angle18
        v57, v58 = angle19 - offset5, offset5 + angle19
        q5_ppp = v51 + (turn if v51 <= -half_turn else 0.0)
        q5_ppm = (turn if -v52 <= -half_turn else 0.0) - v52
        q5_pmp = v53 + (turn if v53 <= -half_turn else 0.0)
        q5_pmm = (turn if -v54 <= -half_turn else 0.0) - v54
        q5_mpp = v55 + (turn if v55 <= -half_turn else 0.0)
        q5_mpm = (turn if -v56 <= -half_turn else 0.0) - v56
        q5_mmp = v57 + (turn if v57 <= -half_turn else 0.0)
        q5_mmm = (turn if -v58 <= -half_turn else 0.0) - v58
        q1_ppp = angle1 + (w3_p - w3_p)
        q1_mpp = angle1 - math.copysign(half_turn, Y1) + (w3_m - w3_m)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, q2_ppp, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle2, q5_ppp, angle6
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, q5_ppm, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q2_pmp, q3_pmp, angle3
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q5_pmp, angle7, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q5_pmm, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q2_mpp, q3_mpp, angle4
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = q5_mpp, angle8, q4_mpm
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q5_mpm, q6_mpm, q2_mmp
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q3_mmp, angle5, q5_mmp
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = angle9, q4_mmm, q5_mmm
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
