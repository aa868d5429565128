"""Angles, and the polynomial of the arctangent."""

from __future__ import annotations

import math
from dataclasses import dataclass

from dhgen.program.arctangent import STEEP, arctangent_coefficients
from dhgen.targets.general.numbers import row


@dataclass(frozen=True, slots=True)
class Angles:
    """Parts of a turn [rad].

    Attributes:
        turn: A whole one.
        pi: Half of one.
        almost_pi: What is as good as pi.
    """

    turn: str = repr(2 * math.pi)
    pi: str = repr(math.pi)
    almost_pi: str = repr(math.pi - 1e-14)


@dataclass(frozen=True, slots=True)
class Arctangent:
    """What the arctangent is made of.

    Attributes:
        odd: Coefficients of its odd powers from the third on.
        highest: Place of the last coefficient.
        second_highest: And of the one before.
        tangent: Up to which ratio the polynomial serves as it is.
        quarter: A quarter of pi.
        half: Half of it.
        pi: All of it.
    """

    odd: str = row(arctangent_coefficients())
    highest: int = len(arctangent_coefficients()) - 1
    second_highest: int = len(arctangent_coefficients()) - 2
    tangent: str = repr(STEEP)
    quarter: str = repr(math.pi / 4)
    half: str = repr(math.pi / 2)
    pi: str = repr(math.pi)
