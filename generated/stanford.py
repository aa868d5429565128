"""stanford: Stanford arm.

Inverse kinematics, generated from robots/stanford.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/stanford.yaml. The formulas and where they come from: stanford.md.

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

NAME = "stanford"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRPRRR"
JOINT_LIMITS = (
    (-2.9670597283903604, 2.9670597283903604),
    (-2.9670597283903604, 2.9670597283903604),
    (0.3048, 1.27),
    (-2.9670597283903604, 2.9670597283903604),
    (-1.5707963267948966, 1.5707963267948966),
    (-2.9670597283903604, 2.9670597283903604),
)
BRANCHES = (
    "right-forward-noflip",
    "right-forward-flip",
    "right-backward-noflip",
    "right-backward-flip",
    "left-forward-noflip",
    "left-forward-flip",
    "left-backward-noflip",
    "left-backward-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.412  # joint offset 1 [m]
d2 = 0.154  # joint offset 2 [m]
a3 = 0.0203  # link length 3 [m]
free_limit_squared2 = 1.6129e-24  # square of a length that fixes no angle [m^2]
free_limit1 = 1.27e-12  # a length that fixes no angle [m]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.13369999999999999  # d2 - a3 [m]
k2 = 0.01787569  # k1^2 [m^2]
k3 = 3.395980000001613e-14  # reach_slack1 * (2 * k1 + reach_slack1) [m^2]
k4 = 3.3959800000001613e-15  # merge_slack1 * (2 * k1 + merge_slack1) [m^2]
high1 = 2.9670597293903604
high2 = 2.9670597293903604
low3 = 0.30479999873
high3 = 1.2700000012700001
per_size = 0.7874015748031495
high4 = 2.9670597293903604
high5 = 1.5707963277948966
high6 = 2.9670597293903604
graze = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 3.3959800000001614e-12  # 1000 * k4 [m^2]
m2 = 1.6129e-08  # doubt_limit1^2 [m^2]
m4 = 9.999999999999999e-09  # doubt_limit^2

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 1.27e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 0.62000124000248, 1.0, 1.0, 1.0])
_JOINTS = np.column_stack([_LOWEST, _HIGHEST, [kind == "R" for kind in JOINT_TYPES], _WEIGHT])
# Of the values of a free joint that are tried, from one to the next.
_FAN_STEP = np.array([
    0.09817477042468103, 0.09817477042468103, 0.030162500000000002, 0.09817477042468103,
    0.09817477042468103, 0.09817477042468103,
])


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
    z2_x = c1 * s2
    z2_y = s1 * s2
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = s1 * c4 + x2_x * s4
    x4_y = x2_y * s4 - c1 * c4
    v1 = s2 * s4
    z4_x = x2_x * c4 - s1 * s4
    z4_y = x2_y * c4 + c1 * s4
    v2 = s2 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 - z2_x * s5
    x5_y = x4_y * c5 - z2_y * s5
    v3 = v1 * c5 + c2 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 + z4_x * s6
    T[0, 1] = z4_x * c6 - x5_x * s6
    T[0, 2] = z2_x * c5 + x4_x * s5
    T[0, 3] = z2_x * q[2] - s1 * d2 + s1 * a3
    T[1, 0] = x5_y * c6 + z4_y * s6
    T[1, 1] = z4_y * c6 - x5_y * s6
    T[1, 2] = z2_y * c5 + x4_y * s5
    T[1, 3] = c1 * d2 + z2_y * q[2] - c1 * a3
    T[2, 0] = -(v3 * c6 + v2 * s6)
    T[2, 1] = v3 * s6 - v2 * c6
    T[2, 2] = c2 * c5 - v1 * s5
    T[2, 3] = d1 + c2 * q[2]
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
    z2_x = c1 * s2
    z2_y = s1 * s2
    p3_x = z2_x * q[2] - s1 * d2 + s1 * a3
    p3_y = c1 * d2 + z2_y * q[2] - c1 * a3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v1 = d1 + c2 * q[2] - d1
    J[0, 0] = -p3_y
    J[0, 1] = c1 * v1
    J[0, 2] = z2_x
    J[1, 0] = p3_x
    J[1, 1] = s1 * v1
    J[1, 2] = z2_y
    J[2, 1] = -(s1 * p3_y + c1 * p3_x)
    J[2, 2] = c2
    J[3, 1] = -s1
    J[3, 3] = z2_x
    J[3, 4] = x2_x * c4 - s1 * s4
    J[3, 5] = z2_x * c5 + (s1 * c4 + x2_x * s4) * s5
    J[4, 1] = c1
    J[4, 3] = z2_y
    J[4, 4] = x2_y * c4 + c1 * s4
    J[4, 5] = z2_y * c5 + (x2_y * s4 - c1 * c4) * s5
    J[5, 0] = 1.0
    J[5, 3] = c2
    J[5, 4] = -(s2 * c4)
    J[5, 5] = c2 * c5 - s2 * s4 * s5
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[3, 4]
    N1 = T14 * T14 + T24 * T24
    free1 = N1 <= free_limit_squared2
    D1 = N1 - k2
    apart1 = k4 < D1
    if not (-k3 <= D1):
        return  # out of reach
    w1 = math.sqrt(D1 if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else k1 * math.sqrt(N1)))
    v1 = T14 * k1
    v2 = T24 * k1

    # theta2, r3, type 4: U1[1, 4] and U1[2, 4]
    Y2_2 = T34 - d1
    v3 = Y2_2 * Y2_2

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        root1 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else inverse1 * (v2 - T14 * root1)
        s1 = math.sin(seed[0]) if free1 else -(inverse1 * (v1 + T24 * root1))
        q1 = _atan2(s1, c1)

        # theta2, r3
        w3 = math.sqrt(root1 * root1 + v3)
        free2 = w3 <= free_limit1
        divisor2 = 1.0 if free2 else w3

        # theta4, type 2: U4[3, 3]
        X4 = T13 * s1 - T23 * c1
        v4 = T13 * c1 + T23 * s1
        v5 = X4 * X4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v6 = T12 * c1 + T22 * s1
        v8 = T22 * c1 - T12 * s1
        v9 = T11 * c1 + T21 * s1
        v11 = T21 * c1 - T11 * s1

        for i2 in range(2):  # forward, backward
            e2 = 1.0 - 2.0 * i2
            # theta2, r3
            if e2 < 0.0 and free2:
                continue  # both signs give the same
            factor2 = e2 / divisor2
            c2 = math.cos(seed[1]) if free2 else Y2_2 * factor2
            s2 = math.sin(seed[1]) if free2 else -(root1 * factor2)
            q2 = _atan2(s2, c2)
            r3 = w3 * e2

            # theta4
            Y4 = T33 * s2 - c2 * v4
            w4 = math.sqrt(v5 + Y4 * Y4)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T33 * c2 + s2 * v4

            # theta6
            v7 = c2 * v6 - T32 * s2
            v10 = c2 * v9 - T31 * s2

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4
                if e3 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e3 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)

                # theta5
                q5 = _atan2(-(w4 * e3), c5)

                # theta6
                c6 = c4 * v7 + s4 * v8
                s6 = c4 * v10 + s4 * v11
                q6 = _atan2(s6, c6)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0] = q1
                q[row, 1] = q2
                q[row, 2] = r3
                q[row, 3] = q4
                q[row, 4] = q5
                q[row, 5] = q6
                status[row] = FREE_JOINT if free1 or free2 or free4 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px * px * px) and math.isfinite(py * py * py) and math.isfinite(pz * pz * pz), pose


@_inner
def _overshoot(joint, value):
    """How far a joint value is beyond its limits, whole turns aside; negative below."""
    low, high = _LOWEST[joint] + _SLACK[joint], _HIGHEST[joint] - _SLACK[joint]
    if low <= value <= high:
        return 0.0
    off = value - high if value > high else value - low
    gap, over = turn - (high - low), value - high
    rest = over - turn * math.floor(over / turn)
    if _REVOLUTE[joint]:
        off = 0.0 if rest >= gap else rest if rest <= gap - rest else rest - gap
    return 0.0 if abs(off) <= 0.5 * _SLACK[joint] else off


@_inner
def _beyond_limits(values):
    """The same of a row."""
    total = 0.0
    for i in range(6):
        total += abs(_overshoot(i, values[i])) * math.sqrt(_WEIGHT[i])
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
    step, nearest, here = _FAN_STEP[search[1]], math.nan, -math.inf
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
        seed[joint] = _without_turns(given[joint]) if _REVOLUTE[joint] else inside
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
_PACE = np.array([1.0, 1.0, 1.27, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.7874, 0.7874, 0.7874, 1.0, 1.0, 1.0])


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
        if _REVOLUTE[i]:
            off -= turn * math.floor(off / turn + 0.5)
        most = max(most, abs(off) * math.sqrt(_WEIGHT[i]))
        half[i] = x[i] + 0.5 * off
    return most


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
            off = _overshoot(j, x[j]) if _PACE[j] > 0.0 else 0.0
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
def _stand(pose, row, far, rows, status):
    """Puts a row's joints just beyond their limits on them, unless that is another solution; those
    that are far beyond them, too, if that is asked for. Returns if it did.

    Half way to the same there is one, and what is nearer to another row that is less far beyond is
    that one's.
    """
    q = rows[row]
    beyond = _beyond_limits(q)
    if not (0.0 < beyond and (far or beyond < 0.01)):
        return False
    x, half, to = q.copy(), np.empty(6), np.empty(6)
    if not _settle(pose, math.nan, math.inf if far else 1.5, x):
        return False
    off = _half_way(q, x, half)
    for k in range(len(rows)):
        if status[k] != UNREACHABLE and _beyond_limits(rows[k]) < beyond:
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
        x[i] = seed[i] - _overshoot(i, seed[i])
    if not _settle(pose, 1e-12, 0.15, x):
        return
    if _beyond_limits(x) > 1e-09 and not _settle(pose, math.nan, 0.15, x):
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
    if nearest > 1e-06 or _beyond_limits(q[place]) > 0.0:
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
    room = carray(_room(32), 32)

    # theta1, type 2: U1[3, 4]
    N1 = T14 * T14 + T24 * T24
    D1 = N1 - k2
    w1 = math.sqrt(D1)
    v1 = w1 - w1
    inverse1 = 1.0 / N1
    v2 = k1 * T14
    v3 = k1 * T24
    v4 = inverse1 * v3
    v5 = w1 * (T14 * inverse1)
    c1_p = v4 - v5
    c1_m = v4 + v5
    v6 = inverse1 * v2
    v7 = w1 * (T24 * inverse1)
    v8 = v6 + v7
    v9 = v6 - v7

    # theta2, r3, type 4: U1[1, 4] and U1[2, 4]
    Y2_2 = T34 - d1
    v10 = D1 + Y2_2 * Y2_2
    w3 = math.sqrt(v10)
    factor2 = w3 * (1.0 / v10)

    # theta4, type 2: U4[3, 3]
    c4_p = v8 * T13 + c1_p * T23
    c4_m = v9 * T13 + c1_m * T23
    v11 = inverse1 * (Y2_2 * (T14 * T13 + T24 * T23)) - T33
    v12 = inverse1 * (Y2_2 * (v2 * T23 - v3 * T13))
    Y4_p = v12 + w1 * v11
    Y4_m = v12 + w1 * -v11
    v13 = factor2 * Y4_p
    v14 = factor2 * Y4_m
    v15 = c4_p * c4_p + factor2 * (Y4_p * v13)
    v16 = c4_m * c4_m + factor2 * (Y4_m * v14)

    # theta5, type 3: U4[2, 3] and U4[1, 3]
    v17 = Y2_2 * T33

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v18 = T32 - inverse1 * (Y2_2 * (T14 * T12 + T24 * T22))
    v19 = inverse1 * (Y2_2 * (v3 * T12 - v2 * T22))
    v20 = T31 - inverse1 * (Y2_2 * (T14 * T11 + T24 * T21))
    v21 = inverse1 * (Y2_2 * (v3 * T11 - v2 * T21))
    s6_p = c4_p * (v21 + w1 * v20) + Y4_p * (c1_p * T21 + v8 * T11)
    s6_m = c4_m * (v21 + w1 * -v20) + Y4_m * (c1_m * T21 + v9 * T11)

    # joint values
    v26 = per_size * max(low3 - w3, w3 - high3)
    v27 = per_size * max(low3 + w3, -(high3 + w3))
    q3_ppp = v1 + w3
    q3_pmp = v1 - w3

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if v10 <= m2 or abs(D1) <= m1 or v15 <= m4 or v16 <= m4:
        return False

    # angles, side by side
    room[0] = -v8
    room[1] = -v9
    room[2] = -w1
    room[3] = v13
    room[4] = v14
    room[5] = -math.sqrt(v15)
    room[6] = -math.sqrt(v16)
    room[7] = s6_p
    room[8] = s6_m
    room[16] = c1_p
    room[17] = c1_m
    room[18] = Y2_2
    room[19] = c4_p
    room[20] = c4_m
    room[21] = factor2 * (v17 - w1 * (c1_p * T13 - v8 * T23))
    room[22] = factor2 * (v17 + w1 * (c1_m * T13 - v9 * T23))
    room[23] = c4_p * (v19 + w1 * v18) + Y4_p * (c1_p * T22 + v8 * T12)
    room[24] = c4_m * (v19 + w1 * -v18) + Y4_m * (c1_m * T22 + v9 * T12)
    for k in range(9, 16):
        room[k] = room[k + 16] = 1.0
    for k in range(16):
        room[k] = _atan2(room[k], room[k + 16])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]
    angle4 = room[3]
    angle5 = room[4]
    angle6 = room[5]
    angle7 = room[6]
    angle8 = room[7]
    angle9 = room[8]

    # theta2, r3, type 4: U1[1, 4] and U1[2, 4]
    q2_pmp = angle3 - math.copysign(half_turn, -w1)

    # theta4, type 2: U4[3, 3]
    q4_ppm = angle4 - math.copysign(half_turn, v13)
    q4_mpm = angle5 - math.copysign(half_turn, v14)

    # theta5, type 3: U4[2, 3] and U4[1, 3]
    q5_pmp = math.copysign(half_turn, -math.sqrt(v15)) - angle6
    q5_mmp = math.copysign(half_turn, -math.sqrt(v16)) - angle7

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    q6_ppm = angle8 - math.copysign(half_turn, s6_p)
    q6_mpm = angle9 - math.copysign(half_turn, s6_m)

    # joint values
    v22 = abs(angle1) - high1
    v23 = abs(angle2) - high1
    v24 = abs(angle3) - high2
    v25 = abs(q2_pmp) - high2
    v28 = abs(angle4) - high4
    v29 = abs(q4_ppm) - high4
    v30 = abs(angle5) - high4
    v31 = abs(q4_mpm) - high4
    v32 = abs(angle6) - high5
    v33 = abs(q5_pmp) - high5
    v34 = abs(angle7) - high5
    v35 = abs(q5_mmp) - high5
    v36 = max(v26, max(v22, v24))
    v37 = max(v27, max(v22, v25))
    v38 = max(v26, max(v23, v24))
    v39 = max(v27, max(v23, v25))
    v40 = abs(angle8) - high6
    excess_ppp = max(v40, max(v32, max(v28, v36)))
    v41 = abs(q6_ppm) - high6
    excess_ppm = max(v41, max(v32, max(v29, v36)))
    excess_pmp = max(v41, max(v33, max(v28, v37)))
    excess_pmm = max(v40, max(v33, max(v29, v37)))
    v42 = abs(angle9) - high6
    excess_mpp = max(v42, max(v34, max(v30, v38)))
    v43 = abs(q6_mpm) - high6
    excess_mpm = max(v43, max(v34, max(v31, v38)))
    excess_mmp = max(v43, max(v35, max(v30, v39)))
    excess_mmm = max(v42, max(v35, max(v31, v39)))
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

    q[0, 0] = angle1
    q[0, 1] = angle3
    q[0, 2] = q3_ppp
    q[0, 3] = angle4
    q[0, 4] = angle6
    q[0, 5] = angle8
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else (OUT_OF_LIMITS if outside_ppp else OK)
    q[1, 0] = angle1
    q[1, 1] = angle3
    q[1, 2] = q3_ppp
    q[1, 3] = q4_ppm
    q[1, 4] = -angle6
    q[1, 5] = q6_ppm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else (OUT_OF_LIMITS if outside_ppm else OK)
    q[2, 0] = angle1
    q[2, 1] = q2_pmp
    q[2, 2] = q3_pmp
    q[2, 3] = -angle4
    q[2, 4] = q5_pmp
    q[2, 5] = q6_ppm
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else (OUT_OF_LIMITS if outside_pmp else OK)
    q[3, 0] = angle1
    q[3, 1] = q2_pmp
    q[3, 2] = q3_pmp
    q[3, 3] = -q4_ppm
    q[3, 4] = -q5_pmp
    q[3, 5] = angle8
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else (OUT_OF_LIMITS if outside_pmm else OK)
    q[4, 0] = angle2
    q[4, 1] = -angle3
    q[4, 2] = q3_ppp
    q[4, 3] = angle5
    q[4, 4] = angle7
    q[4, 5] = angle9
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else (OUT_OF_LIMITS if outside_mpp else OK)
    q[5, 0] = angle2
    q[5, 1] = -angle3
    q[5, 2] = q3_ppp
    q[5, 3] = q4_mpm
    q[5, 4] = -angle7
    q[5, 5] = q6_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else (OUT_OF_LIMITS if outside_mpm else OK)
    q[6, 0] = angle2
    q[6, 1] = -q2_pmp
    q[6, 2] = q3_pmp
    q[6, 3] = -angle5
    q[6, 4] = q5_mmp
    q[6, 5] = q6_mpm
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else (OUT_OF_LIMITS if outside_mmp else OK)
    q[7, 0] = angle2
    q[7, 1] = -q2_pmp
    q[7, 2] = q3_pmp
    q[7, 3] = -q4_mpm
    q[7, 4] = -q5_mmp
    q[7, 5] = angle9
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
    [768, 784, 800, 816, 832, 848],
    [768, 784, 800, 864, 880, 896],
    [768, 912, 928, 944, 960, 896],
    [768, 912, 928, 976, 992, 848],
    [1008, 1024, 800, 1040, 1056, 1072],
    [1008, 1024, 800, 1088, 1104, 1120],
    [1008, 1136, 928, 1152, 1168, 1120],
    [1008, 1136, 928, 1184, 1200, 1072],
])
_KINDS = np.array([1216, 1232, 1248, 1264, 1280, 1296, 1312, 1328])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(1344), 1344)
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
                - 1.0) + 0.0 * (work[48 + k] * work[48 + k] * work[48 + k] + work[112 + k] *
                work[112 + k] * work[112 + k] + work[176 + k] * work[176 + k] * work[176 + k])
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
            D1 = N1 - k2
            w1 = math.sqrt(D1)
            v1 = w1 - w1
            inverse1 = 1.0 / N1
            v2 = k1 * T14
            v3 = k1 * T24
            v4 = inverse1 * v3
            v5 = w1 * (T14 * inverse1)
            c1_p = v4 - v5
            c1_m = v4 + v5
            v6 = inverse1 * v2
            v7 = w1 * (T24 * inverse1)
            v8 = v6 + v7
            v9 = v6 - v7
            Y2_2 = T34 - d1
            v10 = D1 + Y2_2 * Y2_2
            w3 = math.sqrt(v10)
            factor2 = w3 * (1.0 / v10)
            c4_p = v8 * T13 + c1_p * T23
            c4_m = v9 * T13 + c1_m * T23
            v11 = inverse1 * (Y2_2 * (T14 * T13 + T24 * T23)) - T33
            v12 = inverse1 * (Y2_2 * (v2 * T23 - v3 * T13))
            Y4_p = v12 + w1 * v11
            Y4_m = v12 + w1 * -v11
            v13 = factor2 * Y4_p
            v14 = factor2 * Y4_m
            v15 = c4_p * c4_p + factor2 * (Y4_p * v13)
            v16 = c4_m * c4_m + factor2 * (Y4_m * v14)
            v17 = Y2_2 * T33
            v18 = T32 - inverse1 * (Y2_2 * (T14 * T12 + T24 * T22))
            v19 = inverse1 * (Y2_2 * (v3 * T12 - v2 * T22))
            v20 = T31 - inverse1 * (Y2_2 * (T14 * T11 + T24 * T21))
            v21 = inverse1 * (Y2_2 * (v3 * T11 - v2 * T21))
            s6_p = c4_p * (v21 + w1 * v20) + Y4_p * (c1_p * T21 + v8 * T11)
            s6_m = c4_m * (v21 + w1 * -v20) + Y4_m * (c1_m * T21 + v9 * T11)
            v26 = per_size * max(low3 - w3, w3 - high3)
            v27 = per_size * max(low3 + w3, -(high3 + w3))
            q3_ppp = v1 + w3
            q3_pmp = v1 - w3
            work[272 + k] = D1
            work[288 + k] = w1
            work[304 + k] = v10
            work[320 + k] = v13
            work[336 + k] = v14
            work[352 + k] = v15
            work[368 + k] = v16
            work[384 + k] = s6_p
            work[400 + k] = s6_m
            work[416 + k] = v26
            work[432 + k] = v27
            work[448 + k] = q3_ppp
            work[464 + k] = q3_pmp
            work[480 + k] = -v8
            work[496 + k] = -v9
            work[512 + k] = -w1
            work[528 + k] = v13
            work[544 + k] = v14
            work[560 + k] = -math.sqrt(v15)
            work[576 + k] = -math.sqrt(v16)
            work[592 + k] = s6_p
            work[608 + k] = s6_m
            work[624 + k] = c1_p
            work[640 + k] = c1_m
            work[656 + k] = Y2_2
            work[672 + k] = c4_p
            work[688 + k] = c4_m
            work[704 + k] = factor2 * (v17 - w1 * (c1_p * T13 - v8 * T23))
            work[720 + k] = factor2 * (v17 + w1 * (c1_m * T13 - v9 * T23))
            work[736 + k] = c4_p * (v19 + w1 * v18) + Y4_p * (c1_p * T22 + v8 * T12)
            work[752 + k] = c4_m * (v19 + w1 * -v18) + Y4_m * (c1_m * T22 + v9 * T12)
        for k in range(480, 624):
            work[k] = _atan2(work[k], work[k + 144])
        for k in range(0, 16):
            D1 = work[272 + k]
            w1 = work[288 + k]
            v10 = work[304 + k]
            v13 = work[320 + k]
            v14 = work[336 + k]
            v15 = work[352 + k]
            v16 = work[368 + k]
            s6_p = work[384 + k]
            s6_m = work[400 + k]
            v26 = work[416 + k]
            v27 = work[432 + k]
            q3_ppp = work[448 + k]
            q3_pmp = work[464 + k]
            angle1 = work[480 + k]
            angle2 = work[496 + k]
            angle3 = work[512 + k]
            angle4 = work[528 + k]
            angle5 = work[544 + k]
            angle6 = work[560 + k]
            angle7 = work[576 + k]
            angle8 = work[592 + k]
            angle9 = work[608 + k]
            q2_pmp = angle3 - math.copysign(half_turn, -w1)
            q4_ppm = angle4 - math.copysign(half_turn, v13)
            q4_mpm = angle5 - math.copysign(half_turn, v14)
            q5_pmp = math.copysign(half_turn, -math.sqrt(v15)) - angle6
            q5_mmp = math.copysign(half_turn, -math.sqrt(v16)) - angle7
            q6_ppm = angle8 - math.copysign(half_turn, s6_p)
            q6_mpm = angle9 - math.copysign(half_turn, s6_m)
            v22 = abs(angle1) - high1
            v23 = abs(angle2) - high1
            v24 = abs(angle3) - high2
            v25 = abs(q2_pmp) - high2
            v28 = abs(angle4) - high4
            v29 = abs(q4_ppm) - high4
            v30 = abs(angle5) - high4
            v31 = abs(q4_mpm) - high4
            v32 = abs(angle6) - high5
            v33 = abs(q5_pmp) - high5
            v34 = abs(angle7) - high5
            v35 = abs(q5_mmp) - high5
            v36 = max(v26, max(v22, v24))
            v37 = max(v27, max(v22, v25))
            v38 = max(v26, max(v23, v24))
            v39 = max(v27, max(v23, v25))
            v40 = abs(angle8) - high6
            excess_ppp = max(v40, max(v32, max(v28, v36)))
            v41 = abs(q6_ppm) - high6
            excess_ppm = max(v41, max(v32, max(v29, v36)))
            excess_pmp = max(v41, max(v33, max(v28, v37)))
            excess_pmm = max(v40, max(v33, max(v29, v37)))
            v42 = abs(angle9) - high6
            excess_mpp = max(v42, max(v34, max(v30, v38)))
            v43 = abs(q6_mpm) - high6
            excess_mpm = max(v43, max(v34, max(v31, v38)))
            excess_mmp = max(v43, max(v35, max(v30, v39)))
            excess_mmm = max(v42, max(v35, max(v31, v39)))
            outside_ppp = 0.0 < excess_ppp
            outside_ppm = 0.0 < excess_ppm
            outside_pmp = 0.0 < excess_pmp
            outside_pmm = 0.0 < excess_pmm
            outside_mpp = 0.0 < excess_mpp
            outside_mpm = 0.0 < excess_mpm
            outside_mmp = 0.0 < excess_mmp
            outside_mmm = 0.0 < excess_mmm
            _768 = angle1
            work[768 + k] = _768
            _784 = angle3
            work[784 + k] = _784
            _800 = q3_ppp
            work[800 + k] = _800
            _816 = angle4
            work[816 + k] = _816
            _832 = angle6
            work[832 + k] = _832
            _848 = angle8
            work[848 + k] = _848
            _864 = q4_ppm
            work[864 + k] = _864
            _880 = -angle6
            work[880 + k] = _880
            _896 = q6_ppm
            work[896 + k] = _896
            _912 = q2_pmp
            work[912 + k] = _912
            _928 = q3_pmp
            work[928 + k] = _928
            _944 = -angle4
            work[944 + k] = _944
            _960 = q5_pmp
            work[960 + k] = _960
            _976 = -q4_ppm
            work[976 + k] = _976
            _992 = -q5_pmp
            work[992 + k] = _992
            _1008 = angle2
            work[1008 + k] = _1008
            _1024 = -angle3
            work[1024 + k] = _1024
            _1040 = angle5
            work[1040 + k] = _1040
            _1056 = angle7
            work[1056 + k] = _1056
            _1072 = angle9
            work[1072 + k] = _1072
            _1088 = q4_mpm
            work[1088 + k] = _1088
            _1104 = -angle7
            work[1104 + k] = _1104
            _1120 = q6_mpm
            work[1120 + k] = _1120
            _1136 = -q2_pmp
            work[1136 + k] = _1136
            _1152 = -angle5
            work[1152 + k] = _1152
            _1168 = q5_mmp
            work[1168 + k] = _1168
            _1184 = -q4_mpm
            work[1184 + k] = _1184
            _1200 = -q5_mmp
            work[1200 + k] = _1200
            work[1216 + k] = UNREACHABLE if _768 != _768 else (OUT_OF_LIMITS if outside_ppp else OK)
            work[1232 + k] = UNREACHABLE if _768 != _768 else (OUT_OF_LIMITS if outside_ppm else OK)
            work[1248 + k] = UNREACHABLE if _768 != _768 else (OUT_OF_LIMITS if outside_pmp else OK)
            work[1264 + k] = UNREACHABLE if _768 != _768 else (OUT_OF_LIMITS if outside_pmm else OK)
            work[1280 + k] = (
                UNREACHABLE if _1008 != _1008 else (OUT_OF_LIMITS if outside_mpp else OK)
            )
            work[1296 + k] = (
                UNREACHABLE if _1008 != _1008 else (OUT_OF_LIMITS if outside_mpm else OK)
            )
            work[1312 + k] = (
                UNREACHABLE if _1008 != _1008 else (OUT_OF_LIMITS if outside_mmp else OK)
            )
            work[1328 + k] = (
                UNREACHABLE if _1008 != _1008 else (OUT_OF_LIMITS if outside_mmm else OK)
            )
            work[256 + k] = (
                1.0 if v10 <= m2 or abs(D1) <= m1 or v15 <= m4 or v16 <= m4 else work[256 + k]
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
            "no_pose": "not finite or beyond 5e102, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)",
            "no_row": "the pose is out of reach",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
