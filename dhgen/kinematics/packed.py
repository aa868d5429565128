"""Polynomials made ready for many products: whole coefficients, a monomial as one integer.

Every exponent has a byte of its own, so that the product of two monomials is the sum of two
integers. Exponents of this project stay far below what fills a byte.
"""

from __future__ import annotations

from math import lcm
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from sympy.polys.rings import PolyRing

    from dhgen.kinematics.constants import Polynomial

BITS = 8  # of an exponent
Packed = dict[int, int]  # coefficients by monomials


def packed(polynomials: Sequence[Polynomial]) -> tuple[list[Packed], int]:
    """Polynomials times their common denominator, and that."""
    below = lcm(*{int(c.denominator) for each in polynomials for c in each.values()})
    return [
        {
            int.from_bytes(bytes(monomial), "little"): int(c.numerator)
            * (below // int(c.denominator))
            for monomial, c in each.items()
        }
        for each in polynomials
    ], below


def unpacked(ring: PolyRing, terms: Mapping[int, int], below: int) -> Polynomial:
    """The polynomial with these terms over a common denominator; zeros are left out."""
    domain, size = ring.domain, len(ring.gens)
    numbers = {number: domain(number, below) for number in set(terms.values())}
    polynomial = ring.zero
    for monomial, number in terms.items():
        if number:
            polynomial[tuple(monomial.to_bytes(size, "little"))] = numbers[number]
    return polynomial


def add_product(total: Packed, factor: int, first: Packed, second: Packed) -> None:
    """Adds the product of a number and two polynomials to a sum."""
    for one, number in first.items():
        scaled = factor * number
        for other, coefficient in second.items():
            monomial = one + other
            total[monomial] = total.get(monomial, 0) + scaled * coefficient
