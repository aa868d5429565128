"""Vectors that are others turned by a constant angle, and vectors that are their own directions.

(a k + b r, a r - b k) is (k, r) turned by -atan2(b, a): the law of cosines gives such vectors, with
r a signed root and k a length, and the angle of (k, r) depends on fewer signs, or is odd in them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from mpmath import mp, mpf

from dhgen.program.building.graph import Formula
from dhgen.program.regular.coefficient import ONE, Coefficient, coefficient

if TYPE_CHECKING:
    from fractions import Fraction

    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node


DIGITS = 40  # of the constant angle before it is rounded: the same on every machine
Product = tuple["Node", ...]


@dataclass(frozen=True, slots=True)
class TurnedPair:
    """A vector and the angle by which another is turned back from it.

    Attributes:
        sine: Its y, as the factors of a product.
        cosine: Its x.
        turn: The angle.
        formula: How it is written.
    """

    sine: Product
    cosine: Product
    turn: float
    formula: Formula


def turned_pair(builder: Builder, sine: Node, cosine: Node) -> TurnedPair | None:
    """The vector of which (cosine, sine) is a multiple, turned by a constant angle."""
    y, x = _terms(builder, sine), _terms(builder, cosine)
    if len(y) != 2 or set(y) != set(x):
        return None
    one, other = sorted(y)
    for r, k in ((one, other), (other, one)):
        a, b = y[r], x[r]
        if x[k].value == a.value and y[k].value == -b.value and a.value != 0 and b.value != 0:
            with mp.workdps(DIGITS):
                turn = float(mp.atan2(_exact(b.value), _exact(a.value)))
            y_, x_ = (each.formula(builder.formula) for each in (b, a))
            formula = Formula(f"atan2({y_.text}, {x_.text})", names=y_.names | x_.names)
            return TurnedPair(r, k, turn, formula)
    return None


def _exact(value: Fraction) -> mpf:
    return mpf(value.numerator) / mpf(value.denominator)


def _terms(builder: Builder, node: Node) -> dict[Product, Coefficient]:
    """A sum as products of what is not constant, each with its coefficient."""
    entry = builder.entries[node]
    match entry.operator, entry.operands:
        case "neg", (operand,):
            return {key: -value for key, value in _terms(builder, operand).items()}
        case (("add" | "sub"), (left, right)):
            found = _terms(builder, left)
            for key, value in _terms(builder, right).items():
                more = value if entry.operator == "add" else -value
                found[key] = found[key] + more if key in found else more
            return found
        case _:
            factor, product = _factors(builder, node)
            return {tuple(sorted(product)): factor}


def _factors(builder: Builder, node: Node) -> tuple[Coefficient, list[Node]]:
    """A product as a constant and the rest."""
    entry = builder.entries[node]
    if entry.value is not None:
        return coefficient(builder, node), []
    if entry.operator != "mul":
        return ONE, [node]
    (one, first), (two, second) = (_factors(builder, operand) for operand in entry.operands)
    return one * two, first + second


def by_their_lengths(builder: Builder, misses: list[Node]) -> list[Node]:
    """Values that have to vanish, with w^2 - 1 in place of both x - x / w and y - y / w.

    w^2 is x^2 + y^2. The squares of the two add up to (w - 1)^2, which (w^2 - 1)^2 exceeds, and no
    root is needed for it.
    """
    of: dict[Node, list[Node]] = {}
    for miss in misses:
        if (inverse := _inverse_length(builder, miss)) is not None:
            of.setdefault(inverse, []).append(miss)
    kept = list(misses)
    for inverse, pair in of.items():
        square = _square(builder, inverse)
        squares = [builder.square(builder.entries[miss].operands[0]) for miss in pair]
        if len(pair) == 2 and square == builder.add(*squares):
            kept = [miss for miss in kept if miss not in pair]
            kept.append(builder.sub(square, builder.integer(1)))
    return kept


def _inverse_length(builder: Builder, miss: Node) -> Node | None:
    """1 / w of x - x / w."""
    entry = builder.entries[miss]
    if entry.operator != "sub" or builder.entries[entry.operands[1]].operator != "mul":
        return None
    x, product = entry.operands
    factors = builder.entries[product].operands
    return next((other for one, other in (factors, factors[::-1]) if one == x), None)


def _square(builder: Builder, inverse: Node) -> Node | None:
    """w^2 of 1 / w, which is written w / w^2."""
    factors = [builder.entries[operand] for operand in builder.entries[inverse].operands]
    roots = [factor.operands[0] for factor in factors if factor.operator == "sqrt"]
    divisors = [factor.operands[1] for factor in factors if factor.operator == "div"]
    return roots[0] if roots and roots == divisors else None
