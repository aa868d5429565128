# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: b31fa5ddf560b3f9
"""adept_cobra600: Adept Cobra 600.

Inverse kinematics, generated from robots/adept_cobra600.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/adept_cobra600.yaml. The formulas and where they come from:
adept_cobra600.md.

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

NAME = "adept_cobra600"
METHOD = "closed form"
DOF = 4
JOINT_TYPES = "RRPR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = ("right", "left")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = 0.387  # joint offset 1 [m]
a1 = 0.325  # link length 1 [m]
a2 = 0.275  # link length 2 [m]
free_limit = 1e-12  # a length that fixes no angle
longest2 = 0.3600000000000001  # square of the longest reach [m^2]
shortest2 = 0.0024999999999999988  # square of the shortest reach [m^2]
longest2_reach = 0.36000000000011856  # the longest, with what rounding adds [m^2]
shortest2_reach = 0.002499999999990129  # the shortest, with what rounding adds [m^2]
longest2_apart = 0.3599999999999883  # the longest, where branches merge [m^2]
shortest2_apart = 0.002500000000000986  # the shortest, where branches merge [m^2]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 9.87e-06  # a pose may be rounded by this [m]
k1 = 0.18125000000000002  # a1^2 + a2^2 [m^2]
k2 = 5.594405594405594  # 1 / (2 * a2 * a1) [m^-2]
# 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4]
m1 = 4.2270353883820664e-12
m2 = 1.5384615384615385  # a2 * k2 [m^-1]
m3 = 0.04615384615384612  # a1 - a2 * k1 * k2 [m]
m4 = 9.74169e-11  # pose_slack1^2 [m^2]
m5 = 1.0000000000000002e-10  # pose_slack^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="rotation",
    miss_weights=(1.013, 1.013, 1.013, 1.0, 1.0, 1.0), size=0.987,
    slacks=(1e-09, 1e-09, 9.87e-10, 1e-09), weights=(1.0, 1.0, 1.0265159330670552, 1.0),
    paces=(1.0, 1.0, 0.987, 1.0), steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.387, 0.325, 0.0),
    (0.0, 0.0, 0.275, 3.141592653589793),
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 0.0, 0.0),
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
    x2_x, x2_y = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    v1, v2 = x2_y * s4, x2_y * c4
    T[0, 0], T[0, 1], T[0, 3] = x2_x * c4 + v1, v2 - x2_x * s4, c1 * a1 + x2_x * a2
    T[1, 0], T[1, 1], T[1, 3] = v2 + -x2_x * s4, -x2_x * c4 - v1, s1 * a1 + x2_y * a2
    T[2, 2], T[2, 3] = -1.0, d1 - q[2]
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 4): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * a1, s1 * a1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    p2_x, p2_y = p1_x + (c1 * c2 - s1 * s2) * a2, p1_y + (s1 * c2 + c1 * s2) * a2
    J[0, 0], J[0, 1] = -p2_y, p1_y - p2_y
    J[1, 0], J[1, 1] = p2_x, p2_x - p1_x
    J[2, 2] = -1.0
    J[5, 0], J[5, 1], J[5, 3] = 1.0, 1.0, -1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, _, T13, T14, T21, _, T23, T24, T31, _, T33, T34 = pose

    # r3, type 1: U0[3, 4]
    r3 = d1 - T34

    # theta12m4, type 3: U0[2, 1] and U0[1, 1]
    w12m4 = math.sqrt(T21 * T21 + T11 * T11)
    short12m4 = w12m4 <= free_limit
    v1 = 1.0 / (1.0 if short12m4 else w12m4)
    c12m4 = T11 * v1
    s12m4 = T21 * v1
    theta12m4 = _atan2(s12m4, c12m4)

    # theta2, type 8: U0[1, 4] and U0[2, 4]
    N2 = T14 * T14 + T24 * T24
    K2 = N2 - k1
    D2_squared = (longest2 - N2) * (N2 - shortest2)
    apart2 = shortest2_apart < N2 and N2 < longest2_apart
    if not (shortest2_reach <= N2 and N2 <= longest2_reach):
        return  # out of reach
    w2 = math.sqrt(D2_squared if apart2 else 0.0)
    c2 = K2 * k2

    # theta1, type 3: U0[2, 4] and U0[1, 4]
    X1_1 = a1 + a2 * c2
    v2, v3 = T24 * X1_1, T14 * X1_1

    # is the pose one that the arm can take?
    if (
        not (abs(T34 - (d1 - r3)) <= pose_slack1 and abs(1.0 + T33) <= pose_slack and abs(T31) <=
        pose_slack and abs(T23) <= pose_slack and abs(T21 - s12m4) <= pose_slack and abs(T11 -
        c12m4) <= pose_slack and abs(T13) <= pose_slack)
    ):
        return  # the arm can't take this pose

    for i1 in range(2):  # right, left
        e2 = 1.0 - 2.0 * i1
        # theta2
        if e2 < 0.0 and not apart2:
            continue  # both signs give the same
        s2 = w2 * e2 * k2
        q2 = _atan2(s2, c2)

        # theta1
        Y1_1 = a2 * s2
        S1 = v2 - T14 * Y1_1
        C1 = v3 + T24 * Y1_1
        w1 = math.sqrt(S1 * S1 + C1 * C1)
        factor1 = 1.0 / w1
        c1, s1 = C1 * factor1, S1 * factor1
        q1 = _atan2(s1, c1)

        # is the pose one that the arm can take?
        c12, s12 = c2 * c1 - s2 * s1, c2 * s1 + s2 * c1
        if (
            not (abs(T14 - (a2 * c12 + a1 * c1)) <= pose_slack1 and abs(T24 - (a2 * s12 + a1 * s1))
            <= pose_slack1)
        ):
            continue  # the arm can't take this pose

        # joint values
        q4 = _wrap(q2 + q1 - theta12m4)
        row = i1
        q[row, 0], q[row, 1], q[row, 2] = q1, q2, r3
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

        # r3, type 1: U0[3, 4]
        r3 = d1 - T34

        # theta2, type 8: U0[1, 4] and U0[2, 4]
        N2 = T14 * T14 + T24 * T24
        D2_squared = (longest2 - N2) * (N2 - shortest2)
        w2 = math.sqrt(D2_squared)

        # theta1, type 3: U0[2, 4] and U0[1, 4]
        v1 = m3 + m2 * N2
        v2, v3, v4 = T24 * v1, T14 * v1, w2 * (m2 * T14)
        v5 = w2 * (m2 * T24)

        # is the pose one that the arm can take?
        v6, v7, v8 = T34 - (d1 - r3), 1.0 + T33, T21 * T21 + T11 * T11 - 1.0

        # joint values
        q3_p = r3 + (w2 - w2)

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if m4 < v6 * v6 or m5 < v7 * v7 + T31 * T31 + T23 * T23 + T13 * T13 + v8 * v8 or
            abs(D2_squared) <= m1 else kept[16 * w + k]
        )
        kept[17 * w + k], turns[0 * w + k], turns[1 * w + k] = q3_p, T21, w2
        turns[2 * w + k], turns[3 * w + k], turns[8 * w + k] = v2 - v4, v2 + v4, T11
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = N2 - k1, v3 + v5, v3 - v5
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 4 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(4 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        q3_p, angle1, angle2 = kept[17 * w + k], turns[0 * w + k], turns[1 * w + k]
        angle3, angle4 = turns[2 * w + k], turns[3 * w + k]

        # joint values
        v9, v10 = angle2 + angle3 - angle1, angle4 - angle2 - angle1
        q4_p = v9 + (turn if v9 <= -half_turn else (-turn if half_turn < v9 else 0.0))
        q4_m = v10 + (turn if v10 <= -half_turn else (-turn if half_turn < v10 else 0.0))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle3, angle2, q3_p
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_p, angle4, -angle2
        rows[6 * w + k] = q4_m
        rows[7 * w + k] = UNREACHABLE if angle3 != angle3 else OK
        rows[8 * w + k] = UNREACHABLE if angle4 != angle4 else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 18, 16, [
    [0, 1, 2, 3], [4, 5, 2, 6],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
