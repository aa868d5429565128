# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: ab976a3980df600e
"""adept: Adept SCARA.

Inverse kinematics, generated from robots/adept.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/adept.yaml. The formulas and where they come from: adept.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in mm, angles in rad. Every entry of
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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 3), _runtime("arrays").zeros

NAME = "adept"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRP"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = ((-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf))
BRANCHES = ("only",)
MAX_SOLUTIONS = 1

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit2 = 576.0 [mm^2].
d1 = 1075.0  # joint offset 1 [mm]
l1 = 600.0  # link length 1 [mm]
l2 = 550.0  # link length 2 [mm]
zz = 500.0  # z of the base frame [mm]
ez = 175.0  # z of the tool frame [mm]
free_limit = 1e-12  # a length that fixes no angle
free_limit2 = 5.76e-06  # a length that fixes no angle [mm^2]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 0.024  # a pose may be rounded by this [mm]
m1 = 330000.0  # l1 * l2 [mm^2]
m2 = 600.0  # l1 [mm]
m3 = 331776.0  # doubt_limit2^2 [mm^4]
m4 = 0.000576  # pose_slack1^2 [mm^2]
m5 = 1.0000000000000002e-10  # pose_slack^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=1, directions="rotation",
    miss_weights=(0.0004167, 0.0004167, 0.0004167, 1.0, 1.0, 1.0), size=2400.0,
    slacks=(1e-09, 1e-09, 2.4e-06), weights=(1.0, 1.0, 1.7361111111111112e-07),
    paces=(1.0, 1.0, 2400.0), steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [mm], a [mm], alpha [rad].
TABLE = (
    (0.0, 1075.0, 600.0, 0.0),
    (0.0, 0.0, 550.0, 3.141592653589793),
    (0.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    base=(0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 500.0),
    tool=(0.0, 1.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 175.0),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_y, x2_z = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    T[0, 2], T[0, 3] = -1.0, d1 - q[2] - ez
    T[1, 0], T[1, 1], T[1, 3] = -x2_z, x2_y, c1 * l1 + x2_y * l2
    T[2, 0], T[2, 1], T[2, 3] = x2_y, x2_z, zz + s1 * l1 + x2_z * l2
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_y, p1_z = c1 * l1, zz + s1 * l1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    p2_y, p2_z = p1_y + (c1 * c2 - s1 * s2) * l2, p1_z + (s1 * c2 + c1 * s2) * l2
    J[0, 2] = -1.0
    J[1, 0], J[1, 1] = zz - p2_z, p1_z - p2_z
    J[2, 0], J[2, 1] = p2_y, p2_y - p1_y
    J[3, 0], J[3, 1] = 1.0, 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, T12, T13, T14, _, T22, T23, T24, _, T32, T33, T34 = pose

    # r3, type 1: U0[3, 4]
    t34 = T14 - ez * T13
    r3 = d1 - t34

    # theta12, type 3: U0[2, 1] and U0[1, 1]
    w12 = math.sqrt(T32 * T32 + T22 * T22)
    short12 = w12 <= free_limit
    v1 = 1.0 / (1.0 if short12 else w12)
    c12, s12 = T22 * v1, T32 * v1

    # theta1, type 3: U0[1, 4] and U0[2, 4]
    t14 = T24 - ez * T23
    v2 = c12 * l2
    t24 = T34 - ez * T33 - zz
    v3 = s12 * l2
    v4, v5 = l1 * (t24 - v3), l1 * (t14 - v2)
    w1 = math.sqrt(v4 * v4 + v5 * v5)
    short1 = w1 <= free_limit2
    v6 = 1.0 / (1.0 if short1 else w1)
    c1, s1 = v5 * v6, v4 * v6
    q1 = _atan2(s1, c1)

    # is the pose one that the arm can take?
    if (
        not (abs(t34 - (d1 - r3)) <= pose_slack1 and abs(1.0 + T13) <= pose_slack and abs(T12) <=
        pose_slack and abs(t24 - (v3 + l1 * s1)) <= pose_slack1 and abs(T33) <= pose_slack and
        abs(T32 - s12) <= pose_slack and abs(t14 - (v2 + l1 * c1)) <= pose_slack1 and abs(T22 - c12)
        <= pose_slack and abs(T23) <= pose_slack)
    ):
        return  # the arm can't take this pose

    # joint values
    q2 = _wrap(_atan2(s12, c12) - q1)
    row = 0
    q[row, 0], q[row, 1], q[row, 2] = q1, q2, r3
    status[row] = OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T12, T13, T14 = kept[1 * w + k], kept[2 * w + k], kept[3 * w + k]
        T22, T23, T24 = kept[5 * w + k], kept[6 * w + k], kept[7 * w + k]
        T32, T33, T34 = kept[9 * w + k], kept[10 * w + k], kept[11 * w + k]

        # r3, type 1: U0[3, 4]
        t34 = T14 - ez * T13
        q3 = d1 - t34

        # theta12, type 3: U0[2, 1] and U0[1, 1]
        v1 = T32 * T32 + T22 * T22
        w12, v2 = math.sqrt(v1), 1.0 / v1
        v3 = w12 * v2

        # theta1, type 3: U0[1, 4] and U0[2, 4]
        t14, t24 = T24 - ez * T23, T34 - ez * T33 - zz
        v4, v5 = m2 * t24 - w12 * (m1 * (T32 * v2)), m2 * t14 - w12 * (m1 * (T22 * v2))
        v6 = v4 * v4 + v5 * v5
        v7 = math.sqrt(v6) * (1.0 / v6)

        # is the pose one that the arm can take?
        v8, v9, v10 = t34 - (d1 - q3), T13 + 1.0, t24 - (l2 * (T32 * v3) + l1 * (v4 * v7))
        v11, v12 = t14 - (l2 * (T22 * v3) + l1 * (v5 * v7)), v1 - 1.0

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if m4 < v8 * v8 + v10 * v10 + v11 * v11 or m5 < v9 * v9 + T12 * T12 + T33 * T33 +
            T23 * T23 + v12 * v12 or v6 <= m3 else kept[16 * w + k]
        )
        kept[17 * w + k], turns[0 * w + k], turns[1 * w + k] = q3, v4, T32
        turns[8 * w + k], turns[9 * w + k] = v5, T22
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 2 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(2 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        q3, angle1, angle2 = kept[17 * w + k], turns[0 * w + k], turns[1 * w + k]

        # joint values
        v13 = angle2 - angle1
        q2 = v13 + (turn if v13 <= -half_turn else (-turn if half_turn < v13 else 0.0))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle1, q2, q3
        rows[3 * w + k] = UNREACHABLE if angle1 != angle1 else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 18, 16, [
    [0, 1, 2],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
