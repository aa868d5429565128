"""Sizes of the equations that the elimination starts from, and what a slide changes in them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.general import hidden_slide

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel


@dataclass(frozen=True, slots=True)
class HiddenSlide:
    """The length d = unit tan((psi + advance) / 2).

    Attributes:
        order: Half the order of the determinant's zero where it is infinite.
        unit: The length at a quarter of a turn [arm sizes].
        square: Its square.
        cosine: Of the advance.
        sine: Of the same.
    """

    order: int
    unit: float = hidden_slide.UNIT
    square: float = hidden_slide.UNIT**2
    cosine: float = hidden_slide.ADVANCE[0]
    sine: float = hidden_slide.ADVANCE[1]


@dataclass(frozen=True, slots=True)
class Equations:
    """The equations of a formulation.

    Attributes:
        hidden_slide: Where the joint that is hidden slides, how its length becomes an angle.
        left_slide: Whether one of its partners slides.
        right_slide: Whether one on the right side does.
        monomials: Of the right side that are eliminated.
        mixed: Equations that they are eliminated from.
        invariants: Numbers that the right side's angles are recovered from.
        powers: Of a slide's length, in the order of their places.
        one: Place of the constant.
        square: Place of the square.
    """

    hidden_slide: HiddenSlide | None
    left_slide: bool
    right_slide: bool
    monomials: int
    mixed: int
    invariants: int
    powers: str
    one: int
    square: int


def equations(kernel: GeneralKernel) -> Equations:
    """The equations of an arm."""
    right = kernel.slides_on_the_right
    rising = right or kernel.hides_a_slide
    return Equations(
        hidden_slide=HiddenSlide(kernel.first.order) if kernel.hides_a_slide else None,
        left_slide=kernel.slides_beside,
        right_slide=right,
        # a turn next to the left side leaves two of the eight monomials to some features alone
        monomials=8 if right else 6,
        mixed=14 if right else 8,
        invariants=3 if right else 5,
        powers="1, d and d^2" if rising else "d^2, d and 1",
        one=0 if rising else 2,
        square=2 if rising else 0,
    )
