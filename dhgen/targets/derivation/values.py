"""The value of a polynomial in the arm's constants."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial


def constant_value(algebra: Algebra, polynomial: Polynomial) -> float:
    """A polynomial of lengths and twists with the arm's own numbers."""
    values = {algebra.index[c.name]: c.value for c in algebra.chain.constants}
    total = 0.0
    for monomial, coefficient in polynomial.terms():
        part = int(coefficient.numerator) / int(coefficient.denominator)
        for place, exponent in enumerate(monomial):
            part *= values[place] ** exponent if exponent else 1.0
        total += part
    return total
