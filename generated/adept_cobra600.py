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
_of_joints = _runtime("entry").of_joints(_HOW, 4)

NAME = "adept_cobra600"
METHOD = "closed form"
DOF = 4
JOINT_TYPES = "RRPR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "right",
    "left",
)
MAX_SOLUTIONS = 2

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

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
free_limit_squared2 = 9.74169e-25  # square of a length that fixes no angle [m^2]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 9.87e-06  # a pose may be rounded by this [m]
k1 = 0.18125000000000002  # a1^2 + a2^2 [m^2]
k2 = 5.594405594405594  # 1 / (2 * a2 * a1) [m^-2]
# 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4]
m1 = 4.2270353883820664e-12
m2 = 1.5384615384615385  # a coefficient of S1
m3 = 0.04615384615384612  # a coefficient of S1
m4 = 9.74169e-11  # pose_slack1^2 [m^2]
m5 = 1.0000000000000002e-10  # pose_slack^2

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 9.87e-10, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0265159330670552, 1.0])
_JOINTS = np.column_stack([_LOWEST, _HIGHEST, [kind == "R" for kind in JOINT_TYPES], _WEIGHT])


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (4,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 4 joint values")
    T = np.zeros((4, 4))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * c2 - s1 * s2
    x2_y = s1 * c2 + c1 * s2
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    v1 = x2_y * s4
    v2 = x2_y * c4
    T[0, 0] = x2_x * c4 + v1
    T[0, 1] = v2 - x2_x * s4
    T[0, 3] = c1 * a1 + x2_x * a2
    T[1, 0] = v2 + -x2_x * s4
    T[1, 1] = -x2_x * c4 - v1
    T[1, 3] = s1 * a1 + x2_y * a2
    T[2, 2] = -1.0
    T[2, 3] = d1 - q[2]
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 4): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 4 joint values")
    J = np.zeros((6, 4))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    p1_x = c1 * a1
    p1_y = s1 * a1
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    p2_x = p1_x + (c1 * c2 - s1 * s2) * a2
    p2_y = p1_y + (s1 * c2 + c1 * s2) * a2
    J[0, 0] = -p2_y
    J[0, 1] = p1_y - p2_y
    J[1, 0] = p2_x
    J[1, 1] = p2_x - p1_x
    J[2, 2] = -1.0
    J[5, 0] = 1.0
    J[5, 1] = 1.0
    J[5, 3] = -1.0
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, _, T13, T14, T21, _, T23, T24, T31, _, T33, T34 = pose

    # r3, type 1: U0[3, 4]
    r3 = d1 - T34

    # theta12m4, type 3: U0[1, 2] and U0[2, 2]
    w12m4 = math.sqrt(T21 * T21 + T11 * T11)
    short12m4 = w12m4 <= free_limit
    v1 = 1.0 / (1.0 if short12m4 else w12m4)
    c12m4 = T11 * v1
    s12m4 = T21 * v1
    theta12m4 = _atan2(s12m4, c12m4)

    # theta2, type 8: U0[1, 4] and U0[2, 4]
    N2 = T14 * T14 + T24 * T24
    K2 = N2 - k1
    D2 = (longest2 - N2) * (N2 - shortest2)
    apart2 = shortest2_apart < N2 and N2 < longest2_apart
    if not (shortest2_reach <= N2 and N2 <= longest2_reach):
        return  # out of reach
    w2 = math.sqrt(D2 if apart2 else 0.0)
    c2 = K2 * k2

    # theta1, type 3: U0[2, 4] and U0[1, 4]
    X1_1 = a1 + a2 * c2
    v2 = T24 * X1_1
    v3 = T14 * X1_1

    # is the pose one that the arm can take?
    if (
        not (abs(T34 - (d1 - r3)) <= pose_slack1 and abs(1.0 + T33) <= pose_slack and abs(T31) <=
        pose_slack and abs(T23) <= pose_slack and abs(T21 - s12m4) <= pose_slack and abs(T11 -
        c12m4) <= pose_slack and abs(T13) <= pose_slack)
    ):
        return  # the arm can't take this pose

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta2
        if e1 < 0.0 and not apart2:
            continue  # both signs give the same
        s2 = w2 * e1 * k2
        q2 = _atan2(s2, c2)

        # theta1
        Y1_1 = a2 * s2
        S1 = v2 - T14 * Y1_1
        C1 = v3 + T24 * Y1_1
        w1 = math.sqrt(S1 * S1 + C1 * C1)
        free1 = w1 <= free_limit_squared2
        factor1 = 1.0 / (1.0 if free1 else w1)
        c1 = math.cos(seed[0]) if free1 else C1 * factor1
        s1 = math.sin(seed[0]) if free1 else S1 * factor1
        q1 = _atan2(s1, c1)

        # is the pose one that the arm can take?
        c12 = c2 * c1 - s2 * s1
        s12 = c2 * s1 + s2 * c1
        if (
            not (abs(T14 - (a2 * c12 + a1 * c1)) <= pose_slack1 and abs(T24 - (a2 * s12 + a1 * s1))
            <= pose_slack1)
        ):
            continue  # the arm can't take this pose

        # joint values
        q4 = _wrap(q2 + q1 - theta12m4)
        row = i1
        q[row, 0] = q1
        q[row, 1] = q2
        q[row, 2] = r3
        q[row, 3] = q4
        status[row] = FREE_JOINT if free1 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px * px * px) and math.isfinite(py * py * py) and math.isfinite(pz * pz * pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 0.987, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([1.013, 1.013, 1.013, 1.0, 1.0, 1.0])


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
    J, rows, square = jacobian(q), np.zeros((6, 10)), np.zeros(6)
    for i in range(6):
        for j in range(4):
            rows[i, j] = 0.0 if held[j] else _PACE[j] * _MISS_WEIGHT[i] * J[i, j]
        rows[i, 4 + i] = math.sqrt(damping + 1e-26)
        for n in range(2 * i):
            k, along = n % i, 0.0
            for j in range(10):
                along += rows[k, j] * rows[i, j] / square[k]
            for j in range(10):
                rows[i, j] -= along * rows[k, j]
            e[i] -= along * e[k]
        for j in range(10):
            square[i] += rows[i, j] * rows[i, j]
        for j in range(4):
            q[j] += e[i] / square[i] * rows[i, j] * _PACE[j]


@_inner
def _half_way(x, q, half):
    """How far joint values are from others, but for whole turns [rad, arm sizes].

    Those half way go into half.
    """
    most = 0.0
    for i in range(4):
        off = q[i] - x[i]
        if _REVOLUTE[i]:
            off -= turn * math.floor(off / turn + 0.5)
        most = max(most, abs(off) * math.sqrt(_WEIGHT[i]))
        half[i] = x[i] + 0.5 * off
    return most


@_apart("boolean(UniTuple(float64, 12), float64, float64, float64[::1])")
def _settled(T, enough, most, q):
    """Takes joint values to some not farther than most that miss the pose by less than enough.

    Returns if it can.
    Damped least squares, while they gain: where roots meet a step still leaves less than half.
    Until one gains little they are damped so that none leads far.
    """
    half = np.empty(4)
    held, x, settled = np.zeros(4, np.bool_), q.copy(), False
    last, lost = math.inf, 0
    for _ in range(20):
        e, miss = _miss(T, x)
        if miss < enough:
            for i in range(4):
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
    values = np.empty(4)
    for i in range(4):
        values[i] = q[i]
    settled = _settled(pose, enough, most, values)
    for i in range(4):
        q[i] = values[i]
    return settled


@_inner
def _stay(pose, seed, q, status):
    """Where rounding can't tell solutions apart the arm goes on with the one that it is at.

    The solution next to the seed gets a row unless it has one: that of one beside
    it, that of one which it is told from by nothing, one that is left, or any.
    """
    x, half, place, least = np.empty(4), np.empty(4), 0, math.inf
    nearest = 0.001
    for i in range(4):
        x[i] = seed[i]
    if not _settle(pose, 1e-12, 0.15, x):
        return
    for row in range(2 - 1, -1, -1):
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
        for i in range(4):
            q[place, i] = x[i]


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(2):
        status[row] = UNREACHABLE
        for i in range(4):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    _stay(pose, seed, q, status)
    count = 0
    for row in range(2):
        if status[row] == UNREACHABLE:
            continue
        for i in range(4):
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
    T11, _, T13, T14, T21, _, T23, T24, T31, _, T33, T34 = pose
    room = carray(_room(16), 16)

    # r3, type 1: U0[3, 4]
    r3 = d1 - T34

    # theta2, type 8: U0[1, 4] and U0[2, 4]
    N2 = T14 * T14 + T24 * T24
    D2 = (longest2 - N2) * (N2 - shortest2)
    w2 = math.sqrt(D2)

    # theta1, type 3: U0[2, 4] and U0[1, 4]
    v1 = m3 + m2 * N2
    v2 = T24 * v1
    v3 = T14 * v1
    v4 = w2 * (m2 * T14)
    v5 = w2 * (m2 * T24)

    # is the pose one that the arm can take?
    v6 = T34 - (d1 - r3)
    v7 = 1.0 + T33
    v8 = T21 * T21 + T11 * T11 - 1.0

    # joint values
    q3_p = r3 + (w2 - w2)

    # a joint is free, or branches meet
    if m4 < v6 * v6 or m5 < v7 * v7 + T31 * T31 + T23 * T23 + T13 * T13 + v8 * v8 or abs(D2) <= m1:
        return False

    # angles, side by side
    room[0] = T21
    room[1] = w2
    room[2] = v2 - v4
    room[3] = v2 + v4
    room[8] = T11
    room[9] = N2 - k1
    room[10] = v3 + v5
    room[11] = v3 - v5
    for k in range(4, 8):
        room[k] = room[k + 8] = 1.0
    for k in range(8):
        room[k] = _atan2(room[k], room[k + 8])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]
    angle4 = room[3]

    # joint values
    v9 = angle2 + angle3 - angle1
    v10 = angle4 - angle2 - angle1
    q4_p = v9 + (turn if v9 <= -half_turn else (-turn if half_turn < v9 else 0.0))
    q4_m = v10 + (turn if v10 <= -half_turn else (-turn if half_turn < v10 else 0.0))

    q[0, 0] = angle3
    q[0, 1] = angle2
    q[0, 2] = q3_p
    q[0, 3] = q4_p
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = angle4
    q[1, 1] = -angle2
    q[1, 2] = q3_p
    q[1, 3] = q4_m
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    return True


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (2, 4) or status.shape != (2,):
        raise ValueError("T, q and status must have shapes (4, 4), (2, 4), (2,)")
    valid, pose = _read(T)
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    if _COMPILED and _regular(pose, q, status):
        count = 0
        for row in range(2):
            count += status[row] == OK
        return count
    return _whole(pose, seed, q, status)


# Where in a tile the rows' values and statuses begin.
_PLACES = np.array([
    [480, 496, 512, 528],
    [544, 560, 512, 576],
])
_KINDS = np.array([592, 608])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(624), 624)
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
                - 1.0) + 0.0 * (work[48 + k] * work[48 + k] * work[48 + k] + work[112 + k] *
                work[112 + k] * work[112 + k] + work[176 + k] * work[176 + k] * work[176 + k])
            )
            exact = miss <= 1e-24
            work[256 + k] = 0.0 if exact else 1.0
        for k in range(0, 16):
            T11 = work[0 + k]
            T14 = work[48 + k]
            T21 = work[64 + k]
            T24 = work[112 + k]
            T33 = work[160 + k]
            T34 = work[176 + k]
            r3 = d1 - T34
            N2 = T14 * T14 + T24 * T24
            D2 = (longest2 - N2) * (N2 - shortest2)
            w2 = math.sqrt(D2)
            v1 = m3 + m2 * N2
            v2 = T24 * v1
            v3 = T14 * v1
            v4 = w2 * (m2 * T14)
            v5 = w2 * (m2 * T24)
            v6 = T34 - (d1 - r3)
            v7 = 1.0 + T33
            v8 = T21 * T21 + T11 * T11 - 1.0
            q3_p = r3 + (w2 - w2)
            work[272 + k] = D2
            work[288 + k] = v6
            work[304 + k] = v7
            work[320 + k] = v8
            work[336 + k] = q3_p
            work[352 + k] = T21
            work[368 + k] = w2
            work[384 + k] = v2 - v4
            work[400 + k] = v2 + v4
            work[416 + k] = T11
            work[432 + k] = N2 - k1
            work[448 + k] = v3 + v5
            work[464 + k] = v3 - v5
        for k in range(352, 416):
            work[k] = _atan2(work[k], work[k + 64])
        for k in range(0, 16):
            T13 = work[32 + k]
            T23 = work[96 + k]
            T31 = work[128 + k]
            D2 = work[272 + k]
            v6 = work[288 + k]
            v7 = work[304 + k]
            v8 = work[320 + k]
            q3_p = work[336 + k]
            angle1 = work[352 + k]
            angle2 = work[368 + k]
            angle3 = work[384 + k]
            angle4 = work[400 + k]
            v9 = angle2 + angle3 - angle1
            v10 = angle4 - angle2 - angle1
            q4_p = v9 + (turn if v9 <= -half_turn else (-turn if half_turn < v9 else 0.0))
            q4_m = v10 + (turn if v10 <= -half_turn else (-turn if half_turn < v10 else 0.0))
            _480 = angle3
            work[480 + k] = _480
            _496 = angle2
            work[496 + k] = _496
            _512 = q3_p
            work[512 + k] = _512
            _528 = q4_p
            work[528 + k] = _528
            _544 = angle4
            work[544 + k] = _544
            _560 = -angle2
            work[560 + k] = _560
            _576 = q4_m
            work[576 + k] = _576
            work[592 + k] = UNREACHABLE if _480 != _480 else OK
            work[608 + k] = UNREACHABLE if _544 != _544 else OK
            work[256 + k] = (
                1.0 if m4 < v6 * v6 or m5 < v7 * v7 + T31 * T31 + T23 * T23 + T13 * T13 + v8 * v8 or
                abs(D2) <= m1 else work[256 + k]
            )
        for k in range(first, first + count):
            if work[256 + k - first] != 0.0:
                _unseeded(T[k], q[k], status[k])
                continue
            for row in range(2):
                status[k, row] = np.uint8(work[_KINDS[row] + k - first])
                for i in range(4):
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
            "no_pose": "not finite or beyond 5e102, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)",
            "no_row": "the pose is out of reach, or one that 4 joints can't take",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
