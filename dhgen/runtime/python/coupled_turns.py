# SPDX-License-Identifier: MIT
"""Whole turns of drives that are coupled: all choices of them.

And how far a row is beyond limits whichever is taken.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .jit import of_file
from .places import COUPLING, DOF, RECORD, SLACK, WEIGHT
from .tolerances import LIMIT
from .turns import TURN

if TYPE_CHECKING:
    from .arrays import Floats, Ints

OWN = of_file(__file__)

# Turns to each side of the one that takes a drive nearest to the wanted value; fewer in searches,
# which choose turns many times, where more than three drives are coupled.
COUPLED_TURNS, TURNS_OF_FOUR, TURNS_OF_MANY = 4, 2, 1

# Places in the array of a coupling: two counts, the drives, then what each of them moves, the
# limits of drives and of sums, what a sum may miss its own by, and the factors of sums.
COUNT, SUMS, DRIVES = 0, 1, 2
# Of a walk through all choices of whole turns: the drive that is turned next, whether it begins
# anew, and turns to each side.
LEVEL, FRESH, MOST = 0, 1, 2


@OWN.inner
def coupling_of(arm: Floats) -> Floats:
    """The numbers of an arm's coupling."""
    return arm[int(arm[COUPLING]) :]


@OWN.inner
def limits_at(coupling: Floats, dof: int) -> int:
    """Where the limits begin."""
    count = int(coupling[COUNT])
    return DRIVES + count + count * dof


@OWN.inner
def sum_of(coupling: Floats, k: int, q: Floats) -> float:
    """The sum of a row's drives that has limits."""
    dof, total = len(q), 0.0
    factors = limits_at(coupling, dof) + 2 * dof + 3 * int(coupling[SUMS]) + dof * k
    for i in range(dof):
        total += coupling[factors + i] * q[i]
    return total


@OWN.inner
def begin_choices(q: Floats, most: int, at: Floats, walk: Ints) -> None:
    """Begins a walk through the choices of whole turns of a row, so many to each side."""
    for i in range(len(q)):
        at[0, i] = q[i]
    walk[LEVEL], walk[FRESH], walk[MOST] = 0, 1, most


@OWN.inner
def _first_turns(
    coupling: Floats, drive: int, q: Floats, towards: Floats, limits: bool, most: int, ends: Floats
) -> None:
    """The first and last number of turns of a drive that may be tried.

    Inside its limits, else beside them, around the one that takes it nearest to where it is wanted.
    """
    low, high, value = -math.inf, math.inf, q[drive]
    if limits:
        end = limits_at(coupling, len(q)) + 2 * drive
        first = np.ceil((coupling[end] - value) / TURN)
        last = np.floor((coupling[end + 1] - value) / TURN)
        low, high = min(first, last), max(first, last)
    wanted = np.floor((towards[drive] - value) / TURN + 0.5)
    middle = min(max(wanted, low), high)
    ends[0] = max(low, middle - most)
    ends[1] = min(high, middle + most)


@OWN.inner
def next_choice(
    coupling: Floats, limits: bool, towards: Floats, at: Floats, turns: Floats, walk: Ints
) -> int:
    """Which row of `at` has the next choice of whole turns, or -1 when there is none left.

    Args:
        coupling: The coupling of the drives.
        limits: Whether limits of drives count.
        towards: Where the drives are wanted.
        at: The row, after the turns of so many drives.
        turns: Of each drive: the number of turns that it has, and the last.
        walk: Where the walk is.
    """
    count, dof = int(coupling[COUNT]), len(towards)
    while walk[LEVEL] >= 0:
        level = int(walk[LEVEL])
        if level == count:
            walk[LEVEL], walk[FRESH] = level - 1, 0
            return level
        drive = int(coupling[DRIVES + level])
        if walk[FRESH]:
            most = int(walk[MOST])
            _first_turns(coupling, drive, at[level], towards, limits, most, turns[level])
            walk[FRESH] = 1 if turns[level, 0] <= turns[level, 1] else 0
        else:
            last = turns[level, 0]
            turns[level, 0] += 1.0  # which changes nothing very far out
            walk[FRESH] = 1 if last < turns[level, 0] <= turns[level, 1] else 0
        if walk[FRESH] == 0:
            walk[LEVEL] = level - 1
            continue
        moves = DRIVES + count + dof * level
        for i in range(dof):
            at[level + 1, i] = at[level, i] + turns[level, 0] * coupling[moves + i]
        walk[LEVEL] = level + 1
    return -1


@OWN.inner
def turns_coupled(arm: Floats, drive: int) -> bool:
    """Whether whole turns of coupled drives move a drive."""
    if arm[COUPLING] == 0.0:
        return False
    coupling, dof = coupling_of(arm), int(arm[DOF])
    count = int(coupling[COUNT])
    moved = 0
    for k in range(count):
        moved += coupling[DRIVES + count + dof * k + drive] != 0.0
    return moved > 0


@OWN.inner
def _beyond_slack(value: float, lowest: float, highest: float, slack: float) -> float:
    """How far a value is beyond limits that have some slack; none where rounding may take it."""
    off = slack + max(lowest - value, value - highest)
    return off if off > 0.5 * slack else 0.0


@OWN.apart("float64(float64[::1], float64[::1])")
def coupled_beyond(arm: Floats, q: Floats) -> float:
    """How far sums, and drives that coupled turns move, are beyond their limits [rad, arm sizes].

    With the whole turns that leave least of it.
    """
    coupling, dof = coupling_of(arm), len(q)
    last, sums, ends = int(coupling[COUNT]), int(coupling[SUMS]), limits_at(coupling, dof)
    at, turns, walk = np.empty((last + 1, dof)), np.empty((last + 1, 2)), np.empty(3, np.int64)
    zeros, least, most = np.zeros(dof), math.inf, COUPLED_TURNS
    if last > 3:
        most = TURNS_OF_FOUR if last == 4 else TURNS_OF_MANY
    begin_choices(q, most, at, walk)
    while least > 0.0:
        choice = next_choice(coupling, True, zeros, at, turns, walk)
        if choice < 0:
            break
        beyond = 0.0
        for i in range(dof):
            if turns_coupled(arm, i):
                low, high = coupling[ends + 2 * i], coupling[ends + 2 * i + 1]
                slack, weight = arm[SLACK + RECORD * i], arm[WEIGHT + RECORD * i]
                beyond += math.sqrt(weight) * _beyond_slack(at[choice, i], low, high, slack)
        for k in range(sums):
            pair = ends + 2 * dof + 2 * k
            slack = coupling[ends + 2 * dof + 2 * sums + k]
            total = sum_of(coupling, k, at[choice])
            # a length's slack is an angle's, times the arm's size
            off = _beyond_slack(total, coupling[pair], coupling[pair + 1], slack)
            beyond += LIMIT / slack * off
        least = min(least, beyond)
    return least
