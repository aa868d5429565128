"""By how much two arms differ at most, at any joint values."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from dhgen.nominal.fit import DIGITS, lengths_behind

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

# Of what two links side by side differ by: of a wrist that one length misses, a second solution
# was seen at 0.95 of the distance; this leaves half as much again.
MARGIN_SIDE_BY_SIDE = 1.5
MARGIN_DIGITS = 3  # further ones differ from machine to machine
ROUNDING = 1e-9  # [rad, arm sizes]


@dataclass(frozen=True, slots=True)
class Deviation:
    """What the tool of an arm may be away from where that of another arm is.

    Attributes:
        angle: The most that it is turned [rad].
        length: The most that its origin is moved.
        margin: Factor, 1 or more, by which these bounds are enlarged for poses near the end of a
            branch: there a branch may have three solutions, not one, within about what two
            neighbouring links differ by, which join the three axes of a wrist, or parallel ones.
    """

    angle: float
    length: float
    margin: float

    @property
    def ball(self) -> tuple[float, float]:
        """How far poses reach that are looked at: angle and length."""
        return _rounded_up(self.margin * self.angle), _rounded_up(self.margin * self.length)


def most_deviation(arm: FloatArray, other: FloatArray, size: float) -> Deviation:
    """A bound for all joint values: what each pair of constants differs by adds up.

    A rotation counts at the length of what is behind it.

    Args:
        arm: C0 ... Cn of C0 J(q1) C1 ... J(qn) Cn, (n + 1, 4, 4).
        other: The same of the other arm.
        size: Of the arm.
    """
    angles, lengths = [], []
    for C, D, behind in zip(arm, other, lengths_behind(other).tolist(), strict=True):
        angles.append(_angle_between(C[:3, :3], D[:3, :3]))
        lengths.append(angles[-1] * behind + float(np.linalg.norm(C[:3, 3] - D[:3, 3])))
    most = max(_most_side_by_side(angles), _most_side_by_side([each / size for each in lengths]))
    margin = max(1.0, round(MARGIN_SIDE_BY_SIDE * most, MARGIN_DIGITS))
    return Deviation(_rounded_up(sum(angles)), _rounded_up(sum(lengths)), margin)


def _most_side_by_side(parts: list[float]) -> float:
    """The largest share of a sum that two neighbouring parts have; zero if that is rounding."""
    whole = sum(parts)
    pairs = (one + other for one, other in pairwise(parts))
    return 0.0 if whole < ROUNDING else max(pairs) / whole


def _rounded_up(number: float) -> float:
    """A number, rounded up to a few digits: further ones differ from machine to machine."""
    return round(math.ceil(number * 10.0**DIGITS) / 10.0**DIGITS, DIGITS)


def _angle_between(R: FloatArray, S: FloatArray) -> float:
    """The angle of the rotation between two; by its chord, which has all digits of a small one."""
    chord = float(np.linalg.norm(R - S)) / np.sqrt(2.0)
    return float(2.0 * np.arcsin(min(0.5 * chord, 1.0)))
