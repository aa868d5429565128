# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 221669a4b13488f8
"""kinova_j2s6s300: Kinova Jaco j2s6s300, spherical wrist.

Inverse kinematics, generated from robots/kinova_j2s6s300.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/kinova_j2s6s300.yaml. The formulas and where they come from:
kinova_j2s6s300.md.

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

NAME = "kinova_j2s6s300"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-6.283185307179586, 6.283185307179586), (0.8203047484373349, 5.462880558742252),
    (0.33161255787892263, 5.951572749300664), (-6.283185307179586, 6.283185307179586),
    (0.5235987755982988, 5.759586531581287), (-6.283185307179586, 6.283185307179586),
)
BRANCHES = (
    "left-down-noflip", "left-down-flip", "left-up-noflip", "left-up-flip", "right-up-noflip",
    "right-up-flip", "right-down-noflip", "right-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, reach_slack1 = 1.2733e-13 [m], merge_slack1 = 1.2733e-14 [m],
# arm_size1 = 1.2732999999999999 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.2755  # joint offset 1 [m]
d2 = 0.0016  # joint offset 2 [m]
a2 = 0.41  # link length 2 [m]
d3 = 0.0114  # joint offset 3 [m]
d4 = 0.31105  # joint offset 4 [m]
d6 = 0.26375  # joint offset 6 [m]
least_root1 = 4.026528144692397e-07  # a root of nothing, by rounding [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
longest3 = 0.5199131025  # square of the longest reach [m^2]
shortest3 = 0.009791102499999996  # square of the shortest reach [m^2]
boundary3 = 9.367415598763348e-14  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.5199131024999816  # the longest, where branches merge [m^2]
shortest3_apart = 0.009791102500002518  # the shortest, where branches merge [m^2]
offset2 = 1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset3 = 1.5707963267948966  # offset of joint 3 [rad]
offset6 = -1.5707963267948966  # offset of joint 6 [rad]
k1 = -0.0098  # d2 - d3 [m]
k2 = 9.604000000000001e-05  # k1^2 [m^2]
k3 = 2.495668000016213e-15  # reach_slack1 * (reach_slack1 - k1 * 2) [m^2]
k4 = 2.4956680000016213e-16  # merge_slack1 * (merge_slack1 - k1 * 2) [m^2]
k5 = 0.7853608733212912  # 1 / arm_size1 [m^-1]
k6 = 0.255061  # 2 * d4 * a2 [m^2]
k7 = 0.26485210249999996  # a2^2 + d4^2 [m^2]
k8 = 15.371345486276748  # 1 / (k6^2) [m^-4]
low2 = 0.820304747437335  # lowest value of joint 2, with what rounding adds [rad]
high2 = 5.462880559742252  # highest value of joint 2, with what rounding adds [rad]
low3 = 0.3316125568789226  # lowest value of joint 3, with what rounding adds [rad]
high3 = 5.951572750300664  # highest value of joint 3, with what rounding adds [rad]
low5 = 0.5235987745982988  # lowest value of joint 5, with what rounding adds [rad]
high5 = 5.759586532581287  # highest value of joint 5, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 2.4956680000016215e-13  # 1000 * k4 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 9.401396550145706e-12
m3 = 1.2195121951219514  # d4 * k6 * k8 [m^-1]
m4 = 0.08700963109756096  # a2 - d4 * k6 * k7 * k8 [m]
m5 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.7854, 0.7854, 0.7854, 1.0, 1.0, 1.0), size=1.2732999999999999,
    steps=(
        "keeps limits",
        "merges",
        "refines",
        "clamps",
        "clamps far",
        "range exceeds a turn",
        "follows seed",
    ),
    choosable=(3,),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (3.141592653589793, -0.2755, 0.0, 1.5707963267948966),
    (1.5707963267948966, -0.0016, 0.41, 3.141592653589793),
    (1.5707963267948966, -0.0114, 0.0, 1.5707963267948966),
    (0.0, -0.31105, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (-1.5707963267948966, -0.26375, 0.0, 3.141592653589793),
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
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, v8, x4_z = x3_x * c4 - s1 * s4, v6 * c4 + c1 * s4, x3_z * c4
    z4_x, z4_z, z4_y = s1 * c4 + x3_x * s4, x3_z * s4, c1 * c4 - v6 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, z3_y * s5 - v8 * c5, x4_z * c5 - v7 * s5
    z6_x, z6_y, z5_z = z3_x * c5 - x4_x * s5, z3_y * c5 + v8 * s5, v7 * c5 + x4_z * s5
    v9 = q[5] + offset6
    c6, s6 = math.cos(v9), math.sin(v9)
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + z4_x * s6, x5_x * s6 - z4_x * c6, z6_x
    T[0, 3] = x2_x * a2 - s1 * d2 + s1 * d3 - z3_x * d4 - -z6_x * d6
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + z4_y * s6, x5_y * s6 - z4_y * c6, z6_y
    T[1, 3] = c1 * d3 - (v3 * a2 + c1 * d2) - z3_y * d4 + z6_y * d6
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 + z4_z * s6, x5_z * s6 - z4_z * c6, -z5_z
    T[2, 3] = d1 - s2 * a2 + v7 * d4 - z5_z * d6
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
    v4, p2_z, p2_x = s1 * s2, d1 - s2 * a2, x2_x * a2 - s1 * d2
    v5, v6 = v3 * a2 + c1 * d2, q[2] + offset3
    c3, s3 = math.cos(v6), math.sin(v6)
    x3_x, v7, x3_z = x2_x * c3 + y2_x * s3, v3 * c3 + v4 * s3, c2 * s3 - s2 * c3
    v8, p3_x, p3_y = c2 * c3 + s2 * s3, p2_x + s1 * d3, c1 * d3 - v5
    z3_x, z3_y = x2_x * s3 - y2_x * c3, v4 * c3 - v3 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    z4_x, z4_z, p4_x = s1 * c4 + x3_x * s4, x3_z * s4, p3_x - z3_x * d4
    p4_y, p4_z, z4_y = p3_y - z3_y * d4, p2_z + v8 * d4, c1 * c4 - v7 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    z6_y, z5_z = z3_y * c5 + (v7 * c4 + c1 * s4) * s5, v8 * c5 + x3_z * c4 * s5
    z5_x = (x3_x * c4 - s1 * s4) * s5 - z3_x * c5
    p6_x, p6_y, p6_z = p4_x - z5_x * d6, p4_y + z6_y * d6, p4_z - z5_z * d6
    v9, v10, v11 = p6_z - d1, p6_z - p2_z, p6_x - p3_x
    v12, v13, v14 = p6_y - p3_y, p6_x - p4_x, p6_y - p4_y
    v15 = p6_z - p4_z
    J[0, 0], J[0, 1], J[0, 2] = p6_y, c1 * v9, -(c1 * v10)
    J[0, 3], J[0, 4] = z3_y * v10 + v8 * v12, z4_y * v15 - z4_z * v14
    J[0, 5] = -(z6_y * v15 + z5_z * v14)
    J[1, 0], J[1, 1], J[1, 2] = -p6_x, -(s1 * v9), s1 * v10
    J[1, 3], J[1, 4] = -(v8 * v11 + z3_x * v10), z4_z * v13 - z4_x * v15
    J[1, 5] = z5_z * v13 - z5_x * v15
    J[2, 1], J[2, 2] = s1 * p6_y - c1 * p6_x, c1 * (p6_x - p2_x) - s1 * (v5 + p6_y)
    J[2, 3], J[2, 4] = z3_x * v12 - z3_y * v11, z4_x * v14 - z4_y * v13
    J[2, 5] = z5_x * v14 + z6_y * v13
    J[3, 1], J[3, 2], J[3, 3] = s1, -s1, z3_x
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = c1, -c1, z3_y
    J[4, 4], J[4, 5] = z4_y, -z6_y
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
    N1 = X1 * X1 + wy * wy
    D1_squared = N1 - k2
    apart1 = k4 < D1_squared
    if not (-k3 <= D1_squared):
        return  # out of reach
    w1 = math.sqrt(D1_squared if apart1 else 0.0)
    v1 = (w1 if apart1 else least_root1) * k5
    inverse1 = 1.0 / (N1 if apart1 else -(k1 * math.sqrt(N1)))
    v2, v3 = X1 * k1, wy * k1

    # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = d6 * T33 - T34
    Z1_3 = wz + d1
    v4 = Z1_3 * Z1_3

    for i1 in range(2):  # left, right
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and not apart1:
            continue  # both signs give the same
        D1 = w1 * e1
        c1, s1 = inverse1 * (v3 - X1 * D1), inverse1 * (v2 + wy * D1)

        # theta3
        N3 = v4 + D1 * D1
        K3 = N3 - k7
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= v1 * D3_squared):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        v5 = k6 * K3 * k8

        # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        X1_2 = a2 + d4 * v5
        v6, v7 = Z1_3 * X1_2, D1 * X1_2

        # theta4, type 2: U4[3, 3]
        v8, v9 = T13 * c1 - T23 * s1, T23 * c1 + T13 * s1
        v10 = v9 * v9

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v11, v12, v14 = T22 * c1 + T12 * s1, T12 * c1 - T22 * s1, T21 * c1 + T11 * s1
        v15 = T11 * c1 - T21 * s1

        # joint values
        q1 = _wrap(_atan2(s1, c1) - offset1)

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            c3 = k8 * (k6 * (w3 * e3))

            # theta2
            X2_2 = d4 * c3
            S2 = v6 + D1 * X2_2
            C2 = v7 - Z1_3 * X2_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            factor2 = 1.0 / w2
            c2, s2 = C2 * factor2, S2 * factor2

            # theta4
            c2m3 = c3 * c2 - v5 * s2
            s2m3 = c3 * s2 + v5 * c2
            X4 = T33 * s2m3 - c2m3 * v8
            w4 = math.sqrt(X4 * X4 + v10)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta6
            v13, v16 = c2m3 * v12 - T32 * s2m3, c2m3 * v15 - T31 * s2m3

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(-v5, c3) - offset3)

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else -(v9 * factor4)
                q4 = _atan2(s4, c4)

                # theta5, type 3: U4[2, 3] and U4[1, 3]
                q5 = _atan2(-(w4 * e4), -(T33 * c2m3 + s2m3 * v8))

                # theta6
                s6 = c4 * v14 + s4 * v16

                # joint values
                q6 = _wrap(_atan2(s6, -(c4 * v11 + s4 * v13)) - offset6)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
                q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
                status[row] = FREE_JOINT if free4 else OK


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
        N1 = X1 * X1 + wy * wy
        D1_squared = N1 - k2
        w1 = math.sqrt(D1_squared)
        v1, inverse1 = w1 - w1, 1.0 / N1
        v2 = inverse1 * (k1 * wy)
        c1_p, c1_m, v3 = v2 - w1 * (X1 * inverse1), v2 - w1 * (inverse1 * -X1), inverse1 * (k1 * X1)
        s1_p, s1_m = v3 + w1 * (wy * inverse1), v3 + w1 * (inverse1 * -wy)

        # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        Z1_3 = d1 + (d6 * T33 - T34)
        N3 = D1_squared + Z1_3 * Z1_3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)
        v4, v5 = w3 - w3, k6 * (N3 - k7)
        v6, v7 = k8 * v5, k6 * w3
        c3 = k8 * v7

        # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        X1_2, X2_2 = a2 + d4 * v6, d4 * c3
        v8, v9 = Z1_3 * X1_2, w1 * X2_2
        v10, v11, v12 = v8 + v9, v8 - v9, m4 + m3 * N3
        v13, v14 = Z1_3 * v12, w3 * (m3 * w1)
        S2_pp, S2_pm, v15 = v13 + v14, v13 - v14, w1 * X1_2
        v16 = Z1_3 * X2_2
        v17, v18, v19 = v15 - v16, v15 + v16, w3 * (m3 * Z1_3)
        v20 = w1 * v12
        C2_pp, C2_pm, v21 = v20 - v19, v19 + v20, S2_pp * S2_pp
        v22, v23, v24 = v21 + C2_pp * C2_pp, S2_pm * S2_pm + C2_pm * C2_pm, v21 + -C2_pp * -C2_pp
        w2_pp, w2_pm, w2_mm = math.sqrt(v22), math.sqrt(v23), math.sqrt(v24)
        v25, v26, v27 = 1.0 / v22, 1.0 / v23, 1.0 / v24

        # theta4, type 2: U4[3, 3]
        v28 = v6 * v10
        c2m3_pp, v29 = w2_pp * (v25 * (c3 * v17 - v28)), w2_pm * (v26 * (c3 * v18 + v6 * v11))
        v30, v31 = w2_mm * (v27 * (v28 + c3 * -v17)), c3 * v10
        s2m3_pp, v32 = w2_pp * (v25 * (v31 + v6 * v17)), v6 * v18 - c3 * v11
        s2m3_pm, s2m3_mp = w2_pm * (v26 * v32), w2_pm * (v26 * -v32)
        s2m3_mm, v33 = w2_mm * (v27 * (v6 * -v17 - v31)), T13 * c1_p - T23 * s1_p
        v34, X4_pp = T13 * c1_m - T23 * s1_m, T33 * s2m3_pp - c2m3_pp * v33
        X4_pm, X4_mp = T33 * s2m3_pm + v29 * v33, T33 * s2m3_mp + v29 * v34
        X4_mm, v35 = T33 * s2m3_mm + v30 * v34, T23 * c1_p + T13 * s1_p
        v36, v37 = T23 * c1_m + T13 * s1_m, v35 * v35
        v38, v39, v40 = v36 * v36, v37 + X4_pp * X4_pp, v37 + X4_pm * X4_pm
        v41, v42, v43 = v38 + X4_mp * X4_mp, v38 + X4_mm * X4_mm, math.copysign(half_turn, -v35)
        v44 = math.copysign(half_turn, -v36)

        # theta5, type 3: U4[2, 3] and U4[1, 3]
        v45 = T33 * v29

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v46, v47, v48 = c1_p * T22 + s1_p * T12, c1_m * T22 + s1_m * T12, c1_p * T12 - s1_p * T22
        v49, v50, v51 = c1_m * T12 - s1_m * T22, c1_p * T21 + s1_p * T11, c1_m * T21 + s1_m * T11
        v52, v53 = c1_p * T11 - s1_p * T21, c1_m * T11 - s1_m * T21
        s6_pp = -X4_pp * v50 - v35 * (c2m3_pp * v52 - s2m3_pp * T31)
        s6_pm = v35 * (v29 * v52 + s2m3_pm * T31) - X4_pm * v50
        s6_mp = v36 * (v29 * v53 + s2m3_mp * T31) - X4_mp * v51
        s6_mm = v36 * (v30 * v53 + s2m3_mm * T31) - X4_mm * v51

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(D3_squared * (k5 * w1)) <= m2 or abs(D1_squared) <= m1 or v42 <= m5 or v41 <=
            m5 or v39 <= m5 or v40 <= m5 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = v1, v4, v5
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v43, v44, s6_pp
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = s6_pm, s6_mp, s6_mm
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = -v35, -v35, -v36
        turns[3 * w + k], turns[4 * w + k] = -v36, -math.sqrt(v39)
        turns[5 * w + k], turns[6 * w + k] = -math.sqrt(v40), -math.sqrt(v41)
        turns[7 * w + k], turns[8 * w + k], turns[9 * w + k] = -math.sqrt(v42), s1_p, s1_m
        turns[10 * w + k], turns[11 * w + k], turns[12 * w + k] = S2_pp, S2_pm, S2_pm
        turns[13 * w + k], turns[14 * w + k], turns[15 * w + k] = S2_pp, -v5, s6_pp
        turns[16 * w + k], turns[17 * w + k], turns[18 * w + k] = s6_pm, s6_mp, s6_mm
        turns[24 * w + k], turns[25 * w + k], turns[26 * w + k] = -X4_pp, -X4_pm, -X4_mp
        turns[27 * w + k], turns[28 * w + k] = -X4_mm, -(T33 * c2m3_pp + s2m3_pp * v33)
        turns[29 * w + k], turns[30 * w + k] = v45 - s2m3_pm * v33, v45 - s2m3_mp * v34
        turns[31 * w + k], turns[32 * w + k] = T33 * v30 - s2m3_mm * v34, c1_p
        turns[33 * w + k], turns[34 * w + k], turns[35 * w + k] = c1_m, C2_pp, C2_pm
        turns[36 * w + k], turns[37 * w + k], turns[38 * w + k] = -C2_pm, -C2_pp, v7
        turns[39 * w + k] = v35 * (c2m3_pp * v48 - s2m3_pp * T32) - -X4_pp * v46
        turns[40 * w + k] = X4_pm * v46 - v35 * (v29 * v48 + s2m3_pm * T32)
        turns[41 * w + k] = X4_mp * v47 - v36 * (v29 * v49 + s2m3_mp * T32)
        turns[42 * w + k] = X4_mm * v47 - v36 * (v30 * v49 + s2m3_mm * T32)
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 19 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(19 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        v1, v4, v5 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v43, v44, s6_pp = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        s6_pm, s6_mp, s6_mm = kept[23 * w + k], kept[24 * w + k], kept[25 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5, angle6 = turns[3 * w + k], turns[4 * w + k], turns[5 * w + k]
        angle7, angle8, angle9 = turns[6 * w + k], turns[7 * w + k], turns[8 * w + k]
        angle10, angle11, angle12 = turns[9 * w + k], turns[10 * w + k], turns[11 * w + k]
        angle13, angle14, angle15 = turns[12 * w + k], turns[13 * w + k], turns[14 * w + k]
        angle16, angle17, angle18 = turns[15 * w + k], turns[16 * w + k], turns[17 * w + k]
        angle19 = turns[18 * w + k]

        # theta4, type 2: U4[3, 3]
        q4_ppm, q4_pmm, q4_mpm = angle1 - v43, angle2 - v43, angle3 - v44
        q4_mmm = angle4 - v44

        # joint values
        v54, v55, v56 = angle9 - offset1, angle10 - offset1, angle11 - offset2
        v57, v58, v59 = angle12 - offset2, angle13 - offset2, angle14 - offset2
        q2__pp = v56 + (turn if v56 <= -half_turn else 0.0)
        q2__pm = v57 + (turn if v57 <= -half_turn else 0.0)
        q2__mp = v58 + (turn if v58 <= -half_turn else 0.0)
        q2__mm = v59 + (turn if v59 <= -half_turn else 0.0)
        v60, v61 = angle15 - offset3, math.copysign(half_turn, -v5) - angle15 - offset3
        q3__p = v60 + (turn if v60 <= -half_turn else 0.0)
        q3__m = v61 + (turn if v61 <= -half_turn else 0.0)
        v62, v63 = angle16 - offset6, angle16 - math.copysign(half_turn, s6_pp) - offset6
        v64, v65 = angle17 - offset6, angle17 - math.copysign(half_turn, s6_pm) - offset6
        v66, v67 = angle18 - offset6, angle18 - math.copysign(half_turn, s6_mp) - offset6
        v68, v69 = angle19 - offset6, angle19 - math.copysign(half_turn, s6_mm) - offset6
        q6_ppp = v62 + (-turn if half_turn < v62 else 0.0)
        q6_ppm = v63 + (-turn if half_turn < v63 else 0.0)
        q6_pmp = v64 + (-turn if half_turn < v64 else 0.0)
        q6_pmm = v65 + (-turn if half_turn < v65 else 0.0)
        q6_mpp = v66 + (-turn if half_turn < v66 else 0.0)
        q6_mpm = v67 + (-turn if half_turn < v67 else 0.0)
        q6_mmp = v68 + (-turn if half_turn < v68 else 0.0)
        q6_mmm = v69 + (-turn if half_turn < v69 else 0.0)
        v70 = q2__pp + (turn if q2__pp < low2 else 0.0)
        v71 = q2__pm + (turn if q2__pm < low2 else 0.0)
        v72 = q2__mp + (turn if q2__mp < low2 else 0.0)
        v73 = q2__mm + (turn if q2__mm < low2 else 0.0)
        v74, v75 = max(low2 - v70, v70 - high2), max(low2 - v71, v71 - high2)
        v76, v77, v78 = max(low2 - v72, v72 - high2), max(low2 - v73, v73 - high2), low2 - q2__pp
        v79, v80, v81 = low2 - q2__pm, low2 - q2__mp, low2 - q2__mm
        v82 = v78 if v78 < v74 else v74
        v83 = v79 if v79 < v75 else v75
        v84 = v80 if v80 < v76 else v76
        v85 = v81 if v81 < v77 else v77
        q2_ppp = q2__pp if 0.0 < v82 else v70
        q2_pmp = q2__pm if 0.0 < v83 else v71
        q2_mpp = q2__mp if 0.0 < v84 else v72
        q2_mmp = q2__mm if 0.0 < v85 else v73
        v86 = q3__p + (turn if q3__p < low3 else 0.0)
        v87 = q3__m + (turn if q3__m < low3 else 0.0)
        v88, v89, v90 = max(low3 - v86, v86 - high3), max(low3 - v87, v87 - high3), low3 - q3__p
        v91 = low3 - q3__m
        v92 = v90 if v90 < v88 else v88
        v93 = v91 if v91 < v89 else v89
        v94 = angle5 + (turn if angle5 < low5 else 0.0)
        v95 = (turn if -angle5 < low5 else 0.0) - angle5
        v96 = angle6 + (turn if angle6 < low5 else 0.0)
        v97 = (turn if -angle6 < low5 else 0.0) - angle6
        v98 = angle7 + (turn if angle7 < low5 else 0.0)
        v99 = (turn if -angle7 < low5 else 0.0) - angle7
        v100 = angle8 + (turn if angle8 < low5 else 0.0)
        v101 = (turn if -angle8 < low5 else 0.0) - angle8
        v102, v103 = max(low5 - v94, v94 - high5), max(low5 - v95, v95 - high5)
        v104, v105 = max(low5 - v96, v96 - high5), max(low5 - v97, v97 - high5)
        v106, v107 = max(low5 - v98, v98 - high5), max(low5 - v99, v99 - high5)
        v108, v109 = max(low5 - v100, v100 - high5), max(low5 - v101, v101 - high5)
        v110, v111, v112 = low5 - angle5, low5 + angle5, low5 - angle6
        v113, v114, v115 = low5 + angle6, low5 - angle7, low5 + angle7
        v116, v117 = low5 - angle8, low5 + angle8
        v118 = v110 if v110 < v102 else v102
        v119 = v111 if v111 < v103 else v103
        v120 = v112 if v112 < v104 else v104
        v121 = v113 if v113 < v105 else v105
        v122 = v114 if v114 < v106 else v106
        v123 = v115 if v115 < v107 else v107
        v124 = v116 if v116 < v108 else v108
        v125 = v117 if v117 < v109 else v109
        q5_ppp = angle5 if 0.0 < v118 else v94
        q5_ppm = -angle5 if 0.0 < v119 else v95
        q5_pmp = angle6 if 0.0 < v120 else v96
        q5_pmm = -angle6 if 0.0 < v121 else v97
        q5_mpp = angle7 if 0.0 < v122 else v98
        q5_mpm = -angle7 if 0.0 < v123 else v99
        q5_mmp = angle8 if 0.0 < v124 else v100
        q5_mmm = -angle8 if 0.0 < v125 else v101
        q1_ppp = v4 + (v54 + (turn if v54 <= -half_turn else 0.0))
        q1_mpp = v4 + (v55 + (turn if v55 <= -half_turn else 0.0))
        q3_ppp = v1 + (q3__p if 0.0 < v92 else v86)
        q3_pmp = v1 + (q3__m if 0.0 < v93 else v87)
        v126, v127, v128 = max(v82, v92), max(v83, v93), max(v84, v92)
        v129, excess_ppp, excess_ppm = max(v85, v93), max(v118, v126), max(v119, v126)
        excess_pmp, excess_pmm, excess_mpp = max(v120, v127), max(v121, v127), max(v122, v128)
        excess_mpm, excess_mmp, excess_mmm = max(v123, v128), max(v124, v129), max(v125, v129)
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
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle1, q5_ppp, q6_ppp
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, q5_ppm, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q2_pmp, q3_pmp, angle2
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q5_pmp, q6_pmp, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q5_pmm, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q2_mpp, angle3, q5_mpp
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = q6_mpp, q4_mpm, q5_mpm
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q6_mpm, q2_mmp, angle4
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
_FORMULAS = _functions.Formulas(_formulas, 26, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 2, 19, 20, 21], [17, 18, 2, 22, 23, 24], [17, 25, 10, 26, 27, 28],
    [17, 25, 10, 29, 30, 31],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
