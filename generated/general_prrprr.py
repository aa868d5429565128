# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 9a144b007677e152
"""general_prrprr: General arm with slides as joints 1 and 4.

Inverse kinematics, generated from robots/general_prrprr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/general_prrprr.yaml. The formulas and where they come from:
general_prrprr.md.

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

NAME = "general_prrprr"
METHOD = "general 4R2P"
DOF = 6
JOINT_TYPES = "PRRPRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (0.0, 1.2), (-math.inf, math.inf), (-math.inf, math.inf), (-0.4, 0.4), (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = ("root1", "root2", "root3", "root4", "root5", "root6", "root7", "root8")
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, sat1 = 0.29552020666133955, a2 = 0.18 [m], a1 = 0.1 [m], d2 = 0.25 [m],
# sa2 = 0.7833269096274834, ca2 = 0.6216099682706644, d3 = 0.11 [m], d5 = -0.16 [m], d6 = 0.19 [m].
cat1 = 0.955336489125606  # cosine of the angle of joint 1
ca1 = 0.9800665778412416  # cosine of twist 1
sa1 = 0.19866933079506122  # sine of twist 1
a3 = 0.32  # link length 3 [m]
ca3 = 0.26749882862458735  # cosine of twist 3
sa3 = 0.963558185417193  # sine of twist 3
cat4 = 0.5403023058681398  # cosine of the angle of joint 4
sat4 = 0.8414709848078965  # sine of the angle of joint 4
a4 = 0.13  # link length 4 [m]
ca4 = 0.8775825618903728  # cosine of twist 4
sa4 = 0.479425538604203  # sine of twist 4
a5 = 0.21  # link length 5 [m]
ca5 = 0.029199522301288937  # cosine of twist 5
sa5 = 0.9995736030415051  # sine of twist 5
a6 = 0.1  # link length 6 [m]
ca6 = 0.7648421872844885  # cosine of twist 6
sa6 = 0.644217687237691  # sine of twist 6
f1 = 0.28962947762551555  # sat1 * ca1
f2 = 0.05871080169382652  # sat1 * sa1
f3 = 0.052133305972592796  # a2 * sat1 * ca1 [m]
f4 = 0.010567944304888773  # a2 * sat1 * sa1 [m]
f5 = 0.32983280059673464  # a1 + a2 * cat1 + sat1 * d2 * sa2 [m]
f6 = 0.1833559467502831  # d2 * sa2 * cat1 * ca1 [m]
f7 = 0.03716809047647615  # d2 * sa2 * cat1 * sa1 [m]
f8 = 0.030873709102968033  # sa1 * d2 * ca2 [m]
f9 = 0.1523047885887582  # d2 * ca2 * ca1 [m]
f10 = 0.18369830628609546  # sat1 * ca2
f11 = 0.42638625510015216  # ca2 * cat1 * ca1 - sa1 * sa2
f12 = 0.8856916470924222  # ca2 * cat1 * sa1 + sa2 * ca1
f13 = 0.10599140039589122  # d3 * sa3 [m]
f14 = 0.006811531943972054  # d3 * ca3 * sat1 * sa2 [m]
f15 = 0.02521472007885299  # (sa2 * cat1 * ca1 + sa1 * ca2) * d3 * ca3 [m]
f16 = 0.013551530025764803  # d3 * ca3 * (ca2 * ca1 - sa2 * cat1 * sa1) [m]
f17 = 0.2230530535435802  # sa3 * sat1 * sa2
f18 = 0.8256909538260336  # (sa2 * cat1 * ca1 + sa1 * ca2) * sa3
f19 = 0.44376363163199056  # sa3 * (ca2 * ca1 - sa2 * cat1 * sa1)
f20 = 0.06192301767247322  # ca3 * sat1 * sa2
f21 = 0.22922472798957264  # (sa2 * cat1 * ca1 + sa1 * ca2) * ca3
f22 = 0.12319572750695275  # ca3 * (ca2 * ca1 - sa2 * cat1 * sa1)
f23 = 0.7384602626041288  # sat4 * ca4
f24 = 0.4034226801113349  # sat4 * sa4
f25 = 0.4741598817790379  # cat4 * ca4
f26 = 0.2590347239999257  # cat4 * sa4
f27 = -0.1599317764866408  # d5 * sa5 [m]
f28 = -0.00467192356820623  # d5 * ca5 [m]
f29 = 0.1224013605751613  # d6 * sa6 [m]
f30 = 0.1453200155840528  # d6 * ca6 [m]
g13 = 0.23148893021650235  # sat1 * sa2
g14 = 0.8569186234130046  # sa2 * cat1 * ca1 + sa1 * ca2
g15 = 0.4605467924491282  # ca2 * ca1 - sa2 * cat1 * sa1
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=8, size=1.75, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0, turns=False, lowest=0.0, highest=1.2),
        _joints.Joint(place=1),
        _joints.Joint(place=2),
        _joints.Joint(place=3, turns=False, lowest=-0.4, highest=0.4),
        _joints.Joint(place=4),
        _joints.Joint(place=5),
    ),
    base=(
        0.955336489125606, -0.29552020666133955, 0.0, 0.1, 0.28962947762551555, 0.9362933635841992,
        -0.19866933079506122, 0.0, 0.05871080169382652, 0.18979606097868743, 0.9800665778412416,
        0.0,
    ),
    chain=(
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.18, 0.0, 0.6216099682706644, -0.7833269096274834,
                -0.19583172740687085, 0.0, 0.7833269096274834, 0.6216099682706644,
                0.1554024920676661,
            ),
            turns=False,
        ),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.32, 0.0, 0.26749882862458735, 0.963558185417193, 0.10599140039589122,
            0.0, -0.963558185417193, 0.26749882862458735, 0.02942487114870461,
        )),
        _joints.ChainJoint((
            0.5403023058681398, -0.8414709848078965, 0.0, 0.13, 0.7384602626041288,
            0.4741598817790379, -0.479425538604203, 0.0, 0.4034226801113349, 0.2590347239999257,
            0.8775825618903728, 0.0,
        )),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.21, 0.0, -0.029199522301288937, -0.9995736030415051,
                0.1599317764866408, 0.0, 0.9995736030415051, -0.029199522301288937,
                0.00467192356820623,
            ),
            turns=False,
        ),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.1, 0.0, 0.7648421872844885, 0.644217687237691, 0.1224013605751613, 0.0,
            -0.644217687237691, 0.7648421872844885, 0.1453200155840528,
        )),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.5714, 0.5714, 0.5714, 1.0, 1.0, 1.0), size=1.75,
    slacks=(1.75e-09, 1e-09, 1e-09, 1.75e-09, 1e-09, 1e-09),
    weights=(0.32653061224489793, 1.0, 1.0, 0.32653061224489793, 1.0, 1.0),
    paces=(1.75, 1.0, 1.0, 1.75, 1.0, 1.0), clamped_again=1e-10, steps=("clamps",),
))

# The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.3, 0.0, 0.1, 0.2),
    (0.0, 0.25, 0.18, 0.9),
    (0.0, 0.11, 0.32, -1.3),
    (1.0, 0.0, 0.13, 0.5),
    (0.0, -0.16, 0.21, 1.6),
    (0.0, 0.19, 0.1, -0.7),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="modified",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, x2_z = cat1 * c2 - f10 * s2, f1 * c2 + f11 * s2, f2 * c2 + f12 * s2
    v1, y2_y, y2_z = f10 * c2 + cat1 * s2, f11 * c2 - f1 * s2, f12 * c2 - f2 * s2
    v2, v3, v4 = v1 * ca3 + f17, y2_y * ca3 + f18, y2_z * ca3 - f19
    z3_x, z3_y, z3_z = f20 - v1 * sa3, y2_y * sa3 - f21, y2_z * sa3 + f22
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v2 * s3, x2_y * c3 + v3 * s3, x2_z * c3 + v4 * s3
    v5, y3_y, y3_z = v2 * c3 + x2_x * s3, v3 * c3 - x2_y * s3, v4 * c3 - x2_z * s3
    x4_x, x4_y = x3_x * cat4 - v5 * f23 + z3_x * f24, x3_y * cat4 + y3_y * f23 + z3_y * f24
    x4_z, y4_x = x3_z * cat4 + y3_z * f23 + z3_z * f24, z3_x * f26 - (x3_x * sat4 + v5 * f25)
    y4_y, y4_z = y3_y * f25 - x3_y * sat4 + z3_y * f26, y3_z * f25 - x3_z * sat4 + z3_z * f26
    z4_x, z4_y, z4_z = v5 * sa4 + z3_x * ca4, z3_y * ca4 - y3_y * sa4, z3_z * ca4 - y3_z * sa4
    v6, v7, v8 = z4_x * sa5 - y4_x * ca5, z4_y * sa5 - y4_y * ca5, z4_z * sa5 - y4_z * ca5
    v9, v10, v11 = y4_x * sa5 + z4_x * ca5, y4_y * sa5 + z4_y * ca5, y4_z * sa5 + z4_z * ca5
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + v6 * s5, x4_y * c5 + v7 * s5, x4_z * c5 + v8 * s5
    y5_x, y5_y, y5_z = v6 * c5 - x4_x * s5, v7 * c5 - x4_y * s5, v8 * c5 - x4_z * s5
    v12, v13, v14 = y5_x * ca6 + v9 * sa6, y5_y * ca6 + v10 * sa6, y5_z * ca6 + v11 * sa6
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + v12 * s6, v12 * c6 - x5_x * s6, y5_x * sa6 - v9 * ca6
    T[0, 3] = (
        f5 + x2_x * a3 - v1 * f13 + f14 + x3_x * a4 + z4_x * q[3] + x4_x * a5 - y4_x * f27 - z4_x *
        f28 + x5_x * a6 + y5_x * f29 - v9 * f30
    )
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + v13 * s6, v13 * c6 - x5_y * s6, y5_y * sa6 - v10 * ca6
    T[1, 3] = (
        f3 - sa1 * q[0] - f6 - f8 + x2_y * a3 + y2_y * f13 - f15 + x3_y * a4 + z4_y * q[3] + x4_y *
        a5 - y4_y * f27 - z4_y * f28 + x5_y * a6 + y5_y * f29 - v10 * f30
    )
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 + v14 * s6, v14 * c6 - x5_z * s6, y5_z * sa6 - v11 * ca6
    T[2, 3] = (
        ca1 * q[0] + f4 - f7 + f9 + x2_z * a3 + y2_z * f13 + f16 + x3_z * a4 + z4_z * q[3] + x4_z *
        a5 - y4_z * f27 - z4_z * f28 + x5_z * a6 + y5_z * f29 - v11 * f30
    )
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    p2_y, p2_z = f3 - sa1 * q[0] - f6 - f8, ca1 * q[0] + f4 - f7 + f9
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, x2_z = cat1 * c2 - f10 * s2, f1 * c2 + f11 * s2, f2 * c2 + f12 * s2
    v1, y2_y, y2_z = f10 * c2 + cat1 * s2, f11 * c2 - f1 * s2, f12 * c2 - f2 * s2
    p3_x, p3_y = f5 + x2_x * a3 - v1 * f13 + f14, p2_y + x2_y * a3 + y2_y * f13 - f15
    p3_z, v2, v3 = p2_z + x2_z * a3 + y2_z * f13 + f16, v1 * ca3 + f17, y2_y * ca3 + f18
    v4, z3_x, z3_y = y2_z * ca3 - f19, f20 - v1 * sa3, y2_y * sa3 - f21
    z3_z = y2_z * sa3 + f22
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v2 * s3, x2_y * c3 + v3 * s3, x2_z * c3 + v4 * s3
    v5, y3_y, y3_z = v2 * c3 + x2_x * s3, v3 * c3 - x2_y * s3, v4 * c3 - x2_z * s3
    x4_x, x4_y = x3_x * cat4 - v5 * f23 + z3_x * f24, x3_y * cat4 + y3_y * f23 + z3_y * f24
    x4_z, y4_x = x3_z * cat4 + y3_z * f23 + z3_z * f24, z3_x * f26 - (x3_x * sat4 + v5 * f25)
    y4_y, y4_z = y3_y * f25 - x3_y * sat4 + z3_y * f26, y3_z * f25 - x3_z * sat4 + z3_z * f26
    z4_x, z4_y, z4_z = v5 * sa4 + z3_x * ca4, z3_y * ca4 - y3_y * sa4, z3_z * ca4 - y3_z * sa4
    p5_x = p3_x + x3_x * a4 + z4_x * q[3] + x4_x * a5 - y4_x * f27 - z4_x * f28
    p5_y = p3_y + x3_y * a4 + z4_y * q[3] + x4_y * a5 - y4_y * f27 - z4_y * f28
    p5_z = p3_z + x3_z * a4 + z4_z * q[3] + x4_z * a5 - y4_z * f27 - z4_z * f28
    v6, v7, v8 = z4_x * sa5 - y4_x * ca5, z4_y * sa5 - y4_y * ca5, z4_z * sa5 - y4_z * ca5
    v9, v10, v11 = y4_x * sa5 + z4_x * ca5, y4_y * sa5 + z4_y * ca5, y4_z * sa5 + z4_z * ca5
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    y5_x, y5_y, y5_z = v6 * c5 - x4_x * s5, v7 * c5 - x4_y * s5, v8 * c5 - x4_z * s5
    p6_x = p5_x + (x4_x * c5 + v6 * s5) * a6 + y5_x * f29 - v9 * f30
    p6_y = p5_y + (x4_y * c5 + v7 * s5) * a6 + y5_y * f29 - v10 * f30
    p6_z, v12 = p5_z + (x4_z * c5 + v8 * s5) * a6 + y5_z * f29 - v11 * f30, p6_x - f5
    v13, v14, v15 = p6_y - p2_y, p6_z - p2_z, p6_x - p3_x
    v16, v17, v18 = p6_y - p3_y, p6_z - p3_z, p6_x - p5_x
    v19, v20 = p6_y - p5_y, p6_z - p5_z
    J[0, 1], J[0, 2], J[0, 3] = -(g14 * v14 + g15 * v13), z3_y * v17 - z3_z * v16, z4_x
    J[0, 4] = v11 * v19 - v10 * v20
    J[1, 0], J[1, 1], J[1, 2] = -sa1, g15 * v12 - g13 * v14, z3_z * v15 - z3_x * v17
    J[1, 3], J[1, 4] = z4_y, v9 * v20 - v11 * v18
    J[2, 0], J[2, 1], J[2, 2] = ca1, g13 * v13 + g14 * v12, z3_x * v16 - z3_y * v15
    J[2, 3], J[2, 4] = z4_z, v10 * v18 - v9 * v19
    J[3, 1], J[3, 2], J[3, 4] = g13, z3_x, -v9
    J[3, 5] = y5_x * sa6 - v9 * ca6
    J[4, 1], J[4, 2], J[4, 4] = -g14, z3_y, -v10
    J[4, 5] = y5_y * sa6 - v10 * ca6
    J[5, 1], J[5, 2], J[5, 4] = g15, z3_z, -v11
    J[5, 5] = y5_z * sa6 - v11 * ca6
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.5188865104263425, reach=math.inf,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.3468966650378003, 0.5737938168652287,
            0.23908075702717863, -0.7833269096274834, -0.24071198299688865, 0.7230709935022924,
            0.30127958062595517, 0.6216099682706644, 1.910172966735487e-10,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, 0.6167051822894228, 0.2360283781981653,
            0.12588180170568816, 0.963558185417193, 0.05060832613278151, -0.8501983988975231,
            -0.453439146078679, 0.26749882862458735, 0.18855617369548777,
        )),
        _loops.Link((
            0.5403023058681398, -0.8414709848078966, 0.0, 0.250536480305078, 0.7384602626041288,
            0.4741598817790379, -0.479425538604203, 0.032924257305286767, 0.4034226801113349,
            0.2590347239999257, 0.8775825618903728, 0.09920262232951157,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.4047127758774337, -0.021144481666450613,
            -0.02013760158709582, -0.9995736030415052, 0.08898300940260505, 0.723829160823159,
            0.6893611055458657, -0.02919952230128894, 0.07127376158977099,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, 0.19272036946544463, 0.7234993663501919,
            0.24805692560578008, 0.644217687237691, 0.10807014469215119, -0.6093951095491672,
            -0.20893546613114305, 0.7648421872844885, -0.0910262268897436,
        )),
        _loops.Link((
            0.955336489125606, 0.28962947762551555, 0.058710801693826524, -0.09553364891256061,
            -0.29552020666133955, 0.9362933635841992, 0.18979606097868743, 0.029552020666133955,
            0.0, -0.19866933079506122, 0.9800665778412416, -0.09911628477331971,
        )),
        _loops.Link((
            1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.10295467142321668,
        )),
    ),
    advances=(
        (1.0, 0.0),
        (0.38461538461538464, 0.9230769230769231),
        (0.47058823529411764, 0.8823529411764706),
        (1.0, 0.0),
        (0.6896551724137931, 0.7241379310344828),
        (0.32432432432432434, 0.9459459459459459),
    ),
    formulations=(
        _loops.Formulation(joints=(4, 5, 0, 1, 2, 3), sign=1.0),
        _loops.Formulation(joints=(5, 0, 1, 2, 3, 4), sign=1.0),
    ),
    slides=(0, 3),
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
