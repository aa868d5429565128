# SPDX-License-Identifier: MIT
"""All solutions of any pose, singular ones too, with the steps around a robot's formulas."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .arm import POSE, ROBOT, SOLVE, solve_at
from .clamp import clamp_to_limits
from .complete import complete_rows
from .duplicates import remove_duplicates
from .follow_seed import follow_seed
from .jit import of_file
from .limits import at_an_end
from .places import (
    CLAMPED,
    CLAMPED_AGAIN,
    CLAMPS,
    CLAMPS_FAR,
    COMPLETES,
    DOF,
    FOLLOWS_SEED,
    HIGHEST,
    LOWEST,
    MERGES,
    RANGE_EXCEEDS_A_TURN,
    RECORD,
    ROWS,
)
from .refine import moves
from .retry import retry_rows
from .status import FREE_JOINT, OUT_OF_LIMITS, UNREACHABLE
from .turns import turned

if TYPE_CHECKING:
    from .arm import Pose, Robot
    from .arrays import Bytes, Floats

OWN = of_file(__file__)


@OWN.inner
def _solve_rows(
    arm: Floats,
    robot: Robot,
    pose: Pose,
    q_free: Floats,
    seed: Floats,
    q: Floats,
    status: Bytes,
) -> None:
    """Fills the rows of a pose, before any of them is clamped to limits."""
    rows, dof = int(arm[ROWS]), int(arm[DOF])
    solve_at(robot[SOLVE], pose, q_free, seed, 0.0, q, status)
    begun = -1
    for row in range(rows - 1, -1, -1):
        if status[row] != UNREACHABLE:
            begun = row
    retry_rows(arm, robot, pose, q_free, seed, q, status)
    if arm[COMPLETES] > 0.0:
        complete_rows(arm, robot, pose, q_free, seed, begun, q, status)
    if arm[MERGES] > 0.0:
        remove_duplicates(arm, robot, pose, q, status)
    for row in range(rows if arm[RANGE_EXCEEDS_A_TURN] > 0.0 else 0):
        for i in range(dof if status[row] != UNREACHABLE else 0):
            q[row, i] = at_an_end(arm, i, q[row, i], seed[i])
    if arm[FOLLOWS_SEED] > 0.0:
        follow_seed(arm, robot, pose, q_free, seed, q, status)


@OWN.inner
def _turn_inside(arm: Floats, q: Floats) -> bool:
    """Turns the joints of a row inside their limits; returns whether all are."""
    inside, from_zero = True, arm[CLAMPS] + arm[FOLLOWS_SEED] > 0.0
    for i in range(len(q)):
        q[i] = turned(arm, i, q[i], 0.0 if from_zero and moves(arm, i) else q[i])
        at = RECORD * i
        inside = inside and arm[LOWEST + at] <= q[i] <= arm[HIGHEST + at]
    return inside


@OWN.inner
def _end_rows(arm: Floats, robot: Robot, pose: Pose, q: Floats, status: Bytes) -> int:
    """Clamps rows to limits, and again where none is inside; returns how many are."""
    rows, count = int(arm[ROWS]), 0
    twice = arm[CLAMPS_FAR] > 0.0 or arm[CLAMPED_AGAIN] > arm[CLAMPED]
    for n in range(2 * rows if twice else rows):
        row, again = n % rows, n >= rows
        if status[row] == UNREACHABLE or (again and count > 0):
            continue
        if arm[CLAMPS] > 0.0 and clamp_to_limits(arm, robot, pose, row, again, q, status) and again:
            status[row] = FREE_JOINT
        if not _turn_inside(arm, q[row]):
            status[row] = OUT_OF_LIMITS
        if status[row] != OUT_OF_LIMITS:
            count += 1
    return count


@OWN.apart(
    f"int64(float64[::1], {ROBOT}, {POSE}, float64[::1], float64[::1], float64[:, ::1], uint8[::1])"
)
def careful_ik(
    arm: Floats,
    robot: Robot,
    pose: Pose,
    q_free: Floats,
    seed: Floats,
    q: Floats,
    status: Bytes,
) -> int:
    """All solutions of a pose into q and status; returns how many are inside limits.

    Args:
        arm: The arm's numbers.
        robot: Its functions, by their addresses.
        pose: The upper three rows of a valid pose.
        q_free: Values that the caller gives.
        seed: Values for joints that are indeterminate.
        q: Is filled, a row for each branch.
        status: Is filled with what each row holds.
    """
    for row in range(int(arm[ROWS])):
        status[row] = UNREACHABLE
        for i in range(int(arm[DOF])):
            q[row, i] = math.nan
    _solve_rows(arm, robot, pose, q_free, seed, q, status)
    return _end_rows(arm, robot, pose, q, status)
