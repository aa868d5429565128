"""gantry_wrist: Gantry with a spherical wrist.

Inverse kinematics, generated from robots/gantry_wrist.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/gantry_wrist.yaml. The formulas and where they come from:
gantry_wrist.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Every entry of
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


NAME = "gantry_wrist"
DOF = 6
JOINT_TYPES = "PPPRRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "noflip",
    "flip",
)
MAX_SOLUTIONS = 2

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose

d4 = 0.1  # joint offset 4 [m]
d6 = 0.12  # joint offset 6 [m]
free_limit = 1e-12  # a length that fixes no angle

_TURN = 6.283185307179586
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
_REVOLUTE = np.array([kind == "R" for kind in JOINT_TYPES])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([20.66115702479339, 20.66115702479339, 20.66115702479339, 1.0, 1.0, 1.0])
_ZEROS = np.zeros(DOF)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the text says which."""


@njit(cache=True, error_model="numpy")
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    T = np.zeros((4, 4))
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v1 = s4 * c5
    x5_z = c4 * c5
    v2 = s4 * s5
    T33_ = c4 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T31_ = x5_z * c6 - s4 * s6
    T12_ = s5 * s6
    T22_ = v1 * s6 - c4 * c6
    T14_ = q[2] + d4 + c5 * d6
    T24_ = q[1] - v2 * d6
    T34_ = q[0] + T33_ * d6
    T[0, 0] = -(s5 * c6)
    T[0, 1] = T12_
    T[0, 2] = c5
    T[0, 3] = T14_
    T[1, 0] = -(v1 * c6 + c4 * s6)
    T[1, 1] = T22_
    T[1, 2] = -v2
    T[1, 3] = T24_
    T[2, 0] = T31_
    T[2, 1] = -(s4 * c6 + x5_z * s6)
    T[2, 2] = T33_
    T[2, 3] = T34_
    T[3, 3] = 1.0
    return T


@njit(cache=True, error_model="numpy")
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    J = np.zeros((6, 6))
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    p4_x = q[2] + d4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v1 = s4 * s5
    J66 = c4 * s5
    J34 = q[1] - v1 * d6 - q[1]
    v2 = q[0] + J66 * d6 - q[0]
    v3 = p4_x + c5 * d6 - p4_x
    J15 = s4 * J34 - c4 * v2
    J35 = c4 * v3
    J26 = J66 * v3 - c5 * v2
    J36 = c5 * J34 + v1 * v3
    J[0, 2] = 1.0
    J[0, 4] = J15
    J[0, 5] = -(v1 * v2 + J66 * J34)
    J[1, 1] = 1.0
    J[1, 3] = -v2
    J[1, 4] = -(s4 * v3)
    J[1, 5] = J26
    J[2, 0] = 1.0
    J[2, 3] = J34
    J[2, 4] = J35
    J[2, 5] = J36
    J[3, 3] = 1.0
    J[3, 5] = c5
    J[4, 4] = -c4
    J[4, 5] = -v1
    J[5, 4] = -s4
    J[5, 5] = J66
    return J


@njit(cache=True, error_model="numpy")
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # r2, type 1: U0 A6^-1 [2, 4]
    wy = T24 - T23 * d6

    # r1, type 1: U0 A6^-1 [3, 4]
    wz = T34 - d6 * T33

    # r3, type 1: U0 A6^-1 [1, 4]
    wx = T14 - d6 * T13
    r3 = wx - d4

    # theta4, type 2: U4[3, 3]
    w4 = math.sqrt(T33 * T33 + T23 * T23)
    free4 = w4 <= free_limit
    divisor4 = 1.0 if free4 else w4

    for i1 in range(2):  # noflip, flip
        e1 = 1.0 - 2.0 * i1
        # theta4
        if e1 < 0.0 and free4:
            continue  # both signs give the same
        factor4 = e1 / divisor4
        c4 = math.cos(seed[3]) if free4 else -(T33 * factor4)
        s4 = math.sin(seed[3]) if free4 else T23 * factor4
        q4 = math.atan2(s4, c4)

        # theta5, type 3: U4[2, 3] and U4[1, 3]
        q5 = math.atan2(-(w4 * e1), T13)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6 = math.atan2(-(T21 * c4 + T31 * s4), -(T22 * c4 + T32 * s4))
        row = i1
        q[row, 0] = wz
        q[row, 1] = wy
        q[row, 2] = r3
        q[row, 3] = q4
        q[row, 4] = q5
        q[row, 5] = q6
        status[row] = FREE_JOINT if free4 else OK


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
    for row in range(2):
        status[row] = UNREACHABLE if valid else INVALID_POSE
        for i in range(6):
            q[row, i] = math.nan
    if not valid:
        return 0
    pose = _read(T)
    _solve(pose, seed, q, status)
    count = 0
    for row in range(2):
        if status[row] == UNREACHABLE:
            continue
        for i in range(6):
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
        q: Filled with joint values (2, 6), NaN where there is no solution; float64.
        status: Filled with what each row holds (2,); uint8.
        q_seed: Values for joints that are indeterminate (6,), float64.

    Returns:
        How many rows are OK or FREE_JOINT.
    """
    if q.shape != (MAX_SOLUTIONS, DOF) or status.shape != (MAX_SOLUTIONS,) or T.shape != (4, 4):
        raise ValueError("T, q and status must be (4, 4), (2, 6) and (2,)")
    return _ik(T, q_seed, q, status)


def ik_all(T, q_seed=None):
    """All solutions: q (2, 6) and status (2,).

    Row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_seed: Values for joints that are indeterminate at this pose (6,); zeros without it.
    """
    q = np.empty((2, 6))
    status = np.empty(2, np.uint8)
    seed = _ZEROS if q_seed is None else _vector(q_seed, DOF, "q_seed")
    _ik(_array(T, (4, 4), "T"), seed, q, status)
    return q, status


def ik(T, q_seed=None, *, branch=None, limits=True):
    """One solution (6,): the nearest to the seed.

    Angles are moved by whole turns inside their limits.

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
        q (N, 2, 6) and status (N, 2).
    """
    T = _array(T, (len(T), 4, 4), "T")
    q = np.empty((len(T), 2, 6))
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
