"""planar_rrr: Planar arm with three revolute joints.

Inverse kinematics, generated from robots/planar_rrr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/planar_rrr.yaml. The formulas and where they come from: planar_rrr.md.

Poses are 4 x 4 matrices of the tool in the base frame, in m; angles are in rad. Of a pose,
the whole pose is meant; other entries are ignored.
"""

import math

import numpy as np

try:
    from numba import njit, prange
except ImportError:  # plain Python, only slower
    prange = range

    def njit(*_, **__):
        return lambda function: function


NAME = "planar_rrr"
DOF = 3
JOINT_TYPES = "RRR"
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
_LOST = 128

free_square_tolerance = 1e-24  # the same, squared
a3 = 0.15  # link length 3
a1 = 0.4  # link length 1
a2 = 0.3  # link length 2
k5 = 0.25  # (a1 * a1) + (a2 * a2)
longest2 = 0.48999999999999994  # square of the longest reach
shortest2 = 0.010000000000000007  # square of the shortest reach
longest2_reach = 0.490000000000119  # the same, longest by rounding
shortest2_reach = 0.009999999999983007  # the same, shortest by rounding
longest2_apart = 0.48999999999998795  # the same, longest for merging
shortest2_apart = 0.010000000000001705  # the same, shortest for merging
k7 = 4.166666666666667  # 1 / (2 * (a2 * a1))
free_square_tolerance2 = 7.224999999999999e-25  # the same, squared [length^2]
k8 = 99999.99999999999  # 1 / consistent_tolerance
k9 = 117647.05882352941  # 1 / consistent_tolerance1

_TURN = 6.283185307179586
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
_WEIGHT = np.array([1.0, 1.0, 1.0])  # of squared differences: lengths by arm size
_ZEROS = np.zeros(DOF)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the text says which."""



@njit(cache=True, error_model="numpy")
def wrap(angle):
    """The angle moved by whole turns to (-pi, pi]."""
    return angle - _TURN * math.ceil(angle / _TURN - 0.5)


@njit(cache=True, error_model="numpy")
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = np.zeros((4, 4))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    v11 = c1 * c2 - s1 * s2
    v12 = s1 * c2 + c1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    T11 = v11 * c3 - v12 * s3
    T21 = v12 * c3 + v11 * s3
    T14 = c1 * a1 + v11 * a2 + T11 * a3
    T24 = s1 * a1 + v12 * a2 + T21 * a3
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
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = np.zeros((6, 3))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    v12 = c1 * a1
    v13 = s1 * a1
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    v14 = c1 * c2 - s1 * s2
    v15 = s1 * c2 + c1 * s2
    v16 = v12 + v14 * a2
    v17 = v13 + v15 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    J21 = v16 + (v14 * c3 - v15 * s3) * a3
    v18 = v17 + (v15 * c3 + v14 * s3) * a3
    J22 = J21 - v12
    J12 = v13 - v18
    J23 = J21 - v16
    J13 = v17 - v18
    J[0, 0] = -v18
    J[0, 1] = J12
    J[0, 2] = J13
    J[1, 0] = J21
    J[1, 1] = J22
    J[1, 2] = J23
    J[5, 0] = 1.0
    J[5, 1] = 1.0
    J[5, 2] = 1.0
    return J


@njit(cache=True, error_model="numpy")
def _solve(T, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others.

    A row that was lost after joint j had been chosen freely gets the status _LOST + j and, as its
    first value, how far it is from a solution (negative).
    """

    # theta123: type 3
    w123 = math.sqrt(T[1, 0] * T[1, 0] + T[0, 0] * T[0, 0])
    free123 = w123 <= free_square_tolerance
    v22 = 1.0 / (1.0 if free123 else w123)
    v23 = seed[0] + seed[1] + seed[2]
    c123 = math.cos(v23) if free123 else T[0, 0] * v22
    s123 = math.sin(v23) if free123 else T[1, 0] * v22
    v24 = math.atan2(s123, c123)

    # theta2: type 8
    v25 = c123 * a3
    v26 = T[0, 3] - v25
    v27 = s123 * a3
    v28 = T[1, 3] - v27
    N2 = v26 * v26 + v28 * v28
    K2 = N2 - k5
    D2 = (longest2 - N2) * (N2 - shortest2)
    apart2 = shortest2_apart < N2 and N2 < longest2_apart
    if not (shortest2_reach <= N2 and N2 <= longest2_reach):
        if free123:
            status[0] = _LOST + 1
            q[0, 0] = D2
        if free123:
            status[0] = _LOST + 2
            q[0, 0] = D2
        if free123:
            status[0] = _LOST + 3
            q[0, 0] = D2
        return
    w2 = math.sqrt(D2 if apart2 else 0.0)
    c2 = K2 * k7

    # theta1: type 3
    v29 = a1 + a2 * c2
    v31 = v28 * v29
    v33 = v26 * v29

    # is the pose one that the arm can take?
    v36 = max(max(abs(c123 - T[0, 0]) * k8, k8 * abs(-(T[0, 1] + s123))), k8 * abs(-T[0, 2]))
    v37 = k8 * abs(s123 - T[1, 0])
    v38 = k8 * abs(c123 - T[1, 1])
    v39 = k8 * abs(-T[1, 2])
    v40 = k8 * abs(-T[2, 0])
    v41 = k8 * abs(-T[2, 1])
    v42 = k8 * abs(1.0 - T[2, 2])
    v43 = k9 * abs(-T[2, 3])

    for i1 in range(2):  # down, up
        e1 = 1.0 - 2.0 * i1
        # theta2: type 8
        if e1 < 0.0 and not apart2:
            continue
        s2 = w2 * e1 * k7
        q2 = math.atan2(s2, c2)

        # theta1: type 3
        v30 = a2 * s2
        v32 = v31 - v26 * v30
        v34 = v33 + v28 * v30
        w1 = math.sqrt(v32 * v32 + v34 * v34)
        free1 = w1 <= free_square_tolerance2
        v35 = 1.0 / (1.0 if free1 else w1)
        c1 = math.cos(seed[0]) if free1 else v34 * v35
        s1 = math.sin(seed[0]) if free1 else v32 * v35
        q1 = math.atan2(s1, c1)

        # is the pose one that the arm can take?
        c12 = c2 * c1 - s2 * s1
        s12 = c2 * s1 + s2 * c1
        if not (max(max(max(max(max(max(max(max(max(v36, abs(a2 * c12 + (v25 + a1 * c1) - T[0, 3]) * k9), v37), v38), v39), k9 * abs(a2 * s12 + (v27 + a1 * s1) - T[1, 3])), v40), v41), v42), v43) <= 1.0):
            continue

        # joint values
        q3 = wrap(v24 - (q2 + q1))
        free1_ = free123 or free1
        row = i1
        q[row, 0] = q1
        q[row, 1] = q2
        q[row, 2] = q3
        status[row] = FREE_JOINT if free1_ or free123 or free123 else OK


@njit(cache=True, error_model="numpy")
def _fit(T):
    """What the named entries of T are: 0 no pose, 1 a pose, 2 a pose that is only rounded."""
    if not math.isfinite(T[0, 3]):
        return 0
    if not math.isfinite(T[1, 3]):
        return 0
    if not math.isfinite(T[2, 3]):
        return 0
    if not abs(T[3, 0]) + abs(T[3, 1]) + abs(T[3, 2]) + abs(T[3, 3] - 1.0) <= 1e-09:
        return 0
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
def _attempt(T, seed, joint, angle, row, q, status):
    """Solves with another seed for one joint: 0 if the row is solved, else how far it is from that."""
    kept = seed[joint]
    seed[joint] = angle
    for i in range(2):
        status[i] = UNREACHABLE
    _solve(T, seed, q, status)
    seed[joint] = kept
    if status[row] >= _LOST:
        return q[row, 0]
    return -math.inf if status[row] == UNREACHABLE else 0.0


@njit(cache=True, error_model="numpy")
def _choose_again(T, given, row, q, status):
    """A free joint took the seed's value, and then the arm could not reach: takes the nearest that serves.

    A fan of angles finds where the branch is solved, bisection the nearest such angle; where no
    angle of the fan serves, golden section goes for the best of them.
    """
    fan, halvings = 32, 52
    step, ratio = _TURN / (2.0 * fan), 0.6180339887498949
    joint = status[row] - _LOST - 1
    seed, trial, result = given.copy(), q.copy(), status.copy()
    start = seed[joint]
    best, peak, outer, found = -math.inf, 0.0, 0.0, False
    for k in range(1, 2 * fan + 1):
        outer = (step if k % 2 else -step) * ((k + 1) // 2)
        reach = _attempt(T, seed, joint, start + outer, row, trial, result)
        found = reach == 0.0
        if found:
            break
        if reach > best:
            best, peak = reach, outer
    inner = outer - step if outer > 0.0 else outer + step
    if not found:
        low, high = peak - step, peak + step
        for k in range(halvings):
            a, b = high - ratio * (high - low), low + ratio * (high - low)
            at_a = _attempt(T, seed, joint, start + a, row, trial, result)
            at_b = _attempt(T, seed, joint, start + b, row, trial, result)
            outer = a if at_a >= at_b else b
            found = at_a == 0.0 or at_b == 0.0
            if found:
                break
            if at_a >= at_b:
                high = b
            else:
                low = a
        inner = peak - step if outer > 0.0 else peak + step
    status[row] = UNREACHABLE
    for i in range(3):
        q[row, i] = math.nan
    if not found:
        return
    for k in range(halvings):
        middle = 0.5 * (inner + outer)
        if _attempt(T, seed, joint, start + middle, row, trial, result) == 0.0:
            outer = middle
        else:
            inner = middle
    _attempt(T, seed, joint, start + outer, row, trial, result)
    status[row] = result[row]
    for i in range(3):
        q[row, i] = trial[row, i]


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
        if status[row] >= _LOST:
            _choose_again(pose, seed, row, q, status)
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
