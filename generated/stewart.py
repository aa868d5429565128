# SPDX-License-Identifier: MIT
# dhgen 0.2.0.dev0; SHA-256 of the robot file: 7e0d95027cd10e15
"""stewart: Stewart platform, six cylinders (6-UPS).

Inverse kinematics, generated from robots/stewart.yaml and templates/python/parallel.py.jinja.
Do not edit: run dhgen robots/stewart.yaml. The formulas and where they come from: stewart.md.

A platform on 6 legs, each of which is a serial arm. Poses are 4 x 4 matrices of the platform in the
base frame, lengths in m, angles in rad. Every entry of a pose counts.
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

NAME = "stewart"
METHOD = "legs"
TASK = "pose"
LEGS = 6
DOF = 6  # of the platform, which has as many driven joints
JOINTS = 3  # of a leg, passive ones among them
CHAINS = ("stewart_leg", "stewart_leg", "stewart_leg", "stewart_leg", "stewart_leg", "stewart_leg")
_MODULES = tuple(map(_leg, CHAINS))
JOINT_TYPES = tuple(each.JOINT_TYPES for each in _MODULES)
JOINT_LIMITS = tuple(each.JOINT_LIMITS for each in _MODULES)
BRANCHES = tuple(each.BRANCHES for each in _MODULES)
MAX_SOLUTIONS = 4  # of a leg
DRIVES = ((0, 2), (1, 2), (2, 2), (3, 2), (4, 2), (5, 2))  # leg and joint, from 0
ASSEMBLIES = 0  # poses of given drives at most; 0 where that is not known

# What a row of ik_all holds: NaN where it is UNREACHABLE or INVALID_POSE, joint values else.
OK, UNREACHABLE, FREE_JOINT, OUT_OF_LIMITS, INVALID_POSE = _runtime("status").PUBLIC


class Unreachable(ValueError):  # noqa: N818
    """A leg has no solution, or none inside the limits; the message says which."""


# Of every leg, from the robot's base to its own, and what it carries, in the platform.
_PLACES = (
    (
        [
            [1.0, 0.0, 0.0, -0.492403876506104],
            [0.0, 1.0, 0.0, 0.08682408883346517],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
        [
            [1.0, 0.0, 0.0, 0.1928362829059618],
            [0.0, 1.0, 0.0, -0.2298133329356934],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
    ),
    (
        [
            [-0.5, 0.8660254037844386, 0.0, -0.49240387650610395],
            [-0.8660254037844386, -0.5, 0.0, 0.08682408883346515],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
        [
            [-0.5, -0.8660254037844386, 0.0, 0.10260604299770058],
            [0.8660254037844386, -0.5, 0.0, 0.2819077862357725],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
    ),
    (
        [
            [-0.5, -0.8660254037844386, 0.0, -0.492403876506104],
            [0.8660254037844386, -0.5, 0.0, 0.08682408883346512],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
        [
            [-0.5, 0.8660254037844386, 0.0, -0.2954423259036624],
            [-0.8660254037844386, -0.5, 0.0, -0.05209445330007911],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
    ),
    (
        [
            [1.0, 0.0, 0.0, -0.492403876506104],
            [0.0, 1.0, 0.0, -0.08682408883346517],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
        [
            [1.0, 0.0, 0.0, 0.1928362829059618],
            [0.0, 1.0, 0.0, 0.2298133329356934],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
    ),
    (
        [
            [-0.5, 0.8660254037844386, 0.0, -0.492403876506104],
            [-0.8660254037844386, -0.5, 0.0, -0.08682408883346512],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
        [
            [-0.5, -0.8660254037844386, 0.0, -0.2954423259036624],
            [0.8660254037844386, -0.5, 0.0, 0.05209445330007911],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
    ),
    (
        [
            [-0.5, -0.8660254037844386, 0.0, -0.49240387650610395],
            [0.8660254037844386, -0.5, 0.0, -0.08682408883346515],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
        [
            [-0.5, 0.8660254037844386, 0.0, 0.10260604299770058],
            [-0.8660254037844386, -0.5, 0.0, -0.2819077862357725],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ],
    ),
)
_COUNTED = ((0, 1, 2), (0, 1, 2), (0, 1, 2), (0, 1, 2), (0, 1, 2), (0, 1, 2))

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
    task="pose",
    is_planar=False,
    freedoms=(0, 1, 2, 3, 4, 5),
    size=0.9397,
)
_FUNCTIONS = _parallel.Functions(_PLATFORM, Unreachable, "")
ik, ik_all, ik_batch = _FUNCTIONS.ik, _FUNCTIONS.ik_all, _FUNCTIONS.ik_batch
ik_drives, ik_drives_batch = _FUNCTIONS.ik_drives, _FUNCTIONS.ik_drives_batch
fk, drives, assemblies = _FUNCTIONS.fk, _FUNCTIONS.drives, _FUNCTIONS.assemblies
velocities, singularities = _FUNCTIONS.velocities, _FUNCTIONS.singularities
