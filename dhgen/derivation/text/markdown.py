"""Blocks as GitHub Markdown: fenced `math` blocks, and inline formulas between dollar signs.

GitHub reads Markdown before it reads formulas in a line: where a formula holds what Markdown would
take for its own, the form with backquotes is used, which it leaves alone.
"""

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
from dhgen.derivation.text.lines import lines_of
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import LATEX

if TYPE_CHECKING:
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula

_RISKY = re.compile(r"\}_|\\[^A-Za-z]|[|*`]|[<>](?! )|\[[^\]]*\]\(")
_SPECIAL = re.compile(r"([\\`*_\[\]<>#|~$&])")


def markdown(block: Block) -> str:
    """A block without its blank lines."""
    match block:
        case Heading(level, prose):
            return f"{'#' * level} {inline(prose)}"
        case Paragraph(prose, lead):
            text = inline(prose)
            return text if lead is None else f"**{inline(lead)}** {text}"
        case Display(formulas):
            return "```math\n" + _display(formulas) + "\n```"
        case Table(header, rows):
            return _table(header, rows)
        case Drawing(text):
            return f"```text\n{text}\n```"
        case Picture(path, title, caption):
            return f"![{escaped(title)}]({path})\n\n{inline(caption)}"
        case Folded(title, blocks):
            opened = f"<details>\n<summary>{title}</summary>"
            return "\n\n".join([opened, *map(markdown, blocks), "</details>"])


def inline(prose: Prose) -> str:
    """Prose in one line."""
    return in_line(prose, str, escaped, inline_formula, lambda text, path: f"[{text}]({path})")


def inline_formula(formula: Formula) -> str:
    """A formula inside a line of text."""
    latex = show(formula, LATEX)
    return f"$`{latex}`$" if _RISKY.search(latex) else f"${latex}$"


def escaped(text: str) -> str:
    """A text of the user, of which Markdown reads nothing as its own."""
    return " ".join(_SPECIAL.sub(r"\\\1", text).split())


def _display(formulas: tuple[Formula, ...]) -> str:
    pairs = lines_of(formulas, LATEX)
    lines = [f"{left} & {right}".strip() if right else left for left, right in pairs]
    if len(lines) == 1:
        return lines[0].replace(" & ", " ", 1) if pairs[0][1] else lines[0]
    body = " \\\\\n".join(lines)
    return f"\\begin{{aligned}}\n{body}\n\\end{{aligned}}"


def _table(header: tuple[Prose, ...], rows: tuple[tuple[Prose, ...], ...]) -> str:
    lines = [_row(header), "|" + "---|" * len(header)]
    lines += [_row(row) for row in rows]
    return "\n".join(lines)


def _row(cells: tuple[Prose, ...]) -> str:
    return "| " + " | ".join(inline(cell) for cell in cells) + " |"
