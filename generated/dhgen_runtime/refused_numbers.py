# SPDX-License-Identifier: MIT
"""The message for a table, or origins, that are refused: which numbers, or axes, are wrong."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from .calibrate import (
    ANOTHER_ARM,
    JOINTS,
    LEAST_MISS,
    LENGTH,
    MEETING,
    MOST_DEVIATION,
    MOST_NUMBER,
    NO_MISS,
    NOT_FINITE,
    PARALLEL,
    TABLE,
    TABLE_SHAPE,
    TRIPLES,
    calibrate,
)
from .calibration import CONSTANT, MOVED, NOMINAL, NUMBERS, TURNED

if TYPE_CHECKING:
    from .arrays import Bools, Floats

COLUMNS = ("theta", "d", "a", "alpha")
LENGTHS = (False, True, True, False)  # whether a column holds lengths
PLACES = ("x", "y", "z", "roll", "pitch", "yaw")
PLACES_LENGTHS = (True, True, True, False, False, False)


@dataclass(frozen=True, slots=True)
class Refused:
    """Numbers that are not taken.

    Attributes:
        kind: The numbers of the kind.
        blank: Those of an arm of which no table is known.
        given: The arm's own: a table (6, 4), or origins (7, 6).
        unit: How lengths are called.
    """

    kind: Floats
    blank: Floats
    given: Floats
    unit: str

    @property
    def is_table(self) -> bool:
        """Whether they are a table."""
        return self.given.shape == TABLE_SHAPE

    @property
    def size(self) -> float:
        """The size of the arm."""
        return float(self.kind[LENGTH])

    @property
    def lengths(self) -> tuple[bool, ...]:
        """Which columns hold lengths."""
        return LENGTHS if self.is_table else PLACES_LENGTHS

    def entry(self, row: int, column: int) -> str:
        """How a number is called."""
        if self.is_table:
            return f"table[{row}][{column}], {COLUMNS[column]} of row {row + 1}"
        of = f"joint {row + 1}" if row < JOINTS else "the frame behind the last joint"
        return f"origins[{row}][{column}], {PLACES[column]} of {of}"

    def number(self, row: int, column: int) -> str:
        """Its value, with its unit."""
        unit = self.unit if self.lengths[column] else "rad"
        return f"{float(self.given[row, column]):.9g} {unit}"

    def too_large(self) -> Bools:
        """Which numbers are larger than in any calibration."""
        return np.abs(self.given) > MOST_NUMBER * np.where(self.lengths, self.size, 1.0)

    def filled(self) -> tuple[Floats, int]:
        """The arm's array, and what `calibrate` returns."""
        arm = self.blank.copy()
        return arm, calibrate(self.kind, self.given.ravel(), arm)

    def deviation(self) -> tuple[float, float]:
        """By how much the tool may be turned, and moved."""
        arm, _ = self.filled()
        return float(arm[TURNED - NUMBERS]), float(arm[MOVED - NUMBERS])


def refusal(refused: Refused, fault: int) -> str:
    """What is wrong with the numbers.

    Args:
        refused: The numbers.
        fault: What `calibrate` returns for them.
    """
    what = "table" if refused.is_table else "origins"
    if fault == NOT_FINITE:
        row, column = np.argwhere(~np.isfinite(refused.given))[0].tolist()
        number = float(refused.given[row, column])
        return f"{refused.entry(row, column)}, is not finite: {number}"
    if fault == ANOTHER_ARM:
        return _another_arm(refused, what)
    return (
        f"in {what} {_exact_axes(refused)} to {LEAST_MISS:.0e}, as those of the nominal "
        "arm: such an arm has a closed form of its own, that of a robot file with these numbers"
    )


def _another_arm(refused: Refused, what: str) -> str:
    """By how much the arm is another one, and which number makes it so."""
    large = np.argwhere(refused.too_large())
    if len(large):
        row, column = large[0].tolist()
        number = f"{refused.entry(row, column)}, is {refused.number(row, column)}"
        return f"{number}: numbers above {MOST_NUMBER:.0e} [rad, arm sizes] are no calibration's"
    (turned, moved), size = refused.deviation(), refused.size
    verb = "is that" if refused.is_table else "are those"
    return (
        f"{what} {verb} of another arm: its tool is up to {turned:.2g} rad and {moved:.2g} "
        f"{refused.unit} away from the nominal arm's, where {MOST_DEVIATION} rad and "
        f"{MOST_DEVIATION * size:.2g} {refused.unit} are taken; most of it is by "
        f"{_farthest_number(refused) if refused.is_table else _farthest_link(refused)}"
    )


def _farthest_number(refused: Refused) -> str:
    """The number that moves the tool most: with the nominal arm's in its place it is nearest."""
    nominal = refused.kind[TABLE:].reshape(TABLE_SHAPE)
    left = np.empty(TABLE_SHAPE)
    for row, column in np.ndindex(*TABLE_SHAPE):
        other = refused.given.copy()
        other[row, column] = nominal[row, column]
        turned, moved = replace(refused, given=other).deviation()
        left[row, column] = max(turned, moved / refused.size)
    row, column = map(int, np.unravel_index(np.argmin(left), TABLE_SHAPE))
    number = f"{refused.entry(row, column)}: {refused.number(row, column)}"
    return f"{number} in place of {float(nominal[row, column]):.9g}"


def _farthest_link(refused: Refused) -> str:
    """Between which joints axes differ most from the nominal arm's, and by how much."""
    arm, _ = refused.filled()
    of, found = arm[-NUMBERS:], []
    for link in range(1, JOINTS):
        own, nominal = (
            of[at + 12 * link : at + 12 * link + 12].reshape(3, 4) for at in (CONSTANT, NOMINAL)
        )
        off = own - nominal
        chord, moved = float(np.linalg.norm(off[:, :3])), float(np.linalg.norm(off[:, 3]))
        turned = 2.0 * math.asin(min(chord / math.sqrt(8.0), 1.0))
        found.append((max(turned, moved / refused.size), link, turned, moved))
    _, link, turned, moved = max(found)
    distance = f"{turned:.2g} rad and {moved:.2g} {refused.unit} from where the nominal arm has it"
    return f"origins[{link}]: joint {link + 1} is {distance}, seen from joint {link}"


def _exact_axes(refused: Refused) -> str:
    """Three axes that are parallel, or meet, exactly."""
    for first, how in ((PARALLEL, "are parallel"), (MEETING, "meet")):
        for place in range(TRIPLES):
            alone = refused.kind.copy()
            alone[PARALLEL : PARALLEL + TRIPLES] = alone[MEETING : MEETING + TRIPLES] = 0.0
            alone[first + place] = refused.kind[first + place]
            if replace(refused, kind=alone).filled()[1] == NO_MISS:
                return f"axes {place + 1}, {place + 2} and {place + 3} {how}"
    raise AssertionError
