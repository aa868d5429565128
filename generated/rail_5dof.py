"""rail_5dof: Arm with four revolute joints on a rail.

Inverse kinematics, generated from robots/rail_5dof.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/rail_5dof.yaml. The formulas and where they come from: rail_5dof.md.

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
_of_joints = _runtime("entry").of_joints(_HOW, 5)

NAME = "rail_5dof"
METHOD = "closed form"
DOF = 5
JOINT_TYPES = "PRRRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "noflip",
    "flip",
)
MAX_SOLUTIONS = 2

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

a1 = 2.0  # link length 2 [m]
d3 = 1.0  # joint offset 3 [m]
d5 = 3.0  # joint offset 5 [m]
free_limit2 = 3.6e-11  # a length that fixes no angle [m^2]
free_limit = 1e-12  # a length that fixes no angle
doubtful_slack = 0.01  # a row may miss the pose by this before it is tightened
doubtful_slack1 = 0.06  # a row may miss the pose by this before it is tightened [m]
m1 = 1.296e-05  # doubt_limit2^2 [m^4]
m2 = 9.999999999999999e-09  # doubt_limit^2
m4 = 3.6000000000000004e-23  # exact_slack1^2 [m^2]
m5 = 1e-24  # exact_slack^2

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([6e-09, 1e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([0.027777777777777776, 1.0, 1.0, 1.0, 1.0])
_JOINTS = np.column_stack([_LOWEST, _HIGHEST, [kind == "R" for kind in JOINT_TYPES], _WEIGHT])


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (5,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 5 joint values")
    T = np.zeros((4, 4))
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = c2 * c3
    x3_y = s2 * c3
    z4_x = c2 * s3
    z4_y = s2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 + s2 * s4
    x4_y = x3_y * c4 - c2 * s4
    x4_z = s3 * c4
    y4_x = s2 * c4 - x3_x * s4
    v1 = c2 * c4 + x3_y * s4
    v2 = s3 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    T[0, 0] = x4_x * c5 - z4_x * s5
    T[0, 1] = -(z4_x * c5 + x4_x * s5)
    T[0, 2] = y4_x
    T[0, 3] = a1 + s2 * d3 + y4_x * d5
    T[1, 0] = x4_y * c5 - z4_y * s5
    T[1, 1] = -(z4_y * c5 + x4_y * s5)
    T[1, 2] = -v1
    T[1, 3] = -(c2 * d3 + v1 * d5)
    T[2, 0] = x4_z * c5 + c3 * s5
    T[2, 1] = c3 * c5 - x4_z * s5
    T[2, 2] = -v2
    T[2, 3] = q[0] - v2 * d5
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 5): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 5 joint values")
    J = np.zeros((6, 5))
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    p3_x = a1 + s2 * d3
    v1 = c2 * d3
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    z4_x = c2 * s3
    z4_y = s2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    y4_x = s2 * c4 - c2 * c3 * s4
    v2 = c2 * c4 + s2 * c3 * s4
    v3 = s3 * s4
    p5_x = p3_x + y4_x * d5
    J12 = v1 + v2 * d5
    v4 = q[0] - v3 * d5 - q[0]
    v5 = p5_x - p3_x
    v6 = v1 - J12
    J[0, 1] = J12
    J[0, 2] = -(c2 * v4)
    J[0, 3] = z4_y * v4 + c3 * v6
    J[1, 1] = p5_x - a1
    J[1, 2] = -(s2 * v4)
    J[1, 3] = -(c3 * v5 + z4_x * v4)
    J[2, 0] = 1.0
    J[2, 2] = s2 * v6 + c2 * v5
    J[2, 3] = z4_x * v6 - z4_y * v5
    J[3, 2] = s2
    J[3, 3] = z4_x
    J[3, 4] = y4_x
    J[4, 2] = -c2
    J[4, 3] = z4_y
    J[4, 4] = -v2
    J[5, 1] = 1.0
    J[5, 3] = -c3
    J[5, 4] = -v3
    return J


@_inner
def _missed_by(pose, q):
    """By how much joint values miss the entries that count: the root of the sum of squares."""
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = c2 * c3
    x3_y = s2 * c3
    z4_x = c2 * s3
    z4_y = s2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 + s2 * s4
    x4_y = x3_y * c4 - c2 * s4
    x4_z = s3 * c4
    y4_x = s2 * c4 - x3_x * s4
    v1 = c2 * c4 + x3_y * s4
    v2 = s3 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    miss = 0.0
    off = x4_x * c5 - z4_x * s5 - pose[0]
    miss += (1.0 * off) ** 2
    off = y4_x - pose[2]
    miss += (1.0 * off) ** 2
    off = a1 + s2 * d3 + y4_x * d5 - pose[3]
    miss += (0.16666666666666666 * off) ** 2
    off = x4_y * c5 - z4_y * s5 - pose[4]
    miss += (1.0 * off) ** 2
    off = -v1 - pose[6]
    miss += (1.0 * off) ** 2
    off = -(c2 * d3 + v1 * d5) - pose[7]
    miss += (0.16666666666666666 * off) ** 2
    off = x4_z * c5 + c3 * s5 - pose[8]
    miss += (1.0 * off) ** 2
    off = -v2 - pose[10]
    miss += (1.0 * off) ** 2
    off = q[0] - v2 * d5 - pose[11]
    miss += (0.16666666666666666 * off) ** 2
    return math.sqrt(miss)


# The joints that are solved for, and whether they turn; what a step of one means, in rad or
# lengths, and the same over the arm's size. Below, u are these joints in units.
_SOLVED = np.array([0, 1, 2, 3, 4])
_TURNING = np.array([False, True, True, True, True])
_UNIT = np.array([6.0, 1.0, 1.0, 1.0, 1.0])
_MEASURE = np.array([
    1.0, 0.16666666666666666, 0.16666666666666666, 0.16666666666666666, 0.16666666666666666,
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
        for i in range(3):
            A[3 + i, j] = J[3 + i, column]
    e[0] = (T[0, 3] - P[0, 3]) / 6.0
    e[1] = (T[1, 3] - P[1, 3]) / 6.0
    e[2] = (T[2, 3] - P[2, 3]) / 6.0
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
    gap = np.empty(5)
    for j in range(5):
        gap[j] = (q[_SOLVED[j]] - other[_SOLVED[j]]) / _UNIT[j]
    _wrap_angles(gap)
    return np.abs(gap).max()


@_inner
def _repeats(q, held, first, row):
    """Whether a row that was moved came to lie on one that missed by less at first."""
    for k in range(2):
        before = first[k] < first[row] or (k < row and first[k] <= first[row])
        if held[k] and before and _gap_between(q[k], q[row]) < 1e-06:
            return True
    return False


@_inner
def _exactness(pose):
    """What an exact row may miss: far away rounding is more."""
    distance = 1.0  # arm sizes
    distance = max(distance, abs(pose[3]) / 6.0)
    distance = max(distance, abs(pose[7]) / 6.0)
    distance = max(distance, abs(pose[11]) / 6.0)
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
    moved, first = np.zeros(2, np.bool_), miss.copy()
    for row in range(2):
        if held[row]:
            miss[row], moved[row] = _tightened(T, exact, miss[row], q[row])
    least = math.inf
    for row in range(2):
        if held[row]:
            least = min(least, miss[row])
    enough = exact if least <= exact else 1e-05
    for row in range(2):
        held[row] = held[row] and miss[row] <= enough
    for row in range(2):
        if moved[row] and _repeats(q, held, first, row):
            held[row] = False


@_inner
def _tighten(pose, q, status):
    """Tightens the rows that have a solution; some may have none then."""
    exact = _exactness(pose)
    worst, miss = 0.0, carray(_room(2), 2)
    for row in range(2):
        miss[row] = 0.0 if status[row] == UNREACHABLE else _missed_by(pose, q[row])
        worst = max(worst, miss[row])
    if worst <= exact:
        return
    rows, held = q.copy(), np.empty(2, np.bool_)
    for row in range(2):
        held[row] = status[row] != UNREACHABLE
    _tighten_rows(_upper_rows(pose), exact, miss, rows, held)
    for row in range(2):
        if not held[row]:
            status[row] = UNREACHABLE
        for i in range(5):
            q[row, i] = rows[row, i] if held[row] else math.nan


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # r1, type 1: U0 A5^-1 [3, 4]
    wz = T34 - T33 * d5

    # theta2, type 3: U0 A5^-1 [1, 4] and U0 A5^-1 [2, 4]
    wx = T14 - d5 * T13
    wy = T24 - d5 * T23
    v1 = d3 * (wx - a1)
    C2 = d3 * wy
    w2 = math.sqrt(v1 * v1 + C2 * C2)
    short2 = w2 <= free_limit2
    v2 = 1.0 / (1.0 if short2 else w2)
    v3 = C2 * v2
    s2 = v1 * v2
    q2 = _atan2(s2, -v3)

    # theta3, type 2: U3[2, 3]
    X3 = T23 * s2 - T13 * v3
    w3 = math.sqrt(X3 * X3 + T33 * T33)
    free3 = w3 <= free_limit
    divisor3 = 1.0 if free3 else w3

    # theta4, type 3: U3[3, 3] and U3[1, 3]
    v4 = T23 * v3 + T13 * s2
    v5 = v4 * v4

    # theta5, type 3: U3[2, 2] and U3[2, 1]
    v7 = T22 * s2 - T12 * v3
    v8 = T21 * s2 - T11 * v3

    # is the pose one that the arm can take?
    v13 = T34 - wz
    v15 = T14 - a1
    v16 = T24 * s2 - v3 * v15
    v17 = T11 * s2 + T21 * v3
    v18 = s2 * v15 + T24 * v3

    for i1 in range(2):  # noflip, flip
        e1 = 1.0 - 2.0 * i1
        # theta3
        if e1 < 0.0 and free3:
            continue  # both signs give the same
        factor3 = e1 / divisor3
        c3 = math.cos(seed[2]) if free3 else -(X3 * factor3)
        s3 = math.sin(seed[2]) if free3 else -(T33 * factor3)
        q3 = _atan2(s3, c3)
        root3 = w3 * e1

        # theta4
        w4 = math.sqrt(root3 * root3 + v5)
        short4 = w4 <= free_limit
        v6 = 1.0 / (1.0 if short4 else w4)
        c4 = v4 * v6
        s4 = root3 * v6
        q4 = _atan2(s4, c4)

        # theta5
        C5 = s3 * v7 - T32 * c3
        S5 = s3 * v8 - T31 * c3
        w5 = math.sqrt(S5 * S5 + C5 * C5)
        short5 = w5 <= free_limit
        v9 = 1.0 / (1.0 if short5 else w5)
        v10 = C5 * v9
        v11 = S5 * v9
        q5 = _atan2(-v11, -v10)

        # is the pose one that the arm can take?
        v12 = s3 * s4
        v14 = c3 * s4
        if (
            not (abs(v13 + d5 * v12) <= doubtful_slack1 and abs(T33 + v12) <= doubtful_slack and
            abs(T31 + (v10 * (s3 * c4) + c3 * v11)) <= doubtful_slack and abs(d3 + d5 * c4 - v18) <=
            doubtful_slack1 and abs(c4 - v4) <= doubtful_slack and abs(v17 + s4 * v10) <=
            doubtful_slack and abs(v16 + d5 * v14) <= doubtful_slack1 and abs(v8 - (s3 * v11 - v10 *
            (c3 * c4))) <= doubtful_slack and abs(X3 + v14) <= doubtful_slack)
        ):
            continue  # the arm can't take this pose
        row = i1
        q[row, 0] = wz
        q[row, 1] = q2
        q[row, 2] = q3
        q[row, 3] = q4
        q[row, 4] = q5
        status[row] = FREE_JOINT if free3 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px * px * px) and math.isfinite(py * py * py) and math.isfinite(pz * pz * pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([6.0, 1.0, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.1667, 0.1667, 0.1667, 1.0, 1.0, 1.0])


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
    J, rows, square = jacobian(q), np.zeros((6, 11)), np.zeros(6)
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
        if _REVOLUTE[i]:
            off -= turn * math.floor(off / turn + 0.5)
        most = max(most, abs(off) * math.sqrt(_WEIGHT[i]))
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
    -1.0, -3.141592653589793, -3.141592653589793, -3.141592653589793, -3.141592653589793,
])
_SPAN_WIDTH = np.array([
    2.0, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
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
        if _descend(T, joints, u) > 1e-05:
            continue
        _take(end, joints)
        for j in range(5):
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
def _seek(pose, seed, begun, q, status):
    """The same into a row, if there is none, or only such as fit a pose that has been rounded."""
    before, chosen = 4, -1
    T, exact = _upper_rows(pose), _exactness(pose)
    here, ahead = np.empty(5), np.empty(1)
    for row in range(2 - 1, -1, -1):
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
    least = _sought(pose, seed.copy(), before, found)
    if least == before:
        return
    for row in range(2):
        status[row] = FREE_JOINT if row == begun else UNREACHABLE
        for i in range(5):
            q[row, i] = found[i] if row == begun else math.nan


@_inner
def _stay(pose, seed, q, status):
    """Where rounding can't tell solutions apart the arm goes on with the one that it is at.

    The solution next to the seed gets a row unless it has one: that of one beside
    it, that of one which it is told from by nothing, one that is left, or any.
    """
    x, half, place, least = np.empty(5), np.empty(5), 0, math.inf
    nearest = 0.001
    for i in range(5):
        x[i] = seed[i]
    if not _settle(pose, 1e-12, 0.15, x):
        return
    for row in range(2 - 1, -1, -1):
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
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(2):
        status[row] = UNREACHABLE
        for i in range(5):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    begun = 0  # the first row that was not out of reach: here equations may have ended all
    for row in range(2 - 1, -1, -1):
        if status[row] != UNREACHABLE:
            begun = row
    _tighten(pose, q, status)
    _seek(pose, seed, begun, q, status)
    _stay(pose, seed, q, status)
    count = 0
    for row in range(2):
        if status[row] == UNREACHABLE:
            continue
        for i in range(5):
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
    room = carray(_room(16), 16)

    # r1, type 1: U0 A5^-1 [3, 4]
    q1_p = T34 - d5 * T33

    # theta2, type 3: U0 A5^-1 [1, 4] and U0 A5^-1 [2, 4]
    wy = T24 - d5 * T23
    v1 = T14 - d5 * T13 - a1
    s2 = d3 * v1
    C2 = d3 * wy
    v2 = s2 * s2 + C2 * C2
    v3 = math.sqrt(v2) * (1.0 / v2)

    # theta3, type 2: U3[2, 3]
    X3 = T23 * s2 - T13 * C2
    v4 = T33 * T33 + v3 * (X3 * (v3 * X3))
    w3 = math.sqrt(v4)
    v5 = 1.0 / v4
    factor3 = w3 * v5
    v6 = X3 * factor3
    v7 = T33 * factor3
    v8 = v3 * v6

    # theta4, type 3: U3[3, 3] and U3[1, 3]
    v9 = T23 * C2 + T13 * s2
    v10 = v4 + v3 * (v9 * (v3 * v9))
    v11 = math.sqrt(v10) * (1.0 / v10)
    c4 = v9 * v11
    s4 = w3 * v11

    # theta5, type 3: U3[2, 2] and U3[2, 1]
    C5 = w3 * (v5 * (X3 * T32 - T33 * (s2 * T22 - C2 * T12)))
    v12 = s2 * T21 - C2 * T11
    S5 = w3 * (v5 * (X3 * T31 - T33 * v12))
    v13 = v3 * (S5 * (v3 * S5) + C5 * (v3 * C5))
    v14 = math.sqrt(v13) * (1.0 / v13)
    v15 = C5 * v14
    v16 = S5 * v14

    # is the pose one that the arm can take?
    v17 = v7 * s4
    v18 = v6 * s4
    v19 = T14 - a1
    v20 = T34 - q1_p - d5 * v17
    v21 = T33 - v17
    v22 = v3 * v15
    v23 = T31 - v3 * (v22 * (v7 * c4) + v8 * v16)
    v24 = d3 + v3 * (d5 * c4) - v3 * (s2 * v19 + T24 * C2)
    v25 = v3 * (c4 - v9)
    v26 = v3 * (s2 * T11 + C2 * T21 + s4 * v15)
    v27 = v3 * (T24 * s2 - C2 * v19 - d5 * v18)
    v28 = v3 * (v12 - (v22 * (v8 * c4) - v7 * v16))
    v29 = v3 * (X3 - v18)

    # a joint is free, or branches meet
    if (
        v4 <= m2 or v2 <= m1 or v10 <= m2 or v13 <= m2 or m5 < v21 * v21 + v23 * v23 + v25 * v25 +
        v26 * v26 + v28 * v28 + v29 * v29 or m4 < v20 * v20 + v24 * v24 + v27 * v27
    ):
        return False

    # angles, side by side
    room[0] = v1
    room[1] = -v7
    room[2] = s4
    room[3] = -v16
    room[8] = -wy
    room[9] = -v8
    room[10] = v3 * c4
    room[11] = -v15
    for k in range(4, 8):
        room[k] = room[k + 8] = 1.0
    for k in range(8):
        room[k] = _atan2(room[k], room[k + 8])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]
    angle4 = room[3]

    # theta3, type 2: U3[2, 3]
    q3_m = angle2 - math.copysign(half_turn, -v7)

    # theta5, type 3: U3[2, 2] and U3[2, 1]
    q5_m = angle4 - math.copysign(half_turn, -v16)

    q[0, 0] = q1_p
    q[0, 1] = angle1
    q[0, 2] = angle2
    q[0, 3] = angle3
    q[0, 4] = angle4
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_p
    q[1, 1] = angle1
    q[1, 2] = q3_m
    q[1, 3] = -angle3
    q[1, 4] = q5_m
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    return True


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (2, 5) or status.shape != (2,):
        raise ValueError("T, q and status must have shapes (4, 4), (2, 5), (2,)")
    valid, pose = _read(T)
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    if _COMPILED and _regular(pose, q, status):
        count = 0
        for row in range(2):
            count += status[row] == OK
        return count
    return _whole(pose, seed, q, status)


# Where in a tile the rows' values and statuses begin.
_PLACES = np.array([
    [656, 672, 688, 704, 720],
    [656, 672, 736, 752, 768],
])
_KINDS = np.array([784, 800])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(816), 816)
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
            q1_p = T34 - d5 * T33
            wy = T24 - d5 * T23
            v1 = T14 - d5 * T13 - a1
            s2 = d3 * v1
            C2 = d3 * wy
            v2 = s2 * s2 + C2 * C2
            v3 = math.sqrt(v2) * (1.0 / v2)
            X3 = T23 * s2 - T13 * C2
            v4 = T33 * T33 + v3 * (X3 * (v3 * X3))
            w3 = math.sqrt(v4)
            v5 = 1.0 / v4
            factor3 = w3 * v5
            v6 = X3 * factor3
            v7 = T33 * factor3
            v8 = v3 * v6
            v9 = T23 * C2 + T13 * s2
            v10 = v4 + v3 * (v9 * (v3 * v9))
            v11 = math.sqrt(v10) * (1.0 / v10)
            c4 = v9 * v11
            s4 = w3 * v11
            C5 = w3 * (v5 * (X3 * T32 - T33 * (s2 * T22 - C2 * T12)))
            v12 = s2 * T21 - C2 * T11
            S5 = w3 * (v5 * (X3 * T31 - T33 * v12))
            v13 = v3 * (S5 * (v3 * S5) + C5 * (v3 * C5))
            v14 = math.sqrt(v13) * (1.0 / v13)
            v15 = C5 * v14
            v16 = S5 * v14
            v17 = v7 * s4
            v18 = v6 * s4
            v19 = T14 - a1
            v20 = T34 - q1_p - d5 * v17
            v21 = T33 - v17
            v22 = v3 * v15
            v23 = T31 - v3 * (v22 * (v7 * c4) + v8 * v16)
            v24 = d3 + v3 * (d5 * c4) - v3 * (s2 * v19 + T24 * C2)
            v25 = v3 * (c4 - v9)
            v26 = v3 * (s2 * T11 + C2 * T21 + s4 * v15)
            v27 = v3 * (T24 * s2 - C2 * v19 - d5 * v18)
            v28 = v3 * (v12 - (v22 * (v8 * c4) - v7 * v16))
            v29 = v3 * (X3 - v18)
            work[272 + k] = q1_p
            work[288 + k] = v2
            work[304 + k] = v4
            work[320 + k] = v7
            work[336 + k] = v10
            work[352 + k] = v13
            work[368 + k] = v16
            work[384 + k] = v20
            work[400 + k] = v21
            work[416 + k] = v23
            work[432 + k] = v24
            work[448 + k] = v25
            work[464 + k] = v26
            work[480 + k] = v27
            work[496 + k] = v28
            work[512 + k] = v29
            work[528 + k] = v1
            work[544 + k] = -v7
            work[560 + k] = s4
            work[576 + k] = -v16
            work[592 + k] = -wy
            work[608 + k] = -v8
            work[624 + k] = v3 * c4
            work[640 + k] = -v15
        for k in range(528, 592):
            work[k] = _atan2(work[k], work[k + 64])
        for k in range(0, 16):
            q1_p = work[272 + k]
            v2 = work[288 + k]
            v4 = work[304 + k]
            v7 = work[320 + k]
            v10 = work[336 + k]
            v13 = work[352 + k]
            v16 = work[368 + k]
            v20 = work[384 + k]
            v21 = work[400 + k]
            v23 = work[416 + k]
            v24 = work[432 + k]
            v25 = work[448 + k]
            v26 = work[464 + k]
            v27 = work[480 + k]
            v28 = work[496 + k]
            v29 = work[512 + k]
            angle1 = work[528 + k]
            angle2 = work[544 + k]
            angle3 = work[560 + k]
            angle4 = work[576 + k]
            q3_m = angle2 - math.copysign(half_turn, -v7)
            q5_m = angle4 - math.copysign(half_turn, -v16)
            _656 = q1_p
            work[656 + k] = _656
            _672 = angle1
            work[672 + k] = _672
            _688 = angle2
            work[688 + k] = _688
            _704 = angle3
            work[704 + k] = _704
            _720 = angle4
            work[720 + k] = _720
            _736 = q3_m
            work[736 + k] = _736
            _752 = -angle3
            work[752 + k] = _752
            _768 = q5_m
            work[768 + k] = _768
            work[784 + k] = UNREACHABLE if _656 != _656 else OK
            work[800 + k] = UNREACHABLE if _656 != _656 else OK
            work[256 + k] = (
                1.0 if v4 <= m2 or v2 <= m1 or v10 <= m2 or v13 <= m2 or m5 < v21 * v21 + v23 * v23
                + v25 * v25 + v26 * v26 + v28 * v28 + v29 * v29 or m4 < v20 * v20 + v24 * v24 + v27
                * v27 else work[256 + k]
            )
        for k in range(first, first + count):
            if work[256 + k - first] != 0.0:
                _unseeded(T[k], q[k], status[k])
                continue
            for row in range(2):
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
        given=0,
        apart=(_HOW.compile_apart,),
        words={
            "no_pose": "not finite or beyond 5e102, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)",
            "no_row": "the pose is out of reach, or one that 5 joints can't take",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
