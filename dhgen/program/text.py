"""A program as text, for people: `dhgen explain --program` and failing tests."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.program.ir import (
    AllJoints,
    Apply,
    Guard,
    Heading,
    Integer,
    Joint,
    Let,
    Pose,
    Roots,
    Variable,
)

if TYPE_CHECKING:
    from dhgen.program.ir import Expression, Program, Statement

_INFIX = {"add": "+", "sub": "-", "mul": "*", "div": "/", "less": "<", "at_most": "<="}


def program_text(program: Program) -> str:
    """The program, one statement a line with its signs in brackets."""
    lines = [f"program {program.name}: {program.rows} rows"]
    lines += [f"  {c.name} = {c.value!r}  ({c.meaning})" for c in program.constants]
    lines += [_statement(program, statement) for statement in program.body]
    lines.append("  rows: " + ", ".join(map(expression_text, program.outputs)))
    if program.completion is not None:
        lines.append("  rows that are not exact are refined")
    return "\n".join(lines) + "\n"


def _statement(program: Program, statement: Statement) -> str:
    def signs(axes: tuple[int, ...]) -> str:
        return "[" + " ".join(program.axes[axis].name for axis in axes) + "]"

    match statement:
        case Heading(text, detail):
            return f"# {text}, {detail}" if detail else f"# {text}"
        case Let(name, expression, axes):
            return f"  {name}{signs(axes)} = {expression_text(expression)}"
        case Roots(axis, coefficients, axes):
            texts = ", ".join(map(expression_text, coefficients))
            return f"  {program.axes[axis].name}{signs((*axes, axis))} = roots({texts})"
        case AllJoints(axis, names, found, chosen):
            values = ", ".join((*names, found, chosen))
            return f"  {values}{signs((axis,))} = all solutions ({statement.method})"
        case Guard(condition, axes, failure):
            return f"  guard{signs(axes)} {expression_text(condition)}  ({failure.value})"


def expression_text(expression: Expression) -> str:
    """An expression with all its parentheses."""
    match expression:
        case Variable(name):
            return name
        case Integer(value):
            return str(value)
        case Pose(row, column):
            return f"T{row}{column}"
        case Joint(number, role):
            return f"{role}{number}"
        case Apply("neg", (operand,)):
            return f"-{expression_text(operand)}"
        case Apply(operator, (left, right)) if operator in _INFIX:
            return f"({expression_text(left)} {_INFIX[operator]} {expression_text(right)})"
        case Apply(operator, operands):
            return f"{operator}({', '.join(map(expression_text, operands))})"
