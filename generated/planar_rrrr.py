"""planar_rrrr: Planar arm with four links, one joint too many twice over.

Inverse kinematics, generated from robots/planar_rrrr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/planar_rrrr.yaml. The formulas and where they come from:
planar_rrrr.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, x =
T[0, 3] and y = T[1, 3] counts; other entries are ignored.
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
_read_rows = _runtime("pose").read_position
_of_joints = _runtime("entry").of_joints(_HOW, 4)

NAME = "planar_rrrr"
METHOD = "numerical"
DOF = 4
JOINT_TYPES = "RRRR"
JOINT_LIMITS = (
    (-2.0943951023931953, 2.0943951023931953),
    (-2.0943951023931953, 2.0943951023931953),
    (-2.0943951023931953, 2.0943951023931953),
    (-2.0943951023931953, 2.0943951023931953),
)
BRANCHES = (
    "nearest",
)
MAX_SOLUTIONS = 1

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

a = 0.25  # link length 1 [m]

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0])
_JOINTS = np.column_stack([_LOWEST, _HIGHEST, [kind == "R" for kind in JOINT_TYPES], _WEIGHT])


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (4,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 4 joint values")
    T = np.zeros((4, 4))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * c2 - s1 * s2
    x2_y = s1 * c2 + c1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - x2_y * s3
    x3_y = x2_y * c3 + x2_x * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - x3_y * s4
    x4_y = x3_y * c4 + x3_x * s4
    T[0, 0] = x4_x
    T[0, 1] = -x4_y
    T[0, 3] = c1 * a + a * x2_x + a * x3_x + a * x4_x
    T[1, 0] = x4_y
    T[1, 1] = x4_x
    T[1, 3] = s1 * a + a * x2_y + a * x3_y + a * x4_y
    T[2, 2] = 1.0
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 4): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 4 joint values")
    J = np.zeros((6, 4))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    p1_x = c1 * a
    p1_y = s1 * a
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * c2 - s1 * s2
    x2_y = s1 * c2 + c1 * s2
    p2_x = p1_x + a * x2_x
    p2_y = p1_y + a * x2_y
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - x2_y * s3
    x3_y = x2_y * c3 + x2_x * s3
    p3_x = p2_x + a * x3_x
    p3_y = p2_y + a * x3_y
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    p4_x = p3_x + a * (x3_x * c4 - x3_y * s4)
    p4_y = p3_y + a * (x3_y * c4 + x3_x * s4)
    J[0, 0] = -p4_y
    J[0, 1] = p1_y - p4_y
    J[0, 2] = p2_y - p4_y
    J[0, 3] = p3_y - p4_y
    J[1, 0] = p4_x
    J[1, 1] = p4_x - p1_x
    J[1, 2] = p4_x - p2_x
    J[1, 3] = p4_x - p3_x
    J[5, 0] = 1.0
    J[5, 1] = 1.0
    J[5, 2] = 1.0
    J[5, 3] = 1.0
    return J


_arms = import_module(f"{_FOLDER}.dhgen_runtime.numerical.arm")
# The joints, what the task names, and the forward model with all links.
_WHOLE = _arms.Arm(
    rows=1,
    size=1.0,
    coordinates=(0, 1),
    directions='none',
    joints=(
        _arms.Joint(place=0, lowest=-2.0943951023931953, highest=2.0943951023931953),
        _arms.Joint(place=1, lowest=-2.0943951023931953, highest=2.0943951023931953),
        _arms.Joint(place=2, lowest=-2.0943951023931953, highest=2.0943951023931953),
        _arms.Joint(place=3, lowest=-2.0943951023931953, highest=2.0943951023931953),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _arms.ChainJoint((1.0, 0.0, 0.0, 0.25, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
        _arms.ChainJoint((1.0, 0.0, 0.0, 0.25, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
        _arms.ChainJoint((1.0, 0.0, 0.0, 0.25, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
        _arms.ChainJoint((1.0, 0.0, 0.0, 0.25, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
    ),
    redundant=True,
)
_solver = import_module(f"{_FOLDER}.dhgen_runtime.numerical.search")
_compiled = import_module(f"{_FOLDER}.dhgen_runtime.numerical.compiled")
_ARM = _arms.arm_numbers(_WHOLE)
_NO_FREE = np.zeros(0)
_solved_whole = _solver.all_joints


@_inner
def _all_joints(pose, seed):
    """All solutions, which rows hold one, and where a joint was indeterminate."""
    return _solved_whole(_ARM, pose, _NO_FREE, seed)


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    # all joints: damped least squares
    solution_roots, solution_found, solution_chosen = _all_joints(pose, seed)

    for i1 in range(1):  # nearest
        q1 = solution_roots[i1, 0]
        q2 = solution_roots[i1, 1]
        q3 = solution_roots[i1, 2]
        q4 = solution_roots[i1, 3]
        found = solution_found[i1]
        chosen = solution_chosen[i1]
        # all joints: damped least squares
        if not found:
            continue  # out of reach
        row = i1
        q[row, 0] = q1
        q[row, 1] = q2
        q[row, 2] = q3
        q[row, 3] = q4
        status[row] = FREE_JOINT if chosen else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px) and math.isfinite(py), pose


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
    for i in range(4):
        total += abs(_overshoot(i, values[i]))
    return total


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([1.0, 1.0, 0.0, 0.0, 0.0, 0.0])


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
    return e, math.sqrt(square)


@_inner
def _add_step(held, damping, e, q):
    """Adds the damped least squares step that the miss e asks for to joint values.

    The rows of the Jacobian, each with its share of the damping's root, are made orthogonal one
    after another (modified Gram-Schmidt), twice: once would not do beside singular places.
    """
    J, rows, square = jacobian(q), np.zeros((6, 10)), np.zeros(6)
    for i in range(6):
        for j in range(4):
            rows[i, j] = 0.0 if held[j] else _PACE[j] * _MISS_WEIGHT[i] * J[i, j]
        rows[i, 4 + i] = math.sqrt(damping + 1e-26)
        for n in range(2 * i):
            k, along = n % i, 0.0
            for j in range(10):
                along += rows[k, j] * rows[i, j] / square[k]
            for j in range(10):
                rows[i, j] -= along * rows[k, j]
            e[i] -= along * e[k]
        for j in range(10):
            square[i] += rows[i, j] * rows[i, j]
        for j in range(4):
            q[j] += e[i] / square[i] * rows[i, j] * _PACE[j]


@_inner
def _half_way(x, q, half):
    """How far joint values are from others, but for whole turns [rad, arm sizes].

    Those half way go into half.
    """
    most = 0.0
    for i in range(4):
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
    half = np.empty(4)
    stands, moves = math.isnan(enough), 0
    held, x, settled = np.zeros(4, np.bool_), q.copy(), False
    last, lost = math.inf, 0
    for _ in range(20):
        e, miss = _miss(T, x)
        if math.isnan(enough):
            enough = miss + 1e-14
        worst, past = -1, 0.0
        for j in range(4 if stands and miss < enough else 0):
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
            for i in range(4):
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
    values = np.empty(4)
    for i in range(4):
        values[i] = q[i]
    settled = _settled(pose, enough, most, values)
    for i in range(4):
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
    x, half, to = q.copy(), np.empty(4), np.empty(4)
    if not _settle(pose, math.nan, math.inf if far else 1.5, x):
        return False
    off = _half_way(q, x, half)
    for k in range(len(rows)):
        if status[k] != UNREACHABLE and _beyond_limits(rows[k]) < beyond:
            if _half_way(rows[k], x, to) < off:
                return False
    if off >= 0.001 and not _settle(pose, 1e-12, 0.25 * off, half):
        return False
    for i in range(4):
        q[i] = x[i]
    return True


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(1):
        status[row] = UNREACHABLE
        for i in range(4):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    count = 0
    for row in range(1):
        if status[row] == UNREACHABLE:
            continue
        _stand(pose, row, False, q, status)
        for i in range(4):
            q[row, i] = _turned(_JOINTS, i, q[row, i], 0.0)
            if not _LOWEST[i] <= q[row, i] <= _HIGHEST[i]:
                status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (1, 4) or status.shape != (1,):
        raise ValueError("T, q and status must have shapes (4, 4), (1, 4), (1,)")
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
        apart=(_HOW.compile_apart, _compiled.compile_apart),
        words={
            "no_pose": "not finite",
            "no_row": "the pose is out of reach",
            "allocates": "at every pose",
        },
    ),
)
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
