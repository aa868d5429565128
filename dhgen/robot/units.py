"""The joint variable in a cell, and the units that its expression is in."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.robot.angles import degrees_text, turns_notice
from dhgen.robot.exact import add, negate, subtract
from dhgen.robot.expression import (
    DEGREE,
    ZERO,
    Binary,
    Call,
    Expression,
    Name,
    Negate,
    Number,
    Pi,
    parts,
    to_text,
)
from dhgen.robot.source import quoted

if TYPE_CHECKING:
    from collections.abc import Callable


VARIABLE = Name("q")


@dataclass(frozen=True, slots=True)
class Split:
    """sign*q + offset; a sign of 0 means that there is no q."""

    sign: int
    offset: Expression


def split(expression: Expression) -> Split | None:
    """An expression as sign*q + offset; None when q is in it in any other way."""
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


class SaidUnits:
    """Which expressions name the unit of an angle, in files of radians and of degrees.

    Attributes:
        degrees: Whether angles without one are degrees.
    """

    def __init__(self, value: Callable[[Expression], float]) -> None:
        self.degrees = False
        self._value = value
        self._angles: set[str] = set()
        self._in_degrees: set[str] = set()

    def define(self, name: str, expression: Expression) -> None:
        """Make a parameter known."""
        if self.speaks_of_pi(expression):
            self._angles.add(name)
        if self.is_in_degrees(expression):
            self._in_degrees.add(name)

    def radians(self, expression: Expression) -> Expression:
        """A cell's angle in radians: in a file of degrees only what speaks of pi is so already."""
        if not self.degrees or expression == ZERO or self.speaks_of_pi(expression):
            return expression
        return Binary("*", expression, DEGREE)

    def speaks_of_pi(self, expression: Expression) -> bool:
        """Whether pi or deg is a term or a factor of it, which names its unit."""
        match expression:
            case Pi():
                return True
            case Name(name):
                return name in self._angles
            case Negate(operand) | Call("sqrt", operand):
                return self.speaks_of_pi(operand)
            case Binary(_, left, right):
                return self.speaks_of_pi(left) or self.speaks_of_pi(right)
            case _:
                return False  # the argument of a sine has no part in what the sine measures

    def is_in_degrees(self, expression: Expression) -> bool:
        """Whether it is so many degrees, or a sum with some.

        Products of more than that may be lengths of arcs, and quotients of two angles are ratios.
        """
        match expression:
            case Name(name):
                return name in self._in_degrees
            case Negate(operand):
                return self.is_in_degrees(operand)
            case Binary("+" | "-", left, right):
                return self.is_in_degrees(left) or self.is_in_degrees(right)
            case Binary("*", Number() | Negate(Number()), factor):
                return factor == DEGREE
            case _:
                return expression == DEGREE

    def mixed_notice(self, angle: Expression) -> str | None:
        """The notice for a plain number that is added to what holds pi.

        In a file of radians only where the sum looks like degrees.
        """
        if self.degrees:
            return self.mixture_notice(angle)
        number = self._plain_addend(angle)
        return turns_notice(self._value(angle), degrees_text(number)) if number else None

    def mixture_notice(self, angle: Expression) -> str | None:
        """The doubt about a plain number in either file, where something is wrong besides."""
        number = self._plain_addend(angle)
        if number is None:
            return None
        text = f"has {to_text(number)} in rad, as it is next to pi or deg"
        return f"{text}: write {degrees_text(number)} if degrees are meant"

    def _plain_addend(self, expression: Expression) -> Expression | None:
        """The first number but zero that is added to what speaks of pi, and does not itself."""
        if not isinstance(expression, Binary) or not self.speaks_of_pi(expression):
            return None
        sides = (expression.left, expression.right)
        plain = [side for side in sides if not self.speaks_of_pi(side) and self._value(side)]
        if expression.operator in {"+", "-"} and plain:
            return plain[0]
        inner = (self._plain_addend(side) for side in sides)
        return next((number for number in inner if number is not None), None)

    def argument_notices(self, expression: Expression) -> list[str]:
        """The notices for arguments of sin and cos that look like degrees: they are in radians."""
        calls = [part for part in parts(expression) if isinstance(part, Call)]
        return [
            f"{quoted(to_text(call))} takes rad: write {call.function}"
            f"({degrees_text(call.argument)}) if degrees are meant"
            for call in calls
            if call.function != "sqrt" and self._is_plain(call.argument)
        ]

    def _is_plain(self, argument: Expression) -> bool:
        """Whether a number does not speak of pi, and so may be meant as degrees."""
        if self.speaks_of_pi(argument) or VARIABLE in parts(argument):
            return False
        value = self._value(argument)
        return bool(value) and (self.degrees or turns_notice(value, "") is not None)
