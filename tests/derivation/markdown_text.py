"""The words of a committed derivation, as its French is looked up: a mark for what stays."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from dhgen.derivation.french.catalogue import MARKS

if TYPE_CHECKING:
    from collections.abc import Iterator

MARK = MARKS[0]
FORMULA = re.compile(r"\$`[^$]*`\$|\$[^$]+\$")
UNIT = re.compile(rf"(?<={MARK} )(?:m|mm)(?=[ ,.;]|$)")
CITED = re.compile(r"(Source of the numbers: ).*\.$")
PICTURE = re.compile(r"!\[(.*)\]\(.*\)")


def texts(document: str, names: tuple[str, str] = ("joint", "name")) -> Iterator[str]:
    """Headings, paragraphs, captions, and cells of tables.

    Args:
        document: Markdown, as it is printed.
        names: How columns are headed of which the cells are names.
    """
    bare = re.sub(r"```.*?```|<!--.*?-->|</?details>", "", document, flags=re.DOTALL)
    for block in filter(None, map(str.strip, re.split(r"\n\s*\n", bare))):
        text = UNIT.sub(MARK, FORMULA.sub(MARK, block))
        if text.startswith("|"):
            yield from _cells(text, names)
        elif text.startswith("#"):
            title = text.lstrip("# ")
            yield re.sub(r"^.*(?=: inverse kinematics$)", MARK, title)
        elif picture := PICTURE.fullmatch(text):
            yield picture[1]
        elif summary := re.fullmatch("<summary>(.*)</summary>", text):
            yield summary[1]
        else:
            lead = re.fullmatch(r"\*\*(.+?)\*\* ?(.*)", text, re.DOTALL)
            for part in lead.groups() if lead else [text]:
                yield CITED.sub(rf"\1{MARK}.", part)


def _cells(table: str, names: tuple[str, str]) -> Iterator[str]:
    header, _, *rows = (
        [*map(str.strip, line.strip("| ").split(" | "))] for line in table.split("\n")
    )
    yield from header
    for row in rows:
        for name, cell in zip(header, row, strict=True):
            if name in names:
                continue  # a number, and what the file calls it; the name of a row
            yield cell
