"""kuka_kr210: KUKA KR 210.

Inverse kinematics, generated from robots/kuka_kr210.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kuka_kr210.yaml. The formulas and where they come from: kuka_kr210.md.

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

NAME = "kuka_kr210"
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
    "back-down-noflip",
    "back-down-flip",
    "back-up-noflip",
    "back-up-flip",
    "front-up-noflip",
    "front-up-flip",
    "front-down-noflip",
    "front-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.75  # joint offset 1 [m]
a1 = 0.35  # link length 2 [m]
a2 = 1.25  # link length 3 [m]
d4 = 1.5  # joint offset 4 [m]
a3 = 0.054  # link length 4 [m]
d7 = 0.303  # z of the tool frame [m]
free_limit1 = 4.207e-12  # a length that fixes no angle [m]
longest3 = 7.567845213189771  # square of the longest reach [m^2]
shortest3 = 0.06298678681022957  # square of the shortest reach [m^2]
longest3_reach = 7.567845213192085  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.06298678681001839  # the shortest, with what rounding adds [m^2]
longest3_apart = 7.567845213189539  # the longest, where branches merge [m^2]
shortest3_apart = 0.06298678681025069  # the shortest, where branches merge [m^2]
free_limit_squared2 = 1.7698848999999998e-23  # square of a length that fixes no angle [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
k1 = 3.75  # 2 * d4 * a2 [m^2]
k2 = 0.135  # 2 * a3 * a2 [m^2]
k3 = 3.815416  # a2^2 + (d4^2 + a3^2) [m^2]
k4 = 0.07101907039587806  # 1 / (k1^2 + k2^2) [m^-4]
m1 = 1.7698849000000003e-07  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 1.739735510573048e-09
m4 = 0.009587574503443538  # a coefficient of v4
m5 = 1.016127365600848  # a coefficient of v4
m6 = 0.26632151398454273  # a coefficient of v4
m7 = 0.03658058516163053  # a coefficient of c3
m8 = 0.4  # a coefficient of X2_2
m9 = 0.27616640000000003  # a coefficient of X2_2
m10 = 9.999999999999999e-09  # doubt_limit^2

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
    v1 = q[1] + offset2
    c2 = math.cos(v1)
    s2 = math.sin(v1)
    x2_x = c1 * c2
    x2_y = s1 * c2
    v2 = c1 * s2
    v3 = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v2 * s3
    x3_y = x2_y * c3 - v3 * s3
    v4 = s2 * c3 + c2 * s3
    v5 = v2 * c3 + x2_x * s3
    v6 = v3 * c3 + x2_y * s3
    y3_z = s2 * s3 - c2 * c3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 + s1 * s4
    x4_y = x3_y * c4 - c1 * s4
    v7 = v4 * c4
    y4_x = s1 * c4 - x3_x * s4
    z5_y = c1 * c4 + x3_y * s4
    y4_z = v4 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 - v5 * s5
    x5_y = x4_y * c5 - v6 * s5
    x5_z = y3_z * s5 - v7 * c5
    v8 = v5 * c5 + x4_x * s5
    v9 = v6 * c5 + x4_y * s5
    y5_z = y3_z * c5 + v7 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 + y4_x * s6
    T[0, 1] = y4_x * c6 - x5_x * s6
    T[0, 2] = -v8
    T[0, 3] = c1 * a1 + x2_x * a2 - x3_x * a3 - v5 * d4 - v8 * d7
    T[1, 0] = x5_y * c6 - z5_y * s6
    T[1, 1] = -(z5_y * c6 + x5_y * s6)
    T[1, 2] = -v9
    T[1, 3] = s1 * a1 + x2_y * a2 - x3_y * a3 - v6 * d4 - v9 * d7
    T[2, 0] = x5_z * c6 + y4_z * s6
    T[2, 1] = y4_z * c6 - x5_z * s6
    T[2, 2] = y5_z
    T[2, 3] = d1 - s2 * a2 + v4 * a3 + y3_z * d4 + y5_z * d7
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
    p2_x = c1 * a1
    p2_y = s1 * a1
    v1 = q[1] + offset2
    c2 = math.cos(v1)
    s2 = math.sin(v1)
    x2_x = c1 * c2
    x2_y = s1 * c2
    v2 = c1 * s2
    v3 = s1 * s2
    p3_x = p2_x + x2_x * a2
    p3_y = p2_y + x2_y * a2
    p3_z = d1 - s2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v2 * s3
    x3_y = x2_y * c3 - v3 * s3
    v4 = s2 * c3 + c2 * s3
    v5 = v2 * c3 + x2_x * s3
    v6 = v3 * c3 + x2_y * s3
    y3_z = s2 * s3 - c2 * c3
    p4_x = p3_x - x3_x * a3 - v5 * d4
    p4_y = p3_y - x3_y * a3 - v6 * d4
    p4_z = p3_z + v4 * a3 + y3_z * d4
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    z5_y = c1 * c4 + x3_y * s4
    y4_z = v4 * s4
    z5_x = x3_x * s4 - s1 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v7 = v5 * c5 + (x3_x * c4 + s1 * s4) * s5
    v8 = v6 * c5 + (x3_y * c4 - c1 * s4) * s5
    y5_z = y3_z * c5 + v4 * c4 * s5
    J21 = p4_x - v7 * d7
    v9 = p4_y - v8 * d7
    v10 = p4_z + y5_z * d7
    v11 = v10 - d1
    v12 = v10 - p3_z
    v13 = J21 - p4_x
    v14 = v9 - p4_y
    v15 = v10 - p4_z
    J[0, 0] = -v9
    J[0, 1] = c1 * v11
    J[0, 2] = c1 * v12
    J[0, 3] = -(v6 * v15 + y3_z * v14)
    J[0, 4] = z5_y * v15 + y4_z * v14
    J[0, 5] = -(v8 * v15 + y5_z * v14)
    J[1, 0] = J21
    J[1, 1] = s1 * v11
    J[1, 2] = s1 * v12
    J[1, 3] = y3_z * v13 + v5 * v15
    J[1, 4] = -(y4_z * v13 + z5_x * v15)
    J[1, 5] = y5_z * v13 + v7 * v15
    J[2, 1] = -(s1 * (v9 - p2_y) + c1 * (J21 - p2_x))
    J[2, 2] = -(s1 * (v9 - p3_y) + c1 * (J21 - p3_x))
    J[2, 3] = v6 * v13 - v5 * v14
    J[2, 4] = z5_x * v14 - z5_y * v13
    J[2, 5] = v8 * v13 - v7 * v14
    J[3, 1] = -s1
    J[3, 2] = -s1
    J[3, 3] = -v5
    J[3, 4] = z5_x
    J[3, 5] = -v7
    J[4, 1] = c1
    J[4, 2] = c1
    J[4, 3] = -v6
    J[4, 4] = z5_y
    J[4, 5] = -v8
    J[5, 0] = 1.0
    J[5, 3] = y3_z
    J[5, 4] = -y4_z
    J[5, 5] = y5_z
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[2, 4]
    t14 = T14 - d7 * T13
    Y1 = d7 * T23 - T24
    w1 = math.sqrt(t14 * t14 + Y1 * Y1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 6: U1[3, 4] and U1[1, 4]
    t34 = T34 - d7 * T33
    Z1_3 = t34 - d1
    v2 = Z1_3 * Z1_3

    # theta2, type 3: U1[1, 4] and U1[3, 4]
    v7 = seed[1] + offset2

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(t14 * factor1)
        s1 = math.sin(seed[0]) if free1 else Y1 * factor1
        q1 = _atan2(s1, c1)

        # theta3
        v1 = w1 * e1 + a1
        N3 = v2 + v1 * v1
        K3 = N3 - k3
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        v3 = k1 * K3
        v5 = k2 * K3

        # theta4, type 2: U4[2, 3]
        v8 = T13 * c1 + T23 * s1
        Y4 = T23 * c1 - T13 * s1
        v9 = Y4 * Y4

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        v10 = T22 * c1 - T12 * s1
        v11 = T12 * c1 + T22 * s1
        v13 = T21 * c1 - T11 * s1
        v14 = T11 * c1 + T21 * s1

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            root3 = w3 * e2
            v4 = (v3 + k2 * root3) * k4
            c3 = k4 * (k1 * root3 - v5)
            q3 = _atan2(-v4, c3)

            # theta2
            v6 = d4 * c3 + a3 * v4
            X2_2 = a3 * c3 - d4 * v4 - a2
            S2 = v1 * v6 - Z1_3 * -X2_2
            C2 = v1 * X2_2 - Z1_3 * v6
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v7) if free2 else C2 * factor2
            s2 = math.sin(v7) if free2 else S2 * factor2

            # theta4
            c23 = c3 * c2 + v4 * s2
            s23 = c3 * s2 - v4 * c2
            X4 = c23 * v8 - T33 * s23
            w4 = math.sqrt(X4 * X4 + v9)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta6
            v12 = c23 * v11 - T32 * s23
            v15 = c23 * v14 - T31 * s23

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)

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

                # theta5, type 3: U4[3, 3] and U4[1, 3]
                q5 = _atan2(s5, -(T33 * c23 + s23 * v8))

                # theta6
                q6 = _atan2(-(c4 * v13 + s4 * v15), -(c4 * v10 + s4 * v12))
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
_MISS_WEIGHT = np.array([0.2377, 0.2377, 0.2377, 1.0, 1.0, 1.0])


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
    t14 = T14 - d7 * T13
    Y1 = d7 * T23 - T24
    v1 = t14 * t14 + Y1 * Y1
    w1 = math.sqrt(v1)
    v2 = 1.0 / v1

    # theta3, type 6: U1[3, 4] and U1[1, 4]
    Z1_3 = T34 - d7 * T33 - d1
    v3 = a1 + w1
    v4 = a1 - w1
    v5 = Z1_3 * Z1_3
    N3_p = v5 + v3 * v3
    N3_m = v5 + v4 * v4
    D3_p = (longest3 - N3_p) * (N3_p - shortest3)
    D3_m = (longest3 - N3_m) * (N3_m - shortest3)
    w3_p = math.sqrt(D3_p)
    w3_m = math.sqrt(D3_m)
    v6 = m6 * N3_p - m5
    v7 = m6 * N3_m - m5
    v8 = m4 * w3_p
    v9 = v6 + v8
    v10 = v6 - v8
    v11 = m4 * w3_m
    v12 = v7 + v11
    v13 = v7 - v11
    v14 = m7 - m4 * N3_p
    v15 = m7 - m4 * N3_m
    v16 = m6 * w3_p
    c3_pp = v14 + v16
    c3_pm = v14 - v16
    v17 = m6 * w3_m
    c3_mp = v15 + v17
    c3_mm = v15 - v17

    # theta2, type 3: U1[1, 4] and U1[3, 4]
    X2_2_p = m9 - m8 * N3_p
    X2_2_m = m9 - m8 * N3_m
    v18 = Z1_3 * X2_2_p
    v19 = Z1_3 * X2_2_m
    v20 = w3_p * (m8 * v3)
    S2_pp = v18 + v20
    S2_pm = v18 - v20
    S2_mp = v19 + w3_m * (m8 * v4)
    S2_mm = v19 + w3_m * (m8 * -v4)
    v21 = v3 * X2_2_p
    v22 = v4 * X2_2_m
    v23 = m8 * Z1_3
    v24 = m8 * -Z1_3
    C2_pp = v21 - w3_p * v23
    C2_pm = v21 - w3_p * v24
    C2_mp = v22 - w3_m * v23
    C2_mm = v22 - w3_m * v24
    factor2_p = 1.0 / N3_p
    factor2_m = 1.0 / N3_m

    # theta4, type 2: U4[2, 3]
    c23_pp = c3_pp * C2_pp + v9 * S2_pp
    c23_pm = c3_pm * C2_pm + v10 * S2_pm
    c23_mp = c3_mp * C2_mp + v12 * S2_mp
    c23_mm = c3_mm * C2_mm + v13 * S2_mm
    s23_pp = c3_pp * S2_pp - v9 * C2_pp
    s23_pm = c3_pm * S2_pm - v10 * C2_pm
    s23_mp = c3_mp * S2_mp - v12 * C2_mp
    s23_mm = c3_mm * S2_mm - v13 * C2_mm
    v25 = w1 * (v2 * (T23 * Y1 - T13 * t14))
    X4_pp = c23_pp * v25 - T33 * s23_pp
    X4_pm = c23_pm * v25 - T33 * s23_pm
    v26 = c23_mp * v25 + T33 * s23_mp
    v27 = c23_mm * v25 + T33 * s23_mm
    v28 = w1 * (v2 * (T13 * Y1 + t14 * T23))
    v29 = v28 * v28
    v30 = v29 + factor2_p * (X4_pp * (factor2_p * X4_pp))
    v31 = v29 + factor2_p * (X4_pm * (factor2_p * X4_pm))
    v32 = factor2_m * v26
    v33 = v29 + factor2_m * (v26 * v32)
    v34 = factor2_m * v27
    v35 = v29 + factor2_m * (v27 * v34)
    v36 = math.copysign(half_turn, -v28)
    v37 = math.copysign(half_turn, v28)

    # theta6, type 3: U4[2, 2] and U4[2, 1]
    v38 = w1 * (v2 * (t14 * T22 + Y1 * T12))
    v39 = w1 * (v2 * (Y1 * T22 - t14 * T12))
    v40 = w1 * (v2 * (t14 * T21 + Y1 * T11))
    v41 = w1 * (v2 * (Y1 * T21 - t14 * T11))
    v42 = -X4_pp * v40 + v28 * (c23_pp * v41 - s23_pp * T31)
    v43 = -X4_pm * v40 + v28 * (c23_pm * v41 - s23_pm * T31)
    v44 = v28 * (c23_mp * v41 + s23_mp * T31) - v26 * v40
    v45 = v28 * (c23_mm * v41 + s23_mm * T31) - v27 * v40

    # a joint is free, or branches meet
    if (
        v35 <= m10 or v33 <= m10 or v31 <= m10 or v30 <= m10 or abs(D3_m) <= m3 or v1 <= m1 or
        abs(D3_p) <= m3
    ):
        return False

    # angles, side by side
    room[0] = Y1
    room[1] = -v9
    room[2] = -v10
    room[3] = -v12
    room[4] = -v13
    room[5] = -v28
    room[6] = -v28
    room[7] = v28
    room[8] = v28
    room[9] = math.sqrt(v30)
    room[10] = math.sqrt(v31)
    room[11] = math.sqrt(v33)
    room[12] = math.sqrt(v35)
    room[13] = v42
    room[14] = v43
    room[15] = v44
    room[16] = v45
    room[17] = S2_pp
    room[18] = S2_pm
    room[19] = S2_mp
    room[20] = S2_mm
    room[24] = -t14
    room[25] = c3_pp
    room[26] = c3_pm
    room[27] = c3_mp
    room[28] = c3_mm
    room[29] = factor2_p * -X4_pp
    room[30] = factor2_p * -X4_pm
    room[31] = v32
    room[32] = v34
    room[33] = -(factor2_p * (T33 * c23_pp + s23_pp * v25))
    room[34] = -(factor2_p * (T33 * c23_pm + s23_pm * v25))
    room[35] = -(factor2_m * (T33 * c23_mp - s23_mp * v25))
    room[36] = -(factor2_m * (T33 * c23_mm - s23_mm * v25))
    room[37] = -X4_pp * v38 + v28 * (c23_pp * v39 - s23_pp * T32)
    room[38] = -X4_pm * v38 + v28 * (c23_pm * v39 - s23_pm * T32)
    room[39] = v28 * (c23_mp * v39 + s23_mp * T32) - v26 * v38
    room[40] = v28 * (c23_mm * v39 + s23_mm * T32) - v27 * v38
    room[41] = C2_pp
    room[42] = C2_pm
    room[43] = C2_mp
    room[44] = C2_mm
    for k in range(21, 24):
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
    angle20 = room[19]
    angle21 = room[20]

    # theta4, type 2: U4[2, 3]
    q4_ppm = angle6 - v36
    q4_pmm = angle7 - v36
    q4_mpm = angle8 - v37
    q4_mmm = angle9 - v37

    # theta6, type 3: U4[2, 2] and U4[2, 1]
    q6_ppm = angle14 - math.copysign(half_turn, v42)
    q6_pmm = angle15 - math.copysign(half_turn, v43)
    q6_mpm = angle16 - math.copysign(half_turn, v44)
    q6_mmm = angle17 - math.copysign(half_turn, v45)

    # joint values
    v46 = angle18 - offset2
    v47 = angle19 - offset2
    v48 = angle20 - offset2
    v49 = angle21 - offset2
    q2_ppp = v46 + (-turn if half_turn < v46 else 0.0)
    q2_pmp = v47 + (-turn if half_turn < v47 else 0.0)
    q2_mpp = v48 + (-turn if half_turn < v48 else 0.0)
    q2_mmp = v49 + (-turn if half_turn < v49 else 0.0)
    q1_ppp = angle1 + (w3_p - w3_p)
    q1_mpp = angle1 - math.copysign(half_turn, Y1) + (w3_m - w3_m)

    q[0, 0] = q1_ppp
    q[0, 1] = q2_ppp
    q[0, 2] = angle2
    q[0, 3] = angle6
    q[0, 4] = angle10
    q[0, 5] = angle14
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_ppp
    q[1, 1] = q2_ppp
    q[1, 2] = angle2
    q[1, 3] = q4_ppm
    q[1, 4] = -angle10
    q[1, 5] = q6_ppm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = q1_ppp
    q[2, 1] = q2_pmp
    q[2, 2] = angle3
    q[2, 3] = angle7
    q[2, 4] = angle11
    q[2, 5] = angle15
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = q1_ppp
    q[3, 1] = q2_pmp
    q[3, 2] = angle3
    q[3, 3] = q4_pmm
    q[3, 4] = -angle11
    q[3, 5] = q6_pmm
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else OK
    q[4, 0] = q1_mpp
    q[4, 1] = q2_mpp
    q[4, 2] = angle4
    q[4, 3] = angle8
    q[4, 4] = angle12
    q[4, 5] = angle16
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else OK
    q[5, 0] = q1_mpp
    q[5, 1] = q2_mpp
    q[5, 2] = angle4
    q[5, 3] = q4_mpm
    q[5, 4] = -angle12
    q[5, 5] = q6_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else OK
    q[6, 0] = q1_mpp
    q[6, 1] = q2_mmp
    q[6, 2] = angle5
    q[6, 3] = angle9
    q[6, 4] = angle13
    q[6, 5] = angle17
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else OK
    q[7, 0] = q1_mpp
    q[7, 1] = q2_mmp
    q[7, 2] = angle5
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
    [1200, 1216, 1232, 1248, 1264, 1280],
    [1200, 1216, 1232, 1296, 1312, 1328],
    [1200, 1344, 1360, 1376, 1392, 1408],
    [1200, 1344, 1360, 1424, 1440, 1456],
    [1472, 1488, 1504, 1520, 1536, 1552],
    [1472, 1488, 1504, 1568, 1584, 1600],
    [1472, 1616, 1632, 1648, 1664, 1680],
    [1472, 1616, 1632, 1696, 1712, 1728],
])
_KINDS = np.array([1744, 1760, 1776, 1792, 1808, 1824, 1840, 1856])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(1872), 1872)
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
            t14 = T14 - d7 * T13
            Y1 = d7 * T23 - T24
            v1 = t14 * t14 + Y1 * Y1
            w1 = math.sqrt(v1)
            v2 = 1.0 / v1
            Z1_3 = T34 - d7 * T33 - d1
            v3 = a1 + w1
            v4 = a1 - w1
            v5 = Z1_3 * Z1_3
            N3_p = v5 + v3 * v3
            N3_m = v5 + v4 * v4
            D3_p = (longest3 - N3_p) * (N3_p - shortest3)
            D3_m = (longest3 - N3_m) * (N3_m - shortest3)
            w3_p = math.sqrt(D3_p)
            w3_m = math.sqrt(D3_m)
            v6 = m6 * N3_p - m5
            v7 = m6 * N3_m - m5
            v8 = m4 * w3_p
            v9 = v6 + v8
            v10 = v6 - v8
            v11 = m4 * w3_m
            v12 = v7 + v11
            v13 = v7 - v11
            v14 = m7 - m4 * N3_p
            v15 = m7 - m4 * N3_m
            v16 = m6 * w3_p
            c3_pp = v14 + v16
            c3_pm = v14 - v16
            v17 = m6 * w3_m
            c3_mp = v15 + v17
            c3_mm = v15 - v17
            X2_2_p = m9 - m8 * N3_p
            X2_2_m = m9 - m8 * N3_m
            v18 = Z1_3 * X2_2_p
            v19 = Z1_3 * X2_2_m
            v20 = w3_p * (m8 * v3)
            S2_pp = v18 + v20
            S2_pm = v18 - v20
            S2_mp = v19 + w3_m * (m8 * v4)
            S2_mm = v19 + w3_m * (m8 * -v4)
            v21 = v3 * X2_2_p
            v22 = v4 * X2_2_m
            v23 = m8 * Z1_3
            v24 = m8 * -Z1_3
            C2_pp = v21 - w3_p * v23
            C2_pm = v21 - w3_p * v24
            C2_mp = v22 - w3_m * v23
            C2_mm = v22 - w3_m * v24
            factor2_p = 1.0 / N3_p
            factor2_m = 1.0 / N3_m
            c23_pp = c3_pp * C2_pp + v9 * S2_pp
            c23_pm = c3_pm * C2_pm + v10 * S2_pm
            c23_mp = c3_mp * C2_mp + v12 * S2_mp
            c23_mm = c3_mm * C2_mm + v13 * S2_mm
            s23_pp = c3_pp * S2_pp - v9 * C2_pp
            s23_pm = c3_pm * S2_pm - v10 * C2_pm
            s23_mp = c3_mp * S2_mp - v12 * C2_mp
            s23_mm = c3_mm * S2_mm - v13 * C2_mm
            v25 = w1 * (v2 * (T23 * Y1 - T13 * t14))
            X4_pp = c23_pp * v25 - T33 * s23_pp
            X4_pm = c23_pm * v25 - T33 * s23_pm
            v26 = c23_mp * v25 + T33 * s23_mp
            v27 = c23_mm * v25 + T33 * s23_mm
            v28 = w1 * (v2 * (T13 * Y1 + t14 * T23))
            v29 = v28 * v28
            v30 = v29 + factor2_p * (X4_pp * (factor2_p * X4_pp))
            v31 = v29 + factor2_p * (X4_pm * (factor2_p * X4_pm))
            v32 = factor2_m * v26
            v33 = v29 + factor2_m * (v26 * v32)
            v34 = factor2_m * v27
            v35 = v29 + factor2_m * (v27 * v34)
            v36 = math.copysign(half_turn, -v28)
            v37 = math.copysign(half_turn, v28)
            v38 = w1 * (v2 * (t14 * T22 + Y1 * T12))
            v39 = w1 * (v2 * (Y1 * T22 - t14 * T12))
            v40 = w1 * (v2 * (t14 * T21 + Y1 * T11))
            v41 = w1 * (v2 * (Y1 * T21 - t14 * T11))
            v42 = -X4_pp * v40 + v28 * (c23_pp * v41 - s23_pp * T31)
            v43 = -X4_pm * v40 + v28 * (c23_pm * v41 - s23_pm * T31)
            v44 = v28 * (c23_mp * v41 + s23_mp * T31) - v26 * v40
            v45 = v28 * (c23_mm * v41 + s23_mm * T31) - v27 * v40
            work[272 + k] = Y1
            work[288 + k] = v1
            work[304 + k] = D3_p
            work[320 + k] = D3_m
            work[336 + k] = w3_p
            work[352 + k] = w3_m
            work[368 + k] = v30
            work[384 + k] = v31
            work[400 + k] = v33
            work[416 + k] = v35
            work[432 + k] = v36
            work[448 + k] = v37
            work[464 + k] = v42
            work[480 + k] = v43
            work[496 + k] = v44
            work[512 + k] = v45
            work[528 + k] = Y1
            work[544 + k] = -v9
            work[560 + k] = -v10
            work[576 + k] = -v12
            work[592 + k] = -v13
            work[608 + k] = -v28
            work[624 + k] = -v28
            work[640 + k] = v28
            work[656 + k] = v28
            work[672 + k] = math.sqrt(v30)
            work[688 + k] = math.sqrt(v31)
            work[704 + k] = math.sqrt(v33)
            work[720 + k] = math.sqrt(v35)
            work[736 + k] = v42
            work[752 + k] = v43
            work[768 + k] = v44
            work[784 + k] = v45
            work[800 + k] = S2_pp
            work[816 + k] = S2_pm
            work[832 + k] = S2_mp
            work[848 + k] = S2_mm
            work[864 + k] = -t14
            work[880 + k] = c3_pp
            work[896 + k] = c3_pm
            work[912 + k] = c3_mp
            work[928 + k] = c3_mm
            work[944 + k] = factor2_p * -X4_pp
            work[960 + k] = factor2_p * -X4_pm
            work[976 + k] = v32
            work[992 + k] = v34
            work[1008 + k] = -(factor2_p * (T33 * c23_pp + s23_pp * v25))
            work[1024 + k] = -(factor2_p * (T33 * c23_pm + s23_pm * v25))
            work[1040 + k] = -(factor2_m * (T33 * c23_mp - s23_mp * v25))
            work[1056 + k] = -(factor2_m * (T33 * c23_mm - s23_mm * v25))
            work[1072 + k] = -X4_pp * v38 + v28 * (c23_pp * v39 - s23_pp * T32)
            work[1088 + k] = -X4_pm * v38 + v28 * (c23_pm * v39 - s23_pm * T32)
            work[1104 + k] = v28 * (c23_mp * v39 + s23_mp * T32) - v26 * v38
            work[1120 + k] = v28 * (c23_mm * v39 + s23_mm * T32) - v27 * v38
            work[1136 + k] = C2_pp
            work[1152 + k] = C2_pm
            work[1168 + k] = C2_mp
            work[1184 + k] = C2_mm
        for k in range(528, 864):
            work[k] = _atan2(work[k], work[k + 336])
        for k in range(0, 16):
            Y1 = work[272 + k]
            v1 = work[288 + k]
            D3_p = work[304 + k]
            D3_m = work[320 + k]
            w3_p = work[336 + k]
            w3_m = work[352 + k]
            v30 = work[368 + k]
            v31 = work[384 + k]
            v33 = work[400 + k]
            v35 = work[416 + k]
            v36 = work[432 + k]
            v37 = work[448 + k]
            v42 = work[464 + k]
            v43 = work[480 + k]
            v44 = work[496 + k]
            v45 = work[512 + k]
            angle1 = work[528 + k]
            angle2 = work[544 + k]
            angle3 = work[560 + k]
            angle4 = work[576 + k]
            angle5 = work[592 + k]
            angle6 = work[608 + k]
            angle7 = work[624 + k]
            angle8 = work[640 + k]
            angle9 = work[656 + k]
            angle10 = work[672 + k]
            angle11 = work[688 + k]
            angle12 = work[704 + k]
            angle13 = work[720 + k]
            angle14 = work[736 + k]
            angle15 = work[752 + k]
            angle16 = work[768 + k]
            angle17 = work[784 + k]
            angle18 = work[800 + k]
            angle19 = work[816 + k]
            angle20 = work[832 + k]
            angle21 = work[848 + k]
            q4_ppm = angle6 - v36
            q4_pmm = angle7 - v36
            q4_mpm = angle8 - v37
            q4_mmm = angle9 - v37
            q6_ppm = angle14 - math.copysign(half_turn, v42)
            q6_pmm = angle15 - math.copysign(half_turn, v43)
            q6_mpm = angle16 - math.copysign(half_turn, v44)
            q6_mmm = angle17 - math.copysign(half_turn, v45)
            v46 = angle18 - offset2
            v47 = angle19 - offset2
            v48 = angle20 - offset2
            v49 = angle21 - offset2
            q2_ppp = v46 + (-turn if half_turn < v46 else 0.0)
            q2_pmp = v47 + (-turn if half_turn < v47 else 0.0)
            q2_mpp = v48 + (-turn if half_turn < v48 else 0.0)
            q2_mmp = v49 + (-turn if half_turn < v49 else 0.0)
            q1_ppp = angle1 + (w3_p - w3_p)
            q1_mpp = angle1 - math.copysign(half_turn, Y1) + (w3_m - w3_m)
            _1200 = q1_ppp
            work[1200 + k] = _1200
            _1216 = q2_ppp
            work[1216 + k] = _1216
            _1232 = angle2
            work[1232 + k] = _1232
            _1248 = angle6
            work[1248 + k] = _1248
            _1264 = angle10
            work[1264 + k] = _1264
            _1280 = angle14
            work[1280 + k] = _1280
            _1296 = q4_ppm
            work[1296 + k] = _1296
            _1312 = -angle10
            work[1312 + k] = _1312
            _1328 = q6_ppm
            work[1328 + k] = _1328
            _1344 = q2_pmp
            work[1344 + k] = _1344
            _1360 = angle3
            work[1360 + k] = _1360
            _1376 = angle7
            work[1376 + k] = _1376
            _1392 = angle11
            work[1392 + k] = _1392
            _1408 = angle15
            work[1408 + k] = _1408
            _1424 = q4_pmm
            work[1424 + k] = _1424
            _1440 = -angle11
            work[1440 + k] = _1440
            _1456 = q6_pmm
            work[1456 + k] = _1456
            _1472 = q1_mpp
            work[1472 + k] = _1472
            _1488 = q2_mpp
            work[1488 + k] = _1488
            _1504 = angle4
            work[1504 + k] = _1504
            _1520 = angle8
            work[1520 + k] = _1520
            _1536 = angle12
            work[1536 + k] = _1536
            _1552 = angle16
            work[1552 + k] = _1552
            _1568 = q4_mpm
            work[1568 + k] = _1568
            _1584 = -angle12
            work[1584 + k] = _1584
            _1600 = q6_mpm
            work[1600 + k] = _1600
            _1616 = q2_mmp
            work[1616 + k] = _1616
            _1632 = angle5
            work[1632 + k] = _1632
            _1648 = angle9
            work[1648 + k] = _1648
            _1664 = angle13
            work[1664 + k] = _1664
            _1680 = angle17
            work[1680 + k] = _1680
            _1696 = q4_mmm
            work[1696 + k] = _1696
            _1712 = -angle13
            work[1712 + k] = _1712
            _1728 = q6_mmm
            work[1728 + k] = _1728
            work[1744 + k] = UNREACHABLE if _1200 != _1200 else OK
            work[1760 + k] = UNREACHABLE if _1200 != _1200 else OK
            work[1776 + k] = UNREACHABLE if _1200 != _1200 else OK
            work[1792 + k] = UNREACHABLE if _1200 != _1200 else OK
            work[1808 + k] = UNREACHABLE if _1472 != _1472 else OK
            work[1824 + k] = UNREACHABLE if _1472 != _1472 else OK
            work[1840 + k] = UNREACHABLE if _1472 != _1472 else OK
            work[1856 + k] = UNREACHABLE if _1472 != _1472 else OK
            work[256 + k] = (
                1.0 if v35 <= m10 or v33 <= m10 or v31 <= m10 or v30 <= m10 or abs(D3_m) <= m3 or v1
                <= m1 or abs(D3_p) <= m3 else work[256 + k]
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
