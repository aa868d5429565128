"""Templates get finished strings: they loop and choose, they don't compute."""

from __future__ import annotations

import re
from dataclasses import fields, is_dataclass
from functools import cache
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

import jinja2
import jinja2.meta
import pytest
from jinja2 import nodes

from dhgen.printing.templates import render
from dhgen.targets.c import files as c
from dhgen.targets.python import files as python
from dhgen.tolerances import Tolerances
from tests.targets.made import made

if TYPE_CHECKING:
    from collections.abc import Iterator

TEMPLATES = Path(__file__).resolve().parents[2] / "templates"
ALL = sorted(str(path.relative_to(TEMPLATES)) for path in TEMPLATES.rglob("*.jinja"))
SHORT = tuple(name for name in ALL if "solver" in name or name.endswith("rows/rows.py.jinja"))
# between them all that templates choose from: regular poses, the arm angle, roots that nearly meet,
# the general algorithm with a determinant and in closed form, families of solutions
ARMS = (
    "scara",
    "kuka_iiwa14_arm_angle",
    "spherical_wrist_general_arm",
    "general_6r",
    "planar_rrrr",
)
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
def parsed(name: str) -> nodes.Template:
    """A template's parts."""
    text = (TEMPLATES / name).read_text(encoding="utf-8")
    return jinja2.Environment(autoescape=True).parse(text)


@cache
def included(name: str) -> set[str]:
    """A template and all that it includes."""
    found = {str(each) for each in jinja2.meta.find_referenced_templates(parsed(name))}
    return {name}.union(*map(included, found))


@cache
def paths(name: str) -> set[tuple[str, ...]]:
    """What a template and all that it includes name, whichever branches a robot takes."""
    found: set[tuple[str, ...]] = set()
    for each in included(name):
        free = jinja2.meta.find_undeclared_variables(parsed(each))
        found |= {path for path in map(path_of, _below(parsed(each))) if path and path[0] in free}
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


def bound(name: str) -> set[str]:
    """What a template and all that it includes give other names to."""
    found = (each for part in included(name) for each in parsed(part).find_all(nodes.With))
    return {
        target.name for each in found for target in each.targets if isinstance(target, nodes.Name)
    }


@cache
def filled(robot: str) -> tuple[tuple[str, dict[str, object]], ...]:
    """The templates of a robot's solvers, each with what it may name."""
    found: list[tuple[str, dict[str, object]]] = []

    def filled_in(template: str, **values: object) -> str:
        found.append((template, values))
        return render(template, **values)

    module = made(robot).module
    with pytest.MonkeyPatch.context() as patch:
        for place in (c, python):
            patch.setattr(place, "render", filled_in)
        c.c_files(module)
        python.python_files(module)
    return tuple(found)


@pytest.mark.parametrize("robot", ARMS)
def test_templates_name_what_there_is(robot: str) -> None:
    for template, values in filled(robot):
        wrong = {
            ".".join(path)
            for path in paths(template)
            if path[0] not in bound(template)
            and not (path[0] in values and has(values[path[0]], path[1:]))
        }
        assert not wrong, template


def test_what_there_is_is_named() -> None:
    """In one of the languages; the table of tolerances is for other things, too."""
    asked, known = set(), set()
    for template, values in chain.from_iterable(map(filled, ARMS)):
        for name, group in values.items():
            if not is_dataclass(group) or isinstance(group, Tolerances):
                continue
            kind = f"{type(group).__module__}.{type(group).__name__}"
            known |= {f"{kind}.{field.name}" for field in fields(group)}
            asked |= {
                f"{kind}.{path[1]}" for path in paths(template) if path[0] == name and path[1:]
            }
    assert sorted(known - asked) == []


@pytest.mark.parametrize("name", SHORT)
def test_no_line_of_a_template_is_long(name: str) -> None:
    """Placeholders stand for short texts: what is left must leave them room."""
    for line in (TEMPLATES / name).read_text(encoding="utf-8").splitlines():
        assert len(re.sub(r"\{\{.*?\}\}|\{%.*?%\}", "", line)) <= 100
