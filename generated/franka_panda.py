# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 3bdf97d21dac1f9a
"""franka_panda: Franka Emika Panda.

Inverse kinematics, generated from robots/franka_panda.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/franka_panda.yaml. The formulas and where they come from:
franka_panda.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 7), _runtime("arrays").zeros

NAME = "franka_panda"
METHOD = "closed form"
DOF = 7
JOINT_TYPES = "RRRRRRR"
JOINT_NAMES = (
    "panda_joint1", "panda_joint2", "panda_joint3", "panda_joint4", "panda_joint5", "panda_joint6",
    "panda_joint7",
)
JOINT_LIMITS = (
    (-2.8973, 2.8973), (-1.7628, 1.7628), (-2.8973, 2.8973), (-3.0718, -0.0698), (-2.8973, 2.8973),
    (-0.0175, 3.7525), (-2.8973, 2.8973),
)
BRANCHES = (
    "elbow4+-noflip-elbow3+", "elbow4+-noflip-elbow3-", "elbow4+-flip-elbow3+",
    "elbow4+-flip-elbow3-", "elbow4--noflip-elbow3+", "elbow4--noflip-elbow3-",
    "elbow4--flip-elbow3+", "elbow4--flip-elbow3-",
)
MAX_SOLUTIONS = 8
FREE_JOINTS = (7,)  # from 1: the caller gives their values

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, arm_size2 = 1.940449 [m^2], doubt_limit = 9.999999999999999e-05.
d1 = 0.333  # joint offset 1 [m]
d3 = 0.316  # joint offset 3 [m]
a3 = 0.0825  # link length 4 [m]
d5 = 0.384  # joint offset 5 [m]
a4 = 0.0825  # link length 5 [m]
a6 = 0.088  # link length 7 [m]
d7 = 0.107  # z of the tool frame [m]
reach_slack2 = 1.9404490000000003e-13  # rounding at the boundary of the workspace [m^2]
merge_slack2 = 1.940449e-14  # nearer to that boundary two branches are one [m^2]
least_root2 = 6.136238523396071e-07  # a root of nothing, by rounding [m^2]
free_limit_squared2 = 1.940449e-24  # square of a length that fixes no angle [m^2]
reach_slack1 = 1.393e-13  # rounding at the boundary of the workspace [m]
merge_slack1 = 1.393e-14  # nearer to that boundary two branches are one [m]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.1155  # 2 * (d3 * a4 + d5 * a3) [m^2]
k2 = 0.22907550000000002  # 2 * (d3 * d5 - a4 * a3) [m^2]
k3 = 0.06581583470025  # k1^2 + k2^2 [m^4]
k4 = 0.25318050000000003  # d3^2 + (a4 * a3 + (d5^2 + (a4 * a3 - a6^2))) [m^2]
k5 = 0.515344644461153  # 1 / arm_size2 [m^-2]
k6 = 15.193911990243306  # 1 / k3 [m^-4]
doubt_limit_squared2 = 1.940449e-08  # square of a length that fixes no angle [m^2]
turn1 = 0.46700242365301164  # atan2(k1, k2) [rad]
high1 = 2.897300001  # highest value of joint 1, with what rounding adds [rad]
high2 = 1.762800001  # highest value of joint 2, with what rounding adds [rad]
high3 = 2.897300001  # highest value of joint 3, with what rounding adds [rad]
low4 = -3.071800001  # lowest value of joint 4, with what rounding adds [rad]
high4 = -0.069799999  # highest value of joint 4, with what rounding adds [rad]
high5 = 2.897300001  # highest value of joint 5, with what rounding adds [rad]
low6 = -0.017500001  # lowest value of joint 6, with what rounding adds [rad]
high6 = 3.752500001  # highest value of joint 6, with what rounding adds [rad]
high7 = 2.897300001  # highest value of joint 7, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 1.940449e-11  # 1000 * merge_slack2 [m^2]
m2 = 1.754896834873102  # k1 * k6 [m^-2]
m3 = 3.4805529861209807  # k2 * k6 [m^-2]
m4 = 1.2446337324912609  # k6 * (d3 * k2 + a3 * k1) [m^-1]
m5 = 0.0825  # a4 [m]
m6 = 0.2674017784649193  # k6 * (d3 * k1 - a3 * k2) [m^-1]
m7 = 1.393e-11  # 1000 * merge_slack1 [m]
m9 = 0.384  # d5 [m]
m10 = 3.765342321601e-16  # doubt_limit_squared2^2 [m^4]
m11 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.7179, 0.7179, 0.7179, 1.0, 1.0, 1.0), size=1.393,
    paces=(1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0),
    steps=("keeps limits", "merges", "refines", "clamps", "clamps far", "follows seed"), given=(6,),
    choosable=(5, 4, 2),
))

# The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.333, 0.0, 0.0),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.316, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0825, 1.5707963267948966),
    (0.0, 0.384, -0.0825, -1.5707963267948966),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.088, 1.5707963267948966),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="modified",
    tool=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.107),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (7,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, z3_x = c1 * c2, s1 * c2, c1 * s2
    z3_y = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v1 = x2_x * c3 - s1 * s3, x2_y * c3 + c1 * s3, s2 * c3
    z4_x, y3_y, y3_z = s1 * c3 + x2_x * s3, c1 * c3 - x2_y * s3, s2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + z3_x * s4, x3_y * c4 + z3_y * s4, c2 * s4 - v1 * c4
    y4_x, y4_y, y4_z = z3_x * c4 - x3_x * s4, z3_y * c4 - x3_y * s4, c2 * c4 + v1 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 - z4_x * s5, x4_y * c5 + y3_y * s5, x4_z * c5 + y3_z * s5
    z6_x, z6_y, z6_z = z4_x * c5 + x4_x * s5, x4_y * s5 - y3_y * c5, x4_z * s5 - y3_z * c5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    x6_x, x6_y, x6_z = x5_x * c6 + y4_x * s6, x5_y * c6 + y4_y * s6, x5_z * c6 + y4_z * s6
    z7_x, z7_y, z7_z = x5_x * s6 - y4_x * c6, x5_y * s6 - y4_y * c6, x5_z * s6 - y4_z * c6
    c7, s7 = math.cos(q[6]), math.sin(q[6])
    T[0, 0], T[0, 1], T[0, 2] = x6_x * c7 + z6_x * s7, z6_x * c7 - x6_x * s7, z7_x
    T[0, 3] = z3_x * d3 + x3_x * a3 - x4_x * a4 + y4_x * d5 + x6_x * a6 + z7_x * d7
    T[1, 0], T[1, 1], T[1, 2] = x6_y * c7 + z6_y * s7, z6_y * c7 - x6_y * s7, z7_y
    T[1, 3] = z3_y * d3 + x3_y * a3 - x4_y * a4 + y4_y * d5 + x6_y * a6 + z7_y * d7
    T[2, 0], T[2, 1], T[2, 2] = x6_z * c7 + z6_z * s7, z6_z * c7 - x6_z * s7, z7_z
    T[2, 3] = d1 + c2 * d3 - v1 * a3 - x4_z * a4 + y4_z * d5 + x6_z * a6 + z7_z * d7
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 7): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 7)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, z3_x = c1 * c2, s1 * c2, c1 * s2
    z3_y, p3_x = s1 * s2, z3_x * d3
    p3_y, p3_z = z3_y * d3, d1 + c2 * d3
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v1 = x2_x * c3 - s1 * s3, x2_y * c3 + c1 * s3, s2 * c3
    z4_x, y3_y, y3_z = s1 * c3 + x2_x * s3, c1 * c3 - x2_y * s3, s2 * s3
    p4_x, p4_y, p4_z = p3_x + x3_x * a3, p3_y + x3_y * a3, p3_z - v1 * a3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + z3_x * s4, x3_y * c4 + z3_y * s4, c2 * s4 - v1 * c4
    y4_x, y4_y, y4_z = z3_x * c4 - x3_x * s4, z3_y * c4 - x3_y * s4, c2 * c4 + v1 * s4
    p5_x, p5_y = p4_x - x4_x * a4 + y4_x * d5, p4_y - x4_y * a4 + y4_y * d5
    p5_z = p4_z - x4_z * a4 + y4_z * d5
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 - z4_x * s5, x4_y * c5 + y3_y * s5, x4_z * c5 + y3_z * s5
    z6_x, z6_y, z6_z = z4_x * c5 + x4_x * s5, x4_y * s5 - y3_y * c5, x4_z * s5 - y3_z * c5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    p7_x, p7_y = p5_x + (x5_x * c6 + y4_x * s6) * a6, p5_y + (x5_y * c6 + y4_y * s6) * a6
    p7_z, z7_x = p5_z + (x5_z * c6 + y4_z * s6) * a6, x5_x * s6 - y4_x * c6
    z7_y, z7_z, J21 = x5_y * s6 - y4_y * c6, x5_z * s6 - y4_z * c6, p7_x + z7_x * d7
    v2, v3 = p7_y + z7_y * d7, p7_z + z7_z * d7
    v4, v5, v6 = v3 - d1, J21 - p3_x, v2 - p3_y
    v7, v8, v9 = v3 - p3_z, J21 - p4_x, v2 - p4_y
    v10, v11, v12 = v3 - p4_z, J21 - p5_x, v2 - p5_y
    v13, v14, v15 = v3 - p5_z, J21 - p7_x, v2 - p7_y
    v16 = v3 - p7_z
    J[0, 0], J[0, 1], J[0, 2] = -v2, c1 * v4, z3_y * v7 - c2 * v6
    J[0, 3], J[0, 4] = -y3_y * v10 + y3_z * v9, y4_y * v13 - y4_z * v12
    J[0, 5], J[0, 6] = z6_y * v13 - z6_z * v12, z7_y * v16 - z7_z * v15
    J[1, 0], J[1, 1], J[1, 2] = J21, s1 * v4, c2 * v5 - z3_x * v7
    J[1, 3], J[1, 4] = -(y3_z * v8 + z4_x * v10), y4_z * v11 - y4_x * v13
    J[1, 5], J[1, 6] = z6_z * v11 - z6_x * v13, z7_z * v14 - z7_x * v16
    J[2, 1], J[2, 2], J[2, 3] = -(s1 * v2 + c1 * J21), z3_x * v6 - z3_y * v5, z4_x * v9 - -y3_y * v8
    J[2, 4], J[2, 5] = y4_x * v12 - y4_y * v11, z6_x * v12 - z6_y * v11
    J[2, 6] = z7_x * v15 - z7_y * v14
    J[3, 1], J[3, 2], J[3, 3] = -s1, z3_x, z4_x
    J[3, 4], J[3, 5], J[3, 6] = y4_x, z6_x, z7_x
    J[4, 1], J[4, 2], J[4, 3] = c1, z3_y, -y3_y
    J[4, 4], J[4, 5], J[4, 6] = y4_y, z6_y, z7_y
    J[5, 0], J[5, 2], J[5, 3] = 1.0, c2, -y3_z
    J[5, 4], J[5, 5], J[5, 6] = y4_z, z6_z, z7_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    c7, s7 = math.cos(q_free[0]), math.sin(q_free[0])

    # theta4, type 2: the squared length of column 4 of A7 U0^-1 A1
    v1, v2 = d7 * T13 - T14, d7 * T23 - T24
    t34 = T34 - d7 * T33
    v3 = d1 - t34
    w2x, w2y = T11 * v1 + T21 * v2 + T31 * v3, T12 * v1 + T22 * v2 + T32 * v3
    w2z = T13 * v1 + T23 * v2 + T33 * v3
    Z4 = (
        c7 * (2.0 * (w2x * a6)) - s7 * (2.0 * (w2y * a6)) + (w2x * w2x + (w2y * w2y + (w2z * w2z -
        k4)))
    )
    D4_squared = k3 - Z4 * Z4
    v4 = 2.0 * abs(Z4)
    apart4 = merge_slack2 * (v4 + merge_slack2) < D4_squared
    if not (-(reach_slack2 * (v4 + reach_slack2)) < D4_squared):
        return  # out of reach
    w4 = math.sqrt(D4_squared if apart4 else 0.0)
    v5 = (w4 if apart4 else least_root2) * k5
    v6, v7 = k1 * Z4, k2 * Z4

    # theta5, type 2: A7 U0^-1 A1 [3, 4]
    Z5 = c7 * w2y + s7 * w2x
    v9, v10 = Z5 * Z5, abs(Z5)
    v11 = 2.0 * v10
    v12 = merge_slack1 * (v11 + merge_slack1)

    # theta6, type 3: A7 U0^-1 A1 [2, 4] and A7 U0^-1 A1 [1, 4]
    Z2_6 = a6 + (c7 * w2x - s7 * w2y)

    # theta3, type 2: U0 (A3 A4 A5 A6 A7)^-1 [3, 3]
    v17, v22 = c7 * T31 - s7 * T32, c7 * T32 + s7 * T31

    # theta1, type 3: U0 (A3 A4 A5 A6 A7)^-1 [1, 3] and U0 (A3 A4 A5 A6 A7)^-1 [2, 3]
    v28, v31, v39 = c7 * T11 - s7 * T12, c7 * T12 + s7 * T11, c7 * T21 - s7 * T22
    v42 = c7 * T22 + s7 * T21

    for i1 in range(2):  # elbow4+, elbow4-
        e4 = 1.0 - 2.0 * i1
        # theta4
        if e4 < 0.0 and not apart4:
            continue  # both signs give the same
        D4 = w4 * e4
        c4, s4 = k6 * (v7 + k1 * D4), k6 * (k2 * D4 - v6)
        q4 = _atan2(s4, c4)

        # theta5
        v8 = a3 * c4 + d3 * s4 - a4
        N5 = -v8 * -v8
        free5 = N5 <= free_limit_squared2
        D5_squared = N5 - v9
        apart5 = v12 < D5_squared
        if not (-(reach_slack1 * (v11 + reach_slack1)) < v5 * D5_squared):
            continue  # out of reach
        w5 = math.sqrt(D5_squared if apart5 else 0.0)
        inverse5 = 1.0 / (1.0 if free5 else (N5 if apart5 else v10 * math.sqrt(N5)))
        s5 = math.sin(seed[4]) if free5 else inverse5 * (-v8 * Z5)

        # theta6
        Y1_6 = d5 + (d3 * c4 - a3 * s4)
        v14, v16 = Y1_6 * Z2_6, w2z * Y1_6

        # theta3
        v18, v19, v20 = c4 * v17, T33 * s4, T33 * c4
        v21, v23, v25 = s4 * v17, s5 * (c4 * v22), s5 * v17
        v26 = T33 * s5

        # theta2, type 3: U0 (A3 A4 A5 A6 A7)^-1 [3, 2] and U0 (A3 A4 A5 A6 A7)^-1 [3, 1]
        v27 = s5 * (s4 * v22)

        # theta1
        v29, v30, v33 = s5 * v28, T13 * s5, c4 * v28
        v34, v35, v36 = T13 * s4, T13 * c4, s4 * v28
        v37, v40, v41 = s5 * (c4 * v31), s5 * v39, T23 * s5
        v44, v45, v46 = c4 * v39, T23 * s4, T23 * c4
        v47, v48 = s4 * v39, s5 * (c4 * v42)

        for i2 in range(2):  # noflip, flip
            e5 = 1.0 - 2.0 * i2
            # theta5
            if e5 < 0.0 and (free5 or not apart5):
                continue  # both signs give the same
            c5 = math.cos(seed[4]) if free5 else -(inverse5 * (-v8 * (w5 * e5)))
            q5 = _atan2(s5, c5)

            # theta6
            v13 = v8 * c5
            v15 = w2z * v13 + v14
            C6 = v16 - v13 * Z2_6
            w6 = math.sqrt(v15 * v15 + C6 * C6)
            free6 = w6 <= free_limit_squared2
            factor6 = 1.0 / (1.0 if free6 else w6)
            c6 = math.cos(seed[5]) if free6 else C6 * factor6
            s6 = math.sin(seed[5]) if free6 else -(v15 * factor6)
            q6 = _atan2(s6, c6)

            # theta3
            v24 = c6 * (c5 * v18 + v19) + s6 * (c5 * v20 - v21) + v23
            Y3 = c5 * v22 - (c6 * v25 + s6 * v26)
            w3 = math.sqrt(v24 * v24 + Y3 * Y3)
            free3 = w3 <= free_limit
            divisor3 = 1.0 if free3 else w3

            # theta2
            c2 = c6 * (c5 * v21 - v20) + s6 * (v18 + c5 * v19) + v27

            # theta1
            v32 = c5 * v31 - (c6 * v29 + s6 * v30)
            v38 = c6 * (c5 * v33 + v34) + s6 * (c5 * v35 - v36) + v37
            v43 = c5 * v42 - (c6 * v40 + s6 * v41)
            v49 = c6 * (c5 * v44 + v45) + s6 * (c5 * v46 - v47) + v48

            for i3 in range(2):  # elbow3+, elbow3-
                e3 = 1.0 - 2.0 * i3
                # theta3
                if e3 < 0.0 and free3:
                    continue  # both signs give the same
                factor3 = e3 / divisor3
                c3 = math.cos(seed[2]) if free3 else v24 * factor3
                s3 = math.sin(seed[2]) if free3 else Y3 * factor3
                q3 = _atan2(s3, c3)

                # theta2
                q2 = _atan2(-(w3 * e3), c2)

                # theta1
                s1, c1 = c3 * v32 - s3 * v38, s3 * v49 - c3 * v43
                q1 = _atan2(s1, c1)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
                q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
                q[row, 6] = q_free[0]
                status[row] = FREE_JOINT if free3 or free5 or free6 else OK


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

        # theta4, type 2: the squared length of column 4 of A7 U0^-1 A1
        v1, v2, v3 = d7 * T13 - T14, d7 * T23 - T24, d1 - (T34 - d7 * T33)
        w2x, w2y = v1 * T11 + v2 * T21 + v3 * T31, v1 * T12 + v2 * T22 + v3 * T32
        w2z = T13 * v1 + T23 * v2 + T33 * v3
        kept[18 * w + k], kept[19 * w + k], kept[20 * w + k] = w2x, w2y, w2z
        turns[0 * w + k], turns[1 * w + k] = given1, given1
    for k in range(0 * w, 1 * w):
        turns[k] = math.sin(turns[k])
    for k in range(1 * w, 2 * w):
        turns[k] = math.cos(turns[k])
    for k in range(w):
        T11, T12, T13 = kept[0 * w + k], kept[1 * w + k], kept[2 * w + k]
        T21, T22, T23 = kept[4 * w + k], kept[5 * w + k], kept[6 * w + k]
        T31, T32, T33 = kept[8 * w + k], kept[9 * w + k], kept[10 * w + k]
        given1, w2x, w2y = kept[16 * w + k], kept[18 * w + k], kept[19 * w + k]
        w2z, s7, c7 = kept[20 * w + k], turns[0 * w + k], turns[1 * w + k]

        # theta4, type 2: the squared length of column 4 of A7 U0^-1 A1
        Z4 = (
            c7 * (2.0 * (a6 * w2x)) - s7 * (2.0 * (a6 * w2y)) + (w2x * w2x + (w2y * w2y + (w2z * w2z
            - k4)))
        )
        D4_squared = k3 - Z4 * Z4
        w4 = math.sqrt(D4_squared)
        v4, v5, v6 = k5 * w4, m3 * Z4, m2 * w4
        c4_p, c4_m, v7 = v5 + v6, v5 - v6, m2 * Z4
        v8 = m3 * w4
        s4_p, v9 = v8 - v7, v7 + v8

        # theta5, type 2: A7 U0^-1 A1 [3, 4]
        v11, v12, v13 = a3 * c4_p + d3 * s4_p - a4, a3 * c4_m - d3 * v9 - a4, m5 + m6 * Z4
        v14 = m4 * w4
        v15, v16 = v13 - v14, v13 + v14
        N5_p, N5_m, Z5 = v15 * v15, v16 * v16, c7 * w2y + s7 * w2x
        v17 = Z5 * Z5
        D5_squared_p, D5_squared_m = N5_p - v17, N5_m - v17
        w5_p, w5_m = math.sqrt(D5_squared_p), math.sqrt(D5_squared_m)
        v18, v19, v20 = w5_p - w5_p, w5_m - w5_m, m7 * (merge_slack1 + 2.0 * abs(Z5))
        inverse5_p, inverse5_m, v21 = 1.0 / N5_p, 1.0 / N5_m, v15 * w5_p
        v22, v23 = v16 * w5_m, inverse5_p * v21
        v24, v25, v26 = inverse5_m * v22, v15 * Z5, v16 * Z5
        s5_p, s5_m = inverse5_p * v25, inverse5_m * v26

        # theta6, type 3: A7 U0^-1 A1 [2, 4] and A7 U0^-1 A1 [1, 4]
        v27, v28 = m9 + m4 * Z4, m6 * w4
        Y1_6_p, Y1_6_m, Z2_6 = v27 + v28, v27 - v28, a6 + (c7 * w2x - s7 * w2y)
        v29, v30, v31 = Y1_6_p * Z2_6, Y1_6_m * Z2_6, w5_p * (inverse5_p * (v11 * (w2z * v15)))
        v32, v33, v34 = v29 - v31, v29 + v31, w5_m * (inverse5_m * (v12 * (w2z * v16)))
        v35, v36, v37 = v30 - v34, v30 + v34, w2z * Y1_6_p
        v38, v39 = w2z * Y1_6_m, w5_p * (inverse5_p * (v11 * (v15 * Z2_6)))
        C6_pp, C6_pm, v40 = v37 + v39, v37 - v39, w5_m * (inverse5_m * (v12 * (v16 * Z2_6)))
        C6_mp, C6_mm, v41 = v38 + v40, v38 - v40, v32 * v32 + C6_pp * C6_pp
        v42, v43 = v33 * v33 + C6_pm * C6_pm, v35 * v35 + C6_mp * C6_mp
        v44, factor6_pp = v36 * v36 + C6_mm * C6_mm, math.sqrt(v41) * (1.0 / v41)
        factor6_pm, factor6_mp = math.sqrt(v42) * (1.0 / v42), math.sqrt(v43) * (1.0 / v43)
        factor6_mm = math.sqrt(v44) * (1.0 / v44)

        # theta3, type 2: U0 (A3 A4 A5 A6 A7)^-1 [3, 3]
        v45 = c7 * T31 - s7 * T32
        v46, v47, v48 = c4_p * v45, c4_m * v45, T33 * s4_p
        v49, v50, v51 = T33 * v9, T33 * c4_p, T33 * c4_m
        v52, v53, v54 = s4_p * v45, v9 * v45, c7 * T32 + s7 * T31
        v55, v56, v57 = s5_p * (c4_p * v54), s5_m * (c4_m * v54), v23 * v46
        v58, v59, v60 = v24 * v47, v23 * v50, v24 * v51
        c3_pp = v55 + factor6_pp * (C6_pp * (v48 - v57) - -v32 * (v52 + v59))
        c3_pm = v55 + factor6_pm * (C6_pm * (v48 + v57) + v33 * (v52 - v59))
        c3_mp = v56 - factor6_mp * (C6_mp * (v49 + v58) + -v35 * (v60 - v53))
        c3_mm, v61 = v56 + factor6_mm * (C6_mm * (v58 - v49) - v36 * (v53 + v60)), s5_p * v45
        v62, v63, v64 = s5_m * v45, T33 * s5_p, T33 * s5_m
        v65, v66 = v23 * v54, v24 * v54
        v67 = v65 + factor6_pp * (C6_pp * v61 + -v32 * v63)
        v68 = factor6_pm * (C6_pm * v61 - v33 * v63) - v65
        v69 = v66 + factor6_mp * (C6_mp * v62 + -v35 * v64)
        v70, v71 = factor6_mm * (C6_mm * v62 - v36 * v64) - v66, c3_pp * c3_pp + v67 * v67
        v72, v73 = c3_pm * c3_pm + v68 * v68, c3_mp * c3_mp + v69 * v69
        v74 = c3_mm * c3_mm + v70 * v70

        # theta2, type 3: U0 (A3 A4 A5 A6 A7)^-1 [3, 2] and U0 (A3 A4 A5 A6 A7)^-1 [3, 1]
        v75, v76, v77 = s5_p * (s4_p * v54), s5_m * (v9 * v54), v23 * v52
        v78, v79, v80 = v24 * v53, v23 * v48, v24 * v49

        # theta1, type 3: U0 (A3 A4 A5 A6 A7)^-1 [1, 3] and U0 (A3 A4 A5 A6 A7)^-1 [2, 3]
        v81 = c7 * T11 - s7 * T12
        v82, v83, v84 = s5_p * v81, s5_m * v81, T13 * s5_p
        v85, v86 = T13 * s5_m, c7 * T12 + s7 * T11
        v87, v88, v89 = v23 * v86, v24 * v86, T13 * s4_p
        v90, v91, v92 = T13 * v9, s4_p * v81, v9 * v81
        v93, v94, v95 = s5_p * (c4_p * v86), s5_m * (c4_m * v86), v23 * (c4_p * v81)
        v96, v97, v98 = v24 * (c4_m * v81), v23 * (T13 * c4_p), v24 * (T13 * c4_m)
        s1_pp = (
            v67 * (v93 + factor6_pp * (C6_pp * (v89 - v95) - -v32 * (v91 + v97))) - c3_pp * (v87 +
            factor6_pp * (C6_pp * v82 + -v32 * v84))
        )
        s1_pm = (
            v68 * (v93 + factor6_pm * (C6_pm * (v89 + v95) + v33 * (v91 - v97))) - c3_pm *
            (factor6_pm * (C6_pm * v82 - v33 * v84) - v87)
        )
        s1_mp = (
            v69 * (v94 - factor6_mp * (C6_mp * (v90 + v96) + -v35 * (v98 - v92))) - c3_mp * (v88 +
            factor6_mp * (C6_mp * v83 + -v35 * v85))
        )
        s1_mm = (
            v70 * (v94 + factor6_mm * (C6_mm * (v96 - v90) - v36 * (v92 + v98))) - c3_mm *
            (factor6_mm * (C6_mm * v83 - v36 * v85) - v88)
        )
        v99 = c7 * T21 - s7 * T22
        v100, v101, v102 = s5_p * v99, s5_m * v99, T23 * s5_p
        v103, v104 = T23 * s5_m, c7 * T22 + s7 * T21
        v105, v106, v107 = v23 * v104, v24 * v104, T23 * s4_p
        v108, v109, v110 = T23 * v9, s4_p * v99, v9 * v99
        v111, v112, v113 = s5_p * (c4_p * v104), s5_m * (c4_m * v104), v23 * (c4_p * v99)
        v114, v115, v116 = v24 * (c4_m * v99), v23 * (T23 * c4_p), v24 * (T23 * c4_m)

        # joint values
        v137 = given1 + (w4 - w4)
        q7_ppp, q7_mpp = v18 + v137, v19 + v137

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[17 * w + k] = (
            1.0 if v74 <= m11 or v44 <= m10 or v73 <= m11 or v43 <= m10 or v72 <= m11 or v42 <= m10
            or v71 <= m11 or v41 <= m10 or abs(v4 * D5_squared_m) <= v20 or N5_m <=
            doubt_limit_squared2 or abs(v4 * D5_squared_p) <= v20 or abs(D4_squared) <= m1 *
            (merge_slack2 + 2.0 * abs(Z4)) or 0.0 < abs(given1) - high7 or N5_p <=
            doubt_limit_squared2 else kept[17 * w + k]
        )
        kept[21 * w + k], kept[22 * w + k], kept[23 * w + k] = v18, v19, v25
        kept[24 * w + k], kept[25 * w + k], kept[26 * w + k] = v26, v67, v68
        kept[27 * w + k], kept[28 * w + k], kept[29 * w + k] = v69, v70, s1_pp
        kept[30 * w + k], kept[31 * w + k], kept[32 * w + k] = s1_pm, s1_mp, s1_mm
        kept[33 * w + k], kept[34 * w + k], turns[2 * w + k] = q7_ppp, q7_mpp, w4
        turns[3 * w + k], turns[4 * w + k], turns[5 * w + k] = v25, v26, -v32
        turns[6 * w + k], turns[7 * w + k], turns[8 * w + k] = -v33, -v35, -v36
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = -v67, -v68, -v69
        turns[12 * w + k], turns[13 * w + k] = -v70, -math.sqrt(v71)
        turns[14 * w + k], turns[15 * w + k] = -math.sqrt(v72), -math.sqrt(v73)
        turns[16 * w + k], turns[17 * w + k], turns[18 * w + k] = -math.sqrt(v74), s1_pp, s1_pm
        turns[19 * w + k], turns[20 * w + k], turns[26 * w + k] = s1_mp, s1_mm, Z4
        turns[27 * w + k], turns[28 * w + k], turns[29 * w + k] = -v21, -v22, C6_pp
        turns[30 * w + k], turns[31 * w + k], turns[32 * w + k] = C6_pm, C6_mp, C6_mm
        turns[33 * w + k], turns[34 * w + k], turns[35 * w + k] = c3_pp, c3_pm, c3_mp
        turns[36 * w + k] = c3_mm
        turns[37 * w + k] = v75 + factor6_pp * (-v32 * (v46 - v79) - C6_pp * (v50 + v77))
        turns[38 * w + k] = v75 - factor6_pm * (v33 * (v46 + v79) + C6_pm * (v50 - v77))
        turns[39 * w + k] = factor6_mp * (-v35 * (v47 + v80) - C6_mp * (v51 - v78)) - v76
        turns[40 * w + k] = -(v76 + factor6_mm * (v36 * (v47 - v80) + C6_mm * (v51 + v78)))
        turns[41 * w + k] = (
            c3_pp * (v105 + factor6_pp * (C6_pp * v100 + -v32 * v102)) - v67 * (v111 + factor6_pp *
            (C6_pp * (v107 - v113) - -v32 * (v109 + v115)))
        )
        turns[42 * w + k] = (
            c3_pm * (factor6_pm * (C6_pm * v100 - v33 * v102) - v105) - v68 * (v111 + factor6_pm *
            (C6_pm * (v107 + v113) + v33 * (v109 - v115)))
        )
        turns[43 * w + k] = (
            c3_mp * (v106 + factor6_mp * (C6_mp * v101 + -v35 * v103)) - v69 * (v112 - factor6_mp *
            (C6_mp * (v108 + v114) + -v35 * (v116 - v110)))
        )
        turns[44 * w + k] = (
            c3_mm * (factor6_mm * (C6_mm * v101 - v36 * v103) - v106) - v70 * (v112 + factor6_mm *
            (C6_mm * (v114 - v108) - v36 * (v110 + v116)))
        )
    if w == 1 and kept[17] != 0.0:
        return
    end = 26 if w == 1 else 21 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(21 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(2 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        v18, v19, v25 = kept[21 * w + k], kept[22 * w + k], kept[23 * w + k]
        v26, v67, v68 = kept[24 * w + k], kept[25 * w + k], kept[26 * w + k]
        v69, v70, s1_pp = kept[27 * w + k], kept[28 * w + k], kept[29 * w + k]
        s1_pm, s1_mp, s1_mm = kept[30 * w + k], kept[31 * w + k], kept[32 * w + k]
        q7_ppp, q7_mpp, angle1 = kept[33 * w + k], kept[34 * w + k], turns[2 * w + k]
        angle2, angle3, angle4 = turns[3 * w + k], turns[4 * w + k], turns[5 * w + k]
        angle5, angle6, angle7 = turns[6 * w + k], turns[7 * w + k], turns[8 * w + k]
        angle8, angle9, angle10 = turns[9 * w + k], turns[10 * w + k], turns[11 * w + k]
        angle11, angle12, angle13 = turns[12 * w + k], turns[13 * w + k], turns[14 * w + k]
        angle14, angle15, angle16 = turns[15 * w + k], turns[16 * w + k], turns[17 * w + k]
        angle17, angle18, angle19 = turns[18 * w + k], turns[19 * w + k], turns[20 * w + k]

        # theta4, type 2: the squared length of column 4 of A7 U0^-1 A1
        q4__p, v10 = angle1 - turn1, turn1 + angle1

        # theta5, type 2: A7 U0^-1 A1 [3, 4]
        q5_pmp = math.copysign(half_turn, v25) - angle2
        q5_mmp = math.copysign(half_turn, v26) - angle3

        # theta3, type 2: U0 (A3 A4 A5 A6 A7)^-1 [3, 3]
        q3_ppm = angle8 - math.copysign(half_turn, -v67)
        q3_pmm = angle9 - math.copysign(half_turn, -v68)
        q3_mpm = angle10 - math.copysign(half_turn, -v69)
        q3_mmm = angle11 - math.copysign(half_turn, -v70)

        # theta1, type 3: U0 (A3 A4 A5 A6 A7)^-1 [1, 3] and U0 (A3 A4 A5 A6 A7)^-1 [2, 3]
        q1_ppm = angle16 - math.copysign(half_turn, s1_pp)
        q1_pmm = angle17 - math.copysign(half_turn, s1_pm)
        q1_mpm = angle18 - math.copysign(half_turn, s1_mp)
        q1_mmm = angle19 - math.copysign(half_turn, s1_mm)

        # joint values
        v117 = q4__p + (turn if q4__p <= -half_turn else 0.0)
        v118 = (turn if -v10 <= -half_turn else 0.0) - v10
        v119, v120 = max(low4 - v117, v117 - high4), max(low4 - v118, v118 - high4)
        v121 = angle4 + (turn if angle4 < low6 else 0.0)
        v122 = angle5 + (turn if angle5 < low6 else 0.0)
        v123 = angle6 + (turn if angle6 < low6 else 0.0)
        v124 = angle7 + (turn if angle7 < low6 else 0.0)
        v125, v126 = max(low6 - v121, v121 - high6), max(low6 - v122, v122 - high6)
        v127, v128 = max(low6 - v123, v123 - high6), max(low6 - v124, v124 - high6)
        v129, v130, v131 = low6 - angle4, low6 - angle5, low6 - angle6
        v132 = low6 - angle7
        v133 = v129 if v129 < v125 else v125
        v134 = v130 if v130 < v126 else v126
        v135 = v131 if v131 < v127 else v127
        v136 = v132 if v132 < v128 else v128
        q6_ppp = angle4 if 0.0 < v133 else v121
        q6_pmp = angle5 if 0.0 < v134 else v122
        q6_mpp = angle6 if 0.0 < v135 else v123
        q6_mmp = angle7 if 0.0 < v136 else v124
        q4_ppp, q4_mpp = v18 + v117, v19 + v118
        v138 = max(v133, max(abs(angle2) - high5, max(v119, abs(angle12) - high2)))
        v139 = max(v134, max(abs(q5_pmp) - high5, max(v119, abs(angle13) - high2)))
        v140 = max(v135, max(abs(angle3) - high5, max(v120, abs(angle14) - high2)))
        v141 = max(v136, max(abs(q5_mmp) - high5, max(v120, abs(angle15) - high2)))
        excess_ppp = max(abs(angle8) - high3, max(v138, abs(angle16) - high1))
        excess_ppm = max(abs(q3_ppm) - high3, max(v138, abs(q1_ppm) - high1))
        excess_pmp = max(abs(angle9) - high3, max(v139, abs(angle17) - high1))
        excess_pmm = max(abs(q3_pmm) - high3, max(v139, abs(q1_pmm) - high1))
        excess_mpp = max(abs(angle10) - high3, max(v140, abs(angle18) - high1))
        excess_mpm = max(abs(q3_mpm) - high3, max(v140, abs(q1_mpm) - high1))
        excess_mmp = max(abs(angle11) - high3, max(v141, abs(angle19) - high1))
        excess_mmm = max(abs(q3_mmm) - high3, max(v141, abs(q1_mmm) - high1))
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

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle16, angle12, angle8
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_ppp, angle2, q6_ppp
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q7_ppp, q1_ppm, -angle12
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q3_ppm, angle17, angle13
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = angle9, q5_pmp, q6_pmp
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q1_pmm, -angle13, q3_pmm
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = angle18, angle14, angle10
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = q4_mpp, angle3, q6_mpp
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q7_mpp, q1_mpm, -angle14
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q3_mpm, angle19, angle15
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = angle11, q5_mmp, q6_mmp
        rows[33 * w + k], rows[34 * w + k], rows[35 * w + k] = q1_mmm, -angle15, q3_mmm
        rows[36 * w + k] = (
            UNREACHABLE if angle16 != angle16 else (OUT_OF_LIMITS if outside_ppp else OK)
        )
        rows[37 * w + k] = (
            UNREACHABLE if q1_ppm != q1_ppm else (OUT_OF_LIMITS if outside_ppm else OK)
        )
        rows[38 * w + k] = (
            UNREACHABLE if angle17 != angle17 else (OUT_OF_LIMITS if outside_pmp else OK)
        )
        rows[39 * w + k] = (
            UNREACHABLE if q1_pmm != q1_pmm else (OUT_OF_LIMITS if outside_pmm else OK)
        )
        rows[40 * w + k] = (
            UNREACHABLE if angle18 != angle18 else (OUT_OF_LIMITS if outside_mpp else OK)
        )
        rows[41 * w + k] = (
            UNREACHABLE if q1_mpm != q1_mpm else (OUT_OF_LIMITS if outside_mpm else OK)
        )
        rows[42 * w + k] = (
            UNREACHABLE if angle19 != angle19 else (OUT_OF_LIMITS if outside_mmp else OK)
        )
        rows[43 * w + k] = (
            UNREACHABLE if q1_mmm != q1_mmm else (OUT_OF_LIMITS if outside_mmm else OK)
        )


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 35, 50, [
    [0, 1, 2, 3, 4, 5, 6], [7, 8, 9, 3, 4, 5, 6], [10, 11, 12, 3, 13, 14, 6],
    [15, 16, 17, 3, 13, 14, 6], [18, 19, 20, 21, 22, 23, 24], [25, 26, 27, 21, 22, 23, 24],
    [28, 29, 30, 21, 31, 32, 24], [33, 34, 35, 21, 31, 32, 24],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS, given=1))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
