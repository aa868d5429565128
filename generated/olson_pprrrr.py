# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: db2ececc07f31b80
"""olson_pprrrr: Olson PPRRRR arm.

Inverse kinematics, generated from robots/olson_pprrrr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/olson_pprrrr.yaml. The formulas and where they come from:
olson_pprrrr.md.

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

NAME = "olson_pprrrr"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "PPRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = ("elbow3+-elbow4+", "elbow3+-elbow4-", "elbow3--elbow4+", "elbow3--elbow4-")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit = 9.999999999999999e-05.
d3 = 1.0  # joint offset 3 [m]
a4 = 4.0  # link length 5 [m]
d6 = 2.0  # joint offset 6 [m]
free_limit = 1e-12  # a length that fixes no angle
near_limit = 0.001  # a length whose direction is good to few digits
reach_slack1 = 7e-13  # rounding at the boundary of the workspace [m]
merge_slack1 = 7e-14  # nearer to that boundary two branches are one [m]
# the same where they follow an angle that is good to few digits [m]
blur_slack1 = 6.999999999999999e-11
k1 = 16.0  # a4^2 [m^2]
k2 = 0.0625  # 1 / k1 [m^-2]
m1 = 9.999999999999999e-09  # doubt_limit^2
m3 = 6.999999999999999e-10  # 10 * blur_slack1 [m]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="rotation",
    miss_weights=(0.1429, 0.1429, 0.1429, 1.0, 1.0, 1.0), size=7.0,
    slacks=(7e-09, 7e-09, 1e-09, 1e-09, 1e-09, 1e-09),
    weights=(0.02040816326530612, 0.02040816326530612, 1.0, 1.0, 1.0, 1.0),
    paces=(7.0, 7.0, 1.0, 1.0, 1.0, 1.0), steps=("follows seed",),
))

# The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (1.5707963267948966, 0.0, 0.0, -1.5707963267948966),
    (-1.5707963267948966, 0.0, 0.0, 1.5707963267948966),
    (0.0, 1.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 4.0, 0.0),
    (0.0, 2.0, 0.0, 1.5707963267948966),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="modified",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, v1, v2 = s3 * c4, c3 * c4, s3 * s4
    y4_y = c3 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 - v2 * s5, y4_y * s5 - v1 * c5, s4 * c5 + c4 * s5
    z6_x, y5_y, y5_z = v2 * c5 + x4_x * s5, y4_y * c5 + v1 * s5, c4 * c5 - s4 * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 - c3 * s6, -(c3 * c6 + x5_x * s6), z6_x
    T[0, 3] = q[1] + x4_x * a4 + z6_x * d6
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 - s3 * s6, -(s3 * c6 + x5_y * s6), -y5_y
    T[1, 3] = q[0] - v1 * a4 - y5_y * d6
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6, -(x5_z * s6), -y5_z
    T[2, 3] = d3 + s4 * a4 - y5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, v1 = s3 * c4, c3 * c4
    p5_x, p5_y, p5_z = q[1] + x4_x * a4, q[0] - v1 * a4, d3 + s4 * a4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    z6_x, y5_y, y5_z = s3 * s4 * c5 + x4_x * s5, c3 * s4 * c5 + v1 * s5, c4 * c5 - s4 * s5
    p6_x, p6_y, p6_z = p5_x + z6_x * d6, p5_y - y5_y * d6, p5_z - y5_z * d6
    J23, v2, v3 = p6_x - q[1], p6_y - q[0], p6_z - d3
    v4 = p6_z - p5_z
    J[0, 1], J[0, 2], J[0, 3] = 1.0, -v2, -(s3 * v3)
    J[0, 4] = -(s3 * v4)
    J[1, 0], J[1, 2], J[1, 3] = 1.0, J23, c3 * v3
    J[1, 4] = c3 * v4
    J[2, 3], J[2, 4] = s3 * J23 - c3 * v2, s3 * (p6_x - p5_x) - c3 * (p6_y - p5_y)
    J[3, 3], J[3, 4], J[3, 5] = -c3, -c3, z6_x
    J[4, 3], J[4, 4], J[4, 5] = -s3, -s3, -y5_y
    J[5, 2], J[5, 5] = 1.0, -y5_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, _, _, T33, T34 = pose

    # theta3, type 2: U3[2, 3]
    w3 = math.sqrt(T23 * T23 + T13 * T13)
    free3 = w3 <= free_limit
    divisor3 = 1.0 if free3 else w3
    near3 = w3 <= near_limit

    # theta4, type 2: U0 A6^-1 [3, 4]
    wz = T34 - T33 * d6
    Z4 = wz - d3
    D4_squared = k1 - Z4 * Z4
    v3 = 2.0 * abs(Z4)
    apart4 = merge_slack1 * (v3 + merge_slack1) < D4_squared
    if not (-(reach_slack1 * (v3 + reach_slack1)) < D4_squared):
        return  # out of reach
    w4 = math.sqrt(D4_squared if apart4 else 0.0)
    s4 = k2 * (a4 * Z4)

    # r2, type 1: U0 A6^-1 [1, 4]
    wx = T14 - T13 * d6

    # r1, type 1: U0 A6^-1 [2, 4]
    wy = T24 - T23 * d6

    for i1 in range(2):  # elbow3+, elbow3-
        e3 = 1.0 - 2.0 * i1
        # theta3
        if e3 < 0.0 and free3:
            continue  # both signs give the same
        factor3 = e3 / divisor3
        v1, v2 = T23 * factor3, T13 * factor3
        off3 = w3 * abs(v1 * math.sin(seed[2]) + v2 * math.cos(seed[2])) if near3 else 1.0
        ahead3 = v1 * math.cos(seed[2]) - v2 * math.sin(seed[2]) if near3 else -1.0
        same3 = near3 and 0.0 < ahead3 and off3 <= free_limit
        held3 = free3 or same3
        c3 = math.cos(seed[2]) if held3 else v1
        s3 = math.sin(seed[2]) if held3 else -v2
        q3 = _atan2(s3, c3)

        # r2
        v5 = s3 * a4

        # r1
        v6 = c3 * a4

        # theta45, type 3: U3[3, 3] and U3[1, 3]
        theta45 = _atan2(-(w3 * e3), -T33)

        # theta6, type 3: U3[2, 2] and U3[2, 1]
        q6 = _atan2(-(T11 * c3 + T21 * s3), -(T12 * c3 + T22 * s3))

        for i2 in range(2):  # elbow4+, elbow4-
            e4 = 1.0 - 2.0 * i2
            # theta4
            if (
                e4 < 0.0 and (not apart4 or (near3 and not (blur_slack1 * (v3 + blur_slack1) <
                D4_squared)))
            ):
                continue  # both signs give the same
            v4 = k2 * (a4 * (w4 * e4))
            q4 = _atan2(s4, -v4)

            # r2
            r2 = wx + v4 * v5

            # r1
            r1 = wy - v4 * v6

            # joint values
            q5 = _wrap(theta45 - q4)
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = r1, r2, q3
            q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
            status[row] = FREE_JOINT if free3 else OK


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

        # theta3, type 2: U3[2, 3]
        v1 = T23 * T23 + T13 * T13
        w3 = math.sqrt(v1)
        factor3 = w3 * (1.0 / v1)
        c3, v2 = T23 * factor3, T13 * factor3

        # theta4, type 2: U0 A6^-1 [3, 4]
        Z4 = T34 - d6 * T33 - d3
        D4_squared = k1 - Z4 * Z4
        w4 = math.sqrt(D4_squared)
        v3, v4 = w4 - w4, a4 * w4
        v5, v6 = k2 * v4, a4 * Z4

        # r2, type 1: U0 A6^-1 [1, 4]
        wx, v7 = T14 - d6 * T13, v5 * (a4 * v2)
        q2_pp, q2_pm = wx - v7, wx + v7

        # r1, type 1: U0 A6^-1 [2, 4]
        wy, v8 = T24 - d6 * T23, v5 * (a4 * c3)
        q1_pp, q1_pm = wy - v8, wy + v8

        # theta6, type 3: U3[2, 2] and U3[2, 1]
        v9 = v2 * T21 - c3 * T11

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v1 <= m1 or abs(D4_squared) <= m3 * (blur_slack1 + 2.0 * abs(Z4)) else kept[16 *
            w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = v3, v6, q2_pp
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = q2_pm, q1_pp, q1_pm
        kept[23 * w + k], turns[0 * w + k], turns[1 * w + k] = v9, -T13, v6
        turns[2 * w + k], turns[3 * w + k], turns[8 * w + k] = -w3, v9, T23
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = -v4, -T33, v2 * T22 - c3 * T12
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 4 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(4 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        T13, v3, v6 = kept[2 * w + k], kept[17 * w + k], kept[18 * w + k]
        q2_pp, q2_pm, q1_pp = kept[19 * w + k], kept[20 * w + k], kept[21 * w + k]
        q1_pm, v9, angle1 = kept[22 * w + k], kept[23 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]

        # theta4, type 2: U0 A6^-1 [3, 4]
        q4_pm = math.copysign(half_turn, v6) - angle2

        # joint values
        v10, v11, v12 = angle3 - angle2, angle3 - q4_pm, angle2 + angle3
        v13 = q4_pm + angle3
        q5_pp = v10 + (turn if v10 <= -half_turn else (-turn if half_turn < v10 else 0.0))
        q5_pm = v11 + (turn if v11 <= -half_turn else (-turn if half_turn < v11 else 0.0))
        q5_mp = (turn if -v12 <= -half_turn else (-turn if half_turn < -v12 else 0.0)) - v12
        q5_mm = (turn if -v13 <= -half_turn else (-turn if half_turn < -v13 else 0.0)) - v13
        q3_pp, q3_mp = angle1 + v3, v3 + (angle1 - math.copysign(half_turn, -T13))
        q6_pp, q6_mp = v3 + angle4, v3 + (angle4 - math.copysign(half_turn, v9))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_pp, q2_pp, q3_pp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle2, q5_pp, q6_pp
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q1_pm, q2_pm, q4_pm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q5_pm, q3_mp, q5_mp
        rows[12 * w + k], rows[13 * w + k] = q6_mp, q5_mm
        rows[14 * w + k] = UNREACHABLE if q1_pp != q1_pp else OK
        rows[15 * w + k] = rows[16 * w + k] = UNREACHABLE if q1_pm != q1_pm else OK
        rows[17 * w + k] = UNREACHABLE if q1_pp != q1_pp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 24, 16, [
    [0, 1, 2, 3, 4, 5], [6, 7, 2, 8, 9, 5], [6, 7, 10, 3, 11, 12], [0, 1, 10, 8, 13, 12],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
