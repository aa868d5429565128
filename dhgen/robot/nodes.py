"""Nodes of YAML: their places, keys and values of mappings, lists without their brackets."""

from __future__ import annotations

import copy
import itertools
import re
from typing import TYPE_CHECKING, TypeAlias

from ruamel.yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from dhgen.robot.source import Span, quoted, shortened
from dhgen.robot.syntax import blank_message, split_glued

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.errors import Diagnostic
    from dhgen.robot.source import SourceText


_NULL = "tag:yaml.org,2002:null"


def span_of(node: Node) -> Span:
    """The place of a node in the text."""
    start, end = node.start_mark.index, node.end_mark.index
    return Span(start, max(1, end - start) if isinstance(node, ScalarNode) else 1)


def is_null(node: Node) -> bool:
    """Whether a node is nothing: empty, ~ or null."""
    return isinstance(node, ScalarNode) and node.tag == _NULL and node.style is None


def piece(node: ScalarNode, start: int, text: str) -> ScalarNode:
    """A part of a text, with its place, as a node."""
    begin, end = copy.copy(node.start_mark), copy.copy(node.end_mark)
    begin.index += start + (node.style is not None)  # quotes shift it by one
    end.index = begin.index + len(text)
    return ScalarNode(node.tag, text, begin, end)


Entry: TypeAlias = tuple[Node, Node]

_LIST_KEYS = (
    *("limits", "direction", "point", "free", "steps", "actuated", "turned"),
    *("xyz", "rpy", "quaternion_xyzw", "quaternion_wxyz"),
)
_BRACKETS = {"(": ")", "[": "]", "{": "}"}
_LIST = "tag:yaml.org,2002:seq"


def in_brackets(
    source: SourceText, entries: Sequence[Entry], mistakes: list[Diagnostic]
) -> Iterator[Entry]:
    """Keys and values of a mapping, where lists without square brackets are lists.

    Args:
        source: The text.
        entries: As YAML has them.
        mistakes: Gets the mistakes of such lists.
    """
    pending = list(reversed(entries))
    while pending:
        key, value = pending.pop()
        if isinstance(key, ScalarNode) and key.value in _LIST_KEYS:
            keys = list(itertools.takewhile(_is_bare, reversed(pending)))
            texts = [value, *(name for name, _ in keys)] if _is_text(value) else _members(value)
            items = _items([text for text in texts if isinstance(text, ScalarNode)])
            if len(items) > 1:
                del pending[len(pending) - len(keys) :]
                start, end = texts[0].start_mark, texts[-1].end_mark
                message = _message(key.value, value, items)
                mistakes.append(source.point(Span(start.index, end.index - start.index), message))
                value = SequenceNode(_LIST, items, start, end)
        yield key, value


def _message(key: str, value: Node, items: Sequence[ScalarNode]) -> str:
    written = shortened(", ".join(item.value for item in items))
    quotes = ", without quotes" if isinstance(value, ScalarNode) and value.style else ""
    return f"'{key}' takes a list in square brackets{quotes}: [{written}]"


def _is_bare(entry: Entry) -> bool:
    """Whether a key is no more than a text between commas."""
    key, value = entry
    return (
        isinstance(key, ScalarNode)
        and key.style is None
        and is_null(value)
        and ":" not in key.value
    )


def _is_text(node: Node) -> bool:
    return isinstance(node, ScalarNode) and not is_null(node)


def _members(node: Node) -> list[Node]:
    """The text between braces, if that is a list and no keys with values."""
    if isinstance(node, MappingNode) and all(map(_is_bare, node.value)):
        return [key for key, _ in node.value]
    return []


def _items(texts: Sequence[ScalarNode]) -> list[ScalarNode]:
    """The texts between the commas of a list, without other brackets around it."""
    items = [
        piece(text, found.start(), found[0].rstrip())
        for text in texts
        for found in re.finditer(r"[^,\s][^,]*", text.value)
    ]
    if len(items) < 2:
        return items
    first, last = items[0], items[-1]
    opening = first.value[0]
    closing = _BRACKETS.get(opening, "\0")
    if last.value.endswith(closing) and first.value.count(opening) > first.value.count(closing):
        within = first.value[1:].lstrip()
        items[0] = piece(first, len(first.value) - len(within), within)
        items[-1] = piece(last, 0, last.value[:-1].rstrip())
    return [item for item in items if item.value]


Pairs = dict[str, tuple[ScalarNode, Node]]


def index_pairs(source: SourceText, root: Node) -> tuple[dict[int, Pairs], list[Diagnostic]]:
    """Keys and values of every mapping by its id, and the mistakes of keys that can't be."""
    pairs: dict[int, Pairs] = {}
    mistakes: list[Diagnostic] = []
    pending: list[Node] = [root]
    while pending:
        node = pending.pop()
        if isinstance(node, SequenceNode):
            pending.extend(node.value)
        if not isinstance(node, MappingNode):
            continue
        known = pairs[id(node)] = {}
        before = ""
        for key, value in in_brackets(source, node.value, mistakes):
            pending.append(value)
            if not isinstance(key, ScalarNode):
                mistakes.append(source.point(span_of(key), "a key is a name, not a collection"))
            elif key.value[:1].isdecimal() and is_null(value):  # {a: 0,4} is a pair and a key
                written = before if before[-1:].isdecimal() else ""
                message = f"write a decimal point: {written}.{key.value}, not {written},{key.value}"
                mistakes.append(source.point(span_of(key), message))
            else:
                _add(known, *_apart(source, key, value, mistakes), source, mistakes)
            before = value.value if isinstance(value, ScalarNode) else ""
    return pairs, mistakes


def _add(
    known: Pairs, key: ScalarNode, value: Node, source: SourceText, mistakes: list[Diagnostic]
) -> None:
    if key.value in known:
        line = known[key.value][0].start_mark.line + 1
        message = f"duplicate key {quoted(key.value)}: line {line} has it too"
        mistakes.append(source.point(span_of(key), message))
    else:
        known[key.value] = (key, value)


def _apart(
    source: SourceText, key: ScalarNode, value: Node, mistakes: list[Diagnostic]
) -> tuple[ScalarNode, Node]:
    """A key and its value; {a:1} is a key without one, which is a mistake."""
    halves = split_glued(key.value)
    if halves is None or key.style is not None or not is_null(value):
        return key, value
    mistakes.append(source.point(span_of(key), blank_message(*halves)))
    return piece(key, 0, halves[0]), piece(key, len(halves[0]) + 1, halves[1])
