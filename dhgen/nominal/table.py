"""Tables of arms with a structure: which numbers of a table are exact, and the table's motions."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.descriptions.misses import GAP, TILT
from dhgen.kinematics.neighbours import EXACT

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.nominal.lines import Neighbours

QUARTER = 0.5 * math.pi
NONE_KEPT: frozenset[int] = frozenset()


@dataclass(frozen=True, slots=True)
class Table:
    """The links between axes, first to last: T_z(d) T_x(a) R_x(alpha).

    Attributes:
        quarters: Each twist as a multiple of a right angle; None where it is neither.
        alpha: Each twist [rad].
        a: Each link length.
        d: Each joint offset; the first is the base's.
    """

    quarters: tuple[int | None, ...]
    alpha: tuple[float, ...]
    a: tuple[float, ...]
    d: tuple[float, ...]

    def links(self, lengths: FloatArray, offsets: FloatArray) -> FloatArray:
        """The transforms between the joints, (n - 1, 4, 4).

        Args:
            lengths: In the place of all that are not zero: of a, then of d.
            offsets: What each angle but the first and the last is more, (n - 2,).
        """
        a, d = self.filled(lengths)
        return np.array(
            [
                _link(offset, d[k], a[k], self.alpha[k])
                for k, offset in enumerate([0.0, *map(float, offsets)])
            ]
        )

    @property
    def joints(self) -> int:
        """The number of axes."""
        return len(self.alpha) + 1

    @property
    def lengths(self) -> FloatArray:
        """All lengths that are not zero: of a, then of d."""
        return np.array([length for length in (*self.a, *self.d) if length])

    def filled(self, lengths: FloatArray) -> tuple[list[float], list[float]]:
        """Both columns with these lengths in place of the nonzero ones."""
        left = iter(map(float, lengths))
        a, d = ([next(left) if each else 0.0 for each in column] for column in (self.a, self.d))
        return a, d


def rounded_table(
    found: tuple[Neighbours, ...], size: float, kept: frozenset[int] = NONE_KEPT
) -> Table:
    """The table with what is nearly zero or a right angle taken as that.

    Args:
        found: How axes lie to each other.
        size: Of the arm.
        kept: Places of lengths, of a, then of d, that are not zero all the same.
    """
    quarters = [_quarter(each.alpha) for each in found]
    lengths = [
        number if place in kept else _or_zero(number, size)
        for place, number in enumerate(lengths_of(found))
    ]
    return Table(
        tuple(quarters),
        tuple(
            each.alpha if quarter is None else quarter * QUARTER
            for each, quarter in zip(found, quarters, strict=True)
        ),
        tuple(lengths[: len(found)]),
        tuple(lengths[len(found) :]),
    )


def small_lengths(found: tuple[Neighbours, ...], size: float) -> tuple[int, ...]:
    """Places of lengths, of a, then of d, that are nearly zero and not quite."""
    return tuple(
        place
        for place, number in enumerate(lengths_of(found))
        if abs(number) > EXACT * size and not _or_zero(number, size)
    )


def lengths_of(found: tuple[Neighbours, ...]) -> list[float]:
    """The lengths of common normals, then the offsets between their feet."""
    return [*(each.a for each in found), *(each.d for each in found)]


def _quarter(angle: float) -> int | None:
    nearest = round(angle / QUARTER)
    return nearest if abs(angle - nearest * QUARTER) < TILT else None


def _or_zero(length: float, size: float) -> float:
    return 0.0 if abs(length) < GAP * size else length


def _link(theta: float, d: float, a: float, alpha: float) -> FloatArray:
    c, s, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
    return np.array(
        [
            [c, -s * ca, s * sa, a * c],
            [s, c * ca, -c * sa, a * s],
            [0.0, sa, ca, d],
            [0.0, 0.0, 0.0, 1.0],
        ]
    )
