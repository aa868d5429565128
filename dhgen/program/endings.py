"""Where branches end: without a solution a row is NaN, and of that each joint needs a cause."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.program.builder import Builder
    from dhgen.program.graph import Node


class Endings:
    """What ends branches, and whether a joint's value is spoilt by it anyway."""

    def __init__(self, builder: Builder) -> None:
        self._builder = builder
        self._endings: list[tuple[Node, Node]] = []  # what may be NaN, and NaN or zero with it

    def at_root(self, square: Node) -> None:
        """A branch ends where the square root of a value, which it takes, is that of a negative."""
        length = self._builder.apply("sqrt", square)
        self._endings.append((length, self._builder.apply("sub", length, length)))

    def unless(self, condition: Node) -> None:
        """A branch ends where a condition does not hold."""
        builder = self._builder
        none = builder.apply("sqrt", builder.integer(-1))
        ending = builder.select(condition, builder.integer(0), none)
        self._endings.append((ending, ending))

    def ended(self, joint: Node) -> Node:
        """A joint's value, NaN where the branch has ended."""
        for cause, ending in self._endings:
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
