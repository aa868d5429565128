# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 274f14e086929f69
"""cartesian: Cartesian arm.

Inverse kinematics, generated from robots/cartesian.yaml and templates/python/solver.py.jinja.
Do not edit: run dhgen robots/cartesian.yaml. The formulas and where they come from: cartesian.md.

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
_of_joints, _zeros = _runtime("entry").of_joints(_HOW, 3), _runtime("arrays").zeros

NAME = "cartesian"
METHOD = "closed form"
DOF = 3
JOINT_TYPES = "PPP"
JOINT_NAMES = ("joint1", "joint2", "joint3")
JOINT_LIMITS = ((0.0, 0.8), (0.0, 0.6), (0.0, 1.2))
BRANCHES = ("only",)
MAX_SOLUTIONS = 1

# What a row of ik_all holds, see there.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC

low1 = -1.2e-09  # lowest value of joint 1, with what rounding adds [m]
high1 = 0.8000000012  # highest value of joint 1, with what rounding adds [m]
per_size = 0.8333333333333334  # slides beyond limits count in the arm's size [m^-1]
low2 = -1.2e-09  # lowest value of joint 2, with what rounding adds [m]
high2 = 0.6000000012  # highest value of joint 2, with what rounding adds [m]
low3 = -1.2e-09  # lowest value of joint 3, with what rounding adds [m]
high3 = 1.2000000012  # highest value of joint 3, with what rounding adds [m]

_ARM = _arms.arm_numbers(_arms.Arm(
    types=JOINT_TYPES, limits=JOINT_LIMITS, rows=1, directions="none",
    miss_weights=(0.8333, 0.8333, 0.8333, 0.0, 0.0, 0.0), size=1.2,
    slacks=(1.2e-09, 1.2e-09, 1.2e-09),
    weights=(0.6944444444444444, 0.6944444444444444, 0.6944444444444444), paces=(1.2, 1.2, 1.2),
))

# The table at q = 0, standard: theta [rad], d [m], a [m], alpha [rad].
TABLE = (
    (0.0, 0.0, 0.0, -1.5707963267948966),
    (-1.5707963267948966, 0.0, 0.0, -1.5707963267948966),
    (0.0, 0.0, 0.0, 0.0),
)
frames = _runtime("frames").frames_of(
    types=JOINT_TYPES, table=TABLE, convention="standard",
)


@_of_joints
def fk(q):
    """The pose (4, 4) of the joint values q (3,)."""
    T = _zeros(4, 4)
    T[0, 2], T[0, 3] = 1.0, q[2]
    T[1, 1], T[1, 3] = -1.0, q[1]
    T[2, 0], T[2, 3] = 1.0, q[0]
    T[3, 3] = 1.0
    return T


@_of_joints
def jacobian(q):
    """The geometric Jacobian (6, 3): velocity of the tool's origin, then angular velocity."""
    J = _zeros(6, 3)
    J[0, 2] = 1.0
    J[1, 1] = 1.0
    J[2, 0] = 1.0
    return J


@_HOW.apart(_arms.SOLVES)
def _solve(pose, q_free, seed, moved, q, status):
    """Fills the rows of the branches that have a solution, and no others."""
    _, _, _, T14, _, _, _, T24, _, _, _, T34 = pose

    row = 0
    q[row, 0], q[row, 1], q[row, 2] = T34, T24, T14
    status[row] = OK


@_HOW.merged
def _formulas(kept, turns, rows, w):
    """Regular poses, w of them side by side, every branch: what is derived, without special cases.

    kept[n * w + k] is a value of pose k, first the entries of T. What can't be reached is NaN by
    itself: it has the root of a negative number in it.
    """
    for k in range(w):
        T14, T24, T34 = kept[3 * w + k], kept[7 * w + k], kept[11 * w + k]

        # joint values
        outside = (
            0.0 < max(per_size * max(low3 - T14, T14 - high3), max(per_size * max(low1 - T34, T34 -
            high1), per_size * max(low2 - T24, T24 - high2)))
        )

        _0 = T34
        rows[0 * w + k], rows[1 * w + k], rows[2 * w + k] = _0, T24, T14
        rows[3 * w + k] = UNREACHABLE if _0 != _0 else (OUT_OF_LIMITS if outside else OK)


# Where in rows the joint values of each row are.
_FORMULAS = _functions.Formulas(_formulas, 17, 1, [
    [0, 1, 2],
])


_CALLS = _functions.of_robot(globals(), _HOW, _functions.Solver(_ARM, "position", _FORMULAS))
ik, ik_all, ik_batch, ik_into, joint_velocities, warm_up, Unreachable = _functions.public(_CALLS)
