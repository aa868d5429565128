"""igus_rebel: igus ReBeL.

Inverse kinematics, generated from robots/igus_rebel.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/igus_rebel.yaml. The formulas and where they come from: igus_rebel.md.

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

NAME = "igus_rebel"
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

d1 = 0.1  # joint offset 1 [m]
a1 = 0.149  # link length 1 [m]
a2 = 0.2384  # link length 2 [m]
a3 = 0.119  # link length 3 [m]
d4 = 0.17  # joint offset 4 [m]
d6 = 0.1208  # joint offset 6 [m]
free_limit1 = 8.972000000000001e-13  # a length that fixes no angle [m]
longest3 = 0.19883701719889113  # square of the longest reach [m^2]
shortest3 = 0.0009541028011088964  # square of the shortest reach [m^2]
longest3_reach = 0.19883701719897112  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0009541028011033538  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.1988370171988831  # the longest, where branches merge [m^2]
shortest3_apart = 0.0009541028011094507  # the shortest, where branches merge [m^2]
free_limit_squared2 = 8.049678400000002e-25  # square of a length that fixes no angle [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset3 = -1.5707963267948966  # offset of joint 3 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
k1 = 0.081056  # 2 * d4 * a2 [m^2]
k2 = 0.0567392  # 2 * a3 * a2 [m^2]
k3 = 0.09989556000000001  # a2^2 + (a3^2 + d4^2) [m^2]
k4 = 102.1511817908859  # 1 / (k1^2 + k2^2) [m^-4]
turn1 = 0.960070362405688  # a constant angle [rad]
m1 = 8.049678400000001e-09  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 1.5872903619528408e-12
m4 = 2.097315436241611  # a coefficient of Y1_2
m5 = 0.028887499999999986  # a coefficient of Y1_2
m6 = 1.3817607579944728  # a coefficient of c23
m7 = 1.9739439399921042  # a coefficient of c23
m8 = 0.027188235294117635  # a coefficient of c23
m9 = 0.019031764705882342  # a coefficient of c23
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
    v4 = q[2] + offset3
    c3 = math.cos(v4)
    s3 = math.sin(v4)
    x3_x = x2_x * c3 - v2 * s3
    x3_y = x2_y * c3 - v3 * s3
    v5 = s2 * c3 + c2 * s3
    v6 = v2 * c3 + x2_x * s3
    v7 = v3 * c3 + x2_y * s3
    z3_z = s2 * s3 - c2 * c3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 + s1 * s4
    x4_y = x3_y * c4 - c1 * s4
    v8 = v5 * c4
    z4_y = c1 * c4 + x3_y * s4
    v9 = v5 * s4
    z4_x = x3_x * s4 - s1 * c4
    v10 = q[4] + offset5
    c5 = math.cos(v10)
    s5 = math.sin(v10)
    x5_x = x4_x * c5 - v6 * s5
    x5_y = x4_y * c5 - v7 * s5
    x5_z = z3_z * s5 - v8 * c5
    z5_x = v6 * c5 + x4_x * s5
    z5_y = v7 * c5 + x4_y * s5
    v11 = z3_z * c5 + v8 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 + z4_x * s6
    T[0, 1] = z4_x * c6 - x5_x * s6
    T[0, 2] = z5_x
    T[0, 3] = c1 * a1 + x2_x * a2 + x3_x * a3 - v6 * d4 + z5_x * d6
    T[1, 0] = x5_y * c6 + z4_y * s6
    T[1, 1] = z4_y * c6 - x5_y * s6
    T[1, 2] = z5_y
    T[1, 3] = s1 * a1 + x2_y * a2 + x3_y * a3 - v7 * d4 + z5_y * d6
    T[2, 0] = x5_z * c6 - v9 * s6
    T[2, 1] = -(v9 * c6 + x5_z * s6)
    T[2, 2] = -v11
    T[2, 3] = d1 - s2 * a2 - v5 * a3 + z3_z * d4 - v11 * d6
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
    v1 = q[1] + offset2
    c2 = math.cos(v1)
    s2 = math.sin(v1)
    x2_x = c1 * c2
    x2_y = s1 * c2
    v2 = c1 * s2
    v3 = s1 * s2
    p2_x = p1_x + x2_x * a2
    p2_y = p1_y + x2_y * a2
    p2_z = d1 - s2 * a2
    v4 = q[2] + offset3
    c3 = math.cos(v4)
    s3 = math.sin(v4)
    x3_x = x2_x * c3 - v2 * s3
    x3_y = x2_y * c3 - v3 * s3
    v5 = s2 * c3 + c2 * s3
    v6 = v2 * c3 + x2_x * s3
    v7 = v3 * c3 + x2_y * s3
    z3_z = s2 * s3 - c2 * c3
    p3_x = p2_x + x3_x * a3
    p3_y = p2_y + x3_y * a3
    p3_z = p2_z - v5 * a3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    z4_y = c1 * c4 + x3_y * s4
    v8 = v5 * s4
    p4_x = p3_x - v6 * d4
    p4_y = p3_y - v7 * d4
    p4_z = p3_z + z3_z * d4
    z4_x = x3_x * s4 - s1 * c4
    v9 = q[4] + offset5
    c5 = math.cos(v9)
    s5 = math.sin(v9)
    z5_x = v6 * c5 + (x3_x * c4 + s1 * s4) * s5
    z5_y = v7 * c5 + (x3_y * c4 - c1 * s4) * s5
    v10 = z3_z * c5 + v5 * c4 * s5
    p6_x = p4_x + z5_x * d6
    p6_y = p4_y + z5_y * d6
    p6_z = p4_z - v10 * d6
    v11 = p6_z - d1
    v12 = p6_z - p2_z
    v13 = p6_x - p3_x
    v14 = p6_y - p3_y
    v15 = p6_z - p3_z
    v16 = p6_x - p4_x
    v17 = p6_y - p4_y
    v18 = p6_z - p4_z
    J[0, 0] = -p6_y
    J[0, 1] = c1 * v11
    J[0, 2] = c1 * v12
    J[0, 3] = -(v7 * v15 + z3_z * v14)
    J[0, 4] = z4_y * v18 + v8 * v17
    J[0, 5] = z5_y * v18 + v10 * v17
    J[1, 0] = p6_x
    J[1, 1] = s1 * v11
    J[1, 2] = s1 * v12
    J[1, 3] = z3_z * v13 + v6 * v15
    J[1, 4] = -(v8 * v16 + z4_x * v18)
    J[1, 5] = -(v10 * v16 + z5_x * v18)
    J[2, 1] = -(s1 * (p6_y - p1_y) + c1 * (p6_x - p1_x))
    J[2, 2] = -(s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x))
    J[2, 3] = v7 * v13 - v6 * v14
    J[2, 4] = z4_x * v17 - z4_y * v16
    J[2, 5] = z5_x * v17 - z5_y * v16
    J[3, 1] = -s1
    J[3, 2] = -s1
    J[3, 3] = -v6
    J[3, 4] = z4_x
    J[3, 5] = z5_x
    J[4, 1] = c1
    J[4, 2] = c1
    J[4, 3] = -v7
    J[4, 4] = z4_y
    J[4, 5] = z5_y
    J[5, 0] = 1.0
    J[5, 3] = z3_z
    J[5, 4] = -v8
    J[5, 5] = -v10
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1 A6^-1 [3, 4]
    wx = T14 - T13 * d6
    Y1 = d6 * T23 - T24
    w1 = math.sqrt(wx * wx + Y1 * Y1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = T34 - d6 * T33
    Z1_3 = wz - d1
    v2 = Z1_3 * Z1_3

    # theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4]
    v7 = seed[1] + offset2

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(wx * factor1)
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
        v4 = k2 * K3

        # theta4, type 2: U4[3, 3]
        v8 = T13 * c1 + T23 * s1
        Y4 = T13 * s1 - T23 * c1
        v9 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
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
            s3 = (k2 * root3 - v3) * k4
            c3 = k4 * (v4 + k1 * root3)

            # theta2
            v5 = d4 * c3 + a3 * s3
            Y1_2 = a2 + (a3 * c3 - d4 * s3)
            S2 = v1 * v5 - Z1_3 * Y1_2
            v6 = Z1_3 * v5 + v1 * Y1_2
            w2 = math.sqrt(S2 * S2 + v6 * v6)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v7) if free2 else -(v6 * factor2)
            s2 = math.sin(v7) if free2 else S2 * factor2

            # theta4
            c23 = c3 * c2 - s3 * s2
            s23 = c3 * s2 + s3 * c2
            X4 = T33 * s23 - c23 * v8
            w4 = math.sqrt(X4 * X4 + v9)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T33 * c23 + s23 * v8

            # theta6
            v12 = c23 * v11 - T32 * s23
            v15 = c23 * v14 - T31 * s23

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(s3, c3) - offset3)

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

                # theta6
                c6 = c4 * v10 + s4 * v12
                s6 = c4 * v13 + s4 * v15
                q6 = _atan2(s6, c6)

                # joint values
                q5 = _wrap(_atan2(s5, c5) - offset5)
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
_MISS_WEIGHT = np.array([1.115, 1.115, 1.115, 1.0, 1.0, 1.0])


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

    # theta1, type 2: U1 A6^-1 [3, 4]
    wx = T14 - d6 * T13
    Y1 = d6 * T23 - T24
    v1 = wx * wx + Y1 * Y1
    w1 = math.sqrt(v1)
    v2 = 1.0 / v1

    # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    Z1_3 = T34 - d6 * T33 - d1
    v3 = a1 + w1
    v4 = a1 - w1
    v5 = Z1_3 * Z1_3
    N3_p = v5 + v3 * v3
    N3_m = v5 + v4 * v4
    D3_p = (longest3 - N3_p) * (N3_p - shortest3)
    D3_m = (longest3 - N3_m) * (N3_m - shortest3)
    w3_p = math.sqrt(D3_p)
    w3_m = math.sqrt(D3_m)

    # theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4]
    Y1_2_p = m5 + m4 * N3_p
    Y1_2_m = m5 + m4 * N3_m
    v6 = Z1_3 * Y1_2_p
    v7 = Z1_3 * Y1_2_m
    v8 = v3 * Y1_2_p
    v9 = v4 * Y1_2_m
    v10 = m4 * Z1_3
    v11 = m4 * -Z1_3
    factor2_p = 1.0 / N3_p
    factor2_m = 1.0 / N3_m

    # theta4, type 2: U4[3, 3]
    v12 = m6 * Z1_3
    v13 = v12 - m7 * v3
    v14 = v12 - m7 * v4
    v15 = m8 * factor2_p - m7
    v16 = m8 * factor2_m - m7
    v17 = m9 * factor2_p - m6
    v18 = m9 * factor2_m - m6
    v19 = Z1_3 * v15 + v3 * v17
    v20 = Z1_3 * v16 + v4 * v18
    c23_pp = v19 + w3_p * (factor2_p * v13)
    c23_pm = v19 + w3_p * (factor2_p * -v13)
    c23_mp = v20 + w3_m * (factor2_m * v14)
    c23_mm = v20 + w3_m * (factor2_m * -v14)
    v21 = m7 * Z1_3
    v22 = Z1_3 * v17 + v3 * -v15
    v23 = Z1_3 * v18 + v4 * -v16
    v24 = w3_p * (factor2_p * (v21 + m6 * v3))
    s23_pp = v22 - v24
    s23_pm = v22 + v24
    v25 = w3_m * (factor2_m * (v21 + m6 * v4))
    s23_mp = v23 - v25
    s23_mm = v23 + v25
    v26 = w1 * (v2 * (T23 * Y1 - T13 * wx))
    X4_pp = T33 * s23_pp - c23_pp * v26
    X4_pm = T33 * s23_pm - c23_pm * v26
    X4_mp = T33 * s23_mp + c23_mp * v26
    X4_mm = T33 * s23_mm + c23_mm * v26
    Y4 = w1 * (v2 * (T13 * Y1 + wx * T23))
    v27 = Y4 * Y4
    v28 = v27 + X4_pp * X4_pp
    v29 = v27 + X4_pm * X4_pm
    v30 = v27 + X4_mp * X4_mp
    v31 = v27 + X4_mm * X4_mm
    v32 = math.copysign(half_turn, Y4)
    v33 = math.copysign(half_turn, -Y4)

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v34 = w1 * (v2 * (wx * T22 + Y1 * T12))
    v35 = w1 * (v2 * (Y1 * T22 - wx * T12))
    v36 = w1 * (v2 * (wx * T21 + Y1 * T11))
    v37 = w1 * (v2 * (Y1 * T21 - wx * T11))
    v38 = Y4 * (c23_pp * v37 - s23_pp * T31) - -X4_pp * v36
    v39 = Y4 * (c23_pm * v37 - s23_pm * T31) - -X4_pm * v36
    v40 = Y4 * (c23_mp * v37 + s23_mp * T31) - X4_mp * v36
    v41 = Y4 * (c23_mm * v37 + s23_mm * T31) - X4_mm * v36

    # joint values
    v42 = w3_p * (m4 * v3)

    # a joint is free, or branches meet
    if (
        v31 <= m10 or v30 <= m10 or v29 <= m10 or v28 <= m10 or abs(D3_m) <= m3 or v1 <= m1 or
        abs(D3_p) <= m3
    ):
        return False

    # angles, side by side
    room[0] = Y1
    room[1] = Y4
    room[2] = Y4
    room[3] = -Y4
    room[4] = -Y4
    room[5] = v38
    room[6] = v39
    room[7] = v40
    room[8] = v41
    room[9] = v42 - v6
    room[10] = -(v6 + v42)
    room[11] = w3_m * (m4 * v4) - v7
    room[12] = w3_m * (m4 * -v4) - v7
    room[13] = w3_p
    room[14] = w3_m
    room[15] = math.sqrt(v28)
    room[16] = math.sqrt(v29)
    room[17] = math.sqrt(v30)
    room[18] = math.sqrt(v31)
    room[24] = -wx
    room[25] = -X4_pp
    room[26] = -X4_pm
    room[27] = -X4_mp
    room[28] = -X4_mm
    room[29] = Y4 * (c23_pp * v35 - s23_pp * T32) - -X4_pp * v34
    room[30] = Y4 * (c23_pm * v35 - s23_pm * T32) - -X4_pm * v34
    room[31] = Y4 * (c23_mp * v35 + s23_mp * T32) - X4_mp * v34
    room[32] = Y4 * (c23_mm * v35 + s23_mm * T32) - X4_mm * v34
    room[33] = -(v8 + w3_p * v10)
    room[34] = -(v8 + w3_p * v11)
    room[35] = -(v9 + w3_m * v10)
    room[36] = -(v9 + w3_m * v11)
    room[37] = N3_p - k3
    room[38] = N3_m - k3
    room[39] = T33 * c23_pp + s23_pp * v26
    room[40] = T33 * c23_pm + s23_pm * v26
    room[41] = T33 * c23_mp - s23_mp * v26
    room[42] = T33 * c23_mm - s23_mm * v26
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

    # theta4, type 2: U4[3, 3]
    q4_ppm = angle2 - v32
    q4_pmm = angle3 - v32
    q4_mpm = angle4 - v33
    q4_mmm = angle5 - v33

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    q6_ppm = angle6 - math.copysign(half_turn, v38)
    q6_pmm = angle7 - math.copysign(half_turn, v39)
    q6_mpm = angle8 - math.copysign(half_turn, v40)
    q6_mmm = angle9 - math.copysign(half_turn, v41)

    # joint values
    v43 = angle10 - offset2
    v44 = angle11 - offset2
    v45 = angle12 - offset2
    v46 = angle13 - offset2
    q2_ppp = v43 + (-turn if half_turn < v43 else 0.0)
    q2_pmp = v44 + (-turn if half_turn < v44 else 0.0)
    q2_mpp = v45 + (-turn if half_turn < v45 else 0.0)
    q2_mmp = v46 + (-turn if half_turn < v46 else 0.0)
    v47 = angle14 - turn1 - offset3
    v48 = offset3 + (turn1 + angle14)
    v49 = angle15 - turn1 - offset3
    v50 = offset3 + (turn1 + angle15)
    q3_ppp = v47 + (-turn if half_turn < v47 else 0.0)
    q3_pmp = (-turn if half_turn < -v48 else 0.0) - v48
    q3_mpp = v49 + (-turn if half_turn < v49 else 0.0)
    q3_mmp = (-turn if half_turn < -v50 else 0.0) - v50
    v51 = angle16 - offset5
    v52 = offset5 + angle16
    v53 = angle17 - offset5
    v54 = offset5 + angle17
    v55 = angle18 - offset5
    v56 = offset5 + angle18
    v57 = angle19 - offset5
    v58 = offset5 + angle19
    q5_ppp = v51 + (turn if v51 <= -half_turn else 0.0)
    q5_ppm = (turn if -v52 <= -half_turn else 0.0) - v52
    q5_pmp = v53 + (turn if v53 <= -half_turn else 0.0)
    q5_pmm = (turn if -v54 <= -half_turn else 0.0) - v54
    q5_mpp = v55 + (turn if v55 <= -half_turn else 0.0)
    q5_mpm = (turn if -v56 <= -half_turn else 0.0) - v56
    q5_mmp = v57 + (turn if v57 <= -half_turn else 0.0)
    q5_mmm = (turn if -v58 <= -half_turn else 0.0) - v58
    q1_ppp = angle1 + (w3_p - w3_p)
    q1_mpp = angle1 - math.copysign(half_turn, Y1) + (w3_m - w3_m)

    q[0, 0] = q1_ppp
    q[0, 1] = q2_ppp
    q[0, 2] = q3_ppp
    q[0, 3] = angle2
    q[0, 4] = q5_ppp
    q[0, 5] = angle6
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
    q[2, 3] = angle3
    q[2, 4] = q5_pmp
    q[2, 5] = angle7
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
    q[4, 2] = q3_mpp
    q[4, 3] = angle4
    q[4, 4] = q5_mpp
    q[4, 5] = angle8
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else OK
    q[5, 0] = q1_mpp
    q[5, 1] = q2_mpp
    q[5, 2] = q3_mpp
    q[5, 3] = q4_mpm
    q[5, 4] = q5_mpm
    q[5, 5] = q6_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else OK
    q[6, 0] = q1_mpp
    q[6, 1] = q2_mmp
    q[6, 2] = q3_mmp
    q[6, 3] = angle5
    q[6, 4] = q5_mmp
    q[6, 5] = angle9
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else OK
    q[7, 0] = q1_mpp
    q[7, 1] = q2_mmp
    q[7, 2] = q3_mmp
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
    [1136, 1152, 1168, 1184, 1200, 1216],
    [1136, 1152, 1168, 1232, 1248, 1264],
    [1136, 1280, 1296, 1312, 1328, 1344],
    [1136, 1280, 1296, 1360, 1376, 1392],
    [1408, 1424, 1440, 1456, 1472, 1488],
    [1408, 1424, 1440, 1504, 1520, 1536],
    [1408, 1552, 1568, 1584, 1600, 1616],
    [1408, 1552, 1568, 1632, 1648, 1664],
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
            wx = T14 - d6 * T13
            Y1 = d6 * T23 - T24
            v1 = wx * wx + Y1 * Y1
            w1 = math.sqrt(v1)
            v2 = 1.0 / v1
            Z1_3 = T34 - d6 * T33 - d1
            v3 = a1 + w1
            v4 = a1 - w1
            v5 = Z1_3 * Z1_3
            N3_p = v5 + v3 * v3
            N3_m = v5 + v4 * v4
            D3_p = (longest3 - N3_p) * (N3_p - shortest3)
            D3_m = (longest3 - N3_m) * (N3_m - shortest3)
            w3_p = math.sqrt(D3_p)
            w3_m = math.sqrt(D3_m)
            Y1_2_p = m5 + m4 * N3_p
            Y1_2_m = m5 + m4 * N3_m
            v6 = Z1_3 * Y1_2_p
            v7 = Z1_3 * Y1_2_m
            v8 = v3 * Y1_2_p
            v9 = v4 * Y1_2_m
            v10 = m4 * Z1_3
            v11 = m4 * -Z1_3
            factor2_p = 1.0 / N3_p
            factor2_m = 1.0 / N3_m
            v12 = m6 * Z1_3
            v13 = v12 - m7 * v3
            v14 = v12 - m7 * v4
            v15 = m8 * factor2_p - m7
            v16 = m8 * factor2_m - m7
            v17 = m9 * factor2_p - m6
            v18 = m9 * factor2_m - m6
            v19 = Z1_3 * v15 + v3 * v17
            v20 = Z1_3 * v16 + v4 * v18
            c23_pp = v19 + w3_p * (factor2_p * v13)
            c23_pm = v19 + w3_p * (factor2_p * -v13)
            c23_mp = v20 + w3_m * (factor2_m * v14)
            c23_mm = v20 + w3_m * (factor2_m * -v14)
            v21 = m7 * Z1_3
            v22 = Z1_3 * v17 + v3 * -v15
            v23 = Z1_3 * v18 + v4 * -v16
            v24 = w3_p * (factor2_p * (v21 + m6 * v3))
            s23_pp = v22 - v24
            s23_pm = v22 + v24
            v25 = w3_m * (factor2_m * (v21 + m6 * v4))
            s23_mp = v23 - v25
            s23_mm = v23 + v25
            v26 = w1 * (v2 * (T23 * Y1 - T13 * wx))
            X4_pp = T33 * s23_pp - c23_pp * v26
            X4_pm = T33 * s23_pm - c23_pm * v26
            X4_mp = T33 * s23_mp + c23_mp * v26
            X4_mm = T33 * s23_mm + c23_mm * v26
            Y4 = w1 * (v2 * (T13 * Y1 + wx * T23))
            v27 = Y4 * Y4
            v28 = v27 + X4_pp * X4_pp
            v29 = v27 + X4_pm * X4_pm
            v30 = v27 + X4_mp * X4_mp
            v31 = v27 + X4_mm * X4_mm
            v32 = math.copysign(half_turn, Y4)
            v33 = math.copysign(half_turn, -Y4)
            v34 = w1 * (v2 * (wx * T22 + Y1 * T12))
            v35 = w1 * (v2 * (Y1 * T22 - wx * T12))
            v36 = w1 * (v2 * (wx * T21 + Y1 * T11))
            v37 = w1 * (v2 * (Y1 * T21 - wx * T11))
            v38 = Y4 * (c23_pp * v37 - s23_pp * T31) - -X4_pp * v36
            v39 = Y4 * (c23_pm * v37 - s23_pm * T31) - -X4_pm * v36
            v40 = Y4 * (c23_mp * v37 + s23_mp * T31) - X4_mp * v36
            v41 = Y4 * (c23_mm * v37 + s23_mm * T31) - X4_mm * v36
            v42 = w3_p * (m4 * v3)
            work[272 + k] = Y1
            work[288 + k] = v1
            work[304 + k] = D3_p
            work[320 + k] = D3_m
            work[336 + k] = w3_p
            work[352 + k] = w3_m
            work[368 + k] = v28
            work[384 + k] = v29
            work[400 + k] = v30
            work[416 + k] = v31
            work[432 + k] = v32
            work[448 + k] = v33
            work[464 + k] = v38
            work[480 + k] = v39
            work[496 + k] = v40
            work[512 + k] = v41
            work[528 + k] = Y1
            work[544 + k] = Y4
            work[560 + k] = Y4
            work[576 + k] = -Y4
            work[592 + k] = -Y4
            work[608 + k] = v38
            work[624 + k] = v39
            work[640 + k] = v40
            work[656 + k] = v41
            work[672 + k] = v42 - v6
            work[688 + k] = -(v6 + v42)
            work[704 + k] = w3_m * (m4 * v4) - v7
            work[720 + k] = w3_m * (m4 * -v4) - v7
            work[736 + k] = w3_p
            work[752 + k] = w3_m
            work[768 + k] = math.sqrt(v28)
            work[784 + k] = math.sqrt(v29)
            work[800 + k] = math.sqrt(v30)
            work[816 + k] = math.sqrt(v31)
            work[832 + k] = -wx
            work[848 + k] = -X4_pp
            work[864 + k] = -X4_pm
            work[880 + k] = -X4_mp
            work[896 + k] = -X4_mm
            work[912 + k] = Y4 * (c23_pp * v35 - s23_pp * T32) - -X4_pp * v34
            work[928 + k] = Y4 * (c23_pm * v35 - s23_pm * T32) - -X4_pm * v34
            work[944 + k] = Y4 * (c23_mp * v35 + s23_mp * T32) - X4_mp * v34
            work[960 + k] = Y4 * (c23_mm * v35 + s23_mm * T32) - X4_mm * v34
            work[976 + k] = -(v8 + w3_p * v10)
            work[992 + k] = -(v8 + w3_p * v11)
            work[1008 + k] = -(v9 + w3_m * v10)
            work[1024 + k] = -(v9 + w3_m * v11)
            work[1040 + k] = N3_p - k3
            work[1056 + k] = N3_m - k3
            work[1072 + k] = T33 * c23_pp + s23_pp * v26
            work[1088 + k] = T33 * c23_pm + s23_pm * v26
            work[1104 + k] = T33 * c23_mp - s23_mp * v26
            work[1120 + k] = T33 * c23_mm - s23_mm * v26
        for k in range(528, 832):
            work[k] = _atan2(work[k], work[k + 304])
        for k in range(0, 16):
            Y1 = work[272 + k]
            v1 = work[288 + k]
            D3_p = work[304 + k]
            D3_m = work[320 + k]
            w3_p = work[336 + k]
            w3_m = work[352 + k]
            v28 = work[368 + k]
            v29 = work[384 + k]
            v30 = work[400 + k]
            v31 = work[416 + k]
            v32 = work[432 + k]
            v33 = work[448 + k]
            v38 = work[464 + k]
            v39 = work[480 + k]
            v40 = work[496 + k]
            v41 = work[512 + k]
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
            q4_ppm = angle2 - v32
            q4_pmm = angle3 - v32
            q4_mpm = angle4 - v33
            q4_mmm = angle5 - v33
            q6_ppm = angle6 - math.copysign(half_turn, v38)
            q6_pmm = angle7 - math.copysign(half_turn, v39)
            q6_mpm = angle8 - math.copysign(half_turn, v40)
            q6_mmm = angle9 - math.copysign(half_turn, v41)
            v43 = angle10 - offset2
            v44 = angle11 - offset2
            v45 = angle12 - offset2
            v46 = angle13 - offset2
            q2_ppp = v43 + (-turn if half_turn < v43 else 0.0)
            q2_pmp = v44 + (-turn if half_turn < v44 else 0.0)
            q2_mpp = v45 + (-turn if half_turn < v45 else 0.0)
            q2_mmp = v46 + (-turn if half_turn < v46 else 0.0)
            v47 = angle14 - turn1 - offset3
            v48 = offset3 + (turn1 + angle14)
            v49 = angle15 - turn1 - offset3
            v50 = offset3 + (turn1 + angle15)
            q3_ppp = v47 + (-turn if half_turn < v47 else 0.0)
            q3_pmp = (-turn if half_turn < -v48 else 0.0) - v48
            q3_mpp = v49 + (-turn if half_turn < v49 else 0.0)
            q3_mmp = (-turn if half_turn < -v50 else 0.0) - v50
            v51 = angle16 - offset5
            v52 = offset5 + angle16
            v53 = angle17 - offset5
            v54 = offset5 + angle17
            v55 = angle18 - offset5
            v56 = offset5 + angle18
            v57 = angle19 - offset5
            v58 = offset5 + angle19
            q5_ppp = v51 + (turn if v51 <= -half_turn else 0.0)
            q5_ppm = (turn if -v52 <= -half_turn else 0.0) - v52
            q5_pmp = v53 + (turn if v53 <= -half_turn else 0.0)
            q5_pmm = (turn if -v54 <= -half_turn else 0.0) - v54
            q5_mpp = v55 + (turn if v55 <= -half_turn else 0.0)
            q5_mpm = (turn if -v56 <= -half_turn else 0.0) - v56
            q5_mmp = v57 + (turn if v57 <= -half_turn else 0.0)
            q5_mmm = (turn if -v58 <= -half_turn else 0.0) - v58
            q1_ppp = angle1 + (w3_p - w3_p)
            q1_mpp = angle1 - math.copysign(half_turn, Y1) + (w3_m - w3_m)
            _1136 = q1_ppp
            work[1136 + k] = _1136
            _1152 = q2_ppp
            work[1152 + k] = _1152
            _1168 = q3_ppp
            work[1168 + k] = _1168
            _1184 = angle2
            work[1184 + k] = _1184
            _1200 = q5_ppp
            work[1200 + k] = _1200
            _1216 = angle6
            work[1216 + k] = _1216
            _1232 = q4_ppm
            work[1232 + k] = _1232
            _1248 = q5_ppm
            work[1248 + k] = _1248
            _1264 = q6_ppm
            work[1264 + k] = _1264
            _1280 = q2_pmp
            work[1280 + k] = _1280
            _1296 = q3_pmp
            work[1296 + k] = _1296
            _1312 = angle3
            work[1312 + k] = _1312
            _1328 = q5_pmp
            work[1328 + k] = _1328
            _1344 = angle7
            work[1344 + k] = _1344
            _1360 = q4_pmm
            work[1360 + k] = _1360
            _1376 = q5_pmm
            work[1376 + k] = _1376
            _1392 = q6_pmm
            work[1392 + k] = _1392
            _1408 = q1_mpp
            work[1408 + k] = _1408
            _1424 = q2_mpp
            work[1424 + k] = _1424
            _1440 = q3_mpp
            work[1440 + k] = _1440
            _1456 = angle4
            work[1456 + k] = _1456
            _1472 = q5_mpp
            work[1472 + k] = _1472
            _1488 = angle8
            work[1488 + k] = _1488
            _1504 = q4_mpm
            work[1504 + k] = _1504
            _1520 = q5_mpm
            work[1520 + k] = _1520
            _1536 = q6_mpm
            work[1536 + k] = _1536
            _1552 = q2_mmp
            work[1552 + k] = _1552
            _1568 = q3_mmp
            work[1568 + k] = _1568
            _1584 = angle5
            work[1584 + k] = _1584
            _1600 = q5_mmp
            work[1600 + k] = _1600
            _1616 = angle9
            work[1616 + k] = _1616
            _1632 = q4_mmm
            work[1632 + k] = _1632
            _1648 = q5_mmm
            work[1648 + k] = _1648
            _1664 = q6_mmm
            work[1664 + k] = _1664
            work[1680 + k] = UNREACHABLE if _1136 != _1136 else OK
            work[1696 + k] = UNREACHABLE if _1136 != _1136 else OK
            work[1712 + k] = UNREACHABLE if _1136 != _1136 else OK
            work[1728 + k] = UNREACHABLE if _1136 != _1136 else OK
            work[1744 + k] = UNREACHABLE if _1408 != _1408 else OK
            work[1760 + k] = UNREACHABLE if _1408 != _1408 else OK
            work[1776 + k] = UNREACHABLE if _1408 != _1408 else OK
            work[1792 + k] = UNREACHABLE if _1408 != _1408 else OK
            work[256 + k] = (
                1.0 if v31 <= m10 or v30 <= m10 or v29 <= m10 or v28 <= m10 or abs(D3_m) <= m3 or v1
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
