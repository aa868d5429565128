# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 31de25d5e88e2e17
"""spherical_offset: Spherical arm with a shoulder offset.

Inverse kinematics, generated from robots/spherical_offset.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/spherical_offset.yaml. The formulas and where they come from:
spherical_offset.md.

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

NAME = "spherical_offset"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "RRP"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = ((-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf))
BRANCHES = ("right-forward", "right-backward", "left-forward", "left-backward")
MAX_SOLUTIONS = 4

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, reach_slack1 = 1.5e-14 [m], merge_slack1 = 1.5e-15 [m],
# doubt_limit1 = 1.4999999999999999e-05 [m].
d2 = 0.15  # joint offset 2 [m]
free_limit1 = 1.5e-13  # a length that fixes no angle [m]
k1 = 0.0225  # d2^2 [m^2]
k2 = 4.5000000000002246e-15  # reach_slack1 * (2 * d2 + reach_slack1) [m^2]
k3 = 4.500000000000022e-16  # merge_slack1 * (2 * d2 + merge_slack1) [m^2]
m1 = 4.5000000000000217e-13  # 1000 * k3 [m^2]
m2 = 2.2499999999999997e-10  # doubt_limit1^2 [m^2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=4, directions="none",
    miss_weights=(6.667, 6.667, 6.667, 0.0, 0.0, 0.0), size=0.15, slacks=(1e-09, 1e-09, 1.5e-10),
    weights=(1.0, 1.0, 44.44444444444444), paces=(1.0, 1.0, 0.15), steps=("follows seed",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.15, 0.0, 1.5707963267948966),
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
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    z2_x, z2_y = c1 * s2, s1 * s2
    T[0, 0], T[0, 1], T[0, 2] = c1 * c2, -s1, z2_x
    T[0, 3] = z2_x * q[2] - s1 * d2
    T[1, 0], T[1, 1], T[1, 2] = s1 * c2, c1, z2_y
    T[1, 3] = c1 * d2 + z2_y * q[2]
    T[2, 0], T[2, 2], T[2, 3] = -s2, c2, c2 * q[2]
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    z2_x, z2_y = c1 * s2, s1 * s2
    p3_x, p3_y, p3_z = z2_x * q[2] - s1 * d2, c1 * d2 + z2_y * q[2], c2 * q[2]
    J[0, 0], J[0, 1], J[0, 2] = -p3_y, c1 * p3_z, z2_x
    J[1, 0], J[1, 1], J[1, 2] = p3_x, s1 * p3_z, z2_y
    J[2, 1], J[2, 2] = -(s1 * p3_y + c1 * p3_x), c2
    J[3, 1] = -s1
    J[4, 1] = c1
    J[5, 0] = 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    # theta1, type 2: U1[3, 4]
    N1 = T14 * T14 + T24 * T24
    D1_squared = N1 - k1
    apart1 = k3 < D1_squared
    if not (-k2 <= D1_squared):
        return  # out of reach
    w1 = math.sqrt(D1_squared if apart1 else 0.0)
    inverse1 = 1.0 / (N1 if apart1 else d2 * math.sqrt(N1))
    v1, v2 = T14 * d2, T24 * d2

    # theta2, r3, type 4: U1[1, 4] and U1[2, 4]
    v3 = T34 * T34

    for i1 in range(2):  # right, left
        e1 = 1.0 - 2.0 * i1
        # theta1
        if e1 < 0.0 and not apart1:
            continue  # both signs give the same
        D1 = w1 * e1
        c1, s1 = inverse1 * (v2 - T14 * D1), -(inverse1 * (v1 + T24 * D1))
        q1 = _atan2(s1, c1)

        # theta2, r3
        w3 = math.sqrt(D1 * D1 + v3)
        free2 = w3 <= free_limit1
        divisor2 = 1.0 if free2 else w3

        for i2 in range(2):  # forward, backward
            e2 = 1.0 - 2.0 * i2
            # theta2, r3
            if e2 < 0.0 and free2:
                continue  # both signs give the same
            factor2 = e2 / divisor2
            c2 = math.cos(seed[1]) if free2 else T34 * factor2
            s2 = math.sin(seed[1]) if free2 else -(D1 * factor2)
            q2 = _atan2(s2, c2)
            r3 = w3 * e2
            row = 2 * i1 + i2
            q[row, 0], q[row, 1], q[row, 2] = q1, q2, r3
            status[row] = FREE_JOINT if free2 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T14, T24, T34 = kept[3 * w + k], kept[7 * w + k], kept[11 * w + k]

        # theta1, type 2: U1[3, 4]
        D1_squared = T14 * T14 + T24 * T24 - k1
        w1 = math.sqrt(D1_squared)
        v1, v2, v3 = w1 - w1, d2 * T14, d2 * T24
        v4, v5 = T14 * w1, T24 * w1

        # theta2, r3, type 4: U1[1, 4] and U1[2, 4]
        v6 = D1_squared + T34 * T34
        w3 = math.sqrt(v6)

        # joint values
        q3_pp, q3_pm = v1 + w3, v1 - w3

        # a joint is free, or branches meet
        kept[16 * w + k] = 1.0 if abs(D1_squared) <= m1 or v6 <= m2 else kept[16 * w + k]
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = w1, q3_pp, q3_pm
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = -(v2 + v5), v5 - v2, -w1
        turns[8 * w + k], turns[9 * w + k], turns[10 * w + k] = v3 - v4, v3 + v4, T34
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 3 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(3 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        w1, q3_pp, q3_pm = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]

        # theta2, r3, type 4: U1[1, 4] and U1[2, 4]
        q2_pm = angle3 - math.copysign(half_turn, -w1)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = angle1, angle3, q3_pp
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = q2_pm, q3_pm, angle2
        rows[6 * w + k], rows[7 * w + k] = -angle3, -q2_pm
        rows[8 * w + k] = rows[9 * w + k] = UNREACHABLE if angle1 != angle1 else OK
        rows[10 * w + k] = rows[11 * w + k] = UNREACHABLE if angle2 != angle2 else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 20, 16, [
    [0, 1, 2], [0, 3, 4], [5, 6, 2], [5, 7, 4],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "position", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
