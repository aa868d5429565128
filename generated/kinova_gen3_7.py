"""kinova_gen3_7: Kinova Gen3 with 7 joints.

Inverse kinematics, generated from robots/kinova_gen3_7.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kinova_gen3_7.yaml. The formulas and where they come from:
kinova_gen3_7.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 7), _runtime("arrays").zeros

NAME = "kinova_gen3_7"
METHOD = "general 6R"
DOF = 7
JOINT_TYPES = "RRRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6", "joint7")
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-2.24, 2.24),
    (-math.inf, math.inf),
    (-2.57, 2.57),
    (-math.inf, math.inf),
    (-2.09, 2.09),
    (-math.inf, math.inf),
)
BRANCHES = (
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
)
MAX_SOLUTIONS = 16
FREE_JOINTS = (3,)  # from 1: the caller gives their values

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose, or a free joint's value is not finite

# In formulas below, near_arm_size2 = 0.5770225443999999 [m^2],
# near_doubt_limit = 9.999999999999999e-05.
d1 = 0.28481  # joint offset 1 [m]
d2 = 0.01175  # joint offset 2 [m]
d3 = 0.42076  # joint offset 3 [m]
d4 = 0.01275  # joint offset 4 [m]
d5 = 0.31436  # joint offset 5 [m]
d6 = 0.00035  # joint offset 6 [m]
d7 = 0.10593  # joint offset 7 [m]
offset2 = 3.141592653589793  # offset of joint 2 [rad]
offset3 = 3.141592653589793  # offset of joint 3 [rad]
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
offset6 = 3.141592653589793  # offset of joint 6 [rad]
offset7 = 3.141592653589793  # offset of joint 7 [rad]
near_angle = 1e-10  # the two arms' tools are turned by no more
near_length = 0.0003500001  # and no farther apart [m]
near_offset3 = 3.141592653589793  # offset of joint 3 [rad]
near_d2 = -0.01175  # joint offset 2 [m]
near_d5 = -0.31436  # joint offset 5 [m]
near_d3 = -0.42076  # joint offset 3 [m]
near_doubt_limit_squared4 = 3.329550167458499e-09  # square of a length that fixes no angle [m^4]
near_d4 = -0.01275  # joint offset 4 [m]
near_merge_slack2 = 5.770225443999999e-15  # nearer to that boundary two branches are one [m^2]
near_doubt_limit_squared2 = 5.770225443999999e-09  # square of a length that fixes no angle [m^2]
# the same where they follow an angle that is good to few digits [m]
near_blur_slack1 = 7.596199999999999e-12
near_k1 = 0.2645402272  # 2 * near_d5 * near_d3 [m^2]
near_k2 = 0.06998153180702761  # near_k1^2 [m^4]
near_k3 = 0.000299625  # 2 * near_d4 * near_d2 [m^2]
near_k4 = 0.2761618122  # near_d2^2 + (near_d3^2 + (near_d4^2 + near_d5^2)) [m^2]
near_k5 = 1.7330345403398768  # 1 / near_arm_size2 [m^-2]
near_m1 = 5.7702254439999985e-12  # 1000 * near_merge_slack2 [m^2]
near_m2 = 0.2645402272  # near_k1 [m^2]
near_m3 = 7.596199999999998e-11  # 10 * near_blur_slack1 [m]
near_m4 = 3.3295501674584984e-17  # near_doubt_limit_squared2^2 [m^4]
near_m5 = 9.999999999999999e-09  # near_doubt_limit^2
near1 = 2.4500014000001997e-07  # near_length^2 + near_length^2 [m^2]
near2 = 3.6750021000002996e-07  # near_length^2 + near1 [m^2]
near3 = 0.5  # 1 / 2
near4 = 9.721858904945563e-08  # near_k1 * near2 [m^4]
near5 = 5.0000000000000005e-21  # near_angle^2 / 2
turn = 2.0 * math.pi  # [rad]
half_turn = 0.5 * turn

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16,
    size=1.1507100000000001,
    coordinates=(0, 1, 2),
    directions='rotation',
    joints=(
        _joints.Joint(place=0),
        _joints.Joint(place=1, lowest=-2.24, highest=2.24, zero=3.141592653589793),
        _joints.Joint(place=3, lowest=-2.57, highest=2.57, zero=3.141592653589793),
        _joints.Joint(place=4, zero=3.141592653589793),
        _joints.Joint(place=5, lowest=-2.09, highest=2.09, zero=3.141592653589793),
        _joints.Joint(place=6, zero=3.141592653589793),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0),
    chain=(
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -0.28481)),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -0.01175),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -0.42076),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -0.01275),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -0.31436),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -0.00035),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, -0.10593),
            offset=3.141592653589793,
        ),
    ),
    free=(2,),
)
_ARM = _arms.arm_numbers(
    _arms.Arm(
        types=JOINT_TYPES,
        limits=JOINT_LIMITS,
        slacks=(1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09),
        weights=(1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0),
        paces=(1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.0),
        fan_steps=(),
        rows=16,
        directions='rotation',
        miss_weights=(0.869, 0.869, 0.869, 1.0, 1.0, 1.0),
        size=1.1507100000000001,
        clamped=1e-14,
        clamped_again=1e-10,
        steps=('clamps',),
        given=(2,),
    ),
)


# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, -0.28481, 0.0, 1.5707963267948966),
    (3.141592653589793, -0.01175, 0.0, 1.5707963267948966),
    (3.141592653589793, -0.42076, 0.0, 1.5707963267948966),
    (3.141592653589793, -0.01275, 0.0, 1.5707963267948966),
    (3.141592653589793, -0.31436, 0.0, 1.5707963267948966),
    (3.141592653589793, -0.00035, 0.0, 1.5707963267948966),
    (3.141592653589793, -0.10593, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES,
    table=TABLE,
    convention="standard",
    base=(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0),
)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (7,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 7 joint values")
    T = _zeros(4, 4)
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    v1 = q[1] + offset2
    c2 = math.cos(v1)
    s2 = math.sin(v1)
    x2_x = c1 * c2
    v2 = s1 * c2
    z2_x = c1 * s2
    v3 = s1 * s2
    v4 = q[2] + offset3
    c3 = math.cos(v4)
    s3 = math.sin(v4)
    x3_x = x2_x * c3 + s1 * s3
    x3_y = c1 * s3 - v2 * c3
    v5 = s2 * c3
    v6 = c1 * c3 + v2 * s3
    v7 = s2 * s3
    z3_x = x2_x * s3 - s1 * c3
    v8 = q[3] + offset4
    c4 = math.cos(v8)
    s4 = math.sin(v8)
    x4_x = x3_x * c4 + z2_x * s4
    x4_y = x3_y * c4 - v3 * s4
    x4_z = c2 * s4 - v5 * c4
    z4_y = v3 * c4 + x3_y * s4
    v9 = c2 * c4 + v5 * s4
    z4_x = x3_x * s4 - z2_x * c4
    v10 = q[4] + offset5
    c5 = math.cos(v10)
    s5 = math.sin(v10)
    x5_x = x4_x * c5 + z3_x * s5
    x5_y = x4_y * c5 - v6 * s5
    x5_z = x4_z * c5 - v7 * s5
    z5_y = v6 * c5 + x4_y * s5
    z5_z = v7 * c5 + x4_z * s5
    z5_x = x4_x * s5 - z3_x * c5
    v11 = q[5] + offset6
    c6 = math.cos(v11)
    s6 = math.sin(v11)
    x6_x = x5_x * c6 + z4_x * s6
    x6_y = x5_y * c6 + z4_y * s6
    x6_z = x5_z * c6 - v9 * s6
    z6_z = v9 * c6 + x5_z * s6
    z6_x = x5_x * s6 - z4_x * c6
    z6_y = x5_y * s6 - z4_y * c6
    v12 = q[6] + offset7
    c7 = math.cos(v12)
    s7 = math.sin(v12)
    T[0, 0] = x6_x * c7 + z5_x * s7
    T[0, 1] = z5_x * c7 - x6_x * s7
    T[0, 2] = z6_x
    T[0, 3] = -(s1 * d2 + z2_x * d3 + z3_x * d4 + z4_x * d5 + z5_x * d6 + z6_x * d7)
    T[1, 0] = x6_y * c7 + z5_y * s7
    T[1, 1] = z5_y * c7 - x6_y * s7
    T[1, 2] = z6_y
    T[1, 3] = v3 * d3 - c1 * d2 + v6 * d4 - z4_y * d5 - z5_y * d6 - z6_y * d7
    T[2, 0] = x6_z * c7 + z5_z * s7
    T[2, 1] = z5_z * c7 - x6_z * s7
    T[2, 2] = z6_z
    T[2, 3] = d1 - c2 * d3 + v7 * d4 + v9 * d5 - z5_z * d6 - z6_z * d7
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 7): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 7 joint values")
    J = _zeros(6, 7)
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    v1 = q[1] + offset2
    c2 = math.cos(v1)
    s2 = math.sin(v1)
    x2_x = c1 * c2
    v2 = s1 * c2
    z2_x = c1 * s2
    v3 = s1 * s2
    v4 = s1 * d2
    v5 = c1 * d2
    v6 = q[2] + offset3
    c3 = math.cos(v6)
    s3 = math.sin(v6)
    x3_x = x2_x * c3 + s1 * s3
    x3_y = c1 * s3 - v2 * c3
    v7 = s2 * c3
    v8 = c1 * c3 + v2 * s3
    v9 = s2 * s3
    v10 = v4 + z2_x * d3
    p3_y = v3 * d3 - v5
    p3_z = d1 - c2 * d3
    z3_x = x2_x * s3 - s1 * c3
    v11 = q[3] + offset4
    c4 = math.cos(v11)
    s4 = math.sin(v11)
    x4_x = x3_x * c4 + z2_x * s4
    x4_y = x3_y * c4 - v3 * s4
    x4_z = c2 * s4 - v7 * c4
    z4_y = v3 * c4 + x3_y * s4
    v12 = c2 * c4 + v7 * s4
    v13 = v10 + z3_x * d4
    p4_y = p3_y + v8 * d4
    p4_z = p3_z + v9 * d4
    z4_x = x3_x * s4 - z2_x * c4
    v14 = q[4] + offset5
    c5 = math.cos(v14)
    s5 = math.sin(v14)
    z5_y = v8 * c5 + x4_y * s5
    z5_z = v9 * c5 + x4_z * s5
    v15 = v13 + z4_x * d5
    p5_y = p4_y - z4_y * d5
    p5_z = p4_z + v12 * d5
    z5_x = x4_x * s5 - z3_x * c5
    v16 = q[5] + offset6
    c6 = math.cos(v16)
    s6 = math.sin(v16)
    z6_z = v12 * c6 + (x4_z * c5 - v9 * s5) * s6
    v17 = v15 + z5_x * d6
    p6_y = p5_y - z5_y * d6
    p6_z = p5_z - z5_z * d6
    z6_x = (x4_x * c5 + z3_x * s5) * s6 - z4_x * c6
    z6_y = (x4_y * c5 - v8 * s5) * s6 - z4_y * c6
    J21 = v17 + z6_x * d7
    p7_y = p6_y - z6_y * d7
    p7_z = p6_z - z6_z * d7
    v18 = p7_z - d1
    v19 = v4 - J21
    v20 = v5 + p7_y
    v21 = v10 - J21
    v22 = p7_y - p3_y
    v23 = p7_z - p3_z
    v24 = v13 - J21
    v25 = p7_y - p4_y
    v26 = p7_z - p4_z
    v27 = v15 - J21
    v28 = p7_y - p5_y
    v29 = p7_z - p5_z
    v30 = v17 - J21
    v31 = p7_y - p6_y
    v32 = p7_z - p6_z
    J[0, 0] = p7_y
    J[0, 1] = c1 * v18
    J[0, 2] = -(v3 * v18 + c2 * v20)
    J[0, 3] = v9 * v22 - v8 * v23
    J[0, 4] = z4_y * v26 + v12 * v25
    J[0, 5] = z5_y * v29 - z5_z * v28
    J[0, 6] = z6_y * v32 - z6_z * v31
    J[1, 0] = J21
    J[1, 1] = -(s1 * v18)
    J[1, 2] = c2 * v19 - z2_x * v18
    J[1, 3] = -(v9 * v21 + z3_x * v23)
    J[1, 4] = -(v12 * v24 + z4_x * v26)
    J[1, 5] = z5_z * v27 - z5_x * v29
    J[1, 6] = z6_z * v30 - z6_x * v32
    J[2, 1] = s1 * p7_y + c1 * J21
    J[2, 2] = z2_x * v20 + v3 * v19
    J[2, 3] = z3_x * v22 + v8 * v21
    J[2, 4] = z4_x * v25 - z4_y * v24
    J[2, 5] = z5_x * v28 - z5_y * v27
    J[2, 6] = z6_x * v31 - z6_y * v30
    J[3, 1] = s1
    J[3, 2] = z2_x
    J[3, 3] = z3_x
    J[3, 4] = z4_x
    J[3, 5] = z5_x
    J[3, 6] = z6_x
    J[4, 1] = c1
    J[4, 2] = -v3
    J[4, 3] = -v8
    J[4, 4] = z4_y
    J[4, 5] = z5_y
    J[4, 6] = z6_y
    J[5, 0] = -1.0
    J[5, 2] = c2
    J[5, 3] = -v9
    J[5, 4] = -v12
    J[5, 5] = z5_z
    J[5, 6] = z6_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.3707388051002349,
    reach=4.062224539232323,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0, 0.01584673608061403,
            0.9230769230769231, 0.38461538461538464, 0.0, -1.9205566660481306e-10,
        )),
        _loops.Link(
            first=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -0.015846736084575715),
            inside=(
                _loops.Inside(
                    given=0,
                    slides=False,
                    factor=1.0,
                    after=(
                        0.47058823529411764, -0.8823529411764706, 0.0, 0.0, 0.0, 0.0, -1.0,
                        0.017195394470453523, 0.8823529411764706, 0.47058823529411764, 0.0,
                        -1.1349230083595947,
                    ),
                ),
            ),
        ),
        _loops.Link((
            0.28, -0.96, 0.0, 0.0, 0.0, 0.0, -1.0, 0.4239642514299426, 0.96, 0.28, 0.0,
            -0.01719539447475237,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.0, 0.0, -1.0,
            0.0004720304364438222, 0.7241379310344828, 0.6896551724137931, 0.0, -0.4239642515359337,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0,
            0.9459459459459459, 0.32432432432432434, 0.0, -0.0004720304365618298,
        )),
        _loops.Link((
            0.6, -0.8, 0.0, -0.0, -0.8, -0.6, 0.0, -0.0, 0.0, 0.0, -1.0, 0.2848099999287975,
        )),
        _loops.Link((1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, 0.10593)),
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
        _loops.Formulation(joints=(3, 4, 5, 0, 1, 2), sign=1.0),
        _loops.Formulation(joints=(0, 5, 4, 3, 2, 1), sign=-1.0),
        _loops.Formulation(joints=(4, 3, 2, 1, 0, 5), sign=-1.0),
        _loops.Formulation(joints=(1, 2, 3, 4, 5, 0), sign=1.0),
    ),
    given=((1.0, 3.141592653589793),),
    special=(
        _loops.Special(given=0, cosine=1.0, sine=0.0, within=1e-12, formulations=(0, 1)),
        _loops.Special(given=0, cosine=-1.0, sine=0.0, within=1e-12, formulations=(0, 1)),
    ),
)
_NUMBERS = _loops.general_numbers(_LINKS, _LOOP)
_all_joints = _runtime("general.rows").all_joints
_nearest, _COMPILED = _runtime("general.near"), _runtime("jit").COMPILED
_NONE_NEAR = np.zeros((0, 6))


# The nearest arm with a structure: what follows is its closed form.
@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T13, T14, T23, T24 = kept[2 * w + k], kept[3 * w + k], kept[6 * w + k], kept[7 * w + k]
        T33, T34, given1 = kept[10 * w + k], kept[11 * w + k], kept[16 * w + k]
        v1 = near_offset3 + given1

        # theta4, type 2: the squared length of column 4 of U0
        v2 = T14 * T14
        v3 = T24 * T24

        # theta1, type 2: U1[3, 4]
        N1 = v2 + v3
        inverse1 = 1.0 / N1
        v26 = T14 * inverse1
        v31 = T24 * inverse1

        # theta5, type 2: U5[3, 3]
        v85 = T24 * T13 - T14 * T23

        # joint values
        v178 = near_length * T14
        v179 = abs(T14)
        v180 = v178 + v178
        v181 = near_length * T24
        v182 = abs(T24)
        v183 = v181 + v181
        v184 = near_length * T34
        v185 = abs(T34)
        v186 = v184 + v184
        v191 = v180 * v180 + v183 * v183
        v192 = near2 + math.sqrt(v191 + v186 * v186)
        v507 = abs(inverse1)
        v508 = inverse1 * (inverse1 * v180)
        v509 = inverse1 * (inverse1 * v183)
        v510 = v507 * (near1 * v507)
        v511 = math.sqrt(N1) - math.sqrt(near1)
        v512 = v510 + (v510 + (abs(v508) + abs(v509))) * ((near1 + math.sqrt(v191)) / (v511 * v511))
        v530 = v512 + math.sqrt(v508 * v508 + v509 * v509)
        v539 = near_length * inverse1
        v540 = T14 * v509
        v541 = v539 - T14 * v508
        v542 = near_length * v530
        v543 = v542 + v179 * v512
        v544 = abs(v26)
        v545 = v540 * v540
        v546 = v543 + math.sqrt(v541 * v541 + v545)
        v547 = v543 + math.sqrt(v545 + -v541 * -v541)
        v572 = near_angle * T33
        v573 = near_angle * T23
        v586 = abs(T13)
        v587 = v572 * v572
        v588 = v573 * v573
        v589 = near5 + math.sqrt(v587 + v588)
        v607 = T24 * v508
        v608 = v539 - T24 * v509
        v609 = v542 + v182 * v512
        v610 = abs(v31)
        v611 = v607 * v607
        v612 = v609 + math.sqrt(v611 + v608 * v608)
        v613 = v609 + math.sqrt(v611 + -v608 * -v608)
        v659 = near_angle * T13
        v668 = abs(T23)
        v669 = v659 * v659
        v670 = near5 + math.sqrt(v587 + v669)
        v694 = near5 + math.sqrt(v588 + v669)
        kept[18 * w + k], kept[19 * w + k], kept[20 * w + k] = v2, v3, N1
        kept[21 * w + k], kept[22 * w + k], kept[23 * w + k] = inverse1, v26, v31
        kept[24 * w + k], kept[25 * w + k], kept[26 * w + k] = v85, v179, v180
        kept[27 * w + k], kept[28 * w + k], kept[29 * w + k] = v182, v183, v185
        kept[30 * w + k], kept[31 * w + k], kept[32 * w + k] = v186, v192, v507
        kept[33 * w + k], kept[34 * w + k], kept[35 * w + k] = v508, v509, v512
        kept[36 * w + k], kept[37 * w + k], kept[38 * w + k] = v530, v540, v541
        kept[39 * w + k], kept[40 * w + k], kept[41 * w + k] = v543, v544, v546
        kept[42 * w + k], kept[43 * w + k], kept[44 * w + k] = v547, v572, v573
        kept[45 * w + k], kept[46 * w + k], kept[47 * w + k] = v586, v589, v607
        kept[48 * w + k], kept[49 * w + k], kept[50 * w + k] = v608, v609, v610
        kept[51 * w + k], kept[52 * w + k], kept[53 * w + k] = v612, v613, v659
        kept[54 * w + k], kept[55 * w + k], kept[56 * w + k] = v668, v670, v694
        turns[0 * w + k], turns[1 * w + k] = v1, v1
    for k in range(0 * w, 1 * w):
        turns[k] = math.sin(turns[k])
    for k in range(1 * w, 2 * w):
        turns[k] = math.cos(turns[k])
    for k in range(w):
        T11, T12, T13, T14 = kept[0 * w + k], kept[1 * w + k], kept[2 * w + k], kept[3 * w + k]
        T21, T22, T23, T24 = kept[4 * w + k], kept[5 * w + k], kept[6 * w + k], kept[7 * w + k]
        T31, T32, T33, T34 = kept[8 * w + k], kept[9 * w + k], kept[10 * w + k], kept[11 * w + k]
        given1, v2, v3, N1 = kept[16 * w + k], kept[18 * w + k], kept[19 * w + k], kept[20 * w + k]
        inverse1, v26, v31 = kept[21 * w + k], kept[22 * w + k], kept[23 * w + k]
        v85, v179, v180 = kept[24 * w + k], kept[25 * w + k], kept[26 * w + k]
        v182, v183, v185 = kept[27 * w + k], kept[28 * w + k], kept[29 * w + k]
        v186, v192, v507 = kept[30 * w + k], kept[31 * w + k], kept[32 * w + k]
        v508, v509, v512 = kept[33 * w + k], kept[34 * w + k], kept[35 * w + k]
        v530, v540, v541 = kept[36 * w + k], kept[37 * w + k], kept[38 * w + k]
        v543, v544, v546 = kept[39 * w + k], kept[40 * w + k], kept[41 * w + k]
        v547, v572, v573 = kept[42 * w + k], kept[43 * w + k], kept[44 * w + k]
        v586, v589, v607 = kept[45 * w + k], kept[46 * w + k], kept[47 * w + k]
        v608, v609, v610 = kept[48 * w + k], kept[49 * w + k], kept[50 * w + k]
        v612, v613, v659 = kept[51 * w + k], kept[52 * w + k], kept[53 * w + k]
        v668, v670, v694 = kept[54 * w + k], kept[55 * w + k], kept[56 * w + k]
        s3, c3 = turns[0 * w + k], turns[1 * w + k]

        # theta4, type 2: the squared length of column 4 of U0
        X4 = near_d5 * (near_d2 * s3) * 2.0
        N4 = near_k2 + X4 * X4
        Z4 = near_k3 * c3 + (v2 + (v3 + (T34 * T34 - near_k4)))
        D4 = N4 - Z4 * Z4
        w4 = math.sqrt(D4)
        inverse4 = 1.0 / N4
        v4 = X4 * Z4
        v5 = inverse4 * v4
        v6 = near_m2 * inverse4
        v7 = w4 * v6
        s4_p = v5 - v7
        s4_m = v5 + v7
        v8 = inverse4 * (near_k1 * Z4)
        v9 = X4 * inverse4
        v10 = w4 * v9
        v11 = v8 + v10
        v12 = v8 - v10

        # theta1, type 2: U1[3, 4]
        v13 = near_d5 * s3
        v14 = near_d4 * c3 - near_d2
        Z1_p = v14 - s4_p * v13
        Z1_m = v14 - s4_m * v13
        D1_p = N1 - Z1_p * Z1_p
        D1_m = N1 - Z1_m * Z1_m
        v15 = near_k5 * w4
        w1_p = math.sqrt(D1_p)
        w1_m = math.sqrt(D1_m)
        v16 = w1_p - w1_p
        v17 = w1_m - w1_m
        v18 = abs(Z1_p)
        v19 = abs(Z1_m)
        v20 = near_blur_slack1 + 2.0 * v18
        v21 = near_blur_slack1 + 2.0 * v19
        v22 = T14 * Z1_p
        v23 = T14 * Z1_m
        v24 = T24 * Z1_p
        v25 = T24 * Z1_m
        v27 = inverse1 * v24
        v28 = inverse1 * v25
        v29 = w1_p * v26
        c1_pp = v27 + v29
        c1_pm = v27 - v29
        v30 = w1_m * v26
        c1_mp = v28 + v30
        c1_mm = v28 - v30
        v32 = inverse1 * v22
        v33 = inverse1 * v23
        v34 = w1_p * v31
        s1_pp = v34 - v32
        v35 = v32 + v34
        v36 = w1_m * v31
        s1_mp = v36 - v33
        v37 = v33 + v36

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        v38 = near_d5 * c3
        v39 = near_d4 * s3
        v40 = near_d3 + near_d5 * v11
        v41 = near_d3 + near_d5 * v12
        v42 = v39 + inverse4 * (v4 * v38)
        v43 = T34 * v42
        v44 = near_m2 * (inverse4 * (T34 * v38))
        v45 = w4 * v44
        v46 = v43 - v45
        v47 = v43 + v45
        v48 = w1_p * v40
        v49 = w1_m * v41
        S2_pp = v46 + v48
        S2_pm = v46 - v48
        S2_mp = v47 + v49
        S2_mm = v47 - v49
        v50 = T34 * v40
        v51 = T34 * v41
        v52 = v39 + s4_p * v38
        v53 = v39 + s4_m * v38
        v54 = w1_p * v52
        v55 = w1_m * v53
        C2_pp = v54 - v50
        v56 = v50 + v54
        C2_mp = v55 - v51
        v57 = v51 + v55
        v58 = S2_pp * S2_pp + C2_pp * C2_pp
        v59 = S2_pm * S2_pm + v56 * v56
        v60 = S2_mp * S2_mp + C2_mp * C2_mp
        v61 = S2_mm * S2_mm + v57 * v57
        v62 = math.sqrt(v58)
        v63 = math.sqrt(v59)
        v64 = math.sqrt(v60)
        v65 = math.sqrt(v61)
        v66 = 1.0 / v58
        v67 = 1.0 / v59
        v68 = 1.0 / v60
        v69 = 1.0 / v61
        factor2_pp = v62 * v66
        factor2_pm = v63 * v67
        factor2_mp = v64 * v68
        factor2_mm = v65 * v69

        # theta5, type 2: U5[3, 3]
        v70 = c3 * T13
        v71 = v11 * v70
        v72 = v12 * v70
        v73 = c3 * T23
        v74 = v11 * v73
        v75 = v12 * v73
        v76 = s4_p * T33
        v77 = s4_m * T33
        v78 = s4_p * T13
        v79 = s4_m * T13
        v80 = s4_p * T23
        v81 = s4_m * T23
        v82 = c3 * T33
        v83 = v11 * v82
        v84 = v12 * v82
        v86 = s3 * v85
        v87 = s3 * -v85
        v88 = inverse1 * v86
        v89 = inverse1 * v87
        v90 = s3 * (v22 * T13 + v24 * T23)
        v91 = s3 * (v23 * T13 + v25 * T23)
        v92 = inverse1 * v90
        v93 = inverse1 * v91
        v94 = w1_p * v88 - v92
        v95 = w1_p * v89 - v92
        v96 = w1_m * v88 - v93
        v97 = w1_m * v89 - v93
        v98 = c1_pp * v78 + s1_pp * v80 - v83
        v99 = c1_pm * v78 - v35 * v80 - v83
        v100 = c1_mp * v79 + s1_mp * v81 - v84
        v101 = c1_mm * v79 - v37 * v81 - v84
        v102 = v76 + (c1_pp * v71 + s1_pp * v74)
        v103 = v76 + (c1_pm * v71 - v35 * v74)
        v104 = v77 + (c1_mp * v72 + s1_mp * v75)
        v105 = v77 + (c1_mm * v72 - v37 * v75)
        v106 = S2_pp * v98 - C2_pp * v102
        v107 = S2_pm * v99 + v56 * v103
        v108 = S2_mp * v100 - C2_mp * v104
        v109 = S2_mm * v101 + v57 * v105
        c5_pp = factor2_pp * v106 - v11 * v94
        c5_pm = factor2_pm * v107 - v11 * v95
        c5_mp = factor2_mp * v108 - v12 * v96
        c5_mm = factor2_mm * v109 - v12 * v97
        v110 = s3 * T33
        v111 = s3 * (c1_pp * T13 + s1_pp * T23)
        v112 = s3 * (c1_pm * T13 - v35 * T23)
        v113 = s3 * (c1_mp * T13 + s1_mp * T23)
        v114 = s3 * (c1_mm * T13 - v37 * T23)
        v115 = C2_pp * v111 + S2_pp * v110
        v116 = S2_pm * v110 - v56 * v112
        v117 = C2_mp * v113 + S2_mp * v110
        v118 = S2_mm * v110 - v57 * v114
        Y5_pp = factor2_pp * v115 - c3 * (s1_pp * T13 - c1_pp * T23)
        Y5_pm = factor2_pm * v116 + c3 * (v35 * T13 + c1_pm * T23)
        Y5_mp = factor2_mp * v117 - c3 * (s1_mp * T13 - c1_mp * T23)
        Y5_mm = factor2_mm * v118 + c3 * (v37 * T13 + c1_mm * T23)
        v119 = c5_pp * c5_pp + Y5_pp * Y5_pp
        v120 = c5_pm * c5_pm + Y5_pm * Y5_pm
        v121 = c5_mp * c5_mp + Y5_mp * Y5_mp
        v122 = c5_mm * c5_mm + Y5_mm * Y5_mm

        # theta6, type 3: U5[2, 3] and U5[1, 3]
        v123 = s4_p * v70
        v124 = s4_m * v70
        v125 = s4_p * v73
        v126 = s4_m * v73
        v127 = v11 * T33
        v128 = v12 * T33
        v129 = v11 * T13
        v130 = v12 * T13
        v131 = v11 * T23
        v132 = v12 * T23
        v133 = s4_p * v82
        v134 = s4_m * v82

        # theta7, type 3: U5[3, 2] and U5[3, 1]
        v135 = s3 * T32
        v136 = s1_pp * T12 - c1_pp * T22
        v137 = v35 * T12 + c1_pm * T22
        v138 = s1_mp * T12 - c1_mp * T22
        v139 = v37 * T12 + c1_mm * T22
        v140 = c3 * T12
        v141 = v11 * v140
        v142 = v12 * v140
        v143 = c3 * T22
        v144 = v11 * v143
        v145 = v12 * v143
        v146 = s4_p * T32
        v147 = s4_m * T32
        v148 = s4_p * T12
        v149 = s4_m * T12
        v150 = s4_p * T22
        v151 = s4_m * T22
        v152 = c3 * T32
        v153 = v11 * v152
        v154 = v12 * v152
        v155 = s3 * T31
        v156 = s1_pp * T11 - c1_pp * T21
        v157 = v35 * T11 + c1_pm * T21
        v158 = s1_mp * T11 - c1_mp * T21
        v159 = v37 * T11 + c1_mm * T21
        v160 = c3 * T11
        v161 = v11 * v160
        v162 = v12 * v160
        v163 = c3 * T21
        v164 = v11 * v163
        v165 = v12 * v163
        v166 = s4_p * T31
        v167 = s4_m * T31
        v168 = s4_p * T11
        v169 = s4_m * T11
        v170 = s4_p * T21
        v171 = s4_m * T21
        v172 = c3 * T31
        v173 = v11 * v172
        v174 = v12 * v172
        s7_pp = (
            c5_pp * (c3 * v156 - factor2_pp * (C2_pp * (s3 * (c1_pp * T11 + s1_pp * T21)) + S2_pp *
            v155)) + Y5_pp * (factor2_pp * (S2_pp * (c1_pp * v168 + s1_pp * v170 - v173) - C2_pp *
            (v166 + (c1_pp * v161 + s1_pp * v164))) - v11 * (s3 * v156))
        )
        s7_pm = (
            Y5_pm * (factor2_pm * (S2_pm * (c1_pm * v168 - v35 * v170 - v173) + v56 * (v166 + (c1_pm
            * v161 - v35 * v164))) + v11 * (s3 * v157)) - c5_pm * (c3 * v157 + factor2_pm * (S2_pm *
            v155 - v56 * (s3 * (c1_pm * T11 - v35 * T21))))
        )
        s7_mp = (
            c5_mp * (c3 * v158 - factor2_mp * (C2_mp * (s3 * (c1_mp * T11 + s1_mp * T21)) + S2_mp *
            v155)) + Y5_mp * (factor2_mp * (S2_mp * (c1_mp * v169 + s1_mp * v171 - v174) - C2_mp *
            (v167 + (c1_mp * v162 + s1_mp * v165))) - v12 * (s3 * v158))
        )
        s7_mm = (
            Y5_mm * (factor2_mm * (S2_mm * (c1_mm * v169 - v37 * v171 - v174) + v57 * (v167 + (c1_mm
            * v162 - v37 * v165))) + v12 * (s3 * v159)) - c5_mm * (c3 * v159 + factor2_mm * (S2_mm *
            v155 - v57 * (s3 * (c1_mm * T11 - v37 * T21))))
        )

        # joint values
        v175 = given1 + (w4 - w4)
        q3_ppp = v16 + v175
        q3_mpp = v17 + v175
        v176 = abs(Z4)
        v177 = near_merge_slack2 + 2.0 * v176
        v187 = Z4 * v180
        v188 = Z4 * v183
        v189 = Z4 * v186
        v190 = near2 * v176
        v193 = v187 + v187
        v194 = v188 + v188
        v195 = v189 + v189
        v196 = v190 + v190 + v192 * v192
        v197 = v196 + math.sqrt(v193 * v193 + v194 * v194 + v195 * v195)
        v198 = X4 * v180
        v199 = X4 * v183
        v200 = X4 * v186
        v201 = near2 * abs(X4)
        v202 = inverse4 * v198
        v203 = inverse4 * v199
        v204 = inverse4 * v200
        v205 = abs(inverse4)
        v206 = near3 / w4
        v207 = v193 * v206
        v208 = v194 * v206
        v209 = v195 * v206
        v210 = v197 * v206
        v211 = v210 * v210 / w4
        v212 = v211 + (v211 + v196 * abs(v206))
        v213 = v6 * v207
        v214 = v202 + v213
        v215 = v202 - v213
        v216 = v6 * v208
        v217 = v203 + v216
        v218 = v203 - v216
        v219 = v6 * v209
        v220 = v204 + v219
        v221 = v204 - v219
        v222 = v201 * v205 + v212 * abs(v6)
        v223 = v13 * v214
        v224 = v13 * v215
        v225 = v13 * v217
        v226 = v13 * v218
        v227 = v13 * v220
        v228 = v13 * v221
        v229 = v222 * abs(v13)
        v230 = v222 + math.sqrt(v214 * v214 + v217 * v217 + v220 * v220)
        v231 = v222 + math.sqrt(v215 * v215 + v218 * v218 + v221 * v221)
        v232 = Z1_p * v223
        v233 = Z1_m * v224
        v234 = Z1_p * v225
        v235 = Z1_m * v226
        v236 = Z1_p * v227
        v237 = Z1_m * v228
        v238 = v18 * v229
        v239 = v19 * v229
        v240 = v229 + math.sqrt(v223 * v223 + v225 * v225 + v227 * v227)
        v241 = v229 + math.sqrt(v224 * v224 + v226 * v226 + v228 * v228)
        v242 = v236 + v236
        v243 = v237 + v237
        v244 = v180 + (v232 + v232)
        v245 = v180 + (v233 + v233)
        v246 = v183 + (v234 + v234)
        v247 = v183 + (v235 + v235)
        v248 = near1 + (v238 + v238 + v240 * v240)
        v249 = near1 + (v239 + v239 + v241 * v241)
        v250 = v248 + math.sqrt(v244 * v244 + v246 * v246 + v242 * v242)
        v251 = v249 + math.sqrt(v245 * v245 + v247 * v247 + v243 * v243)
        v252 = abs(v38)
        v253 = inverse4 * (v38 * v198)
        v254 = inverse4 * (v38 * v199)
        v255 = inverse4 * (v38 * v200)
        v256 = v205 * (v201 * v252)
        v257 = T34 * v253
        v258 = T34 * v254
        v259 = T34 * v255 + near_length * v42
        v260 = near_m2 * (inverse4 * (near_length * v38))
        v261 = v44 * v207
        v262 = v257 + v261
        v263 = v257 - v261
        v264 = v44 * v208
        v265 = v258 + v264
        v266 = v258 - v264
        v267 = v44 * v209 - w4 * v260
        v268 = v259 + v267
        v269 = v259 + -v267
        v270 = near3 / w1_p
        v271 = near3 / w1_m
        v272 = v244 * v270
        v273 = v245 * v271
        v274 = v246 * v270
        v275 = v247 * v271
        v276 = v242 * v270
        v277 = v243 * v271
        v278 = v250 * v270
        v279 = v251 * v271
        v280 = v278 * v278 / w1_p
        v281 = v279 * v279 / w1_m
        v282 = v280 + (v280 + v248 * abs(v270))
        v283 = v281 + (v281 + v249 * abs(v271))
        v284 = inverse4 * (near_k1 * v180)
        v285 = inverse4 * (near_k1 * v183)
        v286 = inverse4 * (near_k1 * v186)
        v287 = v9 * v207
        v288 = v284 - v287
        v289 = v284 + v287
        v290 = v9 * v208
        v291 = v285 - v290
        v292 = v285 + v290
        v293 = v9 * v209
        v294 = v286 - v293
        v295 = v286 + v293
        v296 = near4 * v205 + v212 * abs(v9)
        v297 = near_d5 * v288
        v298 = near_d5 * v289
        v299 = near_d5 * v291
        v300 = near_d5 * v292
        v301 = near_d5 * v294
        v302 = near_d5 * v295
        v303 = near_d5 * v296
        v304 = v296 + math.sqrt(v288 * v288 + v291 * v291 + v294 * v294)
        v305 = v296 + math.sqrt(v289 * v289 + v292 * v292 + v295 * v295)
        v306 = abs(w1_p)
        v307 = abs(w1_m)
        v308 = v282 + math.sqrt(v272 * v272 + v274 * v274 + v276 * v276)
        v309 = v283 + math.sqrt(v273 * v273 + v275 * v275 + v277 * v277)
        v310 = math.sqrt(v297 * v297 + v299 * v299 + v301 * v301) - v303
        v311 = math.sqrt(v298 * v298 + v300 * v300 + v302 * v302) - v303
        v312 = w1_p * v297 + v40 * v272
        v313 = w1_m * v298 + v41 * v273
        v314 = w1_p * v299 + v40 * v274
        v315 = w1_m * v300 + v41 * v275
        v316 = w1_p * v301 + v40 * v276
        v317 = w1_m * v302 + v41 * v277
        v318 = v262 + v312
        v319 = v262 - v312
        v320 = v263 + v313
        v321 = v263 - v313
        v322 = v265 + v314
        v323 = v265 - v314
        v324 = v266 + v315
        v325 = v266 - v315
        v326 = v268 + v316
        v327 = v268 - v316
        v328 = v269 + v317
        v329 = v269 - v317
        v330 = (
            v185 * v256 + near_length * (v256 + math.sqrt(v253 * v253 + v254 * v254 + v255 * v255))
            + (v212 * abs(v44) + (v212 + math.sqrt(v207 * v207 + v208 * v208 + v209 * v209)) *
            abs(v260))
        )
        v331 = v330 + (v282 * abs(v40) - v303 * v306 + v308 * v310)
        v332 = v330 + (v283 * abs(v41) - v303 * v307 + v309 * v311)
        v333 = v331 + math.sqrt(v318 * v318 + v322 * v322 + v326 * v326)
        v334 = v331 + math.sqrt(v319 * v319 + v323 * v323 + v327 * v327)
        v335 = v332 + math.sqrt(v320 * v320 + v324 * v324 + v328 * v328)
        v336 = v332 + math.sqrt(v321 * v321 + v325 * v325 + v329 * v329)
        v337 = v38 * v214
        v338 = v38 * v215
        v339 = v38 * v217
        v340 = v38 * v218
        v341 = v38 * v220
        v342 = v38 * v221
        v343 = v222 * v252
        v344 = w1_p * v337 + v52 * v272
        v345 = w1_m * v338 + v53 * v273
        v346 = w1_p * v339 + v52 * v274
        v347 = w1_m * v340 + v53 * v275
        v348 = w1_p * v341 + v52 * v276
        v349 = w1_m * v342 + v53 * v277
        v350 = T34 * v297
        v351 = T34 * v298
        v352 = T34 * v299
        v353 = T34 * v300
        v354 = T34 * v301 + near_length * v40
        v355 = T34 * v302 + near_length * v41
        v356 = v344 - v350
        v357 = v344 + v350
        v358 = v345 - v351
        v359 = v345 + v351
        v360 = v346 - v352
        v361 = v346 + v352
        v362 = v347 - v353
        v363 = v347 + v353
        v364 = v348 - v354
        v365 = v348 + v354
        v366 = v349 - v355
        v367 = v349 + v355
        v368 = v185 * v303
        v369 = (
            v306 * v343 + v282 * abs(v52) + v308 * (v343 + math.sqrt(v337 * v337 + v339 * v339 +
            v341 * v341)) + (near_length * v310 - v368)
        )
        v370 = (
            v307 * v343 + v283 * abs(v53) + v309 * (v343 + math.sqrt(v338 * v338 + v340 * v340 +
            v342 * v342)) + (near_length * v311 - v368)
        )
        v371 = v369 + math.sqrt(v356 * v356 + v360 * v360 + v364 * v364)
        v372 = v369 + math.sqrt(v357 * v357 + v361 * v361 + v365 * v365)
        v373 = v370 + math.sqrt(v358 * v358 + v362 * v362 + v366 * v366)
        v374 = v370 + math.sqrt(v359 * v359 + v363 * v363 + v367 * v367)
        v375 = v333 * v333
        v376 = v334 * v334
        v377 = v335 * v335
        v378 = v336 * v336
        v379 = v371 * v371
        v380 = v372 * v372
        v381 = v373 * v373
        v382 = v374 * v374
        v383 = v375 + v379
        v384 = v376 + v380
        v385 = v377 + v381
        v386 = v378 + v382
        v387 = S2_pp * v318
        v388 = S2_pm * v319
        v389 = S2_mp * v320
        v390 = S2_mm * v321
        v391 = S2_pp * v322
        v392 = S2_pm * v323
        v393 = S2_mp * v324
        v394 = S2_mm * v325
        v395 = S2_pp * v326
        v396 = S2_pm * v327
        v397 = S2_mp * v328
        v398 = S2_mm * v329
        v399 = abs(S2_pp)
        v400 = abs(S2_pm)
        v401 = abs(S2_mp)
        v402 = abs(S2_mm)
        v403 = v331 * v399
        v404 = v331 * v400
        v405 = v332 * v401
        v406 = v332 * v402
        v407 = C2_pp * v356
        v408 = v56 * v357
        v409 = C2_mp * v358
        v410 = v57 * v359
        v411 = C2_pp * v360
        v412 = v56 * v361
        v413 = C2_mp * v362
        v414 = v57 * v363
        v415 = C2_pp * v364
        v416 = v56 * v365
        v417 = C2_mp * v366
        v418 = v57 * v367
        v419 = abs(C2_pp)
        v420 = abs(v56)
        v421 = abs(C2_mp)
        v422 = abs(v57)
        v423 = v369 * v419
        v424 = v369 * v420
        v425 = v370 * v421
        v426 = v370 * v422
        v427 = v387 + v387 + (v407 + v407)
        v428 = v388 + v388 + (v408 + v408)
        v429 = v389 + v389 + (v409 + v409)
        v430 = v390 + v390 + (v410 + v410)
        v431 = v391 + v391 + (v411 + v411)
        v432 = v392 + v392 + (v412 + v412)
        v433 = v393 + v393 + (v413 + v413)
        v434 = v394 + v394 + (v414 + v414)
        v435 = v395 + v395 + (v415 + v415)
        v436 = v396 + v396 + (v416 + v416)
        v437 = v397 + v397 + (v417 + v417)
        v438 = v398 + v398 + (v418 + v418)
        v439 = v375 + (v403 + v403) + (v379 + (v423 + v423))
        v440 = v376 + (v404 + v404) + (v380 + (v424 + v424))
        v441 = v377 + (v405 + v405) + (v381 + (v425 + v425))
        v442 = v378 + (v406 + v406) + (v382 + (v426 + v426))
        v443 = near3 / v62
        v444 = near3 / v63
        v445 = near3 / v64
        v446 = near3 / v65
        v447 = v427 * v443
        v448 = v428 * v444
        v449 = v429 * v445
        v450 = v430 * v446
        v451 = v431 * v443
        v452 = v432 * v444
        v453 = v433 * v445
        v454 = v434 * v446
        v455 = v435 * v443
        v456 = v436 * v444
        v457 = v437 * v445
        v458 = v438 * v446
        v459 = v439 * abs(v443)
        v460 = v440 * abs(v444)
        v461 = v441 * abs(v445)
        v462 = v442 * abs(v446)
        v463 = abs(v66)
        v464 = abs(v67)
        v465 = abs(v68)
        v466 = abs(v69)
        v467 = v66 * (v66 * v427)
        v468 = v67 * (v67 * v428)
        v469 = v68 * (v68 * v429)
        v470 = v69 * (v69 * v430)
        v471 = v66 * (v66 * v431)
        v472 = v67 * (v67 * v432)
        v473 = v68 * (v68 * v433)
        v474 = v69 * (v69 * v434)
        v475 = v66 * (v66 * v435)
        v476 = v67 * (v67 * v436)
        v477 = v68 * (v68 * v437)
        v478 = v69 * (v69 * v438)
        v479 = v463 * (v439 * v463)
        v480 = v464 * (v440 * v464)
        v481 = v465 * (v441 * v465)
        v482 = v466 * (v442 * v466)
        v483 = v62 - math.sqrt(v383)
        v484 = v63 - math.sqrt(v384)
        v485 = v64 - math.sqrt(v385)
        v486 = v65 - math.sqrt(v386)
        v487 = (
            v479 + (v479 + (abs(v475) + (abs(v467) + abs(v471)))) * ((v439 + math.sqrt(v427 * v427 +
            v431 * v431 + v435 * v435)) / (v483 * v483))
        )
        v488 = (
            v480 + (v480 + (abs(v476) + (abs(v468) + abs(v472)))) * ((v440 + math.sqrt(v428 * v428 +
            v432 * v432 + v436 * v436)) / (v484 * v484))
        )
        v489 = (
            v481 + (v481 + (abs(v477) + (abs(v469) + abs(v473)))) * ((v441 + math.sqrt(v429 * v429 +
            v433 * v433 + v437 * v437)) / (v485 * v485))
        )
        v490 = (
            v482 + (v482 + (abs(v478) + (abs(v470) + abs(v474)))) * ((v442 + math.sqrt(v430 * v430 +
            v434 * v434 + v438 * v438)) / (v486 * v486))
        )
        v491 = v66 * v447 - v62 * v467
        v492 = v67 * v448 - v63 * v468
        v493 = v68 * v449 - v64 * v469
        v494 = v69 * v450 - v65 * v470
        v495 = v66 * v451 - v62 * v471
        v496 = v67 * v452 - v63 * v472
        v497 = v68 * v453 - v64 * v473
        v498 = v69 * v454 - v65 * v474
        v499 = v66 * v455 - v62 * v475
        v500 = v67 * v456 - v63 * v476
        v501 = v68 * v457 - v64 * v477
        v502 = v69 * v458 - v65 * v478
        v503 = (
            v487 * abs(v62) + v459 * v463 + (v459 + math.sqrt(v447 * v447 + v451 * v451 + v455 *
            v455)) * (v487 + math.sqrt(v467 * v467 + v471 * v471 + v475 * v475))
        )
        v504 = (
            v488 * abs(v63) + v460 * v464 + (v460 + math.sqrt(v448 * v448 + v452 * v452 + v456 *
            v456)) * (v488 + math.sqrt(v468 * v468 + v472 * v472 + v476 * v476))
        )
        v505 = (
            v489 * abs(v64) + v461 * v465 + (v461 + math.sqrt(v449 * v449 + v453 * v453 + v457 *
            v457)) * (v489 + math.sqrt(v469 * v469 + v473 * v473 + v477 * v477))
        )
        v506 = (
            v490 * abs(v65) + v462 * v466 + (v462 + math.sqrt(v450 * v450 + v454 * v454 + v458 *
            v458)) * (v490 + math.sqrt(v470 * v470 + v474 * v474 + v478 * v478))
        )
        v513 = T24 * v223
        v514 = T24 * v224
        v515 = T24 * v227
        v516 = T24 * v228
        v517 = near_length * Z1_p
        v518 = near_length * Z1_m
        v519 = v517 - T24 * v225
        v520 = v518 - T24 * v226
        v521 = near_length * v240
        v522 = near_length * v241
        v523 = v182 * v229
        v524 = v521 + v523
        v525 = v522 + v523
        v526 = inverse1 * v515
        v527 = inverse1 * v516
        v528 = abs(v24)
        v529 = abs(v25)
        v531 = v524 + math.sqrt(v513 * v513 + v519 * v519 + v515 * v515)
        v532 = v525 + math.sqrt(v514 * v514 + v520 * v520 + v516 * v516)
        v533 = inverse1 * v513 + v24 * v508
        v534 = inverse1 * v514 + v25 * v508
        v535 = inverse1 * v519 - v24 * v509
        v536 = inverse1 * v520 - v25 * v509
        v537 = v507 * v524 + v512 * v528 + v530 * v531
        v538 = v507 * v525 + v512 * v529 + v530 * v532
        v548 = v26 * v272
        v549 = w1_p * v541 + v548 - v533
        v550 = w1_p * -v541 - v548 - v533
        v551 = v26 * v273
        v552 = w1_m * v541 + v551 - v534
        v553 = w1_m * -v541 - v551 - v534
        v554 = v26 * v274 - w1_p * v540
        v555 = v535 + v554
        v556 = v535 + -v554
        v557 = v26 * v275 - w1_m * v540
        v558 = v536 + v557
        v559 = v536 + -v557
        v560 = v26 * v276
        v561 = v560 - v526
        v562 = v526 + v560
        v563 = v26 * v277
        v564 = v563 - v527
        v565 = v527 + v563
        v566 = v306 * v543 + v282 * v544
        v567 = v537 + (v566 + v308 * v546)
        v568 = v537 + (v566 + v308 * v547)
        v569 = v307 * v543 + v283 * v544
        v570 = v538 + (v569 + v309 * v546)
        v571 = v538 + (v569 + v309 * v547)
        v574 = s4_p * v572
        v575 = s4_m * v572
        v576 = s4_p * v573
        v577 = s4_m * v573
        v578 = near5 * abs(s4_p)
        v579 = near5 * abs(s4_m)
        v580 = T13 * v214
        v581 = T13 * v215
        v582 = T13 * v217
        v583 = T13 * v218
        v584 = T13 * v220
        v585 = T13 * v221
        v590 = v222 * v586
        v591 = v578 + v590 + v230 * v589
        v592 = v579 + v590 + v231 * v589
        v593 = abs(c1_pp)
        v594 = abs(c1_pm)
        v595 = abs(c1_mp)
        v596 = abs(c1_mm)
        v597 = abs(v78)
        v598 = abs(v79)
        v599 = v567 + math.sqrt(v549 * v549 + v555 * v555 + v561 * v561)
        v600 = v568 + math.sqrt(v550 * v550 + v556 * v556 + v562 * v562)
        v601 = v570 + math.sqrt(v552 * v552 + v558 * v558 + v564 * v564)
        v602 = v571 + math.sqrt(v553 * v553 + v559 * v559 + v565 * v565)
        v603 = v574 * v574
        v604 = v575 * v575
        v605 = (
            v591 + (math.sqrt(v603 + v576 * v576) + math.sqrt(v580 * v580 + v582 * v582 + v584 *
            v584))
        )
        v606 = (
            v592 + (math.sqrt(v604 + v577 * v577) + math.sqrt(v581 * v581 + v583 * v583 + v585 *
            v585))
        )
        v614 = T14 * v225
        v615 = T14 * v226
        v616 = T14 * v227
        v617 = T14 * v228
        v618 = v517 - T14 * v223
        v619 = v518 - T14 * v224
        v620 = v179 * v229
        v621 = v521 + v620
        v622 = v522 + v620
        v623 = inverse1 * v616
        v624 = inverse1 * v617
        v625 = abs(v22)
        v626 = abs(v23)
        v627 = v621 + math.sqrt(v618 * v618 + v614 * v614 + v616 * v616)
        v628 = v622 + math.sqrt(v619 * v619 + v615 * v615 + v617 * v617)
        v629 = inverse1 * v614 + v22 * v509
        v630 = inverse1 * v615 + v23 * v509
        v631 = v507 * v621 + v512 * v625 + v530 * v627
        v632 = v507 * v622 + v512 * v626 + v530 * v628
        v633 = v22 * v508 - inverse1 * v618
        v634 = v23 * v508 - inverse1 * v619
        v635 = v31 * v272 - w1_p * v607
        v636 = v633 + v635
        v637 = v633 + -v635
        v638 = v31 * v273 - w1_m * v607
        v639 = v634 + v638
        v640 = v634 + -v638
        v641 = v31 * v274
        v642 = v629 + (w1_p * v608 + v641)
        v643 = v629 + (w1_p * -v608 - v641)
        v644 = v31 * v275
        v645 = v630 + (w1_m * v608 + v644)
        v646 = v630 + (w1_m * -v608 - v644)
        v647 = v31 * v276
        v648 = v623 + v647
        v649 = v623 - v647
        v650 = v31 * v277
        v651 = v624 + v650
        v652 = v624 - v650
        v653 = v306 * v609 + v282 * v610
        v654 = v631 + (v653 + v308 * v612)
        v655 = v631 + (v653 + v308 * v613)
        v656 = v307 * v609 + v283 * v610
        v657 = v632 + (v656 + v309 * v612)
        v658 = v632 + (v656 + v309 * v613)
        v660 = s4_p * v659
        v661 = s4_m * v659
        v662 = T23 * v214
        v663 = T23 * v215
        v664 = T23 * v217
        v665 = T23 * v218
        v666 = T23 * v220
        v667 = T23 * v221
        v671 = v222 * v668
        v672 = v578 + v671 + v230 * v670
        v673 = v579 + v671 + v231 * v670
        v674 = abs(s1_pp)
        v675 = abs(v35)
        v676 = abs(s1_mp)
        v677 = abs(v37)
        v678 = abs(v80)
        v679 = abs(v81)
        v680 = v654 + math.sqrt(v636 * v636 + v642 * v642 + v648 * v648)
        v681 = v655 + math.sqrt(v637 * v637 + v643 * v643 + v649 * v649)
        v682 = v657 + math.sqrt(v639 * v639 + v645 * v645 + v651 * v651)
        v683 = v658 + math.sqrt(v640 * v640 + v646 * v646 + v652 * v652)
        v684 = (
            v672 + (math.sqrt(v603 + v660 * v660) + math.sqrt(v662 * v662 + v664 * v664 + v666 *
            v666))
        )
        v685 = (
            v673 + (math.sqrt(v604 + v661 * v661) + math.sqrt(v663 * v663 + v665 * v665 + v667 *
            v667))
        )
        v686 = s1_pp * v660 - c1_pp * v576
        v687 = v35 * v660 + c1_pm * v576
        v688 = s1_mp * v661 - c1_mp * v577
        v689 = v37 * v661 + c1_mm * v577
        v690 = c3 * v573
        v691 = c3 * v659
        v692 = abs(c3)
        v693 = near5 * v692
        v695 = v11 * v690
        v696 = v12 * v690
        v697 = v11 * v691
        v698 = v12 * v691
        v699 = abs(v11)
        v700 = abs(v12)
        v701 = v693 * v699
        v702 = v693 * v700
        v703 = v82 * v288
        v704 = v82 * v289
        v705 = v82 * v291
        v706 = v82 * v292
        v707 = v82 * v294
        v708 = v82 * v295
        v709 = v690 * v690
        v710 = v691 * v691
        v711 = v693 + math.sqrt(v709 + v710)
        v712 = v296 * abs(v82)
        v713 = v701 + v712 + v304 * v711
        v714 = v702 + v712 + v305 * v711
        v715 = v695 + s1_pp * v574
        v716 = v695 - v35 * v574
        v717 = v696 + s1_mp * v575
        v718 = v696 - v37 * v575
        v719 = v697 + c1_pp * v574
        v720 = v697 + c1_pm * v574
        v721 = v698 + c1_mp * v575
        v722 = v698 + c1_mm * v575
        v723 = c1_pp * v580 + v78 * v549 + (s1_pp * v662 + v80 * v636) - v703
        v724 = c1_pm * v580 + v78 * v550 + (v80 * v637 - v35 * v662) - v703
        v725 = c1_mp * v581 + v79 * v552 + (s1_mp * v663 + v81 * v639) - v704
        v726 = c1_mm * v581 + v79 * v553 + (v81 * v640 - v37 * v663) - v704
        v727 = c1_pp * v582 + v78 * v555 + (s1_pp * v664 + v80 * v642) - v705
        v728 = c1_pm * v582 + v78 * v556 + (v80 * v643 - v35 * v664) - v705
        v729 = c1_mp * v583 + v79 * v558 + (s1_mp * v665 + v81 * v645) - v706
        v730 = c1_mm * v583 + v79 * v559 + (v81 * v646 - v37 * v665) - v706
        v731 = c1_pp * v584 + v78 * v561 + (s1_pp * v666 + v80 * v648) - v707
        v732 = c1_pm * v584 - v78 * v562 + (v80 * v649 - v35 * v666) - v707
        v733 = c1_mp * v585 + v79 * v564 + (s1_mp * v667 + v81 * v651) - v708
        v734 = c1_mm * v585 - v79 * v565 + (v81 * v652 - v37 * v667) - v708
        v735 = (
            v713 + (v591 * v593 + v567 * v597 + v599 * v605 + (v672 * v674 + v654 * v678 + v680 *
            v684))
        )
        v736 = (
            v713 + (v591 * v594 + v568 * v597 + v600 * v605 + (v672 * v675 + v655 * v678 + v681 *
            v684))
        )
        v737 = (
            v714 + (v592 * v595 + v570 * v598 + v601 * v606 + (v673 * v676 + v657 * v679 + v682 *
            v685))
        )
        v738 = (
            v714 + (v592 * v596 + v571 * v598 + v602 * v606 + (v673 * v677 + v658 * v679 + v683 *
            v685))
        )
        v739 = T33 * v214
        v740 = T33 * v215
        v741 = T33 * v217
        v742 = T33 * v218
        v743 = T33 * v220
        v744 = T33 * v221
        v745 = v222 * abs(T33)
        v746 = v578 + v745 + v230 * v694
        v747 = v579 + v745 + v231 * v694
        v748 = c3 * v572
        v749 = v11 * v748
        v750 = v12 * v748
        v751 = v70 * v288
        v752 = v70 * v289
        v753 = v70 * v291
        v754 = v70 * v292
        v755 = v70 * v294
        v756 = v70 * v295
        v757 = v748 * v748
        v758 = v693 + math.sqrt(v709 + v757)
        v759 = v296 * abs(v70)
        v760 = v701 + v759 + v304 * v758
        v761 = v702 + v759 + v305 * v758
        v762 = abs(v71)
        v763 = abs(v72)
        v764 = v749 * v749
        v765 = v750 * v750
        v766 = (
            v760 + (math.sqrt(v764 + v695 * v695) + math.sqrt(v751 * v751 + v753 * v753 + v755 *
            v755))
        )
        v767 = (
            v761 + (math.sqrt(v765 + v696 * v696) + math.sqrt(v752 * v752 + v754 * v754 + v756 *
            v756))
        )
        v768 = v73 * v288
        v769 = v73 * v289
        v770 = v73 * v291
        v771 = v73 * v292
        v772 = v73 * v294
        v773 = v73 * v295
        v774 = v693 + math.sqrt(v710 + v757)
        v775 = v296 * abs(v73)
        v776 = v701 + v775 + v304 * v774
        v777 = v702 + v775 + v305 * v774
        v778 = abs(v74)
        v779 = abs(v75)
        v780 = (
            v776 + (math.sqrt(v764 + v697 * v697) + math.sqrt(v768 * v768 + v770 * v770 + v772 *
            v772))
        )
        v781 = (
            v777 + (math.sqrt(v765 + v698 * v698) + math.sqrt(v769 * v769 + v771 * v771 + v773 *
            v773))
        )
        v782 = s1_pp * v697 - c1_pp * v695
        v783 = v35 * v697 + c1_pm * v695
        v784 = s1_mp * v698 - c1_mp * v696
        v785 = v37 * v698 + c1_mm * v696
        v786 = v576 - s1_pp * v749
        v787 = v576 + v35 * v749
        v788 = v577 - s1_mp * v750
        v789 = v577 + v37 * v750
        v790 = c1_pp * v749 - v660
        v791 = c1_pm * v749 - v660
        v792 = c1_mp * v750 - v661
        v793 = c1_mm * v750 - v661
        v794 = v739 + (c1_pp * v751 + v71 * v549 + (s1_pp * v768 + v74 * v636))
        v795 = v739 + (c1_pm * v751 + v71 * v550 + (v74 * v637 - v35 * v768))
        v796 = v740 + (c1_mp * v752 + v72 * v552 + (s1_mp * v769 + v75 * v639))
        v797 = v740 + (c1_mm * v752 + v72 * v553 + (v75 * v640 - v37 * v769))
        v798 = v741 + (c1_pp * v753 + v71 * v555 + (s1_pp * v770 + v74 * v642))
        v799 = v741 + (c1_pm * v753 + v71 * v556 + (v74 * v643 - v35 * v770))
        v800 = v742 + (c1_mp * v754 + v72 * v558 + (s1_mp * v771 + v75 * v645))
        v801 = v742 + (c1_mm * v754 + v72 * v559 + (v75 * v646 - v37 * v771))
        v802 = v743 + (c1_pp * v755 + v71 * v561 + (s1_pp * v772 + v74 * v648))
        v803 = v743 + (c1_pm * v755 - v71 * v562 + (v74 * v649 - v35 * v772))
        v804 = v744 + (c1_mp * v756 + v72 * v564 + (s1_mp * v773 + v75 * v651))
        v805 = v744 + (c1_mm * v756 - v72 * v565 + (v75 * v652 - v37 * v773))
        v806 = (
            v746 + (v593 * v760 + v567 * v762 + v599 * v766 + (v674 * v776 + v654 * v778 + v680 *
            v780))
        )
        v807 = (
            v746 + (v594 * v760 + v568 * v762 + v600 * v766 + (v675 * v776 + v655 * v778 + v681 *
            v780))
        )
        v808 = (
            v747 + (v595 * v761 + v570 * v763 + v601 * v767 + (v676 * v777 + v657 * v779 + v682 *
            v781))
        )
        v809 = (
            v747 + (v596 * v761 + v571 * v763 + v602 * v767 + (v677 * v777 + v658 * v779 + v683 *
            v781))
        )
        v810 = S2_pp * v715 + C2_pp * v786
        v811 = S2_pm * v716 - v56 * v787
        v812 = S2_mp * v717 + C2_mp * v788
        v813 = S2_mm * v718 - v57 * v789
        v814 = S2_pp * v719 - C2_pp * v790
        v815 = S2_pm * v720 + v56 * v791
        v816 = S2_mp * v721 - C2_mp * v792
        v817 = S2_mm * v722 + v57 * v793
        v818 = S2_pp * v686 - C2_pp * v782
        v819 = S2_pm * v687 + v56 * v783
        v820 = S2_mp * v688 - C2_mp * v784
        v821 = S2_mm * v689 + v57 * v785
        v822 = S2_pp * v723 + v98 * v318 - (C2_pp * v794 + v102 * v356)
        v823 = S2_pm * v724 + v99 * v319 + (v56 * v795 + v103 * v357)
        v824 = S2_mp * v725 + v100 * v320 - (C2_mp * v796 + v104 * v358)
        v825 = S2_mm * v726 + v101 * v321 + (v57 * v797 + v105 * v359)
        v826 = S2_pp * v727 + v98 * v322 - (C2_pp * v798 + v102 * v360)
        v827 = S2_pm * v728 + v99 * v323 + (v56 * v799 + v103 * v361)
        v828 = S2_mp * v729 + v100 * v324 - (C2_mp * v800 + v104 * v362)
        v829 = S2_mm * v730 + v101 * v325 + (v57 * v801 + v105 * v363)
        v830 = S2_pp * v731 + v98 * v326 - (C2_pp * v802 + v102 * v364)
        v831 = S2_pm * v732 + v99 * v327 + (v56 * v803 + v103 * v365)
        v832 = S2_mp * v733 + v100 * v328 - (C2_mp * v804 + v104 * v366)
        v833 = S2_mm * v734 + v101 * v329 + (v57 * v805 + v105 * v367)
        v834 = (
            v399 * v735 + v331 * abs(v98) + v333 * (v735 + (math.sqrt(v715 * v715 + v719 * v719 +
            v686 * v686) + math.sqrt(v723 * v723 + v727 * v727 + v731 * v731))) + (v419 * v806 +
            v369 * abs(v102) + v371 * (v806 + (math.sqrt(v786 * v786 + v790 * v790 + v782 * v782) +
            math.sqrt(v794 * v794 + v798 * v798 + v802 * v802))))
        )
        v835 = (
            v400 * v736 + v331 * abs(v99) + v334 * (v736 + (math.sqrt(v716 * v716 + v720 * v720 +
            v687 * v687) + math.sqrt(v724 * v724 + v728 * v728 + v732 * v732))) + (v420 * v807 +
            v369 * abs(v103) + v372 * (v807 + (math.sqrt(v787 * v787 + v791 * v791 + v783 * v783) +
            math.sqrt(v795 * v795 + v799 * v799 + v803 * v803))))
        )
        v836 = (
            v401 * v737 + v332 * abs(v100) + v335 * (v737 + (math.sqrt(v717 * v717 + v721 * v721 +
            v688 * v688) + math.sqrt(v725 * v725 + v729 * v729 + v733 * v733))) + (v421 * v808 +
            v370 * abs(v104) + v373 * (v808 + (math.sqrt(v788 * v788 + v792 * v792 + v784 * v784) +
            math.sqrt(v796 * v796 + v800 * v800 + v804 * v804))))
        )
        v837 = (
            v402 * v738 + v332 * abs(v101) + v336 * (v738 + (math.sqrt(v718 * v718 + v722 * v722 +
            v689 * v689) + math.sqrt(v726 * v726 + v730 * v730 + v734 * v734))) + (v422 * v809 +
            v370 * abs(v105) + v374 * (v809 + (math.sqrt(v789 * v789 + v793 * v793 + v785 * v785) +
            math.sqrt(v797 * v797 + v801 * v801 + v805 * v805))))
        )
        v838 = abs(factor2_pp)
        v839 = abs(factor2_pm)
        v840 = abs(factor2_mp)
        v841 = abs(factor2_mm)
        v842 = v503 + math.sqrt(v491 * v491 + v495 * v495 + v499 * v499)
        v843 = v504 + math.sqrt(v492 * v492 + v496 * v496 + v500 * v500)
        v844 = v505 + math.sqrt(v493 * v493 + v497 * v497 + v501 * v501)
        v845 = v506 + math.sqrt(v494 * v494 + v498 * v498 + v502 * v502)
        v846 = s3 * (T14 * v572)
        v847 = s3 * (T24 * v572)
        v848 = s3 * (T24 * v573 + T14 * v659)
        v849 = s3 * (near_length * T23)
        v850 = s3 * (near_length * T13)
        v851 = abs(s3)
        v852 = v851 * (near5 * v182 + near_length * v589 + (near5 * v179 + near_length * v670))
        v853 = inverse1 * v846
        v854 = inverse1 * v847
        v855 = inverse1 * v848
        v856 = v507 * v852
        v857 = inverse1 * v849
        v858 = v857 + v86 * v508
        v859 = v87 * v508 - v857
        v860 = inverse1 * v850
        v861 = v860 - v86 * v509
        v862 = v860 + v87 * v509
        v863 = (
            v530 * (v852 + (math.sqrt(v846 * v846 + v847 * v847 + v848 * v848) + math.sqrt(v849 *
            v849 + v850 * v850)))
        )
        v864 = v856 + v512 * abs(v86) + v863
        v865 = v863 + (v856 + v512 * abs(v87))
        v866 = abs(v88)
        v867 = abs(v89)
        v868 = math.sqrt(v853 * v853 + v854 * v854 + v855 * v855)
        v869 = v864 + (v868 + math.sqrt(v858 * v858 + v861 * v861))
        v870 = v865 + (v868 + math.sqrt(v859 * v859 + v862 * v862))
        v871 = s3 * (v24 * v572)
        v872 = s3 * (v25 * v572)
        v873 = s3 * (v22 * v572)
        v874 = s3 * (v23 * v572)
        v875 = s3 * (v24 * v659 - v22 * v573)
        v876 = s3 * (v25 * v659 - v23 * v573)
        v877 = s3 * (T13 * v618 - T23 * v513)
        v878 = s3 * (T13 * v619 - T23 * v514)
        v879 = s3 * (T23 * v519 - T13 * v614)
        v880 = s3 * (T23 * v520 - T13 * v615)
        v881 = s3 * (T13 * v616 + T23 * v515)
        v882 = s3 * (T13 * v617 + T23 * v516)
        v883 = (
            v851 * (near5 * v625 + v586 * v621 + v589 * v627 + (near5 * v528 + v524 * v668 + v531 *
            v670))
        )
        v884 = (
            v851 * (near5 * v626 + v586 * v622 + v589 * v628 + (near5 * v529 + v525 * v668 + v532 *
            v670))
        )
        v885 = inverse1 * v871
        v886 = inverse1 * v872
        v887 = inverse1 * v873
        v888 = inverse1 * v874
        v889 = inverse1 * v875
        v890 = inverse1 * v876
        v891 = inverse1 * v881
        v892 = inverse1 * v882
        v893 = (
            v507 * v883 + v512 * abs(v90) + v530 * (v883 + (math.sqrt(v871 * v871 + v873 * v873 +
            v875 * v875) + math.sqrt(v877 * v877 + v879 * v879 + v881 * v881)))
        )
        v894 = (
            v507 * v884 + v512 * abs(v91) + v530 * (v884 + (math.sqrt(v872 * v872 + v874 * v874 +
            v876 * v876) + math.sqrt(v878 * v878 + v880 * v880 + v882 * v882)))
        )
        v895 = w1_p * v853
        v896 = v885 + v895
        v897 = v885 - v895
        v898 = w1_m * v853
        v899 = v886 + v898
        v900 = v886 - v898
        v901 = w1_p * v854
        v902 = v901 - v887
        v903 = v887 + v901
        v904 = w1_m * v854
        v905 = v904 - v888
        v906 = v888 + v904
        v907 = w1_p * v855
        v908 = v889 + v907
        v909 = v889 - v907
        v910 = w1_m * v855
        v911 = v890 + v910
        v912 = v890 - v910
        v913 = v90 * v508 - inverse1 * v877
        v914 = v91 * v508 - inverse1 * v878
        v915 = v913 + (v88 * v272 - w1_p * v858)
        v916 = v913 + (v89 * v272 - w1_p * v859)
        v917 = v914 + (v88 * v273 - w1_m * v858)
        v918 = v914 + (v89 * v273 - w1_m * v859)
        v919 = v90 * v509 - inverse1 * v879
        v920 = v91 * v509 - inverse1 * v880
        v921 = v919 + (w1_p * v861 + v88 * v274)
        v922 = v919 + (v89 * v274 - w1_p * v862)
        v923 = v920 + (w1_m * v861 + v88 * v275)
        v924 = v920 + (v89 * v275 - w1_m * v862)
        v925 = v891 + v88 * v276
        v926 = v891 + v89 * v276
        v927 = v892 + v88 * v277
        v928 = v892 + v89 * v277
        v929 = v893 + (v306 * v864 + v282 * v866 + v308 * v869)
        v930 = v893 + (v306 * v865 + v282 * v867 + v308 * v870)
        v931 = v894 + (v307 * v864 + v283 * v866 + v309 * v869)
        v932 = v894 + (v307 * v865 + v283 * v867 + v309 * v870)
        v933 = factor2_pp * v810 + v11 * v896
        v934 = factor2_pm * v811 + v11 * v897
        v935 = factor2_mp * v812 + v12 * v899
        v936 = factor2_mm * v813 + v12 * v900
        v937 = factor2_pp * v814 - v11 * v902
        v938 = factor2_pm * v815 + v11 * v903
        v939 = factor2_mp * v816 - v12 * v905
        v940 = factor2_mm * v817 + v12 * v906
        v941 = factor2_pp * v818 + v11 * v908
        v942 = v11 * v909 - factor2_pm * v819
        v943 = factor2_mp * v820 + v12 * v911
        v944 = v12 * v912 - factor2_mm * v821
        v945 = factor2_pp * v822 + v106 * v491 - (v11 * v915 + v94 * v288)
        v946 = factor2_pm * v823 + v107 * v492 - (v11 * v916 + v95 * v288)
        v947 = factor2_mp * v824 + v108 * v493 - (v12 * v917 + v96 * v289)
        v948 = factor2_mm * v825 + v109 * v494 - (v12 * v918 + v97 * v289)
        v949 = factor2_pp * v826 + v106 * v495 - (v11 * v921 + v94 * v291)
        v950 = factor2_pm * v827 + v107 * v496 - (v11 * v922 + v95 * v291)
        v951 = factor2_mp * v828 + v108 * v497 - (v12 * v923 + v96 * v292)
        v952 = factor2_mm * v829 + v109 * v498 - (v12 * v924 + v97 * v292)
        v953 = factor2_pp * v830 + v106 * v499 - (v11 * v925 + v94 * v294)
        v954 = factor2_pm * v831 + v107 * v500 - (v11 * v926 + v95 * v294)
        v955 = factor2_mp * v832 + v108 * v501 - (v12 * v927 + v96 * v295)
        v956 = factor2_mm * v833 + v109 * v502 - (v12 * v928 + v97 * v295)
        v957 = (
            v834 * v838 + v503 * abs(v106) + v842 * (v834 + (math.sqrt(v810 * v810 + v814 * v814 +
            v818 * v818) + math.sqrt(v822 * v822 + v826 * v826 + v830 * v830))) + (v699 * v929 +
            v296 * abs(v94) + v304 * (v929 + (math.sqrt(v896 * v896 + v902 * v902 + v908 * v908) +
            math.sqrt(v915 * v915 + v921 * v921 + v925 * v925)))) + (math.sqrt(v933 * v933 + v937 *
            v937 + v941 * v941) + math.sqrt(v945 * v945 + v949 * v949 + v953 * v953))
        )
        v958 = (
            v835 * v839 + v504 * abs(v107) + v843 * (v835 + (math.sqrt(v811 * v811 + v815 * v815 +
            v819 * v819) + math.sqrt(v823 * v823 + v827 * v827 + v831 * v831))) + (v699 * v930 +
            v296 * abs(v95) + v304 * (v930 + (math.sqrt(v897 * v897 + v903 * v903 + v909 * v909) +
            math.sqrt(v916 * v916 + v922 * v922 + v926 * v926)))) + (math.sqrt(v934 * v934 + v938 *
            v938 + v942 * v942) + math.sqrt(v946 * v946 + v950 * v950 + v954 * v954))
        )
        v959 = (
            v836 * v840 + v505 * abs(v108) + v844 * (v836 + (math.sqrt(v812 * v812 + v816 * v816 +
            v820 * v820) + math.sqrt(v824 * v824 + v828 * v828 + v832 * v832))) + (v700 * v931 +
            v296 * abs(v96) + v305 * (v931 + (math.sqrt(v899 * v899 + v905 * v905 + v911 * v911) +
            math.sqrt(v917 * v917 + v923 * v923 + v927 * v927)))) + (math.sqrt(v935 * v935 + v939 *
            v939 + v943 * v943) + math.sqrt(v947 * v947 + v951 * v951 + v955 * v955))
        )
        v960 = (
            v837 * v841 + v506 * abs(v109) + v845 * (v837 + (math.sqrt(v813 * v813 + v817 * v817 +
            v821 * v821) + math.sqrt(v825 * v825 + v829 * v829 + v833 * v833))) + (v700 * v932 +
            v296 * abs(v97) + v305 * (v932 + (math.sqrt(v900 * v900 + v906 * v906 + v912 * v912) +
            math.sqrt(v918 * v918 + v924 * v924 + v928 * v928)))) + (math.sqrt(v936 * v936 + v940 *
            v940 + v944 * v944) + math.sqrt(v948 * v948 + v952 * v952 + v956 * v956))
        )
        v961 = c1_pp * v572
        v962 = c1_pm * v572
        v963 = c1_mp * v572
        v964 = c1_mm * v572
        v965 = near5 * v593
        v966 = near5 * v594
        v967 = near5 * v595
        v968 = near5 * v596
        v969 = s1_pp * v572
        v970 = v35 * v572
        v971 = s1_mp * v572
        v972 = v37 * v572
        v973 = near5 * v674
        v974 = near5 * v675
        v975 = near5 * v676
        v976 = near5 * v677
        v977 = s3 * v969
        v978 = s3 * v970
        v979 = s3 * v971
        v980 = s3 * v972
        v981 = s3 * v961
        v982 = s3 * v962
        v983 = s3 * v963
        v984 = s3 * v964
        v985 = s3 * (s1_pp * v659 - c1_pp * v573)
        v986 = s3 * (v35 * v659 + c1_pm * v573)
        v987 = s3 * (s1_mp * v659 - c1_mp * v573)
        v988 = s3 * (v37 * v659 + c1_mm * v573)
        v989 = s3 * (T13 * v549 + T23 * v636)
        v990 = s3 * (T13 * v550 + T23 * v637)
        v991 = s3 * (T13 * v552 + T23 * v639)
        v992 = s3 * (T13 * v553 + T23 * v640)
        v993 = s3 * (T13 * v555 + T23 * v642)
        v994 = s3 * (T13 * v556 + T23 * v643)
        v995 = s3 * (T13 * v558 + T23 * v645)
        v996 = s3 * (T13 * v559 + T23 * v646)
        v997 = s3 * (T13 * v561 + T23 * v648)
        v998 = s3 * (T23 * v649 - T13 * v562)
        v999 = s3 * (T13 * v564 + T23 * v651)
        v1000 = s3 * (T23 * v652 - T13 * v565)
        v1001 = v851 * (v965 + v567 * v586 + v589 * v599 + (v973 + v654 * v668 + v670 * v680))
        v1002 = v851 * (v966 + v568 * v586 + v589 * v600 + (v974 + v655 * v668 + v670 * v681))
        v1003 = v851 * (v967 + v570 * v586 + v589 * v601 + (v975 + v657 * v668 + v670 * v682))
        v1004 = v851 * (v968 + v571 * v586 + v589 * v602 + (v976 + v658 * v668 + v670 * v683))
        v1005 = C2_pp * v985
        v1006 = v56 * v986
        v1007 = C2_mp * v987
        v1008 = v57 * v988
        v1009 = s3 * v573
        v1010 = s3 * v659
        v1011 = near5 * v851
        v1012 = abs(v110)
        v1013 = v331 * v1012
        v1014 = v332 * v1012
        v1015 = v1011 + math.sqrt(v1009 * v1009 + v1010 * v1010)
        v1016 = S2_pp * v1009 - C2_pp * v977
        v1017 = S2_pm * v1009 - v56 * v978
        v1018 = S2_mp * v1009 - C2_mp * v979
        v1019 = S2_mm * v1009 - v57 * v980
        v1020 = C2_pp * v981 - S2_pp * v1010
        v1021 = v56 * v982 + S2_pm * v1010
        v1022 = C2_mp * v983 - S2_mp * v1010
        v1023 = v57 * v984 + S2_mm * v1010
        v1024 = C2_pp * v989 + v111 * v356 + v110 * v318
        v1025 = v110 * v319 - (v56 * v990 + v112 * v357)
        v1026 = C2_mp * v991 + v113 * v358 + v110 * v320
        v1027 = v110 * v321 - (v57 * v992 + v114 * v359)
        v1028 = C2_pp * v993 + v111 * v360 + v110 * v322
        v1029 = v110 * v323 - (v56 * v994 + v112 * v361)
        v1030 = C2_mp * v995 + v113 * v362 + v110 * v324
        v1031 = v110 * v325 - (v57 * v996 + v114 * v363)
        v1032 = C2_pp * v997 + v111 * v364 + v110 * v326
        v1033 = v110 * v327 - (v56 * v998 + v112 * v365)
        v1034 = C2_mp * v999 + v113 * v366 + v110 * v328
        v1035 = v110 * v329 - (v57 * v1000 + v114 * v367)
        v1036 = (
            v419 * v1001 + v369 * abs(v111) + v371 * (v1001 + (math.sqrt(v977 * v977 + v981 * v981 +
            v985 * v985) + math.sqrt(v989 * v989 + v993 * v993 + v997 * v997))) + (v1013 + v399 *
            v1011 + v333 * v1015)
        )
        v1037 = (
            v420 * v1002 + v369 * abs(v112) + v372 * (v1002 + (math.sqrt(v978 * v978 + v982 * v982 +
            v986 * v986) + math.sqrt(v990 * v990 + v994 * v994 + v998 * v998))) + (v1013 + v400 *
            v1011 + v334 * v1015)
        )
        v1038 = (
            v421 * v1003 + v370 * abs(v113) + v373 * (v1003 + (math.sqrt(v979 * v979 + v983 * v983 +
            v987 * v987) + math.sqrt(v991 * v991 + v995 * v995 + v999 * v999))) + (v1014 + v401 *
            v1011 + v335 * v1015)
        )
        v1039 = (
            v422 * v1004 + v370 * abs(v114) + v374 * (v1004 + (math.sqrt(v980 * v980 + v984 * v984 +
            v988 * v988) + math.sqrt(v992 * v992 + v996 * v996 + v1000 * v1000))) + (v1014 + v402 *
            v1011 + v336 * v1015)
        )
        v1040 = factor2_pp * v1016 - c3 * v961
        v1041 = factor2_pm * v1017 - c3 * v962
        v1042 = factor2_mp * v1018 - c3 * v963
        v1043 = factor2_mm * v1019 - c3 * v964
        v1044 = factor2_pp * v1020 - c3 * v969
        v1045 = c3 * v970 - factor2_pm * v1021
        v1046 = factor2_mp * v1022 - c3 * v971
        v1047 = c3 * v972 - factor2_mm * v1023
        v1048 = factor2_pp * v1005 + c3 * (s1_pp * v573 + c1_pp * v659)
        v1049 = factor2_pm * v1006 + c3 * (c1_pm * v659 - v35 * v573)
        v1050 = factor2_mp * v1007 + c3 * (s1_mp * v573 + c1_mp * v659)
        v1051 = factor2_mm * v1008 + c3 * (c1_mm * v659 - v37 * v573)
        v1052 = factor2_pp * v1024 + v115 * v491 - c3 * (T13 * v636 - T23 * v549)
        v1053 = factor2_pm * v1025 + v116 * v492 - c3 * (T13 * v637 - T23 * v550)
        v1054 = factor2_mp * v1026 + v117 * v493 - c3 * (T13 * v639 - T23 * v552)
        v1055 = factor2_mm * v1027 + v118 * v494 - c3 * (T13 * v640 - T23 * v553)
        v1056 = factor2_pp * v1028 + v115 * v495 - c3 * (T13 * v642 - T23 * v555)
        v1057 = factor2_pm * v1029 + v116 * v496 - c3 * (T13 * v643 - T23 * v556)
        v1058 = factor2_mp * v1030 + v117 * v497 - c3 * (T13 * v645 - T23 * v558)
        v1059 = factor2_mm * v1031 + v118 * v498 - c3 * (T13 * v646 - T23 * v559)
        v1060 = factor2_pp * v1032 + v115 * v499 - c3 * (T13 * v648 - T23 * v561)
        v1061 = factor2_pm * v1033 + v116 * v500 - c3 * (T13 * v649 + T23 * v562)
        v1062 = factor2_mp * v1034 + v117 * v501 - c3 * (T13 * v651 - T23 * v564)
        v1063 = factor2_mm * v1035 + v118 * v502 - c3 * (T13 * v652 + T23 * v565)
        v1064 = (
            v838 * v1036 + v503 * abs(v115) + v842 * (v1036 + (math.sqrt(v1016 * v1016 + v1020 *
            v1020 + v1005 * v1005) + math.sqrt(v1024 * v1024 + v1028 * v1028 + v1032 * v1032))) +
            v692 * (v973 + v586 * v654 + v589 * v680 + (v965 + v567 * v668 + v599 * v670)) +
            (math.sqrt(v1040 * v1040 + v1044 * v1044 + v1048 * v1048) + math.sqrt(v1052 * v1052 +
            v1056 * v1056 + v1060 * v1060))
        )
        v1065 = (
            v839 * v1037 + v504 * abs(v116) + v843 * (v1037 + (math.sqrt(v1017 * v1017 + v1021 *
            v1021 + v1006 * v1006) + math.sqrt(v1025 * v1025 + v1029 * v1029 + v1033 * v1033))) +
            v692 * (v974 + v586 * v655 + v589 * v681 + (v966 + v568 * v668 + v600 * v670)) +
            (math.sqrt(v1041 * v1041 + v1045 * v1045 + v1049 * v1049) + math.sqrt(v1053 * v1053 +
            v1057 * v1057 + v1061 * v1061))
        )
        v1066 = (
            v840 * v1038 + v505 * abs(v117) + v844 * (v1038 + (math.sqrt(v1018 * v1018 + v1022 *
            v1022 + v1007 * v1007) + math.sqrt(v1026 * v1026 + v1030 * v1030 + v1034 * v1034))) +
            v692 * (v975 + v586 * v657 + v589 * v682 + (v967 + v570 * v668 + v601 * v670)) +
            (math.sqrt(v1042 * v1042 + v1046 * v1046 + v1050 * v1050) + math.sqrt(v1054 * v1054 +
            v1058 * v1058 + v1062 * v1062))
        )
        v1067 = (
            v841 * v1039 + v506 * abs(v118) + v845 * (v1039 + (math.sqrt(v1019 * v1019 + v1023 *
            v1023 + v1008 * v1008) + math.sqrt(v1027 * v1027 + v1031 * v1031 + v1035 * v1035))) +
            v692 * (v976 + v586 * v658 + v589 * v683 + (v968 + v571 * v668 + v602 * v670)) +
            (math.sqrt(v1043 * v1043 + v1047 * v1047 + v1051 * v1051) + math.sqrt(v1055 * v1055 +
            v1059 * v1059 + v1063 * v1063))
        )

        # a joint is free, or branches meet
        kept[17 * w + k] = (
            1.0 if abs(N1) <= near1 or abs(v197 + (D4 + D4)) <= v197 or abs(v177) <= 2.0 * v192 or
            abs(v122) <= v960 * v960 + v1067 * v1067 or abs(v61) <= v386 or abs(v121) <= v959 * v959
            + v1066 * v1066 or abs(v60) <= v385 or abs(v120) <= v958 * v958 + v1065 * v1065 or
            abs(v59) <= v384 or abs(v119) <= v957 * v957 + v1064 * v1064 or abs(v58) <= v383 or N1
            <= near_doubt_limit_squared2 or v61 <= near_m4 or v60 <= near_m4 or v59 <= near_m4 or
            v58 <= near_m4 or abs(v251 + (D1_m + D1_m)) <= v251 or abs(D1_m * v15) <= near_m3 * v21
            or abs(v250 + (D1_p + D1_p)) <= v250 or abs(D1_p * v15) <= near_m3 * v20 or N4 <=
            near_doubt_limit_squared4 or v122 <= near_m5 or v121 <= near_m5 or v120 <= near_m5 or
            v119 <= near_m5 or abs(v21) <= 2.0 * v241 or abs(D4) <= near_m1 * v177 or abs(v20) <=
            2.0 * v240 else kept[17 * w + k]
        )
        kept[57 * w + k], kept[58 * w + k], kept[59 * w + k] = v16, v17, Y5_pp
        kept[60 * w + k], kept[61 * w + k], kept[62 * w + k] = Y5_pm, Y5_mp, Y5_mm
        kept[63 * w + k], kept[64 * w + k], kept[65 * w + k] = s7_pp, s7_pm, s7_mp
        kept[66 * w + k], kept[67 * w + k], kept[68 * w + k] = s7_mm, q3_ppp, q3_mpp
        turns[2 * w + k], turns[3 * w + k], turns[4 * w + k] = s1_pp, -v35, s1_mp
        turns[5 * w + k], turns[6 * w + k], turns[7 * w + k] = -v37, S2_pp, S2_pm
        turns[8 * w + k], turns[9 * w + k], turns[10 * w + k] = S2_mp, S2_mm, Y5_pp
        turns[11 * w + k], turns[12 * w + k], turns[13 * w + k] = Y5_pm, Y5_mp, Y5_mm
        turns[14 * w + k], turns[15 * w + k] = math.sqrt(v119), math.sqrt(v120)
        turns[16 * w + k], turns[17 * w + k] = math.sqrt(v121), math.sqrt(v122)
        turns[18 * w + k], turns[19 * w + k], turns[20 * w + k] = s7_pp, s7_pm, s7_mp
        turns[21 * w + k], turns[22 * w + k], turns[23 * w + k] = s7_mm, s4_p, s4_m
        turns[26 * w + k], turns[27 * w + k], turns[28 * w + k] = c1_pp, c1_pm, c1_mp
        turns[29 * w + k], turns[30 * w + k], turns[31 * w + k] = c1_mm, C2_pp, -v56
        turns[32 * w + k], turns[33 * w + k], turns[34 * w + k] = C2_mp, -v57, c5_pp
        turns[35 * w + k], turns[36 * w + k], turns[37 * w + k] = c5_pm, c5_mp, c5_mm
        turns[38 * w + k] = (
            -(s4_p * v94 + factor2_pp * (C2_pp * (c1_pp * v123 + s1_pp * v125 - v127) + S2_pp *
            (v133 + (c1_pp * v129 + s1_pp * v131))))
        )
        turns[39 * w + k] = (
            -(s4_p * v95 + factor2_pm * (S2_pm * (v133 + (c1_pm * v129 - v35 * v131)) - v56 * (c1_pm
            * v123 - v35 * v125 - v127)))
        )
        turns[40 * w + k] = (
            -(s4_m * v96 + factor2_mp * (C2_mp * (c1_mp * v124 + s1_mp * v126 - v128) + S2_mp *
            (v134 + (c1_mp * v130 + s1_mp * v132))))
        )
        turns[41 * w + k] = (
            -(s4_m * v97 + factor2_mm * (S2_mm * (v134 + (c1_mm * v130 - v37 * v132)) - v57 * (c1_mm
            * v124 - v37 * v126 - v128)))
        )
        turns[42 * w + k] = (
            c5_pp * (c3 * v136 - factor2_pp * (C2_pp * (s3 * (c1_pp * T12 + s1_pp * T22)) + S2_pp *
            v135)) + Y5_pp * (factor2_pp * (S2_pp * (c1_pp * v148 + s1_pp * v150 - v153) - C2_pp *
            (v146 + (c1_pp * v141 + s1_pp * v144))) - v11 * (s3 * v136))
        )
        turns[43 * w + k] = (
            Y5_pm * (factor2_pm * (S2_pm * (c1_pm * v148 - v35 * v150 - v153) + v56 * (v146 + (c1_pm
            * v141 - v35 * v144))) + v11 * (s3 * v137)) - c5_pm * (c3 * v137 + factor2_pm * (S2_pm *
            v135 - v56 * (s3 * (c1_pm * T12 - v35 * T22))))
        )
        turns[44 * w + k] = (
            c5_mp * (c3 * v138 - factor2_mp * (C2_mp * (s3 * (c1_mp * T12 + s1_mp * T22)) + S2_mp *
            v135)) + Y5_mp * (factor2_mp * (S2_mp * (c1_mp * v149 + s1_mp * v151 - v154) - C2_mp *
            (v147 + (c1_mp * v142 + s1_mp * v145))) - v12 * (s3 * v138))
        )
        turns[45 * w + k] = (
            Y5_mm * (factor2_mm * (S2_mm * (c1_mm * v149 - v37 * v151 - v154) + v57 * (v147 + (c1_mm
            * v142 - v37 * v145))) + v12 * (s3 * v139)) - c5_mm * (c3 * v139 + factor2_mm * (S2_mm *
            v135 - v57 * (s3 * (c1_mm * T12 - v37 * T22))))
        )
        turns[46 * w + k], turns[47 * w + k] = -v11, -v12
    if w == 1 and kept[17] != 0.0:
        return
    end = 26 if w == 1 else 24 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(24 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(2 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        v16, v17, Y5_pp = kept[57 * w + k], kept[58 * w + k], kept[59 * w + k]
        Y5_pm, Y5_mp, Y5_mm = kept[60 * w + k], kept[61 * w + k], kept[62 * w + k]
        s7_pp, s7_pm, s7_mp = kept[63 * w + k], kept[64 * w + k], kept[65 * w + k]
        s7_mm, q3_ppp, q3_mpp = kept[66 * w + k], kept[67 * w + k], kept[68 * w + k]
        angle1, angle2, angle3 = turns[2 * w + k], turns[3 * w + k], turns[4 * w + k]
        angle4, angle5, angle6 = turns[5 * w + k], turns[6 * w + k], turns[7 * w + k]
        angle7, angle8, angle9 = turns[8 * w + k], turns[9 * w + k], turns[10 * w + k]
        angle10, angle11, angle12 = turns[11 * w + k], turns[12 * w + k], turns[13 * w + k]
        angle13, angle14, angle15 = turns[14 * w + k], turns[15 * w + k], turns[16 * w + k]
        angle16, angle17, angle18 = turns[17 * w + k], turns[18 * w + k], turns[19 * w + k]
        angle19, angle20, angle21 = turns[20 * w + k], turns[21 * w + k], turns[22 * w + k]
        angle22 = turns[23 * w + k]

        # theta5, type 2: U5[3, 3]
        q5_ppm = angle9 - math.copysign(half_turn, Y5_pp)
        q5_pmm = angle10 - math.copysign(half_turn, Y5_pm)
        q5_mpm = angle11 - math.copysign(half_turn, Y5_mp)
        q5_mmm = angle12 - math.copysign(half_turn, Y5_mm)

        # theta7, type 3: U5[3, 2] and U5[3, 1]
        q7_ppm = angle17 - math.copysign(half_turn, s7_pp)
        q7_pmm = angle18 - math.copysign(half_turn, s7_pm)
        q7_mpm = angle19 - math.copysign(half_turn, s7_mp)
        q7_mmm = angle20 - math.copysign(half_turn, s7_mm)

        # joint values
        q4_ppp = v16 + angle21
        q4_mpp = v17 + angle22

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle1, angle5, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_ppp, angle9, angle13
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = angle17, q5_ppm, -angle13
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q7_ppm, angle2, angle6
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = angle10, angle14, angle18
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q5_pmm, -angle14, q7_pmm
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = angle3, angle7, q3_mpp
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = q4_mpp, angle11, angle15
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = angle19, q5_mpm, -angle15
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q7_mpm, angle4, angle8
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = angle12, angle16, angle20
        rows[33 * w + k], rows[34 * w + k], rows[35 * w + k] = q5_mmm, -angle16, q7_mmm
        rows[36 * w + k] = UNREACHABLE if angle1 != angle1 else OK
        rows[37 * w + k] = UNREACHABLE if angle1 != angle1 else OK
        rows[38 * w + k] = UNREACHABLE if angle2 != angle2 else OK
        rows[39 * w + k] = UNREACHABLE if angle2 != angle2 else OK
        rows[40 * w + k] = UNREACHABLE if angle3 != angle3 else OK
        rows[41 * w + k] = UNREACHABLE if angle3 != angle3 else OK
        rows[42 * w + k] = UNREACHABLE if angle4 != angle4 else OK
        rows[43 * w + k] = UNREACHABLE if angle4 != angle4 else OK


# Where in rows the joint values of each row are.
_PLACES = np.array([
    [0, 1, 2, 3, 4, 5, 6],
    [0, 1, 2, 3, 7, 8, 9],
    [10, 11, 2, 3, 12, 13, 14],
    [10, 11, 2, 3, 15, 16, 17],
    [18, 19, 20, 21, 22, 23, 24],
    [18, 19, 20, 21, 25, 26, 27],
    [28, 29, 20, 21, 30, 31, 32],
    [28, 29, 20, 21, 33, 34, 35],
])

# What makes of a pose this arm's, before and behind it, and what its angles are more; where in rows
# these are.
_LEFT, _RIGHT = np.array((1.0, 0.0, 0.0, -0.0, 0.0, -1.0, 0.0, -0.0, 0.0, 0.0, -1.0, 0.28481)), np.array((1.0, 0.0, 0.0, -0.0, -0.0, 1.0, 0.0, -0.0, 0.0, -0.0, 1.0, 0.10593))
_OFFSETS = np.array((0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
_ANGLES = np.ascontiguousarray(_PLACES[:, (0, 1, 3, 4, 5, 6)])


@_HOW.merged
def _nearby(pose, q_free):
    """Joint values that lead to all solutions; none where one of these rows may end."""
    kept, turns, rows = np.zeros(69), np.zeros(50), np.zeros(44)
    _nearest.near_pose(pose, _LEFT, _RIGHT, kept)
    kept[16:17] = q_free[:1]
    _formulas(kept, turns, rows, len(kept) // 69)
    if kept[17] != 0.0:
        return np.empty((0, 6))
    return _nearest.near_solutions(rows, _ANGLES, _OFFSETS)


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    nearby = _nearby(pose, q_free) if _COMPILED else _NONE_NEAR
    _all_joints(_NUMBERS, pose, q_free, seed, nearby, q, status)


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
        given=1,
        apart=(_whole.compile_apart,),
        words={
            "no_pose": "not finite, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?), or the value of a free joint not finite",
            "no_row": "the pose is out of reach",
            "allocates": "at every pose",
            "given": "Values of the joints 3",
        },
    ),
)
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
joint_velocities = _CALLS["joint_velocities"]
