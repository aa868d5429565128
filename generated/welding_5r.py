"""welding_5r: Welding arm with five joints, its torch tilted aside.

Inverse kinematics, generated from robots/welding_5r.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/welding_5r.yaml. The formulas and where they come from: welding_5r.md.

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

NAME = "welding_5r"
METHOD = "quartic"
DOF = 5
JOINT_TYPES = "RRRRR"
JOINT_LIMITS = (
    (-2.9670597283903604, 2.9670597283903604),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "root1-elbow+",
    "root1-elbow-",
    "root2-elbow+",
    "root2-elbow-",
    "root3-elbow+",
    "root3-elbow-",
    "root4-elbow+",
    "root4-elbow-",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.3  # joint offset 1 [m]
a1 = 0.08  # link length 1 [m]
L2 = 0.5  # link length 2 [m]
L3 = 0.45  # link length 3 [m]
d4 = 0.03  # joint offset 4 [m]
d5 = 0.12  # joint offset 5 [m]
ex = 0.02  # x of the tool frame [m]
ez = 0.1  # z of the tool frame [m]
free_limit2 = 2.5600000000000004e-12  # a length that fixes no angle [m^2]
square_rounding = 1e-15  # squares are rounded by this
near_limit = 0.001  # a length whose direction is good to few digits
double_root = 1e-13  # a polynomial's value at a root, relative to its coefficients
free_limit_squared = 1e-24  # square of a length that fixes no angle
near_limit_squared = 1e-06  # square of a length whose direction is good to few digits
longest3 = 0.9025  # square of the longest reach [m^2]
shortest3 = 0.0024999999999999988  # square of the shortest reach [m^2]
longest3_reach = 0.902530400256  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0024984002559999986  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.9024999999999695  # the longest, where branches merge [m^2]
shortest3_apart = 0.002500000000001599  # the shortest, where branches merge [m^2]
longest3_clear = 0.9024999999696  # the longest, where blurred branches do [m^2]
shortest3_clear = 0.002500000001599999  # the shortest, where blurred branches do [m^2]
free_limit_squared2 = 2.5600000000000005e-24  # square of a length that fixes no angle [m^2]
# square of a length whose direction is good to few digits [m^2]
near_limit_squared2 = 2.5600000000000005e-06
k1 = 0.5  # 1 / 2
k2 = 0.06  # d4 * 2 [m]
k3 = 0.0009  # d4^2 [m^2]
k4 = 0.0004  # ex^2 [m^2]
k5 = -50.0  # -1 / ex [m^-1]
k6 = 0.4525  # L2^2 + L3^2 [m^2]
k7 = 2.2222222222222223  # 1 / (2 * L3 * L2) [m^-2]

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




@_inner
def _horner(p0, p1, p2, p3, p4, t):
    return (((p4 * t + p3) * t + p2) * t + p1) * t + p0


@_inner
def _bracketed(p0, p1, p2, p3, p4, low, high, at_low):
    """The root between two points with values of unlike sign."""
    t = 0.5 * (low + high)
    for _ in range(100):
        value = _horner(p0, p1, p2, p3, p4, t)
        slope = ((4.0 * p4 * t + 3.0 * p3) * t + 2.0 * p2) * t + p1
        if (value < 0.0) == (at_low < 0.0):
            low = t
        else:
            high = t
        following = t - value / slope if slope != 0.0 else low
        if not low < following < high:
            following = 0.5 * (low + high)
        if abs(following - t) <= 2e-16 * abs(t):
            return following
        t = following
    return t


@_inner
def _between(p0, p1, p2, p3, p4, edges, count, tolerance, found):
    """Roots, into `found`, of a polynomial that is monotone between neighbouring edges."""
    roots = 0
    before, at_before = edges[0], _horner(p0, p1, p2, p3, p4, edges[0])
    for k in range(1, count):
        edge = edges[k]
        value = _horner(p0, p1, p2, p3, p4, edge)
        size = 1.0 + edge * edge
        if k < count - 1 and abs(value) <= tolerance * size * size:
            value = 0.0
        if at_before * value < 0.0:
            found[roots] = _bracketed(p0, p1, p2, p3, p4, before, edge, at_before)
            roots += 1
        elif value == 0.0 and k < count - 1:
            found[roots] = edge
            roots += 1
        before, at_before = edge, value
    return roots


@_inner
def _circle_roots(a0, a1, b1, a2, b2, rounding, moved):
    """Roots, ascending in (-pi, pi], of a0 + a1 cos x + b1 sin x + a2 cos 2x + b2 sin 2x; else NaN.

    Seen from a point where it is large, it is a quartic in the half-angle tangent with a large
    leading coefficient; its roots lie between those of its derivative, those between the
    roots of the second derivative. Second comes which are close, where the slope is small: one may
    stand for two, or has another beside it. Rounding may add so much to values. All roots are moved
    by an angle in the end.
    """
    x, close = np.full(4, math.nan), np.zeros(4, np.bool_)
    size = abs(a0) + abs(a1) + abs(b1) + abs(a2) + abs(b2)
    if not (size > 0.0 and math.isfinite(size)):
        return x, close
    best, apart = -1.0, 0.0
    for k in range(16):
        at = turn * k / 16
        c, s = math.cos(at), math.sin(at)
        value = abs(a0 + a1 * c + b1 * s + a2 * (c * c - s * s) + 2.0 * b2 * c * s)
        if value > best:
            best, apart = value, at
    c, s = -math.cos(apart), -math.sin(apart)
    u1, v1 = a1 * c + b1 * s, b1 * c - a1 * s
    c2, s2 = c * c - s * s, 2.0 * c * s
    u2, v2 = a2 * c2 + b2 * s2, b2 * c2 - a2 * s2
    lead = a0 - u1 + u2
    p0, p1 = (a0 + u1 + u2) / lead, 2.0 * (v1 + 2.0 * v2) / lead
    p2, p3 = 2.0 * (a0 - 3.0 * u2) / lead, 2.0 * (v1 - 2.0 * v2) / lead
    bound = 1.0 + max(abs(p0), abs(p1), abs(p2), abs(p3))
    edges, extrema = np.empty(5), np.empty(4)
    half = 0.25 * p3
    square = half * half - p2 / 6.0
    count = 0
    edges[0] = -bound
    if square > 0.0:
        edges[1], edges[2] = -half - math.sqrt(square), -half + math.sqrt(square)
        count = 2
    edges[count + 1] = bound
    count = _between(p1, 2.0 * p2, 3.0 * p3, 4.0, 0.0, edges, count + 2, 0.0, extrema)
    for k in range(count):
        edges[k + 1] = extrema[k]
    edges[count + 1] = bound
    tolerance = (1e-13 * size + rounding) / abs(lead)
    count = _between(p0, p1, p2, p3, 1.0, edges, count + 2, tolerance, x)
    for k in range(count):
        at = apart + 0.5 * turn + 2.0 * math.atan(x[k])
        c, s = math.cos(at), math.sin(at)
        slope = b1 * c - a1 * s + 2.0 * b2 * (c * c - s * s) - 4.0 * a2 * c * s
        flat = abs(slope) <= 0.0001 * size
        if not flat:
            at -= (a0 + a1 * c + b1 * s + a2 * (c * c - s * s) + 2.0 * b2 * c * s) / slope
        at -= turn * math.ceil(at / turn - 0.5)
        place = k
        while place > 0 and x[place - 1] > at:
            x[place], close[place] = x[place - 1], close[place - 1]
            place -= 1
        x[place], close[place] = at, flat
    for k in range(4):
        x[k] += moved
    return x, close
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
    x3_z = s2 * c3 + c2 * s3
    v3 = v1 * c3 + x2_x * s3
    v4 = v2 * c3 + x2_y * s3
    y3_z = c2 * c3 - s2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - v3 * s4
    x4_y = x3_y * c4 - v4 * s4
    x4_z = x3_z * c4 + y3_z * s4
    z4_x = v3 * c4 + x3_x * s4
    z4_y = v4 * c4 + x3_y * s4
    z4_z = x3_z * s4 - y3_z * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 + s1 * s5
    x5_y = x4_y * c5 - c1 * s5
    x5_z = x4_z * c5
    z5_y = c1 * c5 + x4_y * s5
    z5_z = x4_z * s5
    z5_x = x4_x * s5 - s1 * c5
    T[0, 0] = x5_x
    T[0, 1] = z4_x
    T[0, 2] = z5_x
    T[0, 3] = c1 * a1 + x2_x * L2 + x3_x * L3 + s1 * d4 + z4_x * d5 + x5_x * ex + z5_x * ez
    T[1, 0] = x5_y
    T[1, 1] = z4_y
    T[1, 2] = z5_y
    T[1, 3] = s1 * a1 + x2_y * L2 + x3_y * L3 - c1 * d4 + z4_y * d5 + x5_y * ex + z5_y * ez
    T[2, 0] = x5_z
    T[2, 1] = z4_z
    T[2, 2] = z5_z
    T[2, 3] = d1 + s2 * L2 + x3_z * L3 + z4_z * d5 + x5_z * ex + z5_z * ez
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
    p2_x = p1_x + x2_x * L2
    p2_y = p1_y + x2_y * L2
    p2_z = d1 + s2 * L2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v1 * s3
    x3_y = x2_y * c3 - v2 * s3
    x3_z = s2 * c3 + c2 * s3
    v3 = v1 * c3 + x2_x * s3
    v4 = v2 * c3 + x2_y * s3
    y3_z = c2 * c3 - s2 * s3
    p3_x = p2_x + x3_x * L3
    p3_y = p2_y + x3_y * L3
    p3_z = p2_z + x3_z * L3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - v3 * s4
    x4_y = x3_y * c4 - v4 * s4
    x4_z = x3_z * c4 + y3_z * s4
    z4_x = v3 * c4 + x3_x * s4
    z4_y = v4 * c4 + x3_y * s4
    p4_x = p3_x + s1 * d4
    p4_y = p3_y - c1 * d4
    z4_z = x3_z * s4 - y3_z * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    J21 = p4_x + z4_x * d5 + (x4_x * c5 + s1 * s5) * ex + (x4_x * s5 - s1 * c5) * ez
    v5 = p4_y + z4_y * d5 + (x4_y * c5 - c1 * s5) * ex + (c1 * c5 + x4_y * s5) * ez
    v6 = p3_z + z4_z * d5 + x4_z * c5 * ex + x4_z * s5 * ez
    v7 = v6 - d1
    v8 = v6 - p2_z
    v9 = v6 - p3_z
    v10 = J21 - p4_x
    v11 = v5 - p4_y
    J[0, 0] = -v5
    J[0, 1] = -(c1 * v7)
    J[0, 2] = -(c1 * v8)
    J[0, 3] = -(c1 * v9)
    J[0, 4] = z4_y * v9 - z4_z * v11
    J[1, 0] = J21
    J[1, 1] = -(s1 * v7)
    J[1, 2] = -(s1 * v8)
    J[1, 3] = -(s1 * v9)
    J[1, 4] = z4_z * v10 - z4_x * v9
    J[2, 1] = s1 * (v5 - p1_y) + c1 * (J21 - p1_x)
    J[2, 2] = s1 * (v5 - p2_y) + c1 * (J21 - p2_x)
    J[2, 3] = s1 * (v5 - p3_y) + c1 * (J21 - p3_x)
    J[2, 4] = z4_x * v11 - z4_y * v10
    J[3, 1] = s1
    J[3, 2] = s1
    J[3, 3] = s1
    J[3, 4] = z4_x
    J[4, 1] = -c1
    J[4, 2] = -c1
    J[4, 3] = -c1
    J[4, 4] = z4_y
    J[5, 0] = 1.0
    J[5, 4] = z4_z
    return J


_CLOSE = 64  # roots nearly meet: the row may stand between two solutions


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
    x3_z = s2 * c3 + c2 * s3
    v3 = v1 * c3 + x2_x * s3
    v4 = v2 * c3 + x2_y * s3
    y3_z = c2 * c3 - s2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - v3 * s4
    x4_y = x3_y * c4 - v4 * s4
    x4_z = x3_z * c4 + y3_z * s4
    z4_x = v3 * c4 + x3_x * s4
    z4_y = v4 * c4 + x3_y * s4
    z4_z = x3_z * s4 - y3_z * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 + s1 * s5
    x5_y = x4_y * c5 - c1 * s5
    x5_z = x4_z * c5
    z5_y = c1 * c5 + x4_y * s5
    z5_z = x4_z * s5
    z5_x = x4_x * s5 - s1 * c5
    miss = 0.0
    off = z5_x - pose[2]
    miss += (1.0 * off) ** 2
    off = c1 * a1 + x2_x * L2 + x3_x * L3 + s1 * d4 + z4_x * d5 + x5_x * ex + z5_x * ez - pose[3]
    miss += (0.625 * off) ** 2
    off = z5_y - pose[6]
    miss += (1.0 * off) ** 2
    off = s1 * a1 + x2_y * L2 + x3_y * L3 - c1 * d4 + z4_y * d5 + x5_y * ex + z5_y * ez - pose[7]
    miss += (0.625 * off) ** 2
    off = z5_z - pose[10]
    miss += (1.0 * off) ** 2
    off = d1 + s2 * L2 + x3_z * L3 + z4_z * d5 + x5_z * ex + z5_z * ez - pose[11]
    miss += (0.625 * off) ** 2
    return math.sqrt(miss)


# The joints that are solved for, and whether they turn; what a step of one means, in rad or
# lengths, and the same over the arm's size. Below, u are these joints in units.
_SOLVED = np.array([0, 1, 2, 3, 4])
_TURNING = np.array([True, True, True, True, True])
_UNIT = np.array([1.0, 1.0, 1.0, 1.0, 1.0])
_MEASURE = np.array([0.625, 0.625, 0.625, 0.625, 0.625])


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
    for j in range(5):
        q[_SOLVED[j]] = _UNIT[j] * u[j]
    P, J = fk(q), jacobian(q)
    for j in range(5):
        column = _SOLVED[j]
        A[0, j] = _MEASURE[j] * J[0, column]
        A[1, j] = _MEASURE[j] * J[1, column]
        A[2, j] = _MEASURE[j] * J[2, column]
        along = P[0, 2] * J[3, column] + P[1, 2] * J[4, column] + P[2, 2] * J[5, column]
        for i in range(3):  # turning about z changes nothing
            A[3 + i, j] = J[3 + i, column] - along * P[i, 2]
    e[0] = (T[0, 3] - P[0, 3]) / 1.6
    e[1] = (T[1, 3] - P[1, 3]) / 1.6
    e[2] = (T[2, 3] - P[2, 3]) / 1.6
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
_STRIDE = np.array([
    0.8812714616335696, 0.7766393890897682, 0.6844301295853426, 0.6031687406857283,
    0.5315553977157914,
])


@_inner
def _wrap_angles(u):
    """Moves angles by whole turns to (-pi, pi]."""
    for j in range(5):
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
    for j in range(5):
        longest = max(longest, abs(step[j]))
    for j in range(5):
        step[j] *= 2.0 / longest


@_inner
def _damped_step(A, e, length, little, step):
    """The damped least squares step A' (A A' + damping)^-1 e, `little` the least damping.

    The rows of A, each with its share of the damping's root behind it, are made orthonormal one
    after another (modified Gram-Schmidt; used as by A. Bjorck, Numerics of Gram-Schmidt
    orthogonalization, 1994): the product A A' would lose half of the digits.
    """
    damping = 0.1 * min(length * length, 1.0) + little
    rows, y = np.zeros((6, 11)), np.empty(6)
    total = np.zeros(11)
    for i in range(6):
        for j in range(5):
            rows[i, j] = A[i, j]
        rows[i, 5 + i] = math.sqrt(damping)
        y[i] = e[i]
        for k in range(i):
            along = 0.0
            for j in range(11):
                along += rows[k, j] * rows[i, j]
            for j in range(11):
                rows[i, j] -= along * rows[k, j]
            y[i] -= along * y[k]
        square = 0.0
        for j in range(11):
            square += rows[i, j] * rows[i, j]
        inverse = 1.0 / math.sqrt(square)
        y[i] *= inverse
        for j in range(11):
            rows[i, j] *= inverse
    for i in range(5, -1, -1):
        missing = y[i]
        for j in range(11):
            missing -= rows[i, j] * total[j]
        for j in range(11):
            total[j] += missing * rows[i, j]
    for j in range(5):
        step[j] = total[j]


@_apart("float64(float64[:, ::1], int64, float64, float64[::1], float64[::1])")
def _descended(T, steps, exact, q, ahead):
    """Takes a row as far as steps help, and tells how long another one would be, into `ahead`.

    Returns by how much the row misses the pose then. Beside a singular place a step that is right
    may be long, and what it leaves, half of its square, far more than was missed.
    """
    e, A = np.empty(6), np.empty((6, 5))
    joints, u, step = q.copy(), np.empty(5), np.empty(5)
    for j in range(5):
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
        for j in range(5):
            u[j] += step[j]
            way += abs(step[j])
        last, left = length, 0.5 * way * way
    _wrap_angles(best)
    for j in range(5):
        q[_SOLVED[j]] = _UNIT[j] * best[j]
    return least


@_inner
def _sideways(A, along):
    """The part of a generic direction that leaves the tool where it is, to first order, one long.

    Returns how long it was.
    """
    moved, square = np.empty(6), 0.0
    for i in range(6):
        moved[i] = 0.0
        for j in range(5):
            moved[i] += A[i, j] * _STRIDE[j]
    _damped_step(A, moved, 0.0, 1e-13, along)
    for j in range(5):
        along[j] = _STRIDE[j] - along[j]
        square += along[j] * along[j]
    length = math.sqrt(square)
    for j in range(5):
        along[j] /= length
    return length


@_apart("float64(float64[:, ::1], float64, float64[::1])")
def _escaped(T, exact, q):
    """Takes a row as far as steps help, also from both sides of where they get slow.

    Where many solutions meet, joint values between them are singular. A root of four is missed by
    the fourth power of the way to it. Returns by how much the row misses the pose then.
    """
    e, A = np.empty(6), np.empty((6, 5))
    u, along, ahead = np.empty(5), np.empty(5), np.empty(1)
    ends, miss = np.empty((2, 5)), np.empty(2)
    least = _descended(T, 72, exact, q, ahead)
    for _ in range(8):
        if least <= exact:
            break
        for j in range(5):
            u[j] = q[_SOLVED[j]] / _UNIT[j]
        _look(T, q.copy(), u, e, A)
        if _sideways(A, along) <= 0.0001:
            break
        pace = math.sqrt(math.sqrt(least))
        for side in range(2):
            _take(ends[side], q)
            for j in range(5):
                ends[side, _SOLVED[j]] += pace * _UNIT[j] * along[j]
            pace = -pace
            miss[side] = _descended(T, 72, exact, ends[side], ahead)
        other = 1 if miss[1] < miss[0] else 0
        if not miss[other] < 0.9 * least:
            break
        least = miss[other]
        _take(q, ends[other])
    return least


@_inner
def _tightened(T, exact, first, q):
    """Takes a row to where damped least squares lead, unless it is exact.

    Returns by how much it misses the pose then, and whether it was moved; `first` is what it misses
    the pose by before.
    """
    if first <= exact:
        return first, False
    end, moved = q.copy(), False
    least = _escaped(T, exact, end)
    for i in range(5):
        moved = moved or q[i] != end[i]
        q[i] = end[i]
    return least, moved


@_inner
def _gap_between(q, other):
    """By how much the joint values of two rows differ at most."""
    gap = np.empty(5)
    for j in range(5):
        gap[j] = (q[_SOLVED[j]] - other[_SOLVED[j]]) / _UNIT[j]
    _wrap_angles(gap)
    return np.abs(gap).max()


@_inner
def _repeats(q, held, first, row):
    """Whether a row that was moved came to lie on one that missed by less at first."""
    for k in range(8):
        before = first[k] < first[row] or (k < row and first[k] <= first[row])
        if held[k] and before and _gap_between(q[k], q[row]) < 1e-06:
            return True
    return False


@_inner
def _exactness(pose):
    """What an exact row may miss: far away rounding is more."""
    distance = 1.0  # arm sizes
    distance = max(distance, abs(pose[3]) / 1.6)
    distance = max(distance, abs(pose[7]) / 1.6)
    distance = max(distance, abs(pose[11]) / 1.6)
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
    """Tightens the rows; ends those that miss the pose then, and all but one that have become the
    same."""
    moved, first = np.zeros(8, np.bool_), miss.copy()
    for row in range(8):
        if held[row]:
            miss[row], moved[row] = _tightened(T, exact, miss[row], q[row])
    enough = 10.0 * exact
    for row in range(8):
        held[row] = held[row] and miss[row] <= enough
    for row in range(8):
        if moved[row] and _repeats(q, held, first, row):
            held[row] = False


@_inner
def _tighten(pose, q, status):
    """Tightens the rows that have a solution; some may have none then."""
    exact = _exactness(pose)
    worst, miss = 0.0, carray(_room(8), 8)
    for row in range(8):
        miss[row] = 0.0 if status[row] == UNREACHABLE else _missed_by(pose, q[row])
        worst = max(worst, miss[row])
    if worst <= exact:
        return
    rows, held = q.copy(), np.empty(8, np.bool_)
    for row in range(8):
        held[row] = status[row] != UNREACHABLE
    _tighten_rows(_upper_rows(pose), exact, miss, rows, held)
    for row in range(8):
        if not held[row]:
            status[row] = UNREACHABLE
        for i in range(5):
            q[row, i] = rows[row, i] if held[row] else math.nan


@_inner
def _solve(pose, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others.

    The first value of a row that is _LOST says how far it is from a solution (negative).
    """
    _, _, T13, T14, _, _, T23, T24, _, _, T33, T34 = pose

    # theta1, type 9: U1[3, 4] and U1[3, 3]
    v1 = ex * T23
    v2 = ex * T13
    v3 = ez * T23 - T24
    v4 = T14 - ez * T13
    v5 = v1 * v1
    v6 = v2 * v2
    v7 = v3 * v3
    v8 = v4 * v4
    v9 = v3 * k2
    v10 = v4 * k2
    v11 = k1 * (v5 + v6) + (k3 + k1 * (v7 + v8))
    v12 = k1 * (v5 - v6) + k1 * (v7 - v8)
    v13 = v3 * v4 - v1 * v2
    v14 = v11 - k4
    v15 = abs(v14) + abs(v9) + abs(v10) + abs(v12) + abs(v13)
    free1 = v15 <= free_limit2
    v16 = square_rounding * (v11 + k4)
    x1_roots, x1_close = _circle_roots(1.0 if free1 else v14, -1.0 if free1 else -v9, 0.0 if free1
        else -v10, 0.0 if free1 else v12, 0.0 if free1 else v13, v16, moved)
    v19 = math.cos(seed[0]) * math.cos(seed[0]) - math.sin(seed[0]) * math.sin(seed[0])
    v20 = 2.0 * (math.cos(seed[0]) * math.sin(seed[0]))
    v21 = 2.0 * v13
    v22 = 2.0 * v12
    v24 = v15 * near_limit
    v25 = v19 * v21 + (v9 * math.sin(seed[0]) - v10 * math.cos(seed[0])) - v20 * v22
    v26 = (
        abs(v14 + (v13 * v20 + (v12 * v19 - (v9 * math.cos(seed[0]) + v10 * math.sin(seed[0]))))) <=
        v16 + v15 * double_root
    )

    # theta234, type 3: U1[2, 3] and U1[1, 3]
    v28 = seed[1] + seed[2] + seed[3]

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v30 = T34 - d1

    for i1 in range(4):  # root1, root2, root3, root4
        x1 = x1_roots[i1]
        # theta1
        if not (x1 <= 4.0):
            continue  # out of reach
        v17 = math.cos(x1)
        v18 = math.sin(x1)
        v23 = (v17 * v17 - v18 * v18) * v21 + (v9 * v18 - v10 * v17) - 2.0 * (v17 * v18) * v22
        near1 = abs(v23) <= v24
        same1 = (
            -(double_root * (v15 * v15)) <= v23 * v25 and 0.0 < v17 * math.cos(seed[0]) + v18 *
            math.sin(seed[0]) and abs(v17 * math.sin(seed[0]) - v18 * math.cos(seed[0])) <=
            near_limit and near1 and v26
        )
        v27 = seed[0] if same1 else x1
        q1 = seed[0] if free1 else v27
        c1 = math.cos(q1)
        s1 = math.sin(q1)

        # theta5, type 3: U1[3, 4] and U1[3, 3]
        Z2_5 = T13 * s1 - T23 * c1
        s5 = (d4 - (T14 * s1 - T24 * c1) + ez * Z2_5) * k5
        c5 = ex * Z2_5 * k5
        q5 = _atan2(s5, c5)

        # theta234
        S234 = s5 * T33
        C234 = s5 * (T13 * c1 + T23 * s1)
        w234 = math.sqrt(S234 * S234 + C234 * C234)
        free234 = w234 <= free_limit_squared
        near234 = w234 <= near_limit_squared
        factor234 = 1.0 / (1.0 if free234 else w234)
        c234 = math.cos(v28) if free234 else C234 * factor234
        s234 = math.sin(v28) if free234 else S234 * factor234
        theta234 = _atan2(s234, c234)

        # theta3
        v29 = ex * c5 + ez * s5
        Z1_3 = c234 * d5 - s234 * v29 + v30
        Z2_3 = T14 * c1 + T24 * s1 - a1 - (c234 * v29 + s234 * d5)
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
        K3 = N3 - k6
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            if near1:
                status[2 * i1] = _NEARLY + 1
                q[2 * i1, 0] = D3
                q[2 * i1, 1] = v27
            if free1:
                status[2 * i1] = _LOST + 1
                q[2 * i1, 0] = D3
            if free234:
                status[2 * i1] = _LOST + 2
                q[2 * i1, 0] = D3
            if free234:
                status[2 * i1] = _LOST + 3
                q[2 * i1, 0] = D3
            if free234:
                status[2 * i1] = _LOST + 4
                q[2 * i1, 0] = D3
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        c3 = K3 * k7

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        X1_2 = L2 + L3 * c3
        v31 = Z1_3 * X1_2
        v32 = Z2_3 * X1_2

        for i2 in range(2):  # elbow+, elbow-
            e2 = 1.0 - 2.0 * i2
            # theta3
            if (
                e2 < 0.0 and (not apart3 or (near1 and not (shortest3_clear < N3 and N3 <
                longest3_clear)))
            ):
                continue  # both signs give the same
            s3 = w3 * e2 * k7
            q3 = _atan2(s3, c3)

            # theta2
            Y1_2 = L3 * s3
            S2 = v31 - Z2_3 * Y1_2
            C2 = v32 + Z1_3 * Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            near2 = w2 <= near_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else S2 * factor2
            q2 = _atan2(s2, c2)

            # joint values
            q4 = _wrap(theta234 - (q3 + q2))
            row = 2 * i1 + i2
            q[row, 0] = q1
            q[row, 1] = q2
            q[row, 2] = q3
            q[row, 3] = q4
            q[row, 4] = q5
            status[row] = (
                FREE_JOINT if free1 or free234 or free2 else _CLOSE if x1_close[i1] or near1 or
                near234 or near2 else OK
            )


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
    for i in range(5):
        total += abs(_overshoot(i, values[i]))
    return total


@_inner
def _without_turns(angle):
    """An angle without its whole turns, by which a search could not tell small moves."""
    return math.copysign(abs(angle) % turn, angle)


_CHOOSABLE = (3, 2, 1, 0,)  # joints, from 0, that may be free


@_inner
def _serves(search, q, status):
    """Whether a row was solved, as exactly as poses may be rounded."""
    if search[2] and _beyond_limits(q[search[0]]) > 0.0:
        return False
    return status[search[0]] != UNREACHABLE and status[search[0]] < _LOST


@_inner
def _shortfall(pose, row, q, status):
    """How far a row is from a solution: 0 if it is solved.
    """
    if status[row] >= _LOST:
        return q[row, 0]
    return -math.inf if status[row] == UNREACHABLE else 0.0


@_inner
def _attempt(pose, seed, search, moved, q, status):
    """Solves with a joint moved: 0 if it serves, else less.

    A search is a row, the joint that had been chosen, whether limits count, and by how much roots
    are moved.
    """
    row, joint = search[0], search[1]
    for i in range(8):
        status[i] = UNREACHABLE
    kept = seed[joint]
    seed[joint] = kept + moved
    _solve(pose, seed, search[3], q, status)
    seed[joint] = kept
    result = _shortfall(pose, row, q, status)
    return -_beyond_limits(q[row]) if search[2] and result == 0.0 else result


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
    # beside a place where the branches meet, this one has no solution of its own
    for moved in (top - 1e-09, top + 1e-09):
        if math.isinf(_attempt(pose, seed, search, moved, q, status)):
            return math.nan
    _attempt(pose, seed, search, top, q, status)
    return top if _serves(search, q, status) else math.nan


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
def _serving_digits(pose, seed, search, q, status):
    """The same for a joint that is nearly free: its angle is known to few digits.

    Also where the arm just reaches (an elbow that is stretched). As long as the angle is right up
    to rounding of what it was taken from, `_solve` takes it as it would take its own.
    """
    before, past = np.full(2, -math.inf), np.zeros(2)
    moved = 1e-15
    while moved < 0.1:
        for way in range(2):
            there = -moved if way else moved
            here = _attempt(pose, seed, search, there, q, status)
            if here == 0.0:
                return there
            if here < 2.0 * before[way] and past[way] == 0.0:
                past[way] = 1.0
                low = 0.25 * there
                top = _summit(pose, seed, search, low, there, q, status)
                if not math.isnan(top):
                    return top
            before[way] = here
        moved *= 2.0
    return math.nan


@_inner
def _choose_again(pose, given, row, q, status):
    """A free joint took the seed's value, and then the arm could not reach.

    The joint takes the nearest value that serves.
    """
    nearly = status[row] > _NEARLY
    search = row, status[row] - (_NEARLY if nearly else _LOST) - 1, False, 0.0
    seed, trial, result = given.copy(), q.copy(), status.copy()
    if nearly:
        seed[search[1]] = q[row, 1]
        moved = _serving_digits(pose, seed, search, trial, result)
    else:
        seed[search[1]] = _without_turns(seed[search[1]])
        moved = _serving(pose, seed, search, trial, result)
    _attempt(pose, seed, search, moved, trial, result)
    served = not math.isnan(moved) and _serves(search, trial, result)
    status[row] = result[row] if served else UNREACHABLE
    for i in range(5):
        q[row, i] = trial[row, i] if served else math.nan


@_inner
def _hopeless(pose, seed, search, q, status):
    """Whether a joint beyond its limits stays where it is when the one that is searched moves."""
    row = search[0]
    _attempt(pose, seed, search, 0.0, q, status)
    if _shortfall(pose, row, q, status) < 0.0:
        return False
    values = q[row].copy()
    _attempt(pose, seed, search, 0.1, q, status)
    if _shortfall(pose, row, q, status) < 0.0:
        return False
    for i in range(5):
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
    for i in range(5):
        seed[i] -= _overshoot(i, seed[i])
    for joint in _CHOOSABLE:
        inside, search = seed[joint], (row, joint, True, 0.0)
        seed[joint] = _without_turns(given[joint])
        if not _hopeless(pose, seed, search, trial, result):
            moved = _serving(pose, seed, search, trial, result)
            # beside the solution of another row this one has none
            start = _attempt(pose, seed, search, 0.0, trial, result)
            own = abs(moved) >= 1e-06 or not math.isinf(start)
            if own and not math.isnan(moved):
                _attempt(pose, seed, search, moved, trial, result)
                for i in range(5):
                    q[row, i] = trial[row, i]
                status[row] = result[row]
                return
        seed[joint] = inside


@_apart("void(UniTuple(float64, 12), float64[::1], float64[:, ::1], uint8[::1])")
def _other_choices(pose, seed, q, status):
    """Other values for free joints, in rows that the seed's do not serve."""
    for row in range(8):
        if status[row] >= _LOST:
            _choose_again(pose, seed, row, q, status)
        if status[row] == FREE_JOINT and _beyond_limits(q[row]) > 0.0:
            _keep_limits(pose, seed, row, q, status)


@_inner
def _choose(pose, seed, q, status):
    """The same where there is a row that needs it."""
    served = True
    for row in range(8):
        served = served and status[row] < _LOST
        served = served and not (status[row] == FREE_JOINT and _beyond_limits(q[row]) > 0.0)
    if served:
        return
    # arrays of the caller may have any layout
    values, rows, kinds = np.empty(5), np.empty((8, 5)), np.empty(8, np.uint8)
    for row in range(8):
        kinds[row] = status[row]
        for i in range(5):
            values[i], rows[row, i] = seed[i], q[row, i]
    _other_choices(pose, values, rows, kinds)
    for row in range(8):
        status[row] = kinds[row]
        for i in range(5):
            q[row, i] = rows[row, i]


@_inner
def _solves(T, steps, exact, q):
    """Whether joint values are a solution.

    Beside a singular place they may miss the pose by next to nothing and be far from any.
    """
    ahead = np.empty(1)
    return _descended(T, steps, exact, q, ahead) <= exact and ahead[0] <= 0.0001


@_inner
def _is_new(known, count, q):
    """Whether a solution is none of those."""
    for k in range(count):
        if _gap_between(known[k], q) < 0.001:
            return False
    return True


@_inner
def _keep(known, count, q):
    """Puts a solution behind those that are known, unless it is one of them; how many there are."""
    if not _is_new(known, count, q):
        return count
    _take(known[count], q)
    return count + 1


@_inner
def _leads(pose, T, seed, angle, row, exact, end):
    """Whether the row of a root that is moved leads to a solution, and to which."""
    q, kind = np.empty((8, 5)), np.empty(8, np.uint8)
    kind[:] = UNREACHABLE
    _solve(pose, seed, angle, q, kind)
    if kind[row] == UNREACHABLE or kind[row] > _CLOSE:  # lost
        return False
    _take(end, q[row])
    return _solves(T, 72, exact, end)


_BESIDE = (3.0517578125e-05, -3.0517578125e-05, 3.814697265625e-06, -3.814697265625e-06, 4.76837158203125e-07, -4.76837158203125e-07, 5.960464477539063e-08, -5.960464477539063e-08, 7.450580596923828e-09, -7.450580596923828e-09, 9.313225746154785e-10, -9.313225746154785e-10, 1.1641532182693481e-10, -1.1641532182693481e-10, 1.4551915228366852e-11, -1.4551915228366852e-11, 1.8189894035458565e-12, -1.8189894035458565e-12)


@_apart("void(UniTuple(float64, 12), float64[::1], float64[:, ::1], uint8[::1])")
def _beside(pose, seed, q, status):
    """Solutions for the rows that stand between two of them, which are known by no more than that.

    Steps from a row lead to one; the root of the other is as far from it on the other side. A row may
    have taken the seed's value for its root, which is one of the two and hides the middle: the roots'
    own rows have a seed that is turned away.
    """
    T, exact = _upper_rows(pose), _exactness(pose)
    known, count = np.empty((16, 5)), 0
    doubtful = np.zeros(8, np.bool_)
    own, kind = np.empty((8, 5)), np.empty(8, np.uint8)
    kind[:] = UNREACHABLE
    away = seed.copy()
    away[0] += 2.0
    _solve(pose, away, 0.0, own, kind)
    for row in range(8):
        if kind[row] == UNREACHABLE or kind[row] > _CLOSE:  # lost
            _take(own[row], q[row])
        if status[row] == _CLOSE:
            doubtful[row] = not _solves(T, 0, exact, own[row].copy())
            status[row] = OK
        if status[row] != UNREACHABLE and not doubtful[row]:
            _take(known[count], q[row])
            count += 1
    others, after = count, count
    other = np.empty(5)
    for row in range(8):
        if not doubtful[row]:
            continue
        end = q[row].copy()
        # long steps may lead to solutions of other roots, which are known
        found = _solves(T, 72, exact, end) and _is_new(known, others, end)
        for angle in _BESIDE:
            if found or not _leads(pose, T, away, angle, row, exact, end):
                continue
            found = _is_new(known, others, end)
        if not found:
            continue
        status[row] = UNREACHABLE
        count = _keep(known, count, end)
        off = 0.0
        off += end[0] - own[row, 0]
        off -= 6.283185307179586 * math.ceil(off / 6.283185307179586 - 0.5)
        for part in (0.0, -1.0, -2.0, -0.5, -4.0):  # of the way to the one that is known
            if not _leads(pose, T, away, part * off, row, exact, other):
                continue
            if _is_new(known, others, other) and _gap_between(end, other) >= 0.001:
                count = _keep(known, count, other)
                break
    for k in range(after, count):  # whichever roots rounding told apart: the row that was nearest
        place, least = -1, math.inf
        for row in range(8 - 1, -1, -1):
            gap = math.inf if math.isnan(q[row, 0]) else _gap_between(q[row], known[k])
            if status[row] == UNREACHABLE and gap <= least:
                place, least = row, gap
        if place >= 0:
            _take(q[place], known[k])
            status[place] = OK
    for row in range(8):
        if status[row] == UNREACHABLE:
            q[row, :] = math.nan


@_inner
def _both_sides(pose, seed, q, status):
    """Solutions for the rows of roots that nearly meet, which may stand between two."""
    close = False
    for row in range(8):
        close = close or status[row] == _CLOSE
    if not close:
        return
    rows, kinds = q.copy(), status.copy()
    _beside(pose, seed.copy(), rows, kinds)
    for row in range(8):
        status[row] = kinds[row]
        for i in range(5):
            q[row, i] = rows[row, i]


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.625, 0.625, 0.625, 1.0, 1.0, 1.0])


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

    If enough is NaN, to some inside their limits that miss it hardly more. Returns if it can.
    Damped least squares, while they gain: where roots meet a step still leaves less than half.
    Until one gains little they are damped so that none leads far.
    """
    half = np.empty(5)
    stands, moves = math.isnan(enough), 0
    held, x, settled = np.zeros(5, np.bool_), q.copy(), False
    last, lost = math.inf, 0
    for _ in range(20):
        e, miss = _miss(T, x)
        if math.isnan(enough):
            enough = miss + 1e-14
        worst, past = -1, 0.0
        for j in range(5 if stands and miss < enough else 0):
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
    x, half, to = q.copy(), np.empty(5), np.empty(5)
    if not _settle(pose, math.nan, math.inf if far else 1.5, x):
        return False
    off = _half_way(q, x, half)
    for k in range(len(rows)):
        if status[k] != UNREACHABLE and _beyond_limits(rows[k]) < beyond:
            if _half_way(rows[k], x, to) < off:
                return False
    if off >= 0.001 and not _settle(pose, 1e-12, 0.25 * off, half):
        return False
    for i in range(5):
        q[i] = x[i]
    return True


# Between which values starts lie.
_SPAN_LOW = np.array([
    -2.9670597283903604, -3.141592653589793, -3.141592653589793, -3.141592653589793,
    -3.141592653589793,
])
_SPAN_WIDTH = np.array([
    5.934119456780721, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
])


@_inner
def _start_of(k, near, u):
    """Start number k; number 0 is the seed."""
    for j in range(5):
        u[j] = near[j] if k == 0 else _SPAN_LOW[j] + _SPAN_WIDTH[j] * ((0.5 + k * _STRIDE[j]) % 1.0)


@_apart("float64(float64[:, ::1], float64[::1], float64[::1])")
def _descend(T, q, u):
    """Takes u to where damped least squares lead; returns by how much that misses the pose.

    Near to it less damping than usual leads further, where joints hardly move the tool: there a step
    that is right may be long, and what it leaves, half of its square, far more than was missed.
    """
    e, A = np.empty(6), np.empty((6, 5))
    least, best, step, little = math.inf, u.copy(), np.empty(5), 1e-13
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
        for j in range(5):
            u[j] += step[j]
            way += abs(step[j])
        last, left = length, 0.5 * way * way if little < 1e-13 else 0.0
    _take(u, best)
    return least


@_apart("int64(UniTuple(float64, 12), float64[::1], int64, float64[::1])")
def _sought(pose, seed, least, q):
    """Joint values that serve, into q, if there are some with less wrong than `least`; what is.

    Nothing is 0, 1 that they are beyond limits, 2 that they are not exact, 4 that there are none.

    Several joints may be free at once, and few of their values serve. Steps of damped least squares
    from the seed and from evenly spread starts lead to some that do, if the arm can take the pose.
    """
    T, exact = _upper_rows(pose), _exactness(pose)
    joints, near = seed.copy(), np.empty(5)
    for j in range(5):
        near[j] = seed[_SOLVED[j]] / _UNIT[j]
    u, end = np.empty(5), np.empty(5)
    for k in range(12):
        if least == 0:
            break
        _start_of(k, near, u)
        if _descend(T, joints, u) > 0.01:
            continue
        _take(end, joints)
        for j in range(5):
            end[_SOLVED[j]] = _UNIT[j] * u[j]
        miss = _escaped(T, exact, end)
        if miss > 10.0 * exact:
            continue
        if _beyond_limits(end) > 0.0:
            _settled(pose, math.nan, math.inf, end)
        fault = 2 * (miss > exact) + (_beyond_limits(end) > 0.0)
        if fault < least:
            least = fault
            _take(q, end)
    return least


@_inner
def _seek(pose, seed, begun, q, status):
    """The same into a row, if there is none, or none
    inside the limits."""
    before, chosen = 4, -1
    for row in range(8 - 1, -1, -1):
        fault, is_open = 0, status[row] == FREE_JOINT
        if status[row] == UNREACHABLE:
            continue
        fault += _beyond_limits(q[row]) > 0.0
        before = min(before, fault)
        chosen = row if is_open else chosen
    if before == 0 or (before < 4 and chosen < 0):
        return
    found = np.empty(5)
    least = _sought(pose, seed.copy(), before, found)
    if least == before:
        return
    if before < 4 and before // 2 == least // 2:  # other rows are no less exact
        for i in range(5):
            q[chosen, i] = found[i]
        return
    for row in range(8):
        status[row] = FREE_JOINT if row == begun else UNREACHABLE
        for i in range(5):
            q[row, i] = found[i] if row == begun else math.nan


@_apart("boolean(UniTuple(float64, 12), float64[::1])")
def _are_one(T, half):
    """Whether rounding alone tells two solutions that lie to both sides of joint values.

    Half way the arm is singular, and what steps in all other directions leave of the miss is how far
    the pose is from one at which both meet.
    """
    held = np.zeros(5, np.bool_)
    for _ in range(3):
        _add_step(held, 1e-13, _miss(T, half)[0], half)
    return _miss(T, half)[1] <= 1e-14


@_inner
def _tell_once(pose, q, status):
    """Ends rows that rounding alone tells from earlier ones.

    Where an earlier angle is good to fewer digits than usual branches that meet come out apart.
    """
    half = np.empty(5)
    for row in range(1, 8):
        for k in range(row):
            if status[row] == UNREACHABLE or status[k] == UNREACHABLE:
                continue
            if _half_way(q[k], q[row], half) < 0.001 and _are_one(pose, half):
                status[row] = UNREACHABLE
                for i in range(5):
                    q[row, i] = math.nan


@_inner
def _stay(pose, seed, q, status):
    """Where rounding can't tell solutions apart the arm goes on with the one that it is at.

    The solution next to the seed gets a row unless it has one: that of one beside
    it, that of one which it is told from by nothing, one that is left, or any.
    """
    x, half, place, least = np.empty(5), np.empty(5), 0, math.inf
    nearest = 0.001
    for i in range(5):
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
        for i in range(5):
            q[place, i] = x[i]


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(8):
        status[row] = UNREACHABLE
        for i in range(5):
            q[row, i] = math.nan
    _solve(pose, seed, 0.0, q, status)
    begun = -1  # the first row that was not simply out of reach
    for row in range(8 - 1, -1, -1):
        if status[row] != UNREACHABLE:
            begun = row
    _choose(pose, seed, q, status)
    _both_sides(pose, seed, q, status)
    _tighten(pose, q, status)
    if begun >= 0:
        _seek(pose, seed, begun, q, status)
    _tell_once(pose, q, status)
    _stay(pose, seed, q, status)
    count = 0
    for row in range(8):
        if status[row] == UNREACHABLE:
            continue
        _stand(pose, row, False, q, status)
        for i in range(5):
            q[row, i] = _turned(_JOINTS, i, q[row, i], 0.0)
            if not _LOWEST[i] <= q[row, i] <= _HIGHEST[i]:
                status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (8, 5) or status.shape != (8,):
        raise ValueError("T, q and status must have shapes (4, 4), (8, 5), (8,)")
    valid, pose = _read(T)
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    return _whole(pose, seed, q, status)


_FUNCTIONS = _runtime("functions")
_CALLS = _FUNCTIONS.of_robot(
    globals(),
    _HOW,
    _FUNCTIONS.Solver(
        joints=_JOINTS,
        into=_into,
        many=None,
        kinematics=(fk, jacobian),
        given=0,
        apart=(_HOW.compile_apart,),
        words={
            "no_pose": "not finite, or its z axis not of length one to six digits",
            "no_row": "the pose is out of reach",
            "allocates": "at every pose",
        },
    ),
)
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
