"""How many arithmetic operations a program takes for all its rows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.ir import Apply, Guard, Let, Roots
from dhgen.program.walk import parts

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.program.ir import Expression, Program


@dataclass(frozen=True, slots=True)
class OperationCount:
    """Operations of one kind each; changes of sign, comparisons and choices are not counted.

    Attributes:
        additions: Additions and subtractions.
        multiplications: Multiplications.
        divisions: Divisions.
        square_roots: Square roots.
        arctangents: atan2.
        sines_cosines: Sines and cosines, which only values from the caller need.
    """

    additions: int
    multiplications: int
    divisions: int
    square_roots: int
    arctangents: int
    sines_cosines: int


_FIELDS = {
    "add": "additions",
    "sub": "additions",
    "mul": "multiplications",
    "div": "divisions",
    "sqrt": "square_roots",
    "atan2": "arctangents",
    "sin": "sines_cosines",
    "cos": "sines_cosines",
}


def count_operations(program: Program) -> OperationCount:
    """Counts a program; a statement counts once for each combination of the signs it depends on."""
    totals = dict.fromkeys(_FIELDS.values(), 0)
    for expression, times in _expressions(program):
        for part in parts(expression):
            if isinstance(part, Apply) and part.operator in _FIELDS:
                totals[_FIELDS[part.operator]] += times
    return OperationCount(**totals)


def _expressions(program: Program) -> Iterator[tuple[Expression, int]]:
    """Every expression, with how often it is evaluated.

    Of a guard the condition alone: its margin and what may be chosen again are for the poses that
    it refuses.
    """
    for statement in program.body:
        match statement:
            case Let(expression=expression, axes=axes) | Guard(condition=expression, axes=axes):
                yield expression, program.combinations(axes)
            case Roots(coefficients=coefficients, axes=axes):
                for coefficient in coefficients:
                    yield coefficient, program.combinations(axes)
