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


_jit = njit(cache=True, error_model="numpy")

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


@_jit
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
def _ik(T, q_free, seed, q, status):
    """All rows into q and status; how many are OK or FREE_JOINT."""
    valid, pose = _read(T, q_free)
    for row in range(8):
        status[row] = UNREACHABLE if valid else INVALID_POSE
        for i in range(7):
            q[row, i] = math.nan
    if not valid:
        return 0
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
    if q_seed is None:
        return _ik(T, q_free, _ZEROS, q, status)
    if q_seed.shape != (7,):
        raise ValueError("q_seed must be (7,)")
    if not np.isfinite(q_seed).all():
        raise ValueError("q_seed must be finite")
    return _ik(T, q_free, q_seed, q, status)


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
    if q_seed is None:
        ik_into(T, q_free, q, status)
    else:
        ik_into(T, q_free, q, status, _array(q_seed, (7,), "q_seed"))
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


@njit(cache=True, error_model="numpy", nogil=True)
def _ik_batch(T, q_free, q, status):
    for k in range(len(T)):
        _ik(T[k], q_free[k], _ZEROS, q[k], status[k])


def ik_batch(T, q_free, *, cores=None):
    """ik_all for N poses (N, 4, 4), shared among so many cores; all of them without a number.

    Returns:
        q (N, 8, 7) and status (N, 8).
    """
    T = _array(T, (len(T), 4, 4), "T")
    q, status = np.empty((len(T), 8, 7)), np.empty((len(T), 8), _BYTE)
    q_free = _array(q_free, (len(T), 1), "q_free")
    shares = min(cores or os.cpu_count() or 1, len(T) // 2048)
    if shares > 1:
        parts = (np.array_split(each, shares) for each in (T, q_free, q, status))
        with ThreadPoolExecutor(shares) as threads:
            list(threads.map(_ik_batch, *parts))
    else:
        _ik_batch(T, q_free, q, status)
    return q, status


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
