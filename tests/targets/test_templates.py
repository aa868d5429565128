"""Templates get finished strings: they loop and choose, they don't compute."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

import jinja2
import pytest
from jinja2 import nodes

from dhgen.targets.templates import render

if TYPE_CHECKING:
    from collections.abc import Iterator

TEMPLATES = Path(__file__).resolve().parents[2] / "templates"
ALL = sorted(str(path.relative_to(TEMPLATES)) for path in TEMPLATES.rglob("*.jinja"))
SHORT = tuple(name for name in ALL if "solver" in name)
WRITTEN = (nodes.Template, nodes.Output, nodes.TemplateData, nodes.Include)
CHOSEN = (nodes.For, nodes.If, nodes.Not, nodes.With)
NAMED = (nodes.Name, nodes.Getattr)


def faults(text: str) -> list[str]:
    """What a template has beside text, names, attributes, loops over them and choices by them."""
    parsed = jinja2.Environment(autoescape=True).parse(text)
    return [type(node).__name__ for node in _below(parsed) if not _allowed(node)]


def _below(node: nodes.Node) -> Iterator[nodes.Node]:
    """All nodes below one, without the paths of what is included."""
    for child in node.iter_child_nodes(exclude=("template",)):
        yield child
        yield from _below(child)


def _allowed(node: nodes.Node) -> bool:
    match node:
        case nodes.For():  # no counting, no conditions, no unpacking: items have names
            return node.test is None and isinstance(node.target, nodes.Name)
        case nodes.Not():
            return isinstance(node.node, NAMED)
        case nodes.With():  # another name for something
            return all(isinstance(value, NAMED) for value in node.values)
        case nodes.Name():
            return node.name != "loop"
        case _:
            return isinstance(node, (*WRITTEN, *CHOSEN, *NAMED))


@pytest.mark.parametrize("name", ALL)
def test_no_logic(name: str) -> None:
    assert faults((TEMPLATES / name).read_text(encoding="utf-8")) == []


@pytest.mark.parametrize(
    "text",
    [
        *("{{ a + 1 }}", "{{ a | join }}", "{{ a.b() }}", "{{ -a }}", "{{ a[1] }}", "{{ 1 }}"),
        *("{{ b if a else c }}", "{{ a ~ b }}", "{% set a = b %}", "{% with a = 1 %}{% endwith %}"),
        *("{% if a > 1 %}{% endif %}", "{% if a and b %}{% endif %}"),
        *("{% if not (a or b) %}{% endif %}", "{% macro a(b) %}{% endmacro %}"),
        *("{% for a in b %}{{ loop.index }}{% endfor %}", "{% for a, b in c %}{% endfor %}"),
        *("{% for a in b if a %}{% endfor %}", "{% if a is odd %}{% endif %}"),
    ],
)
def test_logic_would_be_seen(text: str) -> None:
    assert faults(text)


@pytest.mark.parametrize(
    "text",
    ["{% if not a.b %}{{ c }}{% endif %}", "{% for a in b.c %}{{ a.d }}{% endfor %}"],
)
def test_choices_and_loops_are_no_logic(text: str) -> None:
    assert faults(text) == []


def test_a_missing_value_is_an_error() -> None:
    with pytest.raises(jinja2.UndefinedError):
        render("c/solver.h.jinja", about="arm")


@pytest.mark.parametrize("name", SHORT)
def test_no_line_of_a_template_is_long(name: str) -> None:
    """Placeholders stand for short texts: what is left must leave them room."""
    for line in (TEMPLATES / name).read_text(encoding="utf-8").splitlines():
        assert len(re.sub(r"\{\{.*?\}\}|\{%.*?%\}", "", line)) <= 100
