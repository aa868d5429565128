# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: c5078a2be1cf5382
"""stanford: Stanford arm.

Inverse kinematics, generated from robots/stanford.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/stanford.yaml. The formulas and where they come from: stanford.md.

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

NAME = "stanford"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRPRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-2.9670597283903604, 2.9670597283903604), (-2.9670597283903604, 2.9670597283903604),
    (0.3048, 1.27), (-2.9670597283903604, 2.9670597283903604),
    (-1.5707963267948966, 1.5707963267948966), (-2.9670597283903604, 2.9670597283903604),
)
BRANCHES = (
    "right-forward-noflip", "right-forward-flip", "right-backward-noflip", "right-backward-flip",
    "left-forward-noflip", "left-forward-flip", "left-backward-noflip", "left-backward-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, reach_slack1 = 1.2700000000000001e-13 [m], merge_slack1 = 1.27e-14 [m],
# doubt_limit1 = 0.000127 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.412  # joint offset 1 [m]
d2 = 0.154  # joint offset 2 [m]
a3 = 0.0203  # link length 3 [m]
free_limit1 = 1.27e-12  # a length that fixes no angle [m]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.13369999999999999  # d2 - a3 [m]
k2 = 0.01787569  # k1^2 [m^2]
k3 = 3.395980000001613e-14  # reach_slack1 * (2 * k1 + reach_slack1) [m^2]
k4 = 3.3959800000001613e-15  # merge_slack1 * (2 * k1 + merge_slack1) [m^2]
high1 = 2.9670597293903604  # highest value of joint 1, with what rounding adds [rad]
high2 = 2.9670597293903604  # highest value of joint 2, with what rounding adds [rad]
low3 = 0.30479999873  # lowest value of joint 3, with what rounding adds [m]
high3 = 1.2700000012700001  # highest value of joint 3, with what rounding adds [m]
per_size = 0.7874015748031495  # slides beyond limits count in the arm's size [m^-1]
high4 = 2.9670597293903604  # highest value of joint 4, with what rounding adds [rad]
high5 = 1.5707963277948966  # highest value of joint 5, with what rounding adds [rad]
high6 = 2.9670597293903604  # highest value of joint 6, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 3.3959800000001614e-12  # 1000 * k4 [m^2]
m2 = 1.6129e-08  # doubt_limit1^2 [m^2]
m4 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.7874, 0.7874, 0.7874, 1.0, 1.0, 1.0), size=1.27,
    slacks=(1e-09, 1e-09, 1.27e-09, 1e-09, 1e-09, 1e-09),
    weights=(1.0, 1.0, 0.62000124000248, 1.0, 1.0, 1.0), paces=(1.0, 1.0, 1.27, 1.0, 1.0, 1.0),
    fan_steps=(
        0.09817477042468103, 0.09817477042468103, 0.030162500000000002, 0.09817477042468103,
        0.09817477042468103, 0.09817477042468103,
    ),
    steps=("keeps limits", "clamps", "clamps far", "follows seed"), choosable=(3, 1),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.412, 0.0, -1.5707963267948966),
    (0.0, 0.154, 0.0, 1.5707963267948966),
    (-1.5707963267948966, 0.0, 0.0203, 0.0),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
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
    x2_x, x2_y, z2_x = c1 * c2, s1 * c2, c1 * s2
    z2_y = s1 * s2
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, v1 = s1 * c4 + x2_x * s4, x2_y * s4 - c1 * c4, s2 * s4
    z4_x, z4_y, v2 = x2_x * c4 - s1 * s4, x2_y * c4 + c1 * s4, s2 * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, v3 = x4_x * c5 - z2_x * s5, x4_y * c5 - z2_y * s5, v1 * c5 + c2 * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + z4_x * s6, z4_x * c6 - x5_x * s6, z2_x * c5 + x4_x * s5
    T[0, 3] = z2_x * q[2] - s1 * d2 + s1 * a3
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 + z4_y * s6, z4_y * c6 - x5_y * s6, z2_y * c5 + x4_y * s5
    T[1, 3] = c1 * d2 + z2_y * q[2] - c1 * a3
    T[2, 0], T[2, 1], T[2, 2] = -(v3 * c6 + v2 * s6), v3 * s6 - v2 * c6, c2 * c5 - v1 * s5
    T[2, 3] = d1 + c2 * q[2]
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, z2_x = c1 * c2, s1 * c2, c1 * s2
    z2_y, p3_x = s1 * s2, z2_x * q[2] - s1 * d2 + s1 * a3
    p3_y = c1 * d2 + z2_y * q[2] - c1 * a3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    c5, s5, v1 = math.cos(q[4]), math.sin(q[4]), d1 + c2 * q[2] - d1
    J[0, 0], J[0, 1], J[0, 2] = -p3_y, c1 * v1, z2_x
    J[1, 0], J[1, 1], J[1, 2] = p3_x, s1 * v1, z2_y
    J[2, 1], J[2, 2] = -(s1 * p3_y + c1 * p3_x), c2
    J[3, 1], J[3, 3], J[3, 4] = -s1, z2_x, x2_x * c4 - s1 * s4
    J[3, 5] = z2_x * c5 + (s1 * c4 + x2_x * s4) * s5
    J[4, 1], J[4, 3], J[4, 4] = c1, z2_y, x2_y * c4 + c1 * s4
    J[4, 5] = z2_y * c5 + (x2_y * s4 - c1 * c4) * s5
    J[5, 0], J[5, 3], J[5, 4] = 1.0, c2, -(s2 * c4)
    J[5, 5] = c2 * c5 - s2 * s4 * s5
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[3, 4]
    N1 = T14 * T14 + T24 * T24
    D1_squared = N1 - k2
    apart1 = k4 < D1_squared
    if not (-k3 <= D1_squared):
        return  # out of reach
    w1 = math.sqrt(D1_squared if apart1 else 0.0)
    inverse1 = 1.0 / (N1 if apart1 else k1 * math.sqrt(N1))
    v1, v2 = T14 * k1, T24 * k1

    # theta2, r3, type 4: U1[1, 4] and U1[2, 4]
    Y2_2 = T34 - d1
    v3 = Y2_2 * Y2_2

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and not apart1:
            continue  # both signs give the same
        D1 = w1 * e1
        c1, s1 = inverse1 * (v2 - T14 * D1), -(inverse1 * (v1 + T24 * D1))
        q1 = _atan2(s1, c1)

        # theta2, r3
        w3 = math.sqrt(D1 * D1 + v3)
        free2 = w3 <= free_limit1
        divisor2 = 1.0 if free2 else w3

        # theta4, type 2: U4[3, 3]
        X4 = T13 * s1 - T23 * c1
        v4, v5 = T13 * c1 + T23 * s1, X4 * X4

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v6, v8, v9 = T12 * c1 + T22 * s1, T22 * c1 - T12 * s1, T11 * c1 + T21 * s1
        v11 = T21 * c1 - T11 * s1

        for i2 in range(2):  # forward, backward
            e2 = 1.0 - 2.0 * i2
            # theta2, r3
            if e2 < 0.0 and free2:
                continue  # both signs give the same
            factor2 = e2 / divisor2
            c2 = math.cos(seed[1]) if free2 else Y2_2 * factor2
            s2 = math.sin(seed[1]) if free2 else -(D1 * factor2)
            q2 = _atan2(s2, c2)
            r3 = w3 * e2

            # theta4
            Y4 = T33 * s2 - c2 * v4
            w4 = math.sqrt(v5 + Y4 * Y4)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[2, 3] and U4[1, 3]
            c5 = T33 * c2 + s2 * v4

            # theta6
            v7, v10 = c2 * v6 - T32 * s2, c2 * v9 - T31 * s2

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
                c6, s6 = c4 * v7 + s4 * v8, c4 * v10 + s4 * v11
                q6 = _atan2(s6, c6)
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0], q[row, 1], q[row, 2] = q1, q2, r3
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

        # theta1, type 2: U1[3, 4]
        N1 = T14 * T14 + T24 * T24
        D1_squared = N1 - k2
        w1 = math.sqrt(D1_squared)
        v1, inverse1, v2 = w1 - w1, 1.0 / N1, k1 * T14
        v3 = k1 * T24
        v4, v5 = inverse1 * v3, w1 * (T14 * inverse1)
        c1_p, c1_m, v6 = v4 - v5, v4 + v5, inverse1 * v2
        v7 = w1 * (T24 * inverse1)
        v8, v9 = v6 + v7, v6 - v7

        # theta2, r3, type 4: U1[1, 4] and U1[2, 4]
        Y2_2 = T34 - d1
        v10 = D1_squared + Y2_2 * Y2_2
        w3 = math.sqrt(v10)
        factor2 = w3 * (1.0 / v10)

        # theta4, type 2: U4[3, 3]
        c4_p, c4_m = v8 * T13 + c1_p * T23, v9 * T13 + c1_m * T23
        v11 = inverse1 * (Y2_2 * (T14 * T13 + T24 * T23)) - T33
        v12 = inverse1 * (Y2_2 * (v2 * T23 - v3 * T13))
        Y4_p, Y4_m = v12 + w1 * v11, v12 + w1 * -v11
        v13, v14 = factor2 * Y4_p, factor2 * Y4_m
        v15, v16 = c4_p * c4_p + factor2 * (Y4_p * v13), c4_m * c4_m + factor2 * (Y4_m * v14)

        # theta5, type 3: U4[2, 3] and U4[1, 3]
        v17 = Y2_2 * T33

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v18 = T32 - inverse1 * (Y2_2 * (T14 * T12 + T24 * T22))
        v19 = inverse1 * (Y2_2 * (v3 * T12 - v2 * T22))
        v20 = T31 - inverse1 * (Y2_2 * (T14 * T11 + T24 * T21))
        v21 = inverse1 * (Y2_2 * (v3 * T11 - v2 * T21))
        s6_p = c4_p * (v21 + w1 * v20) + Y4_p * (c1_p * T21 + v8 * T11)
        s6_m = c4_m * (v21 + w1 * -v20) + Y4_m * (c1_m * T21 + v9 * T11)

        # joint values
        v26, v27 = per_size * max(low3 - w3, w3 - high3), per_size * max(low3 + w3, -(high3 + w3))
        q3_ppp, q3_pmp = v1 + w3, v1 - w3

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if v10 <= m2 or abs(D1_squared) <= m1 or v15 <= m4 or v16 <= m4 else kept[16 * w +
            k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = w1, v13, v14
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v15, v16, s6_p
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = s6_m, v26, v27
        kept[26 * w + k], kept[27 * w + k], turns[0 * w + k] = q3_ppp, q3_pmp, -v8
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = -v9, -w1, v13
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = v14, -math.sqrt(v15), -math.sqrt(v16)
        turns[7 * w + k], turns[8 * w + k], turns[16 * w + k] = s6_p, s6_m, c1_p
        turns[17 * w + k], turns[18 * w + k], turns[19 * w + k] = c1_m, Y2_2, c4_p
        turns[20 * w + k], turns[21 * w + k] = c4_m, factor2 * (v17 - w1 * (c1_p * T13 - v8 * T23))
        turns[22 * w + k] = factor2 * (v17 + w1 * (c1_m * T13 - v9 * T23))
        turns[23 * w + k] = c4_p * (v19 + w1 * v18) + Y4_p * (c1_p * T22 + v8 * T12)
        turns[24 * w + k] = c4_m * (v19 + w1 * -v18) + Y4_m * (c1_m * T22 + v9 * T12)
    if w == 1 and kept[16] != 0.0:
        return
    end = 16 if w == 1 else 9 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(9 * w, end):
        turns[k] = turns[k + 16 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 16 * w])
    for k in range(w):
        w1, v13, v14 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v15, v16, s6_p = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        s6_m, v26, v27 = kept[23 * w + k], kept[24 * w + k], kept[25 * w + k]
        q3_ppp, q3_pmp, angle1 = kept[26 * w + k], kept[27 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle8, angle9 = turns[7 * w + k], turns[8 * w + k]

        # theta2, r3, type 4: U1[1, 4] and U1[2, 4]
        q2_pmp = angle3 - math.copysign(half_turn, -w1)

        # theta4, type 2: U4[3, 3]
        q4_ppm = angle4 - math.copysign(half_turn, v13)
        q4_mpm = angle5 - math.copysign(half_turn, v14)

        # theta5, type 3: U4[2, 3] and U4[1, 3]
        q5_pmp = math.copysign(half_turn, -math.sqrt(v15)) - angle6
        q5_mmp = math.copysign(half_turn, -math.sqrt(v16)) - angle7

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_ppm = angle8 - math.copysign(half_turn, s6_p)
        q6_mpm = angle9 - math.copysign(half_turn, s6_m)

        # joint values
        v22, v23, v24 = abs(angle1) - high1, abs(angle2) - high1, abs(angle3) - high2
        v25, v28, v29 = abs(q2_pmp) - high2, abs(angle4) - high4, abs(q4_ppm) - high4
        v30, v31, v32 = abs(angle5) - high4, abs(q4_mpm) - high4, abs(angle6) - high5
        v33, v34, v35 = abs(q5_pmp) - high5, abs(angle7) - high5, abs(q5_mmp) - high5
        v36, v37, v38 = max(v26, max(v22, v24)), max(v27, max(v22, v25)), max(v26, max(v23, v24))
        v39, v40 = max(v27, max(v23, v25)), abs(angle8) - high6
        excess_ppp, v41 = max(v40, max(v32, max(v28, v36))), abs(q6_ppm) - high6
        excess_ppm = max(v41, max(v32, max(v29, v36)))
        excess_pmp = max(v41, max(v33, max(v28, v37)))
        excess_pmm, v42 = max(v40, max(v33, max(v29, v37))), abs(angle9) - high6
        excess_mpp, v43 = max(v42, max(v34, max(v30, v38))), abs(q6_mpm) - high6
        excess_mpm = max(v43, max(v34, max(v31, v38)))
        excess_mmp = max(v43, max(v35, max(v30, v39)))
        excess_mmm, outside_ppp = max(v42, max(v35, max(v31, v39))), 0.0 < excess_ppp
        outside_ppm, outside_pmp, outside_pmm = 0.0 < excess_ppm, 0.0 < excess_pmp, 0.0 < excess_pmm
        outside_mpp, outside_mpm, outside_mmp = 0.0 < excess_mpp, 0.0 < excess_mpm, 0.0 < excess_mmp
        outside_mmm = 0.0 < excess_mmm

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if abs(excess_mmm - limit_slack) <= limit_slack or abs(excess_mmp - limit_slack) <=
            limit_slack or abs(excess_mpm - limit_slack) <= limit_slack or abs(excess_mpp -
            limit_slack) <= limit_slack or abs(excess_pmm - limit_slack) <= limit_slack or
            abs(excess_pmp - limit_slack) <= limit_slack or abs(excess_ppp - limit_slack) <=
            limit_slack or abs(excess_ppm - limit_slack) <= limit_slack else kept[16 * w + k]
        )

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle1, angle3, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle4, angle6, angle8
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, -angle6, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q2_pmp, q3_pmp, -angle4
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q5_pmp, -q4_ppm, -q5_pmp
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = angle2, -angle3, angle5
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = angle7, angle9, q4_mpm
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = -angle7, q6_mpm, -q2_pmp
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = -angle5, q5_mmp, -q4_mpm
        rows[27 * w + k] = -q5_mmp
        rows[28 * w + k] = (
            UNREACHABLE if angle1 != angle1 else (OUT_OF_LIMITS if outside_ppp else OK)
        )
        rows[29 * w + k] = (
            UNREACHABLE if angle1 != angle1 else (OUT_OF_LIMITS if outside_ppm else OK)
        )
        rows[30 * w + k] = (
            UNREACHABLE if angle1 != angle1 else (OUT_OF_LIMITS if outside_pmp else OK)
        )
        rows[31 * w + k] = (
            UNREACHABLE if angle1 != angle1 else (OUT_OF_LIMITS if outside_pmm else OK)
        )
        rows[32 * w + k] = (
            UNREACHABLE if angle2 != angle2 else (OUT_OF_LIMITS if outside_mpp else OK)
        )
        rows[33 * w + k] = (
            UNREACHABLE if angle2 != angle2 else (OUT_OF_LIMITS if outside_mpm else OK)
        )
        rows[34 * w + k] = (
            UNREACHABLE if angle2 != angle2 else (OUT_OF_LIMITS if outside_mmp else OK)
        )
        rows[35 * w + k] = (
            UNREACHABLE if angle2 != angle2 else (OUT_OF_LIMITS if outside_mmm else OK)
        )


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 28, 32, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 8], [0, 9, 10, 13, 14, 5],
    [15, 16, 2, 17, 18, 19], [15, 16, 2, 20, 21, 22], [15, 23, 10, 24, 25, 22],
    [15, 23, 10, 26, 27, 19],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
