"""C that gives the entries of a pose their names."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.targets.layout import INDENT
from dhgen.targets.scalar import pose_entries

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.ir import Program
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class Entries:
    """The lines that name a pose's entries, and the definition of a macro if they use one."""

    lines: Sequence[str]
    macro: Sequence[str]


def entry_texts(
    module: SolverModule, regular: Sequence[Program], nearest: SolverModule | None = None
) -> Entries:
    """How a robot's solver names the pose's entries beside its programs for regular poses.

    Args:
        module: The robot.
        regular: Its programs for regular poses, or those of the nearest arm.
        nearest: The nearest arm, where that has these.
    """
    if nearest is not None:
        return Entries(entry_lines(module.solver), entry_texts(nearest, regular).macro)
    if not regular or not read_alike(module, regular):
        return Entries(entry_lines(module.solver), ())
    return Entries(entry_lines(module.solver, alike=True), _entries_macro(regular[0]))


def read_alike(module: SolverModule, regular: Sequence[Program]) -> bool:
    """Whether all programs read the same entries."""
    programs = module.solver, *regular
    return len({tuple(pose_entries(program)) for program in programs}) == 1


def entry_lines(program: Program, number: str = "double", *, alike: bool = False) -> list[str]:
    """The entries of the pose get their names, row by row.

    Args:
        program: Which reads them.
        number: Their type.
        alike: Whether all programs read the same, and a macro holds the names.
    """
    if alike:
        return [f"{INDENT}ENTRIES({number});"]
    lines = []
    for row in (1, 2, 3):
        named = [
            f"T{entry.row}{entry.column} = T[{4 * (row - 1) + entry.column - 1}]"
            for entry in pose_entries(program)
            if entry.row == row
        ]
        lines += [f"{INDENT}const {number} {', '.join(named)};"] if named else []
    return lines


def _entries_macro(program: Program) -> list[str]:
    *lines, last = entry_lines(program, "number")
    ending = [f"{line} \\" for line in ["#define ENTRIES(number)", *lines]]
    return [*ending, last.removesuffix(";")]
