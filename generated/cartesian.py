"""cartesian: Cartesian arm.

Inverse kinematics, generated from robots/cartesian.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/cartesian.yaml. The formulas and where they come from: cartesian.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
position T[0:3, 3] counts; other entries are ignored.
"""

import math
import os
from concurrent.futures import ThreadPoolExecutor

import numpy as np

try:
    from numba import njit
except ImportError:  # plain Python, only slower

    def njit(*_, **__):
        return lambda function: function


_jit = njit(cache=True, error_model="numpy")

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
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose


# The limits with what rounding may add.
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - 1e-09
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + 1e-09
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0])
_ZEROS = np.zeros(DOF)
_FLOAT = np.dtype(np.float64)
_BYTE = np.dtype(np.uint8)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the text says which."""


@_jit
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


@_jit
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 3 joint values")
    J = np.zeros((6, 3))
    J[0, 2] = 1.0
    J[1, 1] = 1.0
    J[2, 0] = 1.0
    return J


@_jit
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    row = 0
    q[row, 0] = T34
    q[row, 1] = T24
    q[row, 2] = T14
    status[row] = OK


@_jit
def _read(T):
    """Whether T is a pose, and its upper three rows.

    Only the entries that count are looked at.
    """
    x0, x1, x2, px = T[0, 0], T[0, 1], T[0, 2], T[0, 3]
    y0, y1, y2, py = T[1, 0], T[1, 1], T[1, 2], T[1, 3]
    z0, z1, z2, pz = T[2, 0], T[2, 1], T[2, 2], T[2, 3]
    valid = math.isfinite(px) and math.isfinite(py) and math.isfinite(pz)
    return valid, (x0, x1, x2, px, y0, y1, y2, py, z0, z1, z2, pz)


@_jit
def _ik(T, seed, q, status):
    """All rows into q and status; how many are OK or FREE_JOINT."""
    valid, pose = _read(T)
    for row in range(1):
        status[row] = UNREACHABLE if valid else INVALID_POSE
        for i in range(3):
            q[row, i] = math.nan
    if not valid:
        return 0
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


@_jit
def ik_into(T, q, status, q_seed=None):
    """All solutions into the caller's arrays, for control loops and for other numba functions.

    Memory is allocated nowhere. numba compiles
    once more for arrays of another type or layout.

    Args:
        T: Pose (4, 4), float64.
        q: Filled with joint values (1, 3), NaN where there is no solution; float64.
        status: Filled with what each row holds (1,); uint8.
        q_seed: Values for joints that are indeterminate (3,), float64; zeros without it.

    Returns:
        How many rows are OK or FREE_JOINT.

    Raises:
        ValueError: An array has another shape, or the seed is not finite.
    """
    if T.shape != (4, 4) or q.shape != (1, 3) or status.shape != (1,):
        raise ValueError("T, q and status must be (4, 4), (1, 3) and (1,)")
    if q_seed is None:
        return _ik(T, _ZEROS, q, status)
    if q_seed.shape != (3,):
        raise ValueError("q_seed must be (3,)")
    if not np.isfinite(q_seed).all():
        raise ValueError("q_seed must be finite")
    return _ik(T, q_seed, q, status)


def ik_all(T, q_seed=None):
    """All solutions: q (1, 3) and status (1,).

    Row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (3,); zeros without it.

    Raises:
        ValueError: An argument has another shape, or the seed is not finite.
    """
    q, status = np.empty((1, 3)), np.empty(1, _BYTE)
    T = _array(T, (4, 4), "T")
    if q_seed is None:
        ik_into(T, q, status)
    else:
        ik_into(T, q, status, _array(q_seed, (3,), "q_seed"))
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
        if distance < least:
            nearest, least = row, distance
    for i in range(3):
        q[i] = rows[nearest, i]
    return nearest >= 0


def ik(T, q_seed=None, *, branch=None, limits=True):
    """One solution (3,): the nearest to the seed.

    Angles are moved by whole turns inside their limits.

    Args:
        T: Pose (4, 4).
        q_seed: Where the arm is (3,); zeros without it.
        branch: Only this branch: a name out of BRANCHES, or its row.
        limits: Whether joint limits count.

    Raises:
        Unreachable: There is no such solution; the text says why.
        ValueError: T is no pose, or there is no such branch.
    """
    first, last = (0, 1) if branch is None else _span(branch)
    rows, status = ik_all(T, q_seed)
    if status[0] == INVALID_POSE:
        raise ValueError("T is no pose: not finite")
    rows, status, q = rows[first:last], status[first:last], np.empty(3)
    seed = _ZEROS if q_seed is None else _array(q_seed, (3,), "q_seed")
    if _nearest(rows, status, seed, limits, q):
        return q
    where = "" if branch is None else f" in branch {BRANCHES[first]}"
    beyond = OUT_OF_LIMITS in status
    why = "every solution is beyond the joint limits" if beyond else "the pose is out of reach"
    raise Unreachable(why + where)


@njit(cache=True, error_model="numpy", nogil=True)
def _ik_batch(T, q, status):
    for k in range(len(T)):
        _ik(T[k], _ZEROS, q[k], status[k])


def ik_batch(T, *, cores=None):
    """ik_all for N poses (N, 4, 4), shared among so many cores; all of them without a number.

    Returns:
        q (N, 1, 3) and status (N, 1).
    """
    T = _array(T, (len(T), 4, 4), "T")
    q, status = np.empty((len(T), 1, 3)), np.empty((len(T), 1), _BYTE)
    shares = min(cores or os.cpu_count() or 1, len(T) // 2048)
    if shares > 1:
        parts = (np.array_split(each, shares) for each in (T, q, status))
        with ThreadPoolExecutor(shares) as threads:
            list(threads.map(_ik_batch, *parts))
    else:
        _ik_batch(T, q, status)
    return q, status


def _array(values, shape, name):
    values = np.ascontiguousarray(values, _FLOAT)
    if values.shape != shape:
        raise ValueError(f"{name} must have shape {shape}, not {values.shape}")
    return values


def _span(branch):
    """The rows of a branch: the first, and the one after the last."""
    if branch in BRANCHES:
        branch = BRANCHES.index(branch)
    if isinstance(branch, int) and 0 <= branch < MAX_SOLUTIONS:
        return branch, branch + 1
    raise ValueError(f"no branch {branch!r}; there are {', '.join(BRANCHES)}")
