"""puma: PUMA in its reference position.

Inverse kinematics, generated from robots/puma.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/puma.yaml. The formulas and where they come from: puma.md.

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


NAME = "puma"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "left-down-noflip",
    "left-down-flip",
    "left-up-noflip",
    "left-up-flip",
    "right-down-noflip",
    "right-down-flip",
    "right-up-noflip",
    "right-up-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose

D3 = 0.15005  # x of axis 4
L2 = 0.4318  # z of axis 3
D4 = 0.4318  # z of axis 5
k1 = 0.8636  # L2 + D4
k2 = 0.022515002499999996  # D3 * D3
free_square_tolerance2 = 1.0274863225e-24  # the same, squared [length^2]
reach_tolerance1 = 1.0136499999999999e-13  # rounding at the boundary of the workspace [length]
merge_tolerance1 = 1.0136499999999999e-14  # two branches nearer than this are one [length]
k4 = 0.37290248000000004  # 2 * (D4 * L2)
longest2 = 0.7458049600000001  # square of the longest reach
shortest2 = 0.0  # square of the shortest reach
longest2_reach = 0.7458049600001752  # the same, longest by rounding
shortest2_reach = 0.0  # the same, shortest by rounding
longest2_apart = 0.7458049599999826  # the same, longest for merging
shortest2_apart = 1.0274863225e-28  # the same, shortest for merging
k6 = 2.681666262986505  # 1 / (2 * (D4 * L2))
free_tolerance = 1e-12  # a vector this short fixes no angle
f1 = 0.8636  # L2 + D4
g1 = 0.8636  # L2 + D4

_TURN = 6.283185307179586
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])  # of squared differences: lengths by arm size
_ZEROS = np.zeros(DOF)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the text says which."""


@njit(cache=True, error_model="numpy")
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = np.zeros((4, 4))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    v24 = s1 * s2
    v25 = c1 * s2
    v26 = s1 * c2
    v27 = c1 * c2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    v28 = v24 * c3 + v26 * s3
    v29 = v25 * c3 + v27 * s3
    v30 = c2 * c3 - s2 * s3
    v31 = s2 * c3 + c2 * s3
    v32 = v24 * s3 - v26 * c3
    v33 = v27 * c3 - v25 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    v34 = c1 * c4 + v32 * s4
    v35 = s1 * c4 + v33 * s4
    v36 = v31 * s4
    v37 = v31 * c4
    v38 = c1 * s4 - v32 * c4
    v39 = s1 * s4 - v33 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    T13 = v28 * c5 + v38 * s5
    T23 = v39 * s5 - v29 * c5
    T33 = v30 * c5 - v37 * s5
    v40 = v39 * c5 + v29 * s5
    v41 = v37 * c5 + v30 * s5
    v42 = v28 * s5 - v38 * c5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T11 = v34 * c6 + v42 * s6
    T21 = v35 * c6 - v40 * s6
    T31 = v36 * c6 + v41 * s6
    T12 = v42 * c6 - v34 * s6
    T32 = v41 * c6 - v36 * s6
    T14 = v24 * L2 + c1 * D3 + v28 * D4 - D3 * T11 - T13 * f1
    T24 = s1 * D3 - v25 * L2 - v29 * D4 - D3 * T21 - T23 * f1
    T34 = c2 * L2 + v30 * D4 - D3 * T31 - T33 * f1
    T[0, 0] = T11
    T[0, 1] = T12
    T[0, 2] = T13
    T[0, 3] = T14
    T[1, 0] = T21
    T[1, 1] = -(v40 * c6 + v35 * s6)
    T[1, 2] = T23
    T[1, 3] = T24
    T[2, 0] = T31
    T[2, 1] = T32
    T[2, 2] = T33
    T[2, 3] = T34
    T[3, 3] = 1.0
    return T


@njit(cache=True, error_model="numpy")
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = np.zeros((6, 6))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    v35 = s1 * s2
    v36 = c1 * s2
    v37 = s1 * c2
    v38 = c1 * c2
    v39 = v35 * L2
    v40 = v36 * L2
    v41 = c2 * L2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    J44 = v35 * c3 + v37 * s3
    v42 = v36 * c3 + v38 * s3
    J64 = c2 * c3 - s2 * s3
    v43 = s2 * c3 + c2 * s3
    v44 = v39 + c1 * D3
    v45 = s1 * D3 - v40
    v46 = v35 * s3 - v37 * c3
    v47 = v38 * c3 - v36 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    J45 = c1 * c4 + v46 * s4
    J55 = s1 * c4 + v47 * s4
    J65 = v43 * s4
    v48 = v43 * c4
    v49 = v44 + J44 * D4
    v50 = v45 - v42 * D4
    v51 = v41 + J64 * D4
    v52 = c1 * s4 - v46 * c4
    v53 = s1 * s4 - v47 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    J46 = J44 * c5 + v52 * s5
    J56 = v53 * s5 - v42 * c5
    J66 = J64 * c5 - v48 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    v54 = v50 - D3 * (J55 * c6 - (v53 * c5 + v42 * s5) * s6)
    J21 = v49 - D3 * (J45 * c6 + (J44 * s5 - v52 * c5) * s6) - J46 * g1
    v55 = J56 * g1
    v56 = v54 - v55
    v57 = v51 - D3 * (J65 * c6 + (v48 * c5 + J64 * s5) * s6) - J66 * g1
    J11 = v55 - v54
    J12 = s1 * v57
    J32 = c1 * v56 - s1 * J21
    v58 = v57 - v41
    J13 = s1 * v58
    J33 = c1 * (v40 + v56) - s1 * (J21 - v39)
    v59 = J21 - v44
    v60 = v56 - v45
    J24 = J64 * v59 - J44 * v58
    J34 = J44 * v60 + v42 * v59
    v61 = J21 - v49
    v62 = v56 - v50
    v63 = v57 - v51
    J15 = J55 * v63 - J65 * v62
    J25 = J65 * v61 - J45 * v63
    J35 = J45 * v62 - J55 * v61
    J16 = J56 * v63 - J66 * v62
    J26 = J66 * v61 - J46 * v63
    J36 = J46 * v62 - J56 * v61
    J[0, 0] = J11
    J[0, 1] = J12
    J[0, 2] = J13
    J[0, 3] = -(v42 * v58 + J64 * v60)
    J[0, 4] = J15
    J[0, 5] = J16
    J[1, 0] = J21
    J[1, 1] = -(c1 * v57)
    J[1, 2] = -(c1 * v58)
    J[1, 3] = J24
    J[1, 4] = J25
    J[1, 5] = J26
    J[2, 1] = J32
    J[2, 2] = J33
    J[2, 3] = J34
    J[2, 4] = J35
    J[2, 5] = J36
    J[3, 1] = c1
    J[3, 2] = c1
    J[3, 3] = J44
    J[3, 4] = J45
    J[3, 5] = J46
    J[4, 1] = s1
    J[4, 2] = s1
    J[4, 3] = -v42
    J[4, 4] = J55
    J[4, 5] = J56
    J[5, 0] = 1.0
    J[5, 3] = J64
    J[5, 4] = J65
    J[5, 5] = J66
    return J


@njit(cache=True, error_model="numpy")
def _solve(T, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others.
    """

    # theta1: type 2
    t24 = T[1, 3] + D3 * T[1, 0] + k1 * T[1, 2]
    t14 = T[0, 3] + D3 * T[0, 0] + k1 * T[0, 2]
    N1 = t24 * t24 + t14 * t14
    D1 = N1 - k2
    free1 = N1 <= free_square_tolerance2
    v37 = 2.0 * abs(-D3)
    apart1 = merge_tolerance1 * (v37 + merge_tolerance1) < D1
    if not (-(reach_tolerance1 * (v37 + reach_tolerance1)) <= D1):
        return
    w1 = math.sqrt(D1 if apart1 else 0.0)
    v39 = 1.0 / (1.0 if free1 else N1)
    v40 = D3 * t24
    v41 = D3 * t14

    # theta3: type 8
    t34 = T[2, 3] + D3 * T[2, 0] + k1 * T[2, 2]
    v42 = t34 * t34

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1: type 2
        if e1 < 0.0 and (free1 or not apart1):
            continue
        v38 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else v39 * (v41 + t24 * v38)
        s1 = math.sin(seed[0]) if free1 else v39 * (v40 - t14 * v38)
        q1 = math.atan2(s1, c1)

        # theta3: type 8
        N3 = v42 + v38 * v38
        K3 = N3 - k4
        D3_ = (longest2 - N3) * (N3 - shortest2)
        apart3 = shortest2_apart < N3 and N3 < longest2_apart
        if not (shortest2_reach <= N3 and N3 <= longest2_reach):
            continue
        w3 = math.sqrt(D3_ if apart3 else 0.0)
        c3 = K3 * k6

        # theta2: type 3
        v44 = L2 + D4 * c3
        v45 = v38 * v44
        v47 = t34 * v44

        # theta4: type 2
        v50 = T[0, 2] * s1 - T[1, 2] * c1
        v51 = T[0, 2] * c1 + T[1, 2] * s1
        v52 = v51 * v51

        # theta6: type 3
        v55 = T[0, 1] * c1 + T[1, 1] * s1
        v56 = T[0, 1] * s1 - T[1, 1] * c1
        v58 = T[0, 0] * c1 + T[1, 0] * s1
        v59 = T[0, 0] * s1 - T[1, 0] * c1

        for i2 in range(2):  # down, up
            e2 = 1.0 - 2.0 * i2
            # theta3: type 8
            if e2 < 0.0 and not apart3:
                continue
            s3 = w3 * e2 * k6
            q3 = math.atan2(s3, c3)

            # theta2: type 3
            v43 = D4 * s3
            v46 = t34 * v43 + v45
            v48 = v47 - v38 * v43
            w2 = math.sqrt(v46 * v46 + v48 * v48)
            free2 = w2 <= free_square_tolerance2
            v49 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else v48 * v49
            s2 = math.sin(seed[1]) if free2 else -(v46 * v49)
            q2 = math.atan2(s2, c2)

            # theta4: type 2
            c23 = c3 * c2 - s3 * s2
            s23 = c3 * s2 + s3 * c2
            X4 = c23 * v50 - T[2, 2] * s23
            w4 = math.sqrt(X4 * X4 + v52)
            free4 = w4 <= free_tolerance
            v53 = 1.0 if free4 else w4

            # theta5: type 3
            c5 = T[2, 2] * c23 + s23 * v50

            # theta6: type 3
            v57 = T[2, 1] * s23 - c23 * v56
            v60 = T[2, 0] * s23 - c23 * v59

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4: type 2
                if e3 < 0.0 and free4:
                    continue
                v54 = e3 / v53
                c4 = math.cos(seed[3]) if free4 else -(X4 * v54)
                s4 = math.sin(seed[3]) if free4 else -(v51 * v54)
                q4 = math.atan2(s4, c4)

                # theta5: type 3
                q5 = math.atan2(-(w4 * e3), c5)

                # theta6: type 3
                c6 = c4 * v58 + s4 * v60
                q6 = math.atan2(-(c4 * v55 + s4 * v57), c6)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0] = q1
                q[row, 1] = q2
                q[row, 2] = q3
                q[row, 3] = q4
                q[row, 4] = q5
                q[row, 5] = q6
                status[row] = FREE_JOINT if free1 or free2 or free4 else OK


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
    """All rows into q (8, 6) and status (8,); how many are OK or FREE_JOINT."""
    fit = _fit(T)
    for row in range(8):
        status[row] = UNREACHABLE if fit else INVALID_POSE
        for i in range(6):
            q[row, i] = math.nan
    if not fit:
        return 0
    pose = T if fit == 1 else _straightened(T)
    _solve(pose, seed, q, status)
    count = 0
    for row in range(8):
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
        q: Filled with joint values (8, 6), NaN where there is no solution; float64.
        status: Filled with what each row holds (8,); uint8.
        q_seed: Values for joints that are indeterminate (6,).

    Returns:
        How many rows are OK or FREE_JOINT.
    """
    return _ik(T, q_seed, q, status)


def ik_all(T, q_seed=None):
    """All solutions: q (8, 6) and status (8,); row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (6,); zeros without it.
    """
    q = np.empty((8, 6))
    status = np.empty(8, np.uint8)
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
    rows = range(8) if branch is None else [_row(branch)]
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
    """ik_all for N poses (N, 4, 4) on all cores: q (N, 8, 6) and status (N, 8)."""
    T = np.ascontiguousarray(T, np.float64)
    if T.ndim != 3 or T.shape[1:] != (4, 4):
        raise ValueError(f"T must have shape (N, 4, 4), not {T.shape}")
    q = np.empty((len(T), 8, 6))
    status = np.empty((len(T), 8), np.uint8)
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
