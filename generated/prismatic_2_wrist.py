"""prismatic_2_wrist: Slide as joint 2, spherical wrist.

Inverse kinematics, generated from robots/prismatic_2_wrist.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/prismatic_2_wrist.yaml. The formulas and where they come from:
prismatic_2_wrist.md.

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

NAME = "prismatic_2_wrist"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RPRRRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "shoulder+-elbow+-noflip",
    "shoulder+-elbow+-flip",
    "shoulder+-elbow--noflip",
    "shoulder+-elbow--flip",
    "shoulder--elbow+-noflip",
    "shoulder--elbow+-flip",
    "shoulder--elbow--noflip",
    "shoulder--elbow--flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

a1 = 0.1  # link length 1 [m]
cat2 = 0.9800665778412416  # cosine of the angle of joint 2
sat2 = 0.19866933079506122  # sine of the angle of joint 2
a2 = 0.15  # link length 2 [m]
d3 = 0.1  # joint offset 3 [m]
a3 = 0.08  # link length 3 [m]
d4 = 0.43  # joint offset 4 [m]
d6 = 0.08  # joint offset 6 [m]
free_limit_squared2 = 1.5375999999999999e-24  # square of a length that fixes no angle [m^2]
reach_slack1 = 1.24e-13  # rounding at the boundary of the workspace [m]
merge_slack1 = 1.24e-14  # nearer to that boundary two branches are one [m]
# the same where they follow an angle that is good to few digits [m]
blur_slack1 = 1.2399999999999999e-11
# square of a length whose direction is good to few digits [m^2]
near_limit_squared2 = 1.5376000000000001e-06
free_limit1 = 1.24e-12  # a length that fixes no angle [m]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.4138869064318786  # d1 * cat2 + (a1 * sat2 + d3) [m]
k2 = 0.08542781224187632  # d4 * sat2 [m]
k3 = 0.0158935464636049  # a3 * sat2 [m]
k4 = 0.007550515923624042  # k2^2 + k3^2 [m^2]
k5 = 0.36820625816486496  # d1 + (cat2 * d3 - a2 * sat2) [m]
k6 = 132.4412808495909  # 1 / k4 [m^-2]
f1 = 0.2701996003807408  # d1 - sat2 * a2 [m]
f2 = 0.09800665778412417  # d3 * cat2 [m]
doubt_limit_squared2 = 1.5375999999999998e-08  # square of a length that fixes no angle [m^2]
m1 = 1.2399999999999999e-11  # 1000 * merge_slack1 [m]
m2 = 1.2399999999999999e-10  # 10 * blur_slack1 [m]
m3 = 11.314168873492461  # a coefficient of v12
m4 = 0.7750600530519154  # a coefficient of v12
m5 = 2.1049616508823186  # a coefficient of v12
m6 = 4.165947785154044  # a coefficient of s3
m7 = 9.999999999999999e-09  # doubt_limit^2

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1.24e-09, 1e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 0.6503642039542143, 1.0, 1.0, 1.0, 1.0])
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
    x2_x = c1 * cat2
    x2_y = s1 * cat2
    z2_x = c1 * sat2
    z2_y = s1 * sat2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - s1 * s3
    x3_y = x2_y * c3 + c1 * s3
    v1 = sat2 * c3
    v2 = s1 * c3 + x2_x * s3
    z3_y = c1 * c3 - x2_y * s3
    z3_z = sat2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - z2_x * s4
    x4_y = x3_y * c4 - z2_y * s4
    v3 = v1 * c4 + cat2 * s4
    z4_x = z2_x * c4 + x3_x * s4
    z4_y = z2_y * c4 + x3_y * s4
    y5_z = v1 * s4 - cat2 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 - v2 * s5
    x5_y = x4_y * c5 + z3_y * s5
    x5_z = z3_z * s5 - v3 * c5
    v4 = v2 * c5 + x4_x * s5
    z5_y = z3_y * c5 - x4_y * s5
    z5_z = z3_z * c5 + v3 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 - z4_x * s6
    T[0, 1] = -(z4_x * c6 + x5_x * s6)
    T[0, 2] = -v4
    T[0, 3] = c1 * a1 - s1 * q[1] + x2_x * a2 + x3_x * a3 + z2_x * d3 - v2 * d4 - v4 * d6
    T[1, 0] = x5_y * c6 - z4_y * s6
    T[1, 1] = -(z4_y * c6 + x5_y * s6)
    T[1, 2] = z5_y
    T[1, 3] = s1 * a1 + c1 * q[1] + x2_y * a2 + x3_y * a3 + z2_y * d3 + z3_y * d4 + z5_y * d6
    T[2, 0] = x5_z * c6 + y5_z * s6
    T[2, 1] = y5_z * c6 - x5_z * s6
    T[2, 2] = z5_z
    T[2, 3] = f1 - v1 * a3 + f2 + z3_z * d4 + z5_z * d6
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
    x2_x = c1 * cat2
    x2_y = s1 * cat2
    z2_x = c1 * sat2
    z2_y = s1 * sat2
    p2_x = c1 * a1 - s1 * q[1] + x2_x * a2
    p2_y = s1 * a1 + c1 * q[1] + x2_y * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - s1 * s3
    x3_y = x2_y * c3 + c1 * s3
    v1 = sat2 * c3
    v2 = s1 * c3 + x2_x * s3
    z3_y = c1 * c3 - x2_y * s3
    z3_z = sat2 * s3
    p3_x = p2_x + x3_x * a3 + z2_x * d3
    p3_y = p2_y + x3_y * a3 + z2_y * d3
    p3_z = f1 - v1 * a3 + f2
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    z4_x = z2_x * c4 + x3_x * s4
    z4_y = z2_y * c4 + x3_y * s4
    p4_x = p3_x - v2 * d4
    p4_y = p3_y + z3_y * d4
    p4_z = p3_z + z3_z * d4
    z4_z = cat2 * c4 - v1 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v3 = v2 * c5 + (x3_x * c4 - z2_x * s4) * s5
    z5_y = z3_y * c5 - (x3_y * c4 - z2_y * s4) * s5
    z5_z = z3_z * c5 + (v1 * c4 + cat2 * s4) * s5
    p6_x = p4_x - v3 * d6
    p6_y = p4_y + z5_y * d6
    p6_z = p4_z + z5_z * d6
    v4 = p6_x - p2_x
    v5 = p6_y - p2_y
    v6 = p6_z - f1
    v7 = p6_x - p3_x
    v8 = p6_y - p3_y
    v9 = p6_z - p3_z
    v10 = p6_x - p4_x
    v11 = p6_y - p4_y
    v12 = p6_z - p4_z
    J[0, 0] = -p6_y
    J[0, 1] = -s1
    J[0, 2] = z2_y * v6 - cat2 * v5
    J[0, 3] = z3_y * v9 - z3_z * v8
    J[0, 4] = z4_y * v12 - z4_z * v11
    J[0, 5] = z5_y * v12 - z5_z * v11
    J[1, 0] = p6_x
    J[1, 1] = c1
    J[1, 2] = cat2 * v4 - z2_x * v6
    J[1, 3] = z3_z * v7 + v2 * v9
    J[1, 4] = z4_z * v10 - z4_x * v12
    J[1, 5] = z5_z * v10 + v3 * v12
    J[2, 2] = z2_x * v5 - z2_y * v4
    J[2, 3] = -(v2 * v8 + z3_y * v7)
    J[2, 4] = z4_x * v11 - z4_y * v10
    J[2, 5] = -(v3 * v11 + z5_y * v10)
    J[3, 2] = z2_x
    J[3, 3] = -v2
    J[3, 4] = z4_x
    J[3, 5] = -v3
    J[4, 2] = z2_y
    J[4, 3] = z3_y
    J[4, 4] = z4_y
    J[4, 5] = z5_y
    J[5, 0] = 1.0
    J[5, 2] = cat2
    J[5, 3] = z3_z
    J[5, 4] = z4_z
    J[5, 5] = z5_z
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U2 A6^-1 [3, 4]
    wy = T24 - T23 * d6
    v1 = wy * sat2
    wx = T14 - d6 * T13
    v2 = sat2 * wx
    N1 = v1 * v1 + v2 * v2
    free1 = N1 <= free_limit_squared2
    wz = T34 - d6 * T33
    Z1 = wz * cat2 - k1
    D1 = N1 - Z1 * Z1
    v3 = abs(Z1)
    v4 = 2.0 * v3
    apart1 = merge_slack1 * (v4 + merge_slack1) < D1
    if not (-(reach_slack1 * (v4 + reach_slack1)) <= D1):
        return  # out of reach
    w1 = math.sqrt(D1 if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else v3 * math.sqrt(N1)))
    v5 = v1 * Z1
    v6 = v2 * Z1
    near1 = N1 <= near_limit_squared2
    v7 = v1 * math.cos(seed[0]) - v2 * math.sin(seed[0])
    off1 = abs(Z1 + (v1 * math.sin(seed[0]) + v2 * math.cos(seed[0]))) if near1 else 1.0
    v8 = off1 <= free_limit1

    # theta3, type 2: U0 A6^-1 [3, 4]
    Z3 = wz - k5
    D3 = k4 - Z3 * Z3
    v9 = 2.0 * abs(Z3)
    apart3 = merge_slack1 * (merge_slack1 + v9) < D3
    if not (-(reach_slack1 * (reach_slack1 + v9)) <= D3):
        return  # out of reach
    w3 = math.sqrt(D3 if apart3 else 0.0)
    v10 = k2 * Z3
    v11 = k3 * Z3

    # theta4, type 2: U4[3, 3]
    v15 = T13 * cat2
    v16 = T23 * cat2
    v17 = sat2 * T33
    v20 = sat2 * T13
    v21 = T23 * sat2
    v22 = T33 * cat2

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v25 = sat2 * T12
    v26 = T22 * sat2
    v27 = T32 * cat2
    v29 = T12 * cat2
    v30 = T22 * cat2
    v31 = sat2 * T32
    v35 = sat2 * T11
    v36 = T21 * sat2
    v37 = T31 * cat2
    v39 = T11 * cat2
    v40 = T21 * cat2
    v41 = sat2 * T31

    for i1 in range(2):  # shoulder+, shoulder-
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        root1 = w1 * e1
        ahead1 = root1 * v7 if near1 else -1.0
        same1 = near1 and 0.0 <= ahead1 and v8
        held1 = free1 or same1
        c1 = math.cos(seed[0]) if held1 else inverse1 * (v1 * root1 - v6)
        s1 = math.sin(seed[0]) if held1 else -(inverse1 * (v5 + v2 * root1))
        q1 = _atan2(s1, c1)

        # r2, type 1: U1 A6^-1 [3, 4]
        v14 = c1 * -wy + wx * s1

        # theta4
        v18 = c1 * v15 + s1 * v16 - v17
        v19 = T13 * s1 - T23 * c1
        v23 = c1 * v20 + s1 * v21 + v22
        v24 = v23 * v23

        # theta6
        v28 = c1 * v25 + s1 * v26 + v27
        v32 = c1 * v29 + s1 * v30 - v31
        v33 = T22 * c1 - T12 * s1
        v38 = c1 * v35 + s1 * v36 + v37
        v42 = c1 * v39 + s1 * v40 - v41
        v43 = T21 * c1 - T11 * s1

        for i2 in range(2):  # elbow+, elbow-
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and (not apart3 or (near1 and not (blur_slack1 * (blur_slack1 + v9) < D3))):
                continue  # both signs give the same
            root3 = w3 * e2
            v12 = k6 * (v11 + k2 * root3)
            s3 = k6 * (v10 - k3 * root3)
            q3 = _atan2(s3, -v12)

            # r2
            v13 = a3 * s3 - d4 * v12

            # theta4
            X4 = v12 * v18 - s3 * -v19
            w4 = math.sqrt(X4 * X4 + v24)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = v12 * v19 - s3 * v18

            # theta6
            v34 = s3 * v33 - v12 * v32
            v44 = s3 * v43 - v12 * v42

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4
                if e3 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e3 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else -(v23 * factor4)
                q4 = _atan2(s4, c4)

                # theta5
                q5 = _atan2(-(w4 * e3), c5)

                # theta6
                q6 = _atan2(-(c4 * v38 + s4 * v44), -(c4 * v28 + s4 * v34))
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0] = q1
                q[row, 1] = -(v13 + v14)
                q[row, 2] = q3
                q[row, 3] = q4
                q[row, 4] = q5
                q[row, 5] = q6
                status[row] = FREE_JOINT if free1 or free4 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px * px * px) and math.isfinite(py * py * py) and math.isfinite(pz * pz * pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.24, 1.0, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.8065, 0.8065, 0.8065, 1.0, 1.0, 1.0])


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
    room = carray(_room(32), 32)

    # theta1, type 2: U2 A6^-1 [3, 4]
    wy = T24 - d6 * T23
    v1 = sat2 * wy
    wx = T14 - d6 * T13
    v2 = sat2 * wx
    N1 = v1 * v1 + v2 * v2
    wz = T34 - d6 * T33
    Z1 = cat2 * wz - k1
    D1 = N1 - Z1 * Z1
    w1 = math.sqrt(D1)
    v3 = w1 - w1
    inverse1 = 1.0 / N1
    v4 = v1 * Z1
    v5 = v2 * Z1
    v6 = inverse1 * v5
    v7 = w1 * (v1 * inverse1)
    c1_p = v7 - v6
    v8 = v6 + v7
    v9 = inverse1 * v4
    v10 = w1 * (v2 * inverse1)
    v11 = v9 + v10
    v12 = v9 - v10

    # theta3, type 2: U0 A6^-1 [3, 4]
    Z3 = wz - k5
    D3 = k4 - Z3 * Z3
    w3 = math.sqrt(D3)
    v13 = w3 - w3
    v14 = m5 * wz - m4
    v15 = m3 * w3
    v16 = v14 + v15
    v17 = v14 - v15
    v18 = m3 * wz - m6
    v19 = m5 * w3
    s3_p = v18 - v19
    s3_m = v18 + v19

    # r2, type 1: U1 A6^-1 [3, 4]
    v20 = a3 * s3_p - d4 * v16
    v21 = a3 * s3_m - d4 * v17
    v22 = c1_p * -wy - wx * v11
    v23 = v8 * -wy + wx * v12

    # theta4, type 2: U4[3, 3]
    v24 = cat2 * T13
    v25 = cat2 * T23
    v26 = v1 * v24 - v2 * v25
    v27 = sat2 * T33 + inverse1 * (v4 * v25 + v5 * v24)
    v28 = w1 * (inverse1 * v26) - v27
    v29 = w1 * (inverse1 * -v26) - v27
    v30 = T13 * v11 + T23 * c1_p
    v31 = T13 * v12 - T23 * v8
    X4_pp = v16 * v28 - s3_p * v30
    X4_pm = v17 * v28 - s3_m * v30
    X4_mp = v16 * v29 - s3_p * v31
    X4_mm = v17 * v29 - s3_m * v31
    v32 = sat2 * T13
    v33 = sat2 * T23
    v34 = v1 * v32 - v2 * v33
    v35 = cat2 * T33 - inverse1 * (v4 * v33 + v5 * v32)
    v36 = v35 + w1 * (inverse1 * v34)
    v37 = v35 + w1 * (inverse1 * -v34)
    v38 = v36 * v36
    v39 = v37 * v37
    v40 = v38 + X4_pp * X4_pp
    v41 = v38 + X4_pm * X4_pm
    v42 = v39 + X4_mp * X4_mp
    v43 = v39 + X4_mm * X4_mm
    v44 = math.copysign(half_turn, -v36)
    v45 = math.copysign(half_turn, -v37)

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v46 = sat2 * T12
    v47 = sat2 * T22
    v48 = v1 * v46 - v2 * v47
    v49 = cat2 * T32 - inverse1 * (v4 * v47 + v5 * v46)
    v50 = v49 + w1 * (inverse1 * v48)
    v51 = v49 + w1 * (inverse1 * -v48)
    v52 = cat2 * T12
    v53 = cat2 * T22
    v54 = v1 * v52 - v2 * v53
    v55 = sat2 * T32 + inverse1 * (v4 * v53 + v5 * v52)
    v56 = w1 * (inverse1 * v54) - v55
    v57 = w1 * (inverse1 * -v54) - v55
    v58 = c1_p * T22 + v11 * T12
    v59 = v12 * T12 - v8 * T22
    v60 = sat2 * T11
    v61 = sat2 * T21
    v62 = v1 * v60 - v2 * v61
    v63 = cat2 * T31 - inverse1 * (v4 * v61 + v5 * v60)
    v64 = v63 + w1 * (inverse1 * v62)
    v65 = v63 + w1 * (inverse1 * -v62)
    v66 = cat2 * T11
    v67 = cat2 * T21
    v68 = v1 * v66 - v2 * v67
    v69 = sat2 * T31 + inverse1 * (v4 * v67 + v5 * v66)
    v70 = w1 * (inverse1 * v68) - v69
    v71 = w1 * (inverse1 * -v68) - v69
    v72 = c1_p * T21 + v11 * T11
    v73 = v12 * T11 - v8 * T21
    v74 = v36 * (s3_p * v72 - v16 * v70) - -X4_pp * v64
    v75 = v36 * (s3_m * v72 - v17 * v70) - -X4_pm * v64
    v76 = v37 * (s3_p * v73 - v16 * v71) - -X4_mp * v65
    v77 = v37 * (s3_m * v73 - v17 * v71) - -X4_mm * v65

    # joint values
    q2_mpp = v23 - v20
    q2_mmp = v23 - v21

    # a joint is free, or branches meet
    if (
        abs(D1) <= m1 * (merge_slack1 + 2.0 * abs(Z1)) or N1 <= doubt_limit_squared2 or abs(D3) <=
        m2 * (blur_slack1 + 2.0 * abs(Z3)) or v43 <= m7 or v42 <= m7 or v40 <= m7 or v41 <= m7
    ):
        return False

    # angles, side by side
    room[0] = -v36
    room[1] = -v36
    room[2] = -v37
    room[3] = -v37
    room[4] = -math.sqrt(v40)
    room[5] = -math.sqrt(v41)
    room[6] = -math.sqrt(v42)
    room[7] = -math.sqrt(v43)
    room[8] = v74
    room[9] = v75
    room[10] = v76
    room[11] = v77
    room[12] = -v11
    room[13] = -v12
    room[14] = s3_p
    room[15] = s3_m
    room[16] = -X4_pp
    room[17] = -X4_pm
    room[18] = -X4_mp
    room[19] = -X4_mm
    room[20] = -(v16 * v30 + s3_p * v28)
    room[21] = -(v17 * v30 + s3_m * v28)
    room[22] = -(v16 * v31 + s3_p * v29)
    room[23] = -(v17 * v31 + s3_m * v29)
    room[24] = v36 * (s3_p * v58 - v16 * v56) - -X4_pp * v50
    room[25] = v36 * (s3_m * v58 - v17 * v56) - -X4_pm * v50
    room[26] = v37 * (s3_p * v59 - v16 * v57) - -X4_mp * v51
    room[27] = v37 * (s3_m * v59 - v17 * v57) - -X4_mm * v51
    room[28] = c1_p
    room[29] = -v8
    room[30] = -v16
    room[31] = -v17
    for k in range(16):
        room[k] = _atan2(room[k], room[k + 16])
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

    # theta4, type 2: U4[3, 3]
    q4_ppm = angle1 - v44
    q4_pmm = angle2 - v44
    q4_mpm = angle3 - v45
    q4_mmm = angle4 - v45

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    q6_ppm = angle9 - math.copysign(half_turn, v74)
    q6_pmm = angle10 - math.copysign(half_turn, v75)
    q6_mpm = angle11 - math.copysign(half_turn, v76)
    q6_mmm = angle12 - math.copysign(half_turn, v77)

    # joint values
    q1_ppp = v13 + angle13
    q1_mpp = v13 + angle14
    q3_ppp = v3 + angle15
    q3_pmp = v3 + angle16

    q[0, 0] = q1_ppp
    q[0, 1] = -(v20 + v22)
    q[0, 2] = q3_ppp
    q[0, 3] = angle1
    q[0, 4] = angle5
    q[0, 5] = angle9
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_ppp
    q[1, 1] = -(v20 + v22)
    q[1, 2] = q3_ppp
    q[1, 3] = q4_ppm
    q[1, 4] = -angle5
    q[1, 5] = q6_ppm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = q1_ppp
    q[2, 1] = -(v21 + v22)
    q[2, 2] = q3_pmp
    q[2, 3] = angle2
    q[2, 4] = angle6
    q[2, 5] = angle10
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = q1_ppp
    q[3, 1] = -(v21 + v22)
    q[3, 2] = q3_pmp
    q[3, 3] = q4_pmm
    q[3, 4] = -angle6
    q[3, 5] = q6_pmm
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else OK
    q[4, 0] = q1_mpp
    q[4, 1] = q2_mpp
    q[4, 2] = q3_ppp
    q[4, 3] = angle3
    q[4, 4] = angle7
    q[4, 5] = angle11
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else OK
    q[5, 0] = q1_mpp
    q[5, 1] = q2_mpp
    q[5, 2] = q3_ppp
    q[5, 3] = q4_mpm
    q[5, 4] = -angle7
    q[5, 5] = q6_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else OK
    q[6, 0] = q1_mpp
    q[6, 1] = q2_mmp
    q[6, 2] = q3_pmp
    q[6, 3] = angle4
    q[6, 4] = angle8
    q[6, 5] = angle12
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else OK
    q[7, 0] = q1_mpp
    q[7, 1] = q2_mmp
    q[7, 2] = q3_pmp
    q[7, 3] = q4_mmm
    q[7, 4] = -angle8
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
    [1408, 1424, 1168, 1440, 1456, 1472],
    [1408, 1424, 1168, 1488, 1504, 1520],
    [1408, 1536, 1296, 1552, 1568, 1584],
    [1408, 1536, 1296, 1600, 1616, 1632],
])
_KINDS = np.array([1648, 1664, 1680, 1696, 1712, 1728, 1744, 1760])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(1776), 1776)
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
            wy = T24 - d6 * T23
            v1 = sat2 * wy
            wx = T14 - d6 * T13
            v2 = sat2 * wx
            N1 = v1 * v1 + v2 * v2
            wz = T34 - d6 * T33
            Z1 = cat2 * wz - k1
            D1 = N1 - Z1 * Z1
            w1 = math.sqrt(D1)
            v3 = w1 - w1
            inverse1 = 1.0 / N1
            v4 = v1 * Z1
            v5 = v2 * Z1
            v6 = inverse1 * v5
            v7 = w1 * (v1 * inverse1)
            c1_p = v7 - v6
            v8 = v6 + v7
            v9 = inverse1 * v4
            v10 = w1 * (v2 * inverse1)
            v11 = v9 + v10
            v12 = v9 - v10
            Z3 = wz - k5
            D3 = k4 - Z3 * Z3
            w3 = math.sqrt(D3)
            v13 = w3 - w3
            v14 = m5 * wz - m4
            v15 = m3 * w3
            v16 = v14 + v15
            v17 = v14 - v15
            v18 = m3 * wz - m6
            v19 = m5 * w3
            s3_p = v18 - v19
            s3_m = v18 + v19
            v20 = a3 * s3_p - d4 * v16
            v21 = a3 * s3_m - d4 * v17
            v22 = c1_p * -wy - wx * v11
            v23 = v8 * -wy + wx * v12
            v24 = cat2 * T13
            v25 = cat2 * T23
            v26 = v1 * v24 - v2 * v25
            v27 = sat2 * T33 + inverse1 * (v4 * v25 + v5 * v24)
            v28 = w1 * (inverse1 * v26) - v27
            v29 = w1 * (inverse1 * -v26) - v27
            v30 = T13 * v11 + T23 * c1_p
            v31 = T13 * v12 - T23 * v8
            X4_pp = v16 * v28 - s3_p * v30
            X4_pm = v17 * v28 - s3_m * v30
            X4_mp = v16 * v29 - s3_p * v31
            X4_mm = v17 * v29 - s3_m * v31
            v32 = sat2 * T13
            v33 = sat2 * T23
            v34 = v1 * v32 - v2 * v33
            v35 = cat2 * T33 - inverse1 * (v4 * v33 + v5 * v32)
            v36 = v35 + w1 * (inverse1 * v34)
            v37 = v35 + w1 * (inverse1 * -v34)
            v38 = v36 * v36
            v39 = v37 * v37
            v40 = v38 + X4_pp * X4_pp
            v41 = v38 + X4_pm * X4_pm
            v42 = v39 + X4_mp * X4_mp
            v43 = v39 + X4_mm * X4_mm
            v44 = math.copysign(half_turn, -v36)
            v45 = math.copysign(half_turn, -v37)
            v46 = sat2 * T12
            v47 = sat2 * T22
            v48 = v1 * v46 - v2 * v47
            v49 = cat2 * T32 - inverse1 * (v4 * v47 + v5 * v46)
            v50 = v49 + w1 * (inverse1 * v48)
            v51 = v49 + w1 * (inverse1 * -v48)
            v52 = cat2 * T12
            v53 = cat2 * T22
            v54 = v1 * v52 - v2 * v53
            v55 = sat2 * T32 + inverse1 * (v4 * v53 + v5 * v52)
            v56 = w1 * (inverse1 * v54) - v55
            v57 = w1 * (inverse1 * -v54) - v55
            v58 = c1_p * T22 + v11 * T12
            v59 = v12 * T12 - v8 * T22
            v60 = sat2 * T11
            v61 = sat2 * T21
            v62 = v1 * v60 - v2 * v61
            v63 = cat2 * T31 - inverse1 * (v4 * v61 + v5 * v60)
            v64 = v63 + w1 * (inverse1 * v62)
            v65 = v63 + w1 * (inverse1 * -v62)
            v66 = cat2 * T11
            v67 = cat2 * T21
            v68 = v1 * v66 - v2 * v67
            v69 = sat2 * T31 + inverse1 * (v4 * v67 + v5 * v66)
            v70 = w1 * (inverse1 * v68) - v69
            v71 = w1 * (inverse1 * -v68) - v69
            v72 = c1_p * T21 + v11 * T11
            v73 = v12 * T11 - v8 * T21
            v74 = v36 * (s3_p * v72 - v16 * v70) - -X4_pp * v64
            v75 = v36 * (s3_m * v72 - v17 * v70) - -X4_pm * v64
            v76 = v37 * (s3_p * v73 - v16 * v71) - -X4_mp * v65
            v77 = v37 * (s3_m * v73 - v17 * v71) - -X4_mm * v65
            q2_mpp = v23 - v20
            q2_mmp = v23 - v21
            work[272 + k] = N1
            work[288 + k] = Z1
            work[304 + k] = D1
            work[320 + k] = v3
            work[336 + k] = Z3
            work[352 + k] = D3
            work[368 + k] = v13
            work[384 + k] = v20
            work[400 + k] = v21
            work[416 + k] = v22
            work[432 + k] = v40
            work[448 + k] = v41
            work[464 + k] = v42
            work[480 + k] = v43
            work[496 + k] = v44
            work[512 + k] = v45
            work[528 + k] = v74
            work[544 + k] = v75
            work[560 + k] = v76
            work[576 + k] = v77
            work[592 + k] = q2_mpp
            work[608 + k] = q2_mmp
            work[624 + k] = -v36
            work[640 + k] = -v36
            work[656 + k] = -v37
            work[672 + k] = -v37
            work[688 + k] = -math.sqrt(v40)
            work[704 + k] = -math.sqrt(v41)
            work[720 + k] = -math.sqrt(v42)
            work[736 + k] = -math.sqrt(v43)
            work[752 + k] = v74
            work[768 + k] = v75
            work[784 + k] = v76
            work[800 + k] = v77
            work[816 + k] = -v11
            work[832 + k] = -v12
            work[848 + k] = s3_p
            work[864 + k] = s3_m
            work[880 + k] = -X4_pp
            work[896 + k] = -X4_pm
            work[912 + k] = -X4_mp
            work[928 + k] = -X4_mm
            work[944 + k] = -(v16 * v30 + s3_p * v28)
            work[960 + k] = -(v17 * v30 + s3_m * v28)
            work[976 + k] = -(v16 * v31 + s3_p * v29)
            work[992 + k] = -(v17 * v31 + s3_m * v29)
            work[1008 + k] = v36 * (s3_p * v58 - v16 * v56) - -X4_pp * v50
            work[1024 + k] = v36 * (s3_m * v58 - v17 * v56) - -X4_pm * v50
            work[1040 + k] = v37 * (s3_p * v59 - v16 * v57) - -X4_mp * v51
            work[1056 + k] = v37 * (s3_m * v59 - v17 * v57) - -X4_mm * v51
            work[1072 + k] = c1_p
            work[1088 + k] = -v8
            work[1104 + k] = -v16
            work[1120 + k] = -v17
        for k in range(624, 880):
            work[k] = _atan2(work[k], work[k + 256])
        for k in range(0, 16):
            N1 = work[272 + k]
            Z1 = work[288 + k]
            D1 = work[304 + k]
            v3 = work[320 + k]
            Z3 = work[336 + k]
            D3 = work[352 + k]
            v13 = work[368 + k]
            v20 = work[384 + k]
            v21 = work[400 + k]
            v22 = work[416 + k]
            v40 = work[432 + k]
            v41 = work[448 + k]
            v42 = work[464 + k]
            v43 = work[480 + k]
            v44 = work[496 + k]
            v45 = work[512 + k]
            v74 = work[528 + k]
            v75 = work[544 + k]
            v76 = work[560 + k]
            v77 = work[576 + k]
            q2_mpp = work[592 + k]
            q2_mmp = work[608 + k]
            angle1 = work[624 + k]
            angle2 = work[640 + k]
            angle3 = work[656 + k]
            angle4 = work[672 + k]
            angle5 = work[688 + k]
            angle6 = work[704 + k]
            angle7 = work[720 + k]
            angle8 = work[736 + k]
            angle9 = work[752 + k]
            angle10 = work[768 + k]
            angle11 = work[784 + k]
            angle12 = work[800 + k]
            angle13 = work[816 + k]
            angle14 = work[832 + k]
            angle15 = work[848 + k]
            angle16 = work[864 + k]
            q4_ppm = angle1 - v44
            q4_pmm = angle2 - v44
            q4_mpm = angle3 - v45
            q4_mmm = angle4 - v45
            q6_ppm = angle9 - math.copysign(half_turn, v74)
            q6_pmm = angle10 - math.copysign(half_turn, v75)
            q6_mpm = angle11 - math.copysign(half_turn, v76)
            q6_mmm = angle12 - math.copysign(half_turn, v77)
            q1_ppp = v13 + angle13
            q1_mpp = v13 + angle14
            q3_ppp = v3 + angle15
            q3_pmp = v3 + angle16
            _1136 = q1_ppp
            work[1136 + k] = _1136
            _1152 = -(v20 + v22)
            work[1152 + k] = _1152
            _1168 = q3_ppp
            work[1168 + k] = _1168
            _1184 = angle1
            work[1184 + k] = _1184
            _1200 = angle5
            work[1200 + k] = _1200
            _1216 = angle9
            work[1216 + k] = _1216
            _1232 = q4_ppm
            work[1232 + k] = _1232
            _1248 = -angle5
            work[1248 + k] = _1248
            _1264 = q6_ppm
            work[1264 + k] = _1264
            _1280 = -(v21 + v22)
            work[1280 + k] = _1280
            _1296 = q3_pmp
            work[1296 + k] = _1296
            _1312 = angle2
            work[1312 + k] = _1312
            _1328 = angle6
            work[1328 + k] = _1328
            _1344 = angle10
            work[1344 + k] = _1344
            _1360 = q4_pmm
            work[1360 + k] = _1360
            _1376 = -angle6
            work[1376 + k] = _1376
            _1392 = q6_pmm
            work[1392 + k] = _1392
            _1408 = q1_mpp
            work[1408 + k] = _1408
            _1424 = q2_mpp
            work[1424 + k] = _1424
            _1440 = angle3
            work[1440 + k] = _1440
            _1456 = angle7
            work[1456 + k] = _1456
            _1472 = angle11
            work[1472 + k] = _1472
            _1488 = q4_mpm
            work[1488 + k] = _1488
            _1504 = -angle7
            work[1504 + k] = _1504
            _1520 = q6_mpm
            work[1520 + k] = _1520
            _1536 = q2_mmp
            work[1536 + k] = _1536
            _1552 = angle4
            work[1552 + k] = _1552
            _1568 = angle8
            work[1568 + k] = _1568
            _1584 = angle12
            work[1584 + k] = _1584
            _1600 = q4_mmm
            work[1600 + k] = _1600
            _1616 = -angle8
            work[1616 + k] = _1616
            _1632 = q6_mmm
            work[1632 + k] = _1632
            work[1648 + k] = UNREACHABLE if _1136 != _1136 else OK
            work[1664 + k] = UNREACHABLE if _1136 != _1136 else OK
            work[1680 + k] = UNREACHABLE if _1136 != _1136 else OK
            work[1696 + k] = UNREACHABLE if _1136 != _1136 else OK
            work[1712 + k] = UNREACHABLE if _1408 != _1408 else OK
            work[1728 + k] = UNREACHABLE if _1408 != _1408 else OK
            work[1744 + k] = UNREACHABLE if _1408 != _1408 else OK
            work[1760 + k] = UNREACHABLE if _1408 != _1408 else OK
            work[256 + k] = (
                1.0 if abs(D1) <= m1 * (merge_slack1 + 2.0 * abs(Z1)) or N1 <= doubt_limit_squared2
                or abs(D3) <= m2 * (blur_slack1 + 2.0 * abs(Z3)) or v43 <= m7 or v42 <= m7 or v40 <=
                m7 or v41 <= m7 else work[256 + k]
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
            "no_pose": "not finite or beyond 5e102, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)",
            "no_row": "the pose is out of reach",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
