"""adept: Adept SCARA.

Inverse kinematics, generated from robots/adept.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/adept.yaml. The formulas and where they come from: adept.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in mm, angles in rad. Every entry of
a pose counts.
"""

import math

import numpy as np

try:
    from numba import njit, prange
except ImportError:  # plain Python, only slower
    prange = range

    def njit(*_, **__):
        return lambda function: function


NAME = "adept"
DOF = 3
JOINT_TYPES = "RRP"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "only",
)
MAX_SOLUTIONS = 1

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose

d1 = 1075.0  # joint offset 1 [mm]
l1 = 600.0  # link length 1 [mm]
l2 = 550.0  # link length 2 [mm]
zz = 500.0  # z of the base frame [mm]
ez = 175.0  # z of the tool frame [mm]
free_limit_squared = 1e-24  # square of a length that fixes no angle
free_limit_squared2 = 5.7599999999999994e-18  # square of a length that fixes no angle [mm^2]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 0.024  # a pose may be rounded by this [mm]

_TURN = 6.283185307179586
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.7361111111111112e-07])
_ZEROS = np.zeros(DOF)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the text says which."""


@njit(cache=True, error_model="numpy")
def _wrap(angle):
    """The angle moved by whole turns to (-pi, pi]."""
    return angle - _TURN * math.ceil(angle / _TURN - 0.5)


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
    T22_ = c1 * c2 - s1 * s2
    T32_ = s1 * c2 + c1 * s2
    T24_ = c1 * l1 + T22_ * l2
    T34_ = zz + s1 * l1 + T32_ * l2
    T14_ = d1 - q[2] - ez
    T[0, 2] = -1.0
    T[0, 3] = T14_
    T[1, 0] = -T32_
    T[1, 1] = T22_
    T[1, 3] = T24_
    T[2, 0] = T22_
    T[2, 1] = T32_
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
    p1_y = c1 * l1
    p1_z = zz + s1 * l1
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    J31 = p1_y + (c1 * c2 - s1 * s2) * l2
    p2_z = p1_z + (s1 * c2 + c1 * s2) * l2
    J21 = zz - p2_z
    J32 = J31 - p1_y
    J22 = p1_z - p2_z
    J[0, 2] = -1.0
    J[1, 0] = J21
    J[1, 1] = J22
    J[2, 0] = J31
    J[2, 1] = J32
    J[3, 0] = 1.0
    J[3, 1] = 1.0
    return J


@njit(cache=True, error_model="numpy")
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # r3, type 1: U0[3, 4]
    t34 = T14 - ez * T13
    r3 = d1 - t34

    # theta12, type 3: U0[1, 2] and U0[2, 2]
    w12 = math.sqrt(T32 * T32 + T22 * T22)
    free12 = w12 <= free_limit_squared
    v1 = 1.0 / (1.0 if free12 else w12)
    v2 = seed[0] + seed[1]
    c12 = math.cos(v2) if free12 else T22 * v1
    s12 = math.sin(v2) if free12 else T32 * v1

    # theta1, type 3: U0[1, 4] and U0[2, 4]
    t14 = T24 - ez * T23
    v3 = c12 * l2
    t24 = T34 - ez * T33 - zz
    v4 = s12 * l2
    v5 = l1 * (t24 - v4)
    v6 = l1 * (t14 - v3)
    w1 = math.sqrt(v5 * v5 + v6 * v6)
    free1 = w1 <= free_limit_squared2
    v7 = 1.0 / (1.0 if free1 else w1)
    c1 = math.cos(seed[0]) if free1 else v6 * v7
    s1 = math.sin(seed[0]) if free1 else v5 * v7
    q1 = math.atan2(s1, c1)

    # is the pose one that the arm can take?
    if (
        not (abs(t34 - (d1 - r3)) <= pose_slack1 and (abs(1.0 + T13) <= pose_slack and (abs(T11) <=
        pose_slack and (abs(T12) <= pose_slack and (abs(t24 - (v4 + l1 * s1)) <= pose_slack1 and
        (abs(T33) <= pose_slack and (abs(c12 - T31) <= pose_slack and (abs(T32 - s12) <= pose_slack
        and (abs(t14 - (v3 + l1 * c1)) <= pose_slack1 and (abs(T23) <= pose_slack and (abs(T22 -
        c12) <= pose_slack and abs(T21 + s12) <= pose_slack)))))))))))
    ):
        return  # the arm can't take this pose

    # joint values
    q2 = _wrap(math.atan2(s12, c12) - q1)
    free1_ = free12 or free1
    row = 0
    q[row, 0] = q1
    q[row, 1] = q2
    q[row, 2] = r3
    status[row] = FREE_JOINT if free1_ or free12 else OK


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
    if not (math.isfinite(T[0, 3]) and math.isfinite(T[1, 3]) and math.isfinite(T[2, 3])):
        return False
    rest = abs(T[3, 0]) + abs(T[3, 1]) + abs(T[3, 2]) + abs(T[3, 3] - 1.0)
    if not rest <= 1e-09:
        return False
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
    for row in range(1):
        status[row] = UNREACHABLE if valid else INVALID_POSE
        for i in range(3):
            q[row, i] = math.nan
    if not valid:
        return 0
    pose = _read(T)
    _solve(pose, seed, q, status)
    count = 0
    for row in range(1):
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
        q: Filled with joint values (1, 3), NaN where there is no solution; float64.
        status: Filled with what each row holds (1,); uint8.
        q_seed: Values for joints that are indeterminate (3,), float64.

    Returns:
        How many rows are OK or FREE_JOINT.
    """
    if q.shape != (MAX_SOLUTIONS, DOF) or status.shape != (MAX_SOLUTIONS,) or T.shape != (4, 4):
        raise ValueError("T, q and status must be (4, 4), (1, 3) and (1,)")
    return _ik(T, q_seed, q, status)


def ik_all(T, q_seed=None):
    """All solutions: q (1, 3) and status (1,).

    Row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (3,); zeros without it.
    """
    q = np.empty((1, 3))
    status = np.empty(1, np.uint8)
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
    rows = range(1) if branch is None else [_row(branch)]
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
        q (N, 1, 3) and status (N, 1).
    """
    T = _array(T, (len(T), 4, 4), "T")
    q = np.empty((len(T), 1, 3))
    status = np.empty((len(T), 1), np.uint8)
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
