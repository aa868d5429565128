"""scorbot_pointing: Scorbot (tool axis only).

Inverse kinematics, generated from robots/scorbot_pointing.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/scorbot_pointing.yaml. The formulas and where they come from:
scorbot_pointing.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
position T[0:3, 3] and the tool's z axis T[0:3, 2] counts; other entries are ignored.
"""

import math

import numpy as np

try:
    from numba import njit, prange
except ImportError:  # plain Python, only slower
    prange = range

    def njit(*_, **__):
        return lambda function: function


NAME = "scorbot_pointing"
DOF = 5
JOINT_TYPES = "RRRRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "left-down",
    "left-up",
    "right-down",
    "right-up",
)
MAX_SOLUTIONS = 4
FREE_JOINTS = (5,)  # from 1: the caller gives their values

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose, or a free joint's value is not finite

d1 = 0.349  # joint offset 1 [m]
a1 = 0.016  # link length 1 [m]
a2 = 0.221  # link length 2 [m]
a3 = 0.221  # link length 3 [m]
d5 = 0.145  # joint offset 5 [m]
free_limit1 = 9.52e-13  # a length that fixes no angle [m]
free_limit_squared = 1e-24  # square of a length that fixes no angle
offset4 = 1.5707963267948966  # offset of joint 4 [rad]
longest3 = 0.195364  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
longest3_reach = 0.19536400000008416  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.1953639999999916  # the longest, where branches merge [m^2]
shortest3_apart = 9.06304e-29  # the shortest, where branches merge [m^2]
free_limit_squared2 = 9.063039999999997e-25  # square of a length that fixes no angle [m^2]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 9.52e-06  # a pose may be rounded by this [m]
k1 = 0.097682  # 2 * a3 * a2 [m^2]
k2 = 10.237300628570258  # 1 / (2 * a3 * a2) [m^-2]

_TURN = 6.283185307179586
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS])
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS])
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0, 1.0])
_ZEROS = np.zeros(DOF)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the text says which."""


@njit(cache=True, error_model="numpy")
def _wrap(angle):
    """The angle moved by whole turns to (-pi, pi]."""
    return angle - _TURN * math.ceil(angle / _TURN - 0.5)


@njit(cache=True, error_model="numpy")
def fk(q):
    """The pose (4, 4) of the joint values q (5,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 5 joint values")
    T = np.zeros((4, 4))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * c2
    x2_y = s1 * c2
    v1 = c1 * s2
    v2 = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v1 * s3
    x3_y = x2_y * c3 - v2 * s3
    v3 = s2 * c3 + c2 * s3
    v4 = v1 * c3 + x2_x * s3
    v5 = v2 * c3 + x2_y * s3
    y3_z = s2 * s3 - c2 * c3
    v6 = q[3] + offset4
    c4 = math.cos(v6)
    s4 = math.sin(v6)
    x4_x = x3_x * c4 - v4 * s4
    x4_y = x3_y * c4 - v5 * s4
    x4_z = y3_z * s4 - v3 * c4
    T13_ = v4 * c4 + x3_x * s4
    T23_ = v5 * c4 + x3_y * s4
    v7 = y3_z * c4 + v3 * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    T11_ = x4_x * c5 - s1 * s5
    T21_ = x4_y * c5 + c1 * s5
    T31_ = x4_z * c5
    T22_ = c1 * c5 - x4_y * s5
    T14_ = c1 * a1 + x2_x * a2 + x3_x * a3 + T13_ * d5
    T24_ = s1 * a1 + x2_y * a2 + x3_y * a3 + T23_ * d5
    T34_ = d1 - s2 * a2 - v3 * a3 - v7 * d5
    T[0, 0] = T11_
    T[0, 1] = -(s1 * c5 + x4_x * s5)
    T[0, 2] = T13_
    T[0, 3] = T14_
    T[1, 0] = T21_
    T[1, 1] = T22_
    T[1, 2] = T23_
    T[1, 3] = T24_
    T[2, 0] = T31_
    T[2, 1] = -(x4_z * s5)
    T[2, 2] = -v7
    T[2, 3] = T34_
    T[3, 3] = 1.0
    return T


@njit(cache=True, error_model="numpy")
def jacobian(q):
    """The geometric Jacobian (6, 5): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 5 joint values")
    J = np.zeros((6, 5))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    p1_x = c1 * a1
    p1_y = s1 * a1
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * c2
    x2_y = s1 * c2
    v1 = c1 * s2
    v2 = s1 * s2
    p2_x = p1_x + x2_x * a2
    p2_y = p1_y + x2_y * a2
    p2_z = d1 - s2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v1 * s3
    x3_y = x2_y * c3 - v2 * s3
    v3 = s2 * c3 + c2 * s3
    p3_x = p2_x + x3_x * a3
    p3_y = p2_y + x3_y * a3
    p3_z = p2_z - v3 * a3
    v4 = q[3] + offset4
    c4 = math.cos(v4)
    s4 = math.sin(v4)
    J45 = (v1 * c3 + x2_x * s3) * c4 + x3_x * s4
    J55 = (v2 * c3 + x2_y * s3) * c4 + x3_y * s4
    v5 = (s2 * s3 - c2 * c3) * c4 + v3 * s4
    J21 = p3_x + J45 * d5
    p5_y = p3_y + J55 * d5
    p5_z = p3_z - v5 * d5
    v6 = p5_z - d1
    J12 = c1 * v6
    J22 = s1 * v6
    v7 = p5_z - p2_z
    J13 = c1 * v7
    J23 = s1 * v7
    v8 = J21 - p3_x
    v9 = p5_y - p3_y
    v10 = p5_z - p3_z
    J14 = c1 * v10
    J24 = s1 * v10
    J15 = J55 * v10 + v5 * v9
    J35 = J45 * v9 - J55 * v8
    J[0, 0] = -p5_y
    J[0, 1] = J12
    J[0, 2] = J13
    J[0, 3] = J14
    J[0, 4] = J15
    J[1, 0] = J21
    J[1, 1] = J22
    J[1, 2] = J23
    J[1, 3] = J24
    J[1, 4] = -(v5 * v8 + J45 * v10)
    J[2, 1] = -(s1 * (p5_y - p1_y) + c1 * (J21 - p1_x))
    J[2, 2] = -(s1 * (p5_y - p2_y) + c1 * (J21 - p2_x))
    J[2, 3] = -(s1 * v9 + c1 * v8)
    J[2, 4] = J35
    J[3, 1] = -s1
    J[3, 2] = -s1
    J[3, 3] = -s1
    J[3, 4] = J45
    J[4, 1] = c1
    J[4, 2] = c1
    J[4, 3] = c1
    J[4, 4] = J55
    J[5, 0] = 1.0
    J[5, 4] = -v5
    return J


_LOST = 128  # _LOST + j: the row was lost after joint j had been chosen freely


@njit(cache=True, error_model="numpy")
def _solve(pose, q_free, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others.

    The first value of a row that is _LOST says how far it is from a solution (negative).
    """
    _, _, T13, T14, _, _, T23, T24, _, _, T33, T34 = pose

    # theta1, type 2: U1[3, 4]
    w1 = math.sqrt(T14 * T14 + T24 * T24)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta234, type 3: U1[2, 3] and U1[1, 3]
    v1 = T33 * T33
    v3 = seed[1] + seed[2] + (seed[3] + offset4)

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v5 = T34 - d1

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(T14 * factor1)
        s1 = math.sin(seed[0]) if free1 else -(T24 * factor1)
        q1 = math.atan2(s1, c1)

        # theta234
        Z2_234 = c1 * T13 + s1 * T23
        w234 = math.sqrt(Z2_234 * Z2_234 + v1)
        free234 = w234 <= free_limit_squared
        v2 = 1.0 / (1.0 if free234 else w234)
        c234 = math.cos(v3) if free234 else T33 * v2
        s234 = math.sin(v3) if free234 else Z2_234 * v2
        theta234 = math.atan2(s234, c234)

        # theta3
        v4 = c234 * d5
        Z1_3 = v5 - v4
        v6 = s234 * d5
        v7 = v6 + (w1 * e1 + a1)
        N3 = Z1_3 * Z1_3 + v7 * v7
        K3 = N3 - k1
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            if free1:
                status[2 * i1] = _LOST + 1
                q[2 * i1, 0] = D3
            if free234:
                status[2 * i1] = _LOST + 2
                q[2 * i1, 0] = D3
            if free234:
                status[2 * i1] = _LOST + 3
                q[2 * i1, 0] = D3
            if free234:
                status[2 * i1] = _LOST + 4
                q[2 * i1, 0] = D3
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        c3 = K3 * k2

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        Y1_2 = a2 + a3 * c3
        v9 = Z1_3 * Y1_2
        v10 = v7 * Y1_2

        # is the pose one that the arm can take?
        v12 = a1 + v6
        v14 = d1 + v4
        if (
            not (abs(T33 - c234) <= pose_slack and (abs(T13 - c1 * s234) <= pose_slack and abs(T23 -
            s1 * s234) <= pose_slack))
        ):
            continue  # the arm can't take this pose

        for i2 in range(2):  # down, up
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            s3 = w3 * e2 * k2
            q3 = math.atan2(s3, c3)

            # theta2
            v8 = a3 * s3
            S2 = v7 * v8 - v9
            v11 = Z1_3 * v8 + v10
            w2 = math.sqrt(S2 * S2 + v11 * v11)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else -(v11 * factor2)
            s2 = math.sin(seed[1]) if free2 else S2 * factor2
            q2 = math.atan2(s2, c2)

            # is the pose one that the arm can take?
            c23 = c3 * c2 - s3 * s2
            s23 = c3 * s2 + s3 * c2
            v13 = a3 * c23 + (a2 * c2 + v12)
            if (
                not (abs(T34 + (a3 * s23 + (a2 * s2 - v14))) <= pose_slack1 and (abs(T14 - c1 * v13)
                <= pose_slack1 and abs(T24 - s1 * v13) <= pose_slack1))
            ):
                continue  # the arm can't take this pose

            # joint values
            q4 = _wrap(theta234 - (q3 + q2) - offset4)
            free2_ = free234 or free2
            row = 2 * i1 + i2
            q[row, 0] = q1
            q[row, 1] = q2
            q[row, 2] = q3
            q[row, 3] = q4
            q[row, 4] = q_free[0]
            status[row] = FREE_JOINT if free1 or free2_ or free234 or free234 else OK


@njit(cache=True, error_model="numpy")
def _misfit(T):
    """How far the tool axis is from length one, squared."""
    miss = T[0, 2] * T[0, 2] + T[1, 2] * T[1, 2] + T[2, 2] * T[2, 2] - 1.0
    return miss * miss


@njit(cache=True, error_model="numpy")
def _straightened(pose):
    """With a tool axis of length one."""
    x0, x1, x2, px, y0, y1, y2, py, z0, z1, z2, pz = pose
    length = math.sqrt(x2 * x2 + y2 * y2 + z2 * z2)
    return x0, x1, x2 / length, px, y0, y1, y2 / length, py, z0, z1, z2 / length, pz


@njit(cache=True, error_model="numpy")
def _is_pose(T, q_free):
    """Whether the entries that count make a pose."""
    if not (math.isfinite(T[0, 3]) and math.isfinite(T[1, 3]) and math.isfinite(T[2, 3]) and math.isfinite(q_free[0])):
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
    low, high = _LOWEST[joint] - 1e-09, _HIGHEST[joint] + 1e-09
    value = given + _TURN * math.floor((towards - given) / _TURN + 0.5)
    if value > high:
        value -= _TURN * math.ceil((value - high) / _TURN)
    if value < low:
        value += _TURN * math.ceil((low - value) / _TURN)
    return value if value <= high else given


@njit(cache=True, error_model="numpy")
def _attempt(pose, q_free, seed, lost, moved, q, status):
    """Solves with the joint moved: 0 if the row is solved, else how far it is from that.

    The row and the joint that had been chosen are the two numbers of `lost`.
    """
    row, joint = lost
    for i in range(4):
        status[i] = UNREACHABLE
    kept = seed[joint]
    seed[joint] = kept + moved
    _solve(pose, q_free, seed, q, status)
    seed[joint] = kept
    if status[row] >= _LOST:
        return q[row, 0]
    return -math.inf if status[row] == UNREACHABLE else 0.0


@njit(cache=True, error_model="numpy")
def _summit(pose, q_free, seed, lost, low, high, q, status):
    """Golden section for a move between low and high that serves; NaN if there is none."""
    for _ in range(52):
        third = 0.3819660112501051 * (high - low)
        left = _attempt(pose, q_free, seed, lost, low + third, q, status)
        right = _attempt(pose, q_free, seed, lost, high - third, q, status)
        if left == 0.0 or right == 0.0:
            return low + third if left == 0.0 else high - third
        if left >= right:
            high -= third
        else:
            low += third
    return math.nan


@njit(cache=True, error_model="numpy")
def _serving(pose, q_free, seed, lost, q, status):
    """How far the joint has to be moved from the seed's value until it serves; NaN if nowhere.

    A fan of values shows where the branch is solved or nearly so, golden section finds what lies
    between two of them, bisection the end that is nearest to the seed.
    """
    step, nearest = _TURN / 64, math.nan
    here, after = -math.inf, _attempt(pose, q_free, seed, lost, -_TURN / 2.0, q, status)
    for k in range(-32, 32 + 1):
        before, here = here, after
        after = _attempt(pose, q_free, seed, lost, (k + 1) * step, q, status)
        outer = k * step
        inner = outer - step if k > 0 else outer + step if k < 0 else 0.0
        if here < 0.0 and here >= before and here > after:
            low, high = outer - step, outer + step
            outer = _summit(pose, q_free, seed, lost, low, high, q, status)
            if math.isnan(outer):
                continue
        elif here < 0.0 or (before if k > 0 else after) == 0.0:
            continue
        for _ in range(52):
            middle = 0.5 * (inner + outer)
            if _attempt(pose, q_free, seed, lost, middle, q, status) == 0.0:
                outer = middle
            else:
                inner = middle
        if not abs(outer) >= abs(nearest):
            nearest = outer
    return nearest


@njit(cache=True, error_model="numpy")
def _choose_again(pose, q_free, given, row, q, status):
    """A free joint took the seed's value, and then the arm could not reach.

    The joint takes the nearest value that serves.
    """
    lost = row, status[row] - _LOST - 1
    seed, trial, result = given.copy(), q.copy(), status.copy()
    moved = _serving(pose, q_free, seed, lost, trial, result)
    served = _attempt(pose, q_free, seed, lost, moved, trial, result) == 0.0
    status[row] = result[row] if served else UNREACHABLE
    for i in range(5):
        q[row, i] = trial[row, i] if served else math.nan


@njit(cache=True, error_model="numpy")
def _ik(T, q_free, seed, q, status):
    """All rows into q and status; how many are OK or FREE_JOINT."""
    valid = _is_pose(T, q_free)
    for row in range(4):
        status[row] = UNREACHABLE if valid else INVALID_POSE
        for i in range(5):
            q[row, i] = math.nan
    if not valid:
        return 0
    pose = _read(T)
    _solve(pose, q_free, seed, q, status)
    count = 0
    for row in range(4):
        if status[row] >= _LOST:
            _choose_again(pose, q_free, seed, row, q, status)
        if status[row] == UNREACHABLE:
            continue
        for i in range(5):
            q[row, i] = _turned(i, q[row, i], q[row, i])
            low, high = _LOWEST[i] - 1e-09, _HIGHEST[i] + 1e-09
            if not low <= q[row, i] <= high:
                status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


@njit(cache=True, error_model="numpy", parallel=True)
def _ik_batch(T, q_free, q, status):
    for k in prange(len(T)):
        _ik(T[k], q_free[k], _ZEROS, q[k], status[k])


def ik_into(T, q_free, q, status, q_seed=_ZEROS):
    """All solutions into the caller's arrays, for control loops.

    Besides the pose only shapes are checked. Memory is allocated only where a free
    joint can't keep the seed's value.

    Args:
        T: Pose (4, 4), float64.
        q_free: Values of the joints 5 (1,), float64.
        q: Filled with joint values (4, 5), NaN where there is no solution; float64.
        status: Filled with what each row holds (4,); uint8.
        q_seed: Values for joints that are indeterminate (5,), float64.

    Returns:
        How many rows are OK or FREE_JOINT.
    """
    if q.shape != (MAX_SOLUTIONS, DOF) or status.shape != (MAX_SOLUTIONS,) or T.shape != (4, 4):
        raise ValueError("T, q and status must be (4, 4), (4, 5) and (4,)")
    return _ik(T, q_free, q_seed, q, status)


def ik_all(T, q_free, q_seed=None):
    """All solutions: q (4, 5) and status (4,).

    Row b is always branch BRANCHES[b].

    Args:
        T: Pose (4, 4).
        q_free: Values of the joints 5 (1,).
        q_seed: Values for joints that are indeterminate at this pose (5,); zeros without it.
    """
    q = np.empty((4, 5))
    status = np.empty(4, np.uint8)
    seed = _ZEROS if q_seed is None else _vector(q_seed, DOF, "q_seed")
    _ik(_array(T, (4, 4), "T"), _vector(q_free, 1, "q_free"), seed, q, status)
    return q, status


def ik(T, q_free, q_seed=None, *, branch=None, limits=True):
    """One solution (5,): the nearest to the seed.

    Angles are moved by whole turns inside their limits.

    Args:
        T: Pose (4, 4).
        q_free: Values of the joints 5 (1,).
        q_seed: Where the arm is (5,); zeros without it.
        branch: Only this branch: a name out of BRANCHES, or its row.
        limits: Whether joint limits count.

    Raises:
        Unreachable: There is no such solution; the text says why.
        ValueError: T is no pose, or there is no such branch.
    """
    seed = _ZEROS if q_seed is None else _vector(q_seed, DOF, "q_seed")
    rows = range(4) if branch is None else [_row(branch)]
    q, status = ik_all(T, q_free, seed)
    if status[0] == INVALID_POSE:
        raise ValueError("T is no pose: not finite, or its z axis not of length one")
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


def ik_batch(T, q_free):
    """ik_all for N poses (N, 4, 4) on all cores.

    Returns:
        q (N, 4, 5) and status (N, 4).
    """
    T = _array(T, (len(T), 4, 4), "T")
    q_free = _array(q_free, (len(T), 1), "q_free")
    q = np.empty((len(T), 4, 5))
    status = np.empty((len(T), 4), np.uint8)
    _ik_batch(T, q_free, q, status)
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
