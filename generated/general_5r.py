# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 18f2b87bcd3b3853
"""general_5r: Five revolute joints without structure, for whole poses.

Inverse kinematics, generated from robots/general_5r.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/general_5r.yaml. The formulas and where they come from: general_5r.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 5), _runtime("arrays").zeros

NAME = "general_5r"
METHOD = "general 6R"
DOF = 5
JOINT_TYPES = "RRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5")
JOINT_LIMITS = (
    (-2.9670597283903604, 2.9670597283903604), (-2.0943951023931953, 2.0943951023931953),
    (-2.443460952792061, 2.443460952792061), (-3.141592653589793, 3.141592653589793),
    (-3.141592653589793, 3.141592653589793),
)
BRANCHES = (
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
)
MAX_SOLUTIONS = 16

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = 0.32  # joint offset 1 [m]
a1 = 0.09  # link length 1 [m]
ca1 = 0.3420201433256688  # cosine of twist 1
sa1 = 0.9396926207859083  # sine of twist 1
d2 = 0.11  # joint offset 2 [m]
a2 = 0.38  # link length 2 [m]
ca2 = 0.9063077870366499  # cosine of twist 2
sa2 = 0.42261826174069944  # sine of twist 2
d3 = -0.07  # joint offset 3 [m]
a3 = 0.29  # link length 3 [m]
ca3 = 0.5735764363510462  # cosine of twist 3
sa3 = 0.8191520442889918  # sine of twist 3
d4 = 0.14  # joint offset 4 [m]
a4 = 0.05  # link length 4 [m]
ca4 = 0.08715574274765814  # cosine of twist 4
sa4 = 0.9961946980917455  # sine of twist 4
d5 = 0.1  # joint offset 5 [m]
a5 = 0.04  # link length 5 [m]
ca5 = 0.766044443118978  # cosine of twist 5
sa5 = 0.6427876096865393  # sine of twist 5
cae11 = 0.955336489125606  # cosine of tool frame, entry 1,1
sae11 = 0.29552020666133955  # sine of tool frame, entry 1,1
ex = 0.03  # x of the tool frame [m]
ez = 0.14  # z of the tool frame [m]
f1 = 0.03762221576582357  # d2 * ca1 [m]
f2 = 0.14454395845259904  # sa2 * ca1
f3 = 0.3099755192194448  # ca2 * ca1
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16, size=1.7600000000000002, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0, lowest=-2.9670597283903604, highest=2.9670597283903604),
        _joints.Joint(place=1, lowest=-2.0943951023931953, highest=2.0943951023931953),
        _joints.Joint(place=2, lowest=-2.443460952792061, highest=2.443460952792061),
        _joints.Joint(place=3, lowest=-3.141592653589793, highest=3.141592653589793),
        _joints.Joint(place=4, lowest=-3.141592653589793, highest=3.141592653589793),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.09, 0.0, 0.3420201433256688, -0.9396926207859083, 0.0, 0.0,
            0.9396926207859083, 0.3420201433256688, 0.32,
        )),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.38, 0.0, 0.9063077870366499, -0.42261826174069944, 0.0, 0.0,
            0.42261826174069944, 0.9063077870366499, 0.11,
        )),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.29, 0.0, 0.5735764363510462, 0.8191520442889918, 0.0, 0.0,
            -0.8191520442889918, 0.5735764363510462, -0.07,
        )),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.05, 0.0, 0.08715574274765814, -0.9961946980917455, 0.0, 0.0,
            0.9961946980917455, 0.08715574274765814, 0.14,
        )),
        _joints.ChainJoint((
            0.955336489125606, 0.0, 0.29552020666133955, 0.07, -0.18995672725391455,
            0.766044443118978, 0.6140784582913787, 0.0899902653561155, -0.22638161214229116,
            -0.6427876096865393, 0.7318302088034644, 0.20724622203665694,
        )),
    ),
    checked=True,
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
    miss_weights=(0.5682, 0.5682, 0.5682, 1.0, 1.0, 1.0), size=1.7600000000000002,
    clamped_again=1e-10, steps=("clamps", "range exceeds a turn"),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.32, 0.09, 1.2217304763960306),
    (0.0, 0.11, 0.38, 0.4363323129985824),
    (0.0, -0.07, 0.29, -0.9599310885968813),
    (0.0, 0.14, 0.05, 1.4835298641951802),
    (0.0, 0.1, 0.04, -0.6981317007977318),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    tool=(
        0.955336489125606, 0.0, 0.29552020666133955, 0.03, 0.0, 1.0, 0.0, 0.0, -0.29552020666133955,
        0.0, 0.955336489125606, 0.14,
    ),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (5,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    v1, y1_y, z1_x = s1 * ca1, c1 * ca1, s1 * sa1
    v2 = c1 * sa1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, x2_z = c1 * c2 - v1 * s2, s1 * c2 + y1_y * s2, sa1 * s2
    v3, v4, v5 = v1 * c2 + c1 * s2, y1_y * c2 - s1 * s2, sa1 * c2
    y2_x, y2_y, y2_z = z1_x * sa2 - v3 * ca2, v4 * ca2 - v2 * sa2, v5 * ca2 + f2
    z2_x, v6, z2_z = v3 * sa2 + z1_x * ca2, v4 * sa2 + v2 * ca2, f3 - v5 * sa2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, x2_z * c3 + y2_z * s3
    v7, v8, v9 = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, y2_z * c3 - x2_z * s3
    y3_x, y3_y, y3_z = v7 * ca3 - z2_x * sa3, v8 * ca3 + v6 * sa3, v9 * ca3 - z2_z * sa3
    z3_x, z3_y, z3_z = v7 * sa3 + z2_x * ca3, v8 * sa3 - v6 * ca3, v9 * sa3 + z2_z * ca3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, x3_y * c4 + y3_y * s4, x3_z * c4 + y3_z * s4
    v10, v11, v12 = y3_x * c4 - x3_x * s4, y3_y * c4 - x3_y * s4, y3_z * c4 - x3_z * s4
    y4_x, y4_y, y4_z = v10 * ca4 + z3_x * sa4, v11 * ca4 + z3_y * sa4, v12 * ca4 + z3_z * sa4
    z4_x, z4_y, z4_z = z3_x * ca4 - v10 * sa4, z3_y * ca4 - v11 * sa4, z3_z * ca4 - v12 * sa4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, x4_z * c5 + y4_z * s5
    v13, v14, v15 = y4_x * c5 - x4_x * s5, y4_y * c5 - x4_y * s5, y4_z * c5 - x4_z * s5
    z5_x, z5_y, z5_z = v13 * sa5 + z4_x * ca5, v14 * sa5 + z4_y * ca5, v15 * sa5 + z4_z * ca5
    T[0, 0], T[0, 1] = x5_x * cae11 - z5_x * sae11, v13 * ca5 - z4_x * sa5
    T[0, 2] = x5_x * sae11 + z5_x * cae11
    T[0, 3] = (
        c1 * a1 + x2_x * a2 + z1_x * d2 + x3_x * a3 + z2_x * d3 + x4_x * a4 + z3_x * d4 + x5_x * a5
        + z4_x * d5 + x5_x * ex + z5_x * ez
    )
    T[1, 0], T[1, 1] = x5_y * cae11 - z5_y * sae11, v14 * ca5 - z4_y * sa5
    T[1, 2] = x5_y * sae11 + z5_y * cae11
    T[1, 3] = (
        s1 * a1 + x2_y * a2 - v2 * d2 + x3_y * a3 - v6 * d3 + x4_y * a4 + z3_y * d4 + x5_y * a5 +
        z4_y * d5 + x5_y * ex + z5_y * ez
    )
    T[2, 0], T[2, 1] = x5_z * cae11 - z5_z * sae11, v15 * ca5 - z4_z * sa5
    T[2, 2] = x5_z * sae11 + z5_z * cae11
    T[2, 3] = (
        d1 + x2_z * a2 + f1 + x3_z * a3 + z2_z * d3 + x4_z * a4 + z3_z * d4 + x5_z * a5 + z4_z * d5
        + x5_z * ex + z5_z * ez
    )
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 5): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 5)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y, v1 = c1 * a1, s1 * a1, s1 * ca1
    y1_y, z1_x, v2 = c1 * ca1, s1 * sa1, c1 * sa1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, x2_z = c1 * c2 - v1 * s2, s1 * c2 + y1_y * s2, sa1 * s2
    v3, v4, v5 = v1 * c2 + c1 * s2, y1_y * c2 - s1 * s2, sa1 * c2
    p2_x, p2_y, p2_z = p1_x + x2_x * a2 + z1_x * d2, p1_y + x2_y * a2 - v2 * d2, d1 + x2_z * a2 + f1
    y2_x, y2_y, y2_z = z1_x * sa2 - v3 * ca2, v4 * ca2 - v2 * sa2, v5 * ca2 + f2
    z2_x, v6, z2_z = v3 * sa2 + z1_x * ca2, v4 * sa2 + v2 * ca2, f3 - v5 * sa2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, x2_z * c3 + y2_z * s3
    v7, v8, v9 = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, y2_z * c3 - x2_z * s3
    p3_x, p3_y = p2_x + x3_x * a3 + z2_x * d3, p2_y + x3_y * a3 - v6 * d3
    p3_z, y3_x, y3_y = p2_z + x3_z * a3 + z2_z * d3, v7 * ca3 - z2_x * sa3, v8 * ca3 + v6 * sa3
    y3_z, z3_x, z3_y = v9 * ca3 - z2_z * sa3, v7 * sa3 + z2_x * ca3, v8 * sa3 - v6 * ca3
    z3_z = v9 * sa3 + z2_z * ca3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, x3_y * c4 + y3_y * s4, x3_z * c4 + y3_z * s4
    v10, v11, v12 = y3_x * c4 - x3_x * s4, y3_y * c4 - x3_y * s4, y3_z * c4 - x3_z * s4
    p4_x, p4_y = p3_x + x4_x * a4 + z3_x * d4, p3_y + x4_y * a4 + z3_y * d4
    p4_z, y4_x, y4_y = p3_z + x4_z * a4 + z3_z * d4, v10 * ca4 + z3_x * sa4, v11 * ca4 + z3_y * sa4
    y4_z, z4_x, z4_y = v12 * ca4 + z3_z * sa4, z3_x * ca4 - v10 * sa4, z3_y * ca4 - v11 * sa4
    z4_z = z3_z * ca4 - v12 * sa4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, x4_z * c5 + y4_z * s5
    J21 = (
        p4_x + x5_x * a5 + z4_x * d5 + x5_x * ex + ((y4_x * c5 - x4_x * s5) * sa5 + z4_x * ca5) * ez
    )
    v13 = (
        p4_y + x5_y * a5 + z4_y * d5 + x5_y * ex + ((y4_y * c5 - x4_y * s5) * sa5 + z4_y * ca5) * ez
    )
    v14 = (
        p4_z + x5_z * a5 + z4_z * d5 + x5_z * ex + ((y4_z * c5 - x4_z * s5) * sa5 + z4_z * ca5) * ez
    )
    v15, v16, v17 = J21 - p1_x, v13 - p1_y, v14 - d1
    v18, v19, v20 = J21 - p2_x, v13 - p2_y, v14 - p2_z
    v21, v22, v23 = J21 - p3_x, v13 - p3_y, v14 - p3_z
    v24, v25, v26 = J21 - p4_x, v13 - p4_y, v14 - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -v13, -(v2 * v17 + ca1 * v16), -(v6 * v20 + z2_z * v19)
    J[0, 3], J[0, 4] = z3_y * v23 - z3_z * v22, z4_y * v26 - z4_z * v25
    J[1, 0], J[1, 1], J[1, 2] = J21, ca1 * v15 - z1_x * v17, z2_z * v18 - z2_x * v20
    J[1, 3], J[1, 4] = z3_z * v21 - z3_x * v23, z4_z * v24 - z4_x * v26
    J[2, 1], J[2, 2] = z1_x * v16 + v2 * v15, z2_x * v19 + v6 * v18
    J[2, 3], J[2, 4] = z3_x * v22 - z3_y * v21, z4_x * v25 - z4_y * v24
    J[3, 1], J[3, 2], J[3, 3] = z1_x, z2_x, z3_x
    J[3, 4] = z4_x
    J[4, 1], J[4, 2], J[4, 3] = -v2, -v6, z3_y
    J[4, 4] = z4_y
    J[5, 0], J[5, 1], J[5, 2] = 1.0, ca1, z2_z
    J[5, 3], J[5, 4] = z3_z, z4_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.8539731738520357, reach=4.000000004,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.10538972740096156, 0.3157109015313867,
            0.13154620897141112, -0.9396926207859084, -0.038553998126521535, 0.8674085730331463,
            0.36142023876381096, 0.3420201433256689, 3.8875152434369215e-10,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, 0.44497884902628215, 0.7996833415029264,
            0.4264977821348941, -0.42261826174069944, 0.02403930282003971, 0.3728984662417936,
            0.19887918199562327, 0.9063077870366499, 0.03622890771527519,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.33958912162532057, 0.5506333788970043, 0.16060140217829294,
            0.8191520442889918, 0.06821269656711591, -0.7863859625174321, -0.22936257240091773,
            0.5735764363510462, 0.022675092750040773,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.05854984855608976, 0.06311277923106279,
            0.060107408791488376, -0.9961946980917455, 0.13470065795828057, 0.7213823675836778,
            0.6870308262701694, 0.08715574274765814, 0.06888246881618784,
        )),
        _loops.Link((
            0.4980694980694982, -0.13127413127413126, 0.8571428571428572, 0.37800838000338793,
            0.5482625482625483, -0.7181467181467182, -0.4285714285714286, 0.8414731445854858,
            0.6718146718146719, 0.6833976833976835, -0.28571428571428575, -0.12818457869075675,
        )),
        _loops.Link((
            0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.33198338483131545,
        )),
        _loops.Link((
            0.20715392159351406, 0.16111519143074884, 0.9649503343999947, 0.21994807102450414,
            0.9320899268247839, -0.3320909674116114, -0.14465115856912225, 0.7593411359264012,
            0.2971457909515084, 0.9293855413410805, -0.2189677932161469, 0.14443884746120278,
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
        _loops.Formulation(joints=(4, 5, 0, 1, 2, 3), sign=1.0),
        _loops.Formulation(joints=(3, 2, 1, 0, 5, 4), sign=-1.0),
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
