"""What is assumed of a regular pose: no joint is free, no two branches meet, and what follows."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal

from dhgen.program.ir import Apply, Failure, Guard, Let, Variable

if TYPE_CHECKING:
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
    """When the branches of both signs are the same: the guard is plus or not this."""
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
