# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: c347f76f4868f211
"""puma560: Unimation PUMA 560.

Inverse kinematics, generated from robots/puma560.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/puma560.yaml. The formulas and where they come from: puma560.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 6), _runtime("arrays").zeros

NAME = "puma560"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-2.792526803190927, 2.792526803190927), (-1.9198621771937625, 1.9198621771937625),
    (-2.356194490192345, 2.356194490192345), (-4.642575810304916, 4.642575810304916),
    (-1.7453292519943295, 1.7453292519943295), (-4.642575810304916, 4.642575810304916),
)
BRANCHES = (
    "right-down-noflip", "right-down-flip", "right-up-noflip", "right-up-flip", "left-up-noflip",
    "left-up-flip", "left-down-noflip", "left-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, reach_slack1 = 1.7057800000000002e-13 [m], merge_slack1 = 1.70578e-14 [m],
# arm_size1 = 1.70578 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.67183  # joint offset 1 [m]
a2 = 0.4318  # link length 2 [m]
d3 = 0.15005  # joint offset 3 [m]
a3 = 0.0203  # link length 3 [m]
d4 = 0.4318  # joint offset 4 [m]
free_limit_squared2 = 2.9096854084e-24  # square of a length that fixes no angle [m^2]
least_root1 = 5.394149987162018e-07  # a root of nothing, by rounding [m]
longest3 = 0.7466289125534531  # square of the longest reach [m^2]
shortest3 = 2.274465470660925e-07  # square of the shortest reach [m^2]
boundary3 = 2.1999652436149993e-13  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.7466289125534236  # the longest, where branches merge [m^2]
shortest3_apart = 2.2744654708236271e-07  # the shortest, where branches merge [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.022515002499999996  # d3^2 [m^2]
k2 = 5.11904578000291e-14  # reach_slack1 * (2 * d3 + reach_slack1) [m^2]
k3 = 5.1190457800002905e-15  # merge_slack1 * (2 * d3 + merge_slack1) [m^2]
k4 = 0.5862420710759887  # 1 / arm_size1 [m^-1]
k5 = 0.37290248000000004  # 2 * d4 * a2 [m^2]
k6 = 0.01753108  # 2 * a3 * a2 [m^2]
k7 = 0.37331457  # d4 * a2 + (a3^2 + d4 * a2) [m^2]
k8 = 7.175474885806929  # 1 / (k5^2 + k6^2) [m^-4]
turn1 = 1.5238184104468135  # atan2(k5, k6) [rad]
high1 = 2.7925268041909272  # highest value of joint 1, with what rounding adds [rad]
high2 = 1.9198621781937626  # highest value of joint 2, with what rounding adds [rad]
high3 = 2.356194491192345  # highest value of joint 3, with what rounding adds [rad]
high5 = 1.7453292529943296  # highest value of joint 5, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 5.119045780000291e-12  # 1000 * k3 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 2.2049387897563516e-11
m3 = 0.12579382426107213  # k6 * k8 [m^-2]
m4 = 0.9988973492016866  # k5 * k7 * k8
m5 = 2.675752380095121  # k5 * k8 [m^-2]
m6 = 0.046960667412677716  # k6 * k7 * k8
m7 = 1.1579434923575729  # k8 * (d4 * k5 + a3 * k6) [m^-1]
m8 = 0.000477176933765627  # d4 * k5 * k7 * k8 + a3 * k6 * k7 * k8 - a2 [m]
m9 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.5862, 0.5862, 0.5862, 1.0, 1.0, 1.0), size=1.70578,
    steps=(
        "keeps limits",
        "merges",
        "refines",
        "clamps",
        "clamps far",
        "range exceeds a turn",
        "follows seed",
    ),
    choosable=(3, 1),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.67183, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.4318, 0.0),
    (0.0, 0.15005, 0.0203, -1.5707963267948966),
    (0.0, 0.4318, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
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
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v3, v4, z3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - s1 * s4, x3_y * c4 + c1 * s4, x3_z * c4
    z4_x, y5_y, z4_z = s1 * c4 + x3_x * s4, c1 * c4 - x3_y * s4, x3_z * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 - v3 * s5, x4_y * c5 - v4 * s5, x4_z * c5 + z3_z * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1] = x5_x * c6 - z4_x * s6, -(z4_x * c6 + x5_x * s6)
    T[0, 2], T[0, 3] = -(v3 * c5 + x4_x * s5), x2_x * a2 + x3_x * a3 + s1 * d3 - v3 * d4
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + y5_y * s6, y5_y * c6 - x5_y * s6, -(v4 * c5 + x4_y * s5)
    T[1, 3] = x2_y * a2 + x3_y * a3 - c1 * d3 - v4 * d4
    T[2, 0], T[2, 1] = x5_z * c6 - z4_z * s6, -(z4_z * c6 + x5_z * s6)
    T[2, 2], T[2, 3] = z3_z * c5 - x4_z * s5, d1 + s2 * a2 + x3_z * a3 + z3_z * d4
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2, p2_x, p2_y = s1 * s2, x2_x * a2, x2_y * a2
    p2_z = d1 + s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v3, v4, z3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    p3_z, p3_x, p3_y = p2_z + x3_z * a3, p2_x + x3_x * a3 + s1 * d3, p2_y + x3_y * a3 - c1 * d3
    c4, s4, p4_x = math.cos(q[3]), math.sin(q[3]), p3_x - v3 * d4
    p4_y, p4_z = p3_y - v4 * d4, p3_z + z3_z * d4
    c5, s5, v5 = math.cos(q[4]), math.sin(q[4]), p4_z - d1
    v6, v7, v8 = p4_z - p2_z, p4_x - p3_x, p4_y - p3_y
    v9 = p4_z - p3_z
    J[0, 0], J[0, 1], J[0, 2] = -p4_y, -(c1 * v5), -(c1 * v6)
    J[0, 3] = -(v4 * v9 + z3_z * v8)
    J[1, 0], J[1, 1], J[1, 2] = p4_x, -(s1 * v5), -(s1 * v6)
    J[1, 3] = z3_z * v7 + v3 * v9
    J[2, 1], J[2, 2] = s1 * p4_y + c1 * p4_x, s1 * (p4_y - p2_y) + c1 * (p4_x - p2_x)
    J[2, 3] = v4 * v7 - v3 * v8
    J[3, 1], J[3, 2], J[3, 3] = s1, s1, -v3
    J[3, 4], J[3, 5] = s1 * c4 + x3_x * s4, -(v3 * c5 + (x3_x * c4 - s1 * s4) * s5)
    J[4, 1], J[4, 2], J[4, 3] = -c1, -c1, -v4
    J[4, 4], J[4, 5] = x3_y * s4 - c1 * c4, -(v4 * c5 + (x3_y * c4 + c1 * s4) * s5)
    J[5, 0], J[5, 3], J[5, 4] = 1.0, z3_z, x3_z * s4
    J[5, 5] = z3_z * c5 - x3_z * c4 * s5
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

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

        # theta4, type 2: U4[3, 3]
        v7 = T13 * c1 + T23 * s1
        Y4 = T23 * c1 - T13 * s1
        v9 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v10, v11, v13 = T12 * s1 - T22 * c1, T12 * c1 + T22 * s1, T11 * s1 - T21 * c1
        v14 = T11 * c1 + T21 * s1

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

            # theta4
            c23, s23 = c3 * c2 - s3 * s2, c3 * s2 + s3 * c2
            v8 = c23 * v7 + T33 * s23
            w4 = math.sqrt(v8 * v8 + v9)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T33 * c23 - s23 * v7

            # theta6
            v12, v15 = c23 * v11 + T32 * s23, c23 * v14 + T31 * s23

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(seed[3]) if free4 else v8 * factor4
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)

                # theta5
                q5 = _atan2(-(w4 * e4), c5)

                # theta6
                q6 = _atan2(-(c4 * v13 + s4 * v15), -(c4 * v10 + s4 * v12))
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
                q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
                status[row] = FREE_JOINT if free2 or free4 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T11, T12, T13 = kept[0 * w + k], kept[1 * w + k], kept[2 * w + k]
        T14, T21, T22 = kept[3 * w + k], kept[4 * w + k], kept[5 * w + k]
        T23, T24, T31 = kept[6 * w + k], kept[7 * w + k], kept[8 * w + k]
        T32, T33, T34 = kept[9 * w + k], kept[10 * w + k], kept[11 * w + k]

        # theta1, type 2: U1[3, 4]
        N1 = T14 * T14 + T24 * T24
        D1_squared = N1 - k1
        w1 = math.sqrt(D1_squared)
        v1, inverse1 = w1 - w1, 1.0 / N1
        v2, v3 = inverse1 * (d3 * T24), w1 * (T14 * inverse1)
        c1_p, v4, v5 = v3 - v2, v2 + v3, inverse1 * (d3 * T14)
        v6 = w1 * (T24 * inverse1)
        s1_p, s1_m = v5 + v6, v5 - v6

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        Z1_3 = T34 - d1
        N3 = D1_squared + Z1_3 * Z1_3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)
        v7, v8, v9 = w3 - w3, m4 - m5 * N3, m3 * w3
        s3_p, s3_m, v10 = v8 + v9, v8 - v9, m3 * N3 - m6
        v11 = m5 * w3
        c3_p, c3_m = v10 + v11, v10 - v11

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        X1_2 = m7 * N3 - m8
        v13, v14 = Z1_3 * X1_2, w3 * (m7 * w1)
        S2_pp, S2_pm, v15 = v13 - v14, v13 + v14, w3 * (m7 * Z1_3)
        v16, v17, v18 = w3 * (m7 * -Z1_3), w1 * X1_2, w1 * -X1_2
        C2_pp, C2_pm, C2_mp = v15 + v17, v16 + v17, v15 + v18
        C2_mm, factor2 = v16 + v18, 1.0 / N3

        # theta4, type 2: U4[3, 3]
        c23_pp, c23_pm = c3_p * C2_pp - s3_p * S2_pp, c3_m * C2_pm - s3_m * S2_pm
        c23_mp, c23_mm = c3_p * C2_mp - s3_p * S2_pm, c3_m * C2_mm - s3_m * S2_pp
        s23_pp, s23_pm = c3_p * S2_pp + s3_p * C2_pp, c3_m * S2_pm + s3_m * C2_pm
        s23_mp, s23_mm = c3_p * S2_pm + s3_p * C2_mp, c3_m * S2_pp + s3_m * C2_mm
        v19, v20 = c1_p * T13 + s1_p * T23, s1_m * T23 - v4 * T13
        c4_pp, c4_pm = c23_pp * v19 + s23_pp * T33, c23_pm * v19 + s23_pm * T33
        c4_mp, c4_mm = c23_mp * v20 + s23_mp * T33, c23_mm * v20 + s23_mm * T33
        Y4_p, v21 = c1_p * T23 - s1_p * T13, v4 * T23 + s1_m * T13
        v22, v23, v24 = Y4_p * Y4_p, v21 * v21, factor2 * c4_pp
        v25, v26, v27 = factor2 * c4_pm, factor2 * c4_mp, factor2 * c4_mm
        v28, v29 = v22 + factor2 * (c4_pp * v24), v22 + factor2 * (c4_pm * v25)
        v30, v31 = v23 + factor2 * (c4_mp * v26), v23 + factor2 * (c4_mm * v27)
        v32, v33 = math.copysign(half_turn, Y4_p), math.copysign(half_turn, -v21)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v34, v35, v36 = s1_p * T12 - c1_p * T22, s1_m * T12 + v4 * T22, c1_p * T12 + s1_p * T22
        v37, v38, v39 = s1_m * T22 - v4 * T12, s1_p * T11 - c1_p * T21, s1_m * T11 + v4 * T21
        v40, v41 = c1_p * T11 + s1_p * T21, s1_m * T21 - v4 * T11
        v42 = v21 * (c23_mp * v41 + s23_mp * T31) - c4_mp * v39
        v43 = v21 * (c23_mm * v41 + s23_mm * T31) - c4_mm * v39

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(D3_squared * (k4 * w1)) <= m2 or abs(D1_squared) <= m1 or v31 <= m9 or v30 <=
            m9 or v28 <= m9 or v29 <= m9 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = v1, v7, c23_pp
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = c23_pm, s23_pp, s23_pm
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = c4_pp, c4_pm, Y4_p
        kept[26 * w + k], kept[27 * w + k], kept[28 * w + k] = v32, v33, v38
        kept[29 * w + k], kept[30 * w + k], kept[31 * w + k] = v40, v42, v43
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = s1_p, s1_m, w3
        turns[3 * w + k], turns[4 * w + k], turns[5 * w + k] = S2_pp, S2_pm, S2_pm
        turns[6 * w + k], turns[7 * w + k], turns[8 * w + k] = S2_pp, Y4_p, Y4_p
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = -v21, -v21, -math.sqrt(v28)
        turns[12 * w + k], turns[13 * w + k] = -math.sqrt(v29), -math.sqrt(v30)
        turns[14 * w + k] = -math.sqrt(v31)
        turns[15 * w + k] = -(c4_pp * v38 + Y4_p * (c23_pp * v40 + s23_pp * T31))
        turns[16 * w + k] = -(c4_pm * v38 + Y4_p * (c23_pm * v40 + s23_pm * T31))
        turns[17 * w + k], turns[18 * w + k], turns[24 * w + k] = v42, v43, c1_p
        turns[25 * w + k], turns[26 * w + k], turns[27 * w + k] = -v4, N3 - k7, C2_pp
        turns[28 * w + k], turns[29 * w + k], turns[30 * w + k] = C2_pm, C2_mp, C2_mm
        turns[31 * w + k], turns[32 * w + k], turns[33 * w + k] = v24, v25, v26
        turns[34 * w + k], turns[35 * w + k] = v27, factor2 * (c23_pp * T33 - s23_pp * v19)
        turns[36 * w + k] = factor2 * (c23_pm * T33 - s23_pm * v19)
        turns[37 * w + k] = factor2 * (c23_mp * T33 - s23_mp * v20)
        turns[38 * w + k] = factor2 * (c23_mm * T33 - s23_mm * v20)
        turns[39 * w + k] = -(c4_pp * v34 + Y4_p * (c23_pp * v36 + s23_pp * T32))
        turns[40 * w + k] = -(c4_pm * v34 + Y4_p * (c23_pm * v36 + s23_pm * T32))
        turns[41 * w + k] = v21 * (c23_mp * v37 + s23_mp * T32) - c4_mp * v35
        turns[42 * w + k] = v21 * (c23_mm * v37 + s23_mm * T32) - c4_mm * v35
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 19 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(19 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        T31, v1, v7 = kept[8 * w + k], kept[17 * w + k], kept[18 * w + k]
        c23_pp, c23_pm, s23_pp = kept[19 * w + k], kept[20 * w + k], kept[21 * w + k]
        s23_pm, c4_pp, c4_pm = kept[22 * w + k], kept[23 * w + k], kept[24 * w + k]
        Y4_p, v32, v33 = kept[25 * w + k], kept[26 * w + k], kept[27 * w + k]
        v38, v40, v42 = kept[28 * w + k], kept[29 * w + k], kept[30 * w + k]
        v43, angle1, angle2 = kept[31 * w + k], turns[0 * w + k], turns[1 * w + k]
        angle3, angle4, angle5 = turns[2 * w + k], turns[3 * w + k], turns[4 * w + k]
        angle6, angle7, angle8 = turns[5 * w + k], turns[6 * w + k], turns[7 * w + k]
        angle9, angle10, angle11 = turns[8 * w + k], turns[9 * w + k], turns[10 * w + k]
        angle12, angle13, angle14 = turns[11 * w + k], turns[12 * w + k], turns[13 * w + k]
        angle15, angle16, angle17 = turns[14 * w + k], turns[15 * w + k], turns[16 * w + k]
        angle18, angle19 = turns[17 * w + k], turns[18 * w + k]

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        q3__p, v12 = angle3 - turn1, turn1 + angle3

        # theta4, type 2: U4[3, 3]
        q4_ppm, q4_pmm, q4_mpm = angle8 - v32, angle9 - v32, angle10 - v33
        q4_mmm = angle11 - v33

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = (
            angle16 - math.copysign(half_turn, -(c4_pp * v38 + Y4_p * (c23_pp * v40 + s23_pp *
            T31)))
        )
        q6_pmm = (
            angle17 - math.copysign(half_turn, -(c4_pm * v38 + Y4_p * (c23_pm * v40 + s23_pm *
            T31)))
        )
        q6_mpm = angle18 - math.copysign(half_turn, v42)
        q6_mmm = angle19 - math.copysign(half_turn, v43)

        # joint values
        v44 = q3__p + (turn if q3__p <= -half_turn else 0.0)
        v45 = (turn if -v12 <= -half_turn else 0.0) - v12
        v46, v47, v48 = abs(angle1) - high1, abs(angle2) - high1, abs(v44) - high3
        v49, q1_ppp, q1_mpp = abs(v45) - high3, angle1 + v7, angle2 + v7
        q3_ppp, q3_pmp = v1 + v44, v1 + v45
        excess_pp = max(abs(angle12) - high5, max(abs(angle4) - high2, max(v46, v48)))
        excess_pm = max(abs(angle13) - high5, max(abs(angle5) - high2, max(v46, v49)))
        excess_mp = max(abs(angle14) - high5, max(abs(angle6) - high2, max(v47, v48)))
        excess_mm = max(abs(angle15) - high5, max(abs(angle7) - high2, max(v47, v49)))
        outside_ppp, outside_pmp, outside_mpp = 0.0 < excess_pp, 0.0 < excess_pm, 0.0 < excess_mp
        outside_mmp = 0.0 < excess_mm

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(excess_mm - limit_slack) <= limit_slack or abs(excess_mp - limit_slack) <=
            limit_slack or abs(excess_pp - limit_slack) <= limit_slack or abs(excess_pm -
            limit_slack) <= limit_slack else kept[16 * w + k]
        )

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, angle4, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle8, angle12, angle16
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, -angle12, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = angle5, q3_pmp, angle9
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = angle13, angle17, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = -angle13, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = angle6, angle10, angle14
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = angle18, q4_mpm, -angle14
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q6_mpm, angle7, angle11
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = angle15, angle19, q4_mmm
        rows[30 * w + k], rows[31 * w + k] = -angle15, q6_mmm
        rows[32 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_ppp else OK)
        )
        rows[33 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_ppp else OK)
        )
        rows[34 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_pmp else OK)
        )
        rows[35 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_pmp else OK)
        )
        rows[36 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mpp else OK)
        )
        rows[37 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mpp else OK)
        )
        rows[38 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mmp else OK)
        )
        rows[39 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mmp else OK)
        )


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 32, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 2, 19, 20, 21], [17, 18, 2, 22, 23, 24], [17, 25, 10, 26, 27, 28],
    [17, 25, 10, 29, 30, 31],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
