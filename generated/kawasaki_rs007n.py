# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 507a4b68dffe081d
"""kawasaki_rs007n: Kawasaki RS007N.

Inverse kinematics, generated from robots/kawasaki_rs007n.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kawasaki_rs007n.yaml. The formulas and where they come from:
kawasaki_rs007n.md.

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

NAME = "kawasaki_rs007n"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-3.141592653589793, 3.141592653589793), (-2.356194490192345, 2.356194490192345),
    (-2.705260340591211, 2.705260340591211), (-3.490658503988659, 3.490658503988659),
    (-2.181661564992912, 2.181661564992912), (-6.283185307179586, 6.283185307179586),
)
BRANCHES = (
    "front-down-noflip", "front-down-flip", "front-up-noflip", "front-up-flip", "back-up-noflip",
    "back-up-flip", "back-down-noflip", "back-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 0.00011679999999999999 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.36  # joint offset 1 [m]
a2 = 0.355  # link length 2 [m]
d4 = 0.375  # joint offset 4 [m]
d6 = 0.078  # joint offset 6 [m]
free_limit1 = 1.1679999999999999e-12  # a length that fixes no angle [m]
offset1 = -1.5707963267948966  # offset of joint 1 [rad]
longest3 = 0.5328999999999999  # square of the longest reach [m^2]
shortest3 = 0.0004000000000000007  # square of the shortest reach [m^2]
longest3_reach = 0.5329000000001705  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.00039999999999532873  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.5328999999999829  # the longest, where branches merge [m^2]
shortest3_apart = 0.00040000000000046796  # the shortest, where branches merge [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset3 = 1.5707963267948966  # offset of joint 3 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
offset6 = 1.5707963267948966  # offset of joint 6 [rad]
k1 = 0.26625  # 2 * d4 * a2 [m^2]
k2 = 0.26665  # a2^2 + d4^2 [m^2]
k3 = 14.106548524322777  # 1 / (k1^2) [m^-4]
high2 = 2.356194491192345  # highest value of joint 2, with what rounding adds [rad]
high3 = 2.705260341591211  # highest value of joint 3, with what rounding adds [rad]
high5 = 2.181661565992912  # highest value of joint 5, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 1.3642239999999998e-08  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 9.045264537377017e-12
m3 = 1.4084507042253522  # d4 * k1 * k3 [m^-1]
m4 = 0.020563380281690184  # d4 * k1 * k2 * k3 - a2 [m]
m5 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.8562, 0.8562, 0.8562, 1.0, 1.0, 1.0), size=1.168,
    steps=("keeps limits", "clamps", "clamps far", "range exceeds a turn", "follows seed"),
    choosable=(3, 0),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (-1.5707963267948966, -0.36, 0.0, 1.5707963267948966),
    (-1.5707963267948966, 0.0, 0.355, 3.141592653589793),
    (1.5707963267948966, 0.0, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.375, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (1.5707963267948966, 0.078, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    base=(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, v3, y2_x = c1 * c2, s1 * c2, c1 * s2
    v4, v5 = s1 * s2, q[2] + offset3
    c3, s3 = math.cos(v5), math.sin(v5)
    x3_x, v6, x3_z = x2_x * c3 + y2_x * s3, v3 * c3 + v4 * s3, c2 * s3 - s2 * c3
    v7, z3_x, z3_y = c2 * c3 + s2 * s3, x2_x * s3 - y2_x * c3, v4 * c3 - v3 * s3
    v8 = q[3] + offset4
    c4, s4 = math.cos(v8), math.sin(v8)
    x4_x, v9, x4_z = x3_x * c4 - s1 * s4, v6 * c4 + c1 * s4, x3_z * c4
    z4_x, z4_z, z4_y = s1 * c4 + x3_x * s4, x3_z * s4, c1 * c4 - v6 * s4
    v10 = q[4] + offset5
    c5, s5 = math.cos(v10), math.sin(v10)
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, z3_y * s5 - v9 * c5, x4_z * c5 - v7 * s5
    v11, z5_z, z5_x = z3_y * c5 + v9 * s5, v7 * c5 + x4_z * s5, x4_x * s5 - z3_x * c5
    v12 = q[5] + offset6
    c6, s6 = math.cos(v12), math.sin(v12)
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + z4_x * s6, z4_x * c6 - x5_x * s6, z5_x
    T[0, 3] = x2_x * a2 + z3_x * d4 + z5_x * d6
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + z4_y * s6, z4_y * c6 - x5_y * s6, -v11
    T[1, 3] = z3_y * d4 - v3 * a2 - v11 * d6
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 + z4_z * s6, z4_z * c6 - x5_z * s6, z5_z
    T[2, 3] = d1 - s2 * a2 - v7 * d4 + z5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, v3, y2_x = c1 * c2, s1 * c2, c1 * s2
    v4, p2_x, v5 = s1 * s2, x2_x * a2, v3 * a2
    p2_z, v6 = d1 - s2 * a2, q[2] + offset3
    c3, s3 = math.cos(v6), math.sin(v6)
    x3_x, v7, x3_z = x2_x * c3 + y2_x * s3, v3 * c3 + v4 * s3, c2 * s3 - s2 * c3
    v8, z3_x, z3_y = c2 * c3 + s2 * s3, x2_x * s3 - y2_x * c3, v4 * c3 - v3 * s3
    v9 = q[3] + offset4
    c4, s4 = math.cos(v9), math.sin(v9)
    z4_x, z4_z, p4_x = s1 * c4 + x3_x * s4, x3_z * s4, p2_x + z3_x * d4
    p4_y, p4_z, z4_y = z3_y * d4 - v5, p2_z - v8 * d4, c1 * c4 - v7 * s4
    v10 = q[4] + offset5
    c5, s5 = math.cos(v10), math.sin(v10)
    v11, z5_z = z3_y * c5 + (v7 * c4 + c1 * s4) * s5, v8 * c5 + x3_z * c4 * s5
    z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5
    p6_x, p6_y, p6_z = p4_x + z5_x * d6, p4_y - v11 * d6, p4_z + z5_z * d6
    v12, v13, v14 = p6_z - d1, p6_x - p2_x, v5 + p6_y
    v15, v16, v17 = p6_z - p2_z, p6_x - p4_x, p6_y - p4_y
    v18 = p6_z - p4_z
    J[0, 0], J[0, 1], J[0, 2] = p6_y, c1 * v12, -(c1 * v15)
    J[0, 3], J[0, 4] = z3_y * v15 + v8 * v14, z4_y * v18 - z4_z * v17
    J[0, 5] = -(v11 * v18 + z5_z * v17)
    J[1, 0], J[1, 1], J[1, 2] = -p6_x, -(s1 * v12), s1 * v15
    J[1, 3], J[1, 4] = -(v8 * v13 + z3_x * v15), z4_z * v16 - z4_x * v18
    J[1, 5] = z5_z * v16 - z5_x * v18
    J[2, 1], J[2, 2], J[2, 3] = s1 * p6_y - c1 * p6_x, c1 * v13 - s1 * v14, z3_x * v14 - z3_y * v13
    J[2, 4], J[2, 5] = z4_x * v17 - z4_y * v16, z5_x * v17 + v11 * v16
    J[3, 1], J[3, 2], J[3, 3] = s1, -s1, z3_x
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = c1, -c1, z3_y
    J[4, 4], J[4, 5] = z4_y, -v11
    J[5, 0], J[5, 3], J[5, 4] = -1.0, -v8, z4_z
    J[5, 5] = z5_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1 A6^-1 [3, 4]
    X1 = T13 * d6 - T14
    wy = d6 * T23 - T24
    w1 = math.sqrt(X1 * X1 + wy * wy)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1
    v1 = seed[0] + offset1

    # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = d6 * T33 - T34
    Z1_3 = wz + d1
    v2 = Z1_3 * Z1_3

    # theta4, type 2: U4[3, 3]
    v11 = seed[3] + offset4

    for i1 in range(2):  # front, back
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(v1) if free1 else -(X1 * factor1)
        s1 = math.sin(v1) if free1 else wy * factor1
        D1 = w1 * e1

        # theta3
        N3 = v2 + D1 * D1
        K3 = N3 - k2
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        s3 = k1 * K3 * k3

        # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        X1_2 = a2 + d4 * s3
        v4, v5 = Z1_3 * X1_2, D1 * X1_2

        # theta4
        v7, v9 = T13 * c1 - T23 * s1, T23 * c1 + T13 * s1
        v10 = v9 * v9

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v12, v13, v15 = T22 * c1 + T12 * s1, T12 * c1 - T22 * s1, T21 * c1 + T11 * s1
        v16 = T11 * c1 - T21 * s1

        # joint values
        q1 = _wrap(_atan2(s1, c1) - offset1)

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            v3 = k3 * (k1 * (w3 * e3))

            # theta2
            X2_2 = d4 * v3
            S2 = v4 + D1 * X2_2
            C2 = v5 - Z1_3 * X2_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            factor2 = 1.0 / w2
            c2, s2 = C2 * factor2, S2 * factor2

            # theta4
            c2m3 = s3 * s2 - v3 * c2
            v6 = v3 * s2 + s3 * c2
            v8 = c2m3 * v7 + T33 * v6
            w4 = math.sqrt(v8 * v8 + v10)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T33 * c2m3 - v6 * v7

            # theta6
            v14, v17 = c2m3 * v13 + T32 * v6, c2m3 * v16 + T31 * v6

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(s3, -v3) - offset3)

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(v11) if free4 else v8 * factor4
                s4 = math.sin(v11) if free4 else -(v9 * factor4)
                s5 = w4 * e4

                # theta6
                c6, s6 = c4 * v12 + s4 * v14, c4 * v15 + s4 * v17

                # joint values
                q4 = _wrap(_atan2(s4, c4) - offset4)
                q5 = _wrap(_atan2(s5, c5) - offset5)
                q6 = _wrap(_atan2(s6, c6) - offset6)
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

        # theta1, type 2: U1 A6^-1 [3, 4]
        X1, wy = d6 * T13 - T14, d6 * T23 - T24
        v1 = X1 * X1 + wy * wy
        w1, v2 = math.sqrt(v1), 1.0 / v1
        factor1 = w1 * v2
        v3, s1 = X1 * factor1, wy * factor1

        # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        Z1_3 = d1 + (d6 * T33 - T34)
        N3 = v1 + Z1_3 * Z1_3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)
        v4, v5 = w3 - w3, k1 * (N3 - k2)
        s3, v6 = k3 * v5, k1 * w3
        v7 = k3 * v6

        # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        X1_2, X2_2 = a2 + d4 * s3, d4 * v7
        v8, v9 = Z1_3 * X1_2, w1 * X2_2
        v10, v11, v12 = v8 + v9, v8 - v9, m3 * N3 - m4
        v13, v14 = Z1_3 * v12, w3 * (m3 * w1)
        S2_pp, S2_pm, v15 = v13 + v14, v13 - v14, w1 * X1_2
        v16 = Z1_3 * X2_2
        v17, v18, v19 = v15 - v16, v15 + v16, w3 * (m3 * Z1_3)
        v20, v21 = w1 * v12, w1 * -v12
        C2_pp, C2_pm, C2_mp = v20 - v19, v19 + v20, v21 - v19
        C2_mm, v22 = v19 + v21, S2_pp * S2_pp
        v23, v24 = v22 + C2_pp * C2_pp, S2_pm * S2_pm
        v25, v26, v27 = v24 + C2_pm * C2_pm, v24 + C2_mp * C2_mp, v22 + C2_mm * C2_mm
        w2_pp, w2_pm, w2_mp = math.sqrt(v23), math.sqrt(v25), math.sqrt(v26)
        w2_mm, v28, v29 = math.sqrt(v27), 1.0 / v23, 1.0 / v25
        v30, v31 = 1.0 / v26, 1.0 / v27

        # theta4, type 2: U4[3, 3]
        v32 = s3 * v10
        c2m3_pp, v33 = w2_pp * (v28 * (v32 - v7 * v17)), s3 * v11 + v7 * v18
        c2m3_pm, c2m3_mp = w2_pm * (v29 * v33), w2_mp * (v30 * v33)
        c2m3_mm, v34 = w2_mm * (v31 * (v32 + v7 * -v17)), v7 * v10
        v35, v36 = w2_pp * (v28 * (v34 + s3 * v17)), s3 * v18 - v7 * v11
        v37, v38, v39 = w2_pm * (v29 * v36), w2_mp * (v30 * -v36), w2_mm * (v31 * (s3 * -v17 - v34))
        v40 = w1 * (v2 * (T13 * X1 + T23 * wy))
        v41, v42 = T33 * v35 - c2m3_pp * v40, T33 * v37 - c2m3_pm * v40
        v43, v44, v45 = T33 * v38 + c2m3_mp * v40, T33 * v39 + c2m3_mm * v40, T13 * s1 - T23 * v3
        v46 = w1 * (v2 * (T13 * wy - X1 * T23))
        v47 = v46 * v46
        v48, v49, v50 = v47 + v41 * v41, v47 + v42 * v42, v47 + v43 * v43
        v51, v52, v53 = v47 + v44 * v44, 1.0 / v48, 1.0 / v49
        v54, v55 = 1.0 / v50, 1.0 / v51

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v56, v57, v58 = s1 * T12 - v3 * T22, w1 * (v2 * (X1 * T12 + wy * T22)), s1 * T11 - v3 * T21
        v59 = w1 * (v2 * (X1 * T11 + wy * T21))

        # joint values
        v68, v69 = math.copysign(half_turn, -v46), math.copysign(half_turn, v46)
        v86 = v52 * (v41 * v58 - v45 * (v35 * T31 - c2m3_pp * v59))
        v87 = v53 * (v42 * v58 - v45 * (v37 * T31 - c2m3_pm * v59))

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(D3_squared) <= m2 or v1 <= m1 or v51 <= m5 or v50 <= m5 or v48 <= m5 or v49
            <= m5 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = wy, v4, v5
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = c2m3_mp, c2m3_mm, v38
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = v39, v43, v44
        kept[26 * w + k], kept[27 * w + k], kept[28 * w + k] = v45, v54, v55
        kept[29 * w + k], kept[30 * w + k], kept[31 * w + k] = v58, v59, v68
        kept[32 * w + k], kept[33 * w + k], kept[34 * w + k] = v69, v86, v87
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = wy, S2_pp, S2_pm
        turns[3 * w + k], turns[4 * w + k], turns[5 * w + k] = S2_pm, S2_pp, v5
        turns[6 * w + k], turns[7 * w + k], turns[8 * w + k] = -v46, -v46, v46
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = v46, math.sqrt(v48), math.sqrt(v49)
        turns[12 * w + k], turns[13 * w + k] = math.sqrt(v50), math.sqrt(v51)
        turns[14 * w + k], turns[15 * w + k] = v86, v87
        turns[16 * w + k] = -(v54 * (v43 * v58 - v45 * (v38 * T31 + c2m3_mp * v59)))
        turns[17 * w + k] = -(v55 * (v44 * v58 - v45 * (v39 * T31 + c2m3_mm * v59)))
        turns[24 * w + k], turns[25 * w + k], turns[26 * w + k] = -X1, C2_pp, C2_pm
        turns[27 * w + k], turns[28 * w + k], turns[29 * w + k] = C2_mp, C2_mm, -v6
        turns[30 * w + k], turns[31 * w + k], turns[32 * w + k] = v41, v42, v43
        turns[33 * w + k], turns[34 * w + k] = v44, T33 * c2m3_pp + v35 * v40
        turns[35 * w + k], turns[36 * w + k] = T33 * c2m3_pm + v37 * v40, T33 * c2m3_mp - v38 * v40
        turns[37 * w + k] = T33 * c2m3_mm - v39 * v40
        turns[38 * w + k] = v52 * (v41 * v56 - v45 * (v35 * T32 - c2m3_pp * v57))
        turns[39 * w + k] = v53 * (v42 * v56 - v45 * (v37 * T32 - c2m3_pm * v57))
        turns[40 * w + k] = -(v54 * (v43 * v56 - v45 * (v38 * T32 + c2m3_mp * v57)))
        turns[41 * w + k] = -(v55 * (v44 * v56 - v45 * (v39 * T32 + c2m3_mm * v57)))
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 18 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(18 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        T31, wy, v4 = kept[8 * w + k], kept[17 * w + k], kept[18 * w + k]
        v5, c2m3_mp, c2m3_mm = kept[19 * w + k], kept[20 * w + k], kept[21 * w + k]
        v38, v39, v43 = kept[22 * w + k], kept[23 * w + k], kept[24 * w + k]
        v44, v45, v54 = kept[25 * w + k], kept[26 * w + k], kept[27 * w + k]
        v55, v58, v59 = kept[28 * w + k], kept[29 * w + k], kept[30 * w + k]
        v68, v69, v86 = kept[31 * w + k], kept[32 * w + k], kept[33 * w + k]
        v87, angle1, angle2 = kept[34 * w + k], turns[0 * w + k], turns[1 * w + k]
        angle3, angle4, angle5 = turns[2 * w + k], turns[3 * w + k], turns[4 * w + k]
        angle6, angle7, angle8 = turns[5 * w + k], turns[6 * w + k], turns[7 * w + k]
        angle9, angle10, angle11 = turns[8 * w + k], turns[9 * w + k], turns[10 * w + k]
        angle12, angle13, angle14 = turns[11 * w + k], turns[12 * w + k], turns[13 * w + k]
        angle15, angle16, angle17 = turns[14 * w + k], turns[15 * w + k], turns[16 * w + k]
        angle18 = turns[17 * w + k]

        # joint values
        v60, v61 = angle1 - offset1, angle1 - math.copysign(half_turn, wy) - offset1
        v62, v63, v64 = angle2 - offset2, angle3 - offset2, angle4 - offset2
        v65 = angle5 - offset2
        q2_ppp = v62 + (-turn if half_turn < v62 else 0.0)
        q2_pmp = v63 + (-turn if half_turn < v63 else 0.0)
        q2_mpp = v64 + (-turn if half_turn < v64 else 0.0)
        q2_mmp = v65 + (-turn if half_turn < v65 else 0.0)
        v66, v67 = angle6 - offset3, math.copysign(half_turn, v5) - angle6 - offset3
        q3_ppp = v66 + (turn if v66 <= -half_turn else 0.0)
        q3_pmp = v67 + (turn if v67 <= -half_turn else 0.0)
        v70, v71, v72 = angle7 - offset4, angle7 - v68 - offset4, angle8 - offset4
        v73, v74, v75 = angle8 - v68 - offset4, angle9 - offset4, angle9 - v69 - offset4
        v76, v77 = angle10 - offset4, angle10 - v69 - offset4
        q4_ppp = v70 + (turn if v70 <= -half_turn else 0.0)
        q4_ppm = v71 + (turn if v71 <= -half_turn else 0.0)
        q4_pmp = v72 + (turn if v72 <= -half_turn else 0.0)
        q4_pmm = v73 + (turn if v73 <= -half_turn else 0.0)
        q4_mpp = v74 + (turn if v74 <= -half_turn else 0.0)
        q4_mpm = v75 + (turn if v75 <= -half_turn else 0.0)
        q4_mmp = v76 + (turn if v76 <= -half_turn else 0.0)
        q4_mmm = v77 + (turn if v77 <= -half_turn else 0.0)
        v78, v79, v80 = angle11 - offset5, offset5 + angle11, angle12 - offset5
        v81, v82, v83 = offset5 + angle12, angle13 - offset5, offset5 + angle13
        v84, v85 = angle14 - offset5, offset5 + angle14
        q5_ppp = v78 + (turn if v78 <= -half_turn else 0.0)
        q5_ppm = (turn if -v79 <= -half_turn else 0.0) - v79
        q5_pmp = v80 + (turn if v80 <= -half_turn else 0.0)
        q5_pmm = (turn if -v81 <= -half_turn else 0.0) - v81
        q5_mpp = v82 + (turn if v82 <= -half_turn else 0.0)
        q5_mpm = (turn if -v83 <= -half_turn else 0.0) - v83
        q5_mmp = v84 + (turn if v84 <= -half_turn else 0.0)
        q5_mmm = (turn if -v85 <= -half_turn else 0.0) - v85
        v88, v89 = angle15 - offset6, angle15 - math.copysign(half_turn, v86) - offset6
        v90, v91 = angle16 - offset6, angle16 - math.copysign(half_turn, v87) - offset6
        v92 = angle17 - offset6
        v93 = (
            angle17 - math.copysign(half_turn, -(v54 * (v43 * v58 - v45 * (v38 * T31 + c2m3_mp *
            v59)))) - offset6
        )
        v94 = angle18 - offset6
        v95 = (
            angle18 - math.copysign(half_turn, -(v55 * (v44 * v58 - v45 * (v39 * T31 + c2m3_mm *
            v59)))) - offset6
        )
        q6_ppp = v88 + (turn if v88 <= -half_turn else 0.0)
        q6_ppm = v89 + (turn if v89 <= -half_turn else 0.0)
        q6_pmp = v90 + (turn if v90 <= -half_turn else 0.0)
        q6_pmm = v91 + (turn if v91 <= -half_turn else 0.0)
        q6_mpp = v92 + (turn if v92 <= -half_turn else 0.0)
        q6_mpm = v93 + (turn if v93 <= -half_turn else 0.0)
        q6_mmp = v94 + (turn if v94 <= -half_turn else 0.0)
        q6_mmm = v95 + (turn if v95 <= -half_turn else 0.0)
        v96, v97 = abs(q3_ppp) - high3, abs(q3_pmp) - high3
        q1_ppp = v4 + (v60 + (-turn if half_turn < v60 else 0.0))
        q1_mpp = v4 + (v61 + (-turn if half_turn < v61 else 0.0))
        v98, v99 = max(v96, abs(q2_ppp) - high2), max(v97, abs(q2_pmp) - high2)
        v100, v101 = max(v96, abs(q2_mpp) - high2), max(v97, abs(q2_mmp) - high2)
        excess_ppp, excess_ppm = max(v98, abs(q5_ppp) - high5), max(v98, abs(q5_ppm) - high5)
        excess_pmp, excess_pmm = max(v99, abs(q5_pmp) - high5), max(v99, abs(q5_pmm) - high5)
        excess_mpp, excess_mpm = max(v100, abs(q5_mpp) - high5), max(v100, abs(q5_mpm) - high5)
        excess_mmp, excess_mmm = max(v101, abs(q5_mmp) - high5), max(v101, abs(q5_mmm) - high5)
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
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_ppp, q5_ppp, q6_ppp
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, q5_ppm, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q2_pmp, q3_pmp, q4_pmp
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q5_pmp, q6_pmp, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q5_pmm, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q2_mpp, q4_mpp, q5_mpp
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = q6_mpp, q4_mpm, q5_mpm
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q6_mpm, q2_mmp, q4_mmp
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q5_mmp, q6_mmp, q4_mmm
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
_FORMULAS = _functions.Formulas(_formulas, 35, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 2, 19, 20, 21], [17, 18, 2, 22, 23, 24], [17, 25, 10, 26, 27, 28],
    [17, 25, 10, 29, 30, 31],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
