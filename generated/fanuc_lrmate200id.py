"""fanuc_lrmate200id: Fanuc LR Mate 200iD.

Inverse kinematics, generated from robots/fanuc_lrmate200id.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/fanuc_lrmate200id.yaml. The formulas and where they come from:
fanuc_lrmate200id.md.

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

NAME = "fanuc_lrmate200id"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_LIMITS = (
    (-2.9670597283903604, 2.9670597283903604),
    (-1.7453292519943295, 2.530727415391778),
    (-1.2217304763960306, 3.5779249665883754),
    (-3.3161255787892263, 3.3161255787892263),
    (-2.181661564992912, 2.181661564992912),
    (-6.283185307179586, 6.283185307179586),
)
BRANCHES = (
    "back-up-noflip",
    "back-up-flip",
    "back-down-noflip",
    "back-down-flip",
    "front-down-noflip",
    "front-down-flip",
    "front-up-noflip",
    "front-up-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.33  # joint offset 1 [m]
a1 = 0.05  # link length 1 [m]
a2 = 0.33  # link length 2 [m]
a3 = 0.035  # link length 3 [m]
d4 = 0.335  # joint offset 4 [m]
d6 = 0.08  # z of the tool frame [m]
free_limit1 = 1.1600000000000001e-12  # a length that fixes no angle [m]
longest3 = 0.4446534412689106  # square of the longest reach [m^2]
shortest3 = 4.655873108936529e-05  # square of the shortest reach [m^2]
longest3_reach = 0.44465344126906536  # the longest, with what rounding adds [m^2]
shortest3_reach = 4.655873108778226e-05  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.4446534412688952  # the longest, where branches merge [m^2]
shortest3_apart = 4.655873108952359e-05  # the shortest, where branches merge [m^2]
free_limit_squared2 = 1.3456000000000002e-24  # square of a length that fixes no angle [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset5 = 3.141592653589793  # offset of joint 5 [rad]
k1 = 0.22110000000000002  # 2 * d4 * a2 [m^2]
k2 = 0.023100000000000002  # 2 * a3 * a2 [m^2]
k3 = 0.22235000000000002  # a2^2 + (a3^2 + d4^2) [m^2]
k4 = 20.235205939761407  # 1 / (k1^2 + k2^2) [m^-4]
turn1 = -1.4666963886852973  # a constant angle [rad]
high1 = 2.9670597293903604
low2 = -1.7453292529943296
high2 = 2.530727416391778
low3 = -1.2217304773960307
high3 = 3.5779249675883755
high5 = 2.181661565992912
graze = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 1.3456000000000003e-08  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 6.836537250918941e-12
m4 = 1.5151515151515151  # a coefficient of Y1_2
m5 = 0.006893939393939396  # a coefficient of Y1_2
m6 = 0.15425297487880124  # a coefficient of c2m3
m7 = 1.4764213309828118  # a coefficient of c2m3
m8 = 0.006717717055971795  # a coefficient of c2m3
m9 = 0.0007018510356985458  # a coefficient of c2m3
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
    v1 = q[1] + offset2
    c2 = math.cos(v1)
    s2 = math.sin(v1)
    x2_x = c1 * c2
    x2_y = s1 * c2
    y2_x = c1 * s2
    y2_y = s1 * s2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 + y2_x * s3
    x3_y = x2_y * c3 + y2_y * s3
    x3_z = c2 * s3 - s2 * c3
    z3_x = y2_x * c3 - x2_x * s3
    z3_y = y2_y * c3 - x2_y * s3
    z3_z = c2 * c3 + s2 * s3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - s1 * s4
    x4_y = x3_y * c4 + c1 * s4
    x4_z = x3_z * c4
    z4_x = s1 * c4 + x3_x * s4
    z4_z = x3_z * s4
    z4_y = x3_y * s4 - c1 * c4
    v2 = q[4] + offset5
    c5 = math.cos(v2)
    s5 = math.sin(v2)
    x5_x = x4_x * c5 + z3_x * s5
    x5_y = x4_y * c5 + z3_y * s5
    x5_z = x4_z * c5 + z3_z * s5
    T11_ = z3_x * c5 - x4_x * s5
    T21_ = z3_y * c5 - x4_y * s5
    T31_ = z3_z * c5 - x4_z * s5
    c6 = math.cos(q[5])
    s6 = math.sin(q[5])
    T[0, 0] = T11_
    T[0, 1] = x5_x * s6 - z4_x * c6
    T[0, 2] = -(x5_x * c6 + z4_x * s6)
    T[0, 3] = c1 * a1 + x2_x * a2 + x3_x * a3 - z3_x * d4 - -T11_ * d6
    T[1, 0] = T21_
    T[1, 1] = x5_y * s6 - z4_y * c6
    T[1, 2] = -(x5_y * c6 + z4_y * s6)
    T[1, 3] = s1 * a1 + x2_y * a2 + x3_y * a3 - z3_y * d4 - -T21_ * d6
    T[2, 0] = T31_
    T[2, 1] = x5_z * s6 - z4_z * c6
    T[2, 2] = -(x5_z * c6 + z4_z * s6)
    T[2, 3] = d1 - s2 * a2 + x3_z * a3 - z3_z * d4 - -T31_ * d6
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
    p1_x = c1 * a1
    p1_y = s1 * a1
    v1 = q[1] + offset2
    c2 = math.cos(v1)
    s2 = math.sin(v1)
    x2_x = c1 * c2
    x2_y = s1 * c2
    y2_x = c1 * s2
    y2_y = s1 * s2
    p2_x = p1_x + x2_x * a2
    p2_y = p1_y + x2_y * a2
    p2_z = d1 - s2 * a2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 + y2_x * s3
    x3_y = x2_y * c3 + y2_y * s3
    x3_z = c2 * s3 - s2 * c3
    z3_x = y2_x * c3 - x2_x * s3
    z3_y = y2_y * c3 - x2_y * s3
    z3_z = c2 * c3 + s2 * s3
    p3_x = p2_x + x3_x * a3
    p3_y = p2_y + x3_y * a3
    p3_z = p2_z + x3_z * a3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    z4_x = s1 * c4 + x3_x * s4
    z4_z = x3_z * s4
    p4_x = p3_x - z3_x * d4
    p4_y = p3_y - z3_y * d4
    p4_z = p3_z - z3_z * d4
    z4_y = x3_y * s4 - c1 * c4
    v2 = q[4] + offset5
    c5 = math.cos(v2)
    s5 = math.sin(v2)
    z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5
    z5_y = (x3_y * c4 + c1 * s4) * s5 - z3_y * c5
    z5_z = x3_z * c4 * s5 - z3_z * c5
    J21 = p4_x - z5_x * d6
    v3 = p4_y - z5_y * d6
    v4 = p4_z - z5_z * d6
    v5 = v4 - d1
    v6 = v4 - p2_z
    v7 = J21 - p3_x
    v8 = v3 - p3_y
    v9 = v4 - p3_z
    v10 = J21 - p4_x
    v11 = v3 - p4_y
    v12 = v4 - p4_z
    J[0, 0] = -v3
    J[0, 1] = c1 * v5
    J[0, 2] = -(c1 * v6)
    J[0, 3] = z3_y * v9 - z3_z * v8
    J[0, 4] = z4_y * v12 - z4_z * v11
    J[0, 5] = z5_y * v12 - z5_z * v11
    J[1, 0] = J21
    J[1, 1] = s1 * v5
    J[1, 2] = -(s1 * v6)
    J[1, 3] = z3_z * v7 - z3_x * v9
    J[1, 4] = z4_z * v10 - z4_x * v12
    J[1, 5] = z5_z * v10 - z5_x * v12
    J[2, 1] = -(s1 * (v3 - p1_y) + c1 * (J21 - p1_x))
    J[2, 2] = s1 * (v3 - p2_y) + c1 * (J21 - p2_x)
    J[2, 3] = z3_x * v8 - z3_y * v7
    J[2, 4] = z4_x * v11 - z4_y * v10
    J[2, 5] = z5_x * v11 - z5_y * v10
    J[3, 1] = -s1
    J[3, 2] = s1
    J[3, 3] = z3_x
    J[3, 4] = z4_x
    J[3, 5] = z5_x
    J[4, 1] = c1
    J[4, 2] = -c1
    J[4, 3] = z3_y
    J[4, 4] = z4_y
    J[4, 5] = z5_y
    J[5, 0] = 1.0
    J[5, 3] = z3_z
    J[5, 4] = z4_z
    J[5, 5] = z5_z
    return J


@_inner
def _solve(pose, seed, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[3, 4]
    t14 = T14 - d6 * T11
    Y1 = d6 * T21 - T24
    w1 = math.sqrt(t14 * t14 + Y1 * Y1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 6: U1[2, 4] and U1[1, 4]
    t34 = T34 - d6 * T31
    Z1_3 = t34 - d1
    v2 = Z1_3 * Z1_3

    # theta2, type 3: U1[1, 4] and U1[2, 4]
    v6 = seed[1] + offset2

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

        # theta4, type 2: U4[3, 3]
        v7 = T11 * c1 + T21 * s1
        Y4 = T11 * s1 - T21 * c1
        v8 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v9 = T22 * c1 - T12 * s1
        v10 = T12 * c1 + T22 * s1
        v12 = T23 * c1 - T13 * s1
        v13 = T13 * c1 + T23 * s1

        for i2 in range(2):  # +, -
            e2 = 1.0 - 2.0 * i2
            # theta3
            if e2 < 0.0 and not apart3:
                continue  # both signs give the same
            root3 = w3 * e2
            s3 = (v3 + k2 * root3) * k4
            c3 = k4 * (v4 - k1 * root3)
            q3 = _atan2(s3, c3)

            # theta2
            X1_2 = a3 * s3 - d4 * c3
            Y1_2 = a2 + (a3 * c3 + d4 * s3)
            v5 = v1 * X1_2 + Z1_3 * Y1_2
            C2 = Z1_3 * X1_2 - v1 * Y1_2
            w2 = math.sqrt(v5 * v5 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v6) if free2 else C2 * factor2
            s2 = math.sin(v6) if free2 else -(v5 * factor2)

            # theta4
            c2m3 = c3 * c2 + s3 * s2
            s2m3 = c3 * s2 - s3 * c2
            X4 = c2m3 * v7 - T31 * s2m3
            w4 = math.sqrt(X4 * X4 + v8)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T31 * c2m3 + s2m3 * v7

            # theta6
            v11 = T32 * s2m3 - c2m3 * v10
            v14 = T33 * s2m3 - c2m3 * v13

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)

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

                # theta6
                c6 = c4 * v9 + s4 * v11
                s6 = c4 * v12 + s4 * v14
                q6 = _atan2(s6, c6)

                # joint values
                q5 = _wrap(_atan2(s5, c5) - offset5)
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
_MISS_WEIGHT = np.array([0.8621, 0.8621, 0.8621, 1.0, 1.0, 1.0])


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

    # theta1, type 2: U1[3, 4]
    t14 = T14 - d6 * T11
    Y1 = d6 * T21 - T24
    v1 = t14 * t14 + Y1 * Y1
    w1 = math.sqrt(v1)
    v2 = 1.0 / v1

    # theta3, type 6: U1[2, 4] and U1[1, 4]
    Z1_3 = T34 - d6 * T31 - d1
    v3 = a1 + w1
    v4 = a1 - w1
    v5 = Z1_3 * Z1_3
    N3_p = v5 + v3 * v3
    N3_m = v5 + v4 * v4
    D3_p = (longest3 - N3_p) * (N3_p - shortest3)
    D3_m = (longest3 - N3_m) * (N3_m - shortest3)
    w3_p = math.sqrt(D3_p)
    w3_m = math.sqrt(D3_m)

    # theta2, type 3: U1[1, 4] and U1[2, 4]
    Y1_2_p = m4 * N3_p - m5
    Y1_2_m = m4 * N3_m - m5
    v8 = Z1_3 * Y1_2_p
    v9 = Z1_3 * Y1_2_m
    v10 = m4 * Z1_3
    v11 = m4 * -Z1_3
    v12 = v3 * -Y1_2_p
    v13 = v4 * -Y1_2_m
    factor2_p = 1.0 / N3_p
    factor2_m = 1.0 / N3_m

    # theta4, type 2: U4[3, 3]
    v14 = m6 * Z1_3
    v15 = m7 * v3 - v14
    v16 = m7 * v4 - v14
    v17 = m7 + m8 * factor2_p
    v18 = m7 + m8 * factor2_m
    v19 = m6 + m9 * factor2_p
    v20 = m6 + m9 * factor2_m
    v21 = Z1_3 * v17 + v3 * v19
    v22 = Z1_3 * v18 + v4 * v20
    c2m3_pp = w3_p * (factor2_p * v15) - v21
    c2m3_pm = w3_p * (factor2_p * -v15) - v21
    c2m3_mp = w3_m * (factor2_m * v16) - v22
    c2m3_mm = w3_m * (factor2_m * -v16) - v22
    v23 = m7 * Z1_3
    v24 = v3 * v17 - Z1_3 * v19
    v25 = v4 * v18 - Z1_3 * v20
    v26 = w3_p * (factor2_p * (v23 + m6 * v3))
    s2m3_pp = v24 + v26
    s2m3_pm = v24 - v26
    v27 = w3_m * (factor2_m * (v23 + m6 * v4))
    s2m3_mp = v25 + v27
    s2m3_mm = v25 - v27
    v28 = w1 * (v2 * (T21 * Y1 - T11 * t14))
    X4_pp = c2m3_pp * v28 - T31 * s2m3_pp
    X4_pm = c2m3_pm * v28 - T31 * s2m3_pm
    v29 = c2m3_mp * v28 + T31 * s2m3_mp
    v30 = c2m3_mm * v28 + T31 * s2m3_mm
    Y4 = w1 * (v2 * (T11 * Y1 + t14 * T21))
    v31 = Y4 * Y4
    v32 = v31 + X4_pp * X4_pp
    v33 = v31 + X4_pm * X4_pm
    v34 = v31 + v29 * v29
    v35 = v31 + v30 * v30
    v36 = math.copysign(half_turn, Y4)
    v37 = math.copysign(half_turn, -Y4)

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v38 = w1 * (v2 * (t14 * T22 + Y1 * T12))
    v39 = w1 * (v2 * (Y1 * T22 - t14 * T12))
    v40 = w1 * (v2 * (t14 * T23 + Y1 * T13))
    v41 = w1 * (v2 * (Y1 * T23 - t14 * T13))
    v42 = Y4 * (s2m3_pp * T33 - c2m3_pp * v41) - -X4_pp * v40
    v43 = Y4 * (s2m3_pm * T33 - c2m3_pm * v41) - -X4_pm * v40
    v44 = v29 * v40 - Y4 * (s2m3_mp * T33 + c2m3_mp * v41)
    v45 = v30 * v40 - Y4 * (s2m3_mm * T33 + c2m3_mm * v41)

    # joint values
    v46 = w3_p * (m4 * v3)

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
    room[3] = Y4
    room[4] = Y4
    room[5] = -Y4
    room[6] = -Y4
    room[7] = v42
    room[8] = v43
    room[9] = v44
    room[10] = v45
    room[11] = -(v8 + v46)
    room[12] = v46 - v8
    room[13] = -(v9 + w3_m * (m4 * v4))
    room[14] = -(v9 + w3_m * (m4 * -v4))
    room[15] = math.sqrt(v32)
    room[16] = math.sqrt(v33)
    room[17] = math.sqrt(v34)
    room[18] = math.sqrt(v35)
    room[24] = -t14
    room[25] = N3_p - k3
    room[26] = N3_m - k3
    room[27] = -X4_pp
    room[28] = -X4_pm
    room[29] = v29
    room[30] = v30
    room[31] = Y4 * (s2m3_pp * T32 - c2m3_pp * v39) - -X4_pp * v38
    room[32] = Y4 * (s2m3_pm * T32 - c2m3_pm * v39) - -X4_pm * v38
    room[33] = v29 * v38 - Y4 * (s2m3_mp * T32 + c2m3_mp * v39)
    room[34] = v30 * v38 - Y4 * (s2m3_mm * T32 + c2m3_mm * v39)
    room[35] = v12 + w3_p * v10
    room[36] = v12 + w3_p * v11
    room[37] = v13 + w3_m * v10
    room[38] = v13 + w3_m * v11
    room[39] = T31 * c2m3_pp + s2m3_pp * v28
    room[40] = T31 * c2m3_pm + s2m3_pm * v28
    room[41] = T31 * c2m3_mp - s2m3_mp * v28
    room[42] = T31 * c2m3_mm - s2m3_mm * v28
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

    # theta1, type 2: U1[3, 4]
    q1__m = angle1 - math.copysign(half_turn, Y1)

    # theta3, type 6: U1[2, 4] and U1[1, 4]
    q3__pp = angle2 - turn1
    v6 = turn1 + angle2
    q3__mp = angle3 - turn1
    v7 = turn1 + angle3

    # theta4, type 2: U4[3, 3]
    q4_ppm = angle4 - v36
    q4_pmm = angle5 - v36
    q4_mpm = angle6 - v37
    q4_mmm = angle7 - v37

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    q6_ppm = angle8 - math.copysign(half_turn, v42)
    q6_pmm = angle9 - math.copysign(half_turn, v43)
    q6_mpm = angle10 - math.copysign(half_turn, v44)
    q6_mmm = angle11 - math.copysign(half_turn, v45)

    # joint values
    v47 = angle12 - offset2
    v48 = angle13 - offset2
    v49 = angle14 - offset2
    v50 = angle15 - offset2
    q2_ppp = v47 + (-turn if half_turn < v47 else 0.0)
    q2_pmp = v48 + (-turn if half_turn < v48 else 0.0)
    q2_mpp = v49 + (-turn if half_turn < v49 else 0.0)
    q2_mmp = v50 + (-turn if half_turn < v50 else 0.0)
    v51 = angle16 - offset5
    v52 = offset5 + angle16
    v53 = angle17 - offset5
    v54 = offset5 + angle17
    v55 = angle18 - offset5
    v56 = offset5 + angle18
    v57 = angle19 - offset5
    v58 = offset5 + angle19
    q5_ppp = v51 + (turn if v51 <= -half_turn else 0.0)
    q5_ppm = (turn if -v52 <= -half_turn else 0.0) - v52
    q5_pmp = v53 + (turn if v53 <= -half_turn else 0.0)
    q5_pmm = (turn if -v54 <= -half_turn else 0.0) - v54
    q5_mpp = v55 + (turn if v55 <= -half_turn else 0.0)
    q5_mpm = (turn if -v56 <= -half_turn else 0.0) - v56
    q5_mmp = v57 + (turn if v57 <= -half_turn else 0.0)
    q5_mmm = (turn if -v58 <= -half_turn else 0.0) - v58
    v59 = q3__pp + (-turn if half_turn < q3__pp else 0.0)
    v60 = (-turn if half_turn < -v6 else 0.0) - v6
    v61 = q3__mp + (-turn if half_turn < q3__mp else 0.0)
    v62 = (-turn if half_turn < -v7 else 0.0) - v7
    v63 = abs(angle1) - high1
    v64 = abs(q1__m) - high1
    v65 = v59 + (turn if v59 < low3 else 0.0)
    v66 = v60 + (turn if v60 < low3 else 0.0)
    v67 = v61 + (turn if v61 < low3 else 0.0)
    v68 = v62 + (turn if v62 < low3 else 0.0)
    v69 = max(low3 - v65, v65 - high3)
    v70 = max(low3 - v66, v66 - high3)
    v71 = max(low3 - v67, v67 - high3)
    v72 = max(low3 - v68, v68 - high3)
    v73 = low3 - v59
    v74 = low3 - v60
    v75 = low3 - v61
    v76 = low3 - v62
    v77 = v73 if v73 < v69 else v69
    v78 = v74 if v74 < v70 else v70
    v79 = v75 if v75 < v71 else v71
    v80 = v76 if v76 < v72 else v72
    q3_ppp = v59 if 0.0 < v77 else v65
    q3_pmp = v60 if 0.0 < v78 else v66
    q3_mpp = v61 if 0.0 < v79 else v67
    q3_mmp = v62 if 0.0 < v80 else v68
    q1_ppp = angle1 + (w3_p - w3_p)
    q1_mpp = q1__m + (w3_m - w3_m)
    v81 = max(v77, max(v63, max(low2 - q2_ppp, q2_ppp - high2)))
    v82 = max(v78, max(v63, max(low2 - q2_pmp, q2_pmp - high2)))
    v83 = max(v79, max(v64, max(low2 - q2_mpp, q2_mpp - high2)))
    v84 = max(v80, max(v64, max(low2 - q2_mmp, q2_mmp - high2)))
    excess_ppp = max(v81, abs(q5_ppp) - high5)
    excess_ppm = max(v81, abs(q5_ppm) - high5)
    excess_pmp = max(v82, abs(q5_pmp) - high5)
    excess_pmm = max(v82, abs(q5_pmm) - high5)
    excess_mpp = max(v83, abs(q5_mpp) - high5)
    excess_mpm = max(v83, abs(q5_mpm) - high5)
    excess_mmp = max(v84, abs(q5_mmp) - high5)
    excess_mmm = max(v84, abs(q5_mmm) - high5)
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
    q[0, 1] = q2_ppp
    q[0, 2] = q3_ppp
    q[0, 3] = angle4
    q[0, 4] = q5_ppp
    q[0, 5] = angle8
    status[0] = UNREACHABLE if q[0, 0] != q[0, 0] else (OUT_OF_LIMITS if outside_ppp else OK)
    q[1, 0] = q1_ppp
    q[1, 1] = q2_ppp
    q[1, 2] = q3_ppp
    q[1, 3] = q4_ppm
    q[1, 4] = q5_ppm
    q[1, 5] = q6_ppm
    status[1] = UNREACHABLE if q[1, 0] != q[1, 0] else (OUT_OF_LIMITS if outside_ppm else OK)
    q[2, 0] = q1_ppp
    q[2, 1] = q2_pmp
    q[2, 2] = q3_pmp
    q[2, 3] = angle5
    q[2, 4] = q5_pmp
    q[2, 5] = angle9
    status[2] = UNREACHABLE if q[2, 0] != q[2, 0] else (OUT_OF_LIMITS if outside_pmp else OK)
    q[3, 0] = q1_ppp
    q[3, 1] = q2_pmp
    q[3, 2] = q3_pmp
    q[3, 3] = q4_pmm
    q[3, 4] = q5_pmm
    q[3, 5] = q6_pmm
    status[3] = UNREACHABLE if q[3, 0] != q[3, 0] else (OUT_OF_LIMITS if outside_pmm else OK)
    q[4, 0] = q1_mpp
    q[4, 1] = q2_mpp
    q[4, 2] = q3_mpp
    q[4, 3] = angle6
    q[4, 4] = q5_mpp
    q[4, 5] = angle10
    status[4] = UNREACHABLE if q[4, 0] != q[4, 0] else (OUT_OF_LIMITS if outside_mpp else OK)
    q[5, 0] = q1_mpp
    q[5, 1] = q2_mpp
    q[5, 2] = q3_mpp
    q[5, 3] = q4_mpm
    q[5, 4] = q5_mpm
    q[5, 5] = q6_mpm
    status[5] = UNREACHABLE if q[5, 0] != q[5, 0] else (OUT_OF_LIMITS if outside_mpm else OK)
    q[6, 0] = q1_mpp
    q[6, 1] = q2_mmp
    q[6, 2] = q3_mmp
    q[6, 3] = angle7
    q[6, 4] = q5_mmp
    q[6, 5] = angle11
    status[6] = UNREACHABLE if q[6, 0] != q[6, 0] else (OUT_OF_LIMITS if outside_mmp else OK)
    q[7, 0] = q1_mpp
    q[7, 1] = q2_mmp
    q[7, 2] = q3_mmp
    q[7, 3] = q4_mmm
    q[7, 4] = q5_mmm
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
            t14 = T14 - d6 * T11
            Y1 = d6 * T21 - T24
            v1 = t14 * t14 + Y1 * Y1
            w1 = math.sqrt(v1)
            v2 = 1.0 / v1
            Z1_3 = T34 - d6 * T31 - d1
            v3 = a1 + w1
            v4 = a1 - w1
            v5 = Z1_3 * Z1_3
            N3_p = v5 + v3 * v3
            N3_m = v5 + v4 * v4
            D3_p = (longest3 - N3_p) * (N3_p - shortest3)
            D3_m = (longest3 - N3_m) * (N3_m - shortest3)
            w3_p = math.sqrt(D3_p)
            w3_m = math.sqrt(D3_m)
            Y1_2_p = m4 * N3_p - m5
            Y1_2_m = m4 * N3_m - m5
            v8 = Z1_3 * Y1_2_p
            v9 = Z1_3 * Y1_2_m
            v10 = m4 * Z1_3
            v11 = m4 * -Z1_3
            v12 = v3 * -Y1_2_p
            v13 = v4 * -Y1_2_m
            factor2_p = 1.0 / N3_p
            factor2_m = 1.0 / N3_m
            v14 = m6 * Z1_3
            v15 = m7 * v3 - v14
            v16 = m7 * v4 - v14
            v17 = m7 + m8 * factor2_p
            v18 = m7 + m8 * factor2_m
            v19 = m6 + m9 * factor2_p
            v20 = m6 + m9 * factor2_m
            v21 = Z1_3 * v17 + v3 * v19
            v22 = Z1_3 * v18 + v4 * v20
            c2m3_pp = w3_p * (factor2_p * v15) - v21
            c2m3_pm = w3_p * (factor2_p * -v15) - v21
            c2m3_mp = w3_m * (factor2_m * v16) - v22
            c2m3_mm = w3_m * (factor2_m * -v16) - v22
            v23 = m7 * Z1_3
            v24 = v3 * v17 - Z1_3 * v19
            v25 = v4 * v18 - Z1_3 * v20
            v26 = w3_p * (factor2_p * (v23 + m6 * v3))
            s2m3_pp = v24 + v26
            s2m3_pm = v24 - v26
            v27 = w3_m * (factor2_m * (v23 + m6 * v4))
            s2m3_mp = v25 + v27
            s2m3_mm = v25 - v27
            v28 = w1 * (v2 * (T21 * Y1 - T11 * t14))
            X4_pp = c2m3_pp * v28 - T31 * s2m3_pp
            X4_pm = c2m3_pm * v28 - T31 * s2m3_pm
            v29 = c2m3_mp * v28 + T31 * s2m3_mp
            v30 = c2m3_mm * v28 + T31 * s2m3_mm
            Y4 = w1 * (v2 * (T11 * Y1 + t14 * T21))
            v31 = Y4 * Y4
            v32 = v31 + X4_pp * X4_pp
            v33 = v31 + X4_pm * X4_pm
            v34 = v31 + v29 * v29
            v35 = v31 + v30 * v30
            v36 = math.copysign(half_turn, Y4)
            v37 = math.copysign(half_turn, -Y4)
            v38 = w1 * (v2 * (t14 * T22 + Y1 * T12))
            v39 = w1 * (v2 * (Y1 * T22 - t14 * T12))
            v40 = w1 * (v2 * (t14 * T23 + Y1 * T13))
            v41 = w1 * (v2 * (Y1 * T23 - t14 * T13))
            v42 = Y4 * (s2m3_pp * T33 - c2m3_pp * v41) - -X4_pp * v40
            v43 = Y4 * (s2m3_pm * T33 - c2m3_pm * v41) - -X4_pm * v40
            v44 = v29 * v40 - Y4 * (s2m3_mp * T33 + c2m3_mp * v41)
            v45 = v30 * v40 - Y4 * (s2m3_mm * T33 + c2m3_mm * v41)
            v46 = w3_p * (m4 * v3)
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
            work[576 + k] = Y4
            work[592 + k] = Y4
            work[608 + k] = -Y4
            work[624 + k] = -Y4
            work[640 + k] = v42
            work[656 + k] = v43
            work[672 + k] = v44
            work[688 + k] = v45
            work[704 + k] = -(v8 + v46)
            work[720 + k] = v46 - v8
            work[736 + k] = -(v9 + w3_m * (m4 * v4))
            work[752 + k] = -(v9 + w3_m * (m4 * -v4))
            work[768 + k] = math.sqrt(v32)
            work[784 + k] = math.sqrt(v33)
            work[800 + k] = math.sqrt(v34)
            work[816 + k] = math.sqrt(v35)
            work[832 + k] = -t14
            work[848 + k] = N3_p - k3
            work[864 + k] = N3_m - k3
            work[880 + k] = -X4_pp
            work[896 + k] = -X4_pm
            work[912 + k] = v29
            work[928 + k] = v30
            work[944 + k] = Y4 * (s2m3_pp * T32 - c2m3_pp * v39) - -X4_pp * v38
            work[960 + k] = Y4 * (s2m3_pm * T32 - c2m3_pm * v39) - -X4_pm * v38
            work[976 + k] = v29 * v38 - Y4 * (s2m3_mp * T32 + c2m3_mp * v39)
            work[992 + k] = v30 * v38 - Y4 * (s2m3_mm * T32 + c2m3_mm * v39)
            work[1008 + k] = v12 + w3_p * v10
            work[1024 + k] = v12 + w3_p * v11
            work[1040 + k] = v13 + w3_m * v10
            work[1056 + k] = v13 + w3_m * v11
            work[1072 + k] = T31 * c2m3_pp + s2m3_pp * v28
            work[1088 + k] = T31 * c2m3_pm + s2m3_pm * v28
            work[1104 + k] = T31 * c2m3_mp - s2m3_mp * v28
            work[1120 + k] = T31 * c2m3_mm - s2m3_mm * v28
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
            q1__m = angle1 - math.copysign(half_turn, Y1)
            q3__pp = angle2 - turn1
            v6 = turn1 + angle2
            q3__mp = angle3 - turn1
            v7 = turn1 + angle3
            q4_ppm = angle4 - v36
            q4_pmm = angle5 - v36
            q4_mpm = angle6 - v37
            q4_mmm = angle7 - v37
            q6_ppm = angle8 - math.copysign(half_turn, v42)
            q6_pmm = angle9 - math.copysign(half_turn, v43)
            q6_mpm = angle10 - math.copysign(half_turn, v44)
            q6_mmm = angle11 - math.copysign(half_turn, v45)
            v47 = angle12 - offset2
            v48 = angle13 - offset2
            v49 = angle14 - offset2
            v50 = angle15 - offset2
            q2_ppp = v47 + (-turn if half_turn < v47 else 0.0)
            q2_pmp = v48 + (-turn if half_turn < v48 else 0.0)
            q2_mpp = v49 + (-turn if half_turn < v49 else 0.0)
            q2_mmp = v50 + (-turn if half_turn < v50 else 0.0)
            v51 = angle16 - offset5
            v52 = offset5 + angle16
            v53 = angle17 - offset5
            v54 = offset5 + angle17
            v55 = angle18 - offset5
            v56 = offset5 + angle18
            v57 = angle19 - offset5
            v58 = offset5 + angle19
            q5_ppp = v51 + (turn if v51 <= -half_turn else 0.0)
            q5_ppm = (turn if -v52 <= -half_turn else 0.0) - v52
            q5_pmp = v53 + (turn if v53 <= -half_turn else 0.0)
            q5_pmm = (turn if -v54 <= -half_turn else 0.0) - v54
            q5_mpp = v55 + (turn if v55 <= -half_turn else 0.0)
            q5_mpm = (turn if -v56 <= -half_turn else 0.0) - v56
            q5_mmp = v57 + (turn if v57 <= -half_turn else 0.0)
            q5_mmm = (turn if -v58 <= -half_turn else 0.0) - v58
            v59 = q3__pp + (-turn if half_turn < q3__pp else 0.0)
            v60 = (-turn if half_turn < -v6 else 0.0) - v6
            v61 = q3__mp + (-turn if half_turn < q3__mp else 0.0)
            v62 = (-turn if half_turn < -v7 else 0.0) - v7
            v63 = abs(angle1) - high1
            v64 = abs(q1__m) - high1
            v65 = v59 + (turn if v59 < low3 else 0.0)
            v66 = v60 + (turn if v60 < low3 else 0.0)
            v67 = v61 + (turn if v61 < low3 else 0.0)
            v68 = v62 + (turn if v62 < low3 else 0.0)
            v69 = max(low3 - v65, v65 - high3)
            v70 = max(low3 - v66, v66 - high3)
            v71 = max(low3 - v67, v67 - high3)
            v72 = max(low3 - v68, v68 - high3)
            v73 = low3 - v59
            v74 = low3 - v60
            v75 = low3 - v61
            v76 = low3 - v62
            v77 = v73 if v73 < v69 else v69
            v78 = v74 if v74 < v70 else v70
            v79 = v75 if v75 < v71 else v71
            v80 = v76 if v76 < v72 else v72
            q3_ppp = v59 if 0.0 < v77 else v65
            q3_pmp = v60 if 0.0 < v78 else v66
            q3_mpp = v61 if 0.0 < v79 else v67
            q3_mmp = v62 if 0.0 < v80 else v68
            q1_ppp = angle1 + (w3_p - w3_p)
            q1_mpp = q1__m + (w3_m - w3_m)
            v81 = max(v77, max(v63, max(low2 - q2_ppp, q2_ppp - high2)))
            v82 = max(v78, max(v63, max(low2 - q2_pmp, q2_pmp - high2)))
            v83 = max(v79, max(v64, max(low2 - q2_mpp, q2_mpp - high2)))
            v84 = max(v80, max(v64, max(low2 - q2_mmp, q2_mmp - high2)))
            excess_ppp = max(v81, abs(q5_ppp) - high5)
            excess_ppm = max(v81, abs(q5_ppm) - high5)
            excess_pmp = max(v82, abs(q5_pmp) - high5)
            excess_pmm = max(v82, abs(q5_pmm) - high5)
            excess_mpp = max(v83, abs(q5_mpp) - high5)
            excess_mpm = max(v83, abs(q5_mpm) - high5)
            excess_mmp = max(v84, abs(q5_mmp) - high5)
            excess_mmm = max(v84, abs(q5_mmm) - high5)
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
            _1152 = q2_ppp
            work[1152 + k] = _1152
            _1168 = q3_ppp
            work[1168 + k] = _1168
            _1184 = angle4
            work[1184 + k] = _1184
            _1200 = q5_ppp
            work[1200 + k] = _1200
            _1216 = angle8
            work[1216 + k] = _1216
            _1232 = q4_ppm
            work[1232 + k] = _1232
            _1248 = q5_ppm
            work[1248 + k] = _1248
            _1264 = q6_ppm
            work[1264 + k] = _1264
            _1280 = q2_pmp
            work[1280 + k] = _1280
            _1296 = q3_pmp
            work[1296 + k] = _1296
            _1312 = angle5
            work[1312 + k] = _1312
            _1328 = q5_pmp
            work[1328 + k] = _1328
            _1344 = angle9
            work[1344 + k] = _1344
            _1360 = q4_pmm
            work[1360 + k] = _1360
            _1376 = q5_pmm
            work[1376 + k] = _1376
            _1392 = q6_pmm
            work[1392 + k] = _1392
            _1408 = q1_mpp
            work[1408 + k] = _1408
            _1424 = q2_mpp
            work[1424 + k] = _1424
            _1440 = q3_mpp
            work[1440 + k] = _1440
            _1456 = angle6
            work[1456 + k] = _1456
            _1472 = q5_mpp
            work[1472 + k] = _1472
            _1488 = angle10
            work[1488 + k] = _1488
            _1504 = q4_mpm
            work[1504 + k] = _1504
            _1520 = q5_mpm
            work[1520 + k] = _1520
            _1536 = q6_mpm
            work[1536 + k] = _1536
            _1552 = q2_mmp
            work[1552 + k] = _1552
            _1568 = q3_mmp
            work[1568 + k] = _1568
            _1584 = angle7
            work[1584 + k] = _1584
            _1600 = q5_mmp
            work[1600 + k] = _1600
            _1616 = angle11
            work[1616 + k] = _1616
            _1632 = q4_mmm
            work[1632 + k] = _1632
            _1648 = q5_mmm
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
