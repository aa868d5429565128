# SPDX-License-Identifier: MIT
"""Finds the rows of rounded poses by the rows of poses close to them.

Where one square root is nested in another, or two roots of a polynomial meet, rounding may take a
radicand below zero, though the whole pose fixes the joints well. A little to one side of the pose
it is above zero, and from there least squares find the row.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..arm import ARM_ANGLE_MISS, POSE, SOLVE, descents_of, solve_at
from ..jit import of_file
from ..refine import copy_row, missed_by
from ..retry import TASK
from ..status import LOST, UNREACHABLE
from .goal import goal_of
from .places import SIZE
from .refine_rows import empty_row, exactness, refine_rows, rows_apart
from .solutions import SAME

if TYPE_CHECKING:
    from ..arm import Pose
    from ..arrays import Bytes, Floats
    from ..retry import Task

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

# How far aside [arm sizes, rad]: some times what a pose may be rounded by, and less than what the
# formulas let rows miss that least squares refine.
FIRST_BESIDE, FARTHER_BESIDE, BESIDE_STEPS = 1e-5, 10.0, 3


@apart(f"{POSE}({POSE}, int64, float64, float64)")
def move_aside(pose: Pose, direction: int, by: float, size: float) -> Pose:
    """A pose that is moved along an axis of the base, or turned about one: direction 0 ... 5."""
    to = np.empty(12)
    for k in range(12):
        to[k] = pose[k]
    if direction < 3:
        to[4 * direction + 3] += by * size
    else:
        j, k = (direction + 1) % 3, (direction + 2) % 3
        for c in range(3):
            to[4 * j + c] -= by * pose[4 * k + c]
            to[4 * k + c] += by * pose[4 * j + c]
    x, y, z = to[:4], to[4:8], to[8:]
    return (x[0], x[1], x[2], x[3], y[0], y[1], y[2], y[3], z[0], z[1], z[2], z[3])


@inner
def _has_no_row(descents: Floats, q: Floats, status: Bytes, row: Floats) -> bool:
    for k in range(len(q)):
        if status[k] != UNREACHABLE and rows_apart(descents, q[k], row) < SAME:
            return False
    return True


@apart(f"void({TASK}, float64[::1], float64[:, ::1], uint8[::1])")
def add_rows_beside(task: Task, seed: Floats, q: Floats, status: Bytes) -> None:
    """Adds rows of poses beside one that may be rounded, unless it has an exact row."""
    arm, robot, pose, q_free = task
    descents, T = descents_of(arm), goal_of(pose, q_free, robot[ARM_ANGLE_MISS])[0]
    exact, by = exactness(descents, T), FIRST_BESIDE
    rows, kinds = np.empty(q.shape), np.empty(len(q), np.uint8)
    for row in range(len(q)):
        if status[row] != UNREACHABLE and missed_by(arm, robot, pose, q[row]) <= exact:
            return
    for n in range(12 * BESIDE_STEPS):
        if n > 0 and n % 12 == 0:
            by *= FARTHER_BESIDE
        for row in range(len(q)):
            empty_row(row, rows, kinds)
        aside = move_aside(pose, n // 2 % 6, -by if n % 2 else by, descents[SIZE])
        solve_at(robot[SOLVE], aside, q_free, seed, 0.0, rows, kinds)
        for row in range(len(q)):
            if kinds[row] >= LOST:
                empty_row(row, rows, kinds)
        refine_rows(task, rows, kinds)
        for row in range(len(q)):
            empty = kinds[row] != UNREACHABLE and status[row] == UNREACHABLE
            if empty and _has_no_row(descents, q, status, rows[row]):
                copy_row(rows[row], q[row])
                status[row] = kinds[row]
