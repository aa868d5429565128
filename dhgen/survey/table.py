"""The survey as plain text: what each arm's solver was asked and answered, and the totals."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.method import Method


@dataclass(frozen=True, slots=True)
class Answers:
    """How a solver did.

    Attributes:
        method: How it works.
        degree: Of the highest polynomial in the tangent of half an angle.
        rows: Branches.
        cpu: From the robot file to the solver's text [s of CPU].
        poses: Random poses.
        expected: Solutions that the oracle found on them.
        found: Those of them that rows hold.
        spurious: Rows that miss their pose or repeat another row.
        unmet: Rows that reach their pose although the oracle did not come across them.
        residual: The largest miss of any row on any pose, in arm sizes.
        bound: What a row may miss its pose by.
        singular: Poses of singular kinds.
        answered: Those with the right answer.
        tried: Random poses whose own joint values are looked for among their rows.
        recalled: Those on which they are there.
        faults: What went wrong where, for a reader.
    """

    method: Method
    degree: int
    rows: int
    cpu: float
    poses: int
    expected: int
    found: int
    spurious: int
    unmet: int
    residual: float
    bound: float
    singular: int
    answered: int
    tried: int
    recalled: int
    faults: tuple[str, ...]

    @property
    def complete(self) -> bool:
        """Whether nothing is missing and nothing wrong."""
        counted = self.found == self.expected and not self.spurious
        answered = self.answered == self.singular and self.recalled == self.tried
        return counted and self.residual <= self.bound and answered


@dataclass(frozen=True, slots=True)
class Line:
    """An arm, and its solver's answers or why there are none.

    Attributes:
        name: The robot's, or the file's where that can't be read.
        joints: R or P for every joint, small where its value is given.
        structure: Of the geometry.
        answers: Of the solver; None without one.
        reason: Why there is none.
        mistaken: Whether that is a mistake in the file.
        remarks: Notes on the file, or all its mistakes, each with its place.
    """

    name: str
    joints: str
    structure: str
    answers: Answers | None
    reason: str = ""
    mistaken: bool = False
    remarks: tuple[str, ...] = ()

    @property
    def complete(self) -> bool:
        """Whether the arm is solved, and completely."""
        return self.answers is not None and self.answers.complete


HEAD = (
    "arm",
    "joints",
    "structure",
    "method",
    "degree",
    "rows",
    "CPU s",
    "found/expected",
    "spurious",
    "residual",
    "singular poses",
)
LEFT = (0, 1, 2, 3)  # columns of words


def survey_text(lines: Sequence[Line]) -> str:
    """The whole report."""
    rows = [HEAD, *(cells(line) for line in lines)]
    whole = [row for row in rows if len(row) == len(HEAD)]  # a reason may run on
    widths = [max(map(len, column)) for column in zip(*whole, strict=True)]
    widths[:3] = [max(map(len, column)) for column in zip(*(row[:3] for row in rows), strict=True)]
    text = [_aligned(row, widths) for row in rows]
    faults = [f"{line.name}: {fault}" for line in lines for fault in _faults(line)]
    parts = ["\n".join(text), *(["\n".join(faults)] if faults else []), totals_text(lines)]
    return "\n\n".join(parts) + "\n"


def totals_text(lines: Sequence[Line]) -> str:
    """The last lines of the report."""
    solved = [line.answers for line in lines if line.answers is not None]
    expected, found = sum(a.expected for a in solved), sum(a.found for a in solved)
    poses, spurious = sum(a.poses for a in solved), sum(a.spurious for a in solved)
    answered, singular = sum(a.answered for a in solved), sum(a.singular for a in solved)
    tried, recalled = sum(a.tried for a in solved), sum(a.recalled for a in solved)
    methods = sorted({a.method for a in solved})
    worst = (f"{_residual(_worst(solved, method))} ({method})" for method in methods)
    text = [
        f"{len(lines)} arm{'' if len(lines) == 1 else 's'}, {len(solved)} solved.",
        f"{found} of {expected} solutions found on {poses} random poses, {spurious} spurious.",
        f"{answered} of {singular} singular poses answered.",
        f"Own joint values found again on {recalled} of {tried} random poses.",
    ]
    if solved:
        text.append(f"Residuals below {', '.join(worst)} of the arm's size.")
    if any(a.unmet for a in solved):
        text.append(
            f"{sum(a.unmet for a in solved)} further solutions that the search did not find."
        )
    short = [line.name for line in lines if not line.complete]
    if short:
        text.append(f"With faults or not solved: {', '.join(short)}.")
    return "\n".join(text)


def _worst(solved: Sequence[Answers], method: str) -> float:
    return max(a.residual for a in solved if a.method == method)


def cells(line: Line) -> tuple[str, ...]:
    """A line's cells; where there is no solver the reason ends it."""
    head = line.name, line.joints, line.structure
    a = line.answers
    if a is None:
        return (*head, f"not solved: {line.reason}")
    return (
        *head,
        a.method,
        str(a.degree or "-"),
        str(a.rows),
        f"{a.cpu:.1f}",
        f"{a.found}/{a.expected}",
        str(a.spurious),
        _residual(a.residual),
        f"{a.answered}/{a.singular}",
    )


def _residual(value: float) -> str:
    """The power of ten above a residual: its digits depend on the compiler."""
    if not math.isfinite(value):
        return "none"
    return f"1e{math.ceil(math.log10(max(value, 1e-17)))}"


def _aligned(row: tuple[str, ...], widths: list[int]) -> str:
    cells = [
        cell.ljust(width) if i in LEFT else cell.rjust(width)
        for i, (cell, width) in enumerate(zip(row, widths, strict=False))
    ]
    return "  ".join(cells).rstrip()


def _faults(line: Line) -> tuple[str, ...]:
    return () if line.answers is None else line.answers.faults
