"""cartesian: Cartesian arm.

Inverse kinematics, generated from robots/cartesian.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/cartesian.yaml. The formulas and where they come from: cartesian.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
position T[0:3, 3] counts; other entries are ignored.
"""

import math

import numpy as np

try:
    from numba import njit, prange
except ImportError:  # plain Python, only slower
    prange = range

    def njit(*_, **__):
        return lambda function: function


NAME = "cartesian"
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


_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0])
_ZEROS = np.zeros(DOF)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the text says which."""


@njit(cache=True, error_model="numpy")
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


@njit(cache=True, error_model="numpy")
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 3 joint values")
    J = np.zeros((6, 3))
    J[0, 2] = 1.0
    J[1, 1] = 1.0
    J[2, 0] = 1.0
    return J


@njit(cache=True, error_model="numpy")
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    row = 0
    q[row, 0] = T34
    q[row, 1] = T24
    q[row, 2] = T14
    status[row] = OK


@njit(cache=True, error_model="numpy")
def _is_pose(T):
    """Whether the entries that count make a pose."""
    return math.isfinite(T[0, 3]) and math.isfinite(T[1, 3]) and math.isfinite(T[2, 3])


@njit(cache=True, error_model="numpy")
def _read(T):
    """The upper three rows, with the nearest rotation where a pose is only rounded."""
    pose = (
        T[0, 0], T[0, 1], T[0, 2], T[0, 3],
        T[1, 0], T[1, 1], T[1, 2], T[1, 3],
        T[2, 0], T[2, 1], T[2, 2], T[2, 3],
    )
    return pose


@njit(cache=True, error_model="numpy")
def _ik(T, seed, q, status):
    """All rows into q and status; how many are OK or FREE_JOINT."""
    valid = _is_pose(T)
    for row in range(1):
        status[row] = UNREACHABLE if valid else INVALID_POSE
        for i in range(3):
            q[row, i] = math.nan
    if not valid:
        return 0
    pose = _read(T)
    _solve(pose, seed, q, status)
    count = 0
    for row in range(1):
        if status[row] == UNREACHABLE:
            continue
        for i in range(3):
            low, high = _LOWEST[i] - 1e-09, _HIGHEST[i] + 1e-09
            if not low <= q[row, i] <= high:
                status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


@njit(cache=True, error_model="numpy", parallel=True)
def _ik_batch(T, q, status):
    for k in prange(len(T)):
        _ik(T[k], _ZEROS, q[k], status[k])


def ik_into(T, q, status, q_seed=_ZEROS):
    """All solutions into the caller's arrays, for control loops.

    Besides the pose only shapes are checked. No memory is allocated.

    Args:
        T: Pose (4, 4), float64.
        q: Filled with joint values (1, 3), NaN where there is no solution; float64.
        status: Filled with what each row holds (1,); uint8.
        q_seed: Values for joints that are indeterminate (3,), float64.

    Returns:
        How many rows are OK or FREE_JOINT.
    """
    if q.shape != (MAX_SOLUTIONS, DOF) or status.shape != (MAX_SOLUTIONS,) or T.shape != (4, 4):
        raise ValueError("T, q and status must be (4, 4), (1, 3) and (1,)")
    return _ik(T, q_seed, q, status)


def ik_all(T, q_seed=None):
    """All solutions: q (1, 3) and status (1,).

    Row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (3,); zeros without it.
    """
    q = np.empty((1, 3))
    status = np.empty(1, np.uint8)
    seed = _ZEROS if q_seed is None else _vector(q_seed, DOF, "q_seed")
    _ik(_array(T, (4, 4), "T"), seed, q, status)
    return q, status


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
    seed = _ZEROS if q_seed is None else _vector(q_seed, DOF, "q_seed")
    rows = range(1) if branch is None else [_row(branch)]
    q, status = ik_all(T, seed)
    if status[0] == INVALID_POSE:
        raise ValueError("T is no pose: not finite")
    best, least = None, math.inf
    for row in rows:
        if status[row] == UNREACHABLE or (limits and status[row] == OUT_OF_LIMITS):
            continue
        values = q[row].copy()
        distance = float(_WEIGHT @ (values - seed) ** 2)
        if distance < least:
            best, least = values, distance
    if best is None:
        where = "" if branch is None else f" in branch {BRANCHES[rows[0]]}"
        beyond = any(status[row] == OUT_OF_LIMITS for row in rows)
        why = "every solution is beyond the joint limits" if beyond else "the pose is out of reach"
        raise Unreachable(why + where)
    return best


def ik_batch(T):
    """ik_all for N poses (N, 4, 4) on all cores.

    Returns:
        q (N, 1, 3) and status (N, 1).
    """
    T = _array(T, (len(T), 4, 4), "T")
    q = np.empty((len(T), 1, 3))
    status = np.empty((len(T), 1), np.uint8)
    _ik_batch(T, q, status)
    return q, status


def _array(values, shape, name):
    values = np.ascontiguousarray(values, np.float64)
    if values.shape != shape:
        raise ValueError(f"{name} must have shape {shape}, not {values.shape}")
    return values


def _vector(values, size, name):
    values = _array(values, (size,), name)
    if not np.isfinite(values).all():
        raise ValueError(f"{name} must be finite, not {values}")
    return values


def _row(branch):
    if branch in BRANCHES:
        return BRANCHES.index(branch)
    if isinstance(branch, int) and 0 <= branch < MAX_SOLUTIONS:
        return branch
    raise ValueError(f"no branch {branch!r}; there are {', '.join(BRANCHES)}")
