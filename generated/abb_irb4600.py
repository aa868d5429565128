"""abb_irb4600: ABB IRB 4600-40/2.55.

Inverse kinematics, generated from robots/abb_irb4600.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/abb_irb4600.yaml. The formulas and where they come from:
abb_irb4600.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Every entry of
a pose counts.
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
_read_rows = _runtime("pose").read_pose
_of_joints = _runtime("entry").of_joints(_HOW, 6)

NAME = "abb_irb4600"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_LIMITS = (
    (-3.141592653589793, 3.141592653589793),
    (-1.5707963267948966, 2.6179938779914944),
    (-3.141592653589793, 1.3089969389957472),
    (-6.981317007977318, 6.981317007977318),
    (-2.181661564992912, 2.0943951023931953),
    (-6.981317007977318, 6.981317007977318),
)
BRANCHES = (
    "back-down-noflip",
    "back-down-flip",
    "back-up-noflip",
    "back-up-flip",
    "front-up-noflip",
    "front-up-flip",
    "front-down-noflip",
    "front-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

a1 = 0.175  # x of axis 2 [m]
d1 = 0.495  # z of axis 2 [m]
a2 = 1.095  # z of axis 3 [m]
a3 = 0.175  # z of axis 4 [m]
d4 = 1.27  # x of axis 5 [m]
d6 = 0.135  # x of the home pose [m]
free_limit1 = 3.2000238089839356e-12  # a length that fixes no angle [m]
longest3 = 5.650130854134036  # square of the longest reach [m^2]
shortest3 = 0.03496914586596454  # square of the shortest reach [m^2]
longest3_reach = 5.650130854135559  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.03496914586584486  # the shortest, with what rounding adds [m^2]
longest3_apart = 5.650130854133884  # the longest, where branches merge [m^2]
shortest3_apart = 0.034969145865976506  # the shortest, where branches merge [m^2]
free_limit_squared2 = 1.0240152378064055e-23  # square of a length that fixes no angle [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 2.7813  # 2 * d4 * a2 [m^2]
k2 = 0.38325  # 2 * a3 * a2 [m^2]
k3 = 2.84255  # a2^2 + (a3^2 + d4^2) [m^2]
k4 = 0.1268631397825131  # 1 / (k1^2 + k2^2) [m^-4]
turn1 = 1.4338633792358526  # a constant angle [rad]
low2 = -1.5707963277948966
high2 = 2.6179938789914945
low3 = -3.141592654589793
high3 = 1.3089969399957473
low5 = -2.181661565992912
high5 = 2.0943951033931953
graze = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 1.0240152378064056e-07  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 8.528223923621197e-10
m4 = 0.4566210045662101  # a coefficient of X1_2
m5 = 0.20296803652968054  # a coefficient of X1_2
m6 = 0.3863646734914285  # a coefficient of c23
m7 = 0.053239226662204715  # a coefficient of c23
m8 = 0.023664836251350022  # a coefficient of c23
m9 = 0.17173909736694015  # a coefficient of c23
m10 = 9.999999999999999e-09  # doubt_limit^2

turn = 6.283185307179586  # 2 pi [rad]
half_turn = 0.5 * turn
# By what joint values may miss their limits, and the limits with it: rounding.
_SLACK = np.array([1e-09, 1e-09, 1e-09, 1e-09, 1e-09, 1e-09])
_LOWEST = np.array([pair[0] for pair in JOINT_LIMITS]) - _SLACK
_HIGHEST = np.array([pair[1] for pair in JOINT_LIMITS]) + _SLACK
# Of squared differences of joint values: lengths count in arm sizes.
_WEIGHT = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])
_JOINTS = np.column_stack([_LOWEST, _HIGHEST, [kind == "R" for kind in JOINT_TYPES], _WEIGHT])


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    T = np.zeros((4, 4))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * s2
    x2_y = s1 * s2
    y2_x = c1 * c2
    y2_y = s1 * c2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 + y2_x * s3
    x3_y = x2_y * c3 + y2_y * s3
    x3_z = c2 * c3 - s2 * s3
    y3_x = y2_x * c3 - x2_x * s3
    y3_y = y2_y * c3 - x2_y * s3
    v1 = s2 * c3 + c2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 + s1 * s4
    x4_y = x3_y * c4 - c1 * s4
    x4_z = x3_z * c4
    y4_x = s1 * c4 - x3_x * s4
    z5_y = c1 * c4 + x3_y * s4
    z5_z = x3_z * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 + y3_x * s5
    x5_y = x4_y * c5 + y3_y * s5
    x5_z = x4_z * c5 - v1 * s5
    y5_x = y3_x * c5 - x4_x * s5
    y5_y = y3_y * c5 - x4_y * s5
    v2 = v1 * c5 + x4_z * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = -(x5_x * c6 + y4_x * s6)
    T[0, 1] = x5_x * s6 - y4_x * c6
    T[0, 2] = y5_x
    T[0, 3] = c1 * a1 + x2_x * a2 + x3_x * a3 + y3_x * d4 + y5_x * d6
    T[1, 0] = z5_y * s6 - x5_y * c6
    T[1, 1] = z5_y * c6 + x5_y * s6
    T[1, 2] = y5_y
    T[1, 3] = s1 * a1 + x2_y * a2 + x3_y * a3 + y3_y * d4 + y5_y * d6
    T[2, 0] = z5_z * s6 - x5_z * c6
    T[2, 1] = z5_z * c6 + x5_z * s6
    T[2, 2] = -v2
    T[2, 3] = d1 + c2 * a2 + x3_z * a3 - v1 * d4 - v2 * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    if len(q) != DOF:
        raise ValueError("q must hold 6 joint values")
    J = np.zeros((6, 6))
    c1 = math.cos(q[0])
    s1 = math.sin(q[0])
    p2_x = c1 * a1
    p2_y = s1 * a1
    c2 = math.cos(q[1])
    s2 = math.sin(q[1])
    x2_x = c1 * s2
    x2_y = s1 * s2
    y2_x = c1 * c2
    y2_y = s1 * c2
    p3_x = p2_x + x2_x * a2
    p3_y = p2_y + x2_y * a2
    p3_z = d1 + c2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 + y2_x * s3
    x3_y = x2_y * c3 + y2_y * s3
    x3_z = c2 * c3 - s2 * s3
    y3_x = y2_x * c3 - x2_x * s3
    y3_y = y2_y * c3 - x2_y * s3
    v1 = s2 * c3 + c2 * s3
    p4_x = p3_x + x3_x * a3
    p4_y = p3_y + x3_y * a3
    p4_z = p3_z + x3_z * a3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    z5_y = c1 * c4 + x3_y * s4
    z5_z = x3_z * s4
    p5_x = p4_x + y3_x * d4
    p5_y = p4_y + y3_y * d4
    p5_z = p4_z - v1 * d4
    z5_x = x3_x * s4 - s1 * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    y5_x = y3_x * c5 - (x3_x * c4 + s1 * s4) * s5
    y5_y = y3_y * c5 - (x3_y * c4 - c1 * s4) * s5
    v2 = v1 * c5 + x3_z * c4 * s5
    J21 = p5_x + y5_x * d6
    v3 = p5_y + y5_y * d6
    v4 = p5_z - v2 * d6
    v5 = v4 - d1
    v6 = v4 - p3_z
    v7 = J21 - p4_x
    v8 = v3 - p4_y
    v9 = v4 - p4_z
    v10 = J21 - p5_x
    v11 = v3 - p5_y
    v12 = v4 - p5_z
    J[0, 0] = -v3
    J[0, 1] = c1 * v5
    J[0, 2] = c1 * v6
    J[0, 3] = y3_y * v9 + v1 * v8
    J[0, 4] = z5_y * v12 - z5_z * v11
    J[0, 5] = y5_y * v12 + v2 * v11
    J[1, 0] = J21
    J[1, 1] = s1 * v5
    J[1, 2] = s1 * v6
    J[1, 3] = -(v1 * v7 + y3_x * v9)
    J[1, 4] = z5_z * v10 - z5_x * v12
    J[1, 5] = -(v2 * v10 + y5_x * v12)
    J[2, 1] = -(s1 * (v3 - p2_y) + c1 * (J21 - p2_x))
    J[2, 2] = -(s1 * (v3 - p3_y) + c1 * (J21 - p3_x))
    J[2, 3] = y3_x * v8 - y3_y * v7
    J[2, 4] = z5_x * v11 - z5_y * v10
    J[2, 5] = y5_x * v11 - y5_y * v10
    J[3, 1] = -s1
    J[3, 2] = -s1
    J[3, 3] = y3_x
    J[3, 4] = z5_x
    J[3, 5] = y5_x
    J[4, 1] = c1
    J[4, 2] = c1
    J[4, 3] = y3_y
    J[4, 4] = z5_y
    J[4, 5] = y5_y
    J[5, 0] = 1.0
    J[5, 3] = -v1
    J[5, 4] = z5_z
    J[5, 5] = -v2
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[2, 4]
    t14 = T14 - d6 * T13
    Y1 = d6 * T23 - T24
    w1 = math.sqrt(t14 * t14 + Y1 * Y1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 6: U1[3, 4] and U1[1, 4]
    t34 = T34 - d6 * T33
    Z1_3 = t34 - d1
    v2 = Z1_3 * Z1_3

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(t14 * factor1)
        s1 = math.sin(seed[0]) if free1 else Y1 * factor1
        q1 = _atan2(s1, c1)

        # theta3
        v1 = w1 * e1 + a1
        N3 = v2 + v1 * v1
        K3 = N3 - k3
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        v3 = k1 * K3
        v4 = k2 * K3

        # theta4, type 2: U4[2, 3]
        v6 = T13 * c1 + T23 * s1
        Y4 = T23 * c1 - T13 * s1
        v7 = Y4 * Y4

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        v8 = T12 * s1 - T22 * c1
        v9 = T12 * c1 + T22 * s1
        v11 = T11 * s1 - T21 * c1
        v12 = T11 * c1 + T21 * s1

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            root3 = w3 * e2
            s3 = (k2 * root3 - v3) * k4
            c3 = k4 * (v4 + k1 * root3)
            q3 = _atan2(s3, c3)

            # theta2, type 3: U1[1, 4] and U1[3, 4]
            X1_2 = a2 + (a3 * c3 - d4 * s3)
            Y1_2 = d4 * c3 + a3 * s3
            v5 = v1 * X1_2 + Z1_3 * Y1_2
            C2 = Z1_3 * X1_2 - v1 * Y1_2
            w2 = math.sqrt(v5 * v5 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else -(v5 * factor2)
            q2 = _atan2(s2, c2)

            # theta4
            c23 = c3 * c2 - s3 * s2
            s23 = c3 * s2 + s3 * c2
            X4 = T33 * c23 + s23 * v6
            w4 = math.sqrt(X4 * X4 + v7)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[3, 3] and U4[1, 3]
            c5 = c23 * v6 - T33 * s23

            # theta6
            v10 = T32 * c23 + s23 * v9
            v13 = T31 * c23 + s23 * v12

            for i3 in range(2):  # noflip, flip
                e3 = 1.0 - 2.0 * i3
                # theta4
                if e3 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e3 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)
                s5 = w4 * e3

                # theta5
                q5 = _atan2(s5, c5)

                # theta6
                c6 = s4 * v10 - c4 * v8
                s6 = s4 * v13 - c4 * v11
                q6 = _atan2(s6, c6)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0] = q1
                q[row, 1] = q2
                q[row, 2] = q3
                q[row, 3] = q4
                q[row, 4] = q5
                q[row, 5] = q6
                status[row] = FREE_JOINT if free1 or free2 or free4 else OK


@_njit(forceinline=True)
def _read(T):
    """Whether T is a pose, and its upper three rows."""
    valid, pose = _read_rows(T)
    px, py, pz = pose[3], pose[7], pose[11]
    return valid and math.isfinite(px) and math.isfinite(py) and math.isfinite(pz), pose


@_inner
def _overshoot(joint, value):
    """How far a joint value is beyond its limits, whole turns aside; negative below."""
    low, high = _LOWEST[joint] + _SLACK[joint], _HIGHEST[joint] - _SLACK[joint]
    if low <= value <= high:
        return 0.0
    gap, over = turn - (high - low), value - high
    rest = over - turn * math.floor(over / turn)
    off = 0.0 if rest >= gap else rest if rest <= gap - rest else rest - gap
    return 0.0 if abs(off) <= 0.5 * _SLACK[joint] else off


@_inner
def _beyond_limits(values):
    """The same of a row."""
    total = 0.0
    for i in range(6):
        total += abs(_overshoot(i, values[i]))
    return total


@_inner
def _without_turns(angle):
    """An angle without its whole turns, by which a search could not tell small moves."""
    return math.copysign(abs(angle) % turn, angle)


_CHOOSABLE = (3, 1, 0,)  # joints, from 0, that may be free


@_inner
def _attempt(pose, seed, search, moved, q, status):
    """Solves with a joint moved: 0 if it serves, else less.

    A search is a row, the joint that had been chosen, whether limits count.
    """
    row, joint = search[0], search[1]
    for i in range(8):
        status[i] = UNREACHABLE
    kept = seed[joint]
    seed[joint] = kept + moved
    _solve(pose, seed, q, status)
    seed[joint] = kept
    return -math.inf if status[row] == UNREACHABLE else -_beyond_limits(q[row])


@_inner
def _peak(pose, seed, search, low, high, q, status):
    """Golden section for the move between low and high that comes nearest, or one that serves."""
    for _ in range(52):
        third = 0.3819660112501051 * (high - low)
        left = _attempt(pose, seed, search, low + third, q, status)
        right = _attempt(pose, seed, search, high - third, q, status)
        if left == 0.0 or right == 0.0:
            return low + third if left == 0.0 else high - third
        if left >= right:
            high -= third
        else:
            low += third
    return low


@_inner
def _summit(pose, seed, search, low, high, q, status):
    """A move between low and high that serves; NaN if there is none."""
    top = _peak(pose, seed, search, low, high, q, status)
    if _attempt(pose, seed, search, top, q, status) == 0.0:
        return top
    return math.nan


@_inner
def _serving(pose, seed, search, q, status):
    """How far the joint has to be moved from the seed's value until it serves; NaN if nowhere.

    A fan of values shows where it serves or nearly so, golden section finds what lies between two
    of them, bisection the end that is nearest to the seed; of two that are equally near the lower
    one.
    """
    if _attempt(pose, seed, search, 0.0, q, status) == 0.0:
        return 0.0
    step, nearest, here = 0.09817477042468103, math.nan, -math.inf
    after = _attempt(pose, seed, search, -32.0 * step, q, status)
    for k in range(-32, 32 + 1):
        before, here = here, after
        after = _attempt(pose, seed, search, (k + 1) * step, q, status)
        outer = k * step
        inner = outer - step if k > 0 else outer + step if k < 0 else 0.0
        if here < 0.0 and here >= before and here > after:
            low, high = outer - step, outer + step
            outer = _summit(pose, seed, search, low, high, q, status)
            if math.isnan(outer):
                continue
        elif here < 0.0 or (before if k > 0 else after) == 0.0:
            continue
        for _ in range(52):
            middle = 0.5 * (inner + outer)
            if _attempt(pose, seed, search, middle, q, status) == 0.0:
                outer = middle
            else:
                inner = middle
        if not abs(outer) >= abs(nearest) - 1e-09:
            nearest = outer
    return nearest


@_inner
def _hopeless(pose, seed, search, q, status):
    """Whether a joint beyond its limits stays where it is when the one that is searched moves."""
    row = search[0]
    if math.isinf(_attempt(pose, seed, search, 0.0, q, status)):
        return False
    values = q[row].copy()
    if math.isinf(_attempt(pose, seed, search, 0.1, q, status)):
        return False
    for i in range(6):
        if abs(values[i] - q[row, i]) < 1e-09 and _overshoot(i, values[i]) != 0.0:
            return True
    return False


@_inner
def _keep_limits(pose, given, row, q, status):
    """A free joint took the seed's value, and that puts one beyond its limits.

    It takes the nearest value that keeps all of them, if there is one. Where several joints are
    free the others take the seed's values as far as their limits allow.
    """
    seed, trial, result = given.copy(), q.copy(), status.copy()
    for i in range(6):
        seed[i] -= _overshoot(i, seed[i])
    for joint in _CHOOSABLE:
        inside, search = seed[joint], (row, joint, True)
        seed[joint] = _without_turns(given[joint])
        if not _hopeless(pose, seed, search, trial, result):
            moved = _serving(pose, seed, search, trial, result)
            # beside the solution of another row this one has none
            start = _attempt(pose, seed, search, 0.0, trial, result)
            own = abs(moved) >= 1e-06 or not math.isinf(start)
            if own and not math.isnan(moved):
                _attempt(pose, seed, search, moved, trial, result)
                for i in range(6):
                    q[row, i] = trial[row, i]
                status[row] = result[row]
                return
        seed[joint] = inside


@_apart("void(UniTuple(float64, 12), float64[::1], float64[:, ::1], uint8[::1])")
def _other_choices(pose, seed, q, status):
    """Other values for free joints, in rows that the seed's do not serve."""
    for row in range(8):
        if status[row] == FREE_JOINT and _beyond_limits(q[row]) > 0.0:
            _keep_limits(pose, seed, row, q, status)


@_inner
def _choose(pose, seed, q, status):
    """The same where there is a row that needs it."""
    served = True
    for row in range(8):
        served = served and not (status[row] == FREE_JOINT and _beyond_limits(q[row]) > 0.0)
    if served:
        return
    # arrays of the caller may have any layout
    values, rows, kinds = np.empty(6), np.empty((8, 6)), np.empty(8, np.uint8)
    for row in range(8):
        kinds[row] = status[row]
        for i in range(6):
            values[i], rows[row, i] = seed[i], q[row, i]
    _other_choices(pose, values, rows, kinds)
    for row in range(8):
        status[row] = kinds[row]
        for i in range(6):
            q[row, i] = rows[row, i]


# What a step of one means for each joint: 1 rad or the arm's size, nothing if the caller gives it.
_PACE = np.array([1.0, 1.0, 1.0, 1.0, 1.0, 1.0])
# What the entries of a miss count, first the translation's: lengths in arm sizes.
_MISS_WEIGHT = np.array([0.3125, 0.3125, 0.3125, 1.0, 1.0, 1.0])


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
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        for c in range(3):
            e[3 + i] += 0.5 * (P[j, c] * T[4 * k + c] - P[k, c] * T[4 * j + c])
            square += 0.5 * (P[j, c] - T[4 * j + c]) ** 2
    return e, math.sqrt(square)


@_inner
def _add_step(held, damping, e, q):
    """Adds the damped least squares step that the miss e asks for to joint values.

    The rows of the Jacobian, each with its share of the damping's root, are made orthogonal one
    after another (modified Gram-Schmidt), twice: once would not do beside singular places.
    """
    J, rows, square = jacobian(q), np.zeros((6, 12)), np.zeros(6)
    for i in range(6):
        for j in range(6):
            rows[i, j] = 0.0 if held[j] else _PACE[j] * _MISS_WEIGHT[i] * J[i, j]
        rows[i, 6 + i] = math.sqrt(damping + 1e-26)
        for n in range(2 * i):
            k, along = n % i, 0.0
            for j in range(12):
                along += rows[k, j] * rows[i, j] / square[k]
            for j in range(12):
                rows[i, j] -= along * rows[k, j]
            e[i] -= along * e[k]
        for j in range(12):
            square[i] += rows[i, j] * rows[i, j]
        for j in range(6):
            q[j] += e[i] / square[i] * rows[i, j] * _PACE[j]


@_inner
def _half_way(x, q, half):
    """How far joint values are from others, but for whole turns [rad, arm sizes].

    Those half way go into half.
    """
    most = 0.0
    for i in range(6):
        off = q[i] - x[i]
        off -= turn * math.floor(off / turn + 0.5)
        most = max(most, abs(off))
        half[i] = x[i] + 0.5 * off
    return most


@_inner
def _past_an_end(joint, value):
    """How far a joint value is beyond its limits as it stands: perhaps it could be turned."""
    low, high = _LOWEST[joint], _HIGHEST[joint]
    if high - low < 6.183185307179587:
        return _overshoot(joint, value)
    off = value - min(max(value, low + _SLACK[joint]), high - _SLACK[joint])
    return 0.0 if abs(off) <= 0.5 * _SLACK[joint] else off


@_inner
def _past_ends(values):
    """How far joints are beyond their limits as they stand."""
    total = 0.0
    for i in range(6):
        total += abs(_past_an_end(i, values[i]))
    return total


@_inner
def _at_an_end(joint, value, seed):
    """A joint value moved by whole turns inside its limits, or next to an end that it is just
    beyond: the one near the seed."""
    near = value + turn * math.floor((seed - value) / turn + 0.5)
    if 0.0 < abs(_past_an_end(joint, near)) < 0.01:
        if abs(near - seed) < 0.15:
            return near
    off = _overshoot(joint, value)
    if off == 0.0 or abs(off) > 0.01:
        return _turned(_JOINTS, joint, value, value)
    return off + (_HIGHEST[joint] - _SLACK[joint] if off > 0.0 else _LOWEST[joint] + _SLACK[joint])


@_apart("boolean(UniTuple(float64, 12), float64, float64, float64[::1])")
def _settled(T, enough, most, q):
    """Takes joint values to some not farther than most that miss the pose by less than enough.

    If enough is NaN, to some inside their limits that miss it hardly more. Returns if it can.
    Damped least squares, while they gain: where roots meet a step still leaves less than half.
    Until one gains little they are damped so that none leads far.
    """
    half = np.empty(6)
    stands, moves = math.isnan(enough), 0
    held, x, settled = np.zeros(6, np.bool_), q.copy(), False
    last, lost = math.inf, 0
    for _ in range(20):
        e, miss = _miss(T, x)
        if math.isnan(enough):
            enough = miss + 1e-14
        worst, past = -1, 0.0
        for j in range(6 if stands and miss < enough else 0):
            off = _past_an_end(j, x[j]) if _PACE[j] > 0.0 else 0.0
            if abs(off) > abs(past):
                worst, past = j, off
        if worst >= 0:  # one at a time: others may follow it inside, or the first one the second
            moves += 1
            if moves == 2:
                held[:] = False
            held[worst], last = True, math.inf
            x[worst] -= past
            e, miss = _miss(T, x)
        if miss < enough:
            for i in range(6):
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
    values = np.empty(6)
    for i in range(6):
        values[i] = q[i]
    settled = _settled(pose, enough, most, values)
    for i in range(6):
        q[i] = values[i]
    return settled


@_inner
def _lead_inside(pose, enough, most, q):
    """Takes joint values onto the ends that they are beyond, or else inside.

    Two of them may not be able to stand on their ends at once.
    """
    if _settle(pose, enough, most, q):
        return True
    past = 0
    for i in range(6):
        past += _past_an_end(i, q[i]) != 0.0
    if past < 2:
        return False
    x, enough = q.copy(), _miss(pose, q)[1] + 1e-14
    farther = 2.0
    while farther <= 16.0:
        for i in range(6):
            x[i] = q[i] - farther * _past_an_end(i, q[i])
        farther *= 2.0
        if _settle(pose, enough, most, x) and _past_ends(x) == 0.0:
            for i in range(6):
                q[i] = x[i]
            return True
    return False


@_inner
def _stand(pose, row, far, rows, status):
    """Puts a row's joints just beyond their limits on them, unless that is another solution; those
    that are far beyond them, too, if that is asked for. Returns if it did.

    Half way to the same there is one, and what is nearer to another row that is less far beyond is
    that one's.
    """
    q = rows[row]
    beyond = _past_ends(q)
    if not (0.0 < beyond and (far or beyond < 0.01)):
        return False
    x, half, to = q.copy(), np.empty(6), np.empty(6)
    if not _lead_inside(pose, math.nan, math.inf if far else 1.5, x):
        return False
    off = _half_way(q, x, half)
    for k in range(len(rows)):
        if status[k] != UNREACHABLE and _past_ends(rows[k]) < beyond:
            if _half_way(rows[k], x, to) < off:
                return False
    if off >= 0.001 and not _settle(pose, 1e-12, 0.25 * off, half):
        return False
    for i in range(6):
        q[i] = x[i]
    return True


@_inner
def _stay(pose, seed, q, status):
    """Where rounding can't tell solutions apart the arm goes on with the one that it is at.

    The solution next to the seed gets a row unless it has one: that of one beside
    it, that of one which it is told from by nothing, one that is left, or any.
    """
    x, half, place, least = np.empty(6), np.empty(6), 0, math.inf
    nearest = 0.001
    for i in range(6):
        here = seed[i]
        if abs(_past_an_end(i, here)) > 0.15:
            here = _turned(_JOINTS, i, here, here)
        x[i] = here - _past_an_end(i, here)
    if not _settle(pose, 1e-12, 0.15, x):
        return
    if _past_ends(x) > 1e-09 and not _lead_inside(pose, math.nan, 0.15, x):
        return
    for row in range(8 - 1, -1, -1):
        between = 1e-06
        if status[row] != UNREACHABLE:
            off = _half_way(x, q[row], half)
            between = max(_miss(pose, half)[1], 1e-12) if off >= 0.001 else 0.0
            if off < nearest:
                place, nearest, least = row, off, -1.0  # its own
        if between <= 2.0 * least:
            place = row
        least = min(least, between)
    if least >= 0.0:
        status[place] = FREE_JOINT
    if nearest > 1e-06 or _past_ends(q[place]) > 0.0:
        for i in range(6):
            q[place, i] = x[i]


@_jit
def _whole(pose, seed, q, status):
    """Any pose, singular ones too, into q and status; how many rows are OK or FREE_JOINT."""
    for row in range(8):
        status[row] = UNREACHABLE
        for i in range(6):
            q[row, i] = math.nan
    _solve(pose, seed, q, status)
    _choose(pose, seed, q, status)
    for row in range(8):
        if status[row] != UNREACHABLE:
            for i in range(6):
                q[row, i] = _at_an_end(i, q[row, i], seed[i])
    _stay(pose, seed, q, status)
    count = 0
    for n in range(2 * 8):
        row, far = n % 8, n >= 8  # far where no row is inside all limits
        if status[row] == UNREACHABLE or (far and count > 0):
            continue
        if _stand(pose, row, far, q, status) and far:
            status[row] = FREE_JOINT
        for i in range(6):
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
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose
    room = carray(_room(48), 48)

    # theta1, type 2: U1[2, 4]
    t14 = T14 - d6 * T13
    Y1 = d6 * T23 - T24
    v1 = t14 * t14 + Y1 * Y1
    w1 = math.sqrt(v1)
    v2 = 1.0 / v1

    # theta3, type 6: U1[3, 4] and U1[1, 4]
    Z1_3 = T34 - d6 * T33 - d1
    v3 = a1 + w1
    v4 = a1 - w1
    v5 = Z1_3 * Z1_3
    N3_p = v5 + v3 * v3
    N3_m = v5 + v4 * v4
    D3_p = (longest3 - N3_p) * (N3_p - shortest3)
    D3_m = (longest3 - N3_m) * (N3_m - shortest3)
    w3_p = math.sqrt(D3_p)
    w3_m = math.sqrt(D3_m)

    # theta2, type 3: U1[1, 4] and U1[3, 4]
    X1_2_p = m4 * N3_p - m5
    X1_2_m = m4 * N3_m - m5
    v8 = v3 * X1_2_p
    v9 = v4 * X1_2_m
    v10 = m4 * Z1_3
    v11 = m4 * -Z1_3
    v12 = Z1_3 * X1_2_p
    v13 = Z1_3 * X1_2_m
    factor2_p = 1.0 / N3_p
    factor2_m = 1.0 / N3_m
    v14 = w3_p * (m4 * v3)

    # theta4, type 2: U4[2, 3]
    v15 = m6 * Z1_3
    v16 = m7 + m8 * factor2_p
    v17 = m7 + m8 * factor2_m
    v18 = m6 + m9 * factor2_p
    v19 = m6 + m9 * factor2_m
    v20 = Z1_3 * v16 - v3 * v18
    v21 = Z1_3 * v17 - v4 * v19
    v22 = w3_p * (factor2_p * (v15 + m7 * v3))
    c23_pp = v20 + v22
    c23_pm = v20 - v22
    v23 = w3_m * (factor2_m * (v15 + m7 * v4))
    c23_mp = v21 + v23
    c23_mm = v21 - v23
    v24 = m7 * Z1_3
    v25 = v24 - m6 * v3
    v26 = v24 - m6 * v4
    v27 = Z1_3 * v18 + v3 * v16
    v28 = Z1_3 * v19 + v4 * v17
    s23_pp = w3_p * (factor2_p * v25) - v27
    s23_pm = w3_p * (factor2_p * -v25) - v27
    s23_mp = w3_m * (factor2_m * v26) - v28
    s23_mm = w3_m * (factor2_m * -v26) - v28
    v29 = w1 * (v2 * (T23 * Y1 - T13 * t14))
    X4_pp = T33 * c23_pp + s23_pp * v29
    X4_pm = T33 * c23_pm + s23_pm * v29
    X4_mp = T33 * c23_mp - s23_mp * v29
    X4_mm = T33 * c23_mm - s23_mm * v29
    v30 = w1 * (v2 * (T13 * Y1 + t14 * T23))
    v31 = v30 * v30
    v32 = v31 + X4_pp * X4_pp
    v33 = v31 + X4_pm * X4_pm
    v34 = v31 + X4_mp * X4_mp
    v35 = v31 + X4_mm * X4_mm
    v36 = math.copysign(half_turn, -v30)
    v37 = math.copysign(half_turn, v30)

    # theta6, type 3: U4[2, 2] and U4[2, 1]
    v38 = w1 * (v2 * (t14 * T22 + Y1 * T12))
    v39 = w1 * (v2 * (Y1 * T22 - t14 * T12))
    v40 = w1 * (v2 * (t14 * T21 + Y1 * T11))
    v41 = w1 * (v2 * (Y1 * T21 - t14 * T11))
    v42 = X4_pp * v40 - v30 * (c23_pp * T31 + s23_pp * v41)
    v43 = X4_pm * v40 - v30 * (c23_pm * T31 + s23_pm * v41)
    v44 = v30 * (c23_mp * T31 - s23_mp * v41) - X4_mp * v40
    v45 = v30 * (c23_mm * T31 - s23_mm * v41) - X4_mm * v40

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if (
        v35 <= m10 or v34 <= m10 or v33 <= m10 or v32 <= m10 or abs(D3_m) <= m3 or v1 <= m1 or
        abs(D3_p) <= m3
    ):
        return False

    # angles, side by side
    room[0] = Y1
    room[1] = w3_p
    room[2] = w3_m
    room[3] = -(v8 + w3_p * v10)
    room[4] = -(v8 + w3_p * v11)
    room[5] = -(v9 + w3_m * v10)
    room[6] = -(v9 + w3_m * v11)
    room[7] = -v30
    room[8] = -v30
    room[9] = v30
    room[10] = v30
    room[11] = math.sqrt(v32)
    room[12] = math.sqrt(v33)
    room[13] = math.sqrt(v34)
    room[14] = math.sqrt(v35)
    room[15] = v42
    room[16] = v43
    room[17] = v44
    room[18] = v45
    room[24] = -t14
    room[25] = N3_p - k3
    room[26] = N3_m - k3
    room[27] = v12 - v14
    room[28] = v12 + v14
    room[29] = v13 - w3_m * (m4 * v4)
    room[30] = v13 - w3_m * (m4 * -v4)
    room[31] = -X4_pp
    room[32] = -X4_pm
    room[33] = -X4_mp
    room[34] = -X4_mm
    room[35] = c23_pp * v29 - T33 * s23_pp
    room[36] = c23_pm * v29 - T33 * s23_pm
    room[37] = -(c23_mp * v29 + T33 * s23_mp)
    room[38] = -(c23_mm * v29 + T33 * s23_mm)
    room[39] = X4_pp * v38 - v30 * (c23_pp * T32 + s23_pp * v39)
    room[40] = X4_pm * v38 - v30 * (c23_pm * T32 + s23_pm * v39)
    room[41] = v30 * (c23_mp * T32 - s23_mp * v39) - X4_mp * v38
    room[42] = v30 * (c23_mm * T32 - s23_mm * v39) - X4_mm * v38
    for k in range(19, 24):
        room[k] = room[k + 24] = 1.0
    for k in range(24):
        room[k] = _atan2(room[k], room[k + 24])
    angle1 = room[0]
    angle2 = room[1]
    angle3 = room[2]
    angle4 = room[3]
    angle5 = room[4]
    angle6 = room[5]
    angle7 = room[6]
    angle8 = room[7]
    angle9 = room[8]
    angle10 = room[9]
    angle11 = room[10]
    angle12 = room[11]
    angle13 = room[12]
    angle14 = room[13]
    angle15 = room[14]
    angle16 = room[15]
    angle17 = room[16]
    angle18 = room[17]
    angle19 = room[18]

    # theta3, type 6: U1[3, 4] and U1[1, 4]
    q3__pp = angle2 - turn1
    v6 = turn1 + angle2
    q3__mp = angle3 - turn1
    v7 = turn1 + angle3

    # theta4, type 2: U4[2, 3]
    q4_ppm = angle8 - v36
    q4_pmm = angle9 - v36
    q4_mpm = angle10 - v37
    q4_mmm = angle11 - v37

    # theta6, type 3: U4[2, 2] and U4[2, 1]
    q6_ppm = angle16 - math.copysign(half_turn, v42)
    q6_pmm = angle17 - math.copysign(half_turn, v43)
    q6_mpm = angle18 - math.copysign(half_turn, v44)
    q6_mmm = angle19 - math.copysign(half_turn, v45)

    # joint values
    v46 = q3__pp + (turn if q3__pp <= -half_turn else 0.0)
    v47 = (turn if -v6 <= -half_turn else 0.0) - v6
    v48 = q3__mp + (turn if q3__mp <= -half_turn else 0.0)
    v49 = (turn if -v7 <= -half_turn else 0.0) - v7
    v50 = v46 - (turn if high3 < v46 else 0.0)
    v51 = v47 - (turn if high3 < v47 else 0.0)
    v52 = v48 - (turn if high3 < v48 else 0.0)
    v53 = v49 - (turn if high3 < v49 else 0.0)
    v54 = max(low3 - v50, v50 - high3)
    v55 = max(low3 - v51, v51 - high3)
    v56 = max(low3 - v52, v52 - high3)
    v57 = max(low3 - v53, v53 - high3)
    v58 = v46 - high3
    v59 = v47 - high3
    v60 = v48 - high3
    v61 = v49 - high3
    v62 = v58 if v58 < v54 else v54
    v63 = v59 if v59 < v55 else v55
    v64 = v60 if v60 < v56 else v56
    v65 = v61 if v61 < v57 else v57
    q3_ppp = v46 if 0.0 < v62 else v50
    q3_pmp = v47 if 0.0 < v63 else v51
    q3_mpp = v48 if 0.0 < v64 else v52
    q3_mmp = v49 if 0.0 < v65 else v53
    q1_ppp = angle1 + (w3_p - w3_p)
    q1_mpp = angle1 - math.copysign(half_turn, Y1) + (w3_m - w3_m)
    v66 = max(v62, max(low2 - angle4, angle4 - high2))
    v67 = max(v63, max(low2 - angle5, angle5 - high2))
    v68 = max(v64, max(low2 - angle6, angle6 - high2))
    v69 = max(v65, max(low2 - angle7, angle7 - high2))
    excess_ppp = max(v66, max(low5 - angle12, angle12 - high5))
    excess_ppm = max(v66, max(low5 + angle12, -(high5 + angle12)))
    excess_pmp = max(v67, max(low5 - angle13, angle13 - high5))
    excess_pmm = max(v67, max(low5 + angle13, -(high5 + angle13)))
    excess_mpp = max(v68, max(low5 - angle14, angle14 - high5))
    excess_mpm = max(v68, max(low5 + angle14, -(high5 + angle14)))
    excess_mmp = max(v69, max(low5 - angle15, angle15 - high5))
    excess_mmm = max(v69, max(low5 + angle15, -(high5 + angle15)))
    outside_ppp = 0.0 < excess_ppp
    outside_ppm = 0.0 < excess_ppm
    outside_pmp = 0.0 < excess_pmp
    outside_pmm = 0.0 < excess_pmm
    outside_mpp = 0.0 < excess_mpp
    outside_mpm = 0.0 < excess_mpm
    outside_mmp = 0.0 < excess_mmp
    outside_mmm = 0.0 < excess_mmm

    # a joint is free, branches meet, or rounding tells what is beyond a limit
    if (
        abs(excess_mmm - graze) <= graze or abs(excess_mmp - graze) <= graze or abs(excess_mpm -
        graze) <= graze or abs(excess_mpp - graze) <= graze or abs(excess_pmm - graze) <= graze or
        abs(excess_pmp - graze) <= graze or abs(excess_ppp - graze) <= graze or abs(excess_ppm -
        graze) <= graze
    ):
        return False

    q[0, 0] = q1_ppp
    q[0, 1] = angle4
    q[0, 2] = q3_ppp
    q[0, 3] = angle8
    q[0, 4] = angle12
    q[0, 5] = angle16
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else (OUT_OF_LIMITS if outside_ppp else OK)
    q[1, 0] = q1_ppp
    q[1, 1] = angle4
    q[1, 2] = q3_ppp
    q[1, 3] = q4_ppm
    q[1, 4] = -angle12
    q[1, 5] = q6_ppm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else (OUT_OF_LIMITS if outside_ppm else OK)
    q[2, 0] = q1_ppp
    q[2, 1] = angle5
    q[2, 2] = q3_pmp
    q[2, 3] = angle9
    q[2, 4] = angle13
    q[2, 5] = angle17
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else (OUT_OF_LIMITS if outside_pmp else OK)
    q[3, 0] = q1_ppp
    q[3, 1] = angle5
    q[3, 2] = q3_pmp
    q[3, 3] = q4_pmm
    q[3, 4] = -angle13
    q[3, 5] = q6_pmm
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else (OUT_OF_LIMITS if outside_pmm else OK)
    q[4, 0] = q1_mpp
    q[4, 1] = angle6
    q[4, 2] = q3_mpp
    q[4, 3] = angle10
    q[4, 4] = angle14
    q[4, 5] = angle18
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else (OUT_OF_LIMITS if outside_mpp else OK)
    q[5, 0] = q1_mpp
    q[5, 1] = angle6
    q[5, 2] = q3_mpp
    q[5, 3] = q4_mpm
    q[5, 4] = -angle14
    q[5, 5] = q6_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else (OUT_OF_LIMITS if outside_mpm else OK)
    q[6, 0] = q1_mpp
    q[6, 1] = angle7
    q[6, 2] = q3_mmp
    q[6, 3] = angle11
    q[6, 4] = angle15
    q[6, 5] = angle19
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else (OUT_OF_LIMITS if outside_mmp else OK)
    q[7, 0] = q1_mpp
    q[7, 1] = angle7
    q[7, 2] = q3_mmp
    q[7, 3] = q4_mmm
    q[7, 4] = -angle15
    q[7, 5] = q6_mmm
    status[7] = UNREACHABLE if q[7, 0] != q[7, 0] else (OUT_OF_LIMITS if outside_mmm else OK)
    return True


@_merged
def _into(T, seed, q, status):
    """All solutions into q and status; how many rows are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (8, 6) or status.shape != (8,):
        raise ValueError("T, q and status must have shapes (4, 4), (8, 6), (8,)")
    valid, pose = _read(T)
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    if _COMPILED and _regular(pose, q, status):
        count = 0
        for row in range(8):
            count += status[row] == OK
        return count
    return _whole(pose, seed, q, status)


# Where in a tile the rows' values and statuses begin.
_PLACES = np.array([
    [1136, 1152, 1168, 1184, 1200, 1216],
    [1136, 1152, 1168, 1232, 1248, 1264],
    [1136, 1280, 1296, 1312, 1328, 1344],
    [1136, 1280, 1296, 1360, 1376, 1392],
    [1408, 1424, 1440, 1456, 1472, 1488],
    [1408, 1424, 1440, 1504, 1520, 1536],
    [1408, 1552, 1568, 1584, 1600, 1616],
    [1408, 1552, 1568, 1632, 1648, 1664],
])
_KINDS = np.array([1680, 1696, 1712, 1728, 1744, 1760, 1776, 1792])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(1808), 1808)
    work[:] = 0.0  # the last tile may be half full
    for first in range(0, len(T), 16):
        count = min(16, len(T) - first)
        for k in range(count):
            for i in range(4):
                for j in range(4):
                    work[(4 * i + j) * 16 + k] = T[first + k, i, j]
        for k in range(16):
            x0, x1, x2 = work[0 + k], work[16 + k], work[32 + k]
            y0, y1, y2 = work[64 + k], work[80 + k], work[96 + k]
            z0, z1, z2 = work[128 + k], work[144 + k], work[160 + k]
            xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0
            yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0
            xy = x0 * y0 + x1 * y1 + x2 * y2
            u, v, w = x1 * y2 - x2 * y1 - z0, x2 * y0 - x0 * y2 - z1, x0 * y1 - x1 * y0 - z2
            rest = abs(work[192 + k]) + abs(work[208 + k]) + abs(work[224 + k])
            miss = (
                xx * xx + yy * yy + 2.0 * xy * xy + u * u + v * v + w * w + rest + abs(work[240 + k]
                - 1.0) + 0.0 * (work[48 + k] + work[112 + k] + work[176 + k])
            )
            exact = miss <= 1e-24
            work[256 + k] = 0.0 if exact else 1.0
        for k in range(0, 16):
            T11 = work[0 + k]
            T12 = work[16 + k]
            T13 = work[32 + k]
            T14 = work[48 + k]
            T21 = work[64 + k]
            T22 = work[80 + k]
            T23 = work[96 + k]
            T24 = work[112 + k]
            T31 = work[128 + k]
            T32 = work[144 + k]
            T33 = work[160 + k]
            T34 = work[176 + k]
            t14 = T14 - d6 * T13
            Y1 = d6 * T23 - T24
            v1 = t14 * t14 + Y1 * Y1
            w1 = math.sqrt(v1)
            v2 = 1.0 / v1
            Z1_3 = T34 - d6 * T33 - d1
            v3 = a1 + w1
            v4 = a1 - w1
            v5 = Z1_3 * Z1_3
            N3_p = v5 + v3 * v3
            N3_m = v5 + v4 * v4
            D3_p = (longest3 - N3_p) * (N3_p - shortest3)
            D3_m = (longest3 - N3_m) * (N3_m - shortest3)
            w3_p = math.sqrt(D3_p)
            w3_m = math.sqrt(D3_m)
            X1_2_p = m4 * N3_p - m5
            X1_2_m = m4 * N3_m - m5
            v8 = v3 * X1_2_p
            v9 = v4 * X1_2_m
            v10 = m4 * Z1_3
            v11 = m4 * -Z1_3
            v12 = Z1_3 * X1_2_p
            v13 = Z1_3 * X1_2_m
            factor2_p = 1.0 / N3_p
            factor2_m = 1.0 / N3_m
            v14 = w3_p * (m4 * v3)
            v15 = m6 * Z1_3
            v16 = m7 + m8 * factor2_p
            v17 = m7 + m8 * factor2_m
            v18 = m6 + m9 * factor2_p
            v19 = m6 + m9 * factor2_m
            v20 = Z1_3 * v16 - v3 * v18
            v21 = Z1_3 * v17 - v4 * v19
            v22 = w3_p * (factor2_p * (v15 + m7 * v3))
            c23_pp = v20 + v22
            c23_pm = v20 - v22
            v23 = w3_m * (factor2_m * (v15 + m7 * v4))
            c23_mp = v21 + v23
            c23_mm = v21 - v23
            v24 = m7 * Z1_3
            v25 = v24 - m6 * v3
            v26 = v24 - m6 * v4
            v27 = Z1_3 * v18 + v3 * v16
            v28 = Z1_3 * v19 + v4 * v17
            s23_pp = w3_p * (factor2_p * v25) - v27
            s23_pm = w3_p * (factor2_p * -v25) - v27
            s23_mp = w3_m * (factor2_m * v26) - v28
            s23_mm = w3_m * (factor2_m * -v26) - v28
            v29 = w1 * (v2 * (T23 * Y1 - T13 * t14))
            X4_pp = T33 * c23_pp + s23_pp * v29
            X4_pm = T33 * c23_pm + s23_pm * v29
            X4_mp = T33 * c23_mp - s23_mp * v29
            X4_mm = T33 * c23_mm - s23_mm * v29
            v30 = w1 * (v2 * (T13 * Y1 + t14 * T23))
            v31 = v30 * v30
            v32 = v31 + X4_pp * X4_pp
            v33 = v31 + X4_pm * X4_pm
            v34 = v31 + X4_mp * X4_mp
            v35 = v31 + X4_mm * X4_mm
            v36 = math.copysign(half_turn, -v30)
            v37 = math.copysign(half_turn, v30)
            v38 = w1 * (v2 * (t14 * T22 + Y1 * T12))
            v39 = w1 * (v2 * (Y1 * T22 - t14 * T12))
            v40 = w1 * (v2 * (t14 * T21 + Y1 * T11))
            v41 = w1 * (v2 * (Y1 * T21 - t14 * T11))
            v42 = X4_pp * v40 - v30 * (c23_pp * T31 + s23_pp * v41)
            v43 = X4_pm * v40 - v30 * (c23_pm * T31 + s23_pm * v41)
            v44 = v30 * (c23_mp * T31 - s23_mp * v41) - X4_mp * v40
            v45 = v30 * (c23_mm * T31 - s23_mm * v41) - X4_mm * v40
            work[272 + k] = Y1
            work[288 + k] = v1
            work[304 + k] = D3_p
            work[320 + k] = D3_m
            work[336 + k] = w3_p
            work[352 + k] = w3_m
            work[368 + k] = v32
            work[384 + k] = v33
            work[400 + k] = v34
            work[416 + k] = v35
            work[432 + k] = v36
            work[448 + k] = v37
            work[464 + k] = v42
            work[480 + k] = v43
            work[496 + k] = v44
            work[512 + k] = v45
            work[528 + k] = Y1
            work[544 + k] = w3_p
            work[560 + k] = w3_m
            work[576 + k] = -(v8 + w3_p * v10)
            work[592 + k] = -(v8 + w3_p * v11)
            work[608 + k] = -(v9 + w3_m * v10)
            work[624 + k] = -(v9 + w3_m * v11)
            work[640 + k] = -v30
            work[656 + k] = -v30
            work[672 + k] = v30
            work[688 + k] = v30
            work[704 + k] = math.sqrt(v32)
            work[720 + k] = math.sqrt(v33)
            work[736 + k] = math.sqrt(v34)
            work[752 + k] = math.sqrt(v35)
            work[768 + k] = v42
            work[784 + k] = v43
            work[800 + k] = v44
            work[816 + k] = v45
            work[832 + k] = -t14
            work[848 + k] = N3_p - k3
            work[864 + k] = N3_m - k3
            work[880 + k] = v12 - v14
            work[896 + k] = v12 + v14
            work[912 + k] = v13 - w3_m * (m4 * v4)
            work[928 + k] = v13 - w3_m * (m4 * -v4)
            work[944 + k] = -X4_pp
            work[960 + k] = -X4_pm
            work[976 + k] = -X4_mp
            work[992 + k] = -X4_mm
            work[1008 + k] = c23_pp * v29 - T33 * s23_pp
            work[1024 + k] = c23_pm * v29 - T33 * s23_pm
            work[1040 + k] = -(c23_mp * v29 + T33 * s23_mp)
            work[1056 + k] = -(c23_mm * v29 + T33 * s23_mm)
            work[1072 + k] = X4_pp * v38 - v30 * (c23_pp * T32 + s23_pp * v39)
            work[1088 + k] = X4_pm * v38 - v30 * (c23_pm * T32 + s23_pm * v39)
            work[1104 + k] = v30 * (c23_mp * T32 - s23_mp * v39) - X4_mp * v38
            work[1120 + k] = v30 * (c23_mm * T32 - s23_mm * v39) - X4_mm * v38
        for k in range(528, 832):
            work[k] = _atan2(work[k], work[k + 304])
        for k in range(0, 16):
            Y1 = work[272 + k]
            v1 = work[288 + k]
            D3_p = work[304 + k]
            D3_m = work[320 + k]
            w3_p = work[336 + k]
            w3_m = work[352 + k]
            v32 = work[368 + k]
            v33 = work[384 + k]
            v34 = work[400 + k]
            v35 = work[416 + k]
            v36 = work[432 + k]
            v37 = work[448 + k]
            v42 = work[464 + k]
            v43 = work[480 + k]
            v44 = work[496 + k]
            v45 = work[512 + k]
            angle1 = work[528 + k]
            angle2 = work[544 + k]
            angle3 = work[560 + k]
            angle4 = work[576 + k]
            angle5 = work[592 + k]
            angle6 = work[608 + k]
            angle7 = work[624 + k]
            angle8 = work[640 + k]
            angle9 = work[656 + k]
            angle10 = work[672 + k]
            angle11 = work[688 + k]
            angle12 = work[704 + k]
            angle13 = work[720 + k]
            angle14 = work[736 + k]
            angle15 = work[752 + k]
            angle16 = work[768 + k]
            angle17 = work[784 + k]
            angle18 = work[800 + k]
            angle19 = work[816 + k]
            q3__pp = angle2 - turn1
            v6 = turn1 + angle2
            q3__mp = angle3 - turn1
            v7 = turn1 + angle3
            q4_ppm = angle8 - v36
            q4_pmm = angle9 - v36
            q4_mpm = angle10 - v37
            q4_mmm = angle11 - v37
            q6_ppm = angle16 - math.copysign(half_turn, v42)
            q6_pmm = angle17 - math.copysign(half_turn, v43)
            q6_mpm = angle18 - math.copysign(half_turn, v44)
            q6_mmm = angle19 - math.copysign(half_turn, v45)
            v46 = q3__pp + (turn if q3__pp <= -half_turn else 0.0)
            v47 = (turn if -v6 <= -half_turn else 0.0) - v6
            v48 = q3__mp + (turn if q3__mp <= -half_turn else 0.0)
            v49 = (turn if -v7 <= -half_turn else 0.0) - v7
            v50 = v46 - (turn if high3 < v46 else 0.0)
            v51 = v47 - (turn if high3 < v47 else 0.0)
            v52 = v48 - (turn if high3 < v48 else 0.0)
            v53 = v49 - (turn if high3 < v49 else 0.0)
            v54 = max(low3 - v50, v50 - high3)
            v55 = max(low3 - v51, v51 - high3)
            v56 = max(low3 - v52, v52 - high3)
            v57 = max(low3 - v53, v53 - high3)
            v58 = v46 - high3
            v59 = v47 - high3
            v60 = v48 - high3
            v61 = v49 - high3
            v62 = v58 if v58 < v54 else v54
            v63 = v59 if v59 < v55 else v55
            v64 = v60 if v60 < v56 else v56
            v65 = v61 if v61 < v57 else v57
            q3_ppp = v46 if 0.0 < v62 else v50
            q3_pmp = v47 if 0.0 < v63 else v51
            q3_mpp = v48 if 0.0 < v64 else v52
            q3_mmp = v49 if 0.0 < v65 else v53
            q1_ppp = angle1 + (w3_p - w3_p)
            q1_mpp = angle1 - math.copysign(half_turn, Y1) + (w3_m - w3_m)
            v66 = max(v62, max(low2 - angle4, angle4 - high2))
            v67 = max(v63, max(low2 - angle5, angle5 - high2))
            v68 = max(v64, max(low2 - angle6, angle6 - high2))
            v69 = max(v65, max(low2 - angle7, angle7 - high2))
            excess_ppp = max(v66, max(low5 - angle12, angle12 - high5))
            excess_ppm = max(v66, max(low5 + angle12, -(high5 + angle12)))
            excess_pmp = max(v67, max(low5 - angle13, angle13 - high5))
            excess_pmm = max(v67, max(low5 + angle13, -(high5 + angle13)))
            excess_mpp = max(v68, max(low5 - angle14, angle14 - high5))
            excess_mpm = max(v68, max(low5 + angle14, -(high5 + angle14)))
            excess_mmp = max(v69, max(low5 - angle15, angle15 - high5))
            excess_mmm = max(v69, max(low5 + angle15, -(high5 + angle15)))
            outside_ppp = 0.0 < excess_ppp
            outside_ppm = 0.0 < excess_ppm
            outside_pmp = 0.0 < excess_pmp
            outside_pmm = 0.0 < excess_pmm
            outside_mpp = 0.0 < excess_mpp
            outside_mpm = 0.0 < excess_mpm
            outside_mmp = 0.0 < excess_mmp
            outside_mmm = 0.0 < excess_mmm
            _1136 = q1_ppp
            work[1136 + k] = _1136
            _1152 = angle4
            work[1152 + k] = _1152
            _1168 = q3_ppp
            work[1168 + k] = _1168
            _1184 = angle8
            work[1184 + k] = _1184
            _1200 = angle12
            work[1200 + k] = _1200
            _1216 = angle16
            work[1216 + k] = _1216
            _1232 = q4_ppm
            work[1232 + k] = _1232
            _1248 = -angle12
            work[1248 + k] = _1248
            _1264 = q6_ppm
            work[1264 + k] = _1264
            _1280 = angle5
            work[1280 + k] = _1280
            _1296 = q3_pmp
            work[1296 + k] = _1296
            _1312 = angle9
            work[1312 + k] = _1312
            _1328 = angle13
            work[1328 + k] = _1328
            _1344 = angle17
            work[1344 + k] = _1344
            _1360 = q4_pmm
            work[1360 + k] = _1360
            _1376 = -angle13
            work[1376 + k] = _1376
            _1392 = q6_pmm
            work[1392 + k] = _1392
            _1408 = q1_mpp
            work[1408 + k] = _1408
            _1424 = angle6
            work[1424 + k] = _1424
            _1440 = q3_mpp
            work[1440 + k] = _1440
            _1456 = angle10
            work[1456 + k] = _1456
            _1472 = angle14
            work[1472 + k] = _1472
            _1488 = angle18
            work[1488 + k] = _1488
            _1504 = q4_mpm
            work[1504 + k] = _1504
            _1520 = -angle14
            work[1520 + k] = _1520
            _1536 = q6_mpm
            work[1536 + k] = _1536
            _1552 = angle7
            work[1552 + k] = _1552
            _1568 = q3_mmp
            work[1568 + k] = _1568
            _1584 = angle11
            work[1584 + k] = _1584
            _1600 = angle15
            work[1600 + k] = _1600
            _1616 = angle19
            work[1616 + k] = _1616
            _1632 = q4_mmm
            work[1632 + k] = _1632
            _1648 = -angle15
            work[1648 + k] = _1648
            _1664 = q6_mmm
            work[1664 + k] = _1664
            work[1680 + k] = (
                UNREACHABLE if _1136 != _1136 else (OUT_OF_LIMITS if outside_ppp else OK)
            )
            work[1696 + k] = (
                UNREACHABLE if _1136 != _1136 else (OUT_OF_LIMITS if outside_ppm else OK)
            )
            work[1712 + k] = (
                UNREACHABLE if _1136 != _1136 else (OUT_OF_LIMITS if outside_pmp else OK)
            )
            work[1728 + k] = (
                UNREACHABLE if _1136 != _1136 else (OUT_OF_LIMITS if outside_pmm else OK)
            )
            work[1744 + k] = (
                UNREACHABLE if _1408 != _1408 else (OUT_OF_LIMITS if outside_mpp else OK)
            )
            work[1760 + k] = (
                UNREACHABLE if _1408 != _1408 else (OUT_OF_LIMITS if outside_mpm else OK)
            )
            work[1776 + k] = (
                UNREACHABLE if _1408 != _1408 else (OUT_OF_LIMITS if outside_mmp else OK)
            )
            work[1792 + k] = (
                UNREACHABLE if _1408 != _1408 else (OUT_OF_LIMITS if outside_mmm else OK)
            )
            work[256 + k] = (
                1.0 if v35 <= m10 or v34 <= m10 or v33 <= m10 or v32 <= m10 or abs(D3_m) <= m3 or v1
                <= m1 or abs(D3_p) <= m3 else work[256 + k]
            )
            work[256 + k] = (
                1.0 if abs(excess_mmm - graze) <= graze or abs(excess_mmp - graze) <= graze or
                abs(excess_mpm - graze) <= graze or abs(excess_mpp - graze) <= graze or
                abs(excess_pmm - graze) <= graze or abs(excess_pmp - graze) <= graze or
                abs(excess_ppp - graze) <= graze or abs(excess_ppm - graze) <= graze else work[256 +
                k]
            )
        for k in range(first, first + count):
            if work[256 + k - first] != 0.0:
                _unseeded(T[k], q[k], status[k])
                continue
            for row in range(8):
                status[k, row] = np.uint8(work[_KINDS[row] + k - first])
                for i in range(6):
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
            "no_pose": "not finite, or not a right-handed rotation to six digits, or its last row not 0, 0, 0, 1 (is it transposed?)",
            "no_row": "the pose is out of reach",
            "allocates": "only where a pose is singular or rounded",
        },
    ),
)
_unseeded = _CALLS["unseeded"]
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
