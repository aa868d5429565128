"""YAML text to nodes with positions; everything that a robot file has no use for is refused."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

from ruamel.yaml import YAML
from ruamel.yaml.error import MarkedYAMLError, YAMLError
from ruamel.yaml.events import (
    AliasEvent,
    CollectionEndEvent,
    CollectionStartEvent,
    DocumentStartEvent,
    ScalarEvent,
)
from ruamel.yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from dhgen.errors import Diagnostic, RobotFileError
from dhgen.robot.source import SourceText, Span, quoted

if TYPE_CHECKING:
    from ruamel.yaml.error import StreamMark
    from ruamel.yaml.events import Event

MAX_CHARACTERS = 256 * 1024
MAX_NODES = 8_000  # 64 joints with every cell and limit, 256 parameters and all frames: about 2 000
MAX_DEPTH = 12

Path = tuple[str | int, ...]

# All but tabs, line ends and what can be seen; bidirectional marks make a text read otherwise.
_FORBIDDEN = re.compile(
    "[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff\ufeff]"
)
_NULL = "tag:yaml.org,2002:null"


@dataclass(frozen=True, slots=True)
class Document:
    """A robot file as nodes.

    Attributes:
        source: Its text.
        root: Its outermost mapping.
        mistakes: What is wrong with it so far (a key given twice, a key that is no text).
    """

    source: SourceText
    root: MappingNode
    mistakes: tuple[Diagnostic, ...]

    def find(self, path: Path) -> tuple[ScalarNode | None, Node]:
        """The key (None for an element of a list) and the value at a path.

        A step that the file doesn't have is passed over: the nearest node around it is found.
        """
        key: ScalarNode | None = None
        node: Node = self.root
        for step in path:
            if isinstance(node, MappingNode):
                key, node = _pairs(node).get(str(step), (key, node))
            elif isinstance(node, SequenceNode) and isinstance(step, int):
                key, node = None, node.value[step]
        return key, node

    def has(self, path: Path) -> bool:
        """Whether the file has a value at a path of keys."""
        inner = self.plain(path[:-1])
        return not path or (path[-1] in inner if isinstance(inner, dict) else True)

    def plain(self, path: Path = ()) -> object:
        """The value at a path as dicts, lists, texts and None; of a repeated key the first."""
        return _plain(self.find(path)[1])


def read_document(text: str, file: str) -> Document:
    """Parse a robot file's YAML.

    Raises:
        RobotFileError: The text is no YAML, or uses what a robot file has no use for: anchors,
            tags, merge keys, several documents, deep nesting.
    """
    source = SourceText.of(text, file)
    _check_characters(source)
    try:
        _check_events(source)
        root = YAML(typ="safe", pure=True).compose(text)
    except MarkedYAMLError as error:
        raise RobotFileError((_syntax_error(source, error),)) from None
    except YAMLError as error:
        raise _whole(source, f"this is no YAML: {error}") from None
    if root is None:
        raise _whole(source, "the file is empty")
    if not isinstance(root, MappingNode):
        raise RobotFileError(
            (source.point(span_of(root), "expected keys with values, e.g. 'name: puma560'"),)
        )
    return Document(source, root, tuple(_key_mistakes(source, root)))


def span_of(node: Node) -> Span:
    """Where a node stands in the text."""
    start, end = node.start_mark.index, node.end_mark.index
    return Span(start, max(1, end - start) if isinstance(node, ScalarNode) else 1)


def _whole(source: SourceText, message: str) -> RobotFileError:
    return RobotFileError((Diagnostic(source.file, 0, 0, message),))


def _check_characters(source: SourceText) -> None:
    if len(source.text) > MAX_CHARACTERS:
        raise _whole(source, f"a robot file has at most {MAX_CHARACTERS} characters")
    found = _FORBIDDEN.search(source.text)
    if found:
        message = f"the character U+{ord(found[0]):04X} can't stand in a robot file"
        raise RobotFileError((source.point(Span(found.start()), message),))


def _check_events(source: SourceText) -> None:
    """Refuse what is hostile or useless before any node is built."""
    depth = documents = 0
    events: list[Event] = YAML(typ="safe", pure=True).parse(source.text)
    for count, event in enumerate(events):
        depth += isinstance(event, CollectionStartEvent) - isinstance(event, CollectionEndEvent)
        documents += isinstance(event, DocumentStartEvent)
        message = _refusal(event)
        if count > MAX_NODES:
            message = f"a robot file has at most {MAX_NODES} values"
        elif depth > MAX_DEPTH:
            message = f"nested more than {MAX_DEPTH} deep"
        elif documents > 1:
            message = "a robot file holds one document; give each robot its own file"
        if message:
            width = event.end_mark.index - event.start_mark.index
            raise RobotFileError((source.point(Span(event.start_mark.index, width), message),))


def _refusal(event: Event) -> str | None:
    """Why a robot file can't hold this, or None."""
    match event:
        case AliasEvent():
            what = f"aliases (*{event.anchor})"
        case DocumentStartEvent() if event.tags or event.version:
            what = "YAML directives (%)"
        case ScalarEvent() | CollectionStartEvent() if event.anchor:
            what = f"anchors (&{event.anchor})"
        case ScalarEvent() | CollectionStartEvent() if event.tag is not None:
            what = "tags (!)"
        case ScalarEvent(value="<<") if event.implicit[0]:
            what = "merge keys (<<)"
        case _:
            return None
    return f"{what} have no place in a robot file"


def _syntax_error(source: SourceText, error: MarkedYAMLError) -> Diagnostic:
    mark = cast("StreamMark | None", error.problem_mark or error.context_mark)
    context = f" {error.context}" if error.context else ""
    message = f"this is no YAML: {error.problem or 'unreadable'}{context}"
    return source.point(Span(mark.index if mark else 0), " ".join(message.split()))


def _key_mistakes(source: SourceText, root: Node) -> list[Diagnostic]:
    mistakes: list[Diagnostic] = []
    pending: list[Node] = [root]
    while pending:
        node = pending.pop()
        if isinstance(node, SequenceNode):
            pending.extend(node.value)
        if not isinstance(node, MappingNode):
            continue
        first: dict[str, int] = {}
        for key, value in node.value:
            pending.append(value)
            if not isinstance(key, ScalarNode):
                mistakes.append(source.point(span_of(key), "a key is a name, not a collection"))
            elif key.value in first:
                message = f"duplicate key {quoted(key.value)}: line {first[key.value]} has it too"
                mistakes.append(source.point(span_of(key), message))
            else:
                first[key.value] = key.start_mark.line + 1
    return mistakes


def _pairs(node: MappingNode) -> dict[str, tuple[ScalarNode, Node]]:
    """Keys and values by the text of the key; of a repeated key the first."""
    pairs: dict[str, tuple[ScalarNode, Node]] = {}
    for key, value in node.value:
        if isinstance(key, ScalarNode):
            pairs.setdefault(key.value, (key, value))
    return pairs


def _plain(node: Node) -> object:
    if isinstance(node, SequenceNode):
        return [_plain(item) for item in node.value]
    if isinstance(node, MappingNode):
        return {text: _plain(value) for text, (_, value) in _pairs(node).items()}
    scalar = cast("ScalarNode", node)
    return None if scalar.tag == _NULL and scalar.style is None else str(scalar.value)
