# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 4264ea173b1cd0aa
"""planar_rrr: Planar arm with three revolute joints.

Inverse kinematics, generated from robots/planar_rrr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/planar_rrr.yaml. The formulas and where they come from: planar_rrr.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 3), _runtime("arrays").zeros

NAME = "planar_rrr"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRR"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = ((-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf))
BRANCHES = ("right", "left")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

a1 = 0.4  # link length 1 [m]
a2 = 0.3  # link length 2 [m]
a3 = 0.15  # link length 3 [m]
free_limit = 1e-12  # a length that fixes no angle
longest2 = 0.48999999999999994  # square of the longest reach [m^2]
shortest2 = 0.010000000000000007  # square of the shortest reach [m^2]
longest2_reach = 0.490000000000119  # the longest, with what rounding adds [m^2]
shortest2_reach = 0.009999999999983007  # the shortest, with what rounding adds [m^2]
longest2_apart = 0.48999999999998795  # the longest, where branches merge [m^2]
shortest2_apart = 0.010000000000001705  # the shortest, where branches merge [m^2]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 8.5e-06  # a pose may be rounded by this [m]
k1 = 0.25  # a1^2 + a2^2 [m^2]
k2 = 4.166666666666667  # 1 / (2 * a2 * a1) [m^-2]
# 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4]
m1 = 5.755396159656667e-12
m2 = 1.25  # a2 * k2 [m^-1]
m3 = 0.08750000000000001  # a1 - a2 * k1 * k2 [m]
m4 = 1.666666666666667  # a1 * k2 [m^-1]
m5 = 0.1166666666666667  # k2 * (a1 * k1 + a2 * longest2 * shortest2 * k2 - a2 * k1^2 * k2) [m]
m6 = 7.225e-11  # pose_slack1^2 [m^2]
m7 = 1.0000000000000002e-10  # pose_slack^2
m8 = 1.445e-10  # 2 * pose_slack1^2 [m^2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="rotation",
    miss_weights=(1.176, 1.176, 1.176, 1.0, 1.0, 1.0), size=0.85, steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.4, 0.0),
    (0.0, 0.0, 0.3, 0.0),
    (0.0, 0.0, 0.15, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y = x2_x * c3 - x2_y * s3, x2_y * c3 + x2_x * s3
    T[0, 0], T[0, 1], T[0, 3] = x3_x, -x3_y, c1 * a1 + x2_x * a2 + x3_x * a3
    T[1, 0], T[1, 1], T[1, 3] = x3_y, x3_x, s1 * a1 + x2_y * a2 + x3_y * a3
    T[2, 2] = 1.0
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * a1, s1 * a1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    p2_x, p2_y = p1_x + x2_x * a2, p1_y + x2_y * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    p3_x, p3_y = p2_x + (x2_x * c3 - x2_y * s3) * a3, p2_y + (x2_y * c3 + x2_x * s3) * a3
    J[0, 0], J[0, 1], J[0, 2] = -p3_y, p1_y - p3_y, p2_y - p3_y
    J[1, 0], J[1, 1], J[1, 2] = p3_x, p3_x - p1_x, p3_x - p2_x
    J[5, 0], J[5, 1], J[5, 2] = 1.0, 1.0, 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, _, T13, T14, T21, _, T23, T24, T31, _, T33, T34 = pose

    # theta123, type 3: U0[2, 1] and U0[1, 1]
    w123 = math.sqrt(T21 * T21 + T11 * T11)
    short123 = w123 <= free_limit
    v1 = 1.0 / (1.0 if short123 else w123)
    c123, s123 = T11 * v1, T21 * v1
    theta123 = _atan2(s123, c123)

    # theta2, type 8: U0[1, 4] and U0[2, 4]
    v2 = c123 * a3
    Z1_2 = T14 - v2
    v3 = s123 * a3
    Z2_2 = T24 - v3
    N2 = Z1_2 * Z1_2 + Z2_2 * Z2_2
    K2 = N2 - k1
    D2_squared = (longest2 - N2) * (N2 - shortest2)
    apart2 = shortest2_apart < N2 and N2 < longest2_apart
    if not (shortest2_reach <= N2 and N2 <= longest2_reach):
        return  # out of reach
    w2 = math.sqrt(D2_squared if apart2 else 0.0)
    c2 = K2 * k2

    # theta1, type 3: U0[2, 4] and U0[1, 4]
    X1_1 = a1 + a2 * c2
    v4, v5 = Z2_2 * X1_1, Z1_2 * X1_1

    # is the pose one that the arm can take?
    if (
        not (abs(T34) <= pose_slack1 and abs(T33 - 1.0) <= pose_slack and abs(T31) <= pose_slack and
        abs(T23) <= pose_slack and abs(T21 - s123) <= pose_slack and abs(T11 - c123) <= pose_slack
        and abs(T13) <= pose_slack)
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
        S1 = v4 - Z1_2 * Y1_1
        C1 = v5 + Z2_2 * Y1_1
        w1 = math.sqrt(S1 * S1 + C1 * C1)
        factor1 = 1.0 / w1
        c1, s1 = C1 * factor1, S1 * factor1
        q1 = _atan2(s1, c1)

        # is the pose one that the arm can take?
        c12, s12 = c2 * c1 - s2 * s1, c2 * s1 + s2 * c1
        if (
            not (abs(T14 - (a2 * c12 + (v2 + a1 * c1))) <= pose_slack1 and abs(T24 - (a2 * s12 + (v3
            + a1 * s1))) <= pose_slack1)
        ):
            continue  # the arm can't take this pose

        # joint values
        q3 = _wrap(theta123 - (q2 + q1))
        row = i1
        q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
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

        # theta123, type 3: U0[2, 1] and U0[1, 1]
        v1 = T21 * T21 + T11 * T11
        v2 = math.sqrt(v1) * (1.0 / v1)

        # theta2, type 8: U0[1, 4] and U0[2, 4]
        v3 = v2 * (a3 * T11)
        Z1_2, v4 = T14 - v3, v2 * (a3 * T21)
        Z2_2 = T24 - v4
        N2 = Z1_2 * Z1_2 + Z2_2 * Z2_2
        D2_squared = (longest2 - N2) * (N2 - shortest2)
        w2 = math.sqrt(D2_squared)

        # theta1, type 3: U0[2, 4] and U0[1, 4]
        v5 = m3 + m2 * N2
        v6 = Z2_2 * v5
        S1_p, S1_m, v7 = v6 - w2 * (m2 * Z1_2), v6 - w2 * (m2 * -Z1_2), Z1_2 * v5
        C1_p, C1_m, factor1 = v7 + w2 * (m2 * Z2_2), v7 + w2 * (m2 * -Z2_2), 1.0 / N2

        # is the pose one that the arm can take?
        v8 = m4 - m5 * factor1
        v9, v10, v11 = Z1_2 * v8, Z2_2 * v8, T33 - 1.0
        v12 = v1 - 1.0
        v13 = T14 - (a2 * (v9 - w2 * (m4 * (Z2_2 * factor1))) + (v3 + a1 * (C1_p * factor1)))
        v14 = T14 - (a2 * (v9 - w2 * (m4 * (-Z2_2 * factor1))) + (v3 + a1 * (C1_m * factor1)))
        v15 = T24 - (a2 * (v10 + w2 * (m4 * (Z1_2 * factor1))) + (v4 + a1 * (S1_p * factor1)))
        v16 = T24 - (a2 * (v10 + w2 * (m4 * (-Z1_2 * factor1))) + (v4 + a1 * (S1_m * factor1)))
        v17, v18 = v13 * v13 + v15 * v15, v14 * v14 + v16 * v16

        # joint values
        v21 = math.sqrt(-1.0)
        v22 = 0.0 if v17 <= m6 else v21
        v23 = 0.0 if v18 <= m6 else v21

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if m6 < T34 * T34 or abs(D2_squared) <= m1 or m7 < v11 * v11 + T31 * T31 + T23 * T23
            + T13 * T13 + v12 * v12 or (m6 < v17 and v17 <= m8) or (m6 < v18 and v18 <= m8) else
            kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], turns[0 * w + k] = v22, v23, T21
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = w2, S1_p, S1_m
        turns[8 * w + k], turns[9 * w + k], turns[10 * w + k] = T11, N2 - k1, C1_p
        turns[11 * w + k] = C1_m
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 4 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(4 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        v22, v23, angle1 = kept[17 * w + k], kept[18 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]

        # joint values
        v19, v20, q1_p = angle1 - (angle2 + angle3), angle1 - (angle4 - angle2), angle3 + v22
        q1_m, q2_p, q2_m = angle4 + v23, angle2 + v22, v23 - angle2
        q3_p = v22 + (v19 + (turn if v19 <= -half_turn else (-turn if half_turn < v19 else 0.0)))
        q3_m = v23 + (v20 + (turn if v20 <= -half_turn else (-turn if half_turn < v20 else 0.0)))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_p, q2_p, q3_p
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q1_m, q2_m, q3_m
        rows[6 * w + k] = UNREACHABLE if q1_p != q1_p else OK
        rows[7 * w + k] = UNREACHABLE if q1_m != q1_m else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 19, 16, [
    [0, 1, 2], [3, 4, 5],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
