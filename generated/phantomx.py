# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: d79ae5d065226016
"""phantomx: Interbotix PhantomX Pincher.

Inverse kinematics, generated from robots/phantomx.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/phantomx.yaml. The formulas and where they come from: phantomx.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in mm, angles in rad. Every entry of
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
_wrap = _runtime("angles").wrap
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 4), _runtime("arrays").zeros

NAME = "phantomx"
METHOD = "closed form"
DOF = 4
JOINT_TYPES = "RRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = ("elbow+", "elbow-")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit = 9.999999999999999e-05, exact_slack = 1e-12,
# exact_slack1 = 3.55e-10 [mm], pose_slack1 = 0.00355 [mm].
d1 = 40.0  # joint offset 1 [mm]
a2 = 105.0  # link length 2 [mm]
a3 = 105.0  # link length 3 [mm]
a4 = 105.0  # link length 4 [mm]
free_limit = 1e-12  # a length that fixes no angle
longest3 = 44100.0  # square of the longest reach [mm^2]
shortest3 = 0.0  # square of the shortest reach [mm^2]
longest3_reach = 44101.4910126025  # the longest, with what rounding adds [mm^2]
shortest3_reach = 0.0  # the shortest, with what rounding adds [mm^2]
longest3_apart = 44099.99999999851  # the longest, where branches merge [mm^2]
shortest3_apart = 1.26025e-23  # the shortest, where branches merge [mm^2]
free_limit_squared2 = 1.26025e-19  # square of a length that fixes no angle [mm^2]
offset2 = 1.5707963267948966  # offset of joint 2 [rad]
doubtful_slack = 0.01  # a row may miss the pose by this before it is refined
doubtful_slack1 = 3.5500000000000003  # a row may miss the pose by this before it is refined [mm]
k1 = 22050.0  # 2 * a3 * a2 [mm^2]
k2 = 4.5351473922902495e-05  # 1 / k1 [mm^-2]
doubt_limit_squared2 = 0.0012602499999999999  # square of a length that fixes no angle [mm^2]
m1 = 9.999999999999999e-09  # doubt_limit^2
m2 = 65755.87888877846  # -1 * (longest3 - longest3_reach) * (longest3_reach - shortest3) [mm^4]
m3 = 0.06577829481102304  # 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [mm^4]
m4 = 0.004761904761904762  # a3 * k2 [mm^-1]
m5 = 1e-24  # exact_slack^2
m6 = 1.2602500000000002e-19  # exact_slack1^2 [mm^2]
m7 = 3.780750000000001e-05  # 3 * pose_slack1^2 [mm^2]
m8 = 37.807500000000005  # 3 * doubtful_slack1^2 [mm^2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=2, size=355.0, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0),
        _joints.Joint(place=1, zero=1.5707963267948966),
        _joints.Joint(place=2),
        _joints.Joint(place=3),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 40.0)),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, -105.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0),
            offset=1.5707963267948966,
        ),
        _joints.ChainJoint((1.0, 0.0, 0.0, -105.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
        _joints.ChainJoint((0.0, 0.0, -1.0, -105.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0)),
    ),
    checked=True,
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="rotation",
    miss_weights=(0.002817, 0.002817, 0.002817, 1.0, 1.0, 1.0), size=355.0,
    entries=(0, 2, 3, 4, 6, 7, 8, 10, 11), steps=("completes", "equations end all", "follows seed"),
), _joints.arm_numbers(_LINKS))

# The table at q = 0, standard: theta [rad], d [mm], a [mm], alpha [rad].
TABLE = (
    (0.0, 40.0, 0.0, -1.5707963267948966),
    (1.5707963267948966, 0.0, -105.0, 3.141592653589793),
    (0.0, 0.0, -105.0, 0.0),
    (0.0, 0.0, -105.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    tool=(0.0, 0.0, -1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (4,)."""
    T = _zeros(4, 4)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, y2_x = c1 * c2, s1 * c2, c1 * s2
    y2_y = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, c2 * s3 - s2 * c3
    y3_x, y3_y, y3_z = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, c2 * c3 + s2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + y3_x * s4, x3_y * c4 + y3_y * s4, x3_z * c4 + y3_z * s4
    T[0, 0], T[0, 1], T[0, 2] = x3_x * s4 - y3_x * c4, s1, -x4_x
    T[0, 3] = -(x2_x * a2 + x3_x * a3 + x4_x * a4)
    T[1, 0], T[1, 1], T[1, 2] = x3_y * s4 - y3_y * c4, -c1, -x4_y
    T[1, 3] = -(x2_y * a2 + x3_y * a3 + x4_y * a4)
    T[2, 0], T[2, 2], T[2, 3] = x3_z * s4 - y3_z * c4, -x4_z, d1 + s2 * a2 - x3_z * a3 - x4_z * a4
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 4): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 4)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, y2_x = c1 * c2, s1 * c2, c1 * s2
    y2_y, v2, v3 = s1 * s2, x2_x * a2, x2_y * a2
    p2_z = d1 + s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, c2 * s3 - s2 * c3
    v4, v5, p3_z = v2 + x3_x * a3, v3 + x3_y * a3, p2_z - x3_z * a3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    v6 = v4 + (x3_x * c4 + (y2_x * c3 - x2_x * s3) * s4) * a4
    J11 = v5 + (x3_y * c4 + (y2_y * c3 - x2_y * s3) * s4) * a4
    p4_z = p3_z - (x3_z * c4 + (c2 * c3 + s2 * s3) * s4) * a4
    v7, v8, v9 = p4_z - d1, p4_z - p2_z, p4_z - p3_z
    J[0, 0], J[0, 1], J[0, 2] = J11, c1 * v7, -(c1 * v8)
    J[0, 3] = -(c1 * v9)
    J[1, 0], J[1, 1], J[1, 2] = -v6, s1 * v7, -(s1 * v8)
    J[1, 3] = -(s1 * v9)
    J[2, 1], J[2, 2] = s1 * J11 + c1 * v6, s1 * (v3 - J11) + c1 * (v2 - v6)
    J[2, 3] = s1 * (v5 - J11) + c1 * (v4 - v6)
    J[3, 1], J[3, 2], J[3, 3] = -s1, s1, s1
    J[4, 1], J[4, 2], J[4, 3] = c1, -c1, -c1
    J[5, 0] = 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, T12, T13, T14, _, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 3: U0[1, 3] and U0[2, 3]
    w1 = math.sqrt(T12 * T12 + T22 * T22)
    short1 = w1 <= free_limit
    v1 = 1.0 / (1.0 if short1 else w1)
    v2 = T22 * v1
    s1 = T12 * v1
    q1 = _atan2(s1, -v2)

    # theta2m3m4, type 3: U0[3, 2] and U0[3, 1]
    w2m3m4 = math.sqrt(T33 * T33 + T31 * T31)
    short2m3m4 = w2m3m4 <= free_limit
    factor2m3m4 = 1.0 / (1.0 if short2m3m4 else w2m3m4)
    v3 = T31 * factor2m3m4
    s2m3m4 = T33 * factor2m3m4
    theta2m3m4 = _atan2(s2m3m4, -v3)

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v4 = s2m3m4 * a4
    Z1_3 = T34 - d1 - v4
    v5 = v3 * a4
    Z2_3 = s1 * T24 - v2 * T14 - v5
    N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
    K3 = N3 - k1
    D3_squared = (longest3 - N3) * (N3 - shortest3)
    apart3 = shortest3_apart < N3 and N3 < longest3_apart
    if not (shortest3_reach <= N3 and N3 <= longest3_reach):
        return  # out of reach
    w3 = math.sqrt(D3_squared if apart3 else 0.0)
    c3 = K3 * k2

    # theta2, type 3: U1[1, 4] and U1[2, 4]
    X2_2 = a2 + a3 * c3
    v7, v8, v10 = Z1_3 * X2_2, Z2_3 * X2_2, seed[1] + offset2

    # is the pose one that the arm can take?
    v12 = d1 + v4
    if (
        not (abs(T32) <= doubtful_slack and abs(s2m3m4 - T33) <= doubtful_slack and abs(T22 - v2) <=
        doubtful_slack and abs(s1 * v3 - T23) <= doubtful_slack and abs(T13 + v2 * v3) <=
        doubtful_slack and abs(T12 - s1) <= doubtful_slack)
    ):
        return  # the arm can't take this pose

    for i1 in range(2):  # elbow+, elbow-
        e3 = 1.0 - 2.0 * i1
        # theta3
        if e3 < 0.0 and not apart3:
            continue  # both signs give the same
        s3 = w3 * e3 * k2
        q3 = _atan2(s3, c3)

        # theta2
        v6 = a3 * s3
        S2 = v7 - Z2_3 * v6
        v9 = Z1_3 * v6 + v8
        w2 = math.sqrt(S2 * S2 + v9 * v9)
        free2 = w2 <= free_limit_squared2
        factor2 = 1.0 / (1.0 if free2 else w2)
        c2 = math.cos(v10) if free2 else -(v9 * factor2)
        s2 = math.sin(v10) if free2 else S2 * factor2
        theta2 = _atan2(s2, c2)

        # is the pose one that the arm can take?
        c2m3 = c3 * c2 + s3 * s2
        s2m3 = c3 * s2 - s3 * c2
        v11 = a3 * c2m3 + (a2 * c2 - v5)
        if (
            not (abs(T34 - (a3 * s2m3 + (a2 * s2 + v12))) <= doubtful_slack1 and abs(T14 - v2 * v11)
            <= doubtful_slack1 and abs(T24 + s1 * v11) <= doubtful_slack1)
        ):
            continue  # the arm can't take this pose

        # joint values
        q2 = _wrap(theta2 - offset2)
        q4 = _wrap(theta2 - q3 - theta2m3m4)
        row = i1
        q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
        q[row, 3] = q4
        status[row] = FREE_JOINT if free2 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T12, T13, T14 = kept[1 * w + k], kept[2 * w + k], kept[3 * w + k]
        T22, T23, T24 = kept[5 * w + k], kept[6 * w + k], kept[7 * w + k]
        T31, T32, T33 = kept[8 * w + k], kept[9 * w + k], kept[10 * w + k]
        T34 = kept[11 * w + k]

        # theta1, type 3: U0[1, 3] and U0[2, 3]
        v1 = T12 * T12 + T22 * T22
        v2 = math.sqrt(v1) * (1.0 / v1)
        v3, s1 = T22 * v2, T12 * v2

        # theta2m3m4, type 3: U0[3, 2] and U0[3, 1]
        v4 = T33 * T33 + T31 * T31
        factor2m3m4 = math.sqrt(v4) * (1.0 / v4)

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        v5 = factor2m3m4 * (a4 * T33)
        Z1_3, v6 = T34 - d1 - v5, factor2m3m4 * (a4 * T31)
        Z2_3 = s1 * T24 - v3 * T14 - v6
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        v7, v8, v9 = w3 * (m4 * Z2_3), w3 * (m4 * -Z2_3), m4 * (Z1_3 * N3)
        S2_p, S2_m, v10 = v9 - v7, v9 - v8, m4 * (Z2_3 * N3)
        factor2 = 1.0 / N3

        # is the pose one that the arm can take?
        v11, v12, v13 = -Z2_3 - v6, d1 + v5, T33 * factor2m3m4 - T33
        v14, v15, v16 = factor2m3m4 * (s1 * T31) - T23, T13 + factor2m3m4 * (v3 * T31), v1 - 1.0
        v17 = T34 - (v12 + factor2 * (a2 * S2_p) + factor2 * (a3 * (v7 + v9)))
        v18, v19 = T34 - (v12 + factor2 * (a2 * S2_m) + factor2 * (a3 * (v8 + v9))), T14 - v3 * v11
        v20, v21 = T24 + s1 * v11, v19 * v19
        v22 = v20 * v20
        v23, v24 = v22 + (v21 + v17 * v17), v22 + (v21 + v18 * v18)
        exact__p, exact__m = v23 <= m6, v24 <= m6

        # joint values
        v29 = math.sqrt(-1.0)
        v30 = 0.0 if exact__p else v29
        v31 = 0.0 if exact__m else v29

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if (-m2 <= D3_squared and D3_squared <= m3) or v4 <= m1 or N3 <=
            doubt_limit_squared2 or m5 < T32 * T32 + v13 * v13 + v14 * v14 + v15 * v15 + v16 * v16
            or ((v23 <= m8 or v24 <= m8) and not (exact__p or exact__m)) or (m6 < v23 and v23 <= m7)
            or (m6 < v24 and v24 <= m7) else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = w3, v30, v31
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = T33, w3, S2_p
        turns[3 * w + k], turns[4 * w + k], turns[8 * w + k] = S2_m, T12, -T31
        turns[9 * w + k], turns[10 * w + k] = N3 - k1, -(v10 + w3 * (m4 * Z1_3))
        turns[11 * w + k], turns[12 * w + k] = -(v10 + w3 * (m4 * -Z1_3)), -T22
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 5 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(5 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        w3, v30, v31 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5 = turns[3 * w + k], turns[4 * w + k]

        # joint values
        v25, v26, v27 = angle3 - offset2, angle4 - offset2, angle3 - angle2 - angle1
        v28, v32 = angle2 + angle4 - angle1, angle5 + (w3 - w3)
        q1_p, q1_m = v30 + v32, v31 + v32
        q2_p = v30 + (v25 + (turn if v25 <= -half_turn else 0.0))
        q2_m = v31 + (v26 + (turn if v26 <= -half_turn else 0.0))
        q3_p, q3_m = angle2 + v30, v31 - angle2
        q4_p = v30 + (v27 + (turn if v27 <= -half_turn else (-turn if half_turn < v27 else 0.0)))
        q4_m = v31 + (v28 + (turn if v28 <= -half_turn else (-turn if half_turn < v28 else 0.0)))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_p, q2_p, q3_p
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_p, q1_m, q2_m
        rows[6 * w + k], rows[7 * w + k] = q3_m, q4_m
        rows[8 * w + k] = UNREACHABLE if q1_p != q1_p else OK
        rows[9 * w + k] = UNREACHABLE if q1_m != q1_m else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 20, 16, [
    [0, 1, 2, 3], [4, 5, 6, 7],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "pose", _FORMULAS, apart=(_runtime("complete").compile_apart,),
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
