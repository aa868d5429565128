"""What occurs in expressions and in programs, and what is asked of them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.program.ir import AllJoints, Apply, Guard, Joint, Let, Roots, Variable

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.general.kernel import GeneralKernel
    from dhgen.numerical.kernel import NumericalKernel
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


def uses(program: Program, operator: str) -> bool:
    """Whether an operator occurs."""
    return any(isinstance(e, Apply) and e.operator == operator for e in expressions(program))


def reads(program: Program, role: str) -> bool:
    """Whether a program reads joint values of this role."""
    whole = any(isinstance(s, AllJoints) for s in program.body)
    read = any(isinstance(e, Joint) and e.role == role for e in expressions(program))
    return read or (whole and role == "seed")


def whole_arm(program: Program) -> AllJoints | None:
    """The statement that solves all joints at once, where there is one."""
    found = (statement for statement in program.body if isinstance(statement, AllJoints))
    return next(found, None)


def general_kernel(program: Program) -> GeneralKernel | None:
    """The general algorithm's constants of the arm, where that solves it."""
    whole = whole_arm(program)
    return None if whole is None else whole.general


def descents(program: Program) -> NumericalKernel | None:
    """The constants of least squares for the arm, where they solve it or complete its rows."""
    whole = whole_arm(program)
    return program.completion if whole is None else whole.descent


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
