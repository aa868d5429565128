"""Vectors that have to be their own directions: that they are of length 1 says the same."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node


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
