# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 2982606682a8b5ef
"""rpr: Arm with a revolute, a prismatic and a revolute joint.

Inverse kinematics, generated from robots/rpr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/rpr.yaml. The formulas and where they come from: rpr.md.

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

NAME = "rpr"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RPR"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = ((-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf))
BRANCHES = ("shoulder+-elbow+", "shoulder+-elbow-", "shoulder--elbow+", "shoulder--elbow-")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit1 = 8e-05 [m].
d1 = 0.5  # joint offset 1 [m]
a3 = 0.3  # link length 3 [m]
free_limit1 = 8e-13  # a length that fixes no angle [m]
reach_slack1 = 8.000000000000001e-14  # rounding at the boundary of the workspace [m]
merge_slack1 = 8e-15  # nearer to that boundary two branches are one [m]
k1 = 0.09  # a3^2 [m^2]
k2 = 11.111111111111112  # 1 / k1 [m^-2]
m1 = 6.400000000000001e-09  # doubt_limit1^2 [m^2]
m3 = 8e-12  # 1000 * merge_slack1 [m]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="none",
    miss_weights=(1.25, 1.25, 1.25, 0.0, 0.0, 0.0), size=0.8, slacks=(1e-09, 8e-10, 1e-09),
    weights=(1.0, 1.5624999999999998, 1.0), paces=(1.0, 0.8, 1.0), steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.5, 0.0, -1.5707963267948966),
    (1.5707963267948966, 0.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.3, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    v1, x3_y = s1 * s3, c1 * s3
    T[0, 0], T[0, 1], T[0, 2] = -v1, -(s1 * c3), c1
    T[0, 3] = -(s1 * q[1] + v1 * a3)
    T[1, 0], T[1, 1], T[1, 2] = x3_y, c1 * c3, s1
    T[1, 3] = c1 * q[1] + x3_y * a3
    T[2, 0], T[2, 1], T[2, 3] = -c3, s3, d1 - c3 * a3
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    v1, p2_y = s1 * q[1], c1 * q[1]
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    v2, p3_y, v3 = v1 + s1 * s3 * a3, p2_y + c1 * s3 * a3, d1 - c3 * a3 - d1
    J[0, 0], J[0, 1], J[0, 2] = -p3_y, -s1, s1 * v3
    J[1, 0], J[1, 1], J[1, 2] = -v2, c1, -(c1 * v3)
    J[2, 2] = c1 * (p3_y - p2_y) - s1 * (v1 - v2)
    J[3, 2] = c1
    J[4, 2] = s1
    J[5, 0] = 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    # theta1, type 2: U1[1, 4]
    w1 = math.sqrt(T24 * T24 + T14 * T14)
    free1 = w1 <= free_limit1
    divisor1 = 1.0 if free1 else w1

    # theta3, type 2: U0[3, 4]
    Z3 = T34 - d1
    D3_squared = k1 - Z3 * Z3
    v1 = 2.0 * abs(Z3)
    apart3 = merge_slack1 * (v1 + merge_slack1) < D3_squared
    if not (-(reach_slack1 * (v1 + reach_slack1)) < D3_squared):
        return  # out of reach
    w3 = math.sqrt(D3_squared if apart3 else 0.0)

    for i1 in range(2):  # shoulder+, shoulder-
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and free1:
            continue  # both signs give the same
        factor1 = e1 / divisor1
        c1 = math.cos(seed[0]) if free1 else T24 * factor1
        s1 = math.sin(seed[0]) if free1 else -(T14 * factor1)
        q1 = _atan2(s1, c1)
        D1 = w1 * e1

        for i2 in range(2):  # elbow+, elbow-
            e3 = 1.0 - 2.0 * i2
            # theta3
            if e3 < 0.0 and not apart3:
                continue  # both signs give the same
            v2 = k2 * (a3 * (w3 * e3))
            q3 = _atan2(-v2, -(k2 * (a3 * Z3)))

            # r2, type 1: U1[3, 4]
            v3 = a3 * v2
            r2 = D1 + v3
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, r2, q3
            status[row] = FREE_JOINT if free1 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T14, T24, T34 = kept[3 * w + k], kept[7 * w + k], kept[11 * w + k]

        # theta1, type 2: U1[1, 4]
        v1 = T24 * T24 + T14 * T14
        w1 = math.sqrt(v1)

        # theta3, type 2: U0[3, 4]
        Z3 = T34 - d1
        D3_squared = k1 - Z3 * Z3
        w3 = math.sqrt(D3_squared)
        v2 = w3 - w3

        # r2, type 1: U1[3, 4]
        q2_pp, q2_pm = w1 + w3, w1 - w3

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v1 <= m1 or abs(D3_squared) <= m3 * (merge_slack1 + 2.0 * abs(Z3)) else kept[16 *
            w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = v2, q2_pp, q2_pm
        turns[0 * w + k], turns[1 * w + k], turns[8 * w + k] = -T14, -(a3 * w3), T24
        turns[9 * w + k] = -(a3 * Z3)
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 2 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(2 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        T14, v2, q2_pp = kept[3 * w + k], kept[17 * w + k], kept[18 * w + k]
        q2_pm, angle1, angle2 = kept[19 * w + k], turns[0 * w + k], turns[1 * w + k]

        # joint values
        q1_pp, q1_mp = angle1 + v2, v2 + (angle1 - math.copysign(half_turn, -T14))

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_pp, q2_pp, angle2
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q2_pm, -angle2, q1_mp
        rows[6 * w + k], rows[7 * w + k] = -q2_pm, -q2_pp
        rows[8 * w + k] = rows[9 * w + k] = UNREACHABLE if q1_pp != q1_pp else OK
        rows[10 * w + k] = rows[11 * w + k] = UNREACHABLE if q1_mp != q1_mp else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 20, 16, [
    [0, 1, 2], [0, 3, 4], [5, 6, 2], [5, 7, 4],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "position", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
