"""scara_wrist: SCARA arm with a spherical wrist.

Inverse kinematics, generated from robots/scara_wrist.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/scara_wrist.yaml. The formulas and where they come from: scara_wrist.md.

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


NAME = "scara_wrist"
DOF = 6
JOINT_TYPES = "RRPRRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "down-left",
    "down-right",
    "up-left",
    "up-right",
)
MAX_SOLUTIONS = 4

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose

d6 = 0.1  # joint offset 6
d1 = 0.5  # joint offset 1
a1 = 0.4  # link length 1
a2 = 0.3  # link length 2
k5 = 0.25  # (a1 * a1) + (a2 * a2)
longest2 = 0.48999999999999994  # square of the longest reach
shortest2 = 0.010000000000000007  # square of the shortest reach
longest2_reach = 0.49000000000018196  # the same, longest by rounding
shortest2_reach = 0.009999999999974009  # the same, shortest by rounding
longest2_apart = 0.48999999999998173  # the same, longest for merging
shortest2_apart = 0.010000000000002607  # the same, shortest for merging
k7 = 4.166666666666667  # 1 / (2 * (a2 * a1))
free_square_tolerance2 = 1.69e-24  # the same, squared [length^2]
free_tolerance = 1e-12  # a vector this short fixes no angle

_TURN = 6.283185307179586
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
_WEIGHT = np.array([1.0, 1.0, 0.5917159763313609, 1.0, 1.0, 1.0])  # of squared differences: lengths by arm size
_ZEROS = np.zeros(DOF)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the text says which."""



@njit(cache=True, error_model="numpy")
def wrap(angle):
    """The angle moved by whole turns to (-pi, pi]."""
    return angle - _TURN * math.ceil(angle / _TURN - 0.5)


@njit(cache=True, error_model="numpy")
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = np.zeros((4, 4))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    v19 = c1 * c2
    v20 = s1 * s2
    v21 = v19 - v20
    v22 = s1 * c2 + c1 * s2
    v23 = v20 - v19
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    v24 = v22 * s4
    v25 = v21 * c4 + v24
    v26 = v22 * c4
    v27 = v26 + v23 * s4
    v28 = v26 - v21 * s4
    v29 = v23 * c4 - v24
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v30 = v25 * c5
    v31 = v27 * c5
    v32 = v25 * s5
    v33 = v27 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T11 = v30 * c6 + v28 * s6
    T21 = v31 * c6 + v29 * s6
    T12 = v28 * c6 - v30 * s6
    T22 = v29 * c6 - v31 * s6
    T32 = s5 * s6
    T14 = c1 * a1 + v21 * a2 - v32 * d6
    T24 = s1 * a1 + v22 * a2 - v33 * d6
    T34 = d1 + q[2] - c5 * d6
    T[0, 0] = T11
    T[0, 1] = T12
    T[0, 2] = -v32
    T[0, 3] = T14
    T[1, 0] = T21
    T[1, 1] = T22
    T[1, 2] = -v33
    T[1, 3] = T24
    T[2, 0] = -(s5 * c6)
    T[2, 1] = T32
    T[2, 2] = -c5
    T[2, 3] = T34
    T[3, 3] = 1.0
    return T


@njit(cache=True, error_model="numpy")
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = np.zeros((6, 6))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    v24 = c1 * a1
    v25 = s1 * a1
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    v26 = c1 * c2
    v27 = s1 * s2
    v28 = v26 - v27
    v29 = s1 * c2 + c1 * s2
    v30 = v24 + v28 * a2
    v31 = v25 + v29 * a2
    v32 = d1 + q[2]
    v33 = v27 - v26
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    v34 = v29 * s4
    v35 = v29 * c4
    J45 = v28 * s4 - v35
    J55 = v34 - v33 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v36 = (v28 * c4 + v34) * s5
    v37 = (v35 + v33 * s4) * s5
    J21 = v30 - v36 * d6
    v38 = v37 * d6
    v39 = v31 - v38
    J11 = v38 - v31
    J22 = J21 - v24
    J12 = v25 - v39
    v40 = J21 - v30
    J14 = v39 - v31
    v41 = v32 - c5 * d6 - v32
    J24 = v30 - J21
    J15 = J55 * v41
    J35 = J45 * J14 - J55 * v40
    J16 = c5 * J14 - v37 * v41
    J26 = v36 * v41 - c5 * v40
    J36 = v37 * v40 - v36 * J14
    J[0, 0] = J11
    J[0, 1] = J12
    J[0, 3] = J14
    J[0, 4] = J15
    J[0, 5] = J16
    J[1, 0] = J21
    J[1, 1] = J22
    J[1, 3] = J24
    J[1, 4] = -(J45 * v41)
    J[1, 5] = J26
    J[2, 2] = 1.0
    J[2, 4] = J35
    J[2, 5] = J36
    J[3, 4] = J45
    J[3, 5] = -v36
    J[4, 4] = J55
    J[4, 5] = -v37
    J[5, 0] = 1.0
    J[5, 1] = 1.0
    J[5, 3] = -1.0
    J[5, 5] = -c5
    return J


@njit(cache=True, error_model="numpy")
def _solve(T, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others.
    """

    # r3: type 1
    wz = T[2, 3] - T[2, 2] * d6
    r3 = wz - d1

    # theta2: type 8
    wx = T[0, 3] - d6 * T[0, 2]
    wy = T[1, 3] - d6 * T[1, 2]
    N2 = wx * wx + wy * wy
    K2 = N2 - k5
    D2 = (longest2 - N2) * (N2 - shortest2)
    apart2 = shortest2_apart < N2 and N2 < longest2_apart
    if not (shortest2_reach <= N2 and N2 <= longest2_reach):
        return
    w2 = math.sqrt(D2 if apart2 else 0.0)
    c2 = K2 * k7

    # theta1: type 3
    v28 = a1 + a2 * c2
    v30 = wy * v28
    v32 = wx * v28

    # theta12m4: type 2
    w12m4 = math.sqrt(T[0, 2] * T[0, 2] + T[1, 2] * T[1, 2])
    free12m4 = w12m4 <= free_tolerance
    v35 = 1.0 if free12m4 else w12m4

    for i1 in range(2):  # down, up
        e1 = 1.0 - 2.0 * i1
        # theta2: type 8
        if e1 < 0.0 and not apart2:
            continue
        s2 = w2 * e1 * k7
        q2 = math.atan2(s2, c2)

        # theta1: type 3
        v29 = a2 * s2
        v31 = v30 - wx * v29
        v33 = v32 + wy * v29
        w1 = math.sqrt(v31 * v31 + v33 * v33)
        free1 = w1 <= free_square_tolerance2
        v34 = 1.0 / (1.0 if free1 else w1)
        c1 = math.cos(seed[0]) if free1 else v33 * v34
        s1 = math.sin(seed[0]) if free1 else v31 * v34
        q1 = math.atan2(s1, c1)

        # theta12m4: type 2
        v37 = q2 + q1
        v38 = v37 - seed[3]

        for i2 in range(2):  # left, right
            e2 = 1.0 - 2.0 * i2
            # theta12m4: type 2
            if e2 < 0.0 and free12m4:
                continue
            v36 = e2 / v35
            c12m4 = math.cos(v38) if free12m4 else -(T[0, 2] * v36)
            s12m4 = math.sin(v38) if free12m4 else -(T[1, 2] * v36)
            s5 = w12m4 * e2

            # theta5: type 3
            q5 = math.atan2(s5, -T[2, 2])

            # theta6: type 3
            c6 = T[0, 1] * s12m4 - T[1, 1] * c12m4
            s6 = T[0, 0] * s12m4 - T[1, 0] * c12m4
            q6 = math.atan2(s6, c6)

            # joint values
            q4 = wrap(v37 - math.atan2(s12m4, c12m4))
            row = 2 * i1 + i2
            q[row, 0] = q1
            q[row, 1] = q2
            q[row, 2] = r3
            q[row, 3] = q4
            q[row, 4] = q5
            q[row, 5] = q6
            status[row] = FREE_JOINT if free1 or free12m4 else OK


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
def _ik(T, seed, q, status):
    """All rows into q (4, 6) and status (4,); how many are OK or FREE_JOINT."""
    fit = _fit(T)
    for row in range(4):
        status[row] = UNREACHABLE if fit else INVALID_POSE
        for i in range(6):
            q[row, i] = math.nan
    if not fit:
        return 0
    pose = T if fit == 1 else _straightened(T)
    _solve(pose, seed, q, status)
    count = 0
    for row in range(4):
        if status[row] == UNREACHABLE:
            continue
        for i in range(6):
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
        q: Filled with joint values (4, 6), NaN where there is no solution; float64.
        status: Filled with what each row holds (4,); uint8.
        q_seed: Values for joints that are indeterminate (6,).

    Returns:
        How many rows are OK or FREE_JOINT.
    """
    return _ik(T, q_seed, q, status)


def ik_all(T, q_seed=None):
    """All solutions: q (4, 6) and status (4,); row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (6,); zeros without it.
    """
    q = np.empty((4, 6))
    status = np.empty(4, np.uint8)
    seed = _ZEROS if q_seed is None else _vector(q_seed, DOF, "q_seed")
    _ik(_pose(T), seed, q, status)
    return q, status


def ik(T, q_seed=None, *, branch=None, limits=True):
    """One solution (6,): the nearest to the seed, angles moved by whole turns inside their limits.

    Args:
        T: Pose (4, 4).
        q_seed: Where the arm is (6,); zeros without it.
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
    rows = range(4) if branch is None else [_row(branch)]
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
    """ik_all for N poses (N, 4, 4) on all cores: q (N, 4, 6) and status (N, 4)."""
    T = np.ascontiguousarray(T, np.float64)
    if T.ndim != 3 or T.shape[1:] != (4, 4):
        raise ValueError(f"T must have shape (N, 4, 4), not {T.shape}")
    q = np.empty((len(T), 4, 6))
    status = np.empty((len(T), 4), np.uint8)
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
