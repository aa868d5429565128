# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 1cbcbf07d0e3a04a
"""wrist_oblique: Oblique spherical wrist.

Inverse kinematics, generated from robots/wrist_oblique.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/wrist_oblique.yaml. The formulas and where they come from:
wrist_oblique.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 3), _runtime("arrays").zeros

NAME = "wrist_oblique"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRR"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = ((-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf))
BRANCHES = ("shoulder+", "shoulder-")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit = 9.999999999999999e-05.
sqrt3 = 1.7320508075688772  # square root of 3
ca2 = 0.6427876096865394  # cosine of twist 2
sa2 = 0.766044443118978  # sine of twist 2
d3 = 0.1  # joint offset 3 [m]
free_limit_squared2 = 1.0000000000000002e-26  # square of a length that fixes no angle [m^2]
reach_slack1 = 1.0000000000000002e-14  # rounding at the boundary of the workspace [m]
merge_slack1 = 1e-15  # nearer to that boundary two branches are one [m]
free_limit = 1e-12  # a length that fixes no angle
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 1.0000000000000002e-06  # a pose may be rounded by this [m]
k1 = 0.5  # 1 / 2
k2 = 0.06427876096865394  # d3 * ca2 [m]
k3 = 0.12855752193730788  # 2 * d3 * ca2 [m]
k4 = 0.6634139481689384  # sa2 * sqrt3 / 2
k5 = 0.8660254037844386  # sqrt3 / 2
f2 = 0.8660254037844386  # 1 / 2 * sqrt3
f3 = 0.383022221559489  # sa2 * 1 / 2
f4 = 0.3213938048432697  # ca2 * 1 / 2
doubt_limit_squared2 = 1.0000000000000002e-10  # square of a length that fixes no angle [m^2]
m1 = 1e-12  # 1000 * merge_slack1 [m]
m2 = 0.383022221559489  # sa2 * k1
m3 = 9.999999999999999e-09  # doubt_limit^2
m4 = 0.5  # k1
m5 = 0.8660254037844386  # sqrt3 * k1
m6 = 1.0000000000000004e-12  # pose_slack1^2 [m^2]
m7 = 3.000000000000001e-12  # 3 * pose_slack1^2 [m^2]
m8 = 1.0000000000000002e-10  # pose_slack^2
m9 = 6.000000000000001e-10  # 6 * pose_slack^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="rotation",
    miss_weights=(10.0, 10.0, 10.0, 1.0, 1.0, 1.0), size=0.1, steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.0, 1.0471975511965976),
    (0.0, 0.0, 0.0, -0.8726646259971648),
    (0.0, 0.1, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    v1, y1_y, z1_x = s1 * k1, c1 * k1, s1 * f2
    v2 = c1 * f2
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, x2_z = c1 * c2 - v1 * s2, s1 * c2 + y1_y * s2, f2 * s2
    v3, v4, v5 = v1 * c2 + c1 * s2, y1_y * c2 - s1 * s2, f2 * c2
    v6, y2_y, y2_z = v3 * ca2 + z1_x * sa2, v4 * ca2 + v2 * sa2, v5 * ca2 - f3
    z2_x, z2_y, z2_z = z1_x * ca2 - v3 * sa2, v4 * sa2 - v2 * ca2, v5 * sa2 + f4
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    T[0, 0], T[0, 1], T[0, 2] = x2_x * c3 - v6 * s3, -(v6 * c3 + x2_x * s3), z2_x
    T[0, 3] = z2_x * d3
    T[1, 0], T[1, 1], T[1, 2] = x2_y * c3 + y2_y * s3, y2_y * c3 - x2_y * s3, z2_y
    T[1, 3] = z2_y * d3
    T[2, 0], T[2, 1], T[2, 2] = x2_z * c3 + y2_z * s3, y2_z * c3 - x2_z * s3, z2_z
    T[2, 3] = z2_z * d3
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    z1_x, v1 = s1 * f2, c1 * f2
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    z2_x = z1_x * ca2 - (s1 * k1 * c2 + c1 * s2) * sa2
    z2_y, z2_z, p3_x = (c1 * k1 * c2 - s1 * s2) * sa2 - v1 * ca2, f2 * c2 * sa2 + f4, z2_x * d3
    p3_y, p3_z = z2_y * d3, z2_z * d3
    J[0, 0], J[0, 1], J[0, 2] = -p3_y, -(v1 * p3_z + k1 * p3_y), z2_y * p3_z - z2_z * p3_y
    J[1, 0], J[1, 1], J[1, 2] = p3_x, k1 * p3_x - z1_x * p3_z, z2_z * p3_x - z2_x * p3_z
    J[2, 1], J[2, 2] = z1_x * p3_y + v1 * p3_x, z2_x * p3_y - z2_y * p3_x
    J[3, 1], J[3, 2] = z1_x, z2_x
    J[4, 1], J[4, 2] = -v1, z2_y
    J[5, 0], J[5, 1], J[5, 2] = 1.0, k1, z2_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[3, 4]
    v1 = T14 * sqrt3 * k1
    Y1 = k1 * (sqrt3 * T24)
    N1 = v1 * v1 + Y1 * Y1
    free1 = N1 <= free_limit_squared2
    Z1 = k1 * (T34 - k3)
    D1_squared = N1 - Z1 * Z1
    v2 = abs(Z1)
    v3 = 2.0 * v2
    apart1 = merge_slack1 * (v3 + merge_slack1) < D1_squared
    if not (-(reach_slack1 * (v3 + reach_slack1)) < D1_squared):
        return  # out of reach
    w1 = math.sqrt(D1_squared if apart1 else 0.0)
    inverse1 = 1.0 / (1.0 if free1 else (N1 if apart1 else v2 * math.sqrt(N1)))
    v4, v5 = v1 * Z1, Y1 * Z1

    # theta3, type 3: U1[3, 2] and U1[3, 1]
    v6, v7, v8 = sqrt3 * T22, T12 * sqrt3, sqrt3 * T21
    v9 = T11 * sqrt3

    # theta2, type 3: U0 A3^-1 [3, 3] and U0 A3^-1 [3, 1]
    v14 = k1 * (2.0 * T33 - ca2) * k5
    v15 = v14 * v14

    # is the pose one that the arm can take?
    v21, v22, v24 = T31 * k5, T33 * k5, T34 * k5
    v27, v28, v29 = k1 * T31, k1 * T33, k1 * T34

    for i1 in range(2):  # shoulder+, shoulder-
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and (free1 or not apart1):
            continue  # both signs give the same
        D1 = w1 * e1
        c1 = math.cos(seed[0]) if free1 else inverse1 * (v5 + v1 * D1)
        s1 = math.sin(seed[0]) if free1 else inverse1 * (Y1 * D1 - v4)
        q1 = _atan2(s1, c1)

        # theta3
        S3 = sa2 * (k1 * (T31 + (s1 * v9 - c1 * v8)))
        C3 = sa2 * (k1 * (T32 + (s1 * v7 - c1 * v6)))
        w3 = math.sqrt(S3 * S3 + C3 * C3)
        short3 = w3 <= free_limit
        v10 = 1.0 / (1.0 if short3 else w3)
        v11, v12 = C3 * v10, S3 * v10
        q3 = _atan2(-v12, -v11)

        # theta2
        v13 = k4 * (T32 * v12 - T31 * v11)
        w2 = math.sqrt(v13 * v13 + v15)
        short2 = w2 <= free_limit
        v16 = 1.0 / (1.0 if short2 else w2)
        c2, s2 = v14 * v16, v13 * v16
        q2 = _atan2(s2, c2)

        # is the pose one that the arm can take?
        v17, v18, v19 = ca2 * v12, sa2 * s2, k1 * s1
        v20, v23, v25 = k1 * c1, sa2 * c2, k1 * (sqrt3 * s1)
        v26 = k1 * (sqrt3 * c1)
        if (
            not (abs(T14 * v25 - T24 * v26 + v29 - k2) <= pose_slack1 and abs(T13 * v25 - T23 * v26
            + v28 - ca2) <= pose_slack and abs(T11 * v25 - T21 * v26 + v27 - sa2 * v12) <=
            pose_slack and abs(T24 * v20 - T14 * v19 + v24 - d3 * v23) <= pose_slack1 and abs(T23 *
            v20 - T13 * v19 + v22 - v23) <= pose_slack and abs(T21 * v20 - T11 * v19 + v21 + (c2 *
            v17 + v11 * s2)) <= pose_slack and abs(T14 * c1 + T24 * s1 + d3 * v18) <= pose_slack1
            and abs(T11 * c1 + T21 * s1 - (s2 * v17 - v11 * c2)) <= pose_slack and abs(T13 * c1 +
            T23 * s1 + v18) <= pose_slack)
        ):
            continue  # the arm can't take this pose
        row = i1
        q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
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
        T32, T33, T34 = kept[9 * w + k], kept[10 * w + k], kept[11 * w + k]

        # theta1, type 2: U1[3, 4]
        v1, Y1 = k1 * (sqrt3 * T14), k1 * (sqrt3 * T24)
        N1, Z1 = v1 * v1 + Y1 * Y1, k1 * (T34 - k3)
        D1_squared = N1 - Z1 * Z1
        w1, inverse1, v2 = math.sqrt(D1_squared), 1.0 / N1, v1 * Z1
        v3, v4 = Y1 * Z1, v1 * w1
        c1_p, c1_m, v5 = v3 + v4, v3 - v4, Y1 * w1
        s1_p, v6 = v5 - v2, v2 + v5

        # theta3, type 3: U1[3, 2] and U1[3, 1]
        v7, v8, v9 = sqrt3 * T22, sqrt3 * T12, sqrt3 * T21
        v10 = sqrt3 * T11
        v11, v12 = Y1 * v10 - v1 * v9, m2 * (T31 - inverse1 * (v2 * v10 + v3 * v9))
        S3_p, S3_m = v12 + w1 * (m2 * (inverse1 * v11)), v12 + w1 * (m2 * (inverse1 * -v11))
        v13, v14 = Y1 * v8 - v1 * v7, m2 * (T32 - inverse1 * (v2 * v8 + v3 * v7))
        C3_p, C3_m = v14 + w1 * (m2 * (inverse1 * v13)), v14 + w1 * (m2 * (inverse1 * -v13))
        v15, v16 = S3_p * S3_p + C3_p * C3_p, S3_m * S3_m + C3_m * C3_m
        v17, v18 = math.sqrt(v15) * (1.0 / v15), math.sqrt(v16) * (1.0 / v16)
        v19, v20, v21 = C3_p * v17, C3_m * v18, S3_p * v17
        v22 = S3_m * v18

        # theta2, type 3: U0 A3^-1 [3, 3] and U0 A3^-1 [3, 1]
        v23, v24 = k4 * (T32 * v21 - T31 * v19), k4 * (T32 * v22 - T31 * v20)
        v25 = k5 * (k1 * (2.0 * T33 - ca2))
        v26 = v25 * v25
        v27, v28 = v26 + v23 * v23, v26 + v24 * v24
        v29, v30 = math.sqrt(v27) * (1.0 / v27), math.sqrt(v28) * (1.0 / v28)
        c2_p, c2_m, s2_p = v25 * v29, v25 * v30, v23 * v29
        s2_m = v24 * v30

        # is the pose one that the arm can take?
        v31, v32, v33 = ca2 * v21, ca2 * v22, sa2 * s2_p
        v34, v35, v36 = sa2 * s2_m, m4 * v2, w1 * (m4 * Y1)
        v37, v38, v39 = v36 - v35, v35 + v36, m4 * v3
        v40 = w1 * (m4 * v1)
        v41, v42, v43 = v39 + v40, v39 - v40, k5 * T31
        v44, v45, v46 = k5 * T33, sa2 * c2_p, sa2 * c2_m
        v47, v48, v49 = k5 * T34, m5 * v2, w1 * (m5 * Y1)
        v50, v51, v52 = v49 - v48, v48 + v49, m5 * v3
        v53 = w1 * (m5 * v1)
        v54, v55, v56 = v52 + v53, v52 - v53, k1 * T31
        v57, v58 = k1 * T33, k1 * T34
        v59 = v58 + inverse1 * (T14 * v50 - T24 * v54) - k2
        v60 = v58 - inverse1 * (T14 * v51 + T24 * v55) - k2
        v61 = v57 + inverse1 * (v50 * T13 - v54 * T23) - ca2
        v62 = v57 - inverse1 * (v51 * T13 + v55 * T23) - ca2
        v63 = v56 + inverse1 * (T11 * v50 - T21 * v54) - sa2 * v21
        v64 = v56 - inverse1 * (T11 * v51 + T21 * v55) - sa2 * v22
        v65 = v47 + inverse1 * (T24 * v41 - T14 * v37) - d3 * v45
        v66 = v47 + inverse1 * (T24 * v42 + T14 * v38) - d3 * v46
        v67 = v44 + inverse1 * (v41 * T23 - v37 * T13) - v45
        v68 = v44 + inverse1 * (v42 * T23 + v38 * T13) - v46
        v69 = v43 + inverse1 * (T21 * v41 - T11 * v37) + (c2_p * v31 + v19 * s2_p)
        v70 = v43 + inverse1 * (T21 * v42 + T11 * v38) + (c2_m * v32 + v20 * s2_m)
        v71 = d3 * v33 + inverse1 * (T14 * c1_p + T24 * s1_p)
        v72 = d3 * v34 + inverse1 * (T14 * c1_m - T24 * v6)
        v73 = inverse1 * (c1_p * T11 + s1_p * T21) - (s2_p * v31 - v19 * c2_p)
        v74 = inverse1 * (c1_m * T11 - v6 * T21) - (s2_m * v32 - v20 * c2_m)
        v75 = v33 + inverse1 * (c1_p * T13 + s1_p * T23)
        v76, v77 = v34 + inverse1 * (c1_m * T13 - v6 * T23), v59 * v59 + v65 * v65 + v71 * v71
        v78 = v60 * v60 + v66 * v66 + v72 * v72
        v79 = v61 * v61 + v63 * v63 + v67 * v67 + v69 * v69 + v73 * v73 + v75 * v75
        v80 = v62 * v62 + v64 * v64 + v68 * v68 + v70 * v70 + v74 * v74 + v76 * v76

        # joint values
        v81 = math.sqrt(-1.0)
        v82 = 0.0 if (v77 <= m6 and v79 <= m8) else v81
        v83 = 0.0 if (v78 <= m6 and v80 <= m8) else v81

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v28 <= m3 or v16 <= m3 or v27 <= m3 or v15 <= m3 or (m6 < v78 and v78 <= m7) or
            (m6 < v77 and v77 <= m7) or (m8 < v80 and v80 <= m9) or N1 <= doubt_limit_squared2 or
            abs(D1_squared) <= m1 * (merge_slack1 + 2.0 * abs(Z1)) or (m8 < v79 and v79 <= m9) else
            kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], turns[0 * w + k] = v82, v83, s1_p
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = -v6, v23, v24
        turns[4 * w + k], turns[5 * w + k], turns[8 * w + k] = -S3_p, -S3_m, c1_p
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = c1_m, v25, v25
        turns[12 * w + k], turns[13 * w + k] = -C3_p, -C3_m
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 6 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(6 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        v82, v83, angle1 = kept[17 * w + k], kept[18 * w + k], turns[0 * w + k]
        angle2, angle3, angle4 = turns[1 * w + k], turns[2 * w + k], turns[3 * w + k]
        angle5, angle6 = turns[4 * w + k], turns[5 * w + k]

        # joint values
        q1_p, q1_m, q2_p = v82 + angle1, v83 + angle2, v82 + angle3
        q2_m, q3_p, q3_m = v83 + angle4, v82 + angle5, v83 + angle6

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_p, q2_p, q3_p
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q1_m, q2_m, q3_m
        rows[6 * w + k] = UNREACHABLE if q1_p != q1_p else OK
        rows[7 * w + k] = UNREACHABLE if q1_m != q1_m else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 19, 16, [
    [0, 1, 2], [3, 4, 5],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
