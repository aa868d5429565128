# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 008cfb16c5fc4c47
"""general_4r2p: General arm with four revolute joints and two slides.

Inverse kinematics, generated from robots/general_4r2p.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/general_4r2p.yaml. The formulas and where they come from:
general_4r2p.md.

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

NAME = "general_4r2p"
METHOD = "general 4R2P"
DOF = 6
JOINT_TYPES = "RRPRPR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-0.6, 0.6), (-math.inf, math.inf), (-0.5, 0.5),
    (-math.inf, math.inf),
)
BRANCHES = ("root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8")
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = 0.31  # joint offset 1 [m]
a1 = 0.12  # link length 1 [m]
ca1 = 0.3623577544766736  # cosine of twist 1
sa1 = 0.9320390859672263  # sine of twist 1
d2 = -0.14  # joint offset 2 [m]
a2 = 0.27  # link length 2 [m]
ca2 = 0.6967067093471654  # cosine of twist 2
sa2 = 0.7173560908995228  # sine of twist 2
cat3 = 0.9210609940028851  # cosine of the angle of joint 3
sat3 = 0.3894183423086505  # sine of the angle of joint 3
a3 = 0.09  # link length 3 [m]
ca3 = 0.32328956686350346  # cosine of twist 3
sa3 = 0.9463000876874145  # sine of twist 3
d4 = 0.22  # joint offset 4 [m]
a4 = -0.18  # link length 4 [m]
ca4 = 0.7648421872844885  # cosine of twist 4
sa4 = 0.644217687237691  # sine of twist 4
cat5 = 0.6216099682706644  # cosine of the angle of joint 5
sat5 = 0.7833269096274834  # sine of the angle of joint 5
a5 = 0.15  # link length 5 [m]
ca5 = 0.4535961214255773  # cosine of twist 5
sa5 = 0.8912073600614354  # sine of twist 5
d6 = 0.17  # joint offset 6 [m]
a6 = 0.08  # link length 6 [m]
ca6 = 0.8253356149096783  # cosine of twist 6
sa6 = 0.5646424733950354  # sine of twist 6
f1 = -0.05073008562673431  # d2 * ca1 [m]
f2 = 0.2599395422585156  # sa2 * ca1
f3 = 0.2524570787278714  # ca2 * ca1
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=8, size=1.7299999999999998, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0),
        _joints.Joint(place=1),
        _joints.Joint(place=2, turns=False, lowest=-0.6, highest=0.6),
        _joints.Joint(place=3),
        _joints.Joint(place=4, turns=False, lowest=-0.5, highest=0.5),
        _joints.Joint(place=5),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.12, 0.0, 0.3623577544766736, -0.9320390859672263, 0.0, 0.0,
            0.9320390859672263, 0.3623577544766736, 0.31,
        )),
        _joints.ChainJoint((
            0.9210609940028851, -0.3894183423086505, 0.0, 0.27, 0.2713103718292879,
            0.6417093742397794, 0.7173560908995228, 0.0, -0.2793516197631058, -0.6607287141379384,
            0.6967067093471654, -0.14,
        )),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.09, 0.0, -0.32328956686350346, -0.9463000876874145, 0.0, 0.0,
                0.9463000876874145, -0.32328956686350346, 0.0,
            ),
            turns=False,
        ),
        _joints.ChainJoint((
            0.6216099682706644, 0.7833269096274834, 0.0, -0.18, -0.5991214669182833,
            0.47543352776997644, -0.644217687237691, 0.0, -0.5046330500712651, 0.4004521361232219,
            0.7648421872844885, 0.22,
        )),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.15, 0.0, 0.4535961214255773, 0.8912073600614354, 0.0, 0.0,
                -0.8912073600614354, 0.4535961214255773, 0.0,
            ),
            turns=False,
        ),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.08, 0.0, 0.8253356149096783, -0.5646424733950354, 0.0, 0.0,
            0.5646424733950354, 0.8253356149096783, 0.17,
        )),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.578, 0.578, 0.578, 1.0, 1.0, 1.0), size=1.7299999999999998,
    slacks=(1e-09, 1e-09, 1.73e-09, 1e-09, 1.73e-09, 1e-09),
    weights=(1.0, 1.0, 0.33412409368839596, 1.0, 0.33412409368839596, 1.0),
    paces=(1.0, 1.0, 1.73, 1.0, 1.73, 1.0), clamped_again=1e-10, steps=("clamps",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.31, 0.12, 1.2),
    (0.0, -0.14, 0.27, -0.8),
    (0.4, 0.0, 0.09, 1.9),
    (0.0, 0.22, -0.18, 0.7),
    (-0.9, 0.0, 0.15, -1.1),
    (0.0, 0.17, 0.08, 0.6),
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
    v2 = c1 * sa1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, x2_z = c1 * c2 - v1 * s2, s1 * c2 + y1_y * s2, sa1 * s2
    v3, v4, v5 = v1 * c2 + c1 * s2, y1_y * c2 - s1 * s2, sa1 * c2
    v6, y2_y, y2_z = v3 * ca2 + z1_x * sa2, v4 * ca2 + v2 * sa2, v5 * ca2 - f2
    z2_x, z2_y, z2_z = z1_x * ca2 - v3 * sa2, v4 * sa2 - v2 * ca2, v5 * sa2 + f3
    x3_x, x3_y, x3_z = x2_x * cat3 - v6 * sat3, x2_y * cat3 + y2_y * sat3, x2_z * cat3 + y2_z * sat3
    v7, v8, v9 = x2_x * sat3 + v6 * cat3, y2_y * cat3 - x2_y * sat3, y2_z * cat3 - x2_z * sat3
    y3_x, y3_y, y3_z = v7 * ca3 + z2_x * sa3, z2_y * sa3 - v8 * ca3, z2_z * sa3 - v9 * ca3
    z3_x, v10, v11 = v7 * sa3 - z2_x * ca3, v8 * sa3 + z2_y * ca3, v9 * sa3 + z2_z * ca3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, x3_y * c4 + y3_y * s4, x3_z * c4 + y3_z * s4
    v12, v13, v14 = y3_x * c4 - x3_x * s4, y3_y * c4 - x3_y * s4, y3_z * c4 - x3_z * s4
    y4_x, y4_y, y4_z = v12 * ca4 + z3_x * sa4, v13 * ca4 - v10 * sa4, v14 * ca4 - v11 * sa4
    z4_x, v15, v16 = z3_x * ca4 - v12 * sa4, v13 * sa4 + v10 * ca4, v14 * sa4 + v11 * ca4
    x5_x, x5_y = x4_x * cat5 - y4_x * sat5, x4_y * cat5 - y4_y * sat5
    x5_z, v17, v18 = x4_z * cat5 - y4_z * sat5, x4_x * sat5 + y4_x * cat5, x4_y * sat5 + y4_y * cat5
    v19, y5_x, y5_y = x4_z * sat5 + y4_z * cat5, v17 * ca5 - z4_x * sa5, v18 * ca5 + v15 * sa5
    y5_z, z5_x, z5_y = v19 * ca5 + v16 * sa5, v17 * sa5 + z4_x * ca5, v18 * sa5 - v15 * ca5
    z5_z = v19 * sa5 - v16 * ca5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    x6_x, x6_y, x6_z = x5_x * c6 + y5_x * s6, x5_y * c6 + y5_y * s6, x5_z * c6 + y5_z * s6
    v20, v21, v22 = y5_x * c6 - x5_x * s6, y5_y * c6 - x5_y * s6, y5_z * c6 - x5_z * s6
    T[0, 0], T[0, 1], T[0, 2] = x6_x, v20 * ca6 + z5_x * sa6, z5_x * ca6 - v20 * sa6
    T[0, 3] = (
        c1 * a1 + x2_x * a2 + z1_x * d2 + z2_x * q[2] + x3_x * a3 + x4_x * a4 + z3_x * d4 + z4_x *
        q[4] + x5_x * a5 + x6_x * a6 + z5_x * d6
    )
    T[1, 0], T[1, 1], T[1, 2] = x6_y, v21 * ca6 + z5_y * sa6, z5_y * ca6 - v21 * sa6
    T[1, 3] = (
        s1 * a1 + x2_y * a2 - v2 * d2 + z2_y * q[2] + x3_y * a3 + x4_y * a4 - v10 * d4 - v15 * q[4]
        + x5_y * a5 + x6_y * a6 + z5_y * d6
    )
    T[2, 0], T[2, 1], T[2, 2] = x6_z, v22 * ca6 + z5_z * sa6, z5_z * ca6 - v22 * sa6
    T[2, 3] = (
        d1 + x2_z * a2 + f1 + z2_z * q[2] + x3_z * a3 + x4_z * a4 - v11 * d4 - v16 * q[4] + x5_z *
        a5 + x6_z * a6 + z5_z * d6
    )
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y, v1 = c1 * a1, s1 * a1, s1 * ca1
    y1_y, z1_x, v2 = c1 * ca1, s1 * sa1, c1 * sa1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, x2_z = c1 * c2 - v1 * s2, s1 * c2 + y1_y * s2, sa1 * s2
    v3, v4, v5 = v1 * c2 + c1 * s2, y1_y * c2 - s1 * s2, sa1 * c2
    v6, y2_y, y2_z = v3 * ca2 + z1_x * sa2, v4 * ca2 + v2 * sa2, v5 * ca2 - f2
    z2_x, z2_y, z2_z = z1_x * ca2 - v3 * sa2, v4 * sa2 - v2 * ca2, v5 * sa2 + f3
    x3_x, x3_y, x3_z = x2_x * cat3 - v6 * sat3, x2_y * cat3 + y2_y * sat3, x2_z * cat3 + y2_z * sat3
    v7, v8, v9 = x2_x * sat3 + v6 * cat3, y2_y * cat3 - x2_y * sat3, y2_z * cat3 - x2_z * sat3
    p3_x = p1_x + x2_x * a2 + z1_x * d2 + z2_x * q[2] + x3_x * a3
    p3_y = p1_y + x2_y * a2 - v2 * d2 + z2_y * q[2] + x3_y * a3
    p3_z, y3_x = d1 + x2_z * a2 + f1 + z2_z * q[2] + x3_z * a3, v7 * ca3 + z2_x * sa3
    y3_y, y3_z, z3_x = z2_y * sa3 - v8 * ca3, z2_z * sa3 - v9 * ca3, v7 * sa3 - z2_x * ca3
    v10, v11 = v8 * sa3 + z2_y * ca3, v9 * sa3 + z2_z * ca3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, x3_y * c4 + y3_y * s4, x3_z * c4 + y3_z * s4
    v12, v13, v14 = y3_x * c4 - x3_x * s4, y3_y * c4 - x3_y * s4, y3_z * c4 - x3_z * s4
    y4_x, y4_y, y4_z = v12 * ca4 + z3_x * sa4, v13 * ca4 - v10 * sa4, v14 * ca4 - v11 * sa4
    z4_x, v15, v16 = z3_x * ca4 - v12 * sa4, v13 * sa4 + v10 * ca4, v14 * sa4 + v11 * ca4
    x5_x, x5_y = x4_x * cat5 - y4_x * sat5, x4_y * cat5 - y4_y * sat5
    x5_z, v17, v18 = x4_z * cat5 - y4_z * sat5, x4_x * sat5 + y4_x * cat5, x4_y * sat5 + y4_y * cat5
    v19, p5_x = x4_z * sat5 + y4_z * cat5, p3_x + x4_x * a4 + z3_x * d4 + z4_x * q[4] + x5_x * a5
    p5_y = p3_y + x4_y * a4 - v10 * d4 - v15 * q[4] + x5_y * a5
    p5_z, z5_x = p3_z + x4_z * a4 - v11 * d4 - v16 * q[4] + x5_z * a5, v17 * sa5 + z4_x * ca5
    z5_y, z5_z = v18 * sa5 - v15 * ca5, v19 * sa5 - v16 * ca5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    p6_x = p5_x + (x5_x * c6 + (v17 * ca5 - z4_x * sa5) * s6) * a6 + z5_x * d6
    p6_y = p5_y + (x5_y * c6 + (v18 * ca5 + v15 * sa5) * s6) * a6 + z5_y * d6
    p6_z, v20 = p5_z + (x5_z * c6 + (v19 * ca5 + v16 * sa5) * s6) * a6 + z5_z * d6, p6_x - p1_x
    v21, v22, v23 = p6_y - p1_y, p6_z - d1, p6_x - p3_x
    v24, v25, v26 = p6_y - p3_y, p6_z - p3_z, p6_x - p5_x
    v27, v28 = p6_y - p5_y, p6_z - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, -(v2 * v22 + ca1 * v21), z2_x
    J[0, 3], J[0, 4], J[0, 5] = v11 * v24 - v10 * v25, z4_x, z5_y * v28 - z5_z * v27
    J[1, 0], J[1, 1], J[1, 2] = p6_x, ca1 * v20 - z1_x * v22, z2_y
    J[1, 3], J[1, 4], J[1, 5] = -(v11 * v23 + z3_x * v25), -v15, z5_z * v26 - z5_x * v28
    J[2, 1], J[2, 2], J[2, 3] = z1_x * v21 + v2 * v20, z2_z, z3_x * v24 + v10 * v23
    J[2, 4], J[2, 5] = -v16, z5_x * v27 - z5_y * v26
    J[3, 1], J[3, 3], J[3, 5] = z1_x, z3_x, z5_x
    J[4, 1], J[4, 3], J[4, 5] = -v2, -v10, z5_y
    J[5, 0], J[5, 1], J[5, 3] = 1.0, ca1, -v11
    J[5, 5] = z5_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.4522857624867539, reach=math.inf,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.2653189862537723, 0.33448408105539107,
            0.13936836710641293, -0.9320390859672263, 0.14673636817971505, 0.8603437716620551,
            0.35847657152585627, 0.3623577544766736, 6.28359350727957e-10,
        )),
        _loops.Link((
            0.9210609940028851, -0.3894183423086505, 0.0, 0.5969677190709878, 0.2713103718292879,
            0.6417093742397794, 0.7173560908995228, 0.015793558142548212, -0.2793516197631058,
            -0.6607287141379384, 0.6967067093471654, -0.136764030406117,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.19898923969032925, -0.3103579841889633, -0.09052107872178097,
            -0.9463000876874145, -0.18129993832765687, 0.9084480841799178, 0.2649640245524761,
            -0.32328956686350346, -0.08395481242875238,
        )),
        _loops.Link((
            0.6216099682706644, 0.7833269096274834, 0.0, -0.3979784793806585, -0.5991214669182833,
            0.47543352776997644, -0.644217687237691, 0.08096418764476625, -0.5046330500712651,
            0.4004521361232219, 0.7648421872844885, 0.19870586267497078,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, 0.3316487328172154, 0.4290774121593299,
            0.14711225559748453, 0.8912073600614354, -0.050805229179742194, -0.8430339892473038,
            -0.28904022488478986, 0.4535961214255773, 0.0998200647953078,
        )),
        _loops.Link((
            0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.28419795539003395,
        )),
        _loops.Link((
            1.0, 0.0, 0.0, -0.08, 0.0, 0.8253356149096783, 0.5646424733950354, -0.11054770303682969,
            0.0, -0.5646424733950354, 0.8253356149096783, -0.16158712948772755,
        )),
    ),
    advances=(
        (0.6, 0.8),
        (0.38461538461538464, 0.9230769230769231),
        (1.0, 0.0),
        (0.28, 0.96),
        (1.0, 0.0),
        (0.32432432432432434, 0.9459459459459459),
    ),
    formulations=(
        _loops.Formulation(joints=(5, 0, 1, 2, 3, 4), sign=1.0),
        _loops.Formulation(joints=(3, 4, 5, 0, 1, 2), sign=1.0),
    ),
    slides=(2, 4),
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
