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

from dhgen.errors import Diagnostic, RobotFileError
from dhgen.robot.source import SourceText, Span, quoted

if TYPE_CHECKING:
    from ruamel.yaml.error import StreamMark
    from ruamel.yaml.events import Event

MAX_BYTES = 128 * 1024
MAX_EVENTS = 5_000  # 64 joints with every cell and limit, 128 parameters, all frames: about 2 000
MAX_DEPTH = 12

Path = tuple[str | int, ...]

# All but tabs, line ends and what can be seen; bidirectional marks make a text read otherwise.
_FORBIDDEN = re.compile(
    "[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u2028\u2029\u202a-\u202e\u2066-\u2069\ud800-\udfff\ufeff]"
)
_NULL = "tag:yaml.org,2002:null"
_LIST = (
    "a robot file holds keys with values, e.g. 'name: puma560', and not a list; lists of tables in "
    "JSON are for 'dhgen survey'"
)


_Pairs = dict[str, tuple[ScalarNode, Node]]


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
    pairs: dict[int, _Pairs]
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

    def has(self, key: str) -> bool:
        """Whether the file has a key of its outermost level."""
        return key in self.pairs[id(self.root)]

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
        return None if _is_null(scalar) else str(scalar.value)


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
    except (ValueError, OverflowError):  # an escape like \\UFFFFFFFF, beyond Unicode
        raise _whole(source, "this is no YAML: an escape names no character") from None
    if root is None or _is_null(root):
        raise _whole(source, "the file is empty")
    if not isinstance(root, MappingNode):
        raise RobotFileError(
            (source.point(span_of(root), "expected keys with values, e.g. 'name: puma560'"),)
        )
    pairs, mistakes = _index(source, root)
    return Document(source, root, pairs, tuple(mistakes))


def span_of(node: Node) -> Span:
    """Where a node stands in the text."""
    start, end = node.start_mark.index, node.end_mark.index
    return Span(start, max(1, end - start) if isinstance(node, ScalarNode) else 1)


def _whole(source: SourceText, message: str) -> RobotFileError:
    return RobotFileError((Diagnostic(source.file, 0, 0, message),))


def _check_characters(source: SourceText) -> None:
    if len(source.text) > MAX_BYTES:
        raise _whole(source, f"a robot file has at most {MAX_BYTES // 1024} KiB")
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
            raise RobotFileError((source.point(Span(event.start_mark.index, width), message),))


def _refusal(event: Event) -> str | None:
    """Why a robot file can't hold this, or None."""
    match event:
        case AliasEvent():
            what = f"aliases ({quoted('*' + event.anchor)})"
        case DocumentStartEvent() if event.tags or event.version:
            what = "YAML directives (%)"
        case ScalarEvent() | CollectionStartEvent() if event.anchor:
            what = f"anchors ({quoted('&' + event.anchor)})"
        case ScalarEvent() | CollectionStartEvent() if event.tag is not None:
            what = "tags (!)"
        case ScalarEvent(value="<<") if event.implicit[0]:
            what = "merge keys (<<)"
        case _:
            return None
    return f"{what} have no place in a robot file"


def _syntax_error(source: SourceText, error: MarkedYAMLError) -> Diagnostic:
    end = len(source.text.rstrip())
    mark = cast("StreamMark | None", error.problem_mark or error.context_mark)
    context = f" {error.context}" if error.context else ""
    place = Span(min(mark.index, end) if mark else 0)
    problem = error.problem or "unreadable"
    hint = _tabs(source, place) or _second_colon(source, place, problem)
    message = f"this is no YAML: {problem}{context}{hint}"
    return source.point(place, " ".join(message.split()))


def _tabs(source: SourceText, place: Span) -> str:
    """The end of a message about a line that begins with a tab, which nobody sees."""
    line = source.lines[source.number(place)]
    indent = line[: len(line) - len(line.lstrip())]
    return "; YAML wants spaces at the beginning of a line, not tabs" if "\t" in indent else ""


def _second_colon(source: SourceText, place: Span, problem: str) -> str:
    """The end of a message about a second colon in a line, where YAML expects none."""
    number = source.number(place)
    before = source.lines[number][: place.start - source.starts[number]]
    if not problem.startswith("mapping values") or ":" not in before:
        return ""
    if re.match(r"(title|source)\s*:", before):
        return "; a text with a colon stands in quotes"
    return "; several keys in one line stand in braces, e.g. {theta: q, d: 0}"


def _index(source: SourceText, root: Node) -> tuple[dict[int, _Pairs], list[Diagnostic]]:
    """Keys and values of every mapping, and the keys that can't be."""
    pairs: dict[int, _Pairs] = {}
    mistakes: list[Diagnostic] = []
    pending: list[Node] = [root]
    while pending:
        node = pending.pop()
        if isinstance(node, SequenceNode):
            pending.extend(node.value)
        if not isinstance(node, MappingNode):
            continue
        known = pairs[id(node)] = {}
        for key, value in node.value:
            pending.append(value)
            if not isinstance(key, ScalarNode):
                mistakes.append(source.point(span_of(key), "a key is a name, not a collection"))
            elif _is_behind_comma(key.value) and _is_null(value):  # {a: 0,4} is a pair and a key
                message = f"a decimal comma has to be a point: .{key.value}, not ,{key.value}"
                mistakes.append(source.point(span_of(key), message))
            elif key.value in known:
                line = known[key.value][0].start_mark.line + 1
                message = f"duplicate key {quoted(key.value)}: line {line} has it too"
                mistakes.append(source.point(span_of(key), message))
            else:
                known[key.value] = (key, value)
    return pairs, mistakes


def _is_behind_comma(key: str) -> bool:
    """Whether a key may be what stands behind a decimal comma, and no end of a tuple."""
    return key[:1].isdecimal() and key.count("(") == key.count(")")


def _is_null(node: Node) -> bool:
    return isinstance(node, ScalarNode) and node.tag == _NULL and node.style is None
