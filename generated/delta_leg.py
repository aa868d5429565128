# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: f33bcc1b99634bba
"""delta_leg: Delta, three cranks with parallelograms: a leg.

Inverse kinematics, generated from robots/delta.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/delta.yaml. The formulas and where they come from: delta_leg.md, of a
leg of delta.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 3), _runtime("arrays").zeros

NAME = "delta_leg"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRR"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = (
    (-1.0471975511965976, 1.5707963267948966), (-math.inf, math.inf),
    (-1.0471975511965976, 1.0471975511965976),
)
BRANCHES = ("shoulder+-elbow+", "shoulder+-elbow-", "shoulder--elbow+", "shoulder--elbow-")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 0.0001768 [m].
crank = 0.524  # link length 1 [m]
rod = 1.244  # link length 3 [m]
free_limit_squared4 = 9.770775678976e-24  # square of a length that fixes no angle [m^4]
reach_slack2 = 3.1258240000000004e-13  # rounding at the boundary of the workspace [m^2]
merge_slack2 = 3.125824e-14  # nearer to that boundary two branches are one [m^2]
free_limit1 = 1.768e-12  # a length that fixes no angle [m]
k1 = -1.2729599999999999  # crank^2 - rod^2 [m^2]
k2 = 0.6461885216240527  # 1 / (rod^2) [m^-2]
doubt_limit_squared4 = 9.770775678976e-08  # square of a length that fixes no angle [m^4]
low1 = -1.0471975521965977  # lowest value of joint 1, with what rounding adds [rad]
high1 = 1.5707963277948966  # highest value of joint 1, with what rounding adds [rad]
high3 = 1.0471975521965977  # highest value of joint 3, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 3.1258239999999996e-11  # 1000 * merge_slack2 [m^2]
m2 = 0.524  # crank [m]
m3 = 3.125824e-08  # doubt_limit1^2 [m^2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="none",
    miss_weights=(0.5656, 0.5656, 0.5656, 0.0, 0.0, 0.0), size=1.768,
    steps=("keeps limits", "clamps", "clamps far", "follows seed"), choosable=(1, 0),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.524, 0.0),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 1.244, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y = x2_x * c3, x2_y * c3
    T[0, 0], T[0, 1], T[0, 2] = x3_x, -(x2_x * s3), x2_y
    T[0, 3] = c1 * crank + x3_x * rod
    T[1, 0], T[1, 1], T[1, 2] = x3_y, -(x2_y * s3), -x2_x
    T[1, 3] = s1 * crank + x3_y * rod
    T[2, 0], T[2, 1], T[2, 3] = s3, c3, s3 * rod
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * crank, s1 * crank
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    p3_x, p3_y, p3_z = p1_x + x2_x * c3 * rod, p1_y + x2_y * c3 * rod, s3 * rod
    J22, v1 = p3_x - p1_x, p3_y - p1_y
    J[0, 0], J[0, 1], J[0, 2] = -p3_y, -v1, -x2_x * p3_z
    J[1, 0], J[1, 1], J[1, 2] = p3_x, J22, -(x2_y * p3_z)
    J[2, 2] = x2_y * v1 - -x2_x * J22
    J[3, 2] = x2_y
    J[4, 2] = -x2_x
    J[5, 0], J[5, 1] = 1.0, 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    # theta1, type 2: the squared length of column 4 of U1
    X1 = T24 * crank * 2.0
    Y1 = 2.0 * (crank * T14)
    N1 = X1 * X1 + Y1 * Y1
    free1 = N1 <= free_limit_squared4
    Z1 = T14 * T14 + (T24 * T24 + (T34 * T34 + k1))
    D1_squared = N1 - Z1 * Z1
    v1 = abs(Z1)
    v2 = 2.0 * v1
    apart1 = merge_slack2 * (v2 + merge_slack2) < D1_squared
    if not (-(reach_slack2 * (v2 + reach_slack2)) < D1_squared):
        return  # out of reach
    w1 = math.sqrt(D1_squared if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else v1 * math.sqrt(N1)))
    v3, v4 = X1 * Z1, Y1 * Z1

    # theta3, type 3: U2[2, 4] and U2[1, 4]
    s3 = T34 * rod * k2

    for i1 in range(2):  # shoulder+, shoulder-
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        D1 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else inverse1 * (v4 - X1 * D1)
        s1 = math.sin(seed[0]) if free1 else inverse1 * (v3 + Y1 * D1)
        q1 = _atan2(s1, c1)

        # theta2, type 2: U2[3, 4]
        X2 = crank - (T14 * c1 + T24 * s1)
        Y2 = T24 * c1 - T14 * s1
        w2 = math.sqrt(X2 * X2 + Y2 * Y2)
        free2 = w2 <= free_limit1
        divisor2 = 1.0 if free2 else w2

        for i2 in range(2):  # elbow+, elbow-
            e2 = 1.0 - 2.0 * i2
            # theta2
            if e2 < 0.0 and free2:
                continue  # both signs give the same
            factor2 = e2 / divisor2
            c2 = math.cos(seed[1]) if free2 else -(X2 * factor2)
            s2 = math.sin(seed[1]) if free2 else Y2 * factor2
            q2 = _atan2(s2, c2)

            # theta3
            c12, s12 = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
            c3 = rod * (T14 * c12 + T24 * s12 - crank * c2) * k2
            q3 = _atan2(s3, c3)
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

        # theta1, type 2: the squared length of column 4 of U1
        X1, Y1 = crank * T24 * 2.0, 2.0 * (crank * T14)
        N1, Z1 = X1 * X1 + Y1 * Y1, T14 * T14 + (T24 * T24 + (k1 + T34 * T34))
        D1_squared = N1 - Z1 * Z1
        w1, inverse1, v1 = math.sqrt(D1_squared), 1.0 / N1, X1 * Z1
        v2 = Y1 * Z1
        v3, v4 = inverse1 * v2, w1 * (X1 * inverse1)
        c1_p, c1_m, v5 = v3 - v4, v3 + v4, inverse1 * v1
        v6 = w1 * (Y1 * inverse1)
        s1_p, s1_m = v5 + v6, v5 - v6

        # theta2, type 2: U2[3, 4]
        v7, v8 = X1 * T14 - T24 * Y1, m2 - inverse1 * (T24 * v1 + T14 * v2)
        X2_p, X2_m = v8 + w1 * (inverse1 * v7), v8 + w1 * (inverse1 * -v7)
        Y2_p, Y2_m = T24 * c1_p - T14 * s1_p, T24 * c1_m - T14 * s1_m
        v9, v10 = X2_p * X2_p + Y2_p * Y2_p, X2_m * X2_m + Y2_m * Y2_m

        # theta3, type 3: U2[2, 4] and U2[1, 4]
        s3 = k2 * (rod * T34)
        v11 = math.copysign(half_turn, s3)

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(D1_squared) <= m1 * (merge_slack2 + 2.0 * abs(Z1)) or N1 <=
            doubt_limit_squared4 or v9 <= m3 or v10 <= m3 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = Y2_p, Y2_m, v11
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = s1_p, s1_m, Y2_p
        turns[3 * w + k], turns[4 * w + k], turns[5 * w + k] = Y2_m, s3, s3
        turns[8 * w + k], turns[9 * w + k], turns[10 * w + k] = c1_p, c1_m, -X2_p
        turns[11 * w + k] = -X2_m
        turns[12 * w + k] = (
            math.sqrt(v9) * (1.0 / v9) * (k2 * (rod * (T24 * (c1_p * Y2_p - s1_p * X2_p) - T14 *
            (c1_p * X2_p + s1_p * Y2_p) + crank * X2_p)))
        )
        turns[13 * w + k] = (
            math.sqrt(v10) * (1.0 / v10) * (k2 * (rod * (T24 * (c1_m * Y2_m - s1_m * X2_m) - T14 *
            (c1_m * X2_m + s1_m * Y2_m) + crank * X2_m)))
        )
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 6 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(6 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        Y2_p, Y2_m, v11 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5, angle6 = turns[3 * w + k], turns[4 * w + k], turns[5 * w + k]

        # theta2, type 2: U2[3, 4]
        q2_pm = angle3 - math.copysign(half_turn, Y2_p)
        q2_mm = angle4 - math.copysign(half_turn, Y2_m)

        # theta3, type 3: U2[2, 4] and U2[1, 4]
        q3_pm, q3_mm = v11 - angle5, v11 - angle6

        # joint values
        v12, v13 = max(low1 - angle1, angle1 - high1), max(low1 - angle2, angle2 - high1)
        excess_pp, excess_pm = max(v12, abs(angle5) - high3), max(v12, abs(q3_pm) - high3)
        excess_mp, excess_mm = max(v13, abs(angle6) - high3), max(v13, abs(q3_mm) - high3)
        outside_pp, outside_pm, outside_mp = 0.0 < excess_pp, 0.0 < excess_pm, 0.0 < excess_mp
        outside_mm = 0.0 < excess_mm

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(excess_mm - limit_slack) <= limit_slack or abs(excess_mp - limit_slack) <=
            limit_slack or abs(excess_pp - limit_slack) <= limit_slack or abs(excess_pm -
            limit_slack) <= limit_slack else kept[16 * w + k]
        )

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle1, angle3, angle5
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q2_pm, q3_pm, angle2
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = angle4, angle6, q2_mm
        rows[9 * w + k] = q3_mm
        rows[10 * w + k] = (
            UNREACHABLE if angle1 != angle1 else (OUT_OF_LIMITS if outside_pp else OK)
        )
        rows[11 * w + k] = (
            UNREACHABLE if angle1 != angle1 else (OUT_OF_LIMITS if outside_pm else OK)
        )
        rows[12 * w + k] = (
            UNREACHABLE if angle2 != angle2 else (OUT_OF_LIMITS if outside_mp else OK)
        )
        rows[13 * w + k] = (
            UNREACHABLE if angle2 != angle2 else (OUT_OF_LIMITS if outside_mm else OK)
        )


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 20, 16, [
    [0, 1, 2], [0, 3, 4], [5, 6, 7], [5, 8, 9],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "position", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
