# SPDX-License-Identifier: MIT
"""The rows of a general arm: what the loop's solutions are for it, and what descents add.

Where it is not certain that the loop's solutions are all, descents refine them, and some more
starts are tried: solutions that meet are distinct only if they are exact.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from ..numerical.descent import descend, start_of, wrap_angles
from ..numerical.goal import NO_ARM_ANGLE, given_joints, goal_of, in_units
from ..numerical.keep import keep
from ..numerical.pairs import complete_pairs
from ..numerical.places import (
    CHECKED,
    DOF,
    DRIVES,
    FACING,
    PLACE,
    RECORD,
    RESIDUAL,
    ROWS,
    SOLVED,
    UNIT,
    ZERO,
)
from ..numerical.solutions import sort_rows
from ..rigid import take
from ..status import UNREACHABLE
from ..tolerances import EXACT
from .candidates import PLACES
from .places import POINTING_LOOP
from .search import solve_loop

if TYPE_CHECKING:
    from ..arm import Pose
    from ..arrays import Bytes, Floats, Ints
    from ..numerical.goal import Goal
    from ..numerical.solutions import Ahead

OWN = of_file(__file__)
apart, inner, jit = OWN.apart, OWN.inner, OWN.jit

# Descents, the seed's among them, besides what the algorithm finds where that is not certainly
# everything.
STARTS = 12
# An angle above this [rad] of a turn that the arm does not have belongs to a pose that it does not
# take: rounding of a pose, as far as it is accepted, is a thousand times less, and the angle is
# more only where the arm is nearly singular. Where the certificate fails, or solutions meet, it may
# be: then the second bound holds.
NEARLY_NONE = 0.01
NEARLY_NONE_IN_DOUBT = 0.1


@inner
def any_turn(T: Floats, flat: Floats) -> None:
    """Replaces the first columns of a pose by any that fit its z axis, where the tool only points.

    T. Duff et al., Building an orthonormal basis, revisited (2017).
    """
    x, y, z = T[0, 2], T[1, 2], T[2, 2]
    side = math.copysign(1.0, z)
    a = -1.0 / (side + z)
    flat[0], flat[4], flat[8] = 1.0 + side * x * x * a, side * x * y * a, -side * x
    flat[1], flat[5], flat[9] = x * y * a, side + y * y * a, -y


@inner
def loop_in_units(arm: Floats, joints: Floats, angles: Floats, u: Floats) -> None:
    """Computes joint values, in units, from the loop's and the given ones."""
    solved, dof, drives = int(arm[SOLVED]), int(arm[DOF]), int(arm[DRIVES])
    coupled = drives + 1 + int(arm[drives]) * (solved + 1)
    if arm[coupled] > 0.0:
        inner = joints.copy()
        for j in range(solved):
            inner[int(arm[PLACE + RECORD * j])] = angles[j] - arm[ZERO + RECORD * j]
        for j in range(solved):
            value = 0.0
            for i in range(dof):
                value += arm[coupled + 1 + dof * j + i] * inner[i]
            u[j] = value / arm[UNIT + RECORD * j]
        return
    for j in range(solved):
        at = RECORD * j
        u[j] = arm[FACING + at] * (angles[j] - arm[ZERO + at]) / arm[UNIT + at]


@inner
def _look_ahead(
    arm: Floats, goal: Goal, joints: Floats, u: Floats, enough: float, ahead: Ahead, count: int
) -> int:
    """Adds the joint values where a descent ends to the solutions ahead; returns the count.

    Not if they miss the pose by more than `enough`.
    """
    solutions, passed = ahead
    if descend(arm, goal, joints, u) > enough:
        return count
    take(solutions[count], u)
    passed[count] = False
    return count + 1


@inner
def _look_from_starts(
    arm: Floats,
    goal: Goal,
    joints: Floats,
    near: Floats,
    first: int,
    end: int,
    ahead: Ahead,
    count: int,
) -> int:
    """Adds what descents from these starts find to the solutions ahead; returns the count."""
    u = np.empty(int(arm[SOLVED]))
    for k in range(first, end):
        start_of(arm, k, near, u)
        count = _look_ahead(arm, goal, joints, u, arm[RESIDUAL], ahead, count)
    return count


@inner
def _keep_loop(
    arm: Floats,
    goal: Goal,
    joints: Floats,
    angles: Floats,
    certain: bool,
    kept: Floats,
    ahead: Ahead,
    ahead_count: int,
) -> tuple[int, int]:
    """Keeps the loop's solutions: at once where they are certainly all, else they come ahead.

    Where solutions meet the exact ones differ. Returns the count of rows, and of those ahead.
    """
    u, count = np.empty(int(arm[SOLVED])), 0
    for k in range(len(angles)):
        loop_in_units(arm, joints, angles[k], u)
        if certain:
            wrap_angles(arm, u)
            take(kept[count], u)
            count += 1
        else:
            ahead_count = _look_ahead(arm, goal, joints, u, math.inf, ahead, ahead_count)
    return count, ahead_count


@inner
def _keep_without_turn(
    arm: Floats,
    goal: Goal,
    joints: Floats,
    angles: Floats,
    certain: bool,
    kept: Floats,
    ahead: Ahead,
    ahead_count: int,
) -> tuple[int, int]:
    """Keeps the solutions of the loop without a turn that the arm does not have.

    Solutions that are exact, also without that turn, are kept at once; solutions nearly without it
    are refined by a descent and come ahead. Other ones are no start. Returns the count of rows, and
    of those ahead.
    """
    solved, count = int(arm[SOLVED]), 0
    nearly_none, u = NEARLY_NONE if certain else NEARLY_NONE_IN_DOUBT, np.empty(solved)
    for k in range(len(angles)):
        exact = certain
        for j in range(solved, 6):
            exact = exact and abs(angles[k, j]) <= EXACT
        loop_in_units(arm, joints, angles[k], u)
        if exact:
            wrap_angles(arm, u)
            take(kept[count], u)
            count += 1
        elif abs(angles[k, solved]) < nearly_none:
            ahead_count = _look_ahead(arm, goal, joints, u, arm[RESIDUAL], ahead, ahead_count)
    return count, ahead_count


@inner
def _keep_ahead(
    arm: Floats,
    goal: Goal,
    joints: Floats,
    near: Floats,
    kept: Floats,
    kinds: Ints,
    count: int,
    ahead: Ahead,
) -> int:
    """Keeps the solutions ahead, except members of continua that were already walked along."""
    solutions, passed = ahead
    for k in range(len(passed)):
        if not passed[k]:
            passed[k] = True
            count = keep(arm, goal, joints, near, kept, kinds, count, solutions[k], ahead)
    return count


@apart(
    "void(float64[::1], UniTuple(float64, 12), float64[::1], float64[::1], float64[:, ::1], "
    "uint8[::1])"
)
def all_joints(
    arm: Floats, pose: Pose, q_free: Floats, seed: Floats, q: Floats, status: Bytes
) -> None:
    """Fills rows with all solutions, by the first joint, then by the second and so on.

    Other rows are left as they are. A joint that is indeterminate follows the seed.
    """
    goal = goal_of(pose, q_free, NO_ARM_ANGLE)
    T, joints, near = goal[0], given_joints(arm, q_free), in_units(arm, seed)
    rows, solved = int(arm[ROWS]), int(arm[SOLVED])
    flat = T.copy().reshape(12)
    if arm[POINTING_LOOP] > 0.0:
        any_turn(T, flat)
    angles, residual = np.empty((PLACES, 6)), np.empty(PLACES)
    known = solve_loop(arm, flat, q_free, angles, residual)
    certain, many = known >= 0, known if known >= 0 else -1 - known
    kept, kinds = np.empty((rows, solved)), np.full(rows, -1, np.int64)
    ahead, n = (np.empty((PLACES + STARTS, solved)), np.ones(PLACES + STARTS, np.bool_)), 0
    if not certain:
        n = _look_from_starts(arm, goal, joints, near, 0, 1, ahead, n)
    if arm[CHECKED] > 0.0:
        count, n = _keep_without_turn(arm, goal, joints, angles[:many], certain, kept, ahead, n)
    else:
        count, n = _keep_loop(arm, goal, joints, angles[:many], certain, kept, ahead, n)
    if not certain:
        _look_from_starts(arm, goal, joints, near, 1, STARTS, ahead, n)
    count = _keep_ahead(arm, goal, joints, near, kept, kinds, count, ahead)
    if certain and arm[CHECKED] > 0.0 and count == 0:
        certain = False
        _look_from_starts(arm, goal, joints, near, 0, STARTS, ahead, 0)
        count = _keep_ahead(arm, goal, joints, near, kept, kinds, count, ahead)
    if not certain:
        count = complete_pairs(arm, goal, joints, near, kept, kinds, count)
    sort_rows(arm, kept, kinds, count, joints, q, status)


@jit
def solve_whole(arm: Floats, pose: Pose, q_free: Floats, seed: Floats) -> tuple[Floats, Bytes]:
    """Returns the rows that `all_joints` fills and what they hold, for callers in Python."""
    rows = int(arm[ROWS])
    q, status = np.full((rows, int(arm[DOF])), math.nan), np.full(rows, UNREACHABLE, np.uint8)
    all_joints(arm, pose, q_free, seed, q, status)
    return q, status
