"""Drives: how a chain's angles and lengths come from the values that the caller counts, and back.

A joint's angle or length is sign q + the shares of other joints' drives + offset. No joint hangs on
itself, so that the matrix of this is triangular in some order, and its inverse as exact as it is.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray


@dataclass(frozen=True, slots=True)
class Share:
    """What the drive of another joint adds to a joint's angle or length.

    Attributes:
        drive: The number of the other joint, from 1.
        factor: What its value is multiplied by [this joint's unit per that joint's].
        meaning: The factor as a formula, for comments.
    """

    drive: int
    factor: float
    meaning: str = ""


@dataclass(frozen=True, slots=True)
class SumLimit:
    """Limits of a sum of drives' values.

    Attributes:
        factors: Of every drive.
        lowest: The lowest value of the sum [rad or length].
        highest: The highest.
        turns: Whether it is an angle.
    """

    factors: tuple[float, ...]
    lowest: float
    highest: float
    turns: bool


@dataclass(frozen=True, slots=True)
class Drives:
    """The drives of an arm.

    Attributes:
        signs: The factor of each joint's own drive, +1 or -1.
        offsets: What is added [rad or length].
        shares: What the other drives add to each joint.
    """

    signs: tuple[int, ...]
    offsets: tuple[float, ...]
    shares: tuple[tuple[Share, ...], ...]

    @property
    def are_coupled(self) -> bool:
        """Whether a drive moves more than its own joint."""
        return any(self.shares)

    @property
    def order(self) -> tuple[int, ...]:
        """The joints, from 1, each behind joints whose drives move it, too."""
        found: list[int] = []
        pending = list(range(1, len(self.signs) + 1))
        while pending:
            ready = [j for j in pending if all(s.drive in found for s in self.shares[j - 1])]
            found.append(ready[0])
            pending.remove(ready[0])
        return tuple(found)

    @property
    def matrix(self) -> FloatArray:
        """M, with M q + offsets the angles and lengths, (n, n)."""
        M = np.diag(np.array(self.signs, np.float64))
        for place, shares in enumerate(self.shares):
            for share in shares:
                M[place, share.drive - 1] = share.factor
        return M

    @property
    def inverse(self) -> FloatArray:
        """The inverse of M, by substitution, (n, n)."""
        found = np.zeros((len(self.signs), len(self.signs)))
        for joint in self.order:
            row = np.eye(len(self.signs))[joint - 1]
            for share in self.shares[joint - 1]:
                row = row - share.factor * found[share.drive - 1]
            found[joint - 1] = self.signs[joint - 1] * row
        return found

    def values(self, q: FloatArray) -> FloatArray:
        """Angles and lengths of drives' values (..., n)."""
        if self.are_coupled:
            return np.asarray(q @ self.matrix.T + self.offsets)
        return np.asarray(q * self.signs + self.offsets)

    def rates(self, along: FloatArray) -> FloatArray:
        """Derivatives by the drives (..., n) from derivatives by the angles and lengths."""
        return np.asarray(along @ self.matrix if self.are_coupled else along * self.signs)

    def back(self, values: Sequence[FloatArray]) -> list[FloatArray]:
        """The drives' values, one after another, for angles and lengths."""
        found: dict[int, FloatArray] = {}
        for joint in self.order:
            place = joint - 1
            value = values[place] - self.offsets[place]
            for share in self.shares[place]:
                value = value - share.factor * found[share.drive]
            found[joint] = self.signs[place] * value
        return [found[joint] for joint in range(1, len(values) + 1)]
