"""Nodes of YAML: where they stand, and parts of them."""

from __future__ import annotations

import copy

from ruamel.yaml.nodes import Node, ScalarNode

from dhgen.robot.source import Span

_NULL = "tag:yaml.org,2002:null"


def span_of(node: Node) -> Span:
    """Where a node stands in the text."""
    start, end = node.start_mark.index, node.end_mark.index
    return Span(start, max(1, end - start) if isinstance(node, ScalarNode) else 1)


def is_null(node: Node) -> bool:
    """Whether a node is nothing: empty, ~ or null."""
    return isinstance(node, ScalarNode) and node.tag == _NULL and node.style is None


def piece(node: ScalarNode, start: int, text: str) -> ScalarNode:
    """A part of a text, where it stands in it, as a node."""
    begin, end = copy.copy(node.start_mark), copy.copy(node.end_mark)
    begin.index += start + (node.style is not None)  # quotes shift it by one
    end.index = begin.index + len(text)
    return ScalarNode(node.tag, text, begin, end)
