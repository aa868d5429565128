# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: cd4e6518e19091b2
"""puma: PUMA in its reference position.

Inverse kinematics, generated from robots/puma.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/puma.yaml. The formulas and where they come from: puma.md.

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

NAME = "puma"
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

# In formulas below, reach_slack1 = 1.890188625788961e-13 [m],
# merge_slack1 = 1.890188625788961e-14 [m], arm_size1 = 1.8901886257889609 [m],
# doubt_limit_squared2 = 3.57281304106196e-08 [m^2], doubt_limit = 9.999999999999999e-05.
L2 = 0.4318  # z of axis 3 [m]
D3 = 0.15005  # x of axis 4 [m]
D4 = 0.4318  # z of axis 5 [m]
free_limit_squared2 = 3.57281304106196e-24  # square of a length that fixes no angle [m^2]
least_root1 = 5.977301264836799e-07  # a root of nothing, by rounding [m]
longest3 = 0.7458049600000001  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
boundary3 = 2.435176934946171e-13  # rounding at the boundary of the workspace [m^4]
longest3_apart = 0.7458049599999674  # the longest, where branches merge [m^2]
shortest3_apart = 3.5728130410619605e-28  # the shortest, where branches merge [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 0.8636  # L2 + D4 [m]
k2 = 0.022515002499999996  # D3^2 [m^2]
k3 = 5.6724560659962443e-14  # reach_slack1 * (2 * D3 + reach_slack1) [m^2]
k4 = 5.672456065993029e-15  # merge_slack1 * (2 * D3 + merge_slack1) [m^2]
k5 = 0.5290477290765635  # 1 / arm_size1 [m^-1]
k6 = 0.37290248000000004  # 2 * D4 * L2 [m^2]
k7 = 2.681666262986505  # 1 / k6 [m^-2]
f1 = 0.8636  # L2 + D4 [m]
g1 = 0.8636  # L2 + D4 [m]
m1 = 5.672456065993029e-12  # 1000 * k4 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m2 = 2.4343489251065266e-11
m3 = 1.1579434923575729  # D4 * k7 [m^-1]
m4 = 1.276499302638241e-15  # doubt_limit_squared2^2 [m^4]
m5 = 3.105217997900075  # D4 * k7^2 [m^-3]
m6 = 2.3158869847151458  # D4 * longest3 * k7^2 [m^-1]
m7 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.529, 0.529, 0.529, 1.0, 1.0, 1.0), size=1.8901886257889609,
    steps=("merges", "refines", "follows seed"),
))

# The axes at q = 0: a unit vector along each, and a point of it [m].
AXES = (
    (0.0, 0.0, 1.0, 0.0, 0.0, 0.0),
    (1.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    (1.0, 0.0, 0.0, 0.0, 0.0, 0.4318),
    (0.0, 0.0, 1.0, 0.15005, 0.0, 0.0),
    (1.0, 0.0, 0.0, 0.15005, 0.0, 0.8636),
    (0.0, 0.0, 1.0, 0.15005, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=AXES, convention="axes",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, v1, y2_x = s1 * s2, c1 * s2, s1 * c2
    v2 = c1 * c2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, v3, x3_z = x2_x * c3 + y2_x * s3, v1 * c3 + v2 * s3, c2 * c3 - s2 * s3
    v4, v5, v6 = s2 * c3 + c2 * s3, x2_x * s3 - y2_x * c3, v2 * c3 - v1 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = c1 * c4 + v5 * s4, s1 * c4 + v6 * s4, v4 * s4
    y4_z, v7, v8 = v4 * c4, c1 * s4 - v5 * c4, s1 * s4 - v6 * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x3_x * c5 + v7 * s5, v8 * s5 - v3 * c5, x3_z * c5 - y4_z * s5
    y5_y, v9, v10 = v8 * c5 + v3 * s5, y4_z * c5 + x3_z * s5, x3_x * s5 - v7 * c5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    x6_x, x6_y, x6_z = x4_x * c6 + v10 * s6, x4_y * c6 - y5_y * s6, x4_z * c6 + v9 * s6
    T[0, 0], T[0, 1], T[0, 2] = x6_x, v10 * c6 - x4_x * s6, x5_x
    T[0, 3] = x2_x * L2 + c1 * D3 + x3_x * D4 - D3 * x6_x - x5_x * f1
    T[1, 0], T[1, 1], T[1, 2] = x6_y, -(y5_y * c6 + x4_y * s6), x5_y
    T[1, 3] = s1 * D3 - v1 * L2 - v3 * D4 - D3 * x6_y - x5_y * f1
    T[2, 0], T[2, 1], T[2, 2] = x6_z, v9 * c6 - x4_z * s6, x5_z
    T[2, 3] = c2 * L2 + x3_z * D4 - D3 * x6_z - x5_z * f1
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, v1, y2_x = s1 * s2, c1 * s2, s1 * c2
    v2, p3_x, v3 = c1 * c2, x2_x * L2, v1 * L2
    p3_z = c2 * L2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, v4, x3_z = x2_x * c3 + y2_x * s3, v1 * c3 + v2 * s3, c2 * c3 - s2 * s3
    v5, p4_x, p4_y = s2 * c3 + c2 * s3, p3_x + c1 * D3, s1 * D3 - v3
    v6, v7 = x2_x * s3 - y2_x * c3, v2 * c3 - v1 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = c1 * c4 + v6 * s4, s1 * c4 + v7 * s4, v5 * s4
    y4_z, p5_x, p5_y = v5 * c4, p4_x + x3_x * D4, p4_y - v4 * D4
    p5_z, v8, v9 = p3_z + x3_z * D4, c1 * s4 - v6 * c4, s1 * s4 - v7 * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x3_x * c5 + v8 * s5, v9 * s5 - v4 * c5, x3_z * c5 - y4_z * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    J21 = p5_x - D3 * (x4_x * c6 + (x3_x * s5 - v8 * c5) * s6) - x5_x * g1
    v10 = p5_y - D3 * (x4_y * c6 - (v9 * c5 + v4 * s5) * s6) - x5_y * g1
    v11 = p5_z - D3 * (x4_z * c6 + (y4_z * c5 + x3_z * s5) * s6) - x5_z * g1
    v12, v13, v14 = v11 - p3_z, J21 - p4_x, v10 - p4_y
    v15, v16, v17 = J21 - p5_x, v10 - p5_y, v11 - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -v10, s1 * v11, s1 * v12
    J[0, 3], J[0, 4] = -(v4 * v12 + x3_z * v14), x4_y * v17 - x4_z * v16
    J[0, 5] = x5_y * v17 - x5_z * v16
    J[1, 0], J[1, 1], J[1, 2] = J21, -(c1 * v11), -(c1 * v12)
    J[1, 3], J[1, 4] = x3_z * v13 - x3_x * v12, x4_z * v15 - x4_x * v17
    J[1, 5] = x5_z * v15 - x5_x * v17
    J[2, 1], J[2, 2] = c1 * v10 - s1 * J21, c1 * (v3 + v10) - s1 * (J21 - p3_x)
    J[2, 3], J[2, 4] = x3_x * v14 + v4 * v13, x4_x * v16 - x4_y * v15
    J[2, 5] = x5_x * v16 - x5_y * v15
    J[3, 1], J[3, 2], J[3, 3] = c1, c1, x3_x
    J[3, 4], J[3, 5] = x4_x, x5_x
    J[4, 1], J[4, 2], J[4, 3] = s1, s1, -v4
    J[4, 4], J[4, 5] = x4_y, x5_y
    J[5, 0], J[5, 3], J[5, 4] = 1.0, x3_z, x4_z
    J[5, 5] = x5_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[1, 4]
    t24 = T24 + D3 * T21 + k1 * T23
    t14 = T14 + D3 * T11 + k1 * T13
    N1 = t24 * t24 + t14 * t14
    D1_squared = N1 - k2
    apart1 = k4 < D1_squared
    if not (-k3 <= D1_squared):
        return  # out of reach
    w1 = math.sqrt(D1_squared if apart1 else 0.0)
    v1 = (w1 if apart1 else least_root1) * k5
    inverse1 = 1.0 / (N1 if apart1 else D3 * math.sqrt(N1))
    v2, v3 = D3 * t24, D3 * t14

    # theta3, type 8: U1[3, 4] and U1[2, 4]
    t34 = T34 + D3 * T31 + k1 * T33
    v4 = t34 * t34

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and not apart1:
            continue  # both signs give the same
        D1 = w1 * e1
        c1, s1 = inverse1 * (v3 + t24 * D1), inverse1 * (v2 - t14 * D1)
        q1 = _atan2(s1, c1)

        # theta3
        N3 = v4 + D1 * D1
        K3 = N3 - k6
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (-boundary3 <= v1 * D3_squared):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        c3 = K3 * k7

        # theta2, type 3: U1[3, 4] and U1[2, 4]
        Y1_2 = L2 + D4 * c3
        v6, v8 = D1 * Y1_2, t34 * Y1_2

        # theta4, type 2: U4[1, 3]
        v9, v10 = T13 * s1 - T23 * c1, T13 * c1 + T23 * s1
        v11 = v10 * v10

        # theta6, type 3: U4[1, 2] and U4[1, 1]
        v12, v13, v15 = T12 * c1 + T22 * s1, T12 * s1 - T22 * c1, T11 * c1 + T21 * s1
        v16 = T11 * s1 - T21 * c1

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            s3 = w3 * e3 * k7
            q3 = _atan2(s3, c3)

            # theta2
            v5 = D4 * s3
            v7 = t34 * v5 + v6
            C2 = v8 - D1 * v5
            w2 = math.sqrt(v7 * v7 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else -(v7 * factor2)
            q2 = _atan2(s2, c2)

            # theta4
            c23, s23 = c3 * c2 - s3 * s2, c3 * s2 + s3 * c2
            X4 = c23 * v9 - T33 * s23
            w4 = math.sqrt(X4 * X4 + v11)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[3, 3] and U4[2, 3]
            c5 = T33 * c23 + s23 * v9

            # theta6
            v14, v17 = T32 * s23 - c23 * v13, T31 * s23 - c23 * v16

            for i3 in range(2):  # noflip, flip
                e4 = 1.0 - 2.0 * i3
                # theta4
                if e4 < 0.0 and free4:
                    continue  # both signs give the same
                factor4 = e4 / divisor4
                c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
                s4 = math.sin(seed[3]) if free4 else -(v10 * factor4)
                q4 = _atan2(s4, c4)

                # theta5
                q5 = _atan2(-(w4 * e4), c5)

                # theta6
                c6 = c4 * v15 + s4 * v17
                q6 = _atan2(-(c4 * v12 + s4 * v14), c6)
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

        # theta1, type 2: U1[1, 4]
        t24, t14 = T24 + D3 * T21 + k1 * T23, T14 + D3 * T11 + k1 * T13
        N1 = t24 * t24 + t14 * t14
        D1_squared = N1 - k2
        w1 = math.sqrt(D1_squared)
        v1, inverse1 = w1 - w1, 1.0 / N1
        v2, v3 = inverse1 * (D3 * t14), w1 * (t24 * inverse1)
        c1_p, c1_m, v4 = v2 + v3, v2 - v3, inverse1 * (D3 * t24)
        v5 = w1 * (t14 * inverse1)
        s1_p, s1_m = v4 - v5, v4 + v5

        # theta3, type 8: U1[3, 4] and U1[2, 4]
        t34 = T34 + D3 * T31 + k1 * T33
        N3 = D1_squared + t34 * t34
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)
        v6 = w3 - w3

        # theta2, type 3: U1[3, 4] and U1[2, 4]
        v7, v8 = w3 * (m3 * t34), m3 * (w1 * N3)
        v9, v10, v11 = v7 + v8, v8 - v7, m3 * (t34 * N3)
        v12 = w3 * (m3 * w1)
        C2_pp, C2_pm = v11 - v12, v11 + v12
        v13, v14 = v9 * v9 + C2_pp * C2_pp, C2_pm * C2_pm
        v15, v16, factor2_pp = v10 * v10 + v14, v14 + -v10 * -v10, math.sqrt(v13) * (1.0 / v13)
        factor2_pm, factor2_mp = math.sqrt(v15) * (1.0 / v15), math.sqrt(v16) * (1.0 / v16)

        # theta4, type 2: U4[1, 3]
        v17 = m5 * N3
        v18, v19 = m3 - v17, v17 - m6
        v20 = w1 * (N3 * (v18 + v19))
        s23_pp, s23_pm, v21 = v7 + v20, v20 - v7, w1 * (N3 * (-v18 + -v19))
        s23_mp, s23_mm, v22 = v7 + v21, v21 - v7, T13 * s1_p - T23 * c1_p
        v23, X4_pp = T13 * s1_m - T23 * c1_m, C2_pm * v22 - T33 * s23_pp
        X4_pm, X4_mp = C2_pp * v22 - T33 * s23_pm, C2_pp * v23 - T33 * s23_mp
        X4_mm, v24 = C2_pm * v23 - T33 * s23_mm, T13 * c1_p + T23 * s1_p
        v25, v26 = T13 * c1_m + T23 * s1_m, v24 * v24
        v27, v28 = v25 * v25, v26 + factor2_pp * (X4_pp * (factor2_pp * X4_pp))
        v29 = v26 + factor2_pm * (X4_pm * (factor2_pm * X4_pm))
        v30 = v27 + factor2_mp * (X4_mp * (factor2_mp * X4_mp))
        v31, v32 = v27 + factor2_pp * (X4_mm * (factor2_pp * X4_mm)), math.copysign(half_turn, -v24)
        v33 = math.copysign(half_turn, -v25)

        # theta5, type 3: U4[3, 3] and U4[2, 3]
        v34, v35 = T33 * C2_pm, T33 * C2_pp

        # theta6, type 3: U4[1, 2] and U4[1, 1]
        v36, v37, v38 = c1_p * T12 + s1_p * T22, c1_m * T12 + s1_m * T22, s1_p * T12 - c1_p * T22
        v39, v40, v41 = s1_m * T12 - c1_m * T22, T11 * c1_p + T21 * s1_p, T11 * c1_m + T21 * s1_m
        v42, v43 = T11 * s1_p - T21 * c1_p, T11 * s1_m - T21 * c1_m
        v44 = v24 * (s23_pp * T32 - C2_pm * v38) - -X4_pp * v36
        v45 = v24 * (s23_pm * T32 - C2_pp * v38) - -X4_pm * v36
        v46 = v25 * (s23_mp * T32 - C2_pp * v39) - -X4_mp * v37
        v47 = v25 * (s23_mm * T32 - C2_pm * v39) - -X4_mm * v37

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v31 <= m7 or v30 <= m7 or v16 <= m4 or v29 <= m7 or v15 <= m4 or v28 <= m7 or
            abs(D1_squared) <= m1 or abs(D3_squared * (k5 * w1)) <= m2 or v13 <= m4 else kept[16 * w
            + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = v1, v6, v32
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v33, v44, v45
        kept[23 * w + k], kept[24 * w + k], turns[0 * w + k] = v46, v47, w3
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = -v9, -v10, v10
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = v9, -v24, -v24
        turns[7 * w + k], turns[8 * w + k], turns[9 * w + k] = -v25, -v25, -math.sqrt(v28)
        turns[10 * w + k], turns[11 * w + k] = -math.sqrt(v29), -math.sqrt(v30)
        turns[12 * w + k], turns[13 * w + k], turns[14 * w + k] = -math.sqrt(v31), v44, v45
        turns[15 * w + k], turns[16 * w + k], turns[17 * w + k] = v46, v47, s1_p
        turns[18 * w + k], turns[24 * w + k], turns[25 * w + k] = s1_m, N3 - k6, C2_pp
        turns[26 * w + k], turns[27 * w + k], turns[28 * w + k] = C2_pm, C2_pm, C2_pp
        turns[29 * w + k], turns[30 * w + k] = factor2_pp * -X4_pp, factor2_pm * -X4_pm
        turns[31 * w + k], turns[32 * w + k] = factor2_mp * -X4_mp, factor2_pp * -X4_mm
        turns[33 * w + k] = factor2_pp * (v34 + s23_pp * v22)
        turns[34 * w + k] = factor2_pm * (v35 + s23_pm * v22)
        turns[35 * w + k] = factor2_mp * (v35 + s23_mp * v23)
        turns[36 * w + k] = factor2_pp * (v34 + s23_mm * v23)
        turns[37 * w + k] = -X4_pp * v40 - v24 * (T31 * s23_pp - C2_pm * v42)
        turns[38 * w + k] = -X4_pm * v40 - v24 * (T31 * s23_pm - C2_pp * v42)
        turns[39 * w + k] = -X4_mp * v41 - v25 * (T31 * s23_mp - C2_pp * v43)
        turns[40 * w + k] = -X4_mm * v41 - v25 * (T31 * s23_mm - C2_pm * v43)
        turns[41 * w + k], turns[42 * w + k] = c1_p, c1_m
    if w == 1 and kept[16] != 0.0:
        return
    end = 24 if w == 1 else 19 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(19 * w, end):
        turns[k] = turns[k + 24 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 24 * w])
    for k in range(w):
        v1, v6, v32 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v33, v44, v45 = kept[20 * w + k], kept[21 * w + k], kept[22 * w + k]
        v46, v47, angle1 = kept[23 * w + k], kept[24 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle8, angle9, angle10 = turns[7 * w + k], turns[8 * w + k], turns[9 * w + k]
        angle11, angle12, angle13 = turns[10 * w + k], turns[11 * w + k], turns[12 * w + k]
        angle14, angle15, angle16 = turns[13 * w + k], turns[14 * w + k], turns[15 * w + k]
        angle17, angle18, angle19 = turns[16 * w + k], turns[17 * w + k], turns[18 * w + k]

        # theta4, type 2: U4[1, 3]
        q4_ppm, q4_pmm, q4_mpm = angle6 - v32, angle7 - v32, angle8 - v33
        q4_mmm = angle9 - v33

        # theta6, type 3: U4[1, 2] and U4[1, 1]
        q6_ppm = angle14 - math.copysign(half_turn, v44)
        q6_pmm = angle15 - math.copysign(half_turn, v45)
        q6_mpm = angle16 - math.copysign(half_turn, v46)
        q6_mmm = angle17 - math.copysign(half_turn, v47)

        # joint values
        q1_ppp, q1_mpp, q3_ppp = v6 + angle18, v6 + angle19, v1 + angle1
        q3_pmp = v1 - angle1

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, angle2, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle6, angle10, angle14
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, -angle10, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = angle3, q3_pmp, angle7
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = angle11, angle15, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = -angle11, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = angle4, angle8, angle12
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = angle16, q4_mpm, -angle12
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = q6_mpm, angle5, angle9
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = angle13, angle17, q4_mmm
        rows[30 * w + k], rows[31 * w + k] = -angle13, q6_mmm
        rows[32 * w + k] = rows[33 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[34 * w + k] = rows[35 * w + k] = UNREACHABLE if q1_ppp != q1_ppp else OK
        rows[36 * w + k] = rows[37 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[38 * w + k] = rows[39 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 25, 48, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 13], [0, 9, 10, 14, 15, 16],
    [17, 18, 2, 19, 20, 21], [17, 18, 2, 22, 23, 24], [17, 25, 10, 26, 27, 28],
    [17, 25, 10, 29, 30, 31],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
