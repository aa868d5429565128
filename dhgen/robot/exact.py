"""Exact values of the form a + b sqrt(2) + c sqrt(3) + d sqrt(6).

They are closed under sums and products, and hold the cosine of every multiple of pi/12: a rotation
by such angles is kept exact whatever is multiplied.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from dhgen.robot.expression import ONE, ZERO, Binary, Call, Expression, Name, Negate, Number

if TYPE_CHECKING:
    from collections.abc import Mapping

_ROOTS = (1, 2, 3, 6)


@dataclass(frozen=True, slots=True)
class Surd:
    """The coefficients of 1, sqrt(2), sqrt(3) and sqrt(6)."""

    coefficients: tuple[Fraction, Fraction, Fraction, Fraction]

    @classmethod
    def of(cls, value: Fraction | int, root: int = 1) -> Surd:
        """The value times sqrt(root), root out of 1, 2, 3, 6."""
        a, b, c, d = (Fraction(value if root == r else 0) for r in _ROOTS)
        return cls((a, b, c, d))

    def __add__(self, other: Surd) -> Surd:
        a, b, c, d = (x + y for x, y in zip(self.coefficients, other.coefficients, strict=True))
        return Surd((a, b, c, d))

    def __neg__(self) -> Surd:
        a, b, c, d = self.coefficients
        return Surd((-a, -b, -c, -d))

    def __mul__(self, other: Surd) -> Surd:
        a, b, c, d = self.coefficients
        e, f, g, h = other.coefficients
        return Surd(
            (
                a * e + 2 * b * f + 3 * c * g + 6 * d * h,
                a * f + b * e + 3 * (c * h + d * g),
                a * g + c * e + 2 * (b * h + d * f),
                a * h + d * e + b * g + c * f,
            )
        )

    def inverse(self) -> Surd | None:
        """1 / self where self is a single term; None otherwise."""
        terms = [(x, r) for x, r in zip(self.coefficients, _ROOTS, strict=True) if x]
        if len(terms) != 1:
            return None
        ((coefficient, root),) = terms
        return Surd.of(1 / (coefficient * root), root)

    def expression(self) -> Expression:
        """The value as an expression over one common denominator: sqrt(3)/2, (1 + sqrt(2))/4."""
        denominator = math.lcm(*(x.denominator for x in self.coefficients))
        numerator: Expression = ZERO
        for coefficient, root in zip(self.coefficients, _ROOTS, strict=True):
            term = _term(int(abs(coefficient) * denominator), root)
            if coefficient and numerator == ZERO:
                numerator = term if coefficient > 0 else Negate(term)
            elif coefficient:
                numerator = Binary("+" if coefficient > 0 else "-", numerator, term)
        if denominator == 1 or numerator == ZERO:
            return numerator
        if isinstance(numerator, Negate):
            return Negate(_over(numerator.operand, denominator))
        return _over(numerator, denominator)


def surd(expression: Expression) -> Surd | None:
    """The exact value of an expression that is such a number, or None."""
    match expression:
        case Number(value):
            return Surd.of(value)
        case Negate(operand):
            inner = surd(operand)
            return None if inner is None else -inner
        case Call("sqrt", Number(value)) if value >= 0:
            return square_root(value)
        case Binary("+" | "-" | "*" | "/" as operator, left, right):
            a, b = surd(left), surd(right)
            return None if a is None or b is None else _combine(operator, a, b)
        case _:
            return None


def _combine(operator: str, a: Surd, b: Surd) -> Surd | None:
    if operator == "+":
        return a + b
    if operator == "-":
        return a + -b
    factor = b if operator == "*" else b.inverse()
    return None if factor is None else a * factor


def square_root(value: Fraction) -> Surd | None:
    """The root of a rational number that is not negative, or None where it is no such number."""
    # sqrt(n/d) = sqrt(n d)/d
    product = value.numerator * value.denominator
    for root in _ROOTS:
        square, rest = divmod(product, root)
        whole = math.isqrt(square)
        if rest == 0 and whole * whole == square:
            return Surd.of(Fraction(whole, value.denominator), root)
    return None


def _term(factor: int, root: int) -> Expression:
    if root == 1:
        return Number(Fraction(factor))
    call = Call("sqrt", Number(Fraction(root)))
    return call if factor == 1 else Binary("*", Number(Fraction(factor)), call)


def _over(numerator: Expression, denominator: int) -> Expression:
    if isinstance(numerator, Number):
        return Number(numerator.value / denominator)
    return Binary("/", numerator, Number(Fraction(denominator)))


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


def rational(expression: Expression, known: Mapping[str, Fraction]) -> Fraction | None:
    """The exact value of an expression that is a ratio of whole numbers, or None.

    Args:
        expression: Of numbers and parameters.
        known: The parameters that are such ratios.
    """
    match expression:
        case Number(value):
            return value
        case Name(name):
            return known.get(name)
        case Negate(operand):
            inner = rational(operand, known)
            return None if inner is None else -inner
        case Binary(operator, left, right):
            a, b = rational(left, known), rational(right, known)
            return None if a is None or b is None else _combined(operator, a, b)
        case _:
            return None


def _combined(operator: str, a: Fraction, b: Fraction) -> Fraction | None:
    match operator:
        case "+":
            return a + b
        case "-":
            return a - b
        case "*":
            return a * b
        case "/":
            return a / b
        case _:
            return a ** int(b)  # whole, as cells demand
