# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: c78e090c7343b790
"""concurrent_345: Arm whose axes 3, 4 and 5 meet.

Inverse kinematics, generated from robots/concurrent_345.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/concurrent_345.yaml. The formulas and where they come from:
concurrent_345.md.

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
_atan2 = _runtime("angles").atan2
_circle = _runtime("circle_roots")
_circle_roots = _circle.circle_roots
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 6), _runtime("arrays").zeros

NAME = "concurrent_345"
METHOD = "quartic"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "root1-elbow+", "root1-elbow-", "root2-elbow+", "root2-elbow-", "root3-elbow+", "root3-elbow-",
    "root4-elbow+", "root4-elbow-",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = 0.3  # joint offset 1 [m]
a1 = 0.2  # link length 1 [m]
sqrt2 = 1.4142135623730951  # square root of 2
sqrt3 = 1.7320508075688772  # square root of 3
d2 = 0.1  # joint offset 2 [m]
a2 = 0.35  # link length 2 [m]
d3 = 0.25  # joint offset 3 [m]
d5 = 0.2  # joint offset 5 [m]
a5 = 0.15  # link length 5 [m]
d6 = 0.1  # joint offset 6 [m]
a6 = 0.2  # link length 6 [m]
free_limit6 = 4.0089475140624984e-11  # a length that fixes no angle [m^6]
square_rounding = 1e-15  # squares are rounded by this
free_limit_squared2 = 3.422499999999999e-24  # square of a length that fixes no angle [m^2]
# square of a length whose direction is good to few digits [m^2]
near_limit_squared2 = 3.4224999999999994e-06
free_limit = 1e-12  # a length that fixes no angle
near_limit_squared = 1e-06  # square of a length whose direction is good to few digits
free_limit_squared = 1e-24  # square of a length that fixes no angle
k1 = 2.732050807568877  # sqrt3 + 1
k2 = 0.9659258262890683  # d3 * sqrt2 * k1 [m]
k3 = 0.125  # 1 / 8
k4 = 0.12074072828613354  # d3 * sqrt2 * k1 * 1 / 8 [m]
k5 = 0.2897777478867205  # d1 * d3 * sqrt2 * k1 [m^2]
k6 = 0.25  # 1 / 4
k7 = -0.06755556302831987  # (d1 * d3 * sqrt2 * k1 - 8 * a2 * a1) * 1 / 4 [m^2]
k8 = 0.3380740392011739  # a2 * sqrt2 * k1 / 4 [m]
k9 = 0.05  # d3 * a1 [m^2]
k10 = 0.25284442352070435  # (d1 * a2 * sqrt2 * k1 + 2 * d3 * a1) / 2 [m^2]
k11 = 1.6  # 8 * a6 [m]
k12 = 0.4  # d5 + 2 * d6 [m]
k13 = 3.0553429721660432  # d1 * 8 + sqrt2 * (sqrt3 * (2 * d6 - d3) - (2 * d6 - 3 * d3)) [m]
k14 = 0.3  # 2 * a5 [m]
k15 = 0.5  # 1 / 2
k16 = 0.34641016151377546  # d5 * sqrt3 [m]
k17 = 0.0625  # d3^2 [m^2]
# d1 * (d1 * 4 + sqrt2 * (sqrt3 * (2 * d6 - d3) - (2 * d6 - 3 * d3))) + 4 * (a1^2 + (sqrt3 * d3 * d2
# + (d2^2 + (a2^2 + (d3^2 - (d5 * (d5 + d6) + (a5^2 + (d2^2 + a1^2)))))))) [m^2]
k18 = 1.1398079724067007
k19 = 0.06  # 2 * a6 * a5 [m^2]
k20 = 0.06928203230275509  # a6 * d5 * sqrt3 [m^2]
# ((d1 * d3 * sqrt2 * k1 - 8 * a2 * a1) * 1 / 4 * a2 * sqrt2 * k1 / 4 - d3 * sqrt2 * k1 * 1 / 8 *
# (d1 * a2 * sqrt2 * k1 + 2 * d3 * a1) / 2)^2 [m^6]
k21 = 0.0028480795858198678
# 1 / (d3 * sqrt2 * k1 * 1 / 8 * (d1 * a2 * sqrt2 * k1 + 2 * d3 * a1) / 2 - (d1 * d3 * sqrt2 * k1 -
# 8 * a2 * a1) * 1 / 4 * a2 * sqrt2 * k1 / 4) [m^-3]
k22 = 18.738030414662138
k23 = 0.7  # 2 * a2 [m]
k24 = 0.7320508075688772  # sqrt3 - 1
k25 = 0.1830127018922193  # d3 * k24 [m]
k26 = 0.512435565298214  # 2 * a2 * k24 [m]
k27 = 1.7294228634059947  # sqrt3 * (2 * d6 + d3) + (2 * d6 + 3 * d3) [m]
k28 = -1.2679491924311228  # sqrt3 - 3
k29 = 4.732050807568877  # sqrt3 + 3
k30 = 0.8660254037844386  # sqrt3 / 2
k31 = 0.25881904510252074  # sqrt2 * k24 / 4
k32 = 0.07764571353075622  # sqrt2 * d1 * k24 * 1 / 4 [m]
k33 = 7.698003589195011  # 1 / (a5 * sqrt3 / 2) [m^-1]
f1 = 0.25881904510252074  # 1 / 4 * sqrt2 * sqrt3 - 1 / 4 * sqrt2
f2 = 0.9659258262890683  # 1 / 4 * sqrt2 * sqrt3 + 1 / 4 * sqrt2
f3 = 0.025881904510252077  # d2 * f1 [m]
f5 = 0.8660254037844386  # 1 / 2 * sqrt3
f6 = 0.12940952255126037  # 1 / 2 * f1
f7 = 0.22414386804201336  # 1 / 2 * sqrt3 * f1
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=8, size=1.8499999999999999, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0),
        _joints.Joint(place=1),
        _joints.Joint(place=2),
        _joints.Joint(place=3),
        _joints.Joint(place=4),
        _joints.Joint(place=5),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.2, 0.0, 0.2588190451025208, -0.9659258262890684, 0.0, 0.0,
            0.9659258262890684, 0.2588190451025208, 0.3,
        )),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.35, 0.0, 0.8660254037844386, -0.5, 0.0, 0.0, 0.5, 0.8660254037844386,
            0.1,
        )),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.25)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0)),
        _joints.ChainJoint((
            1.0, 0.0, 0.0, 0.15, 0.0, 0.5, -0.8660254037844386, 0.0, 0.0, 0.8660254037844386, 0.5,
            0.2,
        )),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.2, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.1)),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.5405, 0.5405, 0.5405, 1.0, 1.0, 1.0), size=1.8499999999999999,
    entries=(0, 2, 3, 4, 6, 7, 8, 10, 11), steps=("completes", "follows seed"),
    root_turns=((5, 1.0),),
), _joints.arm_numbers(_LINKS))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.3, 0.2, 1.3089969389957472),
    (0.0, 0.1, 0.35, 0.5235987755982988),
    (0.0, 0.25, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.2, 0.15, 1.0471975511965976),
    (0.0, 0.1, 0.2, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    v1, y1_y, z1_x = s1 * f1, c1 * f1, s1 * f2
    v2 = c1 * f2
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, x2_z = c1 * c2 - v1 * s2, s1 * c2 + y1_y * s2, f2 * s2
    v3, v4, v5 = v1 * c2 + c1 * s2, y1_y * c2 - s1 * s2, f2 * c2
    y2_x, y2_y, y2_z = z1_x * k15 - v3 * f5, v4 * f5 - v2 * k15, v5 * f5 + f6
    z2_x, v6, z2_z = v3 * k15 + z1_x * f5, v4 * k15 + v2 * f5, f7 - v5 * k15
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, x2_z * c3 + y2_z * s3
    y4_x, y4_y, y4_z = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, y2_z * c3 - x2_z * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + z2_x * s4, x3_y * c4 - v6 * s4, x3_z * c4 + z2_z * s4
    z4_x, v7, z4_z = z2_x * c4 - x3_x * s4, v6 * c4 + x3_y * s4, z2_z * c4 - x3_z * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, x4_z * c5 + y4_z * s5
    v8, v9, v10 = y4_x * c5 - x4_x * s5, y4_y * c5 - x4_y * s5, y4_z * c5 - x4_z * s5
    y5_x, y5_y, y5_z = k15 * v8 + f5 * z4_x, k15 * v9 - f5 * v7, k15 * v10 + f5 * z4_z
    z5_x, v11, z5_z = k15 * z4_x - f5 * v8, f5 * v9 + k15 * v7, k15 * z4_z - f5 * v10
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    x6_x, x6_y, x6_z = x5_x * c6 + y5_x * s6, x5_y * c6 + y5_y * s6, x5_z * c6 + y5_z * s6
    T[0, 0], T[0, 1], T[0, 2] = x6_x, y5_x * c6 - x5_x * s6, z5_x
    T[0, 3] = (
        c1 * a1 + x2_x * a2 + z1_x * d2 + z2_x * d3 + x5_x * a5 + z4_x * d5 + x6_x * a6 + z5_x * d6
    )
    T[1, 0], T[1, 1], T[1, 2] = x6_y, y5_y * c6 - x5_y * s6, -v11
    T[1, 3] = s1 * a1 + x2_y * a2 - v2 * d2 - v6 * d3 + x5_y * a5 - v7 * d5 + x6_y * a6 - v11 * d6
    T[2, 0], T[2, 1], T[2, 2] = x6_z, y5_z * c6 - x5_z * s6, z5_z
    T[2, 3] = d1 + x2_z * a2 + f3 + z2_z * d3 + x5_z * a5 + z4_z * d5 + x6_z * a6 + z5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y, v1 = c1 * a1, s1 * a1, s1 * f1
    y1_y, z1_x, v2 = c1 * f1, s1 * f2, c1 * f2
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, x2_z = c1 * c2 - v1 * s2, s1 * c2 + y1_y * s2, f2 * s2
    v3, v4, v5 = v1 * c2 + c1 * s2, y1_y * c2 - s1 * s2, f2 * c2
    p2_x, p2_y, p2_z = p1_x + x2_x * a2 + z1_x * d2, p1_y + x2_y * a2 - v2 * d2, d1 + x2_z * a2 + f3
    y2_x, y2_y, y2_z = z1_x * k15 - v3 * f5, v4 * f5 - v2 * k15, v5 * f5 + f6
    z2_x, v6, z2_z = v3 * k15 + z1_x * f5, v4 * k15 + v2 * f5, f7 - v5 * k15
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, x2_z * c3 + y2_z * s3
    y4_x, y4_y, y4_z = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, y2_z * c3 - x2_z * s3
    p3_x, p3_y, p3_z = p2_x + z2_x * d3, p2_y - v6 * d3, p2_z + z2_z * d3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + z2_x * s4, x3_y * c4 - v6 * s4, x3_z * c4 + z2_z * s4
    z4_x, v7, z4_z = z2_x * c4 - x3_x * s4, v6 * c4 + x3_y * s4, z2_z * c4 - x3_z * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, x4_z * c5 + y4_z * s5
    v8, v9, v10 = y4_x * c5 - x4_x * s5, y4_y * c5 - x4_y * s5, y4_z * c5 - x4_z * s5
    p5_x, p5_y = p3_x + x5_x * a5 + z4_x * d5, p3_y + x5_y * a5 - v7 * d5
    p5_z, z5_x, v11 = p3_z + x5_z * a5 + z4_z * d5, k15 * z4_x - f5 * v8, f5 * v9 + k15 * v7
    z5_z = k15 * z4_z - f5 * v10
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    p6_x = p5_x + (x5_x * c6 + (k15 * v8 + f5 * z4_x) * s6) * a6 + z5_x * d6
    p6_y = p5_y + (x5_y * c6 + (k15 * v9 - f5 * v7) * s6) * a6 - v11 * d6
    p6_z, v12 = p5_z + (x5_z * c6 + (k15 * v10 + f5 * z4_z) * s6) * a6 + z5_z * d6, p6_x - p1_x
    v13, v14, v15 = p6_y - p1_y, p6_z - d1, p6_x - p2_x
    v16, v17, v18 = p6_y - p2_y, p6_z - p2_z, p6_x - p3_x
    v19, v20, v21 = p6_y - p3_y, p6_z - p3_z, p6_x - p5_x
    v22, v23 = p6_y - p5_y, p6_z - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, -(v2 * v14 + f1 * v13), -(v6 * v17 + z2_z * v16)
    J[0, 3], J[0, 4] = -y4_y * v20 - -y4_z * v19, -(v7 * v20 + z4_z * v19)
    J[0, 5] = -(v11 * v23 + z5_z * v22)
    J[1, 0], J[1, 1], J[1, 2] = p6_x, f1 * v12 - z1_x * v14, z2_z * v15 - z2_x * v17
    J[1, 3], J[1, 4] = -y4_z * v18 - -y4_x * v20, z4_z * v18 - z4_x * v20
    J[1, 5] = z5_z * v21 - z5_x * v23
    J[2, 1], J[2, 2] = z1_x * v13 + v2 * v12, z2_x * v16 + v6 * v15
    J[2, 3], J[2, 4] = -y4_x * v19 - -y4_y * v18, z4_x * v19 + v7 * v18
    J[2, 5] = z5_x * v22 + v11 * v21
    J[3, 1], J[3, 2], J[3, 3] = z1_x, z2_x, -y4_x
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = -v2, -v6, -y4_y
    J[4, 4], J[4, 5] = -v7, -v11
    J[5, 0], J[5, 1], J[5, 2] = 1.0, f1, z2_z
    J[5, 3], J[5, 4], J[5, 5] = -y4_z, z4_z, z5_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta6, type 9: U0 (A5 A6)^-1 [3, 4] and the squared length of column 4 of A5 A6 U0^-1
    v1 = T31 * k11 + (T33 * k11 + (k13 - 8.0 * T34))
    R1_6 = k3 * v1
    v2 = T31 * k14 + d5 * (sqrt3 * T32)
    R1c6 = v2 * k15
    v3 = T31 * k16 - 2.0 * (T32 * a5)
    R1s6 = k15 * v3
    v4, v5 = T14 * T11 + T24 * T21 + T31 * T34, T14 * T12 + T24 * T22 + T32 * T34
    v6 = T14 * T13 + T24 * T23 + T33 * T34
    v7 = v5 * (4.0 * v5) - (v6 * (4.0 * (k12 - v6)) + k18) - v4 * (4.0 * (k12 - v4))
    R2_6 = k6 * -v7
    v8, v9, v10 = k19 - k16 * v5 - k14 * v4, k14 * v5 + k20 - k16 * v4, k8 * R2_6 - k10 * R1_6
    v11, v12, v13 = k8 * -v8 - k10 * R1c6, k8 * -v9 - k10 * R1s6, k4 * R2_6 - k7 * R1_6
    v14, v15, v16 = k4 * -v8 - k7 * R1c6, k4 * -v9 - k7 * R1s6, v11 * v11
    v17, v18, v19 = v12 * v12, 2.0 * v10, v14 * v14
    v20, v21 = v15 * v15, 2.0 * v13
    v22 = v10 * v10 + k15 * (v16 + v17) + (v13 * v13 + k15 * (v19 + v20))
    v23, v24 = v11 * v18 + v14 * v21, v12 * v18 + v15 * v21
    v25, v26, v27 = k15 * (v16 - v17) + k15 * (v19 - v20), v11 * v12 + v14 * v15, v22 - k21
    free6 = abs(v27) + abs(v23) + abs(v24) + abs(v25) + abs(v26) <= free_limit6
    x6_roots, x6_close = _circle_roots(1.0 if free6 else v27, -1.0 if free6 else v23, 0.0 if free6
        else v24, 0.0 if free6 else v25, 0.0 if free6 else v26, square_rounding * (v22 + k21),
        moved)

    # theta2, type 3: U0 (A5 A6)^-1 [3, 4] and the squared length of column 4 of A5 A6 U0^-1
    v28, v29, v31 = 4.0 * v2, 4.0 * v3, 4.0 * v8
    v32 = 4.0 * v9

    # theta1, type 3: U0 (A5 A6)^-1 [2, 4] and U0 (A5 A6)^-1 [1, 4]
    v33 = sqrt3 * T22
    v34, v35 = k14 * T21 + d5 * v33, k16 * T21 - 2.0 * (a5 * T22)
    v36, v38 = k12 * T21 + (k12 * T23 - 2.0 * T24), sqrt3 * T12
    v39, v40 = k14 * T11 + d5 * v38, k16 * T11 - 2.0 * (a5 * T12)
    v41 = k12 * T11 + (k12 * T13 - 2.0 * T14)

    # theta3, type 2: U3 (A5 A6)^-1 [3, 3]
    v44, v45, v46 = sqrt3 * T11, T22 * k28, T21 * k28
    v47, v48, v49 = T23 * k24, sqrt3 * T21, T12 * k28
    v50, v51, v52 = T11 * k28, T13 * k24, T32 * k29
    v53, v54, v56 = T31 * k29, k1 * T33, 3.0 * (T22 * k24)
    v57, v58, v59 = 3.0 * (T21 * k24), T23 * k28, 3.0 * T12
    v60, v61, v62 = 3.0 * T11, sqrt3 * T13, T22 * k29
    v63, v64, v65 = T21 * k29, k1 * T23, 3.0 * (T12 * k24)
    v66, v67, v68 = 3.0 * (T11 * k24), T13 * k28, 3.0 * T22
    v69, v70, v71 = 3.0 * T21, sqrt3 * T23, T12 * k29
    v72, v73, v74 = T11 * k29, k1 * T13, 3.0 * (k1 * T32)
    v75, v76, v77 = 3.0 * (k1 * T31), T33 * k29, T32 * k28
    v78, v79 = T31 * k28, T33 * k24

    # theta5, type 3: U3 A6^-1 [3, 3] and U3 A6^-1 [3, 4]
    v81, v82, v83 = sqrt2 * v58, 4.0 * v61, sqrt2 * v64
    v84, v85, v86 = sqrt2 * v67, 4.0 * v70, sqrt2 * v73
    v88, v89, v90 = 4.0 * T13, sqrt2 * v47, 4.0 * T23
    v91 = sqrt2 * v51
    wx = T14 - a6 * T11 - d6 * T13
    wy = T24 - a6 * T21 - d6 * T23
    wz = T34 - T31 * a6 - T33 * d6
    v94, v95 = k2 * wz, wz * k31

    # theta4, type 3: U3[2, 3] and U3[1, 3]
    v102, v103 = sqrt2 * (T23 * k29), sqrt2 * (T13 * k29)

    for i1 in range(4):  # root1, root2, root3, root4
        x6 = x6_roots[i1]
        # theta6
        if not (x6 <= 4.0):
            continue  # out of reach
        q6 = seed[5] if free6 else x6
        c6, s6 = math.cos(q6), math.sin(q6)

        # theta2
        v30 = k3 * (v1 + (c6 * v28 + s6 * v29))
        Z2_2 = k6 * (v7 + (c6 * v31 + s6 * v32))
        s2, c2 = (k7 * v30 + k4 * Z2_2) * k22, (k8 * Z2_2 + k10 * v30) * k22
        q2 = _atan2(s2, c2)

        # theta1
        X1_1 = k15 * (k12 + (c2 * k23 + d3 * s2))
        X2_1 = k3 * (sqrt2 * (c2 * k25 - s2 * k26 + k27))
        v37, v42 = k15 * (c6 * v34 + s6 * v35 + v36), k15 * (c6 * v39 + s6 * v40 + v41)
        v43 = X1_1 * v37 + X2_1 * v42
        C1 = X2_1 * v37 - X1_1 * v42
        w1 = math.sqrt(v43 * v43 + C1 * C1)
        free1 = w1 <= free_limit_squared2
        near1 = w1 <= near_limit_squared2
        factor1 = 1.0 / (1.0 if free1 else w1)
        c1 = math.cos(seed[0]) if free1 else C1 * factor1
        s1 = math.sin(seed[0]) if free1 else -(v43 * factor1)
        q1 = _atan2(s1, c1)

        # theta3
        v55 = (
            k3 * (c1 * (c2 * (4.0 * (T13 + (c6 * v38 + s6 * v44))) - s2 * (sqrt2 * (c6 * v45 + s6 *
            v46 - v47))) + s1 * (c2 * (4.0 * (T23 + (c6 * v33 + s6 * v48))) + s2 * (sqrt2 * (c6 *
            v49 + s6 * v50 - v51))) + sqrt2 * (s2 * (c6 * v52 + s6 * v53 + v54)))
        )
        Y3 = (
            k17 * (sqrt2 * (c2 * (c6 * v74 + s6 * v75 + v76) + (v79 - (c6 * v77 + s6 * v78))) - (c1
            * (s2 * (4.0 * (c6 * v59 + s6 * v60 + v61)) - c2 * (sqrt2 * (c6 * v56 + s6 * v57 - v58))
            + sqrt2 * (c6 * v62 + s6 * v63 + v64)) + s1 * (c2 * (sqrt2 * (c6 * v65 + s6 * v66 -
            v67)) + s2 * (4.0 * (c6 * v68 + s6 * v69 + v70)) - sqrt2 * (c6 * v71 + s6 * v72 +
            v73))))
        )
        v80 = v55 * v55 + Y3 * Y3
        w3 = math.sqrt(v80)
        free3 = w3 <= free_limit
        near3 = v80 <= near_limit_squared
        divisor3 = 1.0 if free3 else w3

        # theta5
        v87 = (
            c1 * (c2 * v81 + s2 * v82 + v83) - s1 * (c2 * v84 - s2 * v85 + v86) - sqrt2 * (T33 *
            (k24 + c2 * k29))
        )
        v92 = 2.0 * (c1 * (c2 * v88 + s2 * v89) + s1 * (c2 * v90 - s2 * v91) + sqrt2 * (s2 * v54))
        v93, v96 = c1 * wy - s1 * wx, c1 * wx + s1 * wy - a1
        v97 = k31 * v93 + v94 - k5
        v98 = c2 * v96 + s2 * v97 - a2
        v99 = k30 * (c2 * v97 - s2 * v96) + k15 * (v95 - k2 * v93 - k32) - k9

        # theta4
        Z1_4 = (
            k3 * (c1 * (s2 * v88 - c2 * v89 - v102) + s1 * (c2 * v91 + s2 * v90 + v103) - sqrt2 *
            (T33 * (k28 + k1 * c2)))
        )
        v105 = k15 * Z1_4

        for i2 in range(2):  # elbow+, elbow-
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and free3:
                continue  # both signs give the same
            factor3 = e3 / divisor3
            c3 = math.cos(seed[2]) if free3 else v55 * factor3
            s3 = math.sin(seed[2]) if free3 else Y3 * factor3
            q3 = _atan2(s3, c3)

            # theta5
            v100 = k30 * (s3 * v98 - c3 * v99) * k33
            c5 = a5 * (k3 * (c3 * v87 + s3 * v92)) * k33
            q5 = _atan2(-v100, c5)

            # theta4
            v101 = k15 * (sqrt3 * v100)
            Z2_4 = k3 * (c3 * v92 + s3 * -v87)
            v104 = v101 * Z1_4 + k15 * Z2_4
            C4 = v105 - v101 * Z2_4
            w4 = math.sqrt(v104 * v104 + C4 * C4)
            free4 = w4 <= free_limit_squared
            near4 = w4 <= near_limit_squared
            factor4 = 1.0 / (1.0 if free4 else w4)
            c4 = math.cos(seed[3]) if free4 else C4 * factor4
            s4 = math.sin(seed[3]) if free4 else -(v104 * factor4)
            q4 = _atan2(s4, c4)
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
            q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
            status[row] = (
                FREE_JOINT if free1 or free3 or free4 or free6 else _status.CLOSE if x6_close[i1] or
                near1 or near3 or near4 else OK
            )


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "pose", apart=(_circle.OWN.compile_apart, _runtime("complete").compile_apart,),
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
