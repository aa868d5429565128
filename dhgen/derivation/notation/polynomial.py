"""Polynomials as people write them: nested by joints, parameters before cosines, signs in front.

The group of generators with the highest rank is outermost, so that
c2 (c1 t11 + s1 t21) + s2 t31 comes out when joint 2 was solved after joint 1.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from fractions import Fraction
from typing import TYPE_CHECKING

from dhgen.derivation.text.formula import (
    ZERO,
    Minus,
    Number,
    Power,
    Quotient,
    add,
    minus,
    square,
    times,
)
from dhgen.kinematics.algebra import POSE_NAMES
from dhgen.kinematics.ring import (
    content,
    primitive,
    split,
    used_places,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from dhgen.derivation.text.formula import Formula, Symbol
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial


@dataclass(frozen=True, slots=True)
class Alphabet:
    """The generators of an arm as people write them, by their places in the ring.

    Attributes:
        names: Their names.
        letters: Their letters.
        orders: What kind it is (0 a constant, 1 a cosine or sine, 2 a length, 3 a coordinate of a
            named point, 4 a pose entry), and the place: their order in a product.
        pairs: Both places for that of a cosine or sine.
        roots: The letters of roots of numbers.
    """

    names: tuple[str, ...]
    letters: dict[int, Symbol]
    orders: tuple[tuple[int, int], ...]
    pairs: dict[int, frozenset[int]]
    roots: frozenset[Symbol]


def alphabet(algebra: Algebra, letters: Mapping[str, Symbol]) -> Alphabet:
    """The generators of an arm, by the letters for their names."""
    index = algebra.index
    pairs = [frozenset({index[angle.cosine], index[angle.sine]}) for angle in algebra.angles]
    constants = len(index) - len(algebra.chain.ring.gens)
    slides = {index[name] for name in algebra.slides.values()}

    def kind(place: int) -> int:
        if place >= constants:
            return 0
        if place < len(POSE_NAMES):
            return 4
        if place < len(POSE_NAMES) + len(algebra.coordinates):
            return 3
        return 2 if place in slides else 1

    return Alphabet(
        names=tuple(index),
        letters={index[name]: letter for name, letter in letters.items()},
        orders=tuple((kind(place), place) for place in range(len(index))),
        pairs={place: pair for pair in pairs for place in pair},
        roots=frozenset(letters[c.name] for c in algebra.chain.constants if c.square is not None),
    )


@dataclass(frozen=True, slots=True)
class Writer:
    """Writes the polynomials of one arm.

    Attributes:
        alphabet: Of the arm.
        rank: For a generator's name, how far outside it is; equal for a cosine and its sine.
        known: Forms that have a letter of their own, with positive first coefficient.
    """

    alphabet: Alphabet
    rank: Callable[[str], int]
    known: Mapping[Polynomial, Formula] = field(default_factory=dict)

    def write(self, polynomial: Polynomial) -> Formula:
        """The formula of a polynomial."""
        if not polynomial:
            return ZERO
        factor, rest = primitive(polynomial)
        if len({int(c.denominator) for c in polynomial.values()}) > 1:
            sign = 1 if factor > 0 else -1  # a fraction is left to the term that has it
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
        roots = self.alphabet.roots
        above = times(Number(Fraction(abs(factor.numerator))), *(m for m in monomial if m in roots))
        below = Number(Fraction(factor.denominator))
        return times(Quotient(above, below), *(m for m in monomial if m not in roots), body)

    def _monomial(self, exponents: tuple[int, ...]) -> tuple[Formula, ...]:
        """Constants first, then cosines and sines by joint, then lengths, then pose entries."""
        places = [place for place, exponent in enumerate(exponents) if exponent]
        places.sort(key=self.alphabet.orders.__getitem__)
        letters = self.alphabet.letters
        return tuple(
            letters[place] if exponents[place] == 1 else Power(letters[place], exponents[place])
            for place in places
        )

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
        squared, inside = self._squares(inside)
        parts += squared
        parts += [(self._place_of(part), self.write(part)) for part in self._by_entries(inside)]
        return parts

    def _by_entries(self, inside: Polynomial) -> list[Polynomial]:
        """Terms one by one, but terms with equal entries of the pose together."""
        orders = self.alphabet.orders
        groups: dict[tuple[int, ...], list[Polynomial]] = {}
        for term in _terms_of(inside):
            (monomial,) = term
            entries = tuple(
                power if kind in {3, 4} else 0
                for power, (kind, _) in zip(monomial, orders, strict=True)
            )
            own = entries if any(entries) else monomial
            groups.setdefault(own, []).append(term)
        return [sum(terms, inside.ring.zero) for terms in groups.values()]

    def _squares(
        self, inside: Polynomial
    ) -> tuple[list[tuple[tuple[int, ...], Formula]], Polynomial]:
        """The squares of sums of constants, x^2 + 2 x y + y^2, and the terms that are left."""
        found = []
        for places in _crossed(inside, self.alphabet):
            first, *others = (inside.ring.gens[place] for place in places)
            factor = inside.coeff(first**2)
            signs = [1 if inside.coeff(first * each) * factor > 0 else -1 for each in others]
            sum_ = first + sum(sign * each for sign, each in zip(signs, others, strict=True))
            square_ = factor * sum_**2
            if factor and all(inside.get(m) == c for m, c in square_.items()):
                power = times(_as_number(Fraction(str(abs(factor)))), square(self.write(sum_)))
                found.append((self._place_of(square_), minus(power) if factor < 0 else power))
                inside = inside - square_
        return found, inside

    def _place_of(self, polynomial: Polynomial) -> tuple[int, ...]:
        """Pose entries first, then constants, then the joints in their order."""
        classes = [self.alphabet.orders[place] for place in used_places(polynomial)]
        kinds = {kind for kind, _ in classes}
        trig = sorted(place for kind, place in classes if kind in {1, 2})
        if kinds & {3, 4}:
            return (0, *trig, *sorted(place for kind, place in classes if kind in {3, 4}))
        return (2, *trig) if trig else (1, *sorted(place for _, place in classes))

    def _outermost(self, places: frozenset[int]) -> frozenset[int]:
        """The cosine and sine, or the length, with the highest rank; empty if there is none."""
        names, orders = self.alphabet.names, self.alphabet.orders
        moving = [place for place in places if orders[place][0] in {1, 2}]
        if not moving:
            return frozenset()
        best = max(moving, key=lambda place: (self.rank(names[place]), -place))
        return self.alphabet.pairs.get(best, frozenset({best}))


def _crossed(polynomial: Polynomial, alphabet: Alphabet) -> list[list[int]]:
    """The constants that are in products of two, with their partners there."""
    groups: list[set[int]] = []
    for monomial in polynomial:
        pair = {place for place, power in enumerate(monomial) if power}
        constant = all(alphabet.orders[place][0] == 0 for place in pair)
        if constant and sum(monomial) == len(pair) == 2:
            joined = [group for group in groups if group & pair]
            groups = [group for group in groups if not group & pair] + [pair.union(*joined)]
    return sorted(map(sorted, groups))


def _terms_of(polynomial: Polynomial) -> list[Polynomial]:
    ring = polynomial.ring
    return [ring.from_dict({monomial: c}) for monomial, c in polynomial.terms()]


def _as_number(value: Fraction) -> Formula:
    return Number(value) if value >= 0 else Minus(Number(-value))
