"""Formulas as they are written in French: decimal commas, and the transforms of the courses."""

from __future__ import annotations

import re
from dataclasses import fields, replace
from functools import cache
from typing import Any, get_args

from dhgen.derivation.text.formula import Formula, Listing, Matrix, Symbol
from dhgen.derivation.text.walk import symbols_in

_POINT = re.compile(r"(?<=\d)\.(?=\d)")
_LATEX = (
    (_POINT, "{,}"),
    (re.compile(r"T_(\{\\mathrm\{base,)tool\}\}"), r"T_\1outil}}"),
    (re.compile(r"\bT_(\{[^{}]*\}|\w)\^(\d)"), r"{}^\2T_\1"),
    (re.compile(r"\bR_(\d)\^(\d)"), r"{}^\2R_\1"),
    (re.compile(r"\\mathrm\{seed\}"), r"\\mathrm{init}"),
    (re.compile(r"\\text\{and\}"), r"\\text{et}"),
)
_PLAIN = (
    (_POINT, ","),
    (re.compile("T_base,tool"), "T_base,outil"),
    (re.compile("T([₀₁₂₃₄₅₆₇₈₉ᵢₙ₋]+)⁰"), r"⁰T\1"),
    (re.compile(r"\bR([₀₁₂₃₄₅₆₇₈₉])\^3"), r"³R\1"),
    (re.compile(",seed"), ",init"),
    (re.compile("  and  "), "  et  "),
)


def french_formula(formula: Formula) -> Formula:
    """A formula in the notation of French courses."""
    if isinstance(formula, Symbol):
        return french_symbol(formula)
    inside: dict[str, Any] = {
        each.name: _inside(getattr(formula, each.name)) for each in fields(formula)
    }
    written = replace(formula, **inside)
    if isinstance(written, Listing | Matrix) and _has_decimals(written):
        return replace(written, separator=" ;")
    return written


@cache
def french_symbol(symbol: Symbol) -> Symbol:
    """A letter, or a number that is written as one."""
    latex = _written(symbol.latex, _LATEX, r"\,;\ ")  # mathematics drops blanks
    return replace(symbol, latex=latex, text=_written(symbol.text, _PLAIN, " ; "))


def _written(text: str, changes: tuple[tuple[re.Pattern[str], str], ...], apart: str) -> str:
    if text.startswith("(") and text.endswith(")"):
        text = text.replace(", ", apart)  # the coordinates of a point
    for before, after in changes:
        text = before.sub(after, text)
    return text


def _has_decimals(formula: Formula) -> bool:
    return any("{,}" in symbol.latex for symbol in symbols_in(formula))


def _inside(value: object) -> object:
    """The formulas that a part of a formula holds."""
    if isinstance(value, tuple):
        return tuple(map(_inside, value))
    return french_formula(value) if isinstance(value, get_args(Formula)) else value
