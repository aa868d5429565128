"""Arithmetic as it may stand in a robot file, and its two meanings: a float, or a text."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from collections.abc import Mapping

Operator = Literal["+", "-", "*", "/", "**"]
Function = Literal["sqrt", "sin", "cos"]


@dataclass(frozen=True, slots=True)
class Number:
    """A literal, exact as written: 0.4318 is 4318/10000."""

    value: Fraction


@dataclass(frozen=True, slots=True)
class Pi:
    """The circle's number."""


@dataclass(frozen=True, slots=True)
class Name:
    """A parameter of the file."""

    name: str


@dataclass(frozen=True, slots=True)
class Negate:
    """Minus something."""

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
        case Negate(operand):
            return -evaluate(operand, parameters)
        case Call(function, argument):
            value = evaluate(argument, parameters)
            return {"sqrt": math.sqrt, "sin": math.sin, "cos": math.cos}[function](value)
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
