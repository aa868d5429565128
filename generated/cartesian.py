"""cartesian: Cartesian arm.

Inverse kinematics, generated from robots/cartesian.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/cartesian.yaml. The formulas and where they come from: cartesian.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
position T[0:3, 3] counts; other entries are ignored.
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

NAME = "cartesian"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "PPP"
JOINT_LIMITS = (
    (0.0, 0.8),
    (0.0, 0.6),
    (0.0, 1.2),
)
BRANCHES = (
    "only",
)
MAX_SOLUTIONS = 1

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

low1 = -1.2e-09
high1 = 0.8000000012
per_size = 0.8333333333333334
low2 = -1.2e-09
high2 = 0.6000000012
low3 = -1.2e-09
high3 = 1.2000000012

# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1.2e-09, 1.2e-09, 1.2e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([0.6944444444444444, 0.6944444444444444, 0.6944444444444444])
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
    """Compiled; Python calls it with any 3 numbers, other numba functions with an array."""

    @functools.wraps(function)
    def call(q):
        return compiled(_array(q, (3,), "q"))

    def inner(q):
        return compiled(q)

    # Of functions of one name in one module numba takes one for the other when both are cached.
    inner.__qualname__ = f"{function.__name__} of an array"
    compiled = _jit(function)
    overload(call, strict=False)(lambda _: _owned(inner))
    return call


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 3 joint values")
    T = np.zeros((4, 4))
    T[0, 2] = 1.0
    T[0, 3] = q[2]
    T[1, 1] = -1.0
    T[1, 3] = q[1]
    T[2, 0] = 1.0
    T[2, 3] = q[0]
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 3 joint values")
    J = np.zeros((6, 3))
    J[0, 2] = 1.0
    J[1, 1] = 1.0
    J[2, 0] = 1.0
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    row = 0
    q[row, 0] = T34
    q[row, 1] = T24
    q[row, 2] = T14
    status[row] = OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows.

    Only the entries that count are looked at.
    """
    x0, x1, x2, px = T[0, 0], T[0, 1], T[0, 2], T[0, 3]
    y0, y1, y2, py = T[1, 0], T[1, 1], T[1, 2], T[1, 3]
    z0, z1, z2, pz = T[2, 0], T[2, 1], T[2, 2], T[2, 3]
    valid = math.isfinite(px * px * px) and math.isfinite(py * py * py) and math.isfinite(pz * pz * pz)
    return valid, (x0, x1, x2, px, y0, y1, y2, py, z0, z1, z2, pz)


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(1):
        status[row] = UNREACHABLE
        for i in range(3):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    count = 0
    for row in range(1):
        if status[row] == UNREACHABLE:
            continue
        for i in range(3):
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
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    # joint values
    outside = (
        0.0 < max(per_size * max(low3 - T14, T14 - high3), max(per_size * max(low1 - T34, T34 -
        high1), per_size * max(low2 - T24, T24 - high2)))
    )

    q[0, 0] = T34
    q[0, 1] = T24
    q[0, 2] = T14
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else (OUT_OF_LIMITS if outside else OK)
    return True


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (1, 3) or status.shape != (1,):
        raise ValueError("T, q and status must have shapes (4, 4), (1, 3), (1,)")
    valid, pose = _read(T)
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    if _COMPILED and _regular(pose, q, status):
        count = 0
        for row in range(1):
            count += status[row] == OK
        return count
    return _whole(pose, seed, q, status)


@_merged
def _zeros(seed):
    """The seed where there is none; of the type that callers' arrays have."""
    for i in range(3):
        seed[i] = 0.0
    return seed


@_jit
def _unseeded(T, q, status):
    seed = _zeros(carray(_room(3), 3))
    return _into(_lent_rows(T), seed, _lent_rows(q), _lent_statuses(status))


@_jit
def _seeded(T, q, status, seed):
    if seed.shape != (3,):
        raise ValueError("q_seed must have shape (3,)")
    for value in seed:
        if not math.isfinite(value):
            raise ValueError("q_seed must be finite")
    return _into(_lent_rows(T), _lent_values(seed), _lent_rows(q), _lent_statuses(status))


def ik_into(T, q, status, q_seed=None):
    """All solutions into the caller's arrays, for control loops and for other numba functions.

    Memory is allocated nowhere. numba compiles
    once more for arrays of another layout.

    Args:
        T: Pose (4, 4), float64.
        q: Filled with joint values (1, 3), NaN where there is no solution; float64.
        status: Filled with what each row holds (1,); uint8.
        q_seed: Values for joints that are indeterminate (3,), float64; zeros without it.

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
    _demand_array("q", q, (1, 3), _FLOAT)
    _demand_array("status", status, (1,), _BYTE)
    if q_seed is not None:
        _demand_array("q_seed", q_seed, (3,), _FLOAT)
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
    """All solutions: q (1, 3) and status (1,).

    Row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (3,); zeros without it.

    Raises:
        ValueError: An argument has the wrong shape, or the seed is not finite.
    """
    q, status = _empty((1, 3)), _empty(1, _BYTE)
    given = T
    try:
        T = _contiguous(T)
        if T.dtype is not _FLOAT:
            T = _numbers(T, (4, 4), "T")
        if q_seed is None:
            _unseeded(T, q, status)
        else:
            seed = _array(q_seed, (3,), "q_seed")
            _seeded(T, q, status, seed)
    except Exception:
        # Shapes are looked at in there: only who fails is asked again, and told which one it is.
        _array(given, (4, 4), "T")
        raise
    return q, status


@_jit
def _nearest(rows, status, seed, limits, q):
    """The solution nearest to the seed into q; whether there is one."""
    nearest, least = -1, math.inf
    for row in range(len(rows)):
        if status[row] == UNREACHABLE or (limits and status[row] == OUT_OF_LIMITS):
            continue
        distance = 0.0
        for i in range(3):
            moved = rows[row, i] - seed[i]
            distance += _WEIGHT[i] * moved * moved
        if nearest < 0 or distance < least:
            nearest, least = row, distance
    for i in range(3):
        q[i] = rows[nearest, i]
    return nearest >= 0


def ik(T, q_seed=None, *, branch=None, limits=True):
    """One solution (3,): the nearest to the seed.

    Angles are moved by whole turns into their limits.

    Args:
        T: Pose (4, 4).
        q_seed: Where the arm is (3,); zeros without it.
        branch: Only this branch: a name from BRANCHES, or its row.
        limits: Whether joint limits count: True or False.

    Raises:
        Unreachable: There is no such solution; the message says why.
        ValueError: T is not a valid pose, branch does not exist, or limits is not True or False.
    """
    if not isinstance(limits, (bool, np.bool_)):
        raise ValueError(f"limits must be True or False, not {limits!r}")
    first, last = (0, 1) if branch is None else _span(branch)
    rows, status = ik_all(T, q_seed)
    if status[0] == INVALID_POSE:
        raise ValueError("T is not a valid pose: not finite or beyond 5e102")
    rows, status, q = rows[first:last], status[first:last], np.empty(3)
    seed = _ZEROS if q_seed is None else _array(q_seed, (3,), "q_seed")
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


# Where in a tile the rows' values and statuses begin.
_PLACES = np.array([
    [272, 288, 304],
])
_KINDS = np.array([320])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(336), 336)
    work[:] = 0.0  # the last tile may be half full
    for first in range(0, len(T), 16):
        count = min(16, len(T) - first)
        for k in range(count):
            for i in range(4):
                for j in range(4):
                    work[(4 * i + j) * 16 + k] = T[first + k, i, j]
        for k in range(16):
            miss = (
                0.0 * (work[48 + k] * work[48 + k] * work[48 + k] + work[112 + k] * work[112 + k] *
                work[112 + k] + work[176 + k] * work[176 + k] * work[176 + k])
            )
            exact = miss <= 1e-24
            work[256 + k] = 0.0 if exact else 1.0
        for k in range(0, 16):
            T14 = work[48 + k]
            T24 = work[112 + k]
            T34 = work[176 + k]
            outside = (
                0.0 < max(per_size * max(low3 - T14, T14 - high3), max(per_size * max(low1 - T34,
                T34 - high1), per_size * max(low2 - T24, T24 - high2)))
            )
            _272 = T34
            work[272 + k] = _272
            _288 = T24
            work[288 + k] = _288
            _304 = T14
            work[304 + k] = _304
            work[320 + k] = UNREACHABLE if _272 != _272 else (OUT_OF_LIMITS if outside else OK)
        for k in range(first, first + count):
            if work[256 + k - first] != 0.0:
                _unseeded(T[k], q[k], status[k])
                continue
            for row in range(1):
                status[k, row] = np.uint8(work[_KINDS[row] + k - first])
                for i in range(3):
                    q[k, row, i] = work[_PLACES[row, i] + k - first]


def ik_batch(T, *, cores=None, out=None):
    """ik_all for N poses (N, 4, 4), shared among `cores` cores, by default all of them.

    Args:
        T: Poses (N, 4, 4).
        cores: How many threads share the poses.
        out: The arrays q and status to write to, from an earlier call or like those: fresh
            memory can cost more time than the solutions.

    Returns:
        q (N, 1, 3) and status (N, 1).

    Raises:
        ValueError: An argument has the wrong shape, or cores is not a whole number from 1.
    """
    given, T = T, _numbers(T, "(N, 4, 4)", "T")
    if T.ndim != 3 or T.shape[1:] != (4, 4):
        raise ValueError(f"T must have shape (N, 4, 4), not {np.shape(given)}")
    if cores is not None and not (_is_number(cores) and cores >= 1):
        raise ValueError(f"cores must be at least 1, or None for all of them, not {cores!r}")
    q, status = _results(out, len(T))
    _share(_in_tiles if _COMPILED else _one_by_one, cores, T, q, status)
    return q, status


def warm_up():
    """Compiles everything, or gets it from numba's cache, so that no call waits for it later."""
    q, status = np.empty((1, 3)), np.empty(1, _BYTE)
    T = fk(_ZEROS)
    jacobian(_ZEROS)
    ik_into(T, q, status)
    ik_into(T, q, status, _ZEROS)
    _nearest(q, status, _ZEROS, True, np.empty(3))
    ik_batch(T[np.newaxis])


def _results(out, count):
    """The rows and the statuses of so many poses: the caller's arrays, or new ones."""
    rows, row = (count, 1, 3), (count, 1)
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
