# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 1b08c7fc3b36b795
"""katana_400: Neuronics Katana 400.

Inverse kinematics, generated from robots/katana_400.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/katana_400.yaml. The formulas and where they come from: katana_400.md.

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

NAME = "katana_400"
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

# In formulas below, doubt_limit1 = 6.777999999999999e-05 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.2015  # joint offset 1 [m]
a2 = 0.19  # link length 2 [m]
a3 = 0.139  # link length 3 [m]
d5 = 0.1473  # joint offset 5 [m]
second_weight = 0.6778  # lengths count in arm sizes [m]
free_limit1 = 6.777999999999999e-13  # a length that fixes no angle [m]
free_limit = 1e-12  # a length that fixes no angle
longest3 = 0.108241  # square of the longest reach [m^2]
shortest3 = 0.002600999999999999  # square of the shortest reach [m^2]
longest3_reach = 0.10824100000004461  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0026009999999930854  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.10824099999999555  # the longest, where branches merge [m^2]
shortest3_apart = 0.0026010000000006904  # the shortest, where branches merge [m^2]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 6.778e-06  # a pose may be rounded by this [m]
offset4 = -1.5707963267948966  # offset of joint 4 [rad]
k1 = 0.055421000000000005  # a2^2 + a3^2 [m^2]
k2 = 18.932222642938278  # 1 / (2 * a3 * a2) [m^-2]
m1 = 4.594128399999999e-09  # doubt_limit1^2 [m^2]
m3 = 9.999999999999999e-09  # doubt_limit^2
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m4 = 4.706018907896038e-13
m5 = 2.631578947368421  # a3 * k2 [m^-1]
m6 = 0.04415526315789473  # a2 - a3 * k1 * k2 [m]
m7 = 0.19  # a2 [m]
m8 = 0.139  # a3 [m]
m9 = 1.0000000000000002e-10  # pose_slack^2
m10 = 4.5941284e-11  # pose_slack1^2 [m^2]
m11 = 1.37823852e-10  # 3 * pose_slack1^2 [m^2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="rotation",
    miss_weights=(1.475, 1.475, 1.475, 1.0, 1.0, 1.0), size=0.6778,
    steps=("retries", "follows seed"), choosable=(0,),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.2015, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.19, 0.0),
    (0.0, 0.0, 0.139, 0.0),
    (-1.5707963267948966, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.1473, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (5,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v3, v4, y3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    v5 = q[3] + offset4
    c4, s4 = math.cos(v5), math.sin(v5)
    x4_x, x4_y, x4_z = x3_x * c4 - v3 * s4, x3_y * c4 - v4 * s4, x3_z * c4 + y3_z * s4
    v6, v7, z4_z = v3 * c4 + x3_x * s4, v4 * c4 + x3_y * s4, y3_z * c4 - x3_z * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    T[0, 0], T[0, 1], T[0, 2] = x4_x * c5 - s1 * s5, -(s1 * c5 + x4_x * s5), -v6
    T[0, 3] = x2_x * a2 + x3_x * a3 - v6 * d5
    T[1, 0], T[1, 1], T[1, 2] = x4_y * c5 + c1 * s5, c1 * c5 - x4_y * s5, -v7
    T[1, 3] = x2_y * a2 + x3_y * a3 - v7 * d5
    T[2, 0], T[2, 1], T[2, 2] = x4_z * c5, -(x4_z * s5), z4_z
    T[2, 3] = d1 + s2 * a2 + x3_z * a3 + z4_z * d5
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 5): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 5)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2, p2_x, p2_y = s1 * s2, x2_x * a2, x2_y * a2
    p2_z = d1 + s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    p3_x, p3_y, p3_z = p2_x + x3_x * a3, p2_y + x3_y * a3, p2_z + x3_z * a3
    v3 = q[3] + offset4
    c4, s4 = math.cos(v3), math.sin(v3)
    v4, v5 = (v1 * c3 + x2_x * s3) * c4 + x3_x * s4, (v2 * c3 + x2_y * s3) * c4 + x3_y * s4
    z4_z, p5_x, p5_y = (c2 * c3 - s2 * s3) * c4 - x3_z * s4, p3_x - v4 * d5, p3_y - v5 * d5
    p5_z = p3_z + z4_z * d5
    v6, v7, v8 = p5_z - d1, p5_z - p2_z, p5_x - p3_x
    v9, v10 = p5_y - p3_y, p5_z - p3_z
    J[0, 0], J[0, 1], J[0, 2] = -p5_y, -(c1 * v6), -(c1 * v7)
    J[0, 3], J[0, 4] = -(c1 * v10), -(v5 * v10 + z4_z * v9)
    J[1, 0], J[1, 1], J[1, 2] = p5_x, -(s1 * v6), -(s1 * v7)
    J[1, 3], J[1, 4] = -(s1 * v10), z4_z * v8 + v4 * v10
    J[2, 1], J[2, 2] = s1 * p5_y + c1 * p5_x, s1 * (p5_y - p2_y) + c1 * (p5_x - p2_x)
    J[2, 3], J[2, 4] = s1 * v9 + c1 * v8, v5 * v8 - v4 * v9
    J[3, 1], J[3, 2], J[3, 3] = s1, s1, s1
    J[3, 4] = -v4
    J[4, 1], J[4, 2], J[4, 3] = -c1, -c1, -c1
    J[4, 4] = -v5
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
        c234, v2 = T33 * factor234, Z2_234 * factor234
        theta234 = _atan2(-v2, c234)

        # theta5, type 3: U1[3, 2] and U1[3, 1]
        Z1_5 = T12 * s1 - T22 * c1
        Z2_5 = T11 * s1 - T21 * c1
        w5 = math.sqrt(Z2_5 * Z2_5 + Z1_5 * Z1_5)
        short5 = w5 <= free_limit
        v3 = 1.0 / (1.0 if short5 else w5)
        v4, v5 = Z1_5 * v3, Z2_5 * v3
        q5 = _atan2(-v5, -v4)

        # theta3
        v6 = c234 * d5
        Z1_3 = v7 - v6
        v8 = v2 * d5
        Z2_3 = T14 * c1 + T24 * s1 - v8
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
        v12 = d1 + v6
        if (
            not (abs(T33 - c234) <= pose_slack and abs(T31 - v2 * v4) <= pose_slack and abs(T23 - s1
            * v2) <= pose_slack and abs(T21 + (v4 * (s1 * c234) + c1 * v5)) <= pose_slack and
            abs(T11 - (s1 * v5 - v4 * (c1 * c234))) <= pose_slack and abs(T13 - c1 * v2) <=
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
            q2 = _atan2(s2, c2)

            # is the pose one that the arm can take?
            c23, s23 = c3 * c2 - s3 * s2, c3 * s2 + s3 * c2
            v11 = a3 * c23 + (v8 + a2 * c2)
            if (
                not (abs(T34 - (a3 * s23 + (a2 * s2 + v12))) <= pose_slack1 and abs(T14 - c1 * v11)
                <= pose_slack1 and abs(T24 - s1 * v11) <= pose_slack1)
            ):
                continue  # the arm can't take this pose

            # joint values
            q4 = _wrap(theta234 - (q3 + q2) - offset4)
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
        factor234 = math.sqrt(v3) * (1.0 / v3)

        # theta5, type 3: U1[3, 2] and U1[3, 1]
        Z1_5 = w1 * (v2 * (Yhat1 * T12 - Xhat1 * T22))
        Z2_5 = w1 * (v2 * (Yhat1 * T11 - Xhat1 * T21))
        v4 = Z2_5 * Z2_5 + Z1_5 * Z1_5
        v5 = math.sqrt(v4) * (1.0 / v4)
        v6, v7 = Z1_5 * v5, Z2_5 * v5

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        v8 = factor234 * (d5 * T33)
        Z1_3, v9 = T34 - d1 - v8, factor234 * (d5 * Z2_234)
        Z2_3 = T14 * c1 + T24 * s1 - v9
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
        K3, D3_squared = N3 - k1, (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)
        v10, s3, c3 = w3 - w3, k2 * w3, k2 * K3

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        X1_2, Y1_2 = a2 + a3 * c3, a3 * s3
        v11, v12 = Z1_3 * X1_2, Z2_3 * Y1_2
        v13, v14, v15 = v11 - v12, v11 + v12, m6 + m5 * N3
        v16 = Z1_3 * v15
        S2_pp, S2_pm, v17 = v16 - w3 * (m5 * Z2_3), v16 - w3 * (m5 * -Z2_3), Z2_3 * X1_2
        v18 = Z1_3 * Y1_2
        v19, v20, v21 = v17 + v18, v17 - v18, w3 * (m5 * Z1_3)
        v22, v23 = w3 * (m5 * -Z1_3), Z2_3 * v15
        C2_pp, C2_pm, C2_mp = v21 + v23, v22 + v23, v21 - v23
        C2_mm, v24 = v22 - v23, S2_pp * S2_pp
        v25, v26 = v24 + C2_pp * C2_pp, S2_pm * S2_pm
        v27, v28, v29 = v26 + C2_pm * C2_pm, v26 + C2_mp * C2_mp, v24 + C2_mm * C2_mm
        w2_pp, w2_pm, w2_mp = math.sqrt(v25), math.sqrt(v27), math.sqrt(v28)
        w2_mm, v30, v31 = math.sqrt(v29), 1.0 / v25, 1.0 / v27
        v32, v33 = 1.0 / v28, 1.0 / v29

        # is the pose one that the arm can take?
        v34 = m7 + m8 * c3
        v35 = v19 * v34 - m8 * (s3 * v13)
        v36, v37 = v9 + w2_pp * (v30 * v35), m8 * (s3 * v14)
        v38, v39 = v9 + w2_pm * (v31 * (v20 * v34 + v37)), w2_mp * (v32 * (-v20 * v34 - v37)) - v9
        v40, v41, v42 = w2_mm * (v33 * -v35) - v9, d1 + v8, T33 - T33 * factor234
        v43, v44 = T31 - factor234 * (Z2_234 * v6), T23 - factor234 * (s1 * Z2_234)
        v45 = T21 + (c1 * v7 + factor234 * (v6 * (s1 * T33)))
        v46, v47 = T11 - (s1 * v7 - factor234 * (v6 * (c1 * T33))), T13 - factor234 * (c1 * Z2_234)
        v48 = s3 * v19 + c3 * v13
        v49 = T34 - (a3 * (w2_pp * (v30 * v48)) + (v41 + a2 * (S2_pp * (w2_pp * v30))))
        v50 = c3 * v14
        v51 = T34 - (a3 * (w2_pm * (v31 * (v50 - s3 * v20))) + (v41 + a2 * (S2_pm * (w2_pm * v31))))
        v52 = (
            T34 - (a3 * (w2_mp * (v32 * (v50 + s3 * -v20))) + (v41 + a2 * (S2_pm * (w2_mp * v32))))
        )
        v53 = T34 - (a3 * (w2_mm * (v33 * v48)) + (v41 + a2 * (S2_pp * (w2_mm * v33))))
        v54, v55, v56 = T14 - c1 * v36, T14 - c1 * v38, T14 + c1 * v39
        v57, v58, v59 = T14 + c1 * v40, T24 - s1 * v36, T24 - s1 * v38
        v60, v61, v62 = T24 + s1 * v39, T24 + s1 * v40, v49 * v49 + v54 * v54 + v58 * v58
        v63, v64 = v51 * v51 + v55 * v55 + v59 * v59, v52 * v52 + v56 * v56 + v60 * v60
        v65 = v53 * v53 + v57 * v57 + v61 * v61

        # joint values
        v74 = math.sqrt(-1.0)
        v75 = 0.0 if v62 <= m10 else v74
        v76 = 0.0 if v63 <= m10 else v74
        v77 = 0.0 if v64 <= m10 else v74
        v78 = 0.0 if v65 <= m10 else v74

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v3 <= m3 or v1 <= m1 or v4 <= m3 or abs(D3_squared) <= m4 or m9 < v42 * v42 + v43
            * v43 + v44 * v44 + v45 * v45 + v46 * v46 + v47 * v47 or (m10 < v65 and v65 <= m11) or
            (m10 < v64 and v64 <= m11) or (m10 < v62 and v62 <= m11) or (m10 < v63 and v63 <= m11)
            else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = Yhat1, Z2_5, v10
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v75, v76, v77
        kept[23 * w + k], turns[0 * w + k], turns[1 * w + k] = v78, Yhat1, -Z2_234
        turns[2 * w + k], turns[3 * w + k], turns[4 * w + k] = -Z2_5, w3, S2_pp
        turns[5 * w + k], turns[6 * w + k], turns[7 * w + k] = S2_pm, S2_pm, S2_pp
        turns[8 * w + k], turns[9 * w + k], turns[10 * w + k] = Xhat1, T33, -Z1_5
        turns[11 * w + k], turns[12 * w + k], turns[13 * w + k] = K3, C2_pp, C2_pm
        turns[14 * w + k], turns[15 * w + k] = C2_mp, C2_mm
    if w == 1 and kept[16] != 0.0:
        return
    for k in range(0 * w, 8 * w):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        Yhat1, Z2_5, v10 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v75, v76, v77 = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v78, angle1, angle2 = kept[23 * w + k], turns[0 * w + k], turns[1 * w + k]
        angle3, angle4, angle5 = turns[2 * w + k], turns[3 * w + k], turns[4 * w + k]
        angle6, angle7, angle8 = turns[5 * w + k], turns[6 * w + k], turns[7 * w + k]

        # joint values
        v66, v67 = angle2 - (angle4 + angle5) - offset4, angle2 - (angle6 - angle4) - offset4
        v68, v69 = offset4 + (angle2 + (angle4 + angle7)), offset4 + (angle2 + (angle8 - angle4))
        v70 = v66 + (turn if v66 <= -half_turn else (-turn if half_turn < v66 else 0.0))
        v71 = v67 + (turn if v67 <= -half_turn else (-turn if half_turn < v67 else 0.0))
        v72 = (turn if -v68 <= -half_turn else (-turn if half_turn < -v68 else 0.0)) - v68
        v73 = (turn if -v69 <= -half_turn else (-turn if half_turn < -v69 else 0.0)) - v69
        v79, v80 = angle1 + v10, v10 + (angle1 - math.copysign(half_turn, Yhat1))
        q1_pp, q1_pm, q1_mp = v75 + v79, v76 + v79, v77 + v80
        q1_mm, q2_pp, q2_pm = v78 + v80, angle5 + v75, angle6 + v76
        q2_mp, q2_mm, q3_pp = angle7 + v77, angle8 + v78, angle4 + v75
        q3_pm, q3_mp, q3_mm = v76 - angle4, angle4 + v77, v78 - angle4
        q4_pp = v75 + (v70 + (-turn if half_turn < v70 else 0.0))
        q4_pm = v76 + (v71 + (-turn if half_turn < v71 else 0.0))
        q4_mp = v77 + (v72 + (-turn if half_turn < v72 else 0.0))
        q4_mm = v78 + (v73 + (-turn if half_turn < v73 else 0.0))
        v81, v82 = angle3 + v10, v10 + (angle3 - math.copysign(half_turn, -Z2_5))
        q5_pp, q5_pm, q5_mp = v75 + v81, v76 + v81, v77 + v82
        q5_mm = v78 + v82

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
_FORMULAS = _functions.Formulas(_formulas, 24, 16, [
    [0, 1, 2, 3, 4], [5, 6, 7, 8, 9], [10, 11, 12, 13, 14], [15, 16, 17, 18, 19],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
