"""stanford: Stanford arm.

Inverse kinematics, generated from robots/stanford.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/stanford.yaml. The formulas and where they come from: stanford.md.

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


NAME = "stanford"
DOF = 6
JOINT_TYPES = "RRPRRR"
JOINT_LIMITS = (
    (-2.9670597283903604, 2.9670597283903604),
    (-2.9670597283903604, 2.9670597283903604),
    (0.3048, 1.27),
    (-2.9670597283903604, 2.9670597283903604),
    (-1.5707963267948966, 1.5707963267948966),
    (-2.9670597283903604, 2.9670597283903604),
)
BRANCHES = (
    "left-forward-noflip",
    "left-forward-flip",
    "left-backward-noflip",
    "left-backward-flip",
    "right-forward-noflip",
    "right-forward-flip",
    "right-backward-noflip",
    "right-backward-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose

k1 = 0.13369999999999999  # d2 - a3
k2 = 0.01787569  # (d2 - a3) * (d2 - a3)
free_square_tolerance2 = 3.4374768999999993e-25  # the same, squared [length^2]
reach_tolerance1 = 5.863e-14  # rounding at the boundary of the workspace [length]
merge_tolerance1 = 5.862999999999999e-15  # two branches nearer than this are one [length]
d1 = 0.412  # joint offset 1
free_tolerance1 = 5.862999999999999e-13  # a vector this short fixes no angle [length]
free_tolerance = 1e-12  # a vector this short fixes no angle
d2 = 0.154  # joint offset 2
a3 = 0.0203  # link length 3

_TURN = 6.283185307179586
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
_WEIGHT = np.array([1.0, 1.0, 2.9091104583131893, 1.0, 1.0, 1.0])  # of squared differences: lengths by arm size
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
    T34 = d1 + c2 * q[2]
    T14 = v24 * q[2] - s1 * d2 + s1 * a3
    T24 = c1 * d2 + v25 * q[2] - c1 * a3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    v26 = s1 * c4 + v22 * s4
    v27 = v23 * s4 - c1 * c4
    v28 = s2 * s4
    v29 = v22 * c4 - s1 * s4
    v30 = v23 * c4 + c1 * s4
    v31 = s2 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v32 = v26 * c5 - v24 * s5
    v33 = v27 * c5 - v25 * s5
    v34 = v28 * c5 + c2 * s5
    T13 = v24 * c5 + v26 * s5
    T23 = v25 * c5 + v27 * s5
    T33 = c2 * c5 - v28 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T11 = v32 * c6 + v29 * s6
    T21 = v33 * c6 + v30 * s6
    T12 = v29 * c6 - v32 * s6
    T22 = v30 * c6 - v33 * s6
    T32 = v34 * s6 - v31 * c6
    T[0, 0] = T11
    T[0, 1] = T12
    T[0, 2] = T13
    T[0, 3] = T14
    T[1, 0] = T21
    T[1, 1] = T22
    T[1, 2] = T23
    T[1, 3] = T24
    T[2, 0] = -(v34 * c6 + v31 * s6)
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
    v22 = c1 * c2
    v23 = s1 * c2
    J13 = c1 * s2
    J23 = s1 * s2
    v24 = c1 * d2 + J23 * q[2]
    J21 = J13 * q[2] - s1 * d2 + s1 * a3
    v25 = c1 * a3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    J45 = v22 * c4 - s1 * s4
    J55 = v23 * c4 + c1 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    J46 = J13 * c5 + (s1 * c4 + v22 * s4) * s5
    J56 = J23 * c5 + (v23 * s4 - c1 * c4) * s5
    J66 = c2 * c5 - s2 * s4 * s5
    J11 = v25 - v24
    v26 = d1 + c2 * q[2] - d1
    J12 = c1 * v26
    J22 = s1 * v26
    J[0, 0] = J11
    J[0, 1] = J12
    J[0, 2] = J13
    J[1, 0] = J21
    J[1, 1] = J22
    J[1, 2] = J23
    J[2, 1] = -(s1 * (v24 - v25) + c1 * J21)
    J[2, 2] = c2
    J[3, 1] = -s1
    J[3, 3] = J13
    J[3, 4] = J45
    J[3, 5] = J46
    J[4, 1] = c1
    J[4, 3] = J23
    J[4, 4] = J55
    J[4, 5] = J56
    J[5, 0] = 1.0
    J[5, 3] = c2
    J[5, 4] = -(s2 * c4)
    J[5, 5] = J66
    return J


@njit(cache=True, error_model="numpy")
def _solve(T, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others.
    """

    # theta1: type 2
    N1 = T[0, 3] * T[0, 3] + T[1, 3] * T[1, 3]
    D1 = N1 - k2
    free1 = N1 <= free_square_tolerance2
    v27 = 2.0 * abs(-k1)
    apart1 = merge_tolerance1 * (v27 + merge_tolerance1) < D1
    if not (-(reach_tolerance1 * (v27 + reach_tolerance1)) <= D1):
        return
    w1 = math.sqrt(D1 if apart1 else 0.0)
    v29 = 1.0 / (1.0 if free1 else N1)
    v30 = T[0, 3] * k1
    v31 = T[1, 3] * k1

    # theta2, r3: type 4
    v32 = T[2, 3] - d1
    v33 = v32 * v32

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1: type 2
        if e1 < 0.0 and (free1 or not apart1):
            continue
        v28 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else v29 * (v31 - T[0, 3] * v28)
        s1 = math.sin(seed[0]) if free1 else -(v29 * (v30 + T[1, 3] * v28))
        q1 = math.atan2(s1, c1)

        # theta2, r3: type 4
        w3 = math.sqrt(v28 * v28 + v33)
        free2 = w3 <= free_tolerance1
        v34 = 1.0 if free2 else w3

        # theta4: type 2
        X4 = T[0, 2] * s1 - T[1, 2] * c1
        v36 = T[0, 2] * c1 + T[1, 2] * s1
        v37 = X4 * X4

        # theta6: type 3
        v40 = T[0, 1] * c1 + T[1, 1] * s1
        v42 = T[1, 1] * c1 - T[0, 1] * s1
        v43 = T[0, 0] * c1 + T[1, 0] * s1
        v45 = T[1, 0] * c1 - T[0, 0] * s1

        for i2 in range(2):  # forward, backward
            e2 = 1.0 - 2.0 * i2
            # theta2, r3: type 4
            if e2 < 0.0 and free2:
                continue
            v35 = e2 / v34
            c2 = math.cos(seed[1]) if free2 else v32 * v35
            s2 = math.sin(seed[1]) if free2 else -(v28 * v35)
            q2 = math.atan2(s2, c2)
            r3 = w3 * e2

            # theta4: type 2
            Y4 = T[2, 2] * s2 - c2 * v36
            w4 = math.sqrt(v37 + Y4 * Y4)
            free4 = w4 <= free_tolerance
            v38 = 1.0 if free4 else w4

            # theta5: type 3
            c5 = T[2, 2] * c2 + s2 * v36

            # theta6: type 3
            v41 = c2 * v40 - T[2, 1] * s2
            v44 = c2 * v43 - T[2, 0] * s2

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4: type 2
                if e3 < 0.0 and free4:
                    continue
                v39 = e3 / v38
                c4 = math.cos(seed[3]) if free4 else -(X4 * v39)
                s4 = math.sin(seed[3]) if free4 else Y4 * v39
                q4 = math.atan2(s4, c4)

                # theta5: type 3
                q5 = math.atan2(-(w4 * e3), c5)

                # theta6: type 3
                c6 = c4 * v41 + s4 * v42
                s6 = c4 * v44 + s4 * v45
                q6 = math.atan2(s6, c6)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0] = q1
                q[row, 1] = q2
                q[row, 2] = r3
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
