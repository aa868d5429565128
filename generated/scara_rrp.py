"""scara_rrp: SCARA arm without a wrist.

Inverse kinematics, generated from robots/scara_rrp.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/scara_rrp.yaml. The formulas and where they come from: scara_rrp.md.

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


NAME = "scara_rrp"
DOF = 3
JOINT_TYPES = "RRP"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "down",
    "up",
)
MAX_SOLUTIONS = 2

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose

d1 = 0.5  # joint offset 1 [m]
a1 = 0.4  # link length 1 [m]
a2 = 0.3  # link length 2 [m]
longest2 = 0.48999999999999994  # square of the longest reach [m^2]
shortest2 = 0.010000000000000007  # square of the shortest reach [m^2]
longest2_reach = 0.49000000000016797  # the longest, with what rounding adds [m^2]
shortest2_reach = 0.009999999999976007  # the shortest, with what rounding adds [m^2]
longest2_apart = 0.48999999999998317  # the longest, where branches merge [m^2]
shortest2_apart = 0.010000000000002408  # the shortest, where branches merge [m^2]
free_limit_squared2 = 1.4399999999999998e-24  # square of a length that fixes no angle [m^2]
k1 = 0.25  # a1^2 + a2^2 [m^2]
k2 = 4.166666666666667  # 1 / (2 * a2 * a1) [m^-2]

_TURN = 6.283185307179586
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 0.6944444444444444])
_ZEROS = np.zeros(DOF)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the text says which."""


@njit(cache=True, error_model="numpy")
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 3 joint values")
    T = np.zeros((4, 4))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    T11_ = c1 * c2 - s1 * s2
    T21_ = s1 * c2 + c1 * s2
    T14_ = c1 * a1 + T11_ * a2
    T24_ = s1 * a1 + T21_ * a2
    T34_ = d1 + q[2]
    T[0, 0] = T11_
    T[0, 1] = -T21_
    T[0, 3] = T14_
    T[1, 0] = T21_
    T[1, 1] = T11_
    T[1, 3] = T24_
    T[2, 2] = 1.0
    T[2, 3] = T34_
    T[3, 3] = 1.0
    return T


@njit(cache=True, error_model="numpy")
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 3 joint values")
    J = np.zeros((6, 3))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    p1_x = c1 * a1
    p1_y = s1 * a1
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    J21 = p1_x + (c1 * c2 - s1 * s2) * a2
    p2_y = p1_y + (s1 * c2 + c1 * s2) * a2
    J22 = J21 - p1_x
    J12 = p1_y - p2_y
    J[0, 0] = -p2_y
    J[0, 1] = J12
    J[1, 0] = J21
    J[1, 1] = J22
    J[2, 2] = 1.0
    J[5, 0] = 1.0
    J[5, 1] = 1.0
    return J


@njit(cache=True, error_model="numpy")
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    # r3, type 1: U0[3, 4]
    r3 = T34 - d1

    # theta2, type 8: U0[1, 4] and U0[2, 4]
    N2 = T14 * T14 + T24 * T24
    K2 = N2 - k1
    D2 = (longest2 - N2) * (N2 - shortest2)
    apart2 = shortest2_apart < N2 and N2 < longest2_apart
    if not (shortest2_reach <= N2 and N2 <= longest2_reach):
        return  # out of reach
    w2 = math.sqrt(D2 if apart2 else 0.0)
    c2 = K2 * k2

    # theta1, type 3: U0[2, 4] and U0[1, 4]
    X1_1 = a1 + a2 * c2
    v1 = T24 * X1_1
    v2 = T14 * X1_1

    for i1 in range(2):  # down, up
        e1 = 1.0 - 2.0 * i1
        # theta2
        if e1 < 0.0 and not apart2:
            continue  # both signs give the same
        s2 = w2 * e1 * k2
        q2 = math.atan2(s2, c2)

        # theta1
        Y1_1 = a2 * s2
        S1 = v1 - T14 * Y1_1
        C1 = v2 + T24 * Y1_1
        w1 = math.sqrt(S1 * S1 + C1 * C1)
        free1 = w1 <= free_limit_squared2
        factor1 = 1.0 / (1.0 if free1 else w1)
        c1 = math.cos(seed[0]) if free1 else C1 * factor1
        s1 = math.sin(seed[0]) if free1 else S1 * factor1
        q1 = math.atan2(s1, c1)
        row = i1
        q[row, 0] = q1
        q[row, 1] = q2
        q[row, 2] = r3
        status[row] = FREE_JOINT if free1 else OK


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
        for i in range(3):
            q[row, i] = math.nan
    if not valid:
        return 0
    pose = _read(T)
    _solve(pose, seed, q, status)
    count = 0
    for row in range(2):
        if status[row] == UNREACHABLE:
            continue
        for i in range(3):
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
        q: Filled with joint values (2, 3), NaN where there is no solution; float64.
        status: Filled with what each row holds (2,); uint8.
        q_seed: Values for joints that are indeterminate (3,), float64.

    Returns:
        How many rows are OK or FREE_JOINT.
    """
    if q.shape != (MAX_SOLUTIONS, DOF) or status.shape != (MAX_SOLUTIONS,) or T.shape != (4, 4):
        raise ValueError("T, q and status must be (4, 4), (2, 3) and (2,)")
    return _ik(T, q_seed, q, status)


def ik_all(T, q_seed=None):
    """All solutions: q (2, 3) and status (2,).

    Row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (3,); zeros without it.
    """
    q = np.empty((2, 3))
    status = np.empty(2, np.uint8)
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
        q (N, 2, 3) and status (N, 2).
    """
    T = _array(T, (len(T), 4, 4), "T")
    q = np.empty((len(T), 2, 3))
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
