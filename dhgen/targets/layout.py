"""Lines of code that fit on a page."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

WIDTH = 100
INDENT = "    "
GOES_ON = " \\"  # behind a line of a directive in C


def wrapped(line: str, indent: str, hanging: str = "    ", width: int = WIDTH) -> list[str]:
    """A line broken at spaces; the lines after the first are indented further."""
    return textwrap.wrap(
        line,
        width,
        subsequent_indent=indent + hanging,
        break_long_words=False,
        break_on_hyphens=False,
    )


def packed(
    pieces: Sequence[str], indent: str, separator: str = " ", width: int = WIDTH
) -> list[str]:
    """Pieces that must not be broken, as many on a line as fit."""
    lines: list[str] = []
    for piece in pieces:
        if lines and len(lines[-1]) + len(separator) + len(piece) <= width:
            lines[-1] += separator + piece
        else:
            lines.append(indent + piece)
    return lines


def listed(entries: Sequence[str], indent: str) -> list[str]:
    """The entries of a list, each with its comma."""
    return packed([f"{entry}," for entry in entries], indent)


def c_array(head: str, entries: Iterable[str]) -> str:
    """The definition of an array in C."""
    texts = list(entries)
    line = f"{head} = {{ {', '.join(texts)} }};"
    if len(line) <= WIDTH:
        return line
    return "\n".join([f"{head} = {{", *listed(texts, INDENT), "};"])


def call(head: str, arguments: Sequence[str], tail: str, indent: str = "") -> str:
    """A call or a prototype, broken between its arguments if it is too long."""
    line = f"{indent}{head}({', '.join(arguments)}){tail}"
    if len(line) < WIDTH:  # a prototype's semicolon is still to come
        return line
    pieces = [f"{argument}," for argument in arguments[:-1]] + [f"{arguments[-1]}){tail}"]
    return "\n".join([f"{indent}{head}(", *packed(pieces, f"{indent}    ")])


def paragraph(text: str, indent: str) -> str:
    """Prose in several lines, the first one without indentation."""
    return "\n".join(
        textwrap.wrap(text, WIDTH - len(indent), break_long_words=False, break_on_hyphens=False)
    ).replace("\n", f"\n{indent}")
