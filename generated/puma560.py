"""puma560: Unimation PUMA 560.

Inverse kinematics, generated from robots/puma560.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/puma560.yaml. The formulas and where they come from: puma560.md.

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
_read_rows = _runtime("pose").read_pose
_of_joints = _runtime("entry").of_joints(_HOW, 6)

NAME = "puma560"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_LIMITS = (
    (-2.792526803190927, 2.792526803190927),
    (-1.9198621771937625, 1.9198621771937625),
    (-2.356194490192345, 2.356194490192345),
    (-4.642575810304916, 4.642575810304916),
    (-1.7453292519943295, 1.7453292519943295),
    (-4.642575810304916, 4.642575810304916),
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

d1 = 0.67183  # joint offset 1 [m]
a2 = 0.4318  # link length 2 [m]
d3 = 0.15005  # joint offset 3 [m]
a3 = 0.0203  # link length 3 [m]
d4 = 0.4318  # joint offset 4 [m]
free_limit_squared2 = 2.9096854084e-24  # square of a length that fixes no angle [m^2]
least_root1 = 5.394149987162018e-07  # a root of nothing, by rounding [m]
longest3 = 0.7466289125534531  # square of the longest reach [m^2]
shortest3 = 2.274465470660925e-07  # square of the shortest reach [m^2]
boundary3 = 2.1999652436149993e-13  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.7466289125534236  # the longest, where branches merge [m^2]
shortest3_apart = 2.2744654708236271e-07  # the shortest, where branches merge [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.022515002499999996  # d3^2 [m^2]
k2 = 5.11904578000291e-14  # reach_slack1 * (2 * d3 + reach_slack1) [m^2]
k3 = 5.1190457800002905e-15  # merge_slack1 * (2 * d3 + merge_slack1) [m^2]
k4 = 0.5862420710759887  # 1 / arm_size1 [m^-1]
k5 = 0.37290248000000004  # 2 * d4 * a2 [m^2]
k6 = 0.01753108  # 2 * a3 * a2 [m^2]
k7 = 0.37331457  # d4 * a2 + (a3^2 + d4 * a2) [m^2]
k8 = 7.175474885806929  # 1 / (k5^2 + k6^2) [m^-4]
turn1 = 1.5238184104468135  # a constant angle [rad]
high1 = 2.7925268041909272
high2 = 1.9198621781937626
high3 = 2.356194491192345
high5 = 1.7453292529943296
graze = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 5.119045780000291e-12  # 1000 * k3 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 2.2049387897563516e-11
m3 = 0.12579382426107213  # a coefficient of s3
m4 = 0.9988973492016866  # a coefficient of s3
m5 = 2.675752380095121  # a coefficient of s3
m6 = 0.046960667412677716  # a coefficient of c3
m7 = 1.1579434923575729  # a coefficient of X1_2
m8 = 0.000477176933765627  # a coefficient of X1_2
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
    x3_z = s2 * c3 + c2 * s3
    v3 = v1 * c3 + x2_x * s3
    v4 = v2 * c3 + x2_y * s3
    z3_z = c2 * c3 - s2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - s1 * s4
    x4_y = x3_y * c4 + c1 * s4
    x4_z = x3_z * c4
    z4_x = s1 * c4 + x3_x * s4
    y5_y = c1 * c4 - x3_y * s4
    z4_z = x3_z * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 - v3 * s5
    x5_y = x4_y * c5 - v4 * s5
    x5_z = x4_z * c5 + z3_z * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 - z4_x * s6
    T[0, 1] = -(z4_x * c6 + x5_x * s6)
    T[0, 2] = -(v3 * c5 + x4_x * s5)
    T[0, 3] = x2_x * a2 + x3_x * a3 + s1 * d3 - v3 * d4
    T[1, 0] = x5_y * c6 + y5_y * s6
    T[1, 1] = y5_y * c6 - x5_y * s6
    T[1, 2] = -(v4 * c5 + x4_y * s5)
    T[1, 3] = x2_y * a2 + x3_y * a3 - c1 * d3 - v4 * d4
    T[2, 0] = x5_z * c6 - z4_z * s6
    T[2, 1] = -(z4_z * c6 + x5_z * s6)
    T[2, 2] = z3_z * c5 - x4_z * s5
    T[2, 3] = d1 + s2 * a2 + x3_z * a3 + z3_z * d4
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
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * c2
    x2_y = s1 * c2
    v1 = c1 * s2
    v2 = s1 * s2
    p2_x = x2_x * a2
    p2_y = x2_y * a2
    p2_z = d1 + s2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v1 * s3
    x3_y = x2_y * c3 - v2 * s3
    x3_z = s2 * c3 + c2 * s3
    v3 = v1 * c3 + x2_x * s3
    v4 = v2 * c3 + x2_y * s3
    z3_z = c2 * c3 - s2 * s3
    p3_z = p2_z + x3_z * a3
    p3_x = p2_x + x3_x * a3 + s1 * d3
    p3_y = p2_y + x3_y * a3 - c1 * d3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    p4_x = p3_x - v3 * d4
    p4_y = p3_y - v4 * d4
    p4_z = p3_z + z3_z * d4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v5 = p4_z - d1
    v6 = p4_z - p2_z
    v7 = p4_x - p3_x
    v8 = p4_y - p3_y
    v9 = p4_z - p3_z
    J[0, 0] = -p4_y
    J[0, 1] = -(c1 * v5)
    J[0, 2] = -(c1 * v6)
    J[0, 3] = -(v4 * v9 + z3_z * v8)
    J[1, 0] = p4_x
    J[1, 1] = -(s1 * v5)
    J[1, 2] = -(s1 * v6)
    J[1, 3] = z3_z * v7 + v3 * v9
    J[2, 1] = s1 * p4_y + c1 * p4_x
    J[2, 2] = s1 * (p4_y - p2_y) + c1 * (p4_x - p2_x)
    J[2, 3] = v4 * v7 - v3 * v8
    J[3, 1] = s1
    J[3, 2] = s1
    J[3, 3] = -v3
    J[3, 4] = s1 * c4 + x3_x * s4
    J[3, 5] = -(v3 * c5 + (x3_x * c4 - s1 * s4) * s5)
    J[4, 1] = -c1
    J[4, 2] = -c1
    J[4, 3] = -v4
    J[4, 4] = x3_y * s4 - c1 * c4
    J[4, 5] = -(v4 * c5 + (x3_y * c4 + c1 * s4) * s5)
    J[5, 0] = 1.0
    J[5, 3] = z3_z
    J[5, 4] = x3_z * s4
    J[5, 5] = z3_z * c5 - x3_z * c4 * s5
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[3, 4]
    N1 = T14 * T14 + T24 * T24
    free1 = N1 <= free_limit_squared2
    D1 = N1 - k1
    apart1 = k3 < D1
    if not (-k2 <= D1):
        return  # out of reach
    w1 = math.sqrt(D1 if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else d3 * math.sqrt(N1)))
    v1 = T14 * d3
    v2 = T24 * d3

    # theta3, type 6: U1[2, 4] and U1[1, 4]
    Z1_3 = T34 - d1
    v3 = Z1_3 * Z1_3
    v4 = 1.0 if free1 else (w1 if apart1 else least_root1) * k4

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        root1 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else inverse1 * (T14 * root1 - v2)
        s1 = math.sin(seed[0]) if free1 else inverse1 * (v1 + T24 * root1)
        q1 = _atan2(s1, c1)

        # theta3
        N3 = v3 + root1 * root1
        K3 = N3 - k7
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= D3 * v4):
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        v5 = k5 * K3
        v6 = k6 * K3

        # theta4, type 2: U4[3, 3]
        v7 = T13 * c1 + T23 * s1
        Y4 = T23 * c1 - T13 * s1
        v9 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v10 = T12 * s1 - T22 * c1
        v11 = T12 * c1 + T22 * s1
        v13 = T11 * s1 - T21 * c1
        v14 = T11 * c1 + T21 * s1

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            root3 = w3 * e2
            s3 = (k6 * root3 - v5) * k8
            c3 = k8 * (v6 + k5 * root3)
            q3 = _atan2(s3, c3)

            # theta2, type 3: U1[2, 4] and U1[1, 4]
            X1_2 = a2 + (a3 * c3 - d4 * s3)
            Y1_2 = d4 * c3 + a3 * s3
            S2 = Z1_3 * X1_2 - root1 * Y1_2
            C2 = root1 * X1_2 + Z1_3 * Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else S2 * factor2
            q2 = _atan2(s2, c2)

            # theta4
            c23 = c3 * c2 - s3 * s2
            s23 = c3 * s2 + s3 * c2
            v8 = c23 * v7 + T33 * s23
            w4 = math.sqrt(v8 * v8 + v9)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T33 * c23 - s23 * v7

            # theta6
            v12 = c23 * v11 + T32 * s23
            v15 = c23 * v14 + T31 * s23

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4
                if e3 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e3 / divisor4
                c4 = math.cos(seed[3]) if free4 else v8 * factor4
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)

                # theta5
                q5 = _atan2(-(w4 * e3), c5)

                # theta6
                q6 = _atan2(-(c4 * v13 + s4 * v15), -(c4 * v10 + s4 * v12))
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
_MISS_WEIGHT = np.array([0.5862, 0.5862, 0.5862, 1.0, 1.0, 1.0])


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
    N1 = T14 * T14 + T24 * T24
    D1 = N1 - k1
    w1 = math.sqrt(D1)
    v1 = w1 - w1
    inverse1 = 1.0 / N1
    v2 = inverse1 * (d3 * T24)
    v3 = w1 * (T14 * inverse1)
    c1_p = v3 - v2
    v4 = v2 + v3
    v5 = inverse1 * (d3 * T14)
    v6 = w1 * (T24 * inverse1)
    s1_p = v5 + v6
    s1_m = v5 - v6

    # theta3, type 6: U1[2, 4] and U1[1, 4]
    Z1_3 = T34 - d1
    N3 = D1 + Z1_3 * Z1_3
    D3 = (longest3 - N3) * (N3 - shortest3)
    w3 = math.sqrt(D3)
    v7 = w3 - w3
    v8 = m4 - m5 * N3
    v9 = m3 * w3
    s3_p = v8 + v9
    s3_m = v8 - v9
    v10 = m3 * N3 - m6
    v11 = m5 * w3
    c3_p = v10 + v11
    c3_m = v10 - v11

    # theta2, type 3: U1[2, 4] and U1[1, 4]
    X1_2 = m7 * N3 - m8
    v13 = Z1_3 * X1_2
    v14 = w3 * (m7 * w1)
    S2_pp = v13 - v14
    S2_pm = v13 + v14
    v15 = w3 * (m7 * Z1_3)
    v16 = w3 * (m7 * -Z1_3)
    v17 = w1 * X1_2
    v18 = w1 * -X1_2
    C2_pp = v15 + v17
    C2_pm = v16 + v17
    C2_mp = v15 + v18
    C2_mm = v16 + v18
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
    v19 = c1_p * T13 + s1_p * T23
    v20 = s1_m * T23 - v4 * T13
    c4_pp = c23_pp * v19 + s23_pp * T33
    c4_pm = c23_pm * v19 + s23_pm * T33
    c4_mp = c23_mp * v20 + s23_mp * T33
    c4_mm = c23_mm * v20 + s23_mm * T33
    Y4_p = c1_p * T23 - s1_p * T13
    v21 = v4 * T23 + s1_m * T13
    v22 = Y4_p * Y4_p
    v23 = v21 * v21
    v24 = factor2 * c4_pp
    v25 = factor2 * c4_pm
    v26 = factor2 * c4_mp
    v27 = factor2 * c4_mm
    v28 = v22 + factor2 * (c4_pp * v24)
    v29 = v22 + factor2 * (c4_pm * v25)
    v30 = v23 + factor2 * (c4_mp * v26)
    v31 = v23 + factor2 * (c4_mm * v27)
    v32 = math.copysign(half_turn, Y4_p)
    v33 = math.copysign(half_turn, -v21)

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v34 = s1_p * T12 - c1_p * T22
    v35 = s1_m * T12 + v4 * T22
    v36 = c1_p * T12 + s1_p * T22
    v37 = s1_m * T22 - v4 * T12
    v38 = s1_p * T11 - c1_p * T21
    v39 = s1_m * T11 + v4 * T21
    v40 = c1_p * T11 + s1_p * T21
    v41 = s1_m * T21 - v4 * T11
    v42 = v21 * (c23_mp * v41 + s23_mp * T31) - c4_mp * v39
    v43 = v21 * (c23_mm * v41 + s23_mm * T31) - c4_mm * v39

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if (
        abs(D3 * (k4 * w1)) <= m2 or abs(D1) <= m1 or v31 <= m9 or v30 <= m9 or v28 <= m9 or v29 <=
        m9
    ):
        return False

    # angles, side by side
    room[0] = s1_p
    room[1] = s1_m
    room[2] = w3
    room[3] = S2_pp
    room[4] = S2_pm
    room[5] = S2_pm
    room[6] = S2_pp
    room[7] = Y4_p
    room[8] = Y4_p
    room[9] = -v21
    room[10] = -v21
    room[11] = -math.sqrt(v28)
    room[12] = -math.sqrt(v29)
    room[13] = -math.sqrt(v30)
    room[14] = -math.sqrt(v31)
    room[15] = -(c4_pp * v38 + Y4_p * (c23_pp * v40 + s23_pp * T31))
    room[16] = -(c4_pm * v38 + Y4_p * (c23_pm * v40 + s23_pm * T31))
    room[17] = v42
    room[18] = v43
    room[24] = c1_p
    room[25] = -v4
    room[26] = N3 - k7
    room[27] = C2_pp
    room[28] = C2_pm
    room[29] = C2_mp
    room[30] = C2_mm
    room[31] = v24
    room[32] = v25
    room[33] = v26
    room[34] = v27
    room[35] = factor2 * (c23_pp * T33 - s23_pp * v19)
    room[36] = factor2 * (c23_pm * T33 - s23_pm * v19)
    room[37] = factor2 * (c23_mp * T33 - s23_mp * v20)
    room[38] = factor2 * (c23_mm * T33 - s23_mm * v20)
    room[39] = -(c4_pp * v34 + Y4_p * (c23_pp * v36 + s23_pp * T32))
    room[40] = -(c4_pm * v34 + Y4_p * (c23_pm * v36 + s23_pm * T32))
    room[41] = v21 * (c23_mp * v37 + s23_mp * T32) - c4_mp * v35
    room[42] = v21 * (c23_mm * v37 + s23_mm * T32) - c4_mm * v35
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

    # theta3, type 6: U1[2, 4] and U1[1, 4]
    q3__p = angle3 - turn1
    v12 = turn1 + angle3

    # theta4, type 2: U4[3, 3]
    q4_ppm = angle8 - v32
    q4_pmm = angle9 - v32
    q4_mpm = angle10 - v33
    q4_mmm = angle11 - v33

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    q6_ppm = (
        angle16 - math.copysign(half_turn, -(c4_pp * v38 + Y4_p * (c23_pp * v40 + s23_pp * T31)))
    )
    q6_pmm = (
        angle17 - math.copysign(half_turn, -(c4_pm * v38 + Y4_p * (c23_pm * v40 + s23_pm * T31)))
    )
    q6_mpm = angle18 - math.copysign(half_turn, v42)
    q6_mmm = angle19 - math.copysign(half_turn, v43)

    # joint values
    v44 = q3__p + (turn if q3__p <= -half_turn else 0.0)
    v45 = (turn if -v12 <= -half_turn else 0.0) - v12
    v46 = abs(angle1) - high1
    v47 = abs(angle2) - high1
    v48 = abs(v44) - high3
    v49 = abs(v45) - high3
    q1_ppp = angle1 + v7
    q1_mpp = angle2 + v7
    q3_ppp = v1 + v44
    q3_pmp = v1 + v45
    excess_pp = max(abs(angle12) - high5, max(abs(angle4) - high2, max(v46, v48)))
    excess_pm = max(abs(angle13) - high5, max(abs(angle5) - high2, max(v46, v49)))
    excess_mp = max(abs(angle14) - high5, max(abs(angle6) - high2, max(v47, v48)))
    excess_mm = max(abs(angle15) - high5, max(abs(angle7) - high2, max(v47, v49)))
    outside_ppp = 0.0 < excess_pp
    outside_pmp = 0.0 < excess_pm
    outside_mpp = 0.0 < excess_mp
    outside_mmp = 0.0 < excess_mm

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if (
        abs(excess_mm - graze) <= graze or abs(excess_mp - graze) <= graze or abs(excess_pp - graze)
        <= graze or abs(excess_pm - graze) <= graze
    ):
        return False

    q[0, 0] = q1_ppp
    q[0, 1] = angle4
    q[0, 2] = q3_ppp
    q[0, 3] = angle8
    q[0, 4] = angle12
    q[0, 5] = angle16
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else (OUT_OF_LIMITS if outside_ppp else OK)
    q[1, 0] = q1_ppp
    q[1, 1] = angle4
    q[1, 2] = q3_ppp
    q[1, 3] = q4_ppm
    q[1, 4] = -angle12
    q[1, 5] = q6_ppm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else (OUT_OF_LIMITS if outside_ppp else OK)
    q[2, 0] = q1_ppp
    q[2, 1] = angle5
    q[2, 2] = q3_pmp
    q[2, 3] = angle9
    q[2, 4] = angle13
    q[2, 5] = angle17
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else (OUT_OF_LIMITS if outside_pmp else OK)
    q[3, 0] = q1_ppp
    q[3, 1] = angle5
    q[3, 2] = q3_pmp
    q[3, 3] = q4_pmm
    q[3, 4] = -angle13
    q[3, 5] = q6_pmm
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else (OUT_OF_LIMITS if outside_pmp else OK)
    q[4, 0] = q1_mpp
    q[4, 1] = angle6
    q[4, 2] = q3_ppp
    q[4, 3] = angle10
    q[4, 4] = angle14
    q[4, 5] = angle18
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else (OUT_OF_LIMITS if outside_mpp else OK)
    q[5, 0] = q1_mpp
    q[5, 1] = angle6
    q[5, 2] = q3_ppp
    q[5, 3] = q4_mpm
    q[5, 4] = -angle14
    q[5, 5] = q6_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else (OUT_OF_LIMITS if outside_mpp else OK)
    q[6, 0] = q1_mpp
    q[6, 1] = angle7
    q[6, 2] = q3_pmp
    q[6, 3] = angle11
    q[6, 4] = angle15
    q[6, 5] = angle19
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else (OUT_OF_LIMITS if outside_mmp else OK)
    q[7, 0] = q1_mpp
    q[7, 1] = angle7
    q[7, 2] = q3_pmp
    q[7, 3] = q4_mmm
    q[7, 4] = -angle15
    q[7, 5] = q6_mmm
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
    [1232, 1248, 1264, 1280, 1296, 1312],
    [1232, 1248, 1264, 1328, 1344, 1360],
    [1232, 1376, 1392, 1408, 1424, 1440],
    [1232, 1376, 1392, 1456, 1472, 1488],
    [1504, 1520, 1264, 1536, 1552, 1568],
    [1504, 1520, 1264, 1584, 1600, 1616],
    [1504, 1632, 1392, 1648, 1664, 1680],
    [1504, 1632, 1392, 1696, 1712, 1728],
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
            N1 = T14 * T14 + T24 * T24
            D1 = N1 - k1
            w1 = math.sqrt(D1)
            v1 = w1 - w1
            inverse1 = 1.0 / N1
            v2 = inverse1 * (d3 * T24)
            v3 = w1 * (T14 * inverse1)
            c1_p = v3 - v2
            v4 = v2 + v3
            v5 = inverse1 * (d3 * T14)
            v6 = w1 * (T24 * inverse1)
            s1_p = v5 + v6
            s1_m = v5 - v6
            Z1_3 = T34 - d1
            N3 = D1 + Z1_3 * Z1_3
            D3 = (longest3 - N3) * (N3 - shortest3)
            w3 = math.sqrt(D3)
            v7 = w3 - w3
            v8 = m4 - m5 * N3
            v9 = m3 * w3
            s3_p = v8 + v9
            s3_m = v8 - v9
            v10 = m3 * N3 - m6
            v11 = m5 * w3
            c3_p = v10 + v11
            c3_m = v10 - v11
            X1_2 = m7 * N3 - m8
            v13 = Z1_3 * X1_2
            v14 = w3 * (m7 * w1)
            S2_pp = v13 - v14
            S2_pm = v13 + v14
            v15 = w3 * (m7 * Z1_3)
            v16 = w3 * (m7 * -Z1_3)
            v17 = w1 * X1_2
            v18 = w1 * -X1_2
            C2_pp = v15 + v17
            C2_pm = v16 + v17
            C2_mp = v15 + v18
            C2_mm = v16 + v18
            factor2 = 1.0 / N3
            c23_pp = c3_p * C2_pp - s3_p * S2_pp
            c23_pm = c3_m * C2_pm - s3_m * S2_pm
            c23_mp = c3_p * C2_mp - s3_p * S2_pm
            c23_mm = c3_m * C2_mm - s3_m * S2_pp
            s23_pp = c3_p * S2_pp + s3_p * C2_pp
            s23_pm = c3_m * S2_pm + s3_m * C2_pm
            s23_mp = c3_p * S2_pm + s3_p * C2_mp
            s23_mm = c3_m * S2_pp + s3_m * C2_mm
            v19 = c1_p * T13 + s1_p * T23
            v20 = s1_m * T23 - v4 * T13
            c4_pp = c23_pp * v19 + s23_pp * T33
            c4_pm = c23_pm * v19 + s23_pm * T33
            c4_mp = c23_mp * v20 + s23_mp * T33
            c4_mm = c23_mm * v20 + s23_mm * T33
            Y4_p = c1_p * T23 - s1_p * T13
            v21 = v4 * T23 + s1_m * T13
            v22 = Y4_p * Y4_p
            v23 = v21 * v21
            v24 = factor2 * c4_pp
            v25 = factor2 * c4_pm
            v26 = factor2 * c4_mp
            v27 = factor2 * c4_mm
            v28 = v22 + factor2 * (c4_pp * v24)
            v29 = v22 + factor2 * (c4_pm * v25)
            v30 = v23 + factor2 * (c4_mp * v26)
            v31 = v23 + factor2 * (c4_mm * v27)
            v32 = math.copysign(half_turn, Y4_p)
            v33 = math.copysign(half_turn, -v21)
            v34 = s1_p * T12 - c1_p * T22
            v35 = s1_m * T12 + v4 * T22
            v36 = c1_p * T12 + s1_p * T22
            v37 = s1_m * T22 - v4 * T12
            v38 = s1_p * T11 - c1_p * T21
            v39 = s1_m * T11 + v4 * T21
            v40 = c1_p * T11 + s1_p * T21
            v41 = s1_m * T21 - v4 * T11
            v42 = v21 * (c23_mp * v41 + s23_mp * T31) - c4_mp * v39
            v43 = v21 * (c23_mm * v41 + s23_mm * T31) - c4_mm * v39
            work[272 + k] = D1
            work[288 + k] = w1
            work[304 + k] = v1
            work[320 + k] = D3
            work[336 + k] = v7
            work[352 + k] = c23_pp
            work[368 + k] = c23_pm
            work[384 + k] = s23_pp
            work[400 + k] = s23_pm
            work[416 + k] = c4_pp
            work[432 + k] = c4_pm
            work[448 + k] = Y4_p
            work[464 + k] = v28
            work[480 + k] = v29
            work[496 + k] = v30
            work[512 + k] = v31
            work[528 + k] = v32
            work[544 + k] = v33
            work[560 + k] = v38
            work[576 + k] = v40
            work[592 + k] = v42
            work[608 + k] = v43
            work[624 + k] = s1_p
            work[640 + k] = s1_m
            work[656 + k] = w3
            work[672 + k] = S2_pp
            work[688 + k] = S2_pm
            work[704 + k] = S2_pm
            work[720 + k] = S2_pp
            work[736 + k] = Y4_p
            work[752 + k] = Y4_p
            work[768 + k] = -v21
            work[784 + k] = -v21
            work[800 + k] = -math.sqrt(v28)
            work[816 + k] = -math.sqrt(v29)
            work[832 + k] = -math.sqrt(v30)
            work[848 + k] = -math.sqrt(v31)
            work[864 + k] = -(c4_pp * v38 + Y4_p * (c23_pp * v40 + s23_pp * T31))
            work[880 + k] = -(c4_pm * v38 + Y4_p * (c23_pm * v40 + s23_pm * T31))
            work[896 + k] = v42
            work[912 + k] = v43
            work[928 + k] = c1_p
            work[944 + k] = -v4
            work[960 + k] = N3 - k7
            work[976 + k] = C2_pp
            work[992 + k] = C2_pm
            work[1008 + k] = C2_mp
            work[1024 + k] = C2_mm
            work[1040 + k] = v24
            work[1056 + k] = v25
            work[1072 + k] = v26
            work[1088 + k] = v27
            work[1104 + k] = factor2 * (c23_pp * T33 - s23_pp * v19)
            work[1120 + k] = factor2 * (c23_pm * T33 - s23_pm * v19)
            work[1136 + k] = factor2 * (c23_mp * T33 - s23_mp * v20)
            work[1152 + k] = factor2 * (c23_mm * T33 - s23_mm * v20)
            work[1168 + k] = -(c4_pp * v34 + Y4_p * (c23_pp * v36 + s23_pp * T32))
            work[1184 + k] = -(c4_pm * v34 + Y4_p * (c23_pm * v36 + s23_pm * T32))
            work[1200 + k] = v21 * (c23_mp * v37 + s23_mp * T32) - c4_mp * v35
            work[1216 + k] = v21 * (c23_mm * v37 + s23_mm * T32) - c4_mm * v35
        for k in range(624, 928):
            work[k] = _atan2(work[k], work[k + 304])
        for k in range(0, 16):
            T31 = work[128 + k]
            D1 = work[272 + k]
            w1 = work[288 + k]
            v1 = work[304 + k]
            D3 = work[320 + k]
            v7 = work[336 + k]
            c23_pp = work[352 + k]
            c23_pm = work[368 + k]
            s23_pp = work[384 + k]
            s23_pm = work[400 + k]
            c4_pp = work[416 + k]
            c4_pm = work[432 + k]
            Y4_p = work[448 + k]
            v28 = work[464 + k]
            v29 = work[480 + k]
            v30 = work[496 + k]
            v31 = work[512 + k]
            v32 = work[528 + k]
            v33 = work[544 + k]
            v38 = work[560 + k]
            v40 = work[576 + k]
            v42 = work[592 + k]
            v43 = work[608 + k]
            angle1 = work[624 + k]
            angle2 = work[640 + k]
            angle3 = work[656 + k]
            angle4 = work[672 + k]
            angle5 = work[688 + k]
            angle6 = work[704 + k]
            angle7 = work[720 + k]
            angle8 = work[736 + k]
            angle9 = work[752 + k]
            angle10 = work[768 + k]
            angle11 = work[784 + k]
            angle12 = work[800 + k]
            angle13 = work[816 + k]
            angle14 = work[832 + k]
            angle15 = work[848 + k]
            angle16 = work[864 + k]
            angle17 = work[880 + k]
            angle18 = work[896 + k]
            angle19 = work[912 + k]
            q3__p = angle3 - turn1
            v12 = turn1 + angle3
            q4_ppm = angle8 - v32
            q4_pmm = angle9 - v32
            q4_mpm = angle10 - v33
            q4_mmm = angle11 - v33
            q6_ppm = (
                angle16 - math.copysign(half_turn, -(c4_pp * v38 + Y4_p * (c23_pp * v40 + s23_pp *
                T31)))
            )
            q6_pmm = (
                angle17 - math.copysign(half_turn, -(c4_pm * v38 + Y4_p * (c23_pm * v40 + s23_pm *
                T31)))
            )
            q6_mpm = angle18 - math.copysign(half_turn, v42)
            q6_mmm = angle19 - math.copysign(half_turn, v43)
            v44 = q3__p + (turn if q3__p <= -half_turn else 0.0)
            v45 = (turn if -v12 <= -half_turn else 0.0) - v12
            v46 = abs(angle1) - high1
            v47 = abs(angle2) - high1
            v48 = abs(v44) - high3
            v49 = abs(v45) - high3
            q1_ppp = angle1 + v7
            q1_mpp = angle2 + v7
            q3_ppp = v1 + v44
            q3_pmp = v1 + v45
            excess_pp = max(abs(angle12) - high5, max(abs(angle4) - high2, max(v46, v48)))
            excess_pm = max(abs(angle13) - high5, max(abs(angle5) - high2, max(v46, v49)))
            excess_mp = max(abs(angle14) - high5, max(abs(angle6) - high2, max(v47, v48)))
            excess_mm = max(abs(angle15) - high5, max(abs(angle7) - high2, max(v47, v49)))
            outside_ppp = 0.0 < excess_pp
            outside_pmp = 0.0 < excess_pm
            outside_mpp = 0.0 < excess_mp
            outside_mmp = 0.0 < excess_mm
            _1232 = q1_ppp
            work[1232 + k] = _1232
            _1248 = angle4
            work[1248 + k] = _1248
            _1264 = q3_ppp
            work[1264 + k] = _1264
            _1280 = angle8
            work[1280 + k] = _1280
            _1296 = angle12
            work[1296 + k] = _1296
            _1312 = angle16
            work[1312 + k] = _1312
            _1328 = q4_ppm
            work[1328 + k] = _1328
            _1344 = -angle12
            work[1344 + k] = _1344
            _1360 = q6_ppm
            work[1360 + k] = _1360
            _1376 = angle5
            work[1376 + k] = _1376
            _1392 = q3_pmp
            work[1392 + k] = _1392
            _1408 = angle9
            work[1408 + k] = _1408
            _1424 = angle13
            work[1424 + k] = _1424
            _1440 = angle17
            work[1440 + k] = _1440
            _1456 = q4_pmm
            work[1456 + k] = _1456
            _1472 = -angle13
            work[1472 + k] = _1472
            _1488 = q6_pmm
            work[1488 + k] = _1488
            _1504 = q1_mpp
            work[1504 + k] = _1504
            _1520 = angle6
            work[1520 + k] = _1520
            _1536 = angle10
            work[1536 + k] = _1536
            _1552 = angle14
            work[1552 + k] = _1552
            _1568 = angle18
            work[1568 + k] = _1568
            _1584 = q4_mpm
            work[1584 + k] = _1584
            _1600 = -angle14
            work[1600 + k] = _1600
            _1616 = q6_mpm
            work[1616 + k] = _1616
            _1632 = angle7
            work[1632 + k] = _1632
            _1648 = angle11
            work[1648 + k] = _1648
            _1664 = angle15
            work[1664 + k] = _1664
            _1680 = angle19
            work[1680 + k] = _1680
            _1696 = q4_mmm
            work[1696 + k] = _1696
            _1712 = -angle15
            work[1712 + k] = _1712
            _1728 = q6_mmm
            work[1728 + k] = _1728
            work[1744 + k] = (
                UNREACHABLE if _1232 != _1232 else (OUT_OF_LIMITS if outside_ppp else OK)
            )
            work[1760 + k] = (
                UNREACHABLE if _1232 != _1232 else (OUT_OF_LIMITS if outside_ppp else OK)
            )
            work[1776 + k] = (
                UNREACHABLE if _1232 != _1232 else (OUT_OF_LIMITS if outside_pmp else OK)
            )
            work[1792 + k] = (
                UNREACHABLE if _1232 != _1232 else (OUT_OF_LIMITS if outside_pmp else OK)
            )
            work[1808 + k] = (
                UNREACHABLE if _1504 != _1504 else (OUT_OF_LIMITS if outside_mpp else OK)
            )
            work[1824 + k] = (
                UNREACHABLE if _1504 != _1504 else (OUT_OF_LIMITS if outside_mpp else OK)
            )
            work[1840 + k] = (
                UNREACHABLE if _1504 != _1504 else (OUT_OF_LIMITS if outside_mmp else OK)
            )
            work[1856 + k] = (
                UNREACHABLE if _1504 != _1504 else (OUT_OF_LIMITS if outside_mmp else OK)
            )
            work[256 + k] = (
                1.0 if abs(D3 * (k4 * w1)) <= m2 or abs(D1) <= m1 or v31 <= m9 or v30 <= m9 or v28
                <= m9 or v29 <= m9 else work[256 + k]
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
