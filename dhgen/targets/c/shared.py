"""C that one pose with its branches in lanes and one lane a pose have in common, as macros."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.ir import Apply, Heading, Let
from dhgen.program.walk import names_in
from dhgen.targets.c.declared import Declaration, dense
from dhgen.targets.c.lanes import LaneText
from dhgen.targets.c.language import C
from dhgen.targets.layout import GOES_ON, INDENT, WIDTH

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.ir import Statement
    from dhgen.program.regular.flatten import Flat

_LANES = re.compile(r"\b(\w+)_(four|wide)\(")
_PLAIN = re.compile(r"\b(sqrt|fabs|sin|cos)\(")
_CALLED = {"sqrt": "sqrt", "fabs": "abs", "sin": "sin", "cos": "cos"}  # in dhgen_abs_four ...
MACROS = ("KNOWN", "SIGNED", "SIGNED_TWICE")  # by the number of signs that values need


@dataclass(frozen=True, slots=True)
class Shared:
    """Values of a program for regular poses that all functions compute in equal words.

    Attributes:
        names: What they are called.
        signs: Those of them that need nothing but signs, and have a type of their own.
        macros: The definition of a macro for each depth, the values that need so many signs.
        depths: Those that have one.
    """

    names: frozenset[str] = frozenset()
    signs: frozenset[str] = frozenset()
    macros: Sequence[str] = ()
    depths: tuple[int, ...] = ()

    def stated(self, depth: int, number: str, signs: str, indent: str = INDENT) -> list[str]:
        """The statement for a depth, where there is one.

        Args:
            depth: The number of signs that its values need.
            number: Their type.
            signs: The type of values that need nothing but signs.
            indent: The blanks before it.
        """
        types = f"{number}, {signs}" if depth else number
        return [f"{indent}{MACROS[depth]}({types});"] if depth in self.depths else []


NOTHING_SHARED = Shared()


def depth_of(let: Let) -> int:
    """In how many loops over signs a value is."""
    return max(let.axes, default=-1) + 1


def shared_values(flat: Flat) -> Shared:
    """The values with equal words whether lanes are branches or poses, but for angles."""
    words = _Words(flat)
    body = [each for each in flat.program.body if words.has(each)]
    macros: list[str] = []
    depths = []
    for depth in range(len(flat.lanes) + 1):
        lines = _values([each for each in body if words.stands(each, depth)], words.declared)
        if lines:
            depths.append(depth)
            types = "number, signs" if depth else "number"
            first, *others = [f"#define {MACROS[depth]}({types})", *lines]
            macros += [f"{line}{GOES_ON}" for line in [first, *others[:-1]]]
            macros.append(others[-1].removesuffix(";"))
    signs = frozenset(name for name, each in words.declared.items() if each.kind == "dhgen_##signs")
    return Shared(frozenset(words.declared), signs, macros, tuple(depths))


class _Words:
    """The values, and how they are written."""

    def __init__(self, flat: Flat) -> None:
        program = flat.program
        self.declared: dict[str, Declaration] = {}
        self._own: set[str] = set()
        self._one = LaneText("four", program, wide=False)
        self._wide = LaneText("wide", program, wide=True)
        for axis in program.axes:
            self._wide.declare(axis.name, lanes=False)
        for statement in program.body:
            if isinstance(statement, Let):
                self._let(statement)

    def _let(self, let: Let) -> None:
        pose, lanes = (text.let(let) for text in (self._one, self._wide))
        one, wide = pose.value, lanes.value
        angle = isinstance(let.expression, Apply) and let.expression.operator == "atan2"
        mixed = depth_of(let) > 0 and _PLAIN.search(one)
        one = _PLAIN.sub(lambda found: f"dhgen_{_CALLED[found[1]]}_##number(", one)
        one, wide = (_LANES.sub(r"\1_##number(", text) for text in (one, wide))
        signs = bool(let.axes) and (pose.kind, lanes.kind) == ("dhgen_four", "double")
        one_kind = "dhgen_four" if let.axes else "double"
        number = (pose.kind, lanes.kind) == (one_kind, "dhgen_wide")
        own = angle or mixed or not (signs or number)
        if own or one != wide or names_in(let.expression) & self._own:
            self._own.add(let.name)
        else:
            kind = "signs" if signs else "number"
            self.declared[let.name] = Declaration(f"dhgen_##{kind}", let.name, one)

    def has(self, statement: Statement) -> bool:
        return not isinstance(statement, Let) or statement.name in self.declared

    def stands(self, statement: Statement, depth: int) -> bool:
        return not isinstance(statement, Let) or depth_of(statement) == depth


def _values(body: Sequence[Statement], declared: dict[str, Declaration]) -> list[str]:
    """Values under their headings."""
    lines: list[str] = []
    heading = ""
    values: list[Declaration] = []
    for statement in [*body, Heading("")]:
        if isinstance(statement, Let):
            values.append(declared[statement.name])
        elif isinstance(statement, Heading):
            if values:
                lines += [C().comment(heading, INDENT)] if heading else []
                lines += dense(values, INDENT, WIDTH - len(GOES_ON))
            heading, values = statement.text, []
    return lines
