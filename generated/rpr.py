"""rpr: Arm with a revolute, a prismatic and a revolute joint.

Inverse kinematics, generated from robots/rpr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/rpr.yaml. The formulas and where they come from: rpr.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
position T[0:3, 3] counts; other entries are ignored.
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
_read_rows = _runtime("pose").read_position
_of_joints = _runtime("entry").of_joints(_HOW, 3)

NAME = "rpr"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RPR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "shoulder+-noflip",
    "shoulder+-flip",
    "shoulder--noflip",
    "shoulder--flip",
)
MAX_SOLUTIONS = 4

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.5  # joint offset 1 [m]
a3 = 0.3  # link length 3 [m]
free_limit1 = 8e-13  # a length that fixes no angle [m]
reach_slack1 = 8.000000000000001e-14  # rounding at the boundary of the workspace [m]
merge_slack1 = 8e-15  # nearer to that boundary two branches are one [m]
k1 = 0.09  # a3^2 [m^2]
k2 = 11.111111111111112  # 1 / k1 [m^-2]
m1 = 6.400000000000001e-09  # doubt_limit1^2 [m^2]
m3 = 8e-12  # 1000 * merge_slack1 [m]

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 8e-10, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.5624999999999998, 1.0])
_JOINTS = np.column_stack([_LOWEST, _HIGHEST, [kind == "R" for kind in JOINT_TYPES], _WEIGHT])


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 3 joint values")
    T = np.zeros((4, 4))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    v1 = s1 * s3
    x3_y = c1 * s3
    T[0, 0] = -v1
    T[0, 1] = -(s1 * c3)
    T[0, 2] = c1
    T[0, 3] = -(s1 * q[1] + v1 * a3)
    T[1, 0] = x3_y
    T[1, 1] = c1 * c3
    T[1, 2] = s1
    T[1, 3] = c1 * q[1] + x3_y * a3
    T[2, 0] = -c3
    T[2, 1] = s3
    T[2, 3] = d1 - c3 * a3
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 3 joint values")
    J = np.zeros((6, 3))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    v1 = s1 * q[1]
    p2_y = c1 * q[1]
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    v2 = v1 + s1 * s3 * a3
    p3_y = p2_y + c1 * s3 * a3
    v3 = d1 - c3 * a3 - d1
    J[0, 0] = -p3_y
    J[0, 1] = -s1
    J[0, 2] = s1 * v3
    J[1, 0] = -v2
    J[1, 1] = c1
    J[1, 2] = -(c1 * v3)
    J[2, 2] = c1 * (p3_y - p2_y) - s1 * (v1 - v2)
    J[3, 2] = c1
    J[4, 2] = s1
    J[5, 0] = 1.0
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    # theta1, type 2: U1[1, 4]
    w1 = math.sqrt(T24 * T24 + T14 * T14)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 2: U0[3, 4]
    Z3 = T34 - d1
    D3 = k1 - Z3 * Z3
    v1 = 2.0 * abs(Z3)
    apart3 = merge_slack1 * (v1 + merge_slack1) < D3
    if not (-(reach_slack1 * (v1 + reach_slack1)) <= D3):
        return  # out of reach
    w3 = math.sqrt(D3 if apart3 else 0.0)

    for i1 in range(2):  # shoulder+, shoulder-
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else T24 * factor1
        s1 = math.sin(seed[0]) if free1 else -(T14 * factor1)
        q1 = _atan2(s1, c1)
        root1 = w1 * e1

        for i2 in range(2):  # noflip, flip
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            v2 = k2 * (a3 * (w3 * e2))
            q3 = _atan2(-v2, -(k2 * (a3 * Z3)))

            # r2, type 1: U1[3, 4]
            v3 = a3 * v2
            r2 = root1 + v3
            row = 2 * i1 + i2
            q[row, 0] = q1
            q[row, 1] = r2
            q[row, 2] = q3
            status[row] = FREE_JOINT if free1 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px * px * px) and math.isfinite(py * py * py) and math.isfinite(pz * pz * pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 0.8, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([1.25, 1.25, 1.25, 0.0, 0.0, 0.0])


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
    return e, math.sqrt(square)


@_inner
def _add_step(held, damping, e, q):
    """Adds the damped least squares step that the miss e asks for to joint values.

    The rows of the Jacobian, each with its share of the damping's root, are made orthogonal one
    after another (modified Gram-Schmidt), twice: once would not do beside singular places.
    """
    J, rows, square = jacobian(q), np.zeros((6, 9)), np.zeros(6)
    for i in range(6):
        for j in range(3):
            rows[i, j] = 0.0 if held[j] else _PACE[j] * _MISS_WEIGHT[i] * J[i, j]
        rows[i, 3 + i] = math.sqrt(damping + 1e-26)
        for n in range(2 * i):
            k, along = n % i, 0.0
            for j in range(9):
                along += rows[k, j] * rows[i, j] / square[k]
            for j in range(9):
                rows[i, j] -= along * rows[k, j]
            e[i] -= along * e[k]
        for j in range(9):
            square[i] += rows[i, j] * rows[i, j]
        for j in range(3):
            q[j] += e[i] / square[i] * rows[i, j] * _PACE[j]


@_inner
def _half_way(x, q, half):
    """How far joint values are from others, but for whole turns [rad, arm sizes].

    Those half way go into half.
    """
    most = 0.0
    for i in range(3):
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
    half = np.empty(3)
    held, x, settled = np.zeros(3, np.bool_), q.copy(), False
    last, lost = math.inf, 0
    for _ in range(20):
        e, miss = _miss(T, x)
        if miss < enough:
            for i in range(3):
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
    values = np.empty(3)
    for i in range(3):
        values[i] = q[i]
    settled = _settled(pose, enough, most, values)
    for i in range(3):
        q[i] = values[i]
    return settled


@_inner
def _stay(pose, seed, q, status):
    """Where rounding can't tell solutions apart the arm goes on with the one that it is at.

    The solution next to the seed gets a row unless it has one: that of one beside
    it, that of one which it is told from by nothing, one that is left, or any.
    """
    x, half, place, least = np.empty(3), np.empty(3), 0, math.inf
    nearest = 0.001
    for i in range(3):
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
        for i in range(3):
            q[place, i] = x[i]


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(4):
        status[row] = UNREACHABLE
        for i in range(3):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    _stay(pose, seed, q, status)
    count = 0
    for row in range(4):
        if status[row] == UNREACHABLE:
            continue
        for i in range(3):
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
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose
    room = carray(_room(16), 16)

    # theta1, type 2: U1[1, 4]
    v1 = T24 * T24 + T14 * T14
    w1 = math.sqrt(v1)

    # theta3, type 2: U0[3, 4]
    Z3 = T34 - d1
    D3 = k1 - Z3 * Z3
    w3 = math.sqrt(D3)
    v2 = w3 - w3

    # r2, type 1: U1[3, 4]
    q2_pp = w1 + w3
    q2_pm = w1 - w3

    # a joint is free, or branches meet
    if v1 <= m1 or abs(D3) <= m3 * (merge_slack1 + 2.0 * abs(Z3)):
        return False

    # angles, side by side
    room[0] = -T14
    room[1] = -(a3 * w3)
    room[8] = T24
    room[9] = -(a3 * Z3)
    for k in range(2, 8):
        room[k] = room[k + 8] = 1.0
    for k in range(8):
        room[k] = _atan2(room[k], room[k + 8])
    angle1 = room[0]
    angle2 = room[1]

    # joint values
    q1_pp = angle1 + v2
    q1_mp = v2 + (angle1 - math.copysign(half_turn, -T14))

    q[0, 0] = q1_pp
    q[0, 1] = q2_pp
    q[0, 2] = angle2
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_pp
    q[1, 1] = q2_pm
    q[1, 2] = -angle2
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = q1_mp
    q[2, 1] = -q2_pm
    q[2, 2] = angle2
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = q1_mp
    q[3, 1] = -q2_pp
    q[3, 2] = -angle2
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else OK
    return True


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (4, 3) or status.shape != (4,):
        raise ValueError("T, q and status must have shapes (4, 4), (4, 3), (4,)")
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
    [432, 448, 464],
    [432, 480, 496],
    [512, 528, 464],
    [512, 544, 496],
])
_KINDS = np.array([560, 576, 592, 608])


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
            miss = (
                0.0 * (work[48 + k] * work[48 + k] * work[48 + k] + work[112 + k] * work[112 + k] *
                work[112 + k] + work[176 + k] * work[176 + k] * work[176 + k])
            )
            exact = miss <= 1e-24
            work[256 + k] = 0.0 if exact else 1.0
        for k in range(0, 16):
            T14 = work[48 + k]
            T24 = work[112 + k]
            T34 = work[176 + k]
            v1 = T24 * T24 + T14 * T14
            w1 = math.sqrt(v1)
            Z3 = T34 - d1
            D3 = k1 - Z3 * Z3
            w3 = math.sqrt(D3)
            v2 = w3 - w3
            q2_pp = w1 + w3
            q2_pm = w1 - w3
            work[272 + k] = v1
            work[288 + k] = Z3
            work[304 + k] = D3
            work[320 + k] = v2
            work[336 + k] = q2_pp
            work[352 + k] = q2_pm
            work[368 + k] = -T14
            work[384 + k] = -(a3 * w3)
            work[400 + k] = T24
            work[416 + k] = -(a3 * Z3)
        for k in range(368, 400):
            work[k] = _atan2(work[k], work[k + 32])
        for k in range(0, 16):
            T14 = work[48 + k]
            v1 = work[272 + k]
            Z3 = work[288 + k]
            D3 = work[304 + k]
            v2 = work[320 + k]
            q2_pp = work[336 + k]
            q2_pm = work[352 + k]
            angle1 = work[368 + k]
            angle2 = work[384 + k]
            q1_pp = angle1 + v2
            q1_mp = v2 + (angle1 - math.copysign(half_turn, -T14))
            _432 = q1_pp
            work[432 + k] = _432
            _448 = q2_pp
            work[448 + k] = _448
            _464 = angle2
            work[464 + k] = _464
            _480 = q2_pm
            work[480 + k] = _480
            _496 = -angle2
            work[496 + k] = _496
            _512 = q1_mp
            work[512 + k] = _512
            _528 = -q2_pm
            work[528 + k] = _528
            _544 = -q2_pp
            work[544 + k] = _544
            work[560 + k] = UNREACHABLE if _432 != _432 else OK
            work[576 + k] = UNREACHABLE if _432 != _432 else OK
            work[592 + k] = UNREACHABLE if _512 != _512 else OK
            work[608 + k] = UNREACHABLE if _512 != _512 else OK
            work[256 + k] = (
                1.0 if v1 <= m1 or abs(D3) <= m3 * (merge_slack1 + 2.0 * abs(Z3)) else work[256 + k]
            )
        for k in range(first, first + count):
            if work[256 + k - first] != 0.0:
                _unseeded(T[k], q[k], status[k])
                continue
            for row in range(4):
                status[k, row] = np.uint8(work[_KINDS[row] + k - first])
                for i in range(3):
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
            "no_pose": "not finite or beyond 5e102",
            "no_row": "the pose is out of reach",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
