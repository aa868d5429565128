"""puma_arm: PUMA 560 to its wrist centre.

Inverse kinematics, generated from robots/puma_arm.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/puma_arm.yaml. The formulas and where they come from: puma_arm.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
position T[0:3, 3] counts; other entries are ignored.
"""

import math
import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType

import numpy as np

# The runtime that lies beside this file, by whatever name this is imported, and no other one: it is
# in a package named after the folder. A dot in a name would be one between packages.
_BESIDE = str(Path(__file__).resolve().parent)
_FOLDER = _BESIDE.replace("%", "%25").replace(".", "%2E")
sys.modules.setdefault(_FOLDER, ModuleType(_FOLDER)).__path__ = [_BESIDE]


def _runtime(name):
    return import_module(f"{_FOLDER}.dhgen_runtime.{name}")


_RUNTIME = _runtime("jit")
_COMPILED = _RUNTIME.COMPILED
_HOW = _RUNTIME.of_file(__file__, interface=1)
_njit, _jit, _inner, _merged = _HOW.njit, _HOW.jit, _HOW.inner, _HOW.merged
_apart = _HOW.apart
carray = _RUNTIME.carray
_room, _wide_room = _RUNTIME.room, _RUNTIME.wide_room
_turned = _runtime("turns").turned
_atan2 = _runtime("angles").atan2
_read_rows = _runtime("pose").read_position
_of_joints = _runtime("entry").of_joints(_HOW, 3)

NAME = "puma_arm"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRR"
JOINT_LIMITS = (
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "right-down",
    "right-up",
    "left-up",
    "left-down",
)
MAX_SOLUTIONS = 4

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.67183  # joint offset 1 [m]
a2 = 0.4318  # link length 2 [m]
d3 = 0.15005  # joint offset 3 [m]
a3 = 0.0203  # link length 3 [m]
d4 = 0.4318  # z of the tool frame [m]
free_limit_squared2 = 2.9096854084e-24  # square of a length that fixes no angle [m^2]
least_root1 = 5.394149987162018e-07  # a root of nothing, by rounding [m]
longest3 = 0.7466289125534531  # square of the longest reach [m^2]
shortest3 = 2.274465470660925e-07  # square of the shortest reach [m^2]
boundary3 = 2.1999652436149993e-13  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.7466289125534236  # the longest, where branches merge [m^2]
shortest3_apart = 2.2744654708236271e-07  # the shortest, where branches merge [m^2]
k1 = 0.022515002499999996  # d3^2 [m^2]
k2 = 5.11904578000291e-14  # reach_slack1 * (2 * d3 + reach_slack1) [m^2]
k3 = 5.1190457800002905e-15  # merge_slack1 * (2 * d3 + merge_slack1) [m^2]
k4 = 0.5862420710759887  # 1 / arm_size1 [m^-1]
k5 = 0.37290248000000004  # 2 * d4 * a2 [m^2]
k6 = 0.01753108  # 2 * a3 * a2 [m^2]
k7 = 0.37331457  # d4 * a2 + (a3^2 + d4 * a2) [m^2]
k8 = 7.175474885806929  # 1 / (k5^2 + k6^2) [m^-4]
turn1 = 1.5238184104468135  # a constant angle [rad]
m1 = 5.119045780000291e-12  # 1000 * k3 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 2.2049387897563516e-11
m3 = 1.1579434923575729  # a coefficient of X1_2
m4 = 0.000477176933765627  # a coefficient of X1_2

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0])
_JOINTS = np.column_stack([_LOWEST, _HIGHEST, [kind == "R" for kind in JOINT_TYPES], _WEIGHT])


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
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
    v1 = c1 * s2
    v2 = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v1 * s3
    x3_y = x2_y * c3 - v2 * s3
    x3_z = s2 * c3 + c2 * s3
    v3 = v1 * c3 + x2_x * s3
    v4 = v2 * c3 + x2_y * s3
    z3_z = c2 * c3 - s2 * s3
    T[0, 0] = x3_x
    T[0, 1] = -s1
    T[0, 2] = -v3
    T[0, 3] = x2_x * a2 + x3_x * a3 + s1 * d3 - v3 * d4
    T[1, 0] = x3_y
    T[1, 1] = c1
    T[1, 2] = -v4
    T[1, 3] = x2_y * a2 + x3_y * a3 - c1 * d3 - v4 * d4
    T[2, 0] = x3_z
    T[2, 2] = z3_z
    T[2, 3] = d1 + s2 * a2 + x3_z * a3 + z3_z * d4
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 3 joint values")
    J = np.zeros((6, 3))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * c2
    x2_y = s1 * c2
    v1 = c1 * s2
    v2 = s1 * s2
    p2_x = x2_x * a2
    p2_y = x2_y * a2
    p2_z = d1 + s2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    J21 = p2_x + (x2_x * c3 - v1 * s3) * a3 + s1 * d3 - (v1 * c3 + x2_x * s3) * d4
    v3 = p2_y + (x2_y * c3 - v2 * s3) * a3 - c1 * d3 - (v2 * c3 + x2_y * s3) * d4
    v4 = p2_z + (s2 * c3 + c2 * s3) * a3 + (c2 * c3 - s2 * s3) * d4
    v5 = v4 - d1
    v6 = v4 - p2_z
    J[0, 0] = -v3
    J[0, 1] = -(c1 * v5)
    J[0, 2] = -(c1 * v6)
    J[1, 0] = J21
    J[1, 1] = -(s1 * v5)
    J[1, 2] = -(s1 * v6)
    J[2, 1] = s1 * v3 + c1 * J21
    J[2, 2] = s1 * (v3 - p2_y) + c1 * (J21 - p2_x)
    J[3, 1] = s1
    J[3, 2] = s1
    J[4, 1] = -c1
    J[4, 2] = -c1
    J[5, 0] = 1.0
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    # theta1, type 2: U1[3, 4]
    N1 = T14 * T14 + T24 * T24
    free1 = N1 <= free_limit_squared2
    D1 = N1 - k1
    apart1 = k3 < D1
    if not (-k2 <= D1):
        return  # out of reach
    w1 = math.sqrt(D1 if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else d3 * math.sqrt(N1)))
    v1 = T14 * d3
    v2 = T24 * d3

    # theta3, type 6: U1[2, 4] and U1[1, 4]
    Z1_3 = T34 - d1
    v3 = Z1_3 * Z1_3
    v4 = 1.0 if free1 else (w1 if apart1 else least_root1) * k4

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        root1 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else inverse1 * (T14 * root1 - v2)
        s1 = math.sin(seed[0]) if free1 else inverse1 * (v1 + T24 * root1)
        q1 = _atan2(s1, c1)

        # theta3
        N3 = v3 + root1 * root1
        K3 = N3 - k7
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= D3 * v4):
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        v5 = k5 * K3
        v6 = k6 * K3

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            root3 = w3 * e2
            s3 = (k6 * root3 - v5) * k8
            c3 = k8 * (v6 + k5 * root3)
            q3 = _atan2(s3, c3)

            # theta2, type 3: U1[2, 4] and U1[1, 4]
            X1_2 = a2 + (a3 * c3 - d4 * s3)
            Y1_2 = d4 * c3 + a3 * s3
            S2 = Z1_3 * X1_2 - root1 * Y1_2
            C2 = root1 * X1_2 + Z1_3 * Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else S2 * factor2
            q2 = _atan2(s2, c2)
            row = 2 * i1 + i2
            q[row, 0] = q1
            q[row, 1] = q2
            q[row, 2] = q3
            status[row] = FREE_JOINT if free1 or free2 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px) and math.isfinite(py) and math.isfinite(pz), pose


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.5862, 0.5862, 0.5862, 0.0, 0.0, 0.0])


@_inner
def _miss(T, q):
    """By how much joint values miss the pose (6,), and its length.

    The former is zero half a turn away, too.
    """
    e, P, square = np.zeros(6), fk(q), 0.0
    for i in range(3):
        if _MISS_WEIGHT[i] > 0.0:
            e[i] = _MISS_WEIGHT[i] * (T[4 * i + 3] - P[i, 3])
        square += e[i] * e[i]
    return e, math.sqrt(square)


@_inner
def _add_step(held, damping, e, q):
    """Adds the damped least squares step that the miss e asks for to joint values.

    The rows of the Jacobian, each with its share of the damping's root, are made orthogonal one
    after another (modified Gram-Schmidt), twice: once would not do beside singular places.
    """
    J, rows, square = jacobian(q), np.zeros((6, 9)), np.zeros(6)
    for i in range(6):
        for j in range(3):
            rows[i, j] = 0.0 if held[j] else _PACE[j] * _MISS_WEIGHT[i] * J[i, j]
        rows[i, 3 + i] = math.sqrt(damping + 1e-26)
        for n in range(2 * i):
            k, along = n % i, 0.0
            for j in range(9):
                along += rows[k, j] * rows[i, j] / square[k]
            for j in range(9):
                rows[i, j] -= along * rows[k, j]
            e[i] -= along * e[k]
        for j in range(9):
            square[i] += rows[i, j] * rows[i, j]
        for j in range(3):
            q[j] += e[i] / square[i] * rows[i, j] * _PACE[j]


@_inner
def _half_way(x, q, half):
    """How far joint values are from others, but for whole turns [rad, arm sizes].

    Those half way go into half.
    """
    most = 0.0
    for i in range(3):
        off = q[i] - x[i]
        off -= turn * math.floor(off / turn + 0.5)
        most = max(most, abs(off))
        half[i] = x[i] + 0.5 * off
    return most


@_apart("boolean(UniTuple(float64, 12), float64, float64, float64[::1])")
def _settled(T, enough, most, q):
    """Takes joint values to some not farther than most that miss the pose by less than enough.

    Returns if it can.
    Damped least squares, while they gain: where roots meet a step still leaves less than half.
    Until one gains little they are damped so that none leads far.
    """
    half = np.empty(3)
    held, x, settled = np.zeros(3, np.bool_), q.copy(), False
    last, lost = math.inf, 0
    for _ in range(20):
        e, miss = _miss(T, x)
        if miss < enough:
            for i in range(3):
                q[i] = x[i]
            settled = True
            enough = 0.5 * miss
        elif settled:
            return True
        elif miss > max(0.7 * last, 100.0 * enough):
            lost += 1
            if lost == 4:
                return False
        last = miss
        damping = 0.1 * miss * miss
        if lost == 0 and miss > 100.0 * enough:
            damping = 0.003 * miss
        _add_step(held, damping, e, x)
        if not _half_way(x, q, half) <= most:
            return settled  # another solution
    return settled


@_inner
def _settle(pose, enough, most, q):
    """The same for joint values of the caller's."""
    values = np.empty(3)
    for i in range(3):
        values[i] = q[i]
    settled = _settled(pose, enough, most, values)
    for i in range(3):
        q[i] = values[i]
    return settled


@_inner
def _lead(pose, q, status):
    """Rows of a root that follows another, which may be a little out of reach, to solutions."""
    for row in range(4):
        if status[row] == UNREACHABLE or _miss(pose, q[row])[1] <= 1e-11:
            continue
        if not _settle(pose, 1e-12, 0.15, q[row]):
            status[row] = UNREACHABLE
            for i in range(3):
                q[row, i] = math.nan


@_apart("boolean(UniTuple(float64, 12), float64[::1])")
def _are_one(T, half):
    """Whether rounding alone tells two solutions that lie to both sides of joint values.

    Half way the arm is singular, and what steps in all other directions leave of the miss is how far
    the pose is from one at which both meet.
    """
    held = np.zeros(3, np.bool_)
    for _ in range(3):
        _add_step(held, 1e-13, _miss(T, half)[0], half)
    return _miss(T, half)[1] <= 1e-14


@_inner
def _tell_once(pose, q, status):
    """Ends rows that rounding alone tells from earlier ones.

    Where an earlier angle is good to fewer digits than usual branches that meet come out apart.
    """
    half = np.empty(3)
    for row in range(1, 4):
        for k in range(row):
            if status[row] == UNREACHABLE or status[k] == UNREACHABLE:
                continue
            if _half_way(q[k], q[row], half) < 0.001 and _are_one(pose, half):
                status[row] = UNREACHABLE
                for i in range(3):
                    q[row, i] = math.nan


@_inner
def _stay(pose, seed, q, status):
    """Where rounding can't tell solutions apart the arm goes on with the one that it is at.

    The solution next to the seed gets a row unless it has one: that of one beside
    it, that of one which it is told from by nothing, one that is left, or any.
    """
    x, half, place, least = np.empty(3), np.empty(3), 0, math.inf
    nearest = 0.001
    for i in range(3):
        x[i] = seed[i]
    if not _settle(pose, 1e-12, 0.15, x):
        return
    for row in range(4 - 1, -1, -1):
        between = 1e-06
        if status[row] != UNREACHABLE:
            off = _half_way(x, q[row], half)
            between = max(_miss(pose, half)[1], 1e-12)
            if off < nearest:
                place, nearest, least = row, off, -1.0  # its own
        if between <= 2.0 * least:
            place = row
        least = min(least, between)
    if least >= 0.0:
        status[place] = FREE_JOINT
    if nearest > 1e-06:
        for i in range(3):
            q[place, i] = x[i]


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(4):
        status[row] = UNREACHABLE
        for i in range(3):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    _lead(pose, q, status)
    _tell_once(pose, q, status)
    _stay(pose, seed, q, status)
    count = 0
    for row in range(4):
        if status[row] == UNREACHABLE:
            continue
        for i in range(3):
            q[row, i] = _turned(_JOINTS, i, q[row, i], 0.0)
            if not _LOWEST[i] <= q[row, i] <= _HIGHEST[i]:
                status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


@_merged
def _regular(pose, q, status):
    """A pose at which no joint is free and no branches meet into q and status; False for others.

    What can't be reached is NaN by itself: it has the root of a negative number in it.
    """
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose
    room = carray(_room(16), 16)

    # theta1, type 2: U1[3, 4]
    D1 = T14 * T14 + T24 * T24 - k1
    w1 = math.sqrt(D1)
    v1 = w1 - w1
    v2 = d3 * T14
    v3 = d3 * T24
    v4 = T14 * w1
    v5 = T24 * w1

    # theta3, type 6: U1[2, 4] and U1[1, 4]
    Z1_3 = T34 - d1
    N3 = D1 + Z1_3 * Z1_3
    D3 = (longest3 - N3) * (N3 - shortest3)
    w3 = math.sqrt(D3)
    v6 = w3 - w3

    # theta2, type 3: U1[2, 4] and U1[1, 4]
    X1_2 = m3 * N3 - m4
    v8 = Z1_3 * X1_2
    v9 = w3 * (m3 * Z1_3)
    v10 = w3 * (m3 * -Z1_3)
    v11 = w1 * X1_2
    v12 = w1 * -X1_2
    v13 = w3 * (m3 * w1)
    v14 = v8 - v13
    v15 = v8 + v13

    # a joint is free, or branches meet
    if abs(D1) <= m1 or abs(D3 * (k4 * w1)) <= m2:
        return False

    # angles, side by side
    room[0] = w3
    room[1] = v14
    room[2] = v15
    room[3] = v15
    room[4] = v14
    room[5] = v2 + v5
    room[6] = v2 - v5
    room[8] = N3 - k7
    room[9] = v9 + v11
    room[10] = v10 + v11
    room[11] = v9 + v12
    room[12] = v10 + v12
    room[13] = v4 - v3
    room[14] = -(v3 + v4)
    for k in range(7, 8):
        room[k] = room[k + 8] = 1.0
    for k in range(8):
        room[k] = _atan2(room[k], room[k + 8])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]
    angle4 = room[3]
    angle5 = room[4]
    angle6 = room[5]
    angle7 = room[6]

    # theta3, type 6: U1[2, 4] and U1[1, 4]
    q3__p = angle1 - turn1
    v7 = turn1 + angle1

    # joint values
    q1_pp = v6 + angle6
    q1_mp = v6 + angle7
    q3_pp = v1 + (q3__p + (turn if q3__p <= -half_turn else 0.0))
    q3_pm = v1 + ((turn if -v7 <= -half_turn else 0.0) - v7)

    q[0, 0] = q1_pp
    q[0, 1] = angle2
    q[0, 2] = q3_pp
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_pp
    q[1, 1] = angle3
    q[1, 2] = q3_pm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = q1_mp
    q[2, 1] = angle4
    q[2, 2] = q3_pp
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = q1_mp
    q[3, 1] = angle5
    q[3, 2] = q3_pm
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else OK
    return True


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (4, 3) or status.shape != (4,):
        raise ValueError("T, q and status must have shapes (4, 4), (4, 3), (4,)")
    valid, pose = _read(T)
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    if _COMPILED and _regular(pose, q, status):
        count = 0
        for row in range(4):
            count += status[row] == OK
        return count
    return _whole(pose, seed, q, status)


# Where in a tile the rows' values and statuses begin.
_PLACES = np.array([
    [576, 592, 608],
    [576, 624, 640],
    [656, 672, 608],
    [656, 688, 640],
])
_KINDS = np.array([704, 720, 736, 752])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(768), 768)
    work[:] = 0.0  # the last tile may be half full
    for first in range(0, len(T), 16):
        count = min(16, len(T) - first)
        for k in range(count):
            for i in range(4):
                for j in range(4):
                    work[(4 * i + j) * 16 + k] = T[first + k, i, j]
        for k in range(16):
            miss = 0.0 * (work[48 + k] + work[112 + k] + work[176 + k])
            exact = miss <= 1e-24
            work[256 + k] = 0.0 if exact else 1.0
        for k in range(0, 16):
            T14 = work[48 + k]
            T24 = work[112 + k]
            T34 = work[176 + k]
            D1 = T14 * T14 + T24 * T24 - k1
            w1 = math.sqrt(D1)
            v1 = w1 - w1
            v2 = d3 * T14
            v3 = d3 * T24
            v4 = T14 * w1
            v5 = T24 * w1
            Z1_3 = T34 - d1
            N3 = D1 + Z1_3 * Z1_3
            D3 = (longest3 - N3) * (N3 - shortest3)
            w3 = math.sqrt(D3)
            v6 = w3 - w3
            X1_2 = m3 * N3 - m4
            v8 = Z1_3 * X1_2
            v9 = w3 * (m3 * Z1_3)
            v10 = w3 * (m3 * -Z1_3)
            v11 = w1 * X1_2
            v12 = w1 * -X1_2
            v13 = w3 * (m3 * w1)
            v14 = v8 - v13
            v15 = v8 + v13
            work[272 + k] = D1
            work[288 + k] = w1
            work[304 + k] = v1
            work[320 + k] = D3
            work[336 + k] = v6
            work[352 + k] = w3
            work[368 + k] = v14
            work[384 + k] = v15
            work[400 + k] = v15
            work[416 + k] = v14
            work[432 + k] = v2 + v5
            work[448 + k] = v2 - v5
            work[464 + k] = N3 - k7
            work[480 + k] = v9 + v11
            work[496 + k] = v10 + v11
            work[512 + k] = v9 + v12
            work[528 + k] = v10 + v12
            work[544 + k] = v4 - v3
            work[560 + k] = -(v3 + v4)
        for k in range(352, 464):
            work[k] = _atan2(work[k], work[k + 112])
        for k in range(0, 16):
            D1 = work[272 + k]
            w1 = work[288 + k]
            v1 = work[304 + k]
            D3 = work[320 + k]
            v6 = work[336 + k]
            angle1 = work[352 + k]
            angle2 = work[368 + k]
            angle3 = work[384 + k]
            angle4 = work[400 + k]
            angle5 = work[416 + k]
            angle6 = work[432 + k]
            angle7 = work[448 + k]
            q3__p = angle1 - turn1
            v7 = turn1 + angle1
            q1_pp = v6 + angle6
            q1_mp = v6 + angle7
            q3_pp = v1 + (q3__p + (turn if q3__p <= -half_turn else 0.0))
            q3_pm = v1 + ((turn if -v7 <= -half_turn else 0.0) - v7)
            _576 = q1_pp
            work[576 + k] = _576
            _592 = angle2
            work[592 + k] = _592
            _608 = q3_pp
            work[608 + k] = _608
            _624 = angle3
            work[624 + k] = _624
            _640 = q3_pm
            work[640 + k] = _640
            _656 = q1_mp
            work[656 + k] = _656
            _672 = angle4
            work[672 + k] = _672
            _688 = angle5
            work[688 + k] = _688
            work[704 + k] = UNREACHABLE if _576 != _576 else OK
            work[720 + k] = UNREACHABLE if _576 != _576 else OK
            work[736 + k] = UNREACHABLE if _656 != _656 else OK
            work[752 + k] = UNREACHABLE if _656 != _656 else OK
            work[256 + k] = 1.0 if abs(D1) <= m1 or abs(D3 * (k4 * w1)) <= m2 else work[256 + k]
        for k in range(first, first + count):
            if work[256 + k - first] != 0.0:
                _unseeded(T[k], q[k], status[k])
                continue
            for row in range(4):
                status[k, row] = np.uint8(work[_KINDS[row] + k - first])
                for i in range(3):
                    q[k, row, i] = work[_PLACES[row, i] + k - first]

_FUNCTIONS = _runtime("functions")
_CALLS = _FUNCTIONS.of_robot(
    globals(),
    _HOW,
    _FUNCTIONS.Solver(
        joints=_JOINTS,
        into=_into,
        many=_in_tiles,
        kinematics=(fk, jacobian),
        given=0,
        apart=(_HOW.compile_apart,),
        words={
            "no_pose": "not finite",
            "no_row": "the pose is out of reach",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
