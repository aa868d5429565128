"""rrprrr: RRPRRR arm.

Inverse kinematics, generated from robots/rrprrr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/rrprrr.yaml. The formulas and where they come from: rrprrr.md.

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

NAME = "rrprrr"
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
    "back-forward-noflip",
    "back-forward-flip",
    "back-backward-noflip",
    "back-backward-flip",
    "front-forward-noflip",
    "front-forward-flip",
    "front-backward-noflip",
    "front-backward-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

free_limit1 = 1e-12  # a length that fixes no angle [m]
free_limit = 1e-12  # a length that fixes no angle
m1 = 9.999999999999999e-09  # doubt_limit1^2 [m^2]

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
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
    z3_x = c1 * s2
    z3_y = s1 * s2
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x2_x * c4 + s1 * s4
    x4_y = x2_y * c4 - c1 * s4
    x4_z = s2 * c4
    y4_x = s1 * c4 - x2_x * s4
    v1 = c1 * c4 + x2_y * s4
    v2 = s2 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 - z3_x * s5
    x5_y = x4_y * c5 - z3_y * s5
    x5_z = x4_z * c5 + c2 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 + y4_x * s6
    T[0, 1] = y4_x * c6 - x5_x * s6
    T[0, 2] = z3_x * c5 + x4_x * s5
    T[0, 3] = z3_x * q[2]
    T[1, 0] = x5_y * c6 - v1 * s6
    T[1, 1] = -(v1 * c6 + x5_y * s6)
    T[1, 2] = z3_y * c5 + x4_y * s5
    T[1, 3] = z3_y * q[2]
    T[2, 0] = x5_z * c6 - v2 * s6
    T[2, 1] = -(v2 * c6 + x5_z * s6)
    T[2, 2] = x4_z * s5 - c2 * c5
    T[2, 3] = -(c2 * q[2])
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
    z3_x = c1 * s2
    z3_y = s1 * s2
    p3_x = z3_x * q[2]
    p3_y = z3_y * q[2]
    v1 = c2 * q[2]
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    J[0, 0] = -p3_y
    J[0, 1] = c1 * v1
    J[0, 2] = z3_x
    J[1, 0] = p3_x
    J[1, 1] = s1 * v1
    J[1, 2] = z3_y
    J[2, 1] = s1 * p3_y + c1 * p3_x
    J[2, 2] = -c2
    J[3, 1] = s1
    J[3, 3] = z3_x
    J[3, 4] = s1 * c4 - x2_x * s4
    J[3, 5] = z3_x * c5 + (x2_x * c4 + s1 * s4) * s5
    J[4, 1] = -c1
    J[4, 3] = z3_y
    J[4, 4] = -(c1 * c4 + x2_y * s4)
    J[4, 5] = z3_y * c5 + (x2_y * c4 - c1 * s4) * s5
    J[5, 0] = 1.0
    J[5, 3] = -c2
    J[5, 4] = -(s2 * s4)
    J[5, 5] = s2 * c4 * s5 - c2 * c5
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[2, 4]
    w1 = math.sqrt(T14 * T14 + T24 * T24)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta2, r3, type 4: U1[1, 4] and U1[3, 4]
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

        # theta2, r3
        w3 = math.sqrt(root1 * root1 + v1)
        free2 = w3 <= free_limit1
        divisor2 = 1.0 if free2 else w3

        # theta4, type 2: U4[2, 3]
        v2 = T13 * c1 + T23 * s1
        Y4 = T23 * c1 - T13 * s1
        v3 = Y4 * Y4

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        v4 = T22 * c1 - T12 * s1
        v5 = T12 * c1 + T22 * s1
        v7 = T21 * c1 - T11 * s1
        v8 = T11 * c1 + T21 * s1

        for i2 in range(2):  # forward, backward
            e2 = 1.0 - 2.0 * i2
            # theta2, r3
            if e2 < 0.0 and free2:
                continue  # both signs give the same
            factor2 = e2 / divisor2
            c2 = math.cos(seed[1]) if free2 else -(T34 * factor2)
            s2 = math.sin(seed[1]) if free2 else -(root1 * factor2)
            q2 = _atan2(s2, c2)
            r3 = w3 * e2

            # theta4
            X4 = c2 * v2 + T33 * s2
            w4 = math.sqrt(X4 * X4 + v3)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[3, 3] and U4[1, 3]
            c5 = s2 * v2 - T33 * c2

            # theta6
            v6 = c2 * v5 + T32 * s2
            v9 = c2 * v8 + T31 * s2

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4
                if e3 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e3 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)

                # theta5
                q5 = _atan2(-(w4 * e3), c5)

                # theta6
                q6 = _atan2(-(c4 * v7 + s4 * v9), -(c4 * v4 + s4 * v6))
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0] = q1
                q[row, 1] = q2
                q[row, 2] = r3
                q[row, 3] = q4
                q[row, 4] = q5
                q[row, 5] = q6
                status[row] = FREE_JOINT if free1 or free2 or free4 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px * px * px) and math.isfinite(py * py * py) and math.isfinite(pz * pz * pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])


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
    room = carray(_room(16), 16)

    # theta1, type 2: U1[2, 4]
    v1 = T14 * T14 + T24 * T24
    w1 = math.sqrt(v1)
    factor1 = w1 * (1.0 / v1)

    # theta2, r3, type 4: U1[1, 4] and U1[3, 4]
    v2 = v1 + T34 * T34
    q3_ppp = math.sqrt(v2)
    factor2 = q3_ppp * (1.0 / v2)
    v3 = T34 * factor2
    v4 = w1 * factor2

    # theta4, type 2: U4[2, 3]
    v5 = T14 * T13 + T24 * T23
    X4 = factor1 * (v3 * v5) - v4 * T33
    Y4 = T24 * T13 - T14 * T23
    v6 = X4 * X4 + factor1 * (Y4 * (factor1 * Y4))
    w4 = math.sqrt(v6)
    factor4 = w4 * (1.0 / v6)
    v7 = X4 * factor4
    s4 = Y4 * factor4
    v8 = factor1 * s4

    # theta6, type 3: U4[2, 2] and U4[2, 1]
    v9 = v7 * (T24 * T11 - T14 * T21) - s4 * (factor1 * (v3 * (T14 * T11 + T24 * T21)) - v4 * T31)

    # a joint is free, or branches meet
    if v2 <= m1 or v6 <= m1 or v1 <= m1:
        return False

    # angles, side by side
    room[0] = -T24
    room[1] = -w1
    room[2] = v8
    room[3] = -w4
    room[4] = v9
    room[8] = -T14
    room[9] = -T34
    room[10] = -v7
    room[11] = v3 * T33 + factor1 * (v4 * v5)
    room[12] = (
        v7 * (T24 * T12 - T14 * T22) - s4 * (factor1 * (v3 * (T14 * T12 + T24 * T22)) - v4 * T32)
    )
    for k in range(5, 8):
        room[k] = room[k + 8] = 1.0
    for k in range(8):
        room[k] = _atan2(room[k], room[k + 8])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]
    angle4 = room[3]
    angle5 = room[4]

    # theta1, type 2: U1[2, 4]
    q1_mpp = angle1 - math.copysign(half_turn, -T24)

    # theta2, r3, type 4: U1[1, 4] and U1[3, 4]
    q2_pmp = angle2 - math.copysign(half_turn, -w1)

    # theta4, type 2: U4[2, 3]
    q4_ppm = angle3 - math.copysign(half_turn, v8)

    # theta5, type 3: U4[3, 3] and U4[1, 3]
    q5_pmp = math.copysign(half_turn, -w4) - angle4

    # theta6, type 3: U4[2, 2] and U4[2, 1]
    q6_ppm = angle5 - math.copysign(half_turn, v9)

    q[0, 0] = angle1
    q[0, 1] = angle2
    q[0, 2] = q3_ppp
    q[0, 3] = angle3
    q[0, 4] = angle4
    q[0, 5] = angle5
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = angle1
    q[1, 1] = angle2
    q[1, 2] = q3_ppp
    q[1, 3] = q4_ppm
    q[1, 4] = -angle4
    q[1, 5] = q6_ppm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = angle1
    q[2, 1] = q2_pmp
    q[2, 2] = -q3_ppp
    q[2, 3] = -q4_ppm
    q[2, 4] = q5_pmp
    q[2, 5] = q6_ppm
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = angle1
    q[3, 1] = q2_pmp
    q[3, 2] = -q3_ppp
    q[3, 3] = -angle3
    q[3, 4] = -q5_pmp
    q[3, 5] = angle5
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else OK
    q[4, 0] = q1_mpp
    q[4, 1] = -angle2
    q[4, 2] = q3_ppp
    q[4, 3] = q4_ppm
    q[4, 4] = angle4
    q[4, 5] = angle5
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else OK
    q[5, 0] = q1_mpp
    q[5, 1] = -angle2
    q[5, 2] = q3_ppp
    q[5, 3] = angle3
    q[5, 4] = -angle4
    q[5, 5] = q6_ppm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else OK
    q[6, 0] = q1_mpp
    q[6, 1] = -q2_pmp
    q[6, 2] = -q3_ppp
    q[6, 3] = -angle3
    q[6, 4] = q5_pmp
    q[6, 5] = q6_ppm
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else OK
    q[7, 0] = q1_mpp
    q[7, 1] = -q2_pmp
    q[7, 2] = -q3_ppp
    q[7, 3] = -q4_ppm
    q[7, 4] = -q5_pmp
    q[7, 5] = angle5
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
    [560, 576, 592, 608, 624, 640],
    [560, 576, 592, 656, 672, 688],
    [560, 704, 720, 736, 752, 688],
    [560, 704, 720, 768, 784, 640],
    [800, 816, 592, 656, 624, 640],
    [800, 816, 592, 608, 672, 688],
    [800, 832, 720, 768, 752, 688],
    [800, 832, 720, 736, 784, 640],
])
_KINDS = np.array([848, 864, 880, 896, 912, 928, 944, 960])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(976), 976)
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
            T32 = work[144 + k]
            T33 = work[160 + k]
            T34 = work[176 + k]
            v1 = T14 * T14 + T24 * T24
            w1 = math.sqrt(v1)
            factor1 = w1 * (1.0 / v1)
            v2 = v1 + T34 * T34
            q3_ppp = math.sqrt(v2)
            factor2 = q3_ppp * (1.0 / v2)
            v3 = T34 * factor2
            v4 = w1 * factor2
            v5 = T14 * T13 + T24 * T23
            X4 = factor1 * (v3 * v5) - v4 * T33
            Y4 = T24 * T13 - T14 * T23
            v6 = X4 * X4 + factor1 * (Y4 * (factor1 * Y4))
            w4 = math.sqrt(v6)
            factor4 = w4 * (1.0 / v6)
            v7 = X4 * factor4
            s4 = Y4 * factor4
            v8 = factor1 * s4
            v9 = (
                v7 * (T24 * T11 - T14 * T21) - s4 * (factor1 * (v3 * (T14 * T11 + T24 * T21)) - v4 *
                T31)
            )
            work[272 + k] = v1
            work[288 + k] = w1
            work[304 + k] = v2
            work[320 + k] = q3_ppp
            work[336 + k] = v6
            work[352 + k] = w4
            work[368 + k] = v8
            work[384 + k] = v9
            work[400 + k] = -T24
            work[416 + k] = -w1
            work[432 + k] = v8
            work[448 + k] = -w4
            work[464 + k] = v9
            work[480 + k] = -T14
            work[496 + k] = -T34
            work[512 + k] = -v7
            work[528 + k] = v3 * T33 + factor1 * (v4 * v5)
            work[544 + k] = (
                v7 * (T24 * T12 - T14 * T22) - s4 * (factor1 * (v3 * (T14 * T12 + T24 * T22)) - v4 *
                T32)
            )
        for k in range(400, 480):
            work[k] = _atan2(work[k], work[k + 80])
        for k in range(0, 16):
            T24 = work[112 + k]
            v1 = work[272 + k]
            w1 = work[288 + k]
            v2 = work[304 + k]
            q3_ppp = work[320 + k]
            v6 = work[336 + k]
            w4 = work[352 + k]
            v8 = work[368 + k]
            v9 = work[384 + k]
            angle1 = work[400 + k]
            angle2 = work[416 + k]
            angle3 = work[432 + k]
            angle4 = work[448 + k]
            angle5 = work[464 + k]
            q1_mpp = angle1 - math.copysign(half_turn, -T24)
            q2_pmp = angle2 - math.copysign(half_turn, -w1)
            q4_ppm = angle3 - math.copysign(half_turn, v8)
            q5_pmp = math.copysign(half_turn, -w4) - angle4
            q6_ppm = angle5 - math.copysign(half_turn, v9)
            _560 = angle1
            work[560 + k] = _560
            _576 = angle2
            work[576 + k] = _576
            _592 = q3_ppp
            work[592 + k] = _592
            _608 = angle3
            work[608 + k] = _608
            _624 = angle4
            work[624 + k] = _624
            _640 = angle5
            work[640 + k] = _640
            _656 = q4_ppm
            work[656 + k] = _656
            _672 = -angle4
            work[672 + k] = _672
            _688 = q6_ppm
            work[688 + k] = _688
            _704 = q2_pmp
            work[704 + k] = _704
            _720 = -q3_ppp
            work[720 + k] = _720
            _736 = -q4_ppm
            work[736 + k] = _736
            _752 = q5_pmp
            work[752 + k] = _752
            _768 = -angle3
            work[768 + k] = _768
            _784 = -q5_pmp
            work[784 + k] = _784
            _800 = q1_mpp
            work[800 + k] = _800
            _816 = -angle2
            work[816 + k] = _816
            _832 = -q2_pmp
            work[832 + k] = _832
            work[848 + k] = UNREACHABLE if _560 != _560 else OK
            work[864 + k] = UNREACHABLE if _560 != _560 else OK
            work[880 + k] = UNREACHABLE if _560 != _560 else OK
            work[896 + k] = UNREACHABLE if _560 != _560 else OK
            work[912 + k] = UNREACHABLE if _800 != _800 else OK
            work[928 + k] = UNREACHABLE if _800 != _800 else OK
            work[944 + k] = UNREACHABLE if _800 != _800 else OK
            work[960 + k] = UNREACHABLE if _800 != _800 else OK
            work[256 + k] = 1.0 if v2 <= m1 or v6 <= m1 or v1 <= m1 else work[256 + k]
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
            "no_pose": "not finite or beyond 5e102, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)",
            "no_row": "the pose is out of reach",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
