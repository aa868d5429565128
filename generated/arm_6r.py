"""arm_6r: Arm with six revolute joints and a spherical wrist.

Inverse kinematics, generated from robots/arm_6r.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/arm_6r.yaml. The formulas and where they come from: arm_6r.md.

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


NAME = "arm_6r"
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

d6 = 0.1  # joint offset 6
free_tolerance1 = 1.25e-12  # a vector this short fixes no angle [length]
d1 = 0.4  # joint offset 1
a2 = 0.4  # link length 2
d4 = 0.35  # joint offset 4
k2 = 0.27999999999999997  # 2 * (d4 * a2)
k5 = 0.28250000000000003  # (a2 * a2) + (d4 * d4)
longest2 = 0.5625  # square of the longest reach
shortest2 = 0.0025000000000000044  # square of the shortest reach
longest2_reach = 0.5625000000001875  # the same, longest by rounding
shortest2_reach = 0.002499999999987505  # the same, shortest by rounding
longest2_apart = 0.5624999999999812  # the same, longest for merging
shortest2_apart = 0.0025000000000012543  # the same, shortest for merging
k7 = 12.755102040816327  # 1 / ((2 * (d4 * a2)) * (2 * (d4 * a2)))
free_square_tolerance2 = 1.5624999999999999e-24  # the same, squared [length^2]
free_tolerance = 1e-12  # a vector this short fixes no angle

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
    v22 = c1 * c2
    v23 = s1 * c2
    v24 = c1 * s2
    v25 = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    v26 = v22 * c3 - v24 * s3
    v27 = v23 * c3 - v25 * s3
    v28 = s2 * c3 + c2 * s3
    v29 = v24 * c3 + v22 * s3
    v30 = v25 * c3 + v23 * s3
    v31 = s2 * s3 - c2 * c3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    v32 = v26 * c4 + s1 * s4
    v33 = v27 * c4 - c1 * s4
    v34 = v28 * c4
    v35 = s1 * c4 - v26 * s4
    v36 = c1 * c4 + v27 * s4
    v37 = v28 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v38 = v32 * c5 - v29 * s5
    v39 = v33 * c5 - v30 * s5
    v40 = v31 * s5 - v34 * c5
    v41 = v29 * c5 + v32 * s5
    v42 = v30 * c5 + v33 * s5
    T33 = v31 * c5 + v34 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T11 = v38 * c6 + v35 * s6
    T21 = v39 * c6 - v36 * s6
    T31 = v40 * c6 + v37 * s6
    T12 = v35 * c6 - v38 * s6
    T32 = v37 * c6 - v40 * s6
    T14 = v22 * a2 - v29 * d4 - v41 * d6
    T24 = v23 * a2 - v30 * d4 - v42 * d6
    T34 = d1 - s2 * a2 + v31 * d4 + T33 * d6
    T[0, 0] = T11
    T[0, 1] = T12
    T[0, 2] = -v41
    T[0, 3] = T14
    T[1, 0] = T21
    T[1, 1] = -(v36 * c6 + v39 * s6)
    T[1, 2] = -v42
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
    v29 = c1 * c2
    v30 = s1 * c2
    v31 = c1 * s2
    v32 = s1 * s2
    v33 = v29 * a2
    v34 = v30 * a2
    v35 = d1 - s2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    v36 = v29 * c3 - v31 * s3
    v37 = v30 * c3 - v32 * s3
    v38 = s2 * c3 + c2 * s3
    v39 = v31 * c3 + v29 * s3
    v40 = v32 * c3 + v30 * s3
    J64 = s2 * s3 - c2 * c3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    J55 = c1 * c4 + v37 * s4
    v41 = v38 * s4
    v42 = v33 - v39 * d4
    v43 = v34 - v40 * d4
    v44 = v35 + J64 * d4
    J45 = v36 * s4 - s1 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v45 = v39 * c5 + (v36 * c4 + s1 * s4) * s5
    v46 = v40 * c5 + (v37 * c4 - c1 * s4) * s5
    J66 = J64 * c5 + v38 * c4 * s5
    J21 = v42 - v45 * d6
    v47 = v46 * d6
    v48 = v43 - v47
    v49 = v44 + J66 * d6
    J11 = v47 - v43
    v50 = v49 - d1
    J12 = c1 * v50
    J22 = s1 * v50
    v51 = J21 - v33
    v52 = v48 - v34
    v53 = v49 - v35
    J13 = c1 * v53
    J23 = s1 * v53
    J24 = J64 * v51 + v39 * v53
    J34 = v40 * v51 - v39 * v52
    v54 = J21 - v42
    v55 = v48 - v43
    v56 = v49 - v44
    J15 = J55 * v56 + v41 * v55
    J35 = J45 * v55 - J55 * v54
    J26 = J66 * v54 + v45 * v56
    J36 = v46 * v54 - v45 * v55
    J[0, 0] = J11
    J[0, 1] = J12
    J[0, 2] = J13
    J[0, 3] = -(v40 * v53 + J64 * v52)
    J[0, 4] = J15
    J[0, 5] = -(v46 * v56 + J66 * v55)
    J[1, 0] = J21
    J[1, 1] = J22
    J[1, 2] = J23
    J[1, 3] = J24
    J[1, 4] = -(v41 * v54 + J45 * v56)
    J[1, 5] = J26
    J[2, 1] = -(s1 * v48 + c1 * J21)
    J[2, 2] = -(s1 * v52 + c1 * v51)
    J[2, 3] = J34
    J[2, 4] = J35
    J[2, 5] = J36
    J[3, 1] = -s1
    J[3, 2] = -s1
    J[3, 3] = -v39
    J[3, 4] = J45
    J[3, 5] = -v45
    J[4, 1] = c1
    J[4, 2] = c1
    J[4, 3] = -v40
    J[4, 4] = J55
    J[4, 5] = -v46
    J[5, 0] = 1.0
    J[5, 3] = J64
    J[5, 4] = -v41
    J[5, 5] = J66
    return J


@njit(cache=True, error_model="numpy")
def _solve(T, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others.
    """

    # theta1: type 2
    wx = T[0, 3] - T[0, 2] * d6
    Y1 = d6 * T[1, 2] - T[1, 3]
    w1 = math.sqrt(wx * wx + Y1 * Y1)
    free1 = w1 <= free_tolerance1
    v33 = 1.0 if free1 else w1

    # theta3: type 8
    wz = T[2, 3] - d6 * T[2, 2]
    v36 = wz - d1
    v37 = v36 * v36

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1: type 2
        if e1 < 0.0 and free1:
            continue
        v34 = e1 / v33
        c1 = math.cos(seed[0]) if free1 else -(wx * v34)
        s1 = math.sin(seed[0]) if free1 else Y1 * v34
        q1 = math.atan2(s1, c1)
        v35 = w1 * e1

        # theta3: type 8
        N3 = v37 + v35 * v35
        K3 = N3 - k5
        D3 = (longest2 - N3) * (N3 - shortest2)
        apart3 = shortest2_apart < N3 and N3 < longest2_apart
        if not (shortest2_reach <= N3 and N3 <= longest2_reach):
            continue
        w3 = math.sqrt(D3 if apart3 else 0.0)
        v38 = k2 * K3 * k7

        # theta2: type 3
        v40 = a2 + d4 * v38
        v41 = v36 * v40
        v43 = v35 * v40

        # theta4: type 2
        v46 = T[0, 2] * c1 + T[1, 2] * s1
        Y4 = T[0, 2] * s1 - T[1, 2] * c1
        v47 = Y4 * Y4

        # theta6: type 3
        v50 = T[1, 1] * c1 - T[0, 1] * s1
        v51 = T[0, 1] * c1 + T[1, 1] * s1
        v53 = T[1, 0] * c1 - T[0, 0] * s1
        v54 = T[0, 0] * c1 + T[1, 0] * s1

        for i2 in range(2):  # down, up
            e2 = 1.0 - 2.0 * i2
            # theta3: type 8
            if e2 < 0.0 and not apart3:
                continue
            c3 = k7 * (k2 * (w3 * e2))
            q3 = math.atan2(-v38, c3)

            # theta2: type 3
            v39 = d4 * c3
            v42 = v35 * v39 - v41
            v44 = v36 * v39 + v43
            w2 = math.sqrt(v42 * v42 + v44 * v44)
            free2 = w2 <= free_square_tolerance2
            v45 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else -(v44 * v45)
            s2 = math.sin(seed[1]) if free2 else v42 * v45
            q2 = math.atan2(s2, c2)

            # theta4: type 2
            c23 = c3 * c2 + v38 * s2
            s23 = c3 * s2 - v38 * c2
            X4 = T[2, 2] * s23 - c23 * v46
            w4 = math.sqrt(X4 * X4 + v47)
            free4 = w4 <= free_tolerance
            v48 = 1.0 if free4 else w4

            # theta6: type 3
            v52 = c23 * v51 - T[2, 1] * s23
            v55 = c23 * v54 - T[2, 0] * s23

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4: type 2
                if e3 < 0.0 and free4:
                    continue
                v49 = e3 / v48
                c4 = math.cos(seed[3]) if free4 else -(X4 * v49)
                s4 = math.sin(seed[3]) if free4 else Y4 * v49
                q4 = math.atan2(s4, c4)

                # theta5: type 3
                q5 = math.atan2(-(w4 * e3), -(T[2, 2] * c23 + s23 * v46))

                # theta6: type 3
                q6 = math.atan2(-(c4 * v53 + s4 * v55), -(c4 * v50 + s4 * v52))
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
