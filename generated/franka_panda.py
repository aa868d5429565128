"""franka_panda: Franka Emika Panda.

Inverse kinematics, generated from robots/franka_panda.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/franka_panda.yaml. The formulas and where they come from:
franka_panda.md.

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
_of_joints = _runtime("entry").of_joints(_HOW, 7)

NAME = "franka_panda"
METHOD = "closed form"
DOF = 7
JOINT_TYPES = "RRRRRRR"
JOINT_LIMITS = (
    (-2.8973, 2.8973),
    (-1.7628, 1.7628),
    (-2.8973, 2.8973),
    (-3.0718, -0.0698),
    (-2.8973, 2.8973),
    (-0.0175, 3.7525),
    (-2.8973, 2.8973),
)
BRANCHES = (
    "elbow4+-noflip-elbow3+",
    "elbow4+-noflip-elbow3-",
    "elbow4+-flip-elbow3+",
    "elbow4+-flip-elbow3-",
    "elbow4--noflip-elbow3+",
    "elbow4--noflip-elbow3-",
    "elbow4--flip-elbow3+",
    "elbow4--flip-elbow3-",
)
MAX_SOLUTIONS = 8
FREE_JOINTS = (7,)  # from 1: the caller gives their values

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose, or a free joint's value is not finite

d1 = 0.333  # joint offset 1 [m]
d3 = 0.316  # joint offset 3 [m]
a3 = 0.0825  # link length 4 [m]
d5 = 0.384  # joint offset 5 [m]
a4 = 0.0825  # link length 5 [m]
a6 = 0.088  # link length 7 [m]
d7 = 0.107  # z of the tool frame [m]
reach_slack2 = 1.9404490000000003e-13  # rounding at the boundary of the workspace [m^2]
merge_slack2 = 1.940449e-14  # nearer to that boundary two branches are one [m^2]
least_root2 = 6.136238523396071e-07  # a root of nothing, by rounding [m^2]
free_limit_squared2 = 1.940449e-24  # square of a length that fixes no angle [m^2]
reach_slack1 = 1.393e-13  # rounding at the boundary of the workspace [m]
merge_slack1 = 1.393e-14  # nearer to that boundary two branches are one [m]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.1155  # 2 * (d3 * a4 + d5 * a3) [m^2]
k2 = 0.22907550000000002  # 2 * (d3 * d5 - a4 * a3) [m^2]
k3 = 0.06581583470025  # k1^2 + k2^2 [m^4]
k4 = 0.25318050000000003  # d3^2 + (a4 * a3 + (d5^2 + (a4 * a3 - a6^2))) [m^2]
k5 = 0.515344644461153  # 1 / arm_size2 [m^-2]
k6 = 15.193911990243306  # 1 / k3 [m^-4]
doubt_limit_squared2 = 1.940449e-08  # square of a length that fixes no angle [m^2]
turn1 = 0.46700242365301164  # a constant angle [rad]
high1 = 2.897300001
high2 = 1.762800001
high3 = 2.897300001
low4 = -3.071800001
high4 = -0.069799999
high5 = 2.897300001
low6 = -0.017500001
high6 = 3.752500001
high7 = 2.897300001
graze = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 1.940449e-11  # 1000 * merge_slack2 [m^2]
m2 = 1.754896834873102  # a coefficient of c4
m3 = 3.4805529861209807  # a coefficient of c4
m4 = 1.2446337324912609  # a coefficient of v8
m5 = 0.0825  # a coefficient of v8
m6 = 0.2674017784649193  # a coefficient of v8
m7 = 1.393e-11  # 1000 * merge_slack1 [m]
m9 = 0.384  # a coefficient of Y1_6
m10 = 3.765342321601e-16  # doubt_limit_squared2^2 [m^4]
m11 = 9.999999999999999e-09  # doubt_limit^2

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
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * c2
    x2_y = s1 * c2
    z3_x = c1 * s2
    z3_y = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - s1 * s3
    x3_y = x2_y * c3 + c1 * s3
    v1 = s2 * c3
    z4_x = s1 * c3 + x2_x * s3
    y3_y = c1 * c3 - x2_y * s3
    y3_z = s2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 + z3_x * s4
    x4_y = x3_y * c4 + z3_y * s4
    x4_z = c2 * s4 - v1 * c4
    y4_x = z3_x * c4 - x3_x * s4
    y4_y = z3_y * c4 - x3_y * s4
    y4_z = c2 * c4 + v1 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 - z4_x * s5
    x5_y = x4_y * c5 + y3_y * s5
    x5_z = x4_z * c5 + y3_z * s5
    z6_x = z4_x * c5 + x4_x * s5
    z6_y = x4_y * s5 - y3_y * c5
    z6_z = x4_z * s5 - y3_z * c5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    x6_x = x5_x * c6 + y4_x * s6
    x6_y = x5_y * c6 + y4_y * s6
    x6_z = x5_z * c6 + y4_z * s6
    z7_x = x5_x * s6 - y4_x * c6
    z7_y = x5_y * s6 - y4_y * c6
    z7_z = x5_z * s6 - y4_z * c6
    c7 = math.cos(q[6])
    s7 = math.sin(q[6])
    T[0, 0] = x6_x * c7 + z6_x * s7
    T[0, 1] = z6_x * c7 - x6_x * s7
    T[0, 2] = z7_x
    T[0, 3] = z3_x * d3 + x3_x * a3 - x4_x * a4 + y4_x * d5 + x6_x * a6 + z7_x * d7
    T[1, 0] = x6_y * c7 + z6_y * s7
    T[1, 1] = z6_y * c7 - x6_y * s7
    T[1, 2] = z7_y
    T[1, 3] = z3_y * d3 + x3_y * a3 - x4_y * a4 + y4_y * d5 + x6_y * a6 + z7_y * d7
    T[2, 0] = x6_z * c7 + z6_z * s7
    T[2, 1] = z6_z * c7 - x6_z * s7
    T[2, 2] = z7_z
    T[2, 3] = d1 + c2 * d3 - v1 * a3 - x4_z * a4 + y4_z * d5 + x6_z * a6 + z7_z * d7
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 7): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 7 joint values")
    J = np.zeros((6, 7))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * c2
    x2_y = s1 * c2
    z3_x = c1 * s2
    z3_y = s1 * s2
    p3_x = z3_x * d3
    p3_y = z3_y * d3
    p3_z = d1 + c2 * d3
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - s1 * s3
    x3_y = x2_y * c3 + c1 * s3
    v1 = s2 * c3
    z4_x = s1 * c3 + x2_x * s3
    y3_y = c1 * c3 - x2_y * s3
    y3_z = s2 * s3
    p4_x = p3_x + x3_x * a3
    p4_y = p3_y + x3_y * a3
    p4_z = p3_z - v1 * a3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 + z3_x * s4
    x4_y = x3_y * c4 + z3_y * s4
    x4_z = c2 * s4 - v1 * c4
    y4_x = z3_x * c4 - x3_x * s4
    y4_y = z3_y * c4 - x3_y * s4
    y4_z = c2 * c4 + v1 * s4
    p5_x = p4_x - x4_x * a4 + y4_x * d5
    p5_y = p4_y - x4_y * a4 + y4_y * d5
    p5_z = p4_z - x4_z * a4 + y4_z * d5
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 - z4_x * s5
    x5_y = x4_y * c5 + y3_y * s5
    x5_z = x4_z * c5 + y3_z * s5
    z6_x = z4_x * c5 + x4_x * s5
    z6_y = x4_y * s5 - y3_y * c5
    z6_z = x4_z * s5 - y3_z * c5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    p7_x = p5_x + (x5_x * c6 + y4_x * s6) * a6
    p7_y = p5_y + (x5_y * c6 + y4_y * s6) * a6
    p7_z = p5_z + (x5_z * c6 + y4_z * s6) * a6
    z7_x = x5_x * s6 - y4_x * c6
    z7_y = x5_y * s6 - y4_y * c6
    z7_z = x5_z * s6 - y4_z * c6
    J21 = p7_x + z7_x * d7
    v2 = p7_y + z7_y * d7
    v3 = p7_z + z7_z * d7
    v4 = v3 - d1
    v5 = J21 - p3_x
    v6 = v2 - p3_y
    v7 = v3 - p3_z
    v8 = J21 - p4_x
    v9 = v2 - p4_y
    v10 = v3 - p4_z
    v11 = J21 - p5_x
    v12 = v2 - p5_y
    v13 = v3 - p5_z
    v14 = J21 - p7_x
    v15 = v2 - p7_y
    v16 = v3 - p7_z
    J[0, 0] = -v2
    J[0, 1] = c1 * v4
    J[0, 2] = z3_y * v7 - c2 * v6
    J[0, 3] = -y3_y * v10 + y3_z * v9
    J[0, 4] = y4_y * v13 - y4_z * v12
    J[0, 5] = z6_y * v13 - z6_z * v12
    J[0, 6] = z7_y * v16 - z7_z * v15
    J[1, 0] = J21
    J[1, 1] = s1 * v4
    J[1, 2] = c2 * v5 - z3_x * v7
    J[1, 3] = -(y3_z * v8 + z4_x * v10)
    J[1, 4] = y4_z * v11 - y4_x * v13
    J[1, 5] = z6_z * v11 - z6_x * v13
    J[1, 6] = z7_z * v14 - z7_x * v16
    J[2, 1] = -(s1 * v2 + c1 * J21)
    J[2, 2] = z3_x * v6 - z3_y * v5
    J[2, 3] = z4_x * v9 - -y3_y * v8
    J[2, 4] = y4_x * v12 - y4_y * v11
    J[2, 5] = z6_x * v12 - z6_y * v11
    J[2, 6] = z7_x * v15 - z7_y * v14
    J[3, 1] = -s1
    J[3, 2] = z3_x
    J[3, 3] = z4_x
    J[3, 4] = y4_x
    J[3, 5] = z6_x
    J[3, 6] = z7_x
    J[4, 1] = c1
    J[4, 2] = z3_y
    J[4, 3] = -y3_y
    J[4, 4] = y4_y
    J[4, 5] = z6_y
    J[4, 6] = z7_y
    J[5, 0] = 1.0
    J[5, 2] = c2
    J[5, 3] = -y3_z
    J[5, 4] = y4_z
    J[5, 5] = z6_z
    J[5, 6] = z7_z
    return J


@_inner
def _solve(pose, q_free, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    c7 = math.cos(q_free[0])
    s7 = math.sin(q_free[0])

    # theta4, type 2: the squared length of column 4 of A7 U0^-1 A1
    v1 = d7 * T13 - T14
    v2 = d7 * T23 - T24
    t34 = T34 - d7 * T33
    v3 = d1 - t34
    w2x = T11 * v1 + T21 * v2 + T31 * v3
    w2y = T12 * v1 + T22 * v2 + T32 * v3
    w2z = T13 * v1 + T23 * v2 + T33 * v3
    Z4 = (
        c7 * (2.0 * (w2x * a6)) - s7 * (2.0 * (w2y * a6)) + (w2x * w2x + (w2y * w2y + (w2z * w2z -
        k4)))
    )
    D4 = k3 - Z4 * Z4
    v4 = 2.0 * abs(Z4)
    apart4 = merge_slack2 * (v4 + merge_slack2) < D4
    if not (-(reach_slack2 * (v4 + reach_slack2)) <= D4):
        return  # out of reach
    w4 = math.sqrt(D4 if apart4 else 0.0)
    v5 = (w4 if apart4 else least_root2) * k5
    v6 = k1 * Z4
    v7 = k2 * Z4

    # theta5, type 2: A7 U0^-1 A1 [3, 4]
    Z5 = c7 * w2y + s7 * w2x
    v9 = Z5 * Z5
    v10 = abs(Z5)
    v11 = 2.0 * v10
    v12 = merge_slack1 * (v11 + merge_slack1)

    # theta6, type 3: A7 U0^-1 A1 [2, 4] and A7 U0^-1 A1 [1, 4]
    Z2_6 = a6 + (c7 * w2x - s7 * w2y)

    # theta3, type 2: U0 (A3 A4 A5 A6 A7)^-1 [3, 3]
    v17 = c7 * T31 - s7 * T32
    v22 = c7 * T32 + s7 * T31

    # theta1, type 3: U0 (A3 A4 A5 A6 A7)^-1 [1, 3] and U0 (A3 A4 A5 A6 A7)^-1 [2, 3]
    v28 = c7 * T11 - s7 * T12
    v31 = c7 * T12 + s7 * T11
    v39 = c7 * T21 - s7 * T22
    v42 = c7 * T22 + s7 * T21

    for i1 in range(2):  # elbow4+, elbow4-
        e1 = 1.0 - 2.0 * i1
        # theta4
        if e1 < 0.0 and not apart4:
            continue  # both signs give the same
        root4 = w4 * e1
        c4 = k6 * (v7 + k1 * root4)
        s4 = k6 * (k2 * root4 - v6)
        q4 = _atan2(s4, c4)

        # theta5
        v8 = a3 * c4 + d3 * s4 - a4
        N5 = -v8 * -v8
        free5 = N5 <= free_limit_squared2
        D5 = N5 - v9
        apart5 = v12 < D5
        if not (-(reach_slack1 * (v11 + reach_slack1)) <= v5 * D5):
            continue  # out of reach
        w5 = math.sqrt(D5 if apart5 else 0.0)
        inverse5 = 1.0 / (1.0 if free5 else (N5 if apart5 else v10 * math.sqrt(N5)))
        s5 = math.sin(seed[4]) if free5 else inverse5 * (-v8 * Z5)

        # theta6
        Y1_6 = d5 + (d3 * c4 - a3 * s4)
        v14 = Y1_6 * Z2_6
        v16 = w2z * Y1_6

        # theta3
        v18 = c4 * v17
        v19 = T33 * s4
        v20 = T33 * c4
        v21 = s4 * v17
        v23 = s5 * (c4 * v22)
        v25 = s5 * v17
        v26 = T33 * s5

        # theta2, type 3: U0 (A3 A4 A5 A6 A7)^-1 [3, 2] and U0 (A3 A4 A5 A6 A7)^-1 [3, 1]
        v27 = s5 * (s4 * v22)

        # theta1
        v29 = s5 * v28
        v30 = T13 * s5
        v33 = c4 * v28
        v34 = T13 * s4
        v35 = T13 * c4
        v36 = s4 * v28
        v37 = s5 * (c4 * v31)
        v40 = s5 * v39
        v41 = T23 * s5
        v44 = c4 * v39
        v45 = T23 * s4
        v46 = T23 * c4
        v47 = s4 * v39
        v48 = s5 * (c4 * v42)

        for i2 in range(2):  # noflip, flip
            e2 = 1.0 - 2.0 * i2
            # theta5
            if e2 < 0.0 and (free5 or not apart5):
                continue  # both signs give the same
            c5 = math.cos(seed[4]) if free5 else -(inverse5 * (-v8 * (w5 * e2)))
            q5 = _atan2(s5, c5)

            # theta6
            v13 = v8 * c5
            v15 = w2z * v13 + v14
            C6 = v16 - v13 * Z2_6
            w6 = math.sqrt(v15 * v15 + C6 * C6)
            free6 = w6 <= free_limit_squared2
            factor6 = 1.0 / (1.0 if free6 else w6)
            c6 = math.cos(seed[5]) if free6 else C6 * factor6
            s6 = math.sin(seed[5]) if free6 else -(v15 * factor6)
            q6 = _atan2(s6, c6)

            # theta3
            v24 = c6 * (c5 * v18 + v19) + s6 * (c5 * v20 - v21) + v23
            Y3 = c5 * v22 - (c6 * v25 + s6 * v26)
            w3 = math.sqrt(v24 * v24 + Y3 * Y3)
            free3 = w3 <= free_limit
            divisor3 = 1.0 if free3 else w3

            # theta2
            c2 = c6 * (c5 * v21 - v20) + s6 * (v18 + c5 * v19) + v27

            # theta1
            v32 = c5 * v31 - (c6 * v29 + s6 * v30)
            v38 = c6 * (c5 * v33 + v34) + s6 * (c5 * v35 - v36) + v37
            v43 = c5 * v42 - (c6 * v40 + s6 * v41)
            v49 = c6 * (c5 * v44 + v45) + s6 * (c5 * v46 - v47) + v48

            for i3 in range(2):  # elbow3+, elbow3-
                e3 = 1.0 - 2.0 * i3
                # theta3
                if e3 < 0.0 and free3:
                    continue  # both signs give the same
                factor3 = e3 / divisor3
                c3 = math.cos(seed[2]) if free3 else v24 * factor3
                s3 = math.sin(seed[2]) if free3 else Y3 * factor3
                q3 = _atan2(s3, c3)

                # theta2
                q2 = _atan2(-(w3 * e3), c2)

                # theta1
                s1 = c3 * v32 - s3 * v38
                c1 = s3 * v49 - c3 * v43
                q1 = _atan2(s1, c1)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0] = q1
                q[row, 1] = q2
                q[row, 2] = q3
                q[row, 3] = q4
                q[row, 4] = q5
                q[row, 5] = q6
                q[row, 6] = q_free[0]
                status[row] = FREE_JOINT if free3 or free5 or free6 else OK


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


_CHOOSABLE = (5, 4, 2,)  # joints, from 0, that may be free


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
_PACE = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 0.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.7179, 0.7179, 0.7179, 1.0, 1.0, 1.0])


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
    x[6] = q_free[0]
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

    # theta4, type 2: the squared length of column 4 of A7 U0^-1 A1
    v1 = d7 * T13 - T14
    v2 = d7 * T23 - T24
    v3 = d1 - (T34 - d7 * T33)
    w2x = v1 * T11 + v2 * T21 + v3 * T31
    w2y = v1 * T12 + v2 * T22 + v3 * T32
    w2z = T13 * v1 + T23 * v2 + T33 * v3
    s7 = math.sin(q_free[0])
    c7 = math.cos(q_free[0])

    # theta4, type 2: the squared length of column 4 of A7 U0^-1 A1
    Z4 = (
        c7 * (2.0 * (a6 * w2x)) - s7 * (2.0 * (a6 * w2y)) + (w2x * w2x + (w2y * w2y + (w2z * w2z -
        k4)))
    )
    D4 = k3 - Z4 * Z4
    w4 = math.sqrt(D4)
    v4 = k5 * w4
    v5 = m3 * Z4
    v6 = m2 * w4
    c4_p = v5 + v6
    c4_m = v5 - v6
    v7 = m2 * Z4
    v8 = m3 * w4
    s4_p = v8 - v7
    v9 = v7 + v8

    # theta5, type 2: A7 U0^-1 A1 [3, 4]
    v11 = a3 * c4_p + d3 * s4_p - a4
    v12 = a3 * c4_m - d3 * v9 - a4
    v13 = m5 + m6 * Z4
    v14 = m4 * w4
    v15 = v13 - v14
    v16 = v13 + v14
    N5_p = v15 * v15
    N5_m = v16 * v16
    Z5 = c7 * w2y + s7 * w2x
    v17 = Z5 * Z5
    D5_p = N5_p - v17
    D5_m = N5_m - v17
    w5_p = math.sqrt(D5_p)
    w5_m = math.sqrt(D5_m)
    v18 = w5_p - w5_p
    v19 = w5_m - w5_m
    v20 = m7 * (merge_slack1 + 2.0 * abs(Z5))
    inverse5_p = 1.0 / N5_p
    inverse5_m = 1.0 / N5_m
    v21 = v15 * w5_p
    v22 = v16 * w5_m
    v23 = inverse5_p * v21
    v24 = inverse5_m * v22
    v25 = v15 * Z5
    v26 = v16 * Z5
    s5_p = inverse5_p * v25
    s5_m = inverse5_m * v26

    # theta6, type 3: A7 U0^-1 A1 [2, 4] and A7 U0^-1 A1 [1, 4]
    v27 = m9 + m4 * Z4
    v28 = m6 * w4
    Y1_6_p = v27 + v28
    Y1_6_m = v27 - v28
    Z2_6 = a6 + (c7 * w2x - s7 * w2y)
    v29 = Y1_6_p * Z2_6
    v30 = Y1_6_m * Z2_6
    v31 = w5_p * (inverse5_p * (v11 * (w2z * v15)))
    v32 = v29 - v31
    v33 = v29 + v31
    v34 = w5_m * (inverse5_m * (v12 * (w2z * v16)))
    v35 = v30 - v34
    v36 = v30 + v34
    v37 = w2z * Y1_6_p
    v38 = w2z * Y1_6_m
    v39 = w5_p * (inverse5_p * (v11 * (v15 * Z2_6)))
    C6_pp = v37 + v39
    C6_pm = v37 - v39
    v40 = w5_m * (inverse5_m * (v12 * (v16 * Z2_6)))
    C6_mp = v38 + v40
    C6_mm = v38 - v40
    v41 = v32 * v32 + C6_pp * C6_pp
    v42 = v33 * v33 + C6_pm * C6_pm
    v43 = v35 * v35 + C6_mp * C6_mp
    v44 = v36 * v36 + C6_mm * C6_mm
    factor6_pp = math.sqrt(v41) * (1.0 / v41)
    factor6_pm = math.sqrt(v42) * (1.0 / v42)
    factor6_mp = math.sqrt(v43) * (1.0 / v43)
    factor6_mm = math.sqrt(v44) * (1.0 / v44)

    # theta3, type 2: U0 (A3 A4 A5 A6 A7)^-1 [3, 3]
    v45 = c7 * T31 - s7 * T32
    v46 = c4_p * v45
    v47 = c4_m * v45
    v48 = T33 * s4_p
    v49 = T33 * v9
    v50 = T33 * c4_p
    v51 = T33 * c4_m
    v52 = s4_p * v45
    v53 = v9 * v45
    v54 = c7 * T32 + s7 * T31
    v55 = s5_p * (c4_p * v54)
    v56 = s5_m * (c4_m * v54)
    v57 = v23 * v46
    v58 = v24 * v47
    v59 = v23 * v50
    v60 = v24 * v51
    c3_pp = v55 + factor6_pp * (C6_pp * (v48 - v57) - -v32 * (v52 + v59))
    c3_pm = v55 + factor6_pm * (C6_pm * (v48 + v57) + v33 * (v52 - v59))
    c3_mp = v56 - factor6_mp * (C6_mp * (v49 + v58) + -v35 * (v60 - v53))
    c3_mm = v56 + factor6_mm * (C6_mm * (v58 - v49) - v36 * (v53 + v60))
    v61 = s5_p * v45
    v62 = s5_m * v45
    v63 = T33 * s5_p
    v64 = T33 * s5_m
    v65 = v23 * v54
    v66 = v24 * v54
    v67 = v65 + factor6_pp * (C6_pp * v61 + -v32 * v63)
    v68 = factor6_pm * (C6_pm * v61 - v33 * v63) - v65
    v69 = v66 + factor6_mp * (C6_mp * v62 + -v35 * v64)
    v70 = factor6_mm * (C6_mm * v62 - v36 * v64) - v66
    v71 = c3_pp * c3_pp + v67 * v67
    v72 = c3_pm * c3_pm + v68 * v68
    v73 = c3_mp * c3_mp + v69 * v69
    v74 = c3_mm * c3_mm + v70 * v70

    # theta2, type 3: U0 (A3 A4 A5 A6 A7)^-1 [3, 2] and U0 (A3 A4 A5 A6 A7)^-1 [3, 1]
    v75 = s5_p * (s4_p * v54)
    v76 = s5_m * (v9 * v54)
    v77 = v23 * v52
    v78 = v24 * v53
    v79 = v23 * v48
    v80 = v24 * v49

    # theta1, type 3: U0 (A3 A4 A5 A6 A7)^-1 [1, 3] and U0 (A3 A4 A5 A6 A7)^-1 [2, 3]
    v81 = c7 * T11 - s7 * T12
    v82 = s5_p * v81
    v83 = s5_m * v81
    v84 = T13 * s5_p
    v85 = T13 * s5_m
    v86 = c7 * T12 + s7 * T11
    v87 = v23 * v86
    v88 = v24 * v86
    v89 = T13 * s4_p
    v90 = T13 * v9
    v91 = s4_p * v81
    v92 = v9 * v81
    v93 = s5_p * (c4_p * v86)
    v94 = s5_m * (c4_m * v86)
    v95 = v23 * (c4_p * v81)
    v96 = v24 * (c4_m * v81)
    v97 = v23 * (T13 * c4_p)
    v98 = v24 * (T13 * c4_m)
    s1_pp = (
        v67 * (v93 + factor6_pp * (C6_pp * (v89 - v95) - -v32 * (v91 + v97))) - c3_pp * (v87 +
        factor6_pp * (C6_pp * v82 + -v32 * v84))
    )
    s1_pm = (
        v68 * (v93 + factor6_pm * (C6_pm * (v89 + v95) + v33 * (v91 - v97))) - c3_pm * (factor6_pm *
        (C6_pm * v82 - v33 * v84) - v87)
    )
    s1_mp = (
        v69 * (v94 - factor6_mp * (C6_mp * (v90 + v96) + -v35 * (v98 - v92))) - c3_mp * (v88 +
        factor6_mp * (C6_mp * v83 + -v35 * v85))
    )
    s1_mm = (
        v70 * (v94 + factor6_mm * (C6_mm * (v96 - v90) - v36 * (v92 + v98))) - c3_mm * (factor6_mm *
        (C6_mm * v83 - v36 * v85) - v88)
    )
    v99 = c7 * T21 - s7 * T22
    v100 = s5_p * v99
    v101 = s5_m * v99
    v102 = T23 * s5_p
    v103 = T23 * s5_m
    v104 = c7 * T22 + s7 * T21
    v105 = v23 * v104
    v106 = v24 * v104
    v107 = T23 * s4_p
    v108 = T23 * v9
    v109 = s4_p * v99
    v110 = v9 * v99
    v111 = s5_p * (c4_p * v104)
    v112 = s5_m * (c4_m * v104)
    v113 = v23 * (c4_p * v99)
    v114 = v24 * (c4_m * v99)
    v115 = v23 * (T23 * c4_p)
    v116 = v24 * (T23 * c4_m)

    # joint values
    v137 = q_free[0] + (w4 - w4)
    q7_ppp = v18 + v137
    q7_mpp = v19 + v137

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if (
        v74 <= m11 or v44 <= m10 or v73 <= m11 or v43 <= m10 or v72 <= m11 or v42 <= m10 or v71 <=
        m11 or v41 <= m10 or abs(v4 * D5_m) <= v20 or N5_m <= doubt_limit_squared2 or abs(v4 * D5_p)
        <= v20 or abs(D4) <= m1 * (merge_slack2 + 2.0 * abs(Z4)) or 0.0 < abs(q_free[0]) - high7 or
        N5_p <= doubt_limit_squared2
    ):
        return False

    # angles, side by side
    room[0] = w4
    room[1] = v25
    room[2] = v26
    room[3] = -v32
    room[4] = -v33
    room[5] = -v35
    room[6] = -v36
    room[7] = -v67
    room[8] = -v68
    room[9] = -v69
    room[10] = -v70
    room[11] = -math.sqrt(v71)
    room[12] = -math.sqrt(v72)
    room[13] = -math.sqrt(v73)
    room[14] = -math.sqrt(v74)
    room[15] = s1_pp
    room[16] = s1_pm
    room[17] = s1_mp
    room[18] = s1_mm
    room[24] = Z4
    room[25] = -v21
    room[26] = -v22
    room[27] = C6_pp
    room[28] = C6_pm
    room[29] = C6_mp
    room[30] = C6_mm
    room[31] = c3_pp
    room[32] = c3_pm
    room[33] = c3_mp
    room[34] = c3_mm
    room[35] = v75 + factor6_pp * (-v32 * (v46 - v79) - C6_pp * (v50 + v77))
    room[36] = v75 - factor6_pm * (v33 * (v46 + v79) + C6_pm * (v50 - v77))
    room[37] = factor6_mp * (-v35 * (v47 + v80) - C6_mp * (v51 - v78)) - v76
    room[38] = -(v76 + factor6_mm * (v36 * (v47 - v80) + C6_mm * (v51 + v78)))
    room[39] = (
        c3_pp * (v105 + factor6_pp * (C6_pp * v100 + -v32 * v102)) - v67 * (v111 + factor6_pp *
        (C6_pp * (v107 - v113) - -v32 * (v109 + v115)))
    )
    room[40] = (
        c3_pm * (factor6_pm * (C6_pm * v100 - v33 * v102) - v105) - v68 * (v111 + factor6_pm *
        (C6_pm * (v107 + v113) + v33 * (v109 - v115)))
    )
    room[41] = (
        c3_mp * (v106 + factor6_mp * (C6_mp * v101 + -v35 * v103)) - v69 * (v112 - factor6_mp *
        (C6_mp * (v108 + v114) + -v35 * (v116 - v110)))
    )
    room[42] = (
        c3_mm * (factor6_mm * (C6_mm * v101 - v36 * v103) - v106) - v70 * (v112 + factor6_mm *
        (C6_mm * (v114 - v108) - v36 * (v110 + v116)))
    )
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

    # theta4, type 2: the squared length of column 4 of A7 U0^-1 A1
    q4__p = angle1 - turn1
    v10 = turn1 + angle1

    # theta5, type 2: A7 U0^-1 A1 [3, 4]
    q5_pmp = math.copysign(half_turn, v25) - angle2
    q5_mmp = math.copysign(half_turn, v26) - angle3

    # theta3, type 2: U0 (A3 A4 A5 A6 A7)^-1 [3, 3]
    q3_ppm = angle8 - math.copysign(half_turn, -v67)
    q3_pmm = angle9 - math.copysign(half_turn, -v68)
    q3_mpm = angle10 - math.copysign(half_turn, -v69)
    q3_mmm = angle11 - math.copysign(half_turn, -v70)

    # theta1, type 3: U0 (A3 A4 A5 A6 A7)^-1 [1, 3] and U0 (A3 A4 A5 A6 A7)^-1 [2, 3]
    q1_ppm = angle16 - math.copysign(half_turn, s1_pp)
    q1_pmm = angle17 - math.copysign(half_turn, s1_pm)
    q1_mpm = angle18 - math.copysign(half_turn, s1_mp)
    q1_mmm = angle19 - math.copysign(half_turn, s1_mm)

    # joint values
    v117 = q4__p + (turn if q4__p <= -half_turn else 0.0)
    v118 = (turn if -v10 <= -half_turn else 0.0) - v10
    v119 = max(low4 - v117, v117 - high4)
    v120 = max(low4 - v118, v118 - high4)
    v121 = angle4 + (turn if angle4 < low6 else 0.0)
    v122 = angle5 + (turn if angle5 < low6 else 0.0)
    v123 = angle6 + (turn if angle6 < low6 else 0.0)
    v124 = angle7 + (turn if angle7 < low6 else 0.0)
    v125 = max(low6 - v121, v121 - high6)
    v126 = max(low6 - v122, v122 - high6)
    v127 = max(low6 - v123, v123 - high6)
    v128 = max(low6 - v124, v124 - high6)
    v129 = low6 - angle4
    v130 = low6 - angle5
    v131 = low6 - angle6
    v132 = low6 - angle7
    v133 = v129 if v129 < v125 else v125
    v134 = v130 if v130 < v126 else v126
    v135 = v131 if v131 < v127 else v127
    v136 = v132 if v132 < v128 else v128
    q6_ppp = angle4 if 0.0 < v133 else v121
    q6_pmp = angle5 if 0.0 < v134 else v122
    q6_mpp = angle6 if 0.0 < v135 else v123
    q6_mmp = angle7 if 0.0 < v136 else v124
    q4_ppp = v18 + v117
    q4_mpp = v19 + v118
    v138 = max(v133, max(abs(angle2) - high5, max(v119, abs(angle12) - high2)))
    v139 = max(v134, max(abs(q5_pmp) - high5, max(v119, abs(angle13) - high2)))
    v140 = max(v135, max(abs(angle3) - high5, max(v120, abs(angle14) - high2)))
    v141 = max(v136, max(abs(q5_mmp) - high5, max(v120, abs(angle15) - high2)))
    excess_ppp = max(abs(angle8) - high3, max(v138, abs(angle16) - high1))
    excess_ppm = max(abs(q3_ppm) - high3, max(v138, abs(q1_ppm) - high1))
    excess_pmp = max(abs(angle9) - high3, max(v139, abs(angle17) - high1))
    excess_pmm = max(abs(q3_pmm) - high3, max(v139, abs(q1_pmm) - high1))
    excess_mpp = max(abs(angle10) - high3, max(v140, abs(angle18) - high1))
    excess_mpm = max(abs(q3_mpm) - high3, max(v140, abs(q1_mpm) - high1))
    excess_mmp = max(abs(angle11) - high3, max(v141, abs(angle19) - high1))
    excess_mmm = max(abs(q3_mmm) - high3, max(v141, abs(q1_mmm) - high1))
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

    q[0, 0] = angle16
    q[0, 1] = angle12
    q[0, 2] = angle8
    q[0, 3] = q4_ppp
    q[0, 4] = angle2
    q[0, 5] = q6_ppp
    q[0, 6] = q7_ppp
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else (OUT_OF_LIMITS if outside_ppp else OK)
    q[1, 0] = q1_ppm
    q[1, 1] = -angle12
    q[1, 2] = q3_ppm
    q[1, 3] = q4_ppp
    q[1, 4] = angle2
    q[1, 5] = q6_ppp
    q[1, 6] = q7_ppp
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else (OUT_OF_LIMITS if outside_ppm else OK)
    q[2, 0] = angle17
    q[2, 1] = angle13
    q[2, 2] = angle9
    q[2, 3] = q4_ppp
    q[2, 4] = q5_pmp
    q[2, 5] = q6_pmp
    q[2, 6] = q7_ppp
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else (OUT_OF_LIMITS if outside_pmp else OK)
    q[3, 0] = q1_pmm
    q[3, 1] = -angle13
    q[3, 2] = q3_pmm
    q[3, 3] = q4_ppp
    q[3, 4] = q5_pmp
    q[3, 5] = q6_pmp
    q[3, 6] = q7_ppp
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else (OUT_OF_LIMITS if outside_pmm else OK)
    q[4, 0] = angle18
    q[4, 1] = angle14
    q[4, 2] = angle10
    q[4, 3] = q4_mpp
    q[4, 4] = angle3
    q[4, 5] = q6_mpp
    q[4, 6] = q7_mpp
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else (OUT_OF_LIMITS if outside_mpp else OK)
    q[5, 0] = q1_mpm
    q[5, 1] = -angle14
    q[5, 2] = q3_mpm
    q[5, 3] = q4_mpp
    q[5, 4] = angle3
    q[5, 5] = q6_mpp
    q[5, 6] = q7_mpp
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else (OUT_OF_LIMITS if outside_mpm else OK)
    q[6, 0] = angle19
    q[6, 1] = angle15
    q[6, 2] = angle11
    q[6, 3] = q4_mpp
    q[6, 4] = q5_mmp
    q[6, 5] = q6_mmp
    q[6, 6] = q7_mpp
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else (OUT_OF_LIMITS if outside_mmp else OK)
    q[7, 0] = q1_mmm
    q[7, 1] = -angle15
    q[7, 2] = q3_mmm
    q[7, 3] = q4_mpp
    q[7, 4] = q5_mmp
    q[7, 5] = q6_mmp
    q[7, 6] = q7_mpp
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
    [1456, 1472, 1488, 1504, 1520, 1536, 1552],
    [1568, 1584, 1600, 1504, 1520, 1536, 1552],
    [1616, 1632, 1648, 1504, 1664, 1680, 1552],
    [1696, 1712, 1728, 1504, 1664, 1680, 1552],
    [1744, 1760, 1776, 1792, 1808, 1824, 1840],
    [1856, 1872, 1888, 1792, 1808, 1824, 1840],
    [1904, 1920, 1936, 1792, 1952, 1968, 1840],
    [1984, 2000, 2016, 1792, 1952, 1968, 1840],
])
_KINDS = np.array([2032, 2048, 2064, 2080, 2096, 2112, 2128, 2144])


@_njit(nogil=True)
def _in_tiles(T, q_free, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(2160), 2160)
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
            v1 = d7 * T13 - T14
            v2 = d7 * T23 - T24
            v3 = d1 - (T34 - d7 * T33)
            w2x = v1 * T11 + v2 * T21 + v3 * T31
            w2y = v1 * T12 + v2 * T22 + v3 * T32
            w2z = T13 * v1 + T23 * v2 + T33 * v3
            work[288 + k] = w2x
            work[304 + k] = w2y
            work[320 + k] = w2z
            work[336 + k] = given1
            work[352 + k] = given1
        for k in range(336, 352):
            work[k] = math.sin(work[k])
        for k in range(352, 368):
            work[k] = math.cos(work[k])
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
            w2x = work[288 + k]
            w2y = work[304 + k]
            w2z = work[320 + k]
            s7 = work[336 + k]
            c7 = work[352 + k]
            Z4 = (
                c7 * (2.0 * (a6 * w2x)) - s7 * (2.0 * (a6 * w2y)) + (w2x * w2x + (w2y * w2y + (w2z *
                w2z - k4)))
            )
            D4 = k3 - Z4 * Z4
            w4 = math.sqrt(D4)
            v4 = k5 * w4
            v5 = m3 * Z4
            v6 = m2 * w4
            c4_p = v5 + v6
            c4_m = v5 - v6
            v7 = m2 * Z4
            v8 = m3 * w4
            s4_p = v8 - v7
            v9 = v7 + v8
            v11 = a3 * c4_p + d3 * s4_p - a4
            v12 = a3 * c4_m - d3 * v9 - a4
            v13 = m5 + m6 * Z4
            v14 = m4 * w4
            v15 = v13 - v14
            v16 = v13 + v14
            N5_p = v15 * v15
            N5_m = v16 * v16
            Z5 = c7 * w2y + s7 * w2x
            v17 = Z5 * Z5
            D5_p = N5_p - v17
            D5_m = N5_m - v17
            w5_p = math.sqrt(D5_p)
            w5_m = math.sqrt(D5_m)
            v18 = w5_p - w5_p
            v19 = w5_m - w5_m
            v20 = m7 * (merge_slack1 + 2.0 * abs(Z5))
            inverse5_p = 1.0 / N5_p
            inverse5_m = 1.0 / N5_m
            v21 = v15 * w5_p
            v22 = v16 * w5_m
            v23 = inverse5_p * v21
            v24 = inverse5_m * v22
            v25 = v15 * Z5
            v26 = v16 * Z5
            s5_p = inverse5_p * v25
            s5_m = inverse5_m * v26
            v27 = m9 + m4 * Z4
            v28 = m6 * w4
            Y1_6_p = v27 + v28
            Y1_6_m = v27 - v28
            Z2_6 = a6 + (c7 * w2x - s7 * w2y)
            v29 = Y1_6_p * Z2_6
            v30 = Y1_6_m * Z2_6
            v31 = w5_p * (inverse5_p * (v11 * (w2z * v15)))
            v32 = v29 - v31
            v33 = v29 + v31
            v34 = w5_m * (inverse5_m * (v12 * (w2z * v16)))
            v35 = v30 - v34
            v36 = v30 + v34
            v37 = w2z * Y1_6_p
            v38 = w2z * Y1_6_m
            v39 = w5_p * (inverse5_p * (v11 * (v15 * Z2_6)))
            C6_pp = v37 + v39
            C6_pm = v37 - v39
            v40 = w5_m * (inverse5_m * (v12 * (v16 * Z2_6)))
            C6_mp = v38 + v40
            C6_mm = v38 - v40
            v41 = v32 * v32 + C6_pp * C6_pp
            v42 = v33 * v33 + C6_pm * C6_pm
            v43 = v35 * v35 + C6_mp * C6_mp
            v44 = v36 * v36 + C6_mm * C6_mm
            factor6_pp = math.sqrt(v41) * (1.0 / v41)
            factor6_pm = math.sqrt(v42) * (1.0 / v42)
            factor6_mp = math.sqrt(v43) * (1.0 / v43)
            factor6_mm = math.sqrt(v44) * (1.0 / v44)
            v45 = c7 * T31 - s7 * T32
            v46 = c4_p * v45
            v47 = c4_m * v45
            v48 = T33 * s4_p
            v49 = T33 * v9
            v50 = T33 * c4_p
            v51 = T33 * c4_m
            v52 = s4_p * v45
            v53 = v9 * v45
            v54 = c7 * T32 + s7 * T31
            v55 = s5_p * (c4_p * v54)
            v56 = s5_m * (c4_m * v54)
            v57 = v23 * v46
            v58 = v24 * v47
            v59 = v23 * v50
            v60 = v24 * v51
            c3_pp = v55 + factor6_pp * (C6_pp * (v48 - v57) - -v32 * (v52 + v59))
            c3_pm = v55 + factor6_pm * (C6_pm * (v48 + v57) + v33 * (v52 - v59))
            c3_mp = v56 - factor6_mp * (C6_mp * (v49 + v58) + -v35 * (v60 - v53))
            c3_mm = v56 + factor6_mm * (C6_mm * (v58 - v49) - v36 * (v53 + v60))
            v61 = s5_p * v45
            v62 = s5_m * v45
            v63 = T33 * s5_p
            v64 = T33 * s5_m
            v65 = v23 * v54
            v66 = v24 * v54
            v67 = v65 + factor6_pp * (C6_pp * v61 + -v32 * v63)
            v68 = factor6_pm * (C6_pm * v61 - v33 * v63) - v65
            v69 = v66 + factor6_mp * (C6_mp * v62 + -v35 * v64)
            v70 = factor6_mm * (C6_mm * v62 - v36 * v64) - v66
            v71 = c3_pp * c3_pp + v67 * v67
            v72 = c3_pm * c3_pm + v68 * v68
            v73 = c3_mp * c3_mp + v69 * v69
            v74 = c3_mm * c3_mm + v70 * v70
            v75 = s5_p * (s4_p * v54)
            v76 = s5_m * (v9 * v54)
            v77 = v23 * v52
            v78 = v24 * v53
            v79 = v23 * v48
            v80 = v24 * v49
            v81 = c7 * T11 - s7 * T12
            v82 = s5_p * v81
            v83 = s5_m * v81
            v84 = T13 * s5_p
            v85 = T13 * s5_m
            v86 = c7 * T12 + s7 * T11
            v87 = v23 * v86
            v88 = v24 * v86
            v89 = T13 * s4_p
            v90 = T13 * v9
            v91 = s4_p * v81
            v92 = v9 * v81
            v93 = s5_p * (c4_p * v86)
            v94 = s5_m * (c4_m * v86)
            v95 = v23 * (c4_p * v81)
            v96 = v24 * (c4_m * v81)
            v97 = v23 * (T13 * c4_p)
            v98 = v24 * (T13 * c4_m)
            s1_pp = (
                v67 * (v93 + factor6_pp * (C6_pp * (v89 - v95) - -v32 * (v91 + v97))) - c3_pp * (v87
                + factor6_pp * (C6_pp * v82 + -v32 * v84))
            )
            s1_pm = (
                v68 * (v93 + factor6_pm * (C6_pm * (v89 + v95) + v33 * (v91 - v97))) - c3_pm *
                (factor6_pm * (C6_pm * v82 - v33 * v84) - v87)
            )
            s1_mp = (
                v69 * (v94 - factor6_mp * (C6_mp * (v90 + v96) + -v35 * (v98 - v92))) - c3_mp * (v88
                + factor6_mp * (C6_mp * v83 + -v35 * v85))
            )
            s1_mm = (
                v70 * (v94 + factor6_mm * (C6_mm * (v96 - v90) - v36 * (v92 + v98))) - c3_mm *
                (factor6_mm * (C6_mm * v83 - v36 * v85) - v88)
            )
            v99 = c7 * T21 - s7 * T22
            v100 = s5_p * v99
            v101 = s5_m * v99
            v102 = T23 * s5_p
            v103 = T23 * s5_m
            v104 = c7 * T22 + s7 * T21
            v105 = v23 * v104
            v106 = v24 * v104
            v107 = T23 * s4_p
            v108 = T23 * v9
            v109 = s4_p * v99
            v110 = v9 * v99
            v111 = s5_p * (c4_p * v104)
            v112 = s5_m * (c4_m * v104)
            v113 = v23 * (c4_p * v99)
            v114 = v24 * (c4_m * v99)
            v115 = v23 * (T23 * c4_p)
            v116 = v24 * (T23 * c4_m)
            v137 = given1 + (w4 - w4)
            q7_ppp = v18 + v137
            q7_mpp = v19 + v137
            work[368 + k] = Z4
            work[384 + k] = D4
            work[400 + k] = v4
            work[416 + k] = N5_p
            work[432 + k] = N5_m
            work[448 + k] = D5_p
            work[464 + k] = D5_m
            work[480 + k] = v18
            work[496 + k] = v19
            work[512 + k] = v20
            work[528 + k] = v25
            work[544 + k] = v26
            work[560 + k] = v41
            work[576 + k] = v42
            work[592 + k] = v43
            work[608 + k] = v44
            work[624 + k] = v67
            work[640 + k] = v68
            work[656 + k] = v69
            work[672 + k] = v70
            work[688 + k] = v71
            work[704 + k] = v72
            work[720 + k] = v73
            work[736 + k] = v74
            work[752 + k] = s1_pp
            work[768 + k] = s1_pm
            work[784 + k] = s1_mp
            work[800 + k] = s1_mm
            work[816 + k] = q7_ppp
            work[832 + k] = q7_mpp
            work[848 + k] = w4
            work[864 + k] = v25
            work[880 + k] = v26
            work[896 + k] = -v32
            work[912 + k] = -v33
            work[928 + k] = -v35
            work[944 + k] = -v36
            work[960 + k] = -v67
            work[976 + k] = -v68
            work[992 + k] = -v69
            work[1008 + k] = -v70
            work[1024 + k] = -math.sqrt(v71)
            work[1040 + k] = -math.sqrt(v72)
            work[1056 + k] = -math.sqrt(v73)
            work[1072 + k] = -math.sqrt(v74)
            work[1088 + k] = s1_pp
            work[1104 + k] = s1_pm
            work[1120 + k] = s1_mp
            work[1136 + k] = s1_mm
            work[1152 + k] = Z4
            work[1168 + k] = -v21
            work[1184 + k] = -v22
            work[1200 + k] = C6_pp
            work[1216 + k] = C6_pm
            work[1232 + k] = C6_mp
            work[1248 + k] = C6_mm
            work[1264 + k] = c3_pp
            work[1280 + k] = c3_pm
            work[1296 + k] = c3_mp
            work[1312 + k] = c3_mm
            work[1328 + k] = v75 + factor6_pp * (-v32 * (v46 - v79) - C6_pp * (v50 + v77))
            work[1344 + k] = v75 - factor6_pm * (v33 * (v46 + v79) + C6_pm * (v50 - v77))
            work[1360 + k] = factor6_mp * (-v35 * (v47 + v80) - C6_mp * (v51 - v78)) - v76
            work[1376 + k] = -(v76 + factor6_mm * (v36 * (v47 - v80) + C6_mm * (v51 + v78)))
            work[1392 + k] = (
                c3_pp * (v105 + factor6_pp * (C6_pp * v100 + -v32 * v102)) - v67 * (v111 +
                factor6_pp * (C6_pp * (v107 - v113) - -v32 * (v109 + v115)))
            )
            work[1408 + k] = (
                c3_pm * (factor6_pm * (C6_pm * v100 - v33 * v102) - v105) - v68 * (v111 + factor6_pm
                * (C6_pm * (v107 + v113) + v33 * (v109 - v115)))
            )
            work[1424 + k] = (
                c3_mp * (v106 + factor6_mp * (C6_mp * v101 + -v35 * v103)) - v69 * (v112 -
                factor6_mp * (C6_mp * (v108 + v114) + -v35 * (v116 - v110)))
            )
            work[1440 + k] = (
                c3_mm * (factor6_mm * (C6_mm * v101 - v36 * v103) - v106) - v70 * (v112 + factor6_mm
                * (C6_mm * (v114 - v108) - v36 * (v110 + v116)))
            )
        for k in range(848, 1152):
            work[k] = _atan2(work[k], work[k + 304])
        for k in range(0, 16):
            given1 = work[256 + k]
            Z4 = work[368 + k]
            D4 = work[384 + k]
            v4 = work[400 + k]
            N5_p = work[416 + k]
            N5_m = work[432 + k]
            D5_p = work[448 + k]
            D5_m = work[464 + k]
            v18 = work[480 + k]
            v19 = work[496 + k]
            v20 = work[512 + k]
            v25 = work[528 + k]
            v26 = work[544 + k]
            v41 = work[560 + k]
            v42 = work[576 + k]
            v43 = work[592 + k]
            v44 = work[608 + k]
            v67 = work[624 + k]
            v68 = work[640 + k]
            v69 = work[656 + k]
            v70 = work[672 + k]
            v71 = work[688 + k]
            v72 = work[704 + k]
            v73 = work[720 + k]
            v74 = work[736 + k]
            s1_pp = work[752 + k]
            s1_pm = work[768 + k]
            s1_mp = work[784 + k]
            s1_mm = work[800 + k]
            q7_ppp = work[816 + k]
            q7_mpp = work[832 + k]
            angle1 = work[848 + k]
            angle2 = work[864 + k]
            angle3 = work[880 + k]
            angle4 = work[896 + k]
            angle5 = work[912 + k]
            angle6 = work[928 + k]
            angle7 = work[944 + k]
            angle8 = work[960 + k]
            angle9 = work[976 + k]
            angle10 = work[992 + k]
            angle11 = work[1008 + k]
            angle12 = work[1024 + k]
            angle13 = work[1040 + k]
            angle14 = work[1056 + k]
            angle15 = work[1072 + k]
            angle16 = work[1088 + k]
            angle17 = work[1104 + k]
            angle18 = work[1120 + k]
            angle19 = work[1136 + k]
            q4__p = angle1 - turn1
            v10 = turn1 + angle1
            q5_pmp = math.copysign(half_turn, v25) - angle2
            q5_mmp = math.copysign(half_turn, v26) - angle3
            q3_ppm = angle8 - math.copysign(half_turn, -v67)
            q3_pmm = angle9 - math.copysign(half_turn, -v68)
            q3_mpm = angle10 - math.copysign(half_turn, -v69)
            q3_mmm = angle11 - math.copysign(half_turn, -v70)
            q1_ppm = angle16 - math.copysign(half_turn, s1_pp)
            q1_pmm = angle17 - math.copysign(half_turn, s1_pm)
            q1_mpm = angle18 - math.copysign(half_turn, s1_mp)
            q1_mmm = angle19 - math.copysign(half_turn, s1_mm)
            v117 = q4__p + (turn if q4__p <= -half_turn else 0.0)
            v118 = (turn if -v10 <= -half_turn else 0.0) - v10
            v119 = max(low4 - v117, v117 - high4)
            v120 = max(low4 - v118, v118 - high4)
            v121 = angle4 + (turn if angle4 < low6 else 0.0)
            v122 = angle5 + (turn if angle5 < low6 else 0.0)
            v123 = angle6 + (turn if angle6 < low6 else 0.0)
            v124 = angle7 + (turn if angle7 < low6 else 0.0)
            v125 = max(low6 - v121, v121 - high6)
            v126 = max(low6 - v122, v122 - high6)
            v127 = max(low6 - v123, v123 - high6)
            v128 = max(low6 - v124, v124 - high6)
            v129 = low6 - angle4
            v130 = low6 - angle5
            v131 = low6 - angle6
            v132 = low6 - angle7
            v133 = v129 if v129 < v125 else v125
            v134 = v130 if v130 < v126 else v126
            v135 = v131 if v131 < v127 else v127
            v136 = v132 if v132 < v128 else v128
            q6_ppp = angle4 if 0.0 < v133 else v121
            q6_pmp = angle5 if 0.0 < v134 else v122
            q6_mpp = angle6 if 0.0 < v135 else v123
            q6_mmp = angle7 if 0.0 < v136 else v124
            q4_ppp = v18 + v117
            q4_mpp = v19 + v118
            v138 = max(v133, max(abs(angle2) - high5, max(v119, abs(angle12) - high2)))
            v139 = max(v134, max(abs(q5_pmp) - high5, max(v119, abs(angle13) - high2)))
            v140 = max(v135, max(abs(angle3) - high5, max(v120, abs(angle14) - high2)))
            v141 = max(v136, max(abs(q5_mmp) - high5, max(v120, abs(angle15) - high2)))
            excess_ppp = max(abs(angle8) - high3, max(v138, abs(angle16) - high1))
            excess_ppm = max(abs(q3_ppm) - high3, max(v138, abs(q1_ppm) - high1))
            excess_pmp = max(abs(angle9) - high3, max(v139, abs(angle17) - high1))
            excess_pmm = max(abs(q3_pmm) - high3, max(v139, abs(q1_pmm) - high1))
            excess_mpp = max(abs(angle10) - high3, max(v140, abs(angle18) - high1))
            excess_mpm = max(abs(q3_mpm) - high3, max(v140, abs(q1_mpm) - high1))
            excess_mmp = max(abs(angle11) - high3, max(v141, abs(angle19) - high1))
            excess_mmm = max(abs(q3_mmm) - high3, max(v141, abs(q1_mmm) - high1))
            outside_ppp = 0.0 < excess_ppp
            outside_ppm = 0.0 < excess_ppm
            outside_pmp = 0.0 < excess_pmp
            outside_pmm = 0.0 < excess_pmm
            outside_mpp = 0.0 < excess_mpp
            outside_mpm = 0.0 < excess_mpm
            outside_mmp = 0.0 < excess_mmp
            outside_mmm = 0.0 < excess_mmm
            _1456 = angle16
            work[1456 + k] = _1456
            _1472 = angle12
            work[1472 + k] = _1472
            _1488 = angle8
            work[1488 + k] = _1488
            _1504 = q4_ppp
            work[1504 + k] = _1504
            _1520 = angle2
            work[1520 + k] = _1520
            _1536 = q6_ppp
            work[1536 + k] = _1536
            _1552 = q7_ppp
            work[1552 + k] = _1552
            _1568 = q1_ppm
            work[1568 + k] = _1568
            _1584 = -angle12
            work[1584 + k] = _1584
            _1600 = q3_ppm
            work[1600 + k] = _1600
            _1616 = angle17
            work[1616 + k] = _1616
            _1632 = angle13
            work[1632 + k] = _1632
            _1648 = angle9
            work[1648 + k] = _1648
            _1664 = q5_pmp
            work[1664 + k] = _1664
            _1680 = q6_pmp
            work[1680 + k] = _1680
            _1696 = q1_pmm
            work[1696 + k] = _1696
            _1712 = -angle13
            work[1712 + k] = _1712
            _1728 = q3_pmm
            work[1728 + k] = _1728
            _1744 = angle18
            work[1744 + k] = _1744
            _1760 = angle14
            work[1760 + k] = _1760
            _1776 = angle10
            work[1776 + k] = _1776
            _1792 = q4_mpp
            work[1792 + k] = _1792
            _1808 = angle3
            work[1808 + k] = _1808
            _1824 = q6_mpp
            work[1824 + k] = _1824
            _1840 = q7_mpp
            work[1840 + k] = _1840
            _1856 = q1_mpm
            work[1856 + k] = _1856
            _1872 = -angle14
            work[1872 + k] = _1872
            _1888 = q3_mpm
            work[1888 + k] = _1888
            _1904 = angle19
            work[1904 + k] = _1904
            _1920 = angle15
            work[1920 + k] = _1920
            _1936 = angle11
            work[1936 + k] = _1936
            _1952 = q5_mmp
            work[1952 + k] = _1952
            _1968 = q6_mmp
            work[1968 + k] = _1968
            _1984 = q1_mmm
            work[1984 + k] = _1984
            _2000 = -angle15
            work[2000 + k] = _2000
            _2016 = q3_mmm
            work[2016 + k] = _2016
            work[2032 + k] = (
                UNREACHABLE if _1456 != _1456 else (OUT_OF_LIMITS if outside_ppp else OK)
            )
            work[2048 + k] = (
                UNREACHABLE if _1568 != _1568 else (OUT_OF_LIMITS if outside_ppm else OK)
            )
            work[2064 + k] = (
                UNREACHABLE if _1616 != _1616 else (OUT_OF_LIMITS if outside_pmp else OK)
            )
            work[2080 + k] = (
                UNREACHABLE if _1696 != _1696 else (OUT_OF_LIMITS if outside_pmm else OK)
            )
            work[2096 + k] = (
                UNREACHABLE if _1744 != _1744 else (OUT_OF_LIMITS if outside_mpp else OK)
            )
            work[2112 + k] = (
                UNREACHABLE if _1856 != _1856 else (OUT_OF_LIMITS if outside_mpm else OK)
            )
            work[2128 + k] = (
                UNREACHABLE if _1904 != _1904 else (OUT_OF_LIMITS if outside_mmp else OK)
            )
            work[2144 + k] = (
                UNREACHABLE if _1984 != _1984 else (OUT_OF_LIMITS if outside_mmm else OK)
            )
            work[272 + k] = (
                1.0 if v74 <= m11 or v44 <= m10 or v73 <= m11 or v43 <= m10 or v72 <= m11 or v42 <=
                m10 or v71 <= m11 or v41 <= m10 or abs(v4 * D5_m) <= v20 or N5_m <=
                doubt_limit_squared2 or abs(v4 * D5_p) <= v20 or abs(D4) <= m1 * (merge_slack2 + 2.0
                * abs(Z4)) or 0.0 < abs(given1) - high7 or N5_p <= doubt_limit_squared2 else
                work[272 + k]
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
            "given": "Values of the joints 7",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
