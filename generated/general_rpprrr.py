# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 8e126e041fd99fc0
"""general_rpprrr: General arm with an oblique cross slide on its first axis.

Inverse kinematics, generated from robots/general_rpprrr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/general_rpprrr.yaml. The formulas and where they come from:
general_rpprrr.md.

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

NAME = "general_rpprrr"
METHOD = "general 4R2P"
DOF = 6
JOINT_TYPES = "RPPRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-0.8, 0.8), (0.0, 0.9), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = ("root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8")
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = 0.5  # joint offset 1 [m]
a1 = 0.1  # link length 1 [m]
ca1 = 0.30901699437494745  # cosine of twist 1
sa1 = 0.9510565162951535  # sine of twist 1
cat2 = 0.9800665778412416  # cosine of the angle of joint 2
sat2 = 0.19866933079506122  # sine of the angle of joint 2
ca2 = 0.3420201433256688  # cosine of twist 2
sa2 = 0.9396926207859083  # sine of twist 2
cat3 = 0.8775825618903728  # cosine of the angle of joint 3
sat3 = 0.479425538604203  # sine of the angle of joint 3
a3 = 0.12  # link length 3 [m]
ca3 = 0.766044443118978  # cosine of twist 3
sa3 = 0.6427876096865393  # sine of twist 3
d4 = 0.14  # joint offset 4 [m]
a4 = 0.2  # link length 4 [m]
ca4 = 0.42261826174069944  # cosine of twist 4
sa4 = 0.9063077870366499  # sine of twist 4
d5 = 0.1  # joint offset 5 [m]
a5 = 0.16  # link length 5 [m]
ca5 = 0.6427876096865394  # cosine of twist 5
sa5 = 0.766044443118978  # sine of twist 5
d6 = 0.12  # joint offset 6 [m]
f1 = -0.7701962384697986  # ca2 * ca1 - sa2 * cat2 * sa1
f2 = -0.12623975606886617  # cat3 * sat2 * sa1 - sat3 * (ca2 * cat2 * sa1 + sa2 * ca1)
f3 = -0.015148770728263941  # a3 * f2 [m]
# ca3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) - sa3 * f1
f4 = 0.9739951538781595
# d4 * (sa3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) + ca3 * f1) [m]
f5 = -0.02633971333380174
# sa4 * (sa3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) + ca3 * f1)
f6 = -0.17051348073383996
# ca4 * (sa3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) + ca3 * f1)
f7 = -0.0795117418848544
# sa3 * (sat3 * sat2 * sa1 + cat3 * (ca2 * cat2 * sa1 + sa2 * ca1)) + ca3 * f1
g5 = -0.18814080952715528
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=8, size=1.44, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0),
        _joints.Joint(place=1, turns=False, lowest=-0.8, highest=0.8),
        _joints.Joint(place=2, turns=False, lowest=0.0, highest=0.9),
        _joints.Joint(place=3),
        _joints.Joint(place=4),
        _joints.Joint(place=5),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((
            0.9800665778412416, -0.19866933079506122, 0.0, 0.1, 0.061392199476772005,
            0.30285722817184096, -0.9510565162951535, 0.0, 0.1889457616406404, 0.9320987052590042,
            0.30901699437494745, 0.5,
        )),
        _joints.ChainJoint(
            after=(
                0.8775825618903728, 0.479425538604203, 0.0, 0.0, -0.16397319142739547,
                0.3001509135978529, -0.9396926207859083, 0.0, -0.45051264084267917,
                0.824657857538776, 0.3420201433256688, 0.0,
            ),
            turns=False,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.12, 0.0, 0.766044443118978, 0.6427876096865393, 0.0, 0.0,
                -0.6427876096865393, 0.766044443118978, 0.0,
            ),
            turns=False,
        ),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.2, 0.0, 0.42261826174069944, -0.9063077870366499, 0.0, 0.0,
            0.9063077870366499, 0.42261826174069944, 0.14,
        )),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.16, 0.0, 0.6427876096865394, 0.766044443118978, 0.0, 0.0,
            -0.766044443118978, 0.6427876096865394, 0.1,
        )),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.12)),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.6944, 0.6944, 0.6944, 1.0, 1.0, 1.0), size=1.44,
    slacks=(1e-09, 1.44e-09, 1.44e-09, 1e-09, 1e-09, 1e-09),
    weights=(1.0, 0.4822530864197531, 0.4822530864197531, 1.0, 1.0, 1.0),
    paces=(1.0, 1.44, 1.44, 1.0, 1.0, 1.0), clamped_again=1e-10, steps=("clamps",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.5, 0.1, 1.2566370614359172),
    (0.2, 0.0, 0.0, 1.2217304763960306),
    (-0.5, 0.0, 0.12, -0.6981317007977318),
    (0.0, 0.14, 0.2, 1.1344640137963142),
    (0.0, 0.1, 0.16, -0.8726646259971648),
    (0.0, 0.12, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    v1, y1_y, z1_x = s1 * ca1, c1 * ca1, s1 * sa1
    v2, x2_x, x2_y = c1 * sa1, c1 * cat2 - v1 * sat2, s1 * cat2 + y1_y * sat2
    v3, v4 = c1 * sat2 + v1 * cat2, y1_y * cat2 - s1 * sat2
    y2_x, y2_y, z2_x = z1_x * sa2 - v3 * ca2, v4 * ca2 - v2 * sa2, v3 * sa2 + z1_x * ca2
    v5, x3_x, x3_y = v4 * sa2 + v2 * ca2, x2_x * cat3 - y2_x * sat3, x2_y * cat3 - y2_y * sat3
    v6, v7 = x2_x * sat3 + y2_x * cat3, x2_y * sat3 + y2_y * cat3
    y3_x, y3_y, z3_x = v6 * ca3 - z2_x * sa3, v7 * ca3 + v5 * sa3, v6 * sa3 + z2_x * ca3
    z3_y = v7 * sa3 - v5 * ca3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, x3_y * c4 + y3_y * s4, f2 * c4 + f4 * s4
    v8, v9, v10 = y3_x * c4 - x3_x * s4, y3_y * c4 - x3_y * s4, f4 * c4 - f2 * s4
    y4_x, y4_y, y4_z = v8 * ca4 + z3_x * sa4, v9 * ca4 + z3_y * sa4, v10 * ca4 + f6
    z4_x, z4_y, z4_z = z3_x * ca4 - v8 * sa4, z3_y * ca4 - v9 * sa4, f7 - v10 * sa4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, x4_z * c5 + y4_z * s5
    v11, v12, v13 = y4_x * c5 - x4_x * s5, y4_y * c5 - x4_y * s5, y4_z * c5 - x4_z * s5
    y5_x, y5_y, y5_z = v11 * ca5 - z4_x * sa5, v12 * ca5 - z4_y * sa5, v13 * ca5 - z4_z * sa5
    z5_x, z5_y, z5_z = v11 * sa5 + z4_x * ca5, v12 * sa5 + z4_y * ca5, v13 * sa5 + z4_z * ca5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + y5_x * s6, y5_x * c6 - x5_x * s6, z5_x
    T[0, 3] = (
        c1 * a1 + z1_x * q[1] + z2_x * q[2] + x3_x * a3 + x4_x * a4 + z3_x * d4 + x5_x * a5 + z4_x *
        d5 + z5_x * d6
    )
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + y5_y * s6, y5_y * c6 - x5_y * s6, z5_y
    T[1, 3] = (
        s1 * a1 - v2 * q[1] - v5 * q[2] + x3_y * a3 + x4_y * a4 + z3_y * d4 + x5_y * a5 + z4_y * d5
        + z5_y * d6
    )
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 + y5_z * s6, y5_z * c6 - x5_z * s6, z5_z
    T[2, 3] = d1 + ca1 * q[1] + f1 * q[2] + f3 + x4_z * a4 + f5 + x5_z * a5 + z4_z * d5 + z5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    v1, y1_y, z1_x = s1 * ca1, c1 * ca1, s1 * sa1
    v2, x2_x, x2_y = c1 * sa1, c1 * cat2 - v1 * sat2, s1 * cat2 + y1_y * sat2
    v3, v4 = c1 * sat2 + v1 * cat2, y1_y * cat2 - s1 * sat2
    y2_x, y2_y, z2_x = z1_x * sa2 - v3 * ca2, v4 * ca2 - v2 * sa2, v3 * sa2 + z1_x * ca2
    v5, x3_x, x3_y = v4 * sa2 + v2 * ca2, x2_x * cat3 - y2_x * sat3, x2_y * cat3 - y2_y * sat3
    v6, v7 = x2_x * sat3 + y2_x * cat3, x2_y * sat3 + y2_y * cat3
    p3_x = c1 * a1 + z1_x * q[1] + z2_x * q[2] + x3_x * a3
    p3_y, p3_z = s1 * a1 - v2 * q[1] - v5 * q[2] + x3_y * a3, d1 + ca1 * q[1] + f1 * q[2] + f3
    y3_x, y3_y, z3_x = v6 * ca3 - z2_x * sa3, v7 * ca3 + v5 * sa3, v6 * sa3 + z2_x * ca3
    z3_y = v7 * sa3 - v5 * ca3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, x3_y * c4 + y3_y * s4, f2 * c4 + f4 * s4
    v8, v9, v10 = y3_x * c4 - x3_x * s4, y3_y * c4 - x3_y * s4, f4 * c4 - f2 * s4
    p4_x, p4_y = p3_x + x4_x * a4 + z3_x * d4, p3_y + x4_y * a4 + z3_y * d4
    p4_z, y4_x, y4_y = p3_z + x4_z * a4 + f5, v8 * ca4 + z3_x * sa4, v9 * ca4 + z3_y * sa4
    y4_z, z4_x, z4_y = v10 * ca4 + f6, z3_x * ca4 - v8 * sa4, z3_y * ca4 - v9 * sa4
    z4_z = f7 - v10 * sa4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    p5_x = p4_x + (x4_x * c5 + y4_x * s5) * a5 + z4_x * d5
    p5_y = p4_y + (x4_y * c5 + y4_y * s5) * a5 + z4_y * d5
    p5_z = p4_z + (x4_z * c5 + y4_z * s5) * a5 + z4_z * d5
    z5_x = (y4_x * c5 - x4_x * s5) * sa5 + z4_x * ca5
    z5_y = (y4_y * c5 - x4_y * s5) * sa5 + z4_y * ca5
    z5_z, p6_x = (y4_z * c5 - x4_z * s5) * sa5 + z4_z * ca5, p5_x + z5_x * d6
    p6_y, p6_z, v11 = p5_y + z5_y * d6, p5_z + z5_z * d6, p6_x - p3_x
    v12, v13, v14 = p6_y - p3_y, p6_z - p3_z, p6_x - p4_x
    v15, v16, v17 = p6_y - p4_y, p6_z - p4_z, p6_x - p5_x
    v18, v19 = p6_y - p5_y, p6_z - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, z1_x, z2_x
    J[0, 3], J[0, 4] = z3_y * v13 - g5 * v12, z4_y * v16 - z4_z * v15
    J[0, 5] = z5_y * v19 - z5_z * v18
    J[1, 0], J[1, 1], J[1, 2] = p6_x, -v2, -v5
    J[1, 3], J[1, 4] = g5 * v11 - z3_x * v13, z4_z * v14 - z4_x * v16
    J[1, 5] = z5_z * v17 - z5_x * v19
    J[2, 1], J[2, 2], J[2, 3] = ca1, f1, z3_x * v12 - z3_y * v11
    J[2, 4], J[2, 5] = z4_x * v15 - z4_y * v14, z5_x * v18 - z5_y * v17
    J[3, 3], J[3, 4], J[3, 5] = z3_x, z4_x, z5_x
    J[4, 3], J[4, 4], J[4, 5] = z3_y, z4_y, z5_y
    J[5, 0], J[5, 3], J[5, 4] = 1.0, g5, z4_z
    J[5, 5] = z5_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.32546573682169855, reach=math.inf,
    links=(
        _loops.Link((
            0.9800665778412416, -0.19866933079506124, 0.0, 0.30725200439388645, 0.06139219947677201,
            0.302857228171841, -0.9510565162951536, -0.018302540677770086, 0.1889457616406404,
            0.9320987052590043, 0.3090169943749475, 1.5422069881142466e-09,
        )),
        _loops.Link((
            0.8775825618903728, 0.479425538604203, 0.0, 0.0, -0.16397319142739547,
            0.30015091359785295, -0.9396926207859084, -0.10069829274999541, -0.45051264084267917,
            0.8246578575387761, 0.3420201433256689, 0.01740675107216298,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.3687024052726637, 0.735402665394219, 0.2144924440733139,
            0.6427876096865394, 0.17431437873429476, -0.6170761052990777, -0.17998053071223105,
            0.7660444431189781, 0.10057890222660615,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.6145040087877729, 0.3060339136742996,
            0.29146087016599964, -0.9063077870366499, -0.06460811427924738, 0.6562918457851603,
            0.6250398531287241, 0.42261826174069944, 0.18909503225749508,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, 0.49160320703021826, 0.608042333487267,
            0.2084716571956344, 0.766044443118978, -0.11619000069250957, -0.7246366353828171,
            -0.24844684641696585, 0.6427876096865394, 0.13846985098478687,
        )),
        _loops.Link((
            0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.5019354973539834,
        )),
        _loops.Link((
            1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.16936510476171932,
        )),
    ),
    advances=(
        (0.6, 0.8),
        (1.0, 0.0),
        (1.0, 0.0),
        (0.28, 0.96),
        (0.6896551724137931, 0.7241379310344828),
        (0.32432432432432434, 0.9459459459459459),
    ),
    formulations=(
        _loops.Formulation(joints=(0, 1, 2, 3, 4, 5), sign=1.0),
        _loops.Formulation(joints=(5, 0, 1, 2, 3, 4), sign=1.0),
    ),
    slides=(1, 2),
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
