"""From polynomials to program values: nested by the order in which joints were solved.

The joint solved last is outermost, so that the inner parts depend on fewer signs and are
shared. Linear forms that a solved equation fixes are not computed again: after X s + Y c = Z, the
form X s + Y c is Z, and Y s - X c is the signed root. Long polynomials are made of parts that are
known to be short otherwise.
"""

from __future__ import annotations

from dataclasses import dataclass
from operator import sub
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import POSE_NAMES
from dhgen.kinematics.ring import content as content_of
from dhgen.kinematics.ring import divided, primitive, split, used_places

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator
    from fractions import Fraction

    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node

LONG = 24  # terms: where all twists are right angles there are at most 13


@dataclass(frozen=True, slots=True)
class Part:
    """A sum that coefficients may hold.

    Attributes:
        polynomial: What it is.
        value: Makes its value.
    """

    polynomial: Polynomial
    value: Callable[[], Node]


@dataclass(frozen=True, slots=True)
class _Taken:
    """polynomial = factor part + rest."""

    factor: Polynomial
    part: Part
    rest: Polynomial


class PolynomialLowering:
    """Lowers polynomials of one arm, given the values of its generators.

    Attributes:
        builder: Where the values go.
    """

    def __init__(self, algebra: Algebra, builder: Builder, value: Callable[[str], Node]) -> None:
        self.builder = builder
        self._algebra = algebra
        self._value = value
        self._rank: dict[int, int] = {}
        self._pairs: dict[int, tuple[int, int]] = {}
        self._forms: dict[Polynomial, Node] = {}
        self._parts: Callable[[], Iterable[Part]] = tuple
        for angle in algebra.angles:
            pair = (algebra.index[angle.cosine], algebra.index[angle.sine])
            self._pairs[pair[0]] = self._pairs[pair[1]] = pair
        self._first_unknown = len(POSE_NAMES) + len(algebra.coordinates)
        self._names = [symbol.name for symbol in algebra.ring.symbols]
        constants = len(algebra.chain.ring.gens)
        for place in range(len(self._names) - constants, len(self._names)):
            self._rank[place] = -1

    def solved(self, *names: str) -> None:
        """These generators became known: they are outside all earlier ones."""
        rank = max(self._rank.values(), default=0) + 1
        for name in names:
            self._rank.setdefault(self._algebra.index[name], max(rank, 1))

    def is_known(self, place: int) -> bool:
        """Whether a generator is something other than joints that are not solved."""
        return place in self._rank or place < self._first_unknown

    def offer(self, parts: Callable[[], Iterable[Part]]) -> None:
        """Long polynomials to come may be made of these."""
        self._parts = parts

    def remember(self, form: Polynomial, node: Node) -> None:
        """This form need not be computed: it is that value."""
        if len(form) > 1:
            factor, forward = _facing_forward(form)
            if factor == 1:
                self._forms.setdefault(forward, node)
            elif factor == -1:
                self._forms.setdefault(forward, self.builder.neg(node))

    def lower(self, polynomial: Polynomial) -> Node:
        """The value of a polynomial."""
        for place in sorted(used_places(polynomial)):
            self._value(self._names[place])  # sums of angles are composed, and ranked, before use
        if len(polynomial) < LONG or self._is_remembered(polynomial):
            return self._lower(polynomial)
        return self._of_parts(polynomial)

    def _is_remembered(self, polynomial: Polynomial) -> bool:
        _, form = _facing_forward(polynomial)
        return content_of(form)[1] in self._forms

    def _of_parts(self, polynomial: Polynomial) -> Node:
        """A sum of parts, each times one term, and what is left."""
        builder, rest, total = self.builder, polynomial, self.builder.integer(0)
        offered, self._parts = self._parts, tuple  # what parts are made of holds none of them
        parts = [part for part in offered() if part.polynomial]
        while len(rest) >= LONG:
            found = [each for part in parts for each in self._without(rest, part)]
            best = min(found, key=lambda each: len(each.rest), default=None)
            if best is None or len(best.rest) >= len(rest):
                break
            value = builder.mul(self._lower(best.factor), best.part.value())
            total, rest = builder.add(total, value), best.rest
        self._parts = offered
        return builder.add(total, self._lower(rest)) if rest else total

    def _without(self, polynomial: Polynomial, part: Part) -> Iterator[_Taken]:
        """A polynomial without a part, times every term that may take one away."""
        # the shortest term is the least likely to have changed on the way to the normal form
        least = min(part.polynomial, key=lambda monomial: (sum(monomial), monomial))
        for monomial, coefficient in sorted(polynomial.items()):
            powers = tuple(map(sub, monomial, least))
            if min(powers) >= 0:
                term = {powers: coefficient / part.polynomial[least]}
                factor = polynomial.ring.from_dict(term)
                rest = self._algebra.normal(polynomial - factor * part.polynomial)
                yield _Taken(factor, part, rest)

    def _lower(self, polynomial: Polynomial) -> Node:
        if not polynomial:
            return self.builder.integer(0)
        factor, form = _facing_forward(polynomial)
        content, rest = content_of(form)
        return self._scaled(self._nested(rest), factor, content)

    def _scaled(self, node: Node, factor: Fraction, content: tuple[int, ...]) -> Node:
        """factor * monomial * node."""
        builder = self.builder
        for place, exponent in enumerate(content):
            for _ in range(exponent):
                node = builder.mul(self._value(self._names[place]), node)
        scaled = builder.mul(builder.integer(factor.numerator), node)
        return builder.div(scaled, builder.integer(factor.denominator))

    def _nested(self, polynomial: Polynomial) -> Node:
        """A polynomial without common factors."""
        known = self._forms.get(polynomial)
        if known is not None:
            return known
        places = used_places(polynomial)
        if not places:
            coefficient = polynomial.coeff(1)
            return self.builder.integer(int(coefficient))
        outermost = max(places, key=lambda place: (self._rank.get(place, 0), -place))
        pair = self._pairs.get(outermost)
        group = set(pair) if pair is not None and self._rank.get(outermost, 0) > 0 else {outermost}
        inside, outside = split(polynomial, group)
        total = self._known_or_sum(inside, sorted(group))
        return self.builder.add(total, self._lower(outside)) if outside else total

    def _known_or_sum(self, inside: Polynomial, group: list[int]) -> Node:
        """The terms in one joint: a remembered form, or c A + s B."""
        builder = self.builder
        factor, form = _facing_forward(inside)
        content, rest = content_of(form)
        if rest in self._forms and not any(content[place] for place in group):
            return self._scaled(self._forms[rest], factor, content)
        total = builder.integer(0)
        for place in group:
            part, inside = split(inside, {place})
            if part:
                quotient = divided(part, place)
                total = builder.add(
                    total, builder.mul(self._value(self._names[place]), self._lower(quotient))
                )
        return total


def _facing_forward(polynomial: Polynomial) -> tuple[Fraction, Polynomial]:
    """The rational factor that leaves whole, coprime coefficients, the first of them positive."""
    factor, rest = primitive(polynomial)
    return (factor, rest) if rest.LC > 0 else (-factor, -rest)
