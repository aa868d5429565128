"""Sums rewritten so that each of their terms fits in a line: c (u + v) becomes c u + c v.

Widths are counted in the plain style, which is about what a formula takes on a page.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from dhgen.derivation.text.formula import (
    ONE,
    Minus,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
    add,
    factors_of,
    minus,
    number,
    over,
    times,
)
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import PLAIN

if TYPE_CHECKING:
    from dhgen.derivation.text.formula import Formula

LEAST = 30  # visible characters that are left to a bracket, however long its factors are
_ORDER = {"c": 1, "s": 1, "r": 2, "w": 3, "t": 4}  # letters are constants otherwise


def width(formula: Formula) -> int:
    """Visible characters of a formula in one line."""
    return len(show(formula, PLAIN))


def terms_within(formula: Formula, room: int) -> tuple[Formula, ...]:
    """Terms whose sum is the formula, none wider than the room as far as that is possible."""
    if isinstance(formula, Sum):
        return tuple(part for term in formula.terms for part in terms_within(term, room))
    if width(formula) <= room:
        return (formula,)
    match formula:
        case Minus(operand):
            return tuple(minus(part) for part in terms_within(operand, room))
        case Quotient(above, below):
            parts = _packed(terms_within(above, room), room)
            return tuple(_multiplied([], part, below) for part in parts)
        case Product(factors) if sums := [f for f in factors if isinstance(f, Sum | Quotient)]:
            longest = max(sums, key=width)
            rest = list(factors)
            rest.remove(longest)
            left = max(room - (width(formula) - width(longest)), LEAST)
            parts = _packed(terms_within(longest, left), left)
            return tuple(_multiplied(rest, part) for part in parts) if parts[1:] else (formula,)
        case _:
            return (formula,)


def _packed(terms: tuple[Formula, ...], room: int) -> tuple[Formula, ...]:
    """The same sum in fewer terms: as many together as fit in the room."""
    groups: list[list[Formula]] = []
    used = 0
    for term in terms:
        needed = width(term) + len(" + ")
        if not groups or used + needed > room:
            groups.append([])
            used = 0
        groups[-1].append(term)
        used += needed
    return tuple(add(*group) for group in groups)


def _multiplied(factors: list[Formula], part: Formula, below: Formula = ONE) -> Formula:
    """Factors times a part of a bracket: its sign in front, numbers, then letters in order."""
    if isinstance(part, Minus):
        return minus(_multiplied(factors, part.operand, below))
    if isinstance(part, Sum) and all(isinstance(term, Minus) for term in part.terms):
        return minus(_multiplied(factors, minus(part), below))
    above = [*factors, *factors_of(part)]
    under = factors_of(below)
    upper, lower = _fraction(list(filter(_is_number, above)), list(filter(_is_number, under)))
    letters = sorted((f for f in above if not _is_number(f)), key=_place)
    if below == ONE:
        return times(over(upper, lower), *letters)
    return over(times(upper, *letters), times(lower, *(f for f in under if not _is_number(f))))


def _place(factor: Formula) -> tuple[int, str]:
    """In a product lengths come first, then cosines and sines by their joints, then the pose."""
    base = factor.base if isinstance(factor, Power) else factor
    if not isinstance(base, Symbol):
        return len(_ORDER), ""
    kind = _ORDER.get(base.text[0], 0)
    return kind, base.text[1:] if kind == _ORDER["c"] else ""


def _is_number(factor: Formula) -> bool:
    if isinstance(factor, Quotient):
        return all(map(_is_number, (*factors_of(factor.over), *factors_of(factor.under))))
    return isinstance(factor, Number) or _radicand(factor) is not None


def _fraction(above: list[Formula], below: list[Formula]) -> tuple[Formula, Formula]:
    """What is above and below the stroke of a ratio of numbers, in lowest terms."""
    value = Fraction(1)
    roots: tuple[list[Formula], list[Formula]] = ([], [])
    waiting = [*((each, False) for each in above), *((each, True) for each in below)]
    while waiting:
        each, lower = waiting.pop(0)
        radicand = _radicand(each)
        if isinstance(each, Quotient):
            waiting += [(factor, lower) for factor in factors_of(each.over)]
            waiting += [(factor, not lower) for factor in factors_of(each.under)]
        elif isinstance(each, Number):
            value = value / each.value if lower else value * each.value
        elif each in roots[not lower]:
            roots[not lower].remove(each)
        elif each in roots[lower] and radicand is not None:
            roots[lower].remove(each)
            value = value / radicand if lower else value * radicand
        else:
            roots[lower].append(each)
    upper = times(number(value.numerator), *roots[0])
    return upper, times(number(value.denominator), *roots[1])


def _radicand(factor: Formula) -> int | None:
    """The whole number under the root that a symbol is."""
    digits = factor.text.removeprefix("√") if isinstance(factor, Symbol) else ""
    return int(digits) if digits.isdigit() else None
