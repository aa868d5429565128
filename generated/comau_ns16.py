# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 662c5aef5c1d86d9
"""comau_ns16: Comau NS 16 Hand.

Inverse kinematics, generated from robots/comau_ns16.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/comau_ns16.yaml. The formulas and where they come from: comau_ns16.md.

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

NAME = "comau_ns16"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-3.14159, 3.14159), (-0.87266, 1.658), (-2.967, 1.9198), (-6.2831853, 6.2831853),
    (-3.14159, 3.14159), (-6.2831853, 6.2831853),
)
BRANCHES = (
    "front-down-noflip", "front-down-flip", "front-up-noflip", "front-up-flip", "back-up-noflip",
    "back-up-flip", "back-down-noflip", "back-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, reach_slack1 = 2.7459999999999996e-13 [m],
# merge_slack1 = 2.7459999999999994e-14 [m], arm_size1 = 2.7459999999999996 [m],
# doubt_limit = 9.999999999999999e-05.
d1 = 0.6  # joint offset 1 [m]
a1 = 0.3  # link length 1 [m]
d2 = 0.101  # joint offset 2 [m]
a2 = 0.7  # link length 2 [m]
d3 = 0.101  # joint offset 3 [m]
a3 = 0.185  # link length 3 [m]
d4 = 0.624  # joint offset 4 [m]
d6 = 0.135  # joint offset 6 [m]
free_limit_squared2 = 7.540515999999996e-24  # square of a length that fixes no angle [m^2]
least_root1 = 8.683614454822367e-07  # a root of nothing, by rounding [m]
longest3 = 1.824785920858549  # square of the longest reach [m^2]
shortest3 = 0.00241607914145111  # square of the shortest reach [m^2]
boundary3 = 1.352331582498372e-12  # rounding at the boundary of the workspace [m^4]
longest3_apart = 1.8247859208584747  # the longest, where branches merge [m^2]
shortest3_apart = 0.0024160791414538094  # the shortest, where branches merge [m^2]
offset2 = -1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset3 = 1.5707963267948966  # offset of joint 3 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
offset6 = 3.141592653589793  # offset of joint 6 [rad]
k1 = 0.0  # d2 - d3 [m]
k2 = 7.540515999999998e-26  # reach_slack1 * (d2 - d3 + reach_slack1) [m^2]
k3 = 7.540515999999996e-28  # merge_slack1 * (d2 - d3 + merge_slack1) [m^2]
k4 = 0.36416605972323385  # 1 / arm_size1 [m^-1]
k5 = 0.8735999999999999  # 2 * d4 * a2 [m^2]
k6 = 0.259  # 2 * a3 * a2 [m^2]
k7 = 0.9136009999999999  # a2^2 + (a3^2 + d4^2) [m^2]
k8 = 1.204444941425193  # 1 / (k5^2 + k6^2) [m^-4]
doubt_limit_squared2 = 7.540515999999996e-08  # square of a length that fixes no angle [m^2]
turn1 = -1.2825771957649381  # atan2(-k5, k6) [rad]
high1 = 3.141590001  # highest value of joint 1, with what rounding adds [rad]
low2 = -0.872660001  # lowest value of joint 2, with what rounding adds [rad]
high2 = 1.658000001  # highest value of joint 2, with what rounding adds [rad]
low3 = -2.967000001  # lowest value of joint 3, with what rounding adds [rad]
high3 = 1.919800001  # highest value of joint 3, with what rounding adds [rad]
high5 = 3.141590001  # highest value of joint 5, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 7.540515999999996e-25  # 1000 * k3 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 1.355568761630017e-10
m3 = 0.7142857142857144  # k8 * (d4 * k5 + a3 * k6) [m^-1]
m4 = 0.047427857142857084  # a2 - d4 * k5 * k7 * k8 - a3 * k6 * k7 * k8 [m]
m5 = 0.21836586788038748  # a2 * k6 * k8 [m^-1]
m6 = 0.7365421705803339  # a2 * k5 * k8 [m^-1]
# k5 * k8 * (a2 * k7 + d4 * longest3 * shortest3 * k5 * k8 + a3 * longest3 * shortest3 * k6 * k8 -
# d4 * k5 * k7^2 * k8 - a3 * k6 * k7^2 * k8) [m]
m7 = 0.04890566358436353
# k6 * k8 * (a2 * k7 + d4 * longest3 * shortest3 * k5 * k8 + a3 * longest3 * shortest3 * k6 * k8 -
# d4 * k5 * k7^2 * k8 - a3 * k6 * k7^2 * k8) [m]
m8 = 0.01449927526138983
m9 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.3642, 0.3642, 0.3642, 1.0, 1.0, 1.0), size=2.7459999999999996,
    steps=(
        "keeps limits",
        "merges",
        "refines",
        "clamps",
        "clamps far",
        "range exceeds a turn",
        "follows seed",
    ),
    choosable=(3, 0),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, -0.6, 0.3, 1.5707963267948966),
    (-1.5707963267948966, -0.101, 0.7, 3.141592653589793),
    (1.5707963267948966, -0.101, 0.185, -1.5707963267948966),
    (3.141592653589793, -0.624, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (3.141592653589793, -0.135, 0.0, 3.141592653589793),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    base=(1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1, v1 = math.cos(q[0]), math.sin(q[0]), q[1] + offset2
    c2, s2 = math.cos(v1), math.sin(v1)
    x2_x, v2, y2_x = c1 * c2, s1 * c2, c1 * s2
    v3, v4 = s1 * s2, q[2] + offset3
    c3, s3 = math.cos(v4), math.sin(v4)
    x3_x, v5, x3_z = x2_x * c3 + y2_x * s3, v2 * c3 + v3 * s3, c2 * s3 - s2 * c3
    z3_x, z3_y, z3_z = y2_x * c3 - x2_x * s3, v2 * s3 - v3 * c3, c2 * c3 + s2 * s3
    v6 = q[3] + offset4
    c4, s4 = math.cos(v6), math.sin(v6)
    x4_x, x4_y, x4_z = x3_x * c4 + s1 * s4, c1 * s4 - v5 * c4, x3_z * c4
    v7, z4_z, z4_x = c1 * c4 + v5 * s4, x3_z * s4, x3_x * s4 - s1 * c4
    v8 = q[4] + offset5
    c5, s5 = math.cos(v8), math.sin(v8)
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, x4_y * c5 + z3_y * s5, x4_z * c5 + z3_z * s5
    z6_x, z6_y, z6_z = z3_x * c5 - x4_x * s5, z3_y * c5 - x4_y * s5, z3_z * c5 - x4_z * s5
    v9 = q[5] + offset6
    c6, s6 = math.cos(v9), math.sin(v9)
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + z4_x * s6, x5_x * s6 - z4_x * c6, z6_x
    T[0, 3] = c1 * a1 + x2_x * a2 - s1 * d2 + x3_x * a3 + s1 * d3 - z3_x * d4 - -z6_x * d6
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 - v7 * s6, v7 * c6 + x5_y * s6, z6_y
    T[1, 3] = c1 * d3 - (s1 * a1 + v2 * a2 + c1 * d2 + v5 * a3) - z3_y * d4 - -z6_y * d6
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 + z4_z * s6, x5_z * s6 - z4_z * c6, z6_z
    T[2, 3] = d1 - s2 * a2 + x3_z * a3 - z3_z * d4 - -z6_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, v1, v2 = c1 * a1, s1 * a1, q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, v3, y2_x = c1 * c2, s1 * c2, c1 * s2
    v4, p2_z, p2_x = s1 * s2, d1 - s2 * a2, p1_x + x2_x * a2 - s1 * d2
    v5, v6 = v1 + v3 * a2 + c1 * d2, q[2] + offset3
    c3, s3 = math.cos(v6), math.sin(v6)
    x3_x, v7, x3_z = x2_x * c3 + y2_x * s3, v3 * c3 + v4 * s3, c2 * s3 - s2 * c3
    z3_x, z3_y, z3_z = y2_x * c3 - x2_x * s3, v3 * s3 - v4 * c3, c2 * c3 + s2 * s3
    p3_z, p3_x, p3_y = p2_z + x3_z * a3, p2_x + x3_x * a3 + s1 * d3, c1 * d3 - (v5 + v7 * a3)
    v8 = q[3] + offset4
    c4, s4 = math.cos(v8), math.sin(v8)
    v9, z4_z, p4_x = c1 * c4 + v7 * s4, x3_z * s4, p3_x - z3_x * d4
    p4_y, p4_z, z4_x = p3_y - z3_y * d4, p3_z - z3_z * d4, x3_x * s4 - s1 * c4
    v10 = q[4] + offset5
    c5, s5 = math.cos(v10), math.sin(v10)
    z5_x, z5_y = (x3_x * c4 + s1 * s4) * s5 - z3_x * c5, (c1 * s4 - v7 * c4) * s5 - z3_y * c5
    z5_z, p6_x, p6_y = x3_z * c4 * s5 - z3_z * c5, p4_x - z5_x * d6, p4_y - z5_y * d6
    p6_z = p4_z - z5_z * d6
    v11, v12, v13 = p6_z - d1, p6_z - p2_z, p6_x - p3_x
    v14, v15, v16 = p6_y - p3_y, p6_z - p3_z, p6_x - p4_x
    v17, v18 = p6_y - p4_y, p6_z - p4_z
    J[0, 0], J[0, 1], J[0, 2] = p6_y, c1 * v11, -(c1 * v12)
    J[0, 3], J[0, 4] = z3_y * v15 - z3_z * v14, -(v9 * v18 + z4_z * v17)
    J[0, 5] = z5_y * v18 - z5_z * v17
    J[1, 0], J[1, 1], J[1, 2] = -p6_x, -(s1 * v11), s1 * v12
    J[1, 3], J[1, 4] = z3_z * v13 - z3_x * v15, z4_z * v16 - z4_x * v18
    J[1, 5] = z5_z * v16 - z5_x * v18
    J[2, 1], J[2, 2] = s1 * (v1 + p6_y) - c1 * (p6_x - p1_x), c1 * (p6_x - p2_x) - s1 * (v5 + p6_y)
    J[2, 3], J[2, 4] = z3_x * v14 - z3_y * v13, z4_x * v17 + v9 * v16
    J[2, 5] = z5_x * v17 - z5_y * v16
    J[3, 1], J[3, 2], J[3, 3] = s1, -s1, z3_x
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = c1, -c1, z3_y
    J[4, 4], J[4, 5] = -v9, z5_y
    J[5, 0], J[5, 3], J[5, 4] = -1.0, z3_z, z4_z
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
    free1 = N1 <= free_limit_squared2
    D1_squared = N1 - k1
    apart1 = k3 < D1_squared
    if not (-k2 <= D1_squared):
        return  # out of reach
    w1 = math.sqrt(D1_squared if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else k1 * math.sqrt(N1)))
    v1, v2 = X1 * k1, wy * k1

    # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = d6 * T33 - T34
    Z1_3 = wz + d1
    v3 = Z1_3 * Z1_3
    v4 = 1.0 if free1 else (w1 if apart1 else least_root1) * k4

    # theta4, type 2: U4[3, 3]
    v9 = seed[3] + offset4

    for i1 in range(2):  # front, back
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        D1 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else inverse1 * (v2 - X1 * D1)
        s1 = math.sin(seed[0]) if free1 else inverse1 * (v1 + wy * D1)
        q1 = _atan2(s1, c1)

        # theta3
        Z2_3 = D1 - a1
        N3 = v3 + Z2_3 * Z2_3
        K3 = N3 - k7
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= D3_squared * v4):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        v5, v6 = k5 * K3, k6 * K3

        # theta4
        v7 = T13 * c1 - T23 * s1
        Y4 = T23 * c1 + T13 * s1
        v8 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v10, v11, v13 = T22 * c1 + T12 * s1, T12 * c1 - T22 * s1, T21 * c1 + T11 * s1
        v14 = T11 * c1 - T21 * s1

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            D3 = w3 * e3
            s3, c3 = (v5 + k6 * D3) * k8, k8 * (v6 - k5 * D3)

            # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
            X1_2 = a2 + (a3 * c3 + d4 * s3)
            Y1_2 = d4 * c3 - a3 * s3
            S2 = Z1_3 * X1_2 - Z2_3 * Y1_2
            C2 = Z2_3 * X1_2 - Z1_3 * -Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            factor2 = 1.0 / w2
            c2, s2 = C2 * factor2, S2 * factor2

            # theta4
            c2m3 = c3 * c2 + s3 * s2
            s2m3 = c3 * s2 - s3 * c2
            X4 = T33 * s2m3 - c2m3 * v7
            w4 = math.sqrt(X4 * X4 + v8)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T33 * c2m3 + s2m3 * v7

            # theta6
            v12, v15 = c2m3 * v11 - T32 * s2m3, c2m3 * v14 - T31 * s2m3

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(s3, c3) - offset3)

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(v9) if free4 else -(X4 * factor4)
                s4 = math.sin(v9) if free4 else Y4 * factor4

                # theta6
                s6, c6 = s4 * v15 - c4 * v13, c4 * v10 - s4 * v12

                # joint values
                q4 = _wrap(_atan2(s4, c4) - offset4)
                q5 = _wrap(_atan2(-(w4 * e4), c5) - offset5)
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
        N1 = X1 * X1 + wy * wy
        D1_squared = N1 - k1
        w1, inverse1 = math.sqrt(D1_squared), 1.0 / N1
        v1 = inverse1 * (k1 * wy)
        c1_p, c1_m, v2 = v1 - w1 * (X1 * inverse1), v1 - w1 * (inverse1 * -X1), inverse1 * (k1 * X1)
        s1_p, s1_m = v2 + w1 * (wy * inverse1), v2 + w1 * (inverse1 * -wy)

        # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        Z1_3, Z2_3_p, v3 = d1 + (d6 * T33 - T34), w1 - a1, a1 + w1
        v4 = Z1_3 * Z1_3
        N3_p, N3_m = v4 + Z2_3_p * Z2_3_p, v4 + v3 * v3
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3)
        D3_squared_m, v5 = (longest3 - N3_m) * (N3_m - shortest3), k4 * w1
        w3_p, w3_m = math.sqrt(D3_squared_p), math.sqrt(D3_squared_m)

        # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        X1_2_p, X1_2_m = m4 + m3 * N3_p, m4 + m3 * N3_m
        v6, v7, v8 = Z1_3 * X1_2_p, Z1_3 * X1_2_m, Z2_3_p * X1_2_p
        v9, v10, factor2_p = v3 * X1_2_m, m3 * Z1_3, 1.0 / N3_p
        factor2_m = 1.0 / N3_m

        # theta4, type 2: U4[3, 3]
        v11 = m5 * Z1_3
        v12, v13, v14 = v11 - m6 * Z2_3_p, m6 - m7 * factor2_p, m6 - m7 * factor2_m
        v15, v16 = m5 - m8 * factor2_p, m5 - m8 * factor2_m
        v17, v18 = Z1_3 * v13 + Z2_3_p * v15, Z1_3 * v14 - v3 * v16
        c2m3_pp, c2m3_pm = v17 + w3_p * (factor2_p * v12), v17 + w3_p * (factor2_p * -v12)
        v19 = w3_m * (factor2_m * (v11 + m6 * v3))
        c2m3_mp, c2m3_mm, v20 = v18 + v19, v18 - v19, m6 * Z1_3
        v21, v22, v23 = v20 - m5 * v3, Z1_3 * v15 + Z2_3_p * -v13, Z1_3 * v16 - v3 * -v14
        v24 = w3_p * (factor2_p * (v20 + m5 * Z2_3_p))
        s2m3_pp, s2m3_pm, s2m3_mp = v22 - v24, v22 + v24, v23 - w3_m * (factor2_m * v21)
        s2m3_mm, v25 = v23 - w3_m * (factor2_m * -v21), T13 * c1_p - T23 * s1_p
        v26, X4_pp = T13 * c1_m - T23 * s1_m, T33 * s2m3_pp - c2m3_pp * v25
        X4_pm, X4_mp = T33 * s2m3_pm - c2m3_pm * v25, T33 * s2m3_mp - c2m3_mp * v26
        X4_mm, Y4_p = T33 * s2m3_mm - c2m3_mm * v26, T23 * c1_p + T13 * s1_p
        Y4_m, v27 = T23 * c1_m + T13 * s1_m, Y4_p * Y4_p
        v28, v29, v30 = Y4_m * Y4_m, v27 + X4_pp * X4_pp, v27 + X4_pm * X4_pm
        v31, v32 = v28 + X4_mp * X4_mp, v28 + X4_mm * X4_mm

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v33, v34, v35 = c1_p * T22 + s1_p * T12, c1_m * T22 + s1_m * T12, c1_p * T12 - s1_p * T22
        v36, v37, v38 = c1_m * T12 - s1_m * T22, c1_p * T21 + s1_p * T11, c1_m * T21 + s1_m * T11
        v39, v40 = c1_p * T11 - s1_p * T21, c1_m * T11 - s1_m * T21
        s6_pp = Y4_p * (c2m3_pp * v39 - s2m3_pp * T31) - v37 * -X4_pp
        s6_pm = Y4_p * (c2m3_pm * v39 - s2m3_pm * T31) - v37 * -X4_pm
        s6_mp = Y4_m * (c2m3_mp * v40 - s2m3_mp * T31) - v38 * -X4_mp
        s6_mm = Y4_m * (c2m3_mm * v40 - s2m3_mm * T31) - v38 * -X4_mm

        # joint values
        v41, v44, v45 = w3_p * v10, w3_m * (m3 * v3), w3_m * v10
        v52, v53 = math.copysign(half_turn, Y4_p), math.copysign(half_turn, Y4_m)

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(D1_squared) <= m1 or N1 <= doubt_limit_squared2 or v32 <= m9 or v31 <= m9 or
            v30 <= m9 or v29 <= m9 or abs(D3_squared_p * v5) <= m2 or abs(D3_squared_m * v5) <= m2
            else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = w3_p, w3_m, s6_pp
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = s6_pm, s6_mp, s6_mm
        kept[23 * w + k], kept[24 * w + k], turns[0 * w + k] = v52, v53, s1_p
        turns[1 * w + k], turns[2 * w + k] = s1_m, v6 + w3_p * (m3 * Z2_3_p)
        turns[3 * w + k], turns[4 * w + k] = v6 + w3_p * (m3 * -Z2_3_p), v7 - v44
        turns[5 * w + k], turns[6 * w + k], turns[7 * w + k] = v7 + v44, w3_p, w3_m
        turns[8 * w + k], turns[9 * w + k], turns[10 * w + k] = Y4_p, Y4_p, Y4_m
        turns[11 * w + k], turns[12 * w + k] = Y4_m, -math.sqrt(v29)
        turns[13 * w + k], turns[14 * w + k] = -math.sqrt(v30), -math.sqrt(v31)
        turns[15 * w + k], turns[16 * w + k], turns[17 * w + k] = -math.sqrt(v32), s6_pp, s6_pm
        turns[18 * w + k], turns[19 * w + k], turns[24 * w + k] = s6_mp, s6_mm, c1_p
        turns[25 * w + k], turns[26 * w + k], turns[27 * w + k] = c1_m, v8 - v41, v8 + v41
        turns[28 * w + k], turns[29 * w + k], turns[30 * w + k] = -(v9 + v45), v45 - v9, N3_p - k7
        turns[31 * w + k], turns[32 * w + k], turns[33 * w + k] = N3_m - k7, -X4_pp, -X4_pm
        turns[34 * w + k], turns[35 * w + k] = -X4_mp, -X4_mm
        turns[36 * w + k] = T33 * c2m3_pp + s2m3_pp * v25
        turns[37 * w + k] = T33 * c2m3_pm + s2m3_pm * v25
        turns[38 * w + k] = T33 * c2m3_mp + s2m3_mp * v26
        turns[39 * w + k] = T33 * c2m3_mm + s2m3_mm * v26
        turns[40 * w + k] = v33 * -X4_pp - Y4_p * (c2m3_pp * v35 - s2m3_pp * T32)
        turns[41 * w + k] = v33 * -X4_pm - Y4_p * (c2m3_pm * v35 - s2m3_pm * T32)
        turns[42 * w + k] = v34 * -X4_mp - Y4_m * (c2m3_mp * v36 - s2m3_mp * T32)
        turns[43 * w + k] = v34 * -X4_mm - Y4_m * (c2m3_mm * v36 - s2m3_mm * T32)
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 20 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(20 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        w3_p, w3_m, s6_pp = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        s6_pm, s6_mp, s6_mm = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v52, v53, angle1 = kept[23 * w + k], kept[24 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle8, angle9, angle10 = turns[7 * w + k], turns[8 * w + k], turns[9 * w + k]
        angle11, angle12, angle13 = turns[10 * w + k], turns[11 * w + k], turns[12 * w + k]
        angle14, angle15, angle16 = turns[13 * w + k], turns[14 * w + k], turns[15 * w + k]
        angle17, angle18, angle19 = turns[16 * w + k], turns[17 * w + k], turns[18 * w + k]
        angle20 = turns[19 * w + k]

        # joint values
        v42, v43, v46 = angle3 - offset2, angle4 - offset2, angle5 - offset2
        v47 = angle6 - offset2
        q2_ppp = v42 + (-turn if half_turn < v42 else 0.0)
        q2_pmp = v43 + (-turn if half_turn < v43 else 0.0)
        q2_mpp = v46 + (-turn if half_turn < v46 else 0.0)
        q2_mmp = v47 + (-turn if half_turn < v47 else 0.0)
        v48, v49 = angle7 - turn1 - offset3, offset3 + (turn1 + angle7)
        v50, v51 = angle8 - turn1 - offset3, offset3 + (turn1 + angle8)
        q3_ppp = v48 + (turn if v48 <= -half_turn else 0.0)
        q3_pmp = (turn if -v49 <= -half_turn else 0.0) - v49
        q3_mpp = v50 + (turn if v50 <= -half_turn else 0.0)
        q3_mmp = (turn if -v51 <= -half_turn else 0.0) - v51
        v54, v55, v56 = angle9 - offset4, angle9 - v52 - offset4, angle10 - offset4
        v57, v58, v59 = angle10 - v52 - offset4, angle11 - offset4, angle11 - v53 - offset4
        v60, v61 = angle12 - offset4, angle12 - v53 - offset4
        q4_ppp = v54 + (turn if v54 <= -half_turn else 0.0)
        q4_ppm = v55 + (turn if v55 <= -half_turn else 0.0)
        q4_pmp = v56 + (turn if v56 <= -half_turn else 0.0)
        q4_pmm = v57 + (turn if v57 <= -half_turn else 0.0)
        q4_mpp = v58 + (turn if v58 <= -half_turn else 0.0)
        q4_mpm = v59 + (turn if v59 <= -half_turn else 0.0)
        q4_mmp = v60 + (turn if v60 <= -half_turn else 0.0)
        q4_mmm = v61 + (turn if v61 <= -half_turn else 0.0)
        v62, v63, v64 = angle13 - offset5, offset5 + angle13, angle14 - offset5
        v65, v66, v67 = offset5 + angle14, angle15 - offset5, offset5 + angle15
        v68, v69 = angle16 - offset5, offset5 + angle16
        q5_ppp = v62 + (turn if v62 <= -half_turn else 0.0)
        q5_ppm = (turn if -v63 <= -half_turn else 0.0) - v63
        q5_pmp = v64 + (turn if v64 <= -half_turn else 0.0)
        q5_pmm = (turn if -v65 <= -half_turn else 0.0) - v65
        q5_mpp = v66 + (turn if v66 <= -half_turn else 0.0)
        q5_mpm = (turn if -v67 <= -half_turn else 0.0) - v67
        q5_mmp = v68 + (turn if v68 <= -half_turn else 0.0)
        q5_mmm = (turn if -v69 <= -half_turn else 0.0) - v69
        v70, v71 = angle17 - offset6, angle17 - math.copysign(half_turn, s6_pp) - offset6
        v72, v73 = angle18 - offset6, angle18 - math.copysign(half_turn, s6_pm) - offset6
        v74, v75 = angle19 - offset6, angle19 - math.copysign(half_turn, s6_mp) - offset6
        v76, v77 = angle20 - offset6, angle20 - math.copysign(half_turn, s6_mm) - offset6
        q6_ppp = v70 + (turn if v70 <= -half_turn else 0.0)
        q6_ppm = v71 + (turn if v71 <= -half_turn else 0.0)
        q6_pmp = v72 + (turn if v72 <= -half_turn else 0.0)
        q6_pmm = v73 + (turn if v73 <= -half_turn else 0.0)
        q6_mpp = v74 + (turn if v74 <= -half_turn else 0.0)
        q6_mpm = v75 + (turn if v75 <= -half_turn else 0.0)
        q6_mmp = v76 + (turn if v76 <= -half_turn else 0.0)
        q6_mmm = v77 + (turn if v77 <= -half_turn else 0.0)
        v78, v79, q1_ppp = abs(angle1) - high1, abs(angle2) - high1, angle1 + (w3_p - w3_p)
        q1_mpp = angle2 + (w3_m - w3_m)
        v80 = max(max(low3 - q3_ppp, q3_ppp - high3), max(v78, max(low2 - q2_ppp, q2_ppp - high2)))
        v81 = max(max(low3 - q3_pmp, q3_pmp - high3), max(v78, max(low2 - q2_pmp, q2_pmp - high2)))
        v82 = max(max(low3 - q3_mpp, q3_mpp - high3), max(v79, max(low2 - q2_mpp, q2_mpp - high2)))
        v83 = max(max(low3 - q3_mmp, q3_mmp - high3), max(v79, max(low2 - q2_mmp, q2_mmp - high2)))
        excess_ppp, excess_ppm = max(v80, abs(q5_ppp) - high5), max(v80, abs(q5_ppm) - high5)
        excess_pmp, excess_pmm = max(v81, abs(q5_pmp) - high5), max(v81, abs(q5_pmm) - high5)
        excess_mpp, excess_mpm = max(v82, abs(q5_mpp) - high5), max(v82, abs(q5_mpm) - high5)
        excess_mmp, excess_mmm = max(v83, abs(q5_mmp) - high5), max(v83, abs(q5_mmm) - high5)
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
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q2_mpp, q3_mpp, q4_mpp
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = q5_mpp, q6_mpp, q4_mpm
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q5_mpm, q6_mpm, q2_mmp
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q3_mmp, q4_mmp, q5_mmp
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = q6_mmp, q4_mmm, q5_mmm
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
_FORMULAS = _functions.Formulas(_formulas, 25, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 19, 20, 21, 22], [17, 18, 19, 23, 24, 25], [17, 26, 27, 28, 29, 30],
    [17, 26, 27, 31, 32, 33],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
