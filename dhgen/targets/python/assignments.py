"""Assignments in Python: values that don't need each other share a line."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from dhgen.targets.layout import WIDTH, wrapped

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

Assignment = tuple[str, str]

TOGETHER = 3  # targets: as many are assigned without making a tuple of their values

_WORD = re.compile(r"[A-Za-z_]\w*")
_BRANCH = re.compile(
    r" (?:if|and|or) "
)  # in values on lines of their own, where choices are visible


def broken(line: str, indent: str) -> list[str]:
    """An assignment that is too long for one line: Python may be broken inside parentheses."""
    name, value = line.strip().split(" = ", 1)
    inner = wrapped(f"{indent}    {value}", indent, "    ")
    return [f"{indent}{name} = (", *inner, f"{indent})"]


def alike(assignments: Iterable[Assignment], indent: str) -> list[Assignment]:
    """Assignments with neighbouring targets of one value chained, as many as fit in a line."""
    chained: list[Assignment] = []
    for target, value in assignments:
        both = f"{chained[-1][0]} = {target}" if chained else target
        if chained and chained[-1][1] == value and len(f"{indent}{both} = {value}") <= WIDTH:
            chained[-1] = both, value
        else:
            chained.append((target, value))
    return chained


def side_by_side(
    assignments: Iterable[Assignment],
    indent: str,
    *,
    follows: Callable[[str, str], bool] = lambda _name, _before: True,
    most: int = TOGETHER,
) -> list[str]:
    """Assignments in their order, as many in a line as fit and don't need each other.

    Args:
        assignments: Targets and values.
        indent: Of the lines.
        follows: Whether a target may share the line of another that is before it.
        most: Targets in a line.
    """
    groups: list[list[Assignment]] = []
    for each in assignments:
        if groups and len(groups[-1]) < most and _shares(each, groups[-1], indent, follows):
            groups[-1].append(each)
        else:
            groups.append([each])
    return [line for group in groups for line in _lines(group, indent)]


def _shares(
    each: Assignment,
    group: list[Assignment],
    indent: str,
    follows: Callable[[str, str], bool],
) -> bool:
    """Whether an assignment may share the line of others."""
    target, value = each
    if not follows(target, group[-1][0]) or any(map(_BRANCH.search, (group[0][1], value))):
        return False
    return {name for name, _ in group}.isdisjoint(_WORD.findall(value)) and (
        len(_line([*group, each], indent)) <= WIDTH
    )


def _lines(group: list[Assignment], indent: str) -> list[str]:
    line = _line(group, indent)
    return [line] if len(line) <= WIDTH else broken(line, indent)


def _line(group: list[Assignment], indent: str) -> str:
    targets, values = zip(*group, strict=True)
    return f"{indent}{', '.join(targets)} = {', '.join(values)}"
