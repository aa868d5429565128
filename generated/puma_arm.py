# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: d47b230c056f04e4
"""puma_arm: PUMA 560 to its wrist centre.

Inverse kinematics, generated from robots/puma_arm.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/puma_arm.yaml. The formulas and where they come from: puma_arm.md.

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

NAME = "puma_arm"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRR"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = ((-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf))
BRANCHES = ("right-down", "right-up", "left-up", "left-down")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, reach_slack1 = 1.7057800000000002e-13 [m], merge_slack1 = 1.70578e-14 [m],
# arm_size1 = 1.70578 [m].
d1 = 0.67183  # joint offset 1 [m]
a2 = 0.4318  # link length 2 [m]
d3 = 0.15005  # joint offset 3 [m]
a3 = 0.0203  # link length 3 [m]
d4 = 0.4318  # z of the tool frame [m]
free_limit_squared2 = 2.9096854084e-24  # square of a length that fixes no angle [m^2]
least_root1 = 5.394149987162018e-07  # a root of nothing, by rounding [m]
longest3 = 0.7466289125534531  # square of the longest reach [m^2]
shortest3 = 2.274465470660925e-07  # square of the shortest reach [m^2]
boundary3 = 2.1999652436149993e-13  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.7466289125534236  # the longest, where branches merge [m^2]
shortest3_apart = 2.2744654708236271e-07  # the shortest, where branches merge [m^2]
k1 = 0.022515002499999996  # d3^2 [m^2]
k2 = 5.11904578000291e-14  # reach_slack1 * (2 * d3 + reach_slack1) [m^2]
k3 = 5.1190457800002905e-15  # merge_slack1 * (2 * d3 + merge_slack1) [m^2]
k4 = 0.5862420710759887  # 1 / arm_size1 [m^-1]
k5 = 0.37290248000000004  # 2 * d4 * a2 [m^2]
k6 = 0.01753108  # 2 * a3 * a2 [m^2]
k7 = 0.37331457  # d4 * a2 + (a3^2 + d4 * a2) [m^2]
k8 = 7.175474885806929  # 1 / (k5^2 + k6^2) [m^-4]
turn1 = 1.5238184104468135  # atan2(k5, k6) [rad]
m1 = 5.119045780000291e-12  # 1000 * k3 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 2.2049387897563516e-11
m3 = 1.1579434923575729  # k8 * (d4 * k5 + a3 * k6) [m^-1]
m4 = 0.000477176933765627  # d4 * k5 * k7 * k8 + a3 * k6 * k7 * k8 - a2 [m]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="none",
    miss_weights=(0.5862, 0.5862, 0.5862, 0.0, 0.0, 0.0), size=1.70578,
    steps=("merges", "refines", "follows seed"),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.67183, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.4318, 0.0),
    (0.0, 0.15005, 0.0203, -1.5707963267948966),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    tool=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.4318),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v3, v4, z3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    T[0, 0], T[0, 1], T[0, 2] = x3_x, -s1, -v3
    T[0, 3] = x2_x * a2 + x3_x * a3 + s1 * d3 - v3 * d4
    T[1, 0], T[1, 1], T[1, 2] = x3_y, c1, -v4
    T[1, 3] = x2_y * a2 + x3_y * a3 - c1 * d3 - v4 * d4
    T[2, 0], T[2, 2], T[2, 3] = x3_z, z3_z, d1 + s2 * a2 + x3_z * a3 + z3_z * d4
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2, p2_x, p2_y = s1 * s2, x2_x * a2, x2_y * a2
    p2_z = d1 + s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    J21 = p2_x + (x2_x * c3 - v1 * s3) * a3 + s1 * d3 - (v1 * c3 + x2_x * s3) * d4
    v3 = p2_y + (x2_y * c3 - v2 * s3) * a3 - c1 * d3 - (v2 * c3 + x2_y * s3) * d4
    v4 = p2_z + (s2 * c3 + c2 * s3) * a3 + (c2 * c3 - s2 * s3) * d4
    v5, v6 = v4 - d1, v4 - p2_z
    J[0, 0], J[0, 1], J[0, 2] = -v3, -(c1 * v5), -(c1 * v6)
    J[1, 0], J[1, 1], J[1, 2] = J21, -(s1 * v5), -(s1 * v6)
    J[2, 1], J[2, 2] = s1 * v3 + c1 * J21, s1 * (v3 - p2_y) + c1 * (J21 - p2_x)
    J[3, 1], J[3, 2] = s1, s1
    J[4, 1], J[4, 2] = -c1, -c1
    J[5, 0] = 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    # theta1, type 2: U1[3, 4]
    N1 = T14 * T14 + T24 * T24
    D1_squared = N1 - k1
    apart1 = k3 < D1_squared
    if not (-k2 <= D1_squared):
        return  # out of reach
    w1 = math.sqrt(D1_squared if apart1 else 0.0)
    v1 = (w1 if apart1 else least_root1) * k4
    inverse1 = 1.0 / (N1 if apart1 else d3 * math.sqrt(N1))
    v2, v3 = T14 * d3, T24 * d3

    # theta3, type 6: U1[2, 4] and U1[1, 4]
    Z1_3 = T34 - d1
    v4 = Z1_3 * Z1_3

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and not apart1:
            continue  # both signs give the same
        D1 = w1 * e1
        c1, s1 = inverse1 * (T14 * D1 - v3), inverse1 * (v2 + T24 * D1)
        q1 = _atan2(s1, c1)

        # theta3
        N3 = v4 + D1 * D1
        K3 = N3 - k7
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= v1 * D3_squared):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        v5, v6 = k5 * K3, k6 * K3

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            D3 = w3 * e3
            s3, c3 = (k6 * D3 - v5) * k8, k8 * (v6 + k5 * D3)
            q3 = _atan2(s3, c3)

            # theta2, type 3: U1[2, 4] and U1[1, 4]
            X1_2 = a2 + (a3 * c3 - d4 * s3)
            Y1_2 = d4 * c3 + a3 * s3
            S2 = Z1_3 * X1_2 - D1 * Y1_2
            C2 = D1 * X1_2 + Z1_3 * Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else S2 * factor2
            q2 = _atan2(s2, c2)
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
            status[row] = FREE_JOINT if free2 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T14, T24, T34 = kept[3 * w + k], kept[7 * w + k], kept[11 * w + k]

        # theta1, type 2: U1[3, 4]
        D1_squared = T14 * T14 + T24 * T24 - k1
        w1 = math.sqrt(D1_squared)
        v1, v2, v3 = w1 - w1, d3 * T14, d3 * T24
        v4, v5 = T14 * w1, T24 * w1

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        Z1_3 = T34 - d1
        N3 = D1_squared + Z1_3 * Z1_3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)
        v6 = w3 - w3

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        X1_2 = m3 * N3 - m4
        v8, v9, v10 = Z1_3 * X1_2, w3 * (m3 * Z1_3), w3 * (m3 * -Z1_3)
        v11, v12, v13 = w1 * X1_2, w1 * -X1_2, w3 * (m3 * w1)
        v14, v15 = v8 - v13, v8 + v13

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if abs(D1_squared) <= m1 or abs(D3_squared * (k4 * w1)) <= m2 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], turns[0 * w + k] = v1, v6, w3
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = v14, v15, v15
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = v14, v2 + v5, v2 - v5
        turns[8 * w + k], turns[9 * w + k], turns[10 * w + k] = N3 - k7, v9 + v11, v10 + v11
        turns[11 * w + k], turns[12 * w + k], turns[13 * w + k] = v9 + v12, v10 + v12, v4 - v3
        turns[14 * w + k] = -(v3 + v4)
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 7 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(7 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        v1, v6, angle1 = kept[17 * w + k], kept[18 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        q3__p, v7 = angle1 - turn1, turn1 + angle1

        # joint values
        q1_pp, q1_mp = v6 + angle6, v6 + angle7
        q3_pp = v1 + (q3__p + (turn if q3__p <= -half_turn else 0.0))
        q3_pm = v1 + ((turn if -v7 <= -half_turn else 0.0) - v7)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_pp, angle2, q3_pp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle3, q3_pm, q1_mp
        rows[6 * w + k], rows[7 * w + k] = angle4, angle5
        rows[8 * w + k] = rows[9 * w + k] = UNREACHABLE if q1_pp != q1_pp else OK
        rows[10 * w + k] = rows[11 * w + k] = UNREACHABLE if q1_mp != q1_mp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 19, 16, [
    [0, 1, 2], [0, 3, 4], [5, 6, 2], [5, 7, 4],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "position", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
