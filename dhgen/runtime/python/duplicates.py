# SPDX-License-Identifier: MIT
"""Rows that are one solution: branches that meet come out apart by rounding.

So they do where one root follows another, as an earlier angle is good to fewer digits than usual.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .arm import POSE, ROBOT
from .jit import of_file
from .places import DOF, REFINES, ROWS
from .refine import add_step, half_way, measure_miss, refine
from .status import UNREACHABLE
from .tolerances import BESIDE_SEED, EXACT, MERGE, PROMISED, TOGETHER

if TYPE_CHECKING:
    from .arm import Pose, Robot
    from .arrays import Bytes, Floats

OWN = of_file(__file__)

# The damping of steps that leave singular directions alone, and how many are made.
SINGULAR, STEPS_TO_DOUBLE = 1e-13, 3


@OWN.inner
def _are_duplicates(arm: Floats, robot: Robot, pose: Pose, half: Floats) -> bool:
    """Whether two solutions on both sides of joint values differ by rounding alone.

    Half way the arm is singular, and what steps in all other directions leave of the miss is how
    far the pose is from one at which both meet.
    """
    held, e = np.zeros(len(half), np.bool_), np.empty(6)
    for _ in range(STEPS_TO_DOUBLE):
        measure_miss(arm, robot, pose, half, e)
        add_step(arm, robot, held, SINGULAR, e, half)
    return measure_miss(arm, robot, pose, half, e) <= MERGE


@OWN.inner
def _empty_row(row: int, q: Floats, status: Bytes) -> None:
    """Leaves a row without a solution."""
    status[row] = UNREACHABLE
    for i in range(q.shape[1]):
        q[row, i] = math.nan


@OWN.inner
def _refine_rows(arm: Floats, robot: Robot, pose: Pose, q: Floats, status: Bytes) -> None:
    """Refines rows of a root that follows another, which may be a little out of reach."""
    e = np.empty(6)
    for row in range(int(arm[ROWS])):
        if status[row] == UNREACHABLE or measure_miss(arm, robot, pose, q[row], e) <= PROMISED:
            continue
        if not refine(arm, robot, pose, EXACT, BESIDE_SEED, q[row]):
            _empty_row(row, q, status)


@OWN.apart(f"void(float64[::1], {ROBOT}, {POSE}, float64[:, ::1], uint8[::1])")
def remove_duplicates(arm: Floats, robot: Robot, pose: Pose, q: Floats, status: Bytes) -> None:
    """Empties rows that differ from earlier ones by rounding alone, refined first if need be."""
    if arm[REFINES] > 0.0:
        _refine_rows(arm, robot, pose, q, status)
    half = np.empty(int(arm[DOF]))
    for row in range(1, int(arm[ROWS])):
        for k in range(row):
            if status[row] == UNREACHABLE or status[k] == UNREACHABLE:
                continue
            near = half_way(arm, q[k], q[row], half) < TOGETHER
            if near and _are_duplicates(arm, robot, pose, half):
                _empty_row(row, q, status)
