"""kinova_j2s6s300: Kinova Jaco j2s6s300, spherical wrist.

Inverse kinematics, generated from robots/kinova_j2s6s300.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kinova_j2s6s300.yaml. The formulas and where they come from:
kinova_j2s6s300.md.

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

NAME = "kinova_j2s6s300"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_LIMITS = (
    (-6.283185307179586, 6.283185307179586),
    (0.8203047484373349, 5.462880558742252),
    (0.33161255787892263, 5.951572749300664),
    (-6.283185307179586, 6.283185307179586),
    (0.5235987755982988, 5.759586531581287),
    (-6.283185307179586, 6.283185307179586),
)
BRANCHES = (
    "left-down-noflip",
    "left-down-flip",
    "left-up-noflip",
    "left-up-flip",
    "right-up-noflip",
    "right-up-flip",
    "right-down-noflip",
    "right-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.2755  # joint offset 1 [m]
d2 = 0.0016  # joint offset 2 [m]
a2 = 0.41  # link length 2 [m]
d3 = 0.0114  # joint offset 3 [m]
d4 = 0.31105  # joint offset 4 [m]
d6 = 0.26375  # joint offset 6 [m]
free_limit_squared2 = 1.6212928899999995e-24  # square of a length that fixes no angle [m^2]
least_root1 = 4.026528144692397e-07  # a root of nothing, by rounding [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
longest3 = 0.5199131025  # square of the longest reach [m^2]
shortest3 = 0.009791102499999996  # square of the shortest reach [m^2]
boundary3 = 9.367415598763348e-14  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.5199131024999816  # the longest, where branches merge [m^2]
shortest3_apart = 0.009791102500002518  # the shortest, where branches merge [m^2]
offset2 = 1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset3 = 1.5707963267948966  # offset of joint 3 [rad]
offset6 = -1.5707963267948966  # offset of joint 6 [rad]
k1 = -0.0098  # d2 - d3 [m]
k2 = 9.604000000000001e-05  # k1^2 [m^2]
k3 = 2.495668000016213e-15  # reach_slack1 * (reach_slack1 - k1 * 2) [m^2]
k4 = 2.4956680000016213e-16  # merge_slack1 * (merge_slack1 - k1 * 2) [m^2]
k5 = 0.7853608733212912  # 1 / arm_size1 [m^-1]
k6 = 0.255061  # 2 * d4 * a2 [m^2]
k7 = 0.26485210249999996  # a2^2 + d4^2 [m^2]
k8 = 15.371345486276748  # 1 / (k6^2) [m^-4]
low2 = 0.820304747437335
high2 = 5.462880559742252
low3 = 0.3316125568789226
high3 = 5.951572750300664
low5 = 0.5235987745982988
high5 = 5.759586532581287
graze = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 2.4956680000016215e-13  # 1000 * k4 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 9.401396550145706e-12
m3 = 1.2195121951219514  # a coefficient of S2
m4 = 0.08700963109756096  # a coefficient of S2
m5 = 2.628590635164551e-16  # doubt_limit_squared2^2 [m^4]
m6 = 9.999999999999999e-09  # doubt_limit^2

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
    v3 = s1 * c2
    y2_x = c1 * s2
    v4 = s1 * s2
    v5 = q[2] + offset3
    c3 = math.cos(v5)
    s3 = math.sin(v5)
    x3_x = x2_x * c3 + y2_x * s3
    v6 = v3 * c3 + v4 * s3
    x3_z = c2 * s3 - s2 * c3
    v7 = c2 * c3 + s2 * s3
    z3_x = x2_x * s3 - y2_x * c3
    z3_y = v4 * c3 - v3 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - s1 * s4
    v8 = v6 * c4 + c1 * s4
    x4_z = x3_z * c4
    z4_x = s1 * c4 + x3_x * s4
    z4_z = x3_z * s4
    z4_y = c1 * c4 - v6 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 + z3_x * s5
    x5_y = z3_y * s5 - v8 * c5
    x5_z = x4_z * c5 - v7 * s5
    z6_x = z3_x * c5 - x4_x * s5
    z6_y = z3_y * c5 + v8 * s5
    z5_z = v7 * c5 + x4_z * s5
    v9 = q[5] + offset6
    c6 = math.cos(v9)
    s6 = math.sin(v9)
    T[0, 0] = x5_x * c6 + z4_x * s6
    T[0, 1] = x5_x * s6 - z4_x * c6
    T[0, 2] = z6_x
    T[0, 3] = x2_x * a2 - s1 * d2 + s1 * d3 - z3_x * d4 - -z6_x * d6
    T[1, 0] = x5_y * c6 + z4_y * s6
    T[1, 1] = x5_y * s6 - z4_y * c6
    T[1, 2] = z6_y
    T[1, 3] = c1 * d3 - (v3 * a2 + c1 * d2) - z3_y * d4 + z6_y * d6
    T[2, 0] = x5_z * c6 + z4_z * s6
    T[2, 1] = x5_z * s6 - z4_z * c6
    T[2, 2] = -z5_z
    T[2, 3] = d1 - s2 * a2 + v7 * d4 - z5_z * d6
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
    v3 = s1 * c2
    y2_x = c1 * s2
    v4 = s1 * s2
    p2_z = d1 - s2 * a2
    p2_x = x2_x * a2 - s1 * d2
    v5 = v3 * a2 + c1 * d2
    v6 = q[2] + offset3
    c3 = math.cos(v6)
    s3 = math.sin(v6)
    x3_x = x2_x * c3 + y2_x * s3
    v7 = v3 * c3 + v4 * s3
    x3_z = c2 * s3 - s2 * c3
    v8 = c2 * c3 + s2 * s3
    p3_x = p2_x + s1 * d3
    p3_y = c1 * d3 - v5
    z3_x = x2_x * s3 - y2_x * c3
    z3_y = v4 * c3 - v3 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    z4_x = s1 * c4 + x3_x * s4
    z4_z = x3_z * s4
    p4_x = p3_x - z3_x * d4
    p4_y = p3_y - z3_y * d4
    p4_z = p2_z + v8 * d4
    z4_y = c1 * c4 - v7 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    z6_y = z3_y * c5 + (v7 * c4 + c1 * s4) * s5
    z5_z = v8 * c5 + x3_z * c4 * s5
    z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5
    p6_x = p4_x - z5_x * d6
    p6_y = p4_y + z6_y * d6
    p6_z = p4_z - z5_z * d6
    v9 = p6_z - d1
    v10 = p6_z - p2_z
    v11 = p6_x - p3_x
    v12 = p6_y - p3_y
    v13 = p6_x - p4_x
    v14 = p6_y - p4_y
    v15 = p6_z - p4_z
    J[0, 0] = p6_y
    J[0, 1] = c1 * v9
    J[0, 2] = -(c1 * v10)
    J[0, 3] = z3_y * v10 + v8 * v12
    J[0, 4] = z4_y * v15 - z4_z * v14
    J[0, 5] = -(z6_y * v15 + z5_z * v14)
    J[1, 0] = -p6_x
    J[1, 1] = -(s1 * v9)
    J[1, 2] = s1 * v10
    J[1, 3] = -(v8 * v11 + z3_x * v10)
    J[1, 4] = z4_z * v13 - z4_x * v15
    J[1, 5] = z5_z * v13 - z5_x * v15
    J[2, 1] = s1 * p6_y - c1 * p6_x
    J[2, 2] = c1 * (p6_x - p2_x) - s1 * (v5 + p6_y)
    J[2, 3] = z3_x * v12 - z3_y * v11
    J[2, 4] = z4_x * v14 - z4_y * v13
    J[2, 5] = z5_x * v14 + z6_y * v13
    J[3, 1] = s1
    J[3, 2] = -s1
    J[3, 3] = z3_x
    J[3, 4] = z4_x
    J[3, 5] = z5_x
    J[4, 1] = c1
    J[4, 2] = -c1
    J[4, 3] = z3_y
    J[4, 4] = z4_y
    J[4, 5] = -z6_y
    J[5, 0] = -1.0
    J[5, 3] = -v8
    J[5, 4] = z4_z
    J[5, 5] = z5_z
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1 A6^-1 [3, 4]
    X1 = T13 * d6 - T14
    wy = d6 * T23 - T24
    N1 = X1 * X1 + wy * wy
    free1 = N1 <= free_limit_squared2
    D1 = N1 - k2
    apart1 = k4 < D1
    if not (-k3 <= D1):
        return  # out of reach
    w1 = math.sqrt(D1 if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else -(k1 * math.sqrt(N1))))
    v1 = X1 * k1
    v2 = wy * k1
    v3 = seed[0] + offset1

    # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = d6 * T33 - T34
    Z1_3 = wz + d1
    v4 = Z1_3 * Z1_3
    v5 = 1.0 if free1 else (w1 if apart1 else least_root1) * k5

    # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    v9 = seed[1] + offset2

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        root1 = w1 * e1
        c1 = math.cos(v3) if free1 else inverse1 * (v2 - X1 * root1)
        s1 = math.sin(v3) if free1 else inverse1 * (v1 + wy * root1)

        # theta3
        N3 = v4 + root1 * root1
        K3 = N3 - k7
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= D3 * v5):
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        v6 = k6 * K3 * k8

        # theta2
        X1_2 = a2 + d4 * v6
        v7 = Z1_3 * X1_2
        v8 = root1 * X1_2

        # theta4, type 2: U4[3, 3]
        v10 = T13 * c1 - T23 * s1
        v11 = T23 * c1 + T13 * s1
        v12 = v11 * v11

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v13 = T22 * c1 + T12 * s1
        v14 = T12 * c1 - T22 * s1
        v16 = T21 * c1 + T11 * s1
        v17 = T11 * c1 - T21 * s1

        # joint values
        q1 = _wrap(_atan2(s1, c1) - offset1)

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            c3 = k8 * (k6 * (w3 * e2))

            # theta2
            X2_2 = d4 * c3
            S2 = v7 + root1 * X2_2
            C2 = v8 - Z1_3 * X2_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v9) if free2 else C2 * factor2
            s2 = math.sin(v9) if free2 else S2 * factor2

            # theta4
            c2m3 = c3 * c2 - v6 * s2
            s2m3 = c3 * s2 + v6 * c2
            X4 = T33 * s2m3 - c2m3 * v10
            w4 = math.sqrt(X4 * X4 + v12)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta6
            v15 = c2m3 * v14 - T32 * s2m3
            v18 = c2m3 * v17 - T31 * s2m3

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(-v6, c3) - offset3)

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4
                if e3 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e3 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else -(v11 * factor4)
                q4 = _atan2(s4, c4)

                # theta5, type 3: U4[2, 3] and U4[1, 3]
                q5 = _atan2(-(w4 * e3), -(T33 * c2m3 + s2m3 * v10))

                # theta6
                s6 = c4 * v16 + s4 * v18

                # joint values
                q6 = _wrap(_atan2(s6, -(c4 * v13 + s4 * v15)) - offset6)
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
_MISS_WEIGHT = np.array([0.7854, 0.7854, 0.7854, 1.0, 1.0, 1.0])


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
    wy = d6 * T23 - T24
    N1 = X1 * X1 + wy * wy
    D1 = N1 - k2
    w1 = math.sqrt(D1)
    v1 = w1 - w1
    inverse1 = 1.0 / N1
    v2 = inverse1 * (k1 * wy)
    c1_p = v2 - w1 * (X1 * inverse1)
    c1_m = v2 - w1 * (inverse1 * -X1)
    v3 = inverse1 * (k1 * X1)
    s1_p = v3 + w1 * (wy * inverse1)
    s1_m = v3 + w1 * (inverse1 * -wy)

    # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    Z1_3 = d1 + (d6 * T33 - T34)
    N3 = D1 + Z1_3 * Z1_3
    D3 = (longest3 - N3) * (N3 - shortest3)
    w3 = math.sqrt(D3)
    v4 = w3 - w3
    v5 = k6 * (N3 - k7)
    v6 = k8 * v5
    v7 = k6 * w3
    c3 = k8 * v7

    # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    X1_2 = a2 + d4 * v6
    X2_2 = d4 * c3
    v8 = Z1_3 * X1_2
    v9 = w1 * X2_2
    v10 = v8 + v9
    v11 = v8 - v9
    v12 = m4 + m3 * N3
    v13 = Z1_3 * v12
    v14 = w3 * (m3 * w1)
    S2_pp = v13 + v14
    S2_pm = v13 - v14
    v15 = w1 * X1_2
    v16 = Z1_3 * X2_2
    v17 = v15 - v16
    v18 = v15 + v16
    v19 = w3 * (m3 * Z1_3)
    v20 = w1 * v12
    C2_pp = v20 - v19
    C2_pm = v19 + v20
    v21 = S2_pp * S2_pp
    v22 = v21 + C2_pp * C2_pp
    v23 = S2_pm * S2_pm + C2_pm * C2_pm
    v24 = v21 + -C2_pp * -C2_pp
    w2_pp = math.sqrt(v22)
    w2_pm = math.sqrt(v23)
    w2_mm = math.sqrt(v24)
    v25 = 1.0 / v22
    v26 = 1.0 / v23
    v27 = 1.0 / v24

    # theta4, type 2: U4[3, 3]
    v28 = v6 * v10
    c2m3_pp = w2_pp * (v25 * (c3 * v17 - v28))
    v29 = w2_pm * (v26 * (c3 * v18 + v6 * v11))
    v30 = w2_mm * (v27 * (v28 + c3 * -v17))
    v31 = c3 * v10
    s2m3_pp = w2_pp * (v25 * (v31 + v6 * v17))
    v32 = v6 * v18 - c3 * v11
    s2m3_pm = w2_pm * (v26 * v32)
    s2m3_mp = w2_pm * (v26 * -v32)
    s2m3_mm = w2_mm * (v27 * (v6 * -v17 - v31))
    v33 = T13 * c1_p - T23 * s1_p
    v34 = T13 * c1_m - T23 * s1_m
    X4_pp = T33 * s2m3_pp - c2m3_pp * v33
    X4_pm = T33 * s2m3_pm + v29 * v33
    X4_mp = T33 * s2m3_mp + v29 * v34
    X4_mm = T33 * s2m3_mm + v30 * v34
    v35 = T23 * c1_p + T13 * s1_p
    v36 = T23 * c1_m + T13 * s1_m
    v37 = v35 * v35
    v38 = v36 * v36
    v39 = v37 + X4_pp * X4_pp
    v40 = v37 + X4_pm * X4_pm
    v41 = v38 + X4_mp * X4_mp
    v42 = v38 + X4_mm * X4_mm
    v43 = math.copysign(half_turn, -v35)
    v44 = math.copysign(half_turn, -v36)

    # theta5, type 3: U4[2, 3] and U4[1, 3]
    v45 = T33 * v29

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v46 = c1_p * T22 + s1_p * T12
    v47 = c1_m * T22 + s1_m * T12
    v48 = c1_p * T12 - s1_p * T22
    v49 = c1_m * T12 - s1_m * T22
    v50 = c1_p * T21 + s1_p * T11
    v51 = c1_m * T21 + s1_m * T11
    v52 = c1_p * T11 - s1_p * T21
    v53 = c1_m * T11 - s1_m * T21
    s6_pp = -X4_pp * v50 - v35 * (c2m3_pp * v52 - s2m3_pp * T31)
    s6_pm = v35 * (v29 * v52 + s2m3_pm * T31) - X4_pm * v50
    s6_mp = v36 * (v29 * v53 + s2m3_mp * T31) - X4_mp * v51
    s6_mm = v36 * (v30 * v53 + s2m3_mm * T31) - X4_mm * v51

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if (
        v42 <= m6 or v24 <= m5 or v41 <= m6 or v40 <= m6 or v23 <= m5 or v39 <= m6 or abs(D1) <= m1
        or abs(D3 * (k5 * w1)) <= m2 or v22 <= m5
    ):
        return False

    # angles, side by side
    room[0] = -v35
    room[1] = -v35
    room[2] = -v36
    room[3] = -v36
    room[4] = -math.sqrt(v39)
    room[5] = -math.sqrt(v40)
    room[6] = -math.sqrt(v41)
    room[7] = -math.sqrt(v42)
    room[8] = s1_p
    room[9] = s1_m
    room[10] = S2_pp
    room[11] = S2_pm
    room[12] = S2_pm
    room[13] = S2_pp
    room[14] = -v5
    room[15] = s6_pp
    room[16] = s6_pm
    room[17] = s6_mp
    room[18] = s6_mm
    room[24] = -X4_pp
    room[25] = -X4_pm
    room[26] = -X4_mp
    room[27] = -X4_mm
    room[28] = -(T33 * c2m3_pp + s2m3_pp * v33)
    room[29] = v45 - s2m3_pm * v33
    room[30] = v45 - s2m3_mp * v34
    room[31] = T33 * v30 - s2m3_mm * v34
    room[32] = c1_p
    room[33] = c1_m
    room[34] = C2_pp
    room[35] = C2_pm
    room[36] = -C2_pm
    room[37] = -C2_pp
    room[38] = v7
    room[39] = v35 * (c2m3_pp * v48 - s2m3_pp * T32) - -X4_pp * v46
    room[40] = X4_pm * v46 - v35 * (v29 * v48 + s2m3_pm * T32)
    room[41] = X4_mp * v47 - v36 * (v29 * v49 + s2m3_mp * T32)
    room[42] = X4_mm * v47 - v36 * (v30 * v49 + s2m3_mm * T32)
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

    # theta4, type 2: U4[3, 3]
    q4_ppm = angle1 - v43
    q4_pmm = angle2 - v43
    q4_mpm = angle3 - v44
    q4_mmm = angle4 - v44

    # joint values
    v54 = angle9 - offset1
    v55 = angle10 - offset1
    v56 = angle11 - offset2
    v57 = angle12 - offset2
    v58 = angle13 - offset2
    v59 = angle14 - offset2
    q2__pp = v56 + (turn if v56 <= -half_turn else 0.0)
    q2__pm = v57 + (turn if v57 <= -half_turn else 0.0)
    q2__mp = v58 + (turn if v58 <= -half_turn else 0.0)
    q2__mm = v59 + (turn if v59 <= -half_turn else 0.0)
    v60 = angle15 - offset3
    v61 = math.copysign(half_turn, -v5) - angle15 - offset3
    q3__p = v60 + (turn if v60 <= -half_turn else 0.0)
    q3__m = v61 + (turn if v61 <= -half_turn else 0.0)
    v62 = angle16 - offset6
    v63 = angle16 - math.copysign(half_turn, s6_pp) - offset6
    v64 = angle17 - offset6
    v65 = angle17 - math.copysign(half_turn, s6_pm) - offset6
    v66 = angle18 - offset6
    v67 = angle18 - math.copysign(half_turn, s6_mp) - offset6
    v68 = angle19 - offset6
    v69 = angle19 - math.copysign(half_turn, s6_mm) - offset6
    q6_ppp = v62 + (-turn if half_turn < v62 else 0.0)
    q6_ppm = v63 + (-turn if half_turn < v63 else 0.0)
    q6_pmp = v64 + (-turn if half_turn < v64 else 0.0)
    q6_pmm = v65 + (-turn if half_turn < v65 else 0.0)
    q6_mpp = v66 + (-turn if half_turn < v66 else 0.0)
    q6_mpm = v67 + (-turn if half_turn < v67 else 0.0)
    q6_mmp = v68 + (-turn if half_turn < v68 else 0.0)
    q6_mmm = v69 + (-turn if half_turn < v69 else 0.0)
    v70 = q2__pp + (turn if q2__pp < low2 else 0.0)
    v71 = q2__pm + (turn if q2__pm < low2 else 0.0)
    v72 = q2__mp + (turn if q2__mp < low2 else 0.0)
    v73 = q2__mm + (turn if q2__mm < low2 else 0.0)
    v74 = max(low2 - v70, v70 - high2)
    v75 = max(low2 - v71, v71 - high2)
    v76 = max(low2 - v72, v72 - high2)
    v77 = max(low2 - v73, v73 - high2)
    v78 = low2 - q2__pp
    v79 = low2 - q2__pm
    v80 = low2 - q2__mp
    v81 = low2 - q2__mm
    v82 = v78 if v78 < v74 else v74
    v83 = v79 if v79 < v75 else v75
    v84 = v80 if v80 < v76 else v76
    v85 = v81 if v81 < v77 else v77
    q2_ppp = q2__pp if 0.0 < v82 else v70
    q2_pmp = q2__pm if 0.0 < v83 else v71
    q2_mpp = q2__mp if 0.0 < v84 else v72
    q2_mmp = q2__mm if 0.0 < v85 else v73
    v86 = q3__p + (turn if q3__p < low3 else 0.0)
    v87 = q3__m + (turn if q3__m < low3 else 0.0)
    v88 = max(low3 - v86, v86 - high3)
    v89 = max(low3 - v87, v87 - high3)
    v90 = low3 - q3__p
    v91 = low3 - q3__m
    v92 = v90 if v90 < v88 else v88
    v93 = v91 if v91 < v89 else v89
    v94 = angle5 + (turn if angle5 < low5 else 0.0)
    v95 = (turn if -angle5 < low5 else 0.0) - angle5
    v96 = angle6 + (turn if angle6 < low5 else 0.0)
    v97 = (turn if -angle6 < low5 else 0.0) - angle6
    v98 = angle7 + (turn if angle7 < low5 else 0.0)
    v99 = (turn if -angle7 < low5 else 0.0) - angle7
    v100 = angle8 + (turn if angle8 < low5 else 0.0)
    v101 = (turn if -angle8 < low5 else 0.0) - angle8
    v102 = max(low5 - v94, v94 - high5)
    v103 = max(low5 - v95, v95 - high5)
    v104 = max(low5 - v96, v96 - high5)
    v105 = max(low5 - v97, v97 - high5)
    v106 = max(low5 - v98, v98 - high5)
    v107 = max(low5 - v99, v99 - high5)
    v108 = max(low5 - v100, v100 - high5)
    v109 = max(low5 - v101, v101 - high5)
    v110 = low5 - angle5
    v111 = low5 + angle5
    v112 = low5 - angle6
    v113 = low5 + angle6
    v114 = low5 - angle7
    v115 = low5 + angle7
    v116 = low5 - angle8
    v117 = low5 + angle8
    v118 = v110 if v110 < v102 else v102
    v119 = v111 if v111 < v103 else v103
    v120 = v112 if v112 < v104 else v104
    v121 = v113 if v113 < v105 else v105
    v122 = v114 if v114 < v106 else v106
    v123 = v115 if v115 < v107 else v107
    v124 = v116 if v116 < v108 else v108
    v125 = v117 if v117 < v109 else v109
    q5_ppp = angle5 if 0.0 < v118 else v94
    q5_ppm = -angle5 if 0.0 < v119 else v95
    q5_pmp = angle6 if 0.0 < v120 else v96
    q5_pmm = -angle6 if 0.0 < v121 else v97
    q5_mpp = angle7 if 0.0 < v122 else v98
    q5_mpm = -angle7 if 0.0 < v123 else v99
    q5_mmp = angle8 if 0.0 < v124 else v100
    q5_mmm = -angle8 if 0.0 < v125 else v101
    q1_ppp = v4 + (v54 + (turn if v54 <= -half_turn else 0.0))
    q1_mpp = v4 + (v55 + (turn if v55 <= -half_turn else 0.0))
    q3_ppp = v1 + (q3__p if 0.0 < v92 else v86)
    q3_pmp = v1 + (q3__m if 0.0 < v93 else v87)
    v126 = max(v82, v92)
    v127 = max(v83, v93)
    v128 = max(v84, v92)
    v129 = max(v85, v93)
    excess_ppp = max(v118, v126)
    excess_ppm = max(v119, v126)
    excess_pmp = max(v120, v127)
    excess_pmm = max(v121, v127)
    excess_mpp = max(v122, v128)
    excess_mpm = max(v123, v128)
    excess_mmp = max(v124, v129)
    excess_mmm = max(v125, v129)
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
    q[0, 3] = angle1
    q[0, 4] = q5_ppp
    q[0, 5] = q6_ppp
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
    q[2, 3] = angle2
    q[2, 4] = q5_pmp
    q[2, 5] = q6_pmp
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
    q[4, 2] = q3_ppp
    q[4, 3] = angle3
    q[4, 4] = q5_mpp
    q[4, 5] = q6_mpp
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else (OUT_OF_LIMITS if outside_mpp else OK)
    q[5, 0] = q1_mpp
    q[5, 1] = q2_mpp
    q[5, 2] = q3_ppp
    q[5, 3] = q4_mpm
    q[5, 4] = q5_mpm
    q[5, 5] = q6_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else (OUT_OF_LIMITS if outside_mpm else OK)
    q[6, 0] = q1_mpp
    q[6, 1] = q2_mmp
    q[6, 2] = q3_pmp
    q[6, 3] = angle4
    q[6, 4] = q5_mmp
    q[6, 5] = q6_mmp
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else (OUT_OF_LIMITS if outside_mmp else OK)
    q[7, 0] = q1_mpp
    q[7, 1] = q2_mmp
    q[7, 2] = q3_pmp
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
    [1184, 1200, 1216, 1232, 1248, 1264],
    [1184, 1200, 1216, 1280, 1296, 1312],
    [1184, 1328, 1344, 1360, 1376, 1392],
    [1184, 1328, 1344, 1408, 1424, 1440],
    [1456, 1472, 1216, 1488, 1504, 1520],
    [1456, 1472, 1216, 1536, 1552, 1568],
    [1456, 1584, 1344, 1600, 1616, 1632],
    [1456, 1584, 1344, 1648, 1664, 1680],
])
_KINDS = np.array([1696, 1712, 1728, 1744, 1760, 1776, 1792, 1808])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(1824), 1824)
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
            wy = d6 * T23 - T24
            N1 = X1 * X1 + wy * wy
            D1 = N1 - k2
            w1 = math.sqrt(D1)
            v1 = w1 - w1
            inverse1 = 1.0 / N1
            v2 = inverse1 * (k1 * wy)
            c1_p = v2 - w1 * (X1 * inverse1)
            c1_m = v2 - w1 * (inverse1 * -X1)
            v3 = inverse1 * (k1 * X1)
            s1_p = v3 + w1 * (wy * inverse1)
            s1_m = v3 + w1 * (inverse1 * -wy)
            Z1_3 = d1 + (d6 * T33 - T34)
            N3 = D1 + Z1_3 * Z1_3
            D3 = (longest3 - N3) * (N3 - shortest3)
            w3 = math.sqrt(D3)
            v4 = w3 - w3
            v5 = k6 * (N3 - k7)
            v6 = k8 * v5
            v7 = k6 * w3
            c3 = k8 * v7
            X1_2 = a2 + d4 * v6
            X2_2 = d4 * c3
            v8 = Z1_3 * X1_2
            v9 = w1 * X2_2
            v10 = v8 + v9
            v11 = v8 - v9
            v12 = m4 + m3 * N3
            v13 = Z1_3 * v12
            v14 = w3 * (m3 * w1)
            S2_pp = v13 + v14
            S2_pm = v13 - v14
            v15 = w1 * X1_2
            v16 = Z1_3 * X2_2
            v17 = v15 - v16
            v18 = v15 + v16
            v19 = w3 * (m3 * Z1_3)
            v20 = w1 * v12
            C2_pp = v20 - v19
            C2_pm = v19 + v20
            v21 = S2_pp * S2_pp
            v22 = v21 + C2_pp * C2_pp
            v23 = S2_pm * S2_pm + C2_pm * C2_pm
            v24 = v21 + -C2_pp * -C2_pp
            w2_pp = math.sqrt(v22)
            w2_pm = math.sqrt(v23)
            w2_mm = math.sqrt(v24)
            v25 = 1.0 / v22
            v26 = 1.0 / v23
            v27 = 1.0 / v24
            v28 = v6 * v10
            c2m3_pp = w2_pp * (v25 * (c3 * v17 - v28))
            v29 = w2_pm * (v26 * (c3 * v18 + v6 * v11))
            v30 = w2_mm * (v27 * (v28 + c3 * -v17))
            v31 = c3 * v10
            s2m3_pp = w2_pp * (v25 * (v31 + v6 * v17))
            v32 = v6 * v18 - c3 * v11
            s2m3_pm = w2_pm * (v26 * v32)
            s2m3_mp = w2_pm * (v26 * -v32)
            s2m3_mm = w2_mm * (v27 * (v6 * -v17 - v31))
            v33 = T13 * c1_p - T23 * s1_p
            v34 = T13 * c1_m - T23 * s1_m
            X4_pp = T33 * s2m3_pp - c2m3_pp * v33
            X4_pm = T33 * s2m3_pm + v29 * v33
            X4_mp = T33 * s2m3_mp + v29 * v34
            X4_mm = T33 * s2m3_mm + v30 * v34
            v35 = T23 * c1_p + T13 * s1_p
            v36 = T23 * c1_m + T13 * s1_m
            v37 = v35 * v35
            v38 = v36 * v36
            v39 = v37 + X4_pp * X4_pp
            v40 = v37 + X4_pm * X4_pm
            v41 = v38 + X4_mp * X4_mp
            v42 = v38 + X4_mm * X4_mm
            v43 = math.copysign(half_turn, -v35)
            v44 = math.copysign(half_turn, -v36)
            v45 = T33 * v29
            v46 = c1_p * T22 + s1_p * T12
            v47 = c1_m * T22 + s1_m * T12
            v48 = c1_p * T12 - s1_p * T22
            v49 = c1_m * T12 - s1_m * T22
            v50 = c1_p * T21 + s1_p * T11
            v51 = c1_m * T21 + s1_m * T11
            v52 = c1_p * T11 - s1_p * T21
            v53 = c1_m * T11 - s1_m * T21
            s6_pp = -X4_pp * v50 - v35 * (c2m3_pp * v52 - s2m3_pp * T31)
            s6_pm = v35 * (v29 * v52 + s2m3_pm * T31) - X4_pm * v50
            s6_mp = v36 * (v29 * v53 + s2m3_mp * T31) - X4_mp * v51
            s6_mm = v36 * (v30 * v53 + s2m3_mm * T31) - X4_mm * v51
            work[272 + k] = D1
            work[288 + k] = w1
            work[304 + k] = v1
            work[320 + k] = D3
            work[336 + k] = v4
            work[352 + k] = v5
            work[368 + k] = v22
            work[384 + k] = v23
            work[400 + k] = v24
            work[416 + k] = v39
            work[432 + k] = v40
            work[448 + k] = v41
            work[464 + k] = v42
            work[480 + k] = v43
            work[496 + k] = v44
            work[512 + k] = s6_pp
            work[528 + k] = s6_pm
            work[544 + k] = s6_mp
            work[560 + k] = s6_mm
            work[576 + k] = -v35
            work[592 + k] = -v35
            work[608 + k] = -v36
            work[624 + k] = -v36
            work[640 + k] = -math.sqrt(v39)
            work[656 + k] = -math.sqrt(v40)
            work[672 + k] = -math.sqrt(v41)
            work[688 + k] = -math.sqrt(v42)
            work[704 + k] = s1_p
            work[720 + k] = s1_m
            work[736 + k] = S2_pp
            work[752 + k] = S2_pm
            work[768 + k] = S2_pm
            work[784 + k] = S2_pp
            work[800 + k] = -v5
            work[816 + k] = s6_pp
            work[832 + k] = s6_pm
            work[848 + k] = s6_mp
            work[864 + k] = s6_mm
            work[880 + k] = -X4_pp
            work[896 + k] = -X4_pm
            work[912 + k] = -X4_mp
            work[928 + k] = -X4_mm
            work[944 + k] = -(T33 * c2m3_pp + s2m3_pp * v33)
            work[960 + k] = v45 - s2m3_pm * v33
            work[976 + k] = v45 - s2m3_mp * v34
            work[992 + k] = T33 * v30 - s2m3_mm * v34
            work[1008 + k] = c1_p
            work[1024 + k] = c1_m
            work[1040 + k] = C2_pp
            work[1056 + k] = C2_pm
            work[1072 + k] = -C2_pm
            work[1088 + k] = -C2_pp
            work[1104 + k] = v7
            work[1120 + k] = v35 * (c2m3_pp * v48 - s2m3_pp * T32) - -X4_pp * v46
            work[1136 + k] = X4_pm * v46 - v35 * (v29 * v48 + s2m3_pm * T32)
            work[1152 + k] = X4_mp * v47 - v36 * (v29 * v49 + s2m3_mp * T32)
            work[1168 + k] = X4_mm * v47 - v36 * (v30 * v49 + s2m3_mm * T32)
        for k in range(576, 880):
            work[k] = _atan2(work[k], work[k + 304])
        for k in range(0, 16):
            D1 = work[272 + k]
            w1 = work[288 + k]
            v1 = work[304 + k]
            D3 = work[320 + k]
            v4 = work[336 + k]
            v5 = work[352 + k]
            v22 = work[368 + k]
            v23 = work[384 + k]
            v24 = work[400 + k]
            v39 = work[416 + k]
            v40 = work[432 + k]
            v41 = work[448 + k]
            v42 = work[464 + k]
            v43 = work[480 + k]
            v44 = work[496 + k]
            s6_pp = work[512 + k]
            s6_pm = work[528 + k]
            s6_mp = work[544 + k]
            s6_mm = work[560 + k]
            angle1 = work[576 + k]
            angle2 = work[592 + k]
            angle3 = work[608 + k]
            angle4 = work[624 + k]
            angle5 = work[640 + k]
            angle6 = work[656 + k]
            angle7 = work[672 + k]
            angle8 = work[688 + k]
            angle9 = work[704 + k]
            angle10 = work[720 + k]
            angle11 = work[736 + k]
            angle12 = work[752 + k]
            angle13 = work[768 + k]
            angle14 = work[784 + k]
            angle15 = work[800 + k]
            angle16 = work[816 + k]
            angle17 = work[832 + k]
            angle18 = work[848 + k]
            angle19 = work[864 + k]
            q4_ppm = angle1 - v43
            q4_pmm = angle2 - v43
            q4_mpm = angle3 - v44
            q4_mmm = angle4 - v44
            v54 = angle9 - offset1
            v55 = angle10 - offset1
            v56 = angle11 - offset2
            v57 = angle12 - offset2
            v58 = angle13 - offset2
            v59 = angle14 - offset2
            q2__pp = v56 + (turn if v56 <= -half_turn else 0.0)
            q2__pm = v57 + (turn if v57 <= -half_turn else 0.0)
            q2__mp = v58 + (turn if v58 <= -half_turn else 0.0)
            q2__mm = v59 + (turn if v59 <= -half_turn else 0.0)
            v60 = angle15 - offset3
            v61 = math.copysign(half_turn, -v5) - angle15 - offset3
            q3__p = v60 + (turn if v60 <= -half_turn else 0.0)
            q3__m = v61 + (turn if v61 <= -half_turn else 0.0)
            v62 = angle16 - offset6
            v63 = angle16 - math.copysign(half_turn, s6_pp) - offset6
            v64 = angle17 - offset6
            v65 = angle17 - math.copysign(half_turn, s6_pm) - offset6
            v66 = angle18 - offset6
            v67 = angle18 - math.copysign(half_turn, s6_mp) - offset6
            v68 = angle19 - offset6
            v69 = angle19 - math.copysign(half_turn, s6_mm) - offset6
            q6_ppp = v62 + (-turn if half_turn < v62 else 0.0)
            q6_ppm = v63 + (-turn if half_turn < v63 else 0.0)
            q6_pmp = v64 + (-turn if half_turn < v64 else 0.0)
            q6_pmm = v65 + (-turn if half_turn < v65 else 0.0)
            q6_mpp = v66 + (-turn if half_turn < v66 else 0.0)
            q6_mpm = v67 + (-turn if half_turn < v67 else 0.0)
            q6_mmp = v68 + (-turn if half_turn < v68 else 0.0)
            q6_mmm = v69 + (-turn if half_turn < v69 else 0.0)
            v70 = q2__pp + (turn if q2__pp < low2 else 0.0)
            v71 = q2__pm + (turn if q2__pm < low2 else 0.0)
            v72 = q2__mp + (turn if q2__mp < low2 else 0.0)
            v73 = q2__mm + (turn if q2__mm < low2 else 0.0)
            v74 = max(low2 - v70, v70 - high2)
            v75 = max(low2 - v71, v71 - high2)
            v76 = max(low2 - v72, v72 - high2)
            v77 = max(low2 - v73, v73 - high2)
            v78 = low2 - q2__pp
            v79 = low2 - q2__pm
            v80 = low2 - q2__mp
            v81 = low2 - q2__mm
            v82 = v78 if v78 < v74 else v74
            v83 = v79 if v79 < v75 else v75
            v84 = v80 if v80 < v76 else v76
            v85 = v81 if v81 < v77 else v77
            q2_ppp = q2__pp if 0.0 < v82 else v70
            q2_pmp = q2__pm if 0.0 < v83 else v71
            q2_mpp = q2__mp if 0.0 < v84 else v72
            q2_mmp = q2__mm if 0.0 < v85 else v73
            v86 = q3__p + (turn if q3__p < low3 else 0.0)
            v87 = q3__m + (turn if q3__m < low3 else 0.0)
            v88 = max(low3 - v86, v86 - high3)
            v89 = max(low3 - v87, v87 - high3)
            v90 = low3 - q3__p
            v91 = low3 - q3__m
            v92 = v90 if v90 < v88 else v88
            v93 = v91 if v91 < v89 else v89
            v94 = angle5 + (turn if angle5 < low5 else 0.0)
            v95 = (turn if -angle5 < low5 else 0.0) - angle5
            v96 = angle6 + (turn if angle6 < low5 else 0.0)
            v97 = (turn if -angle6 < low5 else 0.0) - angle6
            v98 = angle7 + (turn if angle7 < low5 else 0.0)
            v99 = (turn if -angle7 < low5 else 0.0) - angle7
            v100 = angle8 + (turn if angle8 < low5 else 0.0)
            v101 = (turn if -angle8 < low5 else 0.0) - angle8
            v102 = max(low5 - v94, v94 - high5)
            v103 = max(low5 - v95, v95 - high5)
            v104 = max(low5 - v96, v96 - high5)
            v105 = max(low5 - v97, v97 - high5)
            v106 = max(low5 - v98, v98 - high5)
            v107 = max(low5 - v99, v99 - high5)
            v108 = max(low5 - v100, v100 - high5)
            v109 = max(low5 - v101, v101 - high5)
            v110 = low5 - angle5
            v111 = low5 + angle5
            v112 = low5 - angle6
            v113 = low5 + angle6
            v114 = low5 - angle7
            v115 = low5 + angle7
            v116 = low5 - angle8
            v117 = low5 + angle8
            v118 = v110 if v110 < v102 else v102
            v119 = v111 if v111 < v103 else v103
            v120 = v112 if v112 < v104 else v104
            v121 = v113 if v113 < v105 else v105
            v122 = v114 if v114 < v106 else v106
            v123 = v115 if v115 < v107 else v107
            v124 = v116 if v116 < v108 else v108
            v125 = v117 if v117 < v109 else v109
            q5_ppp = angle5 if 0.0 < v118 else v94
            q5_ppm = -angle5 if 0.0 < v119 else v95
            q5_pmp = angle6 if 0.0 < v120 else v96
            q5_pmm = -angle6 if 0.0 < v121 else v97
            q5_mpp = angle7 if 0.0 < v122 else v98
            q5_mpm = -angle7 if 0.0 < v123 else v99
            q5_mmp = angle8 if 0.0 < v124 else v100
            q5_mmm = -angle8 if 0.0 < v125 else v101
            q1_ppp = v4 + (v54 + (turn if v54 <= -half_turn else 0.0))
            q1_mpp = v4 + (v55 + (turn if v55 <= -half_turn else 0.0))
            q3_ppp = v1 + (q3__p if 0.0 < v92 else v86)
            q3_pmp = v1 + (q3__m if 0.0 < v93 else v87)
            v126 = max(v82, v92)
            v127 = max(v83, v93)
            v128 = max(v84, v92)
            v129 = max(v85, v93)
            excess_ppp = max(v118, v126)
            excess_ppm = max(v119, v126)
            excess_pmp = max(v120, v127)
            excess_pmm = max(v121, v127)
            excess_mpp = max(v122, v128)
            excess_mpm = max(v123, v128)
            excess_mmp = max(v124, v129)
            excess_mmm = max(v125, v129)
            outside_ppp = 0.0 < excess_ppp
            outside_ppm = 0.0 < excess_ppm
            outside_pmp = 0.0 < excess_pmp
            outside_pmm = 0.0 < excess_pmm
            outside_mpp = 0.0 < excess_mpp
            outside_mpm = 0.0 < excess_mpm
            outside_mmp = 0.0 < excess_mmp
            outside_mmm = 0.0 < excess_mmm
            _1184 = q1_ppp
            work[1184 + k] = _1184
            _1200 = q2_ppp
            work[1200 + k] = _1200
            _1216 = q3_ppp
            work[1216 + k] = _1216
            _1232 = angle1
            work[1232 + k] = _1232
            _1248 = q5_ppp
            work[1248 + k] = _1248
            _1264 = q6_ppp
            work[1264 + k] = _1264
            _1280 = q4_ppm
            work[1280 + k] = _1280
            _1296 = q5_ppm
            work[1296 + k] = _1296
            _1312 = q6_ppm
            work[1312 + k] = _1312
            _1328 = q2_pmp
            work[1328 + k] = _1328
            _1344 = q3_pmp
            work[1344 + k] = _1344
            _1360 = angle2
            work[1360 + k] = _1360
            _1376 = q5_pmp
            work[1376 + k] = _1376
            _1392 = q6_pmp
            work[1392 + k] = _1392
            _1408 = q4_pmm
            work[1408 + k] = _1408
            _1424 = q5_pmm
            work[1424 + k] = _1424
            _1440 = q6_pmm
            work[1440 + k] = _1440
            _1456 = q1_mpp
            work[1456 + k] = _1456
            _1472 = q2_mpp
            work[1472 + k] = _1472
            _1488 = angle3
            work[1488 + k] = _1488
            _1504 = q5_mpp
            work[1504 + k] = _1504
            _1520 = q6_mpp
            work[1520 + k] = _1520
            _1536 = q4_mpm
            work[1536 + k] = _1536
            _1552 = q5_mpm
            work[1552 + k] = _1552
            _1568 = q6_mpm
            work[1568 + k] = _1568
            _1584 = q2_mmp
            work[1584 + k] = _1584
            _1600 = angle4
            work[1600 + k] = _1600
            _1616 = q5_mmp
            work[1616 + k] = _1616
            _1632 = q6_mmp
            work[1632 + k] = _1632
            _1648 = q4_mmm
            work[1648 + k] = _1648
            _1664 = q5_mmm
            work[1664 + k] = _1664
            _1680 = q6_mmm
            work[1680 + k] = _1680
            work[1696 + k] = (
                UNREACHABLE if _1184 != _1184 else (OUT_OF_LIMITS if outside_ppp else OK)
            )
            work[1712 + k] = (
                UNREACHABLE if _1184 != _1184 else (OUT_OF_LIMITS if outside_ppm else OK)
            )
            work[1728 + k] = (
                UNREACHABLE if _1184 != _1184 else (OUT_OF_LIMITS if outside_pmp else OK)
            )
            work[1744 + k] = (
                UNREACHABLE if _1184 != _1184 else (OUT_OF_LIMITS if outside_pmm else OK)
            )
            work[1760 + k] = (
                UNREACHABLE if _1456 != _1456 else (OUT_OF_LIMITS if outside_mpp else OK)
            )
            work[1776 + k] = (
                UNREACHABLE if _1456 != _1456 else (OUT_OF_LIMITS if outside_mpm else OK)
            )
            work[1792 + k] = (
                UNREACHABLE if _1456 != _1456 else (OUT_OF_LIMITS if outside_mmp else OK)
            )
            work[1808 + k] = (
                UNREACHABLE if _1456 != _1456 else (OUT_OF_LIMITS if outside_mmm else OK)
            )
            work[256 + k] = (
                1.0 if v42 <= m6 or v24 <= m5 or v41 <= m6 or v40 <= m6 or v23 <= m5 or v39 <= m6 or
                abs(D1) <= m1 or abs(D3 * (k5 * w1)) <= m2 or v22 <= m5 else work[256 + k]
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
