"""A program as loops over its signs: every statement in the outermost loop that knows its signs.

The scalar targets print this: a tree of statements and loops, with headings where a step begins.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.ir import AllJoints, Guard, Heading, Let, Roots

if TYPE_CHECKING:
    from dhgen.program.ir import Axis, Program


@dataclass(frozen=True, slots=True)
class Loop:
    """The values of an axis: a sign's two, or the roots of a polynomial.

    Attributes:
        axis: The axis.
        place: Its number, from 0.
        is_sign: Whether it is a sign.
        body: What is done for each value.
    """

    axis: Axis
    place: int
    is_sign: bool
    body: tuple[Nested, ...]


Nested = Let | Guard | Roots | Heading | Loop


def nest(program: Program) -> tuple[Nested, ...]:
    """The program's statements, loop by loop."""
    return _level(program, 0, set())


def _level(program: Program, depth: int, seen: set[Heading]) -> tuple[Nested, ...]:
    """One loop's body; headings that were printed in full before are shortened."""
    body: list[Nested] = []
    heading: Heading | None = None
    shown: Heading | None = None
    for statement in program.body:
        if isinstance(statement, Heading):
            heading = statement
        elif not isinstance(statement, AllJoints) and _depth(statement) == depth:
            if heading is not None and heading != shown:
                body.append(Heading(heading.text) if heading in seen else heading)
                seen.add(heading)
                shown = heading
            body.append(statement)
    if depth < len(program.axes):
        has_roots = any(s.axis == depth for s in program.body if isinstance(s, Roots))
        inner = _level(program, depth + 1, seen)
        body.append(Loop(program.axes[depth], depth, not has_roots, inner))
    return tuple(body)


def _depth(statement: Let | Guard | Roots) -> int:
    return max(statement.axes, default=-1) + 1
