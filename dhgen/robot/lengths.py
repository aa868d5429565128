"""The lengths of an arm beside each other: one out of all proportion is told."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from dhgen.robot.angles import SNAP
from dhgen.robot.source import quoted

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.robot.reader import Path
    from dhgen.robot.report import Report

# Squares of lengths are added: of sixteen digits the shorter one's have four beside the longer's.
LEAST = 1e-6


class Length(NamedTuple):
    """A length of the file, without its sign."""

    value: float
    path: Path
    text: str


def note_spread(report: Report, lengths: Iterable[Length]) -> None:
    """Tell of the shortest length where it is next to nothing beside the longest.

    Where the base stands in the world is no length of the arm.
    """
    arm = [each for each in lengths if each.value > SNAP and each.path[0] != "base"]
    if not arm:
        return
    shortest, longest = (pick(arm, key=lambda each: each.value) for pick in (min, max))
    if shortest.value < LEAST * longest.value:
        message = (
            f"{quoted(shortest.text)} is {shortest.value / longest.value:.1e} of the longest "
            f"length, {longest.value:g}, and lost in rounding: write 0 if that is meant, and all "
            "lengths in one unit"
        )
        report.notice(shortest.path, message)
