"""The joints of a file: rows of a Denavit-Hartenberg table, or axes in the reference position."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.robot.angles import LARGEST_ANGLE, LARGEST_LENGTH, SNAP
from dhgen.robot.cells import INVALID
from dhgen.robot.frames import read_lengths
from dhgen.robot.lengths import Length
from dhgen.robot.robot import AxisJoint, DhRow, JointKind
from dhgen.robot.source import quoted
from dhgen.robot.variable import VARIABLE, Split, split
from dhgen.robot.wording import is_endless

if TYPE_CHECKING:
    from dhgen.robot.cells import Cells
    from dhgen.robot.expression import Expression
    from dhgen.robot.reader import Path
    from dhgen.robot.schema import AxisRow, JointRow

NOWHERE = "both ends are nowhere: leave 'limits' out"

# Beyond, an end is as good as nowhere, and doubles have too few digits of it.
_FARTHEST = {
    JointKind.REVOLUTE: (LARGEST_ANGLE, f"{LARGEST_ANGLE:.0e} rad"),
    JointKind.PRISMATIC: (LARGEST_LENGTH, f"{LARGEST_LENGTH:.0e}"),
}
# What to write for an end that there is not. Tolerances are relative to how far a slide goes.
_INSTEAD = {
    JointKind.REVOLUTE: "where nothing stops the joint write some turns, e.g. {}3600 deg",
    JointKind.PRISMATIC: "where nothing stops the slide write how far it is ever sent, not more",
}


def read_row(cells: Cells, path: Path, entry: JointRow, *, complete: bool) -> DhRow:
    """A row of the table; mistakes are reported.

    Args:
        cells: Reads the cells, and reports.
        path: Where the row stands.
        entry: Its keys.
        complete: Whether these are all: a misspelt key may have held the variable.
    """
    theta = _split(cells, (*path, "theta"), entry.theta)
    d = _split(cells, (*path, "d"), entry.d)
    if INVALID not in (theta.offset, d.offset):
        if theta.sign and d.sign:
            cells.report.error((*path, "d"), "q stands in theta already: a joint has one variable")
        elif complete and not theta.sign and not d.sign:
            message = (
                "no variable: write q in theta (revolute) or in d (prismatic); what does not move "
                "belongs to base, tool or a row beside it"
            )
            cells.report.error(path, message)
    kind = JointKind.PRISMATIC if d.sign else JointKind.REVOLUTE
    offset = cells.radians(theta.offset)
    return DhRow(
        kind=kind,
        sign=theta.sign or d.sign,
        theta=cells.snap_angle((*path, "theta"), entry.theta, offset),
        d=cells.snap_length((*path, "d"), entry.d, d.offset),
        a=cells.length((*path, "a"), entry.a),
        alpha=cells.angle((*path, "alpha"), entry.alpha),
        limits=_limits(cells, (*path, "limits"), kind, entry.limits),
    )


def read_axis(cells: Cells, path: Path, entry: AxisRow, *, complete: bool) -> AxisJoint:
    """An axis in the reference position; mistakes are reported.

    Args:
        cells: Reads the cells, and reports.
        path: Where the axis stands.
        entry: Its keys.
        complete: Whether these are all: a mistaken one may have held the point.
    """
    kind = JointKind(entry.type)
    x, y, z = (cells.ratio((*path, "direction", i), cell) for i, cell in enumerate(entry.direction))
    if math.hypot(*(cells.value(part) for part in (x, y, z))) <= SNAP:
        cells.report.error((*path, "direction"), "a direction of length 0 is no axis")
    if complete and kind is JointKind.REVOLUTE and not entry.point:
        cells.report.error(path, "the key 'point' is missing: a revolute joint turns about a line")
    return AxisJoint(
        kind=kind,
        direction=(x, y, z),
        point=read_lengths(cells, (*path, "point"), entry.point),
        limits=_limits(cells, (*path, "limits"), kind, entry.limits),
    )


def _split(cells: Cells, path: Path, text: str) -> Split:
    expression = cells.parse(path, text, more={VARIABLE.name: math.nan})
    parts = split(expression)
    if parts is None:
        message = "q stands alone, with a sign or with an offset: q, -q, q + pi/2, pi - q"
        cells.report.error(path, message)
    return parts or Split(0, INVALID)


def _limits(
    cells: Cells, path: Path, kind: JointKind, entry: list[str]
) -> tuple[float, float] | None:
    if not entry:
        return None
    endless = [is_endless(cell) and not cells.knows(cell.strip().lstrip("+-")) for cell in entry]
    ends = [
        INVALID if none else cells.parse((*path, i), cell)
        for i, (cell, none) in enumerate(zip(entry, endless, strict=True))
    ]
    turns = kind is JointKind.REVOLUTE
    low, high = (cells.value(cells.radians(end) if turns else end) for end in ends)
    farthest, shown = _FARTHEST[kind]
    reasons = [
        "no number" if none else f"beyond {shown}" if abs(value) > farthest else ""
        for none, value in zip(endless, (low, high), strict=True)
    ]
    if all(reasons):
        cells.report.error(path, NOWHERE)
        return None
    for i, reason in enumerate(reasons):
        if reason:
            instead = _INSTEAD[kind].format("" if i else "-")
            cells.report.error((*path, i), f"{quoted(entry[i].strip())} is {reason}: {instead}")
    _look_at_ends(cells, path, kind, entry, ends)
    if low >= high:
        cells.report.error(path, f"the lower limit {low:.6g} is not below the upper one {high:.6g}")
    return low, high


def _look_at_ends(
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
