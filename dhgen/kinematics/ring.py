"""What lowering and printing need of polynomials: factors, parts and values."""

from __future__ import annotations

from fractions import Fraction
from math import gcd, lcm
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping
    from collections.abc import Set as AbstractSet

    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial


def primitive(polynomial: Polynomial) -> tuple[Fraction, Polynomial]:
    """The rational factor that leaves whole, coprime coefficients; it carries no sign of a sum.

    The factor is negative only when every coefficient is.
    """
    parts = [Fraction(int(c.numerator), int(c.denominator)) for _, c in polynomial.terms()]
    below = lcm(*(part.denominator for part in parts))
    factor = Fraction(gcd(*(abs(int(part * below)) for part in parts)), below)
    if all(part < 0 for part in parts):
        factor = -factor
    domain = polynomial.ring.domain
    return factor, polynomial.mul_ground(domain(factor.denominator) / domain(factor.numerator))


def content(polynomial: Polynomial) -> tuple[tuple[int, ...], Polynomial]:
    """The common monomial, and what is left without it."""
    common = tuple(min(exponents) for exponents in zip(*polynomial, strict=True))
    if not any(common):
        return common, polynomial
    lowered = {
        tuple(e - c for e, c in zip(monomial, common, strict=True)): coefficient
        for monomial, coefficient in polynomial.terms()
    }
    return common, polynomial.ring.from_dict(lowered)


def split(polynomial: Polynomial, places: AbstractSet[int]) -> tuple[Polynomial, Polynomial]:
    """The terms with any of these generators, and the others."""
    inside: dict[tuple[int, ...], object] = {}
    outside: dict[tuple[int, ...], object] = {}
    for monomial, coefficient in polynomial.terms():
        part = inside if any(monomial[place] for place in places) else outside
        part[monomial] = coefficient
    return polynomial.ring.from_dict(inside), polynomial.ring.from_dict(outside)


def divided(polynomial: Polynomial, place: int) -> Polynomial:
    """A polynomial of which every term holds the generator, without it once."""
    lowered = {
        (*monomial[:place], monomial[place] - 1, *monomial[place + 1 :]): coefficient
        for monomial, coefficient in polynomial.terms()
    }
    return polynomial.ring.from_dict(lowered)


def used_places(polynomial: Polynomial) -> frozenset[int]:
    """The generators that occur."""
    return frozenset(p for monomial in polynomial for p, e in enumerate(monomial) if e)


def substitute(polynomial: Polynomial, change: Mapping[int, Polynomial]) -> Polynomial:
    """The polynomial with some generators replaced."""
    ring = polynomial.ring
    total = ring.zero
    for monomial, coefficient in polynomial.terms():
        rest = tuple(0 if place in change else e for place, e in enumerate(monomial))
        part = ring.from_dict({rest: coefficient})
        for place in sorted(change):
            if monomial[place]:
                part = part * change[place] ** monomial[place]
        total += part
    return total


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
