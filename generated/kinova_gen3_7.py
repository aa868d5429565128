# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 24c1f9395bc7745f
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
    (-math.inf, math.inf), (-2.24, 2.24), (-math.inf, math.inf), (-2.57, 2.57),
    (-math.inf, math.inf), (-2.09, 2.09), (-math.inf, math.inf),
)
BRANCHES = (
    "elbow+-shoulder+-noflip", "elbow+-shoulder+-flip", "elbow+-shoulder--noflip",
    "elbow+-shoulder--flip", "elbow--shoulder+-noflip", "elbow--shoulder+-flip",
    "elbow--shoulder--noflip", "elbow--shoulder--flip", "further1", "further2", "further3",
    "further4", "further5", "further6", "further7", "further8",
)
MAX_SOLUTIONS = 16
FREE_JOINTS = (3,)  # from 1: the caller gives their values

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

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
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16, size=1.1507100000000001, coordinates=(0, 1, 2), directions="rotation",
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
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
    miss_weights=(0.869, 0.869, 0.869, 1.0, 1.0, 1.0), size=1.1507100000000001,
    paces=(1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.0), clamped_again=1e-10, steps=("clamps",), given=(2,),
))

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
    types=JOINT_TYPES, table=TABLE, convention="standard",
    base=(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (7,)."""
    T = _zeros(4, 4)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, v2, z2_x = c1 * c2, s1 * c2, c1 * s2
    v3, v4 = s1 * s2, q[2] + offset3
    c3, s3 = math.cos(v4), math.sin(v4)
    x3_x, x3_y, v5 = x2_x * c3 + s1 * s3, c1 * s3 - v2 * c3, s2 * c3
    v6, v7, z3_x = c1 * c3 + v2 * s3, s2 * s3, x2_x * s3 - s1 * c3
    v8 = q[3] + offset4
    c4, s4 = math.cos(v8), math.sin(v8)
    x4_x, x4_y, x4_z = x3_x * c4 + z2_x * s4, x3_y * c4 - v3 * s4, c2 * s4 - v5 * c4
    z4_y, v9, z4_x = v3 * c4 + x3_y * s4, c2 * c4 + v5 * s4, x3_x * s4 - z2_x * c4
    v10 = q[4] + offset5
    c5, s5 = math.cos(v10), math.sin(v10)
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, x4_y * c5 - v6 * s5, x4_z * c5 - v7 * s5
    z5_y, z5_z, z5_x = v6 * c5 + x4_y * s5, v7 * c5 + x4_z * s5, x4_x * s5 - z3_x * c5
    v11 = q[5] + offset6
    c6, s6 = math.cos(v11), math.sin(v11)
    x6_x, x6_y, x6_z = x5_x * c6 + z4_x * s6, x5_y * c6 + z4_y * s6, x5_z * c6 - v9 * s6
    z6_z, z6_x, z6_y = v9 * c6 + x5_z * s6, x5_x * s6 - z4_x * c6, x5_y * s6 - z4_y * c6
    v12 = q[6] + offset7
    c7, s7 = math.cos(v12), math.sin(v12)
    T[0, 0], T[0, 1], T[0, 2] = x6_x * c7 + z5_x * s7, z5_x * c7 - x6_x * s7, z6_x
    T[0, 3] = -(s1 * d2 + z2_x * d3 + z3_x * d4 + z4_x * d5 + z5_x * d6 + z6_x * d7)
    T[1, 0], T[1, 1], T[1, 2] = x6_y * c7 + z5_y * s7, z5_y * c7 - x6_y * s7, z6_y
    T[1, 3] = v3 * d3 - c1 * d2 + v6 * d4 - z4_y * d5 - z5_y * d6 - z6_y * d7
    T[2, 0], T[2, 1], T[2, 2] = x6_z * c7 + z5_z * s7, z5_z * c7 - x6_z * s7, z6_z
    T[2, 3] = d1 - c2 * d3 + v7 * d4 + v9 * d5 - z5_z * d6 - z6_z * d7
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 7): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 7)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, v2, z2_x = c1 * c2, s1 * c2, c1 * s2
    v3, v4, v5 = s1 * s2, s1 * d2, c1 * d2
    v6 = q[2] + offset3
    c3, s3 = math.cos(v6), math.sin(v6)
    x3_x, x3_y, v7 = x2_x * c3 + s1 * s3, c1 * s3 - v2 * c3, s2 * c3
    v8, v9, v10 = c1 * c3 + v2 * s3, s2 * s3, v4 + z2_x * d3
    p3_y, p3_z, z3_x = v3 * d3 - v5, d1 - c2 * d3, x2_x * s3 - s1 * c3
    v11 = q[3] + offset4
    c4, s4 = math.cos(v11), math.sin(v11)
    x4_x, x4_y, x4_z = x3_x * c4 + z2_x * s4, x3_y * c4 - v3 * s4, c2 * s4 - v7 * c4
    z4_y, v12, v13 = v3 * c4 + x3_y * s4, c2 * c4 + v7 * s4, v10 + z3_x * d4
    p4_y, p4_z, z4_x = p3_y + v8 * d4, p3_z + v9 * d4, x3_x * s4 - z2_x * c4
    v14 = q[4] + offset5
    c5, s5 = math.cos(v14), math.sin(v14)
    z5_y, z5_z, v15 = v8 * c5 + x4_y * s5, v9 * c5 + x4_z * s5, v13 + z4_x * d5
    p5_y, p5_z, z5_x = p4_y - z4_y * d5, p4_z + v12 * d5, x4_x * s5 - z3_x * c5
    v16 = q[5] + offset6
    c6, s6 = math.cos(v16), math.sin(v16)
    z6_z, v17, p6_y = v12 * c6 + (x4_z * c5 - v9 * s5) * s6, v15 + z5_x * d6, p5_y - z5_y * d6
    p6_z, z6_x = p5_z - z5_z * d6, (x4_x * c5 + z3_x * s5) * s6 - z4_x * c6
    z6_y, J21 = (x4_y * c5 - v8 * s5) * s6 - z4_y * c6, v17 + z6_x * d7
    p7_y, p7_z = p6_y - z6_y * d7, p6_z - z6_z * d7
    v18, v19, v20 = p7_z - d1, v4 - J21, v5 + p7_y
    v21, v22, v23 = v10 - J21, p7_y - p3_y, p7_z - p3_z
    v24, v25, v26 = v13 - J21, p7_y - p4_y, p7_z - p4_z
    v27, v28, v29 = v15 - J21, p7_y - p5_y, p7_z - p5_z
    v30, v31, v32 = v17 - J21, p7_y - p6_y, p7_z - p6_z
    J[0, 0], J[0, 1], J[0, 2] = p7_y, c1 * v18, -(v3 * v18 + c2 * v20)
    J[0, 3], J[0, 4], J[0, 5] = v9 * v22 - v8 * v23, z4_y * v26 + v12 * v25, z5_y * v29 - z5_z * v28
    J[0, 6] = z6_y * v32 - z6_z * v31
    J[1, 0], J[1, 1], J[1, 2] = J21, -(s1 * v18), c2 * v19 - z2_x * v18
    J[1, 3], J[1, 4] = -(v9 * v21 + z3_x * v23), -(v12 * v24 + z4_x * v26)
    J[1, 5], J[1, 6] = z5_z * v27 - z5_x * v29, z6_z * v30 - z6_x * v32
    J[2, 1], J[2, 2], J[2, 3] = s1 * p7_y + c1 * J21, z2_x * v20 + v3 * v19, z3_x * v22 + v8 * v21
    J[2, 4], J[2, 5] = z4_x * v25 - z4_y * v24, z5_x * v28 - z5_y * v27
    J[2, 6] = z6_x * v31 - z6_y * v30
    J[3, 1], J[3, 2], J[3, 3] = s1, z2_x, z3_x
    J[3, 4], J[3, 5], J[3, 6] = z4_x, z5_x, z6_x
    J[4, 1], J[4, 2], J[4, 3] = c1, -v3, -v8
    J[4, 4], J[4, 5], J[4, 6] = z4_y, z5_y, z6_y
    J[5, 0], J[5, 2], J[5, 3] = -1.0, c2, -v9
    J[5, 4], J[5, 5], J[5, 6] = -v12, z5_z, z6_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.3707388051002349, reach=4.062224539232323,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0, 0.01584673608061403,
            0.9230769230769231, 0.38461538461538464, 0.0, -1.9205566660481306e-10,
        )),
        _loops.Link(
            first=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -0.015846736084575715),
            inside=(
                _loops.Inside(
                    given=0, slides=False, factor=1.0,
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
_nearest = _runtime("general.near")


# The nearest arm with a structure: what follows is its closed form.
@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T13, T14, T23 = kept[2 * w + k], kept[3 * w + k], kept[6 * w + k]
        T24, T33, T34 = kept[7 * w + k], kept[10 * w + k], kept[11 * w + k]
        given1, given2, given3 = kept[16 * w + k], kept[17 * w + k], kept[18 * w + k]
        v1 = near_offset3 + given1

        # theta4, type 2: the squared length of column 4 of U0
        v2, v3 = T14 * T14, T24 * T24

        # theta1, type 2: U1[3, 4]
        N1 = v2 + v3
        inverse1 = 1.0 / N1
        v26, v31 = T14 * inverse1, T24 * inverse1

        # theta5, type 2: U5[3, 3]
        v85 = T24 * T13 - T14 * T23

        # by how much these differ at poses so near: slopes and rests
        v178, v179, v180 = T14 * given3, abs(T14), abs(given3)
        v181, v182, v183 = v178 + v178, v180 * v180, T24 * given3
        v184, v185, v186 = abs(T24), v183 + v183, T34 * given3
        v187, v188, v189 = abs(T34), v186 + v186, v182 + v182
        v190, v195 = v182 + v189, v181 * v181 + v185 * v185
        v196, v511 = v190 + math.sqrt(v195 + v188 * v188), abs(inverse1)
        v512, v513 = inverse1 * (inverse1 * v181), inverse1 * (inverse1 * v185)
        v514, v515 = v511 * (v189 * v511), math.sqrt(N1) - math.sqrt(v189)
        v516 = v514 + (v514 + (abs(v512) + abs(v513))) * ((v189 + math.sqrt(v195)) / (v515 * v515))
        v534, v543 = v516 + math.sqrt(v512 * v512 + v513 * v513), inverse1 * given3
        v544, v545, v546 = T14 * v513, v543 - T14 * v512, v180 * v534
        v547, v548, v549 = v546 + v179 * v516, abs(v26), v544 * v544
        v550, v551 = v547 + math.sqrt(v545 * v545 + v549), v547 + math.sqrt(v549 + -v545 * -v545)
        v576, v577, v578 = T33 * given2, T23 * given2, near1 * (given2 * given2)
        v591, v592, v593 = abs(T13), v576 * v576, v577 * v577
        v594, v612, v613 = v578 + math.sqrt(v592 + v593), T24 * v512, v543 - T24 * v513
        v614, v615, v616 = v546 + v184 * v516, abs(v31), v612 * v612
        v617, v618 = v614 + math.sqrt(v616 + v613 * v613), v614 + math.sqrt(v616 + -v613 * -v613)
        v664, v673 = T13 * given2, abs(T23)
        v674 = v664 * v664
        v675, v699 = v578 + math.sqrt(v592 + v674), v578 + math.sqrt(v593 + v674)
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v2, v3, N1
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = inverse1, v26, v31
        kept[26 * w + k], kept[27 * w + k], kept[28 * w + k] = v85, v179, v180
        kept[29 * w + k], kept[30 * w + k], kept[31 * w + k] = v181, v184, v185
        kept[32 * w + k], kept[33 * w + k], kept[34 * w + k] = v187, v188, v189
        kept[35 * w + k], kept[36 * w + k], kept[37 * w + k] = v190, v196, v511
        kept[38 * w + k], kept[39 * w + k], kept[40 * w + k] = v512, v513, v516
        kept[41 * w + k], kept[42 * w + k], kept[43 * w + k] = v534, v544, v545
        kept[44 * w + k], kept[45 * w + k], kept[46 * w + k] = v547, v548, v550
        kept[47 * w + k], kept[48 * w + k], kept[49 * w + k] = v551, v576, v577
        kept[50 * w + k], kept[51 * w + k], kept[52 * w + k] = v578, v591, v594
        kept[53 * w + k], kept[54 * w + k], kept[55 * w + k] = v612, v613, v614
        kept[56 * w + k], kept[57 * w + k], kept[58 * w + k] = v615, v617, v618
        kept[59 * w + k], kept[60 * w + k], kept[61 * w + k] = v664, v673, v675
        kept[62 * w + k], turns[0 * w + k], turns[1 * w + k] = v699, v1, v1
    for k in range(0 * w, 1 * w):
        turns[k] = math.sin(turns[k])
    for k in range(1 * w, 2 * w):
        turns[k] = math.cos(turns[k])
    for k in range(w):
        T11, T12, T13 = kept[0 * w + k], kept[1 * w + k], kept[2 * w + k]
        T14, T21, T22 = kept[3 * w + k], kept[4 * w + k], kept[5 * w + k]
        T23, T24, T31 = kept[6 * w + k], kept[7 * w + k], kept[8 * w + k]
        T32, T33, T34 = kept[9 * w + k], kept[10 * w + k], kept[11 * w + k]
        given1, given3, v2 = kept[16 * w + k], kept[18 * w + k], kept[20 * w + k]
        v3, N1, inverse1 = kept[21 * w + k], kept[22 * w + k], kept[23 * w + k]
        v26, v31, v85 = kept[24 * w + k], kept[25 * w + k], kept[26 * w + k]
        v179, v180, v181 = kept[27 * w + k], kept[28 * w + k], kept[29 * w + k]
        v184, v185, v187 = kept[30 * w + k], kept[31 * w + k], kept[32 * w + k]
        v188, v189, v190 = kept[33 * w + k], kept[34 * w + k], kept[35 * w + k]
        v196, v511, v512 = kept[36 * w + k], kept[37 * w + k], kept[38 * w + k]
        v513, v516, v534 = kept[39 * w + k], kept[40 * w + k], kept[41 * w + k]
        v544, v545, v547 = kept[42 * w + k], kept[43 * w + k], kept[44 * w + k]
        v548, v550, v551 = kept[45 * w + k], kept[46 * w + k], kept[47 * w + k]
        v576, v577, v578 = kept[48 * w + k], kept[49 * w + k], kept[50 * w + k]
        v591, v594, v612 = kept[51 * w + k], kept[52 * w + k], kept[53 * w + k]
        v613, v614, v615 = kept[54 * w + k], kept[55 * w + k], kept[56 * w + k]
        v617, v618, v664 = kept[57 * w + k], kept[58 * w + k], kept[59 * w + k]
        v673, v675, v699 = kept[60 * w + k], kept[61 * w + k], kept[62 * w + k]
        s3, c3 = turns[0 * w + k], turns[1 * w + k]

        # theta4, type 2: the squared length of column 4 of U0
        X4 = near_d5 * (near_d2 * s3) * 2.0
        N4, Z4 = near_k2 + X4 * X4, near_k3 * c3 + (v2 + (v3 + (T34 * T34 - near_k4)))
        D4_squared = N4 - Z4 * Z4
        w4, inverse4, v4 = math.sqrt(D4_squared), 1.0 / N4, X4 * Z4
        v5, v6 = inverse4 * v4, near_m2 * inverse4
        v7 = w4 * v6
        s4_p, s4_m, v8 = v5 - v7, v5 + v7, inverse4 * (near_k1 * Z4)
        v9 = X4 * inverse4
        v10 = w4 * v9
        v11, v12 = v8 + v10, v8 - v10

        # theta1, type 2: U1[3, 4]
        v13, v14 = near_d5 * s3, near_d4 * c3 - near_d2
        Z1_p, Z1_m = v14 - s4_p * v13, v14 - s4_m * v13
        D1_squared_p, D1_squared_m, v15 = N1 - Z1_p * Z1_p, N1 - Z1_m * Z1_m, near_k5 * w4
        w1_p, w1_m = math.sqrt(D1_squared_p), math.sqrt(D1_squared_m)
        v16, v17, v18 = w1_p - w1_p, w1_m - w1_m, abs(Z1_p)
        v19, v20 = abs(Z1_m), near_blur_slack1 + 2.0 * v18
        v21, v22, v23 = near_blur_slack1 + 2.0 * v19, T14 * Z1_p, T14 * Z1_m
        v24, v25 = T24 * Z1_p, T24 * Z1_m
        v27, v28, v29 = inverse1 * v24, inverse1 * v25, w1_p * v26
        c1_pp, c1_pm, v30 = v27 + v29, v27 - v29, w1_m * v26
        c1_mp, c1_mm, v32 = v28 + v30, v28 - v30, inverse1 * v22
        v33, v34 = inverse1 * v23, w1_p * v31
        s1_pp, v35, v36 = v34 - v32, v32 + v34, w1_m * v31
        s1_mp, v37 = v36 - v33, v33 + v36

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        v38, v39, v40 = near_d5 * c3, near_d4 * s3, near_d3 + near_d5 * v11
        v41, v42 = near_d3 + near_d5 * v12, v39 + inverse4 * (v4 * v38)
        v43, v44 = T34 * v42, near_m2 * (inverse4 * (T34 * v38))
        v45 = w4 * v44
        v46, v47, v48 = v43 - v45, v43 + v45, w1_p * v40
        v49, S2_pp, S2_pm = w1_m * v41, v46 + v48, v46 - v48
        S2_mp, S2_mm, v50 = v47 + v49, v47 - v49, T34 * v40
        v51, v52, v53 = T34 * v41, v39 + s4_p * v38, v39 + s4_m * v38
        v54, v55 = w1_p * v52, w1_m * v53
        C2_pp, v56, C2_mp = v54 - v50, v50 + v54, v55 - v51
        v57, v58, v59 = v51 + v55, S2_pp * S2_pp + C2_pp * C2_pp, S2_pm * S2_pm + v56 * v56
        v60, v61, v62 = S2_mp * S2_mp + C2_mp * C2_mp, S2_mm * S2_mm + v57 * v57, math.sqrt(v58)
        v63, v64, v65 = math.sqrt(v59), math.sqrt(v60), math.sqrt(v61)
        v66, v67, v68 = 1.0 / v58, 1.0 / v59, 1.0 / v60
        v69, factor2_pp, factor2_pm = 1.0 / v61, v62 * v66, v63 * v67
        factor2_mp, factor2_mm = v64 * v68, v65 * v69

        # theta5, type 2: U5[3, 3]
        v70 = c3 * T13
        v71, v72, v73 = v11 * v70, v12 * v70, c3 * T23
        v74, v75, v76 = v11 * v73, v12 * v73, s4_p * T33
        v77, v78, v79 = s4_m * T33, s4_p * T13, s4_m * T13
        v80, v81, v82 = s4_p * T23, s4_m * T23, c3 * T33
        v83, v84, v86 = v11 * v82, v12 * v82, s3 * v85
        v87, v88 = s3 * -v85, inverse1 * v86
        v89, v90, v91 = inverse1 * v87, s3 * (v22 * T13 + v24 * T23), s3 * (v23 * T13 + v25 * T23)
        v92, v93 = inverse1 * v90, inverse1 * v91
        v94, v95, v96 = w1_p * v88 - v92, w1_p * v89 - v92, w1_m * v88 - v93
        v97, v98 = w1_m * v89 - v93, c1_pp * v78 + s1_pp * v80 - v83
        v99, v100 = c1_pm * v78 - v35 * v80 - v83, c1_mp * v79 + s1_mp * v81 - v84
        v101, v102 = c1_mm * v79 - v37 * v81 - v84, v76 + (c1_pp * v71 + s1_pp * v74)
        v103, v104 = v76 + (c1_pm * v71 - v35 * v74), v77 + (c1_mp * v72 + s1_mp * v75)
        v105, v106 = v77 + (c1_mm * v72 - v37 * v75), S2_pp * v98 - C2_pp * v102
        v107, v108 = S2_pm * v99 + v56 * v103, S2_mp * v100 - C2_mp * v104
        v109, c5_pp = S2_mm * v101 + v57 * v105, factor2_pp * v106 - v11 * v94
        c5_pm, c5_mp = factor2_pm * v107 - v11 * v95, factor2_mp * v108 - v12 * v96
        c5_mm, v110 = factor2_mm * v109 - v12 * v97, s3 * T33
        v111, v112 = s3 * (c1_pp * T13 + s1_pp * T23), s3 * (c1_pm * T13 - v35 * T23)
        v113, v114 = s3 * (c1_mp * T13 + s1_mp * T23), s3 * (c1_mm * T13 - v37 * T23)
        v115, v116 = C2_pp * v111 + S2_pp * v110, S2_pm * v110 - v56 * v112
        v117, v118 = C2_mp * v113 + S2_mp * v110, S2_mm * v110 - v57 * v114
        Y5_pp = factor2_pp * v115 - c3 * (s1_pp * T13 - c1_pp * T23)
        Y5_pm = factor2_pm * v116 + c3 * (v35 * T13 + c1_pm * T23)
        Y5_mp = factor2_mp * v117 - c3 * (s1_mp * T13 - c1_mp * T23)
        Y5_mm = factor2_mm * v118 + c3 * (v37 * T13 + c1_mm * T23)
        v119, v120 = c5_pp * c5_pp + Y5_pp * Y5_pp, c5_pm * c5_pm + Y5_pm * Y5_pm
        v121, v122 = c5_mp * c5_mp + Y5_mp * Y5_mp, c5_mm * c5_mm + Y5_mm * Y5_mm

        # theta6, type 3: U5[2, 3] and U5[1, 3]
        v123, v124, v125 = s4_p * v70, s4_m * v70, s4_p * v73
        v126, v127, v128 = s4_m * v73, v11 * T33, v12 * T33
        v129, v130, v131 = v11 * T13, v12 * T13, v11 * T23
        v132, v133, v134 = v12 * T23, s4_p * v82, s4_m * v82

        # theta7, type 3: U5[3, 2] and U5[3, 1]
        v135, v136, v137 = s3 * T32, s1_pp * T12 - c1_pp * T22, v35 * T12 + c1_pm * T22
        v138, v139, v140 = s1_mp * T12 - c1_mp * T22, v37 * T12 + c1_mm * T22, c3 * T12
        v141, v142, v143 = v11 * v140, v12 * v140, c3 * T22
        v144, v145, v146 = v11 * v143, v12 * v143, s4_p * T32
        v147, v148, v149 = s4_m * T32, s4_p * T12, s4_m * T12
        v150, v151, v152 = s4_p * T22, s4_m * T22, c3 * T32
        v153, v154, v155 = v11 * v152, v12 * v152, s3 * T31
        v156, v157 = s1_pp * T11 - c1_pp * T21, v35 * T11 + c1_pm * T21
        v158, v159, v160 = s1_mp * T11 - c1_mp * T21, v37 * T11 + c1_mm * T21, c3 * T11
        v161, v162, v163 = v11 * v160, v12 * v160, c3 * T21
        v164, v165, v166 = v11 * v163, v12 * v163, s4_p * T31
        v167, v168, v169 = s4_m * T31, s4_p * T11, s4_m * T11
        v170, v171, v172 = s4_p * T21, s4_m * T21, c3 * T31
        v173, v174 = v11 * v172, v12 * v172
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
        q3_ppp, q3_mpp, v176 = v16 + v175, v17 + v175, abs(Z4)
        v177 = near_merge_slack2 + 2.0 * v176

        # by how much these differ at poses so near: slopes and rests
        v191, v192, v193 = Z4 * v181, Z4 * v185, Z4 * v188
        v194, v197, v198 = v176 * v190, v191 + v191, v192 + v192
        v199, v200 = v193 + v193, v194 + v194 + v196 * v196
        v201, v202 = v200 + math.sqrt(v197 * v197 + v198 * v198 + v199 * v199), X4 * v181
        v203, v204, v205 = X4 * v185, X4 * v188, v190 * abs(X4)
        v206, v207, v208 = inverse4 * v202, inverse4 * v203, inverse4 * v204
        v209, v210 = abs(inverse4), near1 / w4
        v211, v212, v213 = v197 * v210, v198 * v210, v199 * v210
        v214 = v201 * v210
        v215 = v214 * v214 / w4
        v216, v217 = v215 + (v215 + v200 * abs(v210)), v6 * v211
        v218, v219, v220 = v206 + v217, v206 - v217, v6 * v212
        v221, v222, v223 = v207 + v220, v207 - v220, v6 * v213
        v224, v225, v226 = v208 + v223, v208 - v223, v205 * v209 + v216 * abs(v6)
        v227, v228, v229 = v13 * v218, v13 * v219, v13 * v221
        v230, v231, v232 = v13 * v222, v13 * v224, v13 * v225
        v233, v234 = v226 * abs(v13), v226 + math.sqrt(v218 * v218 + v221 * v221 + v224 * v224)
        v235, v236 = v226 + math.sqrt(v219 * v219 + v222 * v222 + v225 * v225), Z1_p * v227
        v237, v238, v239 = Z1_m * v228, Z1_p * v229, Z1_m * v230
        v240, v241, v242 = Z1_p * v231, Z1_m * v232, v18 * v233
        v243, v244 = v19 * v233, v233 + math.sqrt(v227 * v227 + v229 * v229 + v231 * v231)
        v245, v246 = v233 + math.sqrt(v228 * v228 + v230 * v230 + v232 * v232), v240 + v240
        v247, v248, v249 = v241 + v241, v181 + (v236 + v236), v181 + (v237 + v237)
        v250, v251 = v185 + (v238 + v238), v185 + (v239 + v239)
        v252, v253 = v189 + (v242 + v242 + v244 * v244), v189 + (v243 + v243 + v245 * v245)
        v254 = v252 + math.sqrt(v248 * v248 + v250 * v250 + v246 * v246)
        v255, v256 = v253 + math.sqrt(v249 * v249 + v251 * v251 + v247 * v247), abs(v38)
        v257, v258, v259 = inverse4 * (v38 * v202), inverse4 * (v38 * v203), inverse4 * (v38 * v204)
        v260, v261, v262 = v209 * (v205 * v256), T34 * v257, T34 * v258
        v263, v264 = T34 * v259 + v42 * given3, near_m2 * (inverse4 * (v38 * given3))
        v265 = v44 * v211
        v266, v267, v268 = v261 + v265, v261 - v265, v44 * v212
        v269, v270, v271 = v262 + v268, v262 - v268, v44 * v213 - w4 * v264
        v272, v273, v274 = v263 + v271, v263 + -v271, near1 / w1_p
        v275, v276 = near1 / w1_m, v248 * v274
        v277, v278, v279 = v249 * v275, v250 * v274, v251 * v275
        v280, v281, v282 = v246 * v274, v247 * v275, v254 * v274
        v283, v284 = v255 * v275, v282 * v282 / w1_p
        v285, v286 = v283 * v283 / w1_m, v284 + (v284 + v252 * abs(v274))
        v287, v288 = v285 + (v285 + v253 * abs(v275)), inverse4 * (near_k1 * v181)
        v289, v290, v291 = inverse4 * (near_k1 * v185), inverse4 * (near_k1 * v188), v9 * v211
        v292, v293, v294 = v288 - v291, v288 + v291, v9 * v212
        v295, v296, v297 = v289 - v294, v289 + v294, v9 * v213
        v298, v299, v300 = v290 - v297, v290 + v297, v209 * (near_k1 * v190) + v216 * abs(v9)
        v301, v302, v303 = near_d5 * v292, near_d5 * v293, near_d5 * v295
        v304, v305, v306 = near_d5 * v296, near_d5 * v298, near_d5 * v299
        v307, v308 = near_d5 * v300, v300 + math.sqrt(v292 * v292 + v295 * v295 + v298 * v298)
        v309, v310 = v300 + math.sqrt(v293 * v293 + v296 * v296 + v299 * v299), abs(w1_p)
        v311, v312 = abs(w1_m), v286 + math.sqrt(v276 * v276 + v278 * v278 + v280 * v280)
        v313 = v287 + math.sqrt(v277 * v277 + v279 * v279 + v281 * v281)
        v314 = math.sqrt(v301 * v301 + v303 * v303 + v305 * v305) - v307
        v315 = math.sqrt(v302 * v302 + v304 * v304 + v306 * v306) - v307
        v316, v317 = w1_p * v301 + v40 * v276, w1_m * v302 + v41 * v277
        v318, v319 = w1_p * v303 + v40 * v278, w1_m * v304 + v41 * v279
        v320, v321, v322 = w1_p * v305 + v40 * v280, w1_m * v306 + v41 * v281, v266 + v316
        v323, v324, v325 = v266 - v316, v267 + v317, v267 - v317
        v326, v327, v328 = v269 + v318, v269 - v318, v270 + v319
        v329, v330, v331 = v270 - v319, v272 + v320, v272 - v320
        v332, v333 = v273 + v321, v273 - v321
        v334 = (
            v187 * v260 + v180 * (v260 + math.sqrt(v257 * v257 + v258 * v258 + v259 * v259)) + (v216
            * abs(v44) + (v216 + math.sqrt(v211 * v211 + v212 * v212 + v213 * v213)) * abs(v264))
        )
        v335 = v334 + (v286 * abs(v40) - v307 * v310 + v312 * v314)
        v336 = v334 + (v287 * abs(v41) - v307 * v311 + v313 * v315)
        v337 = v335 + math.sqrt(v322 * v322 + v326 * v326 + v330 * v330)
        v338 = v335 + math.sqrt(v323 * v323 + v327 * v327 + v331 * v331)
        v339 = v336 + math.sqrt(v324 * v324 + v328 * v328 + v332 * v332)
        v340, v341 = v336 + math.sqrt(v325 * v325 + v329 * v329 + v333 * v333), v38 * v218
        v342, v343, v344 = v38 * v219, v38 * v221, v38 * v222
        v345, v346, v347 = v38 * v224, v38 * v225, v226 * v256
        v348, v349 = w1_p * v341 + v52 * v276, w1_m * v342 + v53 * v277
        v350, v351 = w1_p * v343 + v52 * v278, w1_m * v344 + v53 * v279
        v352, v353, v354 = w1_p * v345 + v52 * v280, w1_m * v346 + v53 * v281, T34 * v301
        v355, v356, v357 = T34 * v302, T34 * v303, T34 * v304
        v358, v359, v360 = T34 * v305 + v40 * given3, T34 * v306 + v41 * given3, v348 - v354
        v361, v362, v363 = v348 + v354, v349 - v355, v349 + v355
        v364, v365, v366 = v350 - v356, v350 + v356, v351 - v357
        v367, v368, v369 = v351 + v357, v352 - v358, v352 + v358
        v370, v371, v372 = v353 - v359, v353 + v359, v187 * v307
        v373 = (
            v310 * v347 + v286 * abs(v52) + v312 * (v347 + math.sqrt(v341 * v341 + v343 * v343 +
            v345 * v345)) + (v180 * v314 - v372)
        )
        v374 = (
            v311 * v347 + v287 * abs(v53) + v313 * (v347 + math.sqrt(v342 * v342 + v344 * v344 +
            v346 * v346)) + (v180 * v315 - v372)
        )
        v375 = v373 + math.sqrt(v360 * v360 + v364 * v364 + v368 * v368)
        v376 = v373 + math.sqrt(v361 * v361 + v365 * v365 + v369 * v369)
        v377 = v374 + math.sqrt(v362 * v362 + v366 * v366 + v370 * v370)
        v378, v379 = v374 + math.sqrt(v363 * v363 + v367 * v367 + v371 * v371), v337 * v337
        v380, v381, v382 = v338 * v338, v339 * v339, v340 * v340
        v383, v384, v385 = v375 * v375, v376 * v376, v377 * v377
        v386, v387, v388 = v378 * v378, v379 + v383, v380 + v384
        v389, v390, v391 = v381 + v385, v382 + v386, S2_pp * v322
        v392, v393, v394 = S2_pm * v323, S2_mp * v324, S2_mm * v325
        v395, v396, v397 = S2_pp * v326, S2_pm * v327, S2_mp * v328
        v398, v399, v400 = S2_mm * v329, S2_pp * v330, S2_pm * v331
        v401, v402, v403 = S2_mp * v332, S2_mm * v333, abs(S2_pp)
        v404, v405, v406 = abs(S2_pm), abs(S2_mp), abs(S2_mm)
        v407, v408, v409 = v335 * v403, v335 * v404, v336 * v405
        v410, v411, v412 = v336 * v406, C2_pp * v360, v56 * v361
        v413, v414, v415 = C2_mp * v362, v57 * v363, C2_pp * v364
        v416, v417, v418 = v56 * v365, C2_mp * v366, v57 * v367
        v419, v420, v421 = C2_pp * v368, v56 * v369, C2_mp * v370
        v422, v423, v424 = v57 * v371, abs(C2_pp), abs(v56)
        v425, v426, v427 = abs(C2_mp), abs(v57), v373 * v423
        v428, v429, v430 = v373 * v424, v374 * v425, v374 * v426
        v431, v432 = v391 + v391 + (v411 + v411), v392 + v392 + (v412 + v412)
        v433, v434 = v393 + v393 + (v413 + v413), v394 + v394 + (v414 + v414)
        v435, v436 = v395 + v395 + (v415 + v415), v396 + v396 + (v416 + v416)
        v437, v438 = v397 + v397 + (v417 + v417), v398 + v398 + (v418 + v418)
        v439, v440 = v399 + v399 + (v419 + v419), v400 + v400 + (v420 + v420)
        v441, v442 = v401 + v401 + (v421 + v421), v402 + v402 + (v422 + v422)
        v443 = v379 + (v407 + v407) + (v383 + (v427 + v427))
        v444 = v380 + (v408 + v408) + (v384 + (v428 + v428))
        v445 = v381 + (v409 + v409) + (v385 + (v429 + v429))
        v446, v447, v448 = v382 + (v410 + v410) + (v386 + (v430 + v430)), near1 / v62, near1 / v63
        v449, v450, v451 = near1 / v64, near1 / v65, v431 * v447
        v452, v453, v454 = v432 * v448, v433 * v449, v434 * v450
        v455, v456, v457 = v435 * v447, v436 * v448, v437 * v449
        v458, v459, v460 = v438 * v450, v439 * v447, v440 * v448
        v461, v462, v463 = v441 * v449, v442 * v450, v443 * abs(v447)
        v464, v465, v466 = v444 * abs(v448), v445 * abs(v449), v446 * abs(v450)
        v467, v468, v469 = abs(v66), abs(v67), abs(v68)
        v470, v471, v472 = abs(v69), v66 * (v66 * v431), v67 * (v67 * v432)
        v473, v474, v475 = v68 * (v68 * v433), v69 * (v69 * v434), v66 * (v66 * v435)
        v476, v477, v478 = v67 * (v67 * v436), v68 * (v68 * v437), v69 * (v69 * v438)
        v479, v480, v481 = v66 * (v66 * v439), v67 * (v67 * v440), v68 * (v68 * v441)
        v482, v483, v484 = v69 * (v69 * v442), v467 * (v443 * v467), v468 * (v444 * v468)
        v485, v486, v487 = v469 * (v445 * v469), v470 * (v446 * v470), v62 - math.sqrt(v387)
        v488, v489, v490 = v63 - math.sqrt(v388), v64 - math.sqrt(v389), v65 - math.sqrt(v390)
        v491 = (
            v483 + (v483 + (abs(v479) + (abs(v471) + abs(v475)))) * ((v443 + math.sqrt(v431 * v431 +
            v435 * v435 + v439 * v439)) / (v487 * v487))
        )
        v492 = (
            v484 + (v484 + (abs(v480) + (abs(v472) + abs(v476)))) * ((v444 + math.sqrt(v432 * v432 +
            v436 * v436 + v440 * v440)) / (v488 * v488))
        )
        v493 = (
            v485 + (v485 + (abs(v481) + (abs(v473) + abs(v477)))) * ((v445 + math.sqrt(v433 * v433 +
            v437 * v437 + v441 * v441)) / (v489 * v489))
        )
        v494 = (
            v486 + (v486 + (abs(v482) + (abs(v474) + abs(v478)))) * ((v446 + math.sqrt(v434 * v434 +
            v438 * v438 + v442 * v442)) / (v490 * v490))
        )
        v495, v496, v497 = v66 * v451 - v62 * v471, v67 * v452 - v63 * v472, v68 * v453 - v64 * v473
        v498, v499, v500 = v69 * v454 - v65 * v474, v66 * v455 - v62 * v475, v67 * v456 - v63 * v476
        v501, v502, v503 = v68 * v457 - v64 * v477, v69 * v458 - v65 * v478, v66 * v459 - v62 * v479
        v504, v505, v506 = v67 * v460 - v63 * v480, v68 * v461 - v64 * v481, v69 * v462 - v65 * v482
        v507 = (
            v491 * abs(v62) + v463 * v467 + (v463 + math.sqrt(v451 * v451 + v455 * v455 + v459 *
            v459)) * (v491 + math.sqrt(v471 * v471 + v475 * v475 + v479 * v479))
        )
        v508 = (
            v492 * abs(v63) + v464 * v468 + (v464 + math.sqrt(v452 * v452 + v456 * v456 + v460 *
            v460)) * (v492 + math.sqrt(v472 * v472 + v476 * v476 + v480 * v480))
        )
        v509 = (
            v493 * abs(v64) + v465 * v469 + (v465 + math.sqrt(v453 * v453 + v457 * v457 + v461 *
            v461)) * (v493 + math.sqrt(v473 * v473 + v477 * v477 + v481 * v481))
        )
        v510 = (
            v494 * abs(v65) + v466 * v470 + (v466 + math.sqrt(v454 * v454 + v458 * v458 + v462 *
            v462)) * (v494 + math.sqrt(v474 * v474 + v478 * v478 + v482 * v482))
        )
        v517, v518, v519 = T24 * v227, T24 * v228, T24 * v231
        v520, v521, v522 = T24 * v232, Z1_p * given3, Z1_m * given3
        v523, v524, v525 = v521 - T24 * v229, v522 - T24 * v230, v180 * v244
        v526, v527 = v180 * v245, v184 * v233
        v528, v529, v530 = v525 + v527, v526 + v527, inverse1 * v519
        v531, v532, v533 = inverse1 * v520, abs(v24), abs(v25)
        v535 = v528 + math.sqrt(v517 * v517 + v523 * v523 + v519 * v519)
        v536 = v529 + math.sqrt(v518 * v518 + v524 * v524 + v520 * v520)
        v537, v538 = inverse1 * v517 + v24 * v512, inverse1 * v518 + v25 * v512
        v539, v540 = inverse1 * v523 - v24 * v513, inverse1 * v524 - v25 * v513
        v541 = v511 * v528 + v516 * v532 + v534 * v535
        v542, v552 = v511 * v529 + v516 * v533 + v534 * v536, v26 * v276
        v553, v554, v555 = w1_p * v545 + v552 - v537, w1_p * -v545 - v552 - v537, v26 * v277
        v556, v557 = w1_m * v545 + v555 - v538, w1_m * -v545 - v555 - v538
        v558 = v26 * v278 - w1_p * v544
        v559, v560, v561 = v539 + v558, v539 + -v558, v26 * v279 - w1_m * v544
        v562, v563, v564 = v540 + v561, v540 + -v561, v26 * v280
        v565, v566, v567 = v564 - v530, v530 + v564, v26 * v281
        v568, v569, v570 = v567 - v531, v531 + v567, v310 * v547 + v286 * v548
        v571, v572 = v541 + (v570 + v312 * v550), v541 + (v570 + v312 * v551)
        v573 = v311 * v547 + v287 * v548
        v574, v575, v579 = v542 + (v573 + v313 * v550), v542 + (v573 + v313 * v551), s4_p * v576
        v580, v581, v582 = s4_m * v576, s4_p * v577, s4_m * v577
        v583, v584, v585 = v578 * abs(s4_p), v578 * abs(s4_m), T13 * v218
        v586, v587, v588 = T13 * v219, T13 * v221, T13 * v222
        v589, v590, v595 = T13 * v224, T13 * v225, v226 * v591
        v596, v597, v598 = v583 + v595 + v234 * v594, v584 + v595 + v235 * v594, abs(c1_pp)
        v599, v600, v601 = abs(c1_pm), abs(c1_mp), abs(c1_mm)
        v602, v603 = abs(v78), abs(v79)
        v604 = v571 + math.sqrt(v553 * v553 + v559 * v559 + v565 * v565)
        v605 = v572 + math.sqrt(v554 * v554 + v560 * v560 + v566 * v566)
        v606 = v574 + math.sqrt(v556 * v556 + v562 * v562 + v568 * v568)
        v607, v608 = v575 + math.sqrt(v557 * v557 + v563 * v563 + v569 * v569), v579 * v579
        v609 = v580 * v580
        v610 = (
            v596 + (math.sqrt(v608 + v581 * v581) + math.sqrt(v585 * v585 + v587 * v587 + v589 *
            v589))
        )
        v611 = (
            v597 + (math.sqrt(v609 + v582 * v582) + math.sqrt(v586 * v586 + v588 * v588 + v590 *
            v590))
        )
        v619, v620, v621 = T14 * v229, T14 * v230, T14 * v231
        v622, v623, v624 = T14 * v232, v521 - T14 * v227, v522 - T14 * v228
        v625 = v179 * v233
        v626, v627, v628 = v525 + v625, v526 + v625, inverse1 * v621
        v629, v630, v631 = inverse1 * v622, abs(v22), abs(v23)
        v632 = v626 + math.sqrt(v623 * v623 + v619 * v619 + v621 * v621)
        v633 = v627 + math.sqrt(v624 * v624 + v620 * v620 + v622 * v622)
        v634, v635 = inverse1 * v619 + v22 * v513, inverse1 * v620 + v23 * v513
        v636 = v511 * v626 + v516 * v630 + v534 * v632
        v637, v638 = v511 * v627 + v516 * v631 + v534 * v633, v22 * v512 - inverse1 * v623
        v639, v640 = v23 * v512 - inverse1 * v624, v31 * v276 - w1_p * v612
        v641, v642, v643 = v638 + v640, v638 + -v640, v31 * v277 - w1_m * v612
        v644, v645, v646 = v639 + v643, v639 + -v643, v31 * v278
        v647, v648, v649 = v634 + (w1_p * v613 + v646), v634 + (w1_p * -v613 - v646), v31 * v279
        v650, v651, v652 = v635 + (w1_m * v613 + v649), v635 + (w1_m * -v613 - v649), v31 * v280
        v653, v654, v655 = v628 + v652, v628 - v652, v31 * v281
        v656, v657, v658 = v629 + v655, v629 - v655, v310 * v614 + v286 * v615
        v659, v660 = v636 + (v658 + v312 * v617), v636 + (v658 + v312 * v618)
        v661 = v311 * v614 + v287 * v615
        v662, v663, v665 = v637 + (v661 + v313 * v617), v637 + (v661 + v313 * v618), s4_p * v664
        v666, v667, v668 = s4_m * v664, T23 * v218, T23 * v219
        v669, v670, v671 = T23 * v221, T23 * v222, T23 * v224
        v672, v676 = T23 * v225, v226 * v673
        v677, v678, v679 = v583 + v676 + v234 * v675, v584 + v676 + v235 * v675, abs(s1_pp)
        v680, v681, v682 = abs(v35), abs(s1_mp), abs(v37)
        v683, v684 = abs(v80), abs(v81)
        v685 = v659 + math.sqrt(v641 * v641 + v647 * v647 + v653 * v653)
        v686 = v660 + math.sqrt(v642 * v642 + v648 * v648 + v654 * v654)
        v687 = v662 + math.sqrt(v644 * v644 + v650 * v650 + v656 * v656)
        v688 = v663 + math.sqrt(v645 * v645 + v651 * v651 + v657 * v657)
        v689 = (
            v677 + (math.sqrt(v608 + v665 * v665) + math.sqrt(v667 * v667 + v669 * v669 + v671 *
            v671))
        )
        v690 = (
            v678 + (math.sqrt(v609 + v666 * v666) + math.sqrt(v668 * v668 + v670 * v670 + v672 *
            v672))
        )
        v691, v692 = s1_pp * v665 - c1_pp * v581, v35 * v665 + c1_pm * v581
        v693, v694, v695 = s1_mp * v666 - c1_mp * v582, v37 * v666 + c1_mm * v582, c3 * v577
        v696, v697 = c3 * v664, abs(c3)
        v698, v700, v701 = v578 * v697, v11 * v695, v12 * v695
        v702, v703, v704 = v11 * v696, v12 * v696, abs(v11)
        v705, v706 = abs(v12), v698 * v704
        v707, v708, v709 = v698 * v705, v82 * v292, v82 * v293
        v710, v711, v712 = v82 * v295, v82 * v296, v82 * v298
        v713, v714, v715 = v82 * v299, v695 * v695, v696 * v696
        v716, v717 = v698 + math.sqrt(v714 + v715), v300 * abs(v82)
        v718, v719, v720 = v706 + v717 + v308 * v716, v707 + v717 + v309 * v716, v700 + s1_pp * v579
        v721, v722, v723 = v700 - v35 * v579, v701 + s1_mp * v580, v701 - v37 * v580
        v724, v725, v726 = v702 + c1_pp * v579, v702 + c1_pm * v579, v703 + c1_mp * v580
        v727 = v703 + c1_mm * v580
        v728 = c1_pp * v585 + v78 * v553 + (s1_pp * v667 + v80 * v641) - v708
        v729 = c1_pm * v585 + v78 * v554 + (v80 * v642 - v35 * v667) - v708
        v730 = c1_mp * v586 + v79 * v556 + (s1_mp * v668 + v81 * v644) - v709
        v731 = c1_mm * v586 + v79 * v557 + (v81 * v645 - v37 * v668) - v709
        v732 = c1_pp * v587 + v78 * v559 + (s1_pp * v669 + v80 * v647) - v710
        v733 = c1_pm * v587 + v78 * v560 + (v80 * v648 - v35 * v669) - v710
        v734 = c1_mp * v588 + v79 * v562 + (s1_mp * v670 + v81 * v650) - v711
        v735 = c1_mm * v588 + v79 * v563 + (v81 * v651 - v37 * v670) - v711
        v736 = c1_pp * v589 + v78 * v565 + (s1_pp * v671 + v80 * v653) - v712
        v737 = c1_pm * v589 - v78 * v566 + (v80 * v654 - v35 * v671) - v712
        v738 = c1_mp * v590 + v79 * v568 + (s1_mp * v672 + v81 * v656) - v713
        v739 = c1_mm * v590 - v79 * v569 + (v81 * v657 - v37 * v672) - v713
        v740 = (
            v718 + (v596 * v598 + v571 * v602 + v604 * v610 + (v677 * v679 + v659 * v683 + v685 *
            v689))
        )
        v741 = (
            v718 + (v596 * v599 + v572 * v602 + v605 * v610 + (v677 * v680 + v660 * v683 + v686 *
            v689))
        )
        v742 = (
            v719 + (v597 * v600 + v574 * v603 + v606 * v611 + (v678 * v681 + v662 * v684 + v687 *
            v690))
        )
        v743 = (
            v719 + (v597 * v601 + v575 * v603 + v607 * v611 + (v678 * v682 + v663 * v684 + v688 *
            v690))
        )
        v744, v745, v746 = T33 * v218, T33 * v219, T33 * v221
        v747, v748, v749 = T33 * v222, T33 * v224, T33 * v225
        v750 = v226 * abs(T33)
        v751, v752, v753 = v583 + v750 + v234 * v699, v584 + v750 + v235 * v699, c3 * v576
        v754, v755, v756 = v11 * v753, v12 * v753, v70 * v292
        v757, v758, v759 = v70 * v293, v70 * v295, v70 * v296
        v760, v761, v762 = v70 * v298, v70 * v299, v753 * v753
        v763, v764 = v698 + math.sqrt(v714 + v762), v300 * abs(v70)
        v765, v766, v767 = v706 + v764 + v308 * v763, v707 + v764 + v309 * v763, abs(v71)
        v768, v769, v770 = abs(v72), v754 * v754, v755 * v755
        v771 = (
            v765 + (math.sqrt(v769 + v700 * v700) + math.sqrt(v756 * v756 + v758 * v758 + v760 *
            v760))
        )
        v772 = (
            v766 + (math.sqrt(v770 + v701 * v701) + math.sqrt(v757 * v757 + v759 * v759 + v761 *
            v761))
        )
        v773, v774, v775 = v73 * v292, v73 * v293, v73 * v295
        v776, v777, v778 = v73 * v296, v73 * v298, v73 * v299
        v779, v780 = v698 + math.sqrt(v715 + v762), v300 * abs(v73)
        v781, v782, v783 = v706 + v780 + v308 * v779, v707 + v780 + v309 * v779, abs(v74)
        v784 = abs(v75)
        v785 = (
            v781 + (math.sqrt(v769 + v702 * v702) + math.sqrt(v773 * v773 + v775 * v775 + v777 *
            v777))
        )
        v786 = (
            v782 + (math.sqrt(v770 + v703 * v703) + math.sqrt(v774 * v774 + v776 * v776 + v778 *
            v778))
        )
        v787, v788 = s1_pp * v702 - c1_pp * v700, v35 * v702 + c1_pm * v700
        v789, v790 = s1_mp * v703 - c1_mp * v701, v37 * v703 + c1_mm * v701
        v791, v792, v793 = v581 - s1_pp * v754, v581 + v35 * v754, v582 - s1_mp * v755
        v794, v795, v796 = v582 + v37 * v755, c1_pp * v754 - v665, c1_pm * v754 - v665
        v797, v798 = c1_mp * v755 - v666, c1_mm * v755 - v666
        v799 = v744 + (c1_pp * v756 + v71 * v553 + (s1_pp * v773 + v74 * v641))
        v800 = v744 + (c1_pm * v756 + v71 * v554 + (v74 * v642 - v35 * v773))
        v801 = v745 + (c1_mp * v757 + v72 * v556 + (s1_mp * v774 + v75 * v644))
        v802 = v745 + (c1_mm * v757 + v72 * v557 + (v75 * v645 - v37 * v774))
        v803 = v746 + (c1_pp * v758 + v71 * v559 + (s1_pp * v775 + v74 * v647))
        v804 = v746 + (c1_pm * v758 + v71 * v560 + (v74 * v648 - v35 * v775))
        v805 = v747 + (c1_mp * v759 + v72 * v562 + (s1_mp * v776 + v75 * v650))
        v806 = v747 + (c1_mm * v759 + v72 * v563 + (v75 * v651 - v37 * v776))
        v807 = v748 + (c1_pp * v760 + v71 * v565 + (s1_pp * v777 + v74 * v653))
        v808 = v748 + (c1_pm * v760 - v71 * v566 + (v74 * v654 - v35 * v777))
        v809 = v749 + (c1_mp * v761 + v72 * v568 + (s1_mp * v778 + v75 * v656))
        v810 = v749 + (c1_mm * v761 - v72 * v569 + (v75 * v657 - v37 * v778))
        v811 = (
            v751 + (v598 * v765 + v571 * v767 + v604 * v771 + (v679 * v781 + v659 * v783 + v685 *
            v785))
        )
        v812 = (
            v751 + (v599 * v765 + v572 * v767 + v605 * v771 + (v680 * v781 + v660 * v783 + v686 *
            v785))
        )
        v813 = (
            v752 + (v600 * v766 + v574 * v768 + v606 * v772 + (v681 * v782 + v662 * v784 + v687 *
            v786))
        )
        v814 = (
            v752 + (v601 * v766 + v575 * v768 + v607 * v772 + (v682 * v782 + v663 * v784 + v688 *
            v786))
        )
        v815, v816 = S2_pp * v720 + C2_pp * v791, S2_pm * v721 - v56 * v792
        v817, v818 = S2_mp * v722 + C2_mp * v793, S2_mm * v723 - v57 * v794
        v819, v820 = S2_pp * v724 - C2_pp * v795, S2_pm * v725 + v56 * v796
        v821, v822 = S2_mp * v726 - C2_mp * v797, S2_mm * v727 + v57 * v798
        v823, v824 = S2_pp * v691 - C2_pp * v787, S2_pm * v692 + v56 * v788
        v825, v826 = S2_mp * v693 - C2_mp * v789, S2_mm * v694 + v57 * v790
        v827 = S2_pp * v728 + v98 * v322 - (C2_pp * v799 + v102 * v360)
        v828 = S2_pm * v729 + v99 * v323 + (v56 * v800 + v103 * v361)
        v829 = S2_mp * v730 + v100 * v324 - (C2_mp * v801 + v104 * v362)
        v830 = S2_mm * v731 + v101 * v325 + (v57 * v802 + v105 * v363)
        v831 = S2_pp * v732 + v98 * v326 - (C2_pp * v803 + v102 * v364)
        v832 = S2_pm * v733 + v99 * v327 + (v56 * v804 + v103 * v365)
        v833 = S2_mp * v734 + v100 * v328 - (C2_mp * v805 + v104 * v366)
        v834 = S2_mm * v735 + v101 * v329 + (v57 * v806 + v105 * v367)
        v835 = S2_pp * v736 + v98 * v330 - (C2_pp * v807 + v102 * v368)
        v836 = S2_pm * v737 + v99 * v331 + (v56 * v808 + v103 * v369)
        v837 = S2_mp * v738 + v100 * v332 - (C2_mp * v809 + v104 * v370)
        v838 = S2_mm * v739 + v101 * v333 + (v57 * v810 + v105 * v371)
        v839 = (
            v403 * v740 + v335 * abs(v98) + v337 * (v740 + (math.sqrt(v720 * v720 + v724 * v724 +
            v691 * v691) + math.sqrt(v728 * v728 + v732 * v732 + v736 * v736))) + (v423 * v811 +
            v373 * abs(v102) + v375 * (v811 + (math.sqrt(v791 * v791 + v795 * v795 + v787 * v787) +
            math.sqrt(v799 * v799 + v803 * v803 + v807 * v807))))
        )
        v840 = (
            v404 * v741 + v335 * abs(v99) + v338 * (v741 + (math.sqrt(v721 * v721 + v725 * v725 +
            v692 * v692) + math.sqrt(v729 * v729 + v733 * v733 + v737 * v737))) + (v424 * v812 +
            v373 * abs(v103) + v376 * (v812 + (math.sqrt(v792 * v792 + v796 * v796 + v788 * v788) +
            math.sqrt(v800 * v800 + v804 * v804 + v808 * v808))))
        )
        v841 = (
            v405 * v742 + v336 * abs(v100) + v339 * (v742 + (math.sqrt(v722 * v722 + v726 * v726 +
            v693 * v693) + math.sqrt(v730 * v730 + v734 * v734 + v738 * v738))) + (v425 * v813 +
            v374 * abs(v104) + v377 * (v813 + (math.sqrt(v793 * v793 + v797 * v797 + v789 * v789) +
            math.sqrt(v801 * v801 + v805 * v805 + v809 * v809))))
        )
        v842 = (
            v406 * v743 + v336 * abs(v101) + v340 * (v743 + (math.sqrt(v723 * v723 + v727 * v727 +
            v694 * v694) + math.sqrt(v731 * v731 + v735 * v735 + v739 * v739))) + (v426 * v814 +
            v374 * abs(v105) + v378 * (v814 + (math.sqrt(v794 * v794 + v798 * v798 + v790 * v790) +
            math.sqrt(v802 * v802 + v806 * v806 + v810 * v810))))
        )
        v843, v844, v845 = abs(factor2_pp), abs(factor2_pm), abs(factor2_mp)
        v846, v847 = abs(factor2_mm), v507 + math.sqrt(v495 * v495 + v499 * v499 + v503 * v503)
        v848 = v508 + math.sqrt(v496 * v496 + v500 * v500 + v504 * v504)
        v849 = v509 + math.sqrt(v497 * v497 + v501 * v501 + v505 * v505)
        v850, v851 = v510 + math.sqrt(v498 * v498 + v502 * v502 + v506 * v506), s3 * (T14 * v576)
        v852, v853, v854 = s3 * (T24 * v576), s3 * (T24 * v577 + T14 * v664), s3 * (T23 * given3)
        v855, v856 = s3 * (T13 * given3), abs(s3)
        v857 = v856 * (v184 * v578 + v180 * v594 + (v179 * v578 + v180 * v675))
        v858, v859, v860 = inverse1 * v851, inverse1 * v852, inverse1 * v853
        v861, v862 = v511 * v857, inverse1 * v854
        v863, v864, v865 = v862 + v86 * v512, v87 * v512 - v862, inverse1 * v855
        v866, v867 = v865 - v86 * v513, v865 + v87 * v513
        v868 = (
            v534 * (v857 + (math.sqrt(v851 * v851 + v852 * v852 + v853 * v853) + math.sqrt(v854 *
            v854 + v855 * v855)))
        )
        v869, v870, v871 = v861 + v516 * abs(v86) + v868, v868 + (v861 + v516 * abs(v87)), abs(v88)
        v872, v873 = abs(v89), math.sqrt(v858 * v858 + v859 * v859 + v860 * v860)
        v874 = v869 + (v873 + math.sqrt(v863 * v863 + v866 * v866))
        v875, v876 = v870 + (v873 + math.sqrt(v864 * v864 + v867 * v867)), s3 * (v24 * v576)
        v877, v878, v879 = s3 * (v25 * v576), s3 * (v22 * v576), s3 * (v23 * v576)
        v880, v881 = s3 * (v24 * v664 - v22 * v577), s3 * (v25 * v664 - v23 * v577)
        v882, v883 = s3 * (T13 * v623 - T23 * v517), s3 * (T13 * v624 - T23 * v518)
        v884, v885 = s3 * (T23 * v523 - T13 * v619), s3 * (T23 * v524 - T13 * v620)
        v886, v887 = s3 * (T13 * v621 + T23 * v519), s3 * (T13 * v622 + T23 * v520)
        v888 = (
            v856 * (v578 * v630 + v591 * v626 + v594 * v632 + (v532 * v578 + v528 * v673 + v535 *
            v675))
        )
        v889 = (
            v856 * (v578 * v631 + v591 * v627 + v594 * v633 + (v533 * v578 + v529 * v673 + v536 *
            v675))
        )
        v890, v891, v892 = inverse1 * v876, inverse1 * v877, inverse1 * v878
        v893, v894, v895 = inverse1 * v879, inverse1 * v880, inverse1 * v881
        v896, v897 = inverse1 * v886, inverse1 * v887
        v898 = (
            v511 * v888 + v516 * abs(v90) + v534 * (v888 + (math.sqrt(v876 * v876 + v878 * v878 +
            v880 * v880) + math.sqrt(v882 * v882 + v884 * v884 + v886 * v886)))
        )
        v899 = (
            v511 * v889 + v516 * abs(v91) + v534 * (v889 + (math.sqrt(v877 * v877 + v879 * v879 +
            v881 * v881) + math.sqrt(v883 * v883 + v885 * v885 + v887 * v887)))
        )
        v900 = w1_p * v858
        v901, v902, v903 = v890 + v900, v890 - v900, w1_m * v858
        v904, v905, v906 = v891 + v903, v891 - v903, w1_p * v859
        v907, v908, v909 = v906 - v892, v892 + v906, w1_m * v859
        v910, v911, v912 = v909 - v893, v893 + v909, w1_p * v860
        v913, v914, v915 = v894 + v912, v894 - v912, w1_m * v860
        v916, v917, v918 = v895 + v915, v895 - v915, v90 * v512 - inverse1 * v882
        v919, v920 = v91 * v512 - inverse1 * v883, v918 + (v88 * v276 - w1_p * v863)
        v921, v922 = v918 + (v89 * v276 - w1_p * v864), v919 + (v88 * v277 - w1_m * v863)
        v923, v924 = v919 + (v89 * v277 - w1_m * v864), v90 * v513 - inverse1 * v884
        v925, v926 = v91 * v513 - inverse1 * v885, v924 + (w1_p * v866 + v88 * v278)
        v927, v928 = v924 + (v89 * v278 - w1_p * v867), v925 + (w1_m * v866 + v88 * v279)
        v929, v930, v931 = v925 + (v89 * v279 - w1_m * v867), v896 + v88 * v280, v896 + v89 * v280
        v932, v933 = v897 + v88 * v281, v897 + v89 * v281
        v934 = v898 + (v310 * v869 + v286 * v871 + v312 * v874)
        v935 = v898 + (v310 * v870 + v286 * v872 + v312 * v875)
        v936 = v899 + (v311 * v869 + v287 * v871 + v313 * v874)
        v937 = v899 + (v311 * v870 + v287 * v872 + v313 * v875)
        v938, v939 = factor2_pp * v815 + v11 * v901, factor2_pm * v816 + v11 * v902
        v940, v941 = factor2_mp * v817 + v12 * v904, factor2_mm * v818 + v12 * v905
        v942, v943 = factor2_pp * v819 - v11 * v907, factor2_pm * v820 + v11 * v908
        v944, v945 = factor2_mp * v821 - v12 * v910, factor2_mm * v822 + v12 * v911
        v946, v947 = factor2_pp * v823 + v11 * v913, v11 * v914 - factor2_pm * v824
        v948, v949 = factor2_mp * v825 + v12 * v916, v12 * v917 - factor2_mm * v826
        v950 = factor2_pp * v827 + v106 * v495 - (v11 * v920 + v94 * v292)
        v951 = factor2_pm * v828 + v107 * v496 - (v11 * v921 + v95 * v292)
        v952 = factor2_mp * v829 + v108 * v497 - (v12 * v922 + v96 * v293)
        v953 = factor2_mm * v830 + v109 * v498 - (v12 * v923 + v97 * v293)
        v954 = factor2_pp * v831 + v106 * v499 - (v11 * v926 + v94 * v295)
        v955 = factor2_pm * v832 + v107 * v500 - (v11 * v927 + v95 * v295)
        v956 = factor2_mp * v833 + v108 * v501 - (v12 * v928 + v96 * v296)
        v957 = factor2_mm * v834 + v109 * v502 - (v12 * v929 + v97 * v296)
        v958 = factor2_pp * v835 + v106 * v503 - (v11 * v930 + v94 * v298)
        v959 = factor2_pm * v836 + v107 * v504 - (v11 * v931 + v95 * v298)
        v960 = factor2_mp * v837 + v108 * v505 - (v12 * v932 + v96 * v299)
        v961 = factor2_mm * v838 + v109 * v506 - (v12 * v933 + v97 * v299)
        v962 = (
            v839 * v843 + v507 * abs(v106) + v847 * (v839 + (math.sqrt(v815 * v815 + v819 * v819 +
            v823 * v823) + math.sqrt(v827 * v827 + v831 * v831 + v835 * v835))) + (v704 * v934 +
            v300 * abs(v94) + v308 * (v934 + (math.sqrt(v901 * v901 + v907 * v907 + v913 * v913) +
            math.sqrt(v920 * v920 + v926 * v926 + v930 * v930)))) + (math.sqrt(v938 * v938 + v942 *
            v942 + v946 * v946) + math.sqrt(v950 * v950 + v954 * v954 + v958 * v958))
        )
        v963 = (
            v840 * v844 + v508 * abs(v107) + v848 * (v840 + (math.sqrt(v816 * v816 + v820 * v820 +
            v824 * v824) + math.sqrt(v828 * v828 + v832 * v832 + v836 * v836))) + (v704 * v935 +
            v300 * abs(v95) + v308 * (v935 + (math.sqrt(v902 * v902 + v908 * v908 + v914 * v914) +
            math.sqrt(v921 * v921 + v927 * v927 + v931 * v931)))) + (math.sqrt(v939 * v939 + v943 *
            v943 + v947 * v947) + math.sqrt(v951 * v951 + v955 * v955 + v959 * v959))
        )
        v964 = (
            v841 * v845 + v509 * abs(v108) + v849 * (v841 + (math.sqrt(v817 * v817 + v821 * v821 +
            v825 * v825) + math.sqrt(v829 * v829 + v833 * v833 + v837 * v837))) + (v705 * v936 +
            v300 * abs(v96) + v309 * (v936 + (math.sqrt(v904 * v904 + v910 * v910 + v916 * v916) +
            math.sqrt(v922 * v922 + v928 * v928 + v932 * v932)))) + (math.sqrt(v940 * v940 + v944 *
            v944 + v948 * v948) + math.sqrt(v952 * v952 + v956 * v956 + v960 * v960))
        )
        v965 = (
            v842 * v846 + v510 * abs(v109) + v850 * (v842 + (math.sqrt(v818 * v818 + v822 * v822 +
            v826 * v826) + math.sqrt(v830 * v830 + v834 * v834 + v838 * v838))) + (v705 * v937 +
            v300 * abs(v97) + v309 * (v937 + (math.sqrt(v905 * v905 + v911 * v911 + v917 * v917) +
            math.sqrt(v923 * v923 + v929 * v929 + v933 * v933)))) + (math.sqrt(v941 * v941 + v945 *
            v945 + v949 * v949) + math.sqrt(v953 * v953 + v957 * v957 + v961 * v961))
        )
        v966, v967, v968 = c1_pp * v576, c1_pm * v576, c1_mp * v576
        v969, v970, v971 = c1_mm * v576, v578 * v598, v578 * v599
        v972, v973, v974 = v578 * v600, v578 * v601, s1_pp * v576
        v975, v976, v977 = v35 * v576, s1_mp * v576, v37 * v576
        v978, v979, v980 = v578 * v679, v578 * v680, v578 * v681
        v981, v982, v983 = v578 * v682, s3 * v974, s3 * v975
        v984, v985, v986 = s3 * v976, s3 * v977, s3 * v966
        v987, v988, v989 = s3 * v967, s3 * v968, s3 * v969
        v990, v991 = s3 * (s1_pp * v664 - c1_pp * v577), s3 * (v35 * v664 + c1_pm * v577)
        v992, v993 = s3 * (s1_mp * v664 - c1_mp * v577), s3 * (v37 * v664 + c1_mm * v577)
        v994, v995 = s3 * (T13 * v553 + T23 * v641), s3 * (T13 * v554 + T23 * v642)
        v996, v997 = s3 * (T13 * v556 + T23 * v644), s3 * (T13 * v557 + T23 * v645)
        v998, v999 = s3 * (T13 * v559 + T23 * v647), s3 * (T13 * v560 + T23 * v648)
        v1000, v1001 = s3 * (T13 * v562 + T23 * v650), s3 * (T13 * v563 + T23 * v651)
        v1002, v1003 = s3 * (T13 * v565 + T23 * v653), s3 * (T23 * v654 - T13 * v566)
        v1004, v1005 = s3 * (T13 * v568 + T23 * v656), s3 * (T23 * v657 - T13 * v569)
        v1006 = v856 * (v970 + v571 * v591 + v594 * v604 + (v978 + v659 * v673 + v675 * v685))
        v1007 = v856 * (v971 + v572 * v591 + v594 * v605 + (v979 + v660 * v673 + v675 * v686))
        v1008 = v856 * (v972 + v574 * v591 + v594 * v606 + (v980 + v662 * v673 + v675 * v687))
        v1009 = v856 * (v973 + v575 * v591 + v594 * v607 + (v981 + v663 * v673 + v675 * v688))
        v1010, v1011, v1012 = C2_pp * v990, v56 * v991, C2_mp * v992
        v1013, v1014, v1015 = v57 * v993, s3 * v577, s3 * v664
        v1016, v1017 = v578 * v856, abs(v110)
        v1018, v1019 = v335 * v1017, v336 * v1017
        v1020 = v1016 + math.sqrt(v1014 * v1014 + v1015 * v1015)
        v1021, v1022 = S2_pp * v1014 - C2_pp * v982, S2_pm * v1014 - v56 * v983
        v1023, v1024 = S2_mp * v1014 - C2_mp * v984, S2_mm * v1014 - v57 * v985
        v1025, v1026 = C2_pp * v986 - S2_pp * v1015, v56 * v987 + S2_pm * v1015
        v1027, v1028 = C2_mp * v988 - S2_mp * v1015, v57 * v989 + S2_mm * v1015
        v1029 = C2_pp * v994 + v111 * v360 + v110 * v322
        v1030 = v110 * v323 - (v56 * v995 + v112 * v361)
        v1031 = C2_mp * v996 + v113 * v362 + v110 * v324
        v1032 = v110 * v325 - (v57 * v997 + v114 * v363)
        v1033 = C2_pp * v998 + v111 * v364 + v110 * v326
        v1034 = v110 * v327 - (v56 * v999 + v112 * v365)
        v1035 = C2_mp * v1000 + v113 * v366 + v110 * v328
        v1036 = v110 * v329 - (v57 * v1001 + v114 * v367)
        v1037 = C2_pp * v1002 + v111 * v368 + v110 * v330
        v1038 = v110 * v331 - (v56 * v1003 + v112 * v369)
        v1039 = C2_mp * v1004 + v113 * v370 + v110 * v332
        v1040 = v110 * v333 - (v57 * v1005 + v114 * v371)
        v1041 = (
            v423 * v1006 + v373 * abs(v111) + v375 * (v1006 + (math.sqrt(v982 * v982 + v986 * v986 +
            v990 * v990) + math.sqrt(v994 * v994 + v998 * v998 + v1002 * v1002))) + (v1018 + v403 *
            v1016 + v337 * v1020)
        )
        v1042 = (
            v424 * v1007 + v373 * abs(v112) + v376 * (v1007 + (math.sqrt(v983 * v983 + v987 * v987 +
            v991 * v991) + math.sqrt(v995 * v995 + v999 * v999 + v1003 * v1003))) + (v1018 + v404 *
            v1016 + v338 * v1020)
        )
        v1043 = (
            v425 * v1008 + v374 * abs(v113) + v377 * (v1008 + (math.sqrt(v984 * v984 + v988 * v988 +
            v992 * v992) + math.sqrt(v996 * v996 + v1000 * v1000 + v1004 * v1004))) + (v1019 + v405
            * v1016 + v339 * v1020)
        )
        v1044 = (
            v426 * v1009 + v374 * abs(v114) + v378 * (v1009 + (math.sqrt(v985 * v985 + v989 * v989 +
            v993 * v993) + math.sqrt(v997 * v997 + v1001 * v1001 + v1005 * v1005))) + (v1019 + v406
            * v1016 + v340 * v1020)
        )
        v1045, v1046 = factor2_pp * v1021 - c3 * v966, factor2_pm * v1022 - c3 * v967
        v1047, v1048 = factor2_mp * v1023 - c3 * v968, factor2_mm * v1024 - c3 * v969
        v1049, v1050 = factor2_pp * v1025 - c3 * v974, c3 * v975 - factor2_pm * v1026
        v1051, v1052 = factor2_mp * v1027 - c3 * v976, c3 * v977 - factor2_mm * v1028
        v1053 = factor2_pp * v1010 + c3 * (s1_pp * v577 + c1_pp * v664)
        v1054 = factor2_pm * v1011 + c3 * (c1_pm * v664 - v35 * v577)
        v1055 = factor2_mp * v1012 + c3 * (s1_mp * v577 + c1_mp * v664)
        v1056 = factor2_mm * v1013 + c3 * (c1_mm * v664 - v37 * v577)
        v1057 = factor2_pp * v1029 + v115 * v495 - c3 * (T13 * v641 - T23 * v553)
        v1058 = factor2_pm * v1030 + v116 * v496 - c3 * (T13 * v642 - T23 * v554)
        v1059 = factor2_mp * v1031 + v117 * v497 - c3 * (T13 * v644 - T23 * v556)
        v1060 = factor2_mm * v1032 + v118 * v498 - c3 * (T13 * v645 - T23 * v557)
        v1061 = factor2_pp * v1033 + v115 * v499 - c3 * (T13 * v647 - T23 * v559)
        v1062 = factor2_pm * v1034 + v116 * v500 - c3 * (T13 * v648 - T23 * v560)
        v1063 = factor2_mp * v1035 + v117 * v501 - c3 * (T13 * v650 - T23 * v562)
        v1064 = factor2_mm * v1036 + v118 * v502 - c3 * (T13 * v651 - T23 * v563)
        v1065 = factor2_pp * v1037 + v115 * v503 - c3 * (T13 * v653 - T23 * v565)
        v1066 = factor2_pm * v1038 + v116 * v504 - c3 * (T13 * v654 + T23 * v566)
        v1067 = factor2_mp * v1039 + v117 * v505 - c3 * (T13 * v656 - T23 * v568)
        v1068 = factor2_mm * v1040 + v118 * v506 - c3 * (T13 * v657 + T23 * v569)
        v1069 = (
            v843 * v1041 + v507 * abs(v115) + v847 * (v1041 + (math.sqrt(v1021 * v1021 + v1025 *
            v1025 + v1010 * v1010) + math.sqrt(v1029 * v1029 + v1033 * v1033 + v1037 * v1037))) +
            v697 * (v978 + v591 * v659 + v594 * v685 + (v970 + v571 * v673 + v604 * v675)) +
            (math.sqrt(v1045 * v1045 + v1049 * v1049 + v1053 * v1053) + math.sqrt(v1057 * v1057 +
            v1061 * v1061 + v1065 * v1065))
        )
        v1070 = (
            v844 * v1042 + v508 * abs(v116) + v848 * (v1042 + (math.sqrt(v1022 * v1022 + v1026 *
            v1026 + v1011 * v1011) + math.sqrt(v1030 * v1030 + v1034 * v1034 + v1038 * v1038))) +
            v697 * (v979 + v591 * v660 + v594 * v686 + (v971 + v572 * v673 + v605 * v675)) +
            (math.sqrt(v1046 * v1046 + v1050 * v1050 + v1054 * v1054) + math.sqrt(v1058 * v1058 +
            v1062 * v1062 + v1066 * v1066))
        )
        v1071 = (
            v845 * v1043 + v509 * abs(v117) + v849 * (v1043 + (math.sqrt(v1023 * v1023 + v1027 *
            v1027 + v1012 * v1012) + math.sqrt(v1031 * v1031 + v1035 * v1035 + v1039 * v1039))) +
            v697 * (v980 + v591 * v662 + v594 * v687 + (v972 + v574 * v673 + v606 * v675)) +
            (math.sqrt(v1047 * v1047 + v1051 * v1051 + v1055 * v1055) + math.sqrt(v1059 * v1059 +
            v1063 * v1063 + v1067 * v1067))
        )
        v1072 = (
            v846 * v1044 + v510 * abs(v118) + v850 * (v1044 + (math.sqrt(v1024 * v1024 + v1028 *
            v1028 + v1013 * v1013) + math.sqrt(v1032 * v1032 + v1036 * v1036 + v1040 * v1040))) +
            v697 * (v981 + v591 * v663 + v594 * v688 + (v973 + v575 * v673 + v607 * v675)) +
            (math.sqrt(v1048 * v1048 + v1052 * v1052 + v1056 * v1056) + math.sqrt(v1060 * v1060 +
            v1064 * v1064 + v1068 * v1068))
        )

        # a joint is free, or branches meet
        kept[19 * w + k] = (
            1.0 if abs(N1) <= v189 or abs(v201 + (D4_squared + D4_squared)) <= v201 or abs(v177) <=
            2.0 * v196 or abs(v122) <= v965 * v965 + v1072 * v1072 or abs(v61) <= v390 or abs(v121)
            <= v964 * v964 + v1071 * v1071 or abs(v60) <= v389 or abs(v120) <= v963 * v963 + v1070 *
            v1070 or abs(v59) <= v388 or abs(v119) <= v962 * v962 + v1069 * v1069 or abs(v58) <=
            v387 or N1 <= near_doubt_limit_squared2 or v61 <= near_m4 or v60 <= near_m4 or v59 <=
            near_m4 or v58 <= near_m4 or abs(v255 + (D1_squared_m + D1_squared_m)) <= v255 or
            abs(D1_squared_m * v15) <= near_m3 * v21 or abs(v254 + (D1_squared_p + D1_squared_p)) <=
            v254 or abs(D1_squared_p * v15) <= near_m3 * v20 or N4 <= near_doubt_limit_squared4 or
            v122 <= near_m5 or v121 <= near_m5 or v120 <= near_m5 or v119 <= near_m5 or abs(v21) <=
            2.0 * v245 or abs(D4_squared) <= near_m1 * v177 or abs(v20) <= 2.0 * v244 else kept[19 *
            w + k]
        )
        kept[63 * w + k], kept[64 * w + k], kept[65 * w + k] = v16, v17, Y5_pp
        kept[66 * w + k], kept[67 * w + k], kept[68 * w + k] = Y5_pm, Y5_mp, Y5_mm
        kept[69 * w + k], kept[70 * w + k], kept[71 * w + k] = s7_pp, s7_pm, s7_mp
        kept[72 * w + k], kept[73 * w + k], kept[74 * w + k] = s7_mm, q3_ppp, q3_mpp
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
    if w == 1 and kept[19] != 0.0:
        return
    end = 26 if w == 1 else 24 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(24 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(2 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        v16, v17, Y5_pp = kept[63 * w + k], kept[64 * w + k], kept[65 * w + k]
        Y5_pm, Y5_mp, Y5_mm = kept[66 * w + k], kept[67 * w + k], kept[68 * w + k]
        s7_pp, s7_pm, s7_mp = kept[69 * w + k], kept[70 * w + k], kept[71 * w + k]
        s7_mm, q3_ppp, q3_mpp = kept[72 * w + k], kept[73 * w + k], kept[74 * w + k]
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
        q4_ppp, q4_mpp = v16 + angle21, v17 + angle22

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
        rows[36 * w + k] = rows[37 * w + k] = UNREACHABLE if angle1 != angle1 else OK
        rows[38 * w + k] = rows[39 * w + k] = UNREACHABLE if angle2 != angle2 else OK
        rows[40 * w + k] = rows[41 * w + k] = UNREACHABLE if angle3 != angle3 else OK
        rows[42 * w + k] = rows[43 * w + k] = UNREACHABLE if angle4 != angle4 else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 75, 50, [
    [0, 1, 2, 3, 4, 5, 6], [0, 1, 2, 3, 7, 8, 9], [10, 11, 2, 3, 12, 13, 14],
    [10, 11, 2, 3, 15, 16, 17], [18, 19, 20, 21, 22, 23, 24], [18, 19, 20, 21, 25, 26, 27],
    [28, 29, 20, 21, 30, 31, 32], [28, 29, 20, 21, 33, 34, 35],
])

_solve_from_nearest, _to_nearest_rows = _nearest.of_nearest(
    _HOW,
    _NUMBERS,
    _FORMULAS,
    _nearest.Nearest(
        turned=2e-10, moved=0.0005250002,
        left=(1.0, 0.0, 0.0, -0.0, 0.0, -1.0, 0.0, -0.0, 0.0, 0.0, -1.0, 0.28481),
        right=(1.0, 0.0, 0.0, -0.0, -0.0, 1.0, 0.0, -0.0, 0.0, -0.0, 1.0, 0.10593),
        offsets=(0.0, 0.0, 0.0, 0.0, 0.0, 0.0), solved=(0, 1, 3, 4, 5, 6),
        links=(
            (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
            (
                1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0,
                6.123233995736766e-17, 0.0,
            ),
            (
                1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0,
                6.123233995736766e-17, -0.01175,
            ),
            (
                1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0,
                6.123233995736766e-17, -0.42076,
            ),
            (
                1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0,
                6.123233995736766e-17, -0.01275,
            ),
            (
                1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0,
                6.123233995736766e-17, -0.31436,
            ),
            (
                1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0,
                6.123233995736766e-17, 0.0,
            ),
            (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
        ),
        angles=(
            (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
            (0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3.141592653589793),
            (0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 3.141592653589793),
            (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 3.141592653589793),
            (0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 3.141592653589793),
            (0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 3.141592653589793),
            (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 3.141592653589793),
        ),
    ),
    1,
)


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    if _solve_from_nearest(pose, q_free, q, status):
        return
    _all_joints(_NUMBERS, pose, q_free, seed, q, status)
    _to_nearest_rows(q_free, q, status)


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "pose", given=1, apart=(_whole.compile_apart,), at_once=True,
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
