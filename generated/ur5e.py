# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 188073c3e2550859
"""ur5e: Universal Robots UR5e.

Inverse kinematics, generated from robots/ur5e.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/ur5e.yaml. The formulas and where they come from: ur5e.md.

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

NAME = "ur5e"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-6.283185307179586, 6.283185307179586), (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586), (-6.283185307179586, 6.283185307179586),
    (-6.283185307179586, 6.283185307179586), (-6.283185307179586, 6.283185307179586),
)
BRANCHES = (
    "right-noflip-down", "right-noflip-up", "right-flip-down", "right-flip-up", "left-noflip-up",
    "left-noflip-down", "left-flip-up", "left-flip-down",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, reach_slack1 = 1.3122999999999999e-13 [m],
# merge_slack1 = 1.3122999999999998e-14 [m], arm_size1 = 1.3122999999999998 [m],
# doubt_limit = 9.999999999999999e-05.
d1 = 0.1625  # joint offset 1 [m]
a2 = -0.425  # link length 2 [m]
a3 = -0.3922  # link length 3 [m]
d4 = 0.1333  # joint offset 4 [m]
d5 = 0.0997  # joint offset 5 [m]
d6 = 0.0996  # joint offset 6 [m]
least_root1 = 4.149856973438963e-07  # a root of nothing, by rounding [m]
free_limit = 1e-12  # a length that fixes no angle
near_limit = 0.001  # a length whose direction is good to few digits
longest3 = 0.6678158399999998  # square of the longest reach [m^2]
shortest3 = 0.0010758399999999998  # square of the shortest reach [m^2]
boundary3 = 1.4301245521157901e-13  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.6678158399999785  # the longest, where branches merge [m^2]
shortest3_apart = 0.0010758400000008604  # the shortest, where branches merge [m^2]
longest3_clear = 0.6678158399785518  # the longest, where blurred branches do [m^2]
shortest3_clear = 0.0010758400008608687  # the shortest, where blurred branches do [m^2]
k1 = 0.01776889  # d4^2 [m^2]
k2 = 3.4985918000017217e-14  # reach_slack1 * (2 * d4 + reach_slack1) [m^2]
k3 = 3.4985918000001716e-15  # merge_slack1 * (2 * d4 + merge_slack1) [m^2]
k4 = 0.762020879372095  # 1 / arm_size1 [m^-1]
k5 = 0.33444584  # a2^2 + a3^2 [m^2]
k6 = 2.9996700362960076  # 1 / (2 * a3 * a2) [m^-2]
m1 = 3.4985918000001714e-12  # 1000 * k3 [m^2]
m2 = 9.999999999999999e-09  # doubt_limit^2
m4 = 1.4300283221564012e-10  # 10 * (longest3 - longest3_clear) * (longest3_clear - shortest3) [m^4]
m5 = 1.1764705882352942  # -a3 * k6 [m^-1]
m6 = 0.031534305882352925  # a3 * k5 * k6 - a2 [m]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.762, 0.762, 0.762, 1.0, 1.0, 1.0), size=1.3122999999999998,
    steps=(
        "retries",
        "keeps limits",
        "merges",
        "refines",
        "clamps",
        "clamps far",
        "range exceeds a turn",
        "follows seed",
    ),
    choosable=(5,),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.1625, 0.0, 1.5707963267948966),
    (0.0, 0.0, -0.425, 0.0),
    (0.0, 0.0, -0.3922, 0.0),
    (0.0, 0.1333, 0.0, 1.5707963267948966),
    (0.0, 0.0997, 0.0, -1.5707963267948966),
    (0.0, 0.0996, 0.0, 0.0),
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
    x3_x, x3_y, x3_z = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v3, v4, y3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 - v3 * s4, x3_y * c4 - v4 * s4, x3_z * c4 + y3_z * s4
    z4_x, z4_y, y5_z = v3 * c4 + x3_x * s4, v4 * c4 + x3_y * s4, y3_z * c4 - x3_z * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + s1 * s5, x4_y * c5 - c1 * s5, x4_z * c5
    z5_x, v5, v6 = s1 * c5 - x4_x * s5, c1 * c5 + x4_y * s5, x4_z * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 - z4_x * s6, -(z4_x * c6 + x5_x * s6), z5_x
    T[0, 3] = x2_x * a2 + x3_x * a3 + s1 * d4 + z4_x * d5 + z5_x * d6
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 - z4_y * s6, -(z4_y * c6 + x5_y * s6), -v5
    T[1, 3] = x2_y * a2 + x3_y * a3 - c1 * d4 + z4_y * d5 - v5 * d6
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 + y5_z * s6, y5_z * c6 - x5_z * s6, -v6
    T[2, 3] = d1 + s2 * a2 + x3_z * a3 + -y5_z * d5 - v6 * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2, p2_x, p2_y = s1 * s2, x2_x * a2, x2_y * a2
    p2_z = d1 + s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v3, v4, y3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, c2 * c3 - s2 * s3
    p3_x, p3_y, p3_z = p2_x + x3_x * a3, p2_y + x3_y * a3, p2_z + x3_z * a3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    z4_x, z4_y, p4_x = v3 * c4 + x3_x * s4, v4 * c4 + x3_y * s4, p3_x + s1 * d4
    p4_y, z4_z = p3_y - c1 * d4, x3_z * s4 - y3_z * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    z5_x, v5 = s1 * c5 - (x3_x * c4 - v3 * s4) * s5, c1 * c5 + (x3_y * c4 - v4 * s4) * s5
    v6, p5_x, p5_y = (x3_z * c4 + y3_z * s4) * s5, p4_x + z4_x * d5, p4_y + z4_y * d5
    p5_z, p6_x, p6_y = p3_z + z4_z * d5, p5_x + z5_x * d6, p5_y - v5 * d6
    p6_z = p5_z - v6 * d6
    v7, v8, v9 = p6_z - d1, p6_z - p2_z, p6_z - p3_z
    v10, v11, v12 = p6_x - p4_x, p6_y - p4_y, p6_x - p5_x
    v13, v14 = p6_y - p5_y, p6_z - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, -(c1 * v7), -(c1 * v8)
    J[0, 3], J[0, 4], J[0, 5] = -(c1 * v9), z4_y * v9 - z4_z * v11, v6 * v13 - v5 * v14
    J[1, 0], J[1, 1], J[1, 2] = p6_x, -(s1 * v7), -(s1 * v8)
    J[1, 3], J[1, 4], J[1, 5] = -(s1 * v9), z4_z * v10 - z4_x * v9, -(v6 * v12 + z5_x * v14)
    J[2, 1], J[2, 2] = s1 * p6_y + c1 * p6_x, s1 * (p6_y - p2_y) + c1 * (p6_x - p2_x)
    J[2, 3], J[2, 4] = s1 * (p6_y - p3_y) + c1 * (p6_x - p3_x), z4_x * v11 - z4_y * v10
    J[2, 5] = z5_x * v13 + v5 * v12
    J[3, 1], J[3, 2], J[3, 3] = s1, s1, s1
    J[3, 4], J[3, 5] = z4_x, z5_x
    J[4, 1], J[4, 2], J[4, 3] = -c1, -c1, -c1
    J[4, 4], J[4, 5] = z4_y, -v5
    J[5, 0], J[5, 4], J[5, 5] = 1.0, z4_z, -v6
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
    inverse1 = 1.0 / (N1 if apart1 else d4 * math.sqrt(N1))
    v2, v3 = X1 * d4, wy * d4

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v7 = T34 - d1

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and not apart1:
            continue  # both signs give the same
        D1 = w1 * e1
        c1, s1 = -(inverse1 * (v3 + X1 * D1)), inverse1 * (wy * D1 - v2)
        q1 = _atan2(s1, c1)

        # theta6, type 2: U1 A6^-1 [3, 2]
        X6 = T21 * c1 - T11 * s1
        Y6 = T22 * c1 - T12 * s1
        w6 = math.sqrt(X6 * X6 + Y6 * Y6)
        free6 = w6 <= free_limit
        divisor6 = 1.0 if free6 else w6
        near6 = w6 <= near_limit

        # theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1]
        c5 = T13 * s1 - T23 * c1

        # theta3
        v8 = T14 * c1 + T24 * s1
        v9 = 1.0 if near6 else v1

        for i2 in range(2):  # noflip, flip
            e6 = 1.0 - 2.0 * i2
            # theta6
            if e6 < 0.0 and free6:
                continue  # both signs give the same
            factor6 = e6 / divisor6
            v4, v5 = X6 * factor6, Y6 * factor6
            off6 = w6 * abs(v4 * math.sin(seed[5]) + v5 * math.cos(seed[5])) if near6 else 1.0
            ahead6 = v5 * math.sin(seed[5]) - v4 * math.cos(seed[5]) if near6 else -1.0
            same6 = near6 and 0.0 < ahead6 and off6 <= free_limit
            held6 = free6 or same6
            c6 = math.cos(seed[5]) if held6 else -v4
            s6 = math.sin(seed[5]) if held6 else v5
            q6 = _atan2(s6, c6)
            s5 = w6 * e6

            # theta5
            q5 = _atan2(s5, c5)

            # theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1]
            c234, s234 = c6 * T32 + s6 * T31, c5 * (c6 * T31 - s6 * T32) - s5 * T33
            theta234 = _atan2(s234, c234)

            # theta3
            v6 = d6 * s5
            Z1_3 = c234 * d5 + s234 * v6 + v7
            Z2_3 = c234 * v6 - s234 * d5 + v8
            N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
            K3 = N3 - k5
            D3_squared = (longest3 - N3) * (N3 - shortest3)
            apart3 = shortest3_apart < N3 and N3 < longest3_apart
            if not (-boundary3 <= D3_squared * v9):
                if near6:
                    status[4 * i1 + 2 * i2] = _status.NEARLY + 6
                    q[4 * i1 + 2 * i2, 0] = D3_squared
                    q[4 * i1 + 2 * i2, 1] = _atan2(v5, -v4)
                if free6:
                    status[4 * i1 + 2 * i2] = _status.LOST + 6
                    q[4 * i1 + 2 * i2, 0] = D3_squared
                continue  # out of reach
            w3 = math.sqrt(D3_squared if apart3 else 0.0)
            c3 = K3 * k6

            # theta2, type 3: U1[2, 4] and U1[1, 4]
            X1_2 = a2 + a3 * c3
            v10, v11 = Z1_3 * X1_2, Z2_3 * X1_2

            for i3 in range(2):  # +, -
                e3 = 1.0 - 2.0 * i3
                # theta3
                if (
                    e3 < 0.0 and (not apart3 or (near6 and not (shortest3_clear < N3 and N3 <
                    longest3_clear)))
                ):
                    continue  # both signs give the same
                s3 = w3 * e3 * k6
                q3 = _atan2(s3, c3)

                # theta2
                Y1_2 = a3 * s3
                S2 = v10 - Z2_3 * Y1_2
                C2 = v11 + Z1_3 * Y1_2
                w2 = math.sqrt(S2 * S2 + C2 * C2)
                factor2 = 1.0 / w2
                c2, s2 = C2 * factor2, S2 * factor2
                q2 = _atan2(s2, c2)

                # joint values
                q4 = _wrap(theta234 - (q3 + q2))
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
                q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
                status[row] = FREE_JOINT if free6 else OK


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
        v1, inverse1 = k4 * w1, 1.0 / N1
        v2 = inverse1 * (d4 * wy)
        v3, v4, v5 = v2 + w1 * (X1 * inverse1), v2 + w1 * (inverse1 * -X1), inverse1 * (d4 * X1)
        s1_p, s1_m = w1 * (wy * inverse1) - v5, w1 * (inverse1 * -wy) - v5

        # theta6, type 2: U1 A6^-1 [3, 2]
        v6, v7, v8 = v3 * T21 + s1_p * T11, v4 * T21 + s1_m * T11, v3 * T22 + s1_p * T12
        v9, v10 = v4 * T22 + s1_m * T12, v6 * v6 + v8 * v8
        v11, w6_p = v7 * v7 + v9 * v9, math.sqrt(v10)
        w6_m, v12, v13 = math.sqrt(v11), 1.0 / v10, 1.0 / v11

        # theta5, type 3: U1 A6^-1 [3, 3] and U1 A6^-1 [3, 1]
        c5_p, c5_m = T13 * s1_p + T23 * v3, T13 * s1_m + T23 * v4

        # theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1]
        v14, v15 = v12 * (v6 * T32 - v8 * T31), v13 * (v7 * T32 - v9 * T31)
        c234_p, c234_m, v16 = w6_p * v14, w6_m * v15, v12 * (c5_p * (v6 * T31 + v8 * T32)) - T33
        v17, s234_p = v13 * (c5_m * (v7 * T31 + v9 * T32)) - T33, w6_p * v16
        s234_m = w6_m * v17

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        v18, v19, v20 = d6 * w6_p, d6 * w6_m, T34 - d1
        v21, v22, v23 = d5 * c234_p, d5 * c234_m, s234_p * v18
        v24, Z1_3_pp, Z1_3_pm = s234_m * v19, v20 + (v21 + v23), v20 + (v23 - v21)
        Z1_3_mp, Z1_3_mm, v25 = v20 + (v22 + v24), v20 + (v24 - v22), T24 * s1_p - T14 * v3
        v26, v27, v28 = T24 * s1_m - T14 * v4, c234_p * v18, c234_m * v19
        v29, v30 = d5 * s234_p, d5 * s234_m
        Z2_3_pp, Z2_3_pm, Z2_3_mp = v25 + (v27 - v29), v25 + (v27 + v29), v26 + (v28 - v30)
        Z2_3_mm, N3_pp = v26 + (v28 + v30), Z1_3_pp * Z1_3_pp + Z2_3_pp * Z2_3_pp
        N3_pm, N3_mp = Z1_3_pm * Z1_3_pm + Z2_3_pm * Z2_3_pm, Z1_3_mp * Z1_3_mp + Z2_3_mp * Z2_3_mp
        N3_mm = Z1_3_mm * Z1_3_mm + Z2_3_mm * Z2_3_mm
        D3_squared_pp = (longest3 - N3_pp) * (N3_pp - shortest3)
        D3_squared_pm = (longest3 - N3_pm) * (N3_pm - shortest3)
        D3_squared_mp = (longest3 - N3_mp) * (N3_mp - shortest3)
        D3_squared_mm, w3_pp = (longest3 - N3_mm) * (N3_mm - shortest3), math.sqrt(D3_squared_pp)
        w3_pm, w3_mp = math.sqrt(D3_squared_pm), math.sqrt(D3_squared_mp)
        w3_mm, v31, v32 = math.sqrt(D3_squared_mm), w3_pp - w3_pp, w3_pm - w3_pm
        v33, v34 = w3_mp - w3_mp, w3_mm - w3_mm

        # theta2, type 3: U1[2, 4] and U1[1, 4]
        v35, v36, v37 = m6 + m5 * N3_pp, m6 + m5 * N3_pm, m6 + m5 * N3_mp
        v38, v39, v40 = m6 + m5 * N3_mm, Z1_3_pp * v35, Z1_3_pm * v36
        v41, v42, v43 = Z1_3_mp * v37, Z1_3_mm * v38, Z2_3_pp * v35
        v44, v45, v46 = Z2_3_pm * v36, Z2_3_mp * v37, Z2_3_mm * v38
        v47, v48, v49 = w3_pp * (m5 * Z2_3_pp), w3_pp * (m5 * Z1_3_pp), w3_pm * (m5 * Z2_3_pm)
        v50, v51, v52 = w3_pm * (m5 * Z1_3_pm), w3_mp * (m5 * Z2_3_mp), w3_mp * (m5 * Z1_3_mp)
        v53, v54 = w3_mm * (m5 * Z2_3_mm), w3_mm * (m5 * Z1_3_mm)

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if abs(v1 * D3_squared_mm) <= m4 or abs(v1 * D3_squared_mp) <= m4 or abs(v1 *
            D3_squared_pm) <= m4 or abs(v1 * D3_squared_pp) <= m4 or v11 <= m2 or abs(D1_squared) <=
            m1 or v10 <= m2 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = v8, v9, v16
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v17, v31, v32
        kept[23 * w + k], kept[24 * w + k], turns[0 * w + k] = v33, v34, s1_p
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = s1_m, -v8, -v9
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = w6_p, w6_m, v16
        turns[7 * w + k], turns[8 * w + k], turns[9 * w + k] = v17, w3_pp, w3_pm
        turns[10 * w + k], turns[11 * w + k], turns[12 * w + k] = w3_mp, w3_mm, v47 - v39
        turns[13 * w + k], turns[14 * w + k] = -(v39 + v47), v49 - v40
        turns[15 * w + k], turns[16 * w + k] = -(v40 + v49), v51 - v41
        turns[17 * w + k], turns[18 * w + k] = -(v41 + v51), v53 - v42
        turns[19 * w + k], turns[24 * w + k], turns[25 * w + k] = -(v42 + v53), -v3, -v4
        turns[26 * w + k], turns[27 * w + k], turns[28 * w + k] = v6, v7, c5_p
        turns[29 * w + k], turns[30 * w + k], turns[31 * w + k] = c5_m, v14, v15
        turns[32 * w + k], turns[33 * w + k], turns[34 * w + k] = N3_pp - k5, N3_pm - k5, N3_mp - k5
        turns[35 * w + k], turns[36 * w + k] = N3_mm - k5, -(v43 + v48)
        turns[37 * w + k], turns[38 * w + k], turns[39 * w + k] = v48 - v43, -(v44 + v50), v50 - v44
        turns[40 * w + k], turns[41 * w + k] = -(v45 + v52), v52 - v45
        turns[42 * w + k], turns[43 * w + k] = -(v46 + v54), v54 - v46
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 20 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(20 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        v8, v9, v16 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v17, v31, v32 = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v33, v34, angle1 = kept[23 * w + k], kept[24 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle8, angle9, angle10 = turns[7 * w + k], turns[8 * w + k], turns[9 * w + k]
        angle11, angle12, angle13 = turns[10 * w + k], turns[11 * w + k], turns[12 * w + k]
        angle14, angle15, angle16 = turns[13 * w + k], turns[14 * w + k], turns[15 * w + k]
        angle17, angle18, angle19 = turns[16 * w + k], turns[17 * w + k], turns[18 * w + k]
        angle20 = turns[19 * w + k]

        # theta234, type 3: U0 (A5 A6)^-1 [3, 3] and U0 (A5 A6)^-1 [3, 1]
        theta234_pm = angle7 - math.copysign(half_turn, v16)
        theta234_mm = angle8 - math.copysign(half_turn, v17)

        # joint values
        v55, v56 = angle7 - (angle9 + angle13), angle7 - (angle14 - angle9)
        v57, v58 = theta234_pm - (angle10 + angle15), theta234_pm - (angle16 - angle10)
        v59, v60 = angle8 - (angle11 + angle17), angle8 - (angle18 - angle11)
        v61, v62 = theta234_mm - (angle12 + angle19), theta234_mm - (angle20 - angle12)
        q4_ppp = v55 + (turn if v55 <= -half_turn else (-turn if half_turn < v55 else 0.0))
        q4_ppm = v56 + (turn if v56 <= -half_turn else (-turn if half_turn < v56 else 0.0))
        q4_pmp = v57 + (turn if v57 <= -half_turn else (-turn if half_turn < v57 else 0.0))
        q4_pmm = v58 + (turn if v58 <= -half_turn else (-turn if half_turn < v58 else 0.0))
        q4_mpp = v59 + (turn if v59 <= -half_turn else (-turn if half_turn < v59 else 0.0))
        q4_mpm = v60 + (turn if v60 <= -half_turn else (-turn if half_turn < v60 else 0.0))
        q4_mmp = v61 + (turn if v61 <= -half_turn else (-turn if half_turn < v61 else 0.0))
        q4_mmm = v62 + (turn if v62 <= -half_turn else (-turn if half_turn < v62 else 0.0))
        q1_ppp, q1_pmp, q1_mpp = angle1 + v31, angle1 + v32, angle2 + v33
        q1_mmp, q5_ppp, q5_pmp = angle2 + v34, angle5 + v31, v32 - angle5
        q5_mpp, q5_mmp, q6_ppp = angle6 + v33, v34 - angle6, angle3 + v31
        q6_pmp, q6_mpp = v32 + (angle3 - math.copysign(half_turn, -v8)), angle4 + v33
        q6_mmp = v34 + (angle4 - math.copysign(half_turn, -v9))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, angle13, angle9
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_ppp, q5_ppp, q6_ppp
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = angle14, -angle9, q4_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q1_pmp, angle15, angle10
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q4_pmp, q5_pmp, q6_pmp
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = angle16, -angle10, q4_pmm
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q1_mpp, angle17, angle11
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = q4_mpp, q5_mpp, q6_mpp
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = angle18, -angle11, q4_mpm
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q1_mmp, angle19, angle12
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = q4_mmp, q5_mmp, q6_mmp
        rows[33 * w + k], rows[34 * w + k], rows[35 * w + k] = angle20, -angle12, q4_mmm
        rows[36 * w + k] = rows[37 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[38 * w + k] = rows[39 * w + k] = UNREACHABLE if q1_pmp != q1_pmp else OK
        rows[40 * w + k] = rows[41 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[42 * w + k] = rows[43 * w + k] = UNREACHABLE if q1_mmp != q1_mmp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 25, 48, [
    [0, 1, 2, 3, 4, 5], [0, 6, 7, 8, 4, 5], [9, 10, 11, 12, 13, 14], [9, 15, 16, 17, 13, 14],
    [18, 19, 20, 21, 22, 23], [18, 24, 25, 26, 22, 23], [27, 28, 29, 30, 31, 32],
    [27, 33, 34, 35, 31, 32],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
