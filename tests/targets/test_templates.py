"""Templates get finished strings: they loop and choose, they don't compute."""

from __future__ import annotations

import re
from collections import defaultdict
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import jinja2
import jinja2.meta
import pytest
from jinja2 import nodes

from dhgen.targets.c import c_solver
from dhgen.targets.python import python_solver
from dhgen.targets.solver.common import common_of
from dhgen.targets.templates import named, render
from tests.targets.made import made

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.targets.module import SolverModule

TEMPLATES = Path(__file__).resolve().parents[2] / "templates"
ALL = sorted(str(path.relative_to(TEMPLATES)) for path in TEMPLATES.rglob("*.jinja"))
SHORT = tuple(name for name in ALL if "solver" in name)
ARMS = ("scara", "kuka_iiwa14_arm_angle")
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


@cache
def included(name: str) -> set[str]:
    """A template and all that it includes."""
    text = (TEMPLATES / name).read_text(encoding="utf-8")
    parsed = jinja2.Environment(autoescape=True).parse(text)
    found = {str(each) for each in jinja2.meta.find_referenced_templates(parsed)}
    return {name}.union(*map(included, found))


@cache
def paths(name: str) -> set[tuple[str, ...]]:
    """What a template and all that it includes name, whichever branches a robot takes."""
    found: set[tuple[str, ...]] = set()
    for each in included(name):
        text = (TEMPLATES / each).read_text(encoding="utf-8")
        parsed = jinja2.Environment(autoescape=True).parse(text)
        free = jinja2.meta.find_undeclared_variables(parsed)
        found |= {path for path in map(path_of, _below(parsed)) if path and path[0] in free}
    return found


def path_of(node: nodes.Node) -> tuple[str, ...]:
    """A name, and the attributes that are asked of it."""
    match node:
        case nodes.Name():
            return (node.name,)
        case nodes.Getattr():
            path = path_of(node.node)
            return (*path, node.attr) if path else ()
        case _:
            return ()


def has(values: object, path: tuple[str, ...]) -> bool:
    """Whether there is such an attribute; of what a robot has not nothing is known."""
    if not path or values is None:
        return True
    return hasattr(values, path[0]) and has(getattr(values, path[0]), path[1:])


def solvers_of(module: SolverModule) -> list[tuple[str, dict[str, object]]]:
    """Templates of a robot's solver, with what they may name."""
    common = common_of(module)
    shared = named(common)
    of_c, of_python = c_solver(module, common), python_solver(module, common)
    assert of_c.regular is not None
    in_c = named(of_c) | {"test": of_c.regular.irregularity.wide}  # another name in templates
    in_python = named(of_python)
    return [
        ("c/solver.h.jinja", shared | in_c),
        ("c/solver.c.jinja", shared | in_c),
        ("python/solver.py.jinja", shared | in_python),
    ]


@pytest.mark.parametrize("robot", ARMS)
def test_templates_name_what_there_is(robot: str) -> None:
    for template, values in solvers_of(made(robot).module):
        wrong = {
            ".".join(path)
            for path in paths(template)
            if path[0] not in values or not has(values[path[0]], path[1:])
        }
        assert not wrong, template


def test_what_there_is_is_named() -> None:
    """By a template of one of the languages, or by what is included as text."""
    asked = set().union(*(paths(template) for template in ALL))
    known: dict[str, set[str]] = defaultdict(set)
    for _, values in solvers_of(made(ARMS[0]).module):
        for name, group in values.items():
            if is_dataclass(group) and name != "tolerances":
                known[name] |= {field.name for field in fields(group)}
    unused = {
        f"{name}.{each}" for name in known for each in known[name] if (name, each) not in asked
    }
    assert not unused


@pytest.mark.parametrize("name", SHORT)
def test_no_line_of_a_template_is_long(name: str) -> None:
    """Placeholders stand for short texts: what is left must leave them room."""
    for line in (TEMPLATES / name).read_text(encoding="utf-8").splitlines():
        assert len(re.sub(r"\{\{.*?\}\}|\{%.*?%\}", "", line)) <= 100
