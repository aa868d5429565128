# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 193c5bacd2d40f86
"""kuka_kr6_r900_calibrated: KUKA KR 6 R900 with calibration noise of 1e-4.

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

NAME = "kuka_kr6_r900_calibrated"
METHOD = "general 6R"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "back-down-noflip", "back-down-flip", "back-up-noflip", "back-up-flip", "front-up-noflip",
    "front-up-flip", "front-down-noflip", "front-down-flip", "further1", "further2", "further3",
    "further4", "further5", "further6", "further7", "further8",
)
MAX_SOLUTIONS = 16

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, near_a2 = 0.45511099999999993 [m], near_a3 = -0.025039000000000033 [m],
# near_d4 = 0.42008600000000007 [m], near_k1 = 2 * near_d4 * near_a2 = 0.382371519092 [m^2],
# near_k2 = 2 * near_a3 * near_a2 = -0.022791048658000027 [m^2],
# near_doubt_limit1 = 9.25213e-05 [m], near_longest3_apart = 0.7672753622269346 [m^2],
# near_k4 = 1 / ((2 * near_d4 * near_a2)^2 + (2 * near_a3 * near_a2)^2) = 6.815359151455662 [m^-4],
# near_doubt_limit = 9.999999999999999e-05.
d1 = 0.400051  # joint offset 1 [m]
a1 = 0.024977  # link length 1 [m]
ca1 = 3.1999999994631904e-05  # cosine of twist 1
sa1 = 0.999999999488  # sine of twist 1
d2 = -2.1e-05  # joint offset 2 [m]
a2 = 0.455111  # link length 2 [m]
ca2 = 0.999999999118  # cosine of twist 2
sa2 = 4.1999999987652e-05  # sine of twist 2
d3 = 2.5e-05  # joint offset 3 [m]
a3 = 0.025039  # link length 3 [m]
ca3 = 1.899999999890931e-05  # cosine of twist 3
sa3 = 0.9999999998195  # sine of twist 3
d4 = 0.420086  # joint offset 4 [m]
a4 = 5.1e-05  # link length 4 [m]
ca4 = 4.9999999979333415e-05  # cosine of twist 4
sa4 = 0.99999999875  # sine of twist 4
d5 = -0.000174  # joint offset 5 [m]
a5 = -8.9e-05  # link length 5 [m]
ca5 = 4.6999999982665624e-05  # cosine of twist 5
sa5 = 0.9999999988955  # sine of twist 5
d6 = 0.089995  # joint offset 6 [m]
a6 = 5.2e-05  # link length 6 [m]
ca6 = 0.999999997952  # cosine of twist 6
sa6 = 6.399999995630933e-05  # sine of twist 6
offset1 = -2.6e-05  # offset of joint 1 [rad]
offset2 = -1.5708893267948965  # offset of joint 2 [rad]
offset3 = -1.5706923267948965  # offset of joint 3 [rad]
offset4 = -0.000167  # offset of joint 4 [rad]
offset5 = 3.141423653589793  # offset of joint 5 [rad]
offset6 = 3.1e-05  # offset of joint 6 [rad]
f1 = -6.719999998872699e-10  # ca1 * d2 [m]
f2 = 1.343999999379404e-09  # ca1 * sa2
f3 = 3.1999999966407905e-05  # ca1 * ca2
near_a1 = -0.024977  # link length 1 [m]
near_longest3 = 0.7672753622269508  # square of the longest reach [m^2]
near_shortest3 = 0.001175080249049243  # square of the shortest reach [m^2]
near_k3 = 0.384225221238  # near_a2^2 + (near_a3^2 + near_d4^2) [m^2]
near_turn1 = -1.6303303533892188  # atan2(-near_k1, near_k2) [rad]
near_m1 = 8.560190953689999e-09  # near_doubt_limit1^2 [m^2]
# 1000 * (near_longest3 - near_longest3_apart) * (near_longest3_apart - near_shortest3) [m^4]
near_m3 = 1.2417915714465629e-11
near_m4 = 1.0986330807209672  # near_k4 * (near_d4 * near_k1 + near_a3 * near_k2) [m^-1]
# near_a2 - near_d4 * near_k1 * near_k3 * near_k4 - near_a3 * near_k2 * near_k3 * near_k4 [m]
near_m5 = 0.032988461500600814
near_m6 = 1.1860189164290886  # near_a2 * near_k1 * near_k4 [m^-1]
near_m7 = 0.07069201936857687  # -near_a2 * near_k2 * near_k4 [m^-1]
# near_k2 * near_k4 * (near_d4 * near_k1 * near_k3^2 * near_k4 + near_a3 * near_k2 * near_k3^2 *
# near_k4 - near_a2 * near_k3 - near_d4 * near_longest3 * near_shortest3 * near_k1 * near_k4 -
# near_a3 * near_longest3 * near_shortest3 * near_k2 * near_k4) [m]
near_m8 = 0.0021226567816523957
# near_k1 * near_k4 * (near_a2 * near_k3 + near_d4 * near_longest3 * near_shortest3 * near_k1 *
# near_k4 + near_a3 * near_longest3 * near_shortest3 * near_k2 * near_k4 - near_d4 * near_k1 *
# near_k3^2 * near_k4 - near_a3 * near_k2 * near_k3^2 * near_k4) [m]
near_m9 = 0.03561238055741952
near_m10 = 9.999999999999999e-09  # near_doubt_limit^2
near1 = 0.5  # 1 / 2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=16, size=1.4156710000000001, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0, zero=-2.6e-05),
        _joints.Joint(place=1, zero=-1.5708893267948965),
        _joints.Joint(place=2, zero=-1.5706923267948965),
        _joints.Joint(place=3, zero=-0.000167),
        _joints.Joint(place=4, zero=3.141423653589793),
        _joints.Joint(place=5, zero=3.1e-05),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.024977, 0.0, -3.1999999994631904e-05, 0.999999999488, 0.0, 0.0,
                -0.999999999488, -3.1999999994631904e-05, 0.400051,
            ),
            offset=-2.6e-05,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.455111, 0.0, 0.999999999118, -4.1999999987652e-05, 0.0, 0.0,
                4.1999999987652e-05, 0.999999999118, -2.1e-05,
            ),
            offset=-1.5708893267948965,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.025039, 0.0, 1.899999999890931e-05, 0.9999999998195, 0.0, 0.0,
                -0.9999999998195, 1.899999999890931e-05, 2.5e-05,
            ),
            offset=-1.5706923267948965,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 5.1e-05, 0.0, -4.9999999979333415e-05, -0.99999999875, 0.0, 0.0,
                0.99999999875, -4.9999999979333415e-05, 0.420086,
            ),
            offset=-0.000167,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, -8.9e-05, 0.0, 4.6999999982665624e-05, -0.9999999988955, 0.0, 0.0,
                0.9999999988955, 4.6999999982665624e-05, -0.000174,
            ),
            offset=3.141423653589793,
        ),
        _joints.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 5.2e-05, 0.0, 0.999999997952, 6.399999995630933e-05, 0.0, 0.0,
                -6.399999995630933e-05, 0.999999997952, 0.089995,
            ),
            offset=3.1e-05,
        ),
    ),
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=16, directions="rotation",
    miss_weights=(0.7064, 0.7064, 0.7064, 1.0, 1.0, 1.0), size=1.4156710000000001,
    clamped_again=1e-10,
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (-2.6e-05, 0.400051, 0.024977, -1.5708283267948966),
    (-1.5708893267948965, -2.1e-05, 0.455111, 4.2e-05),
    (-1.5706923267948965, 2.5e-05, 0.025039, -1.5707773267948966),
    (-0.000167, 0.420086, 5.1e-05, 1.5708463267948967),
    (3.141423653589793, -0.000174, -8.9e-05, 1.5707493267948966),
    (3.1e-05, 0.089995, 5.2e-05, -6.4e-05),
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
    y1_x, v2, v3 = s1 * ca1, c1 * ca1, s1 * sa1
    z1_y, v4 = c1 * sa1, q[1] + offset2
    c2, s2 = math.cos(v4), math.sin(v4)
    x2_x, x2_y, v5 = c1 * c2 + y1_x * s2, s1 * c2 - v2 * s2, sa1 * s2
    v6, v7, v8 = y1_x * c2 - c1 * s2, v2 * c2 + s1 * s2, sa1 * c2
    y2_x, y2_y, v9 = v6 * ca2 - v3 * sa2, z1_y * sa2 - v7 * ca2, v8 * ca2 + f2
    v10, z2_y, z2_z = v6 * sa2 + v3 * ca2, v7 * sa2 + z1_y * ca2, v8 * sa2 - f3
    v11 = q[2] + offset3
    c3, s3 = math.cos(v11), math.sin(v11)
    x3_x, x3_y, v12 = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, v5 * c3 + v9 * s3
    v13, v14, v15 = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, v5 * s3 - v9 * c3
    y3_x, y3_y, y3_z = v13 * ca3 + v10 * sa3, v14 * ca3 - z2_y * sa3, v15 * ca3 - z2_z * sa3
    z3_x, z3_y, z3_z = v13 * sa3 - v10 * ca3, v14 * sa3 + z2_y * ca3, v15 * sa3 + z2_z * ca3
    v16 = q[3] + offset4
    c4, s4 = math.cos(v16), math.sin(v16)
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, x3_y * c4 + y3_y * s4, y3_z * s4 - v12 * c4
    v17, v18, v19 = y3_x * c4 - x3_x * s4, y3_y * c4 - x3_y * s4, y3_z * c4 + v12 * s4
    y4_x, y4_y, y4_z = z3_x * sa4 - v17 * ca4, z3_y * sa4 - v18 * ca4, z3_z * sa4 - v19 * ca4
    v20, v21, v22 = v17 * sa4 + z3_x * ca4, v18 * sa4 + z3_y * ca4, v19 * sa4 + z3_z * ca4
    v23 = q[4] + offset5
    c5, s5 = math.cos(v23), math.sin(v23)
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, x4_z * c5 + y4_z * s5
    v24, v25, v26 = y4_x * c5 - x4_x * s5, y4_y * c5 - x4_y * s5, y4_z * c5 - x4_z * s5
    y5_x, y5_y, y5_z = v24 * ca5 - v20 * sa5, v25 * ca5 - v21 * sa5, v26 * ca5 - v22 * sa5
    v27, v28, v29 = v24 * sa5 + v20 * ca5, v25 * sa5 + v21 * ca5, v26 * sa5 + v22 * ca5
    v30 = q[5] + offset6
    c6, s6 = math.cos(v30), math.sin(v30)
    x6_x, x6_y, x6_z = x5_x * c6 + y5_x * s6, x5_y * c6 + y5_y * s6, x5_z * c6 + y5_z * s6
    v31, v32, v33 = y5_x * c6 - x5_x * s6, y5_y * c6 - x5_y * s6, y5_z * c6 - x5_z * s6
    T[0, 0], T[0, 1], T[0, 2] = x6_x, v31 * ca6 + v27 * sa6, v31 * sa6 - v27 * ca6
    T[0, 3] = (
        c1 * a1 + x2_x * a2 - v3 * d2 + x3_x * a3 - v10 * d3 + x4_x * a4 + z3_x * d4 + x5_x * a5 -
        v20 * d5 + x6_x * a6 - v27 * d6
    )
    T[1, 0], T[1, 1], T[1, 2] = x6_y, v32 * ca6 + v28 * sa6, v32 * sa6 - v28 * ca6
    T[1, 3] = (
        s1 * a1 + x2_y * a2 + z1_y * d2 + x3_y * a3 + z2_y * d3 + x4_y * a4 + z3_y * d4 + x5_y * a5
        - v21 * d5 + x6_y * a6 - v28 * d6
    )
    T[2, 0], T[2, 1], T[2, 2] = x6_z, v33 * ca6 + v29 * sa6, v33 * sa6 - v29 * ca6
    T[2, 3] = (
        d1 - v5 * a2 - f1 - v12 * a3 + z2_z * d3 + x4_z * a4 + z3_z * d4 + x5_z * a5 - v22 * d5 +
        x6_z * a6 - v29 * d6
    )
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    v1 = q[0] + offset1
    c1, s1 = math.cos(v1), math.sin(v1)
    p1_x, p1_y, y1_x = c1 * a1, s1 * a1, s1 * ca1
    v2, v3, z1_y = c1 * ca1, s1 * sa1, c1 * sa1
    v4 = q[1] + offset2
    c2, s2 = math.cos(v4), math.sin(v4)
    x2_x, x2_y, v5 = c1 * c2 + y1_x * s2, s1 * c2 - v2 * s2, sa1 * s2
    v6, v7, v8 = y1_x * c2 - c1 * s2, v2 * c2 + s1 * s2, sa1 * c2
    p2_x, p2_y, p2_z = p1_x + x2_x * a2 - v3 * d2, p1_y + x2_y * a2 + z1_y * d2, d1 - v5 * a2 - f1
    y2_x, y2_y, v9 = v6 * ca2 - v3 * sa2, z1_y * sa2 - v7 * ca2, v8 * ca2 + f2
    v10, z2_y, z2_z = v6 * sa2 + v3 * ca2, v7 * sa2 + z1_y * ca2, v8 * sa2 - f3
    v11 = q[2] + offset3
    c3, s3 = math.cos(v11), math.sin(v11)
    x3_x, x3_y, v12 = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, v5 * c3 + v9 * s3
    v13, v14, v15 = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, v5 * s3 - v9 * c3
    p3_x, p3_y = p2_x + x3_x * a3 - v10 * d3, p2_y + x3_y * a3 + z2_y * d3
    p3_z, y3_x, y3_y = p2_z - v12 * a3 + z2_z * d3, v13 * ca3 + v10 * sa3, v14 * ca3 - z2_y * sa3
    y3_z, z3_x, z3_y = v15 * ca3 - z2_z * sa3, v13 * sa3 - v10 * ca3, v14 * sa3 + z2_y * ca3
    z3_z, v16 = v15 * sa3 + z2_z * ca3, q[3] + offset4
    c4, s4 = math.cos(v16), math.sin(v16)
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, x3_y * c4 + y3_y * s4, y3_z * s4 - v12 * c4
    v17, v18, v19 = y3_x * c4 - x3_x * s4, y3_y * c4 - x3_y * s4, y3_z * c4 + v12 * s4
    p4_x, p4_y = p3_x + x4_x * a4 + z3_x * d4, p3_y + x4_y * a4 + z3_y * d4
    p4_z, y4_x, y4_y = p3_z + x4_z * a4 + z3_z * d4, z3_x * sa4 - v17 * ca4, z3_y * sa4 - v18 * ca4
    y4_z, v20, v21 = z3_z * sa4 - v19 * ca4, v17 * sa4 + z3_x * ca4, v18 * sa4 + z3_y * ca4
    v22, v23 = v19 * sa4 + z3_z * ca4, q[4] + offset5
    c5, s5 = math.cos(v23), math.sin(v23)
    x5_x, x5_y, x5_z = x4_x * c5 + y4_x * s5, x4_y * c5 + y4_y * s5, x4_z * c5 + y4_z * s5
    v24, v25, v26 = y4_x * c5 - x4_x * s5, y4_y * c5 - x4_y * s5, y4_z * c5 - x4_z * s5
    p5_x, p5_y = p4_x + x5_x * a5 - v20 * d5, p4_y + x5_y * a5 - v21 * d5
    p5_z, v27, v28 = p4_z + x5_z * a5 - v22 * d5, v24 * sa5 + v20 * ca5, v25 * sa5 + v21 * ca5
    v29, v30 = v26 * sa5 + v22 * ca5, q[5] + offset6
    c6, s6 = math.cos(v30), math.sin(v30)
    p6_x = p5_x + (x5_x * c6 + (v24 * ca5 - v20 * sa5) * s6) * a6 - v27 * d6
    p6_y = p5_y + (x5_y * c6 + (v25 * ca5 - v21 * sa5) * s6) * a6 - v28 * d6
    p6_z, v31 = p5_z + (x5_z * c6 + (v26 * ca5 - v22 * sa5) * s6) * a6 - v29 * d6, p6_x - p1_x
    v32, v33, v34 = p6_y - p1_y, p6_z - d1, p6_x - p2_x
    v35, v36, v37 = p6_y - p2_y, p6_z - p2_z, p6_x - p3_x
    v38, v39, v40 = p6_y - p3_y, p6_z - p3_z, p6_x - p4_x
    v41, v42, v43 = p6_y - p4_y, p6_z - p4_z, p6_x - p5_x
    v44, v45 = p6_y - p5_y, p6_z - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, z1_y * v33 + ca1 * v32, z2_y * v36 - z2_z * v35
    J[0, 3], J[0, 4] = z3_y * v39 - z3_z * v38, v22 * v41 - v21 * v42
    J[0, 5] = v29 * v44 - v28 * v45
    J[1, 0], J[1, 1], J[1, 2] = p6_x, v3 * v33 - ca1 * v31, z2_z * v34 + v10 * v36
    J[1, 3], J[1, 4] = z3_z * v37 - z3_x * v39, v20 * v42 - v22 * v40
    J[1, 5] = v27 * v45 - v29 * v43
    J[2, 1], J[2, 2] = -(v3 * v32 + z1_y * v31), -(v10 * v35 + z2_y * v34)
    J[2, 3], J[2, 4] = z3_x * v38 - z3_y * v37, v21 * v40 - v20 * v41
    J[2, 5] = v28 * v43 - v27 * v44
    J[3, 1], J[3, 2], J[3, 3] = -v3, -v10, z3_x
    J[3, 4], J[3, 5] = -v20, -v27
    J[4, 1], J[4, 2], J[4, 3] = z1_y, z2_y, z3_y
    J[4, 4], J[4, 5] = -v21, -v28
    J[5, 0], J[5, 1], J[5, 2] = 1.0, -ca1, z2_z
    J[5, 3], J[5, 4], J[5, 5] = z3_z, -v22, -v29
    return J


_loops, _whole = _runtime("general.arm"), _runtime("general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.4508946910409257, reach=4.0000000039999986,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.055394309350457506,
            -2.9538461533506374e-05, -1.2307692305627655e-05, 0.999999999488, 5.907378613838845e-06,
            -0.9230769226043077, -0.38461538441846155, -3.1999999994631904e-05,
            8.872383044631429e-10,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, 1.0093509838169543, 0.8823529403982353,
            0.4705882348790589, -4.1999999987652006e-05, -2.4523306599316377e-09,
            3.705882351851647e-05, 1.976470587654212e-05, 0.9999999991180001, 5.907378588330026e-06,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.05553181374168657, 1.8239999998952937e-05, 5.319999999694607e-06,
            0.9999999998195, 0.46583605016172774, -0.95999999982672, -0.27999999994946007,
            1.899999999890931e-05, 5.907378744506423e-06,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.00011310845084971505,
            -3.620689653675868e-05, -3.448275860643684e-05, -0.99999999875, 0.00018130380869483623,
            0.7241379301293104, 0.6896551715517242, -4.9999999979333415e-05, 0.46583605065572053,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, -0.00019738533579656157,
            4.445945944306208e-05, 1.5243243237621286e-05, -0.9999999988955001,
            -9.615993722573778e-09, 0.9459459449011487, 0.32432432396610816, 4.699999998266563e-05,
            -0.000204595611172669,
        )),
        _loops.Link((
            0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.40005099951471357,
        )),
        _loops.Link((
            1.0, 0.0, 0.0, -5.2e-05, 0.0, 0.999999997952, -6.399999995630933e-05,
            5.759679718576826e-06, 0.0, 6.399999995630933e-05, 0.999999997952, -0.08999499547988973,
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
        v1 = T14 * T14 + T24 * T24
        w1, v2 = math.sqrt(v1), 1.0 / v1

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        Z2_3_p, v3, v4 = w1 - near_a1, near_a1 + w1, T34 * T34
        N3_p, N3_m = v4 + Z2_3_p * Z2_3_p, v4 + v3 * v3
        v5, v6, v7 = near_longest3 - N3_p, near_longest3 - N3_m, N3_p - near_shortest3
        v8, D3_squared_p = N3_m - near_shortest3, v5 * v7
        D3_squared_m, w3_p = v6 * v8, math.sqrt(D3_squared_p)
        w3_m = math.sqrt(D3_squared_m)

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        X1_2_p, X1_2_m = near_m5 + near_m4 * N3_p, near_m5 + near_m4 * N3_m
        v11, v12, v13 = T34 * X1_2_p, T34 * X1_2_m, Z2_3_p * X1_2_p
        v14, v15, factor2_p = v3 * X1_2_m, near_m4 * T34, 1.0 / N3_p
        factor2_m, v16, v17 = 1.0 / N3_m, w3_p * v15, w3_m * (near_m4 * v3)
        v18 = w3_m * v15

        # theta4, type 2: U4[3, 3]
        v19 = near_m7 * T34
        v20, v21, v22 = v19 - near_m6 * Z2_3_p, v19 + near_m6 * v3, near_m8 * factor2_p - near_m7
        v23, v24 = near_m8 * factor2_m - near_m7, near_m9 * factor2_p - near_m6
        v25, v26 = near_m9 * factor2_m - near_m6, Z2_3_p * v22 + T34 * v24
        v27, v28, v29 = T34 * v25 - v3 * v23, factor2_p * v20, factor2_p * -v20
        v30, c23_pp, c23_pm = factor2_m * v21, v26 + w3_p * v28, v26 + w3_p * v29
        v31 = w3_m * v30
        c23_mp, c23_mm, v32 = v27 + v31, v27 - v31, near_m6 * T34
        v33, v34, v35 = v32 + near_m7 * Z2_3_p, v32 - near_m7 * v3, Z2_3_p * -v24 + T34 * v22
        v36, v37, v38 = T34 * v23 - v3 * -v25, factor2_p * v33, factor2_m * v34
        v39, v40 = factor2_m * -v34, w3_p * v37
        s23_pp, s23_pm, s23_mp = v35 - v40, v35 + v40, v36 - w3_m * v38
        s23_mm, v41 = v36 - w3_m * v39, T14 * T13 + T24 * T23
        v42 = v2 * v41
        v43 = w1 * v42
        c4_pp, c4_pm = s23_pp * T33 + c23_pp * v43, s23_pm * T33 + c23_pm * v43
        c4_mp, c4_mm = s23_mp * T33 - c23_mp * v43, s23_mm * T33 - c23_mm * v43
        v44 = T24 * T13 - T14 * T23
        Y4 = w1 * (v2 * v44)
        v45 = Y4 * Y4
        v46, v47, v48 = v45 + c4_pp * c4_pp, v45 + c4_pm * c4_pm, v45 + c4_mp * c4_mp
        v49, v50 = v45 + c4_mm * c4_mm, math.copysign(half_turn, Y4)
        v51 = math.copysign(half_turn, -Y4)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v52, v53 = w1 * (v2 * (T14 * T22 - T24 * T12)), w1 * (v2 * (T14 * T12 + T24 * T22))
        v54, v55 = w1 * (v2 * (T14 * T21 - T24 * T11)), w1 * (v2 * (T14 * T11 + T24 * T21))
        v56 = c4_pp * v54 + Y4 * (s23_pp * T31 + c23_pp * v55)
        v57 = c4_pm * v54 + Y4 * (s23_pm * T31 + c23_pm * v55)

        # by how much these differ at poses so near: slopes and rests
        v58, v59, v60 = T34 * given2, abs(T34), abs(given2)
        v61, v62, v63 = v58 + v58, v60 * v60, T14 * given2
        v64, v65 = v63 + v63, T24 * given2
        v66, v67, v68 = v65 + v65, v62 + v62, near1 / w1
        v69, v70, v71 = v64 * v68, v66 * v68, v67 * abs(v68)
        v72, v73, v74 = v71 + math.sqrt(v69 * v69 + v70 * v70), Z2_3_p * v69, v3 * v69
        v75, v76, v77 = Z2_3_p * v70, v3 * v70, abs(Z2_3_p)
        v78, v79 = abs(v3), v71 * v77
        v80, v81, v82 = v71 * v78, v73 + v73, v74 + v74
        v83, v84, v85 = v75 + v75, v76 + v76, v72 * v72
        v86, v87, v88 = v62 + (v85 + (v79 + v79)), v62 + (v85 + (v80 + v80)), v61 * v61
        v89 = v86 + math.sqrt(v88 + (v81 * v81 + v83 * v83))
        v90, v91 = v87 + math.sqrt(v88 + (v82 * v82 + v84 * v84)), v5 * v81 - v7 * v81
        v92, v93, v94 = v6 * v82 - v8 * v82, v5 * v83 - v7 * v83, v6 * v84 - v8 * v84
        v95, v96 = v5 * v61 - v7 * v61, v6 * v61 - v8 * v61
        v97 = v86 * abs(v5) + v86 * abs(v7) + v89 * v89
        v98 = v87 * abs(v6) + v87 * abs(v8) + v90 * v90
        v99 = v97 + math.sqrt(v91 * v91 + v93 * v93 + v95 * v95)
        v100, v101, v102 = v98 + math.sqrt(v92 * v92 + v94 * v94 + v96 * v96), v62 + v85, w1 * v2
        v103, v104, v105 = T33 * given1, T23 * given1, near1 * (given1 * given1)
        v106, v107, v108 = T24 * v103, v105 * abs(T24), T13 * given2
        v109, v110 = v103 * v103, v104 * v104
        v111, v112, v113 = v60 * (v105 + math.sqrt(v109 + v110)), T13 * given1, T14 * v103
        v114, v115, v116 = v105 * abs(T14), T23 * given2, v112 * v112
        v117, v118 = v60 * (v105 + math.sqrt(v109 + v116)), T24 * v104 + T14 * v112
        v119, v120, v121 = v107 + v111 + (v114 + v117), abs(v2), v2 * (v2 * v64)
        v122, v123, v124 = v2 * (v2 * v66), v120 * (v67 * v120), w1 - math.sqrt(v67)
        v125 = (
            v123 + (v123 + (abs(v121) + abs(v122))) * ((v67 + math.sqrt(v64 * v64 + v66 * v66)) /
            (v124 * v124))
        )
        v126, v127 = abs(w1), v125 + math.sqrt(v121 * v121 + v122 * v122)
        v128, v129 = v2 * v69 - w1 * v121, v2 * v70 - w1 * v122
        v130, v131, v132 = v125 * v126 + v71 * v120 + v72 * v127, v102 * v113, v102 * v106
        v133, v134 = v102 * v118, v113 * v113 + v106 * v106
        v135, v136 = math.sqrt(v115 * v115 + v108 * v108), v44 * v128 - v102 * v115
        v137 = v44 * v129 + v102 * v108
        v138 = (
            v130 * abs(v44) + v119 * abs(v102) + (v119 + (v135 + math.sqrt(v134 + v118 * v118))) *
            (v130 + math.sqrt(v128 * v128 + v129 * v129)) + (math.sqrt(v131 * v131 + v132 * v132 +
            v133 * v133) + math.sqrt(v136 * v136 + v137 * v137))
        )
        v139, v140, v141 = abs(factor2_p), abs(factor2_m), factor2_p * (factor2_p * v81)
        v142, v143 = factor2_m * (factor2_m * v82), factor2_p * (factor2_p * v83)
        v144, v145 = factor2_m * (factor2_m * v84), factor2_p * (factor2_p * v61)
        v146, v147, v148 = factor2_m * (factor2_m * v61), v139 * (v86 * v139), v140 * (v87 * v140)
        v149 = math.sqrt(v101)
        v150, v151 = math.sqrt(N3_p) - v149, math.sqrt(N3_m) - v149
        v152 = v147 + (v147 + (abs(v145) + (abs(v141) + abs(v143)))) * (v89 / (v150 * v150))
        v153 = v148 + (v148 + (abs(v146) + (abs(v142) + abs(v144)))) * (v90 / (v151 * v151))
        v154, v155, v156 = near_m9 * v141, near_m9 * v142, near_m9 * v143
        v157, v158, v159 = near_m9 * v144, near_m9 * v145, near_m9 * v146
        v160, v161 = near_m9 * v152, near_m9 * v153
        v162 = v152 + math.sqrt(v141 * v141 + v143 * v143 + v145 * v145)
        v163 = v153 + math.sqrt(v142 * v142 + v144 * v144 + v146 * v146)
        v164 = v160 + math.sqrt(v154 * v154 + v156 * v156 + v158 * v158)
        v165, v166 = v161 + math.sqrt(v155 * v155 + v157 * v157 + v159 * v159), near_m8 * v141
        v167, v168, v169 = near_m8 * v142, near_m8 * v143, near_m8 * v144
        v170, v171, v172 = near_m8 * v145, near_m8 * v146, near_m8 * v152
        v173, v174 = near_m8 * v153, v172 + math.sqrt(v166 * v166 + v168 * v168 + v170 * v170)
        v175 = v173 + math.sqrt(v167 * v167 + v169 * v169 + v171 * v171)
        v176, v177 = Z2_3_p * v154 + -v24 * v69 - T34 * v166, v3 * v155 + -v25 * v69 + T34 * v167
        v178, v179 = Z2_3_p * v156 + -v24 * v70 - T34 * v168, v3 * v157 + -v25 * v70 + T34 * v169
        v180 = Z2_3_p * v158 + (v22 * given2 - T34 * v170)
        v181 = v23 * given2 - T34 * v171 - v3 * v159
        v182 = v77 * v160 + v71 * abs(-v24) + v72 * v164 + (v59 * v172 + v60 * v174)
        v183 = v78 * v161 + v71 * abs(-v25) + v72 * v165 + (v59 * v173 + v60 * v175)
        v184, v185 = near1 / w3_p, near1 / w3_m
        v186, v187, v188 = v91 * v184, v92 * v185, v93 * v184
        v189, v190, v191 = v94 * v185, v95 * v184, v96 * v185
        v192, v193 = v99 * v184, v100 * v185
        v194, v195 = v192 * v192 / w3_p, v193 * v193 / w3_m
        v196, v197 = v194 + (v194 + v97 * abs(v184)), v195 + (v195 + v98 * abs(v185))
        v198, v199, v200 = near_m6 * given2, near_m7 * v69, near_m7 * v70
        v201, v202, v203 = near_m7 * v71, factor2_p * v199 - v33 * v141, factor2_m * v199
        v204, v205, v206 = v203 + v34 * v142, v203 - -v34 * v142, factor2_p * v200 - v33 * v143
        v207 = factor2_m * v200
        v208, v209, v210 = v207 + v34 * v144, v207 - -v34 * v144, factor2_p * v198 - v33 * v145
        v211 = factor2_m * v198
        v212, v213 = v211 - v34 * v146, v211 + -v34 * v146
        v214 = v201 + math.sqrt(v198 * v198 + (v199 * v199 + v200 * v200))
        v215 = v139 * v201 + v152 * abs(v33) + v162 * v214
        v216, v217, v218 = v140 * v201 + v153 * abs(v34) + v163 * v214, abs(w3_p), abs(w3_m)
        v219 = v196 + math.sqrt(v186 * v186 + v188 * v188 + v190 * v190)
        v220, v221 = v197 + math.sqrt(v187 * v187 + v189 * v189 + v191 * v191), v37 * v186
        v222, v223 = v176 - (w3_p * v202 + v221), v176 - (w3_p * -v202 - v221)
        v224, v225 = v177 + (v38 * v187 - w3_m * v204), v177 + (w3_m * v205 + v39 * v187)
        v226 = v37 * v188
        v227, v228 = v178 - (w3_p * v206 + v226), v178 - (w3_p * -v206 - v226)
        v229, v230 = v179 + (v38 * v189 - w3_m * v208), v179 + (w3_m * v209 + v39 * v189)
        v231 = v37 * v190
        v232, v233 = v180 - (w3_p * v210 + v231), v180 - (w3_p * -v210 - v231)
        v234, v235 = v181 - (w3_m * v212 + v38 * v191), v181 - (v39 * v191 - w3_m * v213)
        v236 = v215 * v217 + v196 * abs(v37)
        v237 = v182 + (v236 + v219 * (v215 + math.sqrt(v202 * v202 + v206 * v206 + v210 * v210)))
        v238 = (
            v182 + (v236 + v219 * (v215 + math.sqrt(-v202 * -v202 + -v206 * -v206 + -v210 * -v210)))
        )
        v239 = v216 * v218
        v240 = (
            v183 + (v239 + v197 * abs(v38) + v220 * (v216 + math.sqrt(v204 * v204 + v208 * v208 +
            v212 * v212)))
        )
        v241 = (
            v183 + (v239 + v197 * abs(v39) + v220 * (v216 + math.sqrt(v205 * v205 + v209 * v209 +
            v213 * v213)))
        )
        v242, v243 = abs(T33), v105 + math.sqrt(v110 + v116)
        v244, v245 = v22 * v69 - Z2_3_p * v166 - T34 * v154, v3 * v167 - v23 * v69 - T34 * v155
        v246, v247 = v22 * v70 - Z2_3_p * v168 - T34 * v156, v3 * v169 - v23 * v70 - T34 * v157
        v248 = v24 * given2 - T34 * v158 - Z2_3_p * v170
        v249 = v25 * given2 - T34 * v159 + v3 * v171
        v250 = v77 * v172 + v71 * abs(v22) + v72 * v174 + (v59 * v160 + v60 * v164)
        v251 = v78 * v173 + v71 * abs(v23) + v72 * v175 + (v59 * v161 + v60 * v165)
        v252, v253, v254 = near_m7 * given2, near_m6 * v69, near_m6 * v70
        v255, v256 = near_m6 * v71, factor2_p * v253
        v257, v258, v259 = v256 + v20 * v141, -v20 * v141 - v256, v21 * v142 - factor2_m * v253
        v260 = factor2_p * v254
        v261, v262, v263 = v260 + v20 * v143, -v20 * v143 - v260, v21 * v144 - factor2_m * v254
        v264 = factor2_p * v252
        v265, v266, v267 = v264 - v20 * v145, v264 + -v20 * v145, factor2_m * v252 - v21 * v146
        v268 = v255 + math.sqrt(v252 * v252 + (v253 * v253 + v254 * v254))
        v269 = v139 * v255 + v152 * abs(v20) + v162 * v268
        v270, v271 = v140 * v255 + v153 * abs(v21) + v163 * v268, v244 + (v28 * v186 - w3_p * v257)
        v272, v273 = v244 + (v29 * v186 - w3_p * v258), v30 * v187
        v274, v275 = v245 + (v273 - w3_m * v259), v245 - (v273 + w3_m * -v259)
        v276, v277 = v246 + (v28 * v188 - w3_p * v261), v246 + (v29 * v188 - w3_p * v262)
        v278 = v30 * v189
        v279, v280 = v247 + (v278 - w3_m * v263), v247 - (v278 + w3_m * -v263)
        v281, v282 = v248 + (w3_p * v265 + v28 * v190), v248 + (v29 * v190 - w3_p * v266)
        v283 = v30 * v191
        v284, v285, v286 = v249 + (w3_m * v267 + v283), v249 + (w3_m * -v267 - v283), v217 * v269
        v287 = (
            v250 + (v286 + v196 * abs(v28) + v219 * (v269 + math.sqrt(v257 * v257 + v261 * v261 +
            v265 * v265)))
        )
        v288 = (
            v250 + (v286 + v196 * abs(v29) + v219 * (v269 + math.sqrt(v258 * v258 + v262 * v262 +
            v266 * v266)))
        )
        v289 = v218 * v270 + v197 * abs(v30)
        v290 = v251 + (v289 + v220 * (v270 + math.sqrt(v259 * v259 + v263 * v263 + v267 * v267)))
        v291 = (
            v251 + (v289 + v220 * (v270 + math.sqrt(-v259 * -v259 + -v263 * -v263 + -v267 * -v267)))
        )
        v292, v293, v294 = T24 * v112 - T14 * v104, v111 + v114 + (v107 + v117), v2 * v106
        v295, v296, v297 = v2 * v113, v2 * v292, v2 * v108 - v41 * v121
        v298 = v2 * v115 - v41 * v122
        v299 = (
            v120 * v293 + v125 * abs(v41) + v127 * (v293 + (v135 + math.sqrt(v134 + v292 * v292)))
        )
        v300, v301, v302 = w1 * v294, w1 * v295, w1 * v296
        v303, v304 = w1 * v297 + v42 * v69, w1 * v298 + v42 * v70
        v305 = (
            v126 * v299 + v71 * abs(v42) + v72 * (v299 + (math.sqrt(v294 * v294 + v295 * v295 + v296
            * v296) + math.sqrt(v297 * v297 + v298 * v298)))
        )
        v306 = abs(v43)
        v307 = (
            v305 + (math.sqrt(v300 * v300 + v301 * v301 + v302 * v302) + math.sqrt(v303 * v303 +
            v304 * v304))
        )
        v308, v309, v310 = c23_pp * v302, c23_pm * v302, c23_mp * v302
        v311, v312 = c23_mm * v302, s23_pp * v104 - c23_pp * v300
        v313, v314 = s23_pm * v104 - c23_pm * v300, s23_mp * v104 + c23_mp * v300
        v315, v316 = s23_mm * v104 + c23_mm * v300, c23_pp * v301 - s23_pp * v112
        v317, v318 = c23_pm * v301 - s23_pm * v112, c23_mp * v301 + s23_mp * v112
        v319, v320 = c23_mm * v301 + s23_mm * v112, T33 * v222 + (c23_pp * v303 + v43 * v271)
        v321 = T33 * v223 + (c23_pm * v303 + v43 * v272)
        v322 = T33 * v224 + (c23_mp * v303 + v43 * v274)
        v323 = T33 * v225 + (c23_mm * v303 + v43 * v275)
        v324 = T33 * v227 + (c23_pp * v304 + v43 * v276)
        v325 = T33 * v228 + (c23_pm * v304 + v43 * v277)
        v326 = T33 * v229 + (c23_mp * v304 + v43 * v279)
        v327, v328 = T33 * v230 + (c23_mm * v304 + v43 * v280), T33 * v232 + v43 * v281
        v329, v330, v331 = T33 * v233 + v43 * v282, T33 * v234 - v43 * v284, T33 * v235 - v43 * v285
        v332 = (
            v105 * abs(s23_pp) + v237 * v242 + v243 * (v237 + math.sqrt(v222 * v222 + v227 * v227 +
            v232 * v232)) + (v305 * abs(c23_pp) + v287 * v306 + v307 * (v287 + math.sqrt(v271 * v271
            + v276 * v276 + v281 * v281))) + (math.sqrt(v312 * v312 + v316 * v316 + v308 * v308) +
            math.sqrt(v320 * v320 + v324 * v324 + v328 * v328))
        )
        v333 = (
            v105 * abs(s23_pm) + v238 * v242 + v243 * (v238 + math.sqrt(v223 * v223 + v228 * v228 +
            v233 * v233)) + (v305 * abs(c23_pm) + v288 * v306 + v307 * (v288 + math.sqrt(v272 * v272
            + v277 * v277 + v282 * v282))) + (math.sqrt(v313 * v313 + v317 * v317 + v309 * v309) +
            math.sqrt(v321 * v321 + v325 * v325 + v329 * v329))
        )
        v334 = (
            v105 * abs(s23_mp) + v240 * v242 + v243 * (v240 + math.sqrt(v224 * v224 + v229 * v229 +
            v234 * v234)) + (v305 * abs(c23_mp) + v290 * v306 + v307 * (v290 + math.sqrt(v274 * v274
            + v279 * v279 + v284 * v284))) + (math.sqrt(v314 * v314 + v318 * v318 + v310 * v310) +
            math.sqrt(v322 * v322 + v326 * v326 + v330 * v330))
        )
        v335 = (
            v105 * abs(s23_mm) + v241 * v242 + v243 * (v241 + math.sqrt(v225 * v225 + v230 * v230 +
            v235 * v235)) + (v305 * abs(c23_mm) + v291 * v306 + v307 * (v291 + math.sqrt(v275 * v275
            + v280 * v280 + v285 * v285))) + (math.sqrt(v315 * v315 + v319 * v319 + v311 * v311) +
            math.sqrt(v323 * v323 + v327 * v327 + v331 * v331))
        )
        v336 = v138 * v138

        # a joint is free, or branches meet
        kept[18 * w + k] = (
            1.0 if abs(v100 + (D3_squared_m + D3_squared_m)) <= v100 or abs(D3_squared_m) <= near_m3
            or abs(v99 + (D3_squared_p + D3_squared_p)) <= v99 or abs(D3_squared_p) <= near_m3 or
            abs(v49) <= v336 + v335 * v335 or v49 <= near_m10 or abs(v48) <= v336 + v334 * v334 or
            v48 <= near_m10 or abs(v47) <= v336 + v333 * v333 or v47 <= near_m10 or abs(v46) <= v336
            + v332 * v332 or v46 <= near_m10 or abs(N3_m) <= v101 or v1 <= near_m1 or abs(v1) <= v67
            or abs(N3_p) <= v101 else kept[18 * w + k]
        )
        kept[19 * w + k], kept[20 * w + k], kept[21 * w + k] = w3_p, w3_m, c23_mp
        kept[22 * w + k], kept[23 * w + k], kept[24 * w + k] = c23_mm, s23_mp, s23_mm
        kept[25 * w + k], kept[26 * w + k], kept[27 * w + k] = c4_mp, c4_mm, Y4
        kept[28 * w + k], kept[29 * w + k], kept[30 * w + k] = v50, v51, v54
        kept[31 * w + k], kept[32 * w + k], kept[33 * w + k] = v55, v56, v57
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = T24, w3_p, w3_m
        turns[3 * w + k] = v11 - w3_p * (near_m4 * Z2_3_p)
        turns[4 * w + k], turns[5 * w + k] = v11 - w3_p * (near_m4 * -Z2_3_p), v12 + v17
        turns[6 * w + k], turns[7 * w + k], turns[8 * w + k] = v12 - v17, Y4, Y4
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = -Y4, -Y4, math.sqrt(v46)
        turns[12 * w + k], turns[13 * w + k] = math.sqrt(v47), math.sqrt(v48)
        turns[14 * w + k], turns[15 * w + k], turns[16 * w + k] = math.sqrt(v49), v56, v57
        turns[17 * w + k] = -(c4_mp * v54 + Y4 * (s23_mp * T31 - c23_mp * v55))
        turns[18 * w + k] = -(c4_mm * v54 + Y4 * (s23_mm * T31 - c23_mm * v55))
        turns[24 * w + k], turns[25 * w + k] = T14, N3_p - near_k3
        turns[26 * w + k], turns[27 * w + k] = N3_m - near_k3, v13 + v16
        turns[28 * w + k], turns[29 * w + k], turns[30 * w + k] = v13 - v16, v18 - v14, -(v14 + v18)
        turns[31 * w + k], turns[32 * w + k], turns[33 * w + k] = c4_pp, c4_pm, c4_mp
        turns[34 * w + k], turns[35 * w + k] = c4_mm, c23_pp * T33 - s23_pp * v43
        turns[36 * w + k] = c23_pm * T33 - s23_pm * v43
        turns[37 * w + k] = c23_mp * T33 + s23_mp * v43
        turns[38 * w + k] = c23_mm * T33 + s23_mm * v43
        turns[39 * w + k] = c4_pp * v52 + Y4 * (s23_pp * T32 + c23_pp * v53)
        turns[40 * w + k] = c4_pm * v52 + Y4 * (s23_pm * T32 + c23_pm * v53)
        turns[41 * w + k] = -(c4_mp * v52 + Y4 * (s23_mp * T32 - c23_mp * v53))
        turns[42 * w + k] = -(c4_mm * v52 + Y4 * (s23_mm * T32 - c23_mm * v53))
    if w == 1 and kept[18] != 0.0:
        return
    end = 24 if w == 1 else 19 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(19 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        T24, T31, w3_p = kept[7 * w + k], kept[8 * w + k], kept[19 * w + k]
        w3_m, c23_mp, c23_mm = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        s23_mp, s23_mm, c4_mp = kept[23 * w + k], kept[24 * w + k], kept[25 * w + k]
        c4_mm, Y4, v50 = kept[26 * w + k], kept[27 * w + k], kept[28 * w + k]
        v51, v54, v55 = kept[29 * w + k], kept[30 * w + k], kept[31 * w + k]
        v56, v57, angle1 = kept[32 * w + k], kept[33 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle8, angle9, angle10 = turns[7 * w + k], turns[8 * w + k], turns[9 * w + k]
        angle11, angle12, angle13 = turns[10 * w + k], turns[11 * w + k], turns[12 * w + k]
        angle14, angle15, angle16 = turns[13 * w + k], turns[14 * w + k], turns[15 * w + k]
        angle17, angle18, angle19 = turns[16 * w + k], turns[17 * w + k], turns[18 * w + k]

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        q3__pp, v9, q3__mp = angle2 - near_turn1, near_turn1 + angle2, angle3 - near_turn1
        v10 = near_turn1 + angle3

        # theta4, type 2: U4[3, 3]
        q4_ppm, q4_pmm, q4_mpm = angle8 - v50, angle9 - v50, angle10 - v51
        q4_mmm = angle11 - v51

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle16 - math.copysign(half_turn, v56)
        q6_pmm = angle17 - math.copysign(half_turn, v57)
        q6_mpm = (
            angle18 - math.copysign(half_turn, -(c4_mp * v54 + Y4 * (s23_mp * T31 - c23_mp * v55)))
        )
        q6_mmm = (
            angle19 - math.copysign(half_turn, -(c4_mm * v54 + Y4 * (s23_mm * T31 - c23_mm * v55)))
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
        rows[34 * w + k] = rows[35 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[36 * w + k] = rows[37 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[38 * w + k] = rows[39 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[40 * w + k] = rows[41 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 34, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 19, 20, 21, 22], [17, 18, 19, 23, 24, 25], [17, 26, 27, 28, 29, 30],
    [17, 26, 27, 31, 32, 33],
])

_solve_from_nearest, _to_nearest_rows = _nearest.of_nearest(
    _HOW,
    _NUMBERS,
    _FORMULAS,
    _nearest.Nearest(
        turned=0.0002205921, moved=0.000348204,
        left=(
            -0.9999999999999449, -3.321999999999817e-07, 0.0, -0.0, 3.321999999999817e-07,
            -0.9999999999999449, 0.0, -0.0, 0.0, 0.0, 1.0, -0.400051,
        ),
        right=(
            1.0, -0.0, 0.0, -5.2e-05, 0.0, 0.9999999979520001, -6.3999999996928e-05,
            5.759779999723332e-06, 0.0, 6.3999999996928e-05, 0.9999999979520001,
            -0.08999499981568386,
        ),
        offsets=(0.0, 3.141592651689793, -3.141592651689793, 3.1415926548897932, 0.0, 0.0),
        solved=(0, 1, 2, 3, 4, 5),
        links=(
            (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
            (
                1.0, -0.0, 0.0, -0.024977, 0.0, 6.123233995736766e-17, -1.0, -0.0, 0.0, 1.0,
                6.123233995736766e-17, 0.0,
            ),
            (
                -1.0, -1.9000002796713848e-09, 0.0, -0.45511099999999993, 1.9000002796713848e-09,
                -1.0, 0.0, 8.647110272815235e-10, 0.0, 0.0, 1.0, 0.0,
            ),
            (
                -1.0, 1.1634146304393186e-25, -1.9000002796713848e-09, 0.025039000000000033,
                -1.9000002796713848e-09, -6.123233995736766e-17, 1.0, 4.757410700269187e-11, 0.0,
                1.0, 6.123233995736766e-17, 0.0,
            ),
            (
                -1.0, 7.960204103208153e-26, -1.2999999850978024e-09, -0.0, -1.2999999850978024e-09,
                -6.123233995736766e-17, 1.0, -0.0, 0.0, 1.0, 6.123233995736766e-17,
                0.42008600000000007,
            ),
            (
                1.0, -0.0, 0.0, 0.0, 0.0, 6.123233995736766e-17, -1.0, 0.0, 0.0, 1.0,
                6.123233995736766e-17, 0.0,
            ),
            (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
        ),
        angles=(
            (1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -2.6e-05),
            (0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.5708893267948965),
            (0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.5706923267948965),
            (0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -0.000167),
            (0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 3.141423653589793),
            (0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 3.1e-05),
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
