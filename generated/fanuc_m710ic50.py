# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 78a8baf20f7b61fb
"""fanuc_m710ic50: Fanuc M-710iC/50.

Inverse kinematics, generated from robots/fanuc_m710ic50.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/fanuc_m710ic50.yaml. The formulas and where they come from:
fanuc_m710ic50.md.

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

NAME = "fanuc_m710ic50"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-3.1415, 3.1415), (-1.5707, 2.3561), (-2.7925, 4.8869), (-6.283, 6.283), (-2.1816, 2.1816),
    (-6.2831, 6.2831),
)
BRANCHES = (
    "back-up-noflip", "back-up-flip", "back-down-noflip", "back-down-flip", "front-down-noflip",
    "front-down-flip", "front-up-noflip", "front-up-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 0.00029459999999999995 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.565  # joint offset 1 [m]
a1 = 0.15  # link length 1 [m]
a2 = 0.87  # link length 2 [m]
a3 = 0.17  # link length 3 [m]
d4 = 1.016  # joint offset 4 [m]
d6 = 0.175  # z of the tool frame [m]
free_limit1 = 2.9459999999999998e-12  # a length that fixes no angle [m]
longest3 = 3.61047221996678  # square of the longest reach [m^2]
shortest3 = 0.025639780033220066  # square of the shortest reach [m^2]
longest3_reach = 3.6104722199679  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.025639780033125722  # the shortest, with what rounding adds [m^2]
longest3_apart = 3.610472219966668  # the longest, where branches merge [m^2]
shortest3_apart = 0.025639780033229496  # the shortest, where branches merge [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset5 = 3.141592653589793  # offset of joint 5 [rad]
k1 = 1.76784  # 2 * d4 * a2 [m^2]
k2 = 0.2958  # 2 * a3 * a2 [m^2]
k3 = 1.8180560000000001  # a2^2 + (a3^2 + d4^2) [m^2]
k4 = 0.31125925198890714  # 1 / (k1^2 + k2^2) [m^-4]
turn1 = -1.4050092836833894  # atan2(-k1, k2) [rad]
high1 = 3.1415000010000003  # highest value of joint 1, with what rounding adds [rad]
low2 = -1.570700001  # lowest value of joint 2, with what rounding adds [rad]
high2 = 2.356100001  # highest value of joint 2, with what rounding adds [rad]
low3 = -2.792500001  # lowest value of joint 3, with what rounding adds [rad]
high3 = 4.886900001  # highest value of joint 3, with what rounding adds [rad]
high5 = 2.181600001  # highest value of joint 5, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 8.678915999999997e-08  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 4.011803222351191e-10
m4 = 0.5747126436781609  # k4 * (d4 * k1 + a3 * k2) [m^-1]
m5 = 0.1748597701149426  # d4 * k1 * k3 * k4 + a3 * k2 * k3 * k4 - a2 [m]
m6 = 0.0801013234623373  # a2 * k2 * k4 [m^-1]
m7 = 0.47872320375138055  # a2 * k1 * k4 [m^-1]
# k1 * k4 * (d4 * k1 * k3^2 * k4 + a3 * k2 * k3^2 * k4 - a2 * k3 - d4 * longest3 * shortest3 * k1 *
# k4 - a3 * longest3 * shortest3 * k2 * k4) [m]
m8 = 0.14565440708058014
# k2 * k4 * (d4 * k1 * k3^2 * k4 + a3 * k2 * k3^2 * k4 - a2 * k3 - d4 * longest3 * shortest3 * k1 *
# k4 - a3 * longest3 * shortest3 * k2 * k4) [m]
m9 = 0.024371308271356914
m10 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.3394, 0.3394, 0.3394, 1.0, 1.0, 1.0), size=2.9459999999999997,
    steps=("keeps limits", "clamps", "clamps far", "range exceeds a turn", "follows seed"),
    choosable=(3, 0),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.565, 0.15, -1.5707963267948966),
    (-1.5707963267948966, 0.0, 0.87, 3.141592653589793),
    (0.0, 0.0, 0.17, -1.5707963267948966),
    (0.0, -1.016, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    tool=(0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 0.0, 0.0, -1.0, 0.0, 0.0, -0.175),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, y2_x = c1 * c2, s1 * c2, c1 * s2
    y2_y = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, c2 * s3 - s2 * c3
    z3_x, z3_y, z3_z = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, c2 * c3 + s2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - s1 * s4, x3_y * c4 + c1 * s4, x3_z * c4
    z4_x, z4_z, z4_y = s1 * c4 + x3_x * s4, x3_z * s4, x3_y * s4 - c1 * c4
    v2 = q[4] + offset5
    c5, s5 = math.cos(v2), math.sin(v2)
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, x4_y * c5 + z3_y * s5, x4_z * c5 + z3_z * s5
    T11_, T21_, T31_ = z3_x * c5 - x4_x * s5, z3_y * c5 - x4_y * s5, z3_z * c5 - x4_z * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = T11_, x5_x * s6 - z4_x * c6, -(x5_x * c6 + z4_x * s6)
    T[0, 3] = c1 * a1 + x2_x * a2 + x3_x * a3 - z3_x * d4 - -T11_ * d6
    T[1, 0], T[1, 1], T[1, 2] = T21_, x5_y * s6 - z4_y * c6, -(x5_y * c6 + z4_y * s6)
    T[1, 3] = s1 * a1 + x2_y * a2 + x3_y * a3 - z3_y * d4 - -T21_ * d6
    T[2, 0], T[2, 1], T[2, 2] = T31_, x5_z * s6 - z4_z * c6, -(x5_z * c6 + z4_z * s6)
    T[2, 3] = d1 - s2 * a2 + x3_z * a3 - z3_z * d4 - -T31_ * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y, v1 = c1 * a1, s1 * a1, q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, x2_y, y2_x = c1 * c2, s1 * c2, c1 * s2
    y2_y, p2_x, p2_y = s1 * s2, p1_x + x2_x * a2, p1_y + x2_y * a2
    p2_z = d1 - s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, c2 * s3 - s2 * c3
    z3_x, z3_y, z3_z = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, c2 * c3 + s2 * s3
    p3_x, p3_y, p3_z = p2_x + x3_x * a3, p2_y + x3_y * a3, p2_z + x3_z * a3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    z4_x, z4_z, p4_x = s1 * c4 + x3_x * s4, x3_z * s4, p3_x - z3_x * d4
    p4_y, p4_z, z4_y = p3_y - z3_y * d4, p3_z - z3_z * d4, x3_y * s4 - c1 * c4
    v2 = q[4] + offset5
    c5, s5 = math.cos(v2), math.sin(v2)
    z5_x, z5_y = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5, (x3_y * c4 + c1 * s4) * s5 - z3_y * c5
    z5_z, J21, v3 = x3_z * c4 * s5 - z3_z * c5, p4_x - z5_x * d6, p4_y - z5_y * d6
    v4 = p4_z - z5_z * d6
    v5, v6, v7 = v4 - d1, v4 - p2_z, J21 - p3_x
    v8, v9, v10 = v3 - p3_y, v4 - p3_z, J21 - p4_x
    v11, v12 = v3 - p4_y, v4 - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -v3, c1 * v5, -(c1 * v6)
    J[0, 3], J[0, 4] = z3_y * v9 - z3_z * v8, z4_y * v12 - z4_z * v11
    J[0, 5] = z5_y * v12 - z5_z * v11
    J[1, 0], J[1, 1], J[1, 2] = J21, s1 * v5, -(s1 * v6)
    J[1, 3], J[1, 4] = z3_z * v7 - z3_x * v9, z4_z * v10 - z4_x * v12
    J[1, 5] = z5_z * v10 - z5_x * v12
    J[2, 1], J[2, 2] = -(s1 * (v3 - p1_y) + c1 * (J21 - p1_x)), s1 * (v3 - p2_y) + c1 * (J21 - p2_x)
    J[2, 3], J[2, 4] = z3_x * v8 - z3_y * v7, z4_x * v11 - z4_y * v10
    J[2, 5] = z5_x * v11 - z5_y * v10
    J[3, 1], J[3, 2], J[3, 3] = -s1, s1, z3_x
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = c1, -c1, z3_y
    J[4, 4], J[4, 5] = z4_y, z5_y
    J[5, 0], J[5, 3], J[5, 4] = 1.0, z3_z, z4_z
    J[5, 5] = z5_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[3, 4]
    t14 = T14 - d6 * T11
    Y1 = d6 * T21 - T24
    w1 = math.sqrt(t14 * t14 + Y1 * Y1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

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
        c1 = math.cos(seed[0]) if free1 else -(t14 * factor1)
        s1 = math.sin(seed[0]) if free1 else Y1 * factor1
        q1 = _atan2(s1, c1)

        # theta3
        v1 = w1 * e1 + a1
        N3 = v2 + v1 * v1
        K3 = N3 - k3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        v3, v4 = k1 * K3, k2 * K3

        # theta4, type 2: U4[3, 3]
        v6 = T11 * c1 + T21 * s1
        Y4 = T11 * s1 - T21 * c1
        v7 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v8, v9, v11 = T22 * c1 - T12 * s1, T12 * c1 + T22 * s1, T23 * c1 - T13 * s1
        v12 = T13 * c1 + T23 * s1

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            D3 = w3 * e3
            s3, c3 = (v3 + k2 * D3) * k4, k4 * (v4 - k1 * D3)
            q3 = _atan2(s3, c3)

            # theta2, type 3: U1[1, 4] and U1[2, 4]
            X1_2 = a3 * s3 - d4 * c3
            Y1_2 = a2 + (a3 * c3 + d4 * s3)
            v5 = v1 * X1_2 + Z1_3 * Y1_2
            C2 = Z1_3 * X1_2 - v1 * Y1_2
            w2 = math.sqrt(v5 * v5 + C2 * C2)
            factor2 = 1.0 / w2
            c2, s2 = C2 * factor2, -(v5 * factor2)

            # theta4
            c2m3 = c3 * c2 + s3 * s2
            s2m3 = c3 * s2 - s3 * c2
            X4 = c2m3 * v6 - T31 * s2m3
            w4 = math.sqrt(X4 * X4 + v7)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T31 * c2m3 + s2m3 * v6

            # theta6
            v10, v13 = T32 * s2m3 - c2m3 * v9, T33 * s2m3 - c2m3 * v12

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)
                s5 = w4 * e4

                # theta6
                c6, s6 = c4 * v8 + s4 * v10, c4 * v11 + s4 * v13
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
        t14, Y1 = T14 - d6 * T11, d6 * T21 - T24
        v1 = t14 * t14 + Y1 * Y1
        w1, v2 = math.sqrt(v1), 1.0 / v1

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        Z1_3, v3, v4 = T34 - d6 * T31 - d1, a1 + w1, a1 - w1
        v5 = Z1_3 * Z1_3
        N3_p, N3_m = v5 + v3 * v3, v5 + v4 * v4
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3)
        D3_squared_m, w3_p = (longest3 - N3_m) * (N3_m - shortest3), math.sqrt(D3_squared_p)
        w3_m = math.sqrt(D3_squared_m)

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        Y1_2_p, Y1_2_m = m4 * N3_p - m5, m4 * N3_m - m5
        v8, v9, v10 = Z1_3 * Y1_2_p, Z1_3 * Y1_2_m, m4 * Z1_3
        v11, v12, v13 = m4 * -Z1_3, v3 * -Y1_2_p, v4 * -Y1_2_m
        factor2_p, factor2_m = 1.0 / N3_p, 1.0 / N3_m

        # theta4, type 2: U4[3, 3]
        v14 = m6 * Z1_3
        v15, v16, v17 = m7 * v3 - v14, m7 * v4 - v14, m7 + m8 * factor2_p
        v18, v19, v20 = m7 + m8 * factor2_m, m6 + m9 * factor2_p, m6 + m9 * factor2_m
        v21, v22 = Z1_3 * v17 + v3 * v19, Z1_3 * v18 + v4 * v20
        c2m3_pp, c2m3_pm = w3_p * (factor2_p * v15) - v21, w3_p * (factor2_p * -v15) - v21
        c2m3_mp, c2m3_mm = w3_m * (factor2_m * v16) - v22, w3_m * (factor2_m * -v16) - v22
        v23, v24, v25 = m7 * Z1_3, v3 * v17 - Z1_3 * v19, v4 * v18 - Z1_3 * v20
        v26 = w3_p * (factor2_p * (v23 + m6 * v3))
        s2m3_pp, s2m3_pm, v27 = v24 + v26, v24 - v26, w3_m * (factor2_m * (v23 + m6 * v4))
        s2m3_mp, s2m3_mm, v28 = v25 + v27, v25 - v27, w1 * (v2 * (T21 * Y1 - T11 * t14))
        X4_pp, X4_pm = c2m3_pp * v28 - T31 * s2m3_pp, c2m3_pm * v28 - T31 * s2m3_pm
        v29, v30 = c2m3_mp * v28 + T31 * s2m3_mp, c2m3_mm * v28 + T31 * s2m3_mm
        Y4 = w1 * (v2 * (T11 * Y1 + t14 * T21))
        v31 = Y4 * Y4
        v32, v33, v34 = v31 + X4_pp * X4_pp, v31 + X4_pm * X4_pm, v31 + v29 * v29
        v35, v36, v37 = v31 + v30 * v30, math.copysign(half_turn, Y4), math.copysign(half_turn, -Y4)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v38, v39 = w1 * (v2 * (t14 * T22 + Y1 * T12)), w1 * (v2 * (Y1 * T22 - t14 * T12))
        v40, v41 = w1 * (v2 * (t14 * T23 + Y1 * T13)), w1 * (v2 * (Y1 * T23 - t14 * T13))
        v42 = Y4 * (s2m3_pp * T33 - c2m3_pp * v41) - -X4_pp * v40
        v43 = Y4 * (s2m3_pm * T33 - c2m3_pm * v41) - -X4_pm * v40
        v44 = v29 * v40 - Y4 * (s2m3_mp * T33 + c2m3_mp * v41)
        v45 = v30 * v40 - Y4 * (s2m3_mm * T33 + c2m3_mm * v41)

        # joint values
        v46 = w3_p * (m4 * v3)

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if v35 <= m10 or v34 <= m10 or v33 <= m10 or v32 <= m10 or abs(D3_squared_m) <= m3
            or v1 <= m1 or abs(D3_squared_p) <= m3 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = Y1, w3_p, w3_m
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v36, v37, v42
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = v43, v44, v45
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = Y1, w3_p, w3_m
        turns[3 * w + k], turns[4 * w + k], turns[5 * w + k] = Y4, Y4, -Y4
        turns[6 * w + k], turns[7 * w + k], turns[8 * w + k] = -Y4, v42, v43
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = v44, v45, -(v8 + v46)
        turns[12 * w + k], turns[13 * w + k] = v46 - v8, -(v9 + w3_m * (m4 * v4))
        turns[14 * w + k], turns[15 * w + k] = -(v9 + w3_m * (m4 * -v4)), math.sqrt(v32)
        turns[16 * w + k], turns[17 * w + k] = math.sqrt(v33), math.sqrt(v34)
        turns[18 * w + k], turns[24 * w + k], turns[25 * w + k] = math.sqrt(v35), -t14, N3_p - k3
        turns[26 * w + k], turns[27 * w + k], turns[28 * w + k] = N3_m - k3, -X4_pp, -X4_pm
        turns[29 * w + k], turns[30 * w + k] = v29, v30
        turns[31 * w + k] = Y4 * (s2m3_pp * T32 - c2m3_pp * v39) - -X4_pp * v38
        turns[32 * w + k] = Y4 * (s2m3_pm * T32 - c2m3_pm * v39) - -X4_pm * v38
        turns[33 * w + k] = v29 * v38 - Y4 * (s2m3_mp * T32 + c2m3_mp * v39)
        turns[34 * w + k] = v30 * v38 - Y4 * (s2m3_mm * T32 + c2m3_mm * v39)
        turns[35 * w + k], turns[36 * w + k] = v12 + w3_p * v10, v12 + w3_p * v11
        turns[37 * w + k], turns[38 * w + k] = v13 + w3_m * v10, v13 + w3_m * v11
        turns[39 * w + k] = T31 * c2m3_pp + s2m3_pp * v28
        turns[40 * w + k] = T31 * c2m3_pm + s2m3_pm * v28
        turns[41 * w + k] = T31 * c2m3_mp - s2m3_mp * v28
        turns[42 * w + k] = T31 * c2m3_mm - s2m3_mm * v28
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 19 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(19 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        Y1, w3_p, w3_m = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v36, v37, v42 = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v43, v44, v45 = kept[23 * w + k], kept[24 * w + k], kept[25 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5, angle6 = turns[3 * w + k], turns[4 * w + k], turns[5 * w + k]
        angle7, angle8, angle9 = turns[6 * w + k], turns[7 * w + k], turns[8 * w + k]
        angle10, angle11, angle12 = turns[9 * w + k], turns[10 * w + k], turns[11 * w + k]
        angle13, angle14, angle15 = turns[12 * w + k], turns[13 * w + k], turns[14 * w + k]
        angle16, angle17, angle18 = turns[15 * w + k], turns[16 * w + k], turns[17 * w + k]
        angle19 = turns[18 * w + k]

        # theta1, type 2: U1[3, 4]
        q1__m = angle1 - math.copysign(half_turn, Y1)

        # theta3, type 6: U1[2, 4] and U1[1, 4]
        q3__pp, v6, q3__mp = angle2 - turn1, turn1 + angle2, angle3 - turn1
        v7 = turn1 + angle3

        # theta4, type 2: U4[3, 3]
        q4_ppm, q4_pmm, q4_mpm = angle4 - v36, angle5 - v36, angle6 - v37
        q4_mmm = angle7 - v37

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle8 - math.copysign(half_turn, v42)
        q6_pmm = angle9 - math.copysign(half_turn, v43)
        q6_mpm = angle10 - math.copysign(half_turn, v44)
        q6_mmm = angle11 - math.copysign(half_turn, v45)

        # joint values
        v47, v48, v49 = angle12 - offset2, angle13 - offset2, angle14 - offset2
        v50 = angle15 - offset2
        q2_ppp = v47 + (-turn if half_turn < v47 else 0.0)
        q2_pmp = v48 + (-turn if half_turn < v48 else 0.0)
        q2_mpp = v49 + (-turn if half_turn < v49 else 0.0)
        q2_mmp = v50 + (-turn if half_turn < v50 else 0.0)
        v51, v52, v53 = angle16 - offset5, offset5 + angle16, angle17 - offset5
        v54, v55, v56 = offset5 + angle17, angle18 - offset5, offset5 + angle18
        v57, v58 = angle19 - offset5, offset5 + angle19
        q5_ppp = v51 + (turn if v51 <= -half_turn else 0.0)
        q5_ppm = (turn if -v52 <= -half_turn else 0.0) - v52
        q5_pmp = v53 + (turn if v53 <= -half_turn else 0.0)
        q5_pmm = (turn if -v54 <= -half_turn else 0.0) - v54
        q5_mpp = v55 + (turn if v55 <= -half_turn else 0.0)
        q5_mpm = (turn if -v56 <= -half_turn else 0.0) - v56
        q5_mmp = v57 + (turn if v57 <= -half_turn else 0.0)
        q5_mmm = (turn if -v58 <= -half_turn else 0.0) - v58
        v59 = q3__pp + (-turn if half_turn < q3__pp else 0.0)
        v60 = (-turn if half_turn < -v6 else 0.0) - v6
        v61 = q3__mp + (-turn if half_turn < q3__mp else 0.0)
        v62 = (-turn if half_turn < -v7 else 0.0) - v7
        v63, v64 = abs(angle1) - high1, abs(q1__m) - high1
        v65 = v59 + (turn if v59 < low3 else 0.0)
        v66 = v60 + (turn if v60 < low3 else 0.0)
        v67 = v61 + (turn if v61 < low3 else 0.0)
        v68 = v62 + (turn if v62 < low3 else 0.0)
        v69, v70 = max(low3 - v65, v65 - high3), max(low3 - v66, v66 - high3)
        v71, v72, v73 = max(low3 - v67, v67 - high3), max(low3 - v68, v68 - high3), low3 - v59
        v74, v75, v76 = low3 - v60, low3 - v61, low3 - v62
        v77 = v73 if v73 < v69 else v69
        v78 = v74 if v74 < v70 else v70
        v79 = v75 if v75 < v71 else v71
        v80 = v76 if v76 < v72 else v72
        q3_ppp = v59 if 0.0 < v77 else v65
        q3_pmp = v60 if 0.0 < v78 else v66
        q3_mpp = v61 if 0.0 < v79 else v67
        q3_mmp = v62 if 0.0 < v80 else v68
        q1_ppp, q1_mpp = angle1 + (w3_p - w3_p), q1__m + (w3_m - w3_m)
        v81 = max(v77, max(v63, max(low2 - q2_ppp, q2_ppp - high2)))
        v82 = max(v78, max(v63, max(low2 - q2_pmp, q2_pmp - high2)))
        v83 = max(v79, max(v64, max(low2 - q2_mpp, q2_mpp - high2)))
        v84 = max(v80, max(v64, max(low2 - q2_mmp, q2_mmp - high2)))
        excess_ppp, excess_ppm = max(v81, abs(q5_ppp) - high5), max(v81, abs(q5_ppm) - high5)
        excess_pmp, excess_pmm = max(v82, abs(q5_pmp) - high5), max(v82, abs(q5_pmm) - high5)
        excess_mpp, excess_mpm = max(v83, abs(q5_mpp) - high5), max(v83, abs(q5_mpm) - high5)
        excess_mmp, excess_mmm = max(v84, abs(q5_mmp) - high5), max(v84, abs(q5_mmm) - high5)
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
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle4, q5_ppp, angle8
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, q5_ppm, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q2_pmp, q3_pmp, angle5
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q5_pmp, angle9, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q5_pmm, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q2_mpp, q3_mpp, angle6
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = q5_mpp, angle10, q4_mpm
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q5_mpm, q6_mpm, q2_mmp
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q3_mmp, angle7, q5_mmp
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = angle11, q4_mmm, q5_mmm
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
_FORMULAS = _functions.Formulas(_formulas, 26, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 19, 20, 21, 22], [17, 18, 19, 23, 24, 25], [17, 26, 27, 28, 29, 30],
    [17, 26, 27, 31, 32, 33],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
