# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 952c9a85242bdf5e
"""kuka_kr40pa_level: KUKA KR 40 PA palletizer, whose rods keep the tool level.

Inverse kinematics, generated from robots/kuka_kr40pa_level.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kuka_kr40pa_level.yaml. The formulas and where they come from:
kuka_kr40pa_level.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, x =
T[0, 3] and y = T[1, 3] and z = T[2, 3] and the yaw atan2(T[1, 0], T[0, 0]) counts; other entries
are ignored.
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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 4), _runtime("arrays").zeros

NAME = "kuka_kr40pa_level"
METHOD = "closed form"
DOF = 4
JOINT_TYPES = "RRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4")
JOINT_LIMITS = (
    (-2.705260340591211, 2.705260340591211), (-2.0943951023931953, -0.2617993877991494),
    (0.2617993877991494, 2.530727415391778), (-6.1086523819801535, 6.1086523819801535),
)
BRANCHES = ("back-down", "back-up", "front-up", "front-down")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 0.000293 [m].
d1 = 0.62  # joint offset 1 [m]
a1 = 0.22  # link length 1 [m]
a2 = 0.85  # link length 2 [m]
a3 = 0.85  # link length 3 [m]
a4 = 0.2  # link length 3p [m]
d5 = 0.19  # joint offset 4 [m]
steep_limit = 1e-06  # a vertical axis, which has no yaw, is no longer seen from above
free_limit1 = 2.9300000000000002e-12  # a length that fixes no angle [m]
offset4 = 3.141592653589793  # offset of joint 4 [rad]
longest3 = 2.8899999999999997  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
longest3_reach = 2.890000000000996  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0  # the shortest, with what rounding adds [m^2]
longest3_apart = 2.8899999999999  # the longest, where branches merge [m^2]
shortest3_apart = 8.584899999999999e-28  # the shortest, where branches merge [m^2]
free_limit_squared2 = 8.584900000000001e-24  # square of a length that fixes no angle [m^2]
k1 = 0.43  # d1 - d5 [m]
k2 = 0.42000000000000004  # a1 + a4 [m]
k3 = 1.4449999999999998  # 2 * a3 * a2 [m^2]
k4 = 0.6920415224913495  # 1 / k3 [m^-2]
doubt_limit_squared2 = 8.584900000000002e-08  # square of a length that fixes no angle [m^2]
high1 = 2.705260341591211  # highest value of joint 1, with what rounding adds [rad]
low2 = -2.0943951033931953  # lowest value of joint 2, with what rounding adds [rad]
high2 = -0.2617993867991494  # highest value of joint 2, with what rounding adds [rad]
low3 = 0.2617993867991494  # lowest value of joint 3, with what rounding adds [rad]
high3 = 2.530727416391778  # highest value of joint 3, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 1e-12  # steep_limit^2
m2 = 8.584900000000002e-08  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 2.874855908885266e-10
m4 = 0.5882352941176471  # a3 * k4 [m^-1]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="yaw",
    miss_weights=(0.3413, 0.3413, 0.3413, 0.0, 0.0, 1.0), size=2.93,
    steps=("keeps limits", "clamps", "clamps far", "range exceeds a turn", "follows seed"),
    choosable=(3, 1, 0),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.62, 0.22, -1.5707963267948966),
    (0.0, 0.0, 0.85, 0.0),
    (0.0, 0.0, 0.85, 0.0),
    (0.0, 0.0, 0.2, -1.5707963267948966),
    (3.141592653589793, 0.19, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types="RRRRR", table=TABLE, convention="standard",
    drives=(
        (-1.0, 0.0, 0.0, 0.0),
        (0.0, 1.0, 0.0, 0.0),
        (0.0, 0.0, 1.0, 0.0),
        (0.0, -1.0, -1.0, 0.0),
        (0.0, 0.0, 0.0, -1.0),
    ),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (4,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(-q[0]), math.sin(-q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    v3, v4, v5 = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v6, v7, v8 = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    c3p = math.cos(-(q[1] + q[2]))
    s3p = math.sin(-(q[1] + q[2]))
    x3_x, x3_y, x3_z = v3 * c3p - v6 * s3p, v4 * c3p - v7 * s3p, v8 * s3p - v5 * c3p
    v9, v10, z3_z = v6 * c3p + v3 * s3p, v7 * c3p + v4 * s3p, v8 * c3p + v5 * s3p
    v11 = offset4 - q[3]
    c4, s4 = math.cos(v11), math.sin(v11)
    T[0, 0], T[0, 1], T[0, 2] = x3_x * c4 + s1 * s4, s1 * c4 - x3_x * s4, -v9
    T[0, 3] = c1 * a1 + x2_x * a2 + v3 * a3 + x3_x * a4 - v9 * d5
    T[1, 0], T[1, 1], T[1, 2] = x3_y * c4 - c1 * s4, -(c1 * c4 + x3_y * s4), -v10
    T[1, 3] = s1 * a1 + x2_y * a2 + v4 * a3 + x3_y * a4 - v10 * d5
    T[2, 0], T[2, 1], T[2, 2] = x3_z * c4, -(x3_z * s4), z3_z
    T[2, 3] = d1 - s2 * a2 - v5 * a3 + x3_z * a4 + z3_z * d5
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 4): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 4)
    c1, s1 = math.cos(-q[0]), math.sin(-q[0])
    p1_x, p1_y = c1 * a1, s1 * a1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2, p2_x, p2_y = s1 * s2, p1_x + x2_x * a2, p1_y + x2_y * a2
    p2_z = d1 - s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    v3, v4, v5 = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v6, v7, v8 = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    v9, v10, v11 = p2_x + v3 * a3, p2_y + v4 * a3, p2_z - v5 * a3
    c3p = math.cos(-(q[1] + q[2]))
    s3p = math.sin(-(q[1] + q[2]))
    J44, J54, z3_z = v6 * c3p + v3 * s3p, v7 * c3p + v4 * s3p, v8 * c3p + v5 * s3p
    p3_x, p3_y = v9 + (v3 * c3p - v6 * s3p) * a4, v10 + (v4 * c3p - v7 * s3p) * a4
    p3_z, p4_x, p4_y = v11 + (v8 * s3p - v5 * c3p) * a4, p3_x - J44 * d5, p3_y - J54 * d5
    p4_z = p3_z + z3_z * d5
    v12, v13, v14 = p4_z - d1, p4_z - p2_z, p4_x - p3_x
    v15, v16, v17 = p4_y - p3_y, p4_z - p3_z, p4_z - v11
    v18, v19, v20 = c1 * v17, s1 * v17, s1 * (p4_y - v10) + c1 * (p4_x - v9)
    J[0, 0], J[0, 1], J[0, 2] = p4_y, c1 * v12 - v18, c1 * v13 - v18
    J[0, 3] = J54 * v16 + z3_z * v15
    J[1, 0], J[1, 1], J[1, 2] = -p4_x, s1 * v12 - v19, s1 * v13 - v19
    J[1, 3] = -(z3_z * v14 + J44 * v16)
    J[2, 1] = v20 - (s1 * (p4_y - p1_y) + c1 * (p4_x - p1_x))
    J[2, 2], J[2, 3] = v20 - (s1 * (p4_y - p2_y) + c1 * (p4_x - p2_x)), J44 * v15 - J54 * v14
    J[3, 3] = J44
    J[4, 3] = J54
    J[5, 0], J[5, 3] = -1.0, -z3_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, _, _, T14, T21, _, _, T24, _, _, _, T34 = pose

    # the yaw's cosine and sine
    level = math.sqrt(T11 * T11 + T21 * T21)
    steep = level <= steep_limit
    factor_yaw = 1.0 / (1.0 if steep else level)
    t11 = T11 * factor_yaw
    t21 = T21 * factor_yaw

    # theta1, type 2: U1[3, 4]
    w1 = math.sqrt(T14 * T14 + T24 * T24)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta4, type 3: U1[1, 1] and U1[3, 1]
    v1 = offset4 - seed[3]

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    Z1_3 = T34 - k1
    v3 = Z1_3 * Z1_3

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(-seed[0]) if free1 else -(T14 * factor1)
        s1 = math.sin(-seed[0]) if free1 else -(T24 * factor1)

        # theta4
        c4 = math.cos(v1) if steep else t11 * c1 + t21 * s1
        s4 = math.sin(v1) if steep else t11 * s1 - t21 * c1

        # theta3
        v2 = w1 * e1 + k2
        N3 = v3 + v2 * v2
        K3 = N3 - k3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        c3 = K3 * k4

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        Y1_2 = a2 + a3 * c3
        v5, v6 = Z1_3 * Y1_2, v2 * Y1_2

        # joint values
        q4 = _wrap(offset4 - _atan2(s4, c4))

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            s3 = w3 * e3 * k4
            q3 = _atan2(s3, c3)

            # theta2
            v4 = a3 * s3
            S2 = v2 * v4 - v5
            v7 = Z1_3 * v4 + v6
            w2 = math.sqrt(S2 * S2 + v7 * v7)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else -(v7 * factor2)
            s2 = math.sin(seed[1]) if free2 else S2 * factor2
            q2 = _atan2(s2, c2)
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = -_atan2(s1, c1), q2, q3
            q[row, 3] = q4
            status[row] = FREE_JOINT if free1 or free2 or steep else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T11, T14, T21 = kept[0 * w + k], kept[3 * w + k], kept[4 * w + k]
        T24, T34 = kept[7 * w + k], kept[11 * w + k]

        # theta1, type 2: U1[3, 4]
        v1 = T14 * T14 + T24 * T24
        w1 = math.sqrt(v1)

        # theta4, type 3: U1[1, 1] and U1[3, 1]
        s4 = T14 * T21 - T24 * T11

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        Z1_3, v2, v3 = T34 - k1, k2 + w1, k2 - w1
        v4 = Z1_3 * Z1_3
        N3_p, N3_m = v4 + v2 * v2, v4 + v3 * v3
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3)
        D3_squared_m, w3_p = (longest3 - N3_m) * (N3_m - shortest3), math.sqrt(D3_squared_p)
        w3_m, v5 = math.sqrt(D3_squared_m), w3_p - w3_p
        v6 = w3_m - w3_m

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        v7, v8, v9 = m4 * (N3_p * -Z1_3), m4 * (N3_m * -Z1_3), m4 * Z1_3
        v10, v11, v12 = m4 * -Z1_3, m4 * (v2 * N3_p), m4 * (v3 * N3_m)
        v13 = w3_p * (m4 * v2)

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if N3_m <= doubt_limit_squared2 or abs(D3_squared_m) <= m3 or N3_p <=
            doubt_limit_squared2 or T11 * T11 + T21 * T21 <= m1 or v1 <= m2 or abs(D3_squared_p) <=
            m3 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = s4, v5, v6
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = w3_p, w3_m, v7 + v13
        turns[3 * w + k], turns[4 * w + k] = v7 - v13, v8 + w3_m * (m4 * v3)
        turns[5 * w + k], turns[6 * w + k], turns[7 * w + k] = v8 + w3_m * (m4 * -v3), s4, -T24
        turns[8 * w + k], turns[9 * w + k] = N3_p - k3, N3_m - k3
        turns[10 * w + k], turns[11 * w + k] = -(v11 + w3_p * v9), -(v11 + w3_p * v10)
        turns[12 * w + k], turns[13 * w + k] = -(v12 + w3_m * v9), -(v12 + w3_m * v10)
        turns[14 * w + k], turns[15 * w + k] = -(T14 * T11 + T24 * T21), -T14
    if w == 1 and kept[16] != 0.0:
        return
    for k in range(0 * w, 8 * w):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        T24, s4, v5 = kept[7 * w + k], kept[17 * w + k], kept[18 * w + k]
        v6, angle1, angle2 = kept[19 * w + k], turns[0 * w + k], turns[1 * w + k]
        angle3, angle4, angle5 = turns[2 * w + k], turns[3 * w + k], turns[4 * w + k]
        angle6, angle7, angle8 = turns[5 * w + k], turns[6 * w + k], turns[7 * w + k]

        # joint values
        v14, v15 = offset4 - angle7, offset4 - (angle7 - math.copysign(half_turn, s4))
        v16, v17 = angle8 - math.copysign(half_turn, -T24), abs(angle8) - high1
        v18, q1_pp, q1_mp = abs(v16) - high1, v5 - angle8, v6 - v16
        q4_pp = v5 + (v14 + (-turn if half_turn < v14 else 0.0))
        q4_mp = v6 + (v15 + (-turn if half_turn < v15 else 0.0))
        excess_pp = (
            max(max(low3 - angle1, angle1 - high3), max(v17, max(low2 - angle3, angle3 - high2)))
        )
        excess_pm = (
            max(max(low3 + angle1, -(high3 + angle1)), max(v17, max(low2 - angle4, angle4 - high2)))
        )
        excess_mp = (
            max(max(low3 - angle2, angle2 - high3), max(v18, max(low2 - angle5, angle5 - high2)))
        )
        excess_mm = (
            max(max(low3 + angle2, -(high3 + angle2)), max(v18, max(low2 - angle6, angle6 - high2)))
        )
        outside_pp, outside_pm, outside_mp = 0.0 < excess_pp, 0.0 < excess_pm, 0.0 < excess_mp
        outside_mm = 0.0 < excess_mm

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(excess_mm - limit_slack) <= limit_slack or abs(excess_mp - limit_slack) <=
            limit_slack or abs(excess_pp - limit_slack) <= limit_slack or abs(excess_pm -
            limit_slack) <= limit_slack else kept[16 * w + k]
        )

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_pp, angle3, angle1
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_pp, angle4, -angle1
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q1_mp, angle5, angle2
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q4_mp, angle6, -angle2
        rows[12 * w + k] = UNREACHABLE if q1_pp != q1_pp else (OUT_OF_LIMITS if outside_pp else OK)
        rows[13 * w + k] = UNREACHABLE if q1_pp != q1_pp else (OUT_OF_LIMITS if outside_pm else OK)
        rows[14 * w + k] = UNREACHABLE if q1_mp != q1_mp else (OUT_OF_LIMITS if outside_mp else OK)
        rows[15 * w + k] = UNREACHABLE if q1_mp != q1_mp else (OUT_OF_LIMITS if outside_mm else OK)


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 20, 16, [
    [0, 1, 2, 3], [0, 4, 5, 3], [6, 7, 8, 9], [6, 10, 11, 9],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "yaw", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
