"""Constructors that do what is obvious at once: 0*x is 0, --x is x, 1/2*sqrt(2) is sqrt(2)/2."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.expression import ONE, ZERO, Binary, Expression, Negate, Number
from dhgen.robot.surds import surd

if TYPE_CHECKING:
    from fractions import Fraction


def number(value: Fraction) -> Expression:
    """A number; a negative one as the negative of a number, as a cell writes it."""
    return Number(value) if value >= 0 else Negate(Number(-value))


def negate(a: Expression) -> Expression:
    """The negative of a."""
    if a == ZERO:
        return ZERO
    return a.operand if isinstance(a, Negate) else Negate(a)


def add(a: Expression, b: Expression) -> Expression:
    """The sum a + b."""
    if (exact := _exact("+", a, b)) is not None:
        return exact
    if a == ZERO:
        return b
    if b == ZERO:
        return a
    return Binary("-", a, b.operand) if isinstance(b, Negate) else Binary("+", a, b)


def subtract(a: Expression, b: Expression) -> Expression:
    """The difference a - b."""
    return add(a, negate(b))


def multiply(a: Expression, b: Expression) -> Expression:
    """The product a b."""
    if (exact := _exact("*", a, b)) is not None:
        return exact
    if ZERO in (a, b):
        return ZERO
    if isinstance(a, Negate):
        return negate(multiply(a.operand, b))
    if isinstance(b, Negate):
        return negate(multiply(a, b.operand))
    if ONE in (a, b):
        return b if a == ONE else a
    return _product(b, a) if surd(b) is not None else _product(a, b)


def _product(a: Expression, b: Expression) -> Expression:
    """Exact factors come first, and become one: sqrt(2)/2 (sqrt(2)/2 x) is 1/2 x."""
    match b:
        case Binary("*", left, right) if (exact := _exact("*", a, left)) is not None:
            return multiply(exact, right)
        case _:
            return Binary("*", a, b)


def canonical(a: Expression) -> Expression:
    """The one form of an exact number: sqrt(1/2) and 1/sqrt(2) are sqrt(2)/2."""
    exact = surd(a)
    return a if exact is None else exact.expression()


def _exact(operator: str, a: Expression, b: Expression) -> Expression | None:
    x, y = surd(a), surd(b)
    if x is None or y is None:
        return None
    return (x + y if operator == "+" else x * y).expression()
