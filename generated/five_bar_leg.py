# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 5e95f08d2a024264
"""five_bar_leg: Planar five-bar linkage (RR legs): a leg.

Inverse kinematics, generated from robots/five_bar.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/five_bar.yaml. The formulas and where they come from: five_bar_leg.md,
of a leg of five_bar.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, x =
T[0, 3] and y = T[1, 3] counts; other entries are ignored.
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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 2), _runtime("arrays").zeros

NAME = "five_bar_leg"
METHOD = "closed form"
DOF = 2
JOINT_TYPES = "RR"
JOINT_NAMES = ("joint1", "joint2")
JOINT_LIMITS = ((-math.inf, math.inf), (-math.inf, math.inf))
BRANCHES = ("right", "left")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

crank = 0.2  # link length 1 [m]
rod = 0.3  # link length 2 [m]
longest2 = 0.25  # square of the longest reach [m^2]
shortest2 = 0.009999999999999995  # square of the shortest reach [m^2]
longest2_reach = 0.25000000000004996  # the longest, with what rounding adds [m^2]
shortest2_reach = 0.009999999999989996  # the shortest, with what rounding adds [m^2]
longest2_apart = 0.249999999999995  # the longest, where branches merge [m^2]
shortest2_apart = 0.010000000000000994  # the shortest, where branches merge [m^2]
k1 = 0.13  # crank^2 + rod^2 [m^2]
k2 = 8.333333333333334  # 1 / (2 * rod * crank) [m^-2]
# 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4]
m1 = 1.1990408665951442e-12
m2 = 2.5  # rod * k2 [m^-1]
m3 = 0.125  # rod * k1 * k2 - crank [m]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="none",
    miss_weights=(2.0, 2.0, 0.0, 0.0, 0.0, 0.0), size=0.5, steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.2, 0.0),
    (0.0, 0.0, 0.3, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (2,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    T[0, 0], T[0, 1], T[0, 3] = x2_x, -x2_y, c1 * crank + x2_x * rod
    T[1, 0], T[1, 1], T[1, 3] = x2_y, x2_x, s1 * crank + x2_y * rod
    T[2, 2] = 1.0
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 2): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 2)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * crank, s1 * crank
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    p2_x, p2_y = p1_x + (c1 * c2 - s1 * s2) * rod, p1_y + (s1 * c2 + c1 * s2) * rod
    J[0, 0], J[0, 1] = -p2_y, p1_y - p2_y
    J[1, 0], J[1, 1] = p2_x, p2_x - p1_x
    J[5, 0], J[5, 1] = 1.0, 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, _ = pose

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
    X1_1 = crank + rod * c2
    v1, v2 = T24 * X1_1, T14 * X1_1

    for i1 in range(2):  # right, left
        e2 = 1.0 - 2.0 * i1
        # theta2
        if e2 < 0.0 and not apart2:
            continue  # both signs give the same
        s2 = w2 * e2 * k2
        q2 = _atan2(s2, c2)

        # theta1
        Y1_1 = rod * s2
        S1 = v1 - T14 * Y1_1
        C1 = v2 + T24 * Y1_1
        w1 = math.sqrt(S1 * S1 + C1 * C1)
        factor1 = 1.0 / w1
        c1, s1 = C1 * factor1, S1 * factor1
        q1 = _atan2(s1, c1)
        row = i1
        q[row, 0], q[row, 1] = q1, q2
        status[row] = OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T14, T24 = kept[3 * w + k], kept[7 * w + k]

        # theta2, type 8: U0[1, 4] and U0[2, 4]
        N2 = T14 * T14 + T24 * T24
        D2_squared = (longest2 - N2) * (N2 - shortest2)
        w2 = math.sqrt(D2_squared)

        # theta1, type 3: U0[2, 4] and U0[1, 4]
        v1 = m2 * N2 - m3
        v2, v3, v4 = T24 * v1, T14 * v1, w2 * (m2 * T14)
        v5 = w2 * (m2 * T24)

        # a joint is free, or branches meet
        kept[16 * w + k] = 1.0 if abs(D2_squared) <= m1 else kept[16 * w + k]
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = w2, v2 - v4, v2 + v4
        turns[8 * w + k], turns[9 * w + k], turns[10 * w + k] = N2 - k1, v3 + v5, v3 - v5
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 3 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(3 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle2, angle1, angle3
        rows[3 * w + k] = -angle1
        rows[4 * w + k] = UNREACHABLE if angle2 != angle2 else OK
        rows[5 * w + k] = UNREACHABLE if angle3 != angle3 else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 17, 16, [
    [0, 1], [2, 3],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "position", _FORMULAS, counted=(True, True, False),
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
