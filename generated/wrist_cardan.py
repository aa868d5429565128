"""wrist_cardan: Spherical wrist, cardan axes.

Inverse kinematics, generated from robots/wrist_cardan.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/wrist_cardan.yaml. The formulas and where they come from:
wrist_cardan.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
orientation T[0:3, 0:3] counts; other entries are ignored.
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
_read_rows = _runtime("pose").read_orientation
_of_joints = _runtime("entry").of_joints(_HOW, 3)

NAME = "wrist_cardan"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "noflip",
    "flip",
)
MAX_SOLUTIONS = 2

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

free_limit = 1e-12  # a length that fixes no angle
m1 = 9.999999999999999e-09  # doubt_limit^2

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0])
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
    y2_z = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    T[0, 0] = c1 * c2
    T[0, 1] = s1 * s3 - v1 * c3
    T[0, 2] = s1 * c3 + v1 * s3
    T[1, 0] = s2
    T[1, 1] = c2 * c3
    T[1, 2] = -(c2 * s3)
    T[2, 0] = -(s1 * c2)
    T[2, 1] = y2_z * c3 + c1 * s3
    T[2, 2] = c1 * c3 - y2_z * s3
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
    J[3, 1] = s1
    J[3, 2] = c1 * c2
    J[4, 0] = 1.0
    J[4, 2] = s2
    J[5, 1] = c1
    J[5, 2] = -(s1 * c2)
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, _, T21, _, _, _, T31, T32, T33, _ = pose

    # theta1, type 2: U1[1, 3]
    w1 = math.sqrt(T11 * T11 + T31 * T31)
    free1 = w1 <= free_limit
    divisor1 = 1.0 if free1 else w1

    for i1 in range(2):  # noflip, flip
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else T11 * factor1
        s1 = math.sin(seed[0]) if free1 else -(T31 * factor1)
        q1 = _atan2(s1, c1)
        c2 = w1 * e1

        # theta2, type 3: U1[3, 3] and U1[2, 3]
        q2 = _atan2(T21, c2)

        # theta3, type 3: U1[1, 2] and U1[1, 1]
        s3 = T32 * c1 + T12 * s1
        c3 = T33 * c1 + T13 * s1
        q3 = _atan2(s3, c3)
        row = i1
        q[row, 0] = q1
        q[row, 1] = q2
        q[row, 2] = q3
        status[row] = FREE_JOINT if free1 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and True, pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.0, 0.0, 0.0, 1.0, 1.0, 1.0])


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
        for i in range(3):
            q[place, i] = x[i]


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(2):
        status[row] = UNREACHABLE
        for i in range(3):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    _stay(pose, seed, q, status)
    count = 0
    for row in range(2):
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
    T11, T12, T13, _, T21, _, _, _, T31, T32, T33, _ = pose
    room = carray(_room(16), 16)

    # theta1, type 2: U1[1, 3]
    v1 = T11 * T11 + T31 * T31

    # theta3, type 3: U1[1, 2] and U1[1, 1]
    s3 = T11 * T32 - T31 * T12

    # a joint is free, or branches meet
    if v1 <= m1:
        return False

    # angles, side by side
    room[0] = -T31
    room[1] = T21
    room[2] = s3
    room[8] = T11
    room[9] = math.sqrt(v1)
    room[10] = T11 * T33 - T31 * T13
    for k in range(3, 8):
        room[k] = room[k + 8] = 1.0
    for k in range(8):
        room[k] = _atan2(room[k], room[k + 8])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]

    # theta1, type 2: U1[1, 3]
    q1_m = angle1 - math.copysign(half_turn, -T31)

    # theta2, type 3: U1[3, 3] and U1[2, 3]
    q2_m = math.copysign(half_turn, T21) - angle2

    # theta3, type 3: U1[1, 2] and U1[1, 1]
    q3_m = angle3 - math.copysign(half_turn, s3)

    q[0, 0] = angle1
    q[0, 1] = angle2
    q[0, 2] = angle3
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_m
    q[1, 1] = q2_m
    q[1, 2] = q3_m
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    return True


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (2, 3) or status.shape != (2,):
        raise ValueError("T, q and status must have shapes (4, 4), (2, 3), (2,)")
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
    [400, 416, 432],
    [448, 464, 480],
])
_KINDS = np.array([496, 512])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(528), 528)
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
            miss = xx * xx + yy * yy + 2.0 * xy * xy + u * u + v * v + w * w
            exact = miss <= 1e-24
            work[256 + k] = 0.0 if exact else 1.0
        for k in range(0, 16):
            T11 = work[0 + k]
            T12 = work[16 + k]
            T13 = work[32 + k]
            T21 = work[64 + k]
            T31 = work[128 + k]
            T32 = work[144 + k]
            T33 = work[160 + k]
            v1 = T11 * T11 + T31 * T31
            s3 = T11 * T32 - T31 * T12
            work[272 + k] = v1
            work[288 + k] = s3
            work[304 + k] = -T31
            work[320 + k] = T21
            work[336 + k] = s3
            work[352 + k] = T11
            work[368 + k] = math.sqrt(v1)
            work[384 + k] = T11 * T33 - T31 * T13
        for k in range(304, 352):
            work[k] = _atan2(work[k], work[k + 48])
        for k in range(0, 16):
            T21 = work[64 + k]
            T31 = work[128 + k]
            v1 = work[272 + k]
            s3 = work[288 + k]
            angle1 = work[304 + k]
            angle2 = work[320 + k]
            angle3 = work[336 + k]
            q1_m = angle1 - math.copysign(half_turn, -T31)
            q2_m = math.copysign(half_turn, T21) - angle2
            q3_m = angle3 - math.copysign(half_turn, s3)
            _400 = angle1
            work[400 + k] = _400
            _416 = angle2
            work[416 + k] = _416
            _432 = angle3
            work[432 + k] = _432
            _448 = q1_m
            work[448 + k] = _448
            _464 = q2_m
            work[464 + k] = _464
            _480 = q3_m
            work[480 + k] = _480
            work[496 + k] = UNREACHABLE if _400 != _400 else OK
            work[512 + k] = UNREACHABLE if _448 != _448 else OK
            work[256 + k] = 1.0 if v1 <= m1 else work[256 + k]
        for k in range(first, first + count):
            if work[256 + k - first] != 0.0:
                _unseeded(T[k], q[k], status[k])
                continue
            for row in range(2):
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
            "no_pose": "not finite, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)",
            "no_row": "the pose is out of reach",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
