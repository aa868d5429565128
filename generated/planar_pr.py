"""planar_pr: Inclined slider with a revolute link.

Inverse kinematics, generated from robots/planar_pr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/planar_pr.yaml. The formulas and where they come from: planar_pr.md.

Poses are 4 x 4 matrices of the tool in the base frame, in m; angles are in rad. Of a pose,
the coordinates x, y of the position is meant; other entries are ignored.
"""

import math

import numpy as np

try:
    from numba import njit, prange
except ImportError:  # plain Python, only slower
    prange = range

    def njit(*_, **__):
        return lambda function: function


NAME = "planar_pr"
DOF = 2
JOINT_TYPES = "PR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "forward",
    "backward",
)
MAX_SOLUTIONS = 2

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose

k3 = 3.3333333333333335  # 1 / a
k4 = 1.6666666666666667  # (1 / 2) * (1 / a)
k5 = 2.8867513459481287  # (sqrt3 * (1 / 2)) * (1 / a)
k8 = 11.11111111111111  # (((1 / 2) * (1 / a)) * ((1 / 2) * (1 / a))) + (((sqrt3 * (1 / 2)) * (1 / a)) * ((sqrt3 * (1 / 2)) * (1 / a)))
k10 = 2.2222222222222224e-12  # (2 * ((((1 / 2) * (1 / a)) * ((1 / 2) * (1 / a))) + (((sqrt3 * (1 / 2)) * (1 / a)) * ((sqrt3 * (1 / 2)) * (1 / a))))) * reach_tolerance
k11 = 2.2222222222222222e-13  # (2 * ((((1 / 2) * (1 / a)) * ((1 / 2) * (1 / a))) + (((sqrt3 * (1 / 2)) * (1 / a)) * ((sqrt3 * (1 / 2)) * (1 / a))))) * merge_tolerance
k12 = 0.09  # 1 / ((((1 / 2) * (1 / a)) * ((1 / 2) * (1 / a))) + (((sqrt3 * (1 / 2)) * (1 / a)) * ((sqrt3 * (1 / 2)) * (1 / a))))
f1 = 0.5  # 1 / 2
f2 = 0.8660254037844386  # (1 / 2) * sqrt3
f6 = 0.9999999999999999  # ((1 / 2) * (1 / 2)) + (((1 / 2) * sqrt3) * ((1 / 2) * sqrt3))
a = 0.3  # x of the home pose
g1 = 0.5  # 1 / 2
g2 = 0.8660254037844386  # (1 / 2) * sqrt3
g6 = 0.9999999999999999  # ((1 / 2) * (1 / 2)) + (((1 / 2) * sqrt3) * ((1 / 2) * sqrt3))

_TURN = 6.283185307179586
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
_WEIGHT = np.array([11.11111111111111, 1.0])  # of squared differences: lengths by arm size
_ZEROS = np.zeros(DOF)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the text says which."""


@njit(cache=True, error_model="numpy")
def fk(q):
    """The pose (4, 4) of the joint values q (2,)."""
    T = np.zeros((4, 4))
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    T11 = f6 * c2
    T21 = f6 * s2
    T14 = f2 * q[0] + T11 * a
    T24 = f1 * q[0] + T21 * a
    T[0, 0] = T11
    T[0, 1] = -T21
    T[0, 3] = T14
    T[1, 0] = T21
    T[1, 1] = T11
    T[1, 3] = T24
    T[2, 2] = 1.0
    T[3, 3] = 1.0
    return T


@njit(cache=True, error_model="numpy")
def jacobian(q):
    """The geometric Jacobian (6, 2): velocity of the tool's origin, then angular velocity."""
    J = np.zeros((6, 2))
    v5 = g2 * q[0]
    v6 = g1 * q[0]
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    J22 = v5 + g6 * c2 * a - v5
    J12 = v6 - (v6 + g6 * s2 * a)
    J[0, 0] = g2
    J[0, 1] = J12
    J[1, 0] = g1
    J[1, 1] = J22
    J[5, 1] = 1.0
    return J


@njit(cache=True, error_model="numpy")
def _solve(T, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others.
    """

    # theta2, r1: type 5
    v8 = T[1, 3] * k3
    v9 = T[0, 3] * k3
    v10 = v8 * k4 + v9 * k5
    v11 = k4 * v9 - v8 * k5
    D1 = k8 - v11 * v11
    apart2 = k11 < D1
    if not (-k10 <= D1):
        return
    w2 = math.sqrt(D1 if apart2 else 0.0)

    for i1 in range(2):  # forward, backward
        e1 = 1.0 - 2.0 * i1
        # theta2, r1: type 5
        if e1 < 0.0 and not apart2:
            continue
        r1 = (v10 + w2 * e1) * k12
        s2 = v8 - k4 * r1
        c2 = v9 - k5 * r1
        q2 = math.atan2(s2, c2)
        row = i1
        q[row, 0] = r1
        q[row, 1] = q2
        status[row] = OK


@njit(cache=True, error_model="numpy")
def _fit(T):
    """What the named entries of T are: 0 no pose, 1 a pose, 2 a pose that is only rounded."""
    if not math.isfinite(T[0, 3]):
        return 0
    if not math.isfinite(T[1, 3]):
        return 0
    return 1


@njit(cache=True, error_model="numpy")
def _turned(joint, value, towards):
    """A joint value moved by whole turns, near to another value but inside its limits."""
    if not _REVOLUTE[joint]:
        return value
    low, high = _LOWEST[joint] - 1e-09, _HIGHEST[joint] + 1e-09
    value += _TURN * math.floor((towards - value) / _TURN + 0.5)
    if value > high:
        value -= _TURN * math.ceil((value - high) / _TURN)
    if value < low:
        value += _TURN * math.ceil((low - value) / _TURN)
    return value


@njit(cache=True, error_model="numpy")
def _ik(T, seed, q, status):
    """All rows into q (2, 2) and status (2,); how many are OK or FREE_JOINT."""
    fit = _fit(T)
    for row in range(2):
        status[row] = UNREACHABLE if fit else INVALID_POSE
        for i in range(2):
            q[row, i] = math.nan
    if not fit:
        return 0
    pose = T
    _solve(pose, seed, q, status)
    count = 0
    for row in range(2):
        if status[row] == UNREACHABLE:
            continue
        for i in range(2):
            q[row, i] = _turned(i, q[row, i], q[row, i])
            if not _LOWEST[i] - 1e-09 <= q[row, i] <= _HIGHEST[i] + 1e-09:
                status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


@njit(cache=True, error_model="numpy", parallel=True)
def _ik_batch(T, q, status):
    for k in prange(len(T)):
        _ik(T[k], _ZEROS, q[k], status[k])


def ik_into(T, q, status, q_seed=_ZEROS):
    """All solutions without allocation, for control loops.

    Args:
        T: Pose (4, 4), float64.
        q: Filled with joint values (2, 2), NaN where there is no solution; float64.
        status: Filled with what each row holds (2,); uint8.
        q_seed: Values for joints that are indeterminate (2,).

    Returns:
        How many rows are OK or FREE_JOINT.
    """
    return _ik(T, q_seed, q, status)


def ik_all(T, q_seed=None):
    """All solutions: q (2, 2) and status (2,); row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (2,); zeros without it.
    """
    q = np.empty((2, 2))
    status = np.empty(2, np.uint8)
    seed = _ZEROS if q_seed is None else _vector(q_seed, DOF, "q_seed")
    _ik(_pose(T), seed, q, status)
    return q, status


def ik(T, q_seed=None, *, branch=None, limits=True):
    """One solution (2,): the nearest to the seed, angles moved by whole turns inside their limits.

    Args:
        T: Pose (4, 4).
        q_seed: Where the arm is (2,); zeros without it.
        branch: Only this branch: a name out of BRANCHES, or its row.
        limits: Whether joint limits count.

    Raises:
        Unreachable: There is no such solution; the text says why.
        ValueError: T is no pose, or there is no such branch.
    """
    seed = _ZEROS if q_seed is None else _vector(q_seed, DOF, "q_seed")
    q, status = ik_all(T, seed)
    if status[0] == INVALID_POSE:
        raise ValueError("T is no pose: its entries are not finite, or its rotation is not orthonormal")
    rows = range(2) if branch is None else [_row(branch)]
    best, least = None, math.inf
    for row in rows:
        if status[row] == UNREACHABLE or (limits and status[row] == OUT_OF_LIMITS):
            continue
        values = np.array([_near(i, q[row, i], seed[i], limits) for i in range(DOF)])
        distance = float(_WEIGHT @ (values - seed) ** 2)
        if distance < least:
            best, least = values, distance
    if best is None:
        where = "" if branch is None else f" in branch {BRANCHES[_row(branch)]}"
        beyond = any(status[row] == OUT_OF_LIMITS for row in rows)
        reason = "every solution is beyond the joint limits" if beyond else "the pose is out of reach"
        raise Unreachable(reason + where)
    return best


def ik_batch(T):
    """ik_all for N poses (N, 4, 4) on all cores: q (N, 2, 2) and status (N, 2)."""
    T = np.ascontiguousarray(T, np.float64)
    if T.ndim != 3 or T.shape[1:] != (4, 4):
        raise ValueError(f"T must have shape (N, 4, 4), not {T.shape}")
    q = np.empty((len(T), 2, 2))
    status = np.empty((len(T), 2), np.uint8)
    _ik_batch(T, q, status)
    return q, status


def _pose(T):
    T = np.asarray(T, np.float64)
    if T.shape != (4, 4):
        raise ValueError(f"T must have shape (4, 4), not {T.shape}")
    return np.ascontiguousarray(T)


def _vector(values, size, name):
    values = np.ascontiguousarray(values, np.float64)
    if values.shape != (size,):
        raise ValueError(f"{name} must have shape ({size},), not {values.shape}")
    return values


def _row(branch):
    if branch in BRANCHES:
        return BRANCHES.index(branch)
    if isinstance(branch, int) and 0 <= branch < MAX_SOLUTIONS:
        return branch
    raise ValueError(f"no branch {branch!r}; there are {', '.join(BRANCHES)}")


def _near(joint, value, towards, limits):
    if limits:
        return _turned(joint, value, towards)
    if not _REVOLUTE[joint]:
        return value
    return value + _TURN * math.floor((towards - value) / _TURN + 0.5)
