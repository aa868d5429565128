# SPDX-License-Identifier: MIT
"""Searches where a pose was left without a row after a joint had been chosen.

Or with rows that are not exact or beyond limits: several joints may be free, and few of their
values work. Steps from the seed and from evenly spread starts find some that do.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..angles import wrap
from ..arm import ARM_ANGLE, ARM_ANGLE_MISS, arm_angle_at, descents_of
from ..jit import of_file
from ..limits import beyond_limits
from ..places import CLAMPED, CLAMPS, KEEPS_LIMITS
from ..refine import copy_row, refine
from ..retry import TASK
from ..status import FREE_JOINT, UNREACHABLE
from ..tolerances import DOUBTFUL
from . import places
from .descent import descend, start_of
from .goal import GOAL, given_joints, goal_of, in_units, take_units
from .refine_rows import LOOSE, ROW_STEPS, SURE, approach, empty_row, escape, exactness

if TYPE_CHECKING:
    from ..arrays import Bytes, Floats
    from ..retry import Task
    from .goal import Goal

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

SEARCH_STARTS = 12  # starts of a search
# What is wrong with joint values, as a sum: they are beyond limits, not exact, there are none.
IS_BEYOND_LIMITS, IS_INEXACT, IS_MISSING = 1, 2, 4


@inner
def fault(arm: Floats, miss: float, exact: float, q: Floats) -> int:
    """What is wrong with joint values that miss the pose by so much."""
    beyond = arm[KEEPS_LIMITS] > 0.0 and beyond_limits(arm, q) > 0.0
    return (IS_INEXACT if miss > exact else 0) + (IS_BEYOND_LIMITS if beyond else 0)


@inner
def least_fault(arm: Floats, goal: Goal, exact: float, q: Floats, status: Bytes) -> tuple[int, int]:
    """What is wrong with the best of the rows, and the first where a joint is free or nearly.

    The second is -1 where none is.
    """
    descents, least, chosen = descents_of(arm), IS_MISSING, -1
    for row in range(len(q) - 1, -1, -1):
        if status[row] == UNREACHABLE:
            continue
        miss, ahead = 0.0, 0.0
        if descents[places.CHECKED] > 0.0:
            miss, ahead = approach(descents, goal, 0, exact, q[row].copy())
        least = min(least, fault(arm, miss, exact, q[row]))
        if status[row] == FREE_JOINT or ahead > SURE:
            chosen = row
    return least, chosen


@apart(f"float64({TASK}, {GOAL}, float64[::1], int64, float64, float64[::1])")
def search_from(task: Task, goal: Goal, near: Floats, k: int, exact: float, end: Floats) -> float:
    """Takes start number k to a solution, inside limits if it can.

    Returns by how much it misses the pose, or infinity where there is none.
    """
    arm, robot, pose, q_free = task
    descents, u = descents_of(arm), np.empty(len(near))
    checked = descents[places.CHECKED] > 0.0  # then the pose may have been rounded
    nearly = descents[places.RESIDUAL] if checked else DOUBTFUL
    enough = descents[places.RESIDUAL] if checked else LOOSE * exact
    copy_row(given_joints(descents, q_free), end)
    start_of(descents, k, near, u)
    if descend(descents, goal, end, u) > nearly:
        return math.inf
    take_units(descents, u, end)
    if checked:
        miss = approach(descents, goal, ROW_STEPS, exact, end)[0]
    else:
        miss = escape(descents, goal, exact, end)
    if miss > enough:
        return math.inf
    if descents[places.ARM_ANGLE] > 0.0:
        off = wrap(arm_angle_at(robot[ARM_ANGLE], end) - q_free[0])
        if abs(off) > 1.0:
            return math.inf  # the elbow is on the other side
    if arm[KEEPS_LIMITS] > 0.0 and arm[CLAMPS] > 0.0 and beyond_limits(arm, end) > 0.0:
        refine(arm, robot, pose, -arm[CLAMPED], math.inf, end)
    return float(miss)


@apart(f"void({TASK}, float64[::1], int64, boolean, float64[:, ::1], uint8[::1])")
def search_lost_rows(
    task: Task, seed: Floats, begun: int, fitted: bool, q: Floats, status: Bytes
) -> None:
    """Searches joint values with less wrong with them than the rows have.

    They are for row `begun`, or for one that has a free joint where only limits are at fault. Of
    rows that were `fitted` to a pose that may be rounded only exact values take the place.
    """
    arm, robot, pose, q_free = task
    descents, goal = descents_of(arm), goal_of(pose, q_free, robot[ARM_ANGLE_MISS])
    exact, near = exactness(descents, goal[0]), in_units(descents, seed)
    before, chosen = least_fault(arm, goal, exact, q, status)
    if before == 0 or (before < IS_MISSING and chosen < 0 and not fitted):
        return
    least, found, end = before, np.zeros(q.shape[1]), np.empty(q.shape[1])
    for k in range(SEARCH_STARTS):
        if least == 0:
            break
        miss = search_from(task, goal, near, k, exact, end)
        wrong = IS_MISSING if math.isinf(miss) else fault(arm, miss, exact, end)
        if wrong < least:
            least = wrong
            copy_row(end, found)
    if least == before or (fitted and least & IS_INEXACT):
        return
    as_exact = before & IS_INEXACT == least & IS_INEXACT
    if arm[KEEPS_LIMITS] > 0.0 and before < IS_MISSING and chosen >= 0 and as_exact:
        copy_row(found, q[chosen])  # other rows are no less exact
        return
    for row in range(len(q)):
        empty_row(row, q, status)
    status[begun] = FREE_JOINT
    copy_row(found, q[begun])
