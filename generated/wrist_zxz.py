# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: dd4736fc8f6b852b
"""wrist_zxz: Spherical wrist, axes z, x, z.

Inverse kinematics, generated from robots/wrist_zxz.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/wrist_zxz.yaml. The formulas and where they come from: wrist_zxz.md.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, the
orientation T[0:3, 0:3] counts; other entries are ignored.
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

NAME = "wrist_zxz"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRR"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = ((-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf))
BRANCHES = ("noflip", "flip")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit = 9.999999999999999e-05.
free_limit = 1e-12  # a length that fixes no angle
m1 = 9.999999999999999e-09  # doubt_limit^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="rotation",
    miss_weights=(0.0, 0.0, 0.0, 1.0, 1.0, 1.0), size=1.0, steps=("follows seed",),
))

# The axes at q = 0: a unit vector along each, and a point of it [m].
AXES = (
    (0.0, 0.0, 1.0, 0.0, 0.0, 0.0),
    (1.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 1.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=AXES, convention="axes",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    y2_x, v1 = s1 * c2, c1 * c2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    T[0, 0], T[0, 1], T[0, 2] = c1 * c3 - y2_x * s3, -(y2_x * c3 + c1 * s3), s1 * s2
    T[1, 0], T[1, 1], T[1, 2] = s1 * c3 + v1 * s3, v1 * c3 - s1 * s3, -(c1 * s2)
    T[2, 0], T[2, 1], T[2, 2] = s2 * s3, s2 * c3, c2
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    J[3, 1], J[3, 2] = c1, s1 * s2
    J[4, 1], J[4, 2] = s1, -(c1 * s2)
    J[5, 0], J[5, 2] = 1.0, c2
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, _, T21, T22, T23, _, _, _, T33, _ = pose

    # theta1, type 2: U1[1, 3]
    w1 = math.sqrt(T23 * T23 + T13 * T13)
    free1 = w1 <= free_limit
    divisor1 = 1.0 if free1 else w1

    for i1 in range(2):  # noflip, flip
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else T23 * factor1
        s1 = math.sin(seed[0]) if free1 else -(T13 * factor1)
        q1 = _atan2(s1, c1)

        # theta2, type 3: U1[3, 3] and U1[2, 3]
        q2 = _atan2(-(w1 * e1), T33)

        # theta3, type 3: U1[1, 2] and U1[1, 1]
        c3 = T11 * c1 + T21 * s1
        q3 = _atan2(-(T12 * c1 + T22 * s1), c3)
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
        T21, T22, T23 = kept[4 * w + k], kept[5 * w + k], kept[6 * w + k]
        T33 = kept[10 * w + k]

        # theta1, type 2: U1[1, 3]
        v1 = T23 * T23 + T13 * T13

        # theta3, type 3: U1[1, 2] and U1[1, 1]
        v2 = T13 * T22 - T23 * T12

        # a joint is free, or branches meet
        kept[16 * w + k] = 1.0 if v1 <= m1 else kept[16 * w + k]
        kept[17 * w + k], turns[0 * w + k], turns[1 * w + k] = v2, -T13, -math.sqrt(v1)
        turns[2 * w + k], turns[8 * w + k], turns[9 * w + k] = v2, T23, T33
        turns[10 * w + k] = T23 * T11 - T13 * T21
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 3 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(3 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        T13, v2, angle1 = kept[2 * w + k], kept[17 * w + k], turns[0 * w + k]
        angle2, angle3 = turns[1 * w + k], turns[2 * w + k]

        # theta1, type 2: U1[1, 3]
        q1_m = angle1 - math.copysign(half_turn, -T13)

        # theta3, type 3: U1[1, 2] and U1[1, 1]
        q3_m = angle3 - math.copysign(half_turn, v2)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle1, angle2, angle3
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q1_m, -angle2, q3_m
        rows[6 * w + k] = UNREACHABLE if angle1 != angle1 else OK
        rows[7 * w + k] = UNREACHABLE if q1_m != q1_m else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 18, 16, [
    [0, 1, 2], [3, 4, 5],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "orientation", _FORMULAS, counted=(False, False, False),
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
