"""spherical_wrist_all_offsets: Spherical wrist on an arm with every offset.

Inverse kinematics, generated from robots/spherical_wrist_all_offsets.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/spherical_wrist_all_offsets.yaml. The formulas and where they come
from: spherical_wrist_all_offsets.md.

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

NAME = "spherical_wrist_all_offsets"
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

d1 = 0.5  # joint offset 1 [m]
a1 = 0.12  # link length 1 [m]
d2 = 0.13  # joint offset 2 [m]
a2 = 0.43  # link length 2 [m]
d3 = 0.06  # joint offset 3 [m]
a3 = 0.09  # link length 3 [m]
d4 = 0.38  # joint offset 4 [m]
d6 = 0.07  # joint offset 6 [m]
free_limit_squared2 = 3.1684000000000017e-24  # square of a length that fixes no angle [m^2]
least_root1 = 5.628854235099716e-07  # a root of nothing, by rounding [m]
longest3 = 0.6732407360639862  # square of the longest reach [m^2]
shortest3 = 0.0015592639360138612  # square of the shortest reach [m^2]
boundary3 = 1.9612336995515177e-13  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.673240736063957  # the longest, where branches merge [m^2]
shortest3_apart = 0.001559263936015267  # the shortest, where branches merge [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.07  # d2 - d3 [m]
k2 = 0.004900000000000001  # k1^2 [m^2]
k3 = 2.4920000000031693e-14  # reach_slack1 * (2 * k1 + reach_slack1) [m^2]
k4 = 2.4920000000003178e-15  # merge_slack1 * (2 * k1 + merge_slack1) [m^2]
k5 = 0.5617977528089886  # 1 / arm_size1 [m^-1]
k6 = 0.3268  # 2 * d4 * a2 [m^2]
k7 = 0.0774  # 2 * a3 * a2 [m^2]
k8 = 0.3374  # a2^2 + (a3^2 + d4^2) [m^2]
k9 = 8.866112830151877  # 1 / (k6^2 + k7^2) [m^-4]
turn1 = -1.3382393849899876  # a constant angle [rad]
m1 = 2.4920000000003177e-12  # 1000 * k4 [m^2]
m2 = 1.96123369955058e-11  # 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 1.1627906976744187  # a coefficient of Y1_2
m4 = 0.03767441860465117  # a coefficient of Y1_2
m5 = 0.29508196721311475  # a coefficient of c23
m6 = 1.2459016393442623  # a coefficient of c23
m7 = 0.04036721311475411  # a coefficient of c23
m8 = 0.00956065573770492  # a coefficient of c23
m9 = 9.999999999999999e-09  # doubt_limit^2

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
    v3 = s2 * c3 + c2 * s3
    z3_x = v1 * c3 + x2_x * s3
    z3_y = v2 * c3 + x2_y * s3
    y4_z = s2 * s3 - c2 * c3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - s1 * s4
    x4_y = x3_y * c4 + c1 * s4
    v4 = v3 * c4
    v5 = s1 * c4 + x3_x * s4
    z4_y = c1 * c4 - x3_y * s4
    z4_z = v3 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 - z3_x * s5
    x5_y = x4_y * c5 - z3_y * s5
    x5_z = y4_z * s5 - v4 * c5
    z5_x = z3_x * c5 + x4_x * s5
    z5_y = z3_y * c5 + x4_y * s5
    v6 = y4_z * c5 + v4 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 - v5 * s6
    T[0, 1] = -(v5 * c6 + x5_x * s6)
    T[0, 2] = z5_x
    T[0, 3] = c1 * a1 + x2_x * a2 - s1 * d2 + x3_x * a3 + s1 * d3 + z3_x * d4 + z5_x * d6
    T[1, 0] = x5_y * c6 + z4_y * s6
    T[1, 1] = z4_y * c6 - x5_y * s6
    T[1, 2] = z5_y
    T[1, 3] = s1 * a1 + x2_y * a2 + c1 * d2 + x3_y * a3 - c1 * d3 + z3_y * d4 + z5_y * d6
    T[2, 0] = x5_z * c6 + z4_z * s6
    T[2, 1] = z4_z * c6 - x5_z * s6
    T[2, 2] = -v6
    T[2, 3] = d1 - s2 * a2 - v3 * a3 + -y4_z * d4 - v6 * d6
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
    x2_x = c1 * c2
    x2_y = s1 * c2
    v1 = c1 * s2
    v2 = s1 * s2
    p2_z = d1 - s2 * a2
    p2_x = p1_x + x2_x * a2 - s1 * d2
    p2_y = p1_y + x2_y * a2 + c1 * d2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v1 * s3
    x3_y = x2_y * c3 - v2 * s3
    v3 = s2 * c3 + c2 * s3
    z3_x = v1 * c3 + x2_x * s3
    z3_y = v2 * c3 + x2_y * s3
    y4_z = s2 * s3 - c2 * c3
    p3_z = p2_z - v3 * a3
    p3_x = p2_x + x3_x * a3 + s1 * d3
    p3_y = p2_y + x3_y * a3 - c1 * d3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    v4 = s1 * c4 + x3_x * s4
    z4_y = c1 * c4 - x3_y * s4
    z4_z = v3 * s4
    p4_x = p3_x + z3_x * d4
    p4_y = p3_y + z3_y * d4
    p4_z = p3_z + -y4_z * d4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    z5_x = z3_x * c5 + (x3_x * c4 - s1 * s4) * s5
    z5_y = z3_y * c5 + (x3_y * c4 + c1 * s4) * s5
    v5 = y4_z * c5 + v3 * c4 * s5
    p6_x = p4_x + z5_x * d6
    p6_y = p4_y + z5_y * d6
    p6_z = p4_z - v5 * d6
    v6 = p6_z - d1
    v7 = p6_z - p2_z
    v8 = p6_x - p3_x
    v9 = p6_y - p3_y
    v10 = p6_z - p3_z
    v11 = p6_x - p4_x
    v12 = p6_y - p4_y
    v13 = p6_z - p4_z
    J[0, 0] = -p6_y
    J[0, 1] = c1 * v6
    J[0, 2] = c1 * v7
    J[0, 3] = z3_y * v10 - -y4_z * v9
    J[0, 4] = z4_y * v13 - z4_z * v12
    J[0, 5] = z5_y * v13 + v5 * v12
    J[1, 0] = p6_x
    J[1, 1] = s1 * v6
    J[1, 2] = s1 * v7
    J[1, 3] = -y4_z * v8 - z3_x * v10
    J[1, 4] = z4_z * v11 + v4 * v13
    J[1, 5] = -(v5 * v11 + z5_x * v13)
    J[2, 1] = -(s1 * (p6_y - p1_y) + c1 * (p6_x - p1_x))
    J[2, 2] = -(s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x))
    J[2, 3] = z3_x * v9 - z3_y * v8
    J[2, 4] = -(v4 * v12 + z4_y * v11)
    J[2, 5] = z5_x * v12 - z5_y * v11
    J[3, 1] = -s1
    J[3, 2] = -s1
    J[3, 3] = z3_x
    J[3, 4] = -v4
    J[3, 5] = z5_x
    J[4, 1] = c1
    J[4, 2] = c1
    J[4, 3] = z3_y
    J[4, 4] = z4_y
    J[4, 5] = z5_y
    J[5, 0] = 1.0
    J[5, 3] = -y4_z
    J[5, 4] = z4_z
    J[5, 5] = -v5
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1 A6^-1 [3, 4]
    wx = T14 - T13 * d6
    Y1 = d6 * T23 - T24
    N1 = wx * wx + Y1 * Y1
    free1 = N1 <= free_limit_squared2
    D1 = N1 - k2
    apart1 = k4 < D1
    if not (-k3 <= D1):
        return  # out of reach
    w1 = math.sqrt(D1 if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else k1 * math.sqrt(N1)))
    v1 = wx * k1
    v2 = Y1 * k1

    # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = T34 - d6 * T33
    Z1_3 = wz - d1
    v4 = Z1_3 * Z1_3
    v5 = 1.0 if free1 else (w1 if apart1 else least_root1) * k5

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        root1 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else -(inverse1 * (v2 + wx * root1))
        s1 = math.sin(seed[0]) if free1 else inverse1 * (Y1 * root1 - v1)
        q1 = _atan2(s1, c1)

        # theta3
        v3 = root1 + a1
        N3 = v4 + v3 * v3
        K3 = N3 - k8
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= D3 * v5):
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        v6 = k6 * K3
        v7 = k7 * K3

        # theta4, type 2: U4[3, 3]
        v9 = T13 * c1 + T23 * s1
        Y4 = T13 * s1 - T23 * c1
        v10 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v11 = T12 * s1 - T22 * c1
        v12 = T12 * c1 + T22 * s1
        v14 = T11 * s1 - T21 * c1
        v15 = T11 * c1 + T21 * s1

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            root3 = w3 * e2
            s3 = (v6 + k7 * root3) * k9
            c3 = k9 * (v7 - k6 * root3)
            q3 = _atan2(s3, c3)

            # theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4]
            X1_2 = d4 * c3 - a3 * s3
            Y1_2 = a2 + (a3 * c3 + d4 * s3)
            v8 = v3 * X1_2 + Z1_3 * Y1_2
            C2 = Z1_3 * X1_2 - v3 * Y1_2
            w2 = math.sqrt(v8 * v8 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else -(v8 * factor2)
            q2 = _atan2(s2, c2)

            # theta4
            c23 = c3 * c2 - s3 * s2
            s23 = c3 * s2 + s3 * c2
            X4 = c23 * v9 - T33 * s23
            w4 = math.sqrt(X4 * X4 + v10)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T33 * c23 + s23 * v9

            # theta6
            v13 = c23 * v12 - T32 * s23
            v16 = c23 * v15 - T31 * s23

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
                q6 = _atan2(-(c4 * v14 + s4 * v16), -(c4 * v11 + s4 * v13))
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
_MISS_WEIGHT = np.array([0.5618, 0.5618, 0.5618, 1.0, 1.0, 1.0])


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
    wx = T14 - d6 * T13
    Y1 = d6 * T23 - T24
    N1 = wx * wx + Y1 * Y1
    D1 = N1 - k2
    w1 = math.sqrt(D1)
    inverse1 = 1.0 / N1
    v1 = inverse1 * (k1 * Y1)
    v2 = v1 + w1 * (wx * inverse1)
    v3 = v1 + w1 * (inverse1 * -wx)
    v4 = inverse1 * (k1 * wx)
    s1_p = w1 * (Y1 * inverse1) - v4
    s1_m = w1 * (inverse1 * -Y1) - v4

    # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    Z1_3 = T34 - d6 * T33 - d1
    v5 = a1 + w1
    v6 = a1 - w1
    v7 = Z1_3 * Z1_3
    N3_p = v7 + v5 * v5
    N3_m = v7 + v6 * v6
    D3_p = (longest3 - N3_p) * (N3_p - shortest3)
    D3_m = (longest3 - N3_m) * (N3_m - shortest3)
    v8 = k5 * w1
    w3_p = math.sqrt(D3_p)
    w3_m = math.sqrt(D3_m)

    # theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4]
    v11 = Z1_3 * (m4 + m3 * N3_p)
    v12 = Z1_3 * (m4 + m3 * N3_m)
    factor2_p = 1.0 / N3_p
    factor2_m = 1.0 / N3_m
    v13 = v5 * (m3 + m4 * factor2_p)
    v14 = v6 * (m3 + m4 * factor2_m)
    v15 = w3_p * (m3 * v5)

    # theta4, type 2: U4[3, 3]
    v16 = m5 * Z1_3
    v17 = m6 - m7 * factor2_p
    v18 = m6 - m7 * factor2_m
    v19 = m8 * factor2_p - m5
    v20 = m8 * factor2_m - m5
    v21 = Z1_3 * v17 + v5 * v19
    v22 = Z1_3 * v18 + v6 * v20
    v23 = w3_p * (factor2_p * (v16 + m6 * v5))
    c23_pp = v21 + v23
    c23_pm = v21 - v23
    v24 = w3_m * (factor2_m * (v16 + m6 * v6))
    c23_mp = v22 + v24
    c23_mm = v22 - v24
    v25 = m6 * Z1_3
    v26 = v25 - m5 * v5
    v27 = v25 - m5 * v6
    v28 = Z1_3 * v19 + v5 * -v17
    v29 = Z1_3 * v20 + v6 * -v18
    s23_pp = v28 + w3_p * (factor2_p * v26)
    s23_pm = v28 + w3_p * (factor2_p * -v26)
    s23_mp = v29 + w3_m * (factor2_m * v27)
    s23_mm = v29 + w3_m * (factor2_m * -v27)
    v30 = T23 * s1_p - T13 * v2
    v31 = T23 * s1_m - T13 * v3
    X4_pp = c23_pp * v30 - T33 * s23_pp
    X4_pm = c23_pm * v30 - T33 * s23_pm
    X4_mp = c23_mp * v31 - T33 * s23_mp
    X4_mm = c23_mm * v31 - T33 * s23_mm
    Y4_p = T13 * s1_p + T23 * v2
    Y4_m = T13 * s1_m + T23 * v3
    v32 = Y4_p * Y4_p
    v33 = Y4_m * Y4_m
    v34 = v32 + X4_pp * X4_pp
    v35 = v32 + X4_pm * X4_pm
    v36 = v33 + X4_mp * X4_mp
    v37 = v33 + X4_mm * X4_mm
    v38 = math.copysign(half_turn, Y4_p)
    v39 = math.copysign(half_turn, Y4_m)

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v40 = s1_p * T12 + v2 * T22
    v41 = s1_m * T12 + v3 * T22
    v42 = s1_p * T22 - v2 * T12
    v43 = s1_m * T22 - v3 * T12
    v44 = s1_p * T11 + v2 * T21
    v45 = s1_m * T11 + v3 * T21
    v46 = s1_p * T21 - v2 * T11
    v47 = s1_m * T21 - v3 * T11

    # a joint is free, or branches meet
    if (
        v37 <= m9 or v36 <= m9 or v35 <= m9 or v34 <= m9 or abs(D3_m * v8) <= m2 or abs(D1) <= m1 or
        abs(D3_p * v8) <= m2
    ):
        return False

    # angles, side by side
    room[0] = w3_p
    room[1] = w3_m
    room[2] = -(factor2_p * (v11 - v15))
    room[3] = -(factor2_p * (v11 + v15))
    room[4] = -(factor2_m * (v12 - w3_m * (m3 * v6)))
    room[5] = -(factor2_m * (v12 - w3_m * (m3 * -v6)))
    room[6] = Y4_p
    room[7] = Y4_p
    room[8] = Y4_m
    room[9] = Y4_m
    room[10] = -math.sqrt(v34)
    room[11] = -math.sqrt(v35)
    room[12] = -math.sqrt(v36)
    room[13] = -math.sqrt(v37)
    room[14] = -(-X4_pp * v44 + Y4_p * (c23_pp * v46 - s23_pp * T31))
    room[15] = -(-X4_pm * v44 + Y4_p * (c23_pm * v46 - s23_pm * T31))
    room[16] = -(-X4_mp * v45 + Y4_m * (c23_mp * v47 - s23_mp * T31))
    room[17] = -(-X4_mm * v45 + Y4_m * (c23_mm * v47 - s23_mm * T31))
    room[18] = s1_p
    room[19] = s1_m
    room[24] = N3_p - k8
    room[25] = N3_m - k8
    room[26] = -(v13 + w3_p * (m3 * (Z1_3 * factor2_p)))
    room[27] = -(v13 + w3_p * (m3 * (-Z1_3 * factor2_p)))
    room[28] = -(v14 + w3_m * (m3 * (Z1_3 * factor2_m)))
    room[29] = -(v14 + w3_m * (m3 * (-Z1_3 * factor2_m)))
    room[30] = -X4_pp
    room[31] = -X4_pm
    room[32] = -X4_mp
    room[33] = -X4_mm
    room[34] = T33 * c23_pp + s23_pp * v30
    room[35] = T33 * c23_pm + s23_pm * v30
    room[36] = T33 * c23_mp + s23_mp * v31
    room[37] = T33 * c23_mm + s23_mm * v31
    room[38] = -(-X4_pp * v40 + Y4_p * (c23_pp * v42 - s23_pp * T32))
    room[39] = -(-X4_pm * v40 + Y4_p * (c23_pm * v42 - s23_pm * T32))
    room[40] = -(-X4_mp * v41 + Y4_m * (c23_mp * v43 - s23_mp * T32))
    room[41] = -(-X4_mm * v41 + Y4_m * (c23_mm * v43 - s23_mm * T32))
    room[42] = -v2
    room[43] = -v3
    for k in range(20, 24):
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

    # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    q3__pp = angle1 - turn1
    v9 = turn1 + angle1
    q3__mp = angle2 - turn1
    v10 = turn1 + angle2

    # theta4, type 2: U4[3, 3]
    q4_ppm = angle7 - v38
    q4_pmm = angle8 - v38
    q4_mpm = angle9 - v39
    q4_mmm = angle10 - v39

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    q6_ppm = (
        angle15 - math.copysign(half_turn, -(-X4_pp * v44 + Y4_p * (c23_pp * v46 - s23_pp * T31)))
    )
    q6_pmm = (
        angle16 - math.copysign(half_turn, -(-X4_pm * v44 + Y4_p * (c23_pm * v46 - s23_pm * T31)))
    )
    q6_mpm = (
        angle17 - math.copysign(half_turn, -(-X4_mp * v45 + Y4_m * (c23_mp * v47 - s23_mp * T31)))
    )
    q6_mmm = (
        angle18 - math.copysign(half_turn, -(-X4_mm * v45 + Y4_m * (c23_mm * v47 - s23_mm * T31)))
    )

    # joint values
    q3_ppp = q3__pp + (-turn if half_turn < q3__pp else 0.0)
    q3_pmp = (-turn if half_turn < -v9 else 0.0) - v9
    q3_mpp = q3__mp + (-turn if half_turn < q3__mp else 0.0)
    q3_mmp = (-turn if half_turn < -v10 else 0.0) - v10
    q1_ppp = angle19 + (w3_p - w3_p)
    q1_mpp = angle20 + (w3_m - w3_m)

    q[0, 0] = q1_ppp
    q[0, 1] = angle3
    q[0, 2] = q3_ppp
    q[0, 3] = angle7
    q[0, 4] = angle11
    q[0, 5] = angle15
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_ppp
    q[1, 1] = angle3
    q[1, 2] = q3_ppp
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
    q[4, 2] = q3_mpp
    q[4, 3] = angle9
    q[4, 4] = angle13
    q[4, 5] = angle17
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else OK
    q[5, 0] = q1_mpp
    q[5, 1] = angle5
    q[5, 2] = q3_mpp
    q[5, 3] = q4_mpm
    q[5, 4] = -angle13
    q[5, 5] = q6_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else OK
    q[6, 0] = q1_mpp
    q[6, 1] = angle6
    q[6, 2] = q3_mmp
    q[6, 3] = angle10
    q[6, 4] = angle14
    q[6, 5] = angle18
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else OK
    q[7, 0] = q1_mpp
    q[7, 1] = angle6
    q[7, 2] = q3_mmp
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
    [1392, 1408, 1424, 1440, 1456, 1472],
    [1392, 1408, 1424, 1488, 1504, 1520],
    [1392, 1536, 1552, 1568, 1584, 1600],
    [1392, 1536, 1552, 1616, 1632, 1648],
    [1664, 1680, 1696, 1712, 1728, 1744],
    [1664, 1680, 1696, 1760, 1776, 1792],
    [1664, 1808, 1824, 1840, 1856, 1872],
    [1664, 1808, 1824, 1888, 1904, 1920],
])
_KINDS = np.array([1936, 1952, 1968, 1984, 2000, 2016, 2032, 2048])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(2064), 2064)
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
            N1 = wx * wx + Y1 * Y1
            D1 = N1 - k2
            w1 = math.sqrt(D1)
            inverse1 = 1.0 / N1
            v1 = inverse1 * (k1 * Y1)
            v2 = v1 + w1 * (wx * inverse1)
            v3 = v1 + w1 * (inverse1 * -wx)
            v4 = inverse1 * (k1 * wx)
            s1_p = w1 * (Y1 * inverse1) - v4
            s1_m = w1 * (inverse1 * -Y1) - v4
            Z1_3 = T34 - d6 * T33 - d1
            v5 = a1 + w1
            v6 = a1 - w1
            v7 = Z1_3 * Z1_3
            N3_p = v7 + v5 * v5
            N3_m = v7 + v6 * v6
            D3_p = (longest3 - N3_p) * (N3_p - shortest3)
            D3_m = (longest3 - N3_m) * (N3_m - shortest3)
            v8 = k5 * w1
            w3_p = math.sqrt(D3_p)
            w3_m = math.sqrt(D3_m)
            v11 = Z1_3 * (m4 + m3 * N3_p)
            v12 = Z1_3 * (m4 + m3 * N3_m)
            factor2_p = 1.0 / N3_p
            factor2_m = 1.0 / N3_m
            v13 = v5 * (m3 + m4 * factor2_p)
            v14 = v6 * (m3 + m4 * factor2_m)
            v15 = w3_p * (m3 * v5)
            v16 = m5 * Z1_3
            v17 = m6 - m7 * factor2_p
            v18 = m6 - m7 * factor2_m
            v19 = m8 * factor2_p - m5
            v20 = m8 * factor2_m - m5
            v21 = Z1_3 * v17 + v5 * v19
            v22 = Z1_3 * v18 + v6 * v20
            v23 = w3_p * (factor2_p * (v16 + m6 * v5))
            c23_pp = v21 + v23
            c23_pm = v21 - v23
            v24 = w3_m * (factor2_m * (v16 + m6 * v6))
            c23_mp = v22 + v24
            c23_mm = v22 - v24
            v25 = m6 * Z1_3
            v26 = v25 - m5 * v5
            v27 = v25 - m5 * v6
            v28 = Z1_3 * v19 + v5 * -v17
            v29 = Z1_3 * v20 + v6 * -v18
            s23_pp = v28 + w3_p * (factor2_p * v26)
            s23_pm = v28 + w3_p * (factor2_p * -v26)
            s23_mp = v29 + w3_m * (factor2_m * v27)
            s23_mm = v29 + w3_m * (factor2_m * -v27)
            v30 = T23 * s1_p - T13 * v2
            v31 = T23 * s1_m - T13 * v3
            X4_pp = c23_pp * v30 - T33 * s23_pp
            X4_pm = c23_pm * v30 - T33 * s23_pm
            X4_mp = c23_mp * v31 - T33 * s23_mp
            X4_mm = c23_mm * v31 - T33 * s23_mm
            Y4_p = T13 * s1_p + T23 * v2
            Y4_m = T13 * s1_m + T23 * v3
            v32 = Y4_p * Y4_p
            v33 = Y4_m * Y4_m
            v34 = v32 + X4_pp * X4_pp
            v35 = v32 + X4_pm * X4_pm
            v36 = v33 + X4_mp * X4_mp
            v37 = v33 + X4_mm * X4_mm
            v38 = math.copysign(half_turn, Y4_p)
            v39 = math.copysign(half_turn, Y4_m)
            v40 = s1_p * T12 + v2 * T22
            v41 = s1_m * T12 + v3 * T22
            v42 = s1_p * T22 - v2 * T12
            v43 = s1_m * T22 - v3 * T12
            v44 = s1_p * T11 + v2 * T21
            v45 = s1_m * T11 + v3 * T21
            v46 = s1_p * T21 - v2 * T11
            v47 = s1_m * T21 - v3 * T11
            work[272 + k] = D1
            work[288 + k] = D3_p
            work[304 + k] = D3_m
            work[320 + k] = v8
            work[336 + k] = w3_p
            work[352 + k] = w3_m
            work[368 + k] = c23_pp
            work[384 + k] = c23_pm
            work[400 + k] = c23_mp
            work[416 + k] = c23_mm
            work[432 + k] = s23_pp
            work[448 + k] = s23_pm
            work[464 + k] = s23_mp
            work[480 + k] = s23_mm
            work[496 + k] = X4_pp
            work[512 + k] = X4_pm
            work[528 + k] = X4_mp
            work[544 + k] = X4_mm
            work[560 + k] = Y4_p
            work[576 + k] = Y4_m
            work[592 + k] = v34
            work[608 + k] = v35
            work[624 + k] = v36
            work[640 + k] = v37
            work[656 + k] = v38
            work[672 + k] = v39
            work[688 + k] = v44
            work[704 + k] = v45
            work[720 + k] = v46
            work[736 + k] = v47
            work[752 + k] = w3_p
            work[768 + k] = w3_m
            work[784 + k] = -(factor2_p * (v11 - v15))
            work[800 + k] = -(factor2_p * (v11 + v15))
            work[816 + k] = -(factor2_m * (v12 - w3_m * (m3 * v6)))
            work[832 + k] = -(factor2_m * (v12 - w3_m * (m3 * -v6)))
            work[848 + k] = Y4_p
            work[864 + k] = Y4_p
            work[880 + k] = Y4_m
            work[896 + k] = Y4_m
            work[912 + k] = -math.sqrt(v34)
            work[928 + k] = -math.sqrt(v35)
            work[944 + k] = -math.sqrt(v36)
            work[960 + k] = -math.sqrt(v37)
            work[976 + k] = -(-X4_pp * v44 + Y4_p * (c23_pp * v46 - s23_pp * T31))
            work[992 + k] = -(-X4_pm * v44 + Y4_p * (c23_pm * v46 - s23_pm * T31))
            work[1008 + k] = -(-X4_mp * v45 + Y4_m * (c23_mp * v47 - s23_mp * T31))
            work[1024 + k] = -(-X4_mm * v45 + Y4_m * (c23_mm * v47 - s23_mm * T31))
            work[1040 + k] = s1_p
            work[1056 + k] = s1_m
            work[1072 + k] = N3_p - k8
            work[1088 + k] = N3_m - k8
            work[1104 + k] = -(v13 + w3_p * (m3 * (Z1_3 * factor2_p)))
            work[1120 + k] = -(v13 + w3_p * (m3 * (-Z1_3 * factor2_p)))
            work[1136 + k] = -(v14 + w3_m * (m3 * (Z1_3 * factor2_m)))
            work[1152 + k] = -(v14 + w3_m * (m3 * (-Z1_3 * factor2_m)))
            work[1168 + k] = -X4_pp
            work[1184 + k] = -X4_pm
            work[1200 + k] = -X4_mp
            work[1216 + k] = -X4_mm
            work[1232 + k] = T33 * c23_pp + s23_pp * v30
            work[1248 + k] = T33 * c23_pm + s23_pm * v30
            work[1264 + k] = T33 * c23_mp + s23_mp * v31
            work[1280 + k] = T33 * c23_mm + s23_mm * v31
            work[1296 + k] = -(-X4_pp * v40 + Y4_p * (c23_pp * v42 - s23_pp * T32))
            work[1312 + k] = -(-X4_pm * v40 + Y4_p * (c23_pm * v42 - s23_pm * T32))
            work[1328 + k] = -(-X4_mp * v41 + Y4_m * (c23_mp * v43 - s23_mp * T32))
            work[1344 + k] = -(-X4_mm * v41 + Y4_m * (c23_mm * v43 - s23_mm * T32))
            work[1360 + k] = -v2
            work[1376 + k] = -v3
        for k in range(752, 1072):
            work[k] = _atan2(work[k], work[k + 320])
        for k in range(0, 16):
            T31 = work[128 + k]
            D1 = work[272 + k]
            D3_p = work[288 + k]
            D3_m = work[304 + k]
            v8 = work[320 + k]
            w3_p = work[336 + k]
            w3_m = work[352 + k]
            c23_pp = work[368 + k]
            c23_pm = work[384 + k]
            c23_mp = work[400 + k]
            c23_mm = work[416 + k]
            s23_pp = work[432 + k]
            s23_pm = work[448 + k]
            s23_mp = work[464 + k]
            s23_mm = work[480 + k]
            X4_pp = work[496 + k]
            X4_pm = work[512 + k]
            X4_mp = work[528 + k]
            X4_mm = work[544 + k]
            Y4_p = work[560 + k]
            Y4_m = work[576 + k]
            v34 = work[592 + k]
            v35 = work[608 + k]
            v36 = work[624 + k]
            v37 = work[640 + k]
            v38 = work[656 + k]
            v39 = work[672 + k]
            v44 = work[688 + k]
            v45 = work[704 + k]
            v46 = work[720 + k]
            v47 = work[736 + k]
            angle1 = work[752 + k]
            angle2 = work[768 + k]
            angle3 = work[784 + k]
            angle4 = work[800 + k]
            angle5 = work[816 + k]
            angle6 = work[832 + k]
            angle7 = work[848 + k]
            angle8 = work[864 + k]
            angle9 = work[880 + k]
            angle10 = work[896 + k]
            angle11 = work[912 + k]
            angle12 = work[928 + k]
            angle13 = work[944 + k]
            angle14 = work[960 + k]
            angle15 = work[976 + k]
            angle16 = work[992 + k]
            angle17 = work[1008 + k]
            angle18 = work[1024 + k]
            angle19 = work[1040 + k]
            angle20 = work[1056 + k]
            q3__pp = angle1 - turn1
            v9 = turn1 + angle1
            q3__mp = angle2 - turn1
            v10 = turn1 + angle2
            q4_ppm = angle7 - v38
            q4_pmm = angle8 - v38
            q4_mpm = angle9 - v39
            q4_mmm = angle10 - v39
            q6_ppm = (
                angle15 - math.copysign(half_turn, -(-X4_pp * v44 + Y4_p * (c23_pp * v46 - s23_pp *
                T31)))
            )
            q6_pmm = (
                angle16 - math.copysign(half_turn, -(-X4_pm * v44 + Y4_p * (c23_pm * v46 - s23_pm *
                T31)))
            )
            q6_mpm = (
                angle17 - math.copysign(half_turn, -(-X4_mp * v45 + Y4_m * (c23_mp * v47 - s23_mp *
                T31)))
            )
            q6_mmm = (
                angle18 - math.copysign(half_turn, -(-X4_mm * v45 + Y4_m * (c23_mm * v47 - s23_mm *
                T31)))
            )
            q3_ppp = q3__pp + (-turn if half_turn < q3__pp else 0.0)
            q3_pmp = (-turn if half_turn < -v9 else 0.0) - v9
            q3_mpp = q3__mp + (-turn if half_turn < q3__mp else 0.0)
            q3_mmp = (-turn if half_turn < -v10 else 0.0) - v10
            q1_ppp = angle19 + (w3_p - w3_p)
            q1_mpp = angle20 + (w3_m - w3_m)
            _1392 = q1_ppp
            work[1392 + k] = _1392
            _1408 = angle3
            work[1408 + k] = _1408
            _1424 = q3_ppp
            work[1424 + k] = _1424
            _1440 = angle7
            work[1440 + k] = _1440
            _1456 = angle11
            work[1456 + k] = _1456
            _1472 = angle15
            work[1472 + k] = _1472
            _1488 = q4_ppm
            work[1488 + k] = _1488
            _1504 = -angle11
            work[1504 + k] = _1504
            _1520 = q6_ppm
            work[1520 + k] = _1520
            _1536 = angle4
            work[1536 + k] = _1536
            _1552 = q3_pmp
            work[1552 + k] = _1552
            _1568 = angle8
            work[1568 + k] = _1568
            _1584 = angle12
            work[1584 + k] = _1584
            _1600 = angle16
            work[1600 + k] = _1600
            _1616 = q4_pmm
            work[1616 + k] = _1616
            _1632 = -angle12
            work[1632 + k] = _1632
            _1648 = q6_pmm
            work[1648 + k] = _1648
            _1664 = q1_mpp
            work[1664 + k] = _1664
            _1680 = angle5
            work[1680 + k] = _1680
            _1696 = q3_mpp
            work[1696 + k] = _1696
            _1712 = angle9
            work[1712 + k] = _1712
            _1728 = angle13
            work[1728 + k] = _1728
            _1744 = angle17
            work[1744 + k] = _1744
            _1760 = q4_mpm
            work[1760 + k] = _1760
            _1776 = -angle13
            work[1776 + k] = _1776
            _1792 = q6_mpm
            work[1792 + k] = _1792
            _1808 = angle6
            work[1808 + k] = _1808
            _1824 = q3_mmp
            work[1824 + k] = _1824
            _1840 = angle10
            work[1840 + k] = _1840
            _1856 = angle14
            work[1856 + k] = _1856
            _1872 = angle18
            work[1872 + k] = _1872
            _1888 = q4_mmm
            work[1888 + k] = _1888
            _1904 = -angle14
            work[1904 + k] = _1904
            _1920 = q6_mmm
            work[1920 + k] = _1920
            work[1936 + k] = UNREACHABLE if _1392 != _1392 else OK
            work[1952 + k] = UNREACHABLE if _1392 != _1392 else OK
            work[1968 + k] = UNREACHABLE if _1392 != _1392 else OK
            work[1984 + k] = UNREACHABLE if _1392 != _1392 else OK
            work[2000 + k] = UNREACHABLE if _1664 != _1664 else OK
            work[2016 + k] = UNREACHABLE if _1664 != _1664 else OK
            work[2032 + k] = UNREACHABLE if _1664 != _1664 else OK
            work[2048 + k] = UNREACHABLE if _1664 != _1664 else OK
            work[256 + k] = (
                1.0 if v37 <= m9 or v36 <= m9 or v35 <= m9 or v34 <= m9 or abs(D3_m * v8) <= m2 or
                abs(D1) <= m1 or abs(D3_p * v8) <= m2 else work[256 + k]
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
