"""Arms with four turns and two slides: any turn may be hidden, and its polynomial is of degree 4.

The runtime has the polynomial in closed form (see its `four_turns`).
"""

from __future__ import annotations

from dataclasses import dataclass

from dhgen.general.formulation import Formulation


@dataclass(frozen=True, slots=True)
class FourTurns:
    """A way to hide one of four turns.

    Attributes:
        formulation: The order of the joints; φ1 is hidden.
        slides: Which two of the six joints slide, from 0.
    """

    formulation: Formulation
    slides: tuple[int, ...]

    @property
    def solutions_per_root(self) -> int:
        """How many solutions have one root of the polynomial."""
        return 1


def turns_to_hide(slides: tuple[int, ...]) -> tuple[Formulation, ...]:
    """The four formulations.

    Args:
        slides: Which two of the six joints slide, from 0.
    """
    every = [Formulation(tuple((first + i) % 6 for i in range(6)), 1) for first in range(6)]
    return tuple(f for f in every if f.joints[0] not in slides)
