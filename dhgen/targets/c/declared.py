"""Local constants in C: those that belong together stand in one statement."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.targets.layout import WIDTH, wrapped

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

# Values without a name of the derivation's, entries of a matrix, and columns of frames.
_NUMBERED = re.compile(r"(?:v|angle|packed|[JTpxyz])\d+")
_COSINE_OR_SINE = re.compile(r"[cs](\d+)")
_COMPONENT = re.compile(r"(w\d+)[xyz]")


@dataclass(frozen=True, slots=True)
class Declaration:
    """A local constant."""

    kind: str
    name: str
    value: str

    @property
    def family(self) -> str:
        """Branches of a value, cosine and sine, a vector ...; empty without a name of its own."""
        stem = self.name.partition("_")[0]
        if _NUMBERED.fullmatch(stem):
            return ""
        part = _COSINE_OR_SINE.fullmatch(stem) or _COMPONENT.fullmatch(stem)
        return part[1] if part else stem

    def follows(self, before: Declaration) -> bool:
        """Whether it may share another's statement: what has no name, that of an angle too."""
        turned = not self.family and _COSINE_OR_SINE.fullmatch(before.name)
        return self.kind == before.kind and (self.family == before.family or bool(turned))


def declared(declarations: Iterable[Declaration], indent: str) -> list[str]:
    """Statements, one for each family of values."""
    return _listed(declarations, indent, Declaration.follows)


def dense(declarations: Iterable[Declaration], indent: str, width: int = WIDTH) -> list[str]:
    """Statements, one for all values of one type that follow each other."""
    return _listed(declarations, indent, lambda each, before: each.kind == before.kind, width)


def _listed(
    declarations: Iterable[Declaration],
    indent: str,
    follows: Callable[[Declaration, Declaration], bool],
    width: int = WIDTH,
) -> list[str]:
    statements: list[list[Declaration]] = []
    for each in declarations:
        if statements and follows(each, statements[-1][-1]):
            statements[-1].append(each)
        else:
            statements.append([each])
    return [line for statement in statements for line in _statement(statement, indent, width)]


def _statement(declarations: list[Declaration], indent: str, width: int) -> list[str]:
    """One statement for values of one type, broken between them as far as that will do."""
    first, *others = (f"{each.name} = {each.value}," for each in declarations)
    lines = wrapped(f"{indent}const {declarations[0].kind} {first}", indent, width=width)
    for other in others:
        if len(lines[-1]) + 1 + len(other) <= width:
            lines[-1] += f" {other}"
        else:
            lines += wrapped(f"{indent}    {other}", f"{indent}    ", width=width)
    return [*lines[:-1], f"{lines[-1].removesuffix(',')};"]
