"""Blocks as LaTeX, for the document of `handout.tex.jinja`, which defines the commands."""

from __future__ import annotations

import re
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
from dhgen.derivation.text.inline import in_line
from dhgen.derivation.text.latex_text import latex_cells, latex_text
from dhgen.derivation.text.lines import lines_of
from dhgen.derivation.text.plain import words
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import LATEX

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula

LEVELS = {2: "section", 3: "subsection"}
LINES = 16  # of formulas that are kept on one page
BESIDE = 105  # characters that fit side by side in a table
BROKEN = 35  # of them in a column whose cells are broken into lines
_OPENING = re.compile(r'(^|[\s(])"')


def latex(block: Block, drawings: Mapping[str, str]) -> str:
    """A block without its blank lines.

    Args:
        block: The block.
        drawings: Pictures as TikZ, by their paths.
    """
    match block:
        case Heading(1, prose):
            return rf"\title{{{inline(prose)}}}"
        case Heading(level, prose):
            return rf"\{LEVELS[level]}{{{inline(prose)}}}"
        case Paragraph(prose, lead):
            text = inline(prose) if lead is None else rf"\textbf{{{inline(lead)}}} {inline(prose)}"
            return rf"{text}\nopagebreak" if text.endswith(":") else text
        case Display(formulas):
            return "\n\n".join(_displays(lines_of(formulas, LATEX)))
        case Table(header, rows):
            return _table(header, rows)
        case Drawing(text):
            lines = "\\\\\n".join(map(latex_cells, text.split("\n")))
            return f"\\drawing{{%\n{lines}}}"
        case Picture(path, _, caption):
            return f"\\drawn{{%\n{drawings[path]}}}{{{inline(caption)}}}"
        case Folded(title, blocks):
            heading = rf"\paragraph{{{_quoted(title)}}}\leavevmode\nopagebreak"
            return "\n\n".join([heading, *(latex(each, drawings) for each in blocks)])


def inline(prose: Prose) -> str:
    """Prose in one line."""
    return in_line(prose, _quoted, latex_text, _in_text)


def _in_text(formula: Formula) -> str:
    return f"${show(formula, LATEX)}$"


def _quoted(text: str) -> str:
    """Words with quotation marks that open and close."""
    pieces = _OPENING.sub("\\1\0", text).replace('"', "\1")
    return latex_text(pieces).replace("\0", "``").replace("\1", "''")


def _displays(pairs: list[tuple[str, str]]) -> Iterator[str]:
    """Lines of formulas, in groups of which none is broken at the end of a page."""
    for start in range(0, len(pairs), LINES):
        lines = (f"{left} & {right}" for left, right in pairs[start : start + LINES])
        body = " \\\\\n".join(lines)
        yield f"\\formulas{{%\n{body}}}"


def _table(header: tuple[Prose, ...], rows: tuple[tuple[Prose, ...], ...]) -> str:
    """A table, the cells of its longest columns in several lines where it would be too wide."""
    widths = [2 + max(map(len, map(words, column))) for column in zip(header, *rows, strict=True)]
    broken: set[int] = set()
    for column in sorted(range(len(widths)), key=lambda each: -widths[each]):
        kept = sum(width for place, width in enumerate(widths) if place not in broken)
        if kept + BROKEN * len(broken) <= BESIDE or widths[column] <= BROKEN:
            break
        broken.add(column)
    columns = "".join("L" if place in broken else "l" for place in range(len(widths)))
    body = " \\\\\n".join(" & ".join(map(inline, row)) for row in rows)
    name = "broadtable" if broken else "smalltable"
    return f"\\{name}{{{columns}}}{{{' & '.join(map(inline, header))}}}{{%\n{body}}}"
