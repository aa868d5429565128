# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 97ba4b4fa6b0ae87
"""cylindrical: Cylindrical arm, vertical slide first.

Inverse kinematics, generated from robots/cylindrical.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/cylindrical.yaml. The formulas and where they come from:
cylindrical.md.

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

NAME = "cylindrical"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RPP"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = ((-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf))
BRANCHES = ("only",)
MAX_SOLUTIONS = 1

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

d1 = 0.3  # joint offset 1 [m]
free_limit = 1e-12  # a length that fixes no angle
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 3e-06  # a pose may be rounded by this [m]
m1 = 9.000000000000001e-12  # pose_slack1^2 [m^2]
m2 = 1.0000000000000002e-10  # pose_slack^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=1, directions="rotation",
    miss_weights=(3.333, 3.333, 3.333, 1.0, 1.0, 1.0), size=0.3, slacks=(1e-09, 3e-10, 3e-10),
    weights=(1.0, 11.11111111111111, 11.11111111111111), paces=(1.0, 0.3, 0.3),
    steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.3, 0.0, 0.0),
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    T[0, 0], T[0, 2], T[0, 3] = c1, -s1, -(s1 * q[2])
    T[1, 0], T[1, 2], T[1, 3] = s1, c1, c1 * q[2]
    T[2, 1], T[2, 3] = -1.0, d1 + q[1]
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    J[0, 0], J[0, 2] = -(c1 * q[2]), -s1
    J[1, 0], J[1, 2] = -(s1 * q[2]), c1
    J[2, 1] = 1.0
    J[5, 0] = 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, _, T13, T14, T21, _, T23, T24, T31, _, T33, T34 = pose

    # r2, type 1: U0[3, 4]
    r2 = T34 - d1

    # theta1, type 3: U0[2, 1] and U0[1, 1]
    w1 = math.sqrt(T21 * T21 + T11 * T11)
    short1 = w1 <= free_limit
    v1 = 1.0 / (1.0 if short1 else w1)
    c1, s1 = T11 * v1, T21 * v1
    q1 = _atan2(s1, c1)

    # r3, type 1: U1[2, 4]
    r3 = c1 * T24 - s1 * T14

    # is the pose one that the arm can take?
    if (
        not (abs(T34 - (d1 + r2)) <= pose_slack1 and abs(T33) <= pose_slack and abs(T31) <=
        pose_slack and abs(T24 - c1 * r3) <= pose_slack1 and abs(T23 - c1) <= pose_slack and abs(T21
        - s1) <= pose_slack and abs(T14 + s1 * r3) <= pose_slack1 and abs(T11 - c1) <= pose_slack
        and abs(T13 + s1) <= pose_slack)
    ):
        return  # the arm can't take this pose
    row = 0
    q[row, 0], q[row, 1], q[row, 2] = q1, r2, r3
    status[row] = OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T11, T13, T14 = kept[0 * w + k], kept[2 * w + k], kept[3 * w + k]
        T21, T23, T24 = kept[4 * w + k], kept[6 * w + k], kept[7 * w + k]
        T31, T33, T34 = kept[8 * w + k], kept[10 * w + k], kept[11 * w + k]

        # r2, type 1: U0[3, 4]
        q2 = T34 - d1

        # theta1, type 3: U0[2, 1] and U0[1, 1]
        v1 = T21 * T21 + T11 * T11
        w1, v2 = math.sqrt(v1), 1.0 / v1
        v3 = w1 * v2
        c1, s1 = T11 * v3, T21 * v3

        # r3, type 1: U1[2, 4]
        q3 = w1 * (v2 * (T11 * T24 - T21 * T14))

        # is the pose one that the arm can take?
        v4, v5, v6 = T34 - (d1 + q2), T24 - c1 * q3, T23 - c1
        v7, v8, v9 = T14 + s1 * q3, s1 + T13, v1 - 1.0

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if m1 < v4 * v4 + v5 * v5 + v7 * v7 or m2 < T33 * T33 + T31 * T31 + v6 * v6 + v8 *
            v8 + v9 * v9 else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], turns[0 * w + k] = q2, q3, T21
        turns[1 * w + k] = T11
    if w == 1 and kept[16] != 0.0:
        return
    for k in range(0 * w, 1 * w):
        turns[k] = _atan2(turns[k], turns[k + 1 * w])
    for k in range(w):
        q2, q3, angle1 = kept[17 * w + k], kept[18 * w + k], turns[0 * w + k]

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle1, q2, q3
        rows[3 * w + k] = UNREACHABLE if angle1 != angle1 else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 19, 2, [
    [0, 1, 2],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
