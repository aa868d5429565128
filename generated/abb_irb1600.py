# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 6c48156184b3fa9e
"""abb_irb1600: ABB IRB 1600.

Inverse kinematics, generated from robots/abb_irb1600.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/abb_irb1600.yaml. The formulas and where they come from:
abb_irb1600.md.

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

NAME = "abb_irb1600"
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

# In formulas below, doubt_limit1 = 0.00020014999999999999 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.4865  # joint offset 1 [m]
a1 = 0.15  # link length 1 [m]
a2 = 0.7  # link length 2 [m]
d4 = 0.6  # joint offset 4 [m]
d6 = 0.065  # joint offset 6 [m]
free_limit1 = 2.0015e-12  # a length that fixes no angle [m]
longest3 = 1.6899999999999995  # square of the longest reach [m^2]
shortest3 = 0.009999999999999995  # square of the shortest reach [m^2]
longest3_reach = 1.6900000000005198  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.009999999999959966  # the shortest, with what rounding adds [m^2]
longest3_apart = 1.6899999999999475  # the longest, where branches merge [m^2]
shortest3_apart = 0.010000000000003999  # the shortest, where branches merge [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset3 = 1.5707963267948966  # offset of joint 3 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
k1 = 0.84  # 2 * d4 * a2 [m^2]
k2 = 0.8499999999999999  # a2^2 + d4^2 [m^2]
k3 = 1.4172335600907033  # 1 / (k1^2) [m^-4]
m1 = 4.006002249999999e-08  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 8.729017508812558e-11
m4 = 0.7142857142857144  # d4 * k1 * k3 [m^-1]
m5 = 0.09285714285714279  # a2 - d4 * k1 * k2 * k3 [m]
m6 = 0.8333333333333335  # a2 * k1 * k3 [m^-1]
# k1 * k3 * (a2 * k2 + d4 * longest3 * shortest3 * k1 * k3 - d4 * k1 * k2^2 * k3) [m]
m7 = 0.10833333333333327
m8 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.4996, 0.4996, 0.4996, 1.0, 1.0, 1.0), size=2.0015, steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.4865, 0.15, -1.5707963267948966),
    (-1.5707963267948966, 0.0, 0.7, 0.0),
    (1.5707963267948966, 0.0, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.6, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.065, 0.0, 0.0),
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
    z3_x, z3_y, z3_z = v2 * c3 + x2_x * s3, v3 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    v6 = q[3] + offset4
    c4, s4 = math.cos(v6), math.sin(v6)
    x4_x, x4_y, v7 = x3_x * c4 - s1 * s4, x3_y * c4 + c1 * s4, v5 * c4
    z4_x, v8, z4_y = s1 * c4 + x3_x * s4, v5 * s4, x3_y * s4 - c1 * c4
    v9 = q[4] + offset5
    c5, s5 = math.cos(v9), math.sin(v9)
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, x4_y * c5 + z3_y * s5, z3_z * s5 - v7 * c5
    v10, z5_x, z5_y = z3_z * c5 + v7 * s5, x4_x * s5 - z3_x * c5, x4_y * s5 - z3_y * c5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + z4_x * s6, z4_x * c6 - x5_x * s6, z5_x
    T[0, 3] = c1 * a1 + x2_x * a2 + z3_x * d4 + z5_x * d6
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + z4_y * s6, z4_y * c6 - x5_y * s6, z5_y
    T[1, 3] = s1 * a1 + x2_y * a2 + z3_y * d4 + z5_y * d6
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 - v8 * s6, -(v8 * c6 + x5_z * s6), -v10
    T[2, 3] = d1 - s2 * a2 + z3_z * d4 - v10 * d6
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
    z3_x, z3_y, z3_z = v2 * c3 + x2_x * s3, v3 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    v6 = q[3] + offset4
    c4, s4 = math.cos(v6), math.sin(v6)
    z4_x, v7, p4_x = s1 * c4 + x3_x * s4, v5 * s4, p2_x + z3_x * d4
    p4_y, p4_z, z4_y = p2_y + z3_y * d4, p2_z + z3_z * d4, x3_y * s4 - c1 * c4
    v8 = q[4] + offset5
    c5, s5 = math.cos(v8), math.sin(v8)
    v9, z5_x = z3_z * c5 + v5 * c4 * s5, (x3_x * c4 - s1 * s4) * s5 - z3_x * c5
    z5_y, p6_x = (x3_y * c4 + c1 * s4) * s5 - z3_y * c5, p4_x + z5_x * d6
    p6_y, p6_z = p4_y + z5_y * d6, p4_z - v9 * d6
    v10, v11, v12 = p6_z - d1, p6_x - p2_x, p6_y - p2_y
    v13, v14, v15 = p6_z - p2_z, p6_x - p4_x, p6_y - p4_y
    v16 = p6_z - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, c1 * v10, c1 * v13
    J[0, 3], J[0, 4] = z3_y * v13 - z3_z * v12, z4_y * v16 + v7 * v15
    J[0, 5] = z5_y * v16 + v9 * v15
    J[1, 0], J[1, 1], J[1, 2] = p6_x, s1 * v10, s1 * v13
    J[1, 3], J[1, 4] = z3_z * v11 - z3_x * v13, -(v7 * v14 + z4_x * v16)
    J[1, 5] = -(v9 * v14 + z5_x * v16)
    J[2, 1], J[2, 2] = -(s1 * (p6_y - p1_y) + c1 * (p6_x - p1_x)), -(s1 * v12 + c1 * v11)
    J[2, 3], J[2, 4] = z3_x * v12 - z3_y * v11, z4_x * v15 - z4_y * v14
    J[2, 5] = z5_x * v15 - z5_y * v14
    J[3, 1], J[3, 2], J[3, 3] = -s1, -s1, z3_x
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = c1, c1, z3_y
    J[4, 4], J[4, 5] = z4_y, z5_y
    J[5, 0], J[5, 3], J[5, 4] = 1.0, z3_z, -v7
    J[5, 5] = -v9
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
    v2 = Z1_3 * Z1_3

    # theta4, type 2: U4[3, 3]
    v11 = seed[3] + offset4

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
        K3 = N3 - k2
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        s3 = k1 * K3 * k3

        # theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4]
        Y1_2 = a2 + d4 * s3
        v5, v6 = Z1_3 * Y1_2, v1 * Y1_2

        # theta4
        v9 = T13 * c1 + T23 * s1
        Y4 = T23 * c1 - T13 * s1
        v10 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v12, v13, v15 = T12 * s1 - T22 * c1, T12 * c1 + T22 * s1, T11 * s1 - T21 * c1
        v16 = T11 * c1 + T21 * s1

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            v3 = k3 * (k1 * (w3 * e3))

            # theta2
            v4 = d4 * v3
            S2 = v1 * v4 - v5
            v7 = Z1_3 * v4 + v6
            w2 = math.sqrt(S2 * S2 + v7 * v7)
            factor2 = 1.0 / w2
            c2, s2 = -(v7 * factor2), S2 * factor2

            # theta4
            v8 = v3 * c2 + s3 * s2
            s23 = s3 * c2 - v3 * s2
            X4 = v8 * v9 + T33 * s23
            w4 = math.sqrt(X4 * X4 + v10)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T33 * v8 - s23 * v9

            # theta6
            v14, v17 = v8 * v13 + T32 * s23, v8 * v16 + T31 * s23

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(s3, -v3) - offset3)

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(v11) if free4 else -(X4 * factor4)
                s4 = math.sin(v11) if free4 else Y4 * factor4
                s5 = w4 * e4

                # theta6
                c6, s6 = c4 * v12 - s4 * v14, c4 * v15 - s4 * v17
                q6 = _atan2(s6, c6)

                # joint values
                q4 = _wrap(_atan2(s4, c4) - offset4)
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
        factor1 = w1 * v2
        v3, s1 = wx * factor1, Y1 * factor1

        # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        Z1_3, v4, v5 = T34 - d6 * T33 - d1, a1 + w1, a1 - w1
        v6 = Z1_3 * Z1_3
        N3_p, N3_m = v6 + v4 * v4, v6 + v5 * v5
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3)
        D3_squared_m, w3_p = (longest3 - N3_m) * (N3_m - shortest3), math.sqrt(D3_squared_p)
        w3_m, v7, v8 = math.sqrt(D3_squared_m), k1 * (N3_p - k2), k1 * (N3_m - k2)

        # theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4]
        v9, v10 = m5 + m4 * N3_p, m5 + m4 * N3_m
        v11, v12, v13 = Z1_3 * v9, Z1_3 * v10, m4 * Z1_3
        v14, v15, v16 = m4 * -Z1_3, v4 * v9, v5 * v10
        factor2_p, factor2_m = 1.0 / N3_p, 1.0 / N3_m

        # theta4, type 2: U4[3, 3]
        v17, v18, v19 = m7 - m6 * N3_p, m7 - m6 * N3_m, T23 * s1 - T13 * v3
        v20 = T33 * Z1_3
        v21, v22, v23 = v20 - v4 * v19, v20 - v19 * -v5, Z1_3 * v17
        v24, v25, v26 = Z1_3 * -v18, T33 * v17, T33 * v18
        v27, v28 = v19 * v23 + v4 * v25, v19 * v24 + v5 * v26
        X4_pp, X4_pm = v27 + w3_p * (m6 * v21), v27 + w3_p * (m6 * -v21)
        X4_mp, X4_mm = v28 + w3_m * (m6 * v22), v28 + w3_m * (m6 * -v22)
        v29 = w1 * (v2 * (T13 * Y1 + wx * T23))
        v30, v31, v32 = v29 * v29, factor2_p * X4_pp, factor2_p * X4_pm
        v33, v34, v35 = factor2_m * X4_mp, factor2_m * X4_mm, v30 + factor2_p * (X4_pp * v31)
        v36, v37 = v30 + factor2_p * (X4_pm * v32), v30 + factor2_m * (X4_mp * v33)
        v38 = v30 + factor2_m * (X4_mm * v34)

        # theta5, type 3: U4[2, 3] and U4[1, 3]
        v39, v40 = v19 * (v4 * -v17) + Z1_3 * v25, v19 * (v5 * v18) + Z1_3 * v26

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v41, v42, v43 = w1 * (v2 * (wx * T22 + Y1 * T12)), s1 * T22 - v3 * T12, Z1_3 * T32
        v44, v45, v46 = v43 - v4 * v42, v43 - -v5 * v42, v23 * v42 + v4 * (v17 * T32)
        v47, v48 = v24 * v42 + v5 * (v18 * T32), w1 * (v2 * (wx * T21 + Y1 * T11))
        v49, v50 = s1 * T21 - v3 * T11, Z1_3 * T31
        v51, v52, v53 = v50 - v4 * v49, v50 - -v5 * v49, v23 * v49 + v4 * (v17 * T31)
        v54, v55 = v24 * v49 + v5 * (v18 * T31), v29 * (v53 + w3_p * (m6 * v51)) - X4_pp * v48
        v56 = v29 * (v53 + w3_p * (m6 * -v51)) - X4_pm * v48
        v57 = X4_mp * v48 - v29 * (v54 + w3_m * (m6 * v52))
        v58 = X4_mm * v48 - v29 * (v54 + w3_m * (m6 * -v52))

        # joint values
        v59, v68 = w3_p * (m4 * v4), math.copysign(half_turn, -v29)
        v69, v78 = math.copysign(half_turn, v29), w3_p * (m6 * (Z1_3 * v19 + T33 * v4))
        v79 = w3_m * (m6 * (-Z1_3 * v19 + T33 * v5))

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v38 <= m8 or v37 <= m8 or v36 <= m8 or v35 <= m8 or abs(D3_squared_m) <= m3 or v1
            <= m1 or abs(D3_squared_p) <= m3 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = Y1, w3_p, w3_m
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v7, v8, v55
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = v56, v57, v58
        kept[26 * w + k], kept[27 * w + k], turns[0 * w + k] = v68, v69, Y1
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = v55, v56, v57
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = v58, v59 - v11, -(v11 + v59)
        turns[7 * w + k], turns[8 * w + k] = w3_m * (m4 * v5) - v12, w3_m * (m4 * -v5) - v12
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = v7, v8, -v29
        turns[12 * w + k], turns[13 * w + k], turns[14 * w + k] = -v29, v29, v29
        turns[15 * w + k], turns[16 * w + k] = math.sqrt(v35), math.sqrt(v36)
        turns[17 * w + k], turns[18 * w + k] = math.sqrt(v37), math.sqrt(v38)
        turns[24 * w + k], turns[25 * w + k] = -wx, v29 * (v46 + w3_p * (m6 * v44)) - X4_pp * v41
        turns[26 * w + k] = v29 * (v46 + w3_p * (m6 * -v44)) - X4_pm * v41
        turns[27 * w + k] = X4_mp * v41 - v29 * (v47 + w3_m * (m6 * v45))
        turns[28 * w + k] = X4_mm * v41 - v29 * (v47 + w3_m * (m6 * -v45))
        turns[29 * w + k], turns[30 * w + k] = -(v15 + w3_p * v13), -(v15 + w3_p * v14)
        turns[31 * w + k], turns[32 * w + k] = -(v16 + w3_m * v13), -(v16 + w3_m * v14)
        turns[33 * w + k], turns[34 * w + k], turns[35 * w + k] = -(k1 * w3_p), -(k1 * w3_m), -v31
        turns[36 * w + k], turns[37 * w + k], turns[38 * w + k] = -v32, -v33, -v34
        turns[39 * w + k], turns[40 * w + k] = factor2_p * (v39 - v78), factor2_p * (v39 + v78)
        turns[41 * w + k], turns[42 * w + k] = factor2_m * (v40 - v79), factor2_m * (v40 + v79)
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
        v7, v8, v55 = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v56, v57, v58 = kept[23 * w + k], kept[24 * w + k], kept[25 * w + k]
        v68, v69, angle1 = kept[26 * w + k], kept[27 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle8, angle9, angle10 = turns[7 * w + k], turns[8 * w + k], turns[9 * w + k]
        angle11, angle12, angle13 = turns[10 * w + k], turns[11 * w + k], turns[12 * w + k]
        angle14, angle15, angle16 = turns[13 * w + k], turns[14 * w + k], turns[15 * w + k]
        angle17, angle18, angle19 = turns[16 * w + k], turns[17 * w + k], turns[18 * w + k]

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle2 - math.copysign(half_turn, v55)
        q6_pmm = angle3 - math.copysign(half_turn, v56)
        q6_mpm = angle4 - math.copysign(half_turn, v57)
        q6_mmm = angle5 - math.copysign(half_turn, v58)

        # joint values
        v60, v61, v62 = angle6 - offset2, angle7 - offset2, angle8 - offset2
        v63 = angle9 - offset2
        q2_ppp = v60 + (-turn if half_turn < v60 else 0.0)
        q2_pmp = v61 + (-turn if half_turn < v61 else 0.0)
        q2_mpp = v62 + (-turn if half_turn < v62 else 0.0)
        q2_mmp = v63 + (-turn if half_turn < v63 else 0.0)
        v64, v65 = angle10 - offset3, math.copysign(half_turn, v7) - angle10 - offset3
        v66, v67 = angle11 - offset3, math.copysign(half_turn, v8) - angle11 - offset3
        q3_ppp = v64 + (turn if v64 <= -half_turn else 0.0)
        q3_pmp = v65 + (turn if v65 <= -half_turn else 0.0)
        q3_mpp = v66 + (turn if v66 <= -half_turn else 0.0)
        q3_mmp = v67 + (turn if v67 <= -half_turn else 0.0)
        v70, v71, v72 = angle12 - offset4, angle12 - v68 - offset4, angle13 - offset4
        v73, v74, v75 = angle13 - v68 - offset4, angle14 - offset4, angle14 - v69 - offset4
        v76, v77 = angle15 - offset4, angle15 - v69 - offset4
        q4_ppp = v70 + (turn if v70 <= -half_turn else 0.0)
        q4_ppm = v71 + (turn if v71 <= -half_turn else 0.0)
        q4_pmp = v72 + (turn if v72 <= -half_turn else 0.0)
        q4_pmm = v73 + (turn if v73 <= -half_turn else 0.0)
        q4_mpp = v74 + (turn if v74 <= -half_turn else 0.0)
        q4_mpm = v75 + (turn if v75 <= -half_turn else 0.0)
        q4_mmp = v76 + (turn if v76 <= -half_turn else 0.0)
        q4_mmm = v77 + (turn if v77 <= -half_turn else 0.0)
        v80, v81, v82 = angle16 - offset5, offset5 + angle16, angle17 - offset5
        v83, v84, v85 = offset5 + angle17, angle18 - offset5, offset5 + angle18
        v86, v87 = angle19 - offset5, offset5 + angle19
        q5_ppp = v80 + (turn if v80 <= -half_turn else 0.0)
        q5_ppm = (turn if -v81 <= -half_turn else 0.0) - v81
        q5_pmp = v82 + (turn if v82 <= -half_turn else 0.0)
        q5_pmm = (turn if -v83 <= -half_turn else 0.0) - v83
        q5_mpp = v84 + (turn if v84 <= -half_turn else 0.0)
        q5_mpm = (turn if -v85 <= -half_turn else 0.0) - v85
        q5_mmp = v86 + (turn if v86 <= -half_turn else 0.0)
        q5_mmm = (turn if -v87 <= -half_turn else 0.0) - v87
        q1_ppp = angle1 + (w3_p - w3_p)
        q1_mpp = angle1 - math.copysign(half_turn, Y1) + (w3_m - w3_m)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, q2_ppp, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_ppp, q5_ppp, angle2
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, q5_ppm, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q2_pmp, q3_pmp, q4_pmp
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q5_pmp, angle3, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q5_pmm, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q2_mpp, q3_mpp, q4_mpp
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = q5_mpp, angle4, q4_mpm
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q5_mpm, q6_mpm, q2_mmp
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q3_mmp, q4_mmp, q5_mmp
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = angle5, q4_mmm, q5_mmm
        rows[33 * w + k] = q6_mmm
        rows[34 * w + k] = rows[35 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[36 * w + k] = rows[37 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[38 * w + k] = rows[39 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[40 * w + k] = rows[41 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 28, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 19, 20, 21, 22], [17, 18, 19, 23, 24, 25], [17, 26, 27, 28, 29, 30],
    [17, 26, 27, 31, 32, 33],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
