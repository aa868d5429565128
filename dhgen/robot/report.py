"""The remarks on one robot file, collected while it is read."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ruamel.yaml.nodes import ScalarNode

from dhgen.robot.nodes import span_of
from dhgen.robot.source import Span

if TYPE_CHECKING:
    from collections.abc import Iterable

    from ruamel.yaml.nodes import Node

    from dhgen.errors import Diagnostic
    from dhgen.robot.reader import Document, Path


ROWS = (("joints",), ("axes",))
LEGS = "legs"  # of a parallel robot: each holds a table of its own


def within_leg(path: Path) -> Path:
    """A place in a leg as if the leg were a file; any other place as it is."""
    return path[2:] if path[:1] == (LEGS,) and len(path) > 2 else path


class Report:
    """Errors and notices, each at a path of the file; both come out in the file's order."""

    def __init__(self, document: Document) -> None:
        self.document = document
        self._errors = list(document.mistakes)
        self._notices: list[tuple[Path, Diagnostic]] = []
        self._wrong: set[Path] = set()
        self.doubts: list[Diagnostic] = []

    @property
    def errors(self) -> tuple[Diagnostic, ...]:
        """What makes the file unusable, without repetitions."""
        return _in_order(self._errors)

    @property
    def notices(self) -> tuple[Diagnostic, ...]:
        """What was snapped, looks like a slip, or is of no use."""
        return _in_order(notice for _, notice in self._notices)

    @property
    def notes_on_errors(self) -> tuple[Diagnostic, ...]:
        """The notices about values of keys that are wrong: they may be why."""
        return _in_order(notice for path, notice in self._notices if _field(path) in self._wrong)

    def error(self, path: Path, message: str, *, part: Span | None = None) -> None:
        """Something wrong with the value at a path, or with a part of a cell."""
        self._errors.append(self._point(self.document.find(path)[1], message, part))
        within = within_leg(path)
        if len(within) > 2 or within[:1] not in ROWS:  # a whole row holds many values
            self._wrong.add(_field(path))

    def error_at_key(self, path: Path, message: str) -> None:
        """Something wrong with a key, rather than with its value."""
        key, value = self.document.find(path)
        self._errors.append(self._point(value if key is None else key, message, None))

    def notice(self, path: Path, message: str) -> None:
        """Adds a notice; the file is used nevertheless."""
        self._notices.append((path, self._point(self.document.find(path)[1], message, None)))

    def doubt(self, path: Path, message: str) -> None:
        """Adds a doubt: a notice that is shown only if the arm's solvers do not pass."""
        self.doubts.append(self._point(self.document.find(path)[1], message, None))

    def notice_at_key(self, path: Path, message: str) -> None:
        """Adds a mistake about a key."""
        key, value = self.document.find(path)
        node = value if key is None else key
        self._notices.append((path, self._point(node, message, None)))

    def _point(self, node: Node, message: str, part: Span | None) -> Diagnostic:
        span = span_of(node)
        text = self.document.source.text
        if part is not None and isinstance(node, ScalarNode):
            # Quotes shift a cell by one; folded or escaped text is nowhere in the file.
            for start in (span.start, span.start + 1):
                if text.startswith(node.value, start):
                    span = Span(start + part.start, part.width)
                    break
        return self.document.source.point(span, message)


def _field(path: Path) -> Path:
    """The key that a value belongs to, which may be one of a list."""
    keys = [i for i, step in enumerate(path) if isinstance(step, str)]
    return path[: keys[-1] + 1] if keys else path


def _in_order(remarks: Iterable[Diagnostic]) -> tuple[Diagnostic, ...]:
    return tuple(sorted(dict.fromkeys(remarks), key=_position))


def _position(diagnostic: Diagnostic) -> tuple[int, int]:
    return diagnostic.line, diagnostic.column
