# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 061b107b5feed2ce
"""abb_irb4600: ABB IRB 4600-40/2.55.

Inverse kinematics, generated from robots/abb_irb4600.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/abb_irb4600.yaml. The formulas and where they come from:
abb_irb4600.md.

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

NAME = "abb_irb4600"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-3.141592653589793, 3.141592653589793), (-1.5707963267948966, 2.6179938779914944),
    (-3.141592653589793, 1.3089969389957472), (-6.981317007977318, 6.981317007977318),
    (-2.181661564992912, 2.0943951023931953), (-6.981317007977318, 6.981317007977318),
)
BRANCHES = (
    "back-down-noflip", "back-down-flip", "back-up-noflip", "back-up-flip", "front-up-noflip",
    "front-up-flip", "front-down-noflip", "front-down-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 0.00032000238089839356 [m], doubt_limit = 9.999999999999999e-05.
a1 = 0.175  # x of axis 2 [m]
d1 = 0.495  # z of axis 2 [m]
a2 = 1.095  # z of axis 3 [m]
a3 = 0.175  # z of axis 4 [m]
d4 = 1.27  # x of axis 5 [m]
d6 = 0.135  # x of the home pose [m]
free_limit1 = 3.2000238089839356e-12  # a length that fixes no angle [m]
longest3 = 5.650130854134036  # square of the longest reach [m^2]
shortest3 = 0.03496914586596454  # square of the shortest reach [m^2]
longest3_reach = 5.650130854135559  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.03496914586584486  # the shortest, with what rounding adds [m^2]
longest3_apart = 5.650130854133884  # the longest, where branches merge [m^2]
shortest3_apart = 0.034969145865976506  # the shortest, where branches merge [m^2]
free_limit = 1e-12  # a length that fixes no angle
k1 = 2.7813  # 2 * d4 * a2 [m^2]
k2 = 0.38325  # 2 * a3 * a2 [m^2]
k3 = 2.84255  # a2^2 + (a3^2 + d4^2) [m^2]
k4 = 0.1268631397825131  # 1 / (k1^2 + k2^2) [m^-4]
turn1 = 1.4338633792358526  # atan2(k1, k2) [rad]
low2 = -1.5707963277948966  # lowest value of joint 2, with what rounding adds [rad]
high2 = 2.6179938789914945  # highest value of joint 2, with what rounding adds [rad]
low3 = -3.141592654589793  # lowest value of joint 3, with what rounding adds [rad]
high3 = 1.3089969399957473  # highest value of joint 3, with what rounding adds [rad]
low5 = -2.181661565992912  # lowest value of joint 5, with what rounding adds [rad]
high5 = 2.0943951033931953  # highest value of joint 5, with what rounding adds [rad]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 1.0240152378064056e-07  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 8.528223923621197e-10
m4 = 0.4566210045662101  # k4 * (d4 * k1 + a3 * k2) [m^-1]
m5 = 0.20296803652968054  # d4 * k1 * k3 * k4 + a3 * k2 * k3 * k4 - a2 [m]
m6 = 0.3863646734914285  # a2 * k1 * k4 [m^-1]
m7 = 0.053239226662204715  # a2 * k2 * k4 [m^-1]
# k2 * k4 * (d4 * k1 * k3^2 * k4 + a3 * k2 * k3^2 * k4 - a2 * k3 - d4 * longest3 * shortest3 * k1 *
# k4 - a3 * longest3 * shortest3 * k2 * k4) [m]
m8 = 0.023664836251350022
# k1 * k4 * (d4 * k1 * k3^2 * k4 + a3 * k2 * k3^2 * k4 - a2 * k3 - d4 * longest3 * shortest3 * k1 *
# k4 - a3 * longest3 * shortest3 * k2 * k4) [m]
m9 = 0.17173909736694015
m10 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(0.3125, 0.3125, 0.3125, 1.0, 1.0, 1.0), size=3.2000238089839357,
    steps=("keeps limits", "clamps", "clamps far", "range exceeds a turn", "follows seed"),
    choosable=(3, 0),
))

# The axes at q = 0: a unit vector along each, and a point of it [m].
AXES = (
    (0.0, 0.0, 1.0, 0.0, 0.0, 0.0),
    (0.0, 1.0, 0.0, 0.175, 0.0, 0.495),
    (0.0, 1.0, 0.0, 0.175, 0.0, 1.5899999999999999),
    (1.0, 0.0, 0.0, 0.175, 0.0, 1.765),
    (0.0, 1.0, 0.0, 1.445, 0.0, 1.765),
    (1.0, 0.0, 0.0, 0.175, 0.0, 1.765),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=AXES, convention="axes",
    tool=(0.0, 0.0, 1.0, 1.58, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.765),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, y2_x = c1 * s2, s1 * s2, c1 * c2
    y2_y = s1 * c2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, c2 * c3 - s2 * s3
    y3_x, y3_y, v1 = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, s2 * c3 + c2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + s1 * s4, x3_y * c4 - c1 * s4, x3_z * c4
    y4_x, z5_y, z5_z = s1 * c4 - x3_x * s4, c1 * c4 + x3_y * s4, x3_z * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 + y3_x * s5, x4_y * c5 + y3_y * s5, x4_z * c5 - v1 * s5
    y5_x, y5_y, v2 = y3_x * c5 - x4_x * s5, y3_y * c5 - x4_y * s5, v1 * c5 + x4_z * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = -(x5_x * c6 + y4_x * s6), x5_x * s6 - y4_x * c6, y5_x
    T[0, 3] = c1 * a1 + x2_x * a2 + x3_x * a3 + y3_x * d4 + y5_x * d6
    T[1, 0], T[1, 1], T[1, 2] = z5_y * s6 - x5_y * c6, z5_y * c6 + x5_y * s6, y5_y
    T[1, 3] = s1 * a1 + x2_y * a2 + x3_y * a3 + y3_y * d4 + y5_y * d6
    T[2, 0], T[2, 1], T[2, 2] = z5_z * s6 - x5_z * c6, z5_z * c6 + x5_z * s6, -v2
    T[2, 3] = d1 + c2 * a2 + x3_z * a3 - v1 * d4 - v2 * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p2_x, p2_y = c1 * a1, s1 * a1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, y2_x = c1 * s2, s1 * s2, c1 * c2
    y2_y, p3_x, p3_y = s1 * c2, p2_x + x2_x * a2, p2_y + x2_y * a2
    p3_z = d1 + c2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, x3_z = x2_x * c3 + y2_x * s3, x2_y * c3 + y2_y * s3, c2 * c3 - s2 * s3
    y3_x, y3_y, v1 = y2_x * c3 - x2_x * s3, y2_y * c3 - x2_y * s3, s2 * c3 + c2 * s3
    p4_x, p4_y, p4_z = p3_x + x3_x * a3, p3_y + x3_y * a3, p3_z + x3_z * a3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    z5_y, z5_z, p5_x = c1 * c4 + x3_y * s4, x3_z * s4, p4_x + y3_x * d4
    p5_y, p5_z, z5_x = p4_y + y3_y * d4, p4_z - v1 * d4, x3_x * s4 - s1 * c4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    y5_x, y5_y = y3_x * c5 - (x3_x * c4 + s1 * s4) * s5, y3_y * c5 - (x3_y * c4 - c1 * s4) * s5
    v2, J21, v3 = v1 * c5 + x3_z * c4 * s5, p5_x + y5_x * d6, p5_y + y5_y * d6
    v4 = p5_z - v2 * d6
    v5, v6, v7 = v4 - d1, v4 - p3_z, J21 - p4_x
    v8, v9, v10 = v3 - p4_y, v4 - p4_z, J21 - p5_x
    v11, v12 = v3 - p5_y, v4 - p5_z
    J[0, 0], J[0, 1], J[0, 2] = -v3, c1 * v5, c1 * v6
    J[0, 3], J[0, 4], J[0, 5] = y3_y * v9 + v1 * v8, z5_y * v12 - z5_z * v11, y5_y * v12 + v2 * v11
    J[1, 0], J[1, 1], J[1, 2] = J21, s1 * v5, s1 * v6
    J[1, 3], J[1, 4] = -(v1 * v7 + y3_x * v9), z5_z * v10 - z5_x * v12
    J[1, 5] = -(v2 * v10 + y5_x * v12)
    J[2, 1] = -(s1 * (v3 - p2_y) + c1 * (J21 - p2_x))
    J[2, 2], J[2, 3] = -(s1 * (v3 - p3_y) + c1 * (J21 - p3_x)), y3_x * v8 - y3_y * v7
    J[2, 4], J[2, 5] = z5_x * v11 - z5_y * v10, y5_x * v11 - y5_y * v10
    J[3, 1], J[3, 2], J[3, 3] = -s1, -s1, y3_x
    J[3, 4], J[3, 5] = z5_x, y5_x
    J[4, 1], J[4, 2], J[4, 3] = c1, c1, y3_y
    J[4, 4], J[4, 5] = z5_y, y5_y
    J[5, 0], J[5, 3], J[5, 4] = 1.0, -v1, z5_z
    J[5, 5] = -v2
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[2, 4]
    t14 = T14 - d6 * T13
    Y1 = d6 * T23 - T24
    w1 = math.sqrt(t14 * t14 + Y1 * Y1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 6: U1[3, 4] and U1[1, 4]
    t34 = T34 - d6 * T33
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

        # theta4, type 2: U4[2, 3]
        v6 = T13 * c1 + T23 * s1
        Y4 = T23 * c1 - T13 * s1
        v7 = Y4 * Y4

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        v8, v9, v11 = T12 * s1 - T22 * c1, T12 * c1 + T22 * s1, T11 * s1 - T21 * c1
        v12 = T11 * c1 + T21 * s1

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            D3 = w3 * e3
            s3, c3 = (k2 * D3 - v3) * k4, k4 * (v4 + k1 * D3)
            q3 = _atan2(s3, c3)

            # theta2, type 3: U1[1, 4] and U1[3, 4]
            X1_2 = a2 + (a3 * c3 - d4 * s3)
            Y1_2 = d4 * c3 + a3 * s3
            v5 = v1 * X1_2 + Z1_3 * Y1_2
            C2 = Z1_3 * X1_2 - v1 * Y1_2
            w2 = math.sqrt(v5 * v5 + C2 * C2)
            factor2 = 1.0 / w2
            c2, s2 = C2 * factor2, -(v5 * factor2)
            q2 = _atan2(s2, c2)

            # theta4
            c23, s23 = c3 * c2 - s3 * s2, c3 * s2 + s3 * c2
            X4 = T33 * c23 + s23 * v6
            w4 = math.sqrt(X4 * X4 + v7)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[3, 3] and U4[1, 3]
            c5 = c23 * v6 - T33 * s23

            # theta6
            v10, v13 = T32 * c23 + s23 * v9, T31 * c23 + s23 * v12

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

                # theta5
                q5 = _atan2(s5, c5)

                # theta6
                c6, s6 = s4 * v10 - c4 * v8, s4 * v13 - c4 * v11
                q6 = _atan2(s6, c6)
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

        # theta1, type 2: U1[2, 4]
        t14, Y1 = T14 - d6 * T13, d6 * T23 - T24
        v1 = t14 * t14 + Y1 * Y1
        w1, v2 = math.sqrt(v1), 1.0 / v1

        # theta3, type 6: U1[3, 4] and U1[1, 4]
        Z1_3, v3, v4 = T34 - d6 * T33 - d1, a1 + w1, a1 - w1
        v5 = Z1_3 * Z1_3
        N3_p, N3_m = v5 + v3 * v3, v5 + v4 * v4
        D3_squared_p = (longest3 - N3_p) * (N3_p - shortest3)
        D3_squared_m, w3_p = (longest3 - N3_m) * (N3_m - shortest3), math.sqrt(D3_squared_p)
        w3_m = math.sqrt(D3_squared_m)

        # theta2, type 3: U1[1, 4] and U1[3, 4]
        X1_2_p, X1_2_m = m4 * N3_p - m5, m4 * N3_m - m5
        v8, v9, v10 = v3 * X1_2_p, v4 * X1_2_m, m4 * Z1_3
        v11, v12, v13 = m4 * -Z1_3, Z1_3 * X1_2_p, Z1_3 * X1_2_m
        factor2_p, factor2_m, v14 = 1.0 / N3_p, 1.0 / N3_m, w3_p * (m4 * v3)

        # theta4, type 2: U4[2, 3]
        v15, v16, v17 = m6 * Z1_3, m7 + m8 * factor2_p, m7 + m8 * factor2_m
        v18, v19 = m6 + m9 * factor2_p, m6 + m9 * factor2_m
        v20, v21 = Z1_3 * v16 - v3 * v18, Z1_3 * v17 - v4 * v19
        v22 = w3_p * (factor2_p * (v15 + m7 * v3))
        c23_pp, c23_pm, v23 = v20 + v22, v20 - v22, w3_m * (factor2_m * (v15 + m7 * v4))
        c23_mp, c23_mm, v24 = v21 + v23, v21 - v23, m7 * Z1_3
        v25, v26, v27 = v24 - m6 * v3, v24 - m6 * v4, Z1_3 * v18 + v3 * v16
        v28, s23_pp = Z1_3 * v19 + v4 * v17, w3_p * (factor2_p * v25) - v27
        s23_pm, s23_mp = w3_p * (factor2_p * -v25) - v27, w3_m * (factor2_m * v26) - v28
        s23_mm, v29 = w3_m * (factor2_m * -v26) - v28, w1 * (v2 * (T23 * Y1 - T13 * t14))
        X4_pp, X4_pm = T33 * c23_pp + s23_pp * v29, T33 * c23_pm + s23_pm * v29
        X4_mp, X4_mm = T33 * c23_mp - s23_mp * v29, T33 * c23_mm - s23_mm * v29
        v30 = w1 * (v2 * (T13 * Y1 + t14 * T23))
        v31 = v30 * v30
        v32, v33, v34 = v31 + X4_pp * X4_pp, v31 + X4_pm * X4_pm, v31 + X4_mp * X4_mp
        v35, v36 = v31 + X4_mm * X4_mm, math.copysign(half_turn, -v30)
        v37 = math.copysign(half_turn, v30)

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        v38, v39 = w1 * (v2 * (t14 * T22 + Y1 * T12)), w1 * (v2 * (Y1 * T22 - t14 * T12))
        v40, v41 = w1 * (v2 * (t14 * T21 + Y1 * T11)), w1 * (v2 * (Y1 * T21 - t14 * T11))
        v42 = X4_pp * v40 - v30 * (c23_pp * T31 + s23_pp * v41)
        v43 = X4_pm * v40 - v30 * (c23_pm * T31 + s23_pm * v41)
        v44 = v30 * (c23_mp * T31 - s23_mp * v41) - X4_mp * v40
        v45 = v30 * (c23_mm * T31 - s23_mm * v41) - X4_mm * v40

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = (
            1.0 if v35 <= m10 or v34 <= m10 or v33 <= m10 or v32 <= m10 or abs(D3_squared_m) <= m3
            or v1 <= m1 or abs(D3_squared_p) <= m3 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = Y1, w3_p, w3_m
        kept[20 * w + k], kept[21 * w + k], kept[22 * w + k] = v36, v37, v42
        kept[23 * w + k], kept[24 * w + k], kept[25 * w + k] = v43, v44, v45
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = Y1, w3_p, w3_m
        turns[3 * w + k], turns[4 * w + k] = -(v8 + w3_p * v10), -(v8 + w3_p * v11)
        turns[5 * w + k], turns[6 * w + k] = -(v9 + w3_m * v10), -(v9 + w3_m * v11)
        turns[7 * w + k], turns[8 * w + k], turns[9 * w + k] = -v30, -v30, v30
        turns[10 * w + k], turns[11 * w + k] = v30, math.sqrt(v32)
        turns[12 * w + k], turns[13 * w + k] = math.sqrt(v33), math.sqrt(v34)
        turns[14 * w + k], turns[15 * w + k], turns[16 * w + k] = math.sqrt(v35), v42, v43
        turns[17 * w + k], turns[18 * w + k], turns[24 * w + k] = v44, v45, -t14
        turns[25 * w + k], turns[26 * w + k], turns[27 * w + k] = N3_p - k3, N3_m - k3, v12 - v14
        turns[28 * w + k], turns[29 * w + k] = v12 + v14, v13 - w3_m * (m4 * v4)
        turns[30 * w + k], turns[31 * w + k] = v13 - w3_m * (m4 * -v4), -X4_pp
        turns[32 * w + k], turns[33 * w + k], turns[34 * w + k] = -X4_pm, -X4_mp, -X4_mm
        turns[35 * w + k] = c23_pp * v29 - T33 * s23_pp
        turns[36 * w + k] = c23_pm * v29 - T33 * s23_pm
        turns[37 * w + k] = -(c23_mp * v29 + T33 * s23_mp)
        turns[38 * w + k] = -(c23_mm * v29 + T33 * s23_mm)
        turns[39 * w + k] = X4_pp * v38 - v30 * (c23_pp * T32 + s23_pp * v39)
        turns[40 * w + k] = X4_pm * v38 - v30 * (c23_pm * T32 + s23_pm * v39)
        turns[41 * w + k] = v30 * (c23_mp * T32 - s23_mp * v39) - X4_mp * v38
        turns[42 * w + k] = v30 * (c23_mm * T32 - s23_mm * v39) - X4_mm * v38
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

        # theta3, type 6: U1[3, 4] and U1[1, 4]
        q3__pp, v6, q3__mp = angle2 - turn1, turn1 + angle2, angle3 - turn1
        v7 = turn1 + angle3

        # theta4, type 2: U4[2, 3]
        q4_ppm, q4_pmm, q4_mpm = angle8 - v36, angle9 - v36, angle10 - v37
        q4_mmm = angle11 - v37

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        q6_ppm = angle16 - math.copysign(half_turn, v42)
        q6_pmm = angle17 - math.copysign(half_turn, v43)
        q6_mpm = angle18 - math.copysign(half_turn, v44)
        q6_mmm = angle19 - math.copysign(half_turn, v45)

        # joint values
        v46 = q3__pp + (turn if q3__pp <= -half_turn else 0.0)
        v47 = (turn if -v6 <= -half_turn else 0.0) - v6
        v48 = q3__mp + (turn if q3__mp <= -half_turn else 0.0)
        v49 = (turn if -v7 <= -half_turn else 0.0) - v7
        v50 = v46 - (turn if high3 < v46 else 0.0)
        v51 = v47 - (turn if high3 < v47 else 0.0)
        v52 = v48 - (turn if high3 < v48 else 0.0)
        v53 = v49 - (turn if high3 < v49 else 0.0)
        v54, v55 = max(low3 - v50, v50 - high3), max(low3 - v51, v51 - high3)
        v56, v57, v58 = max(low3 - v52, v52 - high3), max(low3 - v53, v53 - high3), v46 - high3
        v59, v60, v61 = v47 - high3, v48 - high3, v49 - high3
        v62 = v58 if v58 < v54 else v54
        v63 = v59 if v59 < v55 else v55
        v64 = v60 if v60 < v56 else v56
        v65 = v61 if v61 < v57 else v57
        q3_ppp = v46 if 0.0 < v62 else v50
        q3_pmp = v47 if 0.0 < v63 else v51
        q3_mpp = v48 if 0.0 < v64 else v52
        q3_mmp = v49 if 0.0 < v65 else v53
        q1_ppp = angle1 + (w3_p - w3_p)
        q1_mpp = angle1 - math.copysign(half_turn, Y1) + (w3_m - w3_m)
        v66 = max(v62, max(low2 - angle4, angle4 - high2))
        v67 = max(v63, max(low2 - angle5, angle5 - high2))
        v68 = max(v64, max(low2 - angle6, angle6 - high2))
        v69 = max(v65, max(low2 - angle7, angle7 - high2))
        excess_ppp = max(v66, max(low5 - angle12, angle12 - high5))
        excess_ppm = max(v66, max(low5 + angle12, -(high5 + angle12)))
        excess_pmp = max(v67, max(low5 - angle13, angle13 - high5))
        excess_pmm = max(v67, max(low5 + angle13, -(high5 + angle13)))
        excess_mpp = max(v68, max(low5 - angle14, angle14 - high5))
        excess_mpm = max(v68, max(low5 + angle14, -(high5 + angle14)))
        excess_mmp = max(v69, max(low5 - angle15, angle15 - high5))
        excess_mmm = max(v69, max(low5 + angle15, -(high5 + angle15)))
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

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_ppp, angle4, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle8, angle12, angle16
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, -angle12, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = angle5, q3_pmp, angle9
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = angle13, angle17, q4_pmm
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = -angle13, q6_pmm, q1_mpp
        rows[18 * w + k], rows[19 * w + k], rows[20 * w + k] = angle6, q3_mpp, angle10
        rows[21 * w + k], rows[22 * w + k], rows[23 * w + k] = angle14, angle18, q4_mpm
        rows[24 * w + k], rows[25 * w + k], rows[26 * w + k] = -angle14, q6_mpm, angle7
        rows[27 * w + k], rows[28 * w + k], rows[29 * w + k] = q3_mmp, angle11, angle15
        rows[30 * w + k], rows[31 * w + k], rows[32 * w + k] = angle19, q4_mmm, -angle15
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
