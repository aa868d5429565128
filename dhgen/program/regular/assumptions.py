"""What is assumed of a regular pose, and where branches end there."""

from __future__ import annotations

from functools import partial, reduce
from typing import TYPE_CHECKING, Literal

from dhgen.program.ir import Apply, Failure, Guard, Let, Variable

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node
    from dhgen.program.ir import Expression, Program


class Assumptions:
    """Truth values of a program that are taken as decided, by their names."""

    def __init__(self, program: Program) -> None:
        self._program = program
        self._assumed: dict[str, bool] = {}
        for name in (*(name for _, name in program.free), *program.near):
            self._suppose(Variable(name), truth=False)
        for statement in program.body:
            if isinstance(statement, Guard) and statement.failure is Failure.MERGED:
                self._suppose(meeting(statement), truth=False)

    def denies(self, name: str) -> bool:
        """Whether a truth value is taken for false."""
        return self._assumed.get(name) is False

    def foresees(self, name: str, expression: Expression) -> bool:
        """Whether a truth value follows from what is assumed of others; then it is assumed too."""
        if name in self._assumed:
            return False
        known = self.decided(expression)
        if known is not None:
            self._assumed[name] = known
        return known is not None

    def decided(self, condition: Expression) -> bool | None:
        """What is assumed of a condition."""
        match condition:
            case Variable(name):
                return self._assumed.get(name)
            case Apply("not", (inner,)):
                known = self.decided(inner)
                return None if known is None else not known
            case Apply("and" | "or" as operator, parts):
                decided = [self.decided(part) for part in parts]
                ending = operator == "or"
                if ending in decided:
                    return ending
                return None if None in decided else not ending
            case _:
                return None

    def _suppose(self, condition: Expression, *, truth: bool) -> None:
        match condition:
            case Apply("not", (inner,)):
                self._suppose(inner, truth=not truth)
            case Apply("or" | "and" as both, parts) if truth == (both == "and"):
                for part in parts:
                    self._suppose(part, truth=truth)
            case Variable(name):
                self._assumed[name] = truth
                for statement in self._program.body:
                    if isinstance(statement, Let) and statement.name == name:
                        self._suppose(statement.expression, truth=truth)
            case _:
                pass


def meeting(guard: Guard) -> Expression:
    """When the branches of both signs are one: the guard is plus or not this."""
    match guard.condition:
        case Apply("or", (Apply("less", _), Apply("not", (met,)))):
            return met
        case Apply("or", (Apply("not", (met,)), Apply("less", _))):
            return met
    raise AssertionError(guard)


def joined(condition: Expression, operator: Literal["and", "or"]) -> list[Expression]:
    """What a condition joins by an operator, however deep."""
    match condition:
        case Apply(found, operands) if found == operator:
            return [part for each in operands for part in joined(each, operator)]
        case _:
            return [condition]


class Endings:
    """What ends branches, and whether a joint's value is spoilt by it anyway."""

    def __init__(self, builder: Builder) -> None:
        self._builder = builder
        self._roots: list[tuple[Node, Node]] = []  # what may be NaN, and NaN or zero with it
        self._conditions: list[Node] = []

    def at_root(self, square: Node) -> None:
        """A branch ends where a value whose square root it takes is negative."""
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
