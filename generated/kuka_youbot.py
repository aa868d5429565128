# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: fc15dcffa9b84be9
"""kuka_youbot: KUKA youBot arm.

Inverse kinematics, generated from robots/kuka_youbot.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kuka_youbot.yaml. The formulas and where they come from:
kuka_youbot.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 5), _runtime("arrays").zeros

NAME = "kuka_youbot"
METHOD = "closed form"
DOF = 5
JOINT_TYPES = "RRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = ("front-down", "front-up", "back-up", "back-down")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 6.874999999999999e-05 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.147  # joint offset 1 [m]
a1 = 0.033  # link length 1 [m]
a2 = 0.155  # link length 2 [m]
a3 = 0.135  # link length 3 [m]
d5 = 0.2175  # joint offset 5 [m]
second_weight = 0.6875  # lengths count in arm sizes [m]
free_limit1 = 6.874999999999999e-13  # a length that fixes no angle [m]
free_limit = 1e-12  # a length that fixes no angle
longest3 = 0.08410000000000002  # square of the longest reach [m^2]
shortest3 = 0.0003999999999999996  # square of the shortest reach [m^2]
longest3_reach = 0.08410000000003988  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.00039999999999724956  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.08409999999999603  # the longest, where branches merge [m^2]
shortest3_apart = 0.00040000000000027465  # the shortest, where branches merge [m^2]
offset2 = 1.5707963267948966  # offset of joint 2 [rad]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 6.875e-06  # a pose may be rounded by this [m]
offset4 = 1.5707963267948966  # offset of joint 4 [rad]
k1 = 0.04225  # a2^2 + a3^2 [m^2]
k2 = 23.894862604540023  # 1 / (2 * a3 * a2) [m^-2]
m1 = 4.726562499999999e-09  # doubt_limit1^2 [m^2]
m3 = 9.999999999999999e-09  # doubt_limit^2
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m4 = 3.345324017800363e-13
m5 = 3.2258064516129035  # a3 * k2 [m^-1]
m6 = 0.018709677419354823  # a2 - a3 * k1 * k2 [m]
m7 = 3.7037037037037037  # a2 * k2 [m^-1]
m8 = 0.021481481481481466  # k2 * (a2 * k1 + a3 * longest3 * shortest3 * k2 - a3 * k1^2 * k2) [m]
m9 = 1.0000000000000002e-10  # pose_slack^2
m10 = 4.7265625e-11  # pose_slack1^2 [m^2]
m11 = 1.41796875e-10  # 3 * pose_slack1^2 [m^2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="rotation",
    miss_weights=(1.455, 1.455, 1.455, 1.0, 1.0, 1.0), size=0.6875,
    steps=("retries", "follows seed"), choosable=(0,),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.147, 0.033, 1.5707963267948966),
    (1.5707963267948966, 0.0, 0.155, 0.0),
    (0.0, 0.0, 0.135, 0.0),
    (1.5707963267948966, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.2175, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (5,)."""
    T = _zeros(4, 4)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, v2 = c1 * c2, s1 * c2, c1 * s2
    v3 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v2 * s3, x2_y * c3 - v3 * s3, s2 * c3 + c2 * s3
    v4, v5, y3_z = v2 * c3 + x2_x * s3, v3 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    v6 = q[3] + offset4
    c4, s4 = math.cos(v6), math.sin(v6)
    x4_x, x4_y, x4_z = x3_x * c4 - v4 * s4, x3_y * c4 - v5 * s4, x3_z * c4 + y3_z * s4
    z4_x, z4_y, z4_z = v4 * c4 + x3_x * s4, v5 * c4 + x3_y * s4, x3_z * s4 - y3_z * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    T[0, 0], T[0, 1], T[0, 2] = x4_x * c5 + s1 * s5, s1 * c5 - x4_x * s5, z4_x
    T[0, 3] = c1 * a1 + x2_x * a2 + x3_x * a3 + z4_x * d5
    T[1, 0], T[1, 1], T[1, 2] = x4_y * c5 - c1 * s5, -(c1 * c5 + x4_y * s5), z4_y
    T[1, 3] = s1 * a1 + x2_y * a2 + x3_y * a3 + z4_y * d5
    T[2, 0], T[2, 1], T[2, 2] = x4_z * c5, -(x4_z * s5), z4_z
    T[2, 3] = d1 + s2 * a2 + x3_z * a3 + z4_z * d5
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 5): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 5)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y, v1 = c1 * a1, s1 * a1, q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, v2 = c1 * c2, s1 * c2, c1 * s2
    v3, p2_x, p2_y = s1 * s2, p1_x + x2_x * a2, p1_y + x2_y * a2
    p2_z = d1 + s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v2 * s3, x2_y * c3 - v3 * s3, s2 * c3 + c2 * s3
    p3_x, p3_y, p3_z = p2_x + x3_x * a3, p2_y + x3_y * a3, p2_z + x3_z * a3
    v4 = q[3] + offset4
    c4, s4 = math.cos(v4), math.sin(v4)
    z4_x, z4_y = (v2 * c3 + x2_x * s3) * c4 + x3_x * s4, (v3 * c3 + x2_y * s3) * c4 + x3_y * s4
    z4_z, p5_x, p5_y = x3_z * s4 - (c2 * c3 - s2 * s3) * c4, p3_x + z4_x * d5, p3_y + z4_y * d5
    p5_z = p3_z + z4_z * d5
    v5, v6, v7 = p5_z - d1, p5_z - p2_z, p5_x - p3_x
    v8, v9 = p5_y - p3_y, p5_z - p3_z
    J[0, 0], J[0, 1], J[0, 2] = -p5_y, -(c1 * v5), -(c1 * v6)
    J[0, 3], J[0, 4] = -(c1 * v9), z4_y * v9 - z4_z * v8
    J[1, 0], J[1, 1], J[1, 2] = p5_x, -(s1 * v5), -(s1 * v6)
    J[1, 3], J[1, 4] = -(s1 * v9), z4_z * v7 - z4_x * v9
    J[2, 1] = s1 * (p5_y - p1_y) + c1 * (p5_x - p1_x)
    J[2, 2], J[2, 3] = s1 * (p5_y - p2_y) + c1 * (p5_x - p2_x), s1 * v8 + c1 * v7
    J[2, 4] = z4_x * v8 - z4_y * v7
    J[3, 1], J[3, 2], J[3, 3] = s1, s1, s1
    J[3, 4] = z4_x
    J[4, 1], J[4, 2], J[4, 3] = -c1, -c1, -c1
    J[4, 4] = z4_y
    J[5, 0], J[5, 4] = 1.0, z4_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, _, T33, T34 = pose

    # theta1, type 2: U1[3, 4], so theta1 = atan2(T24, T14) or half a turn from it. Where both are
    # small, U1[3, 3] says more: its vector, along the same line, is added
    sigma1 = math.copysign(second_weight, T14 * T13 + T24 * T23)
    Xhat1 = T14 + T13 * sigma1
    Yhat1 = T24 + T23 * sigma1
    w1 = math.sqrt(Xhat1 * Xhat1 + Yhat1 * Yhat1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta234, type 3: U1[2, 3] and U1[1, 3]
    v1 = T33 * T33

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v7 = T34 - d1

    for i1 in range(2):  # front, back
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else Xhat1 * factor1
        s1 = math.sin(seed[0]) if free1 else Yhat1 * factor1
        q1 = _atan2(s1, c1)

        # theta234
        Z2_234 = T13 * c1 + T23 * s1
        w234 = math.sqrt(Z2_234 * Z2_234 + v1)
        short234 = w234 <= free_limit
        factor234 = 1.0 / (1.0 if short234 else w234)
        v2 = T33 * factor234
        s234 = Z2_234 * factor234
        theta234 = _atan2(s234, -v2)

        # theta5, type 3: U1[3, 2] and U1[3, 1]
        S5 = T21 * c1 - T11 * s1
        C5 = T22 * c1 - T12 * s1
        w5 = math.sqrt(S5 * S5 + C5 * C5)
        short5 = w5 <= free_limit
        v3 = 1.0 / (1.0 if short5 else w5)
        v4, v5 = C5 * v3, S5 * v3
        q5 = _atan2(-v5, -v4)

        # theta3
        v6 = v2 * d5
        Z1_3 = v7 - v6
        v8 = s234 * d5
        Z2_3 = T14 * c1 + T24 * s1 - a1 - v8
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
        K3 = N3 - k1
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            if free1:
                status[2 * i1] = _status.LOST + 1
                q[2 * i1, 0] = D3_squared
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        c3 = K3 * k2

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        X1_2 = a2 + a3 * c3
        v9, v10 = Z1_3 * X1_2, Z2_3 * X1_2

        # is the pose one that the arm can take?
        v11, v13 = a1 + v8, d1 + v6
        if (
            not (abs(T33 - v2) <= pose_slack and abs(T31 + s234 * v4) <= pose_slack and abs(T23 - s1
            * s234) <= pose_slack and abs(T21 - (v4 * (s1 * v2) + c1 * v5)) <= pose_slack and
            abs(T11 - (v4 * (c1 * v2) - s1 * v5)) <= pose_slack and abs(T13 - c1 * s234) <=
            pose_slack)
        ):
            continue  # the arm can't take this pose

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            s3 = w3 * e3 * k2
            q3 = _atan2(s3, c3)

            # theta2
            Y1_2 = a3 * s3
            S2 = v9 - Z2_3 * Y1_2
            C2 = v10 + Z1_3 * Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            factor2 = 1.0 / w2
            c2, s2 = C2 * factor2, S2 * factor2
            theta2 = _atan2(s2, c2)

            # is the pose one that the arm can take?
            c23, s23 = c3 * c2 - s3 * s2, c3 * s2 + s3 * c2
            v12 = a3 * c23 + (a2 * c2 + v11)
            if (
                not (abs(T34 - (a3 * s23 + (a2 * s2 + v13))) <= pose_slack1 and abs(T14 - c1 * v12)
                <= pose_slack1 and abs(T24 - s1 * v12) <= pose_slack1)
            ):
                continue  # the arm can't take this pose

            # joint values
            q2 = _wrap(theta2 - offset2)
            q4 = _wrap(theta234 - (q3 + theta2) - offset4)
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
            q[row, 3], q[row, 4] = q4, q5
            status[row] = FREE_JOINT if free1 else OK


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
        T33, T34 = kept[10 * w + k], kept[11 * w + k]

        # theta1, type 2: U1[3, 4], so theta1 = atan2(T24, T14) or half a turn from it. Where both
        # are small, U1[3, 3] says more: its vector, along the same line, is added
        sigma1 = math.copysign(second_weight, T14 * T13 + T24 * T23)
        Xhat1, Yhat1 = T14 + T13 * sigma1, T24 + T23 * sigma1
        v1 = Xhat1 * Xhat1 + Yhat1 * Yhat1
        w1, v2 = math.sqrt(v1), 1.0 / v1
        factor1 = w1 * v2
        c1, s1 = Xhat1 * factor1, Yhat1 * factor1

        # theta234, type 3: U1[2, 3] and U1[1, 3]
        Z2_234 = w1 * (v2 * (T13 * Xhat1 + T23 * Yhat1))
        v3 = T33 * T33 + Z2_234 * Z2_234
        w234, v4 = math.sqrt(v3), 1.0 / v3
        factor234 = w234 * v4

        # theta5, type 3: U1[3, 2] and U1[3, 1]
        S5, C5 = w1 * (v2 * (Xhat1 * T21 - Yhat1 * T11)), w1 * (v2 * (Xhat1 * T22 - Yhat1 * T12))
        v5 = S5 * S5 + C5 * C5
        v6 = math.sqrt(v5) * (1.0 / v5)
        v7, v8 = C5 * v6, S5 * v6

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        v9 = factor234 * (d5 * T33)
        Z1_3, v10, v11 = T34 - d1 - v9, d5 * Z2_234, T14 * c1 + T24 * s1
        v12, v13, v14 = v11 - a1, a1 + v11, factor234 * v10
        v15, v16, v17 = v12 - v14, v14 - v13, w234 * (v4 * v10)
        Z2_3_p, Z2_3_m, v18 = v12 - v17, v17 - v13, Z1_3 * Z1_3
        N3_p, N3_m = v18 + Z2_3_p * Z2_3_p, v18 + Z2_3_m * Z2_3_m
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3)
        D3_squared_m, w3_p = (longest3 - N3_m) * (N3_m - shortest3), math.sqrt(D3_squared_p)
        w3_m, v19 = math.sqrt(D3_squared_m), w3_p - w3_p
        v20 = w3_m - w3_m

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        v21, v22 = m6 + m5 * N3_p, m6 + m5 * N3_m
        v23, v24 = Z1_3 * v21, Z1_3 * v22
        S2_pp, S2_pm = v23 - w3_p * (m5 * v15), v23 - w3_p * (m5 * -v15)
        S2_mp, S2_mm, v25 = v24 - w3_m * (m5 * v16), v24 - w3_m * (m5 * -v16), m5 * Z1_3
        v26, v27, v28 = m5 * -Z1_3, v15 * v21, v16 * v22
        C2_pp, C2_pm, C2_mp = v27 + w3_p * v25, v27 + w3_p * v26, v28 + w3_m * v25
        C2_mm, v29 = v28 + w3_m * v26, S2_pp * S2_pp + C2_pp * C2_pp
        v30, v31 = S2_pm * S2_pm + C2_pm * C2_pm, S2_mp * S2_mp + C2_mp * C2_mp
        v32, w2_pp, w2_pm = S2_mm * S2_mm + C2_mm * C2_mm, math.sqrt(v29), math.sqrt(v30)
        w2_mp, w2_mm, v33 = math.sqrt(v31), math.sqrt(v32), 1.0 / v29
        v34, v35, v36 = 1.0 / v30, 1.0 / v31, 1.0 / v32
        factor2_pp, factor2_pm, factor2_mp = w2_pp * v33, w2_pm * v34, w2_mp * v35
        factor2_mm = w2_mm * v36

        # is the pose one that the arm can take?
        v37, v38, v39 = m7 * Z1_3, m7 * -Z1_3, m7 * N3_p - m8
        v40, v41 = m7 * N3_m - m8, v15 * v39
        v42, v43, v44 = v16 * v40, Z1_3 * v39, Z1_3 * v40
        v45, v46 = a1 + v14, a1 - v14
        v47 = v45 + w2_pp * (v33 * (a3 * (v41 - w3_p * v37) + a2 * C2_pp))
        v48 = v45 + w2_pm * (v34 * (a3 * (v41 - w3_p * v38) + a2 * C2_pm))
        v49 = v46 + w2_mp * (v35 * (a3 * (v42 - w3_m * v37) + a2 * C2_mp))
        v50, v51 = v46 + w2_mm * (v36 * (a3 * (v42 - w3_m * v38) + a2 * C2_mm)), d1 + v9
        v52, v53 = T33 - T33 * factor234, T31 + factor234 * (Z2_234 * v7)
        v54, v55 = T23 - factor234 * (s1 * Z2_234), T21 - (c1 * v8 + factor234 * (v7 * (s1 * T33)))
        v56, v57 = T11 - (factor234 * (v7 * (c1 * T33)) - s1 * v8), T13 - factor234 * (c1 * Z2_234)
        v58 = (
            T34 - (v51 + factor2_pp * (a2 * S2_pp) + factor2_pp * (a3 * (v43 + w3_p * (m7 * v15))))
        )
        v59 = (
            T34 - (v51 + factor2_pm * (a2 * S2_pm) + factor2_pm * (a3 * (v43 + w3_p * (m7 * -v15))))
        )
        v60 = (
            T34 - (v51 + factor2_mp * (a2 * S2_mp) + factor2_mp * (a3 * (v44 + w3_m * (m7 * v16))))
        )
        v61 = (
            T34 - (v51 + factor2_mm * (a2 * S2_mm) + factor2_mm * (a3 * (v44 + w3_m * (m7 * -v16))))
        )
        v62, v63, v64 = T14 - c1 * v47, T14 - c1 * v48, T14 + c1 * v49
        v65, v66, v67 = T14 + c1 * v50, T24 - s1 * v47, T24 - s1 * v48
        v68, v69, v70 = T24 + s1 * v49, T24 + s1 * v50, v58 * v58 + v62 * v62 + v66 * v66
        v71, v72 = v59 * v59 + v63 * v63 + v67 * v67, v60 * v60 + v64 * v64 + v68 * v68
        v73 = v61 * v61 + v65 * v65 + v69 * v69

        # joint values
        v86 = math.sqrt(-1.0)
        v87 = 0.0 if v70 <= m10 else v86
        v88 = 0.0 if v71 <= m10 else v86
        v89 = 0.0 if v72 <= m10 else v86
        v90 = 0.0 if v73 <= m10 else v86

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v3 <= m3 or v1 <= m1 or v5 <= m3 or m9 < v52 * v52 + v53 * v53 + v54 * v54 + v55
            * v55 + v56 * v56 + v57 * v57 or (m10 < v73 and v73 <= m11) or (m10 < v72 and v72 <=
            m11) or (m10 < v71 and v71 <= m11) or (m10 < v70 and v70 <= m11) or abs(D3_squared_p) <=
            m4 or abs(D3_squared_m) <= m4 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = Yhat1, S5, v19
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v20, v87, v88
        kept[23 * w + k], kept[24 * w + k], turns[0 * w + k] = v89, v90, Yhat1
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = Z2_234, -S5, w3_p
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = w3_m, S2_pp, S2_pm
        turns[7 * w + k], turns[8 * w + k], turns[16 * w + k] = S2_mp, S2_mm, Xhat1
        turns[17 * w + k], turns[18 * w + k], turns[19 * w + k] = -T33, -C5, N3_p - k1
        turns[20 * w + k], turns[21 * w + k], turns[22 * w + k] = N3_m - k1, C2_pp, C2_pm
        turns[23 * w + k], turns[24 * w + k] = C2_mp, C2_mm
    if w == 1 and kept[16] != 0.0:
        return
    end = 16 if w == 1 else 9 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(9 * w, end):
        turns[k] = turns[k + 16 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 16 * w])
    for k in range(w):
        Yhat1, S5, v19 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v20, v87, v88 = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v89, v90, angle1 = kept[23 * w + k], kept[24 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle8, angle9 = turns[7 * w + k], turns[8 * w + k]

        # joint values
        v74, v75, v76 = angle6 - offset2, angle7 - offset2, angle8 - offset2
        v77, v78 = angle9 - offset2, angle2 - (angle4 + angle6) - offset4
        v79, v80 = angle2 - (angle7 - angle4) - offset4, offset4 + (angle2 + (angle5 + angle8))
        v81 = offset4 + (angle2 + (angle9 - angle5))
        v82 = v78 + (turn if v78 <= -half_turn else (-turn if half_turn < v78 else 0.0))
        v83 = v79 + (turn if v79 <= -half_turn else (-turn if half_turn < v79 else 0.0))
        v84 = (turn if -v80 <= -half_turn else (-turn if half_turn < -v80 else 0.0)) - v80
        v85 = (turn if -v81 <= -half_turn else (-turn if half_turn < -v81 else 0.0)) - v81
        v91, v92 = angle1 + v19, v20 + (angle1 - math.copysign(half_turn, Yhat1))
        q1_pp, q1_pm, q1_mp = v87 + v91, v88 + v91, v89 + v92
        q1_mm = v90 + v92
        q2_pp = v87 + (v74 + (turn if v74 <= -half_turn else 0.0))
        q2_pm = v88 + (v75 + (turn if v75 <= -half_turn else 0.0))
        q2_mp = v89 + (v76 + (turn if v76 <= -half_turn else 0.0))
        q2_mm = v90 + (v77 + (turn if v77 <= -half_turn else 0.0))
        q3_pp, q3_pm, q3_mp = angle4 + v87, v88 - angle4, angle5 + v89
        q3_mm = v90 - angle5
        q4_pp = v87 + (v82 + (turn if v82 <= -half_turn else 0.0))
        q4_pm = v88 + (v83 + (turn if v83 <= -half_turn else 0.0))
        q4_mp = v89 + (v84 + (turn if v84 <= -half_turn else 0.0))
        q4_mm = v90 + (v85 + (turn if v85 <= -half_turn else 0.0))
        v93, v94 = angle3 + v19, v20 + (angle3 - math.copysign(half_turn, -S5))
        q5_pp, q5_pm, q5_mp = v87 + v93, v88 + v93, v89 + v94
        q5_mm = v90 + v94

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_pp, q2_pp, q3_pp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_pp, q5_pp, q1_pm
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q2_pm, q3_pm, q4_pm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q5_pm, q1_mp, q2_mp
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q3_mp, q4_mp, q5_mp
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q1_mm, q2_mm, q3_mm
        rows[18 * w + k], rows[19 * w + k] = q4_mm, q5_mm
        rows[20 * w + k] = UNREACHABLE if q1_pp != q1_pp else OK
        rows[21 * w + k] = UNREACHABLE if q1_pm != q1_pm else OK
        rows[22 * w + k] = UNREACHABLE if q1_mp != q1_mp else OK
        rows[23 * w + k] = UNREACHABLE if q1_mm != q1_mm else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 25, 32, [
    [0, 1, 2, 3, 4], [5, 6, 7, 8, 9], [10, 11, 12, 13, 14], [15, 16, 17, 18, 19],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
