"""wrist_cardan: Spherical wrist, cardan axes.

Inverse kinematics, generated from robots/wrist_cardan.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/wrist_cardan.yaml. The formulas and where they come from: wrist_cardan.md.

Poses are 4 x 4 matrices of the tool in the base frame, in m; angles are in rad. Of a pose,
the orientation T[0:3, 0:3] is meant; other entries are ignored.
"""

import math

import numpy as np

try:
    from numba import njit, prange
except ImportError:  # plain Python, only slower
    prange = range

    def njit(*_, **__):
        return lambda function: function


NAME = "wrist_cardan"
DOF = 3
JOINT_TYPES = "RRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "left",
    "right",
)
MAX_SOLUTIONS = 2

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose

free_tolerance = 1e-12  # a vector this short fixes no angle

_TURN = 6.283185307179586
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
_WEIGHT = np.array([1.0, 1.0, 1.0])  # of squared differences: lengths by arm size
_ZEROS = np.zeros(DOF)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the text says which."""


@njit(cache=True, error_model="numpy")
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = np.zeros((4, 4))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    T11 = c1 * c2
    v13 = c1 * s2
    v14 = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    T13 = s1 * c3 + v13 * s3
    T33 = c1 * c3 - v14 * s3
    T22 = c2 * c3
    T32 = v14 * c3 + c1 * s3
    T12 = s1 * s3 - v13 * c3
    T[0, 0] = T11
    T[0, 1] = T12
    T[0, 2] = T13
    T[1, 0] = s2
    T[1, 1] = T22
    T[1, 2] = -(c2 * s3)
    T[2, 0] = -(s1 * c2)
    T[2, 1] = T32
    T[2, 2] = T33
    T[3, 3] = 1.0
    return T


@njit(cache=True, error_model="numpy")
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = np.zeros((6, 3))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    J43 = c1 * c2
    J[3, 1] = s1
    J[3, 2] = J43
    J[4, 0] = 1.0
    J[4, 2] = s2
    J[5, 1] = c1
    J[5, 2] = -(s1 * c2)
    return J


@njit(cache=True, error_model="numpy")
def _solve(T, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others.
    """

    # theta1: type 2
    w1 = math.sqrt(T[0, 0] * T[0, 0] + T[2, 0] * T[2, 0])
    free1 = w1 <= free_tolerance
    v11 = 1.0 if free1 else w1

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1: type 2
        if e1 < 0.0 and free1:
            continue
        v12 = e1 / v11
        c1 = math.cos(seed[0]) if free1 else T[0, 0] * v12
        s1 = math.sin(seed[0]) if free1 else -(T[2, 0] * v12)
        q1 = math.atan2(s1, c1)
        c2 = w1 * e1

        # theta2: type 3
        q2 = math.atan2(T[1, 0], c2)

        # theta3: type 3
        s3 = T[2, 1] * c1 + T[0, 1] * s1
        c3 = T[2, 2] * c1 + T[0, 2] * s1
        q3 = math.atan2(s3, c3)
        row = i1
        q[row, 0] = q1
        q[row, 1] = q2
        q[row, 2] = q3
        status[row] = FREE_JOINT if free1 else OK


@njit(cache=True, error_model="numpy")
def _fit(T):
    """What the named entries of T are: 0 no pose, 1 a pose, 2 a pose that is only rounded."""
    aa = T[0, 0] * T[0, 0] + T[0, 1] * T[0, 1] + T[0, 2] * T[0, 2] - 1.0
    bb = T[1, 0] * T[1, 0] + T[1, 1] * T[1, 1] + T[1, 2] * T[1, 2] - 1.0
    ab = T[0, 0] * T[1, 0] + T[0, 1] * T[1, 1] + T[0, 2] * T[1, 2]
    x = T[0, 1] * T[1, 2] - T[0, 2] * T[1, 1] - T[2, 0]
    y = T[0, 2] * T[1, 0] - T[0, 0] * T[1, 2] - T[2, 1]
    z = T[0, 0] * T[1, 1] - T[0, 1] * T[1, 0] - T[2, 2]
    miss = aa * aa + bb * bb + 2.0 * ab * ab + x * x + y * y + z * z
    if not miss <= 1e-09:
        return 0
    return 1 if miss <= 1e-24 else 2


@njit(cache=True, error_model="numpy")
def _straightened(T):
    """The pose with the nearest rotation: twice R (3 I - R' R) / 2 (polar decomposition, Higham 1986)."""
    R = T.copy()
    for _ in range(2):
        S = R.copy()
        for i in range(3):
            for j in range(3):
                total = 1.5 * S[i, j]
                for k in range(3):
                    gram = S[0, k] * S[0, j] + S[1, k] * S[1, j] + S[2, k] * S[2, j]
                    total -= 0.5 * S[i, k] * gram
                R[i, j] = total
    return R


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
    """All rows into q (2, 3) and status (2,); how many are OK or FREE_JOINT."""
    fit = _fit(T)
    for row in range(2):
        status[row] = UNREACHABLE if fit else INVALID_POSE
        for i in range(3):
            q[row, i] = math.nan
    if not fit:
        return 0
    pose = T if fit == 1 else _straightened(T)
    _solve(pose, seed, q, status)
    count = 0
    for row in range(2):
        if status[row] == UNREACHABLE:
            continue
        for i in range(3):
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
        q: Filled with joint values (2, 3), NaN where there is no solution; float64.
        status: Filled with what each row holds (2,); uint8.
        q_seed: Values for joints that are indeterminate (3,).

    Returns:
        How many rows are OK or FREE_JOINT.
    """
    return _ik(T, q_seed, q, status)


def ik_all(T, q_seed=None):
    """All solutions: q (2, 3) and status (2,); row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (3,); zeros without it.
    """
    q = np.empty((2, 3))
    status = np.empty(2, np.uint8)
    seed = _ZEROS if q_seed is None else _vector(q_seed, DOF, "q_seed")
    _ik(_pose(T), seed, q, status)
    return q, status


def ik(T, q_seed=None, *, branch=None, limits=True):
    """One solution (3,): the nearest to the seed, angles moved by whole turns inside their limits.

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
    """ik_all for N poses (N, 4, 4) on all cores: q (N, 2, 3) and status (N, 2)."""
    T = np.ascontiguousarray(T, np.float64)
    if T.ndim != 3 or T.shape[1:] != (4, 4):
        raise ValueError(f"T must have shape (N, 4, 4), not {T.shape}")
    q = np.empty((len(T), 2, 3))
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
