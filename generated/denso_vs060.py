"""denso_vs060: Denso VS-060.

Inverse kinematics, generated from robots/denso_vs060.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/denso_vs060.yaml. The formulas and where they come from:
denso_vs060.md.

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

NAME = "denso_vs060"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_LIMITS = (
    (-2.96706, 2.96706),
    (-2.094395, 2.094395),
    (-2.181662, 2.70526),
    (-4.712389, 4.712389),
    (-2.094395, 2.094395),
    (-6.283185, 6.283185),
)
BRANCHES = (
    "front-down-noflip",
    "front-down-flip",
    "front-up-noflip",
    "front-up-flip",
    "back-up-noflip",
    "back-up-flip",
    "back-down-noflip",
    "back-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.345  # joint offset 1 [m]
a2 = 0.305  # link length 2 [m]
a3 = 0.01  # link length 3 [m]
d4 = 0.3  # joint offset 4 [m]
d6 = 0.07  # joint offset 6 [m]
free_limit1 = 1.03e-12  # a length that fixes no angle [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
longest3 = 0.36622663844160425  # square of the longest reach [m^2]
shortest3 = 2.3361558395660652e-05  # square of the shortest reach [m^2]
longest3_reach = 0.3662266384417289  # the longest, with what rounding adds [m^2]
shortest3_reach = 2.3361558394664975e-05  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.36622663844159176  # the longest, where branches merge [m^2]
shortest3_apart = 2.336155839576022e-05  # the shortest, where branches merge [m^2]
free_limit_squared2 = 1.0608999999999998e-24  # square of a length that fixes no angle [m^2]
offset2 = 1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset3 = -1.5707963267948966  # offset of joint 3 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
k1 = 0.183  # 2 * d4 * a2 [m^2]
k2 = 0.0061  # 2 * a3 * a2 [m^2]
k3 = 0.18312499999999998  # a2^2 + (a3^2 + d4^2) [m^2]
k4 = 29.827409659487312  # 1 / (k1^2 + k2^2) [m^-4]
turn1 = 1.5374753309166493  # a constant angle [rad]
high1 = 2.967060001
high2 = 2.094395001
low3 = -2.1816620010000003
high3 = 2.705260001
high5 = 2.094395001
graze = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 1.0609000000000003e-08  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 4.573882234000188e-12
m3 = 0.18194719892287262  # a coefficient of s3
m4 = 0.9995724240825312  # a coefficient of s3
m5 = 5.458415967686178  # a coefficient of s3
m6 = 0.03331908080275105  # a coefficient of c3
m7 = 1.639344262295082  # a coefficient of X1_2
m8 = 0.004795081967213119  # a coefficient of X1_2
m9 = 9.999999999999999e-09  # doubt_limit^2

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
    v5 = q[2] + offset3
    c3 = math.cos(v5)
    s3 = math.sin(v5)
    x3_x = x2_x * c3 - v3 * s3
    x3_y = x2_y * c3 - v4 * s3
    x3_z = s2 * c3 + c2 * s3
    v6 = v3 * c3 + x2_x * s3
    v7 = v4 * c3 + x2_y * s3
    z3_z = c2 * c3 - s2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - s1 * s4
    x4_y = x3_y * c4 + c1 * s4
    x4_z = x3_z * c4
    z4_x = s1 * c4 + x3_x * s4
    z4_z = x3_z * s4
    z4_y = x3_y * s4 - c1 * c4
    v8 = q[4] + offset5
    c5 = math.cos(v8)
    s5 = math.sin(v8)
    x5_x = x4_x * c5 - v6 * s5
    x5_y = x4_y * c5 - v7 * s5
    x5_z = x4_z * c5 + z3_z * s5
    z5_x = v6 * c5 + x4_x * s5
    z5_y = v7 * c5 + x4_y * s5
    z5_z = x4_z * s5 - z3_z * c5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 + z4_x * s6
    T[0, 1] = z4_x * c6 - x5_x * s6
    T[0, 2] = z5_x
    T[0, 3] = x2_x * a2 + x3_x * a3 - v6 * d4 + z5_x * d6
    T[1, 0] = x5_y * c6 + z4_y * s6
    T[1, 1] = z4_y * c6 - x5_y * s6
    T[1, 2] = z5_y
    T[1, 3] = x2_y * a2 + x3_y * a3 - v7 * d4 + z5_y * d6
    T[2, 0] = x5_z * c6 + z4_z * s6
    T[2, 1] = z4_z * c6 - x5_z * s6
    T[2, 2] = z5_z
    T[2, 3] = d1 + s2 * a2 + x3_z * a3 + z3_z * d4 + z5_z * d6
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
    v5 = q[2] + offset3
    c3 = math.cos(v5)
    s3 = math.sin(v5)
    x3_x = x2_x * c3 - v3 * s3
    x3_y = x2_y * c3 - v4 * s3
    x3_z = s2 * c3 + c2 * s3
    v6 = v3 * c3 + x2_x * s3
    v7 = v4 * c3 + x2_y * s3
    z3_z = c2 * c3 - s2 * s3
    p3_x = p2_x + x3_x * a3
    p3_y = p2_y + x3_y * a3
    p3_z = p2_z + x3_z * a3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    z4_x = s1 * c4 + x3_x * s4
    z4_z = x3_z * s4
    p4_x = p3_x - v6 * d4
    p4_y = p3_y - v7 * d4
    p4_z = p3_z + z3_z * d4
    z4_y = x3_y * s4 - c1 * c4
    v8 = q[4] + offset5
    c5 = math.cos(v8)
    s5 = math.sin(v8)
    z5_x = v6 * c5 + (x3_x * c4 - s1 * s4) * s5
    z5_y = v7 * c5 + (x3_y * c4 + c1 * s4) * s5
    z5_z = x3_z * c4 * s5 - z3_z * c5
    p6_x = p4_x + z5_x * d6
    p6_y = p4_y + z5_y * d6
    p6_z = p4_z + z5_z * d6
    v9 = p6_z - d1
    v10 = p6_z - p2_z
    v11 = p6_x - p3_x
    v12 = p6_y - p3_y
    v13 = p6_z - p3_z
    v14 = p6_x - p4_x
    v15 = p6_y - p4_y
    v16 = p6_z - p4_z
    J[0, 0] = -p6_y
    J[0, 1] = -(c1 * v9)
    J[0, 2] = -(c1 * v10)
    J[0, 3] = -(v7 * v13 + z3_z * v12)
    J[0, 4] = z4_y * v16 - z4_z * v15
    J[0, 5] = z5_y * v16 - z5_z * v15
    J[1, 0] = p6_x
    J[1, 1] = -(s1 * v9)
    J[1, 2] = -(s1 * v10)
    J[1, 3] = z3_z * v11 + v6 * v13
    J[1, 4] = z4_z * v14 - z4_x * v16
    J[1, 5] = z5_z * v14 - z5_x * v16
    J[2, 1] = s1 * p6_y + c1 * p6_x
    J[2, 2] = s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x)
    J[2, 3] = v7 * v11 - v6 * v12
    J[2, 4] = z4_x * v15 - z4_y * v14
    J[2, 5] = z5_x * v15 - z5_y * v14
    J[3, 1] = s1
    J[3, 2] = s1
    J[3, 3] = -v6
    J[3, 4] = z4_x
    J[3, 5] = z5_x
    J[4, 1] = -c1
    J[4, 2] = -c1
    J[4, 3] = -v7
    J[4, 4] = z4_y
    J[4, 5] = z5_y
    J[5, 0] = 1.0
    J[5, 3] = z3_z
    J[5, 4] = z4_z
    J[5, 5] = z5_z
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1 A6^-1 [3, 4]
    X1 = T13 * d6 - T14
    wy = T24 - d6 * T23
    w1 = math.sqrt(X1 * X1 + wy * wy)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1
    v1 = seed[0] + offset1

    # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = T34 - d6 * T33
    Z1_3 = wz - d1
    v2 = Z1_3 * Z1_3

    # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    v5 = seed[1] + offset2

    for i1 in range(2):  # front, back
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(v1) if free1 else -(X1 * factor1)
        s1 = math.sin(v1) if free1 else wy * factor1
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
        v6 = T13 * c1 + T23 * s1
        Y4 = T23 * c1 - T13 * s1
        v8 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v9 = T12 * s1 - T22 * c1
        v10 = T12 * c1 + T22 * s1
        v12 = T11 * s1 - T21 * c1
        v13 = T11 * c1 + T21 * s1

        # joint values
        q1 = _wrap(_atan2(s1, c1) - offset1)

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            root3 = w3 * e2
            s3 = (k2 * root3 - v3) * k4
            c3 = k4 * (v4 + k1 * root3)

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
            v7 = c23 * v6 + T33 * s23
            w4 = math.sqrt(v7 * v7 + v8)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = s23 * v6 - T33 * c23

            # theta6
            v11 = c23 * v10 + T32 * s23
            v14 = c23 * v13 + T31 * s23

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(s3, c3) - offset3)

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
                s6 = c4 * v12 + s4 * v14
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
_MISS_WEIGHT = np.array([0.9709, 0.9709, 0.9709, 1.0, 1.0, 1.0])


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
    v1 = X1 * X1 + wy * wy
    w1 = math.sqrt(v1)
    v2 = 1.0 / v1

    # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    Z1_3 = T34 - d6 * T33 - d1
    N3 = v1 + Z1_3 * Z1_3
    D3 = (longest3 - N3) * (N3 - shortest3)
    w3 = math.sqrt(D3)
    v3 = w3 - w3
    v4 = m4 - m5 * N3
    v5 = m3 * w3
    s3_p = v4 + v5
    s3_m = v4 - v5
    v6 = m3 * N3 - m6
    v7 = m5 * w3
    c3_p = v6 + v7
    c3_m = v6 - v7

    # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    X1_2 = m8 + m7 * N3
    v8 = Z1_3 * X1_2
    v9 = w3 * (m7 * w1)
    S2_pp = v8 - v9
    S2_pm = v8 + v9
    v10 = w3 * (m7 * Z1_3)
    v11 = w3 * (m7 * -Z1_3)
    v12 = w1 * X1_2
    C2_pp = v10 + v12
    C2_pm = v11 + v12
    C2_mp = v10 - v12
    C2_mm = v11 - v12
    factor2 = 1.0 / N3

    # theta4, type 2: U4[3, 3]
    c23_pp = c3_p * C2_pp - s3_p * S2_pp
    c23_pm = c3_m * C2_pm - s3_m * S2_pm
    c23_mp = c3_p * C2_mp - s3_p * S2_pm
    c23_mm = c3_m * C2_mm - s3_m * S2_pp
    s23_pp = c3_p * S2_pp + s3_p * C2_pp
    s23_pm = c3_m * S2_pm + s3_m * C2_pm
    s23_mp = c3_p * S2_pm + s3_p * C2_mp
    s23_mm = c3_m * S2_pp + s3_m * C2_mm
    v13 = w1 * (v2 * (T23 * wy - T13 * X1))
    c4_pp = T33 * s23_pp + c23_pp * v13
    c4_pm = T33 * s23_pm + c23_pm * v13
    c4_mp = T33 * s23_mp - c23_mp * v13
    c4_mm = T33 * s23_mm - c23_mm * v13
    v14 = w1 * (v2 * (T13 * wy + X1 * T23))
    v15 = v14 * v14
    v16 = factor2 * c4_pp
    v17 = factor2 * c4_pm
    v18 = factor2 * c4_mp
    v19 = factor2 * c4_mm
    v20 = v15 + factor2 * (c4_pp * v16)
    v21 = v15 + factor2 * (c4_pm * v17)
    v22 = v15 + factor2 * (c4_mp * v18)
    v23 = v15 + factor2 * (c4_mm * v19)
    v24 = math.copysign(half_turn, -v14)
    v25 = math.copysign(half_turn, v14)

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v26 = w1 * (v2 * (X1 * T22 + wy * T12))
    v27 = w1 * (v2 * (wy * T22 - X1 * T12))
    v28 = w1 * (v2 * (X1 * T21 + wy * T11))
    v29 = w1 * (v2 * (wy * T21 - X1 * T11))
    v30 = c4_pp * v28 - v14 * (s23_pp * T31 + c23_pp * v29)
    v31 = c4_pm * v28 - v14 * (s23_pm * T31 + c23_pm * v29)
    v32 = v14 * (s23_mp * T31 - c23_mp * v29) - c4_mp * v28
    v33 = v14 * (s23_mm * T31 - c23_mm * v29) - c4_mm * v28

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if abs(D3) <= m2 or v1 <= m1 or v23 <= m9 or v22 <= m9 or v20 <= m9 or v21 <= m9:
        return False

    # angles, side by side
    room[0] = -v14
    room[1] = -v14
    room[2] = v14
    room[3] = v14
    room[4] = v30
    room[5] = v31
    room[6] = v32
    room[7] = v33
    room[8] = wy
    room[9] = S2_pp
    room[10] = S2_pm
    room[11] = S2_pm
    room[12] = S2_pp
    room[13] = w3
    room[14] = math.sqrt(v20)
    room[15] = math.sqrt(v21)
    room[16] = math.sqrt(v22)
    room[17] = math.sqrt(v23)
    room[24] = v16
    room[25] = v17
    room[26] = v18
    room[27] = v19
    room[28] = c4_pp * v26 - v14 * (s23_pp * T32 + c23_pp * v27)
    room[29] = c4_pm * v26 - v14 * (s23_pm * T32 + c23_pm * v27)
    room[30] = v14 * (s23_mp * T32 - c23_mp * v27) - c4_mp * v26
    room[31] = v14 * (s23_mm * T32 - c23_mm * v27) - c4_mm * v26
    room[32] = -X1
    room[33] = C2_pp
    room[34] = C2_pm
    room[35] = C2_mp
    room[36] = C2_mm
    room[37] = N3 - k3
    room[38] = factor2 * (s23_pp * v13 - T33 * c23_pp)
    room[39] = factor2 * (s23_pm * v13 - T33 * c23_pm)
    room[40] = -(factor2 * (s23_mp * v13 + T33 * c23_mp))
    room[41] = -(factor2 * (s23_mm * v13 + T33 * c23_mm))
    for k in range(18, 24):
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

    # theta4, type 2: U4[3, 3]
    q4_ppm = angle1 - v24
    q4_pmm = angle2 - v24
    q4_mpm = angle3 - v25
    q4_mmm = angle4 - v25

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    q6_ppm = angle5 - math.copysign(half_turn, v30)
    q6_pmm = angle6 - math.copysign(half_turn, v31)
    q6_mpm = angle7 - math.copysign(half_turn, v32)
    q6_mmm = angle8 - math.copysign(half_turn, v33)

    # joint values
    v34 = angle9 - offset1
    v35 = angle9 - math.copysign(half_turn, wy) - offset1
    q1__p = v34 + (turn if v34 <= -half_turn else 0.0)
    q1__m = v35 + (turn if v35 <= -half_turn else 0.0)
    v36 = angle10 - offset2
    v37 = angle11 - offset2
    v38 = angle12 - offset2
    v39 = angle13 - offset2
    q2_ppp = v36 + (turn if v36 <= -half_turn else 0.0)
    q2_pmp = v37 + (turn if v37 <= -half_turn else 0.0)
    q2_mpp = v38 + (turn if v38 <= -half_turn else 0.0)
    q2_mmp = v39 + (turn if v39 <= -half_turn else 0.0)
    v40 = angle14 - turn1 - offset3
    v41 = offset3 + (turn1 + angle14)
    q3_ppp = v40 + (-turn if half_turn < v40 else 0.0)
    q3_pmp = (-turn if half_turn < -v41 else 0.0) - v41
    v42 = angle15 - offset5
    v43 = offset5 + angle15
    v44 = angle16 - offset5
    v45 = offset5 + angle16
    v46 = angle17 - offset5
    v47 = offset5 + angle17
    v48 = angle18 - offset5
    v49 = offset5 + angle18
    q5_ppp = v42 + (turn if v42 <= -half_turn else 0.0)
    q5_ppm = (turn if -v43 <= -half_turn else 0.0) - v43
    q5_pmp = v44 + (turn if v44 <= -half_turn else 0.0)
    q5_pmm = (turn if -v45 <= -half_turn else 0.0) - v45
    q5_mpp = v46 + (turn if v46 <= -half_turn else 0.0)
    q5_mpm = (turn if -v47 <= -half_turn else 0.0) - v47
    q5_mmp = v48 + (turn if v48 <= -half_turn else 0.0)
    q5_mmm = (turn if -v49 <= -half_turn else 0.0) - v49
    v50 = abs(q1__p) - high1
    v51 = abs(q1__m) - high1
    v52 = max(low3 - q3_ppp, q3_ppp - high3)
    v53 = max(low3 - q3_pmp, q3_pmp - high3)
    q1_ppp = v3 + q1__p
    q1_mpp = v3 + q1__m
    v54 = max(abs(q2_ppp) - high2, max(v50, v52))
    v55 = max(abs(q2_pmp) - high2, max(v50, v53))
    v56 = max(abs(q2_mpp) - high2, max(v51, v52))
    v57 = max(abs(q2_mmp) - high2, max(v51, v53))
    excess_ppp = max(v54, abs(q5_ppp) - high5)
    excess_ppm = max(v54, abs(q5_ppm) - high5)
    excess_pmp = max(v55, abs(q5_pmp) - high5)
    excess_pmm = max(v55, abs(q5_pmm) - high5)
    excess_mpp = max(v56, abs(q5_mpp) - high5)
    excess_mpm = max(v56, abs(q5_mpm) - high5)
    excess_mmp = max(v57, abs(q5_mmp) - high5)
    excess_mmm = max(v57, abs(q5_mmm) - high5)
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
    q[0, 5] = angle5
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
    q[2, 5] = angle6
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
    q[4, 5] = angle7
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
    q[6, 5] = angle8
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
    [1072, 1088, 1104, 1120, 1136, 1152],
    [1072, 1088, 1104, 1168, 1184, 1200],
    [1072, 1216, 1232, 1248, 1264, 1280],
    [1072, 1216, 1232, 1296, 1312, 1328],
    [1344, 1360, 1104, 1376, 1392, 1408],
    [1344, 1360, 1104, 1424, 1440, 1456],
    [1344, 1472, 1232, 1488, 1504, 1520],
    [1344, 1472, 1232, 1536, 1552, 1568],
])
_KINDS = np.array([1584, 1600, 1616, 1632, 1648, 1664, 1680, 1696])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(1712), 1712)
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
            v1 = X1 * X1 + wy * wy
            w1 = math.sqrt(v1)
            v2 = 1.0 / v1
            Z1_3 = T34 - d6 * T33 - d1
            N3 = v1 + Z1_3 * Z1_3
            D3 = (longest3 - N3) * (N3 - shortest3)
            w3 = math.sqrt(D3)
            v3 = w3 - w3
            v4 = m4 - m5 * N3
            v5 = m3 * w3
            s3_p = v4 + v5
            s3_m = v4 - v5
            v6 = m3 * N3 - m6
            v7 = m5 * w3
            c3_p = v6 + v7
            c3_m = v6 - v7
            X1_2 = m8 + m7 * N3
            v8 = Z1_3 * X1_2
            v9 = w3 * (m7 * w1)
            S2_pp = v8 - v9
            S2_pm = v8 + v9
            v10 = w3 * (m7 * Z1_3)
            v11 = w3 * (m7 * -Z1_3)
            v12 = w1 * X1_2
            C2_pp = v10 + v12
            C2_pm = v11 + v12
            C2_mp = v10 - v12
            C2_mm = v11 - v12
            factor2 = 1.0 / N3
            c23_pp = c3_p * C2_pp - s3_p * S2_pp
            c23_pm = c3_m * C2_pm - s3_m * S2_pm
            c23_mp = c3_p * C2_mp - s3_p * S2_pm
            c23_mm = c3_m * C2_mm - s3_m * S2_pp
            s23_pp = c3_p * S2_pp + s3_p * C2_pp
            s23_pm = c3_m * S2_pm + s3_m * C2_pm
            s23_mp = c3_p * S2_pm + s3_p * C2_mp
            s23_mm = c3_m * S2_pp + s3_m * C2_mm
            v13 = w1 * (v2 * (T23 * wy - T13 * X1))
            c4_pp = T33 * s23_pp + c23_pp * v13
            c4_pm = T33 * s23_pm + c23_pm * v13
            c4_mp = T33 * s23_mp - c23_mp * v13
            c4_mm = T33 * s23_mm - c23_mm * v13
            v14 = w1 * (v2 * (T13 * wy + X1 * T23))
            v15 = v14 * v14
            v16 = factor2 * c4_pp
            v17 = factor2 * c4_pm
            v18 = factor2 * c4_mp
            v19 = factor2 * c4_mm
            v20 = v15 + factor2 * (c4_pp * v16)
            v21 = v15 + factor2 * (c4_pm * v17)
            v22 = v15 + factor2 * (c4_mp * v18)
            v23 = v15 + factor2 * (c4_mm * v19)
            v24 = math.copysign(half_turn, -v14)
            v25 = math.copysign(half_turn, v14)
            v26 = w1 * (v2 * (X1 * T22 + wy * T12))
            v27 = w1 * (v2 * (wy * T22 - X1 * T12))
            v28 = w1 * (v2 * (X1 * T21 + wy * T11))
            v29 = w1 * (v2 * (wy * T21 - X1 * T11))
            v30 = c4_pp * v28 - v14 * (s23_pp * T31 + c23_pp * v29)
            v31 = c4_pm * v28 - v14 * (s23_pm * T31 + c23_pm * v29)
            v32 = v14 * (s23_mp * T31 - c23_mp * v29) - c4_mp * v28
            v33 = v14 * (s23_mm * T31 - c23_mm * v29) - c4_mm * v28
            work[272 + k] = wy
            work[288 + k] = v1
            work[304 + k] = D3
            work[320 + k] = v3
            work[336 + k] = v20
            work[352 + k] = v21
            work[368 + k] = v22
            work[384 + k] = v23
            work[400 + k] = v24
            work[416 + k] = v25
            work[432 + k] = v30
            work[448 + k] = v31
            work[464 + k] = v32
            work[480 + k] = v33
            work[496 + k] = -v14
            work[512 + k] = -v14
            work[528 + k] = v14
            work[544 + k] = v14
            work[560 + k] = v30
            work[576 + k] = v31
            work[592 + k] = v32
            work[608 + k] = v33
            work[624 + k] = wy
            work[640 + k] = S2_pp
            work[656 + k] = S2_pm
            work[672 + k] = S2_pm
            work[688 + k] = S2_pp
            work[704 + k] = w3
            work[720 + k] = math.sqrt(v20)
            work[736 + k] = math.sqrt(v21)
            work[752 + k] = math.sqrt(v22)
            work[768 + k] = math.sqrt(v23)
            work[784 + k] = v16
            work[800 + k] = v17
            work[816 + k] = v18
            work[832 + k] = v19
            work[848 + k] = c4_pp * v26 - v14 * (s23_pp * T32 + c23_pp * v27)
            work[864 + k] = c4_pm * v26 - v14 * (s23_pm * T32 + c23_pm * v27)
            work[880 + k] = v14 * (s23_mp * T32 - c23_mp * v27) - c4_mp * v26
            work[896 + k] = v14 * (s23_mm * T32 - c23_mm * v27) - c4_mm * v26
            work[912 + k] = -X1
            work[928 + k] = C2_pp
            work[944 + k] = C2_pm
            work[960 + k] = C2_mp
            work[976 + k] = C2_mm
            work[992 + k] = N3 - k3
            work[1008 + k] = factor2 * (s23_pp * v13 - T33 * c23_pp)
            work[1024 + k] = factor2 * (s23_pm * v13 - T33 * c23_pm)
            work[1040 + k] = -(factor2 * (s23_mp * v13 + T33 * c23_mp))
            work[1056 + k] = -(factor2 * (s23_mm * v13 + T33 * c23_mm))
        for k in range(496, 784):
            work[k] = _atan2(work[k], work[k + 288])
        for k in range(0, 16):
            wy = work[272 + k]
            v1 = work[288 + k]
            D3 = work[304 + k]
            v3 = work[320 + k]
            v20 = work[336 + k]
            v21 = work[352 + k]
            v22 = work[368 + k]
            v23 = work[384 + k]
            v24 = work[400 + k]
            v25 = work[416 + k]
            v30 = work[432 + k]
            v31 = work[448 + k]
            v32 = work[464 + k]
            v33 = work[480 + k]
            angle1 = work[496 + k]
            angle2 = work[512 + k]
            angle3 = work[528 + k]
            angle4 = work[544 + k]
            angle5 = work[560 + k]
            angle6 = work[576 + k]
            angle7 = work[592 + k]
            angle8 = work[608 + k]
            angle9 = work[624 + k]
            angle10 = work[640 + k]
            angle11 = work[656 + k]
            angle12 = work[672 + k]
            angle13 = work[688 + k]
            angle14 = work[704 + k]
            angle15 = work[720 + k]
            angle16 = work[736 + k]
            angle17 = work[752 + k]
            angle18 = work[768 + k]
            q4_ppm = angle1 - v24
            q4_pmm = angle2 - v24
            q4_mpm = angle3 - v25
            q4_mmm = angle4 - v25
            q6_ppm = angle5 - math.copysign(half_turn, v30)
            q6_pmm = angle6 - math.copysign(half_turn, v31)
            q6_mpm = angle7 - math.copysign(half_turn, v32)
            q6_mmm = angle8 - math.copysign(half_turn, v33)
            v34 = angle9 - offset1
            v35 = angle9 - math.copysign(half_turn, wy) - offset1
            q1__p = v34 + (turn if v34 <= -half_turn else 0.0)
            q1__m = v35 + (turn if v35 <= -half_turn else 0.0)
            v36 = angle10 - offset2
            v37 = angle11 - offset2
            v38 = angle12 - offset2
            v39 = angle13 - offset2
            q2_ppp = v36 + (turn if v36 <= -half_turn else 0.0)
            q2_pmp = v37 + (turn if v37 <= -half_turn else 0.0)
            q2_mpp = v38 + (turn if v38 <= -half_turn else 0.0)
            q2_mmp = v39 + (turn if v39 <= -half_turn else 0.0)
            v40 = angle14 - turn1 - offset3
            v41 = offset3 + (turn1 + angle14)
            q3_ppp = v40 + (-turn if half_turn < v40 else 0.0)
            q3_pmp = (-turn if half_turn < -v41 else 0.0) - v41
            v42 = angle15 - offset5
            v43 = offset5 + angle15
            v44 = angle16 - offset5
            v45 = offset5 + angle16
            v46 = angle17 - offset5
            v47 = offset5 + angle17
            v48 = angle18 - offset5
            v49 = offset5 + angle18
            q5_ppp = v42 + (turn if v42 <= -half_turn else 0.0)
            q5_ppm = (turn if -v43 <= -half_turn else 0.0) - v43
            q5_pmp = v44 + (turn if v44 <= -half_turn else 0.0)
            q5_pmm = (turn if -v45 <= -half_turn else 0.0) - v45
            q5_mpp = v46 + (turn if v46 <= -half_turn else 0.0)
            q5_mpm = (turn if -v47 <= -half_turn else 0.0) - v47
            q5_mmp = v48 + (turn if v48 <= -half_turn else 0.0)
            q5_mmm = (turn if -v49 <= -half_turn else 0.0) - v49
            v50 = abs(q1__p) - high1
            v51 = abs(q1__m) - high1
            v52 = max(low3 - q3_ppp, q3_ppp - high3)
            v53 = max(low3 - q3_pmp, q3_pmp - high3)
            q1_ppp = v3 + q1__p
            q1_mpp = v3 + q1__m
            v54 = max(abs(q2_ppp) - high2, max(v50, v52))
            v55 = max(abs(q2_pmp) - high2, max(v50, v53))
            v56 = max(abs(q2_mpp) - high2, max(v51, v52))
            v57 = max(abs(q2_mmp) - high2, max(v51, v53))
            excess_ppp = max(v54, abs(q5_ppp) - high5)
            excess_ppm = max(v54, abs(q5_ppm) - high5)
            excess_pmp = max(v55, abs(q5_pmp) - high5)
            excess_pmm = max(v55, abs(q5_pmm) - high5)
            excess_mpp = max(v56, abs(q5_mpp) - high5)
            excess_mpm = max(v56, abs(q5_mpm) - high5)
            excess_mmp = max(v57, abs(q5_mmp) - high5)
            excess_mmm = max(v57, abs(q5_mmm) - high5)
            outside_ppp = 0.0 < excess_ppp
            outside_ppm = 0.0 < excess_ppm
            outside_pmp = 0.0 < excess_pmp
            outside_pmm = 0.0 < excess_pmm
            outside_mpp = 0.0 < excess_mpp
            outside_mpm = 0.0 < excess_mpm
            outside_mmp = 0.0 < excess_mmp
            outside_mmm = 0.0 < excess_mmm
            _1072 = q1_ppp
            work[1072 + k] = _1072
            _1088 = q2_ppp
            work[1088 + k] = _1088
            _1104 = q3_ppp
            work[1104 + k] = _1104
            _1120 = angle1
            work[1120 + k] = _1120
            _1136 = q5_ppp
            work[1136 + k] = _1136
            _1152 = angle5
            work[1152 + k] = _1152
            _1168 = q4_ppm
            work[1168 + k] = _1168
            _1184 = q5_ppm
            work[1184 + k] = _1184
            _1200 = q6_ppm
            work[1200 + k] = _1200
            _1216 = q2_pmp
            work[1216 + k] = _1216
            _1232 = q3_pmp
            work[1232 + k] = _1232
            _1248 = angle2
            work[1248 + k] = _1248
            _1264 = q5_pmp
            work[1264 + k] = _1264
            _1280 = angle6
            work[1280 + k] = _1280
            _1296 = q4_pmm
            work[1296 + k] = _1296
            _1312 = q5_pmm
            work[1312 + k] = _1312
            _1328 = q6_pmm
            work[1328 + k] = _1328
            _1344 = q1_mpp
            work[1344 + k] = _1344
            _1360 = q2_mpp
            work[1360 + k] = _1360
            _1376 = angle3
            work[1376 + k] = _1376
            _1392 = q5_mpp
            work[1392 + k] = _1392
            _1408 = angle7
            work[1408 + k] = _1408
            _1424 = q4_mpm
            work[1424 + k] = _1424
            _1440 = q5_mpm
            work[1440 + k] = _1440
            _1456 = q6_mpm
            work[1456 + k] = _1456
            _1472 = q2_mmp
            work[1472 + k] = _1472
            _1488 = angle4
            work[1488 + k] = _1488
            _1504 = q5_mmp
            work[1504 + k] = _1504
            _1520 = angle8
            work[1520 + k] = _1520
            _1536 = q4_mmm
            work[1536 + k] = _1536
            _1552 = q5_mmm
            work[1552 + k] = _1552
            _1568 = q6_mmm
            work[1568 + k] = _1568
            work[1584 + k] = (
                UNREACHABLE if _1072 != _1072 else (OUT_OF_LIMITS if outside_ppp else OK)
            )
            work[1600 + k] = (
                UNREACHABLE if _1072 != _1072 else (OUT_OF_LIMITS if outside_ppm else OK)
            )
            work[1616 + k] = (
                UNREACHABLE if _1072 != _1072 else (OUT_OF_LIMITS if outside_pmp else OK)
            )
            work[1632 + k] = (
                UNREACHABLE if _1072 != _1072 else (OUT_OF_LIMITS if outside_pmm else OK)
            )
            work[1648 + k] = (
                UNREACHABLE if _1344 != _1344 else (OUT_OF_LIMITS if outside_mpp else OK)
            )
            work[1664 + k] = (
                UNREACHABLE if _1344 != _1344 else (OUT_OF_LIMITS if outside_mpm else OK)
            )
            work[1680 + k] = (
                UNREACHABLE if _1344 != _1344 else (OUT_OF_LIMITS if outside_mmp else OK)
            )
            work[1696 + k] = (
                UNREACHABLE if _1344 != _1344 else (OUT_OF_LIMITS if outside_mmm else OK)
            )
            work[256 + k] = (
                1.0 if abs(D3) <= m2 or v1 <= m1 or v23 <= m9 or v22 <= m9 or v20 <= m9 or v21 <= m9
                else work[256 + k]
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
