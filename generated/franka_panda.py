"""franka_panda: Franka Emika Panda.

Inverse kinematics, generated from robots/franka_panda.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/franka_panda.yaml. The formulas and where they come from:
franka_panda.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Every entry of
a pose counts.
"""

import math
import os
from concurrent.futures import ThreadPoolExecutor

import numpy as np

try:
    from numba import njit
except ImportError:  # plain Python, only slower

    def njit(*_, **__):
        return lambda function: function


_OPTIONS = {"cache": True, "error_model": "numpy"}
_jit = njit(**_OPTIONS)

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
    "noflip4-noflip6-left",
    "noflip4-noflip6-right",
    "noflip4-flip6-left",
    "noflip4-flip6-right",
    "flip4-noflip6-left",
    "flip4-noflip6-right",
    "flip4-flip6-left",
    "flip4-flip6-right",
)
MAX_SOLUTIONS = 8
FREE_JOINTS = (7,)  # from 1: the caller gives their values

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose, or a free joint's value is not finite

d1 = 0.333  # joint offset 1 [m]
d3 = 0.316  # joint offset 3 [m]
a3 = 0.0825  # link length 4 [m]
d5 = 0.384  # joint offset 5 [m]
a4 = 0.0825  # link length 5 [m]
a6 = 0.088  # link length 7 [m]
d7 = 0.107  # z of the tool frame [m]
reach_slack2 = 1.9404490000000003e-13  # rounding at the boundary of the workspace [m^2]
merge_slack2 = 1.940449e-14  # nearer to that boundary two branches are one [m^2]
free_limit_squared2 = 1.940449e-24  # square of a length that fixes no angle [m^2]
reach_slack1 = 1.393e-13  # rounding at the boundary of the workspace [m]
merge_slack1 = 1.393e-14  # nearer to that boundary two branches are one [m]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.1155  # 2 * (d3 * a4 + d5 * a3) [m^2]
k2 = 0.22907550000000002  # 2 * (d3 * d5 - a4 * a3) [m^2]
k3 = 0.25318050000000003  # d3^2 + (a4 * a3 + (d5^2 + (a4 * a3 - a6^2))) [m^2]
k4 = 0.06581583470025  # (2 * (d3 * a4 + d5 * a3))^2 + (2 * (d3 * d5 - a4 * a3))^2 [m^4]
k5 = 15.193911990243306  # 1 / ((2 * (d3 * a4 + d5 * a3))^2 + (2 * (d3 * d5 - a4 * a3))^2) [m^-4]
turn1 = 0.46700242365301164  # a constant angle [rad]
half_turn = 3.141592653589793  # pi [rad]
low1 = -2.897300001  # lowest value of joint 1
high1 = 2.897300001  # highest value of joint 1
whole_turn = 6.283185307179586  # 2 pi [rad]
low2 = -1.762800001  # lowest value of joint 2
high2 = 1.762800001  # highest value of joint 2
low3 = -2.897300001  # lowest value of joint 3
high3 = 2.897300001  # highest value of joint 3
low4 = -3.071800001  # lowest value of joint 4
high4 = -0.069799999  # highest value of joint 4
low5 = -2.897300001  # lowest value of joint 5
high5 = 2.897300001  # highest value of joint 5
low6 = -0.017500001  # lowest value of joint 6
high6 = 3.752500001  # highest value of joint 6
low7 = -2.897300001  # lowest value of joint 7
high7 = 2.897300001  # highest value of joint 7
m1 = 3.765342321601e-48  # free_limit_squared2^2 [m^4]
m3 = 1e-24  # free_limit^2
m4 = 6.283185307179586  # 2 * half_turn
h1 = 1.0  # 2 * m2

_TURN = 6.283185307179586
# The limits with what rounding may add.
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - 1e-09
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + 1e-09
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0])
_ZEROS = np.zeros(DOF)
_FLOAT = np.dtype(np.float64)
_BYTE = np.dtype(np.uint8)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the text says which."""


@njit(fastmath={"contract"}, **_OPTIONS)
def _atan2(y, x):
    """math.atan2 by a polynomial: without branches, within 3 units in the last place."""
    along, across = abs(x), abs(y)
    far = along if along > across else across
    near = across if along > across else along
    steep = near > 0.41421356237309515 * far  # tan(pi/8)
    divisor = near + far if steep else far
    r = (near - far if steep else near) / (1.0 if divisor == 0.0 else divisor)
    u = r * r
    p = -0.01917454359469326
    p = p * u + 0.039229744582632814
    p = p * u - 0.050853834915688644
    p = p * u + 0.05858136252639731
    p = p * u - 0.0666450998991572
    p = p * u + 0.07692183087347286
    p = p * u - 0.0909090457366891
    p = p * u + 0.11111111015146682
    p = p * u - 0.14285714284665177
    p = p * u + 0.19999999999995513
    p = p * u - 0.3333333333333333
    angle = r + r * u * p + (0.7853981633974483 if steep else 0.0)
    angle = 1.5707963267948966 - angle if across > along else angle
    angle = 3.141592653589793 - angle if math.copysign(1.0, x) < 0.0 else angle
    return math.copysign(angle, y)


@_jit
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
    T13_ = x5_x * s6 - y4_x * c6
    T23_ = x5_y * s6 - y4_y * c6
    T33_ = x5_z * s6 - y4_z * c6
    c7 = math.cos(q[6])
    s7 = math.sin(q[6])
    T11_ = x6_x * c7 + z6_x * s7
    T21_ = x6_y * c7 + z6_y * s7
    T31_ = x6_z * c7 + z6_z * s7
    T12_ = z6_x * c7 - x6_x * s7
    T22_ = z6_y * c7 - x6_y * s7
    T32_ = z6_z * c7 - x6_z * s7
    T14_ = z3_x * d3 + x3_x * a3 - x4_x * a4 + y4_x * d5 + x6_x * a6 + T13_ * d7
    T24_ = z3_y * d3 + x3_y * a3 - x4_y * a4 + y4_y * d5 + x6_y * a6 + T23_ * d7
    T34_ = d1 + c2 * d3 - v1 * a3 - x4_z * a4 + y4_z * d5 + x6_z * a6 + T33_ * d7
    T[0, 0] = T11_
    T[0, 1] = T12_
    T[0, 2] = T13_
    T[0, 3] = T14_
    T[1, 0] = T21_
    T[1, 1] = T22_
    T[1, 2] = T23_
    T[1, 3] = T24_
    T[2, 0] = T31_
    T[2, 1] = T32_
    T[2, 2] = T33_
    T[2, 3] = T34_
    T[3, 3] = 1.0
    return T


_COMPILED = hasattr(fk, "py_func")  # plain Python stops at the root of a negative number


@_jit
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
    J43 = c1 * s2
    J53 = s1 * s2
    p3_x = J43 * d3
    p3_y = J53 * d3
    p3_z = d1 + c2 * d3
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - s1 * s3
    x3_y = x2_y * c3 + c1 * s3
    v1 = s2 * c3
    J44 = s1 * c3 + x2_x * s3
    y3_y = c1 * c3 - x2_y * s3
    y3_z = s2 * s3
    p4_x = p3_x + x3_x * a3
    p4_y = p3_y + x3_y * a3
    p4_z = p3_z - v1 * a3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 + J43 * s4
    x4_y = x3_y * c4 + J53 * s4
    x4_z = c2 * s4 - v1 * c4
    J45 = J43 * c4 - x3_x * s4
    J55 = J53 * c4 - x3_y * s4
    J65 = c2 * c4 + v1 * s4
    p5_x = p4_x - x4_x * a4 + J45 * d5
    p5_y = p4_y - x4_y * a4 + J55 * d5
    p5_z = p4_z - x4_z * a4 + J65 * d5
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 - J44 * s5
    x5_y = x4_y * c5 + y3_y * s5
    x5_z = x4_z * c5 + y3_z * s5
    J46 = J44 * c5 + x4_x * s5
    J56 = x4_y * s5 - y3_y * c5
    J66 = x4_z * s5 - y3_z * c5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    p7_x = p5_x + (x5_x * c6 + J45 * s6) * a6
    p7_y = p5_y + (x5_y * c6 + J55 * s6) * a6
    p7_z = p5_z + (x5_z * c6 + J65 * s6) * a6
    J47 = x5_x * s6 - J45 * c6
    J57 = x5_y * s6 - J55 * c6
    J67 = x5_z * s6 - J65 * c6
    J21 = p7_x + J47 * d7
    v2 = p7_y + J57 * d7
    v3 = p7_z + J67 * d7
    v4 = v3 - d1
    J12 = c1 * v4
    J22 = s1 * v4
    v5 = J21 - p3_x
    v6 = v2 - p3_y
    v7 = v3 - p3_z
    J13 = J53 * v7 - c2 * v6
    J23 = c2 * v5 - J43 * v7
    J33 = J43 * v6 - J53 * v5
    v8 = J21 - p4_x
    v9 = v2 - p4_y
    v10 = v3 - p4_z
    J14 = -y3_y * v10 + y3_z * v9
    J34 = J44 * v9 - -y3_y * v8
    v11 = J21 - p5_x
    v12 = v2 - p5_y
    v13 = v3 - p5_z
    J15 = J55 * v13 - J65 * v12
    J25 = J65 * v11 - J45 * v13
    J35 = J45 * v12 - J55 * v11
    J16 = J56 * v13 - J66 * v12
    J26 = J66 * v11 - J46 * v13
    J36 = J46 * v12 - J56 * v11
    v14 = J21 - p7_x
    v15 = v2 - p7_y
    v16 = v3 - p7_z
    J17 = J57 * v16 - J67 * v15
    J27 = J67 * v14 - J47 * v16
    J37 = J47 * v15 - J57 * v14
    J[0, 0] = -v2
    J[0, 1] = J12
    J[0, 2] = J13
    J[0, 3] = J14
    J[0, 4] = J15
    J[0, 5] = J16
    J[0, 6] = J17
    J[1, 0] = J21
    J[1, 1] = J22
    J[1, 2] = J23
    J[1, 3] = -(y3_z * v8 + J44 * v10)
    J[1, 4] = J25
    J[1, 5] = J26
    J[1, 6] = J27
    J[2, 1] = -(s1 * v2 + c1 * J21)
    J[2, 2] = J33
    J[2, 3] = J34
    J[2, 4] = J35
    J[2, 5] = J36
    J[2, 6] = J37
    J[3, 1] = -s1
    J[3, 2] = J43
    J[3, 3] = J44
    J[3, 4] = J45
    J[3, 5] = J46
    J[3, 6] = J47
    J[4, 1] = c1
    J[4, 2] = J53
    J[4, 3] = -y3_y
    J[4, 4] = J55
    J[4, 5] = J56
    J[4, 6] = J57
    J[5, 0] = 1.0
    J[5, 2] = c2
    J[5, 3] = -y3_z
    J[5, 4] = J65
    J[5, 5] = J66
    J[5, 6] = J67
    return J


@_jit
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
    v4 = w2z * w2z
    Z4 = c7 * (2.0 * (w2x * a6)) - s7 * (2.0 * (w2y * a6)) + (w2x * w2x + (w2y * w2y + (v4 - k3)))
    D4 = k4 - Z4 * Z4
    v5 = 2.0 * abs(Z4)
    apart4 = merge_slack2 * (v5 + merge_slack2) < D4
    if not (-(reach_slack2 * (v5 + reach_slack2)) <= D4):
        return  # out of reach
    w4 = math.sqrt(D4 if apart4 else 0.0)
    v6 = k1 * Z4
    v7 = k2 * Z4

    # theta6, type 2: A6 A7 U0^-1 A1 [3, 4]
    v8 = a6 + (c7 * w2x - s7 * w2y)
    N6 = v4 + v8 * v8
    free6 = N6 <= free_limit_squared2
    inverse6 = 1.0 / (1.0 if free6 else N6)

    # theta5, type 3: A6 A7 U0^-1 A1 [2, 4] and A6 A7 U0^-1 A1 [1, 4]
    Z1_5 = c7 * w2y + s7 * w2x

    # theta1, type 2: U1 (A4 A5 A6 A7)^-1 [2, 3]
    v13 = c7 * T11 - s7 * T12
    v15 = c7 * T12 + s7 * T11
    v17 = c7 * T21 - s7 * T22
    v19 = c7 * T22 + s7 * T21

    # theta3, type 3: U1 (A5 A6 A7)^-1 [2, 4] and U1 (A5 A6 A7)^-1 [2, 3]
    v22 = a4 * v19
    v23 = d5 * T23
    v24 = d5 * v17
    v25 = v2 + (c7 * (T21 * a6) - s7 * (T22 * a6))
    v27 = a4 * v15
    v28 = d5 * T13
    v29 = d5 * v13
    v30 = v1 + (c7 * (T11 * a6) - s7 * (T12 * a6))

    # theta2, type 3: U0 (A3 A4 A5 A6 A7)^-1 [3, 2] and U0 (A3 A4 A5 A6 A7)^-1 [3, 1]
    v35 = c7 * T31 - s7 * T32
    v37 = c7 * T32 + s7 * T31

    for i1 in range(2):  # noflip4, flip4
        e1 = 1.0 - 2.0 * i1
        # theta4
        if e1 < 0.0 and not apart4:
            continue  # both signs give the same
        root4 = w4 * e1
        c4 = k5 * (v7 + k1 * root4)
        s4 = k5 * (k2 * root4 - v6)
        q4 = _atan2(s4, c4)

        # theta6
        Z6 = d5 + (d3 * c4 - a3 * s4)
        D6 = N6 - Z6 * Z6
        v9 = 2.0 * abs(Z6)
        apart6 = merge_slack1 * (v9 + merge_slack1) < D6
        if not (-(reach_slack1 * (v9 + reach_slack1)) <= D6):
            continue  # out of reach
        w6 = math.sqrt(D6 if apart6 else 0.0)
        v10 = v8 * Z6
        v11 = w2z * Z6

        # theta5
        X1_5 = a4 - (a3 * c4 + d3 * s4)
        S5 = X1_5 * Z1_5
        v12 = S5 * S5

        # theta1
        v16 = s4 * v15
        v20 = s4 * v19

        # theta2
        v38 = s4 * v37
        v40 = c4 * v37

        for i2 in range(2):  # noflip6, flip6
            e2 = 1.0 - 2.0 * i2
            # theta6
            if e2 < 0.0 and (free6 or not apart6):
                continue  # both signs give the same
            root6 = w6 * e2
            c6 = math.cos(seed[5]) if free6 else inverse6 * (v11 + v8 * root6)
            s6 = math.sin(seed[5]) if free6 else inverse6 * (w2z * root6 - v10)
            q6 = _atan2(s6, c6)

            # theta5
            C5 = root6 * X1_5
            w5 = math.sqrt(v12 + C5 * C5)
            free5 = w5 <= free_limit_squared2
            factor5 = 1.0 / (1.0 if free5 else w5)
            c5 = math.cos(seed[4]) if free5 else C5 * factor5
            s5 = math.sin(seed[4]) if free5 else S5 * factor5
            q5 = _atan2(s5, c5)

            # theta1
            v14 = c6 * v13 + T13 * s6
            X1 = c5 * (s4 * v14) + s5 * v16 + c4 * (s6 * v13 - T13 * c6)
            v18 = c6 * v17 + T23 * s6
            v21 = c5 * (s4 * v18) + s5 * v20 + c4 * (s6 * v17 - T23 * c6)
            w1 = math.sqrt(X1 * X1 + v21 * v21)
            free1 = w1 <= free_limit
            divisor1 = 1.0 if free1 else w1

            # theta3
            v26 = s6 * v24 - c6 * v23 + v25 - (c5 * (a4 * v18) + s5 * v22)
            v31 = c5 * (a4 * v14) + s5 * v27 - (s6 * v29 - c6 * v28 + v30)
            v32 = s5 * v18 - c5 * v19
            v33 = c5 * v15 - s5 * v14

            # theta2
            v36 = c6 * v35 + T33 * s6
            v39 = s6 * v35 - T33 * c6
            c2 = c5 * (s4 * v36) + s5 * v38 + c4 * v39
            v41 = c5 * (c4 * v36) + s5 * v40 - s4 * v39
            v42 = c5 * v37 - s5 * v36

            for i3 in range(2):  # left, right
                e3 = 1.0 - 2.0 * i3
                # theta1
                if e3 < 0.0 and free1:
                    continue  # both signs give the same
                factor1 = e3 / divisor1
                c1 = math.cos(seed[0]) if free1 else -(X1 * factor1)
                s1 = math.sin(seed[0]) if free1 else -(v21 * factor1)
                q1 = _atan2(s1, c1)

                # theta3
                s3 = (c1 * v26 + s1 * v31) / -a3
                v34 = a3 * (c1 * v32 + s1 * v33) / -a3
                q3 = _atan2(s3, -v34)

                # theta2
                s2 = v34 * v41 - s3 * v42
                q2 = _atan2(s2, c2)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0] = q1
                q[row, 1] = q2
                q[row, 2] = q3
                q[row, 3] = q4
                q[row, 4] = q5
                q[row, 5] = q6
                q[row, 6] = q_free[0]
                status[row] = FREE_JOINT if free1 or free5 or free6 else OK


@_jit
def _read(T, q_free):
    """Whether T is a pose, and its upper three rows.

    Where it is only rounded, with the nearest rotation: R becomes (3 I - R R') R / 2, twice
    (Higham 1986).
    """
    x0, x1, x2, px = T[0, 0], T[0, 1], T[0, 2], T[0, 3]
    y0, y1, y2, py = T[1, 0], T[1, 1], T[1, 2], T[1, 3]
    z0, z1, z2, pz = T[2, 0], T[2, 1], T[2, 2], T[2, 3]
    valid = math.isfinite(px) and math.isfinite(py) and math.isfinite(pz) and math.isfinite(q_free[0])
    rest = abs(T[3, 0]) + abs(T[3, 1]) + abs(T[3, 2]) + abs(T[3, 3] - 1.0)
    valid = valid and rest <= 1e-09
    xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0
    yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0
    xy = x0 * y0 + x1 * y1 + x2 * y2
    u, v, w = x1 * y2 - x2 * y1 - z0, x2 * y0 - x0 * y2 - z1, x0 * y1 - x1 * y0 - z2
    miss = xx * xx + yy * yy + 2.0 * xy * xy + u * u + v * v + w * w
    valid = valid and miss <= 1e-09
    if valid and miss > 1e-24:
        for _ in range(2):
            xx = 1.5 - 0.5 * (x0 * x0 + x1 * x1 + x2 * x2)
            yy = 1.5 - 0.5 * (y0 * y0 + y1 * y1 + y2 * y2)
            zz = 1.5 - 0.5 * (z0 * z0 + z1 * z1 + z2 * z2)
            xy = -0.5 * (x0 * y0 + x1 * y1 + x2 * y2)
            xz = -0.5 * (x0 * z0 + x1 * z1 + x2 * z2)
            yz = -0.5 * (y0 * z0 + y1 * z1 + y2 * z2)
            x0, y0, z0 = (
                xx * x0 + xy * y0 + xz * z0,
                xy * x0 + yy * y0 + yz * z0,
                xz * x0 + yz * y0 + zz * z0,
            )
            x1, y1, z1 = (
                xx * x1 + xy * y1 + xz * z1,
                xy * x1 + yy * y1 + yz * z1,
                xz * x1 + yz * y1 + zz * z1,
            )
            x2, y2, z2 = (
                xx * x2 + xy * y2 + xz * z2,
                xy * x2 + yy * y2 + yz * z2,
                xz * x2 + yz * y2 + zz * z2,
            )
    return valid, (x0, x1, x2, px, y0, y1, y2, py, z0, z1, z2, pz)


@_jit
def _turned(joint, given, towards):
    """A joint value moved by whole turns, near to another value but inside its limits."""
    low, high = _LOWEST[joint], _HIGHEST[joint]
    value = given + _TURN * math.floor((towards - given) / _TURN + 0.5)
    if value > high:
        value -= _TURN * math.ceil((value - high) / _TURN)
    if value < low:
        value += _TURN * math.ceil((low - value) / _TURN)
    return value if value <= high else given


@_jit
def _whole(pose, q_free, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(8):
        status[row] = UNREACHABLE
        for i in range(7):
            q[row, i] = math.nan
    _solve(pose, q_free, seed, q, status)
    count = 0
    for row in range(8):
        if status[row] == UNREACHABLE:
            continue
        for i in range(7):
            if not _LOWEST[i] <= q[row, i] <= _HIGHEST[i]:
                q[row, i] = _turned(i, q[row, i], q[row, i])
                if not _LOWEST[i] <= q[row, i] <= _HIGHEST[i]:
                    status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


@_jit
def _regular(pose, q_free, q, status):
    """A pose at which no joint is free and no branches meet into q and status; False for others.

    What can't be reached is NaN by itself: it has the root of a negative number in it.
    """
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    c7 = math.cos(q_free[0])
    s7 = math.sin(q_free[0])

    # theta4, type 2: the squared length of column 4 of A7 U0^-1 A1
    v1 = d7 * T13 - T14
    v2 = d7 * T23 - T24
    v3 = d1 - (T34 - d7 * T33)
    w2x = v1 * T11 + v2 * T21 + v3 * T31
    w2y = v1 * T12 + v2 * T22 + v3 * T32
    w2z = T13 * v1 + T23 * v2 + T33 * v3
    v4 = w2z * w2z
    Z4 = c7 * (2.0 * (a6 * w2x)) - s7 * (2.0 * (a6 * w2y)) + (w2x * w2x + (w2y * w2y + (v4 - k3)))
    D4 = k4 - Z4 * Z4
    v5 = 2.0 * abs(Z4)
    w4 = math.sqrt(D4)
    v6 = k1 * Z4
    v7 = k2 * Z4
    v8 = k1 * w4
    c4_p = k5 * (v7 + v8)
    c4_m = k5 * (v7 - v8)
    v9 = k2 * w4
    s4_p = k5 * (v9 - v6)
    v10 = k5 * (v6 + v9)
    angle1 = _atan2(w4, Z4)
    q4__p = angle1 - turn1
    v11 = turn1 + angle1

    # theta6, type 2: A6 A7 U0^-1 A1 [3, 4]
    v12 = a6 + (c7 * w2x - s7 * w2y)
    Z6_p = d5 + (d3 * c4_p - a3 * s4_p)
    Z6_m = d5 + (d3 * c4_m + a3 * v10)
    N6 = v4 + v12 * v12
    D6_p = N6 - Z6_p * Z6_p
    D6_m = N6 - Z6_m * Z6_m
    free6 = N6 <= free_limit_squared2
    v13 = 2.0 * abs(Z6_p)
    v14 = 2.0 * abs(Z6_m)
    w6_p = math.sqrt(D6_p)
    w6_m = math.sqrt(D6_m)
    v15 = w6_p - w6_p
    v16 = w6_m - w6_m
    inverse6 = 1.0 / N6
    v17 = v12 * Z6_p
    v18 = v12 * Z6_m
    v19 = w2z * Z6_p
    v20 = w2z * Z6_m
    v21 = v12 * w6_p
    v22 = v12 * w6_m
    v23 = v19 + v21
    v24 = v19 - v21
    v25 = v20 + v22
    v26 = v20 - v22
    c6_pp = inverse6 * v23
    c6_pm = inverse6 * v24
    c6_mp = inverse6 * v25
    c6_mm = inverse6 * v26
    v27 = w2z * w6_p
    v28 = w2z * w6_m
    v29 = v27 - v17
    v30 = v17 + v27
    v31 = v28 - v18
    v32 = v18 + v28
    s6_pp = inverse6 * v29
    v33 = inverse6 * v30
    s6_mp = inverse6 * v31
    v34 = inverse6 * v32
    angle1_ = _atan2(v29, v23)
    angle1__ = _atan2(-v30, v24)
    angle1___ = _atan2(v31, v25)
    angle1____ = _atan2(-v32, v26)

    # theta5, type 3: A6 A7 U0^-1 A1 [2, 4] and A6 A7 U0^-1 A1 [1, 4]
    X1_5_p = a4 - (a3 * c4_p + d3 * s4_p)
    X1_5_m = a4 - (a3 * c4_m - d3 * v10)
    Z1_5 = c7 * w2y + s7 * w2x
    S5_p = X1_5_p * Z1_5
    S5_m = X1_5_m * Z1_5
    C5_p = w6_p * X1_5_p
    C5_m = w6_m * X1_5_m
    v35 = S5_p * S5_p + C5_p * C5_p
    v36 = S5_m * S5_m + C5_m * C5_m
    factor5_p = 1.0 / math.sqrt(v35)
    factor5_m = 1.0 / math.sqrt(v36)
    c5_p = C5_p * factor5_p
    c5_m = C5_m * factor5_m
    s5_p = S5_p * factor5_p
    s5_m = S5_m * factor5_m
    angle1_____ = _atan2(S5_p, C5_p)
    angle1______ = _atan2(S5_m, C5_m)
    q5_pmp = math.copysign(half_turn, S5_p) * h1 - angle1_____
    q5_mmp = math.copysign(half_turn, S5_m) * h1 - angle1______

    # theta1, type 2: U1 (A4 A5 A6 A7)^-1 [2, 3]
    v37 = c7 * T11 - s7 * T12
    v38 = c6_pp * v37 + T13 * s6_pp
    v39 = c6_pm * v37 - T13 * v33
    v40 = c6_mp * v37 + T13 * s6_mp
    v41 = c6_mm * v37 - T13 * v34
    v42 = c7 * T12 + s7 * T11
    v43 = s5_p * (s4_p * v42)
    v44 = s5_m * (v10 * v42)
    X1_pp = v43 + c5_p * (s4_p * v38) + c4_p * (s6_pp * v37 - T13 * c6_pp)
    X1_pm = v43 - c5_p * (s4_p * v39) - c4_p * (v33 * v37 + T13 * c6_pm)
    X1_mp = c4_m * (s6_mp * v37 - T13 * c6_mp) - (v44 + c5_m * (v10 * v40))
    X1_mm = c5_m * (v10 * v41) - v44 - c4_m * (v34 * v37 + T13 * c6_mm)
    v45 = c7 * T21 - s7 * T22
    v46 = c6_pp * v45 + T23 * s6_pp
    v47 = c6_pm * v45 - T23 * v33
    v48 = c6_mp * v45 + T23 * s6_mp
    v49 = c6_mm * v45 - T23 * v34
    v50 = c7 * T22 + s7 * T21
    v51 = s5_p * (s4_p * v50)
    v52 = s5_m * (v10 * v50)
    v53 = v51 + c5_p * (s4_p * v46) + c4_p * (s6_pp * v45 - T23 * c6_pp)
    v54 = v51 - c5_p * (s4_p * v47) - c4_p * (v33 * v45 + T23 * c6_pm)
    v55 = c4_m * (s6_mp * v45 - T23 * c6_mp) - (v52 + c5_m * (v10 * v48))
    v56 = c5_m * (v10 * v49) - v52 - c4_m * (v34 * v45 + T23 * c6_mm)
    v57 = X1_pp * X1_pp + v53 * v53
    v58 = X1_pm * X1_pm + v54 * v54
    v59 = X1_mp * X1_mp + v55 * v55
    v60 = X1_mm * X1_mm + v56 * v56
    angle1_______ = _atan2(-v53, -X1_pp)
    angle1________ = _atan2(-v54, -X1_pm)
    angle1_________ = _atan2(-v55, -X1_mp)
    angle1__________ = _atan2(-v56, -X1_mm)
    q1_ppm = angle1_______ - h1 * math.copysign(half_turn, -v53)
    q1_pmm = angle1________ - h1 * math.copysign(half_turn, -v54)
    q1_mpm = angle1_________ - h1 * math.copysign(half_turn, -v55)
    q1_mmm = angle1__________ - h1 * math.copysign(half_turn, -v56)

    # theta3, type 3: U1 (A5 A6 A7)^-1 [2, 4] and U1 (A5 A6 A7)^-1 [2, 3]
    v61 = a4 * v50
    v62 = d5 * T23
    v63 = d5 * v45
    v64 = v2 + (c7 * (a6 * T21) - s7 * (a6 * T22))
    v65 = s5_p * v61
    v66 = s5_m * v61
    v67 = a4 * v42
    v68 = d5 * T13
    v69 = d5 * v37
    v70 = v1 + (c7 * (a6 * T11) - s7 * (a6 * T12))
    v71 = s5_p * v67
    v72 = s5_m * v67
    v73 = c5_p * v50
    v74 = c5_m * v50
    v75 = c5_p * v42
    v76 = c5_m * v42
    v77 = (
        (X1_pp * (v64 + (s6_pp * v63 - c6_pp * v62) - (v65 + c5_p * (a4 * v46))) + v53 * (v71 + c5_p
        * (a4 * v38) - (v70 + (s6_pp * v69 - c6_pp * v68)))) / -a3
    )
    v78 = (
        (X1_pm * (v64 - (v33 * v63 + c6_pm * v62) - (v65 - c5_p * (a4 * v47))) + v54 * (v71 - c5_p *
        (a4 * v39) - (v70 - (v33 * v69 + c6_pm * v68)))) / -a3
    )
    v79 = (
        (X1_mp * (v64 + (s6_mp * v63 - c6_mp * v62) - (v66 + c5_m * (a4 * v48))) + v55 * (v72 + c5_m
        * (a4 * v40) - (v70 + (s6_mp * v69 - c6_mp * v68)))) / -a3
    )
    v80 = (
        (X1_mm * (v64 - (v34 * v63 + c6_mm * v62) - (v66 - c5_m * (a4 * v49))) + v56 * (v72 - c5_m *
        (a4 * v41) - (v70 - (v34 * v69 + c6_mm * v68)))) / -a3
    )
    v81 = a3 * (X1_pp * (s5_p * v46 - v73) + v53 * (v75 - s5_p * v38)) / -a3
    v82 = a3 * (X1_pm * (v73 + s5_p * v47) - v54 * (v75 + s5_p * v39)) / -a3
    v83 = a3 * (X1_mp * (s5_m * v48 - v74) + v55 * (v76 - s5_m * v40)) / -a3
    v84 = a3 * (X1_mm * (v74 + s5_m * v49) - v56 * (v76 + s5_m * v41)) / -a3
    angle1___________ = _atan2(-v77, v81)
    angle1____________ = _atan2(-v78, v82)
    angle1_____________ = _atan2(-v79, v83)
    angle1______________ = _atan2(-v80, v84)
    q3_ppm = angle1___________ - h1 * math.copysign(half_turn, -v77)
    q3_pmm = angle1____________ - h1 * math.copysign(half_turn, -v78)
    q3_mpm = angle1_____________ - h1 * math.copysign(half_turn, -v79)
    q3_mmm = angle1______________ - h1 * math.copysign(half_turn, -v80)

    # theta2, type 3: U0 (A3 A4 A5 A6 A7)^-1 [3, 2] and U0 (A3 A4 A5 A6 A7)^-1 [3, 1]
    v85 = c7 * T31 - s7 * T32
    v86 = c6_pp * v85 + T33 * s6_pp
    v87 = c6_pm * v85 - T33 * v33
    v88 = c6_mp * v85 + T33 * s6_mp
    v89 = c6_mm * v85 - T33 * v34
    v90 = c7 * T32 + s7 * T31
    v91 = s6_pp * v85 - T33 * c6_pp
    v92 = v33 * v85 + T33 * c6_pm
    v93 = s6_mp * v85 - T33 * c6_mp
    v94 = v34 * v85 + T33 * c6_mm
    v95 = s5_p * (s4_p * v90)
    v96 = s5_m * (v10 * v90)
    v97 = s5_p * (c4_p * v90)
    v98 = s5_m * (c4_m * v90)
    v99 = c5_p * v90
    v100 = c5_m * v90
    angle1_______________ = (
        _atan2(1.0 / math.sqrt(v57) * (v77 * (v99 - s5_p * v86) - v81 * (v97 + c5_p * (c4_p * v86) -
        s4_p * v91)), v95 + c5_p * (s4_p * v86) + c4_p * v91)
    )
    angle1________________ = (
        _atan2(-(1.0 / math.sqrt(v58) * (v78 * (v99 + s5_p * v87) + v82 * (v97 - c5_p * (c4_p * v87)
        + s4_p * v92))), v95 - c5_p * (s4_p * v87) - c4_p * v92)
    )
    angle1_________________ = (
        _atan2(1.0 / math.sqrt(v59) * (v79 * (v100 - s5_m * v88) - v83 * (v98 + c5_m * (c4_m * v88)
        + v10 * v93)), c4_m * v93 - (v96 + c5_m * (v10 * v88)))
    )
    angle1__________________ = (
        _atan2(-(1.0 / math.sqrt(v60) * (v80 * (v100 + s5_m * v89) + v84 * (v98 - c5_m * (c4_m *
        v89) - v10 * v94))), c5_m * (v10 * v89) - v96 - c4_m * v94)
    )

    # joint values
    v101 = q4__p + (m4 if q4__p <= -half_turn else 0.0)
    v102 = (m4 if -v11 <= -half_turn else 0.0) - v11
    v103 = v101 < low4 or high4 < v101
    v104 = v102 < low4 or high4 < v102
    v105 = angle1_____ < low5 or high5 < angle1_____
    v106 = q5_pmp < low5 or high5 < q5_pmp
    v107 = angle1______ < low5 or high5 < angle1______
    v108 = q5_mmp < low5 or high5 < q5_mmp
    v109 = angle1_ + (whole_turn if angle1_ < low6 else 0.0)
    v110 = angle1__ + (whole_turn if angle1__ < low6 else 0.0)
    v111 = angle1___ + (whole_turn if angle1___ < low6 else 0.0)
    v112 = angle1____ + (whole_turn if angle1____ < low6 else 0.0)
    v113 = v109 < low6 or high6 < v109
    v114 = v110 < low6 or high6 < v110
    v115 = v111 < low6 or high6 < v111
    v116 = v112 < low6 or high6 < v112
    q6_ppp = angle1_ if v113 else v109
    q6_pmp = angle1__ if v114 else v110
    q6_mpp = angle1___ if v115 else v111
    q6_mmp = angle1____ if v116 else v112
    v117 = q_free[0] < low7 or high7 < q_free[0]
    q4_ppp = v15 + v101
    q4_mpp = v16 + v102
    v118 = q_free[0] + (w4 - w4)
    q7_ppp = v15 + v118
    q7_mpp = v16 + v118
    outside_ppp = (
        v117 or (v113 or (v105 or (v103 or (angle1___________ < low3 or high3 < angle1___________ or
        (angle1_______ < low1 or high1 < angle1_______ or (angle1_______________ < low2 or high2 <
        angle1_______________))))))
    )
    outside_ppm = (
        v117 or (v113 or (v105 or (v103 or (q3_ppm < low3 or high3 < q3_ppm or (q1_ppm < low1 or
        high1 < q1_ppm or (-angle1_______________ < low2 or high2 < -angle1_______________))))))
    )
    outside_pmp = (
        v117 or (v114 or (v106 or (v103 or (angle1____________ < low3 or high3 < angle1____________
        or (angle1________ < low1 or high1 < angle1________ or (angle1________________ < low2 or
        high2 < angle1________________))))))
    )
    outside_pmm = (
        v117 or (v114 or (v106 or (v103 or (q3_pmm < low3 or high3 < q3_pmm or (q1_pmm < low1 or
        high1 < q1_pmm or (-angle1________________ < low2 or high2 < -angle1________________))))))
    )
    outside_mpp = (
        v117 or (v115 or (v107 or (v104 or (angle1_____________ < low3 or high3 <
        angle1_____________ or (angle1_________ < low1 or high1 < angle1_________ or
        (angle1_________________ < low2 or high2 < angle1_________________))))))
    )
    outside_mpm = (
        v117 or (v115 or (v107 or (v104 or (q3_mpm < low3 or high3 < q3_mpm or (q1_mpm < low1 or
        high1 < q1_mpm or (-angle1_________________ < low2 or high2 < -angle1_________________))))))
    )
    outside_mmp = (
        v117 or (v116 or (v108 or (v104 or (angle1______________ < low3 or high3 <
        angle1______________ or (angle1__________ < low1 or high1 < angle1__________ or
        (angle1__________________ < low2 or high2 < angle1__________________))))))
    )
    outside_mmm = (
        v117 or (v116 or (v108 or (v104 or (q3_mmm < low3 or high3 < q3_mmm or (q1_mmm < low1 or
        high1 < q1_mmm or (-angle1__________________ < low2 or high2 <
        -angle1__________________))))))
    )
    doubt = (
        v60 <= m3 or (v59 <= m3 or (v58 <= m3 or (v57 <= m3 or (-(reach_slack1 * (reach_slack1 +
        v14)) <= D6_m and (free6 or not (merge_slack1 * (merge_slack1 + v14) < D6_m)) or v36 <= m1
        or (free6 or -(reach_slack2 * (reach_slack2 + v5)) <= D4 and not (merge_slack2 *
        (merge_slack2 + v5) < D4) or (-(reach_slack1 * (reach_slack1 + v13)) <= D6_p and (free6 or
        not (merge_slack1 * (merge_slack1 + v13) < D6_p)) or v35 <= m1))))))
    )
    # a joint is free, or branches meet
    if doubt:
        return False
    q[0, 0] = angle1_______
    q[0, 1] = angle1_______________
    q[0, 2] = angle1___________
    q[0, 3] = q4_ppp
    q[0, 4] = angle1_____
    q[0, 5] = q6_ppp
    q[0, 6] = q7_ppp
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else (OUT_OF_LIMITS if outside_ppp else OK)
    q[1, 0] = q1_ppm
    q[1, 1] = -angle1_______________
    q[1, 2] = q3_ppm
    q[1, 3] = q4_ppp
    q[1, 4] = angle1_____
    q[1, 5] = q6_ppp
    q[1, 6] = q7_ppp
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else (OUT_OF_LIMITS if outside_ppm else OK)
    q[2, 0] = angle1________
    q[2, 1] = angle1________________
    q[2, 2] = angle1____________
    q[2, 3] = q4_ppp
    q[2, 4] = q5_pmp
    q[2, 5] = q6_pmp
    q[2, 6] = q7_ppp
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else (OUT_OF_LIMITS if outside_pmp else OK)
    q[3, 0] = q1_pmm
    q[3, 1] = -angle1________________
    q[3, 2] = q3_pmm
    q[3, 3] = q4_ppp
    q[3, 4] = q5_pmp
    q[3, 5] = q6_pmp
    q[3, 6] = q7_ppp
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else (OUT_OF_LIMITS if outside_pmm else OK)
    q[4, 0] = angle1_________
    q[4, 1] = angle1_________________
    q[4, 2] = angle1_____________
    q[4, 3] = q4_mpp
    q[4, 4] = angle1______
    q[4, 5] = q6_mpp
    q[4, 6] = q7_mpp
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else (OUT_OF_LIMITS if outside_mpp else OK)
    q[5, 0] = q1_mpm
    q[5, 1] = -angle1_________________
    q[5, 2] = q3_mpm
    q[5, 3] = q4_mpp
    q[5, 4] = angle1______
    q[5, 5] = q6_mpp
    q[5, 6] = q7_mpp
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else (OUT_OF_LIMITS if outside_mpm else OK)
    q[6, 0] = angle1__________
    q[6, 1] = angle1__________________
    q[6, 2] = angle1______________
    q[6, 3] = q4_mpp
    q[6, 4] = q5_mmp
    q[6, 5] = q6_mmp
    q[6, 6] = q7_mpp
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else (OUT_OF_LIMITS if outside_mmp else OK)
    q[7, 0] = q1_mmm
    q[7, 1] = -angle1__________________
    q[7, 2] = q3_mmm
    q[7, 3] = q4_mpp
    q[7, 4] = q5_mmp
    q[7, 5] = q6_mmp
    q[7, 6] = q7_mpp
    status[7] = UNREACHABLE if q[7, 0] != q[7, 0] else (OUT_OF_LIMITS if outside_mmm else OK)
    return True


@_jit
def ik_into(T, q_free, q, status, q_seed=None):
    """All solutions into the caller's arrays, for control loops and for other numba functions.

    Memory is allocated nowhere. numba compiles
    once more for arrays of another type or layout.

    Args:
        T: Pose (4, 4), float64.
        q_free: Values of the joints 7 (1,), float64.
        q: Filled with joint values (8, 7), NaN where there is no solution; float64.
        status: Filled with what each row holds (8,); uint8.
        q_seed: Values for joints that are indeterminate (7,), float64; zeros without it.

    Returns:
        How many rows are OK or FREE_JOINT.

    Raises:
        ValueError: An array has another shape, or the seed is not finite.
    """
    if T.shape != (4, 4) or q.shape != (8, 7) or status.shape != (8,):
        raise ValueError("T, q and status must be (4, 4), (8, 7) and (8,)")
    if q_free.shape != (1,):
        raise ValueError("q_free must be (1,)")
    seed = _ZEROS if q_seed is None else q_seed
    if seed.shape != (7,):
        raise ValueError("q_seed must be (7,)")
    for value in seed:
        if not math.isfinite(value):
            raise ValueError("q_seed must be finite")
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


def ik_all(T, q_free, q_seed=None):
    """All solutions: q (8, 7) and status (8,).

    Row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_free: Values of the joints 7 (1,).
        q_seed: Values for joints that are indeterminate at this pose (7,); zeros without it.

    Raises:
        ValueError: An argument has another shape, or the seed is not finite.
    """
    q, status = np.empty((8, 7)), np.empty(8, _BYTE)
    T = _array(T, (4, 4), "T")
    q_free = _array(q_free, (1,), "q_free")
    seed = _ZEROS if q_seed is None else _array(q_seed, (7,), "q_seed")
    ik_into(T, q_free, q, status, seed)
    return q, status


@_jit
def _near(joint, value, towards, limits):
    """A joint value moved by whole turns near to another, if limits count inside its own."""
    if limits:
        return _turned(joint, value, towards)
    return value + _TURN * math.floor((towards - value) / _TURN + 0.5)


@_jit
def _nearest(rows, status, seed, limits, q):
    """The solution nearest to the seed into q; whether there is one."""
    nearest, least = -1, math.inf
    for row in range(len(rows)):
        if status[row] == UNREACHABLE or (limits and status[row] == OUT_OF_LIMITS):
            continue
        distance = 0.0
        for i in range(7):
            rows[row, i] = _near(i, rows[row, i], seed[i], limits)
            moved = rows[row, i] - seed[i]
            distance += _WEIGHT[i] * moved * moved
        if distance < least:
            nearest, least = row, distance
    for i in range(7):
        q[i] = rows[nearest, i]
    return nearest >= 0


def ik(T, q_free, q_seed=None, *, branch=None, limits=True):
    """One solution (7,): the nearest to the seed.

    Angles are moved by whole turns inside their limits.

    Args:
        T: Pose (4, 4).
        q_free: Values of the joints 7 (1,).
        q_seed: Where the arm is (7,); zeros without it.
        branch: Only this branch: a name out of BRANCHES, or its row.
        limits: Whether joint limits count.

    Raises:
        Unreachable: There is no such solution; the text says why.
        ValueError: T is no pose, or there is no such branch.
    """
    first, last = (0, 8) if branch is None else _span(branch)
    rows, status = ik_all(T, q_free, q_seed)
    if status[0] == INVALID_POSE:
        raise ValueError("T is no pose: not finite, or not a right-handed rotation, or the value of a free joint not finite")
    rows, status, q = rows[first:last], status[first:last], np.empty(7)
    seed = _ZEROS if q_seed is None else _array(q_seed, (7,), "q_seed")
    if _nearest(rows, status, seed, limits, q):
        return q
    where = "" if branch is None else f" in branch {BRANCHES[first]}"
    beyond = OUT_OF_LIMITS in status
    why = "every solution is beyond the joint limits" if beyond else "the pose is out of reach"
    raise Unreachable(why + where)


@njit(nogil=True, **_OPTIONS)
def _one_by_one(T, q_free, q, status):
    seed = np.empty(7)
    seed[:] = 0.0
    for k in range(len(T)):
        ik_into(T[k], q_free[k], q[k], status[k], seed)


# Where in a tile the rows' values and statuses begin.
_PLACES = np.array([
    [7840, 7872, 7904, 7936, 7968, 8000, 8032],
    [8064, 8096, 8128, 7936, 7968, 8000, 8032],
    [8160, 8192, 8224, 7936, 8256, 8288, 8032],
    [8320, 8352, 8384, 7936, 8256, 8288, 8032],
    [8416, 8448, 8480, 8512, 8544, 8576, 8608],
    [8640, 8672, 8704, 8512, 8544, 8576, 8608],
    [8736, 8768, 8800, 8512, 8832, 8864, 8608],
    [8896, 8928, 8960, 8512, 8832, 8864, 8608],
])
_KINDS = np.array([8992, 9024, 9056, 9088, 9120, 9152, 9184, 9216])
_LEFT_OVER = 255


@njit(nogil=True, **_OPTIONS)
def _in_tiles(T, q_free, q, status):
    """32 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; the status of a pose that it does not answer is _LEFT_OVER.
    """
    work = np.empty(9248)
    work[:] = 0.0  # the last tile may be half full
    for first in range(0, len(T), 32):
        count = min(32, len(T) - first)
        for k in range(count):
            for i in range(4):
                for j in range(4):
                    work[(4 * i + j) * 32 + k] = T[first + k, i, j]
            for i in range(1):
                work[(16 + i) * 32 + k] = q_free[first + k, i]
        for k in range(32):
            x0, x1, x2 = work[0 + k], work[32 + k], work[64 + k]
            y0, y1, y2 = work[128 + k], work[160 + k], work[192 + k]
            z0, z1, z2 = work[256 + k], work[288 + k], work[320 + k]
            xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0
            yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0
            xy = x0 * y0 + x1 * y1 + x2 * y2
            u, v, w = x1 * y2 - x2 * y1 - z0, x2 * y0 - x0 * y2 - z1, x0 * y1 - x1 * y0 - z2
            rest = abs(work[384 + k]) + abs(work[416 + k]) + abs(work[448 + k])
            miss = (
                xx * xx + yy * yy + 2.0 * xy * xy + u * u + v * v + w * w + rest + abs(work[480 + k]
                - 1.0) + 0.0 * (work[96 + k] + work[224 + k] + work[352 + k] + work[512 + k])
            )
            exact = miss <= 1e-24
            work[544 + k] = 0.0 if exact else 1.0
        for k in range(0, 32):
            T11 = work[0 + k]
            T12 = work[32 + k]
            T13 = work[64 + k]
            T14 = work[96 + k]
            T21 = work[128 + k]
            T22 = work[160 + k]
            T23 = work[192 + k]
            T24 = work[224 + k]
            T31 = work[256 + k]
            T32 = work[288 + k]
            T33 = work[320 + k]
            T34 = work[352 + k]
            given1 = work[512 + k]
            v1 = d7 * T13 - T14
            v2 = d7 * T23 - T24
            v3 = d1 - (T34 - d7 * T33)
            w2x = v1 * T11 + v2 * T21 + v3 * T31
            w2y = v1 * T12 + v2 * T22 + v3 * T32
            w2z = T13 * v1 + T23 * v2 + T33 * v3
            v4 = w2z * w2z
            v62 = d5 * T23
            v68 = d5 * T13
            v117 = given1 < low7 or high7 < given1
            work[608 + k] = v1
            work[672 + k] = v2
            work[704 + k] = w2x
            work[736 + k] = w2y
            work[576 + k] = w2z
            work[768 + k] = v4
            work[800 + k] = v62
            work[832 + k] = v68
            work[864 + k] = v117
            work[896 + k] = given1
            work[928 + k] = given1
        for k in range(896, 928):
            work[k] = math.sin(work[k])
        for k in range(928, 960):
            work[k] = math.cos(work[k])
        for k in range(0, 32):
            T11 = work[0 + k]
            T12 = work[32 + k]
            T13 = work[64 + k]
            T21 = work[128 + k]
            T22 = work[160 + k]
            T23 = work[192 + k]
            T31 = work[256 + k]
            T32 = work[288 + k]
            T33 = work[320 + k]
            given1 = work[512 + k]
            w2z = work[576 + k]
            v1 = work[608 + k]
            v2 = work[672 + k]
            w2x = work[704 + k]
            w2y = work[736 + k]
            v4 = work[768 + k]
            v62 = work[800 + k]
            v68 = work[832 + k]
            s7 = work[896 + k]
            c7 = work[928 + k]
            Z4 = (
                c7 * (2.0 * (a6 * w2x)) - s7 * (2.0 * (a6 * w2y)) + (w2x * w2x + (w2y * w2y + (v4 -
                k3)))
            )
            D4 = k4 - Z4 * Z4
            v5 = 2.0 * abs(Z4)
            w4 = math.sqrt(D4)
            v6 = k1 * Z4
            v7 = k2 * Z4
            v8 = k1 * w4
            c4_p = k5 * (v7 + v8)
            c4_m = k5 * (v7 - v8)
            v9 = k2 * w4
            s4_p = k5 * (v9 - v6)
            v10 = k5 * (v6 + v9)
            v12 = a6 + (c7 * w2x - s7 * w2y)
            Z6_p = d5 + (d3 * c4_p - a3 * s4_p)
            Z6_m = d5 + (d3 * c4_m + a3 * v10)
            N6 = v4 + v12 * v12
            D6_p = N6 - Z6_p * Z6_p
            D6_m = N6 - Z6_m * Z6_m
            free6 = N6 <= free_limit_squared2
            v13 = 2.0 * abs(Z6_p)
            v14 = 2.0 * abs(Z6_m)
            w6_p = math.sqrt(D6_p)
            w6_m = math.sqrt(D6_m)
            v15 = w6_p - w6_p
            v16 = w6_m - w6_m
            inverse6 = 1.0 / N6
            v17 = v12 * Z6_p
            v18 = v12 * Z6_m
            v19 = w2z * Z6_p
            v20 = w2z * Z6_m
            v21 = v12 * w6_p
            v22 = v12 * w6_m
            v23 = v19 + v21
            v24 = v19 - v21
            v25 = v20 + v22
            v26 = v20 - v22
            c6_pp = inverse6 * v23
            c6_pm = inverse6 * v24
            c6_mp = inverse6 * v25
            c6_mm = inverse6 * v26
            v27 = w2z * w6_p
            v28 = w2z * w6_m
            v29 = v27 - v17
            v30 = v17 + v27
            v31 = v28 - v18
            v32 = v18 + v28
            s6_pp = inverse6 * v29
            v33 = inverse6 * v30
            s6_mp = inverse6 * v31
            v34 = inverse6 * v32
            X1_5_p = a4 - (a3 * c4_p + d3 * s4_p)
            X1_5_m = a4 - (a3 * c4_m - d3 * v10)
            Z1_5 = c7 * w2y + s7 * w2x
            S5_p = X1_5_p * Z1_5
            S5_m = X1_5_m * Z1_5
            C5_p = w6_p * X1_5_p
            C5_m = w6_m * X1_5_m
            v35 = S5_p * S5_p + C5_p * C5_p
            v36 = S5_m * S5_m + C5_m * C5_m
            factor5_p = 1.0 / math.sqrt(v35)
            factor5_m = 1.0 / math.sqrt(v36)
            c5_p = C5_p * factor5_p
            c5_m = C5_m * factor5_m
            s5_p = S5_p * factor5_p
            s5_m = S5_m * factor5_m
            v37 = c7 * T11 - s7 * T12
            v38 = c6_pp * v37 + T13 * s6_pp
            v39 = c6_pm * v37 - T13 * v33
            v40 = c6_mp * v37 + T13 * s6_mp
            v41 = c6_mm * v37 - T13 * v34
            v42 = c7 * T12 + s7 * T11
            v43 = s5_p * (s4_p * v42)
            v44 = s5_m * (v10 * v42)
            X1_pp = v43 + c5_p * (s4_p * v38) + c4_p * (s6_pp * v37 - T13 * c6_pp)
            X1_pm = v43 - c5_p * (s4_p * v39) - c4_p * (v33 * v37 + T13 * c6_pm)
            X1_mp = c4_m * (s6_mp * v37 - T13 * c6_mp) - (v44 + c5_m * (v10 * v40))
            X1_mm = c5_m * (v10 * v41) - v44 - c4_m * (v34 * v37 + T13 * c6_mm)
            v45 = c7 * T21 - s7 * T22
            v46 = c6_pp * v45 + T23 * s6_pp
            v47 = c6_pm * v45 - T23 * v33
            v48 = c6_mp * v45 + T23 * s6_mp
            v49 = c6_mm * v45 - T23 * v34
            v50 = c7 * T22 + s7 * T21
            v51 = s5_p * (s4_p * v50)
            v52 = s5_m * (v10 * v50)
            v53 = v51 + c5_p * (s4_p * v46) + c4_p * (s6_pp * v45 - T23 * c6_pp)
            v54 = v51 - c5_p * (s4_p * v47) - c4_p * (v33 * v45 + T23 * c6_pm)
            v55 = c4_m * (s6_mp * v45 - T23 * c6_mp) - (v52 + c5_m * (v10 * v48))
            v56 = c5_m * (v10 * v49) - v52 - c4_m * (v34 * v45 + T23 * c6_mm)
            v57 = X1_pp * X1_pp + v53 * v53
            v58 = X1_pm * X1_pm + v54 * v54
            v59 = X1_mp * X1_mp + v55 * v55
            v60 = X1_mm * X1_mm + v56 * v56
            v61 = a4 * v50
            v63 = d5 * v45
            v64 = v2 + (c7 * (a6 * T21) - s7 * (a6 * T22))
            v65 = s5_p * v61
            v66 = s5_m * v61
            v67 = a4 * v42
            v69 = d5 * v37
            v70 = v1 + (c7 * (a6 * T11) - s7 * (a6 * T12))
            v71 = s5_p * v67
            v72 = s5_m * v67
            v73 = c5_p * v50
            v74 = c5_m * v50
            v75 = c5_p * v42
            v76 = c5_m * v42
            v77 = (
                (X1_pp * (v64 + (s6_pp * v63 - c6_pp * v62) - (v65 + c5_p * (a4 * v46))) + v53 *
                (v71 + c5_p * (a4 * v38) - (v70 + (s6_pp * v69 - c6_pp * v68)))) / -a3
            )
            v78 = (
                (X1_pm * (v64 - (v33 * v63 + c6_pm * v62) - (v65 - c5_p * (a4 * v47))) + v54 * (v71
                - c5_p * (a4 * v39) - (v70 - (v33 * v69 + c6_pm * v68)))) / -a3
            )
            v79 = (
                (X1_mp * (v64 + (s6_mp * v63 - c6_mp * v62) - (v66 + c5_m * (a4 * v48))) + v55 *
                (v72 + c5_m * (a4 * v40) - (v70 + (s6_mp * v69 - c6_mp * v68)))) / -a3
            )
            v80 = (
                (X1_mm * (v64 - (v34 * v63 + c6_mm * v62) - (v66 - c5_m * (a4 * v49))) + v56 * (v72
                - c5_m * (a4 * v41) - (v70 - (v34 * v69 + c6_mm * v68)))) / -a3
            )
            v81 = a3 * (X1_pp * (s5_p * v46 - v73) + v53 * (v75 - s5_p * v38)) / -a3
            v82 = a3 * (X1_pm * (v73 + s5_p * v47) - v54 * (v75 + s5_p * v39)) / -a3
            v83 = a3 * (X1_mp * (s5_m * v48 - v74) + v55 * (v76 - s5_m * v40)) / -a3
            v84 = a3 * (X1_mm * (v74 + s5_m * v49) - v56 * (v76 + s5_m * v41)) / -a3
            v85 = c7 * T31 - s7 * T32
            v86 = c6_pp * v85 + T33 * s6_pp
            v87 = c6_pm * v85 - T33 * v33
            v88 = c6_mp * v85 + T33 * s6_mp
            v89 = c6_mm * v85 - T33 * v34
            v90 = c7 * T32 + s7 * T31
            v91 = s6_pp * v85 - T33 * c6_pp
            v92 = v33 * v85 + T33 * c6_pm
            v93 = s6_mp * v85 - T33 * c6_mp
            v94 = v34 * v85 + T33 * c6_mm
            v95 = s5_p * (s4_p * v90)
            v96 = s5_m * (v10 * v90)
            v97 = s5_p * (c4_p * v90)
            v98 = s5_m * (c4_m * v90)
            v99 = c5_p * v90
            v100 = c5_m * v90
            v118 = given1 + (w4 - w4)
            q7_ppp = v15 + v118
            q7_mpp = v16 + v118
            doubt = (
                v60 <= m3 or (v59 <= m3 or (v58 <= m3 or (v57 <= m3 or (-(reach_slack1 *
                (reach_slack1 + v14)) <= D6_m and (free6 or not (merge_slack1 * (merge_slack1 + v14)
                < D6_m)) or v36 <= m1 or (free6 or -(reach_slack2 * (reach_slack2 + v5)) <= D4 and
                not (merge_slack2 * (merge_slack2 + v5) < D4) or (-(reach_slack1 * (reach_slack1 +
                v13)) <= D6_p and (free6 or not (merge_slack1 * (merge_slack1 + v13) < D6_p)) or v35
                <= m1))))))
            )
            work[3264 + k] = v15
            work[2304 + k] = v16
            work[4736 + k] = S5_p
            work[3488 + k] = S5_m
            work[2176 + k] = v53
            work[2016 + k] = v54
            work[3328 + k] = v55
            work[2944 + k] = v56
            work[4480 + k] = v77
            work[3712 + k] = v78
            work[4096 + k] = v79
            work[5152 + k] = v80
            work[5184 + k] = q7_ppp
            work[5216 + k] = q7_mpp
            work[5248 + k] = doubt
            work[5280 + k] = w4
            work[5312 + k] = v29
            work[5344 + k] = -v30
            work[5376 + k] = v31
            work[5408 + k] = -v32
            work[5440 + k] = S5_p
            work[5472 + k] = S5_m
            work[5504 + k] = -v53
            work[5536 + k] = -v54
            work[5568 + k] = -v55
            work[5600 + k] = -v56
            work[5632 + k] = -v77
            work[5664 + k] = -v78
            work[5696 + k] = -v79
            work[5728 + k] = -v80
            work[5760 + k] = (
                1.0 / math.sqrt(v57) * (v77 * (v99 - s5_p * v86) - v81 * (v97 + c5_p * (c4_p * v86)
                - s4_p * v91))
            )
            work[5792 + k] = (
                -(1.0 / math.sqrt(v58) * (v78 * (v99 + s5_p * v87) + v82 * (v97 - c5_p * (c4_p *
                v87) + s4_p * v92)))
            )
            work[5824 + k] = (
                1.0 / math.sqrt(v59) * (v79 * (v100 - s5_m * v88) - v83 * (v98 + c5_m * (c4_m * v88)
                + v10 * v93))
            )
            work[5856 + k] = (
                -(1.0 / math.sqrt(v60) * (v80 * (v100 + s5_m * v89) + v84 * (v98 - c5_m * (c4_m *
                v89) - v10 * v94)))
            )
            work[5888 + k] = Z4
            work[5920 + k] = v23
            work[5952 + k] = v24
            work[5984 + k] = v25
            work[6016 + k] = v26
            work[6048 + k] = C5_p
            work[6080 + k] = C5_m
            work[6112 + k] = -X1_pp
            work[6144 + k] = -X1_pm
            work[6176 + k] = -X1_mp
            work[6208 + k] = -X1_mm
            work[6240 + k] = v81
            work[6272 + k] = v82
            work[6304 + k] = v83
            work[6336 + k] = v84
            work[6368 + k] = v95 + c5_p * (s4_p * v86) + c4_p * v91
            work[6400 + k] = v95 - c5_p * (s4_p * v87) - c4_p * v92
            work[6432 + k] = c4_m * v93 - (v96 + c5_m * (v10 * v88))
            work[6464 + k] = c5_m * (v10 * v89) - v96 - c4_m * v94
        for k in range(5280, 5888):
            work[k] = _atan2(work[k], work[k + 608])
        for k in range(0, 32):
            v117 = work[864 + k] != 0.0
            v54 = work[2016 + k]
            v53 = work[2176 + k]
            v16 = work[2304 + k]
            v56 = work[2944 + k]
            v15 = work[3264 + k]
            v55 = work[3328 + k]
            S5_m = work[3488 + k]
            v78 = work[3712 + k]
            v79 = work[4096 + k]
            v77 = work[4480 + k]
            S5_p = work[4736 + k]
            v80 = work[5152 + k]
            q7_ppp = work[5184 + k]
            q7_mpp = work[5216 + k]
            doubt = work[5248 + k] != 0.0
            angle1 = work[5280 + k]
            angle1_ = work[5312 + k]
            angle1__ = work[5344 + k]
            angle1___ = work[5376 + k]
            angle1____ = work[5408 + k]
            angle1_____ = work[5440 + k]
            angle1______ = work[5472 + k]
            angle1_______ = work[5504 + k]
            angle1________ = work[5536 + k]
            angle1_________ = work[5568 + k]
            angle1__________ = work[5600 + k]
            angle1___________ = work[5632 + k]
            angle1____________ = work[5664 + k]
            angle1_____________ = work[5696 + k]
            angle1______________ = work[5728 + k]
            angle1_______________ = work[5760 + k]
            angle1________________ = work[5792 + k]
            angle1_________________ = work[5824 + k]
            angle1__________________ = work[5856 + k]
            q4__p = angle1 - turn1
            v11 = turn1 + angle1
            q5_pmp = math.copysign(half_turn, S5_p) * h1 - angle1_____
            q5_mmp = math.copysign(half_turn, S5_m) * h1 - angle1______
            q1_ppm = angle1_______ - h1 * math.copysign(half_turn, -v53)
            q1_pmm = angle1________ - h1 * math.copysign(half_turn, -v54)
            q1_mpm = angle1_________ - h1 * math.copysign(half_turn, -v55)
            q1_mmm = angle1__________ - h1 * math.copysign(half_turn, -v56)
            q3_ppm = angle1___________ - h1 * math.copysign(half_turn, -v77)
            q3_pmm = angle1____________ - h1 * math.copysign(half_turn, -v78)
            q3_mpm = angle1_____________ - h1 * math.copysign(half_turn, -v79)
            q3_mmm = angle1______________ - h1 * math.copysign(half_turn, -v80)
            v101 = q4__p + (m4 if q4__p <= -half_turn else 0.0)
            v102 = (m4 if -v11 <= -half_turn else 0.0) - v11
            v103 = v101 < low4 or high4 < v101
            v104 = v102 < low4 or high4 < v102
            v105 = angle1_____ < low5 or high5 < angle1_____
            v106 = q5_pmp < low5 or high5 < q5_pmp
            v107 = angle1______ < low5 or high5 < angle1______
            v108 = q5_mmp < low5 or high5 < q5_mmp
            v109 = angle1_ + (whole_turn if angle1_ < low6 else 0.0)
            v110 = angle1__ + (whole_turn if angle1__ < low6 else 0.0)
            v111 = angle1___ + (whole_turn if angle1___ < low6 else 0.0)
            v112 = angle1____ + (whole_turn if angle1____ < low6 else 0.0)
            v113 = v109 < low6 or high6 < v109
            v114 = v110 < low6 or high6 < v110
            v115 = v111 < low6 or high6 < v111
            v116 = v112 < low6 or high6 < v112
            q6_ppp = angle1_ if v113 else v109
            q6_pmp = angle1__ if v114 else v110
            q6_mpp = angle1___ if v115 else v111
            q6_mmp = angle1____ if v116 else v112
            q4_ppp = v15 + v101
            q4_mpp = v16 + v102
            outside_ppp = (
                v117 or (v113 or (v105 or (v103 or (angle1___________ < low3 or high3 <
                angle1___________ or (angle1_______ < low1 or high1 < angle1_______ or
                (angle1_______________ < low2 or high2 < angle1_______________))))))
            )
            outside_ppm = (
                v117 or (v113 or (v105 or (v103 or (q3_ppm < low3 or high3 < q3_ppm or (q1_ppm <
                low1 or high1 < q1_ppm or (-angle1_______________ < low2 or high2 <
                -angle1_______________))))))
            )
            outside_pmp = (
                v117 or (v114 or (v106 or (v103 or (angle1____________ < low3 or high3 <
                angle1____________ or (angle1________ < low1 or high1 < angle1________ or
                (angle1________________ < low2 or high2 < angle1________________))))))
            )
            outside_pmm = (
                v117 or (v114 or (v106 or (v103 or (q3_pmm < low3 or high3 < q3_pmm or (q1_pmm <
                low1 or high1 < q1_pmm or (-angle1________________ < low2 or high2 <
                -angle1________________))))))
            )
            outside_mpp = (
                v117 or (v115 or (v107 or (v104 or (angle1_____________ < low3 or high3 <
                angle1_____________ or (angle1_________ < low1 or high1 < angle1_________ or
                (angle1_________________ < low2 or high2 < angle1_________________))))))
            )
            outside_mpm = (
                v117 or (v115 or (v107 or (v104 or (q3_mpm < low3 or high3 < q3_mpm or (q1_mpm <
                low1 or high1 < q1_mpm or (-angle1_________________ < low2 or high2 <
                -angle1_________________))))))
            )
            outside_mmp = (
                v117 or (v116 or (v108 or (v104 or (angle1______________ < low3 or high3 <
                angle1______________ or (angle1__________ < low1 or high1 < angle1__________ or
                (angle1__________________ < low2 or high2 < angle1__________________))))))
            )
            outside_mmm = (
                v117 or (v116 or (v108 or (v104 or (q3_mmm < low3 or high3 < q3_mmm or (q1_mmm <
                low1 or high1 < q1_mmm or (-angle1__________________ < low2 or high2 <
                -angle1__________________))))))
            )
            _7840 = angle1_______
            work[7840 + k] = _7840
            _7872 = angle1_______________
            work[7872 + k] = _7872
            _7904 = angle1___________
            work[7904 + k] = _7904
            _7936 = q4_ppp
            work[7936 + k] = _7936
            _7968 = angle1_____
            work[7968 + k] = _7968
            _8000 = q6_ppp
            work[8000 + k] = _8000
            _8032 = q7_ppp
            work[8032 + k] = _8032
            _8064 = q1_ppm
            work[8064 + k] = _8064
            _8096 = -angle1_______________
            work[8096 + k] = _8096
            _8128 = q3_ppm
            work[8128 + k] = _8128
            _8160 = angle1________
            work[8160 + k] = _8160
            _8192 = angle1________________
            work[8192 + k] = _8192
            _8224 = angle1____________
            work[8224 + k] = _8224
            _8256 = q5_pmp
            work[8256 + k] = _8256
            _8288 = q6_pmp
            work[8288 + k] = _8288
            _8320 = q1_pmm
            work[8320 + k] = _8320
            _8352 = -angle1________________
            work[8352 + k] = _8352
            _8384 = q3_pmm
            work[8384 + k] = _8384
            _8416 = angle1_________
            work[8416 + k] = _8416
            _8448 = angle1_________________
            work[8448 + k] = _8448
            _8480 = angle1_____________
            work[8480 + k] = _8480
            _8512 = q4_mpp
            work[8512 + k] = _8512
            _8544 = angle1______
            work[8544 + k] = _8544
            _8576 = q6_mpp
            work[8576 + k] = _8576
            _8608 = q7_mpp
            work[8608 + k] = _8608
            _8640 = q1_mpm
            work[8640 + k] = _8640
            _8672 = -angle1_________________
            work[8672 + k] = _8672
            _8704 = q3_mpm
            work[8704 + k] = _8704
            _8736 = angle1__________
            work[8736 + k] = _8736
            _8768 = angle1__________________
            work[8768 + k] = _8768
            _8800 = angle1______________
            work[8800 + k] = _8800
            _8832 = q5_mmp
            work[8832 + k] = _8832
            _8864 = q6_mmp
            work[8864 + k] = _8864
            _8896 = q1_mmm
            work[8896 + k] = _8896
            _8928 = -angle1__________________
            work[8928 + k] = _8928
            _8960 = q3_mmm
            work[8960 + k] = _8960
            work[8992 + k] = (
                UNREACHABLE if _7840 != _7840 else (OUT_OF_LIMITS if outside_ppp else OK)
            )
            work[9024 + k] = (
                UNREACHABLE if _8064 != _8064 else (OUT_OF_LIMITS if outside_ppm else OK)
            )
            work[9056 + k] = (
                UNREACHABLE if _8160 != _8160 else (OUT_OF_LIMITS if outside_pmp else OK)
            )
            work[9088 + k] = (
                UNREACHABLE if _8320 != _8320 else (OUT_OF_LIMITS if outside_pmm else OK)
            )
            work[9120 + k] = (
                UNREACHABLE if _8416 != _8416 else (OUT_OF_LIMITS if outside_mpp else OK)
            )
            work[9152 + k] = (
                UNREACHABLE if _8640 != _8640 else (OUT_OF_LIMITS if outside_mpm else OK)
            )
            work[9184 + k] = (
                UNREACHABLE if _8736 != _8736 else (OUT_OF_LIMITS if outside_mmp else OK)
            )
            work[9216 + k] = (
                UNREACHABLE if _8896 != _8896 else (OUT_OF_LIMITS if outside_mmm else OK)
            )
            work[544 + k] = 1.0 if doubt else work[544 + k]
        for k in range(count):
            if work[544 + k] != 0.0:
                status[first + k, 0] = _LEFT_OVER
                continue
            for row in range(8):
                status[first + k, row] = np.uint8(work[_KINDS[row] + k])
                for i in range(7):
                    q[first + k, row, i] = work[_PLACES[row, i] + k]


def ik_batch(T, q_free, *, cores=None):
    """ik_all for N poses (N, 4, 4), shared among so many cores; all of them without a number.

    Returns:
        q (N, 8, 7) and status (N, 8).
    """
    T = _array(T, (len(T), 4, 4), "T")
    q, status = np.empty((len(T), 8, 7)), np.empty((len(T), 8), _BYTE)
    q_free = _array(q_free, (len(T), 1), "q_free")
    if _COMPILED:
        _share(_in_tiles, cores, T, q_free, q, status)
        for k in np.flatnonzero(status[:, 0] == _LEFT_OVER):
            ik_into(T[k], q_free[k], q[k], status[k], _ZEROS)
        return q, status
    _share(_one_by_one, cores, T, q_free, q, status)
    return q, status


def _share(solve, cores, *arrays):
    """Solves the rows of arrays, shared among threads."""
    shares = min(cores or os.cpu_count() or 1, len(arrays[0]) // 2048)
    if shares > 1:
        with ThreadPoolExecutor(shares) as threads:
            list(threads.map(solve, *(np.array_split(array, shares) for array in arrays)))
    else:
        solve(*arrays)


def _array(values, shape, name):
    values = np.ascontiguousarray(values, _FLOAT)
    if values.shape != shape:
        raise ValueError(f"{name} must have shape {shape}, not {values.shape}")
    return values


def _span(branch):
    """The rows of a branch: the first, and the one after the last."""
    if branch in BRANCHES:
        branch = BRANCHES.index(branch)
    if isinstance(branch, int) and 0 <= branch < MAX_SOLUTIONS:
        return branch, branch + 1
    raise ValueError(f"no branch {branch!r}; there are {', '.join(BRANCHES)}")
