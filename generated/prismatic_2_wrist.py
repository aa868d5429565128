# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 25f4fcfbeffc6717
"""prismatic_2_wrist: Slide as joint 2, spherical wrist.

Inverse kinematics, generated from robots/prismatic_2_wrist.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/prismatic_2_wrist.yaml. The formulas and where they come from:
prismatic_2_wrist.md.

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

NAME = "prismatic_2_wrist"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RPRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "shoulder+-elbow+-noflip", "shoulder+-elbow+-flip", "shoulder+-elbow--noflip",
    "shoulder+-elbow--flip", "shoulder--elbow+-noflip", "shoulder--elbow+-flip",
    "shoulder--elbow--noflip", "shoulder--elbow--flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, d1 = 0.3 [m], doubt_limit = 9.999999999999999e-05.
a1 = 0.1  # link length 1 [m]
cat2 = 0.9800665778412416  # cosine of the angle of joint 2
sat2 = 0.19866933079506122  # sine of the angle of joint 2
a2 = 0.15  # link length 2 [m]
d3 = 0.1  # joint offset 3 [m]
a3 = 0.08  # link length 3 [m]
d4 = 0.43  # joint offset 4 [m]
d6 = 0.08  # joint offset 6 [m]
free_limit_squared2 = 1.5375999999999999e-24  # square of a length that fixes no angle [m^2]
reach_slack1 = 1.24e-13  # rounding at the boundary of the workspace [m]
merge_slack1 = 1.24e-14  # nearer to that boundary two branches are one [m]
# the same where they follow an angle that is good to few digits [m]
blur_slack1 = 1.2399999999999999e-11
# square of a length whose direction is good to few digits [m^2]
near_limit_squared2 = 1.5376000000000001e-06
free_limit1 = 1.24e-12  # a length that fixes no angle [m]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.4138869064318786  # d1 * cat2 + (a1 * sat2 + d3) [m]
k2 = 0.08542781224187632  # d4 * sat2 [m]
k3 = 0.0158935464636049  # a3 * sat2 [m]
k4 = 0.007550515923624042  # k2^2 + k3^2 [m^2]
k5 = 0.36820625816486496  # d1 + (cat2 * d3 - a2 * sat2) [m]
k6 = 132.4412808495909  # 1 / k4 [m^-2]
f1 = 0.2701996003807408  # d1 - sat2 * a2 [m]
f2 = 0.09800665778412417  # d3 * cat2 [m]
doubt_limit_squared2 = 1.5375999999999998e-08  # square of a length that fixes no angle [m^2]
m1 = 1.2399999999999999e-11  # 1000 * merge_slack1 [m]
m2 = 1.2399999999999999e-10  # 10 * blur_slack1 [m]
m3 = 11.314168873492461  # k2 * k6 [m^-1]
m4 = 0.7750600530519154  # k3 * k5 * k6
m5 = 2.1049616508823186  # k3 * k6 [m^-1]
m6 = 4.165947785154044  # k2 * k5 * k6
m7 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.8065, 0.8065, 0.8065, 1.0, 1.0, 1.0), size=1.24,
    slacks=(1e-09, 1.24e-09, 1e-09, 1e-09, 1e-09, 1e-09),
    weights=(1.0, 0.6503642039542143, 1.0, 1.0, 1.0, 1.0), paces=(1.0, 1.24, 1.0, 1.0, 1.0, 1.0),
    steps=("merges", "follows seed"),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.3, 0.1, -1.5707963267948966),
    (0.2, 0.0, 0.15, 1.5707963267948966),
    (0.0, 0.1, 0.08, -1.5707963267948966),
    (0.0, 0.43, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.08, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    x2_x, x2_y, z2_x = c1 * cat2, s1 * cat2, c1 * sat2
    z2_y = s1 * sat2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v1 = x2_x * c3 - s1 * s3, x2_y * c3 + c1 * s3, sat2 * c3
    v2, z3_y, z3_z = s1 * c3 + x2_x * s3, c1 * c3 - x2_y * s3, sat2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, v3 = x3_x * c4 - z2_x * s4, x3_y * c4 - z2_y * s4, v1 * c4 + cat2 * s4
    z4_x, z4_y, y5_z = z2_x * c4 + x3_x * s4, z2_y * c4 + x3_y * s4, v1 * s4 - cat2 * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 - v2 * s5, x4_y * c5 + z3_y * s5, z3_z * s5 - v3 * c5
    v4, z5_y, z5_z = v2 * c5 + x4_x * s5, z3_y * c5 - x4_y * s5, z3_z * c5 + v3 * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 - z4_x * s6, -(z4_x * c6 + x5_x * s6), -v4
    T[0, 3] = c1 * a1 - s1 * q[1] + x2_x * a2 + x3_x * a3 + z2_x * d3 - v2 * d4 - v4 * d6
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 - z4_y * s6, -(z4_y * c6 + x5_y * s6), z5_y
    T[1, 3] = s1 * a1 + c1 * q[1] + x2_y * a2 + x3_y * a3 + z2_y * d3 + z3_y * d4 + z5_y * d6
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 + y5_z * s6, y5_z * c6 - x5_z * s6, z5_z
    T[2, 3] = f1 - v1 * a3 + f2 + z3_z * d4 + z5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    x2_x, x2_y, z2_x = c1 * cat2, s1 * cat2, c1 * sat2
    z2_y, p2_x, p2_y = s1 * sat2, c1 * a1 - s1 * q[1] + x2_x * a2, s1 * a1 + c1 * q[1] + x2_y * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v1 = x2_x * c3 - s1 * s3, x2_y * c3 + c1 * s3, sat2 * c3
    v2, z3_y, z3_z = s1 * c3 + x2_x * s3, c1 * c3 - x2_y * s3, sat2 * s3
    p3_x, p3_y, p3_z = p2_x + x3_x * a3 + z2_x * d3, p2_y + x3_y * a3 + z2_y * d3, f1 - v1 * a3 + f2
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    z4_x, z4_y, p4_x = z2_x * c4 + x3_x * s4, z2_y * c4 + x3_y * s4, p3_x - v2 * d4
    p4_y, p4_z, z4_z = p3_y + z3_y * d4, p3_z + z3_z * d4, cat2 * c4 - v1 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    v3, z5_y = v2 * c5 + (x3_x * c4 - z2_x * s4) * s5, z3_y * c5 - (x3_y * c4 - z2_y * s4) * s5
    z5_z, p6_x, p6_y = z3_z * c5 + (v1 * c4 + cat2 * s4) * s5, p4_x - v3 * d6, p4_y + z5_y * d6
    p6_z, v4, v5 = p4_z + z5_z * d6, p6_x - p2_x, p6_y - p2_y
    v6, v7, v8 = p6_z - f1, p6_x - p3_x, p6_y - p3_y
    v9, v10, v11 = p6_z - p3_z, p6_x - p4_x, p6_y - p4_y
    v12 = p6_z - p4_z
    J[0, 0], J[0, 1], J[0, 2] = -p6_y, -s1, z2_y * v6 - cat2 * v5
    J[0, 3], J[0, 4] = z3_y * v9 - z3_z * v8, z4_y * v12 - z4_z * v11
    J[0, 5] = z5_y * v12 - z5_z * v11
    J[1, 0], J[1, 1], J[1, 2] = p6_x, c1, cat2 * v4 - z2_x * v6
    J[1, 3], J[1, 4], J[1, 5] = z3_z * v7 + v2 * v9, z4_z * v10 - z4_x * v12, z5_z * v10 + v3 * v12
    J[2, 2], J[2, 3] = z2_x * v5 - z2_y * v4, -(v2 * v8 + z3_y * v7)
    J[2, 4], J[2, 5] = z4_x * v11 - z4_y * v10, -(v3 * v11 + z5_y * v10)
    J[3, 2], J[3, 3], J[3, 4] = z2_x, -v2, z4_x
    J[3, 5] = -v3
    J[4, 2], J[4, 3], J[4, 4] = z2_y, z3_y, z4_y
    J[4, 5] = z5_y
    J[5, 0], J[5, 2], J[5, 3] = 1.0, cat2, z3_z
    J[5, 4], J[5, 5] = z4_z, z5_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U2 A6^-1 [3, 4]
    wy = T24 - T23 * d6
    v1 = wy * sat2
    wx = T14 - d6 * T13
    v2 = sat2 * wx
    N1 = v1 * v1 + v2 * v2
    free1 = N1 <= free_limit_squared2
    wz = T34 - d6 * T33
    Z1 = wz * cat2 - k1
    D1_squared = N1 - Z1 * Z1
    v3 = abs(Z1)
    v4 = 2.0 * v3
    apart1 = merge_slack1 * (v4 + merge_slack1) < D1_squared
    if not (-(reach_slack1 * (v4 + reach_slack1)) < D1_squared):
        return  # out of reach
    w1 = math.sqrt(D1_squared if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else v3 * math.sqrt(N1)))
    v5, v6 = v1 * Z1, v2 * Z1
    near1 = N1 <= near_limit_squared2
    v7 = v1 * math.cos(seed[0]) - v2 * math.sin(seed[0])
    off1 = abs(Z1 + (v1 * math.sin(seed[0]) + v2 * math.cos(seed[0]))) if near1 else 1.0
    v8 = off1 <= free_limit1

    # theta3, type 2: U0 A6^-1 [3, 4]
    Z3 = wz - k5
    D3_squared = k4 - Z3 * Z3
    v9 = 2.0 * abs(Z3)
    apart3 = merge_slack1 * (merge_slack1 + v9) < D3_squared
    if not (-(reach_slack1 * (reach_slack1 + v9)) < D3_squared):
        return  # out of reach
    w3 = math.sqrt(D3_squared if apart3 else 0.0)
    v10, v11 = k2 * Z3, k3 * Z3

    # theta4, type 2: U4[3, 3]
    v15, v16, v17 = T13 * cat2, T23 * cat2, sat2 * T33
    v20, v21, v22 = sat2 * T13, T23 * sat2, T33 * cat2

    # theta6, type 3: U4[3, 2] and U4[3, 1]
    v25, v26, v27 = sat2 * T12, T22 * sat2, T32 * cat2
    v29, v30, v31 = T12 * cat2, T22 * cat2, sat2 * T32
    v35, v36, v37 = sat2 * T11, T21 * sat2, T31 * cat2
    v39, v40, v41 = T11 * cat2, T21 * cat2, sat2 * T31

    for i1 in range(2):  # shoulder+, shoulder-
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        D1 = w1 * e1
        ahead1 = D1 * v7 if near1 else -1.0
        same1 = near1 and 0.0 <= ahead1 and v8
        held1 = free1 or same1
        c1 = math.cos(seed[0]) if held1 else inverse1 * (v1 * D1 - v6)
        s1 = math.sin(seed[0]) if held1 else -(inverse1 * (v5 + v2 * D1))
        q1 = _atan2(s1, c1)

        # r2, type 1: U1 A6^-1 [3, 4]
        v14 = c1 * -wy + wx * s1

        # theta4
        v18, v19, v23 = c1 * v15 + s1 * v16 - v17, T13 * s1 - T23 * c1, c1 * v20 + s1 * v21 + v22
        v24 = v23 * v23

        # theta6
        v28, v32, v33 = c1 * v25 + s1 * v26 + v27, c1 * v29 + s1 * v30 - v31, T22 * c1 - T12 * s1
        v38, v42, v43 = c1 * v35 + s1 * v36 + v37, c1 * v39 + s1 * v40 - v41, T21 * c1 - T11 * s1

        for i2 in range(2):  # elbow+, elbow-
            e3 = 1.0 - 2.0 * i2
            # theta3
            if (
                e3 < 0.0 and (not apart3 or (near1 and not (blur_slack1 * (blur_slack1 + v9) <
                D3_squared)))
            ):
                continue  # both signs give the same
            D3 = w3 * e3
            v12 = k6 * (v11 + k2 * D3)
            s3 = k6 * (v10 - k3 * D3)
            q3 = _atan2(s3, -v12)

            # r2
            v13 = a3 * s3 - d4 * v12

            # theta4
            X4 = v12 * v18 - s3 * -v19
            w4 = math.sqrt(X4 * X4 + v24)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = v12 * v19 - s3 * v18

            # theta6
            v34, v44 = s3 * v33 - v12 * v32, s3 * v43 - v12 * v42

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else -(v23 * factor4)
                q4 = _atan2(s4, c4)

                # theta5
                q5 = _atan2(-(w4 * e4), c5)

                # theta6
                q6 = _atan2(-(c4 * v38 + s4 * v44), -(c4 * v28 + s4 * v34))
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0], q[row, 1], q[row, 2] = q1, -(v13 + v14), q3
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

        # theta1, type 2: U2 A6^-1 [3, 4]
        wy = T24 - d6 * T23
        v1, wx = sat2 * wy, T14 - d6 * T13
        v2 = sat2 * wx
        N1, wz = v1 * v1 + v2 * v2, T34 - d6 * T33
        Z1 = cat2 * wz - k1
        D1_squared = N1 - Z1 * Z1
        w1 = math.sqrt(D1_squared)
        v3, inverse1, v4 = w1 - w1, 1.0 / N1, v1 * Z1
        v5 = v2 * Z1
        v6, v7 = inverse1 * v5, w1 * (v1 * inverse1)
        c1_p, v8, v9 = v7 - v6, v6 + v7, inverse1 * v4
        v10 = w1 * (v2 * inverse1)
        v11, v12 = v9 + v10, v9 - v10

        # theta3, type 2: U0 A6^-1 [3, 4]
        Z3 = wz - k5
        D3_squared = k4 - Z3 * Z3
        w3 = math.sqrt(D3_squared)
        v13, v14, v15 = w3 - w3, m5 * wz - m4, m3 * w3
        v16, v17, v18 = v14 + v15, v14 - v15, m3 * wz - m6
        v19 = m5 * w3
        s3_p, s3_m = v18 - v19, v18 + v19

        # r2, type 1: U1 A6^-1 [3, 4]
        v20, v21, v22 = a3 * s3_p - d4 * v16, a3 * s3_m - d4 * v17, c1_p * -wy - wx * v11
        v23 = v8 * -wy + wx * v12

        # theta4, type 2: U4[3, 3]
        v24, v25 = cat2 * T13, cat2 * T23
        v26, v27 = v1 * v24 - v2 * v25, sat2 * T33 + inverse1 * (v4 * v25 + v5 * v24)
        v28, v29 = w1 * (inverse1 * v26) - v27, w1 * (inverse1 * -v26) - v27
        v30, v31 = T13 * v11 + T23 * c1_p, T13 * v12 - T23 * v8
        X4_pp, X4_pm, X4_mp = v16 * v28 - s3_p * v30, v17 * v28 - s3_m * v30, v16 * v29 - s3_p * v31
        X4_mm, v32, v33 = v17 * v29 - s3_m * v31, sat2 * T13, sat2 * T23
        v34, v35 = v1 * v32 - v2 * v33, cat2 * T33 - inverse1 * (v4 * v33 + v5 * v32)
        v36, v37 = v35 + w1 * (inverse1 * v34), v35 + w1 * (inverse1 * -v34)
        v38, v39 = v36 * v36, v37 * v37
        v40, v41, v42 = v38 + X4_pp * X4_pp, v38 + X4_pm * X4_pm, v39 + X4_mp * X4_mp
        v43, v44 = v39 + X4_mm * X4_mm, math.copysign(half_turn, -v36)
        v45 = math.copysign(half_turn, -v37)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v46, v47 = sat2 * T12, sat2 * T22
        v48, v49 = v1 * v46 - v2 * v47, cat2 * T32 - inverse1 * (v4 * v47 + v5 * v46)
        v50, v51, v52 = v49 + w1 * (inverse1 * v48), v49 + w1 * (inverse1 * -v48), cat2 * T12
        v53 = cat2 * T22
        v54, v55 = v1 * v52 - v2 * v53, sat2 * T32 + inverse1 * (v4 * v53 + v5 * v52)
        v56, v57 = w1 * (inverse1 * v54) - v55, w1 * (inverse1 * -v54) - v55
        v58, v59, v60 = c1_p * T22 + v11 * T12, v12 * T12 - v8 * T22, sat2 * T11
        v61 = sat2 * T21
        v62, v63 = v1 * v60 - v2 * v61, cat2 * T31 - inverse1 * (v4 * v61 + v5 * v60)
        v64, v65, v66 = v63 + w1 * (inverse1 * v62), v63 + w1 * (inverse1 * -v62), cat2 * T11
        v67 = cat2 * T21
        v68, v69 = v1 * v66 - v2 * v67, sat2 * T31 + inverse1 * (v4 * v67 + v5 * v66)
        v70, v71 = w1 * (inverse1 * v68) - v69, w1 * (inverse1 * -v68) - v69
        v72, v73 = c1_p * T21 + v11 * T11, v12 * T11 - v8 * T21
        v74 = v36 * (s3_p * v72 - v16 * v70) - -X4_pp * v64
        v75 = v36 * (s3_m * v72 - v17 * v70) - -X4_pm * v64
        v76 = v37 * (s3_p * v73 - v16 * v71) - -X4_mp * v65
        v77 = v37 * (s3_m * v73 - v17 * v71) - -X4_mm * v65

        # joint values
        q2_mpp, q2_mmp = v23 - v20, v23 - v21

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if abs(D1_squared) <= m1 * (merge_slack1 + 2.0 * abs(Z1)) or N1 <=
            doubt_limit_squared2 or abs(D3_squared) <= m2 * (blur_slack1 + 2.0 * abs(Z3)) or v43 <=
            m7 or v42 <= m7 or v40 <= m7 or v41 <= m7 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = v3, v13, v20
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v21, v22, v44
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = v45, v74, v75
        kept[26 * w + k], kept[27 * w + k], kept[28 * w + k] = v76, v77, q2_mpp
        kept[29 * w + k], turns[0 * w + k], turns[1 * w + k] = q2_mmp, -v36, -v36
        turns[2 * w + k], turns[3 * w + k], turns[4 * w + k] = -v37, -v37, -math.sqrt(v40)
        turns[5 * w + k], turns[6 * w + k] = -math.sqrt(v41), -math.sqrt(v42)
        turns[7 * w + k], turns[8 * w + k], turns[9 * w + k] = -math.sqrt(v43), v74, v75
        turns[10 * w + k], turns[11 * w + k], turns[12 * w + k] = v76, v77, -v11
        turns[13 * w + k], turns[14 * w + k], turns[15 * w + k] = -v12, s3_p, s3_m
        turns[16 * w + k], turns[17 * w + k], turns[18 * w + k] = -X4_pp, -X4_pm, -X4_mp
        turns[19 * w + k], turns[20 * w + k] = -X4_mm, -(v16 * v30 + s3_p * v28)
        turns[21 * w + k], turns[22 * w + k] = -(v17 * v30 + s3_m * v28), -(v16 * v31 + s3_p * v29)
        turns[23 * w + k] = -(v17 * v31 + s3_m * v29)
        turns[24 * w + k] = v36 * (s3_p * v58 - v16 * v56) - -X4_pp * v50
        turns[25 * w + k] = v36 * (s3_m * v58 - v17 * v56) - -X4_pm * v50
        turns[26 * w + k] = v37 * (s3_p * v59 - v16 * v57) - -X4_mp * v51
        turns[27 * w + k], turns[28 * w + k] = v37 * (s3_m * v59 - v17 * v57) - -X4_mm * v51, c1_p
        turns[29 * w + k], turns[30 * w + k], turns[31 * w + k] = -v8, -v16, -v17
    if w == 1 and kept[16] != 0.0:
        return
    for k in range(0 * w, 16 * w):
        turns[k] = _atan2(turns[k], turns[k + 16 * w])
    for k in range(w):
        v3, v13, v20 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v21, v22, v44 = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v45, v74, v75 = kept[23 * w + k], kept[24 * w + k], kept[25 * w + k]
        v76, v77, q2_mpp = kept[26 * w + k], kept[27 * w + k], kept[28 * w + k]
        q2_mmp, angle1, angle2 = kept[29 * w + k], turns[0 * w + k], turns[1 * w + k]
        angle3, angle4, angle5 = turns[2 * w + k], turns[3 * w + k], turns[4 * w + k]
        angle6, angle7, angle8 = turns[5 * w + k], turns[6 * w + k], turns[7 * w + k]
        angle9, angle10, angle11 = turns[8 * w + k], turns[9 * w + k], turns[10 * w + k]
        angle12, angle13, angle14 = turns[11 * w + k], turns[12 * w + k], turns[13 * w + k]
        angle15, angle16 = turns[14 * w + k], turns[15 * w + k]

        # theta4, type 2: U4[3, 3]
        q4_ppm, q4_pmm, q4_mpm = angle1 - v44, angle2 - v44, angle3 - v45
        q4_mmm = angle4 - v45

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle9 - math.copysign(half_turn, v74)
        q6_pmm = angle10 - math.copysign(half_turn, v75)
        q6_mpm = angle11 - math.copysign(half_turn, v76)
        q6_mmm = angle12 - math.copysign(half_turn, v77)

        # joint values
        q1_ppp, q1_mpp, q3_ppp = v13 + angle13, v13 + angle14, v3 + angle15
        q3_pmp = v3 + angle16

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, -(v20 + v22), q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle1, angle5, angle9
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, -angle5, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = -(v21 + v22), q3_pmp, angle2
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = angle6, angle10, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = -angle6, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = q2_mpp, angle3, angle7
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = angle11, q4_mpm, -angle7
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q6_mpm, q2_mmp, angle4
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = angle8, angle12, q4_mmm
        rows[30 * w + k], rows[31 * w + k] = -angle8, q6_mmm
        rows[32 * w + k] = rows[33 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[34 * w + k] = rows[35 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[36 * w + k] = rows[37 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[38 * w + k] = rows[39 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 30, 32, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 2, 19, 20, 21], [17, 18, 2, 22, 23, 24], [17, 25, 10, 26, 27, 28],
    [17, 25, 10, 29, 30, 31],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
