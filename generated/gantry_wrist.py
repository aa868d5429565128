# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 1ede0a2831d661a5
"""gantry_wrist: Gantry with a spherical wrist.

Inverse kinematics, generated from robots/gantry_wrist.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/gantry_wrist.yaml. The formulas and where they come from:
gantry_wrist.md.

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

NAME = "gantry_wrist"
METHOD = "closed form"
DOF = 6
JOINT_TYPES = "PPPRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5", "joint6")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf), (-math.inf, math.inf),
)
BRANCHES = ("noflip", "flip")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit = 9.999999999999999e-05.
d4 = 0.1  # joint offset 4 [m]
d6 = 0.12  # joint offset 6 [m]
free_limit = 1e-12  # a length that fixes no angle
m1 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="rotation",
    miss_weights=(4.545, 4.545, 4.545, 1.0, 1.0, 1.0), size=0.22,
    slacks=(2.2e-10, 2.2e-10, 2.2e-10, 1e-09, 1e-09, 1e-09),
    weights=(20.66115702479339, 20.66115702479339, 20.66115702479339, 1.0, 1.0, 1.0),
    paces=(0.22, 0.22, 0.22, 1.0, 1.0, 1.0), steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (-1.5707963267948966, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 0.1, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.12, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (6,)."""
    T = _zeros(4, 4)
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    v1, x5_z, v2 = s4 * c5, c4 * c5, s4 * s5
    z5_z = c4 * s5
    c6, s6 = math.cos(q[5]), math.sin(q[5])
    T[0, 0], T[0, 1], T[0, 2] = -(s5 * c6), s5 * s6, c5
    T[0, 3] = q[2] + d4 + c5 * d6
    T[1, 0], T[1, 1], T[1, 2] = -(v1 * c6 + c4 * s6), v1 * s6 - c4 * c6, -v2
    T[1, 3] = q[1] - v2 * d6
    T[2, 0], T[2, 1], T[2, 2] = x5_z * c6 - s4 * s6, -(s4 * c6 + x5_z * s6), z5_z
    T[2, 3] = q[0] + z5_z * d6
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 6)
    c4, s4, p4_x = math.cos(q[3]), math.sin(q[3]), q[2] + d4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    v1, z5_z = s4 * s5, c4 * s5
    J34, v2, v3 = q[1] - v1 * d6 - q[1], q[0] + z5_z * d6 - q[0], p4_x + c5 * d6 - p4_x
    J[0, 2], J[0, 4], J[0, 5] = 1.0, s4 * J34 - c4 * v2, -(v1 * v2 + z5_z * J34)
    J[1, 1], J[1, 3], J[1, 4] = 1.0, -v2, -(s4 * v3)
    J[1, 5] = z5_z * v3 - c5 * v2
    J[2, 0], J[2, 3], J[2, 4] = 1.0, J34, c4 * v3
    J[2, 5] = c5 * J34 + v1 * v3
    J[3, 3], J[3, 5] = 1.0, c5
    J[4, 4], J[4, 5] = -c4, -v1
    J[5, 4], J[5, 5] = -s4, z5_z
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # r2, type 1: U0 A6^-1 [2, 4]
    wy = T24 - T23 * d6

    # r1, type 1: U0 A6^-1 [3, 4]
    wz = T34 - d6 * T33

    # r3, type 1: U0 A6^-1 [1, 4]
    wx = T14 - d6 * T13
    r3 = wx - d4

    # theta4, type 2: U4[3, 3]
    w4 = math.sqrt(T33 * T33 + T23 * T23)
    free4 = w4 <= free_limit
    divisor4 = 1.0 if free4 else w4

    for i1 in range(2):  # noflip, flip
        e4 = 1.0 - 2.0 * i1
        # theta4
        if e4 < 0.0 and free4:
            continue  # both signs give the same
        factor4 = e4 / divisor4
        c4 = math.cos(seed[3]) if free4 else -(T33 * factor4)
        s4 = math.sin(seed[3]) if free4 else T23 * factor4
        q4 = _atan2(s4, c4)

        # theta5, type 3: U4[2, 3] and U4[1, 3]
        q5 = _atan2(-(w4 * e4), T13)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6 = _atan2(-(T21 * c4 + T31 * s4), -(T22 * c4 + T32 * s4))
        row = i1
        q[row, 0], q[row, 1], q[row, 2] = wz, wy, r3
        q[row, 3], q[row, 4], q[row, 5] = q4, q5, q6
        status[row] = FREE_JOINT if free4 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T13, T14, T21 = kept[2 * w + k], kept[3 * w + k], kept[4 * w + k]
        T22, T23, T24 = kept[5 * w + k], kept[6 * w + k], kept[7 * w + k]
        T31, T32, T33 = kept[8 * w + k], kept[9 * w + k], kept[10 * w + k]
        T34 = kept[11 * w + k]

        # r2, type 1: U0 A6^-1 [2, 4]
        q2_p = T24 - d6 * T23

        # r1, type 1: U0 A6^-1 [3, 4]
        q1_p = T34 - d6 * T33

        # r3, type 1: U0 A6^-1 [1, 4]
        q3_p = T14 - d6 * T13 - d4

        # theta4, type 2: U4[3, 3]
        v1 = T33 * T33 + T23 * T23

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        v2 = T33 * T21 - T23 * T31

        # a joint is free, or branches meet
        kept[16 * w + k] = 1.0 if v1 <= m1 else kept[16 * w + k]
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = q2_p, q1_p, q3_p
        kept[20 * w + k], turns[0 * w + k], turns[1 * w + k] = v2, T23, -math.sqrt(v1)
        turns[2 * w + k], turns[8 * w + k], turns[9 * w + k] = v2, -T33, T13
        turns[10 * w + k] = T33 * T22 - T23 * T32
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 3 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(3 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        T23, q2_p, q1_p = kept[6 * w + k], kept[17 * w + k], kept[18 * w + k]
        q3_p, v2, angle1 = kept[19 * w + k], kept[20 * w + k], turns[0 * w + k]
        angle2, angle3 = turns[1 * w + k], turns[2 * w + k]

        # theta4, type 2: U4[3, 3]
        q4_m = angle1 - math.copysign(half_turn, T23)

        # theta6, type 3: U4[3, 2] and U4[3, 1]
        q6_m = angle3 - math.copysign(half_turn, v2)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_p, q2_p, q3_p
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle1, angle2, angle3
        rows[6 * w + k], rows[7 * w + k], rows[8 * w + k] = q4_m, -angle2, q6_m
        rows[9 * w + k] = rows[10 * w + k] = UNREACHABLE if q1_p != q1_p else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 21, 16, [
    [0, 1, 2, 3, 4, 5], [0, 1, 2, 6, 7, 8],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
