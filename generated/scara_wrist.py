# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: e8aefe29e53d431c
"""scara_wrist: SCARA arm with a spherical wrist.

Inverse kinematics, generated from robots/scara_wrist.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/scara_wrist.yaml. The formulas and where they come from:
scara_wrist.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Every entry of
a pose counts.
"""

import math
import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 6), _runtime("arrays").zeros

NAME = "scara_wrist"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRPRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = ("right-noflip", "right-flip", "left-noflip", "left-flip")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit = 9.999999999999999e-05.
d1 = 0.5  # joint offset 1 [m]
a1 = 0.4  # link length 1 [m]
a2 = 0.3  # link length 2 [m]
d6 = 0.1  # joint offset 6 [m]
longest2 = 0.48999999999999994  # square of the longest reach [m^2]
shortest2 = 0.010000000000000007  # square of the shortest reach [m^2]
longest2_reach = 0.49000000000018196  # the longest, with what rounding adds [m^2]
shortest2_reach = 0.009999999999974009  # the shortest, with what rounding adds [m^2]
longest2_apart = 0.48999999999998173  # the longest, where branches merge [m^2]
shortest2_apart = 0.010000000000002607  # the shortest, where branches merge [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.25  # a1^2 + a2^2 [m^2]
k2 = 4.166666666666667  # 1 / (2 * a2 * a1) [m^-2]
m1 = 8.7396756498489e-12  # 1000 * (longest2 - longest2_apart) * (longest2_apart - shortest2) [m^4]
m2 = 1.25  # a2 * k2 [m^-1]
m3 = 0.08750000000000001  # a1 - a2 * k1 * k2 [m]
m4 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="rotation",
    miss_weights=(0.7692, 0.7692, 0.7692, 1.0, 1.0, 1.0), size=1.3,
    slacks=(1e-09, 1e-09, 1.3e-09, 1e-09, 1e-09, 1e-09),
    weights=(1.0, 1.0, 0.5917159763313609, 1.0, 1.0, 1.0), paces=(1.0, 1.0, 1.3, 1.0, 1.0, 1.0),
    steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.5, 0.4, 0.0),
    (0.0, 0.0, 0.3, 0.0),
    (0.0, 0.0, 0.0, 3.141592653589793),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.1, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    v1 = x2_y * s4
    x4_x, v2 = x2_x * c4 + v1, x2_y * c4
    x4_y, y5_x, y5_y = v2 + -x2_x * s4, v2 - x2_x * s4, -x2_x * c4 - v1
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, v3 = x4_x * c5, x4_y * c5, x4_x * s5
    v4 = x4_y * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + y5_x * s6, y5_x * c6 - x5_x * s6, -v3
    T[0, 3] = c1 * a1 + x2_x * a2 - v3 * d6
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + y5_y * s6, y5_y * c6 - x5_y * s6, -v4
    T[1, 3] = s1 * a1 + x2_y * a2 - v4 * d6
    T[2, 0], T[2, 1], T[2, 2] = -(s5 * c6), s5 * s6, -c5
    T[2, 3] = d1 + q[2] - c5 * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * a1, s1 * a1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    p2_x, p2_y, p3_z = p1_x + x2_x * a2, p1_y + x2_y * a2, d1 + q[2]
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    v1, v2 = x2_y * s4, x2_y * c4
    z4_x, z4_y = x2_x * s4 - v2, v1 - -x2_x * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    v3, v4 = (x2_x * c4 + v1) * s5, (v2 + -x2_x * s4) * s5
    p6_x, p6_y = p2_x - v3 * d6, p2_y - v4 * d6
    v5, J14, v6 = p6_x - p2_x, p6_y - p2_y, p3_z - c5 * d6 - p3_z
    J[0, 0], J[0, 1], J[0, 3] = -p6_y, p1_y - p6_y, J14
    J[0, 4], J[0, 5] = z4_y * v6, c5 * J14 - v4 * v6
    J[1, 0], J[1, 1], J[1, 3] = p6_x, p6_x - p1_x, -v5
    J[1, 4], J[1, 5] = -(z4_x * v6), v3 * v6 - c5 * v5
    J[2, 2], J[2, 4], J[2, 5] = 1.0, z4_x * J14 - z4_y * v5, v4 * v5 - v3 * J14
    J[3, 4], J[3, 5] = z4_x, -v3
    J[4, 4], J[4, 5] = z4_y, -v4
    J[5, 0], J[5, 1], J[5, 3] = 1.0, 1.0, -1.0
    J[5, 5] = -c5
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, _, _, T33, T34 = pose

    # r3, type 1: U0 A6^-1 [3, 4]
    wz = T34 - T33 * d6
    r3 = wz - d1

    # theta2, type 8: U0 A6^-1 [1, 4] and U0 A6^-1 [2, 4]
    wx = T14 - d6 * T13
    wy = T24 - d6 * T23
    N2 = wx * wx + wy * wy
    K2 = N2 - k1
    D2_squared = (longest2 - N2) * (N2 - shortest2)
    apart2 = shortest2_apart < N2 and N2 < longest2_apart
    if not (shortest2_reach <= N2 and N2 <= longest2_reach):
        return  # out of reach
    w2 = math.sqrt(D2_squared if apart2 else 0.0)
    c2 = K2 * k2

    # theta1, type 3: U0 A6^-1 [2, 4] and U0 A6^-1 [1, 4]
    X1_1 = a1 + a2 * c2
    v1, v2 = wy * X1_1, wx * X1_1

    # theta12m4, type 2: U4[3, 3]
    w12m4 = math.sqrt(T13 * T13 + T23 * T23)
    free12m4 = w12m4 <= free_limit
    divisor12m4 = 1.0 if free12m4 else w12m4

    for i1 in range(2):  # right, left
        e2 = 1.0 - 2.0 * i1
        # theta2
        if e2 < 0.0 and not apart2:
            continue  # both signs give the same
        s2 = w2 * e2 * k2
        q2 = _atan2(s2, c2)

        # theta1
        Y1_1 = a2 * s2
        S1 = v1 - wx * Y1_1
        C1 = v2 + wy * Y1_1
        w1 = math.sqrt(S1 * S1 + C1 * C1)
        factor1 = 1.0 / w1
        c1, s1 = C1 * factor1, S1 * factor1
        q1 = _atan2(s1, c1)

        # theta12m4
        v3 = q2 + q1
        v4 = v3 - seed[3]

        for i2 in range(2):  # noflip, flip
            e12m4 = 1.0 - 2.0 * i2
            # theta12m4
            if e12m4 < 0.0 and free12m4:
                continue  # both signs give the same
            factor12m4 = e12m4 / divisor12m4
            c12m4 = math.cos(v4) if free12m4 else -(T13 * factor12m4)
            s12m4 = math.sin(v4) if free12m4 else -(T23 * factor12m4)
            s5 = w12m4 * e12m4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            q5 = _atan2(s5, -T33)

            # theta6, type 3: U4[3, 2] and U4[3, 1]
            c6, s6 = T12 * s12m4 - T22 * c12m4, T11 * s12m4 - T21 * c12m4
            q6 = _atan2(s6, c6)

            # joint values
            q4 = _wrap(v3 - _atan2(s12m4, c12m4))
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, q2, r3
            q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
            status[row] = FREE_JOINT if free12m4 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T11, T12, T13 = kept[0 * w + k], kept[1 * w + k], kept[2 * w + k]
        T14, T21, T22 = kept[3 * w + k], kept[4 * w + k], kept[5 * w + k]
        T23, T24, T33 = kept[6 * w + k], kept[7 * w + k], kept[10 * w + k]
        T34 = kept[11 * w + k]

        # theta2, type 8: U0 A6^-1 [1, 4] and U0 A6^-1 [2, 4]
        wx, wy = T14 - d6 * T13, T24 - d6 * T23
        N2 = wx * wx + wy * wy
        D2_squared = (longest2 - N2) * (N2 - shortest2)
        w2 = math.sqrt(D2_squared)
        v1 = w2 - w2

        # theta1, type 3: U0 A6^-1 [2, 4] and U0 A6^-1 [1, 4]
        v2 = m3 + m2 * N2
        v3, v4 = wy * v2, wx * v2

        # theta12m4, type 2: U4[3, 3]
        v5 = T13 * T13 + T23 * T23

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        s6 = T13 * T21 - T23 * T11

        # joint values
        q3_pp = v1 + (T34 - d6 * T33 - d1)

        # a joint is free, or branches meet
        kept[16 * w + k] = 1.0 if abs(D2_squared) <= m1 or v5 <= m4 else kept[16 * w + k]
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = v1, s6, q3_pp
        turns[0 * w + k], turns[1 * w + k] = w2, v3 - w2 * (m2 * wx)
        turns[2 * w + k], turns[3 * w + k] = v3 - w2 * (m2 * -wx), math.sqrt(v5)
        turns[4 * w + k], turns[5 * w + k], turns[8 * w + k] = s6, -T23, N2 - k1
        turns[9 * w + k], turns[10 * w + k] = v4 + w2 * (m2 * wy), v4 + w2 * (m2 * -wy)
        turns[11 * w + k], turns[12 * w + k], turns[13 * w + k] = -T33, T13 * T22 - T23 * T12, -T13
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 6 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(6 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        T23, v1, s6 = kept[6 * w + k], kept[17 * w + k], kept[18 * w + k]
        q3_pp, angle1, angle2 = kept[19 * w + k], turns[0 * w + k], turns[1 * w + k]
        angle3, angle4, angle5 = turns[2 * w + k], turns[3 * w + k], turns[4 * w + k]
        angle6 = turns[5 * w + k]

        # theta12m4, type 2: U4[3, 3]
        v6, v7 = angle1 + angle2, angle3 - angle1

        # joint values
        v8, v9 = angle6 - math.copysign(half_turn, -T23), v6 - angle6
        v10, v11, v12 = v6 - v8, v7 - angle6, v7 - v8
        q4_pp = v9 + (turn if v9 <= -half_turn else (-turn if half_turn < v9 else 0.0))
        q4_pm = v10 + (turn if v10 <= -half_turn else (-turn if half_turn < v10 else 0.0))
        q4_mp = v11 + (turn if v11 <= -half_turn else (-turn if half_turn < v11 else 0.0))
        q4_mm = v12 + (turn if v12 <= -half_turn else (-turn if half_turn < v12 else 0.0))
        q5_pp, q5_pm, q6_pp = v1 + angle4, v1 - angle4, v1 + angle5
        q6_pm = v1 + (angle5 - math.copysign(half_turn, s6))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle2, angle1, q3_pp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_pp, q5_pp, q6_pp
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_pm, q5_pm, q6_pm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = angle3, -angle1, q4_mp
        rows[12 * w + k] = q4_mm
        rows[13 * w + k] = rows[14 * w + k] = UNREACHABLE if angle2 != angle2 else OK
        rows[15 * w + k] = rows[16 * w + k] = UNREACHABLE if angle3 != angle3 else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 20, 16, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [9, 10, 2, 11, 4, 5], [9, 10, 2, 12, 7, 8],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
