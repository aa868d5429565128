# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: d48b6b9d27ba3606
"""bartell_rprpr: Bartell RPRPR arm.

Inverse kinematics, generated from robots/bartell_rprpr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/bartell_rprpr.yaml. The formulas and where they come from:
bartell_rprpr.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 5), _runtime("arrays").zeros

NAME = "bartell_rprpr"
METHOD = "closed form"
DOF = 5
JOINT_TYPES = "RPRPR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = ("shoulder+", "shoulder-")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit = 9.999999999999999e-05.
d1 = 2.0  # joint offset 1 [m]
second_weight = 0.5  # lengths count in arm sizes [m^-1]
free_limit = 1e-12  # a length that fixes no angle
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 2e-05  # a pose may be rounded by this [m]
m1 = 9.999999999999999e-09  # doubt_limit^2
m3 = 4.0000000000000007e-10  # pose_slack1^2 [m^2]
m4 = 1.0000000000000002e-10  # pose_slack^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="rotation",
    miss_weights=(0.5, 0.5, 0.5, 1.0, 1.0, 1.0), size=2.0,
    slacks=(1e-09, 2e-09, 1e-09, 2e-09, 1e-09), weights=(1.0, 0.25, 1.0, 0.25, 1.0),
    paces=(1.0, 2.0, 1.0, 2.0, 1.0), steps=("follows seed",),
))

# The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 2.0, 0.0, 0.0),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="modified",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (5,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, z4_x = c1 * c3, s1 * c3, c1 * s3
    z4_y = s1 * s3
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    T[0, 0], T[0, 1], T[0, 2] = x3_x * c5 + s1 * s5, s1 * c5 - x3_x * s5, z4_x
    T[0, 3] = s1 * q[1] + z4_x * q[3]
    T[1, 0], T[1, 1], T[1, 2] = x3_y * c5 - c1 * s5, -(c1 * c5 + x3_y * s5), z4_y
    T[1, 3] = z4_y * q[3] - c1 * q[1]
    T[2, 0], T[2, 1], T[2, 2] = s3 * c5, -(s3 * s5), -c3
    T[2, 3] = d1 - c3 * q[3]
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 5): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 5)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p2_x, v1 = s1 * q[1], c1 * q[1]
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    z4_x, z4_y = c1 * s3, s1 * s3
    p4_x, p4_y, v2 = p2_x + z4_x * q[3], z4_y * q[3] - v1, d1 - c3 * q[3] - d1
    J[0, 0], J[0, 1], J[0, 2] = -p4_y, s1, -(c1 * v2)
    J[0, 3] = z4_x
    J[1, 0], J[1, 1], J[1, 2] = p4_x, -c1, -(s1 * v2)
    J[1, 3] = z4_y
    J[2, 2], J[2, 3] = s1 * (v1 + p4_y) + c1 * (p4_x - p2_x), -c3
    J[3, 2], J[3, 4] = s1, z4_x
    J[4, 2], J[4, 4] = -c1, z4_y
    J[5, 0], J[5, 4] = 1.0, -c3
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, _, T33, T34 = pose

    # theta1, type 2: U1[2, 3], so theta1 = atan2(T23, T13) or half a turn from it. Where both are
    # small, U1[3] x U1[4], element 2 says more: its vector, along the same line, is added
    v1 = T34 - d1
    X2_1 = T23 * v1 - T24 * T33
    Y2_1 = T13 * v1 - T33 * T14
    sigma1 = math.copysign(second_weight, T13 * X2_1 - T23 * Y2_1)
    Xhat1 = T13 + X2_1 * sigma1
    Yhat1 = Y2_1 * sigma1 - T23
    w1 = math.sqrt(Xhat1 * Xhat1 + Yhat1 * Yhat1)
    free1 = w1 <= free_limit
    divisor1 = 1.0 if free1 else w1

    # theta3, type 3: U1[3, 3] and U1[1, 3]
    v2 = T33 * T33

    for i1 in range(2):  # shoulder+, shoulder-
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(Xhat1 * factor1)
        s1 = math.sin(seed[0]) if free1 else Yhat1 * factor1
        q1 = _atan2(s1, c1)

        # r2, type 1: U1[2, 4]
        r2 = T14 * s1 - T24 * c1

        # theta3
        Z2_3 = T13 * c1 + T23 * s1
        w3 = math.sqrt(Z2_3 * Z2_3 + v2)
        short3 = w3 <= free_limit
        factor3 = 1.0 / (1.0 if short3 else w3)
        v3 = T33 * factor3
        s3 = Z2_3 * factor3
        q3 = _atan2(s3, -v3)

        # r4, type 1: U3[2, 4]
        r4 = s3 * (T14 * c1 + T24 * s1) - v3 * -v1

        # theta5, type 3: U1[2, 2] and U1[2, 1]
        Z1_5 = T22 * c1 - T12 * s1
        Z2_5 = T21 * c1 - T11 * s1
        w5 = math.sqrt(Z2_5 * Z2_5 + Z1_5 * Z1_5)
        short5 = w5 <= free_limit
        v4 = 1.0 / (1.0 if short5 else w5)
        v5, v6 = Z1_5 * v4, Z2_5 * v4
        q5 = _atan2(-v6, -v5)

        # is the pose one that the arm can take?
        v7, v8 = c1 * s3, s1 * s3
        if (
            not (abs(T34 - (d1 + v3 * r4)) <= pose_slack1 and abs(T33 - v3) <= pose_slack and
            abs(T31 + s3 * v5) <= pose_slack and abs(T24 - (r4 * v8 - c1 * r2)) <= pose_slack1 and
            abs(T23 - v8) <= pose_slack and abs(T21 - (v5 * (s1 * v3) + c1 * v6)) <= pose_slack and
            abs(T14 - (r4 * v7 + s1 * r2)) <= pose_slack1 and abs(T11 - (v5 * (c1 * v3) - s1 * v6))
            <= pose_slack and abs(T13 - v7) <= pose_slack)
        ):
            continue  # the arm can't take this pose
        row = i1
        q[row, 0], q[row, 1], q[row, 2] = q1, r2, q3
        q[row, 3], q[row, 4] = r4, q5
        status[row] = FREE_JOINT if free1 else OK


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
        T33, T34 = kept[10 * w + k], kept[11 * w + k]

        # theta1, type 2: U1[2, 3], so theta1 = atan2(T23, T13) or half a turn from it. Where both
        # are small, U1[3] x U1[4], element 2 says more: its vector, along the same line, is added
        v1 = T34 - d1
        X2_1, Y2_1 = v1 * T23 - T24 * T33, v1 * T13 - T33 * T14
        sigma1 = math.copysign(second_weight, X2_1 * T13 - T23 * Y2_1)
        Xhat1, Yhat1 = T13 + X2_1 * sigma1, Y2_1 * sigma1 - T23
        v2 = Xhat1 * Xhat1 + Yhat1 * Yhat1
        w1, v3 = math.sqrt(v2), 1.0 / v2
        factor1 = w1 * v3
        v4, s1 = Xhat1 * factor1, Yhat1 * factor1

        # r2, type 1: U1[2, 4]
        q2_p = w1 * (v3 * (T24 * Xhat1 + T14 * Yhat1))

        # theta3, type 3: U1[3, 3] and U1[1, 3]
        Z2_3 = w1 * (v3 * (T23 * Yhat1 - T13 * Xhat1))
        v5 = T33 * T33 + Z2_3 * Z2_3
        w3, v6 = math.sqrt(v5), 1.0 / v5
        factor3 = w3 * v6
        v7, s3 = T33 * factor3, Z2_3 * factor3

        # r4, type 1: U3[2, 4]
        q4_p = w3 * (v6 * ((T23 * s1 - T13 * v4) * (T24 * s1 - T14 * v4) - T33 * -v1))

        # theta5, type 3: U1[2, 2] and U1[2, 1]
        v8, v9 = w1 * (v3 * (Xhat1 * T22 + Yhat1 * T12)), w1 * (v3 * (Xhat1 * T21 + Yhat1 * T11))
        v10 = v9 * v9 + v8 * v8
        v11 = math.sqrt(v10) * (1.0 / v10)
        v12, v13 = v8 * v11, v9 * v11

        # is the pose one that the arm can take?
        v14, v15, v16 = v4 * s3, s1 * s3, T34 - (d1 + v7 * q4_p)
        v17, v18, v19 = T33 - v7, T31 - s3 * v12, T24 - (q4_p * v15 + v4 * q2_p)
        v20, v21 = T23 - v15, T21 - (v4 * v13 - v12 * (s1 * v7))
        v22, v23 = T14 - (s1 * q2_p - q4_p * v14), T11 - (v12 * (v4 * v7) + s1 * v13)
        v24 = T13 + v14

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v5 <= m1 or v2 <= m1 or v10 <= m1 or m4 < v17 * v17 + v18 * v18 + v20 * v20 + v21
            * v21 + v23 * v23 + v24 * v24 or m3 < v16 * v16 + v19 * v19 + v22 * v22 else kept[16 * w
            + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = Yhat1, q2_p, q4_p
        kept[20 * w + k], turns[0 * w + k], turns[1 * w + k] = v9, Yhat1, Z2_3
        turns[2 * w + k], turns[8 * w + k], turns[9 * w + k] = v9, -Xhat1, -T33
        turns[10 * w + k] = v8
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 3 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(3 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        Yhat1, q2_p, q4_p = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        v9, angle1, angle2 = kept[20 * w + k], turns[0 * w + k], turns[1 * w + k]
        angle3 = turns[2 * w + k]

        # theta1, type 2: U1[2, 3], so theta1 = atan2(T23, T13) or half a turn from it. Where both
        # are small, U1[3] x U1[4], element 2 says more: its vector, along the same line, is added
        q1_m = angle1 - math.copysign(half_turn, Yhat1)

        # theta5, type 3: U1[2, 2] and U1[2, 1]
        q5_m = angle3 - math.copysign(half_turn, v9)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle1, q2_p, angle2
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_p, angle3, q1_m
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = -q2_p, -angle2, q5_m
        rows[9 * w + k] = UNREACHABLE if angle1 != angle1 else OK
        rows[10 * w + k] = UNREACHABLE if q1_m != q1_m else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 21, 16, [
    [0, 1, 2, 3, 4], [5, 6, 7, 3, 8],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
