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
    SequenceStartEvent,
)
from ruamel.yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from dhgen.errors import Diagnostic, RobotFileError, refused
from dhgen.robot.nodes import Pairs, index_pairs, is_null, span_of
from dhgen.robot.source import SourceText, Span, quoted
from dhgen.robot.syntax import missing_blank, syntax_errors

if TYPE_CHECKING:
    from ruamel.yaml.events import Event

MAX_BYTES = 128 * 1024
MAX_EVENTS = 5_000  # 64 joints with every cell and limit, 128 parameters, all frames: about 2 000
MAX_DEPTH = 12

Path = tuple[str | int, ...]

# All but tabs, line ends and what can be seen; bidirectional marks make a text read otherwise.
_FORBIDDEN = re.compile(
    "[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff\ufeff]"
)
_KEYS = "expected keys with values, e.g. 'name: puma560'"
_TABLE = (
    "this looks like a spreadsheet table, but a robot file is YAML: a line 'name: my_arm', a "
    "line 'joints:', and below it a line like '  - {theta: q, d: 0.1, a: 0.4, alpha: pi/2}' for "
    "every joint; the README has all keys"
)
_WRITE_OUT = "write the values out wherever they belong"
_LIST = (
    "a robot file holds keys with values, e.g. 'name: puma560', not a list; JSON lists of "
    "tables are for 'dhgen survey'"
)


@dataclass(frozen=True, slots=True)
class Document:
    """A robot file as nodes.

    Attributes:
        source: Its text.
        root: Its outermost mapping.
        pairs: Keys and values of every mapping, by the node's id; of a repeated key the first.
        mistakes: What is wrong with it so far (a key given twice, a key that is no text).
    """

    source: SourceText
    root: MappingNode
    pairs: dict[int, Pairs]
    mistakes: tuple[Diagnostic, ...]

    def find(self, path: Path) -> tuple[ScalarNode | None, Node]:
        """The key (None for an element of a list) and the value at a path.

        A step that the file doesn't have is passed over: the nearest node around it is found.
        """
        key: ScalarNode | None = None
        node: Node = self.root
        for step in path:
            if isinstance(node, MappingNode):
                key, node = self.pairs[id(node)].get(str(step), (key, node))
            elif isinstance(node, SequenceNode) and isinstance(step, int):
                key, node = None, node.value[step]
        return key, node

    def has(self, key: str, at: Path = ()) -> bool:
        """Whether there is a key at a path: on the outermost level, or in a part."""
        node = self.find(at)[1]
        return isinstance(node, MappingNode) and key in self.pairs[id(node)]

    def count(self, path: Path) -> int:
        """How many elements the list at a path has; none where there is something else."""
        node = self.find(path)[1]
        return len(node.value) if isinstance(node, SequenceNode) else 0

    def plain(self, path: Path = ()) -> object:
        """The value at a path as dicts, lists, texts and None."""
        return self._plain(self.find(path)[1])

    def _plain(self, node: Node) -> object:
        if isinstance(node, SequenceNode):
            return [self._plain(item) for item in node.value]
        if isinstance(node, MappingNode):
            pairs = self.pairs[id(node)]
            return {text: self._plain(value) for text, (_, value) in pairs.items()}
        scalar = cast("ScalarNode", node)
        return None if is_null(scalar) else str(scalar.value)


def read_document(source: SourceText) -> Document:
    """Parse a robot file's YAML.

    Raises:
        RobotFileError: The text is no YAML, or uses what a robot file has no use for: anchors,
            tags, merge keys, several documents, deep nesting.
    """
    text = source.text
    _check_characters(source)
    try:
        _check_events(source)
        root = YAML(typ="safe", pure=True).compose(text)
    except MarkedYAMLError as error:
        if _is_table(text):
            raise source.refused(Span(0), _TABLE) from None
        raise RobotFileError(syntax_errors(source, error, _check_events)) from None
    except YAMLError as error:
        raise refused(source.file, f"not valid YAML: {error}") from None
    except (ValueError, OverflowError):  # an escape like \\UFFFFFFFF, beyond Unicode
        raise refused(source.file, "not valid YAML: an escape stands for no character") from None
    if root is None or is_null(root):
        raise refused(source.file, "the file is empty")
    if not isinstance(root, MappingNode):
        message = _TABLE if _is_table(text) else missing_blank(str(root.value)) or _KEYS
        raise source.refused(span_of(root), message)
    pairs, mistakes = index_pairs(source, root)
    return Document(source, root, pairs, tuple(mistakes))


def _check_characters(source: SourceText) -> None:
    if len(source.text) > MAX_BYTES:
        raise refused(source.file, f"a robot file has at most {MAX_BYTES // 1024} KiB")
    found = _FORBIDDEN.search(source.text)
    if found:
        message = f"the character U+{ord(found[0]):04X} is not allowed in a robot file"
        raise source.refused(Span(found.start()), message)


def _check_events(source: SourceText) -> None:
    """Refuse what is hostile or useless before any node is built."""
    depth = documents = 0
    events: list[Event] = YAML(typ="safe", pure=True).parse(source.text)
    for count, event in enumerate(events):
        depth += isinstance(event, CollectionStartEvent) - isinstance(event, CollectionEndEvent)
        documents += isinstance(event, DocumentStartEvent)
        message = _why_not_allowed(event)
        if count > MAX_EVENTS:
            message = "more keys and values than any robot has"
        elif depth > MAX_DEPTH:
            message = f"nested more than {MAX_DEPTH} deep"
        elif documents > 1:
            message = "a robot file holds one document; give each robot its own file"
        elif depth == 1 and isinstance(event, SequenceStartEvent):
            message = _LIST
        if message:
            width = event.end_mark.index - event.start_mark.index
            raise source.refused(Span(event.start_mark.index, width), message)


def _why_not_allowed(event: Event) -> str | None:
    """Why a robot file can't hold this, or None."""
    match event:
        case AliasEvent():
            what, instead = f"aliases ({quoted('*' + event.anchor)})", _WRITE_OUT
        case DocumentStartEvent() if event.tags or event.version:
            what, instead = "YAML directives (%)", "leave them out"
        case ScalarEvent() | CollectionStartEvent() if event.anchor:
            what, instead = f"anchors ({quoted('&' + event.anchor)})", _WRITE_OUT
        case ScalarEvent() | CollectionStartEvent() if event.tag is not None:
            what, instead = "tags (!)", "leave them out"
        case ScalarEvent(value="<<") if event.implicit[0]:
            what, instead = "merge keys (<<)", _WRITE_OUT
        case _:
            return None
    return f"{what} are not allowed in a robot file: {instead}"


def _is_table(text: str) -> bool:
    """Whether a text looks like a spreadsheet's: the same separator in all of several lines."""
    lines = [line for line in text.splitlines() if line.strip()]
    return (
        ":" not in text
        and len(lines) > 1
        and any(all(mark in line for line in lines) for mark in ";\t,")
    )
