"""Lists without their square brackets: `limits: (-1, 1)` holds a text, or a text and a key."""

from __future__ import annotations

import itertools
import re
from typing import TYPE_CHECKING, TypeAlias

from ruamel.yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from dhgen.robot.nodes import is_null, piece
from dhgen.robot.source import Span, shortened

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.errors import Diagnostic
    from dhgen.robot.source import SourceText

Entry: TypeAlias = tuple[Node, Node]

_LIST_KEYS = (
    *("limits", "direction", "point", "free"),
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
        mistakes: Gets what is told of such lists.
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
    """What stands between braces, if that is a list and no keys with values."""
    if isinstance(node, MappingNode) and all(map(_is_bare, node.value)):
        return [key for key, _ in node.value]
    return []


def _items(texts: Sequence[ScalarNode]) -> list[ScalarNode]:
    """What stands between the commas of a list, without other brackets around it."""
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
