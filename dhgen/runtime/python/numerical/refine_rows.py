# SPDX-License-Identifier: MIT
"""Rows that miss their pose, taken to solutions by least squares."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..arm import ARM_ANGLE_MISS, descents_of, miss_at
from ..jit import of_file
from ..refine import copy_row, missed_by
from ..retry import TASK
from ..rigid import take
from ..status import UNREACHABLE
from ..tolerances import DOUBTFUL, EXACT, FINE
from .descent import damped_step, measure_miss, shorten, sideways, wrap_angles
from .goal import GOAL, goal_of, in_units, take_units
from .places import (
    ARM_ANGLE,
    CHECKED,
    COORDINATE,
    COORDINATES,
    EQUATIONS,
    PLACE,
    RECORD,
    RESIDUAL,
    SIZE,
    SOLVED,
    UNIT,
)
from .solutions import SAME, SINGULAR

if TYPE_CHECKING:
    from ..arrays import Bytes, Floats
    from ..retry import Task
    from .goal import Goal

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

# Steps of a row that is not exact. Double roots take a quarter off with each; beside a singular
# place a joint that is nearly free may be anywhere, and three steps are one of it.
ROW_STEPS = 72
# Where many solutions meet the steps end on singular joint values and get slow. They go on from
# both sides of these, as often as this, while less than this part of the miss is left.
ESCAPES = 8
STUCK = 0.9
# Steps that miss by less than this part of what counts as exact have come to an end.
SPARE = 1e-3
# A row whose step is longer than this is not known yet: the step may reach another solution [rad,
# arm sizes].
SURE = 1e-4
# The least miss of a pose that is rounded is found where steps are no longer than this [rad, arm
# sizes]: far above their rounding, far below the distance of two solutions.
SETTLED = 1e-9
# So many times what counts as exact is still a solution. So many times what a solution may miss a
# rounded pose by is not far from one.
LOOSE = 10.0


@inner
def exactness(descents: Floats, T: Floats) -> float:
    """What an exact row may miss: far away rounding is more [arm sizes, rad]."""
    distance = 1.0  # arm sizes
    for i in range(int(descents[COORDINATES])):
        distance = max(distance, abs(T[int(descents[COORDINATE + i]), 3]) / descents[SIZE])
    return EXACT * distance


@apart(f"UniTuple(float64, 2)(float64[::1], {GOAL}, int64, float64, float64[::1])")
def approach(
    descents: Floats, goal: Goal, steps: int, exact: float, q: Floats
) -> tuple[float, float]:
    """Takes the joint values of a row as far as steps help.

    Returns by how much the row misses the pose then, and how long another step would be. Beside a
    singular place a step that is right may be long, and what it leaves, half of its square, far
    more than was missed.
    """
    solved, equations = int(descents[SOLVED]), int(descents[EQUATIONS])
    e, A = np.empty(equations), np.empty((equations, solved))
    joints, u, step = q.copy(), in_units(descents, q), np.empty(solved)
    best, least, ahead = u.copy(), math.inf, math.inf
    last, left = math.inf, 0.0  # the miss before a step, and what its curvature leaves
    for _ in range(steps + 1):
        length = measure_miss(descents, goal, joints, u, e, A)
        damped_step(A, e, length, FINE, step)
        slow = not length <= max(0.5 * last, left)
        if length < least:
            least, ahead = length, 0.0
            take(best, u)
            for j in range(solved):
                ahead = max(ahead, abs(step[j]))
        if slow or (least <= SPARE * exact and ahead <= SURE):
            break
        shorten(step)
        way = 0.0
        for j in range(solved):
            u[j] += step[j]
            way += abs(step[j])
        last, left = length, 0.5 * way * way
    wrap_angles(descents, best)
    take_units(descents, best, q)
    return least, ahead


@apart(f"float64(float64[::1], {GOAL}, float64[::1])")
def least_miss(descents: Floats, goal: Goal, q: Floats) -> float:
    """Takes the joint values of a row to the least miss of a pose that is rounded.

    That does not vanish. Returns by how much the row misses the pose then.
    """
    solved, equations = int(descents[SOLVED]), int(descents[EQUATIONS])
    e, A = np.empty(equations), np.empty((equations, solved))
    joints, u, step = q.copy(), in_units(descents, q), np.empty(solved)
    best, least, ahead = u.copy(), math.inf, math.inf
    for _ in range(ROW_STEPS):
        if ahead <= SETTLED:
            break
        length = measure_miss(descents, goal, joints, u, e, A)
        if not length < least:
            break
        least, ahead = length, 0.0
        take(best, u)
        damped_step(A, e, length, FINE, step)
        for j in range(solved):
            ahead = max(ahead, abs(step[j]))
        shorten(step)
        for j in range(solved):
            u[j] += step[j]
    wrap_angles(descents, best)
    take_units(descents, best, q)
    return least


@apart(f"float64(float64[::1], {GOAL}, float64, float64[::1])")
def escape(descents: Floats, goal: Goal, exact: float, q: Floats) -> float:
    """Takes a row as far as steps help, also from both sides of where they get slow.

    Where many solutions meet, joint values between them are singular. A root of four is missed by
    the fourth power of the way to it. Returns by how much the row misses the pose then.
    """
    solved, equations = int(descents[SOLVED]), int(descents[EQUATIONS])
    e, A, along = np.empty(equations), np.empty((equations, solved)), np.empty(solved)
    ends, miss = np.empty((2, len(q))), np.empty(2)
    least = approach(descents, goal, ROW_STEPS, exact, q)[0]
    for _ in range(ESCAPES):
        if least <= exact:
            break
        measure_miss(descents, goal, q.copy(), in_units(descents, q), e, A)
        if sideways(descents, A, along) <= SINGULAR:
            break
        pace = math.sqrt(math.sqrt(least))
        for side in range(2):
            copy_row(q, ends[side])
            for j in range(solved):
                at = RECORD * j
                ends[side, int(descents[PLACE + at])] += pace * descents[UNIT + at] * along[j]
            pace = -pace
            miss[side] = approach(descents, goal, ROW_STEPS, exact, ends[side])[0]
        other = 1 if miss[1] < miss[0] else 0
        if not miss[other] < STUCK * least:
            break
        least = miss[other]
        copy_row(ends[other], q)
    return least


@inner
def refine_row(
    descents: Floats, goal: Goal, exact: float, first: float, q: Floats
) -> tuple[float, bool]:
    """Refines a row by least squares, unless it is exact.

    Where the task names more than the joints can choose, a row that can't be exact is kept if it
    misses the pose by no more than that may be rounded by; if it misses it by more it is taken to
    the least miss: equations that hold few digits of a joint make far more of the rounding. Returns
    by how much the row misses the pose then, `first` being what it misses before, and whether it
    was moved.
    """
    if first <= exact:
        return first, False
    if descents[ARM_ANGLE] > 0.0:
        off = np.empty(4)
        miss_at(goal[2], goal[0], goal[1], q, off)
        if abs(off[0]) > DOUBTFUL:
            return math.inf, False  # out of reach: not a matter of rounding
    end, moved = q.copy(), False
    if descents[CHECKED] > 0.0:
        least = approach(descents, goal, ROW_STEPS, exact, end)[0]
        residual = descents[RESIDUAL]
        may_fit = first > residual and least <= LOOSE * residual
        if least > exact and may_fit:  # the pose may be rounded
            least = least_miss(descents, goal, end)
        if least > exact and not (may_fit and least <= residual):
            return first, False
    else:
        least = escape(descents, goal, exact, end)
    for i in range(len(q)):
        moved = moved or q[i] != end[i]
        q[i] = end[i]
    return least, moved


@inner
def rows_apart(descents: Floats, q: Floats, other: Floats) -> float:
    """By how much two rows differ at most, whole turns aside [rad, arm sizes]."""
    gap, widest = np.empty(int(descents[SOLVED])), 0.0
    for j in range(len(gap)):
        at = RECORD * j
        place = int(descents[PLACE + at])
        gap[j] = (q[place] - other[place]) / descents[UNIT + at]
    wrap_angles(descents, gap)
    for j in range(len(gap)):
        widest = max(widest, abs(gap[j]))
    return widest


@inner
def repeats(descents: Floats, q: Floats, first: Floats, row: int) -> bool:
    """Whether a row that was moved came to lie on one that missed by less at first."""
    for k in range(len(q)):
        before = first[k] < first[row] or (k < row and first[k] <= first[row])
        if before and not math.isnan(q[k, 0]) and rows_apart(descents, q[k], q[row]) < SAME:
            return True
    return False


@inner
def enough_in_rows(descents: Floats, miss: Floats, exact: float) -> float:
    """What a row may miss in the end.

    Where the task names more than the joints can choose, and one row is exact, the pose has not
    been rounded, and all have to be exact.
    """
    if descents[CHECKED] == 0.0:
        return LOOSE * exact
    least = math.inf
    for row in range(len(miss)):
        least = min(least, miss[row])
    residual: float = descents[RESIDUAL]
    return exact if least <= exact else residual


@inner
def empty_row(row: int, q: Floats, status: Bytes) -> None:
    """Empties a row: it has no solution."""
    status[row] = UNREACHABLE
    for i in range(q.shape[1]):
        q[row, i] = math.nan


@apart(f"boolean({TASK}, float64[:, ::1], uint8[::1])")
def refine_rows(task: Task, q: Floats, status: Bytes) -> bool:
    """Refines the rows of a pose.

    Empties those that miss the pose then, and all but one of those that have become one solution.
    Returns whether there are rows that missed the pose by more than it may be rounded by, and miss
    it by less now.
    """
    arm, robot, pose, q_free = task
    descents, goal = descents_of(arm), goal_of(pose, q_free, robot[ARM_ANGLE_MISS])
    exact, rows = exactness(descents, goal[0]), len(q)
    first, miss = np.full(rows, math.inf), np.full(rows, math.inf)
    moved = np.zeros(rows, np.bool_)
    for row in range(rows):
        if status[row] != UNREACHABLE:
            first[row] = missed_by(arm, robot, pose, q[row])
            miss[row], moved[row] = refine_row(descents, goal, exact, first[row], q[row])
    enough = enough_in_rows(descents, miss, exact)
    for row in range(rows):
        if miss[row] > enough:
            q[row, 0] = math.nan
    fitted, checked = False, descents[CHECKED] > 0.0
    for row in range(rows):
        if math.isnan(q[row, 0]) or (moved[row] and repeats(descents, q, first, row)):
            empty_row(row, q, status)
        elif checked and miss[row] > exact and first[row] > descents[RESIDUAL]:
            fitted = True
    return fitted
