# SPDX-License-Identifier: MIT
"""Drives whose whole turns hang together: one's turn moves another, or sums have limits.

As that of a ball screw does. Of a row's copies the one is taken that is inside all limits, and of
these the nearest.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .coupled_turns import (
    COUNT,
    COUPLED_TURNS,
    DRIVES,
    SUMS,
    begin_choices,
    coupling_of,
    limits_at,
    next_choice,
    sum_of,
)
from .jit import of_file
from .places import DOF, RECORD, ROWS, WEIGHT
from .status import FREE_JOINT, OK, OUT_OF_LIMITS, UNREACHABLE
from .turns import near, turned

if TYPE_CHECKING:
    from .arrays import Bytes, Floats

OWN = of_file(__file__)


@dataclass(frozen=True, slots=True)
class Coupling:
    """The coupling of an arm's drives.

    Attributes:
        drives: The places of those whose turns are chosen together, each before those that it
            moves.
        moves: What a whole turn of each moves, a value for every drive.
        limits: Of every drive, with slack.
        factors: Of all drives in each sum that has limits.
        sums: The limits of these sums, with slack.
        slacks: What each of them may miss its limits by.
    """

    drives: tuple[int, ...]
    moves: tuple[tuple[float, ...], ...]
    limits: tuple[tuple[float, float], ...]
    factors: tuple[tuple[float, ...], ...] = ()
    sums: tuple[tuple[float, float], ...] = ()
    slacks: tuple[float, ...] = ()


def coupling_numbers(coupling: Coupling) -> Floats:
    """The array of an arm's coupling."""
    pairs = (*coupling.limits, *coupling.sums)
    numbers = [float(len(coupling.drives)), float(len(coupling.sums)), *map(float, coupling.drives)]
    rows = (*coupling.moves, *pairs, coupling.slacks, *coupling.factors)
    numbers += [x for row in rows for x in row]
    return np.array(numbers)


@OWN.inner
def _keeps_coupled(coupling: Floats, q: Floats) -> bool:
    """Whether a row is inside the limits of all drives and of all sums."""
    dof = len(q)
    at = limits_at(coupling, dof)
    for i in range(dof):
        if not coupling[at + 2 * i] <= q[i] <= coupling[at + 2 * i + 1]:
            return False
    at += 2 * dof
    for k in range(int(coupling[SUMS])):
        if not coupling[at + 2 * k] <= sum_of(coupling, k, q) <= coupling[at + 2 * k + 1]:
            return False
    return True


@OWN.inner
def _distance(arm: Floats, q: Floats, towards: Floats) -> float:
    """How far a row is from other values, squared [rad, arm sizes]."""
    total = 0.0
    for i in range(len(q)):
        total += arm[WEIGHT + RECORD * i] * (q[i] - towards[i]) * (q[i] - towards[i])
    return total


@OWN.inner
def turn_coupled(arm: Floats, limits: bool, towards: Floats, q: Floats) -> bool:
    """Moves the coupled drives of a row by whole turns: as near to other values as can be.

    Args:
        arm: The arm's numbers.
        limits: Whether only places inside all limits count.
        towards: The other values.
        q: The row; unchanged where there is no such place.

    Returns:
        Whether there is one.
    """
    coupling, dof = coupling_of(arm), len(q)
    last, least = int(coupling[COUNT]), math.inf
    at, turns, walk = np.empty((last + 1, dof)), np.empty((last + 1, 2)), np.empty(3, np.int64)
    begin_choices(q, COUPLED_TURNS, at, walk)
    while True:
        choice = next_choice(coupling, limits, towards, at, turns, walk)
        if choice < 0:
            return least < math.inf
        distance = _distance(arm, at[choice], towards)
        if distance < least and (not limits or _keeps_coupled(coupling, at[choice])):
            least = distance
            for i in range(dof):
                q[i] = at[choice, i]


@OWN.apart("int64(float64[::1], float64[:, ::1], uint8[::1], int64)")
def settle_rows(arm: Floats, q: Floats, status: Bytes, count: int) -> int:
    """Takes the turns of all rows together; returns how many of `count` are inside limits."""
    zeros = np.zeros(int(arm[DOF]))
    for row in range(int(arm[ROWS]) if count > 0 else 0):
        if status[row] not in (OK, FREE_JOINT):
            continue
        if not turn_coupled(arm, True, zeros, q[row]):
            status[row] = OUT_OF_LIMITS
            count -= 1
    return count


@OWN.jit
def coupled_nearest(
    arm: Floats,
    rows: Floats,
    status: Bytes,
    seed: Floats,
    limits: bool,
    q: Floats,
) -> bool:
    """The solution nearest to the seed into q; whether there is one. As `nearest.nearest`."""
    coupling, best, least, held = coupling_of(arm), -1, math.inf, np.empty(len(q))
    for row in range(len(rows)):
        if status[row] == UNREACHABLE or (limits and status[row] == OUT_OF_LIMITS):
            continue
        for i in range(len(q)):
            held[i] = rows[row, i]
            to = turned(arm, i, held[i], seed[i]) if limits else near(arm, i, held[i], seed[i])
            rows[row, i] = to
        for k in range(int(coupling[COUNT])):
            drive = int(coupling[DRIVES + k])
            rows[row, drive] = held[drive]
        turn_coupled(arm, limits, seed, rows[row])
        distance = _distance(arm, rows[row], seed)
        if best < 0 or distance < least:
            best, least = row, distance
    for i in range(len(q)):
        q[i] = rows[best, i]
    return best >= 0
