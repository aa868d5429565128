"""staubli_rx90: Stäubli RX90.

Inverse kinematics, generated from robots/staubli_rx90.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/staubli_rx90.yaml. The formulas and where they come from:
staubli_rx90.md.

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

NAME = "staubli_rx90"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "back-up-noflip",
    "back-up-flip",
    "back-down-noflip",
    "back-down-flip",
    "front-down-noflip",
    "front-down-flip",
    "front-up-noflip",
    "front-up-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

a2 = 0.45  # link length 3 [m]
d4 = 0.45  # joint offset 4 [m]
free_limit1 = 9e-13  # a length that fixes no angle [m]
longest3 = 0.81  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
longest3_reach = 0.8100000000001621  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.8099999999999838  # the longest, where branches merge [m^2]
shortest3_apart = 8.099999999999999e-29  # the shortest, where branches merge [m^2]
free_limit_squared2 = 8.1e-25  # square of a length that fixes no angle [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.405  # 2 * d4 * a2 [m^2]
k2 = 6.096631611034903  # 1 / (k1^2) [m^-4]
m1 = 8.100000000000001e-09  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 1.312949748921684e-11
m4 = 1.1111111111111112  # a coefficient of S2
m5 = 6.561e-17  # doubt_limit_squared2^2 [m^4]
m6 = 9.999999999999999e-09  # doubt_limit^2

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])
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
    x2_x = c1 * c2
    x2_y = s1 * c2
    v1 = c1 * s2
    v2 = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v1 * s3
    x3_y = x2_y * c3 - v2 * s3
    x3_z = s2 * c3 + c2 * s3
    v3 = v1 * c3 + x2_x * s3
    v4 = v2 * c3 + x2_y * s3
    y3_z = c2 * c3 - s2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - s1 * s4
    x4_y = x3_y * c4 + c1 * s4
    x4_z = x3_z * c4
    z5_x = s1 * c4 + x3_x * s4
    y4_y = c1 * c4 - x3_y * s4
    z5_z = x3_z * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 - v3 * s5
    x5_y = x4_y * c5 - v4 * s5
    x5_z = x4_z * c5 + y3_z * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 - z5_x * s6
    T[0, 1] = -(z5_x * c6 + x5_x * s6)
    T[0, 2] = -(v3 * c5 + x4_x * s5)
    T[0, 3] = x2_x * a2 - v3 * d4
    T[1, 0] = x5_y * c6 + y4_y * s6
    T[1, 1] = y4_y * c6 - x5_y * s6
    T[1, 2] = -(v4 * c5 + x4_y * s5)
    T[1, 3] = x2_y * a2 - v4 * d4
    T[2, 0] = x5_z * c6 - z5_z * s6
    T[2, 1] = -(z5_z * c6 + x5_z * s6)
    T[2, 2] = y3_z * c5 - x4_z * s5
    T[2, 3] = s2 * a2 + y3_z * d4
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
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * c2
    x2_y = s1 * c2
    v1 = c1 * s2
    v2 = s1 * s2
    p3_x = x2_x * a2
    p3_y = x2_y * a2
    p3_z = s2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v1 * s3
    x3_y = x2_y * c3 - v2 * s3
    x3_z = s2 * c3 + c2 * s3
    v3 = v1 * c3 + x2_x * s3
    v4 = v2 * c3 + x2_y * s3
    y3_z = c2 * c3 - s2 * s3
    p4_x = p3_x - v3 * d4
    p4_y = p3_y - v4 * d4
    p4_z = p3_z + y3_z * d4
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v5 = p4_z - p3_z
    J[0, 0] = -p4_y
    J[0, 1] = -(c1 * p4_z)
    J[0, 2] = -(c1 * v5)
    J[1, 0] = p4_x
    J[1, 1] = -(s1 * p4_z)
    J[1, 2] = -(s1 * v5)
    J[2, 1] = s1 * p4_y + c1 * p4_x
    J[2, 2] = s1 * (p4_y - p3_y) + c1 * (p4_x - p3_x)
    J[3, 1] = s1
    J[3, 2] = s1
    J[3, 3] = -v3
    J[3, 4] = s1 * c4 + x3_x * s4
    J[3, 5] = -(v3 * c5 + (x3_x * c4 - s1 * s4) * s5)
    J[4, 1] = -c1
    J[4, 2] = -c1
    J[4, 3] = -v4
    J[4, 4] = x3_y * s4 - c1 * c4
    J[4, 5] = -(v4 * c5 + (x3_y * c4 + c1 * s4) * s5)
    J[5, 0] = 1.0
    J[5, 3] = y3_z
    J[5, 4] = x3_z * s4
    J[5, 5] = y3_z * c5 - x3_z * c4 * s5
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[2, 4]
    w1 = math.sqrt(T14 * T14 + T24 * T24)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 8: U1[3, 4] and U1[1, 4]
    v1 = T34 * T34

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(T14 * factor1)
        s1 = math.sin(seed[0]) if free1 else -(T24 * factor1)
        q1 = _atan2(s1, c1)
        root1 = w1 * e1

        # theta3
        N3 = v1 + root1 * root1
        K3 = N3 - k1
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        v2 = k1 * K3 * k2

        # theta2, type 3: U1[3, 4] and U1[1, 4]
        X1_2 = a2 + d4 * v2
        v3 = T34 * X1_2
        v4 = root1 * X1_2

        # theta4, type 2: U4[2, 3]
        v5 = T13 * c1 + T23 * s1
        Y4 = T13 * s1 - T23 * c1
        v6 = Y4 * Y4

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        v7 = T12 * s1 - T22 * c1
        v8 = T12 * c1 + T22 * s1
        v10 = T11 * s1 - T21 * c1
        v11 = T11 * c1 + T21 * s1

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            c3 = k2 * (k1 * (w3 * e2))
            q3 = _atan2(-v2, c3)

            # theta2
            Y1_2 = d4 * c3
            S2 = v3 + root1 * Y1_2
            C2 = T34 * Y1_2 - v4
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else S2 * factor2
            q2 = _atan2(s2, c2)

            # theta4
            c23 = c3 * c2 + v2 * s2
            s23 = c3 * s2 - v2 * c2
            X4 = c23 * v5 + T33 * s23
            w4 = math.sqrt(X4 * X4 + v6)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[3, 3] and U4[1, 3]
            c5 = T33 * c23 - s23 * v5

            # theta6
            v9 = c23 * v8 + T32 * s23
            v12 = c23 * v11 + T31 * s23

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4
                if e3 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e3 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)
                s5 = w4 * e3

                # theta5
                q5 = _atan2(s5, c5)

                # theta6
                q6 = _atan2(-(c4 * v10 + s4 * v12), -(c4 * v7 + s4 * v9))
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0] = q1
                q[row, 1] = q2
                q[row, 2] = q3
                q[row, 3] = q4
                q[row, 4] = q5
                q[row, 5] = q6
                status[row] = FREE_JOINT if free1 or free2 or free4 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px) and math.isfinite(py) and math.isfinite(pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([1.111, 1.111, 1.111, 1.0, 1.0, 1.0])


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
    for row in range(8 - 1, -1, -1):
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
    for row in range(8):
        status[row] = UNREACHABLE
        for i in range(6):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    _stay(pose, seed, q, status)
    count = 0
    for row in range(8):
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
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose
    room = carray(_room(48), 48)

    # theta1, type 2: U1[2, 4]
    v1 = T14 * T14 + T24 * T24
    w1 = math.sqrt(v1)
    v2 = 1.0 / v1

    # theta3, type 8: U1[3, 4] and U1[1, 4]
    N3 = v1 + T34 * T34
    D3 = (longest3 - N3) * (N3 - shortest3)
    w3 = math.sqrt(D3)
    v3 = w3 - w3
    v4 = k1 * (N3 - k1)
    v5 = k2 * v4
    v6 = k1 * w3
    c3 = k2 * v6

    # theta2, type 3: U1[3, 4] and U1[1, 4]
    X1_2 = a2 + d4 * v5
    Y1_2 = d4 * c3
    v7 = T34 * X1_2
    v8 = w1 * Y1_2
    v9 = v7 + v8
    v10 = v7 - v8
    v11 = m4 * (T34 * N3)
    v12 = w3 * (m4 * w1)
    S2_pp = v11 + v12
    S2_pm = v11 - v12
    v13 = w1 * X1_2
    v14 = T34 * Y1_2
    v15 = v14 - v13
    v16 = v13 + v14
    v17 = w3 * (m4 * T34)
    v18 = m4 * (w1 * N3)
    C2_pp = v17 - v18
    C2_mp = v17 + v18
    v19 = S2_pp * S2_pp
    v20 = v19 + C2_pp * C2_pp
    v21 = S2_pm * S2_pm + C2_mp * C2_mp
    v22 = v19 + -C2_pp * -C2_pp
    w2_pp = math.sqrt(v20)
    w2_pm = math.sqrt(v21)
    w2_mm = math.sqrt(v22)
    v23 = 1.0 / v20
    v24 = 1.0 / v21
    v25 = 1.0 / v22

    # theta4, type 2: U4[2, 3]
    v26 = v5 * v9
    c23_pp = w2_pp * (v23 * (c3 * v15 + v26))
    c23_pm = w2_pm * (v24 * (c3 * v16 + v5 * v10))
    c23_mm = w2_mm * (v25 * (v26 - c3 * -v15))
    v27 = c3 * v9
    s23_pp = w2_pp * (v23 * (v27 - v5 * v15))
    v28 = v5 * v16 - c3 * v10
    s23_pm = w2_pm * (v24 * v28)
    s23_mp = w2_pm * (v24 * -v28)
    v29 = w2_mm * (v25 * (v27 + v5 * -v15))
    v30 = w1 * (v2 * (T14 * T13 + T24 * T23))
    X4_pp = s23_pp * T33 - c23_pp * v30
    v31 = c23_pm * v30
    X4_pm = s23_pm * T33 - v31
    X4_mp = v31 + s23_mp * T33
    X4_mm = c23_mm * v30 - v29 * T33
    Y4 = w1 * (v2 * (T14 * T23 - T24 * T13))
    v32 = Y4 * Y4
    v33 = v32 + X4_pp * X4_pp
    v34 = v32 + X4_pm * X4_pm
    v35 = v32 + X4_mp * X4_mp
    v36 = v32 + X4_mm * X4_mm
    w4_pp = math.sqrt(v33)
    w4_pm = math.sqrt(v34)
    w4_mp = math.sqrt(v35)
    w4_mm = math.sqrt(v36)
    factor4_pp = w4_pp * (1.0 / v33)
    factor4_pm = w4_pm * (1.0 / v34)
    factor4_mp = w4_mp * (1.0 / v35)
    factor4_mm = w4_mm * (1.0 / v36)
    v37 = X4_pp * factor4_pp
    v38 = X4_pm * factor4_pm
    v39 = X4_mp * factor4_mp
    v40 = X4_mm * factor4_mm
    s4_pp = Y4 * factor4_pp
    s4_pm = Y4 * factor4_pm
    s4_mp = Y4 * factor4_mp
    s4_mm = Y4 * factor4_mm
    v41 = math.copysign(half_turn, Y4)
    v42 = math.copysign(half_turn, -Y4)

    # theta5, type 3: U4[3, 3] and U4[1, 3]
    v43 = c23_pm * T33

    # theta6, type 3: U4[2, 2] and U4[2, 1]
    v44 = w1 * (v2 * (T14 * T22 - T24 * T12))
    v45 = w1 * (v2 * (T14 * T12 + T24 * T22))
    v46 = w1 * (v2 * (T14 * T21 - T24 * T11))
    v47 = w1 * (v2 * (T14 * T11 + T24 * T21))
    v48 = v37 * v46 - s4_pp * (s23_pp * T31 - c23_pp * v47)
    v49 = c23_pm * v47
    v50 = v38 * v46 - s4_pm * (s23_pm * T31 - v49)
    v51 = s4_mp * (v49 + s23_mp * T31) - v39 * v46
    v52 = s4_mm * (c23_mm * v47 - v29 * T31) - v40 * v46
    v53 = c23_pm * v45

    # a joint is free, or branches meet
    if (
        v36 <= m6 or v22 <= m5 or v35 <= m6 or v34 <= m6 or v21 <= m5 or v33 <= m6 or v1 <= m1 or
        abs(D3) <= m3 or v20 <= m5
    ):
        return False

    # angles, side by side
    room[0] = -T24
    room[1] = -v4
    room[2] = S2_pp
    room[3] = S2_pm
    room[4] = S2_pm
    room[5] = S2_pp
    room[6] = Y4
    room[7] = Y4
    room[8] = -Y4
    room[9] = -Y4
    room[10] = w4_pp
    room[11] = w4_pm
    room[12] = w4_mp
    room[13] = w4_mm
    room[14] = v48
    room[15] = v50
    room[16] = v51
    room[17] = v52
    room[24] = -T14
    room[25] = v6
    room[26] = C2_pp
    room[27] = -C2_mp
    room[28] = C2_mp
    room[29] = -C2_pp
    room[30] = -X4_pp
    room[31] = -X4_pm
    room[32] = -X4_mp
    room[33] = -X4_mm
    room[34] = c23_pp * T33 + s23_pp * v30
    room[35] = v43 + s23_pm * v30
    room[36] = v43 - s23_mp * v30
    room[37] = c23_mm * T33 + v29 * v30
    room[38] = v37 * v44 - s4_pp * (s23_pp * T32 - c23_pp * v45)
    room[39] = v38 * v44 - s4_pm * (s23_pm * T32 - v53)
    room[40] = s4_mp * (v53 + s23_mp * T32) - v39 * v44
    room[41] = s4_mm * (c23_mm * v45 - v29 * T32) - v40 * v44
    for k in range(18, 24):
        room[k] = room[k + 24] = 1.0
    for k in range(24):
        room[k] = _atan2(room[k], room[k + 24])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]
    angle4 = room[3]
    angle5 = room[4]
    angle6 = room[5]
    angle7 = room[6]
    angle8 = room[7]
    angle9 = room[8]
    angle10 = room[9]
    angle11 = room[10]
    angle12 = room[11]
    angle13 = room[12]
    angle14 = room[13]
    angle15 = room[14]
    angle16 = room[15]
    angle17 = room[16]
    angle18 = room[17]

    # theta3, type 8: U1[3, 4] and U1[1, 4]
    q3_pmp = math.copysign(half_turn, -v4) - angle2

    # theta4, type 2: U4[2, 3]
    q4_ppm = angle7 - v41
    q4_pmm = angle8 - v41
    q4_mpm = angle9 - v42
    q4_mmm = angle10 - v42

    # theta6, type 3: U4[2, 2] and U4[2, 1]
    q6_ppm = angle15 - math.copysign(half_turn, v48)
    q6_pmm = angle16 - math.copysign(half_turn, v50)
    q6_mpm = angle17 - math.copysign(half_turn, v51)
    q6_mmm = angle18 - math.copysign(half_turn, v52)

    # joint values
    q1_ppp = angle1 + v3
    q1_mpp = v3 + (angle1 - math.copysign(half_turn, -T24))

    q[0, 0] = q1_ppp
    q[0, 1] = angle3
    q[0, 2] = angle2
    q[0, 3] = angle7
    q[0, 4] = angle11
    q[0, 5] = angle15
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_ppp
    q[1, 1] = angle3
    q[1, 2] = angle2
    q[1, 3] = q4_ppm
    q[1, 4] = -angle11
    q[1, 5] = q6_ppm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = q1_ppp
    q[2, 1] = angle4
    q[2, 2] = q3_pmp
    q[2, 3] = angle8
    q[2, 4] = angle12
    q[2, 5] = angle16
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = q1_ppp
    q[3, 1] = angle4
    q[3, 2] = q3_pmp
    q[3, 3] = q4_pmm
    q[3, 4] = -angle12
    q[3, 5] = q6_pmm
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else OK
    q[4, 0] = q1_mpp
    q[4, 1] = angle5
    q[4, 2] = angle2
    q[4, 3] = angle9
    q[4, 4] = angle13
    q[4, 5] = angle17
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else OK
    q[5, 0] = q1_mpp
    q[5, 1] = angle5
    q[5, 2] = angle2
    q[5, 3] = q4_mpm
    q[5, 4] = -angle13
    q[5, 5] = q6_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else OK
    q[6, 0] = q1_mpp
    q[6, 1] = angle6
    q[6, 2] = q3_pmp
    q[6, 3] = angle10
    q[6, 4] = angle14
    q[6, 5] = angle18
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else OK
    q[7, 0] = q1_mpp
    q[7, 1] = angle6
    q[7, 2] = q3_pmp
    q[7, 3] = q4_mmm
    q[7, 4] = -angle14
    q[7, 5] = q6_mmm
    status[7] = UNREACHABLE if q[7, 0] != q[7, 0] else OK
    return True


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (8, 6) or status.shape != (8,):
        raise ValueError("T, q and status must have shapes (4, 4), (8, 6), (8,)")
    valid, pose = _read(T)
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    if _COMPILED and _regular(pose, q, status):
        count = 0
        for row in range(8):
            count += status[row] == OK
        return count
    return _whole(pose, seed, q, status)


# Where in a tile the rows' values and statuses begin.
_PLACES = np.array([
    [1120, 1136, 1152, 1168, 1184, 1200],
    [1120, 1136, 1152, 1216, 1232, 1248],
    [1120, 1264, 1280, 1296, 1312, 1328],
    [1120, 1264, 1280, 1344, 1360, 1376],
    [1392, 1408, 1152, 1424, 1440, 1456],
    [1392, 1408, 1152, 1472, 1488, 1504],
    [1392, 1520, 1280, 1536, 1552, 1568],
    [1392, 1520, 1280, 1584, 1600, 1616],
])
_KINDS = np.array([1632, 1648, 1664, 1680, 1696, 1712, 1728, 1744])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(1760), 1760)
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
            T32 = work[144 + k]
            T33 = work[160 + k]
            T34 = work[176 + k]
            v1 = T14 * T14 + T24 * T24
            w1 = math.sqrt(v1)
            v2 = 1.0 / v1
            N3 = v1 + T34 * T34
            D3 = (longest3 - N3) * (N3 - shortest3)
            w3 = math.sqrt(D3)
            v3 = w3 - w3
            v4 = k1 * (N3 - k1)
            v5 = k2 * v4
            v6 = k1 * w3
            c3 = k2 * v6
            X1_2 = a2 + d4 * v5
            Y1_2 = d4 * c3
            v7 = T34 * X1_2
            v8 = w1 * Y1_2
            v9 = v7 + v8
            v10 = v7 - v8
            v11 = m4 * (T34 * N3)
            v12 = w3 * (m4 * w1)
            S2_pp = v11 + v12
            S2_pm = v11 - v12
            v13 = w1 * X1_2
            v14 = T34 * Y1_2
            v15 = v14 - v13
            v16 = v13 + v14
            v17 = w3 * (m4 * T34)
            v18 = m4 * (w1 * N3)
            C2_pp = v17 - v18
            C2_mp = v17 + v18
            v19 = S2_pp * S2_pp
            v20 = v19 + C2_pp * C2_pp
            v21 = S2_pm * S2_pm + C2_mp * C2_mp
            v22 = v19 + -C2_pp * -C2_pp
            w2_pp = math.sqrt(v20)
            w2_pm = math.sqrt(v21)
            w2_mm = math.sqrt(v22)
            v23 = 1.0 / v20
            v24 = 1.0 / v21
            v25 = 1.0 / v22
            v26 = v5 * v9
            c23_pp = w2_pp * (v23 * (c3 * v15 + v26))
            c23_pm = w2_pm * (v24 * (c3 * v16 + v5 * v10))
            c23_mm = w2_mm * (v25 * (v26 - c3 * -v15))
            v27 = c3 * v9
            s23_pp = w2_pp * (v23 * (v27 - v5 * v15))
            v28 = v5 * v16 - c3 * v10
            s23_pm = w2_pm * (v24 * v28)
            s23_mp = w2_pm * (v24 * -v28)
            v29 = w2_mm * (v25 * (v27 + v5 * -v15))
            v30 = w1 * (v2 * (T14 * T13 + T24 * T23))
            X4_pp = s23_pp * T33 - c23_pp * v30
            v31 = c23_pm * v30
            X4_pm = s23_pm * T33 - v31
            X4_mp = v31 + s23_mp * T33
            X4_mm = c23_mm * v30 - v29 * T33
            Y4 = w1 * (v2 * (T14 * T23 - T24 * T13))
            v32 = Y4 * Y4
            v33 = v32 + X4_pp * X4_pp
            v34 = v32 + X4_pm * X4_pm
            v35 = v32 + X4_mp * X4_mp
            v36 = v32 + X4_mm * X4_mm
            w4_pp = math.sqrt(v33)
            w4_pm = math.sqrt(v34)
            w4_mp = math.sqrt(v35)
            w4_mm = math.sqrt(v36)
            factor4_pp = w4_pp * (1.0 / v33)
            factor4_pm = w4_pm * (1.0 / v34)
            factor4_mp = w4_mp * (1.0 / v35)
            factor4_mm = w4_mm * (1.0 / v36)
            v37 = X4_pp * factor4_pp
            v38 = X4_pm * factor4_pm
            v39 = X4_mp * factor4_mp
            v40 = X4_mm * factor4_mm
            s4_pp = Y4 * factor4_pp
            s4_pm = Y4 * factor4_pm
            s4_mp = Y4 * factor4_mp
            s4_mm = Y4 * factor4_mm
            v41 = math.copysign(half_turn, Y4)
            v42 = math.copysign(half_turn, -Y4)
            v43 = c23_pm * T33
            v44 = w1 * (v2 * (T14 * T22 - T24 * T12))
            v45 = w1 * (v2 * (T14 * T12 + T24 * T22))
            v46 = w1 * (v2 * (T14 * T21 - T24 * T11))
            v47 = w1 * (v2 * (T14 * T11 + T24 * T21))
            v48 = v37 * v46 - s4_pp * (s23_pp * T31 - c23_pp * v47)
            v49 = c23_pm * v47
            v50 = v38 * v46 - s4_pm * (s23_pm * T31 - v49)
            v51 = s4_mp * (v49 + s23_mp * T31) - v39 * v46
            v52 = s4_mm * (c23_mm * v47 - v29 * T31) - v40 * v46
            v53 = c23_pm * v45
            work[272 + k] = v1
            work[288 + k] = D3
            work[304 + k] = v3
            work[320 + k] = v4
            work[336 + k] = v20
            work[352 + k] = v21
            work[368 + k] = v22
            work[384 + k] = v33
            work[400 + k] = v34
            work[416 + k] = v35
            work[432 + k] = v36
            work[448 + k] = v41
            work[464 + k] = v42
            work[480 + k] = v48
            work[496 + k] = v50
            work[512 + k] = v51
            work[528 + k] = v52
            work[544 + k] = -T24
            work[560 + k] = -v4
            work[576 + k] = S2_pp
            work[592 + k] = S2_pm
            work[608 + k] = S2_pm
            work[624 + k] = S2_pp
            work[640 + k] = Y4
            work[656 + k] = Y4
            work[672 + k] = -Y4
            work[688 + k] = -Y4
            work[704 + k] = w4_pp
            work[720 + k] = w4_pm
            work[736 + k] = w4_mp
            work[752 + k] = w4_mm
            work[768 + k] = v48
            work[784 + k] = v50
            work[800 + k] = v51
            work[816 + k] = v52
            work[832 + k] = -T14
            work[848 + k] = v6
            work[864 + k] = C2_pp
            work[880 + k] = -C2_mp
            work[896 + k] = C2_mp
            work[912 + k] = -C2_pp
            work[928 + k] = -X4_pp
            work[944 + k] = -X4_pm
            work[960 + k] = -X4_mp
            work[976 + k] = -X4_mm
            work[992 + k] = c23_pp * T33 + s23_pp * v30
            work[1008 + k] = v43 + s23_pm * v30
            work[1024 + k] = v43 - s23_mp * v30
            work[1040 + k] = c23_mm * T33 + v29 * v30
            work[1056 + k] = v37 * v44 - s4_pp * (s23_pp * T32 - c23_pp * v45)
            work[1072 + k] = v38 * v44 - s4_pm * (s23_pm * T32 - v53)
            work[1088 + k] = s4_mp * (v53 + s23_mp * T32) - v39 * v44
            work[1104 + k] = s4_mm * (c23_mm * v45 - v29 * T32) - v40 * v44
        for k in range(544, 832):
            work[k] = _atan2(work[k], work[k + 288])
        for k in range(0, 16):
            T24 = work[112 + k]
            v1 = work[272 + k]
            D3 = work[288 + k]
            v3 = work[304 + k]
            v4 = work[320 + k]
            v20 = work[336 + k]
            v21 = work[352 + k]
            v22 = work[368 + k]
            v33 = work[384 + k]
            v34 = work[400 + k]
            v35 = work[416 + k]
            v36 = work[432 + k]
            v41 = work[448 + k]
            v42 = work[464 + k]
            v48 = work[480 + k]
            v50 = work[496 + k]
            v51 = work[512 + k]
            v52 = work[528 + k]
            angle1 = work[544 + k]
            angle2 = work[560 + k]
            angle3 = work[576 + k]
            angle4 = work[592 + k]
            angle5 = work[608 + k]
            angle6 = work[624 + k]
            angle7 = work[640 + k]
            angle8 = work[656 + k]
            angle9 = work[672 + k]
            angle10 = work[688 + k]
            angle11 = work[704 + k]
            angle12 = work[720 + k]
            angle13 = work[736 + k]
            angle14 = work[752 + k]
            angle15 = work[768 + k]
            angle16 = work[784 + k]
            angle17 = work[800 + k]
            angle18 = work[816 + k]
            q3_pmp = math.copysign(half_turn, -v4) - angle2
            q4_ppm = angle7 - v41
            q4_pmm = angle8 - v41
            q4_mpm = angle9 - v42
            q4_mmm = angle10 - v42
            q6_ppm = angle15 - math.copysign(half_turn, v48)
            q6_pmm = angle16 - math.copysign(half_turn, v50)
            q6_mpm = angle17 - math.copysign(half_turn, v51)
            q6_mmm = angle18 - math.copysign(half_turn, v52)
            q1_ppp = angle1 + v3
            q1_mpp = v3 + (angle1 - math.copysign(half_turn, -T24))
            _1120 = q1_ppp
            work[1120 + k] = _1120
            _1136 = angle3
            work[1136 + k] = _1136
            _1152 = angle2
            work[1152 + k] = _1152
            _1168 = angle7
            work[1168 + k] = _1168
            _1184 = angle11
            work[1184 + k] = _1184
            _1200 = angle15
            work[1200 + k] = _1200
            _1216 = q4_ppm
            work[1216 + k] = _1216
            _1232 = -angle11
            work[1232 + k] = _1232
            _1248 = q6_ppm
            work[1248 + k] = _1248
            _1264 = angle4
            work[1264 + k] = _1264
            _1280 = q3_pmp
            work[1280 + k] = _1280
            _1296 = angle8
            work[1296 + k] = _1296
            _1312 = angle12
            work[1312 + k] = _1312
            _1328 = angle16
            work[1328 + k] = _1328
            _1344 = q4_pmm
            work[1344 + k] = _1344
            _1360 = -angle12
            work[1360 + k] = _1360
            _1376 = q6_pmm
            work[1376 + k] = _1376
            _1392 = q1_mpp
            work[1392 + k] = _1392
            _1408 = angle5
            work[1408 + k] = _1408
            _1424 = angle9
            work[1424 + k] = _1424
            _1440 = angle13
            work[1440 + k] = _1440
            _1456 = angle17
            work[1456 + k] = _1456
            _1472 = q4_mpm
            work[1472 + k] = _1472
            _1488 = -angle13
            work[1488 + k] = _1488
            _1504 = q6_mpm
            work[1504 + k] = _1504
            _1520 = angle6
            work[1520 + k] = _1520
            _1536 = angle10
            work[1536 + k] = _1536
            _1552 = angle14
            work[1552 + k] = _1552
            _1568 = angle18
            work[1568 + k] = _1568
            _1584 = q4_mmm
            work[1584 + k] = _1584
            _1600 = -angle14
            work[1600 + k] = _1600
            _1616 = q6_mmm
            work[1616 + k] = _1616
            work[1632 + k] = UNREACHABLE if _1120 != _1120 else OK
            work[1648 + k] = UNREACHABLE if _1120 != _1120 else OK
            work[1664 + k] = UNREACHABLE if _1120 != _1120 else OK
            work[1680 + k] = UNREACHABLE if _1120 != _1120 else OK
            work[1696 + k] = UNREACHABLE if _1392 != _1392 else OK
            work[1712 + k] = UNREACHABLE if _1392 != _1392 else OK
            work[1728 + k] = UNREACHABLE if _1392 != _1392 else OK
            work[1744 + k] = UNREACHABLE if _1392 != _1392 else OK
            work[256 + k] = (
                1.0 if v36 <= m6 or v22 <= m5 or v35 <= m6 or v34 <= m6 or v21 <= m5 or v33 <= m6 or
                v1 <= m1 or abs(D3) <= m3 or v20 <= m5 else work[256 + k]
            )
        for k in range(first, first + count):
            if work[256 + k - first] != 0.0:
                _unseeded(T[k], q[k], status[k])
                continue
            for row in range(8):
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
            "no_pose": "not finite, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)",
            "no_row": "the pose is out of reach",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
