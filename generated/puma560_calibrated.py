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
_atan2 = _runtime("angles").atan2
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 6), _runtime("arrays").zeros

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
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
)
MAX_SOLUTIONS = 16

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

# In formulas below, near_arm_size1 = 1.0332489194603163 [m], near_a2 = 0.4314454936115 [m],
# near_a3 = -0.020185839855499987 [m], near_d4 = 0.4326956882369999 [m],
# near_k5 = 2 * near_d4 * near_a2 = 0.3733692095899602 [m^2],
# near_k6 = 2 * near_a3 * near_a2 = -0.01741817928083776 [m^2],
# near_k3 = 3.0774677988139795e-15 [m^2], near_longest3_apart = 0.7475535203061898 [m^2],
# near_k8 = 1 / ((2 * near_d4 * near_a2)^2 + (2 * near_a3 * near_a2)^2) = 7.157788307709011 [m^-4],
# near_doubt_limit = 9.999999999999999e-05.
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
near_angle = 0.0063859344  # the two arms' tools are turned by no more
near_length = 0.0076985885  # and no farther apart [m]
near_d3 = 0.14892189775631642  # joint offset 3 [m]
near_longest3 = 0.7475535203062076  # square of the longest reach [m^2]
near_shortest3 = 2.961108259928867e-06  # square of the shortest reach [m^2]
near_k1 = 0.022177731631342762  # near_d3^2 [m^2]
near_k4 = 0.9678209975988334  # 1 / near_arm_size1 [m^-1]
near_k7 = 0.37377824070723376  # near_a2^2 + (near_a3^2 + near_d4^2) [m^2]
near_turn1 = -1.6174138820106556  # atan2(-near_k5, near_k6) [rad]
near_m1 = 3.0774677988139795e-12  # 1000 * near_k3 [m^2]
# 1000 * (near_longest3 - near_longest3_apart) * (near_longest3_apart - near_shortest3) [m^4]
near_m2 = 1.3279165486287245e-11
near_m3 = 0.12467563999795989  # -near_k6 * near_k8 [m^-2]
near_m4 = 0.9989215120964166  # near_k5 * near_k7 * near_k8
near_m5 = 2.6724977628615725  # near_k5 * near_k8 [m^-2]
near_m6 = 0.04660104137748587  # -near_k6 * near_k7 * near_k8
near_m7 = 1.1588949413161114  # near_k8 * (near_d4 * near_k5 + near_a3 * near_k6) [m^-1]
# near_d4 * near_k5 * near_k7 * near_k8 + near_a3 * near_k6 * near_k7 * near_k8 - near_a2 [m]
near_m8 = 0.0017242187181490598
near_m9 = 9.999999999999999e-09  # near_doubt_limit^2
near1 = 0.0001185365297846645  # near_length^2 + near_length^2 [m^2]
near2 = 0.00017780479467699675  # near_length^2 + near_length^2 + near_length^2 [m^2]
near3 = 0.0011464884094649535  # near_d3 * near_length [m^2]
near4 = 0.5  # 1 / 2
near5 = 2.0390079080551684e-05  # near_angle^2 / 2
near6 = 2.216792657106042e-05  # near_m3 * near2
near7 = 0.00020605707709292137  # near_m7 * near2 [m]
near8 = 0.00047518291600033504  # near_m5 * near2
h1 = 0.00892185526792439  # near_m7 * near_length
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
    T = _zeros(4, 4)
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
    J = _zeros(6, 6)
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
_nearest, _COMPILED = _runtime("general.near"), _runtime("jit").COMPILED
_NONE_NEAR = np.zeros((0, 6))
_NO_FREE = np.zeros(0)


# The nearest arm with a structure: what follows is its closed form.
@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T11, T12, T13, T14 = kept[0 * w + k], kept[1 * w + k], kept[2 * w + k], kept[3 * w + k]
        T21, T22, T23, T24 = kept[4 * w + k], kept[5 * w + k], kept[6 * w + k], kept[7 * w + k]
        T31, T32, T33, T34 = kept[8 * w + k], kept[9 * w + k], kept[10 * w + k], kept[11 * w + k]

        # theta1, type 2: U1[3, 4]
        N1 = T14 * T14 + T24 * T24
        D1 = N1 - near_k1
        w1 = math.sqrt(D1)
        v1 = w1 - w1
        inverse1 = 1.0 / N1
        v2 = near_d3 * T24
        v3 = inverse1 * v2
        v4 = T14 * inverse1
        v5 = w1 * v4
        c1_p = v5 - v3
        v6 = v3 + v5
        v7 = near_d3 * T14
        v8 = inverse1 * v7
        v9 = T24 * inverse1
        v10 = w1 * v9
        s1_p = v8 + v10
        s1_m = v8 - v10

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        N3 = D1 + T34 * T34
        v11 = near_longest3 - N3
        v12 = N3 - near_shortest3
        D3 = v11 * v12
        w3 = math.sqrt(D3)
        v13 = w3 - w3
        v14 = near_m5 * N3 - near_m4
        v15 = near_m3 * w3
        s3_p = v14 - v15
        s3_m = v14 + v15
        v16 = near_m6 - near_m3 * N3
        v17 = near_m5 * w3
        c3_p = v16 - v17
        c3_m = v16 + v17

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        X1_2 = near_m7 * N3 - near_m8
        v19 = T34 * X1_2
        v20 = near_m7 * w1
        v21 = w3 * v20
        S2_pp = v19 - v21
        S2_pm = v19 + v21
        v22 = near_m7 * T34
        v23 = w3 * v22
        v24 = w1 * X1_2
        v25 = w1 * -X1_2
        C2_pp = v23 + v24
        C2_pm = v24 - v23
        C2_mp = v23 + v25
        C2_mm = v25 - v23
        factor2 = 1.0 / N3

        # theta4, type 2: U4[3, 3]
        c23_pp = c3_p * C2_pp - s3_p * S2_pp
        c23_pm = c3_m * C2_pm - s3_m * S2_pm
        c23_mp = c3_p * C2_mp - s3_p * S2_pm
        c23_mm = c3_m * C2_mm - s3_m * S2_pp
        s23_pp = c3_p * S2_pp + s3_p * C2_pp
        s23_pm = c3_m * S2_pm + s3_m * C2_pm
        s23_mp = c3_p * S2_pm + s3_p * C2_mp
        s23_mm = c3_m * S2_pp + s3_m * C2_mm
        v26 = c1_p * T13 + s1_p * T23
        v27 = s1_m * T23 - v6 * T13
        c4_pp = c23_pp * v26 + s23_pp * T33
        c4_pm = c23_pm * v26 + s23_pm * T33
        c4_mp = c23_mp * v27 + s23_mp * T33
        c4_mm = c23_mm * v27 + s23_mm * T33
        Y4_p = s1_p * T13 - c1_p * T23
        Y4_m = s1_m * T13 + v6 * T23
        v28 = Y4_p * Y4_p
        v29 = Y4_m * Y4_m
        v30 = factor2 * c4_pp
        v31 = factor2 * c4_pm
        v32 = factor2 * c4_mp
        v33 = factor2 * c4_mm
        v34 = v28 + factor2 * (c4_pp * v30)
        v35 = v28 + factor2 * (c4_pm * v31)
        v36 = v29 + factor2 * (c4_mp * v32)
        v37 = v29 + factor2 * (c4_mm * v33)
        v38 = math.copysign(half_turn, Y4_p)
        v39 = math.copysign(half_turn, Y4_m)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v40 = c1_p * T22 - s1_p * T12
        v41 = v6 * T22 + s1_m * T12
        v42 = c1_p * T12 + s1_p * T22
        v43 = s1_m * T22 - v6 * T12
        v44 = c1_p * T21 - s1_p * T11
        v45 = v6 * T21 + s1_m * T11
        v46 = c1_p * T11 + s1_p * T21
        v47 = s1_m * T21 - v6 * T11
        s6_pp = c4_pp * v44 + Y4_p * (c23_pp * v46 + s23_pp * T31)
        s6_pm = c4_pm * v44 + Y4_p * (c23_pm * v46 + s23_pm * T31)
        s6_mp = Y4_m * (c23_mp * v47 + s23_mp * T31) - c4_mp * v45
        s6_mm = Y4_m * (c23_mm * v47 + s23_mm * T31) - c4_mm * v45

        # joint values
        v48 = near_length * T14
        v49 = v48 + v48
        v50 = near_length * T24
        v51 = v50 + v50
        v52 = v49 * v49 + v51 * v51
        v53 = near1 + math.sqrt(v52)
        v54 = near_length * T34
        v55 = v54 + v54
        v56 = near2 + math.sqrt(v52 + v55 * v55)
        v57 = v11 * v49 - v12 * v49
        v58 = v11 * v51 - v12 * v51
        v59 = v11 * v55 - v12 * v55
        v60 = near2 * abs(v11) + near2 * abs(v12) + v56 * v56
        v61 = v60 + math.sqrt(v57 * v57 + v58 * v58 + v59 * v59)
        v62 = abs(N3)
        v63 = abs(inverse1)
        v64 = inverse1 * (inverse1 * v49)
        v65 = inverse1 * (inverse1 * v51)
        v66 = v63 * (near1 * v63)
        v67 = math.sqrt(N1) - math.sqrt(near1)
        v68 = v66 + (v66 + (abs(v64) + abs(v65))) * (v53 / (v67 * v67))
        v69 = near3 * inverse1
        v70 = v7 * v65
        v71 = v68 + math.sqrt(v64 * v64 + v65 * v65)
        v72 = v69 - v7 * v64
        v73 = near3 * v71
        v74 = v73 + v68 * abs(v7)
        v75 = near4 / w1
        v76 = v49 * v75
        v77 = v51 * v75
        v78 = v53 * v75
        v79 = v78 * v78 / w1
        v80 = v79 + (v79 + near1 * abs(v75))
        v81 = near_length * inverse1
        v82 = T24 * v64
        v83 = v81 - T24 * v65
        v84 = near_length * v71
        v85 = v84 + v68 * abs(T24)
        v86 = abs(w1)
        v87 = v80 + math.sqrt(v76 * v76 + v77 * v77)
        v88 = v9 * v76 - w1 * v82
        v89 = v72 + v88
        v90 = v72 + -v88
        v91 = v9 * v77
        v92 = w1 * v83 + v91 - v70
        v93 = w1 * -v83 - v91 - v70
        v94 = v85 * v86 + v80 * abs(v9)
        v95 = v82 * v82
        v96 = v74 + (v94 + v87 * (v85 + math.sqrt(v95 + v83 * v83)))
        v97 = v74 + (v94 + v87 * (v85 + math.sqrt(v95 + -v83 * -v83)))
        v98 = near_angle * T33
        v99 = near_angle * T23
        v100 = s1_p * v98
        v101 = s1_m * v98
        v102 = near5 * abs(s1_p)
        v103 = near5 * abs(s1_m)
        v104 = abs(T13)
        v105 = v96 + math.sqrt(v89 * v89 + v92 * v92)
        v106 = v97 + math.sqrt(v90 * v90 + v93 * v93)
        v107 = v98 * v98
        v108 = v99 * v99
        v109 = near5 + math.sqrt(v107 + v108)
        v110 = T14 * v65
        v111 = v81 - T14 * v64
        v112 = v84 + v68 * abs(T14)
        v113 = v2 * v64
        v114 = v73 + v68 * abs(v2)
        v115 = v4 * v76
        v116 = v113 + (w1 * v111 + v115)
        v117 = v113 + (w1 * -v111 - v115)
        v118 = v2 * v65 - v69
        v119 = v4 * v77 - w1 * v110
        v120 = v118 + v119
        v121 = v118 + -v119
        v122 = v86 * v112 + v80 * abs(v4)
        v123 = v110 * v110
        v124 = v114 + (v122 + v87 * (v112 + math.sqrt(v111 * v111 + v123)))
        v125 = v114 + (v122 + v87 * (v112 + math.sqrt(v123 + -v111 * -v111)))
        v126 = near_angle * T13
        v127 = c1_p * v98
        v128 = v6 * v98
        v129 = near5 * abs(c1_p)
        v130 = near5 * abs(v6)
        v131 = abs(T23)
        v132 = v124 + math.sqrt(v116 * v116 + v120 * v120)
        v133 = v125 + math.sqrt(v117 * v117 + v121 * v121)
        v134 = v126 * v126
        v135 = near5 + math.sqrt(v107 + v134)
        v136 = s1_p * v99 + c1_p * v126
        v137 = s1_m * v99 - v6 * v126
        v138 = T13 * v89 - T23 * v116
        v139 = T13 * v90 - T23 * v117
        v140 = T13 * v92 - T23 * v120
        v141 = T13 * v93 - T23 * v121
        v142 = v127 * v127 + v100 * v100
        v143 = v128 * v128 + v101 * v101
        v144 = (
            v102 + v96 * v104 + v105 * v109 + (v129 + v124 * v131 + v132 * v135) + (math.sqrt(v142 +
            v136 * v136) + math.sqrt(v138 * v138 + v140 * v140))
        )
        v145 = (
            v103 + v97 * v104 + v106 * v109 + (v130 + v125 * v131 + v133 * v135) + (math.sqrt(v143 +
            v137 * v137) + math.sqrt(v139 * v139 + v141 * v141))
        )
        v146 = abs(factor2)
        v147 = factor2 * (factor2 * v49)
        v148 = factor2 * (factor2 * v51)
        v149 = factor2 * (factor2 * v55)
        v150 = v146 * (near2 * v146)
        v151 = v150 + (v150 + (abs(v149) + (abs(v147) + abs(v148)))) * (v56 / (v62 - v56))
        v152 = near_m3 * v49
        v153 = near_m3 * v51
        v154 = near_m3 * v55
        v155 = near4 / w3
        v156 = v57 * v155
        v157 = v58 * v155
        v158 = v59 * v155
        v159 = v61 * v155
        v160 = v159 * v159 / w3
        v161 = v160 + (v160 + v60 * abs(v155))
        v162 = v161 + math.sqrt(v156 * v156 + v157 * v157 + v158 * v158)
        v163 = near_m5 * v156
        v164 = v152 + v163
        v165 = v152 - v163
        v166 = near_m5 * v157
        v167 = v153 + v166
        v168 = v153 - v166
        v169 = near_m5 * v158
        v170 = v154 + v169
        v171 = v154 - v169
        v172 = near6 + near_m5 * v161
        v173 = v22 * v156
        v174 = v22 * v157
        v175 = w3 * h1 + v22 * v158
        v176 = near_m7 * v49
        v177 = near_m7 * v51
        v178 = near_m7 * v55
        v179 = w1 * v178
        v180 = w1 * v176
        v181 = v180 + X1_2 * v76
        v182 = -X1_2 * v76 - v180
        v183 = w1 * v177
        v184 = v183 + X1_2 * v77
        v185 = -X1_2 * v77 - v183
        v186 = near7 + math.sqrt(v176 * v176 + v177 * v177 + v178 * v178)
        v187 = v173 + v181
        v188 = v181 - v173
        v189 = v173 + v182
        v190 = v182 - v173
        v191 = v174 + v184
        v192 = v184 - v174
        v193 = v174 + v185
        v194 = v185 - v174
        v195 = v175 + v179
        v196 = v179 - v175
        v197 = v161 * abs(v22) + v162 * h1 + (near7 * v86 + v80 * abs(X1_2) + v87 * v186)
        v198 = abs(c3_p)
        v199 = abs(c3_m)
        v200 = abs(C2_pp)
        v201 = abs(C2_pm)
        v202 = abs(C2_mp)
        v203 = abs(C2_mm)
        v204 = v172 + math.sqrt(v164 * v164 + v167 * v167 + v170 * v170)
        v205 = v172 + math.sqrt(v165 * v165 + v168 * v168 + v171 * v171)
        v206 = v195 * v195
        v207 = v197 + math.sqrt(v187 * v187 + v191 * v191 + v206)
        v208 = v197 + math.sqrt(v188 * v188 + v192 * v192 + v196 * v196)
        v209 = v197 + math.sqrt(v189 * v189 + v193 * v193 + -v196 * -v196)
        v210 = v197 + math.sqrt(v206 + (v190 * v190 + v194 * v194))
        v211 = near_m5 * v49
        v212 = near_m5 * v51
        v213 = near_m5 * v55
        v214 = near_m3 * v156
        v215 = v211 - v214
        v216 = v211 + v214
        v217 = near_m3 * v157
        v218 = v212 - v217
        v219 = v212 + v217
        v220 = near_m3 * v158
        v221 = v213 - v220
        v222 = v213 + v220
        v223 = near8 + near_m3 * v161
        v224 = T34 * v176
        v225 = T34 * v177
        v226 = T34 * v178 + near_length * X1_2
        v227 = near_m7 * v76
        v228 = near_m7 * v77
        v229 = near_m7 * v80
        v230 = w3 * v227 + v20 * v156
        v231 = v224 - v230
        v232 = v224 + v230
        v233 = w3 * v228 + v20 * v157
        v234 = v225 - v233
        v235 = v225 + v233
        v236 = v20 * v158
        v237 = v226 - v236
        v238 = v226 + v236
        v239 = (
            near7 * abs(T34) + near_length * v186 + (abs(w3) * v229 + v161 * abs(v20) + v162 * (v229
            + math.sqrt(v227 * v227 + v228 * v228)))
        )
        v240 = abs(s3_p)
        v241 = abs(s3_m)
        v242 = abs(S2_pp)
        v243 = abs(S2_pm)
        v244 = v223 + math.sqrt(v215 * v215 + v218 * v218 + v221 * v221)
        v245 = v223 + math.sqrt(v216 * v216 + v219 * v219 + v222 * v222)
        v246 = v239 + math.sqrt(v231 * v231 + v234 * v234 + v237 * v237)
        v247 = v239 + math.sqrt(v232 * v232 + v235 * v235 + v238 * v238)
        v248 = c3_p * v187 - C2_pp * v164 - (s3_p * v231 + S2_pp * v215)
        v249 = c3_m * v188 - C2_pm * v165 - (s3_m * v232 + S2_pm * v216)
        v250 = c3_p * v189 - C2_mp * v164 - (s3_p * v232 + S2_pm * v215)
        v251 = c3_m * v190 - C2_mm * v165 - (s3_m * v231 + S2_pp * v216)
        v252 = c3_p * v191 - C2_pp * v167 - (s3_p * v234 + S2_pp * v218)
        v253 = c3_m * v192 - C2_pm * v168 - (s3_m * v235 + S2_pm * v219)
        v254 = c3_p * v193 - C2_mp * v167 - (s3_p * v235 + S2_pm * v218)
        v255 = c3_m * v194 - C2_mm * v168 - (s3_m * v234 + S2_pp * v219)
        v256 = c3_p * v195 - C2_pp * v170 - (s3_p * v237 + S2_pp * v221)
        v257 = c3_m * v196 - C2_pm * v171 - (s3_m * v238 + S2_pm * v222)
        v258 = c3_p * -v196 - C2_mp * v170 - (s3_p * v238 + S2_pm * v221)
        v259 = c3_m * v195 + C2_mm * v171 + (s3_m * v237 + S2_pp * v222)
        v260 = v197 * v198
        v261 = v239 * v240
        v262 = v223 * v242
        v263 = v260 + v172 * v200 + v204 * v207 + (v261 + v262 + v244 * v246)
        v264 = v197 * v199
        v265 = v239 * v241
        v266 = v223 * v243
        v267 = v264 + v172 * v201 + v205 * v208 + (v265 + v266 + v245 * v247)
        v268 = v260 + v172 * v202 + v204 * v209 + (v261 + v266 + v244 * v247)
        v269 = v264 + v172 * v203 + v205 * v210 + (v262 + v265 + v245 * v246)
        v270 = s1_p * v126 - c1_p * v99
        v271 = s1_m * v126 + v6 * v99
        v272 = T13 * v116 + T23 * v89
        v273 = T13 * v117 + T23 * v90
        v274 = T13 * v120 + T23 * v92
        v275 = T13 * v121 + T23 * v93
        v276 = v129 + v104 * v124 + v109 * v132 + (v102 + v96 * v131 + v105 * v135)
        v277 = v130 + v104 * v125 + v109 * v133 + (v103 + v97 * v131 + v106 * v135)
        v278 = c23_pp * v270
        v279 = c23_pm * v270
        v280 = c23_mp * v271
        v281 = c23_mm * v271
        v282 = abs(v26)
        v283 = abs(v27)
        v284 = v276 + (math.sqrt(v142 + v270 * v270) + math.sqrt(v272 * v272 + v274 * v274))
        v285 = v277 + (math.sqrt(v143 + v271 * v271) + math.sqrt(v273 * v273 + v275 * v275))
        v286 = c3_p * v231 - S2_pp * v164 + (s3_p * v187 + C2_pp * v215)
        v287 = c3_m * v232 - S2_pm * v165 + (s3_m * v188 + C2_pm * v216)
        v288 = c3_p * v232 - S2_pm * v164 + (s3_p * v189 + C2_mp * v215)
        v289 = c3_m * v231 - S2_pp * v165 + (s3_m * v190 + C2_mm * v216)
        v290 = c3_p * v234 - S2_pp * v167 + (s3_p * v191 + C2_pp * v218)
        v291 = c3_m * v235 - S2_pm * v168 + (s3_m * v192 + C2_pm * v219)
        v292 = c3_p * v235 - S2_pm * v167 + (s3_p * v193 + C2_mp * v218)
        v293 = c3_m * v234 - S2_pp * v168 + (s3_m * v194 + C2_mm * v219)
        v294 = c3_p * v237 - S2_pp * v170 + (s3_p * v195 + C2_pp * v221)
        v295 = c3_m * v238 - S2_pm * v171 + (s3_m * v196 + C2_pm * v222)
        v296 = c3_p * v238 - S2_pm * v170 + (s3_p * -v196 + C2_mp * v221)
        v297 = c3_m * v237 - S2_pp * v171 + (C2_mm * v222 - s3_m * v195)
        v298 = v198 * v239
        v299 = v172 * v242
        v300 = v197 * v240
        v301 = v298 + v299 + v204 * v246 + (v300 + v200 * v223 + v207 * v244)
        v302 = v199 * v239
        v303 = v172 * v243
        v304 = v197 * v241
        v305 = v302 + v303 + v205 * v247 + (v304 + v201 * v223 + v208 * v245)
        v306 = v298 + v303 + v204 * v247 + (v300 + v202 * v223 + v209 * v244)
        v307 = v299 + v302 + v205 * v246 + (v304 + v203 * v223 + v210 * v245)
        v308 = abs(T33)
        v309 = near5 + math.sqrt(v108 + v134)
        v310 = s23_pp * v99 - c23_pp * v100
        v311 = s23_pm * v99 - c23_pm * v100
        v312 = s23_mp * v99 - c23_mp * v101
        v313 = s23_mm * v99 - c23_mm * v101
        v314 = c23_pp * v127 - s23_pp * v126
        v315 = c23_pm * v127 - s23_pm * v126
        v316 = c23_mp * v128 + s23_mp * v126
        v317 = c23_mm * v128 + s23_mm * v126
        v318 = c23_pp * v272 + v26 * v248 + T33 * v286
        v319 = c23_pm * v272 + v26 * v249 + T33 * v287
        v320 = c23_mp * v273 + v27 * v250 + T33 * v288
        v321 = c23_mm * v273 + v27 * v251 + T33 * v289
        v322 = c23_pp * v274 + v26 * v252 + T33 * v290
        v323 = c23_pm * v274 + v26 * v253 + T33 * v291
        v324 = c23_mp * v275 + v27 * v254 + T33 * v292
        v325 = c23_mm * v275 + v27 * v255 + T33 * v293
        v326 = v26 * v256 + T33 * v294
        v327 = v26 * v257 + T33 * v295
        v328 = v27 * v258 + T33 * v296
        v329 = T33 * v297 - v27 * v259
        v330 = (
            v276 * abs(c23_pp) + v263 * v282 + v284 * (v263 + math.sqrt(v248 * v248 + v252 * v252 +
            v256 * v256)) + (near5 * abs(s23_pp) + v301 * v308 + v309 * (v301 + math.sqrt(v286 *
            v286 + v290 * v290 + v294 * v294)))
        )
        v331 = (
            v276 * abs(c23_pm) + v267 * v282 + v284 * (v267 + math.sqrt(v249 * v249 + v253 * v253 +
            v257 * v257)) + (near5 * abs(s23_pm) + v305 * v308 + v309 * (v305 + math.sqrt(v287 *
            v287 + v291 * v291 + v295 * v295)))
        )
        v332 = (
            v277 * abs(c23_mp) + v268 * v283 + v285 * (v268 + math.sqrt(v250 * v250 + v254 * v254 +
            v258 * v258)) + (near5 * abs(s23_mp) + v306 * v308 + v309 * (v306 + math.sqrt(v288 *
            v288 + v292 * v292 + v296 * v296)))
        )
        v333 = (
            v277 * abs(c23_mm) + v269 * v283 + v285 * (v269 + math.sqrt(v251 * v251 + v255 * v255 +
            v259 * v259)) + (near5 * abs(s23_mm) + v307 * v308 + v309 * (v307 + math.sqrt(v289 *
            v289 + v293 * v293 + v297 * v297)))
        )
        v334 = factor2 * v310
        v335 = factor2 * v311
        v336 = factor2 * v312
        v337 = factor2 * v313
        v338 = factor2 * v314
        v339 = factor2 * v315
        v340 = factor2 * v316
        v341 = factor2 * v317
        v342 = factor2 * v278
        v343 = factor2 * v279
        v344 = factor2 * v280
        v345 = factor2 * v281
        v346 = v151 + math.sqrt(v147 * v147 + v148 * v148 + v149 * v149)
        v347 = factor2 * v318 - c4_pp * v147
        v348 = factor2 * v319 - c4_pm * v147
        v349 = factor2 * v320 - c4_mp * v147
        v350 = factor2 * v321 - c4_mm * v147
        v351 = factor2 * v322 - c4_pp * v148
        v352 = factor2 * v323 - c4_pm * v148
        v353 = factor2 * v324 - c4_mp * v148
        v354 = factor2 * v325 - c4_mm * v148
        v355 = factor2 * v326 - c4_pp * v149
        v356 = factor2 * v327 - c4_pm * v149
        v357 = factor2 * v328 - c4_mp * v149
        v358 = factor2 * v329 - c4_mm * v149
        v359 = (
            v146 * v330 + v151 * abs(c4_pp) + v346 * (v330 + (math.sqrt(v310 * v310 + v314 * v314 +
            v278 * v278) + math.sqrt(v318 * v318 + v322 * v322 + v326 * v326))) + (math.sqrt(v334 *
            v334 + v338 * v338 + v342 * v342) + math.sqrt(v347 * v347 + v351 * v351 + v355 * v355))
        )
        v360 = (
            v146 * v331 + v151 * abs(c4_pm) + v346 * (v331 + (math.sqrt(v311 * v311 + v315 * v315 +
            v279 * v279) + math.sqrt(v319 * v319 + v323 * v323 + v327 * v327))) + (math.sqrt(v335 *
            v335 + v339 * v339 + v343 * v343) + math.sqrt(v348 * v348 + v352 * v352 + v356 * v356))
        )
        v361 = (
            v146 * v332 + v151 * abs(c4_mp) + v346 * (v332 + (math.sqrt(v312 * v312 + v316 * v316 +
            v280 * v280) + math.sqrt(v320 * v320 + v324 * v324 + v328 * v328))) + (math.sqrt(v336 *
            v336 + v340 * v340 + v344 * v344) + math.sqrt(v349 * v349 + v353 * v353 + v357 * v357))
        )
        v362 = (
            v146 * v333 + v151 * abs(c4_mm) + v346 * (v333 + (math.sqrt(v313 * v313 + v317 * v317 +
            v281 * v281) + math.sqrt(v321 * v321 + v325 * v325 + v329 * v329))) + (math.sqrt(v337 *
            v337 + v341 * v341 + v345 * v345) + math.sqrt(v350 * v350 + v354 * v354 + v358 * v358))
        )
        v363 = v144 * v144
        v364 = v145 * v145

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if abs(v61 + (D3 + D3)) <= v61 or abs(v53 + (D1 + D1)) <= v53 or abs(N1) <= near1 or
            v62 <= v56 or abs(D1) <= near_m1 or abs(v37) <= v364 + v362 * v362 or v37 <= near_m9 or
            abs(v36) <= v364 + v361 * v361 or v36 <= near_m9 or abs(v35) <= v363 + v360 * v360 or
            v35 <= near_m9 or abs(v34) <= v363 + v359 * v359 or abs(D3 * (near_k4 * w1)) <= near_m2
            or v34 <= near_m9 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k], kept[20 * w + k] = v1, v13, v38, v39
        kept[21 * w + k], kept[22 * w + k], kept[23 * w + k] = s6_pp, s6_pm, s6_mp
        kept[24 * w + k], turns[0 * w + k], turns[1 * w + k] = s6_mm, w3, S2_pp
        turns[2 * w + k], turns[3 * w + k], turns[4 * w + k] = S2_pm, S2_pm, S2_pp
        turns[5 * w + k], turns[6 * w + k], turns[7 * w + k] = Y4_p, Y4_p, Y4_m
        turns[8 * w + k], turns[9 * w + k], turns[10 * w + k] = Y4_m, math.sqrt(v34), math.sqrt(v35)
        turns[11 * w + k], turns[12 * w + k] = math.sqrt(v36), math.sqrt(v37)
        turns[13 * w + k], turns[14 * w + k], turns[15 * w + k] = s6_pp, s6_pm, s6_mp
        turns[16 * w + k], turns[17 * w + k], turns[18 * w + k] = s6_mm, s1_p, s1_m
        turns[24 * w + k], turns[25 * w + k], turns[26 * w + k] = N3 - near_k7, C2_pp, C2_pm
        turns[27 * w + k], turns[28 * w + k], turns[29 * w + k] = C2_mp, C2_mm, v30
        turns[30 * w + k], turns[31 * w + k], turns[32 * w + k] = v31, v32, v33
        turns[33 * w + k] = factor2 * (c23_pp * T33 - s23_pp * v26)
        turns[34 * w + k] = factor2 * (c23_pm * T33 - s23_pm * v26)
        turns[35 * w + k] = factor2 * (c23_mp * T33 - s23_mp * v27)
        turns[36 * w + k] = factor2 * (c23_mm * T33 - s23_mm * v27)
        turns[37 * w + k] = c4_pp * v40 + Y4_p * (c23_pp * v42 + s23_pp * T32)
        turns[38 * w + k] = c4_pm * v40 + Y4_p * (c23_pm * v42 + s23_pm * T32)
        turns[39 * w + k] = Y4_m * (c23_mp * v43 + s23_mp * T32) - c4_mp * v41
        turns[40 * w + k] = Y4_m * (c23_mm * v43 + s23_mm * T32) - c4_mm * v41
        turns[41 * w + k], turns[42 * w + k] = c1_p, -v6
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 19 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(19 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        v1, v13, v38, v39 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k], kept[20 * w + k]
        s6_pp, s6_pm, s6_mp = kept[21 * w + k], kept[22 * w + k], kept[23 * w + k]
        s6_mm, angle1, angle2 = kept[24 * w + k], turns[0 * w + k], turns[1 * w + k]
        angle3, angle4, angle5 = turns[2 * w + k], turns[3 * w + k], turns[4 * w + k]
        angle6, angle7, angle8 = turns[5 * w + k], turns[6 * w + k], turns[7 * w + k]
        angle9, angle10, angle11 = turns[8 * w + k], turns[9 * w + k], turns[10 * w + k]
        angle12, angle13, angle14 = turns[11 * w + k], turns[12 * w + k], turns[13 * w + k]
        angle15, angle16, angle17 = turns[14 * w + k], turns[15 * w + k], turns[16 * w + k]
        angle18, angle19 = turns[17 * w + k], turns[18 * w + k]

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        q3__p = angle1 - near_turn1
        v18 = near_turn1 + angle1

        # theta4, type 2: U4[3, 3]
        q4_ppm = angle6 - v38
        q4_pmm = angle7 - v38
        q4_mpm = angle8 - v39
        q4_mmm = angle9 - v39

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle14 - math.copysign(half_turn, s6_pp)
        q6_pmm = angle15 - math.copysign(half_turn, s6_pm)
        q6_mpm = angle16 - math.copysign(half_turn, s6_mp)
        q6_mmm = angle17 - math.copysign(half_turn, s6_mm)

        # joint values
        q1_ppp = v13 + angle18
        q1_mpp = v13 + angle19
        q3_ppp = v1 + (q3__p + (-turn if half_turn < q3__p else 0.0))
        q3_pmp = v1 + ((-turn if half_turn < -v18 else 0.0) - v18)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, angle2, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle6, angle10, angle14
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, -angle10, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = angle3, q3_pmp, angle7
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = angle11, angle15, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = -angle11, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = angle4, angle8, angle12
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = angle16, q4_mpm, -angle12
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q6_mpm, angle5, angle9
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = angle13, angle17, q4_mmm
        rows[30 * w + k], rows[31 * w + k] = -angle13, q6_mmm
        rows[32 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[33 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[34 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[35 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[36 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[37 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[38 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[39 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK


# Where in rows the joint values of each row are.
_PLACES = np.array([
    [0, 1, 2, 3, 4, 5],
    [0, 1, 2, 6, 7, 8],
    [0, 9, 10, 11, 12, 13],
    [0, 9, 10, 14, 15, 16],
    [17, 18, 2, 19, 20, 21],
    [17, 18, 2, 22, 23, 24],
    [17, 25, 10, 26, 27, 28],
    [17, 25, 10, 29, 30, 31],
])

# What makes of a pose this arm's, before and behind it, and what its angles are more; where in rows
# these are.
_LEFT, _RIGHT = np.array((1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.6712591624)), np.array((-1.0, 0.0, 0.0, 9.38408e-05, -0.0, -0.999998804206049, -0.0015464755000093547, -1.8575731718540364e-06, 0.0, -0.0015464755000093547, 0.999998804206049, 0.0012011641636534413))
_OFFSETS = np.array((0.0, -3.5450000001824906e-07, -3.141592299089793, 3.141592235789793, 3.141592653889793, 0.0))
_ANGLES = np.ascontiguousarray(_PLACES[:, (0, 1, 2, 3, 4, 5)])


@_HOW.merged
def _nearby(pose, q_free):
    """Joint values that lead to all solutions; none where one of these rows may end."""
    kept, turns, rows = np.zeros(25), np.zeros(48), np.zeros(40)
    _nearest.near_pose(pose, _LEFT, _RIGHT, kept)
    _formulas(kept, turns, rows, len(kept) // 25)
    if kept[16] != 0.0:
        return np.empty((0, 6))
    return _nearest.near_solutions(rows, _ANGLES, _OFFSETS)


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    nearby = _nearby(pose, q_free) if _COMPILED else _NONE_NEAR
    _all_joints(_NUMBERS, pose, _NO_FREE, seed, nearby, q, status)


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
