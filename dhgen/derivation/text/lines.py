"""Long formulas broken into lines: at relation signs first, then before plus and minus signs.

No line ends inside a bracket: where a bracket does not fit in a line, its factors are written anew
with each of its parts, c (u + v) as c u on one line and + c v on the next. Widths are counted in
the plain style, which is about what a formula takes on a page.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.text.formula import Listing, Relation
from dhgen.derivation.text.show import show, signed_terms
from dhgen.derivation.text.style import PLAIN
from dhgen.derivation.text.terms import terms_within, width

if TYPE_CHECKING:
    from dhgen.derivation.text.formula import Formula
    from dhgen.derivation.text.style import Style

WIDTH = 100  # visible characters of a line
INDENT = 4
SHORT = 10  # visible characters that may follow a long side on its line


def laid_out(formulas: tuple[Formula, ...], style: Style) -> list[tuple[str, str]]:
    """The lines of formulas one below the other, aligned when no first side is too long for it."""
    lines = [line for formula in formulas for line in broken(formula, style)]
    if not any(_is_long(formula) for formula in formulas):
        return lines
    return [("", f"{left} {right}" if left else right) for left, right in lines]


def _is_long(formula: Formula) -> bool:
    return isinstance(formula, Relation) and width(formula.sides[0]) + 3 > WIDTH // 2


def broken(formula: Formula, style: Style) -> list[tuple[str, str]]:
    """The lines of a formula, each as what stands left and right of the point of alignment."""
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
    return [text + style.comma for text in shown[:-1]] + shown[-1:]
