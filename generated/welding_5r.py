"""welding_5r: Welding arm with five joints, its torch tilted aside.

Inverse kinematics, generated from robots/welding_5r.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/welding_5r.yaml. The formulas and where they come from: welding_5r.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
position T[0:3, 3] and the tool's z axis T[0:3, 2] counts; other entries are ignored.
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


_HOW = _runtime("jit").of_file(__file__, interface=1)
_arms, _status, _functions = _runtime("arm"), _runtime("status"), _runtime("functions")
_atan2 = _runtime("angles").atan2
_wrap = _runtime("angles").wrap
_circle = _runtime("circle_roots")
_circle_roots = _circle.circle_roots
_of_joints = _runtime("entry").of_joints(_HOW, 5)

NAME = "welding_5r"
METHOD = "quartic"
DOF = 5
JOINT_TYPES = "RRRRR"
JOINT_LIMITS = (
    (-2.9670597283903604, 2.9670597283903604),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = (
    "root1-elbow+",
    "root1-elbow-",
    "root2-elbow+",
    "root2-elbow-",
    "root3-elbow+",
    "root3-elbow-",
    "root4-elbow+",
    "root4-elbow-",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds.
OK = 0  # joint values
UNREACHABLE = 1  # NaN: no solution in this branch, or one that an earlier row holds
FREE_JOINT = 2  # joint values; a joint was indeterminate and took the seed's value, or one near it
OUT_OF_LIMITS = 3  # joint values, at least one beyond its limits
INVALID_POSE = 4  # NaN: T is not a valid pose

d1 = 0.3  # joint offset 1 [m]
a1 = 0.08  # link length 1 [m]
L2 = 0.5  # link length 2 [m]
L3 = 0.45  # link length 3 [m]
d4 = 0.03  # joint offset 4 [m]
d5 = 0.12  # joint offset 5 [m]
ex = 0.02  # x of the tool frame [m]
ez = 0.1  # z of the tool frame [m]
free_limit2 = 2.5600000000000004e-12  # a length that fixes no angle [m^2]
square_rounding = 1e-15  # squares are rounded by this
near_limit = 0.001  # a length whose direction is good to few digits
double_root = 1e-13  # a polynomial's value at a root, relative to its coefficients
free_limit_squared = 1e-24  # square of a length that fixes no angle
near_limit_squared = 1e-06  # square of a length whose direction is good to few digits
longest3 = 0.9025  # square of the longest reach [m^2]
shortest3 = 0.0024999999999999988  # square of the shortest reach [m^2]
longest3_reach = 0.902530400256  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0024984002559999986  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.9024999999999695  # the longest, where branches merge [m^2]
shortest3_apart = 0.002500000000001599  # the shortest, where branches merge [m^2]
longest3_clear = 0.9024999999696  # the longest, where blurred branches do [m^2]
shortest3_clear = 0.002500000001599999  # the shortest, where blurred branches do [m^2]
free_limit_squared2 = 2.5600000000000005e-24  # square of a length that fixes no angle [m^2]
# square of a length whose direction is good to few digits [m^2]
near_limit_squared2 = 2.5600000000000005e-06
k1 = 0.5  # 1 / 2
k2 = 0.06  # d4 * 2 [m]
k3 = 0.0009  # d4^2 [m^2]
k4 = 0.0004  # ex^2 [m^2]
k5 = -50.0  # -1 / ex [m^-1]
k6 = 0.4525  # L2^2 + L3^2 [m^2]
k7 = 2.2222222222222223  # 1 / (2 * L3 * L2) [m^-2]
turn = 2.0 * math.pi  # [rad]
half_turn = 0.5 * turn

_ARM = _arms.arm_numbers(
    _arms.Arm(
        types=JOINT_TYPES,
        limits=JOINT_LIMITS,
        slacks=(1e-09, 1e-09, 1e-09, 1e-09, 1e-09),
        weights=(1.0, 1.0, 1.0, 1.0, 1.0),
        paces=(1.0, 1.0, 1.0, 1.0, 1.0),
        fan_steps=(
            0.09817477042468103, 0.09817477042468103, 0.09817477042468103, 0.09817477042468103,
            0.09817477042468103,
        ),
        rows=8,
        directions='pointing',
        miss_weights=(0.625, 0.625, 0.625, 1.0, 1.0, 1.0),
        size=1.6,
        entries=(2, 3, 6, 7, 10, 11),
        steps=('retries', 'keeps limits', 'completes', 'merges', 'clamps', 'follows seed'),
        choosable=(3, 2, 1, 0),
        cuts=52,
    )
)


class Unreachable(ValueError):  # noqa: N818
    """There is no solution, or none inside the limits; the message says which."""


@_of_joints
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
    z4_z = x3_z * s4 - y3_z * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    x5_x = x4_x * c5 + s1 * s5
    x5_y = x4_y * c5 - c1 * s5
    x5_z = x4_z * c5
    z5_y = c1 * c5 + x4_y * s5
    z5_z = x4_z * s5
    z5_x = x4_x * s5 - s1 * c5
    T[0, 0] = x5_x
    T[0, 1] = z4_x
    T[0, 2] = z5_x
    T[0, 3] = c1 * a1 + x2_x * L2 + x3_x * L3 + s1 * d4 + z4_x * d5 + x5_x * ex + z5_x * ez
    T[1, 0] = x5_y
    T[1, 1] = z4_y
    T[1, 2] = z5_y
    T[1, 3] = s1 * a1 + x2_y * L2 + x3_y * L3 - c1 * d4 + z4_y * d5 + x5_y * ex + z5_y * ez
    T[2, 0] = x5_z
    T[2, 1] = z4_z
    T[2, 2] = z5_z
    T[2, 3] = d1 + s2 * L2 + x3_z * L3 + z4_z * d5 + x5_z * ex + z5_z * ez
    T[3, 3] = 1.0
    return T


@_of_joints
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
    p2_x = p1_x + x2_x * L2
    p2_y = p1_y + x2_y * L2
    p2_z = d1 + s2 * L2
    c3 = math.cos(q[2])
    s3 = math.sin(q[2])
    x3_x = x2_x * c3 - v1 * s3
    x3_y = x2_y * c3 - v2 * s3
    x3_z = s2 * c3 + c2 * s3
    v3 = v1 * c3 + x2_x * s3
    v4 = v2 * c3 + x2_y * s3
    y3_z = c2 * c3 - s2 * s3
    p3_x = p2_x + x3_x * L3
    p3_y = p2_y + x3_y * L3
    p3_z = p2_z + x3_z * L3
    c4 = math.cos(q[3])
    s4 = math.sin(q[3])
    x4_x = x3_x * c4 - v3 * s4
    x4_y = x3_y * c4 - v4 * s4
    x4_z = x3_z * c4 + y3_z * s4
    z4_x = v3 * c4 + x3_x * s4
    z4_y = v4 * c4 + x3_y * s4
    p4_x = p3_x + s1 * d4
    p4_y = p3_y - c1 * d4
    z4_z = x3_z * s4 - y3_z * c4
    c5 = math.cos(q[4])
    s5 = math.sin(q[4])
    J21 = p4_x + z4_x * d5 + (x4_x * c5 + s1 * s5) * ex + (x4_x * s5 - s1 * c5) * ez
    v5 = p4_y + z4_y * d5 + (x4_y * c5 - c1 * s5) * ex + (c1 * c5 + x4_y * s5) * ez
    v6 = p3_z + z4_z * d5 + x4_z * c5 * ex + x4_z * s5 * ez
    v7 = v6 - d1
    v8 = v6 - p2_z
    v9 = v6 - p3_z
    v10 = J21 - p4_x
    v11 = v5 - p4_y
    J[0, 0] = -v5
    J[0, 1] = -(c1 * v7)
    J[0, 2] = -(c1 * v8)
    J[0, 3] = -(c1 * v9)
    J[0, 4] = z4_y * v9 - z4_z * v11
    J[1, 0] = J21
    J[1, 1] = -(s1 * v7)
    J[1, 2] = -(s1 * v8)
    J[1, 3] = -(s1 * v9)
    J[1, 4] = z4_z * v10 - z4_x * v9
    J[2, 1] = s1 * (v5 - p1_y) + c1 * (J21 - p1_x)
    J[2, 2] = s1 * (v5 - p2_y) + c1 * (J21 - p2_x)
    J[2, 3] = s1 * (v5 - p3_y) + c1 * (J21 - p3_x)
    J[2, 4] = z4_x * v11 - z4_y * v10
    J[3, 1] = s1
    J[3, 2] = s1
    J[3, 3] = s1
    J[3, 4] = z4_x
    J[4, 1] = -c1
    J[4, 2] = -c1
    J[4, 3] = -c1
    J[4, 4] = z4_y
    J[5, 0] = 1.0
    J[5, 4] = z4_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, T13, T14, _, _, T23, T24, _, _, T33, T34 = pose

    # theta1, type 9: U1[3, 4] and U1[3, 3]
    v1 = ex * T23
    v2 = ex * T13
    v3 = ez * T23 - T24
    v4 = T14 - ez * T13
    v5 = v1 * v1
    v6 = v2 * v2
    v7 = v3 * v3
    v8 = v4 * v4
    v9 = v3 * k2
    v10 = v4 * k2
    v11 = k1 * (v5 + v6) + (k3 + k1 * (v7 + v8))
    v12 = k1 * (v5 - v6) + k1 * (v7 - v8)
    v13 = v3 * v4 - v1 * v2
    v14 = v11 - k4
    v15 = abs(v14) + abs(v9) + abs(v10) + abs(v12) + abs(v13)
    free1 = v15 <= free_limit2
    v16 = square_rounding * (v11 + k4)
    x1_roots, x1_close = _circle_roots(1.0 if free1 else v14, -1.0 if free1 else -v9, 0.0 if free1
        else -v10, 0.0 if free1 else v12, 0.0 if free1 else v13, v16, moved)
    v19 = math.cos(seed[0]) * math.cos(seed[0]) - math.sin(seed[0]) * math.sin(seed[0])
    v20 = 2.0 * (math.cos(seed[0]) * math.sin(seed[0]))
    v21 = 2.0 * v13
    v22 = 2.0 * v12
    v24 = v15 * near_limit
    v25 = v19 * v21 + (v9 * math.sin(seed[0]) - v10 * math.cos(seed[0])) - v20 * v22
    v26 = (
        abs(v14 + (v13 * v20 + (v12 * v19 - (v9 * math.cos(seed[0]) + v10 * math.sin(seed[0]))))) <=
        v16 + v15 * double_root
    )

    # theta234, type 3: U1[2, 3] and U1[1, 3]
    v28 = seed[1] + seed[2] + seed[3]

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v30 = T34 - d1

    for i1 in range(4):  # root1, root2, root3, root4
        x1 = x1_roots[i1]
        # theta1
        if not (x1 <= 4.0):
            continue  # out of reach
        v17 = math.cos(x1)
        v18 = math.sin(x1)
        v23 = (v17 * v17 - v18 * v18) * v21 + (v9 * v18 - v10 * v17) - 2.0 * (v17 * v18) * v22
        near1 = abs(v23) <= v24
        same1 = (
            -(double_root * (v15 * v15)) <= v23 * v25 and 0.0 < v17 * math.cos(seed[0]) + v18 *
            math.sin(seed[0]) and abs(v17 * math.sin(seed[0]) - v18 * math.cos(seed[0])) <=
            near_limit and near1 and v26
        )
        v27 = seed[0] if same1 else x1
        q1 = seed[0] if free1 else v27
        c1 = math.cos(q1)
        s1 = math.sin(q1)

        # theta5, type 3: U1[3, 4] and U1[3, 3]
        Z2_5 = T13 * s1 - T23 * c1
        s5 = (d4 - (T14 * s1 - T24 * c1) + ez * Z2_5) * k5
        c5 = ex * Z2_5 * k5
        q5 = _atan2(s5, c5)

        # theta234
        S234 = s5 * T33
        C234 = s5 * (T13 * c1 + T23 * s1)
        w234 = math.sqrt(S234 * S234 + C234 * C234)
        free234 = w234 <= free_limit_squared
        near234 = w234 <= near_limit_squared
        factor234 = 1.0 / (1.0 if free234 else w234)
        c234 = math.cos(v28) if free234 else C234 * factor234
        s234 = math.sin(v28) if free234 else S234 * factor234
        theta234 = _atan2(s234, c234)

        # theta3
        v29 = ex * c5 + ez * s5
        Z1_3 = c234 * d5 - s234 * v29 + v30
        Z2_3 = T14 * c1 + T24 * s1 - a1 - (c234 * v29 + s234 * d5)
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
        K3 = N3 - k6
        D3 = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            if near1:
                status[2 * i1] = _status.NEARLY + 1
                q[2 * i1, 0] = D3
                q[2 * i1, 1] = v27
            if free1:
                status[2 * i1] = _status.LOST + 1
                q[2 * i1, 0] = D3
            if free234:
                status[2 * i1] = _status.LOST + 2
                q[2 * i1, 0] = D3
            if free234:
                status[2 * i1] = _status.LOST + 3
                q[2 * i1, 0] = D3
            if free234:
                status[2 * i1] = _status.LOST + 4
                q[2 * i1, 0] = D3
            continue  # out of reach
        w3 = math.sqrt(D3 if apart3 else 0.0)
        c3 = K3 * k7

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        X1_2 = L2 + L3 * c3
        v31 = Z1_3 * X1_2
        v32 = Z2_3 * X1_2

        for i2 in range(2):  # elbow+, elbow-
            e2 = 1.0 - 2.0 * i2
            # theta3
            if (
                e2 < 0.0 and (not apart3 or (near1 and not (shortest3_clear < N3 and N3 <
                longest3_clear)))
            ):
                continue  # both signs give the same
            s3 = w3 * e2 * k7
            q3 = _atan2(s3, c3)

            # theta2
            Y1_2 = L3 * s3
            S2 = v31 - Z2_3 * Y1_2
            C2 = v32 + Z1_3 * Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            near2 = w2 <= near_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else S2 * factor2
            q2 = _atan2(s2, c2)

            # joint values
            q4 = _wrap(theta234 - (q3 + q2))
            row = 2 * i1 + i2
            q[row, 0] = q1
            q[row, 1] = q2
            q[row, 2] = q3
            q[row, 3] = q4
            q[row, 4] = q5
            status[row] = (
                FREE_JOINT if free1 or free234 or free2 else _status.CLOSE if x1_close[i1] or near1
                or near234 or near2 else OK
            )


_inner, _apart = _HOW.inner, _HOW.apart
_room, carray = _runtime("jit").room, _runtime("jit").carray
_CLOSE = _status.CLOSE
_measured, _refined = _runtime("refine").missed_by, _runtime("refine").refine
_robot = _HOW.addresses("_solve", "fk", "jacobian", None)
_sum_beyond = _runtime("limits").beyond_limits


@_inner
def _missed_by(pose, q):
    """By how much joint values miss the entries that count: the root of the sum of squares."""
    return _measured(_ARM, _robot(), pose, q)


@_inner
def _beyond_limits(q):
    """How far joint values are beyond their limits."""
    return _sum_beyond(_ARM, q)


@_inner
def _settled(pose, enough, most, q):
    """Takes joint values to some inside their limits."""
    return _refined(_ARM, _robot(), pose, enough, most, q)


# The joints that are solved for, and whether they turn; what a step of one means, in rad or
# lengths, and the same over the arm's size. Below, u are these joints in units.
_SOLVED = np.array([0, 1, 2, 3, 4])
_TURNING = np.array([True, True, True, True, True])
_UNIT = np.array([1.0, 1.0, 1.0, 1.0, 1.0])
_MEASURE = np.array([0.625, 0.625, 0.625, 0.625, 0.625])


@_inner
def _turn_vector(axis, cosine, vector):
    """The rotation vector of an axis times the sine, and the cosine."""
    sine = math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2])
    if sine < 1e-09 and cosine < 0.0:  # half a turn: any axis will do
        vector[0] = 1.5079644737231006
        vector[1] = 1.8849555921538759
        vector[2] = 2.0106192982974678
        return
    scale = 1.0 if sine < 1e-09 else math.atan2(sine, cosine) / sine
    for i in range(3):
        vector[i] = scale * axis[i]


@_inner
def _look(T, q, u, e, A):
    """By how much u misses the pose, into e and returned as a length, and its Jacobian into A."""
    for j in range(5):
        q[_SOLVED[j]] = _UNIT[j] * u[j]
    P, J = fk(q), jacobian(q)
    for j in range(5):
        column = _SOLVED[j]
        A[0, j] = _MEASURE[j] * J[0, column]
        A[1, j] = _MEASURE[j] * J[1, column]
        A[2, j] = _MEASURE[j] * J[2, column]
        along = P[0, 2] * J[3, column] + P[1, 2] * J[4, column] + P[2, 2] * J[5, column]
        for i in range(3):  # turning about z changes nothing
            A[3 + i, j] = J[3 + i, column] - along * P[i, 2]
    e[0] = (T[0, 3] - P[0, 3]) / 1.6
    e[1] = (T[1, 3] - P[1, 3]) / 1.6
    e[2] = (T[2, 3] - P[2, 3]) / 1.6
    axis = (
        P[1, 2] * T[2, 2] - P[2, 2] * T[1, 2],
        P[2, 2] * T[0, 2] - P[0, 2] * T[2, 2],
        P[0, 2] * T[1, 2] - P[1, 2] * T[0, 2],
    )
    cosine = P[0, 2] * T[0, 2] + P[1, 2] * T[1, 2] + P[2, 2] * T[2, 2]
    _turn_vector(axis, cosine, e[3:])
    square = 0.0
    for i in range(6):
        square += e[i] * e[i]
    return math.sqrt(square)


# What is added from start to start, in parts of the range: a direction that is like no other.
_STRIDE = np.array([
    0.8812714616335696, 0.7766393890897682, 0.6844301295853426, 0.6031687406857283,
    0.5315553977157914,
])


@_inner
def _wrap_angles(u):
    """Moves angles by whole turns to (-pi, pi]."""
    for j in range(5):
        if _TURNING[j]:
            u[j] -= 6.283185307179586 * math.ceil(u[j] / 6.283185307179586 - 0.5)


@_inner
def _take(to, numbers):
    """Numbers into an array as long; for slices numba would compile the text of an error, too."""
    for i in range(len(numbers)):
        to[i] = numbers[i]


@_inner
def _shorten(step):
    """Makes a step no longer than it may be."""
    longest = 2.0
    for j in range(5):
        longest = max(longest, abs(step[j]))
    for j in range(5):
        step[j] *= 2.0 / longest


@_inner
def _damped_step(A, e, length, little, step):
    """The damped least squares step A' (A A' + damping)^-1 e, `little` the least damping.

    The rows of A, each with its share of the damping's root behind it, are made orthonormal one
    after another (modified Gram-Schmidt; used as by A. Bjorck, Numerics of Gram-Schmidt
    orthogonalization, 1994): the product A A' would lose half of the digits.
    """
    damping = 0.1 * min(length * length, 1.0) + little
    rows, y = np.zeros((6, 11)), np.empty(6)
    total = np.zeros(11)
    for i in range(6):
        for j in range(5):
            rows[i, j] = A[i, j]
        rows[i, 5 + i] = math.sqrt(damping)
        y[i] = e[i]
        for k in range(i):
            along = 0.0
            for j in range(11):
                along += rows[k, j] * rows[i, j]
            for j in range(11):
                rows[i, j] -= along * rows[k, j]
            y[i] -= along * y[k]
        square = 0.0
        for j in range(11):
            square += rows[i, j] * rows[i, j]
        inverse = 1.0 / math.sqrt(square)
        y[i] *= inverse
        for j in range(11):
            rows[i, j] *= inverse
    for i in range(5, -1, -1):
        missing = y[i]
        for j in range(11):
            missing -= rows[i, j] * total[j]
        for j in range(11):
            total[j] += missing * rows[i, j]
    for j in range(5):
        step[j] = total[j]


@_apart("float64(float64[:, ::1], int64, float64, float64[::1], float64[::1])")
def _descended(T, steps, exact, q, ahead):
    """Takes a row as far as steps help, and tells how long another one would be, into `ahead`.

    Returns by how much the row misses the pose then. Beside a singular place a step that is right
    may be long, and what it leaves, half of its square, far more than was missed.
    """
    e, A = np.empty(6), np.empty((6, 5))
    joints, u, step = q.copy(), np.empty(5), np.empty(5)
    for j in range(5):
        u[j] = q[_SOLVED[j]] / _UNIT[j]
    best, least, last, left = u.copy(), math.inf, math.inf, 0.0
    ahead[0] = math.inf
    for _ in range(steps + 1):
        length = _look(T, joints, u, e, A)
        _damped_step(A, e, length, 1e-26, step)
        slow = not length <= max(0.5 * last, left)
        if length < least:
            least, ahead[0] = length, np.abs(step).max()
            _take(best, u)
        if slow or (least <= 0.001 * exact and ahead[0] <= 0.0001):
            break
        _shorten(step)
        way = 0.0
        for j in range(5):
            u[j] += step[j]
            way += abs(step[j])
        last, left = length, 0.5 * way * way
    _wrap_angles(best)
    for j in range(5):
        q[_SOLVED[j]] = _UNIT[j] * best[j]
    return least


@_inner
def _sideways(A, along):
    """The part of a generic direction that leaves the tool where it is, to first order, one long.

    Returns how long it was.
    """
    moved, square = np.empty(6), 0.0
    for i in range(6):
        moved[i] = 0.0
        for j in range(5):
            moved[i] += A[i, j] * _STRIDE[j]
    _damped_step(A, moved, 0.0, 1e-13, along)
    for j in range(5):
        along[j] = _STRIDE[j] - along[j]
        square += along[j] * along[j]
    length = math.sqrt(square)
    for j in range(5):
        along[j] /= length
    return length


@_apart("float64(float64[:, ::1], float64, float64[::1])")
def _escaped(T, exact, q):
    """Takes a row as far as steps help, also from both sides of where they get slow.

    Where many solutions meet, joint values between them are singular. A root of four is missed by
    the fourth power of the way to it. Returns by how much the row misses the pose then.
    """
    e, A = np.empty(6), np.empty((6, 5))
    u, along, ahead = np.empty(5), np.empty(5), np.empty(1)
    ends, miss = np.empty((2, 5)), np.empty(2)
    least = _descended(T, 72, exact, q, ahead)
    for _ in range(8):
        if least <= exact:
            break
        for j in range(5):
            u[j] = q[_SOLVED[j]] / _UNIT[j]
        _look(T, q.copy(), u, e, A)
        if _sideways(A, along) <= 0.0001:
            break
        pace = math.sqrt(math.sqrt(least))
        for side in range(2):
            _take(ends[side], q)
            for j in range(5):
                ends[side, _SOLVED[j]] += pace * _UNIT[j] * along[j]
            pace = -pace
            miss[side] = _descended(T, 72, exact, ends[side], ahead)
        other = 1 if miss[1] < miss[0] else 0
        if not miss[other] < 0.9 * least:
            break
        least = miss[other]
        _take(q, ends[other])
    return least


@_inner
def _tightened(T, exact, first, q):
    """Takes a row to where damped least squares lead, unless it is exact.

    Returns by how much it misses the pose then, and whether it was moved; `first` is what it misses
    the pose by before.
    """
    if first <= exact:
        return first, False
    end, moved = q.copy(), False
    least = _escaped(T, exact, end)
    for i in range(5):
        moved = moved or q[i] != end[i]
        q[i] = end[i]
    return least, moved


@_inner
def _gap_between(q, other):
    """By how much the joint values of two rows differ at most."""
    gap = np.empty(5)
    for j in range(5):
        gap[j] = (q[_SOLVED[j]] - other[_SOLVED[j]]) / _UNIT[j]
    _wrap_angles(gap)
    return np.abs(gap).max()


@_inner
def _repeats(q, held, first, row):
    """Whether a row that was moved came to lie on one that missed by less at first."""
    for k in range(8):
        before = first[k] < first[row] or (k < row and first[k] <= first[row])
        if held[k] and before and _gap_between(q[k], q[row]) < 1e-06:
            return True
    return False


@_inner
def _exactness(pose):
    """What an exact row may miss: far away rounding is more."""
    distance = 1.0  # arm sizes
    distance = max(distance, abs(pose[3]) / 1.6)
    distance = max(distance, abs(pose[7]) / 1.6)
    distance = max(distance, abs(pose[11]) / 1.6)
    return 1e-12 * distance


@_inner
def _upper_rows(pose):
    """A pose as a matrix (3, 4)."""
    T = np.empty((3, 4))
    for i in range(3):
        for j in range(4):
            T[i, j] = pose[4 * i + j]
    return T


@_apart("void(float64[:, ::1], float64, float64[::1], float64[:, ::1], boolean[::1])")
def _tighten_rows(T, exact, miss, q, held):
    """Tightens the rows; ends those that miss the pose then, and all but one that have become the
    same."""
    moved, first = np.zeros(8, np.bool_), miss.copy()
    for row in range(8):
        if held[row]:
            miss[row], moved[row] = _tightened(T, exact, miss[row], q[row])
    enough = 10.0 * exact
    for row in range(8):
        held[row] = held[row] and miss[row] <= enough
    for row in range(8):
        if moved[row] and _repeats(q, held, first, row):
            held[row] = False


@_inner
def _tighten(pose, q, status):
    """Tightens the rows that have a solution; some may have none then."""
    exact = _exactness(pose)
    worst, miss = 0.0, carray(_room(8), 8)
    for row in range(8):
        miss[row] = 0.0 if status[row] == UNREACHABLE else _missed_by(pose, q[row])
        worst = max(worst, miss[row])
    if worst <= exact:
        return
    rows, held = q.copy(), np.empty(8, np.bool_)
    for row in range(8):
        held[row] = status[row] != UNREACHABLE
    _tighten_rows(_upper_rows(pose), exact, miss, rows, held)
    for row in range(8):
        if not held[row]:
            status[row] = UNREACHABLE
        for i in range(5):
            q[row, i] = rows[row, i] if held[row] else math.nan


@_inner
def _solves(T, steps, exact, q):
    """Whether joint values are a solution.

    Beside a singular place they may miss the pose by next to nothing and be far from any.
    """
    ahead = np.empty(1)
    return _descended(T, steps, exact, q, ahead) <= exact and ahead[0] <= 0.0001


@_inner
def _is_new(known, count, q):
    """Whether a solution is none of those."""
    for k in range(count):
        if _gap_between(known[k], q) < 0.001:
            return False
    return True


@_inner
def _keep(known, count, q):
    """Puts a solution behind those that are known, unless it is one of them; how many there are."""
    if not _is_new(known, count, q):
        return count
    _take(known[count], q)
    return count + 1


@_inner
def _leads(pose, T, q_free, seed, angle, row, exact, end):
    """Whether the row of a root that is moved leads to a solution, and to which."""
    q, kind = np.empty((8, 5)), np.empty(8, np.uint8)
    kind[:] = UNREACHABLE
    _solve(pose, q_free, seed, angle, q, kind)
    if kind[row] == UNREACHABLE or kind[row] > _CLOSE:  # lost
        return False
    _take(end, q[row])
    return _solves(T, 72, exact, end)


_BESIDE = (3.0517578125e-05, -3.0517578125e-05, 3.814697265625e-06, -3.814697265625e-06, 4.76837158203125e-07, -4.76837158203125e-07, 5.960464477539063e-08, -5.960464477539063e-08, 7.450580596923828e-09, -7.450580596923828e-09, 9.313225746154785e-10, -9.313225746154785e-10, 1.1641532182693481e-10, -1.1641532182693481e-10, 1.4551915228366852e-11, -1.4551915228366852e-11, 1.8189894035458565e-12, -1.8189894035458565e-12)


@_apart("void(UniTuple(float64, 12), float64[::1], float64[::1], float64[:, ::1], uint8[::1])")
def _beside(pose, q_free, seed, q, status):
    """Solutions for the rows that stand between two of them, which are known by no more than that.

    Steps from a row lead to one; the root of the other is as far from it on the other side. A row may
    have taken the seed's value for its root, which is one of the two and hides the middle: the roots'
    own rows have a seed that is turned away.
    """
    T, exact = _upper_rows(pose), _exactness(pose)
    known, count = np.empty((16, 5)), 0
    doubtful = np.zeros(8, np.bool_)
    own, kind = np.empty((8, 5)), np.empty(8, np.uint8)
    kind[:] = UNREACHABLE
    away = seed.copy()
    away[0] += 2.0
    _solve(pose, q_free, away, 0.0, own, kind)
    for row in range(8):
        if kind[row] == UNREACHABLE or kind[row] > _CLOSE:  # lost
            _take(own[row], q[row])
        if status[row] == _CLOSE:
            doubtful[row] = not _solves(T, 0, exact, own[row].copy())
            status[row] = OK
        if status[row] != UNREACHABLE and not doubtful[row]:
            _take(known[count], q[row])
            count += 1
    others, after = count, count
    other = np.empty(5)
    for row in range(8):
        if not doubtful[row]:
            continue
        end = q[row].copy()
        # long steps may lead to solutions of other roots, which are known
        found = _solves(T, 72, exact, end) and _is_new(known, others, end)
        for angle in _BESIDE:
            if found or not _leads(pose, T, q_free, away, angle, row, exact, end):
                continue
            found = _is_new(known, others, end)
        if not found:
            continue
        status[row] = UNREACHABLE
        count = _keep(known, count, end)
        off = 0.0
        off += end[0] - own[row, 0]
        off -= 6.283185307179586 * math.ceil(off / 6.283185307179586 - 0.5)
        for part in (0.0, -1.0, -2.0, -0.5, -4.0):  # of the way to the one that is known
            if not _leads(pose, T, q_free, away, part * off, row, exact, other):
                continue
            if _is_new(known, others, other) and _gap_between(end, other) >= 0.001:
                count = _keep(known, count, other)
                break
    for k in range(after, count):  # whichever roots rounding told apart: the row that was nearest
        place, least = -1, math.inf
        for row in range(8 - 1, -1, -1):
            gap = math.inf if math.isnan(q[row, 0]) else _gap_between(q[row], known[k])
            if status[row] == UNREACHABLE and gap <= least:
                place, least = row, gap
        if place >= 0:
            _take(q[place], known[k])
            status[place] = OK
    for row in range(8):
        if status[row] == UNREACHABLE:
            q[row, :] = math.nan


@_inner
def _both_sides(pose, q_free, seed, q, status):
    """Solutions for the rows of roots that nearly meet, which may stand between two."""
    close = False
    for row in range(8):
        close = close or status[row] == _CLOSE
    if not close:
        return
    rows, kinds = q.copy(), status.copy()
    _beside(pose, q_free.copy(), seed.copy(), rows, kinds)
    for row in range(8):
        status[row] = kinds[row]
        for i in range(5):
            q[row, i] = rows[row, i]


# Between which values starts lie.
_SPAN_LOW = np.array([
    -2.9670597283903604, -3.141592653589793, -3.141592653589793, -3.141592653589793,
    -3.141592653589793,
])
_SPAN_WIDTH = np.array([
    5.934119456780721, 6.283185307179586, 6.283185307179586, 6.283185307179586, 6.283185307179586,
])


@_inner
def _start_of(k, near, u):
    """Start number k; number 0 is the seed."""
    for j in range(5):
        u[j] = near[j] if k == 0 else _SPAN_LOW[j] + _SPAN_WIDTH[j] * ((0.5 + k * _STRIDE[j]) % 1.0)


@_apart("float64(float64[:, ::1], float64[::1], float64[::1])")
def _descend(T, q, u):
    """Takes u to where damped least squares lead; returns by how much that misses the pose.

    Near to it less damping than usual leads further, where joints hardly move the tool: there a step
    that is right may be long, and what it leaves, half of its square, far more than was missed.
    """
    e, A = np.empty(6), np.empty((6, 5))
    least, best, step, little = math.inf, u.copy(), np.empty(5), 1e-13
    last, left = math.inf, 0.0  # the miss before a step, and what its curvature leaves
    for _ in range(40 + 1):
        length = _look(T, q, u, e, A)
        slow = length >= max(0.5 * last, left)
        stalled = slow and least <= (1e-10 if little < 1e-13 else 1e-12)
        if slow and least <= 1e-06:
            little = 1e-26
        if length < least:
            least = length
            _take(best, u)
        if stalled:
            break
        _damped_step(A, e, length, little, step)
        _shorten(step)
        way = 0.0
        for j in range(5):
            u[j] += step[j]
            way += abs(step[j])
        last, left = length, 0.5 * way * way if little < 1e-13 else 0.0
    _take(u, best)
    return least


@_apart("int64(UniTuple(float64, 12), float64[::1], float64[::1], int64, float64[::1])")
def _sought(pose, q_free, seed, least, q):
    """Joint values that serve, into q, if there are some with less wrong than `least`; what is.

    Nothing is 0, 1 that they are beyond limits, 2 that they are not exact, 4 that there are none.

    Several joints may be free at once, and few of their values serve. Steps of damped least squares
    from the seed and from evenly spread starts lead to some that do, if the arm can take the pose.
    """
    T, exact = _upper_rows(pose), _exactness(pose)
    joints, near = seed.copy(), np.empty(5)
    for j in range(5):
        near[j] = seed[_SOLVED[j]] / _UNIT[j]
    u, end = np.empty(5), np.empty(5)
    for k in range(12):
        if least == 0:
            break
        _start_of(k, near, u)
        if _descend(T, joints, u) > 0.01:
            continue
        _take(end, joints)
        for j in range(5):
            end[_SOLVED[j]] = _UNIT[j] * u[j]
        miss = _escaped(T, exact, end)
        if miss > 10.0 * exact:
            continue
        if _beyond_limits(end) > 0.0:
            _settled(pose, math.nan, math.inf, end)
        fault = 2 * (miss > exact) + (_beyond_limits(end) > 0.0)
        if fault < least:
            least = fault
            _take(q, end)
    return least


@_inner
def _seek(pose, q_free, seed, begun, q, status):
    """The same into a row, if there is none, or none
    inside the limits."""
    before, chosen = 4, -1
    for row in range(8 - 1, -1, -1):
        fault, is_open = 0, status[row] == FREE_JOINT
        if status[row] == UNREACHABLE:
            continue
        fault += _beyond_limits(q[row]) > 0.0
        before = min(before, fault)
        chosen = row if is_open else chosen
    if before == 0 or (before < 4 and chosen < 0):
        return
    found = np.empty(5)
    least = _sought(pose, q_free.copy(), seed.copy(), before, found)
    if least == before:
        return
    if before < 4 and before // 2 == least // 2:  # other rows are no less exact
        for i in range(5):
            q[chosen, i] = found[i]
        return
    for row in range(8):
        status[row] = FREE_JOINT if row == begun else UNREACHABLE
        for i in range(5):
            q[row, i] = found[i] if row == begun else math.nan


@_apart(_arms.COMPLETES)
def _complete(pose, q_free, seed, begun, q, status):
    """Works on all rows where roots nearly meet or rows miss the pose, and looks for lost ones."""
    _both_sides(pose, q_free, seed, q, status)
    _tighten(pose, q, status)
    if begun >= 0:
        _seek(pose, q_free, seed, begun, q, status)


_CALLS = _functions.of_robot(
    globals(),
    _HOW,
    _functions.Solver(
        arm=_ARM,
        robot=_HOW.addresses("_solve", "fk", "jacobian", "_complete"),
        task="pointing",
        counted=(True, True, True),
        formulas=None,
        kinematics=(fk, jacobian),
        given=0,
        apart=(_circle.OWN.compile_apart,),
        words={
            "no_pose": "not finite, or its z axis not of length one to six digits",
            "no_row": "the pose is out of reach",
            "allocates": "at every pose",
        },
    ),
)
ik, ik_all, ik_batch = _CALLS["ik"], _CALLS["ik_all"], _CALLS["ik_batch"]
ik_into, warm_up = _CALLS["ik_into"], _CALLS["warm_up"]
