# SPDX-License-Identifier: MIT
"""Roots that nearly meet.

A row of them may lie between two solutions that differ by anything in a joint that is nearly free.
Steps from it reach one; the root of the other is as far from it on the other side. A row may have
taken the seed's value for its root, which is one of the two and hides the middle: the roots' own
rows have a seed that is turned away.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..angles import wrap
from ..arm import ARM_ANGLE_MISS, SOLVE, descents_of, solve_at
from ..jit import of_file
from ..places import ADDS_OTHERS, ROOT_TURNS
from ..refine import copy_row
from ..retry import TASK
from ..status import CLOSE, OK, UNREACHABLE
from ..tolerances import TOGETHER
from .goal import GOAL, goal_of, in_units
from .other_values import add_other_values
from .refine_rows import ROW_STEPS, SURE, approach, empty_row, exactness, rows_apart
from .solutions import is_same

if TYPE_CHECKING:
    from ..arrays import Bytes, Floats
    from ..retry import Task
    from .goal import Goal

    # What an exact row may miss, a seed that is turned away, the solutions that are known, first
    # those of the other rows, and how many these are.
    Known = tuple[float, Floats, Floats, int]

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

_KNOWN = "Tuple((float64, float64[::1], float64[:, ::1], int64))"

# How far a seed is turned so that no close root takes its value [rad]: beyond a right angle, where
# the hidden root is, and no part of a turn, where others are at home poses.
TURNED_AWAY = 2.0
# How far the root of a row is moved where steps from it reach no solution: to both sides by this
# power of two [rad], then by less and less.
FIRST_POWER, LAST_POWER, POWER_STEP = 15, 39, 3
# Where the other of two solutions is looked for, as parts of the way from their double root to one;
# at none of it where the one came from the seed, and the other may be reached from the root itself.
ACROSS = (0.0, -1.0, -2.0, -0.5, -4.0)


@inner
def is_solution(descents: Floats, goal: Goal, steps: int, exact: float, q: Floats) -> bool:
    """Whether joint values are a solution after so many steps.

    Beside a singular place they may miss the pose by next to nothing and be far from any.
    """
    miss, ahead = approach(descents, goal, steps, exact, q)
    return miss <= exact and ahead <= SURE


@inner
def are_one(descents: Floats, goal: Goal, q: Floats, other: Floats) -> bool:
    """Whether two solutions are one.

    Two that nearly meet are next to each other, too, but between them the pose is missed.
    """
    if rows_apart(descents, q, other) >= TOGETHER:
        return False
    u, v = in_units(descents, q), in_units(descents, other)
    return bool(is_same(descents, goal, q.copy(), u, v, True))


@inner
def is_new(descents: Floats, goal: Goal, known: Floats, count: int, q: Floats) -> bool:
    """Whether a solution is none of the first that are known."""
    new = True
    for k in range(count):
        new = new and not are_one(descents, goal, known[k], q)
    return new


@inner
def add_known(descents: Floats, goal: Goal, known: Floats, count: int, q: Floats) -> int:
    """Adds a solution to the known ones, unless it is one of them; returns their count."""
    if not is_new(descents, goal, known, count, q):
        return count
    copy_row(q, known[count])
    return count + 1


@inner
def solve_away(task: Task, away: Floats, angle: float, q: Floats, kind: Bytes) -> None:
    """Solves with roots moved by an angle, for a seed that is turned away."""
    for row in range(len(kind)):
        kind[row] = UNREACHABLE
    solve_at(task[1][SOLVE], task[2], task[3], away, angle, q, kind)


@apart(f"boolean({TASK}, {GOAL}, {_KNOWN}, float64, int64, float64[::1])")
def leads_elsewhere(
    task: Task, goal: Goal, known: Known, angle: float, row: int, end: Floats
) -> bool:
    """Whether steps from the row of a moved root reach a solution, `end`, that no other row has."""
    descents, (exact, away, solutions, others) = descents_of(task[0]), known
    rows = len(solutions) // 2
    q, kind = np.empty((rows, len(end))), np.empty(rows, np.uint8)
    solve_away(task, away, angle, q, kind)
    if kind[row] == UNREACHABLE or kind[row] > CLOSE:  # lost
        return False
    copy_row(q[row], end)
    solves = is_solution(descents, goal, ROW_STEPS, exact, end)
    return solves and is_new(descents, goal, solutions, others, end)


@inner
def find_doubtful(
    task: Task, goal: Goal, known: Known, own: Floats, q: Floats, status: Bytes, doubtful: Bytes
) -> int:
    """Finds which rows of close roots are no solutions, and what the others are.

    The rows of the roots themselves go into `own`. Returns how many others there are.
    """
    descents, (exact, away, solutions, count) = descents_of(task[0]), known
    kind = np.empty(len(q), np.uint8)
    solve_away(task, away, 0.0, own, kind)
    for row in range(len(q)):
        if kind[row] == UNREACHABLE or kind[row] > CLOSE:  # lost
            copy_row(q[row], own[row])
        doubtful[row] = 0
        if status[row] == CLOSE:
            status[row] = OK
            doubtful[row] = not is_solution(descents, goal, 0, exact, own[row].copy())
        if status[row] != UNREACHABLE and doubtful[row] == 0:
            copy_row(q[row], solutions[count])
            count += 1
    return count


@inner
def find_first(task: Task, goal: Goal, known: Known, row: int, end: Floats) -> bool:
    """Finds a solution from a row: from itself, or from where its root is moved.

    Long steps may reach solutions of other roots, which are known.
    """
    descents, (exact, _, solutions, others) = descents_of(task[0]), known
    solves = is_solution(descents, goal, ROW_STEPS, exact, end)
    if solves and is_new(descents, goal, solutions, others, end):
        return True
    for power in range(FIRST_POWER, LAST_POWER + 1, POWER_STEP):
        for side in (1.0, -1.0):
            if leads_elsewhere(task, goal, known, side * 2.0**-power, row, end):
                return True
    return False


@inner
def root_between(arm: Floats, own: Floats, end: Floats) -> float:
    """How far the root of a solution is from the root of a row [rad]."""
    off = 0.0
    for k in range(0, int(arm[ROOT_TURNS]), 2):
        joint, sign = int(arm[ROOT_TURNS + 1 + k]), arm[ROOT_TURNS + 2 + k]
        off += sign * (end[joint] - own[joint])
    return float(wrap(off))


@inner
def find_other(
    task: Task, goal: Goal, known: Known, count: int, row: int, off: float, end: Floats
) -> int:
    """Finds the other one of two solutions; returns how many are known then."""
    descents, solutions, other = descents_of(task[0]), known[2], np.empty(len(end))
    for part in ACROSS:
        if not leads_elsewhere(task, goal, known, part * off, row, other):
            continue
        if not are_one(descents, goal, end, other):
            return add_known(descents, goal, solutions, count, other)
    return count


@inner
def place_solutions(descents: Floats, known: Known, count: int, q: Floats, status: Bytes) -> None:
    """Puts the solutions that were found into the empty rows, each into that which was nearest."""
    for k in range(known[3], count):
        place, least = -1, math.inf
        for row in range(len(q) - 1, -1, -1):
            empty = math.isnan(q[row, 0])
            gap = math.inf if empty else rows_apart(descents, q[row], known[2][k])
            if status[row] == UNREACHABLE and gap <= least:
                place, least = row, gap
        if place < 0:
            return
        copy_row(known[2][k], q[place])
        status[place] = OK


@apart(f"void({TASK}, float64[::1], float64[:, ::1], uint8[::1])")
def _split_rows(task: Task, seed: Floats, q: Floats, status: Bytes) -> None:
    """Splits the rows of close roots, of which there are some."""
    arm, robot, pose, q_free = task
    rows, dof = q.shape
    descents, goal = descents_of(arm), goal_of(pose, q_free, robot[ARM_ANGLE_MISS])
    away, exact = seed.copy(), exactness(descents, goal[0])
    away[int(arm[ROOT_TURNS + 1])] += TURNED_AWAY
    own, ends, off = np.empty((rows, dof)), np.empty((rows, dof)), np.empty(rows)
    doubtful, solutions = np.empty(rows, np.uint8), np.empty((2 * rows, dof))
    known = exact, away, solutions, 0
    count = find_doubtful(task, goal, known, own, q, status, doubtful)
    known = exact, away, solutions, count
    for row in range(rows):
        copy_row(q[row], ends[row])
        if doubtful[row] == 0 or not find_first(task, goal, known, row, ends[row]):
            doubtful[row] = 0
            continue
        status[row] = UNREACHABLE
        count = add_known(descents, goal, solutions, count, ends[row])
        off[row] = root_between(arm, own[row], ends[row])
        count = find_other(task, goal, known, count, row, off[row], ends[row])
    place_solutions(descents, known, count, q, status)
    for row in range(rows if arm[ADDS_OTHERS] > 0.0 else 0):
        if doubtful[row] > 0:
            add_other_values(task, ends[row], off[row], OK, q, status)
    for row in range(rows):
        if status[row] == UNREACHABLE:
            empty_row(row, q, status)


@inner
def split_close_roots(task: Task, seed: Floats, q: Floats, status: Bytes) -> None:
    """Splits the rows of close roots into the solutions that they lie between."""
    for row in range(len(status)):
        if status[row] == CLOSE:
            _split_rows(task, seed, q, status)
            return
