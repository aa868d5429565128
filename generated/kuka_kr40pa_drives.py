# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: a161591f8bab6b71
"""kuka_kr40pa_drives: KUKA KR 40 PA palletizer, its hand's joint, by its drives.

Inverse kinematics, generated from robots/kuka_kr40pa_drives.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kuka_kr40pa_drives.yaml. The formulas and where they come from:
kuka_kr40pa_drives.md.

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

NAME = "kuka_kr40pa_drives"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRR"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = (
    (-2.705260340591211, 2.705260340591211), (-2.2165681500327987, 0.3490658503988659),
    (-0.3490658503988659, 2.2689280275926285),
)
BRANCHES = ("back-down", "back-up", "front-up", "front-down")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 0.000205 [m].
d1 = 0.3  # joint offset 1 [m]
a1 = 0.15  # link length 1 [m]
a2 = 0.8  # link length 2 [m]
a3 = 0.8  # link length 3 [m]
free_limit1 = 2.05e-12  # a length that fixes no angle [m]
longest3 = 2.5600000000000005  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
longest3_reach = 2.560000000000656  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0  # the shortest, with what rounding adds [m^2]
longest3_apart = 2.5599999999999348  # the longest, where branches merge [m^2]
shortest3_apart = 4.202499999999999e-28  # the shortest, where branches merge [m^2]
free_limit_squared2 = 4.2024999999999996e-24  # square of a length that fixes no angle [m^2]
k1 = 1.2800000000000002  # 2 * a3 * a2 [m^2]
k2 = 0.7812499999999999  # 1 / k1 [m^-2]
doubt_limit_squared2 = 4.2024999999999994e-08  # square of a length that fixes no angle [m^2]
high1 = 2.705260341591211  # highest value of joint 1, with what rounding adds [rad]
low2 = -2.216568151032799  # lowest value of joint 2, with what rounding adds [rad]
high2 = 0.3490658513988659  # highest value of joint 2, with what rounding adds [rad]
low3 = -0.3490658513988659  # lowest value of joint 3, with what rounding adds [rad]
high3 = 2.2689280285926285  # highest value of joint 3, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 4.2025e-08  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 1.6825651982798743e-10
m4 = 0.625  # a3 * k2 [m^-1]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="none",
    miss_weights=(0.4878, 0.4878, 0.4878, 0.0, 0.0, 0.0), size=2.05,
    steps=("keeps limits", "clamps", "clamps far", "follows seed"), choosable=(1, 0),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.3, 0.15, -1.5707963267948966),
    (0.0, 0.0, 0.8, 0.0),
    (0.0, 0.0, 0.8, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    drives=((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, -1.0, 1.0)),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2, v3 = s1 * s2, q[2] - q[1]
    c3, s3 = math.cos(v3), math.sin(v3)
    x3_x, x3_y, v4 = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    T[0, 0], T[0, 1], T[0, 2] = x3_x, -(v1 * c3 + x2_x * s3), -s1
    T[0, 3] = c1 * a1 + x2_x * a2 + x3_x * a3
    T[1, 0], T[1, 1], T[1, 2] = x3_y, -(v2 * c3 + x2_y * s3), c1
    T[1, 3] = s1 * a1 + x2_y * a2 + x3_y * a3
    T[2, 0], T[2, 1], T[2, 3] = -v4, s2 * s3 - c2 * c3, d1 - s2 * a2 - v4 * a3
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * a1, s1 * a1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2, s1 * c2
    p2_x, p2_y, p2_z = p1_x + x2_x * a2, p1_y + x2_y * a2, d1 - s2 * a2
    v1 = q[2] - q[1]
    c3, s3 = math.cos(v1), math.sin(v1)
    p3_x, p3_y = p2_x + (x2_x * c3 - c1 * s2 * s3) * a3, p2_y + (x2_y * c3 - s1 * s2 * s3) * a3
    p3_z = p2_z - (s2 * c3 + c2 * s3) * a3
    v2, v3 = p3_z - d1, p3_z - p2_z
    J13, J23, v4 = c1 * v3, s1 * v3, s1 * (p3_y - p2_y) + c1 * (p3_x - p2_x)
    J[0, 0], J[0, 1], J[0, 2] = -p3_y, c1 * v2 - J13, J13
    J[1, 0], J[1, 1], J[1, 2] = p3_x, s1 * v2 - J23, J23
    J[2, 1], J[2, 2] = v4 - (s1 * (p3_y - p1_y) + c1 * (p3_x - p1_x)), -v4
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
    v2 = Z1_3 * Z1_3

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(T14 * factor1)
        s1 = math.sin(seed[0]) if free1 else -(T24 * factor1)
        q1 = _atan2(s1, c1)

        # theta3
        v1 = w1 * e1 + a1
        N3 = v2 + v1 * v1
        K3 = N3 - k1
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        c3 = K3 * k2

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        Y1_2 = a2 + a3 * c3
        v4, v5 = Z1_3 * Y1_2, v1 * Y1_2

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            s3 = w3 * e3 * k2

            # theta2
            v3 = a3 * s3
            S2 = v1 * v3 - v4
            v6 = Z1_3 * v3 + v5
            w2 = math.sqrt(S2 * S2 + v6 * v6)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else -(v6 * factor2)
            s2 = math.sin(seed[1]) if free2 else S2 * factor2
            q2 = _atan2(s2, c2)

            # joint values
            q3 = _wrap(_atan2(s3, c3) + q2)
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
            status[row] = FREE_JOINT if free1 or free2 else OK


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
        Z1_3, v2, v3 = T34 - d1, a1 + w1, a1 - w1
        v4 = Z1_3 * Z1_3
        N3_p, N3_m = v4 + v2 * v2, v4 + v3 * v3
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3)
        D3_squared_m, w3_p = (longest3 - N3_m) * (N3_m - shortest3), math.sqrt(D3_squared_p)
        w3_m = math.sqrt(D3_squared_m)

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        v5, v6, v7 = m4 * (N3_p * -Z1_3), m4 * (N3_m * -Z1_3), m4 * Z1_3
        v8, v9, v10 = m4 * -Z1_3, m4 * (v2 * N3_p), m4 * (v3 * N3_m)
        v11 = w3_p * (m4 * v2)

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if N3_m <= doubt_limit_squared2 or abs(D3_squared_m) <= m3 or N3_p <=
            doubt_limit_squared2 or v1 <= m1 or abs(D3_squared_p) <= m3 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], turns[0 * w + k] = w3_p, w3_m, -T24
        turns[1 * w + k], turns[2 * w + k] = v5 + v11, v5 - v11
        turns[3 * w + k], turns[4 * w + k] = v6 + w3_m * (m4 * v3), v6 + w3_m * (m4 * -v3)
        turns[5 * w + k], turns[6 * w + k], turns[8 * w + k] = w3_p, w3_m, -T14
        turns[9 * w + k], turns[10 * w + k] = -(v9 + w3_p * v7), -(v9 + w3_p * v8)
        turns[11 * w + k], turns[12 * w + k] = -(v10 + w3_m * v7), -(v10 + w3_m * v8)
        turns[13 * w + k], turns[14 * w + k] = N3_p - k1, N3_m - k1
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 7 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(7 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        T24, w3_p, w3_m = kept[7 * w + k], kept[17 * w + k], kept[18 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5, angle6 = turns[3 * w + k], turns[4 * w + k], turns[5 * w + k]
        angle7 = turns[6 * w + k]

        # theta1, type 2: U1[3, 4]
        q1__m = angle1 - math.copysign(half_turn, -T24)

        # joint values
        v12, v13, v14 = angle2 + angle6, angle3 - angle6, angle4 + angle7
        v15 = angle5 - angle7
        q3_pp = v12 + (turn if v12 <= -half_turn else (-turn if half_turn < v12 else 0.0))
        q3_pm = v13 + (turn if v13 <= -half_turn else (-turn if half_turn < v13 else 0.0))
        q3_mp = v14 + (turn if v14 <= -half_turn else (-turn if half_turn < v14 else 0.0))
        q3_mm = v15 + (turn if v15 <= -half_turn else (-turn if half_turn < v15 else 0.0))
        v16, v17, q1_pp = abs(angle1) - high1, abs(q1__m) - high1, angle1 + (w3_p - w3_p)
        q1_mp = q1__m + (w3_m - w3_m)
        excess_pp = (
            max(max(low3 - q3_pp, q3_pp - high3), max(v16, max(low2 - angle2, angle2 - high2)))
        )
        excess_pm = (
            max(max(low3 - q3_pm, q3_pm - high3), max(v16, max(low2 - angle3, angle3 - high2)))
        )
        excess_mp = (
            max(max(low3 - q3_mp, q3_mp - high3), max(v17, max(low2 - angle4, angle4 - high2)))
        )
        excess_mm = (
            max(max(low3 - q3_mm, q3_mm - high3), max(v17, max(low2 - angle5, angle5 - high2)))
        )
        outside_pp, outside_pm, outside_mp = 0.0 < excess_pp, 0.0 < excess_pm, 0.0 < excess_mp
        outside_mm = 0.0 < excess_mm

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(excess_mm - limit_slack) <= limit_slack or abs(excess_mp - limit_slack) <=
            limit_slack or abs(excess_pp - limit_slack) <= limit_slack or abs(excess_pm -
            limit_slack) <= limit_slack else kept[16 * w + k]
        )

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_pp, angle2, q3_pp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle3, q3_pm, q1_mp
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = angle4, q3_mp, angle5
        rows[9 * w + k] = q3_mm
        rows[10 * w + k] = UNREACHABLE if q1_pp != q1_pp else (OUT_OF_LIMITS if outside_pp else OK)
        rows[11 * w + k] = UNREACHABLE if q1_pp != q1_pp else (OUT_OF_LIMITS if outside_pm else OK)
        rows[12 * w + k] = UNREACHABLE if q1_mp != q1_mp else (OUT_OF_LIMITS if outside_mp else OK)
        rows[13 * w + k] = UNREACHABLE if q1_mp != q1_mp else (OUT_OF_LIMITS if outside_mm else OK)


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 19, 16, [
    [0, 1, 2], [0, 3, 4], [5, 6, 7], [5, 8, 9],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "position", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
