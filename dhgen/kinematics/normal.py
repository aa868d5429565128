"""The normal form of polynomials in cosines, sines and square roots: s^2 becomes 1 - c^2."""

from __future__ import annotations

from dataclasses import dataclass
from operator import itemgetter
from typing import TYPE_CHECKING

from sympy.polys.domains import QQ

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from sympy.polys.rings import PolyRing

    from dhgen.kinematics.constants import Constant, Polynomial


@dataclass(frozen=True, slots=True)
class NormalForm:
    """Rewrites even powers of some generators.

    Attributes:
        squares: Generator index and what its square is.
        exponents: Those of the generators of `squares` out of a monomial.
    """

    squares: tuple[tuple[int, Polynomial], ...]
    exponents: Callable[[tuple[int, ...]], tuple[int, ...]]

    def __call__(self, polynomial: Polynomial) -> Polynomial:
        """The polynomial with no generator of `squares` in a power above one."""
        if max(map(max, map(self.exponents, polynomial)), default=0) <= 1:
            return polynomial
        for index, square in self.squares:
            if any(monomial[index] > 1 for monomial in polynomial):
                polynomial = _reduce(polynomial, index, square)
        return polynomial


def _reduce(polynomial: Polynomial, index: int, square: Polynomial) -> Polynomial:
    ring = polynomial.ring
    total, nothing = ring.zero, ring.domain.zero
    powers: dict[int, Polynomial] = {}
    for monomial, coefficient in polynomial.items():
        half, rest = divmod(monomial[index], 2)
        if not half:
            total[monomial] = total.get(monomial, nothing) + coefficient
            continue
        if half not in powers:
            powers[half] = square**half
        lowered = (*monomial[:index], rest, *monomial[index + 1 :])
        for factor, number in powers[half].items():
            product = ring.monomial_mul(lowered, factor)
            total[product] = total.get(product, nothing) + coefficient * number
    total.strip_zero()
    return total


def normal_form(
    ring: PolyRing, constants: Iterable[Constant], angles: Mapping[str, str]
) -> NormalForm:
    """The normal form of a ring.

    Args:
        ring: The ring.
        constants: Those of its generators that are numbers: square roots and sines of twists.
        angles: The name of the cosine for the name of every sine.
    """
    index = {str(symbol): position for position, symbol in enumerate(ring.symbols)}
    cosines = {c.name: c.cosine for c in constants if c.cosine is not None} | dict(angles)
    squares = [(index[sine], 1 - ring.gens[index[cosine]] ** 2) for sine, cosine in cosines.items()]
    squares += [
        (index[c.name], ring.ground_new(QQ(c.square.numerator, c.square.denominator)))
        for c in constants
        if c.square is not None
    ]
    # a getter of at least two places gives tuples
    places = [place for place, _ in squares]
    exponents = itemgetter(*places, *places) if places else lambda _: (0,)
    return NormalForm(tuple(squares), exponents)
