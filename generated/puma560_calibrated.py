"""puma560_calibrated: PUMA 560 with calibration noise of 1e-3.

Inverse kinematics, generated from robots/puma560_calibrated.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/puma560_calibrated.yaml. The formulas and where they come from:
puma560_calibrated.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Every entry of
a pose counts.
"""

import math
import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType

import numpy as np

# The runtime that lies beside this file, by whatever name this is imported, and no other one: it is
# in a package named after the folder. A dot in a name would be one between packages.
_BESIDE = str(Path(__file__).resolve().parent)
_FOLDER = _BESIDE.replace("%", "%25").replace(".", "%2E")
sys.modules.setdefault(_FOLDER, ModuleType(_FOLDER)).__path__ = [_BESIDE]


def _runtime(name):
    return import_module(f"{_FOLDER}.dhgen_runtime.{name}")


_HOW = _runtime("jit").of_file(__file__, interface=1)
_arms, _status, _functions = _runtime("arm"), _runtime("status"), _runtime("functions")
_of_joints = _runtime("entry").of_joints(_HOW, 6)

NAME = "puma560_calibrated"
METHOD = "general 6R"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "root1",
    "root2",
    "root3",
    "root4",
    "root5",
    "root6",
    "root7",
    "root8",
    "root9",
    "root10",
    "root11",
    "root12",
    "root13",
    "root14",
    "root15",
    "root16",
)
MAX_SOLUTIONS = 16

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.6712591624431  # joint offset 1 [m]
a1 = 0.0026544606897  # link length 1 [m]
ca1 = 0.0016085442592340678  # cosine of twist 1
sa1 = 0.9999987062918462  # sine of twist 1
d2 = -0.000143425944  # joint offset 2 [m]
a2 = 0.4314454936115  # link length 2 [m]
ca2 = 0.9999994314394958  # cosine of twist 2
sa2 = 0.001066358610003491  # sine of twist 2
d3 = 0.1490653237899  # joint offset 3 [m]
a3 = 0.0201858398555  # link length 3 [m]
ca3 = 0.0017412729567630927  # cosine of twist 3
sa3 = 0.9999984839830959  # sine of twist 3
d4 = 0.432695688237  # joint offset 4 [m]
a4 = -0.001863305965  # link length 4 [m]
ca4 = 0.001238887228280428  # cosine of twist 4
sa4 = 0.9999992325789233  # sine of twist 4
d5 = -0.00062817974  # joint offset 5 [m]
a5 = -6.29954602e-05  # link length 5 [m]
ca5 = 0.0007308690395286796  # cosine of twist 5
sa5 = 0.9999997329151878  # sine of twist 5
d6 = -0.0012011655652  # joint offset 6 [m]
a6 = -9.3840846e-05  # link length 6 [m]
ca6 = 0.9999988042061223  # cosine of twist 6
sa6 = 0.0015464754525777457  # sine of twist 6
offset1 = 0.0004277699642  # offset of joint 1 [rad]
offset2 = 0.0006617156617  # offset of joint 2 [rad]
offset3 = -0.0018179220006  # offset of joint 3 [rad]
offset4 = 8.90468712e-05  # offset of joint 4 [rad]
offset5 = 0.0009695294734  # offset of joint 5 [rad]
offset6 = -0.0022050175347  # offset of joint 6 [rad]
f1 = -2.3070697884642687e-07  # d2 * ca1 [m]
f2 = 1.7152850204059354e-06  # sa2 * ca1
f3 = 0.0016085433446793326  # ca2 * ca1
turn = 2.0 * math.pi  # [rad]
half_turn = 0.5 * turn

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16,
    size=1.7112988821471,
    coordinates=(0, 1, 2),
    directions='rotation',
    joints=(
        _joints.Joint(place=0, zero=0.0004277699642),
        _joints.Joint(place=1, zero=0.0006617156617),
        _joints.Joint(place=2, zero=-0.0018179220006),
        _joints.Joint(place=3, zero=8.90468712e-05),
        _joints.Joint(place=4, zero=0.0009695294734),
        _joints.Joint(place=5, zero=-0.0022050175347),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.0026544606897, 0.0, 0.0016085442592340678, -0.9999987062918462,
                0.0, 0.0, 0.9999987062918462, 0.0016085442592340678, 0.6712591624431,
            ),
            offset=0.0004277699642,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.4314454936115, 0.0, 0.9999994314394958, -0.001066358610003491, 0.0,
                0.0, 0.001066358610003491, 0.9999994314394958, -0.000143425944,
            ),
            offset=0.0006617156617,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.0201858398555, 0.0, 0.0017412729567630927, 0.9999984839830959, 0.0,
                0.0, -0.9999984839830959, 0.0017412729567630927, 0.1490653237899,
            ),
            offset=-0.0018179220006,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -0.001863305965, 0.0, 0.001238887228280428, -0.9999992325789233, 0.0,
                0.0, 0.9999992325789233, 0.001238887228280428, 0.432695688237,
            ),
            offset=8.90468712e-05,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -6.29954602e-05, 0.0, 0.0007308690395286796, 0.9999997329151878, 0.0,
                0.0, -0.9999997329151878, 0.0007308690395286796, -0.00062817974,
            ),
            offset=0.0009695294734,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -9.3840846e-05, 0.0, 0.9999988042061223, 0.0015464754525777457, 0.0,
                0.0, -0.0015464754525777457, 0.9999988042061223, -0.0012011655652,
            ),
            offset=-0.0022050175347,
        ),
    ),
)
_ARM = _arms.arm_numbers(
    _arms.Arm(
        types=JOINT_TYPES,
        limits=JOINT_LIMITS,
        slacks=(1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09),
        weights=(1.0, 1.0, 1.0, 1.0, 1.0, 1.0),
        paces=(1.0, 1.0, 1.0, 1.0, 1.0, 1.0),
        fan_steps=(),
        rows=16,
        directions='rotation',
        miss_weights=(0.5844, 0.5844, 0.5844, 1.0, 1.0, 1.0),
        size=1.7112988821471,
        clamped=1e-14,
        clamped_again=1e-10,
    ),
)


# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0004277699642, 0.6712591624431, 0.0026544606897, 1.569187781842),
    (0.0006617156617, -0.000143425944, 0.4314454936115, 0.0010663588121),
    (-0.0018179220006, 0.1490653237899, 0.0201858398555, -1.5690550529582),
    (8.90468712e-05, 0.432695688237, -0.001863305965, 1.5695574392497),
    (0.0009695294734, -0.00062817974, -6.29954602e-05, -1.5700654576903),
    (-0.0022050175347, -0.0012011655652, -9.3840846e-05, -0.001546476069),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES,
    table=TABLE,
    convention="standard",
)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    T = np.zeros((4, 4))
    v1 = q[0] + offset1
    c1 = math.cos(v1)
    s1 = math.sin(v1)
    v2 = s1 * ca1
    y1_y = c1 * ca1
    z1_x = s1 * sa1
    v3 = c1 * sa1
    v4 = q[1] + offset2
    c2 = math.cos(v4)
    s2 = math.sin(v4)
    x2_x = c1 * c2 - v2 * s2
    x2_y = s1 * c2 + y1_y * s2
    x2_z = sa1 * s2
    v5 = v2 * c2 + c1 * s2
    v6 = y1_y * c2 - s1 * s2
    v7 = sa1 * c2
    y2_x = z1_x * sa2 - v5 * ca2
    y2_y = v6 * ca2 - v3 * sa2
    y2_z = v7 * ca2 + f2
    z2_x = v5 * sa2 + z1_x * ca2
    v8 = v6 * sa2 + v3 * ca2
    z2_z = f3 - v7 * sa2
    v9 = q[2] + offset3
    c3 = math.cos(v9)
    s3 = math.sin(v9)
    x3_x = x2_x * c3 + y2_x * s3
    x3_y = x2_y * c3 + y2_y * s3
    x3_z = x2_z * c3 + y2_z * s3
    v10 = y2_x * c3 - x2_x * s3
    v11 = y2_y * c3 - x2_y * s3
    v12 = y2_z * c3 - x2_z * s3
    y3_x = v10 * ca3 - z2_x * sa3
    y3_y = v11 * ca3 + v8 * sa3
    y3_z = v12 * ca3 - z2_z * sa3
    z3_x = v10 * sa3 + z2_x * ca3
    z3_y = v11 * sa3 - v8 * ca3
    z3_z = v12 * sa3 + z2_z * ca3
    v13 = q[3] + offset4
    c4 = math.cos(v13)
    s4 = math.sin(v13)
    x4_x = x3_x * c4 + y3_x * s4
    x4_y = x3_y * c4 + y3_y * s4
    x4_z = x3_z * c4 + y3_z * s4
    v14 = y3_x * c4 - x3_x * s4
    v15 = y3_y * c4 - x3_y * s4
    v16 = y3_z * c4 - x3_z * s4
    y4_x = v14 * ca4 + z3_x * sa4
    y4_y = v15 * ca4 + z3_y * sa4
    y4_z = v16 * ca4 + z3_z * sa4
    z4_x = z3_x * ca4 - v14 * sa4
    z4_y = z3_y * ca4 - v15 * sa4
    z4_z = z3_z * ca4 - v16 * sa4
    v17 = q[4] + offset5
    c5 = math.cos(v17)
    s5 = math.sin(v17)
    x5_x = x4_x * c5 + y4_x * s5
    x5_y = x4_y * c5 + y4_y * s5
    x5_z = x4_z * c5 + y4_z * s5
    v18 = y4_x * c5 - x4_x * s5
    v19 = y4_y * c5 - x4_y * s5
    v20 = y4_z * c5 - x4_z * s5
    y5_x = v18 * ca5 - z4_x * sa5
    y5_y = v19 * ca5 - z4_y * sa5
    y5_z = v20 * ca5 - z4_z * sa5
    z5_x = v18 * sa5 + z4_x * ca5
    z5_y = v19 * sa5 + z4_y * ca5
    z5_z = v20 * sa5 + z4_z * ca5
    v21 = q[5] + offset6
    c6 = math.cos(v21)
    s6 = math.sin(v21)
    x6_x = x5_x * c6 + y5_x * s6
    x6_y = x5_y * c6 + y5_y * s6
    x6_z = x5_z * c6 + y5_z * s6
    v22 = y5_x * c6 - x5_x * s6
    v23 = y5_y * c6 - x5_y * s6
    v24 = y5_z * c6 - x5_z * s6
    T[0, 0] = x6_x
    T[0, 1] = v22 * ca6 - z5_x * sa6
    T[0, 2] = v22 * sa6 + z5_x * ca6
    T[0, 3] = c1 * a1 + x2_x * a2 + z1_x * d2 + x3_x * a3 + z2_x * d3 + x4_x * a4 + z3_x * d4 + x5_x * a5 + z4_x * d5 + x6_x * a6 + z5_x * d6
    T[1, 0] = x6_y
    T[1, 1] = v23 * ca6 - z5_y * sa6
    T[1, 2] = v23 * sa6 + z5_y * ca6
    T[1, 3] = s1 * a1 + x2_y * a2 - v3 * d2 + x3_y * a3 - v8 * d3 + x4_y * a4 + z3_y * d4 + x5_y * a5 + z4_y * d5 + x6_y * a6 + z5_y * d6
    T[2, 0] = x6_z
    T[2, 1] = v24 * ca6 - z5_z * sa6
    T[2, 2] = v24 * sa6 + z5_z * ca6
    T[2, 3] = d1 + x2_z * a2 + f1 + x3_z * a3 + z2_z * d3 + x4_z * a4 + z3_z * d4 + x5_z * a5 + z4_z * d5 + x6_z * a6 + z5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    J = np.zeros((6, 6))
    v1 = q[0] + offset1
    c1 = math.cos(v1)
    s1 = math.sin(v1)
    p1_x = c1 * a1
    p1_y = s1 * a1
    v2 = s1 * ca1
    y1_y = c1 * ca1
    z1_x = s1 * sa1
    v3 = c1 * sa1
    v4 = q[1] + offset2
    c2 = math.cos(v4)
    s2 = math.sin(v4)
    x2_x = c1 * c2 - v2 * s2
    x2_y = s1 * c2 + y1_y * s2
    x2_z = sa1 * s2
    v5 = v2 * c2 + c1 * s2
    v6 = y1_y * c2 - s1 * s2
    v7 = sa1 * c2
    p2_x = p1_x + x2_x * a2 + z1_x * d2
    p2_y = p1_y + x2_y * a2 - v3 * d2
    p2_z = d1 + x2_z * a2 + f1
    y2_x = z1_x * sa2 - v5 * ca2
    y2_y = v6 * ca2 - v3 * sa2
    y2_z = v7 * ca2 + f2
    z2_x = v5 * sa2 + z1_x * ca2
    v8 = v6 * sa2 + v3 * ca2
    z2_z = f3 - v7 * sa2
    v9 = q[2] + offset3
    c3 = math.cos(v9)
    s3 = math.sin(v9)
    x3_x = x2_x * c3 + y2_x * s3
    x3_y = x2_y * c3 + y2_y * s3
    x3_z = x2_z * c3 + y2_z * s3
    v10 = y2_x * c3 - x2_x * s3
    v11 = y2_y * c3 - x2_y * s3
    v12 = y2_z * c3 - x2_z * s3
    p3_x = p2_x + x3_x * a3 + z2_x * d3
    p3_y = p2_y + x3_y * a3 - v8 * d3
    p3_z = p2_z + x3_z * a3 + z2_z * d3
    y3_x = v10 * ca3 - z2_x * sa3
    y3_y = v11 * ca3 + v8 * sa3
    y3_z = v12 * ca3 - z2_z * sa3
    z3_x = v10 * sa3 + z2_x * ca3
    z3_y = v11 * sa3 - v8 * ca3
    z3_z = v12 * sa3 + z2_z * ca3
    v13 = q[3] + offset4
    c4 = math.cos(v13)
    s4 = math.sin(v13)
    x4_x = x3_x * c4 + y3_x * s4
    x4_y = x3_y * c4 + y3_y * s4
    x4_z = x3_z * c4 + y3_z * s4
    v14 = y3_x * c4 - x3_x * s4
    v15 = y3_y * c4 - x3_y * s4
    v16 = y3_z * c4 - x3_z * s4
    p4_x = p3_x + x4_x * a4 + z3_x * d4
    p4_y = p3_y + x4_y * a4 + z3_y * d4
    p4_z = p3_z + x4_z * a4 + z3_z * d4
    y4_x = v14 * ca4 + z3_x * sa4
    y4_y = v15 * ca4 + z3_y * sa4
    y4_z = v16 * ca4 + z3_z * sa4
    z4_x = z3_x * ca4 - v14 * sa4
    z4_y = z3_y * ca4 - v15 * sa4
    z4_z = z3_z * ca4 - v16 * sa4
    v17 = q[4] + offset5
    c5 = math.cos(v17)
    s5 = math.sin(v17)
    x5_x = x4_x * c5 + y4_x * s5
    x5_y = x4_y * c5 + y4_y * s5
    x5_z = x4_z * c5 + y4_z * s5
    v18 = y4_x * c5 - x4_x * s5
    v19 = y4_y * c5 - x4_y * s5
    v20 = y4_z * c5 - x4_z * s5
    p5_x = p4_x + x5_x * a5 + z4_x * d5
    p5_y = p4_y + x5_y * a5 + z4_y * d5
    p5_z = p4_z + x5_z * a5 + z4_z * d5
    z5_x = v18 * sa5 + z4_x * ca5
    z5_y = v19 * sa5 + z4_y * ca5
    z5_z = v20 * sa5 + z4_z * ca5
    v21 = q[5] + offset6
    c6 = math.cos(v21)
    s6 = math.sin(v21)
    p6_x = p5_x + (x5_x * c6 + (v18 * ca5 - z4_x * sa5) * s6) * a6 + z5_x * d6
    p6_y = p5_y + (x5_y * c6 + (v19 * ca5 - z4_y * sa5) * s6) * a6 + z5_y * d6
    p6_z = p5_z + (x5_z * c6 + (v20 * ca5 - z4_z * sa5) * s6) * a6 + z5_z * d6
    v22 = p6_x - p1_x
    v23 = p6_y - p1_y
    v24 = p6_z - d1
    v25 = p6_x - p2_x
    v26 = p6_y - p2_y
    v27 = p6_z - p2_z
    v28 = p6_x - p3_x
    v29 = p6_y - p3_y
    v30 = p6_z - p3_z
    v31 = p6_x - p4_x
    v32 = p6_y - p4_y
    v33 = p6_z - p4_z
    v34 = p6_x - p5_x
    v35 = p6_y - p5_y
    v36 = p6_z - p5_z
    J[0, 0] = -p6_y
    J[0, 1] = -(v3 * v24 + ca1 * v23)
    J[0, 2] = -(v8 * v27 + z2_z * v26)
    J[0, 3] = z3_y * v30 - z3_z * v29
    J[0, 4] = z4_y * v33 - z4_z * v32
    J[0, 5] = z5_y * v36 - z5_z * v35
    J[1, 0] = p6_x
    J[1, 1] = ca1 * v22 - z1_x * v24
    J[1, 2] = z2_z * v25 - z2_x * v27
    J[1, 3] = z3_z * v28 - z3_x * v30
    J[1, 4] = z4_z * v31 - z4_x * v33
    J[1, 5] = z5_z * v34 - z5_x * v36
    J[2, 1] = z1_x * v23 + v3 * v22
    J[2, 2] = z2_x * v26 + v8 * v25
    J[2, 3] = z3_x * v29 - z3_y * v28
    J[2, 4] = z4_x * v32 - z4_y * v31
    J[2, 5] = z5_x * v35 - z5_y * v34
    J[3, 1] = z1_x
    J[3, 2] = z2_x
    J[3, 3] = z3_x
    J[3, 4] = z4_x
    J[3, 5] = z5_x
    J[4, 1] = -v3
    J[4, 2] = -v8
    J[4, 3] = z3_y
    J[4, 4] = z4_y
    J[4, 5] = z5_y
    J[5, 0] = 1.0
    J[5, 1] = ca1
    J[5, 2] = z2_z
    J[5, 3] = z3_z
    J[5, 4] = z4_z
    J[5, 5] = z5_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.46180216162714816,
    reach=4.0000000039999986,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.005748047346394125,
            0.0014848100854468322, 0.00061867086893618, -0.9999987062918463, -0.10776509798954229,
            0.9230757288847813, 0.38461488703532554, 0.001608544259234068, 1.4537379415938628e-09,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, 0.934264777131646, 0.8823524395054374,
            0.4705879677362333, -0.001066358610003491, -0.0002301637995154427,
            0.0009409046558854332, 0.000501815816472231, 0.9999994314394958, 0.10776495868305999,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.04371101205844448, 0.001671622038492569, 0.00048755642789366597,
            0.9999984839830959, 0.4683915670885376, -0.959998544623772, -0.2799995755152669,
            0.0017412729567630927, 0.10776514306515093,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, -0.004034857607497308,
            0.000897125234272034, 0.0008544049850209848, -0.9999992325789233, 0.000970397312505304,
            0.724137375315772, 0.6896546431578782, 0.001238887228280428, 0.46857850599669737,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, -0.00013641222461592016,
            0.0006913626049595618, 0.0002370386074147069, 0.9999997329151878,
            2.8495176635072937e-07, -0.9459456932981507, -0.32432423770222313,
            0.0007308690395286796, -0.0003898806422463197,
        )),
        _loops.Link((
            0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.6713392129385739,
        )),
        _loops.Link((
            1.0, 0.0, 0.0, 9.3840846e-05, 0.0, 0.9999988042061223, -0.0015464754525777457,
            -1.8577765638974755e-06, 0.0, 0.0015464754525777457, 0.9999988042061223,
            0.0012012957200730212,
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
        _loops.Formulation(joints=(5, 4, 3, 2, 1, 0), sign=-1.0),
        _loops.Formulation(joints=(3, 4, 5, 0, 1, 2), sign=1.0),
    ),
)
_NUMBERS = _loops.general_numbers(_LINKS, _LOOP)
_all_joints = _runtime("general.rows").all_joints
_NO_FREE = np.zeros(0)


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    nearby = np.empty((0, 6))
    # all joints: the general 6R loop
    solution_roots, solution_found, solution_chosen = _all_joints(
        _NUMBERS, pose, _NO_FREE, seed, nearby
    )

    for i1 in range(16):  # root1 to root16
        q1 = solution_roots[i1, 0]
        q2 = solution_roots[i1, 1]
        q3 = solution_roots[i1, 2]
        q4 = solution_roots[i1, 3]
        q5 = solution_roots[i1, 4]
        q6 = solution_roots[i1, 5]
        found = solution_found[i1]
        chosen = solution_chosen[i1]
        # all joints: the general 6R loop
        if not found:
            continue  # out of reach
        row = i1
        q[row, 0] = q1
        q[row, 1] = q2
        q[row, 2] = q3
        q[row, 3] = q4
        q[row, 4] = q5
        q[row, 5] = q6
        status[row] = FREE_JOINT if chosen else OK


_CALLS = _functions.of_robot(
    globals(),
    _HOW,
    _functions.Solver(
        arm=_ARM,
        robot=_HOW.addresses("_solve", "fk", "jacobian", None, None),
        task="pose",
        counted=(True, True, True),
        formulas=None,
        kinematics=(fk, jacobian),
        given=0,
        apart=(_whole.compile_apart,),
        words={
            "no_pose": "not finite, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)",
            "no_row": "the pose is out of reach",
            "allocates": "at every pose",
        },
    ),
)
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
joint_velocities = _CALLS["joint_velocities"]
