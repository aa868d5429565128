"""gantry_wrist: Gantry with a spherical wrist.

Inverse kinematics, generated from robots/gantry_wrist.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/gantry_wrist.yaml. The formulas and where they come from:
gantry_wrist.md.

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
_read_rows = _runtime("pose").read_pose
_of_joints = _runtime("entry").of_joints(_HOW, 6)

NAME = "gantry_wrist"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "PPPRRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
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

d4 = 0.1  # joint offset 4 [m]
d6 = 0.12  # joint offset 6 [m]
free_limit = 1e-12  # a length that fixes no angle
m1 = 9.999999999999999e-09  # doubt_limit^2

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([2.2e-10, 2.2e-10, 2.2e-10, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([20.66115702479339, 20.66115702479339, 20.66115702479339, 1.0, 1.0, 1.0])
_JOINTS = np.column_stack([_LOWEST, _HIGHEST, [kind == "R" for kind in JOINT_TYPES], _WEIGHT])


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    T = np.zeros((4, 4))
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v1 = s4 * c5
    x5_z = c4 * c5
    v2 = s4 * s5
    z5_z = c4 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = -(s5 * c6)
    T[0, 1] = s5 * s6
    T[0, 2] = c5
    T[0, 3] = q[2] + d4 + c5 * d6
    T[1, 0] = -(v1 * c6 + c4 * s6)
    T[1, 1] = v1 * s6 - c4 * c6
    T[1, 2] = -v2
    T[1, 3] = q[1] - v2 * d6
    T[2, 0] = x5_z * c6 - s4 * s6
    T[2, 1] = -(s4 * c6 + x5_z * s6)
    T[2, 2] = z5_z
    T[2, 3] = q[0] + z5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    J = np.zeros((6, 6))
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    p4_x = q[2] + d4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v1 = s4 * s5
    z5_z = c4 * s5
    J34 = q[1] - v1 * d6 - q[1]
    v2 = q[0] + z5_z * d6 - q[0]
    v3 = p4_x + c5 * d6 - p4_x
    J[0, 2] = 1.0
    J[0, 4] = s4 * J34 - c4 * v2
    J[0, 5] = -(v1 * v2 + z5_z * J34)
    J[1, 1] = 1.0
    J[1, 3] = -v2
    J[1, 4] = -(s4 * v3)
    J[1, 5] = z5_z * v3 - c5 * v2
    J[2, 0] = 1.0
    J[2, 3] = J34
    J[2, 4] = c4 * v3
    J[2, 5] = c5 * J34 + v1 * v3
    J[3, 3] = 1.0
    J[3, 5] = c5
    J[4, 4] = -c4
    J[4, 5] = -v1
    J[5, 4] = -s4
    J[5, 5] = z5_z
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # r2, type 1: U0 A6^-1 [2, 4]
    wy = T24 - T23 * d6

    # r1, type 1: U0 A6^-1 [3, 4]
    wz = T34 - d6 * T33

    # r3, type 1: U0 A6^-1 [1, 4]
    wx = T14 - d6 * T13
    r3 = wx - d4

    # theta4, type 2: U4[3, 3]
    w4 = math.sqrt(T33 * T33 + T23 * T23)
    free4 = w4 <= free_limit
    divisor4 = 1.0 if free4 else w4

    for i1 in range(2):  # noflip, flip
        e1 = 1.0 - 2.0 * i1
        # theta4
        if e1 < 0.0 and free4:
            continue  # both signs give the same
        factor4 = e1 / divisor4
        c4 = math.cos(seed[3]) if free4 else -(T33 * factor4)
        s4 = math.sin(seed[3]) if free4 else T23 * factor4
        q4 = _atan2(s4, c4)

        # theta5, type 3: U4[2, 3] and U4[1, 3]
        q5 = _atan2(-(w4 * e1), T13)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6 = _atan2(-(T21 * c4 + T31 * s4), -(T22 * c4 + T32 * s4))
        row = i1
        q[row, 0] = wz
        q[row, 1] = wy
        q[row, 2] = r3
        q[row, 3] = q4
        q[row, 4] = q5
        q[row, 5] = q6
        status[row] = FREE_JOINT if free4 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px * px * px) and math.isfinite(py * py * py) and math.isfinite(pz * pz * pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([0.22, 0.22, 0.22, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([4.545, 4.545, 4.545, 1.0, 1.0, 1.0])


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
        for i in range(6):
            q[place, i] = x[i]


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(2):
        status[row] = UNREACHABLE
        for i in range(6):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    _stay(pose, seed, q, status)
    count = 0
    for row in range(2):
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
    _, _, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose
    room = carray(_room(16), 16)

    # r2, type 1: U0 A6^-1 [2, 4]
    q2_p = T24 - d6 * T23

    # r1, type 1: U0 A6^-1 [3, 4]
    q1_p = T34 - d6 * T33

    # r3, type 1: U0 A6^-1 [1, 4]
    q3_p = T14 - d6 * T13 - d4

    # theta4, type 2: U4[3, 3]
    v1 = T33 * T33 + T23 * T23

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v2 = T33 * T21 - T23 * T31

    # a joint is free, or branches meet
    if v1 <= m1:
        return False

    # angles, side by side
    room[0] = T23
    room[1] = -math.sqrt(v1)
    room[2] = v2
    room[8] = -T33
    room[9] = T13
    room[10] = T33 * T22 - T23 * T32
    for k in range(3, 8):
        room[k] = room[k + 8] = 1.0
    for k in range(8):
        room[k] = _atan2(room[k], room[k + 8])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]

    # theta4, type 2: U4[3, 3]
    q4_m = angle1 - math.copysign(half_turn, T23)

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    q6_m = angle3 - math.copysign(half_turn, v2)

    q[0, 0] = q1_p
    q[0, 1] = q2_p
    q[0, 2] = q3_p
    q[0, 3] = angle1
    q[0, 4] = angle2
    q[0, 5] = angle3
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_p
    q[1, 1] = q2_p
    q[1, 2] = q3_p
    q[1, 3] = q4_m
    q[1, 4] = -angle2
    q[1, 5] = q6_m
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    return True


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (2, 6) or status.shape != (2,):
        raise ValueError("T, q and status must have shapes (4, 4), (2, 6), (2,)")
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
    [448, 464, 480, 496, 512, 528],
    [448, 464, 480, 544, 560, 576],
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
            T13 = work[32 + k]
            T14 = work[48 + k]
            T21 = work[64 + k]
            T22 = work[80 + k]
            T23 = work[96 + k]
            T24 = work[112 + k]
            T31 = work[128 + k]
            T32 = work[144 + k]
            T33 = work[160 + k]
            T34 = work[176 + k]
            q2_p = T24 - d6 * T23
            q1_p = T34 - d6 * T33
            q3_p = T14 - d6 * T13 - d4
            v1 = T33 * T33 + T23 * T23
            v2 = T33 * T21 - T23 * T31
            work[272 + k] = q2_p
            work[288 + k] = q1_p
            work[304 + k] = q3_p
            work[320 + k] = v1
            work[336 + k] = v2
            work[352 + k] = T23
            work[368 + k] = -math.sqrt(v1)
            work[384 + k] = v2
            work[400 + k] = -T33
            work[416 + k] = T13
            work[432 + k] = T33 * T22 - T23 * T32
        for k in range(352, 400):
            work[k] = _atan2(work[k], work[k + 48])
        for k in range(0, 16):
            T23 = work[96 + k]
            q2_p = work[272 + k]
            q1_p = work[288 + k]
            q3_p = work[304 + k]
            v1 = work[320 + k]
            v2 = work[336 + k]
            angle1 = work[352 + k]
            angle2 = work[368 + k]
            angle3 = work[384 + k]
            q4_m = angle1 - math.copysign(half_turn, T23)
            q6_m = angle3 - math.copysign(half_turn, v2)
            _448 = q1_p
            work[448 + k] = _448
            _464 = q2_p
            work[464 + k] = _464
            _480 = q3_p
            work[480 + k] = _480
            _496 = angle1
            work[496 + k] = _496
            _512 = angle2
            work[512 + k] = _512
            _528 = angle3
            work[528 + k] = _528
            _544 = q4_m
            work[544 + k] = _544
            _560 = -angle2
            work[560 + k] = _560
            _576 = q6_m
            work[576 + k] = _576
            work[592 + k] = UNREACHABLE if _448 != _448 else OK
            work[608 + k] = UNREACHABLE if _448 != _448 else OK
            work[256 + k] = 1.0 if v1 <= m1 else work[256 + k]
        for k in range(first, first + count):
            if work[256 + k - first] != 0.0:
                _unseeded(T[k], q[k], status[k])
                continue
            for row in range(2):
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
