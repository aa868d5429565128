"""The joint variable in a cell: `q`, `-q`, `q + pi/2`, `0.1 - q`."""

from __future__ import annotations

from dataclasses import dataclass

from dhgen.robot.expression import ZERO, Binary, Expression, Name, Negate, parts
from dhgen.robot.simplify import add, negate, subtract

VARIABLE = Name("q")


@dataclass(frozen=True, slots=True)
class Split:
    """sign*q + offset; a sign of 0 means that there is no q."""

    sign: int
    offset: Expression


def split(expression: Expression) -> Split | None:
    """An expression as sign*q + offset; None when q stands in it in any other way."""
    if not contains_variable(expression):
        return Split(0, expression)
    match expression:
        case Name():
            return Split(1, ZERO)
        case Negate(operand):
            inner = split(operand)
            return None if inner is None else Split(-inner.sign, negate(inner.offset))
        case Binary("+" | "-" as operator, left, right):
            a, b = split(left), split(right)
            if a is None or b is None or (a.sign and b.sign):
                return None
            sign = b.sign if operator == "+" else -b.sign
            combine = add if operator == "+" else subtract
            return Split(a.sign + sign, combine(a.offset, b.offset))
        case _:
            return None


def contains_variable(expression: Expression) -> bool:
    """Whether q occurs."""
    return VARIABLE in parts(expression)
