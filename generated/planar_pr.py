# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: a30db3c244a1600f
"""planar_pr: Inclined slider with a revolute link.

Inverse kinematics, generated from robots/planar_pr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/planar_pr.yaml. The formulas and where they come from: planar_pr.md.

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

NAME = "planar_pr"
METHOD = "closed form"
DOF = 2
JOINT_TYPES = "PR"
JOINT_NAMES = ("joint1", "joint2")
JOINT_LIMITS = ((-math.inf, math.inf), (-math.inf, math.inf))
BRANCHES = ("forward", "backward")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, sqrt3 = 1.7320508075688772, reach_slack = 1e-13, merge_slack = 1e-14.
a = 0.3  # x of the home pose [m]
k1 = 3.3333333333333335  # 1 / a [m^-1]
k2 = 1.6666666666666667  # 1 / 2 * 1 / a [m^-1]
k3 = 2.8867513459481287  # sqrt3 * 1 / 2 * 1 / a [m^-1]
k4 = 11.11111111111111  # k2^2 + k3^2 [m^-2]
k5 = 2.2222222222222224e-12  # 2 * k4 * reach_slack [m^-2]
k6 = 2.2222222222222222e-13  # 2 * k4 * merge_slack [m^-2]
k7 = 0.09  # 1 / k4 [m^2]
f1 = 0.5  # 1 / 2
f2 = 0.8660254037844386  # 1 / 2 * sqrt3
f3 = 0.9999999999999999  # f1^2 + f2^2
m1 = 2.2222222222222221e-10  # 1000 * k6 [m^-2]
m2 = 0.15  # k2 * k7 [m]
m3 = 0.25980762113533157  # k3 * k7 [m]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="none",
    miss_weights=(3.333, 3.333, 0.0, 0.0, 0.0, 0.0), size=0.3, slacks=(3e-10, 1e-09),
    weights=(11.11111111111111, 1.0), paces=(0.3, 1.0), steps=("follows seed",),
))

# The axes at q = 0: a unit vector along each, and a point of it [m].
AXES = (
    (0.8660254037844386, 0.5, 0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 1.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=AXES, convention="axes",
    tool=(1.0, 0.0, 0.0, 0.3, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (2,)."""
    T = _zeros(4, 4)
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = f3 * c2, f3 * s2
    T[0, 0], T[0, 1], T[0, 3] = x2_x, -x2_y, f2 * q[0] + x2_x * a
    T[1, 0], T[1, 1], T[1, 3] = x2_y, x2_x, f1 * q[0] + x2_y * a
    T[2, 2] = 1.0
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 2): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 2)
    p1_x, p1_y = f2 * q[0], f1 * q[0]
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    J[0, 0], J[0, 1] = f2, p1_y - (p1_y + f3 * s2 * a)
    J[1, 0], J[1, 1] = f1, p1_x + f3 * c2 * a - p1_x
    J[5, 1] = 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, _ = pose

    # theta2, r1, type 5: U0[2, 4] and U0[1, 4]
    V1_2 = T24 * k1
    V2_2 = T14 * k1
    v1, v2 = V1_2 * k2 + V2_2 * k3, k2 * V2_2 - V1_2 * k3
    D1_squared = k4 - v2 * v2
    apart2 = k6 < D1_squared
    if not (-k5 <= D1_squared):
        return  # out of reach
    w2 = math.sqrt(D1_squared if apart2 else 0.0)

    for i1 in range(2):  # forward, backward
        e2 = 1.0 - 2.0 * i1
        # theta2, r1
        if e2 < 0.0 and not apart2:
            continue  # both signs give the same
        r1 = (v1 + w2 * e2) * k7
        s2, c2 = V1_2 - k2 * r1, V2_2 - k3 * r1
        q2 = _atan2(s2, c2)
        row = i1
        q[row, 0], q[row, 1] = r1, q2
        status[row] = OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T14, T24 = kept[3 * w + k], kept[7 * w + k]

        # theta2, r1, type 5: U0[2, 4] and U0[1, 4]
        V1_2, V2_2 = k1 * T24, k1 * T14
        v1, v2 = k2 * V1_2 + k3 * V2_2, k2 * V2_2 - k3 * V1_2
        D1_squared = k4 - v2 * v2
        w2 = math.sqrt(D1_squared)
        q1_p, q1_m, v3 = k7 * (v1 + w2), k7 * (v1 - w2), V1_2 - m2 * v1
        v4, v5, v6 = V2_2 - m3 * v1, m2 * w2, m3 * w2

        # a joint is free, or branches meet
        kept[16 * w + k] = 1.0 if abs(D1_squared) <= m1 else kept[16 * w + k]
        kept[17 * w + k], kept[18 * w + k], turns[0 * w + k] = q1_p, q1_m, v3 - v5
        turns[1 * w + k], turns[8 * w + k], turns[9 * w + k] = v3 + v5, v4 - v6, v4 + v6
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 2 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(2 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        q1_p, q1_m, angle1 = kept[17 * w + k], kept[18 * w + k], turns[0 * w + k]
        angle2 = turns[1 * w + k]

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_p, angle1, q1_m
        rows[3 * w + k] = angle2
        rows[4 * w + k] = UNREACHABLE if q1_p != q1_p else OK
        rows[5 * w + k] = UNREACHABLE if q1_m != q1_m else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 19, 16, [
    [0, 1], [2, 3],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "position", _FORMULAS, counted=(True, True, False),
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
