# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: fcfe06ceda5e7cac
"""kuka_kr40pa: KUKA KR 40 PA palletizer, serial equivalent.

Inverse kinematics, generated from robots/kuka_kr40pa.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kuka_kr40pa.yaml. The formulas and where they come from:
kuka_kr40pa.md.

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
_wrap = _runtime("angles").wrap
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 4), _runtime("arrays").zeros

NAME = "kuka_kr40pa"
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
# exact_slack1 = 2.1999999999999995e-12 [m], pose_slack1 = 2.2e-05 [m].
d1 = 0.3  # joint offset 1 [m]
a1 = 0.15  # link length 1 [m]
a2 = 0.8  # link length 2 [m]
a3 = 0.8  # link length 3 [m]
a4 = 0.15  # link length 4 [m]
free_limit = 1e-12  # a length that fixes no angle
longest3 = 2.5600000000000005  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
longest3_reach = 2.5600704004840003  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0  # the shortest, with what rounding adds [m^2]
longest3_apart = 2.55999999999993  # the longest, where branches merge [m^2]
shortest3_apart = 4.839999999999999e-28  # the shortest, where branches merge [m^2]
free_limit_squared2 = 4.839999999999999e-24  # square of a length that fixes no angle [m^2]
doubtful_slack = 0.01  # a row may miss the pose by this before it is refined
doubtful_slack1 = 0.022  # a row may miss the pose by this before it is refined [m]
k1 = 1.2800000000000002  # 2 * a3 * a2 [m^2]
k2 = 0.7812499999999999  # 1 / k1 [m^-2]
doubt_limit_squared2 = 4.839999999999999e-08  # square of a length that fixes no angle [m^2]
m1 = 9.999999999999999e-09  # doubt_limit^2
m2 = 0.0001802301952675207  # -1 * (longest3 - longest3_reach) * (longest3_reach - shortest3) [m^4]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 1.8076207197736452e-10
m4 = 0.625  # a3 * k2 [m^-1]
m5 = 1e-24  # exact_slack^2
m6 = 4.839999999999998e-24  # exact_slack1^2 [m^2]
m7 = 1.452e-09  # 3 * pose_slack1^2 [m^2]
m8 = 0.0014519999999999997  # 3 * doubtful_slack1^2 [m^2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=2, size=2.1999999999999997, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0),
        _joints.Joint(place=1),
        _joints.Joint(place=2),
        _joints.Joint(place=3),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.15, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.3)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.8, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.8, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.15, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0)),
    ),
    checked=True,
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="rotation",
    miss_weights=(0.4545, 0.4545, 0.4545, 1.0, 1.0, 1.0), size=2.1999999999999997,
    entries=(0, 2, 3, 4, 6, 7, 8, 10, 11), steps=("completes", "equations end all", "follows seed"),
), _joints.arm_numbers(_LINKS))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.3, 0.15, -1.5707963267948966),
    (0.0, 0.0, 0.8, 0.0),
    (0.0, 0.0, 0.8, 0.0),
    (0.0, 0.0, 0.15, 1.5707963267948966),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (4,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v3 = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v4, v5, y3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - v4 * s4, x3_y * c4 - v5 * s4, y3_z * s4 - v3 * c4
    T[0, 0], T[0, 1], T[0, 2] = x4_x, -s1, v4 * c4 + x3_x * s4
    T[0, 3] = c1 * a1 + x2_x * a2 + x3_x * a3 + x4_x * a4
    T[1, 0], T[1, 1], T[1, 2] = x4_y, c1, v5 * c4 + x3_y * s4
    T[1, 3] = s1 * a1 + x2_y * a2 + x3_y * a3 + x4_y * a4
    T[2, 0], T[2, 2], T[2, 3] = x4_z, -(y3_z * c4 + v3 * s4), d1 - s2 * a2 - v3 * a3 + x4_z * a4
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 4): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * a1, s1 * a1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2, p2_x, p2_y = s1 * s2, p1_x + x2_x * a2, p1_y + x2_y * a2
    p2_z = d1 - s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v3 = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    p3_x, p3_y, p3_z = p2_x + x3_x * a3, p2_y + x3_y * a3, p2_z - v3 * a3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    p4_x = p3_x + (x3_x * c4 - (v1 * c3 + x2_x * s3) * s4) * a4
    p4_y = p3_y + (x3_y * c4 - (v2 * c3 + x2_y * s3) * s4) * a4
    p4_z = p3_z + ((s2 * s3 - c2 * c3) * s4 - v3 * c4) * a4
    v4, v5, v6 = p4_z - d1, p4_z - p2_z, p4_z - p3_z
    J[0, 0], J[0, 1], J[0, 2] = -p4_y, c1 * v4, c1 * v5
    J[0, 3] = c1 * v6
    J[1, 0], J[1, 1], J[1, 2] = p4_x, s1 * v4, s1 * v5
    J[1, 3] = s1 * v6
    J[2, 1] = -(s1 * (p4_y - p1_y) + c1 * (p4_x - p1_x))
    J[2, 2] = -(s1 * (p4_y - p2_y) + c1 * (p4_x - p2_x))
    J[2, 3] = -(s1 * (p4_y - p3_y) + c1 * (p4_x - p3_x))
    J[3, 1], J[3, 2], J[3, 3] = -s1, -s1, -s1
    J[4, 1], J[4, 2], J[4, 3] = c1, c1, c1
    J[5, 0] = 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, _, T33, T34 = pose

    # theta234, type 3: U0[3, 3] and U0[3, 1]
    w234 = math.sqrt(T31 * T31 + T33 * T33)
    short234 = w234 <= free_limit
    factor234 = 1.0 / (1.0 if short234 else w234)
    c234, v1 = T33 * factor234, T31 * factor234
    theta234 = _atan2(-v1, c234)

    # theta1, type 3: U0[1, 2] and U0[2, 2]
    w1 = math.sqrt(T12 * T12 + T22 * T22)
    short1 = w1 <= free_limit
    v2 = 1.0 / (1.0 if short1 else w1)
    c1, v3 = T22 * v2, T12 * v2
    q1 = _atan2(-v3, c1)

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v4 = v1 * a4
    Z1_3 = T34 - d1 - v4
    v5 = a1 + c234 * a4
    Z2_3 = c1 * T14 - v3 * T24 - v5
    N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
    K3 = N3 - k1
    D3_squared = (longest3 - N3) * (N3 - shortest3)
    apart3 = shortest3_apart < N3 and N3 < longest3_apart
    if not (shortest3_reach <= N3 and N3 <= longest3_reach):
        return  # out of reach
    w3 = math.sqrt(D3_squared if apart3 else 0.0)
    c3 = K3 * k2

    # theta2, type 3: U1[1, 4] and U1[2, 4]
    Y1_2 = a2 + a3 * c3
    v7, v9 = Z1_3 * Y1_2, Z2_3 * Y1_2

    # is the pose one that the arm can take?
    v11 = d1 + v4
    if (
        not (abs(T33 - c234) <= doubtful_slack and abs(T31 - v1) <= doubtful_slack and abs(T23 - v1
        * v3) <= doubtful_slack and abs(T21 + c234 * v3) <= doubtful_slack and abs(T11 - c234 * c1)
        <= doubtful_slack and abs(T13 + v1 * c1) <= doubtful_slack)
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
        v8 = Z2_3 * v6 + v7
        C2 = v9 - Z1_3 * v6
        w2 = math.sqrt(v8 * v8 + C2 * C2)
        free2 = w2 <= free_limit_squared2
        factor2 = 1.0 / (1.0 if free2 else w2)
        c2 = math.cos(seed[1]) if free2 else C2 * factor2
        s2 = math.sin(seed[1]) if free2 else -(v8 * factor2)
        q2 = _atan2(s2, c2)

        # is the pose one that the arm can take?
        c23, s23 = c3 * c2 - s3 * s2, c3 * s2 + s3 * c2
        v10 = a3 * c23 + (v5 + a2 * c2)
        if (
            not (abs(T34 + (a3 * s23 + (a2 * s2 - v11))) <= doubtful_slack1 and abs(T14 - c1 * v10)
            <= doubtful_slack1 and abs(T24 + v3 * v10) <= doubtful_slack1)
        ):
            continue  # the arm can't take this pose

        # joint values
        q4 = _wrap(theta234 - (q3 + q2))
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
        T11, T12, T13 = kept[0 * w + k], kept[1 * w + k], kept[2 * w + k]
        T14, T21, T22 = kept[3 * w + k], kept[4 * w + k], kept[5 * w + k]
        T23, T24, T31 = kept[6 * w + k], kept[7 * w + k], kept[8 * w + k]
        T33, T34 = kept[10 * w + k], kept[11 * w + k]

        # theta234, type 3: U0[3, 3] and U0[3, 1]
        v1 = T31 * T31 + T33 * T33
        factor234 = math.sqrt(v1) * (1.0 / v1)

        # theta1, type 3: U0[1, 2] and U0[2, 2]
        v2 = T12 * T12 + T22 * T22
        v3 = math.sqrt(v2) * (1.0 / v2)
        c1, v4 = T22 * v3, T12 * v3

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        v5 = factor234 * (a4 * T31)
        Z1_3, v6 = T34 - d1 - v5, a1 + factor234 * (a4 * T33)
        Z2_3 = c1 * T14 - v4 * T24 - v6
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        v7, v8, v9 = w3 * (m4 * Z2_3), w3 * (m4 * -Z2_3), m4 * (Z1_3 * N3)
        v10, v11, v12 = v7 + v9, v8 + v9, m4 * (Z2_3 * N3)
        factor2, v13 = 1.0 / N3, m4 * (N3 * -Z1_3)

        # is the pose one that the arm can take?
        v14, v15, v16 = v6 + Z2_3, d1 + v5, T23 - factor234 * (T31 * v4)
        v17, v18 = T21 + factor234 * (T33 * v4), T11 - factor234 * (T33 * c1)
        v19, v20 = T13 + factor234 * (T31 * c1), v1 - 1.0
        v21 = T34 + (factor2 * (a3 * (v7 + v13)) - (v15 + factor2 * (a2 * v10)))
        v22 = T34 + (factor2 * (a3 * (v8 + v13)) - (v15 + factor2 * (a2 * v11)))
        v23, v24 = T14 - c1 * v14, T24 + v4 * v14
        v25, v26 = v23 * v23, v24 * v24
        v27, v28 = v26 + (v25 + v21 * v21), v26 + (v25 + v22 * v22)
        exact__p, exact__m = v27 <= m6, v28 <= m6

        # joint values
        v31 = math.sqrt(-1.0)
        v32 = 0.0 if exact__p else v31
        v33 = 0.0 if exact__m else v31

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if (-m2 <= D3_squared and D3_squared <= m3) or v2 <= m1 or N3 <=
            doubt_limit_squared2 or m5 < v16 * v16 + v17 * v17 + v18 * v18 + v19 * v19 + v20 * v20
            or ((v27 <= m8 or v28 <= m8) and not (exact__p or exact__m)) or (m6 < v27 and v27 <= m7)
            or (m6 < v28 and v28 <= m7) else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = w3, v32, v33
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = -T31, w3, -v10
        turns[3 * w + k], turns[4 * w + k], turns[8 * w + k] = -v11, -T12, T33
        turns[9 * w + k], turns[10 * w + k] = N3 - k1, v12 - w3 * (m4 * Z1_3)
        turns[11 * w + k], turns[12 * w + k] = v12 - w3 * (m4 * -Z1_3), T22
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 5 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(5 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        w3, v32, v33 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5 = turns[3 * w + k], turns[4 * w + k]

        # joint values
        v29, v30, v34 = angle1 - (angle2 + angle3), angle1 - (angle4 - angle2), angle5 + (w3 - w3)
        q1_p, q1_m, q2_p = v32 + v34, v33 + v34, angle3 + v32
        q2_m, q3_p, q3_m = angle4 + v33, angle2 + v32, v33 - angle2
        q4_p = v32 + (v29 + (turn if v29 <= -half_turn else (-turn if half_turn < v29 else 0.0)))
        q4_m = v33 + (v30 + (turn if v30 <= -half_turn else (-turn if half_turn < v30 else 0.0)))

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
