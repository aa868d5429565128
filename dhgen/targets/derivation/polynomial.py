"""Polynomials as people write them: nested by joints, parameters before cosines, signs in front.

The group of generators with the highest rank stands outermost, so that
c2 (c1 t11 + s1 t21) + s2 t31 comes out when joint 2 was solved after joint 1.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING

from dhgen.kinematics.ring import (
    content,
    primitive,
    split,
    used_places,
)
from dhgen.targets.derivation.formula import (
    ZERO,
    Minus,
    Number,
    Power,
    Quotient,
    add,
    minus,
    times,
)
from dhgen.targets.derivation.names import symbols

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial
    from dhgen.targets.derivation.formula import Formula, Symbol


@dataclass(frozen=True, slots=True)
class Writer:
    """Writes the polynomials of one arm.

    Attributes:
        algebra: Whose generators occur.
        rank: For a generator's name, how far outside it stands; equal for a cosine and its sine.
        known: Forms that have a letter of their own, with positive first coefficient.
        letters: The letter of every generator.
    """

    algebra: Algebra
    rank: Callable[[str], int]
    known: Mapping[Polynomial, Formula] = field(default_factory=dict)
    letters: Mapping[str, Symbol] = field(default_factory=dict)

    def write(self, polynomial: Polynomial) -> Formula:
        """The formula of a polynomial."""
        if not polynomial:
            return ZERO
        factor, rest = primitive(polynomial)
        if len({int(c.denominator) for c in polynomial.values()}) > 1:
            sign = 1 if factor > 0 else -1  # a fraction stays with the term that has it
            factor, rest = Fraction(sign), polynomial * sign
        common, inner = content(rest)
        monomial = self._monomial(common)
        body = self._nested(inner)
        above = times(Number(Fraction(abs(factor.numerator))), *monomial, body)
        if factor.denominator != 1:
            above = self._divided(factor, monomial, body)
        return minus(above) if factor < 0 else above

    def _divided(self, factor: Fraction, monomial: tuple[Formula, ...], body: Formula) -> Formula:
        """A monomial with a fraction in front; roots of numbers belong to the fraction."""
        table = self._letters()
        roots = {table[c.name] for c in self.algebra.chain.constants if c.square is not None}
        above = times(Number(Fraction(abs(factor.numerator))), *(m for m in monomial if m in roots))
        below = Number(Fraction(factor.denominator))
        return times(Quotient(above, below), *(m for m in monomial if m not in roots), body)

    def _letters(self) -> Mapping[str, Symbol]:
        return self.letters or symbols(self.algebra)

    def _monomial(self, exponents: tuple[int, ...]) -> tuple[Formula, ...]:
        """Constants first, then cosines and sines by joint, then lengths, then pose entries."""
        places = [place for place, exponent in enumerate(exponents) if exponent]
        places.sort(key=self._order)
        names = [str(self.algebra.ring.symbols[place]) for place in places]
        table = self._letters()
        return tuple(
            table[name] if exponents[place] == 1 else Power(table[name], exponents[place])
            for name, place in zip(names, places, strict=True)
        )

    def _order(self, place: int) -> tuple[int, int]:
        """Constants, trigonometric functions, lengths, pose entries."""
        first = len(self.algebra.ring.gens) - len(self.algebra.chain.ring.gens)
        if place >= first:
            return 0, place
        if place < 12:
            return 4, place
        if place < 12 + 18:
            return 3, place
        return (2 if place in self._slides() else 1), place

    def _slides(self) -> set[int]:
        return {self.algebra.index[name] for name in self.algebra.slides.values()}

    def _nested(self, polynomial: Polynomial) -> Formula:
        """A primitive polynomial without common factors."""
        if polynomial in self.known:
            return self.known[polynomial]
        if -polynomial in self.known:
            return minus(self.known[-polynomial])
        places = used_places(polynomial)
        if not places:
            return _as_number(Fraction(str(polynomial.coeff(1))))
        parts: list[tuple[tuple[int, ...], Formula]] = []
        rest = polynomial
        while rest:
            group = self._outermost(used_places(rest))
            inside, rest = split(rest, group) if group else (rest, rest.ring.zero)
            parts += self._inside(inside, group)
        parts.sort(key=lambda part: part[0])
        return add(*(formula for _, formula in parts))

    def _inside(
        self, inside: Polynomial, group: frozenset[int]
    ) -> list[tuple[tuple[int, ...], Formula]]:
        """The terms that hold a group: a known form, or one summand for each of its generators."""
        factor, rest = primitive(inside)
        if rest in self.known or -rest in self.known:
            formula = self._nested(rest)
            return [(self._place_of(inside), times(_as_number(factor), formula))]
        parts = []
        for place in sorted(group):
            part, inside = split(inside, frozenset({place}))
            if part:
                parts.append((self._place_of(part), self.write(part)))
        parts += [(self._place_of(term), self.write(term)) for term in _terms_of(inside)]
        return parts

    def _place_of(self, polynomial: Polynomial) -> tuple[int, ...]:
        """Pose entries first, then constants, then the joints in their order."""
        classes = [self._order(place) for place in used_places(polynomial)]
        kinds = {kind for kind, _ in classes}
        trig = sorted(place for kind, place in classes if kind in {1, 2})
        if kinds & {3, 4}:
            return (0, *trig, *sorted(place for kind, place in classes if kind in {3, 4}))
        return (2, *trig) if trig else (1, *sorted(place for _, place in classes))

    def _outermost(self, places: frozenset[int]) -> frozenset[int]:
        """The cosine and sine, or the length, with the highest rank; empty if there is none."""
        names = {place: str(self.algebra.ring.symbols[place]) for place in places}
        moving = [place for place in places if self._order(place)[0] in {1, 2}]
        if not moving:
            return frozenset()
        best = max(moving, key=lambda place: (self.rank(names[place]), -place))
        for angle in self.algebra.angles:
            pair = frozenset({self.algebra.index[angle.cosine], self.algebra.index[angle.sine]})
            if best in pair:
                return pair
        return frozenset({best})


def _terms_of(polynomial: Polynomial) -> list[Polynomial]:
    ring = polynomial.ring
    return [ring.from_dict({monomial: c}) for monomial, c in polynomial.terms()]


def _as_number(value: Fraction) -> Formula:
    return Number(value) if value >= 0 else Minus(Number(-value))
