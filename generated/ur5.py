"""ur5: Universal Robots UR5.

Inverse kinematics, generated from robots/ur5.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/ur5.yaml. The formulas and where they come from: ur5.md.

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


NAME = "ur5"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_LIMITS = (
    (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586),
)
BRANCHES = (
    "left-noflip-down",
    "left-noflip-up",
    "left-flip-down",
    "left-flip-up",
    "right-noflip-down",
    "right-noflip-up",
    "right-flip-down",
    "right-flip-up",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that a row before it holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value
OUT_OF_LIMITS = 3  # joint values, of which one is beyond its limits
INVALID_POSE = 4  # NaN: T is no pose
_LOST = 128

d6 = 0.0823  # joint offset 6
d4 = 0.10915  # joint offset 4
k1 = 0.0119137225  # d4 * d4
free_square_tolerance2 = 1.4220777150809998e-24  # the same, squared [length^2]
reach_tolerance1 = 1.192509e-13  # rounding at the boundary of the workspace [length]
merge_tolerance1 = 1.192509e-14  # two branches nearer than this are one [length]
free_tolerance = 1e-12  # a vector this short fixes no angle
d1 = 0.089159  # joint offset 1
d5 = 0.09465  # joint offset 5
a2 = -0.425  # link length 2
a3 = -0.39225  # link length 3
k6 = 0.3344850625  # (a2 * a2) + (a3 * a3)
longest5 = 0.6678975625000001  # square of the longest reach
shortest5 = 0.0010725625000000002  # square of the shortest reach
longest5_reach = 0.6678975625001949  # the same, longest by rounding
shortest5_reach = 0.0010725624999921891  # the same, shortest by rounding
longest5_apart = 0.6678975624999807  # the same, longest for merging
shortest5_apart = 0.0010725625000007814  # the same, shortest for merging
k8 = 2.99928766917857  # 1 / (2 * (a3 * a2))

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
    v31 = v25 * c4 - v28 * s4
    v32 = v26 * c4 - v29 * s4
    v33 = v27 * c4 + v30 * s4
    v34 = v28 * c4 + v25 * s4
    v35 = v29 * c4 + v26 * s4
    v36 = v30 * c4
    v37 = v27 * s4
    v38 = v36 - v37
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    v39 = v31 * c5 + s1 * s5
    v40 = v32 * c5 - c1 * s5
    v41 = v33 * c5
    T13 = s1 * c5 - v31 * s5
    v42 = c1 * c5 + v32 * s5
    v43 = v33 * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T11 = v39 * c6 - v34 * s6
    T21 = v40 * c6 - v35 * s6
    T31 = v41 * c6 + v38 * s6
    T32 = v38 * c6 - v41 * s6
    T14 = v21 * a2 + v25 * a3 + s1 * d4 + v34 * d5 + T13 * d6
    T24 = v22 * a2 + v26 * a3 - c1 * d4 + v35 * d5 - v42 * d6
    T34 = d1 + s2 * a2 + v27 * a3 + (v37 - v36) * d5 - v43 * d6
    T[0, 0] = T11
    T[0, 1] = -(v34 * c6 + v39 * s6)
    T[0, 2] = T13
    T[0, 3] = T14
    T[1, 0] = T21
    T[1, 1] = -(v35 * c6 + v40 * s6)
    T[1, 2] = -v42
    T[1, 3] = T24
    T[2, 0] = T31
    T[2, 1] = T32
    T[2, 2] = -v43
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
    v27 = c1 * c2
    v28 = s1 * c2
    v29 = c1 * s2
    v30 = s1 * s2
    v31 = v27 * a2
    v32 = v28 * a2
    v33 = d1 + s2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    v34 = v27 * c3 - v29 * s3
    v35 = v28 * c3 - v30 * s3
    v36 = s2 * c3 + c2 * s3
    v37 = v29 * c3 + v27 * s3
    v38 = v30 * c3 + v28 * s3
    v39 = c2 * c3 - s2 * s3
    v40 = v31 + v34 * a3
    v41 = v32 + v35 * a3
    v42 = v33 + v36 * a3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    J45 = v37 * c4 + v34 * s4
    J55 = v38 * c4 + v35 * s4
    v43 = v40 + s1 * d4
    v44 = v41 - c1 * d4
    J65 = v36 * s4 - v39 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    J46 = s1 * c5 - (v34 * c4 - v37 * s4) * s5
    v45 = c1 * c5 + (v35 * c4 - v38 * s4) * s5
    v46 = (v36 * c4 + v39 * s4) * s5
    v47 = v43 + J45 * d5
    v48 = v44 + J55 * d5
    v49 = v42 + J65 * d5
    J21 = v47 + J46 * d6
    v50 = v45 * d6
    v51 = v48 - v50
    v52 = v49 - v46 * d6
    J11 = v50 - v48
    v53 = v52 - d1
    J32 = s1 * v51 + c1 * J21
    v54 = v52 - v33
    J33 = s1 * (v51 - v32) + c1 * (J21 - v31)
    v55 = v52 - v42
    J34 = s1 * (v51 - v41) + c1 * (J21 - v40)
    v56 = J21 - v43
    v57 = v51 - v44
    J15 = J55 * v55 - J65 * v57
    J25 = J65 * v56 - J45 * v55
    J35 = J45 * v57 - J55 * v56
    v58 = J21 - v47
    v59 = v51 - v48
    v60 = v52 - v49
    J16 = v46 * v59 - v45 * v60
    J36 = J46 * v59 + v45 * v58
    J[0, 0] = J11
    J[0, 1] = -(c1 * v53)
    J[0, 2] = -(c1 * v54)
    J[0, 3] = -(c1 * v55)
    J[0, 4] = J15
    J[0, 5] = J16
    J[1, 0] = J21
    J[1, 1] = -(s1 * v53)
    J[1, 2] = -(s1 * v54)
    J[1, 3] = -(s1 * v55)
    J[1, 4] = J25
    J[1, 5] = -(v46 * v58 + J46 * v60)
    J[2, 1] = J32
    J[2, 2] = J33
    J[2, 3] = J34
    J[2, 4] = J35
    J[2, 5] = J36
    J[3, 1] = s1
    J[3, 2] = s1
    J[3, 3] = s1
    J[3, 4] = J45
    J[3, 5] = J46
    J[4, 1] = -c1
    J[4, 2] = -c1
    J[4, 3] = -c1
    J[4, 4] = J55
    J[4, 5] = -v45
    J[5, 0] = 1.0
    J[5, 4] = J65
    J[5, 5] = -v46
    return J


@njit(cache=True, error_model="numpy")
def _solve(T, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others.

    A row that was lost after joint j had been chosen freely gets the status _LOST + j and, as its
    first value, how far it is from a solution (negative).
    """

    # theta1: type 2
    X1 = T[0, 2] * d6 - T[0, 3]
    wy = T[1, 3] - d6 * T[1, 2]
    N1 = X1 * X1 + wy * wy
    D1 = N1 - k1
    free1 = N1 <= free_square_tolerance2
    v38 = 2.0 * abs(-d4)
    apart1 = merge_tolerance1 * (v38 + merge_tolerance1) < D1
    if not (-(reach_tolerance1 * (v38 + reach_tolerance1)) <= D1):
        return
    w1 = math.sqrt(D1 if apart1 else 0.0)
    v40 = 1.0 / (1.0 if free1 else N1)
    v41 = X1 * d4
    v42 = wy * d4

    # theta3: type 8
    v47 = T[2, 3] - d1

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1: type 2
        if e1 < 0.0 and (free1 or not apart1):
            continue
        v39 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else -(v40 * (v42 + X1 * v39))
        s1 = math.sin(seed[0]) if free1 else v40 * (wy * v39 - v41)
        q1 = math.atan2(s1, c1)

        # theta6: type 2
        X6 = T[1, 0] * c1 - T[0, 0] * s1
        Y6 = T[1, 1] * c1 - T[0, 1] * s1
        w6 = math.sqrt(X6 * X6 + Y6 * Y6)
        free6 = w6 <= free_tolerance
        v43 = 1.0 if free6 else w6

        # theta5: type 3
        c5 = T[0, 2] * s1 - T[1, 2] * c1

        # theta3: type 8
        v49 = T[0, 3] * c1 + T[1, 3] * s1

        for i2 in range(2):  # noflip, flip
            e2 = 1.0 - 2.0 * i2
            # theta6: type 2
            if e2 < 0.0 and free6:
                continue
            v44 = e2 / v43
            c6 = math.cos(seed[5]) if free6 else -(X6 * v44)
            s6 = math.sin(seed[5]) if free6 else Y6 * v44
            q6 = math.atan2(s6, c6)
            s5 = w6 * e2

            # theta5: type 3
            q5 = math.atan2(s5, c5)

            # theta234: type 3
            c234 = c6 * T[2, 1] + s6 * T[2, 0]
            s234 = c5 * (c6 * T[2, 0] - s6 * T[2, 1]) - s5 * T[2, 2]
            v45 = math.atan2(s234, c234)

            # theta3: type 8
            v46 = d6 * s5
            v48 = c234 * d5 + s234 * v46 + v47
            v50 = c234 * v46 - s234 * d5 + v49
            N3 = v48 * v48 + v50 * v50
            K3 = N3 - k6
            D3 = (longest5 - N3) * (N3 - shortest5)
            apart3 = shortest5_apart < N3 and N3 < longest5_apart
            if not (shortest5_reach <= N3 and N3 <= longest5_reach):
                if free1:
                    status[4 * i1 + 2 * i2] = _LOST + 1
                    q[4 * i1 + 2 * i2, 0] = D3
                if free6:
                    status[4 * i1 + 2 * i2] = _LOST + 6
                    q[4 * i1 + 2 * i2, 0] = D3
                continue
            w3 = math.sqrt(D3 if apart3 else 0.0)
            c3 = K3 * k8

            # theta2: type 3
            v51 = a2 + a3 * c3
            v53 = v48 * v51
            v55 = v50 * v51

            for i3 in range(2):  # down, up
                e3 = 1.0 - 2.0 * i3
                # theta3: type 8
                if e3 < 0.0 and not apart3:
                    continue
                s3 = w3 * e3 * k8
                q3 = math.atan2(s3, c3)

                # theta2: type 3
                v52 = a3 * s3
                v54 = v53 - v50 * v52
                v56 = v55 + v48 * v52
                w2 = math.sqrt(v54 * v54 + v56 * v56)
                free2 = w2 <= free_square_tolerance2
                v57 = 1.0 / (1.0 if free2 else w2)
                c2 = math.cos(seed[1]) if free2 else v56 * v57
                s2 = math.sin(seed[1]) if free2 else v54 * v57
                q2 = math.atan2(s2, c2)

                # joint values
                q4 = wrap(v45 - (q3 + q2))
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0] = q1
                q[row, 1] = q2
                q[row, 2] = q3
                q[row, 3] = q4
                q[row, 4] = q5
                q[row, 5] = q6
                status[row] = FREE_JOINT if free1 or free2 or free6 else OK


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
def _attempt(T, seed, joint, angle, row, q, status):
    """Solves with another seed for one joint: 0 if the row is solved, else how far it is from that."""
    kept = seed[joint]
    seed[joint] = angle
    for i in range(8):
        status[i] = UNREACHABLE
    _solve(T, seed, q, status)
    seed[joint] = kept
    if status[row] >= _LOST:
        return q[row, 0]
    return -math.inf if status[row] == UNREACHABLE else 0.0


@njit(cache=True, error_model="numpy")
def _choose_again(T, given, row, q, status):
    """A free joint took the seed's value, and then the arm could not reach: takes the nearest that serves.

    A fan of angles finds where the branch is solved, bisection the nearest such angle; where no
    angle of the fan serves, golden section goes for the best of them.
    """
    fan, halvings = 32, 52
    step, ratio = _TURN / (2.0 * fan), 0.6180339887498949
    joint = status[row] - _LOST - 1
    seed, trial, result = given.copy(), q.copy(), status.copy()
    start = seed[joint]
    best, peak, outer, found = -math.inf, 0.0, 0.0, False
    for k in range(1, 2 * fan + 1):
        outer = (step if k % 2 else -step) * ((k + 1) // 2)
        reach = _attempt(T, seed, joint, start + outer, row, trial, result)
        found = reach == 0.0
        if found:
            break
        if reach > best:
            best, peak = reach, outer
    inner = outer - step if outer > 0.0 else outer + step
    if not found:
        low, high = peak - step, peak + step
        for k in range(halvings):
            a, b = high - ratio * (high - low), low + ratio * (high - low)
            at_a = _attempt(T, seed, joint, start + a, row, trial, result)
            at_b = _attempt(T, seed, joint, start + b, row, trial, result)
            outer = a if at_a >= at_b else b
            found = at_a == 0.0 or at_b == 0.0
            if found:
                break
            if at_a >= at_b:
                high = b
            else:
                low = a
        inner = peak - step if outer > 0.0 else peak + step
    status[row] = UNREACHABLE
    for i in range(6):
        q[row, i] = math.nan
    if not found:
        return
    for k in range(halvings):
        middle = 0.5 * (inner + outer)
        if _attempt(T, seed, joint, start + middle, row, trial, result) == 0.0:
            outer = middle
        else:
            inner = middle
    _attempt(T, seed, joint, start + outer, row, trial, result)
    status[row] = result[row]
    for i in range(6):
        q[row, i] = trial[row, i]


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
        if status[row] >= _LOST:
            _choose_again(pose, seed, row, q, status)
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
