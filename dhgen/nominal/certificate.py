"""The regular program of the nearest arm, with what shows that its rows are all an arm's rows.

Whatever joint values the arm takes to T, those that the caller gives among them, the nearest arm
takes them to a pose T' that is no farther from T than the two arms differ. So T' is in a ball
around T, and what the program computes there is in an interval around what it computes at T: the
centre is the program's value, the radius is worked out beside it (arithmetic of intervals by centre
and radius; R. E. Moore 1966). What depends on given values alone is the same at both. Where no
interval of a root's square, of a divisor, or of what else a branch ends at holds zero, every branch
of the nearest arm has a solution all over the ball, or none anywhere in it.
"""

from __future__ import annotations

import re
from dataclasses import replace
from functools import reduce
from typing import TYPE_CHECKING

from dhgen.program.building.builder import Builder
from dhgen.program.ir import Apply, Heading, Integer, Joint, Let, Pose, Variable
from dhgen.program.regular.unguarded import Regular
from dhgen.program.role import Source

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.nominal.deviation import Deviation
    from dhgen.program.building.graph import Entry, Node
    from dhgen.program.ir import Expression, NamedConstant

OWN = "near"  # what the names of the nearest arm's numbers, and of others made here, begin with
TRANSLATION = 4  # the column of a pose
COMPARISONS = frozenset({"less", "at_most"})
SIGNS = frozenset({"neg", "abs"})


class NoBoundError(Exception):
    """A value has no bound that can be computed beside it."""


def certified(
    solver: Regular, deviation: Deviation | None, names: frozenset[str]
) -> Regular | None:
    """The program, left where a branch may end within the deviation of a pose.

    Args:
        solver: The regular program of the nearest arm, without limits.
        deviation: How far its tool may be from that of the arm; None where the caller says so, by
            an angle and a length as the first and second value that it gives.
        names: Of the arm's own numbers, which stand beside those of the nearest arm.

    Returns:
        None where a value on which a branch may end has no bound.
    """
    if solver.fits or solver.outside is not None:
        return None
    try:
        return _Certificate(solver, deviation, names).run()
    except NoBoundError:
        return None


def _beginning(names: frozenset[str]) -> str:
    """What no other name begins with."""
    word = OWN
    while any(name.startswith(word) for name in names):
        word += "r"
    return word


class _Certificate:
    def __init__(self, solver: Regular, deviation: Deviation | None, names: frozenset[str]) -> None:
        self._solver = solver
        self._word = word = _beginning(names)
        known = solver.program.reserved
        kept = replace(known, values=known.values | names, constants=known.constants | names)
        self._builder = Builder(kept, word)
        self._turned, self._moved = self._bounds(deviation)
        self._values: dict[str, Node] = {}
        self._radii: dict[Node, Node | None] = {}
        self._divisors: set[Node] = set()

    def run(self) -> Regular:
        builder, program = self._builder, self._solver.program
        own = {constant.name for constant in program.constants} | program.reserved.own
        own |= {part.name for constant in program.constants for part in constant.parts}
        names = "|".join(map(re.escape, sorted(own)))
        for constant in program.constants:
            self._values[constant.name] = self._constant(constant, names)
        for axis in program.axes:
            self._values[axis.name] = builder.sign(axis.words, axis.step, axis.name)
        for statement in program.body:
            match statement:
                case Heading(text, detail):
                    builder.heading(text, detail)
                case Let(name, expression):
                    self._values[name] = self._value(expression)
                    if statement.named:
                        builder.hint(self._values[name], name)
        joints = [self._value(joint) for joint in self._solver.joints]
        told = [self._value(doubt) for doubt in self._solver.doubts]
        near = [self._may_vanish(node) for node in self._ends([*joints, *told], told)]
        doubts = builder.disjunctions([*told, *near])
        results = {f"q{place + 1}": node for place, node in enumerate(joints)}
        results |= {f"doubt{place + 1}": node for place, node in enumerate(doubts)}
        finished = builder.finish(program.name, results, [])
        count = len(joints)
        return Regular(finished, finished.outputs[:count], None, None, finished.outputs[count:], ())

    def _bounds(self, deviation: Deviation | None) -> tuple[Node, Node]:
        """By how much the two arms' tools are turned and moved at most."""
        builder, word = self._builder, self._word
        if deviation is None:
            return builder.given(1), builder.given(2)
        angle, length = deviation.angle, deviation.length
        told = "the two arms' tools are turned by no more"
        return (
            builder.constant(f"{word}_angle", angle, told, 0),
            builder.constant(f"{word}_length", length, "and no farther apart", 1),
        )

    def _constant(self, constant: NamedConstant, names: str) -> Node:
        """A number of the nearest arm under a name of its own, also where others are made of it."""
        if constant.role is Source.FILE:
            return self._builder.known(constant)
        near = self._renamed(constant, names)
        role = Source.MADE if near.role is Source.ARM else near.role
        return self._builder.known(replace(near, role=role))

    def _renamed(self, constant: NamedConstant, names: str) -> NamedConstant:
        return replace(
            constant,
            name=f"{self._word}_{constant.name}",
            meaning=re.sub(rf"\b(?:{names})\b", rf"{self._word}_\g<0>", constant.meaning),
            parts=tuple(self._renamed(part, names) for part in constant.parts),
        )

    def _value(self, expression: Expression) -> Node:
        match expression:
            case Variable(name):
                return self._values[name]
            case Integer(value):
                return self._builder.integer(value)
            case Pose(row, column):
                return self._builder.pose(row, column)
            case Apply(operator, operands):
                return self._builder.simplified(operator, [self._value(each) for each in operands])
            case Joint(number, "free"):
                return self._builder.given(number)
            case Joint():
                raise NoBoundError

    def _ends(self, results: list[Node], doubts: list[Node]) -> list[Node]:
        """What must not vanish: under roots, divided by, compared; each factor by itself.

        But what is divided by as a whole, as the bound of a quotient wants it.
        """
        found: list[Node] = []
        for entry in map(self._entry, self._reached(results)):
            if entry.operator == "sqrt":
                found += self._factors(entry.operands[0])
            elif entry.operator == "div":
                divisor = entry.operands[1]
                self._divisors.add(divisor)
                is_exact = self._radius(divisor) is None
                found += self._factors(divisor) if is_exact else [divisor]
        for entry in map(self._entry, self._reached(doubts)):
            if entry.operator in COMPARISONS:
                found += [factor for each in entry.operands for factor in self._factors(each)]
        return list(dict.fromkeys(found))

    def _reached(self, results: list[Node]) -> list[Node]:
        """Nodes and all that they are made of, in their order."""
        pending, seen = list(results), set(results)
        while pending:
            fresh = set(self._entry(pending.pop()).operands) - seen
            seen |= fresh
            pending += sorted(fresh)
        return sorted(seen)

    def _factors(self, node: Node) -> Iterator[Node]:
        """What a product vanishes with."""
        entry = self._entry(node)
        if entry.operator in SIGNS:
            yield from self._factors(entry.operands[0])
        elif entry.operator == "mul":
            for operand in entry.operands:
                yield from self._factors(operand)
        elif entry.operator is not None or isinstance(entry.leaf, Pose):
            yield node

    def _may_vanish(self, node: Node) -> Node:
        """Whether a value may be zero within the deviation.

        A sum of squares is where all that is squared is zero, and so no larger than the sum of the
        radii's squares. What is divided by has to be larger than its radius all the same.
        """
        builder, radius = self._builder, self._radius(node)
        parts = list(self._squared(node))
        limit = builder.integer(0) if radius is None else radius
        if len(parts) > 1 and node not in self._divisors:
            radii = [self._radius(part) for part in parts if part is not None]
            if len(radii) == len(parts) and radius is not None:
                squares = [builder.square(each) for each in radii if each is not None]
                limit = reduce(builder.add, squares)
        return builder.apply("at_most", builder.absolute(node), limit)

    def _entry(self, node: Node) -> Entry:
        return self._builder.entries[node]

    def _radius(self, node: Node) -> Node | None:
        """How far a value may be from where it is anywhere in the ball; None where nowhere."""
        if node not in self._radii:
            self._radii[node] = self._worked_out(node)
        return self._radii[node]

    def _worked_out(self, node: Node) -> Node | None:
        builder, entry = self._builder, self._entry(node)
        match entry.leaf:
            case Pose(_, column):
                return self._moved if column == TRANSLATION else self._turned
            case None:
                pass
            case _:
                return None
        radii = [self._radius(operand) for operand in entry.operands]
        if not any(radius is not None for radius in radii):
            return None
        match entry.operator:
            case "neg" | "abs" | "sin" | "cos":
                return radii[0]
            case "add" | "sub":
                return self._sum(*radii)
            case "mul":
                return self._of_product(*entry.operands)
            case "div":
                return self._of_quotient(*entry.operands)
            case "sqrt":
                return self._of_root(entry.operands[0])
            case "maximum":
                return builder.apply("maximum", *(r for r in radii if r is not None))
            case _:
                raise NoBoundError

    def _sum(self, left: Node | None, right: Node | None) -> Node | None:
        if left is None or right is None:
            return right if left is None else left
        return self._builder.add(left, right)

    def _of_product(self, left: Node, right: Node) -> Node | None:
        """|a| r + s (|b| + r) for the radii s of a and r of b."""
        builder, s, r = self._builder, self._radius(left), self._radius(right)
        a, b = builder.absolute(left), builder.absolute(right)
        if s is None or r is None:
            factor, radius = (a, r) if s is None else (b, s)
            assert radius is not None
            return radius if builder.is_sign(factor) else builder.mul(factor, radius)
        if left == right:
            return builder.mul(s, builder.add(builder.mul(builder.integer(2), a), s))
        return builder.add(builder.mul(a, r), builder.mul(s, builder.add(b, r)))

    def _of_quotient(self, left: Node, right: Node) -> Node | None:
        """(s + |a / b| r) / (|b| - r), where |b| > r, which is seen to."""
        builder, s, r = self._builder, self._radius(left), self._radius(right)
        b = builder.absolute(right)
        if r is None:
            return None if s is None else builder.div(s, b)
        size = builder.absolute(builder.div(left, right))
        total = self._sum(s, builder.mul(size, r))
        assert total is not None
        return builder.div(total, builder.sub(b, r))

    def _of_root(self, square: Node) -> Node | None:
        """Of the length of a vector no more than of its parts; else w x (1 + x) / 2, x = r / w^2.

        1 - sqrt(1 - x) <= x / 2 + x^2 / 2 for x from 0 to 1; beyond, zero is in the interval.
        """
        builder = self._builder
        parts = list(self._squared(square))
        if parts and all(part is not None for part in parts):
            total: Node | None = None
            for part in parts:
                assert part is not None
                total = self._sum(total, self._radius(part))
            return total
        r = self._radius(square)
        assert r is not None
        x = builder.div(r, square)
        grown = builder.mul(x, builder.add(builder.integer(1), x))
        half = builder.div(builder.apply("sqrt", square), builder.integer(2))
        return builder.mul(half, grown)

    def _squared(self, node: Node) -> Iterator[Node | None]:
        """What is squared in a sum of squares; None for a part that is no square."""
        entry = self._entry(node)
        if entry.operator == "add":
            for operand in entry.operands:
                yield from self._squared(operand)
        elif entry.operator == "mul" and entry.operands[0] == entry.operands[1]:
            yield entry.operands[0]
        else:
            yield None
