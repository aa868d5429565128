# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 6b6e4a5ccd645cc3
"""xarm6: UFACTORY xArm 6.

Inverse kinematics, generated from robots/xarm6.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/xarm6.yaml. The formulas and where they come from: xarm6.md.

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

NAME = "xarm6"
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

d1 = 0.267  # z of axis 2 [m]
b2 = 0.0535  # x of axis 3 [m]
h2 = 0.2845  # z of axis 3 [m]
a3 = 0.0775  # x of axis 4 [m]
d4 = 0.3425  # z of axis 5 [m]
a5 = 0.076  # x of axis 6 [m]
d6 = 0.097  # z of the home pose [m]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16, size=1.149486614543747, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0),
        _joints.Joint(place=1),
        _joints.Joint(place=2),
        _joints.Joint(place=3, facing=-1.0),
        _joints.Joint(place=4),
        _joints.Joint(place=5, facing=-1.0),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.267)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.2845, 0.0, 1.0, 0.0, 0.0535, 0.0, 0.0, 1.0, 0.0)),
        _joints.ChainJoint((0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0775, 0.0, 1.0, 0.0, 0.0)),
        _joints.ChainJoint(
            after=(0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, -0.3425), sign=-1.0,
        ),
        _joints.ChainJoint((0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.076, 0.0, 1.0, 0.0, 0.0)),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, -0.097), sign=-1.0,
        ),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
    miss_weights=(0.87, 0.87, 0.87, 1.0, 1.0, 1.0), size=1.149486614543747, clamped_again=1e-10,
))

# The axes at q = 0: a unit vector along each, and a point of it [m].
AXES = (
    (0.0, 0.0, 1.0, 0.0, 0.0, 0.0),
    (0.0, 1.0, 0.0, 0.0, 0.0, 0.267),
    (0.0, 1.0, 0.0, 0.0535, 0.0, 0.5515),
    (0.0, 0.0, -1.0, 0.131, 0.0, 0.0),
    (0.0, 1.0, 0.0, 0.131, 0.0, 0.20899999999999996),
    (0.0, 0.0, -1.0, 0.20700000000000002, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=AXES, convention="axes",
    tool=(1.0, 0.0, 0.0, 0.20700000000000002, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.11199999999999996),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, y2_x = c1 * s2, s1 * s2, c1 * c2
    y2_y = s1 * c2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, c2 * c3 - s2 * s3
    y3_x, y3_y, v1 = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, s2 * c3 + c2 * s3
    c4, s4 = math.cos(-q[3]), math.sin(-q[3])
    x4_x, x4_y, v2 = y3_x * c4 - s1 * s4, y3_y * c4 + c1 * s4, v1 * c4
    v3, y4_y, y4_z = s1 * c4 + y3_x * s4, c1 * c4 - y3_y * s4, v1 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x3_x * c5 + x4_x * s5, x3_y * c5 + x4_y * s5, x3_z * c5 - v2 * s5
    y5_x, y5_y, v4 = x4_x * c5 - x3_x * s5, x4_y * c5 - x3_y * s5, v2 * c5 + x3_z * s5
    c6, s6 = math.cos(-q[5]), math.sin(-q[5])
    T[0, 0], T[0, 1], T[0, 2] = y5_x * c6 - v3 * s6, v3 * c6 + y5_x * s6, -x5_x
    T[0, 3] = x2_x * h2 + y2_x * b2 + y3_x * a3 - x3_x * d4 + y5_x * a5 - x5_x * d6
    T[1, 0], T[1, 1], T[1, 2] = y5_y * c6 + y4_y * s6, y5_y * s6 - y4_y * c6, -x5_y
    T[1, 3] = x2_y * h2 + y2_y * b2 + y3_y * a3 - x3_y * d4 + y5_y * a5 - x5_y * d6
    T[2, 0], T[2, 1], T[2, 2] = y4_z * s6 - v4 * c6, -(y4_z * c6 + v4 * s6), -x5_z
    T[2, 3] = d1 + c2 * h2 - s2 * b2 - v1 * a3 - x3_z * d4 - v4 * a5 - x5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, y2_x = c1 * s2, s1 * s2, c1 * c2
    y2_y, p3_x = s1 * c2, x2_x * h2 + y2_x * b2
    p3_y, p3_z = x2_y * h2 + y2_y * b2, d1 + c2 * h2 - s2 * b2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, c2 * c3 - s2 * s3
    y3_x, y3_y, v1 = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, s2 * c3 + c2 * s3
    p4_x, p4_y, p4_z = p3_x + y3_x * a3, p3_y + y3_y * a3, p3_z - v1 * a3
    c4, s4 = math.cos(-q[3]), math.sin(-q[3])
    x4_x, x4_y, v2 = y3_x * c4 - s1 * s4, y3_y * c4 + c1 * s4, v1 * c4
    v3, y4_y, y4_z = s1 * c4 + y3_x * s4, c1 * c4 - y3_y * s4, v1 * s4
    p5_x, p5_y, p5_z = p4_x - x3_x * d4, p4_y - x3_y * d4, p4_z - x3_z * d4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x3_x * c5 + x4_x * s5, x3_y * c5 + x4_y * s5, x3_z * c5 - v2 * s5
    p6_x, p6_y = p5_x + (x4_x * c5 - x3_x * s5) * a5, p5_y + (x4_y * c5 - x3_y * s5) * a5
    p6_z, J21, v4 = p5_z - (v2 * c5 + x3_z * s5) * a5, p6_x - x5_x * d6, p6_y - x5_y * d6
    v5 = p6_z - x5_z * d6
    v6, v7, v8 = v5 - d1, v5 - p3_z, J21 - p4_x
    v9, v10, v11 = v4 - p4_y, v5 - p4_z, J21 - p5_x
    v12, v13, v14 = v4 - p5_y, v5 - p5_z, J21 - p6_x
    v15, v16 = v4 - p6_y, v5 - p6_z
    J[0, 0], J[0, 1], J[0, 2] = -v4, c1 * v6, c1 * v7
    J[0, 3], J[0, 4] = -(x3_y * v10 + -x3_z * v9), y4_y * v13 - y4_z * v12
    J[0, 5] = -(x5_y * v16 + -x5_z * v15)
    J[1, 0], J[1, 1], J[1, 2] = J21, s1 * v6, s1 * v7
    J[1, 3], J[1, 4] = -x3_z * v8 + x3_x * v10, y4_z * v11 + v3 * v13
    J[1, 5] = -x5_z * v14 + x5_x * v16
    J[2, 1], J[2, 2] = -(s1 * v4 + c1 * J21), -(s1 * (v4 - p3_y) + c1 * (J21 - p3_x))
    J[2, 3], J[2, 4] = x3_y * v8 - x3_x * v9, -(v3 * v12 + y4_y * v11)
    J[2, 5] = x5_y * v14 - x5_x * v15
    J[3, 1], J[3, 2], J[3, 3] = -s1, -s1, -x3_x
    J[3, 4], J[3, 5] = -v3, -x5_x
    J[4, 1], J[4, 2], J[4, 3] = c1, c1, -x3_y
    J[4, 4], J[4, 5] = y4_y, -x5_y
    J[5, 0], J[5, 3], J[5, 4] = 1.0, -x3_z, y4_z
    J[5, 5] = -x5_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.3623534292370541, reach=4.000000004,
    links=(
        _loops.Link((
            0.9230769230769231, 0.38461538461538464, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
            0.38461538461538464, -0.9230769230769231, 0.0, 7.368497484792287e-10,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, 0.7851450463681914, 0.8823529411764706,
            0.47058823529411764, 0.0, 0.1476459050288163, 0.0, 0.0, 1.0, 0.0,
        )),
        _loops.Link((
            0.0, 0.0, 1.0, -0.4726048826830395, 0.28, -0.96, 0.0, 0.21387958205108903, 0.96, 0.28,
            0.0, 0.0,
        )),
        _loops.Link((
            0.7241379310344828, 0.6896551724137931, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
            0.6896551724137931, -0.7241379310344828, 0.0, -0.4726048831556444,
        )),
        _loops.Link((
            0.0, 0.0, 1.0, 0.0, 0.32432432432432434, -0.9459459459459459, 0.0, 0.209739977237197,
            0.9459459459459459, 0.32432432432432434, 0.0, 0.0,
        )),
        _loops.Link((0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.266999999733)),
        _loops.Link((1.0, 0.0, 0.0, -0.0, 0.0, -1.0, 0.0, -0.0, 0.0, 0.0, -1.0, -0.097)),
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
        _loops.Formulation(joints=(3, 2, 1, 0, 5, 4), sign=-1.0),
        _loops.Formulation(joints=(0, 1, 2, 3, 4, 5), sign=1.0),
    ),
    wrist=_loops.Wrist(
        shoulder=7.368497484792287e-10, wrist=-0.0, upper=0.7989067887484044,
        lower=0.9691057615426545, cosine=-0.9753422209915128, sine=-0.22069787482289702, flip=1.0,
        sources=(
            0.0, 1.0, 0.7851450463681914, 0.1476459050288163, -0.945209765838684,
            0.21387958205108903, 0.0, 1.0,
        ),
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
