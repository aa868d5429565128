"""Arithmetic of a robot file, and its two meanings: a float, or a text."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

Operator = Literal["+", "-", "*", "/", "**"]
Function = Literal["sqrt", "sin", "cos"]


@dataclass(frozen=True, slots=True)
class Number:
    """A literal, exact as written: 0.4318 is 4318/10000."""

    value: Fraction


@dataclass(frozen=True, slots=True)
class Pi:
    """The number pi."""


@dataclass(frozen=True, slots=True)
class Name:
    """A parameter of the file."""

    name: str


@dataclass(frozen=True, slots=True)
class Negate:
    """The negative of an operand."""

    operand: Expression


@dataclass(frozen=True, slots=True)
class Binary:
    """Two operands and an operator; `**` takes a small integer on its right."""

    operator: Operator
    left: Expression
    right: Expression


@dataclass(frozen=True, slots=True)
class Call:
    """A function of one argument."""

    function: Function
    argument: Expression


Expression = Number | Pi | Name | Negate | Binary | Call

ZERO = Number(Fraction(0))
ONE = Number(Fraction(1))
DEGREE = Binary("/", Pi(), Number(Fraction(180)))


def parts(expression: Expression) -> Iterator[Expression]:
    """The expression and everything that it is made of."""
    yield expression
    match expression:
        case Negate(operand) | Call(_, operand):
            yield from parts(operand)
        case Binary(_, left, right):
            yield from parts(left)
            yield from parts(right)


def evaluate(expression: Expression, parameters: Mapping[str, float]) -> float:
    """The value of an expression.

    Args:
        expression: What to evaluate.
        parameters: The value of every name that may occur.

    Raises:
        ZeroDivisionError: A division by zero.
        ValueError: The square root of a negative number.
        OverflowError: A power beyond the range of a double.
    """
    match expression:
        case Number(value):
            return float(value)
        case Pi():
            return math.pi
        case Name(name):
            return parameters[name]
        case Negate(negated):
            return -evaluate(negated, parameters)
        case Call(function, argument):
            operand = evaluate(argument, parameters)
            return {"sqrt": math.sqrt, "sin": math.sin, "cos": math.cos}[function](operand)
        case Binary(operator, left, right):
            return _combine(operator, evaluate(left, parameters), evaluate(right, parameters))


def _combine(operator: Operator, left: float, right: float) -> float:
    match operator:
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
        case "/":
            return left / right
        case "**":
            return float(left**right)


def to_text(expression: Expression) -> str:
    """The expression as a cell may hold it, with as few parentheses as its structure needs.

    Numbers are exact decimals where they have one and fractions otherwise.
    """
    return _text(expression)[0]


_SUM, _PRODUCT, _SIGN, _POWER, _ATOM = range(5)
_STRENGTH = {"+": _SUM, "-": _SUM, "*": _PRODUCT, "/": _PRODUCT, "**": _POWER}


def _text(expression: Expression) -> tuple[str, int]:
    """The text, and how strongly its outermost operator binds."""
    match expression:
        case Number(value):
            result = _number_text(value)
        case Pi():
            result = "pi", _ATOM
        case Name(name):
            result = name, _ATOM
        case Negate(operand):
            result = "-" + _enclosed(operand, _SIGN), _SIGN
        case Call(function, argument):
            result = f"{function}({to_text(argument)})", _ATOM
        case Binary("**", left, right):
            result = f"{_enclosed(left, _ATOM)}**{_enclosed(right, _SIGN)}", _POWER
        case Binary(operator, left, right):
            strength = _STRENGTH[operator]
            sign = f" {operator} " if strength == _SUM else operator
            result = _enclosed(left, strength) + sign + _enclosed(right, strength + 1), strength
    return result


def _enclosed(expression: Expression, weakest: int) -> str:
    text, strength = _text(expression)
    return text if strength >= weakest else f"({text})"


def _number_text(value: Fraction) -> tuple[str, int]:
    """A decimal has a denominator of twos and fives only."""
    sign, strength = ("-", _SIGN) if value < 0 else ("", _ATOM)
    rest, places = value.denominator, 0
    while 10**places % rest:
        places += 1
        if places > rest.bit_length():
            return f"{value.numerator}/{value.denominator}", _PRODUCT
    digits = str(abs(value.numerator) * 10**places // rest).rjust(places + 1, "0")
    point = len(digits) - places
    return sign + digits[:point] + ("." + digits[point:] if places else ""), strength
