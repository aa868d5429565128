"""From nodes to statements: which nodes are needed, which get a name, and in which order.

A node is named when it is used twice, when its user depends on more signs than it does (it is
computed outside that user's loop), or when a kernel gave it a name for readers.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.program.ir import (
    Apply,
    Choice,
    Failure,
    Guard,
    Heading,
    Joint,
    Let,
    Program,
    Roots,
    Variable,
)
from dhgen.program.walk import expressions

if TYPE_CHECKING:
    from dhgen.program.building.graph import Entry, Graph, Node
    from dhgen.program.ir import Expression, Statement

TRUTHS = frozenset({"less", "at_most", "and", "or", "not"})


@dataclass(frozen=True, slots=True)
class Option:
    """A joint that may have been chosen: the nodes of a `Choice`.

    Attributes:
        joint: Its number.
        flag: The truth value of it.
        value: Where it is nearly free, its value; None where it has the seed's.
    """

    joint: int
    flag: Node
    value: Node | None = None


@dataclass(frozen=True, slots=True)
class Mark:
    """A heading, a guard, or the roots of a polynomial, between nodes.

    Attributes:
        position: It comes before the node with this number.
        heading: The text of a heading; else None.
        detail: Its details.
        roots: The coefficients of a polynomial; else empty.
        axis: The axis of its roots.
        turning: The joints whose values add up to a root, each with its sign.
        condition: What must hold.
        margin: What must not be negative or, for a pose, be near to zero, if that is asked.
        failure: Why it may not hold.
        chosen: Joints that may have been chosen.
    """

    position: Node
    heading: str | None = None
    detail: str = ""
    roots: tuple[Node, ...] = ()
    axis: int = -1
    turning: tuple[tuple[int, int], ...] = ()
    condition: Node = -1
    margin: Node | None = None
    failure: Failure = Failure.REACH
    chosen: tuple[Option, ...] = ()

    @property
    def wanted(self) -> tuple[Node, ...]:
        """The nodes that a guard or a polynomial looks at."""
        if self.heading is not None or self.roots:
            return self.roots
        margin = () if self.margin is None else (self.margin,)
        flags = (option.flag for option in self.chosen)
        values = (option.value for option in self.chosen if option.value is not None)
        return (self.condition, *margin, *flags, *values)


@dataclass(frozen=True, slots=True)
class Names:
    """Names of nodes.

    Attributes:
        given: Of nodes that are named in any case; the others get theirs here.
        hints: What nodes are called if they need a name.
        folded: What the names of constants made from constants begin with.
    """

    given: dict[Node, str]
    hints: dict[Node, str]
    folded: str


def scheduled(
    graph: Graph,
    name: str,
    marks: list[Mark],
    names: Names,
    results: list[Node],
    free: list[tuple[int, Node]],
    near: tuple[Node, ...] = (),
) -> Program:
    """The program of a graph.

    Args:
        graph: The nodes.
        name: The robot's identifier.
        marks: Guards and headings in their order.
        names: What nodes are called.
        results: The outputs.
        free: Whether a joint was chosen, by joint number.
        near: Whether one was nearly free.
    """
    schedule = _Schedule(graph, marks, names, [*results, *(node for _, node in free), *near])
    body = tuple(schedule.statements())
    outputs = tuple(schedule.expression(node) for node in results)
    program = Program(
        name=name,
        constants=(),
        axes=tuple(graph.axes),
        body=body,
        outputs=outputs,
        free=tuple((number, names.given[node]) for number, node in free),
        near=tuple(names.given[node] for node in near),
        reserved=graph.reserved,
    )
    used = {each.name for each in expressions(program) if isinstance(each, Variable)}
    return replace(program, constants=tuple(c for c in schedule.constants if c.name in used))


class _Schedule:
    def __init__(self, graph: Graph, marks: list[Mark], names: Names, outputs: list[Node]) -> None:
        self._graph = graph
        self._entries = list(graph.entries)
        self._marks = sorted(marks, key=lambda mark: mark.position)
        self._names = names.given
        self._hints = names.hints
        self._outputs = outputs
        self._numbered: set[Node] = set()
        self.constants = list(graph.constants.values())
        self._signs = [Variable(axis.name) for axis in graph.axes]
        self._leave_out_impossible()
        self._mirror_differences()
        self._live = self._needed()
        self._name_folded(names.folded)
        self._name_shared()

    def statements(self) -> list[Statement]:
        """Lets, guards and headings."""
        statements: list[Statement] = []
        pending = list(self._marks)
        for node, entry in enumerate(self._entries):
            while pending and pending[0].position <= node:
                statements.append(self._statement(pending.pop(0)))
            if node in self._live and node in self._names and entry.operator is not None:
                truth, named = entry.operator in TRUTHS, node not in self._numbered
                name, expression = self._names[node], self._applied(node)
                statements.append(Let(name, expression, entry.axes, truth, named))
        return statements + [self._statement(mark) for mark in pending]

    def expression(self, node: Node) -> Expression:
        """A node where it is used: by its name, or in place."""
        if node in self._names:
            return Variable(self._names[node])
        leaf = self._entries[node].leaf
        return self._applied(node) if leaf is None else leaf

    def _applied(self, node: Node) -> Expression:
        entry = self._entries[node]
        assert entry.operator is not None
        return Apply(entry.operator, tuple(self.expression(operand) for operand in entry.operands))

    def _statement(self, mark: Mark) -> Statement:
        if mark.heading is not None:
            return Heading(mark.heading, mark.detail)
        if mark.roots:
            inner = {axis for node in mark.roots for axis in self._entries[node].axes}
            coefficients = tuple(self.expression(node) for node in mark.roots)
            return Roots(mark.axis, coefficients, tuple(sorted(inner)), mark.turning)
        margin = None if mark.margin is None else self.expression(mark.margin)
        chosen = tuple(
            Choice(
                o.joint, self._names[o.flag], None if o.value is None else self.expression(o.value)
            )
            for o in mark.chosen
        )
        axes = self._entries[mark.condition].axes
        return Guard(self.expression(mark.condition), axes, mark.failure, margin, chosen)

    def _needed(self) -> set[Node]:
        """What the outputs and guards need."""
        pending = [*self._outputs, *(node for mark in self._marks for node in mark.wanted)]
        live: set[Node] = set()
        while pending:
            node = pending.pop()
            if node not in live:
                live.add(node)
                pending += self._entries[node].operands
        return live

    def _leave_out_impossible(self) -> None:
        """What hangs on a truth value that never holds is what it is without."""
        same: dict[Node, Node] = {}
        for node, entry in enumerate(self._entries if self._graph.impossible else ()):
            operands = tuple(same.get(operand, operand) for operand in entry.operands)
            self._entries[node] = replace(entry, operands=operands)
            kept = [each for each in operands if each not in self._graph.impossible]
            if len(kept) == len(operands) or entry.operator not in {"or", "select"}:
                continue
            rest = kept[-1]
            if node in self._names and rest not in self._names and self._entries[rest].operator:
                self._entries[node] = self._entries[rest]  # a reader knows its name
            else:
                same[node] = rest
        self._outputs = [same.get(node, node) for node in self._outputs]
        self._marks = [
            replace(mark, condition=same.get(mark.condition, mark.condition))
            for mark in self._marks
        ]

    def _mirror_differences(self) -> None:
        """Of a - b and b - a, where both are needed, the later one is minus the first."""
        first: dict[tuple[Node, ...], Node] = {}
        for node in sorted(self._needed()):
            entry = self._entries[node]
            if entry.operator != "sub":
                continue
            mirror = first.get(entry.operands[::-1])
            if mirror is None:
                first[entry.operands] = node
            else:
                self._entries[node] = replace(entry, operator="neg", operands=(mirror,))
                self._names.pop(node, None)

    def _name_folded(self, letter: str) -> None:
        """The constants made from constants are numbered in the order of their use."""
        count = 0
        for node in sorted(self._live):
            leaf = self._entries[node].leaf
            constant = None if leaf is None else self._graph.folded.get(leaf)
            if constant is not None:
                count += 1
                self._names[node] = self._graph.unique(f"{letter}{count}")
                self.constants.append(replace(constant, name=self._names[node]))

    def _name_shared(self) -> None:
        uses, wider = self._uses()
        for mark in self._marks:
            for option in mark.chosen:
                self._names.setdefault(option.flag, self._graph.unique(f"chosen{option.flag}"))
        for node in sorted(self._live):
            entry = self._entries[node]
            if entry.operator in {None, "neg", "not"} or self._is_rare(entry):
                continue
            if (uses.get(node, 0) > 1 or node in wider) and node not in self._names:
                self._names[node] = self._graph.unique(self._hints.get(node) or self._next(node))

    def _next(self, node: Node) -> str:
        """A number for a value that no one has given a name."""
        self._numbered.add(node)
        return f"v{len(self._numbered)}"

    def _uses(self) -> tuple[dict[Node, int], set[Node]]:
        """How often each node is used, and which are used in a deeper loop than their own."""
        uses: dict[Node, int] = dict.fromkeys(self._outputs, 1)
        wider: set[Node] = set()
        for node in sorted(self._live):
            entry = self._entries[node]
            for operand in entry.operands:
                uses[operand] = uses.get(operand, 0) + 1
                if self._entries[operand].axes != entry.axes:
                    wider.add(operand)
        for mark in self._marks:
            for node in mark.wanted:
                uses[node] = uses.get(node, 0) + 1
        return uses, wider

    def _is_rare(self, entry: Entry) -> bool:
        """Whether a value is left in place: it costs nothing, or only a free joint needs it."""
        leaves = [self._entries[operand].leaf for operand in entry.operands]
        if entry.operator == "less" and any(leaf in self._signs for leaf in leaves):
            return True
        return entry.operator in {"cos", "sin"} and any(
            isinstance(leaf, Joint) and leaf.role == "seed"
            for operand in entry.operands
            for leaf in self._graph.leaves(operand)
        )
