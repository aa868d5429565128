# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 8f549a90cc09d617
"""general_6r: General arm with six revolute joints.

Inverse kinematics, generated from robots/general_6r.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/general_6r.yaml. The formulas and where they come from: general_6r.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 6), _runtime("arrays").zeros

NAME = "general_6r"
METHOD = "general 6R"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
)
MAX_SOLUTIONS = 16

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = -0.035  # joint offset 1 [m]
a1 = 0.416  # link length 1 [m]
ca1 = 0.21607853588096199  # cosine of twist 1
sa1 = 0.9763759861505914  # sine of twist 1
d2 = -0.257  # joint offset 2 [m]
a2 = -0.339  # link length 2 [m]
ca2 = 0.9781157489708037  # cosine of twist 2
sa2 = 0.20806148517994336  # sine of twist 2
d3 = -0.272  # joint offset 3 [m]
a3 = 0.075  # link length 3 [m]
ca3 = 0.8053132584046545  # cosine of twist 3
sa3 = 0.5928495220860671  # sine of twist 3
d4 = 0.262  # joint offset 4 [m]
a4 = -0.28  # link length 4 [m]
ca4 = 0.45217616214091205  # cosine of twist 4
sa4 = 0.8919286509533796  # sine of twist 4
d5 = -0.167  # joint offset 5 [m]
a5 = -0.136  # link length 5 [m]
ca5 = 0.9895059058723947  # cosine of twist 5
sa5 = 0.1444924297105264  # sine of twist 5
d6 = -0.477  # joint offset 6 [m]
a6 = 0.175  # link length 6 [m]
ca6 = 0.13835111738308337  # cosine of twist 6
sa6 = 0.9903832431533018  # sine of twist 6
offset1 = 2.137  # offset of joint 1 [rad]
offset2 = -2.341  # offset of joint 2 [rad]
offset3 = -1.611  # offset of joint 3 [rad]
offset4 = 0.482  # offset of joint 4 [rad]
offset5 = 0.126  # offset of joint 5 [rad]
offset6 = 1.904  # offset of joint 6 [rad]
f1 = -0.05553218372140723  # d2 * ca1 [m]
f2 = 0.04495762109090063  # sa2 * ca1
f3 = 0.2113498189597218  # ca2 * ca1
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16, size=2.8909999999999996, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0, zero=2.137),
        _joints.Joint(place=1, zero=-2.341),
        _joints.Joint(place=2, zero=-1.611),
        _joints.Joint(place=3, zero=0.482),
        _joints.Joint(place=4, zero=0.126),
        _joints.Joint(place=5, zero=1.904),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.416, 0.0, 0.21607853588096199, -0.9763759861505914, 0.0, 0.0,
                0.9763759861505914, 0.21607853588096199, -0.035,
            ),
            offset=2.137,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -0.339, 0.0, -0.9781157489708037, -0.20806148517994336, 0.0, 0.0,
                0.20806148517994336, -0.9781157489708037, -0.257,
            ),
            offset=-2.341,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.075, 0.0, -0.8053132584046545, 0.5928495220860671, 0.0, 0.0,
                -0.5928495220860671, -0.8053132584046545, -0.272,
            ),
            offset=-1.611,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -0.28, 0.0, -0.45217616214091205, 0.8919286509533796, 0.0, 0.0,
                -0.8919286509533796, -0.45217616214091205, 0.262,
            ),
            offset=0.482,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -0.136, 0.0, 0.9895059058723947, -0.1444924297105264, 0.0, 0.0,
                0.1444924297105264, 0.9895059058723947, -0.167,
            ),
            offset=0.126,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.175, 0.0, 0.13835111738308337, -0.9903832431533018, 0.0, 0.0,
                0.9903832431533018, 0.13835111738308337, -0.477,
            ),
            offset=1.904,
        ),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
    miss_weights=(0.3459, 0.3459, 0.3459, 1.0, 1.0, 1.0), size=2.8909999999999996,
    clamped_again=1e-10,
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (2.137, -0.035, 0.416, 1.353),
    (-2.341, -0.257, -0.339, 2.932),
    (-1.611, -0.272, 0.075, -2.507),
    (0.482, 0.262, -0.28, -2.04),
    (0.126, -0.167, -0.136, 0.145),
    (1.904, -0.477, 0.175, 1.432),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    v1 = q[0] + offset1
    c1, s1 = math.cos(v1), math.sin(v1)
    v2, y1_y, z1_x = s1 * ca1, c1 * ca1, s1 * sa1
    v3, v4 = c1 * sa1, q[1] + offset2
    c2, s2 = math.cos(v4), math.sin(v4)
    x2_x, x2_y, x2_z = c1 * c2 - v2 * s2, s1 * c2 + y1_y * s2, sa1 * s2
    v5, v6, v7 = v2 * c2 + c1 * s2, y1_y * c2 - s1 * s2, sa1 * c2
    y2_x, v8, y2_z = v5 * ca2 + z1_x * sa2, v6 * ca2 + v3 * sa2, f2 - v7 * ca2
    z2_x, z2_y, v9 = v5 * sa2 - z1_x * ca2, v3 * ca2 - v6 * sa2, v7 * sa2 + f3
    v10 = q[2] + offset3
    c3, s3 = math.cos(v10), math.sin(v10)
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 - v8 * s3, x2_z * c3 + y2_z * s3
    v11, v12, v13 = y2_x * c3 - x2_x * s3, v8 * c3 + x2_y * s3, y2_z * c3 - x2_z * s3
    v14, y3_y, y3_z = v11 * ca3 + z2_x * sa3, v12 * ca3 - z2_y * sa3, v9 * sa3 - v13 * ca3
    z3_x, v15, z3_z = v11 * sa3 - z2_x * ca3, v12 * sa3 + z2_y * ca3, v13 * sa3 + v9 * ca3
    v16 = q[3] + offset4
    c4, s4 = math.cos(v16), math.sin(v16)
    x4_x, x4_y, x4_z = x3_x * c4 - v14 * s4, x3_y * c4 + y3_y * s4, x3_z * c4 + y3_z * s4
    v17, v18, v19 = v14 * c4 + x3_x * s4, y3_y * c4 - x3_y * s4, y3_z * c4 - x3_z * s4
    y4_x, y4_y, v20 = v17 * ca4 - z3_x * sa4, v15 * sa4 - v18 * ca4, v19 * ca4 + z3_z * sa4
    v21, z4_y, z4_z = v17 * sa4 + z3_x * ca4, v18 * sa4 + v15 * ca4, v19 * sa4 - z3_z * ca4
    v22 = q[4] + offset5
    c5, s5 = math.cos(v22), math.sin(v22)
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, x4_z * c5 - v20 * s5
    v23, v24, v25 = y4_x * c5 - x4_x * s5, y4_y * c5 - x4_y * s5, v20 * c5 + x4_z * s5
    y5_x, y5_y, y5_z = v23 * ca5 - v21 * sa5, v24 * ca5 + z4_y * sa5, z4_z * sa5 - v25 * ca5
    v26, z5_y, z5_z = v23 * sa5 + v21 * ca5, z4_y * ca5 - v24 * sa5, v25 * sa5 + z4_z * ca5
    v27 = q[5] + offset6
    c6, s6 = math.cos(v27), math.sin(v27)
    x6_x, x6_y, x6_z = x5_x * c6 + y5_x * s6, x5_y * c6 + y5_y * s6, x5_z * c6 + y5_z * s6
    v28, v29, v30 = y5_x * c6 - x5_x * s6, y5_y * c6 - x5_y * s6, y5_z * c6 - x5_z * s6
    T[0, 0], T[0, 1], T[0, 2] = x6_x, v28 * ca6 - v26 * sa6, -(v28 * sa6 + v26 * ca6)
    T[0, 3] = (
        c1 * a1 + x2_x * a2 + z1_x * d2 + x3_x * a3 + z2_x * d3 + x4_x * a4 + z3_x * d4 + x5_x * a5
        - v21 * d5 + x6_x * a6 - v26 * d6
    )
    T[1, 0], T[1, 1], T[1, 2] = x6_y, v29 * ca6 + z5_y * sa6, z5_y * ca6 - v29 * sa6
    T[1, 3] = (
        s1 * a1 + x2_y * a2 - v3 * d2 + x3_y * a3 + z2_y * d3 + x4_y * a4 - v15 * d4 + x5_y * a5 +
        z4_y * d5 + x6_y * a6 + z5_y * d6
    )
    T[2, 0], T[2, 1], T[2, 2] = x6_z, v30 * ca6 + z5_z * sa6, z5_z * ca6 - v30 * sa6
    T[2, 3] = (
        d1 + x2_z * a2 + f1 + x3_z * a3 - v9 * d3 + x4_z * a4 + z3_z * d4 + x5_z * a5 + z4_z * d5 +
        x6_z * a6 + z5_z * d6
    )
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    v1 = q[0] + offset1
    c1, s1 = math.cos(v1), math.sin(v1)
    p1_x, p1_y, v2 = c1 * a1, s1 * a1, s1 * ca1
    y1_y, z1_x, v3 = c1 * ca1, s1 * sa1, c1 * sa1
    v4 = q[1] + offset2
    c2, s2 = math.cos(v4), math.sin(v4)
    x2_x, x2_y, x2_z = c1 * c2 - v2 * s2, s1 * c2 + y1_y * s2, sa1 * s2
    v5, v6, v7 = v2 * c2 + c1 * s2, y1_y * c2 - s1 * s2, sa1 * c2
    p2_x, p2_y, p2_z = p1_x + x2_x * a2 + z1_x * d2, p1_y + x2_y * a2 - v3 * d2, d1 + x2_z * a2 + f1
    y2_x, v8, y2_z = v5 * ca2 + z1_x * sa2, v6 * ca2 + v3 * sa2, f2 - v7 * ca2
    z2_x, z2_y, v9 = v5 * sa2 - z1_x * ca2, v3 * ca2 - v6 * sa2, v7 * sa2 + f3
    v10 = q[2] + offset3
    c3, s3 = math.cos(v10), math.sin(v10)
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 - v8 * s3, x2_z * c3 + y2_z * s3
    v11, v12, v13 = y2_x * c3 - x2_x * s3, v8 * c3 + x2_y * s3, y2_z * c3 - x2_z * s3
    p3_x, p3_y = p2_x + x3_x * a3 + z2_x * d3, p2_y + x3_y * a3 + z2_y * d3
    p3_z, v14, y3_y = p2_z + x3_z * a3 - v9 * d3, v11 * ca3 + z2_x * sa3, v12 * ca3 - z2_y * sa3
    y3_z, z3_x, v15 = v9 * sa3 - v13 * ca3, v11 * sa3 - z2_x * ca3, v12 * sa3 + z2_y * ca3
    z3_z, v16 = v13 * sa3 + v9 * ca3, q[3] + offset4
    c4, s4 = math.cos(v16), math.sin(v16)
    x4_x, x4_y, x4_z = x3_x * c4 - v14 * s4, x3_y * c4 + y3_y * s4, x3_z * c4 + y3_z * s4
    v17, v18, v19 = v14 * c4 + x3_x * s4, y3_y * c4 - x3_y * s4, y3_z * c4 - x3_z * s4
    p4_x, p4_y = p3_x + x4_x * a4 + z3_x * d4, p3_y + x4_y * a4 - v15 * d4
    p4_z, y4_x, y4_y = p3_z + x4_z * a4 + z3_z * d4, v17 * ca4 - z3_x * sa4, v15 * sa4 - v18 * ca4
    v20, v21, z4_y = v19 * ca4 + z3_z * sa4, v17 * sa4 + z3_x * ca4, v18 * sa4 + v15 * ca4
    z4_z, v22 = v19 * sa4 - z3_z * ca4, q[4] + offset5
    c5, s5 = math.cos(v22), math.sin(v22)
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, x4_z * c5 - v20 * s5
    v23, v24, v25 = y4_x * c5 - x4_x * s5, y4_y * c5 - x4_y * s5, v20 * c5 + x4_z * s5
    p5_x, p5_y = p4_x + x5_x * a5 - v21 * d5, p4_y + x5_y * a5 + z4_y * d5
    p5_z, v26, z5_y = p4_z + x5_z * a5 + z4_z * d5, v23 * sa5 + v21 * ca5, z4_y * ca5 - v24 * sa5
    z5_z, v27 = v25 * sa5 + z4_z * ca5, q[5] + offset6
    c6, s6 = math.cos(v27), math.sin(v27)
    p6_x = p5_x + (x5_x * c6 + (v23 * ca5 - v21 * sa5) * s6) * a6 - v26 * d6
    p6_y = p5_y + (x5_y * c6 + (v24 * ca5 + z4_y * sa5) * s6) * a6 + z5_y * d6
    p6_z, v28 = p5_z + (x5_z * c6 + (z4_z * sa5 - v25 * ca5) * s6) * a6 + z5_z * d6, p6_x - p1_x
    v29, v30, v31 = p6_y - p1_y, p6_z - d1, p6_x - p2_x
    v32, v33, v34 = p6_y - p2_y, p6_z - p2_z, p6_x - p3_x
    v35, v36, v37 = p6_y - p3_y, p6_z - p3_z, p6_x - p4_x
    v38, v39, v40 = p6_y - p4_y, p6_z - p4_z, p6_x - p5_x
    v41, v42 = p6_y - p5_y, p6_z - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, -(v3 * v30 + ca1 * v29), z2_y * v33 + v9 * v32
    J[0, 3], J[0, 4] = -(v15 * v36 + z3_z * v35), z4_y * v39 - z4_z * v38
    J[0, 5] = z5_y * v42 - z5_z * v41
    J[1, 0], J[1, 1], J[1, 2] = p6_x, ca1 * v28 - z1_x * v30, -(v9 * v31 + z2_x * v33)
    J[1, 3], J[1, 4] = z3_z * v34 - z3_x * v36, z4_z * v37 + v21 * v39
    J[1, 5] = z5_z * v40 + v26 * v42
    J[2, 1], J[2, 2] = z1_x * v29 + v3 * v28, z2_x * v32 - z2_y * v31
    J[2, 3], J[2, 4] = z3_x * v35 + v15 * v34, -(v21 * v38 + z4_y * v37)
    J[2, 5] = -(v26 * v41 + z5_y * v40)
    J[3, 1], J[3, 2], J[3, 3] = z1_x, z2_x, z3_x
    J[3, 4], J[3, 5] = -v21, -v26
    J[4, 1], J[4, 2], J[4, 3] = -v3, z2_y, -v15
    J[4, 4], J[4, 5] = z4_y, z5_y
    J[5, 0], J[5, 1], J[5, 2] = 1.0, ca1, -v9
    J[5, 3], J[5, 4], J[5, 5] = z3_z, z4_z, z5_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.6647515517960572, reach=4.000000004,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.625797711755665, 0.1994571100439649,
            0.08310712918498539, -0.9763759861505914, -0.05692061104264318, 0.9012701410620845,
            0.3755292254425352, 0.21607853588096199, -4.005433883479374e-11,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, -0.5099649622239675, -0.863043307915415,
            -0.46028976422155465, -0.20806148517994336, 0.10646134679468323, 0.18358366339406768,
            0.09791128714350275, -0.9781157489708037, 0.05557591778869785,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.11282410668671844, -0.7731007280684683, -0.22548771235330328,
            0.5928495220860671, 0.13178733217844682, -0.5691355412026244, -0.1659978661840988,
            -0.8053132584046545, -0.07651018689267303,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, -0.4212099982970823, -0.3274379105158329,
            -0.31184562906269797, 0.8919286509533796, 0.06330373161268073, -0.6458793679317576,
            -0.6151232075540549, -0.45217616214091205, 0.1397447250289724,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, -0.20458771345858281, 0.9360191001495627,
            0.3209208343369929, -0.14449242971052642, -0.046066283414697685, 0.13668202810455202,
            0.04686240963584641, 0.9895059058723948, -0.0067268214344506985,
        )),
        _loops.Link((
            0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, 0.026626183228620606,
        )),
        _loops.Link((
            1.0, 0.0, 0.0, -0.175, 0.0, 0.1383511173830834, 0.990383243153302, 0.682307145579463,
            0.0, -0.990383243153302, 0.1383511173830834, 0.09531457306246946,
        )),
    ),
    advances=(
        (0.6, 0.8),
        (0.38461538461538464, 0.9230769230769231),
        (0.47058823529411764, 0.8823529411764706),
        (0.28, 0.96),
        (0.6896551724137931, 0.7241379310344828),
        (0.32432432432432434, 0.9459459459459459),
    ),
    formulations=(
        _loops.Formulation(joints=(5, 0, 1, 2, 3, 4), sign=1.0),
        _loops.Formulation(joints=(3, 4, 5, 0, 1, 2), sign=1.0),
    ),
)
_NUMBERS = _loops.general_numbers(_LINKS, _LOOP)
_all_joints = _runtime("general.rows").all_joints
_NO_FREE = _runtime("arrays").NONE_GIVEN


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _all_joints(_NUMBERS, pose, _NO_FREE, seed, q, status)


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "pose", apart=(_whole.compile_apart,), at_once=True,
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
