"""scara_wrist: SCARA arm with a spherical wrist.

Inverse kinematics, generated from robots/scara_wrist.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/scara_wrist.yaml. The formulas and where they come from:
scara_wrist.md.

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

NAME = "scara_wrist"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRPRRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "right-noflip",
    "right-flip",
    "left-noflip",
    "left-flip",
)
MAX_SOLUTIONS = 4

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.5  # joint offset 1 [m]
a1 = 0.4  # link length 1 [m]
a2 = 0.3  # link length 2 [m]
d6 = 0.1  # joint offset 6 [m]
longest2 = 0.48999999999999994  # square of the longest reach [m^2]
shortest2 = 0.010000000000000007  # square of the shortest reach [m^2]
longest2_reach = 0.49000000000018196  # the longest, with what rounding adds [m^2]
shortest2_reach = 0.009999999999974009  # the shortest, with what rounding adds [m^2]
longest2_apart = 0.48999999999998173  # the longest, where branches merge [m^2]
shortest2_apart = 0.010000000000002607  # the shortest, where branches merge [m^2]
free_limit_squared2 = 1.69e-24  # square of a length that fixes no angle [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.25  # a1^2 + a2^2 [m^2]
k2 = 4.166666666666667  # 1 / (2 * a2 * a1) [m^-2]
m1 = 8.7396756498489e-12  # 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4]
m2 = 1.25  # a coefficient of S1
m3 = 0.08750000000000001  # a coefficient of S1
m4 = 9.999999999999999e-09  # doubt_limit^2

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 1.3e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 0.5917159763313609, 1.0, 1.0, 1.0])
_JOINTS = np.column_stack([_LOWEST, _HIGHEST, [kind == "R" for kind in JOINT_TYPES], _WEIGHT])


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
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
    x4_x = x2_x * c4 + v1
    v2 = x2_y * c4
    x4_y = v2 + -x2_x * s4
    y5_x = v2 - x2_x * s4
    y5_y = -x2_x * c4 - v1
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5
    x5_y = x4_y * c5
    v3 = x4_x * s5
    v4 = x4_y * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 + y5_x * s6
    T[0, 1] = y5_x * c6 - x5_x * s6
    T[0, 2] = -v3
    T[0, 3] = c1 * a1 + x2_x * a2 - v3 * d6
    T[1, 0] = x5_y * c6 + y5_y * s6
    T[1, 1] = y5_y * c6 - x5_y * s6
    T[1, 2] = -v4
    T[1, 3] = s1 * a1 + x2_y * a2 - v4 * d6
    T[2, 0] = -(s5 * c6)
    T[2, 1] = s5 * s6
    T[2, 2] = -c5
    T[2, 3] = d1 + q[2] - c5 * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    J = np.zeros((6, 6))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    p1_x = c1 * a1
    p1_y = s1 * a1
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * c2 - s1 * s2
    x2_y = s1 * c2 + c1 * s2
    p2_x = p1_x + x2_x * a2
    p2_y = p1_y + x2_y * a2
    p3_z = d1 + q[2]
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    v1 = x2_y * s4
    v2 = x2_y * c4
    z4_x = x2_x * s4 - v2
    z4_y = v1 - -x2_x * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v3 = (x2_x * c4 + v1) * s5
    v4 = (v2 + -x2_x * s4) * s5
    p6_x = p2_x - v3 * d6
    p6_y = p2_y - v4 * d6
    v5 = p6_x - p2_x
    J14 = p6_y - p2_y
    v6 = p3_z - c5 * d6 - p3_z
    J[0, 0] = -p6_y
    J[0, 1] = p1_y - p6_y
    J[0, 3] = J14
    J[0, 4] = z4_y * v6
    J[0, 5] = c5 * J14 - v4 * v6
    J[1, 0] = p6_x
    J[1, 1] = p6_x - p1_x
    J[1, 3] = -v5
    J[1, 4] = -(z4_x * v6)
    J[1, 5] = v3 * v6 - c5 * v5
    J[2, 2] = 1.0
    J[2, 4] = z4_x * J14 - z4_y * v5
    J[2, 5] = v4 * v5 - v3 * J14
    J[3, 4] = z4_x
    J[3, 5] = -v3
    J[4, 4] = z4_y
    J[4, 5] = -v4
    J[5, 0] = 1.0
    J[5, 1] = 1.0
    J[5, 3] = -1.0
    J[5, 5] = -c5
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, _, _, T33, T34 = pose

    # r3, type 1: U0 A6^-1 [3, 4]
    wz = T34 - T33 * d6
    r3 = wz - d1

    # theta2, type 8: U0 A6^-1 [1, 4] and U0 A6^-1 [2, 4]
    wx = T14 - d6 * T13
    wy = T24 - d6 * T23
    N2 = wx * wx + wy * wy
    K2 = N2 - k1
    D2 = (longest2 - N2) * (N2 - shortest2)
    apart2 = shortest2_apart < N2 and N2 < longest2_apart
    if not (shortest2_reach <= N2 and N2 <= longest2_reach):
        return  # out of reach
    w2 = math.sqrt(D2 if apart2 else 0.0)
    c2 = K2 * k2

    # theta1, type 3: U0 A6^-1 [2, 4] and U0 A6^-1 [1, 4]
    X1_1 = a1 + a2 * c2
    v1 = wy * X1_1
    v2 = wx * X1_1

    # theta12m4, type 2: U4[3, 3]
    w12m4 = math.sqrt(T13 * T13 + T23 * T23)
    free12m4 = w12m4 <= free_limit
    divisor12m4 = 1.0 if free12m4 else w12m4

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta2
        if e1 < 0.0 and not apart2:
            continue  # both signs give the same
        s2 = w2 * e1 * k2
        q2 = _atan2(s2, c2)

        # theta1
        Y1_1 = a2 * s2
        S1 = v1 - wx * Y1_1
        C1 = v2 + wy * Y1_1
        w1 = math.sqrt(S1 * S1 + C1 * C1)
        free1 = w1 <= free_limit_squared2
        factor1 = 1.0 / (1.0 if free1 else w1)
        c1 = math.cos(seed[0]) if free1 else C1 * factor1
        s1 = math.sin(seed[0]) if free1 else S1 * factor1
        q1 = _atan2(s1, c1)

        # theta12m4
        v3 = q2 + q1
        v4 = v3 - seed[3]

        for i2 in range(2):  # noflip, flip
            e2 = 1.0 - 2.0 * i2
            # theta12m4
            if e2 < 0.0 and free12m4:
                continue  # both signs give the same
            factor12m4 = e2 / divisor12m4
            c12m4 = math.cos(v4) if free12m4 else -(T13 * factor12m4)
            s12m4 = math.sin(v4) if free12m4 else -(T23 * factor12m4)
            s5 = w12m4 * e2

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            q5 = _atan2(s5, -T33)

            # theta6, type 3: U4[3, 2] and U4[3, 1]
            c6 = T12 * s12m4 - T22 * c12m4
            s6 = T11 * s12m4 - T21 * c12m4
            q6 = _atan2(s6, c6)

            # joint values
            q4 = _wrap(v3 - _atan2(s12m4, c12m4))
            row = 2 * i1 + i2
            q[row, 0] = q1
            q[row, 1] = q2
            q[row, 2] = r3
            q[row, 3] = q4
            q[row, 4] = q5
            q[row, 5] = q6
            status[row] = FREE_JOINT if free1 or free12m4 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px * px * px) and math.isfinite(py * py * py) and math.isfinite(pz * pz * pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 1.3, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.7692, 0.7692, 0.7692, 1.0, 1.0, 1.0])


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

    # theta2, type 8: U0 A6^-1 [1, 4] and U0 A6^-1 [2, 4]
    wx = T14 - d6 * T13
    wy = T24 - d6 * T23
    N2 = wx * wx + wy * wy
    D2 = (longest2 - N2) * (N2 - shortest2)
    w2 = math.sqrt(D2)
    v1 = w2 - w2

    # theta1, type 3: U0 A6^-1 [2, 4] and U0 A6^-1 [1, 4]
    v2 = m3 + m2 * N2
    v3 = wy * v2
    v4 = wx * v2

    # theta12m4, type 2: U4[3, 3]
    v5 = T13 * T13 + T23 * T23

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    s6 = T13 * T21 - T23 * T11

    # joint values
    q3_pp = v1 + (T34 - d6 * T33 - d1)

    # a joint is free, or branches meet
    if abs(D2) <= m1 or v5 <= m4:
        return False

    # angles, side by side
    room[0] = w2
    room[1] = v3 - w2 * (m2 * wx)
    room[2] = v3 - w2 * (m2 * -wx)
    room[3] = math.sqrt(v5)
    room[4] = s6
    room[5] = -T23
    room[8] = N2 - k1
    room[9] = v4 + w2 * (m2 * wy)
    room[10] = v4 + w2 * (m2 * -wy)
    room[11] = -T33
    room[12] = T13 * T22 - T23 * T12
    room[13] = -T13
    for k in range(6, 8):
        room[k] = room[k + 8] = 1.0
    for k in range(8):
        room[k] = _atan2(room[k], room[k + 8])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]
    angle4 = room[3]
    angle5 = room[4]
    angle6 = room[5]

    # theta12m4, type 2: U4[3, 3]
    v6 = angle1 + angle2
    v7 = angle3 - angle1

    # joint values
    v8 = angle6 - math.copysign(half_turn, -T23)
    v9 = v6 - angle6
    v10 = v6 - v8
    v11 = v7 - angle6
    v12 = v7 - v8
    q4_pp = v9 + (turn if v9 <= -half_turn else (-turn if half_turn < v9 else 0.0))
    q4_pm = v10 + (turn if v10 <= -half_turn else (-turn if half_turn < v10 else 0.0))
    q4_mp = v11 + (turn if v11 <= -half_turn else (-turn if half_turn < v11 else 0.0))
    q4_mm = v12 + (turn if v12 <= -half_turn else (-turn if half_turn < v12 else 0.0))
    q5_pp = v1 + angle4
    q5_pm = v1 - angle4
    q6_pp = v1 + angle5
    q6_pm = v1 + (angle5 - math.copysign(half_turn, s6))

    q[0, 0] = angle2
    q[0, 1] = angle1
    q[0, 2] = q3_pp
    q[0, 3] = q4_pp
    q[0, 4] = q5_pp
    q[0, 5] = q6_pp
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = angle2
    q[1, 1] = angle1
    q[1, 2] = q3_pp
    q[1, 3] = q4_pm
    q[1, 4] = q5_pm
    q[1, 5] = q6_pm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = angle3
    q[2, 1] = -angle1
    q[2, 2] = q3_pp
    q[2, 3] = q4_mp
    q[2, 4] = q5_pp
    q[2, 5] = q6_pp
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = angle3
    q[3, 1] = -angle1
    q[3, 2] = q3_pp
    q[3, 3] = q4_mm
    q[3, 4] = q5_pm
    q[3, 5] = q6_pm
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
    [544, 560, 576, 592, 608, 624],
    [544, 560, 576, 640, 656, 672],
    [688, 704, 576, 720, 608, 624],
    [688, 704, 576, 736, 656, 672],
])
_KINDS = np.array([752, 768, 784, 800])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(816), 816)
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
            wx = T14 - d6 * T13
            wy = T24 - d6 * T23
            N2 = wx * wx + wy * wy
            D2 = (longest2 - N2) * (N2 - shortest2)
            w2 = math.sqrt(D2)
            v1 = w2 - w2
            v2 = m3 + m2 * N2
            v3 = wy * v2
            v4 = wx * v2
            v5 = T13 * T13 + T23 * T23
            s6 = T13 * T21 - T23 * T11
            q3_pp = v1 + (T34 - d6 * T33 - d1)
            work[272 + k] = D2
            work[288 + k] = v1
            work[304 + k] = v5
            work[320 + k] = s6
            work[336 + k] = q3_pp
            work[352 + k] = w2
            work[368 + k] = v3 - w2 * (m2 * wx)
            work[384 + k] = v3 - w2 * (m2 * -wx)
            work[400 + k] = math.sqrt(v5)
            work[416 + k] = s6
            work[432 + k] = -T23
            work[448 + k] = N2 - k1
            work[464 + k] = v4 + w2 * (m2 * wy)
            work[480 + k] = v4 + w2 * (m2 * -wy)
            work[496 + k] = -T33
            work[512 + k] = T13 * T22 - T23 * T12
            work[528 + k] = -T13
        for k in range(352, 448):
            work[k] = _atan2(work[k], work[k + 96])
        for k in range(0, 16):
            T23 = work[96 + k]
            D2 = work[272 + k]
            v1 = work[288 + k]
            v5 = work[304 + k]
            s6 = work[320 + k]
            q3_pp = work[336 + k]
            angle1 = work[352 + k]
            angle2 = work[368 + k]
            angle3 = work[384 + k]
            angle4 = work[400 + k]
            angle5 = work[416 + k]
            angle6 = work[432 + k]
            v6 = angle1 + angle2
            v7 = angle3 - angle1
            v8 = angle6 - math.copysign(half_turn, -T23)
            v9 = v6 - angle6
            v10 = v6 - v8
            v11 = v7 - angle6
            v12 = v7 - v8
            q4_pp = v9 + (turn if v9 <= -half_turn else (-turn if half_turn < v9 else 0.0))
            q4_pm = v10 + (turn if v10 <= -half_turn else (-turn if half_turn < v10 else 0.0))
            q4_mp = v11 + (turn if v11 <= -half_turn else (-turn if half_turn < v11 else 0.0))
            q4_mm = v12 + (turn if v12 <= -half_turn else (-turn if half_turn < v12 else 0.0))
            q5_pp = v1 + angle4
            q5_pm = v1 - angle4
            q6_pp = v1 + angle5
            q6_pm = v1 + (angle5 - math.copysign(half_turn, s6))
            _544 = angle2
            work[544 + k] = _544
            _560 = angle1
            work[560 + k] = _560
            _576 = q3_pp
            work[576 + k] = _576
            _592 = q4_pp
            work[592 + k] = _592
            _608 = q5_pp
            work[608 + k] = _608
            _624 = q6_pp
            work[624 + k] = _624
            _640 = q4_pm
            work[640 + k] = _640
            _656 = q5_pm
            work[656 + k] = _656
            _672 = q6_pm
            work[672 + k] = _672
            _688 = angle3
            work[688 + k] = _688
            _704 = -angle1
            work[704 + k] = _704
            _720 = q4_mp
            work[720 + k] = _720
            _736 = q4_mm
            work[736 + k] = _736
            work[752 + k] = UNREACHABLE if _544 != _544 else OK
            work[768 + k] = UNREACHABLE if _544 != _544 else OK
            work[784 + k] = UNREACHABLE if _688 != _688 else OK
            work[800 + k] = UNREACHABLE if _688 != _688 else OK
            work[256 + k] = 1.0 if abs(D2) <= m1 or v5 <= m4 else work[256 + k]
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
