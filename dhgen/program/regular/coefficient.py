"""Coefficients of polynomials: numbers made of the arm's constants, with their formulas."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce
from typing import TYPE_CHECKING

from dhgen.program.building.graph import ATOM, PRODUCT, Formula, combined
from dhgen.program.ir import Integer

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Sequence

    from dhgen.program.building.graph import Graph, Node

CANCELLED = Fraction(1, 10**12)  # of its terms a sum that is rounding alone
ALIKE = Fraction(1, 10**13)  # numbers that differ by no more are one

_Expanded = dict[tuple["Node", ...], Fraction]  # numbers by products of constants


@dataclass(frozen=True, slots=True)
class Coefficient:
    """A number made of the arm's constants.

    Attributes:
        value: The number.
        constant: The constant that it is; None for a whole number and for what others make.
        factors: Two that it is the product of, if it is one.
        parts: Those that it is the sum of, if it is one.
    """

    value: Fraction
    constant: Node | None = None
    factors: tuple[Coefficient, ...] = ()
    parts: tuple[Coefficient, ...] = ()

    def __mul__(self, other: Coefficient) -> Coefficient:
        """The product of two."""
        if ONE in (self, other):
            return other if self == ONE else self
        return Coefficient(self.value * other.value, factors=(self, other))

    def __add__(self, other: Coefficient) -> Coefficient:
        """The sum of two."""
        return Coefficient(self.value + other.value, parts=(self, other))

    def __neg__(self) -> Coefficient:
        """The opposite."""
        return MINUS_ONE * self

    def __abs__(self) -> Coefficient:
        """Without its sign."""
        return self if self.value >= 0 else -self

    def formula(self, of: Callable[[Node], Formula]) -> Formula:
        """A sum of products of constants, with the factors that all of them have in front.

        Args:
            of: The formula of a constant.
        """
        terms = _expanded(self)
        counts = [Counter(constants) for constants in terms]
        common = reduce(lambda one, other: one & other, counts)
        rest = sorted(
            (tuple(sorted((each - common).elements())), number)
            for each, number in zip(counts, terms.values(), strict=True)
        )
        if len(rest) == 1:
            return _product(rest[0][1], [of(node) for node in sorted(common.elements())])
        rest.sort(key=lambda term: term[1] < 0)  # a sum begins with what is added
        total = _sum((number, [of(node) for node in nodes]) for nodes, number in rest)
        return _product(Fraction(1), [*(of(node) for node in sorted(common.elements())), total])


def whole(value: int) -> Coefficient:
    """A whole number."""
    return Coefficient(Fraction(value))


def coefficient(graph: Graph, node: Node) -> Coefficient:
    """A number of a program as the constant that it is."""
    entry = graph.entries[node]
    if isinstance(entry.leaf, Integer):
        return whole(entry.leaf.value)
    assert entry.value is not None
    return Coefficient(entry.value, constant=node)


ONE, MINUS_ONE = whole(1), whole(-1)


def total(parts: Sequence[Coefficient]) -> Coefficient:
    """The sum; zero if it is rounding alone, and one if it is one up to rounding."""
    if len(parts) == 1:
        value = parts[0].value
    else:
        value = sum((part.value for part in parts), Fraction(0))
        if abs(value) <= CANCELLED * sum(abs(part.value) for part in parts):
            return whole(0)
    above, below = value.numerator, value.denominator
    if below == 1 or abs(abs(above) - below) * ALIKE.denominator > below * ALIKE.numerator:
        return parts[0] if len(parts) == 1 else Coefficient(value, parts=tuple(parts))
    return ONE if value > 0 else MINUS_ONE


def _expanded(number: Coefficient) -> _Expanded:
    if number.constant is not None:
        return {(number.constant,): Fraction(1)}
    if number.factors:
        one, other = map(_expanded, number.factors)
        return _collected(
            (tuple(sorted((*x, *y))), a * b) for x, a in one.items() for y, b in other.items()
        )
    if number.parts:
        return _collected(term for part in number.parts for term in _expanded(part).items())
    return {(): number.value}


def _collected(terms: Iterable[tuple[tuple[Node, ...], Fraction]]) -> _Expanded:
    found: _Expanded = {}
    for constants, number in terms:
        found[constants] = found.get(constants, Fraction(0)) + number
    return {constants: number for constants, number in found.items() if number} or {(): Fraction(0)}


def _sum(terms: Iterable[tuple[Fraction, list[Formula]]]) -> Formula:
    (number, formulas), *others = terms
    found = _product(number, formulas)
    for each, factors in others:
        found = combined("add" if each > 0 else "sub", found, _product(abs(each), factors))
    return found


def _product(number: Fraction, formulas: Sequence[Formula]) -> Formula:
    """A number times constants; powers are written as such."""
    above, below = abs(number.numerator), number.denominator
    factors = [] if above == 1 and formulas else [Formula(str(above))]
    for each, times in Counter(formulas).items():
        power = Formula(f"{each.within(ATOM)}^{times}", times * each.power, PRODUCT, each.names)
        factors.append(each if times == 1 else power)
    found = reduce(lambda one, other: combined("mul", one, other), factors)
    if below != 1:
        found = combined("div", found, Formula(str(below)))
    return found if number > 0 else replace(found, text=f"-{found.text}")
