# SPDX-License-Identifier: MIT
"""Postures of a nearest arm with a structure, as postures.h has them.

The row of its closed form that holds joint values, and the row of a solution that has this posture.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..angles import wrap
from ..jit import of_file
from ..rigid import take
from ..status import OK, UNREACHABLE

if TYPE_CHECKING:
    from ..arrays import Bytes, Floats, Ints

OWN = of_file(__file__)
inner = OWN.inner

# Joint values belong to a row that differs by less [rad]: at poses that the closed form solves its
# rows are known to 1e-9.
SAME_POSTURE = 1e-6


@inner
def rows_filled(filled: Floats, rows: int) -> Ints:
    """Returns which rows hold a solution.

    Args:
        filled: What the formulas of regular poses fill in: joints' values, then statuses.
        rows: How many rows there are.
    """
    found, count = np.empty(rows, np.int64), 0
    for row in range(rows):
        if filled[len(filled) - rows + row] == OK:
            found[count] = row
            count += 1
    return found[:count]


@inner
def posture_of(filled: Floats, places: Ints, values: Floats) -> int:
    """Returns the row of the nearest arm that holds joint values; -1 where none does.

    Args:
        filled: What the formulas of regular poses fill in: joints' values, then statuses.
        places: Of the values of the loop's joints in each row, (rows, 6).
        values: Of these joints.
    """
    posture, least, rows = -1, SAME_POSTURE, len(places)
    for row in range(rows):
        most = 0.0 if filled[len(filled) - rows + row] == OK else math.inf
        for i in range(6):
            most = max(most, abs(wrap(filled[places[row, i]] - values[i])))
        if most < least:
            posture, least = row, most
    return posture


@inner
def place_rows(postures: Ints, rows: int, q: Floats, status: Bytes) -> None:
    """Moves solutions, which fill the first rows, to the rows of their postures.

    Of several with one posture the first. The others follow behind the nearest arm's rows, and fill
    empty ones of these should there be more.

    Args:
        postures: The row of the nearest arm that each solution is in, -1 for none.
        rows: How many rows the nearest arm has.
        q: Rows of joint values, (n, joints).
        status: What each holds.
    """
    solutions, kinds, behind = q.copy(), status.copy(), rows
    for row in range(len(kinds)):
        status[row] = UNREACHABLE
        for i in range(q.shape[1]):
            q[row, i] = math.nan
    for late in range(2):
        for k in range(len(kinds)):
            row = behind % len(kinds) if late else postures[k]
            if kinds[k] == UNREACHABLE or row < 0:
                continue
            while late and status[row] != UNREACHABLE:
                behind += 1
                row = behind % len(kinds)
            if status[row] == UNREACHABLE:
                take(q[row], solutions[k])
                status[row], kinds[k] = kinds[k], UNREACHABLE
