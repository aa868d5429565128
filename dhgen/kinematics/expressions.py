"""What an expression of a cell is: a multiple of pi, a bare number, a polynomial."""

from __future__ import annotations

import operator as arithmetic
from fractions import Fraction
from typing import TYPE_CHECKING

from dhgen.robot.exact import surd
from dhgen.robot.expression import Binary, Call, Name, Negate, Number, Pi

if TYPE_CHECKING:
    from dhgen.robot.expression import Expression

_ARITHMETIC = {
    "+": arithmetic.add,
    "-": arithmetic.sub,
    "*": arithmetic.mul,
    "/": arithmetic.truediv,
}


def multiple_of_pi(expression: Expression) -> Fraction | None:
    """The rational r with expression = r pi, or None when there is none."""
    parts = _pi_parts(expression)
    if parts is None or parts[0] != 0:
        return None
    return parts[1]


def _pi_parts(expression: Expression) -> tuple[Fraction, Fraction] | None:
    """Expression as rational + rational * pi."""
    match expression:
        case Number(value):
            return value, Fraction(0)
        case Pi():
            return Fraction(0), Fraction(1)
        case Negate(operand):
            parts = _pi_parts(operand)
            return parts and (-parts[0], -parts[1])
        case Binary(operator, left, right):
            first, second = _pi_parts(left), _pi_parts(right)
            if first is None or second is None:
                return None
            return _combine_pi_parts(operator, first, second)
        case _:
            return None


def _combine_pi_parts(
    operator: str, left: tuple[Fraction, Fraction], right: tuple[Fraction, Fraction]
) -> tuple[Fraction, Fraction] | None:
    match operator:
        case "+":
            return left[0] + right[0], left[1] + right[1]
        case "-":
            return left[0] - right[0], left[1] - right[1]
        case "*" if left[1] == 0:
            return left[0] * right[0], left[0] * right[1]
        case "*" if right[1] == 0:
            return left[0] * right[0], left[1] * right[0]
        case "/" if right[1] == 0 and right[0] != 0:
            return left[0] / right[0], left[1] / right[0]
        case _:
            return None


def bare_number(expression: Expression) -> Fraction | None:
    """The number, with its sign, that an expression consists of; None where it is more."""
    match expression:
        case Number(value):
            return value
        case Negate(Number(value)):
            return -value
        case _:
            return None


def rational_number(expression: Expression) -> Fraction | None:
    """What arithmetic of numbers alone gives, where that is a rational number."""
    match expression:
        case Negate(operand):
            inner = rational_number(operand)
            return None if inner is None else -inner
        case Binary("**", left, Number(power)) if power.denominator == 1 and power >= 0:
            base = rational_number(left)
            return None if base is None else base ** int(power)
        case Binary("+" | "-" | "*" | "/" as operator, left, right):
            first, second = rational_number(left), rational_number(right)
            if first is None or second is None or (operator == "/" and second == 0):
                return None
            return Fraction(_ARITHMETIC[operator](first, second))
        case _:
            value = surd(expression)
            return None if value is None or any(value.coefficients[1:]) else value.coefficients[0]


def is_polynomial(expression: Expression) -> bool:
    """Whether an expression is made of parameters, roots, cosines and sines without division."""
    match expression:
        case Number() | Name() | Call("cos" | "sin"):
            return True
        case Negate(operand):
            return is_polynomial(operand)
        case Binary("+" | "-" | "*", left, right):
            return is_polynomial(left) and is_polynomial(right)
        case Binary("/", left, Number(value)) if value != 0:
            return is_polynomial(left)
        case Binary("**", left, Number(value)) if value.denominator == 1 and value >= 0:
            return is_polynomial(left)
        case _:
            return surd(expression) is not None


def has_parameters(expression: Expression) -> bool:
    """Whether a parameter occurs in an expression."""
    match expression:
        case Name():
            return True
        case Negate(operand) | Call(_, operand):
            return has_parameters(operand)
        case Binary(_, left, right):
            return has_parameters(left) or has_parameters(right)
        case _:
            return False
