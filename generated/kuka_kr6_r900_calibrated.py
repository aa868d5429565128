"""kuka_kr6_r900_calibrated: KUKA KR 6 R900, calibrated.

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
_of_joints = _runtime("entry").of_joints(_HOW, 6)

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

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.399973  # joint offset 1 [m]
a2 = -0.024911  # link length 2 [m]
ca2 = 2.9999999981991003e-05  # cosine of twist 2
sa2 = 0.99999999955  # sine of twist 2
a3 = -0.38922960954671  # link length 3 [m]
ca3 = 0.9999999932995001  # cosine of twist 3
sa3 = 0.00011576268798709127  # sine of twist 3
a4 = -0.025036000000003  # link length 4 [m]
ca4 = 6.199999996034639e-05  # cosine of twist 4
sa4 = 0.999999998078  # sine of twist 4
a5 = 6.9999999993558e-05  # link length 5 [m]
ca5 = 9.299999986590045e-05  # cosine of twist 5
sa5 = 0.9999999956755  # sine of twist 5
a6 = -0.00012899999999461  # link length 6 [m]
ca6 = 4.599999998382906e-05  # cosine of twist 6
sa6 = 0.999999998942  # sine of twist 6
ex = 2.6999999541966e-05  # x of the tool frame [m]
ey = -4.9679981739493e-09  # y of the tool frame [m]
ez = 0.089873000000009  # z of the tool frame [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
offset2 = -2.1157052436021195  # offset of joint 2 [rad]
offset3 = -1.0259814129576739  # offset of joint 3 [rad]
offset4 = -3.1415816535897934  # offset of joint 4 [rad]
offset5 = 3.141458653589793  # offset of joint 5 [rad]
f1 = -0.2358967394524778  # ca3 * b3 - d3 * sa3 [m]
f2 = 4.899999966903515e-05  # d3 * ca3 + sa3 * b3 [m]
f3 = 1.4699999891886136e-09  # f2 * ca2 [m]
f4 = 3.4728806375279683e-09  # sa3 * ca2
f5 = 2.9999999780976003e-05  # ca3 * ca2
f6 = 0.4199969991926858  # d4 * sa4 [m]
f7 = 2.6039813983340643e-05  # d4 * ca4 [m]
f8 = -0.00018999922918564835  # d5 * sa5 [m]
f9 = -1.766992836520009e-08  # d5 * ca5 [m]
f10 = 0.9999999830720003  # 9999999830720003 / 10000000000000000
f11 = 0.00018399999896174938  # 9199999948087469 / 50000000000000000000
f12 = 0.00018399999890875743  # 18399999890875743 / 100000000000000000000
f13 = 0.9999999827840002  # 4999999913920001 / 5000000000000000
f14 = 2.3999999997695912e-05  # 2999999999711989 / 125000000000000000000
f15 = 4.4159999746063125e-09  # 70655999593701 / 16000000000000000000000
f16 = 2.3999999591423935e-05  # 4799999918284787 / 200000000000000000000
f17 = 0.999999999712  # 31249999991 / 31250000000
near_angle = 0.00038629455388293287  # the two arms' tools are turned by no more
near_length = 0.0005956666016234988  # and no farther apart [m]
near_a1 = -0.02490435840606673  # link length 1 [m]
near_longest3 = 0.7670856262406353  # square of the longest reach [m^2]
near_shortest3 = 0.0011825258020403124  # square of the shortest reach [m^2]
near_k3 = 0.3841340760213378  # near_a2^2 + (near_a3^2 + near_d4^2) [m^2]
near_turn1 = -1.6303690532815094  # a constant angle [rad]
near_m1 = 8.557009921367217e-09  # doubt_limit1^2 [m^2]
# 1000 * (near_longest3 - longest3_apart) * (longest3_apart - near_shortest3) [m^4]
near_m3 = 1.232968722271121e-11
near_m4 = 1.0986329373744648  # a coefficient of X1_2
near_m5 = 0.033088711096641035  # a coefficient of X1_2
near_m6 = 1.1863216740895242  # a coefficient of c23
near_m7 = 0.07075613880927151  # a coefficient of c23
near_m8 = 0.0021310388171766744  # a coefficient of c23
near_m9 = 0.03572972719663899  # a coefficient of c23
near_m10 = 9.999999999999999e-09  # doubt_limit^2
near1 = 0.0011913332032469975  # near_length + near_length [m]
near2 = 0.5  # 1 / 2
h1 = 0.0007909463375342454  # near3 + near_m7 * near1 [m]
h2 = 0.0014554514688229327  # near4 + near_m6 * near1 [m]
turn = 2.0 * math.pi  # [rad]
half_turn = 0.5 * turn

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16,
    size=1.585408653983645,
    coordinates=(0, 1, 2),
    directions='rotation',
    joints=(
        _joints.Joint(place=0, zero=3.141592653589793),
        _joints.Joint(place=1, zero=-2.1157052436021195),
        _joints.Joint(place=2, zero=-1.0259814129576739),
        _joints.Joint(place=3, zero=-3.1415816535897934),
        _joints.Joint(place=4, zero=3.141458653589793),
        _joints.Joint(place=5),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.399973),
    chain=(
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -0.024911, 0.0, 2.9999999981991003e-05, -0.99999999955, 0.0, 0.0,
                0.99999999955, 2.9999999981991003e-05, 0.0,
            ),
            offset=3.141592653589793,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -0.38922960954671, 0.0, 0.9999999932995001, -0.00011576268798709127,
                -0.2358967394524778, 0.0, 0.00011576268798709127, 0.9999999932995001,
                4.899999966903514e-05,
            ),
            offset=-2.1157052436021195,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -0.025036000000003, 0.0, -6.199999996034639e-05, -0.999999998078,
                -0.4199969991926858, 0.0, 0.999999998078, -6.199999996034639e-05,
                -2.6039813983340643e-05,
            ),
            offset=-1.0259814129576739,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 6.9999999993558e-05, 0.0, 9.299999986590045e-05, -0.9999999956755,
                0.00018999922918564835, 0.0, 0.9999999956755, 9.299999986590045e-05,
                -1.766992836520009e-08,
            ),
            offset=-3.1415816535897934,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -0.00012899999999461, 0.0, 4.599999998382906e-05, -0.999999998942,
                0.0, 0.0, 0.999999998942, 4.599999998382906e-05, 0.0,
            ),
            offset=3.141458653589793,
        ),
        _joints.ChainJoint((
            0.9999999830720003, 0.00018399999890875743, 4.4159999746063125e-09, 2.6999999541966e-05,
            -0.00018399999896174938, 0.9999999827840002, 2.3999999591423935e-05,
            -4.9679981739493e-09, 0.0, -2.3999999997695912e-05, 0.999999999712, 0.089873000000009,
        )),
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
        miss_weights=(0.6308, 0.6308, 0.6308, 1.0, 1.0, 1.0),
        size=1.585408653983645,
        clamped=1e-14,
        clamped_again=1e-10,
    ),
)


# The axes at q = 0: a unit vector along each, and a point of it [m].
AXES = (
    (0.0, 0.0, 1.0, 0.0, 0.0, 0.0),
    (0.0, 0.99999999955, 2.999999998203572e-05, 0.024911, 0.0, 0.399973),
    (9.899729955984851e-05, 0.9999999910493664, 9.000445467075194e-05, 0.02489051897001, -1.365401998e-05, 0.85510699933437),
    (-9.40120771922738e-05, -0.00015199514761225376, 0.9999999840296021, -0.00014547594582, 3.782468778e-05, 0.85510465043496),
    (8.798272759438208e-05, 0.9999999661161818, 0.00024500341767975844, -0.00025496073555, -2.600588783e-05, 1.27510163714764),
    (-0.00022801621018996365, -0.00019898335173072366, 0.9999999542071157, -0.00038397744841, -0.00021599452442, 1.27510156118516),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES,
    table=AXES,
    convention="axes",
    tool=(
        0.9999999370141494, 0.00027199868072050787, -0.00022800968228729382, -0.00037746995097,
        -0.0002720385815250037, 0.9999999476879168, -0.00017498335303891297, -0.00023388510023,
        0.00022796207511845772, 0.000175045369447981, 0.9999999586962047, 1.3649745632246,
    ),
)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    T = np.zeros((4, 4))
    v1 = q[0] + offset1
    c1 = math.cos(v1)
    s1 = math.sin(v1)
    v2 = s1 * ca2
    v3 = c1 * ca2
    z2_x = s1 * sa2
    v4 = c1 * sa2
    v5 = q[1] + offset2
    c2 = math.cos(v5)
    s2 = math.sin(v5)
    x2_x = c1 * c2 - v2 * s2
    x2_y = s1 * c2 + v3 * s2
    x2_z = sa2 * s2
    v6 = v2 * c2 + c1 * s2
    y2_y = v3 * c2 - s1 * s2
    y2_z = sa2 * c2
    v7 = z2_x * sa3 - v6 * ca3
    v8 = y2_y * ca3 - v4 * sa3
    v9 = y2_z * ca3 + f4
    z3_x = v6 * sa3 + z2_x * ca3
    v10 = y2_y * sa3 + v4 * ca3
    z3_z = f5 - y2_z * sa3
    v11 = q[2] + offset3
    c3 = math.cos(v11)
    s3 = math.sin(v11)
    x3_x = x2_x * c3 + v7 * s3
    x3_y = x2_y * c3 + v8 * s3
    x3_z = x2_z * c3 + v9 * s3
    y3_x = v7 * c3 - x2_x * s3
    y3_y = v8 * c3 - x2_y * s3
    y3_z = v9 * c3 - x2_z * s3
    v12 = z3_x * sa4 - y3_x * ca4
    v13 = y3_y * ca4 + v10 * sa4
    v14 = z3_z * sa4 - y3_z * ca4
    v15 = y3_x * sa4 + z3_x * ca4
    z4_y = v10 * ca4 - y3_y * sa4
    v16 = y3_z * sa4 + z3_z * ca4
    v17 = q[3] + offset4
    c4 = math.cos(v17)
    s4 = math.sin(v17)
    x4_x = x3_x * c4 + v12 * s4
    x4_y = x3_y * c4 - v13 * s4
    x4_z = x3_z * c4 + v14 * s4
    y4_x = v12 * c4 - x3_x * s4
    v18 = v13 * c4 + x3_y * s4
    y4_z = v14 * c4 - x3_z * s4
    v19 = y4_x * ca5 - v15 * sa5
    v20 = z4_y * sa5 - v18 * ca5
    v21 = y4_z * ca5 - v16 * sa5
    v22 = y4_x * sa5 + v15 * ca5
    z5_y = v18 * sa5 + z4_y * ca5
    v23 = y4_z * sa5 + v16 * ca5
    v24 = q[4] + offset5
    c5 = math.cos(v24)
    s5 = math.sin(v24)
    x5_x = x4_x * c5 + v19 * s5
    x5_y = x4_y * c5 + v20 * s5
    x5_z = x4_z * c5 + v21 * s5
    y5_x = v19 * c5 - x4_x * s5
    y5_y = v20 * c5 - x4_y * s5
    y5_z = v21 * c5 - x4_z * s5
    v25 = y5_x * ca6 - v22 * sa6
    v26 = y5_y * ca6 + z5_y * sa6
    v27 = y5_z * ca6 - v23 * sa6
    v28 = y5_x * sa6 + v22 * ca6
    z6_y = z5_y * ca6 - y5_y * sa6
    v29 = y5_z * sa6 + v23 * ca6
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    x6_x = x5_x * c6 + v25 * s6
    x6_y = x5_y * c6 + v26 * s6
    x6_z = x5_z * c6 + v27 * s6
    y6_x = v25 * c6 - x5_x * s6
    y6_y = v26 * c6 - x5_y * s6
    y6_z = v27 * c6 - x5_z * s6
    T[0, 0] = x6_x * f10 - y6_x * f11
    T[0, 1] = x6_x * f12 + y6_x * f13 + v28 * f14
    T[0, 2] = x6_x * f15 + y6_x * f16 - v28 * f17
    T[0, 3] = c1 * a2 + x2_x * a3 - v6 * f1 + z2_x * f2 + x3_x * a4 - y3_x * f6 - z3_x * f7 + x4_x * a5 - y4_x * f8 - v15 * f9 + x5_x * a6 + x6_x * ex + y6_x * ey - v28 * ez
    T[1, 0] = x6_y * f10 - y6_y * f11
    T[1, 1] = x6_y * f12 + y6_y * f13 - z6_y * f14
    T[1, 2] = x6_y * f15 + y6_y * f16 + z6_y * f17
    T[1, 3] = s1 * a2 + x2_y * a3 + y2_y * f1 - v4 * f2 + x3_y * a4 - y3_y * f6 + v10 * f7 + x4_y * a5 + v18 * f8 + z4_y * f9 + x5_y * a6 + x6_y * ex + y6_y * ey + z6_y * ez
    T[2, 0] = x6_z * f10 - y6_z * f11
    T[2, 1] = x6_z * f12 + y6_z * f13 + v29 * f14
    T[2, 2] = x6_z * f15 + y6_z * f16 - v29 * f17
    T[2, 3] = d1 + x2_z * a3 + y2_z * f1 + f3 + x3_z * a4 - y3_z * f6 - z3_z * f7 + x4_z * a5 - y4_z * f8 - v16 * f9 + x5_z * a6 + x6_z * ex + y6_z * ey - v29 * ez
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    J = np.zeros((6, 6))
    v1 = q[0] + offset1
    c1 = math.cos(v1)
    s1 = math.sin(v1)
    p2_x = c1 * a2
    p2_y = s1 * a2
    v2 = s1 * ca2
    v3 = c1 * ca2
    z2_x = s1 * sa2
    v4 = c1 * sa2
    v5 = q[1] + offset2
    c2 = math.cos(v5)
    s2 = math.sin(v5)
    x2_x = c1 * c2 - v2 * s2
    x2_y = s1 * c2 + v3 * s2
    x2_z = sa2 * s2
    v6 = v2 * c2 + c1 * s2
    y2_y = v3 * c2 - s1 * s2
    y2_z = sa2 * c2
    p3_x = p2_x + x2_x * a3 - v6 * f1 + z2_x * f2
    p3_y = p2_y + x2_y * a3 + y2_y * f1 - v4 * f2
    p3_z = d1 + x2_z * a3 + y2_z * f1 + f3
    v7 = z2_x * sa3 - v6 * ca3
    v8 = y2_y * ca3 - v4 * sa3
    v9 = y2_z * ca3 + f4
    z3_x = v6 * sa3 + z2_x * ca3
    v10 = y2_y * sa3 + v4 * ca3
    z3_z = f5 - y2_z * sa3
    v11 = q[2] + offset3
    c3 = math.cos(v11)
    s3 = math.sin(v11)
    x3_x = x2_x * c3 + v7 * s3
    x3_y = x2_y * c3 + v8 * s3
    x3_z = x2_z * c3 + v9 * s3
    y3_x = v7 * c3 - x2_x * s3
    y3_y = v8 * c3 - x2_y * s3
    y3_z = v9 * c3 - x2_z * s3
    p4_x = p3_x + x3_x * a4 - y3_x * f6 - z3_x * f7
    p4_y = p3_y + x3_y * a4 - y3_y * f6 + v10 * f7
    p4_z = p3_z + x3_z * a4 - y3_z * f6 - z3_z * f7
    v12 = z3_x * sa4 - y3_x * ca4
    v13 = y3_y * ca4 + v10 * sa4
    v14 = z3_z * sa4 - y3_z * ca4
    v15 = y3_x * sa4 + z3_x * ca4
    z4_y = v10 * ca4 - y3_y * sa4
    v16 = y3_z * sa4 + z3_z * ca4
    v17 = q[3] + offset4
    c4 = math.cos(v17)
    s4 = math.sin(v17)
    x4_x = x3_x * c4 + v12 * s4
    x4_y = x3_y * c4 - v13 * s4
    x4_z = x3_z * c4 + v14 * s4
    y4_x = v12 * c4 - x3_x * s4
    v18 = v13 * c4 + x3_y * s4
    y4_z = v14 * c4 - x3_z * s4
    p5_x = p4_x + x4_x * a5 - y4_x * f8 - v15 * f9
    p5_y = p4_y + x4_y * a5 + v18 * f8 + z4_y * f9
    p5_z = p4_z + x4_z * a5 - y4_z * f8 - v16 * f9
    v19 = y4_x * ca5 - v15 * sa5
    v20 = z4_y * sa5 - v18 * ca5
    v21 = y4_z * ca5 - v16 * sa5
    v22 = y4_x * sa5 + v15 * ca5
    z5_y = v18 * sa5 + z4_y * ca5
    v23 = y4_z * sa5 + v16 * ca5
    v24 = q[4] + offset5
    c5 = math.cos(v24)
    s5 = math.sin(v24)
    x5_x = x4_x * c5 + v19 * s5
    x5_y = x4_y * c5 + v20 * s5
    x5_z = x4_z * c5 + v21 * s5
    y5_x = v19 * c5 - x4_x * s5
    y5_y = v20 * c5 - x4_y * s5
    y5_z = v21 * c5 - x4_z * s5
    p6_x = p5_x + x5_x * a6
    p6_y = p5_y + x5_y * a6
    p6_z = p5_z + x5_z * a6
    v25 = y5_x * ca6 - v22 * sa6
    v26 = y5_y * ca6 + z5_y * sa6
    v27 = y5_z * ca6 - v23 * sa6
    v28 = y5_x * sa6 + v22 * ca6
    z6_y = z5_y * ca6 - y5_y * sa6
    v29 = y5_z * sa6 + v23 * ca6
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    J21 = p6_x + (x5_x * c6 + v25 * s6) * ex + (v25 * c6 - x5_x * s6) * ey - v28 * ez
    v30 = p6_y + (x5_y * c6 + v26 * s6) * ex + (v26 * c6 - x5_y * s6) * ey + z6_y * ez
    v31 = p6_z + (x5_z * c6 + v27 * s6) * ex + (v27 * c6 - x5_z * s6) * ey - v29 * ez
    v32 = v31 - d1
    v33 = J21 - p2_x
    v34 = v30 - p2_y
    v35 = J21 - p3_x
    v36 = v30 - p3_y
    v37 = v31 - p3_z
    v38 = J21 - p4_x
    v39 = v30 - p4_y
    v40 = v31 - p4_z
    v41 = J21 - p5_x
    v42 = v30 - p5_y
    v43 = v31 - p5_z
    v44 = J21 - p6_x
    v45 = v30 - p6_y
    v46 = v31 - p6_z
    J[0, 0] = -v30
    J[0, 1] = -(v4 * v32 + ca2 * v34)
    J[0, 2] = -(v10 * v37 + z3_z * v36)
    J[0, 3] = z4_y * v40 + v16 * v39
    J[0, 4] = z5_y * v43 + v23 * v42
    J[0, 5] = z6_y * v46 + v29 * v45
    J[1, 0] = J21
    J[1, 1] = ca2 * v33 - z2_x * v32
    J[1, 2] = z3_z * v35 - z3_x * v37
    J[1, 3] = v15 * v40 - v16 * v38
    J[1, 4] = v22 * v43 - v23 * v41
    J[1, 5] = v28 * v46 - v29 * v44
    J[2, 1] = z2_x * v34 + v4 * v33
    J[2, 2] = z3_x * v36 + v10 * v35
    J[2, 3] = -(v15 * v39 + z4_y * v38)
    J[2, 4] = -(v22 * v42 + z5_y * v41)
    J[2, 5] = -(v28 * v45 + z6_y * v44)
    J[3, 1] = z2_x
    J[3, 2] = z3_x
    J[3, 3] = -v15
    J[3, 4] = -v22
    J[3, 5] = -v28
    J[4, 1] = -v4
    J[4, 2] = -v10
    J[4, 3] = z4_y
    J[4, 4] = z5_y
    J[4, 5] = z6_y
    J[5, 0] = 1.0
    J[5, 1] = ca2
    J[5, 2] = z3_z
    J[5, 3] = -v16
    J[5, 4] = -v23
    J[5, 5] = -v29
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.4508418874566562,
    reach=4.000000004,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, -0.05525440446656575,
            2.7692307675684008e-05, 1.1538461531535004e-05, -0.9999999995500001,
            -6.41174760047529e-06, 0.9230769226615386, 0.38461538444230775, 2.9999999981991006e-05,
            1.9235245234071069e-19,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, -0.8633394996691172, 0.8823529352642647,
            0.4705882321409412, -0.00011576268798709127, -0.5232360634903338,
            0.00010214354822390406, 5.447655905274883e-05, 0.9999999932995001,
            6.411747604001751e-06,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, -0.055531663531175224, -5.9519999961932536e-05,
            -1.735999998889699e-05, -0.999999998078, -0.4657918929277785, 0.9599999981548799,
            0.27999999946184, -6.199999996034639e-05, 6.698296062660318e-05,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.00015526507616328748,
            6.734482748910032e-05, 6.413793094200031e-05, -0.9999999956755, 0.00023237535777633262,
            0.7241379279029483, 0.6896551694313794, 9.299999986590045e-05, 0.465791887413791,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, -0.00028613135465814944,
            4.3513513498216673e-05, 1.4918918913674289e-05, -0.999999998942, -8.696608708753215e-09,
            0.9459459449451351, 0.3243243239811892, 4.599999998382906e-05, -0.00018905671111534863,
        )),
        _loops.Link((
            0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.39997300008672054,
        )),
        _loops.Link((
            0.9999999830720001, -0.00018399999896174932, 5.1722776507432096e-20,
            -2.6999999999021673e-05, 0.00018399999890875734, 0.9999999827840002,
            -2.3999999997695935e-05, 2.156951903896213e-06, 4.4159999746063125e-09,
            2.3999999591423935e-05, 0.999999999712, -0.08987299605333009,
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
        _loops.Formulation(joints=(3, 2, 1, 0, 5, 4), sign=-1.0),
    ),
)
_NUMBERS = _loops.general_numbers(_LINKS, _LOOP)
_all_joints = _runtime("general.rows").all_joints
_nearest, _COMPILED = _runtime("general.near"), _runtime("jit").COMPILED
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
        v45 = v2 * v44
        Y4 = w1 * v45
        v46 = Y4 * Y4
        v47 = v46 + c4_pp * c4_pp
        v48 = v46 + c4_pm * c4_pm
        v49 = v46 + c4_mp * c4_mp
        v50 = v46 + c4_mm * c4_mm
        v51 = math.copysign(half_turn, Y4)
        v52 = math.copysign(half_turn, -Y4)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v53 = w1 * (v2 * (T14 * T22 - T24 * T12))
        v54 = w1 * (v2 * (T14 * T12 + T24 * T22))
        v55 = w1 * (v2 * (T14 * T21 - T24 * T11))
        v56 = w1 * (v2 * (T14 * T11 + T24 * T21))
        v57 = c4_pp * v55 + Y4 * (s23_pp * T31 + c23_pp * v56)
        v58 = c4_pm * v55 + Y4 * (s23_pm * T31 + c23_pm * v56)

        # joint values
        v59 = abs(T14)
        v60 = abs(T24)
        v61 = near_length * (near_length + 2.0 * v59) + near_length * (near_length + 2.0 * v60)
        v62 = abs(v1)
        v63 = abs(T34)
        v64 = near_length * (near_length + 2.0 * v63)
        v65 = abs(w1)
        v66 = abs(Z2_3_p)
        v67 = abs(v3)
        v68 = v64 + near1 * (near1 + 2.0 * v66)
        v69 = v64 + near1 * (near1 + 2.0 * v67)
        v70 = abs(v5)
        v71 = abs(v6)
        v72 = abs(v7)
        v73 = abs(v8)
        v74 = abs(N3_p)
        v75 = abs(N3_m)
        v76 = abs(v2)
        v77 = v61 * v76 / (v62 - v61)
        v78 = near_angle * v60
        v79 = near_length * (near_angle + abs(T13))
        v80 = near_angle * v59
        v81 = near_length * (near_angle + abs(T23))
        v82 = v78 + v79 + (v80 + v81)
        v83 = v76 * v82 + v77 * (v82 + abs(v44))
        v84 = v65 * v83 + near1 * (v83 + abs(v45))
        v85 = v84 * (v84 + 2.0 * abs(Y4))
        v86 = abs(factor2_p)
        v87 = abs(factor2_m)
        v88 = v68 * v86 / (v74 - v68)
        v89 = v69 * v87 / (v75 - v69)
        v90 = near_m9 * v88
        v91 = near_m9 * v89
        v92 = near_m8 * v88
        v93 = near_m8 * v89
        v94 = v92 + abs(v22)
        v95 = v93 + abs(v23)
        v96 = v67 * v91 + near1 * (v91 + abs(-v25)) + (v63 * v93 + near_length * v95)
        v97 = (v68 * v70 + v68 * (v68 + v72)) / D3_p
        v98 = (v69 * v71 + v69 * (v69 + v73)) / D3_m
        v99 = v97 * (1.0 + v97) * (near2 * w3_p)
        v100 = v98 * (1.0 + v98) * (near2 * w3_m)
        v101 = v86 * h1 + v88 * (h1 + abs(v33))
        v102 = v87 * h1 + v89 * (h1 + abs(v34))
        v103 = abs(w3_p)
        v104 = abs(w3_m)
        v105 = near_angle + abs(T33)
        v106 = v66 * v92 + near1 * v94 + (v63 * v90 + near_length * (v90 + abs(v24)))
        v107 = v86 * h2 + v88 * (h2 + abs(v20))
        v108 = v87 * h2 + v89 * (h2 + abs(v21))
        v109 = v79 + v80 + (v78 + v81)
        v110 = v76 * v109 + v77 * (v109 + abs(v41))
        v111 = v65 * v110 + near1 * (v110 + abs(v42))
        v112 = v111 + abs(v43)
        v113 = (
            v105 * (v66 * v90 + near1 * (v90 + abs(-v24)) + (v63 * v92 + near_length * v94) + (v101
            * v103 + v99 * (v101 + abs(v37))))
        )
        v114 = v103 * v107
        v115 = (
            near_angle * abs(s23_pp) + v113 + (v111 * abs(c23_pp) + v112 * (v106 + (v114 + v99 *
            (v107 + abs(v28)))))
        )
        v116 = (
            v113 + near_angle * abs(s23_pm) + (v111 * abs(c23_pm) + v112 * (v106 + (v114 + v99 *
            (v107 + abs(v29)))))
        )
        v117 = v102 * v104
        v118 = (
            v112 * (v67 * v93 + near1 * v95 + (v63 * v91 + near_length * (v91 + abs(v25))) + (v104 *
            v108 + v100 * (v108 + abs(v30))))
        )
        v119 = (
            near_angle * abs(s23_mp) + v105 * (v96 + (v117 + v100 * (v102 + abs(v38)))) + (v111 *
            abs(c23_mp) + v118)
        )
        v120 = (
            near_angle * abs(s23_mm) + v105 * (v96 + (v117 + v100 * (v102 + abs(v39)))) + (v118 +
            v111 * abs(c23_mm))
        )

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v71 <= v69 or abs(D3_m) <= near_m3 or v70 <= v68 or abs(D3_p) <= near_m3 or v73
            <= v69 or v72 <= v68 or abs(v50) <= v85 + v120 * (v120 + 2.0 * abs(c4_mm)) or v50 <=
            near_m10 or abs(v49) <= v85 + v119 * (v119 + 2.0 * abs(c4_mp)) or v49 <= near_m10 or
            abs(v48) <= v85 + v116 * (v116 + 2.0 * abs(c4_pm)) or v48 <= near_m10 or abs(v47) <= v85
            + v115 * (v115 + 2.0 * abs(c4_pp)) or v47 <= near_m10 or v75 <= v69 or v1 <= near_m1 or
            v62 <= v61 or v74 <= v68 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = w3_p, w3_m, c23_mp
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = c23_mm, s23_mp, s23_mm
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = c4_mp, c4_mm, Y4
        kept[26 * w + k], kept[27 * w + k], kept[28 * w + k], kept[29 * w + k] = v51, v52, v55, v56
        kept[30 * w + k], kept[31 * w + k], turns[0 * w + k], turns[1 * w + k] = v57, v58, T24, w3_p
        turns[2 * w + k], turns[3 * w + k] = w3_m, v11 - w3_p * (near_m4 * Z2_3_p)
        turns[4 * w + k], turns[5 * w + k] = v11 - w3_p * (near_m4 * -Z2_3_p), v12 + v17
        turns[6 * w + k], turns[7 * w + k], turns[8 * w + k] = v12 - v17, Y4, Y4
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = -Y4, -Y4, math.sqrt(v47)
        turns[12 * w + k], turns[13 * w + k] = math.sqrt(v48), math.sqrt(v49)
        turns[14 * w + k], turns[15 * w + k], turns[16 * w + k] = math.sqrt(v50), v57, v58
        turns[17 * w + k] = -(c4_mp * v55 + Y4 * (s23_mp * T31 - c23_mp * v56))
        turns[18 * w + k] = -(c4_mm * v55 + Y4 * (s23_mm * T31 - c23_mm * v56))
        turns[24 * w + k], turns[25 * w + k] = T14, N3_p - near_k3
        turns[26 * w + k], turns[27 * w + k] = N3_m - near_k3, v13 + v16
        turns[28 * w + k], turns[29 * w + k], turns[30 * w + k] = v13 - v16, v18 - v14, -(v14 + v18)
        turns[31 * w + k], turns[32 * w + k], turns[33 * w + k] = c4_pp, c4_pm, c4_mp
        turns[34 * w + k], turns[35 * w + k] = c4_mm, c23_pp * T33 - s23_pp * v43
        turns[36 * w + k] = c23_pm * T33 - s23_pm * v43
        turns[37 * w + k] = c23_mp * T33 + s23_mp * v43
        turns[38 * w + k] = c23_mm * T33 + s23_mm * v43
        turns[39 * w + k] = c4_pp * v53 + Y4 * (s23_pp * T32 + c23_pp * v54)
        turns[40 * w + k] = c4_pm * v53 + Y4 * (s23_pm * T32 + c23_pm * v54)
        turns[41 * w + k] = -(c4_mp * v53 + Y4 * (s23_mp * T32 - c23_mp * v54))
        turns[42 * w + k] = -(c4_mm * v53 + Y4 * (s23_mm * T32 - c23_mm * v54))
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
        Y4, v51, v52, v55 = kept[25 * w + k], kept[26 * w + k], kept[27 * w + k], kept[28 * w + k]
        v56, v57, v58 = kept[29 * w + k], kept[30 * w + k], kept[31 * w + k]
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
        q4_ppm = angle8 - v51
        q4_pmm = angle9 - v51
        q4_mpm = angle10 - v52
        q4_mmm = angle11 - v52

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle16 - math.copysign(half_turn, v57)
        q6_pmm = angle17 - math.copysign(half_turn, v58)
        q6_mpm = (
            angle18 - math.copysign(half_turn, -(c4_mp * v55 + Y4 * (s23_mp * T31 - c23_mp * v56)))
        )
        q6_mmm = (
            angle19 - math.copysign(half_turn, -(c4_mm * v55 + Y4 * (s23_mm * T31 - c23_mm * v56)))
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

# What makes of a pose this arm's, before and behind it, and what its angles are more.
_LEFT, _RIGHT = np.array((0.9999999999918531, -3.476199999090458e-06, 2.0518553472019946e-06, 8.012948348171926e-06, 3.4762326676678125e-06, 0.9999999998672079, -1.5921692866943705e-05, 1.0315399224557022e-05, -2.051799999940795e-06, 1.5921699999540576e-05, 0.9999999998711449, -0.3999492120037384)), np.array((0.9999999837056532, -0.0001805026000012168, -2.7394549473610155e-06, -2.5780483198822104e-05, 0.00018050259021021845, 0.999999983703021, -3.57389453691181e-06, -4.246671387497745e-05, 2.7400999999722193e-06, 3.5733999999637707e-06, 0.9999999999898614, -0.0898696651233072))
_OFFSETS = np.array((0.0, -2.5967434078241616, 2.596736097794161, 5.3526e-06, -9.5436e-06, 0.0))


@_HOW.merged
def _nearby(pose):
    """Joint values near which all solutions are, one near each; none where that is not certain."""
    kept, turns, rows = np.zeros(32), np.zeros(48), np.zeros(42)
    _nearest.near_pose(pose, _LEFT, _RIGHT, kept)
    _formulas(kept, turns, rows, len(kept) // 32)
    if kept[16] != 0.0:
        return np.empty((0, 6))
    return _nearest.near_solutions(rows, _PLACES, _OFFSETS)


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    nearby = _nearby(pose) if _COMPILED else np.empty((0, 6))
    # all joints: the general 6R loop
    solution_roots, solution_found, solution_chosen = _all_joints(
        _NUMBERS, pose, _NO_FREE, seed, nearby
    )

    for i1 in range(16):  # root1 to root16
        q1 = solution_roots[i1, 0]
        q2 = solution_roots[i1, 1]
        q3 = solution_roots[i1, 2]
        q4 = solution_roots[i1, 3]
        q5 = solution_roots[i1, 4]
        q6 = solution_roots[i1, 5]
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
