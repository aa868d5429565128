"""olson_pprrrr: Olson PPRRRR arm.

Inverse kinematics, generated from robots/olson_pprrrr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/olson_pprrrr.yaml. The formulas and where they come from:
olson_pprrrr.md.

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
_of_joints = _runtime("entry").of_joints(_HOW, 6)

NAME = "olson_pprrrr"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "PPRRRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "elbow+-noflip",
    "elbow+-flip",
    "elbow--noflip",
    "elbow--flip",
)
MAX_SOLUTIONS = 4

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d3 = 1.0  # joint offset 3 [m]
a4 = 4.0  # link length 5 [m]
d6 = 2.0  # joint offset 6 [m]
free_limit = 1e-12  # a length that fixes no angle
near_limit = 0.001  # a length whose direction is good to few digits
reach_slack1 = 7e-13  # rounding at the boundary of the workspace [m]
merge_slack1 = 7e-14  # nearer to that boundary two branches are one [m]
# the same where they follow an angle that is good to few digits [m]
blur_slack1 = 6.999999999999999e-11
k1 = 16.0  # a4^2 [m^2]
k2 = 0.0625  # 1 / k1 [m^-2]
m1 = 9.999999999999999e-09  # doubt_limit^2
m3 = 6.999999999999999e-10  # 10 * blur_slack1 [m]

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([7e-09, 7e-09, 1e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([0.02040816326530612, 0.02040816326530612, 1.0, 1.0, 1.0, 1.0])
_JOINTS = np.column_stack([_LOWEST, _HIGHEST, [kind == "R" for kind in JOINT_TYPES], _WEIGHT])


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    T = np.zeros((4, 4))
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = s3 * c4
    v1 = c3 * c4
    v2 = s3 * s4
    y4_y = c3 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 - v2 * s5
    x5_y = y4_y * s5 - v1 * c5
    x5_z = s4 * c5 + c4 * s5
    z6_x = v2 * c5 + x4_x * s5
    y5_y = y4_y * c5 + v1 * s5
    y5_z = c4 * c5 - s4 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 - c3 * s6
    T[0, 1] = -(c3 * c6 + x5_x * s6)
    T[0, 2] = z6_x
    T[0, 3] = q[1] + x4_x * a4 + z6_x * d6
    T[1, 0] = x5_y * c6 - s3 * s6
    T[1, 1] = -(s3 * c6 + x5_y * s6)
    T[1, 2] = -y5_y
    T[1, 3] = q[0] - v1 * a4 - y5_y * d6
    T[2, 0] = x5_z * c6
    T[2, 1] = -(x5_z * s6)
    T[2, 2] = -y5_z
    T[2, 3] = d3 + s4 * a4 - y5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    J = np.zeros((6, 6))
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = s3 * c4
    v1 = c3 * c4
    p5_x = q[1] + x4_x * a4
    p5_y = q[0] - v1 * a4
    p5_z = d3 + s4 * a4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    z6_x = s3 * s4 * c5 + x4_x * s5
    y5_y = c3 * s4 * c5 + v1 * s5
    y5_z = c4 * c5 - s4 * s5
    p6_x = p5_x + z6_x * d6
    p6_y = p5_y - y5_y * d6
    p6_z = p5_z - y5_z * d6
    J23 = p6_x - q[1]
    v2 = p6_y - q[0]
    v3 = p6_z - d3
    v4 = p6_z - p5_z
    J[0, 1] = 1.0
    J[0, 2] = -v2
    J[0, 3] = -(s3 * v3)
    J[0, 4] = -(s3 * v4)
    J[1, 0] = 1.0
    J[1, 2] = J23
    J[1, 3] = c3 * v3
    J[1, 4] = c3 * v4
    J[2, 3] = s3 * J23 - c3 * v2
    J[2, 4] = s3 * (p6_x - p5_x) - c3 * (p6_y - p5_y)
    J[3, 3] = -c3
    J[3, 4] = -c3
    J[3, 5] = z6_x
    J[4, 3] = -s3
    J[4, 4] = -s3
    J[4, 5] = -y5_y
    J[5, 2] = 1.0
    J[5, 5] = -y5_z
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, _, _, T33, T34 = pose

    # theta3, type 2: U3[2, 3]
    w3 = math.sqrt(T23 * T23 + T13 * T13)
    free3 = w3 <= free_limit
    divisor3 = 1.0 if free3 else w3
    near3 = w3 <= near_limit

    # theta4, type 2: U0 A6^-1 [3, 4]
    wz = T34 - T33 * d6
    Z4 = wz - d3
    D4 = k1 - Z4 * Z4
    v3 = 2.0 * abs(Z4)
    apart4 = merge_slack1 * (v3 + merge_slack1) < D4
    if not (-(reach_slack1 * (v3 + reach_slack1)) <= D4):
        return  # out of reach
    w4 = math.sqrt(D4 if apart4 else 0.0)
    s4 = k2 * (a4 * Z4)

    # r2, type 1: U0 A6^-1 [1, 4]
    wx = T14 - T13 * d6

    # r1, type 1: U0 A6^-1 [2, 4]
    wy = T24 - T23 * d6

    for i1 in range(2):  # elbow+, elbow-
        e1 = 1.0 - 2.0 * i1
        # theta3
        if e1 < 0.0 and free3:
            continue  # both signs give the same
        factor3 = e1 / divisor3
        v1 = T23 * factor3
        v2 = T13 * factor3
        off3 = w3 * abs(v1 * math.sin(seed[2]) + v2 * math.cos(seed[2])) if near3 else 1.0
        ahead3 = v1 * math.cos(seed[2]) - v2 * math.sin(seed[2]) if near3 else -1.0
        same3 = near3 and 0.0 < ahead3 and off3 <= free_limit
        held3 = free3 or same3
        c3 = math.cos(seed[2]) if held3 else v1
        s3 = math.sin(seed[2]) if held3 else -v2
        q3 = _atan2(s3, c3)

        # r2
        v5 = s3 * a4

        # r1
        v6 = c3 * a4

        # theta45, type 3: U3[3, 3] and U3[1, 3]
        theta45 = _atan2(-(w3 * e1), -T33)

        # theta6, type 3: U3[2, 2] and U3[2, 1]
        q6 = _atan2(-(T11 * c3 + T21 * s3), -(T12 * c3 + T22 * s3))

        for i2 in range(2):  # noflip, flip
            e2 = 1.0 - 2.0 * i2
            # theta4
            if e2 < 0.0 and (not apart4 or (near3 and not (blur_slack1 * (v3 + blur_slack1) < D4))):
                continue  # both signs give the same
            v4 = k2 * (a4 * (w4 * e2))
            q4 = _atan2(s4, -v4)

            # r2
            r2 = wx + v4 * v5

            # r1
            r1 = wy - v4 * v6

            # joint values
            q5 = _wrap(theta45 - q4)
            row = 2 * i1 + i2
            q[row, 0] = r1
            q[row, 1] = r2
            q[row, 2] = q3
            q[row, 3] = q4
            q[row, 4] = q5
            q[row, 5] = q6
            status[row] = FREE_JOINT if free3 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px * px * px) and math.isfinite(py * py * py) and math.isfinite(pz * pz * pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([7.0, 7.0, 1.0, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.1429, 0.1429, 0.1429, 1.0, 1.0, 1.0])


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
    J, rows, square = jacobian(q), np.zeros((6, 12)), np.zeros(6)
    for i in range(6):
        for j in range(6):
            rows[i, j] = 0.0 if held[j] else _PACE[j] * _MISS_WEIGHT[i] * J[i, j]
        rows[i, 6 + i] = math.sqrt(damping + 1e-26)
        for n in range(2 * i):
            k, along = n % i, 0.0
            for j in range(12):
                along += rows[k, j] * rows[i, j] / square[k]
            for j in range(12):
                rows[i, j] -= along * rows[k, j]
            e[i] -= along * e[k]
        for j in range(12):
            square[i] += rows[i, j] * rows[i, j]
        for j in range(6):
            q[j] += e[i] / square[i] * rows[i, j] * _PACE[j]


@_inner
def _half_way(x, q, half):
    """How far joint values are from others, but for whole turns [rad, arm sizes].

    Those half way go into half.
    """
    most = 0.0
    for i in range(6):
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
    half = np.empty(6)
    held, x, settled = np.zeros(6, np.bool_), q.copy(), False
    last, lost = math.inf, 0
    for _ in range(20):
        e, miss = _miss(T, x)
        if miss < enough:
            for i in range(6):
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
    values = np.empty(6)
    for i in range(6):
        values[i] = q[i]
    settled = _settled(pose, enough, most, values)
    for i in range(6):
        q[i] = values[i]
    return settled


@_inner
def _stay(pose, seed, q, status):
    """Where rounding can't tell solutions apart the arm goes on with the one that it is at.

    The solution next to the seed gets a row unless it has one: that of one beside
    it, that of one which it is told from by nothing, one that is left, or any.
    """
    x, half, place, least = np.empty(6), np.empty(6), 0, math.inf
    nearest = 0.001
    for i in range(6):
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
        for i in range(6):
            q[place, i] = x[i]


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(4):
        status[row] = UNREACHABLE
        for i in range(6):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    _stay(pose, seed, q, status)
    count = 0
    for row in range(4):
        if status[row] == UNREACHABLE:
            continue
        for i in range(6):
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
    T11, T12, T13, T14, T21, T22, T23, T24, _, _, T33, T34 = pose
    room = carray(_room(16), 16)

    # theta3, type 2: U3[2, 3]
    v1 = T23 * T23 + T13 * T13
    w3 = math.sqrt(v1)
    factor3 = w3 * (1.0 / v1)
    c3 = T23 * factor3
    v2 = T13 * factor3

    # theta4, type 2: U0 A6^-1 [3, 4]
    Z4 = T34 - d6 * T33 - d3
    D4 = k1 - Z4 * Z4
    w4 = math.sqrt(D4)
    v3 = w4 - w4
    v4 = a4 * w4
    v5 = k2 * v4
    v6 = a4 * Z4

    # r2, type 1: U0 A6^-1 [1, 4]
    wx = T14 - d6 * T13
    v7 = v5 * (a4 * v2)
    q2_pp = wx - v7
    q2_pm = wx + v7

    # r1, type 1: U0 A6^-1 [2, 4]
    wy = T24 - d6 * T23
    v8 = v5 * (a4 * c3)
    q1_pp = wy - v8
    q1_pm = wy + v8

    # theta6, type 3: U3[2, 2] and U3[2, 1]
    v9 = v2 * T21 - c3 * T11

    # a joint is free, or branches meet
    if v1 <= m1 or abs(D4) <= m3 * (blur_slack1 + 2.0 * abs(Z4)):
        return False

    # angles, side by side
    room[0] = -T13
    room[1] = v6
    room[2] = -w3
    room[3] = v9
    room[8] = T23
    room[9] = -v4
    room[10] = -T33
    room[11] = v2 * T22 - c3 * T12
    for k in range(4, 8):
        room[k] = room[k + 8] = 1.0
    for k in range(8):
        room[k] = _atan2(room[k], room[k + 8])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]
    angle4 = room[3]

    # theta4, type 2: U0 A6^-1 [3, 4]
    q4_pm = math.copysign(half_turn, v6) - angle2

    # joint values
    v10 = angle3 - angle2
    v11 = angle3 - q4_pm
    v12 = angle2 + angle3
    v13 = q4_pm + angle3
    q5_pp = v10 + (turn if v10 <= -half_turn else (-turn if half_turn < v10 else 0.0))
    q5_pm = v11 + (turn if v11 <= -half_turn else (-turn if half_turn < v11 else 0.0))
    q5_mp = (turn if -v12 <= -half_turn else (-turn if half_turn < -v12 else 0.0)) - v12
    q5_mm = (turn if -v13 <= -half_turn else (-turn if half_turn < -v13 else 0.0)) - v13
    q3_pp = angle1 + v3
    q3_mp = v3 + (angle1 - math.copysign(half_turn, -T13))
    q6_pp = v3 + angle4
    q6_mp = v3 + (angle4 - math.copysign(half_turn, v9))

    q[0, 0] = q1_pp
    q[0, 1] = q2_pp
    q[0, 2] = q3_pp
    q[0, 3] = angle2
    q[0, 4] = q5_pp
    q[0, 5] = q6_pp
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_pm
    q[1, 1] = q2_pm
    q[1, 2] = q3_pp
    q[1, 3] = q4_pm
    q[1, 4] = q5_pm
    q[1, 5] = q6_pp
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = q1_pm
    q[2, 1] = q2_pm
    q[2, 2] = q3_mp
    q[2, 3] = angle2
    q[2, 4] = q5_mp
    q[2, 5] = q6_mp
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = q1_pp
    q[3, 1] = q2_pp
    q[3, 2] = q3_mp
    q[3, 3] = q4_pm
    q[3, 4] = q5_mm
    q[3, 5] = q6_mp
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else OK
    return True


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (4, 6) or status.shape != (4,):
        raise ValueError("T, q and status must have shapes (4, 4), (4, 6), (4,)")
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
    [560, 576, 592, 608, 624, 640],
    [656, 672, 592, 688, 704, 640],
    [656, 672, 720, 608, 736, 752],
    [560, 576, 720, 688, 768, 752],
])
_KINDS = np.array([784, 800, 816, 832])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(848), 848)
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
            T12 = work[16 + k]
            T13 = work[32 + k]
            T14 = work[48 + k]
            T21 = work[64 + k]
            T22 = work[80 + k]
            T23 = work[96 + k]
            T24 = work[112 + k]
            T33 = work[160 + k]
            T34 = work[176 + k]
            v1 = T23 * T23 + T13 * T13
            w3 = math.sqrt(v1)
            factor3 = w3 * (1.0 / v1)
            c3 = T23 * factor3
            v2 = T13 * factor3
            Z4 = T34 - d6 * T33 - d3
            D4 = k1 - Z4 * Z4
            w4 = math.sqrt(D4)
            v3 = w4 - w4
            v4 = a4 * w4
            v5 = k2 * v4
            v6 = a4 * Z4
            wx = T14 - d6 * T13
            v7 = v5 * (a4 * v2)
            q2_pp = wx - v7
            q2_pm = wx + v7
            wy = T24 - d6 * T23
            v8 = v5 * (a4 * c3)
            q1_pp = wy - v8
            q1_pm = wy + v8
            v9 = v2 * T21 - c3 * T11
            work[272 + k] = v1
            work[288 + k] = Z4
            work[304 + k] = D4
            work[320 + k] = v3
            work[336 + k] = v6
            work[352 + k] = q2_pp
            work[368 + k] = q2_pm
            work[384 + k] = q1_pp
            work[400 + k] = q1_pm
            work[416 + k] = v9
            work[432 + k] = -T13
            work[448 + k] = v6
            work[464 + k] = -w3
            work[480 + k] = v9
            work[496 + k] = T23
            work[512 + k] = -v4
            work[528 + k] = -T33
            work[544 + k] = v2 * T22 - c3 * T12
        for k in range(432, 496):
            work[k] = _atan2(work[k], work[k + 64])
        for k in range(0, 16):
            T13 = work[32 + k]
            v1 = work[272 + k]
            Z4 = work[288 + k]
            D4 = work[304 + k]
            v3 = work[320 + k]
            v6 = work[336 + k]
            q2_pp = work[352 + k]
            q2_pm = work[368 + k]
            q1_pp = work[384 + k]
            q1_pm = work[400 + k]
            v9 = work[416 + k]
            angle1 = work[432 + k]
            angle2 = work[448 + k]
            angle3 = work[464 + k]
            angle4 = work[480 + k]
            q4_pm = math.copysign(half_turn, v6) - angle2
            v10 = angle3 - angle2
            v11 = angle3 - q4_pm
            v12 = angle2 + angle3
            v13 = q4_pm + angle3
            q5_pp = v10 + (turn if v10 <= -half_turn else (-turn if half_turn < v10 else 0.0))
            q5_pm = v11 + (turn if v11 <= -half_turn else (-turn if half_turn < v11 else 0.0))
            q5_mp = (turn if -v12 <= -half_turn else (-turn if half_turn < -v12 else 0.0)) - v12
            q5_mm = (turn if -v13 <= -half_turn else (-turn if half_turn < -v13 else 0.0)) - v13
            q3_pp = angle1 + v3
            q3_mp = v3 + (angle1 - math.copysign(half_turn, -T13))
            q6_pp = v3 + angle4
            q6_mp = v3 + (angle4 - math.copysign(half_turn, v9))
            _560 = q1_pp
            work[560 + k] = _560
            _576 = q2_pp
            work[576 + k] = _576
            _592 = q3_pp
            work[592 + k] = _592
            _608 = angle2
            work[608 + k] = _608
            _624 = q5_pp
            work[624 + k] = _624
            _640 = q6_pp
            work[640 + k] = _640
            _656 = q1_pm
            work[656 + k] = _656
            _672 = q2_pm
            work[672 + k] = _672
            _688 = q4_pm
            work[688 + k] = _688
            _704 = q5_pm
            work[704 + k] = _704
            _720 = q3_mp
            work[720 + k] = _720
            _736 = q5_mp
            work[736 + k] = _736
            _752 = q6_mp
            work[752 + k] = _752
            _768 = q5_mm
            work[768 + k] = _768
            work[784 + k] = UNREACHABLE if _560 != _560 else OK
            work[800 + k] = UNREACHABLE if _656 != _656 else OK
            work[816 + k] = UNREACHABLE if _656 != _656 else OK
            work[832 + k] = UNREACHABLE if _560 != _560 else OK
            work[256 + k] = (
                1.0 if v1 <= m1 or abs(D4) <= m3 * (blur_slack1 + 2.0 * abs(Z4)) else work[256 + k]
            )
        for k in range(first, first + count):
            if work[256 + k - first] != 0.0:
                _unseeded(T[k], q[k], status[k])
                continue
            for row in range(4):
                status[k, row] = np.uint8(work[_KINDS[row] + k - first])
                for i in range(6):
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
            "no_row": "the pose is out of reach",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
