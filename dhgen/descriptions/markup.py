"""XML to a tree of elements with their places; what could harm is refused, with its place.

By expat alone: no entity is defined, so none expands; nothing is fetched. Namespaces are not looked
at, so a prefix that nobody declared is a part of a name, as the tools that wrote it meant.
"""

from __future__ import annotations

import codecs
import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING
from xml.parsers import expat

from dhgen.errors import Diagnostic, RobotFileError
from dhgen.robot.source import SourceText, Span

if TYPE_CHECKING:
    from collections.abc import Mapping

UTF_16 = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
HEAD = 200  # bytes in which a file names its encoding
MAX_BYTES = (
    4 << 20
)  # descriptions name meshes and do not hold them: of 1200 the longest has 0.2 MiB
MAX_DEPTH = 64  # of elements in each other: URDF needs 5
MAX_ELEMENTS = 20_000  # of 1200 real files the longest has 3900


# A declaration after blank lines, which XML forbids and most readers bear.
_LATE_DECLARATION = re.compile(rb"\A\s+<\?xml[^>]*>")


def _is_unicode(content: bytes) -> bool:
    if content.startswith(UTF_16):
        return True
    try:
        content.decode("utf-8")
    except UnicodeDecodeError:
        return False
    return True


def _blank(found: re.Match[bytes]) -> bytes:
    return bytes(byte if byte in b"\r\n" else 32 for byte in found.group())


@dataclass(frozen=True, slots=True)
class Element:
    """An element, its attributes and the elements in it.

    Attributes:
        tag: Its name, prefix included.
        attributes: Values by name.
        place: The place of its start tag.
        children: The elements in it.
    """

    tag: str
    attributes: Mapping[str, str]
    place: Span
    children: list[Element] = field(default_factory=list)

    def all(self, tag: str) -> list[Element]:
        """The elements of a name directly in this one."""
        return [child for child in self.children if child.tag == tag]


def read_xml(content: bytes, file: str) -> tuple[Element, SourceText]:
    """The root element of a file.

    Args:
        content: The file's bytes.
        file: What remarks call it.

    Raises:
        RobotFileError: It is not XML, or holds what a robot description never needs.
    """
    if len(content) > MAX_BYTES:
        last = content[:MAX_BYTES].count(b"\n") + 1
        message = f"the file is too long: a robot description has at most {MAX_BYTES >> 20} MiB"
        raise RobotFileError((Diagnostic(file, last, 1, message),))
    reader = _Reader(content, file)
    return reader.read(), reader.source


class _Reader:
    def __init__(self, content: bytes, file: str) -> None:
        if b"encoding" not in content[:HEAD] and not _is_unicode(content):
            content = content.decode("latin-1").encode()  # an umlaut in a comment
        encoding = "utf-16" if content.startswith(UTF_16) else "utf-8"
        text = content.decode(encoding, "replace").removeprefix("\ufeff")
        self.content = _LATE_DECLARATION.sub(_blank, content, count=1)
        self.source = SourceText.of(text, file)
        self.count = 0
        self.open: list[Element] = []
        self.root: Element | None = None
        self.parser = expat.ParserCreate()
        self.parser.StartElementHandler = self._start
        self.parser.EndElementHandler = self._end
        self.parser.StartDoctypeDeclHandler = self._doctype

    def read(self) -> Element:
        try:
            self.parser.Parse(self.content, True)  # noqa: FBT003 - it is the last part
        except expat.ExpatError as error:
            reason = expat.errors.messages[error.code]
            place = self._place(error.lineno, error.offset)
            raise self.source.refused(place, f"this is not well-formed XML: {reason}") from None
        except (ValueError, LookupError) as error:  # an encoding that Python lacks
            raise self.source.refused(Span(0), f"this is not readable XML: {error}") from None
        assert self.root is not None
        return self.root

    def _place(self, line: int, column: int) -> Span:
        starts = self.source.starts
        return Span(starts[min(line, len(starts)) - 1] + column)

    def _here(self) -> Span:
        return self._place(self.parser.CurrentLineNumber, self.parser.CurrentColumnNumber)

    def _start(self, tag: str, attributes: dict[str, str]) -> None:
        if len(self.open) >= MAX_DEPTH:
            message = f"elements are nested too deeply: at most {MAX_DEPTH} are inside each other"
            raise self.source.refused(self._here(), message)
        self.count += 1
        if self.count > MAX_ELEMENTS:
            message = f"there are too many elements: a robot description has at most {MAX_ELEMENTS}"
            raise self.source.refused(self._here(), message)
        place = self._here()
        element = Element(tag, attributes, Span(place.start, len(tag) + 1))
        if self.open:
            self.open[-1].children.append(element)
        else:
            self.root = element
        self.open.append(element)

    def _end(self, _: str) -> None:
        self.open.pop()

    def _doctype(self, *_: object) -> None:
        message = "a robot description has no DOCTYPE: entities are not read, remove it"
        raise self.source.refused(self._here(), message)
