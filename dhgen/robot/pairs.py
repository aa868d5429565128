"""Keys and values of a robot file's mappings, and the keys that can't be."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ruamel.yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from dhgen.robot.brackets import in_brackets
from dhgen.robot.nodes import is_null, piece, span_of
from dhgen.robot.source import quoted
from dhgen.robot.syntax import blank_message, split_glued

if TYPE_CHECKING:
    from dhgen.errors import Diagnostic
    from dhgen.robot.source import SourceText

Pairs = dict[str, tuple[ScalarNode, Node]]


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
        for key, value in in_brackets(source, node.value, mistakes):
            pending.append(value)
            if not isinstance(key, ScalarNode):
                mistakes.append(source.point(span_of(key), "a key is a name, not a collection"))
            elif key.value[:1].isdecimal() and is_null(value):  # {a: 0,4} is a pair and a key
                message = f"write a decimal point: .{key.value}, not ,{key.value}"
                mistakes.append(source.point(span_of(key), message))
            else:
                _add(known, *_apart(source, key, value, mistakes), source, mistakes)
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
    """A key and its value; {a:1} is a key without one, and is told what is missing."""
    halves = split_glued(key.value)
    if halves is None or key.style is not None or not is_null(value):
        return key, value
    mistakes.append(source.point(span_of(key), blank_message(*halves)))
    return piece(key, 0, halves[0]), piece(key, len(halves[0]) + 1, halves[1])
