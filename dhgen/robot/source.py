"""The text of a robot file, and remarks that point into it."""

from __future__ import annotations

import bisect
import re
from dataclasses import dataclass

from dhgen.errors import Diagnostic, RobotFileError

_LINE_END = re.compile(r"\r\n|\r|\n")
_LONGEST_SHOWN = 120


@dataclass(frozen=True, slots=True)
class Span:
    """A place in a text: where it starts (from 0), and how many characters it covers."""

    start: int
    width: int = 1


@dataclass(frozen=True, slots=True)
class SourceText:
    """A file's text with its lines.

    Attributes:
        file: The path as the user gave it.
        text: All of it.
        lines: Its lines without their ends.
        starts: Where each line starts in the text.
    """

    file: str
    text: str
    lines: tuple[str, ...]
    starts: tuple[int, ...]

    @classmethod
    def of(cls, text: str, file: str) -> SourceText:
        """Split a text into its lines, at YAML's line ends."""
        ends = list(_LINE_END.finditer(text))
        starts = (0, *(end.end() for end in ends))
        stops = (*(end.start() for end in ends), len(text))
        lines = tuple(text[start:stop] for start, stop in zip(starts, stops, strict=True))
        return cls(file, text, lines, starts)

    def number(self, span: Span) -> int:
        """The line of a place, from 0."""
        return bisect.bisect_right(self.starts, max(span.start, 0)) - 1

    def point(self, span: Span, message: str) -> Diagnostic:
        """A remark with the line of the place and a caret under it."""
        start = min(max(span.start, 0), len(self.text))
        number = self.number(span)
        line = self.lines[number]
        column = min(start - self.starts[number], len(line))
        # A line that fills the screen hides the caret; the position alone is clearer then.
        shown = _printable(line[:_LONGEST_SHOWN]) if column < _LONGEST_SHOWN else ""
        width = max(1, min(span.width, len(shown) - column))
        return Diagnostic(self.file, number + 1, column + 1, message, shown, width)

    def refused(self, span: Span, message: str) -> RobotFileError:
        """What is raised for the whole text, with the place that shows why."""
        return RobotFileError((self.point(span, message),))


def quoted(text: str) -> str:
    """A piece of the user's text for a message: in quotes, printable, and not endless."""
    shown = shortened(text)
    mark = '"' if "'" in shown else "'"
    return f"{mark}{shown}{mark}"


def shortened(text: str) -> str:
    """A piece of the user's text for a message: printable, and not endless."""
    return _printable(text if len(text) <= 40 else text[:37] + "...")


def _printable(text: str) -> str:
    # One character for one, so that the caret is in place; a tab would move it.
    shown = (" " if c == "\t" else c if c.isprintable() else "�" for c in text)
    return "".join(shown).rstrip()
