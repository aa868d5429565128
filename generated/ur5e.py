"""ur5e: Universal Robots UR5e.

Inverse kinematics, generated from robots/ur5e.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/ur5e.yaml. The formulas and where they come from: ur5e.md.

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
_wrap = _runtime("angles").wrap
_read_rows = _runtime("pose").read_pose
_of_joints = _runtime("entry").of_joints(_HOW, 6)

NAME = "ur5e"
METHOD = "closed form"
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
    "right-noflip-down",
    "right-noflip-up",
    "right-flip-down",
    "right-flip-up",
    "left-noflip-up",
    "left-noflip-down",
    "left-flip-up",
    "left-flip-down",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.1625  # joint offset 1 [m]
a2 = -0.425  # link length 2 [m]
a3 = -0.3922  # link length 3 [m]
d4 = 0.1333  # joint offset 4 [m]
d5 = 0.0997  # joint offset 5 [m]
d6 = 0.0996  # joint offset 6 [m]
free_limit_squared2 = 1.7221312899999994e-24  # square of a length that fixes no angle [m^2]
least_root1 = 4.149856973438963e-07  # a root of nothing, by rounding [m]
free_limit = 1e-12  # a length that fixes no angle
near_limit = 0.001  # a length whose direction is good to few digits
longest3 = 0.6678158399999998  # square of the longest reach [m^2]
shortest3 = 0.0010758399999999998  # square of the shortest reach [m^2]
boundary3 = 1.4301245521157901e-13  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.6678158399999785  # the longest, where branches merge [m^2]
shortest3_apart = 0.0010758400000008604  # the shortest, where branches merge [m^2]
longest3_clear = 0.6678158399785518  # the longest, where blurred branches do [m^2]
shortest3_clear = 0.0010758400008608687  # the shortest, where blurred branches do [m^2]
k1 = 0.01776889  # d4^2 [m^2]
k2 = 3.4985918000017217e-14  # reach_slack1 * (2 * d4 + reach_slack1) [m^2]
k3 = 3.4985918000001716e-15  # merge_slack1 * (2 * d4 + merge_slack1) [m^2]
k4 = 0.762020879372095  # 1 / arm_size1 [m^-1]
k5 = 0.33444584  # a2^2 + a3^2 [m^2]
k6 = 2.9996700362960076  # 1 / (2 * a3 * a2) [m^-2]
m1 = 3.4985918000001714e-12  # 1000 * k3 [m^2]
m2 = 9.999999999999999e-09  # doubt_limit^2
m4 = 1.4300283221564012e-10  # 10 * (longest3 - longest3_clear) * (longest3_clear - shortest3) [m^4]
m5 = 1.1764705882352942  # a coefficient of S2
m6 = 0.031534305882352925  # a coefficient of S2

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
    y3_z = c2 * c3 - s2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - v3 * s4
    x4_y = x3_y * c4 - v4 * s4
    x4_z = x3_z * c4 + y3_z * s4
    z4_x = v3 * c4 + x3_x * s4
    z4_y = v4 * c4 + x3_y * s4
    y5_z = y3_z * c4 - x3_z * s4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 + s1 * s5
    x5_y = x4_y * c5 - c1 * s5
    x5_z = x4_z * c5
    z5_x = s1 * c5 - x4_x * s5
    v5 = c1 * c5 + x4_y * s5
    v6 = x4_z * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = x5_x * c6 - z4_x * s6
    T[0, 1] = -(z4_x * c6 + x5_x * s6)
    T[0, 2] = z5_x
    T[0, 3] = x2_x * a2 + x3_x * a3 + s1 * d4 + z4_x * d5 + z5_x * d6
    T[1, 0] = x5_y * c6 - z4_y * s6
    T[1, 1] = -(z4_y * c6 + x5_y * s6)
    T[1, 2] = -v5
    T[1, 3] = x2_y * a2 + x3_y * a3 - c1 * d4 + z4_y * d5 - v5 * d6
    T[2, 0] = x5_z * c6 + y5_z * s6
    T[2, 1] = y5_z * c6 - x5_z * s6
    T[2, 2] = -v6
    T[2, 3] = d1 + s2 * a2 + x3_z * a3 + -y5_z * d5 - v6 * d6
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
    x3_x = x2_x * c3 - v1 * s3
    x3_y = x2_y * c3 - v2 * s3
    x3_z = s2 * c3 + c2 * s3
    v3 = v1 * c3 + x2_x * s3
    v4 = v2 * c3 + x2_y * s3
    y3_z = c2 * c3 - s2 * s3
    p3_x = p2_x + x3_x * a3
    p3_y = p2_y + x3_y * a3
    p3_z = p2_z + x3_z * a3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    z4_x = v3 * c4 + x3_x * s4
    z4_y = v4 * c4 + x3_y * s4
    p4_x = p3_x + s1 * d4
    p4_y = p3_y - c1 * d4
    z4_z = x3_z * s4 - y3_z * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    z5_x = s1 * c5 - (x3_x * c4 - v3 * s4) * s5
    v5 = c1 * c5 + (x3_y * c4 - v4 * s4) * s5
    v6 = (x3_z * c4 + y3_z * s4) * s5
    p5_x = p4_x + z4_x * d5
    p5_y = p4_y + z4_y * d5
    p5_z = p3_z + z4_z * d5
    p6_x = p5_x + z5_x * d6
    p6_y = p5_y - v5 * d6
    p6_z = p5_z - v6 * d6
    v7 = p6_z - d1
    v8 = p6_z - p2_z
    v9 = p6_z - p3_z
    v10 = p6_x - p4_x
    v11 = p6_y - p4_y
    v12 = p6_x - p5_x
    v13 = p6_y - p5_y
    v14 = p6_z - p5_z
    J[0, 0] = -p6_y
    J[0, 1] = -(c1 * v7)
    J[0, 2] = -(c1 * v8)
    J[0, 3] = -(c1 * v9)
    J[0, 4] = z4_y * v9 - z4_z * v11
    J[0, 5] = v6 * v13 - v5 * v14
    J[1, 0] = p6_x
    J[1, 1] = -(s1 * v7)
    J[1, 2] = -(s1 * v8)
    J[1, 3] = -(s1 * v9)
    J[1, 4] = z4_z * v10 - z4_x * v9
    J[1, 5] = -(v6 * v12 + z5_x * v14)
    J[2, 1] = s1 * p6_y + c1 * p6_x
    J[2, 2] = s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x)
    J[2, 3] = s1 * (p6_y - p3_y) + c1 * (p6_x - p3_x)
    J[2, 4] = z4_x * v11 - z4_y * v10
    J[2, 5] = z5_x * v13 + v5 * v12
    J[3, 1] = s1
    J[3, 2] = s1
    J[3, 3] = s1
    J[3, 4] = z4_x
    J[3, 5] = z5_x
    J[4, 1] = -c1
    J[4, 2] = -c1
    J[4, 3] = -c1
    J[4, 4] = z4_y
    J[4, 5] = -v5
    J[5, 0] = 1.0
    J[5, 4] = z4_z
    J[5, 5] = -v6
    return J


_LOST = 128  # _LOST + j: the row was lost after joint j had been chosen freely
_NEARLY = 192  # _NEARLY + j: joint j is nearly free, and the row's second value is its angle


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others.

    The first value of a row that is _LOST says how far it is from a solution (negative).
    """
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1 A6^-1 [3, 4]
    X1 = T13 * d6 - T14
    wy = T24 - d6 * T23
    N1 = X1 * X1 + wy * wy
    free1 = N1 <= free_limit_squared2
    D1 = N1 - k1
    apart1 = k3 < D1
    if not (-k2 <= D1):
        return  # out of reach
    w1 = math.sqrt(D1 if apart1 else 0.0)
    v1 = (w1 if apart1 else least_root1) * k4
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else d4 * math.sqrt(N1)))
    v2 = X1 * d4
    v3 = wy * d4

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v7 = T34 - d1

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        root1 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else -(inverse1 * (v3 + X1 * root1))
        s1 = math.sin(seed[0]) if free1 else inverse1 * (wy * root1 - v2)
        q1 = _atan2(s1, c1)

        # theta6, type 2: U1 A6^-1 [3, 2]
        X6 = T21 * c1 - T11 * s1
        Y6 = T22 * c1 - T12 * s1
        w6 = math.sqrt(X6 * X6 + Y6 * Y6)
        free6 = w6 <= free_limit
        divisor6 = 1.0 if free6 else w6
        near6 = w6 <= near_limit

        # theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1]
        c5 = T13 * s1 - T23 * c1

        # theta3
        v8 = T14 * c1 + T24 * s1
        v9 = 1.0 if (free1 or near6) else v1

        for i2 in range(2):  # noflip, flip
            e2 = 1.0 - 2.0 * i2
            # theta6
            if e2 < 0.0 and free6:
                continue  # both signs give the same
            factor6 = e2 / divisor6
            v4 = X6 * factor6
            v5 = Y6 * factor6
            off6 = w6 * abs(v4 * math.sin(seed[5]) + v5 * math.cos(seed[5])) if near6 else 1.0
            ahead6 = v5 * math.sin(seed[5]) - v4 * math.cos(seed[5]) if near6 else -1.0
            same6 = near6 and 0.0 < ahead6 and off6 <= free_limit
            held6 = free6 or same6
            c6 = math.cos(seed[5]) if held6 else -v4
            s6 = math.sin(seed[5]) if held6 else v5
            q6 = _atan2(s6, c6)
            s5 = w6 * e2

            # theta5
            q5 = _atan2(s5, c5)

            # theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1]
            c234 = c6 * T32 + s6 * T31
            s234 = c5 * (c6 * T31 - s6 * T32) - s5 * T33
            theta234 = _atan2(s234, c234)

            # theta3
            v6 = d6 * s5
            Z1_3 = c234 * d5 + s234 * v6 + v7
            Z2_3 = c234 * v6 - s234 * d5 + v8
            N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
            K3 = N3 - k5
            D3 = (longest3 - N3) * (N3 - shortest3)
            apart3 = shortest3_apart < N3 and N3 < longest3_apart
            if not (-boundary3 <= D3 * v9):
                if near6:
                    status[4 * i1 + 2 * i2] = _NEARLY + 6
                    q[4 * i1 + 2 * i2, 0] = D3
                    q[4 * i1 + 2 * i2, 1] = _atan2(v5, -v4)
                if free1:
                    status[4 * i1 + 2 * i2] = _LOST + 1
                    q[4 * i1 + 2 * i2, 0] = D3
                if free6:
                    status[4 * i1 + 2 * i2] = _LOST + 6
                    q[4 * i1 + 2 * i2, 0] = D3
                continue  # out of reach
            w3 = math.sqrt(D3 if apart3 else 0.0)
            c3 = K3 * k6

            # theta2, type 3: U1[2, 4] and U1[1, 4]
            X1_2 = a2 + a3 * c3
            v10 = Z1_3 * X1_2
            v11 = Z2_3 * X1_2

            for i3 in range(2):  # +, -
                e3 = 1.0 - 2.0 * i3
                # theta3
                if (
                    e3 < 0.0 and (not apart3 or (near6 and not (shortest3_clear < N3 and N3 <
                    longest3_clear)))
                ):
                    continue  # both signs give the same
                s3 = w3 * e3 * k6
                q3 = _atan2(s3, c3)

                # theta2
                Y1_2 = a3 * s3
                S2 = v10 - Z2_3 * Y1_2
                C2 = v11 + Z1_3 * Y1_2
                w2 = math.sqrt(S2 * S2 + C2 * C2)
                free2 = w2 <= free_limit_squared2
                factor2 = 1.0 / (1.0 if free2 else w2)
                c2 = math.cos(seed[1]) if free2 else C2 * factor2
                s2 = math.sin(seed[1]) if free2 else S2 * factor2
                q2 = _atan2(s2, c2)

                # joint values
                q4 = _wrap(theta234 - (q3 + q2))
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0] = q1
                q[row, 1] = q2
                q[row, 2] = q3
                q[row, 3] = q4
                q[row, 4] = q5
                q[row, 5] = q6
                status[row] = FREE_JOINT if free1 or free2 or free6 else OK


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


_CHOOSABLE = (5, 1, 0,)  # joints, from 0, that may be free


@_inner
def _serves(search, q, status):
    """Whether a row was solved, as exactly as poses may be rounded."""
    if search[2] and _beyond_limits(q[search[0]]) > 0.0:
        return False
    return status[search[0]] != UNREACHABLE and status[search[0]] < _LOST


@_inner
def _shortfall(pose, row, q, status):
    """How far a row is from a solution: 0 if it is solved.
    """
    if status[row] >= _LOST:
        return q[row, 0]
    return -math.inf if status[row] == UNREACHABLE else 0.0


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
    result = _shortfall(pose, row, q, status)
    return -_beyond_limits(q[row]) if search[2] and result == 0.0 else result


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
    # beside a place where the branches meet, this one has no solution of its own
    for moved in (top - 1e-09, top + 1e-09):
        if math.isinf(_attempt(pose, seed, search, moved, q, status)):
            return math.nan
    _attempt(pose, seed, search, top, q, status)
    return top if _serves(search, q, status) else math.nan


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
def _serving_digits(pose, seed, search, q, status):
    """The same for a joint that is nearly free: its angle is known to few digits.

    Also where the arm just reaches (an elbow that is stretched). As long as the angle is right up
    to rounding of what it was taken from, `_solve` takes it as it would take its own.
    """
    before, past = np.full(2, -math.inf), np.zeros(2)
    moved = 1e-15
    while moved < 0.1:
        for way in range(2):
            there = -moved if way else moved
            here = _attempt(pose, seed, search, there, q, status)
            if here == 0.0:
                return there
            if here < 2.0 * before[way] and past[way] == 0.0:
                past[way] = 1.0
                low = 0.25 * there
                top = _summit(pose, seed, search, low, there, q, status)
                if not math.isnan(top):
                    return top
            before[way] = here
        moved *= 2.0
    return math.nan


@_inner
def _nearest_miss(pose, seed, search, q, status):
    """How far a free joint has to be moved until the arm comes nearest to its pose."""
    step = 0.09817477042468103
    first = _attempt(pose, seed, search, 0.0, q, status)
    best, at = first, 0.0
    for k in range(-32, 32 + 1):
        here = _attempt(pose, seed, search, k * step, q, status)
        if here > best:
            best, at = here, k * step
    at = _peak(pose, seed, search, at - step, at + step, q, status)
    return at if _attempt(pose, seed, search, at, q, status) > first else 0.0


@_inner
def _serving_in_turn(pose, seed, search, q, status):
    """Several joints are free, and none serves by itself: the search and the move that do.

    In turn each is moved to where the arm comes nearest, until one serves.
    """
    for k in range(12):
        moved = _nearest_miss(pose, seed, search, q, status)
        if k > 0 and moved == 0.0:
            break
        seed[search[1]] += moved
        search = search[0], (0, 5)[k % 2], False
        moved = _serving(pose, seed, search, q, status)
        if not math.isnan(moved):
            return search, moved
    return search, math.nan


@_inner
def _choose_again(pose, given, row, q, status):
    """A free joint took the seed's value, and then the arm could not reach.

    The joint takes the nearest value that serves.
    """
    nearly = status[row] > _NEARLY
    search = row, status[row] - (_NEARLY if nearly else _LOST) - 1, False
    seed, trial, result = given.copy(), q.copy(), status.copy()
    if nearly:
        seed[search[1]] = q[row, 1]
        moved = _serving_digits(pose, seed, search, trial, result)
    else:
        seed[search[1]] = _without_turns(seed[search[1]])
        moved = _serving(pose, seed, search, trial, result)
        if math.isnan(moved):
            search, moved = _serving_in_turn(pose, seed, search, trial, result)
    _attempt(pose, seed, search, moved, trial, result)
    served = not math.isnan(moved) and _serves(search, trial, result)
    status[row] = result[row] if served else UNREACHABLE
    for i in range(6):
        q[row, i] = trial[row, i] if served else math.nan


@_inner
def _hopeless(pose, seed, search, q, status):
    """Whether a joint beyond its limits stays where it is when the one that is searched moves."""
    row = search[0]
    _attempt(pose, seed, search, 0.0, q, status)
    if _shortfall(pose, row, q, status) < 0.0:
        return False
    values = q[row].copy()
    _attempt(pose, seed, search, 0.1, q, status)
    if _shortfall(pose, row, q, status) < 0.0:
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
        if status[row] >= _LOST:
            _choose_again(pose, seed, row, q, status)
        if status[row] == FREE_JOINT and _beyond_limits(q[row]) > 0.0:
            _keep_limits(pose, seed, row, q, status)


@_inner
def _choose(pose, seed, q, status):
    """The same where there is a row that needs it."""
    served = True
    for row in range(8):
        served = served and status[row] < _LOST
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
_MISS_WEIGHT = np.array([0.762, 0.762, 0.762, 1.0, 1.0, 1.0])


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
def _lead(pose, q, status):
    """Rows of a root that follows another, which may be a little out of reach, to solutions."""
    for row in range(8):
        if status[row] == UNREACHABLE or _miss(pose, q[row])[1] <= 1e-11:
            continue
        if not _settle(pose, 1e-12, 0.15, q[row]):
            status[row] = UNREACHABLE
            for i in range(6):
                q[row, i] = math.nan


@_apart("boolean(UniTuple(float64, 12), float64[::1])")
def _are_one(T, half):
    """Whether rounding alone tells two solutions that lie to both sides of joint values.

    Half way the arm is singular, and what steps in all other directions leave of the miss is how far
    the pose is from one at which both meet.
    """
    held = np.zeros(6, np.bool_)
    for _ in range(3):
        _add_step(held, 1e-13, _miss(T, half)[0], half)
    return _miss(T, half)[1] <= 1e-14


@_inner
def _tell_once(pose, q, status):
    """Ends rows that rounding alone tells from earlier ones.

    Where an earlier angle is good to fewer digits than usual branches that meet come out apart.
    """
    half = np.empty(6)
    for row in range(1, 8):
        for k in range(row):
            if status[row] == UNREACHABLE or status[k] == UNREACHABLE:
                continue
            if _half_way(q[k], q[row], half) < 0.001 and _are_one(pose, half):
                status[row] = UNREACHABLE
                for i in range(6):
                    q[row, i] = math.nan


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
    _lead(pose, q, status)
    _tell_once(pose, q, status)
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

    # theta1, type 2: U1 A6^-1 [3, 4]
    X1 = d6 * T13 - T14
    wy = T24 - d6 * T23
    N1 = X1 * X1 + wy * wy
    D1 = N1 - k1
    w1 = math.sqrt(D1)
    v1 = k4 * w1
    inverse1 = 1.0 / N1
    v2 = inverse1 * (d4 * wy)
    v3 = v2 + w1 * (X1 * inverse1)
    v4 = v2 + w1 * (inverse1 * -X1)
    v5 = inverse1 * (d4 * X1)
    s1_p = w1 * (wy * inverse1) - v5
    s1_m = w1 * (inverse1 * -wy) - v5

    # theta6, type 2: U1 A6^-1 [3, 2]
    v6 = v3 * T21 + s1_p * T11
    v7 = v4 * T21 + s1_m * T11
    v8 = v3 * T22 + s1_p * T12
    v9 = v4 * T22 + s1_m * T12
    v10 = v6 * v6 + v8 * v8
    v11 = v7 * v7 + v9 * v9
    w6_p = math.sqrt(v10)
    w6_m = math.sqrt(v11)
    v12 = 1.0 / v10
    v13 = 1.0 / v11

    # theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1]
    c5_p = T13 * s1_p + T23 * v3
    c5_m = T13 * s1_m + T23 * v4

    # theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1]
    v14 = v12 * (v6 * T32 - v8 * T31)
    v15 = v13 * (v7 * T32 - v9 * T31)
    c234_p = w6_p * v14
    c234_m = w6_m * v15
    v16 = v12 * (c5_p * (v6 * T31 + v8 * T32)) - T33
    v17 = v13 * (c5_m * (v7 * T31 + v9 * T32)) - T33
    s234_p = w6_p * v16
    s234_m = w6_m * v17

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v18 = d6 * w6_p
    v19 = d6 * w6_m
    v20 = T34 - d1
    v21 = d5 * c234_p
    v22 = d5 * c234_m
    v23 = s234_p * v18
    v24 = s234_m * v19
    Z1_3_pp = v20 + (v21 + v23)
    Z1_3_pm = v20 + (v23 - v21)
    Z1_3_mp = v20 + (v22 + v24)
    Z1_3_mm = v20 + (v24 - v22)
    v25 = T24 * s1_p - T14 * v3
    v26 = T24 * s1_m - T14 * v4
    v27 = c234_p * v18
    v28 = c234_m * v19
    v29 = d5 * s234_p
    v30 = d5 * s234_m
    Z2_3_pp = v25 + (v27 - v29)
    Z2_3_pm = v25 + (v27 + v29)
    Z2_3_mp = v26 + (v28 - v30)
    Z2_3_mm = v26 + (v28 + v30)
    N3_pp = Z1_3_pp * Z1_3_pp + Z2_3_pp * Z2_3_pp
    N3_pm = Z1_3_pm * Z1_3_pm + Z2_3_pm * Z2_3_pm
    N3_mp = Z1_3_mp * Z1_3_mp + Z2_3_mp * Z2_3_mp
    N3_mm = Z1_3_mm * Z1_3_mm + Z2_3_mm * Z2_3_mm
    D3_pp = (longest3 - N3_pp) * (N3_pp - shortest3)
    D3_pm = (longest3 - N3_pm) * (N3_pm - shortest3)
    D3_mp = (longest3 - N3_mp) * (N3_mp - shortest3)
    D3_mm = (longest3 - N3_mm) * (N3_mm - shortest3)
    w3_pp = math.sqrt(D3_pp)
    w3_pm = math.sqrt(D3_pm)
    w3_mp = math.sqrt(D3_mp)
    w3_mm = math.sqrt(D3_mm)
    v31 = w3_pp - w3_pp
    v32 = w3_pm - w3_pm
    v33 = w3_mp - w3_mp
    v34 = w3_mm - w3_mm

    # theta2, type 3: U1[2, 4] and U1[1, 4]
    v35 = m6 + m5 * N3_pp
    v36 = m6 + m5 * N3_pm
    v37 = m6 + m5 * N3_mp
    v38 = m6 + m5 * N3_mm
    v39 = Z1_3_pp * v35
    v40 = Z1_3_pm * v36
    v41 = Z1_3_mp * v37
    v42 = Z1_3_mm * v38
    v43 = Z2_3_pp * v35
    v44 = Z2_3_pm * v36
    v45 = Z2_3_mp * v37
    v46 = Z2_3_mm * v38
    v47 = w3_pp * (m5 * Z2_3_pp)
    v48 = w3_pp * (m5 * Z1_3_pp)
    v49 = w3_pm * (m5 * Z2_3_pm)
    v50 = w3_pm * (m5 * Z1_3_pm)
    v51 = w3_mp * (m5 * Z2_3_mp)
    v52 = w3_mp * (m5 * Z1_3_mp)
    v53 = w3_mm * (m5 * Z2_3_mm)
    v54 = w3_mm * (m5 * Z1_3_mm)

    # a joint is free, or branches meet
    if (
        abs(v1 * D3_mm) <= m4 or abs(v1 * D3_mp) <= m4 or abs(v1 * D3_pm) <= m4 or abs(v1 * D3_pp)
        <= m4 or v11 <= m2 or abs(D1) <= m1 or v10 <= m2
    ):
        return False

    # angles, side by side
    room[0] = s1_p
    room[1] = s1_m
    room[2] = -v8
    room[3] = -v9
    room[4] = w6_p
    room[5] = w6_m
    room[6] = v16
    room[7] = v17
    room[8] = w3_pp
    room[9] = w3_pm
    room[10] = w3_mp
    room[11] = w3_mm
    room[12] = v47 - v39
    room[13] = -(v39 + v47)
    room[14] = v49 - v40
    room[15] = -(v40 + v49)
    room[16] = v51 - v41
    room[17] = -(v41 + v51)
    room[18] = v53 - v42
    room[19] = -(v42 + v53)
    room[24] = -v3
    room[25] = -v4
    room[26] = v6
    room[27] = v7
    room[28] = c5_p
    room[29] = c5_m
    room[30] = v14
    room[31] = v15
    room[32] = N3_pp - k5
    room[33] = N3_pm - k5
    room[34] = N3_mp - k5
    room[35] = N3_mm - k5
    room[36] = -(v43 + v48)
    room[37] = v48 - v43
    room[38] = -(v44 + v50)
    room[39] = v50 - v44
    room[40] = -(v45 + v52)
    room[41] = v52 - v45
    room[42] = -(v46 + v54)
    room[43] = v54 - v46
    for k in range(20, 24):
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
    angle20 = room[19]

    # theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1]
    theta234_pm = angle7 - math.copysign(half_turn, v16)
    theta234_mm = angle8 - math.copysign(half_turn, v17)

    # joint values
    v55 = angle7 - (angle9 + angle13)
    v56 = angle7 - (angle14 - angle9)
    v57 = theta234_pm - (angle10 + angle15)
    v58 = theta234_pm - (angle16 - angle10)
    v59 = angle8 - (angle11 + angle17)
    v60 = angle8 - (angle18 - angle11)
    v61 = theta234_mm - (angle12 + angle19)
    v62 = theta234_mm - (angle20 - angle12)
    q4_ppp = v55 + (turn if v55 <= -half_turn else (-turn if half_turn < v55 else 0.0))
    q4_ppm = v56 + (turn if v56 <= -half_turn else (-turn if half_turn < v56 else 0.0))
    q4_pmp = v57 + (turn if v57 <= -half_turn else (-turn if half_turn < v57 else 0.0))
    q4_pmm = v58 + (turn if v58 <= -half_turn else (-turn if half_turn < v58 else 0.0))
    q4_mpp = v59 + (turn if v59 <= -half_turn else (-turn if half_turn < v59 else 0.0))
    q4_mpm = v60 + (turn if v60 <= -half_turn else (-turn if half_turn < v60 else 0.0))
    q4_mmp = v61 + (turn if v61 <= -half_turn else (-turn if half_turn < v61 else 0.0))
    q4_mmm = v62 + (turn if v62 <= -half_turn else (-turn if half_turn < v62 else 0.0))
    q1_ppp = angle1 + v31
    q1_pmp = angle1 + v32
    q1_mpp = angle2 + v33
    q1_mmp = angle2 + v34
    q5_ppp = angle5 + v31
    q5_pmp = v32 - angle5
    q5_mpp = angle6 + v33
    q5_mmp = v34 - angle6
    q6_ppp = angle3 + v31
    q6_pmp = v32 + (angle3 - math.copysign(half_turn, -v8))
    q6_mpp = angle4 + v33
    q6_mmp = v34 + (angle4 - math.copysign(half_turn, -v9))

    q[0, 0] = q1_ppp
    q[0, 1] = angle13
    q[0, 2] = angle9
    q[0, 3] = q4_ppp
    q[0, 4] = q5_ppp
    q[0, 5] = q6_ppp
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else OK
    q[1, 0] = q1_ppp
    q[1, 1] = angle14
    q[1, 2] = -angle9
    q[1, 3] = q4_ppm
    q[1, 4] = q5_ppp
    q[1, 5] = q6_ppp
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else OK
    q[2, 0] = q1_pmp
    q[2, 1] = angle15
    q[2, 2] = angle10
    q[2, 3] = q4_pmp
    q[2, 4] = q5_pmp
    q[2, 5] = q6_pmp
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else OK
    q[3, 0] = q1_pmp
    q[3, 1] = angle16
    q[3, 2] = -angle10
    q[3, 3] = q4_pmm
    q[3, 4] = q5_pmp
    q[3, 5] = q6_pmp
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else OK
    q[4, 0] = q1_mpp
    q[4, 1] = angle17
    q[4, 2] = angle11
    q[4, 3] = q4_mpp
    q[4, 4] = q5_mpp
    q[4, 5] = q6_mpp
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else OK
    q[5, 0] = q1_mpp
    q[5, 1] = angle18
    q[5, 2] = -angle11
    q[5, 3] = q4_mpm
    q[5, 4] = q5_mpp
    q[5, 5] = q6_mpp
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else OK
    q[6, 0] = q1_mmp
    q[6, 1] = angle19
    q[6, 2] = angle12
    q[6, 3] = q4_mmp
    q[6, 4] = q5_mmp
    q[6, 5] = q6_mmp
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else OK
    q[7, 0] = q1_mmp
    q[7, 1] = angle20
    q[7, 2] = -angle12
    q[7, 3] = q4_mmm
    q[7, 4] = q5_mmp
    q[7, 5] = q6_mmp
    status[7] = UNREACHABLE if q[7, 0] != q[7, 0] else OK
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
    [1168, 1184, 1200, 1216, 1232, 1248],
    [1168, 1264, 1280, 1296, 1232, 1248],
    [1312, 1328, 1344, 1360, 1376, 1392],
    [1312, 1408, 1424, 1440, 1376, 1392],
    [1456, 1472, 1488, 1504, 1520, 1536],
    [1456, 1552, 1568, 1584, 1520, 1536],
    [1600, 1616, 1632, 1648, 1664, 1680],
    [1600, 1696, 1712, 1728, 1664, 1680],
])
_KINDS = np.array([1744, 1760, 1776, 1792, 1808, 1824, 1840, 1856])


@_njit(nogil=True)
def _in_tiles(T, q, status):
    """16 poses at a time, side by side: work[place + k] is a value of pose k.

    Loops that hold nothing but arithmetic become vector instructions. The formulas are those of
    _regular; poses that it does not answer are solved one by one.
    """
    work = carray(_wide_room(1872), 1872)
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
            X1 = d6 * T13 - T14
            wy = T24 - d6 * T23
            N1 = X1 * X1 + wy * wy
            D1 = N1 - k1
            w1 = math.sqrt(D1)
            v1 = k4 * w1
            inverse1 = 1.0 / N1
            v2 = inverse1 * (d4 * wy)
            v3 = v2 + w1 * (X1 * inverse1)
            v4 = v2 + w1 * (inverse1 * -X1)
            v5 = inverse1 * (d4 * X1)
            s1_p = w1 * (wy * inverse1) - v5
            s1_m = w1 * (inverse1 * -wy) - v5
            v6 = v3 * T21 + s1_p * T11
            v7 = v4 * T21 + s1_m * T11
            v8 = v3 * T22 + s1_p * T12
            v9 = v4 * T22 + s1_m * T12
            v10 = v6 * v6 + v8 * v8
            v11 = v7 * v7 + v9 * v9
            w6_p = math.sqrt(v10)
            w6_m = math.sqrt(v11)
            v12 = 1.0 / v10
            v13 = 1.0 / v11
            c5_p = T13 * s1_p + T23 * v3
            c5_m = T13 * s1_m + T23 * v4
            v14 = v12 * (v6 * T32 - v8 * T31)
            v15 = v13 * (v7 * T32 - v9 * T31)
            c234_p = w6_p * v14
            c234_m = w6_m * v15
            v16 = v12 * (c5_p * (v6 * T31 + v8 * T32)) - T33
            v17 = v13 * (c5_m * (v7 * T31 + v9 * T32)) - T33
            s234_p = w6_p * v16
            s234_m = w6_m * v17
            v18 = d6 * w6_p
            v19 = d6 * w6_m
            v20 = T34 - d1
            v21 = d5 * c234_p
            v22 = d5 * c234_m
            v23 = s234_p * v18
            v24 = s234_m * v19
            Z1_3_pp = v20 + (v21 + v23)
            Z1_3_pm = v20 + (v23 - v21)
            Z1_3_mp = v20 + (v22 + v24)
            Z1_3_mm = v20 + (v24 - v22)
            v25 = T24 * s1_p - T14 * v3
            v26 = T24 * s1_m - T14 * v4
            v27 = c234_p * v18
            v28 = c234_m * v19
            v29 = d5 * s234_p
            v30 = d5 * s234_m
            Z2_3_pp = v25 + (v27 - v29)
            Z2_3_pm = v25 + (v27 + v29)
            Z2_3_mp = v26 + (v28 - v30)
            Z2_3_mm = v26 + (v28 + v30)
            N3_pp = Z1_3_pp * Z1_3_pp + Z2_3_pp * Z2_3_pp
            N3_pm = Z1_3_pm * Z1_3_pm + Z2_3_pm * Z2_3_pm
            N3_mp = Z1_3_mp * Z1_3_mp + Z2_3_mp * Z2_3_mp
            N3_mm = Z1_3_mm * Z1_3_mm + Z2_3_mm * Z2_3_mm
            D3_pp = (longest3 - N3_pp) * (N3_pp - shortest3)
            D3_pm = (longest3 - N3_pm) * (N3_pm - shortest3)
            D3_mp = (longest3 - N3_mp) * (N3_mp - shortest3)
            D3_mm = (longest3 - N3_mm) * (N3_mm - shortest3)
            w3_pp = math.sqrt(D3_pp)
            w3_pm = math.sqrt(D3_pm)
            w3_mp = math.sqrt(D3_mp)
            w3_mm = math.sqrt(D3_mm)
            v31 = w3_pp - w3_pp
            v32 = w3_pm - w3_pm
            v33 = w3_mp - w3_mp
            v34 = w3_mm - w3_mm
            v35 = m6 + m5 * N3_pp
            v36 = m6 + m5 * N3_pm
            v37 = m6 + m5 * N3_mp
            v38 = m6 + m5 * N3_mm
            v39 = Z1_3_pp * v35
            v40 = Z1_3_pm * v36
            v41 = Z1_3_mp * v37
            v42 = Z1_3_mm * v38
            v43 = Z2_3_pp * v35
            v44 = Z2_3_pm * v36
            v45 = Z2_3_mp * v37
            v46 = Z2_3_mm * v38
            v47 = w3_pp * (m5 * Z2_3_pp)
            v48 = w3_pp * (m5 * Z1_3_pp)
            v49 = w3_pm * (m5 * Z2_3_pm)
            v50 = w3_pm * (m5 * Z1_3_pm)
            v51 = w3_mp * (m5 * Z2_3_mp)
            v52 = w3_mp * (m5 * Z1_3_mp)
            v53 = w3_mm * (m5 * Z2_3_mm)
            v54 = w3_mm * (m5 * Z1_3_mm)
            work[272 + k] = D1
            work[288 + k] = v1
            work[304 + k] = v8
            work[320 + k] = v9
            work[336 + k] = v10
            work[352 + k] = v11
            work[368 + k] = v16
            work[384 + k] = v17
            work[400 + k] = D3_pp
            work[416 + k] = D3_pm
            work[432 + k] = D3_mp
            work[448 + k] = D3_mm
            work[464 + k] = v31
            work[480 + k] = v32
            work[496 + k] = v33
            work[512 + k] = v34
            work[528 + k] = s1_p
            work[544 + k] = s1_m
            work[560 + k] = -v8
            work[576 + k] = -v9
            work[592 + k] = w6_p
            work[608 + k] = w6_m
            work[624 + k] = v16
            work[640 + k] = v17
            work[656 + k] = w3_pp
            work[672 + k] = w3_pm
            work[688 + k] = w3_mp
            work[704 + k] = w3_mm
            work[720 + k] = v47 - v39
            work[736 + k] = -(v39 + v47)
            work[752 + k] = v49 - v40
            work[768 + k] = -(v40 + v49)
            work[784 + k] = v51 - v41
            work[800 + k] = -(v41 + v51)
            work[816 + k] = v53 - v42
            work[832 + k] = -(v42 + v53)
            work[848 + k] = -v3
            work[864 + k] = -v4
            work[880 + k] = v6
            work[896 + k] = v7
            work[912 + k] = c5_p
            work[928 + k] = c5_m
            work[944 + k] = v14
            work[960 + k] = v15
            work[976 + k] = N3_pp - k5
            work[992 + k] = N3_pm - k5
            work[1008 + k] = N3_mp - k5
            work[1024 + k] = N3_mm - k5
            work[1040 + k] = -(v43 + v48)
            work[1056 + k] = v48 - v43
            work[1072 + k] = -(v44 + v50)
            work[1088 + k] = v50 - v44
            work[1104 + k] = -(v45 + v52)
            work[1120 + k] = v52 - v45
            work[1136 + k] = -(v46 + v54)
            work[1152 + k] = v54 - v46
        for k in range(528, 848):
            work[k] = _atan2(work[k], work[k + 320])
        for k in range(0, 16):
            D1 = work[272 + k]
            v1 = work[288 + k]
            v8 = work[304 + k]
            v9 = work[320 + k]
            v10 = work[336 + k]
            v11 = work[352 + k]
            v16 = work[368 + k]
            v17 = work[384 + k]
            D3_pp = work[400 + k]
            D3_pm = work[416 + k]
            D3_mp = work[432 + k]
            D3_mm = work[448 + k]
            v31 = work[464 + k]
            v32 = work[480 + k]
            v33 = work[496 + k]
            v34 = work[512 + k]
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
            angle20 = work[832 + k]
            theta234_pm = angle7 - math.copysign(half_turn, v16)
            theta234_mm = angle8 - math.copysign(half_turn, v17)
            v55 = angle7 - (angle9 + angle13)
            v56 = angle7 - (angle14 - angle9)
            v57 = theta234_pm - (angle10 + angle15)
            v58 = theta234_pm - (angle16 - angle10)
            v59 = angle8 - (angle11 + angle17)
            v60 = angle8 - (angle18 - angle11)
            v61 = theta234_mm - (angle12 + angle19)
            v62 = theta234_mm - (angle20 - angle12)
            q4_ppp = v55 + (turn if v55 <= -half_turn else (-turn if half_turn < v55 else 0.0))
            q4_ppm = v56 + (turn if v56 <= -half_turn else (-turn if half_turn < v56 else 0.0))
            q4_pmp = v57 + (turn if v57 <= -half_turn else (-turn if half_turn < v57 else 0.0))
            q4_pmm = v58 + (turn if v58 <= -half_turn else (-turn if half_turn < v58 else 0.0))
            q4_mpp = v59 + (turn if v59 <= -half_turn else (-turn if half_turn < v59 else 0.0))
            q4_mpm = v60 + (turn if v60 <= -half_turn else (-turn if half_turn < v60 else 0.0))
            q4_mmp = v61 + (turn if v61 <= -half_turn else (-turn if half_turn < v61 else 0.0))
            q4_mmm = v62 + (turn if v62 <= -half_turn else (-turn if half_turn < v62 else 0.0))
            q1_ppp = angle1 + v31
            q1_pmp = angle1 + v32
            q1_mpp = angle2 + v33
            q1_mmp = angle2 + v34
            q5_ppp = angle5 + v31
            q5_pmp = v32 - angle5
            q5_mpp = angle6 + v33
            q5_mmp = v34 - angle6
            q6_ppp = angle3 + v31
            q6_pmp = v32 + (angle3 - math.copysign(half_turn, -v8))
            q6_mpp = angle4 + v33
            q6_mmp = v34 + (angle4 - math.copysign(half_turn, -v9))
            _1168 = q1_ppp
            work[1168 + k] = _1168
            _1184 = angle13
            work[1184 + k] = _1184
            _1200 = angle9
            work[1200 + k] = _1200
            _1216 = q4_ppp
            work[1216 + k] = _1216
            _1232 = q5_ppp
            work[1232 + k] = _1232
            _1248 = q6_ppp
            work[1248 + k] = _1248
            _1264 = angle14
            work[1264 + k] = _1264
            _1280 = -angle9
            work[1280 + k] = _1280
            _1296 = q4_ppm
            work[1296 + k] = _1296
            _1312 = q1_pmp
            work[1312 + k] = _1312
            _1328 = angle15
            work[1328 + k] = _1328
            _1344 = angle10
            work[1344 + k] = _1344
            _1360 = q4_pmp
            work[1360 + k] = _1360
            _1376 = q5_pmp
            work[1376 + k] = _1376
            _1392 = q6_pmp
            work[1392 + k] = _1392
            _1408 = angle16
            work[1408 + k] = _1408
            _1424 = -angle10
            work[1424 + k] = _1424
            _1440 = q4_pmm
            work[1440 + k] = _1440
            _1456 = q1_mpp
            work[1456 + k] = _1456
            _1472 = angle17
            work[1472 + k] = _1472
            _1488 = angle11
            work[1488 + k] = _1488
            _1504 = q4_mpp
            work[1504 + k] = _1504
            _1520 = q5_mpp
            work[1520 + k] = _1520
            _1536 = q6_mpp
            work[1536 + k] = _1536
            _1552 = angle18
            work[1552 + k] = _1552
            _1568 = -angle11
            work[1568 + k] = _1568
            _1584 = q4_mpm
            work[1584 + k] = _1584
            _1600 = q1_mmp
            work[1600 + k] = _1600
            _1616 = angle19
            work[1616 + k] = _1616
            _1632 = angle12
            work[1632 + k] = _1632
            _1648 = q4_mmp
            work[1648 + k] = _1648
            _1664 = q5_mmp
            work[1664 + k] = _1664
            _1680 = q6_mmp
            work[1680 + k] = _1680
            _1696 = angle20
            work[1696 + k] = _1696
            _1712 = -angle12
            work[1712 + k] = _1712
            _1728 = q4_mmm
            work[1728 + k] = _1728
            work[1744 + k] = UNREACHABLE if _1168 != _1168 else OK
            work[1760 + k] = UNREACHABLE if _1168 != _1168 else OK
            work[1776 + k] = UNREACHABLE if _1312 != _1312 else OK
            work[1792 + k] = UNREACHABLE if _1312 != _1312 else OK
            work[1808 + k] = UNREACHABLE if _1456 != _1456 else OK
            work[1824 + k] = UNREACHABLE if _1456 != _1456 else OK
            work[1840 + k] = UNREACHABLE if _1600 != _1600 else OK
            work[1856 + k] = UNREACHABLE if _1600 != _1600 else OK
            work[256 + k] = (
                1.0 if abs(v1 * D3_mm) <= m4 or abs(v1 * D3_mp) <= m4 or abs(v1 * D3_pm) <= m4 or
                abs(v1 * D3_pp) <= m4 or v11 <= m2 or abs(D1) <= m1 or v10 <= m2 else work[256 + k]
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
