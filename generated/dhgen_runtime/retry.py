# SPDX-License-Identifier: MIT
"""Other values of free joints: the solver took the seed's, and they don't reach, or keep limits.

Three tuples and a seed go through these functions. `task` is the arm's numbers, the robot, the pose
and the values that the caller gives; `search` a row, the joint that is moved, whether limits count,
and by how much roots are moved; `found` the rows of the last attempt, and what they hold.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .arm import POSE, ROBOT, SOLVE, solve_at
from .jit import of_file
from .limits import beyond_limits, overshoot
from .places import (
    CHECKS,
    CHOOSABLE,
    CUTS,
    DOF,
    FAN_STEP,
    KEEPS_LIMITS,
    RECORD,
    RETRIES,
    ROWS,
    TOGETHER,
    TURNS,
)
from .refine import copy_row, missed_by
from .status import FREE_JOINT, LOST, NEARLY, UNREACHABLE
from .tolerances import APART_BY, FREE, LIMIT
from .turns import without_turns

if TYPE_CHECKING:
    from .arm import Pose, Robot
    from .arrays import Bytes, Floats

    Task = tuple[Floats, Robot, Pose, Floats]
    Search = tuple[int, int, bool, float]
    Found = tuple[Floats, Bytes]

OWN = of_file(__file__)

TASK = f"Tuple((float64[::1], {ROBOT}, {POSE}, float64[::1]))"
SEARCH = "Tuple((int64, int64, boolean, float64))"
FOUND = "Tuple((float64[:, ::1], uint8[::1]))"
ATTEMPTS = f"{TASK}, {SEARCH}, float64[::1]"

HALF_FAN = 32  # values of a free joint that are tried to each side of the first
# How far a joint is moved whose angle has few digits [rad]: from rounding, doubled again and again.
LEAST_MOVE, MOST_MOVE = 1e-15, 0.1
HALVINGS = 52  # until an interval of a turn is as small as rounding
GOLDEN = 0.3819660112501051  # where an interval is cut: (3 - root of 5) / 2
TURNS_TOGETHER = 12  # of joints that may have to be chosen together
ELSEWHERE = 0.1  # how far a joint is moved to see which others move with it [rad or length]


@OWN.inner
def works(task: Task, search: Search, found: Found) -> bool:
    """Whether the row was solved, as exactly as poses may be rounded."""
    row = search[0]
    if search[2] and beyond_limits(task[0], found[0][row]) > 0.0:
        return False
    kind = int(found[1][row])
    return kind != UNREACHABLE and kind < LOST


@OWN.inner
def shortfall(task: Task, row: int, found: Found) -> float:
    """How far a row is from a solution: 0 if it is solved, else less.

    One that misses the pose, be it by less than is allowed, is nearer than any out of reach.
    """
    arm, robot, pose, _ = task
    q, status = found
    ended = status[row] >= LOST
    if status[row] == UNREACHABLE:
        return -math.inf
    noted = float(q[row, 0])
    if arm[CHECKS] == 0.0:
        return noted if ended else 0.0
    if ended and noted < 0.0:
        return noted - 1.0
    miss = noted if ended else missed_by(arm, robot, pose, q[row])
    return 0.0 if miss <= FREE else -miss / (1.0 + miss)


@OWN.apart(f"float64({ATTEMPTS}, float64, {FOUND})")
def attempt(task: Task, search: Search, seed: Floats, moved: float, found: Found) -> float:
    """Solves with the joint moved. Returns 0 if that solves the row, else less."""
    arm, robot, pose, q_free = task
    row, joint, within, by = search
    q, status = found
    for i in range(len(status)):
        status[i] = UNREACHABLE
    kept = seed[joint]
    seed[joint] = kept + moved
    solve_at(robot[SOLVE], pose, q_free, seed, by, q, status)
    seed[joint] = kept
    result = shortfall(task, row, found)
    return -beyond_limits(arm, q[row]) if within and result == 0.0 else result


@OWN.inner
def _peak(task: Task, search: Search, seed: Floats, low: float, high: float, found: Found) -> float:
    """The move between two that comes nearest, or one that works, by golden section."""
    for _ in range(int(task[0][CUTS])):
        third = GOLDEN * (high - low)
        left = attempt(task, search, seed, low + third, found)
        right = attempt(task, search, seed, high - third, found)
        if left == 0.0 or right == 0.0:
            return low + third if left == 0.0 else high - third
        if left >= right:
            high -= third
        else:
            low += third
    return low


@OWN.apart(f"float64({ATTEMPTS}, float64, float64, {FOUND})")
def summit(
    task: Task, search: Search, seed: Floats, low: float, high: float, found: Found
) -> float:
    """A move between two that works, by golden section, or NaN."""
    top = _peak(task, search, seed, low, high, found)
    if attempt(task, search, seed, top, found) == 0.0:
        return top
    if task[0][RETRIES] == 0.0:
        return math.nan
    # beside a place where the branches meet, this one has no solution of its own
    for moved in (top - LIMIT, top + LIMIT):
        if math.isinf(attempt(task, search, seed, moved, found)):
            return math.nan
    attempt(task, search, seed, top, found)
    return top if works(task, search, found) else math.nan


@OWN.inner
def _nearest_end(
    task: Task, search: Search, seed: Floats, inner: float, outer: float, found: Found
) -> float:
    """The end of values that work, between a move that may not and one that does, by bisection."""
    for _ in range(HALVINGS):
        middle = 0.5 * (inner + outer)
        if attempt(task, search, seed, middle, found) == 0.0:
            outer = middle
        else:
            inner = middle
    return outer


@OWN.inner
def fan(arm: Floats, joint: int) -> float:
    """From one value of a joint that is tried to the next."""
    step: float = arm[FAN_STEP + RECORD * joint]
    return step


@OWN.apart(f"float64({ATTEMPTS}, {FOUND})")
def _working_value(task: Task, search: Search, seed: Floats, found: Found) -> float:
    """How far a free joint has to be moved from the seed's value until it works, or NaN.

    A fan of values shows where it works or nearly so, golden section finds what lies between two of
    them, bisection the end that is nearest to the seed; of two that are equally near the lower one;
    one that is exact comes before all others.
    """
    if attempt(task, search, seed, 0.0, found) == 0.0:
        return 0.0
    step, nearest, here, exactly = fan(task[0], search[1]), math.nan, -math.inf, False
    after = attempt(task, search, seed, -HALF_FAN * step, found)
    for k in range(-HALF_FAN, HALF_FAN + 1):
        before, here = here, after
        after = attempt(task, search, seed, (k + 1) * step, found)
        outer = k * step
        inner = outer - step if k > 0 else outer + step if k < 0 else 0.0
        if here < 0.0 and here >= before and here > after:
            outer = summit(task, search, seed, outer - step, outer + step, found)
            if math.isnan(outer):
                continue
        elif here < 0.0 or (before if k > 0 else after) == 0.0:
            continue
        if task[0][CHECKS] > 0.0:
            exact = attempt(task, search, seed, outer, found) == 0.0
            if exactly and not exact:
                continue
            if exact and not exactly:
                nearest = math.nan
            exactly = exact
        outer = _nearest_end(task, search, seed, inner, outer, found)
        if not abs(outer) >= abs(nearest) - LIMIT:
            nearest = outer
    return nearest


@OWN.inner
def _working_digits(task: Task, search: Search, seed: Floats, found: Found) -> float:
    """How far a joint has to be moved that is nearly free, or NaN: its angle has few digits.

    Also where the arm just reaches (an elbow that is stretched). As long as the angle is right up
    to rounding of what it was taken from, the solver takes it as it would take its own.
    """
    before, past = np.full(2, -math.inf), np.zeros(2)
    moved = LEAST_MOVE
    while moved < MOST_MOVE:
        for way in range(2):
            there = -moved if way else moved
            here = attempt(task, search, seed, there, found)
            if here == 0.0:
                return there
            if here < 2.0 * before[way] and past[way] == 0.0:
                past[way] = 1.0
                top = summit(task, search, seed, 0.25 * there, there, found)
                if not math.isnan(top):
                    return top
            before[way] = here
        moved *= 2.0
    return math.nan


@OWN.inner
def _nearest_miss(task: Task, search: Search, seed: Floats, found: Found) -> float:
    """How far a free joint has to be moved until the arm comes nearest to its pose."""
    step = fan(task[0], search[1])
    first = attempt(task, search, seed, 0.0, found)
    best, at = first, 0.0
    for k in range(-HALF_FAN, HALF_FAN + 1):
        here = attempt(task, search, seed, k * step, found)
        if here > best:
            best, at = here, k * step
    at = _peak(task, search, seed, at - step, at + step, found)
    return at if attempt(task, search, seed, at, found) > first else 0.0


@OWN.inner
def _working_together(
    task: Task, search: Search, seed: Floats, found: Found
) -> tuple[Search, float]:
    """Several joints are free, and none works by itself: the search and the move that do.

    In turn each is moved to where the arm comes nearest, until one works.
    """
    arm = task[0]
    for k in range(TURNS_TOGETHER):
        moved = _nearest_miss(task, search, seed, found)
        if k > 0 and moved == 0.0:
            break
        seed[search[1]] += moved
        search = search[0], int(arm[TOGETHER + 1 + k % int(arm[TOGETHER])]), False, 0.0
        moved = _working_value(task, search, seed, found)
        if not math.isnan(moved):
            return search, moved
    return search, math.nan


@OWN.inner
def _first_value(arm: Floats, joint: int, value: float) -> float:
    """Where the values of a joint begin that are tried: angles in the first turn, slides inside.

    A slide is tried as far as its stroke, and so from inside.
    """
    if arm[TURNS + RECORD * joint] > 0.0:
        return without_turns(value)
    return value - overshoot(arm, joint, value) if arm[KEEPS_LIMITS] > 0.0 else value


@OWN.apart(
    f"void(float64[::1], {ROBOT}, {POSE}, float64[::1], float64[::1], int64, float64[:, ::1], "
    "uint8[::1])"
)
def retry_free_joint(
    arm: Floats,
    robot: Robot,
    pose: Pose,
    q_free: Floats,
    given: Floats,
    row: int,
    q: Floats,
    status: Bytes,
) -> None:
    """Retries a row that was lost after a joint had been chosen: another value, if one works."""
    nearly = status[row] > NEARLY
    task, seed, found = (arm, robot, pose, q_free), given.copy(), (q.copy(), status.copy())
    joint = int(status[row]) - (NEARLY if nearly else LOST) - 1
    search = row, joint, False, 0.0
    if nearly:
        seed[joint] = q[row, 1]
        moved = _working_digits(task, search, seed, found)
    else:
        seed[joint] = _first_value(arm, joint, seed[joint])
        moved = _working_value(task, search, seed, found)
        if math.isnan(moved) and arm[TOGETHER] > 0.0:
            search, moved = _working_together(task, search, seed, found)
    attempt(task, search, seed, moved, found)
    worked = not math.isnan(moved) and works(task, search, found)
    status[row] = found[1][row] if worked else UNREACHABLE
    for i in range(int(arm[DOF])):
        q[row, i] = found[0][row, i] if worked else math.nan


@OWN.inner
def _is_hopeless(task: Task, search: Search, seed: Floats, found: Found) -> bool:
    """Whether a joint beyond its limits is fixed while the one that is searched moves."""
    row = search[0]
    attempt(task, search, seed, 0.0, found)
    if shortfall(task, row, found) < 0.0:
        return False
    values = found[0][row].copy()
    attempt(task, search, seed, ELSEWHERE, found)
    if shortfall(task, row, found) < 0.0:
        return False
    for i in range(len(values)):
        still = abs(values[i] - found[0][row, i]) < LIMIT
        if still and overshoot(task[0], i, values[i]) != 0.0:
            return True
    return False


@OWN.apart(
    f"void(float64[::1], {ROBOT}, {POSE}, float64[::1], float64[::1], int64, float64[:, ::1], "
    "uint8[::1])"
)
def keep_limits(
    arm: Floats,
    robot: Robot,
    pose: Pose,
    q_free: Floats,
    given: Floats,
    row: int,
    q: Floats,
    status: Bytes,
) -> None:
    """Retries a row where a free joint took the seed's value, and that puts one beyond its limits.

    It takes the nearest value that keeps all of them, if there is one. Where several joints are
    free the others take the seed's values as far as their limits allow.
    """
    task, seed, found = (arm, robot, pose, q_free), given.copy(), (q.copy(), status.copy())
    for i in range(int(arm[DOF])):
        seed[i] -= overshoot(arm, i, seed[i])
    for k in range(int(arm[CHOOSABLE])):
        joint = int(arm[CHOOSABLE + 1 + k])
        inside, search = seed[joint], (row, joint, True, 0.0)
        if arm[TURNS + RECORD * joint] > 0.0:
            seed[joint] = without_turns(given[joint])
        if not _is_hopeless(task, search, seed, found):
            moved = _working_value(task, search, seed, found)
            # beside the solution of another row this one has none
            start = attempt(task, search, seed, 0.0, found)
            own = abs(moved) >= APART_BY or not math.isinf(start)
            if own and not math.isnan(moved):
                attempt(task, search, seed, moved, found)
                copy_row(found[0][row], q[row])
                status[row] = found[1][row]
                return
        seed[joint] = inside


@OWN.inner
def retry_rows(
    arm: Floats,
    robot: Robot,
    pose: Pose,
    q_free: Floats,
    seed: Floats,
    q: Floats,
    status: Bytes,
) -> None:
    """Retries the rows that the seed's values of free joints don't solve."""
    for row in range(int(arm[ROWS])):
        if arm[RETRIES] > 0.0 and status[row] >= LOST:
            retry_free_joint(arm, robot, pose, q_free, seed, row, q, status)
        chosen = arm[KEEPS_LIMITS] > 0.0 and status[row] == FREE_JOINT
        if chosen and beyond_limits(arm, q[row]) > 0.0:
            keep_limits(arm, robot, pose, q_free, seed, row, q, status)
