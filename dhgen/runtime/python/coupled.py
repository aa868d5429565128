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

from .jit import of_file
from .places import DOF, RECORD, ROWS, WEIGHT
from .status import FREE_JOINT, OK, OUT_OF_LIMITS, UNREACHABLE
from .turns import TURN, near, turned

if TYPE_CHECKING:
    from .arrays import Bytes, Floats

OWN = of_file(__file__)

COUPLED_TURNS = 4.0  # to each side of the one that takes a drive nearest to where it is wanted

# Places in the array of a coupling: two counts, the drives, then what `coupling_numbers` says.
COUNT, SUMS, DRIVES = 0, 1, 2


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
    """

    drives: tuple[int, ...]
    moves: tuple[tuple[float, ...], ...]
    limits: tuple[tuple[float, float], ...]
    factors: tuple[tuple[float, ...], ...] = ()
    sums: tuple[tuple[float, float], ...] = ()


def coupling_numbers(coupling: Coupling) -> Floats:
    """The array of an arm's coupling."""
    pairs = (*coupling.limits, *coupling.sums)
    numbers = [float(len(coupling.drives)), float(len(coupling.sums)), *map(float, coupling.drives)]
    numbers += [x for row in (*coupling.moves, *pairs, *coupling.factors) for x in row]
    return np.array(numbers)


@OWN.inner
def _limits_at(coupling: Floats, dof: int) -> int:
    """Where the limits begin."""
    count = int(coupling[COUNT])
    return DRIVES + count + count * dof


@OWN.inner
def _keeps_coupled(coupling: Floats, q: Floats) -> bool:
    """Whether a row is inside the limits of all drives and of all sums."""
    dof, sums = len(q), int(coupling[SUMS])
    at = _limits_at(coupling, dof)
    for i in range(dof):
        if not coupling[at + 2 * i] <= q[i] <= coupling[at + 2 * i + 1]:
            return False
    at += 2 * dof
    factors = at + 2 * sums
    for k in range(sums):
        total = 0.0
        for i in range(dof):
            total += coupling[factors + dof * k + i] * q[i]
        if not coupling[at + 2 * k] <= total <= coupling[at + 2 * k + 1]:
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
def turn_coupled(arm: Floats, coupling: Floats, limits: bool, towards: Floats, q: Floats) -> bool:
    """Moves the coupled drives of a row by whole turns: as near to other values as can be.

    Args:
        arm: The arm's numbers.
        coupling: The coupling of its drives.
        limits: Whether only places inside all limits count.
        towards: The other values.
        q: The row; it stays as it is where there is no such place.

    Returns:
        Whether there is one.
    """
    dof, last = len(q), int(coupling[COUNT])
    ends_at, moves_at = _limits_at(coupling, dof), DRIVES + last
    at, turns = np.empty((last + 1, dof)), np.empty((last + 1, 2))
    for i in range(dof):
        at[0, i] = q[i]
    least, level, fresh = math.inf, 0, True
    while level >= 0:
        if level == last:
            distance = _distance(arm, at[level], towards)
            if distance < least and (not limits or _keeps_coupled(coupling, at[level])):
                least = distance
                for i in range(dof):
                    q[i] = at[level, i]
            level, fresh = level - 1, False
            continue
        drive = int(coupling[DRIVES + level])
        if fresh:
            value, end = at[level, drive], ends_at + 2 * drive
            low, high = -math.inf, math.inf
            if limits:
                low = np.ceil((coupling[end] - value) / TURN)
                high = np.floor((coupling[end + 1] - value) / TURN)
            wanted = np.floor((towards[drive] - value) / TURN + 0.5)
            middle = min(max(wanted, low), high)
            turns[level, 0] = max(low, middle - COUPLED_TURNS)
            turns[level, 1] = min(high, middle + COUPLED_TURNS)
        else:
            turns[level, 0] += 1.0
        fresh = turns[level, 0] <= turns[level, 1]
        if not fresh:
            level -= 1
            continue
        for i in range(dof):
            at[level + 1, i] = at[level, i] + turns[level, 0] * coupling[moves_at + dof * level + i]
        level += 1
    return least < math.inf


@OWN.apart("int64(float64[::1], float64[::1], float64[:, ::1], uint8[::1], int64)")
def settle_rows(arm: Floats, coupling: Floats, q: Floats, status: Bytes, count: int) -> int:
    """Takes the turns of all rows together; returns how many of `count` are inside limits."""
    zeros = np.zeros(int(arm[DOF]))
    for row in range(int(arm[ROWS]) if count > 0 else 0):
        if status[row] not in (OK, FREE_JOINT):
            continue
        if not turn_coupled(arm, coupling, True, zeros, q[row]):
            status[row] = OUT_OF_LIMITS
            count -= 1
    return count


@OWN.jit
def coupled_nearest(
    arm: Floats,
    coupling: Floats,
    rows: Floats,
    status: Bytes,
    seed: Floats,
    limits: bool,
    q: Floats,
) -> bool:
    """The solution nearest to the seed into q; whether there is one. As `nearest.nearest`."""
    best, least, held = -1, math.inf, np.empty(len(q))
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
        turn_coupled(arm, coupling, limits, seed, rows[row])
        distance = _distance(arm, rows[row], seed)
        if best < 0 or distance < least:
            best, least = row, distance
    for i in range(len(q)):
        q[i] = rows[best, i]
    return best >= 0
