"""Blocks as plain text for a terminal, with the letters of Unicode."""

from __future__ import annotations

import textwrap
from functools import partial
from typing import TYPE_CHECKING

from dhgen.derivation.text.blocks import (
    Display,
    Drawing,
    Folded,
    Heading,
    Paragraph,
    Picture,
    Table,
)
from dhgen.derivation.text.formula import Listing, Matrix, Product, Relation
from dhgen.derivation.text.inline import in_line
from dhgen.derivation.text.lines import laid_out
from dhgen.derivation.text.show import show, show_entry
from dhgen.derivation.text.style import PLAIN

if TYPE_CHECKING:
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula

COLUMNS = 96
INDENT = "    "


def plain(block: Block) -> str:
    """A block without its blank lines."""
    match block:
        case Heading(level, prose):
            text = words(prose)
            return f"{text}\n{('=' if level == 1 else '-') * len(text)}"
        case Paragraph(prose, lead):
            text = words(prose) if lead is None else f"{words(lead)} {words(prose)}"
            return textwrap.fill(text, COLUMNS, break_long_words=False, break_on_hyphens=False)
        case Display(formulas):
            return "\n".join(INDENT + line for line in _display(formulas))
        case Table(header, rows):
            return _table([[words(cell) for cell in row] for row in (header, *rows)])
        case Drawing(text):
            return textwrap.indent(text, INDENT)
        case Picture(path, _, caption):
            return textwrap.fill(f"{path}: {words(caption)}", COLUMNS, break_on_hyphens=False)
        case Folded(_, blocks):
            return "\n\n".join(map(plain, blocks))


def words(prose: Prose) -> str:
    """Prose in one line; backquotes, which only Markdown needs, are left out."""
    return in_line(prose, _without_backquotes, str, partial(show, style=PLAIN))


def _without_backquotes(text: str) -> str:
    return text.replace("`", "")


def _display(formulas: tuple[Formula, ...]) -> list[str]:
    if len(formulas) == 1:
        lines = box(formulas[0])
        if len(lines) > 1:
            return lines
    pairs = laid_out(formulas, PLAIN)
    margin = max(len(left) for left, _ in pairs)
    return [f"{left:>{margin}} {right}".rstrip() if margin else right for left, right in pairs]


def box(formula: Formula) -> list[str]:
    """A formula as lines of one width; more than one where it holds a matrix."""
    match formula:
        case Matrix(rows):
            return _matrix([[show_entry(entry, PLAIN) for entry in row] for row in rows])
        case Relation(sides, signs) if _spread(sides):
            parts = [box(sides[0])]
            for sign, side in zip(signs, sides[1:], strict=True):
                parts += [[f" {PLAIN.sign(sign)} "], box(side)]
            return _beside(parts)
        case Listing(items) if _spread(items):
            parts = [box(items[0])]
            for item in items[1:]:
                parts += [["   "], box(item)]
            return _beside(parts)
        case Product(factors) if _spread(factors):
            return _beside([box(factor) for factor in factors])
        case _:
            return [show(formula, PLAIN)]


def _spread(parts: tuple[Formula, ...]) -> bool:
    return any(len(box(part)) > 1 for part in parts)


def _matrix(rows: list[list[str]]) -> list[str]:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = ["  ".join(e.center(w) for e, w in zip(row, widths, strict=True)) for row in rows]
    last = len(lines) - 1
    if last == 0:
        return [f"[ {lines[0]} ]"]
    edges = ["┌┐" if i == 0 else "└┘" if i == last else "││" for i in range(len(lines))]
    return [f"{edge[0]} {line} {edge[1]}" for edge, line in zip(edges, lines, strict=True)]


def _beside(boxes: list[list[str]]) -> list[str]:
    height = max(map(len, boxes))
    filled = []
    for lines in boxes:
        width = max(map(len, lines))
        above = (height - len(lines)) // 2
        below = height - len(lines) - above
        blank = " " * width
        filled.append([blank] * above + [f"{x:<{width}}" for x in lines] + [blank] * below)
    return ["".join(parts).rstrip() for parts in zip(*filled, strict=True)]


def _table(rows: list[list[str]]) -> str:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    used = sum(widths[:-1]) + 2 * len(widths[:-1])
    widths[-1] = min(widths[-1], max(COLUMNS - used, 30))
    lines: list[str] = []
    for row in rows:
        start = "".join(f"{c:<{w}}  " for c, w in zip(row[:-1], widths[:-1], strict=True))
        last = textwrap.wrap(row[-1], widths[-1]) or [""]
        lines += [(start + last[0]).rstrip(), *(" " * used + rest for rest in last[1:])]
        if len(lines) == 1:
            lines.append("  ".join("─" * w for w in widths))
    return "\n".join(lines)
