# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: a9f7f908835d5b23
"""scorbot_pointing: Scorbot (tool axis only).

Inverse kinematics, generated from robots/scorbot_pointing.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/scorbot_pointing.yaml. The formulas and where they come from:
scorbot_pointing.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
position T[0:3, 3] and the tool's z axis T[0:3, 2] counts; other entries are ignored.
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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 5), _runtime("arrays").zeros

NAME = "scorbot_pointing"
METHOD = "closed form"
DOF = 5
JOINT_TYPES = "RRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = ("back-down", "back-up", "front-up", "front-down")
MAX_SOLUTIONS = 4
FREE_JOINTS = (5,)  # from 1: the caller gives their values

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 9.52e-05 [m], doubt_limit = 9.999999999999999e-05,
# doubt_limit_squared2 = 9.063039999999998e-09 [m^2], exact_slack = 1e-12,
# exact_slack1 = 9.519999999999998e-13 [m], pose_slack1 = 9.519999999999999e-06 [m].
d1 = 0.349  # joint offset 1 [m]
a1 = 0.016  # link length 1 [m]
a2 = 0.221  # link length 2 [m]
a3 = 0.221  # link length 3 [m]
d5 = 0.145  # joint offset 5 [m]
second_weight = 0.952  # lengths count in arm sizes [m]
free_limit1 = 9.52e-13  # a length that fixes no angle [m]
free_limit = 1e-12  # a length that fixes no angle
longest3 = 0.195364  # square of the longest reach [m^2]
shortest3 = 0.0  # square of the shortest reach [m^2]
longest3_reach = 0.1953724157706304  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.1953639999999916  # the longest, where branches merge [m^2]
shortest3_apart = 9.06304e-29  # the shortest, where branches merge [m^2]
free_limit_squared2 = 9.063039999999997e-25  # square of a length that fixes no angle [m^2]
doubtful_slack = 0.01  # a row may miss the pose by this before it is refined
doubtful_slack1 = 0.009519999999999999  # a row may miss the pose by this before it is refined [m]
offset4 = 1.5707963267948966  # offset of joint 4 [rad]
k1 = 0.097682  # 2 * a3 * a2 [m^2]
k2 = 10.237300628570258  # 1 / k1 [m^-2]
m1 = 9.06304e-09  # doubt_limit1^2 [m^2]
m3 = 9.999999999999999e-09  # doubt_limit^2
m4 = 1.6442094386282138e-06  # -1 * (longest3 - longest3_reach) * (longest3_reach - shortest3) [m^4]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m5 = 1.6429994031951627e-12
m6 = 4.524886877828054  # 2 * a3 * k2 [m^-1]
m7 = 2.262443438914027  # a3 * k2 [m^-1]
m8 = 8.213869404159996e-17  # doubt_limit_squared2^2 [m^4]
m9 = 1e-24  # exact_slack^2
m10 = 9.063039999999996e-25  # exact_slack1^2 [m^2]
m11 = 2.7189119999999995e-10  # 3 * pose_slack1^2 [m^2]
m12 = 0.0002718911999999999  # 3 * doubtful_slack1^2 [m^2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=4, size=0.952, coordinates=(0, 1, 2), directions="pointing",
    joints=(
        _joints.Joint(place=0),
        _joints.Joint(place=1),
        _joints.Joint(place=2),
        _joints.Joint(place=3, zero=1.5707963267948966),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.016, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.349)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.221, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.221, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0),
            offset=1.5707963267948966,
        ),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.145)),
    ),
    free=(4,), checked=True,
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="pointing",
    miss_weights=(1.05, 1.05, 1.05, 1.0, 1.0, 1.0), size=0.952, paces=(1.0, 1.0, 1.0, 1.0, 0.0),
    entries=(2, 3, 6, 7, 10, 11),
    steps=("retries", "completes", "equations end all", "follows seed"), given=(4,),
    choosable=(1, 0),
), _joints.arm_numbers(_LINKS))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.349, 0.016, -1.5707963267948966),
    (0.0, 0.0, 0.221, 0.0),
    (0.0, 0.0, 0.221, 0.0),
    (1.5707963267948966, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.145, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (5,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v3 = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    v4, v5, y3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    v6 = q[3] + offset4
    c4, s4 = math.cos(v6), math.sin(v6)
    x4_x, x4_y, x4_z = x3_x * c4 - v4 * s4, x3_y * c4 - v5 * s4, y3_z * s4 - v3 * c4
    z4_x, z4_y, v7 = v4 * c4 + x3_x * s4, v5 * c4 + x3_y * s4, y3_z * c4 + v3 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    T[0, 0], T[0, 1], T[0, 2] = x4_x * c5 - s1 * s5, -(s1 * c5 + x4_x * s5), z4_x
    T[0, 3] = c1 * a1 + x2_x * a2 + x3_x * a3 + z4_x * d5
    T[1, 0], T[1, 1], T[1, 2] = x4_y * c5 + c1 * s5, c1 * c5 - x4_y * s5, z4_y
    T[1, 3] = s1 * a1 + x2_y * a2 + x3_y * a3 + z4_y * d5
    T[2, 0], T[2, 1], T[2, 2] = x4_z * c5, -(x4_z * s5), -v7
    T[2, 3] = d1 - s2 * a2 - v3 * a3 - v7 * d5
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 5): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 5)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * a1, s1 * a1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2, p2_x, p2_y = s1 * s2, p1_x + x2_x * a2, p1_y + x2_y * a2
    p2_z = d1 - s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v3 = x2_x * c3 - v1 * s3, x2_y * c3 - v2 * s3, s2 * c3 + c2 * s3
    p3_x, p3_y, p3_z = p2_x + x3_x * a3, p2_y + x3_y * a3, p2_z - v3 * a3
    v4 = q[3] + offset4
    c4, s4 = math.cos(v4), math.sin(v4)
    z4_x, z4_y = (v1 * c3 + x2_x * s3) * c4 + x3_x * s4, (v2 * c3 + x2_y * s3) * c4 + x3_y * s4
    v5, p5_x, p5_y = (s2 * s3 - c2 * c3) * c4 + v3 * s4, p3_x + z4_x * d5, p3_y + z4_y * d5
    p5_z = p3_z - v5 * d5
    v6, v7, v8 = p5_z - d1, p5_z - p2_z, p5_x - p3_x
    v9, v10 = p5_y - p3_y, p5_z - p3_z
    J[0, 0], J[0, 1], J[0, 2] = -p5_y, c1 * v6, c1 * v7
    J[0, 3], J[0, 4] = c1 * v10, z4_y * v10 + v5 * v9
    J[1, 0], J[1, 1], J[1, 2] = p5_x, s1 * v6, s1 * v7
    J[1, 3], J[1, 4] = s1 * v10, -(v5 * v8 + z4_x * v10)
    J[2, 1] = -(s1 * (p5_y - p1_y) + c1 * (p5_x - p1_x))
    J[2, 2], J[2, 3] = -(s1 * (p5_y - p2_y) + c1 * (p5_x - p2_x)), -(s1 * v9 + c1 * v8)
    J[2, 4] = z4_x * v9 - z4_y * v8
    J[3, 1], J[3, 2], J[3, 3] = -s1, -s1, -s1
    J[3, 4] = z4_x
    J[4, 1], J[4, 2], J[4, 3] = c1, c1, c1
    J[4, 4] = z4_y
    J[5, 0], J[5, 4] = 1.0, -v5
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, T13, T14, _, _, T23, T24, _, _, T33, T34 = pose

    # theta1, type 2: U1[3, 4], so theta1 = atan2(T24, T14) or half a turn from it. Where both are
    # small, U1[3, 3] says more: its vector, along the same line, is added
    sigma1 = math.copysign(second_weight, T14 * T13 + T24 * T23)
    Xhat1 = T14 + T13 * sigma1
    Yhat1 = T24 + T23 * sigma1
    w1 = math.sqrt(Xhat1 * Xhat1 + Yhat1 * Yhat1)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta234, type 3: U1[2, 3] and U1[1, 3]
    v1 = T33 * T33

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    v4 = T34 - d1

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(Xhat1 * factor1)
        s1 = math.sin(seed[0]) if free1 else -(Yhat1 * factor1)
        q1 = _atan2(s1, c1)

        # theta234
        Z2_234 = T13 * c1 + T23 * s1
        w234 = math.sqrt(Z2_234 * Z2_234 + v1)
        short234 = w234 <= free_limit
        v2 = 1.0 / (1.0 if short234 else w234)
        c234, s234 = T33 * v2, Z2_234 * v2
        theta234 = _atan2(s234, c234)

        # theta3
        v3 = c234 * d5
        Z1_3 = v4 - v3
        v5 = s234 * d5
        Z2_3 = T14 * c1 + T24 * s1 - a1 - v5
        N3 = Z1_3 * Z1_3 + Z2_3 * Z2_3
        K3 = N3 - k1
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            if free1:
                status[2 * i1] = _status.LOST + 1
                q[2 * i1, 0] = D3_squared
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        c3 = K3 * k2

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        Y1_2 = a2 + a3 * c3
        v7, v9 = Z1_3 * Y1_2, Z2_3 * Y1_2

        # is the pose one that the arm can take?
        v10, v12 = a1 + v5, d1 + v3
        if (
            not (abs(T33 - c234) <= doubtful_slack and abs(T13 - c1 * s234) <= doubtful_slack and
            abs(T23 - s1 * s234) <= doubtful_slack)
        ):
            continue  # the arm can't take this pose

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            s3 = w3 * e3 * k2
            q3 = _atan2(s3, c3)

            # theta2
            v6 = a3 * s3
            v8 = Z2_3 * v6 + v7
            C2 = v9 - Z1_3 * v6
            w2 = math.sqrt(v8 * v8 + C2 * C2)
            free2 = w2 <= free_limit_squared2
            factor2 = 1.0 / (1.0 if free2 else w2)
            c2 = math.cos(seed[1]) if free2 else C2 * factor2
            s2 = math.sin(seed[1]) if free2 else -(v8 * factor2)
            q2 = _atan2(s2, c2)

            # is the pose one that the arm can take?
            c23, s23 = c3 * c2 - s3 * s2, c3 * s2 + s3 * c2
            v11 = a3 * c23 + (a2 * c2 + v10)
            if (
                not (abs(T34 + (a3 * s23 + (a2 * s2 - v12))) <= doubtful_slack1 and abs(T14 - c1 *
                v11) <= doubtful_slack1 and abs(T24 - s1 * v11) <= doubtful_slack1)
            ):
                continue  # the arm can't take this pose

            # joint values
            q4 = _wrap(theta234 - (q3 + q2) - offset4)
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
            q[row, 3], q[row, 4] = q4, q_free[0]
            status[row] = FREE_JOINT if free1 or free2 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T13, T14, T23 = kept[2 * w + k], kept[3 * w + k], kept[6 * w + k]
        T24, T33, T34 = kept[7 * w + k], kept[10 * w + k], kept[11 * w + k]
        given1 = kept[16 * w + k]

        # theta1, type 2: U1[3, 4], so theta1 = atan2(T24, T14) or half a turn from it. Where both
        # are small, U1[3, 3] says more: its vector, along the same line, is added
        sigma1 = math.copysign(second_weight, T14 * T13 + T24 * T23)
        Xhat1, Yhat1 = T14 + T13 * sigma1, T24 + T23 * sigma1
        v1 = Xhat1 * Xhat1 + Yhat1 * Yhat1
        w1, v2 = math.sqrt(v1), 1.0 / v1
        factor1 = w1 * v2
        v3, v4 = Xhat1 * factor1, Yhat1 * factor1

        # theta234, type 3: U1[2, 3] and U1[1, 3]
        v5 = w1 * (v2 * (T13 * Xhat1 + T23 * Yhat1))
        v6 = T33 * T33 + v5 * v5
        w234, v7 = math.sqrt(v6), 1.0 / v6
        v8 = w234 * v7

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        v9, v10 = d5 * T33, T34 - d1
        v11 = v8 * v9
        Z1_3, v12, v13 = v10 - v11, d5 * v5, T14 * v3 + T24 * v4
        v14, v15, v16 = a1 + v13, a1 - v13, v8 * v12
        v17, v18 = v16 - v14, w234 * (v7 * v12)
        Z2_3_p, v19, v20 = v18 - v14, v15 + v18, Z1_3 * Z1_3
        N3_p, N3_m = v20 + Z2_3_p * Z2_3_p, v20 + v19 * v19
        K3_p, K3_m, D3_squared_p = N3_p - k1, N3_m - k1, (longest3 - N3_p) * (N3_p - shortest3)
        D3_squared_m, w3_p = (longest3 - N3_m) * (N3_m - shortest3), math.sqrt(D3_squared_p)
        w3_m, v21 = math.sqrt(D3_squared_m), w3_p - w3_p
        v22, s3_p, s3_m = w3_m - w3_m, k2 * w3_p, k2 * w3_m
        c3_p, c3_m = k2 * K3_p, k2 * K3_m

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        v23, v24, v25 = v9 * v10, v7 * (v9 * v9 + v12 * v12), v10 * v10
        Y1_2_p = m7 * (v24 + (v25 + v14 * v14)) - w234 * (m6 * (v7 * (v23 + v12 * v14)))
        Y1_2_m = m7 * (v24 + (v25 + v15 * v15)) - w234 * (m6 * (v7 * (v23 - v12 * v15)))
        v26, v27 = Z1_3 * Y1_2_p, Z1_3 * Y1_2_m
        v28, v29, v30 = v26 + w3_p * (m7 * v17), v26 + w3_p * (m7 * -v17), w3_m * (m7 * (v15 + v16))
        v31, v32, v33 = v27 - v30, v27 + v30, Z2_3_p * Y1_2_p
        v34, v35, v36 = v19 * Y1_2_m, m7 * Z1_3, m7 * -Z1_3
        C2_pp, C2_pm, v37 = v33 - w3_p * v35, v33 - w3_p * v36, v34 + w3_m * v35
        v38, v39, v40 = v34 + w3_m * v36, v28 * v28 + C2_pp * C2_pp, v29 * v29 + C2_pm * C2_pm
        v41, v42, w2_pp = v31 * v31 + v37 * v37, v32 * v32 + v38 * v38, math.sqrt(v39)
        w2_pm, w2_mp, w2_mm = math.sqrt(v40), math.sqrt(v41), math.sqrt(v42)
        v43, v44, v45 = 1.0 / v39, 1.0 / v40, 1.0 / v41
        v46, factor2_pp, factor2_pm = 1.0 / v42, w2_pp * v43, w2_pm * v44
        factor2_mp, factor2_mm = w2_mp * v45, w2_mm * v46

        # is the pose one that the arm can take?
        v47, v48 = a1 - v16, a1 + v16
        v49 = v47 + w2_pp * (v43 * (a3 * (c3_p * C2_pp + s3_p * v28) + a2 * C2_pp))
        v50 = v47 + w2_pm * (v44 * (a3 * (c3_p * C2_pm - s3_p * v29) + a2 * C2_pm))
        v51 = v48 + w2_mp * (v45 * (a3 * (s3_m * v31 - c3_m * v37) - a2 * v37))
        v52, v53 = v48 - w2_mm * (v46 * (a3 * (c3_m * v38 + s3_m * v32) + a2 * v38)), d1 + v11
        v54, v55, v56 = T33 - T33 * v8, T13 - v8 * (v3 * v5), T23 - v8 * (v4 * v5)
        v57 = (
            T34 + (factor2_pp * (a3 * (s3_p * C2_pp - c3_p * v28)) - (v53 + factor2_pp * (a2 *
            v28)))
        )
        v58 = (
            T34 - (factor2_pm * (a3 * (s3_p * C2_pm + c3_p * v29)) + (v53 + factor2_pm * (a2 *
            v29)))
        )
        v59 = (
            T34 - (factor2_mp * (a3 * (s3_m * v37 + c3_m * v31)) + (v53 + factor2_mp * (a2 * v31)))
        )
        v60 = (
            T34 + (factor2_mm * (a3 * (s3_m * v38 - c3_m * v32)) - (v53 + factor2_mm * (a2 * v32)))
        )
        v61, v62, v63 = T14 + v3 * v49, T14 + v3 * v50, T14 - v3 * v51
        v64, v65, v66 = T14 - v3 * v52, T24 + v4 * v49, T24 + v4 * v50
        v67, v68, v69 = T24 - v4 * v51, T24 - v4 * v52, v57 * v57 + v61 * v61 + v65 * v65
        v70, v71 = v58 * v58 + v62 * v62 + v66 * v66, v59 * v59 + v63 * v63 + v67 * v67
        v72, exact__pp, exact__pm = v60 * v60 + v64 * v64 + v68 * v68, v69 <= m10, v70 <= m10
        exact__mp, exact__mm = v71 <= m10, v72 <= m10

        # joint values
        v81 = math.sqrt(-1.0)
        v82 = 0.0 if exact__pp else v81
        v83 = 0.0 if exact__pm else v81
        v84 = 0.0 if exact__mp else v81
        v85 = 0.0 if exact__mm else v81
        v88, v89 = v21 + given1, v22 + given1
        q5_pp, q5_pm, q5_mp = v82 + v88, v83 + v88, v84 + v89
        q5_mm = v85 + v89

        # a joint is free, or branches meet
        kept[17 * w + k] = (
            1.0 if v6 <= m3 or v1 <= m1 or (m10 < v72 and v72 <= m11) or v42 <= m8 or (m10 < v71 and
            v71 <= m11) or v41 <= m8 or (m10 < v70 and v70 <= m11) or v40 <= m8 or (m10 < v69 and
            v69 <= m11) or v39 <= m8 or m9 < v54 * v54 + v55 * v55 + v56 * v56 or ((v72 <= m12 or
            v71 <= m12 or v69 <= m12 or v70 <= m12) and not (exact__mm or exact__mp or exact__pp or
            exact__pm)) or (-m4 <= D3_squared_p and D3_squared_p <= m5) or (-m4 <= D3_squared_m and
            D3_squared_m <= m5) else kept[17 * w + k]
        )
        kept[18 * w + k], kept[19 * w + k], kept[20 * w + k] = Yhat1, v21, v22
        kept[21 * w + k], kept[22 * w + k], kept[23 * w + k] = v82, v83, v84
        kept[24 * w + k], kept[25 * w + k], kept[26 * w + k] = v85, q5_pp, q5_pm
        kept[27 * w + k], kept[28 * w + k], turns[0 * w + k] = q5_mp, q5_mm, -Yhat1
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = -v5, w3_p, w3_m
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = -v28, -v29, -v31
        turns[7 * w + k], turns[8 * w + k], turns[9 * w + k] = -v32, -Xhat1, T33
        turns[10 * w + k], turns[11 * w + k], turns[12 * w + k] = K3_p, K3_m, C2_pp
        turns[13 * w + k], turns[14 * w + k], turns[15 * w + k] = C2_pm, -v37, -v38
    if w == 1 and kept[17] != 0.0:
        return
    for k in range(0 * w, 8 * w):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        Yhat1, v21, v22 = kept[18 * w + k], kept[19 * w + k], kept[20 * w + k]
        v82, v83, v84 = kept[21 * w + k], kept[22 * w + k], kept[23 * w + k]
        v85, q5_pp, q5_pm = kept[24 * w + k], kept[25 * w + k], kept[26 * w + k]
        q5_mp, q5_mm, angle1 = kept[27 * w + k], kept[28 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]
        angle8 = turns[7 * w + k]

        # joint values
        v73, v74 = angle2 - (angle3 + angle5) - offset4, angle2 - (angle6 - angle3) - offset4
        v75, v76 = offset4 + (angle2 + (angle4 + angle7)), offset4 + (angle2 + (angle8 - angle4))
        v77 = v73 + (turn if v73 <= -half_turn else (-turn if half_turn < v73 else 0.0))
        v78 = v74 + (turn if v74 <= -half_turn else (-turn if half_turn < v74 else 0.0))
        v79 = (turn if -v75 <= -half_turn else (-turn if half_turn < -v75 else 0.0)) - v75
        v80 = (turn if -v76 <= -half_turn else (-turn if half_turn < -v76 else 0.0)) - v76
        v86, v87 = angle1 + v21, v22 + (angle1 - math.copysign(half_turn, -Yhat1))
        q1_pp, q1_pm, q1_mp = v82 + v86, v83 + v86, v84 + v87
        q1_mm, q2_pp, q2_pm = v85 + v87, angle5 + v82, angle6 + v83
        q2_mp, q2_mm, q3_pp = angle7 + v84, angle8 + v85, angle3 + v82
        q3_pm, q3_mp, q3_mm = v83 - angle3, angle4 + v84, v85 - angle4
        q4_pp = v82 + (v77 + (turn if v77 <= -half_turn else 0.0))
        q4_pm = v83 + (v78 + (turn if v78 <= -half_turn else 0.0))
        q4_mp = v84 + (v79 + (turn if v79 <= -half_turn else 0.0))
        q4_mm = v85 + (v80 + (turn if v80 <= -half_turn else 0.0))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_pp, q2_pp, q3_pp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_pp, q5_pp, q1_pm
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q2_pm, q3_pm, q4_pm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q5_pm, q1_mp, q2_mp
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q3_mp, q4_mp, q5_mp
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q1_mm, q2_mm, q3_mm
        rows[18 * w + k], rows[19 * w + k] = q4_mm, q5_mm
        rows[20 * w + k] = UNREACHABLE if q1_pp != q1_pp else OK
        rows[21 * w + k] = UNREACHABLE if q1_pm != q1_pm else OK
        rows[22 * w + k] = UNREACHABLE if q1_mp != q1_mp else OK
        rows[23 * w + k] = UNREACHABLE if q1_mm != q1_mm else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 29, 16, [
    [0, 1, 2, 3, 4], [5, 6, 7, 8, 9], [10, 11, 12, 13, 14], [15, 16, 17, 18, 19],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "pointing", _FORMULAS, given=1, apart=(_runtime("complete").compile_apart,),
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
