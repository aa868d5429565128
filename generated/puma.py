"""puma: PUMA in its reference position.

Inverse kinematics, generated from robots/puma.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/puma.yaml. The formulas and where they come from: puma.md.

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

NAME = "puma"
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
    "right-down-noflip",
    "right-down-flip",
    "right-up-noflip",
    "right-up-flip",
    "left-up-noflip",
    "left-up-flip",
    "left-down-noflip",
    "left-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

L2 = 0.4318  # z of axis 3 [m]
D3 = 0.15005  # x of axis 4 [m]
D4 = 0.4318  # z of axis 5 [m]
free_limit_squared2 = 3.57281304106196e-24  # square of a length that fixes no angle [m^2]
least_root1 = 5.977301264836799e-07  # a root of nothing, by rounding [m]
longest3 = 0.7458049600000001  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
boundary3 = 2.435176934946171e-13  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.7458049599999674  # the longest, where branches merge [m^2]
shortest3_apart = 3.5728130410619605e-28  # the shortest, where branches merge [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.8636  # L2 + D4 [m]
k2 = 0.022515002499999996  # D3^2 [m^2]
k3 = 5.6724560659962443e-14  # reach_slack1 * (2 * D3 + reach_slack1) [m^2]
k4 = 5.672456065993029e-15  # merge_slack1 * (2 * D3 + merge_slack1) [m^2]
k5 = 0.5290477290765635  # 1 / arm_size1 [m^-1]
k6 = 0.37290248000000004  # 2 * D4 * L2 [m^2]
k7 = 2.681666262986505  # 1 / k6 [m^-2]
f1 = 0.8636  # L2 + D4 [m]
g1 = 0.8636  # L2 + D4 [m]
m1 = 5.672456065993029e-12  # 1000 * k4 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 2.4343489251065266e-11
m3 = 1.1579434923575729  # a coefficient of v6
m4 = 1.276499302638241e-15  # doubt_limit_squared2^2 [m^4]
m5 = 3.105217997900075  # a coefficient of c23
m6 = 2.3158869847151458  # a coefficient of s23
m7 = 9.999999999999999e-09  # doubt_limit^2

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
    x2_x = s1 * s2
    v1 = c1 * s2
    y2_x = s1 * c2
    v2 = c1 * c2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 + y2_x * s3
    v3 = v1 * c3 + v2 * s3
    x3_z = c2 * c3 - s2 * s3
    v4 = s2 * c3 + c2 * s3
    v5 = x2_x * s3 - y2_x * c3
    v6 = v2 * c3 - v1 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = c1 * c4 + v5 * s4
    x4_y = s1 * c4 + v6 * s4
    x4_z = v4 * s4
    y4_z = v4 * c4
    v7 = c1 * s4 - v5 * c4
    v8 = s1 * s4 - v6 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x3_x * c5 + v7 * s5
    x5_y = v8 * s5 - v3 * c5
    x5_z = x3_z * c5 - y4_z * s5
    y5_y = v8 * c5 + v3 * s5
    v9 = y4_z * c5 + x3_z * s5
    v10 = x3_x * s5 - v7 * c5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    x6_x = x4_x * c6 + v10 * s6
    x6_y = x4_y * c6 - y5_y * s6
    x6_z = x4_z * c6 + v9 * s6
    T[0, 0] = x6_x
    T[0, 1] = v10 * c6 - x4_x * s6
    T[0, 2] = x5_x
    T[0, 3] = x2_x * L2 + c1 * D3 + x3_x * D4 - D3 * x6_x - x5_x * f1
    T[1, 0] = x6_y
    T[1, 1] = -(y5_y * c6 + x4_y * s6)
    T[1, 2] = x5_y
    T[1, 3] = s1 * D3 - v1 * L2 - v3 * D4 - D3 * x6_y - x5_y * f1
    T[2, 0] = x6_z
    T[2, 1] = v9 * c6 - x4_z * s6
    T[2, 2] = x5_z
    T[2, 3] = c2 * L2 + x3_z * D4 - D3 * x6_z - x5_z * f1
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
    x2_x = s1 * s2
    v1 = c1 * s2
    y2_x = s1 * c2
    v2 = c1 * c2
    p3_x = x2_x * L2
    v3 = v1 * L2
    p3_z = c2 * L2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 + y2_x * s3
    v4 = v1 * c3 + v2 * s3
    x3_z = c2 * c3 - s2 * s3
    v5 = s2 * c3 + c2 * s3
    p4_x = p3_x + c1 * D3
    p4_y = s1 * D3 - v3
    v6 = x2_x * s3 - y2_x * c3
    v7 = v2 * c3 - v1 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = c1 * c4 + v6 * s4
    x4_y = s1 * c4 + v7 * s4
    x4_z = v5 * s4
    y4_z = v5 * c4
    p5_x = p4_x + x3_x * D4
    p5_y = p4_y - v4 * D4
    p5_z = p3_z + x3_z * D4
    v8 = c1 * s4 - v6 * c4
    v9 = s1 * s4 - v7 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x3_x * c5 + v8 * s5
    x5_y = v9 * s5 - v4 * c5
    x5_z = x3_z * c5 - y4_z * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    J21 = p5_x - D3 * (x4_x * c6 + (x3_x * s5 - v8 * c5) * s6) - x5_x * g1
    v10 = p5_y - D3 * (x4_y * c6 - (v9 * c5 + v4 * s5) * s6) - x5_y * g1
    v11 = p5_z - D3 * (x4_z * c6 + (y4_z * c5 + x3_z * s5) * s6) - x5_z * g1
    v12 = v11 - p3_z
    v13 = J21 - p4_x
    v14 = v10 - p4_y
    v15 = J21 - p5_x
    v16 = v10 - p5_y
    v17 = v11 - p5_z
    J[0, 0] = -v10
    J[0, 1] = s1 * v11
    J[0, 2] = s1 * v12
    J[0, 3] = -(v4 * v12 + x3_z * v14)
    J[0, 4] = x4_y * v17 - x4_z * v16
    J[0, 5] = x5_y * v17 - x5_z * v16
    J[1, 0] = J21
    J[1, 1] = -(c1 * v11)
    J[1, 2] = -(c1 * v12)
    J[1, 3] = x3_z * v13 - x3_x * v12
    J[1, 4] = x4_z * v15 - x4_x * v17
    J[1, 5] = x5_z * v15 - x5_x * v17
    J[2, 1] = c1 * v10 - s1 * J21
    J[2, 2] = c1 * (v3 + v10) - s1 * (J21 - p3_x)
    J[2, 3] = x3_x * v14 + v4 * v13
    J[2, 4] = x4_x * v16 - x4_y * v15
    J[2, 5] = x5_x * v16 - x5_y * v15
    J[3, 1] = c1
    J[3, 2] = c1
    J[3, 3] = x3_x
    J[3, 4] = x4_x
    J[3, 5] = x5_x
    J[4, 1] = s1
    J[4, 2] = s1
    J[4, 3] = -v4
    J[4, 4] = x4_y
    J[4, 5] = x5_y
    J[5, 0] = 1.0
    J[5, 3] = x3_z
    J[5, 4] = x4_z
    J[5, 5] = x5_z
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[1, 4]
    t24 = T24 + D3 * T21 + k1 * T23
    t14 = T14 + D3 * T11 + k1 * T13
    N1 = t24 * t24 + t14 * t14
    free1 = N1 <= free_limit_squared2
    D1 = N1 - k2
    apart1 = k4 < D1
    if not (-k3 <= D1):
        return  # out of reach
    w1 = math.sqrt(D1 if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else D3 * math.sqrt(N1)))
    v1 = D3 * t24
    v2 = D3 * t14

    # theta3, type 8: U1[3, 4] and U1[2, 4]
    t34 = T34 + D3 * T31 + k1 * T33
    v3 = t34 * t34
    v4 = 1.0 if free1 else (w1 if apart1 else least_root1) * k5

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        root1 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else inverse1 * (v2 + t24 * root1)
        s1 = math.sin(seed[0]) if free1 else inverse1 * (v1 - t14 * root1)
        q1 = _atan2(s1, c1)

        # theta3
        N3 = v3 + root1 * root1
        K3 = N3 - k6
        D3_ = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= D3_ * v4):
            continue  # out of reach
        w3 = math.sqrt(D3_ if apart3 else 0.0)
        c3 = K3 * k7

        # theta2, type 3: U1[3, 4] and U1[2, 4]
        Y1_2 = L2 + D4 * c3
        v6 = root1 * Y1_2
        v8 = t34 * Y1_2

        # theta4, type 2: U4[1, 3]
        v9 = T13 * s1 - T23 * c1
        v10 = T13 * c1 + T23 * s1
        v11 = v10 * v10

        # theta6, type 3: U4[1, 2] and U4[1, 1]
        v12 = T12 * c1 + T22 * s1
        v13 = T12 * s1 - T22 * c1
        v15 = T11 * c1 + T21 * s1
        v16 = T11 * s1 - T21 * c1

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            s3 = w3 * e2 * k7
            q3 = _atan2(s3, c3)

            # theta2
            v5 = D4 * s3
            v7 = t34 * v5 + v6
            C2 = v8 - root1 * v5
            w2 = math.sqrt(v7 * v7 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else -(v7 * factor2)
            q2 = _atan2(s2, c2)

            # theta4
            c23 = c3 * c2 - s3 * s2
            s23 = c3 * s2 + s3 * c2
            X4 = c23 * v9 - T33 * s23
            w4 = math.sqrt(X4 * X4 + v11)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[3, 3] and U4[2, 3]
            c5 = T33 * c23 + s23 * v9

            # theta6
            v14 = T32 * s23 - c23 * v13
            v17 = T31 * s23 - c23 * v16

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4
                if e3 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e3 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else -(v10 * factor4)
                q4 = _atan2(s4, c4)

                # theta5
                q5 = _atan2(-(w4 * e3), c5)

                # theta6
                c6 = c4 * v15 + s4 * v17
                q6 = _atan2(-(c4 * v12 + s4 * v14), c6)
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
_MISS_WEIGHT = np.array([0.529, 0.529, 0.529, 1.0, 1.0, 1.0])


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
def _lead(pose, q, status):
    """Rows of a root that follows another, which may be a little out of reach, to solutions."""
    for row in range(8):
        if status[row] == UNREACHABLE or _miss(pose, q[row])[1] <= 1e-11:
            continue
        if not _settle(pose, 1e-12, 0.15, q[row]):
            status[row] = UNREACHABLE
            for i in range(6):
                q[row, i] = math.nan


@_apart("boolean(UniTuple(float64, 12), float64[::1])")
def _are_one(T, half):
    """Whether rounding alone tells two solutions that lie to both sides of joint values.

    Half way the arm is singular, and what steps in all other directions leave of the miss is how far
    the pose is from one at which both meet.
    """
    held = np.zeros(6, np.bool_)
    for _ in range(3):
        _add_step(held, 1e-13, _miss(T, half)[0], half)
    return _miss(T, half)[1] <= 1e-14


@_inner
def _tell_once(pose, q, status):
    """Ends rows that rounding alone tells from earlier ones.

    Where an earlier angle is good to fewer digits than usual branches that meet come out apart.
    """
    half = np.empty(6)
    for row in range(1, 8):
        for k in range(row):
            if status[row] == UNREACHABLE or status[k] == UNREACHABLE:
                continue
            if _half_way(q[k], q[row], half) < 0.001 and _are_one(pose, half):
                status[row] = UNREACHABLE
                for i in range(6):
                    q[row, i] = math.nan


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
    _lead(pose, q, status)
    _tell_once(pose, q, status)
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

    # theta1, type 2: U1[1, 4]
    t24 = T24 + D3 * T21 + k1 * T23
    t14 = T14 + D3 * T11 + k1 * T13
    N1 = t24 * t24 + t14 * t14
    D1 = N1 - k2
    w1 = math.sqrt(D1)
    v1 = w1 - w1
    inverse1 = 1.0 / N1
    v2 = inverse1 * (D3 * t14)
    v3 = w1 * (t24 * inverse1)
    c1_p = v2 + v3
    c1_m = v2 - v3
    v4 = inverse1 * (D3 * t24)
    v5 = w1 * (t14 * inverse1)
    s1_p = v4 - v5
    s1_m = v4 + v5

    # theta3, type 8: U1[3, 4] and U1[2, 4]
    t34 = T34 + D3 * T31 + k1 * T33
    N3 = D1 + t34 * t34
    D3_ = (longest3 - N3) * (N3 - shortest3)
    w3 = math.sqrt(D3_)
    v6 = w3 - w3

    # theta2, type 3: U1[3, 4] and U1[2, 4]
    v7 = w3 * (m3 * t34)
    v8 = m3 * (w1 * N3)
    v9 = v7 + v8
    v10 = v8 - v7
    v11 = m3 * (t34 * N3)
    v12 = w3 * (m3 * w1)
    C2_pp = v11 - v12
    C2_pm = v11 + v12
    v13 = v9 * v9 + C2_pp * C2_pp
    v14 = C2_pm * C2_pm
    v15 = v10 * v10 + v14
    v16 = v14 + -v10 * -v10
    factor2_pp = math.sqrt(v13) * (1.0 / v13)
    factor2_pm = math.sqrt(v15) * (1.0 / v15)
    factor2_mp = math.sqrt(v16) * (1.0 / v16)

    # theta4, type 2: U4[1, 3]
    v17 = m5 * N3
    v18 = m3 - v17
    v19 = v17 - m6
    v20 = w1 * (N3 * (v18 + v19))
    s23_pp = v7 + v20
    s23_pm = v20 - v7
    v21 = w1 * (N3 * (-v18 + -v19))
    s23_mp = v7 + v21
    s23_mm = v21 - v7
    v22 = T13 * s1_p - T23 * c1_p
    v23 = T13 * s1_m - T23 * c1_m
    X4_pp = C2_pm * v22 - T33 * s23_pp
    X4_pm = C2_pp * v22 - T33 * s23_pm
    X4_mp = C2_pp * v23 - T33 * s23_mp
    X4_mm = C2_pm * v23 - T33 * s23_mm
    v24 = T13 * c1_p + T23 * s1_p
    v25 = T13 * c1_m + T23 * s1_m
    v26 = v24 * v24
    v27 = v25 * v25
    v28 = v26 + factor2_pp * (X4_pp * (factor2_pp * X4_pp))
    v29 = v26 + factor2_pm * (X4_pm * (factor2_pm * X4_pm))
    v30 = v27 + factor2_mp * (X4_mp * (factor2_mp * X4_mp))
    v31 = v27 + factor2_pp * (X4_mm * (factor2_pp * X4_mm))
    v32 = math.copysign(half_turn, -v24)
    v33 = math.copysign(half_turn, -v25)

    # theta5, type 3: U4[3, 3] and U4[2, 3]
    v34 = T33 * C2_pm
    v35 = T33 * C2_pp

    # theta6, type 3: U4[1, 2] and U4[1, 1]
    v36 = c1_p * T12 + s1_p * T22
    v37 = c1_m * T12 + s1_m * T22
    v38 = s1_p * T12 - c1_p * T22
    v39 = s1_m * T12 - c1_m * T22
    v40 = T11 * c1_p + T21 * s1_p
    v41 = T11 * c1_m + T21 * s1_m
    v42 = T11 * s1_p - T21 * c1_p
    v43 = T11 * s1_m - T21 * c1_m
    v44 = v24 * (s23_pp * T32 - C2_pm * v38) - -X4_pp * v36
    v45 = v24 * (s23_pm * T32 - C2_pp * v38) - -X4_pm * v36
    v46 = v25 * (s23_mp * T32 - C2_pp * v39) - -X4_mp * v37
    v47 = v25 * (s23_mm * T32 - C2_pm * v39) - -X4_mm * v37

    # a joint is free, or branches meet
    if (
        v31 <= m7 or v30 <= m7 or v16 <= m4 or v29 <= m7 or v15 <= m4 or v28 <= m7 or abs(D1) <= m1
        or abs(D3_ * (k5 * w1)) <= m2 or v13 <= m4
    ):
        return False

    # angles, side by side
    room[0] = w3
    room[1] = -v9
    room[2] = -v10
    room[3] = v10
    room[4] = v9
    room[5] = -v24
    room[6] = -v24
    room[7] = -v25
    room[8] = -v25
    room[9] = -math.sqrt(v28)
    room[10] = -math.sqrt(v29)
    room[11] = -math.sqrt(v30)
    room[12] = -math.sqrt(v31)
    room[13] = v44
    room[14] = v45
    room[15] = v46
    room[16] = v47
    room[17] = s1_p
    room[18] = s1_m
    room[24] = N3 - k6
    room[25] = C2_pp
    room[26] = C2_pm
    room[27] = C2_pm
    room[28] = C2_pp
    room[29] = factor2_pp * -X4_pp
    room[30] = factor2_pm * -X4_pm
    room[31] = factor2_mp * -X4_mp
    room[32] = factor2_pp * -X4_mm
    room[33] = factor2_pp * (v34 + s23_pp * v22)
    room[34] = factor2_pm * (v35 + s23_pm * v22)
    room[35] = factor2_mp * (v35 + s23_mp * v23)
    room[36] = factor2_pp * (v34 + s23_mm * v23)
    room[37] = -X4_pp * v40 - v24 * (T31 * s23_pp - C2_pm * v42)
    room[38] = -X4_pm * v40 - v24 * (T31 * s23_pm - C2_pp * v42)
    room[39] = -X4_mp * v41 - v25 * (T31 * s23_mp - C2_pp * v43)
    room[40] = -X4_mm * v41 - v25 * (T31 * s23_mm - C2_pm * v43)
    room[41] = c1_p
    room[42] = c1_m
    for k in range(19, 24):
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
    angle19 = room[18]

    # theta4, type 2: U4[1, 3]
    q4_ppm = angle6 - v32
    q4_pmm = angle7 - v32
    q4_mpm = angle8 - v33
    q4_mmm = angle9 - v33

    # theta6, type 3: U4[1, 2] and U4[1, 1]
    q6_ppm = angle14 - math.copysign(half_turn, v44)
    q6_pmm = angle15 - math.copysign(half_turn, v45)
    q6_mpm = angle16 - math.copysign(half_turn, v46)
    q6_mmm = angle17 - math.copysign(half_turn, v47)

    # joint values
    q1_ppp = v6 + angle18
    q1_mpp = v6 + angle19
    q3_ppp = v1 + angle1
    q3_pmp = v1 - angle1

    q[0, 0] = q1_ppp
    q[0, 1] = angle2
    q[0, 2] = q3_ppp
    q[0, 3] = angle6
    q[0, 4] = angle10
    q[0, 5] = angle14
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_ppp
    q[1, 1] = angle2
    q[1, 2] = q3_ppp
    q[1, 3] = q4_ppm
    q[1, 4] = -angle10
    q[1, 5] = q6_ppm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = q1_ppp
    q[2, 1] = angle3
    q[2, 2] = q3_pmp
    q[2, 3] = angle7
    q[2, 4] = angle11
    q[2, 5] = angle15
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = q1_ppp
    q[3, 1] = angle3
    q[3, 2] = q3_pmp
    q[3, 3] = q4_pmm
    q[3, 4] = -angle11
    q[3, 5] = q6_pmm
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else OK
    q[4, 0] = q1_mpp
    q[4, 1] = angle4
    q[4, 2] = q3_ppp
    q[4, 3] = angle8
    q[4, 4] = angle12
    q[4, 5] = angle16
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else OK
    q[5, 0] = q1_mpp
    q[5, 1] = angle4
    q[5, 2] = q3_ppp
    q[5, 3] = q4_mpm
    q[5, 4] = -angle12
    q[5, 5] = q6_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else OK
    q[6, 0] = q1_mpp
    q[6, 1] = angle5
    q[6, 2] = q3_pmp
    q[6, 3] = angle9
    q[6, 4] = angle13
    q[6, 5] = angle17
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else OK
    q[7, 0] = q1_mpp
    q[7, 1] = angle5
    q[7, 2] = q3_pmp
    q[7, 3] = q4_mmm
    q[7, 4] = -angle13
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
    [1168, 1184, 1200, 1216, 1232, 1248],
    [1168, 1184, 1200, 1264, 1280, 1296],
    [1168, 1312, 1328, 1344, 1360, 1376],
    [1168, 1312, 1328, 1392, 1408, 1424],
    [1440, 1456, 1200, 1472, 1488, 1504],
    [1440, 1456, 1200, 1520, 1536, 1552],
    [1440, 1568, 1328, 1584, 1600, 1616],
    [1440, 1568, 1328, 1632, 1648, 1664],
])
_KINDS = np.array([1680, 1696, 1712, 1728, 1744, 1760, 1776, 1792])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(1808), 1808)
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
            t24 = T24 + D3 * T21 + k1 * T23
            t14 = T14 + D3 * T11 + k1 * T13
            N1 = t24 * t24 + t14 * t14
            D1 = N1 - k2
            w1 = math.sqrt(D1)
            v1 = w1 - w1
            inverse1 = 1.0 / N1
            v2 = inverse1 * (D3 * t14)
            v3 = w1 * (t24 * inverse1)
            c1_p = v2 + v3
            c1_m = v2 - v3
            v4 = inverse1 * (D3 * t24)
            v5 = w1 * (t14 * inverse1)
            s1_p = v4 - v5
            s1_m = v4 + v5
            t34 = T34 + D3 * T31 + k1 * T33
            N3 = D1 + t34 * t34
            D3_ = (longest3 - N3) * (N3 - shortest3)
            w3 = math.sqrt(D3_)
            v6 = w3 - w3
            v7 = w3 * (m3 * t34)
            v8 = m3 * (w1 * N3)
            v9 = v7 + v8
            v10 = v8 - v7
            v11 = m3 * (t34 * N3)
            v12 = w3 * (m3 * w1)
            C2_pp = v11 - v12
            C2_pm = v11 + v12
            v13 = v9 * v9 + C2_pp * C2_pp
            v14 = C2_pm * C2_pm
            v15 = v10 * v10 + v14
            v16 = v14 + -v10 * -v10
            factor2_pp = math.sqrt(v13) * (1.0 / v13)
            factor2_pm = math.sqrt(v15) * (1.0 / v15)
            factor2_mp = math.sqrt(v16) * (1.0 / v16)
            v17 = m5 * N3
            v18 = m3 - v17
            v19 = v17 - m6
            v20 = w1 * (N3 * (v18 + v19))
            s23_pp = v7 + v20
            s23_pm = v20 - v7
            v21 = w1 * (N3 * (-v18 + -v19))
            s23_mp = v7 + v21
            s23_mm = v21 - v7
            v22 = T13 * s1_p - T23 * c1_p
            v23 = T13 * s1_m - T23 * c1_m
            X4_pp = C2_pm * v22 - T33 * s23_pp
            X4_pm = C2_pp * v22 - T33 * s23_pm
            X4_mp = C2_pp * v23 - T33 * s23_mp
            X4_mm = C2_pm * v23 - T33 * s23_mm
            v24 = T13 * c1_p + T23 * s1_p
            v25 = T13 * c1_m + T23 * s1_m
            v26 = v24 * v24
            v27 = v25 * v25
            v28 = v26 + factor2_pp * (X4_pp * (factor2_pp * X4_pp))
            v29 = v26 + factor2_pm * (X4_pm * (factor2_pm * X4_pm))
            v30 = v27 + factor2_mp * (X4_mp * (factor2_mp * X4_mp))
            v31 = v27 + factor2_pp * (X4_mm * (factor2_pp * X4_mm))
            v32 = math.copysign(half_turn, -v24)
            v33 = math.copysign(half_turn, -v25)
            v34 = T33 * C2_pm
            v35 = T33 * C2_pp
            v36 = c1_p * T12 + s1_p * T22
            v37 = c1_m * T12 + s1_m * T22
            v38 = s1_p * T12 - c1_p * T22
            v39 = s1_m * T12 - c1_m * T22
            v40 = T11 * c1_p + T21 * s1_p
            v41 = T11 * c1_m + T21 * s1_m
            v42 = T11 * s1_p - T21 * c1_p
            v43 = T11 * s1_m - T21 * c1_m
            v44 = v24 * (s23_pp * T32 - C2_pm * v38) - -X4_pp * v36
            v45 = v24 * (s23_pm * T32 - C2_pp * v38) - -X4_pm * v36
            v46 = v25 * (s23_mp * T32 - C2_pp * v39) - -X4_mp * v37
            v47 = v25 * (s23_mm * T32 - C2_pm * v39) - -X4_mm * v37
            work[272 + k] = D1
            work[288 + k] = w1
            work[304 + k] = v1
            work[320 + k] = D3_
            work[336 + k] = v6
            work[352 + k] = v13
            work[368 + k] = v15
            work[384 + k] = v16
            work[400 + k] = v28
            work[416 + k] = v29
            work[432 + k] = v30
            work[448 + k] = v31
            work[464 + k] = v32
            work[480 + k] = v33
            work[496 + k] = v44
            work[512 + k] = v45
            work[528 + k] = v46
            work[544 + k] = v47
            work[560 + k] = w3
            work[576 + k] = -v9
            work[592 + k] = -v10
            work[608 + k] = v10
            work[624 + k] = v9
            work[640 + k] = -v24
            work[656 + k] = -v24
            work[672 + k] = -v25
            work[688 + k] = -v25
            work[704 + k] = -math.sqrt(v28)
            work[720 + k] = -math.sqrt(v29)
            work[736 + k] = -math.sqrt(v30)
            work[752 + k] = -math.sqrt(v31)
            work[768 + k] = v44
            work[784 + k] = v45
            work[800 + k] = v46
            work[816 + k] = v47
            work[832 + k] = s1_p
            work[848 + k] = s1_m
            work[864 + k] = N3 - k6
            work[880 + k] = C2_pp
            work[896 + k] = C2_pm
            work[912 + k] = C2_pm
            work[928 + k] = C2_pp
            work[944 + k] = factor2_pp * -X4_pp
            work[960 + k] = factor2_pm * -X4_pm
            work[976 + k] = factor2_mp * -X4_mp
            work[992 + k] = factor2_pp * -X4_mm
            work[1008 + k] = factor2_pp * (v34 + s23_pp * v22)
            work[1024 + k] = factor2_pm * (v35 + s23_pm * v22)
            work[1040 + k] = factor2_mp * (v35 + s23_mp * v23)
            work[1056 + k] = factor2_pp * (v34 + s23_mm * v23)
            work[1072 + k] = -X4_pp * v40 - v24 * (T31 * s23_pp - C2_pm * v42)
            work[1088 + k] = -X4_pm * v40 - v24 * (T31 * s23_pm - C2_pp * v42)
            work[1104 + k] = -X4_mp * v41 - v25 * (T31 * s23_mp - C2_pp * v43)
            work[1120 + k] = -X4_mm * v41 - v25 * (T31 * s23_mm - C2_pm * v43)
            work[1136 + k] = c1_p
            work[1152 + k] = c1_m
        for k in range(560, 864):
            work[k] = _atan2(work[k], work[k + 304])
        for k in range(0, 16):
            D1 = work[272 + k]
            w1 = work[288 + k]
            v1 = work[304 + k]
            D3_ = work[320 + k]
            v6 = work[336 + k]
            v13 = work[352 + k]
            v15 = work[368 + k]
            v16 = work[384 + k]
            v28 = work[400 + k]
            v29 = work[416 + k]
            v30 = work[432 + k]
            v31 = work[448 + k]
            v32 = work[464 + k]
            v33 = work[480 + k]
            v44 = work[496 + k]
            v45 = work[512 + k]
            v46 = work[528 + k]
            v47 = work[544 + k]
            angle1 = work[560 + k]
            angle2 = work[576 + k]
            angle3 = work[592 + k]
            angle4 = work[608 + k]
            angle5 = work[624 + k]
            angle6 = work[640 + k]
            angle7 = work[656 + k]
            angle8 = work[672 + k]
            angle9 = work[688 + k]
            angle10 = work[704 + k]
            angle11 = work[720 + k]
            angle12 = work[736 + k]
            angle13 = work[752 + k]
            angle14 = work[768 + k]
            angle15 = work[784 + k]
            angle16 = work[800 + k]
            angle17 = work[816 + k]
            angle18 = work[832 + k]
            angle19 = work[848 + k]
            q4_ppm = angle6 - v32
            q4_pmm = angle7 - v32
            q4_mpm = angle8 - v33
            q4_mmm = angle9 - v33
            q6_ppm = angle14 - math.copysign(half_turn, v44)
            q6_pmm = angle15 - math.copysign(half_turn, v45)
            q6_mpm = angle16 - math.copysign(half_turn, v46)
            q6_mmm = angle17 - math.copysign(half_turn, v47)
            q1_ppp = v6 + angle18
            q1_mpp = v6 + angle19
            q3_ppp = v1 + angle1
            q3_pmp = v1 - angle1
            _1168 = q1_ppp
            work[1168 + k] = _1168
            _1184 = angle2
            work[1184 + k] = _1184
            _1200 = q3_ppp
            work[1200 + k] = _1200
            _1216 = angle6
            work[1216 + k] = _1216
            _1232 = angle10
            work[1232 + k] = _1232
            _1248 = angle14
            work[1248 + k] = _1248
            _1264 = q4_ppm
            work[1264 + k] = _1264
            _1280 = -angle10
            work[1280 + k] = _1280
            _1296 = q6_ppm
            work[1296 + k] = _1296
            _1312 = angle3
            work[1312 + k] = _1312
            _1328 = q3_pmp
            work[1328 + k] = _1328
            _1344 = angle7
            work[1344 + k] = _1344
            _1360 = angle11
            work[1360 + k] = _1360
            _1376 = angle15
            work[1376 + k] = _1376
            _1392 = q4_pmm
            work[1392 + k] = _1392
            _1408 = -angle11
            work[1408 + k] = _1408
            _1424 = q6_pmm
            work[1424 + k] = _1424
            _1440 = q1_mpp
            work[1440 + k] = _1440
            _1456 = angle4
            work[1456 + k] = _1456
            _1472 = angle8
            work[1472 + k] = _1472
            _1488 = angle12
            work[1488 + k] = _1488
            _1504 = angle16
            work[1504 + k] = _1504
            _1520 = q4_mpm
            work[1520 + k] = _1520
            _1536 = -angle12
            work[1536 + k] = _1536
            _1552 = q6_mpm
            work[1552 + k] = _1552
            _1568 = angle5
            work[1568 + k] = _1568
            _1584 = angle9
            work[1584 + k] = _1584
            _1600 = angle13
            work[1600 + k] = _1600
            _1616 = angle17
            work[1616 + k] = _1616
            _1632 = q4_mmm
            work[1632 + k] = _1632
            _1648 = -angle13
            work[1648 + k] = _1648
            _1664 = q6_mmm
            work[1664 + k] = _1664
            work[1680 + k] = UNREACHABLE if _1168 != _1168 else OK
            work[1696 + k] = UNREACHABLE if _1168 != _1168 else OK
            work[1712 + k] = UNREACHABLE if _1168 != _1168 else OK
            work[1728 + k] = UNREACHABLE if _1168 != _1168 else OK
            work[1744 + k] = UNREACHABLE if _1440 != _1440 else OK
            work[1760 + k] = UNREACHABLE if _1440 != _1440 else OK
            work[1776 + k] = UNREACHABLE if _1440 != _1440 else OK
            work[1792 + k] = UNREACHABLE if _1440 != _1440 else OK
            work[256 + k] = (
                1.0 if v31 <= m7 or v30 <= m7 or v16 <= m4 or v29 <= m7 or v15 <= m4 or v28 <= m7 or
                abs(D1) <= m1 or abs(D3_ * (k5 * w1)) <= m2 or v13 <= m4 else work[256 + k]
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
