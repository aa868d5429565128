"""kinova_jaco2: Kinova Jaco2 with 6 joints.

Inverse kinematics, generated from robots/kinova_jaco2.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kinova_jaco2.yaml. The formulas and where they come from:
kinova_jaco2.md.

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

NAME = "kinova_jaco2"
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

D1 = 0.2755  # joint offset 1 [m]
D2 = 0.41  # link length 2 [m]
e2 = 0.0098  # joint offset 3 [m]
d5 = -0.08579425000157839  # joint offset 5 [m]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
offset3 = 1.5707963267948966  # offset of joint 3 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
offset6 = 1.7453292519943295  # offset of joint 6 [rad]
f1 = 0.2501971250007892  # D3 + d4 [m]
f2 = 0.5  # 1 / 2
f3 = 0.8660254037844386  # 1 / 2 * sqrt3
f4 = 0.2115971250007892  # D6 + d6 [m]
g1 = 0.2501971250007892  # D3 + d4 [m]
g4 = 0.2115971250007892  # D6 + d6 [m]

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
    v1 = q[1] + offset2
    c2 = math.cos(v1)
    s2 = math.sin(v1)
    x2_x = c1 * c2
    x2_y = s1 * c2
    y2_x = c1 * s2
    y2_y = s1 * s2
    v2 = q[2] + offset3
    c3 = math.cos(v2)
    s3 = math.sin(v2)
    x3_x = x2_x * c3 + y2_x * s3
    x3_y = x2_y * c3 + y2_y * s3
    x3_z = s2 * c3 - c2 * s3
    z3_z = c2 * c3 + s2 * s3
    z3_x = x2_x * s3 - y2_x * c3
    z3_y = x2_y * s3 - y2_y * c3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - s1 * s4
    x4_y = x3_y * c4 + c1 * s4
    x4_z = x3_z * c4
    v3 = s1 * c4 + x3_x * s4
    v4 = c1 * c4 - x3_y * s4
    v5 = x3_z * s4
    y4_x = z3_x * f3 - v3 * f2
    y4_y = v4 * f2 + z3_y * f3
    y4_z = z3_z * f3 - v5 * f2
    z4_x = v3 * f3 + z3_x * f2
    z4_y = z3_y * f2 - v4 * f3
    z4_z = v5 * f3 + z3_z * f2
    v6 = q[4] + offset5
    c5 = math.cos(v6)
    s5 = math.sin(v6)
    x5_x = x4_x * c5 + y4_x * s5
    x5_y = x4_y * c5 + y4_y * s5
    x5_z = x4_z * c5 + y4_z * s5
    v7 = y4_x * c5 - x4_x * s5
    v8 = y4_y * c5 - x4_y * s5
    v9 = y4_z * c5 - x4_z * s5
    y5_x = f2 * v7 + f3 * z4_x
    y5_y = f2 * v8 + f3 * z4_y
    y5_z = f2 * v9 + f3 * z4_z
    z5_x = f2 * z4_x - f3 * v7
    z5_y = f2 * z4_y - f3 * v8
    z5_z = f2 * z4_z - f3 * v9
    v10 = q[5] + offset6
    c6 = math.cos(v10)
    s6 = math.sin(v10)
    T[0, 0] = x5_x * c6 + y5_x * s6
    T[0, 1] = x5_x * s6 - y5_x * c6
    T[0, 2] = -z5_x
    T[0, 3] = x2_x * D2 + s1 * e2 - z3_x * f1 + z4_x * d5 - z5_x * f4
    T[1, 0] = x5_y * c6 + y5_y * s6
    T[1, 1] = x5_y * s6 - y5_y * c6
    T[1, 2] = -z5_y
    T[1, 3] = x2_y * D2 - c1 * e2 - z3_y * f1 + z4_y * d5 - z5_y * f4
    T[2, 0] = x5_z * c6 + y5_z * s6
    T[2, 1] = x5_z * s6 - y5_z * c6
    T[2, 2] = -z5_z
    T[2, 3] = D1 + s2 * D2 - z3_z * f1 + z4_z * d5 - z5_z * f4
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
    v1 = q[1] + offset2
    c2 = math.cos(v1)
    s2 = math.sin(v1)
    x2_x = c1 * c2
    x2_y = s1 * c2
    y2_x = c1 * s2
    y2_y = s1 * s2
    p2_x = x2_x * D2
    p2_y = x2_y * D2
    p2_z = D1 + s2 * D2
    v2 = q[2] + offset3
    c3 = math.cos(v2)
    s3 = math.sin(v2)
    x3_x = x2_x * c3 + y2_x * s3
    x3_y = x2_y * c3 + y2_y * s3
    x3_z = s2 * c3 - c2 * s3
    z3_z = c2 * c3 + s2 * s3
    p3_x = p2_x + s1 * e2
    p3_y = p2_y - c1 * e2
    z3_x = x2_x * s3 - y2_x * c3
    z3_y = x2_y * s3 - y2_y * c3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    v3 = s1 * c4 + x3_x * s4
    v4 = c1 * c4 - x3_y * s4
    v5 = x3_z * s4
    p4_x = p3_x - z3_x * g1
    p4_y = p3_y - z3_y * g1
    p4_z = p2_z - z3_z * g1
    z4_x = v3 * f3 + z3_x * f2
    z4_y = z3_y * f2 - v4 * f3
    z4_z = v5 * f3 + z3_z * f2
    v6 = q[4] + offset5
    c5 = math.cos(v6)
    s5 = math.sin(v6)
    p5_x = p4_x + z4_x * d5
    p5_y = p4_y + z4_y * d5
    p5_z = p4_z + z4_z * d5
    z5_x = f2 * z4_x - f3 * ((z3_x * f3 - v3 * f2) * c5 - (x3_x * c4 - s1 * s4) * s5)
    z5_y = f2 * z4_y - f3 * ((v4 * f2 + z3_y * f3) * c5 - (x3_y * c4 + c1 * s4) * s5)
    z5_z = f2 * z4_z - f3 * ((z3_z * f3 - v5 * f2) * c5 - x3_z * c4 * s5)
    p6_x = p5_x - z5_x * g4
    p6_y = p5_y - z5_y * g4
    p6_z = p5_z - z5_z * g4
    v7 = p6_z - D1
    v8 = p6_z - p2_z
    v9 = p6_x - p3_x
    v10 = p6_y - p3_y
    v11 = p6_x - p4_x
    v12 = p6_y - p4_y
    v13 = p6_z - p4_z
    v14 = p6_x - p5_x
    v15 = p6_y - p5_y
    v16 = p6_z - p5_z
    J[0, 0] = -p6_y
    J[0, 1] = -(c1 * v7)
    J[0, 2] = c1 * v8
    J[0, 3] = z3_y * v8 - z3_z * v10
    J[0, 4] = z4_y * v13 - z4_z * v12
    J[0, 5] = z5_y * v16 - z5_z * v15
    J[1, 0] = p6_x
    J[1, 1] = -(s1 * v7)
    J[1, 2] = s1 * v8
    J[1, 3] = z3_z * v9 - z3_x * v8
    J[1, 4] = z4_z * v11 - z4_x * v13
    J[1, 5] = z5_z * v14 - z5_x * v16
    J[2, 1] = s1 * p6_y + c1 * p6_x
    J[2, 2] = -(s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x))
    J[2, 3] = z3_x * v10 - z3_y * v9
    J[2, 4] = z4_x * v12 - z4_y * v11
    J[2, 5] = z5_x * v15 - z5_y * v14
    J[3, 1] = s1
    J[3, 2] = -s1
    J[3, 3] = z3_x
    J[3, 4] = z4_x
    J[3, 5] = z5_x
    J[4, 1] = -c1
    J[4, 2] = c1
    J[4, 3] = z3_y
    J[4, 4] = z4_y
    J[4, 5] = z5_y
    J[5, 0] = 1.0
    J[5, 3] = z3_z
    J[5, 4] = z4_z
    J[5, 5] = z5_z
    return J


_arms = import_module(f"{_FOLDER}.dhgen_runtime.numerical.arm")
# The joints, what the task names, and the forward model with all links.
_WHOLE = _arms.Arm(
    rows=16,
    size=1.2428885000031569,
    coordinates=(0, 1, 2),
    directions='rotation',
    joints=(
        _arms.Joint(place=0),
        _arms.Joint(place=1, zero=-1.5707963267948966),
        _arms.Joint(place=2, zero=1.5707963267948966),
        _arms.Joint(place=3),
        _arms.Joint(place=4, zero=3.141592653589793),
        _arms.Joint(place=5, zero=1.7453292519943295),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _arms.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.2755)),
        _arms.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.41, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0),
            offset=-1.5707963267948966,
        ),
        _arms.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, -0.0098),
            offset=1.5707963267948966,
        ),
        _arms.ChainJoint((
            1.0, 0.0, 0.0, 0.0, 0.0, 0.5, -0.8660254037844386, 0.0, 0.0, 0.8660254037844386, 0.5,
            -0.2501971250007892,
        )),
        _arms.ChainJoint(
            after=(
                1.0, 0.0, 0.0, 0.0, 0.0, 0.5, -0.8660254037844386, 0.0, 0.0, 0.8660254037844386,
                0.5, -0.08579425000157839,
            ),
            offset=3.141592653589793,
        ),
        _arms.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, -0.2115971250007892),
            offset=1.7453292519943295,
        ),
    ),
)
_loops = import_module(f"{_FOLDER}.dhgen_runtime.general.arm")
_solver = import_module(f"{_FOLDER}.dhgen_runtime.general.rows")
_compiled = import_module(f"{_FOLDER}.dhgen_runtime.general.compiled")
# The arm as a loop J(q1) K0 J(q2) ... K4 J(q6) = L T R, and how it is solved.
_LOOP = _loops.Loop(
    size=0.3687091878934751,
    reach=4.000000004,
    links=(
        _loops.Link((
            0.38461538461538464, -0.9230769230769231, 0.0, 0.0, 0.0, 0.0, -1.0,
            -0.008859737618621246, 0.9230769230769231, 0.38461538461538464, 0.0,
            7.472013737079356e-10,
        )),
        _loops.Link((
            0.47058823529411764, -0.8823529411764706, 0.0, 1.1119874781055206, -0.8823529411764706,
            -0.47058823529411764, 0.0, 0.0, 0.0, 0.0, -1.0, 0.008859737627480985,
        )),
        _loops.Link((
            0.28, -0.96, 0.0, 0.0, 0.0, 0.0, -1.0, 0.3400374515881446, 0.96, 0.28, 0.0,
            -0.00885973764520046,
        )),
        _loops.Link((
            0.6896551724137931, -0.7241379310344828, 0.0, 0.0, 0.36206896551724144,
            0.34482758620689663, -0.8660254037844387, 0.0025965570034597847, 0.627121844119766,
            0.597258899161682, 0.5000000000000001, -0.34003745192818213,
        )),
        _loops.Link((
            0.32432432432432434, -0.9459459459459459, 0.0, 0.0, 0.4729729729729731,
            0.1621621621621622, -0.8660254037844387, -0.09945863557349463, 0.8192132197960906,
            0.28087310393008824, 0.5000000000000001, -0.1722674102944599,
        )),
        _loops.Link((0.6, 0.8, 0.0, -0.0, -0.8, 0.6, 0.0, -0.0, 0.0, 0.0, 1.0, -0.2754999997245)),
        _loops.Link((
            1.0, 0.0, 0.0, -0.0, 0.0, -1.0, 0.0, -0.0, 0.0, 0.0, -1.0, -0.25394150957778494,
        )),
    ),
    advances=(
        (0.6, 0.8),
        (0.38461538461538464, 0.9230769230769231),
        (0.47058823529411764, 0.8823529411764706),
        (0.28, 0.96),
        (0.6896551724137931, 0.7241379310344828),
        (0.32432432432432434, 0.9459459459459459),
    ),
    formulations=(
        _loops.Formulation(joints=(4, 3, 2, 1, 0, 5), sign=-1.0),
        _loops.Formulation(joints=(1, 2, 3, 4, 5, 0), sign=1.0),
    ),
)
_ARM = _loops.general_numbers(_WHOLE, _LOOP)
_NO_FREE = np.zeros(0)
_solved_whole = _solver.all_joints


@_inner
def _all_joints(pose, seed):
    """All solutions, which rows hold one, and where a joint was indeterminate."""
    return _solved_whole(_ARM, pose, _NO_FREE, seed)


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
    _compiled.compile_apart()


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
