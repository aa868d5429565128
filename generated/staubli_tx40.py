"""staubli_tx40: Stäubli TX40.

Inverse kinematics, generated from robots/staubli_tx40.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/staubli_tx40.yaml. The formulas and where they come from:
staubli_tx40.md.

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

NAME = "staubli_tx40"
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

d1 = 0.32  # joint offset 1 [m]
a2 = 0.225  # link length 2 [m]
d3 = 0.035  # joint offset 3 [m]
d4 = 0.225  # joint offset 4 [m]
d6 = 0.065  # joint offset 6 [m]
free_limit_squared2 = 7.5690000000000015e-25  # square of a length that fixes no angle [m^2]
least_root1 = 2.75118156434649e-07  # a root of nothing, by rounding [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
longest3 = 0.2025  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
boundary3 = 1.5849821455311018e-14  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.20249999999999216  # the longest, where branches merge [m^2]
shortest3_apart = 7.569000000000003e-29  # the shortest, where branches merge [m^2]
offset2 = 1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset3 = 1.5707963267948966  # offset of joint 3 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
k1 = 0.0012250000000000002  # d3^2 [m^2]
k2 = 6.09000000000757e-15  # reach_slack1 * (2 * d3 + reach_slack1) [m^2]
k3 = 6.090000000000759e-16  # merge_slack1 * (2 * d3 + merge_slack1) [m^2]
k4 = 1.1494252873563218  # 1 / arm_size1 [m^-1]
k5 = 0.10125  # 2 * d4 * a2 [m^2]
k6 = 97.54610577655845  # 1 / (k5^2) [m^-4]
m1 = 6.090000000000759e-13  # 1000 * k3 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 1.5906026495925924e-12
m3 = 2.2222222222222223  # a coefficient of S2
m4 = 5.728976100000003e-17  # doubt_limit_squared2^2 [m^4]
m5 = 21.947873799725652  # a coefficient of v10
m6 = 4.4444444444444455  # a coefficient of s23
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
    v1 = q[0] + offset1
    c1 = math.cos(v1)
    s1 = math.sin(v1)
    v2 = q[1] + offset2
    c2 = math.cos(v2)
    s2 = math.sin(v2)
    x2_x = c1 * c2
    x2_y = s1 * c2
    v3 = c1 * s2
    v4 = s1 * s2
    v5 = q[2] + offset3
    c3 = math.cos(v5)
    s3 = math.sin(v5)
    x3_x = x2_x * c3 - v3 * s3
    x3_y = x2_y * c3 - v4 * s3
    x3_z = s2 * c3 + c2 * s3
    z3_x = v3 * c3 + x2_x * s3
    z3_y = v4 * c3 + x2_y * s3
    z3_z = s2 * s3 - c2 * c3
    v6 = q[3] + offset4
    c4 = math.cos(v6)
    s4 = math.sin(v6)
    x4_x = x3_x * c4 + s1 * s4
    x4_y = x3_y * c4 - c1 * s4
    x4_z = x3_z * c4
    z4_y = c1 * c4 + x3_y * s4
    z4_z = x3_z * s4
    z4_x = x3_x * s4 - s1 * c4
    v7 = q[4] + offset5
    c5 = math.cos(v7)
    s5 = math.sin(v7)
    x5_x = x4_x * c5 + z3_x * s5
    x5_y = x4_y * c5 + z3_y * s5
    x5_z = x4_z * c5 + z3_z * s5
    z5_x = x4_x * s5 - z3_x * c5
    z5_y = x4_y * s5 - z3_y * c5
    z5_z = x4_z * s5 - z3_z * c5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 + z4_x * s6
    T[0, 1] = z4_x * c6 - x5_x * s6
    T[0, 2] = z5_x
    T[0, 3] = x2_x * a2 + s1 * d3 + z3_x * d4 + z5_x * d6
    T[1, 0] = x5_y * c6 + z4_y * s6
    T[1, 1] = z4_y * c6 - x5_y * s6
    T[1, 2] = z5_y
    T[1, 3] = x2_y * a2 - c1 * d3 + z3_y * d4 + z5_y * d6
    T[2, 0] = x5_z * c6 + z4_z * s6
    T[2, 1] = z4_z * c6 - x5_z * s6
    T[2, 2] = z5_z
    T[2, 3] = d1 + s2 * a2 + z3_z * d4 + z5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    J = np.zeros((6, 6))
    v1 = q[0] + offset1
    c1 = math.cos(v1)
    s1 = math.sin(v1)
    v2 = q[1] + offset2
    c2 = math.cos(v2)
    s2 = math.sin(v2)
    x2_x = c1 * c2
    x2_y = s1 * c2
    v3 = c1 * s2
    v4 = s1 * s2
    p2_x = x2_x * a2
    p2_y = x2_y * a2
    p2_z = d1 + s2 * a2
    v5 = q[2] + offset3
    c3 = math.cos(v5)
    s3 = math.sin(v5)
    x3_x = x2_x * c3 - v3 * s3
    x3_y = x2_y * c3 - v4 * s3
    x3_z = s2 * c3 + c2 * s3
    z3_x = v3 * c3 + x2_x * s3
    z3_y = v4 * c3 + x2_y * s3
    p3_x = p2_x + s1 * d3
    p3_y = p2_y - c1 * d3
    z3_z = s2 * s3 - c2 * c3
    v6 = q[3] + offset4
    c4 = math.cos(v6)
    s4 = math.sin(v6)
    z4_y = c1 * c4 + x3_y * s4
    z4_z = x3_z * s4
    p4_x = p3_x + z3_x * d4
    p4_y = p3_y + z3_y * d4
    p4_z = p2_z + z3_z * d4
    z4_x = x3_x * s4 - s1 * c4
    v7 = q[4] + offset5
    c5 = math.cos(v7)
    s5 = math.sin(v7)
    z5_x = (x3_x * c4 + s1 * s4) * s5 - z3_x * c5
    z5_y = (x3_y * c4 - c1 * s4) * s5 - z3_y * c5
    z5_z = x3_z * c4 * s5 - z3_z * c5
    p6_x = p4_x + z5_x * d6
    p6_y = p4_y + z5_y * d6
    p6_z = p4_z + z5_z * d6
    v8 = p6_z - d1
    v9 = p6_z - p2_z
    v10 = p6_x - p3_x
    v11 = p6_y - p3_y
    v12 = p6_x - p4_x
    v13 = p6_y - p4_y
    v14 = p6_z - p4_z
    J[0, 0] = -p6_y
    J[0, 1] = -(c1 * v8)
    J[0, 2] = -(c1 * v9)
    J[0, 3] = z3_y * v9 - z3_z * v11
    J[0, 4] = z4_y * v14 - z4_z * v13
    J[0, 5] = z5_y * v14 - z5_z * v13
    J[1, 0] = p6_x
    J[1, 1] = -(s1 * v8)
    J[1, 2] = -(s1 * v9)
    J[1, 3] = z3_z * v10 - z3_x * v9
    J[1, 4] = z4_z * v12 - z4_x * v14
    J[1, 5] = z5_z * v12 - z5_x * v14
    J[2, 1] = s1 * p6_y + c1 * p6_x
    J[2, 2] = s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x)
    J[2, 3] = z3_x * v11 - z3_y * v10
    J[2, 4] = z4_x * v13 - z4_y * v12
    J[2, 5] = z5_x * v13 - z5_y * v12
    J[3, 1] = s1
    J[3, 2] = s1
    J[3, 3] = z3_x
    J[3, 4] = z4_x
    J[3, 5] = z5_x
    J[4, 1] = -c1
    J[4, 2] = -c1
    J[4, 3] = z3_y
    J[4, 4] = z4_y
    J[4, 5] = z5_y
    J[5, 0] = 1.0
    J[5, 3] = z3_z
    J[5, 4] = z4_z
    J[5, 5] = z5_z
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1 A6^-1 [3, 4]
    X1 = T13 * d6 - T14
    wy = T24 - d6 * T23
    N1 = X1 * X1 + wy * wy
    free1 = N1 <= free_limit_squared2
    D1 = N1 - k1
    apart1 = k3 < D1
    if not (-k2 <= D1):
        return  # out of reach
    w1 = math.sqrt(D1 if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else d3 * math.sqrt(N1)))
    v1 = X1 * d3
    v2 = wy * d3
    v3 = seed[0] + offset1

    # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = T34 - d6 * T33
    Z1_3 = wz - d1
    v4 = Z1_3 * Z1_3
    v5 = 1.0 if free1 else (w1 if apart1 else least_root1) * k4

    # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    v9 = seed[1] + offset2

    # theta4, type 2: U4[3, 3]
    v13 = seed[3] + offset4

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        root1 = w1 * e1
        c1 = math.cos(v3) if free1 else -(inverse1 * (v2 + X1 * root1))
        s1 = math.sin(v3) if free1 else inverse1 * (wy * root1 - v1)

        # theta3
        N3 = v4 + root1 * root1
        K3 = N3 - k5
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= D3 * v5):
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        s3 = k5 * K3 * k6

        # theta2
        X1_2 = a2 + d4 * s3
        v7 = Z1_3 * X1_2
        v8 = root1 * X1_2

        # theta4
        v11 = T13 * c1 + T23 * s1
        Y4 = T13 * s1 - T23 * c1
        v12 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v14 = T22 * c1 - T12 * s1
        v15 = T12 * c1 + T22 * s1
        v17 = T21 * c1 - T11 * s1
        v18 = T11 * c1 + T21 * s1

        # joint values
        q1 = _wrap(_atan2(s1, c1) - offset1)

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            v6 = k6 * (k5 * (w3 * e2))

            # theta2
            Y1_2 = d4 * v6
            S2 = v7 - root1 * Y1_2
            C2 = v8 + Z1_3 * Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v9) if free2 else C2 * factor2
            s2 = math.sin(v9) if free2 else S2 * factor2

            # theta4
            v10 = v6 * c2 + s3 * s2
            s23 = s3 * c2 - v6 * s2
            X4 = v10 * v11 - T33 * s23
            w4 = math.sqrt(X4 * X4 + v12)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta6
            v16 = T32 * s23 - v10 * v15
            v19 = T31 * s23 - v10 * v18

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(s3, -v6) - offset3)

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4
                if e3 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e3 / divisor4
                c4 = math.cos(v13) if free4 else -(X4 * factor4)
                s4 = math.sin(v13) if free4 else Y4 * factor4
                s5 = w4 * e3

                # theta6
                c6 = c4 * v14 + s4 * v16
                s6 = c4 * v17 + s4 * v19
                q6 = _atan2(s6, c6)

                # joint values
                q4 = _wrap(_atan2(s4, c4) - offset4)
                q5 = _wrap(_atan2(s5, -(T33 * v10 + s23 * v11)) - offset5)
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
_MISS_WEIGHT = np.array([1.149, 1.149, 1.149, 1.0, 1.0, 1.0])


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

    # theta1, type 2: U1 A6^-1 [3, 4]
    X1 = d6 * T13 - T14
    wy = T24 - d6 * T23
    N1 = X1 * X1 + wy * wy
    D1 = N1 - k1
    w1 = math.sqrt(D1)
    v1 = w1 - w1
    inverse1 = 1.0 / N1
    v2 = inverse1 * (d3 * wy)
    v3 = v2 + w1 * (X1 * inverse1)
    v4 = v2 + w1 * (inverse1 * -X1)
    v5 = inverse1 * (d3 * X1)
    s1_p = w1 * (wy * inverse1) - v5
    s1_m = w1 * (inverse1 * -wy) - v5

    # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    Z1_3 = T34 - d6 * T33 - d1
    N3 = D1 + Z1_3 * Z1_3
    D3 = (longest3 - N3) * (N3 - shortest3)
    w3 = math.sqrt(D3)
    v6 = w3 - w3
    v7 = k5 * (N3 - k5)

    # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    v8 = m3 * (Z1_3 * N3)
    v9 = w3 * (m3 * w1)
    S2_pp = v8 - v9
    S2_pm = v8 + v9
    v10 = w3 * (m3 * Z1_3)
    v11 = w3 * (m3 * -Z1_3)
    v12 = m3 * (w1 * N3)
    C2_pp = v10 + v12
    C2_pm = v11 + v12
    C2_mp = v10 - v12
    C2_mm = v11 - v12
    v13 = S2_pp * S2_pp
    v14 = v13 + C2_pp * C2_pp
    v15 = S2_pm * S2_pm
    v16 = v15 + C2_pm * C2_pm
    v17 = v15 + C2_mp * C2_mp
    v18 = v13 + C2_mm * C2_mm
    factor2_pp = math.sqrt(v14) * (1.0 / v14)
    factor2_pm = math.sqrt(v16) * (1.0 / v16)
    factor2_mp = math.sqrt(v17) * (1.0 / v17)
    factor2_mm = math.sqrt(v18) * (1.0 / v18)

    # theta4, type 2: U4[3, 3]
    v19 = m5 * N3
    v20 = v19 - m3
    v21 = m6 - v19
    v22 = w1 * (N3 * (v20 + v21))
    s23_pp = v22 - v10
    s23_pm = v22 - v11
    v23 = w1 * (N3 * (-v20 + -v21))
    s23_mp = v23 - v10
    s23_mm = v23 - v11
    v24 = T23 * s1_p - T13 * v3
    v25 = T23 * s1_m - T13 * v4
    X4_pp = S2_pm * v24 - T33 * s23_pp
    X4_pm = S2_pp * v24 - T33 * s23_pm
    X4_mp = S2_pp * v25 - T33 * s23_mp
    X4_mm = S2_pm * v25 - T33 * s23_mm
    Y4_p = T13 * s1_p + T23 * v3
    Y4_m = T13 * s1_m + T23 * v4
    v26 = Y4_p * Y4_p
    v27 = Y4_m * Y4_m
    v28 = v26 + factor2_pp * (X4_pp * (factor2_pp * X4_pp))
    v29 = v26 + factor2_pm * (X4_pm * (factor2_pm * X4_pm))
    v30 = v27 + factor2_mp * (X4_mp * (factor2_mp * X4_mp))
    v31 = v27 + factor2_mm * (X4_mm * (factor2_mm * X4_mm))

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v32 = v3 * T22 + s1_p * T12
    v33 = v4 * T22 + s1_m * T12
    v34 = s1_p * T22 - v3 * T12
    v35 = s1_m * T22 - v4 * T12
    v36 = v3 * T21 + s1_p * T11
    v37 = v4 * T21 + s1_m * T11
    v38 = s1_p * T21 - v3 * T11
    v39 = s1_m * T21 - v4 * T11
    s6_pp = Y4_p * (s23_pp * T31 - S2_pm * v38) - v36 * -X4_pp
    s6_pm = Y4_p * (s23_pm * T31 - S2_pp * v38) - v36 * -X4_pm
    s6_mp = Y4_m * (s23_mp * T31 - S2_pp * v39) - v37 * -X4_mp
    s6_mm = Y4_m * (s23_mm * T31 - S2_pm * v39) - v37 * -X4_mm

    # joint values
    v48 = math.copysign(half_turn, Y4_p)
    v49 = math.copysign(half_turn, Y4_m)
    v58 = T33 * S2_pm
    v59 = T33 * S2_pp

    # a joint is free, or branches meet
    if (
        v31 <= m7 or v18 <= m4 or v30 <= m7 or v17 <= m4 or v29 <= m7 or v16 <= m4 or v28 <= m7 or
        abs(D1) <= m1 or abs(D3 * (k4 * w1)) <= m2 or v14 <= m4
    ):
        return False

    # angles, side by side
    room[0] = s6_pp
    room[1] = s6_pm
    room[2] = s6_mp
    room[3] = s6_mm
    room[4] = s1_p
    room[5] = s1_m
    room[6] = S2_pp
    room[7] = S2_pm
    room[8] = S2_pm
    room[9] = S2_pp
    room[10] = v7
    room[11] = Y4_p
    room[12] = Y4_p
    room[13] = Y4_m
    room[14] = Y4_m
    room[15] = math.sqrt(v28)
    room[16] = math.sqrt(v29)
    room[17] = math.sqrt(v30)
    room[18] = math.sqrt(v31)
    room[24] = Y4_p * (s23_pp * T32 - S2_pm * v34) - v32 * -X4_pp
    room[25] = Y4_p * (s23_pm * T32 - S2_pp * v34) - v32 * -X4_pm
    room[26] = Y4_m * (s23_mp * T32 - S2_pp * v35) - v33 * -X4_mp
    room[27] = Y4_m * (s23_mm * T32 - S2_pm * v35) - v33 * -X4_mm
    room[28] = -v3
    room[29] = -v4
    room[30] = C2_pp
    room[31] = C2_pm
    room[32] = C2_mp
    room[33] = C2_mm
    room[34] = -(k5 * w3)
    room[35] = factor2_pp * -X4_pp
    room[36] = factor2_pm * -X4_pm
    room[37] = factor2_mp * -X4_mp
    room[38] = factor2_mm * -X4_mm
    room[39] = -(factor2_pp * (v58 + s23_pp * v24))
    room[40] = -(factor2_pm * (v59 + s23_pm * v24))
    room[41] = -(factor2_mp * (v59 + s23_mp * v25))
    room[42] = -(factor2_mm * (v58 + s23_mm * v25))
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

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    q6_ppm = angle1 - math.copysign(half_turn, s6_pp)
    q6_pmm = angle2 - math.copysign(half_turn, s6_pm)
    q6_mpm = angle3 - math.copysign(half_turn, s6_mp)
    q6_mmm = angle4 - math.copysign(half_turn, s6_mm)

    # joint values
    v40 = angle5 - offset1
    v41 = angle6 - offset1
    v42 = angle7 - offset2
    v43 = angle8 - offset2
    v44 = angle9 - offset2
    v45 = angle10 - offset2
    q2_ppp = v42 + (turn if v42 <= -half_turn else 0.0)
    q2_pmp = v43 + (turn if v43 <= -half_turn else 0.0)
    q2_mpp = v44 + (turn if v44 <= -half_turn else 0.0)
    q2_mmp = v45 + (turn if v45 <= -half_turn else 0.0)
    v46 = angle11 - offset3
    v47 = math.copysign(half_turn, v7) - angle11 - offset3
    v50 = angle12 - offset4
    v51 = angle12 - v48 - offset4
    v52 = angle13 - offset4
    v53 = angle13 - v48 - offset4
    v54 = angle14 - offset4
    v55 = angle14 - v49 - offset4
    v56 = angle15 - offset4
    v57 = angle15 - v49 - offset4
    q4_ppp = v50 + (turn if v50 <= -half_turn else 0.0)
    q4_ppm = v51 + (turn if v51 <= -half_turn else 0.0)
    q4_pmp = v52 + (turn if v52 <= -half_turn else 0.0)
    q4_pmm = v53 + (turn if v53 <= -half_turn else 0.0)
    q4_mpp = v54 + (turn if v54 <= -half_turn else 0.0)
    q4_mpm = v55 + (turn if v55 <= -half_turn else 0.0)
    q4_mmp = v56 + (turn if v56 <= -half_turn else 0.0)
    q4_mmm = v57 + (turn if v57 <= -half_turn else 0.0)
    v60 = angle16 - offset5
    v61 = offset5 + angle16
    v62 = angle17 - offset5
    v63 = offset5 + angle17
    v64 = angle18 - offset5
    v65 = offset5 + angle18
    v66 = angle19 - offset5
    v67 = offset5 + angle19
    q5_ppp = v60 + (turn if v60 <= -half_turn else 0.0)
    q5_ppm = (turn if -v61 <= -half_turn else 0.0) - v61
    q5_pmp = v62 + (turn if v62 <= -half_turn else 0.0)
    q5_pmm = (turn if -v63 <= -half_turn else 0.0) - v63
    q5_mpp = v64 + (turn if v64 <= -half_turn else 0.0)
    q5_mpm = (turn if -v65 <= -half_turn else 0.0) - v65
    q5_mmp = v66 + (turn if v66 <= -half_turn else 0.0)
    q5_mmm = (turn if -v67 <= -half_turn else 0.0) - v67
    q1_ppp = v6 + (v40 + (turn if v40 <= -half_turn else 0.0))
    q1_mpp = v6 + (v41 + (turn if v41 <= -half_turn else 0.0))
    q3_ppp = v1 + (v46 + (turn if v46 <= -half_turn else 0.0))
    q3_pmp = v1 + (v47 + (turn if v47 <= -half_turn else 0.0))

    q[0, 0] = q1_ppp
    q[0, 1] = q2_ppp
    q[0, 2] = q3_ppp
    q[0, 3] = q4_ppp
    q[0, 4] = q5_ppp
    q[0, 5] = angle1
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_ppp
    q[1, 1] = q2_ppp
    q[1, 2] = q3_ppp
    q[1, 3] = q4_ppm
    q[1, 4] = q5_ppm
    q[1, 5] = q6_ppm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = q1_ppp
    q[2, 1] = q2_pmp
    q[2, 2] = q3_pmp
    q[2, 3] = q4_pmp
    q[2, 4] = q5_pmp
    q[2, 5] = angle2
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = q1_ppp
    q[3, 1] = q2_pmp
    q[3, 2] = q3_pmp
    q[3, 3] = q4_pmm
    q[3, 4] = q5_pmm
    q[3, 5] = q6_pmm
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else OK
    q[4, 0] = q1_mpp
    q[4, 1] = q2_mpp
    q[4, 2] = q3_ppp
    q[4, 3] = q4_mpp
    q[4, 4] = q5_mpp
    q[4, 5] = angle3
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else OK
    q[5, 0] = q1_mpp
    q[5, 1] = q2_mpp
    q[5, 2] = q3_ppp
    q[5, 3] = q4_mpm
    q[5, 4] = q5_mpm
    q[5, 5] = q6_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else OK
    q[6, 0] = q1_mpp
    q[6, 1] = q2_mmp
    q[6, 2] = q3_pmp
    q[6, 3] = q4_mmp
    q[6, 4] = q5_mmp
    q[6, 5] = angle4
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else OK
    q[7, 0] = q1_mpp
    q[7, 1] = q2_mmp
    q[7, 2] = q3_pmp
    q[7, 3] = q4_mmm
    q[7, 4] = q5_mmm
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
    [1200, 1216, 1232, 1248, 1264, 1280],
    [1200, 1216, 1232, 1296, 1312, 1328],
    [1200, 1344, 1360, 1376, 1392, 1408],
    [1200, 1344, 1360, 1424, 1440, 1456],
    [1472, 1488, 1232, 1504, 1520, 1536],
    [1472, 1488, 1232, 1552, 1568, 1584],
    [1472, 1600, 1360, 1616, 1632, 1648],
    [1472, 1600, 1360, 1664, 1680, 1696],
])
_KINDS = np.array([1712, 1728, 1744, 1760, 1776, 1792, 1808, 1824])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(1840), 1840)
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
            X1 = d6 * T13 - T14
            wy = T24 - d6 * T23
            N1 = X1 * X1 + wy * wy
            D1 = N1 - k1
            w1 = math.sqrt(D1)
            v1 = w1 - w1
            inverse1 = 1.0 / N1
            v2 = inverse1 * (d3 * wy)
            v3 = v2 + w1 * (X1 * inverse1)
            v4 = v2 + w1 * (inverse1 * -X1)
            v5 = inverse1 * (d3 * X1)
            s1_p = w1 * (wy * inverse1) - v5
            s1_m = w1 * (inverse1 * -wy) - v5
            Z1_3 = T34 - d6 * T33 - d1
            N3 = D1 + Z1_3 * Z1_3
            D3 = (longest3 - N3) * (N3 - shortest3)
            w3 = math.sqrt(D3)
            v6 = w3 - w3
            v7 = k5 * (N3 - k5)
            v8 = m3 * (Z1_3 * N3)
            v9 = w3 * (m3 * w1)
            S2_pp = v8 - v9
            S2_pm = v8 + v9
            v10 = w3 * (m3 * Z1_3)
            v11 = w3 * (m3 * -Z1_3)
            v12 = m3 * (w1 * N3)
            C2_pp = v10 + v12
            C2_pm = v11 + v12
            C2_mp = v10 - v12
            C2_mm = v11 - v12
            v13 = S2_pp * S2_pp
            v14 = v13 + C2_pp * C2_pp
            v15 = S2_pm * S2_pm
            v16 = v15 + C2_pm * C2_pm
            v17 = v15 + C2_mp * C2_mp
            v18 = v13 + C2_mm * C2_mm
            factor2_pp = math.sqrt(v14) * (1.0 / v14)
            factor2_pm = math.sqrt(v16) * (1.0 / v16)
            factor2_mp = math.sqrt(v17) * (1.0 / v17)
            factor2_mm = math.sqrt(v18) * (1.0 / v18)
            v19 = m5 * N3
            v20 = v19 - m3
            v21 = m6 - v19
            v22 = w1 * (N3 * (v20 + v21))
            s23_pp = v22 - v10
            s23_pm = v22 - v11
            v23 = w1 * (N3 * (-v20 + -v21))
            s23_mp = v23 - v10
            s23_mm = v23 - v11
            v24 = T23 * s1_p - T13 * v3
            v25 = T23 * s1_m - T13 * v4
            X4_pp = S2_pm * v24 - T33 * s23_pp
            X4_pm = S2_pp * v24 - T33 * s23_pm
            X4_mp = S2_pp * v25 - T33 * s23_mp
            X4_mm = S2_pm * v25 - T33 * s23_mm
            Y4_p = T13 * s1_p + T23 * v3
            Y4_m = T13 * s1_m + T23 * v4
            v26 = Y4_p * Y4_p
            v27 = Y4_m * Y4_m
            v28 = v26 + factor2_pp * (X4_pp * (factor2_pp * X4_pp))
            v29 = v26 + factor2_pm * (X4_pm * (factor2_pm * X4_pm))
            v30 = v27 + factor2_mp * (X4_mp * (factor2_mp * X4_mp))
            v31 = v27 + factor2_mm * (X4_mm * (factor2_mm * X4_mm))
            v32 = v3 * T22 + s1_p * T12
            v33 = v4 * T22 + s1_m * T12
            v34 = s1_p * T22 - v3 * T12
            v35 = s1_m * T22 - v4 * T12
            v36 = v3 * T21 + s1_p * T11
            v37 = v4 * T21 + s1_m * T11
            v38 = s1_p * T21 - v3 * T11
            v39 = s1_m * T21 - v4 * T11
            s6_pp = Y4_p * (s23_pp * T31 - S2_pm * v38) - v36 * -X4_pp
            s6_pm = Y4_p * (s23_pm * T31 - S2_pp * v38) - v36 * -X4_pm
            s6_mp = Y4_m * (s23_mp * T31 - S2_pp * v39) - v37 * -X4_mp
            s6_mm = Y4_m * (s23_mm * T31 - S2_pm * v39) - v37 * -X4_mm
            v48 = math.copysign(half_turn, Y4_p)
            v49 = math.copysign(half_turn, Y4_m)
            v58 = T33 * S2_pm
            v59 = T33 * S2_pp
            work[272 + k] = D1
            work[288 + k] = w1
            work[304 + k] = v1
            work[320 + k] = D3
            work[336 + k] = v6
            work[352 + k] = v7
            work[368 + k] = v14
            work[384 + k] = v16
            work[400 + k] = v17
            work[416 + k] = v18
            work[432 + k] = v28
            work[448 + k] = v29
            work[464 + k] = v30
            work[480 + k] = v31
            work[496 + k] = s6_pp
            work[512 + k] = s6_pm
            work[528 + k] = s6_mp
            work[544 + k] = s6_mm
            work[560 + k] = v48
            work[576 + k] = v49
            work[592 + k] = s6_pp
            work[608 + k] = s6_pm
            work[624 + k] = s6_mp
            work[640 + k] = s6_mm
            work[656 + k] = s1_p
            work[672 + k] = s1_m
            work[688 + k] = S2_pp
            work[704 + k] = S2_pm
            work[720 + k] = S2_pm
            work[736 + k] = S2_pp
            work[752 + k] = v7
            work[768 + k] = Y4_p
            work[784 + k] = Y4_p
            work[800 + k] = Y4_m
            work[816 + k] = Y4_m
            work[832 + k] = math.sqrt(v28)
            work[848 + k] = math.sqrt(v29)
            work[864 + k] = math.sqrt(v30)
            work[880 + k] = math.sqrt(v31)
            work[896 + k] = Y4_p * (s23_pp * T32 - S2_pm * v34) - v32 * -X4_pp
            work[912 + k] = Y4_p * (s23_pm * T32 - S2_pp * v34) - v32 * -X4_pm
            work[928 + k] = Y4_m * (s23_mp * T32 - S2_pp * v35) - v33 * -X4_mp
            work[944 + k] = Y4_m * (s23_mm * T32 - S2_pm * v35) - v33 * -X4_mm
            work[960 + k] = -v3
            work[976 + k] = -v4
            work[992 + k] = C2_pp
            work[1008 + k] = C2_pm
            work[1024 + k] = C2_mp
            work[1040 + k] = C2_mm
            work[1056 + k] = -(k5 * w3)
            work[1072 + k] = factor2_pp * -X4_pp
            work[1088 + k] = factor2_pm * -X4_pm
            work[1104 + k] = factor2_mp * -X4_mp
            work[1120 + k] = factor2_mm * -X4_mm
            work[1136 + k] = -(factor2_pp * (v58 + s23_pp * v24))
            work[1152 + k] = -(factor2_pm * (v59 + s23_pm * v24))
            work[1168 + k] = -(factor2_mp * (v59 + s23_mp * v25))
            work[1184 + k] = -(factor2_mm * (v58 + s23_mm * v25))
        for k in range(592, 896):
            work[k] = _atan2(work[k], work[k + 304])
        for k in range(0, 16):
            D1 = work[272 + k]
            w1 = work[288 + k]
            v1 = work[304 + k]
            D3 = work[320 + k]
            v6 = work[336 + k]
            v7 = work[352 + k]
            v14 = work[368 + k]
            v16 = work[384 + k]
            v17 = work[400 + k]
            v18 = work[416 + k]
            v28 = work[432 + k]
            v29 = work[448 + k]
            v30 = work[464 + k]
            v31 = work[480 + k]
            s6_pp = work[496 + k]
            s6_pm = work[512 + k]
            s6_mp = work[528 + k]
            s6_mm = work[544 + k]
            v48 = work[560 + k]
            v49 = work[576 + k]
            angle1 = work[592 + k]
            angle2 = work[608 + k]
            angle3 = work[624 + k]
            angle4 = work[640 + k]
            angle5 = work[656 + k]
            angle6 = work[672 + k]
            angle7 = work[688 + k]
            angle8 = work[704 + k]
            angle9 = work[720 + k]
            angle10 = work[736 + k]
            angle11 = work[752 + k]
            angle12 = work[768 + k]
            angle13 = work[784 + k]
            angle14 = work[800 + k]
            angle15 = work[816 + k]
            angle16 = work[832 + k]
            angle17 = work[848 + k]
            angle18 = work[864 + k]
            angle19 = work[880 + k]
            q6_ppm = angle1 - math.copysign(half_turn, s6_pp)
            q6_pmm = angle2 - math.copysign(half_turn, s6_pm)
            q6_mpm = angle3 - math.copysign(half_turn, s6_mp)
            q6_mmm = angle4 - math.copysign(half_turn, s6_mm)
            v40 = angle5 - offset1
            v41 = angle6 - offset1
            v42 = angle7 - offset2
            v43 = angle8 - offset2
            v44 = angle9 - offset2
            v45 = angle10 - offset2
            q2_ppp = v42 + (turn if v42 <= -half_turn else 0.0)
            q2_pmp = v43 + (turn if v43 <= -half_turn else 0.0)
            q2_mpp = v44 + (turn if v44 <= -half_turn else 0.0)
            q2_mmp = v45 + (turn if v45 <= -half_turn else 0.0)
            v46 = angle11 - offset3
            v47 = math.copysign(half_turn, v7) - angle11 - offset3
            v50 = angle12 - offset4
            v51 = angle12 - v48 - offset4
            v52 = angle13 - offset4
            v53 = angle13 - v48 - offset4
            v54 = angle14 - offset4
            v55 = angle14 - v49 - offset4
            v56 = angle15 - offset4
            v57 = angle15 - v49 - offset4
            q4_ppp = v50 + (turn if v50 <= -half_turn else 0.0)
            q4_ppm = v51 + (turn if v51 <= -half_turn else 0.0)
            q4_pmp = v52 + (turn if v52 <= -half_turn else 0.0)
            q4_pmm = v53 + (turn if v53 <= -half_turn else 0.0)
            q4_mpp = v54 + (turn if v54 <= -half_turn else 0.0)
            q4_mpm = v55 + (turn if v55 <= -half_turn else 0.0)
            q4_mmp = v56 + (turn if v56 <= -half_turn else 0.0)
            q4_mmm = v57 + (turn if v57 <= -half_turn else 0.0)
            v60 = angle16 - offset5
            v61 = offset5 + angle16
            v62 = angle17 - offset5
            v63 = offset5 + angle17
            v64 = angle18 - offset5
            v65 = offset5 + angle18
            v66 = angle19 - offset5
            v67 = offset5 + angle19
            q5_ppp = v60 + (turn if v60 <= -half_turn else 0.0)
            q5_ppm = (turn if -v61 <= -half_turn else 0.0) - v61
            q5_pmp = v62 + (turn if v62 <= -half_turn else 0.0)
            q5_pmm = (turn if -v63 <= -half_turn else 0.0) - v63
            q5_mpp = v64 + (turn if v64 <= -half_turn else 0.0)
            q5_mpm = (turn if -v65 <= -half_turn else 0.0) - v65
            q5_mmp = v66 + (turn if v66 <= -half_turn else 0.0)
            q5_mmm = (turn if -v67 <= -half_turn else 0.0) - v67
            q1_ppp = v6 + (v40 + (turn if v40 <= -half_turn else 0.0))
            q1_mpp = v6 + (v41 + (turn if v41 <= -half_turn else 0.0))
            q3_ppp = v1 + (v46 + (turn if v46 <= -half_turn else 0.0))
            q3_pmp = v1 + (v47 + (turn if v47 <= -half_turn else 0.0))
            _1200 = q1_ppp
            work[1200 + k] = _1200
            _1216 = q2_ppp
            work[1216 + k] = _1216
            _1232 = q3_ppp
            work[1232 + k] = _1232
            _1248 = q4_ppp
            work[1248 + k] = _1248
            _1264 = q5_ppp
            work[1264 + k] = _1264
            _1280 = angle1
            work[1280 + k] = _1280
            _1296 = q4_ppm
            work[1296 + k] = _1296
            _1312 = q5_ppm
            work[1312 + k] = _1312
            _1328 = q6_ppm
            work[1328 + k] = _1328
            _1344 = q2_pmp
            work[1344 + k] = _1344
            _1360 = q3_pmp
            work[1360 + k] = _1360
            _1376 = q4_pmp
            work[1376 + k] = _1376
            _1392 = q5_pmp
            work[1392 + k] = _1392
            _1408 = angle2
            work[1408 + k] = _1408
            _1424 = q4_pmm
            work[1424 + k] = _1424
            _1440 = q5_pmm
            work[1440 + k] = _1440
            _1456 = q6_pmm
            work[1456 + k] = _1456
            _1472 = q1_mpp
            work[1472 + k] = _1472
            _1488 = q2_mpp
            work[1488 + k] = _1488
            _1504 = q4_mpp
            work[1504 + k] = _1504
            _1520 = q5_mpp
            work[1520 + k] = _1520
            _1536 = angle3
            work[1536 + k] = _1536
            _1552 = q4_mpm
            work[1552 + k] = _1552
            _1568 = q5_mpm
            work[1568 + k] = _1568
            _1584 = q6_mpm
            work[1584 + k] = _1584
            _1600 = q2_mmp
            work[1600 + k] = _1600
            _1616 = q4_mmp
            work[1616 + k] = _1616
            _1632 = q5_mmp
            work[1632 + k] = _1632
            _1648 = angle4
            work[1648 + k] = _1648
            _1664 = q4_mmm
            work[1664 + k] = _1664
            _1680 = q5_mmm
            work[1680 + k] = _1680
            _1696 = q6_mmm
            work[1696 + k] = _1696
            work[1712 + k] = UNREACHABLE if _1200 != _1200 else OK
            work[1728 + k] = UNREACHABLE if _1200 != _1200 else OK
            work[1744 + k] = UNREACHABLE if _1200 != _1200 else OK
            work[1760 + k] = UNREACHABLE if _1200 != _1200 else OK
            work[1776 + k] = UNREACHABLE if _1472 != _1472 else OK
            work[1792 + k] = UNREACHABLE if _1472 != _1472 else OK
            work[1808 + k] = UNREACHABLE if _1472 != _1472 else OK
            work[1824 + k] = UNREACHABLE if _1472 != _1472 else OK
            work[256 + k] = (
                1.0 if v31 <= m7 or v18 <= m4 or v30 <= m7 or v17 <= m4 or v29 <= m7 or v16 <= m4 or
                v28 <= m7 or abs(D1) <= m1 or abs(D3 * (k4 * w1)) <= m2 or v14 <= m4 else work[256 +
                k]
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
