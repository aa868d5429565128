# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 4de49b258340e29c
"""puma560_calibrated: PUMA 560 with calibration noise of 1e-3.

Inverse kinematics, generated from robots/puma560_calibrated.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/puma560_calibrated.yaml. The formulas and where they come from:
puma560_calibrated.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 6), _runtime("arrays").zeros

NAME = "puma560_calibrated"
METHOD = "general 6R"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "right-down-noflip", "right-down-flip", "right-up-noflip", "right-up-flip", "left-up-noflip",
    "left-up-flip", "left-down-noflip", "left-down-flip", "further1", "further2", "further3",
    "further4", "further5", "further6", "further7", "further8",
)
MAX_SOLUTIONS = 16

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, near_arm_size1 = 1.0332489194603163 [m], near_a2 = 0.4314454936115 [m],
# near_a3 = -0.020185839855499987 [m], near_d4 = 0.4326956882369999 [m],
# near_k5 = 2 * near_d4 * near_a2 = 0.3733692095899602 [m^2],
# near_k6 = 2 * near_a3 * near_a2 = -0.01741817928083776 [m^2],
# near_k3 = 3.0774677988139795e-15 [m^2], near_longest3_apart = 0.7475535203061898 [m^2],
# near_k8 = 1 / ((2 * near_d4 * near_a2)^2 + (2 * near_a3 * near_a2)^2) = 7.157788307709011 [m^-4],
# near_doubt_limit = 9.999999999999999e-05.
d1 = 0.6712591624431  # joint offset 1 [m]
a1 = 0.0026544606897  # link length 1 [m]
ca1 = 0.0016085442592340678  # cosine of twist 1
sa1 = 0.9999987062918462  # sine of twist 1
d2 = -0.000143425944  # joint offset 2 [m]
a2 = 0.4314454936115  # link length 2 [m]
ca2 = 0.9999994314394958  # cosine of twist 2
sa2 = 0.001066358610003491  # sine of twist 2
d3 = 0.1490653237899  # joint offset 3 [m]
a3 = 0.0201858398555  # link length 3 [m]
ca3 = 0.0017412729567630927  # cosine of twist 3
sa3 = 0.9999984839830959  # sine of twist 3
d4 = 0.432695688237  # joint offset 4 [m]
a4 = -0.001863305965  # link length 4 [m]
ca4 = 0.001238887228280428  # cosine of twist 4
sa4 = 0.9999992325789233  # sine of twist 4
d5 = -0.00062817974  # joint offset 5 [m]
a5 = -6.29954602e-05  # link length 5 [m]
ca5 = 0.0007308690395286796  # cosine of twist 5
sa5 = 0.9999997329151878  # sine of twist 5
d6 = -0.0012011655652  # joint offset 6 [m]
a6 = -9.3840846e-05  # link length 6 [m]
ca6 = 0.9999988042061223  # cosine of twist 6
sa6 = 0.0015464754525777457  # sine of twist 6
offset1 = 0.0004277699642  # offset of joint 1 [rad]
offset2 = 0.0006617156617  # offset of joint 2 [rad]
offset3 = -0.0018179220006  # offset of joint 3 [rad]
offset4 = 8.90468712e-05  # offset of joint 4 [rad]
offset5 = 0.0009695294734  # offset of joint 5 [rad]
offset6 = -0.0022050175347  # offset of joint 6 [rad]
f1 = -2.3070697884642687e-07  # d2 * ca1 [m]
f2 = 1.7152850204059354e-06  # sa2 * ca1
f3 = 0.0016085433446793326  # ca2 * ca1
near_d3 = 0.14892189775631642  # joint offset 3 [m]
near_longest3 = 0.7475535203062076  # square of the longest reach [m^2]
near_shortest3 = 2.961108259928867e-06  # square of the shortest reach [m^2]
near_k1 = 0.022177731631342762  # near_d3^2 [m^2]
near_k4 = 0.9678209975988334  # 1 / near_arm_size1 [m^-1]
near_k7 = 0.37377824070723376  # near_a2^2 + (near_a3^2 + near_d4^2) [m^2]
near_turn1 = -1.6174138820106556  # atan2(-near_k5, near_k6) [rad]
near_m1 = 3.0774677988139795e-12  # 1000 * near_k3 [m^2]
# 1000 * (near_longest3 - near_longest3_apart) * (near_longest3_apart - near_shortest3) [m^4]
near_m2 = 1.3279165486287245e-11
near_m3 = 0.12467563999795989  # -near_k6 * near_k8 [m^-2]
near_m4 = 0.9989215120964166  # near_k5 * near_k7 * near_k8
near_m5 = 2.6724977628615725  # near_k5 * near_k8 [m^-2]
near_m6 = 0.04660104137748587  # -near_k6 * near_k7 * near_k8
near_m7 = 1.1588949413161114  # near_k8 * (near_d4 * near_k5 + near_a3 * near_k6) [m^-1]
# near_d4 * near_k5 * near_k7 * near_k8 + near_a3 * near_k6 * near_k7 * near_k8 - near_a2 [m]
near_m8 = 0.0017242187181490598
near_m9 = 9.999999999999999e-09  # near_doubt_limit^2
near1 = 0.5  # 1 / 2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16, size=1.7112988821471, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0, zero=0.0004277699642),
        _joints.Joint(place=1, zero=0.0006617156617),
        _joints.Joint(place=2, zero=-0.0018179220006),
        _joints.Joint(place=3, zero=8.90468712e-05),
        _joints.Joint(place=4, zero=0.0009695294734),
        _joints.Joint(place=5, zero=-0.0022050175347),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.0026544606897, 0.0, 0.0016085442592340678, -0.9999987062918462,
                0.0, 0.0, 0.9999987062918462, 0.0016085442592340678, 0.6712591624431,
            ),
            offset=0.0004277699642,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.4314454936115, 0.0, 0.9999994314394958, -0.001066358610003491, 0.0,
                0.0, 0.001066358610003491, 0.9999994314394958, -0.000143425944,
            ),
            offset=0.0006617156617,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.0201858398555, 0.0, 0.0017412729567630927, 0.9999984839830959, 0.0,
                0.0, -0.9999984839830959, 0.0017412729567630927, 0.1490653237899,
            ),
            offset=-0.0018179220006,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -0.001863305965, 0.0, 0.001238887228280428, -0.9999992325789233, 0.0,
                0.0, 0.9999992325789233, 0.001238887228280428, 0.432695688237,
            ),
            offset=8.90468712e-05,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -6.29954602e-05, 0.0, 0.0007308690395286796, 0.9999997329151878, 0.0,
                0.0, -0.9999997329151878, 0.0007308690395286796, -0.00062817974,
            ),
            offset=0.0009695294734,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -9.3840846e-05, 0.0, 0.9999988042061223, 0.0015464754525777457, 0.0,
                0.0, -0.0015464754525777457, 0.9999988042061223, -0.0012011655652,
            ),
            offset=-0.0022050175347,
        ),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
    miss_weights=(0.5844, 0.5844, 0.5844, 1.0, 1.0, 1.0), size=1.7112988821471, clamped_again=1e-10,
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0004277699642, 0.6712591624431, 0.0026544606897, 1.569187781842),
    (0.0006617156617, -0.000143425944, 0.4314454936115, 0.0010663588121),
    (-0.0018179220006, 0.1490653237899, 0.0201858398555, -1.5690550529582),
    (8.90468712e-05, 0.432695688237, -0.001863305965, 1.5695574392497),
    (0.0009695294734, -0.00062817974, -6.29954602e-05, -1.5700654576903),
    (-0.0022050175347, -0.0012011655652, -9.3840846e-05, -0.001546476069),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    v1 = q[0] + offset1
    c1, s1 = math.cos(v1), math.sin(v1)
    v2, y1_y, z1_x = s1 * ca1, c1 * ca1, s1 * sa1
    v3, v4 = c1 * sa1, q[1] + offset2
    c2, s2 = math.cos(v4), math.sin(v4)
    x2_x, x2_y, x2_z = c1 * c2 - v2 * s2, s1 * c2 + y1_y * s2, sa1 * s2
    v5, v6, v7 = v2 * c2 + c1 * s2, y1_y * c2 - s1 * s2, sa1 * c2
    y2_x, y2_y, y2_z = z1_x * sa2 - v5 * ca2, v6 * ca2 - v3 * sa2, v7 * ca2 + f2
    z2_x, v8, z2_z = v5 * sa2 + z1_x * ca2, v6 * sa2 + v3 * ca2, f3 - v7 * sa2
    v9 = q[2] + offset3
    c3, s3 = math.cos(v9), math.sin(v9)
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, x2_z * c3 + y2_z * s3
    v10, v11, v12 = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, y2_z * c3 - x2_z * s3
    y3_x, y3_y, y3_z = v10 * ca3 - z2_x * sa3, v11 * ca3 + v8 * sa3, v12 * ca3 - z2_z * sa3
    z3_x, z3_y, z3_z = v10 * sa3 + z2_x * ca3, v11 * sa3 - v8 * ca3, v12 * sa3 + z2_z * ca3
    v13 = q[3] + offset4
    c4, s4 = math.cos(v13), math.sin(v13)
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, x3_y * c4 + y3_y * s4, x3_z * c4 + y3_z * s4
    v14, v15, v16 = y3_x * c4 - x3_x * s4, y3_y * c4 - x3_y * s4, y3_z * c4 - x3_z * s4
    y4_x, y4_y, y4_z = v14 * ca4 + z3_x * sa4, v15 * ca4 + z3_y * sa4, v16 * ca4 + z3_z * sa4
    z4_x, z4_y, z4_z = z3_x * ca4 - v14 * sa4, z3_y * ca4 - v15 * sa4, z3_z * ca4 - v16 * sa4
    v17 = q[4] + offset5
    c5, s5 = math.cos(v17), math.sin(v17)
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, x4_z * c5 + y4_z * s5
    v18, v19, v20 = y4_x * c5 - x4_x * s5, y4_y * c5 - x4_y * s5, y4_z * c5 - x4_z * s5
    y5_x, y5_y, y5_z = v18 * ca5 - z4_x * sa5, v19 * ca5 - z4_y * sa5, v20 * ca5 - z4_z * sa5
    z5_x, z5_y, z5_z = v18 * sa5 + z4_x * ca5, v19 * sa5 + z4_y * ca5, v20 * sa5 + z4_z * ca5
    v21 = q[5] + offset6
    c6, s6 = math.cos(v21), math.sin(v21)
    x6_x, x6_y, x6_z = x5_x * c6 + y5_x * s6, x5_y * c6 + y5_y * s6, x5_z * c6 + y5_z * s6
    v22, v23, v24 = y5_x * c6 - x5_x * s6, y5_y * c6 - x5_y * s6, y5_z * c6 - x5_z * s6
    T[0, 0], T[0, 1], T[0, 2] = x6_x, v22 * ca6 - z5_x * sa6, v22 * sa6 + z5_x * ca6
    T[0, 3] = (
        c1 * a1 + x2_x * a2 + z1_x * d2 + x3_x * a3 + z2_x * d3 + x4_x * a4 + z3_x * d4 + x5_x * a5
        + z4_x * d5 + x6_x * a6 + z5_x * d6
    )
    T[1, 0], T[1, 1], T[1, 2] = x6_y, v23 * ca6 - z5_y * sa6, v23 * sa6 + z5_y * ca6
    T[1, 3] = (
        s1 * a1 + x2_y * a2 - v3 * d2 + x3_y * a3 - v8 * d3 + x4_y * a4 + z3_y * d4 + x5_y * a5 +
        z4_y * d5 + x6_y * a6 + z5_y * d6
    )
    T[2, 0], T[2, 1], T[2, 2] = x6_z, v24 * ca6 - z5_z * sa6, v24 * sa6 + z5_z * ca6
    T[2, 3] = (
        d1 + x2_z * a2 + f1 + x3_z * a3 + z2_z * d3 + x4_z * a4 + z3_z * d4 + x5_z * a5 + z4_z * d5
        + x6_z * a6 + z5_z * d6
    )
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    v1 = q[0] + offset1
    c1, s1 = math.cos(v1), math.sin(v1)
    p1_x, p1_y, v2 = c1 * a1, s1 * a1, s1 * ca1
    y1_y, z1_x, v3 = c1 * ca1, s1 * sa1, c1 * sa1
    v4 = q[1] + offset2
    c2, s2 = math.cos(v4), math.sin(v4)
    x2_x, x2_y, x2_z = c1 * c2 - v2 * s2, s1 * c2 + y1_y * s2, sa1 * s2
    v5, v6, v7 = v2 * c2 + c1 * s2, y1_y * c2 - s1 * s2, sa1 * c2
    p2_x, p2_y, p2_z = p1_x + x2_x * a2 + z1_x * d2, p1_y + x2_y * a2 - v3 * d2, d1 + x2_z * a2 + f1
    y2_x, y2_y, y2_z = z1_x * sa2 - v5 * ca2, v6 * ca2 - v3 * sa2, v7 * ca2 + f2
    z2_x, v8, z2_z = v5 * sa2 + z1_x * ca2, v6 * sa2 + v3 * ca2, f3 - v7 * sa2
    v9 = q[2] + offset3
    c3, s3 = math.cos(v9), math.sin(v9)
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, x2_z * c3 + y2_z * s3
    v10, v11, v12 = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, y2_z * c3 - x2_z * s3
    p3_x, p3_y = p2_x + x3_x * a3 + z2_x * d3, p2_y + x3_y * a3 - v8 * d3
    p3_z, y3_x, y3_y = p2_z + x3_z * a3 + z2_z * d3, v10 * ca3 - z2_x * sa3, v11 * ca3 + v8 * sa3
    y3_z, z3_x, z3_y = v12 * ca3 - z2_z * sa3, v10 * sa3 + z2_x * ca3, v11 * sa3 - v8 * ca3
    z3_z, v13 = v12 * sa3 + z2_z * ca3, q[3] + offset4
    c4, s4 = math.cos(v13), math.sin(v13)
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, x3_y * c4 + y3_y * s4, x3_z * c4 + y3_z * s4
    v14, v15, v16 = y3_x * c4 - x3_x * s4, y3_y * c4 - x3_y * s4, y3_z * c4 - x3_z * s4
    p4_x, p4_y = p3_x + x4_x * a4 + z3_x * d4, p3_y + x4_y * a4 + z3_y * d4
    p4_z, y4_x, y4_y = p3_z + x4_z * a4 + z3_z * d4, v14 * ca4 + z3_x * sa4, v15 * ca4 + z3_y * sa4
    y4_z, z4_x, z4_y = v16 * ca4 + z3_z * sa4, z3_x * ca4 - v14 * sa4, z3_y * ca4 - v15 * sa4
    z4_z, v17 = z3_z * ca4 - v16 * sa4, q[4] + offset5
    c5, s5 = math.cos(v17), math.sin(v17)
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, x4_z * c5 + y4_z * s5
    v18, v19, v20 = y4_x * c5 - x4_x * s5, y4_y * c5 - x4_y * s5, y4_z * c5 - x4_z * s5
    p5_x, p5_y = p4_x + x5_x * a5 + z4_x * d5, p4_y + x5_y * a5 + z4_y * d5
    p5_z, z5_x, z5_y = p4_z + x5_z * a5 + z4_z * d5, v18 * sa5 + z4_x * ca5, v19 * sa5 + z4_y * ca5
    z5_z, v21 = v20 * sa5 + z4_z * ca5, q[5] + offset6
    c6, s6 = math.cos(v21), math.sin(v21)
    p6_x = p5_x + (x5_x * c6 + (v18 * ca5 - z4_x * sa5) * s6) * a6 + z5_x * d6
    p6_y = p5_y + (x5_y * c6 + (v19 * ca5 - z4_y * sa5) * s6) * a6 + z5_y * d6
    p6_z, v22 = p5_z + (x5_z * c6 + (v20 * ca5 - z4_z * sa5) * s6) * a6 + z5_z * d6, p6_x - p1_x
    v23, v24, v25 = p6_y - p1_y, p6_z - d1, p6_x - p2_x
    v26, v27, v28 = p6_y - p2_y, p6_z - p2_z, p6_x - p3_x
    v29, v30, v31 = p6_y - p3_y, p6_z - p3_z, p6_x - p4_x
    v32, v33, v34 = p6_y - p4_y, p6_z - p4_z, p6_x - p5_x
    v35, v36 = p6_y - p5_y, p6_z - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, -(v3 * v24 + ca1 * v23), -(v8 * v27 + z2_z * v26)
    J[0, 3], J[0, 4] = z3_y * v30 - z3_z * v29, z4_y * v33 - z4_z * v32
    J[0, 5] = z5_y * v36 - z5_z * v35
    J[1, 0], J[1, 1], J[1, 2] = p6_x, ca1 * v22 - z1_x * v24, z2_z * v25 - z2_x * v27
    J[1, 3], J[1, 4] = z3_z * v28 - z3_x * v30, z4_z * v31 - z4_x * v33
    J[1, 5] = z5_z * v34 - z5_x * v36
    J[2, 1], J[2, 2] = z1_x * v23 + v3 * v22, z2_x * v26 + v8 * v25
    J[2, 3], J[2, 4] = z3_x * v29 - z3_y * v28, z4_x * v32 - z4_y * v31
    J[2, 5] = z5_x * v35 - z5_y * v34
    J[3, 1], J[3, 2], J[3, 3] = z1_x, z2_x, z3_x
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = -v3, -v8, z3_y
    J[4, 4], J[4, 5] = z4_y, z5_y
    J[5, 0], J[5, 1], J[5, 2] = 1.0, ca1, z2_z
    J[5, 3], J[5, 4], J[5, 5] = z3_z, z4_z, z5_z
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.46180216162714816, reach=4.0000000039999986,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.005748047346394125,
            0.0014848100854468322, 0.00061867086893618, -0.9999987062918463, -0.10776509798954229,
            0.9230757288847813, 0.38461488703532554, 0.001608544259234068, 1.4537379415938628e-09,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, 0.934264777131646, 0.8823524395054374,
            0.4705879677362333, -0.001066358610003491, -0.0002301637995154427,
            0.0009409046558854332, 0.000501815816472231, 0.9999994314394958, 0.10776495868305999,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.04371101205844448, 0.001671622038492569, 0.00048755642789366597,
            0.9999984839830959, 0.4683915670885376, -0.959998544623772, -0.2799995755152669,
            0.0017412729567630927, 0.10776514306515093,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, -0.004034857607497308,
            0.000897125234272034, 0.0008544049850209848, -0.9999992325789233, 0.000970397312505304,
            0.724137375315772, 0.6896546431578782, 0.001238887228280428, 0.46857850599669737,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, -0.00013641222461592016,
            0.0006913626049595618, 0.0002370386074147069, 0.9999997329151878,
            2.8495176635072937e-07, -0.9459456932981507, -0.32432423770222313,
            0.0007308690395286796, -0.0003898806422463197,
        )),
        _loops.Link((
            0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.6713392129385739,
        )),
        _loops.Link((
            1.0, 0.0, 0.0, 9.3840846e-05, 0.0, 0.9999988042061223, -0.0015464754525777457,
            -1.8577765638974755e-06, 0.0, 0.0015464754525777457, 0.9999988042061223,
            0.0012012957200730212,
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
        _loops.Formulation(joints=(3, 4, 5, 0, 1, 2), sign=1.0),
    ),
)
_NUMBERS = _loops.general_numbers(_LINKS, _LOOP)
_all_joints = _runtime("general.rows").all_joints
_nearest = _runtime("general.near")
_NO_FREE = _runtime("arrays").NONE_GIVEN


# The nearest arm with a structure: what follows is its closed form.
@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T11, T12, T13 = kept[0 * w + k], kept[1 * w + k], kept[2 * w + k]
        T14, T21, T22 = kept[3 * w + k], kept[4 * w + k], kept[5 * w + k]
        T23, T24, T31 = kept[6 * w + k], kept[7 * w + k], kept[8 * w + k]
        T32, T33, T34 = kept[9 * w + k], kept[10 * w + k], kept[11 * w + k]
        given1, given2 = kept[16 * w + k], kept[17 * w + k]

        # theta1, type 2: U1[3, 4]
        N1 = T14 * T14 + T24 * T24
        D1_squared = N1 - near_k1
        w1 = math.sqrt(D1_squared)
        v1, inverse1, v2 = w1 - w1, 1.0 / N1, near_d3 * T24
        v3, v4 = inverse1 * v2, T14 * inverse1
        v5 = w1 * v4
        c1_p, v6, v7 = v5 - v3, v3 + v5, near_d3 * T14
        v8, v9 = inverse1 * v7, T24 * inverse1
        v10 = w1 * v9
        s1_p, s1_m = v8 + v10, v8 - v10

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        N3 = D1_squared + T34 * T34
        v11, v12 = near_longest3 - N3, N3 - near_shortest3
        D3_squared = v11 * v12
        w3 = math.sqrt(D3_squared)
        v13, v14, v15 = w3 - w3, near_m5 * N3 - near_m4, near_m3 * w3
        s3_p, s3_m, v16 = v14 - v15, v14 + v15, near_m6 - near_m3 * N3
        v17 = near_m5 * w3
        c3_p, c3_m = v16 - v17, v16 + v17

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        X1_2 = near_m7 * N3 - near_m8
        v19, v20 = T34 * X1_2, near_m7 * w1
        v21 = w3 * v20
        S2_pp, S2_pm, v22 = v19 - v21, v19 + v21, near_m7 * T34
        v23, v24, v25 = w3 * v22, w1 * X1_2, w1 * -X1_2
        C2_pp, C2_pm, C2_mp = v23 + v24, v24 - v23, v23 + v25
        C2_mm, factor2 = v25 - v23, 1.0 / N3

        # theta4, type 2: U4[3, 3]
        c23_pp, c23_pm = c3_p * C2_pp - s3_p * S2_pp, c3_m * C2_pm - s3_m * S2_pm
        c23_mp, c23_mm = c3_p * C2_mp - s3_p * S2_pm, c3_m * C2_mm - s3_m * S2_pp
        s23_pp, s23_pm = c3_p * S2_pp + s3_p * C2_pp, c3_m * S2_pm + s3_m * C2_pm
        s23_mp, s23_mm = c3_p * S2_pm + s3_p * C2_mp, c3_m * S2_pp + s3_m * C2_mm
        v26, v27 = c1_p * T13 + s1_p * T23, s1_m * T23 - v6 * T13
        c4_pp, c4_pm = c23_pp * v26 + s23_pp * T33, c23_pm * v26 + s23_pm * T33
        c4_mp, c4_mm = c23_mp * v27 + s23_mp * T33, c23_mm * v27 + s23_mm * T33
        Y4_p, Y4_m = s1_p * T13 - c1_p * T23, s1_m * T13 + v6 * T23
        v28, v29, v30 = Y4_p * Y4_p, Y4_m * Y4_m, factor2 * c4_pp
        v31, v32, v33 = factor2 * c4_pm, factor2 * c4_mp, factor2 * c4_mm
        v34, v35 = v28 + factor2 * (c4_pp * v30), v28 + factor2 * (c4_pm * v31)
        v36, v37 = v29 + factor2 * (c4_mp * v32), v29 + factor2 * (c4_mm * v33)
        v38, v39 = math.copysign(half_turn, Y4_p), math.copysign(half_turn, Y4_m)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v40, v41, v42 = c1_p * T22 - s1_p * T12, v6 * T22 + s1_m * T12, c1_p * T12 + s1_p * T22
        v43, v44, v45 = s1_m * T22 - v6 * T12, c1_p * T21 - s1_p * T11, v6 * T21 + s1_m * T11
        v46, v47 = c1_p * T11 + s1_p * T21, s1_m * T21 - v6 * T11
        s6_pp = c4_pp * v44 + Y4_p * (c23_pp * v46 + s23_pp * T31)
        s6_pm = c4_pm * v44 + Y4_p * (c23_pm * v46 + s23_pm * T31)
        s6_mp = Y4_m * (c23_mp * v47 + s23_mp * T31) - c4_mp * v45
        s6_mm = Y4_m * (c23_mm * v47 + s23_mm * T31) - c4_mm * v45

        # by how much these differ at poses so near: slopes and rests
        v48, v49 = T14 * given2, abs(given2)
        v50, v51, v52 = v48 + v48, v49 * v49, T24 * given2
        v53, v54 = v52 + v52, v51 + v51
        v55 = v50 * v50 + v53 * v53
        v56, v57 = v54 + math.sqrt(v55), T34 * given2
        v58, v59 = v57 + v57, v51 + v54
        v60, v61 = v59 + math.sqrt(v55 + v58 * v58), v11 * v50 - v12 * v50
        v62, v63 = v11 * v53 - v12 * v53, v11 * v58 - v12 * v58
        v64 = v59 * abs(v11) + v59 * abs(v12) + v60 * v60
        v65, v66, v67 = v64 + math.sqrt(v61 * v61 + v62 * v62 + v63 * v63), abs(N3), abs(inverse1)
        v68, v69, v70 = inverse1 * (inverse1 * v50), inverse1 * (inverse1 * v53), v67 * (v54 * v67)
        v71 = math.sqrt(N1) - math.sqrt(v54)
        v72, v73 = v70 + (v70 + (abs(v68) + abs(v69))) * (v56 / (v71 * v71)), near_d3 * given2
        v74, v75, v76 = inverse1 * v73, v7 * v69, v72 + math.sqrt(v68 * v68 + v69 * v69)
        v77, v78 = v74 - v7 * v68, v76 * abs(v73)
        v79, v80 = v78 + v72 * abs(v7), near1 / w1
        v81, v82, v83 = v50 * v80, v53 * v80, v56 * v80
        v84 = v83 * v83 / w1
        v85, v86, v87 = v84 + (v84 + v54 * abs(v80)), inverse1 * given2, T24 * v68
        v88, v89 = v86 - T24 * v69, v49 * v76
        v90, v91, v92 = v89 + v72 * abs(T24), abs(w1), v85 + math.sqrt(v81 * v81 + v82 * v82)
        v93 = v9 * v81 - w1 * v87
        v94, v95, v96 = v77 + v93, v77 + -v93, v9 * v82
        v97, v98, v99 = w1 * v88 + v96 - v75, w1 * -v88 - v96 - v75, v90 * v91 + v85 * abs(v9)
        v100 = v87 * v87
        v101 = v79 + (v99 + v92 * (v90 + math.sqrt(v100 + v88 * v88)))
        v102, v103 = v79 + (v99 + v92 * (v90 + math.sqrt(v100 + -v88 * -v88))), T33 * given1
        v104, v105, v106 = T23 * given1, near1 * (given1 * given1), s1_p * v103
        v107, v108, v109 = s1_m * v103, v105 * abs(s1_p), v105 * abs(s1_m)
        v110, v111 = abs(T13), v101 + math.sqrt(v94 * v94 + v97 * v97)
        v112, v113, v114 = v102 + math.sqrt(v95 * v95 + v98 * v98), v103 * v103, v104 * v104
        v115, v116, v117 = v105 + math.sqrt(v113 + v114), T14 * v69, v86 - T14 * v68
        v118, v119, v120 = v89 + v72 * abs(T14), v2 * v68, v78 + v72 * abs(v2)
        v121 = v4 * v81
        v122, v123, v124 = v119 + (w1 * v117 + v121), v119 + (w1 * -v117 - v121), v2 * v69 - v74
        v125 = v4 * v82 - w1 * v116
        v126, v127, v128 = v124 + v125, v124 + -v125, v91 * v118 + v85 * abs(v4)
        v129 = v116 * v116
        v130 = v120 + (v128 + v92 * (v118 + math.sqrt(v117 * v117 + v129)))
        v131, v132 = v120 + (v128 + v92 * (v118 + math.sqrt(v129 + -v117 * -v117))), T13 * given1
        v133, v134, v135 = c1_p * v103, v6 * v103, v105 * abs(c1_p)
        v136, v137, v138 = v105 * abs(v6), abs(T23), v130 + math.sqrt(v122 * v122 + v126 * v126)
        v139, v140 = v131 + math.sqrt(v123 * v123 + v127 * v127), v132 * v132
        v141, v142 = v105 + math.sqrt(v113 + v140), s1_p * v104 + c1_p * v132
        v143, v144, v145 = s1_m * v104 - v6 * v132, T13 * v94 - T23 * v122, T13 * v95 - T23 * v123
        v146, v147, v148 = T13 * v97 - T23 * v126, T13 * v98 - T23 * v127, v133 * v133 + v106 * v106
        v149 = v134 * v134 + v107 * v107
        v150 = (
            v108 + v101 * v110 + v111 * v115 + (v135 + v130 * v137 + v138 * v141) + (math.sqrt(v148
            + v142 * v142) + math.sqrt(v144 * v144 + v146 * v146))
        )
        v151 = (
            v109 + v102 * v110 + v112 * v115 + (v136 + v131 * v137 + v139 * v141) + (math.sqrt(v149
            + v143 * v143) + math.sqrt(v145 * v145 + v147 * v147))
        )
        v152, v153, v154 = abs(factor2), factor2 * (factor2 * v50), factor2 * (factor2 * v53)
        v155, v156 = factor2 * (factor2 * v58), v152 * (v59 * v152)
        v157 = v156 + (v156 + (abs(v155) + (abs(v153) + abs(v154)))) * (v60 / (v66 - v60))
        v158, v159, v160 = near_m3 * v50, near_m3 * v53, near_m3 * v58
        v161 = near1 / w3
        v162, v163, v164 = v61 * v161, v62 * v161, v63 * v161
        v165 = v65 * v161
        v166 = v165 * v165 / w3
        v167 = v166 + (v166 + v64 * abs(v161))
        v168, v169 = v167 + math.sqrt(v162 * v162 + v163 * v163 + v164 * v164), near_m5 * v162
        v170, v171, v172 = v158 + v169, v158 - v169, near_m5 * v163
        v173, v174, v175 = v159 + v172, v159 - v172, near_m5 * v164
        v176, v177, v178 = v160 + v175, v160 - v175, near_m3 * v59 + near_m5 * v167
        v179, v180, v181 = near_m7 * given2, v22 * v162, v22 * v163
        v182, v183, v184 = w3 * v179 + v22 * v164, near_m7 * v50, near_m7 * v53
        v185, v186 = near_m7 * v58, near_m7 * v59
        v187, v188 = w1 * v185, w1 * v183
        v189, v190, v191 = v188 + X1_2 * v81, -X1_2 * v81 - v188, w1 * v184
        v192, v193 = v191 + X1_2 * v82, -X1_2 * v82 - v191
        v194, v195 = v186 + math.sqrt(v183 * v183 + v184 * v184 + v185 * v185), v180 + v189
        v196, v197, v198 = v189 - v180, v180 + v190, v190 - v180
        v199, v200, v201 = v181 + v192, v192 - v181, v181 + v193
        v202, v203, v204 = v193 - v181, v182 + v187, v187 - v182
        v205 = v167 * abs(v22) + v168 * abs(v179) + (v91 * v186 + v85 * abs(X1_2) + v92 * v194)
        v206, v207, v208 = abs(c3_p), abs(c3_m), abs(C2_pp)
        v209, v210, v211 = abs(C2_pm), abs(C2_mp), abs(C2_mm)
        v212 = v178 + math.sqrt(v170 * v170 + v173 * v173 + v176 * v176)
        v213, v214 = v178 + math.sqrt(v171 * v171 + v174 * v174 + v177 * v177), v203 * v203
        v215 = v205 + math.sqrt(v195 * v195 + v199 * v199 + v214)
        v216 = v205 + math.sqrt(v196 * v196 + v200 * v200 + v204 * v204)
        v217 = v205 + math.sqrt(v197 * v197 + v201 * v201 + -v204 * -v204)
        v218, v219 = v205 + math.sqrt(v214 + (v198 * v198 + v202 * v202)), near_m5 * v50
        v220, v221, v222 = near_m5 * v53, near_m5 * v58, near_m3 * v162
        v223, v224, v225 = v219 - v222, v219 + v222, near_m3 * v163
        v226, v227, v228 = v220 - v225, v220 + v225, near_m3 * v164
        v229, v230, v231 = v221 - v228, v221 + v228, near_m5 * v59 + near_m3 * v167
        v232, v233, v234 = T34 * v183, T34 * v184, T34 * v185 + X1_2 * given2
        v235, v236, v237 = near_m7 * v81, near_m7 * v82, near_m7 * v85
        v238 = w3 * v235 + v20 * v162
        v239, v240, v241 = v232 - v238, v232 + v238, w3 * v236 + v20 * v163
        v242, v243, v244 = v233 - v241, v233 + v241, v20 * v164
        v245, v246 = v234 - v244, v234 + v244
        v247 = (
            v186 * abs(T34) + v49 * v194 + (abs(w3) * v237 + v167 * abs(v20) + v168 * (v237 +
            math.sqrt(v235 * v235 + v236 * v236)))
        )
        v248, v249, v250 = abs(s3_p), abs(s3_m), abs(S2_pp)
        v251, v252 = abs(S2_pm), v231 + math.sqrt(v223 * v223 + v226 * v226 + v229 * v229)
        v253 = v231 + math.sqrt(v224 * v224 + v227 * v227 + v230 * v230)
        v254 = v247 + math.sqrt(v239 * v239 + v242 * v242 + v245 * v245)
        v255 = v247 + math.sqrt(v240 * v240 + v243 * v243 + v246 * v246)
        v256 = c3_p * v195 - C2_pp * v170 - (s3_p * v239 + S2_pp * v223)
        v257 = c3_m * v196 - C2_pm * v171 - (s3_m * v240 + S2_pm * v224)
        v258 = c3_p * v197 - C2_mp * v170 - (s3_p * v240 + S2_pm * v223)
        v259 = c3_m * v198 - C2_mm * v171 - (s3_m * v239 + S2_pp * v224)
        v260 = c3_p * v199 - C2_pp * v173 - (s3_p * v242 + S2_pp * v226)
        v261 = c3_m * v200 - C2_pm * v174 - (s3_m * v243 + S2_pm * v227)
        v262 = c3_p * v201 - C2_mp * v173 - (s3_p * v243 + S2_pm * v226)
        v263 = c3_m * v202 - C2_mm * v174 - (s3_m * v242 + S2_pp * v227)
        v264 = c3_p * v203 - C2_pp * v176 - (s3_p * v245 + S2_pp * v229)
        v265 = c3_m * v204 - C2_pm * v177 - (s3_m * v246 + S2_pm * v230)
        v266 = c3_p * -v204 - C2_mp * v176 - (s3_p * v246 + S2_pm * v229)
        v267, v268 = c3_m * v203 + C2_mm * v177 + (s3_m * v245 + S2_pp * v230), v205 * v206
        v269, v270 = v247 * v248, v231 * v250
        v271, v272 = v268 + v178 * v208 + v212 * v215 + (v269 + v270 + v252 * v254), v205 * v207
        v273, v274 = v247 * v249, v231 * v251
        v275 = v272 + v178 * v209 + v213 * v216 + (v273 + v274 + v253 * v255)
        v276 = v268 + v178 * v210 + v212 * v217 + (v269 + v274 + v252 * v255)
        v277 = v272 + v178 * v211 + v213 * v218 + (v270 + v273 + v253 * v254)
        v278, v279 = s1_p * v132 - c1_p * v104, s1_m * v132 + v6 * v104
        v280, v281, v282 = T13 * v122 + T23 * v94, T13 * v123 + T23 * v95, T13 * v126 + T23 * v97
        v283 = T13 * v127 + T23 * v98
        v284 = v135 + v110 * v130 + v115 * v138 + (v108 + v101 * v137 + v111 * v141)
        v285 = v136 + v110 * v131 + v115 * v139 + (v109 + v102 * v137 + v112 * v141)
        v286, v287, v288 = c23_pp * v278, c23_pm * v278, c23_mp * v279
        v289, v290, v291 = c23_mm * v279, abs(v26), abs(v27)
        v292 = v284 + (math.sqrt(v148 + v278 * v278) + math.sqrt(v280 * v280 + v282 * v282))
        v293 = v285 + (math.sqrt(v149 + v279 * v279) + math.sqrt(v281 * v281 + v283 * v283))
        v294 = c3_p * v239 - S2_pp * v170 + (s3_p * v195 + C2_pp * v223)
        v295 = c3_m * v240 - S2_pm * v171 + (s3_m * v196 + C2_pm * v224)
        v296 = c3_p * v240 - S2_pm * v170 + (s3_p * v197 + C2_mp * v223)
        v297 = c3_m * v239 - S2_pp * v171 + (s3_m * v198 + C2_mm * v224)
        v298 = c3_p * v242 - S2_pp * v173 + (s3_p * v199 + C2_pp * v226)
        v299 = c3_m * v243 - S2_pm * v174 + (s3_m * v200 + C2_pm * v227)
        v300 = c3_p * v243 - S2_pm * v173 + (s3_p * v201 + C2_mp * v226)
        v301 = c3_m * v242 - S2_pp * v174 + (s3_m * v202 + C2_mm * v227)
        v302 = c3_p * v245 - S2_pp * v176 + (s3_p * v203 + C2_pp * v229)
        v303 = c3_m * v246 - S2_pm * v177 + (s3_m * v204 + C2_pm * v230)
        v304 = c3_p * v246 - S2_pm * v176 + (s3_p * -v204 + C2_mp * v229)
        v305, v306 = c3_m * v245 - S2_pp * v177 + (C2_mm * v230 - s3_m * v203), v206 * v247
        v307, v308 = v178 * v250, v205 * v248
        v309, v310 = v306 + v307 + v212 * v254 + (v308 + v208 * v231 + v215 * v252), v207 * v247
        v311, v312 = v178 * v251, v205 * v249
        v313 = v310 + v311 + v213 * v255 + (v312 + v209 * v231 + v216 * v253)
        v314 = v306 + v311 + v212 * v255 + (v308 + v210 * v231 + v217 * v252)
        v315, v316 = v307 + v310 + v213 * v254 + (v312 + v211 * v231 + v218 * v253), abs(T33)
        v317, v318 = v105 + math.sqrt(v114 + v140), s23_pp * v104 - c23_pp * v106
        v319, v320 = s23_pm * v104 - c23_pm * v106, s23_mp * v104 - c23_mp * v107
        v321, v322 = s23_mm * v104 - c23_mm * v107, c23_pp * v133 - s23_pp * v132
        v323, v324 = c23_pm * v133 - s23_pm * v132, c23_mp * v134 + s23_mp * v132
        v325, v326 = c23_mm * v134 + s23_mm * v132, c23_pp * v280 + v26 * v256 + T33 * v294
        v327 = c23_pm * v280 + v26 * v257 + T33 * v295
        v328 = c23_mp * v281 + v27 * v258 + T33 * v296
        v329 = c23_mm * v281 + v27 * v259 + T33 * v297
        v330 = c23_pp * v282 + v26 * v260 + T33 * v298
        v331 = c23_pm * v282 + v26 * v261 + T33 * v299
        v332 = c23_mp * v283 + v27 * v262 + T33 * v300
        v333, v334 = c23_mm * v283 + v27 * v263 + T33 * v301, v26 * v264 + T33 * v302
        v335, v336, v337 = v26 * v265 + T33 * v303, v27 * v266 + T33 * v304, T33 * v305 - v27 * v267
        v338 = (
            v284 * abs(c23_pp) + v271 * v290 + v292 * (v271 + math.sqrt(v256 * v256 + v260 * v260 +
            v264 * v264)) + (v105 * abs(s23_pp) + v309 * v316 + v317 * (v309 + math.sqrt(v294 * v294
            + v298 * v298 + v302 * v302)))
        )
        v339 = (
            v284 * abs(c23_pm) + v275 * v290 + v292 * (v275 + math.sqrt(v257 * v257 + v261 * v261 +
            v265 * v265)) + (v105 * abs(s23_pm) + v313 * v316 + v317 * (v313 + math.sqrt(v295 * v295
            + v299 * v299 + v303 * v303)))
        )
        v340 = (
            v285 * abs(c23_mp) + v276 * v291 + v293 * (v276 + math.sqrt(v258 * v258 + v262 * v262 +
            v266 * v266)) + (v105 * abs(s23_mp) + v314 * v316 + v317 * (v314 + math.sqrt(v296 * v296
            + v300 * v300 + v304 * v304)))
        )
        v341 = (
            v285 * abs(c23_mm) + v277 * v291 + v293 * (v277 + math.sqrt(v259 * v259 + v263 * v263 +
            v267 * v267)) + (v105 * abs(s23_mm) + v315 * v316 + v317 * (v315 + math.sqrt(v297 * v297
            + v301 * v301 + v305 * v305)))
        )
        v342, v343, v344 = factor2 * v318, factor2 * v319, factor2 * v320
        v345, v346, v347 = factor2 * v321, factor2 * v322, factor2 * v323
        v348, v349, v350 = factor2 * v324, factor2 * v325, factor2 * v286
        v351, v352, v353 = factor2 * v287, factor2 * v288, factor2 * v289
        v354 = v157 + math.sqrt(v153 * v153 + v154 * v154 + v155 * v155)
        v355, v356 = factor2 * v326 - c4_pp * v153, factor2 * v327 - c4_pm * v153
        v357, v358 = factor2 * v328 - c4_mp * v153, factor2 * v329 - c4_mm * v153
        v359, v360 = factor2 * v330 - c4_pp * v154, factor2 * v331 - c4_pm * v154
        v361, v362 = factor2 * v332 - c4_mp * v154, factor2 * v333 - c4_mm * v154
        v363, v364 = factor2 * v334 - c4_pp * v155, factor2 * v335 - c4_pm * v155
        v365, v366 = factor2 * v336 - c4_mp * v155, factor2 * v337 - c4_mm * v155
        v367 = (
            v152 * v338 + v157 * abs(c4_pp) + v354 * (v338 + (math.sqrt(v318 * v318 + v322 * v322 +
            v286 * v286) + math.sqrt(v326 * v326 + v330 * v330 + v334 * v334))) + (math.sqrt(v342 *
            v342 + v346 * v346 + v350 * v350) + math.sqrt(v355 * v355 + v359 * v359 + v363 * v363))
        )
        v368 = (
            v152 * v339 + v157 * abs(c4_pm) + v354 * (v339 + (math.sqrt(v319 * v319 + v323 * v323 +
            v287 * v287) + math.sqrt(v327 * v327 + v331 * v331 + v335 * v335))) + (math.sqrt(v343 *
            v343 + v347 * v347 + v351 * v351) + math.sqrt(v356 * v356 + v360 * v360 + v364 * v364))
        )
        v369 = (
            v152 * v340 + v157 * abs(c4_mp) + v354 * (v340 + (math.sqrt(v320 * v320 + v324 * v324 +
            v288 * v288) + math.sqrt(v328 * v328 + v332 * v332 + v336 * v336))) + (math.sqrt(v344 *
            v344 + v348 * v348 + v352 * v352) + math.sqrt(v357 * v357 + v361 * v361 + v365 * v365))
        )
        v370 = (
            v152 * v341 + v157 * abs(c4_mm) + v354 * (v341 + (math.sqrt(v321 * v321 + v325 * v325 +
            v289 * v289) + math.sqrt(v329 * v329 + v333 * v333 + v337 * v337))) + (math.sqrt(v345 *
            v345 + v349 * v349 + v353 * v353) + math.sqrt(v358 * v358 + v362 * v362 + v366 * v366))
        )
        v371, v372 = v150 * v150, v151 * v151

        # a joint is free, or branches meet
        kept[18 * w + k] = (
            1.0 if abs(v65 + (D3_squared + D3_squared)) <= v65 or abs(v56 + (D1_squared +
            D1_squared)) <= v56 or abs(N1) <= v54 or v66 <= v60 or abs(D1_squared) <= near_m1 or
            abs(v37) <= v372 + v370 * v370 or v37 <= near_m9 or abs(v36) <= v372 + v369 * v369 or
            v36 <= near_m9 or abs(v35) <= v371 + v368 * v368 or v35 <= near_m9 or abs(v34) <= v371 +
            v367 * v367 or abs(D3_squared * (near_k4 * w1)) <= near_m2 or v34 <= near_m9 else
            kept[18 * w + k]
        )
        kept[19 * w + k], kept[20 * w + k], kept[21 * w + k] = v1, v13, v38
        kept[22 * w + k], kept[23 * w + k], kept[24 * w + k] = v39, s6_pp, s6_pm
        kept[25 * w + k], kept[26 * w + k], turns[0 * w + k] = s6_mp, s6_mm, w3
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = S2_pp, S2_pm, S2_pm
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = S2_pp, Y4_p, Y4_p
        turns[7 * w + k], turns[8 * w + k], turns[9 * w + k] = Y4_m, Y4_m, math.sqrt(v34)
        turns[10 * w + k], turns[11 * w + k] = math.sqrt(v35), math.sqrt(v36)
        turns[12 * w + k], turns[13 * w + k], turns[14 * w + k] = math.sqrt(v37), s6_pp, s6_pm
        turns[15 * w + k], turns[16 * w + k], turns[17 * w + k] = s6_mp, s6_mm, s1_p
        turns[18 * w + k], turns[24 * w + k], turns[25 * w + k] = s1_m, N3 - near_k7, C2_pp
        turns[26 * w + k], turns[27 * w + k], turns[28 * w + k] = C2_pm, C2_mp, C2_mm
        turns[29 * w + k], turns[30 * w + k], turns[31 * w + k] = v30, v31, v32
        turns[32 * w + k], turns[33 * w + k] = v33, factor2 * (c23_pp * T33 - s23_pp * v26)
        turns[34 * w + k] = factor2 * (c23_pm * T33 - s23_pm * v26)
        turns[35 * w + k] = factor2 * (c23_mp * T33 - s23_mp * v27)
        turns[36 * w + k] = factor2 * (c23_mm * T33 - s23_mm * v27)
        turns[37 * w + k] = c4_pp * v40 + Y4_p * (c23_pp * v42 + s23_pp * T32)
        turns[38 * w + k] = c4_pm * v40 + Y4_p * (c23_pm * v42 + s23_pm * T32)
        turns[39 * w + k] = Y4_m * (c23_mp * v43 + s23_mp * T32) - c4_mp * v41
        turns[40 * w + k] = Y4_m * (c23_mm * v43 + s23_mm * T32) - c4_mm * v41
        turns[41 * w + k], turns[42 * w + k] = c1_p, -v6
    if w == 1 and kept[18] != 0.0:
        return
    end = 24 if w == 1 else 19 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(19 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        v1, v13, v38 = kept[19 * w + k], kept[20 * w + k], kept[21 * w + k]
        v39, s6_pp, s6_pm = kept[22 * w + k], kept[23 * w + k], kept[24 * w + k]
        s6_mp, s6_mm, angle1 = kept[25 * w + k], kept[26 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle8, angle9, angle10 = turns[7 * w + k], turns[8 * w + k], turns[9 * w + k]
        angle11, angle12, angle13 = turns[10 * w + k], turns[11 * w + k], turns[12 * w + k]
        angle14, angle15, angle16 = turns[13 * w + k], turns[14 * w + k], turns[15 * w + k]
        angle17, angle18, angle19 = turns[16 * w + k], turns[17 * w + k], turns[18 * w + k]

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        q3__p, v18 = angle1 - near_turn1, near_turn1 + angle1

        # theta4, type 2: U4[3, 3]
        q4_ppm, q4_pmm, q4_mpm = angle6 - v38, angle7 - v38, angle8 - v39
        q4_mmm = angle9 - v39

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle14 - math.copysign(half_turn, s6_pp)
        q6_pmm = angle15 - math.copysign(half_turn, s6_pm)
        q6_mpm = angle16 - math.copysign(half_turn, s6_mp)
        q6_mmm = angle17 - math.copysign(half_turn, s6_mm)

        # joint values
        q1_ppp, q1_mpp = v13 + angle18, v13 + angle19
        q3_ppp = v1 + (q3__p + (-turn if half_turn < q3__p else 0.0))
        q3_pmp = v1 + ((-turn if half_turn < -v18 else 0.0) - v18)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, angle2, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle6, angle10, angle14
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, -angle10, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = angle3, q3_pmp, angle7
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = angle11, angle15, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = -angle11, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = angle4, angle8, angle12
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = angle16, q4_mpm, -angle12
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q6_mpm, angle5, angle9
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = angle13, angle17, q4_mmm
        rows[30 * w + k], rows[31 * w + k] = -angle13, q6_mmm
        rows[32 * w + k] = rows[33 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[34 * w + k] = rows[35 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[36 * w + k] = rows[37 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[38 * w + k] = rows[39 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 27, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 2, 19, 20, 21], [17, 18, 2, 22, 23, 24], [17, 25, 10, 26, 27, 28],
    [17, 25, 10, 29, 30, 31],
])

_solve_from_nearest, _to_nearest_rows = _nearest.of_nearest(
    _HOW,
    _NUMBERS,
    _FORMULAS,
    _nearest.Nearest(
        turned=0.0063859344, moved=0.0076985885,
        left=(1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.6712591624),
        right=(
            -1.0, 0.0, 0.0, 9.38408e-05, -0.0, -0.999998804206049, -0.0015464755000093547,
            -1.8575731718540364e-06, 0.0, -0.0015464755000093547, 0.999998804206049,
            0.0012011641636534413,
        ),
        offsets=(
            0.0, -3.5450000001824906e-07, -3.141592299089793, 3.141592235789793, 3.141592653889793,
            0.0,
        ),
        solved=(0, 1, 2, 3, 4, 5),
        links=(
            (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
            (
                1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0,
                6.123233995736766e-17, 0.0,
            ),
            (
                0.9999999999999372, 3.5450000001824165e-07, -0.0, 0.4314454936114729,
                -3.5450000001824165e-07, 0.9999999999999372, -0.0, -1.5294742749314702e-07, 0.0,
                0.0, 1.0, 0.0,
            ),
            (
                -0.9999999999999372, 2.1706864523706184e-23, -3.545000001440309e-07,
                0.020185839855498718, -3.545000001440309e-07, -6.123233995736381e-17,
                0.9999999999999372, 7.15588023168213e-09, 0.0, 1.0, 6.123233995736766e-17,
                0.14892189775631642,
            ),
            (
                -0.9999999999999127, -2.558287163739808e-23, 4.1780000005242117e-07, -0.0,
                4.1780000005242117e-07, -6.123233995736231e-17, 0.9999999999999127, 0.0, 0.0, 1.0,
                6.123233995736766e-17, 0.4326956882369999,
            ),
            (
                -1.0, 1.8369696008327342e-26, -2.9999990235743137e-10, -0.0,
                -2.9999990235743137e-10, -6.123233995736766e-17, 1.0, -0.0, 0.0, 1.0,
                6.123233995736766e-17, 0.0,
            ),
            (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
        ),
        angles=(
            (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0004277699642),
            (0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0006617156617),
            (0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -0.0018179220006),
            (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 8.90468712e-05),
            (0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0009695294734),
            (0.0, 0.0, 0.0, 0.0, 0.0, 1.0, -0.0022050175347),
        ),
    ),
    0,
)


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    if _solve_from_nearest(pose, _NO_FREE, q, status):
        return
    _all_joints(_NUMBERS, pose, _NO_FREE, seed, q, status)
    _to_nearest_rows(_NO_FREE, q, status)


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "pose", apart=(_whole.compile_apart,), at_once=True,
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
