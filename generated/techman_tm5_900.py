"""techman_tm5_900: Techman TM5-900.

Inverse kinematics, generated from robots/techman_tm5_900.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/techman_tm5_900.yaml. The formulas and where they come from:
techman_tm5_900.md.

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

NAME = "techman_tm5_900"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_LIMITS = (
    (-4.71238898038469, 4.71238898038469),
    (-3.141592653589793, 3.141592653589793),
    (-2.705260340591211, 2.705260340591211),
    (-3.141592653589793, 3.141592653589793),
    (-3.141592653589793, 3.141592653589793),
    (-4.71238898038469, 4.71238898038469),
)
BRANCHES = (
    "left-noflip-down",
    "left-noflip-up",
    "left-flip-down",
    "left-flip-up",
    "right-noflip-up",
    "right-noflip-down",
    "right-flip-up",
    "right-flip-down",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.1452  # joint offset 1 [m]
a2 = 0.429  # link length 2 [m]
d3 = 0.1223  # joint offset 3 [m]
a3 = 0.4115  # link length 3 [m]
d5 = 0.106  # joint offset 5 [m]
d6 = 0.11315  # joint offset 6 [m]
free_limit_squared2 = 1.7613271225000004e-24  # square of a length that fixes no angle [m^2]
least_root1 = 4.196816796692465e-07  # a root of nothing, by rounding [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
free_limit = 1e-12  # a length that fixes no angle
near_limit = 0.001  # a length whose direction is good to few digits
longest3 = 0.70644025  # square of the longest reach [m^2]
shortest3 = 0.00030625000000000053  # square of the shortest reach [m^2]
boundary3 = 1.574988146569254e-13  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.7064402499999777  # the longest, where branches merge [m^2]
shortest3_apart = 0.000306250000000465  # the shortest, where branches merge [m^2]
longest3_clear = 0.7064402499776906  # the longest, where blurred branches do [m^2]
shortest3_clear = 0.000306250000464503  # the shortest, where blurred branches do [m^2]
offset2 = 1.5707963267948966  # offset of joint 2 [rad]
offset4 = 1.5707963267948966  # offset of joint 4 [rad]
k1 = 0.014957290000000002  # d3^2 [m^2]
k2 = 3.2462089000017624e-14  # reach_slack1 * (2 * d3 + reach_slack1) [m^2]
k3 = 3.246208900000177e-15  # merge_slack1 * (2 * d3 + merge_slack1) [m^2]
k4 = 0.753494329955167  # 1 / arm_size1 [m^-1]
k5 = 0.35337324999999997  # a2^2 + a3^2 [m^2]
k6 = 2.8323236099663807  # 1 / (2 * a3 * a2) [m^-2]
high3 = 2.705260341591211
graze = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 3.246208900000177e-12  # 1000 * k3 [m^2]
m2 = 9.999999999999999e-09  # doubt_limit^2
m4 = 1.5753409313203573e-10  # 10 * (longest3 - longest3_clear) * (longest3_clear - shortest3) [m^4]
m5 = 1.1655011655011656  # a coefficient of S2
m6 = 0.017143065268065267  # a coefficient of S2

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
    y3_z = c2 * c3 - s2 * s3
    v7 = q[3] + offset4
    c4 = math.cos(v7)
    s4 = math.sin(v7)
    x4_x = x3_x * c4 - v5 * s4
    x4_y = x3_y * c4 - v6 * s4
    x4_z = x3_z * c4 + y3_z * s4
    z4_x = v5 * c4 + x3_x * s4
    z4_y = v6 * c4 + x3_y * s4
    z4_z = x3_z * s4 - y3_z * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 + s1 * s5
    x5_y = x4_y * c5 - c1 * s5
    x5_z = x4_z * c5
    z5_y = c1 * c5 + x4_y * s5
    z5_z = x4_z * s5
    z5_x = x4_x * s5 - s1 * c5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 + z4_x * s6
    T[0, 1] = z4_x * c6 - x5_x * s6
    T[0, 2] = z5_x
    T[0, 3] = x2_x * a2 + x3_x * a3 - s1 * d3 + z4_x * d5 + z5_x * d6
    T[1, 0] = x5_y * c6 + z4_y * s6
    T[1, 1] = z4_y * c6 - x5_y * s6
    T[1, 2] = z5_y
    T[1, 3] = x2_y * a2 + x3_y * a3 + c1 * d3 + z4_y * d5 + z5_y * d6
    T[2, 0] = x5_z * c6 + z4_z * s6
    T[2, 1] = z4_z * c6 - x5_z * s6
    T[2, 2] = z5_z
    T[2, 3] = d1 + s2 * a2 + x3_z * a3 + z4_z * d5 + z5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
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
    y3_z = c2 * c3 - s2 * s3
    p3_z = p2_z + x3_z * a3
    p3_x = p2_x + x3_x * a3 - s1 * d3
    p3_y = p2_y + x3_y * a3 + c1 * d3
    v7 = q[3] + offset4
    c4 = math.cos(v7)
    s4 = math.sin(v7)
    z4_x = v5 * c4 + x3_x * s4
    z4_y = v6 * c4 + x3_y * s4
    z4_z = x3_z * s4 - y3_z * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    z5_y = c1 * c5 + (x3_y * c4 - v6 * s4) * s5
    z5_z = (x3_z * c4 + y3_z * s4) * s5
    p5_x = p3_x + z4_x * d5
    p5_y = p3_y + z4_y * d5
    p5_z = p3_z + z4_z * d5
    z5_x = (x3_x * c4 - v5 * s4) * s5 - s1 * c5
    p6_x = p5_x + z5_x * d6
    p6_y = p5_y + z5_y * d6
    p6_z = p5_z + z5_z * d6
    v8 = p6_z - d1
    v9 = p6_z - p2_z
    v10 = p6_x - p3_x
    v11 = p6_y - p3_y
    v12 = p6_z - p3_z
    v13 = p6_x - p5_x
    v14 = p6_y - p5_y
    v15 = p6_z - p5_z
    J[0, 0] = -p6_y
    J[0, 1] = -(c1 * v8)
    J[0, 2] = -(c1 * v9)
    J[0, 3] = -(c1 * v12)
    J[0, 4] = z4_y * v12 - z4_z * v11
    J[0, 5] = z5_y * v15 - z5_z * v14
    J[1, 0] = p6_x
    J[1, 1] = -(s1 * v8)
    J[1, 2] = -(s1 * v9)
    J[1, 3] = -(s1 * v12)
    J[1, 4] = z4_z * v10 - z4_x * v12
    J[1, 5] = z5_z * v13 - z5_x * v15
    J[2, 1] = s1 * p6_y + c1 * p6_x
    J[2, 2] = s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x)
    J[2, 3] = s1 * v11 + c1 * v10
    J[2, 4] = z4_x * v11 - z4_y * v10
    J[2, 5] = z5_x * v14 - z5_y * v13
    J[3, 1] = s1
    J[3, 2] = s1
    J[3, 3] = s1
    J[3, 4] = z4_x
    J[3, 5] = z5_x
    J[4, 1] = -c1
    J[4, 2] = -c1
    J[4, 3] = -c1
    J[4, 4] = z4_y
    J[4, 5] = z5_y
    J[5, 0] = 1.0
    J[5, 4] = z4_z
    J[5, 5] = z5_z
    return J


_LOST = 128  # _LOST + j: the row was lost after joint j had been chosen freely
_NEARLY = 192  # _NEARLY + j: joint j is nearly free, and the row's second value is its angle


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others.

    The first value of a row that is _LOST says how far it is from a solution (negative).
    """
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1 A6^-1 [3, 4]
    X1 = T13 * d6 - T14
    wy = T24 - d6 * T23
    N1 = X1 * X1 + wy * wy
    free1 = N1 <= free_limit_squared2
    D1 = N1 - k1
    apart1 = k3 < D1
    if not (-k2 <= D1):
        return  # out of reach
    w1 = math.sqrt(D1 if apart1 else 0.0)
    v1 = (w1 if apart1 else least_root1) * k4
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else d3 * math.sqrt(N1)))
    v2 = X1 * d3
    v3 = wy * d3
    v4 = seed[0] + offset1

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v8 = T34 - d1

    # theta2, type 3: U1[2, 4] and U1[1, 4]
    v13 = seed[1] + offset2

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        root1 = w1 * e1
        c1 = math.cos(v4) if free1 else inverse1 * (v3 - X1 * root1)
        s1 = math.sin(v4) if free1 else inverse1 * (v2 + wy * root1)

        # theta6, type 2: U1 A6^-1 [3, 2]
        X6 = T21 * c1 - T11 * s1
        Y6 = T22 * c1 - T12 * s1
        w6 = math.sqrt(X6 * X6 + Y6 * Y6)
        free6 = w6 <= free_limit
        divisor6 = 1.0 if free6 else w6
        near6 = w6 <= near_limit

        # theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1]
        c5 = T23 * c1 - T13 * s1

        # theta3
        v9 = T14 * c1 + T24 * s1
        v10 = 1.0 if (free1 or near6) else v1

        # joint values
        q1 = _wrap(_atan2(s1, c1) - offset1)

        for i2 in range(2):  # noflip, flip
            e2 = 1.0 - 2.0 * i2
            # theta6
            if e2 < 0.0 and free6:
                continue  # both signs give the same
            factor6 = e2 / divisor6
            v5 = X6 * factor6
            v6 = Y6 * factor6
            off6 = w6 * abs(v5 * math.sin(seed[5]) + v6 * math.cos(seed[5])) if near6 else 1.0
            ahead6 = v6 * math.sin(seed[5]) - v5 * math.cos(seed[5]) if near6 else -1.0
            same6 = near6 and 0.0 < ahead6 and off6 <= free_limit
            held6 = free6 or same6
            c6 = math.cos(seed[5]) if held6 else -v5
            s6 = math.sin(seed[5]) if held6 else v6
            q6 = _atan2(s6, c6)
            s5 = w6 * e2

            # theta5
            q5 = _atan2(s5, c5)

            # theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1]
            Z1_234 = c6 * T32 + s6 * T31
            s234 = c5 * (c6 * T31 - s6 * T32) + s5 * T33
            theta234 = _atan2(s234, -Z1_234)

            # theta3
            v7 = d6 * s5
            Z1_3 = v8 - (Z1_234 * d5 + s234 * v7)
            Z2_3 = Z1_234 * v7 - s234 * d5 + v9
            N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
            K3 = N3 - k5
            D3 = (longest3 - N3) * (N3 - shortest3)
            apart3 = shortest3_apart < N3 and N3 < longest3_apart
            if not (-boundary3 <= D3 * v10):
                if near6:
                    status[4 * i1 + 2 * i2] = _NEARLY + 6
                    q[4 * i1 + 2 * i2, 0] = D3
                    q[4 * i1 + 2 * i2, 1] = _atan2(v6, -v5)
                if free1:
                    status[4 * i1 + 2 * i2] = _LOST + 1
                    q[4 * i1 + 2 * i2, 0] = D3
                if free6:
                    status[4 * i1 + 2 * i2] = _LOST + 6
                    q[4 * i1 + 2 * i2, 0] = D3
                continue  # out of reach
            w3 = math.sqrt(D3 if apart3 else 0.0)
            c3 = K3 * k6

            # theta2
            X1_2 = a2 + a3 * c3
            v11 = Z1_3 * X1_2
            v12 = Z2_3 * X1_2

            for i3 in range(2):  # +, -
                e3 = 1.0 - 2.0 * i3
                # theta3
                if (
                    e3 < 0.0 and (not apart3 or (near6 and not (shortest3_clear < N3 and N3 <
                    longest3_clear)))
                ):
                    continue  # both signs give the same
                s3 = w3 * e3 * k6
                q3 = _atan2(s3, c3)

                # theta2
                Y1_2 = a3 * s3
                S2 = v11 - Z2_3 * Y1_2
                C2 = v12 + Z1_3 * Y1_2
                w2 = math.sqrt(S2 * S2 + C2 * C2)
                free2 = w2 <= free_limit_squared2
                factor2 = 1.0 / (1.0 if free2 else w2)
                c2 = math.cos(v13) if free2 else C2 * factor2
                s2 = math.sin(v13) if free2 else S2 * factor2
                theta2 = _atan2(s2, c2)

                # joint values
                q2 = _wrap(theta2 - offset2)
                q4 = _wrap(theta234 - (q3 + theta2) - offset4)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0] = q1
                q[row, 1] = q2
                q[row, 2] = q3
                q[row, 3] = q4
                q[row, 4] = q5
                q[row, 5] = q6
                status[row] = FREE_JOINT if free1 or free2 or free6 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px) and math.isfinite(py) and math.isfinite(pz), pose


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
    for i in range(6):
        total += abs(_overshoot(i, values[i]))
    return total


@_inner
def _without_turns(angle):
    """An angle without its whole turns, by which a search could not tell small moves."""
    return math.copysign(abs(angle) % turn, angle)


_CHOOSABLE = (5, 1, 0,)  # joints, from 0, that may be free


@_inner
def _serves(search, q, status):
    """Whether a row was solved, as exactly as poses may be rounded."""
    if search[2] and _beyond_limits(q[search[0]]) > 0.0:
        return False
    return status[search[0]] != UNREACHABLE and status[search[0]] < _LOST


@_inner
def _shortfall(pose, row, q, status):
    """How far a row is from a solution: 0 if it is solved.
    """
    if status[row] >= _LOST:
        return q[row, 0]
    return -math.inf if status[row] == UNREACHABLE else 0.0


@_inner
def _attempt(pose, seed, search, moved, q, status):
    """Solves with a joint moved: 0 if it serves, else less.

    A search is a row, the joint that had been chosen, whether limits count.
    """
    row, joint = search[0], search[1]
    for i in range(8):
        status[i] = UNREACHABLE
    kept = seed[joint]
    seed[joint] = kept + moved
    _solve(pose, seed, q, status)
    seed[joint] = kept
    result = _shortfall(pose, row, q, status)
    return -_beyond_limits(q[row]) if search[2] and result == 0.0 else result


@_inner
def _peak(pose, seed, search, low, high, q, status):
    """Golden section for the move between low and high that comes nearest, or one that serves."""
    for _ in range(52):
        third = 0.3819660112501051 * (high - low)
        left = _attempt(pose, seed, search, low + third, q, status)
        right = _attempt(pose, seed, search, high - third, q, status)
        if left == 0.0 or right == 0.0:
            return low + third if left == 0.0 else high - third
        if left >= right:
            high -= third
        else:
            low += third
    return low


@_inner
def _summit(pose, seed, search, low, high, q, status):
    """A move between low and high that serves; NaN if there is none."""
    top = _peak(pose, seed, search, low, high, q, status)
    if _attempt(pose, seed, search, top, q, status) == 0.0:
        return top
    # beside a place where the branches meet, this one has no solution of its own
    for moved in (top - 1e-09, top + 1e-09):
        if math.isinf(_attempt(pose, seed, search, moved, q, status)):
            return math.nan
    _attempt(pose, seed, search, top, q, status)
    return top if _serves(search, q, status) else math.nan


@_inner
def _serving(pose, seed, search, q, status):
    """How far the joint has to be moved from the seed's value until it serves; NaN if nowhere.

    A fan of values shows where it serves or nearly so, golden section finds what lies between two
    of them, bisection the end that is nearest to the seed; of two that are equally near the lower
    one.
    """
    if _attempt(pose, seed, search, 0.0, q, status) == 0.0:
        return 0.0
    step, nearest, here = 0.09817477042468103, math.nan, -math.inf
    after = _attempt(pose, seed, search, -32.0 * step, q, status)
    for k in range(-32, 32 + 1):
        before, here = here, after
        after = _attempt(pose, seed, search, (k + 1) * step, q, status)
        outer = k * step
        inner = outer - step if k > 0 else outer + step if k < 0 else 0.0
        if here < 0.0 and here >= before and here > after:
            low, high = outer - step, outer + step
            outer = _summit(pose, seed, search, low, high, q, status)
            if math.isnan(outer):
                continue
        elif here < 0.0 or (before if k > 0 else after) == 0.0:
            continue
        for _ in range(52):
            middle = 0.5 * (inner + outer)
            if _attempt(pose, seed, search, middle, q, status) == 0.0:
                outer = middle
            else:
                inner = middle
        if not abs(outer) >= abs(nearest) - 1e-09:
            nearest = outer
    return nearest


@_inner
def _serving_digits(pose, seed, search, q, status):
    """The same for a joint that is nearly free: its angle is known to few digits.

    Also where the arm just reaches (an elbow that is stretched). As long as the angle is right up
    to rounding of what it was taken from, `_solve` takes it as it would take its own.
    """
    before, past = np.full(2, -math.inf), np.zeros(2)
    moved = 1e-15
    while moved < 0.1:
        for way in range(2):
            there = -moved if way else moved
            here = _attempt(pose, seed, search, there, q, status)
            if here == 0.0:
                return there
            if here < 2.0 * before[way] and past[way] == 0.0:
                past[way] = 1.0
                low = 0.25 * there
                top = _summit(pose, seed, search, low, there, q, status)
                if not math.isnan(top):
                    return top
            before[way] = here
        moved *= 2.0
    return math.nan


@_inner
def _nearest_miss(pose, seed, search, q, status):
    """How far a free joint has to be moved until the arm comes nearest to its pose."""
    step = 0.09817477042468103
    first = _attempt(pose, seed, search, 0.0, q, status)
    best, at = first, 0.0
    for k in range(-32, 32 + 1):
        here = _attempt(pose, seed, search, k * step, q, status)
        if here > best:
            best, at = here, k * step
    at = _peak(pose, seed, search, at - step, at + step, q, status)
    return at if _attempt(pose, seed, search, at, q, status) > first else 0.0


@_inner
def _serving_in_turn(pose, seed, search, q, status):
    """Several joints are free, and none serves by itself: the search and the move that do.

    In turn each is moved to where the arm comes nearest, until one serves.
    """
    for k in range(12):
        moved = _nearest_miss(pose, seed, search, q, status)
        if k > 0 and moved == 0.0:
            break
        seed[search[1]] += moved
        search = search[0], (0, 5)[k % 2], False
        moved = _serving(pose, seed, search, q, status)
        if not math.isnan(moved):
            return search, moved
    return search, math.nan


@_inner
def _choose_again(pose, given, row, q, status):
    """A free joint took the seed's value, and then the arm could not reach.

    The joint takes the nearest value that serves.
    """
    nearly = status[row] > _NEARLY
    search = row, status[row] - (_NEARLY if nearly else _LOST) - 1, False
    seed, trial, result = given.copy(), q.copy(), status.copy()
    if nearly:
        seed[search[1]] = q[row, 1]
        moved = _serving_digits(pose, seed, search, trial, result)
    else:
        seed[search[1]] = _without_turns(seed[search[1]])
        moved = _serving(pose, seed, search, trial, result)
        if math.isnan(moved):
            search, moved = _serving_in_turn(pose, seed, search, trial, result)
    _attempt(pose, seed, search, moved, trial, result)
    served = not math.isnan(moved) and _serves(search, trial, result)
    status[row] = result[row] if served else UNREACHABLE
    for i in range(6):
        q[row, i] = trial[row, i] if served else math.nan


@_inner
def _hopeless(pose, seed, search, q, status):
    """Whether a joint beyond its limits stays where it is when the one that is searched moves."""
    row = search[0]
    _attempt(pose, seed, search, 0.0, q, status)
    if _shortfall(pose, row, q, status) < 0.0:
        return False
    values = q[row].copy()
    _attempt(pose, seed, search, 0.1, q, status)
    if _shortfall(pose, row, q, status) < 0.0:
        return False
    for i in range(6):
        if abs(values[i] - q[row, i]) < 1e-09 and _overshoot(i, values[i]) != 0.0:
            return True
    return False


@_inner
def _keep_limits(pose, given, row, q, status):
    """A free joint took the seed's value, and that puts one beyond its limits.

    It takes the nearest value that keeps all of them, if there is one. Where several joints are
    free the others take the seed's values as far as their limits allow.
    """
    seed, trial, result = given.copy(), q.copy(), status.copy()
    for i in range(6):
        seed[i] -= _overshoot(i, seed[i])
    for joint in _CHOOSABLE:
        inside, search = seed[joint], (row, joint, True)
        seed[joint] = _without_turns(given[joint])
        if not _hopeless(pose, seed, search, trial, result):
            moved = _serving(pose, seed, search, trial, result)
            # beside the solution of another row this one has none
            start = _attempt(pose, seed, search, 0.0, trial, result)
            own = abs(moved) >= 1e-06 or not math.isinf(start)
            if own and not math.isnan(moved):
                _attempt(pose, seed, search, moved, trial, result)
                for i in range(6):
                    q[row, i] = trial[row, i]
                status[row] = result[row]
                return
        seed[joint] = inside


@_apart("void(UniTuple(float64, 12), float64[::1], float64[:, ::1], uint8[::1])")
def _other_choices(pose, seed, q, status):
    """Other values for free joints, in rows that the seed's do not serve."""
    for row in range(8):
        if status[row] >= _LOST:
            _choose_again(pose, seed, row, q, status)
        if status[row] == FREE_JOINT and _beyond_limits(q[row]) > 0.0:
            _keep_limits(pose, seed, row, q, status)


@_inner
def _choose(pose, seed, q, status):
    """The same where there is a row that needs it."""
    served = True
    for row in range(8):
        served = served and status[row] < _LOST
        served = served and not (status[row] == FREE_JOINT and _beyond_limits(q[row]) > 0.0)
    if served:
        return
    # arrays of the caller may have any layout
    values, rows, kinds = np.empty(6), np.empty((8, 6)), np.empty(8, np.uint8)
    for row in range(8):
        kinds[row] = status[row]
        for i in range(6):
            values[i], rows[row, i] = seed[i], q[row, i]
    _other_choices(pose, values, rows, kinds)
    for row in range(8):
        status[row] = kinds[row]
        for i in range(6):
            q[row, i] = rows[row, i]


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.7535, 0.7535, 0.7535, 1.0, 1.0, 1.0])


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


@_inner
def _past_an_end(joint, value):
    """How far a joint value is beyond its limits as it stands: perhaps it could be turned."""
    low, high = _LOWEST[joint], _HIGHEST[joint]
    if high - low < 6.183185307179587:
        return _overshoot(joint, value)
    off = value - min(max(value, low + _SLACK[joint]), high - _SLACK[joint])
    return 0.0 if abs(off) <= 0.5 * _SLACK[joint] else off


@_inner
def _past_ends(values):
    """How far joints are beyond their limits as they stand."""
    total = 0.0
    for i in range(6):
        total += abs(_past_an_end(i, values[i]))
    return total


@_inner
def _at_an_end(joint, value, seed):
    """A joint value moved by whole turns inside its limits, or next to an end that it is just
    beyond: the one near the seed."""
    near = value + turn * math.floor((seed - value) / turn + 0.5)
    if 0.0 < abs(_past_an_end(joint, near)) < 0.01:
        if abs(near - seed) < 0.15:
            return near
    off = _overshoot(joint, value)
    if off == 0.0 or abs(off) > 0.01:
        return _turned(_JOINTS, joint, value, value)
    return off + (_HIGHEST[joint] - _SLACK[joint] if off > 0.0 else _LOWEST[joint] + _SLACK[joint])


@_apart("boolean(UniTuple(float64, 12), float64, float64, float64[::1])")
def _settled(T, enough, most, q):
    """Takes joint values to some not farther than most that miss the pose by less than enough.

    If enough is NaN, to some inside their limits that miss it hardly more. Returns if it can.
    Damped least squares, while they gain: where roots meet a step still leaves less than half.
    Until one gains little they are damped so that none leads far.
    """
    half = np.empty(6)
    stands, moves = math.isnan(enough), 0
    held, x, settled = np.zeros(6, np.bool_), q.copy(), False
    last, lost = math.inf, 0
    for _ in range(20):
        e, miss = _miss(T, x)
        if math.isnan(enough):
            enough = miss + 1e-14
        worst, past = -1, 0.0
        for j in range(6 if stands and miss < enough else 0):
            off = _past_an_end(j, x[j]) if _PACE[j] > 0.0 else 0.0
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
def _lead_inside(pose, enough, most, q):
    """Takes joint values onto the ends that they are beyond, or else inside.

    Two of them may not be able to stand on their ends at once.
    """
    if _settle(pose, enough, most, q):
        return True
    past = 0
    for i in range(6):
        past += _past_an_end(i, q[i]) != 0.0
    if past < 2:
        return False
    x, enough = q.copy(), _miss(pose, q)[1] + 1e-14
    farther = 2.0
    while farther <= 16.0:
        for i in range(6):
            x[i] = q[i] - farther * _past_an_end(i, q[i])
        farther *= 2.0
        if _settle(pose, enough, most, x) and _past_ends(x) == 0.0:
            for i in range(6):
                q[i] = x[i]
            return True
    return False


@_inner
def _stand(pose, row, far, rows, status):
    """Puts a row's joints just beyond their limits on them, unless that is another solution; those
    that are far beyond them, too, if that is asked for. Returns if it did.

    Half way to the same there is one, and what is nearer to another row that is less far beyond is
    that one's.
    """
    q = rows[row]
    beyond = _past_ends(q)
    if not (0.0 < beyond and (far or beyond < 0.01)):
        return False
    x, half, to = q.copy(), np.empty(6), np.empty(6)
    if not _lead_inside(pose, math.nan, math.inf if far else 1.5, x):
        return False
    off = _half_way(q, x, half)
    for k in range(len(rows)):
        if status[k] != UNREACHABLE and _past_ends(rows[k]) < beyond:
            if _half_way(rows[k], x, to) < off:
                return False
    if off >= 0.001 and not _settle(pose, 1e-12, 0.25 * off, half):
        return False
    for i in range(6):
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
        here = seed[i]
        if abs(_past_an_end(i, here)) > 0.15:
            here = _turned(_JOINTS, i, here, here)
        x[i] = here - _past_an_end(i, here)
    if not _settle(pose, 1e-12, 0.15, x):
        return
    if _past_ends(x) > 1e-09 and not _lead_inside(pose, math.nan, 0.15, x):
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
    if nearest > 1e-06 or _past_ends(q[place]) > 0.0:
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
    _choose(pose, seed, q, status)
    _lead(pose, q, status)
    _tell_once(pose, q, status)
    for row in range(8):
        if status[row] != UNREACHABLE:
            for i in range(6):
                q[row, i] = _at_an_end(i, q[row, i], seed[i])
    _stay(pose, seed, q, status)
    count = 0
    for n in range(2 * 8):
        row, far = n % 8, n >= 8  # far where no row is inside all limits
        if status[row] == UNREACHABLE or (far and count > 0):
            continue
        if _stand(pose, row, far, q, status) and far:
            status[row] = FREE_JOINT
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
    X1 = d6 * T13 - T14
    wy = T24 - d6 * T23
    N1 = X1 * X1 + wy * wy
    D1 = N1 - k1
    w1 = math.sqrt(D1)
    v1 = k4 * w1
    inverse1 = 1.0 / N1
    v2 = inverse1 * (d3 * wy)
    c1_p = v2 - w1 * (X1 * inverse1)
    c1_m = v2 - w1 * (inverse1 * -X1)
    v3 = inverse1 * (d3 * X1)
    s1_p = v3 + w1 * (wy * inverse1)
    s1_m = v3 + w1 * (inverse1 * -wy)

    # theta6, type 2: U1 A6^-1 [3, 2]
    X6_p = c1_p * T21 - s1_p * T11
    X6_m = c1_m * T21 - s1_m * T11
    Y6_p = c1_p * T22 - s1_p * T12
    Y6_m = c1_m * T22 - s1_m * T12
    v4 = X6_p * X6_p + Y6_p * Y6_p
    v5 = X6_m * X6_m + Y6_m * Y6_m
    w6_p = math.sqrt(v4)
    w6_m = math.sqrt(v5)
    v6 = 1.0 / v4
    v7 = 1.0 / v5

    # theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1]
    c5_p = T23 * c1_p - T13 * s1_p
    c5_m = T23 * c1_m - T13 * s1_m

    # theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1]
    v8 = v6 * (Y6_p * T31 - X6_p * T32)
    v9 = v7 * (Y6_m * T31 - X6_m * T32)
    Z1_234_p = w6_p * v8
    Z1_234_m = w6_m * v9
    v10 = T33 - v6 * (c5_p * (X6_p * T31 + Y6_p * T32))
    v11 = T33 - v7 * (c5_m * (X6_m * T31 + Y6_m * T32))
    s234_p = w6_p * v10
    s234_m = w6_m * v11

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v12 = d6 * w6_p
    v13 = d6 * w6_m
    v14 = T34 - d1
    v15 = d5 * Z1_234_p
    v16 = d5 * Z1_234_m
    v17 = s234_p * v12
    v18 = s234_m * v13
    Z1_3_pp = v14 - (v15 + v17)
    Z1_3_pm = v14 - (v17 - v15)
    Z1_3_mp = v14 - (v16 + v18)
    Z1_3_mm = v14 - (v18 - v16)
    v19 = T14 * c1_p + T24 * s1_p
    v20 = T14 * c1_m + T24 * s1_m
    v21 = Z1_234_p * v12
    v22 = Z1_234_m * v13
    v23 = d5 * s234_p
    v24 = d5 * s234_m
    Z2_3_pp = v19 + (v21 - v23)
    Z2_3_pm = v19 + (v21 + v23)
    Z2_3_mp = v20 + (v22 - v24)
    Z2_3_mm = v20 + (v22 + v24)
    N3_pp = Z1_3_pp * Z1_3_pp + Z2_3_pp * Z2_3_pp
    N3_pm = Z1_3_pm * Z1_3_pm + Z2_3_pm * Z2_3_pm
    N3_mp = Z1_3_mp * Z1_3_mp + Z2_3_mp * Z2_3_mp
    N3_mm = Z1_3_mm * Z1_3_mm + Z2_3_mm * Z2_3_mm
    D3_pp = (longest3 - N3_pp) * (N3_pp - shortest3)
    D3_pm = (longest3 - N3_pm) * (N3_pm - shortest3)
    D3_mp = (longest3 - N3_mp) * (N3_mp - shortest3)
    D3_mm = (longest3 - N3_mm) * (N3_mm - shortest3)
    w3_pp = math.sqrt(D3_pp)
    w3_pm = math.sqrt(D3_pm)
    w3_mp = math.sqrt(D3_mp)
    w3_mm = math.sqrt(D3_mm)
    v25 = w3_pp - w3_pp
    v26 = w3_pm - w3_pm
    v27 = w3_mp - w3_mp
    v28 = w3_mm - w3_mm

    # theta2, type 3: U1[2, 4] and U1[1, 4]
    v29 = m6 + m5 * N3_pp
    v30 = m6 + m5 * N3_pm
    v31 = m6 + m5 * N3_mp
    v32 = m6 + m5 * N3_mm
    v33 = Z1_3_pp * v29
    v34 = Z1_3_pm * v30
    v35 = Z1_3_mp * v31
    v36 = Z1_3_mm * v32
    v37 = Z2_3_pp * v29
    v38 = Z2_3_pm * v30
    v39 = Z2_3_mp * v31
    v40 = Z2_3_mm * v32
    v41 = w3_pp * (m5 * Z2_3_pp)
    v42 = w3_pm * (m5 * Z2_3_pm)
    v43 = w3_mp * (m5 * Z2_3_mp)
    v44 = w3_mm * (m5 * Z2_3_mm)

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if (
        abs(v1 * D3_mm) <= m4 or abs(v1 * D3_mp) <= m4 or abs(v1 * D3_pm) <= m4 or abs(v1 * D3_pp)
        <= m4 or v5 <= m2 or abs(D1) <= m1 or v4 <= m2
    ):
        return False

    # angles, side by side
    room[0] = Y6_p
    room[1] = Y6_m
    room[2] = w6_p
    room[3] = w6_m
    room[4] = v10
    room[5] = v11
    room[6] = w3_pp
    room[7] = w3_pm
    room[8] = w3_mp
    room[9] = w3_mm
    room[10] = v33 - v41
    room[11] = v33 + v41
    room[12] = v34 - v42
    room[13] = v34 + v42
    room[14] = v35 - v43
    room[15] = v35 + v43
    room[16] = v36 - v44
    room[17] = v36 + v44
    room[18] = s1_p
    room[19] = s1_m
    room[24] = -X6_p
    room[25] = -X6_m
    room[26] = c5_p
    room[27] = c5_m
    room[28] = -v8
    room[29] = -v9
    room[30] = N3_pp - k5
    room[31] = N3_pm - k5
    room[32] = N3_mp - k5
    room[33] = N3_mm - k5
    room[34] = v37 + w3_pp * (m5 * Z1_3_pp)
    room[35] = v37 + w3_pp * (m5 * -Z1_3_pp)
    room[36] = v38 + w3_pm * (m5 * Z1_3_pm)
    room[37] = v38 + w3_pm * (m5 * -Z1_3_pm)
    room[38] = v39 + w3_mp * (m5 * Z1_3_mp)
    room[39] = v39 + w3_mp * (m5 * -Z1_3_mp)
    room[40] = v40 + w3_mm * (m5 * Z1_3_mm)
    room[41] = v40 + w3_mm * (m5 * -Z1_3_mm)
    room[42] = c1_p
    room[43] = c1_m
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

    # theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1]
    theta234_pm = angle5 - math.copysign(half_turn, v10)
    theta234_mm = angle6 - math.copysign(half_turn, v11)

    # joint values
    v45 = angle19 - offset1
    v46 = angle20 - offset1
    q1__p = v45 + (turn if v45 <= -half_turn else 0.0)
    q1__m = v46 + (turn if v46 <= -half_turn else 0.0)
    v47 = angle11 - offset2
    v48 = angle12 - offset2
    v49 = angle13 - offset2
    v50 = angle14 - offset2
    v51 = angle15 - offset2
    v52 = angle16 - offset2
    v53 = angle17 - offset2
    v54 = angle18 - offset2
    q2_ppp = v47 + (turn if v47 <= -half_turn else 0.0)
    q2_ppm = v48 + (turn if v48 <= -half_turn else 0.0)
    q2_pmp = v49 + (turn if v49 <= -half_turn else 0.0)
    q2_pmm = v50 + (turn if v50 <= -half_turn else 0.0)
    q2_mpp = v51 + (turn if v51 <= -half_turn else 0.0)
    q2_mpm = v52 + (turn if v52 <= -half_turn else 0.0)
    q2_mmp = v53 + (turn if v53 <= -half_turn else 0.0)
    q2_mmm = v54 + (turn if v54 <= -half_turn else 0.0)
    v55 = angle5 - (angle7 + angle11) - offset4
    v56 = angle5 - (angle12 - angle7) - offset4
    v57 = theta234_pm - (angle8 + angle13) - offset4
    v58 = theta234_pm - (angle14 - angle8) - offset4
    v59 = angle6 - (angle9 + angle15) - offset4
    v60 = angle6 - (angle16 - angle9) - offset4
    v61 = theta234_mm - (angle10 + angle17) - offset4
    v62 = theta234_mm - (angle18 - angle10) - offset4
    v63 = v55 + (turn if v55 <= -half_turn else (-turn if half_turn < v55 else 0.0))
    v64 = v56 + (turn if v56 <= -half_turn else (-turn if half_turn < v56 else 0.0))
    v65 = v57 + (turn if v57 <= -half_turn else (-turn if half_turn < v57 else 0.0))
    v66 = v58 + (turn if v58 <= -half_turn else (-turn if half_turn < v58 else 0.0))
    v67 = v59 + (turn if v59 <= -half_turn else (-turn if half_turn < v59 else 0.0))
    v68 = v60 + (turn if v60 <= -half_turn else (-turn if half_turn < v60 else 0.0))
    v69 = v61 + (turn if v61 <= -half_turn else (-turn if half_turn < v61 else 0.0))
    v70 = v62 + (turn if v62 <= -half_turn else (-turn if half_turn < v62 else 0.0))
    q4_ppp = v63 + (turn if v63 <= -half_turn else 0.0)
    q4_ppm = v64 + (turn if v64 <= -half_turn else 0.0)
    q4_pmp = v65 + (turn if v65 <= -half_turn else 0.0)
    q4_pmm = v66 + (turn if v66 <= -half_turn else 0.0)
    q4_mpp = v67 + (turn if v67 <= -half_turn else 0.0)
    q4_mpm = v68 + (turn if v68 <= -half_turn else 0.0)
    q4_mmp = v69 + (turn if v69 <= -half_turn else 0.0)
    q4_mmm = v70 + (turn if v70 <= -half_turn else 0.0)
    excess_pp = abs(angle7) - high3
    excess_pm = abs(angle8) - high3
    excess_mp = abs(angle9) - high3
    excess_mm = abs(angle10) - high3
    outside_ppp = 0.0 < excess_pp
    outside_pmp = 0.0 < excess_pm
    outside_mpp = 0.0 < excess_mp
    outside_mmp = 0.0 < excess_mm
    q1_ppp = v25 + q1__p
    q1_pmp = v26 + q1__p
    q1_mpp = v27 + q1__m
    q1_mmp = v28 + q1__m
    q5_ppp = angle3 + v25
    q5_pmp = v26 - angle3
    q5_mpp = angle4 + v27
    q5_mmp = v28 - angle4
    q6_ppp = angle1 + v25
    q6_pmp = v26 + (angle1 - math.copysign(half_turn, Y6_p))
    q6_mpp = angle2 + v27
    q6_mmp = v28 + (angle2 - math.copysign(half_turn, Y6_m))

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if (
        abs(excess_mm - graze) <= graze or abs(excess_mp - graze) <= graze or abs(excess_pp - graze)
        <= graze or abs(excess_pm - graze) <= graze
    ):
        return False

    q[0, 0] = q1_ppp
    q[0, 1] = q2_ppp
    q[0, 2] = angle7
    q[0, 3] = q4_ppp
    q[0, 4] = q5_ppp
    q[0, 5] = q6_ppp
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else (OUT_OF_LIMITS if outside_ppp else OK)
    q[1, 0] = q1_ppp
    q[1, 1] = q2_ppm
    q[1, 2] = -angle7
    q[1, 3] = q4_ppm
    q[1, 4] = q5_ppp
    q[1, 5] = q6_ppp
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else (OUT_OF_LIMITS if outside_ppp else OK)
    q[2, 0] = q1_pmp
    q[2, 1] = q2_pmp
    q[2, 2] = angle8
    q[2, 3] = q4_pmp
    q[2, 4] = q5_pmp
    q[2, 5] = q6_pmp
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else (OUT_OF_LIMITS if outside_pmp else OK)
    q[3, 0] = q1_pmp
    q[3, 1] = q2_pmm
    q[3, 2] = -angle8
    q[3, 3] = q4_pmm
    q[3, 4] = q5_pmp
    q[3, 5] = q6_pmp
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else (OUT_OF_LIMITS if outside_pmp else OK)
    q[4, 0] = q1_mpp
    q[4, 1] = q2_mpp
    q[4, 2] = angle9
    q[4, 3] = q4_mpp
    q[4, 4] = q5_mpp
    q[4, 5] = q6_mpp
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else (OUT_OF_LIMITS if outside_mpp else OK)
    q[5, 0] = q1_mpp
    q[5, 1] = q2_mpm
    q[5, 2] = -angle9
    q[5, 3] = q4_mpm
    q[5, 4] = q5_mpp
    q[5, 5] = q6_mpp
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else (OUT_OF_LIMITS if outside_mpp else OK)
    q[6, 0] = q1_mmp
    q[6, 1] = q2_mmp
    q[6, 2] = angle10
    q[6, 3] = q4_mmp
    q[6, 4] = q5_mmp
    q[6, 5] = q6_mmp
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else (OUT_OF_LIMITS if outside_mmp else OK)
    q[7, 0] = q1_mmp
    q[7, 1] = q2_mmm
    q[7, 2] = -angle10
    q[7, 3] = q4_mmm
    q[7, 4] = q5_mmp
    q[7, 5] = q6_mmp
    status[7] = UNREACHABLE if q[7, 0] != q[7, 0] else (OUT_OF_LIMITS if outside_mmp else OK)
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
    [1168, 1184, 1200, 1216, 1232, 1248],
    [1168, 1264, 1280, 1296, 1232, 1248],
    [1312, 1328, 1344, 1360, 1376, 1392],
    [1312, 1408, 1424, 1440, 1376, 1392],
    [1456, 1472, 1488, 1504, 1520, 1536],
    [1456, 1552, 1568, 1584, 1520, 1536],
    [1600, 1616, 1632, 1648, 1664, 1680],
    [1600, 1696, 1712, 1728, 1664, 1680],
])
_KINDS = np.array([1744, 1760, 1776, 1792, 1808, 1824, 1840, 1856])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(1872), 1872)
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
            X1 = d6 * T13 - T14
            wy = T24 - d6 * T23
            N1 = X1 * X1 + wy * wy
            D1 = N1 - k1
            w1 = math.sqrt(D1)
            v1 = k4 * w1
            inverse1 = 1.0 / N1
            v2 = inverse1 * (d3 * wy)
            c1_p = v2 - w1 * (X1 * inverse1)
            c1_m = v2 - w1 * (inverse1 * -X1)
            v3 = inverse1 * (d3 * X1)
            s1_p = v3 + w1 * (wy * inverse1)
            s1_m = v3 + w1 * (inverse1 * -wy)
            X6_p = c1_p * T21 - s1_p * T11
            X6_m = c1_m * T21 - s1_m * T11
            Y6_p = c1_p * T22 - s1_p * T12
            Y6_m = c1_m * T22 - s1_m * T12
            v4 = X6_p * X6_p + Y6_p * Y6_p
            v5 = X6_m * X6_m + Y6_m * Y6_m
            w6_p = math.sqrt(v4)
            w6_m = math.sqrt(v5)
            v6 = 1.0 / v4
            v7 = 1.0 / v5
            c5_p = T23 * c1_p - T13 * s1_p
            c5_m = T23 * c1_m - T13 * s1_m
            v8 = v6 * (Y6_p * T31 - X6_p * T32)
            v9 = v7 * (Y6_m * T31 - X6_m * T32)
            Z1_234_p = w6_p * v8
            Z1_234_m = w6_m * v9
            v10 = T33 - v6 * (c5_p * (X6_p * T31 + Y6_p * T32))
            v11 = T33 - v7 * (c5_m * (X6_m * T31 + Y6_m * T32))
            s234_p = w6_p * v10
            s234_m = w6_m * v11
            v12 = d6 * w6_p
            v13 = d6 * w6_m
            v14 = T34 - d1
            v15 = d5 * Z1_234_p
            v16 = d5 * Z1_234_m
            v17 = s234_p * v12
            v18 = s234_m * v13
            Z1_3_pp = v14 - (v15 + v17)
            Z1_3_pm = v14 - (v17 - v15)
            Z1_3_mp = v14 - (v16 + v18)
            Z1_3_mm = v14 - (v18 - v16)
            v19 = T14 * c1_p + T24 * s1_p
            v20 = T14 * c1_m + T24 * s1_m
            v21 = Z1_234_p * v12
            v22 = Z1_234_m * v13
            v23 = d5 * s234_p
            v24 = d5 * s234_m
            Z2_3_pp = v19 + (v21 - v23)
            Z2_3_pm = v19 + (v21 + v23)
            Z2_3_mp = v20 + (v22 - v24)
            Z2_3_mm = v20 + (v22 + v24)
            N3_pp = Z1_3_pp * Z1_3_pp + Z2_3_pp * Z2_3_pp
            N3_pm = Z1_3_pm * Z1_3_pm + Z2_3_pm * Z2_3_pm
            N3_mp = Z1_3_mp * Z1_3_mp + Z2_3_mp * Z2_3_mp
            N3_mm = Z1_3_mm * Z1_3_mm + Z2_3_mm * Z2_3_mm
            D3_pp = (longest3 - N3_pp) * (N3_pp - shortest3)
            D3_pm = (longest3 - N3_pm) * (N3_pm - shortest3)
            D3_mp = (longest3 - N3_mp) * (N3_mp - shortest3)
            D3_mm = (longest3 - N3_mm) * (N3_mm - shortest3)
            w3_pp = math.sqrt(D3_pp)
            w3_pm = math.sqrt(D3_pm)
            w3_mp = math.sqrt(D3_mp)
            w3_mm = math.sqrt(D3_mm)
            v25 = w3_pp - w3_pp
            v26 = w3_pm - w3_pm
            v27 = w3_mp - w3_mp
            v28 = w3_mm - w3_mm
            v29 = m6 + m5 * N3_pp
            v30 = m6 + m5 * N3_pm
            v31 = m6 + m5 * N3_mp
            v32 = m6 + m5 * N3_mm
            v33 = Z1_3_pp * v29
            v34 = Z1_3_pm * v30
            v35 = Z1_3_mp * v31
            v36 = Z1_3_mm * v32
            v37 = Z2_3_pp * v29
            v38 = Z2_3_pm * v30
            v39 = Z2_3_mp * v31
            v40 = Z2_3_mm * v32
            v41 = w3_pp * (m5 * Z2_3_pp)
            v42 = w3_pm * (m5 * Z2_3_pm)
            v43 = w3_mp * (m5 * Z2_3_mp)
            v44 = w3_mm * (m5 * Z2_3_mm)
            work[272 + k] = D1
            work[288 + k] = v1
            work[304 + k] = Y6_p
            work[320 + k] = Y6_m
            work[336 + k] = v4
            work[352 + k] = v5
            work[368 + k] = v10
            work[384 + k] = v11
            work[400 + k] = D3_pp
            work[416 + k] = D3_pm
            work[432 + k] = D3_mp
            work[448 + k] = D3_mm
            work[464 + k] = v25
            work[480 + k] = v26
            work[496 + k] = v27
            work[512 + k] = v28
            work[528 + k] = Y6_p
            work[544 + k] = Y6_m
            work[560 + k] = w6_p
            work[576 + k] = w6_m
            work[592 + k] = v10
            work[608 + k] = v11
            work[624 + k] = w3_pp
            work[640 + k] = w3_pm
            work[656 + k] = w3_mp
            work[672 + k] = w3_mm
            work[688 + k] = v33 - v41
            work[704 + k] = v33 + v41
            work[720 + k] = v34 - v42
            work[736 + k] = v34 + v42
            work[752 + k] = v35 - v43
            work[768 + k] = v35 + v43
            work[784 + k] = v36 - v44
            work[800 + k] = v36 + v44
            work[816 + k] = s1_p
            work[832 + k] = s1_m
            work[848 + k] = -X6_p
            work[864 + k] = -X6_m
            work[880 + k] = c5_p
            work[896 + k] = c5_m
            work[912 + k] = -v8
            work[928 + k] = -v9
            work[944 + k] = N3_pp - k5
            work[960 + k] = N3_pm - k5
            work[976 + k] = N3_mp - k5
            work[992 + k] = N3_mm - k5
            work[1008 + k] = v37 + w3_pp * (m5 * Z1_3_pp)
            work[1024 + k] = v37 + w3_pp * (m5 * -Z1_3_pp)
            work[1040 + k] = v38 + w3_pm * (m5 * Z1_3_pm)
            work[1056 + k] = v38 + w3_pm * (m5 * -Z1_3_pm)
            work[1072 + k] = v39 + w3_mp * (m5 * Z1_3_mp)
            work[1088 + k] = v39 + w3_mp * (m5 * -Z1_3_mp)
            work[1104 + k] = v40 + w3_mm * (m5 * Z1_3_mm)
            work[1120 + k] = v40 + w3_mm * (m5 * -Z1_3_mm)
            work[1136 + k] = c1_p
            work[1152 + k] = c1_m
        for k in range(528, 848):
            work[k] = _atan2(work[k], work[k + 320])
        for k in range(0, 16):
            D1 = work[272 + k]
            v1 = work[288 + k]
            Y6_p = work[304 + k]
            Y6_m = work[320 + k]
            v4 = work[336 + k]
            v5 = work[352 + k]
            v10 = work[368 + k]
            v11 = work[384 + k]
            D3_pp = work[400 + k]
            D3_pm = work[416 + k]
            D3_mp = work[432 + k]
            D3_mm = work[448 + k]
            v25 = work[464 + k]
            v26 = work[480 + k]
            v27 = work[496 + k]
            v28 = work[512 + k]
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
            angle20 = work[832 + k]
            theta234_pm = angle5 - math.copysign(half_turn, v10)
            theta234_mm = angle6 - math.copysign(half_turn, v11)
            v45 = angle19 - offset1
            v46 = angle20 - offset1
            q1__p = v45 + (turn if v45 <= -half_turn else 0.0)
            q1__m = v46 + (turn if v46 <= -half_turn else 0.0)
            v47 = angle11 - offset2
            v48 = angle12 - offset2
            v49 = angle13 - offset2
            v50 = angle14 - offset2
            v51 = angle15 - offset2
            v52 = angle16 - offset2
            v53 = angle17 - offset2
            v54 = angle18 - offset2
            q2_ppp = v47 + (turn if v47 <= -half_turn else 0.0)
            q2_ppm = v48 + (turn if v48 <= -half_turn else 0.0)
            q2_pmp = v49 + (turn if v49 <= -half_turn else 0.0)
            q2_pmm = v50 + (turn if v50 <= -half_turn else 0.0)
            q2_mpp = v51 + (turn if v51 <= -half_turn else 0.0)
            q2_mpm = v52 + (turn if v52 <= -half_turn else 0.0)
            q2_mmp = v53 + (turn if v53 <= -half_turn else 0.0)
            q2_mmm = v54 + (turn if v54 <= -half_turn else 0.0)
            v55 = angle5 - (angle7 + angle11) - offset4
            v56 = angle5 - (angle12 - angle7) - offset4
            v57 = theta234_pm - (angle8 + angle13) - offset4
            v58 = theta234_pm - (angle14 - angle8) - offset4
            v59 = angle6 - (angle9 + angle15) - offset4
            v60 = angle6 - (angle16 - angle9) - offset4
            v61 = theta234_mm - (angle10 + angle17) - offset4
            v62 = theta234_mm - (angle18 - angle10) - offset4
            v63 = v55 + (turn if v55 <= -half_turn else (-turn if half_turn < v55 else 0.0))
            v64 = v56 + (turn if v56 <= -half_turn else (-turn if half_turn < v56 else 0.0))
            v65 = v57 + (turn if v57 <= -half_turn else (-turn if half_turn < v57 else 0.0))
            v66 = v58 + (turn if v58 <= -half_turn else (-turn if half_turn < v58 else 0.0))
            v67 = v59 + (turn if v59 <= -half_turn else (-turn if half_turn < v59 else 0.0))
            v68 = v60 + (turn if v60 <= -half_turn else (-turn if half_turn < v60 else 0.0))
            v69 = v61 + (turn if v61 <= -half_turn else (-turn if half_turn < v61 else 0.0))
            v70 = v62 + (turn if v62 <= -half_turn else (-turn if half_turn < v62 else 0.0))
            q4_ppp = v63 + (turn if v63 <= -half_turn else 0.0)
            q4_ppm = v64 + (turn if v64 <= -half_turn else 0.0)
            q4_pmp = v65 + (turn if v65 <= -half_turn else 0.0)
            q4_pmm = v66 + (turn if v66 <= -half_turn else 0.0)
            q4_mpp = v67 + (turn if v67 <= -half_turn else 0.0)
            q4_mpm = v68 + (turn if v68 <= -half_turn else 0.0)
            q4_mmp = v69 + (turn if v69 <= -half_turn else 0.0)
            q4_mmm = v70 + (turn if v70 <= -half_turn else 0.0)
            excess_pp = abs(angle7) - high3
            excess_pm = abs(angle8) - high3
            excess_mp = abs(angle9) - high3
            excess_mm = abs(angle10) - high3
            outside_ppp = 0.0 < excess_pp
            outside_pmp = 0.0 < excess_pm
            outside_mpp = 0.0 < excess_mp
            outside_mmp = 0.0 < excess_mm
            q1_ppp = v25 + q1__p
            q1_pmp = v26 + q1__p
            q1_mpp = v27 + q1__m
            q1_mmp = v28 + q1__m
            q5_ppp = angle3 + v25
            q5_pmp = v26 - angle3
            q5_mpp = angle4 + v27
            q5_mmp = v28 - angle4
            q6_ppp = angle1 + v25
            q6_pmp = v26 + (angle1 - math.copysign(half_turn, Y6_p))
            q6_mpp = angle2 + v27
            q6_mmp = v28 + (angle2 - math.copysign(half_turn, Y6_m))
            _1168 = q1_ppp
            work[1168 + k] = _1168
            _1184 = q2_ppp
            work[1184 + k] = _1184
            _1200 = angle7
            work[1200 + k] = _1200
            _1216 = q4_ppp
            work[1216 + k] = _1216
            _1232 = q5_ppp
            work[1232 + k] = _1232
            _1248 = q6_ppp
            work[1248 + k] = _1248
            _1264 = q2_ppm
            work[1264 + k] = _1264
            _1280 = -angle7
            work[1280 + k] = _1280
            _1296 = q4_ppm
            work[1296 + k] = _1296
            _1312 = q1_pmp
            work[1312 + k] = _1312
            _1328 = q2_pmp
            work[1328 + k] = _1328
            _1344 = angle8
            work[1344 + k] = _1344
            _1360 = q4_pmp
            work[1360 + k] = _1360
            _1376 = q5_pmp
            work[1376 + k] = _1376
            _1392 = q6_pmp
            work[1392 + k] = _1392
            _1408 = q2_pmm
            work[1408 + k] = _1408
            _1424 = -angle8
            work[1424 + k] = _1424
            _1440 = q4_pmm
            work[1440 + k] = _1440
            _1456 = q1_mpp
            work[1456 + k] = _1456
            _1472 = q2_mpp
            work[1472 + k] = _1472
            _1488 = angle9
            work[1488 + k] = _1488
            _1504 = q4_mpp
            work[1504 + k] = _1504
            _1520 = q5_mpp
            work[1520 + k] = _1520
            _1536 = q6_mpp
            work[1536 + k] = _1536
            _1552 = q2_mpm
            work[1552 + k] = _1552
            _1568 = -angle9
            work[1568 + k] = _1568
            _1584 = q4_mpm
            work[1584 + k] = _1584
            _1600 = q1_mmp
            work[1600 + k] = _1600
            _1616 = q2_mmp
            work[1616 + k] = _1616
            _1632 = angle10
            work[1632 + k] = _1632
            _1648 = q4_mmp
            work[1648 + k] = _1648
            _1664 = q5_mmp
            work[1664 + k] = _1664
            _1680 = q6_mmp
            work[1680 + k] = _1680
            _1696 = q2_mmm
            work[1696 + k] = _1696
            _1712 = -angle10
            work[1712 + k] = _1712
            _1728 = q4_mmm
            work[1728 + k] = _1728
            work[1744 + k] = (
                UNREACHABLE if _1168 != _1168 else (OUT_OF_LIMITS if outside_ppp else OK)
            )
            work[1760 + k] = (
                UNREACHABLE if _1168 != _1168 else (OUT_OF_LIMITS if outside_ppp else OK)
            )
            work[1776 + k] = (
                UNREACHABLE if _1312 != _1312 else (OUT_OF_LIMITS if outside_pmp else OK)
            )
            work[1792 + k] = (
                UNREACHABLE if _1312 != _1312 else (OUT_OF_LIMITS if outside_pmp else OK)
            )
            work[1808 + k] = (
                UNREACHABLE if _1456 != _1456 else (OUT_OF_LIMITS if outside_mpp else OK)
            )
            work[1824 + k] = (
                UNREACHABLE if _1456 != _1456 else (OUT_OF_LIMITS if outside_mpp else OK)
            )
            work[1840 + k] = (
                UNREACHABLE if _1600 != _1600 else (OUT_OF_LIMITS if outside_mmp else OK)
            )
            work[1856 + k] = (
                UNREACHABLE if _1600 != _1600 else (OUT_OF_LIMITS if outside_mmp else OK)
            )
            work[256 + k] = (
                1.0 if abs(v1 * D3_mm) <= m4 or abs(v1 * D3_mp) <= m4 or abs(v1 * D3_pm) <= m4 or
                abs(v1 * D3_pp) <= m4 or v5 <= m2 or abs(D1) <= m1 or v4 <= m2 else work[256 + k]
            )
            work[256 + k] = (
                1.0 if abs(excess_mm - graze) <= graze or abs(excess_mp - graze) <= graze or
                abs(excess_pp - graze) <= graze or abs(excess_pm - graze) <= graze else work[256 +
                k]
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
