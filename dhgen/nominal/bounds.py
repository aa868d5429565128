"""How far values of a program may be away from where they are, all over a ball of poses.

A pose of the ball is the given one, turned by no more than an angle and moved by no more than a
length: by two vectors, in parts of these, no longer than 1. A value there is that at the centre,
plus its slopes times these vectors, up to a rest (K. Makino and M. Berz 1996: Taylor models, here
of the first degree). Slopes and rest are worked out beside the values, from those of operands.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce
from typing import TYPE_CHECKING

from dhgen.program.ir import Pose

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Entry, Node

AXES = 3
TRANSLATION = 4  # the column of a pose
# What changes by no more than its operands do together; of the derivative nothing is made.
LIPSCHITZ = frozenset({"abs", "sin", "cos", "maximum"})


class NoBoundError(Exception):
    """A value has no bound that can be computed beside it."""


@dataclass(frozen=True, slots=True)
class Change:
    """By how much a value differs from that at the centre.

    Attributes:
        slopes: Its factors: three of the rotation, three of the translation. None is zero.
        rest: What is left at most; None for nothing.
    """

    slopes: tuple[Node | None, ...]
    rest: Node | None


class Bounds:
    """Changes of the values of a program.

    Args:
        builder: The program in the making: bounds become values of it.
        turned: By how much a pose is turned at most [rad].
        moved: By how much it is moved.
    """

    def __init__(self, builder: Builder, turned: Node, moved: Node) -> None:
        self._builder, self._turned, self._moved = builder, turned, moved
        self._changes: dict[Node, Change | None] = {}
        self._radii: dict[Node, Node] = {}

    def change(self, node: Node) -> Change | None:
        """By how much a value differs; None where it is constant all over the ball."""
        if node not in self._changes:
            self._changes[node] = self._worked_out(node, self._builder.entries[node])
        return self._changes[node]

    def radius(self, node: Node) -> Node | None:
        """How far a value may be away; None where it may not."""
        change = self.change(node)
        if change is not None and node not in self._radii:
            parts = [_there(change.slopes[:AXES]), _there(change.slopes[AXES:])]
            lengths = [self._length(part) for part in parts if part]
            self._radii[node] = self._total([*lengths, change.rest])
        return self._radii[node] if change is not None else None

    def near_zero(self, node: Node) -> Node | None:
        """What a value that may be zero in the ball is no larger than; None where that is nothing.

        A sum of squares is zero where all that is squared is: it is no larger then than the sum of
        the radii's squares.
        """
        parts = self.squared(node)
        radii = [None if part is None else self.radius(part) for part in parts]
        if len(parts) == 1 or None in radii:
            return self.radius(node)
        return self._total(self._builder.square(radius) for radius in radii if radius is not None)

    def squared(self, node: Node) -> list[Node | None]:
        """What is squared in a sum of squares; None for a part that is no square."""
        entry = self._builder.entries[node]
        if entry.operator == "add":
            return [part for operand in entry.operands for part in self.squared(operand)]
        factors = sorted(self._factors(node))
        if len(factors) % 2 or any(
            a != b for a, b in zip(factors[::2], factors[1::2], strict=True)
        ):
            return [None]
        return [reduce(self._builder.mul, factors[::2])]

    def _factors(self, node: Node) -> Iterable[Node]:
        entry = self._builder.entries[node]
        if entry.operator == "mul":
            return [factor for operand in entry.operands for factor in self._factors(operand)]
        return [node]

    def _worked_out(self, node: Node, entry: Entry) -> Change | None:
        if isinstance(entry.leaf, Pose):
            return self._of_pose(entry.leaf)
        changes = [self.change(operand) for operand in entry.operands]
        if not any(changes):
            return None
        match entry.operator:
            case "neg":
                return self._scaled(self._builder.integer(-1), entry.operands[0])
            case "add" | "sub":
                return self._of_sum(entry.operator, *changes)
            case "mul":
                return self._of_product(*entry.operands)
            case "div":
                return self._of_quotient(node, *entry.operands)
            case "sqrt":
                return self._of_root(node, entry.operands[0])
            case operator if operator in LIPSCHITZ:
                radii = [self.radius(operand) for operand in entry.operands]
                return Change((None,) * (2 * AXES), self._sum(radii))
            case _:
                raise NoBoundError

    def _of_pose(self, entry: Pose) -> Change:
        """w x r + v up to what a rotation by |w| is more than this, no more than |w|^2 / 2."""
        builder = self._builder
        slopes: list[Node | None] = [None] * (2 * AXES)
        place = entry.row - 1
        if entry.column == TRANSLATION:
            slopes[AXES + place] = self._moved
            return Change(tuple(slopes), None)
        ahead, behind = (place + 1) % AXES, (place + 2) % AXES
        column = [builder.pose(row + 1, entry.column) for row in range(AXES)]
        slopes[ahead] = builder.mul(self._turned, column[behind])
        slopes[behind] = builder.neg(builder.mul(self._turned, column[ahead]))
        return Change(tuple(slopes), self._halved(builder.square(self._turned)))

    def _of_sum(self, operator: str, left: Change | None, right: Change | None) -> Change:
        builder, nothing = self._builder, Change((None,) * (2 * AXES), None)
        left, right = left or nothing, right or nothing
        both = zip(left.slopes, right.slopes, strict=True)
        slopes = (
            self._sum([a, b if operator == "add" or b is None else builder.neg(b)]) for a, b in both
        )
        return Change(tuple(slopes), self._sum([left.rest, right.rest]))

    def _scaled(self, factor: Node, node: Node) -> Change | None:
        """The bound of a value times another one, as far as that is constant everywhere."""
        change = self.change(node)
        if change is None:
            return None
        slopes = (
            slope if slope is None else self._builder.mul(factor, slope) for slope in change.slopes
        )
        return Change(tuple(slopes), self._times(self._size(factor), change.rest))

    def _of_product(self, left: Node, right: Node) -> Change | None:
        """a' b + a b', and the product of what the two differ by."""
        one, other = self._scaled(left, right), self._scaled(right, left)
        most, much = self.radius(left), self.radius(right)
        if one is None or other is None or most is None or much is None:
            return one or other
        both = self._of_sum("add", one, other)
        return Change(both.slopes, self._sum([both.rest, self._builder.mul(most, much)]))

    def _of_quotient(self, node: Node, left: Node, right: Node) -> Change | None:
        """(a' - q b') / b for q = a / b, the same times what 1 / b is more elsewhere."""
        builder, radius = self._builder, self.radius(right)
        inverse = builder.div(builder.integer(1), right)
        if radius is None:
            return self._scaled(inverse, left)
        change = self._of_sum("sub", self.change(left), self._scaled(node, right))
        size = self._size(inverse)
        slopes = [
            slope if slope is None else builder.mul(slope, inverse) for slope in change.slopes
        ]
        rest = self._times(size, change.rest)
        most = self._total([*map(self._size, _there(slopes)), rest])
        beyond = builder.div(radius, self._least(right, radius))
        return Change(tuple(slopes), self._sum([rest, builder.mul(most, beyond)]))

    def _least(self, node: Node, radius: Node) -> Node:
        """The least size of a value that may not be zero: of a vector's length no part may be."""
        builder, limit = self._builder, self.near_zero(node)
        if limit is None or limit == radius:
            return builder.sub(builder.absolute(node), radius)
        lengths = builder.apply("sqrt", node), builder.apply("sqrt", limit)
        return builder.square(builder.sub(*lengths))

    def _of_root(self, node: Node, square: Node) -> Change | None:
        """x / 2 w for the change x of w^2.

        The root of what is not negative is no more than that, and less by no more than x^2 / 2 w^3:
        |sqrt(1 + t) - 1 - t / 2| <= t^2 / 2 for t from -1 on. The length of a vector is not less.
        """
        builder, radius = self._builder, self.radius(square)
        half = builder.div(self._halved(builder.integer(1)), node)
        change = self._scaled(half, square)
        if change is None or radius is None or None not in self.squared(square):
            return change
        less = builder.div(builder.square(builder.mul(radius, half)), node)
        return Change(change.slopes, self._sum([change.rest, less, less]))

    def _length(self, parts: Sequence[Node]) -> Node:
        """Of a vector."""
        builder = self._builder
        if len(parts) == 1:
            return self._size(parts[0])
        return builder.apply("sqrt", reduce(builder.add, map(builder.square, parts)))

    def _size(self, node: Node) -> Node:
        builder = self._builder
        return builder.integer(1) if builder.is_sign(node) else builder.absolute(node)

    def _halved(self, node: Node) -> Node:
        return self._builder.div(node, self._builder.integer(2))

    def _times(self, factor: Node, other: Node | None) -> Node | None:
        return None if other is None else self._builder.mul(factor, other)

    def _sum(self, parts: Iterable[Node | None]) -> Node | None:
        """None of nothing."""
        there = _there(parts)
        return self._total(there) if there else None

    def _total(self, parts: Iterable[Node | None]) -> Node:
        return reduce(self._builder.add, _there(parts), self._builder.integer(0))


def _there(parts: Iterable[Node | None]) -> list[Node]:
    return [part for part in parts if part is not None]
