"""A program as loops over its signs: every statement in the outermost loop that knows its signs.

The scalar targets print this: a tree of statements and loops, with headings where a step begins.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.ir import Guard, Heading, Let

if TYPE_CHECKING:
    from dhgen.program.ir import Axis, Program


@dataclass(frozen=True, slots=True)
class Loop:
    """The two values of a sign.

    Attributes:
        axis: The sign.
        place: Its number, from 0.
        stride: How many rows lie between its two values.
        body: What is done for each value.
    """

    axis: Axis
    place: int
    stride: int
    body: tuple[Nested, ...]


Nested = Let | Guard | Heading | Loop


def nest(program: Program) -> tuple[Nested, ...]:
    """The program's statements, loop by loop."""
    return _level(program, 0)


def _level(program: Program, depth: int) -> tuple[Nested, ...]:
    body: list[Nested] = []
    heading: Heading | None = None
    shown: Heading | None = None
    for statement in program.body:
        if isinstance(statement, Heading):
            heading = statement
        elif _depth(statement) == depth:
            if heading is not None and heading != shown:
                body.append(heading)
                shown = heading
            body.append(statement)
    if depth < len(program.axes):
        stride = 2 ** (len(program.axes) - depth - 1)
        body.append(Loop(program.axes[depth], depth, stride, _level(program, depth + 1)))
    return tuple(body)


def _depth(statement: Let | Guard) -> int:
    return max(statement.axes, default=-1) + 1
