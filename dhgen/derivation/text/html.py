"""Blocks as HTML, formulas as MathML, for the document of `handout.html.jinja`."""

from __future__ import annotations

import re
from functools import cache
from html import escape
from typing import TYPE_CHECKING

from latex2mathml.converter import convert

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
    from collections.abc import Mapping

    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula


THIN = "0.167em"  # browsers have spaces by their widths alone
COMMA = "{,}"  # of decimals, in LaTeX; the converter reads points alone
_DECIMAL = re.compile(r"(<mn>\d+)\.(\d+</mn>)")
_MATH = re.compile(r"<math [^>]*>(.*)</math>", re.DOTALL)
# The letters of an upright name, one by one: together they are the name of something.
_NAME = re.compile(
    r'<mrow>((?:<mi mathvariant="normal">.</mi>|<mn>\d</mn>|<mo>&#x0002C;</mo>){2,})</mrow>'
)
# A minus behind another operator is a sign, not a difference.
_SIGN = re.compile(r"(<mo[^>]*>&#x000(?:3D|3C|3E|2C|28|5B);</mo>)<mo>(?=&#x02212;)")


def html(block: Block, drawings: Mapping[str, str]) -> str:
    """A block without its blank lines.

    Args:
        block: The block.
        drawings: Where pictures are, or what they are, by their paths.
    """
    match block:
        case Heading(level, prose):
            return f"<h{level}>{inline(prose)}</h{level}>"
        case Paragraph(prose, lead):
            first = "" if lead is None else f"<strong>{inline(lead)}</strong> "
            return f"<p>{first}{inline(prose)}</p>"
        case Display(formulas):
            return _display(lines_of(formulas, LATEX))
        case Table(header, rows):
            lines = [_row("th", header), *(_row("td", row) for row in rows)]
            return '<div class="wide"><table>\n' + "\n".join(lines) + "\n</table></div>"
        case Drawing(text):
            return f'<pre class="wide">{escape(text)}</pre>'
        case Picture(path, title, caption):
            image = f'<img src="{escape(drawings[path])}" alt="{escape(title)}">'
            return f"<figure>{image}\n<figcaption>{inline(caption)}</figcaption></figure>"
        case Folded(title, blocks):
            opened = "\n".join(html(each, drawings) for each in blocks)
            return f"<details><summary>{escape(title)}</summary>\n{opened}\n</details>"


def inline(prose: Prose) -> str:
    """Prose in one line."""
    return in_line(prose, escape, escape, _in_text, _link)


def _link(text: str, path: str) -> str:
    return f'<a href="{escape(path, quote=True)}">{text}</a>'


def _in_text(formula: Formula) -> str:
    return f"<math>{_mathml(show(formula, LATEX))}</math>"


@cache
def _mathml(latex: str) -> str:
    if not latex:
        return ""
    converted = convert(latex.replace(COMMA, ".")).replace("thinmathspace", THIN)
    found = _MATH.fullmatch(converted)
    assert found is not None, latex
    numbers = _DECIMAL.sub(r"\1,\2", found[1]) if COMMA in latex else found[1]
    named = _NAME.sub(_in_one, numbers)
    return _SIGN.sub(r'\1<mo form="prefix">', named)


def _in_one(found: re.Match[str]) -> str:
    return f"<mi>{re.sub('<[^>]*>', '', found[1])}</mi>"


def _display(pairs: list[tuple[str, str]]) -> str:
    """Lines of formulas, aligned where they have two parts."""
    cells = (
        f"<mtr><mtd>{_mathml(left)}</mtd><mtd>{_mathml(right)}</mtd></mtr>" for left, right in pairs
    )
    table = '<mtable class="aligned" displaystyle="true">' + "\n".join(cells) + "</mtable>"
    return f'<div class="wide"><math display="block">{table}</math></div>'


def _row(kind: str, cells: tuple[Prose, ...]) -> str:
    shown = (f"<{kind}>{inline(cell)}</{kind}>" for cell in cells)
    return f"<tr>{''.join(shown)}</tr>"
