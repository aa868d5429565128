"""craig_417: Arm of exercise 4.17 in Craig, Introduction to Robotics.

Inverse kinematics, generated from robots/craig_417.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/craig_417.yaml. The formulas and where they come from: craig_417.md.

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

NAME = "craig_417"
METHOD = "closed form"
DOF = 4
JOINT_TYPES = "RRRR"
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

sqrt2 = 1.4142135623730951  # square root of 2
d4 = 1.0  # joint offset 4 [m]
a3 = 1.0  # link length 4 [m]
free_limit_squared = 1e-24  # square of a length that fixes no angle
free_limit = 1e-12  # a length that fixes no angle
free_limit2 = 9e-12  # a length that fixes no angle [m^2]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 3.0000000000000004e-05  # a pose may be rounded by this [m]
k1 = 0.5  # 1 / 2
k2 = 0.7071067811865476  # sqrt2 * 1 / 2
k3 = 0.5000000000000001  # k2^2
k4 = 1.4142135623731953e-13  # reach_slack * (2 * sqrt2 * 1 / 2 + reach_slack)
k5 = 1.4142135623731051e-14  # merge_slack * (2 * sqrt2 * 1 / 2 + merge_slack)
k6 = 2.0  # d3 + d4 [m]
k7 = 2.8284271247461903  # sqrt2 * k6 [m]
m1 = 1.414213562373105e-11  # 1000 * k5
m2 = 9.999999999999999e-09  # doubt_limit^2
m3 = 0.7071067811865476  # a coefficient of v7
m4 = 0.5  # a coefficient of v13
m5 = 1.4142135623730951  # a coefficient of v13
m6 = 8.1e-07  # doubt_limit2^2 [m^4]
m7 = 9.000000000000002e-10  # pose_slack1^2 [m^2]
m8 = 2.7000000000000006e-09  # 3 * pose_slack1^2 [m^2]
m9 = 1.0000000000000002e-10  # pose_slack^2
m10 = 6.000000000000001e-10  # 6 * pose_slack^2

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0])
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
    x2_x = c1 * c2
    x2_y = s1 * c2
    v1 = c1 * s2 * k2
    v2 = s1 * s2 * k2
    z3_z = c2 * k2
    v3 = s1 * k2
    z3_x = v1 - v3
    v4 = c1 * k2
    z3_y = v2 + v4
    v5 = v1 + v3
    v6 = v4 - v2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v5 * s3
    x3_y = x2_y * c3 + v6 * s3
    v7 = s2 * c3 + z3_z * s3
    v8 = v5 * c3 + x2_x * s3
    y3_y = v6 * c3 - x2_y * s3
    y3_z = s2 * s3 - z3_z * c3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    T[0, 0] = x3_x * c4 - v8 * s4
    T[0, 1] = -(v8 * c4 + x3_x * s4)
    T[0, 2] = z3_x
    T[0, 3] = z3_x + x3_x * a3 + z3_x * d4
    T[1, 0] = x3_y * c4 + y3_y * s4
    T[1, 1] = y3_y * c4 - x3_y * s4
    T[1, 2] = z3_y
    T[1, 3] = z3_y + x3_y * a3 + z3_y * d4
    T[2, 0] = y3_z * s4 - v7 * c4
    T[2, 1] = y3_z * c4 + v7 * s4
    T[2, 2] = z3_z
    T[2, 3] = z3_z - v7 * a3 + z3_z * d4
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
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    v1 = c1 * s2 * k2
    v2 = s1 * s2 * k2
    z3_z = c2 * k2
    v3 = s1 * k2
    z3_x = v1 - v3
    v4 = c1 * k2
    z3_y = v2 + v4
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    p4_x = z3_x + (c1 * c2 * c3 - (v1 + v3) * s3) * a3 + z3_x * d4
    p4_y = z3_y + (s1 * c2 * c3 + (v4 - v2) * s3) * a3 + z3_y * d4
    p4_z = z3_z - (s2 * c3 + z3_z * s3) * a3 + z3_z * d4
    v5 = p4_x - z3_x
    v6 = p4_y - z3_y
    v7 = p4_z - z3_z
    J[0, 0] = -p4_y
    J[0, 1] = c1 * p4_z
    J[0, 2] = z3_y * v7 - z3_z * v6
    J[1, 0] = p4_x
    J[1, 1] = s1 * p4_z
    J[1, 2] = z3_z * v5 - z3_x * v7
    J[2, 1] = -(s1 * p4_y + c1 * p4_x)
    J[2, 2] = z3_x * v6 - z3_y * v5
    J[3, 1] = -s1
    J[3, 2] = z3_x
    J[3, 3] = z3_x
    J[4, 1] = c1
    J[4, 2] = z3_y
    J[4, 3] = z3_y
    J[5, 0] = 1.0
    J[5, 2] = z3_z
    J[5, 3] = z3_z
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, _, T33, T34 = pose

    # theta1, type 2: U1[2, 3]
    N1 = T13 * T13 + T23 * T23
    free1 = N1 <= free_limit_squared
    D1 = N1 - k3
    apart1 = k5 < D1
    if not (-k4 <= D1):
        return  # out of reach
    w1 = math.sqrt(D1 if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else k2 * math.sqrt(N1)))
    v1 = T13 * k2
    v2 = T23 * k2

    # theta2, type 3: U1[3, 3] and U1[1, 3]
    v3 = k2 * T33
    v4 = v3 * v3

    # theta3, type 3: U2[3, 4] and U2[1, 4]
    v10 = 2.0 * T24
    v11 = 2.0 * T14

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        root1 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else inverse1 * (v2 - T13 * root1)
        s1 = math.sin(seed[0]) if free1 else -(inverse1 * (v1 + T23 * root1))
        q1 = _atan2(s1, c1)

        # theta2
        S2 = k2 * root1
        w2 = math.sqrt(S2 * S2 + v4)
        short2 = w2 <= free_limit
        v5 = 1.0 / (1.0 if short2 else w2)
        c2 = v3 * v5
        v6 = S2 * v5
        q2 = _atan2(-v6, c2)

        # theta34, type 3: U1[2, 2] and U1[2, 1]
        Z2_34 = T21 * c1 - T11 * s1
        v7 = k2 * Z2_34
        v8 = k2 * (T22 * c1 - T12 * s1)
        w34 = math.sqrt(v7 * v7 + v8 * v8)
        short34 = w34 <= free_limit
        v9 = 1.0 / (1.0 if short34 else w34)
        c34 = v8 * v9
        s34 = v7 * v9

        # theta3
        v12 = v6 * T34
        v13 = a3 * (k1 * (s1 * v11 - c1 * v10 + k7))
        C3 = k2 * (c2 * (c1 * T14 + s1 * T24) + v12)
        w3 = math.sqrt(v13 * v13 + C3 * C3)
        short3 = w3 <= free_limit2
        factor3 = 1.0 / (1.0 if short3 else w3)
        c3 = C3 * factor3
        v14 = v13 * factor3
        q3 = _atan2(-v14, c3)

        # is the pose one that the arm can take?
        v15 = c1 * c2
        v16 = c1 * v6
        v17 = s1 * c2
        v18 = s1 * v6
        v19 = k1 * (sqrt2 * s34)
        v20 = a3 * v14
        if (
            not (abs(c1 * T24 - s1 * T14 - k1 * (sqrt2 * (k6 - v20))) <= pose_slack1 and abs(T23 *
            c1 - T13 * s1 - k2) <= pose_slack and abs(Z2_34 - v19) <= pose_slack and abs(T14 * v16 +
            T24 * v18 - c2 * T34 + k1 * (sqrt2 * (k6 + v20))) <= pose_slack1 and abs(k2 + (T13 * v16
            + T23 * v18 - T33 * c2)) <= pose_slack and abs(T11 * v16 + T21 * v18 - T31 * c2 - v19)
            <= pose_slack and abs(v12 + (T14 * v15 + T24 * v17) - a3 * c3) <= pose_slack1 and
            abs(T11 * v15 + T21 * v17 + T31 * v6 - c34) <= pose_slack and abs(T13 * v15 + T23 * v17
            + T33 * v6) <= pose_slack)
        ):
            continue  # the arm can't take this pose

        # joint values
        q4 = _wrap(_atan2(s34, c34) - q3)
        row = i1
        q[row, 0] = q1
        q[row, 1] = q2
        q[row, 2] = q3
        q[row, 3] = q4
        status[row] = FREE_JOINT if free1 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px) and math.isfinite(py) and math.isfinite(pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.3333, 0.3333, 0.3333, 1.0, 1.0, 1.0])


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
    T11, T12, T13, T14, T21, T22, T23, T24, T31, _, T33, T34 = pose
    room = carray(_room(16), 16)

    # theta1, type 2: U1[2, 3]
    N1 = T13 * T13 + T23 * T23
    D1 = N1 - k3
    w1 = math.sqrt(D1)
    inverse1 = 1.0 / N1
    v1 = k2 * T13
    v2 = k2 * T23
    v3 = inverse1 * v2
    v4 = w1 * (T13 * inverse1)
    c1_p = v3 - v4
    c1_m = v3 + v4
    v5 = inverse1 * v1
    v6 = w1 * (T23 * inverse1)
    v7 = v5 + v6
    v8 = v5 - v6

    # theta2, type 3: U1[3, 3] and U1[1, 3]
    S2 = k2 * w1
    v9 = k2 * T33
    v10 = v9 * v9 + S2 * S2
    w2 = math.sqrt(v10)
    v11 = 1.0 / v10
    v12 = w2 * v11
    c2 = v9 * v12
    v13 = S2 * v12

    # theta34, type 3: U1[2, 2] and U1[2, 1]
    v14 = T23 * T11 - T13 * T21
    v15 = m3 * (inverse1 * (v1 * T11 + v2 * T21))
    v16 = v15 + w1 * (m3 * (inverse1 * v14))
    v17 = v15 + w1 * (m3 * (inverse1 * -v14))
    v18 = T23 * T12 - T13 * T22
    v19 = m3 * (inverse1 * (v1 * T12 + v2 * T22))
    v20 = v19 + w1 * (m3 * (inverse1 * v18))
    v21 = v19 + w1 * (m3 * (inverse1 * -v18))
    v22 = v16 * v16 + v20 * v20
    v23 = v17 * v17 + v21 * v21
    v24 = math.sqrt(v22) * (1.0 / v22)
    v25 = math.sqrt(v23) * (1.0 / v23)

    # theta3, type 3: U2[3, 4] and U2[1, 4]
    v26 = 2.0 * T24
    v27 = 2.0 * T14
    v28 = v13 * T34
    v29 = T13 * v26 - T23 * v27
    v30 = m5 - m4 * (inverse1 * (v1 * v27 + v2 * v26))
    v31 = v30 + w1 * (m4 * (inverse1 * v29))
    v32 = v30 + w1 * (m4 * (inverse1 * -v29))
    v33 = S2 * T34
    C3_p = w2 * (m3 * (v11 * (v33 + v9 * (c1_p * T14 - v7 * T24))))
    C3_m = w2 * (m3 * (v11 * (v9 * (c1_m * T14 - v8 * T24) - v33)))
    v34 = v31 * v31 + C3_p * C3_p
    v35 = v32 * v32 + C3_m * C3_m
    factor3_p = math.sqrt(v34) * (1.0 / v34)
    factor3_m = math.sqrt(v35) * (1.0 / v35)

    # is the pose one that the arm can take?
    v36 = c1_p * c2
    v37 = c1_m * c2
    v38 = c1_p * v13
    v39 = c1_m * v13
    v40 = v7 * c2
    v41 = v8 * c2
    v42 = v7 * v13
    v43 = v8 * v13
    v44 = k1 * (sqrt2 * (v16 * v24))
    v45 = k1 * (sqrt2 * (v17 * v25))
    v46 = a3 * (v31 * factor3_p)
    v47 = a3 * (v32 * factor3_m)
    v48 = c1_p * T24 + v7 * T14 - k1 * (sqrt2 * (k6 - v46))
    v49 = c1_m * T24 + v8 * T14 - k1 * (sqrt2 * (k6 - v47))
    v50 = T23 * c1_p + T13 * v7 - k2
    v51 = T23 * c1_m + T13 * v8 - k2
    v52 = c1_p * T21 + v7 * T11 - v44
    v53 = c1_m * T21 + v8 * T11 - v45
    v54 = c2 * T34
    v55 = T14 * v38 - T24 * v42 - v54 + k1 * (sqrt2 * (k6 + v46))
    v56 = T24 * v43 - T14 * v39 - v54 + k1 * (sqrt2 * (k6 + v47))
    v57 = T33 * c2
    v58 = k2 + (T13 * v38 - T23 * v42 - v57)
    v59 = k2 + (T23 * v43 - T13 * v39 - v57)
    v60 = c2 * T31
    v61 = T11 * v38 - T21 * v42 - v60 - v44
    v62 = T21 * v43 - T11 * v39 - v60 - v45
    v63 = v28 + (T14 * v36 - T24 * v40) - a3 * (C3_p * factor3_p)
    v64 = T14 * v37 - T24 * v41 - v28 - a3 * (C3_m * factor3_m)
    v65 = v13 * T31
    v66 = v65 + (T11 * v36 - T21 * v40) - v20 * v24
    v67 = T11 * v37 - T21 * v41 - v65 - v21 * v25
    v68 = T33 * v13
    v69 = v68 + (T13 * v36 - T23 * v40)
    v70 = T13 * v37 - T23 * v41 - v68
    v71 = v48 * v48 + v55 * v55 + v63 * v63
    v72 = v49 * v49 + v56 * v56 + v64 * v64
    v73 = v50 * v50 + v52 * v52 + v58 * v58 + v61 * v61 + v66 * v66 + v69 * v69
    v74 = v51 * v51 + v53 * v53 + v59 * v59 + v62 * v62 + v67 * v67 + v70 * v70

    # joint values
    v77 = math.sqrt(-1.0)
    v78 = 0.0 if (v71 <= m7 and v73 <= m9) else v77
    v79 = 0.0 if (v72 <= m7 and v74 <= m9) else v77

    # a joint is free, or branches meet
    if (
        v35 <= m6 or v23 <= m2 or v34 <= m6 or v22 <= m2 or (m7 < v72 and v72 <= m8) or (m7 < v71
        and v71 <= m8) or (m9 < v74 and v74 <= m10) or abs(D1) <= m1 or v10 <= m2 or (m9 < v73 and
        v73 <= m10)
    ):
        return False

    # angles, side by side
    room[0] = -S2
    room[1] = -v31
    room[2] = -v32
    room[3] = v16
    room[4] = v17
    room[5] = -v7
    room[6] = -v8
    room[8] = v9
    room[9] = C3_p
    room[10] = C3_m
    room[11] = v20
    room[12] = v21
    room[13] = c1_p
    room[14] = c1_m
    for k in range(7, 8):
        room[k] = room[k + 8] = 1.0
    for k in range(8):
        room[k] = _atan2(room[k], room[k + 8])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]
    angle4 = room[3]
    angle5 = room[4]
    angle6 = room[5]
    angle7 = room[6]

    # joint values
    v75 = angle4 - angle2
    v76 = angle5 - angle3
    q1_p = v78 + angle6
    q1_m = v79 + angle7
    q2_p = angle1 + v78
    q2_m = v79 - angle1
    q3_p = angle2 + v78
    q3_m = angle3 + v79
    q4_p = v78 + (v75 + (turn if v75 <= -half_turn else (-turn if half_turn < v75 else 0.0)))
    q4_m = v79 + (v76 + (turn if v76 <= -half_turn else (-turn if half_turn < v76 else 0.0)))

    q[0, 0] = q1_p
    q[0, 1] = q2_p
    q[0, 2] = q3_p
    q[0, 3] = q4_p
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_m
    q[1, 1] = q2_m
    q[1, 2] = q3_m
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
    [688, 704, 720, 736],
    [752, 768, 784, 800],
])
_KINDS = np.array([816, 832])


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
            N1 = T13 * T13 + T23 * T23
            D1 = N1 - k3
            w1 = math.sqrt(D1)
            inverse1 = 1.0 / N1
            v1 = k2 * T13
            v2 = k2 * T23
            v3 = inverse1 * v2
            v4 = w1 * (T13 * inverse1)
            c1_p = v3 - v4
            c1_m = v3 + v4
            v5 = inverse1 * v1
            v6 = w1 * (T23 * inverse1)
            v7 = v5 + v6
            v8 = v5 - v6
            S2 = k2 * w1
            v9 = k2 * T33
            v10 = v9 * v9 + S2 * S2
            w2 = math.sqrt(v10)
            v11 = 1.0 / v10
            v12 = w2 * v11
            c2 = v9 * v12
            v13 = S2 * v12
            v14 = T23 * T11 - T13 * T21
            v15 = m3 * (inverse1 * (v1 * T11 + v2 * T21))
            v16 = v15 + w1 * (m3 * (inverse1 * v14))
            v17 = v15 + w1 * (m3 * (inverse1 * -v14))
            v18 = T23 * T12 - T13 * T22
            v19 = m3 * (inverse1 * (v1 * T12 + v2 * T22))
            v20 = v19 + w1 * (m3 * (inverse1 * v18))
            v21 = v19 + w1 * (m3 * (inverse1 * -v18))
            v22 = v16 * v16 + v20 * v20
            v23 = v17 * v17 + v21 * v21
            v24 = math.sqrt(v22) * (1.0 / v22)
            v25 = math.sqrt(v23) * (1.0 / v23)
            v26 = 2.0 * T24
            v27 = 2.0 * T14
            v28 = v13 * T34
            v29 = T13 * v26 - T23 * v27
            v30 = m5 - m4 * (inverse1 * (v1 * v27 + v2 * v26))
            v31 = v30 + w1 * (m4 * (inverse1 * v29))
            v32 = v30 + w1 * (m4 * (inverse1 * -v29))
            v33 = S2 * T34
            C3_p = w2 * (m3 * (v11 * (v33 + v9 * (c1_p * T14 - v7 * T24))))
            C3_m = w2 * (m3 * (v11 * (v9 * (c1_m * T14 - v8 * T24) - v33)))
            v34 = v31 * v31 + C3_p * C3_p
            v35 = v32 * v32 + C3_m * C3_m
            factor3_p = math.sqrt(v34) * (1.0 / v34)
            factor3_m = math.sqrt(v35) * (1.0 / v35)
            v36 = c1_p * c2
            v37 = c1_m * c2
            v38 = c1_p * v13
            v39 = c1_m * v13
            v40 = v7 * c2
            v41 = v8 * c2
            v42 = v7 * v13
            v43 = v8 * v13
            v44 = k1 * (sqrt2 * (v16 * v24))
            v45 = k1 * (sqrt2 * (v17 * v25))
            v46 = a3 * (v31 * factor3_p)
            v47 = a3 * (v32 * factor3_m)
            v48 = c1_p * T24 + v7 * T14 - k1 * (sqrt2 * (k6 - v46))
            v49 = c1_m * T24 + v8 * T14 - k1 * (sqrt2 * (k6 - v47))
            v50 = T23 * c1_p + T13 * v7 - k2
            v51 = T23 * c1_m + T13 * v8 - k2
            v52 = c1_p * T21 + v7 * T11 - v44
            v53 = c1_m * T21 + v8 * T11 - v45
            v54 = c2 * T34
            v55 = T14 * v38 - T24 * v42 - v54 + k1 * (sqrt2 * (k6 + v46))
            v56 = T24 * v43 - T14 * v39 - v54 + k1 * (sqrt2 * (k6 + v47))
            v57 = T33 * c2
            v58 = k2 + (T13 * v38 - T23 * v42 - v57)
            v59 = k2 + (T23 * v43 - T13 * v39 - v57)
            v60 = c2 * T31
            v61 = T11 * v38 - T21 * v42 - v60 - v44
            v62 = T21 * v43 - T11 * v39 - v60 - v45
            v63 = v28 + (T14 * v36 - T24 * v40) - a3 * (C3_p * factor3_p)
            v64 = T14 * v37 - T24 * v41 - v28 - a3 * (C3_m * factor3_m)
            v65 = v13 * T31
            v66 = v65 + (T11 * v36 - T21 * v40) - v20 * v24
            v67 = T11 * v37 - T21 * v41 - v65 - v21 * v25
            v68 = T33 * v13
            v69 = v68 + (T13 * v36 - T23 * v40)
            v70 = T13 * v37 - T23 * v41 - v68
            v71 = v48 * v48 + v55 * v55 + v63 * v63
            v72 = v49 * v49 + v56 * v56 + v64 * v64
            v73 = v50 * v50 + v52 * v52 + v58 * v58 + v61 * v61 + v66 * v66 + v69 * v69
            v74 = v51 * v51 + v53 * v53 + v59 * v59 + v62 * v62 + v67 * v67 + v70 * v70
            v77 = math.sqrt(-1.0)
            v78 = 0.0 if (v71 <= m7 and v73 <= m9) else v77
            v79 = 0.0 if (v72 <= m7 and v74 <= m9) else v77
            work[272 + k] = D1
            work[288 + k] = v10
            work[304 + k] = v22
            work[320 + k] = v23
            work[336 + k] = v34
            work[352 + k] = v35
            work[368 + k] = v71
            work[384 + k] = v72
            work[400 + k] = v73
            work[416 + k] = v74
            work[432 + k] = v78
            work[448 + k] = v79
            work[464 + k] = -S2
            work[480 + k] = -v31
            work[496 + k] = -v32
            work[512 + k] = v16
            work[528 + k] = v17
            work[544 + k] = -v7
            work[560 + k] = -v8
            work[576 + k] = v9
            work[592 + k] = C3_p
            work[608 + k] = C3_m
            work[624 + k] = v20
            work[640 + k] = v21
            work[656 + k] = c1_p
            work[672 + k] = c1_m
        for k in range(464, 576):
            work[k] = _atan2(work[k], work[k + 112])
        for k in range(0, 16):
            D1 = work[272 + k]
            v10 = work[288 + k]
            v22 = work[304 + k]
            v23 = work[320 + k]
            v34 = work[336 + k]
            v35 = work[352 + k]
            v71 = work[368 + k]
            v72 = work[384 + k]
            v73 = work[400 + k]
            v74 = work[416 + k]
            v78 = work[432 + k]
            v79 = work[448 + k]
            angle1 = work[464 + k]
            angle2 = work[480 + k]
            angle3 = work[496 + k]
            angle4 = work[512 + k]
            angle5 = work[528 + k]
            angle6 = work[544 + k]
            angle7 = work[560 + k]
            v75 = angle4 - angle2
            v76 = angle5 - angle3
            q1_p = v78 + angle6
            q1_m = v79 + angle7
            q2_p = angle1 + v78
            q2_m = v79 - angle1
            q3_p = angle2 + v78
            q3_m = angle3 + v79
            q4_p = (
                v78 + (v75 + (turn if v75 <= -half_turn else (-turn if half_turn < v75 else 0.0)))
            )
            q4_m = (
                v79 + (v76 + (turn if v76 <= -half_turn else (-turn if half_turn < v76 else 0.0)))
            )
            _688 = q1_p
            work[688 + k] = _688
            _704 = q2_p
            work[704 + k] = _704
            _720 = q3_p
            work[720 + k] = _720
            _736 = q4_p
            work[736 + k] = _736
            _752 = q1_m
            work[752 + k] = _752
            _768 = q2_m
            work[768 + k] = _768
            _784 = q3_m
            work[784 + k] = _784
            _800 = q4_m
            work[800 + k] = _800
            work[816 + k] = UNREACHABLE if _688 != _688 else OK
            work[832 + k] = UNREACHABLE if _752 != _752 else OK
            work[256 + k] = (
                1.0 if v35 <= m6 or v23 <= m2 or v34 <= m6 or v22 <= m2 or (m7 < v72 and v72 <= m8)
                or (m7 < v71 and v71 <= m8) or (m9 < v74 and v74 <= m10) or abs(D1) <= m1 or v10 <=
                m2 or (m9 < v73 and v73 <= m10) else work[256 + k]
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
            "no_pose": "not finite, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)",
            "no_row": "the pose is out of reach, or one that 4 joints can't take",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
