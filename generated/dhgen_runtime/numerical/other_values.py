# SPDX-License-Identifier: MIT
"""Rows for the other values of joints whose equation is degenerate.

The rest of the pose leaves such a joint several values, each of them alone.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..arm import ARM_ANGLE_MISS, descents_of
from ..jit import of_file
from ..places import ASCENDS, CHOOSABLE
from ..refine import copy_row
from ..retry import FOUND, HALF_FAN, SEARCH, TASK, attempt, fan, summit, works
from ..status import FREE_JOINT, UNREACHABLE
from ..tolerances import TOGETHER
from .goal import goal_of
from .refine_rows import ROW_STEPS, approach, exactness, rows_apart

if TYPE_CHECKING:
    from ..arrays import Bytes, Floats
    from ..retry import Found, Search, Task

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

# Values that are tried beside one that works, to each side: first these, each farther by the root
# of 2, so that what is missed between it and another one that works shows both, however near they
# are; then as many as of any free joint.
CLOSE_FAN = 20
WHOLE_FAN = CLOSE_FAN + HALF_FAN


@inner
def fan_value(arm: Floats, joint: int, k: int) -> float:
    """How far value number k of a fan is from its middle: beside it they lie closer."""
    if k == 0:
        return 0.0
    step, far = fan(arm, joint), abs(k) - CLOSE_FAN
    return math.copysign(step * far if far > 0 else step * 2.0 ** (0.5 * far - 0.5), k)


@inner
def is_alone(task: Task, search: Search, seed: Floats, values: Floats, found: Found) -> bool:
    """Whether the row that is searched has joint values, and to both sides of them none as good."""
    arm, (row, joint, _, _) = task[0], search
    own = attempt(task, search, seed, 0.0, found)
    if not works(task, search, found):
        return False
    if not rows_apart(descents_of(arm), found[0][row], values) < TOGETHER:
        return False
    before = attempt(task, search, seed, fan_value(arm, joint, -1), found)
    return before < own and attempt(task, search, seed, fan_value(arm, joint, 1), found) < own


@apart(f"int64({TASK}, {SEARCH}, float64[::1], {FOUND}, float64[:, ::1], int64)")
def search_fan(
    task: Task, search: Search, seed: Floats, found: Found, others: Floats, count: int
) -> int:
    """Finds the other values of the joint that is searched, as rows behind the `count` known ones.

    Returns how many rows there are then.
    """
    arm, robot, pose, q_free = task
    row, joint, _, _ = search
    descents, goal = descents_of(arm), goal_of(pose, q_free, robot[ARM_ANGLE_MISS])
    exact = exactness(descents, goal[0])
    here, after = -math.inf, -math.inf
    for k in range(-WHOLE_FAN, WHOLE_FAN + 1):
        before, here = here, after
        after = attempt(task, search, seed, fan_value(arm, joint, k + 1), found)
        if k == 0 or before == 0.0 or not (here >= before and here > after):
            continue
        moved = fan_value(arm, joint, k)
        if here < 0.0:
            low, high = fan_value(arm, joint, k - 1), fan_value(arm, joint, k + 1)
            moved = summit(task, search, seed, low, high, found)
        attempt(task, search, seed, moved, found)
        if math.isnan(moved) or not works(task, search, found) or count == len(others):
            continue
        # next to where the equation is degenerate its last digits are wrong
        copy_row(found[0][row], others[count])
        miss, _ = approach(descents, goal, ROW_STEPS, exact, others[count])
        count += 1 if miss <= exact else 0
    return count


@inner
def find_other_values(task: Task, values: Floats, by: float, others: Floats) -> int:
    """Finds solutions with other values of a joint than a row has.

    `by` is how far the root of the row is moved. Returns how many.
    """
    arm, count = task[0], 0
    found = np.empty(others.shape), np.empty(len(others), np.uint8)
    joints = int(arm[CHOOSABLE])
    for branch in range(len(others) * joints):
        joint = int(arm[CHOOSABLE + 1 + branch % joints])
        search, seed = (branch // joints, joint, False, by), values.copy()
        if is_alone(task, search, seed, values, found):
            count = search_fan(task, search, seed, found, others, count)
    return count


@inner
def join_row(
    arm: Floats, values: Floats, other: Floats, kind: int, q: Floats, status: Bytes
) -> None:
    """Gives a solution a row, unless it has one.

    It lies next to that of another solution, as their roots are one where rows are the roots of a
    polynomial.
    """
    descents, row, place = descents_of(arm), -1, -1
    for k in range(len(q)):
        if status[k] == UNREACHABLE:
            place = k if place < row or row < 0 else place
        elif rows_apart(descents, values, q[k]) < TOGETHER:
            return
        elif rows_apart(descents, other, q[k]) < TOGETHER:
            row = k
    if place < 0:
        return
    while arm[ASCENDS] > 0.0 and row >= 0 and place not in (row, row + 1):
        after = place - 1 if place > row else place + 1
        copy_row(q[after], q[place])
        status[place], place = status[after], after
    copy_row(values, q[place])
    status[place] = kind


@apart(f"void({TASK}, float64[::1], float64, int64, float64[:, ::1], uint8[::1])")
def add_other_values(
    task: Task, values: Floats, by: float, kind: int, q: Floats, status: Bytes
) -> None:
    """Adds rows for the solutions with other values of a joint than `values`.

    `by` is how far the root of these is moved.
    """
    others = np.empty(q.shape)
    for k in range(find_other_values(task, values, by, others)):
        join_row(task[0], others[k], values, kind, q, status)


@apart(f"void({TASK}, float64[:, ::1], uint8[::1])")
def add_others(task: Task, q: Floats, status: Bytes) -> None:
    """Adds rows for the other values of joints that the solver chose freely."""
    rows, kinds = q.copy(), status.copy()
    for row in range(len(q)):
        if kinds[row] == FREE_JOINT:
            add_other_values(task, rows[row], 0.0, FREE_JOINT, q, status)
