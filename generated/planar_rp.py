"""planar_rp: Planar arm with a revolute and a prismatic joint.

Inverse kinematics, generated from robots/planar_rp.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/planar_rp.yaml. The formulas and where they come from: planar_rp.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, x =
T[0, 3] and y = T[1, 3] counts; other entries are ignored.
"""

import math

import numpy as np

try:
    from numba import njit, prange
except ImportError:  # plain Python, only slower
    prange = range

    def njit(*_, **__):
        return lambda function: function


NAME = "planar_rp"
DOF = 2
JOINT_TYPES = "RP"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (0.0, 1.0),
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

free_limit1 = 1e-12  # a length that fixes no angle [m]
offset1 = 1.5707963267948966  # offset of joint 1 [rad]

_TURN = 6.283185307179586
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0])
_ZEROS = np.zeros(DOF)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the text says which."""


@njit(cache=True, error_model="numpy")
def _wrap(angle):
    """The angle moved by whole turns to (-pi, pi]."""
    return angle - _TURN * math.ceil(angle / _TURN - 0.5)


@njit(cache=True, error_model="numpy")
def fk(q):
    """The pose (4, 4) of the joint values q (2,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 2 joint values")
    T = np.zeros((4, 4))
    v1 = q[0] + offset1
    c1 = math.cos(v1)
    s1 = math.sin(v1)
    T14_ = s1 * q[1]
    T[0, 0] = c1
    T[0, 2] = s1
    T[0, 3] = T14_
    T[1, 0] = s1
    T[1, 2] = -c1
    T[1, 3] = -(c1 * q[1])
    T[2, 1] = 1.0
    T[3, 3] = 1.0
    return T


@njit(cache=True, error_model="numpy")
def jacobian(q):
    """The geometric Jacobian (6, 2): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 2 joint values")
    J = np.zeros((6, 2))
    v1 = q[0] + offset1
    c1 = math.cos(v1)
    s1 = math.sin(v1)
    J21 = s1 * q[1]
    J11 = c1 * q[1]
    J[0, 0] = J11
    J[0, 1] = s1
    J[1, 0] = J21
    J[1, 1] = -c1
    J[5, 0] = 1.0
    return J


@njit(cache=True, error_model="numpy")
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, _ = pose

    # theta1, r2, type 4: U0[1, 4] and U0[2, 4]
    w2 = math.sqrt(T14 * T14 + T24 * T24)
    free1 = w2 <= free_limit1
    divisor1 = 1.0 if free1 else w2
    v1 = seed[0] + offset1

    for i1 in range(2):  # forward, backward
        e1 = 1.0 - 2.0 * i1
        # theta1, r2
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(v1) if free1 else -(T24 * factor1)
        s1 = math.sin(v1) if free1 else T14 * factor1
        r2 = w2 * e1

        # joint values
        q1 = _wrap(math.atan2(s1, c1) - offset1)
        row = i1
        q[row, 0] = q1
        q[row, 1] = r2
        status[row] = FREE_JOINT if free1 else OK


@njit(cache=True, error_model="numpy")
def _is_pose(T):
    """Whether the entries that count make a pose."""
    return math.isfinite(T[0, 3]) and math.isfinite(T[1, 3])


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
def _turned(joint, given, towards):
    """A joint value moved by whole turns, near to another value but inside its limits."""
    if not _REVOLUTE[joint]:
        return given
    low, high = _LOWEST[joint] - 1e-09, _HIGHEST[joint] + 1e-09
    value = given + _TURN * math.floor((towards - given) / _TURN + 0.5)
    if value > high:
        value -= _TURN * math.ceil((value - high) / _TURN)
    if value < low:
        value += _TURN * math.ceil((low - value) / _TURN)
    return value if value <= high else given


@njit(cache=True, error_model="numpy")
def _ik(T, seed, q, status):
    """All rows into q and status; how many are OK or FREE_JOINT."""
    valid = _is_pose(T)
    for row in range(2):
        status[row] = UNREACHABLE if valid else INVALID_POSE
        for i in range(2):
            q[row, i] = math.nan
    if not valid:
        return 0
    pose = _read(T)
    _solve(pose, seed, q, status)
    count = 0
    for row in range(2):
        if status[row] == UNREACHABLE:
            continue
        for i in range(2):
            q[row, i] = _turned(i, q[row, i], q[row, i])
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
        q: Filled with joint values (2, 2), NaN where there is no solution; float64.
        status: Filled with what each row holds (2,); uint8.
        q_seed: Values for joints that are indeterminate (2,), float64.

    Returns:
        How many rows are OK or FREE_JOINT.
    """
    if q.shape != (MAX_SOLUTIONS, DOF) or status.shape != (MAX_SOLUTIONS,) or T.shape != (4, 4):
        raise ValueError("T, q and status must be (4, 4), (2, 2) and (2,)")
    return _ik(T, q_seed, q, status)


def ik_all(T, q_seed=None):
    """All solutions: q (2, 2) and status (2,).

    Row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (2,); zeros without it.
    """
    q = np.empty((2, 2))
    status = np.empty(2, np.uint8)
    seed = _ZEROS if q_seed is None else _vector(q_seed, DOF, "q_seed")
    _ik(_array(T, (4, 4), "T"), seed, q, status)
    return q, status


def ik(T, q_seed=None, *, branch=None, limits=True):
    """One solution (2,): the nearest to the seed.

    Angles are moved by whole turns inside their limits.

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
    rows = range(2) if branch is None else [_row(branch)]
    q, status = ik_all(T, seed)
    if status[0] == INVALID_POSE:
        raise ValueError("T is no pose: not finite")
    best, least = None, math.inf
    for row in rows:
        if status[row] == UNREACHABLE or (limits and status[row] == OUT_OF_LIMITS):
            continue
        values = np.array([_near(i, q[row, i], seed[i], limits) for i in range(DOF)])
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
        q (N, 2, 2) and status (N, 2).
    """
    T = _array(T, (len(T), 4, 4), "T")
    q = np.empty((len(T), 2, 2))
    status = np.empty((len(T), 2), np.uint8)
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


def _near(joint, value, towards, limits):
    """A joint value moved by whole turns near to another, if limits count inside its own."""
    if limits:
        return _turned(joint, value, towards)
    if not _REVOLUTE[joint]:
        return value
    return value + _TURN * math.floor((towards - value) / _TURN + 0.5)
