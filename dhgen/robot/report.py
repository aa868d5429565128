"""The remarks on one robot file, collected while it is read."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ruamel.yaml.nodes import ScalarNode

from dhgen.robot.nodes import span_of
from dhgen.robot.source import Span

if TYPE_CHECKING:
    from ruamel.yaml.nodes import Node

    from dhgen.errors import Diagnostic
    from dhgen.robot.reader import Document, Path


class Report:
    """Errors and notices, each at a path of the file; both come out in the file's order."""

    def __init__(self, document: Document) -> None:
        self.document = document
        self._errors = list(document.mistakes)
        self._notices: list[Diagnostic] = []
        self.doubts: list[Diagnostic] = []

    @property
    def errors(self) -> tuple[Diagnostic, ...]:
        """What makes the file unusable, without repetitions."""
        return tuple(sorted(dict.fromkeys(self._errors), key=_position))

    @property
    def notices(self) -> tuple[Diagnostic, ...]:
        """What was snapped, looks like a slip, or is of no use."""
        return tuple(sorted(dict.fromkeys(self._notices), key=_position))

    def error(self, path: Path, message: str, *, part: Span | None = None) -> None:
        """Something wrong with the value at a path, or with a part of a cell."""
        self._errors.append(self._point(self.document.find(path)[1], message, part))

    def error_at_key(self, path: Path, message: str) -> None:
        """Something wrong with a key, rather than with its value."""
        key, value = self.document.find(path)
        self._errors.append(self._point(value if key is None else key, message, None))

    def notice(self, path: Path, message: str) -> None:
        """Something that the user is told; the file is used all the same."""
        self._notices.append(self._point(self.document.find(path)[1], message, None))

    def doubt(self, path: Path, message: str) -> None:
        """Something that the user is told only if the arm's solvers do not pass."""
        self.doubts.append(self._point(self.document.find(path)[1], message, None))

    def notice_at_key(self, path: Path, message: str) -> None:
        """Something that the user is told of a key."""
        key, value = self.document.find(path)
        self._notices.append(self._point(value if key is None else key, message, None))

    def _point(self, node: Node, message: str, part: Span | None) -> Diagnostic:
        span = span_of(node)
        text = self.document.source.text
        if part is not None and isinstance(node, ScalarNode):
            # Quotes shift a cell by one; folded or escaped text stands nowhere in the file.
            for start in (span.start, span.start + 1):
                if text.startswith(node.value, start):
                    span = Span(start + part.start, part.width)
                    break
        return self.document.source.point(span, message)


def _position(diagnostic: Diagnostic) -> tuple[int, int]:
    return diagnostic.line, diagnostic.column
