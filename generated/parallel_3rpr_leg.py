# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 07c20b2bc6956a7a
"""parallel_3rpr_leg: Planar platform on three cylinders (3-RPR): a leg.

Inverse kinematics, generated from robots/parallel_3rpr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/parallel_3rpr.yaml. The formulas and where they come from:
parallel_3rpr_leg.md, of a leg of parallel_3rpr.

Poses are 4 x 4 matrices of the tool in the base frame, lengths in m, angles in rad. Of a pose, x =
T[0, 3] and y = T[1, 3] counts; other entries are ignored.
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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 2), _runtime("arrays").zeros

NAME = "parallel_3rpr_leg"
METHOD = "closed form"
DOF = 2
JOINT_TYPES = "RP"
JOINT_NAMES = ("joint1", "joint2")
JOINT_LIMITS = ((-math.inf, math.inf), (0.3, 1.6))
BRANCHES = ("forward", "backward")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 0.00016 [m].
free_limit1 = 1.6e-12  # a length that fixes no angle [m]
low2 = 0.29999999839999997  # lowest value of joint 2, with what rounding adds [m]
high2 = 1.6000000016  # highest value of joint 2, with what rounding adds [m]
per_size = 0.625  # slides beyond limits count in the arm's size [m^-1]
limit_slack = 5e-07  # half of what rounding may take a joint beyond its limit
m1 = 2.5600000000000004e-08  # doubt_limit1^2 [m^2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="none",
    miss_weights=(0.625, 0.625, 0.0, 0.0, 0.0, 0.0), size=1.6, slacks=(1e-09, 1.6e-09),
    weights=(1.0, 0.39062499999999994), paces=(1.0, 1.6), fan_steps=(0.09817477042468103, 0.040625),
    steps=("keeps limits", "clamps", "clamps far", "follows seed"), choosable=(0,),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (2,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    T[0, 0], T[0, 2], T[0, 3] = c1, s1, s1 * q[1]
    T[1, 0], T[1, 2], T[1, 3] = s1, -c1, -(c1 * q[1])
    T[2, 1] = 1.0
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 2): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 2)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    J[0, 0], J[0, 1] = c1 * q[1], s1
    J[1, 0], J[1, 1] = s1 * q[1], -c1
    J[5, 0] = 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, _ = pose

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
        c1 = math.cos(seed[0]) if free1 else -(T24 * factor1)
        s1 = math.sin(seed[0]) if free1 else T14 * factor1
        q1 = _atan2(s1, c1)
        r2 = w2 * e1
        row = i1
        q[row, 0], q[row, 1] = q1, r2
        status[row] = FREE_JOINT if free1 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T14, T24 = kept[3 * w + k], kept[7 * w + k]

        # theta1, r2, type 4: U0[1, 4] and U0[2, 4]
        v1 = T14 * T14 + T24 * T24
        q2_p = math.sqrt(v1)

        # joint values
        excess_p = per_size * max(low2 - q2_p, q2_p - high2)
        excess_m, outside_p = per_size * max(low2 + q2_p, -(high2 + q2_p)), 0.0 < excess_p
        outside_m = 0.0 < excess_m

        # a joint is free, branches meet, or rounding decides what is beyond a limit
        kept[16 * w + k] = 1.0 if v1 <= m1 else kept[16 * w + k]
        kept[16 * w + k] = (
            1.0 if abs(excess_p - limit_slack) <= limit_slack or abs(excess_m - limit_slack) <=
            limit_slack else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = q2_p, outside_p, outside_m
        turns[0 * w + k], turns[1 * w + k] = T14, -T24
    if w == 1 and kept[16] != 0.0:
        return
    for k in range(0 * w, 1 * w):
        turns[k] = _atan2(turns[k], turns[k + 1 * w])
    for k in range(w):
        T14, q2_p, outside_p = kept[3 * w + k], kept[17 * w + k], kept[18 * w + k] != 0.0
        outside_m, angle1 = kept[19 * w + k] != 0.0, turns[0 * w + k]

        # theta1, r2, type 4: U0[1, 4] and U0[2, 4]
        q1_m = angle1 - math.copysign(half_turn, T14)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle1, q2_p, q1_m
        rows[3 * w + k] = -q2_p
        rows[4 * w + k] = UNREACHABLE if angle1 != angle1 else (OUT_OF_LIMITS if outside_p else OK)
        rows[5 * w + k] = UNREACHABLE if q1_m != q1_m else (OUT_OF_LIMITS if outside_m else OK)


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 20, 2, [
    [0, 1], [2, 3],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "position", _FORMULAS, counted=(True, True, False),
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
