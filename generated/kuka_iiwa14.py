"""kuka_iiwa14: KUKA LBR iiwa 14 R820.

Inverse kinematics, generated from robots/kuka_iiwa14.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kuka_iiwa14.yaml. The formulas and where they come from:
kuka_iiwa14.md.

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
    "noflip4-left-noflip5",
    "noflip4-left-flip5",
    "noflip4-right-noflip5",
    "noflip4-right-flip5",
    "flip4-left-noflip5",
    "flip4-left-flip5",
    "flip4-right-noflip5",
    "flip4-right-flip5",
)
MAX_SOLUTIONS = 8
FREE_JOINTS = (3,)  # from 1: the caller gives their values

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose, or a free joint's value is not finite

d1 = 0.36  # joint offset 1 [m]
d3 = 0.42  # joint offset 3 [m]
d5 = 0.4  # joint offset 5 [m]
d7 = 0.126  # joint offset 7 [m]
reach_slack2 = 1.7056360000000002e-13  # rounding at the boundary of the workspace [m^2]
merge_slack2 = 1.705636e-14  # nearer to that boundary two branches are one [m^2]
free_limit_squared2 = 1.705636e-24  # square of a length that fixes no angle [m^2]
reach_slack1 = 1.3060000000000002e-13  # rounding at the boundary of the workspace [m]
merge_slack1 = 1.306e-14  # nearer to that boundary two branches are one [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
offset2 = 3.141592653589793  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset6 = 3.141592653589793  # offset of joint 6 [rad]
k1 = 0.336  # 2 * d5 * d3 [m^2]
k2 = 0.72  # 2 * d1 [m]
k3 = -0.2068  # d1^2 - (d3^2 + d5^2) [m^2]
k4 = 0.11289600000000001  # (2 * d5 * d3)^2 [m^4]
k5 = 8.857709750566894  # 1 / ((2 * d5 * d3)^2) [m^-4]

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
def _wrap(angle):
    """The angle moved by whole turns to (-pi, pi]."""
    return angle - _TURN * math.ceil(angle / _TURN - 0.5)


@_jit
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
    T13_ = x5_x * s6 - z4_x * c6
    T23_ = x5_y * s6 - z4_y * c6
    T33_ = x5_z * s6 - z4_z * c6
    c7 = math.cos(q[6])
    s7 = math.sin(q[6])
    T11_ = x6_x * c7 + z5_x * s7
    T21_ = x6_y * c7 + z5_y * s7
    T31_ = x6_z * c7 + z5_z * s7
    T12_ = z5_x * c7 - x6_x * s7
    T22_ = z5_y * c7 - x6_y * s7
    T32_ = z5_z * c7 - x6_z * s7
    T14_ = z2_x * d3 + z4_x * d5 + T13_ * d7
    T24_ = z2_y * d3 + z4_y * d5 + T23_ * d7
    T34_ = d1 - c2 * d3 + z4_z * d5 + T33_ * d7
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
    v1 = q[0] + offset1
    c1 = math.cos(v1)
    s1 = math.sin(v1)
    v2 = q[1] + offset2
    c2 = math.cos(v2)
    s2 = math.sin(v2)
    x2_x = c1 * c2
    x2_y = s1 * c2
    J43 = c1 * s2
    J53 = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 + s1 * s3
    x3_y = x2_y * c3 - c1 * s3
    x3_z = s2 * c3
    J54 = c1 * c3 + x2_y * s3
    J64 = s2 * s3
    p3_x = J43 * d3
    p3_y = J53 * d3
    p3_z = d1 - c2 * d3
    J44 = x2_x * s3 - s1 * c3
    v3 = q[3] + offset4
    c4 = math.cos(v3)
    s4 = math.sin(v3)
    x4_x = x3_x * c4 + J43 * s4
    x4_y = x3_y * c4 + J53 * s4
    x4_z = x3_z * c4 - c2 * s4
    J65 = c2 * c4 + x3_z * s4
    J45 = x3_x * s4 - J43 * c4
    J55 = x3_y * s4 - J53 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    p5_x = p3_x + J45 * d5
    p5_y = p3_y + J55 * d5
    p5_z = p3_z + J65 * d5
    J46 = x4_x * s5 - J44 * c5
    J56 = x4_y * s5 - J54 * c5
    J66 = x4_z * s5 - J64 * c5
    v4 = q[5] + offset6
    c6 = math.cos(v4)
    s6 = math.sin(v4)
    J47 = (x4_x * c5 + J44 * s5) * s6 - J45 * c6
    J57 = (x4_y * c5 + J54 * s5) * s6 - J55 * c6
    J67 = (x4_z * c5 + J64 * s5) * s6 - J65 * c6
    J21 = p5_x + J47 * d7
    p7_y = p5_y + J57 * d7
    p7_z = p5_z + J67 * d7
    v5 = p7_z - d1
    J32 = s1 * p7_y + c1 * J21
    J13 = J53 * v5 + c2 * p7_y
    J33 = J43 * p7_y - J53 * J21
    v6 = J21 - p3_x
    v7 = p7_y - p3_y
    v8 = p7_z - p3_z
    J14 = J54 * v8 - J64 * v7
    J24 = J64 * v6 - J44 * v8
    J34 = J44 * v7 - J54 * v6
    J15 = J55 * v8 - J65 * v7
    J25 = J65 * v6 - J45 * v8
    J35 = J45 * v7 - J55 * v6
    v9 = J21 - p5_x
    v10 = p7_y - p5_y
    v11 = p7_z - p5_z
    J16 = J56 * v11 - J66 * v10
    J26 = J66 * v9 - J46 * v11
    J36 = J46 * v10 - J56 * v9
    J17 = J57 * v11 - J67 * v10
    J27 = J67 * v9 - J47 * v11
    J37 = J47 * v10 - J57 * v9
    J[0, 0] = -p7_y
    J[0, 1] = -(c1 * v5)
    J[0, 2] = J13
    J[0, 3] = J14
    J[0, 4] = J15
    J[0, 5] = J16
    J[0, 6] = J17
    J[1, 0] = J21
    J[1, 1] = -(s1 * v5)
    J[1, 2] = -(c2 * J21 + J43 * v5)
    J[1, 3] = J24
    J[1, 4] = J25
    J[1, 5] = J26
    J[1, 6] = J27
    J[2, 1] = J32
    J[2, 2] = J33
    J[2, 3] = J34
    J[2, 4] = J35
    J[2, 5] = J36
    J[2, 6] = J37
    J[3, 1] = s1
    J[3, 2] = J43
    J[3, 3] = J44
    J[3, 4] = J45
    J[3, 5] = J46
    J[3, 6] = J47
    J[4, 1] = -c1
    J[4, 2] = J53
    J[4, 3] = J54
    J[4, 4] = J55
    J[4, 5] = J56
    J[4, 6] = J57
    J[5, 0] = 1.0
    J[5, 2] = -c2
    J[5, 3] = J64
    J[5, 4] = J65
    J[5, 5] = J66
    J[5, 6] = J67
    return J


@_jit
def _solve(pose, q_free, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    c3 = math.cos(q_free[0])
    s3 = math.sin(q_free[0])

    # theta4, type 2: the squared length of column 4 of U1 A7^-1
    wx = T14 - T13 * d7
    wy = T24 - d7 * T23
    wz = T34 - d7 * T33
    v1 = wy * wy
    Z4 = wx * wx + (v1 + (wz * (wz - k2) + k3))
    D4 = k4 - Z4 * Z4
    v2 = 2.0 * abs(Z4)
    apart4 = merge_slack2 * (v2 + merge_slack2) < D4
    if not (-(reach_slack2 * (v2 + reach_slack2)) <= D4):
        return  # out of reach
    w4 = math.sqrt(D4 if apart4 else 0.0)
    v3 = k5 * (k1 * Z4)

    # theta1, type 2: U1 A7^-1 [3, 4]
    N1 = v1 + -wx * -wx
    free1 = N1 <= free_limit_squared2
    inverse1 = 1.0 / (1.0 if free1 else N1)
    v8 = seed[0] + offset1

    # theta2, type 3: U1 A7^-1 [2, 4] and U1 A7^-1 [1, 4]
    X2_2 = d3 + d5 * v3
    Z1_2 = wz - d1
    v11 = X2_2 * Z1_2
    v13 = seed[1] + offset2

    # theta5, type 2: U5[3, 3]
    v14 = c3 * T13
    v15 = v3 * v14
    v16 = c3 * T23
    v17 = v3 * v16
    v21 = c3 * T33
    v22 = v3 * v21
    v25 = s3 * T33

    # theta6, type 3: U5[2, 3] and U5[1, 3]
    v28 = T33 * v3
    v29 = T13 * v3
    v30 = T23 * v3

    # theta7, type 3: U5[3, 2] and U5[3, 1]
    v32 = s3 * T32
    v35 = v3 * (c3 * T12)
    v36 = v3 * (c3 * T22)
    v40 = v3 * (c3 * T32)
    v42 = s3 * T31
    v45 = v3 * (c3 * T11)
    v46 = v3 * (c3 * T21)
    v50 = v3 * (c3 * T31)

    for i1 in range(2):  # noflip4, flip4
        e1 = 1.0 - 2.0 * i1
        # theta4
        if e1 < 0.0 and not apart4:
            continue  # both signs give the same
        v4 = k5 * (k1 * (w4 * e1))

        # theta1
        Z1 = d5 * (s3 * v4)
        D1 = N1 - Z1 * Z1
        v5 = 2.0 * abs(Z1)
        apart1 = merge_slack1 * (v5 + merge_slack1) < D1
        if not (-(reach_slack1 * (v5 + reach_slack1)) <= D1):
            continue  # out of reach
        w1 = math.sqrt(D1 if apart1 else 0.0)
        v6 = -wx * Z1
        v7 = wy * Z1

        # theta2
        v9 = d5 * (c3 * v4)
        v10 = v9 * Z1_2

        # theta5
        v18 = T33 * v4
        v19 = T13 * v4
        v20 = T23 * v4

        # theta6
        v26 = v4 * v14
        v27 = v4 * v16
        v31 = v4 * v21

        # theta7
        v37 = T32 * v4
        v38 = T12 * v4
        v39 = T22 * v4
        v47 = T31 * v4
        v48 = T11 * v4
        v49 = T21 * v4

        # joint values
        q4 = _wrap(_atan2(-v4, -v3) - offset4)

        for i2 in range(2):  # left, right
            e2 = 1.0 - 2.0 * i2
            # theta1
            if e2 < 0.0 and (free1 or not apart1):
                continue  # both signs give the same
            root1 = w1 * e2
            c1 = math.cos(v8) if free1 else inverse1 * (v7 - -wx * root1)
            s1 = math.sin(v8) if free1 else inverse1 * (v6 + wy * root1)

            # theta2
            S2 = root1 * X2_2 - v10
            v12 = root1 * v9 + v11
            w2 = math.sqrt(S2 * S2 + v12 * v12)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v13) if free2 else -(v12 * factor2)
            s2 = math.sin(v13) if free2 else S2 * factor2

            # theta5
            v23 = T13 * s1 - T23 * c1
            v24 = s3 * v23
            X5 = v3 * v24 - (c2 * (v18 - (c1 * v15 + s1 * v17)) - s2 * (c1 * v19 + s1 * v20 + v22))
            Y5 = c2 * (s3 * (T13 * c1 + T23 * s1)) + s2 * v25 - c3 * v23
            w5 = math.sqrt(X5 * X5 + Y5 * Y5)
            free5 = w5 <= free_limit
            divisor5 = 1.0 if free5 else w5

            # theta6
            c6 = v4 * v24 - (s2 * (c1 * v29 + s1 * v30 - v31) - c2 * (c1 * v26 + s1 * v27 + v28))

            # theta7
            v33 = T12 * s1 - T22 * c1
            v34 = c3 * v33 - (c2 * (s3 * (T12 * c1 + T22 * s1)) + s2 * v32)
            v41 = (
                c2 * (v37 - (c1 * v35 + s1 * v36)) - s2 * (c1 * v38 + s1 * v39 + v40) - v3 * (s3 *
                v33)
            )
            v43 = T11 * s1 - T21 * c1
            v44 = c3 * v43 - (c2 * (s3 * (T11 * c1 + T21 * s1)) + s2 * v42)
            v51 = (
                c2 * (v47 - (c1 * v45 + s1 * v46)) - s2 * (c1 * v48 + s1 * v49 + v50) - v3 * (s3 *
                v43)
            )

            # joint values
            q1 = _wrap(_atan2(s1, c1) - offset1)
            q2 = _wrap(_atan2(s2, c2) - offset2)

            for i3 in range(2):  # noflip5, flip5
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
                c7 = c5 * v34 + s5 * v41
                s7 = c5 * v44 + s5 * v51
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
        q_free: Values of the joints 3 (1,), float64.
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
        q_free: Values of the joints 3 (1,).
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
        q_free: Values of the joints 3 (1,).
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
