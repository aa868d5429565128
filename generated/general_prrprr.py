"""general_prrprr: General arm with slides as joints 1 and 4.

Inverse kinematics, generated from robots/general_prrprr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/general_prrprr.yaml. The formulas and where they come from:
general_prrprr.md.

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

NAME = "general_prrprr"
METHOD = "general 4R2P"
DOF = 6
JOINT_TYPES = "PRRPRR"
JOINT_LIMITS = (
    (0.0, 1.2),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-0.4, 0.4),
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
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

cat1 = 0.955336489125606  # cosine of the angle of joint 1
ca1 = 0.9800665778412416  # cosine of twist 1
sa1 = 0.19866933079506122  # sine of twist 1
a3 = 0.32  # link length 3 [m]
ca3 = 0.26749882862458735  # cosine of twist 3
sa3 = 0.963558185417193  # sine of twist 3
cat4 = 0.5403023058681398  # cosine of the angle of joint 4
sat4 = 0.8414709848078965  # sine of the angle of joint 4
a4 = 0.13  # link length 4 [m]
ca4 = 0.8775825618903728  # cosine of twist 4
sa4 = 0.479425538604203  # sine of twist 4
a5 = 0.21  # link length 5 [m]
ca5 = 0.029199522301288937  # cosine of twist 5
sa5 = 0.9995736030415051  # sine of twist 5
a6 = 0.1  # link length 6 [m]
ca6 = 0.7648421872844885  # cosine of twist 6
sa6 = 0.644217687237691  # sine of twist 6
f1 = 0.28962947762551555  # sat1 * ca1
f2 = 0.05871080169382652  # sat1 * sa1
f3 = 0.052133305972592796  # a2 * sat1 * ca1 [m]
f4 = 0.010567944304888773  # a2 * sat1 * sa1 [m]
f5 = 0.32983280059673464  # a1 + a2 * cat1 + sat1 * d2 * sa2 [m]
f6 = 0.1833559467502831  # d2 * sa2 * cat1 * ca1 [m]
f7 = 0.03716809047647615  # d2 * sa2 * cat1 * sa1 [m]
f8 = 0.030873709102968033  # sa1 * d2 * ca2 [m]
f9 = 0.1523047885887582  # d2 * ca2 * ca1 [m]
f10 = 0.18369830628609546  # sat1 * ca2
f11 = 0.42638625510015216  # ca2 * cat1 * ca1 - sa1 * sa2
f12 = 0.8856916470924222  # ca2 * cat1 * sa1 + sa2 * ca1
f13 = 0.10599140039589122  # d3 * sa3 [m]
f14 = 0.006811531943972054  # d3 * ca3 * sat1 * sa2 [m]
f15 = 0.02521472007885299  # (sa2 * cat1 * ca1 + sa1 * ca2) * d3 * ca3 [m]
f16 = 0.013551530025764803  # d3 * ca3 * (ca2 * ca1 - sa2 * cat1 * sa1) [m]
f17 = 0.2230530535435802  # sa3 * sat1 * sa2
f18 = 0.8256909538260336  # (sa2 * cat1 * ca1 + sa1 * ca2) * sa3
f19 = 0.44376363163199056  # sa3 * (ca2 * ca1 - sa2 * cat1 * sa1)
f20 = 0.06192301767247322  # ca3 * sat1 * sa2
f21 = 0.22922472798957264  # (sa2 * cat1 * ca1 + sa1 * ca2) * ca3
f22 = 0.12319572750695275  # ca3 * (ca2 * ca1 - sa2 * cat1 * sa1)
f23 = 0.7384602626041288  # sat4 * ca4
f24 = 0.4034226801113349  # sat4 * sa4
f25 = 0.4741598817790379  # cat4 * ca4
f26 = 0.2590347239999257  # cat4 * sa4
f27 = -0.1599317764866408  # d5 * sa5 [m]
f28 = -0.00467192356820623  # d5 * ca5 [m]
f29 = 0.1224013605751613  # d6 * sa6 [m]
f30 = 0.1453200155840528  # d6 * ca6 [m]
g13 = 0.23148893021650235  # sat1 * sa2
g14 = 0.8569186234130046  # sa2 * cat1 * ca1 + sa1 * ca2
g15 = 0.4605467924491282  # ca2 * ca1 - sa2 * cat1 * sa1

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1.75e-09, 1e-09, 1e-09, 1.75e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([0.32653061224489793, 1.0, 1.0, 0.32653061224489793, 1.0, 1.0])
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
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = cat1 * c2 - f10 * s2
    x2_y = f1 * c2 + f11 * s2
    x2_z = f2 * c2 + f12 * s2
    v1 = f10 * c2 + cat1 * s2
    y2_y = f11 * c2 - f1 * s2
    y2_z = f12 * c2 - f2 * s2
    v2 = v1 * ca3 + f17
    v3 = y2_y * ca3 + f18
    v4 = y2_z * ca3 - f19
    z3_x = f20 - v1 * sa3
    z3_y = y2_y * sa3 - f21
    z3_z = y2_z * sa3 + f22
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v2 * s3
    x3_y = x2_y * c3 + v3 * s3
    x3_z = x2_z * c3 + v4 * s3
    v5 = v2 * c3 + x2_x * s3
    y3_y = v3 * c3 - x2_y * s3
    y3_z = v4 * c3 - x2_z * s3
    x4_x = x3_x * cat4 - v5 * f23 + z3_x * f24
    x4_y = x3_y * cat4 + y3_y * f23 + z3_y * f24
    x4_z = x3_z * cat4 + y3_z * f23 + z3_z * f24
    y4_x = z3_x * f26 - (x3_x * sat4 + v5 * f25)
    y4_y = y3_y * f25 - x3_y * sat4 + z3_y * f26
    y4_z = y3_z * f25 - x3_z * sat4 + z3_z * f26
    z4_x = v5 * sa4 + z3_x * ca4
    z4_y = z3_y * ca4 - y3_y * sa4
    z4_z = z3_z * ca4 - y3_z * sa4
    v6 = z4_x * sa5 - y4_x * ca5
    v7 = z4_y * sa5 - y4_y * ca5
    v8 = z4_z * sa5 - y4_z * ca5
    v9 = y4_x * sa5 + z4_x * ca5
    v10 = y4_y * sa5 + z4_y * ca5
    v11 = y4_z * sa5 + z4_z * ca5
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 + v6 * s5
    x5_y = x4_y * c5 + v7 * s5
    x5_z = x4_z * c5 + v8 * s5
    y5_x = v6 * c5 - x4_x * s5
    y5_y = v7 * c5 - x4_y * s5
    y5_z = v8 * c5 - x4_z * s5
    v12 = y5_x * ca6 + v9 * sa6
    v13 = y5_y * ca6 + v10 * sa6
    v14 = y5_z * ca6 + v11 * sa6
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 + v12 * s6
    T[0, 1] = v12 * c6 - x5_x * s6
    T[0, 2] = y5_x * sa6 - v9 * ca6
    T[0, 3] = f5 + x2_x * a3 - v1 * f13 + f14 + x3_x * a4 + z4_x * q[3] + x4_x * a5 - y4_x * f27 - z4_x * f28 + x5_x * a6 + y5_x * f29 - v9 * f30
    T[1, 0] = x5_y * c6 + v13 * s6
    T[1, 1] = v13 * c6 - x5_y * s6
    T[1, 2] = y5_y * sa6 - v10 * ca6
    T[1, 3] = f3 - sa1 * q[0] - f6 - f8 + x2_y * a3 + y2_y * f13 - f15 + x3_y * a4 + z4_y * q[3] + x4_y * a5 - y4_y * f27 - z4_y * f28 + x5_y * a6 + y5_y * f29 - v10 * f30
    T[2, 0] = x5_z * c6 + v14 * s6
    T[2, 1] = v14 * c6 - x5_z * s6
    T[2, 2] = y5_z * sa6 - v11 * ca6
    T[2, 3] = ca1 * q[0] + f4 - f7 + f9 + x2_z * a3 + y2_z * f13 + f16 + x3_z * a4 + z4_z * q[3] + x4_z * a5 - y4_z * f27 - z4_z * f28 + x5_z * a6 + y5_z * f29 - v11 * f30
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    J = np.zeros((6, 6))
    p2_y = f3 - sa1 * q[0] - f6 - f8
    p2_z = ca1 * q[0] + f4 - f7 + f9
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = cat1 * c2 - f10 * s2
    x2_y = f1 * c2 + f11 * s2
    x2_z = f2 * c2 + f12 * s2
    v1 = f10 * c2 + cat1 * s2
    y2_y = f11 * c2 - f1 * s2
    y2_z = f12 * c2 - f2 * s2
    p3_x = f5 + x2_x * a3 - v1 * f13 + f14
    p3_y = p2_y + x2_y * a3 + y2_y * f13 - f15
    p3_z = p2_z + x2_z * a3 + y2_z * f13 + f16
    v2 = v1 * ca3 + f17
    v3 = y2_y * ca3 + f18
    v4 = y2_z * ca3 - f19
    z3_x = f20 - v1 * sa3
    z3_y = y2_y * sa3 - f21
    z3_z = y2_z * sa3 + f22
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v2 * s3
    x3_y = x2_y * c3 + v3 * s3
    x3_z = x2_z * c3 + v4 * s3
    v5 = v2 * c3 + x2_x * s3
    y3_y = v3 * c3 - x2_y * s3
    y3_z = v4 * c3 - x2_z * s3
    x4_x = x3_x * cat4 - v5 * f23 + z3_x * f24
    x4_y = x3_y * cat4 + y3_y * f23 + z3_y * f24
    x4_z = x3_z * cat4 + y3_z * f23 + z3_z * f24
    y4_x = z3_x * f26 - (x3_x * sat4 + v5 * f25)
    y4_y = y3_y * f25 - x3_y * sat4 + z3_y * f26
    y4_z = y3_z * f25 - x3_z * sat4 + z3_z * f26
    z4_x = v5 * sa4 + z3_x * ca4
    z4_y = z3_y * ca4 - y3_y * sa4
    z4_z = z3_z * ca4 - y3_z * sa4
    p5_x = p3_x + x3_x * a4 + z4_x * q[3] + x4_x * a5 - y4_x * f27 - z4_x * f28
    p5_y = p3_y + x3_y * a4 + z4_y * q[3] + x4_y * a5 - y4_y * f27 - z4_y * f28
    p5_z = p3_z + x3_z * a4 + z4_z * q[3] + x4_z * a5 - y4_z * f27 - z4_z * f28
    v6 = z4_x * sa5 - y4_x * ca5
    v7 = z4_y * sa5 - y4_y * ca5
    v8 = z4_z * sa5 - y4_z * ca5
    v9 = y4_x * sa5 + z4_x * ca5
    v10 = y4_y * sa5 + z4_y * ca5
    v11 = y4_z * sa5 + z4_z * ca5
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    y5_x = v6 * c5 - x4_x * s5
    y5_y = v7 * c5 - x4_y * s5
    y5_z = v8 * c5 - x4_z * s5
    p6_x = p5_x + (x4_x * c5 + v6 * s5) * a6 + y5_x * f29 - v9 * f30
    p6_y = p5_y + (x4_y * c5 + v7 * s5) * a6 + y5_y * f29 - v10 * f30
    p6_z = p5_z + (x4_z * c5 + v8 * s5) * a6 + y5_z * f29 - v11 * f30
    v12 = p6_x - f5
    v13 = p6_y - p2_y
    v14 = p6_z - p2_z
    v15 = p6_x - p3_x
    v16 = p6_y - p3_y
    v17 = p6_z - p3_z
    v18 = p6_x - p5_x
    v19 = p6_y - p5_y
    v20 = p6_z - p5_z
    J[0, 1] = -(g14 * v14 + g15 * v13)
    J[0, 2] = z3_y * v17 - z3_z * v16
    J[0, 3] = z4_x
    J[0, 4] = v11 * v19 - v10 * v20
    J[1, 0] = -sa1
    J[1, 1] = g15 * v12 - g13 * v14
    J[1, 2] = z3_z * v15 - z3_x * v17
    J[1, 3] = z4_y
    J[1, 4] = v9 * v20 - v11 * v18
    J[2, 0] = ca1
    J[2, 1] = g13 * v13 + g14 * v12
    J[2, 2] = z3_x * v16 - z3_y * v15
    J[2, 3] = z4_z
    J[2, 4] = v10 * v18 - v9 * v19
    J[3, 1] = g13
    J[3, 2] = z3_x
    J[3, 4] = -v9
    J[3, 5] = y5_x * sa6 - v9 * ca6
    J[4, 1] = -g14
    J[4, 2] = z3_y
    J[4, 4] = -v10
    J[4, 5] = y5_y * sa6 - v10 * ca6
    J[5, 1] = g15
    J[5, 2] = z3_z
    J[5, 4] = -v11
    J[5, 5] = y5_z * sa6 - v11 * ca6
    return J


# The joints that are solved for, and whether they turn; what a step of one means, in rad or
# lengths, and the same over the arm's size. Below, u are these joints in units.
_SOLVED = np.array([0, 1, 2, 3, 4, 5])
_TURNING = np.array([False, True, True, False, True, True])
_UNIT = np.array([1.75, 1.0, 1.0, 1.75, 1.0, 1.0])
_MEASURE = np.array([
    1.0, 0.5714285714285714, 0.5714285714285714, 1.0, 0.5714285714285714, 0.5714285714285714,
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
    e[0] = (T[0, 3] - P[0, 3]) / 1.75
    e[1] = (T[1, 3] - P[1, 3]) / 1.75
    e[2] = (T[2, 3] - P[2, 3]) / 1.75
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
_LEAST_U = np.array([0.0, -math.inf, -math.inf, -0.2285714285714286, -math.inf, -math.inf])
_MOST_U = np.array([0.6857142857142857, math.inf, math.inf, 0.2285714285714286, math.inf, math.inf])
# Between which values starts lie.
_SPAN_LOW = np.array([
    0.0, -3.141592653589793, -3.141592653589793, -0.2285714285714286, -3.141592653589793,
    -3.141592653589793,
])
_SPAN_WIDTH = np.array([
    0.6857142857142857, 6.283185307179586, 6.283185307179586, 0.4571428571428572, 6.283185307179586,
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


@_inner
def _clamped(u, seen, inside):
    """The nearest values inside the limits, whole turns aside, but next to the seed's where they are
    just beyond an end there; returns how far one was beyond."""
    most = 0.0
    for j in range(6):
        near, middle = u[j], 0.5 * (_LEAST_U[j] + _MOST_U[j])
        if _TURNING[j] and math.isfinite(middle):
            near -= 6.283185307179586 * math.floor((near - seen[j]) / 6.283185307179586 + 0.5)
            past = max(_LEAST_U[j] - near, near - _MOST_U[j])
            if past >= 0.01 or abs(near - seen[j]) >= 0.15:
                near -= 6.283185307179586 * math.ceil((near - middle) / 6.283185307179586 - 0.5)
        inside[j] = min(max(near, _LEAST_U[j]), _MOST_U[j])
        most = max(most, abs(inside[j] - near))
    return most


@_apart("boolean(float64[:, ::1], float64[::1], float64[::1], float64[::1], float64[::1])")
def _leads_inside(T, q, near, u, end):
    """Takes joint values on a way from u to a solution that keeps all limits and is as exact as a row
    has to be, farther on if steps lead back; returns if it can."""
    way, start, inside = np.empty(6), end.copy(), np.empty(6)
    for j in range(6):
        way[j] = start[j] - u[j]
    _wrap_angles(way)
    for part in (0.0, 1.0, 3.0, 7.0, 15.0):
        for j in range(6):
            end[j] = start[j] + part * way[j]
        if _descend(T, q, end) <= 1e-11 and _clamped(end, near, inside) <= 1e-09:
            return True
    return False


@_apart("void(float64[:, ::1], float64[::1], float64[::1], float64[:, ::1], int64[::1], int64, boolean, float64, float64[::1])")
def _move_inside(T, q, near, kept, kinds, count, alone, enough, u):
    """Instead of one that is beyond a limit a solution that keeps all of them, if the way to the seed
    inside the limits leads to one, from there or from the seed; where it stands alone to one that is
    taken for it and as exact as a row has to be."""
    end = np.empty(6)
    if _clamped(u, near, end) <= 1e-09:
        return
    for from_seed in range(2):
        _clamped(near if from_seed else u, near, end)
        if _pulled(T, q, end, near, _LEAST_U, _MOST_U) > enough:
            continue
        if alone and not _leads_inside(T, q, near, u, end):
            continue
        if _known_as(T, q, kept, kinds, count, end, True) < 0 and (not alone or _taken_for(T, q, u, end, True)):
            _take(u, end)
            return


@_inner
def _takes_place(T, q, near, u, known):
    """Of two solutions that are taken for one that inside the limits is kept if it is as
    exact as a row has to be."""
    end = np.empty(6)
    if _clamped(known, near, end) <= 1e-09 or _clamped(u, near, end) > 1e-09:
        return False
    e, A = np.empty(6), np.empty((6, 6))
    return _look(T, q, u, e, A) <= 1e-11


@_apart("int64(float64[:, ::1], float64[::1], float64[::1], float64[:, ::1], int64[::1], int64, float64[::1])")
def _keep(T, q, near, kept, kinds, count, u):
    """A solution joins those found before, unless it is one of them; how many there are then."""
    if count == 8 or _known_as(T, q, kept, kinds, count, u, False) >= 0:
        return count
    enough = 1e-10
    kind = _continuum(T, q, u, enough)
    if kind == 1:
        end = u.copy()
        _pulled(T, q, end, near, _NO_LOWEST, _NO_HIGHEST)
        if _descend(T, q, end) <= enough:
            _take(u, end)
    if kind >= 0:
        _move_inside(T, q, near, kept, kinds, count, kind == 0, enough, u)
    _wrap_angles(u)
    k = _known_as(T, q, kept, kinds, count, u, kind >= 0)
    if k >= 0 and not _takes_place(T, q, near, u, kept[k]):
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




# All solutions, at most 8, of an arm with four turns and two slides. The directions give three
# turns by the fourth, and the slides a determinant that has to vanish: the product over both branches
# is of degree 4 in the hidden turn; here it is sampled at 24 angles.
#
# The loop J(q1) K0 J(q2) ... K4 J(q6) = P, in units of the arm's size, P = L T R.

# The constants K0 ... K4 of the loop, L and R, three rows of four; for those with joints inside whose
# values are given, what stands before, between and behind these.
_GENERAL_PRRPRR_CONSTANTS = np.array([
    [0.38461538461538464, -0.9230769230769231, 0.0, 0.3468966650378003, 0.5737938168652287, 0.23908075702717863, -0.7833269096274834, -0.24071198299688865, 0.7230709935022924, 0.30127958062595517, 0.6216099682706644, 1.910172966735487e-10],
    [0.47058823529411764, -0.8823529411764706, 0.0, 0.6167051822894228, 0.2360283781981653, 0.12588180170568816, 0.963558185417193, 0.05060832613278151, -0.8501983988975231, -0.453439146078679, 0.26749882862458735, 0.18855617369548777],
    [0.5403023058681398, -0.8414709848078966, 0.0, 0.250536480305078, 0.7384602626041288, 0.4741598817790379, -0.479425538604203, 0.032924257305286767, 0.4034226801113349, 0.2590347239999257, 0.8775825618903728, 0.09920262232951157],
    [0.6896551724137931, -0.7241379310344828, 0.0, 0.4047127758774337, -0.021144481666450613, -0.02013760158709582, -0.9995736030415052, 0.08898300940260505, 0.723829160823159, 0.6893611055458657, -0.02919952230128894, 0.07127376158977099],
    [0.32432432432432434, -0.9459459459459459, 0.0, 0.19272036946544463, 0.7234993663501919, 0.24805692560578008, 0.644217687237691, 0.10807014469215119, -0.6093951095491672, -0.20893546613114305, 0.7648421872844885, -0.0910262268897436],
    [0.955336489125606, 0.28962947762551555, 0.058710801693826524, -0.09553364891256061, -0.29552020666133955, 0.9362933635841992, 0.18979606097868743, 0.029552020666133955, 0.0, -0.19866933079506122, 0.9800665778412416, -0.09911628477331971],
    [1.0, 0.0, 0.0, -0.0, 0.0, 1.0, 0.0, -0.0, 0.0, 0.0, 1.0, -0.10295467142321668],
])

# cosine and sine of what is to be added to each joint's angle in the loop
_GENERAL_PRRPRR_ADVANCE_C = np.array([1.0, 0.38461538461538464, 0.47058823529411764, 1.0, 0.6896551724137931, 0.32432432432432434])
_GENERAL_PRRPRR_ADVANCE_S = np.array([0.0, 0.9230769230769231, 0.8823529411764706, 0.0, 0.7241379310344828, 0.9459459459459459])

# poses close by, for those at which the formulations fail
_GENERAL_PRRPRR_NUDGES = np.array([
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
_GENERAL_PRRPRR_JOINTS = np.array([
    [4, 5, 0, 1, 2, 3],
    [5, 0, 1, 2, 3, 4],
])
_GENERAL_PRRPRR_SIGNS = np.array([1.0, 1.0, ])

# cosines and sines of the 24 angles at which the determinant is sampled
_GENERAL_PRRPRR_SAMPLE_C = np.array([1.0, 0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0, -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682, -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5, -0.2588190451025207, 0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386, 0.9659258262890682])
_GENERAL_PRRPRR_SAMPLE_S = np.array([0.0, 0.2588190451025207, 0.5, 0.7071067811865476, 0.8660254037844386, 0.9659258262890682, 1.0, 0.9659258262890682, 0.8660254037844386, 0.7071067811865476, 0.5, 0.2588190451025207, -0.0, -0.2588190451025207, -0.5, -0.7071067811865476, -0.8660254037844386, -0.9659258262890682, -1.0, -0.9659258262890682, -0.8660254037844386, -0.7071067811865476, -0.5, -0.2588190451025207])

# from the samples to a_0 ... a_8, b_1 ... b_8 and seven numbers that would be zero without rounding
_GENERAL_PRRPRR_HARMONICS = np.array([
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
_GENERAL_PRRPRR_GRID_C = np.array([
    [1.0, 0.9996988186962042, 0.9987954562051724, 0.9972904566786902, 0.9951847266721969, 0.99247953459871, 0.989176509964781, 0.9852776423889412, 0.9807852804032304, 0.9757021300385286, 0.970031253194544, 0.9637760657954398, 0.9569403357322088, 0.9495281805930367, 0.9415440651830208, 0.9329927988347388, 0.9238795325112867, 0.9142097557035307, 0.9039892931234433, 0.8932243011955153, 0.881921264348355, 0.8700869911087115, 0.8577286100002721, 0.8448535652497071, 0.8314696123025452, 0.8175848131515837, 0.8032075314806449, 0.7883464276266062, 0.773010453362737, 0.7572088465064846, 0.7409511253549591, 0.7242470829514669, 0.7071067811865476, 0.6895405447370669, 0.6715589548470184, 0.6531728429537768, 0.6343932841636455, 0.6152315905806268, 0.5956993044924334, 0.5758081914178453, 0.5555702330196022, 0.5349976198870973, 0.5141027441932218, 0.49289819222978404, 0.47139673682599764, 0.4496113296546066, 0.4275550934302821, 0.40524131400498986, 0.3826834323650898, 0.35989503653498817, 0.33688985339222005, 0.31368174039889146, 0.2902846772544624, 0.26671275747489837, 0.2429801799032639, 0.2191012401568698, 0.19509032201612828, 0.17096188876030122, 0.14673047445536175, 0.1224106751992162, 0.0980171403295606, 0.07356456359966743, 0.049067674327418015, 0.024541228522912288, 0.0, -0.024541228522912288, -0.049067674327418015, -0.07356456359966743, -0.0980171403295606, -0.1224106751992162, -0.14673047445536175, -0.17096188876030122, -0.19509032201612828, -0.2191012401568698, -0.2429801799032639, -0.26671275747489837, -0.2902846772544624, -0.31368174039889146, -0.33688985339222005, -0.35989503653498817, -0.3826834323650898, -0.40524131400498986, -0.4275550934302821, -0.4496113296546066, -0.47139673682599764, -0.49289819222978404, -0.5141027441932218, -0.5349976198870973, -0.5555702330196022, -0.5758081914178453, -0.5956993044924334, -0.6152315905806268, -0.6343932841636455, -0.6531728429537768, -0.6715589548470184, -0.6895405447370669, -0.7071067811865476, -0.7242470829514669, -0.7409511253549591, -0.7572088465064846, -0.773010453362737, -0.7883464276266062, -0.8032075314806449, -0.8175848131515837, -0.8314696123025452, -0.8448535652497071, -0.8577286100002721, -0.8700869911087115, -0.881921264348355, -0.8932243011955153, -0.9039892931234433, -0.9142097557035307, -0.9238795325112867, -0.9329927988347388, -0.9415440651830208, -0.9495281805930367, -0.9569403357322088, -0.9637760657954398, -0.970031253194544, -0.9757021300385286, -0.9807852804032304, -0.9852776423889412, -0.989176509964781, -0.99247953459871, -0.9951847266721969, -0.9972904566786902, -0.9987954562051724, -0.9996988186962042],
    [1.0, 0.9987954562051724, 0.9951847266721969, 0.989176509964781, 0.9807852804032304, 0.970031253194544, 0.9569403357322088, 0.9415440651830208, 0.9238795325112867, 0.9039892931234433, 0.881921264348355, 0.8577286100002721, 0.8314696123025452, 0.8032075314806449, 0.773010453362737, 0.7409511253549591, 0.7071067811865476, 0.6715589548470184, 0.6343932841636455, 0.5956993044924334, 0.5555702330196022, 0.5141027441932218, 0.47139673682599764, 0.4275550934302821, 0.3826834323650898, 0.33688985339222005, 0.2902846772544624, 0.2429801799032639, 0.19509032201612828, 0.14673047445536175, 0.0980171403295606, 0.049067674327418015, 0.0, -0.049067674327418015, -0.0980171403295606, -0.14673047445536175, -0.19509032201612828, -0.2429801799032639, -0.2902846772544624, -0.33688985339222005, -0.3826834323650898, -0.4275550934302821, -0.47139673682599764, -0.5141027441932218, -0.5555702330196022, -0.5956993044924334, -0.6343932841636455, -0.6715589548470184, -0.7071067811865476, -0.7409511253549591, -0.773010453362737, -0.8032075314806449, -0.8314696123025452, -0.8577286100002721, -0.881921264348355, -0.9039892931234433, -0.9238795325112867, -0.9415440651830208, -0.9569403357322088, -0.970031253194544, -0.9807852804032304, -0.989176509964781, -0.9951847266721969, -0.9987954562051724, -1.0, -0.9987954562051724, -0.9951847266721969, -0.989176509964781, -0.9807852804032304, -0.970031253194544, -0.9569403357322088, -0.9415440651830208, -0.9238795325112867, -0.9039892931234433, -0.881921264348355, -0.8577286100002721, -0.8314696123025452, -0.8032075314806449, -0.773010453362737, -0.7409511253549591, -0.7071067811865476, -0.6715589548470184, -0.6343932841636455, -0.5956993044924334, -0.5555702330196022, -0.5141027441932218, -0.47139673682599764, -0.4275550934302821, -0.3826834323650898, -0.33688985339222005, -0.2902846772544624, -0.2429801799032639, -0.19509032201612828, -0.14673047445536175, -0.0980171403295606, -0.049067674327418015, 0.0, 0.049067674327418015, 0.0980171403295606, 0.14673047445536175, 0.19509032201612828, 0.2429801799032639, 0.2902846772544624, 0.33688985339222005, 0.3826834323650898, 0.4275550934302821, 0.47139673682599764, 0.5141027441932218, 0.5555702330196022, 0.5956993044924334, 0.6343932841636455, 0.6715589548470184, 0.7071067811865476, 0.7409511253549591, 0.773010453362737, 0.8032075314806449, 0.8314696123025452, 0.8577286100002721, 0.881921264348355, 0.9039892931234433, 0.9238795325112867, 0.9415440651830208, 0.9569403357322088, 0.970031253194544, 0.9807852804032304, 0.989176509964781, 0.9951847266721969, 0.9987954562051724],
    [1.0, 0.9972904566786902, 0.989176509964781, 0.9757021300385286, 0.9569403357322088, 0.9329927988347388, 0.9039892931234433, 0.8700869911087115, 0.8314696123025452, 0.7883464276266062, 0.7409511253549591, 0.6895405447370669, 0.6343932841636455, 0.5758081914178453, 0.5141027441932218, 0.4496113296546066, 0.3826834323650898, 0.31368174039889146, 0.2429801799032639, 0.17096188876030122, 0.0980171403295606, 0.024541228522912288, -0.049067674327418015, -0.1224106751992162, -0.19509032201612828, -0.26671275747489837, -0.33688985339222005, -0.40524131400498986, -0.47139673682599764, -0.5349976198870973, -0.5956993044924334, -0.6531728429537768, -0.7071067811865476, -0.7572088465064846, -0.8032075314806449, -0.8448535652497071, -0.881921264348355, -0.9142097557035307, -0.9415440651830208, -0.9637760657954398, -0.9807852804032304, -0.99247953459871, -0.9987954562051724, -0.9996988186962042, -0.9951847266721969, -0.9852776423889412, -0.970031253194544, -0.9495281805930367, -0.9238795325112867, -0.8932243011955153, -0.8577286100002721, -0.8175848131515837, -0.773010453362737, -0.7242470829514669, -0.6715589548470184, -0.6152315905806268, -0.5555702330196022, -0.49289819222978404, -0.4275550934302821, -0.35989503653498817, -0.2902846772544624, -0.2191012401568698, -0.14673047445536175, -0.07356456359966743, 0.0, 0.07356456359966743, 0.14673047445536175, 0.2191012401568698, 0.2902846772544624, 0.35989503653498817, 0.4275550934302821, 0.49289819222978404, 0.5555702330196022, 0.6152315905806268, 0.6715589548470184, 0.7242470829514669, 0.773010453362737, 0.8175848131515837, 0.8577286100002721, 0.8932243011955153, 0.9238795325112867, 0.9495281805930367, 0.970031253194544, 0.9852776423889412, 0.9951847266721969, 0.9996988186962042, 0.9987954562051724, 0.99247953459871, 0.9807852804032304, 0.9637760657954398, 0.9415440651830208, 0.9142097557035307, 0.881921264348355, 0.8448535652497071, 0.8032075314806449, 0.7572088465064846, 0.7071067811865476, 0.6531728429537768, 0.5956993044924334, 0.5349976198870973, 0.47139673682599764, 0.40524131400498986, 0.33688985339222005, 0.26671275747489837, 0.19509032201612828, 0.1224106751992162, 0.049067674327418015, -0.024541228522912288, -0.0980171403295606, -0.17096188876030122, -0.2429801799032639, -0.31368174039889146, -0.3826834323650898, -0.4496113296546066, -0.5141027441932218, -0.5758081914178453, -0.6343932841636455, -0.6895405447370669, -0.7409511253549591, -0.7883464276266062, -0.8314696123025452, -0.8700869911087115, -0.9039892931234433, -0.9329927988347388, -0.9569403357322088, -0.9757021300385286, -0.989176509964781, -0.9972904566786902],
    [1.0, 0.9951847266721969, 0.9807852804032304, 0.9569403357322088, 0.9238795325112867, 0.881921264348355, 0.8314696123025452, 0.773010453362737, 0.7071067811865476, 0.6343932841636455, 0.5555702330196022, 0.47139673682599764, 0.3826834323650898, 0.2902846772544624, 0.19509032201612828, 0.0980171403295606, 0.0, -0.0980171403295606, -0.19509032201612828, -0.2902846772544624, -0.3826834323650898, -0.47139673682599764, -0.5555702330196022, -0.6343932841636455, -0.7071067811865476, -0.773010453362737, -0.8314696123025452, -0.881921264348355, -0.9238795325112867, -0.9569403357322088, -0.9807852804032304, -0.9951847266721969, -1.0, -0.9951847266721969, -0.9807852804032304, -0.9569403357322088, -0.9238795325112867, -0.881921264348355, -0.8314696123025452, -0.773010453362737, -0.7071067811865476, -0.6343932841636455, -0.5555702330196022, -0.47139673682599764, -0.3826834323650898, -0.2902846772544624, -0.19509032201612828, -0.0980171403295606, 0.0, 0.0980171403295606, 0.19509032201612828, 0.2902846772544624, 0.3826834323650898, 0.47139673682599764, 0.5555702330196022, 0.6343932841636455, 0.7071067811865476, 0.773010453362737, 0.8314696123025452, 0.881921264348355, 0.9238795325112867, 0.9569403357322088, 0.9807852804032304, 0.9951847266721969, 1.0, 0.9951847266721969, 0.9807852804032304, 0.9569403357322088, 0.9238795325112867, 0.881921264348355, 0.8314696123025452, 0.773010453362737, 0.7071067811865476, 0.6343932841636455, 0.5555702330196022, 0.47139673682599764, 0.3826834323650898, 0.2902846772544624, 0.19509032201612828, 0.0980171403295606, 0.0, -0.0980171403295606, -0.19509032201612828, -0.2902846772544624, -0.3826834323650898, -0.47139673682599764, -0.5555702330196022, -0.6343932841636455, -0.7071067811865476, -0.773010453362737, -0.8314696123025452, -0.881921264348355, -0.9238795325112867, -0.9569403357322088, -0.9807852804032304, -0.9951847266721969, -1.0, -0.9951847266721969, -0.9807852804032304, -0.9569403357322088, -0.9238795325112867, -0.881921264348355, -0.8314696123025452, -0.773010453362737, -0.7071067811865476, -0.6343932841636455, -0.5555702330196022, -0.47139673682599764, -0.3826834323650898, -0.2902846772544624, -0.19509032201612828, -0.0980171403295606, 0.0, 0.0980171403295606, 0.19509032201612828, 0.2902846772544624, 0.3826834323650898, 0.47139673682599764, 0.5555702330196022, 0.6343932841636455, 0.7071067811865476, 0.773010453362737, 0.8314696123025452, 0.881921264348355, 0.9238795325112867, 0.9569403357322088, 0.9807852804032304, 0.9951847266721969],
    [1.0, 0.99247953459871, 0.970031253194544, 0.9329927988347388, 0.881921264348355, 0.8175848131515837, 0.7409511253549591, 0.6531728429537768, 0.5555702330196022, 0.4496113296546066, 0.33688985339222005, 0.2191012401568698, 0.0980171403295606, -0.024541228522912288, -0.14673047445536175, -0.26671275747489837, -0.3826834323650898, -0.49289819222978404, -0.5956993044924334, -0.6895405447370669, -0.773010453362737, -0.8448535652497071, -0.9039892931234433, -0.9495281805930367, -0.9807852804032304, -0.9972904566786902, -0.9987954562051724, -0.9852776423889412, -0.9569403357322088, -0.9142097557035307, -0.8577286100002721, -0.7883464276266062, -0.7071067811865476, -0.6152315905806268, -0.5141027441932218, -0.40524131400498986, -0.2902846772544624, -0.17096188876030122, -0.049067674327418015, 0.07356456359966743, 0.19509032201612828, 0.31368174039889146, 0.4275550934302821, 0.5349976198870973, 0.6343932841636455, 0.7242470829514669, 0.8032075314806449, 0.8700869911087115, 0.9238795325112867, 0.9637760657954398, 0.989176509964781, 0.9996988186962042, 0.9951847266721969, 0.9757021300385286, 0.9415440651830208, 0.8932243011955153, 0.8314696123025452, 0.7572088465064846, 0.6715589548470184, 0.5758081914178453, 0.47139673682599764, 0.35989503653498817, 0.2429801799032639, 0.1224106751992162, 0.0, -0.1224106751992162, -0.2429801799032639, -0.35989503653498817, -0.47139673682599764, -0.5758081914178453, -0.6715589548470184, -0.7572088465064846, -0.8314696123025452, -0.8932243011955153, -0.9415440651830208, -0.9757021300385286, -0.9951847266721969, -0.9996988186962042, -0.989176509964781, -0.9637760657954398, -0.9238795325112867, -0.8700869911087115, -0.8032075314806449, -0.7242470829514669, -0.6343932841636455, -0.5349976198870973, -0.4275550934302821, -0.31368174039889146, -0.19509032201612828, -0.07356456359966743, 0.049067674327418015, 0.17096188876030122, 0.2902846772544624, 0.40524131400498986, 0.5141027441932218, 0.6152315905806268, 0.7071067811865476, 0.7883464276266062, 0.8577286100002721, 0.9142097557035307, 0.9569403357322088, 0.9852776423889412, 0.9987954562051724, 0.9972904566786902, 0.9807852804032304, 0.9495281805930367, 0.9039892931234433, 0.8448535652497071, 0.773010453362737, 0.6895405447370669, 0.5956993044924334, 0.49289819222978404, 0.3826834323650898, 0.26671275747489837, 0.14673047445536175, 0.024541228522912288, -0.0980171403295606, -0.2191012401568698, -0.33688985339222005, -0.4496113296546066, -0.5555702330196022, -0.6531728429537768, -0.7409511253549591, -0.8175848131515837, -0.881921264348355, -0.9329927988347388, -0.970031253194544, -0.99247953459871],
    [1.0, 0.989176509964781, 0.9569403357322088, 0.9039892931234433, 0.8314696123025452, 0.7409511253549591, 0.6343932841636455, 0.5141027441932218, 0.3826834323650898, 0.2429801799032639, 0.0980171403295606, -0.049067674327418015, -0.19509032201612828, -0.33688985339222005, -0.47139673682599764, -0.5956993044924334, -0.7071067811865476, -0.8032075314806449, -0.881921264348355, -0.9415440651830208, -0.9807852804032304, -0.9987954562051724, -0.9951847266721969, -0.970031253194544, -0.9238795325112867, -0.8577286100002721, -0.773010453362737, -0.6715589548470184, -0.5555702330196022, -0.4275550934302821, -0.2902846772544624, -0.14673047445536175, 0.0, 0.14673047445536175, 0.2902846772544624, 0.4275550934302821, 0.5555702330196022, 0.6715589548470184, 0.773010453362737, 0.8577286100002721, 0.9238795325112867, 0.970031253194544, 0.9951847266721969, 0.9987954562051724, 0.9807852804032304, 0.9415440651830208, 0.881921264348355, 0.8032075314806449, 0.7071067811865476, 0.5956993044924334, 0.47139673682599764, 0.33688985339222005, 0.19509032201612828, 0.049067674327418015, -0.0980171403295606, -0.2429801799032639, -0.3826834323650898, -0.5141027441932218, -0.6343932841636455, -0.7409511253549591, -0.8314696123025452, -0.9039892931234433, -0.9569403357322088, -0.989176509964781, -1.0, -0.989176509964781, -0.9569403357322088, -0.9039892931234433, -0.8314696123025452, -0.7409511253549591, -0.6343932841636455, -0.5141027441932218, -0.3826834323650898, -0.2429801799032639, -0.0980171403295606, 0.049067674327418015, 0.19509032201612828, 0.33688985339222005, 0.47139673682599764, 0.5956993044924334, 0.7071067811865476, 0.8032075314806449, 0.881921264348355, 0.9415440651830208, 0.9807852804032304, 0.9987954562051724, 0.9951847266721969, 0.970031253194544, 0.9238795325112867, 0.8577286100002721, 0.773010453362737, 0.6715589548470184, 0.5555702330196022, 0.4275550934302821, 0.2902846772544624, 0.14673047445536175, 0.0, -0.14673047445536175, -0.2902846772544624, -0.4275550934302821, -0.5555702330196022, -0.6715589548470184, -0.773010453362737, -0.8577286100002721, -0.9238795325112867, -0.970031253194544, -0.9951847266721969, -0.9987954562051724, -0.9807852804032304, -0.9415440651830208, -0.881921264348355, -0.8032075314806449, -0.7071067811865476, -0.5956993044924334, -0.47139673682599764, -0.33688985339222005, -0.19509032201612828, -0.049067674327418015, 0.0980171403295606, 0.2429801799032639, 0.3826834323650898, 0.5141027441932218, 0.6343932841636455, 0.7409511253549591, 0.8314696123025452, 0.9039892931234433, 0.9569403357322088, 0.989176509964781],
    [1.0, 0.9852776423889412, 0.9415440651830208, 0.8700869911087115, 0.773010453362737, 0.6531728429537768, 0.5141027441932218, 0.35989503653498817, 0.19509032201612828, 0.024541228522912288, -0.14673047445536175, -0.31368174039889146, -0.47139673682599764, -0.6152315905806268, -0.7409511253549591, -0.8448535652497071, -0.9238795325112867, -0.9757021300385286, -0.9987954562051724, -0.99247953459871, -0.9569403357322088, -0.8932243011955153, -0.8032075314806449, -0.6895405447370669, -0.5555702330196022, -0.40524131400498986, -0.2429801799032639, -0.07356456359966743, 0.0980171403295606, 0.26671275747489837, 0.4275550934302821, 0.5758081914178453, 0.7071067811865476, 0.8175848131515837, 0.9039892931234433, 0.9637760657954398, 0.9951847266721969, 0.9972904566786902, 0.970031253194544, 0.9142097557035307, 0.8314696123025452, 0.7242470829514669, 0.5956993044924334, 0.4496113296546066, 0.2902846772544624, 0.1224106751992162, -0.049067674327418015, -0.2191012401568698, -0.3826834323650898, -0.5349976198870973, -0.6715589548470184, -0.7883464276266062, -0.881921264348355, -0.9495281805930367, -0.989176509964781, -0.9996988186962042, -0.9807852804032304, -0.9329927988347388, -0.8577286100002721, -0.7572088465064846, -0.6343932841636455, -0.49289819222978404, -0.33688985339222005, -0.17096188876030122, 0.0, 0.17096188876030122, 0.33688985339222005, 0.49289819222978404, 0.6343932841636455, 0.7572088465064846, 0.8577286100002721, 0.9329927988347388, 0.9807852804032304, 0.9996988186962042, 0.989176509964781, 0.9495281805930367, 0.881921264348355, 0.7883464276266062, 0.6715589548470184, 0.5349976198870973, 0.3826834323650898, 0.2191012401568698, 0.049067674327418015, -0.1224106751992162, -0.2902846772544624, -0.4496113296546066, -0.5956993044924334, -0.7242470829514669, -0.8314696123025452, -0.9142097557035307, -0.970031253194544, -0.9972904566786902, -0.9951847266721969, -0.9637760657954398, -0.9039892931234433, -0.8175848131515837, -0.7071067811865476, -0.5758081914178453, -0.4275550934302821, -0.26671275747489837, -0.0980171403295606, 0.07356456359966743, 0.2429801799032639, 0.40524131400498986, 0.5555702330196022, 0.6895405447370669, 0.8032075314806449, 0.8932243011955153, 0.9569403357322088, 0.99247953459871, 0.9987954562051724, 0.9757021300385286, 0.9238795325112867, 0.8448535652497071, 0.7409511253549591, 0.6152315905806268, 0.47139673682599764, 0.31368174039889146, 0.14673047445536175, -0.024541228522912288, -0.19509032201612828, -0.35989503653498817, -0.5141027441932218, -0.6531728429537768, -0.773010453362737, -0.8700869911087115, -0.9415440651830208, -0.9852776423889412],
    [1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304],
])
_GENERAL_PRRPRR_GRID_S = np.array([
    [0.0, 0.024541228522912288, 0.049067674327418015, 0.07356456359966743, 0.0980171403295606, 0.1224106751992162, 0.14673047445536175, 0.17096188876030122, 0.19509032201612828, 0.2191012401568698, 0.2429801799032639, 0.26671275747489837, 0.2902846772544624, 0.31368174039889146, 0.33688985339222005, 0.35989503653498817, 0.3826834323650898, 0.40524131400498986, 0.4275550934302821, 0.4496113296546066, 0.47139673682599764, 0.49289819222978404, 0.5141027441932218, 0.5349976198870973, 0.5555702330196022, 0.5758081914178453, 0.5956993044924334, 0.6152315905806268, 0.6343932841636455, 0.6531728429537768, 0.6715589548470184, 0.6895405447370669, 0.7071067811865476, 0.7242470829514669, 0.7409511253549591, 0.7572088465064846, 0.773010453362737, 0.7883464276266062, 0.8032075314806449, 0.8175848131515837, 0.8314696123025452, 0.8448535652497071, 0.8577286100002721, 0.8700869911087115, 0.881921264348355, 0.8932243011955153, 0.9039892931234433, 0.9142097557035307, 0.9238795325112867, 0.9329927988347388, 0.9415440651830208, 0.9495281805930367, 0.9569403357322088, 0.9637760657954398, 0.970031253194544, 0.9757021300385286, 0.9807852804032304, 0.9852776423889412, 0.989176509964781, 0.99247953459871, 0.9951847266721969, 0.9972904566786902, 0.9987954562051724, 0.9996988186962042, 1.0, 0.9996988186962042, 0.9987954562051724, 0.9972904566786902, 0.9951847266721969, 0.99247953459871, 0.989176509964781, 0.9852776423889412, 0.9807852804032304, 0.9757021300385286, 0.970031253194544, 0.9637760657954398, 0.9569403357322088, 0.9495281805930367, 0.9415440651830208, 0.9329927988347388, 0.9238795325112867, 0.9142097557035307, 0.9039892931234433, 0.8932243011955153, 0.881921264348355, 0.8700869911087115, 0.8577286100002721, 0.8448535652497071, 0.8314696123025452, 0.8175848131515837, 0.8032075314806449, 0.7883464276266062, 0.773010453362737, 0.7572088465064846, 0.7409511253549591, 0.7242470829514669, 0.7071067811865476, 0.6895405447370669, 0.6715589548470184, 0.6531728429537768, 0.6343932841636455, 0.6152315905806268, 0.5956993044924334, 0.5758081914178453, 0.5555702330196022, 0.5349976198870973, 0.5141027441932218, 0.49289819222978404, 0.47139673682599764, 0.4496113296546066, 0.4275550934302821, 0.40524131400498986, 0.3826834323650898, 0.35989503653498817, 0.33688985339222005, 0.31368174039889146, 0.2902846772544624, 0.26671275747489837, 0.2429801799032639, 0.2191012401568698, 0.19509032201612828, 0.17096188876030122, 0.14673047445536175, 0.1224106751992162, 0.0980171403295606, 0.07356456359966743, 0.049067674327418015, 0.024541228522912288],
    [0.0, 0.049067674327418015, 0.0980171403295606, 0.14673047445536175, 0.19509032201612828, 0.2429801799032639, 0.2902846772544624, 0.33688985339222005, 0.3826834323650898, 0.4275550934302821, 0.47139673682599764, 0.5141027441932218, 0.5555702330196022, 0.5956993044924334, 0.6343932841636455, 0.6715589548470184, 0.7071067811865476, 0.7409511253549591, 0.773010453362737, 0.8032075314806449, 0.8314696123025452, 0.8577286100002721, 0.881921264348355, 0.9039892931234433, 0.9238795325112867, 0.9415440651830208, 0.9569403357322088, 0.970031253194544, 0.9807852804032304, 0.989176509964781, 0.9951847266721969, 0.9987954562051724, 1.0, 0.9987954562051724, 0.9951847266721969, 0.989176509964781, 0.9807852804032304, 0.970031253194544, 0.9569403357322088, 0.9415440651830208, 0.9238795325112867, 0.9039892931234433, 0.881921264348355, 0.8577286100002721, 0.8314696123025452, 0.8032075314806449, 0.773010453362737, 0.7409511253549591, 0.7071067811865476, 0.6715589548470184, 0.6343932841636455, 0.5956993044924334, 0.5555702330196022, 0.5141027441932218, 0.47139673682599764, 0.4275550934302821, 0.3826834323650898, 0.33688985339222005, 0.2902846772544624, 0.2429801799032639, 0.19509032201612828, 0.14673047445536175, 0.0980171403295606, 0.049067674327418015, 0.0, -0.049067674327418015, -0.0980171403295606, -0.14673047445536175, -0.19509032201612828, -0.2429801799032639, -0.2902846772544624, -0.33688985339222005, -0.3826834323650898, -0.4275550934302821, -0.47139673682599764, -0.5141027441932218, -0.5555702330196022, -0.5956993044924334, -0.6343932841636455, -0.6715589548470184, -0.7071067811865476, -0.7409511253549591, -0.773010453362737, -0.8032075314806449, -0.8314696123025452, -0.8577286100002721, -0.881921264348355, -0.9039892931234433, -0.9238795325112867, -0.9415440651830208, -0.9569403357322088, -0.970031253194544, -0.9807852804032304, -0.989176509964781, -0.9951847266721969, -0.9987954562051724, -1.0, -0.9987954562051724, -0.9951847266721969, -0.989176509964781, -0.9807852804032304, -0.970031253194544, -0.9569403357322088, -0.9415440651830208, -0.9238795325112867, -0.9039892931234433, -0.881921264348355, -0.8577286100002721, -0.8314696123025452, -0.8032075314806449, -0.773010453362737, -0.7409511253549591, -0.7071067811865476, -0.6715589548470184, -0.6343932841636455, -0.5956993044924334, -0.5555702330196022, -0.5141027441932218, -0.47139673682599764, -0.4275550934302821, -0.3826834323650898, -0.33688985339222005, -0.2902846772544624, -0.2429801799032639, -0.19509032201612828, -0.14673047445536175, -0.0980171403295606, -0.049067674327418015],
    [0.0, 0.07356456359966743, 0.14673047445536175, 0.2191012401568698, 0.2902846772544624, 0.35989503653498817, 0.4275550934302821, 0.49289819222978404, 0.5555702330196022, 0.6152315905806268, 0.6715589548470184, 0.7242470829514669, 0.773010453362737, 0.8175848131515837, 0.8577286100002721, 0.8932243011955153, 0.9238795325112867, 0.9495281805930367, 0.970031253194544, 0.9852776423889412, 0.9951847266721969, 0.9996988186962042, 0.9987954562051724, 0.99247953459871, 0.9807852804032304, 0.9637760657954398, 0.9415440651830208, 0.9142097557035307, 0.881921264348355, 0.8448535652497071, 0.8032075314806449, 0.7572088465064846, 0.7071067811865476, 0.6531728429537768, 0.5956993044924334, 0.5349976198870973, 0.47139673682599764, 0.40524131400498986, 0.33688985339222005, 0.26671275747489837, 0.19509032201612828, 0.1224106751992162, 0.049067674327418015, -0.024541228522912288, -0.0980171403295606, -0.17096188876030122, -0.2429801799032639, -0.31368174039889146, -0.3826834323650898, -0.4496113296546066, -0.5141027441932218, -0.5758081914178453, -0.6343932841636455, -0.6895405447370669, -0.7409511253549591, -0.7883464276266062, -0.8314696123025452, -0.8700869911087115, -0.9039892931234433, -0.9329927988347388, -0.9569403357322088, -0.9757021300385286, -0.989176509964781, -0.9972904566786902, -1.0, -0.9972904566786902, -0.989176509964781, -0.9757021300385286, -0.9569403357322088, -0.9329927988347388, -0.9039892931234433, -0.8700869911087115, -0.8314696123025452, -0.7883464276266062, -0.7409511253549591, -0.6895405447370669, -0.6343932841636455, -0.5758081914178453, -0.5141027441932218, -0.4496113296546066, -0.3826834323650898, -0.31368174039889146, -0.2429801799032639, -0.17096188876030122, -0.0980171403295606, -0.024541228522912288, 0.049067674327418015, 0.1224106751992162, 0.19509032201612828, 0.26671275747489837, 0.33688985339222005, 0.40524131400498986, 0.47139673682599764, 0.5349976198870973, 0.5956993044924334, 0.6531728429537768, 0.7071067811865476, 0.7572088465064846, 0.8032075314806449, 0.8448535652497071, 0.881921264348355, 0.9142097557035307, 0.9415440651830208, 0.9637760657954398, 0.9807852804032304, 0.99247953459871, 0.9987954562051724, 0.9996988186962042, 0.9951847266721969, 0.9852776423889412, 0.970031253194544, 0.9495281805930367, 0.9238795325112867, 0.8932243011955153, 0.8577286100002721, 0.8175848131515837, 0.773010453362737, 0.7242470829514669, 0.6715589548470184, 0.6152315905806268, 0.5555702330196022, 0.49289819222978404, 0.4275550934302821, 0.35989503653498817, 0.2902846772544624, 0.2191012401568698, 0.14673047445536175, 0.07356456359966743],
    [0.0, 0.0980171403295606, 0.19509032201612828, 0.2902846772544624, 0.3826834323650898, 0.47139673682599764, 0.5555702330196022, 0.6343932841636455, 0.7071067811865476, 0.773010453362737, 0.8314696123025452, 0.881921264348355, 0.9238795325112867, 0.9569403357322088, 0.9807852804032304, 0.9951847266721969, 1.0, 0.9951847266721969, 0.9807852804032304, 0.9569403357322088, 0.9238795325112867, 0.881921264348355, 0.8314696123025452, 0.773010453362737, 0.7071067811865476, 0.6343932841636455, 0.5555702330196022, 0.47139673682599764, 0.3826834323650898, 0.2902846772544624, 0.19509032201612828, 0.0980171403295606, 0.0, -0.0980171403295606, -0.19509032201612828, -0.2902846772544624, -0.3826834323650898, -0.47139673682599764, -0.5555702330196022, -0.6343932841636455, -0.7071067811865476, -0.773010453362737, -0.8314696123025452, -0.881921264348355, -0.9238795325112867, -0.9569403357322088, -0.9807852804032304, -0.9951847266721969, -1.0, -0.9951847266721969, -0.9807852804032304, -0.9569403357322088, -0.9238795325112867, -0.881921264348355, -0.8314696123025452, -0.773010453362737, -0.7071067811865476, -0.6343932841636455, -0.5555702330196022, -0.47139673682599764, -0.3826834323650898, -0.2902846772544624, -0.19509032201612828, -0.0980171403295606, 0.0, 0.0980171403295606, 0.19509032201612828, 0.2902846772544624, 0.3826834323650898, 0.47139673682599764, 0.5555702330196022, 0.6343932841636455, 0.7071067811865476, 0.773010453362737, 0.8314696123025452, 0.881921264348355, 0.9238795325112867, 0.9569403357322088, 0.9807852804032304, 0.9951847266721969, 1.0, 0.9951847266721969, 0.9807852804032304, 0.9569403357322088, 0.9238795325112867, 0.881921264348355, 0.8314696123025452, 0.773010453362737, 0.7071067811865476, 0.6343932841636455, 0.5555702330196022, 0.47139673682599764, 0.3826834323650898, 0.2902846772544624, 0.19509032201612828, 0.0980171403295606, 0.0, -0.0980171403295606, -0.19509032201612828, -0.2902846772544624, -0.3826834323650898, -0.47139673682599764, -0.5555702330196022, -0.6343932841636455, -0.7071067811865476, -0.773010453362737, -0.8314696123025452, -0.881921264348355, -0.9238795325112867, -0.9569403357322088, -0.9807852804032304, -0.9951847266721969, -1.0, -0.9951847266721969, -0.9807852804032304, -0.9569403357322088, -0.9238795325112867, -0.881921264348355, -0.8314696123025452, -0.773010453362737, -0.7071067811865476, -0.6343932841636455, -0.5555702330196022, -0.47139673682599764, -0.3826834323650898, -0.2902846772544624, -0.19509032201612828, -0.0980171403295606],
    [0.0, 0.1224106751992162, 0.2429801799032639, 0.35989503653498817, 0.47139673682599764, 0.5758081914178453, 0.6715589548470184, 0.7572088465064846, 0.8314696123025452, 0.8932243011955153, 0.9415440651830208, 0.9757021300385286, 0.9951847266721969, 0.9996988186962042, 0.989176509964781, 0.9637760657954398, 0.9238795325112867, 0.8700869911087115, 0.8032075314806449, 0.7242470829514669, 0.6343932841636455, 0.5349976198870973, 0.4275550934302821, 0.31368174039889146, 0.19509032201612828, 0.07356456359966743, -0.049067674327418015, -0.17096188876030122, -0.2902846772544624, -0.40524131400498986, -0.5141027441932218, -0.6152315905806268, -0.7071067811865476, -0.7883464276266062, -0.8577286100002721, -0.9142097557035307, -0.9569403357322088, -0.9852776423889412, -0.9987954562051724, -0.9972904566786902, -0.9807852804032304, -0.9495281805930367, -0.9039892931234433, -0.8448535652497071, -0.773010453362737, -0.6895405447370669, -0.5956993044924334, -0.49289819222978404, -0.3826834323650898, -0.26671275747489837, -0.14673047445536175, -0.024541228522912288, 0.0980171403295606, 0.2191012401568698, 0.33688985339222005, 0.4496113296546066, 0.5555702330196022, 0.6531728429537768, 0.7409511253549591, 0.8175848131515837, 0.881921264348355, 0.9329927988347388, 0.970031253194544, 0.99247953459871, 1.0, 0.99247953459871, 0.970031253194544, 0.9329927988347388, 0.881921264348355, 0.8175848131515837, 0.7409511253549591, 0.6531728429537768, 0.5555702330196022, 0.4496113296546066, 0.33688985339222005, 0.2191012401568698, 0.0980171403295606, -0.024541228522912288, -0.14673047445536175, -0.26671275747489837, -0.3826834323650898, -0.49289819222978404, -0.5956993044924334, -0.6895405447370669, -0.773010453362737, -0.8448535652497071, -0.9039892931234433, -0.9495281805930367, -0.9807852804032304, -0.9972904566786902, -0.9987954562051724, -0.9852776423889412, -0.9569403357322088, -0.9142097557035307, -0.8577286100002721, -0.7883464276266062, -0.7071067811865476, -0.6152315905806268, -0.5141027441932218, -0.40524131400498986, -0.2902846772544624, -0.17096188876030122, -0.049067674327418015, 0.07356456359966743, 0.19509032201612828, 0.31368174039889146, 0.4275550934302821, 0.5349976198870973, 0.6343932841636455, 0.7242470829514669, 0.8032075314806449, 0.8700869911087115, 0.9238795325112867, 0.9637760657954398, 0.989176509964781, 0.9996988186962042, 0.9951847266721969, 0.9757021300385286, 0.9415440651830208, 0.8932243011955153, 0.8314696123025452, 0.7572088465064846, 0.6715589548470184, 0.5758081914178453, 0.47139673682599764, 0.35989503653498817, 0.2429801799032639, 0.1224106751992162],
    [0.0, 0.14673047445536175, 0.2902846772544624, 0.4275550934302821, 0.5555702330196022, 0.6715589548470184, 0.773010453362737, 0.8577286100002721, 0.9238795325112867, 0.970031253194544, 0.9951847266721969, 0.9987954562051724, 0.9807852804032304, 0.9415440651830208, 0.881921264348355, 0.8032075314806449, 0.7071067811865476, 0.5956993044924334, 0.47139673682599764, 0.33688985339222005, 0.19509032201612828, 0.049067674327418015, -0.0980171403295606, -0.2429801799032639, -0.3826834323650898, -0.5141027441932218, -0.6343932841636455, -0.7409511253549591, -0.8314696123025452, -0.9039892931234433, -0.9569403357322088, -0.989176509964781, -1.0, -0.989176509964781, -0.9569403357322088, -0.9039892931234433, -0.8314696123025452, -0.7409511253549591, -0.6343932841636455, -0.5141027441932218, -0.3826834323650898, -0.2429801799032639, -0.0980171403295606, 0.049067674327418015, 0.19509032201612828, 0.33688985339222005, 0.47139673682599764, 0.5956993044924334, 0.7071067811865476, 0.8032075314806449, 0.881921264348355, 0.9415440651830208, 0.9807852804032304, 0.9987954562051724, 0.9951847266721969, 0.970031253194544, 0.9238795325112867, 0.8577286100002721, 0.773010453362737, 0.6715589548470184, 0.5555702330196022, 0.4275550934302821, 0.2902846772544624, 0.14673047445536175, 0.0, -0.14673047445536175, -0.2902846772544624, -0.4275550934302821, -0.5555702330196022, -0.6715589548470184, -0.773010453362737, -0.8577286100002721, -0.9238795325112867, -0.970031253194544, -0.9951847266721969, -0.9987954562051724, -0.9807852804032304, -0.9415440651830208, -0.881921264348355, -0.8032075314806449, -0.7071067811865476, -0.5956993044924334, -0.47139673682599764, -0.33688985339222005, -0.19509032201612828, -0.049067674327418015, 0.0980171403295606, 0.2429801799032639, 0.3826834323650898, 0.5141027441932218, 0.6343932841636455, 0.7409511253549591, 0.8314696123025452, 0.9039892931234433, 0.9569403357322088, 0.989176509964781, 1.0, 0.989176509964781, 0.9569403357322088, 0.9039892931234433, 0.8314696123025452, 0.7409511253549591, 0.6343932841636455, 0.5141027441932218, 0.3826834323650898, 0.2429801799032639, 0.0980171403295606, -0.049067674327418015, -0.19509032201612828, -0.33688985339222005, -0.47139673682599764, -0.5956993044924334, -0.7071067811865476, -0.8032075314806449, -0.881921264348355, -0.9415440651830208, -0.9807852804032304, -0.9987954562051724, -0.9951847266721969, -0.970031253194544, -0.9238795325112867, -0.8577286100002721, -0.773010453362737, -0.6715589548470184, -0.5555702330196022, -0.4275550934302821, -0.2902846772544624, -0.14673047445536175],
    [0.0, 0.17096188876030122, 0.33688985339222005, 0.49289819222978404, 0.6343932841636455, 0.7572088465064846, 0.8577286100002721, 0.9329927988347388, 0.9807852804032304, 0.9996988186962042, 0.989176509964781, 0.9495281805930367, 0.881921264348355, 0.7883464276266062, 0.6715589548470184, 0.5349976198870973, 0.3826834323650898, 0.2191012401568698, 0.049067674327418015, -0.1224106751992162, -0.2902846772544624, -0.4496113296546066, -0.5956993044924334, -0.7242470829514669, -0.8314696123025452, -0.9142097557035307, -0.970031253194544, -0.9972904566786902, -0.9951847266721969, -0.9637760657954398, -0.9039892931234433, -0.8175848131515837, -0.7071067811865476, -0.5758081914178453, -0.4275550934302821, -0.26671275747489837, -0.0980171403295606, 0.07356456359966743, 0.2429801799032639, 0.40524131400498986, 0.5555702330196022, 0.6895405447370669, 0.8032075314806449, 0.8932243011955153, 0.9569403357322088, 0.99247953459871, 0.9987954562051724, 0.9757021300385286, 0.9238795325112867, 0.8448535652497071, 0.7409511253549591, 0.6152315905806268, 0.47139673682599764, 0.31368174039889146, 0.14673047445536175, -0.024541228522912288, -0.19509032201612828, -0.35989503653498817, -0.5141027441932218, -0.6531728429537768, -0.773010453362737, -0.8700869911087115, -0.9415440651830208, -0.9852776423889412, -1.0, -0.9852776423889412, -0.9415440651830208, -0.8700869911087115, -0.773010453362737, -0.6531728429537768, -0.5141027441932218, -0.35989503653498817, -0.19509032201612828, -0.024541228522912288, 0.14673047445536175, 0.31368174039889146, 0.47139673682599764, 0.6152315905806268, 0.7409511253549591, 0.8448535652497071, 0.9238795325112867, 0.9757021300385286, 0.9987954562051724, 0.99247953459871, 0.9569403357322088, 0.8932243011955153, 0.8032075314806449, 0.6895405447370669, 0.5555702330196022, 0.40524131400498986, 0.2429801799032639, 0.07356456359966743, -0.0980171403295606, -0.26671275747489837, -0.4275550934302821, -0.5758081914178453, -0.7071067811865476, -0.8175848131515837, -0.9039892931234433, -0.9637760657954398, -0.9951847266721969, -0.9972904566786902, -0.970031253194544, -0.9142097557035307, -0.8314696123025452, -0.7242470829514669, -0.5956993044924334, -0.4496113296546066, -0.2902846772544624, -0.1224106751992162, 0.049067674327418015, 0.2191012401568698, 0.3826834323650898, 0.5349976198870973, 0.6715589548470184, 0.7883464276266062, 0.881921264348355, 0.9495281805930367, 0.989176509964781, 0.9996988186962042, 0.9807852804032304, 0.9329927988347388, 0.8577286100002721, 0.7572088465064846, 0.6343932841636455, 0.49289819222978404, 0.33688985339222005, 0.17096188876030122],
    [0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828, 0.0, 0.19509032201612828, 0.3826834323650898, 0.5555702330196022, 0.7071067811865476, 0.8314696123025452, 0.9238795325112867, 0.9807852804032304, 1.0, 0.9807852804032304, 0.9238795325112867, 0.8314696123025452, 0.7071067811865476, 0.5555702330196022, 0.3826834323650898, 0.19509032201612828, 0.0, -0.19509032201612828, -0.3826834323650898, -0.5555702330196022, -0.7071067811865476, -0.8314696123025452, -0.9238795325112867, -0.9807852804032304, -1.0, -0.9807852804032304, -0.9238795325112867, -0.8314696123025452, -0.7071067811865476, -0.5555702330196022, -0.3826834323650898, -0.19509032201612828],
])


@_inner
def _general_prrprr_follow(T, K):
    """T K for rigid transforms, twelve numbers each, in place."""
    for i in range(0, 12, 4):
        a, b, c = T[i], T[i + 1], T[i + 2]
        for j in range(3):
            T[i + j] = a * K[j] + b * K[4 + j] + c * K[8 + j]
        T[i + 3] += a * K[3] + b * K[7] + c * K[11]


@_inner
def _general_prrprr_invert(A):
    """The inverse of a rigid transform."""
    B = np.empty(12)
    for i in range(3):
        for j in range(3):
            B[4 * i + j] = A[4 * j + i]
        B[4 * i + 3] = -(A[i] * A[3] + A[4 + i] * A[7] + A[8 + i] * A[11])
    return B


@_inner
def _general_prrprr_turn(T, c, s):
    """T Rz, in place."""
    for i in range(3):
        x, y = T[4 * i], T[4 * i + 1]
        T[4 * i] = x * c + y * s
        T[4 * i + 1] = y * c - x * s


@_inner
def _general_prrprr_slide(T, d):
    """T Tz, in place."""
    for i in range(3):
        T[4 * i + 3] += T[4 * i + 2] * d


@_inner
def _general_prrprr_move(T, joint, c, s):
    """The motion of a joint, by cosine and sine or by a length that stands in the sine's place."""
    if joint in (0, 3):
        _general_prrprr_slide(T, s)
        return
    _general_prrprr_turn(T, c, s)


@_inner
def _general_prrprr_close(T):
    """The loop: K0 ... K4 and its pose P = L T R, in arm sizes; in its place L stands before, then R."""
    links, first = np.empty((7, 12)), (0, 1, 2, 3, 4, 5, 6)
    for i in range(7):
        _take(links[i], _GENERAL_PRRPRR_CONSTANTS[first[i]])
    _general_prrprr_follow(links[5], T)
    _general_prrprr_follow(links[5], links[6])
    for i in range(3):
        links[5, 4 * i + 3] *= 1.9272036946544462
    return links


@_inner
def _general_prrprr_unit(c, s):
    """A cosine and a sine without their common factor, which is told while it has a square."""
    length = math.sqrt(c * c + s * s)
    if not 1e-150 < length < math.inf:
        return 1.0, 0.0
    return c / length, s / length


@_inner
def _general_prrprr_reflect(M, first, rest, column):
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
def _general_prrprr_around(form, loop):
    """The links L0 ... L5 of a formulation."""
    links = np.empty((6, 12))
    for i in range(6):
        joint = _GENERAL_PRRPRR_JOINTS[form, i]
        if _GENERAL_PRRPRR_SIGNS[form] > 0.0:
            _take(links[i], loop[joint] if joint < 5 else _general_prrprr_invert(loop[5]))
        else:
            _take(links[i], _general_prrprr_invert(loop[joint - 1]) if joint > 0 else loop[5])
    return links


@_inner
def _general_prrprr_at(f, x):
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
def _general_prrprr_fit(samples):
    """The coefficients from 24 samples, the largest sample, and the harmonics beyond the eighth."""
    h = np.zeros(24)
    scale = 0.0
    for k in range(24):
        scale = max(scale, abs(samples[k]))
        for j in range(24):
            h[j] += samples[k] * _GENERAL_PRRPRR_HARMONICS[k, j]
    beyond = 0.0
    for j in range(17, 24):
        beyond = max(beyond, abs(h[j]))
    return h, scale, beyond / scale if scale > 0.0 else 1.0


@_inner
def _general_prrprr_grid(f):
    """f, f', f'', a row each, at the edges of the cells; the first edge stands at the end again."""
    grid = np.empty((3, 257))
    value, slope, bend = grid
    for i in range(128):
        even = uneven = even_slope = uneven_slope = even_bend = uneven_bend = 0.0
        for m in range(1, 9):
            c, s = _GENERAL_PRRPRR_GRID_C[m - 1, i], _GENERAL_PRRPRR_GRID_S[m - 1, i]
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
def _general_prrprr_rootless(grid, zero):
    """In which cells f has no root, as `_general_prrprr_kind` tells it one by one: most of them."""
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
def _general_prrprr_kind(low, high, h, scale, rounding, touching):
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
def _general_prrprr_between(f, order, low, high, rising):
    """Where f (order 0) or f' (order 1) vanishes between two angles at which it has unlike signs:
    Newton, with bisection where it leaves. `rising` says that it is negative at the lower one."""
    x = 0.5 * (low + high)
    for _ in range(48):
        at = _general_prrprr_at(f, x)
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
def _general_prrprr_few(f, rounding, touching, near, low, at_low, high, at_high, roots, counts):
    """The roots of a cell where f has one extremum at most, into roots[0] (simple) or [1] (double), or
    [2] where f turns back beside zero: no root, unless rounding of what f is made of lifted it off."""
    middle, at_middle = high, at_high[0]
    if at_low[1] * at_high[1] < 0.0:
        middle = _general_prrprr_between(f, 1, low, high, at_low[1] < 0.0)
        at_middle, _, bend = _general_prrprr_at(f, middle)
        lifted = at_middle * bend > 0.0 and abs(at_middle) <= max(abs(bend) * near, touching)
        if abs(at_middle) <= rounding or lifted:
            _general_prrprr_add_root(roots, counts, 1 if abs(at_middle) <= rounding else 2, middle)
            return
        if (at_middle < 0.0) != (at_high[0] < 0.0):
            x = _general_prrprr_between(f, 0, middle, high, at_middle < 0.0)
            _general_prrprr_add_root(roots, counts, 0, x)
    if (at_low[0] < 0.0) != (at_middle < 0.0):
        _general_prrprr_add_root(roots, counts, 0, _general_prrprr_between(f, 0, low, middle, at_low[0] < 0.0))


@_apart("void(float64[:, ::1], int64[::1], int64, float64)")
def _general_prrprr_add_root(roots, counts, kind, x):
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
def _general_prrprr_find_roots(f, scale, rounding, middle, reach, near):
    """The simple roots, roots[0, : counts[0]], the double ones, roots[1, : counts[1]], and the places
    where f turns back beside zero, roots[2, : counts[2]], in so many cells on both sides of the middle
    one. These are where the value of a parabola over its bend is below `near`."""
    roots = np.empty((3, 24))
    counts = np.array([0, 0, 0, 1, 0])
    grid = _general_prrprr_grid(f)
    touching = rounding + scale * 2e-09  # by this rounding may lift four roots that meet
    rootless = _general_prrprr_rootless(grid, max(rounding + scale * 2e-09, touching))
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
            kind = _general_prrprr_kind(at_low, at[top], h, scale, rounding, touching)
            if kind == 2:
                _general_prrprr_few(
                    f, rounding, touching, near, low, at_low, edge[top], at[top], roots, counts
                )
            elif kind == 1 or (kind == 3 and (depth[top] == 14 or budget == 0)):
                counts[3] = 0
                _general_prrprr_add_root(roots, counts, 1, low + 0.5 * h)
            elif kind == 3:
                budget -= 1
                edge[waiting] = low + 0.5 * h
                depth[top] += 1
                depth[waiting] = depth[top]
                at[waiting, 0], at[waiting, 1], at[waiting, 2] = _general_prrprr_at(f, edge[waiting])
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
def _general_prrprr_through(x, y, c, s):
    """Cosine and sine of phi from those of psi, and |1 + conj(a) w|^16, which makes of f a polynomial
    in psi."""
    u, v, d, e = c + x, s + y, 1.0 + x * c + y * s, x * s - y * c
    square = d * d + e * e
    return (u * d + v * e) / square, (v * d - u * e) / square, square**8


@_inner
def _general_prrprr_spread(samples):
    """The lens under which the roots are spread, from samples without one; 0, 0 when they are already.
    log |f| is a sum over the roots z, and the first harmonic of log |e^(i phi) - z| is -z for z inside
    the circle, that of its mirror image for z outside."""
    x = y = 0.0
    for k in range(12):
        ratio = math.log((abs(samples[k]) + 1e-300) / (abs(samples[k + 12]) + 1e-300))
        x += ratio * _GENERAL_PRRPRR_SAMPLE_C[k]
        y += ratio * _GENERAL_PRRPRR_SAMPLE_S[k]
    x, y = -0.005208333333333333 * x, -0.005208333333333333 * y
    square = x * x + y * y
    if not square > 0.12249999999999998:
        return 0.0, 0.0
    part = min(1.0, 0.9 / math.sqrt(square))
    return part * x, part * y


@_inner
def _general_prrprr_behind(x, y, roots, counts):
    """The roots as they are without the lens."""
    for kind in range(3):
        for i in range(counts[kind]):
            c, s, _ = _general_prrprr_through(x, y, math.cos(roots[kind, i]), math.sin(roots[kind, i]))
            roots[kind, i] = math.atan2(s, c)


@_inner
def _general_prrprr_seen(samples, x, y, middle, reach, near):
    """The roots that samples through a lens show: (the noise of the samples, the roots, their
    counts)."""""
    f, scale, noise = _general_prrprr_fit(samples)
    rounding = scale * (3e-15 + 64.0 * noise)
    roots, counts = _general_prrprr_find_roots(f, scale, rounding, middle, reach, near)
    _general_prrprr_behind(x, y, roots, counts)
    return noise, roots, counts


@_inner
def _general_prrprr_near(x, middle):
    """Whether an angle is as near to another as a closer look reaches."""
    return math.cos(x - middle) >= 0.9980487804878049


@_apart("void(float64[:, ::1], int64[::1], float64[:, ::1], int64[::1], float64)")
def _general_prrprr_replace(roots, counts, closer, closer_counts, middle):
    """Of the roots those near to an angle are replaced by what a closer look shows there."""
    for twice in range(2):
        kept = 0
        for i in range(counts[twice]):
            if not _general_prrprr_near(roots[twice, i], middle):
                roots[twice, kept] = roots[twice, i]
                kept += 1
        for i in range(closer_counts[twice]):
            if _general_prrprr_near(closer[twice, i], middle) and kept < 24:
                roots[twice, kept] = closer[twice, i]
                kept += 1
        counts[twice] = kept


@_inner
def _general_prrprr_any_near(roots, counts, middle):
    """Whether any root is near to an angle."""
    near = False
    for twice in range(2):
        for i in range(counts[twice]):
            near = near or _general_prrprr_near(roots[twice, i], middle)
    return near


@_inner
def _general_prrprr_next_double(roots, counts, seen, looks):
    """The first double root that nothing has looked at more closely; their count if there is none."""
    for i in range(counts[1]):
        near = False
        for k in range(looks):
            near = near or _general_prrprr_near(roots[1, i], seen[k])
        if not near:
            return i
    return counts[1]


@_inner
def _general_prrprr_marked(marks):
    """How many marks of the first kind are set."""
    count = 0
    for mark in marks:
        count += mark & 1
    return count


@_inner
def _general_prrprr_error(links, c, s, J):
    """The square of the loop's error; J takes the Jacobian with the error, translation and rotation
    vector, as seventh column."""
    P = links[5]
    T = carray(_room(12), 12)
    T[:] = 0.0
    T[0] = T[5] = T[10] = 1.0
    for k in range(6):
        if k:
            _general_prrprr_follow(T, links[k - 1])
        for i in range(3):
            J[3 + i, k] = T[4 * i + 2]
            J[i, k] = T[4 * i + 3]
        _general_prrprr_move(T, k, c[k], s[k])
    for k in range(6):
        z0, z1, z2 = J[3, k], J[4, k], J[5, k]
        r0, r1, r2 = T[3] - J[0, k], T[7] - J[1, k], T[11] - J[2, k]
        J[0, k], J[1, k], J[2, k] = z1 * r2 - z2 * r1, z2 * r0 - z0 * r2, z0 * r1 - z1 * r0
    for i in range(3):
        J[i, 0], J[3 + i, 0] = J[3 + i, 0], 0.0
        J[i, 3], J[3 + i, 3] = J[3 + i, 3], 0.0
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
def _general_prrprr_step(J, x):
    """A step of Newton: the least-squares solution of J x = error by reflections. Where a diagonal is
    next to nothing the step stays zero instead of leaping. Returns the smallest diagonal over the
    largest."""
    for column in range(5):
        _general_prrprr_reflect(J, column, column + 1, column)
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
def _general_prrprr_damped_step(J, damping, x):
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
def _general_prrprr_polish(links, c, s, afar):
    """Newton on the loop; what remains in c and s is the best iterate, and its error is returned."""
    J, x = carray(_room(42), (6, 7)), carray(_room(6), 6)
    tc, ts = carray(_room(6), 6), carray(_room(6), 6)
    _take(tc, c)
    _take(ts, s)
    least = now = _general_prrprr_error(links, c, s, J)
    for _ in range(40 if afar else 4):
        if least < 1e-29:
            break
        if afar:
            _general_prrprr_damped_step(J, 0.01 * min(now, 1.0), x)
        else:
            _general_prrprr_step(J, x)
        length_0 = ts[0] + x[0]
        length_3 = ts[3] + x[3]
        for i in range(6):
            # a turn by 2 atan(x/2), without trigonometry
            u = 0.25 * x[i] * x[i]
            dc, ds = (1.0 - u) / (1.0 + u), x[i] / (1.0 + u)
            tc[i], ts[i] = tc[i] * dc - ts[i] * ds, ts[i] * dc + tc[i] * ds
        ts[0] = length_0
        ts[3] = length_3
        now = _general_prrprr_error(links, tc, ts, J)
        if now < least:
            least = now
            for i in range(6):
                c[i], s[i] = tc[i], ts[i]
    return math.sqrt(least)


@_inner
def _general_prrprr_gap(a, b):
    """The largest difference of two joint vectors, modulo turns."""
    most = 0.0
    for i in range(6):
        gap = abs(a[i] - b[i])
        most = max(most, gap if i in (0, 3) else min(gap, 6.283185307179586 - gap))
    return most


@_inner
def _general_prrprr_rank(q, singular, count):
    """What comes first where there are more than there are rows, in the place of the marks: 0 for
    regular solutions, 1 for singular ones or nearly so, 2 for those that lie together with one of these
    and may be the same, which only its last digits tell."""
    for i in range(count):
        singular[i] = 1 if singular[i] else 0
        for j in range(i):
            if singular[i] == 1 and singular[j] == 1 and _general_prrprr_gap(q[i], q[j]) < 0.001:
                singular[i] = 2


@_inner
def _general_prrprr_begun(q, c, s):
    """The cosines and sines in the loop of joint values; a length stands in the sine's place."""
    for i in range(6):
        cosine, sine = math.cos(q[i]), q[i] if i in (0, 3) else math.sin(q[i])
        c[i] = cosine * _GENERAL_PRRPRR_ADVANCE_C[i] + sine * _GENERAL_PRRPRR_ADVANCE_S[i]
        s[i] = sine * _GENERAL_PRRPRR_ADVANCE_C[i] - cosine * _GENERAL_PRRPRR_ADVANCE_S[i]


@_apart("UniTuple(int64, 2)(float64[:, ::1], float64[::1], float64[::1], boolean, boolean, float64[:, ::1], float64[::1], int64[::1], int64)")
def _general_prrprr_offer(links, c, s, afar, doubtful, q, residual, singular, count):
    """Polish a candidate and keep it unless it is known or none: (its place or -1, the count). Where
    one is singular many come near to it: there is room for more than there are solutions, the last of
    it for regular ones."""
    missing = _general_prrprr_polish(links, c, s, afar)
    if not missing <= 1e-10:
        return -1, count
    theta = carray(_room(6), 6)
    for i in range(6):
        cosine, sine = _GENERAL_PRRPRR_ADVANCE_C[i], _GENERAL_PRRPRR_ADVANCE_S[i]
        theta[i] = math.atan2(s[i] * cosine + c[i] * sine, c[i] * cosine - s[i] * sine)
        # half a turn is +pi, also when rounding says otherwise
        if theta[i] < -3.141592653589783:
            theta[i] = 3.141592653589793
    theta[0] = s[0]
    theta[3] = s[3]
    place = count
    for k in range(count):
        if _general_prrprr_gap(q[k], theta) < 1e-06:
            place = k
            break
    marked = nearly = 0
    if doubtful:
        J, x = carray(_room(42), (6, 7)), carray(_room(6), 6)
        _general_prrprr_error(links, c, s, J)
        pivot = _general_prrprr_step(J, x)
        marked = 1 if pivot < 1e-06 else 0
        nearly = 1 if pivot < 0.0001 else 0
    if place == count and count >= 64 - nearly * 8:
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


# Four turns and two slides: J(phi1) L0 J(phi2) L1 ... J(phi6) L5 = 1 with phi1 a turn. Slides leave
# directions alone, Rz(phi1) A Rz Rz B Rz C Rz D = 1 for the rotations between the turns: with phi1 given,
# Rz N Rz = M = A' Rz(-phi1) D', N = B Rz C. Both have the same entry zz, which gives the middle turn, a
# square root; what turns N's third column and row to those of M are the others. The translation is
# linear in the slides' lengths: the determinant of it and of their directions is zero. Numbers
# x + y sqrt(delta), with delta the discriminant, are pairs of x and y.


@_inner
def _general_prrprr_setting(which, loop):
    """The joints in the loop's order, the links L0 ... L5, and A, B, C, D; what is no rotation of
    these means nothing."""
    joints, links = _GENERAL_PRRPRR_JOINTS[which], _general_prrprr_around(which, loop)
    between = np.empty((4, 12))
    turn = -1
    for i in range(6):
        if joints[i] in (0, 3):
            _general_prrprr_follow(between[turn], links[i])
        else:
            turn += 1
            _take(between[turn], links[i])
    return joints, links, between


@_inner
def _general_prrprr_tells_all(between, roots, counts):
    """Whether every solution has a root, and every root tells its solution.

    Where the third turn's axis is parallel to the one before or behind it, the entry zz does not
    give this turn, and roots tell nothing. Where these two are parallel at a root, it does not tell
    their turns.
    """
    B, C = between[1], between[2]
    plain = (B[8] * B[8] + B[9] * B[9]) * (C[2] * C[2] + C[6] * C[6]) > 1e-18
    for double in range(2):
        for i in range(counts[double]):
            c, s = math.cos(roots[double, i]), math.sin(roots[double, i])
            plain = plain and _general_prrprr_linkage(between, c, s)[1] > 1e-06
    return plain


@_inner
def _general_prrprr_product(a, b, delta):
    """The product of two numbers x + y sqrt(delta)."""
    return a[0] * b[0] + delta * a[1] * b[1], a[0] * b[1] + a[1] * b[0]


@_inner
def _general_prrprr_linkage(between, c, s):
    """delta, what the polynomial is multiplied by, and cosines and sines, (3, 2, 2), of the other turns."""
    A, B, C, D = between[0], between[1], between[2], between[3]
    M = np.empty((3, 3))
    for j in range(3):
        x, y = c * D[4 * j] + s * D[4 * j + 1], c * D[4 * j + 1] - s * D[4 * j]
        for i in range(3):
            M[i, j] = A[i] * x + A[4 + i] * y + A[8 + i] * D[4 * j + 2]
    b, a = B[8] * C[2] + B[9] * C[6], B[9] * C[2] - B[8] * C[6]
    q = a * a + b * b + 1e-300
    k = M[2, 2] - B[10] * C[10]
    w = M[0, 2] * M[0, 2] + M[1, 2] * M[1, 2] + 1e-300
    turns = np.empty((3, 2, 2))
    turns[1, 0, 0], turns[1, 0, 1] = b * k / q, -a / q
    turns[1, 1, 0], turns[1, 1, 1] = a * k / q, b / q
    for i in range(2):
        cosine, sine = turns[1, 0, i], turns[1, 1, i]
        one = 1.0 - i
        # third column and row of B Rz C
        x, y, z = C[2] * cosine - C[6] * sine, C[2] * sine + C[6] * cosine, C[10] * one
        column_x, column_y = B[0] * x + B[1] * y + B[2] * z, B[4] * x + B[5] * y + B[6] * z
        x, y, z = B[8] * cosine + B[9] * sine, B[9] * cosine - B[8] * sine, B[10] * one
        row_x, row_y = C[0] * x + C[4] * y + C[8] * z, C[1] * x + C[5] * y + C[9] * z
        turns[0, 0, i] = (M[0, 2] * column_x + M[1, 2] * column_y) / w
        turns[0, 1, i] = (M[1, 2] * column_x - M[0, 2] * column_y) / w
        turns[2, 0, i] = (M[2, 0] * row_x + M[2, 1] * row_y) / w
        turns[2, 1, i] = (M[2, 0] * row_y - M[2, 1] * row_x) / w
    return a * a + b * b - k * k, w, turns


@_apart("Tuple((float64, float64, float64[:, :, ::1], float64[:, :, ::1], float64, float64))(int64[::1], float64[:, ::1], float64[:, ::1], float64, float64)")
def _general_prrprr_around_once(joints, links, between, c, s):
    """Once around the loop: delta, what the polynomial is multiplied by, cosines and sines of the other
    turns, (3, 2, 2), the directions of the slides and the translation, (3, 3, 2), and the
    determinant of these."""
    delta, w, turns = _general_prrprr_linkage(between, c, s)
    T = np.zeros((2, 12))
    T[0, 0] = T[0, 5] = c
    T[0, 1], T[0, 4], T[0, 10] = -s, s, 1.0
    vectors = np.empty((3, 3, 2))
    turn = slide = 0
    for i in range(6):
        if joints[i] in (0, 3):
            for j in range(3):
                vectors[slide, j, 0], vectors[slide, j, 1] = T[0, 4 * j + 2], T[1, 4 * j + 2]
            slide += 1
        elif i > 0:
            cosine, sine = turns[turn, 0], turns[turn, 1]
            for j in range(0, 12, 4):
                x, y = (T[0, j], T[1, j]), (T[0, j + 1], T[1, j + 1])
                xc, xs = _general_prrprr_product(x, cosine, delta), _general_prrprr_product(x, sine, delta)
                yc, ys = _general_prrprr_product(y, cosine, delta), _general_prrprr_product(y, sine, delta)
                for k in range(2):
                    T[k, j], T[k, j + 1] = xc[k] + ys[k], yc[k] - xs[k]
            turn += 1
        for k in range(2):
            at = T[k].copy()
            for row in range(0, 12, 4):
                for j in range(4):
                    T[k, row + j] = (
                        at[row] * links[i, j]
                        + at[row + 1] * links[i, 4 + j]
                        + at[row + 2] * links[i, 8 + j]
                    )
                T[k, row + 3] += at[row + 3]
    U = V = 0.0
    for i in range(3):
        vectors[2, i, 0], vectors[2, i, 1] = T[0, 4 * i + 3], T[1, 4 * i + 3]
    for i in range(3):
        i1, i2 = (i + 1) % 3, (i + 2) % 3
        first = _general_prrprr_product(vectors[0, i1], vectors[1, i2], delta)
        second = _general_prrprr_product(vectors[0, i2], vectors[1, i1], delta)
        normal = (first[0] - second[0], first[1] - second[1])
        term = _general_prrprr_product(normal, vectors[2, i], delta)
        U += term[0]
        V += term[1]
    return delta, w, turns, vectors, U, V


@_inner
def _general_prrprr_closed_polynomial(setting, c, s):
    """The polynomial of the hidden turn, of degree 4: the product over both branches."""
    joints, links, between = setting
    delta, w, _, _, U, V = _general_prrprr_around_once(joints, links, between, c, s)
    return w * (U * U - V * V * delta)


@_inner
def _general_prrprr_way_joints(setting, way, c1, s1, c, s):
    """The cosines and sines of all turns and the lengths of the slides, from the hidden turn.

    Way 0 is the better branch. Returns 1 if it is to be tried: way 1, the other one, where its
    determinant is small, too, as a double root may be one of each. 2 says that the slides are parallel,
    and as the translation is not along them, they would have to reach too far.
    """
    joints, links, between = setting
    delta, _, turns, vectors, U, V = _general_prrprr_around_once(joints, links, between, c1, s1)
    root = math.sqrt(max(delta, 0.0))
    better = -1.0 if (U < 0.0) == (V < 0.0) else 1.0
    if way == 1:
        better = -better
        if not abs(U + better * V * root) < 0.01:
            return 0
    root *= better
    square, first, second = 1e-30, 0.0, 0.0
    sine = across = 0.0
    for i in range(3):
        i1, i2 = (i + 1) % 3, (i + 2) % 3
        u1, u2 = vectors[0, i1, 0] + root * vectors[0, i1, 1], vectors[0, i2, 0] + root * vectors[0, i2, 1]
        v1, v2 = vectors[1, i1, 0] + root * vectors[1, i1, 1], vectors[1, i2, 0] + root * vectors[1, i2, 1]
        x1, x2 = vectors[2, i1, 0] + root * vectors[2, i1, 1], vectors[2, i2, 0] + root * vectors[2, i2, 1]
        normal, other = u1 * v2 - u2 * v1, x1 * u2 - x2 * u1
        sine, across = max(sine, abs(normal)), max(across, abs(other))
        # x + d u + e v = 0 times v and u; their scalar products would lose digits of the sine
        square += normal * normal
        first += normal * (v1 * x2 - v2 * x1)
        second += normal * other
    moved = math.sqrt(1e-14 / (abs(U) + abs(V * root) + 1e-300))
    if across > max(1e-06, moved, 10000.0 * sine):
        return 2
    lengths = (first / square, second / square)
    c[joints[0]], s[joints[0]] = c1, s1
    turn = slide = 0
    for i in range(1, 6):
        joint = joints[i]
        if joint in (0, 3):
            c[joint], s[joint] = 1.0, lengths[slide]
            slide += 1
        else:
            c[joint], s[joint] = _general_prrprr_unit(
                turns[turn, 0, 0] + root * turns[turn, 0, 1],
                turns[turn, 1, 0] + root * turns[turn, 1, 1],
            )
            turn += 1
    return 1


@_inner
def _general_prrprr_sample_closed(setting, x, y, samples):
    """The polynomial at the sample angles, through a lens."""
    for k in range(24):
        c, s, weight = _general_prrprr_through(x, y, _GENERAL_PRRPRR_SAMPLE_C[k], _GENERAL_PRRPRR_SAMPLE_S[k])
        samples[k] = weight * _general_prrprr_closed_polynomial(setting, c, s)


@_inner
def _general_prrprr_keep_vanishing_closed(setting, angles, count):
    """Of angles those where the polynomial may vanish: it is known itself, and nothing tells more."""
    return count


@_inner
def _general_prrprr_take_lifted_closed(of, roots, counts):
    """The places where f turns back beside zero are double roots where there may be any."""
    for i in range(_general_prrprr_keep_vanishing_closed(of, roots[2], counts[2])):
        _general_prrprr_add_root(roots, counts, 1, roots[2, i])


@_inner
def _general_prrprr_real_roots_closed(of):
    """All real roots: (whether the polynomial does not vanish identically, roots, counts).

    Where roots may be double they are replaced by what a closer look shows, if it shows all: values
    that are computed there have the digits that the fit of f lacks. What was given up stands among
    them. Behind them stand, as many as the last of the counts, places where that shows no root: the
    values lack the digits that the equations behind f lack.
    """
    samples = np.empty(24)
    _general_prrprr_sample_closed(of, 0.0, 0.0, samples)
    largest = np.abs(samples).max()  # rounding of zero may be as smooth as a polynomial
    x, y = _general_prrprr_spread(samples)
    if x != 0.0 or y != 0.0:
        _general_prrprr_sample_closed(of, x, y, samples)
    noise, roots, counts = _general_prrprr_seen(samples, x, y, 0, 128, 5e-09)
    _general_prrprr_take_lifted_closed(of, roots, counts)
    good = noise <= 1e-06 and largest > 1e-26
    if not good or max(counts[0], counts[1]) == 24:
        return good, roots, counts
    seen, looks, clear = np.empty(4), 0, True
    unseen, empty = np.empty(4), 0
    i = _general_prrprr_next_double(roots, counts, seen, looks)
    while i < counts[1] and looks < 4:
        middle = seen[looks] = roots[1, i]
        looks += 1
        x, y = 0.8823529411764706 * math.cos(middle), 0.8823529411764706 * math.sin(middle)
        _general_prrprr_sample_closed(of, x, y, samples)
        turns = middle / 6.283185307179586
        cell = int(256 * (turns - math.floor(turns))) % 256
        blur, closer, closer_counts = _general_prrprr_seen(
            samples, x, y, cell, 38, 1.28e-06
        )
        if blur <= 1e-10 and closer_counts[3]:
            _general_prrprr_take_lifted_closed(of, closer, closer_counts)
            _general_prrprr_replace(roots, counts, closer, closer_counts, middle)
            if not _general_prrprr_any_near(roots, counts, middle):
                unseen[empty] = middle
                empty += 1
        else:
            clear = False
        i = _general_prrprr_next_double(roots, counts, seen, looks)
    empty = _general_prrprr_keep_vanishing_closed(of, unseen, empty)
    counts[4] = min(empty, 24 - counts[1])
    for k in range(counts[4]):
        roots[1, counts[1] + k] = unseen[k]
    if clear and i == counts[1]:
        counts[3] = 1
    if noise > 1e-10:  # f nearly vanishes identically: it does not tell what there is not
        counts[3] = 0
    return good, roots, counts


@_apart("Tuple((boolean, int64))(int64, float64[:, ::1], float64[:, ::1], float64[::1], int64[::1], int64[::1], int64)")
def _general_prrprr_attempt_closed(which, loop, q, residual, singular, doubles_met, count):
    """Find what a polynomial in closed form finds: (whether that is certainly everything, the count).

    The certificate is that of the formulations, with 1 solution(s) a root.
    """
    setting = _general_prrprr_setting(which, loop)
    good, roots, counts = _general_prrprr_real_roots_closed(setting)
    if not good:
        return False, count
    complete, expected = counts[3] == 1 and _general_prrprr_tells_all(setting[2], roots, counts), 0
    doubles_met[0] += counts[1]
    met = np.zeros(64, dtype=np.int64)
    c, s = np.empty(6), np.empty(6)
    for double in range(2):
        for i in range(counts[double]):
            here = np.zeros(64, dtype=np.int64)
            singular_here = False
            cosine, sine = math.cos(roots[double, i]), math.sin(roots[double, i])
            far = 0
            for way in range(2):
                kind = _general_prrprr_way_joints(setting, way, cosine, sine, c, s)
                far += kind == 2
                if kind != 1:
                    continue
                place, count = _general_prrprr_offer(
                    loop, c, s, False, counts[1] > 0, q, residual, singular, count
                )
                if place >= 0:
                    here[place] = met[place] = 1
                    singular_here = singular_here or singular[place] & 1 == 1
            if far and not _general_prrprr_marked(here):
                continue
            complete = complete and _general_prrprr_marked(here) >= 1
            expected += 2 if double and not singular_here else 1
            expected -= far
    regular = count - _general_prrprr_marked(singular)
    return complete and _general_prrprr_marked(met) >= expected and regular % 2 == 0, count


@_apart("Tuple((boolean, int64))(float64[:, ::1], float64[:, ::1], float64[::1], int64[::1], int64[::1])")
def _general_prrprr_try(loop, q, residual, singular, doubles_met):
    """Find what the methods find, one after the other, until that is certainly everything."""
    for i in range(64):
        singular[i] = 0
    complete, count = False, np.int64(0)
    for way in range(2):
        if not complete:
            complete, count = _general_prrprr_attempt_closed(
                way, loop, q, residual, singular, doubles_met, count
            )
    return complete, count


@_apart("Tuple((boolean, int64))(float64[:, ::1], float64[:, ::1], float64[::1], int64[::1], int64)")
def _general_prrprr_from_nearby(loop, q, residual, singular, count):
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
        _general_prrprr_follow(nearby[5], _GENERAL_PRRPRR_NUDGES[n])
        complete, found = _general_prrprr_try(
            nearby, other, ignored, marks, np.zeros(1, dtype=np.int64)
        )
        met = np.zeros(64, dtype=np.int64)
        singular_here = False
        for i in range(found):
            _general_prrprr_begun(other[i], c, s)
            place, count = _general_prrprr_offer(
                loop, c, s, True, True, q, residual, singular, count
            )
            if place < 0:
                complete = False
            else:
                met[place] = 1
                singular_here = singular_here or singular[place] & 1 == 1
        marked = _general_prrprr_marked(singular)
        agreed = -1
        if complete and found > 0:
            agreed = found if _general_prrprr_marked(met) == found else -1
            followed = followed or singular_here
        alike = n % 2 == 1 and before == count and agreed == count
        if alike and marked == 0 and count % 2 == 0:
            return True, count
        before = agreed
    return followed and (count - _general_prrprr_marked(singular)) % 2 == 0, count


@_inner
def _general_prrprr_before(q, rank, i, j):
    """Whether solution i comes before solution j: by rank, then by the first angle, angles that agree
    to rounding by the next."""
    if rank[i] != rank[j]:
        return rank[i] < rank[j]
    for k in range(6):
        if abs(q[i, k] - q[j, k]) > 1e-09:
            return q[i, k] < q[j, k]
    return False


@_apart("int64(float64[::1], float64[:, ::1], float64[::1])")
def general_prrprr_general(T, q, residual):
    """All solutions of T = C0 J(q1) C1 ... J(q6) C6, at most 8.

    Args:
        T: A rigid transform, twelve numbers.
        q: (8, 6), takes the angles, in (-pi, pi], or length; rows in the order of q1, rows whose q1 agree to
            1e-09 in the order of q2, and so on, those where the arm is singular or nearly so behind all others.
        residual: (8,), takes by how much the loop stays open, in radians and arm sizes.

    Returns:
        How many; -1 - count when it is not certain that these are all: for want of a certificate of
        its own (where every polynomial vanishes identically there may be a continuum, which poses
        close by do not have), or because roots met or the arm is singular at a solution, or nearly,
        so that steps did not make it exact.
    """
    loop = _general_prrprr_close(T)
    found, missing, singular = np.empty((64, 6)), np.empty(64), np.zeros(64, dtype=np.int64)
    doubles_met = np.zeros(1, dtype=np.int64)
    certified, count = _general_prrprr_try(loop, found, missing, singular, doubles_met)
    complete = certified
    if not complete:
        complete, count = _general_prrprr_from_nearby(loop, found, missing, singular, count)
    if not complete:
        seed = 1
        c, s = np.empty(6), np.empty(6)
        for _ in range(128):
            start = np.empty(6)
            for i in range(6):
                seed = (seed * 1103515245 + 12345) % 2147483648
                start[i] = (seed / 1073741824.0 - 1.0) * 3.141592653589793
            _general_prrprr_begun(start, c, s)
            _, count = _general_prrprr_offer(
                loop, c, s, True, True, found, missing, singular, count
            )
    regular = _general_prrprr_marked(singular) == 0 and doubles_met[0] == 0
    _general_prrprr_rank(found, singular, count)
    order = np.empty(64, dtype=np.int64)
    for i in range(count):
        j = i
        while j > 0 and _general_prrprr_before(found, singular, i, order[j - 1]):
            order[j] = order[j - 1]
            j -= 1
        order[j] = i
    if count > 8:
        certified, count = False, 8
    for i in range(count):
        for k in range(6):
            q[i, k] = found[order[i], k]
        q[i, 0] *= 0.5188865104263425
        q[i, 3] *= 0.5188865104263425
        residual[i] = missing[order[i]]
    for i in range(count):
        regular = regular and residual[i] <= 1e-12
    return count if certified and regular else -1 - count


_FACING = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])
_ZERO = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0])


@_apart("Tuple((float64[:, ::1], boolean[::1], boolean[::1]))(UniTuple(float64, 12), float64[::1])")
def _all_joints(pose, seed):
    """All solutions, which rows hold one, and where a joint was indeterminate and follows the seed."""
    flat, T = np.empty(12), np.empty((3, 4))
    for i in range(3):
        for j in range(4):
            flat[4 * i + j] = T[i, j] = pose[4 * i + j]
    angles, residual, joints = np.empty((8, 6)), np.empty(8), np.zeros(6)
    known = general_prrprr_general(flat, angles, residual)
    q = np.zeros((8, 6))
    found, chosen = np.zeros(8, np.bool_), np.zeros(8, np.bool_)
    kept, kinds, count = np.empty((8, 6)), np.empty(8, np.int64), 0
    near, u = np.empty(6), np.empty(6)
    for j in range(6):
        near[j] = seed[_SOLVED[j]] / _UNIT[j]
    for k in range(8):
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
    # all joints: the general 4R2P loop
    solution_roots, solution_found, solution_chosen = _all_joints(pose, seed)

    for i1 in range(8):  # root1 to root8
        q1 = solution_roots[i1, 0]
        q2 = solution_roots[i1, 1]
        q3 = solution_roots[i1, 2]
        q4 = solution_roots[i1, 3]
        q5 = solution_roots[i1, 4]
        q6 = solution_roots[i1, 5]
        found = solution_found[i1]
        chosen = solution_chosen[i1]
        # all joints: the general 4R2P loop
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
    valid = math.isfinite(px * px * px) and math.isfinite(py * py * py) and math.isfinite(pz * pz * pz)
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
    if not _REVOLUTE[joint]:
        return given
    low, high = _LOWEST[joint], _HIGHEST[joint]
    value = given
    if abs(towards) < 100000.0:
        value += turn * math.floor((towards - given) / turn + 0.5)
    if value > high:
        value -= turn * math.ceil((value - high) / turn)
    if value < low:
        value += turn * math.ceil((low - value) / turn)
    return value if value <= high else given


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


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.75, 1.0, 1.0, 1.75, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.5714, 0.5714, 0.5714, 1.0, 1.0, 1.0])


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


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(8):
        status[row] = UNREACHABLE
        for i in range(6):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    count = 0
    for row in range(8):
        if status[row] == UNREACHABLE:
            continue
        _stand(pose, row, False, q, status)
        for i in range(6):
            q[row, i] = _turned(i, q[row, i], 0.0)
            if not _LOWEST[i] <= q[row, i] <= _HIGHEST[i]:
                status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


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
        q: Filled with joint values (8, 6), NaN where there is no solution; float64.
        status: Filled with what each row holds (8,); uint8.
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
    _demand_array("q", q, (8, 6), _FLOAT)
    _demand_array("status", status, (8,), _BYTE)
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
    """All solutions: q (8, 6) and status (8,).

    Row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (6,); zeros without it.

    Raises:
        ValueError: An argument has the wrong shape, or the seed is not finite.
    """
    q, status = _empty((8, 6)), _empty(8, _BYTE)
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
    if not _REVOLUTE[joint]:
        return value
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
    first, last = (0, 8) if branch is None else _span(branch)
    rows, status = ik_all(T, q_seed)
    if status[0] == INVALID_POSE:
        raise ValueError("T is not a valid pose: not finite or beyond 5e102, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)")
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
        q (N, 8, 6) and status (N, 8).

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
    q, status = np.empty((8, 6)), np.empty(8, _BYTE)
    T = fk(_ZEROS)
    jacobian(_ZEROS)
    ik_into(T, q, status)
    ik_into(T, q, status, _ZEROS)
    _nearest(q, status, _ZEROS, True, np.empty(6))
    ik_batch(T[np.newaxis])
    _HOW.compile_apart()


def _results(out, count):
    """The rows and the statuses of so many poses: the caller's arrays, or new ones."""
    rows, row = (count, 8, 6), (count, 8)
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
