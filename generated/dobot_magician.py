# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 45a194be1a673098
"""dobot_magician: Dobot Magician, its hand's joint.

Inverse kinematics, generated from robots/dobot_magician.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/dobot_magician.yaml. The formulas and where they come from:
dobot_magician.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
position T[0:3, 3] counts; other entries are ignored.
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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 3), _runtime("arrays").zeros

NAME = "dobot_magician"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRR"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = (
    (-1.5707963267948966, 1.5707963267948966), (0.0, 1.4835298641951802),
    (-0.17453292519943295, 1.6580627893946132),
)
BRANCHES = ("back-down", "back-up", "front-up", "front-down")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 4.21e-05 [m].
d1 = 0.139  # joint offset 1 [m]
a2 = 0.135  # link length 2 [m]
a3 = 0.147  # link length 3 [m]
free_limit1 = 4.21e-13  # a length that fixes no angle [m]
longest3 = 0.07952400000000001  # square of the longest reach [m^2]
shortest3 = 0.0001439999999999996  # square of the shortest reach [m^2]
longest3_reach = 0.07952400000002374  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0001439999999989892  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.07952399999999764  # the longest, where branches merge [m^2]
shortest3_apart = 0.00014400000000010064  # the shortest, where branches merge [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
offset3 = 1.5707963267948966  # offset of joint 3 [rad]
k1 = 0.039834  # a2^2 + a3^2 [m^2]
k2 = 25.195263290501387  # 1 / (2 * a3 * a2) [m^-2]
high1 = 1.5707963277948966  # highest value of joint 1, with what rounding adds [rad]
low2 = -1e-09  # lowest value of joint 2, with what rounding adds [rad]
high2 = 1.4835298651951803  # highest value of joint 2, with what rounding adds [rad]
low3 = -0.17453292619943295  # lowest value of joint 3, with what rounding adds [rad]
high3 = 1.6580627903946132  # highest value of joint 3, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 1.77241e-09  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 1.8837681414751167e-13
m4 = 3.7037037037037037  # a3 * k2 [m^-1]
m5 = 0.012533333333333329  # a3 * k1 * k2 - a2 [m]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="none",
    miss_weights=(2.375, 2.375, 2.375, 0.0, 0.0, 0.0), size=0.42100000000000004,
    steps=("keeps limits", "clamps", "clamps far", "follows seed"), choosable=(0,),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.139, 0.0, -1.5707963267948966),
    (-1.5707963267948966, 0.0, 0.135, 0.0),
    (1.5707963267948966, 0.0, 0.147, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    drives=((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, -1.0, 1.0)),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = _zeros(4, 4)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, v2 = c1 * c2, s1 * c2, c1 * s2
    v3, v4 = s1 * s2, q[2] - q[1] + offset3
    c3, s3 = math.cos(v4), math.sin(v4)
    x3_x, x3_y, v5 = x2_x * c3 - v2 * s3, x2_y * c3 - v3 * s3, s2 * c3 + c2 * s3
    T[0, 0], T[0, 1], T[0, 2] = x3_x, -(v2 * c3 + x2_x * s3), -s1
    T[0, 3] = x2_x * a2 + x3_x * a3
    T[1, 0], T[1, 1], T[1, 2] = x3_y, -(v3 * c3 + x2_y * s3), c1
    T[1, 3] = x2_y * a2 + x3_y * a3
    T[2, 0], T[2, 1], T[2, 3] = -v5, s2 * s3 - c2 * c3, d1 - s2 * a2 - v5 * a3
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y = c1 * c2, s1 * c2
    p2_x, p2_y, p2_z = x2_x * a2, x2_y * a2, d1 - s2 * a2
    v2 = q[2] - q[1] + offset3
    c3, s3 = math.cos(v2), math.sin(v2)
    p3_x, p3_y = p2_x + (x2_x * c3 - c1 * s2 * s3) * a3, p2_y + (x2_y * c3 - s1 * s2 * s3) * a3
    p3_z = p2_z - (s2 * c3 + c2 * s3) * a3
    v3, v4 = p3_z - d1, p3_z - p2_z
    J13, J23, v5 = c1 * v4, s1 * v4, s1 * (p3_y - p2_y) + c1 * (p3_x - p2_x)
    J[0, 0], J[0, 1], J[0, 2] = -p3_y, c1 * v3 - J13, J13
    J[1, 0], J[1, 1], J[1, 2] = p3_x, s1 * v3 - J23, J23
    J[2, 1], J[2, 2] = v5 - (s1 * p3_y + c1 * p3_x), -v5
    J[3, 2] = -s1
    J[4, 2] = c1
    J[5, 0] = 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    # theta1, type 2: U1[3, 4]
    w1 = math.sqrt(T14 * T14 + T24 * T24)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    Z1_3 = T34 - d1
    v1 = Z1_3 * Z1_3

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(T14 * factor1)
        s1 = math.sin(seed[0]) if free1 else -(T24 * factor1)
        q1 = _atan2(s1, c1)
        D1 = w1 * e1

        # theta3
        N3 = v1 + D1 * D1
        K3 = N3 - k1
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        c3 = K3 * k2

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        Y1_2 = a2 + a3 * c3
        v3, v4 = Z1_3 * Y1_2, D1 * Y1_2

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            s3 = w3 * e3 * k2

            # theta2
            v2 = a3 * s3
            S2 = D1 * v2 - v3
            v5 = Z1_3 * v2 + v4
            w2 = math.sqrt(S2 * S2 + v5 * v5)
            factor2 = 1.0 / w2
            c2, s2 = -(v5 * factor2), S2 * factor2

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(q2 + (_atan2(s3, c3) - offset3))
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
            status[row] = FREE_JOINT if free1 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T14, T24, T34 = kept[3 * w + k], kept[7 * w + k], kept[11 * w + k]

        # theta1, type 2: U1[3, 4]
        v1 = T14 * T14 + T24 * T24
        w1 = math.sqrt(v1)

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        Z1_3 = T34 - d1
        N3 = v1 + Z1_3 * Z1_3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)
        v2 = w3 - w3

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        v3 = m5 - m4 * N3
        v4, v5, v6 = Z1_3 * v3, w3 * (m4 * Z1_3), w3 * (m4 * -Z1_3)
        v7, v8 = w1 * -v3, w1 * v3

        # joint values
        v9 = w3 * (m4 * w1)
        v10, v12 = v4 + v9, v4 - v9

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = 1.0 if v1 <= m1 or abs(D3_squared) <= m3 else kept[16 * w + k]
        kept[17 * w + k], turns[0 * w + k], turns[1 * w + k] = v2, -T24, v10
        turns[2 * w + k], turns[3 * w + k], turns[4 * w + k] = v12, v12, v10
        turns[5 * w + k], turns[8 * w + k], turns[9 * w + k] = w3, -T14, -(v5 + v7)
        turns[10 * w + k], turns[11 * w + k], turns[12 * w + k] = -(v6 + v7), -(v5 + v8), -(v6 + v8)
        turns[13 * w + k] = N3 - k1
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 6 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(6 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        T24, v2, angle1 = kept[7 * w + k], kept[17 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6 = turns[4 * w + k], turns[5 * w + k]

        # theta1, type 2: U1[3, 4]
        q1__m = angle1 - math.copysign(half_turn, -T24)

        # joint values
        v11, v13, v14 = angle2 - offset2, angle3 - offset2, angle4 - offset2
        v15 = angle5 - offset2
        q2_pp = v11 + (-turn if half_turn < v11 else 0.0)
        q2_pm = v13 + (-turn if half_turn < v13 else 0.0)
        q2_mp = v14 + (-turn if half_turn < v14 else 0.0)
        q2_mm = v15 + (-turn if half_turn < v15 else 0.0)
        v16, v17 = angle6 - offset3, offset3 + angle6
        q3_pp, q3_pm, q3_mp = _wrap(q2_pp + v16), _wrap(q2_pm - v17), _wrap(q2_mp + v16)
        q3_mm, v18, v19 = _wrap(q2_mm - v17), abs(angle1) - high1, abs(q1__m) - high1
        q1_pp, q1_mp = angle1 + v2, q1__m + v2
        excess_pp = (
            max(max(low3 - q3_pp, q3_pp - high3), max(v18, max(low2 - q2_pp, q2_pp - high2)))
        )
        excess_pm = (
            max(max(low3 - q3_pm, q3_pm - high3), max(v18, max(low2 - q2_pm, q2_pm - high2)))
        )
        excess_mp = (
            max(max(low3 - q3_mp, q3_mp - high3), max(v19, max(low2 - q2_mp, q2_mp - high2)))
        )
        excess_mm = (
            max(max(low3 - q3_mm, q3_mm - high3), max(v19, max(low2 - q2_mm, q2_mm - high2)))
        )
        outside_pp, outside_pm, outside_mp = 0.0 < excess_pp, 0.0 < excess_pm, 0.0 < excess_mp
        outside_mm = 0.0 < excess_mm

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(excess_mm - limit_slack) <= limit_slack or abs(excess_mp - limit_slack) <=
            limit_slack or abs(excess_pp - limit_slack) <= limit_slack or abs(excess_pm -
            limit_slack) <= limit_slack else kept[16 * w + k]
        )

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_pp, q2_pp, q3_pp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q2_pm, q3_pm, q1_mp
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q2_mp, q3_mp, q2_mm
        rows[9 * w + k] = q3_mm
        rows[10 * w + k] = UNREACHABLE if q1_pp != q1_pp else (OUT_OF_LIMITS if outside_pp else OK)
        rows[11 * w + k] = UNREACHABLE if q1_pp != q1_pp else (OUT_OF_LIMITS if outside_pm else OK)
        rows[12 * w + k] = UNREACHABLE if q1_mp != q1_mp else (OUT_OF_LIMITS if outside_mp else OK)
        rows[13 * w + k] = UNREACHABLE if q1_mp != q1_mp else (OUT_OF_LIMITS if outside_mm else OK)


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 18, 16, [
    [0, 1, 2], [0, 3, 4], [5, 6, 7], [5, 8, 9],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "position", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
