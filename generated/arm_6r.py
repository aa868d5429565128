"""arm_6r: Arm with six revolute joints and a spherical wrist.

Inverse kinematics, generated from robots/arm_6r.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/arm_6r.yaml. The formulas and where they come from: arm_6r.md.

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

NAME = "arm_6r"
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

d1 = 0.4  # joint offset 1 [m]
a2 = 0.4  # link length 2 [m]
d4 = 0.35  # joint offset 4 [m]
d6 = 0.1  # joint offset 6 [m]
free_limit1 = 1.25e-12  # a length that fixes no angle [m]
longest3 = 0.5625  # square of the longest reach [m^2]
shortest3 = 0.0025000000000000044  # square of the shortest reach [m^2]
longest3_reach = 0.5625000000001875  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.002499999999987505  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.5624999999999812  # the longest, where branches merge [m^2]
shortest3_apart = 0.0025000000000012543  # the shortest, where branches merge [m^2]
free_limit_squared2 = 1.5624999999999999e-24  # square of a length that fixes no angle [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.27999999999999997  # 2 * d4 * a2 [m^2]
k2 = 0.28250000000000003  # a2^2 + d4^2 [m^2]
k3 = 12.755102040816327  # 1 / ((2 * d4 * a2)^2) [m^-4]

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
    v4 = v1 * c3 + x2_x * s3
    v5 = v2 * c3 + x2_y * s3
    z3_z = s2 * s3 - c2 * c3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 + s1 * s4
    x4_y = x3_y * c4 - c1 * s4
    v6 = v3 * c4
    y5_x = s1 * c4 - x3_x * s4
    z4_y = c1 * c4 + x3_y * s4
    y5_z = v3 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 - v4 * s5
    x5_y = x4_y * c5 - v5 * s5
    x5_z = z3_z * s5 - v6 * c5
    v7 = v4 * c5 + x4_x * s5
    v8 = v5 * c5 + x4_y * s5
    T33_ = z3_z * c5 + v6 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T11_ = x5_x * c6 + y5_x * s6
    T21_ = x5_y * c6 - z4_y * s6
    T31_ = x5_z * c6 + y5_z * s6
    T12_ = y5_x * c6 - x5_x * s6
    T32_ = y5_z * c6 - x5_z * s6
    T14_ = x2_x * a2 - v4 * d4 - v7 * d6
    T24_ = x2_y * a2 - v5 * d4 - v8 * d6
    T34_ = d1 - s2 * a2 + z3_z * d4 + T33_ * d6
    T[0, 0] = T11_
    T[0, 1] = T12_
    T[0, 2] = -v7
    T[0, 3] = T14_
    T[1, 0] = T21_
    T[1, 1] = -(z4_y * c6 + x5_y * s6)
    T[1, 2] = -v8
    T[1, 3] = T24_
    T[2, 0] = T31_
    T[2, 1] = T32_
    T[2, 2] = T33_
    T[2, 3] = T34_
    T[3, 3] = 1.0
    return T


@_jit
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
    v1 = c1 * s2
    v2 = s1 * s2
    p2_x = x2_x * a2
    p2_y = x2_y * a2
    p2_z = d1 - s2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v1 * s3
    x3_y = x2_y * c3 - v2 * s3
    v3 = s2 * c3 + c2 * s3
    v4 = v1 * c3 + x2_x * s3
    v5 = v2 * c3 + x2_y * s3
    J64 = s2 * s3 - c2 * c3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    J55 = c1 * c4 + x3_y * s4
    y5_z = v3 * s4
    p4_x = p2_x - v4 * d4
    p4_y = p2_y - v5 * d4
    p4_z = p2_z + J64 * d4
    J45 = x3_x * s4 - s1 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v6 = v4 * c5 + (x3_x * c4 + s1 * s4) * s5
    v7 = v5 * c5 + (x3_y * c4 - c1 * s4) * s5
    J66 = J64 * c5 + v3 * c4 * s5
    J21 = p4_x - v6 * d6
    p6_y = p4_y - v7 * d6
    p6_z = p4_z + J66 * d6
    v8 = p6_z - d1
    J12 = c1 * v8
    J22 = s1 * v8
    v9 = J21 - p2_x
    v10 = p6_y - p2_y
    v11 = p6_z - p2_z
    J13 = c1 * v11
    J23 = s1 * v11
    J24 = J64 * v9 + v4 * v11
    J34 = v5 * v9 - v4 * v10
    v12 = J21 - p4_x
    v13 = p6_y - p4_y
    v14 = p6_z - p4_z
    J15 = J55 * v14 + y5_z * v13
    J35 = J45 * v13 - J55 * v12
    J26 = J66 * v12 + v6 * v14
    J36 = v7 * v12 - v6 * v13
    J[0, 0] = -p6_y
    J[0, 1] = J12
    J[0, 2] = J13
    J[0, 3] = -(v5 * v11 + J64 * v10)
    J[0, 4] = J15
    J[0, 5] = -(v7 * v14 + J66 * v13)
    J[1, 0] = J21
    J[1, 1] = J22
    J[1, 2] = J23
    J[1, 3] = J24
    J[1, 4] = -(y5_z * v12 + J45 * v14)
    J[1, 5] = J26
    J[2, 1] = -(s1 * p6_y + c1 * J21)
    J[2, 2] = -(s1 * v10 + c1 * v9)
    J[2, 3] = J34
    J[2, 4] = J35
    J[2, 5] = J36
    J[3, 1] = -s1
    J[3, 2] = -s1
    J[3, 3] = -v4
    J[3, 4] = J45
    J[3, 5] = -v6
    J[4, 1] = c1
    J[4, 2] = c1
    J[4, 3] = -v5
    J[4, 4] = J55
    J[4, 5] = -v7
    J[5, 0] = 1.0
    J[5, 3] = J64
    J[5, 4] = -y5_z
    J[5, 5] = J66
    return J


@_jit
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1 A6^-1 [3, 4]
    wx = T14 - T13 * d6
    Y1 = d6 * T23 - T24
    w1 = math.sqrt(wx * wx + Y1 * Y1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = T34 - d6 * T33
    Z1_3 = wz - d1
    v1 = Z1_3 * Z1_3

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(wx * factor1)
        s1 = math.sin(seed[0]) if free1 else Y1 * factor1
        q1 = _atan2(s1, c1)
        root1 = w1 * e1

        # theta3
        N3 = v1 + root1 * root1
        K3 = N3 - k2
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        v2 = k1 * K3 * k3

        # theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4]
        Y1_2 = a2 + d4 * v2
        v4 = Z1_3 * Y1_2
        v5 = root1 * Y1_2

        # theta4, type 2: U4[3, 3]
        v7 = T13 * c1 + T23 * s1
        Y4 = T13 * s1 - T23 * c1
        v8 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v9 = T22 * c1 - T12 * s1
        v10 = T12 * c1 + T22 * s1
        v12 = T21 * c1 - T11 * s1
        v13 = T11 * c1 + T21 * s1

        for i2 in range(2):  # down, up
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            c3 = k3 * (k1 * (w3 * e2))
            q3 = _atan2(-v2, c3)

            # theta2
            v3 = d4 * c3
            S2 = root1 * v3 - v4
            v6 = Z1_3 * v3 + v5
            w2 = math.sqrt(S2 * S2 + v6 * v6)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else -(v6 * factor2)
            s2 = math.sin(seed[1]) if free2 else S2 * factor2
            q2 = _atan2(s2, c2)

            # theta4
            c23 = c3 * c2 + v2 * s2
            s23 = c3 * s2 - v2 * c2
            X4 = T33 * s23 - c23 * v7
            w4 = math.sqrt(X4 * X4 + v8)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta6
            v11 = c23 * v10 - T32 * s23
            v14 = c23 * v13 - T31 * s23

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4
                if e3 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e3 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)

                # theta5, type 3: U4[2, 3] and U4[1, 3]
                q5 = _atan2(-(w4 * e3), -(T33 * c23 + s23 * v7))

                # theta6
                q6 = _atan2(-(c4 * v12 + s4 * v14), -(c4 * v9 + s4 * v11))
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
