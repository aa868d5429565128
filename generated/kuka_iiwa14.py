# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 7f9271a70e3d8ac9
"""kuka_iiwa14: KUKA LBR iiwa 14 R820.

Inverse kinematics, generated from robots/kuka_iiwa14.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kuka_iiwa14.yaml. The formulas and where they come from:
kuka_iiwa14.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 7), _runtime("arrays").zeros

NAME = "kuka_iiwa14"
METHOD = "closed form"
DOF = 7
JOINT_TYPES = "RRRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6", "joint7")
JOINT_LIMITS = (
    (-2.9670597283903604, 2.9670597283903604), (-2.0943951023931953, 2.0943951023931953),
    (-2.9670597283903604, 2.9670597283903604), (-2.0943951023931953, 2.0943951023931953),
    (-2.9670597283903604, 2.9670597283903604), (-2.0943951023931953, 2.0943951023931953),
    (-3.0543261909900767, 3.0543261909900767),
)
BRANCHES = (
    "elbow+-shoulder+-noflip", "elbow+-shoulder+-flip", "elbow+-shoulder--noflip",
    "elbow+-shoulder--flip", "elbow--shoulder+-noflip", "elbow--shoulder+-flip",
    "elbow--shoulder--noflip", "elbow--shoulder--flip",
)
MAX_SOLUTIONS = 8
FREE_JOINTS = (3,)  # from 1: the caller gives their values

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, arm_size2 = 1.7056360000000002 [m^2], doubt_limit = 9.999999999999999e-05.
d1 = 0.36  # joint offset 1 [m]
d3 = 0.42  # joint offset 3 [m]
d5 = 0.4  # joint offset 5 [m]
d7 = 0.126  # joint offset 7 [m]
longest4 = 0.6724000000000001  # square of the longest reach [m^2]
shortest4 = 0.0003999999999999985  # square of the shortest reach [m^2]
longest4_reach = 0.6724000000002143  # the longest, with what rounding adds [m^2]
shortest4_reach = 0.0003999999999947745  # the shortest, with what rounding adds [m^2]
longest4_apart = 0.6723999999999786  # the longest, where branches merge [m^2]
shortest4_apart = 0.00040000000000052087  # the shortest, where branches merge [m^2]
least_root2 = 5.393694619178955e-07  # a root of nothing, by rounding [m^2]
free_limit_squared2 = 1.705636e-24  # square of a length that fixes no angle [m^2]
reach_slack1 = 1.3060000000000002e-13  # rounding at the boundary of the workspace [m]
merge_slack1 = 1.306e-14  # nearer to that boundary two branches are one [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
offset2 = 3.141592653589793  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset6 = 3.141592653589793  # offset of joint 6 [rad]
k1 = 0.336  # 2 * d5 * d3 [m^2]
k2 = 0.33640000000000003  # d3^2 + d5^2 [m^2]
k3 = 0.5862915651405106  # 1 / arm_size2 [m^-2]
k4 = 8.857709750566894  # 1 / (k1^2) [m^-4]
doubt_limit_squared2 = 1.705636e-08  # square of a length that fixes no angle [m^2]
high1 = 2.9670597293903604  # highest value of joint 1, with what rounding adds [rad]
high2 = 2.0943951033931953  # highest value of joint 2, with what rounding adds [rad]
high3 = 2.9670597293903604  # highest value of joint 3, with what rounding adds [rad]
high4 = 2.0943951033931953  # highest value of joint 4, with what rounding adds [rad]
high5 = 2.9670597293903604  # highest value of joint 5, with what rounding adds [rad]
high6 = 2.0943951033931953  # highest value of joint 6, with what rounding adds [rad]
high7 = 3.054326191990077  # highest value of joint 7, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
# 1000 * (longest4 - longest4_apart) * (longest4_apart - shortest4) [m^4]
m1 = 1.4473755527432779e-11
m2 = 1.306e-11  # 1000 * merge_slack1 [m]
m3 = 2.909194164496e-16  # doubt_limit_squared2^2 [m^4]
m4 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.7657, 0.7657, 0.7657, 1.0, 1.0, 1.0), size=1.306,
    paces=(1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.0),
    steps=("keeps limits", "merges", "refines", "clamps", "clamps far", "follows seed"), given=(2,),
    choosable=(4, 1, 0),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (3.141592653589793, 0.36, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.42, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.4, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.126, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (7,)."""
    T = _zeros(4, 4)
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, x2_y, z2_x = c1 * c2, s1 * c2, c1 * s2
    z2_y = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + s1 * s3, x2_y * c3 - c1 * s3, s2 * c3
    z3_y, z3_z, z3_x = c1 * c3 + x2_y * s3, s2 * s3, x2_x * s3 - s1 * c3
    v3 = q[3] + offset4
    c4, s4 = math.cos(v3), math.sin(v3)
    x4_x, x4_y, x4_z = x3_x * c4 + z2_x * s4, x3_y * c4 + z2_y * s4, x3_z * c4 - c2 * s4
    z4_z, z4_x, z4_y = c2 * c4 + x3_z * s4, x3_x * s4 - z2_x * c4, x3_y * s4 - z2_y * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, x4_y * c5 + z3_y * s5, x4_z * c5 + z3_z * s5
    z5_x, z5_y, z5_z = x4_x * s5 - z3_x * c5, x4_y * s5 - z3_y * c5, x4_z * s5 - z3_z * c5
    v4 = q[5] + offset6
    c6, s6 = math.cos(v4), math.sin(v4)
    x6_x, x6_y, x6_z = x5_x * c6 + z4_x * s6, x5_y * c6 + z4_y * s6, x5_z * c6 + z4_z * s6
    z6_x, z6_y, z6_z = x5_x * s6 - z4_x * c6, x5_y * s6 - z4_y * c6, x5_z * s6 - z4_z * c6
    c7, s7 = math.cos(q[6]), math.sin(q[6])
    T[0, 0], T[0, 1], T[0, 2] = x6_x * c7 + z5_x * s7, z5_x * c7 - x6_x * s7, z6_x
    T[0, 3] = z2_x * d3 + z4_x * d5 + z6_x * d7
    T[1, 0], T[1, 1], T[1, 2] = x6_y * c7 + z5_y * s7, z5_y * c7 - x6_y * s7, z6_y
    T[1, 3] = z2_y * d3 + z4_y * d5 + z6_y * d7
    T[2, 0], T[2, 1], T[2, 2] = x6_z * c7 + z5_z * s7, z5_z * c7 - x6_z * s7, z6_z
    T[2, 3] = d1 - c2 * d3 + z4_z * d5 + z6_z * d7
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 7): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 7)
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, x2_y, z2_x = c1 * c2, s1 * c2, c1 * s2
    z2_y = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + s1 * s3, x2_y * c3 - c1 * s3, s2 * c3
    z3_y, z3_z, p3_x = c1 * c3 + x2_y * s3, s2 * s3, z2_x * d3
    p3_y, p3_z, z3_x = z2_y * d3, d1 - c2 * d3, x2_x * s3 - s1 * c3
    v3 = q[3] + offset4
    c4, s4 = math.cos(v3), math.sin(v3)
    x4_x, x4_y, x4_z = x3_x * c4 + z2_x * s4, x3_y * c4 + z2_y * s4, x3_z * c4 - c2 * s4
    z4_z, z4_x, z4_y = c2 * c4 + x3_z * s4, x3_x * s4 - z2_x * c4, x3_y * s4 - z2_y * c4
    c5, s5, p5_x = math.cos(q[4]), math.sin(q[4]), p3_x + z4_x * d5
    p5_y, p5_z, z5_x = p3_y + z4_y * d5, p3_z + z4_z * d5, x4_x * s5 - z3_x * c5
    z5_y, z5_z, v4 = x4_y * s5 - z3_y * c5, x4_z * s5 - z3_z * c5, q[5] + offset6
    c6, s6 = math.cos(v4), math.sin(v4)
    z6_x, z6_y = (x4_x * c5 + z3_x * s5) * s6 - z4_x * c6, (x4_y * c5 + z3_y * s5) * s6 - z4_y * c6
    z6_z, p7_x, p7_y = (x4_z * c5 + z3_z * s5) * s6 - z4_z * c6, p5_x + z6_x * d7, p5_y + z6_y * d7
    p7_z = p5_z + z6_z * d7
    v5, v6, v7 = p7_z - d1, p7_x - p3_x, p7_y - p3_y
    v8, v9, v10 = p7_z - p3_z, p7_x - p5_x, p7_y - p5_y
    v11 = p7_z - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -p7_y, -(c1 * v5), z2_y * v5 + c2 * p7_y
    J[0, 3], J[0, 4] = z3_y * v8 - z3_z * v7, z4_y * v8 - z4_z * v7
    J[0, 5], J[0, 6] = z5_y * v11 - z5_z * v10, z6_y * v11 - z6_z * v10
    J[1, 0], J[1, 1], J[1, 2] = p7_x, -(s1 * v5), -(c2 * p7_x + z2_x * v5)
    J[1, 3], J[1, 4], J[1, 5] = z3_z * v6 - z3_x * v8, z4_z * v6 - z4_x * v8, z5_z * v9 - z5_x * v11
    J[1, 6] = z6_z * v9 - z6_x * v11
    J[2, 1], J[2, 2] = s1 * p7_y + c1 * p7_x, z2_x * p7_y - z2_y * p7_x
    J[2, 3], J[2, 4], J[2, 5] = z3_x * v7 - z3_y * v6, z4_x * v7 - z4_y * v6, z5_x * v10 - z5_y * v9
    J[2, 6] = z6_x * v10 - z6_y * v9
    J[3, 1], J[3, 2], J[3, 3] = s1, z2_x, z3_x
    J[3, 4], J[3, 5], J[3, 6] = z4_x, z5_x, z6_x
    J[4, 1], J[4, 2], J[4, 3] = -c1, z2_y, z3_y
    J[4, 4], J[4, 5], J[4, 6] = z4_y, z5_y, z6_y
    J[5, 0], J[5, 2], J[5, 3] = 1.0, -c2, z3_z
    J[5, 4], J[5, 5], J[5, 6] = z4_z, z5_z, z6_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    c3, s3 = math.cos(q_free[0]), math.sin(q_free[0])

    # theta4, type 2: the squared length of column 4 of U1 A7^-1
    wx = T14 - T13 * d7
    wy = T24 - d7 * T23
    v1 = wy * wy
    wz = T34 - d7 * T33
    Z1_2 = wz - d1
    V4 = wx * wx + v1 + Z1_2 * Z1_2
    Z4 = V4 - k2
    D4_squared = (longest4 - V4) * (V4 - shortest4)
    apart4 = shortest4_apart < V4 and V4 < longest4_apart
    if not (shortest4_reach <= V4 and V4 <= longest4_reach):
        return  # out of reach
    w4 = math.sqrt(D4_squared if apart4 else 0.0)
    v2 = (w4 if apart4 else least_root2) * k3
    v3 = k4 * (k1 * Z4)

    # theta1, type 2: U1 A7^-1 [3, 4]
    N1 = v1 + -wx * -wx
    free1 = N1 <= free_limit_squared2
    v7, v10 = math.sqrt(N1), seed[0] + offset1

    # theta2, type 3: U1 A7^-1 [2, 4] and U1 A7^-1 [1, 4]
    X2_2 = d3 + d5 * v3
    v13, v15 = Z1_2 * X2_2, seed[1] + offset2

    # theta5, type 2: U5[3, 3]
    v16 = c3 * T13
    v17, v18 = v3 * v16, c3 * T23
    v19, v23 = v3 * v18, c3 * T33
    v24, v27 = v3 * v23, s3 * T33

    # theta6, type 3: U5[2, 3] and U5[1, 3]
    v30, v31, v32 = T33 * v3, T13 * v3, T23 * v3

    # theta7, type 3: U5[3, 2] and U5[3, 1]
    v34, v37, v38 = s3 * T32, v3 * (c3 * T12), v3 * (c3 * T22)
    v42, v44, v47 = v3 * (c3 * T32), s3 * T31, v3 * (c3 * T11)
    v48, v52 = v3 * (c3 * T21), v3 * (c3 * T31)

    for i1 in range(2):  # elbow+, elbow-
        e4 = 1.0 - 2.0 * i1
        # theta4
        if e4 < 0.0 and not apart4:
            continue  # both signs give the same
        v4 = k4 * (k1 * (w4 * e4))

        # theta1
        Z1 = d5 * (s3 * v4)
        D1_squared = N1 - Z1 * Z1
        v5 = abs(Z1)
        v6 = 2.0 * v5
        apart1 = merge_slack1 * (v6 + merge_slack1) < D1_squared
        if not (-(reach_slack1 * (v6 + reach_slack1)) < v2 * D1_squared):
            continue  # out of reach
        w1 = math.sqrt(D1_squared if apart1 else 0.0)
        inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else v5 * v7))
        v8, v9 = -wx * Z1, wy * Z1

        # theta2
        v11 = d5 * (c3 * v4)
        v12 = Z1_2 * v11

        # theta5
        v20, v21, v22 = T33 * v4, T13 * v4, T23 * v4

        # theta6
        v28, v29, v33 = v4 * v16, v4 * v18, v4 * v23

        # theta7
        v39, v40, v41 = T32 * v4, T12 * v4, T22 * v4
        v49, v50, v51 = T31 * v4, T11 * v4, T21 * v4

        # joint values
        q4 = _wrap(_atan2(-v4, -v3) - offset4)

        for i2 in range(2):  # shoulder+, shoulder-
            e1 = 1.0 - 2.0 * i2
            # theta1
            if e1 < 0.0 and (free1 or not apart1):
                continue  # both signs give the same
            D1 = w1 * e1
            c1 = math.cos(v10) if free1 else inverse1 * (v9 - -wx * D1)
            s1 = math.sin(v10) if free1 else inverse1 * (v8 + wy * D1)

            # theta2
            S2 = D1 * X2_2 - v12
            v14 = D1 * v11 + v13
            w2 = math.sqrt(S2 * S2 + v14 * v14)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v15) if free2 else -(v14 * factor2)
            s2 = math.sin(v15) if free2 else S2 * factor2

            # theta5
            v25 = T13 * s1 - T23 * c1
            v26 = s3 * v25
            X5 = v3 * v26 - (c2 * (v20 - (c1 * v17 + s1 * v19)) - s2 * (c1 * v21 + s1 * v22 + v24))
            Y5 = c2 * (s3 * (T13 * c1 + T23 * s1)) + s2 * v27 - c3 * v25
            w5 = math.sqrt(X5 * X5 + Y5 * Y5)
            free5 = w5 <= free_limit
            divisor5 = 1.0 if free5 else w5

            # theta6
            c6 = v4 * v26 - (s2 * (c1 * v31 + s1 * v32 - v33) - c2 * (c1 * v28 + s1 * v29 + v30))

            # theta7
            v35 = T12 * s1 - T22 * c1
            v36 = c3 * v35 - (c2 * (s3 * (T12 * c1 + T22 * s1)) + s2 * v34)
            v43 = (
                c2 * (v39 - (c1 * v37 + s1 * v38)) - s2 * (c1 * v40 + s1 * v41 + v42) - v3 * (s3 *
                v35)
            )
            v45 = T11 * s1 - T21 * c1
            v46 = c3 * v45 - (c2 * (s3 * (T11 * c1 + T21 * s1)) + s2 * v44)
            v53 = (
                c2 * (v49 - (c1 * v47 + s1 * v48)) - s2 * (c1 * v50 + s1 * v51 + v52) - v3 * (s3 *
                v45)
            )

            # joint values
            q1 = _wrap(_atan2(s1, c1) - offset1)
            q2 = _wrap(_atan2(s2, c2) - offset2)

            for i3 in range(2):  # noflip, flip
                e5 = 1.0 - 2.0 * i3
                # theta5
                if e5 < 0.0 and free5:
                    continue  # both signs give the same
                factor5 = e5 / divisor5
                c5 = math.cos(seed[4]) if free5 else -(X5 * factor5)
                s5 = math.sin(seed[4]) if free5 else Y5 * factor5
                q5 = _atan2(s5, c5)
                s6 = w5 * e5

                # theta7
                c7, s7 = c5 * v36 + s5 * v43, c5 * v46 + s5 * v53
                q7 = _atan2(s7, c7)

                # joint values
                q6 = _wrap(_atan2(s6, c6) - offset6)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0], q[row, 1], q[row, 2] = q1, q2, q_free[0]
                q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
                q[row, 6] = q7
                status[row] = FREE_JOINT if free1 or free2 or free5 else OK


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
        given1 = kept[16 * w + k]

        # theta4, type 2: the squared length of column 4 of U1 A7^-1
        wx, wy = T14 - d7 * T13, T24 - d7 * T23
        v1, Z1_2 = wy * wy, T34 - d7 * T33 - d1
        V4 = v1 + wx * wx + Z1_2 * Z1_2
        D4_squared = (longest4 - V4) * (V4 - shortest4)
        w4, v2 = math.sqrt(D4_squared), k1 * (V4 - k2)
        v3, v4 = k4 * v2, k1 * w4
        v5 = k4 * v4

        # theta1, type 2: U1 A7^-1 [3, 4]
        N1 = v1 + -wx * -wx
        inverse1 = 1.0 / N1

        # theta2, type 3: U1 A7^-1 [2, 4] and U1 A7^-1 [1, 4]
        X2_2 = d3 + d5 * v3
        v20 = Z1_2 * X2_2

        # theta5, type 2: U5[3, 3]
        v32, v33, v34 = T33 * v5, T13 * v5, T23 * v5

        # theta6, type 3: U5[2, 3] and U5[1, 3]
        v54, v55, v56 = T33 * v3, T13 * v3, T23 * v3

        # theta7, type 3: U5[3, 2] and U5[3, 1]
        v65, v66, v67 = v5 * T32, v5 * T12, v5 * T22
        v76, v77, v78 = v5 * T31, v5 * T11, v5 * T21
        kept[18 * w + k], kept[19 * w + k], kept[20 * w + k] = wx, wy, Z1_2
        kept[21 * w + k], kept[22 * w + k], kept[23 * w + k] = D4_squared, w4, v3
        kept[24 * w + k], kept[25 * w + k], kept[26 * w + k] = v5, N1, inverse1
        kept[27 * w + k], kept[28 * w + k], kept[29 * w + k] = X2_2, v20, v32
        kept[30 * w + k], kept[31 * w + k], kept[32 * w + k] = v33, v34, v54
        kept[33 * w + k], kept[34 * w + k], kept[35 * w + k] = v55, v56, v65
        kept[36 * w + k], kept[37 * w + k], kept[38 * w + k] = v66, v67, v76
        kept[39 * w + k], kept[40 * w + k], turns[0 * w + k] = v77, v78, given1
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = given1, -v4, -v2
    for k in range(0 * w, 1 * w):
        turns[k] = math.sin(turns[k])
    for k in range(1 * w, 2 * w):
        turns[k] = math.cos(turns[k])
    for k in range(2 * w, 3 * w):
        turns[k] = _atan2(turns[k], turns[k + 1 * w])
    for k in range(w):
        T11, T12, T13 = kept[0 * w + k], kept[1 * w + k], kept[2 * w + k]
        T21, T22, T23 = kept[4 * w + k], kept[5 * w + k], kept[6 * w + k]
        T31, T32, T33 = kept[8 * w + k], kept[9 * w + k], kept[10 * w + k]
        given1, wx, wy = kept[16 * w + k], kept[18 * w + k], kept[19 * w + k]
        Z1_2, D4_squared, w4 = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v3, v5, N1 = kept[23 * w + k], kept[24 * w + k], kept[25 * w + k]
        inverse1, X2_2, v20 = kept[26 * w + k], kept[27 * w + k], kept[28 * w + k]
        v32, v33, v34 = kept[29 * w + k], kept[30 * w + k], kept[31 * w + k]
        v54, v55, v56 = kept[32 * w + k], kept[33 * w + k], kept[34 * w + k]
        v65, v66, v67 = kept[35 * w + k], kept[36 * w + k], kept[37 * w + k]
        v76, v77, v78 = kept[38 * w + k], kept[39 * w + k], kept[40 * w + k]
        s3, c3, angle17 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]

        # theta1, type 2: U1 A7^-1 [3, 4]
        Z1 = d5 * (s3 * v5)
        D1_squared = N1 - Z1 * Z1
        w1 = math.sqrt(D1_squared)
        v6, v7, v8 = w1 - w1, -wx * Z1, wy * Z1
        v9, v10, v11 = w1 * (-wx * inverse1), w1 * (wx * inverse1), inverse1 * v8
        c1_pp, c1_pm, v12 = v11 - v9, v11 - v10, v9 + v11
        v13, v14, v15 = v10 + v11, w1 * (wy * inverse1), w1 * (inverse1 * -wy)
        v16 = inverse1 * v7
        s1_pp, s1_pm, s1_mp = v14 + v16, v15 + v16, v14 - v16
        s1_mm = v15 - v16

        # theta2, type 3: U1 A7^-1 [2, 4] and U1 A7^-1 [1, 4]
        v17 = d5 * (c3 * v5)
        v18, v19 = Z1_2 * v17, w1 * X2_2
        S2_pp, S2_mp, v21 = v19 - v18, v18 + v19, w1 * v17
        v22, v23 = v20 + v21, v20 - v21
        v24 = v22 * v22
        v25, v26, v27 = S2_pp * S2_pp + v24, S2_mp * S2_mp + v23 * v23, v24 + -S2_pp * -S2_pp
        factor2_pp, factor2_pm = math.sqrt(v25) * (1.0 / v25), math.sqrt(v26) * (1.0 / v26)
        factor2_mm = math.sqrt(v27) * (1.0 / v27)

        # theta5, type 2: U5[3, 3]
        v28 = c3 * T13
        v29, v30 = v3 * v28, c3 * T23
        v31, v35 = v3 * v30, c3 * T33
        v36, v37 = v3 * v35, w1 * (inverse1 * (s3 * (T13 * wy + T23 * -wx)))
        v38 = T13 * v7 - T23 * v8
        v39, v40 = inverse1 * (s3 * v38), inverse1 * (s3 * -v38)
        v41, v42, v43 = v37 + v39, v39 - v37, v37 + v40
        v44 = v40 - v37
        X5_pp = (
            v3 * v41 + factor2_pp * (v22 * (v32 - (c1_pp * v29 + s1_pp * v31)) + S2_pp * (v36 +
            (c1_pp * v33 + s1_pp * v34)))
        )
        X5_pm = (
            v3 * v42 + factor2_pm * (v23 * (v32 - (c1_pm * v29 + s1_pm * v31)) - S2_mp * (v36 +
            (c1_pm * v33 + s1_pm * v34)))
        )
        X5_mp = (
            v3 * v43 + factor2_pm * (S2_mp * (v36 + (v12 * v33 - s1_mp * v34)) - v23 * (v32 + (s1_mp
            * v31 - v12 * v29)))
        )
        X5_mm = (
            v3 * v44 + factor2_mm * (-S2_pp * (v36 + (v13 * v33 - s1_mm * v34)) - v22 * (v32 +
            (s1_mm * v31 - v13 * v29)))
        )
        v45 = s3 * T33
        Y5_pp = (
            factor2_pp * (S2_pp * v45 - v22 * (s3 * (T13 * c1_pp + T23 * s1_pp))) - c3 * (T13 *
            s1_pp - T23 * c1_pp)
        )
        v46 = S2_mp * v45
        v47 = (
            factor2_pm * (v46 + v23 * (s3 * (T13 * c1_pm + T23 * s1_pm))) + c3 * (T13 * s1_pm - T23
            * c1_pm)
        )
        Y5_mp = (
            factor2_pm * (v46 - v23 * (s3 * (T23 * s1_mp - T13 * v12))) - c3 * (T13 * s1_mp + T23 *
            v12)
        )
        Y5_mm = (
            factor2_mm * (-S2_pp * v45 - v22 * (s3 * (T23 * s1_mm - T13 * v13))) - c3 * (T13 * s1_mm
            + T23 * v13)
        )
        v48, v49 = X5_pp * X5_pp + Y5_pp * Y5_pp, X5_pm * X5_pm + v47 * v47
        v50, v51 = X5_mp * X5_mp + Y5_mp * Y5_mp, X5_mm * X5_mm + Y5_mm * Y5_mm

        # theta6, type 3: U5[2, 3] and U5[1, 3]
        v52, v53, v57 = v5 * v28, v5 * v30, v5 * v35

        # theta7, type 3: U5[3, 2] and U5[3, 1]
        v58, v59, v60 = s3 * T32, s1_pp * T12 - c1_pp * T22, s1_pm * T12 - c1_pm * T22
        v61, v62, v63 = s1_mp * T12 + v12 * T22, s1_mm * T12 + v13 * T22, v3 * (c3 * T12)
        v64, v68, v69 = v3 * (c3 * T22), v3 * (c3 * T32), s3 * T31
        v70, v71 = s1_pp * T11 - c1_pp * T21, s1_pm * T11 - c1_pm * T21
        v72, v73, v74 = s1_mp * T11 + v12 * T21, s1_mm * T11 + v13 * T21, v3 * (c3 * T11)
        v75, v79, v80 = v3 * (c3 * T21), v3 * (c3 * T31), S2_mp * v69
        v81 = (
            v47 * (v3 * (s3 * v71) + factor2_pm * (v23 * (v76 - (c1_pm * v74 + s1_pm * v75)) - S2_mp
            * (v79 + (c1_pm * v77 + s1_pm * v78)))) - X5_pm * (c3 * v71 + factor2_pm * (v80 + v23 *
            (s3 * (c1_pm * T11 + s1_pm * T21))))
        )
        v82 = S2_mp * v58

        # joint values
        v91, v92 = angle17 - offset4, offset4 + angle17
        q4__p = v91 + (turn if v91 <= -half_turn else 0.0)
        q4__m = (turn if -v92 <= -half_turn else 0.0) - v92
        v101, v102, q3_ppp = abs(q4__p) - high4, abs(q4__m) - high4, v6 + (given1 + (w4 - w4))
        q4_ppp, q4_mpp = v6 + q4__p, v6 + q4__m

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[17 * w + k] = (
            1.0 if N1 <= doubt_limit_squared2 or abs(D4_squared) <= m1 or abs(D1_squared * (k3 *
            w4)) <= m2 * (merge_slack1 + 2.0 * abs(Z1)) or v51 <= m4 or v27 <= m3 or v50 <= m4 or
            v49 <= m4 or v26 <= m3 or v48 <= m4 or 0.0 < abs(given1) - high3 or v25 <= m3 else
            kept[17 * w + k]
        )
        kept[41 * w + k], kept[42 * w + k], kept[43 * w + k] = c1_pp, v12, v13
        kept[44 * w + k], kept[45 * w + k], kept[46 * w + k] = s1_pp, s1_mp, s1_mm
        kept[47 * w + k], kept[48 * w + k], kept[49 * w + k] = S2_pp, S2_mp, v22
        kept[50 * w + k], kept[51 * w + k], kept[52 * w + k] = v23, factor2_pp, factor2_pm
        kept[53 * w + k], kept[54 * w + k], kept[55 * w + k] = factor2_mm, X5_pp, X5_mp
        kept[56 * w + k], kept[57 * w + k], kept[58 * w + k] = X5_mm, Y5_pp, v47
        kept[59 * w + k], kept[60 * w + k], kept[61 * w + k] = Y5_mp, Y5_mm, v69
        kept[62 * w + k], kept[63 * w + k], kept[64 * w + k] = v70, v72, v73
        kept[65 * w + k], kept[66 * w + k], kept[67 * w + k] = v74, v75, v79
        kept[68 * w + k], kept[69 * w + k], kept[70 * w + k] = v80, v81, v101
        kept[71 * w + k], kept[72 * w + k], kept[73 * w + k] = v102, q3_ppp, q4_ppp
        kept[74 * w + k], turns[4 * w + k], turns[5 * w + k] = q4_mpp, Y5_pp, -v47
        turns[6 * w + k], turns[7 * w + k] = Y5_mp, Y5_mm
        turns[8 * w + k] = (
            -(X5_pp * (c3 * v70 - factor2_pp * (S2_pp * v69 - v22 * (s3 * (c1_pp * T11 + s1_pp *
            T21)))) + Y5_pp * (v3 * (s3 * v70) + factor2_pp * (v22 * (v76 - (c1_pp * v74 + s1_pp *
            v75)) + S2_pp * (v79 + (c1_pp * v77 + s1_pp * v78)))))
        )
        turns[9 * w + k] = v81
        turns[10 * w + k] = (
            -(X5_mp * (c3 * v72 - factor2_pm * (v80 - v23 * (s3 * (s1_mp * T21 - v12 * T11)))) +
            Y5_mp * (v3 * (s3 * v72) + factor2_pm * (S2_mp * (v79 + (v12 * v77 - s1_mp * v78)) - v23
            * (v76 + (s1_mp * v75 - v12 * v74)))))
        )
        turns[11 * w + k] = (
            -(X5_mm * (c3 * v73 - factor2_mm * (-S2_pp * v69 - v22 * (s3 * (s1_mm * T21 - v13 *
            T11)))) + Y5_mm * (v3 * (s3 * v73) + factor2_mm * (-S2_pp * (v79 + (v13 * v77 - s1_mm *
            v78)) - v22 * (v76 + (s1_mm * v75 - v13 * v74)))))
        )
        turns[12 * w + k], turns[13 * w + k], turns[14 * w + k] = s1_pp, s1_pm, s1_mp
        turns[15 * w + k], turns[16 * w + k], turns[17 * w + k] = s1_mm, S2_pp, -S2_mp
        turns[18 * w + k], turns[19 * w + k], turns[20 * w + k] = S2_mp, -S2_pp, math.sqrt(v48)
        turns[21 * w + k], turns[22 * w + k] = math.sqrt(v49), math.sqrt(v50)
        turns[23 * w + k], turns[28 * w + k], turns[29 * w + k] = math.sqrt(v51), -X5_pp, -X5_pm
        turns[30 * w + k], turns[31 * w + k] = -X5_mp, -X5_mm
        turns[32 * w + k] = (
            -(X5_pp * (c3 * v59 - factor2_pp * (S2_pp * v58 - v22 * (s3 * (c1_pp * T12 + s1_pp *
            T22)))) + Y5_pp * (v3 * (s3 * v59) + factor2_pp * (v22 * (v65 - (c1_pp * v63 + s1_pp *
            v64)) + S2_pp * (v68 + (c1_pp * v66 + s1_pp * v67)))))
        )
        turns[33 * w + k] = (
            v47 * (v3 * (s3 * v60) + factor2_pm * (v23 * (v65 - (c1_pm * v63 + s1_pm * v64)) - S2_mp
            * (v68 + (c1_pm * v66 + s1_pm * v67)))) - X5_pm * (c3 * v60 + factor2_pm * (v82 + v23 *
            (s3 * (c1_pm * T12 + s1_pm * T22))))
        )
        turns[34 * w + k] = (
            -(X5_mp * (c3 * v61 - factor2_pm * (v82 - v23 * (s3 * (s1_mp * T22 - v12 * T12)))) +
            Y5_mp * (v3 * (s3 * v61) + factor2_pm * (S2_mp * (v68 + (v12 * v66 - s1_mp * v67)) - v23
            * (v65 + (s1_mp * v64 - v12 * v63)))))
        )
        turns[35 * w + k] = (
            -(X5_mm * (c3 * v62 - factor2_mm * (-S2_pp * v58 - v22 * (s3 * (s1_mm * T22 - v13 *
            T12)))) + Y5_mm * (v3 * (s3 * v62) + factor2_mm * (-S2_pp * (v68 + (v13 * v66 - s1_mm *
            v67)) - v22 * (v65 + (s1_mm * v64 - v13 * v63)))))
        )
        turns[36 * w + k], turns[37 * w + k], turns[38 * w + k] = c1_pp, c1_pm, -v12
        turns[39 * w + k], turns[40 * w + k], turns[41 * w + k] = -v13, -v22, -v23
        turns[42 * w + k], turns[43 * w + k] = -v23, -v22
        turns[44 * w + k] = (
            v5 * v41 - factor2_pp * (S2_pp * (c1_pp * v55 + s1_pp * v56 - v57) + v22 * (v54 + (c1_pp
            * v52 + s1_pp * v53)))
        )
        turns[45 * w + k] = (
            v5 * v42 - factor2_pm * (v23 * (v54 + (c1_pm * v52 + s1_pm * v53)) - S2_mp * (c1_pm *
            v55 + s1_pm * v56 - v57))
        )
        turns[46 * w + k] = (
            -(v5 * v43 + factor2_pm * (S2_mp * (v57 + (s1_mp * v56 - v12 * v55)) + v23 * (v54 + (v12
            * v52 - s1_mp * v53))))
        )
        turns[47 * w + k] = (
            -(v5 * v44 + factor2_mm * (-S2_pp * (v57 + (s1_mm * v56 - v13 * v55)) + v22 * (v54 +
            (v13 * v52 - s1_mm * v53))))
        )
    if w == 1 and kept[17] != 0.0:
        return
    end = 28 if w == 1 else 24 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(24 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(4 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        T11, T21, v3 = kept[0 * w + k], kept[4 * w + k], kept[23 * w + k]
        v76, v77, v78 = kept[38 * w + k], kept[39 * w + k], kept[40 * w + k]
        s3, c3, c1_pp = turns[0 * w + k], turns[1 * w + k], kept[41 * w + k]
        v12, v13, s1_pp = kept[42 * w + k], kept[43 * w + k], kept[44 * w + k]
        s1_mp, s1_mm, S2_pp = kept[45 * w + k], kept[46 * w + k], kept[47 * w + k]
        S2_mp, v22, v23 = kept[48 * w + k], kept[49 * w + k], kept[50 * w + k]
        factor2_pp, factor2_pm, factor2_mm = kept[51 * w + k], kept[52 * w + k], kept[53 * w + k]
        X5_pp, X5_mp, X5_mm = kept[54 * w + k], kept[55 * w + k], kept[56 * w + k]
        Y5_pp, v47, Y5_mp = kept[57 * w + k], kept[58 * w + k], kept[59 * w + k]
        Y5_mm, v69, v70 = kept[60 * w + k], kept[61 * w + k], kept[62 * w + k]
        v72, v73, v74 = kept[63 * w + k], kept[64 * w + k], kept[65 * w + k]
        v75, v79, v80 = kept[66 * w + k], kept[67 * w + k], kept[68 * w + k]
        v81, v101, v102 = kept[69 * w + k], kept[70 * w + k], kept[71 * w + k]
        q3_ppp, q4_ppp, q4_mpp = kept[72 * w + k], kept[73 * w + k], kept[74 * w + k]
        angle1, angle2, angle3 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle4, angle5, angle6 = turns[7 * w + k], turns[8 * w + k], turns[9 * w + k]
        angle7, angle8, angle9 = turns[10 * w + k], turns[11 * w + k], turns[12 * w + k]
        angle10, angle11, angle12 = turns[13 * w + k], turns[14 * w + k], turns[15 * w + k]
        angle13, angle14, angle15 = turns[16 * w + k], turns[17 * w + k], turns[18 * w + k]
        angle16, angle18, angle19 = turns[19 * w + k], turns[20 * w + k], turns[21 * w + k]
        angle20, angle21 = turns[22 * w + k], turns[23 * w + k]

        # theta5, type 2: U5[3, 3]
        q5_ppm = angle1 - math.copysign(half_turn, Y5_pp)
        q5_pmm = angle2 - math.copysign(half_turn, -v47)
        q5_mpm = angle3 - math.copysign(half_turn, Y5_mp)
        q5_mmm = angle4 - math.copysign(half_turn, Y5_mm)

        # theta7, type 3: U5[3, 2] and U5[3, 1]
        q7_ppm = (
            angle5 - math.copysign(half_turn, -(X5_pp * (c3 * v70 - factor2_pp * (S2_pp * v69 - v22
            * (s3 * (c1_pp * T11 + s1_pp * T21)))) + Y5_pp * (v3 * (s3 * v70) + factor2_pp * (v22 *
            (v76 - (c1_pp * v74 + s1_pp * v75)) + S2_pp * (v79 + (c1_pp * v77 + s1_pp * v78))))))
        )
        q7_pmm = angle6 - math.copysign(half_turn, v81)
        q7_mpm = (
            angle7 - math.copysign(half_turn, -(X5_mp * (c3 * v72 - factor2_pm * (v80 - v23 * (s3 *
            (s1_mp * T21 - v12 * T11)))) + Y5_mp * (v3 * (s3 * v72) + factor2_pm * (S2_mp * (v79 +
            (v12 * v77 - s1_mp * v78)) - v23 * (v76 + (s1_mp * v75 - v12 * v74))))))
        )
        q7_mmm = (
            angle8 - math.copysign(half_turn, -(X5_mm * (c3 * v73 - factor2_mm * (-S2_pp * v69 - v22
            * (s3 * (s1_mm * T21 - v13 * T11)))) + Y5_mm * (v3 * (s3 * v73) + factor2_mm * (-S2_pp *
            (v79 + (v13 * v77 - s1_mm * v78)) - v22 * (v76 + (s1_mm * v75 - v13 * v74))))))
        )

        # joint values
        v83, v84, v85 = angle9 - offset1, angle10 - offset1, angle11 - offset1
        v86 = angle12 - offset1
        q1_ppp = v83 + (turn if v83 <= -half_turn else 0.0)
        q1_pmp = v84 + (turn if v84 <= -half_turn else 0.0)
        q1_mpp = v85 + (turn if v85 <= -half_turn else 0.0)
        q1_mmp = v86 + (turn if v86 <= -half_turn else 0.0)
        v87, v88, v89 = angle13 - offset2, angle14 - offset2, angle15 - offset2
        v90 = angle16 - offset2
        q2_ppp = v87 + (turn if v87 <= -half_turn else 0.0)
        q2_pmp = v88 + (turn if v88 <= -half_turn else 0.0)
        q2_mpp = v89 + (turn if v89 <= -half_turn else 0.0)
        q2_mmp = v90 + (turn if v90 <= -half_turn else 0.0)
        v93, v94, v95 = angle18 - offset6, offset6 + angle18, angle19 - offset6
        v96, v97, v98 = offset6 + angle19, angle20 - offset6, offset6 + angle20
        v99, v100 = angle21 - offset6, offset6 + angle21
        q6_ppp = v93 + (turn if v93 <= -half_turn else 0.0)
        q6_ppm = (turn if -v94 <= -half_turn else 0.0) - v94
        q6_pmp = v95 + (turn if v95 <= -half_turn else 0.0)
        q6_pmm = (turn if -v96 <= -half_turn else 0.0) - v96
        q6_mpp = v97 + (turn if v97 <= -half_turn else 0.0)
        q6_mpm = (turn if -v98 <= -half_turn else 0.0) - v98
        q6_mmp = v99 + (turn if v99 <= -half_turn else 0.0)
        q6_mmm = (turn if -v100 <= -half_turn else 0.0) - v100
        v103 = max(abs(q2_ppp) - high2, max(v101, abs(q1_ppp) - high1))
        v104 = max(abs(q2_pmp) - high2, max(v101, abs(q1_pmp) - high1))
        v105 = max(abs(q2_mpp) - high2, max(v102, abs(q1_mpp) - high1))
        v106 = max(abs(q2_mmp) - high2, max(v102, abs(q1_mmp) - high1))
        excess_ppp = (
            max(abs(angle5) - high7, max(abs(q6_ppp) - high6, max(v103, abs(angle1) - high5)))
        )
        excess_ppm = (
            max(abs(q7_ppm) - high7, max(abs(q6_ppm) - high6, max(v103, abs(q5_ppm) - high5)))
        )
        excess_pmp = (
            max(abs(angle6) - high7, max(abs(q6_pmp) - high6, max(v104, abs(angle2) - high5)))
        )
        excess_pmm = (
            max(abs(q7_pmm) - high7, max(abs(q6_pmm) - high6, max(v104, abs(q5_pmm) - high5)))
        )
        excess_mpp = (
            max(abs(angle7) - high7, max(abs(q6_mpp) - high6, max(v105, abs(angle3) - high5)))
        )
        excess_mpm = (
            max(abs(q7_mpm) - high7, max(abs(q6_mpm) - high6, max(v105, abs(q5_mpm) - high5)))
        )
        excess_mmp = (
            max(abs(angle8) - high7, max(abs(q6_mmp) - high6, max(v106, abs(angle4) - high5)))
        )
        excess_mmm = (
            max(abs(q7_mmm) - high7, max(abs(q6_mmm) - high6, max(v106, abs(q5_mmm) - high5)))
        )
        outside_ppp, outside_ppm, outside_pmp = 0.0 < excess_ppp, 0.0 < excess_ppm, 0.0 < excess_pmp
        outside_pmm, outside_mpp, outside_mpm = 0.0 < excess_pmm, 0.0 < excess_mpp, 0.0 < excess_mpm
        outside_mmp, outside_mmm = 0.0 < excess_mmp, 0.0 < excess_mmm

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[17 * w + k] = (
            1.0 if abs(excess_mmm - limit_slack) <= limit_slack or abs(excess_mmp - limit_slack) <=
            limit_slack or abs(excess_mpm - limit_slack) <= limit_slack or abs(excess_mpp -
            limit_slack) <= limit_slack or abs(excess_pmm - limit_slack) <= limit_slack or
            abs(excess_pmp - limit_slack) <= limit_slack or abs(excess_ppp - limit_slack) <=
            limit_slack or abs(excess_ppm - limit_slack) <= limit_slack else kept[17 * w + k]
        )

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, q2_ppp, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_ppp, angle1, q6_ppp
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = angle5, q5_ppm, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q7_ppm, q1_pmp, q2_pmp
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = angle2, q6_pmp, angle6
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q5_pmm, q6_pmm, q7_pmm
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q1_mpp, q2_mpp, q4_mpp
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = angle3, q6_mpp, angle7
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q5_mpm, q6_mpm, q7_mpm
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q1_mmp, q2_mmp, angle4
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = q6_mmp, angle8, q5_mmm
        rows[33 * w + k], rows[34 * w + k] = q6_mmm, q7_mmm
        rows[35 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_ppp else OK)
        )
        rows[36 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_ppm else OK)
        )
        rows[37 * w + k] = (
            UNREACHABLE if q1_pmp != q1_pmp else (OUT_OF_LIMITS if outside_pmp else OK)
        )
        rows[38 * w + k] = (
            UNREACHABLE if q1_pmp != q1_pmp else (OUT_OF_LIMITS if outside_pmm else OK)
        )
        rows[39 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mpp else OK)
        )
        rows[40 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mpm else OK)
        )
        rows[41 * w + k] = (
            UNREACHABLE if q1_mmp != q1_mmp else (OUT_OF_LIMITS if outside_mmp else OK)
        )
        rows[42 * w + k] = (
            UNREACHABLE if q1_mmp != q1_mmp else (OUT_OF_LIMITS if outside_mmm else OK)
        )


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 75, 52, [
    [0, 1, 2, 3, 4, 5, 6], [0, 1, 2, 3, 7, 8, 9], [10, 11, 2, 3, 12, 13, 14],
    [10, 11, 2, 3, 15, 16, 17], [18, 19, 2, 20, 21, 22, 23], [18, 19, 2, 20, 24, 25, 26],
    [27, 28, 2, 20, 29, 30, 31], [27, 28, 2, 20, 32, 33, 34],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS, given=1))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
