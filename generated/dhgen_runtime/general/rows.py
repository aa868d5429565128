# SPDX-License-Identifier: MIT
"""The rows of a general arm: what the loop's solutions are for it, and what descents add.

Where it is not certain that the loop's solutions are all, they are taken to where descents lead,
and some more starts are tried: what tells solutions apart where they meet is exact ones.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from ..numerical.descent import descend, start_of, wrap_angles
from ..numerical.forward import take
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
from ..tolerances import EXACT
from .places import POINTING_LOOP
from .search import solve_loop

if TYPE_CHECKING:
    from ..arrays import Bools, Floats, Ints
    from ..numerical.goal import Goal

OWN = of_file(__file__)
apart, inner, jit = OWN.apart, OWN.inner, OWN.jit

STARTS = 12  # beside what the loop has, where that is not certainly everything
# An angle above this [rad] of a turn that the arm does not have belongs to a pose that it does not
# take: rounding of a pose, as far as it is accepted, is a thousand times less, and the angle is
# more only where the arm is nearly singular. Where the certificate fails, or solutions meet, it may
# be: then the second one stands.
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
def _in_units(arm: Floats, joints: Floats, angles: Floats, u: Floats) -> None:
    """Computes joint values, in units, from those of the loop and those that are given."""
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
def _keep_all(
    arm: Floats,
    goal: Goal,
    joints: Floats,
    near: Floats,
    angles: Floats,
    many: int,
    certain: bool,
    kept: Floats,
    kinds: Ints,
    count: int,
) -> int:
    """Adds the loop's solutions, refined unless they are certainly all; returns the count."""
    u = np.empty(int(arm[SOLVED]))
    for k in range(many):
        _in_units(arm, joints, angles[k], u)
        if certain:
            wrap_angles(arm, u)
            take(kept[count], u)
            count += 1
        else:
            descend(arm, goal, joints, u)
            count = keep(arm, goal, joints, near, kept, kinds, count, u)
    return count


@inner
def _keep_without_turn(
    arm: Floats,
    goal: Goal,
    joints: Floats,
    near: Floats,
    angles: Floats,
    many: int,
    certain: bool,
    kept: Floats,
    kinds: Ints,
    count: int,
) -> int:
    """Adds those of the loop's solutions without a turn that the arm does not have; how many then.

    First those that are exact, also without that turn; then those that are nearly without it, from
    where a descent leads. What is not nearly so is no start.
    """
    solved = int(arm[SOLVED])
    nearly_none, u = NEARLY_NONE if certain else NEARLY_NONE_IN_DOUBT, np.empty(solved)
    for n in range(2 * many):
        k = n % many
        exact = certain
        for j in range(solved, 6):
            exact = exact and abs(angles[k, j]) <= EXACT
        _in_units(arm, joints, angles[k], u)
        if n < many:
            if exact:
                wrap_angles(arm, u)
                take(kept[count], u)
                count += 1
            continue
        start = not exact and abs(angles[k, solved]) < nearly_none
        if start and descend(arm, goal, joints, u) <= arm[RESIDUAL]:
            count = keep(arm, goal, joints, near, kept, kinds, count, u)
    return count


@apart(
    "Tuple((float64[:, ::1], boolean[::1], boolean[::1]))(float64[::1], UniTuple(float64, 12), "
    "float64[::1], float64[::1], float64[:, ::1])"
)
def all_joints(
    arm: Floats, pose: tuple[float, ...], q_free: Floats, seed: Floats, nearby: Floats
) -> tuple[Floats, Bools, Bools]:
    """Returns rows of joint values, which hold a solution, and in which a joint was indeterminate.

    Such a joint follows the seed. `nearby` holds joint values of the loop near which all solutions
    are, one near each, or none.
    """
    goal = goal_of(pose, q_free, NO_ARM_ANGLE)
    T, joints, near = goal[0], given_joints(arm, q_free), in_units(arm, seed)
    rows, solved = int(arm[ROWS]), int(arm[SOLVED])
    flat = T.copy().reshape(12)
    if arm[POINTING_LOOP] > 0.0:
        any_turn(T, flat)
    angles, residual = np.empty((rows, 6)), np.empty(rows)
    known = solve_loop(arm, flat, q_free, nearby, angles, residual)
    certain, many = known >= 0, known if known >= 0 else -1 - known
    q = np.zeros((rows, int(arm[DOF])))
    found, chosen = np.zeros(rows, np.bool_), np.zeros(rows, np.bool_)
    kept, kinds, count = np.empty((rows, solved)), np.full(rows, -1, np.int64), 0
    u = near.copy()
    if not certain and descend(arm, goal, joints, u) <= arm[RESIDUAL]:
        count = keep(arm, goal, joints, near, kept, kinds, count, u)
    first = 1  # of the starts
    if arm[CHECKED] > 0.0:
        count = _keep_without_turn(
            arm, goal, joints, near, angles, many, certain, kept, kinds, count
        )
        first, certain = 0, certain and count > 0
    else:
        count = _keep_all(arm, goal, joints, near, angles, many, certain, kept, kinds, count)
    for k in range(first, 0 if certain else STARTS):
        start_of(arm, k, near, u)
        if descend(arm, goal, joints, u) <= arm[RESIDUAL]:
            count = keep(arm, goal, joints, near, kept, kinds, count, u)
    if not certain:
        count = complete_pairs(arm, goal, joints, near, kept, kinds, count)
    sort_rows(arm, kept, kinds, count, joints, q, found, chosen)
    return q, found, chosen


@jit
def solve_whole(
    arm: Floats, pose: tuple[float, ...], q_free: Floats, seed: Floats
) -> tuple[Floats, Bools, Bools]:
    """Returns what `all_joints` does, for callers in Python."""
    return all_joints(arm, pose, q_free, seed, np.empty((0, 6)))
