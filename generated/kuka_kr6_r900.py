"""kuka_kr6_r900: KUKA KR 6 R900.

Inverse kinematics, generated from robots/kuka_kr6_r900.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kuka_kr6_r900.yaml. The formulas and where they come from: kuka_kr6_r900.md.

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


NAME = "kuka_kr6_r900"
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

d6 = 0.09  # joint offset 6
free_tolerance1 = 1.4150000000000001e-12  # a vector this short fixes no angle [length]
d1 = 0.4  # joint offset 1
a1 = 0.025  # link length 1
a2 = 0.455  # link length 2
d4 = 0.42  # joint offset 4
k2 = 0.3822  # 2 * (d4 * a2)
a3 = 0.025  # link length 3
k4 = 0.022750000000000003  # 2 * (a3 * a2)
k9 = 0.38405  # (a2 * a2) + ((a3 * a3) + (d4 * d4))
longest2 = 0.766926484652688  # square of the longest reach
shortest2 = 0.0011735153473120417  # square of the shortest reach
longest2_reach = 0.7669264846529359  # the same, longest by rounding
shortest2_reach = 0.0011735153473023472  # the same, shortest by rounding
longest2_apart = 0.7669264846526632  # the same, longest for merging
shortest2_apart = 0.001173515347313011  # the same, shortest for merging
k13 = 6.821542862115762  # 1 / (((2 * (d4 * a2)) * (2 * (d4 * a2))) + ((2 * (a3 * a2)) * (2 * (a3 * a2))))
free_square_tolerance2 = 2.0022250000000003e-24  # the same, squared [length^2]
offset2 = -1.5707963267948966  # offset of joint 2
free_tolerance = 1e-12  # a vector this short fixes no angle
offset3 = -1.5707963267948966  # offset of joint 3
offset5 = 3.141592653589793  # offset of joint 5

_TURN = 6.283185307179586
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])  # of squared differences: lengths by arm size
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
    v23 = q[1] + offset2
    c2 = math.cos(v23)
    s2 = math.sin(v23)
    v24 = c1 * c2
    v25 = s1 * c2
    v26 = c1 * s2
    v27 = s1 * s2
    v28 = q[2] + offset3
    c3 = math.cos(v28)
    s3 = math.sin(v28)
    v29 = v24 * c3 - v26 * s3
    v30 = v25 * c3 - v27 * s3
    v31 = s2 * c3 + c2 * s3
    v32 = v26 * c3 + v24 * s3
    v33 = v27 * c3 + v25 * s3
    v34 = s2 * s3 - c2 * c3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    v35 = v29 * c4 + s1 * s4
    v36 = v30 * c4 - c1 * s4
    v37 = v31 * c4
    v38 = c1 * c4 + v30 * s4
    v39 = v31 * s4
    v40 = v29 * s4 - s1 * c4
    v41 = q[4] + offset5
    c5 = math.cos(v41)
    s5 = math.sin(v41)
    v42 = v35 * c5 - v32 * s5
    v43 = v36 * c5 - v33 * s5
    v44 = v34 * s5 - v37 * c5
    T13 = v32 * c5 + v35 * s5
    T23 = v33 * c5 + v36 * s5
    v45 = v34 * c5 + v37 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T11 = v42 * c6 + v40 * s6
    T21 = v43 * c6 + v38 * s6
    T31 = v44 * c6 - v39 * s6
    T12 = v40 * c6 - v42 * s6
    T22 = v38 * c6 - v43 * s6
    T14 = c1 * a1 + v24 * a2 + v29 * a3 - v32 * d4 + T13 * d6
    T24 = s1 * a1 + v25 * a2 + v30 * a3 - v33 * d4 + T23 * d6
    T34 = d1 - s2 * a2 - v31 * a3 + v34 * d4 - v45 * d6
    T[0, 0] = T11
    T[0, 1] = T12
    T[0, 2] = T13
    T[0, 3] = T14
    T[1, 0] = T21
    T[1, 1] = T22
    T[1, 2] = T23
    T[1, 3] = T24
    T[2, 0] = T31
    T[2, 1] = -(v39 * c6 + v44 * s6)
    T[2, 2] = -v45
    T[2, 3] = T34
    T[3, 3] = 1.0
    return T


@njit(cache=True, error_model="numpy")
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = np.zeros((6, 6))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    v29 = c1 * a1
    v30 = s1 * a1
    v31 = q[1] + offset2
    c2 = math.cos(v31)
    s2 = math.sin(v31)
    v32 = c1 * c2
    v33 = s1 * c2
    v34 = c1 * s2
    v35 = s1 * s2
    v36 = v29 + v32 * a2
    v37 = v30 + v33 * a2
    v38 = d1 - s2 * a2
    v39 = q[2] + offset3
    c3 = math.cos(v39)
    s3 = math.sin(v39)
    v40 = v32 * c3 - v34 * s3
    v41 = v33 * c3 - v35 * s3
    v42 = s2 * c3 + c2 * s3
    v43 = v34 * c3 + v32 * s3
    v44 = v35 * c3 + v33 * s3
    J64 = s2 * s3 - c2 * c3
    v45 = v36 + v40 * a3
    v46 = v37 + v41 * a3
    v47 = v38 - v42 * a3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    J55 = c1 * c4 + v41 * s4
    v48 = v42 * s4
    v49 = v45 - v43 * d4
    v50 = v46 - v44 * d4
    v51 = v47 + J64 * d4
    J45 = v40 * s4 - s1 * c4
    v52 = q[4] + offset5
    c5 = math.cos(v52)
    s5 = math.sin(v52)
    J46 = v43 * c5 + (v40 * c4 + s1 * s4) * s5
    J56 = v44 * c5 + (v41 * c4 - c1 * s4) * s5
    v53 = J64 * c5 + v42 * c4 * s5
    J21 = v49 + J46 * d6
    v54 = v50 + J56 * d6
    v55 = v51 - v53 * d6
    v56 = v55 - d1
    J12 = c1 * v56
    J22 = s1 * v56
    v57 = v55 - v38
    J13 = c1 * v57
    J23 = s1 * v57
    v58 = J21 - v45
    v59 = v54 - v46
    v60 = v55 - v47
    J24 = J64 * v58 + v43 * v60
    J34 = v44 * v58 - v43 * v59
    v61 = J21 - v49
    v62 = v54 - v50
    v63 = v55 - v51
    J15 = J55 * v63 + v48 * v62
    J35 = J45 * v62 - J55 * v61
    J16 = J56 * v63 + v53 * v62
    J36 = J46 * v62 - J56 * v61
    J[0, 0] = -v54
    J[0, 1] = J12
    J[0, 2] = J13
    J[0, 3] = -(v44 * v60 + J64 * v59)
    J[0, 4] = J15
    J[0, 5] = J16
    J[1, 0] = J21
    J[1, 1] = J22
    J[1, 2] = J23
    J[1, 3] = J24
    J[1, 4] = -(v48 * v61 + J45 * v63)
    J[1, 5] = -(v53 * v61 + J46 * v63)
    J[2, 1] = -(s1 * (v54 - v30) + c1 * (J21 - v29))
    J[2, 2] = -(s1 * (v54 - v37) + c1 * (J21 - v36))
    J[2, 3] = J34
    J[2, 4] = J35
    J[2, 5] = J36
    J[3, 1] = -s1
    J[3, 2] = -s1
    J[3, 3] = -v43
    J[3, 4] = J45
    J[3, 5] = J46
    J[4, 1] = c1
    J[4, 2] = c1
    J[4, 3] = -v44
    J[4, 4] = J55
    J[4, 5] = J56
    J[5, 0] = 1.0
    J[5, 3] = J64
    J[5, 4] = -v48
    J[5, 5] = -v53
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
    v38 = 1.0 if free1 else w1

    # theta3: type 6
    wz = T[2, 3] - d6 * T[2, 2]
    v40 = wz - d1
    v42 = v40 * v40

    # theta2: type 3
    v51 = seed[1] + offset2

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1: type 2
        if e1 < 0.0 and free1:
            continue
        v39 = e1 / v38
        c1 = math.cos(seed[0]) if free1 else -(wx * v39)
        s1 = math.sin(seed[0]) if free1 else Y1 * v39
        q1 = math.atan2(s1, c1)

        # theta3: type 6
        v41 = w1 * e1 + a1
        N3 = v42 + v41 * v41
        K3 = N3 - k9
        D3 = (longest2 - N3) * (N3 - shortest2)
        apart3 = shortest2_apart < N3 and N3 < longest2_apart
        if not (shortest2_reach <= N3 and N3 <= longest2_reach):
            continue
        w3 = math.sqrt(D3 if apart3 else 0.0)
        v44 = k2 * K3
        v45 = k4 * K3

        # theta4: type 2
        v52 = T[0, 2] * c1 + T[1, 2] * s1
        Y4 = T[0, 2] * s1 - T[1, 2] * c1
        v53 = Y4 * Y4

        # theta6: type 3
        v56 = T[1, 1] * c1 - T[0, 1] * s1
        v57 = T[0, 1] * c1 + T[1, 1] * s1
        v59 = T[1, 0] * c1 - T[0, 0] * s1
        v60 = T[0, 0] * c1 + T[1, 0] * s1

        for i2 in range(2):  # down, up
            e2 = 1.0 - 2.0 * i2
            # theta3: type 6
            if e2 < 0.0 and not apart3:
                continue
            v43 = w3 * e2
            s3 = (k4 * v43 - v44) * k13
            c3 = k13 * (v45 + k2 * v43)

            # theta2: type 3
            v46 = d4 * c3 + a3 * s3
            v47 = a2 + (a3 * c3 - d4 * s3)
            v48 = v41 * v46 - v40 * v47
            v49 = v40 * v46 + v41 * v47
            w2 = math.sqrt(v48 * v48 + v49 * v49)
            free2 = w2 <= free_square_tolerance2
            v50 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v51) if free2 else -(v49 * v50)
            s2 = math.sin(v51) if free2 else v48 * v50

            # theta4: type 2
            c23 = c3 * c2 - s3 * s2
            s23 = c3 * s2 + s3 * c2
            X4 = T[2, 2] * s23 - c23 * v52
            w4 = math.sqrt(X4 * X4 + v53)
            free4 = w4 <= free_tolerance
            v54 = 1.0 if free4 else w4

            # theta5: type 3
            c5 = T[2, 2] * c23 + s23 * v52

            # theta6: type 3
            v58 = c23 * v57 - T[2, 1] * s23
            v61 = c23 * v60 - T[2, 0] * s23

            # joint values
            q2 = wrap(math.atan2(s2, c2) - offset2)
            q3 = wrap(math.atan2(s3, c3) - offset3)

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4: type 2
                if e3 < 0.0 and free4:
                    continue
                v55 = e3 / v54
                c4 = math.cos(seed[3]) if free4 else -(X4 * v55)
                s4 = math.sin(seed[3]) if free4 else Y4 * v55
                q4 = math.atan2(s4, c4)
                s5 = w4 * e3

                # theta6: type 3
                c6 = c4 * v56 + s4 * v58
                s6 = c4 * v59 + s4 * v61
                q6 = math.atan2(s6, c6)

                # joint values
                q5 = wrap(math.atan2(s5, c5) - offset5)
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
