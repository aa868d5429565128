"""What lowering and printing need of polynomials: factors, parts and values."""

from __future__ import annotations

from fractions import Fraction
from math import gcd, lcm
from operator import itemgetter, sub
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from collections.abc import Set as AbstractSet

    from sympy.polys.rings import PolyRing

    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial


def primitive(polynomial: Polynomial) -> tuple[Fraction, Polynomial]:
    """The rational factor that leaves whole, coprime coefficients; it carries no sign of a sum.

    The factor is negative only when every coefficient is.
    """
    parts = [(int(c.numerator), int(c.denominator)) for c in polynomial.values()]
    below = lcm(*{denominator for _, denominator in parts})
    above = gcd(*{numerator * (below // denominator) for numerator, denominator in parts})
    if all(numerator < 0 for numerator, _ in parts):
        above = -above
    if above == below:
        return Fraction(1), polynomial
    return Fraction(above, below), polynomial.mul_ground(polynomial.ring.domain(below, above))


def content(polynomial: Polynomial) -> tuple[tuple[int, ...], Polynomial]:
    """The common monomial, and what is left without it."""
    common = tuple(map(min, zip(*polynomial, strict=True)))
    if not any(common):
        return common, polynomial
    lowered = {tuple(map(sub, monomial, common)): c for monomial, c in polynomial.items()}
    return common, _made(polynomial.ring, lowered)


def split(polynomial: Polynomial, places: AbstractSet[int]) -> tuple[Polynomial, Polynomial]:
    """The terms with any of these generators, and the others."""
    inside, outside = polynomial.ring.zero, polynomial.ring.zero
    exponents = itemgetter(*places, *places)  # at least two places make tuples
    for monomial, coefficient in polynomial.items():
        part = inside if any(exponents(monomial)) else outside
        part[monomial] = coefficient
    return inside, outside


def divided(polynomial: Polynomial, place: int) -> Polynomial:
    """A polynomial of which every term holds the generator, without it once."""
    lowered = {
        (*monomial[:place], monomial[place] - 1, *monomial[place + 1 :]): coefficient
        for monomial, coefficient in polynomial.items()
    }
    return _made(polynomial.ring, lowered)


def used_places(polynomial: Polynomial) -> frozenset[int]:
    """The generators that occur."""
    columns = zip(*polynomial, strict=True)
    return frozenset(place for place, exponents in enumerate(columns) if any(exponents))


def by_powers(polynomial: Polynomial, places: Sequence[int]) -> dict[tuple[int, ...], Polynomial]:
    """A polynomial by the exponents of the generators at some places."""
    ring = polynomial.ring
    parts: dict[tuple[int, ...], Polynomial] = {}
    exponents_of = itemgetter(*places, *places)  # at least two places make tuples
    for monomial, coefficient in polynomial.items():
        exponents = exponents_of(monomial)[: len(places)]
        part = parts.get(exponents)
        if part is None:
            part = parts[exponents] = ring.zero
        left = list(monomial)
        for place in places:
            left[place] = 0
        part[tuple(left)] = coefficient
    return parts


def substitute(polynomial: Polynomial, change: Mapping[int, Polynomial]) -> Polynomial:
    """The polynomial with some generators replaced."""
    total = polynomial.ring.zero
    for exponents, rest in by_powers(polynomial, tuple(change)).items():
        part = rest
        for value, exponent in zip(change.values(), exponents, strict=True):
            if exponent:
                part = part * value**exponent
        total += part
    return total


def _made(ring: PolyRing, terms: Mapping[tuple[int, ...], object]) -> Polynomial:
    """The polynomial with these terms, none of them zero and all of the ring's domain."""
    polynomial = ring.zero
    polynomial.update(terms)
    return polynomial


def constant_value(algebra: Algebra, polynomial: Polynomial) -> float:
    """A polynomial of lengths and twists with the arm's own numbers."""
    values = {c.name: c.value for c in algebra.chain.constants}
    return sum(terms_in_numbers(polynomial, values), 0.0)


def terms_in_numbers(polynomial: Polynomial, values: Mapping[str, float]) -> list[float]:
    """The terms of a polynomial, one by one, from the values of its generators by their names."""
    names = [symbol.name for symbol in polynomial.ring.symbols]
    terms: list[float] = []
    for powers, factor in polynomial.terms():
        term = int(factor.numerator) / int(factor.denominator)
        for name, power in zip(names, powers, strict=True):
            term *= values[name] ** power if power else 1.0
        terms.append(term)
    return terms
