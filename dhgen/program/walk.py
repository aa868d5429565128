"""What occurs in expressions and in programs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.program.ir import Apply, Guard, Let, Roots, Variable

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.program.ir import Expression, Program, Statement


def parts(*whole: Expression) -> Iterator[Expression]:
    """Expressions and all that they are made of, each as often as it occurs."""
    pending = list(whole)
    while pending:
        expression = pending.pop()
        yield expression
        if isinstance(expression, Apply):
            pending += expression.operands


def names_in(*whole: Expression) -> set[str]:
    """The names that occur in expressions."""
    return {part.name for part in parts(*whole) if isinstance(part, Variable)}


def expressions(program: Program) -> Iterator[Expression]:
    """Every expression of a program and its parts."""
    stated = (each for statement in program.body for each in _stated(statement))
    return parts(*stated, *program.outputs)


def finds_roots(program: Program) -> bool:
    """Whether roots of polynomials are looked for."""
    return any(isinstance(statement, Roots) for statement in program.body)


def _stated(statement: Statement) -> tuple[Expression, ...]:
    """What a statement is made of."""
    match statement:
        case Let(expression=expression):
            return (expression,)
        case Guard(condition=condition, margin=margin, chosen=chosen):
            others = (margin, *(choice.value for choice in chosen))
            return (condition, *(each for each in others if each is not None))
        case Roots(coefficients=coefficients):
            return coefficients
        case _:
            return ()
