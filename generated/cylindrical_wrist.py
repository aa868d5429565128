# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: af40b92118c6448a
"""cylindrical_wrist: Cylindrical arm with a spherical wrist.

Inverse kinematics, generated from robots/cylindrical_wrist.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/cylindrical_wrist.yaml. The formulas and where they come from:
cylindrical_wrist.md.

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

NAME = "cylindrical_wrist"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RPPRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = ("forward-noflip", "forward-flip", "backward-noflip", "backward-flip")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 4e-05 [m], doubt_limit = 9.999999999999999e-05.
d1 = 0.3  # joint offset 1 [m]
d6 = 0.1  # joint offset 6 [m]
free_limit1 = 4e-13  # a length that fixes no angle [m]
free_limit = 1e-12  # a length that fixes no angle
m1 = 1.6000000000000003e-09  # doubt_limit1^2 [m^2]
m3 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="rotation",
    miss_weights=(2.5, 2.5, 2.5, 1.0, 1.0, 1.0), size=0.4,
    slacks=(1e-09, 4e-10, 4e-10, 1e-09, 1e-09, 1e-09),
    weights=(1.0, 6.249999999999999, 6.249999999999999, 1.0, 1.0, 1.0),
    paces=(1.0, 0.4, 0.4, 1.0, 1.0, 1.0), steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.3, 0.0, 0.0),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.1, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, v1 = c1 * c4, s1 * c4, c1 * s4
    v2 = s1 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, v3 = x4_x * c5 + s1 * s5, x4_y * c5 - c1 * s5, s4 * c5
    z5_y, v4, z5_x = c1 * c5 + x4_y * s5, s4 * s5, x4_x * s5 - s1 * c5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 - v1 * s6, -(v1 * c6 + x5_x * s6), z5_x
    T[0, 3] = z5_x * d6 - s1 * q[2]
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 - v2 * s6, -(v2 * c6 + x5_y * s6), z5_y
    T[1, 3] = c1 * q[2] + z5_y * d6
    T[2, 0], T[2, 1], T[2, 2] = -(v3 * c6 + c4 * s6), v3 * s6 - c4 * c6, -v4
    T[2, 3] = d1 + q[1] - v4 * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1, p2_z = math.cos(q[0]), math.sin(q[0]), d1 + q[1]
    v1, p3_y = s1 * q[2], c1 * q[2]
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    v2, v3 = c1 * s4, s1 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    z5_y, v4, z5_x = c1 * c5 + s1 * c4 * s5, s4 * s5, c1 * c4 * s5 - s1 * c5
    p6_x, p6_y = z5_x * d6 - v1, p3_y + z5_y * d6
    v5, v6, v7 = v1 + p6_x, p6_y - p3_y, p2_z - v4 * d6 - p2_z
    J[0, 0], J[0, 2], J[0, 3] = -p6_y, -s1, c1 * v7
    J[0, 4], J[0, 5] = c4 * v6 - v3 * v7, z5_y * v7 + v4 * v6
    J[1, 0], J[1, 2], J[1, 3] = p6_x, c1, s1 * v7
    J[1, 4], J[1, 5] = v2 * v7 - c4 * v5, -(v4 * v5 + z5_x * v7)
    J[2, 1], J[2, 3], J[2, 4] = 1.0, -(s1 * v6 + c1 * v5), v3 * v5 - v2 * v6
    J[2, 5] = z5_x * v6 - z5_y * v5
    J[3, 3], J[3, 4], J[3, 5] = -s1, -v2, z5_x
    J[4, 3], J[4, 4], J[4, 5] = c1, -v3, z5_y
    J[5, 0], J[5, 4], J[5, 5] = 1.0, -c4, -v4
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # r2, type 1: U0 A6^-1 [3, 4]
    wz = T34 - T33 * d6
    r2 = wz - d1

    # theta1, r3, type 4: U0 A6^-1 [1, 4] and U0 A6^-1 [2, 4]
    wy = T24 - d6 * T23
    v1 = d6 * T13 - T14
    w3 = math.sqrt(v1 * v1 + wy * wy)
    free1 = w3 <= free_limit1
    divisor1 = 1.0 if free1 else w3

    # theta4, type 2: U4[3, 3]
    v2 = T33 * T33

    for i1 in range(2):  # forward, backward
        e1 = 1.0 - 2.0 * i1
        # theta1, r3
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else wy * factor1
        s1 = math.sin(seed[0]) if free1 else v1 * factor1
        q1 = _atan2(s1, c1)
        r3 = w3 * e1

        # theta4
        X4 = T13 * c1 + T23 * s1
        w4 = math.sqrt(X4 * X4 + v2)
        free4 = w4 <= free_limit
        divisor4 = 1.0 if free4 else w4

        # theta5, type 3: U4[2, 3] and U4[1, 3]
        c5 = T23 * c1 - T13 * s1

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v3, v4 = T12 * c1 + T22 * s1, T11 * c1 + T21 * s1

        for i2 in range(2):  # noflip, flip
            e4 = 1.0 - 2.0 * i2
            # theta4
            if e4 < 0.0 and free4:
                continue  # both signs give the same
            factor4 = e4 / divisor4
            c4 = math.cos(seed[3]) if free4 else -(X4 * factor4)
            s4 = math.sin(seed[3]) if free4 else T33 * factor4
            q4 = _atan2(s4, c4)

            # theta5
            q5 = _atan2(-(w4 * e4), c5)

            # theta6
            q6 = _atan2(-(T31 * c4 + s4 * v4), -(T32 * c4 + s4 * v3))
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, r2, r3
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

        # r2, type 1: U0 A6^-1 [3, 4]
        q2_pp = T34 - d6 * T33 - d1

        # theta1, r3, type 4: U0 A6^-1 [1, 4] and U0 A6^-1 [2, 4]
        wy, s1 = T24 - d6 * T23, d6 * T13 - T14
        v1 = s1 * s1 + wy * wy
        q3_pp = math.sqrt(v1)
        factor1 = q3_pp * (1.0 / v1)

        # theta4, type 2: U4[3, 3]
        X4 = wy * T13 + T23 * s1
        v2 = factor1 * X4
        v3 = T33 * T33 + factor1 * (X4 * v2)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v4 = X4 * T31 - T33 * (wy * T11 + s1 * T21)

        # a joint is free, or branches meet
        kept[16 * w + k] = 1.0 if v1 <= m1 or v3 <= m3 else kept[16 * w + k]
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = q2_pp, s1, q3_pp
        kept[20 * w + k], kept[21 * w + k], turns[0 * w + k] = v3, v4, s1
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = T33, -math.sqrt(v3), v4
        turns[8 * w + k], turns[9 * w + k] = wy, -v2
        turns[10 * w + k] = factor1 * (T23 * wy - T13 * s1)
        turns[11 * w + k] = X4 * T32 - T33 * (wy * T12 + s1 * T22)
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 4 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(4 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        T33, q2_pp, s1 = kept[10 * w + k], kept[17 * w + k], kept[18 * w + k]
        q3_pp, v3, v4 = kept[19 * w + k], kept[20 * w + k], kept[21 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4 = turns[3 * w + k]

        # theta1, r3, type 4: U0 A6^-1 [1, 4] and U0 A6^-1 [2, 4]
        q1_mp = angle1 - math.copysign(half_turn, s1)

        # theta4, type 2: U4[3, 3]
        q4_pm = angle2 - math.copysign(half_turn, T33)

        # theta5, type 3: U4[2, 3] and U4[1, 3]
        q5_mp = math.copysign(half_turn, -math.sqrt(v3)) - angle3

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_pm = angle4 - math.copysign(half_turn, v4)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle1, q2_pp, q3_pp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle2, angle3, angle4
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_pm, -angle3, q6_pm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q1_mp, -q3_pp, -q4_pm
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q5_mp, -angle2, -q5_mp
        rows[15 * w + k] = rows[16 * w + k] = UNREACHABLE if angle1 != angle1 else OK
        rows[17 * w + k] = rows[18 * w + k] = UNREACHABLE if q1_mp != q1_mp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 22, 16, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [9, 1, 10, 11, 12, 8], [9, 1, 10, 13, 14, 5],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
