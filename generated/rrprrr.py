# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: ec7723db4c98fce0
"""rrprrr: RRPRRR arm.

Inverse kinematics, generated from robots/rrprrr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/rrprrr.yaml. The formulas and where they come from: rrprrr.md.

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

NAME = "rrprrr"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "RRPRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = (
    "back-forward-noflip", "back-forward-flip", "back-backward-noflip", "back-backward-flip",
    "front-forward-noflip", "front-forward-flip", "front-backward-noflip", "front-backward-flip",
)
MAX_SOLUTIONS = 8

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 9.999999999999999e-05 [m].
free_limit1 = 1e-12  # a length that fixes no angle [m]
free_limit = 1e-12  # a length that fixes no angle
m1 = 9.999999999999999e-09  # doubt_limit1^2 [m^2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=8, directions="rotation",
    miss_weights=(1.0, 1.0, 1.0, 1.0, 1.0, 1.0), size=1.0, steps=("follows seed",),
))

# The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.0, 1.5707963267948966),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="modified",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, z3_x = c1 * c2, s1 * c2, c1 * s2
    z3_y = s1 * s2
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x2_x * c4 + s1 * s4, x2_y * c4 - c1 * s4, s2 * c4
    y4_x, v1, v2 = s1 * c4 - x2_x * s4, c1 * c4 + x2_y * s4, s2 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    x5_x, x5_y, x5_z = x4_x * c5 - z3_x * s5, x4_y * c5 - z3_y * s5, x4_z * c5 + c2 * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = x5_x * c6 + y4_x * s6, y4_x * c6 - x5_x * s6, z3_x * c5 + x4_x * s5
    T[0, 3] = z3_x * q[2]
    T[1, 0], T[1, 1], T[1, 2] = x5_y * c6 - v1 * s6, -(v1 * c6 + x5_y * s6), z3_y * c5 + x4_y * s5
    T[1, 3] = z3_y * q[2]
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 - v2 * s6, -(v2 * c6 + x5_z * s6), x4_z * s5 - c2 * c5
    T[2, 3] = -(c2 * q[2])
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, z3_x = c1 * c2, s1 * c2, c1 * s2
    z3_y, p3_x = s1 * s2, z3_x * q[2]
    p3_y, v1 = z3_y * q[2], c2 * q[2]
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    J[0, 0], J[0, 1], J[0, 2] = -p3_y, c1 * v1, z3_x
    J[1, 0], J[1, 1], J[1, 2] = p3_x, s1 * v1, z3_y
    J[2, 1], J[2, 2] = s1 * p3_y + c1 * p3_x, -c2
    J[3, 1], J[3, 3], J[3, 4] = s1, z3_x, s1 * c4 - x2_x * s4
    J[3, 5] = z3_x * c5 + (x2_x * c4 + s1 * s4) * s5
    J[4, 1], J[4, 3], J[4, 4] = -c1, z3_y, -(c1 * c4 + x2_y * s4)
    J[4, 5] = z3_y * c5 + (x2_y * c4 - c1 * s4) * s5
    J[5, 0], J[5, 3], J[5, 4] = 1.0, -c2, -(s2 * s4)
    J[5, 5] = s2 * c4 * s5 - c2 * c5
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # theta1, type 2: U1[2, 4]
    w1 = math.sqrt(T14 * T14 + T24 * T24)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta2, r3, type 4: U1[1, 4] and U1[3, 4]
    v1 = T34 * T34

    for i1 in range(2):  # back, front
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else -(T14 * factor1)
        s1 = math.sin(seed[0]) if free1 else -(T24 * factor1)
        q1 = _atan2(s1, c1)
        D1 = w1 * e1

        # theta2, r3
        w3 = math.sqrt(D1 * D1 + v1)
        free2 = w3 <= free_limit1
        divisor2 = 1.0 if free2 else w3

        # theta4, type 2: U4[2, 3]
        v2 = T13 * c1 + T23 * s1
        Y4 = T23 * c1 - T13 * s1
        v3 = Y4 * Y4

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        v4, v5, v7 = T22 * c1 - T12 * s1, T12 * c1 + T22 * s1, T21 * c1 - T11 * s1
        v8 = T11 * c1 + T21 * s1

        for i2 in range(2):  # forward, backward
            e2 = 1.0 - 2.0 * i2
            # theta2, r3
            if e2 < 0.0 and free2:
                continue  # both signs give the same
            factor2 = e2 / divisor2
            c2 = math.cos(seed[1]) if free2 else -(T34 * factor2)
            s2 = math.sin(seed[1]) if free2 else -(D1 * factor2)
            q2 = _atan2(s2, c2)
            r3 = w3 * e2

            # theta4
            X4 = c2 * v2 + T33 * s2
            w4 = math.sqrt(X4 * X4 + v3)
            free4 = w4 <= free_limit
            divisor4 = 1.0 if free4 else w4

            # theta5, type 3: U4[3, 3] and U4[1, 3]
            c5 = s2 * v2 - T33 * c2

            # theta6
            v6, v9 = c2 * v5 + T32 * s2, c2 * v8 + T31 * s2

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
                q6 = _atan2(-(c4 * v7 + s4 * v9), -(c4 * v4 + s4 * v6))
                row = 4 * i1 + 2 * i2 + i3
                q[row, 0], q[row, 1], q[row, 2] = q1, q2, r3
                q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
                status[row] = FREE_JOINT if free1 or free2 or free4 else OK


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
        v1 = T14 * T14 + T24 * T24
        w1 = math.sqrt(v1)
        factor1 = w1 * (1.0 / v1)

        # theta2, r3, type 4: U1[1, 4] and U1[3, 4]
        v2 = v1 + T34 * T34
        q3_ppp = math.sqrt(v2)
        factor2 = q3_ppp * (1.0 / v2)
        v3, v4 = T34 * factor2, w1 * factor2

        # theta4, type 2: U4[2, 3]
        v5 = T14 * T13 + T24 * T23
        X4, Y4 = factor1 * (v3 * v5) - v4 * T33, T24 * T13 - T14 * T23
        v6 = X4 * X4 + factor1 * (Y4 * (factor1 * Y4))
        w4 = math.sqrt(v6)
        factor4 = w4 * (1.0 / v6)
        v7, s4 = X4 * factor4, Y4 * factor4
        v8 = factor1 * s4

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        v9 = (
            v7 * (T24 * T11 - T14 * T21) - s4 * (factor1 * (v3 * (T14 * T11 + T24 * T21)) - v4 *
            T31)
        )

        # a joint is free, or branches meet
        kept[16 * w + k] = 1.0 if v2 <= m1 or v6 <= m1 or v1 <= m1 else kept[16 * w + k]
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = w1, q3_ppp, w4
        kept[20 * w + k], kept[21 * w + k], turns[0 * w + k] = v8, v9, -T24
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = -w1, v8, -w4
        turns[4 * w + k], turns[8 * w + k], turns[9 * w + k] = v9, -T14, -T34
        turns[10 * w + k], turns[11 * w + k] = -v7, v3 * T33 + factor1 * (v4 * v5)
        turns[12 * w + k] = (
            v7 * (T24 * T12 - T14 * T22) - s4 * (factor1 * (v3 * (T14 * T12 + T24 * T22)) - v4 *
            T32)
        )
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 5 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(5 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        T24, w1, q3_ppp = kept[7 * w + k], kept[17 * w + k], kept[18 * w + k]
        w4, v8, v9 = kept[19 * w + k], kept[20 * w + k], kept[21 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5 = turns[3 * w + k], turns[4 * w + k]

        # theta1, type 2: U1[2, 4]
        q1_mpp = angle1 - math.copysign(half_turn, -T24)

        # theta2, r3, type 4: U1[1, 4] and U1[3, 4]
        q2_pmp = angle2 - math.copysign(half_turn, -w1)

        # theta4, type 2: U4[2, 3]
        q4_ppm = angle3 - math.copysign(half_turn, v8)

        # theta5, type 3: U4[3, 3] and U4[1, 3]
        q5_pmp = math.copysign(half_turn, -w4) - angle4

        # theta6, type 3: U4[2, 2] and U4[2, 1]
        q6_ppm = angle5 - math.copysign(half_turn, v9)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle1, angle2, q3_ppp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle3, angle4, angle5
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_ppm, -angle4, q6_ppm
        rows[9 * w + k], rows[10 * w + k], rows[11 * w + k] = q2_pmp, -q3_ppp, -q4_ppm
        rows[12 * w + k], rows[13 * w + k], rows[14 * w + k] = q5_pmp, -angle3, -q5_pmp
        rows[15 * w + k], rows[16 * w + k], rows[17 * w + k] = q1_mpp, -angle2, -q2_pmp
        rows[18 * w + k] = rows[19 * w + k] = UNREACHABLE if angle1 != angle1 else OK
        rows[20 * w + k] = rows[21 * w + k] = UNREACHABLE if angle1 != angle1 else OK
        rows[22 * w + k] = rows[23 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK
        rows[24 * w + k] = rows[25 * w + k] = UNREACHABLE if q1_mpp != q1_mpp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 22, 16, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8], [0, 9, 10, 11, 12, 8], [0, 9, 10, 13, 14, 5],
    [15, 16, 2, 6, 4, 5], [15, 16, 2, 3, 7, 8], [15, 17, 10, 13, 12, 8], [15, 17, 10, 11, 14, 5],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
