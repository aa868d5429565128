# SPDX-License-Identifier: MIT
"""What is said of a table that is not taken: which of its numbers, or of its axes, it is."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .calibrated import (
    ANOTHER_ARM,
    LEAST_MISS,
    LENGTH,
    MEETING,
    MOST_DEVIATION,
    MOST_NUMBER,
    NO_MISS,
    NOT_FINITE,
    PARALLEL,
    TABLE,
    TRIPLES,
    calibrate,
)
from .calibration import MOVED, NUMBERS, TURNED

if TYPE_CHECKING:
    from .arrays import Bools, Floats

COLUMNS = ("theta", "d", "a", "alpha")
LENGTHS = (False, True, True, False)  # whether a column holds lengths


def refusal(kind: Floats, blank: Floats, table: Floats, said: int, unit: str) -> str:
    """What is wrong with a table.

    Args:
        kind: The numbers of the kind.
        blank: Those of an arm of which no table is known.
        table: The arm's own, (6, 4).
        said: What `calibrate` says of it.
        unit: How lengths are called.
    """
    if said == NOT_FINITE:
        row, column = np.argwhere(~np.isfinite(table))[0].tolist()
        return f"{_entry(row, column)}, is not finite: {float(table[row, column])}"
    if said == ANOTHER_ARM:
        return _another_arm(kind, blank, table, unit)
    return (
        f"in table {_exact_axes(kind, blank, table)} to {LEAST_MISS:.0e}, as those of the nominal "
        "arm: such an arm has a closed form of its own, that of a robot file with these numbers"
    )


def _entry(row: int, column: int) -> str:
    return f"table[{row}][{column}], {COLUMNS[column]} of row {row + 1}"


def _another_arm(kind: Floats, blank: Floats, table: Floats, unit: str) -> str:
    """By how much the arm is another one, and which number makes it so."""
    size, nominal = float(kind[LENGTH]), kind[TABLE:].reshape(table.shape)
    row, column = _farthest(kind, blank, table)
    in_unit = unit if LENGTHS[column] else "rad"
    number = f"{float(table[row, column]):.9g} {in_unit}"
    if _too_large(table, size).any():
        large = f"numbers above {MOST_NUMBER:.0e} [rad, arm sizes] are no calibration's"
        return f"{_entry(row, column)}, is {number}: {large}"
    turned, moved = _deviation(kind, blank, table)
    return (
        f"table is that of another arm: its tool is up to {turned:.2g} rad and {moved:.2g} {unit} "
        f"away from the nominal arm's, where {MOST_DEVIATION} rad and {MOST_DEVIATION * size:.2g} "
        f"{unit} are taken; most of it is by {_entry(row, column)}: {number} in place of "
        f"{float(nominal[row, column]):.9g}"
    )


def _too_large(table: Floats, size: float) -> Bools:
    return np.abs(table) > MOST_NUMBER * np.where(LENGTHS, size, 1.0)


def _farthest(kind: Floats, blank: Floats, table: Floats) -> tuple[int, int]:
    """The number in whose place that of the nominal arm would take the tool nearest to it."""
    size, nominal = float(kind[LENGTH]), kind[TABLE:].reshape(table.shape)
    large = np.argwhere(_too_large(table, size))
    if len(large):
        row, column = large[0].tolist()
        return row, column
    left = np.empty(table.shape)
    for row, column in np.ndindex(*table.shape):
        other = table.copy()
        other[row, column] = nominal[row, column]
        turned, moved = _deviation(kind, blank, other)
        left[row, column] = max(turned, moved / size)
    row, column = np.unravel_index(np.argmin(left), left.shape)
    return int(row), int(column)


def _deviation(kind: Floats, blank: Floats, table: Floats) -> tuple[float, float]:
    """By how much the tool of a table may be turned, and moved."""
    arm = blank.copy()
    calibrate(kind, table.ravel(), arm)
    return float(arm[TURNED - NUMBERS]), float(arm[MOVED - NUMBERS])


def _exact_axes(kind: Floats, blank: Floats, table: Floats) -> str:
    """Three axes that are parallel, or meet, exactly."""
    for first, how in ((PARALLEL, "are parallel"), (MEETING, "meet")):
        for place in range(TRIPLES):
            alone = kind.copy()
            alone[PARALLEL : PARALLEL + TRIPLES] = alone[MEETING : MEETING + TRIPLES] = 0.0
            alone[first + place] = kind[first + place]
            if calibrate(alone, table.ravel(), blank.copy()) == NO_MISS:
                return f"axes {place + 1}, {place + 2} and {place + 3} {how}"
    raise AssertionError
