"""Sizes of the equations that the elimination starts from, and what a slide changes in them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel


@dataclass(frozen=True, slots=True)
class Equations:
    """The equations of a formulation.

    Attributes:
        left_slide: Whether a joint on the left side slides.
        right_slide: Whether one on the right side does.
        monomials: Of the right side that are eliminated.
        mixed: Equations that they are eliminated from.
        invariants: Numbers that the right side's angles are recovered from.
        powers: Of a slide's length, in the order of their places.
        one: Place of the constant.
        square: Place of the square.
    """

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
    return Equations(
        left_slide=bool(kernel.loop.slides) and not right,
        right_slide=right,
        # a turn next to the left side leaves two of the eight monomials to some features alone
        monomials=8 if right else 6,
        mixed=14 if right else 8,
        invariants=3 if right else 5,
        powers="1, d and d^2" if right else "d^2, d and 1",
        one=0 if right else 2,
        square=2 if right else 0,
    )
