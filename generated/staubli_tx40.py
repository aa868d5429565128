# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: fc3cf3d03413d95a
"""staubli_tx40: Stäubli TX40.

Inverse kinematics, generated from robots/staubli_tx40.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/staubli_tx40.yaml. The formulas and where they come from:
staubli_tx40.md.

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

NAME = "staubli_tx40"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "right-down-noflip", "right-down-flip", "right-up-noflip", "right-up-flip", "left-up-noflip",
    "left-up-flip", "left-down-noflip", "left-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, reach_slack1 = 8.700000000000001e-14 [m],
# merge_slack1 = 8.700000000000002e-15 [m], arm_size1 = 0.8700000000000001 [m],
# doubt_limit_squared2 = 7.569000000000001e-09 [m^2], doubt_limit = 9.999999999999999e-05.
d1 = 0.32  # joint offset 1 [m]
a2 = 0.225  # link length 2 [m]
d3 = 0.035  # joint offset 3 [m]
d4 = 0.225  # joint offset 4 [m]
d6 = 0.065  # joint offset 6 [m]
free_limit_squared2 = 7.5690000000000015e-25  # square of a length that fixes no angle [m^2]
least_root1 = 2.75118156434649e-07  # a root of nothing, by rounding [m]
offset1 = 3.141592653589793  # offset of joint 1 [rad]
longest3 = 0.2025  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
boundary3 = 1.5849821455311018e-14  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.20249999999999216  # the longest, where branches merge [m^2]
shortest3_apart = 7.569000000000003e-29  # the shortest, where branches merge [m^2]
offset2 = 1.5707963267948966  # offset of joint 2 [rad]
free_limit = 1e-12  # a length that fixes no angle
offset4 = 3.141592653589793  # offset of joint 4 [rad]
offset3 = 1.5707963267948966  # offset of joint 3 [rad]
offset5 = 3.141592653589793  # offset of joint 5 [rad]
k1 = 0.0012250000000000002  # d3^2 [m^2]
k2 = 6.09000000000757e-15  # reach_slack1 * (2 * d3 + reach_slack1) [m^2]
k3 = 6.090000000000759e-16  # merge_slack1 * (2 * d3 + merge_slack1) [m^2]
k4 = 1.1494252873563218  # 1 / arm_size1 [m^-1]
k5 = 0.10125  # 2 * d4 * a2 [m^2]
k6 = 97.54610577655845  # 1 / (k5^2) [m^-4]
m1 = 6.090000000000759e-13  # 1000 * k3 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 1.5906026495925924e-12
m3 = 2.2222222222222223  # d4 * k5 * k6 [m^-1]
m4 = 5.728976100000003e-17  # doubt_limit_squared2^2 [m^4]
m5 = 21.947873799725652  # d4 * k5^2 * k6^2 [m^-3]
m6 = 4.4444444444444455  # d4 * longest3 * k5^2 * k6^2 [m^-1]
m7 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(1.149, 1.149, 1.149, 1.0, 1.0, 1.0), size=0.8700000000000001,
    steps=("merges", "refines", "follows seed"),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (3.141592653589793, 0.32, 0.0, 1.5707963267948966),
    (1.5707963267948966, 0.0, 0.225, 0.0),
    (1.5707963267948966, 0.035, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.225, 0.0, 1.5707963267948966),
    (3.141592653589793, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.065, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    v1 = q[0] + offset1
    c1, s1, v2 = math.cos(v1), math.sin(v1), q[1] + offset2
    c2, s2 = math.cos(v2), math.sin(v2)
    x2_x, x2_y, v3 = c1 * c2, s1 * c2, c1 * s2
    v4, v5 = s1 * s2, q[2] + offset3
    c3, s3 = math.cos(v5), math.sin(v5)
    x3_x, x3_y, x3_z = x2_x * c3 - v3 * s3, x2_y * c3 - v4 * s3, s2 * c3 + c2 * s3
    z3_x, z3_y, z3_z = v3 * c3 + x2_x * s3, v4 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    v6 = q[3] + offset4
    c4, s4 = math.cos(v6), math.sin(v6)
    x4_x, x4_y, x4_z = x3_x * c4 + s1 * s4, x3_y * c4 - c1 * s4, x3_z * c4
    z4_y, z4_z, z4_x = c1 * c4 + x3_y * s4, x3_z * s4, x3_x * s4 - s1 * c4
    v7 = q[4] + offset5
    c5, s5 = math.cos(v7), math.sin(v7)
    x5_x, x5_y, x5_z = x4_x * c5 + z3_x * s5, x4_y * c5 + z3_y * s5, x4_z * c5 + z3_z * s5
    z5_x, z5_y, z5_z = x4_x * s5 - z3_x * c5, x4_y * s5 - z3_y * c5, x4_z * s5 - z3_z * c5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + z4_x * s6, z4_x * c6 - x5_x * s6, z5_x
    T[0, 3] = x2_x * a2 + s1 * d3 + z3_x * d4 + z5_x * d6
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + z4_y * s6, z4_y * c6 - x5_y * s6, z5_y
    T[1, 3] = x2_y * a2 - c1 * d3 + z3_y * d4 + z5_y * d6
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 + z4_z * s6, z4_z * c6 - x5_z * s6, z5_z
    T[2, 3] = d1 + s2 * a2 + z3_z * d4 + z5_z * d6
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
    p2_z, v5 = d1 + s2 * a2, q[2] + offset3
    c3, s3 = math.cos(v5), math.sin(v5)
    x3_x, x3_y, x3_z = x2_x * c3 - v3 * s3, x2_y * c3 - v4 * s3, s2 * c3 + c2 * s3
    z3_x, z3_y, p3_x = v3 * c3 + x2_x * s3, v4 * c3 + x2_y * s3, p2_x + s1 * d3
    p3_y, z3_z, v6 = p2_y - c1 * d3, s2 * s3 - c2 * c3, q[3] + offset4
    c4, s4 = math.cos(v6), math.sin(v6)
    z4_y, z4_z, p4_x = c1 * c4 + x3_y * s4, x3_z * s4, p3_x + z3_x * d4
    p4_y, p4_z, z4_x = p3_y + z3_y * d4, p2_z + z3_z * d4, x3_x * s4 - s1 * c4
    v7 = q[4] + offset5
    c5, s5 = math.cos(v7), math.sin(v7)
    z5_x, z5_y = (x3_x * c4 + s1 * s4) * s5 - z3_x * c5, (x3_y * c4 - c1 * s4) * s5 - z3_y * c5
    z5_z, p6_x, p6_y = x3_z * c4 * s5 - z3_z * c5, p4_x + z5_x * d6, p4_y + z5_y * d6
    p6_z = p4_z + z5_z * d6
    v8, v9, v10 = p6_z - d1, p6_z - p2_z, p6_x - p3_x
    v11, v12, v13 = p6_y - p3_y, p6_x - p4_x, p6_y - p4_y
    v14 = p6_z - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, -(c1 * v8), -(c1 * v9)
    J[0, 3], J[0, 4] = z3_y * v9 - z3_z * v11, z4_y * v14 - z4_z * v13
    J[0, 5] = z5_y * v14 - z5_z * v13
    J[1, 0], J[1, 1], J[1, 2] = p6_x, -(s1 * v8), -(s1 * v9)
    J[1, 3], J[1, 4] = z3_z * v10 - z3_x * v9, z4_z * v12 - z4_x * v14
    J[1, 5] = z5_z * v12 - z5_x * v14
    J[2, 1], J[2, 2] = s1 * p6_y + c1 * p6_x, s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x)
    J[2, 3], J[2, 4] = z3_x * v11 - z3_y * v10, z4_x * v13 - z4_y * v12
    J[2, 5] = z5_x * v13 - z5_y * v12
    J[3, 1], J[3, 2], J[3, 3] = s1, s1, z3_x
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = -c1, -c1, z3_y
    J[4, 4], J[4, 5] = z4_y, z5_y
    J[5, 0], J[5, 3], J[5, 4] = 1.0, z3_z, z4_z
    J[5, 5] = z5_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1 A6^-1 [3, 4]
    X1 = T13 * d6 - T14
    wy = T24 - d6 * T23
    N1 = X1 * X1 + wy * wy
    D1_squared = N1 - k1
    apart1 = k3 < D1_squared
    if not (-k2 <= D1_squared):
        return  # out of reach
    w1 = math.sqrt(D1_squared if apart1 else 0.0)
    v1 = (w1 if apart1 else least_root1) * k4
    inverse1 = 1.0 / (N1 if apart1 else d3 * math.sqrt(N1))
    v2, v3 = X1 * d3, wy * d3

    # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = T34 - d6 * T33
    Z1_3 = wz - d1
    v4 = Z1_3 * Z1_3

    # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    v8 = seed[1] + offset2

    # theta4, type 2: U4[3, 3]
    v12 = seed[3] + offset4

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and not apart1:
            continue  # both signs give the same
        D1 = w1 * e1
        c1, s1 = -(inverse1 * (v3 + X1 * D1)), inverse1 * (wy * D1 - v2)

        # theta3
        N3 = v4 + D1 * D1
        K3 = N3 - k5
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= v1 * D3_squared):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        s3 = k5 * K3 * k6

        # theta2
        X1_2 = a2 + d4 * s3
        v6, v7 = Z1_3 * X1_2, D1 * X1_2

        # theta4
        v10 = T13 * c1 + T23 * s1
        Y4 = T13 * s1 - T23 * c1
        v11 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v13, v14, v16 = T22 * c1 - T12 * s1, T12 * c1 + T22 * s1, T21 * c1 - T11 * s1
        v17 = T11 * c1 + T21 * s1

        # joint values
        q1 = _wrap(_atan2(s1, c1) - offset1)

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            v5 = k6 * (k5 * (w3 * e3))

            # theta2
            Y1_2 = d4 * v5
            S2 = v6 - D1 * Y1_2
            C2 = v7 + Z1_3 * Y1_2
            w2 = math.sqrt(S2 * S2 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(v8) if free2 else C2 * factor2
            s2 = math.sin(v8) if free2 else S2 * factor2

            # theta4
            v9 = v5 * c2 + s3 * s2
            s23 = s3 * c2 - v5 * s2
            X4 = v9 * v10 - T33 * s23
            w4 = math.sqrt(X4 * X4 + v11)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta6
            v15, v18 = T32 * s23 - v9 * v14, T31 * s23 - v9 * v17

            # joint values
            q2 = _wrap(_atan2(s2, c2) - offset2)
            q3 = _wrap(_atan2(s3, -v5) - offset3)

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(v12) if free4 else -(X4 * factor4)
                s4 = math.sin(v12) if free4 else Y4 * factor4
                s5 = w4 * e4

                # theta6
                c6, s6 = c4 * v13 + s4 * v15, c4 * v16 + s4 * v18
                q6 = _atan2(s6, c6)

                # joint values
                q4 = _wrap(_atan2(s4, c4) - offset4)
                q5 = _wrap(_atan2(s5, -(T33 * v9 + s23 * v10)) - offset5)
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

        # theta1, type 2: U1 A6^-1 [3, 4]
        X1, wy = d6 * T13 - T14, T24 - d6 * T23
        N1 = X1 * X1 + wy * wy
        D1_squared = N1 - k1
        w1 = math.sqrt(D1_squared)
        v1, inverse1 = w1 - w1, 1.0 / N1
        v2 = inverse1 * (d3 * wy)
        v3, v4, v5 = v2 + w1 * (X1 * inverse1), v2 + w1 * (inverse1 * -X1), inverse1 * (d3 * X1)
        s1_p, s1_m = w1 * (wy * inverse1) - v5, w1 * (inverse1 * -wy) - v5

        # theta3, type 8: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        Z1_3 = T34 - d6 * T33 - d1
        N3 = D1_squared + Z1_3 * Z1_3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)
        v6, v7 = w3 - w3, k5 * (N3 - k5)

        # theta2, type 3: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        v8, v9 = m3 * (Z1_3 * N3), w3 * (m3 * w1)
        S2_pp, S2_pm, v10 = v8 - v9, v8 + v9, w3 * (m3 * Z1_3)
        v11, v12 = w3 * (m3 * -Z1_3), m3 * (w1 * N3)
        C2_pp, C2_pm, C2_mp = v10 + v12, v11 + v12, v10 - v12
        C2_mm, v13 = v11 - v12, S2_pp * S2_pp
        v14, v15 = v13 + C2_pp * C2_pp, S2_pm * S2_pm
        v16, v17, v18 = v15 + C2_pm * C2_pm, v15 + C2_mp * C2_mp, v13 + C2_mm * C2_mm
        factor2_pp, factor2_pm = math.sqrt(v14) * (1.0 / v14), math.sqrt(v16) * (1.0 / v16)
        factor2_mp, factor2_mm = math.sqrt(v17) * (1.0 / v17), math.sqrt(v18) * (1.0 / v18)

        # theta4, type 2: U4[3, 3]
        v19 = m5 * N3
        v20, v21 = v19 - m3, m6 - v19
        v22 = w1 * (N3 * (v20 + v21))
        s23_pp, s23_pm, v23 = v22 - v10, v22 - v11, w1 * (N3 * (-v20 + -v21))
        s23_mp, s23_mm, v24 = v23 - v10, v23 - v11, T23 * s1_p - T13 * v3
        v25, X4_pp = T23 * s1_m - T13 * v4, S2_pm * v24 - T33 * s23_pp
        X4_pm, X4_mp = S2_pp * v24 - T33 * s23_pm, S2_pp * v25 - T33 * s23_mp
        X4_mm, Y4_p, Y4_m = S2_pm * v25 - T33 * s23_mm, T13 * s1_p + T23 * v3, T13 * s1_m + T23 * v4
        v26, v27 = Y4_p * Y4_p, Y4_m * Y4_m
        v28 = v26 + factor2_pp * (X4_pp * (factor2_pp * X4_pp))
        v29 = v26 + factor2_pm * (X4_pm * (factor2_pm * X4_pm))
        v30 = v27 + factor2_mp * (X4_mp * (factor2_mp * X4_mp))
        v31 = v27 + factor2_mm * (X4_mm * (factor2_mm * X4_mm))

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v32, v33, v34 = v3 * T22 + s1_p * T12, v4 * T22 + s1_m * T12, s1_p * T22 - v3 * T12
        v35, v36, v37 = s1_m * T22 - v4 * T12, v3 * T21 + s1_p * T11, v4 * T21 + s1_m * T11
        v38, v39 = s1_p * T21 - v3 * T11, s1_m * T21 - v4 * T11
        s6_pp = Y4_p * (s23_pp * T31 - S2_pm * v38) - v36 * -X4_pp
        s6_pm = Y4_p * (s23_pm * T31 - S2_pp * v38) - v36 * -X4_pm
        s6_mp = Y4_m * (s23_mp * T31 - S2_pp * v39) - v37 * -X4_mp
        s6_mm = Y4_m * (s23_mm * T31 - S2_pm * v39) - v37 * -X4_mm

        # joint values
        v48, v49, v58 = math.copysign(half_turn, Y4_p), math.copysign(half_turn, Y4_m), T33 * S2_pm
        v59 = T33 * S2_pp

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v31 <= m7 or v18 <= m4 or v30 <= m7 or v17 <= m4 or v29 <= m7 or v16 <= m4 or v28
            <= m7 or abs(D1_squared) <= m1 or abs(D3_squared * (k4 * w1)) <= m2 or v14 <= m4 else
            kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = v1, v6, v7
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = s6_pp, s6_pm, s6_mp
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = s6_mm, v48, v49
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = s6_pp, s6_pm, s6_mp
        turns[3 * w + k], turns[4 * w + k], turns[5 * w + k] = s6_mm, s1_p, s1_m
        turns[6 * w + k], turns[7 * w + k], turns[8 * w + k] = S2_pp, S2_pm, S2_pm
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = S2_pp, v7, Y4_p
        turns[12 * w + k], turns[13 * w + k], turns[14 * w + k] = Y4_p, Y4_m, Y4_m
        turns[15 * w + k], turns[16 * w + k] = math.sqrt(v28), math.sqrt(v29)
        turns[17 * w + k], turns[18 * w + k] = math.sqrt(v30), math.sqrt(v31)
        turns[24 * w + k] = Y4_p * (s23_pp * T32 - S2_pm * v34) - v32 * -X4_pp
        turns[25 * w + k] = Y4_p * (s23_pm * T32 - S2_pp * v34) - v32 * -X4_pm
        turns[26 * w + k] = Y4_m * (s23_mp * T32 - S2_pp * v35) - v33 * -X4_mp
        turns[27 * w + k] = Y4_m * (s23_mm * T32 - S2_pm * v35) - v33 * -X4_mm
        turns[28 * w + k], turns[29 * w + k], turns[30 * w + k] = -v3, -v4, C2_pp
        turns[31 * w + k], turns[32 * w + k], turns[33 * w + k] = C2_pm, C2_mp, C2_mm
        turns[34 * w + k], turns[35 * w + k] = -(k5 * w3), factor2_pp * -X4_pp
        turns[36 * w + k], turns[37 * w + k] = factor2_pm * -X4_pm, factor2_mp * -X4_mp
        turns[38 * w + k] = factor2_mm * -X4_mm
        turns[39 * w + k] = -(factor2_pp * (v58 + s23_pp * v24))
        turns[40 * w + k] = -(factor2_pm * (v59 + s23_pm * v24))
        turns[41 * w + k] = -(factor2_mp * (v59 + s23_mp * v25))
        turns[42 * w + k] = -(factor2_mm * (v58 + s23_mm * v25))
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 19 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(19 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        v1, v6, v7 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        s6_pp, s6_pm, s6_mp = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        s6_mm, v48, v49 = kept[23 * w + k], kept[24 * w + k], kept[25 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5, angle6 = turns[3 * w + k], turns[4 * w + k], turns[5 * w + k]
        angle7, angle8, angle9 = turns[6 * w + k], turns[7 * w + k], turns[8 * w + k]
        angle10, angle11, angle12 = turns[9 * w + k], turns[10 * w + k], turns[11 * w + k]
        angle13, angle14, angle15 = turns[12 * w + k], turns[13 * w + k], turns[14 * w + k]
        angle16, angle17, angle18 = turns[15 * w + k], turns[16 * w + k], turns[17 * w + k]
        angle19 = turns[18 * w + k]

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle1 - math.copysign(half_turn, s6_pp)
        q6_pmm = angle2 - math.copysign(half_turn, s6_pm)
        q6_mpm = angle3 - math.copysign(half_turn, s6_mp)
        q6_mmm = angle4 - math.copysign(half_turn, s6_mm)

        # joint values
        v40, v41, v42 = angle5 - offset1, angle6 - offset1, angle7 - offset2
        v43, v44, v45 = angle8 - offset2, angle9 - offset2, angle10 - offset2
        q2_ppp = v42 + (turn if v42 <= -half_turn else 0.0)
        q2_pmp = v43 + (turn if v43 <= -half_turn else 0.0)
        q2_mpp = v44 + (turn if v44 <= -half_turn else 0.0)
        q2_mmp = v45 + (turn if v45 <= -half_turn else 0.0)
        v46, v47 = angle11 - offset3, math.copysign(half_turn, v7) - angle11 - offset3
        v50, v51, v52 = angle12 - offset4, angle12 - v48 - offset4, angle13 - offset4
        v53, v54, v55 = angle13 - v48 - offset4, angle14 - offset4, angle14 - v49 - offset4
        v56, v57 = angle15 - offset4, angle15 - v49 - offset4
        q4_ppp = v50 + (turn if v50 <= -half_turn else 0.0)
        q4_ppm = v51 + (turn if v51 <= -half_turn else 0.0)
        q4_pmp = v52 + (turn if v52 <= -half_turn else 0.0)
        q4_pmm = v53 + (turn if v53 <= -half_turn else 0.0)
        q4_mpp = v54 + (turn if v54 <= -half_turn else 0.0)
        q4_mpm = v55 + (turn if v55 <= -half_turn else 0.0)
        q4_mmp = v56 + (turn if v56 <= -half_turn else 0.0)
        q4_mmm = v57 + (turn if v57 <= -half_turn else 0.0)
        v60, v61, v62 = angle16 - offset5, offset5 + angle16, angle17 - offset5
        v63, v64, v65 = offset5 + angle17, angle18 - offset5, offset5 + angle18
        v66, v67 = angle19 - offset5, offset5 + angle19
        q5_ppp = v60 + (turn if v60 <= -half_turn else 0.0)
        q5_ppm = (turn if -v61 <= -half_turn else 0.0) - v61
        q5_pmp = v62 + (turn if v62 <= -half_turn else 0.0)
        q5_pmm = (turn if -v63 <= -half_turn else 0.0) - v63
        q5_mpp = v64 + (turn if v64 <= -half_turn else 0.0)
        q5_mpm = (turn if -v65 <= -half_turn else 0.0) - v65
        q5_mmp = v66 + (turn if v66 <= -half_turn else 0.0)
        q5_mmm = (turn if -v67 <= -half_turn else 0.0) - v67
        q1_ppp = v6 + (v40 + (turn if v40 <= -half_turn else 0.0))
        q1_mpp = v6 + (v41 + (turn if v41 <= -half_turn else 0.0))
        q3_ppp = v1 + (v46 + (turn if v46 <= -half_turn else 0.0))
        q3_pmp = v1 + (v47 + (turn if v47 <= -half_turn else 0.0))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, q2_ppp, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_ppp, q5_ppp, angle1
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, q5_ppm, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q2_pmp, q3_pmp, q4_pmp
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q5_pmp, angle2, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q5_pmm, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q2_mpp, q4_mpp, q5_mpp
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = angle3, q4_mpm, q5_mpm
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q6_mpm, q2_mmp, q4_mmp
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q5_mmp, angle4, q4_mmm
        rows[30 * w + k], rows[31 * w + k] = q5_mmm, q6_mmm
        rows[32 * w + k] = rows[33 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[34 * w + k] = rows[35 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[36 * w + k] = rows[37 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[38 * w + k] = rows[39 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 26, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 2, 19, 20, 21], [17, 18, 2, 22, 23, 24], [17, 25, 10, 26, 27, 28],
    [17, 25, 10, 29, 30, 31],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
