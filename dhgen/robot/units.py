"""The joint variable in a cell, and the units that its expression is in."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from dhgen.robot.angles import degrees_text, turns_notice
from dhgen.robot.exact import add, multiply, negate, surd
from dhgen.robot.expression import (
    DEGREE,
    ONE,
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
    from collections.abc import Callable, Mapping


VARIABLE = Name("q")
_OTHERS = re.compile(r"q(\d+)", re.ASCII)


@dataclass(frozen=True, slots=True)
class Split:
    """sign*q + offset, and multiples of other joints' variables.

    Attributes:
        sign: Of q; 0 means that there is no q.
        offset: What is added.
        others: What multiplies the variable of another joint, by its number.
    """

    sign: int
    offset: Expression
    others: Mapping[int, Expression] = field(default_factory=dict)

    @property
    def variable(self) -> str:
        """What the joint moves by, as a cell has it: q, -q, q - q2; empty for nothing."""
        own: dict[int, Expression] = {1: VARIABLE, 0: ZERO, -1: Negate(VARIABLE)}
        total = own[self.sign]
        for joint, factor in sorted(self.others.items()):
            total = add(total, multiply(factor, Name(f"q{joint}")))
        return "" if total == ZERO else to_text(total)


def split(expression: Expression) -> Split | None:
    """An expression as sign*q + multiples + offset; None when q is in it in any other way."""
    if not contains_variable(expression):
        return Split(0, expression)
    match expression:
        case Name(name):
            other = _OTHERS.fullmatch(name)
            return Split(0, ZERO, {int(other[1]): ONE}) if other else Split(1, ZERO)
        case Negate(operand):
            inner = split(operand)
            return None if inner is None else _negative(inner)
        case Binary("+" | "-" as operator, left, right):
            a, b = split(left), split(right)
            if a is None or b is None or (a.sign and b.sign):
                return None
            return _sum(a, b if operator == "+" else _negative(b))
        case Binary("*", left, right) if not contains_variable(left):
            return _multiple(left, right)
        case Binary("*", left, right) if not contains_variable(right):
            return _multiple(right, left)
        case Binary("/", left, right) if not contains_variable(right):
            return _multiple(_inverse(right), left)
        case _:
            return None


def _negative(a: Split) -> Split:
    others = {joint: negate(factor) for joint, factor in a.others.items()}
    return Split(-a.sign, negate(a.offset), others)


def _sum(a: Split, b: Split) -> Split:
    others = dict(a.others)
    for joint, factor in b.others.items():
        others[joint] = add(others.get(joint, ZERO), factor)
    return Split(a.sign + b.sign, add(a.offset, b.offset), others)


def _multiple(factor: Expression, expression: Expression) -> Split | None:
    """Of other joints' variables only: the own one has no factor but its sign."""
    inner = split(expression)
    if inner is None or inner.sign:
        return None
    others = {joint: multiply(factor, each) for joint, each in inner.others.items()}
    return Split(0, multiply(factor, inner.offset), others)


def _inverse(divisor: Expression) -> Expression:
    exact = surd(divisor)
    inverse = None if exact is None else exact.inverse()
    return Binary("/", ONE, divisor) if inverse is None else inverse.expression()


def contains_variable(expression: Expression) -> bool:
    """Whether q occurs, or the variable of another joint."""
    return any(
        isinstance(part, Name) and (part == VARIABLE or _OTHERS.fullmatch(part.name))
        for part in parts(expression)
    )


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
        """A cell's angle in radians: in a file of degrees only what holds pi is so already."""
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
        """The first number but zero that is added to what holds pi, and does not itself."""
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
        """Whether a number does not hold pi, and so may be meant as degrees."""
        if self.speaks_of_pi(argument) or contains_variable(argument):
            return False
        value = self._value(argument)
        return bool(value) and (self.degrees or turns_notice(value, "") is not None)
