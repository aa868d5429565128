"""Where a square root nearly vanishes: its square may be of either sign, or two branches one.

Poses on this boundary are left to the whole program, which distinguishes them as well as it can.
"""

from __future__ import annotations

from fractions import Fraction
from math import prod
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node
    from dhgen.tolerances import Tolerances


BOTH_SIDES = 100  # one width is used for both sides if it is not so many times the other


class ReachBoundary:
    """The width in which a pose is near the reach boundary, and what is never in it.

    Args:
        builder: Where values are.
        tolerances: The table: it is wider than where branches meet, by as much as limits ask
            for, and where the value hangs on an angle that is good to few digits.
    """

    def __init__(self, builder: Builder, tolerances: Tolerances) -> None:
        self._builder = builder
        self._wider = builder.integer(round(tolerances.near_reach_boundary / tolerances.merge))
        self._blurred = builder.integer(round(tolerances.near / tolerances.regular))
        self._least: dict[Node, Fraction] = {}

    def ends(self, inside: Node) -> None:
        """Takes note that branches end where a condition does not hold."""
        for low, value in self._at_most(inside):
            self._is_above(value, self._number(low))

    def ends_at_root(self, square: Node) -> None:
        """Takes note that branches end where the square of a root is negative.

        It may be a product (H - V) (V - L), with the squares of the longest and shortest reach;
        then V is not below L.
        """
        self._is_above(square, Fraction(0))
        for factor in self._factors(square):
            entry = self._builder.entries[factor]
            if entry.operator == "sub" and self._number(entry.operands[1]) is not None:
                self._is_above(factor, Fraction(0))

    def _factors(self, product: Node) -> Iterator[Node]:
        entry = self._builder.entries[product]
        if entry.operator != "mul":
            yield product
            return
        for operand in entry.operands:
            yield from self._factors(operand)

    def keeps(self, misses: list[Node], limit: Node) -> None:
        """Takes note that poses are doubtful where any of these is farther from zero."""
        most = self._number(limit)
        for miss in misses:
            self._is_above(miss, None if most is None else -most)

    def _is_above(self, value: Node, least: Fraction | None) -> None:
        if least is None:
            return
        self._least[value] = least
        entry = self._builder.entries[value]
        if entry.operator == "sub" and (off := self._number(entry.operands[1])) is not None:
            self._least[entry.operands[0]] = least + off

    def excludes(self, condition: Node) -> bool:
        """Whether a condition, x <= limit, holds in no branch that has a solution."""
        entry = self._builder.entries[condition]
        if entry.operator != "at_most" or entry.operands[0] not in self._least:
            return False
        most = self._builder.entries[entry.operands[1]].value
        return most is not None and most < self._least[entry.operands[0]]

    def touches(self, value: Node, inside: Node, apart: Node, *, blurred: bool) -> Node:
        """Whether a value can't be distinguished from zero.

        One width for both sides, the larger, takes one comparison less. Where rows are refined
        branches end far outside of where they meet, and each side has its own if it is constant.
        A root that follows another is weighed with that one: it may be as much above zero as it
        may be below, and be none.

        Args:
            value: What is under a square root.
            inside: The condition that it is not negative, up to rounding.
            apart: The condition that it is positive.
            blurred: Whether it hangs on an angle that is good to few digits.
        """
        builder = self._builder
        inner, outer = self._width(value, apart), self._width(value, inside)
        value = self._weighed(value, inside)
        if blurred:
            inner = outer = self._times(self._blurred, inner)
        else:
            inner = self._times(self._wider, inner)
        low, high = self._growth(inner), self._growth(outer)
        if self._number(outer) is None or high <= BOTH_SIDES * low:
            wider = outer if low < high else inner
            return builder.apply("at_most", builder.absolute(value), wider)
        below = builder.apply("at_most", builder.neg(outer), value)
        return builder.apply("and", below, builder.apply("at_most", value, inner))

    def _times(self, factor: Node, width: Node) -> Node:
        """A width times a number, which is taken into the constant before the rest of a product."""
        builder, entry = self._builder, self._builder.entries[width]
        if entry.operator == "mul" and self._number(entry.operands[0]) is not None:
            constant, rest = entry.operands
            return builder.arithmetic("mul", builder.arithmetic("mul", factor, constant), rest)
        return builder.arithmetic("mul", factor, width)

    def _growth(self, width: Node) -> Fraction:
        """How a width grows: itself if it is constant, or its constant factors."""
        entry, number = self._builder.entries[width], self._number(width)
        if number is not None:
            return number
        factors = entry.operands if entry.operator == "mul" else ()
        return prod(map(self._growth, factors), start=Fraction(1))

    def _weighed(self, value: Node, inside: Node) -> Node:
        """The value, or what is compared with a slack instead, where earlier roots are in it."""
        compared = list(self._at_most(inside))
        return compared[0][1] if len(compared) == 1 else value

    def _number(self, node: Node) -> Fraction | None:
        """The value of a constant, or of one with a minus before it."""
        entry = self._builder.entries[node]
        if entry.operator == "neg":
            value = self._builder.entries[entry.operands[0]].value
            return None if value is None else -value
        return entry.value

    def _at_most(self, condition: Node) -> Iterator[tuple[Node, Node]]:
        """What is less than what, or at most."""
        for part in self._builder.joined([condition], "and"):
            low, high = self._builder.entries[part].operands
            yield low, high

    def _width(self, value: Node, condition: Node) -> Node:
        """How far from zero the value is at most at the bounds of a condition."""
        builder = self._builder
        found: list[tuple[Fraction, Node]] = []
        for low, high in self._at_most(condition):
            if high == self._weighed(value, condition):  # a slack, constant or not
                entry = builder.entries[low]
                return entry.operands[0] if entry.operator == "neg" else low
            above = builder.entries[high].value is not None
            there = self._there(value, *((low, high) if above else (high, low)))
            number = self._number(there)
            assert number is not None
            if number < 0:
                there = builder.arithmetic("mul", builder.integer(-1), there)
            found.append((abs(number), there))
        return max(found)[1]

    def _there(self, node: Node, variable: Node, value: Node) -> Node:
        """A node's value, a constant, where the one variable in it has a value."""
        entry = self._builder.entries[node]
        if node == variable:
            return value
        if entry.value is not None:
            return node
        assert entry.operator is not None, "the square of a root depends on more than one value"
        operands = [self._there(each, variable, value) for each in entry.operands]
        return self._builder.simplified(entry.operator, operands)
