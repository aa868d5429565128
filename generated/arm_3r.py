# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 68b97f2e9783ad26
"""arm_3r: Arm with three revolute joints, to its wrist centre.

Inverse kinematics, generated from robots/arm_3r.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/arm_3r.yaml. The formulas and where they come from: arm_3r.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
position T[0:3, 3] counts; other entries are ignored.
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

NAME = "arm_3r"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRR"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = ((-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf))
BRANCHES = ("back-down", "back-up", "front-up", "front-down")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 0.00011499999999999999 [m].
d1 = 0.4  # joint offset 1 [m]
a2 = 0.4  # link length 2 [m]
d4 = 0.35  # z of the tool frame [m]
free_limit1 = 1.15e-12  # a length that fixes no angle [m]
longest3 = 0.5625  # square of the longest reach [m^2]
shortest3 = 0.0025000000000000044  # square of the shortest reach [m^2]
longest3_reach = 0.5625000000001725  # the longest, with what rounding adds [m^2]
shortest3_reach = 0.0024999999999885045  # the shortest, with what rounding adds [m^2]
longest3_apart = 0.5624999999999827  # the longest, where branches merge [m^2]
shortest3_apart = 0.002500000000001154  # the shortest, where branches merge [m^2]
k1 = 0.27999999999999997  # 2 * d4 * a2 [m^2]
k2 = 0.28250000000000003  # a2^2 + d4^2 [m^2]
k3 = 12.755102040816327  # 1 / (k1^2) [m^-4]
m1 = 1.3224999999999998e-08  # doubt_limit1^2 [m^2]
# 1000 * (longest3 - longest3_apart) * (longest3_apart - shortest3) [m^4]
m3 = 9.698908343125067e-12
m4 = 1.2499999999999998  # d4 * k1 * k3 [m^-1]
m5 = 0.04687500000000003  # a2 - d4 * k1 * k2 * k3 [m]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="none",
    miss_weights=(0.8696, 0.8696, 0.8696, 0.0, 0.0, 0.0), size=1.15, steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.4, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.4, 0.0),
    (0.0, 0.0, 0.0, -1.5707963267948966),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    tool=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.35),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y, v1 = c1 * c2, s1 * c2, c1 * s2
    v2 = s1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    v3, v4, z3_z = v1 * c3 + x2_x * s3, v2 * c3 + x2_y * s3, s2 * s3 - c2 * c3
    T[0, 0], T[0, 1], T[0, 2] = x2_x * c3 - v1 * s3, s1, -v3
    T[0, 3] = x2_x * a2 - v3 * d4
    T[1, 0], T[1, 1], T[1, 2] = x2_y * c3 - v2 * s3, -c1, -v4
    T[1, 3] = x2_y * a2 - v4 * d4
    T[2, 0], T[2, 2], T[2, 3] = -(s2 * c3 + c2 * s3), z3_z, d1 - s2 * a2 + z3_z * d4
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2, s1 * c2
    p2_x, p2_y, p2_z = x2_x * a2, x2_y * a2, d1 - s2 * a2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    J21, v1 = p2_x - (c1 * s2 * c3 + x2_x * s3) * d4, p2_y - (s1 * s2 * c3 + x2_y * s3) * d4
    v2 = p2_z + (s2 * s3 - c2 * c3) * d4
    v3, v4 = v2 - d1, v2 - p2_z
    J[0, 0], J[0, 1], J[0, 2] = -v1, c1 * v3, c1 * v4
    J[1, 0], J[1, 1], J[1, 2] = J21, s1 * v3, s1 * v4
    J[2, 1], J[2, 2] = -(s1 * v1 + c1 * J21), -(s1 * (v1 - p2_y) + c1 * (J21 - p2_x))
    J[3, 1], J[3, 2] = -s1, -s1
    J[4, 1], J[4, 2] = c1, c1
    J[5, 0] = 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    # theta1, type 2: U1[3, 4]
    w1 = math.sqrt(T14 * T14 + T24 * T24)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 8: U1[2, 4] and U1[1, 4]
    Z1_3 = T34 - d1
    v1 = Z1_3 * Z1_3

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

        # theta3
        N3 = v1 + D1 * D1
        K3 = N3 - k2
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        apart3 = shortest3_apart < N3 and N3 < longest3_apart
        if not (shortest3_reach <= N3 and N3 <= longest3_reach):
            continue  # out of reach
        w3 = math.sqrt(D3_squared if apart3 else 0.0)
        v2 = k1 * K3 * k3

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        Y1_2 = a2 + d4 * v2
        v4, v5 = Z1_3 * Y1_2, D1 * Y1_2

        for i2 in range(2):  # +, -
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            c3 = k3 * (k1 * (w3 * e3))
            q3 = _atan2(-v2, c3)

            # theta2
            v3 = d4 * c3
            S2 = D1 * v3 - v4
            v6 = Z1_3 * v3 + v5
            w2 = math.sqrt(S2 * S2 + v6 * v6)
            factor2 = 1.0 / w2
            c2, s2 = -(v6 * factor2), S2 * factor2
            q2 = _atan2(s2, c2)
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
            status[row] = FREE_JOINT if free1 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T14, T24, T34 = kept[3 * w + k], kept[7 * w + k], kept[11 * w + k]

        # theta1, type 2: U1[3, 4]
        v1 = T14 * T14 + T24 * T24
        w1 = math.sqrt(v1)

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        Z1_3 = T34 - d1
        N3 = v1 + Z1_3 * Z1_3
        D3_squared = (longest3 - N3) * (N3 - shortest3)
        w3 = math.sqrt(D3_squared)
        v2 = w3 - w3

        # theta2, type 3: U1[1, 4] and U1[2, 4]
        v3 = m5 + m4 * N3
        v4, v5, v6 = Z1_3 * v3, w3 * (m4 * Z1_3), w3 * (m4 * -Z1_3)
        v7, v8 = w1 * v3, w3 * (m4 * w1)
        v9 = v8 - v4

        # a joint is free, or branches meet
        kept[16 * w + k] = 1.0 if v1 <= m1 or abs(D3_squared) <= m3 else kept[16 * w + k]
        kept[17 * w + k], kept[18 * w + k], turns[0 * w + k] = N3, v2, -T24
        turns[1 * w + k], turns[2 * w + k], turns[3 * w + k] = -(k1 * (N3 - k2)), v9, -(v4 + v8)
        turns[4 * w + k], turns[5 * w + k], turns[8 * w + k] = -(v4 + v8), v9, -T14
        turns[9 * w + k], turns[10 * w + k], turns[11 * w + k] = k1 * w3, -(v5 + v7), -(v6 + v7)
        turns[12 * w + k], turns[13 * w + k] = v7 - v5, v7 - v6
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 6 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(6 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        T24, N3, v2 = kept[7 * w + k], kept[17 * w + k], kept[18 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4, angle5, angle6 = turns[3 * w + k], turns[4 * w + k], turns[5 * w + k]

        # theta3, type 8: U1[2, 4] and U1[1, 4]
        q3_pm = math.copysign(half_turn, -(k1 * (N3 - k2))) - angle2

        # joint values
        q1_pp, q1_mp = angle1 + v2, v2 + (angle1 - math.copysign(half_turn, -T24))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_pp, angle3, angle2
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle4, q3_pm, q1_mp
        rows[6 * w + k], rows[7 * w + k] = angle5, angle6
        rows[8 * w + k] = rows[9 * w + k] = UNREACHABLE if q1_pp != q1_pp else OK
        rows[10 * w + k] = rows[11 * w + k] = UNREACHABLE if q1_mp != q1_mp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 19, 16, [
    [0, 1, 2], [0, 3, 4], [5, 6, 2], [5, 7, 4],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "position", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
