# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: d4722574f6bbef95
"""kuka_iiwa14_arm_angle: KUKA LBR iiwa 14 R820, arm angle given.

Inverse kinematics, generated from robots/kuka_iiwa14_arm_angle.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kuka_iiwa14_arm_angle.yaml. The formulas and where they come from:
kuka_iiwa14_arm_angle.md.

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

NAME = "kuka_iiwa14_arm_angle"
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
    "elbow+-back-noflip", "elbow+-back-flip", "elbow+-front-noflip", "elbow+-front-flip",
    "elbow--back-noflip", "elbow--back-flip", "elbow--front-noflip", "elbow--front-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit = 9.999999999999999e-05.
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
free_limit = 1e-12  # a length that fixes no angle
solved_limit = 8.993529828991507e-08  # the same of a solution, whose pose is rounded [m^2]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
offset2 = 3.141592653589793  # offset of joint 2 [rad]
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset6 = 3.141592653589793  # offset of joint 6 [rad]
k1 = 0.336  # 2 * d5 * d3 [m^2]
k2 = 0.33640000000000003  # d3^2 + d5^2 [m^2]
k3 = 8.857709750566894  # 1 / (k1^2) [m^-4]
straight_limit = 9.271680236073719e-08  # a stretched arm: its elbow is on either side [m^2]
high1 = 2.9670597293903604  # highest value of joint 1, with what rounding adds [rad]
high2 = 2.0943951033931953  # highest value of joint 2, with what rounding adds [rad]
high3 = 2.9670597293903604  # highest value of joint 3, with what rounding adds [rad]
high4 = 2.0943951033931953  # highest value of joint 4, with what rounding adds [rad]
high5 = 2.9670597293903604  # highest value of joint 5, with what rounding adds [rad]
high6 = 2.0943951033931953  # highest value of joint 6, with what rounding adds [rad]
high7 = 3.054326191990077  # highest value of joint 7, with what rounding adds [rad]
# 1000 * (longest4 - longest4_apart) * (longest4_apart - shortest4) [m^4]
m1 = 1.4473755527432779e-11
m2 = 1e-24  # free_limit^2
m3 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.7657, 0.7657, 0.7657, 1.0, 1.0, 1.0), size=1.306, steps=("keeps limits",),
    choosable=(4, 0),
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


@_of_joints
def arm_angle(q):
    """The arm angle of the joint values q (7,), in (-pi, pi].

    It turns the elbow about the line from shoulder to wrist; zero is where the elbow leans
    towards the direction of axis 1.
    """
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, x2_y, z2_x = c1 * c2, s1 * c2, c1 * s2
    z2_y = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    z3_y, z3_z, p3_x = c1 * c3 + x2_y * s3, s2 * s3, z2_x * d3
    p3_y, p3_z, z3_x = z2_y * d3, d1 - c2 * d3, x2_x * s3 - s1 * c3
    v3 = q[3] + offset4
    c4, s4 = math.cos(v3), math.sin(v3)
    p5_x = p3_x + ((x2_x * c3 + s1 * s3) * s4 - z2_x * c4) * d5
    p5_y, v4 = p3_y + ((x2_y * c3 - c1 * s3) * s4 - z2_y * c4) * d5, p3_z - d1
    v5 = p3_x * z3_x + z3_y * p3_y + z3_z * v4
    v6, v7, v8 = p3_x - z3_x * v5, p3_y - z3_y * v5, v4 - z3_z * v5
    v9 = p3_z + (c2 * c4 + s2 * c3 * s4) * d5 - d1
    v10 = (
        -1.0 if z3_x * (p5_y * v8 - v7 * v9) + z3_y * (v6 * v9 - p5_x * v8) + z3_z * (p5_x * v7 -
        p5_y * v6) < -straight_limit else 1.0
    )
    v11, v12, v13 = z3_x * v10, z3_y * v10, z3_z * v10
    v14 = p5_x * p5_x + p5_y * p5_y
    v15 = math.sqrt(v14 + v9 * v9)
    v16 = math.sqrt(v14) <= v15 * free_limit
    v17 = 0.0 if v16 else p5_y
    v18 = 1.0 if v16 else -p5_x
    v19, v20 = v9 * v12 - p5_y * v13, p5_x * v13 - v9 * v11
    psi = (
        _atan2(v15 * (v17 * v19 + v18 * v20), v9 * v18 * v19 - v9 * v17 * v20 + (p5_y * v17 - p5_x *
        v18) * (p5_y * v11 - p5_x * v12))
    )
    return psi


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta4, type 2: the squared length of column 4 of U1 A7^-1
    wx = T14 - T13 * d7
    wy = T24 - d7 * T23
    wz = T34 - d7 * T33
    v1 = wz - d1
    V4 = wx * wx + wy * wy + v1 * v1
    Z4 = V4 - k2
    D4_squared = (longest4 - V4) * (V4 - shortest4)
    apart4 = shortest4_apart < V4 and V4 < longest4_apart
    if not (shortest4_reach <= V4 and V4 <= longest4_reach):
        return  # out of reach
    w4 = math.sqrt(D4_squared if apart4 else 0.0)
    v2 = k3 * (k1 * Z4)

    # shoulder, its rotation, from the arm angle and theta4
    reach = math.sqrt(V4)
    v4 = 1.0 / reach
    gx = wx * v4
    gy = wy * v4
    gz = v1 * v4
    lean = math.sqrt(gy * gy + gx * gx)
    upright = lean <= free_limit
    v5 = 1.0 / (1.0 if upright else lean)
    v6 = 0.0 if upright else gy * v5
    v7 = 1.0 if upright else -(gx * v5)
    v8, v9 = gz * v7, gz * v6
    cos_psi = math.cos(q_free[0])
    sin_psi = math.sin(q_free[0])
    uz = (gy * v6 - gx * v7) * cos_psi
    ux = v8 * cos_psi + v6 * sin_psi
    uy = v7 * sin_psi - v9 * cos_psi
    nx = v6 * cos_psi - v8 * sin_psi
    ny = v7 * cos_psi + v9 * sin_psi
    v11 = d3 + d5 * v2
    v12 = v11 * v11

    # theta1, type 2: B1[3, 2]
    v20 = seed[0] + offset1

    for i1 in range(2):  # elbow+, elbow-
        e4 = 1.0 - 2.0 * i1
        # theta4
        if e4 < 0.0 and not apart4:
            continue  # both signs give the same
        v3 = k3 * (k1 * (w4 * e4))

        # shoulder
        v10 = d5 * v3
        arm_ = math.sqrt(v10 * v10 + v12)
        v13 = 1.0 / arm_
        v14, v15 = v10 * v13, v11 * v13
        side = -1.0 if -(d5 * (d3 * v3)) < -solved_limit else 1.0
        v16, v17 = v15 * side, v14 * side
        v18 = gx * v14 + ux * v16
        b13 = nx * side
        v19 = gy * v14 + uy * v16
        b22 = gy * v15 - uy * v17
        b23 = ny * side

        # theta1
        X1 = ux * v17 - gx * v15
        w1 = math.sqrt(X1 * X1 + b22 * b22)
        free1 = w1 <= free_limit
        divisor1 = 1.0 if free1 else w1

        # theta2, type 3: B1[2, 2] and B1[1, 2]
        c2 = uz * v17 - gz * v15

        # theta5, type 2: U5[3, 3]
        v24 = T33 * c2

        # theta7, type 3: U5[3, 2] and U5[3, 1]
        v30, v36 = T32 * c2, T31 * c2

        # joint values
        q4 = _wrap(_atan2(-v3, -v2) - offset4)

        for i2 in range(2):  # back, front
            e1 = 1.0 - 2.0 * i2
            # theta1
            if e1 < 0.0 and free1:
                continue  # both signs give the same
            factor1 = e1 / divisor1
            c1 = math.cos(v20) if free1 else -(X1 * factor1)
            s1 = math.sin(v20) if free1 else b22 * factor1
            s2 = w1 * e1

            # theta3, type 3: B1[3, 1] and B1[3, 3]
            s3, c3 = v19 * c1 - v18 * s1, b23 * c1 - b13 * s1
            q3 = _atan2(s3, c3)

            # theta5
            v21 = T13 * c1 + T23 * s1
            v22, v23, v25 = c2 * v21 + T33 * s2, T13 * s1 - T23 * c1, s2 * v21 - v24
            X5 = c3 * (v2 * v22) + s3 * (v2 * v23) + v3 * v25
            Y5 = c3 * -v23 + s3 * v22
            w5 = math.sqrt(X5 * X5 + Y5 * Y5)
            free5 = w5 <= free_limit
            divisor5 = 1.0 if free5 else w5

            # theta6, type 3: U5[2, 3] and U5[1, 3]
            c6 = c3 * (v3 * v22) + s3 * (v3 * v23) - v2 * v25

            # theta7
            v26, v27 = T12 * s1 - T22 * c1, T12 * c1 + T22 * s1
            v28 = c2 * v27 + T32 * s2
            v29 = c3 * -v26 + s3 * v28
            v31 = c3 * (v2 * v28) + s3 * (v2 * v26) + v3 * (s2 * v27 - v30)
            v32, v33 = T11 * s1 - T21 * c1, T11 * c1 + T21 * s1
            v34 = c2 * v33 + T31 * s2
            v35 = c3 * -v32 + s3 * v34
            v37 = c3 * (v2 * v34) + s3 * (v2 * v32) + v3 * (s2 * v33 - v36)

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
                q7 = _atan2(-(c5 * v35 + s5 * v37), -(c5 * v29 + s5 * v31))

                # joint values
                q6 = _wrap(_atan2(s6, c6) - offset6)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
                q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
                q[row, 6] = q7
                status[row] = FREE_JOINT if free1 or free5 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T13, T14, T23 = kept[2 * w + k], kept[3 * w + k], kept[6 * w + k]
        T24, T31, T32 = kept[7 * w + k], kept[8 * w + k], kept[9 * w + k]
        T33, T34, given1 = kept[10 * w + k], kept[11 * w + k], kept[16 * w + k]

        # theta4, type 2: the squared length of column 4 of U1 A7^-1
        wx, wy, v1 = T14 - d7 * T13, T24 - d7 * T23, T34 - d7 * T33 - d1
        V4 = wx * wx + wy * wy + v1 * v1
        D4_squared, v2 = (longest4 - V4) * (V4 - shortest4), k1 * (V4 - k2)
        v3, v4 = k3 * v2, k1 * math.sqrt(D4_squared)
        v5 = k3 * v4

        # shoulder, its rotation, from the arm angle and theta4
        v6 = math.sqrt(V4) * (1.0 / V4)
        gx, gy, gz = wx * v6, wy * v6, v1 * v6
        v7 = gy * gy + gx * gx
        upright = v7 <= m2
        v8 = 1.0 / (1.0 if upright else math.sqrt(v7))
        v9 = 0.0 if upright else gy * v8
        v10 = 1.0 if upright else -(gx * v8)
        v11, v12, v13 = gz * v10, gz * v9, d5 * v5
        v14 = d3 + d5 * v3
        v15 = v14 * v14 + v13 * v13
        arm_, v16 = math.sqrt(v15), 1.0 / v15
        v17 = arm_ * v16
        v18, v19, v20 = v13 * v17, v14 * v17, d5 * (d3 * v5)
        side_p = -1.0 if -v20 < -solved_limit else 1.0
        side_m = -1.0 if v20 < -solved_limit else 1.0
        v21, v22, v23 = v19 * side_p, v19 * side_m, v18 * side_p
        v24, v25, v26 = v18 * side_m, gx * v18, gy * v18
        v27 = gy * v19

        # theta1, type 2: B1[3, 2]
        v28 = gx * v19

        # theta2, type 3: B1[2, 2] and B1[1, 2]
        v34 = gz * v19

        # theta5, type 2: U5[3, 3]
        v50, v51 = arm_ * (v16 * (gz * (T33 * v14))), T33 * v13

        # theta7, type 3: U5[3, 2] and U5[3, 1]
        v65, v72 = arm_ * (v16 * (gz * (v14 * T32))), arm_ * (v16 * (gz * (v14 * T31)))
        v73, v76 = v13 * T31, v13 * T32
        kept[18 * w + k], kept[19 * w + k], kept[20 * w + k] = D4_squared, v3, v5
        kept[21 * w + k], kept[22 * w + k], kept[23 * w + k] = gx, gy, v9
        kept[24 * w + k], kept[25 * w + k], kept[26 * w + k] = v10, v11, v12
        kept[27 * w + k], kept[28 * w + k], kept[29 * w + k] = arm_, v16, side_p
        kept[30 * w + k], kept[31 * w + k], kept[32 * w + k] = side_m, v21, v22
        kept[33 * w + k], kept[34 * w + k], kept[35 * w + k] = v23, v24, v25
        kept[36 * w + k], kept[37 * w + k], kept[38 * w + k] = v26, v27, v28
        kept[39 * w + k], kept[40 * w + k], kept[41 * w + k] = v34, v50, v51
        kept[42 * w + k], kept[43 * w + k], kept[44 * w + k] = v65, v72, v73
        kept[45 * w + k], turns[0 * w + k], turns[1 * w + k] = v76, given1, given1
        turns[2 * w + k], turns[3 * w + k] = -v4, -v2
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
        D4_squared, v3, v5 = kept[18 * w + k], kept[19 * w + k], kept[20 * w + k]
        gx, gy, v9 = kept[21 * w + k], kept[22 * w + k], kept[23 * w + k]
        v10, v11, v12 = kept[24 * w + k], kept[25 * w + k], kept[26 * w + k]
        arm_, v16, side_p = kept[27 * w + k], kept[28 * w + k], kept[29 * w + k]
        side_m, v21, v22 = kept[30 * w + k], kept[31 * w + k], kept[32 * w + k]
        v23, v24, v25 = kept[33 * w + k], kept[34 * w + k], kept[35 * w + k]
        v26, v27, v28 = kept[36 * w + k], kept[37 * w + k], kept[38 * w + k]
        v34, v50, v51 = kept[39 * w + k], kept[40 * w + k], kept[41 * w + k]
        v65, v72, v73 = kept[42 * w + k], kept[43 * w + k], kept[44 * w + k]
        v76, sin_psi, cos_psi = kept[45 * w + k], turns[0 * w + k], turns[1 * w + k]
        angle11 = turns[2 * w + k]

        # shoulder, its rotation, from the arm angle and theta4
        uz, ux = cos_psi * (gy * v9 - gx * v10), v11 * cos_psi + v9 * sin_psi
        uy, nx = v10 * sin_psi - v12 * cos_psi, v9 * cos_psi - v11 * sin_psi
        ny, b22_p, b22_m = v10 * cos_psi + v12 * sin_psi, v27 - uy * v23, v27 + uy * v24

        # theta1, type 2: B1[3, 2]
        X1_p, v29 = ux * v23 - v28, v28 + ux * v24
        v30, v31 = X1_p * X1_p + b22_p * b22_p, v29 * v29 + b22_m * b22_m
        w1_p, w1_m, v32 = math.sqrt(v30), math.sqrt(v31), 1.0 / v30
        v33 = 1.0 / v31

        # theta2, type 3: B1[2, 2] and B1[1, 2]
        c2_p, v35 = uz * v23 - v34, v34 + uz * v24

        # theta3, type 3: B1[3, 1] and B1[3, 3]
        v36 = v32 * (b22_p * (v25 + ux * v21) + X1_p * (v26 + uy * v21))
        v37, v38 = v33 * (b22_m * (ux * v22 - v25) - v29 * (uy * v22 - v26)), w1_p * v36
        v39, v40 = w1_m * v37, v32 * (b22_p * (nx * side_p) + X1_p * (ny * side_p))
        v41, v42 = v33 * (b22_m * (nx * side_m) - v29 * (ny * side_m)), w1_p * v40
        v43 = w1_m * v41

        # theta5, type 2: U5[3, 3]
        v44 = w1_p * (v32 * (T23 * b22_p - T13 * X1_p))
        v45, v46 = w1_m * (v33 * (T23 * b22_m + T13 * v29)), c2_p * v44 + T33 * w1_p
        v47, v48 = T33 * w1_m - v35 * v45, w1_p * (v32 * (T13 * b22_p + T23 * X1_p))
        v49 = w1_m * (v33 * (T13 * b22_m - T23 * v29))
        v52 = w1_p * v44 - (uz * (arm_ * (v16 * (side_p * v51))) - v50)
        v53 = w1_m * v45 + (v50 + uz * (arm_ * (v16 * (side_m * v51))))
        X5_p = v5 * v52 - (v42 * (v3 * v46) + v38 * (v3 * v48))
        v54, Y5_p = v5 * v53 + (v43 * (v3 * v47) + v39 * (v3 * v49)), v42 * v48 - v38 * v46
        Y5_m, v55 = v43 * v49 - v39 * v47, X5_p * X5_p + Y5_p * Y5_p
        v56, w5_p = v54 * v54 + Y5_m * Y5_m, math.sqrt(v55)
        w5_m, factor5_p = math.sqrt(v56), w5_p * (1.0 / v55)
        factor5_m, v57 = w5_m * (1.0 / v56), X5_p * factor5_p
        v58, s5_p, s5_m = v54 * factor5_m, Y5_p * factor5_p, Y5_m * factor5_m

        # theta7, type 3: U5[3, 2] and U5[3, 1]
        v59 = w1_p * (v32 * (b22_p * T12 + X1_p * T22))
        v60 = w1_m * (v33 * (b22_m * T12 - v29 * T22))
        v61 = w1_p * (v32 * (b22_p * T22 - X1_p * T12))
        v62, v63 = w1_m * (v33 * (b22_m * T22 + v29 * T12)), c2_p * v61 + w1_p * T32
        v64, v66 = w1_m * T32 - v35 * v62, w1_p * (v32 * (b22_p * T11 + X1_p * T21))
        v67 = w1_m * (v33 * (b22_m * T11 - v29 * T21))
        v68 = w1_p * (v32 * (b22_p * T21 - X1_p * T11))
        v69, v70 = w1_m * (v33 * (b22_m * T21 + v29 * T11)), c2_p * v68 + w1_p * T31
        v71 = w1_m * T31 - v35 * v69
        v74 = (
            v57 * (v42 * v66 - v38 * v70) - s5_p * (v5 * (w1_p * v68 - (uz * (arm_ * (v16 * (side_p
            * v73))) - v72)) - (v42 * (v3 * v70) + v38 * (v3 * v66)))
        )
        v75 = (
            s5_m * (v5 * (w1_m * v69 + (v72 + uz * (arm_ * (v16 * (side_m * v73))))) + (v43 * (v3 *
            v71) + v39 * (v3 * v67))) - v58 * (v43 * v67 - v39 * v71)
        )

        # joint values
        v85, v86 = angle11 - offset4, offset4 + angle11
        q4_ppp = v85 + (turn if v85 <= -half_turn else 0.0)
        q4_mpp = (turn if -v86 <= -half_turn else 0.0) - v86
        v91, v92 = abs(q4_ppp) - high4, abs(q4_mpp) - high4

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[17 * w + k] = (
            1.0 if v56 <= m3 or v31 <= m3 or v55 <= m3 or abs(D4_squared) <= m1 or v30 <= m3 else
            kept[17 * w + k]
        )
        kept[46 * w + k], kept[47 * w + k], kept[48 * w + k] = b22_p, b22_m, v36
        kept[49 * w + k], kept[50 * w + k], kept[51 * w + k] = v37, Y5_p, Y5_m
        kept[52 * w + k], kept[53 * w + k], kept[54 * w + k] = v74, v75, q4_ppp
        kept[55 * w + k], kept[56 * w + k], kept[57 * w + k] = q4_mpp, v91, v92
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = -v36, -v37, Y5_p
        turns[7 * w + k], turns[8 * w + k], turns[9 * w + k] = Y5_m, v74, v75
        turns[10 * w + k], turns[11 * w + k], turns[12 * w + k] = b22_p, b22_m, w1_p
        turns[13 * w + k], turns[14 * w + k], turns[15 * w + k] = w1_m, w5_p, w5_m
        turns[20 * w + k], turns[21 * w + k], turns[22 * w + k] = -v40, -v41, -X5_p
        turns[23 * w + k] = v54
        turns[24 * w + k] = (
            v57 * (v42 * v59 - v38 * v63) - s5_p * (v5 * (w1_p * v61 - (uz * (arm_ * (v16 * (side_p
            * v76))) - v65)) - (v42 * (v3 * v63) + v38 * (v3 * v59)))
        )
        turns[25 * w + k] = (
            s5_m * (v5 * (w1_m * v62 + (v65 + uz * (arm_ * (v16 * (side_m * v76))))) + (v43 * (v3 *
            v64) + v39 * (v3 * v60))) - v58 * (v43 * v60 - v39 * v64)
        )
        turns[26 * w + k], turns[27 * w + k], turns[28 * w + k] = -X1_p, v29, c2_p
        turns[29 * w + k] = -v35
        turns[30 * w + k] = -(v3 * v52 + (v42 * (v5 * v46) + v38 * (v5 * v48)))
        turns[31 * w + k] = v43 * (v5 * v47) + v39 * (v5 * v49) - v3 * v53
    if w == 1 and kept[17] != 0.0:
        return
    end = 20 if w == 1 else 16 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(16 * w, end):
        turns[k] = turns[k + 16 * w] = 1.0
    for k in range(4 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 16 * w])
    for k in range(w):
        b22_p, b22_m, v36 = kept[46 * w + k], kept[47 * w + k], kept[48 * w + k]
        v37, Y5_p, Y5_m = kept[49 * w + k], kept[50 * w + k], kept[51 * w + k]
        v74, v75, q4_ppp = kept[52 * w + k], kept[53 * w + k], kept[54 * w + k]
        q4_mpp, v91, v92 = kept[55 * w + k], kept[56 * w + k], kept[57 * w + k]
        angle1, angle2, angle3 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle4, angle5, angle6 = turns[7 * w + k], turns[8 * w + k], turns[9 * w + k]
        angle7, angle8, angle9 = turns[10 * w + k], turns[11 * w + k], turns[12 * w + k]
        angle10, angle12, angle13 = turns[13 * w + k], turns[14 * w + k], turns[15 * w + k]

        # theta3, type 3: B1[3, 1] and B1[3, 3]
        q3_pmp = angle1 - math.copysign(half_turn, -v36)
        q3_mmp = angle2 - math.copysign(half_turn, -v37)

        # theta5, type 2: U5[3, 3]
        q5_ppm = angle3 - math.copysign(half_turn, Y5_p)
        q5_mpm = angle4 - math.copysign(half_turn, Y5_m)

        # theta7, type 3: U5[3, 2] and U5[3, 1]
        q7_ppm = angle5 - math.copysign(half_turn, v74)
        q7_mpm = angle6 - math.copysign(half_turn, v75)

        # joint values
        v77, v78 = angle7 - offset1, angle7 - math.copysign(half_turn, b22_p) - offset1
        v79, v80 = angle8 - offset1, angle8 - math.copysign(half_turn, b22_m) - offset1
        q1_ppp = v77 + (turn if v77 <= -half_turn else 0.0)
        q1_pmp = v78 + (turn if v78 <= -half_turn else 0.0)
        q1_mpp = v79 + (turn if v79 <= -half_turn else 0.0)
        q1_mmp = v80 + (turn if v80 <= -half_turn else 0.0)
        v81, v82, v83 = angle9 - offset2, offset2 + angle9, angle10 - offset2
        v84 = offset2 + angle10
        q2_ppp = v81 + (turn if v81 <= -half_turn else 0.0)
        q2_pmp = (turn if -v82 <= -half_turn else 0.0) - v82
        q2_mpp = v83 + (turn if v83 <= -half_turn else 0.0)
        q2_mmp = (turn if -v84 <= -half_turn else 0.0) - v84
        v87, v88, v89 = angle12 - offset6, offset6 + angle12, angle13 - offset6
        v90 = offset6 + angle13
        q6_ppp = v87 + (turn if v87 <= -half_turn else 0.0)
        q6_ppm = (turn if -v88 <= -half_turn else 0.0) - v88
        q6_mpp = v89 + (turn if v89 <= -half_turn else 0.0)
        q6_mpm = (turn if -v90 <= -half_turn else 0.0) - v90
        v93, v94, v95 = abs(angle3) - high5, abs(q5_ppm) - high5, abs(angle4) - high5
        v96, v97, v98 = abs(q5_mpm) - high5, abs(q6_ppp) - high6, abs(q6_ppm) - high6
        v99, v100, v101 = abs(q6_mpp) - high6, abs(q6_mpm) - high6, abs(angle5) - high7
        v102, v103, v104 = abs(q7_ppm) - high7, abs(angle6) - high7, abs(q7_mpm) - high7
        v105 = max(abs(angle1) - high3, max(abs(q2_ppp) - high2, max(v91, abs(q1_ppp) - high1)))
        v106 = max(abs(q3_pmp) - high3, max(abs(q2_pmp) - high2, max(v91, abs(q1_pmp) - high1)))
        v107 = max(abs(angle2) - high3, max(abs(q2_mpp) - high2, max(v92, abs(q1_mpp) - high1)))
        v108 = max(abs(q3_mmp) - high3, max(abs(q2_mmp) - high2, max(v92, abs(q1_mmp) - high1)))
        outside_ppp = 0.0 < max(v101, max(v97, max(v93, v105)))
        outside_ppm = 0.0 < max(v102, max(v98, max(v94, v105)))
        outside_pmp = 0.0 < max(v101, max(v97, max(v93, v106)))
        outside_pmm = 0.0 < max(v102, max(v98, max(v94, v106)))
        outside_mpp = 0.0 < max(v103, max(v99, max(v95, v107)))
        outside_mpm = 0.0 < max(v104, max(v100, max(v96, v107)))
        outside_mmp = 0.0 < max(v103, max(v99, max(v95, v108)))
        outside_mmm = 0.0 < max(v104, max(v100, max(v96, v108)))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, q2_ppp, angle1
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_ppp, angle3, q6_ppp
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = angle5, q5_ppm, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q7_ppm, q1_pmp, q2_pmp
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q3_pmp, q1_mpp, q2_mpp
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = angle2, q4_mpp, angle4
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q6_mpp, angle6, q5_mpm
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = q6_mpm, q7_mpm, q1_mmp
        rows[24 * w + k], rows[25 * w + k] = q2_mmp, q3_mmp
        rows[26 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_ppp else OK)
        )
        rows[27 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_ppm else OK)
        )
        rows[28 * w + k] = (
            UNREACHABLE if q1_pmp != q1_pmp else (OUT_OF_LIMITS if outside_pmp else OK)
        )
        rows[29 * w + k] = (
            UNREACHABLE if q1_pmp != q1_pmp else (OUT_OF_LIMITS if outside_pmm else OK)
        )
        rows[30 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mpp else OK)
        )
        rows[31 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mpm else OK)
        )
        rows[32 * w + k] = (
            UNREACHABLE if q1_mmp != q1_mmp else (OUT_OF_LIMITS if outside_mmp else OK)
        )
        rows[33 * w + k] = (
            UNREACHABLE if q1_mmp != q1_mmp else (OUT_OF_LIMITS if outside_mmm else OK)
        )


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 58, 36, [
    [0, 1, 2, 3, 4, 5, 6], [0, 1, 2, 3, 7, 8, 9], [10, 11, 12, 3, 4, 5, 6],
    [10, 11, 12, 3, 7, 8, 9], [13, 14, 15, 16, 17, 18, 19], [13, 14, 15, 16, 20, 21, 22],
    [23, 24, 25, 16, 17, 18, 19], [23, 24, 25, 16, 20, 21, 22],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS, given=1))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
