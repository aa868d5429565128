"""abb_irb120: ABB IRB 120.

Inverse kinematics, generated from robots/abb_irb120.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/abb_irb120.yaml. The formulas and where they come from: abb_irb120.md.

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

NAME = "abb_irb120"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_LIMITS = (
    (-2.87979, 2.87979),
    (-1.91986, 1.91986),
    (-1.91986, 1.22173),
    (-2.79253, 2.79253),
    (-2.094395, 2.094395),
    (-6.98132, 6.98132),
)
BRANCHES = (
    "left-down-noflip",
    "left-down-flip",
    "left-up-noflip",
    "left-up-flip",
    "right-down-noflip",
    "right-down-flip",
    "right-up-noflip",
    "right-up-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose

d1 = 0.29  # joint offset 1 [m]
a2 = 0.27  # link length 2 [m]
a3 = 0.07  # link length 3 [m]
d4 = 0.302  # joint offset 4 [m]
d6 = 0.072  # z of the tool frame [m]
free_limit1 = 1.0040000000000002e-12  # a length that fixes no angle [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
longest3 = 0.3364074838347159  # square of the longest reach [m^2]
shortest3 = 0.0016005161652840592  # square of the shortest reach [m^2]
longest3_reach = 0.3364074838348323  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0016005161652760261  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.3364074838347043  # the longest, where branches merge [m^2]
shortest3_apart = 0.0016005161652848626  # the shortest, where branches merge [m^2]
free_limit_squared2 = 1.0080160000000003e-24  # square of a length that fixes no angle [m^2]
offset2 = 1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset5 = 3.141592653589793  # offset of joint 5 [rad]
k1 = 0.16308  # 2 * d4 * a2 [m^2]
k2 = 0.03780000000000001  # 2 * a3 * a2 [m^2]
k3 = 0.16900400000000002  # a2^2 + (a3^2 + d4^2) [m^2]
k4 = 35.683793403054324  # 1 / ((2 * d4 * a2)^2 + (2 * a3 * a2)^2) [m^-4]

_TURN = 6.283185307179586
# The limits with what rounding may add.
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - 1e-09
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + 1e-09
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])
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
    """The pose (4, 4) of the joint values q (6,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    T = np.zeros((4, 4))
    v1 = q[0] + offset1
    c1 = math.cos(v1)
    s1 = math.sin(v1)
    v2 = q[1] + offset2
    c2 = math.cos(v2)
    s2 = math.sin(v2)
    x2_x = c1 * c2
    x2_y = s1 * c2
    v3 = c1 * s2
    v4 = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v3 * s3
    x3_y = x2_y * c3 - v4 * s3
    x3_z = s2 * c3 + c2 * s3
    v5 = v3 * c3 + x2_x * s3
    v6 = v4 * c3 + x2_y * s3
    z3_z = c2 * c3 - s2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - s1 * s4
    x4_y = x3_y * c4 + c1 * s4
    x4_z = x3_z * c4
    z4_x = s1 * c4 + x3_x * s4
    z4_z = x3_z * s4
    z4_y = x3_y * s4 - c1 * c4
    v7 = q[4] + offset5
    c5 = math.cos(v7)
    s5 = math.sin(v7)
    x5_x = x4_x * c5 - v5 * s5
    x5_y = x4_y * c5 - v6 * s5
    x5_z = x4_z * c5 + z3_z * s5
    T11_ = v5 * c5 + x4_x * s5
    T21_ = v6 * c5 + x4_y * s5
    T31_ = x4_z * s5 - z3_z * c5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T12_ = z4_x * c6 - x5_x * s6
    T22_ = z4_y * c6 - x5_y * s6
    T32_ = z4_z * c6 - x5_z * s6
    T14_ = x2_x * a2 + x3_x * a3 - v5 * d4 + T11_ * d6
    T24_ = x2_y * a2 + x3_y * a3 - v6 * d4 + T21_ * d6
    T34_ = d1 + s2 * a2 + x3_z * a3 + z3_z * d4 + T31_ * d6
    T[0, 0] = T11_
    T[0, 1] = T12_
    T[0, 2] = -(x5_x * c6 + z4_x * s6)
    T[0, 3] = T14_
    T[1, 0] = T21_
    T[1, 1] = T22_
    T[1, 2] = -(x5_y * c6 + z4_y * s6)
    T[1, 3] = T24_
    T[2, 0] = T31_
    T[2, 1] = T32_
    T[2, 2] = -(x5_z * c6 + z4_z * s6)
    T[2, 3] = T34_
    T[3, 3] = 1.0
    return T


@_jit
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    J = np.zeros((6, 6))
    v1 = q[0] + offset1
    c1 = math.cos(v1)
    s1 = math.sin(v1)
    v2 = q[1] + offset2
    c2 = math.cos(v2)
    s2 = math.sin(v2)
    x2_x = c1 * c2
    x2_y = s1 * c2
    v3 = c1 * s2
    v4 = s1 * s2
    p2_x = x2_x * a2
    p2_y = x2_y * a2
    p2_z = d1 + s2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v3 * s3
    x3_y = x2_y * c3 - v4 * s3
    x3_z = s2 * c3 + c2 * s3
    v5 = v3 * c3 + x2_x * s3
    v6 = v4 * c3 + x2_y * s3
    J64 = c2 * c3 - s2 * s3
    p3_x = p2_x + x3_x * a3
    p3_y = p2_y + x3_y * a3
    p3_z = p2_z + x3_z * a3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    J45 = s1 * c4 + x3_x * s4
    J65 = x3_z * s4
    p4_x = p3_x - v5 * d4
    p4_y = p3_y - v6 * d4
    p4_z = p3_z + J64 * d4
    J55 = x3_y * s4 - c1 * c4
    v7 = q[4] + offset5
    c5 = math.cos(v7)
    s5 = math.sin(v7)
    J46 = v5 * c5 + (x3_x * c4 - s1 * s4) * s5
    J56 = v6 * c5 + (x3_y * c4 + c1 * s4) * s5
    J66 = x3_z * c4 * s5 - J64 * c5
    J21 = p4_x + J46 * d6
    v8 = p4_y + J56 * d6
    v9 = p4_z + J66 * d6
    v10 = v9 - d1
    J32 = s1 * v8 + c1 * J21
    v11 = v9 - p2_z
    J33 = s1 * (v8 - p2_y) + c1 * (J21 - p2_x)
    v12 = J21 - p3_x
    v13 = v8 - p3_y
    v14 = v9 - p3_z
    J24 = J64 * v12 + v5 * v14
    J34 = v6 * v12 - v5 * v13
    v15 = J21 - p4_x
    v16 = v8 - p4_y
    v17 = v9 - p4_z
    J15 = J55 * v17 - J65 * v16
    J25 = J65 * v15 - J45 * v17
    J35 = J45 * v16 - J55 * v15
    J16 = J56 * v17 - J66 * v16
    J26 = J66 * v15 - J46 * v17
    J36 = J46 * v16 - J56 * v15
    J[0, 0] = -v8
    J[0, 1] = -(c1 * v10)
    J[0, 2] = -(c1 * v11)
    J[0, 3] = -(v6 * v14 + J64 * v13)
    J[0, 4] = J15
    J[0, 5] = J16
    J[1, 0] = J21
    J[1, 1] = -(s1 * v10)
    J[1, 2] = -(s1 * v11)
    J[1, 3] = J24
    J[1, 4] = J25
    J[1, 5] = J26
    J[2, 1] = J32
    J[2, 2] = J33
    J[2, 3] = J34
    J[2, 4] = J35
    J[2, 5] = J36
    J[3, 1] = s1
    J[3, 2] = s1
    J[3, 3] = -v5
    J[3, 4] = J45
    J[3, 5] = J46
    J[4, 1] = -c1
    J[4, 2] = -c1
    J[4, 3] = -v6
    J[4, 4] = J55
    J[4, 5] = J56
    J[5, 0] = 1.0
    J[5, 3] = J64
    J[5, 4] = J65
    J[5, 5] = J66
    return J


@_jit
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[3, 4]
    X1 = d6 * T11 - T14
    t24 = T24 - d6 * T21
    w1 = math.sqrt(X1 * X1 + t24 * t24)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1
    v1 = seed[0] + offset1

    # theta3, type 6: U1[2, 4] and U1[1, 4]
    t34 = T34 - d6 * T31
    Z1_3 = t34 - d1
    v2 = Z1_3 * Z1_3

    # theta2, type 3: U1[2, 4] and U1[1, 4]
    v5 = seed[1] + offset2

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(v1) if free1 else -(X1 * factor1)
        s1 = math.sin(v1) if free1 else t24 * factor1
        root1 = w1 * e1

        # theta3
        N3 = v2 + root1 * root1
        K3 = N3 - k3
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        v3 = k1 * K3
        v4 = k2 * K3

        # theta4, type 2: U4[3, 3]
        v6 = T11 * c1 + T21 * s1
        Y4 = T21 * c1 - T11 * s1
        v8 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v9 = T12 * s1 - T22 * c1
        v10 = T12 * c1 + T22 * s1
        v12 = T23 * c1 - T13 * s1
        v13 = T13 * c1 + T23 * s1

        # joint values
        q1 = _wrap(_atan2(s1, c1) - offset1)

        for i2 in range(2):  # down, up
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            root3 = w3 * e2
            s3 = (k2 * root3 - v3) * k4
            c3 = k4 * (v4 + k1 * root3)
            q3 = _atan2(s3, c3)

            # theta2
            X1_2 = a2 + (a3 * c3 - d4 * s3)
            Y1_2 = d4 * c3 + a3 * s3
            S2 = Z1_3 * X1_2 - root1 * Y1_2
            C2 = root1 * X1_2 + Z1_3 * Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v5) if free2 else C2 * factor2
            s2 = math.sin(v5) if free2 else S2 * factor2

            # theta4
            c23 = c3 * c2 - s3 * s2
            s23 = c3 * s2 + s3 * c2
            v7 = c23 * v6 + T31 * s23
            w4 = math.sqrt(v7 * v7 + v8)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = s23 * v6 - T31 * c23

            # theta6
            v11 = c23 * v10 + T32 * s23
            v14 = c23 * v13 + T33 * s23

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4
                if e3 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e3 / divisor4
                c4 = math.cos(seed[3]) if free4 else v7 * factor4
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)
                s5 = w4 * e3

                # theta6
                c6 = c4 * v9 + s4 * v11
                s6 = c4 * v12 - s4 * v14
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


@_jit
def _read(T):
    """Whether T is a pose, and its upper three rows.

    Where it is only rounded, with the nearest rotation: R becomes (3 I - R R') R / 2, twice
    (Higham 1986).
    """
    x0, x1, x2, px = T[0, 0], T[0, 1], T[0, 2], T[0, 3]
    y0, y1, y2, py = T[1, 0], T[1, 1], T[1, 2], T[1, 3]
    z0, z1, z2, pz = T[2, 0], T[2, 1], T[2, 2], T[2, 3]
    valid = math.isfinite(px) and math.isfinite(py) and math.isfinite(pz)
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
def _ik(T, seed, q, status):
    """All rows into q and status; how many are OK or FREE_JOINT."""
    valid, pose = _read(T)
    for row in range(8):
        status[row] = UNREACHABLE if valid else INVALID_POSE
        for i in range(6):
            q[row, i] = math.nan
    if not valid:
        return 0
    _solve(pose, seed, q, status)
    count = 0
    for row in range(8):
        if status[row] == UNREACHABLE:
            continue
        for i in range(6):
            if not _LOWEST[i] <= q[row, i] <= _HIGHEST[i]:
                q[row, i] = _turned(i, q[row, i], q[row, i])
                if not _LOWEST[i] <= q[row, i] <= _HIGHEST[i]:
                    status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


@_jit
def ik_into(T, q, status, q_seed=None):
    """All solutions into the caller's arrays, for control loops and for other numba functions.

    Memory is allocated nowhere. numba compiles
    once more for arrays of another type or layout.

    Args:
        T: Pose (4, 4), float64.
        q: Filled with joint values (8, 6), NaN where there is no solution; float64.
        status: Filled with what each row holds (8,); uint8.
        q_seed: Values for joints that are indeterminate (6,), float64; zeros without it.

    Returns:
        How many rows are OK or FREE_JOINT.

    Raises:
        ValueError: An array has another shape, or the seed is not finite.
    """
    if T.shape != (4, 4) or q.shape != (8, 6) or status.shape != (8,):
        raise ValueError("T, q and status must be (4, 4), (8, 6) and (8,)")
    if q_seed is None:
        return _ik(T, _ZEROS, q, status)
    if q_seed.shape != (6,):
        raise ValueError("q_seed must be (6,)")
    if not np.isfinite(q_seed).all():
        raise ValueError("q_seed must be finite")
    return _ik(T, q_seed, q, status)


def ik_all(T, q_seed=None):
    """All solutions: q (8, 6) and status (8,).

    Row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (6,); zeros without it.

    Raises:
        ValueError: An argument has another shape, or the seed is not finite.
    """
    q, status = np.empty((8, 6)), np.empty(8, _BYTE)
    T = _array(T, (4, 4), "T")
    if q_seed is None:
        ik_into(T, q, status)
    else:
        ik_into(T, q, status, _array(q_seed, (6,), "q_seed"))
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
        for i in range(6):
            rows[row, i] = _near(i, rows[row, i], seed[i], limits)
            moved = rows[row, i] - seed[i]
            distance += _WEIGHT[i] * moved * moved
        if distance < least:
            nearest, least = row, distance
    for i in range(6):
        q[i] = rows[nearest, i]
    return nearest >= 0


def ik(T, q_seed=None, *, branch=None, limits=True):
    """One solution (6,): the nearest to the seed.

    Angles are moved by whole turns inside their limits.

    Args:
        T: Pose (4, 4).
        q_seed: Where the arm is (6,); zeros without it.
        branch: Only this branch: a name out of BRANCHES, or its row.
        limits: Whether joint limits count.

    Raises:
        Unreachable: There is no such solution; the text says why.
        ValueError: T is no pose, or there is no such branch.
    """
    first, last = (0, 8) if branch is None else _span(branch)
    rows, status = ik_all(T, q_seed)
    if status[0] == INVALID_POSE:
        raise ValueError("T is no pose: not finite, or not a right-handed rotation")
    rows, status, q = rows[first:last], status[first:last], np.empty(6)
    seed = _ZEROS if q_seed is None else _array(q_seed, (6,), "q_seed")
    if _nearest(rows, status, seed, limits, q):
        return q
    where = "" if branch is None else f" in branch {BRANCHES[first]}"
    beyond = OUT_OF_LIMITS in status
    why = "every solution is beyond the joint limits" if beyond else "the pose is out of reach"
    raise Unreachable(why + where)


@njit(cache=True, error_model="numpy", nogil=True)
def _ik_batch(T, q, status):
    for k in range(len(T)):
        _ik(T[k], _ZEROS, q[k], status[k])


def ik_batch(T, *, cores=None):
    """ik_all for N poses (N, 4, 4), shared among so many cores; all of them without a number.

    Returns:
        q (N, 8, 6) and status (N, 8).
    """
    T = _array(T, (len(T), 4, 4), "T")
    q, status = np.empty((len(T), 8, 6)), np.empty((len(T), 8), _BYTE)
    shares = min(cores or os.cpu_count() or 1, len(T) // 2048)
    if shares > 1:
        parts = (np.array_split(each, shares) for each in (T, q, status))
        with ThreadPoolExecutor(shares) as threads:
            list(threads.map(_ik_batch, *parts))
    else:
        _ik_batch(T, q, status)
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
