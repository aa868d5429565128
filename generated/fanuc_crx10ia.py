# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: b745383a2692778c
"""fanuc_crx10ia: Fanuc CRX-10iA.

Inverse kinematics, generated from robots/fanuc_crx10ia.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/fanuc_crx10ia.yaml. The formulas and where they come from:
fanuc_crx10ia.md.

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

NAME = "fanuc_crx10ia"
METHOD = "general 6R"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-3.3161255787892263, 3.3161255787892263), (-3.139847324337799, 3.139847324337799),
    (-1.239183768915974, 4.380776422505767), (-3.3161255787892263, 3.3161255787892263),
    (-3.139847324337799, 3.139847324337799), (-3.9269908169872414, 3.9269908169872414),
)
BRANCHES = (
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
)
MAX_SOLUTIONS = 16

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = 0.245  # joint offset 1 [m]
a2 = 0.54  # link length 2 [m]
d4 = 0.54  # joint offset 4 [m]
d5 = 0.15  # joint offset 5 [m]
d6 = 0.16  # z of the tool frame [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
offset2 = 1.5707963267948966  # offset of joint 2 [rad]
offset3 = 3.141592653589793  # offset of joint 3 [rad]
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16, size=1.635, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(
            place=0, lowest=-3.3161255787892263, highest=3.3161255787892263, zero=3.141592653589793,
        ),
        _joints.Joint(
            place=1, lowest=-3.139847324337799, highest=3.139847324337799, zero=1.5707963267948966,
        ),
        _joints.Joint(
            place=2, lowest=-1.239183768915974, highest=4.380776422505767, zero=3.141592653589793,
        ),
        _joints.Joint(
            place=3, lowest=-3.3161255787892263, highest=3.3161255787892263, zero=3.141592653589793,
        ),
        _joints.Joint(
            place=4, lowest=-3.139847324337799, highest=3.139847324337799, zero=3.141592653589793,
        ),
        _joints.Joint(place=5, lowest=-3.9269908169872414, highest=3.9269908169872414),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.245),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.54, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0),
            offset=1.5707963267948966,
        ),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -0.54),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.15),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint((0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 0.0, 0.0, -0.16)),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
    miss_weights=(0.6116, 0.6116, 0.6116, 1.0, 1.0, 1.0), size=1.635, clamped_again=1e-10,
    steps=("clamps", "range exceeds a turn"),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (3.141592653589793, 0.245, 0.0, 1.5707963267948966),
    (1.5707963267948966, 0.0, 0.54, 3.141592653589793),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (3.141592653589793, -0.54, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.15, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    tool=(0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 0.0, 0.0, -0.16),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, x2_y, y2_x = c1 * c2, s1 * c2, c1 * s2
    y2_y, v3 = s1 * s2, q[2] + offset3
    c3, s3 = math.cos(v3), math.sin(v3)
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, s2 * c3 - c2 * s3
    z3_z, z3_x, z3_y = c2 * c3 + s2 * s3, x2_x * s3 - y2_x * c3, x2_y * s3 - y2_y * c3
    v4 = q[3] + offset4
    c4, s4 = math.cos(v4), math.sin(v4)
    x4_x, x4_y, x4_z = x3_x * c4 - s1 * s4, x3_y * c4 + c1 * s4, x3_z * c4
    z4_x, z4_z, z4_y = s1 * c4 + x3_x * s4, x3_z * s4, x3_y * s4 - c1 * c4
    v5 = q[4] + offset5
    c5, s5 = math.cos(v5), math.sin(v5)
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, x4_y * c5 + z3_y * s5, x4_z * c5 + z3_z * s5
    T11_, T21_, T31_ = z3_x * c5 - x4_x * s5, z3_y * c5 - x4_y * s5, z3_z * c5 - x4_z * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = T11_, x5_x * s6 - z4_x * c6, -(x5_x * c6 + z4_x * s6)
    T[0, 3] = x2_x * a2 - z3_x * d4 + z4_x * d5 - -T11_ * d6
    T[1, 0], T[1, 1], T[1, 2] = T21_, x5_y * s6 - z4_y * c6, -(x5_y * c6 + z4_y * s6)
    T[1, 3] = x2_y * a2 - z3_y * d4 + z4_y * d5 - -T21_ * d6
    T[2, 0], T[2, 1], T[2, 2] = T31_, x5_z * s6 - z4_z * c6, -(x5_z * c6 + z4_z * s6)
    T[2, 3] = d1 + s2 * a2 - z3_z * d4 + z4_z * d5 - -T31_ * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, x2_y, y2_x = c1 * c2, s1 * c2, c1 * s2
    y2_y, p2_x, p2_y = s1 * s2, x2_x * a2, x2_y * a2
    p2_z, v3 = d1 + s2 * a2, q[2] + offset3
    c3, s3 = math.cos(v3), math.sin(v3)
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, s2 * c3 - c2 * s3
    z3_z, z3_x, z3_y = c2 * c3 + s2 * s3, x2_x * s3 - y2_x * c3, x2_y * s3 - y2_y * c3
    v4 = q[3] + offset4
    c4, s4 = math.cos(v4), math.sin(v4)
    z4_x, z4_z, p4_x = s1 * c4 + x3_x * s4, x3_z * s4, p2_x - z3_x * d4
    p4_y, p4_z, z4_y = p2_y - z3_y * d4, p2_z - z3_z * d4, x3_y * s4 - c1 * c4
    v5 = q[4] + offset5
    c5, s5, p5_x = math.cos(v5), math.sin(v5), p4_x + z4_x * d5
    p5_y, p5_z, z5_x = p4_y + z4_y * d5, p4_z + z4_z * d5, (x3_x * c4 - s1 * s4) * s5 - z3_x * c5
    z5_y, z5_z = (x3_y * c4 + c1 * s4) * s5 - z3_y * c5, x3_z * c4 * s5 - z3_z * c5
    J21, v6, v7 = p5_x - z5_x * d6, p5_y - z5_y * d6, p5_z - z5_z * d6
    v8, v9, v10 = v7 - d1, J21 - p2_x, v6 - p2_y
    v11, v12, v13 = v7 - p2_z, J21 - p4_x, v6 - p4_y
    v14, v15, v16 = v7 - p4_z, J21 - p5_x, v6 - p5_y
    v17 = v7 - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -v6, -(c1 * v8), c1 * v11
    J[0, 3], J[0, 4] = z3_y * v11 - z3_z * v10, z4_y * v14 - z4_z * v13
    J[0, 5] = z5_y * v17 - z5_z * v16
    J[1, 0], J[1, 1], J[1, 2] = J21, -(s1 * v8), s1 * v11
    J[1, 3], J[1, 4] = z3_z * v9 - z3_x * v11, z4_z * v12 - z4_x * v14
    J[1, 5] = z5_z * v15 - z5_x * v17
    J[2, 1], J[2, 2], J[2, 3] = s1 * v6 + c1 * J21, -(s1 * v10 + c1 * v9), z3_x * v10 - z3_y * v9
    J[2, 4], J[2, 5] = z4_x * v13 - z4_y * v12, z5_x * v16 - z5_y * v15
    J[3, 1], J[3, 2], J[3, 3] = s1, -s1, z3_x
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = -c1, c1, z3_y
    J[4, 4], J[4, 5] = z4_y, z5_y
    J[5, 0], J[5, 3], J[5, 4] = 1.0, z3_z, z4_z
    J[5, 5] = z5_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.5826115628257897, reach=4.000000004,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0,
            0.9230769230769231, 0.38461538461538464, 0.0, 4.2052035336045993e-10,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, 0.9268611103097327, -0.8823529411764706,
            -0.47058823529411764, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.0, 0.0, 0.0, -1.0, 0.46343055492315105, 0.96, 0.28, 0.0, 0.0,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, -1.0, -0.12873070970087527,
            0.7241379310344828, 0.6896551724137931, 0.0, -0.4634305553865816,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0,
            0.9459459459459459, 0.32432432432432434, 0.0, 0.128730709829606,
        )),
        _loops.Link((
            0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.24499999975499998,
        )),
        _loops.Link((0.0, 0.0, -1.0, -0.16, 0.0, -1.0, 0.0, -0.0, -1.0, 0.0, 0.0, -0.0)),
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
        _loops.Formulation(joints=(1, 2, 3, 4, 5, 0), sign=1.0),
        _loops.Formulation(joints=(4, 3, 2, 1, 0, 5), sign=-1.0),
    ),
    wrist=_loops.Wrist(
        shoulder=4.2052035336045993e-10, wrist=-0.12873070970087527, upper=0.9268611103097327,
        lower=0.9268611103097326, cosine=-1.0, sine=0.0, flip=-1.0,
        sources=(0.0, -1.0, 0.9268611103097327, 0.0, 0.0, 0.9268611103097326, 0.0, -1.0),
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
