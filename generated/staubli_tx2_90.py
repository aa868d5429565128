"""staubli_tx2_90: Stäubli TX2-90.

Inverse kinematics, generated from robots/staubli_tx2_90.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/staubli_tx2_90.yaml. The formulas and where they come from:
staubli_tx2_90.md.

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

NAME = "staubli_tx2_90"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_LIMITS = (
    (-3.141592653589793, 3.141592653589793),
    (-2.2689280275926285, 2.5743606466916362),
    (-2.530727415391778, 2.530727415391778),
    (-4.71238898038469, 4.71238898038469),
    (-2.007128639793479, 2.443460952792061),
    (-4.71238898038469, 4.71238898038469),
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

d1 = 0.478  # joint offset 1 [m]
a1 = 0.05  # link length 1 [m]
d2 = 0.05  # joint offset 2 [m]
a2 = 0.425  # link length 2 [m]
d4 = 0.425  # joint offset 4 [m]
d6 = 0.1  # z of the tool frame [m]
free_limit_squared2 = 2.3347840000000007e-24  # square of a length that fixes no angle [m^2]
least_root1 = 4.831960264737285e-07  # a root of nothing, by rounding [m]
longest3 = 0.7224999999999999  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
boundary3 = 1.8769985565831955e-13  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.7224999999999739  # the longest, where branches merge [m^2]
shortest3_apart = 2.334784000000001e-28  # the shortest, where branches merge [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset3 = 1.5707963267948966  # offset of joint 3 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
k1 = 0.0025000000000000005  # d2^2 [m^2]
k2 = 1.5280000000023352e-14  # reach_slack1 * (2 * d2 + reach_slack1) [m^2]
k3 = 1.5280000000002339e-15  # merge_slack1 * (2 * d2 + merge_slack1) [m^2]
k4 = 0.6544502617801046  # 1 / arm_size1 [m^-1]
k5 = 0.36124999999999996  # 2 * d4 * a2 [m^2]
k6 = 7.662743501634321  # 1 / (k5^2) [m^-4]
low2 = -2.2689280285926285
high2 = 2.5743606476916363
high3 = 2.530727416391778
low5 = -2.007128640793479
high5 = 2.4434609537920613
graze = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 1.5280000000002338e-12  # 1000 * k3 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 1.876998556582453e-11
m3 = 0.2768166089965398  # a coefficient of s3
m4 = 2.768166089965398  # a coefficient of s3
m5 = 1.1764705882352942  # a coefficient of Y1_2
m6 = 5.451216326656003e-16  # doubt_limit_squared2^2 [m^4]
m7 = 9.999999999999999e-09  # doubt_limit^2

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
    v1 = q[1] + offset2
    c2 = math.cos(v1)
    s2 = math.sin(v1)
    x2_x = c1 * c2
    x2_y = s1 * c2
    v2 = c1 * s2
    v3 = s1 * s2
    v4 = q[2] + offset3
    c3 = math.cos(v4)
    s3 = math.sin(v4)
    x3_x = x2_x * c3 - v2 * s3
    x3_y = x2_y * c3 - v3 * s3
    v5 = s2 * c3 + c2 * s3
    z3_x = v2 * c3 + x2_x * s3
    z3_y = v3 * c3 + x2_y * s3
    z3_z = c2 * c3 - s2 * s3
    v6 = q[3] + offset4
    c4 = math.cos(v6)
    s4 = math.sin(v6)
    x4_x = x3_x * c4 - s1 * s4
    x4_y = x3_y * c4 + c1 * s4
    v7 = v5 * c4
    z4_x = s1 * c4 + x3_x * s4
    v8 = v5 * s4
    z4_y = x3_y * s4 - c1 * c4
    v9 = q[4] + offset5
    c5 = math.cos(v9)
    s5 = math.sin(v9)
    x5_x = x4_x * c5 + z3_x * s5
    x5_y = x4_y * c5 + z3_y * s5
    x5_z = z3_z * s5 - v7 * c5
    v10 = z3_z * c5 + v7 * s5
    z5_x = x4_x * s5 - z3_x * c5
    z5_y = x4_y * s5 - z3_y * c5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = z5_x
    T[0, 1] = z4_x * c6 - x5_x * s6
    T[0, 2] = -(x5_x * c6 + z4_x * s6)
    T[0, 3] = c1 * a1 + x2_x * a2 - s1 * d2 + z3_x * d4 + z5_x * d6
    T[1, 0] = z5_y
    T[1, 1] = z4_y * c6 - x5_y * s6
    T[1, 2] = -(x5_y * c6 + z4_y * s6)
    T[1, 3] = s1 * a1 + x2_y * a2 + c1 * d2 + z3_y * d4 + z5_y * d6
    T[2, 0] = -v10
    T[2, 1] = -(v8 * c6 + x5_z * s6)
    T[2, 2] = v8 * s6 - x5_z * c6
    T[2, 3] = d1 - s2 * a2 + z3_z * d4 - v10 * d6
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
    v1 = q[1] + offset2
    c2 = math.cos(v1)
    s2 = math.sin(v1)
    x2_x = c1 * c2
    x2_y = s1 * c2
    v2 = c1 * s2
    v3 = s1 * s2
    p2_z = d1 - s2 * a2
    p2_x = p1_x + x2_x * a2 - s1 * d2
    p2_y = p1_y + x2_y * a2 + c1 * d2
    v4 = q[2] + offset3
    c3 = math.cos(v4)
    s3 = math.sin(v4)
    x3_x = x2_x * c3 - v2 * s3
    x3_y = x2_y * c3 - v3 * s3
    v5 = s2 * c3 + c2 * s3
    z3_x = v2 * c3 + x2_x * s3
    z3_y = v3 * c3 + x2_y * s3
    z3_z = c2 * c3 - s2 * s3
    v6 = q[3] + offset4
    c4 = math.cos(v6)
    s4 = math.sin(v6)
    z4_x = s1 * c4 + x3_x * s4
    v7 = v5 * s4
    p4_x = p2_x + z3_x * d4
    p4_y = p2_y + z3_y * d4
    p4_z = p2_z + z3_z * d4
    z4_y = x3_y * s4 - c1 * c4
    v8 = q[4] + offset5
    c5 = math.cos(v8)
    s5 = math.sin(v8)
    v9 = z3_z * c5 + v5 * c4 * s5
    z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5
    z5_y = (x3_y * c4 + c1 * s4) * s5 - z3_y * c5
    J21 = p4_x + z5_x * d6
    v10 = p4_y + z5_y * d6
    v11 = p4_z - v9 * d6
    v12 = v11 - d1
    v13 = J21 - p2_x
    v14 = v10 - p2_y
    v15 = v11 - p2_z
    v16 = J21 - p4_x
    v17 = v10 - p4_y
    v18 = v11 - p4_z
    J[0, 0] = -v10
    J[0, 1] = c1 * v12
    J[0, 2] = c1 * v15
    J[0, 3] = z3_y * v15 - z3_z * v14
    J[0, 4] = z4_y * v18 + v7 * v17
    J[0, 5] = z5_y * v18 + v9 * v17
    J[1, 0] = J21
    J[1, 1] = s1 * v12
    J[1, 2] = s1 * v15
    J[1, 3] = z3_z * v13 - z3_x * v15
    J[1, 4] = -(v7 * v16 + z4_x * v18)
    J[1, 5] = -(v9 * v16 + z5_x * v18)
    J[2, 1] = -(s1 * (v10 - p1_y) + c1 * (J21 - p1_x))
    J[2, 2] = -(s1 * v14 + c1 * v13)
    J[2, 3] = z3_x * v14 - z3_y * v13
    J[2, 4] = z4_x * v17 - z4_y * v16
    J[2, 5] = z5_x * v17 - z5_y * v16
    J[3, 1] = -s1
    J[3, 2] = -s1
    J[3, 3] = z3_x
    J[3, 4] = z4_x
    J[3, 5] = z5_x
    J[4, 1] = c1
    J[4, 2] = c1
    J[4, 3] = z3_y
    J[4, 4] = z4_y
    J[4, 5] = z5_y
    J[5, 0] = 1.0
    J[5, 3] = z3_z
    J[5, 4] = -v7
    J[5, 5] = -v9
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[3, 4]
    t14 = T14 - d6 * T11
    Y1 = d6 * T21 - T24
    N1 = t14 * t14 + Y1 * Y1
    free1 = N1 <= free_limit_squared2
    D1 = N1 - k1
    apart1 = k3 < D1
    if not (-k2 <= D1):
        return  # out of reach
    w1 = math.sqrt(D1 if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else d2 * math.sqrt(N1)))
    v1 = t14 * d2
    v2 = Y1 * d2

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    t34 = T34 - d6 * T31
    Z1_3 = t34 - d1
    v4 = Z1_3 * Z1_3
    v5 = 1.0 if free1 else (w1 if apart1 else least_root1) * k4

    # theta2, type 3: U1[1, 4] and U1[2, 4]
    v11 = seed[1] + offset2

    # theta4, type 2: U4[3, 3]
    v15 = seed[3] + offset4

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        root1 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else -(inverse1 * (v2 + t14 * root1))
        s1 = math.sin(seed[0]) if free1 else inverse1 * (Y1 * root1 - v1)
        q1 = _atan2(s1, c1)

        # theta3
        v3 = root1 + a1
        N3 = v4 + v3 * v3
        K3 = N3 - k5
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= D3 * v5):
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        s3 = k5 * K3 * k6

        # theta2
        Y1_2 = a2 + d4 * s3
        v8 = Z1_3 * Y1_2
        v9 = v3 * Y1_2

        # theta4
        v13 = T11 * c1 + T21 * s1
        Y4 = T21 * c1 - T11 * s1
        v14 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v16 = T12 * s1 - T22 * c1
        v17 = T12 * c1 + T22 * s1
        v19 = T23 * c1 - T13 * s1
        v20 = T13 * c1 + T23 * s1

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            v6 = k6 * (k5 * (w3 * e2))

            # theta2
            v7 = d4 * v6
            S2 = v3 * v7 - v8
            v10 = Z1_3 * v7 + v9
            w2 = math.sqrt(S2 * S2 + v10 * v10)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v11) if free2 else -(v10 * factor2)
            s2 = math.sin(v11) if free2 else S2 * factor2

            # theta4
            v12 = v6 * c2 + s3 * s2
            s23 = s3 * c2 - v6 * s2
            X4 = v12 * v13 + T31 * s23
            w4 = math.sqrt(X4 * X4 + v14)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T31 * v12 - s23 * v13

            # theta6
            v18 = v12 * v17 + T32 * s23
            v21 = v12 * v20 + T33 * s23

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(s3, -v6) - offset3)

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4
                if e3 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e3 / divisor4
                c4 = math.cos(v15) if free4 else -(X4 * factor4)
                s4 = math.sin(v15) if free4 else Y4 * factor4
                s5 = w4 * e3

                # theta6
                c6 = c4 * v16 - s4 * v18
                s6 = c4 * v19 + s4 * v21
                q6 = _atan2(s6, c6)

                # joint values
                q4 = _wrap(_atan2(s4, c4) - offset4)
                q5 = _wrap(_atan2(s5, c5) - offset5)
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


_CHOOSABLE = (3, 1, 0,)  # joints, from 0, that may be free


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
    return -math.inf if status[row] == UNREACHABLE else -_beyond_limits(q[row])


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
    return math.nan


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
def _hopeless(pose, seed, search, q, status):
    """Whether a joint beyond its limits stays where it is when the one that is searched moves."""
    row = search[0]
    if math.isinf(_attempt(pose, seed, search, 0.0, q, status)):
        return False
    values = q[row].copy()
    if math.isinf(_attempt(pose, seed, search, 0.1, q, status)):
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
        if status[row] == FREE_JOINT and _beyond_limits(q[row]) > 0.0:
            _keep_limits(pose, seed, row, q, status)


@_inner
def _choose(pose, seed, q, status):
    """The same where there is a row that needs it."""
    served = True
    for row in range(8):
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
_MISS_WEIGHT = np.array([0.6545, 0.6545, 0.6545, 1.0, 1.0, 1.0])


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

    # theta1, type 2: U1[3, 4]
    t14 = T14 - d6 * T11
    Y1 = d6 * T21 - T24
    N1 = t14 * t14 + Y1 * Y1
    D1 = N1 - k1
    w1 = math.sqrt(D1)
    inverse1 = 1.0 / N1
    v1 = inverse1 * (d2 * Y1)
    v2 = v1 + w1 * (t14 * inverse1)
    v3 = v1 + w1 * (inverse1 * -t14)
    v4 = inverse1 * (d2 * t14)
    s1_p = w1 * (Y1 * inverse1) - v4
    s1_m = w1 * (inverse1 * -Y1) - v4

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    Z1_3 = T34 - d6 * T31 - d1
    v5 = a1 + w1
    v6 = a1 - w1
    v7 = Z1_3 * Z1_3
    N3_p = v7 + v5 * v5
    N3_m = v7 + v6 * v6
    D3_p = (longest3 - N3_p) * (N3_p - shortest3)
    D3_m = (longest3 - N3_m) * (N3_m - shortest3)
    v8 = k4 * w1
    w3_p = math.sqrt(D3_p)
    w3_m = math.sqrt(D3_m)
    v9 = m4 * v7 + (m4 * N1 - 1.0)
    v10 = m3 * w1
    s3_p = v9 + v10
    s3_m = v9 - v10
    v11 = k6 * (k5 * w3_p)
    v12 = k6 * (k5 * w3_m)

    # theta2, type 3: U1[1, 4] and U1[2, 4]
    Y1_2_p = a2 + d4 * s3_p
    Y1_2_m = a2 + d4 * s3_m
    v13 = Z1_3 * Y1_2_p
    v14 = Z1_3 * Y1_2_m
    v15 = w3_p * (m5 * v5)
    S2_pp = v15 - v13
    v16 = v13 + v15
    S2_mp = w3_m * (m5 * v6) - v14
    S2_mm = w3_m * (m5 * -v6) - v14
    v17 = v5 * Y1_2_p
    v18 = v6 * Y1_2_m
    v19 = m5 * Z1_3
    v20 = m5 * -Z1_3
    v21 = v17 + w3_p * v19
    v22 = v17 + w3_p * v20
    v23 = v18 + w3_m * v19
    v24 = v18 + w3_m * v20
    v25 = S2_pp * S2_pp + v21 * v21
    v26 = v16 * v16 + v22 * v22
    v27 = S2_mp * S2_mp + v23 * v23
    v28 = S2_mm * S2_mm + v24 * v24
    factor2_pp = math.sqrt(v25) * (1.0 / v25)
    factor2_pm = math.sqrt(v26) * (1.0 / v26)
    factor2_mp = math.sqrt(v27) * (1.0 / v27)
    factor2_mm = math.sqrt(v28) * (1.0 / v28)

    # theta4, type 2: U4[3, 3]
    v29 = s3_p * S2_pp - v11 * v21
    v30 = v11 * v22 - s3_p * v16
    v31 = s3_m * S2_mp - v12 * v23
    v32 = s3_m * S2_mm + v12 * v24
    v33 = s3_p * v21 + v11 * S2_pp
    v34 = s3_p * v22 + v11 * v16
    v35 = s3_m * v23 + v12 * S2_mp
    v36 = s3_m * v24 - v12 * S2_mm
    v37 = T21 * s1_p - T11 * v2
    v38 = T21 * s1_m - T11 * v3
    X4_pp = v29 * v37 - T31 * v33
    X4_pm = v30 * v37 - T31 * v34
    X4_mp = v31 * v38 - T31 * v35
    X4_mm = v32 * v38 - T31 * v36
    v39 = T21 * v2 + T11 * s1_p
    v40 = T21 * v3 + T11 * s1_m
    v41 = v39 * v39
    v42 = v40 * v40
    v43 = v41 + factor2_pp * (X4_pp * (factor2_pp * X4_pp))
    v44 = v41 + factor2_pm * (X4_pm * (factor2_pm * X4_pm))
    v45 = v42 + factor2_mp * (X4_mp * (factor2_mp * X4_mp))
    v46 = v42 + factor2_mm * (X4_mm * (factor2_mm * X4_mm))

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v47 = s1_p * T12 + v2 * T22
    v48 = s1_m * T12 + v3 * T22
    v49 = s1_p * T22 - v2 * T12
    v50 = s1_m * T22 - v3 * T12
    v51 = v2 * T23 + s1_p * T13
    v52 = v3 * T23 + s1_m * T13
    v53 = s1_p * T23 - v2 * T13
    v54 = s1_m * T23 - v3 * T13

    # joint values
    v63 = math.copysign(half_turn, -v39)
    v64 = math.copysign(half_turn, -v40)

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if (
        v46 <= m7 or v28 <= m6 or v45 <= m7 or v27 <= m6 or v44 <= m7 or v26 <= m6 or v43 <= m7 or
        v25 <= m6 or abs(D3_m * v8) <= m2 or abs(D1) <= m1 or abs(D3_p * v8) <= m2
    ):
        return False

    # angles, side by side
    room[0] = -(v51 * -X4_pp + v39 * (v29 * v53 - v33 * T33))
    room[1] = -(v51 * -X4_pm + v39 * (v30 * v53 - v34 * T33))
    room[2] = -(v52 * -X4_mp + v40 * (v31 * v54 - v35 * T33))
    room[3] = -(v52 * -X4_mm + v40 * (v32 * v54 - v36 * T33))
    room[4] = S2_pp
    room[5] = -v16
    room[6] = S2_mp
    room[7] = S2_mm
    room[8] = s3_p
    room[9] = s3_m
    room[10] = -v39
    room[11] = -v39
    room[12] = -v40
    room[13] = -v40
    room[14] = math.sqrt(v43)
    room[15] = math.sqrt(v44)
    room[16] = math.sqrt(v45)
    room[17] = math.sqrt(v46)
    room[18] = s1_p
    room[19] = s1_m
    room[24] = v47 * -X4_pp + v39 * (v29 * v49 - v33 * T32)
    room[25] = v47 * -X4_pm + v39 * (v30 * v49 - v34 * T32)
    room[26] = v48 * -X4_mp + v40 * (v31 * v50 - v35 * T32)
    room[27] = v48 * -X4_mm + v40 * (v32 * v50 - v36 * T32)
    room[28] = -v21
    room[29] = -v22
    room[30] = -v23
    room[31] = -v24
    room[32] = -v11
    room[33] = -v12
    room[34] = factor2_pp * -X4_pp
    room[35] = factor2_pm * -X4_pm
    room[36] = factor2_mp * -X4_mp
    room[37] = factor2_mm * -X4_mm
    room[38] = factor2_pp * (T31 * v29 + v33 * v37)
    room[39] = factor2_pm * (T31 * v30 + v34 * v37)
    room[40] = factor2_mp * (T31 * v31 + v35 * v38)
    room[41] = factor2_mm * (T31 * v32 + v36 * v38)
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

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    q6_ppm = angle1 - math.copysign(half_turn, -(v51 * -X4_pp + v39 * (v29 * v53 - v33 * T33)))
    q6_pmm = angle2 - math.copysign(half_turn, -(v51 * -X4_pm + v39 * (v30 * v53 - v34 * T33)))
    q6_mpm = angle3 - math.copysign(half_turn, -(v52 * -X4_mp + v40 * (v31 * v54 - v35 * T33)))
    q6_mmm = angle4 - math.copysign(half_turn, -(v52 * -X4_mm + v40 * (v32 * v54 - v36 * T33)))

    # joint values
    v55 = angle5 - offset2
    v56 = angle6 - offset2
    v57 = angle7 - offset2
    v58 = angle8 - offset2
    q2_ppp = v55 + (-turn if half_turn < v55 else 0.0)
    q2_pmp = v56 + (-turn if half_turn < v56 else 0.0)
    q2_mpp = v57 + (-turn if half_turn < v57 else 0.0)
    q2_mmp = v58 + (-turn if half_turn < v58 else 0.0)
    v59 = angle9 - offset3
    v60 = math.copysign(half_turn, s3_p) - angle9 - offset3
    v61 = angle10 - offset3
    v62 = math.copysign(half_turn, s3_m) - angle10 - offset3
    q3_ppp = v59 + (turn if v59 <= -half_turn else 0.0)
    q3_pmp = v60 + (turn if v60 <= -half_turn else 0.0)
    q3_mpp = v61 + (turn if v61 <= -half_turn else 0.0)
    q3_mmp = v62 + (turn if v62 <= -half_turn else 0.0)
    v65 = angle11 - offset4
    v66 = angle11 - v63 - offset4
    v67 = angle12 - offset4
    v68 = angle12 - v63 - offset4
    v69 = angle13 - offset4
    v70 = angle13 - v64 - offset4
    v71 = angle14 - offset4
    v72 = angle14 - v64 - offset4
    q4_ppp = v65 + (turn if v65 <= -half_turn else 0.0)
    q4_ppm = v66 + (turn if v66 <= -half_turn else 0.0)
    q4_pmp = v67 + (turn if v67 <= -half_turn else 0.0)
    q4_pmm = v68 + (turn if v68 <= -half_turn else 0.0)
    q4_mpp = v69 + (turn if v69 <= -half_turn else 0.0)
    q4_mpm = v70 + (turn if v70 <= -half_turn else 0.0)
    q4_mmp = v71 + (turn if v71 <= -half_turn else 0.0)
    q4_mmm = v72 + (turn if v72 <= -half_turn else 0.0)
    v73 = angle15 - offset5
    v74 = offset5 + angle15
    v75 = angle16 - offset5
    v76 = offset5 + angle16
    v77 = angle17 - offset5
    v78 = offset5 + angle17
    v79 = angle18 - offset5
    v80 = offset5 + angle18
    q5_ppp = v73 + (turn if v73 <= -half_turn else 0.0)
    q5_ppm = (turn if -v74 <= -half_turn else 0.0) - v74
    q5_pmp = v75 + (turn if v75 <= -half_turn else 0.0)
    q5_pmm = (turn if -v76 <= -half_turn else 0.0) - v76
    q5_mpp = v77 + (turn if v77 <= -half_turn else 0.0)
    q5_mpm = (turn if -v78 <= -half_turn else 0.0) - v78
    q5_mmp = v79 + (turn if v79 <= -half_turn else 0.0)
    q5_mmm = (turn if -v80 <= -half_turn else 0.0) - v80
    q1_ppp = angle19 + (w3_p - w3_p)
    q1_mpp = angle20 + (w3_m - w3_m)
    v81 = max(max(low2 - q2_ppp, q2_ppp - high2), abs(q3_ppp) - high3)
    v82 = max(max(low2 - q2_pmp, q2_pmp - high2), abs(q3_pmp) - high3)
    v83 = max(max(low2 - q2_mpp, q2_mpp - high2), abs(q3_mpp) - high3)
    v84 = max(max(low2 - q2_mmp, q2_mmp - high2), abs(q3_mmp) - high3)
    excess_ppp = max(v81, max(low5 - q5_ppp, q5_ppp - high5))
    excess_ppm = max(v81, max(low5 - q5_ppm, q5_ppm - high5))
    excess_pmp = max(v82, max(low5 - q5_pmp, q5_pmp - high5))
    excess_pmm = max(v82, max(low5 - q5_pmm, q5_pmm - high5))
    excess_mpp = max(v83, max(low5 - q5_mpp, q5_mpp - high5))
    excess_mpm = max(v83, max(low5 - q5_mpm, q5_mpm - high5))
    excess_mmp = max(v84, max(low5 - q5_mmp, q5_mmp - high5))
    excess_mmm = max(v84, max(low5 - q5_mmm, q5_mmm - high5))
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
    q[0, 4] = q5_ppp
    q[0, 5] = angle1
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else (OUT_OF_LIMITS if outside_ppp else OK)
    q[1, 0] = q1_ppp
    q[1, 1] = q2_ppp
    q[1, 2] = q3_ppp
    q[1, 3] = q4_ppm
    q[1, 4] = q5_ppm
    q[1, 5] = q6_ppm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else (OUT_OF_LIMITS if outside_ppm else OK)
    q[2, 0] = q1_ppp
    q[2, 1] = q2_pmp
    q[2, 2] = q3_pmp
    q[2, 3] = q4_pmp
    q[2, 4] = q5_pmp
    q[2, 5] = angle2
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else (OUT_OF_LIMITS if outside_pmp else OK)
    q[3, 0] = q1_ppp
    q[3, 1] = q2_pmp
    q[3, 2] = q3_pmp
    q[3, 3] = q4_pmm
    q[3, 4] = q5_pmm
    q[3, 5] = q6_pmm
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else (OUT_OF_LIMITS if outside_pmm else OK)
    q[4, 0] = q1_mpp
    q[4, 1] = q2_mpp
    q[4, 2] = q3_mpp
    q[4, 3] = q4_mpp
    q[4, 4] = q5_mpp
    q[4, 5] = angle3
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else (OUT_OF_LIMITS if outside_mpp else OK)
    q[5, 0] = q1_mpp
    q[5, 1] = q2_mpp
    q[5, 2] = q3_mpp
    q[5, 3] = q4_mpm
    q[5, 4] = q5_mpm
    q[5, 5] = q6_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else (OUT_OF_LIMITS if outside_mpm else OK)
    q[6, 0] = q1_mpp
    q[6, 1] = q2_mmp
    q[6, 2] = q3_mmp
    q[6, 3] = q4_mmp
    q[6, 4] = q5_mmp
    q[6, 5] = angle4
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else (OUT_OF_LIMITS if outside_mmp else OK)
    q[7, 0] = q1_mpp
    q[7, 1] = q2_mmp
    q[7, 2] = q3_mmp
    q[7, 3] = q4_mmm
    q[7, 4] = q5_mmm
    q[7, 5] = q6_mmm
    status[7] = UNREACHABLE if q[7, 0] != q[7, 0] else (OUT_OF_LIMITS if outside_mmm else OK)
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
    [1488, 1504, 1520, 1536, 1552, 1568],
    [1488, 1504, 1520, 1584, 1600, 1616],
    [1488, 1632, 1648, 1664, 1680, 1696],
    [1488, 1632, 1648, 1712, 1728, 1744],
    [1760, 1776, 1792, 1808, 1824, 1840],
    [1760, 1776, 1792, 1856, 1872, 1888],
    [1760, 1904, 1920, 1936, 1952, 1968],
    [1760, 1904, 1920, 1984, 2000, 2016],
])
_KINDS = np.array([2032, 2048, 2064, 2080, 2096, 2112, 2128, 2144])


@_njit(nogil=True)
def _in_tiles(T, q, status):
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
            t14 = T14 - d6 * T11
            Y1 = d6 * T21 - T24
            N1 = t14 * t14 + Y1 * Y1
            D1 = N1 - k1
            w1 = math.sqrt(D1)
            inverse1 = 1.0 / N1
            v1 = inverse1 * (d2 * Y1)
            v2 = v1 + w1 * (t14 * inverse1)
            v3 = v1 + w1 * (inverse1 * -t14)
            v4 = inverse1 * (d2 * t14)
            s1_p = w1 * (Y1 * inverse1) - v4
            s1_m = w1 * (inverse1 * -Y1) - v4
            Z1_3 = T34 - d6 * T31 - d1
            v5 = a1 + w1
            v6 = a1 - w1
            v7 = Z1_3 * Z1_3
            N3_p = v7 + v5 * v5
            N3_m = v7 + v6 * v6
            D3_p = (longest3 - N3_p) * (N3_p - shortest3)
            D3_m = (longest3 - N3_m) * (N3_m - shortest3)
            v8 = k4 * w1
            w3_p = math.sqrt(D3_p)
            w3_m = math.sqrt(D3_m)
            v9 = m4 * v7 + (m4 * N1 - 1.0)
            v10 = m3 * w1
            s3_p = v9 + v10
            s3_m = v9 - v10
            v11 = k6 * (k5 * w3_p)
            v12 = k6 * (k5 * w3_m)
            Y1_2_p = a2 + d4 * s3_p
            Y1_2_m = a2 + d4 * s3_m
            v13 = Z1_3 * Y1_2_p
            v14 = Z1_3 * Y1_2_m
            v15 = w3_p * (m5 * v5)
            S2_pp = v15 - v13
            v16 = v13 + v15
            S2_mp = w3_m * (m5 * v6) - v14
            S2_mm = w3_m * (m5 * -v6) - v14
            v17 = v5 * Y1_2_p
            v18 = v6 * Y1_2_m
            v19 = m5 * Z1_3
            v20 = m5 * -Z1_3
            v21 = v17 + w3_p * v19
            v22 = v17 + w3_p * v20
            v23 = v18 + w3_m * v19
            v24 = v18 + w3_m * v20
            v25 = S2_pp * S2_pp + v21 * v21
            v26 = v16 * v16 + v22 * v22
            v27 = S2_mp * S2_mp + v23 * v23
            v28 = S2_mm * S2_mm + v24 * v24
            factor2_pp = math.sqrt(v25) * (1.0 / v25)
            factor2_pm = math.sqrt(v26) * (1.0 / v26)
            factor2_mp = math.sqrt(v27) * (1.0 / v27)
            factor2_mm = math.sqrt(v28) * (1.0 / v28)
            v29 = s3_p * S2_pp - v11 * v21
            v30 = v11 * v22 - s3_p * v16
            v31 = s3_m * S2_mp - v12 * v23
            v32 = s3_m * S2_mm + v12 * v24
            v33 = s3_p * v21 + v11 * S2_pp
            v34 = s3_p * v22 + v11 * v16
            v35 = s3_m * v23 + v12 * S2_mp
            v36 = s3_m * v24 - v12 * S2_mm
            v37 = T21 * s1_p - T11 * v2
            v38 = T21 * s1_m - T11 * v3
            X4_pp = v29 * v37 - T31 * v33
            X4_pm = v30 * v37 - T31 * v34
            X4_mp = v31 * v38 - T31 * v35
            X4_mm = v32 * v38 - T31 * v36
            v39 = T21 * v2 + T11 * s1_p
            v40 = T21 * v3 + T11 * s1_m
            v41 = v39 * v39
            v42 = v40 * v40
            v43 = v41 + factor2_pp * (X4_pp * (factor2_pp * X4_pp))
            v44 = v41 + factor2_pm * (X4_pm * (factor2_pm * X4_pm))
            v45 = v42 + factor2_mp * (X4_mp * (factor2_mp * X4_mp))
            v46 = v42 + factor2_mm * (X4_mm * (factor2_mm * X4_mm))
            v47 = s1_p * T12 + v2 * T22
            v48 = s1_m * T12 + v3 * T22
            v49 = s1_p * T22 - v2 * T12
            v50 = s1_m * T22 - v3 * T12
            v51 = v2 * T23 + s1_p * T13
            v52 = v3 * T23 + s1_m * T13
            v53 = s1_p * T23 - v2 * T13
            v54 = s1_m * T23 - v3 * T13
            v63 = math.copysign(half_turn, -v39)
            v64 = math.copysign(half_turn, -v40)
            work[272 + k] = D1
            work[288 + k] = D3_p
            work[304 + k] = D3_m
            work[320 + k] = v8
            work[336 + k] = w3_p
            work[352 + k] = w3_m
            work[368 + k] = s3_p
            work[384 + k] = s3_m
            work[400 + k] = v25
            work[416 + k] = v26
            work[432 + k] = v27
            work[448 + k] = v28
            work[464 + k] = v29
            work[480 + k] = v30
            work[496 + k] = v31
            work[512 + k] = v32
            work[528 + k] = v33
            work[544 + k] = v34
            work[560 + k] = v35
            work[576 + k] = v36
            work[592 + k] = X4_pp
            work[608 + k] = X4_pm
            work[624 + k] = X4_mp
            work[640 + k] = X4_mm
            work[656 + k] = v39
            work[672 + k] = v40
            work[688 + k] = v43
            work[704 + k] = v44
            work[720 + k] = v45
            work[736 + k] = v46
            work[752 + k] = v51
            work[768 + k] = v52
            work[784 + k] = v53
            work[800 + k] = v54
            work[816 + k] = v63
            work[832 + k] = v64
            work[848 + k] = -(v51 * -X4_pp + v39 * (v29 * v53 - v33 * T33))
            work[864 + k] = -(v51 * -X4_pm + v39 * (v30 * v53 - v34 * T33))
            work[880 + k] = -(v52 * -X4_mp + v40 * (v31 * v54 - v35 * T33))
            work[896 + k] = -(v52 * -X4_mm + v40 * (v32 * v54 - v36 * T33))
            work[912 + k] = S2_pp
            work[928 + k] = -v16
            work[944 + k] = S2_mp
            work[960 + k] = S2_mm
            work[976 + k] = s3_p
            work[992 + k] = s3_m
            work[1008 + k] = -v39
            work[1024 + k] = -v39
            work[1040 + k] = -v40
            work[1056 + k] = -v40
            work[1072 + k] = math.sqrt(v43)
            work[1088 + k] = math.sqrt(v44)
            work[1104 + k] = math.sqrt(v45)
            work[1120 + k] = math.sqrt(v46)
            work[1136 + k] = s1_p
            work[1152 + k] = s1_m
            work[1168 + k] = v47 * -X4_pp + v39 * (v29 * v49 - v33 * T32)
            work[1184 + k] = v47 * -X4_pm + v39 * (v30 * v49 - v34 * T32)
            work[1200 + k] = v48 * -X4_mp + v40 * (v31 * v50 - v35 * T32)
            work[1216 + k] = v48 * -X4_mm + v40 * (v32 * v50 - v36 * T32)
            work[1232 + k] = -v21
            work[1248 + k] = -v22
            work[1264 + k] = -v23
            work[1280 + k] = -v24
            work[1296 + k] = -v11
            work[1312 + k] = -v12
            work[1328 + k] = factor2_pp * -X4_pp
            work[1344 + k] = factor2_pm * -X4_pm
            work[1360 + k] = factor2_mp * -X4_mp
            work[1376 + k] = factor2_mm * -X4_mm
            work[1392 + k] = factor2_pp * (T31 * v29 + v33 * v37)
            work[1408 + k] = factor2_pm * (T31 * v30 + v34 * v37)
            work[1424 + k] = factor2_mp * (T31 * v31 + v35 * v38)
            work[1440 + k] = factor2_mm * (T31 * v32 + v36 * v38)
            work[1456 + k] = -v2
            work[1472 + k] = -v3
        for k in range(848, 1168):
            work[k] = _atan2(work[k], work[k + 320])
        for k in range(0, 16):
            T33 = work[160 + k]
            D1 = work[272 + k]
            D3_p = work[288 + k]
            D3_m = work[304 + k]
            v8 = work[320 + k]
            w3_p = work[336 + k]
            w3_m = work[352 + k]
            s3_p = work[368 + k]
            s3_m = work[384 + k]
            v25 = work[400 + k]
            v26 = work[416 + k]
            v27 = work[432 + k]
            v28 = work[448 + k]
            v29 = work[464 + k]
            v30 = work[480 + k]
            v31 = work[496 + k]
            v32 = work[512 + k]
            v33 = work[528 + k]
            v34 = work[544 + k]
            v35 = work[560 + k]
            v36 = work[576 + k]
            X4_pp = work[592 + k]
            X4_pm = work[608 + k]
            X4_mp = work[624 + k]
            X4_mm = work[640 + k]
            v39 = work[656 + k]
            v40 = work[672 + k]
            v43 = work[688 + k]
            v44 = work[704 + k]
            v45 = work[720 + k]
            v46 = work[736 + k]
            v51 = work[752 + k]
            v52 = work[768 + k]
            v53 = work[784 + k]
            v54 = work[800 + k]
            v63 = work[816 + k]
            v64 = work[832 + k]
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
            angle20 = work[1152 + k]
            q6_ppm = (
                angle1 - math.copysign(half_turn, -(v51 * -X4_pp + v39 * (v29 * v53 - v33 * T33)))
            )
            q6_pmm = (
                angle2 - math.copysign(half_turn, -(v51 * -X4_pm + v39 * (v30 * v53 - v34 * T33)))
            )
            q6_mpm = (
                angle3 - math.copysign(half_turn, -(v52 * -X4_mp + v40 * (v31 * v54 - v35 * T33)))
            )
            q6_mmm = (
                angle4 - math.copysign(half_turn, -(v52 * -X4_mm + v40 * (v32 * v54 - v36 * T33)))
            )
            v55 = angle5 - offset2
            v56 = angle6 - offset2
            v57 = angle7 - offset2
            v58 = angle8 - offset2
            q2_ppp = v55 + (-turn if half_turn < v55 else 0.0)
            q2_pmp = v56 + (-turn if half_turn < v56 else 0.0)
            q2_mpp = v57 + (-turn if half_turn < v57 else 0.0)
            q2_mmp = v58 + (-turn if half_turn < v58 else 0.0)
            v59 = angle9 - offset3
            v60 = math.copysign(half_turn, s3_p) - angle9 - offset3
            v61 = angle10 - offset3
            v62 = math.copysign(half_turn, s3_m) - angle10 - offset3
            q3_ppp = v59 + (turn if v59 <= -half_turn else 0.0)
            q3_pmp = v60 + (turn if v60 <= -half_turn else 0.0)
            q3_mpp = v61 + (turn if v61 <= -half_turn else 0.0)
            q3_mmp = v62 + (turn if v62 <= -half_turn else 0.0)
            v65 = angle11 - offset4
            v66 = angle11 - v63 - offset4
            v67 = angle12 - offset4
            v68 = angle12 - v63 - offset4
            v69 = angle13 - offset4
            v70 = angle13 - v64 - offset4
            v71 = angle14 - offset4
            v72 = angle14 - v64 - offset4
            q4_ppp = v65 + (turn if v65 <= -half_turn else 0.0)
            q4_ppm = v66 + (turn if v66 <= -half_turn else 0.0)
            q4_pmp = v67 + (turn if v67 <= -half_turn else 0.0)
            q4_pmm = v68 + (turn if v68 <= -half_turn else 0.0)
            q4_mpp = v69 + (turn if v69 <= -half_turn else 0.0)
            q4_mpm = v70 + (turn if v70 <= -half_turn else 0.0)
            q4_mmp = v71 + (turn if v71 <= -half_turn else 0.0)
            q4_mmm = v72 + (turn if v72 <= -half_turn else 0.0)
            v73 = angle15 - offset5
            v74 = offset5 + angle15
            v75 = angle16 - offset5
            v76 = offset5 + angle16
            v77 = angle17 - offset5
            v78 = offset5 + angle17
            v79 = angle18 - offset5
            v80 = offset5 + angle18
            q5_ppp = v73 + (turn if v73 <= -half_turn else 0.0)
            q5_ppm = (turn if -v74 <= -half_turn else 0.0) - v74
            q5_pmp = v75 + (turn if v75 <= -half_turn else 0.0)
            q5_pmm = (turn if -v76 <= -half_turn else 0.0) - v76
            q5_mpp = v77 + (turn if v77 <= -half_turn else 0.0)
            q5_mpm = (turn if -v78 <= -half_turn else 0.0) - v78
            q5_mmp = v79 + (turn if v79 <= -half_turn else 0.0)
            q5_mmm = (turn if -v80 <= -half_turn else 0.0) - v80
            q1_ppp = angle19 + (w3_p - w3_p)
            q1_mpp = angle20 + (w3_m - w3_m)
            v81 = max(max(low2 - q2_ppp, q2_ppp - high2), abs(q3_ppp) - high3)
            v82 = max(max(low2 - q2_pmp, q2_pmp - high2), abs(q3_pmp) - high3)
            v83 = max(max(low2 - q2_mpp, q2_mpp - high2), abs(q3_mpp) - high3)
            v84 = max(max(low2 - q2_mmp, q2_mmp - high2), abs(q3_mmp) - high3)
            excess_ppp = max(v81, max(low5 - q5_ppp, q5_ppp - high5))
            excess_ppm = max(v81, max(low5 - q5_ppm, q5_ppm - high5))
            excess_pmp = max(v82, max(low5 - q5_pmp, q5_pmp - high5))
            excess_pmm = max(v82, max(low5 - q5_pmm, q5_pmm - high5))
            excess_mpp = max(v83, max(low5 - q5_mpp, q5_mpp - high5))
            excess_mpm = max(v83, max(low5 - q5_mpm, q5_mpm - high5))
            excess_mmp = max(v84, max(low5 - q5_mmp, q5_mmp - high5))
            excess_mmm = max(v84, max(low5 - q5_mmm, q5_mmm - high5))
            outside_ppp = 0.0 < excess_ppp
            outside_ppm = 0.0 < excess_ppm
            outside_pmp = 0.0 < excess_pmp
            outside_pmm = 0.0 < excess_pmm
            outside_mpp = 0.0 < excess_mpp
            outside_mpm = 0.0 < excess_mpm
            outside_mmp = 0.0 < excess_mmp
            outside_mmm = 0.0 < excess_mmm
            _1488 = q1_ppp
            work[1488 + k] = _1488
            _1504 = q2_ppp
            work[1504 + k] = _1504
            _1520 = q3_ppp
            work[1520 + k] = _1520
            _1536 = q4_ppp
            work[1536 + k] = _1536
            _1552 = q5_ppp
            work[1552 + k] = _1552
            _1568 = angle1
            work[1568 + k] = _1568
            _1584 = q4_ppm
            work[1584 + k] = _1584
            _1600 = q5_ppm
            work[1600 + k] = _1600
            _1616 = q6_ppm
            work[1616 + k] = _1616
            _1632 = q2_pmp
            work[1632 + k] = _1632
            _1648 = q3_pmp
            work[1648 + k] = _1648
            _1664 = q4_pmp
            work[1664 + k] = _1664
            _1680 = q5_pmp
            work[1680 + k] = _1680
            _1696 = angle2
            work[1696 + k] = _1696
            _1712 = q4_pmm
            work[1712 + k] = _1712
            _1728 = q5_pmm
            work[1728 + k] = _1728
            _1744 = q6_pmm
            work[1744 + k] = _1744
            _1760 = q1_mpp
            work[1760 + k] = _1760
            _1776 = q2_mpp
            work[1776 + k] = _1776
            _1792 = q3_mpp
            work[1792 + k] = _1792
            _1808 = q4_mpp
            work[1808 + k] = _1808
            _1824 = q5_mpp
            work[1824 + k] = _1824
            _1840 = angle3
            work[1840 + k] = _1840
            _1856 = q4_mpm
            work[1856 + k] = _1856
            _1872 = q5_mpm
            work[1872 + k] = _1872
            _1888 = q6_mpm
            work[1888 + k] = _1888
            _1904 = q2_mmp
            work[1904 + k] = _1904
            _1920 = q3_mmp
            work[1920 + k] = _1920
            _1936 = q4_mmp
            work[1936 + k] = _1936
            _1952 = q5_mmp
            work[1952 + k] = _1952
            _1968 = angle4
            work[1968 + k] = _1968
            _1984 = q4_mmm
            work[1984 + k] = _1984
            _2000 = q5_mmm
            work[2000 + k] = _2000
            _2016 = q6_mmm
            work[2016 + k] = _2016
            work[2032 + k] = (
                UNREACHABLE if _1488 != _1488 else (OUT_OF_LIMITS if outside_ppp else OK)
            )
            work[2048 + k] = (
                UNREACHABLE if _1488 != _1488 else (OUT_OF_LIMITS if outside_ppm else OK)
            )
            work[2064 + k] = (
                UNREACHABLE if _1488 != _1488 else (OUT_OF_LIMITS if outside_pmp else OK)
            )
            work[2080 + k] = (
                UNREACHABLE if _1488 != _1488 else (OUT_OF_LIMITS if outside_pmm else OK)
            )
            work[2096 + k] = (
                UNREACHABLE if _1760 != _1760 else (OUT_OF_LIMITS if outside_mpp else OK)
            )
            work[2112 + k] = (
                UNREACHABLE if _1760 != _1760 else (OUT_OF_LIMITS if outside_mpm else OK)
            )
            work[2128 + k] = (
                UNREACHABLE if _1760 != _1760 else (OUT_OF_LIMITS if outside_mmp else OK)
            )
            work[2144 + k] = (
                UNREACHABLE if _1760 != _1760 else (OUT_OF_LIMITS if outside_mmm else OK)
            )
            work[256 + k] = (
                1.0 if v46 <= m7 or v28 <= m6 or v45 <= m7 or v27 <= m6 or v44 <= m7 or v26 <= m6 or
                v43 <= m7 or v25 <= m6 or abs(D3_m * v8) <= m2 or abs(D1) <= m1 or abs(D3_p * v8) <=
                m2 else work[256 + k]
            )
            work[256 + k] = (
                1.0 if abs(excess_mmm - graze) <= graze or abs(excess_mmp - graze) <= graze or
                abs(excess_mpm - graze) <= graze or abs(excess_mpp - graze) <= graze or
                abs(excess_pmm - graze) <= graze or abs(excess_pmp - graze) <= graze or
                abs(excess_ppp - graze) <= graze or abs(excess_ppm - graze) <= graze else work[256 +
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
