"""Expressions with signs where a person puts them: a - pi/2 and never a + -pi/2."""

from __future__ import annotations

from dhgen.robot.expression import ZERO, Binary, Call, Expression, Negate, Number


def signs_outside(expression: Expression) -> Expression:
    """The same expression without a sign behind a plus or minus, and without two in a row."""
    match expression:
        case Negate(operand):
            inner = signs_outside(operand)
            bare = without_sign(inner)
            return with_sign(inner) if bare is None else bare
        case Call(function, argument):
            return Call(function, signs_outside(argument))
        case Binary(operator, left, right):
            first, second = signs_outside(left), signs_outside(right)
            bare = without_sign(second)
            if bare is None or operator not in ("+", "-"):
                return Binary(operator, first, second)
            return Binary("-" if operator == "+" else "+", first, bare)
    return expression


def with_sign(expression: Expression) -> Expression:
    """The opposite of an expression without a sign; of a product's first factor."""
    match expression:
        case Binary("*" | "/" as operator, left, right):
            return Binary(operator, with_sign(left), right)
    return Negate(expression)


def without_sign(expression: Expression) -> Expression | None:
    """The opposite of what begins with a minus; None for a sum and for what has no sign."""
    match expression:
        case Negate(operand):
            return operand
        case Number(value) if value < 0:
            return Number(-value)
        case Binary("*" | "/" as operator, left, right):
            bare = without_sign(left)
            return None if bare is None else Binary(operator, bare, right)
    return None


def summands(expression: Expression) -> list[tuple[int, Expression]]:
    """The terms of a sum with their signs; what is in parentheses stays one term."""
    if expression == ZERO:
        return []
    whole = signs_outside(expression)
    match whole:
        case Binary("+" | "-" as operator, left, right):
            return [*summands(left), (1 if operator == "+" else -1, right)]
    return [sign_and_size(whole)]


def sign_and_size(expression: Expression) -> tuple[int, Expression]:
    """A factor as its sign and what has none; a sum has none of its own."""
    whole = signs_outside(expression)
    bare = without_sign(whole)
    return (1, whole) if bare is None else (-1, bare)


def sum_of(terms: list[tuple[int, Expression]]) -> Expression:
    """The sum of terms with their signs."""
    if not terms:
        return ZERO
    (sign, total), *others = terms
    total = total if sign > 0 else signs_outside(Negate(total))
    for sign, term in others:
        total = Binary("+" if sign > 0 else "-", total, term)
    return total
