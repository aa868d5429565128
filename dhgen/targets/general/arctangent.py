"""The polynomial of the arctangent in lanes of angles."""

from __future__ import annotations

from dataclasses import dataclass

from dhgen.targets.arctangent import STEEP, arctangent_coefficients
from dhgen.targets.general.numbers import row


@dataclass(frozen=True, slots=True)
class GeneralArctangent:
    """What the arctangent is made of.

    Attributes:
        odd: Coefficients of its odd powers from the third on.
        highest: Place of the last coefficient.
        second_highest: And of the one before.
        tangent: Up to which ratio the polynomial serves as it is.
    """

    odd: str = row(arctangent_coefficients())
    highest: int = len(arctangent_coefficients()) - 1
    second_highest: int = len(arctangent_coefficients()) - 2
    tangent: float = STEEP
