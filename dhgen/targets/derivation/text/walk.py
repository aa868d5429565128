"""Looking into formulas."""

from __future__ import annotations

from dataclasses import fields
from typing import TYPE_CHECKING

from dhgen.targets.derivation.text.formula import Minus, Number, Sum, Symbol

if TYPE_CHECKING:
    from dhgen.targets.derivation.text.formula import Formula


def occurs(symbol: Symbol, formula: Formula) -> bool:
    """Whether a symbol stands in a formula."""
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


def leads_negative(formula: Formula) -> bool:
    """Whether a formula begins with a minus sign."""
    match formula:
        case Minus():
            return True
        case Sum(terms):
            return isinstance(terms[0], Minus)
        case _:
            return False
