"""puma560: Unimation PUMA 560.

Inverse kinematics, generated from robots/puma560.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/puma560.yaml. The formulas and where they come from: puma560.md.

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


NAME = "puma560"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_LIMITS = (
    (-2.792526803190927, 2.792526803190927),
    (-1.9198621771937625, 1.9198621771937625),
    (-2.356194490192345, 2.356194490192345),
    (-4.642575810304916, 4.642575810304916),
    (-1.7453292519943295, 1.7453292519943295),
    (-4.642575810304916, 4.642575810304916),
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

d3 = 0.15005  # joint offset 3
k1 = 0.022515002499999996  # d3 * d3
free_square_tolerance2 = 2.9096854084e-24  # the same, squared [length^2]
reach_tolerance1 = 1.7057800000000002e-13  # rounding at the boundary of the workspace [length]
merge_tolerance1 = 1.70578e-14  # two branches nearer than this are one [length]
d1 = 0.67183  # joint offset 1
a2 = 0.4318  # link length 2
d4 = 0.4318  # joint offset 4
k3 = 0.37290248000000004  # 2 * (d4 * a2)
a3 = 0.0203  # link length 3
k5 = 0.01753108  # 2 * (a3 * a2)
k8 = 0.37331457  # (d4 * a2) + ((a3 * a3) + (d4 * a2))
longest2 = 0.7466289125534531  # square of the longest reach
shortest2 = 2.274465470660925e-07  # square of the shortest reach
longest2_reach = 0.7466289125537477  # the same, longest by rounding
shortest2_reach = 2.2744654690339056e-07  # the same, shortest by rounding
longest2_apart = 0.7466289125534236  # the same, longest for merging
shortest2_apart = 2.2744654708236271e-07  # the same, shortest for merging
k12 = 7.175474885806929  # 1 / (((2 * (d4 * a2)) * (2 * (d4 * a2))) + ((2 * (a3 * a2)) * (2 * (a3 * a2))))
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
    v21 = c1 * c2
    v22 = s1 * c2
    v23 = c1 * s2
    v24 = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    v25 = v21 * c3 - v23 * s3
    v26 = v22 * c3 - v24 * s3
    v27 = s2 * c3 + c2 * s3
    v28 = v23 * c3 + v21 * s3
    v29 = v24 * c3 + v22 * s3
    v30 = c2 * c3 - s2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    v31 = v25 * c4 - s1 * s4
    v32 = v26 * c4 + c1 * s4
    v33 = v27 * c4
    v34 = s1 * c4 + v25 * s4
    v35 = c1 * c4 - v26 * s4
    v36 = v27 * s4
    T14 = v21 * a2 + v25 * a3 + s1 * d3 - v28 * d4
    T24 = v22 * a2 + v26 * a3 - c1 * d3 - v29 * d4
    T34 = d1 + s2 * a2 + v27 * a3 + v30 * d4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v37 = v31 * c5 - v28 * s5
    v38 = v32 * c5 - v29 * s5
    v39 = v33 * c5 + v30 * s5
    T33 = v30 * c5 - v33 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T11 = v37 * c6 - v34 * s6
    T21 = v38 * c6 + v35 * s6
    T31 = v39 * c6 - v36 * s6
    T22 = v35 * c6 - v38 * s6
    T[0, 0] = T11
    T[0, 1] = -(v34 * c6 + v37 * s6)
    T[0, 2] = -(v28 * c5 + v31 * s5)
    T[0, 3] = T14
    T[1, 0] = T21
    T[1, 1] = T22
    T[1, 2] = -(v29 * c5 + v32 * s5)
    T[1, 3] = T24
    T[2, 0] = T31
    T[2, 1] = -(v36 * c6 + v39 * s6)
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
    v24 = c1 * c2
    v25 = s1 * c2
    v26 = c1 * s2
    v27 = s1 * s2
    v28 = v24 * a2
    v29 = v25 * a2
    v30 = d1 + s2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    v31 = v24 * c3 - v26 * s3
    v32 = v25 * c3 - v27 * s3
    v33 = s2 * c3 + c2 * s3
    v34 = v26 * c3 + v24 * s3
    v35 = v27 * c3 + v25 * s3
    J64 = c2 * c3 - s2 * s3
    v36 = v30 + v33 * a3
    v37 = v28 + v31 * a3 + s1 * d3
    v38 = v29 + v32 * a3 - c1 * d3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    J45 = s1 * c4 + v31 * s4
    J65 = v33 * s4
    J21 = v37 - v34 * d4
    v39 = v35 * d4
    v40 = v38 - v39
    v41 = v36 + J64 * d4
    J55 = v32 * s4 - c1 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    J66 = J64 * c5 - v33 * c4 * s5
    J11 = v39 - v38
    v42 = v41 - d1
    J32 = s1 * v40 + c1 * J21
    v43 = v41 - v30
    J33 = s1 * (v40 - v29) + c1 * (J21 - v28)
    v44 = J21 - v37
    v45 = v40 - v38
    v46 = v41 - v36
    J24 = J64 * v44 + v34 * v46
    J34 = v35 * v44 - v34 * v45
    J[0, 0] = J11
    J[0, 1] = -(c1 * v42)
    J[0, 2] = -(c1 * v43)
    J[0, 3] = -(v35 * v46 + J64 * v45)
    J[1, 0] = J21
    J[1, 1] = -(s1 * v42)
    J[1, 2] = -(s1 * v43)
    J[1, 3] = J24
    J[2, 1] = J32
    J[2, 2] = J33
    J[2, 3] = J34
    J[3, 1] = s1
    J[3, 2] = s1
    J[3, 3] = -v34
    J[3, 4] = J45
    J[3, 5] = -(v34 * c5 + (v31 * c4 - s1 * s4) * s5)
    J[4, 1] = -c1
    J[4, 2] = -c1
    J[4, 3] = -v35
    J[4, 4] = J55
    J[4, 5] = -(v35 * c5 + (v32 * c4 + c1 * s4) * s5)
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
    N1 = T[0, 3] * T[0, 3] + T[1, 3] * T[1, 3]
    D1 = N1 - k1
    free1 = N1 <= free_square_tolerance2
    v33 = 2.0 * abs(-d3)
    apart1 = merge_tolerance1 * (v33 + merge_tolerance1) < D1
    if not (-(reach_tolerance1 * (v33 + reach_tolerance1)) <= D1):
        return
    w1 = math.sqrt(D1 if apart1 else 0.0)
    v35 = 1.0 / (1.0 if free1 else N1)
    v36 = T[0, 3] * d3
    v37 = T[1, 3] * d3

    # theta3: type 6
    v38 = T[2, 3] - d1
    v39 = v38 * v38

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1: type 2
        if e1 < 0.0 and (free1 or not apart1):
            continue
        v34 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else v35 * (T[0, 3] * v34 - v37)
        s1 = math.sin(seed[0]) if free1 else v35 * (v36 + T[1, 3] * v34)
        q1 = math.atan2(s1, c1)

        # theta3: type 6
        N3 = v39 + v34 * v34
        K3 = N3 - k8
        D3 = (longest2 - N3) * (N3 - shortest2)
        apart3 = shortest2_apart < N3 and N3 < longest2_apart
        if not (shortest2_reach <= N3 and N3 <= longest2_reach):
            continue
        w3 = math.sqrt(D3 if apart3 else 0.0)
        v41 = k3 * K3
        v42 = k5 * K3

        # theta4: type 2
        v48 = T[0, 2] * c1 + T[1, 2] * s1
        Y4 = T[1, 2] * c1 - T[0, 2] * s1
        v50 = Y4 * Y4

        # theta6: type 3
        v53 = T[0, 1] * s1 - T[1, 1] * c1
        v54 = T[0, 1] * c1 + T[1, 1] * s1
        v56 = T[0, 0] * s1 - T[1, 0] * c1
        v57 = T[0, 0] * c1 + T[1, 0] * s1

        for i2 in range(2):  # down, up
            e2 = 1.0 - 2.0 * i2
            # theta3: type 6
            if e2 < 0.0 and not apart3:
                continue
            v40 = w3 * e2
            s3 = (k5 * v40 - v41) * k12
            c3 = k12 * (v42 + k3 * v40)
            q3 = math.atan2(s3, c3)

            # theta2: type 3
            v43 = a2 + (a3 * c3 - d4 * s3)
            v44 = d4 * c3 + a3 * s3
            v45 = v38 * v43 - v34 * v44
            v46 = v34 * v43 + v38 * v44
            w2 = math.sqrt(v45 * v45 + v46 * v46)
            free2 = w2 <= free_square_tolerance2
            v47 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else v46 * v47
            s2 = math.sin(seed[1]) if free2 else v45 * v47
            q2 = math.atan2(s2, c2)

            # theta4: type 2
            c23 = c3 * c2 - s3 * s2
            s23 = c3 * s2 + s3 * c2
            v49 = c23 * v48 + T[2, 2] * s23
            w4 = math.sqrt(v49 * v49 + v50)
            free4 = w4 <= free_tolerance
            v51 = 1.0 if free4 else w4

            # theta5: type 3
            c5 = T[2, 2] * c23 - s23 * v48

            # theta6: type 3
            v55 = c23 * v54 + T[2, 1] * s23
            v58 = c23 * v57 + T[2, 0] * s23

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4: type 2
                if e3 < 0.0 and free4:
                    continue
                v52 = e3 / v51
                c4 = math.cos(seed[3]) if free4 else v49 * v52
                s4 = math.sin(seed[3]) if free4 else Y4 * v52
                q4 = math.atan2(s4, c4)

                # theta5: type 3
                q5 = math.atan2(-(w4 * e3), c5)

                # theta6: type 3
                q6 = math.atan2(-(c4 * v56 + s4 * v58), -(c4 * v53 + s4 * v55))
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
