"""wrist_zyz: Spherical wrist, axes z, y, z.

Inverse kinematics, generated from robots/wrist_zyz.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/wrist_zyz.yaml. The formulas and where they come from: wrist_zyz.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
orientation T[0:3, 0:3] counts; other entries are ignored.
"""

import math

import numpy as np

try:
    from numba import njit, prange
except ImportError:  # plain Python, only slower
    prange = range

    def njit(*_, **__):
        return lambda function: function


NAME = "wrist_zyz"
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

free_limit = 1e-12  # a length that fixes no angle

_TURN = 6.283185307179586
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0])
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
    x2_x = c1 * c2
    x2_y = s1 * c2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    T11_ = x2_x * c3 - s1 * s3
    T21_ = x2_y * c3 + c1 * s3
    T31_ = s2 * c3
    T22_ = c1 * c3 - x2_y * s3
    T[0, 0] = T11_
    T[0, 1] = -(s1 * c3 + x2_x * s3)
    T[0, 2] = -(c1 * s2)
    T[1, 0] = T21_
    T[1, 1] = T22_
    T[1, 2] = -(s1 * s2)
    T[2, 0] = T31_
    T[2, 1] = -(s2 * s3)
    T[2, 2] = c2
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
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    J[3, 1] = s1
    J[3, 2] = -(c1 * s2)
    J[4, 1] = -c1
    J[4, 2] = -(s1 * s2)
    J[5, 0] = 1.0
    J[5, 2] = c2
    return J


@njit(cache=True, error_model="numpy")
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, _, T21, T22, T23, _, _, _, T33, _ = pose

    # theta1, type 2: U1[3, 3]
    w1 = math.sqrt(T13 * T13 + T23 * T23)
    free1 = w1 <= free_limit
    divisor1 = 1.0 if free1 else w1

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else T13 * factor1
        s1 = math.sin(seed[0]) if free1 else T23 * factor1
        q1 = math.atan2(s1, c1)

        # theta2, type 3: U1[2, 3] and U1[1, 3]
        q2 = math.atan2(-(w1 * e1), T33)

        # theta3, type 3: U1[3, 2] and U1[3, 1]
        s3 = T21 * c1 - T11 * s1
        c3 = T22 * c1 - T12 * s1
        q3 = math.atan2(s3, c3)
        row = i1
        q[row, 0] = q1
        q[row, 1] = q2
        q[row, 2] = q3
        status[row] = FREE_JOINT if free1 else OK


@njit(cache=True, error_model="numpy")
def _misfit(T):
    """How far the rotation part is from orthonormal and right-handed, as a sum of squares."""
    xx = T[0, 0] * T[0, 0] + T[0, 1] * T[0, 1] + T[0, 2] * T[0, 2] - 1.0
    yy = T[1, 0] * T[1, 0] + T[1, 1] * T[1, 1] + T[1, 2] * T[1, 2] - 1.0
    xy = T[0, 0] * T[1, 0] + T[0, 1] * T[1, 1] + T[0, 2] * T[1, 2]
    z0 = T[0, 1] * T[1, 2] - T[0, 2] * T[1, 1] - T[2, 0]
    z1 = T[0, 2] * T[1, 0] - T[0, 0] * T[1, 2] - T[2, 1]
    z2 = T[0, 0] * T[1, 1] - T[0, 1] * T[1, 0] - T[2, 2]
    return xx * xx + yy * yy + 2.0 * xy * xy + z0 * z0 + z1 * z1 + z2 * z2


@njit(cache=True, error_model="numpy")
def _straightened(pose):
    """With the nearest rotation: R becomes (3 I - R R') R / 2, twice (Higham 1986)."""
    x0, x1, x2, px, y0, y1, y2, py, z0, z1, z2, pz = pose
    for _ in range(2):
        xx = 1.5 - 0.5 * (x0 * x0 + x1 * x1 + x2 * x2)
        yy = 1.5 - 0.5 * (y0 * y0 + y1 * y1 + y2 * y2)
        zz = 1.5 - 0.5 * (z0 * z0 + z1 * z1 + z2 * z2)
        xy = -0.5 * (x0 * y0 + x1 * y1 + x2 * y2)
        xz = -0.5 * (x0 * z0 + x1 * z1 + x2 * z2)
        yz = -0.5 * (y0 * z0 + y1 * z1 + y2 * z2)
        x0, y0, z0 = (
            xx * x0 + xy * y0 + xz * z0,
            xy * x0 + yy * y0 + yz * z0,
            xz * x0 + yz * y0 + zz * z0,
        )
        x1, y1, z1 = (
            xx * x1 + xy * y1 + xz * z1,
            xy * x1 + yy * y1 + yz * z1,
            xz * x1 + yz * y1 + zz * z1,
        )
        x2, y2, z2 = (
            xx * x2 + xy * y2 + xz * z2,
            xy * x2 + yy * y2 + yz * z2,
            xz * x2 + yz * y2 + zz * z2,
        )
    return x0, x1, x2, px, y0, y1, y2, py, z0, z1, z2, pz


@njit(cache=True, error_model="numpy")
def _is_pose(T):
    """Whether the entries that count make a pose."""
    return _misfit(T) <= 1e-09


@njit(cache=True, error_model="numpy")
def _read(T):
    """The upper three rows, with the nearest rotation where a pose is only rounded."""
    pose = (
        T[0, 0], T[0, 1], T[0, 2], T[0, 3],
        T[1, 0], T[1, 1], T[1, 2], T[1, 3],
        T[2, 0], T[2, 1], T[2, 2], T[2, 3],
    )
    if _misfit(T) > 1e-24:
        return _straightened(pose)
    return pose


@njit(cache=True, error_model="numpy")
def _turned(joint, given, towards):
    """A joint value moved by whole turns, near to another value but inside its limits."""
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
        raise ValueError("T is no pose: not finite, or not a right-handed rotation")
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
    return value + _TURN * math.floor((towards - value) / _TURN + 0.5)
