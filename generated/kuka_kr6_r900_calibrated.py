"""kuka_kr6_r900_calibrated: KUKA KR 6 R900 with calibration noise of 1e-4.

Inverse kinematics, generated from robots/kuka_kr6_r900_calibrated.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kuka_kr6_r900_calibrated.yaml. The formulas and where they come from:
kuka_kr6_r900_calibrated.md.

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

NAME = "kuka_kr6_r900_calibrated"
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

# In formulas below, near_a2 = 0.45511099999999993 [m], near_a3 = -0.025039000000000033 [m],
# near_d4 = 0.42008600000000007 [m], near_k1 = 2 * near_d4 * near_a2 = 0.382371519092 [m^2],
# near_k2 = 2 * near_a3 * near_a2 = -0.022791048658000027 [m^2],
# near_doubt_limit1 = 9.25213e-05 [m], near_longest3_apart = 0.7672753622269346 [m^2],
# near_k4 = 1 / ((2 * near_d4 * near_a2)^2 + (2 * near_a3 * near_a2)^2) = 6.815359151455662 [m^-4],
# near_doubt_limit = 9.999999999999999e-05.
d1 = 0.400051  # joint offset 1 [m]
a1 = 0.024977  # link length 1 [m]
ca1 = 3.1999999994631904e-05  # cosine of twist 1
sa1 = 0.999999999488  # sine of twist 1
d2 = -2.1e-05  # joint offset 2 [m]
a2 = 0.455111  # link length 2 [m]
ca2 = 0.999999999118  # cosine of twist 2
sa2 = 4.1999999987652e-05  # sine of twist 2
d3 = 2.5e-05  # joint offset 3 [m]
a3 = 0.025039  # link length 3 [m]
ca3 = 1.899999999890931e-05  # cosine of twist 3
sa3 = 0.9999999998195  # sine of twist 3
d4 = 0.420086  # joint offset 4 [m]
a4 = 5.1e-05  # link length 4 [m]
ca4 = 4.9999999979333415e-05  # cosine of twist 4
sa4 = 0.99999999875  # sine of twist 4
d5 = -0.000174  # joint offset 5 [m]
a5 = -8.9e-05  # link length 5 [m]
ca5 = 4.6999999982665624e-05  # cosine of twist 5
sa5 = 0.9999999988955  # sine of twist 5
d6 = 0.089995  # joint offset 6 [m]
a6 = 5.2e-05  # link length 6 [m]
ca6 = 0.999999997952  # cosine of twist 6
sa6 = 6.399999995630933e-05  # sine of twist 6
offset1 = -2.6e-05  # offset of joint 1 [rad]
offset2 = -1.5708893267948965  # offset of joint 2 [rad]
offset3 = -1.5706923267948965  # offset of joint 3 [rad]
offset4 = -0.000167  # offset of joint 4 [rad]
offset5 = 3.141423653589793  # offset of joint 5 [rad]
offset6 = 3.1e-05  # offset of joint 6 [rad]
f1 = -6.719999998872699e-10  # ca1 * d2 [m]
f2 = 1.343999999379404e-09  # ca1 * sa2
f3 = 3.1999999966407905e-05  # ca1 * ca2
near_angle = 0.0001900018  # the two arms' tools are turned by no more
near_length = 0.0002999173  # and no farther apart [m]
near_a1 = -0.024977  # link length 1 [m]
near_longest3 = 0.7672753622269508  # square of the longest reach [m^2]
near_shortest3 = 0.001175080249049243  # square of the shortest reach [m^2]
near_k3 = 0.384225221238  # near_a2^2 + (near_a3^2 + near_d4^2) [m^2]
near_turn1 = -1.6303303533892188  # atan2(-near_k1, near_k2) [rad]
near_m1 = 8.560190953689999e-09  # near_doubt_limit1^2 [m^2]
# 1000 * (near_longest3 - near_longest3_apart) * (near_longest3_apart - near_shortest3) [m^4]
near_m3 = 1.2417915714465629e-11
near_m4 = 1.0986330807209672  # near_k4 * (near_d4 * near_k1 + near_a3 * near_k2) [m^-1]
# near_a2 - near_d4 * near_k1 * near_k3 * near_k4 - near_a3 * near_k2 * near_k3 * near_k4 [m]
near_m5 = 0.032988461500600814
near_m6 = 1.1860189164290886  # near_a2 * near_k1 * near_k4 [m^-1]
near_m7 = 0.07069201936857687  # -near_a2 * near_k2 * near_k4 [m^-1]
# near_k2 * near_k4 * (near_d4 * near_k1 * near_k3^2 * near_k4 + near_a3 * near_k2 * near_k3^2 *
# near_k4 - near_a2 * near_k3 - near_d4 * near_longest3 * near_shortest3 * near_k1 * near_k4 -
# near_a3 * near_longest3 * near_shortest3 * near_k2 * near_k4) [m]
near_m8 = 0.0021226567816523957
# near_k1 * near_k4 * (near_a2 * near_k3 + near_d4 * near_longest3 * near_shortest3 * near_k1 *
# near_k4 + near_a3 * near_longest3 * near_shortest3 * near_k2 * near_k4 - near_d4 * near_k1 *
# near_k3^2 * near_k4 - near_a3 * near_k2 * near_k3^2 * near_k4) [m]
near_m9 = 0.03561238055741952
near_m10 = 9.999999999999999e-09  # near_doubt_limit^2
near1 = 8.995038683929001e-08  # near_length^2 [m^2]
near2 = 1.7990077367858003e-07  # near_length^2 + near_length^2 [m^2]
near3 = 0.5  # 1 / 2
near4 = 1.805034200162e-08  # near_angle^2 / 2
near5 = 0.00035570759116433794  # near_m6 * near_length
near6 = 2.1201759580571282e-05  # near_m7 * near_length
h1 = 1.265278904119358e-07  # near5^2
h2 = 4.4951460931234614e-10  # near6^2
turn = 2.0 * math.pi  # [rad]
half_turn = 0.5 * turn

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16,
    size=1.4156710000000001,
    coordinates=(0, 1, 2),
    directions='rotation',
    joints=(
        _joints.Joint(place=0, zero=-2.6e-05),
        _joints.Joint(place=1, zero=-1.5708893267948965),
        _joints.Joint(place=2, zero=-1.5706923267948965),
        _joints.Joint(place=3, zero=-0.000167),
        _joints.Joint(place=4, zero=3.141423653589793),
        _joints.Joint(place=5, zero=3.1e-05),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.024977, 0.0, -3.1999999994631904e-05, 0.999999999488, 0.0, 0.0,
                -0.999999999488, -3.1999999994631904e-05, 0.400051,
            ),
            offset=-2.6e-05,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.455111, 0.0, 0.999999999118, -4.1999999987652e-05, 0.0, 0.0,
                4.1999999987652e-05, 0.999999999118, -2.1e-05,
            ),
            offset=-1.5708893267948965,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.025039, 0.0, 1.899999999890931e-05, 0.9999999998195, 0.0, 0.0,
                -0.9999999998195, 1.899999999890931e-05, 2.5e-05,
            ),
            offset=-1.5706923267948965,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 5.1e-05, 0.0, -4.9999999979333415e-05, -0.99999999875, 0.0, 0.0,
                0.99999999875, -4.9999999979333415e-05, 0.420086,
            ),
            offset=-0.000167,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -8.9e-05, 0.0, 4.6999999982665624e-05, -0.9999999988955, 0.0, 0.0,
                0.9999999988955, 4.6999999982665624e-05, -0.000174,
            ),
            offset=3.141423653589793,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 5.2e-05, 0.0, 0.999999997952, 6.399999995630933e-05, 0.0, 0.0,
                -6.399999995630933e-05, 0.999999997952, 0.089995,
            ),
            offset=3.1e-05,
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
        miss_weights=(0.7064, 0.7064, 0.7064, 1.0, 1.0, 1.0),
        size=1.4156710000000001,
        clamped=1e-14,
        clamped_again=1e-10,
    ),
)


# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (-2.6e-05, 0.400051, 0.024977, -1.5708283267948966),
    (-1.5708893267948965, -2.1e-05, 0.455111, 4.2e-05),
    (-1.5706923267948965, 2.5e-05, 0.025039, -1.5707773267948966),
    (-0.000167, 0.420086, 5.1e-05, 1.5708463267948967),
    (3.141423653589793, -0.000174, -8.9e-05, 1.5707493267948966),
    (3.1e-05, 0.089995, 5.2e-05, -6.4e-05),
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
    y1_x = s1 * ca1
    v2 = c1 * ca1
    v3 = s1 * sa1
    z1_y = c1 * sa1
    v4 = q[1] + offset2
    c2 = math.cos(v4)
    s2 = math.sin(v4)
    x2_x = c1 * c2 + y1_x * s2
    x2_y = s1 * c2 - v2 * s2
    v5 = sa1 * s2
    v6 = y1_x * c2 - c1 * s2
    v7 = v2 * c2 + s1 * s2
    v8 = sa1 * c2
    y2_x = v6 * ca2 - v3 * sa2
    y2_y = z1_y * sa2 - v7 * ca2
    v9 = v8 * ca2 + f2
    v10 = v6 * sa2 + v3 * ca2
    z2_y = v7 * sa2 + z1_y * ca2
    z2_z = v8 * sa2 - f3
    v11 = q[2] + offset3
    c3 = math.cos(v11)
    s3 = math.sin(v11)
    x3_x = x2_x * c3 + y2_x * s3
    x3_y = x2_y * c3 + y2_y * s3
    v12 = v5 * c3 + v9 * s3
    v13 = y2_x * c3 - x2_x * s3
    v14 = y2_y * c3 - x2_y * s3
    v15 = v5 * s3 - v9 * c3
    y3_x = v13 * ca3 + v10 * sa3
    y3_y = v14 * ca3 - z2_y * sa3
    y3_z = v15 * ca3 - z2_z * sa3
    z3_x = v13 * sa3 - v10 * ca3
    z3_y = v14 * sa3 + z2_y * ca3
    z3_z = v15 * sa3 + z2_z * ca3
    v16 = q[3] + offset4
    c4 = math.cos(v16)
    s4 = math.sin(v16)
    x4_x = x3_x * c4 + y3_x * s4
    x4_y = x3_y * c4 + y3_y * s4
    x4_z = y3_z * s4 - v12 * c4
    v17 = y3_x * c4 - x3_x * s4
    v18 = y3_y * c4 - x3_y * s4
    v19 = y3_z * c4 + v12 * s4
    y4_x = z3_x * sa4 - v17 * ca4
    y4_y = z3_y * sa4 - v18 * ca4
    y4_z = z3_z * sa4 - v19 * ca4
    v20 = v17 * sa4 + z3_x * ca4
    v21 = v18 * sa4 + z3_y * ca4
    v22 = v19 * sa4 + z3_z * ca4
    v23 = q[4] + offset5
    c5 = math.cos(v23)
    s5 = math.sin(v23)
    x5_x = x4_x * c5 + y4_x * s5
    x5_y = x4_y * c5 + y4_y * s5
    x5_z = x4_z * c5 + y4_z * s5
    v24 = y4_x * c5 - x4_x * s5
    v25 = y4_y * c5 - x4_y * s5
    v26 = y4_z * c5 - x4_z * s5
    y5_x = v24 * ca5 - v20 * sa5
    y5_y = v25 * ca5 - v21 * sa5
    y5_z = v26 * ca5 - v22 * sa5
    v27 = v24 * sa5 + v20 * ca5
    v28 = v25 * sa5 + v21 * ca5
    v29 = v26 * sa5 + v22 * ca5
    v30 = q[5] + offset6
    c6 = math.cos(v30)
    s6 = math.sin(v30)
    x6_x = x5_x * c6 + y5_x * s6
    x6_y = x5_y * c6 + y5_y * s6
    x6_z = x5_z * c6 + y5_z * s6
    v31 = y5_x * c6 - x5_x * s6
    v32 = y5_y * c6 - x5_y * s6
    v33 = y5_z * c6 - x5_z * s6
    T[0, 0] = x6_x
    T[0, 1] = v31 * ca6 + v27 * sa6
    T[0, 2] = v31 * sa6 - v27 * ca6
    T[0, 3] = c1 * a1 + x2_x * a2 - v3 * d2 + x3_x * a3 - v10 * d3 + x4_x * a4 + z3_x * d4 + x5_x * a5 - v20 * d5 + x6_x * a6 - v27 * d6
    T[1, 0] = x6_y
    T[1, 1] = v32 * ca6 + v28 * sa6
    T[1, 2] = v32 * sa6 - v28 * ca6
    T[1, 3] = s1 * a1 + x2_y * a2 + z1_y * d2 + x3_y * a3 + z2_y * d3 + x4_y * a4 + z3_y * d4 + x5_y * a5 - v21 * d5 + x6_y * a6 - v28 * d6
    T[2, 0] = x6_z
    T[2, 1] = v33 * ca6 + v29 * sa6
    T[2, 2] = v33 * sa6 - v29 * ca6
    T[2, 3] = d1 - v5 * a2 - f1 - v12 * a3 + z2_z * d3 + x4_z * a4 + z3_z * d4 + x5_z * a5 - v22 * d5 + x6_z * a6 - v29 * d6
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
    y1_x = s1 * ca1
    v2 = c1 * ca1
    v3 = s1 * sa1
    z1_y = c1 * sa1
    v4 = q[1] + offset2
    c2 = math.cos(v4)
    s2 = math.sin(v4)
    x2_x = c1 * c2 + y1_x * s2
    x2_y = s1 * c2 - v2 * s2
    v5 = sa1 * s2
    v6 = y1_x * c2 - c1 * s2
    v7 = v2 * c2 + s1 * s2
    v8 = sa1 * c2
    p2_x = p1_x + x2_x * a2 - v3 * d2
    p2_y = p1_y + x2_y * a2 + z1_y * d2
    p2_z = d1 - v5 * a2 - f1
    y2_x = v6 * ca2 - v3 * sa2
    y2_y = z1_y * sa2 - v7 * ca2
    v9 = v8 * ca2 + f2
    v10 = v6 * sa2 + v3 * ca2
    z2_y = v7 * sa2 + z1_y * ca2
    z2_z = v8 * sa2 - f3
    v11 = q[2] + offset3
    c3 = math.cos(v11)
    s3 = math.sin(v11)
    x3_x = x2_x * c3 + y2_x * s3
    x3_y = x2_y * c3 + y2_y * s3
    v12 = v5 * c3 + v9 * s3
    v13 = y2_x * c3 - x2_x * s3
    v14 = y2_y * c3 - x2_y * s3
    v15 = v5 * s3 - v9 * c3
    p3_x = p2_x + x3_x * a3 - v10 * d3
    p3_y = p2_y + x3_y * a3 + z2_y * d3
    p3_z = p2_z - v12 * a3 + z2_z * d3
    y3_x = v13 * ca3 + v10 * sa3
    y3_y = v14 * ca3 - z2_y * sa3
    y3_z = v15 * ca3 - z2_z * sa3
    z3_x = v13 * sa3 - v10 * ca3
    z3_y = v14 * sa3 + z2_y * ca3
    z3_z = v15 * sa3 + z2_z * ca3
    v16 = q[3] + offset4
    c4 = math.cos(v16)
    s4 = math.sin(v16)
    x4_x = x3_x * c4 + y3_x * s4
    x4_y = x3_y * c4 + y3_y * s4
    x4_z = y3_z * s4 - v12 * c4
    v17 = y3_x * c4 - x3_x * s4
    v18 = y3_y * c4 - x3_y * s4
    v19 = y3_z * c4 + v12 * s4
    p4_x = p3_x + x4_x * a4 + z3_x * d4
    p4_y = p3_y + x4_y * a4 + z3_y * d4
    p4_z = p3_z + x4_z * a4 + z3_z * d4
    y4_x = z3_x * sa4 - v17 * ca4
    y4_y = z3_y * sa4 - v18 * ca4
    y4_z = z3_z * sa4 - v19 * ca4
    v20 = v17 * sa4 + z3_x * ca4
    v21 = v18 * sa4 + z3_y * ca4
    v22 = v19 * sa4 + z3_z * ca4
    v23 = q[4] + offset5
    c5 = math.cos(v23)
    s5 = math.sin(v23)
    x5_x = x4_x * c5 + y4_x * s5
    x5_y = x4_y * c5 + y4_y * s5
    x5_z = x4_z * c5 + y4_z * s5
    v24 = y4_x * c5 - x4_x * s5
    v25 = y4_y * c5 - x4_y * s5
    v26 = y4_z * c5 - x4_z * s5
    p5_x = p4_x + x5_x * a5 - v20 * d5
    p5_y = p4_y + x5_y * a5 - v21 * d5
    p5_z = p4_z + x5_z * a5 - v22 * d5
    v27 = v24 * sa5 + v20 * ca5
    v28 = v25 * sa5 + v21 * ca5
    v29 = v26 * sa5 + v22 * ca5
    v30 = q[5] + offset6
    c6 = math.cos(v30)
    s6 = math.sin(v30)
    p6_x = p5_x + (x5_x * c6 + (v24 * ca5 - v20 * sa5) * s6) * a6 - v27 * d6
    p6_y = p5_y + (x5_y * c6 + (v25 * ca5 - v21 * sa5) * s6) * a6 - v28 * d6
    p6_z = p5_z + (x5_z * c6 + (v26 * ca5 - v22 * sa5) * s6) * a6 - v29 * d6
    v31 = p6_x - p1_x
    v32 = p6_y - p1_y
    v33 = p6_z - d1
    v34 = p6_x - p2_x
    v35 = p6_y - p2_y
    v36 = p6_z - p2_z
    v37 = p6_x - p3_x
    v38 = p6_y - p3_y
    v39 = p6_z - p3_z
    v40 = p6_x - p4_x
    v41 = p6_y - p4_y
    v42 = p6_z - p4_z
    v43 = p6_x - p5_x
    v44 = p6_y - p5_y
    v45 = p6_z - p5_z
    J[0, 0] = -p6_y
    J[0, 1] = z1_y * v33 + ca1 * v32
    J[0, 2] = z2_y * v36 - z2_z * v35
    J[0, 3] = z3_y * v39 - z3_z * v38
    J[0, 4] = v22 * v41 - v21 * v42
    J[0, 5] = v29 * v44 - v28 * v45
    J[1, 0] = p6_x
    J[1, 1] = v3 * v33 - ca1 * v31
    J[1, 2] = z2_z * v34 + v10 * v36
    J[1, 3] = z3_z * v37 - z3_x * v39
    J[1, 4] = v20 * v42 - v22 * v40
    J[1, 5] = v27 * v45 - v29 * v43
    J[2, 1] = -(v3 * v32 + z1_y * v31)
    J[2, 2] = -(v10 * v35 + z2_y * v34)
    J[2, 3] = z3_x * v38 - z3_y * v37
    J[2, 4] = v21 * v40 - v20 * v41
    J[2, 5] = v28 * v43 - v27 * v44
    J[3, 1] = -v3
    J[3, 2] = -v10
    J[3, 3] = z3_x
    J[3, 4] = -v20
    J[3, 5] = -v27
    J[4, 1] = z1_y
    J[4, 2] = z2_y
    J[4, 3] = z3_y
    J[4, 4] = -v21
    J[4, 5] = -v28
    J[5, 0] = 1.0
    J[5, 1] = -ca1
    J[5, 2] = z2_z
    J[5, 3] = z3_z
    J[5, 4] = -v22
    J[5, 5] = -v29
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.4508946910409257,
    reach=4.0000000039999986,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.055394309350457506,
            -2.9538461533506374e-05, -1.2307692305627655e-05, 0.999999999488, 5.907378613838845e-06,
            -0.9230769226043077, -0.38461538441846155, -3.1999999994631904e-05,
            8.872383044631429e-10,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, 1.0093509838169543, 0.8823529403982353,
            0.4705882348790589, -4.1999999987652006e-05, -2.4523306599316377e-09,
            3.705882351851647e-05, 1.976470587654212e-05, 0.9999999991180001, 5.907378588330026e-06,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.05553181374168657, 1.8239999998952937e-05, 5.319999999694607e-06,
            0.9999999998195, 0.46583605016172774, -0.95999999982672, -0.27999999994946007,
            1.899999999890931e-05, 5.907378744506423e-06,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.00011310845084971505,
            -3.620689653675868e-05, -3.448275860643684e-05, -0.99999999875, 0.00018130380869483623,
            0.7241379301293104, 0.6896551715517242, -4.9999999979333415e-05, 0.46583605065572053,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, -0.00019738533579656157,
            4.445945944306208e-05, 1.5243243237621286e-05, -0.9999999988955001,
            -9.615993722573778e-09, 0.9459459449011487, 0.32432432396610816, 4.699999998266563e-05,
            -0.000204595611172669,
        )),
        _loops.Link((
            0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.40005099951471357,
        )),
        _loops.Link((
            1.0, 0.0, 0.0, -5.2e-05, 0.0, 0.999999997952, -6.399999995630933e-05,
            5.759679718576826e-06, 0.0, 6.399999995630933e-05, 0.999999997952, -0.08999499547988973,
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
        v1 = T14 * T14 + T24 * T24
        w1 = math.sqrt(v1)
        v2 = 1.0 / v1

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        Z2_3_p = w1 - near_a1
        v3 = near_a1 + w1
        v4 = T34 * T34
        N3_p = v4 + Z2_3_p * Z2_3_p
        N3_m = v4 + v3 * v3
        v5 = near_longest3 - N3_p
        v6 = near_longest3 - N3_m
        v7 = N3_p - near_shortest3
        v8 = N3_m - near_shortest3
        D3_p = v5 * v7
        D3_m = v6 * v8
        w3_p = math.sqrt(D3_p)
        w3_m = math.sqrt(D3_m)

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        X1_2_p = near_m5 + near_m4 * N3_p
        X1_2_m = near_m5 + near_m4 * N3_m
        v11 = T34 * X1_2_p
        v12 = T34 * X1_2_m
        v13 = Z2_3_p * X1_2_p
        v14 = v3 * X1_2_m
        v15 = near_m4 * T34
        factor2_p = 1.0 / N3_p
        factor2_m = 1.0 / N3_m
        v16 = w3_p * v15
        v17 = w3_m * (near_m4 * v3)
        v18 = w3_m * v15

        # theta4, type 2: U4[3, 3]
        v19 = near_m7 * T34
        v20 = v19 - near_m6 * Z2_3_p
        v21 = v19 + near_m6 * v3
        v22 = near_m8 * factor2_p - near_m7
        v23 = near_m8 * factor2_m - near_m7
        v24 = near_m9 * factor2_p - near_m6
        v25 = near_m9 * factor2_m - near_m6
        v26 = Z2_3_p * v22 + T34 * v24
        v27 = T34 * v25 - v3 * v23
        v28 = factor2_p * v20
        v29 = factor2_p * -v20
        v30 = factor2_m * v21
        c23_pp = v26 + w3_p * v28
        c23_pm = v26 + w3_p * v29
        v31 = w3_m * v30
        c23_mp = v27 + v31
        c23_mm = v27 - v31
        v32 = near_m6 * T34
        v33 = v32 + near_m7 * Z2_3_p
        v34 = v32 - near_m7 * v3
        v35 = Z2_3_p * -v24 + T34 * v22
        v36 = T34 * v23 - v3 * -v25
        v37 = factor2_p * v33
        v38 = factor2_m * v34
        v39 = factor2_m * -v34
        v40 = w3_p * v37
        s23_pp = v35 - v40
        s23_pm = v35 + v40
        s23_mp = v36 - w3_m * v38
        s23_mm = v36 - w3_m * v39
        v41 = T14 * T13 + T24 * T23
        v42 = v2 * v41
        v43 = w1 * v42
        c4_pp = s23_pp * T33 + c23_pp * v43
        c4_pm = s23_pm * T33 + c23_pm * v43
        c4_mp = s23_mp * T33 - c23_mp * v43
        c4_mm = s23_mm * T33 - c23_mm * v43
        v44 = T24 * T13 - T14 * T23
        Y4 = w1 * (v2 * v44)
        v45 = Y4 * Y4
        v46 = v45 + c4_pp * c4_pp
        v47 = v45 + c4_pm * c4_pm
        v48 = v45 + c4_mp * c4_mp
        v49 = v45 + c4_mm * c4_mm
        v50 = math.copysign(half_turn, Y4)
        v51 = math.copysign(half_turn, -Y4)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v52 = w1 * (v2 * (T14 * T22 - T24 * T12))
        v53 = w1 * (v2 * (T14 * T12 + T24 * T22))
        v54 = w1 * (v2 * (T14 * T21 - T24 * T11))
        v55 = w1 * (v2 * (T14 * T11 + T24 * T21))
        v56 = c4_pp * v54 + Y4 * (s23_pp * T31 + c23_pp * v55)
        v57 = c4_pm * v54 + Y4 * (s23_pm * T31 + c23_pm * v55)

        # joint values
        v58 = near_length * T34
        v59 = abs(T34)
        v60 = v58 + v58
        v61 = near_length * T14
        v62 = v61 + v61
        v63 = near_length * T24
        v64 = v63 + v63
        v65 = near3 / w1
        v66 = v62 * v65
        v67 = v64 * v65
        v68 = near2 * abs(v65)
        v69 = v68 + math.sqrt(v66 * v66 + v67 * v67)
        v70 = Z2_3_p * v66
        v71 = v3 * v66
        v72 = Z2_3_p * v67
        v73 = v3 * v67
        v74 = abs(Z2_3_p)
        v75 = abs(v3)
        v76 = v68 * v74
        v77 = v68 * v75
        v78 = v70 + v70
        v79 = v71 + v71
        v80 = v72 + v72
        v81 = v73 + v73
        v82 = v69 * v69
        v83 = near1 + (v82 + (v76 + v76))
        v84 = near1 + (v82 + (v77 + v77))
        v85 = v60 * v60
        v86 = v83 + math.sqrt(v85 + (v78 * v78 + v80 * v80))
        v87 = v84 + math.sqrt(v85 + (v79 * v79 + v81 * v81))
        v88 = v5 * v78 - v7 * v78
        v89 = v6 * v79 - v8 * v79
        v90 = v5 * v80 - v7 * v80
        v91 = v6 * v81 - v8 * v81
        v92 = v5 * v60 - v7 * v60
        v93 = v6 * v60 - v8 * v60
        v94 = v83 * abs(v5) + v83 * abs(v7) + v86 * v86
        v95 = v84 * abs(v6) + v84 * abs(v8) + v87 * v87
        v96 = v94 + math.sqrt(v88 * v88 + v90 * v90 + v92 * v92)
        v97 = v95 + math.sqrt(v89 * v89 + v91 * v91 + v93 * v93)
        v98 = near1 + v82
        v99 = w1 * v2
        v100 = near_angle * T33
        v101 = near_angle * T23
        v102 = T24 * v100
        v103 = near4 * abs(T24)
        v104 = near_length * T13
        v105 = v100 * v100
        v106 = v101 * v101
        v107 = near_length * (near4 + math.sqrt(v105 + v106))
        v108 = near_angle * T13
        v109 = T14 * v100
        v110 = near4 * abs(T14)
        v111 = near_length * T23
        v112 = v108 * v108
        v113 = near_length * (near4 + math.sqrt(v105 + v112))
        v114 = T24 * v101 + T14 * v108
        v115 = v103 + v107 + (v110 + v113)
        v116 = abs(v2)
        v117 = v2 * (v2 * v62)
        v118 = v2 * (v2 * v64)
        v119 = v116 * (near2 * v116)
        v120 = w1 - math.sqrt(near2)
        v121 = (
            v119 + (v119 + (abs(v117) + abs(v118))) * ((near2 + math.sqrt(v62 * v62 + v64 * v64)) /
            (v120 * v120))
        )
        v122 = abs(w1)
        v123 = v121 + math.sqrt(v117 * v117 + v118 * v118)
        v124 = v2 * v66 - w1 * v117
        v125 = v2 * v67 - w1 * v118
        v126 = v121 * v122 + v68 * v116 + v69 * v123
        v127 = v99 * v109
        v128 = v99 * v102
        v129 = v99 * v114
        v130 = v109 * v109 + v102 * v102
        v131 = math.sqrt(v111 * v111 + v104 * v104)
        v132 = v44 * v124 - v99 * v111
        v133 = v44 * v125 + v99 * v104
        v134 = (
            v126 * abs(v44) + v115 * abs(v99) + (v115 + (v131 + math.sqrt(v130 + v114 * v114))) *
            (v126 + math.sqrt(v124 * v124 + v125 * v125)) + (math.sqrt(v127 * v127 + v128 * v128 +
            v129 * v129) + math.sqrt(v132 * v132 + v133 * v133))
        )
        v135 = abs(factor2_p)
        v136 = abs(factor2_m)
        v137 = factor2_p * (factor2_p * v78)
        v138 = factor2_m * (factor2_m * v79)
        v139 = factor2_p * (factor2_p * v80)
        v140 = factor2_m * (factor2_m * v81)
        v141 = factor2_p * (factor2_p * v60)
        v142 = factor2_m * (factor2_m * v60)
        v143 = v135 * (v83 * v135)
        v144 = v136 * (v84 * v136)
        v145 = math.sqrt(v98)
        v146 = math.sqrt(N3_p) - v145
        v147 = math.sqrt(N3_m) - v145
        v148 = v143 + (v143 + (abs(v141) + (abs(v137) + abs(v139)))) * (v86 / (v146 * v146))
        v149 = v144 + (v144 + (abs(v142) + (abs(v138) + abs(v140)))) * (v87 / (v147 * v147))
        v150 = near_m9 * v137
        v151 = near_m9 * v138
        v152 = near_m9 * v139
        v153 = near_m9 * v140
        v154 = near_m9 * v141
        v155 = near_m9 * v142
        v156 = near_m9 * v148
        v157 = near_m9 * v149
        v158 = v148 + math.sqrt(v137 * v137 + v139 * v139 + v141 * v141)
        v159 = v149 + math.sqrt(v138 * v138 + v140 * v140 + v142 * v142)
        v160 = v156 + math.sqrt(v150 * v150 + v152 * v152 + v154 * v154)
        v161 = v157 + math.sqrt(v151 * v151 + v153 * v153 + v155 * v155)
        v162 = near_m8 * v137
        v163 = near_m8 * v138
        v164 = near_m8 * v139
        v165 = near_m8 * v140
        v166 = near_m8 * v141
        v167 = near_m8 * v142
        v168 = near_m8 * v148
        v169 = near_m8 * v149
        v170 = v168 + math.sqrt(v162 * v162 + v164 * v164 + v166 * v166)
        v171 = v169 + math.sqrt(v163 * v163 + v165 * v165 + v167 * v167)
        v172 = Z2_3_p * v150 + -v24 * v66 - T34 * v162
        v173 = v3 * v151 + -v25 * v66 + T34 * v163
        v174 = Z2_3_p * v152 + -v24 * v67 - T34 * v164
        v175 = v3 * v153 + -v25 * v67 + T34 * v165
        v176 = Z2_3_p * v154 + (near_length * v22 - T34 * v166)
        v177 = near_length * v23 - T34 * v167 - v3 * v155
        v178 = v74 * v156 + v68 * abs(-v24) + v69 * v160 + (v59 * v168 + near_length * v170)
        v179 = v75 * v157 + v68 * abs(-v25) + v69 * v161 + (v59 * v169 + near_length * v171)
        v180 = near3 / w3_p
        v181 = near3 / w3_m
        v182 = v88 * v180
        v183 = v89 * v181
        v184 = v90 * v180
        v185 = v91 * v181
        v186 = v92 * v180
        v187 = v93 * v181
        v188 = v96 * v180
        v189 = v97 * v181
        v190 = v188 * v188 / w3_p
        v191 = v189 * v189 / w3_m
        v192 = v190 + (v190 + v94 * abs(v180))
        v193 = v191 + (v191 + v95 * abs(v181))
        v194 = near_m7 * v66
        v195 = near_m7 * v67
        v196 = near_m7 * v68
        v197 = factor2_p * v194 - v33 * v137
        v198 = factor2_m * v194
        v199 = v198 + v34 * v138
        v200 = v198 - -v34 * v138
        v201 = factor2_p * v195 - v33 * v139
        v202 = factor2_m * v195
        v203 = v202 + v34 * v140
        v204 = v202 - -v34 * v140
        v205 = near5 * factor2_p - v33 * v141
        v206 = near5 * factor2_m
        v207 = v206 - v34 * v142
        v208 = v206 + -v34 * v142
        v209 = v196 + math.sqrt(h1 + (v194 * v194 + v195 * v195))
        v210 = v135 * v196 + v148 * abs(v33) + v158 * v209
        v211 = v136 * v196 + v149 * abs(v34) + v159 * v209
        v212 = abs(w3_p)
        v213 = abs(w3_m)
        v214 = v192 + math.sqrt(v182 * v182 + v184 * v184 + v186 * v186)
        v215 = v193 + math.sqrt(v183 * v183 + v185 * v185 + v187 * v187)
        v216 = v37 * v182
        v217 = v172 - (w3_p * v197 + v216)
        v218 = v172 - (w3_p * -v197 - v216)
        v219 = v173 + (v38 * v183 - w3_m * v199)
        v220 = v173 + (w3_m * v200 + v39 * v183)
        v221 = v37 * v184
        v222 = v174 - (w3_p * v201 + v221)
        v223 = v174 - (w3_p * -v201 - v221)
        v224 = v175 + (v38 * v185 - w3_m * v203)
        v225 = v175 + (w3_m * v204 + v39 * v185)
        v226 = v37 * v186
        v227 = v176 - (w3_p * v205 + v226)
        v228 = v176 - (w3_p * -v205 - v226)
        v229 = v177 - (w3_m * v207 + v38 * v187)
        v230 = v177 - (v39 * v187 - w3_m * v208)
        v231 = v210 * v212 + v192 * abs(v37)
        v232 = v178 + (v231 + v214 * (v210 + math.sqrt(v197 * v197 + v201 * v201 + v205 * v205)))
        v233 = (
            v178 + (v231 + v214 * (v210 + math.sqrt(-v197 * -v197 + -v201 * -v201 + -v205 * -v205)))
        )
        v234 = v211 * v213
        v235 = (
            v179 + (v234 + v193 * abs(v38) + v215 * (v211 + math.sqrt(v199 * v199 + v203 * v203 +
            v207 * v207)))
        )
        v236 = (
            v179 + (v234 + v193 * abs(v39) + v215 * (v211 + math.sqrt(v200 * v200 + v204 * v204 +
            v208 * v208)))
        )
        v237 = abs(T33)
        v238 = near4 + math.sqrt(v106 + v112)
        v239 = v22 * v66 - Z2_3_p * v162 - T34 * v150
        v240 = v3 * v163 - v23 * v66 - T34 * v151
        v241 = v22 * v67 - Z2_3_p * v164 - T34 * v152
        v242 = v3 * v165 - v23 * v67 - T34 * v153
        v243 = near_length * v24 - T34 * v154 - Z2_3_p * v166
        v244 = near_length * v25 - T34 * v155 + v3 * v167
        v245 = v74 * v168 + v68 * abs(v22) + v69 * v170 + (v59 * v156 + near_length * v160)
        v246 = v75 * v169 + v68 * abs(v23) + v69 * v171 + (v59 * v157 + near_length * v161)
        v247 = near_m6 * v66
        v248 = near_m6 * v67
        v249 = near_m6 * v68
        v250 = factor2_p * v247
        v251 = v250 + v20 * v137
        v252 = -v20 * v137 - v250
        v253 = v21 * v138 - factor2_m * v247
        v254 = factor2_p * v248
        v255 = v254 + v20 * v139
        v256 = -v20 * v139 - v254
        v257 = v21 * v140 - factor2_m * v248
        v258 = near6 * factor2_p
        v259 = v258 - v20 * v141
        v260 = v258 + -v20 * v141
        v261 = near6 * factor2_m - v21 * v142
        v262 = v249 + math.sqrt(h2 + (v247 * v247 + v248 * v248))
        v263 = v135 * v249 + v148 * abs(v20) + v158 * v262
        v264 = v136 * v249 + v149 * abs(v21) + v159 * v262
        v265 = v239 + (v28 * v182 - w3_p * v251)
        v266 = v239 + (v29 * v182 - w3_p * v252)
        v267 = v30 * v183
        v268 = v240 + (v267 - w3_m * v253)
        v269 = v240 - (v267 + w3_m * -v253)
        v270 = v241 + (v28 * v184 - w3_p * v255)
        v271 = v241 + (v29 * v184 - w3_p * v256)
        v272 = v30 * v185
        v273 = v242 + (v272 - w3_m * v257)
        v274 = v242 - (v272 + w3_m * -v257)
        v275 = v243 + (w3_p * v259 + v28 * v186)
        v276 = v243 + (v29 * v186 - w3_p * v260)
        v277 = v30 * v187
        v278 = v244 + (w3_m * v261 + v277)
        v279 = v244 + (w3_m * -v261 - v277)
        v280 = v212 * v263
        v281 = (
            v245 + (v280 + v192 * abs(v28) + v214 * (v263 + math.sqrt(v251 * v251 + v255 * v255 +
            v259 * v259)))
        )
        v282 = (
            v245 + (v280 + v192 * abs(v29) + v214 * (v263 + math.sqrt(v252 * v252 + v256 * v256 +
            v260 * v260)))
        )
        v283 = v213 * v264 + v193 * abs(v30)
        v284 = v246 + (v283 + v215 * (v264 + math.sqrt(v253 * v253 + v257 * v257 + v261 * v261)))
        v285 = (
            v246 + (v283 + v215 * (v264 + math.sqrt(-v253 * -v253 + -v257 * -v257 + -v261 * -v261)))
        )
        v286 = T24 * v108 - T14 * v101
        v287 = v107 + v110 + (v103 + v113)
        v288 = v2 * v102
        v289 = v2 * v109
        v290 = v2 * v286
        v291 = v2 * v104 - v41 * v117
        v292 = v2 * v111 - v41 * v118
        v293 = (
            v116 * v287 + v121 * abs(v41) + v123 * (v287 + (v131 + math.sqrt(v130 + v286 * v286)))
        )
        v294 = w1 * v288
        v295 = w1 * v289
        v296 = w1 * v290
        v297 = w1 * v291 + v42 * v66
        v298 = w1 * v292 + v42 * v67
        v299 = (
            v122 * v293 + v68 * abs(v42) + v69 * (v293 + (math.sqrt(v288 * v288 + v289 * v289 + v290
            * v290) + math.sqrt(v291 * v291 + v292 * v292)))
        )
        v300 = abs(v43)
        v301 = (
            v299 + (math.sqrt(v294 * v294 + v295 * v295 + v296 * v296) + math.sqrt(v297 * v297 +
            v298 * v298))
        )
        v302 = c23_pp * v296
        v303 = c23_pm * v296
        v304 = c23_mp * v296
        v305 = c23_mm * v296
        v306 = s23_pp * v101 - c23_pp * v294
        v307 = s23_pm * v101 - c23_pm * v294
        v308 = s23_mp * v101 + c23_mp * v294
        v309 = s23_mm * v101 + c23_mm * v294
        v310 = c23_pp * v295 - s23_pp * v108
        v311 = c23_pm * v295 - s23_pm * v108
        v312 = c23_mp * v295 + s23_mp * v108
        v313 = c23_mm * v295 + s23_mm * v108
        v314 = T33 * v217 + (c23_pp * v297 + v43 * v265)
        v315 = T33 * v218 + (c23_pm * v297 + v43 * v266)
        v316 = T33 * v219 + (c23_mp * v297 + v43 * v268)
        v317 = T33 * v220 + (c23_mm * v297 + v43 * v269)
        v318 = T33 * v222 + (c23_pp * v298 + v43 * v270)
        v319 = T33 * v223 + (c23_pm * v298 + v43 * v271)
        v320 = T33 * v224 + (c23_mp * v298 + v43 * v273)
        v321 = T33 * v225 + (c23_mm * v298 + v43 * v274)
        v322 = T33 * v227 + v43 * v275
        v323 = T33 * v228 + v43 * v276
        v324 = T33 * v229 - v43 * v278
        v325 = T33 * v230 - v43 * v279
        v326 = (
            near4 * abs(s23_pp) + v232 * v237 + v238 * (v232 + math.sqrt(v217 * v217 + v222 * v222 +
            v227 * v227)) + (v299 * abs(c23_pp) + v281 * v300 + v301 * (v281 + math.sqrt(v265 * v265
            + v270 * v270 + v275 * v275))) + (math.sqrt(v306 * v306 + v310 * v310 + v302 * v302) +
            math.sqrt(v314 * v314 + v318 * v318 + v322 * v322))
        )
        v327 = (
            near4 * abs(s23_pm) + v233 * v237 + v238 * (v233 + math.sqrt(v218 * v218 + v223 * v223 +
            v228 * v228)) + (v299 * abs(c23_pm) + v282 * v300 + v301 * (v282 + math.sqrt(v266 * v266
            + v271 * v271 + v276 * v276))) + (math.sqrt(v307 * v307 + v311 * v311 + v303 * v303) +
            math.sqrt(v315 * v315 + v319 * v319 + v323 * v323))
        )
        v328 = (
            near4 * abs(s23_mp) + v235 * v237 + v238 * (v235 + math.sqrt(v219 * v219 + v224 * v224 +
            v229 * v229)) + (v299 * abs(c23_mp) + v284 * v300 + v301 * (v284 + math.sqrt(v268 * v268
            + v273 * v273 + v278 * v278))) + (math.sqrt(v308 * v308 + v312 * v312 + v304 * v304) +
            math.sqrt(v316 * v316 + v320 * v320 + v324 * v324))
        )
        v329 = (
            near4 * abs(s23_mm) + v236 * v237 + v238 * (v236 + math.sqrt(v220 * v220 + v225 * v225 +
            v230 * v230)) + (v299 * abs(c23_mm) + v285 * v300 + v301 * (v285 + math.sqrt(v269 * v269
            + v274 * v274 + v279 * v279))) + (math.sqrt(v309 * v309 + v313 * v313 + v305 * v305) +
            math.sqrt(v317 * v317 + v321 * v321 + v325 * v325))
        )
        v330 = v134 * v134

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if abs(v97 + (D3_m + D3_m)) <= v97 or abs(D3_m) <= near_m3 or abs(v96 + (D3_p +
            D3_p)) <= v96 or abs(D3_p) <= near_m3 or abs(v49) <= v330 + v329 * v329 or v49 <=
            near_m10 or abs(v48) <= v330 + v328 * v328 or v48 <= near_m10 or abs(v47) <= v330 + v327
            * v327 or v47 <= near_m10 or abs(v46) <= v330 + v326 * v326 or v46 <= near_m10 or
            abs(N3_m) <= v98 or v1 <= near_m1 or abs(v1) <= near2 or abs(N3_p) <= v98 else kept[16 *
            w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = w3_p, w3_m, c23_mp
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = c23_mm, s23_mp, s23_mm
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = c4_mp, c4_mm, Y4
        kept[26 * w + k], kept[27 * w + k], kept[28 * w + k], kept[29 * w + k] = v50, v51, v54, v55
        kept[30 * w + k], kept[31 * w + k], turns[0 * w + k], turns[1 * w + k] = v56, v57, T24, w3_p
        turns[2 * w + k], turns[3 * w + k] = w3_m, v11 - w3_p * (near_m4 * Z2_3_p)
        turns[4 * w + k], turns[5 * w + k] = v11 - w3_p * (near_m4 * -Z2_3_p), v12 + v17
        turns[6 * w + k], turns[7 * w + k], turns[8 * w + k] = v12 - v17, Y4, Y4
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = -Y4, -Y4, math.sqrt(v46)
        turns[12 * w + k], turns[13 * w + k] = math.sqrt(v47), math.sqrt(v48)
        turns[14 * w + k], turns[15 * w + k], turns[16 * w + k] = math.sqrt(v49), v56, v57
        turns[17 * w + k] = -(c4_mp * v54 + Y4 * (s23_mp * T31 - c23_mp * v55))
        turns[18 * w + k] = -(c4_mm * v54 + Y4 * (s23_mm * T31 - c23_mm * v55))
        turns[24 * w + k], turns[25 * w + k] = T14, N3_p - near_k3
        turns[26 * w + k], turns[27 * w + k] = N3_m - near_k3, v13 + v16
        turns[28 * w + k], turns[29 * w + k], turns[30 * w + k] = v13 - v16, v18 - v14, -(v14 + v18)
        turns[31 * w + k], turns[32 * w + k], turns[33 * w + k] = c4_pp, c4_pm, c4_mp
        turns[34 * w + k], turns[35 * w + k] = c4_mm, c23_pp * T33 - s23_pp * v43
        turns[36 * w + k] = c23_pm * T33 - s23_pm * v43
        turns[37 * w + k] = c23_mp * T33 + s23_mp * v43
        turns[38 * w + k] = c23_mm * T33 + s23_mm * v43
        turns[39 * w + k] = c4_pp * v52 + Y4 * (s23_pp * T32 + c23_pp * v53)
        turns[40 * w + k] = c4_pm * v52 + Y4 * (s23_pm * T32 + c23_pm * v53)
        turns[41 * w + k] = -(c4_mp * v52 + Y4 * (s23_mp * T32 - c23_mp * v53))
        turns[42 * w + k] = -(c4_mm * v52 + Y4 * (s23_mm * T32 - c23_mm * v53))
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 19 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(19 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        T24, T31, w3_p, w3_m = kept[7 * w + k], kept[8 * w + k], kept[17 * w + k], kept[18 * w + k]
        c23_mp, c23_mm, s23_mp = kept[19 * w + k], kept[20 * w + k], kept[21 * w + k]
        s23_mm, c4_mp, c4_mm = kept[22 * w + k], kept[23 * w + k], kept[24 * w + k]
        Y4, v50, v51, v54 = kept[25 * w + k], kept[26 * w + k], kept[27 * w + k], kept[28 * w + k]
        v55, v56, v57 = kept[29 * w + k], kept[30 * w + k], kept[31 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5, angle6 = turns[3 * w + k], turns[4 * w + k], turns[5 * w + k]
        angle7, angle8, angle9 = turns[6 * w + k], turns[7 * w + k], turns[8 * w + k]
        angle10, angle11, angle12 = turns[9 * w + k], turns[10 * w + k], turns[11 * w + k]
        angle13, angle14, angle15 = turns[12 * w + k], turns[13 * w + k], turns[14 * w + k]
        angle16, angle17, angle18 = turns[15 * w + k], turns[16 * w + k], turns[17 * w + k]
        angle19 = turns[18 * w + k]

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        q3__pp = angle2 - near_turn1
        v9 = near_turn1 + angle2
        q3__mp = angle3 - near_turn1
        v10 = near_turn1 + angle3

        # theta4, type 2: U4[3, 3]
        q4_ppm = angle8 - v50
        q4_pmm = angle9 - v50
        q4_mpm = angle10 - v51
        q4_mmm = angle11 - v51

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle16 - math.copysign(half_turn, v56)
        q6_pmm = angle17 - math.copysign(half_turn, v57)
        q6_mpm = (
            angle18 - math.copysign(half_turn, -(c4_mp * v54 + Y4 * (s23_mp * T31 - c23_mp * v55)))
        )
        q6_mmm = (
            angle19 - math.copysign(half_turn, -(c4_mm * v54 + Y4 * (s23_mm * T31 - c23_mm * v55)))
        )

        # joint values
        q3_ppp = q3__pp + (-turn if half_turn < q3__pp else 0.0)
        q3_pmp = (-turn if half_turn < -v9 else 0.0) - v9
        q3_mpp = q3__mp + (-turn if half_turn < q3__mp else 0.0)
        q3_mmp = (-turn if half_turn < -v10 else 0.0) - v10
        q1_ppp = angle1 + (w3_p - w3_p)
        q1_mpp = angle1 - math.copysign(half_turn, T24) + (w3_m - w3_m)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, angle4, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle8, angle12, angle16
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, -angle12, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = angle5, q3_pmp, angle9
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = angle13, angle17, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = -angle13, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = angle6, q3_mpp, angle10
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = angle14, angle18, q4_mpm
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = -angle14, q6_mpm, angle7
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q3_mmp, angle11, angle15
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = angle19, q4_mmm, -angle15
        rows[33 * w + k] = q6_mmm
        rows[34 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[35 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[36 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[37 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[38 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[39 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[40 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[41 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK


# Where in rows the joint values of each row are.
_PLACES = np.array([
    [0, 1, 2, 3, 4, 5],
    [0, 1, 2, 6, 7, 8],
    [0, 9, 10, 11, 12, 13],
    [0, 9, 10, 14, 15, 16],
    [17, 18, 19, 20, 21, 22],
    [17, 18, 19, 23, 24, 25],
    [17, 26, 27, 28, 29, 30],
    [17, 26, 27, 31, 32, 33],
])

# What makes of a pose this arm's, before and behind it, and what its angles are more; where in rows
# these are.
_LEFT, _RIGHT = np.array((-0.9999999999999449, -3.321999999999817e-07, 0.0, -0.0, 3.321999999999817e-07, -0.9999999999999449, 0.0, -0.0, 0.0, 0.0, 1.0, -0.400051)), np.array((1.0, -0.0, 0.0, -5.2e-05, 0.0, 0.9999999979520001, -6.3999999996928e-05, 5.759779999723332e-06, 0.0, 6.3999999996928e-05, 0.9999999979520001, -0.08999499981568386))
_OFFSETS = np.array((0.0, 3.141592651689793, -3.141592651689793, 3.1415926548897932, 0.0, 0.0))
_ANGLES = np.ascontiguousarray(_PLACES[:, (0, 1, 2, 3, 4, 5)])


@_HOW.merged
def _nearby(pose, q_free):
    """Joint values that lead to all solutions; none where one of these rows may end."""
    kept, turns, rows = np.zeros(32), np.zeros(48), np.zeros(42)
    _nearest.near_pose(pose, _LEFT, _RIGHT, kept)
    _formulas(kept, turns, rows, len(kept) // 32)
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
