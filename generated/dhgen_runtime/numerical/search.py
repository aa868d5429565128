# SPDX-License-Identifier: MIT
"""All joints of any arm from the seed and from evenly spread starts, by descents alone."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from ..rigid import take
from ..status import OK, UNREACHABLE
from .descent import descend, descend_towards, start_of, wrap_angles
from .goal import GOAL, NO_ARM_ANGLE, given_joints, goal_of, in_units, take_units
from .keep import keep
from .pairs import complete_pairs
from .places import (
    DOF,
    HIGHEST,
    LOWEST,
    RECORD,
    REDUNDANT,
    RESIDUAL,
    ROWS,
    SOLVED,
)
from .solutions import nothing_ahead, sort_rows

if TYPE_CHECKING:
    from ..arm import Pose
    from ..arrays import Bytes, Floats
    from .goal import Goal

OWN = of_file(__file__)
apart, inner, jit = OWN.apart, OWN.inner, OWN.jit


# Starts in a round; the search ends with the first round that finds nothing new.
STARTS = 48
ROUNDS = 8
REDUNDANT_STARTS = 24  # of an arm with infinitely many solutions, of which the nearest is kept


@apart(
    f"boolean(float64[::1], {GOAL}, float64[::1], float64[::1], float64[::1], "
    "float64[::1], float64[::1])"
)
def _nearest_solution(
    arm: Floats, goal: Goal, q: Floats, near: Floats, low: Floats, high: Floats, best: Floats
) -> bool:
    """Looks for one of infinitely many solutions near to the seed; returns whether there is one."""
    solved = int(arm[SOLVED])
    least, u = math.inf, np.empty(solved)
    for k in range(REDUNDANT_STARTS):
        start_of(arm, k, near, u)
        for j in range(solved):
            u[j] = min(max(u[j], low[j]), high[j])
        if descend_towards(arm, goal, q, u, near, low, high) > arm[RESIDUAL]:
            continue
        square = 0.0
        for j in range(solved):
            square += (u[j] - near[j]) * (u[j] - near[j])
        if square < least:
            least = square
            take(best, u)
    return least < math.inf


@inner
def _one_of_many(
    arm: Floats, goal: Goal, joints: Floats, near: Floats, q: Floats, status: Bytes
) -> None:
    """Fills the only row of an arm with infinitely many solutions; inside the limits if it can."""
    solved = int(arm[SOLVED])
    u, low, high = np.zeros(solved), np.empty(solved), np.empty(solved)
    for j in range(solved):
        low[j], high[j] = arm[LOWEST + RECORD * j], arm[HIGHEST + RECORD * j]
    if not _nearest_solution(arm, goal, joints, near, low, high, u):
        low[:], high[:] = -math.inf, math.inf
        if not _nearest_solution(arm, goal, joints, near, low, high, u):
            return
    status[0] = OK
    wrap_angles(arm, u)
    take(q[0], joints)
    take_units(arm, u, q[0])


@apart(
    "void(float64[::1], UniTuple(float64, 12), float64[::1], float64[::1], float64[:, ::1], "
    "uint8[::1])"
)
def all_joints(
    arm: Floats, pose: Pose, q_free: Floats, seed: Floats, q: Floats, status: Bytes
) -> None:
    """Fills rows with what is found, by the first joint, then by the second and so on.

    Other rows are left as they are.
    """
    goal, joints, near = (
        goal_of(pose, q_free, NO_ARM_ANGLE),
        given_joints(arm, q_free),
        in_units(arm, seed),
    )
    rows, solved = int(arm[ROWS]), int(arm[SOLVED])
    if arm[REDUNDANT] > 0.0:
        _one_of_many(arm, goal, joints, near, q, status)
        return
    u = np.zeros(solved)
    kept, kinds = np.empty((rows, solved)), np.empty(rows, np.int64)
    count, before = 0, -1
    for k in range(STARTS * ROUNDS):
        if k % STARTS == 0:
            if count in (before, rows):
                break
            before = count
        start_of(arm, k, near, u)
        if descend(arm, goal, joints, u) <= arm[RESIDUAL]:
            count = keep(arm, goal, joints, near, kept, kinds, count, u, nothing_ahead(arm))
    count = complete_pairs(arm, goal, joints, near, kept, kinds, count)
    sort_rows(arm, kept, kinds, count, joints, q, status)


@jit
def solve_whole(arm: Floats, pose: Pose, q_free: Floats, seed: Floats) -> tuple[Floats, Bytes]:
    """Returns the rows that `all_joints` fills and what they hold, for callers in Python."""
    rows = int(arm[ROWS])
    q, status = np.full((rows, int(arm[DOF])), math.nan), np.full(rows, UNREACHABLE, np.uint8)
    all_joints(arm, pose, q_free, seed, q, status)
    return q, status
