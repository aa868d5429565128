"""The message for a text that is no YAML: where, why, and what was probably meant."""

from __future__ import annotations

import itertools
import re
from typing import TYPE_CHECKING, cast

from ruamel.yaml.error import MarkedYAMLError, YAMLError

from dhgen.errors import Diagnostic, RobotFileError
from dhgen.robot.source import SourceText, Span, quoted

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from ruamel.yaml.error import StreamMark

MOST_GLUED = 100  # keys without a blank

_KEY = r"([A-Za-z_]\w*):(?=[^\s:,\]}])(?!//)"
_GLUED = re.compile(rf"{_KEY}(.+)", re.ASCII | re.DOTALL)
_GLUED_IN_LINE = re.compile(rf"(^ *(?:- +)*|[{{,] *){_KEY}", re.ASCII)
_COLLECTION = re.compile(r"\[[^\]]*\]|\{[^}]*\}")


def syntax_errors(
    source: SourceText, error: MarkedYAMLError, read: Callable[[SourceText], None]
) -> tuple[Diagnostic, ...]:
    """The message for the place where YAML stops, or for keys that are the reason.

    Args:
        source: The text.
        error: Why YAML stops.
        read: Reads a text as YAML, up to its first mistake.
    """
    if mistakes := _without_blank(source, error, read):
        return mistakes
    mark = _mark(error)
    context = f" {error.context}" if error.context else ""
    place = Span(min(mark.index, len(source.text.rstrip())) if mark else 0)
    problem = error.problem or "unreadable"
    hint = _tabs(source, place) or _second_colon(source, place, problem)
    message = f"not valid YAML: {problem}{context}{hint}"
    return (source.point(place, " ".join(message.split())),)


def split_glued(text: str) -> tuple[str, str] | None:
    """A key and its value out of one text, for want of a blank after the colon; None else."""
    found = _GLUED.fullmatch(text)
    return (found[1], found[2]) if found else None


def blank_message(key: str, value: str) -> str:
    """The message for a key whose value follows without a blank."""
    meant, written = f"{key}: {value}", f"{key}:{value}"
    return f"a space must follow the colon: {quoted(meant)}, not {quoted(written)}"


def missing_blank(text: str) -> str | None:
    """The message for a text in the place of one key with its value."""
    halves = split_glued(text)
    return blank_message(*halves) if halves and "," not in text else None


def _without_blank(
    source: SourceText, error: MarkedYAMLError, read: Callable[[SourceText], None]
) -> tuple[Diagnostic, ...]:
    """Keys whose values follow without a blank, if YAML gets further with the blanks."""
    mark = _mark(error)
    glued = list(itertools.islice(_glued_keys(source), MOST_GLUED))
    before = sum(span.start + span.width <= mark.index for span, _ in glued) if mark else 0
    if not mark or not before:
        return ()
    cuts = [0, *(span.start + span.width for span, _ in glued), len(source.text)]
    mended = " ".join(source.text[start:stop] for start, stop in itertools.pairwise(cuts))
    try:
        read(SourceText.of(mended, source.file))
    except MarkedYAMLError as other:
        further = _mark(other)
        if further is None or further.index <= mark.index + before:
            return ()
    except (YAMLError, ValueError, OverflowError):
        return ()
    except RobotFileError:
        pass  # YAML it is; what else is wrong is reported without these
    return tuple(source.point(span, message) for span, message in glued)


def _glued_keys(source: SourceText) -> Iterator[tuple[Span, str]]:
    """The place of a key whose colon is followed by no blank, and the message for it."""
    for start, line in zip(source.starts, source.lines, strict=True):
        for found in _GLUED_IN_LINE.finditer(line):
            place, key = found.start(2), found[2]
            if not _is_text(line[:place]):
                value = _value(line[found.end() :], alone=not found[1].strip(" -"))
                yield Span(start + place, len(key) + 1), blank_message(key, value)


def _is_text(before: str) -> bool:
    """Whether what follows in a line is in a comment or in quotes."""
    comment = re.search(r"(?:^|\s)#", before)
    return bool(comment) or before.count('"') % 2 == 1 or before.count("'") % 2 == 1


def _value(rest: str, *, alone: bool) -> str:
    """The value at the beginning of the rest of a line, which may be alone there."""
    if found := _COLLECTION.match(rest):
        return found[0]
    return re.split(r"\s#" if alone else r"[,}\]]", rest)[0].rstrip(" ,")


def _mark(error: MarkedYAMLError) -> StreamMark | None:
    return cast("StreamMark | None", error.problem_mark or error.context_mark)


def _tabs(source: SourceText, place: Span) -> str:
    """The end of a message about a line that begins with a tab, which nobody sees."""
    line = source.lines[source.number(place)]
    indent = line[: len(line) - len(line.lstrip())]
    return "; YAML indents with spaces, not tabs" if "\t" in indent else ""


def _second_colon(source: SourceText, place: Span, problem: str) -> str:
    """The end of a message about a second colon in a line, where YAML expects none."""
    number = source.number(place)
    before = source.lines[number][: place.start - source.starts[number]]
    if not problem.startswith("mapping values") or ":" not in before:
        return ""
    if re.match(r"(title|source)\s*:", before):
        return "; put a text with a colon in quotes"
    return "; put several keys on one line in braces, e.g. {theta: q, d: 0}"
