"""Builds programs: the operators with what simplifies at once, names, headings and guards."""

from __future__ import annotations

from dataclasses import replace
from functools import partial, reduce
from typing import TYPE_CHECKING, Literal

from dhgen.program.building.graph import Graph
from dhgen.program.building.schedule import Mark, Names, scheduled
from dhgen.program.ir import Integer, Joint, Variable
from dhgen.program.reserved import NOTHING, Reserved
from dhgen.program.text import expression_text

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.program.building.graph import Node
    from dhgen.program.building.schedule import Option
    from dhgen.program.ir import Failure, Operator, Program


class Builder(Graph):
    """A program in the making.

    Args:
        reserved: Names that are kept for others.
        folded: What the names of constants made from constants begin with.
    """

    def __init__(self, reserved: Reserved = NOTHING, folded: str = "k") -> None:
        super().__init__(reserved)
        self._folded = folded
        self._names: dict[Node, str] = {}
        self._hints: dict[Node, str] = {}
        self._marks: list[Mark] = []

    # operators

    def add(self, left: Node, right: Node) -> Node:
        """left + right."""
        if self._is(left, 0):
            return right
        if self._is(right, 0):
            return left
        if (inner := self._negated(right)) is not None:
            return self.sub(left, inner)
        if (inner := self._negated(left)) is not None:
            return self.sub(right, inner)
        return self.arithmetic("add", left, right)

    def sub(self, left: Node, right: Node) -> Node:
        """left - right."""
        if self._is(right, 0):
            return left
        if self._is(left, 0):
            return self.neg(right)
        if (inner := self._negated(right)) is not None:
            return self.add(left, inner)
        if left == right:
            return self.integer(0)
        if (inner := self._negated(left)) is not None:
            return self.neg(self.add(inner, right))
        return self.arithmetic("sub", left, right)

    def mul(self, left: Node, right: Node) -> Node:
        """left * right."""
        for one, other in ((left, right), (right, left)):
            if self._is(one, 0):
                return one
            if self._is(one, 1):
                return other
            if self._is(one, -1):
                return self.neg(other)
            if (inner := self._negated(one)) is not None:
                return self.neg(self.mul(inner, other))
        return self.arithmetic("mul", left, right)

    def div(self, left: Node, right: Node) -> Node:
        """left / right; a constant divisor becomes a factor."""
        if self._is(left, 0) or self._is(right, 1):
            return left
        if (inner := self._negated(right)) is not None and self.entries[inner].value is not None:
            return self.mul(left, self.arithmetic("div", self.integer(-1), inner))
        if self.entries[right].value is not None and self.entries[left].value is None:
            return self.mul(left, self.arithmetic("div", self.integer(1), right))
        if (inner := self._negated(left)) is not None:
            return self.neg(self.div(inner, right))
        return self.arithmetic("div", left, right)

    def neg(self, operand: Node) -> Node:
        """-operand."""
        entry = self.entries[operand]
        if isinstance(entry.leaf, Integer):
            return self.integer(-entry.leaf.value)
        if entry.operator == "neg":
            return entry.operands[0]
        if entry.operator == "sub":
            return self.sub(entry.operands[1], entry.operands[0])
        return self.apply("neg", operand)

    def absolute(self, operand: Node) -> Node:
        """Its size, without its sign and the branches' signs; a constant's number."""
        inner = self._negated(operand)
        operand = operand if inner is None else inner
        entry = self.entries[operand]
        if entry.operator == "mul" and any(self.is_sign(factor) for factor in entry.operands):
            left, right = entry.operands
            return self.absolute(right if self.is_sign(left) else left)
        value = self.entries[operand].value
        if value is None:
            return self.apply("abs", operand)
        return operand if value >= 0 else self.neg(operand)

    def square(self, operand: Node) -> Node:
        """operand * operand, without its sign."""
        inner = self._negated(operand)
        operand = operand if inner is None else inner
        return self.mul(operand, operand)

    def select(self, condition: Node, yes: Node, no: Node) -> Node:
        """yes where the condition holds, else no."""
        return yes if yes == no else self.apply("select", condition, yes, no)

    def joined(self, truths: Iterable[Node], operator: Literal["and", "or"]) -> list[Node]:
        """What truth values join by an operator, however deep, each once."""
        pending, found = list(truths), []
        while pending:
            node = pending.pop(0)
            entry = self.entries[node]
            if entry.operator == operator:
                pending += entry.operands
            else:
                found.append(node)
        return list(dict.fromkeys(found))

    def either(self, truths: Iterable[Node]) -> Node:
        """Whether any of these holds, each once and none that follows from another one."""
        found = self.joined(truths, "or")
        needed = [node for node in found if not any(self._implies(node, other) for other in found)]
        return reduce(partial(self.apply, "or"), needed)

    def _implies(self, truth: Node, other: Node) -> bool:
        """Whether one holds with another one that has a larger limit for what they compare."""
        one, two = self.entries[truth], self.entries[other]
        if not one.operator == two.operator == "at_most" or one.operands[0] != two.operands[0]:
            return False
        limit, larger = (self.entries[each.operands[1]].value for each in (one, two))
        return limit is not None and larger is not None and limit < larger

    def disjunctions(self, truths: Iterable[Node]) -> list[Node]:
        """Whether any of these holds: one truth value for each type, the narrow ones first."""
        merged: dict[tuple[int, ...], list[Node]] = {}
        for node in self.joined(truths, "or"):
            merged.setdefault(self.entries[node].axes, []).append(node)
        types = sorted(merged, key=lambda axes: (len(axes), axes))
        return [reduce(lambda a, b: self.apply("or", a, b), merged[axes]) for axes in types]

    def simplified(self, operator: Operator, operands: list[Node]) -> Node:
        """An operator, with what simplifies at once; x - x is kept: it may be there for its NaN."""
        match operator, operands:
            case (("add" | "mul" | "div"), (left, right)):
                return {"add": self.add, "mul": self.mul, "div": self.div}[operator](left, right)
            case "sub", (left, right) if left != right or self.entries[left].value is not None:
                return self.sub(left, right)
            case "neg", (operand,):
                return self.neg(operand)
            case "abs", (operand,):
                return self.absolute(operand)
            case "select", (condition, yes, no):
                return self.select(condition, yes, no)
            case _:
                return self.apply(operator, *operands)

    def is_sign(self, node: Node) -> bool:
        """Whether a node is a branch sign."""
        leaf = self.entries[node].leaf
        return isinstance(leaf, Variable) and any(axis.name == leaf.name for axis in self.axes)

    def is_zero(self, node: Node) -> bool:
        """Whether a node is the number 0."""
        return self._is(node, 0)

    def axes_of(self, node: Node) -> tuple[int, ...]:
        """The axes that a node depends on."""
        return self.entries[node].axes

    # names and statements

    def name(self, node: Node, wanted: str) -> Node:
        """Gives a value a name that a reader knows, if it has none; returns the value."""
        entry = self.entries[node]
        if entry.operator is not None and node not in self._names and entry.operator != "neg":
            self._names[node] = self.unique(wanted)
        return node

    def hint(self, node: Node, wanted: str) -> Node:
        """The name that a value gets if it needs one; returns the value."""
        if self.entries[node].operator is not None:
            self._hints.setdefault(node, wanted)
        return node

    def heading(self, text: str, detail: str = "") -> None:
        """A step begins; the detail is for the first time it is named."""
        self._marks.append(Mark(len(self.entries), heading=text, detail=detail))

    def explain(self, more: str) -> None:
        """Something more for the detail of the heading that was given last."""
        last = max(k for k, mark in enumerate(self._marks) if mark.heading is not None)
        detail = f"{self._marks[last].detail}, {more}"
        self._marks[last] = replace(self._marks[last], detail=detail)

    def spelled(self, node: Node, wanted: str) -> str:
        """How a value reads in a comment: as the number that is given, or by its name."""
        leaf = self.entries[node].leaf
        if leaf is not None:
            return expression_text(leaf)
        self.name(node, wanted)
        return self._names[node]

    def guard(
        self,
        condition: Node,
        failure: Failure,
        margin: Node | None = None,
        chosen: Iterable[Option] = (),
    ) -> None:
        """Ends the branches on which the condition is false.

        Args:
            condition: What must hold.
            failure: Why it may not.
            margin: What must not be negative or, for a pose, be near to zero, if that is asked.
            chosen: Joints that may have been chosen; those whose choice has no influence on the
                margin are left out.
        """
        deciding = () if margin is None else self.deciding(chosen, margin)
        self._marks.append(
            Mark(
                len(self.entries),
                condition=condition,
                margin=margin,
                failure=failure,
                chosen=deciding,
            )
        )

    def deciding(self, chosen: Iterable[Option], margin: Node) -> tuple[Option, ...]:
        """The joints, of some, whose choice has an influence on a value, each once."""
        leaves = self.leaves(margin)
        options = (option for option in chosen if Joint(option.joint, "seed") in leaves)
        return tuple(dict.fromkeys(options))

    def circle_root(
        self,
        wanted: str,
        coefficients: tuple[Node, ...],
        turning: tuple[tuple[int, int], ...],
        meaning: tuple[str, ...],
        step: int,
    ) -> Node:
        """A root, in (-pi, pi], of a trigonometric polynomial of degree 2: see `Roots`."""
        inner = sorted({axis for node in coefficients for axis in self.entries[node].axes})
        axis = len(self.axes)
        mark = Mark(len(self.entries), roots=coefficients, axis=axis, turning=turning)
        self._marks.append(mark)
        return self.root(wanted, meaning, step, tuple(inner))

    def finish(
        self,
        name: str,
        results: dict[str, Node],
        free: list[tuple[int, Node]],
        near: Iterable[Node] = (),
        unnamed: Iterable[Node] = (),
    ) -> Program:
        """The program with these results, by the names they get if they have none, and others."""
        found = [self.name(node, wanted) for wanted, node in results.items()]
        for number, node in free:
            self._names.setdefault(node, self.unique(f"free{number}"))
        names = Names(self._names, self._hints, self._folded)
        return scheduled(self, name, self._marks, names, [*found, *unnamed], free, tuple(near))

    def finish_entries(self, name: str, entries: dict[str, Node]) -> Program:
        """The program with these results, which get their names only where they are used again."""
        results = [self.hint(node, wanted) for wanted, node in entries.items()]
        names = Names(self._names, self._hints, self._folded)
        return scheduled(self, name, self._marks, names, results, [])

    # the inside

    def _is(self, node: Node, value: int) -> bool:
        return self.entries[node].leaf == Integer(value)

    def _negated(self, node: Node) -> Node | None:
        entry = self.entries[node]
        if entry.operator == "neg":
            return entry.operands[0]
        if isinstance(entry.leaf, Integer) and entry.leaf.value < 0:
            return self.integer(-entry.leaf.value)
        return None
