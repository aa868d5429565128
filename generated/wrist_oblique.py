"""wrist_oblique: Oblique spherical wrist.

Inverse kinematics, generated from robots/wrist_oblique.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/wrist_oblique.yaml. The formulas and where they come from:
wrist_oblique.md.

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
_of_joints = _runtime("entry").of_joints(_HOW, 3)

NAME = "wrist_oblique"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRR"
JOINT_LIMITS = (
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

sqrt3 = 1.7320508075688772  # square root of 3
ca2 = 0.6427876096865394  # cosine of twist 2
sa2 = 0.766044443118978  # sine of twist 2
d3 = 0.1  # joint offset 3 [m]
free_limit_squared2 = 1.0000000000000002e-26  # square of a length that fixes no angle [m^2]
reach_slack1 = 1.0000000000000002e-14  # rounding at the boundary of the workspace [m]
merge_slack1 = 1e-15  # nearer to that boundary two branches are one [m]
free_limit = 1e-12  # a length that fixes no angle
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 1.0000000000000002e-06  # a pose may be rounded by this [m]
k1 = 0.5  # 1 / 2
k2 = 0.06427876096865394  # d3 * ca2 [m]
k3 = 0.12855752193730788  # 2 * d3 * ca2 [m]
k4 = 0.6634139481689384  # sa2 * sqrt3 / 2
k5 = 0.8660254037844386  # sqrt3 / 2
f2 = 0.8660254037844386  # 1 / 2 * sqrt3
f3 = 0.383022221559489  # sa2 * 1 / 2
f4 = 0.3213938048432697  # ca2 * 1 / 2
doubt_limit_squared2 = 1.0000000000000002e-10  # square of a length that fixes no angle [m^2]
m1 = 1e-12  # 1000 * merge_slack1 [m]
m2 = 0.383022221559489  # a coefficient of S3
m3 = 9.999999999999999e-09  # doubt_limit^2
m4 = 0.5  # a coefficient of v19
m5 = 0.8660254037844386  # a coefficient of v25
m6 = 1.0000000000000004e-12  # pose_slack1^2 [m^2]
m7 = 3.000000000000001e-12  # 3 * pose_slack1^2 [m^2]
m8 = 1.0000000000000002e-10  # pose_slack^2
m9 = 6.000000000000001e-10  # 6 * pose_slack^2

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
    v1 = s1 * k1
    y1_y = c1 * k1
    z1_x = s1 * f2
    v2 = c1 * f2
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * c2 - v1 * s2
    x2_y = s1 * c2 + y1_y * s2
    x2_z = f2 * s2
    v3 = v1 * c2 + c1 * s2
    v4 = y1_y * c2 - s1 * s2
    v5 = f2 * c2
    v6 = v3 * ca2 + z1_x * sa2
    y2_y = v4 * ca2 + v2 * sa2
    y2_z = v5 * ca2 - f3
    z2_x = z1_x * ca2 - v3 * sa2
    z2_y = v4 * sa2 - v2 * ca2
    z2_z = v5 * sa2 + f4
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    T[0, 0] = x2_x * c3 - v6 * s3
    T[0, 1] = -(v6 * c3 + x2_x * s3)
    T[0, 2] = z2_x
    T[0, 3] = z2_x * d3
    T[1, 0] = x2_y * c3 + y2_y * s3
    T[1, 1] = y2_y * c3 - x2_y * s3
    T[1, 2] = z2_y
    T[1, 3] = z2_y * d3
    T[2, 0] = x2_z * c3 + y2_z * s3
    T[2, 1] = y2_z * c3 - x2_z * s3
    T[2, 2] = z2_z
    T[2, 3] = z2_z * d3
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
    z1_x = s1 * f2
    v1 = c1 * f2
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    z2_x = z1_x * ca2 - (s1 * k1 * c2 + c1 * s2) * sa2
    z2_y = (c1 * k1 * c2 - s1 * s2) * sa2 - v1 * ca2
    z2_z = f2 * c2 * sa2 + f4
    p3_x = z2_x * d3
    p3_y = z2_y * d3
    p3_z = z2_z * d3
    J[0, 0] = -p3_y
    J[0, 1] = -(v1 * p3_z + k1 * p3_y)
    J[0, 2] = z2_y * p3_z - z2_z * p3_y
    J[1, 0] = p3_x
    J[1, 1] = k1 * p3_x - z1_x * p3_z
    J[1, 2] = z2_z * p3_x - z2_x * p3_z
    J[2, 1] = z1_x * p3_y + v1 * p3_x
    J[2, 2] = z2_x * p3_y - z2_y * p3_x
    J[3, 1] = z1_x
    J[3, 2] = z2_x
    J[4, 1] = -v1
    J[4, 2] = z2_y
    J[5, 0] = 1.0
    J[5, 1] = k1
    J[5, 2] = z2_z
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[3, 4]
    v1 = T14 * sqrt3 * k1
    Y1 = k1 * (sqrt3 * T24)
    N1 = v1 * v1 + Y1 * Y1
    free1 = N1 <= free_limit_squared2
    Z1 = k1 * (T34 - k3)
    D1 = N1 - Z1 * Z1
    v2 = abs(Z1)
    v3 = 2.0 * v2
    apart1 = merge_slack1 * (v3 + merge_slack1) < D1
    if not (-(reach_slack1 * (v3 + reach_slack1)) <= D1):
        return  # out of reach
    w1 = math.sqrt(D1 if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else v2 * math.sqrt(N1)))
    v4 = v1 * Z1
    v5 = Y1 * Z1

    # theta3, type 3: U1[3, 2] and U1[3, 1]
    v6 = sqrt3 * T22
    v7 = T12 * sqrt3
    v8 = sqrt3 * T21
    v9 = T11 * sqrt3

    # theta2, type 3: U0 A3^-1 [3, 3] and U0 A3^-1 [3, 1]
    v14 = k1 * (2.0 * T33 - ca2) * k5
    v15 = v14 * v14

    # is the pose one that the arm can take?
    v21 = T31 * k5
    v22 = T33 * k5
    v24 = T34 * k5
    v27 = k1 * T31
    v28 = k1 * T33
    v29 = k1 * T34

    for i1 in range(2):  # shoulder+, shoulder-
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        root1 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else inverse1 * (v5 + v1 * root1)
        s1 = math.sin(seed[0]) if free1 else inverse1 * (Y1 * root1 - v4)
        q1 = _atan2(s1, c1)

        # theta3
        S3 = sa2 * (k1 * (T31 + (s1 * v9 - c1 * v8)))
        C3 = sa2 * (k1 * (T32 + (s1 * v7 - c1 * v6)))
        w3 = math.sqrt(S3 * S3 + C3 * C3)
        short3 = w3 <= free_limit
        v10 = 1.0 / (1.0 if short3 else w3)
        v11 = C3 * v10
        v12 = S3 * v10
        q3 = _atan2(-v12, -v11)

        # theta2
        v13 = k4 * (T32 * v12 - T31 * v11)
        w2 = math.sqrt(v13 * v13 + v15)
        short2 = w2 <= free_limit
        v16 = 1.0 / (1.0 if short2 else w2)
        c2 = v14 * v16
        s2 = v13 * v16
        q2 = _atan2(s2, c2)

        # is the pose one that the arm can take?
        v17 = ca2 * v12
        v18 = sa2 * s2
        v19 = k1 * s1
        v20 = k1 * c1
        v23 = sa2 * c2
        v25 = k1 * (sqrt3 * s1)
        v26 = k1 * (sqrt3 * c1)
        if (
            not (abs(T14 * v25 - T24 * v26 + v29 - k2) <= pose_slack1 and abs(T13 * v25 - T23 * v26
            + v28 - ca2) <= pose_slack and abs(T11 * v25 - T21 * v26 + v27 - sa2 * v12) <=
            pose_slack and abs(T24 * v20 - T14 * v19 + v24 - d3 * v23) <= pose_slack1 and abs(T23 *
            v20 - T13 * v19 + v22 - v23) <= pose_slack and abs(T21 * v20 - T11 * v19 + v21 + (c2 *
            v17 + v11 * s2)) <= pose_slack and abs(T14 * c1 + T24 * s1 + d3 * v18) <= pose_slack1
            and abs(T11 * c1 + T21 * s1 - (s2 * v17 - v11 * c2)) <= pose_slack and abs(T13 * c1 +
            T23 * s1 + v18) <= pose_slack)
        ):
            continue  # the arm can't take this pose
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
    return valid and math.isfinite(px) and math.isfinite(py) and math.isfinite(pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([10.0, 10.0, 10.0, 1.0, 1.0, 1.0])


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
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose
    room = carray(_room(16), 16)

    # theta1, type 2: U1[3, 4]
    v1 = k1 * (sqrt3 * T14)
    Y1 = k1 * (sqrt3 * T24)
    N1 = v1 * v1 + Y1 * Y1
    Z1 = k1 * (T34 - k3)
    D1 = N1 - Z1 * Z1
    w1 = math.sqrt(D1)
    inverse1 = 1.0 / N1
    v2 = v1 * Z1
    v3 = Y1 * Z1
    v4 = v1 * w1
    c1_p = v3 + v4
    c1_m = v3 - v4
    v5 = Y1 * w1
    s1_p = v5 - v2
    v6 = v2 + v5

    # theta3, type 3: U1[3, 2] and U1[3, 1]
    v7 = sqrt3 * T22
    v8 = sqrt3 * T12
    v9 = sqrt3 * T21
    v10 = sqrt3 * T11
    v11 = Y1 * v10 - v1 * v9
    v12 = m2 * (T31 - inverse1 * (v2 * v10 + v3 * v9))
    S3_p = v12 + w1 * (m2 * (inverse1 * v11))
    S3_m = v12 + w1 * (m2 * (inverse1 * -v11))
    v13 = Y1 * v8 - v1 * v7
    v14 = m2 * (T32 - inverse1 * (v2 * v8 + v3 * v7))
    C3_p = v14 + w1 * (m2 * (inverse1 * v13))
    C3_m = v14 + w1 * (m2 * (inverse1 * -v13))
    v15 = S3_p * S3_p + C3_p * C3_p
    v16 = S3_m * S3_m + C3_m * C3_m
    v17 = math.sqrt(v15) * (1.0 / v15)
    v18 = math.sqrt(v16) * (1.0 / v16)
    v19 = C3_p * v17
    v20 = C3_m * v18
    v21 = S3_p * v17
    v22 = S3_m * v18

    # theta2, type 3: U0 A3^-1 [3, 3] and U0 A3^-1 [3, 1]
    v23 = k4 * (T32 * v21 - T31 * v19)
    v24 = k4 * (T32 * v22 - T31 * v20)
    v25 = k5 * (k1 * (2.0 * T33 - ca2))
    v26 = v25 * v25
    v27 = v26 + v23 * v23
    v28 = v26 + v24 * v24
    v29 = math.sqrt(v27) * (1.0 / v27)
    v30 = math.sqrt(v28) * (1.0 / v28)
    c2_p = v25 * v29
    c2_m = v25 * v30
    s2_p = v23 * v29
    s2_m = v24 * v30

    # is the pose one that the arm can take?
    v31 = ca2 * v21
    v32 = ca2 * v22
    v33 = sa2 * s2_p
    v34 = sa2 * s2_m
    v35 = m4 * v2
    v36 = w1 * (m4 * Y1)
    v37 = v36 - v35
    v38 = v35 + v36
    v39 = m4 * v3
    v40 = w1 * (m4 * v1)
    v41 = v39 + v40
    v42 = v39 - v40
    v43 = k5 * T31
    v44 = k5 * T33
    v45 = sa2 * c2_p
    v46 = sa2 * c2_m
    v47 = k5 * T34
    v48 = m5 * v2
    v49 = w1 * (m5 * Y1)
    v50 = v49 - v48
    v51 = v48 + v49
    v52 = m5 * v3
    v53 = w1 * (m5 * v1)
    v54 = v52 + v53
    v55 = v52 - v53
    v56 = k1 * T31
    v57 = k1 * T33
    v58 = k1 * T34
    v59 = v58 + inverse1 * (T14 * v50 - T24 * v54) - k2
    v60 = v58 - inverse1 * (T14 * v51 + T24 * v55) - k2
    v61 = v57 + inverse1 * (v50 * T13 - v54 * T23) - ca2
    v62 = v57 - inverse1 * (v51 * T13 + v55 * T23) - ca2
    v63 = v56 + inverse1 * (T11 * v50 - T21 * v54) - sa2 * v21
    v64 = v56 - inverse1 * (T11 * v51 + T21 * v55) - sa2 * v22
    v65 = v47 + inverse1 * (T24 * v41 - T14 * v37) - d3 * v45
    v66 = v47 + inverse1 * (T24 * v42 + T14 * v38) - d3 * v46
    v67 = v44 + inverse1 * (v41 * T23 - v37 * T13) - v45
    v68 = v44 + inverse1 * (v42 * T23 + v38 * T13) - v46
    v69 = v43 + inverse1 * (T21 * v41 - T11 * v37) + (c2_p * v31 + v19 * s2_p)
    v70 = v43 + inverse1 * (T21 * v42 + T11 * v38) + (c2_m * v32 + v20 * s2_m)
    v71 = d3 * v33 + inverse1 * (T14 * c1_p + T24 * s1_p)
    v72 = d3 * v34 + inverse1 * (T14 * c1_m - T24 * v6)
    v73 = inverse1 * (c1_p * T11 + s1_p * T21) - (s2_p * v31 - v19 * c2_p)
    v74 = inverse1 * (c1_m * T11 - v6 * T21) - (s2_m * v32 - v20 * c2_m)
    v75 = v33 + inverse1 * (c1_p * T13 + s1_p * T23)
    v76 = v34 + inverse1 * (c1_m * T13 - v6 * T23)
    v77 = v59 * v59 + v65 * v65 + v71 * v71
    v78 = v60 * v60 + v66 * v66 + v72 * v72
    v79 = v61 * v61 + v63 * v63 + v67 * v67 + v69 * v69 + v73 * v73 + v75 * v75
    v80 = v62 * v62 + v64 * v64 + v68 * v68 + v70 * v70 + v74 * v74 + v76 * v76

    # joint values
    v81 = math.sqrt(-1.0)
    v82 = 0.0 if (v77 <= m6 and v79 <= m8) else v81
    v83 = 0.0 if (v78 <= m6 and v80 <= m8) else v81

    # a joint is free, or branches meet
    if (
        v28 <= m3 or v16 <= m3 or v27 <= m3 or v15 <= m3 or (m6 < v78 and v78 <= m7) or (m6 < v77
        and v77 <= m7) or (m8 < v80 and v80 <= m9) or N1 <= doubt_limit_squared2 or abs(D1) <= m1 *
        (merge_slack1 + 2.0 * abs(Z1)) or (m8 < v79 and v79 <= m9)
    ):
        return False

    # angles, side by side
    room[0] = s1_p
    room[1] = -v6
    room[2] = v23
    room[3] = v24
    room[4] = -S3_p
    room[5] = -S3_m
    room[8] = c1_p
    room[9] = c1_m
    room[10] = v25
    room[11] = v25
    room[12] = -C3_p
    room[13] = -C3_m
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

    # joint values
    q1_p = v82 + angle1
    q1_m = v83 + angle2
    q2_p = v82 + angle3
    q2_m = v83 + angle4
    q3_p = v82 + angle5
    q3_m = v83 + angle6

    q[0, 0] = q1_p
    q[0, 1] = q2_p
    q[0, 2] = q3_p
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
    [672, 688, 704],
    [720, 736, 752],
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
            v1 = k1 * (sqrt3 * T14)
            Y1 = k1 * (sqrt3 * T24)
            N1 = v1 * v1 + Y1 * Y1
            Z1 = k1 * (T34 - k3)
            D1 = N1 - Z1 * Z1
            w1 = math.sqrt(D1)
            inverse1 = 1.0 / N1
            v2 = v1 * Z1
            v3 = Y1 * Z1
            v4 = v1 * w1
            c1_p = v3 + v4
            c1_m = v3 - v4
            v5 = Y1 * w1
            s1_p = v5 - v2
            v6 = v2 + v5
            v7 = sqrt3 * T22
            v8 = sqrt3 * T12
            v9 = sqrt3 * T21
            v10 = sqrt3 * T11
            v11 = Y1 * v10 - v1 * v9
            v12 = m2 * (T31 - inverse1 * (v2 * v10 + v3 * v9))
            S3_p = v12 + w1 * (m2 * (inverse1 * v11))
            S3_m = v12 + w1 * (m2 * (inverse1 * -v11))
            v13 = Y1 * v8 - v1 * v7
            v14 = m2 * (T32 - inverse1 * (v2 * v8 + v3 * v7))
            C3_p = v14 + w1 * (m2 * (inverse1 * v13))
            C3_m = v14 + w1 * (m2 * (inverse1 * -v13))
            v15 = S3_p * S3_p + C3_p * C3_p
            v16 = S3_m * S3_m + C3_m * C3_m
            v17 = math.sqrt(v15) * (1.0 / v15)
            v18 = math.sqrt(v16) * (1.0 / v16)
            v19 = C3_p * v17
            v20 = C3_m * v18
            v21 = S3_p * v17
            v22 = S3_m * v18
            v23 = k4 * (T32 * v21 - T31 * v19)
            v24 = k4 * (T32 * v22 - T31 * v20)
            v25 = k5 * (k1 * (2.0 * T33 - ca2))
            v26 = v25 * v25
            v27 = v26 + v23 * v23
            v28 = v26 + v24 * v24
            v29 = math.sqrt(v27) * (1.0 / v27)
            v30 = math.sqrt(v28) * (1.0 / v28)
            c2_p = v25 * v29
            c2_m = v25 * v30
            s2_p = v23 * v29
            s2_m = v24 * v30
            v31 = ca2 * v21
            v32 = ca2 * v22
            v33 = sa2 * s2_p
            v34 = sa2 * s2_m
            v35 = m4 * v2
            v36 = w1 * (m4 * Y1)
            v37 = v36 - v35
            v38 = v35 + v36
            v39 = m4 * v3
            v40 = w1 * (m4 * v1)
            v41 = v39 + v40
            v42 = v39 - v40
            v43 = k5 * T31
            v44 = k5 * T33
            v45 = sa2 * c2_p
            v46 = sa2 * c2_m
            v47 = k5 * T34
            v48 = m5 * v2
            v49 = w1 * (m5 * Y1)
            v50 = v49 - v48
            v51 = v48 + v49
            v52 = m5 * v3
            v53 = w1 * (m5 * v1)
            v54 = v52 + v53
            v55 = v52 - v53
            v56 = k1 * T31
            v57 = k1 * T33
            v58 = k1 * T34
            v59 = v58 + inverse1 * (T14 * v50 - T24 * v54) - k2
            v60 = v58 - inverse1 * (T14 * v51 + T24 * v55) - k2
            v61 = v57 + inverse1 * (v50 * T13 - v54 * T23) - ca2
            v62 = v57 - inverse1 * (v51 * T13 + v55 * T23) - ca2
            v63 = v56 + inverse1 * (T11 * v50 - T21 * v54) - sa2 * v21
            v64 = v56 - inverse1 * (T11 * v51 + T21 * v55) - sa2 * v22
            v65 = v47 + inverse1 * (T24 * v41 - T14 * v37) - d3 * v45
            v66 = v47 + inverse1 * (T24 * v42 + T14 * v38) - d3 * v46
            v67 = v44 + inverse1 * (v41 * T23 - v37 * T13) - v45
            v68 = v44 + inverse1 * (v42 * T23 + v38 * T13) - v46
            v69 = v43 + inverse1 * (T21 * v41 - T11 * v37) + (c2_p * v31 + v19 * s2_p)
            v70 = v43 + inverse1 * (T21 * v42 + T11 * v38) + (c2_m * v32 + v20 * s2_m)
            v71 = d3 * v33 + inverse1 * (T14 * c1_p + T24 * s1_p)
            v72 = d3 * v34 + inverse1 * (T14 * c1_m - T24 * v6)
            v73 = inverse1 * (c1_p * T11 + s1_p * T21) - (s2_p * v31 - v19 * c2_p)
            v74 = inverse1 * (c1_m * T11 - v6 * T21) - (s2_m * v32 - v20 * c2_m)
            v75 = v33 + inverse1 * (c1_p * T13 + s1_p * T23)
            v76 = v34 + inverse1 * (c1_m * T13 - v6 * T23)
            v77 = v59 * v59 + v65 * v65 + v71 * v71
            v78 = v60 * v60 + v66 * v66 + v72 * v72
            v79 = v61 * v61 + v63 * v63 + v67 * v67 + v69 * v69 + v73 * v73 + v75 * v75
            v80 = v62 * v62 + v64 * v64 + v68 * v68 + v70 * v70 + v74 * v74 + v76 * v76
            v81 = math.sqrt(-1.0)
            v82 = 0.0 if (v77 <= m6 and v79 <= m8) else v81
            v83 = 0.0 if (v78 <= m6 and v80 <= m8) else v81
            work[272 + k] = N1
            work[288 + k] = Z1
            work[304 + k] = D1
            work[320 + k] = v15
            work[336 + k] = v16
            work[352 + k] = v27
            work[368 + k] = v28
            work[384 + k] = v77
            work[400 + k] = v78
            work[416 + k] = v79
            work[432 + k] = v80
            work[448 + k] = v82
            work[464 + k] = v83
            work[480 + k] = s1_p
            work[496 + k] = -v6
            work[512 + k] = v23
            work[528 + k] = v24
            work[544 + k] = -S3_p
            work[560 + k] = -S3_m
            work[576 + k] = c1_p
            work[592 + k] = c1_m
            work[608 + k] = v25
            work[624 + k] = v25
            work[640 + k] = -C3_p
            work[656 + k] = -C3_m
        for k in range(480, 576):
            work[k] = _atan2(work[k], work[k + 96])
        for k in range(0, 16):
            N1 = work[272 + k]
            Z1 = work[288 + k]
            D1 = work[304 + k]
            v15 = work[320 + k]
            v16 = work[336 + k]
            v27 = work[352 + k]
            v28 = work[368 + k]
            v77 = work[384 + k]
            v78 = work[400 + k]
            v79 = work[416 + k]
            v80 = work[432 + k]
            v82 = work[448 + k]
            v83 = work[464 + k]
            angle1 = work[480 + k]
            angle2 = work[496 + k]
            angle3 = work[512 + k]
            angle4 = work[528 + k]
            angle5 = work[544 + k]
            angle6 = work[560 + k]
            q1_p = v82 + angle1
            q1_m = v83 + angle2
            q2_p = v82 + angle3
            q2_m = v83 + angle4
            q3_p = v82 + angle5
            q3_m = v83 + angle6
            _672 = q1_p
            work[672 + k] = _672
            _688 = q2_p
            work[688 + k] = _688
            _704 = q3_p
            work[704 + k] = _704
            _720 = q1_m
            work[720 + k] = _720
            _736 = q2_m
            work[736 + k] = _736
            _752 = q3_m
            work[752 + k] = _752
            work[768 + k] = UNREACHABLE if _672 != _672 else OK
            work[784 + k] = UNREACHABLE if _720 != _720 else OK
            work[256 + k] = (
                1.0 if v28 <= m3 or v16 <= m3 or v27 <= m3 or v15 <= m3 or (m6 < v78 and v78 <= m7)
                or (m6 < v77 and v77 <= m7) or (m8 < v80 and v80 <= m9) or N1 <=
                doubt_limit_squared2 or abs(D1) <= m1 * (merge_slack1 + 2.0 * abs(Z1)) or (m8 < v79
                and v79 <= m9) else work[256 + k]
            )
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
            "no_row": "the pose is out of reach, or one that 3 joints can't take",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
