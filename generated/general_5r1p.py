# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 738c8e4d5ce8ab8a
"""general_5r1p: General arm with five revolute joints and a slide.

Inverse kinematics, generated from robots/general_5r1p.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/general_5r1p.yaml. The formulas and where they come from:
general_5r1p.md.

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

NAME = "general_5r1p"
METHOD = "general 5R1P"
DOF = 6
JOINT_TYPES = "RRPRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-0.8, 0.8), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8", "root9", "root10",
    "root11", "root12", "root13", "root14", "root15", "root16",
)
MAX_SOLUTIONS = 16

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = -0.293  # joint offset 1 [m]
a1 = 0.278  # link length 1 [m]
ca1 = 0.012203370292583539  # cosine of twist 1
sa1 = 0.9999255361043151  # sine of twist 1
d2 = -0.196  # joint offset 2 [m]
a2 = -0.004  # link length 2 [m]
ca2 = 0.9544456308244855  # cosine of twist 2
sa2 = 0.29838488198977153  # sine of twist 2
cat3 = 0.6145349462240683  # cosine of the angle of joint 3
sat3 = 0.7888895992909156  # sine of the angle of joint 3
a3 = 0.231  # link length 3 [m]
ca3 = 0.7618754628213957  # cosine of twist 3
sa3 = 0.647723536048123  # sine of twist 3
d4 = -0.377  # joint offset 4 [m]
a4 = 0.269  # link length 4 [m]
ca4 = 0.9191023971657747  # cosine of twist 4
sa4 = 0.39401876037078043  # sine of twist 4
d5 = 0.211  # joint offset 5 [m]
a5 = -0.398  # link length 5 [m]
ca5 = 0.9463659134816423  # cosine of twist 5
sa5 = 0.323096824187513  # sine of twist 5
d6 = 0.037  # joint offset 6 [m]
a6 = 0.357  # link length 6 [m]
ca6 = 0.7427737668732654  # cosine of twist 6
sa6 = 0.6695424790443845  # sine of twist 6
f1 = -0.002391860577346374  # ca1 * d2 [m]
f2 = 0.003641301204630023  # ca1 * sa2
f3 = 0.011647453457089682  # ca1 * ca2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16, size=2.651, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0),
        _joints.Joint(place=1),
        _joints.Joint(place=2, turns=False, lowest=-0.8, highest=0.8),
        _joints.Joint(place=3),
        _joints.Joint(place=4),
        _joints.Joint(place=5),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.278, 0.0, -0.012203370292583539, -0.9999255361043151, 0.0, 0.0,
            0.9999255361043151, -0.012203370292583539, -0.293,
        )),
        _joints.ChainJoint((
            0.6145349462240683, -0.7888895992909156, 0.0, -0.004, 0.7529522312460936,
            0.5865401944125223, 0.29838488198977153, 0.0, -0.235392729987378, -0.18336793740765922,
            0.9544456308244855, -0.196,
        )),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.231, 0.0, -0.7618754628213957, 0.647723536048123, 0.0, 0.0,
                -0.647723536048123, -0.7618754628213957, 0.0,
            ),
            turns=False,
        ),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.269, 0.0, 0.9191023971657747, 0.39401876037078043, 0.0, 0.0,
            -0.39401876037078043, 0.9191023971657747, -0.377,
        )),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, -0.398, 0.0, 0.9463659134816423, 0.323096824187513, 0.0, 0.0,
            -0.323096824187513, 0.9463659134816423, 0.211,
        )),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.357, 0.0, -0.7427737668732654, -0.6695424790443845, 0.0, 0.0,
            0.6695424790443845, -0.7427737668732654, 0.037,
        )),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
    miss_weights=(0.3772, 0.3772, 0.3772, 1.0, 1.0, 1.0), size=2.651,
    slacks=(1e-09, 1e-09, 2.651e-09, 1e-09, 1e-09, 1e-09),
    weights=(1.0, 1.0, 0.14229201993625035, 1.0, 1.0, 1.0), paces=(1.0, 1.0, 2.651, 1.0, 1.0, 1.0),
    clamped_again=1e-10, steps=("clamps",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, -0.293, 0.278, 1.583),
    (0.0, -0.196, -0.004, -0.303),
    (0.909, 0.0, 0.231, -2.437),
    (0.0, -0.377, 0.269, -0.405),
    (0.0, 0.211, -0.398, -0.329),
    (0.0, 0.037, 0.357, 2.408),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    y1_x, v1, z1_x = s1 * ca1, c1 * ca1, s1 * sa1
    v2 = c1 * sa1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, x2_z = c1 * c2 + y1_x * s2, s1 * c2 - v1 * s2, sa1 * s2
    v3, v4, v5 = y1_x * c2 - c1 * s2, v1 * c2 + s1 * s2, sa1 * c2
    y2_x, y2_y, y2_z = v3 * ca2 - z1_x * sa2, v2 * sa2 - v4 * ca2, v5 * ca2 + f2
    z2_x, v6, z2_z = v3 * sa2 + z1_x * ca2, v4 * sa2 + v2 * ca2, v5 * sa2 - f3
    x3_x, x3_y = x2_x * cat3 + y2_x * sat3, x2_y * cat3 + y2_y * sat3
    x3_z, v7, v8 = x2_z * cat3 + y2_z * sat3, y2_x * cat3 - x2_x * sat3, y2_y * cat3 - x2_y * sat3
    v9, v10, y3_y = y2_z * cat3 - x2_z * sat3, v7 * ca3 + z2_x * sa3, v6 * sa3 - v8 * ca3
    v11, z3_x, z3_y = v9 * ca3 + z2_z * sa3, v7 * sa3 - z2_x * ca3, v8 * sa3 + v6 * ca3
    z3_z = v9 * sa3 - z2_z * ca3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - v10 * s4, x3_y * c4 + y3_y * s4, x3_z * c4 - v11 * s4
    v12, v13, v14 = v10 * c4 + x3_x * s4, y3_y * c4 - x3_y * s4, v11 * c4 + x3_z * s4
    v15, y4_y, v16 = v12 * ca4 + z3_x * sa4, v13 * ca4 - z3_y * sa4, v14 * ca4 + z3_z * sa4
    z4_x, z4_y, z4_z = z3_x * ca4 - v12 * sa4, v13 * sa4 + z3_y * ca4, z3_z * ca4 - v14 * sa4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 - v15 * s5, x4_y * c5 + y4_y * s5, x4_z * c5 - v16 * s5
    v17, v18, v19 = v15 * c5 + x4_x * s5, y4_y * c5 - x4_y * s5, v16 * c5 + x4_z * s5
    v20, y5_y, v21 = v17 * ca5 + z4_x * sa5, v18 * ca5 - z4_y * sa5, v19 * ca5 + z4_z * sa5
    z5_x, z5_y, z5_z = z4_x * ca5 - v17 * sa5, v18 * sa5 + z4_y * ca5, z4_z * ca5 - v19 * sa5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    x6_x, x6_y, x6_z = x5_x * c6 - v20 * s6, x5_y * c6 + y5_y * s6, x5_z * c6 - v21 * s6
    v22, v23, v24 = v20 * c6 + x5_x * s6, y5_y * c6 - x5_y * s6, v21 * c6 + x5_z * s6
    T[0, 0], T[0, 1], T[0, 2] = x6_x, v22 * ca6 + z5_x * sa6, v22 * sa6 - z5_x * ca6
    T[0, 3] = (
        c1 * a1 + x2_x * a2 + z1_x * d2 + z2_x * q[2] + x3_x * a3 + x4_x * a4 + z3_x * d4 + x5_x *
        a5 + z4_x * d5 + x6_x * a6 + z5_x * d6
    )
    T[1, 0], T[1, 1], T[1, 2] = x6_y, z5_y * sa6 - v23 * ca6, -(v23 * sa6 + z5_y * ca6)
    T[1, 3] = (
        s1 * a1 + x2_y * a2 - v2 * d2 - v6 * q[2] + x3_y * a3 + x4_y * a4 + z3_y * d4 + x5_y * a5 +
        z4_y * d5 + x6_y * a6 + z5_y * d6
    )
    T[2, 0], T[2, 1], T[2, 2] = x6_z, v24 * ca6 + z5_z * sa6, v24 * sa6 - z5_z * ca6
    T[2, 3] = (
        d1 + x2_z * a2 - f1 + z2_z * q[2] + x3_z * a3 + x4_z * a4 + z3_z * d4 + x5_z * a5 + z4_z *
        d5 + x6_z * a6 + z5_z * d6
    )
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y, y1_x = c1 * a1, s1 * a1, s1 * ca1
    v1, z1_x, v2 = c1 * ca1, s1 * sa1, c1 * sa1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, x2_z = c1 * c2 + y1_x * s2, s1 * c2 - v1 * s2, sa1 * s2
    v3, v4, v5 = y1_x * c2 - c1 * s2, v1 * c2 + s1 * s2, sa1 * c2
    y2_x, y2_y, y2_z = v3 * ca2 - z1_x * sa2, v2 * sa2 - v4 * ca2, v5 * ca2 + f2
    z2_x, v6, z2_z = v3 * sa2 + z1_x * ca2, v4 * sa2 + v2 * ca2, v5 * sa2 - f3
    x3_x, x3_y = x2_x * cat3 + y2_x * sat3, x2_y * cat3 + y2_y * sat3
    x3_z, v7, v8 = x2_z * cat3 + y2_z * sat3, y2_x * cat3 - x2_x * sat3, y2_y * cat3 - x2_y * sat3
    v9, p3_x = y2_z * cat3 - x2_z * sat3, p1_x + x2_x * a2 + z1_x * d2 + z2_x * q[2] + x3_x * a3
    p3_y = p1_y + x2_y * a2 - v2 * d2 - v6 * q[2] + x3_y * a3
    p3_z, v10 = d1 + x2_z * a2 - f1 + z2_z * q[2] + x3_z * a3, v7 * ca3 + z2_x * sa3
    y3_y, v11, z3_x = v6 * sa3 - v8 * ca3, v9 * ca3 + z2_z * sa3, v7 * sa3 - z2_x * ca3
    z3_y, z3_z = v8 * sa3 + v6 * ca3, v9 * sa3 - z2_z * ca3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - v10 * s4, x3_y * c4 + y3_y * s4, x3_z * c4 - v11 * s4
    v12, v13, v14 = v10 * c4 + x3_x * s4, y3_y * c4 - x3_y * s4, v11 * c4 + x3_z * s4
    p4_x, p4_y = p3_x + x4_x * a4 + z3_x * d4, p3_y + x4_y * a4 + z3_y * d4
    p4_z, v15, y4_y = p3_z + x4_z * a4 + z3_z * d4, v12 * ca4 + z3_x * sa4, v13 * ca4 - z3_y * sa4
    v16, z4_x, z4_y = v14 * ca4 + z3_z * sa4, z3_x * ca4 - v12 * sa4, v13 * sa4 + z3_y * ca4
    z4_z = z3_z * ca4 - v14 * sa4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 - v15 * s5, x4_y * c5 + y4_y * s5, x4_z * c5 - v16 * s5
    v17, v18, v19 = v15 * c5 + x4_x * s5, y4_y * c5 - x4_y * s5, v16 * c5 + x4_z * s5
    p5_x, p5_y = p4_x + x5_x * a5 + z4_x * d5, p4_y + x5_y * a5 + z4_y * d5
    p5_z, z5_x, z5_y = p4_z + x5_z * a5 + z4_z * d5, z4_x * ca5 - v17 * sa5, v18 * sa5 + z4_y * ca5
    z5_z = z4_z * ca5 - v19 * sa5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    p6_x = p5_x + (x5_x * c6 - (v17 * ca5 + z4_x * sa5) * s6) * a6 + z5_x * d6
    p6_y = p5_y + (x5_y * c6 + (v18 * ca5 - z4_y * sa5) * s6) * a6 + z5_y * d6
    p6_z, v20 = p5_z + (x5_z * c6 - (v19 * ca5 + z4_z * sa5) * s6) * a6 + z5_z * d6, p6_x - p1_x
    v21, v22, v23 = p6_y - p1_y, p6_z - d1, p6_x - p3_x
    v24, v25, v26 = p6_y - p3_y, p6_z - p3_z, p6_x - p4_x
    v27, v28, v29 = p6_y - p4_y, p6_z - p4_z, p6_x - p5_x
    v30, v31 = p6_y - p5_y, p6_z - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, ca1 * v21 - v2 * v22, z2_x
    J[0, 3], J[0, 4] = z3_y * v25 - z3_z * v24, z4_y * v28 - z4_z * v27
    J[0, 5] = z5_y * v31 - z5_z * v30
    J[1, 0], J[1, 1], J[1, 2] = p6_x, -(ca1 * v20 + z1_x * v22), -v6
    J[1, 3], J[1, 4] = z3_z * v23 - z3_x * v25, z4_z * v26 - z4_x * v28
    J[1, 5] = z5_z * v29 - z5_x * v31
    J[2, 1], J[2, 2], J[2, 3] = z1_x * v21 + v2 * v20, z2_z, z3_x * v24 - z3_y * v23
    J[2, 4], J[2, 5] = z4_x * v27 - z4_y * v26, z5_x * v30 - z5_y * v29
    J[3, 1], J[3, 3], J[3, 4] = z1_x, z3_x, z4_x
    J[3, 5] = z5_x
    J[4, 1], J[4, 3], J[4, 4] = -v2, z3_y, z4_y
    J[4, 5] = z5_y
    J[5, 0], J[5, 1], J[5, 3] = 1.0, -ca1, z3_z
    J[5, 4], J[5, 5] = z4_z, z5_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.6327271772032304, reach=math.inf,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.43936788242416075,
            -0.011264649500846345, -0.004693603958685977, -0.9999255361043152, 0.058795324397600594,
            0.9230081871732141, 0.38458674465550585, -0.01220337029258354, -4.6235725321515234e-10,
        )),
        _loops.Link((
            0.6145349462240683, -0.7888895992909156, 0.0, -0.00632184003488001, 0.7529522312460936,
            0.5865401944125223, 0.29838488198977153, 0.060080385216903724, -0.235392729987378,
            -0.18336793740765922, 0.9544456308244855, -0.058790946321855296,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.3650862620143206, -0.7314004443085399, -0.21332512958999084,
            0.647723536048123, -0.13871905921788164, -0.6218145946061981, -0.18136259009347447,
            -0.7618754628213957, -0.038185682994733766,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.4251437423456807, 0.6655569082924576,
            0.633863722183293, 0.3940187603707805, 0.13757420646323018, -0.2853239299236686,
            -0.27173707611777964, 0.9191023971657748, -0.0607588648632754,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, -0.629023083470561, 0.8952109992393914,
            0.3069294854535056, 0.323096824187513, 0.0047942638808703055, -0.305632130988188,
            -0.10478815919595016, 0.9463659134816423, -0.0016367997061155746,
        )),
        _loops.Link((
            0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, 0.29254598344443916,
        )),
        _loops.Link((
            1.0, 0.0, 0.0, -0.357, 0.0, -0.7427737668732654, 0.6695424790443845,
            -0.018486934316693265, 0.0, -0.6695424790443845, -0.7427737668732654,
            0.020508944943937776,
        )),
    ),
    advances=(
        (0.6, 0.8),
        (0.38461538461538464, 0.9230769230769231),
        (1.0, 0.0),
        (0.28, 0.96),
        (0.6896551724137931, 0.7241379310344828),
        (0.32432432432432434, 0.9459459459459459),
    ),
    formulations=(
        _loops.Formulation(joints=(3, 2, 1, 0, 5, 4), sign=-1.0),
        _loops.Formulation(joints=(4, 3, 2, 1, 0, 5), sign=-1.0),
    ),
    slides=(2,),
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
