# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 72e6a2adb561ce87
"""rpp: Cylindrical arm.

Inverse kinematics, generated from robots/rpp.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/rpp.yaml. The formulas and where they come from: rpp.md.

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

NAME = "rpp"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RPP"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = ((-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf))
BRANCHES = ("forward", "backward")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 4.9999999999999996e-05 [m].
d1 = 0.5  # joint offset 1 [m]
free_limit1 = 5e-13  # a length that fixes no angle [m]
m1 = 2.4999999999999996e-09  # doubt_limit1^2 [m^2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="none",
    miss_weights=(2.0, 2.0, 2.0, 0.0, 0.0, 0.0), size=0.5, slacks=(1e-09, 5e-10, 5e-10),
    weights=(1.0, 4.0, 4.0), paces=(1.0, 0.5, 0.5), steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.5, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.0, 1.5707963267948966),
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
    T[0, 0], T[0, 1], T[0, 3] = c1, -s1, -(s1 * q[1])
    T[1, 0], T[1, 1], T[1, 3] = s1, c1, c1 * q[1]
    T[2, 2], T[2, 3] = 1.0, d1 + q[2]
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    J[0, 0], J[0, 1] = -(c1 * q[1]), -s1
    J[1, 0], J[1, 1] = -(s1 * q[1]), c1
    J[2, 2] = 1.0
    J[5, 0] = 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    # r3, type 1: U0[3, 4]
    r3 = T34 - d1

    # theta1, r2, type 4: U0[1, 4] and U0[2, 4]
    w2 = math.sqrt(T14 * T14 + T24 * T24)
    free1 = w2 <= free_limit1
    divisor1 = 1.0 if free1 else w2

    for i1 in range(2):  # forward, backward
        e1 = 1.0 - 2.0 * i1
        # theta1, r2
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else T24 * factor1
        s1 = math.sin(seed[0]) if free1 else -(T14 * factor1)
        q1 = _atan2(s1, c1)
        r2 = w2 * e1
        row = i1
        q[row, 0], q[row, 1], q[row, 2] = q1, r2, r3
        status[row] = FREE_JOINT if free1 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T14, T24, T34 = kept[3 * w + k], kept[7 * w + k], kept[11 * w + k]

        # r3, type 1: U0[3, 4]
        q3_p = T34 - d1

        # theta1, r2, type 4: U0[1, 4] and U0[2, 4]
        v1 = T14 * T14 + T24 * T24
        q2_p = math.sqrt(v1)

        # a joint is free, or branches meet
        kept[16 * w + k] = 1.0 if v1 <= m1 else kept[16 * w + k]
        kept[17 * w + k], kept[18 * w + k], turns[0 * w + k] = q3_p, q2_p, -T14
        turns[1 * w + k] = T24
    if w == 1 and kept[16] != 0.0:
        return
    for k in range(0 * w, 1 * w):
        turns[k] = _atan2(turns[k], turns[k + 1 * w])
    for k in range(w):
        T14, q3_p, q2_p = kept[3 * w + k], kept[17 * w + k], kept[18 * w + k]
        angle1 = turns[0 * w + k]

        # theta1, r2, type 4: U0[1, 4] and U0[2, 4]
        q1_m = angle1 - math.copysign(half_turn, -T14)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle1, q2_p, q3_p
        rows[3 * w + k], rows[4 * w + k] = q1_m, -q2_p
        rows[5 * w + k] = UNREACHABLE if angle1 != angle1 else OK
        rows[6 * w + k] = UNREACHABLE if q1_m != q1_m else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 19, 2, [
    [0, 1, 2], [3, 4, 2],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "position", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
