"""Local constants in C: constants that belong together are in one statement."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.targets.families import follows
from dhgen.targets.layout import WIDTH, wrapped

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable


@dataclass(frozen=True, slots=True)
class Declaration:
    """A local constant."""

    kind: str
    name: str
    value: str


def declared(declarations: Iterable[Declaration], indent: str) -> list[str]:
    """Statements, one for each family of values."""
    return _listed(declarations, indent, follows)


def dense(declarations: Iterable[Declaration], indent: str, width: int = WIDTH) -> list[str]:
    """Statements, one for all values of one type that follow each other."""
    return _listed(declarations, indent, lambda _name, _before: True, width)


def _listed(
    declarations: Iterable[Declaration],
    indent: str,
    shares: Callable[[str, str], bool],
    width: int = WIDTH,
) -> list[str]:
    statements: list[list[Declaration]] = []
    for each in declarations:
        before = statements[-1][-1] if statements else None
        if before and each.kind == before.kind and shares(each.name, before.name):
            statements[-1].append(each)
        else:
            statements.append([each])
    return [line for statement in statements for line in _statement(statement, indent, width)]


def _statement(declarations: list[Declaration], indent: str, width: int) -> list[str]:
    """One statement for values of one type; lines are broken between values where they can be."""
    first, *others = (f"{each.name} = {each.value}," for each in declarations)
    lines = wrapped(f"{indent}const {declarations[0].kind} {first}", indent, width=width)
    for other in others:
        if len(lines[-1]) + 1 + len(other) <= width:
            lines[-1] += f" {other}"
        else:
            lines += wrapped(f"{indent}    {other}", f"{indent}    ", width=width)
    return [*lines[:-1], f"{lines[-1].removesuffix(',')};"]
