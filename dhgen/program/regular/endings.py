"""Where branches end: without a solution a row is NaN, and of that each joint needs a cause."""

from __future__ import annotations

from functools import partial, reduce
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node


class Endings:
    """What ends branches, and whether a joint's value is spoilt by it anyway."""

    def __init__(self, builder: Builder) -> None:
        self._builder = builder
        self._roots: list[tuple[Node, Node]] = []  # what may be NaN, and NaN or zero with it
        self._conditions: list[Node] = []

    def at_root(self, square: Node) -> None:
        """A branch ends where the square root of a value, which it takes, is that of a negative."""
        length = self._builder.apply("sqrt", square)
        self._roots.append((length, self._builder.apply("sub", length, length)))

    def unless(self, condition: Node) -> None:
        """A branch ends where a condition does not hold."""
        self._conditions.append(condition)

    def ended(self, joints: Sequence[Node]) -> list[Node]:
        """The joints' values, NaN where the branch has ended."""
        endings = list(self._roots)
        if self._conditions:
            builder = self._builder
            holds = reduce(partial(builder.apply, "and"), self._conditions)
            none = builder.apply("sqrt", builder.integer(-1))
            ending = builder.select(holds, builder.integer(0), none)
            endings.append((ending, ending))
        return [self._spoilt(joint, endings) for joint in joints]

    def _spoilt(self, joint: Node, endings: list[tuple[Node, Node]]) -> Node:
        for cause, ending in endings:
            if not self._spoils(cause, joint, {}):
                joint = self._builder.add(joint, ending)
        return joint

    def _spoils(self, cause: Node, node: Node, seen: dict[Node, bool]) -> bool:
        """Whether a value is NaN for certain where another is."""
        if node not in seen:
            entry = self._builder.entries[node]
            if node == cause:
                seen[node] = True
            elif entry.operator == "select":
                seen[node] = all(self._spoils(cause, each, seen) for each in entry.operands[1:])
            elif entry.operator == "copysign":
                seen[node] = self._spoils(cause, entry.operands[0], seen)
            else:
                seen[node] = any(self._spoils(cause, each, seen) for each in entry.operands)
        return seen[node]
