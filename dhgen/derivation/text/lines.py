"""Long formulas broken into lines: at relation signs first, then before plus and minus signs.

No line ends inside a bracket: where a bracket does not fit in a line, its factors are written anew
with each of its parts, c (u + v) as c u on one line and + c v on the next. Widths are counted in
the plain style, which is about what a formula takes on a page.
"""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from dhgen.derivation.text.formula import (
    ONE,
    Listing,
    Matrix,
    Minus,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    Symbol,
    add,
    factors_of,
    minus,
    number,
    over,
    times,
)
from dhgen.derivation.text.show import show, signed_terms
from dhgen.derivation.text.style import PLAIN

if TYPE_CHECKING:
    from dhgen.derivation.text.formula import Formula
    from dhgen.derivation.text.style import Style


WIDTH = 100  # visible characters of a line
INDENT = 4
SHORT = 10  # visible characters that may follow a long side on its line


def lines_of(formulas: tuple[Formula, ...], style: Style) -> list[tuple[str, str]]:
    """The lines of a display; a formula alone is kept in one where it fits or holds a matrix."""
    if len(formulas) == 1 and (_has_matrix(formulas[0]) or len(broken(formulas[0], style)) == 1):
        return [(show(formulas[0], style), "")]
    return laid_out(formulas, style)


def _has_matrix(formula: Formula) -> bool:
    match formula:
        case Matrix():
            return True
        case Relation(parts) | Product(parts) | Listing(parts):
            return any(_has_matrix(part) for part in parts)
        case _:
            return False


def laid_out(formulas: tuple[Formula, ...], style: Style) -> list[tuple[str, str]]:
    """The lines of formulas one below the other, aligned when no first side is too long for it."""
    lines = [line for formula in formulas for line in broken(formula, style)]
    if not any(_is_long(formula) for formula in formulas):
        return lines
    return [("", f"{left} {right}" if left else right) for left, right in lines]


def _is_long(formula: Formula) -> bool:
    return isinstance(formula, Relation) and width(formula.sides[0]) + 3 > WIDTH // 2


def broken(formula: Formula, style: Style) -> list[tuple[str, str]]:
    """The lines of a formula, each as what is left and right of the point of alignment."""
    if not isinstance(formula, Relation):
        return [("", line) for line in filled(formula, style, WIDTH)]
    first = formula.sides[0]
    left = show(first, style)
    start = width(first) + 3
    if _is_long(formula):
        head = filled(first, style, WIDTH)
        lines = [("", line) for line in head]
        start = INDENT
        rest = _joined(formula, start, style)
        if len(rest) == 1 and len(_joined(formula, start, PLAIN)[0]) <= SHORT:
            lines[-1] = ("", f"{lines[-1][1]} {rest[0]}")
            return lines
        return [*lines, *(("", line) for line in rest)]
    pending = _joined(formula, start, style)
    return [(left if place == 0 else "", line) for place, line in enumerate(pending)]


def _joined(formula: Relation, start: int, style: Style) -> list[str]:
    """The sides after the first: on one line as long as they fit, else one below the other."""
    rest = formula.sides[1:]
    if start + sum(width(side) + 3 for side in rest) <= WIDTH:
        parts = (
            f"{style.sign(sign)} {show(side, style)}"
            for sign, side in zip(formula.signs, rest, strict=True)
        )
        return [" ".join(parts)]
    lines: list[str] = []
    for sign, side in zip(formula.signs, rest, strict=True):
        pieces = filled(side, style, WIDTH - min(start, WIDTH // 2))
        lines.append(f"{style.sign(sign)} {pieces[0]}")
        lines += pieces[1:]
    return lines


def filled(formula: Formula, style: Style, room: int) -> list[str]:
    """A formula in as many lines as it needs; lines after the first are indented."""
    if isinstance(formula, Listing):
        shown, plain = _items(formula, style), _items(formula, PLAIN)
    else:
        terms = terms_within(formula, room - INDENT)
        shown, plain = signed_terms(terms, style), signed_terms(terms, PLAIN)
    lines: list[str] = []
    used = 0
    for piece, visible in zip(shown, plain, strict=True):
        if lines and used + len(visible) <= room:
            lines[-1] += piece
            used += len(visible)
        else:
            indent = "" if not lines else r"\quad " if style is not PLAIN else " " * INDENT
            lines.append(indent + piece.lstrip())
            used = len(visible) + (INDENT if len(lines) > 1 else 0)
    return lines


def _items(listing: Listing, style: Style) -> list[str]:
    shown = [show(item, style) for item in listing.items]
    between = style.between(listing.separator)
    return [text + between for text in shown[:-1]] + shown[-1:]


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
    """The sum in fewer terms: as many together as fit in the room."""
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
