"""Templates get finished strings: they loop and choose, they don't compute."""

from __future__ import annotations

import re
from pathlib import Path

import jinja2
import pytest
from jinja2 import nodes

from dhgen.targets.templates import render

TEMPLATES = Path(__file__).resolve().parents[2] / "templates"
ALL = sorted(
    str(path.relative_to(TEMPLATES))
    for path in TEMPLATES.rglob("*.jinja")
    if not path.name.startswith("general6r")  # its tables are unrolled in the templates
)
ARITHMETIC = (
    *(nodes.Filter, nodes.Call, nodes.Add, nodes.Sub, nodes.Mul, nodes.Div, nodes.FloorDiv),
    *(nodes.Mod, nodes.Pow, nodes.Concat, nodes.Neg, nodes.Macro, nodes.Assign, nodes.Compare),
)


def tree(text: str) -> nodes.Template:
    return jinja2.Environment(autoescape=True).parse(text)


@pytest.mark.parametrize("name", ALL)
def test_no_logic(name: str) -> None:
    parsed = tree((TEMPLATES / name).read_text(encoding="utf-8"))
    found = [type(node).__name__ for node in parsed.find_all(ARITHMETIC)]
    assert found == []


@pytest.mark.parametrize(
    "text",
    ["{{ a + 1 }}", "{{ a | join }}", "{{ a.b() }}", "{{ -a }}", "{% if a > 1 %}{% endif %}"],
)
def test_logic_would_be_seen(text: str) -> None:
    assert list(tree(text).find_all(ARITHMETIC))


def test_a_missing_value_is_an_error() -> None:
    with pytest.raises(jinja2.UndefinedError):
        render("c/solver.h.jinja", name="arm")


@pytest.mark.parametrize("name", [each for each in ALL if "solver" in each])
def test_no_line_of_a_template_is_long(name: str) -> None:
    """Placeholders stand for short texts: what is left must leave them room."""
    for line in (TEMPLATES / name).read_text(encoding="utf-8").splitlines():
        assert len(re.sub(r"\{\{.*?\}\}|\{%.*?%\}", "", line)) <= 100
