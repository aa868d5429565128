"""The limits of a joint: two ends of a range, in the joint's unit."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from dhgen.robot.angles import LARGEST_ANGLE, LARGEST_LENGTH
from dhgen.robot.cells import INVALID
from dhgen.robot.lengths import Length
from dhgen.robot.robot import JointKind
from dhgen.robot.source import quoted
from dhgen.robot.wording import is_endless

if TYPE_CHECKING:
    from dhgen.robot.cells import Cells
    from dhgen.robot.expression import Expression
    from dhgen.robot.reader import Path

_NOWHERE = "neither value limits the joint: leave 'limits' out"

# Beyond, an end is as good as nowhere, and doubles have too few digits of it.
_FARTHEST = {
    JointKind.REVOLUTE: (LARGEST_ANGLE, f"{LARGEST_ANGLE:.0e} rad"),
    JointKind.PRISMATIC: (LARGEST_LENGTH, f"{LARGEST_LENGTH:.0e}"),
}
# What to write for an end that there is not. Tolerances are relative to how far a slide goes.
_INSTEAD = {
    JointKind.REVOLUTE: "if nothing stops the joint, write some turns, e.g. {}3600 deg",
    JointKind.PRISMATIC: "if nothing stops the slide, write the farthest that it is ever sent",
}


def read_limits(
    cells: Cells, path: Path, kind: JointKind, entry: list[str]
) -> tuple[float, float] | None:
    """Lowest and highest value of a joint; mistakes are reported.

    Args:
        cells: Reads the cells, and reports.
        path: Where the limits stand.
        kind: How the joint moves.
        entry: Both ends as written; empty where there are no limits.
    """
    if not entry:
        return None
    endless = [is_endless(cell) and not cells.knows(cell.strip().lstrip("+-")) for cell in entry]
    ends = [
        INVALID if none else cells.parse((*path, i), cell)
        for i, (cell, none) in enumerate(zip(entry, endless, strict=True))
    ]
    low, high = (_value(cells, kind, end) for end in ends)
    farthest, shown = _FARTHEST[kind]
    reasons = [
        "not a number" if none else f"beyond {shown}" if abs(value) > farthest else ""
        for none, value in zip(endless, (low, high), strict=True)
    ]
    if all(reasons):
        cells.report.error(path, _NOWHERE)
        return None
    for i, reason in enumerate(reasons):
        if reason:
            instead = _INSTEAD[kind].format("" if i else "-")
            cells.report.error((*path, i), f"{quoted(entry[i].strip())} is {reason}: {instead}")
            ends[i] = INVALID
    _look_at_units(cells, path, kind, entry, ends)
    if not any(reasons) and low >= high:
        _report_order(cells, path, kind, entry, ends)
    return low, high


def _value(cells: Cells, kind: JointKind, end: Expression) -> float:
    return cells.value(cells.radians(end) if kind is JointKind.REVOLUTE else end)


def _look_at_units(
    cells: Cells, path: Path, kind: JointKind, entry: list[str], ends: list[Expression]
) -> None:
    ways = [(*path, i) for i in range(len(ends))]
    if kind is JointKind.REVOLUTE:
        # Of both ends one is told of: they are mended together.
        any(map(cells.note_unit, ways, entry, ends))
    else:
        for way, text, end in zip(ways, entry, ends, strict=True):
            cells.refuse_degrees(way, text, end)
            cells.lengths.append(Length(abs(cells.value(end)), way, text.strip()))


def _report_order(
    cells: Cells, path: Path, kind: JointKind, entry: list[str], ends: list[Expression]
) -> None:
    """Tell of ends in the wrong order, and of units that are mixed in them."""
    shown = []
    for i, (text, end) in enumerate(zip(entry, ends, strict=True)):
        said, value, unit = text.strip(), _value(cells, kind, end), ""
        if kind is JointKind.REVOLUTE:
            cells.note_mixture((*path, i), text, end)
            value, unit = (math.degrees(value), " deg") if cells.units.degrees else (value, " rad")
        plain = re.fullmatch(r"[-+\d.]{1,12}", said)
        shown.append(said if plain else f"{quoted(said)} ({value:.6g}{unit})")
    low, high = shown
    cells.report.error(path, f"the lower limit {low} is not below the upper one {high}")
