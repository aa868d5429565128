"""kawasaki_rs007n: Kawasaki RS007N.

Inverse kinematics, generated from robots/kawasaki_rs007n.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kawasaki_rs007n.yaml. The formulas and where they come from:
kawasaki_rs007n.md.

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

NAME = "kawasaki_rs007n"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_LIMITS = (
    (-3.141592653589793, 3.141592653589793),
    (-2.356194490192345, 2.356194490192345),
    (-2.705260340591211, 2.705260340591211),
    (-3.490658503988659, 3.490658503988659),
    (-2.181661564992912, 2.181661564992912),
    (-6.283185307179586, 6.283185307179586),
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

d1 = 0.36  # joint offset 1 [m]
a2 = 0.355  # link length 2 [m]
d4 = 0.375  # joint offset 4 [m]
d6 = 0.078  # joint offset 6 [m]
free_limit1 = 1.1679999999999999e-12  # a length that fixes no angle [m]
offset1 = -1.5707963267948966  # offset of joint 1 [rad]
longest3 = 0.5328999999999999  # square of the longest reach [m^2]
shortest3 = 0.0004000000000000007  # square of the shortest reach [m^2]
longest3_reach = 0.5329000000001705  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.00039999999999532873  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.5328999999999829  # the longest, where branches merge [m^2]
shortest3_apart = 0.00040000000000046796  # the shortest, where branches merge [m^2]
free_limit_squared2 = 1.3642239999999997e-24  # square of a length that fixes no angle [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset3 = 1.5707963267948966  # offset of joint 3 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
offset6 = 1.5707963267948966  # offset of joint 6 [rad]
k1 = 0.26625  # 2 * d4 * a2 [m^2]
k2 = 0.26665  # a2^2 + d4^2 [m^2]
k3 = 14.106548524322777  # 1 / (k1^2) [m^-4]
high2 = 2.356194491192345
high3 = 2.705260341591211
high5 = 2.181661565992912
graze = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 1.3642239999999998e-08  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 9.045264537377017e-12
m3 = 1.4084507042253522  # a coefficient of S2
m4 = 0.020563380281690184  # a coefficient of S2
m5 = 1.8611071221759995e-16  # doubt_limit_squared2^2 [m^4]
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
    v8 = q[3] + offset4
    c4 = math.cos(v8)
    s4 = math.sin(v8)
    x4_x = x3_x * c4 - s1 * s4
    v9 = v6 * c4 + c1 * s4
    x4_z = x3_z * c4
    z4_x = s1 * c4 + x3_x * s4
    z4_z = x3_z * s4
    z4_y = c1 * c4 - v6 * s4
    v10 = q[4] + offset5
    c5 = math.cos(v10)
    s5 = math.sin(v10)
    x5_x = x4_x * c5 + z3_x * s5
    x5_y = z3_y * s5 - v9 * c5
    x5_z = x4_z * c5 - v7 * s5
    v11 = z3_y * c5 + v9 * s5
    z5_z = v7 * c5 + x4_z * s5
    z5_x = x4_x * s5 - z3_x * c5
    v12 = q[5] + offset6
    c6 = math.cos(v12)
    s6 = math.sin(v12)
    T[0, 0] = x5_x * c6 + z4_x * s6
    T[0, 1] = z4_x * c6 - x5_x * s6
    T[0, 2] = z5_x
    T[0, 3] = x2_x * a2 + z3_x * d4 + z5_x * d6
    T[1, 0] = x5_y * c6 + z4_y * s6
    T[1, 1] = z4_y * c6 - x5_y * s6
    T[1, 2] = -v11
    T[1, 3] = z3_y * d4 - v3 * a2 - v11 * d6
    T[2, 0] = x5_z * c6 + z4_z * s6
    T[2, 1] = z4_z * c6 - x5_z * s6
    T[2, 2] = z5_z
    T[2, 3] = d1 - s2 * a2 - v7 * d4 + z5_z * d6
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
    p2_x = x2_x * a2
    v5 = v3 * a2
    p2_z = d1 - s2 * a2
    v6 = q[2] + offset3
    c3 = math.cos(v6)
    s3 = math.sin(v6)
    x3_x = x2_x * c3 + y2_x * s3
    v7 = v3 * c3 + v4 * s3
    x3_z = c2 * s3 - s2 * c3
    v8 = c2 * c3 + s2 * s3
    z3_x = x2_x * s3 - y2_x * c3
    z3_y = v4 * c3 - v3 * s3
    v9 = q[3] + offset4
    c4 = math.cos(v9)
    s4 = math.sin(v9)
    z4_x = s1 * c4 + x3_x * s4
    z4_z = x3_z * s4
    p4_x = p2_x + z3_x * d4
    p4_y = z3_y * d4 - v5
    p4_z = p2_z - v8 * d4
    z4_y = c1 * c4 - v7 * s4
    v10 = q[4] + offset5
    c5 = math.cos(v10)
    s5 = math.sin(v10)
    v11 = z3_y * c5 + (v7 * c4 + c1 * s4) * s5
    z5_z = v8 * c5 + x3_z * c4 * s5
    z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5
    p6_x = p4_x + z5_x * d6
    p6_y = p4_y - v11 * d6
    p6_z = p4_z + z5_z * d6
    v12 = p6_z - d1
    v13 = p6_x - p2_x
    v14 = v5 + p6_y
    v15 = p6_z - p2_z
    v16 = p6_x - p4_x
    v17 = p6_y - p4_y
    v18 = p6_z - p4_z
    J[0, 0] = p6_y
    J[0, 1] = c1 * v12
    J[0, 2] = -(c1 * v15)
    J[0, 3] = z3_y * v15 + v8 * v14
    J[0, 4] = z4_y * v18 - z4_z * v17
    J[0, 5] = -(v11 * v18 + z5_z * v17)
    J[1, 0] = -p6_x
    J[1, 1] = -(s1 * v12)
    J[1, 2] = s1 * v15
    J[1, 3] = -(v8 * v13 + z3_x * v15)
    J[1, 4] = z4_z * v16 - z4_x * v18
    J[1, 5] = z5_z * v16 - z5_x * v18
    J[2, 1] = s1 * p6_y - c1 * p6_x
    J[2, 2] = c1 * v13 - s1 * v14
    J[2, 3] = z3_x * v14 - z3_y * v13
    J[2, 4] = z4_x * v17 - z4_y * v16
    J[2, 5] = z5_x * v17 + v11 * v16
    J[3, 1] = s1
    J[3, 2] = -s1
    J[3, 3] = z3_x
    J[3, 4] = z4_x
    J[3, 5] = z5_x
    J[4, 1] = c1
    J[4, 2] = -c1
    J[4, 3] = z3_y
    J[4, 4] = z4_y
    J[4, 5] = -v11
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
    w1 = math.sqrt(X1 * X1 + wy * wy)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1
    v1 = seed[0] + offset1

    # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = d6 * T33 - T34
    Z1_3 = wz + d1
    v2 = Z1_3 * Z1_3

    # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    v6 = seed[1] + offset2

    # theta4, type 2: U4[3, 3]
    v12 = seed[3] + offset4

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
        K3 = N3 - k2
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        s3 = k1 * K3 * k3

        # theta2
        X1_2 = a2 + d4 * s3
        v4 = Z1_3 * X1_2
        v5 = root1 * X1_2

        # theta4
        v8 = T13 * c1 - T23 * s1
        v10 = T23 * c1 + T13 * s1
        v11 = v10 * v10

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
            v3 = k3 * (k1 * (w3 * e2))

            # theta2
            X2_2 = d4 * v3
            S2 = v4 + root1 * X2_2
            C2 = v5 - Z1_3 * X2_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v6) if free2 else C2 * factor2
            s2 = math.sin(v6) if free2 else S2 * factor2

            # theta4
            c2m3 = s3 * s2 - v3 * c2
            v7 = v3 * s2 + s3 * c2
            v9 = c2m3 * v8 + T33 * v7
            w4 = math.sqrt(v9 * v9 + v11)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T33 * c2m3 - v7 * v8

            # theta6
            v15 = c2m3 * v14 + T32 * v7
            v18 = c2m3 * v17 + T31 * v7

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(s3, -v3) - offset3)

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4
                if e3 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e3 / divisor4
                c4 = math.cos(v12) if free4 else v9 * factor4
                s4 = math.sin(v12) if free4 else -(v10 * factor4)
                s5 = w4 * e3

                # theta6
                c6 = c4 * v13 + s4 * v15
                s6 = c4 * v16 + s4 * v18

                # joint values
                q4 = _wrap(_atan2(s4, c4) - offset4)
                q5 = _wrap(_atan2(s5, c5) - offset5)
                q6 = _wrap(_atan2(s6, c6) - offset6)
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
_MISS_WEIGHT = np.array([0.8562, 0.8562, 0.8562, 1.0, 1.0, 1.0])


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
    wy = d6 * T23 - T24
    v1 = X1 * X1 + wy * wy
    w1 = math.sqrt(v1)
    v2 = 1.0 / v1
    factor1 = w1 * v2
    v3 = X1 * factor1
    s1 = wy * factor1

    # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    Z1_3 = d1 + (d6 * T33 - T34)
    N3 = v1 + Z1_3 * Z1_3
    D3 = (longest3 - N3) * (N3 - shortest3)
    w3 = math.sqrt(D3)
    v4 = w3 - w3
    v5 = k1 * (N3 - k2)
    s3 = k3 * v5
    v6 = k1 * w3
    v7 = k3 * v6

    # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    X1_2 = a2 + d4 * s3
    X2_2 = d4 * v7
    v8 = Z1_3 * X1_2
    v9 = w1 * X2_2
    v10 = v8 + v9
    v11 = v8 - v9
    v12 = m3 * N3 - m4
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
    v21 = w1 * -v12
    C2_pp = v20 - v19
    C2_pm = v19 + v20
    C2_mp = v21 - v19
    C2_mm = v19 + v21
    v22 = S2_pp * S2_pp
    v23 = v22 + C2_pp * C2_pp
    v24 = S2_pm * S2_pm
    v25 = v24 + C2_pm * C2_pm
    v26 = v24 + C2_mp * C2_mp
    v27 = v22 + C2_mm * C2_mm
    w2_pp = math.sqrt(v23)
    w2_pm = math.sqrt(v25)
    w2_mp = math.sqrt(v26)
    w2_mm = math.sqrt(v27)
    v28 = 1.0 / v23
    v29 = 1.0 / v25
    v30 = 1.0 / v26
    v31 = 1.0 / v27

    # theta4, type 2: U4[3, 3]
    v32 = s3 * v10
    c2m3_pp = w2_pp * (v28 * (v32 - v7 * v17))
    v33 = s3 * v11 + v7 * v18
    c2m3_pm = w2_pm * (v29 * v33)
    c2m3_mp = w2_mp * (v30 * v33)
    c2m3_mm = w2_mm * (v31 * (v32 + v7 * -v17))
    v34 = v7 * v10
    v35 = w2_pp * (v28 * (v34 + s3 * v17))
    v36 = s3 * v18 - v7 * v11
    v37 = w2_pm * (v29 * v36)
    v38 = w2_mp * (v30 * -v36)
    v39 = w2_mm * (v31 * (s3 * -v17 - v34))
    v40 = w1 * (v2 * (T13 * X1 + T23 * wy))
    v41 = T33 * v35 - c2m3_pp * v40
    v42 = T33 * v37 - c2m3_pm * v40
    v43 = T33 * v38 + c2m3_mp * v40
    v44 = T33 * v39 + c2m3_mm * v40
    v45 = T13 * s1 - T23 * v3
    v46 = w1 * (v2 * (T13 * wy - X1 * T23))
    v47 = v46 * v46
    v48 = v47 + v41 * v41
    v49 = v47 + v42 * v42
    v50 = v47 + v43 * v43
    v51 = v47 + v44 * v44
    v52 = 1.0 / v48
    v53 = 1.0 / v49
    v54 = 1.0 / v50
    v55 = 1.0 / v51

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v56 = s1 * T12 - v3 * T22
    v57 = w1 * (v2 * (X1 * T12 + wy * T22))
    v58 = s1 * T11 - v3 * T21
    v59 = w1 * (v2 * (X1 * T11 + wy * T21))

    # joint values
    v68 = math.copysign(half_turn, -v46)
    v69 = math.copysign(half_turn, v46)
    v86 = v52 * (v41 * v58 - v45 * (v35 * T31 - c2m3_pp * v59))
    v87 = v53 * (v42 * v58 - v45 * (v37 * T31 - c2m3_pm * v59))

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if (
        v51 <= m6 or v27 <= m5 or v50 <= m6 or v26 <= m5 or v49 <= m6 or v25 <= m5 or v48 <= m6 or
        v1 <= m1 or abs(D3) <= m2 or v23 <= m5
    ):
        return False

    # angles, side by side
    room[0] = wy
    room[1] = S2_pp
    room[2] = S2_pm
    room[3] = S2_pm
    room[4] = S2_pp
    room[5] = v5
    room[6] = -v46
    room[7] = -v46
    room[8] = v46
    room[9] = v46
    room[10] = math.sqrt(v48)
    room[11] = math.sqrt(v49)
    room[12] = math.sqrt(v50)
    room[13] = math.sqrt(v51)
    room[14] = v86
    room[15] = v87
    room[16] = -(v54 * (v43 * v58 - v45 * (v38 * T31 + c2m3_mp * v59)))
    room[17] = -(v55 * (v44 * v58 - v45 * (v39 * T31 + c2m3_mm * v59)))
    room[24] = -X1
    room[25] = C2_pp
    room[26] = C2_pm
    room[27] = C2_mp
    room[28] = C2_mm
    room[29] = -v6
    room[30] = v41
    room[31] = v42
    room[32] = v43
    room[33] = v44
    room[34] = T33 * c2m3_pp + v35 * v40
    room[35] = T33 * c2m3_pm + v37 * v40
    room[36] = T33 * c2m3_mp - v38 * v40
    room[37] = T33 * c2m3_mm - v39 * v40
    room[38] = v52 * (v41 * v56 - v45 * (v35 * T32 - c2m3_pp * v57))
    room[39] = v53 * (v42 * v56 - v45 * (v37 * T32 - c2m3_pm * v57))
    room[40] = -(v54 * (v43 * v56 - v45 * (v38 * T32 + c2m3_mp * v57)))
    room[41] = -(v55 * (v44 * v56 - v45 * (v39 * T32 + c2m3_mm * v57)))
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

    # joint values
    v60 = angle1 - offset1
    v61 = angle1 - math.copysign(half_turn, wy) - offset1
    v62 = angle2 - offset2
    v63 = angle3 - offset2
    v64 = angle4 - offset2
    v65 = angle5 - offset2
    q2_ppp = v62 + (-turn if half_turn < v62 else 0.0)
    q2_pmp = v63 + (-turn if half_turn < v63 else 0.0)
    q2_mpp = v64 + (-turn if half_turn < v64 else 0.0)
    q2_mmp = v65 + (-turn if half_turn < v65 else 0.0)
    v66 = angle6 - offset3
    v67 = math.copysign(half_turn, v5) - angle6 - offset3
    q3_ppp = v66 + (turn if v66 <= -half_turn else 0.0)
    q3_pmp = v67 + (turn if v67 <= -half_turn else 0.0)
    v70 = angle7 - offset4
    v71 = angle7 - v68 - offset4
    v72 = angle8 - offset4
    v73 = angle8 - v68 - offset4
    v74 = angle9 - offset4
    v75 = angle9 - v69 - offset4
    v76 = angle10 - offset4
    v77 = angle10 - v69 - offset4
    q4_ppp = v70 + (turn if v70 <= -half_turn else 0.0)
    q4_ppm = v71 + (turn if v71 <= -half_turn else 0.0)
    q4_pmp = v72 + (turn if v72 <= -half_turn else 0.0)
    q4_pmm = v73 + (turn if v73 <= -half_turn else 0.0)
    q4_mpp = v74 + (turn if v74 <= -half_turn else 0.0)
    q4_mpm = v75 + (turn if v75 <= -half_turn else 0.0)
    q4_mmp = v76 + (turn if v76 <= -half_turn else 0.0)
    q4_mmm = v77 + (turn if v77 <= -half_turn else 0.0)
    v78 = angle11 - offset5
    v79 = offset5 + angle11
    v80 = angle12 - offset5
    v81 = offset5 + angle12
    v82 = angle13 - offset5
    v83 = offset5 + angle13
    v84 = angle14 - offset5
    v85 = offset5 + angle14
    q5_ppp = v78 + (turn if v78 <= -half_turn else 0.0)
    q5_ppm = (turn if -v79 <= -half_turn else 0.0) - v79
    q5_pmp = v80 + (turn if v80 <= -half_turn else 0.0)
    q5_pmm = (turn if -v81 <= -half_turn else 0.0) - v81
    q5_mpp = v82 + (turn if v82 <= -half_turn else 0.0)
    q5_mpm = (turn if -v83 <= -half_turn else 0.0) - v83
    q5_mmp = v84 + (turn if v84 <= -half_turn else 0.0)
    q5_mmm = (turn if -v85 <= -half_turn else 0.0) - v85
    v88 = angle15 - offset6
    v89 = angle15 - math.copysign(half_turn, v86) - offset6
    v90 = angle16 - offset6
    v91 = angle16 - math.copysign(half_turn, v87) - offset6
    v92 = angle17 - offset6
    v93 = (
        angle17 - math.copysign(half_turn, -(v54 * (v43 * v58 - v45 * (v38 * T31 + c2m3_mp * v59))))
        - offset6
    )
    v94 = angle18 - offset6
    v95 = (
        angle18 - math.copysign(half_turn, -(v55 * (v44 * v58 - v45 * (v39 * T31 + c2m3_mm * v59))))
        - offset6
    )
    q6_ppp = v88 + (turn if v88 <= -half_turn else 0.0)
    q6_ppm = v89 + (turn if v89 <= -half_turn else 0.0)
    q6_pmp = v90 + (turn if v90 <= -half_turn else 0.0)
    q6_pmm = v91 + (turn if v91 <= -half_turn else 0.0)
    q6_mpp = v92 + (turn if v92 <= -half_turn else 0.0)
    q6_mpm = v93 + (turn if v93 <= -half_turn else 0.0)
    q6_mmp = v94 + (turn if v94 <= -half_turn else 0.0)
    q6_mmm = v95 + (turn if v95 <= -half_turn else 0.0)
    v96 = abs(q3_ppp) - high3
    v97 = abs(q3_pmp) - high3
    q1_ppp = v4 + (v60 + (-turn if half_turn < v60 else 0.0))
    q1_mpp = v4 + (v61 + (-turn if half_turn < v61 else 0.0))
    v98 = max(v96, abs(q2_ppp) - high2)
    v99 = max(v97, abs(q2_pmp) - high2)
    v100 = max(v96, abs(q2_mpp) - high2)
    v101 = max(v97, abs(q2_mmp) - high2)
    excess_ppp = max(v98, abs(q5_ppp) - high5)
    excess_ppm = max(v98, abs(q5_ppm) - high5)
    excess_pmp = max(v99, abs(q5_pmp) - high5)
    excess_pmm = max(v99, abs(q5_pmm) - high5)
    excess_mpp = max(v100, abs(q5_mpp) - high5)
    excess_mpm = max(v100, abs(q5_mpm) - high5)
    excess_mmp = max(v101, abs(q5_mmp) - high5)
    excess_mmm = max(v101, abs(q5_mmm) - high5)
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
    q[2, 3] = q4_pmp
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
    q[4, 3] = q4_mpp
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
    q[6, 3] = q4_mmp
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
    [1296, 1312, 1328, 1344, 1360, 1376],
    [1296, 1312, 1328, 1392, 1408, 1424],
    [1296, 1440, 1456, 1472, 1488, 1504],
    [1296, 1440, 1456, 1520, 1536, 1552],
    [1568, 1584, 1328, 1600, 1616, 1632],
    [1568, 1584, 1328, 1648, 1664, 1680],
    [1568, 1696, 1456, 1712, 1728, 1744],
    [1568, 1696, 1456, 1760, 1776, 1792],
])
_KINDS = np.array([1808, 1824, 1840, 1856, 1872, 1888, 1904, 1920])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(1936), 1936)
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
            v1 = X1 * X1 + wy * wy
            w1 = math.sqrt(v1)
            v2 = 1.0 / v1
            factor1 = w1 * v2
            v3 = X1 * factor1
            s1 = wy * factor1
            Z1_3 = d1 + (d6 * T33 - T34)
            N3 = v1 + Z1_3 * Z1_3
            D3 = (longest3 - N3) * (N3 - shortest3)
            w3 = math.sqrt(D3)
            v4 = w3 - w3
            v5 = k1 * (N3 - k2)
            s3 = k3 * v5
            v6 = k1 * w3
            v7 = k3 * v6
            X1_2 = a2 + d4 * s3
            X2_2 = d4 * v7
            v8 = Z1_3 * X1_2
            v9 = w1 * X2_2
            v10 = v8 + v9
            v11 = v8 - v9
            v12 = m3 * N3 - m4
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
            v21 = w1 * -v12
            C2_pp = v20 - v19
            C2_pm = v19 + v20
            C2_mp = v21 - v19
            C2_mm = v19 + v21
            v22 = S2_pp * S2_pp
            v23 = v22 + C2_pp * C2_pp
            v24 = S2_pm * S2_pm
            v25 = v24 + C2_pm * C2_pm
            v26 = v24 + C2_mp * C2_mp
            v27 = v22 + C2_mm * C2_mm
            w2_pp = math.sqrt(v23)
            w2_pm = math.sqrt(v25)
            w2_mp = math.sqrt(v26)
            w2_mm = math.sqrt(v27)
            v28 = 1.0 / v23
            v29 = 1.0 / v25
            v30 = 1.0 / v26
            v31 = 1.0 / v27
            v32 = s3 * v10
            c2m3_pp = w2_pp * (v28 * (v32 - v7 * v17))
            v33 = s3 * v11 + v7 * v18
            c2m3_pm = w2_pm * (v29 * v33)
            c2m3_mp = w2_mp * (v30 * v33)
            c2m3_mm = w2_mm * (v31 * (v32 + v7 * -v17))
            v34 = v7 * v10
            v35 = w2_pp * (v28 * (v34 + s3 * v17))
            v36 = s3 * v18 - v7 * v11
            v37 = w2_pm * (v29 * v36)
            v38 = w2_mp * (v30 * -v36)
            v39 = w2_mm * (v31 * (s3 * -v17 - v34))
            v40 = w1 * (v2 * (T13 * X1 + T23 * wy))
            v41 = T33 * v35 - c2m3_pp * v40
            v42 = T33 * v37 - c2m3_pm * v40
            v43 = T33 * v38 + c2m3_mp * v40
            v44 = T33 * v39 + c2m3_mm * v40
            v45 = T13 * s1 - T23 * v3
            v46 = w1 * (v2 * (T13 * wy - X1 * T23))
            v47 = v46 * v46
            v48 = v47 + v41 * v41
            v49 = v47 + v42 * v42
            v50 = v47 + v43 * v43
            v51 = v47 + v44 * v44
            v52 = 1.0 / v48
            v53 = 1.0 / v49
            v54 = 1.0 / v50
            v55 = 1.0 / v51
            v56 = s1 * T12 - v3 * T22
            v57 = w1 * (v2 * (X1 * T12 + wy * T22))
            v58 = s1 * T11 - v3 * T21
            v59 = w1 * (v2 * (X1 * T11 + wy * T21))
            v68 = math.copysign(half_turn, -v46)
            v69 = math.copysign(half_turn, v46)
            v86 = v52 * (v41 * v58 - v45 * (v35 * T31 - c2m3_pp * v59))
            v87 = v53 * (v42 * v58 - v45 * (v37 * T31 - c2m3_pm * v59))
            work[272 + k] = wy
            work[288 + k] = v1
            work[304 + k] = D3
            work[320 + k] = v4
            work[336 + k] = v5
            work[352 + k] = v23
            work[368 + k] = v25
            work[384 + k] = v26
            work[400 + k] = v27
            work[416 + k] = c2m3_mp
            work[432 + k] = c2m3_mm
            work[448 + k] = v38
            work[464 + k] = v39
            work[480 + k] = v43
            work[496 + k] = v44
            work[512 + k] = v45
            work[528 + k] = v48
            work[544 + k] = v49
            work[560 + k] = v50
            work[576 + k] = v51
            work[592 + k] = v54
            work[608 + k] = v55
            work[624 + k] = v58
            work[640 + k] = v59
            work[656 + k] = v68
            work[672 + k] = v69
            work[688 + k] = v86
            work[704 + k] = v87
            work[720 + k] = wy
            work[736 + k] = S2_pp
            work[752 + k] = S2_pm
            work[768 + k] = S2_pm
            work[784 + k] = S2_pp
            work[800 + k] = v5
            work[816 + k] = -v46
            work[832 + k] = -v46
            work[848 + k] = v46
            work[864 + k] = v46
            work[880 + k] = math.sqrt(v48)
            work[896 + k] = math.sqrt(v49)
            work[912 + k] = math.sqrt(v50)
            work[928 + k] = math.sqrt(v51)
            work[944 + k] = v86
            work[960 + k] = v87
            work[976 + k] = -(v54 * (v43 * v58 - v45 * (v38 * T31 + c2m3_mp * v59)))
            work[992 + k] = -(v55 * (v44 * v58 - v45 * (v39 * T31 + c2m3_mm * v59)))
            work[1008 + k] = -X1
            work[1024 + k] = C2_pp
            work[1040 + k] = C2_pm
            work[1056 + k] = C2_mp
            work[1072 + k] = C2_mm
            work[1088 + k] = -v6
            work[1104 + k] = v41
            work[1120 + k] = v42
            work[1136 + k] = v43
            work[1152 + k] = v44
            work[1168 + k] = T33 * c2m3_pp + v35 * v40
            work[1184 + k] = T33 * c2m3_pm + v37 * v40
            work[1200 + k] = T33 * c2m3_mp - v38 * v40
            work[1216 + k] = T33 * c2m3_mm - v39 * v40
            work[1232 + k] = v52 * (v41 * v56 - v45 * (v35 * T32 - c2m3_pp * v57))
            work[1248 + k] = v53 * (v42 * v56 - v45 * (v37 * T32 - c2m3_pm * v57))
            work[1264 + k] = -(v54 * (v43 * v56 - v45 * (v38 * T32 + c2m3_mp * v57)))
            work[1280 + k] = -(v55 * (v44 * v56 - v45 * (v39 * T32 + c2m3_mm * v57)))
        for k in range(720, 1008):
            work[k] = _atan2(work[k], work[k + 288])
        for k in range(0, 16):
            T31 = work[128 + k]
            wy = work[272 + k]
            v1 = work[288 + k]
            D3 = work[304 + k]
            v4 = work[320 + k]
            v5 = work[336 + k]
            v23 = work[352 + k]
            v25 = work[368 + k]
            v26 = work[384 + k]
            v27 = work[400 + k]
            c2m3_mp = work[416 + k]
            c2m3_mm = work[432 + k]
            v38 = work[448 + k]
            v39 = work[464 + k]
            v43 = work[480 + k]
            v44 = work[496 + k]
            v45 = work[512 + k]
            v48 = work[528 + k]
            v49 = work[544 + k]
            v50 = work[560 + k]
            v51 = work[576 + k]
            v54 = work[592 + k]
            v55 = work[608 + k]
            v58 = work[624 + k]
            v59 = work[640 + k]
            v68 = work[656 + k]
            v69 = work[672 + k]
            v86 = work[688 + k]
            v87 = work[704 + k]
            angle1 = work[720 + k]
            angle2 = work[736 + k]
            angle3 = work[752 + k]
            angle4 = work[768 + k]
            angle5 = work[784 + k]
            angle6 = work[800 + k]
            angle7 = work[816 + k]
            angle8 = work[832 + k]
            angle9 = work[848 + k]
            angle10 = work[864 + k]
            angle11 = work[880 + k]
            angle12 = work[896 + k]
            angle13 = work[912 + k]
            angle14 = work[928 + k]
            angle15 = work[944 + k]
            angle16 = work[960 + k]
            angle17 = work[976 + k]
            angle18 = work[992 + k]
            v60 = angle1 - offset1
            v61 = angle1 - math.copysign(half_turn, wy) - offset1
            v62 = angle2 - offset2
            v63 = angle3 - offset2
            v64 = angle4 - offset2
            v65 = angle5 - offset2
            q2_ppp = v62 + (-turn if half_turn < v62 else 0.0)
            q2_pmp = v63 + (-turn if half_turn < v63 else 0.0)
            q2_mpp = v64 + (-turn if half_turn < v64 else 0.0)
            q2_mmp = v65 + (-turn if half_turn < v65 else 0.0)
            v66 = angle6 - offset3
            v67 = math.copysign(half_turn, v5) - angle6 - offset3
            q3_ppp = v66 + (turn if v66 <= -half_turn else 0.0)
            q3_pmp = v67 + (turn if v67 <= -half_turn else 0.0)
            v70 = angle7 - offset4
            v71 = angle7 - v68 - offset4
            v72 = angle8 - offset4
            v73 = angle8 - v68 - offset4
            v74 = angle9 - offset4
            v75 = angle9 - v69 - offset4
            v76 = angle10 - offset4
            v77 = angle10 - v69 - offset4
            q4_ppp = v70 + (turn if v70 <= -half_turn else 0.0)
            q4_ppm = v71 + (turn if v71 <= -half_turn else 0.0)
            q4_pmp = v72 + (turn if v72 <= -half_turn else 0.0)
            q4_pmm = v73 + (turn if v73 <= -half_turn else 0.0)
            q4_mpp = v74 + (turn if v74 <= -half_turn else 0.0)
            q4_mpm = v75 + (turn if v75 <= -half_turn else 0.0)
            q4_mmp = v76 + (turn if v76 <= -half_turn else 0.0)
            q4_mmm = v77 + (turn if v77 <= -half_turn else 0.0)
            v78 = angle11 - offset5
            v79 = offset5 + angle11
            v80 = angle12 - offset5
            v81 = offset5 + angle12
            v82 = angle13 - offset5
            v83 = offset5 + angle13
            v84 = angle14 - offset5
            v85 = offset5 + angle14
            q5_ppp = v78 + (turn if v78 <= -half_turn else 0.0)
            q5_ppm = (turn if -v79 <= -half_turn else 0.0) - v79
            q5_pmp = v80 + (turn if v80 <= -half_turn else 0.0)
            q5_pmm = (turn if -v81 <= -half_turn else 0.0) - v81
            q5_mpp = v82 + (turn if v82 <= -half_turn else 0.0)
            q5_mpm = (turn if -v83 <= -half_turn else 0.0) - v83
            q5_mmp = v84 + (turn if v84 <= -half_turn else 0.0)
            q5_mmm = (turn if -v85 <= -half_turn else 0.0) - v85
            v88 = angle15 - offset6
            v89 = angle15 - math.copysign(half_turn, v86) - offset6
            v90 = angle16 - offset6
            v91 = angle16 - math.copysign(half_turn, v87) - offset6
            v92 = angle17 - offset6
            v93 = (
                angle17 - math.copysign(half_turn, -(v54 * (v43 * v58 - v45 * (v38 * T31 + c2m3_mp *
                v59)))) - offset6
            )
            v94 = angle18 - offset6
            v95 = (
                angle18 - math.copysign(half_turn, -(v55 * (v44 * v58 - v45 * (v39 * T31 + c2m3_mm *
                v59)))) - offset6
            )
            q6_ppp = v88 + (turn if v88 <= -half_turn else 0.0)
            q6_ppm = v89 + (turn if v89 <= -half_turn else 0.0)
            q6_pmp = v90 + (turn if v90 <= -half_turn else 0.0)
            q6_pmm = v91 + (turn if v91 <= -half_turn else 0.0)
            q6_mpp = v92 + (turn if v92 <= -half_turn else 0.0)
            q6_mpm = v93 + (turn if v93 <= -half_turn else 0.0)
            q6_mmp = v94 + (turn if v94 <= -half_turn else 0.0)
            q6_mmm = v95 + (turn if v95 <= -half_turn else 0.0)
            v96 = abs(q3_ppp) - high3
            v97 = abs(q3_pmp) - high3
            q1_ppp = v4 + (v60 + (-turn if half_turn < v60 else 0.0))
            q1_mpp = v4 + (v61 + (-turn if half_turn < v61 else 0.0))
            v98 = max(v96, abs(q2_ppp) - high2)
            v99 = max(v97, abs(q2_pmp) - high2)
            v100 = max(v96, abs(q2_mpp) - high2)
            v101 = max(v97, abs(q2_mmp) - high2)
            excess_ppp = max(v98, abs(q5_ppp) - high5)
            excess_ppm = max(v98, abs(q5_ppm) - high5)
            excess_pmp = max(v99, abs(q5_pmp) - high5)
            excess_pmm = max(v99, abs(q5_pmm) - high5)
            excess_mpp = max(v100, abs(q5_mpp) - high5)
            excess_mpm = max(v100, abs(q5_mpm) - high5)
            excess_mmp = max(v101, abs(q5_mmp) - high5)
            excess_mmm = max(v101, abs(q5_mmm) - high5)
            outside_ppp = 0.0 < excess_ppp
            outside_ppm = 0.0 < excess_ppm
            outside_pmp = 0.0 < excess_pmp
            outside_pmm = 0.0 < excess_pmm
            outside_mpp = 0.0 < excess_mpp
            outside_mpm = 0.0 < excess_mpm
            outside_mmp = 0.0 < excess_mmp
            outside_mmm = 0.0 < excess_mmm
            _1296 = q1_ppp
            work[1296 + k] = _1296
            _1312 = q2_ppp
            work[1312 + k] = _1312
            _1328 = q3_ppp
            work[1328 + k] = _1328
            _1344 = q4_ppp
            work[1344 + k] = _1344
            _1360 = q5_ppp
            work[1360 + k] = _1360
            _1376 = q6_ppp
            work[1376 + k] = _1376
            _1392 = q4_ppm
            work[1392 + k] = _1392
            _1408 = q5_ppm
            work[1408 + k] = _1408
            _1424 = q6_ppm
            work[1424 + k] = _1424
            _1440 = q2_pmp
            work[1440 + k] = _1440
            _1456 = q3_pmp
            work[1456 + k] = _1456
            _1472 = q4_pmp
            work[1472 + k] = _1472
            _1488 = q5_pmp
            work[1488 + k] = _1488
            _1504 = q6_pmp
            work[1504 + k] = _1504
            _1520 = q4_pmm
            work[1520 + k] = _1520
            _1536 = q5_pmm
            work[1536 + k] = _1536
            _1552 = q6_pmm
            work[1552 + k] = _1552
            _1568 = q1_mpp
            work[1568 + k] = _1568
            _1584 = q2_mpp
            work[1584 + k] = _1584
            _1600 = q4_mpp
            work[1600 + k] = _1600
            _1616 = q5_mpp
            work[1616 + k] = _1616
            _1632 = q6_mpp
            work[1632 + k] = _1632
            _1648 = q4_mpm
            work[1648 + k] = _1648
            _1664 = q5_mpm
            work[1664 + k] = _1664
            _1680 = q6_mpm
            work[1680 + k] = _1680
            _1696 = q2_mmp
            work[1696 + k] = _1696
            _1712 = q4_mmp
            work[1712 + k] = _1712
            _1728 = q5_mmp
            work[1728 + k] = _1728
            _1744 = q6_mmp
            work[1744 + k] = _1744
            _1760 = q4_mmm
            work[1760 + k] = _1760
            _1776 = q5_mmm
            work[1776 + k] = _1776
            _1792 = q6_mmm
            work[1792 + k] = _1792
            work[1808 + k] = (
                UNREACHABLE if _1296 != _1296 else (OUT_OF_LIMITS if outside_ppp else OK)
            )
            work[1824 + k] = (
                UNREACHABLE if _1296 != _1296 else (OUT_OF_LIMITS if outside_ppm else OK)
            )
            work[1840 + k] = (
                UNREACHABLE if _1296 != _1296 else (OUT_OF_LIMITS if outside_pmp else OK)
            )
            work[1856 + k] = (
                UNREACHABLE if _1296 != _1296 else (OUT_OF_LIMITS if outside_pmm else OK)
            )
            work[1872 + k] = (
                UNREACHABLE if _1568 != _1568 else (OUT_OF_LIMITS if outside_mpp else OK)
            )
            work[1888 + k] = (
                UNREACHABLE if _1568 != _1568 else (OUT_OF_LIMITS if outside_mpm else OK)
            )
            work[1904 + k] = (
                UNREACHABLE if _1568 != _1568 else (OUT_OF_LIMITS if outside_mmp else OK)
            )
            work[1920 + k] = (
                UNREACHABLE if _1568 != _1568 else (OUT_OF_LIMITS if outside_mmm else OK)
            )
            work[256 + k] = (
                1.0 if v51 <= m6 or v27 <= m5 or v50 <= m6 or v26 <= m5 or v49 <= m6 or v25 <= m5 or
                v48 <= m6 or v1 <= m1 or abs(D3) <= m2 or v23 <= m5 else work[256 + k]
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
