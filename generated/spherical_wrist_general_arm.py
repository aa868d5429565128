# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: fd0953cc6ef8bfdc
"""spherical_wrist_general_arm: Spherical wrist on a general arm.

Inverse kinematics, generated from robots/spherical_wrist_general_arm.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/spherical_wrist_general_arm.yaml. The formulas and where they come
from: spherical_wrist_general_arm.md.

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
_circle = _runtime("circle_roots")
_circle_roots = _circle.circle_roots
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 6), _runtime("arrays").zeros

NAME = "spherical_wrist_general_arm"
METHOD = "quartic"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "root1-noflip", "root1-flip", "root2-noflip", "root2-flip", "root3-noflip", "root3-flip",
    "root4-noflip", "root4-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = 0.3  # joint offset 1 [m]
a1 = 0.15  # link length 1 [m]
ca1 = 0.3420201433256688  # cosine of twist 1
sa1 = 0.9396926207859083  # sine of twist 1
d2 = 0.12  # joint offset 2 [m]
a2 = 0.42  # link length 2 [m]
ca2 = 0.8191520442889918  # cosine of twist 2
sa2 = 0.573576436351046  # sine of twist 2
d3 = 0.08  # joint offset 3 [m]
a3 = 0.11  # link length 3 [m]
ca3 = 0.6427876096865394  # cosine of twist 3
sa3 = 0.766044443118978  # sine of twist 3
d4 = 0.37  # joint offset 4 [m]
d6 = 0.09  # joint offset 6 [m]
free_limit6 = 1.9456426971135993e-11  # a length that fixes no angle [m^6]
square_rounding = 1e-15  # squares are rounded by this
free_limit_squared2 = 2.6895999999999994e-24  # square of a length that fixes no angle [m^2]
# square of a length whose direction is good to few digits [m^2]
near_limit_squared2 = 2.6895999999999996e-06
free_limit = 1e-12  # a length that fixes no angle
near_limit_squared = 1e-06  # square of a length whose direction is good to few digits
free_limit_squared = 1e-24  # square of a length that fixes no angle
k1 = 0.43938504177070503  # sa3 * sa2
k2 = 0.16257246545516085  # d4 * sa3 * sa2 [m]
k3 = 0.1314173917092386  # 2 * (d2 * d4 * sa3 * sa2 + a3 * a2) [m^2]
k4 = 0.06309340799861507  # a3 * sa2 [m]
k5 = -0.22294419500171073  # 2 * (d2 * a3 * sa2 - d4 * sa3 * a2) [m^2]
k6 = 0.4829582968126144  # d1 * ca1 + (d2 + ca2 * (d3 + d4 * ca3)) [m]
k7 = 0.6  # 2 * d1 [m]
# d1^2 + (a1^2 - (d2 * (d2 + 2 * ca2 * (d3 + d4 * ca3)) + (a2^2 + (d3 * (d3 + 2 * d4 * ca3) + (a3^2
# + d4^2))))) [m^2]
k8 = -0.33423756740902244
k9 = 0.5  # 1 / 2
# (d4 * sa3 * sa2 * 2 * (d2 * a3 * sa2 - d4 * sa3 * a2) - a3 * sa2 * 2 * (d2 * d4 * sa3 * sa2 + a3 *
# a2))^2 [m^6]
k10 = 0.001983469418708643
# 1 / (a3 * sa2 * 2 * (d2 * d4 * sa3 * sa2 + a3 * a2) - d4 * sa3 * sa2 * 2 * (d2 * a3 * sa2 - d4 *
# sa3 * a2)) [m^-3]
k11 = 22.453665346937772
k12 = 0.28343644395402184  # d4 * sa3 [m]
k13 = 0.6275068715971331  # sa3 * ca2
k14 = 0.23217754249093925  # d4 * sa3 * ca2 [m]
k15 = 0.0901067248717891  # a3 * ca2 [m]
k16 = 0.18230061071109027  # sa2 * (d3 + d4 * ca3) [m]
k17 = 0.3686878264946124  # ca3 * sa2
k18 = 0.5265407845183633  # ca3 * ca2
f1 = 0.04104241719908026  # d2 * ca1 [m]
f2 = 0.19617469496901113  # sa2 * ca1
f3 = 0.2801664995932356  # ca2 * ca1
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=8, size=1.64, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0),
        _joints.Joint(place=1),
        _joints.Joint(place=2),
        _joints.Joint(place=3),
        _joints.Joint(place=4),
        _joints.Joint(place=5),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.15, 0.0, 0.3420201433256688, -0.9396926207859083, 0.0, 0.0,
            0.9396926207859083, 0.3420201433256688, 0.3,
        )),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.42, 0.0, 0.8191520442889918, -0.573576436351046, 0.0, 0.0,
            0.573576436351046, 0.8191520442889918, 0.12,
        )),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.11, 0.0, 0.6427876096865394, 0.766044443118978, 0.0, 0.0,
            -0.766044443118978, 0.6427876096865394, 0.08,
        )),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.37)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.09)),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.6098, 0.6098, 0.6098, 1.0, 1.0, 1.0), size=1.64,
    entries=(0, 2, 3, 4, 6, 7, 8, 10, 11), steps=("completes", "follows seed"),
    root_turns=((0, 1.0),),
), _joints.arm_numbers(_LINKS))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.3, 0.15, 1.2217304763960306),
    (0.0, 0.12, 0.42, 0.6108652381980153),
    (0.0, 0.08, 0.11, -0.8726646259971648),
    (0.0, 0.37, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.09, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    v1, y1_y, z1_x = s1 * ca1, c1 * ca1, s1 * sa1
    v2 = c1 * sa1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, x2_z = c1 * c2 - v1 * s2, s1 * c2 + y1_y * s2, sa1 * s2
    v3, v4, v5 = v1 * c2 + c1 * s2, y1_y * c2 - s1 * s2, sa1 * c2
    y2_x, y2_y, y2_z = z1_x * sa2 - v3 * ca2, v4 * ca2 - v2 * sa2, v5 * ca2 + f2
    z2_x, v6, z2_z = v3 * sa2 + z1_x * ca2, v4 * sa2 + v2 * ca2, f3 - v5 * sa2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, x2_z * c3 + y2_z * s3
    v7, v8, v9 = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, y2_z * c3 - x2_z * s3
    y3_x, y3_y, y3_z = v7 * ca3 - z2_x * sa3, v8 * ca3 + v6 * sa3, v9 * ca3 - z2_z * sa3
    z3_x, z3_y, z3_z = v7 * sa3 + z2_x * ca3, v8 * sa3 - v6 * ca3, v9 * sa3 + z2_z * ca3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, x3_y * c4 + y3_y * s4, x3_z * c4 + y3_z * s4
    y5_x, y5_y, y5_z = y3_x * c4 - x3_x * s4, y3_y * c4 - x3_y * s4, y3_z * c4 - x3_z * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, x4_y * c5 + z3_y * s5, x4_z * c5 + z3_z * s5
    z5_x, z5_y, z5_z = z3_x * c5 - x4_x * s5, z3_y * c5 - x4_y * s5, z3_z * c5 - x4_z * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + y5_x * s6, y5_x * c6 - x5_x * s6, z5_x
    T[0, 3] = c1 * a1 + x2_x * a2 + z1_x * d2 + x3_x * a3 + z2_x * d3 + z3_x * d4 + z5_x * d6
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + y5_y * s6, y5_y * c6 - x5_y * s6, z5_y
    T[1, 3] = s1 * a1 + x2_y * a2 - v2 * d2 + x3_y * a3 - v6 * d3 + z3_y * d4 + z5_y * d6
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 + y5_z * s6, y5_z * c6 - x5_z * s6, z5_z
    T[2, 3] = d1 + x2_z * a2 + f1 + x3_z * a3 + z2_z * d3 + z3_z * d4 + z5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y, v1 = c1 * a1, s1 * a1, s1 * ca1
    y1_y, z1_x, v2 = c1 * ca1, s1 * sa1, c1 * sa1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, x2_z = c1 * c2 - v1 * s2, s1 * c2 + y1_y * s2, sa1 * s2
    v3, v4, v5 = v1 * c2 + c1 * s2, y1_y * c2 - s1 * s2, sa1 * c2
    p2_x, p2_y, p2_z = p1_x + x2_x * a2 + z1_x * d2, p1_y + x2_y * a2 - v2 * d2, d1 + x2_z * a2 + f1
    y2_x, y2_y, y2_z = z1_x * sa2 - v3 * ca2, v4 * ca2 - v2 * sa2, v5 * ca2 + f2
    z2_x, v6, z2_z = v3 * sa2 + z1_x * ca2, v4 * sa2 + v2 * ca2, f3 - v5 * sa2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, x2_z * c3 + y2_z * s3
    v7, v8, v9 = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, y2_z * c3 - x2_z * s3
    p3_x, p3_y = p2_x + x3_x * a3 + z2_x * d3, p2_y + x3_y * a3 - v6 * d3
    p3_z, y3_x, y3_y = p2_z + x3_z * a3 + z2_z * d3, v7 * ca3 - z2_x * sa3, v8 * ca3 + v6 * sa3
    y3_z, z3_x, z3_y = v9 * ca3 - z2_z * sa3, v7 * sa3 + z2_x * ca3, v8 * sa3 - v6 * ca3
    z3_z = v9 * sa3 + z2_z * ca3
    c4, s4, p4_x = math.cos(q[3]), math.sin(q[3]), p3_x + z3_x * d4
    p4_y, p4_z, z4_x = p3_y + z3_y * d4, p3_z + z3_z * d4, x3_x * s4 - y3_x * c4
    z4_y, z4_z = x3_y * s4 - y3_y * c4, x3_z * s4 - y3_z * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    z5_x, z5_y = z3_x * c5 - (x3_x * c4 + y3_x * s4) * s5, z3_y * c5 - (x3_y * c4 + y3_y * s4) * s5
    z5_z, p6_x, p6_y = z3_z * c5 - (x3_z * c4 + y3_z * s4) * s5, p4_x + z5_x * d6, p4_y + z5_y * d6
    p6_z, v10, v11 = p4_z + z5_z * d6, p6_x - p1_x, p6_y - p1_y
    v12, v13, v14 = p6_z - d1, p6_x - p2_x, p6_y - p2_y
    v15, v16, v17 = p6_z - p2_z, p6_x - p3_x, p6_y - p3_y
    v18, v19, v20 = p6_z - p3_z, p6_x - p4_x, p6_y - p4_y
    v21 = p6_z - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, -(v2 * v12 + ca1 * v11), -(v6 * v15 + z2_z * v14)
    J[0, 3], J[0, 4] = z3_y * v18 - z3_z * v17, z4_y * v21 - z4_z * v20
    J[0, 5] = z5_y * v21 - z5_z * v20
    J[1, 0], J[1, 1], J[1, 2] = p6_x, ca1 * v10 - z1_x * v12, z2_z * v13 - z2_x * v15
    J[1, 3], J[1, 4] = z3_z * v16 - z3_x * v18, z4_z * v19 - z4_x * v21
    J[1, 5] = z5_z * v19 - z5_x * v21
    J[2, 1], J[2, 2] = z1_x * v11 + v2 * v10, z2_x * v14 + v6 * v13
    J[2, 3], J[2, 4] = z3_x * v17 - z3_y * v16, z4_x * v20 - z4_y * v19
    J[2, 5] = z5_x * v20 - z5_y * v19
    J[3, 1], J[3, 2], J[3, 3] = z1_x, z2_x, z3_x
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = -v2, -v6, z3_y
    J[4, 4], J[4, 5] = z4_y, z5_y
    J[5, 0], J[5, 1], J[5, 2] = 1.0, ca1, z2_z
    J[5, 3], J[5, 4], J[5, 5] = z3_z, z4_z, z5_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 9: U1 A6^-1 [3, 4] and the squared length of column 4 of U1 A6^-1
    wz = T34 - T33 * d6
    v1 = wz * ca1 - k6
    wy = T24 - d6 * T23
    R1c1 = wy * sa1
    wx = T14 - d6 * T13
    v2, v3 = sa1 * wx, wx * wx + (wy * wy + (wz * (wz - k7) + k8))
    R2c1 = 2.0 * (wx * a1)
    R2s1 = 2.0 * (wy * a1)
    v4, v5, v6 = k4 * v3 + k5 * -v1, k4 * R2c1 - k5 * R1c1, k4 * R2s1 + k5 * v2
    v7, v8, v9 = k3 * -v1 + k2 * v3, k3 * R1c1 - k2 * R2c1, k3 * v2 + k2 * R2s1
    v10, v11, v12 = v5 * v5, v6 * v6, 2.0 * v4
    v13, v14, v15 = v8 * v8, v9 * v9, 2.0 * v7
    v16, v17 = v4 * v4 + k9 * (v10 + v11) + (v7 * v7 + k9 * (v13 + v14)), v8 * v15 - v5 * v12
    v18, v19, v20 = v6 * v12 + v9 * v15, k9 * (v10 - v11) + k9 * (v13 - v14), v5 * v6 - v8 * v9
    v21 = v16 - k10
    free1 = abs(v21) + abs(v17) + abs(v18) + abs(v19) + abs(v20) <= free_limit6
    x1_roots, x1_close = _circle_roots(1.0 if free1 else v21, -1.0 if free1 else v17, 0.0 if free1
        else -v18, 0.0 if free1 else v19, 0.0 if free1 else v20, square_rounding * (v16 + k10),
        moved)

    # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    v22, v23, v24 = ca1 * wy, ca1 * wx, sa1 * (wz - d1)

    # theta4, type 2: U4[3, 3]
    v26, v27, v28 = ca1 * T23, ca1 * T13, T33 * sa1
    v32, v33, v34 = T23 * sa1, sa1 * T13, T33 * ca1

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v40, v42, v51 = T32 * sa1, T32 * ca1, T31 * sa1
    v53 = T31 * ca1

    # theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1]
    v62, v63, v65 = T21 * sa1, sa1 * T11, T22 * sa1
    v66 = sa1 * T12

    for i1 in range(4):  # root1, root2, root3, root4
        x1 = x1_roots[i1]
        # theta1
        if not (x1 <= 4.0):
            continue  # out of reach
        q1 = seed[0] if free1 else x1
        c1, s1 = math.cos(q1), math.sin(q1)

        # theta3, type 3: U1 A6^-1 [3, 4] and the squared length of column 4 of U1 A6^-1
        Z1_3 = v1 + (v2 * s1 - R1c1 * c1)
        Z2_3 = v3 - (R2c1 * c1 + R2s1 * s1)
        s3, c3 = (k3 * Z1_3 - k2 * Z2_3) * k11, (k4 * Z2_3 - k5 * Z1_3) * k11
        q3 = _atan2(s3, c3)

        # theta2
        X1_2 = a2 + (a3 * c3 - s3 * k12)
        Y1_2 = c3 * k14 + s3 * k15 - k16
        Z1_2 = v24 - (s1 * v23 - c1 * v22)
        Z2_2 = wx * c1 + wy * s1 - a1
        S2 = X1_2 * Z1_2 - Y1_2 * Z2_2
        C2 = X1_2 * Z2_2 - Z1_2 * -Y1_2
        w2 = math.sqrt(S2 * S2 + C2 * C2)
        free2 = w2 <= free_limit_squared2
        near2 = w2 <= near_limit_squared2
        factor2 = 1.0 / (1.0 if free2 else w2)
        c2 = math.cos(seed[1]) if free2 else C2 * factor2
        s2 = math.sin(seed[1]) if free2 else S2 * factor2
        q2 = _atan2(s2, c2)

        # theta4
        v25, v29 = T13 * c1 + T23 * s1, s1 * v27 - c1 * v26 - v28
        v30, v31 = ca2 * v29, ca2 * v25
        Z1_5 = s1 * v33 - c1 * v32 + v34
        v35 = c2 * (c3 * v25 - s3 * v30) - s2 * (c3 * v29 + s3 * v31) + sa2 * (s3 * Z1_5)
        v36 = (
            c2 * (c3 * (ca3 * v30) + s3 * (ca3 * v25) + sa3 * (sa2 * v29)) + s2 * (c3 * (ca3 * v31)
            - s3 * (ca3 * v29) + sa3 * (sa2 * v25)) + (sa3 * (ca2 * Z1_5) - c3 * (ca3 * (sa2 *
            Z1_5)))
        )
        v37 = v35 * v35 + v36 * v36
        w4 = math.sqrt(v37)
        free4 = w4 <= free_limit
        near4 = v37 <= near_limit_squared
        divisor4 = 1.0 if free4 else w4

        # theta6
        v38, v39 = T12 * c1 + T22 * s1, T22 * c1 - T12 * s1
        v41, v43 = ca1 * v39 + v40, v42 - sa1 * v39
        v44, v45 = c2 * v38 + s2 * v41, c2 * v41 - s2 * v38
        v46 = ca2 * v45 + sa2 * v43
        v47, v48 = c3 * v44 + s3 * v46, ca3 * (c3 * v46 - s3 * v44) - sa3 * (ca2 * v43 - sa2 * v45)
        v49, v50 = T11 * c1 + T21 * s1, T21 * c1 - T11 * s1
        v52, v54 = ca1 * v50 + v51, v53 - sa1 * v50
        v55, v56 = c2 * v49 + s2 * v52, c2 * v52 - s2 * v49
        v57 = ca2 * v56 + sa2 * v54
        v58, v59 = c3 * v55 + s3 * v57, ca3 * (c3 * v57 - s3 * v55) - sa3 * (ca2 * v54 - sa2 * v56)

        # theta5
        v60, v61 = sa2 * s3, c3 * k17 - k13
        Y1_5 = k1 * c3 + k18
        v64, v67, v68 = v53 + (s1 * v63 - c1 * v62), v42 + (s1 * v66 - c1 * v65), Z1_5 * Y1_5

        for i2 in range(2):  # noflip, flip
            e4 = 1.0 - 2.0 * i2
            # theta4
            if e4 < 0.0 and free4:
                continue  # both signs give the same
            factor4 = e4 / divisor4
            c4 = math.cos(seed[3]) if free4 else v35 * factor4
            s4 = math.sin(seed[3]) if free4 else -(v36 * factor4)
            q4 = _atan2(s4, c4)

            # theta6
            c6, s6 = c4 * v48 - s4 * v47, c4 * v59 - s4 * v58
            q6 = _atan2(s6, c6)

            # theta5
            Y2_5 = c4 * v60 + s4 * v61
            Z2_5 = c6 * v64 - s6 * v67
            S5 = Z1_5 * Y2_5 - Y1_5 * Z2_5
            v69 = Y2_5 * Z2_5 + v68
            w5 = math.sqrt(S5 * S5 + v69 * v69)
            free5 = w5 <= free_limit_squared
            near5 = w5 <= near_limit_squared
            v70 = 1.0 / (1.0 if free5 else w5)
            c5 = math.cos(seed[4]) if free5 else v69 * v70
            s5 = math.sin(seed[4]) if free5 else -(S5 * v70)
            q5 = _atan2(s5, c5)
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
            q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
            status[row] = (
                FREE_JOINT if free1 or free2 or free4 or free5 else _status.CLOSE if x1_close[i1] or
                near2 or near4 or near5 else OK
            )


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "pose", apart=(_circle.OWN.compile_apart, _runtime("complete").compile_apart,),
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
