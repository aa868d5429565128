"""Arms with four turns and two slides: any turn may be hidden, and its polynomial is of degree 4.

Slides leave directions alone, so the turns are a spherical linkage of four bars (the runtime's
`four_turns` has the formulas). Its entry zz, M_zz where φ1 is known, is a quadratic in the middle
turn; with Δ the discriminant of that, the determinant of the slides' directions and the translation
is U + V √Δ. The polynomial w (U² − V² Δ) is of degree 4, w = 1 − M_zz²: w times the determinant has
the degree 3 in U and 2 in V, its norm 6, and divides by w once, as at w = 0 one of the two branches
remains finite.
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
