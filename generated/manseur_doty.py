# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 049c2906a806dbdc
"""manseur_doty: Arm with 16 real solutions.

Inverse kinematics, generated from robots/manseur_doty.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/manseur_doty.yaml. The formulas and where they come from:
manseur_doty.md.

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

NAME = "manseur_doty"
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

a1 = 0.3  # link length 1 [m]
a2 = 1.0  # link length 2 [m]
ca2 = 0.9998476951563913  # cosine of twist 2
sa2 = 0.01745240643728351  # sine of twist 2
d3 = 0.2  # joint offset 3 [m]
a4 = 1.5  # link length 4 [m]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16, size=3.0, coordinates=(0, 1, 2), directions="rotation",
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
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.3, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0)),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 1.0, 0.0, 0.9998476951563913, -0.01745240643728351, 0.0, 0.0,
            0.01745240643728351, 0.9998476951563913, 0.0,
        )),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.2)),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 1.5, 0.0, 0.9998476951563913, -0.01745240643728351, 0.0, 0.0,
            0.01745240643728351, 0.9998476951563913, 0.0,
        )),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0)),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.0, 0.0, 0.9998476951563913, -0.01745240643728351, 0.0, 0.0,
            0.01745240643728351, 0.9998476951563913, 0.0,
        )),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
    miss_weights=(0.3333, 0.3333, 0.3333, 1.0, 1.0, 1.0), size=3.0, clamped_again=1e-10,
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.3, 1.5707963267948966),
    (0.0, 0.0, 1.0, 0.017453292519943295),
    (0.0, 0.2, 0.0, 1.5707963267948966),
    (0.0, 0.0, 1.5, 0.017453292519943295),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 0.017453292519943295),
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
    v2, y2_z, y2_x = s1 * s2, c2 * ca2, s1 * sa2 - v1 * ca2
    v3, v4, z2_x = v2 * ca2 + c1 * sa2, c2 * sa2, v1 * sa2 + s1 * ca2
    z2_y = v2 * sa2 - c1 * ca2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 - v3 * s3, s2 * c3 + y2_z * s3
    z3_y, z3_x, z3_z = v3 * c3 + x2_y * s3, x2_x * s3 - y2_x * c3, s2 * s3 - y2_z * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + z2_x * s4, x3_y * c4 + z2_y * s4, x3_z * c4 - v4 * s4
    v5, v6, v7 = z2_x * c4 - x3_x * s4, z2_y * c4 - x3_y * s4, v4 * c4 + x3_z * s4
    y4_x, y4_y, y4_z = ca2 * v5 + sa2 * z3_x, ca2 * v6 + sa2 * z3_y, sa2 * z3_z - ca2 * v7
    z4_x, z4_y, z4_z = ca2 * z3_x - sa2 * v5, ca2 * z3_y - sa2 * v6, sa2 * v7 + ca2 * z3_z
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, x4_z * c5 + y4_z * s5
    z5_x, z5_y, z5_z = x4_x * s5 - y4_x * c5, x4_y * s5 - y4_y * c5, x4_z * s5 - y4_z * c5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    v8, v9, v10 = z4_x * c6 - x5_x * s6, z4_y * c6 - x5_y * s6, z4_z * c6 - x5_z * s6
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + z4_x * s6, ca2 * v8 + sa2 * z5_x, ca2 * z5_x - sa2 * v8
    T[0, 3] = c1 * a1 + x2_x * a2 + z2_x * d3 + x4_x * a4
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + z4_y * s6, ca2 * v9 + sa2 * z5_y, ca2 * z5_y - sa2 * v9
    T[1, 3] = s1 * a1 + x2_y * a2 + z2_y * d3 + x4_y * a4
    T[2, 0], T[2, 1] = x5_z * c6 + z4_z * s6, ca2 * v10 + sa2 * z5_z
    T[2, 2], T[2, 3] = ca2 * z5_z - sa2 * v10, s2 * a2 - v4 * d3 + x4_z * a4
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * a1, s1 * a1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2, p2_x, p2_y = s1 * s2, p1_x + x2_x * a2, p1_y + x2_y * a2
    p2_z, y2_z, y2_x = s2 * a2, c2 * ca2, s1 * sa2 - v1 * ca2
    v3, v4, z2_x = v2 * ca2 + c1 * sa2, c2 * sa2, v1 * sa2 + s1 * ca2
    z2_y = v2 * sa2 - c1 * ca2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 - v3 * s3, s2 * c3 + y2_z * s3
    z3_y, p3_x, p3_y = v3 * c3 + x2_y * s3, p2_x + z2_x * d3, p2_y + z2_y * d3
    p3_z, z3_x, z3_z = p2_z - v4 * d3, x2_x * s3 - y2_x * c3, s2 * s3 - y2_z * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + z2_x * s4, x3_y * c4 + z2_y * s4, x3_z * c4 - v4 * s4
    v5, v6, v7 = z2_x * c4 - x3_x * s4, z2_y * c4 - x3_y * s4, v4 * c4 + x3_z * s4
    p4_x, p4_y, p4_z = p3_x + x4_x * a4, p3_y + x4_y * a4, p3_z + x4_z * a4
    c5, s5, v8 = math.cos(q[4]), math.sin(q[4]), p4_x - p2_x
    v9, v10, v11 = p4_y - p2_y, p4_z - p2_z, p4_x - p3_x
    v12, v13 = p4_y - p3_y, p4_z - p3_z
    J[0, 0], J[0, 1], J[0, 2] = -p4_y, -(c1 * p4_z), z2_y * v10 + v4 * v9
    J[0, 3] = z3_y * v13 - z3_z * v12
    J[1, 0], J[1, 1], J[1, 2] = p4_x, -(s1 * p4_z), -(v4 * v8 + z2_x * v10)
    J[1, 3] = z3_z * v11 - z3_x * v13
    J[2, 1], J[2, 2] = s1 * (p4_y - p1_y) + c1 * (p4_x - p1_x), z2_x * v9 - z2_y * v8
    J[2, 3] = z3_x * v12 - z3_y * v11
    J[3, 1], J[3, 2], J[3, 3] = s1, z2_x, z3_x
    J[3, 4], J[3, 5] = ca2 * z3_x - sa2 * v5, x4_x * s5 - (ca2 * v5 + sa2 * z3_x) * c5
    J[4, 1], J[4, 2], J[4, 3] = -c1, z2_y, z3_y
    J[4, 4], J[4, 5] = ca2 * z3_y - sa2 * v6, x4_y * s5 - (ca2 * v6 + sa2 * z3_y) * c5
    J[5, 0], J[5, 2], J[5, 3] = 1.0, -v4, z3_z
    J[5, 4], J[5, 5] = sa2 * v7 + ca2 * z3_z, x4_z * s5 - (sa2 * z3_z - ca2 * v7) * c5
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=1.438108007528137, reach=4.000000004,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.20860741921300402, 0.0, 0.0, -1.0,
            -0.046345438382874284, 0.9230769230769231, 0.38461538461538464, 0.0, 0.0,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, 0.6953580640433468, 0.882218554549757,
            0.47051656242653705, -0.01745240643728351, -0.0016179252730085187, 0.015399182150544274,
            0.008212897146956947, 0.9998476951563913, 0.046345438429219725,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.96, 0.28, 0.0, 0.04636661657662248,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 1.0430370960650202, 0.7240276413201454,
            0.6895501345906148, -0.01745240643728351, 0.0, 0.01263794948906737,
            0.012036142370540353, 0.9998476951563913, 0.0,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0,
            0.9459459459459459, 0.32432432432432434, 0.0, 0.0,
        )),
        _loops.Link((0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.0)),
        _loops.Link((
            1.0, 0.0, 0.0, -0.0, 0.0, 0.9998476951563913, 0.01745240643728351, -0.0, 0.0,
            -0.01745240643728351, 0.9998476951563913, -0.0,
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
        _loops.Formulation(joints=(2, 3, 4, 5, 0, 1), sign=1.0),
        _loops.Formulation(joints=(5, 4, 3, 2, 1, 0), sign=-1.0),
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
