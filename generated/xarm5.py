# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: b7257d98eb95d607
"""xarm5: UFACTORY xArm 5.

Inverse kinematics, generated from robots/xarm5.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/xarm5.yaml. The formulas and where they come from: xarm5.md.

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

NAME = "xarm5"
METHOD = "closed form"
DOF = 5
JOINT_TYPES = "RRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = ("back-down", "back-up", "front-up", "front-down")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 0.00010806466145437469 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.267  # joint offset 1 [m]
a2 = 0.2894866145437471  # link length 2 [m]
a3 = 0.35116  # link length 3 [m]
a4 = 0.076  # link length 4 [m]
d5 = 0.097  # joint offset 5 [m]
second_weight = 1.080646614543747  # lengths count in arm sizes [m]
free_limit1 = 1.080646614543747e-12  # a length that fixes no angle [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
free_limit = 1e-12  # a length that fixes no angle
longest3 = 0.4104280847263644  # square of the longest reach [m^2]
shortest3 = 0.003803606473635553  # square of the shortest reach [m^2]
longest3_reach = 0.41042808472650283  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.003803606473622223  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.4104280847263506  # the longest, where branches merge [m^2]
shortest3_apart = 0.0038036064736368855  # the shortest, where branches merge [m^2]
offset2 = 1.7566747807196037  # offset of joint 2 [rad]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 1.080646614543747e-05  # a pose may be rounded by this [m]
offset3 = 2.733184269115749  # offset of joint 3 [rad]
offset4 = -1.3482663962455592  # offset of joint 4 [rad]
k1 = 0.20711584560000001  # a2^2 + a3^2 [m^2]
k2 = 4.918543046385274  # 1 / (2 * a3 * a2) [m^-2]
m1 = 1.1677971055248613e-08  # doubt_limit1^2 [m^2]
m2 = 9.999999999999999e-09  # doubt_limit^2
m4 = 0.076  # a4 [m]
m5 = 0.097  # d5 [m]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m6 = 5.597903840841209e-12
m7 = 1.727195576168653  # a3 * k2 [m^-1]
m8 = 0.06824295773100271  # a3 * k1 * k2 - a2 [m]
m9 = 1.4238523749857612  # a2 * k2 [m^-1]
m10 = 0.05625761134525573  # k2 * (a3 * k1^2 * k2 - a2 * k1 - a3 * longest3 * shortest3 * k2) [m]
m11 = 1.0000000000000002e-10  # pose_slack^2
m12 = 1.167797105524862e-10  # pose_slack1^2 [m^2]
m13 = 3.5033913165745856e-10  # 3 * pose_slack1^2 [m^2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="rotation",
    miss_weights=(0.9254, 0.9254, 0.9254, 1.0, 1.0, 1.0), size=1.080646614543747,
    steps=("retries", "follows seed"), choosable=(0,),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (3.141592653589793, 0.267, 0.0, 1.5707963267948966),
    (1.7566747807196037, 0.0, 0.2894866145437471, 0.0),
    (2.733184269115749, 0.0, 0.35116, 0.0),
    (-1.3482663962455592, 0.0, 0.076, -1.5707963267948966),
    (0.0, 0.097, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (5,)."""
    T = _zeros(4, 4)
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, x2_y, v3 = c1 * c2, s1 * c2, c1 * s2
    v4, v5 = s1 * s2, q[2] + offset3
    c3, s3 = math.cos(v5), math.sin(v5)
    x3_x, x3_y, x3_z = x2_x * c3 - v3 * s3, x2_y * c3 - v4 * s3, s2 * c3 + c2 * s3
    v6, v7, y3_z = v3 * c3 + x2_x * s3, v4 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    v8 = q[3] + offset4
    c4, s4 = math.cos(v8), math.sin(v8)
    x4_x, x4_y, x4_z = x3_x * c4 - v6 * s4, x3_y * c4 - v7 * s4, x3_z * c4 + y3_z * s4
    v9, v10, z4_z = v6 * c4 + x3_x * s4, v7 * c4 + x3_y * s4, y3_z * c4 - x3_z * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    T[0, 0], T[0, 1], T[0, 2] = x4_x * c5 - s1 * s5, -(s1 * c5 + x4_x * s5), -v9
    T[0, 3] = x2_x * a2 + x3_x * a3 + x4_x * a4 - v9 * d5
    T[1, 0], T[1, 1], T[1, 2] = x4_y * c5 + c1 * s5, c1 * c5 - x4_y * s5, -v10
    T[1, 3] = x2_y * a2 + x3_y * a3 + x4_y * a4 - v10 * d5
    T[2, 0], T[2, 1], T[2, 2] = x4_z * c5, -(x4_z * s5), z4_z
    T[2, 3] = d1 + s2 * a2 + x3_z * a3 + x4_z * a4 + z4_z * d5
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 5): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 5)
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, x2_y, v3 = c1 * c2, s1 * c2, c1 * s2
    v4, p2_x, p2_y = s1 * s2, x2_x * a2, x2_y * a2
    p2_z, v5 = d1 + s2 * a2, q[2] + offset3
    c3, s3 = math.cos(v5), math.sin(v5)
    x3_x, x3_y, x3_z = x2_x * c3 - v3 * s3, x2_y * c3 - v4 * s3, s2 * c3 + c2 * s3
    v6, v7, y3_z = v3 * c3 + x2_x * s3, v4 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    p3_x, p3_y, p3_z = p2_x + x3_x * a3, p2_y + x3_y * a3, p2_z + x3_z * a3
    v8 = q[3] + offset4
    c4, s4 = math.cos(v8), math.sin(v8)
    v9, v10, z4_z = v6 * c4 + x3_x * s4, v7 * c4 + x3_y * s4, y3_z * c4 - x3_z * s4
    p4_x, p4_y = p3_x + (x3_x * c4 - v6 * s4) * a4, p3_y + (x3_y * c4 - v7 * s4) * a4
    p4_z, p5_x, p5_y = p3_z + (x3_z * c4 + y3_z * s4) * a4, p4_x - v9 * d5, p4_y - v10 * d5
    p5_z = p4_z + z4_z * d5
    v11, v12, v13 = p5_z - d1, p5_z - p2_z, p5_z - p3_z
    v14, v15, v16 = p5_x - p4_x, p5_y - p4_y, p5_z - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -p5_y, -(c1 * v11), -(c1 * v12)
    J[0, 3], J[0, 4] = -(c1 * v13), -(v10 * v16 + z4_z * v15)
    J[1, 0], J[1, 1], J[1, 2] = p5_x, -(s1 * v11), -(s1 * v12)
    J[1, 3], J[1, 4] = -(s1 * v13), z4_z * v14 + v9 * v16
    J[2, 1], J[2, 2] = s1 * p5_y + c1 * p5_x, s1 * (p5_y - p2_y) + c1 * (p5_x - p2_x)
    J[2, 3], J[2, 4] = s1 * (p5_y - p3_y) + c1 * (p5_x - p3_x), v10 * v14 - v9 * v15
    J[3, 1], J[3, 2], J[3, 3] = s1, s1, s1
    J[3, 4] = -v9
    J[4, 1], J[4, 2], J[4, 3] = -c1, -c1, -c1
    J[4, 4] = -v10
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
    v1 = seed[0] + offset1

    # theta234, type 3: U1[2, 3] and U1[1, 3]
    v2 = T33 * T33

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v8 = T34 - d1

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(v1) if free1 else Xhat1 * factor1
        s1 = math.sin(v1) if free1 else Yhat1 * factor1

        # theta234
        Z2_234 = T13 * c1 + T23 * s1
        w234 = math.sqrt(Z2_234 * Z2_234 + v2)
        short234 = w234 <= free_limit
        factor234 = 1.0 / (1.0 if short234 else w234)
        c234, v3 = T33 * factor234, Z2_234 * factor234
        theta234 = _atan2(-v3, c234)

        # theta5, type 3: U1[3, 2] and U1[3, 1]
        Z1_5 = T12 * s1 - T22 * c1
        Z2_5 = T11 * s1 - T21 * c1
        w5 = math.sqrt(Z2_5 * Z2_5 + Z1_5 * Z1_5)
        short5 = w5 <= free_limit
        v4 = 1.0 / (1.0 if short5 else w5)
        v5, v6 = Z1_5 * v4, Z2_5 * v4
        q5 = _atan2(-v6, -v5)

        # theta3
        v7 = v3 * a4 - c234 * d5
        Z1_3 = v7 + v8
        v9 = c234 * a4 + v3 * d5
        Z2_3 = T14 * c1 + T24 * s1 - v9
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
        v10, v11 = Z1_3 * X1_2, Z2_3 * X1_2

        # is the pose one that the arm can take?
        v13 = d1 + -v7
        if (
            not (abs(T33 - c234) <= pose_slack and abs(T31 - v3 * v5) <= pose_slack and abs(T23 - s1
            * v3) <= pose_slack and abs(T21 + (v5 * (s1 * c234) + c1 * v6)) <= pose_slack and
            abs(T11 - (s1 * v6 - v5 * (c1 * c234))) <= pose_slack and abs(T13 - c1 * v3) <=
            pose_slack)
        ):
            continue  # the arm can't take this pose

        # joint values
        q1 = _wrap(_atan2(s1, c1) - offset1)

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            s3 = w3 * e3 * k2
            theta3 = _atan2(s3, c3)

            # theta2
            Y1_2 = a3 * s3
            S2 = v10 - Z2_3 * Y1_2
            C2 = v11 + Z1_3 * Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            factor2 = 1.0 / w2
            c2, s2 = C2 * factor2, S2 * factor2
            theta2 = _atan2(s2, c2)

            # is the pose one that the arm can take?
            c23, s23 = c3 * c2 - s3 * s2, c3 * s2 + s3 * c2
            v12 = a3 * c23 + (v9 + a2 * c2)
            if (
                not (abs(T34 - (a3 * s23 + (a2 * s2 + v13))) <= pose_slack1 and abs(T14 - c1 * v12)
                <= pose_slack1 and abs(T24 - s1 * v12) <= pose_slack1)
            ):
                continue  # the arm can't take this pose

            # joint values
            q2 = _wrap(theta2 - offset2)
            q3 = _wrap(theta3 - offset3)
            q4 = _wrap(theta234 - (theta3 + theta2) - offset4)
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
        v3 = v2 * (T13 * Xhat1 + T23 * Yhat1)
        Z2_234 = w1 * v3
        v4 = T33 * T33 + Z2_234 * Z2_234
        factor234 = math.sqrt(v4) * (1.0 / v4)

        # theta5, type 3: U1[3, 2] and U1[3, 1]
        Z1_5 = w1 * (v2 * (Yhat1 * T12 - Xhat1 * T22))
        Z2_5 = w1 * (v2 * (Yhat1 * T11 - Xhat1 * T21))
        v5 = Z2_5 * Z2_5 + Z1_5 * Z1_5
        v6 = math.sqrt(v5) * (1.0 / v5)
        v7, v8 = Z1_5 * v6, Z2_5 * v6

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        v9, v10 = d5 * T33, w1 * (m4 * v3)
        v11, v12 = v10 - v9, T34 - d1
        Z1_3_p, v13 = v12 + factor234 * v11, factor234 * (v9 + v10)
        Z1_3_m, v14, v15 = v12 - v13, a4 * T33, T14 * c1 + T24 * s1
        v16 = w1 * (m5 * v3)
        v17, v18 = factor234 * (v14 + v16), factor234 * (v14 - v16)
        Z2_3_p, v19 = v15 - v17, v15 + v18
        N3_p, N3_m = Z1_3_p * Z1_3_p + Z2_3_p * Z2_3_p, Z1_3_m * Z1_3_m + v19 * v19
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3)
        D3_squared_m, w3_p = (longest3 - N3_m) * (N3_m - shortest3), math.sqrt(D3_squared_p)
        w3_m, v20 = math.sqrt(D3_squared_m), w3_p - w3_p
        v21 = w3_m - w3_m

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        v22, v23 = m7 * N3_p - m8, m7 * N3_m - m8
        v24, v25 = Z1_3_p * v22, Z1_3_m * v23
        S2_pp, S2_pm = v24 - w3_p * (m7 * Z2_3_p), v24 - w3_p * (m7 * -Z2_3_p)
        v26 = w3_m * (m7 * v19)
        S2_mp, S2_mm, v27 = v25 + v26, v25 - v26, Z2_3_p * v22
        v28, factor2_p, factor2_m = v19 * v23, 1.0 / N3_p, 1.0 / N3_m
        v29 = w3_p * (m7 * Z1_3_p)

        # is the pose one that the arm can take?
        v30, v31 = Z1_3_p * (m9 + m10 * factor2_p), Z1_3_m * (m9 + m10 * factor2_m)
        v32, v33, v34 = v17 + Z2_3_p, v18 - v19, d1 + factor234 * -v11
        v35, v36, v37 = d1 + v13, T33 - T33 * factor234, T31 - factor234 * (Z2_234 * v7)
        v38, v39 = T23 - factor234 * (s1 * Z2_234), T21 + (c1 * v8 + factor234 * (v7 * (s1 * T33)))
        v40, v41 = T11 - (s1 * v8 - factor234 * (v7 * (c1 * T33))), T13 - factor234 * (c1 * Z2_234)
        v42 = (
            T34 - (a3 * (v30 + w3_p * (m9 * (Z2_3_p * factor2_p))) + (v34 + a2 * (S2_pp *
            factor2_p)))
        )
        v43 = (
            T34 - (a3 * (v30 + w3_p * (m9 * (-Z2_3_p * factor2_p))) + (v34 + a2 * (S2_pm *
            factor2_p)))
        )
        v44 = w3_m * (m9 * (v19 * factor2_m))
        v45 = T34 - (a3 * (v31 - v44) + (v35 + a2 * (S2_mp * factor2_m)))
        v46, v47 = T34 - (a3 * (v31 + v44) + (v35 + a2 * (S2_mm * factor2_m))), T14 - c1 * v32
        v48, v49, v50 = T14 + c1 * v33, T24 - s1 * v32, T24 + s1 * v33
        v51, v52, v53 = v47 * v47, v48 * v48, v49 * v49
        v54, v55, v56 = v50 * v50, v53 + (v51 + v42 * v42), v53 + (v51 + v43 * v43)
        v57, v58 = v54 + (v52 + v45 * v45), v54 + (v52 + v46 * v46)

        # joint values
        v77 = math.sqrt(-1.0)
        v78 = 0.0 if v55 <= m12 else v77
        v79 = 0.0 if v56 <= m12 else v77
        v80 = 0.0 if v57 <= m12 else v77
        v81 = 0.0 if v58 <= m12 else v77

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v4 <= m2 or v1 <= m1 or v5 <= m2 or m11 < v36 * v36 + v37 * v37 + v38 * v38 + v39
            * v39 + v40 * v40 + v41 * v41 or (m12 < v58 and v58 <= m13) or (m12 < v57 and v57 <=
            m13) or (m12 < v56 and v56 <= m13) or (m12 < v55 and v55 <= m13) or abs(D3_squared_p) <=
            m6 or abs(D3_squared_m) <= m6 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = Yhat1, Z2_5, v20
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v21, v78, v79
        kept[23 * w + k], kept[24 * w + k], turns[0 * w + k] = v80, v81, -Z2_234
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = -Z2_5, w3_p, w3_m
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = S2_pp, S2_pm, S2_mp
        turns[7 * w + k], turns[8 * w + k], turns[16 * w + k] = S2_mm, Yhat1, T33
        turns[17 * w + k], turns[18 * w + k], turns[19 * w + k] = -Z1_5, N3_p - k1, N3_m - k1
        turns[20 * w + k], turns[21 * w + k] = v27 + v29, v27 - v29
        turns[22 * w + k] = w3_m * (m7 * Z1_3_m) - v28
        turns[23 * w + k], turns[24 * w + k] = w3_m * (m7 * -Z1_3_m) - v28, Xhat1
    if w == 1 and kept[16] != 0.0:
        return
    end = 16 if w == 1 else 9 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(9 * w, end):
        turns[k] = turns[k + 16 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 16 * w])
    for k in range(w):
        Yhat1, Z2_5, v20 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v21, v78, v79 = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v80, v81, angle1 = kept[23 * w + k], kept[24 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle8, angle9 = turns[7 * w + k], turns[8 * w + k]

        # joint values
        v59, v60 = angle9 - offset1, angle9 - math.copysign(half_turn, Yhat1) - offset1
        v61, v62, v63 = angle5 - offset2, angle6 - offset2, angle7 - offset2
        v64, v65, v66 = angle8 - offset2, angle3 - offset3, offset3 + angle3
        v67, v68, v69 = angle4 - offset3, offset3 + angle4, angle1 - (angle3 + angle5) - offset4
        v70, v71 = angle1 - (angle6 - angle3) - offset4, offset4 + (angle1 + (angle4 + angle7))
        v72 = offset4 + (angle1 + (angle8 - angle4))
        v73 = v69 + (turn if v69 <= -half_turn else (-turn if half_turn < v69 else 0.0))
        v74 = v70 + (turn if v70 <= -half_turn else (-turn if half_turn < v70 else 0.0))
        v75 = (turn if -v71 <= -half_turn else (-turn if half_turn < -v71 else 0.0)) - v71
        v76 = (turn if -v72 <= -half_turn else (-turn if half_turn < -v72 else 0.0)) - v72
        v82 = v20 + (v59 + (turn if v59 <= -half_turn else 0.0))
        v83 = v21 + (v60 + (turn if v60 <= -half_turn else 0.0))
        q1_pp, q1_pm, q1_mp = v78 + v82, v79 + v82, v80 + v83
        q1_mm = v81 + v83
        q2_pp = v78 + (v61 + (turn if v61 <= -half_turn else 0.0))
        q2_pm = v79 + (v62 + (turn if v62 <= -half_turn else 0.0))
        q2_mp = v80 + (v63 + (turn if v63 <= -half_turn else 0.0))
        q2_mm = v81 + (v64 + (turn if v64 <= -half_turn else 0.0))
        q3_pp = v78 + (v65 + (turn if v65 <= -half_turn else 0.0))
        q3_pm = v79 + ((turn if -v66 <= -half_turn else 0.0) - v66)
        q3_mp = v80 + (v67 + (turn if v67 <= -half_turn else 0.0))
        q3_mm = v81 + ((turn if -v68 <= -half_turn else 0.0) - v68)
        q4_pp = v78 + (v73 + (-turn if half_turn < v73 else 0.0))
        q4_pm = v79 + (v74 + (-turn if half_turn < v74 else 0.0))
        q4_mp = v80 + (v75 + (-turn if half_turn < v75 else 0.0))
        q4_mm = v81 + (v76 + (-turn if half_turn < v76 else 0.0))
        v84, v85 = angle2 + v20, v21 + (angle2 - math.copysign(half_turn, -Z2_5))
        q5_pp, q5_pm, q5_mp = v78 + v84, v79 + v84, v80 + v85
        q5_mm = v81 + v85

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
