"""kuka_youbot: KUKA youBot arm.

Inverse kinematics, generated from robots/kuka_youbot.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kuka_youbot.yaml. The formulas and where they come from:
kuka_youbot.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Every entry of
a pose counts.
"""

import math
import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType

import numpy as np

# The runtime that lies beside this file, by whatever name this is imported, and no other one: it is
# in a package named after the folder. A dot in a name would be one between packages.
_BESIDE = str(Path(__file__).resolve().parent)
_FOLDER = _BESIDE.replace("%", "%25").replace(".", "%2E")
sys.modules.setdefault(_FOLDER, ModuleType(_FOLDER)).__path__ = [_BESIDE]


def _runtime(name):
    return import_module(f"{_FOLDER}.dhgen_runtime.{name}")


_RUNTIME = _runtime("jit")
_COMPILED = _RUNTIME.COMPILED
_HOW = _RUNTIME.of_file(__file__, interface=1)
_njit, _jit, _inner, _merged = _HOW.njit, _HOW.jit, _HOW.inner, _HOW.merged
_apart = _HOW.apart
carray = _RUNTIME.carray
_room, _wide_room = _RUNTIME.room, _RUNTIME.wide_room
_turned = _runtime("turns").turned
_atan2 = _runtime("angles").atan2
_wrap = _runtime("angles").wrap
_read_rows = _runtime("pose").read_pose
_of_joints = _runtime("entry").of_joints(_HOW, 5)

NAME = "kuka_youbot"
METHOD = "closed form"
DOF = 5
JOINT_TYPES = "RRRRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "front-down",
    "front-up",
    "back-up",
    "back-down",
)
MAX_SOLUTIONS = 4

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.147  # joint offset 1 [m]
a1 = 0.033  # link length 1 [m]
a2 = 0.155  # link length 2 [m]
a3 = 0.135  # link length 3 [m]
d5 = 0.2175  # joint offset 5 [m]
second_weight = 0.6875  # lengths count in arm sizes [m]
free_limit1 = 6.874999999999999e-13  # a length that fixes no angle [m]
free_limit = 1e-12  # a length that fixes no angle
longest3 = 0.08410000000000002  # square of the longest reach [m^2]
shortest3 = 0.0003999999999999996  # square of the shortest reach [m^2]
longest3_reach = 0.08410000000003988  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.00039999999999724956  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.08409999999999603  # the longest, where branches merge [m^2]
shortest3_apart = 0.00040000000000027465  # the shortest, where branches merge [m^2]
free_limit_squared2 = 4.7265625e-25  # square of a length that fixes no angle [m^2]
offset2 = 1.5707963267948966  # offset of joint 2 [rad]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 6.875e-06  # a pose may be rounded by this [m]
offset4 = 1.5707963267948966  # offset of joint 4 [rad]
k1 = 0.04225  # a2^2 + a3^2 [m^2]
k2 = 23.894862604540023  # 1 / (2 * a3 * a2) [m^-2]
m1 = 4.726562499999999e-09  # doubt_limit1^2 [m^2]
m3 = 9.999999999999999e-09  # doubt_limit^2
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m4 = 3.345324017800363e-13
m5 = 3.2258064516129035  # a coefficient of S2
m6 = 0.018709677419354823  # a coefficient of S2
m7 = 2.2340393066406244e-17  # doubt_limit_squared2^2 [m^4]
m8 = 3.7037037037037037  # a coefficient of c23
m9 = 0.021481481481481466  # a coefficient of c23
m10 = 1.0000000000000002e-10  # pose_slack^2
m11 = 4.7265625e-11  # pose_slack1^2 [m^2]
m12 = 1.41796875e-10  # 3 * pose_slack1^2 [m^2]

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0, 1.0])
_JOINTS = np.column_stack([_LOWEST, _HIGHEST, [kind == "R" for kind in JOINT_TYPES], _WEIGHT])


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (5,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 5 joint values")
    T = np.zeros((4, 4))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    v1 = q[1] + offset2
    c2 = math.cos(v1)
    s2 = math.sin(v1)
    x2_x = c1 * c2
    x2_y = s1 * c2
    v2 = c1 * s2
    v3 = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v2 * s3
    x3_y = x2_y * c3 - v3 * s3
    x3_z = s2 * c3 + c2 * s3
    v4 = v2 * c3 + x2_x * s3
    v5 = v3 * c3 + x2_y * s3
    y3_z = c2 * c3 - s2 * s3
    v6 = q[3] + offset4
    c4 = math.cos(v6)
    s4 = math.sin(v6)
    x4_x = x3_x * c4 - v4 * s4
    x4_y = x3_y * c4 - v5 * s4
    x4_z = x3_z * c4 + y3_z * s4
    z4_x = v4 * c4 + x3_x * s4
    z4_y = v5 * c4 + x3_y * s4
    z4_z = x3_z * s4 - y3_z * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    T[0, 0] = x4_x * c5 + s1 * s5
    T[0, 1] = s1 * c5 - x4_x * s5
    T[0, 2] = z4_x
    T[0, 3] = c1 * a1 + x2_x * a2 + x3_x * a3 + z4_x * d5
    T[1, 0] = x4_y * c5 - c1 * s5
    T[1, 1] = -(c1 * c5 + x4_y * s5)
    T[1, 2] = z4_y
    T[1, 3] = s1 * a1 + x2_y * a2 + x3_y * a3 + z4_y * d5
    T[2, 0] = x4_z * c5
    T[2, 1] = -(x4_z * s5)
    T[2, 2] = z4_z
    T[2, 3] = d1 + s2 * a2 + x3_z * a3 + z4_z * d5
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 5): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 5 joint values")
    J = np.zeros((6, 5))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    p1_x = c1 * a1
    p1_y = s1 * a1
    v1 = q[1] + offset2
    c2 = math.cos(v1)
    s2 = math.sin(v1)
    x2_x = c1 * c2
    x2_y = s1 * c2
    v2 = c1 * s2
    v3 = s1 * s2
    p2_x = p1_x + x2_x * a2
    p2_y = p1_y + x2_y * a2
    p2_z = d1 + s2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v2 * s3
    x3_y = x2_y * c3 - v3 * s3
    x3_z = s2 * c3 + c2 * s3
    p3_x = p2_x + x3_x * a3
    p3_y = p2_y + x3_y * a3
    p3_z = p2_z + x3_z * a3
    v4 = q[3] + offset4
    c4 = math.cos(v4)
    s4 = math.sin(v4)
    z4_x = (v2 * c3 + x2_x * s3) * c4 + x3_x * s4
    z4_y = (v3 * c3 + x2_y * s3) * c4 + x3_y * s4
    z4_z = x3_z * s4 - (c2 * c3 - s2 * s3) * c4
    p5_x = p3_x + z4_x * d5
    p5_y = p3_y + z4_y * d5
    p5_z = p3_z + z4_z * d5
    v5 = p5_z - d1
    v6 = p5_z - p2_z
    v7 = p5_x - p3_x
    v8 = p5_y - p3_y
    v9 = p5_z - p3_z
    J[0, 0] = -p5_y
    J[0, 1] = -(c1 * v5)
    J[0, 2] = -(c1 * v6)
    J[0, 3] = -(c1 * v9)
    J[0, 4] = z4_y * v9 - z4_z * v8
    J[1, 0] = p5_x
    J[1, 1] = -(s1 * v5)
    J[1, 2] = -(s1 * v6)
    J[1, 3] = -(s1 * v9)
    J[1, 4] = z4_z * v7 - z4_x * v9
    J[2, 1] = s1 * (p5_y - p1_y) + c1 * (p5_x - p1_x)
    J[2, 2] = s1 * (p5_y - p2_y) + c1 * (p5_x - p2_x)
    J[2, 3] = s1 * v8 + c1 * v7
    J[2, 4] = z4_x * v8 - z4_y * v7
    J[3, 1] = s1
    J[3, 2] = s1
    J[3, 3] = s1
    J[3, 4] = z4_x
    J[4, 1] = -c1
    J[4, 2] = -c1
    J[4, 3] = -c1
    J[4, 4] = z4_y
    J[5, 0] = 1.0
    J[5, 4] = z4_z
    return J


_LOST = 128  # _LOST + j: the row was lost after joint j had been chosen freely
_NEARLY = 192  # _NEARLY + j: joint j is nearly free, and the row's second value is its angle


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others.

    The first value of a row that is _LOST says how far it is from a solution (negative).
    """
    T11, T12, T13, T14, T21, T22, T23, T24, T31, _, T33, T34 = pose

    # theta1, type 2: U1[3, 4] and, where that is degenerate, U1[3, 3]
    sigma1 = math.copysign(second_weight, T14 * T13 + T24 * T23)
    Xhat1 = T14 + T13 * sigma1
    Yhat1 = T24 + T23 * sigma1
    w1 = math.sqrt(Xhat1 * Xhat1 + Yhat1 * Yhat1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta234, type 3: U1[2, 3] and U1[1, 3]
    v1 = T33 * T33

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v7 = T34 - d1

    # theta2, type 3: U1[2, 4] and U1[1, 4]
    v11 = seed[1] + offset2

    for i1 in range(2):  # front, back
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else Xhat1 * factor1
        s1 = math.sin(seed[0]) if free1 else Yhat1 * factor1
        q1 = _atan2(s1, c1)

        # theta234
        Z2_234 = T13 * c1 + T23 * s1
        w234 = math.sqrt(Z2_234 * Z2_234 + v1)
        short234 = w234 <= free_limit
        factor234 = 1.0 / (1.0 if short234 else w234)
        v2 = T33 * factor234
        s234 = Z2_234 * factor234
        theta234 = _atan2(s234, -v2)

        # theta5, type 3: U1[3, 2] and U1[3, 1]
        S5 = T21 * c1 - T11 * s1
        C5 = T22 * c1 - T12 * s1
        w5 = math.sqrt(S5 * S5 + C5 * C5)
        short5 = w5 <= free_limit
        v3 = 1.0 / (1.0 if short5 else w5)
        v4 = C5 * v3
        v5 = S5 * v3
        q5 = _atan2(-v5, -v4)

        # theta3
        v6 = v2 * d5
        Z1_3 = v7 - v6
        v8 = s234 * d5
        Z2_3 = T14 * c1 + T24 * s1 - a1 - v8
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
        K3 = N3 - k1
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            if free1:
                status[2 * i1] = _LOST + 1
                q[2 * i1, 0] = D3
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        c3 = K3 * k2

        # theta2
        X1_2 = a2 + a3 * c3
        v9 = Z1_3 * X1_2
        v10 = Z2_3 * X1_2

        # is the pose one that the arm can take?
        v12 = a1 + v8
        v14 = d1 + v6
        if (
            not (abs(T33 - v2) <= pose_slack and abs(T31 + s234 * v4) <= pose_slack and abs(T23 - s1
            * s234) <= pose_slack and abs(T21 - (v4 * (s1 * v2) + c1 * v5)) <= pose_slack and
            abs(T11 - (v4 * (c1 * v2) - s1 * v5)) <= pose_slack and abs(T13 - c1 * s234) <=
            pose_slack)
        ):
            continue  # the arm can't take this pose

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            s3 = w3 * e2 * k2
            q3 = _atan2(s3, c3)

            # theta2
            Y1_2 = a3 * s3
            S2 = v9 - Z2_3 * Y1_2
            C2 = v10 + Z1_3 * Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v11) if free2 else C2 * factor2
            s2 = math.sin(v11) if free2 else S2 * factor2
            theta2 = _atan2(s2, c2)

            # is the pose one that the arm can take?
            c23 = c3 * c2 - s3 * s2
            s23 = c3 * s2 + s3 * c2
            v13 = a3 * c23 + (a2 * c2 + v12)
            if (
                not (abs(T34 - (a3 * s23 + (a2 * s2 + v14))) <= pose_slack1 and abs(T14 - c1 * v13)
                <= pose_slack1 and abs(T24 - s1 * v13) <= pose_slack1)
            ):
                continue  # the arm can't take this pose

            # joint values
            q2 = _wrap(theta2 - offset2)
            q4 = _wrap(theta234 - (q3 + theta2) - offset4)
            row = 2 * i1 + i2
            q[row, 0] = q1
            q[row, 1] = q2
            q[row, 2] = q3
            q[row, 3] = q4
            q[row, 4] = q5
            status[row] = FREE_JOINT if free1 or free2 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px) and math.isfinite(py) and math.isfinite(pz), pose


@_inner
def _without_turns(angle):
    """An angle without its whole turns, by which a search could not tell small moves."""
    return math.copysign(abs(angle) % turn, angle)


_CHOOSABLE = (1, 0,)  # joints, from 0, that may be free


@_inner
def _serves(search, q, status):
    """Whether a row was solved, as exactly as poses may be rounded."""
    return status[search[0]] != UNREACHABLE and status[search[0]] < _LOST


@_inner
def _shortfall(pose, row, q, status):
    """How far a row is from a solution: 0 if it is solved.
    """
    if status[row] >= _LOST:
        return q[row, 0]
    return -math.inf if status[row] == UNREACHABLE else 0.0


@_inner
def _attempt(pose, seed, search, moved, q, status):
    """Solves with a joint moved: 0 if it serves, else less.

    A search is a row, the joint that had been chosen, whether limits count.
    """
    row, joint = search[0], search[1]
    for i in range(4):
        status[i] = UNREACHABLE
    kept = seed[joint]
    seed[joint] = kept + moved
    _solve(pose, seed, q, status)
    seed[joint] = kept
    return _shortfall(pose, row, q, status)


@_inner
def _peak(pose, seed, search, low, high, q, status):
    """Golden section for the move between low and high that comes nearest, or one that serves."""
    for _ in range(52):
        third = 0.3819660112501051 * (high - low)
        left = _attempt(pose, seed, search, low + third, q, status)
        right = _attempt(pose, seed, search, high - third, q, status)
        if left == 0.0 or right == 0.0:
            return low + third if left == 0.0 else high - third
        if left >= right:
            high -= third
        else:
            low += third
    return low


@_inner
def _summit(pose, seed, search, low, high, q, status):
    """A move between low and high that serves; NaN if there is none."""
    top = _peak(pose, seed, search, low, high, q, status)
    if _attempt(pose, seed, search, top, q, status) == 0.0:
        return top
    # beside a place where the branches meet, this one has no solution of its own
    for moved in (top - 1e-09, top + 1e-09):
        if math.isinf(_attempt(pose, seed, search, moved, q, status)):
            return math.nan
    _attempt(pose, seed, search, top, q, status)
    return top if _serves(search, q, status) else math.nan


@_inner
def _serving(pose, seed, search, q, status):
    """How far the joint has to be moved from the seed's value until it serves; NaN if nowhere.

    A fan of values shows where it serves or nearly so, golden section finds what lies between two
    of them, bisection the end that is nearest to the seed; of two that are equally near the lower
    one.
    """
    if _attempt(pose, seed, search, 0.0, q, status) == 0.0:
        return 0.0
    step, nearest, here = 0.09817477042468103, math.nan, -math.inf
    after = _attempt(pose, seed, search, -32.0 * step, q, status)
    for k in range(-32, 32 + 1):
        before, here = here, after
        after = _attempt(pose, seed, search, (k + 1) * step, q, status)
        outer = k * step
        inner = outer - step if k > 0 else outer + step if k < 0 else 0.0
        if here < 0.0 and here >= before and here > after:
            low, high = outer - step, outer + step
            outer = _summit(pose, seed, search, low, high, q, status)
            if math.isnan(outer):
                continue
        elif here < 0.0 or (before if k > 0 else after) == 0.0:
            continue
        for _ in range(52):
            middle = 0.5 * (inner + outer)
            if _attempt(pose, seed, search, middle, q, status) == 0.0:
                outer = middle
            else:
                inner = middle
        if not abs(outer) >= abs(nearest) - 1e-09:
            nearest = outer
    return nearest


@_inner
def _serving_digits(pose, seed, search, q, status):
    """The same for a joint that is nearly free: its angle is known to few digits.

    Also where the arm just reaches (an elbow that is stretched). As long as the angle is right up
    to rounding of what it was taken from, `_solve` takes it as it would take its own.
    """
    before, past = np.full(2, -math.inf), np.zeros(2)
    moved = 1e-15
    while moved < 0.1:
        for way in range(2):
            there = -moved if way else moved
            here = _attempt(pose, seed, search, there, q, status)
            if here == 0.0:
                return there
            if here < 2.0 * before[way] and past[way] == 0.0:
                past[way] = 1.0
                low = 0.25 * there
                top = _summit(pose, seed, search, low, there, q, status)
                if not math.isnan(top):
                    return top
            before[way] = here
        moved *= 2.0
    return math.nan


@_inner
def _choose_again(pose, given, row, q, status):
    """A free joint took the seed's value, and then the arm could not reach.

    The joint takes the nearest value that serves.
    """
    nearly = status[row] > _NEARLY
    search = row, status[row] - (_NEARLY if nearly else _LOST) - 1, False
    seed, trial, result = given.copy(), q.copy(), status.copy()
    if nearly:
        seed[search[1]] = q[row, 1]
        moved = _serving_digits(pose, seed, search, trial, result)
    else:
        seed[search[1]] = _without_turns(seed[search[1]])
        moved = _serving(pose, seed, search, trial, result)
    _attempt(pose, seed, search, moved, trial, result)
    served = not math.isnan(moved) and _serves(search, trial, result)
    status[row] = result[row] if served else UNREACHABLE
    for i in range(5):
        q[row, i] = trial[row, i] if served else math.nan


@_apart("void(UniTuple(float64, 12), float64[::1], float64[:, ::1], uint8[::1])")
def _other_choices(pose, seed, q, status):
    """Other values for free joints, in rows that the seed's do not serve."""
    for row in range(4):
        if status[row] >= _LOST:
            _choose_again(pose, seed, row, q, status)


@_inner
def _choose(pose, seed, q, status):
    """The same where there is a row that needs it."""
    served = True
    for row in range(4):
        served = served and status[row] < _LOST
    if served:
        return
    # arrays of the caller may have any layout
    values, rows, kinds = np.empty(5), np.empty((4, 5)), np.empty(4, np.uint8)
    for row in range(4):
        kinds[row] = status[row]
        for i in range(5):
            values[i], rows[row, i] = seed[i], q[row, i]
    _other_choices(pose, values, rows, kinds)
    for row in range(4):
        status[row] = kinds[row]
        for i in range(5):
            q[row, i] = rows[row, i]


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([1.455, 1.455, 1.455, 1.0, 1.0, 1.0])


@_inner
def _miss(T, q):
    """By how much joint values miss the pose (6,), and its length.

    The former is zero half a turn away, too.
    """
    e, P, square = np.zeros(6), fk(q), 0.0
    for i in range(3):
        if _MISS_WEIGHT[i] > 0.0:
            e[i] = _MISS_WEIGHT[i] * (T[4 * i + 3] - P[i, 3])
        square += e[i] * e[i]
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        for c in range(3):
            e[3 + i] += 0.5 * (P[j, c] * T[4 * k + c] - P[k, c] * T[4 * j + c])
            square += 0.5 * (P[j, c] - T[4 * j + c]) ** 2
    return e, math.sqrt(square)


@_inner
def _add_step(held, damping, e, q):
    """Adds the damped least squares step that the miss e asks for to joint values.

    The rows of the Jacobian, each with its share of the damping's root, are made orthogonal one
    after another (modified Gram-Schmidt), twice: once would not do beside singular places.
    """
    J, rows, square = jacobian(q), np.zeros((6, 11)), np.zeros(6)
    for i in range(6):
        for j in range(5):
            rows[i, j] = 0.0 if held[j] else _PACE[j] * _MISS_WEIGHT[i] * J[i, j]
        rows[i, 5 + i] = math.sqrt(damping + 1e-26)
        for n in range(2 * i):
            k, along = n % i, 0.0
            for j in range(11):
                along += rows[k, j] * rows[i, j] / square[k]
            for j in range(11):
                rows[i, j] -= along * rows[k, j]
            e[i] -= along * e[k]
        for j in range(11):
            square[i] += rows[i, j] * rows[i, j]
        for j in range(5):
            q[j] += e[i] / square[i] * rows[i, j] * _PACE[j]


@_inner
def _half_way(x, q, half):
    """How far joint values are from others, but for whole turns [rad, arm sizes].

    Those half way go into half.
    """
    most = 0.0
    for i in range(5):
        off = q[i] - x[i]
        off -= turn * math.floor(off / turn + 0.5)
        most = max(most, abs(off))
        half[i] = x[i] + 0.5 * off
    return most


@_apart("boolean(UniTuple(float64, 12), float64, float64, float64[::1])")
def _settled(T, enough, most, q):
    """Takes joint values to some not farther than most that miss the pose by less than enough.

    Returns if it can.
    Damped least squares, while they gain: where roots meet a step still leaves less than half.
    Until one gains little they are damped so that none leads far.
    """
    half = np.empty(5)
    held, x, settled = np.zeros(5, np.bool_), q.copy(), False
    last, lost = math.inf, 0
    for _ in range(20):
        e, miss = _miss(T, x)
        if miss < enough:
            for i in range(5):
                q[i] = x[i]
            settled = True
            enough = 0.5 * miss
        elif settled:
            return True
        elif miss > max(0.7 * last, 100.0 * enough):
            lost += 1
            if lost == 4:
                return False
        last = miss
        damping = 0.1 * miss * miss
        if lost == 0 and miss > 100.0 * enough:
            damping = 0.003 * miss
        _add_step(held, damping, e, x)
        if not _half_way(x, q, half) <= most:
            return settled  # another solution
    return settled


@_inner
def _settle(pose, enough, most, q):
    """The same for joint values of the caller's."""
    values = np.empty(5)
    for i in range(5):
        values[i] = q[i]
    settled = _settled(pose, enough, most, values)
    for i in range(5):
        q[i] = values[i]
    return settled


@_inner
def _stay(pose, seed, q, status):
    """Where rounding can't tell solutions apart the arm goes on with the one that it is at.

    The solution next to the seed gets a row unless it has one: that of one beside
    it, that of one which it is told from by nothing, one that is left, or any.
    """
    x, half, place, least = np.empty(5), np.empty(5), 0, math.inf
    nearest = 0.001
    for i in range(5):
        x[i] = seed[i]
    if not _settle(pose, 1e-12, 0.15, x):
        return
    for row in range(4 - 1, -1, -1):
        between = 1e-06
        if status[row] != UNREACHABLE:
            off = _half_way(x, q[row], half)
            between = max(_miss(pose, half)[1], 1e-12)
            if off < nearest:
                place, nearest, least = row, off, -1.0  # its own
        if between <= 2.0 * least:
            place = row
        least = min(least, between)
    if least >= 0.0:
        status[place] = FREE_JOINT
    if nearest > 1e-06:
        for i in range(5):
            q[place, i] = x[i]


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(4):
        status[row] = UNREACHABLE
        for i in range(5):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    _choose(pose, seed, q, status)
    _stay(pose, seed, q, status)
    count = 0
    for row in range(4):
        if status[row] == UNREACHABLE:
            continue
        for i in range(5):
            q[row, i] = _turned(_JOINTS, i, q[row, i], 0.0)
            if not _LOWEST[i] <= q[row, i] <= _HIGHEST[i]:
                status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


@_merged
def _regular(pose, q, status):
    """A pose at which no joint is free and no branches meet into q and status; False for others.

    What can't be reached is NaN by itself: it has the root of a negative number in it.
    """
    T11, T12, T13, T14, T21, T22, T23, T24, T31, _, T33, T34 = pose
    room = carray(_room(32), 32)

    # theta1, type 2: U1[3, 4] and, where that is degenerate, U1[3, 3]
    sigma1 = math.copysign(second_weight, T14 * T13 + T24 * T23)
    Xhat1 = T14 + T13 * sigma1
    Yhat1 = T24 + T23 * sigma1
    v1 = Xhat1 * Xhat1 + Yhat1 * Yhat1
    w1 = math.sqrt(v1)
    v2 = 1.0 / v1
    factor1 = w1 * v2
    c1 = Xhat1 * factor1
    s1 = Yhat1 * factor1

    # theta234, type 3: U1[2, 3] and U1[1, 3]
    Z2_234 = w1 * (v2 * (T13 * Xhat1 + T23 * Yhat1))
    v3 = T33 * T33 + Z2_234 * Z2_234
    w234 = math.sqrt(v3)
    v4 = 1.0 / v3
    factor234 = w234 * v4

    # theta5, type 3: U1[3, 2] and U1[3, 1]
    S5 = w1 * (v2 * (Xhat1 * T21 - Yhat1 * T11))
    C5 = w1 * (v2 * (Xhat1 * T22 - Yhat1 * T12))
    v5 = S5 * S5 + C5 * C5
    v6 = math.sqrt(v5) * (1.0 / v5)
    v7 = C5 * v6
    v8 = S5 * v6

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v9 = factor234 * (d5 * T33)
    Z1_3 = T34 - d1 - v9
    v10 = d5 * Z2_234
    v11 = T14 * c1 + T24 * s1
    v12 = v11 - a1
    v13 = a1 + v11
    v14 = factor234 * v10
    v15 = v12 - v14
    v16 = v14 - v13
    v17 = w234 * (v4 * v10)
    Z2_3_p = v12 - v17
    Z2_3_m = v17 - v13
    v18 = Z1_3 * Z1_3
    N3_p = v18 + Z2_3_p * Z2_3_p
    N3_m = v18 + Z2_3_m * Z2_3_m
    D3_p = (longest3 - N3_p) * (N3_p - shortest3)
    D3_m = (longest3 - N3_m) * (N3_m - shortest3)
    w3_p = math.sqrt(D3_p)
    w3_m = math.sqrt(D3_m)
    v19 = w3_p - w3_p
    v20 = w3_m - w3_m

    # theta2, type 3: U1[2, 4] and U1[1, 4]
    v21 = m6 + m5 * N3_p
    v22 = m6 + m5 * N3_m
    v23 = Z1_3 * v21
    v24 = Z1_3 * v22
    S2_pp = v23 - w3_p * (m5 * v15)
    S2_pm = v23 - w3_p * (m5 * -v15)
    S2_mp = v24 - w3_m * (m5 * v16)
    S2_mm = v24 - w3_m * (m5 * -v16)
    v25 = m5 * Z1_3
    v26 = m5 * -Z1_3
    v27 = v15 * v21
    v28 = v16 * v22
    C2_pp = v27 + w3_p * v25
    C2_pm = v27 + w3_p * v26
    C2_mp = v28 + w3_m * v25
    C2_mm = v28 + w3_m * v26
    v29 = S2_pp * S2_pp + C2_pp * C2_pp
    v30 = S2_pm * S2_pm + C2_pm * C2_pm
    v31 = S2_mp * S2_mp + C2_mp * C2_mp
    v32 = S2_mm * S2_mm + C2_mm * C2_mm
    w2_pp = math.sqrt(v29)
    w2_pm = math.sqrt(v30)
    w2_mp = math.sqrt(v31)
    w2_mm = math.sqrt(v32)
    v33 = 1.0 / v29
    v34 = 1.0 / v30
    v35 = 1.0 / v31
    v36 = 1.0 / v32
    factor2_pp = w2_pp * v33
    factor2_pm = w2_pm * v34
    factor2_mp = w2_mp * v35
    factor2_mm = w2_mm * v36

    # is the pose one that the arm can take?
    v37 = m8 * Z1_3
    v38 = m8 * -Z1_3
    v39 = m8 * N3_p - m9
    v40 = m8 * N3_m - m9
    v41 = v15 * v39
    v42 = v16 * v40
    v43 = Z1_3 * v39
    v44 = Z1_3 * v40
    v45 = a1 + v14
    v46 = a1 - v14
    v47 = v45 + w2_pp * (v33 * (a3 * (v41 - w3_p * v37) + a2 * C2_pp))
    v48 = v45 + w2_pm * (v34 * (a3 * (v41 - w3_p * v38) + a2 * C2_pm))
    v49 = v46 + w2_mp * (v35 * (a3 * (v42 - w3_m * v37) + a2 * C2_mp))
    v50 = v46 + w2_mm * (v36 * (a3 * (v42 - w3_m * v38) + a2 * C2_mm))
    v51 = d1 + v9
    v52 = T33 - T33 * factor234
    v53 = T31 + factor234 * (Z2_234 * v7)
    v54 = T23 - factor234 * (s1 * Z2_234)
    v55 = T21 - (c1 * v8 + factor234 * (v7 * (s1 * T33)))
    v56 = T11 - (factor234 * (v7 * (c1 * T33)) - s1 * v8)
    v57 = T13 - factor234 * (c1 * Z2_234)
    v58 = T34 - (v51 + factor2_pp * (a2 * S2_pp) + factor2_pp * (a3 * (v43 + w3_p * (m8 * v15))))
    v59 = T34 - (v51 + factor2_pm * (a2 * S2_pm) + factor2_pm * (a3 * (v43 + w3_p * (m8 * -v15))))
    v60 = T34 - (v51 + factor2_mp * (a2 * S2_mp) + factor2_mp * (a3 * (v44 + w3_m * (m8 * v16))))
    v61 = T34 - (v51 + factor2_mm * (a2 * S2_mm) + factor2_mm * (a3 * (v44 + w3_m * (m8 * -v16))))
    v62 = T14 - c1 * v47
    v63 = T14 - c1 * v48
    v64 = T14 + c1 * v49
    v65 = T14 + c1 * v50
    v66 = T24 - s1 * v47
    v67 = T24 - s1 * v48
    v68 = T24 + s1 * v49
    v69 = T24 + s1 * v50
    v70 = v58 * v58 + v62 * v62 + v66 * v66
    v71 = v59 * v59 + v63 * v63 + v67 * v67
    v72 = v60 * v60 + v64 * v64 + v68 * v68
    v73 = v61 * v61 + v65 * v65 + v69 * v69

    # joint values
    v86 = math.sqrt(-1.0)
    v87 = 0.0 if v70 <= m11 else v86
    v88 = 0.0 if v71 <= m11 else v86
    v89 = 0.0 if v72 <= m11 else v86
    v90 = 0.0 if v73 <= m11 else v86

    # a joint is free, or branches meet
    if (
        v3 <= m3 or v1 <= m1 or v5 <= m3 or (m11 < v73 and v73 <= m12) or v32 <= m7 or (m11 < v72
        and v72 <= m12) or v31 <= m7 or (m11 < v71 and v71 <= m12) or v30 <= m7 or (m11 < v70 and
        v70 <= m12) or v29 <= m7 or m10 < v52 * v52 + v53 * v53 + v54 * v54 + v55 * v55 + v56 * v56
        + v57 * v57 or abs(D3_p) <= m4 or abs(D3_m) <= m4
    ):
        return False

    # angles, side by side
    room[0] = Yhat1
    room[1] = Z2_234
    room[2] = -S5
    room[3] = w3_p
    room[4] = w3_m
    room[5] = S2_pp
    room[6] = S2_pm
    room[7] = S2_mp
    room[8] = S2_mm
    room[16] = Xhat1
    room[17] = -T33
    room[18] = -C5
    room[19] = N3_p - k1
    room[20] = N3_m - k1
    room[21] = C2_pp
    room[22] = C2_pm
    room[23] = C2_mp
    room[24] = C2_mm
    for k in range(9, 16):
        room[k] = room[k + 16] = 1.0
    for k in range(16):
        room[k] = _atan2(room[k], room[k + 16])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]
    angle4 = room[3]
    angle5 = room[4]
    angle6 = room[5]
    angle7 = room[6]
    angle8 = room[7]
    angle9 = room[8]

    # joint values
    v74 = angle6 - offset2
    v75 = angle7 - offset2
    v76 = angle8 - offset2
    v77 = angle9 - offset2
    v78 = angle2 - (angle4 + angle6) - offset4
    v79 = angle2 - (angle7 - angle4) - offset4
    v80 = offset4 + (angle2 + (angle5 + angle8))
    v81 = offset4 + (angle2 + (angle9 - angle5))
    v82 = v78 + (turn if v78 <= -half_turn else (-turn if half_turn < v78 else 0.0))
    v83 = v79 + (turn if v79 <= -half_turn else (-turn if half_turn < v79 else 0.0))
    v84 = (turn if -v80 <= -half_turn else (-turn if half_turn < -v80 else 0.0)) - v80
    v85 = (turn if -v81 <= -half_turn else (-turn if half_turn < -v81 else 0.0)) - v81
    v91 = angle1 + v19
    v92 = v20 + (angle1 - math.copysign(half_turn, Yhat1))
    q1_pp = v87 + v91
    q1_pm = v88 + v91
    q1_mp = v89 + v92
    q1_mm = v90 + v92
    q2_pp = v87 + (v74 + (turn if v74 <= -half_turn else 0.0))
    q2_pm = v88 + (v75 + (turn if v75 <= -half_turn else 0.0))
    q2_mp = v89 + (v76 + (turn if v76 <= -half_turn else 0.0))
    q2_mm = v90 + (v77 + (turn if v77 <= -half_turn else 0.0))
    q3_pp = angle4 + v87
    q3_pm = v88 - angle4
    q3_mp = angle5 + v89
    q3_mm = v90 - angle5
    q4_pp = v87 + (v82 + (turn if v82 <= -half_turn else 0.0))
    q4_pm = v88 + (v83 + (turn if v83 <= -half_turn else 0.0))
    q4_mp = v89 + (v84 + (turn if v84 <= -half_turn else 0.0))
    q4_mm = v90 + (v85 + (turn if v85 <= -half_turn else 0.0))
    v93 = angle3 + v19
    v94 = v20 + (angle3 - math.copysign(half_turn, -S5))
    q5_pp = v87 + v93
    q5_pm = v88 + v93
    q5_mp = v89 + v94
    q5_mm = v90 + v94

    q[0, 0] = q1_pp
    q[0, 1] = q2_pp
    q[0, 2] = q3_pp
    q[0, 3] = q4_pp
    q[0, 4] = q5_pp
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_pm
    q[1, 1] = q2_pm
    q[1, 2] = q3_pm
    q[1, 3] = q4_pm
    q[1, 4] = q5_pm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = q1_mp
    q[2, 1] = q2_mp
    q[2, 2] = q3_mp
    q[2, 3] = q4_mp
    q[2, 4] = q5_mp
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = q1_mm
    q[3, 1] = q2_mm
    q[3, 2] = q3_mm
    q[3, 3] = q4_mm
    q[3, 4] = q5_mm
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else OK
    return True


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (4, 5) or status.shape != (4,):
        raise ValueError("T, q and status must have shapes (4, 4), (4, 5), (4,)")
    valid, pose = _read(T)
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    if _COMPILED and _regular(pose, q, status):
        count = 0
        for row in range(4):
            count += status[row] == OK
        return count
    return _whole(pose, seed, q, status)


# Where in a tile the rows' values and statuses begin.
_PLACES = np.array([
    [992, 1008, 1024, 1040, 1056],
    [1072, 1088, 1104, 1120, 1136],
    [1152, 1168, 1184, 1200, 1216],
    [1232, 1248, 1264, 1280, 1296],
])
_KINDS = np.array([1312, 1328, 1344, 1360])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(1376), 1376)
    work[:] = 0.0  # the last tile may be half full
    for first in range(0, len(T), 16):
        count = min(16, len(T) - first)
        for k in range(count):
            for i in range(4):
                for j in range(4):
                    work[(4 * i + j) * 16 + k] = T[first + k, i, j]
        for k in range(16):
            x0, x1, x2 = work[0 + k], work[16 + k], work[32 + k]
            y0, y1, y2 = work[64 + k], work[80 + k], work[96 + k]
            z0, z1, z2 = work[128 + k], work[144 + k], work[160 + k]
            xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0
            yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0
            xy = x0 * y0 + x1 * y1 + x2 * y2
            u, v, w = x1 * y2 - x2 * y1 - z0, x2 * y0 - x0 * y2 - z1, x0 * y1 - x1 * y0 - z2
            rest = abs(work[192 + k]) + abs(work[208 + k]) + abs(work[224 + k])
            miss = (
                xx * xx + yy * yy + 2.0 * xy * xy + u * u + v * v + w * w + rest + abs(work[240 + k]
                - 1.0) + 0.0 * (work[48 + k] + work[112 + k] + work[176 + k])
            )
            exact = miss <= 1e-24
            work[256 + k] = 0.0 if exact else 1.0
        for k in range(0, 16):
            T11 = work[0 + k]
            T12 = work[16 + k]
            T13 = work[32 + k]
            T14 = work[48 + k]
            T21 = work[64 + k]
            T22 = work[80 + k]
            T23 = work[96 + k]
            T24 = work[112 + k]
            T31 = work[128 + k]
            T33 = work[160 + k]
            T34 = work[176 + k]
            sigma1 = math.copysign(second_weight, T14 * T13 + T24 * T23)
            Xhat1 = T14 + T13 * sigma1
            Yhat1 = T24 + T23 * sigma1
            v1 = Xhat1 * Xhat1 + Yhat1 * Yhat1
            w1 = math.sqrt(v1)
            v2 = 1.0 / v1
            factor1 = w1 * v2
            c1 = Xhat1 * factor1
            s1 = Yhat1 * factor1
            Z2_234 = w1 * (v2 * (T13 * Xhat1 + T23 * Yhat1))
            v3 = T33 * T33 + Z2_234 * Z2_234
            w234 = math.sqrt(v3)
            v4 = 1.0 / v3
            factor234 = w234 * v4
            S5 = w1 * (v2 * (Xhat1 * T21 - Yhat1 * T11))
            C5 = w1 * (v2 * (Xhat1 * T22 - Yhat1 * T12))
            v5 = S5 * S5 + C5 * C5
            v6 = math.sqrt(v5) * (1.0 / v5)
            v7 = C5 * v6
            v8 = S5 * v6
            v9 = factor234 * (d5 * T33)
            Z1_3 = T34 - d1 - v9
            v10 = d5 * Z2_234
            v11 = T14 * c1 + T24 * s1
            v12 = v11 - a1
            v13 = a1 + v11
            v14 = factor234 * v10
            v15 = v12 - v14
            v16 = v14 - v13
            v17 = w234 * (v4 * v10)
            Z2_3_p = v12 - v17
            Z2_3_m = v17 - v13
            v18 = Z1_3 * Z1_3
            N3_p = v18 + Z2_3_p * Z2_3_p
            N3_m = v18 + Z2_3_m * Z2_3_m
            D3_p = (longest3 - N3_p) * (N3_p - shortest3)
            D3_m = (longest3 - N3_m) * (N3_m - shortest3)
            w3_p = math.sqrt(D3_p)
            w3_m = math.sqrt(D3_m)
            v19 = w3_p - w3_p
            v20 = w3_m - w3_m
            v21 = m6 + m5 * N3_p
            v22 = m6 + m5 * N3_m
            v23 = Z1_3 * v21
            v24 = Z1_3 * v22
            S2_pp = v23 - w3_p * (m5 * v15)
            S2_pm = v23 - w3_p * (m5 * -v15)
            S2_mp = v24 - w3_m * (m5 * v16)
            S2_mm = v24 - w3_m * (m5 * -v16)
            v25 = m5 * Z1_3
            v26 = m5 * -Z1_3
            v27 = v15 * v21
            v28 = v16 * v22
            C2_pp = v27 + w3_p * v25
            C2_pm = v27 + w3_p * v26
            C2_mp = v28 + w3_m * v25
            C2_mm = v28 + w3_m * v26
            v29 = S2_pp * S2_pp + C2_pp * C2_pp
            v30 = S2_pm * S2_pm + C2_pm * C2_pm
            v31 = S2_mp * S2_mp + C2_mp * C2_mp
            v32 = S2_mm * S2_mm + C2_mm * C2_mm
            w2_pp = math.sqrt(v29)
            w2_pm = math.sqrt(v30)
            w2_mp = math.sqrt(v31)
            w2_mm = math.sqrt(v32)
            v33 = 1.0 / v29
            v34 = 1.0 / v30
            v35 = 1.0 / v31
            v36 = 1.0 / v32
            factor2_pp = w2_pp * v33
            factor2_pm = w2_pm * v34
            factor2_mp = w2_mp * v35
            factor2_mm = w2_mm * v36
            v37 = m8 * Z1_3
            v38 = m8 * -Z1_3
            v39 = m8 * N3_p - m9
            v40 = m8 * N3_m - m9
            v41 = v15 * v39
            v42 = v16 * v40
            v43 = Z1_3 * v39
            v44 = Z1_3 * v40
            v45 = a1 + v14
            v46 = a1 - v14
            v47 = v45 + w2_pp * (v33 * (a3 * (v41 - w3_p * v37) + a2 * C2_pp))
            v48 = v45 + w2_pm * (v34 * (a3 * (v41 - w3_p * v38) + a2 * C2_pm))
            v49 = v46 + w2_mp * (v35 * (a3 * (v42 - w3_m * v37) + a2 * C2_mp))
            v50 = v46 + w2_mm * (v36 * (a3 * (v42 - w3_m * v38) + a2 * C2_mm))
            v51 = d1 + v9
            v52 = T33 - T33 * factor234
            v53 = T31 + factor234 * (Z2_234 * v7)
            v54 = T23 - factor234 * (s1 * Z2_234)
            v55 = T21 - (c1 * v8 + factor234 * (v7 * (s1 * T33)))
            v56 = T11 - (factor234 * (v7 * (c1 * T33)) - s1 * v8)
            v57 = T13 - factor234 * (c1 * Z2_234)
            v58 = (
                T34 - (v51 + factor2_pp * (a2 * S2_pp) + factor2_pp * (a3 * (v43 + w3_p * (m8 *
                v15))))
            )
            v59 = (
                T34 - (v51 + factor2_pm * (a2 * S2_pm) + factor2_pm * (a3 * (v43 + w3_p * (m8 *
                -v15))))
            )
            v60 = (
                T34 - (v51 + factor2_mp * (a2 * S2_mp) + factor2_mp * (a3 * (v44 + w3_m * (m8 *
                v16))))
            )
            v61 = (
                T34 - (v51 + factor2_mm * (a2 * S2_mm) + factor2_mm * (a3 * (v44 + w3_m * (m8 *
                -v16))))
            )
            v62 = T14 - c1 * v47
            v63 = T14 - c1 * v48
            v64 = T14 + c1 * v49
            v65 = T14 + c1 * v50
            v66 = T24 - s1 * v47
            v67 = T24 - s1 * v48
            v68 = T24 + s1 * v49
            v69 = T24 + s1 * v50
            v70 = v58 * v58 + v62 * v62 + v66 * v66
            v71 = v59 * v59 + v63 * v63 + v67 * v67
            v72 = v60 * v60 + v64 * v64 + v68 * v68
            v73 = v61 * v61 + v65 * v65 + v69 * v69
            v86 = math.sqrt(-1.0)
            v87 = 0.0 if v70 <= m11 else v86
            v88 = 0.0 if v71 <= m11 else v86
            v89 = 0.0 if v72 <= m11 else v86
            v90 = 0.0 if v73 <= m11 else v86
            work[272 + k] = Yhat1
            work[288 + k] = v1
            work[304 + k] = v3
            work[320 + k] = S5
            work[336 + k] = v5
            work[352 + k] = D3_p
            work[368 + k] = D3_m
            work[384 + k] = v19
            work[400 + k] = v20
            work[416 + k] = v29
            work[432 + k] = v30
            work[448 + k] = v31
            work[464 + k] = v32
            work[480 + k] = v52
            work[496 + k] = v53
            work[512 + k] = v54
            work[528 + k] = v55
            work[544 + k] = v56
            work[560 + k] = v57
            work[576 + k] = v70
            work[592 + k] = v71
            work[608 + k] = v72
            work[624 + k] = v73
            work[640 + k] = v87
            work[656 + k] = v88
            work[672 + k] = v89
            work[688 + k] = v90
            work[704 + k] = Yhat1
            work[720 + k] = Z2_234
            work[736 + k] = -S5
            work[752 + k] = w3_p
            work[768 + k] = w3_m
            work[784 + k] = S2_pp
            work[800 + k] = S2_pm
            work[816 + k] = S2_mp
            work[832 + k] = S2_mm
            work[848 + k] = Xhat1
            work[864 + k] = -T33
            work[880 + k] = -C5
            work[896 + k] = N3_p - k1
            work[912 + k] = N3_m - k1
            work[928 + k] = C2_pp
            work[944 + k] = C2_pm
            work[960 + k] = C2_mp
            work[976 + k] = C2_mm
        for k in range(704, 848):
            work[k] = _atan2(work[k], work[k + 144])
        for k in range(0, 16):
            Yhat1 = work[272 + k]
            v1 = work[288 + k]
            v3 = work[304 + k]
            S5 = work[320 + k]
            v5 = work[336 + k]
            D3_p = work[352 + k]
            D3_m = work[368 + k]
            v19 = work[384 + k]
            v20 = work[400 + k]
            v29 = work[416 + k]
            v30 = work[432 + k]
            v31 = work[448 + k]
            v32 = work[464 + k]
            v52 = work[480 + k]
            v53 = work[496 + k]
            v54 = work[512 + k]
            v55 = work[528 + k]
            v56 = work[544 + k]
            v57 = work[560 + k]
            v70 = work[576 + k]
            v71 = work[592 + k]
            v72 = work[608 + k]
            v73 = work[624 + k]
            v87 = work[640 + k]
            v88 = work[656 + k]
            v89 = work[672 + k]
            v90 = work[688 + k]
            angle1 = work[704 + k]
            angle2 = work[720 + k]
            angle3 = work[736 + k]
            angle4 = work[752 + k]
            angle5 = work[768 + k]
            angle6 = work[784 + k]
            angle7 = work[800 + k]
            angle8 = work[816 + k]
            angle9 = work[832 + k]
            v74 = angle6 - offset2
            v75 = angle7 - offset2
            v76 = angle8 - offset2
            v77 = angle9 - offset2
            v78 = angle2 - (angle4 + angle6) - offset4
            v79 = angle2 - (angle7 - angle4) - offset4
            v80 = offset4 + (angle2 + (angle5 + angle8))
            v81 = offset4 + (angle2 + (angle9 - angle5))
            v82 = v78 + (turn if v78 <= -half_turn else (-turn if half_turn < v78 else 0.0))
            v83 = v79 + (turn if v79 <= -half_turn else (-turn if half_turn < v79 else 0.0))
            v84 = (turn if -v80 <= -half_turn else (-turn if half_turn < -v80 else 0.0)) - v80
            v85 = (turn if -v81 <= -half_turn else (-turn if half_turn < -v81 else 0.0)) - v81
            v91 = angle1 + v19
            v92 = v20 + (angle1 - math.copysign(half_turn, Yhat1))
            q1_pp = v87 + v91
            q1_pm = v88 + v91
            q1_mp = v89 + v92
            q1_mm = v90 + v92
            q2_pp = v87 + (v74 + (turn if v74 <= -half_turn else 0.0))
            q2_pm = v88 + (v75 + (turn if v75 <= -half_turn else 0.0))
            q2_mp = v89 + (v76 + (turn if v76 <= -half_turn else 0.0))
            q2_mm = v90 + (v77 + (turn if v77 <= -half_turn else 0.0))
            q3_pp = angle4 + v87
            q3_pm = v88 - angle4
            q3_mp = angle5 + v89
            q3_mm = v90 - angle5
            q4_pp = v87 + (v82 + (turn if v82 <= -half_turn else 0.0))
            q4_pm = v88 + (v83 + (turn if v83 <= -half_turn else 0.0))
            q4_mp = v89 + (v84 + (turn if v84 <= -half_turn else 0.0))
            q4_mm = v90 + (v85 + (turn if v85 <= -half_turn else 0.0))
            v93 = angle3 + v19
            v94 = v20 + (angle3 - math.copysign(half_turn, -S5))
            q5_pp = v87 + v93
            q5_pm = v88 + v93
            q5_mp = v89 + v94
            q5_mm = v90 + v94
            _992 = q1_pp
            work[992 + k] = _992
            _1008 = q2_pp
            work[1008 + k] = _1008
            _1024 = q3_pp
            work[1024 + k] = _1024
            _1040 = q4_pp
            work[1040 + k] = _1040
            _1056 = q5_pp
            work[1056 + k] = _1056
            _1072 = q1_pm
            work[1072 + k] = _1072
            _1088 = q2_pm
            work[1088 + k] = _1088
            _1104 = q3_pm
            work[1104 + k] = _1104
            _1120 = q4_pm
            work[1120 + k] = _1120
            _1136 = q5_pm
            work[1136 + k] = _1136
            _1152 = q1_mp
            work[1152 + k] = _1152
            _1168 = q2_mp
            work[1168 + k] = _1168
            _1184 = q3_mp
            work[1184 + k] = _1184
            _1200 = q4_mp
            work[1200 + k] = _1200
            _1216 = q5_mp
            work[1216 + k] = _1216
            _1232 = q1_mm
            work[1232 + k] = _1232
            _1248 = q2_mm
            work[1248 + k] = _1248
            _1264 = q3_mm
            work[1264 + k] = _1264
            _1280 = q4_mm
            work[1280 + k] = _1280
            _1296 = q5_mm
            work[1296 + k] = _1296
            work[1312 + k] = UNREACHABLE if _992 != _992 else OK
            work[1328 + k] = UNREACHABLE if _1072 != _1072 else OK
            work[1344 + k] = UNREACHABLE if _1152 != _1152 else OK
            work[1360 + k] = UNREACHABLE if _1232 != _1232 else OK
            work[256 + k] = (
                1.0 if v3 <= m3 or v1 <= m1 or v5 <= m3 or (m11 < v73 and v73 <= m12) or v32 <= m7
                or (m11 < v72 and v72 <= m12) or v31 <= m7 or (m11 < v71 and v71 <= m12) or v30 <=
                m7 or (m11 < v70 and v70 <= m12) or v29 <= m7 or m10 < v52 * v52 + v53 * v53 + v54 *
                v54 + v55 * v55 + v56 * v56 + v57 * v57 or abs(D3_p) <= m4 or abs(D3_m) <= m4 else
                work[256 + k]
            )
        for k in range(first, first + count):
            if work[256 + k - first] != 0.0:
                _unseeded(T[k], q[k], status[k])
                continue
            for row in range(4):
                status[k, row] = np.uint8(work[_KINDS[row] + k - first])
                for i in range(5):
                    q[k, row, i] = work[_PLACES[row, i] + k - first]

_FUNCTIONS = _runtime("functions")
_CALLS = _FUNCTIONS.of_robot(
    globals(),
    _HOW,
    _FUNCTIONS.Solver(
        joints=_JOINTS,
        into=_into,
        many=_in_tiles,
        kinematics=(fk, jacobian),
        given=0,
        apart=(_HOW.compile_apart,),
        words={
            "no_pose": "not finite, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)",
            "no_row": "the pose is out of reach, or one that 5 joints can't take",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
