"""A straight-line program in stages: what is plain arithmetic, and the angles taken between.

Loops over many poses become vector instructions where they hold nothing but arithmetic, roots and
selects; arctangents, sines and cosines get loops of their own, one for all of a stage.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.program.ir import Apply, Let, Variable

if TYPE_CHECKING:
    from dhgen.program.ir import Expression, Operator, Program

APART: tuple[Operator, ...] = ("sin", "cos", "atan2")


@dataclass(frozen=True, slots=True)
class Call:
    """A function that is taken apart from arithmetic.

    Attributes:
        operator: Which one.
        operands: Its arguments.
        name: Of its value.
    """

    operator: Operator
    operands: tuple[Expression, ...]
    name: str


@dataclass(frozen=True, slots=True)
class Stage:
    """Arithmetic, and then the functions of its values.

    Attributes:
        lets: The values that need none of this stage's calls, nor those of later stages.
        calls: The functions, each operator's together.
    """

    lets: tuple[Let, ...]
    calls: tuple[Call, ...]


@dataclass(frozen=True, slots=True)
class Staged:
    """A program in stages.

    Attributes:
        stages: In their order; the last one has no calls.
        outputs: The program's outputs in terms of its values.
    """

    stages: tuple[Stage, ...]
    outputs: tuple[Expression, ...]


def staged(program: Program) -> Staged:
    """A program without branches, roots of polynomials and guards in stages."""
    return _Staging(program).run()


class _Staging:
    def __init__(self, program: Program) -> None:
        self._program = program
        self._levels: dict[str, int] = {}
        self._lets: list[list[Let]] = [[]]
        self._calls: list[list[Call]] = [[]]
        self._taken = {s.name for s in program.body if isinstance(s, Let)}
        self._taken |= {constant.name for constant in program.constants} | program.reserved.own

    def run(self) -> Staged:
        for statement in self._program.body:
            if isinstance(statement, Let):
                self._let(statement)
        outputs = tuple(self._without_calls(output, "")[0] for output in self._program.outputs)
        stages = tuple(
            Stage(tuple(lets), tuple(sorted(calls, key=lambda call: APART.index(call.operator))))
            for lets, calls in zip(self._lets, self._calls, strict=True)
        )
        return Staged(stages, outputs)

    def _let(self, let: Let) -> None:
        expression, level = self._without_calls(let.expression, let.name)
        self._levels[let.name] = level
        if expression != Variable(let.name):
            self._lets[level].append(replace(let, expression=expression, axes=()))

    def _without_calls(self, expression: Expression, name: str) -> tuple[Expression, int]:
        """The expression with names for its calls, and the stage at which it is known.

        A call that is the whole of it gets the name, others get new ones.
        """
        match expression:
            case Variable(other):
                return expression, self._levels.get(other, 0)
            case Apply(operator, operands):
                parts = [self._without_calls(operand, "") for operand in operands]
                level = max(level for _, level in parts)
                inner = tuple(part for part, _ in parts)
                if operator in APART:
                    return self._call(Call(operator, inner, name or self._next()), level)
                return Apply(operator, inner), level
            case _:
                return expression, 0

    def _call(self, call: Call, level: int) -> tuple[Expression, int]:
        self._calls[level].append(call)
        if len(self._calls) == level + 1:
            self._lets.append([])
            self._calls.append([])
        self._levels[call.name] = level + 1
        return Variable(call.name), level + 1

    def _next(self) -> str:
        count = 1
        while f"angle{count}" in self._taken:
            count += 1
        self._taken.add(f"angle{count}")
        return f"angle{count}"
