# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: c20903e6caa02128
"""planar_rrrr: Planar arm with four links, one joint too many twice over.

Inverse kinematics, generated from robots/planar_rrrr.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/planar_rrrr.yaml. The formulas and where they come from:
planar_rrrr.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 4), _runtime("arrays").zeros

NAME = "planar_rrrr"
METHOD = "numerical"
DOF = 4
JOINT_TYPES = "RRRR"
JOINT_NAMES = ("joint1", "joint2", "joint3", "joint4")
JOINT_LIMITS = (
    (-2.0943951023931953, 2.0943951023931953), (-2.0943951023931953, 2.0943951023931953),
    (-2.0943951023931953, 2.0943951023931953), (-2.0943951023931953, 2.0943951023931953),
)
BRANCHES = ("nearest",)
MAX_SOLUTIONS = 1

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

a = 0.25  # link length 1 [m]
turn, half_turn = 2.0 * math.pi, math.pi  # [rad]

_joints = _runtime("numerical.arm")
# The joints, what the task names, and the forward model with all links.
_LINKS = _joints.Arm(
    rows=1, size=1.0, coordinates=(0, 1), directions="none",
    joints=(
        _joints.Joint(place=0, lowest=-2.0943951023931953, highest=2.0943951023931953),
        _joints.Joint(place=1, lowest=-2.0943951023931953, highest=2.0943951023931953),
        _joints.Joint(place=2, lowest=-2.0943951023931953, highest=2.0943951023931953),
        _joints.Joint(place=3, lowest=-2.0943951023931953, highest=2.0943951023931953),
    ),
    base=(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0),
    chain=(
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.25, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.25, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.25, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
        _joints.ChainJoint((1.0, 0.0, 0.0, 0.25, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)),
    ),
    redundant=True,
)
_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=1, directions="none",
    miss_weights=(1.0, 1.0, 0.0, 0.0, 0.0, 0.0), size=1.0, clamped_again=1e-10, steps=("clamps",),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.25, 0.0),
    (0.0, 0.0, 0.25, 0.0),
    (0.0, 0.0, 0.25, 0.0),
    (0.0, 0.0, 0.25, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (4,)."""
    T = _zeros(4, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y = x2_x * c3 - x2_y * s3, x2_y * c3 + x2_x * s3
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    x4_x, x4_y = x3_x * c4 - x3_y * s4, x3_y * c4 + x3_x * s4
    T[0, 0], T[0, 1], T[0, 3] = x4_x, -x4_y, c1 * a + a * x2_x + a * x3_x + a * x4_x
    T[1, 0], T[1, 1], T[1, 3] = x4_y, x4_x, s1 * a + a * x2_y + a * x3_y + a * x4_y
    T[2, 2] = 1.0
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 4): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 4)
    c1, s1 = math.cos(q[0]), math.sin(q[0])
    p1_x, p1_y = c1 * a, s1 * a
    c2, s2 = math.cos(q[1]), math.sin(q[1])
    x2_x, x2_y = c1 * c2 - s1 * s2, s1 * c2 + c1 * s2
    p2_x, p2_y = p1_x + a * x2_x, p1_y + a * x2_y
    c3, s3 = math.cos(q[2]), math.sin(q[2])
    x3_x, x3_y = x2_x * c3 - x2_y * s3, x2_y * c3 + x2_x * s3
    p3_x, p3_y = p2_x + a * x3_x, p2_y + a * x3_y
    c4, s4 = math.cos(q[3]), math.sin(q[3])
    p4_x, p4_y = p3_x + a * (x3_x * c4 - x3_y * s4), p3_y + a * (x3_y * c4 + x3_x * s4)
    J[0, 0], J[0, 1], J[0, 2] = -p4_y, p1_y - p4_y, p2_y - p4_y
    J[0, 3] = p3_y - p4_y
    J[1, 0], J[1, 1], J[1, 2] = p4_x, p4_x - p1_x, p4_x - p2_x
    J[1, 3] = p4_x - p3_x
    J[5, 0], J[5, 1], J[5, 2] = 1.0, 1.0, 1.0
    J[5, 3] = 1.0
    return J


_whole = _runtime("numerical.compiled")
_NUMBERS = _joints.arm_numbers(_LINKS)
_all_joints = _runtime("numerical.search").all_joints
_NO_FREE = _runtime("arrays").NONE_GIVEN


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _all_joints(_NUMBERS, pose, _NO_FREE, seed, q, status)


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(
    _ARM, "position", counted=(True, True, False), apart=(_whole.compile_apart,), at_once=True,
))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
