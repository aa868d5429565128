"""Keys and values of a robot file's mappings, and the keys that can't be."""

from __future__ import annotations

import copy
from typing import TYPE_CHECKING

from ruamel.yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from dhgen.robot.source import Span, quoted
from dhgen.robot.syntax import blank_message, split_glued

if TYPE_CHECKING:
    from dhgen.errors import Diagnostic
    from dhgen.robot.source import SourceText

Pairs = dict[str, tuple[ScalarNode, Node]]

_NULL = "tag:yaml.org,2002:null"


def index_pairs(source: SourceText, root: Node) -> tuple[dict[int, Pairs], list[Diagnostic]]:
    """Keys and values of every mapping by its id, and what is told of keys that can't be."""
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
        for key, value in node.value:
            pending.append(value)
            if not isinstance(key, ScalarNode):
                mistakes.append(source.point(span_of(key), "a key is a name, not a collection"))
            elif _is_behind_comma(key.value) and is_null(value):  # {a: 0,4} is a pair and a key
                message = f"a decimal comma has to be a point: .{key.value}, not ,{key.value}"
                mistakes.append(source.point(span_of(key), message))
            else:
                _add(known, *_apart(source, key, value, mistakes), source, mistakes)
    return pairs, mistakes


def span_of(node: Node) -> Span:
    """Where a node stands in the text."""
    start, end = node.start_mark.index, node.end_mark.index
    return Span(start, max(1, end - start) if isinstance(node, ScalarNode) else 1)


def is_null(node: Node) -> bool:
    """Whether a node is nothing: empty, ~ or null."""
    return isinstance(node, ScalarNode) and node.tag == _NULL and node.style is None


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
    """A key and its value; {a:1} is a key without one, and is told what is missing."""
    halves = split_glued(key.value)
    if halves is None or key.style is not None or not is_null(value):
        return key, value
    mistakes.append(source.point(span_of(key), blank_message(*halves)))
    return _piece(key, 0, halves[0]), _piece(key, len(halves[0]) + 1, halves[1])


def _piece(node: ScalarNode, start: int, text: str) -> ScalarNode:
    """A part of a text as a node, where it stands."""
    begin, end = copy.copy(node.start_mark), copy.copy(node.end_mark)
    begin.index += start
    end.index = begin.index + len(text)
    return ScalarNode(node.tag, text, begin, end)


def _is_behind_comma(key: str) -> bool:
    """Whether a key may be what stands behind a decimal comma, and no end of a tuple."""
    return key[:1].isdecimal() and key.count("(") == key.count(")")
