# SPDX-License-Identifier: MIT
"""All joints of any arm from the seed and from evenly spread starts, by descents alone."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from .descent import descend, descend_towards, start_of, wrap_angles
from .forward import take
from .keep import keep
from .places import (
    DOF,
    FREE,
    GIVEN,
    HIGHEST,
    LOWEST,
    PLACE,
    RECORD,
    REDUNDANT,
    RESIDUAL,
    ROWS,
    SOLVED,
    UNIT,
)
from .solutions import sort_rows

if TYPE_CHECKING:
    from ..arrays import Bools, Floats

OWN = of_file(__file__)
apart, inner, jit = OWN.apart, OWN.inner, OWN.jit


# Starts in a round; the search ends with the first round that finds nothing new.
STARTS = 48
ROUNDS = 8
REDUNDANT_STARTS = 24  # of an arm with infinitely many solutions, of which the nearest is kept


@inner
def matrix_of(pose: tuple[float, ...]) -> Floats:
    """Returns the upper rows (3, 4) of a pose."""
    T = np.empty((3, 4))
    for i in range(3):
        for j in range(4):
            T[i, j] = pose[4 * i + j]
    return T


@inner
def given_joints(arm: Floats, q_free: Floats) -> Floats:
    """Returns joint values that are zero but where the caller gives them."""
    joints, at = np.zeros(int(arm[DOF])), int(arm[FREE])
    for k in range(int(arm[GIVEN])):
        joints[int(arm[at + k])] = q_free[k]
    return joints


@inner
def seed_in_units(arm: Floats, seed: Floats) -> Floats:
    """Returns the seed's values of the joints that are solved for, in units."""
    near = np.empty(int(arm[SOLVED]))
    for j in range(len(near)):
        near[j] = seed[int(arm[PLACE + RECORD * j])] / arm[UNIT + RECORD * j]
    return near


@apart(
    "boolean(float64[::1], float64[:, ::1], float64[::1], float64[::1], float64[::1], "
    "float64[::1], float64[::1])"
)
def _nearest_solution(
    arm: Floats, T: Floats, q: Floats, near: Floats, low: Floats, high: Floats, best: Floats
) -> bool:
    """Looks for one of infinitely many solutions near to the seed; returns whether there is one."""
    solved = int(arm[SOLVED])
    least, u = math.inf, np.empty(solved)
    for k in range(REDUNDANT_STARTS):
        start_of(arm, k, near, u)
        for j in range(solved):
            u[j] = min(max(u[j], low[j]), high[j])
        if descend_towards(arm, T, q, u, near, low, high) > arm[RESIDUAL]:
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
    arm: Floats, T: Floats, joints: Floats, near: Floats, q: Floats, found: Bools
) -> None:
    """Fills the only row of an arm with infinitely many solutions; inside the limits if it can."""
    solved = int(arm[SOLVED])
    u, low, high = np.zeros(solved), np.empty(solved), np.empty(solved)
    for j in range(solved):
        low[j], high[j] = arm[LOWEST + RECORD * j], arm[HIGHEST + RECORD * j]
    found[0] = _nearest_solution(arm, T, joints, near, low, high, u)
    if not found[0]:
        low[:], high[:] = -math.inf, math.inf
        found[0] = _nearest_solution(arm, T, joints, near, low, high, u)
    wrap_angles(arm, u)
    take(q[0], joints)
    for j in range(solved):
        q[0, int(arm[PLACE + RECORD * j])] = arm[UNIT + RECORD * j] * u[j]


@apart(
    "Tuple((float64[:, ::1], boolean[::1], boolean[::1]))(float64[::1], UniTuple(float64, 12), "
    "float64[::1], float64[::1])"
)
def all_joints(
    arm: Floats, pose: tuple[float, ...], q_free: Floats, seed: Floats
) -> tuple[Floats, Bools, Bools]:
    """Returns rows of joint values, which hold a solution, and where a joint was indeterminate."""
    T, joints, near = matrix_of(pose), given_joints(arm, q_free), seed_in_units(arm, seed)
    rows, solved = int(arm[ROWS]), int(arm[SOLVED])
    q = np.zeros((rows, int(arm[DOF])))
    found, chosen = np.zeros(rows, np.bool_), np.zeros(rows, np.bool_)
    if arm[REDUNDANT] > 0.0:
        _one_of_many(arm, T, joints, near, q, found)
        return q, found, chosen
    u = np.zeros(solved)
    kept, kinds = np.empty((rows, solved)), np.empty(rows, np.int64)
    count, before = 0, -1
    for k in range(STARTS * ROUNDS):
        if k % STARTS == 0:
            if count in (before, rows):
                break
            before = count
        start_of(arm, k, near, u)
        if descend(arm, T, joints, u) <= arm[RESIDUAL]:
            count = keep(arm, T, joints, near, kept, kinds, count, u)
    sort_rows(arm, kept, kinds, count, joints, q, found, chosen)
    return q, found, chosen


@jit
def solve_whole(
    arm: Floats, pose: tuple[float, ...], q_free: Floats, seed: Floats
) -> tuple[Floats, Bools, Bools]:
    """Returns what `all_joints` does, for callers in Python."""
    return all_joints(arm, pose, q_free, seed)
