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


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    nearby = np.empty((0, 6))
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
