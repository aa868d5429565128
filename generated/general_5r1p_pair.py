# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 036ddc2d948f0596
"""general_5r1p_pair: Arm on a rail with two parallel axes among five skew or meeting ones.

Inverse kinematics, generated from robots/general_5r1p_pair.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/general_5r1p_pair.yaml. The formulas and where they come from:
general_5r1p_pair.md.

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

NAME = "general_5r1p_pair"
METHOD = "general 5R1P"
DOF = 6
JOINT_TYPES = "PRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-0.6, 0.9), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
)
MAX_SOLUTIONS = 16

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, sqrt3 = 1.7320508075688772, sqrt2 = 1.4142135623730951.
a1 = 0.472  # link length 1 [m]
d2 = -0.069  # joint offset 2 [m]
d3 = -0.261  # joint offset 3 [m]
a3 = 0.234  # link length 3 [m]
d4 = 0.525  # joint offset 4 [m]
d5 = 0.119  # joint offset 5 [m]
a6 = 0.123  # link length 6 [m]
f1 = 0.5  # 1 / 2
f2 = 0.8660254037844386  # 1 / 2 * sqrt3
f3 = -0.2260326303877385  # 1 / 2 * sqrt3 * d3 [m]
f4 = 0.45466333698683026  # d4 * 1 / 2 * sqrt3 [m]
f5 = 0.7071067811865476  # 1 / 2 * sqrt2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16, size=1.803, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0, turns=False, lowest=-0.6, highest=0.9),
        _joints.Joint(place=1, facing=-1.0),
        _joints.Joint(place=2),
        _joints.Joint(place=3),
        _joints.Joint(place=4),
        _joints.Joint(place=5),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.472, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0), turns=False,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.0, 0.0, 0.8660254037844386, -0.5, 0.0, 0.0, 0.5,
                0.8660254037844386, -0.069,
            ),
            sign=-1.0,
        ),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.234, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, -0.261)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.525)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.119)),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.123, 0.0, 0.7071067811865476, -0.7071067811865476, 0.0, 0.0,
            0.7071067811865476, 0.7071067811865476, 0.0,
        )),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
    miss_weights=(0.5546, 0.5546, 0.5546, 1.0, 1.0, 1.0), size=1.803,
    slacks=(1.803e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09),
    weights=(0.3076157350370323, 1.0, 1.0, 1.0, 1.0, 1.0), paces=(1.803, 1.0, 1.0, 1.0, 1.0, 1.0),
    clamped_again=1e-10, steps=("clamps",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.472, 1.5707963267948966),
    (0.0, -0.069, 0.0, 0.5235987755982988),
    (0.0, -0.261, 0.234, 3.141592653589793),
    (0.0, 0.525, 0.0, -1.5707963267948966),
    (0.0, 0.119, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.123, 0.7853981633974483),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    drives=(
        (1.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        (0.0, -1.0, 0.0, 0.0, 0.0, 0.0),
        (0.0, 0.0, 1.0, 0.0, 0.0, 0.0),
        (0.0, 0.0, 0.0, 1.0, 0.0, 0.0),
        (0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
        (0.0, 0.0, 0.0, 0.0, 0.0, 1.0),
    ),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c2, s2 = math.cos(-q[1]), math.sin(-q[1])
    v1, y2_z, z2_x = s2 * f2, c2 * f2, s2 * f1
    z3_z = c2 * f1
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, v2, x3_z = c2 * c3 - v1 * s3, f1 * s3, s2 * c3 + y2_z * s3
    y3_x, y3_y, y3_z = v1 * c3 + c2 * s3, f1 * c3, s2 * s3 - y2_z * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, y3_y * s4 - v2 * c4, x3_z * c4 + y3_z * s4
    z4_x, z4_y, z4_z = y3_x * c4 - x3_x * s4, y3_y * c4 + v2 * s4, y3_z * c4 - x3_z * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + z2_x * s5, x4_y * c5 - f2 * s5, x4_z * c5 - z3_z * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    x6_x, x6_y, x6_z = x5_x * c6 + z4_x * s6, x5_y * c6 + z4_y * s6, x5_z * c6 + z4_z * s6
    v3, v4 = (z4_x * c6 - x5_x * s6) * f5, (z4_y * c6 - x5_y * s6) * f5
    v5, v6 = (z4_z * c6 - x5_z * s6) * f5, (x4_x * s5 - z2_x * c5) * f5
    v7, v8 = (f2 * c5 + x4_y * s5) * f5, (z3_z * c5 + x4_z * s5) * f5
    T[0, 0], T[0, 1], T[0, 2] = x6_x, v3 + v6, v6 - v3
    T[0, 3] = a1 + x3_x * a3 + z2_x * d3 - z2_x * d4 + z4_x * d5 + x6_x * a6
    T[1, 0], T[1, 1], T[1, 2] = x6_y, v4 + v7, v7 - v4
    T[1, 3] = f4 - (d2 + v2 * a3 + f3) + z4_y * d5 + x6_y * a6
    T[2, 0], T[2, 1], T[2, 2] = x6_z, v5 + v8, v8 - v5
    T[2, 3] = q[0] + x3_z * a3 - z3_z * d3 + z3_z * d4 + z4_z * d5 + x6_z * a6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c2, s2 = math.cos(-q[1]), math.sin(-q[1])
    v1, y2_z, z2_x = s2 * f2, c2 * f2, s2 * f1
    z3_z = c2 * f1
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, v2, x3_z = c2 * c3 - v1 * s3, f1 * s3, s2 * c3 + y2_z * s3
    y3_x, y3_y, p3_x = v1 * c3 + c2 * s3, f1 * c3, a1 + x3_x * a3 + z2_x * d3
    v3, p3_z, y3_z = d2 + v2 * a3 + f3, q[0] + x3_z * a3 - z3_z * d3, s2 * s3 - y2_z * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, y3_y * s4 - v2 * c4, x3_z * c4 + y3_z * s4
    z4_x, z4_y, z4_z = y3_x * c4 - x3_x * s4, y3_y * c4 + v2 * s4, y3_z * c4 - x3_z * s4
    p4_x, p4_y, p4_z = p3_x - z2_x * d4, f4 - v3, p3_z + z3_z * d4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    z5_y, z5_z, p5_x = f2 * c5 + x4_y * s5, z3_z * c5 + x4_z * s5, p4_x + z4_x * d5
    p5_y, p5_z, z5_x = p4_y + z4_y * d5, p4_z + z4_z * d5, x4_x * s5 - z2_x * c5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    p6_x = p5_x + ((x4_x * c5 + z2_x * s5) * c6 + z4_x * s6) * a6
    p6_y = p5_y + ((x4_y * c5 - f2 * s5) * c6 + z4_y * s6) * a6
    p6_z, v4 = p5_z + ((x4_z * c5 - z3_z * s5) * c6 + z4_z * s6) * a6, p6_x - a1
    J12, v5, v6 = p6_z - q[0], d2 + p6_y, p6_x - p3_x
    v7, v8, v9 = v3 + p6_y, p6_z - p3_z, p6_x - p4_x
    v10, v11, v12 = p6_y - p4_y, p6_z - p4_z, p6_x - p5_x
    v13, v14 = p6_y - p5_y, p6_z - p5_z
    J[0, 1], J[0, 2], J[0, 3] = J12, z3_z * v5 - f2 * J12, f2 * v8 - z3_z * v7
    J[0, 4], J[0, 5] = z4_y * v11 - z4_z * v10, z5_y * v14 - z5_z * v13
    J[1, 2], J[1, 3] = -(z3_z * v4 + z2_x * J12), z3_z * v6 + z2_x * v8
    J[1, 4], J[1, 5] = z4_z * v9 - z4_x * v11, z5_z * v12 - z5_x * v14
    J[2, 0], J[2, 1], J[2, 2] = 1.0, -v4, z2_x * v5 + f2 * v4
    J[2, 3], J[2, 4] = -(z2_x * v7 + f2 * v6), z4_x * v10 - z4_y * v9
    J[2, 5] = z5_x * v13 - z5_y * v12
    J[3, 2], J[3, 3], J[3, 4] = z2_x, -z2_x, z4_x
    J[3, 5] = z5_x
    J[4, 1], J[4, 2], J[4, 3] = 1.0, -f2, f2
    J[4, 4], J[4, 5] = z4_y, z5_y
    J[5, 2], J[5, 3], J[5, 4] = -z3_z, z3_z, z4_z
    J[5, 5] = z5_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.6842675044380697, reach=math.inf,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.6897887111965271, 0.0, 0.0, -1.0,
            0.25467491748554627, 0.9230769230769231, 0.38461538461538464, 0.0, 0.0,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, 0.0, 0.76414006216274,
            0.4075413664867947, -0.5000000000000001, 0.2358545586139572, 0.4411764705882354,
            0.23529411764705888, 0.8660254037844387, -0.25467491774022116,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.3419715220762444, -0.96, -0.28, 0.0, 0.0, 0.0, 0.0, -1.0,
            -0.33848222824843144,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, 1.0, 0.08695429723659354,
            -0.7241379310344828, -0.6896551724137931, 0.0, 0.33848222867719313,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0,
            0.9459459459459459, 0.32432432432432434, 0.0, 0.08695429732354783,
        )),
        _loops.Link((1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.0)),
        _loops.Link((
            1.0, 0.0, 0.0, -0.123, 0.0, 0.7071067811865476, 0.7071067811865476, -0.0, 0.0,
            -0.7071067811865476, 0.7071067811865476, -0.0,
        )),
    ),
    advances=(
        (1.0, 0.0),
        (0.38461538461538464, 0.9230769230769231),
        (0.47058823529411764, 0.8823529411764706),
        (0.28, 0.96),
        (0.6896551724137931, 0.7241379310344828),
        (0.32432432432432434, 0.9459459459459459),
    ),
    formulations=(
        _loops.Formulation(joints=(1, 2, 3, 4, 5, 0), sign=1.0),
        _loops.Formulation(joints=(4, 3, 2, 1, 0, 5), sign=-1.0),
    ),
    slides=(0,), side="right",
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
