"""The joints of a file: rows of a Denavit-Hartenberg table, or axes in the reference position."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.robot.angles import SNAP
from dhgen.robot.cells import INVALID
from dhgen.robot.frames import read_lengths
from dhgen.robot.limits import read_limits
from dhgen.robot.robot import AxisJoint, DhRow, JointKind
from dhgen.robot.variable import VARIABLE, Split, split

if TYPE_CHECKING:
    from dhgen.robot.cells import Cells
    from dhgen.robot.reader import Path
    from dhgen.robot.schema import AxisRow, JointRow


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
            cells.report.error((*path, "d"), "q is already in theta: a joint has only one variable")
        elif complete and not theta.sign and not d.sign:
            message = (
                "no variable: write q in theta (revolute) or in d (prismatic); a fixed "
                "transform belongs in base, tool or a neighbouring row"
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
        limits=read_limits(cells, (*path, "limits"), kind, entry.limits),
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
        cells.report.error((*path, "direction"), "a direction can't have length 0")
    if complete and kind is JointKind.REVOLUTE and not entry.point:
        cells.report.error(path, "the key 'point' is missing: a revolute joint turns about a line")
    return AxisJoint(
        kind=kind,
        direction=(x, y, z),
        point=read_lengths(cells, (*path, "point"), entry.point),
        limits=read_limits(cells, (*path, "limits"), kind, entry.limits),
    )


def _split(cells: Cells, path: Path, text: str) -> Split:
    expression = cells.parse(path, text, more={VARIABLE.name: math.nan})
    parts = split(expression)
    if parts is None:
        message = "q may only have a sign and an offset: q, -q, q + pi/2, pi - q"
        cells.report.error(path, message)
    return parts or Split(0, INVALID)
