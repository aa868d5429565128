# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 0a8b7c253a33639f
"""craig_417: Arm of exercise 4.17 in Craig, Introduction to Robotics.

Inverse kinematics, generated from robots/craig_417.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/craig_417.yaml. The formulas and where they come from: craig_417.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 4), _runtime("arrays").zeros

NAME = "craig_417"
METHOD = "closed form"
DOF = 4
JOINT_TYPES = "RRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = ("right", "left")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, reach_slack = 1e-13, merge_slack = 1e-14, d3 = 1.0 [m],
# doubt_limit = 9.999999999999999e-05, doubt_limit2 = 0.0009 [m^2].
sqrt2 = 1.4142135623730951  # square root of 2
d4 = 1.0  # joint offset 4 [m]
a3 = 1.0  # link length 4 [m]
free_limit = 1e-12  # a length that fixes no angle
free_limit2 = 9e-12  # a length that fixes no angle [m^2]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 3.0000000000000004e-05  # a pose may be rounded by this [m]
k1 = 0.5  # 1 / 2
k2 = 0.7071067811865476  # sqrt2 * 1 / 2
k3 = 0.5000000000000001  # k2^2
k4 = 1.4142135623731953e-13  # reach_slack * (2 * sqrt2 * 1 / 2 + reach_slack)
k5 = 1.4142135623731051e-14  # merge_slack * (2 * sqrt2 * 1 / 2 + merge_slack)
k6 = 2.0  # d3 + d4 [m]
k7 = 2.8284271247461903  # sqrt2 * k6 [m]
m1 = 1.414213562373105e-11  # 1000 * k5
m2 = 9.999999999999999e-09  # doubt_limit^2
m3 = 0.7071067811865476  # k2
m4 = 0.5  # a3 * k1 [m]
m5 = 1.4142135623730951  # a3 * k1 * k7 [m^2]
m6 = 8.1e-07  # doubt_limit2^2 [m^4]
m7 = 9.000000000000002e-10  # pose_slack1^2 [m^2]
m8 = 2.7000000000000006e-09  # 3 * pose_slack1^2 [m^2]
m9 = 1.0000000000000002e-10  # pose_slack^2
m10 = 6.000000000000001e-10  # 6 * pose_slack^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="rotation",
    miss_weights=(0.3333, 0.3333, 0.3333, 1.0, 1.0, 1.0), size=3.0, steps=("follows seed",),
))

# The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 1.0, 0.0, 0.7853981633974483),
    (0.0, 1.0, 1.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="modified",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (4,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2 * k2
    v2, z3_z, v3 = s1 * s2 * k2, c2 * k2, s1 * k2
    z3_x, v4 = v1 - v3, c1 * k2
    z3_y, v5, v6 = v2 + v4, v1 + v3, v4 - v2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, v7 = x2_x * c3 - v5 * s3, x2_y * c3 + v6 * s3, s2 * c3 + z3_z * s3
    v8, y3_y, y3_z = v5 * c3 + x2_x * s3, v6 * c3 - x2_y * s3, s2 * s3 - z3_z * c3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    T[0, 0], T[0, 1], T[0, 2] = x3_x * c4 - v8 * s4, -(v8 * c4 + x3_x * s4), z3_x
    T[0, 3] = z3_x + x3_x * a3 + z3_x * d4
    T[1, 0], T[1, 1], T[1, 2] = x3_y * c4 + y3_y * s4, y3_y * c4 - x3_y * s4, z3_y
    T[1, 3] = z3_y + x3_y * a3 + z3_y * d4
    T[2, 0], T[2, 1], T[2, 2] = y3_z * s4 - v7 * c4, y3_z * c4 + v7 * s4, z3_z
    T[2, 3] = z3_z - v7 * a3 + z3_z * d4
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 4): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    v1, v2, z3_z = c1 * s2 * k2, s1 * s2 * k2, c2 * k2
    v3 = s1 * k2
    z3_x, v4 = v1 - v3, c1 * k2
    z3_y = v2 + v4
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    p4_x = z3_x + (c1 * c2 * c3 - (v1 + v3) * s3) * a3 + z3_x * d4
    p4_y = z3_y + (s1 * c2 * c3 + (v4 - v2) * s3) * a3 + z3_y * d4
    p4_z, v5, v6 = z3_z - (s2 * c3 + z3_z * s3) * a3 + z3_z * d4, p4_x - z3_x, p4_y - z3_y
    v7 = p4_z - z3_z
    J[0, 0], J[0, 1], J[0, 2] = -p4_y, c1 * p4_z, z3_y * v7 - z3_z * v6
    J[1, 0], J[1, 1], J[1, 2] = p4_x, s1 * p4_z, z3_z * v5 - z3_x * v7
    J[2, 1], J[2, 2] = -(s1 * p4_y + c1 * p4_x), z3_x * v6 - z3_y * v5
    J[3, 1], J[3, 2], J[3, 3] = -s1, z3_x, z3_x
    J[4, 1], J[4, 2], J[4, 3] = c1, z3_y, z3_y
    J[5, 0], J[5, 2], J[5, 3] = 1.0, z3_z, z3_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, _, T33, T34 = pose

    # theta1, type 2: U1[2, 3]
    N1 = T13 * T13 + T23 * T23
    D1_squared = N1 - k3
    apart1 = k5 < D1_squared
    if not (-k4 <= D1_squared):
        return  # out of reach
    w1 = math.sqrt(D1_squared if apart1 else 0.0)
    inverse1 = 1.0 / (N1 if apart1 else k2 * math.sqrt(N1))
    v1, v2 = T13 * k2, T23 * k2

    # theta2, type 3: U1[3, 3] and U1[1, 3]
    v3 = k2 * T33
    v4 = v3 * v3

    # theta3, type 3: U2[3, 4] and U2[1, 4]
    v10, v11 = 2.0 * T24, 2.0 * T14

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and not apart1:
            continue  # both signs give the same
        D1 = w1 * e1
        c1, s1 = inverse1 * (v2 - T13 * D1), -(inverse1 * (v1 + T23 * D1))
        q1 = _atan2(s1, c1)

        # theta2
        S2 = k2 * D1
        w2 = math.sqrt(S2 * S2 + v4)
        short2 = w2 <= free_limit
        v5 = 1.0 / (1.0 if short2 else w2)
        c2, v6 = v3 * v5, S2 * v5
        q2 = _atan2(-v6, c2)

        # theta34, type 3: U1[2, 2] and U1[2, 1]
        Z2_34 = T21 * c1 - T11 * s1
        v7, v8 = k2 * Z2_34, k2 * (T22 * c1 - T12 * s1)
        w34 = math.sqrt(v7 * v7 + v8 * v8)
        short34 = w34 <= free_limit
        v9 = 1.0 / (1.0 if short34 else w34)
        c34, s34 = v8 * v9, v7 * v9

        # theta3
        v12, v13 = v6 * T34, a3 * (k1 * (s1 * v11 - c1 * v10 + k7))
        C3 = k2 * (c2 * (c1 * T14 + s1 * T24) + v12)
        w3 = math.sqrt(v13 * v13 + C3 * C3)
        short3 = w3 <= free_limit2
        factor3 = 1.0 / (1.0 if short3 else w3)
        c3, v14 = C3 * factor3, v13 * factor3
        q3 = _atan2(-v14, c3)

        # is the pose one that the arm can take?
        v15, v16, v17 = c1 * c2, c1 * v6, s1 * c2
        v18, v19, v20 = s1 * v6, k1 * (sqrt2 * s34), a3 * v14
        if (
            not (abs(c1 * T24 - s1 * T14 - k1 * (sqrt2 * (k6 - v20))) <= pose_slack1 and abs(T23 *
            c1 - T13 * s1 - k2) <= pose_slack and abs(Z2_34 - v19) <= pose_slack and abs(T14 * v16 +
            T24 * v18 - c2 * T34 + k1 * (sqrt2 * (k6 + v20))) <= pose_slack1 and abs(k2 + (T13 * v16
            + T23 * v18 - T33 * c2)) <= pose_slack and abs(T11 * v16 + T21 * v18 - T31 * c2 - v19)
            <= pose_slack and abs(v12 + (T14 * v15 + T24 * v17) - a3 * c3) <= pose_slack1 and
            abs(T11 * v15 + T21 * v17 + T31 * v6 - c34) <= pose_slack and abs(T13 * v15 + T23 * v17
            + T33 * v6) <= pose_slack)
        ):
            continue  # the arm can't take this pose

        # joint values
        q4 = _wrap(_atan2(s34, c34) - q3)
        row = i1
        q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
        q[row, 3] = q4
        status[row] = OK


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

        # theta1, type 2: U1[2, 3]
        N1 = T13 * T13 + T23 * T23
        D1_squared = N1 - k3
        w1, inverse1, v1 = math.sqrt(D1_squared), 1.0 / N1, k2 * T13
        v2 = k2 * T23
        v3, v4 = inverse1 * v2, w1 * (T13 * inverse1)
        c1_p, c1_m, v5 = v3 - v4, v3 + v4, inverse1 * v1
        v6 = w1 * (T23 * inverse1)
        v7, v8 = v5 + v6, v5 - v6

        # theta2, type 3: U1[3, 3] and U1[1, 3]
        S2, v9 = k2 * w1, k2 * T33
        v10 = v9 * v9 + S2 * S2
        w2, v11 = math.sqrt(v10), 1.0 / v10
        v12 = w2 * v11
        c2, v13 = v9 * v12, S2 * v12

        # theta34, type 3: U1[2, 2] and U1[2, 1]
        v14, v15 = T23 * T11 - T13 * T21, m3 * (inverse1 * (v1 * T11 + v2 * T21))
        v16, v17 = v15 + w1 * (m3 * (inverse1 * v14)), v15 + w1 * (m3 * (inverse1 * -v14))
        v18, v19 = T23 * T12 - T13 * T22, m3 * (inverse1 * (v1 * T12 + v2 * T22))
        v20, v21 = v19 + w1 * (m3 * (inverse1 * v18)), v19 + w1 * (m3 * (inverse1 * -v18))
        v22, v23 = v16 * v16 + v20 * v20, v17 * v17 + v21 * v21
        v24, v25 = math.sqrt(v22) * (1.0 / v22), math.sqrt(v23) * (1.0 / v23)

        # theta3, type 3: U2[3, 4] and U2[1, 4]
        v26, v27, v28 = 2.0 * T24, 2.0 * T14, v13 * T34
        v29, v30 = T13 * v26 - T23 * v27, m5 - m4 * (inverse1 * (v1 * v27 + v2 * v26))
        v31, v32 = v30 + w1 * (m4 * (inverse1 * v29)), v30 + w1 * (m4 * (inverse1 * -v29))
        v33 = S2 * T34
        C3_p = w2 * (m3 * (v11 * (v33 + v9 * (c1_p * T14 - v7 * T24))))
        C3_m = w2 * (m3 * (v11 * (v9 * (c1_m * T14 - v8 * T24) - v33)))
        v34, v35 = v31 * v31 + C3_p * C3_p, v32 * v32 + C3_m * C3_m
        factor3_p, factor3_m = math.sqrt(v34) * (1.0 / v34), math.sqrt(v35) * (1.0 / v35)

        # is the pose one that the arm can take?
        v36, v37, v38 = c1_p * c2, c1_m * c2, c1_p * v13
        v39, v40, v41 = c1_m * v13, v7 * c2, v8 * c2
        v42, v43, v44 = v7 * v13, v8 * v13, k1 * (sqrt2 * (v16 * v24))
        v45, v46, v47 = k1 * (sqrt2 * (v17 * v25)), a3 * (v31 * factor3_p), a3 * (v32 * factor3_m)
        v48 = c1_p * T24 + v7 * T14 - k1 * (sqrt2 * (k6 - v46))
        v49, v50 = c1_m * T24 + v8 * T14 - k1 * (sqrt2 * (k6 - v47)), T23 * c1_p + T13 * v7 - k2
        v51, v52 = T23 * c1_m + T13 * v8 - k2, c1_p * T21 + v7 * T11 - v44
        v53, v54 = c1_m * T21 + v8 * T11 - v45, c2 * T34
        v55 = T14 * v38 - T24 * v42 - v54 + k1 * (sqrt2 * (k6 + v46))
        v56, v57 = T24 * v43 - T14 * v39 - v54 + k1 * (sqrt2 * (k6 + v47)), T33 * c2
        v58, v59 = k2 + (T13 * v38 - T23 * v42 - v57), k2 + (T23 * v43 - T13 * v39 - v57)
        v60 = c2 * T31
        v61, v62 = T11 * v38 - T21 * v42 - v60 - v44, T21 * v43 - T11 * v39 - v60 - v45
        v63 = v28 + (T14 * v36 - T24 * v40) - a3 * (C3_p * factor3_p)
        v64, v65 = T14 * v37 - T24 * v41 - v28 - a3 * (C3_m * factor3_m), v13 * T31
        v66 = v65 + (T11 * v36 - T21 * v40) - v20 * v24
        v67, v68 = T11 * v37 - T21 * v41 - v65 - v21 * v25, T33 * v13
        v69, v70 = v68 + (T13 * v36 - T23 * v40), T13 * v37 - T23 * v41 - v68
        v71, v72 = v48 * v48 + v55 * v55 + v63 * v63, v49 * v49 + v56 * v56 + v64 * v64
        v73 = v50 * v50 + v52 * v52 + v58 * v58 + v61 * v61 + v66 * v66 + v69 * v69
        v74 = v51 * v51 + v53 * v53 + v59 * v59 + v62 * v62 + v67 * v67 + v70 * v70

        # joint values
        v77 = math.sqrt(-1.0)
        v78 = 0.0 if (v71 <= m7 and v73 <= m9) else v77
        v79 = 0.0 if (v72 <= m7 and v74 <= m9) else v77

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v35 <= m6 or v23 <= m2 or v34 <= m6 or v22 <= m2 or (m7 < v72 and v72 <= m8) or
            (m7 < v71 and v71 <= m8) or (m9 < v74 and v74 <= m10) or abs(D1_squared) <= m1 or v10 <=
            m2 or (m9 < v73 and v73 <= m10) else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], turns[0 * w + k] = v78, v79, -S2
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = -v31, -v32, v16
        turns[4 * w + k], turns[5 * w + k], turns[6 * w + k] = v17, -v7, -v8
        turns[8 * w + k], turns[9 * w + k], turns[10 * w + k] = v9, C3_p, C3_m
        turns[11 * w + k], turns[12 * w + k], turns[13 * w + k] = v20, v21, c1_p
        turns[14 * w + k] = c1_m
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 7 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(7 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        v78, v79, angle1 = kept[17 * w + k], kept[18 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6, angle7 = turns[4 * w + k], turns[5 * w + k], turns[6 * w + k]

        # joint values
        v75, v76, q1_p = angle4 - angle2, angle5 - angle3, v78 + angle6
        q1_m, q2_p, q2_m = v79 + angle7, angle1 + v78, v79 - angle1
        q3_p, q3_m = angle2 + v78, angle3 + v79
        q4_p = v78 + (v75 + (turn if v75 <= -half_turn else (-turn if half_turn < v75 else 0.0)))
        q4_m = v79 + (v76 + (turn if v76 <= -half_turn else (-turn if half_turn < v76 else 0.0)))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_p, q2_p, q3_p
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q4_p, q1_m, q2_m
        rows[6 * w + k], rows[7 * w + k] = q3_m, q4_m
        rows[8 * w + k] = UNREACHABLE if q1_p != q1_p else OK
        rows[9 * w + k] = UNREACHABLE if q1_m != q1_m else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 19, 16, [
    [0, 1, 2, 3], [4, 5, 6, 7],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
