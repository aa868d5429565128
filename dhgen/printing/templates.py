"""The one place that touches jinja2: a template's path and its values go in, text comes out."""

from __future__ import annotations

from dataclasses import fields
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from jinja2 import Environment, FileSystemLoader, StrictUndefined

if TYPE_CHECKING:
    from _typeshed import DataclassInstance


def named(values: DataclassInstance) -> dict[str, object]:
    """The fields of a dataclass as values that a template names."""
    return {field.name: getattr(values, field.name) for field in fields(values)}


def render(template: str, **values: object) -> str:
    """Fill in a template.

    Args:
        template: Its path below `templates/`, e.g. `c/solver.c.jinja`.
        **values: What the template names; naming anything else is an error.

    Returns:
        The text, with the template's own last line end.

    Raises:
        jinja2.TemplateNotFound: There is no such template.
        jinja2.UndefinedError: The template names a value that was not given.
    """
    return _environment().get_template(template).render(values)


@cache
def _environment() -> Environment:
    """The environment of every template: strict, and with the layout of the output in mind."""
    return Environment(
        loader=FileSystemLoader(template_folder()),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,  # noqa: S701  the output is source code, where & and < mean themselves
    )


def template_folder() -> Path:
    """The folder of templates: `dhgen/templates` in a wheel, beside `dhgen` in a checkout."""
    package = Path(__file__).resolve().parent.parent
    # The wheel's first: beside an installed dhgen may lie somebody else's `templates`.
    packaged = package / "templates"
    return packaged if packaged.is_dir() else package.parent / "templates"
