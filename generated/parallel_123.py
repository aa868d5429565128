# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 7a430d01fc79c886
"""parallel_123: Arm whose axes 1, 2 and 3 are parallel.

Inverse kinematics, generated from robots/parallel_123.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/parallel_123.yaml. The formulas and where they come from:
parallel_123.md.

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
_circle = _runtime("circle_roots")
_circle_roots = _circle.circle_roots
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 6), _runtime("arrays").zeros

NAME = "parallel_123"
METHOD = "quartic"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "root1-right", "root1-left", "root2-right", "root2-left", "root3-right", "root3-left",
    "root4-right", "root4-left",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, d1 = 0.1 [m], d2 = 0.05 [m], d3 = 0.08 [m].
a1 = 0.3  # link length 1 [m]
a2 = 0.25  # link length 2 [m]
a3 = 0.1  # link length 3 [m]
d4 = 0.2  # joint offset 4 [m]
a4 = 0.1  # link length 4 [m]
sqrt3 = 1.7320508075688772  # square root of 3
d5 = 0.15  # joint offset 5 [m]
a5 = 0.12  # link length 5 [m]
ca5 = 0.17364817766693041  # cosine of twist 5
sa5 = 0.984807753012208  # sine of twist 5
d6 = 0.1  # joint offset 6 [m]
a6 = 0.05  # link length 6 [m]
free_limit2 = 2.5599999999999996e-12  # a length that fixes no angle [m^2]
square_rounding = 1e-15  # squares are rounded by this
near_limit = 0.001  # a length whose direction is good to few digits
double_root = 1e-13  # a polynomial's value at a root, relative to its coefficients
free_limit_squared = 1e-24  # square of a length that fixes no angle
near_limit_squared = 1e-06  # square of a length whose direction is good to few digits
longest2 = 0.30250000000000005  # square of the longest reach [m^2]
shortest2 = 0.0024999999999999988  # square of the shortest reach [m^2]
longest2_reach = 0.30251760025600005  # the longest, with what rounding adds [m^2]
shortest2_reach = 0.0024984002559999986  # the shortest, with what rounding adds [m^2]
longest2_apart = 0.30249999999998245  # the longest, where branches merge [m^2]
shortest2_apart = 0.002500000000001599  # the shortest, where branches merge [m^2]
longest2_clear = 0.30249999998240007  # the longest, where blurred branches do [m^2]
shortest2_clear = 0.002500000001599999  # the shortest, where blurred branches do [m^2]
free_limit_squared2 = 2.5599999999999994e-24  # square of a length that fixes no angle [m^2]
# square of a length whose direction is good to few digits [m^2]
near_limit_squared2 = 2.5599999999999996e-06
k1 = 0.5  # 1 / 2
k2 = 0.8660254037844386  # sqrt3 * 1 / 2
k3 = 0.12604722665003956  # d5 * ca5 + d6 [m]
k4 = 0.23  # d1 + (d2 + d3) [m]
k5 = 0.1477211629518312  # sa5 * d5 [m]
k6 = 0.0075  # (sqrt3 * 1 / 2 * a4)^2 [m^2]
k7 = -11.547005383792515  # -1 / (sqrt3 * 1 / 2 * a4) [m^-1]
k8 = 0.8528685319524432  # sa5 * sqrt3 * 1 / 2
k9 = 1.1906015685221298  # 1 / (sa5 * sqrt3 * 1 / 2 * sa5)
k10 = 0.008682408883346522  # a6 * ca5 [m]
k11 = 0.0984807753012208  # d6 * sa5 [m]
k12 = 0.2  # 2 * a4 [m]
k13 = 0.0492403876506104  # a6 * sa5 [m]
k14 = 0.16736481776669304  # d5 + d6 * ca5 [m]
k15 = 0.567364817766693  # d4 * 2 + k14 [m]
k16 = 0.1525  # a1^2 + a2^2 [m^2]
k17 = 6.666666666666667  # 1 / (2 * a2 * a1) [m^-2]
k18 = 0.55  # d4 * 2 + d5 [m]
k19 = 0.25980762113533157  # d5 * sqrt3 [m]
f1 = 0.23  # d1 + d2 + d3 [m]
g1 = 0.23  # d1 + d2 + d3 [m]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=8, size=1.5999999999999999, coordinates=(0, 1, 2), directions="rotation",
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
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.3, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.1)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.25, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.05)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.1, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.08)),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.1, 0.0, 0.5, -0.8660254037844386, 0.0, 0.0, 0.8660254037844386, 0.5,
            0.2,
        )),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.12, 0.0, 0.17364817766693041, -0.984807753012208, 0.0, 0.0,
            0.984807753012208, 0.17364817766693041, 0.15,
        )),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.05, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.1)),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.625, 0.625, 0.625, 1.0, 1.0, 1.0), size=1.5999999999999999,
    entries=(0, 2, 3, 4, 6, 7, 8, 10, 11), steps=("retries", "completes", "merges", "follows seed"),
    choosable=(5, 2, 1, 0), root_turns=((5, 1.0),),
), _joints.arm_numbers(_LINKS))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.1, 0.3, 0.0),
    (0.0, 0.05, 0.25, 0.0),
    (0.0, 0.08, 0.1, 1.5707963267948966),
    (0.0, 0.2, 0.1, 1.0471975511965976),
    (0.0, 0.15, 0.12, 1.3962634015954636),
    (0.0, 0.1, 0.05, 0.0),
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
    x2_x, x2_y = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y = x2_x * c3 - x2_y * s3, x2_y * c3 + x2_x * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, v1 = x3_x * c4, x3_y * c4, x3_x * s4
    v2, y4_z, y4_x = x3_y * s4, c4 * k1, x3_y * k2 - v1 * k1
    y4_y, v3, z4_x = -x3_x * k2 - v2 * k1, c4 * k2, v1 * k2 + x3_y * k1
    z4_y = v2 * k2 + -x3_x * k1
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, s4 * c5 + y4_z * s5
    v4, v5, v6 = y4_x * c5 - x4_x * s5, y4_y * c5 - x4_y * s5, y4_z * c5 - s4 * s5
    y5_x, y5_y, y5_z = v4 * ca5 + z4_x * sa5, v5 * ca5 + z4_y * sa5, v6 * ca5 - v3 * sa5
    z5_x, z5_y, v7 = z4_x * ca5 - v4 * sa5, z4_y * ca5 - v5 * sa5, v6 * sa5 + v3 * ca5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    x6_x, x6_y, x6_z = x5_x * c6 + y5_x * s6, x5_y * c6 + y5_y * s6, x5_z * c6 + y5_z * s6
    T[0, 0], T[0, 1], T[0, 2] = x6_x, y5_x * c6 - x5_x * s6, z5_x
    T[0, 3] = (
        c1 * a1 + x2_x * a2 + x3_x * a3 + x4_x * a4 + x3_y * d4 + x5_x * a5 + z4_x * d5 + x6_x * a6
        + z5_x * d6
    )
    T[1, 0], T[1, 1], T[1, 2] = x6_y, y5_y * c6 - x5_y * s6, z5_y
    T[1, 3] = (
        s1 * a1 + x2_y * a2 + x3_y * a3 + x4_y * a4 + -x3_x * d4 + x5_y * a5 + z4_y * d5 + x6_y * a6
        + z5_y * d6
    )
    T[2, 0], T[2, 1], T[2, 2] = x6_z, y5_z * c6 - x5_z * s6, -v7
    T[2, 3] = f1 + s4 * a4 + x5_z * a5 - v3 * d5 + x6_z * a6 - v7 * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * a1, s1 * a1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    p2_x, p2_y = p1_x + x2_x * a2, p1_y + x2_y * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y = x2_x * c3 - x2_y * s3, x2_y * c3 + x2_x * s3
    p3_x, p3_y = p2_x + x3_x * a3, p2_y + x3_y * a3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, v1 = x3_x * c4, x3_y * c4, x3_x * s4
    v2, p4_z, p4_x = x3_y * s4, g1 + s4 * a4, p3_x + x4_x * a4 + x3_y * d4
    p4_y, y4_z, y4_x = p3_y + x4_y * a4 + -x3_x * d4, c4 * k1, x3_y * k2 - v1 * k1
    y4_y, v3, z4_x = -x3_x * k2 - v2 * k1, c4 * k2, v1 * k2 + x3_y * k1
    z4_y = v2 * k2 + -x3_x * k1
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, s4 * c5 + y4_z * s5
    v4, v5, v6 = y4_x * c5 - x4_x * s5, y4_y * c5 - x4_y * s5, y4_z * c5 - s4 * s5
    p5_x, p5_y = p4_x + x5_x * a5 + z4_x * d5, p4_y + x5_y * a5 + z4_y * d5
    p5_z, z5_x, z5_y = p4_z + x5_z * a5 - v3 * d5, z4_x * ca5 - v4 * sa5, z4_y * ca5 - v5 * sa5
    v7 = v6 * sa5 + v3 * ca5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    p6_x = p5_x + (x5_x * c6 + (v4 * ca5 + z4_x * sa5) * s6) * a6 + z5_x * d6
    p6_y = p5_y + (x5_y * c6 + (v5 * ca5 + z4_y * sa5) * s6) * a6 + z5_y * d6
    p6_z = p5_z + (x5_z * c6 + (v6 * ca5 - v3 * sa5) * s6) * a6 - v7 * d6
    v8, v9, v10 = p6_z - g1, p6_x - p4_x, p6_y - p4_y
    v11, v12, v13 = p6_z - p4_z, p6_x - p5_x, p6_y - p5_y
    v14 = p6_z - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, p1_y - p6_y, p2_y - p6_y
    J[0, 3], J[0, 4], J[0, 5] = -x3_x * v8, z4_y * v11 + v3 * v10, z5_y * v14 + v7 * v13
    J[1, 0], J[1, 1], J[1, 2] = p6_x, p6_x - p1_x, p6_x - p2_x
    J[1, 3], J[1, 4], J[1, 5] = -(x3_y * v8), -(v3 * v9 + z4_x * v11), -(v7 * v12 + z5_x * v14)
    J[2, 3], J[2, 4] = x3_y * (p6_y - p3_y) - -x3_x * (p6_x - p3_x), z4_x * v10 - z4_y * v9
    J[2, 5] = z5_x * v13 - z5_y * v12
    J[3, 3], J[3, 4], J[3, 5] = x3_y, z4_x, z5_x
    J[4, 3], J[4, 4], J[4, 5] = -x3_x, z4_y, z5_y
    J[5, 0], J[5, 1], J[5, 2] = 1.0, 1.0, 1.0
    J[5, 4], J[5, 5] = -v3, -v7
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta6, type 9: U0 (A5 A6)^-1 [3, 4] and U0 (A5 A6)^-1 [3, 3]
    R1_6 = T31 * a6 + (T33 * k3 + (k4 - T34))
    R1c6 = T31 * a5 + sa5 * (T32 * d5)
    R1s6 = T31 * k5 - T32 * a5
    v1, v2, v3 = T33 * ca5, T32 * sa5, T31 * sa5
    v4, v5, v6 = a4 * v1, a4 * v2, a4 * v3
    v7, v8, v9 = k2 * R1_6, k2 * R1c6, k2 * R1s6
    v10, v11, v12 = v5 * v5, v6 * v6, 2.0 * v4
    v13, v14, v15 = v8 * v8, v9 * v9, 2.0 * v7
    v16, v17 = v4 * v4 + k1 * (v10 + v11) + (v7 * v7 + k1 * (v13 + v14)), v5 * v12 + v8 * v15
    v18, v19, v20 = v6 * v12 + v9 * v15, k1 * (v10 - v11) + k1 * (v13 - v14), v5 * v6 + v8 * v9
    v21 = v16 - k6
    v22 = abs(v21) + abs(v17) + abs(v18) + abs(v19) + abs(v20)
    free6 = v22 <= free_limit2
    v23 = square_rounding * (v16 + k6)
    x6_roots, x6_close = _circle_roots(1.0 if free6 else v21, -1.0 if free6 else v17, 0.0 if free6
        else v18, 0.0 if free6 else v19, 0.0 if free6 else v20, v23, moved)
    v26 = math.cos(seed[5]) * math.cos(seed[5]) - math.sin(seed[5]) * math.sin(seed[5])
    v27, v28, v29 = 2.0 * (math.cos(seed[5]) * math.sin(seed[5])), 2.0 * v20, 2.0 * v19
    v31 = v22 * near_limit
    v32 = v26 * v28 + (v18 * math.cos(seed[5]) - v17 * math.sin(seed[5])) - v27 * v29
    v33 = (
        abs(v21 + (v20 * v27 + (v19 * v26 + (v17 * math.cos(seed[5]) + v18 * math.sin(seed[5])))))
        <= v23 + v22 * double_root
    )

    # theta123, type 3: U0 (A5 A6)^-1 [2, 3] and U0 (A5 A6)^-1 [1, 3]
    v35, v36, v37 = sa5 * T22, sa5 * T21, ca5 * T23
    v38, v39, v40 = sa5 * T12, sa5 * T11, ca5 * T13
    v41 = seed[0] + seed[1] + seed[2]

    # theta5, type 3: U3[3, 3] and U4[1, 3]
    v42, v43 = 2.0 * T23, 2.0 * T13

    # theta2, type 8: U0[1, 4] and U0[2, 4]
    v55, v56 = 2.0 * T14, 2.0 * T24

    # theta1, type 3: U0 A6^-1 [2, 4] and U0 A6^-1 [1, 4]
    wy = T24 - a6 * T21 - d6 * T23
    v58 = 2.0 * wy
    wx = T14 - a6 * T11 - d6 * T13
    v59 = 2.0 * wx

    for i1 in range(4):  # root1, root2, root3, root4
        x6 = x6_roots[i1]
        # theta6
        if not (x6 <= 4.0):
            continue  # out of reach
        v24, v25 = math.cos(x6), math.sin(x6)
        v30 = (v24 * v24 - v25 * v25) * v28 + (v18 * v24 - v17 * v25) - 2.0 * (v24 * v25) * v29
        near6 = abs(v30) <= v31
        same6 = (
            -(double_root * (v22 * v22)) <= v30 * v32 and 0.0 < v24 * math.cos(seed[5]) + v25 *
            math.sin(seed[5]) and abs(v24 * math.sin(seed[5]) - v25 * math.cos(seed[5])) <=
            near_limit and near6 and v33
        )
        v34 = seed[5] if same6 else x6
        q6 = seed[5] if free6 else v34
        c6, s6 = math.cos(q6), math.sin(q6)

        # theta4, type 3: U0 (A5 A6)^-1 [3, 4] and U0 (A5 A6)^-1 [3, 3]
        s4, c4 = k2 * (R1_6 + (R1c6 * c6 + R1s6 * s6)) * k7, a4 * (v1 + (v2 * c6 + v3 * s6)) * k7
        q4 = _atan2(s4, c4)

        # theta123
        X1_123 = k1 * (sqrt3 * s4)
        Z1_123 = c6 * v35 + s6 * v36 + v37
        Z2_123 = c6 * v38 + s6 * v39 + v40
        S123 = X1_123 * Z1_123 + k1 * Z2_123
        C123 = X1_123 * Z2_123 - k1 * Z1_123
        w123 = math.sqrt(S123 * S123 + C123 * C123)
        free123 = w123 <= free_limit_squared
        near123 = w123 <= near_limit_squared
        factor123 = 1.0 / (1.0 if free123 else w123)
        c123 = math.cos(v41) if free123 else C123 * factor123
        s123 = math.sin(v41) if free123 else S123 * factor123
        theta123 = _atan2(s123, c123)

        # theta5
        s5 = k8 * (c123 * (c4 * T13) + s123 * (c4 * T23) + T33 * s4) * k9
        v44 = sa5 * (k1 * (s123 * v43 - c123 * v42 - ca5)) * k9
        q5 = _atan2(s5, -v44)

        # theta2
        v45, v46 = a5 + a6 * c6, s6 * k10 - k11
        v47, v48, v49 = c4 * (2.0 * v45) + s4 * -v46, sqrt3 * v46, c4 * (2.0 * v46) + s4 * v45
        v50, v51, v52 = sqrt3 * v45, c4 * k12, s6 * k13
        v53, v54 = k12 + (v51 + s4 * (sqrt3 * (v52 + k14))), v52 + k15
        Z1_2 = (
            k1 * (v44 * (c123 * v47 + s123 * v48) + s5 * (c123 * v49 - s123 * v50) + (v55 - (c123 *
            v53 + s123 * v54)))
        )
        Z2_2 = (
            k1 * (s5 * (c123 * v50 + s123 * v49) - v44 * (c123 * v48 - s123 * v47) + (c123 * v54 -
            s123 * v53 + v56))
        )
        N2 = Z1_2 * Z1_2 + Z2_2 * Z2_2
        K2 = N2 - k16
        D2_squared = (longest2 - N2) * (N2 - shortest2)
        apart2 = shortest2_apart < N2 and N2 < longest2_apart
        if not (shortest2_reach <= N2 and N2 <= longest2_reach):
            if near6:
                status[2 * i1] = _status.NEARLY + 6
                q[2 * i1, 0] = D2_squared
                q[2 * i1, 1] = v34
            if free6:
                status[2 * i1] = _status.LOST + 6
                q[2 * i1, 0] = D2_squared
            if free123:
                status[2 * i1] = _status.LOST + 1
                q[2 * i1, 0] = D2_squared
            if free123:
                status[2 * i1] = _status.LOST + 2
                q[2 * i1, 0] = D2_squared
            if free123:
                status[2 * i1] = _status.LOST + 3
                q[2 * i1, 0] = D2_squared
            continue  # out of reach
        w2 = math.sqrt(D2_squared if apart2 else 0.0)
        c2 = K2 * k17

        # theta1
        X1_1 = a1 + a2 * c2
        v57 = k12 + (v51 + s4 * k19)
        Z1_1 = (
            k1 * (v44 * (2.0 * (a5 * (c4 * s123))) + s5 * (a5 * (sqrt3 * c123 + s4 * s123)) + (c123
            * k18 - s123 * v57 + v58))
        )
        Z2_1 = (
            k1 * (v44 * (2.0 * (a5 * (c4 * c123))) + s5 * (a5 * (s4 * c123 - sqrt3 * s123)) + (v59 -
            (c123 * v57 + s123 * k18)))
        )
        v60, v61 = X1_1 * Z1_1, X1_1 * Z2_1

        for i2 in range(2):  # right, left
            e2 = 1.0 - 2.0 * i2
            # theta2
            if (
                e2 < 0.0 and (not apart2 or (near6 and not (shortest2_clear < N2 and N2 <
                longest2_clear)))
            ):
                continue  # both signs give the same
            s2 = w2 * e2 * k17
            q2 = _atan2(s2, c2)

            # theta1
            Y1_1 = a2 * s2
            S1 = v60 - Y1_1 * Z2_1
            C1 = v61 + Y1_1 * Z1_1
            w1 = math.sqrt(S1 * S1 + C1 * C1)
            free1 = w1 <= free_limit_squared2
            near1 = w1 <= near_limit_squared2
            factor1 = 1.0 / (1.0 if free1 else w1)
            c1 = math.cos(seed[0]) if free1 else C1 * factor1
            s1 = math.sin(seed[0]) if free1 else S1 * factor1
            q1 = _atan2(s1, c1)

            # joint values
            q3 = _wrap(theta123 - (q2 + q1))
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
            q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
            status[row] = (
                FREE_JOINT if free123 or free1 or free6 else _status.CLOSE if x6_close[i1] or near6
                or near123 or near1 else OK
            )


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "pose", apart=(_circle.OWN.compile_apart, _runtime("complete").compile_apart,),
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
