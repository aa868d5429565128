"""Looking into formulas."""

from __future__ import annotations

from dataclasses import fields
from typing import TYPE_CHECKING

from dhgen.derivation.text.blocks import Display, Given, Paragraph, Picture, Prose, Table, unfolded
from dhgen.derivation.text.formula import Minus, Number, Sum, Symbol

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula


def occurs(symbol: Symbol, formula: Formula) -> bool:
    """Whether a formula holds a symbol."""
    return formula == symbol or any(occurs(symbol, part) for part in parts_of(formula))


def parts_of(formula: Formula) -> tuple[Formula, ...]:
    """The formulas that a formula is made of."""
    if isinstance(formula, Symbol | Number):
        return ()
    found: list[Formula] = []
    for field in fields(formula):
        value = getattr(formula, field.name)
        if isinstance(value, tuple):
            for each in value:
                found += (
                    [p for p in each if p is not None]
                    if isinstance(each, tuple)
                    else ([] if isinstance(each, str) else [each])
                )
        elif not isinstance(value, int | str):
            found.append(value)
    return tuple(found)


def begins_negative(formula: Formula) -> bool:
    """Whether a formula begins with a minus sign."""
    match formula:
        case Minus():
            return True
        case Sum(terms):
            return isinstance(terms[0], Minus)
        case _:
            return False


def symbols_of(blocks: Iterable[Block]) -> frozenset[Symbol]:
    """The symbols anywhere in the blocks."""
    return frozenset(
        symbol
        for block in unfolded(blocks)
        for formula in _formulas_of(block)
        for symbol in symbols_in(formula)
    )


def symbols_in(formula: Formula) -> Iterator[Symbol]:
    """The symbols of a formula, each as often as it occurs."""
    if isinstance(formula, Symbol):
        yield formula
    for part in parts_of(formula):
        yield from symbols_in(part)


def _formulas_of(block: Block) -> Iterator[Formula]:
    match block:
        case Display(formulas):
            yield from formulas
        case Paragraph(prose, lead):
            for each in (prose, lead):
                yield from _in_prose(each) if each is not None else ()
        case Table(header, rows):
            for row in (header, *rows):
                for cell in row:
                    yield from _in_prose(cell)
        case Picture(caption=caption):
            yield from _in_prose(caption)
        case _:
            pass


def _in_prose(prose: Prose) -> Iterator[Formula]:
    for part in prose.parts:
        if isinstance(part, Prose):
            yield from _in_prose(part)
        elif not isinstance(part, Given):
            yield part
