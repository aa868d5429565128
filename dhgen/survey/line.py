"""A line of the survey: what was asked of an arm's solver and what it answered."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
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
