"""C that fits on a page, however long the names are that came into its lines."""

from __future__ import annotations

import textwrap

from dhgen.targets.layout import GOES_ON, WIDTH, wrapped

END = " */"
STAR = " * "
_GLUE = "\u00a0"  # keeps the end of a comment with its last word: no text is broken there


def fitted(source: str) -> str:
    """A source whose long names have made some lines too long for a page."""
    lines: list[str] = []
    pending = source.split("\n")
    while pending:
        size = _comment(pending)
        if size:
            lines += _refilled(pending[:size])
        else:
            lines += _fitting(pending[0], inside=bool(lines) and lines[-1].endswith(GOES_ON))
        pending = pending[size or 1 :]
    return "\n".join(lines)


def _comment(lines: list[str]) -> int:
    """How many lines a comment has that begins a line and has several; else 0."""
    if not lines[0].lstrip().startswith("/*"):
        return 0
    ends = (k for k, line in enumerate(lines) if "*/" in line)
    size = next(ends, 0) + 1
    return size if size > 1 and not any(line.endswith(GOES_ON) for line in lines[:size]) else 0


def _refilled(lines: list[str]) -> list[str]:
    """A comment whose paragraphs are filled anew where a line of theirs is too long."""
    indent = lines[0][: len(lines[0]) - len(lines[0].lstrip())]
    filled: list[str] = []
    paragraph: list[str] = []
    for line in [*lines, ""]:
        if paragraph and line.strip(" */") == "":
            filled += _filled(paragraph, indent)
            paragraph = []
        if line.strip(" */") != "":
            paragraph.append(line)
        elif line:
            filled.append(line)
    return filled


def _filled(paragraph: list[str], indent: str) -> list[str]:
    if max(map(len, paragraph)) <= WIDTH:
        return paragraph
    first = indent + ("/* " if paragraph[0].lstrip().startswith("/*") else STAR)
    words = " ".join(line.strip().removeprefix("/").removeprefix("* ") for line in paragraph)
    return _wrapped(words.replace(END, _GLUE + END.strip()), first, indent + STAR)


def _wrapped(text: str, first: str, others: str) -> list[str]:
    lines = textwrap.wrap(
        text,
        WIDTH,
        initial_indent=first,
        subsequent_indent=others,
        break_long_words=False,
        break_on_hyphens=False,
    )
    return [line.replace(_GLUE, " ") for line in lines]


def _fitting(line: str, *, inside: bool) -> list[str]:
    """A line of code or a comment in one line; inside a directive, which goes on, or not."""
    text = line.lstrip()
    indent = line[: len(line) - len(text)]
    if len(line) <= WIDTH or line.startswith("#"):
        return [line]
    if inside:
        return _going_on(line, indent)
    if text.startswith("/*") and text.endswith("*/"):
        words = text.removeprefix("/*").strip().replace(END, _GLUE + END.strip())
        return _wrapped(words, f"{indent}/* ", indent + STAR)
    return wrapped(line, indent)


def _going_on(line: str, indent: str) -> list[str]:
    """A line of a directive, which ends where no backslash continues it."""
    text = line.removesuffix(GOES_ON)
    pieces = wrapped(text, indent, width=WIDTH - len(GOES_ON))
    return [*(piece + GOES_ON for piece in pieces[:-1]), pieces[-1] + line[len(text) :]]
