"""Formulas as values: what is printed as LaTeX, as plain text, and evaluated by the tests.

A formula does not hold its looks. `style.py` prints it, `lines.py` breaks it.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Symbol:
    """A letter with its index.

    Attributes:
        latex: Its spelling in a formula.
        text: Its spelling in a terminal.
        name: The generator of the algebra that it means, or "".
    """

    latex: str
    text: str
    name: str = ""


@dataclass(frozen=True, slots=True)
class Number:
    """A rational number."""

    value: Fraction


@dataclass(frozen=True, slots=True)
class Minus:
    """A formula with the opposite sign."""

    operand: Formula


@dataclass(frozen=True, slots=True)
class Sum:
    """Two terms or more."""

    terms: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Product:
    """Two factors or more, written side by side."""

    factors: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Power:
    """A formula to a whole power; -1 is the inverse of a matrix."""

    base: Formula
    exponent: int


@dataclass(frozen=True, slots=True)
class Quotient:
    """A fraction."""

    over: Formula
    under: Formula


@dataclass(frozen=True, slots=True)
class Root:
    """A square root."""

    operand: Formula


@dataclass(frozen=True, slots=True)
class Call:
    """A function of some arguments: atan2, sgn, wrap."""

    function: str
    arguments: tuple[Formula, ...]


@dataclass(frozen=True, slots=True)
class Size:
    """An absolute value."""

    operand: Formula


@dataclass(frozen=True, slots=True)
class Relation:
    """Sides with signs between them: a = b = c, a < b.

    Attributes:
        sides: Two or more.
        signs: One fewer, out of `=`, `<`, `>`, `<=`, `>=`, `!=`, `->`, `in`.
    """

    sides: tuple[Formula, ...]
    signs: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Listing:
    """Formulas side by side.

    Attributes:
        items: The formulas.
        separator: The text between them.
    """

    items: tuple[Formula, ...]
    separator: str = ","


@dataclass(frozen=True, slots=True)
class Matrix:
    """A matrix.

    Attributes:
        rows: The entries; None is one that does not matter.
        separator: The text between entries of a row where a matrix is written in one line; between
            rows it is doubled, or a semicolon where it is a comma.
    """

    rows: tuple[tuple[Formula | None, ...], ...]
    separator: str = ","


@dataclass(frozen=True, slots=True)
class Element:
    """An element of a matrix with a name, from 1: U_1[2,4]."""

    matrix: Formula
    row: int
    column: int


Formula = (
    Symbol
    | Number
    | Minus
    | Sum
    | Product
    | Power
    | Quotient
    | Root
    | Call
    | Size
    | Relation
    | Listing
    | Matrix
    | Element
)

ZERO = Number(Fraction(0))
ONE = Number(Fraction(1))


def number(value: int | Fraction) -> Formula:
    """A number; a negative one as the opposite of a positive one."""
    return Number(Fraction(value)) if value >= 0 else Minus(Number(Fraction(-value)))


def minus(operand: Formula) -> Formula:
    """The opposite of a formula, without two signs in a row."""
    match operand:
        case Minus(inner):
            return inner
        case Number(value) if value == 0:
            return operand
        case Sum(terms):
            return add(*(minus(term) for term in terms))
        case _:
            return Minus(operand)


def add(*terms: Formula) -> Formula:
    """The sum of some terms; a positive one comes first if there is one."""
    flat: list[Formula] = []
    for term in terms:
        if isinstance(term, Sum):
            flat += term.terms
        elif term != ZERO:
            flat.append(term)
    if not flat:
        return ZERO
    if isinstance(flat[0], Minus):
        first = next((t for t in flat if not isinstance(t, Minus)), None)
        if first is not None:
            flat.remove(first)
            flat.insert(0, first)
    return flat[0] if len(flat) == 1 else Sum(tuple(flat))


def subtract(left: Formula, right: Formula) -> Formula:
    """left - right."""
    return add(left, minus(right))


def is_function(formula: Formula) -> bool:
    """Whether a formula is the cosine or sine of an angle without parentheses: cos alpha_2."""
    base = formula.base if isinstance(formula, Power) else formula
    return isinstance(base, Symbol) and base.text.startswith(("cos ", "sin "))


def is_word(formula: Formula) -> bool:
    """Whether a formula is a name of several letters, or a power of one."""
    base = formula.base if isinstance(formula, Power) else formula
    return isinstance(base, Symbol) and base.latex.startswith(r"\mathit{")


def times(*factors: Formula) -> Formula:
    """The product of some factors; signs and numbers come first.

    Functions come last, or else what follows would seem to be part of their angle.
    """
    flat: list[Formula] = []
    value = Fraction(1)
    for factor in factors:
        inner = factor
        if isinstance(inner, Minus):
            value, inner = -value, inner.operand
        if isinstance(inner, Number):
            value *= inner.value
        elif isinstance(inner, Product):
            flat += inner.factors
        else:
            flat.append(inner)
    if value == 0:
        return ZERO
    flat.sort(key=is_function)
    flat = _with_powers(flat)
    if abs(value) != 1:
        flat.insert(0, Number(abs(value)))
    if not flat:
        return number(value)
    result = flat[0] if len(flat) == 1 else Product(tuple(flat))
    return result if value > 0 else minus(result)


def _with_powers(factors: list[Formula]) -> list[Formula]:
    """Factors of which a letter that comes twice in a row has an exponent."""
    found: list[Formula] = []
    for factor in factors:
        (base, power), (last, before) = map(_power_of, (factor, found[-1] if found else ONE))
        if base == last and isinstance(base, Symbol) and power > 0 and before > 0:
            found[-1] = Power(base, power + before)
        else:
            found.append(factor)
    return found


def _power_of(factor: Formula) -> tuple[Formula, int]:
    return (factor.base, factor.exponent) if isinstance(factor, Power) else (factor, 1)


def over(above: Formula, below: Formula) -> Formula:
    """A fraction with its sign in front."""
    if isinstance(above, Minus):
        return minus(over(above.operand, below))
    if isinstance(below, Minus):
        return over(minus(above), below.operand)
    if any(isinstance(each, Quotient) or _is_fraction(each) for each in factors_of(below)):
        return _without_fractions(above, below)
    if isinstance(above, Product) and isinstance(first := above.factors[0], Quotient):
        return over(times(first.over, *above.factors[1:]), times(first.under, below))
    if isinstance(above, Quotient):
        return over(above.over, times(above.under, below))
    if isinstance(above, Number) and above.value.denominator != 1:
        ratio = above.value
        return over(number(ratio.numerator), times(number(ratio.denominator), below))
    if below == ONE or above == ZERO:
        return above
    return Quotient(above, below)


def factors_of(formula: Formula) -> tuple[Formula, ...]:
    """The factors of a product; anything else is its own."""
    return formula.factors if isinstance(formula, Product) else (formula,)


def _is_fraction(formula: Formula) -> bool:
    return isinstance(formula, Number) and formula.value.denominator != 1


def _without_fractions(above: Formula, below: Formula) -> Formula:
    """A fraction by a fraction as one, without the factors that both its parts would have."""
    value = Fraction(1)
    parts: tuple[list[Formula], list[Formula]] = ([], [])
    waiting = [(each, 0) for each in factors_of(above)] + [(each, 1) for each in factors_of(below)]
    while waiting:
        each, place = waiting.pop(0)
        if isinstance(each, Number):
            value = value / each.value if place else value * each.value
        elif isinstance(each, Quotient):
            waiting = [
                *((factor, place) for factor in factors_of(each.over)),
                *((factor, 1 - place) for factor in factors_of(each.under)),
                *waiting,
            ]
        elif each in parts[1 - place]:
            parts[1 - place].remove(each)
        else:
            parts[place].append(each)
    for each in [each for each in parts[1] if isinstance(each, Symbol)]:
        radicand = each.text.removeprefix("√")
        if radicand != each.text and value.numerator % int(radicand) == 0:
            value /= int(radicand)  # 2/√2 is √2
            parts[1].remove(each)
            parts[0].insert(0, each)
    upper, lower = number(value.numerator), number(value.denominator)
    return over(times(upper, *parts[0]), times(lower, *parts[1]))


def square(operand: Formula) -> Formula:
    """The square of a formula, without its sign."""
    if isinstance(operand, Minus):
        return square(operand.operand)
    if isinstance(operand, Number):
        return Number(operand.value**2)
    if isinstance(operand, Product):
        return times(*(square(factor) for factor in operand.factors))
    return Power(operand, 2)


def root(operand: Formula) -> Formula:
    """A square root; a square's root is an absolute value."""
    if operand in (ZERO, ONE):
        return operand
    if isinstance(operand, Power) and operand.exponent == 2:
        return Size(operand.base)
    return Root(operand)


def equal(*sides: Formula) -> Relation:
    """a = b = c, without equal sides in a row."""
    kept = [side for place, side in enumerate(sides) if place == 0 or side != sides[place - 1]]
    kept = kept if len(kept) > 1 else list(sides)
    return Relation(tuple(kept), ("=",) * (len(kept) - 1))


def relation(left: Formula, sign: str, right: Formula) -> Relation:
    """left sign right."""
    return Relation((left, right), (sign,))


def atan2(sine: Formula, cosine: Formula) -> Formula:
    """The angle with this sine and cosine, up to a common positive factor."""
    return Call("atan2", (sine, cosine))
