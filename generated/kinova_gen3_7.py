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
_of_joints = _runtime("entry").of_joints(_HOW, 7)

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
near1 = 0.5  # 1 / 2
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
    T = np.zeros((4, 4))
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
    J = np.zeros((6, 7))
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


# The nearest arm with a structure: what follows is its closed form.
@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T13, T14, T23, T24 = kept[2 * w + k], kept[3 * w + k], kept[6 * w + k], kept[7 * w + k]
        T34, given1 = kept[11 * w + k], kept[16 * w + k]
        v1 = near_offset3 + given1

        # theta4, type 2: the squared length of column 4 of U0
        v2 = T14 * T14
        v3 = T24 * T24

        # theta1, type 2: U1[3, 4]
        N1 = v2 + v3
        inverse1 = 1.0 / N1
        v28 = T14 * inverse1
        v33 = T24 * inverse1

        # theta5, type 2: U5[3, 3]
        v87 = T24 * T13 - T14 * T23

        # joint values
        v181 = abs(T14)
        v182 = near_length * (near_length + 2.0 * v181)
        v183 = abs(T24)
        v184 = near_length * (near_length + 2.0 * v183)
        v185 = v182 + v184
        v186 = abs(T34)
        v187 = v182 + (v184 + near_length * (near_length + 2.0 * v186))
        v232 = abs(N1)
        v251 = abs(inverse1)
        v252 = v185 * v251 / (v232 - v185)
        v260 = near_length * v251
        v261 = v260 + v252 * (near_length + v181)
        v262 = v261 + abs(v28)
        v267 = near_angle + abs(T13)
        v275 = v260 + v252 * (near_length + v183)
        v276 = v275 + abs(v33)
        v284 = near_angle + abs(T23)
        kept[18 * w + k], kept[19 * w + k], kept[20 * w + k] = v2, v3, N1
        kept[21 * w + k], kept[22 * w + k], kept[23 * w + k] = inverse1, v28, v33
        kept[24 * w + k], kept[25 * w + k], kept[26 * w + k] = v87, v181, v183
        kept[27 * w + k], kept[28 * w + k], kept[29 * w + k] = v185, v186, v187
        kept[30 * w + k], kept[31 * w + k], kept[32 * w + k] = v232, v251, v252
        kept[33 * w + k], kept[34 * w + k], kept[35 * w + k] = v261, v262, v267
        kept[36 * w + k], kept[37 * w + k], kept[38 * w + k] = v275, v276, v284
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
        inverse1, v28, v33 = kept[21 * w + k], kept[22 * w + k], kept[23 * w + k]
        v87, v181, v183 = kept[24 * w + k], kept[25 * w + k], kept[26 * w + k]
        v185, v186, v187 = kept[27 * w + k], kept[28 * w + k], kept[29 * w + k]
        v232, v251, v252 = kept[30 * w + k], kept[31 * w + k], kept[32 * w + k]
        v261, v262, v267 = kept[33 * w + k], kept[34 * w + k], kept[35 * w + k]
        v275, v276, v284 = kept[36 * w + k], kept[37 * w + k], kept[38 * w + k]
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
        v20 = 2.0 * v18
        v21 = 2.0 * v19
        v22 = near_blur_slack1 + v20
        v23 = near_blur_slack1 + v21
        v24 = T14 * Z1_p
        v25 = T14 * Z1_m
        v26 = T24 * Z1_p
        v27 = T24 * Z1_m
        v29 = inverse1 * v26
        v30 = inverse1 * v27
        v31 = w1_p * v28
        c1_pp = v29 + v31
        c1_pm = v29 - v31
        v32 = w1_m * v28
        c1_mp = v30 + v32
        c1_mm = v30 - v32
        v34 = inverse1 * v24
        v35 = inverse1 * v25
        v36 = w1_p * v33
        s1_pp = v36 - v34
        v37 = v34 + v36
        v38 = w1_m * v33
        s1_mp = v38 - v35
        v39 = v35 + v38

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        v40 = near_d5 * c3
        v41 = near_d4 * s3
        v42 = near_d3 + near_d5 * v11
        v43 = near_d3 + near_d5 * v12
        v44 = v41 + inverse4 * (v4 * v40)
        v45 = T34 * v44
        v46 = near_m2 * (inverse4 * (T34 * v40))
        v47 = w4 * v46
        v48 = v45 - v47
        v49 = v45 + v47
        v50 = w1_p * v42
        v51 = w1_m * v43
        S2_pp = v48 + v50
        S2_pm = v48 - v50
        S2_mp = v49 + v51
        S2_mm = v49 - v51
        v52 = T34 * v42
        v53 = T34 * v43
        v54 = v41 + s4_p * v40
        v55 = v41 + s4_m * v40
        v56 = w1_p * v54
        v57 = w1_m * v55
        C2_pp = v56 - v52
        v58 = v52 + v56
        C2_mp = v57 - v53
        v59 = v53 + v57
        v60 = S2_pp * S2_pp + C2_pp * C2_pp
        v61 = S2_pm * S2_pm + v58 * v58
        v62 = S2_mp * S2_mp + C2_mp * C2_mp
        v63 = S2_mm * S2_mm + v59 * v59
        v64 = math.sqrt(v60)
        v65 = math.sqrt(v61)
        v66 = math.sqrt(v62)
        v67 = math.sqrt(v63)
        v68 = 1.0 / v60
        v69 = 1.0 / v61
        v70 = 1.0 / v62
        v71 = 1.0 / v63
        factor2_pp = v64 * v68
        factor2_pm = v65 * v69
        factor2_mp = v66 * v70
        factor2_mm = v67 * v71

        # theta5, type 2: U5[3, 3]
        v72 = c3 * T13
        v73 = v11 * v72
        v74 = v12 * v72
        v75 = c3 * T23
        v76 = v11 * v75
        v77 = v12 * v75
        v78 = s4_p * T33
        v79 = s4_m * T33
        v80 = s4_p * T13
        v81 = s4_m * T13
        v82 = s4_p * T23
        v83 = s4_m * T23
        v84 = c3 * T33
        v85 = v11 * v84
        v86 = v12 * v84
        v88 = s3 * v87
        v89 = s3 * -v87
        v90 = inverse1 * v88
        v91 = inverse1 * v89
        v92 = s3 * (v24 * T13 + v26 * T23)
        v93 = s3 * (v25 * T13 + v27 * T23)
        v94 = inverse1 * v92
        v95 = inverse1 * v93
        v96 = w1_p * v90 - v94
        v97 = w1_p * v91 - v94
        v98 = w1_m * v90 - v95
        v99 = w1_m * v91 - v95
        v100 = c1_pp * v80 + s1_pp * v82 - v85
        v101 = c1_pm * v80 - v37 * v82 - v85
        v102 = c1_mp * v81 + s1_mp * v83 - v86
        v103 = c1_mm * v81 - v39 * v83 - v86
        v104 = v78 + (c1_pp * v73 + s1_pp * v76)
        v105 = v78 + (c1_pm * v73 - v37 * v76)
        v106 = v79 + (c1_mp * v74 + s1_mp * v77)
        v107 = v79 + (c1_mm * v74 - v39 * v77)
        v108 = S2_pp * v100 - C2_pp * v104
        v109 = S2_pm * v101 + v58 * v105
        v110 = S2_mp * v102 - C2_mp * v106
        v111 = S2_mm * v103 + v59 * v107
        c5_pp = factor2_pp * v108 - v11 * v96
        c5_pm = factor2_pm * v109 - v11 * v97
        c5_mp = factor2_mp * v110 - v12 * v98
        c5_mm = factor2_mm * v111 - v12 * v99
        v112 = s3 * T33
        v113 = s3 * (c1_pp * T13 + s1_pp * T23)
        v114 = s3 * (c1_pm * T13 - v37 * T23)
        v115 = s3 * (c1_mp * T13 + s1_mp * T23)
        v116 = s3 * (c1_mm * T13 - v39 * T23)
        v117 = C2_pp * v113 + S2_pp * v112
        v118 = S2_pm * v112 - v58 * v114
        v119 = C2_mp * v115 + S2_mp * v112
        v120 = S2_mm * v112 - v59 * v116
        Y5_pp = factor2_pp * v117 - c3 * (s1_pp * T13 - c1_pp * T23)
        Y5_pm = factor2_pm * v118 + c3 * (v37 * T13 + c1_pm * T23)
        Y5_mp = factor2_mp * v119 - c3 * (s1_mp * T13 - c1_mp * T23)
        Y5_mm = factor2_mm * v120 + c3 * (v39 * T13 + c1_mm * T23)
        v121 = c5_pp * c5_pp + Y5_pp * Y5_pp
        v122 = c5_pm * c5_pm + Y5_pm * Y5_pm
        v123 = c5_mp * c5_mp + Y5_mp * Y5_mp
        v124 = c5_mm * c5_mm + Y5_mm * Y5_mm

        # theta6, type 3: U5[2, 3] and U5[1, 3]
        v125 = s4_p * v72
        v126 = s4_m * v72
        v127 = s4_p * v75
        v128 = s4_m * v75
        v129 = v11 * T33
        v130 = v12 * T33
        v131 = v11 * T13
        v132 = v12 * T13
        v133 = v11 * T23
        v134 = v12 * T23
        v135 = s4_p * v84
        v136 = s4_m * v84

        # theta7, type 3: U5[3, 2] and U5[3, 1]
        v137 = s3 * T32
        v138 = s1_pp * T12 - c1_pp * T22
        v139 = v37 * T12 + c1_pm * T22
        v140 = s1_mp * T12 - c1_mp * T22
        v141 = v39 * T12 + c1_mm * T22
        v142 = c3 * T12
        v143 = v11 * v142
        v144 = v12 * v142
        v145 = c3 * T22
        v146 = v11 * v145
        v147 = v12 * v145
        v148 = s4_p * T32
        v149 = s4_m * T32
        v150 = s4_p * T12
        v151 = s4_m * T12
        v152 = s4_p * T22
        v153 = s4_m * T22
        v154 = c3 * T32
        v155 = v11 * v154
        v156 = v12 * v154
        v157 = s3 * T31
        v158 = s1_pp * T11 - c1_pp * T21
        v159 = v37 * T11 + c1_pm * T21
        v160 = s1_mp * T11 - c1_mp * T21
        v161 = v39 * T11 + c1_mm * T21
        v162 = c3 * T11
        v163 = v11 * v162
        v164 = v12 * v162
        v165 = c3 * T21
        v166 = v11 * v165
        v167 = v12 * v165
        v168 = s4_p * T31
        v169 = s4_m * T31
        v170 = s4_p * T11
        v171 = s4_m * T11
        v172 = s4_p * T21
        v173 = s4_m * T21
        v174 = c3 * T31
        v175 = v11 * v174
        v176 = v12 * v174
        s7_pp = (
            c5_pp * (c3 * v158 - factor2_pp * (C2_pp * (s3 * (c1_pp * T11 + s1_pp * T21)) + S2_pp *
            v157)) + Y5_pp * (factor2_pp * (S2_pp * (c1_pp * v170 + s1_pp * v172 - v175) - C2_pp *
            (v168 + (c1_pp * v163 + s1_pp * v166))) - v11 * (s3 * v158))
        )
        s7_pm = (
            Y5_pm * (factor2_pm * (S2_pm * (c1_pm * v170 - v37 * v172 - v175) + v58 * (v168 + (c1_pm
            * v163 - v37 * v166))) + v11 * (s3 * v159)) - c5_pm * (c3 * v159 + factor2_pm * (S2_pm *
            v157 - v58 * (s3 * (c1_pm * T11 - v37 * T21))))
        )
        s7_mp = (
            c5_mp * (c3 * v160 - factor2_mp * (C2_mp * (s3 * (c1_mp * T11 + s1_mp * T21)) + S2_mp *
            v157)) + Y5_mp * (factor2_mp * (S2_mp * (c1_mp * v171 + s1_mp * v173 - v176) - C2_mp *
            (v169 + (c1_mp * v164 + s1_mp * v167))) - v12 * (s3 * v160))
        )
        s7_mm = (
            Y5_mm * (factor2_mm * (S2_mm * (c1_mm * v171 - v39 * v173 - v176) + v59 * (v169 + (c1_mm
            * v164 - v39 * v167))) + v12 * (s3 * v161)) - c5_mm * (c3 * v161 + factor2_mm * (S2_mm *
            v157 - v59 * (s3 * (c1_mm * T11 - v39 * T21))))
        )

        # joint values
        v177 = given1 + (w4 - w4)
        q3_ppp = v16 + v177
        q3_mpp = v17 + v177
        v178 = abs(D4)
        v179 = 2.0 * abs(Z4)
        v180 = near_merge_slack2 + v179
        v188 = v187 * abs(X4)
        v189 = abs(v40)
        v190 = abs(inverse4)
        v191 = v190 * (v188 * v189)
        v192 = v187 * (v179 + v187)
        v193 = v192 / D4
        v194 = v193 * (1.0 + v193) * (near1 * w4)
        v195 = near_m2 * (v190 * (near_length * v189))
        v196 = abs(w4)
        v197 = (
            v186 * v191 + near_length * (v191 + abs(v44)) + (v195 * v196 + v194 * (v195 + abs(v46)))
        )
        v198 = v188 * v190 + v194 * abs(v6)
        v199 = v198 * abs(v13)
        v200 = v185 + v199 * (v20 + v199)
        v201 = v185 + v199 * (v21 + v199)
        v202 = v200 / D1_p
        v203 = v201 / D1_m
        v204 = v202 * (1.0 + v202) * (near1 * w1_p)
        v205 = v203 * (1.0 + v203) * (near1 * w1_m)
        v206 = v190 * (near_k1 * v187) + v194 * abs(v9)
        v207 = abs(v11)
        v208 = abs(v12)
        v209 = near_d5 * v206
        v210 = abs(w1_p)
        v211 = abs(w1_m)
        v212 = abs(v42) - v209
        v213 = abs(v43) - v209
        v214 = v197 + (v204 * v212 - v209 * v210)
        v215 = v197 + (v205 * v213 - v209 * v211)
        v216 = abs(S2_pp)
        v217 = abs(S2_pm)
        v218 = abs(S2_mp)
        v219 = abs(S2_mm)
        v220 = v189 * v198
        v221 = v186 * v209
        v222 = v210 * v220 + v204 * (v220 + abs(v54)) + (near_length * v212 - v221)
        v223 = v211 * v220 + v205 * (v220 + abs(v55)) + (near_length * v213 - v221)
        v224 = abs(C2_pp)
        v225 = abs(v58)
        v226 = abs(C2_mp)
        v227 = abs(v59)
        v228 = v214 * (v214 + 2.0 * v216) + v222 * (v222 + 2.0 * v224)
        v229 = v214 * (v214 + 2.0 * v217) + v222 * (v222 + 2.0 * v225)
        v230 = v215 * (v215 + 2.0 * v218) + v223 * (v223 + 2.0 * v226)
        v231 = v215 * (v215 + 2.0 * v219) + v223 * (v223 + 2.0 * v227)
        v233 = abs(v60)
        v234 = abs(v61)
        v235 = abs(v62)
        v236 = abs(v63)
        v237 = abs(v68)
        v238 = abs(v69)
        v239 = abs(v70)
        v240 = abs(v71)
        v241 = v228 * v237 / (v233 - v228)
        v242 = v229 * v238 / (v234 - v229)
        v243 = v230 * v239 / (v235 - v230)
        v244 = v231 * v240 / (v236 - v231)
        v245 = v214 + v222
        v246 = v241 * abs(v64) + v245 * (v237 + v241)
        v247 = v242 * abs(v65) + v245 * (v238 + v242)
        v248 = v215 + v223
        v249 = v243 * abs(v66) + v248 * (v239 + v243)
        v250 = v244 * abs(v67) + v248 * (v240 + v244)
        v253 = near_length * (v18 + v199)
        v254 = near_length * (v19 + v199)
        v255 = v183 * v199
        v256 = v253 + v255
        v257 = v254 + v255
        v258 = abs(v26)
        v259 = abs(v27)
        v263 = v251 * v256 + v252 * (v256 + v258) + (v210 * v261 + v204 * v262)
        v264 = v251 * v257 + v252 * (v257 + v259) + (v211 * v261 + v205 * v262)
        v265 = near_angle * abs(s4_p)
        v266 = near_angle * abs(s4_m)
        v268 = v198 * v267
        v269 = v265 + v268
        v270 = v266 + v268
        v271 = abs(c1_pp)
        v272 = abs(c1_pm)
        v273 = abs(c1_mp)
        v274 = abs(c1_mm)
        v277 = v181 * v199
        v278 = v253 + v277
        v279 = v254 + v277
        v280 = abs(v24)
        v281 = abs(v25)
        v282 = v251 * v278 + v252 * (v278 + v280) + (v210 * v275 + v204 * v276)
        v283 = v251 * v279 + v252 * (v279 + v281) + (v211 * v275 + v205 * v276)
        v285 = v198 * v284
        v286 = v265 + v285
        v287 = v266 + v285
        v288 = abs(s1_pp)
        v289 = abs(v37)
        v290 = abs(s1_mp)
        v291 = abs(v39)
        v292 = abs(c3)
        v293 = near_angle * v292
        v294 = v207 * v293
        v295 = v208 * v293
        v296 = v206 * (v293 + abs(v84))
        v297 = v294 + v296
        v298 = v295 + v296
        v299 = v263 * (v269 + abs(v80))
        v300 = v282 * (v286 + abs(v82))
        v301 = v297 + (v269 * v271 + v299 + (v286 * v288 + v300))
        v302 = v297 + (v299 + v269 * v272 + (v300 + v286 * v289))
        v303 = v264 * (v270 + abs(v81))
        v304 = v283 * (v287 + abs(v83))
        v305 = v298 + (v270 * v273 + v303 + (v287 * v290 + v304))
        v306 = v298 + (v303 + v270 * v274 + (v304 + v287 * v291))
        v307 = v198 * (near_angle + abs(T33))
        v308 = v265 + v307
        v309 = v266 + v307
        v310 = v206 * (v293 + abs(v72))
        v311 = v294 + v310
        v312 = v295 + v310
        v313 = v206 * (v293 + abs(v75))
        v314 = v294 + v313
        v315 = v295 + v313
        v316 = v263 * (v311 + abs(v73))
        v317 = v282 * (v314 + abs(v76))
        v318 = v308 + (v271 * v311 + v316 + (v288 * v314 + v317))
        v319 = v308 + (v316 + v272 * v311 + (v317 + v289 * v314))
        v320 = v264 * (v312 + abs(v74))
        v321 = v283 * (v315 + abs(v77))
        v322 = v309 + (v273 * v312 + v320 + (v290 * v315 + v321))
        v323 = v309 + (v320 + v274 * v312 + (v321 + v291 * v315))
        v324 = v216 * v301 + v214 * (v301 + abs(v100)) + (v224 * v318 + v222 * (v318 + abs(v104)))
        v325 = v217 * v302 + v214 * (v302 + abs(v101)) + (v225 * v319 + v222 * (v319 + abs(v105)))
        v326 = v218 * v305 + v215 * (v305 + abs(v102)) + (v226 * v322 + v223 * (v322 + abs(v106)))
        v327 = v219 * v306 + v215 * (v306 + abs(v103)) + (v227 * v323 + v223 * (v323 + abs(v107)))
        v328 = abs(factor2_pp)
        v329 = abs(factor2_pm)
        v330 = abs(factor2_mp)
        v331 = abs(factor2_mm)
        v332 = abs(s3)
        v333 = (
            (near_angle * v183 + near_length * v267 + (near_angle * v181 + near_length * v284)) *
            v332
        )
        v334 = v251 * v333
        v335 = v334 + v252 * (v333 + abs(v88))
        v336 = v334 + v252 * (v333 + abs(v89))
        v337 = v335 + abs(v90)
        v338 = v336 + abs(v91)
        v339 = v332 * (near_angle * v280 + v267 * v278 + (near_angle * v258 + v256 * v284))
        v340 = v332 * (near_angle * v281 + v267 * v279 + (near_angle * v259 + v257 * v284))
        v341 = v251 * v339 + v252 * (v339 + abs(v92))
        v342 = v251 * v340 + v252 * (v340 + abs(v93))
        v343 = v341 + (v210 * v335 + v204 * v337)
        v344 = v341 + (v210 * v336 + v204 * v338)
        v345 = v342 + (v211 * v335 + v205 * v337)
        v346 = v342 + (v211 * v336 + v205 * v338)
        v347 = v324 * v328 + v246 * (v324 + abs(v108)) + (v207 * v343 + v206 * (v343 + abs(v96)))
        v348 = v325 * v329 + v247 * (v325 + abs(v109)) + (v207 * v344 + v206 * (v344 + abs(v97)))
        v349 = v326 * v330 + v249 * (v326 + abs(v110)) + (v208 * v345 + v206 * (v345 + abs(v98)))
        v350 = v327 * v331 + v250 * (v327 + abs(v111)) + (v208 * v346 + v206 * (v346 + abs(v99)))
        v351 = near_angle * v271
        v352 = near_angle * v272
        v353 = near_angle * v273
        v354 = near_angle * v274
        v355 = near_angle * v288
        v356 = near_angle * v289
        v357 = near_angle * v290
        v358 = near_angle * v291
        v359 = v263 * v267
        v360 = v282 * v284
        v361 = v332 * (v351 + v359 + (v355 + v360))
        v362 = v332 * (v352 + v359 + (v356 + v360))
        v363 = v264 * v267
        v364 = v283 * v284
        v365 = v332 * (v353 + v363 + (v357 + v364))
        v366 = v332 * (v354 + v363 + (v358 + v364))
        v367 = near_angle * v332
        v368 = v367 + abs(v112)
        v369 = v214 * v368
        v370 = v224 * v361 + v222 * (v361 + abs(v113)) + (v216 * v367 + v369)
        v371 = v225 * v362 + v222 * (v362 + abs(v114)) + (v369 + v217 * v367)
        v372 = v215 * v368
        v373 = v226 * v365 + v223 * (v365 + abs(v115)) + (v218 * v367 + v372)
        v374 = v227 * v366 + v223 * (v366 + abs(v116)) + (v372 + v219 * v367)
        v375 = v267 * v282
        v376 = v263 * v284
        v377 = v328 * v370 + v246 * (v370 + abs(v117)) + v292 * (v355 + v375 + (v351 + v376))
        v378 = v329 * v371 + v247 * (v371 + abs(v118)) + v292 * (v356 + v375 + (v352 + v376))
        v379 = v267 * v283
        v380 = v264 * v284
        v381 = v330 * v373 + v249 * (v373 + abs(v119)) + v292 * (v357 + v379 + (v353 + v380))
        v382 = v331 * v374 + v250 * (v374 + abs(v120)) + v292 * (v358 + v379 + (v354 + v380))
        v383 = 2.0 * v199

        # a joint is free, or branches meet
        kept[17 * w + k] = (
            1.0 if abs(N4) <= 0.0 or v178 <= v192 or v232 <= v185 or v196 <= v194 or abs(v180) <=
            2.0 * v187 or abs(v124) <= v350 * v350 + v382 * v382 or v236 <= v231 or abs(v123) <=
            v349 * v349 + v381 * v381 or v235 <= v230 or abs(v122) <= v348 * v348 + v378 * v378 or
            v234 <= v229 or abs(v121) <= v347 * v347 + v377 * v377 or v233 <= v228 or N1 <=
            near_doubt_limit_squared2 or v63 <= near_m4 or v62 <= near_m4 or v61 <= near_m4 or v60
            <= near_m4 or abs(D1_m) <= v201 or abs(D1_m * v15) <= near_m3 * v23 or abs(D1_p) <= v200
            or abs(D1_p * v15) <= near_m3 * v22 or N4 <= near_doubt_limit_squared4 or v124 <=
            near_m5 or v123 <= near_m5 or v122 <= near_m5 or v121 <= near_m5 or abs(v23) <= v383 or
            v178 <= near_m1 * v180 or abs(v22) <= v383 else kept[17 * w + k]
        )
        kept[39 * w + k], kept[40 * w + k], kept[41 * w + k] = v16, v17, Y5_pp
        kept[42 * w + k], kept[43 * w + k], kept[44 * w + k] = Y5_pm, Y5_mp, Y5_mm
        kept[45 * w + k], kept[46 * w + k], kept[47 * w + k] = s7_pp, s7_pm, s7_mp
        kept[48 * w + k], kept[49 * w + k], kept[50 * w + k] = s7_mm, q3_ppp, q3_mpp
        turns[2 * w + k], turns[3 * w + k], turns[4 * w + k] = s1_pp, -v37, s1_mp
        turns[5 * w + k], turns[6 * w + k], turns[7 * w + k] = -v39, S2_pp, S2_pm
        turns[8 * w + k], turns[9 * w + k], turns[10 * w + k] = S2_mp, S2_mm, Y5_pp
        turns[11 * w + k], turns[12 * w + k], turns[13 * w + k] = Y5_pm, Y5_mp, Y5_mm
        turns[14 * w + k], turns[15 * w + k] = math.sqrt(v121), math.sqrt(v122)
        turns[16 * w + k], turns[17 * w + k] = math.sqrt(v123), math.sqrt(v124)
        turns[18 * w + k], turns[19 * w + k], turns[20 * w + k] = s7_pp, s7_pm, s7_mp
        turns[21 * w + k], turns[22 * w + k], turns[23 * w + k] = s7_mm, s4_p, s4_m
        turns[26 * w + k], turns[27 * w + k], turns[28 * w + k] = c1_pp, c1_pm, c1_mp
        turns[29 * w + k], turns[30 * w + k], turns[31 * w + k] = c1_mm, C2_pp, -v58
        turns[32 * w + k], turns[33 * w + k], turns[34 * w + k] = C2_mp, -v59, c5_pp
        turns[35 * w + k], turns[36 * w + k], turns[37 * w + k] = c5_pm, c5_mp, c5_mm
        turns[38 * w + k] = (
            -(s4_p * v96 + factor2_pp * (C2_pp * (c1_pp * v125 + s1_pp * v127 - v129) + S2_pp *
            (v135 + (c1_pp * v131 + s1_pp * v133))))
        )
        turns[39 * w + k] = (
            -(s4_p * v97 + factor2_pm * (S2_pm * (v135 + (c1_pm * v131 - v37 * v133)) - v58 * (c1_pm
            * v125 - v37 * v127 - v129)))
        )
        turns[40 * w + k] = (
            -(s4_m * v98 + factor2_mp * (C2_mp * (c1_mp * v126 + s1_mp * v128 - v130) + S2_mp *
            (v136 + (c1_mp * v132 + s1_mp * v134))))
        )
        turns[41 * w + k] = (
            -(s4_m * v99 + factor2_mm * (S2_mm * (v136 + (c1_mm * v132 - v39 * v134)) - v59 * (c1_mm
            * v126 - v39 * v128 - v130)))
        )
        turns[42 * w + k] = (
            c5_pp * (c3 * v138 - factor2_pp * (C2_pp * (s3 * (c1_pp * T12 + s1_pp * T22)) + S2_pp *
            v137)) + Y5_pp * (factor2_pp * (S2_pp * (c1_pp * v150 + s1_pp * v152 - v155) - C2_pp *
            (v148 + (c1_pp * v143 + s1_pp * v146))) - v11 * (s3 * v138))
        )
        turns[43 * w + k] = (
            Y5_pm * (factor2_pm * (S2_pm * (c1_pm * v150 - v37 * v152 - v155) + v58 * (v148 + (c1_pm
            * v143 - v37 * v146))) + v11 * (s3 * v139)) - c5_pm * (c3 * v139 + factor2_pm * (S2_pm *
            v137 - v58 * (s3 * (c1_pm * T12 - v37 * T22))))
        )
        turns[44 * w + k] = (
            c5_mp * (c3 * v140 - factor2_mp * (C2_mp * (s3 * (c1_mp * T12 + s1_mp * T22)) + S2_mp *
            v137)) + Y5_mp * (factor2_mp * (S2_mp * (c1_mp * v151 + s1_mp * v153 - v156) - C2_mp *
            (v149 + (c1_mp * v144 + s1_mp * v147))) - v12 * (s3 * v140))
        )
        turns[45 * w + k] = (
            Y5_mm * (factor2_mm * (S2_mm * (c1_mm * v151 - v39 * v153 - v156) + v59 * (v149 + (c1_mm
            * v144 - v39 * v147))) + v12 * (s3 * v141)) - c5_mm * (c3 * v141 + factor2_mm * (S2_mm *
            v137 - v59 * (s3 * (c1_mm * T12 - v39 * T22))))
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
        v16, v17, Y5_pp = kept[39 * w + k], kept[40 * w + k], kept[41 * w + k]
        Y5_pm, Y5_mp, Y5_mm = kept[42 * w + k], kept[43 * w + k], kept[44 * w + k]
        s7_pp, s7_pm, s7_mp = kept[45 * w + k], kept[46 * w + k], kept[47 * w + k]
        s7_mm, q3_ppp, q3_mpp = kept[48 * w + k], kept[49 * w + k], kept[50 * w + k]
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
    """Joint values near which all solutions are; none where one of these rows may end."""
    kept, turns, rows = np.zeros(51), np.zeros(50), np.zeros(44)
    _nearest.near_pose(pose, _LEFT, _RIGHT, kept)
    kept[16:17] = q_free[:1]
    _formulas(kept, turns, rows, len(kept) // 51)
    if kept[17] != 0.0:
        return np.empty((0, 6))
    return _nearest.near_solutions(rows, _ANGLES, _OFFSETS)


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    nearby = _nearby(pose, q_free) if _COMPILED else np.empty((0, 6))
    # all joints: the general 6R loop
    solution_roots, solution_found, solution_chosen = _all_joints(
        _NUMBERS, pose, q_free, seed, nearby
    )

    for i1 in range(16):  # root1 to root16
        q1 = solution_roots[i1, 0]
        q2 = solution_roots[i1, 1]
        q3 = solution_roots[i1, 2]
        q4 = solution_roots[i1, 3]
        q5 = solution_roots[i1, 4]
        q6 = solution_roots[i1, 5]
        q7 = solution_roots[i1, 6]
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
        q[row, 6] = q7
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
