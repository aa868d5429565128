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
    """Pieces that must stay whole, as many on a line as fit."""
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


def python_array(head: str, entries: Iterable[str]) -> str:
    """A call with a list, e.g. `x = np.array([1.0])` with the head `x = np.array`."""
    texts = list(entries)
    line = f"{head}([{', '.join(texts)}])"
    return line if len(line) <= WIDTH else "\n".join([f"{head}([", *listed(texts, INDENT), "])"])


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


def fitted(source: str) -> str:
    """C whose long names have made some lines too long for a page."""
    lines: list[str] = []
    in_comment = False  # a line of a product may begin with a star, too
    for line in source.split("\n"):
        if len(line) <= WIDTH or line.startswith("#"):
            lines.append(line)
        elif lines and lines[-1].endswith(GOES_ON):
            lines += _going_on(line)
        else:
            lines += _broken(line, in_comment=in_comment)
        opened, closed = line.rfind("/*"), line.rfind("*/")
        in_comment = in_comment if opened == closed else opened > closed
    return "\n".join(lines)


def _going_on(line: str) -> list[str]:
    """A line of a directive, which ends where no backslash says that it goes on."""
    text = line.removesuffix(GOES_ON)
    indent = line[: len(line) - len(line.lstrip())]
    pieces = wrapped(text, indent, width=WIDTH - len(GOES_ON))
    return [*(piece + GOES_ON for piece in pieces[:-1]), pieces[-1] + line[len(text) :]]


def _broken(line: str, *, in_comment: bool) -> list[str]:
    text = line.lstrip()
    indent = line[: len(line) - len(text)]
    if in_comment:
        return wrapped(line, indent, "* ")
    return wrapped(line, indent, " * " if text.startswith("/* ") else INDENT)
