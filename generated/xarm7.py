# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: fc9fabe66b08c783
"""xarm7: UFACTORY xArm 7.

Inverse kinematics, generated from robots/xarm7.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/xarm7.yaml. The formulas and where they come from: xarm7.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 7), _runtime("arrays").zeros

NAME = "xarm7"
METHOD = "general 6R"
DOF = 7
JOINT_TYPES = "RRRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6", "joint7")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
)
MAX_SOLUTIONS = 16
FREE_JOINTS = (3,)  # from 1: the caller gives their values

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = 0.267  # joint offset 1 [m]
d3 = 0.293  # joint offset 3 [m]
a3 = 0.0525  # link length 3 [m]
a4 = 0.0775  # link length 4 [m]
d5 = 0.3425  # joint offset 5 [m]
a6 = 0.076  # link length 6 [m]
d7 = 0.097  # joint offset 7 [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
offset2 = 3.141592653589793  # offset of joint 2 [rad]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16, size=1.2055000000000002, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0, zero=3.141592653589793),
        _joints.Joint(place=1, zero=3.141592653589793),
        _joints.Joint(place=3),
        _joints.Joint(place=4),
        _joints.Joint(place=5),
        _joints.Joint(place=6),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.267),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0525, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.293)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0775, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.3425)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.076, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.097)),
    ),
    free=(2,),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
    miss_weights=(0.8295, 0.8295, 0.8295, 1.0, 1.0, 1.0), size=1.2055000000000002,
    paces=(1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.0), clamped_again=1e-10, given=(2,),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (3.141592653589793, 0.267, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.293, 0.0525, 1.5707963267948966),
    (0.0, 0.0, 0.0775, 1.5707963267948966),
    (0.0, 0.3425, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.076, -1.5707963267948966),
    (0.0, 0.097, 0.0, 0.0),
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
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + z2_x * s4, x3_y * c4 + z2_y * s4, x3_z * c4 - c2 * s4
    z4_z, z4_x, z4_y = c2 * c4 + x3_z * s4, x3_x * s4 - z2_x * c4, x3_y * s4 - z2_y * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, x4_y * c5 + z3_y * s5, x4_z * c5 + z3_z * s5
    y6_x, y6_y, y6_z = z3_x * c5 - x4_x * s5, z3_y * c5 - x4_y * s5, z3_z * c5 - x4_z * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    x6_x, x6_y, x6_z = x5_x * c6 + z4_x * s6, x5_y * c6 + z4_y * s6, x5_z * c6 + z4_z * s6
    z6_x, z6_y, z6_z = z4_x * c6 - x5_x * s6, z4_y * c6 - x5_y * s6, z4_z * c6 - x5_z * s6
    c7, s7 = math.cos(q[6]), math.sin(q[6])
    T[0, 0], T[0, 1], T[0, 2] = x6_x * c7 + y6_x * s7, y6_x * c7 - x6_x * s7, z6_x
    T[0, 3] = x3_x * a3 + z2_x * d3 + x4_x * a4 + z4_x * d5 + x6_x * a6 + z6_x * d7
    T[1, 0], T[1, 1], T[1, 2] = x6_y * c7 + y6_y * s7, y6_y * c7 - x6_y * s7, z6_y
    T[1, 3] = x3_y * a3 + z2_y * d3 + x4_y * a4 + z4_y * d5 + x6_y * a6 + z6_y * d7
    T[2, 0], T[2, 1], T[2, 2] = x6_z * c7 + y6_z * s7, y6_z * c7 - x6_z * s7, z6_z
    T[2, 3] = d1 + x3_z * a3 - c2 * d3 + x4_z * a4 + z4_z * d5 + x6_z * a6 + z6_z * d7
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
    z3_y, z3_z, p3_x = c1 * c3 + x2_y * s3, s2 * s3, x3_x * a3 + z2_x * d3
    p3_y, p3_z, z3_x = x3_y * a3 + z2_y * d3, d1 + x3_z * a3 - c2 * d3, x2_x * s3 - s1 * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + z2_x * s4, x3_y * c4 + z2_y * s4, x3_z * c4 - c2 * s4
    z4_z, p4_x, p4_y = c2 * c4 + x3_z * s4, p3_x + x4_x * a4, p3_y + x4_y * a4
    p4_z, z4_x, z4_y = p3_z + x4_z * a4, x3_x * s4 - z2_x * c4, x3_y * s4 - z2_y * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, x4_y * c5 + z3_y * s5, x4_z * c5 + z3_z * s5
    p5_x, p5_y, p5_z = p4_x + z4_x * d5, p4_y + z4_y * d5, p4_z + z4_z * d5
    z5_x, z5_y, z5_z = x4_x * s5 - z3_x * c5, x4_y * s5 - z3_y * c5, x4_z * s5 - z3_z * c5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    z6_x, z6_y, z6_z = z4_x * c6 - x5_x * s6, z4_y * c6 - x5_y * s6, z4_z * c6 - x5_z * s6
    p6_x, p6_y = p5_x + (x5_x * c6 + z4_x * s6) * a6, p5_y + (x5_y * c6 + z4_y * s6) * a6
    p6_z, p7_x, p7_y = p5_z + (x5_z * c6 + z4_z * s6) * a6, p6_x + z6_x * d7, p6_y + z6_y * d7
    p7_z = p6_z + z6_z * d7
    v3, v4, v5 = p7_z - d1, p7_x - p3_x, p7_y - p3_y
    v6, v7, v8 = p7_z - p3_z, p7_x - p4_x, p7_y - p4_y
    v9, v10, v11 = p7_z - p4_z, p7_x - p5_x, p7_y - p5_y
    v12, v13, v14 = p7_z - p5_z, p7_x - p6_x, p7_y - p6_y
    v15 = p7_z - p6_z
    J[0, 0], J[0, 1], J[0, 2] = -p7_y, -(c1 * v3), z2_y * v3 + c2 * p7_y
    J[0, 3], J[0, 4] = z3_y * v6 - z3_z * v5, z4_y * v9 - z4_z * v8
    J[0, 5], J[0, 6] = z5_y * v12 - z5_z * v11, z6_y * v15 - z6_z * v14
    J[1, 0], J[1, 1], J[1, 2] = p7_x, -(s1 * v3), -(c2 * p7_x + z2_x * v3)
    J[1, 3], J[1, 4] = z3_z * v4 - z3_x * v6, z4_z * v7 - z4_x * v9
    J[1, 5], J[1, 6] = z5_z * v10 - z5_x * v12, z6_z * v13 - z6_x * v15
    J[2, 1], J[2, 2] = s1 * p7_y + c1 * p7_x, z2_x * p7_y - z2_y * p7_x
    J[2, 3], J[2, 4] = z3_x * v5 - z3_y * v4, z4_x * v8 - z4_y * v7
    J[2, 5], J[2, 6] = z5_x * v11 - z5_y * v10, z6_x * v14 - z6_y * v13
    J[3, 1], J[3, 2], J[3, 3] = s1, z2_x, z3_x
    J[3, 4], J[3, 5], J[3, 6] = z4_x, z5_x, z6_x
    J[4, 1], J[4, 2], J[4, 3] = -c1, z2_y, z3_y
    J[4, 4], J[4, 5], J[4, 6] = z4_y, z5_y, z6_y
    J[5, 0], J[5, 2], J[5, 3] = 1.0, -c2, z3_z
    J[5, 4], J[5, 5], J[5, 6] = z4_z, z5_z, z6_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.3664432918882389, reach=4.000000004,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0,
            0.9230769230769231, 0.38461538461538464, 0.0, 1.8215640973187067e-10,
        )),
        _loops.Link(
            first=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0),
            inside=(
                _loops.Inside(
                    given=0, slides=False, factor=1.0,
                    after=(
                        0.47058823529411764, -0.8823529411764706, 0.0, 0.14326909828113846, 0.0,
                        0.0, -1.0, 0.0, 0.8823529411764706, 0.47058823529411764, 0.0,
                        0.7995780151690203,
                    ),
                ),
            ),
        ),
        _loops.Link((
            0.28, -0.96, 0.0, 0.21149247841501392, 0.0, 0.0, -1.0, -0.4673301538586307, 0.96, 0.28,
            0.0, 0.0,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0,
            0.7241379310344828, 0.6896551724137931, 0.0, 0.4673301539754631,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, 0.20739907560698137, 0.0, 0.0, 1.0, 0.0,
            -0.9459459459459459, -0.32432432432432434, 0.0, 0.0,
        )),
        _loops.Link((0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.26699999993325)),
        _loops.Link((1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.097)),
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
        _loops.Formulation(joints=(0, 1, 2, 3, 4, 5), sign=1.0),
        _loops.Formulation(joints=(3, 4, 5, 0, 1, 2), sign=1.0),
        _loops.Formulation(joints=(3, 2, 1, 0, 5, 4), sign=-1.0),
    ),
    given=((1.0, 0.0),),
    special=(
        _loops.Special(given=0, cosine=1.0, sine=0.0, within=1e-12, formulations=(1,)),
        _loops.Special(given=0, cosine=-1.0, sine=0.0, within=1e-12, formulations=(1,)),
    ),
)
_NUMBERS = _loops.general_numbers(_LINKS, _LOOP)
_all_joints = _runtime("general.rows").all_joints


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _all_joints(_NUMBERS, pose, q_free, seed, q, status)


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "pose", given=1, apart=(_whole.compile_apart,), at_once=True,
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
