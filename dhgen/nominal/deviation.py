"""By how much two arms differ at most, at any joint values."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.nominal.fit import DIGITS, lengths_behind

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray


@dataclass(frozen=True, slots=True)
class Deviation:
    """What the tool of an arm may be away from where that of another arm is.

    Attributes:
        angle: The most that it is turned [rad].
        length: The most that its origin is moved.
    """

    angle: float
    length: float


def most_deviation(arm: FloatArray, other: FloatArray) -> Deviation:
    """A bound for all joint values: what each pair of constants differs by adds up.

    A rotation counts at the length of what is behind it.

    Args:
        arm: C0 ... Cn of C0 J(q1) C1 ... J(qn) Cn, (n + 1, 4, 4).
        other: The same of the other arm.
    """
    angle = length = 0.0
    for C, D, behind in zip(arm, other, lengths_behind(other).tolist(), strict=True):
        turned = _angle_between(C[:3, :3], D[:3, :3])
        length += turned * behind + float(np.linalg.norm(C[:3, 3] - D[:3, 3]))
        angle += turned
    return Deviation(_rounded_up(angle), _rounded_up(length))


def _rounded_up(number: float) -> float:
    """A number up to which further digits, which differ from machine to machine, don't count."""
    return round(math.ceil(number * 10.0**DIGITS) / 10.0**DIGITS, DIGITS)


def _angle_between(R: FloatArray, S: FloatArray) -> float:
    """The angle of the rotation between two; by its chord, which has all digits of a small one."""
    chord = float(np.linalg.norm(R - S)) / np.sqrt(2.0)
    return float(2.0 * np.arcsin(min(0.5 * chord, 1.0)))
