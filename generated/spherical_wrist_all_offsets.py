# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 8351e27252c6f861
"""spherical_wrist_all_offsets: Spherical wrist on an arm with every offset.

Inverse kinematics, generated from robots/spherical_wrist_all_offsets.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/spherical_wrist_all_offsets.yaml. The formulas and where they come
from: spherical_wrist_all_offsets.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 6), _runtime("arrays").zeros

NAME = "spherical_wrist_all_offsets"
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

# In formulas below, reach_slack1 = 1.7800000000000005e-13 [m],
# merge_slack1 = 1.7800000000000004e-14 [m], arm_size1 = 1.7800000000000005 [m],
# doubt_limit = 9.999999999999999e-05.
d1 = 0.5  # joint offset 1 [m]
a1 = 0.12  # link length 1 [m]
d2 = 0.13  # joint offset 2 [m]
a2 = 0.43  # link length 2 [m]
d3 = 0.06  # joint offset 3 [m]
a3 = 0.09  # link length 3 [m]
d4 = 0.38  # joint offset 4 [m]
d6 = 0.07  # joint offset 6 [m]
least_root1 = 5.628854235099716e-07  # a root of nothing, by rounding [m]
longest3 = 0.6732407360639862  # square of the longest reach [m^2]
shortest3 = 0.0015592639360138612  # square of the shortest reach [m^2]
boundary3 = 1.9612336995515177e-13  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.673240736063957  # the longest, where branches merge [m^2]
shortest3_apart = 0.001559263936015267  # the shortest, where branches merge [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.07  # d2 - d3 [m]
k2 = 0.004900000000000001  # k1^2 [m^2]
k3 = 2.4920000000031693e-14  # reach_slack1 * (2 * k1 + reach_slack1) [m^2]
k4 = 2.4920000000003178e-15  # merge_slack1 * (2 * k1 + merge_slack1) [m^2]
k5 = 0.5617977528089886  # 1 / arm_size1 [m^-1]
k6 = 0.3268  # 2 * d4 * a2 [m^2]
k7 = 0.0774  # 2 * a3 * a2 [m^2]
k8 = 0.3374  # a2^2 + (a3^2 + d4^2) [m^2]
k9 = 8.866112830151877  # 1 / (k6^2 + k7^2) [m^-4]
turn1 = -1.3382393849899876  # atan2(-k6, k7) [rad]
m1 = 2.4920000000003177e-12  # 1000 * k4 [m^2]
m2 = 1.96123369955058e-11  # 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 1.1627906976744187  # k9 * (d4 * k6 + a3 * k7) [m^-1]
m4 = 0.03767441860465117  # a2 - d4 * k6 * k8 * k9 - a3 * k7 * k8 * k9 [m]
m5 = 0.29508196721311475  # a2 * k7 * k9 [m^-1]
m6 = 1.2459016393442623  # a2 * k6 * k9 [m^-1]
# k6 * k9 * (a2 * k8 + d4 * longest3 * shortest3 * k6 * k9 + a3 * longest3 * shortest3 * k7 * k9 -
# d4 * k6 * k8^2 * k9 - a3 * k7 * k8^2 * k9) [m]
m7 = 0.04036721311475411
# k7 * k9 * (a2 * k8 + d4 * longest3 * shortest3 * k6 * k9 + a3 * longest3 * shortest3 * k7 * k9 -
# d4 * k6 * k8^2 * k9 - a3 * k7 * k8^2 * k9) [m]
m8 = 0.00956065573770492
m9 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.5618, 0.5618, 0.5618, 1.0, 1.0, 1.0), size=1.7800000000000005,
    steps=("merges", "refines", "follows seed"),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.5, 0.12, -1.5707963267948966),
    (0.0, 0.13, 0.43, 0.0),
    (0.0, -0.06, 0.09, 1.5707963267948966),
    (0.0, 0.38, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.07, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v3 = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    z3_x, z3_y, y4_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, v4 = x3_x * c4 - s1 * s4, x3_y * c4 + c1 * s4, v3 * c4
    v5, z4_y, z4_z = s1 * c4 + x3_x * s4, c1 * c4 - x3_y * s4, v3 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 - z3_x * s5, x4_y * c5 - z3_y * s5, y4_z * s5 - v4 * c5
    z5_x, z5_y, v6 = z3_x * c5 + x4_x * s5, z3_y * c5 + x4_y * s5, y4_z * c5 + v4 * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 - v5 * s6, -(v5 * c6 + x5_x * s6), z5_x
    T[0, 3] = c1 * a1 + x2_x * a2 - s1 * d2 + x3_x * a3 + s1 * d3 + z3_x * d4 + z5_x * d6
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + z4_y * s6, z4_y * c6 - x5_y * s6, z5_y
    T[1, 3] = s1 * a1 + x2_y * a2 + c1 * d2 + x3_y * a3 - c1 * d3 + z3_y * d4 + z5_y * d6
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 + z4_z * s6, z4_z * c6 - x5_z * s6, -v6
    T[2, 3] = d1 - s2 * a2 - v3 * a3 + -y4_z * d4 - v6 * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * a1, s1 * a1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2, p2_z, p2_x = s1 * s2, d1 - s2 * a2, p1_x + x2_x * a2 - s1 * d2
    p2_y = p1_y + x2_y * a2 + c1 * d2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v3 = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    z3_x, z3_y, y4_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    p3_z, p3_x, p3_y = p2_z - v3 * a3, p2_x + x3_x * a3 + s1 * d3, p2_y + x3_y * a3 - c1 * d3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    v4, z4_y, z4_z = s1 * c4 + x3_x * s4, c1 * c4 - x3_y * s4, v3 * s4
    p4_x, p4_y, p4_z = p3_x + z3_x * d4, p3_y + z3_y * d4, p3_z + -y4_z * d4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    z5_x, z5_y = z3_x * c5 + (x3_x * c4 - s1 * s4) * s5, z3_y * c5 + (x3_y * c4 + c1 * s4) * s5
    v5, p6_x, p6_y = y4_z * c5 + v3 * c4 * s5, p4_x + z5_x * d6, p4_y + z5_y * d6
    p6_z = p4_z - v5 * d6
    v6, v7, v8 = p6_z - d1, p6_z - p2_z, p6_x - p3_x
    v9, v10, v11 = p6_y - p3_y, p6_z - p3_z, p6_x - p4_x
    v12, v13 = p6_y - p4_y, p6_z - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, c1 * v6, c1 * v7
    J[0, 3], J[0, 4] = z3_y * v10 - -y4_z * v9, z4_y * v13 - z4_z * v12
    J[0, 5] = z5_y * v13 + v5 * v12
    J[1, 0], J[1, 1], J[1, 2] = p6_x, s1 * v6, s1 * v7
    J[1, 3], J[1, 4] = -y4_z * v8 - z3_x * v10, z4_z * v11 + v4 * v13
    J[1, 5] = -(v5 * v11 + z5_x * v13)
    J[2, 1] = -(s1 * (p6_y - p1_y) + c1 * (p6_x - p1_x))
    J[2, 2], J[2, 3] = -(s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x)), z3_x * v9 - z3_y * v8
    J[2, 4], J[2, 5] = -(v4 * v12 + z4_y * v11), z5_x * v12 - z5_y * v11
    J[3, 1], J[3, 2], J[3, 3] = -s1, -s1, z3_x
    J[3, 4], J[3, 5] = -v4, z5_x
    J[4, 1], J[4, 2], J[4, 3] = c1, c1, z3_y
    J[4, 4], J[4, 5] = z4_y, z5_y
    J[5, 0], J[5, 3], J[5, 4] = 1.0, -y4_z, z4_z
    J[5, 5] = -v5
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1 A6^-1 [3, 4]
    wx = T14 - T13 * d6
    Y1 = d6 * T23 - T24
    N1 = wx * wx + Y1 * Y1
    D1_squared = N1 - k2
    apart1 = k4 < D1_squared
    if not (-k3 <= D1_squared):
        return  # out of reach
    w1 = math.sqrt(D1_squared if apart1 else 0.0)
    v1 = (w1 if apart1 else least_root1) * k5
    inverse1 = 1.0 / (N1 if apart1 else k1 * math.sqrt(N1))
    v2, v3 = wx * k1, Y1 * k1

    # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
    wz = T34 - d6 * T33
    Z1_3 = wz - d1
    v5 = Z1_3 * Z1_3

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and not apart1:
            continue  # both signs give the same
        D1 = w1 * e1
        c1, s1 = -(inverse1 * (v3 + wx * D1)), inverse1 * (Y1 * D1 - v2)
        q1 = _atan2(s1, c1)

        # theta3
        v4 = D1 + a1
        N3 = v5 + v4 * v4
        K3 = N3 - k8
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= v1 * D3_squared):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        v6, v7 = k6 * K3, k7 * K3

        # theta4, type 2: U4[3, 3]
        v9 = T13 * c1 + T23 * s1
        Y4 = T13 * s1 - T23 * c1
        v10 = Y4 * Y4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v11, v12, v14 = T12 * s1 - T22 * c1, T12 * c1 + T22 * s1, T11 * s1 - T21 * c1
        v15 = T11 * c1 + T21 * s1

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            D3 = w3 * e3
            s3, c3 = (v6 + k7 * D3) * k9, k9 * (v7 - k6 * D3)
            q3 = _atan2(s3, c3)

            # theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4]
            X1_2 = d4 * c3 - a3 * s3
            Y1_2 = a2 + (a3 * c3 + d4 * s3)
            v8 = v4 * X1_2 + Z1_3 * Y1_2
            C2 = Z1_3 * X1_2 - v4 * Y1_2
            w2 = math.sqrt(v8 * v8 + C2 * C2)
            factor2 = 1.0 / w2
            c2, s2 = C2 * factor2, -(v8 * factor2)
            q2 = _atan2(s2, c2)

            # theta4
            c23, s23 = c3 * c2 - s3 * s2, c3 * s2 + s3 * c2
            X4 = c23 * v9 - T33 * s23
            w4 = math.sqrt(X4 * X4 + v10)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T33 * c23 + s23 * v9

            # theta6
            v13, v16 = c23 * v12 - T32 * s23, c23 * v15 - T31 * s23

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else Y4 * factor4
                q4 = _atan2(s4, c4)

                # theta5
                q5 = _atan2(-(w4 * e4), c5)

                # theta6
                q6 = _atan2(-(c4 * v14 + s4 * v16), -(c4 * v11 + s4 * v13))
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
        wx, Y1 = T14 - d6 * T13, d6 * T23 - T24
        N1 = wx * wx + Y1 * Y1
        D1_squared = N1 - k2
        w1 = math.sqrt(D1_squared)
        v1, inverse1 = k5 * w1, 1.0 / N1
        v2 = inverse1 * (k1 * Y1)
        v3, v4, v5 = v2 + w1 * (wx * inverse1), v2 + w1 * (inverse1 * -wx), inverse1 * (k1 * wx)
        s1_p, s1_m = w1 * (Y1 * inverse1) - v5, w1 * (inverse1 * -Y1) - v5

        # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        Z1_3, v6, v7 = T34 - d6 * T33 - d1, a1 + w1, a1 - w1
        v8 = Z1_3 * Z1_3
        N3_p, N3_m = v8 + v6 * v6, v8 + v7 * v7
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3)
        D3_squared_m, w3_p = (longest3 - N3_m) * (N3_m - shortest3), math.sqrt(D3_squared_p)
        w3_m = math.sqrt(D3_squared_m)

        # theta2, type 3: U1 A6^-1 [1, 4] and U1 A6^-1 [2, 4]
        v11, v12, factor2_p = Z1_3 * (m4 + m3 * N3_p), Z1_3 * (m4 + m3 * N3_m), 1.0 / N3_p
        factor2_m, v13 = 1.0 / N3_m, v6 * (m3 + m4 * factor2_p)
        v14, v15 = v7 * (m3 + m4 * factor2_m), w3_p * (m3 * v6)

        # theta4, type 2: U4[3, 3]
        v16, v17, v18 = m5 * Z1_3, m6 - m7 * factor2_p, m6 - m7 * factor2_m
        v19, v20 = m8 * factor2_p - m5, m8 * factor2_m - m5
        v21, v22 = Z1_3 * v17 + v6 * v19, Z1_3 * v18 + v7 * v20
        v23 = w3_p * (factor2_p * (v16 + m6 * v6))
        c23_pp, c23_pm, v24 = v21 + v23, v21 - v23, w3_m * (factor2_m * (v16 + m6 * v7))
        c23_mp, c23_mm, v25 = v22 + v24, v22 - v24, m6 * Z1_3
        v26, v27, v28 = v25 - m5 * v6, v25 - m5 * v7, Z1_3 * v19 + v6 * -v17
        v29, s23_pp = Z1_3 * v20 + v7 * -v18, v28 + w3_p * (factor2_p * v26)
        s23_pm, s23_mp = v28 + w3_p * (factor2_p * -v26), v29 + w3_m * (factor2_m * v27)
        s23_mm, v30 = v29 + w3_m * (factor2_m * -v27), T23 * s1_p - T13 * v3
        v31, X4_pp = T23 * s1_m - T13 * v4, c23_pp * v30 - T33 * s23_pp
        X4_pm, X4_mp = c23_pm * v30 - T33 * s23_pm, c23_mp * v31 - T33 * s23_mp
        X4_mm, Y4_p = c23_mm * v31 - T33 * s23_mm, T13 * s1_p + T23 * v3
        Y4_m, v32 = T13 * s1_m + T23 * v4, Y4_p * Y4_p
        v33, v34, v35 = Y4_m * Y4_m, v32 + X4_pp * X4_pp, v32 + X4_pm * X4_pm
        v36, v37, v38 = v33 + X4_mp * X4_mp, v33 + X4_mm * X4_mm, math.copysign(half_turn, Y4_p)
        v39 = math.copysign(half_turn, Y4_m)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v40, v41, v42 = s1_p * T12 + v3 * T22, s1_m * T12 + v4 * T22, s1_p * T22 - v3 * T12
        v43, v44, v45 = s1_m * T22 - v4 * T12, s1_p * T11 + v3 * T21, s1_m * T11 + v4 * T21
        v46, v47 = s1_p * T21 - v3 * T11, s1_m * T21 - v4 * T11

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v37 <= m9 or v36 <= m9 or v35 <= m9 or v34 <= m9 or abs(v1 * D3_squared_m) <= m2
            or abs(D1_squared) <= m1 or abs(v1 * D3_squared_p) <= m2 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = w3_p, w3_m, c23_pp
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = c23_pm, c23_mp, c23_mm
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = s23_pp, s23_pm, s23_mp
        kept[26 * w + k], kept[27 * w + k], kept[28 * w + k] = s23_mm, X4_pp, X4_pm
        kept[29 * w + k], kept[30 * w + k], kept[31 * w + k] = X4_mp, X4_mm, Y4_p
        kept[32 * w + k], kept[33 * w + k], kept[34 * w + k] = Y4_m, v38, v39
        kept[35 * w + k], kept[36 * w + k], kept[37 * w + k] = v44, v45, v46
        kept[38 * w + k], turns[0 * w + k], turns[1 * w + k] = v47, w3_p, w3_m
        turns[2 * w + k], turns[3 * w + k] = -(factor2_p * (v11 - v15)), -(factor2_p * (v11 + v15))
        turns[4 * w + k] = -(factor2_m * (v12 - w3_m * (m3 * v7)))
        turns[5 * w + k], turns[6 * w + k] = -(factor2_m * (v12 - w3_m * (m3 * -v7))), Y4_p
        turns[7 * w + k], turns[8 * w + k], turns[9 * w + k] = Y4_p, Y4_m, Y4_m
        turns[10 * w + k], turns[11 * w + k] = -math.sqrt(v34), -math.sqrt(v35)
        turns[12 * w + k], turns[13 * w + k] = -math.sqrt(v36), -math.sqrt(v37)
        turns[14 * w + k] = -(-X4_pp * v44 + Y4_p * (c23_pp * v46 - s23_pp * T31))
        turns[15 * w + k] = -(-X4_pm * v44 + Y4_p * (c23_pm * v46 - s23_pm * T31))
        turns[16 * w + k] = -(-X4_mp * v45 + Y4_m * (c23_mp * v47 - s23_mp * T31))
        turns[17 * w + k] = -(-X4_mm * v45 + Y4_m * (c23_mm * v47 - s23_mm * T31))
        turns[18 * w + k], turns[19 * w + k], turns[24 * w + k] = s1_p, s1_m, N3_p - k8
        turns[25 * w + k], turns[26 * w + k] = N3_m - k8, -(v13 + w3_p * (m3 * (Z1_3 * factor2_p)))
        turns[27 * w + k] = -(v13 + w3_p * (m3 * (-Z1_3 * factor2_p)))
        turns[28 * w + k] = -(v14 + w3_m * (m3 * (Z1_3 * factor2_m)))
        turns[29 * w + k], turns[30 * w + k] = -(v14 + w3_m * (m3 * (-Z1_3 * factor2_m))), -X4_pp
        turns[31 * w + k], turns[32 * w + k], turns[33 * w + k] = -X4_pm, -X4_mp, -X4_mm
        turns[34 * w + k] = T33 * c23_pp + s23_pp * v30
        turns[35 * w + k] = T33 * c23_pm + s23_pm * v30
        turns[36 * w + k] = T33 * c23_mp + s23_mp * v31
        turns[37 * w + k] = T33 * c23_mm + s23_mm * v31
        turns[38 * w + k] = -(-X4_pp * v40 + Y4_p * (c23_pp * v42 - s23_pp * T32))
        turns[39 * w + k] = -(-X4_pm * v40 + Y4_p * (c23_pm * v42 - s23_pm * T32))
        turns[40 * w + k] = -(-X4_mp * v41 + Y4_m * (c23_mp * v43 - s23_mp * T32))
        turns[41 * w + k] = -(-X4_mm * v41 + Y4_m * (c23_mm * v43 - s23_mm * T32))
        turns[42 * w + k], turns[43 * w + k] = -v3, -v4
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 20 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(20 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        T31, w3_p, w3_m = kept[8 * w + k], kept[17 * w + k], kept[18 * w + k]
        c23_pp, c23_pm, c23_mp = kept[19 * w + k], kept[20 * w + k], kept[21 * w + k]
        c23_mm, s23_pp, s23_pm = kept[22 * w + k], kept[23 * w + k], kept[24 * w + k]
        s23_mp, s23_mm, X4_pp = kept[25 * w + k], kept[26 * w + k], kept[27 * w + k]
        X4_pm, X4_mp, X4_mm = kept[28 * w + k], kept[29 * w + k], kept[30 * w + k]
        Y4_p, Y4_m, v38 = kept[31 * w + k], kept[32 * w + k], kept[33 * w + k]
        v39, v44, v45 = kept[34 * w + k], kept[35 * w + k], kept[36 * w + k]
        v46, v47, angle1 = kept[37 * w + k], kept[38 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle8, angle9, angle10 = turns[7 * w + k], turns[8 * w + k], turns[9 * w + k]
        angle11, angle12, angle13 = turns[10 * w + k], turns[11 * w + k], turns[12 * w + k]
        angle14, angle15, angle16 = turns[13 * w + k], turns[14 * w + k], turns[15 * w + k]
        angle17, angle18, angle19 = turns[16 * w + k], turns[17 * w + k], turns[18 * w + k]
        angle20 = turns[19 * w + k]

        # theta3, type 6: U1 A6^-1 [2, 4] and U1 A6^-1 [1, 4]
        q3__pp, v9, q3__mp = angle1 - turn1, turn1 + angle1, angle2 - turn1
        v10 = turn1 + angle2

        # theta4, type 2: U4[3, 3]
        q4_ppm, q4_pmm, q4_mpm = angle7 - v38, angle8 - v38, angle9 - v39
        q4_mmm = angle10 - v39

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = (
            angle15 - math.copysign(half_turn, -(-X4_pp * v44 + Y4_p * (c23_pp * v46 - s23_pp *
            T31)))
        )
        q6_pmm = (
            angle16 - math.copysign(half_turn, -(-X4_pm * v44 + Y4_p * (c23_pm * v46 - s23_pm *
            T31)))
        )
        q6_mpm = (
            angle17 - math.copysign(half_turn, -(-X4_mp * v45 + Y4_m * (c23_mp * v47 - s23_mp *
            T31)))
        )
        q6_mmm = (
            angle18 - math.copysign(half_turn, -(-X4_mm * v45 + Y4_m * (c23_mm * v47 - s23_mm *
            T31)))
        )

        # joint values
        q3_ppp = q3__pp + (-turn if half_turn < q3__pp else 0.0)
        q3_pmp = (-turn if half_turn < -v9 else 0.0) - v9
        q3_mpp = q3__mp + (-turn if half_turn < q3__mp else 0.0)
        q3_mmp = (-turn if half_turn < -v10 else 0.0) - v10
        q1_ppp, q1_mpp = angle19 + (w3_p - w3_p), angle20 + (w3_m - w3_m)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, angle3, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle7, angle11, angle15
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, -angle11, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = angle4, q3_pmp, angle8
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = angle12, angle16, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = -angle12, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = angle5, q3_mpp, angle9
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = angle13, angle17, q4_mpm
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = -angle13, q6_mpm, angle6
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q3_mmp, angle10, angle14
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = angle18, q4_mmm, -angle14
        rows[33 * w + k] = q6_mmm
        rows[34 * w + k] = rows[35 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[36 * w + k] = rows[37 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[38 * w + k] = rows[39 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[40 * w + k] = rows[41 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 39, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 19, 20, 21, 22], [17, 18, 19, 23, 24, 25], [17, 26, 27, 28, 29, 30],
    [17, 26, 27, 31, 32, 33],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
