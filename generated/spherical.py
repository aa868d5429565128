"""spherical: Spherical arm.

Inverse kinematics, generated from robots/spherical.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/spherical.yaml. The formulas and where they come from: spherical.md.

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

NAME = "spherical"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRP"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "front-forward",
    "front-backward",
    "back-forward",
    "back-backward",
)
MAX_SOLUTIONS = 4

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.5  # joint offset 1 [m]
free_limit1 = 5e-13  # a length that fixes no angle [m]
m1 = 2.4999999999999996e-09  # doubt_limit1^2 [m^2]

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 5e-10])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 4.0])
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
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    v1 = c1 * s2
    v2 = s1 * s2
    T[0, 0] = c1 * c2
    T[0, 1] = -s1
    T[0, 2] = -v1
    T[0, 3] = -(v1 * q[2])
    T[1, 0] = s1 * c2
    T[1, 1] = c1
    T[1, 2] = -v2
    T[1, 3] = -(v2 * q[2])
    T[2, 0] = s2
    T[2, 2] = c2
    T[2, 3] = d1 + c2 * q[2]
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
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    v1 = c1 * s2
    v2 = s1 * s2
    v3 = v1 * q[2]
    J11 = v2 * q[2]
    v4 = d1 + c2 * q[2] - d1
    J[0, 0] = J11
    J[0, 1] = -(c1 * v4)
    J[0, 2] = -v1
    J[1, 0] = -v3
    J[1, 1] = -(s1 * v4)
    J[1, 2] = -v2
    J[2, 1] = -(s1 * J11 + c1 * v3)
    J[2, 2] = c2
    J[3, 1] = s1
    J[4, 1] = -c1
    J[5, 0] = 1.0
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    # theta1, type 2: U1[3, 4]
    w1 = math.sqrt(T14 * T14 + T24 * T24)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta2, r3, type 4: U1[1, 4] and U1[2, 4]
    Y2_2 = T34 - d1
    v1 = Y2_2 * Y2_2

    for i1 in range(2):  # front, back
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else T14 * factor1
        s1 = math.sin(seed[0]) if free1 else T24 * factor1
        q1 = _atan2(s1, c1)
        root1 = w1 * e1

        # theta2, r3
        w3 = math.sqrt(root1 * root1 + v1)
        free2 = w3 <= free_limit1
        divisor2 = 1.0 if free2 else w3

        for i2 in range(2):  # forward, backward
            e2 = 1.0 - 2.0 * i2
            # theta2, r3
            if e2 < 0.0 and free2:
                continue  # both signs give the same
            factor2 = e2 / divisor2
            c2 = math.cos(seed[1]) if free2 else Y2_2 * factor2
            s2 = math.sin(seed[1]) if free2 else -(root1 * factor2)
            q2 = _atan2(s2, c2)
            r3 = w3 * e2
            row = 2 * i1 + i2
            q[row, 0] = q1
            q[row, 1] = q2
            q[row, 2] = r3
            status[row] = FREE_JOINT if free1 or free2 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px * px * px) and math.isfinite(py * py * py) and math.isfinite(pz * pz * pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 0.5])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([2.0, 2.0, 2.0, 0.0, 0.0, 0.0])


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

    # theta1, type 2: U1[3, 4]
    v1 = T14 * T14 + T24 * T24

    # theta2, r3, type 4: U1[1, 4] and U1[2, 4]
    Y2_2 = T34 - d1
    v2 = v1 + Y2_2 * Y2_2
    q3_pp = math.sqrt(v2)

    # a joint is free, or branches meet
    if v1 <= m1 or v2 <= m1:
        return False

    # angles, side by side
    room[0] = T24
    room[1] = -math.sqrt(v1)
    room[8] = T14
    room[9] = Y2_2
    for k in range(2, 8):
        room[k] = room[k + 8] = 1.0
    for k in range(8):
        room[k] = _atan2(room[k], room[k + 8])
    angle1 = room[0]
    angle2 = room[1]

    # theta1, type 2: U1[3, 4]
    q1_mp = angle1 - math.copysign(half_turn, T24)

    # theta2, r3, type 4: U1[1, 4] and U1[2, 4]
    q2_pm = angle2 - math.copysign(half_turn, -math.sqrt(v1))

    q[0, 0] = angle1
    q[0, 1] = angle2
    q[0, 2] = q3_pp
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = angle1
    q[1, 1] = q2_pm
    q[1, 2] = -q3_pp
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = q1_mp
    q[2, 1] = -angle2
    q[2, 2] = q3_pp
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = q1_mp
    q[3, 1] = -q2_pm
    q[3, 2] = -q3_pp
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
    [384, 400, 416],
    [384, 432, 448],
    [464, 480, 416],
    [464, 496, 448],
])
_KINDS = np.array([512, 528, 544, 560])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(576), 576)
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
            v1 = T14 * T14 + T24 * T24
            Y2_2 = T34 - d1
            v2 = v1 + Y2_2 * Y2_2
            q3_pp = math.sqrt(v2)
            work[272 + k] = v1
            work[288 + k] = v2
            work[304 + k] = q3_pp
            work[320 + k] = T24
            work[336 + k] = -math.sqrt(v1)
            work[352 + k] = T14
            work[368 + k] = Y2_2
        for k in range(320, 352):
            work[k] = _atan2(work[k], work[k + 32])
        for k in range(0, 16):
            T24 = work[112 + k]
            v1 = work[272 + k]
            v2 = work[288 + k]
            q3_pp = work[304 + k]
            angle1 = work[320 + k]
            angle2 = work[336 + k]
            q1_mp = angle1 - math.copysign(half_turn, T24)
            q2_pm = angle2 - math.copysign(half_turn, -math.sqrt(v1))
            _384 = angle1
            work[384 + k] = _384
            _400 = angle2
            work[400 + k] = _400
            _416 = q3_pp
            work[416 + k] = _416
            _432 = q2_pm
            work[432 + k] = _432
            _448 = -q3_pp
            work[448 + k] = _448
            _464 = q1_mp
            work[464 + k] = _464
            _480 = -angle2
            work[480 + k] = _480
            _496 = -q2_pm
            work[496 + k] = _496
            work[512 + k] = UNREACHABLE if _384 != _384 else OK
            work[528 + k] = UNREACHABLE if _384 != _384 else OK
            work[544 + k] = UNREACHABLE if _464 != _464 else OK
            work[560 + k] = UNREACHABLE if _464 != _464 else OK
            work[256 + k] = 1.0 if v1 <= m1 or v2 <= m1 else work[256 + k]
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
