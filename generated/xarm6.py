"""xarm6: UFACTORY xArm 6.

Inverse kinematics, generated from robots/xarm6.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/xarm6.yaml. The formulas and where they come from: xarm6.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Every entry of
a pose counts.
"""

import functools
import math
import os
import sys
from concurrent.futures import ThreadPoolExecutor
from importlib import import_module
from pathlib import Path
from types import ModuleType

import numpy as np

# The runtime that lies beside this file, by whatever name this is imported, and no other one.
_FOLDER = str(Path(__file__).resolve().parent)
sys.modules.setdefault(_FOLDER, ModuleType(_FOLDER)).__path__ = [_FOLDER]
_RUNTIME = import_module(f"{_FOLDER}.dhgen_runtime.jit")
_COMPILED = _RUNTIME.COMPILED
_HOW = _RUNTIME.of_file(__file__, interface=1)
_njit, _jit, _inner, _merged = _HOW.njit, _HOW.jit, _HOW.inner, _HOW.merged
_owned, _apart = _HOW.owned, _HOW.apart
carray, overload = _RUNTIME.carray, _RUNTIME.overload
_room, _wide_room = _RUNTIME.room, _RUNTIME.wide_room
_lent_rows, _lent_values = _RUNTIME.lent_rows, _RUNTIME.lent_values
_lent_statuses = _RUNTIME.lent_statuses

NAME = "xarm6"
METHOD = "general 6R"
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
    "root1",
    "root2",
    "root3",
    "root4",
    "root5",
    "root6",
    "root7",
    "root8",
    "root9",
    "root10",
    "root11",
    "root12",
    "root13",
    "root14",
    "root15",
    "root16",
)
MAX_SOLUTIONS = 16

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.267  # z of axis 2 [m]
b2 = 0.0535  # x of axis 3 [m]
h2 = 0.2845  # z of axis 3 [m]
a3 = 0.0775  # x of axis 4 [m]
d4 = 0.3425  # z of axis 5 [m]
a5 = 0.076  # x of axis 6 [m]
d6 = 0.097  # z of the home pose [m]

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])
_ZEROS = np.zeros(DOF)
_FLOAT = np.dtype(np.float64)
_BYTE = np.dtype(np.uint8)
_NONE = type(None)
# Names of modules take their time in a call that is over in half a microsecond.
_empty, _contiguous = np.empty, np.ascontiguousarray


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


def _numbers(values, shape, name):
    try:
        values = np.ascontiguousarray(values)
        if values.dtype != _FLOAT:
            # numpy would drop imaginary parts, read texts and dates, and make NaN of None
            kind, objects = values.dtype.kind, values.ravel() if values.dtype.kind == "O" else ()
            if kind not in "biufO" or any(isinstance(o, (str, bytes, _NONE)) for o in objects):
                raise TypeError
            values = values.astype(_FLOAT)
    except (TypeError, ValueError):
        raise ValueError(f"{name} must hold real numbers, with shape {shape}") from None
    return values


def _array(values, shape, name):
    numbers = _numbers(values, shape, name)
    if numbers.shape != shape:
        raise ValueError(f"{name} must have shape {shape}, not {np.shape(values)}") from None
    return numbers


def _of_joints(function):
    """Compiled; Python calls it with any 6 numbers, other numba functions with an array."""

    @functools.wraps(function)
    def call(q):
        return compiled(_array(q, (6,), "q"))

    def inner(q):
        return compiled(q)

    # Of functions of one name in one module numba takes one for the other when both are cached.
    inner.__qualname__ = f"{function.__name__} of an array"
    compiled = _jit(function)
    overload(call, strict=False)(lambda _: _owned(inner))
    return call


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
    x2_x = c1 * s2
    x2_y = s1 * s2
    y2_x = c1 * c2
    y2_y = s1 * c2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 + y2_x * s3
    x3_y = x2_y * c3 + y2_y * s3
    x3_z = c2 * c3 - s2 * s3
    y3_x = y2_x * c3 - x2_x * s3
    y3_y = y2_y * c3 - x2_y * s3
    v1 = s2 * c3 + c2 * s3
    c4 = math.cos(-q[3])
    s4 = math.sin(-q[3])
    x4_x = y3_x * c4 - s1 * s4
    x4_y = y3_y * c4 + c1 * s4
    v2 = v1 * c4
    v3 = s1 * c4 + y3_x * s4
    y4_y = c1 * c4 - y3_y * s4
    y4_z = v1 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x3_x * c5 + x4_x * s5
    x5_y = x3_y * c5 + x4_y * s5
    x5_z = x3_z * c5 - v2 * s5
    y5_x = x4_x * c5 - x3_x * s5
    y5_y = x4_y * c5 - x3_y * s5
    v4 = v2 * c5 + x3_z * s5
    c6 = math.cos(-q[5])
    s6 = math.sin(-q[5])
    T[0, 0] = y5_x * c6 - v3 * s6
    T[0, 1] = v3 * c6 + y5_x * s6
    T[0, 2] = -x5_x
    T[0, 3] = x2_x * h2 + y2_x * b2 + y3_x * a3 - x3_x * d4 + y5_x * a5 - x5_x * d6
    T[1, 0] = y5_y * c6 + y4_y * s6
    T[1, 1] = y5_y * s6 - y4_y * c6
    T[1, 2] = -x5_y
    T[1, 3] = x2_y * h2 + y2_y * b2 + y3_y * a3 - x3_y * d4 + y5_y * a5 - x5_y * d6
    T[2, 0] = y4_z * s6 - v4 * c6
    T[2, 1] = -(y4_z * c6 + v4 * s6)
    T[2, 2] = -x5_z
    T[2, 3] = d1 + c2 * h2 - s2 * b2 - v1 * a3 - x3_z * d4 - v4 * a5 - x5_z * d6
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
    x2_x = c1 * s2
    x2_y = s1 * s2
    y2_x = c1 * c2
    y2_y = s1 * c2
    p3_x = x2_x * h2 + y2_x * b2
    p3_y = x2_y * h2 + y2_y * b2
    p3_z = d1 + c2 * h2 - s2 * b2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 + y2_x * s3
    x3_y = x2_y * c3 + y2_y * s3
    x3_z = c2 * c3 - s2 * s3
    y3_x = y2_x * c3 - x2_x * s3
    y3_y = y2_y * c3 - x2_y * s3
    v1 = s2 * c3 + c2 * s3
    p4_x = p3_x + y3_x * a3
    p4_y = p3_y + y3_y * a3
    p4_z = p3_z - v1 * a3
    c4 = math.cos(-q[3])
    s4 = math.sin(-q[3])
    x4_x = y3_x * c4 - s1 * s4
    x4_y = y3_y * c4 + c1 * s4
    v2 = v1 * c4
    v3 = s1 * c4 + y3_x * s4
    y4_y = c1 * c4 - y3_y * s4
    y4_z = v1 * s4
    p5_x = p4_x - x3_x * d4
    p5_y = p4_y - x3_y * d4
    p5_z = p4_z - x3_z * d4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x3_x * c5 + x4_x * s5
    x5_y = x3_y * c5 + x4_y * s5
    x5_z = x3_z * c5 - v2 * s5
    p6_x = p5_x + (x4_x * c5 - x3_x * s5) * a5
    p6_y = p5_y + (x4_y * c5 - x3_y * s5) * a5
    p6_z = p5_z - (v2 * c5 + x3_z * s5) * a5
    J21 = p6_x - x5_x * d6
    v4 = p6_y - x5_y * d6
    v5 = p6_z - x5_z * d6
    v6 = v5 - d1
    v7 = v5 - p3_z
    v8 = J21 - p4_x
    v9 = v4 - p4_y
    v10 = v5 - p4_z
    v11 = J21 - p5_x
    v12 = v4 - p5_y
    v13 = v5 - p5_z
    v14 = J21 - p6_x
    v15 = v4 - p6_y
    v16 = v5 - p6_z
    J[0, 0] = -v4
    J[0, 1] = c1 * v6
    J[0, 2] = c1 * v7
    J[0, 3] = -(x3_y * v10 + -x3_z * v9)
    J[0, 4] = y4_y * v13 - y4_z * v12
    J[0, 5] = -(x5_y * v16 + -x5_z * v15)
    J[1, 0] = J21
    J[1, 1] = s1 * v6
    J[1, 2] = s1 * v7
    J[1, 3] = -x3_z * v8 + x3_x * v10
    J[1, 4] = y4_z * v11 + v3 * v13
    J[1, 5] = -x5_z * v14 + x5_x * v16
    J[2, 1] = -(s1 * v4 + c1 * J21)
    J[2, 2] = -(s1 * (v4 - p3_y) + c1 * (J21 - p3_x))
    J[2, 3] = x3_y * v8 - x3_x * v9
    J[2, 4] = -(v3 * v12 + y4_y * v11)
    J[2, 5] = x5_y * v14 - x5_x * v15
    J[3, 1] = -s1
    J[3, 2] = -s1
    J[3, 3] = -x3_x
    J[3, 4] = -v3
    J[3, 5] = -x5_x
    J[4, 1] = c1
    J[4, 2] = c1
    J[4, 3] = -x3_y
    J[4, 4] = y4_y
    J[4, 5] = -x5_y
    J[5, 0] = 1.0
    J[5, 3] = -x3_z
    J[5, 4] = y4_z
    J[5, 5] = -x5_z
    return J


# The joints that are solved for, and whether they turn; what a step of one means, in rad or
# lengths, and the same over the arm's size. Below, u are these joints in units.
_SOLVED = np.array([0, 1, 2, 3, 4, 5])
_TURNING = np.array([True, True, True, True, True, True])
_UNIT = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])
_MEASURE = np.array([
    0.8699535839283513, 0.8699535839283513, 0.8699535839283513, 0.8699535839283513,
    0.8699535839283513, 0.8699535839283513,
])


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


@_apart("float64(float64[:, ::1], float64[::1], float64[::1], float64[::1], float64[:, ::1])")
def _look(T, q, u, e, A):
    """By how much u misses the pose, into e and returned as a length, and its Jacobian into A."""
    for j in range(6):
        q[_SOLVED[j]] = _UNIT[j] * u[j]
    P, J = fk(q), jacobian(q)
    for j in range(6):
        column = _SOLVED[j]
        A[0, j] = _MEASURE[j] * J[0, column]
        A[1, j] = _MEASURE[j] * J[1, column]
        A[2, j] = _MEASURE[j] * J[2, column]
        for i in range(3):
            A[3 + i, j] = J[3 + i, column]
    e[0] = (T[0, 3] - P[0, 3]) / 1.149486614543747
    e[1] = (T[1, 3] - P[1, 3]) / 1.149486614543747
    e[2] = (T[2, 3] - P[2, 3]) / 1.149486614543747
    R = np.zeros((3, 3))
    for i in range(3):
        for j in range(3):
            for k in range(3):
                R[i, j] += T[i, k] * P[j, k]
    axis = 0.5 * (R[2, 1] - R[1, 2]), 0.5 * (R[0, 2] - R[2, 0]), 0.5 * (R[1, 0] - R[0, 1])
    _turn_vector(axis, 0.5 * (R[0, 0] + R[1, 1] + R[2, 2] - 1.0), e[3:])
    square = 0.0
    for i in range(6):
        square += e[i] * e[i]
    return math.sqrt(square)


# What is added from start to start, in parts of the range: a direction that is like no other.
_STRIDE = np.array([
    0.8986537126286992, 0.8075784952213447, 0.7257334129697597, 0.6521830259439715,
    0.5860866975779693, 0.5266889867007357,
])


@_inner
def _wrap_angles(u):
    """Moves angles by whole turns to (-pi, pi]."""
    for j in range(6):
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
    for j in range(6):
        longest = max(longest, abs(step[j]))
    for j in range(6):
        step[j] *= 2.0 / longest


@_inner
def _damped_step(A, e, length, little, step):
    """The damped least squares step A' (A A' + damping)^-1 e, `little` the least damping.

    The rows of A, each with its share of the damping's root behind it, are made orthonormal one
    after another (modified Gram-Schmidt; used as by A. Bjorck, Numerics of Gram-Schmidt
    orthogonalization, 1994): the product A A' would lose half of the digits.
    """
    damping = 0.1 * min(length * length, 1.0) + little
    rows, y = np.zeros((6, 12)), np.empty(6)
    total = np.zeros(12)
    for i in range(6):
        for j in range(6):
            rows[i, j] = A[i, j]
        rows[i, 6 + i] = math.sqrt(damping)
        y[i] = e[i]
        for k in range(i):
            along = 0.0
            for j in range(12):
                along += rows[k, j] * rows[i, j]
            for j in range(12):
                rows[i, j] -= along * rows[k, j]
            y[i] -= along * y[k]
        square = 0.0
        for j in range(12):
            square += rows[i, j] * rows[i, j]
        inverse = 1.0 / math.sqrt(square)
        y[i] *= inverse
        for j in range(12):
            rows[i, j] *= inverse
    for i in range(5, -1, -1):
        missing = y[i]
        for j in range(12):
            missing -= rows[i, j] * total[j]
        for j in range(12):
            total[j] += missing * rows[i, j]
    for j in range(6):
        step[j] = total[j]


@_apart("float64(float64[:, ::1], float64[::1], float64[::1])")
def _descend(T, q, u):
    """Takes u to where damped least squares lead; returns by how much that misses the pose.

    Near to it less damping than usual leads further, where joints hardly move the tool: there a step
    that is right may be long, and what it leaves, half of its square, far more than was missed.
    """
    e, A = np.empty(6), np.empty((6, 6))
    least, best, step, little = math.inf, u.copy(), np.empty(6), 1e-13
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
        for j in range(6):
            u[j] += step[j]
            way += abs(step[j])
        last, left = length, 0.5 * way * way if little < 1e-13 else 0.0
    _take(u, best)
    return least


@_inner
def _limited_step(A, e, length, wish, u, low, high, step):
    """A step with a wish; joints that it would take beyond a limit are put there, and locked."""
    fixed, locked = np.zeros(6), np.zeros(6, np.uint8)
    rest = np.empty(6)
    beyond = True
    while beyond:
        beyond = False
        for i in range(6):
            rest[i] = e[i]
            for j in range(6):
                rest[i] -= A[i, j] * wish[j]
        _damped_step(A, rest, length, 1e-13, step)
        for j in range(6):
            step[j] += wish[j]
        _shorten(step)
        for j in range(6):
            end = u[j] + step[j]
            if locked[j]:
                step[j] = fixed[j]
            elif end < low[j] or end > high[j]:
                step[j] = fixed[j] = (low[j] if end < low[j] else high[j]) - u[j]
                beyond, locked[j], wish[j] = True, 1, 0.0
                for i in range(6):
                    e[i] -= A[i, j] * fixed[j]
                    A[i, j] = 0.0


@_apart("float64(float64[:, ::1], float64[::1], float64[::1], float64[::1], float64[::1], float64[::1])")
def _pulled(T, q, u, near, low, high):
    """Takes u to a solution on the way to `near`; returns by how much it misses the pose."""
    e, A = np.empty(6), np.empty((6, 6))
    least, best, step, pull = math.inf, u.copy(), np.empty(6), 0.5
    wish = np.empty(6)
    for k in range(1, 60 + 40 + 1):
        length = _look(T, q, u, e, A)
        if pull == 0.0:
            if length >= 0.5 * least and least <= 1e-10:
                break
            if length < least:
                least = length
                _take(best, u)
        for j in range(6):
            wish[j] = pull * (min(max(near[j], low[j]), high[j]) - u[j])
        _limited_step(A, e, length, wish, u, low, high, step)
        longest = 0.0
        for j in range(6):
            longest = max(longest, abs(step[j]))
            u[j] += step[j]
        if k >= 60 or longest < 1e-09:
            pull = 0.0
    _take(u, best)
    return least


_NO_LOWEST = np.array([-math.inf, -math.inf, -math.inf, -math.inf, -math.inf, -math.inf])
_NO_HIGHEST = np.array([math.inf, math.inf, math.inf, math.inf, math.inf, math.inf])
# Between which values starts lie.
_SPAN_LOW = np.array([
    -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
    -3.141592653589793, -3.141592653589793,
])
_SPAN_WIDTH = np.array([
    6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
    6.283185307179586,
])


@_inner
def _start_of(k, near, u):
    """Start number k; number 0 is the seed."""
    for j in range(6):
        u[j] = near[j] if k == 0 else _SPAN_LOW[j] + _SPAN_WIDTH[j] * ((0.5 + k * _STRIDE[j]) % 1.0)


@_inner
def _sideways(A, along):
    """The part of a generic direction that leaves the tool where it is, to first order, one long.

    Returns how long it was.
    """
    moved, square = np.empty(6), 0.0
    for i in range(6):
        moved[i] = 0.0
        for j in range(6):
            moved[i] += A[i, j] * _STRIDE[j]
    _damped_step(A, moved, 0.0, 1e-13, along)
    for j in range(6):
        along[j] = _STRIDE[j] - along[j]
        square += along[j] * along[j]
    length = math.sqrt(square)
    for j in range(6):
        along[j] /= length
    return length


@_apart("int64(float64[:, ::1], float64[::1], float64[::1], float64)")
def _continuum(T, q, u, enough):
    """Whether u is one of a continuum of solutions: 1 if there are others to both sides.

    They miss the pose by no more than `enough`. 0 if it is a singular solution that stands alone, -1 if it is a regular one.
    """
    e, A = np.empty(6), np.empty((6, 6))
    along, end, other = np.empty(6), np.empty(6), np.full(6, np.inf)
    _look(T, q, u, e, A)
    if _sideways(A, along) <= 0.0001:
        return -1
    for side in (1.0, -1.0):
        gap = across = 0.0
        for j in range(6):
            end[j] = u[j] + side * 0.05 * along[j]
        miss = _descend(T, q, end)
        for j in range(6):
            gap, across = max(gap, abs(end[j] - u[j])), max(across, abs(end[j] - other[j]))
        if miss > enough or min(gap, across) <= 0.01:
            return 0
        _take(other, end)
    return 1


@_apart("boolean(float64[:, ::1], float64[::1], float64[::1], float64[::1], float64)")
def _solves_between(T, q, u, way, length):
    """Whether solutions lie all along the way from one to another: where many roots meet, joint values
    beside the solution miss the pose by next to nothing."""
    e, A = np.empty(6), np.empty((6, 6))
    end, step = np.empty(6), np.empty(6)
    for part in (0.25, 0.5, 0.75):
        for j in range(6):
            end[j] = u[j] + part * way[j]
        miss = _look(T, q, end, e, A)
        for _ in range(4):
            if miss > 1e-10:
                _damped_step(A, e, miss, 1e-13, step)
                for j in range(6):
                    end[j] += step[j]
                miss = _look(T, q, end, e, A)
        if miss > 1e-10:
            return False
        for j in range(6):
            if abs(u[j] + part * way[j] - end[j]) > 0.0625 * length:
                return False
    return True


@_apart("boolean(float64[:, ::1], float64[::1], float64[::1], float64[::1], boolean)")
def _taken_for(T, q, known, u, loose):
    """Whether a solution is taken for one that is known; loosely where both are singular."""
    between, gap = np.empty(6), 0.0
    for j in range(6):
        between[j] = u[j] - known[j]
    _wrap_angles(between)
    for j in range(6):
        gap = max(gap, abs(between[j]))
    if gap < 1e-06:
        return True
    return loose and gap < 0.1 and _solves_between(T, q, known, between, gap)


@_apart("int64(float64[:, ::1], float64[::1], float64[:, ::1], int64[::1], int64, float64[::1], boolean)")
def _known_as(T, q, kept, kinds, count, u, singular):
    """Which of those found before a solution is; -1 for none."""
    for k in range(count):
        if _taken_for(T, q, kept[k], u, singular and kinds[k] >= 0):
            return k
    return -1


@_apart("int64(float64[:, ::1], float64[::1], float64[::1], float64[:, ::1], int64[::1], int64, float64[::1])")
def _keep(T, q, near, kept, kinds, count, u):
    """A solution joins those found before, unless it is one of them; how many there are then."""
    if count == 16 or _known_as(T, q, kept, kinds, count, u, False) >= 0:
        return count
    enough = 1e-10
    kind = _continuum(T, q, u, enough)
    if kind == 1:
        end = u.copy()
        _pulled(T, q, end, near, _NO_LOWEST, _NO_HIGHEST)
        if _descend(T, q, end) <= enough:
            _take(u, end)
    _wrap_angles(u)
    k = _known_as(T, q, kept, kinds, count, u, kind >= 0)
    if k >= 0:
        return count
    k = count if k < 0 else k
    kinds[k] = kind
    _take(kept[k], u)
    return max(count, k + 1)


@_inner
def _stands_before(a, b):
    """Whether a row of joint values stands before another."""
    for i in range(6):
        if abs(a[i] - b[i]) > 1e-09:
            return a[i] < b[i]
    return False


@_inner
def _sorted_rows(kept, kinds, count, joints, q, found, chosen):
    """Rows by the first joint, then by the second and so on."""
    for k in range(count):
        row = k
        for j in range(6):
            joints[_SOLVED[j]] = _UNIT[j] * kept[k, j]
        while row > 0 and _stands_before(joints, q[row - 1]):
            _take(q[row], q[row - 1])
            chosen[row] = chosen[row - 1]
            row -= 1
        _take(q[row], joints)
        chosen[row] = kinds[k] == 1
        found[k] = True




# The general 6R algorithm: all solutions, at most 16, of an arm without three concurrent or parallel
# axes. M. Raghavan and B. Roth (1993): six equations in the hidden joint and two partners, a
# determinant of degree 8 in the hidden joint; here it is sampled at 24 angles.
#
# The loop J(q1) K0 J(q2) ... K4 J(q6) = P, in units of the arm's size, P = L T R.

# The constants K0 ... K4 of the loop, L and R, three rows of four; for those with joints inside whose
# values are given, what stands before, between and behind these.
_XARM6_CONSTANTS = np.array([
    [0.9230769230769231, 0.38461538461538464, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.38461538461538464, -0.9230769230769231, 0.0, 7.368497484792287e-10],
    [0.47058823529411764, -0.8823529411764706, 0.0, 0.7851450463681914, 0.8823529411764706, 0.47058823529411764, 0.0, 0.1476459050288163, 0.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0, -0.4726048826830395, 0.28, -0.96, 0.0, 0.21387958205108903, 0.96, 0.28, 0.0, 0.0],
    [0.7241379310344828, 0.6896551724137931, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.6896551724137931, -0.7241379310344828, 0.0, -0.4726048831556444],
    [0.0, 0.0, 1.0, 0.0, 0.32432432432432434, -0.9459459459459459, 0.0, 0.209739977237197, 0.9459459459459459, 0.32432432432432434, 0.0, 0.0],
    [0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.266999999733],
    [1.0, 0.0, 0.0, -0.0, 0.0, -1.0, 0.0, -0.0, 0.0, 0.0, -1.0, -0.097],
])

# cosine and sine of what is to be added to each joint's angle in the loop
_XARM6_ADVANCE_C = np.array([0.6, 0.38461538461538464, 0.47058823529411764, 0.28, 0.6896551724137931, 0.32432432432432434])
_XARM6_ADVANCE_S = np.array([0.8, 0.9230769230769231, 0.8823529411764706, 0.96, 0.7241379310344828, 0.9459459459459459])

# poses close by, for those at which the formulations fail
_XARM6_NUDGES = np.array([
    [0.9999995580001719, -0.000580303174204035, -0.00073976191215864, 0.0005300000000000001, 0.0005796963744401407, 0.9999994956001963, -0.0008202142808546233, 0.00071, 0.0007402375119735841, 0.0008197850810216249, 0.9999993900002373, -0.00047],
    [0.9999995580001719, 0.0005796963744401407, 0.0007402375119735841, -0.0005300000000000001, -0.000580303174204035, 0.9999994956001963, 0.0008197850810216249, -0.00071, -0.00073976191215864, -0.0008202142808546233, 0.9999993900002373, 0.00047],
    [0.9999949420151998, -0.0018617746051811336, 0.002578708850722032, -0.00183, 0.0018582142158804597, 0.9999973180080597, 0.001382395245764047, 0.00087, -0.0025812756430085644, -0.0013775964601848774, 0.999995719612863, 0.00201],
    [0.9999949420151998, 0.0018582142158804597, -0.0025812756430085644, 0.00183, -0.0018617746051811336, 0.9999973180080597, -0.0013775964601848774, -0.00087, 0.002578708850722032, 0.001382395245764047, 0.999995719612863, -0.00201],
    [0.9999377228865443, 0.009025321676340304, 0.00656459573098787, 0.0059, -0.008973844062327714, 0.9999290832869896, -0.007829337110224942, -0.0043, -0.0066347924773686754, 0.007769939863287338, 0.9999478024193579, 0.0031],
    [0.9999377228865443, -0.008973844062327714, -0.0066347924773686754, -0.0059, 0.009025321676340304, 0.9999290832869896, 0.007769939863287338, 0.0043, 0.00656459573098787, -0.007829337110224942, 0.9999478024193579, -0.0031],
    [0.9996484117295773, 0.020763800426894047, 0.01648992172102878, 0.011099999999999999, -0.021220469326757335, 0.9993821115042827, 0.028019401970663643, 0.0183, -0.015897943517502292, -0.028359474555668215, 0.9994713580662733, 0.017099999999999997],
    [0.9996484117295773, -0.021220469326757335, -0.015897943517502292, -0.011099999999999999, 0.020763800426894047, 0.9993821115042827, -0.028359474555668215, -0.0183, 0.01648992172102878, 0.028019401970663643, 0.9994713580662733, -0.017099999999999997],
    [0.999472790696877, -0.013504055448103867, 0.029525940172180323, -0.0153, 0.014085964965612287, 0.9997088653063301, -0.01959005408153817, -0.0201, -0.02925279897008453, 0.019995627381619797, 0.9993720271440617, 0.012299999999999998],
    [0.999472790696877, 0.014085964965612287, -0.02925279897008453, 0.0153, -0.013504055448103867, 0.9997088653063301, 0.019995627381619797, 0.0201, 0.029525940172180323, -0.01959005408153817, 0.9993720271440617, -0.012299999999999998],
])

# A formulation: the joints phi_1 (hidden) ... phi_6 are; the sign of phi = sign q.
_XARM6_JOINTS = np.array([
    [3, 2, 1, 0, 5, 4],
    [0, 1, 2, 3, 4, 5],
])
_XARM6_SIGNS = np.array([-1.0, 1.0, ])

# cosines and sines of the 24 angles at which the determinant is sampled
_XARM6_SAMPLE_C = np.array([1.0, 0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0, -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682, -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5, -0.2588190451025207, 0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386, 0.9659258262890682])
_XARM6_SAMPLE_S = np.array([0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386, 0.9659258262890682, 1.0, 0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0, -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682, -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5, -0.2588190451025207])

# from the samples to a_0 ... a_8, b_1 ... b_8 and seven numbers that would be zero without rounding
_XARM6_HARMONICS = np.array([
    [0.041666666666666664, 0.08333333333333333, 0.08333333333333333, 0.08333333333333333, 0.08333333333333333, 0.08333333333333333, 0.08333333333333333, 0.08333333333333333, 0.08333333333333333, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.08333333333333333, 0.08333333333333333, 0.08333333333333333, 0.08333333333333333, 0.0, 0.0, 0.0],
    [0.041666666666666664, 0.08049381885742235, 0.07216878364870322, 0.05892556509887897, 0.041666666666666664, 0.02156825375854339, -0.0, -0.02156825375854339, -0.041666666666666664, 0.02156825375854339, 0.041666666666666664, 0.05892556509887897, 0.07216878364870322, 0.08049381885742235, 0.08333333333333333, 0.08049381885742235, 0.07216878364870322, -0.05892556509887897, -0.07216878364870322, -0.08049381885742235, -0.08333333333333333, 0.05892556509887897, 0.041666666666666664, 0.02156825375854339],
    [0.041666666666666664, 0.07216878364870322, 0.041666666666666664, -0.0, -0.041666666666666664, -0.07216878364870322, -0.08333333333333333, -0.07216878364870322, -0.041666666666666664, 0.041666666666666664, 0.07216878364870322, 0.08333333333333333, 0.07216878364870322, 0.041666666666666664, -0.0, -0.041666666666666664, -0.07216878364870322, 0.0, 0.041666666666666664, 0.07216878364870322, 0.08333333333333333, -0.08333333333333333, -0.07216878364870322, -0.041666666666666664],
    [0.041666666666666664, 0.05892556509887897, -0.0, -0.05892556509887897, -0.08333333333333333, -0.05892556509887897, 0.0, 0.05892556509887897, 0.08333333333333333, 0.05892556509887897, 0.08333333333333333, 0.05892556509887897, -0.0, -0.05892556509887897, -0.08333333333333333, -0.05892556509887897, 0.0, 0.05892556509887897, -0.0, -0.05892556509887897, -0.08333333333333333, 0.05892556509887897, 0.08333333333333333, 0.05892556509887897],
    [0.041666666666666664, 0.041666666666666664, -0.041666666666666664, -0.08333333333333333, -0.041666666666666664, 0.041666666666666664, 0.08333333333333333, 0.041666666666666664, -0.041666666666666664, 0.07216878364870322, 0.07216878364870322, -0.0, -0.07216878364870322, -0.07216878364870322, 0.0, 0.07216878364870322, 0.07216878364870322, -0.08333333333333333, -0.041666666666666664, 0.041666666666666664, 0.08333333333333333, -0.0, -0.07216878364870322, -0.07216878364870322],
    [0.041666666666666664, 0.02156825375854339, -0.07216878364870322, -0.05892556509887897, 0.041666666666666664, 0.08049381885742235, -0.0, -0.08049381885742235, -0.041666666666666664, 0.08049381885742235, 0.041666666666666664, -0.05892556509887897, -0.07216878364870322, 0.02156825375854339, 0.08333333333333333, 0.02156825375854339, -0.07216878364870322, 0.05892556509887897, 0.07216878364870322, -0.02156825375854339, -0.08333333333333333, -0.05892556509887897, 0.041666666666666664, 0.08049381885742235],
    [0.041666666666666664, -0.0, -0.08333333333333333, 0.0, 0.08333333333333333, -0.0, -0.08333333333333333, 0.0, 0.08333333333333333, 0.08333333333333333, -0.0, -0.08333333333333333, 0.0, 0.08333333333333333, -0.0, -0.08333333333333333, 0.0, -0.0, -0.08333333333333333, 0.0, 0.08333333333333333, 0.08333333333333333, -0.0, -0.08333333333333333],
    [0.041666666666666664, -0.02156825375854339, -0.07216878364870322, 0.05892556509887897, 0.041666666666666664, -0.08049381885742235, 0.0, 0.08049381885742235, -0.041666666666666664, 0.08049381885742235, -0.041666666666666664, -0.05892556509887897, 0.07216878364870322, 0.02156825375854339, -0.08333333333333333, 0.02156825375854339, 0.07216878364870322, -0.05892556509887897, 0.07216878364870322, 0.02156825375854339, -0.08333333333333333, -0.05892556509887897, -0.041666666666666664, 0.08049381885742235],
    [0.041666666666666664, -0.041666666666666664, -0.041666666666666664, 0.08333333333333333, -0.041666666666666664, -0.041666666666666664, 0.08333333333333333, -0.041666666666666664, -0.041666666666666664, 0.07216878364870322, -0.07216878364870322, 0.0, 0.07216878364870322, -0.07216878364870322, 0.0, 0.07216878364870322, -0.07216878364870322, 0.08333333333333333, -0.041666666666666664, -0.041666666666666664, 0.08333333333333333, 0.0, 0.07216878364870322, -0.07216878364870322],
    [0.041666666666666664, -0.05892556509887897, 0.0, 0.05892556509887897, -0.08333333333333333, 0.05892556509887897, -0.0, -0.05892556509887897, 0.08333333333333333, 0.05892556509887897, -0.08333333333333333, 0.05892556509887897, -0.0, -0.05892556509887897, 0.08333333333333333, -0.05892556509887897, 0.0, -0.05892556509887897, 0.0, 0.05892556509887897, -0.08333333333333333, 0.05892556509887897, -0.08333333333333333, 0.05892556509887897],
    [0.041666666666666664, -0.07216878364870322, 0.041666666666666664, -0.0, -0.041666666666666664, 0.07216878364870322, -0.08333333333333333, 0.07216878364870322, -0.041666666666666664, 0.041666666666666664, -0.07216878364870322, 0.08333333333333333, -0.07216878364870322, 0.041666666666666664, -0.0, -0.041666666666666664, 0.07216878364870322, 0.0, 0.041666666666666664, -0.07216878364870322, 0.08333333333333333, -0.08333333333333333, 0.07216878364870322, -0.041666666666666664],
    [0.041666666666666664, -0.08049381885742235, 0.07216878364870322, -0.05892556509887897, 0.041666666666666664, -0.02156825375854339, 0.0, 0.02156825375854339, -0.041666666666666664, 0.02156825375854339, -0.041666666666666664, 0.05892556509887897, -0.07216878364870322, 0.08049381885742235, -0.08333333333333333, 0.08049381885742235, -0.07216878364870322, 0.05892556509887897, -0.07216878364870322, 0.08049381885742235, -0.08333333333333333, 0.05892556509887897, -0.041666666666666664, 0.02156825375854339],
    [0.041666666666666664, -0.08333333333333333, 0.08333333333333333, -0.08333333333333333, 0.08333333333333333, -0.08333333333333333, 0.08333333333333333, -0.08333333333333333, 0.08333333333333333, -0.0, 0.0, -0.0, 0.0, -0.0, 0.0, -0.0, 0.0, -0.08333333333333333, 0.08333333333333333, -0.08333333333333333, 0.08333333333333333, -0.0, 0.0, -0.0],
    [0.041666666666666664, -0.08049381885742235, 0.07216878364870322, -0.05892556509887897, 0.041666666666666664, -0.02156825375854339, -0.0, 0.02156825375854339, -0.041666666666666664, -0.02156825375854339, 0.041666666666666664, -0.05892556509887897, 0.07216878364870322, -0.08049381885742235, 0.08333333333333333, -0.08049381885742235, 0.07216878364870322, 0.05892556509887897, -0.07216878364870322, 0.08049381885742235, -0.08333333333333333, -0.05892556509887897, 0.041666666666666664, -0.02156825375854339],
    [0.041666666666666664, -0.07216878364870322, 0.041666666666666664, 0.0, -0.041666666666666664, 0.07216878364870322, -0.08333333333333333, 0.07216878364870322, -0.041666666666666664, -0.041666666666666664, 0.07216878364870322, -0.08333333333333333, 0.07216878364870322, -0.041666666666666664, -0.0, 0.041666666666666664, -0.07216878364870322, -0.0, 0.041666666666666664, -0.07216878364870322, 0.08333333333333333, 0.08333333333333333, -0.07216878364870322, 0.041666666666666664],
    [0.041666666666666664, -0.05892556509887897, -0.0, 0.05892556509887897, -0.08333333333333333, 0.05892556509887897, 0.0, -0.05892556509887897, 0.08333333333333333, -0.05892556509887897, 0.08333333333333333, -0.05892556509887897, -0.0, 0.05892556509887897, -0.08333333333333333, 0.05892556509887897, 0.0, -0.05892556509887897, -0.0, 0.05892556509887897, -0.08333333333333333, -0.05892556509887897, 0.08333333333333333, -0.05892556509887897],
    [0.041666666666666664, -0.041666666666666664, -0.041666666666666664, 0.08333333333333333, -0.041666666666666664, -0.041666666666666664, 0.08333333333333333, -0.041666666666666664, -0.041666666666666664, -0.07216878364870322, 0.07216878364870322, 0.0, -0.07216878364870322, 0.07216878364870322, 0.0, -0.07216878364870322, 0.07216878364870322, 0.08333333333333333, -0.041666666666666664, -0.041666666666666664, 0.08333333333333333, 0.0, -0.07216878364870322, 0.07216878364870322],
    [0.041666666666666664, -0.02156825375854339, -0.07216878364870322, 0.05892556509887897, 0.041666666666666664, -0.08049381885742235, -0.0, 0.08049381885742235, -0.041666666666666664, -0.08049381885742235, 0.041666666666666664, 0.05892556509887897, -0.07216878364870322, -0.02156825375854339, 0.08333333333333333, -0.02156825375854339, -0.07216878364870322, -0.05892556509887897, 0.07216878364870322, 0.02156825375854339, -0.08333333333333333, 0.05892556509887897, 0.041666666666666664, -0.08049381885742235],
    [0.041666666666666664, 0.0, -0.08333333333333333, -0.0, 0.08333333333333333, 0.0, -0.08333333333333333, -0.0, 0.08333333333333333, -0.08333333333333333, -0.0, 0.08333333333333333, 0.0, -0.08333333333333333, -0.0, 0.08333333333333333, 0.0, 0.0, -0.08333333333333333, -0.0, 0.08333333333333333, -0.08333333333333333, -0.0, 0.08333333333333333],
    [0.041666666666666664, 0.02156825375854339, -0.07216878364870322, -0.05892556509887897, 0.041666666666666664, 0.08049381885742235, 0.0, -0.08049381885742235, -0.041666666666666664, -0.08049381885742235, -0.041666666666666664, 0.05892556509887897, 0.07216878364870322, -0.02156825375854339, -0.08333333333333333, -0.02156825375854339, 0.07216878364870322, 0.05892556509887897, 0.07216878364870322, -0.02156825375854339, -0.08333333333333333, 0.05892556509887897, -0.041666666666666664, -0.08049381885742235],
    [0.041666666666666664, 0.041666666666666664, -0.041666666666666664, -0.08333333333333333, -0.041666666666666664, 0.041666666666666664, 0.08333333333333333, 0.041666666666666664, -0.041666666666666664, -0.07216878364870322, -0.07216878364870322, -0.0, 0.07216878364870322, 0.07216878364870322, 0.0, -0.07216878364870322, -0.07216878364870322, -0.08333333333333333, -0.041666666666666664, 0.041666666666666664, 0.08333333333333333, -0.0, 0.07216878364870322, 0.07216878364870322],
    [0.041666666666666664, 0.05892556509887897, 0.0, -0.05892556509887897, -0.08333333333333333, -0.05892556509887897, -0.0, 0.05892556509887897, 0.08333333333333333, -0.05892556509887897, -0.08333333333333333, -0.05892556509887897, -0.0, 0.05892556509887897, 0.08333333333333333, 0.05892556509887897, 0.0, 0.05892556509887897, 0.0, -0.05892556509887897, -0.08333333333333333, -0.05892556509887897, -0.08333333333333333, -0.05892556509887897],
    [0.041666666666666664, 0.07216878364870322, 0.041666666666666664, 0.0, -0.041666666666666664, -0.07216878364870322, -0.08333333333333333, -0.07216878364870322, -0.041666666666666664, -0.041666666666666664, -0.07216878364870322, -0.08333333333333333, -0.07216878364870322, -0.041666666666666664, -0.0, 0.041666666666666664, 0.07216878364870322, -0.0, 0.041666666666666664, 0.07216878364870322, 0.08333333333333333, 0.08333333333333333, 0.07216878364870322, 0.041666666666666664],
    [0.041666666666666664, 0.08049381885742235, 0.07216878364870322, 0.05892556509887897, 0.041666666666666664, 0.02156825375854339, 0.0, -0.02156825375854339, -0.041666666666666664, -0.02156825375854339, -0.041666666666666664, -0.05892556509887897, -0.07216878364870322, -0.08049381885742235, -0.08333333333333333, -0.08049381885742235, -0.07216878364870322, -0.05892556509887897, -0.07216878364870322, -0.08049381885742235, -0.08333333333333333, -0.05892556509887897, -0.041666666666666664, -0.02156825375854339],
])

# cosines and sines of m phi, m = 1 ... 8, at 128 angles of half the circle
_XARM6_GRID_C = np.array([
    [1.0, 0.9996988186962042, 0.9987954562051724, 0.9972904566786902, 0.9951847266721969, 0.99247953459871, 0.989176509964781, 0.9852776423889412, 0.9807852804032304, 0.9757021300385286, 0.970031253194544, 0.9637760657954398, 0.9569403357322088, 0.9495281805930367, 0.9415440651830208, 0.9329927988347388, 0.9238795325112867, 0.9142097557035307, 0.9039892931234433, 0.8932243011955153, 0.881921264348355, 0.8700869911087115, 0.8577286100002721, 0.8448535652497071, 0.8314696123025452, 0.8175848131515837, 0.8032075314806449, 0.7883464276266062, 0.773010453362737, 0.7572088465064846, 0.7409511253549591, 0.7242470829514669, 0.7071067811865476, 0.6895405447370669, 0.6715589548470184, 0.6531728429537768, 0.6343932841636455, 0.6152315905806268, 0.5956993044924334, 0.5758081914178453, 0.5555702330196022, 0.5349976198870973, 0.5141027441932218, 0.49289819222978404, 0.47139673682599764, 0.4496113296546066, 0.4275550934302821, 0.40524131400498986, 0.3826834323650898, 0.35989503653498817, 0.33688985339222005, 0.31368174039889146, 0.2902846772544624, 0.26671275747489837, 0.2429801799032639, 0.2191012401568698, 0.19509032201612828, 0.17096188876030122, 0.14673047445536175, 0.1224106751992162, 0.0980171403295606, 0.07356456359966743, 0.049067674327418015, 0.024541228522912288, 0.0, -0.024541228522912288, -0.049067674327418015, -0.07356456359966743, -0.0980171403295606, -0.1224106751992162, -0.14673047445536175, -0.17096188876030122, -0.19509032201612828, -0.2191012401568698, -0.2429801799032639, -0.26671275747489837, -0.2902846772544624, -0.31368174039889146, -0.33688985339222005, -0.35989503653498817, -0.3826834323650898, -0.40524131400498986, -0.4275550934302821, -0.4496113296546066, -0.47139673682599764, -0.49289819222978404, -0.5141027441932218, -0.5349976198870973, -0.5555702330196022, -0.5758081914178453, -0.5956993044924334, -0.6152315905806268, -0.6343932841636455, -0.6531728429537768, -0.6715589548470184, -0.6895405447370669, -0.7071067811865476, -0.7242470829514669, -0.7409511253549591, -0.7572088465064846, -0.773010453362737, -0.7883464276266062, -0.8032075314806449, -0.8175848131515837, -0.8314696123025452, -0.8448535652497071, -0.8577286100002721, -0.8700869911087115, -0.881921264348355, -0.8932243011955153, -0.9039892931234433, -0.9142097557035307, -0.9238795325112867, -0.9329927988347388, -0.9415440651830208, -0.9495281805930367, -0.9569403357322088, -0.9637760657954398, -0.970031253194544, -0.9757021300385286, -0.9807852804032304, -0.9852776423889412, -0.989176509964781, -0.99247953459871, -0.9951847266721969, -0.9972904566786902, -0.9987954562051724, -0.9996988186962042],
    [1.0, 0.9987954562051724, 0.9951847266721969, 0.989176509964781, 0.9807852804032304, 0.970031253194544, 0.9569403357322088, 0.9415440651830208, 0.9238795325112867, 0.9039892931234433, 0.881921264348355, 0.8577286100002721, 0.8314696123025452, 0.8032075314806449, 0.773010453362737, 0.7409511253549591, 0.7071067811865476, 0.6715589548470184, 0.6343932841636455, 0.5956993044924334, 0.5555702330196022, 0.5141027441932218, 0.47139673682599764, 0.4275550934302821, 0.3826834323650898, 0.33688985339222005, 0.2902846772544624, 0.2429801799032639, 0.19509032201612828, 0.14673047445536175, 0.0980171403295606, 0.049067674327418015, 0.0, -0.049067674327418015, -0.0980171403295606, -0.14673047445536175, -0.19509032201612828, -0.2429801799032639, -0.2902846772544624, -0.33688985339222005, -0.3826834323650898, -0.4275550934302821, -0.47139673682599764, -0.5141027441932218, -0.5555702330196022, -0.5956993044924334, -0.6343932841636455, -0.6715589548470184, -0.7071067811865476, -0.7409511253549591, -0.773010453362737, -0.8032075314806449, -0.8314696123025452, -0.8577286100002721, -0.881921264348355, -0.9039892931234433, -0.9238795325112867, -0.9415440651830208, -0.9569403357322088, -0.970031253194544, -0.9807852804032304, -0.989176509964781, -0.9951847266721969, -0.9987954562051724, -1.0, -0.9987954562051724, -0.9951847266721969, -0.989176509964781, -0.9807852804032304, -0.970031253194544, -0.9569403357322088, -0.9415440651830208, -0.9238795325112867, -0.9039892931234433, -0.881921264348355, -0.8577286100002721, -0.8314696123025452, -0.8032075314806449, -0.773010453362737, -0.7409511253549591, -0.7071067811865476, -0.6715589548470184, -0.6343932841636455, -0.5956993044924334, -0.5555702330196022, -0.5141027441932218, -0.47139673682599764, -0.4275550934302821, -0.3826834323650898, -0.33688985339222005, -0.2902846772544624, -0.2429801799032639, -0.19509032201612828, -0.14673047445536175, -0.0980171403295606, -0.049067674327418015, 0.0, 0.049067674327418015, 0.0980171403295606, 0.14673047445536175, 0.19509032201612828, 0.2429801799032639, 0.2902846772544624, 0.33688985339222005, 0.3826834323650898, 0.4275550934302821, 0.47139673682599764, 0.5141027441932218, 0.5555702330196022, 0.5956993044924334, 0.6343932841636455, 0.6715589548470184, 0.7071067811865476, 0.7409511253549591, 0.773010453362737, 0.8032075314806449, 0.8314696123025452, 0.8577286100002721, 0.881921264348355, 0.9039892931234433, 0.9238795325112867, 0.9415440651830208, 0.9569403357322088, 0.970031253194544, 0.9807852804032304, 0.989176509964781, 0.9951847266721969, 0.9987954562051724],
    [1.0, 0.9972904566786902, 0.989176509964781, 0.9757021300385286, 0.9569403357322088, 0.9329927988347388, 0.9039892931234433, 0.8700869911087115, 0.8314696123025452, 0.7883464276266062, 0.7409511253549591, 0.6895405447370669, 0.6343932841636455, 0.5758081914178453, 0.5141027441932218, 0.4496113296546066, 0.3826834323650898, 0.31368174039889146, 0.2429801799032639, 0.17096188876030122, 0.0980171403295606, 0.024541228522912288, -0.049067674327418015, -0.1224106751992162, -0.19509032201612828, -0.26671275747489837, -0.33688985339222005, -0.40524131400498986, -0.47139673682599764, -0.5349976198870973, -0.5956993044924334, -0.6531728429537768, -0.7071067811865476, -0.7572088465064846, -0.8032075314806449, -0.8448535652497071, -0.881921264348355, -0.9142097557035307, -0.9415440651830208, -0.9637760657954398, -0.9807852804032304, -0.99247953459871, -0.9987954562051724, -0.9996988186962042, -0.9951847266721969, -0.9852776423889412, -0.970031253194544, -0.9495281805930367, -0.9238795325112867, -0.8932243011955153, -0.8577286100002721, -0.8175848131515837, -0.773010453362737, -0.7242470829514669, -0.6715589548470184, -0.6152315905806268, -0.5555702330196022, -0.49289819222978404, -0.4275550934302821, -0.35989503653498817, -0.2902846772544624, -0.2191012401568698, -0.14673047445536175, -0.07356456359966743, 0.0, 0.07356456359966743, 0.14673047445536175, 0.2191012401568698, 0.2902846772544624, 0.35989503653498817, 0.4275550934302821, 0.49289819222978404, 0.5555702330196022, 0.6152315905806268, 0.6715589548470184, 0.7242470829514669, 0.773010453362737, 0.8175848131515837, 0.8577286100002721, 0.8932243011955153, 0.9238795325112867, 0.9495281805930367, 0.970031253194544, 0.9852776423889412, 0.9951847266721969, 0.9996988186962042, 0.9987954562051724, 0.99247953459871, 0.9807852804032304, 0.9637760657954398, 0.9415440651830208, 0.9142097557035307, 0.881921264348355, 0.8448535652497071, 0.8032075314806449, 0.7572088465064846, 0.7071067811865476, 0.6531728429537768, 0.5956993044924334, 0.5349976198870973, 0.47139673682599764, 0.40524131400498986, 0.33688985339222005, 0.26671275747489837, 0.19509032201612828, 0.1224106751992162, 0.049067674327418015, -0.024541228522912288, -0.0980171403295606, -0.17096188876030122, -0.2429801799032639, -0.31368174039889146, -0.3826834323650898, -0.4496113296546066, -0.5141027441932218, -0.5758081914178453, -0.6343932841636455, -0.6895405447370669, -0.7409511253549591, -0.7883464276266062, -0.8314696123025452, -0.8700869911087115, -0.9039892931234433, -0.9329927988347388, -0.9569403357322088, -0.9757021300385286, -0.989176509964781, -0.9972904566786902],
    [1.0, 0.9951847266721969, 0.9807852804032304, 0.9569403357322088, 0.9238795325112867, 0.881921264348355, 0.8314696123025452, 0.773010453362737, 0.7071067811865476, 0.6343932841636455, 0.5555702330196022, 0.47139673682599764, 0.3826834323650898, 0.2902846772544624, 0.19509032201612828, 0.0980171403295606, 0.0, -0.0980171403295606, -0.19509032201612828, -0.2902846772544624, -0.3826834323650898, -0.47139673682599764, -0.5555702330196022, -0.6343932841636455, -0.7071067811865476, -0.773010453362737, -0.8314696123025452, -0.881921264348355, -0.9238795325112867, -0.9569403357322088, -0.9807852804032304, -0.9951847266721969, -1.0, -0.9951847266721969, -0.9807852804032304, -0.9569403357322088, -0.9238795325112867, -0.881921264348355, -0.8314696123025452, -0.773010453362737, -0.7071067811865476, -0.6343932841636455, -0.5555702330196022, -0.47139673682599764, -0.3826834323650898, -0.2902846772544624, -0.19509032201612828, -0.0980171403295606, 0.0, 0.0980171403295606, 0.19509032201612828, 0.2902846772544624, 0.3826834323650898, 0.47139673682599764, 0.5555702330196022, 0.6343932841636455, 0.7071067811865476, 0.773010453362737, 0.8314696123025452, 0.881921264348355, 0.9238795325112867, 0.9569403357322088, 0.9807852804032304, 0.9951847266721969, 1.0, 0.9951847266721969, 0.9807852804032304, 0.9569403357322088, 0.9238795325112867, 0.881921264348355, 0.8314696123025452, 0.773010453362737, 0.7071067811865476, 0.6343932841636455, 0.5555702330196022, 0.47139673682599764, 0.3826834323650898, 0.2902846772544624, 0.19509032201612828, 0.0980171403295606, 0.0, -0.0980171403295606, -0.19509032201612828, -0.2902846772544624, -0.3826834323650898, -0.47139673682599764, -0.5555702330196022, -0.6343932841636455, -0.7071067811865476, -0.773010453362737, -0.8314696123025452, -0.881921264348355, -0.9238795325112867, -0.9569403357322088, -0.9807852804032304, -0.9951847266721969, -1.0, -0.9951847266721969, -0.9807852804032304, -0.9569403357322088, -0.9238795325112867, -0.881921264348355, -0.8314696123025452, -0.773010453362737, -0.7071067811865476, -0.6343932841636455, -0.5555702330196022, -0.47139673682599764, -0.3826834323650898, -0.2902846772544624, -0.19509032201612828, -0.0980171403295606, 0.0, 0.0980171403295606, 0.19509032201612828, 0.2902846772544624, 0.3826834323650898, 0.47139673682599764, 0.5555702330196022, 0.6343932841636455, 0.7071067811865476, 0.773010453362737, 0.8314696123025452, 0.881921264348355, 0.9238795325112867, 0.9569403357322088, 0.9807852804032304, 0.9951847266721969],
    [1.0, 0.99247953459871, 0.970031253194544, 0.9329927988347388, 0.881921264348355, 0.8175848131515837, 0.7409511253549591, 0.6531728429537768, 0.5555702330196022, 0.4496113296546066, 0.33688985339222005, 0.2191012401568698, 0.0980171403295606, -0.024541228522912288, -0.14673047445536175, -0.26671275747489837, -0.3826834323650898, -0.49289819222978404, -0.5956993044924334, -0.6895405447370669, -0.773010453362737, -0.8448535652497071, -0.9039892931234433, -0.9495281805930367, -0.9807852804032304, -0.9972904566786902, -0.9987954562051724, -0.9852776423889412, -0.9569403357322088, -0.9142097557035307, -0.8577286100002721, -0.7883464276266062, -0.7071067811865476, -0.6152315905806268, -0.5141027441932218, -0.40524131400498986, -0.2902846772544624, -0.17096188876030122, -0.049067674327418015, 0.07356456359966743, 0.19509032201612828, 0.31368174039889146, 0.4275550934302821, 0.5349976198870973, 0.6343932841636455, 0.7242470829514669, 0.8032075314806449, 0.8700869911087115, 0.9238795325112867, 0.9637760657954398, 0.989176509964781, 0.9996988186962042, 0.9951847266721969, 0.9757021300385286, 0.9415440651830208, 0.8932243011955153, 0.8314696123025452, 0.7572088465064846, 0.6715589548470184, 0.5758081914178453, 0.47139673682599764, 0.35989503653498817, 0.2429801799032639, 0.1224106751992162, 0.0, -0.1224106751992162, -0.2429801799032639, -0.35989503653498817, -0.47139673682599764, -0.5758081914178453, -0.6715589548470184, -0.7572088465064846, -0.8314696123025452, -0.8932243011955153, -0.9415440651830208, -0.9757021300385286, -0.9951847266721969, -0.9996988186962042, -0.989176509964781, -0.9637760657954398, -0.9238795325112867, -0.8700869911087115, -0.8032075314806449, -0.7242470829514669, -0.6343932841636455, -0.5349976198870973, -0.4275550934302821, -0.31368174039889146, -0.19509032201612828, -0.07356456359966743, 0.049067674327418015, 0.17096188876030122, 0.2902846772544624, 0.40524131400498986, 0.5141027441932218, 0.6152315905806268, 0.7071067811865476, 0.7883464276266062, 0.8577286100002721, 0.9142097557035307, 0.9569403357322088, 0.9852776423889412, 0.9987954562051724, 0.9972904566786902, 0.9807852804032304, 0.9495281805930367, 0.9039892931234433, 0.8448535652497071, 0.773010453362737, 0.6895405447370669, 0.5956993044924334, 0.49289819222978404, 0.3826834323650898, 0.26671275747489837, 0.14673047445536175, 0.024541228522912288, -0.0980171403295606, -0.2191012401568698, -0.33688985339222005, -0.4496113296546066, -0.5555702330196022, -0.6531728429537768, -0.7409511253549591, -0.8175848131515837, -0.881921264348355, -0.9329927988347388, -0.970031253194544, -0.99247953459871],
    [1.0, 0.989176509964781, 0.9569403357322088, 0.9039892931234433, 0.8314696123025452, 0.7409511253549591, 0.6343932841636455, 0.5141027441932218, 0.3826834323650898, 0.2429801799032639, 0.0980171403295606, -0.049067674327418015, -0.19509032201612828, -0.33688985339222005, -0.47139673682599764, -0.5956993044924334, -0.7071067811865476, -0.8032075314806449, -0.881921264348355, -0.9415440651830208, -0.9807852804032304, -0.9987954562051724, -0.9951847266721969, -0.970031253194544, -0.9238795325112867, -0.8577286100002721, -0.773010453362737, -0.6715589548470184, -0.5555702330196022, -0.4275550934302821, -0.2902846772544624, -0.14673047445536175, 0.0, 0.14673047445536175, 0.2902846772544624, 0.4275550934302821, 0.5555702330196022, 0.6715589548470184, 0.773010453362737, 0.8577286100002721, 0.9238795325112867, 0.970031253194544, 0.9951847266721969, 0.9987954562051724, 0.9807852804032304, 0.9415440651830208, 0.881921264348355, 0.8032075314806449, 0.7071067811865476, 0.5956993044924334, 0.47139673682599764, 0.33688985339222005, 0.19509032201612828, 0.049067674327418015, -0.0980171403295606, -0.2429801799032639, -0.3826834323650898, -0.5141027441932218, -0.6343932841636455, -0.7409511253549591, -0.8314696123025452, -0.9039892931234433, -0.9569403357322088, -0.989176509964781, -1.0, -0.989176509964781, -0.9569403357322088, -0.9039892931234433, -0.8314696123025452, -0.7409511253549591, -0.6343932841636455, -0.5141027441932218, -0.3826834323650898, -0.2429801799032639, -0.0980171403295606, 0.049067674327418015, 0.19509032201612828, 0.33688985339222005, 0.47139673682599764, 0.5956993044924334, 0.7071067811865476, 0.8032075314806449, 0.881921264348355, 0.9415440651830208, 0.9807852804032304, 0.9987954562051724, 0.9951847266721969, 0.970031253194544, 0.9238795325112867, 0.8577286100002721, 0.773010453362737, 0.6715589548470184, 0.5555702330196022, 0.4275550934302821, 0.2902846772544624, 0.14673047445536175, 0.0, -0.14673047445536175, -0.2902846772544624, -0.4275550934302821, -0.5555702330196022, -0.6715589548470184, -0.773010453362737, -0.8577286100002721, -0.9238795325112867, -0.970031253194544, -0.9951847266721969, -0.9987954562051724, -0.9807852804032304, -0.9415440651830208, -0.881921264348355, -0.8032075314806449, -0.7071067811865476, -0.5956993044924334, -0.47139673682599764, -0.33688985339222005, -0.19509032201612828, -0.049067674327418015, 0.0980171403295606, 0.2429801799032639, 0.3826834323650898, 0.5141027441932218, 0.6343932841636455, 0.7409511253549591, 0.8314696123025452, 0.9039892931234433, 0.9569403357322088, 0.989176509964781],
    [1.0, 0.9852776423889412, 0.9415440651830208, 0.8700869911087115, 0.773010453362737, 0.6531728429537768, 0.5141027441932218, 0.35989503653498817, 0.19509032201612828, 0.024541228522912288, -0.14673047445536175, -0.31368174039889146, -0.47139673682599764, -0.6152315905806268, -0.7409511253549591, -0.8448535652497071, -0.9238795325112867, -0.9757021300385286, -0.9987954562051724, -0.99247953459871, -0.9569403357322088, -0.8932243011955153, -0.8032075314806449, -0.6895405447370669, -0.5555702330196022, -0.40524131400498986, -0.2429801799032639, -0.07356456359966743, 0.0980171403295606, 0.26671275747489837, 0.4275550934302821, 0.5758081914178453, 0.7071067811865476, 0.8175848131515837, 0.9039892931234433, 0.9637760657954398, 0.9951847266721969, 0.9972904566786902, 0.970031253194544, 0.9142097557035307, 0.8314696123025452, 0.7242470829514669, 0.5956993044924334, 0.4496113296546066, 0.2902846772544624, 0.1224106751992162, -0.049067674327418015, -0.2191012401568698, -0.3826834323650898, -0.5349976198870973, -0.6715589548470184, -0.7883464276266062, -0.881921264348355, -0.9495281805930367, -0.989176509964781, -0.9996988186962042, -0.9807852804032304, -0.9329927988347388, -0.8577286100002721, -0.7572088465064846, -0.6343932841636455, -0.49289819222978404, -0.33688985339222005, -0.17096188876030122, 0.0, 0.17096188876030122, 0.33688985339222005, 0.49289819222978404, 0.6343932841636455, 0.7572088465064846, 0.8577286100002721, 0.9329927988347388, 0.9807852804032304, 0.9996988186962042, 0.989176509964781, 0.9495281805930367, 0.881921264348355, 0.7883464276266062, 0.6715589548470184, 0.5349976198870973, 0.3826834323650898, 0.2191012401568698, 0.049067674327418015, -0.1224106751992162, -0.2902846772544624, -0.4496113296546066, -0.5956993044924334, -0.7242470829514669, -0.8314696123025452, -0.9142097557035307, -0.970031253194544, -0.9972904566786902, -0.9951847266721969, -0.9637760657954398, -0.9039892931234433, -0.8175848131515837, -0.7071067811865476, -0.5758081914178453, -0.4275550934302821, -0.26671275747489837, -0.0980171403295606, 0.07356456359966743, 0.2429801799032639, 0.40524131400498986, 0.5555702330196022, 0.6895405447370669, 0.8032075314806449, 0.8932243011955153, 0.9569403357322088, 0.99247953459871, 0.9987954562051724, 0.9757021300385286, 0.9238795325112867, 0.8448535652497071, 0.7409511253549591, 0.6152315905806268, 0.47139673682599764, 0.31368174039889146, 0.14673047445536175, -0.024541228522912288, -0.19509032201612828, -0.35989503653498817, -0.5141027441932218, -0.6531728429537768, -0.773010453362737, -0.8700869911087115, -0.9415440651830208, -0.9852776423889412],
    [1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304],
])
_XARM6_GRID_S = np.array([
    [0.0, 0.024541228522912288, 0.049067674327418015, 0.07356456359966743, 0.0980171403295606, 0.1224106751992162, 0.14673047445536175, 0.17096188876030122, 0.19509032201612828, 0.2191012401568698, 0.2429801799032639, 0.26671275747489837, 0.2902846772544624, 0.31368174039889146, 0.33688985339222005, 0.35989503653498817, 0.3826834323650898, 0.40524131400498986, 0.4275550934302821, 0.4496113296546066, 0.47139673682599764, 0.49289819222978404, 0.5141027441932218, 0.5349976198870973, 0.5555702330196022, 0.5758081914178453, 0.5956993044924334, 0.6152315905806268, 0.6343932841636455, 0.6531728429537768, 0.6715589548470184, 0.6895405447370669, 0.7071067811865476, 0.7242470829514669, 0.7409511253549591, 0.7572088465064846, 0.773010453362737, 0.7883464276266062, 0.8032075314806449, 0.8175848131515837, 0.8314696123025452, 0.8448535652497071, 0.8577286100002721, 0.8700869911087115, 0.881921264348355, 0.8932243011955153, 0.9039892931234433, 0.9142097557035307, 0.9238795325112867, 0.9329927988347388, 0.9415440651830208, 0.9495281805930367, 0.9569403357322088, 0.9637760657954398, 0.970031253194544, 0.9757021300385286, 0.9807852804032304, 0.9852776423889412, 0.989176509964781, 0.99247953459871, 0.9951847266721969, 0.9972904566786902, 0.9987954562051724, 0.9996988186962042, 1.0, 0.9996988186962042, 0.9987954562051724, 0.9972904566786902, 0.9951847266721969, 0.99247953459871, 0.989176509964781, 0.9852776423889412, 0.9807852804032304, 0.9757021300385286, 0.970031253194544, 0.9637760657954398, 0.9569403357322088, 0.9495281805930367, 0.9415440651830208, 0.9329927988347388, 0.9238795325112867, 0.9142097557035307, 0.9039892931234433, 0.8932243011955153, 0.881921264348355, 0.8700869911087115, 0.8577286100002721, 0.8448535652497071, 0.8314696123025452, 0.8175848131515837, 0.8032075314806449, 0.7883464276266062, 0.773010453362737, 0.7572088465064846, 0.7409511253549591, 0.7242470829514669, 0.7071067811865476, 0.6895405447370669, 0.6715589548470184, 0.6531728429537768, 0.6343932841636455, 0.6152315905806268, 0.5956993044924334, 0.5758081914178453, 0.5555702330196022, 0.5349976198870973, 0.5141027441932218, 0.49289819222978404, 0.47139673682599764, 0.4496113296546066, 0.4275550934302821, 0.40524131400498986, 0.3826834323650898, 0.35989503653498817, 0.33688985339222005, 0.31368174039889146, 0.2902846772544624, 0.26671275747489837, 0.2429801799032639, 0.2191012401568698, 0.19509032201612828, 0.17096188876030122, 0.14673047445536175, 0.1224106751992162, 0.0980171403295606, 0.07356456359966743, 0.049067674327418015, 0.024541228522912288],
    [0.0, 0.049067674327418015, 0.0980171403295606, 0.14673047445536175, 0.19509032201612828, 0.2429801799032639, 0.2902846772544624, 0.33688985339222005, 0.3826834323650898, 0.4275550934302821, 0.47139673682599764, 0.5141027441932218, 0.5555702330196022, 0.5956993044924334, 0.6343932841636455, 0.6715589548470184, 0.7071067811865476, 0.7409511253549591, 0.773010453362737, 0.8032075314806449, 0.8314696123025452, 0.8577286100002721, 0.881921264348355, 0.9039892931234433, 0.9238795325112867, 0.9415440651830208, 0.9569403357322088, 0.970031253194544, 0.9807852804032304, 0.989176509964781, 0.9951847266721969, 0.9987954562051724, 1.0, 0.9987954562051724, 0.9951847266721969, 0.989176509964781, 0.9807852804032304, 0.970031253194544, 0.9569403357322088, 0.9415440651830208, 0.9238795325112867, 0.9039892931234433, 0.881921264348355, 0.8577286100002721, 0.8314696123025452, 0.8032075314806449, 0.773010453362737, 0.7409511253549591, 0.7071067811865476, 0.6715589548470184, 0.6343932841636455, 0.5956993044924334, 0.5555702330196022, 0.5141027441932218, 0.47139673682599764, 0.4275550934302821, 0.3826834323650898, 0.33688985339222005, 0.2902846772544624, 0.2429801799032639, 0.19509032201612828, 0.14673047445536175, 0.0980171403295606, 0.049067674327418015, 0.0, -0.049067674327418015, -0.0980171403295606, -0.14673047445536175, -0.19509032201612828, -0.2429801799032639, -0.2902846772544624, -0.33688985339222005, -0.3826834323650898, -0.4275550934302821, -0.47139673682599764, -0.5141027441932218, -0.5555702330196022, -0.5956993044924334, -0.6343932841636455, -0.6715589548470184, -0.7071067811865476, -0.7409511253549591, -0.773010453362737, -0.8032075314806449, -0.8314696123025452, -0.8577286100002721, -0.881921264348355, -0.9039892931234433, -0.9238795325112867, -0.9415440651830208, -0.9569403357322088, -0.970031253194544, -0.9807852804032304, -0.989176509964781, -0.9951847266721969, -0.9987954562051724, -1.0, -0.9987954562051724, -0.9951847266721969, -0.989176509964781, -0.9807852804032304, -0.970031253194544, -0.9569403357322088, -0.9415440651830208, -0.9238795325112867, -0.9039892931234433, -0.881921264348355, -0.8577286100002721, -0.8314696123025452, -0.8032075314806449, -0.773010453362737, -0.7409511253549591, -0.7071067811865476, -0.6715589548470184, -0.6343932841636455, -0.5956993044924334, -0.5555702330196022, -0.5141027441932218, -0.47139673682599764, -0.4275550934302821, -0.3826834323650898, -0.33688985339222005, -0.2902846772544624, -0.2429801799032639, -0.19509032201612828, -0.14673047445536175, -0.0980171403295606, -0.049067674327418015],
    [0.0, 0.07356456359966743, 0.14673047445536175, 0.2191012401568698, 0.2902846772544624, 0.35989503653498817, 0.4275550934302821, 0.49289819222978404, 0.5555702330196022, 0.6152315905806268, 0.6715589548470184, 0.7242470829514669, 0.773010453362737, 0.8175848131515837, 0.8577286100002721, 0.8932243011955153, 0.9238795325112867, 0.9495281805930367, 0.970031253194544, 0.9852776423889412, 0.9951847266721969, 0.9996988186962042, 0.9987954562051724, 0.99247953459871, 0.9807852804032304, 0.9637760657954398, 0.9415440651830208, 0.9142097557035307, 0.881921264348355, 0.8448535652497071, 0.8032075314806449, 0.7572088465064846, 0.7071067811865476, 0.6531728429537768, 0.5956993044924334, 0.5349976198870973, 0.47139673682599764, 0.40524131400498986, 0.33688985339222005, 0.26671275747489837, 0.19509032201612828, 0.1224106751992162, 0.049067674327418015, -0.024541228522912288, -0.0980171403295606, -0.17096188876030122, -0.2429801799032639, -0.31368174039889146, -0.3826834323650898, -0.4496113296546066, -0.5141027441932218, -0.5758081914178453, -0.6343932841636455, -0.6895405447370669, -0.7409511253549591, -0.7883464276266062, -0.8314696123025452, -0.8700869911087115, -0.9039892931234433, -0.9329927988347388, -0.9569403357322088, -0.9757021300385286, -0.989176509964781, -0.9972904566786902, -1.0, -0.9972904566786902, -0.989176509964781, -0.9757021300385286, -0.9569403357322088, -0.9329927988347388, -0.9039892931234433, -0.8700869911087115, -0.8314696123025452, -0.7883464276266062, -0.7409511253549591, -0.6895405447370669, -0.6343932841636455, -0.5758081914178453, -0.5141027441932218, -0.4496113296546066, -0.3826834323650898, -0.31368174039889146, -0.2429801799032639, -0.17096188876030122, -0.0980171403295606, -0.024541228522912288, 0.049067674327418015, 0.1224106751992162, 0.19509032201612828, 0.26671275747489837, 0.33688985339222005, 0.40524131400498986, 0.47139673682599764, 0.5349976198870973, 0.5956993044924334, 0.6531728429537768, 0.7071067811865476, 0.7572088465064846, 0.8032075314806449, 0.8448535652497071, 0.881921264348355, 0.9142097557035307, 0.9415440651830208, 0.9637760657954398, 0.9807852804032304, 0.99247953459871, 0.9987954562051724, 0.9996988186962042, 0.9951847266721969, 0.9852776423889412, 0.970031253194544, 0.9495281805930367, 0.9238795325112867, 0.8932243011955153, 0.8577286100002721, 0.8175848131515837, 0.773010453362737, 0.7242470829514669, 0.6715589548470184, 0.6152315905806268, 0.5555702330196022, 0.49289819222978404, 0.4275550934302821, 0.35989503653498817, 0.2902846772544624, 0.2191012401568698, 0.14673047445536175, 0.07356456359966743],
    [0.0, 0.0980171403295606, 0.19509032201612828, 0.2902846772544624, 0.3826834323650898, 0.47139673682599764, 0.5555702330196022, 0.6343932841636455, 0.7071067811865476, 0.773010453362737, 0.8314696123025452, 0.881921264348355, 0.9238795325112867, 0.9569403357322088, 0.9807852804032304, 0.9951847266721969, 1.0, 0.9951847266721969, 0.9807852804032304, 0.9569403357322088, 0.9238795325112867, 0.881921264348355, 0.8314696123025452, 0.773010453362737, 0.7071067811865476, 0.6343932841636455, 0.5555702330196022, 0.47139673682599764, 0.3826834323650898, 0.2902846772544624, 0.19509032201612828, 0.0980171403295606, 0.0, -0.0980171403295606, -0.19509032201612828, -0.2902846772544624, -0.3826834323650898, -0.47139673682599764, -0.5555702330196022, -0.6343932841636455, -0.7071067811865476, -0.773010453362737, -0.8314696123025452, -0.881921264348355, -0.9238795325112867, -0.9569403357322088, -0.9807852804032304, -0.9951847266721969, -1.0, -0.9951847266721969, -0.9807852804032304, -0.9569403357322088, -0.9238795325112867, -0.881921264348355, -0.8314696123025452, -0.773010453362737, -0.7071067811865476, -0.6343932841636455, -0.5555702330196022, -0.47139673682599764, -0.3826834323650898, -0.2902846772544624, -0.19509032201612828, -0.0980171403295606, 0.0, 0.0980171403295606, 0.19509032201612828, 0.2902846772544624, 0.3826834323650898, 0.47139673682599764, 0.5555702330196022, 0.6343932841636455, 0.7071067811865476, 0.773010453362737, 0.8314696123025452, 0.881921264348355, 0.9238795325112867, 0.9569403357322088, 0.9807852804032304, 0.9951847266721969, 1.0, 0.9951847266721969, 0.9807852804032304, 0.9569403357322088, 0.9238795325112867, 0.881921264348355, 0.8314696123025452, 0.773010453362737, 0.7071067811865476, 0.6343932841636455, 0.5555702330196022, 0.47139673682599764, 0.3826834323650898, 0.2902846772544624, 0.19509032201612828, 0.0980171403295606, 0.0, -0.0980171403295606, -0.19509032201612828, -0.2902846772544624, -0.3826834323650898, -0.47139673682599764, -0.5555702330196022, -0.6343932841636455, -0.7071067811865476, -0.773010453362737, -0.8314696123025452, -0.881921264348355, -0.9238795325112867, -0.9569403357322088, -0.9807852804032304, -0.9951847266721969, -1.0, -0.9951847266721969, -0.9807852804032304, -0.9569403357322088, -0.9238795325112867, -0.881921264348355, -0.8314696123025452, -0.773010453362737, -0.7071067811865476, -0.6343932841636455, -0.5555702330196022, -0.47139673682599764, -0.3826834323650898, -0.2902846772544624, -0.19509032201612828, -0.0980171403295606],
    [0.0, 0.1224106751992162, 0.2429801799032639, 0.35989503653498817, 0.47139673682599764, 0.5758081914178453, 0.6715589548470184, 0.7572088465064846, 0.8314696123025452, 0.8932243011955153, 0.9415440651830208, 0.9757021300385286, 0.9951847266721969, 0.9996988186962042, 0.989176509964781, 0.9637760657954398, 0.9238795325112867, 0.8700869911087115, 0.8032075314806449, 0.7242470829514669, 0.6343932841636455, 0.5349976198870973, 0.4275550934302821, 0.31368174039889146, 0.19509032201612828, 0.07356456359966743, -0.049067674327418015, -0.17096188876030122, -0.2902846772544624, -0.40524131400498986, -0.5141027441932218, -0.6152315905806268, -0.7071067811865476, -0.7883464276266062, -0.8577286100002721, -0.9142097557035307, -0.9569403357322088, -0.9852776423889412, -0.9987954562051724, -0.9972904566786902, -0.9807852804032304, -0.9495281805930367, -0.9039892931234433, -0.8448535652497071, -0.773010453362737, -0.6895405447370669, -0.5956993044924334, -0.49289819222978404, -0.3826834323650898, -0.26671275747489837, -0.14673047445536175, -0.024541228522912288, 0.0980171403295606, 0.2191012401568698, 0.33688985339222005, 0.4496113296546066, 0.5555702330196022, 0.6531728429537768, 0.7409511253549591, 0.8175848131515837, 0.881921264348355, 0.9329927988347388, 0.970031253194544, 0.99247953459871, 1.0, 0.99247953459871, 0.970031253194544, 0.9329927988347388, 0.881921264348355, 0.8175848131515837, 0.7409511253549591, 0.6531728429537768, 0.5555702330196022, 0.4496113296546066, 0.33688985339222005, 0.2191012401568698, 0.0980171403295606, -0.024541228522912288, -0.14673047445536175, -0.26671275747489837, -0.3826834323650898, -0.49289819222978404, -0.5956993044924334, -0.6895405447370669, -0.773010453362737, -0.8448535652497071, -0.9039892931234433, -0.9495281805930367, -0.9807852804032304, -0.9972904566786902, -0.9987954562051724, -0.9852776423889412, -0.9569403357322088, -0.9142097557035307, -0.8577286100002721, -0.7883464276266062, -0.7071067811865476, -0.6152315905806268, -0.5141027441932218, -0.40524131400498986, -0.2902846772544624, -0.17096188876030122, -0.049067674327418015, 0.07356456359966743, 0.19509032201612828, 0.31368174039889146, 0.4275550934302821, 0.5349976198870973, 0.6343932841636455, 0.7242470829514669, 0.8032075314806449, 0.8700869911087115, 0.9238795325112867, 0.9637760657954398, 0.989176509964781, 0.9996988186962042, 0.9951847266721969, 0.9757021300385286, 0.9415440651830208, 0.8932243011955153, 0.8314696123025452, 0.7572088465064846, 0.6715589548470184, 0.5758081914178453, 0.47139673682599764, 0.35989503653498817, 0.2429801799032639, 0.1224106751992162],
    [0.0, 0.14673047445536175, 0.2902846772544624, 0.4275550934302821, 0.5555702330196022, 0.6715589548470184, 0.773010453362737, 0.8577286100002721, 0.9238795325112867, 0.970031253194544, 0.9951847266721969, 0.9987954562051724, 0.9807852804032304, 0.9415440651830208, 0.881921264348355, 0.8032075314806449, 0.7071067811865476, 0.5956993044924334, 0.47139673682599764, 0.33688985339222005, 0.19509032201612828, 0.049067674327418015, -0.0980171403295606, -0.2429801799032639, -0.3826834323650898, -0.5141027441932218, -0.6343932841636455, -0.7409511253549591, -0.8314696123025452, -0.9039892931234433, -0.9569403357322088, -0.989176509964781, -1.0, -0.989176509964781, -0.9569403357322088, -0.9039892931234433, -0.8314696123025452, -0.7409511253549591, -0.6343932841636455, -0.5141027441932218, -0.3826834323650898, -0.2429801799032639, -0.0980171403295606, 0.049067674327418015, 0.19509032201612828, 0.33688985339222005, 0.47139673682599764, 0.5956993044924334, 0.7071067811865476, 0.8032075314806449, 0.881921264348355, 0.9415440651830208, 0.9807852804032304, 0.9987954562051724, 0.9951847266721969, 0.970031253194544, 0.9238795325112867, 0.8577286100002721, 0.773010453362737, 0.6715589548470184, 0.5555702330196022, 0.4275550934302821, 0.2902846772544624, 0.14673047445536175, 0.0, -0.14673047445536175, -0.2902846772544624, -0.4275550934302821, -0.5555702330196022, -0.6715589548470184, -0.773010453362737, -0.8577286100002721, -0.9238795325112867, -0.970031253194544, -0.9951847266721969, -0.9987954562051724, -0.9807852804032304, -0.9415440651830208, -0.881921264348355, -0.8032075314806449, -0.7071067811865476, -0.5956993044924334, -0.47139673682599764, -0.33688985339222005, -0.19509032201612828, -0.049067674327418015, 0.0980171403295606, 0.2429801799032639, 0.3826834323650898, 0.5141027441932218, 0.6343932841636455, 0.7409511253549591, 0.8314696123025452, 0.9039892931234433, 0.9569403357322088, 0.989176509964781, 1.0, 0.989176509964781, 0.9569403357322088, 0.9039892931234433, 0.8314696123025452, 0.7409511253549591, 0.6343932841636455, 0.5141027441932218, 0.3826834323650898, 0.2429801799032639, 0.0980171403295606, -0.049067674327418015, -0.19509032201612828, -0.33688985339222005, -0.47139673682599764, -0.5956993044924334, -0.7071067811865476, -0.8032075314806449, -0.881921264348355, -0.9415440651830208, -0.9807852804032304, -0.9987954562051724, -0.9951847266721969, -0.970031253194544, -0.9238795325112867, -0.8577286100002721, -0.773010453362737, -0.6715589548470184, -0.5555702330196022, -0.4275550934302821, -0.2902846772544624, -0.14673047445536175],
    [0.0, 0.17096188876030122, 0.33688985339222005, 0.49289819222978404, 0.6343932841636455, 0.7572088465064846, 0.8577286100002721, 0.9329927988347388, 0.9807852804032304, 0.9996988186962042, 0.989176509964781, 0.9495281805930367, 0.881921264348355, 0.7883464276266062, 0.6715589548470184, 0.5349976198870973, 0.3826834323650898, 0.2191012401568698, 0.049067674327418015, -0.1224106751992162, -0.2902846772544624, -0.4496113296546066, -0.5956993044924334, -0.7242470829514669, -0.8314696123025452, -0.9142097557035307, -0.970031253194544, -0.9972904566786902, -0.9951847266721969, -0.9637760657954398, -0.9039892931234433, -0.8175848131515837, -0.7071067811865476, -0.5758081914178453, -0.4275550934302821, -0.26671275747489837, -0.0980171403295606, 0.07356456359966743, 0.2429801799032639, 0.40524131400498986, 0.5555702330196022, 0.6895405447370669, 0.8032075314806449, 0.8932243011955153, 0.9569403357322088, 0.99247953459871, 0.9987954562051724, 0.9757021300385286, 0.9238795325112867, 0.8448535652497071, 0.7409511253549591, 0.6152315905806268, 0.47139673682599764, 0.31368174039889146, 0.14673047445536175, -0.024541228522912288, -0.19509032201612828, -0.35989503653498817, -0.5141027441932218, -0.6531728429537768, -0.773010453362737, -0.8700869911087115, -0.9415440651830208, -0.9852776423889412, -1.0, -0.9852776423889412, -0.9415440651830208, -0.8700869911087115, -0.773010453362737, -0.6531728429537768, -0.5141027441932218, -0.35989503653498817, -0.19509032201612828, -0.024541228522912288, 0.14673047445536175, 0.31368174039889146, 0.47139673682599764, 0.6152315905806268, 0.7409511253549591, 0.8448535652497071, 0.9238795325112867, 0.9757021300385286, 0.9987954562051724, 0.99247953459871, 0.9569403357322088, 0.8932243011955153, 0.8032075314806449, 0.6895405447370669, 0.5555702330196022, 0.40524131400498986, 0.2429801799032639, 0.07356456359966743, -0.0980171403295606, -0.26671275747489837, -0.4275550934302821, -0.5758081914178453, -0.7071067811865476, -0.8175848131515837, -0.9039892931234433, -0.9637760657954398, -0.9951847266721969, -0.9972904566786902, -0.970031253194544, -0.9142097557035307, -0.8314696123025452, -0.7242470829514669, -0.5956993044924334, -0.4496113296546066, -0.2902846772544624, -0.1224106751992162, 0.049067674327418015, 0.2191012401568698, 0.3826834323650898, 0.5349976198870973, 0.6715589548470184, 0.7883464276266062, 0.881921264348355, 0.9495281805930367, 0.989176509964781, 0.9996988186962042, 0.9807852804032304, 0.9329927988347388, 0.8577286100002721, 0.7572088465064846, 0.6343932841636455, 0.49289819222978404, 0.33688985339222005, 0.17096188876030122],
    [0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828],
])
_XARM6_START = np.array([
    [0.61, -0.37, 0.53, 0.29, 0.71, -0.43],
    [-0.31, 0.47, 0.59, 0.67, -0.23, 0.41],
])


@_inner
def _xarm6_follow(T, K):
    """T K for rigid transforms, twelve numbers each, in place."""
    for i in range(0, 12, 4):
        a, b, c = T[i], T[i + 1], T[i + 2]
        for j in range(3):
            T[i + j] = a * K[j] + b * K[4 + j] + c * K[8 + j]
        T[i + 3] += a * K[3] + b * K[7] + c * K[11]


@_inner
def _xarm6_invert(A):
    """The inverse of a rigid transform."""
    B = np.empty(12)
    for i in range(3):
        for j in range(3):
            B[4 * i + j] = A[4 * j + i]
        B[4 * i + 3] = -(A[i] * A[3] + A[4 + i] * A[7] + A[8 + i] * A[11])
    return B


@_inner
def _xarm6_turn(T, c, s):
    """T Rz, in place."""
    for i in range(3):
        x, y = T[4 * i], T[4 * i + 1]
        T[4 * i] = x * c + y * s
        T[4 * i + 1] = y * c - x * s


@_inner
def _xarm6_move(T, joint, c, s):
    """The motion of a joint, by cosine and sine or by a length that stands in the sine's place."""
    _xarm6_turn(T, c, s)


@_inner
def _xarm6_close(T):
    """The loop: K0 ... K4 and its pose P = L T R, in arm sizes; in its place L stands before, then R."""
    links, first = np.empty((7, 12)), (0, 1, 2, 3, 4, 5, 6)
    for i in range(7):
        _take(links[i], _XARM6_CONSTANTS[first[i]])
    _xarm6_follow(links[5], T)
    _xarm6_follow(links[5], links[6])
    for i in range(3):
        links[5, 4 * i + 3] *= 2.7597365425946974
    return links


@_inner
def _xarm6_unit(c, s):
    """A cosine and a sine without their common factor, which is told while it has a square."""
    length = math.sqrt(c * c + s * s)
    if not 1e-150 < length < math.inf:
        return 1.0, 0.0
    return c / length, s / length


@_inner
def _xarm6_reflect(M, first, rest, column):
    """Reflect the first row and the rows from `rest` on so that `column` stays in the first only."""
    rows, columns = M.shape
    head = M[first, column]
    square = head * head
    for i in range(rest, rows):
        square += M[i, column] * M[i, column]
    length = math.copysign(math.sqrt(square), head)
    head += length
    factor = 1.0 / (length * head + 1e-300)
    for j in range(column + 1, columns):
        total = head * M[first, j]
        for i in range(rest, rows):
            total += M[i, column] * M[i, j]
        total *= factor
        M[first, j] -= head * total
        for i in range(rest, rows):
            M[i, j] -= M[i, column] * total
    for i in range(rest, rows):
        M[i, column] = 0.0
    M[first, column] = -length
    return -length


@_apart("float64[:, ::1](int64, float64[:, ::1])")
def _xarm6_around(form, loop):
    """The links L0 ... L5 of a formulation."""
    links = np.empty((6, 12))
    for i in range(6):
        joint = _XARM6_JOINTS[form, i]
        if _XARM6_SIGNS[form] > 0.0:
            _take(links[i], loop[joint] if joint < 5 else _xarm6_invert(loop[5]))
        else:
            _take(links[i], _xarm6_invert(loop[joint - 1]) if joint > 0 else loop[5])
    return links


@_apart("void(float64[::1], float64[:, ::1])")
def _xarm6_act(K, x):
    """The features of a point and a direction, for all columns of x: 1, l, p, p.p, p.l, p x l and
    (p.p) l - 2 (p.l) p, as a rigid motion acts on them, in place."""
    t0, t1, t2 = K[3], K[7], K[11]
    square = t0 * t0 + t1 * t1 + t2 * t2
    for k in range(x.shape[1]):
        for at in (1, 4, 9, 12):
            a, b, c = x[at, k], x[at + 1, k], x[at + 2, k]
            for i in range(3):
                x[at + i, k] = K[4 * i] * a + K[4 * i + 1] * b + K[4 * i + 2] * c
        u0, u1, u2, q0, q1, q2 = x[1, k], x[2, k], x[3, k], x[4, k], x[5, k], x[6, k]
        v0, v1, v2, one = x[9, k], x[10, k], x[11, k], x[0, k]
        along = t0 * u0 + t1 * u1 + t2 * u2
        x[7, k] += 2.0 * (t0 * q0 + t1 * q1 + t2 * q2) + square * one
        x[8, k] += along
        twice = 2.0 * x[8, k]
        x[4, k] += t0 * one
        x[5, k] += t1 * one
        x[6, k] += t2 * one
        x[9, k] += t1 * u2 - t2 * u1
        x[10, k] += t2 * u0 - t0 * u2
        x[11, k] += t0 * u1 - t1 * u0
        x[12, k] += square * u0 - twice * t0 - 2.0 * (t1 * v2 - t2 * v1)
        x[13, k] += square * u1 - twice * t1 - 2.0 * (t2 * v0 - t0 * v2)
        x[14, k] += square * u2 - twice * t2 - 2.0 * (t0 * v1 - t1 * v0)


@_apart("float64[:, ::1](float64[::1], float64[:, ::1], int64, boolean)")
def _xarm6_pass(K, x, joint, powers):
    """Columns of features pass a link, and each becomes three by what the joint before it does: the
    coefficients of 1, cos and sin, or with `powers` of y^2, y and 1 for y = tan(phi/2), times
    1 + y^2, or for the length of a slide. Column a columns + k is part a of column k."""
    n = x.shape[1]
    _xarm6_act(K, x)
    to = np.zeros((15, 3 * n))
    for i in range(15):
        for k in range(n):
            to[i, k] = x[i, k]
    for at in (1, 4, 9, 12):
        for k in range(n):
            to[at, k] = to[at + 1, k] = 0.0
            to[at, n + k] = to[at + 1, 2 * n + k] = x[at, k]
            to[at + 1, n + k] = x[at + 1, k]
            to[at, 2 * n + k] = -x[at + 1, k]
    if powers:
        for i in range(15):
            for k in range(n):
                one, cosine, sine = to[i, k], to[i, n + k], to[i, 2 * n + k]
                to[i, k], to[i, n + k], to[i, 2 * n + k] = one - cosine, 2.0 * sine, one + cosine
    return to


@_apart("float64[:, ::1](int64[::1], float64[:, ::1])")
def _xarm6_equations(joints, links):
    """The six equations of a formulation: columns 9 a + 3 j + i for 1, c1, s1 (a), the powers x3^2, x3,
    1 (i) and x2^2, x2, 1 (j) of the partners' half-angle tangents or lengths."""
    right, left = np.zeros((15, 1)), np.zeros((15, 1))
    right[0, 0] = right[3, 0] = left[0, 0] = left[3, 0] = 1.0  # the origin and z
    for i in (3, 4):
        right = _xarm6_pass(_xarm6_invert(links[i]), right, joints[i + 1], False)
    for i in (2, 1, 0):
        left = _xarm6_pass(links[i], left, joints[i], i > 0)
    _xarm6_act(links[5], left)
    work = np.empty((14, 35))
    for i in range(14):
        for k in range(8):
            work[i, k] = right[1 + i, 1 + k]
        for k in range(27):
            # the constant column of the right side, times 1 + x2^2 and 1 + x3^2
            work[i, 8 + k] = left[1 + i, k] - right[1 + i, 0] * left[0, k]
    for column in range(8):
        _xarm6_reflect(work, column, column + 1, column)
    E = np.empty((6, 27))
    for i in range(6):
        for k in range(27):
            E[i, k] = work[8 + i, 8 + k]
    return E


@_merged
def _xarm6_reflect_all(M, columns, first, rest, column, determinant):
    """Reflect, at all angles at once, the first row and the rows from `rest` on so that `column` stays
    in the first only; what it holds elsewhere means nothing afterwards."""
    head = carray(_room(24), 24)
    factor = carray(_room(24), 24)
    for k in range(24):
        square = M[first, column, k] * M[first, column, k]
        for i in range(rest, 6):
            square += M[i, column, k] * M[i, column, k]
        length = math.copysign(math.sqrt(square), M[first, column, k])
        head[k] = M[first, column, k] + length
        factor[k] = 1.0 / (length * head[k] + 1e-300)
        determinant[k] *= -length
        M[first, column, k] = -length
    for j in range(column + 1, columns):
        for k in range(24):
            total = head[k] * M[first, j, k]
            for i in range(rest, 6):
                total += M[i, column, k] * M[i, j, k]
            total *= factor[k]
            M[first, j, k] -= head[k] * total
            for i in range(rest, 6):
                M[i, j, k] -= M[i, column, k] * total


@_apart("float64[:, :, ::1](float64[:, ::1], float64[::1], float64[::1], float64[::1])")
def _xarm6_fold(E, c, s, determinant):
    """The determinant at 24 hidden angles; returns the upper triangular matrices whose null vectors are
    (x3, 1) x (x2^2, x2, 1). With A2, A1, A0 the blocks of x3^2, x3, 1 the matrix is
    [A2 A1 A0 0; 0 A2 A1 A0]; reflections fold it to 9x9 and to 6x6.

    Each reflection stands by itself: where its rows are known the loops over angles become vectors.
    """
    M, W, factor = np.empty((6, 9, 24)), np.zeros((6, 9, 24)), np.empty((6, 6, 24))
    for r in range(6):
        for j in range(9):
            at = 3 * (j % 3) + j // 3
            one, cosine, sine = E[r, at], E[r, 9 + at], E[r, 18 + at]
            for k in range(24):
                M[r, j, k] = one + cosine * c[k] + sine * s[k]
    for k in range(24):
        determinant[k] = 1.0
    _xarm6_reflect_all(M, 9, 0, 1, 0, determinant)
    _xarm6_reflect_all(M, 9, 1, 2, 1, determinant)
    _xarm6_reflect_all(M, 9, 2, 3, 2, determinant)
    # now M is [R B1 B0; 0 D1 D0]; the other shift has R B1 B0 under D1 D0 0
    for r in range(3):
        for j in range(9):
            for k in range(24):
                W[r, j, k] = M[r, j, k]
        for j in range(6):
            for k in range(24):
                W[3 + r, j, k] = factor[3 + r, j, k] = M[3 + r, 3 + j, k]
    _xarm6_reflect_all(W, 9, 0, 3, 0, determinant)
    _xarm6_reflect_all(W, 9, 1, 3, 1, determinant)
    _xarm6_reflect_all(W, 9, 2, 3, 2, determinant)
    for r in range(3):
        for j in range(6):
            for k in range(24):
                factor[r, j, k] = W[3 + r, 3 + j, k]
    _xarm6_reflect_all(factor, 6, 0, 1, 0, determinant)
    _xarm6_reflect_all(factor, 6, 1, 2, 1, determinant)
    _xarm6_reflect_all(factor, 6, 2, 3, 2, determinant)
    _xarm6_reflect_all(factor, 6, 3, 4, 3, determinant)
    _xarm6_reflect_all(factor, 6, 4, 5, 4, determinant)
    for k in range(24):
        determinant[k] *= factor[5, 5, k]
    return factor


@_inner
def _xarm6_independence(E, c, s):
    """How far the columns that are cleared first are from depending on each other: the square of the
    least singular value of A2 over that of the norm of [A2 A1 A0], or a third of it, as det and minors
    of A2' A2 say. Where x3 is nearly infinite they do depend on each other if the matrix is singular,
    and the factor does not show it."""
    A, G, squares = np.empty((6, 3)), np.zeros((3, 3)), 0.0
    for r in range(6):
        for k in range(9):
            x = E[r, k] + E[r, 9 + k] * c + E[r, 18 + k] * s
            squares += x * x
            if k % 3 == 0:
                A[r, k // 3] = x
    for r in range(6):
        for i in range(3):
            for j in range(3):
                G[i, j] += A[r, i] * A[r, j]
    first = G[1, 1] * G[2, 2] - G[1, 2] * G[1, 2]
    minors = first + G[0, 0] * G[2, 2] - G[0, 2] * G[0, 2] + G[0, 0] * G[1, 1] - G[0, 1] * G[0, 1]
    det = G[0, 0] * first - G[0, 1] * (G[0, 1] * G[2, 2] - G[1, 2] * G[0, 2])
    det += G[0, 2] * (G[0, 1] * G[1, 2] - G[1, 1] * G[0, 2])
    return det / (minors * squares + 1e-300)


@_inner
def _xarm6_at(f, x):
    """f, f', f'' at an angle; f holds a_0 ... a_8, b_1 ... b_8."""
    value, slope, bend = f[0], 0.0, 0.0
    cosine, sine = math.cos(x), math.sin(x)
    c, s = cosine, sine
    for m in range(1, 9):
        even, odd = f[m] * c + f[8 + m] * s, f[8 + m] * c - f[m] * s
        value += even
        slope += m * odd
        bend -= m * m * even
        c, s = c * cosine - s * sine, s * cosine + c * sine
    return value, slope, bend


@_inner
def _xarm6_fit(samples):
    """The coefficients from 24 samples, the largest sample, and the harmonics beyond the eighth."""
    h = np.zeros(24)
    scale = 0.0
    for k in range(24):
        scale = max(scale, abs(samples[k]))
        for j in range(24):
            h[j] += samples[k] * _XARM6_HARMONICS[k, j]
    beyond = 0.0
    for j in range(17, 24):
        beyond = max(beyond, abs(h[j]))
    return h, scale, beyond / scale if scale > 0.0 else 1.0


@_inner
def _xarm6_grid(f):
    """f, f', f'', a row each, at the edges of the cells; the first edge stands at the end again."""
    grid = np.empty((3, 257))
    value, slope, bend = grid
    for i in range(128):
        even = uneven = even_slope = uneven_slope = even_bend = uneven_bend = 0.0
        for m in range(1, 9):
            c, s = _XARM6_GRID_C[m - 1, i], _XARM6_GRID_S[m - 1, i]
            along, across = f[m] * c + f[8 + m] * s, f[8 + m] * c - f[m] * s
            if m % 2 == 0:
                even, even_slope = even + along, even_slope + m * across
                even_bend -= m * m * along
            else:
                uneven, uneven_slope = uneven + along, uneven_slope + m * across
                uneven_bend -= m * m * along
        # even multiples are the same half a turn on, odd ones the opposite
        opposite = i + 128
        value[i], value[opposite] = f[0] + even + uneven, f[0] + even - uneven
        slope[i], slope[opposite] = even_slope + uneven_slope, even_slope - uneven_slope
        bend[i], bend[opposite] = even_bend + uneven_bend, even_bend - uneven_bend
    for k in range(3):
        grid[k, 256] = grid[k, 0]
    return grid


@_inner
def _xarm6_rootless(grid, zero):
    """In which cells f has no root, as `_xarm6_kind` tells it one by one: most of them."""
    value, slope, bend = grid
    h, square = 0.02454369260617026 / 5.0, 0.02454369260617026 * 0.02454369260617026 / 20.0
    rootless = np.empty(256)  # truth values of another width would end the vectors
    for i in range(256):
        b0, b5 = value[i], value[i + 1]
        b1, b4 = b0 + h * slope[i], b5 - h * slope[i + 1]
        b2 = b0 + 2.0 * h * slope[i] + square * bend[i]
        b3 = b5 - 2.0 * h * slope[i + 1] + square * bend[i + 1]
        above = (b0 > zero) & (b1 > zero) & (b2 > zero) & (b3 > zero) & (b4 > zero) & (b5 > zero)
        below = (b0 < -zero) & (b1 < -zero) & (b2 < -zero) & (b3 < -zero) & (b4 < -zero) & (b5 < -zero)
        rootless[i] = 1.0 if above | below else 0.0
    return rootless


@_inner
def _xarm6_kind(low, high, h, scale, rounding, touching):
    """0: no root between two angles; 1: nothing but rounding; 2: one extremum at most; 3: none of
    these. The Bernstein coefficients of the quintic through f, f', f'' at both ends and their
    differences bound f, f' and f''."""
    part = h / 0.02454369260617026
    doubt = rounding + scale * 2e-09 * part**6
    b0, b5 = low[0], high[0]
    b1 = b0 + h * low[1] / 5.0
    b2 = b0 + 2.0 * h * low[1] / 5.0 + h * h * low[2] / 20.0
    b3 = b5 - 2.0 * h * high[1] / 5.0 + h * h * high[2] / 20.0
    b4 = b5 - h * high[1] / 5.0
    least, most = min(b0, b1, b2, b3, b4, b5), max(b0, b1, b2, b3, b4, b5)
    zero = max(doubt, touching)
    if least > zero or most < -zero:
        return 0
    if least >= -rounding and most <= rounding:
        return 1
    d0, d1, d2, d3, d4 = b1 - b0, b2 - b1, b3 - b2, b4 - b3, b5 - b4
    if min(d0, d1, d2, d3, d4) > doubt * part or max(d0, d1, d2, d3, d4) < -doubt * part:
        return 2
    e0, e1, e2, e3 = d1 - d0, d2 - d1, d3 - d2, d4 - d3
    bound = doubt * part * part
    return 2 if min(e0, e1, e2, e3) > bound or max(e0, e1, e2, e3) < -bound else 3


@_apart("float64(float64[::1], int64, float64, float64, boolean)")
def _xarm6_between(f, order, low, high, rising):
    """Where f (order 0) or f' (order 1) vanishes between two angles at which it has unlike signs:
    Newton, with bisection where it leaves. `rising` says that it is negative at the lower one."""
    x = 0.5 * (low + high)
    for _ in range(48):
        at = _xarm6_at(f, x)
        value, slope = (at[1], at[2]) if order else (at[0], at[1])
        if (value < 0.0) == rising:
            low = x
        else:
            high = x
        step = -value / slope if slope != 0.0 else high - low
        if not low < x + step < high:
            step = 0.5 * (low + high) - x
        x += step
        if abs(step) < 1e-09:
            break  # what follows is rounding
    return x


@_inner
def _xarm6_few(f, rounding, touching, near, low, at_low, high, at_high, roots, counts):
    """The roots of a cell where f has one extremum at most, into roots[0] (simple) or [1] (double), or
    [2] where f turns back beside zero: no root, unless rounding of what f is made of lifted it off."""
    middle, at_middle = high, at_high[0]
    if at_low[1] * at_high[1] < 0.0:
        middle = _xarm6_between(f, 1, low, high, at_low[1] < 0.0)
        at_middle, _, bend = _xarm6_at(f, middle)
        lifted = at_middle * bend > 0.0 and abs(at_middle) <= max(abs(bend) * near, touching)
        if abs(at_middle) <= rounding or lifted:
            _xarm6_add_root(roots, counts, 1 if abs(at_middle) <= rounding else 2, middle)
            return
        if (at_middle < 0.0) != (at_high[0] < 0.0):
            x = _xarm6_between(f, 0, middle, high, at_middle < 0.0)
            _xarm6_add_root(roots, counts, 0, x)
    if (at_low[0] < 0.0) != (at_middle < 0.0):
        _xarm6_add_root(roots, counts, 0, _xarm6_between(f, 0, low, middle, at_low[0] < 0.0))


@_apart("void(float64[:, ::1], int64[::1], int64, float64)")
def _xarm6_add_root(roots, counts, kind, x):
    """Add a root; counts[3] says that nothing was given up."""
    if kind:
        for i in range(counts[kind]):
            gap = abs(x - roots[kind, i])
            if min(gap, 6.283185307179586 - gap) < 0.02454369260617026 / 64.0:
                return  # neighbouring cells that were given up together
    if counts[kind] == 24:
        counts[3] = 0
        return
    roots[kind, counts[kind]] = x
    counts[kind] += 1


@_apart("Tuple((float64[:, ::1], int64[::1]))(float64[::1], float64, float64, int64, int64, float64)")
def _xarm6_find_roots(f, scale, rounding, middle, reach, near):
    """The simple roots, roots[0, : counts[0]], the double ones, roots[1, : counts[1]], and the places
    where f turns back beside zero, roots[2, : counts[2]], in so many cells on both sides of the middle
    one. These are where the value of a parabola over its bend is below `near`."""
    roots = np.empty((3, 24))
    counts = np.array([0, 0, 0, 1, 0])
    grid = _xarm6_grid(f)
    touching = rounding + scale * 2e-09  # by this rounding may lift four roots that meet
    rootless = _xarm6_rootless(grid, max(rounding + scale * 2e-09, touching))
    budget = 100  # against an f that is next to nothing for long stretches
    edge = np.empty(16)  # the upper edges still to come
    at, at_low = np.empty((16, 3)), np.empty(3)
    depth = np.zeros(16, dtype=np.int64)
    for i in range(256):
        if rootless[i] != 0.0 or min(abs(i - middle), 256 - abs(i - middle)) > reach:
            continue
        low = i * 0.02454369260617026
        edge[0], depth[0] = (i + 1) * 0.02454369260617026, 0
        for k in range(3):
            at_low[k], at[0, k] = grid[k, i], grid[k, i + 1]
        waiting = 1
        while waiting > 0:
            top = waiting - 1
            h = edge[top] - low
            kind = _xarm6_kind(at_low, at[top], h, scale, rounding, touching)
            if kind == 2:
                _xarm6_few(
                    f, rounding, touching, near, low, at_low, edge[top], at[top], roots, counts
                )
            elif kind == 1 or (kind == 3 and (depth[top] == 14 or budget == 0)):
                counts[3] = 0
                _xarm6_add_root(roots, counts, 1, low + 0.5 * h)
            elif kind == 3:
                budget -= 1
                edge[waiting] = low + 0.5 * h
                depth[top] += 1
                depth[waiting] = depth[top]
                at[waiting, 0], at[waiting, 1], at[waiting, 2] = _xarm6_at(f, edge[waiting])
                waiting += 1
                continue
            low = edge[top]
            for k in range(3):
                at_low[k] = at[top, k]
            waiting -= 1
    return roots, counts


# A lens on the circle: e^(i phi) = (w + a) / (1 + conj(a) w) with a = x + i y inside the circle maps the
# circle of w = e^(i psi) to itself and shows what lies around the direction of a larger. Where all roots
# lie together, as near the boundary of reach, f drowns in rounding without it.


@_inner
def _xarm6_through(x, y, c, s):
    """Cosine and sine of phi from those of psi, and |1 + conj(a) w|^16, which makes of f a polynomial
    in psi."""
    u, v, d, e = c + x, s + y, 1.0 + x * c + y * s, x * s - y * c
    square = d * d + e * e
    return (u * d + v * e) / square, (v * d - u * e) / square, square**8


@_inner
def _xarm6_spread(samples):
    """The lens under which the roots are spread, from samples without one; 0, 0 when they are already.
    log |f| is a sum over the roots z, and the first harmonic of log |e^(i phi) - z| is -z for z inside
    the circle, that of its mirror image for z outside."""
    x = y = 0.0
    for k in range(12):
        ratio = math.log((abs(samples[k]) + 1e-300) / (abs(samples[k + 12]) + 1e-300))
        x += ratio * _XARM6_SAMPLE_C[k]
        y += ratio * _XARM6_SAMPLE_S[k]
    x, y = -0.005208333333333333 * x, -0.005208333333333333 * y
    square = x * x + y * y
    if not square > 0.12249999999999998:
        return 0.0, 0.0
    part = min(1.0, 0.9 / math.sqrt(square))
    return part * x, part * y


@_inner
def _xarm6_behind(x, y, roots, counts):
    """The roots as they are without the lens."""
    for kind in range(3):
        for i in range(counts[kind]):
            c, s, _ = _xarm6_through(x, y, math.cos(roots[kind, i]), math.sin(roots[kind, i]))
            roots[kind, i] = math.atan2(s, c)


@_inner
def _xarm6_seen(samples, x, y, middle, reach, near):
    """The roots that samples through a lens show: (the noise of the samples, the roots, their
    counts)."""""
    f, scale, noise = _xarm6_fit(samples)
    rounding = scale * (3e-15 + 64.0 * noise)
    roots, counts = _xarm6_find_roots(f, scale, rounding, middle, reach, near)
    _xarm6_behind(x, y, roots, counts)
    return noise, roots, counts


@_inner
def _xarm6_near(x, middle):
    """Whether an angle is as near to another as a closer look reaches."""
    return math.cos(x - middle) >= 0.9980487804878049


@_apart("void(float64[:, ::1], int64[::1], float64[:, ::1], int64[::1], float64)")
def _xarm6_replace(roots, counts, closer, closer_counts, middle):
    """Of the roots those near to an angle are replaced by what a closer look shows there."""
    for twice in range(2):
        kept = 0
        for i in range(counts[twice]):
            if not _xarm6_near(roots[twice, i], middle):
                roots[twice, kept] = roots[twice, i]
                kept += 1
        for i in range(closer_counts[twice]):
            if _xarm6_near(closer[twice, i], middle) and kept < 24:
                roots[twice, kept] = closer[twice, i]
                kept += 1
        counts[twice] = kept


@_inner
def _xarm6_any_near(roots, counts, middle):
    """Whether any root is near to an angle."""
    near = False
    for twice in range(2):
        for i in range(counts[twice]):
            near = near or _xarm6_near(roots[twice, i], middle)
    return near


@_inner
def _xarm6_next_double(roots, counts, seen, looks):
    """The first double root that nothing has looked at more closely; their count if there is none."""
    for i in range(counts[1]):
        near = False
        for k in range(looks):
            near = near or _xarm6_near(roots[1, i], seen[k])
        if not near:
            return i
    return counts[1]


@_inner
def _xarm6_inverse_iteration(U, inverse, x):
    """x = U^-1 U^-T x, to length one; `inverse` holds the reciprocals of the diagonal. Returns what was
    its length: the reciprocal of the square of the smallest singular value, in the end."""
    for i in range(6):
        for j in range(i):
            x[i] -= U[j, i] * x[j]
        x[i] *= inverse[i]
    square = 0.0
    for i in range(5, -1, -1):
        for j in range(i + 1, 6):
            x[i] -= U[i, j] * x[j]
        x[i] *= inverse[i]
        square += x[i] * x[i]
    length = math.sqrt(square) + 1e-300
    for i in range(6):
        x[i] *= 1.0 / length
    return length


@_apart("int64(float64[:, ::1], int64, float64[:, ::1], int64)")
def _xarm6_split(n, shift, out, count):
    """Vectors w of the plane with up w = x down w for some x (least squares): their sums of the two
    null vectors n go to `out`. The shift, by 3 for x3 or by 1 for x2, takes `down` to `up`."""
    A, G, H = np.zeros((2, 2)), np.zeros((2, 2)), np.zeros((2, 2))
    for i in range(2):
        for j in range(2):
            for k in range(3 if shift == 3 else 4):
                up = k if shift == 3 else k + k // 2
                A[i, j] += n[i, up + shift] * n[j, up]
                G[i, j] += n[i, up + shift] * n[j, up + shift]
                H[i, j] += n[i, up] * n[j, up]
    det = G[0, 0] * G[1, 1] - G[0, 1] * G[0, 1]
    det_h = H[0, 0] * H[1, 1] - H[0, 1] * H[0, 1]
    if det < det_h:  # 1/x is the better unknown
        A[0, 1], A[1, 0] = A[1, 0], A[0, 1]
        G, det = H, det_h
    if det < 1e-24:
        return count
    a = (G[1, 1] * A[0, 0] - G[0, 1] * A[1, 0]) / det
    b = (G[1, 1] * A[0, 1] - G[0, 1] * A[1, 1]) / det
    c = (G[0, 0] * A[1, 0] - G[0, 1] * A[0, 0]) / det
    d = (G[0, 0] * A[1, 1] - G[0, 1] * A[0, 1]) / det
    spread = math.sqrt(max(0.25 * (a - d) * (a - d) + b * c, 0.0))
    for sign in (-1.0, 1.0):
        # (M - x) w = 0 from the longer of its rows
        x = 0.5 * (a + d) + sign * spread
        upper = abs(a - x) + abs(b) > abs(d - x) + abs(c)
        w0, w1 = (b, x - a) if upper else (d - x, -c)
        for i in range(6):
            out[count, i] = w0 * n[0, i] + w1 * n[1, i]
        count += 1
    return count


@_apart("Tuple((int64, boolean))(float64[:, :, ::1], int64, boolean, float64[:, ::1])")
def _xarm6_null_vectors(factors, at, double, out):
    """Vectors near (x3, 1) x (x2^2, x2, 1): one of a simple root, and of a double one also those at
    which one of the two shifts, x3 or x2, has an eigenvalue. Into out; returns how many, and whether
    the matrix is regular: then there is no root. It has no singular value that is next to nothing,
    and not two small ones, as where so many roots crowd that the determinant does not tell. The
    matrix is one of those of `_xarm6_fold`."""
    factor, inverse = carray(_room(36), (6, 6)), carray(_room(6), 6)
    n = _XARM6_START.copy()
    length = second = squares = 0.0
    for i in range(6):
        for j in range(i, 6):
            factor[i, j] = factors[i, j, at]
            squares += factor[i, j] * factor[i, j]
    most = 0.0
    for i in range(6):
        most = max(most, abs(factor[i, i]))
    least = most * 1e-15 + 1e-300
    for i in range(6):  # kept finite where the diagonal is next to nothing
        d = factor[i, i]
        inverse[i] = 1.0 / (d if abs(d) > least else math.copysign(least, d))
    for _ in range(4 if double else 2):
        length = _xarm6_inverse_iteration(factor, inverse, n[0])
        if double:
            second = _xarm6_inverse_iteration(factor, inverse, n[1])
            along = 0.0
            for i in range(6):
                along += n[0, i] * n[1, i]
            for i in range(6):
                n[1, i] -= along * n[0, i]
    for i in range(6):
        out[0, i] = n[0, i]
    regular = length * squares < 25000000000000.004 and second * squares < 1000000000000.0
    if not double:
        return 1, regular
    square = 0.0
    for i in range(6):
        square += n[1, i] * n[1, i]
    for i in range(6):
        n[1, i] /= math.sqrt(square) + 1e-300
    count = 1
    for shift in (3, 1):
        count = _xarm6_split(n, shift, out, count)
    return count, regular


@_inner
def _xarm6_middle(K, M, value):
    """c and s of phi5 from invariants of B = Rz K Rz(phi5) M Rz, `value` = l_z, p_z, p.l, p.p / 2 and
    (p x l)_z, by least squares."""
    t0, t1, t2 = K[3], K[7], K[11]
    e0, e1, e2, u0, u1, u2 = M[2], M[6], M[10], M[3], M[7], M[11]
    axis = (K[8], K[9], K[10])
    foot = (
        K[0] * t0 + K[4] * t1 + K[8] * t2,
        K[1] * t0 + K[5] * t1 + K[9] * t2,
        K[2] * t0 + K[6] * t1 + K[10] * t2,
    )
    side = (K[4] * t0 - K[0] * t1, K[5] * t0 - K[1] * t1, K[6] * t0 - K[2] * t1)
    e, u = (e0, e1, e2), (u0, u1, u2)
    v = (u1 * e2 - u2 * e1, u2 * e0 - u0 * e2, u0 * e1 - u1 * e0)
    pairs = ((axis, e), (axis, u), (foot, e), (foot, u), (axis, v))
    rest = (
        0.0,
        t2,
        u0 * e0 + u1 * e1 + u2 * e2,
        0.5 * (t0 * t0 + t1 * t1 + t2 * t2 + u0 * u0 + u1 * u1 + u2 * u2),
        side[2] * e2,
    )
    aa = ab = bb = ar = br = 0.0
    for i in range(5):
        left, right = pairs[i]
        a = left[0] * right[0] + left[1] * right[1]
        b = left[1] * right[0] - left[0] * right[1]
        r = value[i] - rest[i] - left[2] * right[2]
        if i == 4:
            a += side[0] * e0 + side[1] * e1
            b += side[1] * e0 - side[0] * e1
        aa += a * a
        ab += a * b
        bb += b * b
        ar += a * r
        br += b * r
    return _xarm6_unit(bb * ar - ab * br, aa * br - ab * ar)


@_apart("void(int64[::1], float64[:, ::1], float64[::1], float64[::1], float64[::1])")
def _xarm6_angles(joints, links, n, c, s):
    """The cosines and sines of phi_2 ... phi_6 from phi_1 and a null vector, in place; the length of a
    slide stands in the sine's place."""
    up = n[0] * n[0] + n[1] * n[1] + n[2] * n[2]
    down = n[3] * n[3] + n[4] * n[4] + n[5] * n[5]
    row = n[:3] if up > down else n[3:]
    sign = math.copysign(1.0, row[0] + row[2])
    c[1], s[1] = _xarm6_unit(sign * (row[2] - row[0]), sign * 2.0 * row[1])
    top = n[0] * row[0] + n[1] * row[1] + n[2] * row[2]
    bottom = n[3] * row[0] + n[4] * row[1] + n[5] * row[2]
    c[2], s[2] = _xarm6_unit(bottom * bottom - top * top, 2.0 * top * bottom)
    G = carray(_room(12), 12)
    _take(G, links[5])
    for i in range(3):
        _xarm6_move(G, joints[i], c[i], s[i])
        _xarm6_follow(G, links[i])
    B = _xarm6_invert(G)
    l0, l1, q0, q1 = B[2], B[6], B[3], B[7]
    square = G[3] * G[3] + G[7] * G[7] + G[11] * G[11]
    value = (B[10], B[11], -G[11], 0.5 * square, q0 * l1 - q1 * l0)
    c[4], s[4] = _xarm6_middle(links[3], links[4], value)
    C = carray(_room(12), 12)
    _take(C, links[3])
    _xarm6_turn(C, c[4], s[4])
    _xarm6_follow(C, links[4])
    c[3], s[3] = _xarm6_unit(
        C[2] * l0 + C[6] * l1 + C[3] * q0 + C[7] * q1, C[2] * l1 - C[6] * l0 + C[3] * q1 - C[7] * q0
    )
    cosine = sine = 0.0
    for i in range(2):
        for j in range(2):
            # columns of Rz(phi_4) C against columns of B
            x, y = c[3] * C[j] - s[3] * C[4 + j], s[3] * C[j] + c[3] * C[4 + j]
            along = x * B[i] + y * B[4 + i] + C[8 + j] * B[8 + i]
            if i == j:
                cosine += along
            else:
                sine += -along if i else along
    c[5], s[5] = _xarm6_unit(cosine, sine)


@_inner
def _xarm6_marked(marks):
    """How many marks of the first kind are set."""
    count = 0
    for mark in marks:
        count += mark & 1
    return count


@_inner
def _xarm6_error(links, c, s, J):
    """The square of the loop's error; J takes the Jacobian with the error, translation and rotation
    vector, as seventh column."""
    P = links[5]
    T = carray(_room(12), 12)
    T[:] = 0.0
    T[0] = T[5] = T[10] = 1.0
    for k in range(6):
        if k:
            _xarm6_follow(T, links[k - 1])
        for i in range(3):
            J[3 + i, k] = T[4 * i + 2]
            J[i, k] = T[4 * i + 3]
        _xarm6_move(T, k, c[k], s[k])
    for k in range(6):
        z0, z1, z2 = J[3, k], J[4, k], J[5, k]
        r0, r1, r2 = T[3] - J[0, k], T[7] - J[1, k], T[11] - J[2, k]
        J[0, k], J[1, k], J[2, k] = z1 * r2 - z2 * r1, z2 * r0 - z0 * r2, z0 * r1 - z1 * r0
    S = carray(_room(9), (3, 3))
    for i in range(3):
        for j in range(3):
            S[i, j] = P[4 * i] * T[4 * j] + P[4 * i + 1] * T[4 * j + 1] + P[4 * i + 2] * T[4 * j + 2]
        J[i, 6] = P[4 * i + 3] - T[4 * i + 3]
    J[3, 6] = 0.5 * (S[2, 1] - S[1, 2])
    J[4, 6] = 0.5 * (S[0, 2] - S[2, 0])
    J[5, 6] = 0.5 * (S[1, 0] - S[0, 1])
    square = 0.0
    for i in range(6):
        square += J[i, 6] * J[i, 6]
    # half a turn away the skew part vanishes too: the trace tells
    return square + 1.0 if S[0, 0] + S[1, 1] + S[2, 2] < 0.0 else square


@_inner
def _xarm6_step(J, x):
    """A step of Newton: the least-squares solution of J x = error by reflections. Where a diagonal is
    next to nothing the step stays zero instead of leaping. Returns the smallest diagonal over the
    largest."""
    for column in range(5):
        _xarm6_reflect(J, column, column + 1, column)
    most = least = abs(J[0, 0])
    for i in range(1, 6):
        most, least = max(most, abs(J[i, i])), min(least, abs(J[i, i]))
    for i in range(5, -1, -1):
        total = J[i, 6]
        for j in range(i + 1, 6):
            total -= J[i, j] * x[j]
        x[i] = 0.0
        if abs(J[i, i]) > most * 1e-09:
            x[i] = max(min(total / J[i, i], 1.0), -1.0)
    return least / most if most > 0.0 else 0.0


@_inner
def _xarm6_damped_step(J, damping, x):
    """The same damped, for starts far away and for singular solutions: (J' J + d) x = J' error."""
    A = carray(_room(42), (6, 7))
    for i in range(6):
        for j in range(i, 7):
            total = 0.0
            for k in range(6):
                total += J[k, i] * J[k, j]
            A[i, j] = total
        A[i, i] += damping + 1e-30
    for i in range(6):
        for j in range(i + 1, 6):
            factor = A[i, j] / A[i, i]
            for k in range(j, 7):
                A[j, k] -= factor * A[i, k]
    for i in range(5, -1, -1):
        total = A[i, 6]
        for j in range(i + 1, 6):
            total -= A[i, j] * x[j]
        x[i] = max(min(total / A[i, i], 1.0), -1.0)


@_inner
def _xarm6_polish(links, c, s, afar):
    """Newton on the loop; what remains in c and s is the best iterate, and its error is returned."""
    J, x = carray(_room(42), (6, 7)), carray(_room(6), 6)
    tc, ts = carray(_room(6), 6), carray(_room(6), 6)
    _take(tc, c)
    _take(ts, s)
    least = now = _xarm6_error(links, c, s, J)
    for _ in range(40 if afar else 4):
        if least < 1e-29:
            break
        if afar:
            _xarm6_damped_step(J, 0.01 * min(now, 1.0), x)
        else:
            _xarm6_step(J, x)
        for i in range(6):
            # a turn by 2 atan(x/2), without trigonometry
            u = 0.25 * x[i] * x[i]
            dc, ds = (1.0 - u) / (1.0 + u), x[i] / (1.0 + u)
            tc[i], ts[i] = tc[i] * dc - ts[i] * ds, ts[i] * dc + tc[i] * ds
        now = _xarm6_error(links, tc, ts, J)
        if now < least:
            least = now
            for i in range(6):
                c[i], s[i] = tc[i], ts[i]
    return math.sqrt(least)


@_inner
def _xarm6_gap(a, b):
    """The largest difference of two joint vectors, modulo turns."""
    most = 0.0
    for i in range(6):
        gap = abs(a[i] - b[i])
        most = max(most, min(gap, 6.283185307179586 - gap))
    return most


@_inner
def _xarm6_rank(q, singular, count):
    """What comes first where there are more than there are rows, in the place of the marks: 0 for
    regular solutions, 1 for singular ones or nearly so, 2 for those that lie together with one of these
    and may be the same, which only its last digits tell."""
    for i in range(count):
        singular[i] = 1 if singular[i] else 0
        for j in range(i):
            if singular[i] == 1 and singular[j] == 1 and _xarm6_gap(q[i], q[j]) < 0.001:
                singular[i] = 2


@_inner
def _xarm6_begun(q, c, s):
    """The cosines and sines in the loop of joint values; a length stands in the sine's place."""
    for i in range(6):
        cosine, sine = math.cos(q[i]), math.sin(q[i])
        c[i] = cosine * _XARM6_ADVANCE_C[i] + sine * _XARM6_ADVANCE_S[i]
        s[i] = sine * _XARM6_ADVANCE_C[i] - cosine * _XARM6_ADVANCE_S[i]


@_apart("UniTuple(int64, 2)(float64[:, ::1], float64[::1], float64[::1], boolean, boolean, float64[:, ::1], float64[::1], int64[::1], int64)")
def _xarm6_offer(links, c, s, afar, doubtful, q, residual, singular, count):
    """Polish a candidate and keep it unless it is known or none: (its place or -1, the count). Where
    one is singular many come near to it: there is room for more than there are solutions, the last of
    it for regular ones."""
    missing = _xarm6_polish(links, c, s, afar)
    if not missing <= 1e-10:
        return -1, count
    theta = carray(_room(6), 6)
    for i in range(6):
        cosine, sine = _XARM6_ADVANCE_C[i], _XARM6_ADVANCE_S[i]
        theta[i] = math.atan2(s[i] * cosine + c[i] * sine, c[i] * cosine - s[i] * sine)
        # half a turn is +pi, also when rounding says otherwise
        if theta[i] < -3.141592653589783:
            theta[i] = 3.141592653589793
    place = count
    for k in range(count):
        if _xarm6_gap(q[k], theta) < 1e-06:
            place = k
            break
    marked = nearly = 0
    if doubtful:
        J, x = carray(_room(42), (6, 7)), carray(_room(6), 6)
        _xarm6_error(links, c, s, J)
        pivot = _xarm6_step(J, x)
        marked = 1 if pivot < 1e-06 else 0
        nearly = 1 if pivot < 0.0001 else 0
    if place == count and count >= 64 - nearly * 16:
        return -1, count
    if place == count:
        count += 1
        singular[place] = 0
        residual[place] = math.inf
    if missing < residual[place]:
        residual[place] = missing
        for i in range(6):
            q[place, i] = theta[i]
    singular[place] |= marked | nearly << 1
    return place, count


# The offset wrist: axes 1 and 2 meet at right angles in S, 2 and 3 are parallel, 4 and 5 meet at right
# angles in W, axis 4 lies in the plane through S across axis 2. With q6 given, W and z5 are known, and
# S, the elbow E and W form a triangle; axis 4 has to be at right angles to z5.

# what the turns of joints 1 ... 4 bring into line with axis 3, E, W and z5
_XARM6_SOURCES = np.array([0.0, 1.0, 0.7851450463681914, 0.1476459050288163, -0.945209765838684, 0.21387958205108903, 0.0, 1.0])


@_inner
def _xarm6_setting(which, loop):
    """The loop, and what goes from frame 6 to frame 5."""
    return loop, _xarm6_invert(loop[4])


@_inner
def _xarm6_wrist_at(setting, c, s, frame):
    """What a sixth angle fixes: W from S, the square of its length, and the discriminant of the
    elbow; frame takes frame 5 before its own turn."""
    loop, back = setting
    _take(frame, loop[5])
    _xarm6_turn(frame, c, -s)
    _xarm6_follow(frame, back)
    x = frame[3] + -0.0 * frame[2]
    y = frame[7] + -0.0 * frame[6]
    z = frame[11] + -0.0 * frame[10] - (7.368497484792287e-10)
    w = x * x + y * y + z * z
    twice = w + 0.6382520571082876 - 0.9391659770551684
    return x, y, z, w, 4.0 * 0.6382520571082876 * w - twice * twice


@_inner
def _xarm6_closed_polynomial(setting, c, s):
    """The polynomial of q6: of degree 8."""
    frame = carray(_room(12), 12)
    x, y, z, w, D = _xarm6_wrist_at(setting, c, s, frame)
    along = x * frame[2] + y * frame[6] + z * frame[10]
    m = frame[10] * w - z * along
    part = w - 0.6382520571082876 + 0.9391659770551684
    first, second = along * along * (x * x + y * y), m * m
    C, S = -0.9753422209915128, -0.22069787482289702
    U = first * (C * C * part * part + S * S * D) - second * (S * S * part * part + C * C * D)
    V = 2.0 * C * S * part * (first + second)
    return (U * U - V * V * D) / (w * w + 1e-300)


@_inner
def _xarm6_way_joints(setting, way, cosine_6, sine_6, c, s):
    """The cosines and sines of all joints from those of q6; a way is a sign of the plane and of the
    elbow.

    Returns 1 where axis 4 is nearly at right angles to z5, 0 elsewhere.
    """
    loop = setting[0]
    tau, elbow = 1.0 if way % 2 else -1.0, 1.0 if way > 1 else -1.0
    c[5], s[5] = cosine_6, sine_6
    frame = carray(_room(12), 12)
    wx, wy, wz, w, D = _xarm6_wrist_at(setting, cosine_6, sine_6, frame)
    rho = math.sqrt(wx * wx + wy * wy)
    if rho < 1e-12:
        return 0
    W, z5 = (wx, wy, wz), (frame[2], frame[6], frame[10])
    x0, x1 = tau * wx / rho, tau * wy / rho
    up = (-wz * x0, -wz * x1, tau * rho)  # W turned about axis 3
    part = 0.5 * (w - 0.6382520571082876 + 0.9391659770551684) / w
    side = 0.5 * elbow * math.sqrt(max(D, 0.0)) / w
    target = carray(_room(12), (4, 3))
    target[0, 2] = 0.0
    target[0, 0], target[0, 1] = 1.0 * x1, 1.0 * -x0
    slant = 0.0
    for i in range(3):
        reach, turned = part * W[i] - side * up[i], part * up[i] + side * W[i]
        slant += (-0.9753422209915128 * reach + -0.22069787482289702 * turned) * z5[i]
        target[2, i] = W[i] + (7.368497484792287e-10 if i == 2 else 0.0)
        target[1, i] = target[2, i] - reach
        target[3, i] = z5[i]
    if not abs(slant) < 0.9691057615426545 * 0.01:
        return 0
    T = carray(_room(12), 12)
    T[:] = 0.0
    T[0] = T[5] = T[10] = 1.0
    local = carray(_room(2), 2)
    for k in range(4):
        for j in range(2):
            local[j] = 0.0
            for i in range(3):
                v = target[k, i] - T[4 * i + 3] if k in (1, 2) else target[k, i]
                local[j] += T[4 * i + j] * v
        a, b = _XARM6_SOURCES[2 * k], _XARM6_SOURCES[2 * k + 1]
        c[k], s[k] = _xarm6_unit(a * local[0] + b * local[1], a * local[1] - b * local[0])
        _xarm6_turn(T, c[k], s[k])
        _xarm6_follow(T, loop[k])
    cosine = sine = 0.0
    for i in range(3):
        cosine += T[4 * i] * frame[4 * i] + T[4 * i + 1] * frame[4 * i + 1]
        sine += T[4 * i + 1] * frame[4 * i] - T[4 * i] * frame[4 * i + 1]
    c[4], s[4] = _xarm6_unit(cosine, sine)
    return 1


@_inner
def _xarm6_sample_closed(setting, x, y, samples):
    """The polynomial at the sample angles, through a lens."""
    for k in range(24):
        c, s, weight = _xarm6_through(x, y, _XARM6_SAMPLE_C[k], _XARM6_SAMPLE_S[k])
        samples[k] = weight * _xarm6_closed_polynomial(setting, c, s)


@_inner
def _xarm6_keep_vanishing_closed(setting, angles, count):
    """Of angles those where the polynomial may vanish: it is known itself, and nothing tells more."""
    return count


@_inner
def _xarm6_take_lifted_closed(of, roots, counts):
    """The places where f turns back beside zero are double roots where there may be any."""
    for i in range(_xarm6_keep_vanishing_closed(of, roots[2], counts[2])):
        _xarm6_add_root(roots, counts, 1, roots[2, i])


@_inner
def _xarm6_real_roots_closed(of):
    """All real roots: (whether the polynomial does not vanish identically, roots, counts).

    Where roots may be double they are replaced by what a closer look shows, if it shows all: values
    that are computed there have the digits that the fit of f lacks. What was given up stands among
    them. Behind them stand, as many as the last of the counts, places where that shows no root: the
    values lack the digits that the equations behind f lack.
    """
    samples = np.empty(24)
    _xarm6_sample_closed(of, 0.0, 0.0, samples)
    largest = np.abs(samples).max()  # rounding of zero may be as smooth as a polynomial
    x, y = _xarm6_spread(samples)
    if x != 0.0 or y != 0.0:
        _xarm6_sample_closed(of, x, y, samples)
    noise, roots, counts = _xarm6_seen(samples, x, y, 0, 128, 5e-09)
    _xarm6_take_lifted_closed(of, roots, counts)
    good = noise <= 1e-06 and largest > 1e-26
    if not good or max(counts[0], counts[1]) == 24:
        return good, roots, counts
    seen, looks, clear = np.empty(4), 0, True
    unseen, empty = np.empty(4), 0
    i = _xarm6_next_double(roots, counts, seen, looks)
    while i < counts[1] and looks < 4:
        middle = seen[looks] = roots[1, i]
        looks += 1
        x, y = 0.8823529411764706 * math.cos(middle), 0.8823529411764706 * math.sin(middle)
        _xarm6_sample_closed(of, x, y, samples)
        turns = middle / 6.283185307179586
        cell = int(256 * (turns - math.floor(turns))) % 256
        blur, closer, closer_counts = _xarm6_seen(
            samples, x, y, cell, 38, 1.28e-06
        )
        if blur <= 1e-10 and closer_counts[3]:
            _xarm6_take_lifted_closed(of, closer, closer_counts)
            _xarm6_replace(roots, counts, closer, closer_counts, middle)
            if not _xarm6_any_near(roots, counts, middle):
                unseen[empty] = middle
                empty += 1
        else:
            clear = False
        i = _xarm6_next_double(roots, counts, seen, looks)
    empty = _xarm6_keep_vanishing_closed(of, unseen, empty)
    counts[4] = min(empty, 24 - counts[1])
    for k in range(counts[4]):
        roots[1, counts[1] + k] = unseen[k]
    if clear and i == counts[1]:
        counts[3] = 1
    if noise > 1e-10:  # f nearly vanishes identically: it does not tell what there is not
        counts[3] = 0
    return good, roots, counts


@_apart("Tuple((boolean, int64))(int64, float64[:, ::1], float64[:, ::1], float64[::1], int64[::1], int64[::1], int64)")
def _xarm6_attempt_closed(which, loop, q, residual, singular, doubles_met, count):
    """Find what a polynomial in closed form finds: (whether that is certainly everything, the count).

    The certificate is that of the formulations, with 1 solution(s) a root.
    """
    setting = _xarm6_setting(which, loop)
    good, roots, counts = _xarm6_real_roots_closed(setting)
    if not good:
        return False, count
    complete, expected = counts[3] == 1, 0
    doubles_met[0] += counts[1]
    met = np.zeros(64, dtype=np.int64)
    c, s = np.empty(6), np.empty(6)
    for double in range(2):
        for i in range(counts[double]):
            here = np.zeros(64, dtype=np.int64)
            singular_here = False
            cosine, sine = math.cos(roots[double, i]), math.sin(roots[double, i])
            far = 0
            for way in range(4):
                kind = _xarm6_way_joints(setting, way, cosine, sine, c, s)
                far += kind == 2
                if kind != 1:
                    continue
                place, count = _xarm6_offer(
                    loop, c, s, False, counts[1] > 0, q, residual, singular, count
                )
                if place >= 0:
                    here[place] = met[place] = 1
                    singular_here = singular_here or singular[place] & 1 == 1
            if far and not _xarm6_marked(here):
                continue
            complete = complete and _xarm6_marked(here) >= 1
            expected += 2 if double and not singular_here else 1
            expected -= far
    regular = count - _xarm6_marked(singular)
    return complete and _xarm6_marked(met) >= expected and regular % 2 == 0, count


@_inner
def _xarm6_sample(E, x, y, samples):
    """The determinant at the sample angles, through a lens."""
    c = carray(_room(24), 24)
    s = carray(_room(24), 24)
    weight = carray(_room(24), 24)
    for k in range(24):
        c[k], s[k], weight[k] = _xarm6_through(x, y, _XARM6_SAMPLE_C[k], _XARM6_SAMPLE_S[k])
    _xarm6_fold(E, c, s, samples)
    for k in range(24):
        samples[k] *= weight[k]


@_apart("int64(float64[:, ::1], float64[::1], int64)")
def _xarm6_keep_vanishing(E, angles, count):
    """Keeps of angles those where the determinant may vanish, and tells how many they are: where f only
    comes near to zero it does not."""
    if count == 0:
        return 0
    c, s, determinant = np.empty(24), np.empty(24), np.empty(24)
    for k in range(24):
        angle = angles[min(k, count - 1)]
        c[k], s[k] = math.cos(angle), math.sin(angle)
    factors = _xarm6_fold(E, c, s, determinant)
    vectors, kept = np.empty((5, 6)), 0
    for i in range(count):
        _, regular = _xarm6_null_vectors(factors, i, True, vectors)
        if not regular or not _xarm6_independence(E, c[i], s[i]) > 8.999999999999999e-08:
            angles[kept] = angles[i]
            kept += 1
    return kept


@_inner
def _xarm6_take_lifted(of, roots, counts):
    """The places where f turns back beside zero are double roots where there may be any."""
    for i in range(_xarm6_keep_vanishing(of, roots[2], counts[2])):
        _xarm6_add_root(roots, counts, 1, roots[2, i])


@_inner
def _xarm6_real_roots(of):
    """All real roots: (whether the polynomial does not vanish identically, roots, counts).

    Where roots may be double they are replaced by what a closer look shows, if it shows all: values
    that are computed there have the digits that the fit of f lacks. What was given up stands among
    them. Behind them stand, as many as the last of the counts, places where that shows no root: the
    values lack the digits that the equations behind f lack.
    """
    samples = np.empty(24)
    _xarm6_sample(of, 0.0, 0.0, samples)
    largest = np.abs(samples).max()  # rounding of zero may be as smooth as a polynomial
    x, y = _xarm6_spread(samples)
    if x != 0.0 or y != 0.0:
        _xarm6_sample(of, x, y, samples)
    noise, roots, counts = _xarm6_seen(samples, x, y, 0, 128, 5e-09)
    _xarm6_take_lifted(of, roots, counts)
    good = noise <= 1e-06 and largest > 1e-26
    if not good or max(counts[0], counts[1]) == 24:
        return good, roots, counts
    seen, looks, clear = np.empty(4), 0, True
    unseen, empty = np.empty(4), 0
    i = _xarm6_next_double(roots, counts, seen, looks)
    while i < counts[1] and looks < 4:
        middle = seen[looks] = roots[1, i]
        looks += 1
        x, y = 0.8823529411764706 * math.cos(middle), 0.8823529411764706 * math.sin(middle)
        _xarm6_sample(of, x, y, samples)
        turns = middle / 6.283185307179586
        cell = int(256 * (turns - math.floor(turns))) % 256
        blur, closer, closer_counts = _xarm6_seen(
            samples, x, y, cell, 38, 1.28e-06
        )
        if blur <= 1e-10 and closer_counts[3]:
            _xarm6_take_lifted(of, closer, closer_counts)
            _xarm6_replace(roots, counts, closer, closer_counts, middle)
            if not _xarm6_any_near(roots, counts, middle):
                unseen[empty] = middle
                empty += 1
        else:
            clear = False
        i = _xarm6_next_double(roots, counts, seen, looks)
    empty = _xarm6_keep_vanishing(of, unseen, empty)
    counts[4] = min(empty, 24 - counts[1])
    for k in range(counts[4]):
        roots[1, counts[1] + k] = unseen[k]
    if clear and i == counts[1]:
        counts[3] = 1
    if noise > 1e-10:  # f nearly vanishes identically: it does not tell what there is not
        counts[3] = 0
    return good, roots, counts


@_apart("int64(float64[:, ::1], float64, float64[::1], int64)")
def _xarm6_separate(E, angle, angles, total):
    """Two simple roots beside an angle where roots may have met, if there are, go behind the angles:
    the determinant itself has digits there that its fit lacks. Each parabola is as wide as the one
    before says that they are apart. Returns how many angles there are."""
    c, s, f = np.empty(24), np.empty(24), np.empty(24)
    middle, apart = angle, 0.0001
    for _ in range(3):
        for k in range(24):
            turned = middle + (k % 3 - 1) * apart
            c[k], s[k] = math.cos(turned), math.sin(turned)
        _xarm6_fold(E, c, s, f)
        slope, bend = 0.5 * (f[2] - f[0]), 0.5 * (f[2] + f[0]) - f[1]
        square = slope * slope - 4.0 * bend * f[1]
        if not (square > 0.0 and bend != 0.0):
            return total
        middle -= 0.5 * slope / bend * apart
        apart *= math.sqrt(square) / abs(bend)
        if abs(middle - angle) + apart >= 0.0001:
            return total  # so far apart that they are known
    angles[total], angles[total + 1] = middle - 0.5 * apart, middle + 0.5 * apart
    return total + 2


@_apart("Tuple((boolean, int64))(int64, float64[:, ::1], float64[:, ::1], float64[::1], int64[::1], int64[::1], int64)")
def _xarm6_attempt(form, loop, q, residual, singular, doubles_met, count):
    """Find what a formulation finds: (whether that is certainly everything, the count).

    The certificate: every simple root leads to a solution, there is another one for each of them and
    two more for each double root, or a singular one; and regular solutions come in pairs. Where the
    determinant only comes near to zero there is no root; where it nearly vanishes all around, rounding
    of the equations may lift it off a double root, which nothing but they tell. What an attempt
    before took for double roots is none then; whether the arm is singular there is looked at.
    """
    doubted = doubles_met[0] > 0
    joints, links = _XARM6_JOINTS[form], _xarm6_around(form, loop)
    E = _xarm6_equations(joints, links)
    good, roots, counts = _xarm6_real_roots(E)
    if not good:
        return False, count
    simple, touching, complete = counts[0], counts[1] + counts[4], counts[3] == 1
    # simple roots, pairs of them that nearly meet, double roots
    angles = np.empty(144)
    total = simple
    for i in range(simple):
        angles[i] = roots[0, i]
        for j in range(i):
            gap = math.cos(0.5 * (roots[0, i] - roots[0, j]))
            if 4.0 * gap * gap > 3.999999 and total < 72:
                middle = 0.5 * (roots[0, i] + roots[0, j])
                angles[total] = middle if gap > 0.0 else middle + 3.141592653589793
                total += 1
    for i in range(touching):
        total = _xarm6_separate(E, roots[1, i], angles, total)
    first_double = total
    for i in range(touching):
        angles[total] = roots[1, i]
        total += 1
    met = np.zeros(64, dtype=np.int64)
    cosines, sines, determinant = np.empty(24), np.empty(24), np.empty(24)
    c, s = carray(_room(6), 6), carray(_room(6), 6)
    tc, ts = carray(_room(6), 6), carray(_room(6), 6)
    vectors, expected, true_doubles = np.empty((5, 6)), simple, 0
    for i in range(total):
        at = i % 24
        if at == 0:
            for k in range(24):
                angle = angles[min(i + k, total - 1)]
                cosines[k], sines[k] = math.cos(angle), math.sin(angle)
            factors = _xarm6_fold(E, cosines, sines, determinant)
        cosine, sine = cosines[at], sines[at]
        met_here = singular_here = False
        ways, regular = _xarm6_null_vectors(factors, at, i >= simple, vectors)
        if i >= first_double:
            regular = regular and _xarm6_independence(E, cosine, sine) > 8.999999999999999e-08
        for n in range(ways):
            c[0], s[0] = cosine, sine
            _xarm6_angles(joints, links, vectors[n], c, s)
            for k in range(6):
                tc[joints[k]], ts[joints[k]] = c[k], _XARM6_SIGNS[form] * s[k]
            place, count = _xarm6_offer(
                loop, tc, ts, False, doubted or i >= simple, q, residual, singular, count
            )
            if place >= 0:
                met[place] = 1
                met_here = True
                singular_here = singular_here or singular[place] & 1 == 1
            elif i < simple:
                complete = False
        if i >= first_double and (met_here or not regular):
            expected += 1 if singular_here else 2
            true_doubles += 1
    regular = count - _xarm6_marked(singular)
    complete = complete and _xarm6_marked(met) >= expected and regular % 2 == 0
    doubles_met[0] = true_doubles if complete else doubles_met[0] + counts[1]
    return complete, count


@_apart("Tuple((boolean, int64))(float64[:, ::1], float64[:, ::1], float64[::1], int64[::1], int64[::1])")
def _xarm6_try(loop, q, residual, singular, doubles_met):
    """Find what the methods find, one after the other, until that is certainly everything."""
    for i in range(64):
        singular[i] = 0
    complete, count = False, np.int64(0)
    for way in range(1):
        if not complete:
            complete, count = _xarm6_attempt_closed(
                way, loop, q, residual, singular, doubles_met, count
            )
    for form in range(2):
        if not complete:
            complete, count = _xarm6_attempt(form, loop, q, residual, singular, doubles_met, count)
    return complete, count


@_apart("Tuple((boolean, int64))(float64[:, ::1], float64[:, ::1], float64[::1], int64[::1], int64)")
def _xarm6_from_nearby(loop, q, residual, singular, count):
    """Solve poses close by, and follow their solutions back: (whether that is all, the count).

    Where two solutions meet they are on one side only: both sides have to have as many as are
    found. Around a singular pose none of them has to have all solutions: then all are looked at.
    """
    followed = False
    before = -1
    c, s = np.empty(6), np.empty(6)
    other, ignored, marks = np.empty((64, 6)), np.empty(64), np.zeros(64, dtype=np.int64)
    for n in range(10):
        nearby = loop.copy()
        _xarm6_follow(nearby[5], _XARM6_NUDGES[n])
        complete, found = _xarm6_try(
            nearby, other, ignored, marks, np.zeros(1, dtype=np.int64)
        )
        met = np.zeros(64, dtype=np.int64)
        singular_here = False
        for i in range(found):
            _xarm6_begun(other[i], c, s)
            place, count = _xarm6_offer(
                loop, c, s, True, True, q, residual, singular, count
            )
            if place < 0:
                complete = False
            else:
                met[place] = 1
                singular_here = singular_here or singular[place] & 1 == 1
        marked = _xarm6_marked(singular)
        agreed = -1
        if complete and found > 0:
            agreed = found if _xarm6_marked(met) == found else -1
            followed = followed or singular_here
        alike = n % 2 == 1 and before == count and agreed == count
        if alike and marked == 0 and count % 2 == 0:
            return True, count
        before = agreed
    return followed and (count - _xarm6_marked(singular)) % 2 == 0, count


@_inner
def _xarm6_before(q, rank, i, j):
    """Whether solution i comes before solution j: by rank, then by the first angle, angles that agree
    to rounding by the next."""
    if rank[i] != rank[j]:
        return rank[i] < rank[j]
    for k in range(6):
        if abs(q[i, k] - q[j, k]) > 1e-09:
            return q[i, k] < q[j, k]
    return False


@_apart("int64(float64[::1], float64[:, ::1], float64[::1])")
def xarm6_general(T, q, residual):
    """All solutions of T = C0 J(q1) C1 ... J(q6) C6, at most 16.

    Args:
        T: A rigid transform, twelve numbers.
        q: (16, 6), takes the angles, in (-pi, pi], or length; rows in the order of q1, rows whose q1 agree to
            1e-09 in the order of q2, and so on, those where the arm is singular or nearly so behind all others.
        residual: (16,), takes by how much the loop stays open, in radians and arm sizes.

    Returns:
        How many; -1 - count when it is not certain that these are all: for want of a certificate of
        its own (where every polynomial vanishes identically there may be a continuum, which poses
        close by do not have), or because roots met or the arm is singular at a solution, or nearly,
        so that steps did not make it exact.
    """
    loop = _xarm6_close(T)
    P = loop[5]
    if P[3] * P[3] + P[7] * P[7] + P[11] * P[11] > 4.000000004:
        return 0
    found, missing, singular = np.empty((64, 6)), np.empty(64), np.zeros(64, dtype=np.int64)
    doubles_met = np.zeros(1, dtype=np.int64)
    certified, count = _xarm6_try(loop, found, missing, singular, doubles_met)
    complete = certified
    if not complete:
        complete, count = _xarm6_from_nearby(loop, found, missing, singular, count)
    if not complete:
        seed = 1
        c, s = np.empty(6), np.empty(6)
        for _ in range(128):
            start = np.empty(6)
            for i in range(6):
                seed = (seed * 1103515245 + 12345) % 2147483648
                start[i] = (seed / 1073741824.0 - 1.0) * 3.141592653589793
            _xarm6_begun(start, c, s)
            _, count = _xarm6_offer(
                loop, c, s, True, True, found, missing, singular, count
            )
    regular = _xarm6_marked(singular) == 0 and doubles_met[0] == 0
    _xarm6_rank(found, singular, count)
    order = np.empty(64, dtype=np.int64)
    for i in range(count):
        j = i
        while j > 0 and _xarm6_before(found, singular, i, order[j - 1]):
            order[j] = order[j - 1]
            j -= 1
        order[j] = i
    if count > 16:
        certified, count = False, 16
    for i in range(count):
        for k in range(6):
            q[i, k] = found[order[i], k]
        residual[i] = missing[order[i]]
    for i in range(count):
        regular = regular and residual[i] <= 1e-12
    return count if certified and regular else -1 - count


_FACING = np.array([1.0, 1.0, 1.0, -1.0, 1.0, -1.0])
_ZERO = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0])


@_apart("Tuple((float64[:, ::1], boolean[::1], boolean[::1]))(UniTuple(float64, 12), float64[::1])")
def _all_joints(pose, seed):
    """All solutions, which rows hold one, and where a joint was indeterminate and follows the seed."""
    flat, T = np.empty(12), np.empty((3, 4))
    for i in range(3):
        for j in range(4):
            flat[4 * i + j] = T[i, j] = pose[4 * i + j]
    angles, residual, joints = np.empty((16, 6)), np.empty(16), np.zeros(6)
    known = xarm6_general(flat, angles, residual)
    q = np.zeros((16, 6))
    found, chosen = np.zeros(16, np.bool_), np.zeros(16, np.bool_)
    kept, kinds, count = np.empty((16, 6)), np.empty(16, np.int64), 0
    near, u = np.empty(6), np.empty(6)
    for j in range(6):
        near[j] = seed[_SOLVED[j]] / _UNIT[j]
    for k in range(16):
        kinds[k] = -1
    if known < 0:
        _take(u, near)
        if _descend(T, joints, u) <= 1e-10:
            count = _keep(T, joints, near, kept, kinds, count, u)
    many = -1 - known if known < 0 else known
    for k in range(many):
        for j in range(6):
            u[j] = _FACING[j] * (angles[k, j] - _ZERO[j]) / _UNIT[j]
        if known < 0:
            _descend(T, joints, u)  # where solutions meet it is exact that tells them apart
            count = _keep(T, joints, near, kept, kinds, count, u)
        else:
            _wrap_angles(u)
            _take(kept[count], u)
            count += 1
    if known < 0:
        for k in range(1, 12):
            _start_of(k, near, u)
            if _descend(T, joints, u) <= 1e-10:
                count = _keep(T, joints, near, kept, kinds, count, u)
    _sorted_rows(kept, kinds, count, joints, q, found, chosen)
    return q, found, chosen


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    # all joints: the general 6R loop
    solution_roots, solution_found, solution_chosen = _all_joints(pose, seed)

    for i1 in range(16):  # root1 to root16
        q1 = solution_roots[i1, 0]
        q2 = solution_roots[i1, 1]
        q3 = solution_roots[i1, 2]
        q4 = solution_roots[i1, 3]
        q5 = solution_roots[i1, 4]
        q6 = solution_roots[i1, 5]
        found = solution_found[i1]
        chosen = solution_chosen[i1]
        # all joints: the general 6R loop
        if not found:
            continue  # out of reach
        row = i1
        q[row, 0] = q1
        q[row, 1] = q2
        q[row, 2] = q3
        q[row, 3] = q4
        q[row, 4] = q5
        q[row, 5] = q6
        status[row] = FREE_JOINT if chosen else OK


@_njit(forceinline=True)
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


@_inner
def _turned(joint, given, towards):
    """A joint value moved by whole turns, near to another value but inside its limits."""
    low, high = _LOWEST[joint], _HIGHEST[joint]
    value = given
    if abs(towards) < 100000.0:
        value += turn * math.floor((towards - given) / turn + 0.5)
    if value > high:
        value -= turn * math.ceil((value - high) / turn)
    if value < low:
        value += turn * math.ceil((low - value) / turn)
    return value if value <= high else given


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(16):
        status[row] = UNREACHABLE
        for i in range(6):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    count = 0
    for row in range(16):
        if status[row] == UNREACHABLE:
            continue
        for i in range(6):
            q[row, i] = _turned(i, q[row, i], q[row, i])
            if not _LOWEST[i] <= q[row, i] <= _HIGHEST[i]:
                status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (16, 6) or status.shape != (16,):
        raise ValueError("T, q and status must have shapes (4, 4), (16, 6), (16,)")
    valid, pose = _read(T)
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    return _whole(pose, seed, q, status)


@_merged
def _zeros(seed):
    """The seed where there is none; of the type that callers' arrays have."""
    for i in range(6):
        seed[i] = 0.0
    return seed


@_jit
def _unseeded(T, q, status):
    seed = _zeros(carray(_room(6), 6))
    return _into(_lent_rows(T), seed, _lent_rows(q), _lent_statuses(status))


@_jit
def _seeded(T, q, status, seed):
    if seed.shape != (6,):
        raise ValueError("q_seed must have shape (6,)")
    for value in seed:
        if not math.isfinite(value):
            raise ValueError("q_seed must be finite")
    return _into(_lent_rows(T), _lent_values(seed), _lent_rows(q), _lent_statuses(status))


def ik_into(T, q, status, q_seed=None):
    """All solutions into the caller's arrays, for control loops and for other numba functions.

    Memory is allocated at every pose. numba compiles
    once more for arrays of another layout.

    Args:
        T: Pose (4, 4), float64.
        q: Filled with joint values (16, 6), NaN where there is no solution; float64.
        status: Filled with what each row holds (16,); uint8.
        q_seed: Values for joints that are indeterminate (6,), float64; zeros without it.

    Returns:
        How many rows are OK or FREE_JOINT.

    Raises:
        ValueError: An array has the wrong shape or type, or the seed is not finite.
    """
    try:
        # From Python numba takes its time for an argument that is left out.
        if q_seed is None:
            return _unseeded(T, q, status)
        return _seeded(T, q, status, q_seed)
    except Exception:
        # Types and shapes are looked at in there: only who fails is told which array it is.
        _look_at(T, q, status, q_seed)
        raise


def _look_at(T, q, status, q_seed):
    """ValueError where an array is none that `ik_into` takes."""
    _demand_array("T", T, (4, 4), _FLOAT)
    _demand_array("q", q, (16, 6), _FLOAT)
    _demand_array("status", status, (16,), _BYTE)
    if q_seed is not None:
        _demand_array("q_seed", q_seed, (6,), _FLOAT)
    if not (q.flags.writeable and status.flags.writeable):
        raise ValueError("q and status are filled: they can't be read-only") from None


def _demand_array(name, array, shape, kind):
    plain = isinstance(array, np.ndarray) and not isinstance(array, np.ma.MaskedArray)
    if not plain or array.dtype != kind:  # a dtype equals some names of types
        got = array.dtype if plain else type(array).__name__
        raise ValueError(f"{name} must be an array of {kind}, not {got}") from None
    if array.shape != shape:
        raise ValueError(f"{name} must have shape {shape}, not {array.shape}") from None


@overload(ik_into)
def _ik_into(T, q, status, q_seed=None):
    def solve(T, q, status, q_seed=None):
        if q_seed is None:
            return _unseeded(_lent_rows(T), _lent_rows(q), _lent_statuses(status))
        return _seeded(_lent_rows(T), _lent_rows(q), _lent_statuses(status), _lent_values(q_seed))

    return solve


def ik_all(T, q_seed=None):
    """All solutions: q (16, 6) and status (16,).

    Row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (6,); zeros without it.

    Raises:
        ValueError: An argument has the wrong shape, or the seed is not finite.
    """
    q, status = _empty((16, 6)), _empty(16, _BYTE)
    given = T
    try:
        T = _contiguous(T)
        if T.dtype is not _FLOAT:
            T = _numbers(T, (4, 4), "T")
        if q_seed is None:
            _unseeded(T, q, status)
        else:
            seed = _array(q_seed, (6,), "q_seed")
            _seeded(T, q, status, seed)
    except Exception:
        # Shapes are looked at in there: only who fails is asked again, and told which one it is.
        _array(given, (4, 4), "T")
        raise
    return q, status


@_jit
def _near(joint, value, towards, limits):
    """A joint value moved by whole turns near to another, if limits count inside its own."""
    if limits:
        return _turned(joint, value, towards)
    if not abs(towards) < 100000.0:
        return value
    return value + turn * math.floor((towards - value) / turn + 0.5)


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
        if nearest < 0 or distance < least:
            nearest, least = row, distance
    for i in range(6):
        q[i] = rows[nearest, i]
    return nearest >= 0


def ik(T, q_seed=None, *, branch=None, limits=True):
    """One solution (6,): the nearest to the seed.

    Angles are moved by whole turns into their limits.

    Args:
        T: Pose (4, 4).
        q_seed: Where the arm is (6,); zeros without it.
        branch: Only this branch: a name from BRANCHES, or its row.
        limits: Whether joint limits count: True or False.

    Raises:
        Unreachable: There is no such solution; the message says why.
        ValueError: T is not a valid pose, branch does not exist, or limits is not True or False.
    """
    if not isinstance(limits, (bool, np.bool_)):
        raise ValueError(f"limits must be True or False, not {limits!r}")
    first, last = (0, 16) if branch is None else _span(branch)
    rows, status = ik_all(T, q_seed)
    if status[0] == INVALID_POSE:
        raise ValueError("T is not a valid pose: not finite, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)")
    rows, status, q = rows[first:last], status[first:last], np.empty(6)
    seed = _ZEROS if q_seed is None else _array(q_seed, (6,), "q_seed")
    if _nearest(rows, status, seed, limits, q):
        return q
    where = "" if branch is None else f" in branch {BRANCHES[first]}"
    beyond = OUT_OF_LIMITS in status
    why = "solutions found are beyond the joint limits" if beyond else "the pose is out of reach"
    raise Unreachable(why + where)


@_njit(nogil=True)
def _one_by_one(T, q, status):
    for k in range(len(T)):
        _unseeded(T[k], q[k], status[k])


def ik_batch(T, *, cores=None, out=None):
    """ik_all for N poses (N, 4, 4), shared among `cores` cores, by default all of them.

    Args:
        T: Poses (N, 4, 4).
        cores: How many threads share the poses.
        out: The arrays q and status to write to, from an earlier call or like those: fresh
            memory can cost more time than the solutions.

    Returns:
        q (N, 16, 6) and status (N, 16).

    Raises:
        ValueError: An argument has the wrong shape, or cores is not a whole number from 1.
    """
    given, T = T, _numbers(T, "(N, 4, 4)", "T")
    if T.ndim != 3 or T.shape[1:] != (4, 4):
        raise ValueError(f"T must have shape (N, 4, 4), not {np.shape(given)}")
    if cores is not None and not (_is_number(cores) and cores >= 1):
        raise ValueError(f"cores must be at least 1, or None for all of them, not {cores!r}")
    q, status = _results(out, len(T))
    _share(_one_by_one, cores, T, q, status)
    return q, status


def warm_up():
    """Compiles everything, or gets it from numba's cache, so that no call waits for it later."""
    q, status = np.empty((16, 6)), np.empty(16, _BYTE)
    T = fk(_ZEROS)
    jacobian(_ZEROS)
    ik_into(T, q, status)
    ik_into(T, q, status, _ZEROS)
    _nearest(q, status, _ZEROS, True, np.empty(6))
    ik_batch(T[np.newaxis])
    _HOW.compile_apart()


def _results(out, count):
    """The rows and the statuses of so many poses: the caller's arrays, or new ones."""
    rows, row = (count, 16, 6), (count, 16)
    if out is None:
        return np.empty(rows), np.empty(row, _BYTE)
    if not isinstance(out, (tuple, list)) or len(out) != 2:
        raise ValueError("out must be (q, status), two arrays like those an earlier call returned")
    q, status = out
    for name, array, shape, kind in ("q", q, rows, _FLOAT), ("status", status, row, _BYTE):
        ready = isinstance(array, np.ndarray) and array.flags.carray
        if not ready and isinstance(array, np.ndarray) and not array.flags.writeable:
            raise ValueError(f"{name} in out can't be written to: it is read-only")
        if not ready or array.shape != shape or array.dtype != kind:
            raise ValueError(f"{name} in out must be a contiguous array of {kind}, {shape}")
    return q, status


def _share(solve, cores, *arrays):
    """Solves the rows of arrays, shared among threads."""
    shares = len(arrays[0]) // 2048
    if shares > 1:  # asking for the cores takes longer than some poses
        shares = min(cores or os.cpu_count() or 1, shares)
    if shares > 1:
        with ThreadPoolExecutor(shares) as threads:
            list(threads.map(solve, *(np.array_split(array, shares) for array in arrays)))
    else:
        solve(*arrays)


def _span(branch):
    """The rows of a branch: the first, and the one after the last."""
    if isinstance(branch, str) and branch in BRANCHES:
        branch = BRANCHES.index(branch)
    if _is_number(branch) and 0 <= branch < MAX_SOLUTIONS:
        return branch, branch + 1
    names = ", ".join(BRANCHES)
    raise ValueError(f"no branch {branch!r}; give a row, from 0, or a name: {names}")


def _is_number(value):
    """Whether it is a whole number; True and False are none."""
    return isinstance(value, (int, np.integer)) and not isinstance(value, bool)
