# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 1d5a53e83bedae87
"""abb_irb120: ABB IRB 120.

Inverse kinematics, generated from robots/abb_irb120.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/abb_irb120.yaml. The formulas and where they come from: abb_irb120.md.

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

NAME = "abb_irb120"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-2.87979, 2.87979), (-1.91986, 1.91986), (-1.91986, 1.22173), (-2.79253, 2.79253),
    (-2.094395, 2.094395), (-6.98132, 6.98132),
)
BRANCHES = (
    "back-down-noflip", "back-down-flip", "back-up-noflip", "back-up-flip", "front-up-noflip",
    "front-up-flip", "front-down-noflip", "front-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 0.00010040000000000001 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.29  # joint offset 1 [m]
a2 = 0.27  # link length 2 [m]
a3 = 0.07  # link length 3 [m]
d4 = 0.302  # joint offset 4 [m]
d6 = 0.072  # z of the tool frame [m]
free_limit1 = 1.0040000000000002e-12  # a length that fixes no angle [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
longest3 = 0.3364074838347159  # square of the longest reach [m^2]
shortest3 = 0.0016005161652840592  # square of the shortest reach [m^2]
longest3_reach = 0.3364074838348323  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0016005161652760261  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.3364074838347043  # the longest, where branches merge [m^2]
shortest3_apart = 0.0016005161652848626  # the shortest, where branches merge [m^2]
offset2 = 1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset5 = 3.141592653589793  # offset of joint 5 [rad]
k1 = 0.16308  # 2 * d4 * a2 [m^2]
k2 = 0.03780000000000001  # 2 * a3 * a2 [m^2]
k3 = 0.16900400000000002  # a2^2 + (a3^2 + d4^2) [m^2]
k4 = 35.683793403054324  # 1 / (k1^2 + k2^2) [m^-4]
turn1 = 1.3430303610541368  # atan2(k1, k2) [rad]
high1 = 2.879790001  # highest value of joint 1, with what rounding adds [rad]
high2 = 1.919860001  # highest value of joint 2, with what rounding adds [rad]
low3 = -1.919860001  # lowest value of joint 3, with what rounding adds [rad]
high3 = 1.221730001  # highest value of joint 3, with what rounding adds [rad]
high4 = 2.7925300010000003  # highest value of joint 4, with what rounding adds [rad]
high5 = 2.094395001  # highest value of joint 5, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 1.0080160000000003e-08  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 3.884373725055392e-12
m3 = 1.3488473906354537  # k2 * k4 [m^-2]
m4 = 0.9834871790128595  # k1 * k3 * k4
m5 = 5.819313028170099  # k1 * k4 [m^-2]
m6 = 0.22796060440695423  # k2 * k3 * k4
m7 = 1.8518518518518516  # k4 * (d4 * k1 + a3 * k2) [m^-1]
m8 = 0.04297037037037035  # d4 * k1 * k3 * k4 + a3 * k2 * k3 * k4 - a2 [m]
m9 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.996, 0.996, 0.996, 1.0, 1.0, 1.0), size=1.0040000000000002,
    steps=("keeps limits", "clamps", "clamps far", "range exceeds a turn", "follows seed"),
    choosable=(3, 0),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (3.141592653589793, 0.29, 0.0, 1.5707963267948966),
    (1.5707963267948966, 0.0, 0.27, 0.0),
    (0.0, 0.0, 0.07, -1.5707963267948966),
    (0.0, 0.302, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    tool=(0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.072),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, x2_y, v3 = c1 * c2, s1 * c2, c1 * s2
    v4 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v3 * s3, x2_y * c3 - v4 * s3, s2 * c3 + c2 * s3
    v5, v6, z3_z = v3 * c3 + x2_x * s3, v4 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - s1 * s4, x3_y * c4 + c1 * s4, x3_z * c4
    z4_x, z4_z, z4_y = s1 * c4 + x3_x * s4, x3_z * s4, x3_y * s4 - c1 * c4
    v7 = q[4] + offset5
    c5, s5 = math.cos(v7), math.sin(v7)
    x5_x, x5_y, x5_z = x4_x * c5 - v5 * s5, x4_y * c5 - v6 * s5, x4_z * c5 + z3_z * s5
    z5_x, z5_y, z5_z = v5 * c5 + x4_x * s5, v6 * c5 + x4_y * s5, x4_z * s5 - z3_z * c5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = z5_x, z4_x * c6 - x5_x * s6, -(x5_x * c6 + z4_x * s6)
    T[0, 3] = x2_x * a2 + x3_x * a3 - v5 * d4 + z5_x * d6
    T[1, 0], T[1, 1], T[1, 2] = z5_y, z4_y * c6 - x5_y * s6, -(x5_y * c6 + z4_y * s6)
    T[1, 3] = x2_y * a2 + x3_y * a3 - v6 * d4 + z5_y * d6
    T[2, 0], T[2, 1], T[2, 2] = z5_z, z4_z * c6 - x5_z * s6, -(x5_z * c6 + z4_z * s6)
    T[2, 3] = d1 + s2 * a2 + x3_z * a3 + z3_z * d4 + z5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, x2_y, v3 = c1 * c2, s1 * c2, c1 * s2
    v4, p2_x, p2_y = s1 * s2, x2_x * a2, x2_y * a2
    p2_z = d1 + s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v3 * s3, x2_y * c3 - v4 * s3, s2 * c3 + c2 * s3
    v5, v6, z3_z = v3 * c3 + x2_x * s3, v4 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    p3_x, p3_y, p3_z = p2_x + x3_x * a3, p2_y + x3_y * a3, p2_z + x3_z * a3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    z4_x, z4_z, p4_x = s1 * c4 + x3_x * s4, x3_z * s4, p3_x - v5 * d4
    p4_y, p4_z, z4_y = p3_y - v6 * d4, p3_z + z3_z * d4, x3_y * s4 - c1 * c4
    v7 = q[4] + offset5
    c5, s5 = math.cos(v7), math.sin(v7)
    z5_x, z5_y = v5 * c5 + (x3_x * c4 - s1 * s4) * s5, v6 * c5 + (x3_y * c4 + c1 * s4) * s5
    z5_z, J21, v8 = x3_z * c4 * s5 - z3_z * c5, p4_x + z5_x * d6, p4_y + z5_y * d6
    v9 = p4_z + z5_z * d6
    v10, v11, v12 = v9 - d1, v9 - p2_z, J21 - p3_x
    v13, v14, v15 = v8 - p3_y, v9 - p3_z, J21 - p4_x
    v16, v17 = v8 - p4_y, v9 - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -v8, -(c1 * v10), -(c1 * v11)
    J[0, 3], J[0, 4] = -(v6 * v14 + z3_z * v13), z4_y * v17 - z4_z * v16
    J[0, 5] = z5_y * v17 - z5_z * v16
    J[1, 0], J[1, 1], J[1, 2] = J21, -(s1 * v10), -(s1 * v11)
    J[1, 3], J[1, 4] = z3_z * v12 + v5 * v14, z4_z * v15 - z4_x * v17
    J[1, 5] = z5_z * v15 - z5_x * v17
    J[2, 1], J[2, 2] = s1 * v8 + c1 * J21, s1 * (v8 - p2_y) + c1 * (J21 - p2_x)
    J[2, 3], J[2, 4] = v6 * v12 - v5 * v13, z4_x * v16 - z4_y * v15
    J[2, 5] = z5_x * v16 - z5_y * v15
    J[3, 1], J[3, 2], J[3, 3] = s1, s1, -v5
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = -c1, -c1, -v6
    J[4, 4], J[4, 5] = z4_y, z5_y
    J[5, 0], J[5, 3], J[5, 4] = 1.0, z3_z, z4_z
    J[5, 5] = z5_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[3, 4]
    X1 = d6 * T11 - T14
    t24 = T24 - d6 * T21
    w1 = math.sqrt(X1 * X1 + t24 * t24)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1
    v1 = seed[0] + offset1

    # theta3, type 6: U1[2, 4] and U1[1, 4]
    t34 = T34 - d6 * T31
    Z1_3 = t34 - d1
    v2 = Z1_3 * Z1_3

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(v1) if free1 else -(X1 * factor1)
        s1 = math.sin(v1) if free1 else t24 * factor1
        D1 = w1 * e1

        # theta3
        N3 = v2 + D1 * D1
        K3 = N3 - k3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        v3, v4 = k1 * K3, k2 * K3

        # theta4, type 2: U4[3, 3]
        v5 = T11 * c1 + T21 * s1
        Y4 = T21 * c1 - T11 * s1
        v7 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v8, v9, v11 = T12 * s1 - T22 * c1, T12 * c1 + T22 * s1, T23 * c1 - T13 * s1
        v12 = T13 * c1 + T23 * s1

        # joint values
        q1 = _wrap(_atan2(s1, c1) - offset1)

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            D3 = w3 * e3
            s3, c3 = (k2 * D3 - v3) * k4, k4 * (v4 + k1 * D3)
            q3 = _atan2(s3, c3)

            # theta2, type 3: U1[2, 4] and U1[1, 4]
            X1_2 = a2 + (a3 * c3 - d4 * s3)
            Y1_2 = d4 * c3 + a3 * s3
            S2 = Z1_3 * X1_2 - D1 * Y1_2
            C2 = D1 * X1_2 + Z1_3 * Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            factor2 = 1.0 / w2
            c2, s2 = C2 * factor2, S2 * factor2

            # theta4
            c23, s23 = c3 * c2 - s3 * s2, c3 * s2 + s3 * c2
            v6 = c23 * v5 + T31 * s23
            w4 = math.sqrt(v6 * v6 + v7)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = s23 * v5 - T31 * c23

            # theta6
            v10, v13 = c23 * v9 + T32 * s23, c23 * v12 + T33 * s23

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(seed[3]) if free4 else v6 * factor4
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)
                s5 = w4 * e4

                # theta6
                c6, s6 = c4 * v8 + s4 * v10, c4 * v11 - s4 * v13
                q6 = _atan2(s6, c6)

                # joint values
                q5 = _wrap(_atan2(s5, c5) - offset5)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
                q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
                status[row] = FREE_JOINT if free1 or free4 else OK


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
        X1, t24 = d6 * T11 - T14, T24 - d6 * T21
        v1 = X1 * X1 + t24 * t24
        w1, v2 = math.sqrt(v1), 1.0 / v1

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        Z1_3 = T34 - d6 * T31 - d1
        N3 = v1 + Z1_3 * Z1_3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)
        v3, v4, v5 = w3 - w3, m4 - m5 * N3, m3 * w3
        s3_p, s3_m, v6 = v4 + v5, v4 - v5, m3 * N3 - m6
        v7 = m5 * w3
        c3_p, c3_m = v6 + v7, v6 - v7

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        X1_2 = m7 * N3 - m8
        v9, v10 = Z1_3 * X1_2, w3 * (m7 * w1)
        S2_pp, S2_pm, v11 = v9 - v10, v9 + v10, w3 * (m7 * Z1_3)
        v12, v13, v14 = w3 * (m7 * -Z1_3), w1 * X1_2, w1 * -X1_2
        C2_pp, C2_pm, C2_mp = v11 + v13, v12 + v13, v11 + v14
        C2_mm, factor2 = v12 + v14, 1.0 / N3

        # theta4, type 2: U4[3, 3]
        c23_pp, c23_pm = c3_p * C2_pp - s3_p * S2_pp, c3_m * C2_pm - s3_m * S2_pm
        c23_mp, c23_mm = c3_p * C2_mp - s3_p * S2_pm, c3_m * C2_mm - s3_m * S2_pp
        s23_pp, s23_pm = c3_p * S2_pp + s3_p * C2_pp, c3_m * S2_pm + s3_m * C2_pm
        s23_mp, s23_mm = c3_p * S2_pm + s3_p * C2_mp, c3_m * S2_pp + s3_m * C2_mm
        v15 = w1 * (v2 * (T21 * t24 - T11 * X1))
        c4_pp, c4_pm = T31 * s23_pp + c23_pp * v15, T31 * s23_pm + c23_pm * v15
        c4_mp, c4_mm = T31 * s23_mp - c23_mp * v15, T31 * s23_mm - c23_mm * v15
        v16 = w1 * (v2 * (T11 * t24 + X1 * T21))
        v17, v18, v19 = v16 * v16, factor2 * c4_pp, factor2 * c4_pm
        v20, v21, v22 = factor2 * c4_mp, factor2 * c4_mm, v17 + factor2 * (c4_pp * v18)
        v23, v24 = v17 + factor2 * (c4_pm * v19), v17 + factor2 * (c4_mp * v20)
        v25, v26 = v17 + factor2 * (c4_mm * v21), math.copysign(half_turn, -v16)
        v27 = math.copysign(half_turn, v16)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v28, v29 = w1 * (v2 * (X1 * T22 + t24 * T12)), w1 * (v2 * (t24 * T22 - X1 * T12))
        v30, v31 = w1 * (v2 * (X1 * T23 + t24 * T13)), w1 * (v2 * (t24 * T23 - X1 * T13))
        v32 = v16 * (s23_pp * T33 + c23_pp * v31) - c4_pp * v30
        v33 = v16 * (s23_pm * T33 + c23_pm * v31) - c4_pm * v30
        v34 = c4_mp * v30 - v16 * (s23_mp * T33 - c23_mp * v31)
        v35 = c4_mm * v30 - v16 * (s23_mm * T33 - c23_mm * v31)

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(D3_squared) <= m2 or v1 <= m1 or v25 <= m9 or v24 <= m9 or v22 <= m9 or v23
            <= m9 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = t24, v3, v26
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v27, v32, v33
        kept[23 * w + k], kept[24 * w + k], turns[0 * w + k] = v34, v35, w3
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = -v16, -v16, v16
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = v16, v32, v33
        turns[7 * w + k], turns[8 * w + k], turns[9 * w + k] = v34, v35, t24
        turns[10 * w + k], turns[11 * w + k], turns[12 * w + k] = S2_pp, S2_pm, S2_pm
        turns[13 * w + k], turns[14 * w + k] = S2_pp, math.sqrt(v22)
        turns[15 * w + k], turns[16 * w + k] = math.sqrt(v23), math.sqrt(v24)
        turns[17 * w + k], turns[24 * w + k], turns[25 * w + k] = math.sqrt(v25), N3 - k3, v18
        turns[26 * w + k], turns[27 * w + k], turns[28 * w + k] = v19, v20, v21
        turns[29 * w + k] = c4_pp * v28 - v16 * (s23_pp * T32 + c23_pp * v29)
        turns[30 * w + k] = c4_pm * v28 - v16 * (s23_pm * T32 + c23_pm * v29)
        turns[31 * w + k] = v16 * (s23_mp * T32 - c23_mp * v29) - c4_mp * v28
        turns[32 * w + k] = v16 * (s23_mm * T32 - c23_mm * v29) - c4_mm * v28
        turns[33 * w + k], turns[34 * w + k], turns[35 * w + k] = -X1, C2_pp, C2_pm
        turns[36 * w + k], turns[37 * w + k] = C2_mp, C2_mm
        turns[38 * w + k] = factor2 * (s23_pp * v15 - T31 * c23_pp)
        turns[39 * w + k] = factor2 * (s23_pm * v15 - T31 * c23_pm)
        turns[40 * w + k] = -(factor2 * (s23_mp * v15 + T31 * c23_mp))
        turns[41 * w + k] = -(factor2 * (s23_mm * v15 + T31 * c23_mm))
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 18 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(18 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        t24, v3, v26 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v27, v32, v33 = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v34, v35, angle1 = kept[23 * w + k], kept[24 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle8, angle9, angle10 = turns[7 * w + k], turns[8 * w + k], turns[9 * w + k]
        angle11, angle12, angle13 = turns[10 * w + k], turns[11 * w + k], turns[12 * w + k]
        angle14, angle15, angle16 = turns[13 * w + k], turns[14 * w + k], turns[15 * w + k]
        angle17, angle18 = turns[16 * w + k], turns[17 * w + k]

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        q3__p, v8 = angle1 - turn1, turn1 + angle1

        # theta4, type 2: U4[3, 3]
        q4_ppm, q4_pmm, q4_mpm = angle2 - v26, angle3 - v26, angle4 - v27
        q4_mmm = angle5 - v27

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle6 - math.copysign(half_turn, v32)
        q6_pmm = angle7 - math.copysign(half_turn, v33)
        q6_mpm = angle8 - math.copysign(half_turn, v34)
        q6_mmm = angle9 - math.copysign(half_turn, v35)

        # joint values
        v36, v37 = angle10 - offset1, angle10 - math.copysign(half_turn, t24) - offset1
        q1__p = v36 + (turn if v36 <= -half_turn else 0.0)
        q1__m = v37 + (turn if v37 <= -half_turn else 0.0)
        v38, v39, v40 = angle11 - offset2, angle12 - offset2, angle13 - offset2
        v41 = angle14 - offset2
        q2_ppp = v38 + (turn if v38 <= -half_turn else 0.0)
        q2_pmp = v39 + (turn if v39 <= -half_turn else 0.0)
        q2_mpp = v40 + (turn if v40 <= -half_turn else 0.0)
        q2_mmp = v41 + (turn if v41 <= -half_turn else 0.0)
        v42, v43, v44 = angle15 - offset5, offset5 + angle15, angle16 - offset5
        v45, v46, v47 = offset5 + angle16, angle17 - offset5, offset5 + angle17
        v48, v49 = angle18 - offset5, offset5 + angle18
        q5_ppp = v42 + (turn if v42 <= -half_turn else 0.0)
        q5_ppm = (turn if -v43 <= -half_turn else 0.0) - v43
        q5_pmp = v44 + (turn if v44 <= -half_turn else 0.0)
        q5_pmm = (turn if -v45 <= -half_turn else 0.0) - v45
        q5_mpp = v46 + (turn if v46 <= -half_turn else 0.0)
        q5_mpm = (turn if -v47 <= -half_turn else 0.0) - v47
        q5_mmp = v48 + (turn if v48 <= -half_turn else 0.0)
        q5_mmm = (turn if -v49 <= -half_turn else 0.0) - v49
        q3_ppp = q3__p + (turn if q3__p <= -half_turn else 0.0)
        q3_pmp = (turn if -v8 <= -half_turn else 0.0) - v8
        v50, v51, v52 = abs(q1__p) - high1, abs(q1__m) - high1, max(low3 - q3_ppp, q3_ppp - high3)
        v53, q1_ppp, q1_mpp = max(low3 - q3_pmp, q3_pmp - high3), v3 + q1__p, v3 + q1__m
        v54, v55 = max(abs(q2_ppp) - high2, max(v50, v52)), max(abs(q2_pmp) - high2, max(v50, v53))
        v56, v57 = max(abs(q2_mpp) - high2, max(v51, v52)), max(abs(q2_mmp) - high2, max(v51, v53))
        excess_ppp = max(abs(q5_ppp) - high5, max(v54, abs(angle2) - high4))
        excess_ppm = max(abs(q5_ppm) - high5, max(v54, abs(q4_ppm) - high4))
        excess_pmp = max(abs(q5_pmp) - high5, max(v55, abs(angle3) - high4))
        excess_pmm = max(abs(q5_pmm) - high5, max(v55, abs(q4_pmm) - high4))
        excess_mpp = max(abs(q5_mpp) - high5, max(v56, abs(angle4) - high4))
        excess_mpm = max(abs(q5_mpm) - high5, max(v56, abs(q4_mpm) - high4))
        excess_mmp = max(abs(q5_mmp) - high5, max(v57, abs(angle5) - high4))
        excess_mmm = max(abs(q5_mmm) - high5, max(v57, abs(q4_mmm) - high4))
        outside_ppp, outside_ppm, outside_pmp = 0.0 < excess_ppp, 0.0 < excess_ppm, 0.0 < excess_pmp
        outside_pmm, outside_mpp, outside_mpm = 0.0 < excess_pmm, 0.0 < excess_mpp, 0.0 < excess_mpm
        outside_mmp, outside_mmm = 0.0 < excess_mmp, 0.0 < excess_mmm

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(excess_mmm - limit_slack) <= limit_slack or abs(excess_mmp - limit_slack) <=
            limit_slack or abs(excess_mpm - limit_slack) <= limit_slack or abs(excess_mpp -
            limit_slack) <= limit_slack or abs(excess_pmm - limit_slack) <= limit_slack or
            abs(excess_pmp - limit_slack) <= limit_slack or abs(excess_ppp - limit_slack) <=
            limit_slack or abs(excess_ppm - limit_slack) <= limit_slack else kept[16 * w + k]
        )

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, q2_ppp, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle2, q5_ppp, angle6
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, q5_ppm, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q2_pmp, q3_pmp, angle3
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q5_pmp, angle7, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q5_pmm, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q2_mpp, angle4, q5_mpp
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = angle8, q4_mpm, q5_mpm
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q6_mpm, q2_mmp, angle5
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q5_mmp, angle9, q4_mmm
        rows[30 * w + k], rows[31 * w + k] = q5_mmm, q6_mmm
        rows[32 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_ppp else OK)
        )
        rows[33 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_ppm else OK)
        )
        rows[34 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_pmp else OK)
        )
        rows[35 * w + k] = (
            UNREACHABLE if q1_ppp != q1_ppp else (OUT_OF_LIMITS if outside_pmm else OK)
        )
        rows[36 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mpp else OK)
        )
        rows[37 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mpm else OK)
        )
        rows[38 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mmp else OK)
        )
        rows[39 * w + k] = (
            UNREACHABLE if q1_mpp != q1_mpp else (OUT_OF_LIMITS if outside_mmm else OK)
        )


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 25, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 2, 19, 20, 21], [17, 18, 2, 22, 23, 24], [17, 25, 10, 26, 27, 28],
    [17, 25, 10, 29, 30, 31],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
