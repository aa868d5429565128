# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 25c95d32d8b27f20
"""abb_gofa_5: ABB GoFa CRB 15000-5/0.95.

Inverse kinematics, generated from robots/abb_gofa_5.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/abb_gofa_5.yaml. The formulas and where they come from: abb_gofa_5.md.

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

NAME = "abb_gofa_5"
METHOD = "general 6R"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-3.141592653589793, 3.141592653589793), (-3.141592653589793, 3.141592653589793),
    (-3.9269908169872414, 1.4835298641951802), (-3.141592653589793, 3.141592653589793),
    (-3.141592653589793, 3.141592653589793), (-3.141592653589793, 3.141592653589793),
)
BRANCHES = (
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
)
MAX_SOLUTIONS = 16

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = 0.265  # joint offset 1 [m]
a2 = 0.444  # link length 2 [m]
a3 = 0.11  # link length 3 [m]
d4 = 0.47  # joint offset 4 [m]
a5 = 0.08  # link length 5 [m]
d6 = 0.101  # z of the tool frame [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
offset2 = 1.5707963267948966  # offset of joint 2 [rad]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16, size=1.4700000000000002, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(
            place=0, lowest=-3.141592653589793, highest=3.141592653589793, zero=3.141592653589793,
        ),
        _joints.Joint(
            place=1, lowest=-3.141592653589793, highest=3.141592653589793, zero=1.5707963267948966,
        ),
        _joints.Joint(place=2, lowest=-3.9269908169872414, highest=1.4835298641951802),
        _joints.Joint(place=3, lowest=-3.141592653589793, highest=3.141592653589793),
        _joints.Joint(place=4, lowest=-3.141592653589793, highest=3.141592653589793),
        _joints.Joint(place=5, lowest=-3.141592653589793, highest=3.141592653589793),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.265),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.444, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
            offset=1.5707963267948966,
        ),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.11, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.47)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.08, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0)),
        _joints.ChainJoint((0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.101)),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
    miss_weights=(0.6803, 0.6803, 0.6803, 1.0, 1.0, 1.0), size=1.4700000000000002,
    clamped_again=1e-10, steps=("clamps", "range exceeds a turn"),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (3.141592653589793, 0.265, 0.0, 1.5707963267948966),
    (1.5707963267948966, 0.0, 0.444, 0.0),
    (0.0, 0.0, 0.11, -1.5707963267948966),
    (0.0, 0.47, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.08, -1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    tool=(0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.101),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, x2_y, v3 = c1 * c2, s1 * c2, c1 * s2
    v4 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v3 * s3, x2_y * c3 - v4 * s3, s2 * c3 + c2 * s3
    v5, v6, z3_z = v3 * c3 + x2_x * s3, v4 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - s1 * s4, x3_y * c4 + c1 * s4, x3_z * c4
    z4_x, y5_y, z4_z = s1 * c4 + x3_x * s4, c1 * c4 - x3_y * s4, x3_z * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 - v5 * s5, x4_y * c5 - v6 * s5, x4_z * c5 + z3_z * s5
    v7, v8, z5_z = v5 * c5 + x4_x * s5, v6 * c5 + x4_y * s5, z3_z * c5 - x4_z * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = -v7, z4_x * c6 + x5_x * s6, x5_x * c6 - z4_x * s6
    T[0, 3] = x2_x * a2 + x3_x * a3 - v5 * d4 + x5_x * a5 - v7 * d6
    T[1, 0], T[1, 1], T[1, 2] = -v8, x5_y * s6 - y5_y * c6, x5_y * c6 + y5_y * s6
    T[1, 3] = x2_y * a2 + x3_y * a3 - v6 * d4 + x5_y * a5 - v8 * d6
    T[2, 0], T[2, 1], T[2, 2] = z5_z, z4_z * c6 + x5_z * s6, x5_z * c6 - z4_z * s6
    T[2, 3] = d1 + s2 * a2 + x3_z * a3 + z3_z * d4 + x5_z * a5 + z5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, x2_y, v3 = c1 * c2, s1 * c2, c1 * s2
    v4, p2_x, p2_y = s1 * s2, x2_x * a2, x2_y * a2
    p2_z = d1 + s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v3 * s3, x2_y * c3 - v4 * s3, s2 * c3 + c2 * s3
    v5, v6, z3_z = v3 * c3 + x2_x * s3, v4 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    p3_x, p3_y, p3_z = p2_x + x3_x * a3, p2_y + x3_y * a3, p2_z + x3_z * a3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - s1 * s4, x3_y * c4 + c1 * s4, x3_z * c4
    z4_x, z4_z, p4_x = s1 * c4 + x3_x * s4, x3_z * s4, p3_x - v5 * d4
    p4_y, p4_z, z4_y = p3_y - v6 * d4, p3_z + z3_z * d4, x3_y * s4 - c1 * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    v7, v8, z5_z = v5 * c5 + x4_x * s5, v6 * c5 + x4_y * s5, z3_z * c5 - x4_z * s5
    p5_x, p5_y = p4_x + (x4_x * c5 - v5 * s5) * a5, p4_y + (x4_y * c5 - v6 * s5) * a5
    p5_z, J21, v9 = p4_z + (x4_z * c5 + z3_z * s5) * a5, p5_x - v7 * d6, p5_y - v8 * d6
    v10 = p5_z + z5_z * d6
    v11, v12, v13 = v10 - d1, v10 - p2_z, J21 - p3_x
    v14, v15, v16 = v9 - p3_y, v10 - p3_z, J21 - p4_x
    v17, v18, v19 = v9 - p4_y, v10 - p4_z, J21 - p5_x
    v20, v21 = v9 - p5_y, v10 - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -v9, -(c1 * v11), -(c1 * v12)
    J[0, 3], J[0, 4] = -(v6 * v15 + z3_z * v14), z4_y * v18 - z4_z * v17
    J[0, 5] = -(v8 * v21 + z5_z * v20)
    J[1, 0], J[1, 1], J[1, 2] = J21, -(s1 * v11), -(s1 * v12)
    J[1, 3], J[1, 4] = z3_z * v13 + v5 * v15, z4_z * v16 - z4_x * v18
    J[1, 5] = z5_z * v19 + v7 * v21
    J[2, 1], J[2, 2] = s1 * v9 + c1 * J21, s1 * (v9 - p2_y) + c1 * (J21 - p2_x)
    J[2, 3], J[2, 4], J[2, 5] = v6 * v13 - v5 * v14, z4_x * v17 - z4_y * v16, v8 * v19 - v7 * v20
    J[3, 1], J[3, 2], J[3, 3] = s1, s1, -v5
    J[3, 4], J[3, 5] = z4_x, -v7
    J[4, 1], J[4, 2], J[4, 3] = -c1, -c1, -v6
    J[4, 4], J[4, 5] = z4_y, -v8
    J[5, 0], J[5, 3], J[5, 4] = 1.0, z3_z, z4_z
    J[5, 5] = z5_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.509235307591332, reach=4.0000000039999986,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0,
            0.9230769230769231, 0.38461538461538464, 0.0, 5.203881545049196e-10,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, 0.8718955527653943, 0.8823529411764706,
            0.47058823529411764, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.216010159468904, 0.0, 0.0, 1.0, 0.46147624954373856, -0.96, -0.28,
            0.0, 0.0,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0,
            0.7241379310344828, 0.6896551724137931, 0.0, 0.46147625000521486,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, 0.15709829779556655, 0.0, 0.0, 1.0, 0.0,
            -0.9459459459459459, -0.32432432432432434, 0.0, 0.0,
        )),
        _loops.Link((0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.264999999735)),
        _loops.Link((0.0, 0.0, 1.0, -0.101, 0.0, -1.0, 0.0, -0.0, 1.0, 0.0, 0.0, -0.0)),
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
        _loops.Formulation(joints=(4, 5, 0, 1, 2, 3), sign=1.0),
    ),
    wrist=_loops.Wrist(
        shoulder=5.203881545049196e-10, wrist=-0.0, upper=0.8718955527653943,
        lower=0.9478932985402113, cosine=0.973688178796424, sine=0.22788446737788648, flip=1.0,
        sources=(0.0, -1.0, 0.8718955527653943, 0.0, 0.216010159468904, 0.9229524995489534, 0.0, -1.0),
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
