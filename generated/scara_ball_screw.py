# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 219eb12029b9e883
"""scara_ball_screw: SCARA with a ball screw spline.

Inverse kinematics, generated from robots/scara_ball_screw.yaml and
templates/python/solver.py.jinja.
Do not edit: run dhgen robots/scara_ball_screw.yaml. The formulas and where they come from:
scara_ball_screw.md.

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
_wrap = _runtime("angles").wrap
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 4), _runtime("arrays").zeros

NAME = "scara_ball_screw"
METHOD = "closed form"
DOF = 4
JOINT_TYPES = "RRPR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4")
JOINT_LIMITS = (
    (-2.2689280275926285, 2.2689280275926285), (-2.530727415391778, 2.530727415391778), (-0.2, 0.0),
    (-6.283185307179586, 6.283185307179586),
)
BRANCHES = ("right", "left")
MAX_SOLUTIONS = 2

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

L1 = 0.4  # link length 1 [m]
L2 = 0.3  # link length 2 [m]
free_limit = 1e-12  # a length that fixes no angle
longest2 = 0.48999999999999994  # square of the longest reach [m^2]
shortest2 = 0.010000000000000007  # square of the shortest reach [m^2]
longest2_reach = 0.490000000000098  # the longest, with what rounding adds [m^2]
shortest2_reach = 0.009999999999986006  # the shortest, with what rounding adds [m^2]
longest2_apart = 0.48999999999999017  # the longest, where branches merge [m^2]
shortest2_apart = 0.010000000000001405  # the shortest, where branches merge [m^2]
pose_slack = 1e-05  # a pose may be rounded by this
pose_slack1 = 7e-06  # a pose may be rounded by this [m]
factor34 = 0.0025464790894703256  # pitch/(2*pi): what q4 counts in joint 3
k1 = 0.25  # L1^2 + L2^2 [m^2]
k2 = 4.166666666666667  # 1 / (2 * L2 * L1) [m^-2]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

# The drives whose whole turns hang together, and sums of drives that have limits.
_coupled = _runtime("coupled")
_COUPLING = _coupled.coupling_numbers(
    _coupled.Coupling(
        drives=(3,),
        moves=((0.0, 0.0, -0.016, 6.283185307179586),),
        limits=(
            (-2.2689280285926285, 2.2689280285926285),
            (-2.530727416391778, 2.530727416391778),
            (-0.2000000007, 7e-10),
            (-6.283185308179586, 6.283185308179586),
        ),
        factors=(),
        sums=(),
        slacks=(),
    )
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES,
    limits=(
        (-2.2689280275926285, 2.2689280275926285),
        (-2.530727415391778, 2.530727415391778),
        (-math.inf, math.inf),
        (-math.inf, math.inf),
    ),
    rows=2, directions="rotation", miss_weights=(1.429, 1.429, 1.429, 1.0, 1.0, 1.0), size=0.7,
    slacks=(1e-09, 1e-09, 7e-10, 1e-09), weights=(1.0, 1.0, 2.0408163265306127, 1.0),
    paces=(1.0, 1.0, 0.7, 1.0),
), coupling=_COUPLING)

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.4, 0.0),
    (0.0, 0.0, 0.3, 0.0),
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
    drives=(
        (1.0, 0.0, 0.0, 0.0),
        (0.0, 1.0, 0.0, 0.0),
        (0.0, 0.0, 1.0, 0.0025464790894703256),
        (0.0, 0.0, 0.0, 1.0),
    ),
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (4,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_y = x2_y * c4 + x2_x * s4
    T[0, 0], T[0, 1], T[0, 3] = x2_x * c4 - x2_y * s4, -x4_y, c1 * L1 + x2_x * L2
    T[1, 0], T[1, 1], T[1, 3] = x4_y, x2_x * c4 - x2_y * s4, s1 * L1 + x2_y * L2
    T[2, 2], T[2, 3] = 1.0, q[2] + factor34 * q[3]
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 4): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * L1, s1 * L1
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    p2_x, p2_y = p1_x + (c1 * c2 - s1 * s2) * L2, p1_y + (s1 * c2 + c1 * s2) * L2
    J[0, 0], J[0, 1] = -p2_y, p1_y - p2_y
    J[1, 0], J[1, 1] = p2_x, p2_x - p1_x
    J[2, 2], J[2, 3] = 1.0, factor34
    J[5, 0], J[5, 1], J[5, 3] = 1.0, 1.0, 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    T11, _, T13, T14, T21, _, T23, T24, T31, _, T33, T34 = pose

    # theta124, type 3: U0[2, 1] and U0[1, 1]
    w124 = math.sqrt(T21 * T21 + T11 * T11)
    short124 = w124 <= free_limit
    v1 = 1.0 / (1.0 if short124 else w124)
    c124, s124 = T11 * v1, T21 * v1
    theta124 = _atan2(s124, c124)

    # theta2, type 8: U0[1, 4] and U0[2, 4]
    N2 = T14 * T14 + T24 * T24
    K2 = N2 - k1
    D2_squared = (longest2 - N2) * (N2 - shortest2)
    apart2 = shortest2_apart < N2 and N2 < longest2_apart
    if not (shortest2_reach <= N2 and N2 <= longest2_reach):
        return  # out of reach
    w2 = math.sqrt(D2_squared if apart2 else 0.0)
    c2 = K2 * k2

    # theta1, type 3: U0[2, 4] and U0[1, 4]
    X1_1 = L1 + L2 * c2
    v2, v3 = T24 * X1_1, T14 * X1_1

    # is the pose one that the arm can take?
    if (
        not (abs(T33 - 1.0) <= pose_slack and abs(T31) <= pose_slack and abs(T23) <= pose_slack and
        abs(T21 - s124) <= pose_slack and abs(T11 - c124) <= pose_slack and abs(T13) <= pose_slack)
    ):
        return  # the arm can't take this pose

    for i1 in range(2):  # right, left
        e2 = 1.0 - 2.0 * i1
        # theta2
        if e2 < 0.0 and not apart2:
            continue  # both signs give the same
        s2 = w2 * e2 * k2
        q2 = _atan2(s2, c2)

        # theta1
        Y1_1 = L2 * s2
        S1 = v2 - T14 * Y1_1
        C1 = v3 + T24 * Y1_1
        w1 = math.sqrt(S1 * S1 + C1 * C1)
        factor1 = 1.0 / w1
        c1, s1 = C1 * factor1, S1 * factor1
        q1 = _atan2(s1, c1)

        # is the pose one that the arm can take?
        c12, s12 = c2 * c1 - s2 * s1, c2 * s1 + s2 * c1
        if (
            not (abs(T14 - (L2 * c12 + L1 * c1)) <= pose_slack1 and abs(T24 - (L2 * s12 + L1 * s1))
            <= pose_slack1)
        ):
            continue  # the arm can't take this pose

        # joint values
        q4 = _wrap(theta124 - (q2 + q1))
        q3 = T34 - q4 * factor34
        row = i1
        q[row, 0], q[row, 1], q[row, 2] = q1, q2, q3
        q[row, 3] = q4
        status[row] = OK


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "pose"))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
