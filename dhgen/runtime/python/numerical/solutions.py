# SPDX-License-Identifier: MIT
"""Which solutions are one, which belong to a continuum, and the order of rows."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from ..rigid import take
from ..status import FREE_JOINT, OK
from ..turns import TURN
from .descent import (
    FLOOR,
    SOLUTION,
    damped_step,
    descend,
    measure_miss,
    sideways,
    wrap_angles,
)
from .goal import GOAL, take_units
from .places import (
    CHECKED,
    EQUATIONS,
    RECORD,
    RESIDUAL,
    SOLVED,
    TURNS,
)

if TYPE_CHECKING:
    from ..arrays import Bools, Bytes, Floats, Ints
    from .goal import Goal

    Ahead = tuple[Floats, Bools]

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner


SAME = (
    1e-6  # solutions closer than this are one [rad, arm sizes]: roots are known to 1e-8 or better
)
# Singular solutions closer than this [rad, arm sizes] are one if what lies between them solves,
# too: from these parts of the way a few steps reach solutions that are nearer to where they began
# than this part of it.
NEIGHBOURS = 0.1
BETWEEN = (0.25, 0.5, 0.75)
STEPS_ASIDE = 4
STAYS = 1 / 16
# Between solutions that are one the pose is missed by no more than this, or than twice what they
# miss it by [arm sizes, rad]: a hundred times rounding. Where many roots meet, those closer than
# NEXT_TO [rad, arm sizes] miss it by a little more.
SAME_BETWEEN = 1e-13
NEXT_TO, SAME_NEXT_TO = 1e-5, 1e-12
# What is left of a generic direction when all that moves the tool is taken away [of its length]: by
# less it is what damping leaves at a regular solution.
SINGULAR = 1e-4
FEELER = 0.05  # how far a continuum is looked for in that direction [rad, arm sizes]
FELT = 0.01  # how far from where it began, and from the other side, a solution must then be
# Solutions that are still to be kept, and which of them a walk along a continuum came by.
AHEAD = "Tuple((float64[:, ::1], boolean[::1]))"
# Values closer than this don't decide which of two rows comes first [rad, arm sizes], and an angle
# as close to -pi comes where pi does: where solutions meet they are known to 1e-8, and rounding,
# which differs between machines, decides the rest.
TIE = 1e-6


@apart(f"float64(float64[::1], {GOAL}, float64[::1], float64[::1])")
def enough_beside(arm: Floats, goal: Goal, q: Floats, u: Floats) -> float:
    """Returns what others may miss beside a solution: an exact one leaves exact ones only."""
    if arm[CHECKED] == 0.0:
        return SOLUTION
    e, A = np.empty(int(arm[EQUATIONS])), np.empty((int(arm[EQUATIONS]), int(arm[SOLVED])))
    return SOLUTION if measure_miss(arm, goal, q, u, e, A) <= SOLUTION else arm[RESIDUAL]


@apart(f"boolean(float64[::1], {GOAL}, float64[::1], float64[::1], float64[::1], float64)")
def _solves_between(
    arm: Floats, goal: Goal, q: Floats, u: Floats, way: Floats, length: float
) -> bool:
    """Whether solutions lie all along the way from one to another.

    Where many roots meet, joint values beside the solution miss the pose by next to nothing.
    Between two that nearly meet the pose is missed by next to nothing, too, but by more than at
    both.
    """
    solved = int(arm[SOLVED])
    e, A = np.empty(int(arm[EQUATIONS])), np.empty((int(arm[EQUATIONS]), solved))
    end, step = np.empty(solved), np.empty(solved)
    enough = enough_beside(arm, goal, q, u)
    for j in range(solved):
        end[j] = u[j] + way[j]
    ends = max(measure_miss(arm, goal, q, u, e, A), measure_miss(arm, goal, q, end, e, A))
    least = SAME_NEXT_TO if length < NEXT_TO else SAME_BETWEEN
    enough = min(enough, max(least, 2.0 * ends))
    for part in BETWEEN:
        for j in range(solved):
            end[j] = u[j] + part * way[j]
        miss = measure_miss(arm, goal, q, end, e, A)
        for _ in range(STEPS_ASIDE):
            if miss > enough:
                damped_step(A, e, miss, FLOOR, step)
                for j in range(solved):
                    end[j] += step[j]
                miss = measure_miss(arm, goal, q, end, e, A)
        if miss > enough:
            return False
        for j in range(solved):
            if abs(u[j] + part * way[j] - end[j]) > STAYS * length:
                return False
    return True


@apart(f"int64(float64[::1], {GOAL}, float64[::1], float64[::1], float64)")
def continuum(arm: Floats, goal: Goal, q: Floats, u: Floats, enough: float) -> int:
    """Returns whether u is one of a continuum of solutions: 1 if it goes on to both sides.

    These miss the pose by no more than `enough`. 0 if it is an isolated singular solution, as where
    three nearly meet, -1 if it is a regular one.
    """
    solved = int(arm[SOLVED])
    e, A = np.empty(int(arm[EQUATIONS])), np.empty((int(arm[EQUATIONS]), solved))
    along, ends, gaps, across = np.empty(solved), np.empty((2, solved)), np.zeros(2), 0.0
    measure_miss(arm, goal, q, u, e, A)
    if sideways(arm, A, along) <= SINGULAR:
        return -1
    for side in range(2):
        for j in range(solved):
            ends[side, j] = u[j] + (1 - 2 * side) * FEELER * along[j]
        if descend(arm, goal, q, ends[side]) > enough:
            return 0
        for j in range(solved):
            gaps[side] = max(gaps[side], abs(ends[side, j] - u[j]))
        if gaps[side] <= FELT:
            return 0
    for j in range(solved):
        across = max(across, abs(ends[0, j] - ends[1, j]))
    if across <= FELT:
        return 0
    for side in range(2):
        for j in range(solved):
            along[j] = ends[side, j] - u[j]
        if not _solves_between(arm, goal, q, u, along, gaps[side]):
            return 0
    return 1


@apart(f"boolean(float64[::1], {GOAL}, float64[::1], float64[::1], float64[::1], boolean)")
def is_same(arm: Floats, goal: Goal, q: Floats, known: Floats, u: Floats, loose: bool) -> bool:
    """Whether a solution is taken for one that is known; loosely where both are singular."""
    solved = int(arm[SOLVED])
    between, gap = np.empty(solved), 0.0
    for j in range(solved):
        between[j] = u[j] - known[j]
    wrap_angles(arm, between)
    for j in range(solved):
        gap = max(gap, abs(between[j]))
    if gap < SAME:
        return True
    return loose and gap < NEIGHBOURS and _solves_between(arm, goal, q, known, between, gap)


@apart(
    f"int64(float64[::1], {GOAL}, float64[::1], float64[:, ::1], int64[::1], int64, "
    "float64[::1], boolean)"
)
def find_known(
    arm: Floats,
    goal: Goal,
    q: Floats,
    kept: Floats,
    kinds: Ints,
    count: int,
    u: Floats,
    singular: bool,
) -> int:
    """Returns which kept solution a solution is; -1 for none."""
    for k in range(count):
        if is_same(arm, goal, q, kept[k], u, singular and kinds[k] >= 0):
            return k
    return -1


@inner
def nothing_ahead(arm: Floats) -> Ahead:
    """Returns no solutions that are still to be kept."""
    return np.empty((0, int(arm[SOLVED]))), np.empty(0, np.bool_)


@apart(f"void(float64[::1], {GOAL}, float64[::1], float64[::1], {AHEAD})")
def pass_by(arm: Floats, goal: Goal, q: Floats, member: Floats, ahead: Ahead) -> None:
    """Marks the solutions ahead that are the member of a continuum at which a walk is."""
    solutions, passed = ahead
    for k in range(len(passed)):
        if not passed[k]:
            passed[k] = is_same(arm, goal, q, member, solutions[k], True)


@inner
def order_of(value: float, turns: bool) -> float:
    """A joint value as it counts where rows are put in order."""
    return value + TURN if turns and value < TIE - math.pi else value


@inner
def order_blocks(value: Floats, tie: float, count: int, order: Ints, first: Bools) -> bool:
    """Puts rows in order by one value more; returns whether each row is a block by now.

    `order` holds their places, `first` whether each begins a block: rows of one block agree so far.
    They are sorted by the value, and the block ends wherever it rises by more than `tie`.
    """
    for i in range(1, count):
        row, place = order[i], i
        while place > 0 and not first[place] and value[row] < value[order[place - 1]]:
            order[place] = order[place - 1]
            place -= 1
        order[place] = row
    single = True
    for i in range(1, count):
        first[i] = first[i] or value[order[i]] - value[order[i - 1]] > tie
        single = single and first[i]
    return single


@apart(
    "void(float64[::1], float64[:, ::1], int64[::1], int64, float64[::1], float64[:, ::1], "
    "uint8[::1])"
)
def sort_rows(
    arm: Floats,
    kept: Floats,
    kinds: Ints,
    count: int,
    joints: Floats,
    q: Floats,
    status: Bytes,
) -> None:
    """Fills rows by the first joint, then by the second and so on."""
    order, first, value = np.empty(count, np.int64), np.zeros(count, np.bool_), np.empty(count)
    for k in range(count):
        order[k] = k
    single = count < 2
    for j in range(int(arm[SOLVED])):
        if not single:
            turns = arm[TURNS + RECORD * j] > 0.0
            for k in range(count):
                value[k] = order_of(kept[k, j], turns)
            single = order_blocks(value, TIE, count, order, first)
    for row in range(count):
        take_units(arm, kept[order[row]], joints)
        take(q[row], joints)
        status[row] = FREE_JOINT if kinds[order[row]] == 1 else OK
