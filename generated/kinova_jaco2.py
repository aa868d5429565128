# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 66d5d28c76f1d82d
"""kinova_jaco2: Kinova Jaco2 with 6 joints.

Inverse kinematics, generated from robots/kinova_jaco2.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kinova_jaco2.yaml. The formulas and where they come from:
kinova_jaco2.md.

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

NAME = "kinova_jaco2"
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

# In formulas below, D3 = 0.2073 [m], d4 = 0.042897125000789196 [m], sqrt3 = 1.7320508075688772,
# D6 = 0.1687 [m], d6 = 0.042897125000789196 [m].
D1 = 0.2755  # joint offset 1 [m]
D2 = 0.41  # link length 2 [m]
e2 = 0.0098  # joint offset 3 [m]
d5 = -0.08579425000157839  # joint offset 5 [m]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
offset3 = 1.5707963267948966  # offset of joint 3 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
offset6 = 1.7453292519943295  # offset of joint 6 [rad]
f1 = 0.2501971250007892  # D3 + d4 [m]
f2 = 0.5  # 1 / 2
f3 = 0.8660254037844386  # 1 / 2 * sqrt3
f4 = 0.2115971250007892  # D6 + d6 [m]
g1 = 0.2501971250007892  # D3 + d4 [m]
g4 = 0.2115971250007892  # D6 + d6 [m]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16, size=1.2428885000031569, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0),
        _joints.Joint(place=1, zero=-1.5707963267948966),
        _joints.Joint(place=2, zero=1.5707963267948966),
        _joints.Joint(place=3),
        _joints.Joint(place=4, zero=3.141592653589793),
        _joints.Joint(place=5, zero=1.7453292519943295),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.2755)),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.41, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0),
            offset=-1.5707963267948966,
        ),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -0.0098),
            offset=1.5707963267948966,
        ),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.0, 0.0, 0.5, -0.8660254037844386, 0.0, 0.0, 0.8660254037844386, 0.5,
            -0.2501971250007892,
        )),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.0, 0.0, 0.5, -0.8660254037844386, 0.0, 0.0, 0.8660254037844386,
                0.5, -0.08579425000157839,
            ),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, -0.2115971250007892),
            offset=1.7453292519943295,
        ),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
    miss_weights=(0.8046, 0.8046, 0.8046, 1.0, 1.0, 1.0), size=1.2428885000031569,
    clamped_again=1e-10,
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.2755, 0.0, 1.5707963267948966),
    (-1.5707963267948966, 0.0, 0.41, 3.141592653589793),
    (1.5707963267948966, -0.0098, 0.0, 1.5707963267948966),
    (0.0, -0.2501971250007892, 0.0, 1.0471975511965976),
    (3.141592653589793, -0.08579425000157839, 0.0, 1.0471975511965976),
    (1.7453292519943295, -0.2115971250007892, 0.0, 3.141592653589793),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, y2_x = c1 * c2, s1 * c2, c1 * s2
    y2_y, v2 = s1 * s2, q[2] + offset3
    c3, s3 = math.cos(v2), math.sin(v2)
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, s2 * c3 - c2 * s3
    z3_z, z3_x, z3_y = c2 * c3 + s2 * s3, x2_x * s3 - y2_x * c3, x2_y * s3 - y2_y * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - s1 * s4, x3_y * c4 + c1 * s4, x3_z * c4
    v3, v4, v5 = s1 * c4 + x3_x * s4, c1 * c4 - x3_y * s4, x3_z * s4
    y4_x, y4_y, y4_z = z3_x * f3 - v3 * f2, v4 * f2 + z3_y * f3, z3_z * f3 - v5 * f2
    z4_x, z4_y, z4_z = v3 * f3 + z3_x * f2, z3_y * f2 - v4 * f3, v5 * f3 + z3_z * f2
    v6 = q[4] + offset5
    c5, s5 = math.cos(v6), math.sin(v6)
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, x4_z * c5 + y4_z * s5
    v7, v8, v9 = y4_x * c5 - x4_x * s5, y4_y * c5 - x4_y * s5, y4_z * c5 - x4_z * s5
    y5_x, y5_y, y5_z = f2 * v7 + f3 * z4_x, f2 * v8 + f3 * z4_y, f2 * v9 + f3 * z4_z
    z5_x, z5_y, z5_z = f2 * z4_x - f3 * v7, f2 * z4_y - f3 * v8, f2 * z4_z - f3 * v9
    v10 = q[5] + offset6
    c6, s6 = math.cos(v10), math.sin(v10)
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + y5_x * s6, x5_x * s6 - y5_x * c6, -z5_x
    T[0, 3] = x2_x * D2 + s1 * e2 - z3_x * f1 + z4_x * d5 - z5_x * f4
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + y5_y * s6, x5_y * s6 - y5_y * c6, -z5_y
    T[1, 3] = x2_y * D2 - c1 * e2 - z3_y * f1 + z4_y * d5 - z5_y * f4
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 + y5_z * s6, x5_z * s6 - y5_z * c6, -z5_z
    T[2, 3] = D1 + s2 * D2 - z3_z * f1 + z4_z * d5 - z5_z * f4
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, y2_x = c1 * c2, s1 * c2, c1 * s2
    y2_y, p2_x, p2_y = s1 * s2, x2_x * D2, x2_y * D2
    p2_z, v2 = D1 + s2 * D2, q[2] + offset3
    c3, s3 = math.cos(v2), math.sin(v2)
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, s2 * c3 - c2 * s3
    z3_z, p3_x, p3_y = c2 * c3 + s2 * s3, p2_x + s1 * e2, p2_y - c1 * e2
    z3_x, z3_y = x2_x * s3 - y2_x * c3, x2_y * s3 - y2_y * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    v3, v4, v5 = s1 * c4 + x3_x * s4, c1 * c4 - x3_y * s4, x3_z * s4
    p4_x, p4_y, p4_z = p3_x - z3_x * g1, p3_y - z3_y * g1, p2_z - z3_z * g1
    z4_x, z4_y, z4_z = v3 * f3 + z3_x * f2, z3_y * f2 - v4 * f3, v5 * f3 + z3_z * f2
    v6 = q[4] + offset5
    c5, s5, p5_x = math.cos(v6), math.sin(v6), p4_x + z4_x * d5
    p5_y, p5_z = p4_y + z4_y * d5, p4_z + z4_z * d5
    z5_x = f2 * z4_x - f3 * ((z3_x * f3 - v3 * f2) * c5 - (x3_x * c4 - s1 * s4) * s5)
    z5_y = f2 * z4_y - f3 * ((v4 * f2 + z3_y * f3) * c5 - (x3_y * c4 + c1 * s4) * s5)
    z5_z, p6_x = f2 * z4_z - f3 * ((z3_z * f3 - v5 * f2) * c5 - x3_z * c4 * s5), p5_x - z5_x * g4
    p6_y, p6_z = p5_y - z5_y * g4, p5_z - z5_z * g4
    v7, v8, v9 = p6_z - D1, p6_z - p2_z, p6_x - p3_x
    v10, v11, v12 = p6_y - p3_y, p6_x - p4_x, p6_y - p4_y
    v13, v14, v15 = p6_z - p4_z, p6_x - p5_x, p6_y - p5_y
    v16 = p6_z - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, -(c1 * v7), c1 * v8
    J[0, 3], J[0, 4] = z3_y * v8 - z3_z * v10, z4_y * v13 - z4_z * v12
    J[0, 5] = z5_y * v16 - z5_z * v15
    J[1, 0], J[1, 1], J[1, 2] = p6_x, -(s1 * v7), s1 * v8
    J[1, 3], J[1, 4] = z3_z * v9 - z3_x * v8, z4_z * v11 - z4_x * v13
    J[1, 5] = z5_z * v14 - z5_x * v16
    J[2, 1], J[2, 2] = s1 * p6_y + c1 * p6_x, -(s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x))
    J[2, 3], J[2, 4] = z3_x * v10 - z3_y * v9, z4_x * v12 - z4_y * v11
    J[2, 5] = z5_x * v15 - z5_y * v14
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
    size=0.3687091878934751, reach=4.000000004,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0,
            -0.008859737618621246, 0.9230769230769231, 0.38461538461538464, 0.0,
            7.472013737079356e-10,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, 1.1119874781055206, -0.8823529411764706,
            -0.47058823529411764, 0.0, 0.0, 0.0, 0.0, -1.0, 0.008859737627480985,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.0, 0.0, 0.0, -1.0, 0.3400374515881446, 0.96, 0.28, 0.0,
            -0.00885973764520046,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.36206896551724144,
            0.34482758620689663, -0.8660254037844387, 0.0025965570034597847, 0.627121844119766,
            0.597258899161682, 0.5000000000000001, -0.34003745192818213,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.4729729729729731,
            0.1621621621621622, -0.8660254037844387, -0.09945863557349463, 0.8192132197960906,
            0.28087310393008824, 0.5000000000000001, -0.1722674102944599,
        )),
        _loops.Link((0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.2754999997245)),
        _loops.Link((
            1.0, 0.0, 0.0, -0.0, 0.0, -1.0, 0.0, -0.0, 0.0, 0.0, -1.0, -0.25394150957778494,
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
        _loops.Formulation(joints=(4, 3, 2, 1, 0, 5), sign=-1.0),
        _loops.Formulation(joints=(1, 2, 3, 4, 5, 0), sign=1.0),
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
