# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 7e1be802377f3755
"""staubli_tx2_90: Stäubli TX2-90.

Inverse kinematics, generated from robots/staubli_tx2_90.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/staubli_tx2_90.yaml. The formulas and where they come from:
staubli_tx2_90.md.

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

NAME = "staubli_tx2_90"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-3.141592653589793, 3.141592653589793), (-2.2689280275926285, 2.5743606466916362),
    (-2.530727415391778, 2.530727415391778), (-4.71238898038469, 4.71238898038469),
    (-2.007128639793479, 2.443460952792061), (-4.71238898038469, 4.71238898038469),
)
BRANCHES = (
    "right-down-noflip", "right-down-flip", "right-up-noflip", "right-up-flip", "left-up-noflip",
    "left-up-flip", "left-down-noflip", "left-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, reach_slack1 = 1.5280000000000004e-13 [m],
# merge_slack1 = 1.5280000000000002e-14 [m], arm_size1 = 1.5280000000000002 [m],
# doubt_limit_squared2 = 2.3347840000000007e-08 [m^2], doubt_limit = 9.999999999999999e-05.
d1 = 0.478  # joint offset 1 [m]
a1 = 0.05  # link length 1 [m]
d2 = 0.05  # joint offset 2 [m]
a2 = 0.425  # link length 2 [m]
d4 = 0.425  # joint offset 4 [m]
d6 = 0.1  # z of the tool frame [m]
free_limit_squared2 = 2.3347840000000007e-24  # square of a length that fixes no angle [m^2]
least_root1 = 4.831960264737285e-07  # a root of nothing, by rounding [m]
longest3 = 0.7224999999999999  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
boundary3 = 1.8769985565831955e-13  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.7224999999999739  # the longest, where branches merge [m^2]
shortest3_apart = 2.334784000000001e-28  # the shortest, where branches merge [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset3 = 1.5707963267948966  # offset of joint 3 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
k1 = 0.0025000000000000005  # d2^2 [m^2]
k2 = 1.5280000000023352e-14  # reach_slack1 * (2 * d2 + reach_slack1) [m^2]
k3 = 1.5280000000002339e-15  # merge_slack1 * (2 * d2 + merge_slack1) [m^2]
k4 = 0.6544502617801046  # 1 / arm_size1 [m^-1]
k5 = 0.36124999999999996  # 2 * d4 * a2 [m^2]
k6 = 7.662743501634321  # 1 / (k5^2) [m^-4]
low2 = -2.2689280285926285  # lowest value of joint 2, with what rounding adds [rad]
high2 = 2.5743606476916363  # highest value of joint 2, with what rounding adds [rad]
high3 = 2.530727416391778  # highest value of joint 3, with what rounding adds [rad]
low5 = -2.007128640793479  # lowest value of joint 5, with what rounding adds [rad]
high5 = 2.4434609537920613  # highest value of joint 5, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 1.5280000000002338e-12  # 1000 * k3 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 1.876998556582453e-11
m3 = 0.2768166089965398  # 2 * a1 * k5 * k6 [m^-1]
m4 = 2.768166089965398  # k5 * k6 [m^-2]
m5 = 1.1764705882352942  # d4 * k5 * k6 [m^-1]
m6 = 5.451216326656003e-16  # doubt_limit_squared2^2 [m^4]
m7 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.6545, 0.6545, 0.6545, 1.0, 1.0, 1.0), size=1.5280000000000002,
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
    (0.0, 0.478, 0.05, -1.5707963267948966),
    (-1.5707963267948966, 0.05, 0.425, 0.0),
    (1.5707963267948966, 0.0, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.425, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    tool=(0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.1),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, v2 = c1 * c2, s1 * c2, c1 * s2
    v3, v4 = s1 * s2, q[2] + offset3
    c3, s3 = math.cos(v4), math.sin(v4)
    x3_x, x3_y, v5 = x2_x * c3 - v2 * s3, x2_y * c3 - v3 * s3, s2 * c3 + c2 * s3
    z3_x, z3_y, z3_z = v2 * c3 + x2_x * s3, v3 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    v6 = q[3] + offset4
    c4, s4 = math.cos(v6), math.sin(v6)
    x4_x, x4_y, v7 = x3_x * c4 - s1 * s4, x3_y * c4 + c1 * s4, v5 * c4
    z4_x, v8, z4_y = s1 * c4 + x3_x * s4, v5 * s4, x3_y * s4 - c1 * c4
    v9 = q[4] + offset5
    c5, s5 = math.cos(v9), math.sin(v9)
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, x4_y * c5 + z3_y * s5, z3_z * s5 - v7 * c5
    v10, z5_x, z5_y = z3_z * c5 + v7 * s5, x4_x * s5 - z3_x * c5, x4_y * s5 - z3_y * c5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = z5_x, z4_x * c6 - x5_x * s6, -(x5_x * c6 + z4_x * s6)
    T[0, 3] = c1 * a1 + x2_x * a2 - s1 * d2 + z3_x * d4 + z5_x * d6
    T[1, 0], T[1, 1], T[1, 2] = z5_y, z4_y * c6 - x5_y * s6, -(x5_y * c6 + z4_y * s6)
    T[1, 3] = s1 * a1 + x2_y * a2 + c1 * d2 + z3_y * d4 + z5_y * d6
    T[2, 0], T[2, 1], T[2, 2] = -v10, -(v8 * c6 + x5_z * s6), v8 * s6 - x5_z * c6
    T[2, 3] = d1 - s2 * a2 + z3_z * d4 - v10 * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y, v1 = c1 * a1, s1 * a1, q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, v2 = c1 * c2, s1 * c2, c1 * s2
    v3, p2_z, p2_x = s1 * s2, d1 - s2 * a2, p1_x + x2_x * a2 - s1 * d2
    p2_y, v4 = p1_y + x2_y * a2 + c1 * d2, q[2] + offset3
    c3, s3 = math.cos(v4), math.sin(v4)
    x3_x, x3_y, v5 = x2_x * c3 - v2 * s3, x2_y * c3 - v3 * s3, s2 * c3 + c2 * s3
    z3_x, z3_y, z3_z = v2 * c3 + x2_x * s3, v3 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    v6 = q[3] + offset4
    c4, s4 = math.cos(v6), math.sin(v6)
    z4_x, v7, p4_x = s1 * c4 + x3_x * s4, v5 * s4, p2_x + z3_x * d4
    p4_y, p4_z, z4_y = p2_y + z3_y * d4, p2_z + z3_z * d4, x3_y * s4 - c1 * c4
    v8 = q[4] + offset5
    c5, s5 = math.cos(v8), math.sin(v8)
    v9, z5_x = z3_z * c5 + v5 * c4 * s5, (x3_x * c4 - s1 * s4) * s5 - z3_x * c5
    z5_y, J21 = (x3_y * c4 + c1 * s4) * s5 - z3_y * c5, p4_x + z5_x * d6
    v10, v11 = p4_y + z5_y * d6, p4_z - v9 * d6
    v12, v13, v14 = v11 - d1, J21 - p2_x, v10 - p2_y
    v15, v16, v17 = v11 - p2_z, J21 - p4_x, v10 - p4_y
    v18 = v11 - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -v10, c1 * v12, c1 * v15
    J[0, 3], J[0, 4] = z3_y * v15 - z3_z * v14, z4_y * v18 + v7 * v17
    J[0, 5] = z5_y * v18 + v9 * v17
    J[1, 0], J[1, 1], J[1, 2] = J21, s1 * v12, s1 * v15
    J[1, 3], J[1, 4] = z3_z * v13 - z3_x * v15, -(v7 * v16 + z4_x * v18)
    J[1, 5] = -(v9 * v16 + z5_x * v18)
    J[2, 1], J[2, 2] = -(s1 * (v10 - p1_y) + c1 * (J21 - p1_x)), -(s1 * v14 + c1 * v13)
    J[2, 3], J[2, 4] = z3_x * v14 - z3_y * v13, z4_x * v17 - z4_y * v16
    J[2, 5] = z5_x * v17 - z5_y * v16
    J[3, 1], J[3, 2], J[3, 3] = -s1, -s1, z3_x
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = c1, c1, z3_y
    J[4, 4], J[4, 5] = z4_y, z5_y
    J[5, 0], J[5, 3], J[5, 4] = 1.0, z3_z, -v7
    J[5, 5] = -v9
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[3, 4]
    t14 = T14 - d6 * T11
    Y1 = d6 * T21 - T24
    N1 = t14 * t14 + Y1 * Y1
    D1_squared = N1 - k1
    apart1 = k3 < D1_squared
    if not (-k2 <= D1_squared):
        return  # out of reach
    w1 = math.sqrt(D1_squared if apart1 else 0.0)
    v1 = (w1 if apart1 else least_root1) * k4
    inverse1 = 1.0 / (N1 if apart1 else d2 * math.sqrt(N1))
    v2, v3 = t14 * d2, Y1 * d2

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    t34 = T34 - d6 * T31
    Z1_3 = t34 - d1
    v5 = Z1_3 * Z1_3

    # theta2, type 3: U1[1, 4] and U1[2, 4]
    v11 = seed[1] + offset2

    # theta4, type 2: U4[3, 3]
    v15 = seed[3] + offset4

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and not apart1:
            continue  # both signs give the same
        D1 = w1 * e1
        c1, s1 = -(inverse1 * (v3 + t14 * D1)), inverse1 * (Y1 * D1 - v2)
        q1 = _atan2(s1, c1)

        # theta3
        v4 = D1 + a1
        N3 = v5 + v4 * v4
        K3 = N3 - k5
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= v1 * D3_squared):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        s3 = k5 * K3 * k6

        # theta2
        Y1_2 = a2 + d4 * s3
        v8, v9 = Z1_3 * Y1_2, v4 * Y1_2

        # theta4
        v13 = T11 * c1 + T21 * s1
        Y4 = T21 * c1 - T11 * s1
        v14 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v16, v17, v19 = T12 * s1 - T22 * c1, T12 * c1 + T22 * s1, T23 * c1 - T13 * s1
        v20 = T13 * c1 + T23 * s1

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            v6 = k6 * (k5 * (w3 * e3))

            # theta2
            v7 = d4 * v6
            S2 = v4 * v7 - v8
            v10 = Z1_3 * v7 + v9
            w2 = math.sqrt(S2 * S2 + v10 * v10)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v11) if free2 else -(v10 * factor2)
            s2 = math.sin(v11) if free2 else S2 * factor2

            # theta4
            v12 = v6 * c2 + s3 * s2
            s23 = s3 * c2 - v6 * s2
            X4 = v12 * v13 + T31 * s23
            w4 = math.sqrt(X4 * X4 + v14)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T31 * v12 - s23 * v13

            # theta6
            v18, v21 = v12 * v17 + T32 * s23, v12 * v20 + T33 * s23

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(s3, -v6) - offset3)

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(v15) if free4 else -(X4 * factor4)
                s4 = math.sin(v15) if free4 else Y4 * factor4
                s5 = w4 * e4

                # theta6
                c6, s6 = c4 * v16 - s4 * v18, c4 * v19 + s4 * v21
                q6 = _atan2(s6, c6)

                # joint values
                q4 = _wrap(_atan2(s4, c4) - offset4)
                q5 = _wrap(_atan2(s5, c5) - offset5)
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
        t14, Y1 = T14 - d6 * T11, d6 * T21 - T24
        N1 = t14 * t14 + Y1 * Y1
        D1_squared = N1 - k1
        w1 = math.sqrt(D1_squared)
        v1, inverse1 = k4 * w1, 1.0 / N1
        v2 = inverse1 * (d2 * Y1)
        v3, v4, v5 = v2 + w1 * (t14 * inverse1), v2 + w1 * (inverse1 * -t14), inverse1 * (d2 * t14)
        s1_p, s1_m = w1 * (Y1 * inverse1) - v5, w1 * (inverse1 * -Y1) - v5

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        Z1_3, v6, v7 = T34 - d6 * T31 - d1, a1 + w1, a1 - w1
        v8 = Z1_3 * Z1_3
        N3_p, N3_m = v8 + v6 * v6, v8 + v7 * v7
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3)
        D3_squared_m, w3_p = (longest3 - N3_m) * (N3_m - shortest3), math.sqrt(D3_squared_p)
        w3_m, v9, v10 = math.sqrt(D3_squared_m), m4 * v8 + (m4 * N1 - 1.0), m3 * w1
        s3_p, s3_m, v11 = v9 + v10, v9 - v10, k6 * (k5 * w3_p)
        v12 = k6 * (k5 * w3_m)

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        Y1_2_p, Y1_2_m = a2 + d4 * s3_p, a2 + d4 * s3_m
        v13, v14, v15 = Z1_3 * Y1_2_p, Z1_3 * Y1_2_m, w3_p * (m5 * v6)
        S2_pp, v16, S2_mp = v15 - v13, v13 + v15, w3_m * (m5 * v7) - v14
        S2_mm, v17, v18 = w3_m * (m5 * -v7) - v14, v6 * Y1_2_p, v7 * Y1_2_m
        v19, v20 = m5 * Z1_3, m5 * -Z1_3
        v21, v22, v23 = v17 + w3_p * v19, v17 + w3_p * v20, v18 + w3_m * v19
        v24, v25, v26 = v18 + w3_m * v20, S2_pp * S2_pp + v21 * v21, v16 * v16 + v22 * v22
        v27, v28 = S2_mp * S2_mp + v23 * v23, S2_mm * S2_mm + v24 * v24
        factor2_pp, factor2_pm = math.sqrt(v25) * (1.0 / v25), math.sqrt(v26) * (1.0 / v26)
        factor2_mp, factor2_mm = math.sqrt(v27) * (1.0 / v27), math.sqrt(v28) * (1.0 / v28)

        # theta4, type 2: U4[3, 3]
        v29, v30, v31 = s3_p * S2_pp - v11 * v21, v11 * v22 - s3_p * v16, s3_m * S2_mp - v12 * v23
        v32, v33, v34 = s3_m * S2_mm + v12 * v24, s3_p * v21 + v11 * S2_pp, s3_p * v22 + v11 * v16
        v35, v36, v37 = s3_m * v23 + v12 * S2_mp, s3_m * v24 - v12 * S2_mm, T21 * s1_p - T11 * v3
        v38, X4_pp, X4_pm = T21 * s1_m - T11 * v4, v29 * v37 - T31 * v33, v30 * v37 - T31 * v34
        X4_mp, X4_mm, v39 = v31 * v38 - T31 * v35, v32 * v38 - T31 * v36, T21 * v3 + T11 * s1_p
        v40, v41 = T21 * v4 + T11 * s1_m, v39 * v39
        v42, v43 = v40 * v40, v41 + factor2_pp * (X4_pp * (factor2_pp * X4_pp))
        v44 = v41 + factor2_pm * (X4_pm * (factor2_pm * X4_pm))
        v45 = v42 + factor2_mp * (X4_mp * (factor2_mp * X4_mp))
        v46 = v42 + factor2_mm * (X4_mm * (factor2_mm * X4_mm))

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v47, v48, v49 = s1_p * T12 + v3 * T22, s1_m * T12 + v4 * T22, s1_p * T22 - v3 * T12
        v50, v51, v52 = s1_m * T22 - v4 * T12, v3 * T23 + s1_p * T13, v4 * T23 + s1_m * T13
        v53, v54 = s1_p * T23 - v3 * T13, s1_m * T23 - v4 * T13

        # joint values
        v63, v64 = math.copysign(half_turn, -v39), math.copysign(half_turn, -v40)

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if v46 <= m7 or v28 <= m6 or v45 <= m7 or v27 <= m6 or v44 <= m7 or v26 <= m6 or v43
            <= m7 or v25 <= m6 or abs(v1 * D3_squared_m) <= m2 or abs(D1_squared) <= m1 or abs(v1 *
            D3_squared_p) <= m2 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = w3_p, w3_m, s3_p
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = s3_m, v29, v30
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = v31, v32, v33
        kept[26 * w + k], kept[27 * w + k], kept[28 * w + k] = v34, v35, v36
        kept[29 * w + k], kept[30 * w + k], kept[31 * w + k] = X4_pp, X4_pm, X4_mp
        kept[32 * w + k], kept[33 * w + k], kept[34 * w + k] = X4_mm, v39, v40
        kept[35 * w + k], kept[36 * w + k], kept[37 * w + k] = v51, v52, v53
        kept[38 * w + k], kept[39 * w + k], kept[40 * w + k] = v54, v63, v64
        turns[0 * w + k] = -(v51 * -X4_pp + v39 * (v29 * v53 - v33 * T33))
        turns[1 * w + k] = -(v51 * -X4_pm + v39 * (v30 * v53 - v34 * T33))
        turns[2 * w + k] = -(v52 * -X4_mp + v40 * (v31 * v54 - v35 * T33))
        turns[3 * w + k], turns[4 * w + k] = -(v52 * -X4_mm + v40 * (v32 * v54 - v36 * T33)), S2_pp
        turns[5 * w + k], turns[6 * w + k], turns[7 * w + k] = -v16, S2_mp, S2_mm
        turns[8 * w + k], turns[9 * w + k], turns[10 * w + k] = s3_p, s3_m, -v39
        turns[11 * w + k], turns[12 * w + k], turns[13 * w + k] = -v39, -v40, -v40
        turns[14 * w + k], turns[15 * w + k] = math.sqrt(v43), math.sqrt(v44)
        turns[16 * w + k], turns[17 * w + k] = math.sqrt(v45), math.sqrt(v46)
        turns[18 * w + k], turns[19 * w + k] = s1_p, s1_m
        turns[24 * w + k] = v47 * -X4_pp + v39 * (v29 * v49 - v33 * T32)
        turns[25 * w + k] = v47 * -X4_pm + v39 * (v30 * v49 - v34 * T32)
        turns[26 * w + k] = v48 * -X4_mp + v40 * (v31 * v50 - v35 * T32)
        turns[27 * w + k], turns[28 * w + k] = v48 * -X4_mm + v40 * (v32 * v50 - v36 * T32), -v21
        turns[29 * w + k], turns[30 * w + k], turns[31 * w + k] = -v22, -v23, -v24
        turns[32 * w + k], turns[33 * w + k], turns[34 * w + k] = -v11, -v12, factor2_pp * -X4_pp
        turns[35 * w + k], turns[36 * w + k] = factor2_pm * -X4_pm, factor2_mp * -X4_mp
        turns[37 * w + k] = factor2_mm * -X4_mm
        turns[38 * w + k] = factor2_pp * (T31 * v29 + v33 * v37)
        turns[39 * w + k] = factor2_pm * (T31 * v30 + v34 * v37)
        turns[40 * w + k] = factor2_mp * (T31 * v31 + v35 * v38)
        turns[41 * w + k], turns[42 * w + k] = factor2_mm * (T31 * v32 + v36 * v38), -v3
        turns[43 * w + k] = -v4
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 20 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(20 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        T33, w3_p, w3_m = kept[10 * w + k], kept[17 * w + k], kept[18 * w + k]
        s3_p, s3_m, v29 = kept[19 * w + k], kept[20 * w + k], kept[21 * w + k]
        v30, v31, v32 = kept[22 * w + k], kept[23 * w + k], kept[24 * w + k]
        v33, v34, v35 = kept[25 * w + k], kept[26 * w + k], kept[27 * w + k]
        v36, X4_pp, X4_pm = kept[28 * w + k], kept[29 * w + k], kept[30 * w + k]
        X4_mp, X4_mm, v39 = kept[31 * w + k], kept[32 * w + k], kept[33 * w + k]
        v40, v51, v52 = kept[34 * w + k], kept[35 * w + k], kept[36 * w + k]
        v53, v54, v63 = kept[37 * w + k], kept[38 * w + k], kept[39 * w + k]
        v64, angle1, angle2 = kept[40 * w + k], turns[0 * w + k], turns[1 * w + k]
        angle3, angle4, angle5 = turns[2 * w + k], turns[3 * w + k], turns[4 * w + k]
        angle6, angle7, angle8 = turns[5 * w + k], turns[6 * w + k], turns[7 * w + k]
        angle9, angle10, angle11 = turns[8 * w + k], turns[9 * w + k], turns[10 * w + k]
        angle12, angle13, angle14 = turns[11 * w + k], turns[12 * w + k], turns[13 * w + k]
        angle15, angle16, angle17 = turns[14 * w + k], turns[15 * w + k], turns[16 * w + k]
        angle18, angle19, angle20 = turns[17 * w + k], turns[18 * w + k], turns[19 * w + k]

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle1 - math.copysign(half_turn, -(v51 * -X4_pp + v39 * (v29 * v53 - v33 * T33)))
        q6_pmm = angle2 - math.copysign(half_turn, -(v51 * -X4_pm + v39 * (v30 * v53 - v34 * T33)))
        q6_mpm = angle3 - math.copysign(half_turn, -(v52 * -X4_mp + v40 * (v31 * v54 - v35 * T33)))
        q6_mmm = angle4 - math.copysign(half_turn, -(v52 * -X4_mm + v40 * (v32 * v54 - v36 * T33)))

        # joint values
        v55, v56, v57 = angle5 - offset2, angle6 - offset2, angle7 - offset2
        v58 = angle8 - offset2
        q2_ppp = v55 + (-turn if half_turn < v55 else 0.0)
        q2_pmp = v56 + (-turn if half_turn < v56 else 0.0)
        q2_mpp = v57 + (-turn if half_turn < v57 else 0.0)
        q2_mmp = v58 + (-turn if half_turn < v58 else 0.0)
        v59, v60 = angle9 - offset3, math.copysign(half_turn, s3_p) - angle9 - offset3
        v61, v62 = angle10 - offset3, math.copysign(half_turn, s3_m) - angle10 - offset3
        q3_ppp = v59 + (turn if v59 <= -half_turn else 0.0)
        q3_pmp = v60 + (turn if v60 <= -half_turn else 0.0)
        q3_mpp = v61 + (turn if v61 <= -half_turn else 0.0)
        q3_mmp = v62 + (turn if v62 <= -half_turn else 0.0)
        v65, v66, v67 = angle11 - offset4, angle11 - v63 - offset4, angle12 - offset4
        v68, v69, v70 = angle12 - v63 - offset4, angle13 - offset4, angle13 - v64 - offset4
        v71, v72 = angle14 - offset4, angle14 - v64 - offset4
        q4_ppp = v65 + (turn if v65 <= -half_turn else 0.0)
        q4_ppm = v66 + (turn if v66 <= -half_turn else 0.0)
        q4_pmp = v67 + (turn if v67 <= -half_turn else 0.0)
        q4_pmm = v68 + (turn if v68 <= -half_turn else 0.0)
        q4_mpp = v69 + (turn if v69 <= -half_turn else 0.0)
        q4_mpm = v70 + (turn if v70 <= -half_turn else 0.0)
        q4_mmp = v71 + (turn if v71 <= -half_turn else 0.0)
        q4_mmm = v72 + (turn if v72 <= -half_turn else 0.0)
        v73, v74, v75 = angle15 - offset5, offset5 + angle15, angle16 - offset5
        v76, v77, v78 = offset5 + angle16, angle17 - offset5, offset5 + angle17
        v79, v80 = angle18 - offset5, offset5 + angle18
        q5_ppp = v73 + (turn if v73 <= -half_turn else 0.0)
        q5_ppm = (turn if -v74 <= -half_turn else 0.0) - v74
        q5_pmp = v75 + (turn if v75 <= -half_turn else 0.0)
        q5_pmm = (turn if -v76 <= -half_turn else 0.0) - v76
        q5_mpp = v77 + (turn if v77 <= -half_turn else 0.0)
        q5_mpm = (turn if -v78 <= -half_turn else 0.0) - v78
        q5_mmp = v79 + (turn if v79 <= -half_turn else 0.0)
        q5_mmm = (turn if -v80 <= -half_turn else 0.0) - v80
        q1_ppp, q1_mpp = angle19 + (w3_p - w3_p), angle20 + (w3_m - w3_m)
        v81 = max(max(low2 - q2_ppp, q2_ppp - high2), abs(q3_ppp) - high3)
        v82 = max(max(low2 - q2_pmp, q2_pmp - high2), abs(q3_pmp) - high3)
        v83 = max(max(low2 - q2_mpp, q2_mpp - high2), abs(q3_mpp) - high3)
        v84 = max(max(low2 - q2_mmp, q2_mmp - high2), abs(q3_mmp) - high3)
        excess_ppp = max(v81, max(low5 - q5_ppp, q5_ppp - high5))
        excess_ppm = max(v81, max(low5 - q5_ppm, q5_ppm - high5))
        excess_pmp = max(v82, max(low5 - q5_pmp, q5_pmp - high5))
        excess_pmm = max(v82, max(low5 - q5_pmm, q5_pmm - high5))
        excess_mpp = max(v83, max(low5 - q5_mpp, q5_mpp - high5))
        excess_mpm = max(v83, max(low5 - q5_mpm, q5_mpm - high5))
        excess_mmp = max(v84, max(low5 - q5_mmp, q5_mmp - high5))
        excess_mmm, outside_ppp = max(v84, max(low5 - q5_mmm, q5_mmm - high5)), 0.0 < excess_ppp
        outside_ppm, outside_pmp, outside_pmm = 0.0 < excess_ppm, 0.0 < excess_pmp, 0.0 < excess_pmm
        outside_mpp, outside_mpm, outside_mmp = 0.0 < excess_mpp, 0.0 < excess_mpm, 0.0 < excess_mmp
        outside_mmm = 0.0 < excess_mmm

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(excess_mmm - limit_slack) <= limit_slack or abs(excess_mmp - limit_slack) <=
            limit_slack or abs(excess_mpm - limit_slack) <= limit_slack or abs(excess_mpp -
            limit_slack) <= limit_slack or abs(excess_pmm - limit_slack) <= limit_slack or
            abs(excess_pmp - limit_slack) <= limit_slack or abs(excess_ppp - limit_slack) <=
            limit_slack or abs(excess_ppm - limit_slack) <= limit_slack else kept[16 * w + k]
        )

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, q2_ppp, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_ppp, q5_ppp, angle1
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, q5_ppm, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q2_pmp, q3_pmp, q4_pmp
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q5_pmp, angle2, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q5_pmm, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q2_mpp, q3_mpp, q4_mpp
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = q5_mpp, angle3, q4_mpm
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q5_mpm, q6_mpm, q2_mmp
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q3_mmp, q4_mmp, q5_mmp
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = angle4, q4_mmm, q5_mmm
        rows[33 * w + k] = q6_mmm
        rows[34 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_ppp else OK)
        )
        rows[35 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_ppm else OK)
        )
        rows[36 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_pmp else OK)
        )
        rows[37 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_pmm else OK)
        )
        rows[38 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mpp else OK)
        )
        rows[39 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mpm else OK)
        )
        rows[40 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mmp else OK)
        )
        rows[41 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mmm else OK)
        )


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 41, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 19, 20, 21, 22], [17, 18, 19, 23, 24, 25], [17, 26, 27, 28, 29, 30],
    [17, 26, 27, 31, 32, 33],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
