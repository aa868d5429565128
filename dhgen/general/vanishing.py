"""Values of held joints at which the arm has more structure and formulations are of no use."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.general.links import Value

# How far a joint may be from such a value to count as there [rad, arm sizes]: what a formulation
# has left of a polynomial is then no more than rounding.
THERE = 1e-12


@dataclass(frozen=True, slots=True)
class Vanishing:
    """A value of a held joint, and the formulations that are not tried there.

    Attributes:
        place: Which of the values that are given, from 0.
        value: The value.
        slides: Whether it is a length.
        formulations: Numbers of formulations of the kernel, not all of them.
    """

    place: int
    value: Value
    slides: bool
    formulations: tuple[int, ...]
