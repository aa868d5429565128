# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 07c20b2bc6956a7a
"""parallel_3rpr: Planar platform on three cylinders (3-RPR).

Inverse kinematics, generated from robots/parallel_3rpr.yaml and templates/python/parallel.py.jinja.
Do not edit: run dhgen robots/parallel_3rpr.yaml. The formulas and where they come from:
parallel_3rpr.md.

A platform on 3 legs, each of which is a serial arm. Poses are 4 x 4 matrices of the platform in the
base frame, lengths in m, angles in rad. Of a pose its place in the plane of x and y and its yaw
count.
"""

import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType

import numpy as np

# The runtime that lies beside this file, by whatever name this is imported, and no other one: it is
# in a package named after the folder. A dot in a name would be one between packages.
_BESIDE = str(Path(__file__).resolve().parent)
_FOLDER = _BESIDE.replace("%", "%25").replace(".", "%2E")
sys.modules.setdefault(_FOLDER, ModuleType(_FOLDER)).__path__ = [_BESIDE]


def _runtime(name):
    return import_module(f"{_FOLDER}.dhgen_runtime.{name}")


def _leg(name):
    beside = str(Path(__file__).resolve().parent)
    folder = beside.replace("%", "%25").replace(".", "%2E")
    sys.modules.setdefault(folder, ModuleType(folder)).__path__ = [beside]
    return import_module(f"{folder}.{name}")


_runtime("jit").of_file(__file__, interface=1)
_parallel = _runtime("parallel")

NAME = "parallel_3rpr"
METHOD = "legs"
TASK = "[x, y, yaw]"
LEGS = 3
DOF = 3  # of the platform, which has as many driven joints
JOINTS = 2  # of a leg, passive ones among them
CHAINS = ("parallel_3rpr_leg", "parallel_3rpr_leg", "parallel_3rpr_leg")
_MODULES = tuple(map(_leg, CHAINS))
JOINT_TYPES = tuple(each.JOINT_TYPES for each in _MODULES)
JOINT_LIMITS = tuple(each.JOINT_LIMITS for each in _MODULES)
BRANCHES = tuple(each.BRANCHES for each in _MODULES)
MAX_SOLUTIONS = 2  # of a leg
DRIVES = ((0, 1), (1, 1), (2, 1))  # leg and joint, from 0
ASSEMBLIES = 6  # poses of given drives at most; 0 where that is not known

# What a row of ik_all holds: NaN where it is UNREACHABLE or INVALID_POSE, joint values else.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC


class Unreachable(ValueError):  # noqa: N818
    """A leg has no solution, or none inside the limits; the message says which."""


# Of every leg, from the robot's base to its own, and what it carries, in the platform.
_PLACES = (
    (
        [
            [1.0, 0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
        [
            [1.0, 0.0, 0.0, -0.2],
            [0.0, 1.0, 0.0, -0.1],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
    ),
    (
        [
            [1.0, 0.0, 0.0, -1.2],
            [0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
        [
            [1.0, 0.0, 0.0, 0.25],
            [0.0, 1.0, 0.0, -0.1],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
    ),
    (
        [
            [1.0, 0.0, 0.0, -0.5],
            [0.0, 1.0, 0.0, -1.1],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
        [
            [1.0, 0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0, 0.25],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
    ),
)
_COUNTED = ((0, 1), (0, 1), (0, 1))

_PLATFORM = _parallel.Platform(
    legs=tuple(
        _parallel.Leg(
            module=module,
            driven=tuple(joint for number, joint in DRIVES if number == leg),
            counted=_COUNTED[leg],
            base=np.array(_PLACES[leg][0]),
            end=np.array(_PLACES[leg][1]),
        )
        for leg, module in enumerate(_MODULES)
    ),
    task="yaw",
    is_planar=True,
    freedoms=(0, 1, 5),
    size=1.6,
)
_FUNCTIONS = _parallel.Functions(_PLATFORM, Unreachable, "three circles")
ik, ik_all, ik_batch = _FUNCTIONS.ik, _FUNCTIONS.ik_all, _FUNCTIONS.ik_batch
ik_drives, ik_drives_batch = _FUNCTIONS.ik_drives, _FUNCTIONS.ik_drives_batch
fk, drives, assemblies = _FUNCTIONS.fk, _FUNCTIONS.drives, _FUNCTIONS.assemblies
velocities, singularities = _FUNCTIONS.velocities, _FUNCTIONS.singularities
