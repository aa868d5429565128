"""kuka_iiwa14: KUKA LBR iiwa 14 R820.

Inverse kinematics, generated from robots/kuka_iiwa14.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kuka_iiwa14.yaml. The formulas and where they come from:
kuka_iiwa14.md.

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
_of_joints = _runtime("entry").of_joints(_HOW, 7)

NAME = "kuka_iiwa14"
METHOD = "closed form"
DOF = 7
JOINT_TYPES = "RRRRRRR"
JOINT_LIMITS = (
    (-2.9670597283903604, 2.9670597283903604),
    (-2.0943951023931953, 2.0943951023931953),
    (-2.9670597283903604, 2.9670597283903604),
    (-2.0943951023931953, 2.0943951023931953),
    (-2.9670597283903604, 2.9670597283903604),
    (-2.0943951023931953, 2.0943951023931953),
    (-3.0543261909900767, 3.0543261909900767),
)
BRANCHES = (
    "elbow+-shoulder+-noflip",
    "elbow+-shoulder+-flip",
    "elbow+-shoulder--noflip",
    "elbow+-shoulder--flip",
    "elbow--shoulder+-noflip",
    "elbow--shoulder+-flip",
    "elbow--shoulder--noflip",
    "elbow--shoulder--flip",
)
MAX_SOLUTIONS = 8
FREE_JOINTS = (3,)  # from 1: the caller gives their values

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose, or a free joint's value is not finite

d1 = 0.36  # joint offset 1 [m]
d3 = 0.42  # joint offset 3 [m]
d5 = 0.4  # joint offset 5 [m]
d7 = 0.126  # joint offset 7 [m]
longest4 = 0.6724000000000001  # square of the longest reach [m^2]
shortest4 = 0.0003999999999999985  # square of the shortest reach [m^2]
longest4_reach = 0.6724000000002143  # the longest, with what rounding adds [m^2]
shortest4_reach = 0.0003999999999947745  # the shortest, with what rounding adds [m^2]
longest4_apart = 0.6723999999999786  # the longest, where branches merge [m^2]
shortest4_apart = 0.00040000000000052087  # the shortest, where branches merge [m^2]
least_root2 = 5.393694619178955e-07  # a root of nothing, by rounding [m^2]
free_limit_squared2 = 1.705636e-24  # square of a length that fixes no angle [m^2]
reach_slack1 = 1.3060000000000002e-13  # rounding at the boundary of the workspace [m]
merge_slack1 = 1.306e-14  # nearer to that boundary two branches are one [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
offset2 = 3.141592653589793  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset6 = 3.141592653589793  # offset of joint 6 [rad]
k1 = 0.336  # 2 * d5 * d3 [m^2]
k2 = 0.33640000000000003  # d3^2 + d5^2 [m^2]
k3 = 0.5862915651405106  # 1 / arm_size2 [m^-2]
k4 = 8.857709750566894  # 1 / (k1^2) [m^-4]
doubt_limit_squared2 = 1.705636e-08  # square of a length that fixes no angle [m^2]
high1 = 2.9670597293903604
high2 = 2.0943951033931953
high3 = 2.9670597293903604
high4 = 2.0943951033931953
high5 = 2.9670597293903604
high6 = 2.0943951033931953
high7 = 3.054326191990077
graze = 5e-07  # half of what rounding may take a joint beyond its limit
# 1000 * (longest4 - longest4_apart) * (longest4_apart - shortest4) [m^4]
m1 = 1.4473755527432779e-11
m2 = 1.306e-11  # 1000 * merge_slack1 [m]
m3 = 2.909194164496e-16  # doubt_limit_squared2^2 [m^4]
m4 = 9.999999999999999e-09  # doubt_limit^2

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0])
_JOINTS = np.column_stack([_LOWEST, _HIGHEST, [kind == "R" for kind in JOINT_TYPES], _WEIGHT])


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (7,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 7 joint values")
    T = np.zeros((4, 4))
    v1 = q[0] + offset1
    c1 = math.cos(v1)
    s1 = math.sin(v1)
    v2 = q[1] + offset2
    c2 = math.cos(v2)
    s2 = math.sin(v2)
    x2_x = c1 * c2
    x2_y = s1 * c2
    z2_x = c1 * s2
    z2_y = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 + s1 * s3
    x3_y = x2_y * c3 - c1 * s3
    x3_z = s2 * c3
    z3_y = c1 * c3 + x2_y * s3
    z3_z = s2 * s3
    z3_x = x2_x * s3 - s1 * c3
    v3 = q[3] + offset4
    c4 = math.cos(v3)
    s4 = math.sin(v3)
    x4_x = x3_x * c4 + z2_x * s4
    x4_y = x3_y * c4 + z2_y * s4
    x4_z = x3_z * c4 - c2 * s4
    z4_z = c2 * c4 + x3_z * s4
    z4_x = x3_x * s4 - z2_x * c4
    z4_y = x3_y * s4 - z2_y * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 + z3_x * s5
    x5_y = x4_y * c5 + z3_y * s5
    x5_z = x4_z * c5 + z3_z * s5
    z5_x = x4_x * s5 - z3_x * c5
    z5_y = x4_y * s5 - z3_y * c5
    z5_z = x4_z * s5 - z3_z * c5
    v4 = q[5] + offset6
    c6 = math.cos(v4)
    s6 = math.sin(v4)
    x6_x = x5_x * c6 + z4_x * s6
    x6_y = x5_y * c6 + z4_y * s6
    x6_z = x5_z * c6 + z4_z * s6
    z6_x = x5_x * s6 - z4_x * c6
    z6_y = x5_y * s6 - z4_y * c6
    z6_z = x5_z * s6 - z4_z * c6
    c7 = math.cos(q[6])
    s7 = math.sin(q[6])
    T[0, 0] = x6_x * c7 + z5_x * s7
    T[0, 1] = z5_x * c7 - x6_x * s7
    T[0, 2] = z6_x
    T[0, 3] = z2_x * d3 + z4_x * d5 + z6_x * d7
    T[1, 0] = x6_y * c7 + z5_y * s7
    T[1, 1] = z5_y * c7 - x6_y * s7
    T[1, 2] = z6_y
    T[1, 3] = z2_y * d3 + z4_y * d5 + z6_y * d7
    T[2, 0] = x6_z * c7 + z5_z * s7
    T[2, 1] = z5_z * c7 - x6_z * s7
    T[2, 2] = z6_z
    T[2, 3] = d1 - c2 * d3 + z4_z * d5 + z6_z * d7
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 7): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 7 joint values")
    J = np.zeros((6, 7))
    v1 = q[0] + offset1
    c1 = math.cos(v1)
    s1 = math.sin(v1)
    v2 = q[1] + offset2
    c2 = math.cos(v2)
    s2 = math.sin(v2)
    x2_x = c1 * c2
    x2_y = s1 * c2
    z2_x = c1 * s2
    z2_y = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 + s1 * s3
    x3_y = x2_y * c3 - c1 * s3
    x3_z = s2 * c3
    z3_y = c1 * c3 + x2_y * s3
    z3_z = s2 * s3
    p3_x = z2_x * d3
    p3_y = z2_y * d3
    p3_z = d1 - c2 * d3
    z3_x = x2_x * s3 - s1 * c3
    v3 = q[3] + offset4
    c4 = math.cos(v3)
    s4 = math.sin(v3)
    x4_x = x3_x * c4 + z2_x * s4
    x4_y = x3_y * c4 + z2_y * s4
    x4_z = x3_z * c4 - c2 * s4
    z4_z = c2 * c4 + x3_z * s4
    z4_x = x3_x * s4 - z2_x * c4
    z4_y = x3_y * s4 - z2_y * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    p5_x = p3_x + z4_x * d5
    p5_y = p3_y + z4_y * d5
    p5_z = p3_z + z4_z * d5
    z5_x = x4_x * s5 - z3_x * c5
    z5_y = x4_y * s5 - z3_y * c5
    z5_z = x4_z * s5 - z3_z * c5
    v4 = q[5] + offset6
    c6 = math.cos(v4)
    s6 = math.sin(v4)
    z6_x = (x4_x * c5 + z3_x * s5) * s6 - z4_x * c6
    z6_y = (x4_y * c5 + z3_y * s5) * s6 - z4_y * c6
    z6_z = (x4_z * c5 + z3_z * s5) * s6 - z4_z * c6
    p7_x = p5_x + z6_x * d7
    p7_y = p5_y + z6_y * d7
    p7_z = p5_z + z6_z * d7
    v5 = p7_z - d1
    v6 = p7_x - p3_x
    v7 = p7_y - p3_y
    v8 = p7_z - p3_z
    v9 = p7_x - p5_x
    v10 = p7_y - p5_y
    v11 = p7_z - p5_z
    J[0, 0] = -p7_y
    J[0, 1] = -(c1 * v5)
    J[0, 2] = z2_y * v5 + c2 * p7_y
    J[0, 3] = z3_y * v8 - z3_z * v7
    J[0, 4] = z4_y * v8 - z4_z * v7
    J[0, 5] = z5_y * v11 - z5_z * v10
    J[0, 6] = z6_y * v11 - z6_z * v10
    J[1, 0] = p7_x
    J[1, 1] = -(s1 * v5)
    J[1, 2] = -(c2 * p7_x + z2_x * v5)
    J[1, 3] = z3_z * v6 - z3_x * v8
    J[1, 4] = z4_z * v6 - z4_x * v8
    J[1, 5] = z5_z * v9 - z5_x * v11
    J[1, 6] = z6_z * v9 - z6_x * v11
    J[2, 1] = s1 * p7_y + c1 * p7_x
    J[2, 2] = z2_x * p7_y - z2_y * p7_x
    J[2, 3] = z3_x * v7 - z3_y * v6
    J[2, 4] = z4_x * v7 - z4_y * v6
    J[2, 5] = z5_x * v10 - z5_y * v9
    J[2, 6] = z6_x * v10 - z6_y * v9
    J[3, 1] = s1
    J[3, 2] = z2_x
    J[3, 3] = z3_x
    J[3, 4] = z4_x
    J[3, 5] = z5_x
    J[3, 6] = z6_x
    J[4, 1] = -c1
    J[4, 2] = z2_y
    J[4, 3] = z3_y
    J[4, 4] = z4_y
    J[4, 5] = z5_y
    J[4, 6] = z6_y
    J[5, 0] = 1.0
    J[5, 2] = -c2
    J[5, 3] = z3_z
    J[5, 4] = z4_z
    J[5, 5] = z5_z
    J[5, 6] = z6_z
    return J


@_inner
def _solve(pose, q_free, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    c3 = math.cos(q_free[0])
    s3 = math.sin(q_free[0])

    # theta4, type 2: the squared length of column 4 of U1 A7^-1
    wx = T14 - T13 * d7
    wy = T24 - d7 * T23
    v1 = wy * wy
    wz = T34 - d7 * T33
    Z1_2 = wz - d1
    V4 = wx * wx + v1 + Z1_2 * Z1_2
    Z4 = V4 - k2
    D4 = (longest4 - V4) * (V4 - shortest4)
    apart4 = shortest4_apart < V4 and V4 < longest4_apart
    if not (shortest4_reach <= V4 and V4 <= longest4_reach):
        return  # out of reach
    w4 = math.sqrt(D4 if apart4 else 0.0)
    v2 = (w4 if apart4 else least_root2) * k3
    v3 = k4 * (k1 * Z4)

    # theta1, type 2: U1 A7^-1 [3, 4]
    N1 = v1 + -wx * -wx
    free1 = N1 <= free_limit_squared2
    v7 = math.sqrt(N1)
    v10 = seed[0] + offset1

    # theta2, type 3: U1 A7^-1 [2, 4] and U1 A7^-1 [1, 4]
    X2_2 = d3 + d5 * v3
    v13 = Z1_2 * X2_2
    v15 = seed[1] + offset2

    # theta5, type 2: U5[3, 3]
    v16 = c3 * T13
    v17 = v3 * v16
    v18 = c3 * T23
    v19 = v3 * v18
    v23 = c3 * T33
    v24 = v3 * v23
    v27 = s3 * T33

    # theta6, type 3: U5[2, 3] and U5[1, 3]
    v30 = T33 * v3
    v31 = T13 * v3
    v32 = T23 * v3

    # theta7, type 3: U5[3, 2] and U5[3, 1]
    v34 = s3 * T32
    v37 = v3 * (c3 * T12)
    v38 = v3 * (c3 * T22)
    v42 = v3 * (c3 * T32)
    v44 = s3 * T31
    v47 = v3 * (c3 * T11)
    v48 = v3 * (c3 * T21)
    v52 = v3 * (c3 * T31)

    for i1 in range(2):  # elbow+, elbow-
        e1 = 1.0 - 2.0 * i1
        # theta4
        if e1 < 0.0 and not apart4:
            continue  # both signs give the same
        v4 = k4 * (k1 * (w4 * e1))

        # theta1
        Z1 = d5 * (s3 * v4)
        D1 = N1 - Z1 * Z1
        v5 = abs(Z1)
        v6 = 2.0 * v5
        apart1 = merge_slack1 * (v6 + merge_slack1) < D1
        if not (-(reach_slack1 * (v6 + reach_slack1)) <= v2 * D1):
            continue  # out of reach
        w1 = math.sqrt(D1 if apart1 else 0.0)
        inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else v5 * v7))
        v8 = -wx * Z1
        v9 = wy * Z1

        # theta2
        v11 = d5 * (c3 * v4)
        v12 = Z1_2 * v11

        # theta5
        v20 = T33 * v4
        v21 = T13 * v4
        v22 = T23 * v4

        # theta6
        v28 = v4 * v16
        v29 = v4 * v18
        v33 = v4 * v23

        # theta7
        v39 = T32 * v4
        v40 = T12 * v4
        v41 = T22 * v4
        v49 = T31 * v4
        v50 = T11 * v4
        v51 = T21 * v4

        # joint values
        q4 = _wrap(_atan2(-v4, -v3) - offset4)

        for i2 in range(2):  # shoulder+, shoulder-
            e2 = 1.0 - 2.0 * i2
            # theta1
            if e2 < 0.0 and (free1 or not apart1):
                continue  # both signs give the same
            root1 = w1 * e2
            c1 = math.cos(v10) if free1 else inverse1 * (v9 - -wx * root1)
            s1 = math.sin(v10) if free1 else inverse1 * (v8 + wy * root1)

            # theta2
            S2 = root1 * X2_2 - v12
            v14 = root1 * v11 + v13
            w2 = math.sqrt(S2 * S2 + v14 * v14)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v15) if free2 else -(v14 * factor2)
            s2 = math.sin(v15) if free2 else S2 * factor2

            # theta5
            v25 = T13 * s1 - T23 * c1
            v26 = s3 * v25
            X5 = v3 * v26 - (c2 * (v20 - (c1 * v17 + s1 * v19)) - s2 * (c1 * v21 + s1 * v22 + v24))
            Y5 = c2 * (s3 * (T13 * c1 + T23 * s1)) + s2 * v27 - c3 * v25
            w5 = math.sqrt(X5 * X5 + Y5 * Y5)
            free5 = w5 <= free_limit
            divisor5 = 1.0 if free5 else w5

            # theta6
            c6 = v4 * v26 - (s2 * (c1 * v31 + s1 * v32 - v33) - c2 * (c1 * v28 + s1 * v29 + v30))

            # theta7
            v35 = T12 * s1 - T22 * c1
            v36 = c3 * v35 - (c2 * (s3 * (T12 * c1 + T22 * s1)) + s2 * v34)
            v43 = (
                c2 * (v39 - (c1 * v37 + s1 * v38)) - s2 * (c1 * v40 + s1 * v41 + v42) - v3 * (s3 *
                v35)
            )
            v45 = T11 * s1 - T21 * c1
            v46 = c3 * v45 - (c2 * (s3 * (T11 * c1 + T21 * s1)) + s2 * v44)
            v53 = (
                c2 * (v49 - (c1 * v47 + s1 * v48)) - s2 * (c1 * v50 + s1 * v51 + v52) - v3 * (s3 *
                v45)
            )

            # joint values
            q1 = _wrap(_atan2(s1, c1) - offset1)
            q2 = _wrap(_atan2(s2, c2) - offset2)

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta5
                if e3 < 0.0 and free5:
                    continue  # both signs give the same
                factor5 = e3 / divisor5
                c5 = math.cos(seed[4]) if free5 else -(X5 * factor5)
                s5 = math.sin(seed[4]) if free5 else Y5 * factor5
                q5 = _atan2(s5, c5)
                s6 = w5 * e3

                # theta7
                c7 = c5 * v36 + s5 * v43
                s7 = c5 * v46 + s5 * v53
                q7 = _atan2(s7, c7)

                # joint values
                q6 = _wrap(_atan2(s6, c6) - offset6)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0] = q1
                q[row, 1] = q2
                q[row, 2] = q_free[0]
                q[row, 3] = q4
                q[row, 4] = q5
                q[row, 5] = q6
                q[row, 6] = q7
                status[row] = FREE_JOINT if free1 or free2 or free5 else OK


@_njit(forceinline=True)
def _read(T, q_free):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px) and math.isfinite(py) and math.isfinite(pz) and math.isfinite(q_free[0]), pose


@_inner
def _overshoot(joint, value):
    """How far a joint value is beyond its limits, whole turns aside; negative below."""
    low, high = _LOWEST[joint] + _SLACK[joint], _HIGHEST[joint] - _SLACK[joint]
    if low <= value <= high:
        return 0.0
    gap, over = turn - (high - low), value - high
    rest = over - turn * math.floor(over / turn)
    off = 0.0 if rest >= gap else rest if rest <= gap - rest else rest - gap
    return 0.0 if abs(off) <= 0.5 * _SLACK[joint] else off


@_inner
def _beyond_limits(values):
    """The same of a row."""
    total = 0.0
    for i in range(7):
        total += abs(_overshoot(i, values[i]))
    return total


@_inner
def _without_turns(angle):
    """An angle without its whole turns, by which a search could not tell small moves."""
    return math.copysign(abs(angle) % turn, angle)


_CHOOSABLE = (4, 1, 0,)  # joints, from 0, that may be free


@_inner
def _attempt(pose, q_free, seed, search, moved, q, status):
    """Solves with a joint moved: 0 if it serves, else less.

    A search is a row, the joint that had been chosen, whether limits count.
    """
    row, joint = search[0], search[1]
    for i in range(8):
        status[i] = UNREACHABLE
    kept = seed[joint]
    seed[joint] = kept + moved
    _solve(pose, q_free, seed, q, status)
    seed[joint] = kept
    return -math.inf if status[row] == UNREACHABLE else -_beyond_limits(q[row])


@_inner
def _peak(pose, q_free, seed, search, low, high, q, status):
    """Golden section for the move between low and high that comes nearest, or one that serves."""
    for _ in range(52):
        third = 0.3819660112501051 * (high - low)
        left = _attempt(pose, q_free, seed, search, low + third, q, status)
        right = _attempt(pose, q_free, seed, search, high - third, q, status)
        if left == 0.0 or right == 0.0:
            return low + third if left == 0.0 else high - third
        if left >= right:
            high -= third
        else:
            low += third
    return low


@_inner
def _summit(pose, q_free, seed, search, low, high, q, status):
    """A move between low and high that serves; NaN if there is none."""
    top = _peak(pose, q_free, seed, search, low, high, q, status)
    if _attempt(pose, q_free, seed, search, top, q, status) == 0.0:
        return top
    return math.nan


@_inner
def _serving(pose, q_free, seed, search, q, status):
    """How far the joint has to be moved from the seed's value until it serves; NaN if nowhere.

    A fan of values shows where it serves or nearly so, golden section finds what lies between two
    of them, bisection the end that is nearest to the seed; of two that are equally near the lower
    one.
    """
    if _attempt(pose, q_free, seed, search, 0.0, q, status) == 0.0:
        return 0.0
    step, nearest, here = 0.09817477042468103, math.nan, -math.inf
    after = _attempt(pose, q_free, seed, search, -32.0 * step, q, status)
    for k in range(-32, 32 + 1):
        before, here = here, after
        after = _attempt(pose, q_free, seed, search, (k + 1) * step, q, status)
        outer = k * step
        inner = outer - step if k > 0 else outer + step if k < 0 else 0.0
        if here < 0.0 and here >= before and here > after:
            low, high = outer - step, outer + step
            outer = _summit(pose, q_free, seed, search, low, high, q, status)
            if math.isnan(outer):
                continue
        elif here < 0.0 or (before if k > 0 else after) == 0.0:
            continue
        for _ in range(52):
            middle = 0.5 * (inner + outer)
            if _attempt(pose, q_free, seed, search, middle, q, status) == 0.0:
                outer = middle
            else:
                inner = middle
        if not abs(outer) >= abs(nearest) - 1e-09:
            nearest = outer
    return nearest


@_inner
def _hopeless(pose, q_free, seed, search, q, status):
    """Whether a joint beyond its limits stays where it is when the one that is searched moves."""
    row = search[0]
    if math.isinf(_attempt(pose, q_free, seed, search, 0.0, q, status)):
        return False
    values = q[row].copy()
    if math.isinf(_attempt(pose, q_free, seed, search, 0.1, q, status)):
        return False
    for i in range(7):
        if abs(values[i] - q[row, i]) < 1e-09 and _overshoot(i, values[i]) != 0.0:
            return True
    return False


@_inner
def _keep_limits(pose, q_free, given, row, q, status):
    """A free joint took the seed's value, and that puts one beyond its limits.

    It takes the nearest value that keeps all of them, if there is one. Where several joints are
    free the others take the seed's values as far as their limits allow.
    """
    seed, trial, result = given.copy(), q.copy(), status.copy()
    for i in range(7):
        seed[i] -= _overshoot(i, seed[i])
    for joint in _CHOOSABLE:
        inside, search = seed[joint], (row, joint, True)
        seed[joint] = _without_turns(given[joint])
        if not _hopeless(pose, q_free, seed, search, trial, result):
            moved = _serving(pose, q_free, seed, search, trial, result)
            # beside the solution of another row this one has none
            start = _attempt(pose, q_free, seed, search, 0.0, trial, result)
            own = abs(moved) >= 1e-06 or not math.isinf(start)
            if own and not math.isnan(moved):
                _attempt(pose, q_free, seed, search, moved, trial, result)
                for i in range(7):
                    q[row, i] = trial[row, i]
                status[row] = result[row]
                return
        seed[joint] = inside


@_apart("void(UniTuple(float64, 12), float64[::1], float64[::1], float64[:, ::1], uint8[::1])")
def _other_choices(pose, q_free, seed, q, status):
    """Other values for free joints, in rows that the seed's do not serve."""
    for row in range(8):
        if status[row] == FREE_JOINT and _beyond_limits(q[row]) > 0.0:
            _keep_limits(pose, q_free, seed, row, q, status)


@_inner
def _choose(pose, q_free, seed, q, status):
    """The same where there is a row that needs it."""
    served = True
    for row in range(8):
        served = served and not (status[row] == FREE_JOINT and _beyond_limits(q[row]) > 0.0)
    if served:
        return
    # arrays of the caller may have any layout
    values, rows, kinds = np.empty(7), np.empty((8, 7)), np.empty(8, np.uint8)
    for row in range(8):
        kinds[row] = status[row]
        for i in range(7):
            values[i], rows[row, i] = seed[i], q[row, i]
    _other_choices(pose, q_free.copy(), values, rows, kinds)
    for row in range(8):
        status[row] = kinds[row]
        for i in range(7):
            q[row, i] = rows[row, i]


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 0.0, 1.0, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.7657, 0.7657, 0.7657, 1.0, 1.0, 1.0])


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
    J, rows, square = jacobian(q), np.zeros((6, 13)), np.zeros(6)
    for i in range(6):
        for j in range(7):
            rows[i, j] = 0.0 if held[j] else _PACE[j] * _MISS_WEIGHT[i] * J[i, j]
        rows[i, 7 + i] = math.sqrt(damping + 1e-26)
        for n in range(2 * i):
            k, along = n % i, 0.0
            for j in range(13):
                along += rows[k, j] * rows[i, j] / square[k]
            for j in range(13):
                rows[i, j] -= along * rows[k, j]
            e[i] -= along * e[k]
        for j in range(13):
            square[i] += rows[i, j] * rows[i, j]
        for j in range(7):
            q[j] += e[i] / square[i] * rows[i, j] * _PACE[j]


@_inner
def _half_way(x, q, half):
    """How far joint values are from others, but for whole turns [rad, arm sizes].

    Those half way go into half.
    """
    most = 0.0
    for i in range(7):
        off = q[i] - x[i]
        off -= turn * math.floor(off / turn + 0.5)
        most = max(most, abs(off))
        half[i] = x[i] + 0.5 * off
    return most


@_apart("boolean(UniTuple(float64, 12), float64, float64, float64[::1])")
def _settled(T, enough, most, q):
    """Takes joint values to some not farther than most that miss the pose by less than enough.

    If enough is NaN, to some inside their limits that miss it hardly more. Returns if it can.
    Damped least squares, while they gain: where roots meet a step still leaves less than half.
    Until one gains little they are damped so that none leads far.
    """
    half = np.empty(7)
    stands, moves = math.isnan(enough), 0
    held, x, settled = np.zeros(7, np.bool_), q.copy(), False
    last, lost = math.inf, 0
    for _ in range(20):
        e, miss = _miss(T, x)
        if math.isnan(enough):
            enough = miss + 1e-14
        worst, past = -1, 0.0
        for j in range(7 if stands and miss < enough else 0):
            off = _overshoot(j, x[j]) if _PACE[j] > 0.0 else 0.0
            if abs(off) > abs(past):
                worst, past = j, off
        if worst >= 0:  # one at a time: others may follow it inside, or the first one the second
            moves += 1
            if moves == 2:
                held[:] = False
            held[worst], last = True, math.inf
            x[worst] -= past
            e, miss = _miss(T, x)
        if miss < enough:
            for i in range(7):
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
    values = np.empty(7)
    for i in range(7):
        values[i] = q[i]
    settled = _settled(pose, enough, most, values)
    for i in range(7):
        q[i] = values[i]
    return settled


@_inner
def _stand(pose, row, far, rows, status):
    """Puts a row's joints just beyond their limits on them, unless that is another solution; those
    that are far beyond them, too, if that is asked for. Returns if it did.

    Half way to the same there is one, and what is nearer to another row that is less far beyond is
    that one's.
    """
    q = rows[row]
    beyond = _beyond_limits(q)
    if not (0.0 < beyond and (far or beyond < 0.01)):
        return False
    x, half, to = q.copy(), np.empty(7), np.empty(7)
    if not _settle(pose, math.nan, math.inf if far else 1.5, x):
        return False
    off = _half_way(q, x, half)
    for k in range(len(rows)):
        if status[k] != UNREACHABLE and _beyond_limits(rows[k]) < beyond:
            if _half_way(rows[k], x, to) < off:
                return False
    if off >= 0.001 and not _settle(pose, 1e-12, 0.25 * off, half):
        return False
    for i in range(7):
        q[i] = x[i]
    return True


@_inner
def _lead(pose, q, status):
    """Rows of a root that follows another, which may be a little out of reach, to solutions."""
    for row in range(8):
        if status[row] == UNREACHABLE or _miss(pose, q[row])[1] <= 1e-11:
            continue
        if not _settle(pose, 1e-12, 0.15, q[row]):
            status[row] = UNREACHABLE
            for i in range(7):
                q[row, i] = math.nan


@_apart("boolean(UniTuple(float64, 12), float64[::1])")
def _are_one(T, half):
    """Whether rounding alone tells two solutions that lie to both sides of joint values.

    Half way the arm is singular, and what steps in all other directions leave of the miss is how far
    the pose is from one at which both meet.
    """
    held = np.zeros(7, np.bool_)
    for _ in range(3):
        _add_step(held, 1e-13, _miss(T, half)[0], half)
    return _miss(T, half)[1] <= 1e-14


@_inner
def _tell_once(pose, q, status):
    """Ends rows that rounding alone tells from earlier ones.

    Where an earlier angle is good to fewer digits than usual branches that meet come out apart.
    """
    half = np.empty(7)
    for row in range(1, 8):
        for k in range(row):
            if status[row] == UNREACHABLE or status[k] == UNREACHABLE:
                continue
            if _half_way(q[k], q[row], half) < 0.001 and _are_one(pose, half):
                status[row] = UNREACHABLE
                for i in range(7):
                    q[row, i] = math.nan


@_inner
def _stay(pose, q_free, seed, q, status):
    """Where rounding can't tell solutions apart the arm goes on with the one that it is at.

    The solution next to the seed gets a row unless it has one: that of one beside
    it, that of one which it is told from by nothing, one that is left, or any.
    """
    x, half, place, least = np.empty(7), np.empty(7), 0, math.inf
    nearest = 0.001
    for i in range(7):
        x[i] = seed[i] - _overshoot(i, seed[i])
    x[2] = q_free[0]
    if not _settle(pose, 1e-12, 0.15, x):
        return
    if _beyond_limits(x) > 1e-09 and not _settle(pose, math.nan, 0.15, x):
        return
    for row in range(8 - 1, -1, -1):
        between = 1e-06
        if status[row] != UNREACHABLE:
            off = _half_way(x, q[row], half)
            between = max(_miss(pose, half)[1], 1e-12) if off >= 0.001 else 0.0
            if off < nearest:
                place, nearest, least = row, off, -1.0  # its own
        if between <= 2.0 * least:
            place = row
        least = min(least, between)
    if least >= 0.0:
        status[place] = FREE_JOINT
    if nearest > 1e-06 or _beyond_limits(q[place]) > 0.0:
        for i in range(7):
            q[place, i] = x[i]


@_jit
def _whole(pose, q_free, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(8):
        status[row] = UNREACHABLE
        for i in range(7):
            q[row, i] = math.nan
    _solve(pose, q_free, seed, q, status)
    _choose(pose, q_free, seed, q, status)
    _lead(pose, q, status)
    _tell_once(pose, q, status)
    _stay(pose, q_free, seed, q, status)
    count = 0
    for n in range(2 * 8):
        row, far = n % 8, n >= 8  # far where no row is inside all limits
        if status[row] == UNREACHABLE or (far and count > 0):
            continue
        if _stand(pose, row, far, q, status) and far:
            status[row] = FREE_JOINT
        for i in range(7):
            q[row, i] = _turned(_JOINTS, i, q[row, i], 0.0 if _PACE[i] > 0.0 else q[row, i])
            if not _LOWEST[i] <= q[row, i] <= _HIGHEST[i]:
                status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


@_merged
def _regular(pose, q_free, q, status):
    """A pose at which no joint is free and no branches meet into q and status; False for others.

    What can't be reached is NaN by itself: it has the root of a negative number in it.
    """
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose
    room = carray(_room(48), 48)

    # theta4, type 2: the squared length of column 4 of U1 A7^-1
    wx = T14 - d7 * T13
    wy = T24 - d7 * T23
    v1 = wy * wy
    Z1_2 = T34 - d7 * T33 - d1
    V4 = v1 + wx * wx + Z1_2 * Z1_2
    D4 = (longest4 - V4) * (V4 - shortest4)
    w4 = math.sqrt(D4)
    v2 = k1 * (V4 - k2)
    v3 = k4 * v2
    v4 = k1 * w4
    v5 = k4 * v4

    # theta1, type 2: U1 A7^-1 [3, 4]
    N1 = v1 + -wx * -wx
    inverse1 = 1.0 / N1

    # theta2, type 3: U1 A7^-1 [2, 4] and U1 A7^-1 [1, 4]
    X2_2 = d3 + d5 * v3
    v20 = Z1_2 * X2_2

    # theta5, type 2: U5[3, 3]
    v32 = T33 * v5
    v33 = T13 * v5
    v34 = T23 * v5

    # theta6, type 3: U5[2, 3] and U5[1, 3]
    v54 = T33 * v3
    v55 = T13 * v3
    v56 = T23 * v3

    # theta7, type 3: U5[3, 2] and U5[3, 1]
    v65 = v5 * T32
    v66 = v5 * T12
    v67 = v5 * T22
    v76 = v5 * T31
    v77 = v5 * T11
    v78 = v5 * T21
    s3 = math.sin(q_free[0])
    c3 = math.cos(q_free[0])
    angle17 = _atan2(-v4, -v2)

    # theta1, type 2: U1 A7^-1 [3, 4]
    Z1 = d5 * (s3 * v5)
    D1 = N1 - Z1 * Z1
    w1 = math.sqrt(D1)
    v6 = w1 - w1
    v7 = -wx * Z1
    v8 = wy * Z1
    v9 = w1 * (-wx * inverse1)
    v10 = w1 * (wx * inverse1)
    v11 = inverse1 * v8
    c1_pp = v11 - v9
    c1_pm = v11 - v10
    v12 = v9 + v11
    v13 = v10 + v11
    v14 = w1 * (wy * inverse1)
    v15 = w1 * (inverse1 * -wy)
    v16 = inverse1 * v7
    s1_pp = v14 + v16
    s1_pm = v15 + v16
    s1_mp = v14 - v16
    s1_mm = v15 - v16

    # theta2, type 3: U1 A7^-1 [2, 4] and U1 A7^-1 [1, 4]
    v17 = d5 * (c3 * v5)
    v18 = Z1_2 * v17
    v19 = w1 * X2_2
    S2_pp = v19 - v18
    S2_mp = v18 + v19
    v21 = w1 * v17
    v22 = v20 + v21
    v23 = v20 - v21
    v24 = v22 * v22
    v25 = S2_pp * S2_pp + v24
    v26 = S2_mp * S2_mp + v23 * v23
    v27 = v24 + -S2_pp * -S2_pp
    factor2_pp = math.sqrt(v25) * (1.0 / v25)
    factor2_pm = math.sqrt(v26) * (1.0 / v26)
    factor2_mm = math.sqrt(v27) * (1.0 / v27)

    # theta5, type 2: U5[3, 3]
    v28 = c3 * T13
    v29 = v3 * v28
    v30 = c3 * T23
    v31 = v3 * v30
    v35 = c3 * T33
    v36 = v3 * v35
    v37 = w1 * (inverse1 * (s3 * (T13 * wy + T23 * -wx)))
    v38 = T13 * v7 - T23 * v8
    v39 = inverse1 * (s3 * v38)
    v40 = inverse1 * (s3 * -v38)
    v41 = v37 + v39
    v42 = v39 - v37
    v43 = v37 + v40
    v44 = v40 - v37
    X5_pp = (
        v3 * v41 + factor2_pp * (v22 * (v32 - (c1_pp * v29 + s1_pp * v31)) + S2_pp * (v36 + (c1_pp *
        v33 + s1_pp * v34)))
    )
    X5_pm = (
        v3 * v42 + factor2_pm * (v23 * (v32 - (c1_pm * v29 + s1_pm * v31)) - S2_mp * (v36 + (c1_pm *
        v33 + s1_pm * v34)))
    )
    X5_mp = (
        v3 * v43 + factor2_pm * (S2_mp * (v36 + (v12 * v33 - s1_mp * v34)) - v23 * (v32 + (s1_mp *
        v31 - v12 * v29)))
    )
    X5_mm = (
        v3 * v44 + factor2_mm * (-S2_pp * (v36 + (v13 * v33 - s1_mm * v34)) - v22 * (v32 + (s1_mm *
        v31 - v13 * v29)))
    )
    v45 = s3 * T33
    Y5_pp = (
        factor2_pp * (S2_pp * v45 - v22 * (s3 * (T13 * c1_pp + T23 * s1_pp))) - c3 * (T13 * s1_pp -
        T23 * c1_pp)
    )
    v46 = S2_mp * v45
    v47 = (
        factor2_pm * (v46 + v23 * (s3 * (T13 * c1_pm + T23 * s1_pm))) + c3 * (T13 * s1_pm - T23 *
        c1_pm)
    )
    Y5_mp = (
        factor2_pm * (v46 - v23 * (s3 * (T23 * s1_mp - T13 * v12))) - c3 * (T13 * s1_mp + T23 * v12)
    )
    Y5_mm = (
        factor2_mm * (-S2_pp * v45 - v22 * (s3 * (T23 * s1_mm - T13 * v13))) - c3 * (T13 * s1_mm +
        T23 * v13)
    )
    v48 = X5_pp * X5_pp + Y5_pp * Y5_pp
    v49 = X5_pm * X5_pm + v47 * v47
    v50 = X5_mp * X5_mp + Y5_mp * Y5_mp
    v51 = X5_mm * X5_mm + Y5_mm * Y5_mm

    # theta6, type 3: U5[2, 3] and U5[1, 3]
    v52 = v5 * v28
    v53 = v5 * v30
    v57 = v5 * v35

    # theta7, type 3: U5[3, 2] and U5[3, 1]
    v58 = s3 * T32
    v59 = s1_pp * T12 - c1_pp * T22
    v60 = s1_pm * T12 - c1_pm * T22
    v61 = s1_mp * T12 + v12 * T22
    v62 = s1_mm * T12 + v13 * T22
    v63 = v3 * (c3 * T12)
    v64 = v3 * (c3 * T22)
    v68 = v3 * (c3 * T32)
    v69 = s3 * T31
    v70 = s1_pp * T11 - c1_pp * T21
    v71 = s1_pm * T11 - c1_pm * T21
    v72 = s1_mp * T11 + v12 * T21
    v73 = s1_mm * T11 + v13 * T21
    v74 = v3 * (c3 * T11)
    v75 = v3 * (c3 * T21)
    v79 = v3 * (c3 * T31)
    v80 = S2_mp * v69
    v81 = (
        v47 * (v3 * (s3 * v71) + factor2_pm * (v23 * (v76 - (c1_pm * v74 + s1_pm * v75)) - S2_mp *
        (v79 + (c1_pm * v77 + s1_pm * v78)))) - X5_pm * (c3 * v71 + factor2_pm * (v80 + v23 * (s3 *
        (c1_pm * T11 + s1_pm * T21))))
    )
    v82 = S2_mp * v58

    # joint values
    v91 = angle17 - offset4
    v92 = offset4 + angle17
    q4__p = v91 + (turn if v91 <= -half_turn else 0.0)
    q4__m = (turn if -v92 <= -half_turn else 0.0) - v92
    v101 = abs(q4__p) - high4
    v102 = abs(q4__m) - high4
    q3_ppp = v6 + (q_free[0] + (w4 - w4))
    q4_ppp = v6 + q4__p
    q4_mpp = v6 + q4__m

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if (
        N1 <= doubt_limit_squared2 or abs(D4) <= m1 or abs(D1 * (k3 * w4)) <= m2 * (merge_slack1 +
        2.0 * abs(Z1)) or v51 <= m4 or v27 <= m3 or v50 <= m4 or v49 <= m4 or v26 <= m3 or v48 <= m4
        or 0.0 < abs(q_free[0]) - high3 or v25 <= m3
    ):
        return False

    # angles, side by side
    room[0] = Y5_pp
    room[1] = -v47
    room[2] = Y5_mp
    room[3] = Y5_mm
    room[4] = (
        -(X5_pp * (c3 * v70 - factor2_pp * (S2_pp * v69 - v22 * (s3 * (c1_pp * T11 + s1_pp * T21))))
        + Y5_pp * (v3 * (s3 * v70) + factor2_pp * (v22 * (v76 - (c1_pp * v74 + s1_pp * v75)) + S2_pp
        * (v79 + (c1_pp * v77 + s1_pp * v78)))))
    )
    room[5] = v81
    room[6] = (
        -(X5_mp * (c3 * v72 - factor2_pm * (v80 - v23 * (s3 * (s1_mp * T21 - v12 * T11)))) + Y5_mp *
        (v3 * (s3 * v72) + factor2_pm * (S2_mp * (v79 + (v12 * v77 - s1_mp * v78)) - v23 * (v76 +
        (s1_mp * v75 - v12 * v74)))))
    )
    room[7] = (
        -(X5_mm * (c3 * v73 - factor2_mm * (-S2_pp * v69 - v22 * (s3 * (s1_mm * T21 - v13 * T11))))
        + Y5_mm * (v3 * (s3 * v73) + factor2_mm * (-S2_pp * (v79 + (v13 * v77 - s1_mm * v78)) - v22
        * (v76 + (s1_mm * v75 - v13 * v74)))))
    )
    room[8] = s1_pp
    room[9] = s1_pm
    room[10] = s1_mp
    room[11] = s1_mm
    room[12] = S2_pp
    room[13] = -S2_mp
    room[14] = S2_mp
    room[15] = -S2_pp
    room[16] = math.sqrt(v48)
    room[17] = math.sqrt(v49)
    room[18] = math.sqrt(v50)
    room[19] = math.sqrt(v51)
    room[24] = -X5_pp
    room[25] = -X5_pm
    room[26] = -X5_mp
    room[27] = -X5_mm
    room[28] = (
        -(X5_pp * (c3 * v59 - factor2_pp * (S2_pp * v58 - v22 * (s3 * (c1_pp * T12 + s1_pp * T22))))
        + Y5_pp * (v3 * (s3 * v59) + factor2_pp * (v22 * (v65 - (c1_pp * v63 + s1_pp * v64)) + S2_pp
        * (v68 + (c1_pp * v66 + s1_pp * v67)))))
    )
    room[29] = (
        v47 * (v3 * (s3 * v60) + factor2_pm * (v23 * (v65 - (c1_pm * v63 + s1_pm * v64)) - S2_mp *
        (v68 + (c1_pm * v66 + s1_pm * v67)))) - X5_pm * (c3 * v60 + factor2_pm * (v82 + v23 * (s3 *
        (c1_pm * T12 + s1_pm * T22))))
    )
    room[30] = (
        -(X5_mp * (c3 * v61 - factor2_pm * (v82 - v23 * (s3 * (s1_mp * T22 - v12 * T12)))) + Y5_mp *
        (v3 * (s3 * v61) + factor2_pm * (S2_mp * (v68 + (v12 * v66 - s1_mp * v67)) - v23 * (v65 +
        (s1_mp * v64 - v12 * v63)))))
    )
    room[31] = (
        -(X5_mm * (c3 * v62 - factor2_mm * (-S2_pp * v58 - v22 * (s3 * (s1_mm * T22 - v13 * T12))))
        + Y5_mm * (v3 * (s3 * v62) + factor2_mm * (-S2_pp * (v68 + (v13 * v66 - s1_mm * v67)) - v22
        * (v65 + (s1_mm * v64 - v13 * v63)))))
    )
    room[32] = c1_pp
    room[33] = c1_pm
    room[34] = -v12
    room[35] = -v13
    room[36] = -v22
    room[37] = -v23
    room[38] = -v23
    room[39] = -v22
    room[40] = (
        v5 * v41 - factor2_pp * (S2_pp * (c1_pp * v55 + s1_pp * v56 - v57) + v22 * (v54 + (c1_pp *
        v52 + s1_pp * v53)))
    )
    room[41] = (
        v5 * v42 - factor2_pm * (v23 * (v54 + (c1_pm * v52 + s1_pm * v53)) - S2_mp * (c1_pm * v55 +
        s1_pm * v56 - v57))
    )
    room[42] = (
        -(v5 * v43 + factor2_pm * (S2_mp * (v57 + (s1_mp * v56 - v12 * v55)) + v23 * (v54 + (v12 *
        v52 - s1_mp * v53))))
    )
    room[43] = (
        -(v5 * v44 + factor2_mm * (-S2_pp * (v57 + (s1_mm * v56 - v13 * v55)) + v22 * (v54 + (v13 *
        v52 - s1_mm * v53))))
    )
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
    angle18 = room[16]
    angle19 = room[17]
    angle20 = room[18]
    angle21 = room[19]

    # theta5, type 2: U5[3, 3]
    q5_ppm = angle1 - math.copysign(half_turn, Y5_pp)
    q5_pmm = angle2 - math.copysign(half_turn, -v47)
    q5_mpm = angle3 - math.copysign(half_turn, Y5_mp)
    q5_mmm = angle4 - math.copysign(half_turn, Y5_mm)

    # theta7, type 3: U5[3, 2] and U5[3, 1]
    q7_ppm = (
        angle5 - math.copysign(half_turn, -(X5_pp * (c3 * v70 - factor2_pp * (S2_pp * v69 - v22 *
        (s3 * (c1_pp * T11 + s1_pp * T21)))) + Y5_pp * (v3 * (s3 * v70) + factor2_pp * (v22 * (v76 -
        (c1_pp * v74 + s1_pp * v75)) + S2_pp * (v79 + (c1_pp * v77 + s1_pp * v78))))))
    )
    q7_pmm = angle6 - math.copysign(half_turn, v81)
    q7_mpm = (
        angle7 - math.copysign(half_turn, -(X5_mp * (c3 * v72 - factor2_pm * (v80 - v23 * (s3 *
        (s1_mp * T21 - v12 * T11)))) + Y5_mp * (v3 * (s3 * v72) + factor2_pm * (S2_mp * (v79 + (v12
        * v77 - s1_mp * v78)) - v23 * (v76 + (s1_mp * v75 - v12 * v74))))))
    )
    q7_mmm = (
        angle8 - math.copysign(half_turn, -(X5_mm * (c3 * v73 - factor2_mm * (-S2_pp * v69 - v22 *
        (s3 * (s1_mm * T21 - v13 * T11)))) + Y5_mm * (v3 * (s3 * v73) + factor2_mm * (-S2_pp * (v79
        + (v13 * v77 - s1_mm * v78)) - v22 * (v76 + (s1_mm * v75 - v13 * v74))))))
    )

    # joint values
    v83 = angle9 - offset1
    v84 = angle10 - offset1
    v85 = angle11 - offset1
    v86 = angle12 - offset1
    q1_ppp = v83 + (turn if v83 <= -half_turn else 0.0)
    q1_pmp = v84 + (turn if v84 <= -half_turn else 0.0)
    q1_mpp = v85 + (turn if v85 <= -half_turn else 0.0)
    q1_mmp = v86 + (turn if v86 <= -half_turn else 0.0)
    v87 = angle13 - offset2
    v88 = angle14 - offset2
    v89 = angle15 - offset2
    v90 = angle16 - offset2
    q2_ppp = v87 + (turn if v87 <= -half_turn else 0.0)
    q2_pmp = v88 + (turn if v88 <= -half_turn else 0.0)
    q2_mpp = v89 + (turn if v89 <= -half_turn else 0.0)
    q2_mmp = v90 + (turn if v90 <= -half_turn else 0.0)
    v93 = angle18 - offset6
    v94 = offset6 + angle18
    v95 = angle19 - offset6
    v96 = offset6 + angle19
    v97 = angle20 - offset6
    v98 = offset6 + angle20
    v99 = angle21 - offset6
    v100 = offset6 + angle21
    q6_ppp = v93 + (turn if v93 <= -half_turn else 0.0)
    q6_ppm = (turn if -v94 <= -half_turn else 0.0) - v94
    q6_pmp = v95 + (turn if v95 <= -half_turn else 0.0)
    q6_pmm = (turn if -v96 <= -half_turn else 0.0) - v96
    q6_mpp = v97 + (turn if v97 <= -half_turn else 0.0)
    q6_mpm = (turn if -v98 <= -half_turn else 0.0) - v98
    q6_mmp = v99 + (turn if v99 <= -half_turn else 0.0)
    q6_mmm = (turn if -v100 <= -half_turn else 0.0) - v100
    v103 = max(abs(q2_ppp) - high2, max(v101, abs(q1_ppp) - high1))
    v104 = max(abs(q2_pmp) - high2, max(v101, abs(q1_pmp) - high1))
    v105 = max(abs(q2_mpp) - high2, max(v102, abs(q1_mpp) - high1))
    v106 = max(abs(q2_mmp) - high2, max(v102, abs(q1_mmp) - high1))
    excess_ppp = max(abs(angle5) - high7, max(abs(q6_ppp) - high6, max(v103, abs(angle1) - high5)))
    excess_ppm = max(abs(q7_ppm) - high7, max(abs(q6_ppm) - high6, max(v103, abs(q5_ppm) - high5)))
    excess_pmp = max(abs(angle6) - high7, max(abs(q6_pmp) - high6, max(v104, abs(angle2) - high5)))
    excess_pmm = max(abs(q7_pmm) - high7, max(abs(q6_pmm) - high6, max(v104, abs(q5_pmm) - high5)))
    excess_mpp = max(abs(angle7) - high7, max(abs(q6_mpp) - high6, max(v105, abs(angle3) - high5)))
    excess_mpm = max(abs(q7_mpm) - high7, max(abs(q6_mpm) - high6, max(v105, abs(q5_mpm) - high5)))
    excess_mmp = max(abs(angle8) - high7, max(abs(q6_mmp) - high6, max(v106, abs(angle4) - high5)))
    excess_mmm = max(abs(q7_mmm) - high7, max(abs(q6_mmm) - high6, max(v106, abs(q5_mmm) - high5)))
    outside_ppp = 0.0 < excess_ppp
    outside_ppm = 0.0 < excess_ppm
    outside_pmp = 0.0 < excess_pmp
    outside_pmm = 0.0 < excess_pmm
    outside_mpp = 0.0 < excess_mpp
    outside_mpm = 0.0 < excess_mpm
    outside_mmp = 0.0 < excess_mmp
    outside_mmm = 0.0 < excess_mmm

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if (
        abs(excess_mmm - graze) <= graze or abs(excess_mmp - graze) <= graze or abs(excess_mpm -
        graze) <= graze or abs(excess_mpp - graze) <= graze or abs(excess_pmm - graze) <= graze or
        abs(excess_pmp - graze) <= graze or abs(excess_ppp - graze) <= graze or abs(excess_ppm -
        graze) <= graze
    ):
        return False

    q[0, 0] = q1_ppp
    q[0, 1] = q2_ppp
    q[0, 2] = q3_ppp
    q[0, 3] = q4_ppp
    q[0, 4] = angle1
    q[0, 5] = q6_ppp
    q[0, 6] = angle5
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else (OUT_OF_LIMITS if outside_ppp else OK)
    q[1, 0] = q1_ppp
    q[1, 1] = q2_ppp
    q[1, 2] = q3_ppp
    q[1, 3] = q4_ppp
    q[1, 4] = q5_ppm
    q[1, 5] = q6_ppm
    q[1, 6] = q7_ppm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else (OUT_OF_LIMITS if outside_ppm else OK)
    q[2, 0] = q1_pmp
    q[2, 1] = q2_pmp
    q[2, 2] = q3_ppp
    q[2, 3] = q4_ppp
    q[2, 4] = angle2
    q[2, 5] = q6_pmp
    q[2, 6] = angle6
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else (OUT_OF_LIMITS if outside_pmp else OK)
    q[3, 0] = q1_pmp
    q[3, 1] = q2_pmp
    q[3, 2] = q3_ppp
    q[3, 3] = q4_ppp
    q[3, 4] = q5_pmm
    q[3, 5] = q6_pmm
    q[3, 6] = q7_pmm
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else (OUT_OF_LIMITS if outside_pmm else OK)
    q[4, 0] = q1_mpp
    q[4, 1] = q2_mpp
    q[4, 2] = q3_ppp
    q[4, 3] = q4_mpp
    q[4, 4] = angle3
    q[4, 5] = q6_mpp
    q[4, 6] = angle7
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else (OUT_OF_LIMITS if outside_mpp else OK)
    q[5, 0] = q1_mpp
    q[5, 1] = q2_mpp
    q[5, 2] = q3_ppp
    q[5, 3] = q4_mpp
    q[5, 4] = q5_mpm
    q[5, 5] = q6_mpm
    q[5, 6] = q7_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else (OUT_OF_LIMITS if outside_mpm else OK)
    q[6, 0] = q1_mmp
    q[6, 1] = q2_mmp
    q[6, 2] = q3_ppp
    q[6, 3] = q4_mpp
    q[6, 4] = angle4
    q[6, 5] = q6_mmp
    q[6, 6] = angle8
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else (OUT_OF_LIMITS if outside_mmp else OK)
    q[7, 0] = q1_mmp
    q[7, 1] = q2_mmp
    q[7, 2] = q3_ppp
    q[7, 3] = q4_mpp
    q[7, 4] = q5_mmm
    q[7, 5] = q6_mmm
    q[7, 6] = q7_mmm
    status[7] = UNREACHABLE if q[7, 0] != q[7, 0] else (OUT_OF_LIMITS if outside_mmm else OK)
    return True


@_merged
def _into(T, q_free, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (8, 7) or status.shape != (8,):
        raise ValueError("T, q and status must have shapes (4, 4), (8, 7), (8,)")
    if q_free.shape != (1,):
        raise ValueError("q_free must have shape (1,)")
    valid, pose = _read(T, q_free)
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    if _COMPILED and _regular(pose, q_free, q, status):
        count = 0
        for row in range(8):
            count += status[row] == OK
        return count
    return _whole(pose, q_free, seed, q, status)


# Where in a tile the rows' values and statuses begin.
_PLACES = np.array([
    [2048, 2064, 2080, 2096, 2112, 2128, 2144],
    [2048, 2064, 2080, 2096, 2160, 2176, 2192],
    [2208, 2224, 2080, 2096, 2240, 2256, 2272],
    [2208, 2224, 2080, 2096, 2288, 2304, 2320],
    [2336, 2352, 2080, 2368, 2384, 2400, 2416],
    [2336, 2352, 2080, 2368, 2432, 2448, 2464],
    [2480, 2496, 2080, 2368, 2512, 2528, 2544],
    [2480, 2496, 2080, 2368, 2560, 2576, 2592],
])
_KINDS = np.array([2608, 2624, 2640, 2656, 2672, 2688, 2704, 2720])


@_njit(nogil=True)
def _in_tiles(T, q_free, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(2736), 2736)
    work[:] = 0.0  # the last tile may be half full
    for first in range(0, len(T), 16):
        count = min(16, len(T) - first)
        for k in range(count):
            for i in range(4):
                for j in range(4):
                    work[(4 * i + j) * 16 + k] = T[first + k, i, j]
            for i in range(1):
                work[(16 + i) * 16 + k] = q_free[first + k, i]
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
                - 1.0) + 0.0 * (work[48 + k] + work[112 + k] + work[176 + k] + work[256 + k])
            )
            exact = miss <= 1e-24
            work[272 + k] = 0.0 if exact else 1.0
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
            given1 = work[256 + k]
            wx = T14 - d7 * T13
            wy = T24 - d7 * T23
            v1 = wy * wy
            Z1_2 = T34 - d7 * T33 - d1
            V4 = v1 + wx * wx + Z1_2 * Z1_2
            D4 = (longest4 - V4) * (V4 - shortest4)
            w4 = math.sqrt(D4)
            v2 = k1 * (V4 - k2)
            v3 = k4 * v2
            v4 = k1 * w4
            v5 = k4 * v4
            N1 = v1 + -wx * -wx
            inverse1 = 1.0 / N1
            X2_2 = d3 + d5 * v3
            v20 = Z1_2 * X2_2
            v32 = T33 * v5
            v33 = T13 * v5
            v34 = T23 * v5
            v54 = T33 * v3
            v55 = T13 * v3
            v56 = T23 * v3
            v65 = v5 * T32
            v66 = v5 * T12
            v67 = v5 * T22
            v76 = v5 * T31
            v77 = v5 * T11
            v78 = v5 * T21
            work[288 + k] = wx
            work[304 + k] = wy
            work[320 + k] = Z1_2
            work[336 + k] = D4
            work[352 + k] = w4
            work[368 + k] = v3
            work[384 + k] = v5
            work[400 + k] = N1
            work[416 + k] = inverse1
            work[432 + k] = X2_2
            work[448 + k] = v20
            work[464 + k] = v32
            work[480 + k] = v33
            work[496 + k] = v34
            work[512 + k] = v54
            work[528 + k] = v55
            work[544 + k] = v56
            work[560 + k] = v65
            work[576 + k] = v66
            work[592 + k] = v67
            work[608 + k] = v76
            work[624 + k] = v77
            work[640 + k] = v78
            work[656 + k] = given1
            work[672 + k] = given1
            work[688 + k] = -v4
            work[704 + k] = -v2
        for k in range(656, 672):
            work[k] = math.sin(work[k])
        for k in range(672, 688):
            work[k] = math.cos(work[k])
        for k in range(688, 704):
            work[k] = _atan2(work[k], work[k + 16])
        for k in range(0, 16):
            T11 = work[0 + k]
            T12 = work[16 + k]
            T13 = work[32 + k]
            T21 = work[64 + k]
            T22 = work[80 + k]
            T23 = work[96 + k]
            T31 = work[128 + k]
            T32 = work[144 + k]
            T33 = work[160 + k]
            given1 = work[256 + k]
            wx = work[288 + k]
            wy = work[304 + k]
            Z1_2 = work[320 + k]
            w4 = work[352 + k]
            v3 = work[368 + k]
            v5 = work[384 + k]
            N1 = work[400 + k]
            inverse1 = work[416 + k]
            X2_2 = work[432 + k]
            v20 = work[448 + k]
            v32 = work[464 + k]
            v33 = work[480 + k]
            v34 = work[496 + k]
            v54 = work[512 + k]
            v55 = work[528 + k]
            v56 = work[544 + k]
            v65 = work[560 + k]
            v66 = work[576 + k]
            v67 = work[592 + k]
            v76 = work[608 + k]
            v77 = work[624 + k]
            v78 = work[640 + k]
            s3 = work[656 + k]
            c3 = work[672 + k]
            angle17 = work[688 + k]
            Z1 = d5 * (s3 * v5)
            D1 = N1 - Z1 * Z1
            w1 = math.sqrt(D1)
            v6 = w1 - w1
            v7 = -wx * Z1
            v8 = wy * Z1
            v9 = w1 * (-wx * inverse1)
            v10 = w1 * (wx * inverse1)
            v11 = inverse1 * v8
            c1_pp = v11 - v9
            c1_pm = v11 - v10
            v12 = v9 + v11
            v13 = v10 + v11
            v14 = w1 * (wy * inverse1)
            v15 = w1 * (inverse1 * -wy)
            v16 = inverse1 * v7
            s1_pp = v14 + v16
            s1_pm = v15 + v16
            s1_mp = v14 - v16
            s1_mm = v15 - v16
            v17 = d5 * (c3 * v5)
            v18 = Z1_2 * v17
            v19 = w1 * X2_2
            S2_pp = v19 - v18
            S2_mp = v18 + v19
            v21 = w1 * v17
            v22 = v20 + v21
            v23 = v20 - v21
            v24 = v22 * v22
            v25 = S2_pp * S2_pp + v24
            v26 = S2_mp * S2_mp + v23 * v23
            v27 = v24 + -S2_pp * -S2_pp
            factor2_pp = math.sqrt(v25) * (1.0 / v25)
            factor2_pm = math.sqrt(v26) * (1.0 / v26)
            factor2_mm = math.sqrt(v27) * (1.0 / v27)
            v28 = c3 * T13
            v29 = v3 * v28
            v30 = c3 * T23
            v31 = v3 * v30
            v35 = c3 * T33
            v36 = v3 * v35
            v37 = w1 * (inverse1 * (s3 * (T13 * wy + T23 * -wx)))
            v38 = T13 * v7 - T23 * v8
            v39 = inverse1 * (s3 * v38)
            v40 = inverse1 * (s3 * -v38)
            v41 = v37 + v39
            v42 = v39 - v37
            v43 = v37 + v40
            v44 = v40 - v37
            X5_pp = (
                v3 * v41 + factor2_pp * (v22 * (v32 - (c1_pp * v29 + s1_pp * v31)) + S2_pp * (v36 +
                (c1_pp * v33 + s1_pp * v34)))
            )
            X5_pm = (
                v3 * v42 + factor2_pm * (v23 * (v32 - (c1_pm * v29 + s1_pm * v31)) - S2_mp * (v36 +
                (c1_pm * v33 + s1_pm * v34)))
            )
            X5_mp = (
                v3 * v43 + factor2_pm * (S2_mp * (v36 + (v12 * v33 - s1_mp * v34)) - v23 * (v32 +
                (s1_mp * v31 - v12 * v29)))
            )
            X5_mm = (
                v3 * v44 + factor2_mm * (-S2_pp * (v36 + (v13 * v33 - s1_mm * v34)) - v22 * (v32 +
                (s1_mm * v31 - v13 * v29)))
            )
            v45 = s3 * T33
            Y5_pp = (
                factor2_pp * (S2_pp * v45 - v22 * (s3 * (T13 * c1_pp + T23 * s1_pp))) - c3 * (T13 *
                s1_pp - T23 * c1_pp)
            )
            v46 = S2_mp * v45
            v47 = (
                factor2_pm * (v46 + v23 * (s3 * (T13 * c1_pm + T23 * s1_pm))) + c3 * (T13 * s1_pm -
                T23 * c1_pm)
            )
            Y5_mp = (
                factor2_pm * (v46 - v23 * (s3 * (T23 * s1_mp - T13 * v12))) - c3 * (T13 * s1_mp +
                T23 * v12)
            )
            Y5_mm = (
                factor2_mm * (-S2_pp * v45 - v22 * (s3 * (T23 * s1_mm - T13 * v13))) - c3 * (T13 *
                s1_mm + T23 * v13)
            )
            v48 = X5_pp * X5_pp + Y5_pp * Y5_pp
            v49 = X5_pm * X5_pm + v47 * v47
            v50 = X5_mp * X5_mp + Y5_mp * Y5_mp
            v51 = X5_mm * X5_mm + Y5_mm * Y5_mm
            v52 = v5 * v28
            v53 = v5 * v30
            v57 = v5 * v35
            v58 = s3 * T32
            v59 = s1_pp * T12 - c1_pp * T22
            v60 = s1_pm * T12 - c1_pm * T22
            v61 = s1_mp * T12 + v12 * T22
            v62 = s1_mm * T12 + v13 * T22
            v63 = v3 * (c3 * T12)
            v64 = v3 * (c3 * T22)
            v68 = v3 * (c3 * T32)
            v69 = s3 * T31
            v70 = s1_pp * T11 - c1_pp * T21
            v71 = s1_pm * T11 - c1_pm * T21
            v72 = s1_mp * T11 + v12 * T21
            v73 = s1_mm * T11 + v13 * T21
            v74 = v3 * (c3 * T11)
            v75 = v3 * (c3 * T21)
            v79 = v3 * (c3 * T31)
            v80 = S2_mp * v69
            v81 = (
                v47 * (v3 * (s3 * v71) + factor2_pm * (v23 * (v76 - (c1_pm * v74 + s1_pm * v75)) -
                S2_mp * (v79 + (c1_pm * v77 + s1_pm * v78)))) - X5_pm * (c3 * v71 + factor2_pm *
                (v80 + v23 * (s3 * (c1_pm * T11 + s1_pm * T21))))
            )
            v82 = S2_mp * v58
            v91 = angle17 - offset4
            v92 = offset4 + angle17
            q4__p = v91 + (turn if v91 <= -half_turn else 0.0)
            q4__m = (turn if -v92 <= -half_turn else 0.0) - v92
            v101 = abs(q4__p) - high4
            v102 = abs(q4__m) - high4
            q3_ppp = v6 + (given1 + (w4 - w4))
            q4_ppp = v6 + q4__p
            q4_mpp = v6 + q4__m
            work[720 + k] = Z1
            work[736 + k] = D1
            work[752 + k] = c1_pp
            work[768 + k] = v12
            work[784 + k] = v13
            work[800 + k] = s1_pp
            work[816 + k] = s1_mp
            work[832 + k] = s1_mm
            work[848 + k] = S2_pp
            work[864 + k] = S2_mp
            work[880 + k] = v22
            work[896 + k] = v23
            work[912 + k] = v25
            work[928 + k] = v26
            work[944 + k] = v27
            work[960 + k] = factor2_pp
            work[976 + k] = factor2_pm
            work[992 + k] = factor2_mm
            work[1008 + k] = X5_pp
            work[1024 + k] = X5_mp
            work[1040 + k] = X5_mm
            work[1056 + k] = Y5_pp
            work[1072 + k] = v47
            work[1088 + k] = Y5_mp
            work[1104 + k] = Y5_mm
            work[1120 + k] = v48
            work[1136 + k] = v49
            work[1152 + k] = v50
            work[1168 + k] = v51
            work[1184 + k] = v69
            work[1200 + k] = v70
            work[1216 + k] = v72
            work[1232 + k] = v73
            work[1248 + k] = v74
            work[1264 + k] = v75
            work[1280 + k] = v79
            work[1296 + k] = v80
            work[1312 + k] = v81
            work[1328 + k] = v101
            work[1344 + k] = v102
            work[1360 + k] = q3_ppp
            work[1376 + k] = q4_ppp
            work[1392 + k] = q4_mpp
            work[1408 + k] = Y5_pp
            work[1424 + k] = -v47
            work[1440 + k] = Y5_mp
            work[1456 + k] = Y5_mm
            work[1472 + k] = (
                -(X5_pp * (c3 * v70 - factor2_pp * (S2_pp * v69 - v22 * (s3 * (c1_pp * T11 + s1_pp *
                T21)))) + Y5_pp * (v3 * (s3 * v70) + factor2_pp * (v22 * (v76 - (c1_pp * v74 + s1_pp
                * v75)) + S2_pp * (v79 + (c1_pp * v77 + s1_pp * v78)))))
            )
            work[1488 + k] = v81
            work[1504 + k] = (
                -(X5_mp * (c3 * v72 - factor2_pm * (v80 - v23 * (s3 * (s1_mp * T21 - v12 * T11)))) +
                Y5_mp * (v3 * (s3 * v72) + factor2_pm * (S2_mp * (v79 + (v12 * v77 - s1_mp * v78)) -
                v23 * (v76 + (s1_mp * v75 - v12 * v74)))))
            )
            work[1520 + k] = (
                -(X5_mm * (c3 * v73 - factor2_mm * (-S2_pp * v69 - v22 * (s3 * (s1_mm * T21 - v13 *
                T11)))) + Y5_mm * (v3 * (s3 * v73) + factor2_mm * (-S2_pp * (v79 + (v13 * v77 -
                s1_mm * v78)) - v22 * (v76 + (s1_mm * v75 - v13 * v74)))))
            )
            work[1536 + k] = s1_pp
            work[1552 + k] = s1_pm
            work[1568 + k] = s1_mp
            work[1584 + k] = s1_mm
            work[1600 + k] = S2_pp
            work[1616 + k] = -S2_mp
            work[1632 + k] = S2_mp
            work[1648 + k] = -S2_pp
            work[1664 + k] = math.sqrt(v48)
            work[1680 + k] = math.sqrt(v49)
            work[1696 + k] = math.sqrt(v50)
            work[1712 + k] = math.sqrt(v51)
            work[1728 + k] = -X5_pp
            work[1744 + k] = -X5_pm
            work[1760 + k] = -X5_mp
            work[1776 + k] = -X5_mm
            work[1792 + k] = (
                -(X5_pp * (c3 * v59 - factor2_pp * (S2_pp * v58 - v22 * (s3 * (c1_pp * T12 + s1_pp *
                T22)))) + Y5_pp * (v3 * (s3 * v59) + factor2_pp * (v22 * (v65 - (c1_pp * v63 + s1_pp
                * v64)) + S2_pp * (v68 + (c1_pp * v66 + s1_pp * v67)))))
            )
            work[1808 + k] = (
                v47 * (v3 * (s3 * v60) + factor2_pm * (v23 * (v65 - (c1_pm * v63 + s1_pm * v64)) -
                S2_mp * (v68 + (c1_pm * v66 + s1_pm * v67)))) - X5_pm * (c3 * v60 + factor2_pm *
                (v82 + v23 * (s3 * (c1_pm * T12 + s1_pm * T22))))
            )
            work[1824 + k] = (
                -(X5_mp * (c3 * v61 - factor2_pm * (v82 - v23 * (s3 * (s1_mp * T22 - v12 * T12)))) +
                Y5_mp * (v3 * (s3 * v61) + factor2_pm * (S2_mp * (v68 + (v12 * v66 - s1_mp * v67)) -
                v23 * (v65 + (s1_mp * v64 - v12 * v63)))))
            )
            work[1840 + k] = (
                -(X5_mm * (c3 * v62 - factor2_mm * (-S2_pp * v58 - v22 * (s3 * (s1_mm * T22 - v13 *
                T12)))) + Y5_mm * (v3 * (s3 * v62) + factor2_mm * (-S2_pp * (v68 + (v13 * v66 -
                s1_mm * v67)) - v22 * (v65 + (s1_mm * v64 - v13 * v63)))))
            )
            work[1856 + k] = c1_pp
            work[1872 + k] = c1_pm
            work[1888 + k] = -v12
            work[1904 + k] = -v13
            work[1920 + k] = -v22
            work[1936 + k] = -v23
            work[1952 + k] = -v23
            work[1968 + k] = -v22
            work[1984 + k] = (
                v5 * v41 - factor2_pp * (S2_pp * (c1_pp * v55 + s1_pp * v56 - v57) + v22 * (v54 +
                (c1_pp * v52 + s1_pp * v53)))
            )
            work[2000 + k] = (
                v5 * v42 - factor2_pm * (v23 * (v54 + (c1_pm * v52 + s1_pm * v53)) - S2_mp * (c1_pm
                * v55 + s1_pm * v56 - v57))
            )
            work[2016 + k] = (
                -(v5 * v43 + factor2_pm * (S2_mp * (v57 + (s1_mp * v56 - v12 * v55)) + v23 * (v54 +
                (v12 * v52 - s1_mp * v53))))
            )
            work[2032 + k] = (
                -(v5 * v44 + factor2_mm * (-S2_pp * (v57 + (s1_mm * v56 - v13 * v55)) + v22 * (v54 +
                (v13 * v52 - s1_mm * v53))))
            )
        for k in range(1408, 1728):
            work[k] = _atan2(work[k], work[k + 320])
        for k in range(0, 16):
            T11 = work[0 + k]
            T21 = work[64 + k]
            given1 = work[256 + k]
            D4 = work[336 + k]
            w4 = work[352 + k]
            v3 = work[368 + k]
            N1 = work[400 + k]
            v76 = work[608 + k]
            v77 = work[624 + k]
            v78 = work[640 + k]
            s3 = work[656 + k]
            c3 = work[672 + k]
            Z1 = work[720 + k]
            D1 = work[736 + k]
            c1_pp = work[752 + k]
            v12 = work[768 + k]
            v13 = work[784 + k]
            s1_pp = work[800 + k]
            s1_mp = work[816 + k]
            s1_mm = work[832 + k]
            S2_pp = work[848 + k]
            S2_mp = work[864 + k]
            v22 = work[880 + k]
            v23 = work[896 + k]
            v25 = work[912 + k]
            v26 = work[928 + k]
            v27 = work[944 + k]
            factor2_pp = work[960 + k]
            factor2_pm = work[976 + k]
            factor2_mm = work[992 + k]
            X5_pp = work[1008 + k]
            X5_mp = work[1024 + k]
            X5_mm = work[1040 + k]
            Y5_pp = work[1056 + k]
            v47 = work[1072 + k]
            Y5_mp = work[1088 + k]
            Y5_mm = work[1104 + k]
            v48 = work[1120 + k]
            v49 = work[1136 + k]
            v50 = work[1152 + k]
            v51 = work[1168 + k]
            v69 = work[1184 + k]
            v70 = work[1200 + k]
            v72 = work[1216 + k]
            v73 = work[1232 + k]
            v74 = work[1248 + k]
            v75 = work[1264 + k]
            v79 = work[1280 + k]
            v80 = work[1296 + k]
            v81 = work[1312 + k]
            v101 = work[1328 + k]
            v102 = work[1344 + k]
            q3_ppp = work[1360 + k]
            q4_ppp = work[1376 + k]
            q4_mpp = work[1392 + k]
            angle1 = work[1408 + k]
            angle2 = work[1424 + k]
            angle3 = work[1440 + k]
            angle4 = work[1456 + k]
            angle5 = work[1472 + k]
            angle6 = work[1488 + k]
            angle7 = work[1504 + k]
            angle8 = work[1520 + k]
            angle9 = work[1536 + k]
            angle10 = work[1552 + k]
            angle11 = work[1568 + k]
            angle12 = work[1584 + k]
            angle13 = work[1600 + k]
            angle14 = work[1616 + k]
            angle15 = work[1632 + k]
            angle16 = work[1648 + k]
            angle18 = work[1664 + k]
            angle19 = work[1680 + k]
            angle20 = work[1696 + k]
            angle21 = work[1712 + k]
            q5_ppm = angle1 - math.copysign(half_turn, Y5_pp)
            q5_pmm = angle2 - math.copysign(half_turn, -v47)
            q5_mpm = angle3 - math.copysign(half_turn, Y5_mp)
            q5_mmm = angle4 - math.copysign(half_turn, Y5_mm)
            q7_ppm = (
                angle5 - math.copysign(half_turn, -(X5_pp * (c3 * v70 - factor2_pp * (S2_pp * v69 -
                v22 * (s3 * (c1_pp * T11 + s1_pp * T21)))) + Y5_pp * (v3 * (s3 * v70) + factor2_pp *
                (v22 * (v76 - (c1_pp * v74 + s1_pp * v75)) + S2_pp * (v79 + (c1_pp * v77 + s1_pp *
                v78))))))
            )
            q7_pmm = angle6 - math.copysign(half_turn, v81)
            q7_mpm = (
                angle7 - math.copysign(half_turn, -(X5_mp * (c3 * v72 - factor2_pm * (v80 - v23 *
                (s3 * (s1_mp * T21 - v12 * T11)))) + Y5_mp * (v3 * (s3 * v72) + factor2_pm * (S2_mp
                * (v79 + (v12 * v77 - s1_mp * v78)) - v23 * (v76 + (s1_mp * v75 - v12 * v74))))))
            )
            q7_mmm = (
                angle8 - math.copysign(half_turn, -(X5_mm * (c3 * v73 - factor2_mm * (-S2_pp * v69 -
                v22 * (s3 * (s1_mm * T21 - v13 * T11)))) + Y5_mm * (v3 * (s3 * v73) + factor2_mm *
                (-S2_pp * (v79 + (v13 * v77 - s1_mm * v78)) - v22 * (v76 + (s1_mm * v75 - v13 *
                v74))))))
            )
            v83 = angle9 - offset1
            v84 = angle10 - offset1
            v85 = angle11 - offset1
            v86 = angle12 - offset1
            q1_ppp = v83 + (turn if v83 <= -half_turn else 0.0)
            q1_pmp = v84 + (turn if v84 <= -half_turn else 0.0)
            q1_mpp = v85 + (turn if v85 <= -half_turn else 0.0)
            q1_mmp = v86 + (turn if v86 <= -half_turn else 0.0)
            v87 = angle13 - offset2
            v88 = angle14 - offset2
            v89 = angle15 - offset2
            v90 = angle16 - offset2
            q2_ppp = v87 + (turn if v87 <= -half_turn else 0.0)
            q2_pmp = v88 + (turn if v88 <= -half_turn else 0.0)
            q2_mpp = v89 + (turn if v89 <= -half_turn else 0.0)
            q2_mmp = v90 + (turn if v90 <= -half_turn else 0.0)
            v93 = angle18 - offset6
            v94 = offset6 + angle18
            v95 = angle19 - offset6
            v96 = offset6 + angle19
            v97 = angle20 - offset6
            v98 = offset6 + angle20
            v99 = angle21 - offset6
            v100 = offset6 + angle21
            q6_ppp = v93 + (turn if v93 <= -half_turn else 0.0)
            q6_ppm = (turn if -v94 <= -half_turn else 0.0) - v94
            q6_pmp = v95 + (turn if v95 <= -half_turn else 0.0)
            q6_pmm = (turn if -v96 <= -half_turn else 0.0) - v96
            q6_mpp = v97 + (turn if v97 <= -half_turn else 0.0)
            q6_mpm = (turn if -v98 <= -half_turn else 0.0) - v98
            q6_mmp = v99 + (turn if v99 <= -half_turn else 0.0)
            q6_mmm = (turn if -v100 <= -half_turn else 0.0) - v100
            v103 = max(abs(q2_ppp) - high2, max(v101, abs(q1_ppp) - high1))
            v104 = max(abs(q2_pmp) - high2, max(v101, abs(q1_pmp) - high1))
            v105 = max(abs(q2_mpp) - high2, max(v102, abs(q1_mpp) - high1))
            v106 = max(abs(q2_mmp) - high2, max(v102, abs(q1_mmp) - high1))
            excess_ppp = (
                max(abs(angle5) - high7, max(abs(q6_ppp) - high6, max(v103, abs(angle1) - high5)))
            )
            excess_ppm = (
                max(abs(q7_ppm) - high7, max(abs(q6_ppm) - high6, max(v103, abs(q5_ppm) - high5)))
            )
            excess_pmp = (
                max(abs(angle6) - high7, max(abs(q6_pmp) - high6, max(v104, abs(angle2) - high5)))
            )
            excess_pmm = (
                max(abs(q7_pmm) - high7, max(abs(q6_pmm) - high6, max(v104, abs(q5_pmm) - high5)))
            )
            excess_mpp = (
                max(abs(angle7) - high7, max(abs(q6_mpp) - high6, max(v105, abs(angle3) - high5)))
            )
            excess_mpm = (
                max(abs(q7_mpm) - high7, max(abs(q6_mpm) - high6, max(v105, abs(q5_mpm) - high5)))
            )
            excess_mmp = (
                max(abs(angle8) - high7, max(abs(q6_mmp) - high6, max(v106, abs(angle4) - high5)))
            )
            excess_mmm = (
                max(abs(q7_mmm) - high7, max(abs(q6_mmm) - high6, max(v106, abs(q5_mmm) - high5)))
            )
            outside_ppp = 0.0 < excess_ppp
            outside_ppm = 0.0 < excess_ppm
            outside_pmp = 0.0 < excess_pmp
            outside_pmm = 0.0 < excess_pmm
            outside_mpp = 0.0 < excess_mpp
            outside_mpm = 0.0 < excess_mpm
            outside_mmp = 0.0 < excess_mmp
            outside_mmm = 0.0 < excess_mmm
            _2048 = q1_ppp
            work[2048 + k] = _2048
            _2064 = q2_ppp
            work[2064 + k] = _2064
            _2080 = q3_ppp
            work[2080 + k] = _2080
            _2096 = q4_ppp
            work[2096 + k] = _2096
            _2112 = angle1
            work[2112 + k] = _2112
            _2128 = q6_ppp
            work[2128 + k] = _2128
            _2144 = angle5
            work[2144 + k] = _2144
            _2160 = q5_ppm
            work[2160 + k] = _2160
            _2176 = q6_ppm
            work[2176 + k] = _2176
            _2192 = q7_ppm
            work[2192 + k] = _2192
            _2208 = q1_pmp
            work[2208 + k] = _2208
            _2224 = q2_pmp
            work[2224 + k] = _2224
            _2240 = angle2
            work[2240 + k] = _2240
            _2256 = q6_pmp
            work[2256 + k] = _2256
            _2272 = angle6
            work[2272 + k] = _2272
            _2288 = q5_pmm
            work[2288 + k] = _2288
            _2304 = q6_pmm
            work[2304 + k] = _2304
            _2320 = q7_pmm
            work[2320 + k] = _2320
            _2336 = q1_mpp
            work[2336 + k] = _2336
            _2352 = q2_mpp
            work[2352 + k] = _2352
            _2368 = q4_mpp
            work[2368 + k] = _2368
            _2384 = angle3
            work[2384 + k] = _2384
            _2400 = q6_mpp
            work[2400 + k] = _2400
            _2416 = angle7
            work[2416 + k] = _2416
            _2432 = q5_mpm
            work[2432 + k] = _2432
            _2448 = q6_mpm
            work[2448 + k] = _2448
            _2464 = q7_mpm
            work[2464 + k] = _2464
            _2480 = q1_mmp
            work[2480 + k] = _2480
            _2496 = q2_mmp
            work[2496 + k] = _2496
            _2512 = angle4
            work[2512 + k] = _2512
            _2528 = q6_mmp
            work[2528 + k] = _2528
            _2544 = angle8
            work[2544 + k] = _2544
            _2560 = q5_mmm
            work[2560 + k] = _2560
            _2576 = q6_mmm
            work[2576 + k] = _2576
            _2592 = q7_mmm
            work[2592 + k] = _2592
            work[2608 + k] = (
                UNREACHABLE if _2048 != _2048 else (OUT_OF_LIMITS if outside_ppp else OK)
            )
            work[2624 + k] = (
                UNREACHABLE if _2048 != _2048 else (OUT_OF_LIMITS if outside_ppm else OK)
            )
            work[2640 + k] = (
                UNREACHABLE if _2208 != _2208 else (OUT_OF_LIMITS if outside_pmp else OK)
            )
            work[2656 + k] = (
                UNREACHABLE if _2208 != _2208 else (OUT_OF_LIMITS if outside_pmm else OK)
            )
            work[2672 + k] = (
                UNREACHABLE if _2336 != _2336 else (OUT_OF_LIMITS if outside_mpp else OK)
            )
            work[2688 + k] = (
                UNREACHABLE if _2336 != _2336 else (OUT_OF_LIMITS if outside_mpm else OK)
            )
            work[2704 + k] = (
                UNREACHABLE if _2480 != _2480 else (OUT_OF_LIMITS if outside_mmp else OK)
            )
            work[2720 + k] = (
                UNREACHABLE if _2480 != _2480 else (OUT_OF_LIMITS if outside_mmm else OK)
            )
            work[272 + k] = (
                1.0 if N1 <= doubt_limit_squared2 or abs(D4) <= m1 or abs(D1 * (k3 * w4)) <= m2 *
                (merge_slack1 + 2.0 * abs(Z1)) or v51 <= m4 or v27 <= m3 or v50 <= m4 or v49 <= m4
                or v26 <= m3 or v48 <= m4 or 0.0 < abs(given1) - high3 or v25 <= m3 else work[272 +
                k]
            )
            work[272 + k] = (
                1.0 if abs(excess_mmm - graze) <= graze or abs(excess_mmp - graze) <= graze or
                abs(excess_mpm - graze) <= graze or abs(excess_mpp - graze) <= graze or
                abs(excess_pmm - graze) <= graze or abs(excess_pmp - graze) <= graze or
                abs(excess_ppp - graze) <= graze or abs(excess_ppm - graze) <= graze else work[272 +
                k]
            )
        for k in range(first, first + count):
            if work[272 + k - first] != 0.0:
                _unseeded(T[k], q_free[k], q[k], status[k])
                continue
            for row in range(8):
                status[k, row] = np.uint8(work[_KINDS[row] + k - first])
                for i in range(7):
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
        given=1,
        apart=(_HOW.compile_apart,),
        words={
            "no_pose": "not finite, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?), or the value of a free joint not finite",
            "no_row": "the pose is out of reach",
            "allocates": "only where a pose is singular or rounded",
            "given": "Values of the joints 3",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
