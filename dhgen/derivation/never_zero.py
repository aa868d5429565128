"""Whether factors that a known angle decides on can be zero, from the arm's numbers."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.derivation.geometry import NEAR
from dhgen.kinematics.ring import used_places

if TYPE_CHECKING:
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial

LOOKED_AT = 2048  # angles, evenly spread
Terms = list[tuple[float, int, int]]  # a number, and the powers of the cosine and the sine


def are_never_zero(algebra: Algebra, *factors: Polynomial) -> bool:
    """Whether factors are never zero together, as far as numbers tell.

    They do if the factors, or some of them, hold the cosine and sine of one angle, and else
    lengths and twists alone: between two of the angles that are looked at, none can change by more
    than its slope allows.
    """
    if len(factors) > 1 and any(are_never_zero(algebra, factor) for factor in factors):
        return True
    constants = frozenset(algebra.index[constant.name] for constant in algebra.chain.constants)
    moving = frozenset().union(*map(used_places, factors)) - constants
    pairs = [(algebra.index[a.cosine], algebra.index[a.sine]) for a in algebra.angles]
    pair = next((pair for pair in pairs if moving <= set(pair)), None)
    if pair is None:
        return False
    each = [_terms(algebra, factor, *pair) for factor in factors]
    half = math.pi / LOOKED_AT
    margin = math.hypot(*(half * _slope(terms) + NEAR * _size(terms) for terms in each))
    angles = (2 * half * k for k in range(LOOKED_AT))
    return all(math.hypot(*(_value(terms, angle) for terms in each)) > margin for angle in angles)


def _terms(algebra: Algebra, factor: Polynomial, cosine: int, sine: int) -> Terms:
    values = {algebra.index[each.name]: each.value for each in algebra.chain.constants}
    found = []
    for powers, coefficient in factor.terms():
        value = int(coefficient.numerator) / int(coefficient.denominator)
        value *= math.prod(number ** powers[place] for place, number in values.items())
        found.append((value, powers[cosine], powers[sine]))
    return found


def _size(terms: Terms) -> float:
    return sum(abs(value) for value, _, _ in terms)


def _slope(terms: Terms) -> float:
    """What the derivative by the angle does not exceed."""
    return sum(abs(value) * (i + j) for value, i, j in terms)


def _value(terms: Terms, angle: float) -> float:
    c, s = math.cos(angle), math.sin(angle)
    return sum(value * c**i * s**j for value, i, j in terms)
