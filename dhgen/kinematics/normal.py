"""The normal form of polynomials in cosines, sines and square roots: s^2 becomes 1 - c^2."""

from __future__ import annotations

from dataclasses import dataclass
from math import lcm
from typing import TYPE_CHECKING

from sympy.polys.domains import QQ

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from sympy.polys.rings import PolyRing

    from dhgen.kinematics.constants import Constant, Polynomial


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


LOWEST = (1 << BITS) - 1  # the bits of the exponent at place 0
ABOVE_ONE = LOWEST - 1  # those of them that are set above one


@dataclass(frozen=True, slots=True)
class Square:
    """What the square of a generator is.

    Attributes:
        shift: Of the generator's exponent in a packed monomial.
        terms: The square times its common denominator.
        below: That denominator.
    """

    shift: int
    terms: Packed
    below: int


@dataclass(frozen=True, slots=True)
class NormalForm:
    """Rewrites even powers of some generators.

    Attributes:
        ring: The ring of the polynomials.
        squares: In the order of rewriting.
        high: The bits of a packed monomial of which none is set in normal form.
    """

    ring: PolyRing
    squares: tuple[Square, ...]
    high: int

    def __call__(self, polynomial: Polynomial) -> Polynomial:
        """The polynomial with no generator of `squares` in a power above one."""
        (terms,), below = packed([polynomial])
        if not any(map(self.high.__and__, terms)):
            return polynomial
        return self._unpacked(terms, below)

    def products(self, terms: Iterable[tuple[int, Polynomial, Polynomial]]) -> Polynomial:
        """The sum of n f g, in normal form."""
        nonzero = [each for each in terms if all(each)]
        if not nonzero:
            return self.ring.zero
        numbers, *factors = zip(*nonzero, strict=True)
        (firsts, below), (seconds, other) = map(packed, factors)
        total: Packed = {}
        for number, first, second in zip(numbers, firsts, seconds, strict=True):
            add_product(total, number, first, second)
        return self._unpacked(total, below * other)

    def _unpacked(self, terms: Packed, below: int) -> Polynomial:
        if any(map(self.high.__and__, terms)):
            for square in self.squares:
                if any(map((ABOVE_ONE << square.shift).__and__, terms)):
                    terms, below = _reduced(terms, below, square)
        return unpacked(self.ring, terms, below)


def _reduced(terms: Packed, below: int, square: Square) -> tuple[Packed, int]:
    """Terms over a common denominator, without powers above one of one generator."""
    shift = square.shift
    high = [monomial for monomial in terms if monomial >> shift & ABOVE_ONE]
    halves = [(monomial >> shift & LOWEST) // 2 for monomial in high]
    most = max(halves)
    powers: list[Packed] = [{0: 1}]
    for _ in range(most):
        power: Packed = {}
        add_product(power, 1, powers[-1], square.terms)
        powers.append(power)
    lowered: list[Packed] = [{} for _ in powers]
    for half, monomial in zip(halves, high, strict=True):
        lowered[half][monomial - (2 * half << shift)] = terms[monomial]
    scale = square.below**most
    total = {
        monomial: scale * number
        for monomial, number in terms.items()
        if not monomial >> shift & ABOVE_ONE
    }
    for half in range(1, most + 1):
        add_product(total, square.below ** (most - half), lowered[half], powers[half])
    return total, below * scale


def normal_form(
    ring: PolyRing, constants: Iterable[Constant], angles: Mapping[str, str]
) -> NormalForm:
    """The normal form of a ring.

    Args:
        ring: The ring.
        constants: Those of its generators that are numbers: square roots and sines of twists.
        angles: The name of the cosine for the name of every sine.
    """
    index = {symbol.name: position for position, symbol in enumerate(ring.symbols)}
    cosines = {c.name: c.cosine for c in constants if c.cosine is not None} | dict(angles)
    squares = [(index[sine], 1 - ring.gens[index[cosine]] ** 2) for sine, cosine in cosines.items()]
    squares += [
        (index[c.name], ring.ground_new(QQ(c.square.numerator, c.square.denominator)))
        for c in constants
        if c.square is not None
    ]
    found = []
    for place, polynomial in squares:
        (terms,), below = packed([polynomial])
        found.append(Square(BITS * place, terms, below))
    high = sum(ABOVE_ONE << square.shift for square in found)
    return NormalForm(ring, tuple(found), high)
