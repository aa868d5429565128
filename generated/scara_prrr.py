# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: b16765c183860141
"""scara_prrr: SCARA arm on a vertical slide.

Inverse kinematics, generated from robots/scara_prrr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/scara_prrr.yaml. The formulas and where they come from: scara_prrr.md.

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

NAME = "scara_prrr"
METHOD = "closed form"
DOF = 4
JOINT_TYPES = "PRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = ("right", "left")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

a2 = 0.3  # link length 2 [m]
a3 = 0.25  # link length 3 [m]
free_limit = 1e-12  # a length that fixes no angle
longest3 = 0.30250000000000005  # square of the longest reach [m^2]
shortest3 = 0.0024999999999999988  # square of the shortest reach [m^2]
longest3_reach = 0.3025000000000605  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0024999999999944992  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.30249999999999394  # the longest, where branches merge [m^2]
shortest3_apart = 0.002500000000000549  # the shortest, where branches merge [m^2]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 5.500000000000001e-06  # a pose may be rounded by this [m]
k1 = 0.1525  # a2^2 + a3^2 [m^2]
k2 = 6.666666666666667  # 1 / (2 * a3 * a2) [m^-2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m1 = 1.831867990631471e-12
m2 = 1.6666666666666667  # a3 * k2 [m^-1]
m3 = 0.045833333333333316  # a2 - a3 * k1 * k2 [m]
m4 = 1.0000000000000002e-10  # pose_slack^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="rotation",
    miss_weights=(1.818, 1.818, 1.818, 1.0, 1.0, 1.0), size=0.55,
    slacks=(5.5e-10, 1e-09, 1e-09, 1e-09), weights=(3.305785123966942, 1.0, 1.0, 1.0),
    paces=(0.55, 1.0, 1.0, 1.0), steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 0.3, 0.0),
    (0.0, 0.0, 0.25, 0.0),
    (0.0, 0.0, 0.0, 3.141592653589793),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (4,)."""
    T = _zeros(4, 4)
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y = c2 * c3 - s2 * s3, s2 * c3 + c2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x = x3_x * c4 - x3_y * s4
    T[0, 0], T[0, 1], T[0, 3] = x4_x, x3_y * c4 + x3_x * s4, c2 * a2 + x3_x * a3
    T[1, 0], T[1, 1], T[1, 3] = x3_y * c4 + x3_x * s4, -x4_x, s2 * a2 + x3_y * a3
    T[2, 2], T[2, 3] = -1.0, q[0]
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 4): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 4)
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    p2_x, p2_y = c2 * a2, s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    p3_x, p3_y = p2_x + (c2 * c3 - s2 * s3) * a3, p2_y + (s2 * c3 + c2 * s3) * a3
    J[0, 1], J[0, 2] = -p3_y, p2_y - p3_y
    J[1, 1], J[1, 2] = p3_x, p3_x - p2_x
    J[2, 0] = 1.0
    J[5, 1], J[5, 2], J[5, 3] = 1.0, 1.0, 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, _, T13, T14, T21, _, T23, T24, T31, _, T33, T34 = pose

    # theta234, type 3: U0[2, 1] and U0[1, 1]
    w234 = math.sqrt(T21 * T21 + T11 * T11)
    short234 = w234 <= free_limit
    v1 = 1.0 / (1.0 if short234 else w234)
    c234, s234 = T11 * v1, T21 * v1
    theta234 = _atan2(s234, c234)

    # theta3, type 8: U0[1, 4] and U0[2, 4]
    N3 = T14 * T14 + T24 * T24
    K3 = N3 - k1
    D3_squared = (longest3 - N3) * (N3 - shortest3)
    apart3 = shortest3_apart < N3 and N3 < longest3_apart
    if not (shortest3_reach <= N3 and N3 <= longest3_reach):
        return  # out of reach
    w3 = math.sqrt(D3_squared if apart3 else 0.0)
    c3 = K3 * k2

    # theta2, type 3: U0[2, 4] and U0[1, 4]
    X1_2 = a2 + a3 * c3
    v2, v3 = T24 * X1_2, T14 * X1_2

    # is the pose one that the arm can take?
    if (
        not (abs(1.0 + T33) <= pose_slack and abs(T31) <= pose_slack and abs(T23) <= pose_slack and
        abs(T21 - s234) <= pose_slack and abs(T11 - c234) <= pose_slack and abs(T13) <= pose_slack)
    ):
        return  # the arm can't take this pose

    for i1 in range(2):  # right, left
        e3 = 1.0 - 2.0 * i1
        # theta3
        if e3 < 0.0 and not apart3:
            continue  # both signs give the same
        s3 = w3 * e3 * k2
        q3 = _atan2(s3, c3)

        # theta2
        Y1_2 = a3 * s3
        S2 = v2 - T14 * Y1_2
        C2 = v3 + T24 * Y1_2
        w2 = math.sqrt(S2 * S2 + C2 * C2)
        factor2 = 1.0 / w2
        c2, s2 = C2 * factor2, S2 * factor2
        q2 = _atan2(s2, c2)

        # is the pose one that the arm can take?
        c23, s23 = c3 * c2 - s3 * s2, c3 * s2 + s3 * c2
        if (
            not (abs(T14 - (a3 * c23 + a2 * c2)) <= pose_slack1 and abs(T24 - (a3 * s23 + a2 * s2))
            <= pose_slack1)
        ):
            continue  # the arm can't take this pose

        # joint values
        q4 = _wrap(theta234 - (q3 + q2))
        row = i1
        q[row, 0], q[row, 1], q[row, 2] = T34, q2, q3
        q[row, 3] = q4
        status[row] = OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T11, T13, T14 = kept[0 * w + k], kept[2 * w + k], kept[3 * w + k]
        T21, T23, T24 = kept[4 * w + k], kept[6 * w + k], kept[7 * w + k]
        T31, T33, T34 = kept[8 * w + k], kept[10 * w + k], kept[11 * w + k]

        # theta3, type 8: U0[1, 4] and U0[2, 4]
        N3 = T14 * T14 + T24 * T24
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)

        # theta2, type 3: U0[2, 4] and U0[1, 4]
        v1 = m3 + m2 * N3
        v2, v3, v4 = T24 * v1, T14 * v1, w3 * (m2 * T14)
        v5 = w3 * (m2 * T24)

        # is the pose one that the arm can take?
        v6, v7 = 1.0 + T33, T21 * T21 + T11 * T11 - 1.0

        # joint values
        q1_p = w3 - w3 + T34

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if abs(D3_squared) <= m1 or m4 < v6 * v6 + T31 * T31 + T23 * T23 + T13 * T13 + v7 *
            v7 else kept[16 * w + k]
        )
        kept[17 * w + k], turns[0 * w + k], turns[1 * w + k] = q1_p, T21, w3
        turns[2 * w + k], turns[3 * w + k], turns[8 * w + k] = v2 - v4, v2 + v4, T11
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = N3 - k1, v3 + v5, v3 - v5
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 4 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(4 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        q1_p, angle1, angle2 = kept[17 * w + k], turns[0 * w + k], turns[1 * w + k]
        angle3, angle4 = turns[2 * w + k], turns[3 * w + k]

        # joint values
        v8, v9 = angle1 - (angle2 + angle3), angle1 - (angle4 - angle2)
        q4_p = v8 + (turn if v8 <= -half_turn else (-turn if half_turn < v8 else 0.0))
        q4_m = v9 + (turn if v9 <= -half_turn else (-turn if half_turn < v9 else 0.0))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_p, angle3, angle2
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_p, angle4, -angle2
        rows[6 * w + k] = q4_m
        rows[7 * w + k] = rows[8 * w + k] = UNREACHABLE if q1_p != q1_p else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 18, 16, [
    [0, 1, 2, 3], [0, 4, 5, 6],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
