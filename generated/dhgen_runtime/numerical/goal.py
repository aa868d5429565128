# SPDX-License-Identifier: MIT
"""What joint values have to meet, and the joints that descents begin with."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from .places import DOF, FREE, GIVEN, PLACE, RECORD, SOLVED, UNIT

if TYPE_CHECKING:
    from ..arrays import Floats

OWN = of_file(__file__)
inner = OWN.inner

# The upper rows (3, 4) of a pose, what the caller gives besides, and the address of the robot's
# function that measures by how much the arm angle is missed, where that is given.
Goal = tuple["Floats", "Floats", int]
GOAL = "Tuple((float64[:, ::1], float64[::1], int64))"  # the same in numba's words
NO_ARM_ANGLE = 0  # the address where no arm angle is given


@inner
def goal_of(pose: tuple[float, ...], q_free: Floats, arm_angle_miss: int) -> Goal:
    """Returns a pose with what the caller gives besides."""
    T = np.empty((3, 4))
    for i in range(3):
        for j in range(4):
            T[i, j] = pose[4 * i + j]
    return T, q_free, arm_angle_miss


@inner
def given_joints(arm: Floats, q_free: Floats) -> Floats:
    """Returns joint values that are zero but where the caller gives them."""
    joints, at = np.zeros(int(arm[DOF])), int(arm[FREE])
    for k in range(int(arm[GIVEN])):
        joints[int(arm[at + k])] = q_free[k]
    return joints


@inner
def in_units(arm: Floats, q: Floats) -> Floats:
    """Returns the values of the joints that are solved for, in units."""
    u = np.empty(int(arm[SOLVED]))
    for j in range(len(u)):
        u[j] = q[int(arm[PLACE + RECORD * j])] / arm[UNIT + RECORD * j]
    return u


@inner
def take_units(arm: Floats, u: Floats, q: Floats) -> None:
    """Sets the joints that are solved for to values in units."""
    for j in range(int(arm[SOLVED])):
        at = RECORD * j
        q[int(arm[PLACE + at])] = arm[UNIT + at] * u[j]
