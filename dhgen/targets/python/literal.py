"""Values of the runtime's data classes as Python text."""

from __future__ import annotations

import math
from dataclasses import MISSING, dataclass, fields, is_dataclass
from typing import TYPE_CHECKING, Any

from dhgen.targets.layout import INDENT, WIDTH, listed

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence


def literal(value: object, modules: Mapping[str, str], indent: str = "") -> str:
    """An expression for a value, broken into lines where it is too long.

    Args:
        value: A number, a truth value, a text, None, or a tuple or data class of such.
        modules: The prefix of the name of a class, by the name of its module.
        indent: Of the line that it is in.
    """
    flat = _flat(value, modules)
    if len(indent) + len(flat) < WIDTH or not isinstance(value, tuple) | is_dataclass(value):
        return flat
    inner = indent + INDENT
    if isinstance(value, tuple):
        if all(isinstance(x, (int, float)) for x in value):
            return "\n".join(
                ["(", *listed([_flat(x, modules) for x in value], inner), f"{indent})"]
            )
        lines = [f"{inner}{literal(x, modules, inner)}," for x in value]
        return "\n".join(["(", *lines, f"{indent})"])
    named = _named(value)
    if _is_row(named):
        row = listed([_flat(x, modules) for x in named[0][1]], inner)
        return "\n".join([f"{_class(value, modules)}((", *row, f"{indent}))"])
    return "\n".join(
        [f"{_class(value, modules)}(", *fields_of(named, modules, inner), f"{indent})"]
    )


def fields_of(
    named: Iterable[tuple[str, object]], modules: Mapping[str, str], indent: str
) -> list[str]:
    """Arguments by their names, as many in a line as fit."""
    lines = [""]
    for name, value in named:
        text = f"{name}={literal(value, modules, indent)},"
        if lines[-1] and "\n" not in text + lines[-1] and len(lines[-1]) + len(text) < WIDTH:
            lines[-1] += f" {text}"
        else:
            lines.append(f"{indent}{text}")
    return lines[1:]


@dataclass(frozen=True, slots=True)
class Name:
    """A value that a file has under a name."""

    name: str


def _flat(value: object, modules: Mapping[str, str]) -> str:
    """The value in one line."""
    if isinstance(value, float) and math.isinf(value):
        return "math.inf" if value > 0.0 else "-math.inf"
    if isinstance(value, Name):
        return value.name
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, tuple):
        inside = ", ".join(_flat(x, modules) for x in value)
        return f"({inside},)" if len(value) == 1 else f"({inside})"
    if is_dataclass(value):
        named = _named(value)
        inside = ", ".join(
            _flat(x, modules) if _is_row(named) else f"{name}={_flat(x, modules)}"
            for name, x in named
        )
        return f"{_class(value, modules)}({inside})"
    return repr(value)


def _class(value: object, modules: Mapping[str, str]) -> str:
    return f"{modules[type(value).__module__]}.{type(value).__name__}"


def _is_row(named: Sequence[tuple[str, Any]]) -> bool:
    """Whether all that is named is a tuple of numbers, which needs no name then."""
    return len(named) == 1 and isinstance(named[0][1], tuple)


def _named(value: Any) -> list[tuple[str, Any]]:  # noqa: ANN401
    """The fields of a data class that are not what they are without being named."""
    named = [(each, getattr(value, each.name)) for each in fields(value)]
    return [(f.name, x) for f, x in named if f.default is MISSING or x != f.default]
