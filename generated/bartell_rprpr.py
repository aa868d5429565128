"""bartell_rprpr: Bartell RPRPR arm.

Inverse kinematics, generated from robots/bartell_rprpr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/bartell_rprpr.yaml. The formulas and where they come from:
bartell_rprpr.md.

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
_of_joints = _runtime("entry").of_joints(_HOW, 5)

NAME = "bartell_rprpr"
METHOD = "closed form"
DOF = 5
JOINT_TYPES = "RPRPR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "shoulder+",
    "shoulder-",
)
MAX_SOLUTIONS = 2

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 2.0  # joint offset 1 [m]
second_weight = 0.5  # lengths count in arm sizes [m^-1]
free_limit = 1e-12  # a length that fixes no angle
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 2e-05  # a pose may be rounded by this [m]
m1 = 9.999999999999999e-09  # doubt_limit^2
m3 = 4.0000000000000007e-10  # pose_slack1^2 [m^2]
m4 = 1.0000000000000002e-10  # pose_slack^2

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 2e-09, 1e-09, 2e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 0.25, 1.0, 0.25, 1.0])
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
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = c1 * c3
    x3_y = s1 * c3
    z4_x = c1 * s3
    z4_y = s1 * s3
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    T[0, 0] = x3_x * c5 + s1 * s5
    T[0, 1] = s1 * c5 - x3_x * s5
    T[0, 2] = z4_x
    T[0, 3] = s1 * q[1] + z4_x * q[3]
    T[1, 0] = x3_y * c5 - c1 * s5
    T[1, 1] = -(c1 * c5 + x3_y * s5)
    T[1, 2] = z4_y
    T[1, 3] = z4_y * q[3] - c1 * q[1]
    T[2, 0] = s3 * c5
    T[2, 1] = -(s3 * s5)
    T[2, 2] = -c3
    T[2, 3] = d1 - c3 * q[3]
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
    p2_x = s1 * q[1]
    v1 = c1 * q[1]
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    z4_x = c1 * s3
    z4_y = s1 * s3
    p4_x = p2_x + z4_x * q[3]
    p4_y = z4_y * q[3] - v1
    v2 = d1 - c3 * q[3] - d1
    J[0, 0] = -p4_y
    J[0, 1] = s1
    J[0, 2] = -(c1 * v2)
    J[0, 3] = z4_x
    J[1, 0] = p4_x
    J[1, 1] = -c1
    J[1, 2] = -(s1 * v2)
    J[1, 3] = z4_y
    J[2, 2] = s1 * (v1 + p4_y) + c1 * (p4_x - p2_x)
    J[2, 3] = -c3
    J[3, 2] = s1
    J[3, 4] = z4_x
    J[4, 2] = -c1
    J[4, 4] = z4_y
    J[5, 0] = 1.0
    J[5, 4] = -c3
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, _, T33, T34 = pose

    # theta1, type 2: U1[2, 3] and, where that is degenerate, U1[3] x U1[4], element 2
    v1 = T34 - d1
    X2_1 = T23 * v1 - T24 * T33
    Y2_1 = T13 * v1 - T33 * T14
    sigma1 = math.copysign(second_weight, T13 * X2_1 - T23 * Y2_1)
    Xhat1 = T13 + X2_1 * sigma1
    Yhat1 = Y2_1 * sigma1 - T23
    w1 = math.sqrt(Xhat1 * Xhat1 + Yhat1 * Yhat1)
    free1 = w1 <= free_limit
    divisor1 = 1.0 if free1 else w1

    # theta3, type 3: U1[3, 3] and U1[1, 3]
    v2 = T33 * T33

    for i1 in range(2):  # shoulder+, shoulder-
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(Xhat1 * factor1)
        s1 = math.sin(seed[0]) if free1 else Yhat1 * factor1
        q1 = _atan2(s1, c1)

        # r2, type 1: U1[2, 4]
        r2 = T14 * s1 - T24 * c1

        # theta3
        Z2_3 = T13 * c1 + T23 * s1
        w3 = math.sqrt(Z2_3 * Z2_3 + v2)
        short3 = w3 <= free_limit
        factor3 = 1.0 / (1.0 if short3 else w3)
        v3 = T33 * factor3
        s3 = Z2_3 * factor3
        q3 = _atan2(s3, -v3)

        # r4, type 1: U3[2, 4]
        r4 = s3 * (T14 * c1 + T24 * s1) - v3 * -v1

        # theta5, type 3: U1[2, 2] and U1[2, 1]
        Z1_5 = T22 * c1 - T12 * s1
        Z2_5 = T21 * c1 - T11 * s1
        w5 = math.sqrt(Z2_5 * Z2_5 + Z1_5 * Z1_5)
        short5 = w5 <= free_limit
        v4 = 1.0 / (1.0 if short5 else w5)
        v5 = Z1_5 * v4
        v6 = Z2_5 * v4
        q5 = _atan2(-v6, -v5)

        # is the pose one that the arm can take?
        v7 = c1 * s3
        v8 = s1 * s3
        if (
            not (abs(T34 - (d1 + v3 * r4)) <= pose_slack1 and abs(T33 - v3) <= pose_slack and
            abs(T31 + s3 * v5) <= pose_slack and abs(T24 - (r4 * v8 - c1 * r2)) <= pose_slack1 and
            abs(T23 - v8) <= pose_slack and abs(T21 - (v5 * (s1 * v3) + c1 * v6)) <= pose_slack and
            abs(T14 - (r4 * v7 + s1 * r2)) <= pose_slack1 and abs(T11 - (v5 * (c1 * v3) - s1 * v6))
            <= pose_slack and abs(T13 - v7) <= pose_slack)
        ):
            continue  # the arm can't take this pose
        row = i1
        q[row, 0] = q1
        q[row, 1] = r2
        q[row, 2] = q3
        q[row, 3] = r4
        q[row, 4] = q5
        status[row] = FREE_JOINT if free1 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px * px * px) and math.isfinite(py * py * py) and math.isfinite(pz * pz * pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 2.0, 1.0, 2.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.5, 0.5, 0.5, 1.0, 1.0, 1.0])


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
        for i in range(5):
            q[place, i] = x[i]


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(2):
        status[row] = UNREACHABLE
        for i in range(5):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    _stay(pose, seed, q, status)
    count = 0
    for row in range(2):
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
    room = carray(_room(16), 16)

    # theta1, type 2: U1[2, 3] and, where that is degenerate, U1[3] x U1[4], element 2
    v1 = T34 - d1
    X2_1 = v1 * T23 - T24 * T33
    Y2_1 = v1 * T13 - T33 * T14
    sigma1 = math.copysign(second_weight, X2_1 * T13 - T23 * Y2_1)
    Xhat1 = T13 + X2_1 * sigma1
    Yhat1 = Y2_1 * sigma1 - T23
    v2 = Xhat1 * Xhat1 + Yhat1 * Yhat1
    w1 = math.sqrt(v2)
    v3 = 1.0 / v2
    factor1 = w1 * v3
    v4 = Xhat1 * factor1
    s1 = Yhat1 * factor1

    # r2, type 1: U1[2, 4]
    q2_p = w1 * (v3 * (T24 * Xhat1 + T14 * Yhat1))

    # theta3, type 3: U1[3, 3] and U1[1, 3]
    Z2_3 = w1 * (v3 * (T23 * Yhat1 - T13 * Xhat1))
    v5 = T33 * T33 + Z2_3 * Z2_3
    w3 = math.sqrt(v5)
    v6 = 1.0 / v5
    factor3 = w3 * v6
    v7 = T33 * factor3
    s3 = Z2_3 * factor3

    # r4, type 1: U3[2, 4]
    q4_p = w3 * (v6 * ((T23 * s1 - T13 * v4) * (T24 * s1 - T14 * v4) - T33 * -v1))

    # theta5, type 3: U1[2, 2] and U1[2, 1]
    v8 = w1 * (v3 * (Xhat1 * T22 + Yhat1 * T12))
    v9 = w1 * (v3 * (Xhat1 * T21 + Yhat1 * T11))
    v10 = v9 * v9 + v8 * v8
    v11 = math.sqrt(v10) * (1.0 / v10)
    v12 = v8 * v11
    v13 = v9 * v11

    # is the pose one that the arm can take?
    v14 = v4 * s3
    v15 = s1 * s3
    v16 = T34 - (d1 + v7 * q4_p)
    v17 = T33 - v7
    v18 = T31 - s3 * v12
    v19 = T24 - (q4_p * v15 + v4 * q2_p)
    v20 = T23 - v15
    v21 = T21 - (v4 * v13 - v12 * (s1 * v7))
    v22 = T14 - (s1 * q2_p - q4_p * v14)
    v23 = T11 - (v12 * (v4 * v7) + s1 * v13)
    v24 = T13 + v14

    # a joint is free, or branches meet
    if (
        v5 <= m1 or v2 <= m1 or v10 <= m1 or m4 < v17 * v17 + v18 * v18 + v20 * v20 + v21 * v21 +
        v23 * v23 + v24 * v24 or m3 < v16 * v16 + v19 * v19 + v22 * v22
    ):
        return False

    # angles, side by side
    room[0] = Yhat1
    room[1] = Z2_3
    room[2] = v9
    room[8] = -Xhat1
    room[9] = -T33
    room[10] = v8
    for k in range(3, 8):
        room[k] = room[k + 8] = 1.0
    for k in range(8):
        room[k] = _atan2(room[k], room[k + 8])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]

    # theta1, type 2: U1[2, 3] and, where that is degenerate, U1[3] x U1[4], element 2
    q1_m = angle1 - math.copysign(half_turn, Yhat1)

    # theta5, type 3: U1[2, 2] and U1[2, 1]
    q5_m = angle3 - math.copysign(half_turn, v9)

    q[0, 0] = angle1
    q[0, 1] = q2_p
    q[0, 2] = angle2
    q[0, 3] = q4_p
    q[0, 4] = angle3
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_m
    q[1, 1] = -q2_p
    q[1, 2] = -angle2
    q[1, 3] = q4_p
    q[1, 4] = q5_m
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    return True


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (2, 5) or status.shape != (2,):
        raise ValueError("T, q and status must have shapes (4, 4), (2, 5), (2,)")
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
    [624, 640, 656, 672, 688],
    [704, 720, 736, 672, 752],
])
_KINDS = np.array([768, 784])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(800), 800)
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
            T31 = work[128 + k]
            T33 = work[160 + k]
            T34 = work[176 + k]
            v1 = T34 - d1
            X2_1 = v1 * T23 - T24 * T33
            Y2_1 = v1 * T13 - T33 * T14
            sigma1 = math.copysign(second_weight, X2_1 * T13 - T23 * Y2_1)
            Xhat1 = T13 + X2_1 * sigma1
            Yhat1 = Y2_1 * sigma1 - T23
            v2 = Xhat1 * Xhat1 + Yhat1 * Yhat1
            w1 = math.sqrt(v2)
            v3 = 1.0 / v2
            factor1 = w1 * v3
            v4 = Xhat1 * factor1
            s1 = Yhat1 * factor1
            q2_p = w1 * (v3 * (T24 * Xhat1 + T14 * Yhat1))
            Z2_3 = w1 * (v3 * (T23 * Yhat1 - T13 * Xhat1))
            v5 = T33 * T33 + Z2_3 * Z2_3
            w3 = math.sqrt(v5)
            v6 = 1.0 / v5
            factor3 = w3 * v6
            v7 = T33 * factor3
            s3 = Z2_3 * factor3
            q4_p = w3 * (v6 * ((T23 * s1 - T13 * v4) * (T24 * s1 - T14 * v4) - T33 * -v1))
            v8 = w1 * (v3 * (Xhat1 * T22 + Yhat1 * T12))
            v9 = w1 * (v3 * (Xhat1 * T21 + Yhat1 * T11))
            v10 = v9 * v9 + v8 * v8
            v11 = math.sqrt(v10) * (1.0 / v10)
            v12 = v8 * v11
            v13 = v9 * v11
            v14 = v4 * s3
            v15 = s1 * s3
            v16 = T34 - (d1 + v7 * q4_p)
            v17 = T33 - v7
            v18 = T31 - s3 * v12
            v19 = T24 - (q4_p * v15 + v4 * q2_p)
            v20 = T23 - v15
            v21 = T21 - (v4 * v13 - v12 * (s1 * v7))
            v22 = T14 - (s1 * q2_p - q4_p * v14)
            v23 = T11 - (v12 * (v4 * v7) + s1 * v13)
            v24 = T13 + v14
            work[272 + k] = Yhat1
            work[288 + k] = v2
            work[304 + k] = q2_p
            work[320 + k] = v5
            work[336 + k] = q4_p
            work[352 + k] = v9
            work[368 + k] = v10
            work[384 + k] = v16
            work[400 + k] = v17
            work[416 + k] = v18
            work[432 + k] = v19
            work[448 + k] = v20
            work[464 + k] = v21
            work[480 + k] = v22
            work[496 + k] = v23
            work[512 + k] = v24
            work[528 + k] = Yhat1
            work[544 + k] = Z2_3
            work[560 + k] = v9
            work[576 + k] = -Xhat1
            work[592 + k] = -T33
            work[608 + k] = v8
        for k in range(528, 576):
            work[k] = _atan2(work[k], work[k + 48])
        for k in range(0, 16):
            Yhat1 = work[272 + k]
            v2 = work[288 + k]
            q2_p = work[304 + k]
            v5 = work[320 + k]
            q4_p = work[336 + k]
            v9 = work[352 + k]
            v10 = work[368 + k]
            v16 = work[384 + k]
            v17 = work[400 + k]
            v18 = work[416 + k]
            v19 = work[432 + k]
            v20 = work[448 + k]
            v21 = work[464 + k]
            v22 = work[480 + k]
            v23 = work[496 + k]
            v24 = work[512 + k]
            angle1 = work[528 + k]
            angle2 = work[544 + k]
            angle3 = work[560 + k]
            q1_m = angle1 - math.copysign(half_turn, Yhat1)
            q5_m = angle3 - math.copysign(half_turn, v9)
            _624 = angle1
            work[624 + k] = _624
            _640 = q2_p
            work[640 + k] = _640
            _656 = angle2
            work[656 + k] = _656
            _672 = q4_p
            work[672 + k] = _672
            _688 = angle3
            work[688 + k] = _688
            _704 = q1_m
            work[704 + k] = _704
            _720 = -q2_p
            work[720 + k] = _720
            _736 = -angle2
            work[736 + k] = _736
            _752 = q5_m
            work[752 + k] = _752
            work[768 + k] = UNREACHABLE if _624 != _624 else OK
            work[784 + k] = UNREACHABLE if _704 != _704 else OK
            work[256 + k] = (
                1.0 if v5 <= m1 or v2 <= m1 or v10 <= m1 or m4 < v17 * v17 + v18 * v18 + v20 * v20 +
                v21 * v21 + v23 * v23 + v24 * v24 or m3 < v16 * v16 + v19 * v19 + v22 * v22 else
                work[256 + k]
            )
        for k in range(first, first + count):
            if work[256 + k - first] != 0.0:
                _unseeded(T[k], q[k], status[k])
                continue
            for row in range(2):
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
            "no_pose": "not finite or beyond 5e102, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)",
            "no_row": "the pose is out of reach, or one that 5 joints can't take",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
