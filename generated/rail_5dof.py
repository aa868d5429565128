# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 4631ca9d913f2f17
"""rail_5dof: Arm with four revolute joints on a rail.

Inverse kinematics, generated from robots/rail_5dof.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/rail_5dof.yaml. The formulas and where they come from: rail_5dof.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 5), _runtime("arrays").zeros

NAME = "rail_5dof"
METHOD = "closed form"
DOF = 5
JOINT_TYPES = "PRRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4", "joint5")
JOINT_LIMITS = (
    (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf), (-math.inf, math.inf),
    (-math.inf, math.inf),
)
BRANCHES = ("noflip", "flip")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

# In formulas below, doubt_limit2 = 0.0036 [m^2], doubt_limit = 9.999999999999999e-05,
# exact_slack1 = 6e-12 [m], exact_slack = 1e-12.
a1 = 2.0  # link length 2 [m]
d3 = 1.0  # joint offset 3 [m]
d5 = 3.0  # joint offset 5 [m]
free_limit2 = 3.6e-11  # a length that fixes no angle [m^2]
free_limit = 1e-12  # a length that fixes no angle
doubtful_slack = 0.01  # a row may miss the pose by this before it is refined
doubtful_slack1 = 0.06  # a row may miss the pose by this before it is refined [m]
m1 = 1.296e-05  # doubt_limit2^2 [m^4]
m2 = 9.999999999999999e-09  # doubt_limit^2
m4 = 3.6000000000000004e-23  # exact_slack1^2 [m^2]
m5 = 1e-24  # exact_slack^2
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=2, size=6.0, coordinates=(0, 1, 2), directions="rotation",
    joints=(
        _joints.Joint(place=0, turns=False),
        _joints.Joint(place=1),
        _joints.Joint(place=2),
        _joints.Joint(place=3),
        _joints.Joint(place=4),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint(
            after=(1.0, 0.0, 0.0, 2.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0), turns=False,
        ),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 1.0, 0.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 3.0, 0.0, -1.0, 0.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
    ),
    checked=True,
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=2, directions="rotation",
    miss_weights=(0.1667, 0.1667, 0.1667, 1.0, 1.0, 1.0), size=6.0,
    slacks=(6e-09, 1e-09, 1e-09, 1e-09, 1e-09), weights=(0.027777777777777776, 1.0, 1.0, 1.0, 1.0),
    paces=(6.0, 1.0, 1.0, 1.0, 1.0), entries=(0, 2, 3, 4, 6, 7, 8, 10, 11),
    steps=("completes", "equations end all", "follows seed"),
), _joints.arm_numbers(_LINKS))

# The table at q = 0, modified: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 2.0, 0.0),
    (0.0, 1.0, 0.0, 1.5707963267948966),
    (0.0, 0.0, 0.0, 1.5707963267948966),
    (0.0, 3.0, 0.0, -1.5707963267948966),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="modified",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (5,)."""
    T = _zeros(4, 4)
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y, z4_x = c2 * c3, s2 * c3, c2 * s3
    z4_y = s2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y, x4_z = x3_x * c4 + s2 * s4, x3_y * c4 - c2 * s4, s3 * c4
    y4_x, v1, v2 = s2 * c4 - x3_x * s4, c2 * c4 + x3_y * s4, s3 * s4
    c5, s5 = math.cos(q[4]), math.sin(q[4])
    T[0, 0], T[0, 1], T[0, 2] = x4_x * c5 - z4_x * s5, -(z4_x * c5 + x4_x * s5), y4_x
    T[0, 3] = a1 + s2 * d3 + y4_x * d5
    T[1, 0], T[1, 1], T[1, 2] = x4_y * c5 - z4_y * s5, -(z4_y * c5 + x4_y * s5), -v1
    T[1, 3] = -(c2 * d3 + v1 * d5)
    T[2, 0], T[2, 1], T[2, 2] = x4_z * c5 + c3 * s5, c3 * c5 - x4_z * s5, -v2
    T[2, 3] = q[0] - v2 * d5
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 5): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 5)
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    p3_x, v1 = a1 + s2 * d3, c2 * d3
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    z4_x, z4_y = c2 * s3, s2 * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    y4_x, v2, v3 = s2 * c4 - c2 * c3 * s4, c2 * c4 + s2 * c3 * s4, s3 * s4
    p5_x, J12, v4 = p3_x + y4_x * d5, v1 + v2 * d5, q[0] - v3 * d5 - q[0]
    v5, v6 = p5_x - p3_x, v1 - J12
    J[0, 1], J[0, 2], J[0, 3] = J12, -(c2 * v4), z4_y * v4 + c3 * v6
    J[1, 1], J[1, 2], J[1, 3] = p5_x - a1, -(s2 * v4), -(c3 * v5 + z4_x * v4)
    J[2, 0], J[2, 2], J[2, 3] = 1.0, s2 * v6 + c2 * v5, z4_x * v6 - z4_y * v5
    J[3, 2], J[3, 3], J[3, 4] = s2, z4_x, y4_x
    J[4, 2], J[4, 3], J[4, 4] = -c2, z4_y, -v2
    J[5, 1], J[5, 3], J[5, 4] = 1.0, -c3, -v3
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, T12, T13, T14, T21, T22, T23, T24, T31, T32, T33, T34 = pose

    # r1, type 1: U0 A5^-1 [3, 4]
    wz = T34 - T33 * d5

    # theta2, type 3: U0 A5^-1 [1, 4] and U0 A5^-1 [2, 4]
    wx = T14 - d5 * T13
    wy = T24 - d5 * T23
    v1 = d3 * (wx - a1)
    C2 = d3 * wy
    w2 = math.sqrt(v1 * v1 + C2 * C2)
    short2 = w2 <= free_limit2
    v2 = 1.0 / (1.0 if short2 else w2)
    v3 = C2 * v2
    s2 = v1 * v2
    q2 = _atan2(s2, -v3)

    # theta3, type 2: U3[2, 3]
    X3 = T23 * s2 - T13 * v3
    w3 = math.sqrt(X3 * X3 + T33 * T33)
    free3 = w3 <= free_limit
    divisor3 = 1.0 if free3 else w3

    # theta4, type 3: U3[3, 3] and U3[1, 3]
    v4 = T23 * v3 + T13 * s2
    v5 = v4 * v4

    # theta5, type 3: U3[2, 2] and U3[2, 1]
    v7, v8 = T22 * s2 - T12 * v3, T21 * s2 - T11 * v3

    # is the pose one that the arm can take?
    v13, v15 = T34 - wz, T14 - a1
    v16, v17, v18 = T24 * s2 - v3 * v15, T11 * s2 + T21 * v3, s2 * v15 + T24 * v3

    for i1 in range(2):  # noflip, flip
        e3 = 1.0 - 2.0 * i1
        # theta3
        if e3 < 0.0 and free3:
            continue  # both signs give the same
        factor3 = e3 / divisor3
        c3 = math.cos(seed[2]) if free3 else -(X3 * factor3)
        s3 = math.sin(seed[2]) if free3 else -(T33 * factor3)
        q3 = _atan2(s3, c3)
        D3 = w3 * e3

        # theta4
        w4 = math.sqrt(D3 * D3 + v5)
        short4 = w4 <= free_limit
        v6 = 1.0 / (1.0 if short4 else w4)
        c4, s4 = v4 * v6, D3 * v6
        q4 = _atan2(s4, c4)

        # theta5
        C5 = s3 * v7 - T32 * c3
        S5 = s3 * v8 - T31 * c3
        w5 = math.sqrt(S5 * S5 + C5 * C5)
        short5 = w5 <= free_limit
        v9 = 1.0 / (1.0 if short5 else w5)
        v10, v11 = C5 * v9, S5 * v9
        q5 = _atan2(-v11, -v10)

        # is the pose one that the arm can take?
        v12, v14 = s3 * s4, c3 * s4
        if (
            not (abs(v13 + d5 * v12) <= doubtful_slack1 and abs(T33 + v12) <= doubtful_slack and
            abs(T31 + (v10 * (s3 * c4) + c3 * v11)) <= doubtful_slack and abs(d3 + d5 * c4 - v18) <=
            doubtful_slack1 and abs(c4 - v4) <= doubtful_slack and abs(v17 + s4 * v10) <=
            doubtful_slack and abs(v16 + d5 * v14) <= doubtful_slack1 and abs(v8 - (s3 * v11 - v10 *
            (c3 * c4))) <= doubtful_slack and abs(X3 + v14) <= doubtful_slack)
        ):
            continue  # the arm can't take this pose
        row = i1
        q[row, 0], q[row, 1], q[row, 2] = wz, q2, q3
        q[row, 3], q[row, 4] = q4, q5
        status[row] = FREE_JOINT if free3 else OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T11, T12, T13 = kept[0 * w + k], kept[1 * w + k], kept[2 * w + k]
        T14, T21, T22 = kept[3 * w + k], kept[4 * w + k], kept[5 * w + k]
        T23, T24, T31 = kept[6 * w + k], kept[7 * w + k], kept[8 * w + k]
        T32, T33, T34 = kept[9 * w + k], kept[10 * w + k], kept[11 * w + k]

        # r1, type 1: U0 A5^-1 [3, 4]
        q1_p = T34 - d5 * T33

        # theta2, type 3: U0 A5^-1 [1, 4] and U0 A5^-1 [2, 4]
        wy, v1 = T24 - d5 * T23, T14 - d5 * T13 - a1
        s2, C2 = d3 * v1, d3 * wy
        v2 = s2 * s2 + C2 * C2
        v3 = math.sqrt(v2) * (1.0 / v2)

        # theta3, type 2: U3[2, 3]
        X3 = T23 * s2 - T13 * C2
        v4 = T33 * T33 + v3 * (X3 * (v3 * X3))
        w3, v5 = math.sqrt(v4), 1.0 / v4
        factor3 = w3 * v5
        v6, v7 = X3 * factor3, T33 * factor3
        v8 = v3 * v6

        # theta4, type 3: U3[3, 3] and U3[1, 3]
        v9 = T23 * C2 + T13 * s2
        v10 = v4 + v3 * (v9 * (v3 * v9))
        v11 = math.sqrt(v10) * (1.0 / v10)
        c4, s4 = v9 * v11, w3 * v11

        # theta5, type 3: U3[2, 2] and U3[2, 1]
        C5, v12 = w3 * (v5 * (X3 * T32 - T33 * (s2 * T22 - C2 * T12))), s2 * T21 - C2 * T11
        S5 = w3 * (v5 * (X3 * T31 - T33 * v12))
        v13 = v3 * (S5 * (v3 * S5) + C5 * (v3 * C5))
        v14 = math.sqrt(v13) * (1.0 / v13)
        v15, v16 = C5 * v14, S5 * v14

        # is the pose one that the arm can take?
        v17, v18, v19 = v7 * s4, v6 * s4, T14 - a1
        v20, v21, v22 = T34 - q1_p - d5 * v17, T33 - v17, v3 * v15
        v23 = T31 - v3 * (v22 * (v7 * c4) + v8 * v16)
        v24, v25 = d3 + v3 * (d5 * c4) - v3 * (s2 * v19 + T24 * C2), v3 * (c4 - v9)
        v26, v27 = v3 * (s2 * T11 + C2 * T21 + s4 * v15), v3 * (T24 * s2 - C2 * v19 - d5 * v18)
        v28, v29 = v3 * (v12 - (v22 * (v8 * c4) - v7 * v16)), v3 * (X3 - v18)

        # a joint is free, or branches meet
        kept[16 * w + k] = (
            1.0 if v4 <= m2 or v2 <= m1 or v10 <= m2 or v13 <= m2 or m5 < v21 * v21 + v23 * v23 +
            v25 * v25 + v26 * v26 + v28 * v28 + v29 * v29 or m4 < v20 * v20 + v24 * v24 + v27 * v27
            else kept[16 * w + k]
        )
        kept[17 * w + k], kept[18 * w + k], kept[19 * w + k] = q1_p, v7, v16
        turns[0 * w + k], turns[1 * w + k], turns[2 * w + k] = v1, -v7, s4
        turns[3 * w + k], turns[8 * w + k], turns[9 * w + k] = -v16, -wy, -v8
        turns[10 * w + k], turns[11 * w + k] = v3 * c4, -v15
    if w == 1 and kept[16] != 0.0:
        return
    end = 8 if w == 1 else 4 * w
    # one pose's vectors are filled up: any numbers would do, but some are slow
    for k in range(4 * w, end):
        turns[k] = turns[k + 8 * w] = 1.0
    for k in range(0 * w, end):
        turns[k] = _atan2(turns[k], turns[k + 8 * w])
    for k in range(w):
        q1_p, v7, v16 = kept[17 * w + k], kept[18 * w + k], kept[19 * w + k]
        angle1, angle2, angle3 = turns[0 * w + k], turns[1 * w + k], turns[2 * w + k]
        angle4 = turns[3 * w + k]

        # theta3, type 2: U3[2, 3]
        q3_m = angle2 - math.copysign(half_turn, -v7)

        # theta5, type 3: U3[2, 2] and U3[2, 1]
        q5_m = angle4 - math.copysign(half_turn, -v16)

        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = q1_p, angle1, angle2
        rows[3 * w + k], rows[4 * w + k], rows[5 * w + k] = angle3, angle4, q3_m
        rows[6 * w + k], rows[7 * w + k] = -angle3, q5_m
        rows[8 * w + k] = rows[9 * w + k] = UNREACHABLE if q1_p != q1_p else OK


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 20, 16, [
    [0, 1, 2, 3, 4], [0, 1, 5, 6, 7],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "pose", _FORMULAS, apart=(_runtime("complete").compile_apart,),
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
