"""Formulas printed: signs and parentheses, which are the same in every style."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

from dhgen.derivation.text.formula import (
    Call,
    Element,
    Formula,
    Listing,
    Matrix,
    Minus,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Root,
    Size,
    Sum,
    Symbol,
    is_function,
    is_word,
)

if TYPE_CHECKING:
    from dhgen.derivation.text.style import Style


def show(formula: Formula, style: Style) -> str:
    """A formula in one line."""
    match formula:
        case Symbol():
            return style.symbol(formula)
        case Minus(operand):
            return style.minus + show_factor(operand, style)
        case Sum(terms):
            return "".join(signed_terms(terms, style))
        case Product(factors):
            return _show_product(factors, style)
        case Number() | Power() | Quotient() | Root() | Size():
            return _show_unit(formula, style)
        case _:
            return _show_group(formula, style)


def _show_unit(formula: Number | Power | Quotient | Root | Size, style: Style) -> str:
    match formula:
        case Number(value) if value.denominator == 1:
            return str(value)
        case Number(value):
            return style.quotient(str(value.numerator), str(value.denominator))
        case Power(base, exponent) if is_function(base):
            function, _, angle = show(base, style).partition(" ")
            return f"{style.power(function, exponent)} {angle}"
        case Power(base, exponent):
            return style.power(_base(base, style), exponent)
        case Quotient(above, below):
            return style.quotient(_part(above, style), _part(below, style))
        case Root(operand):
            return style.root(show(operand, style))
        case Size(operand):
            return style.size(show(operand, style))


def _show_group(formula: Call | Relation | Listing | Matrix | Element, style: Style) -> str:
    match formula:
        case Call("tan", (Quotient() as angle,)) if not style.slanted:
            return rf"\tan{show(angle, style)}"
        case Call(function, arguments):
            inside = ", ".join(show(argument, style) for argument in arguments)
            tall = not style.slanted and any(is_tall(argument) for argument in arguments)
            return style.function(function) + style.enclosed(inside, tall=tall)
        case Relation(sides, signs):
            parts = [show(sides[0], style)]
            for sign, side in zip(signs, sides[1:], strict=True):
                parts += [style.sign(sign), show(side, style)]
            return " ".join(parts)
        case Listing(items, separator):
            between = style.between(separator)
            return between.join(show(item, style) for item in items)
        case Matrix(rows, separator):
            entries = [[show_entry(entry, style) for entry in row] for row in rows]
            return style.matrix(entries, separator)
        case Element(matrix, row, column):
            name = show(matrix, style)
            name = name if isinstance(matrix, Symbol) else style.enclosed(name, tall=False)
            return f"{name}[{row},{column}]"


def _show_product(factors: tuple[Formula, ...], style: Style) -> str:
    """Factors side by side; beside a name of several letters there has to be room."""
    shown = show_factor(factors[0], style)
    for before, factor in pairwise(factors):
        room = style.room if is_word(before) or is_word(factor) else " "
        shown += room + show_factor(factor, style)
    return shown


def show_entry(entry: Formula | None, style: Style) -> str:
    """An entry of a matrix, or the sign for one that does not matter."""
    return style.any_entry if entry is None else show(entry, style)


def signed_terms(terms: tuple[Formula, ...], style: Style) -> list[str]:
    """The terms of a sum, each with its sign; joined they are the sum."""
    parts = []
    for place, term in enumerate(terms):
        negative = isinstance(term, Minus)
        inner = term.operand if isinstance(term, Minus) else term
        body = show_factor(inner, style) if negative else show(inner, style)
        if place == 0:
            parts.append((style.minus if negative else "") + body)
        else:
            parts.append((f" {style.minus} " if negative else " + ") + body)
    return parts


def show_factor(factor: Formula, style: Style) -> str:
    """A formula as a factor: a sum in parentheses."""
    return _enclosed(factor, style) if isinstance(factor, Sum | Minus) else show(factor, style)


def _base(base: Formula, style: Style) -> str:
    if isinstance(base, Symbol | Size | Matrix) or (
        isinstance(base, Number) and base.value.denominator == 1
    ):
        return show(base, style)
    return _enclosed(base, style)


def _enclosed(formula: Formula, style: Style) -> str:
    """In parentheses, which grow with what is in them unless fractions are in one line."""
    return style.enclosed(show(formula, style), tall=not style.slanted and is_tall(formula))


def _part(part: Formula, style: Style) -> str:
    """The upper or lower part of a fraction."""
    text = show(part, style)
    if not style.slanted or isinstance(part, Symbol | Number | Power | Root | Size):
        return text
    return style.enclosed(text, tall=False)


def is_tall(formula: Formula) -> bool:
    """Whether a formula is higher than a line, so that its parentheses have to grow."""
    match formula:
        case Quotient() | Matrix():
            return True
        case Number(value):
            return value.denominator != 1
        case Minus(operand) | Power(operand):
            return is_tall(operand)
        case Sum(parts) | Product(parts) | Call(_, parts) | Listing(parts) | Relation(parts):
            return any(is_tall(part) for part in parts)
        case _:
            return False
