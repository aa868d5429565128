"""scorbot_pointing: Scorbot (tool axis only).

Inverse kinematics, generated from robots/scorbot_pointing.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/scorbot_pointing.yaml. The formulas and where they come from:
scorbot_pointing.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
position T[0:3, 3] and the tool's z axis T[0:3, 2] counts; other entries are ignored.
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
_read_rows = _runtime("pose").read_pointing
_of_joints = _runtime("entry").of_joints(_HOW, 5)

NAME = "scorbot_pointing"
METHOD = "closed form"
DOF = 5
JOINT_TYPES = "RRRRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "back-down",
    "back-up",
    "front-up",
    "front-down",
)
MAX_SOLUTIONS = 4
FREE_JOINTS = (5,)  # from 1: the caller gives their values

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose, or a free joint's value is not finite

d1 = 0.349  # joint offset 1 [m]
a1 = 0.016  # link length 1 [m]
a2 = 0.221  # link length 2 [m]
a3 = 0.221  # link length 3 [m]
d5 = 0.145  # joint offset 5 [m]
second_weight = 0.952  # lengths count in arm sizes [m]
free_limit1 = 9.52e-13  # a length that fixes no angle [m]
free_limit = 1e-12  # a length that fixes no angle
longest3 = 0.195364  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
longest3_reach = 0.1953724157706304  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.1953639999999916  # the longest, where branches merge [m^2]
shortest3_apart = 9.06304e-29  # the shortest, where branches merge [m^2]
free_limit_squared2 = 9.063039999999997e-25  # square of a length that fixes no angle [m^2]
doubtful_slack = 0.01  # a row may miss the pose by this before it is tightened
doubtful_slack1 = 0.009519999999999999  # a row may miss the pose by this before it is tightened [m]
offset4 = 1.5707963267948966  # offset of joint 4 [rad]
k1 = 0.097682  # 2 * a3 * a2 [m^2]
k2 = 10.237300628570258  # 1 / k1 [m^-2]
m1 = 9.06304e-09  # doubt_limit1^2 [m^2]
m3 = 9.999999999999999e-09  # doubt_limit^2
m4 = 1.6442094386282138e-06  # -1 * (longest3 - longest3_reach) * (longest3_reach - shortest3) [m^4]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m5 = 1.6429994031951627e-12
m6 = 4.524886877828054  # a coefficient of Y1_2
m7 = 2.262443438914027  # a coefficient of Y1_2
m8 = 8.213869404159996e-17  # doubt_limit_squared2^2 [m^4]
m9 = 1e-24  # exact_slack^2
m10 = 9.063039999999996e-25  # exact_slack1^2 [m^2]
m11 = 2.7189119999999995e-10  # 3 * pose_slack1^2 [m^2]

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0, 1.0])
_JOINTS = np.column_stack([_LOWEST, _HIGHEST, [kind == "R" for kind in JOINT_TYPES], _WEIGHT])


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (5,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 5 joint values")
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
    y3_z = s2 * s3 - c2 * c3
    v6 = q[3] + offset4
    c4 = math.cos(v6)
    s4 = math.sin(v6)
    x4_x = x3_x * c4 - v4 * s4
    x4_y = x3_y * c4 - v5 * s4
    x4_z = y3_z * s4 - v3 * c4
    z4_x = v4 * c4 + x3_x * s4
    z4_y = v5 * c4 + x3_y * s4
    v7 = y3_z * c4 + v3 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    T[0, 0] = x4_x * c5 - s1 * s5
    T[0, 1] = -(s1 * c5 + x4_x * s5)
    T[0, 2] = z4_x
    T[0, 3] = c1 * a1 + x2_x * a2 + x3_x * a3 + z4_x * d5
    T[1, 0] = x4_y * c5 + c1 * s5
    T[1, 1] = c1 * c5 - x4_y * s5
    T[1, 2] = z4_y
    T[1, 3] = s1 * a1 + x2_y * a2 + x3_y * a3 + z4_y * d5
    T[2, 0] = x4_z * c5
    T[2, 1] = -(x4_z * s5)
    T[2, 2] = -v7
    T[2, 3] = d1 - s2 * a2 - v3 * a3 - v7 * d5
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 5): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 5 joint values")
    J = np.zeros((6, 5))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    p1_x = c1 * a1
    p1_y = s1 * a1
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * c2
    x2_y = s1 * c2
    v1 = c1 * s2
    v2 = s1 * s2
    p2_x = p1_x + x2_x * a2
    p2_y = p1_y + x2_y * a2
    p2_z = d1 - s2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v1 * s3
    x3_y = x2_y * c3 - v2 * s3
    v3 = s2 * c3 + c2 * s3
    p3_x = p2_x + x3_x * a3
    p3_y = p2_y + x3_y * a3
    p3_z = p2_z - v3 * a3
    v4 = q[3] + offset4
    c4 = math.cos(v4)
    s4 = math.sin(v4)
    z4_x = (v1 * c3 + x2_x * s3) * c4 + x3_x * s4
    z4_y = (v2 * c3 + x2_y * s3) * c4 + x3_y * s4
    v5 = (s2 * s3 - c2 * c3) * c4 + v3 * s4
    p5_x = p3_x + z4_x * d5
    p5_y = p3_y + z4_y * d5
    p5_z = p3_z - v5 * d5
    v6 = p5_z - d1
    v7 = p5_z - p2_z
    v8 = p5_x - p3_x
    v9 = p5_y - p3_y
    v10 = p5_z - p3_z
    J[0, 0] = -p5_y
    J[0, 1] = c1 * v6
    J[0, 2] = c1 * v7
    J[0, 3] = c1 * v10
    J[0, 4] = z4_y * v10 + v5 * v9
    J[1, 0] = p5_x
    J[1, 1] = s1 * v6
    J[1, 2] = s1 * v7
    J[1, 3] = s1 * v10
    J[1, 4] = -(v5 * v8 + z4_x * v10)
    J[2, 1] = -(s1 * (p5_y - p1_y) + c1 * (p5_x - p1_x))
    J[2, 2] = -(s1 * (p5_y - p2_y) + c1 * (p5_x - p2_x))
    J[2, 3] = -(s1 * v9 + c1 * v8)
    J[2, 4] = z4_x * v9 - z4_y * v8
    J[3, 1] = -s1
    J[3, 2] = -s1
    J[3, 3] = -s1
    J[3, 4] = z4_x
    J[4, 1] = c1
    J[4, 2] = c1
    J[4, 3] = c1
    J[4, 4] = z4_y
    J[5, 0] = 1.0
    J[5, 4] = -v5
    return J


_LOST = 128  # _LOST + j: the row was lost after joint j had been chosen freely
_NEARLY = 192  # _NEARLY + j: joint j is nearly free, and the row's second value is its angle


@_inner
def _missed_by(pose, q):
    """By how much joint values miss the entries that count: the root of the sum of squares."""
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
    y3_z = s2 * s3 - c2 * c3
    v6 = q[3] + offset4
    c4 = math.cos(v6)
    s4 = math.sin(v6)
    x4_x = x3_x * c4 - v4 * s4
    x4_y = x3_y * c4 - v5 * s4
    x4_z = y3_z * s4 - v3 * c4
    z4_x = v4 * c4 + x3_x * s4
    z4_y = v5 * c4 + x3_y * s4
    v7 = y3_z * c4 + v3 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    miss = 0.0
    off = z4_x - pose[2]
    miss += (1.0 * off) ** 2
    off = c1 * a1 + x2_x * a2 + x3_x * a3 + z4_x * d5 - pose[3]
    miss += (1.050420168067227 * off) ** 2
    off = z4_y - pose[6]
    miss += (1.0 * off) ** 2
    off = s1 * a1 + x2_y * a2 + x3_y * a3 + z4_y * d5 - pose[7]
    miss += (1.050420168067227 * off) ** 2
    off = -v7 - pose[10]
    miss += (1.0 * off) ** 2
    off = d1 - s2 * a2 - v3 * a3 - v7 * d5 - pose[11]
    miss += (1.050420168067227 * off) ** 2
    return math.sqrt(miss)


# The joints that are solved for, and whether they turn; what a step of one means, in rad or
# lengths, and the same over the arm's size. Below, u are these joints in units.
_SOLVED = np.array([0, 1, 2, 3])
_TURNING = np.array([True, True, True, True])
_UNIT = np.array([1.0, 1.0, 1.0, 1.0])
_MEASURE = np.array([1.050420168067227, 1.050420168067227, 1.050420168067227, 1.050420168067227])


@_inner
def _turn_vector(axis, cosine, vector):
    """The rotation vector of an axis times the sine, and the cosine."""
    sine = math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2])
    if sine < 1e-09 and cosine < 0.0:  # half a turn: any axis will do
        vector[0] = 1.5079644737231006
        vector[1] = 1.8849555921538759
        vector[2] = 2.0106192982974678
        return
    scale = 1.0 if sine < 1e-09 else math.atan2(sine, cosine) / sine
    for i in range(3):
        vector[i] = scale * axis[i]


@_inner
def _look(T, q, u, e, A):
    """By how much u misses the pose, into e and returned as a length, and its Jacobian into A."""
    for j in range(4):
        q[_SOLVED[j]] = _UNIT[j] * u[j]
    P, J = fk(q), jacobian(q)
    for j in range(4):
        column = _SOLVED[j]
        A[0, j] = _MEASURE[j] * J[0, column]
        A[1, j] = _MEASURE[j] * J[1, column]
        A[2, j] = _MEASURE[j] * J[2, column]
        along = P[0, 2] * J[3, column] + P[1, 2] * J[4, column] + P[2, 2] * J[5, column]
        for i in range(3):  # turning about z changes nothing
            A[3 + i, j] = J[3 + i, column] - along * P[i, 2]
    e[0] = (T[0, 3] - P[0, 3]) / 0.952
    e[1] = (T[1, 3] - P[1, 3]) / 0.952
    e[2] = (T[2, 3] - P[2, 3]) / 0.952
    axis = (
        P[1, 2] * T[2, 2] - P[2, 2] * T[1, 2],
        P[2, 2] * T[0, 2] - P[0, 2] * T[2, 2],
        P[0, 2] * T[1, 2] - P[1, 2] * T[0, 2],
    )
    cosine = P[0, 2] * T[0, 2] + P[1, 2] * T[1, 2] + P[2, 2] * T[2, 2]
    _turn_vector(axis, cosine, e[3:])
    square = 0.0
    for i in range(6):
        square += e[i] * e[i]
    return math.sqrt(square)


# What is added from start to start, in parts of the range: a direction that is like no other.
_STRIDE = np.array([0.8566748838545029, 0.733891856627126, 0.6287067210378086, 0.53859725722361])


@_inner
def _wrap_angles(u):
    """Moves angles by whole turns to (-pi, pi]."""
    for j in range(4):
        if _TURNING[j]:
            u[j] -= 6.283185307179586 * math.ceil(u[j] / 6.283185307179586 - 0.5)


@_inner
def _take(to, numbers):
    """Numbers into an array as long; for slices numba would compile the text of an error, too."""
    for i in range(len(numbers)):
        to[i] = numbers[i]


@_inner
def _shorten(step):
    """Makes a step no longer than it may be."""
    longest = 2.0
    for j in range(4):
        longest = max(longest, abs(step[j]))
    for j in range(4):
        step[j] *= 2.0 / longest


@_inner
def _damped_step(A, e, length, little, step):
    """The damped least squares step A' (A A' + damping)^-1 e, `little` the least damping.

    The rows of A, each with its share of the damping's root behind it, are made orthonormal one
    after another (modified Gram-Schmidt; used as by A. Bjorck, Numerics of Gram-Schmidt
    orthogonalization, 1994): the product A A' would lose half of the digits.
    """
    damping = 0.1 * min(length * length, 1.0) + little
    rows, y = np.zeros((6, 10)), np.empty(6)
    total = np.zeros(10)
    for i in range(6):
        for j in range(4):
            rows[i, j] = A[i, j]
        rows[i, 4 + i] = math.sqrt(damping)
        y[i] = e[i]
        for k in range(i):
            along = 0.0
            for j in range(10):
                along += rows[k, j] * rows[i, j]
            for j in range(10):
                rows[i, j] -= along * rows[k, j]
            y[i] -= along * y[k]
        square = 0.0
        for j in range(10):
            square += rows[i, j] * rows[i, j]
        inverse = 1.0 / math.sqrt(square)
        y[i] *= inverse
        for j in range(10):
            rows[i, j] *= inverse
    for i in range(5, -1, -1):
        missing = y[i]
        for j in range(10):
            missing -= rows[i, j] * total[j]
        for j in range(10):
            total[j] += missing * rows[i, j]
    for j in range(4):
        step[j] = total[j]


@_apart("float64(float64[:, ::1], int64, float64, float64[::1], float64[::1])")
def _descended(T, steps, exact, q, ahead):
    """Takes a row as far as steps help, and tells how long another one would be, into `ahead`.

    Returns by how much the row misses the pose then. Beside a singular place a step that is right
    may be long, and what it leaves, half of its square, far more than was missed.
    """
    e, A = np.empty(6), np.empty((6, 4))
    joints, u, step = q.copy(), np.empty(4), np.empty(4)
    for j in range(4):
        u[j] = q[_SOLVED[j]] / _UNIT[j]
    best, least, last, left = u.copy(), math.inf, math.inf, 0.0
    ahead[0] = math.inf
    for _ in range(steps + 1):
        length = _look(T, joints, u, e, A)
        _damped_step(A, e, length, 1e-26, step)
        slow = not length <= max(0.5 * last, left)
        if length < least:
            least, ahead[0] = length, np.abs(step).max()
            _take(best, u)
        if slow or (least <= 0.001 * exact and ahead[0] <= 0.0001):
            break
        _shorten(step)
        way = 0.0
        for j in range(4):
            u[j] += step[j]
            way += abs(step[j])
        last, left = length, 0.5 * way * way
    _wrap_angles(best)
    for j in range(4):
        q[_SOLVED[j]] = _UNIT[j] * best[j]
    return least


@_inner
def _tightened(T, exact, first, q):
    """Takes a row to where damped least squares lead, unless it is exact or can't be.

    Returns by how much it misses the pose then, and whether it was moved; `first` is what it misses
    the pose by before.
    """
    if first <= exact:
        return first, False
    end, moved = q.copy(), False
    least = _descended(T, 72, exact, end, np.empty(1))
    if least > exact:  # the pose is rounded, or this is no solution
        return first, False
    for i in range(5):
        moved = moved or q[i] != end[i]
        q[i] = end[i]
    return least, moved


@_inner
def _gap_between(q, other):
    """By how much the joint values of two rows differ at most."""
    gap = np.empty(4)
    for j in range(4):
        gap[j] = (q[_SOLVED[j]] - other[_SOLVED[j]]) / _UNIT[j]
    _wrap_angles(gap)
    return np.abs(gap).max()


@_inner
def _repeats(q, held, first, row):
    """Whether a row that was moved came to lie on one that missed by less at first."""
    for k in range(4):
        before = first[k] < first[row] or (k < row and first[k] <= first[row])
        if held[k] and before and _gap_between(q[k], q[row]) < 1e-06:
            return True
    return False


@_inner
def _exactness(pose):
    """What an exact row may miss: far away rounding is more."""
    distance = 1.0  # arm sizes
    distance = max(distance, abs(pose[3]) / 0.952)
    distance = max(distance, abs(pose[7]) / 0.952)
    distance = max(distance, abs(pose[11]) / 0.952)
    return 1e-12 * distance


@_inner
def _upper_rows(pose):
    """A pose as a matrix (3, 4)."""
    T = np.empty((3, 4))
    for i in range(3):
        for j in range(4):
            T[i, j] = pose[4 * i + j]
    return T


@_apart("void(float64[:, ::1], float64, float64[::1], float64[:, ::1], boolean[::1])")
def _tighten_rows(T, exact, miss, q, held):
    """Tightens the rows; ends those that do not fit, and all but one that have become the same.

    Where one is exact the pose has not been rounded: then all have to be exact.
    """
    moved, first = np.zeros(4, np.bool_), miss.copy()
    for row in range(4):
        if held[row]:
            miss[row], moved[row] = _tightened(T, exact, miss[row], q[row])
    least = math.inf
    for row in range(4):
        if held[row]:
            least = min(least, miss[row])
    enough = exact if least <= exact else 1e-05
    for row in range(4):
        held[row] = held[row] and miss[row] <= enough
    for row in range(4):
        if moved[row] and _repeats(q, held, first, row):
            held[row] = False


@_inner
def _tighten(pose, q, status):
    """Tightens the rows that have a solution; some may have none then."""
    exact = _exactness(pose)
    worst, miss = 0.0, carray(_room(4), 4)
    for row in range(4):
        miss[row] = 0.0 if status[row] == UNREACHABLE else _missed_by(pose, q[row])
        worst = max(worst, miss[row])
    if worst <= exact:
        return
    rows, held = q.copy(), np.empty(4, np.bool_)
    for row in range(4):
        held[row] = status[row] != UNREACHABLE
    _tighten_rows(_upper_rows(pose), exact, miss, rows, held)
    for row in range(4):
        if not held[row]:
            status[row] = UNREACHABLE
        for i in range(5):
            q[row, i] = rows[row, i] if held[row] else math.nan


@_inner
def _solve(pose, q_free, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others.

    The first value of a row that is _LOST says how far it is from a solution (negative).
    """
    _, _, T13, T14, _, _, T23, T24, _, _, T33, T34 = pose

    # theta1, type 2: U1[3, 4] and, where that is degenerate, U1[3, 3]
    sigma1 = math.copysign(second_weight, T14 * T13 + T24 * T23)
    Xhat1 = T14 + T13 * sigma1
    Yhat1 = T24 + T23 * sigma1
    w1 = math.sqrt(Xhat1 * Xhat1 + Yhat1 * Yhat1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta234, type 3: U1[2, 3] and U1[1, 3]
    v1 = T33 * T33

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v4 = T34 - d1

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(Xhat1 * factor1)
        s1 = math.sin(seed[0]) if free1 else -(Yhat1 * factor1)
        q1 = _atan2(s1, c1)

        # theta234
        Z2_234 = T13 * c1 + T23 * s1
        w234 = math.sqrt(Z2_234 * Z2_234 + v1)
        short234 = w234 <= free_limit
        v2 = 1.0 / (1.0 if short234 else w234)
        c234 = T33 * v2
        s234 = Z2_234 * v2
        theta234 = _atan2(s234, c234)

        # theta3
        v3 = c234 * d5
        Z1_3 = v4 - v3
        v5 = s234 * d5
        Z2_3 = T14 * c1 + T24 * s1 - a1 - v5
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
        K3 = N3 - k1
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            if free1:
                status[2 * i1] = _LOST + 1
                q[2 * i1, 0] = D3
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        c3 = K3 * k2

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        Y1_2 = a2 + a3 * c3
        v7 = Z1_3 * Y1_2
        v9 = Z2_3 * Y1_2

        # is the pose one that the arm can take?
        v10 = a1 + v5
        v12 = d1 + v3
        if (
            not (abs(T33 - c234) <= doubtful_slack and abs(T13 - c1 * s234) <= doubtful_slack and
            abs(T23 - s1 * s234) <= doubtful_slack)
        ):
            continue  # the arm can't take this pose

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            s3 = w3 * e2 * k2
            q3 = _atan2(s3, c3)

            # theta2
            v6 = a3 * s3
            v8 = Z2_3 * v6 + v7
            C2 = v9 - Z1_3 * v6
            w2 = math.sqrt(v8 * v8 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else -(v8 * factor2)
            q2 = _atan2(s2, c2)

            # is the pose one that the arm can take?
            c23 = c3 * c2 - s3 * s2
            s23 = c3 * s2 + s3 * c2
            v11 = a3 * c23 + (a2 * c2 + v10)
            if (
                not (abs(T34 + (a3 * s23 + (a2 * s2 - v12))) <= doubtful_slack1 and abs(T14 - c1 *
                v11) <= doubtful_slack1 and abs(T24 - s1 * v11) <= doubtful_slack1)
            ):
                continue  # the arm can't take this pose

            # joint values
            q4 = _wrap(theta234 - (q3 + q2) - offset4)
            row = 2 * i1 + i2
            q[row, 0] = q1
            q[row, 1] = q2
            q[row, 2] = q3
            q[row, 3] = q4
            q[row, 4] = q_free[0]
            status[row] = FREE_JOINT if free1 or free2 else OK


@_njit(forceinline=True)
def _read(T, q_free):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px) and math.isfinite(py) and math.isfinite(pz) and math.isfinite(q_free[0]), pose


@_inner
def _without_turns(angle):
    """An angle without its whole turns, by which a search could not tell small moves."""
    return math.copysign(abs(angle) % turn, angle)


_CHOOSABLE = (1, 0,)  # joints, from 0, that may be free


@_inner
def _serves(search, q, status):
    """Whether a row was solved, as exactly as poses may be rounded."""
    return status[search[0]] != UNREACHABLE and status[search[0]] < _LOST


@_inner
def _shortfall(pose, row, q, status):
    """How far a row is from a solution: 0 if it is solved.
    """
    if status[row] >= _LOST:
        return q[row, 0]
    return -math.inf if status[row] == UNREACHABLE else 0.0


@_inner
def _attempt(pose, q_free, seed, search, moved, q, status):
    """Solves with a joint moved: 0 if it serves, else less.

    A search is a row, the joint that had been chosen, whether limits count.
    """
    row, joint = search[0], search[1]
    for i in range(4):
        status[i] = UNREACHABLE
    kept = seed[joint]
    seed[joint] = kept + moved
    _solve(pose, q_free, seed, q, status)
    seed[joint] = kept
    return _shortfall(pose, row, q, status)


@_inner
def _peak(pose, q_free, seed, search, low, high, q, status):
    """Golden section for the move between low and high that comes nearest, or one that serves."""
    for _ in range(52):
        third = 0.3819660112501051 * (high - low)
        left = _attempt(pose, q_free, seed, search, low + third, q, status)
        right = _attempt(pose, q_free, seed, search, high - third, q, status)
        if left == 0.0 or right == 0.0:
            return low + third if left == 0.0 else high - third
        if left >= right:
            high -= third
        else:
            low += third
    return low


@_inner
def _summit(pose, q_free, seed, search, low, high, q, status):
    """A move between low and high that serves; NaN if there is none."""
    top = _peak(pose, q_free, seed, search, low, high, q, status)
    if _attempt(pose, q_free, seed, search, top, q, status) == 0.0:
        return top
    # beside a place where the branches meet, this one has no solution of its own
    for moved in (top - 1e-09, top + 1e-09):
        if math.isinf(_attempt(pose, q_free, seed, search, moved, q, status)):
            return math.nan
    _attempt(pose, q_free, seed, search, top, q, status)
    return top if _serves(search, q, status) else math.nan


@_inner
def _serving(pose, q_free, seed, search, q, status):
    """How far the joint has to be moved from the seed's value until it serves; NaN if nowhere.

    A fan of values shows where it serves or nearly so, golden section finds what lies between two
    of them, bisection the end that is nearest to the seed; of two that are equally near the lower
    one.
    """
    if _attempt(pose, q_free, seed, search, 0.0, q, status) == 0.0:
        return 0.0
    step, nearest, here = 0.09817477042468103, math.nan, -math.inf
    after = _attempt(pose, q_free, seed, search, -32.0 * step, q, status)
    for k in range(-32, 32 + 1):
        before, here = here, after
        after = _attempt(pose, q_free, seed, search, (k + 1) * step, q, status)
        outer = k * step
        inner = outer - step if k > 0 else outer + step if k < 0 else 0.0
        if here < 0.0 and here >= before and here > after:
            low, high = outer - step, outer + step
            outer = _summit(pose, q_free, seed, search, low, high, q, status)
            if math.isnan(outer):
                continue
        elif here < 0.0 or (before if k > 0 else after) == 0.0:
            continue
        for _ in range(52):
            middle = 0.5 * (inner + outer)
            if _attempt(pose, q_free, seed, search, middle, q, status) == 0.0:
                outer = middle
            else:
                inner = middle
        if not abs(outer) >= abs(nearest) - 1e-09:
            nearest = outer
    return nearest


@_inner
def _serving_digits(pose, q_free, seed, search, q, status):
    """The same for a joint that is nearly free: its angle is known to few digits.

    Also where the arm just reaches (an elbow that is stretched). As long as the angle is right up
    to rounding of what it was taken from, `_solve` takes it as it would take its own.
    """
    before, past = np.full(2, -math.inf), np.zeros(2)
    moved = 1e-15
    while moved < 0.1:
        for way in range(2):
            there = -moved if way else moved
            here = _attempt(pose, q_free, seed, search, there, q, status)
            if here == 0.0:
                return there
            if here < 2.0 * before[way] and past[way] == 0.0:
                past[way] = 1.0
                low = 0.25 * there
                top = _summit(pose, q_free, seed, search, low, there, q, status)
                if not math.isnan(top):
                    return top
            before[way] = here
        moved *= 2.0
    return math.nan


@_inner
def _choose_again(pose, q_free, given, row, q, status):
    """A free joint took the seed's value, and then the arm could not reach.

    The joint takes the nearest value that serves.
    """
    nearly = status[row] > _NEARLY
    search = row, status[row] - (_NEARLY if nearly else _LOST) - 1, False
    seed, trial, result = given.copy(), q.copy(), status.copy()
    if nearly:
        seed[search[1]] = q[row, 1]
        moved = _serving_digits(pose, q_free, seed, search, trial, result)
    else:
        seed[search[1]] = _without_turns(seed[search[1]])
        moved = _serving(pose, q_free, seed, search, trial, result)
    _attempt(pose, q_free, seed, search, moved, trial, result)
    served = not math.isnan(moved) and _serves(search, trial, result)
    status[row] = result[row] if served else UNREACHABLE
    for i in range(5):
        q[row, i] = trial[row, i] if served else math.nan


@_apart("void(UniTuple(float64, 12), float64[::1], float64[::1], float64[:, ::1], uint8[::1])")
def _other_choices(pose, q_free, seed, q, status):
    """Other values for free joints, in rows that the seed's do not serve."""
    for row in range(4):
        if status[row] >= _LOST:
            _choose_again(pose, q_free, seed, row, q, status)


@_inner
def _choose(pose, q_free, seed, q, status):
    """The same where there is a row that needs it."""
    served = True
    for row in range(4):
        served = served and status[row] < _LOST
    if served:
        return
    # arrays of the caller may have any layout
    values, rows, kinds = np.empty(5), np.empty((4, 5)), np.empty(4, np.uint8)
    for row in range(4):
        kinds[row] = status[row]
        for i in range(5):
            values[i], rows[row, i] = seed[i], q[row, i]
    _other_choices(pose, q_free.copy(), values, rows, kinds)
    for row in range(4):
        status[row] = kinds[row]
        for i in range(5):
            q[row, i] = rows[row, i]


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 1.0, 1.0, 0.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([1.05, 1.05, 1.05, 1.0, 1.0, 1.0])


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
        e[3 + i] = P[j, 2] * T[4 * k + 2] - P[k, 2] * T[4 * j + 2]
        square += (P[j, 2] - T[4 * j + 2]) ** 2
    return e, math.sqrt(square)


@_inner
def _add_step(held, damping, e, q):
    """Adds the damped least squares step that the miss e asks for to joint values.

    The rows of the Jacobian, each with its share of the damping's root, are made orthogonal one
    after another (modified Gram-Schmidt), twice: once would not do beside singular places.
    """
    J, rows, square = jacobian(q), np.zeros((6, 11)), np.zeros(6)
    P = fk(q)
    for j in range(5):  # turning about z changes nothing
        along = P[0, 2] * J[3, j] + P[1, 2] * J[4, j] + P[2, 2] * J[5, j]
        for i in range(3):
            J[3 + i, j] -= along * P[i, 2]
    for i in range(6):
        for j in range(5):
            rows[i, j] = 0.0 if held[j] else _PACE[j] * _MISS_WEIGHT[i] * J[i, j]
        rows[i, 5 + i] = math.sqrt(damping + 1e-26)
        for n in range(2 * i):
            k, along = n % i, 0.0
            for j in range(11):
                along += rows[k, j] * rows[i, j] / square[k]
            for j in range(11):
                rows[i, j] -= along * rows[k, j]
            e[i] -= along * e[k]
        for j in range(11):
            square[i] += rows[i, j] * rows[i, j]
        for j in range(5):
            q[j] += e[i] / square[i] * rows[i, j] * _PACE[j]


@_inner
def _half_way(x, q, half):
    """How far joint values are from others, but for whole turns [rad, arm sizes].

    Those half way go into half.
    """
    most = 0.0
    for i in range(5):
        off = q[i] - x[i]
        off -= turn * math.floor(off / turn + 0.5)
        most = max(most, abs(off))
        half[i] = x[i] + 0.5 * off
    return most


@_apart("boolean(UniTuple(float64, 12), float64, float64, float64[::1])")
def _settled(T, enough, most, q):
    """Takes joint values to some not farther than most that miss the pose by less than enough.

    Returns if it can.
    Damped least squares, while they gain: where roots meet a step still leaves less than half.
    Until one gains little they are damped so that none leads far.
    """
    half = np.empty(5)
    held, x, settled = np.zeros(5, np.bool_), q.copy(), False
    last, lost = math.inf, 0
    for _ in range(20):
        e, miss = _miss(T, x)
        if miss < enough:
            for i in range(5):
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
    values = np.empty(5)
    for i in range(5):
        values[i] = q[i]
    settled = _settled(pose, enough, most, values)
    for i in range(5):
        q[i] = values[i]
    return settled


# Between which values starts lie.
_SPAN_LOW = np.array([
    -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
])
_SPAN_WIDTH = np.array([6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586])


@_inner
def _start_of(k, near, u):
    """Start number k; number 0 is the seed."""
    for j in range(4):
        u[j] = near[j] if k == 0 else _SPAN_LOW[j] + _SPAN_WIDTH[j] * ((0.5 + k * _STRIDE[j]) % 1.0)


@_apart("float64(float64[:, ::1], float64[::1], float64[::1])")
def _descend(T, q, u):
    """Takes u to where damped least squares lead; returns by how much that misses the pose.

    Near to it less damping than usual leads further, where joints hardly move the tool: there a step
    that is right may be long, and what it leaves, half of its square, far more than was missed.
    """
    e, A = np.empty(6), np.empty((6, 4))
    least, best, step, little = math.inf, u.copy(), np.empty(4), 1e-13
    last, left = math.inf, 0.0  # the miss before a step, and what its curvature leaves
    for _ in range(40 + 1):
        length = _look(T, q, u, e, A)
        slow = length >= max(0.5 * last, left)
        stalled = slow and least <= (1e-10 if little < 1e-13 else 1e-12)
        if slow and least <= 1e-06:
            little = 1e-26
        if length < least:
            least = length
            _take(best, u)
        if stalled:
            break
        _damped_step(A, e, length, little, step)
        _shorten(step)
        way = 0.0
        for j in range(4):
            u[j] += step[j]
            way += abs(step[j])
        last, left = length, 0.5 * way * way if little < 1e-13 else 0.0
    _take(u, best)
    return least


@_apart("int64(UniTuple(float64, 12), float64[::1], float64[::1], int64, float64[::1])")
def _sought(pose, q_free, seed, least, q):
    """Joint values that serve, into q, if there are some with less wrong than `least`; what is.

    Nothing is 0, 1 that they are beyond limits, 2 that they are not exact, 4 that there are none.

    Several joints may be free at once, and few of their values serve. Steps of damped least squares
    from the seed and from evenly spread starts lead to some that do, if the arm can take the pose.
    """
    T, exact = _upper_rows(pose), _exactness(pose)
    joints, near = seed.copy(), np.empty(4)
    joints[4] = q_free[0]
    for j in range(4):
        near[j] = seed[_SOLVED[j]] / _UNIT[j]
    u, end = np.empty(4), np.empty(5)
    for k in range(12):
        if least == 0:
            break
        _start_of(k, near, u)
        if _descend(T, joints, u) > 1e-05:
            continue
        _take(end, joints)
        for j in range(4):
            end[_SOLVED[j]] = _UNIT[j] * u[j]
        miss = _descended(T, 72, exact, end, np.empty(1))
        if miss > 1e-05:
            continue
        fault = 2 * (miss > exact)
        if fault < least:
            least = fault
            _take(q, end)
    return least


@_inner
def _seek(pose, q_free, seed, begun, q, status):
    """The same into a row, if there is none, or only such as fit a pose that has been rounded."""
    before, chosen = 4, -1
    T, exact = _upper_rows(pose), _exactness(pose)
    here, ahead = np.empty(5), np.empty(1)
    for row in range(4 - 1, -1, -1):
        fault, is_open = 0, status[row] == FREE_JOINT
        if status[row] == UNREACHABLE:
            continue
        _take(here, q[row])
        fault += 2 * (_descended(T, 0, exact, here, ahead) > exact)
        is_open = is_open or ahead[0] > 0.0001  # a joint is nearly free
        before = min(before, fault)
        chosen = row if is_open else chosen
    if before == 0 or (before < 4 and chosen < 0):
        return
    found = np.empty(5)
    least = _sought(pose, q_free.copy(), seed.copy(), before, found)
    if least == before:
        return
    for row in range(4):
        status[row] = FREE_JOINT if row == begun else UNREACHABLE
        for i in range(5):
            q[row, i] = found[i] if row == begun else math.nan


@_inner
def _stay(pose, q_free, seed, q, status):
    """Where rounding can't tell solutions apart the arm goes on with the one that it is at.

    The solution next to the seed gets a row unless it has one: that of one beside
    it, that of one which it is told from by nothing, one that is left, or any.
    """
    x, half, place, least = np.empty(5), np.empty(5), 0, math.inf
    nearest = 0.001
    for i in range(5):
        x[i] = seed[i]
    x[4] = q_free[0]
    if not _settle(pose, 1e-12, 0.15, x):
        return
    for row in range(4 - 1, -1, -1):
        between = 1e-06
        if status[row] != UNREACHABLE:
            off = _half_way(x, q[row], half)
            between = max(_miss(pose, half)[1], 1e-12)
            if off < nearest:
                place, nearest, least = row, off, -1.0  # its own
        if between <= 2.0 * least:
            place = row
        least = min(least, between)
    if least >= 0.0:
        status[place] = FREE_JOINT
    if nearest > 1e-06:
        for i in range(5):
            q[place, i] = x[i]


@_jit
def _whole(pose, q_free, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(4):
        status[row] = UNREACHABLE
        for i in range(5):
            q[row, i] = math.nan
    _solve(pose, q_free, seed, q, status)
    begun = 0  # the first row that was not out of reach: here equations may have ended all
    for row in range(4 - 1, -1, -1):
        if status[row] != UNREACHABLE:
            begun = row
    _choose(pose, q_free, seed, q, status)
    _tighten(pose, q, status)
    _seek(pose, q_free, seed, begun, q, status)
    _stay(pose, q_free, seed, q, status)
    count = 0
    for row in range(4):
        if status[row] == UNREACHABLE:
            continue
        for i in range(5):
            q[row, i] = _turned(_JOINTS, i, q[row, i], 0.0 if _PACE[i] > 0.0 else q[row, i])
            if not _LOWEST[i] <= q[row, i] <= _HIGHEST[i]:
                status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


@_merged
def _regular(pose, q_free, q, status):
    """A pose at which no joint is free and no branches meet into q and status; False for others.

    What can't be reached is NaN by itself: it has the root of a negative number in it.
    """
    _, _, T13, T14, _, _, T23, T24, _, _, T33, T34 = pose
    room = carray(_room(16), 16)

    # theta1, type 2: U1[3, 4] and, where that is degenerate, U1[3, 3]
    sigma1 = math.copysign(second_weight, T14 * T13 + T24 * T23)
    Xhat1 = T14 + T13 * sigma1
    Yhat1 = T24 + T23 * sigma1
    v1 = Xhat1 * Xhat1 + Yhat1 * Yhat1
    w1 = math.sqrt(v1)
    v2 = 1.0 / v1
    factor1 = w1 * v2
    v3 = Xhat1 * factor1
    v4 = Yhat1 * factor1

    # theta234, type 3: U1[2, 3] and U1[1, 3]
    v5 = w1 * (v2 * (T13 * Xhat1 + T23 * Yhat1))
    v6 = T33 * T33 + v5 * v5
    w234 = math.sqrt(v6)
    v7 = 1.0 / v6
    v8 = w234 * v7

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v9 = d5 * T33
    v10 = T34 - d1
    v11 = v8 * v9
    Z1_3 = v10 - v11
    v12 = d5 * v5
    v13 = T14 * v3 + T24 * v4
    v14 = a1 + v13
    v15 = a1 - v13
    v16 = v8 * v12
    v17 = v16 - v14
    v18 = w234 * (v7 * v12)
    Z2_3_p = v18 - v14
    v19 = v15 + v18
    v20 = Z1_3 * Z1_3
    N3_p = v20 + Z2_3_p * Z2_3_p
    N3_m = v20 + v19 * v19
    K3_p = N3_p - k1
    K3_m = N3_m - k1
    D3_p = (longest3 - N3_p) * (N3_p - shortest3)
    D3_m = (longest3 - N3_m) * (N3_m - shortest3)
    w3_p = math.sqrt(D3_p)
    w3_m = math.sqrt(D3_m)
    v21 = w3_p - w3_p
    v22 = w3_m - w3_m
    s3_p = k2 * w3_p
    s3_m = k2 * w3_m
    c3_p = k2 * K3_p
    c3_m = k2 * K3_m

    # theta2, type 3: U1[1, 4] and U1[2, 4]
    v23 = v9 * v10
    v24 = v7 * (v9 * v9 + v12 * v12)
    v25 = v10 * v10
    Y1_2_p = m7 * (v24 + (v25 + v14 * v14)) - w234 * (m6 * (v7 * (v23 + v12 * v14)))
    Y1_2_m = m7 * (v24 + (v25 + v15 * v15)) - w234 * (m6 * (v7 * (v23 - v12 * v15)))
    v26 = Z1_3 * Y1_2_p
    v27 = Z1_3 * Y1_2_m
    v28 = v26 + w3_p * (m7 * v17)
    v29 = v26 + w3_p * (m7 * -v17)
    v30 = w3_m * (m7 * (v15 + v16))
    v31 = v27 - v30
    v32 = v27 + v30
    v33 = Z2_3_p * Y1_2_p
    v34 = v19 * Y1_2_m
    v35 = m7 * Z1_3
    v36 = m7 * -Z1_3
    C2_pp = v33 - w3_p * v35
    C2_pm = v33 - w3_p * v36
    v37 = v34 + w3_m * v35
    v38 = v34 + w3_m * v36
    v39 = v28 * v28 + C2_pp * C2_pp
    v40 = v29 * v29 + C2_pm * C2_pm
    v41 = v31 * v31 + v37 * v37
    v42 = v32 * v32 + v38 * v38
    w2_pp = math.sqrt(v39)
    w2_pm = math.sqrt(v40)
    w2_mp = math.sqrt(v41)
    w2_mm = math.sqrt(v42)
    v43 = 1.0 / v39
    v44 = 1.0 / v40
    v45 = 1.0 / v41
    v46 = 1.0 / v42
    factor2_pp = w2_pp * v43
    factor2_pm = w2_pm * v44
    factor2_mp = w2_mp * v45
    factor2_mm = w2_mm * v46

    # is the pose one that the arm can take?
    v47 = a1 - v16
    v48 = a1 + v16
    v49 = v47 + w2_pp * (v43 * (a3 * (c3_p * C2_pp + s3_p * v28) + a2 * C2_pp))
    v50 = v47 + w2_pm * (v44 * (a3 * (c3_p * C2_pm - s3_p * v29) + a2 * C2_pm))
    v51 = v48 + w2_mp * (v45 * (a3 * (s3_m * v31 - c3_m * v37) - a2 * v37))
    v52 = v48 - w2_mm * (v46 * (a3 * (c3_m * v38 + s3_m * v32) + a2 * v38))
    v53 = d1 + v11
    v54 = T33 - T33 * v8
    v55 = T13 - v8 * (v3 * v5)
    v56 = T23 - v8 * (v4 * v5)
    v57 = T34 + (factor2_pp * (a3 * (s3_p * C2_pp - c3_p * v28)) - (v53 + factor2_pp * (a2 * v28)))
    v58 = T34 - (factor2_pm * (a3 * (s3_p * C2_pm + c3_p * v29)) + (v53 + factor2_pm * (a2 * v29)))
    v59 = T34 - (factor2_mp * (a3 * (s3_m * v37 + c3_m * v31)) + (v53 + factor2_mp * (a2 * v31)))
    v60 = T34 + (factor2_mm * (a3 * (s3_m * v38 - c3_m * v32)) - (v53 + factor2_mm * (a2 * v32)))
    v61 = T14 + v3 * v49
    v62 = T14 + v3 * v50
    v63 = T14 - v3 * v51
    v64 = T14 - v3 * v52
    v65 = T24 + v4 * v49
    v66 = T24 + v4 * v50
    v67 = T24 - v4 * v51
    v68 = T24 - v4 * v52
    v69 = v57 * v57 + v61 * v61 + v65 * v65
    v70 = v58 * v58 + v62 * v62 + v66 * v66
    v71 = v59 * v59 + v63 * v63 + v67 * v67
    v72 = v60 * v60 + v64 * v64 + v68 * v68

    # joint values
    v81 = math.sqrt(-1.0)
    v82 = 0.0 if v69 <= m10 else v81
    v83 = 0.0 if v70 <= m10 else v81
    v84 = 0.0 if v71 <= m10 else v81
    v85 = 0.0 if v72 <= m10 else v81
    v88 = v21 + q_free[0]
    v89 = v22 + q_free[0]
    q5_pp = v82 + v88
    q5_pm = v83 + v88
    q5_mp = v84 + v89
    q5_mm = v85 + v89

    # a joint is free, or branches meet
    if (
        v6 <= m3 or v1 <= m1 or (m10 < v72 and v72 <= m11) or v42 <= m8 or (m10 < v71 and v71 <=
        m11) or v41 <= m8 or (m10 < v70 and v70 <= m11) or v40 <= m8 or (m10 < v69 and v69 <= m11)
        or v39 <= m8 or m9 < v54 * v54 + v55 * v55 + v56 * v56 or (-m4 <= D3_p and D3_p <= m5) or
        (-m4 <= D3_m and D3_m <= m5)
    ):
        return False

    # angles, side by side
    room[0] = -Yhat1
    room[1] = -v5
    room[2] = w3_p
    room[3] = w3_m
    room[4] = -v28
    room[5] = -v29
    room[6] = -v31
    room[7] = -v32
    room[8] = -Xhat1
    room[9] = T33
    room[10] = K3_p
    room[11] = K3_m
    room[12] = C2_pp
    room[13] = C2_pm
    room[14] = -v37
    room[15] = -v38
    for k in range(8):
        room[k] = _atan2(room[k], room[k + 8])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]
    angle4 = room[3]
    angle5 = room[4]
    angle6 = room[5]
    angle7 = room[6]
    angle8 = room[7]

    # joint values
    v73 = angle2 - (angle3 + angle5) - offset4
    v74 = angle2 - (angle6 - angle3) - offset4
    v75 = offset4 + (angle2 + (angle4 + angle7))
    v76 = offset4 + (angle2 + (angle8 - angle4))
    v77 = v73 + (turn if v73 <= -half_turn else (-turn if half_turn < v73 else 0.0))
    v78 = v74 + (turn if v74 <= -half_turn else (-turn if half_turn < v74 else 0.0))
    v79 = (turn if -v75 <= -half_turn else (-turn if half_turn < -v75 else 0.0)) - v75
    v80 = (turn if -v76 <= -half_turn else (-turn if half_turn < -v76 else 0.0)) - v76
    v86 = angle1 + v21
    v87 = v22 + (angle1 - math.copysign(half_turn, -Yhat1))
    q1_pp = v82 + v86
    q1_pm = v83 + v86
    q1_mp = v84 + v87
    q1_mm = v85 + v87
    q2_pp = angle5 + v82
    q2_pm = angle6 + v83
    q2_mp = angle7 + v84
    q2_mm = angle8 + v85
    q3_pp = angle3 + v82
    q3_pm = v83 - angle3
    q3_mp = angle4 + v84
    q3_mm = v85 - angle4
    q4_pp = v82 + (v77 + (turn if v77 <= -half_turn else 0.0))
    q4_pm = v83 + (v78 + (turn if v78 <= -half_turn else 0.0))
    q4_mp = v84 + (v79 + (turn if v79 <= -half_turn else 0.0))
    q4_mm = v85 + (v80 + (turn if v80 <= -half_turn else 0.0))

    q[0, 0] = q1_pp
    q[0, 1] = q2_pp
    q[0, 2] = q3_pp
    q[0, 3] = q4_pp
    q[0, 4] = q5_pp
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_pm
    q[1, 1] = q2_pm
    q[1, 2] = q3_pm
    q[1, 3] = q4_pm
    q[1, 4] = q5_pm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = q1_mp
    q[2, 1] = q2_mp
    q[2, 2] = q3_mp
    q[2, 3] = q4_mp
    q[2, 4] = q5_mp
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = q1_mm
    q[3, 1] = q2_mm
    q[3, 2] = q3_mm
    q[3, 3] = q4_mm
    q[3, 4] = q5_mm
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else OK
    return True


@_merged
def _into(T, q_free, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (4, 5) or status.shape != (4,):
        raise ValueError("T, q and status must have shapes (4, 4), (4, 5), (4,)")
    if q_free.shape != (1,):
        raise ValueError("q_free must have shape (1,)")
    valid, pose = _read(T, q_free)
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    if _COMPILED and _regular(pose, q_free, q, status):
        count = 0
        for row in range(4):
            count += status[row] == OK
        return count
    return _whole(pose, q_free, seed, q, status)


# Where in a tile the rows' values and statuses begin.
_PLACES = np.array([
    [960, 976, 992, 1008, 1024],
    [1040, 1056, 1072, 1088, 1104],
    [1120, 1136, 1152, 1168, 1184],
    [1200, 1216, 1232, 1248, 1264],
])
_KINDS = np.array([1280, 1296, 1312, 1328])


@_njit(nogil=True)
def _in_tiles(T, q_free, q, status):
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
            for i in range(1):
                work[(16 + i) * 16 + k] = q_free[first + k, i]
        for k in range(16):
            x, y, z = work[32 + k], work[96 + k], work[160 + k]
            square = x * x + y * y + z * z - 1.0
            miss = (
                square * square + 0.0 * (work[48 + k] + work[112 + k] + work[176 + k] + work[256 +
                k])
            )
            exact = miss <= 1e-24
            work[272 + k] = 0.0 if exact else 1.0
        for k in range(0, 16):
            T13 = work[32 + k]
            T14 = work[48 + k]
            T23 = work[96 + k]
            T24 = work[112 + k]
            T33 = work[160 + k]
            T34 = work[176 + k]
            given1 = work[256 + k]
            sigma1 = math.copysign(second_weight, T14 * T13 + T24 * T23)
            Xhat1 = T14 + T13 * sigma1
            Yhat1 = T24 + T23 * sigma1
            v1 = Xhat1 * Xhat1 + Yhat1 * Yhat1
            w1 = math.sqrt(v1)
            v2 = 1.0 / v1
            factor1 = w1 * v2
            v3 = Xhat1 * factor1
            v4 = Yhat1 * factor1
            v5 = w1 * (v2 * (T13 * Xhat1 + T23 * Yhat1))
            v6 = T33 * T33 + v5 * v5
            w234 = math.sqrt(v6)
            v7 = 1.0 / v6
            v8 = w234 * v7
            v9 = d5 * T33
            v10 = T34 - d1
            v11 = v8 * v9
            Z1_3 = v10 - v11
            v12 = d5 * v5
            v13 = T14 * v3 + T24 * v4
            v14 = a1 + v13
            v15 = a1 - v13
            v16 = v8 * v12
            v17 = v16 - v14
            v18 = w234 * (v7 * v12)
            Z2_3_p = v18 - v14
            v19 = v15 + v18
            v20 = Z1_3 * Z1_3
            N3_p = v20 + Z2_3_p * Z2_3_p
            N3_m = v20 + v19 * v19
            K3_p = N3_p - k1
            K3_m = N3_m - k1
            D3_p = (longest3 - N3_p) * (N3_p - shortest3)
            D3_m = (longest3 - N3_m) * (N3_m - shortest3)
            w3_p = math.sqrt(D3_p)
            w3_m = math.sqrt(D3_m)
            v21 = w3_p - w3_p
            v22 = w3_m - w3_m
            s3_p = k2 * w3_p
            s3_m = k2 * w3_m
            c3_p = k2 * K3_p
            c3_m = k2 * K3_m
            v23 = v9 * v10
            v24 = v7 * (v9 * v9 + v12 * v12)
            v25 = v10 * v10
            Y1_2_p = m7 * (v24 + (v25 + v14 * v14)) - w234 * (m6 * (v7 * (v23 + v12 * v14)))
            Y1_2_m = m7 * (v24 + (v25 + v15 * v15)) - w234 * (m6 * (v7 * (v23 - v12 * v15)))
            v26 = Z1_3 * Y1_2_p
            v27 = Z1_3 * Y1_2_m
            v28 = v26 + w3_p * (m7 * v17)
            v29 = v26 + w3_p * (m7 * -v17)
            v30 = w3_m * (m7 * (v15 + v16))
            v31 = v27 - v30
            v32 = v27 + v30
            v33 = Z2_3_p * Y1_2_p
            v34 = v19 * Y1_2_m
            v35 = m7 * Z1_3
            v36 = m7 * -Z1_3
            C2_pp = v33 - w3_p * v35
            C2_pm = v33 - w3_p * v36
            v37 = v34 + w3_m * v35
            v38 = v34 + w3_m * v36
            v39 = v28 * v28 + C2_pp * C2_pp
            v40 = v29 * v29 + C2_pm * C2_pm
            v41 = v31 * v31 + v37 * v37
            v42 = v32 * v32 + v38 * v38
            w2_pp = math.sqrt(v39)
            w2_pm = math.sqrt(v40)
            w2_mp = math.sqrt(v41)
            w2_mm = math.sqrt(v42)
            v43 = 1.0 / v39
            v44 = 1.0 / v40
            v45 = 1.0 / v41
            v46 = 1.0 / v42
            factor2_pp = w2_pp * v43
            factor2_pm = w2_pm * v44
            factor2_mp = w2_mp * v45
            factor2_mm = w2_mm * v46
            v47 = a1 - v16
            v48 = a1 + v16
            v49 = v47 + w2_pp * (v43 * (a3 * (c3_p * C2_pp + s3_p * v28) + a2 * C2_pp))
            v50 = v47 + w2_pm * (v44 * (a3 * (c3_p * C2_pm - s3_p * v29) + a2 * C2_pm))
            v51 = v48 + w2_mp * (v45 * (a3 * (s3_m * v31 - c3_m * v37) - a2 * v37))
            v52 = v48 - w2_mm * (v46 * (a3 * (c3_m * v38 + s3_m * v32) + a2 * v38))
            v53 = d1 + v11
            v54 = T33 - T33 * v8
            v55 = T13 - v8 * (v3 * v5)
            v56 = T23 - v8 * (v4 * v5)
            v57 = (
                T34 + (factor2_pp * (a3 * (s3_p * C2_pp - c3_p * v28)) - (v53 + factor2_pp * (a2 *
                v28)))
            )
            v58 = (
                T34 - (factor2_pm * (a3 * (s3_p * C2_pm + c3_p * v29)) + (v53 + factor2_pm * (a2 *
                v29)))
            )
            v59 = (
                T34 - (factor2_mp * (a3 * (s3_m * v37 + c3_m * v31)) + (v53 + factor2_mp * (a2 *
                v31)))
            )
            v60 = (
                T34 + (factor2_mm * (a3 * (s3_m * v38 - c3_m * v32)) - (v53 + factor2_mm * (a2 *
                v32)))
            )
            v61 = T14 + v3 * v49
            v62 = T14 + v3 * v50
            v63 = T14 - v3 * v51
            v64 = T14 - v3 * v52
            v65 = T24 + v4 * v49
            v66 = T24 + v4 * v50
            v67 = T24 - v4 * v51
            v68 = T24 - v4 * v52
            v69 = v57 * v57 + v61 * v61 + v65 * v65
            v70 = v58 * v58 + v62 * v62 + v66 * v66
            v71 = v59 * v59 + v63 * v63 + v67 * v67
            v72 = v60 * v60 + v64 * v64 + v68 * v68
            v81 = math.sqrt(-1.0)
            v82 = 0.0 if v69 <= m10 else v81
            v83 = 0.0 if v70 <= m10 else v81
            v84 = 0.0 if v71 <= m10 else v81
            v85 = 0.0 if v72 <= m10 else v81
            v88 = v21 + given1
            v89 = v22 + given1
            q5_pp = v82 + v88
            q5_pm = v83 + v88
            q5_mp = v84 + v89
            q5_mm = v85 + v89
            work[288 + k] = Yhat1
            work[304 + k] = v1
            work[320 + k] = v6
            work[336 + k] = D3_p
            work[352 + k] = D3_m
            work[368 + k] = v21
            work[384 + k] = v22
            work[400 + k] = v39
            work[416 + k] = v40
            work[432 + k] = v41
            work[448 + k] = v42
            work[464 + k] = v54
            work[480 + k] = v55
            work[496 + k] = v56
            work[512 + k] = v69
            work[528 + k] = v70
            work[544 + k] = v71
            work[560 + k] = v72
            work[576 + k] = v82
            work[592 + k] = v83
            work[608 + k] = v84
            work[624 + k] = v85
            work[640 + k] = q5_pp
            work[656 + k] = q5_pm
            work[672 + k] = q5_mp
            work[688 + k] = q5_mm
            work[704 + k] = -Yhat1
            work[720 + k] = -v5
            work[736 + k] = w3_p
            work[752 + k] = w3_m
            work[768 + k] = -v28
            work[784 + k] = -v29
            work[800 + k] = -v31
            work[816 + k] = -v32
            work[832 + k] = -Xhat1
            work[848 + k] = T33
            work[864 + k] = K3_p
            work[880 + k] = K3_m
            work[896 + k] = C2_pp
            work[912 + k] = C2_pm
            work[928 + k] = -v37
            work[944 + k] = -v38
        for k in range(704, 832):
            work[k] = _atan2(work[k], work[k + 128])
        for k in range(0, 16):
            Yhat1 = work[288 + k]
            v1 = work[304 + k]
            v6 = work[320 + k]
            D3_p = work[336 + k]
            D3_m = work[352 + k]
            v21 = work[368 + k]
            v22 = work[384 + k]
            v39 = work[400 + k]
            v40 = work[416 + k]
            v41 = work[432 + k]
            v42 = work[448 + k]
            v54 = work[464 + k]
            v55 = work[480 + k]
            v56 = work[496 + k]
            v69 = work[512 + k]
            v70 = work[528 + k]
            v71 = work[544 + k]
            v72 = work[560 + k]
            v82 = work[576 + k]
            v83 = work[592 + k]
            v84 = work[608 + k]
            v85 = work[624 + k]
            q5_pp = work[640 + k]
            q5_pm = work[656 + k]
            q5_mp = work[672 + k]
            q5_mm = work[688 + k]
            angle1 = work[704 + k]
            angle2 = work[720 + k]
            angle3 = work[736 + k]
            angle4 = work[752 + k]
            angle5 = work[768 + k]
            angle6 = work[784 + k]
            angle7 = work[800 + k]
            angle8 = work[816 + k]
            v73 = angle2 - (angle3 + angle5) - offset4
            v74 = angle2 - (angle6 - angle3) - offset4
            v75 = offset4 + (angle2 + (angle4 + angle7))
            v76 = offset4 + (angle2 + (angle8 - angle4))
            v77 = v73 + (turn if v73 <= -half_turn else (-turn if half_turn < v73 else 0.0))
            v78 = v74 + (turn if v74 <= -half_turn else (-turn if half_turn < v74 else 0.0))
            v79 = (turn if -v75 <= -half_turn else (-turn if half_turn < -v75 else 0.0)) - v75
            v80 = (turn if -v76 <= -half_turn else (-turn if half_turn < -v76 else 0.0)) - v76
            v86 = angle1 + v21
            v87 = v22 + (angle1 - math.copysign(half_turn, -Yhat1))
            q1_pp = v82 + v86
            q1_pm = v83 + v86
            q1_mp = v84 + v87
            q1_mm = v85 + v87
            q2_pp = angle5 + v82
            q2_pm = angle6 + v83
            q2_mp = angle7 + v84
            q2_mm = angle8 + v85
            q3_pp = angle3 + v82
            q3_pm = v83 - angle3
            q3_mp = angle4 + v84
            q3_mm = v85 - angle4
            q4_pp = v82 + (v77 + (turn if v77 <= -half_turn else 0.0))
            q4_pm = v83 + (v78 + (turn if v78 <= -half_turn else 0.0))
            q4_mp = v84 + (v79 + (turn if v79 <= -half_turn else 0.0))
            q4_mm = v85 + (v80 + (turn if v80 <= -half_turn else 0.0))
            _960 = q1_pp
            work[960 + k] = _960
            _976 = q2_pp
            work[976 + k] = _976
            _992 = q3_pp
            work[992 + k] = _992
            _1008 = q4_pp
            work[1008 + k] = _1008
            _1024 = q5_pp
            work[1024 + k] = _1024
            _1040 = q1_pm
            work[1040 + k] = _1040
            _1056 = q2_pm
            work[1056 + k] = _1056
            _1072 = q3_pm
            work[1072 + k] = _1072
            _1088 = q4_pm
            work[1088 + k] = _1088
            _1104 = q5_pm
            work[1104 + k] = _1104
            _1120 = q1_mp
            work[1120 + k] = _1120
            _1136 = q2_mp
            work[1136 + k] = _1136
            _1152 = q3_mp
            work[1152 + k] = _1152
            _1168 = q4_mp
            work[1168 + k] = _1168
            _1184 = q5_mp
            work[1184 + k] = _1184
            _1200 = q1_mm
            work[1200 + k] = _1200
            _1216 = q2_mm
            work[1216 + k] = _1216
            _1232 = q3_mm
            work[1232 + k] = _1232
            _1248 = q4_mm
            work[1248 + k] = _1248
            _1264 = q5_mm
            work[1264 + k] = _1264
            work[1280 + k] = UNREACHABLE if _960 != _960 else OK
            work[1296 + k] = UNREACHABLE if _1040 != _1040 else OK
            work[1312 + k] = UNREACHABLE if _1120 != _1120 else OK
            work[1328 + k] = UNREACHABLE if _1200 != _1200 else OK
            work[272 + k] = (
                1.0 if v6 <= m3 or v1 <= m1 or (m10 < v72 and v72 <= m11) or v42 <= m8 or (m10 < v71
                and v71 <= m11) or v41 <= m8 or (m10 < v70 and v70 <= m11) or v40 <= m8 or (m10 <
                v69 and v69 <= m11) or v39 <= m8 or m9 < v54 * v54 + v55 * v55 + v56 * v56 or (-m4
                <= D3_p and D3_p <= m5) or (-m4 <= D3_m and D3_m <= m5) else work[272 + k]
            )
        for k in range(first, first + count):
            if work[272 + k - first] != 0.0:
                _unseeded(T[k], q_free[k], q[k], status[k])
                continue
            for row in range(4):
                status[k, row] = np.uint8(work[_KINDS[row] + k - first])
                for i in range(5):
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
        given=1,
        apart=(_HOW.compile_apart,),
        words={
            "no_pose": "not finite, or its z axis not of length one to six digits, or the value of a free joint not finite",
            "no_row": "the pose is out of reach, or one that 4 joints can't take",
            "allocates": "only where a pose is singular or rounded",
            "given": "Values of the joints 5",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
