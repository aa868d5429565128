"""The joints of a file, rows of a table or axes, and the limits of each."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from dhgen.robot.angles import LARGEST_ANGLE, LARGEST_LENGTH, SNAP
from dhgen.robot.cell_notes import PlainLimit
from dhgen.robot.cells import INVALID
from dhgen.robot.couplings import read_couplings
from dhgen.robot.frames import read_lengths
from dhgen.robot.lengths import Length
from dhgen.robot.robot import AxisJoint, DhRow, JointKind
from dhgen.robot.shape import is_endless
from dhgen.robot.source import Span, quoted
from dhgen.robot.units import VARIABLE, Split, split

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.robot.cells import Cells
    from dhgen.robot.expression import Expression
    from dhgen.robot.reader import Path
    from dhgen.robot.schema import AxisRow, JointRow


_NUMBERED = re.compile(r"\bq([1-9]\d*)\b", re.ASCII)
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
        path: The place of the limits.
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
        # Of both ends one is reported: they are mended together. Of many turns both are counted.
        any(map(cells.note_unit, ways, entry, ends))
        if cells.units.degrees and not any(map(cells.units.speaks_of_pi, ends)):
            numbers = zip(ways, entry, map(cells.value, ends), strict=True)
            cells.limits_in_degrees += [PlainLimit(*each) for each in numbers]
    else:
        for way, text, end in zip(ways, entry, ends, strict=True):
            cells.refuse_degrees(way, text, end)
            cells.lengths.append(Length(abs(cells.value(end)), way, text.strip()))


def _report_order(
    cells: Cells, path: Path, kind: JointKind, entry: list[str], ends: list[Expression]
) -> None:
    """Reports ends in the wrong order, and units that are mixed in them."""
    shown = []
    for i, (text, end) in enumerate(zip(entry, ends, strict=True)):
        written, value, unit = text.strip(), _value(cells, kind, end), ""
        if kind is JointKind.REVOLUTE:
            cells.note_mixture((*path, i), text, end)
            value, unit = (math.degrees(value), " deg") if cells.units.degrees else (value, " rad")
        plain = re.fullmatch(r"[-+\d.]{1,12}", written)
        shown.append(written if plain else f"{quoted(written)} ({value:.6g}{unit})")
    low, high = shown
    cells.report.error(path, f"the lower limit {low} is not below the upper one {high}")


def read_row(
    cells: Cells, path: Path, entry: JointRow, numbers: Mapping[int, int], *, complete: bool
) -> DhRow:
    """A row of the table; mistakes are reported.

    Args:
        cells: Reads the cells, and reports.
        path: The place of the row.
        entry: Its keys.
        numbers: The joints' numbers by those of their rows: their variables it may hold.
        complete: Whether these are all: a misspelt key may have held the variable.
    """
    row = int(path[-1]) + 1
    theta = _split(cells, (*path, "theta"), entry.theta, numbers, row)
    d = _split(cells, (*path, "d"), entry.d, numbers, row)
    if INVALID not in (theta.offset, d.offset):
        _check_variables(cells, path, theta, d, complete=complete)
    slides = bool(d.sign or (d.others and not theta.sign))
    kind = JointKind.PRISMATIC if slides else JointKind.REVOLUTE
    moving = "d" if slides else "theta"
    if not (theta.sign or d.sign) and (theta.others or d.others):
        entry = _without_limits(cells, path, entry)
    offset = cells.radians(theta.offset)
    return DhRow(
        kind=kind,
        sign=theta.sign or d.sign,
        theta=cells.snap_angle((*path, "theta"), entry.theta, offset, theta.variable),
        d=cells.snap_length((*path, "d"), entry.d, d.offset, d.variable),
        a=cells.length((*path, "a"), entry.a),
        alpha=cells.angle((*path, "alpha"), entry.alpha),
        limits=read_limits(cells, (*path, "limits"), kind, entry.limits),
        name=entry.name,
        couplings=read_couplings(cells, (*path, moving), (d if slides else theta).others, numbers),
    )


def _without_limits(cells: Cells, path: Path, entry: JointRow) -> JointRow:
    """A passive row; limits in it are reported: they are of a sum."""
    if entry.limits:
        message = "a row without q has no limits of its own: write those of the sum that it follows"
        cells.report.error((*path, "limits"), f"{message} under `limits` beside `joints`")
    return entry.model_copy(update={"limits": []})


def _check_variables(cells: Cells, path: Path, theta: Split, d: Split, *, complete: bool) -> None:
    """A row has a variable of its own, and others only beside it."""
    if theta.sign and d.sign:
        cells.report.error((*path, "d"), "q is already in theta: a joint has only one variable")
    elif (theta.sign and d.others) or (d.sign and theta.others):
        still, moving = ("d", "theta") if theta.sign else ("theta", "d")
        message = f"the variables of other joints stand beside q, in {moving}"
        cells.report.error((*path, still), message)
    elif theta.others and d.others:
        message = "without q a row turns or slides: the variables of other joints are in theta, too"
        cells.report.error((*path, "d"), message)
    elif complete and not (theta.sign or d.sign or theta.others or d.others):
        message = (
            "no variable: write q in theta (revolute) or in d (prismatic); a fixed "
            "transform belongs in base, tool or a neighbouring row"
        )
        cells.report.error(path, message)


def read_axis(cells: Cells, path: Path, entry: AxisRow, *, complete: bool) -> AxisJoint:
    """An axis in the reference position; mistakes are reported.

    Args:
        cells: Reads the cells, and reports.
        path: The place of the axis.
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
        name=entry.name,
    )


def _split(cells: Cells, path: Path, text: str, numbers: Mapping[int, int], row: int) -> Split:
    if (wrong := _no_other(text, numbers, row)) is not None:
        message, part = wrong
        cells.report.error(path, message, part=part)
        return Split(0, INVALID)
    others = [number for number in numbers if number != row]
    names = (VARIABLE.name, *(f"q{joint}" for joint in others))
    expression = cells.parse(path, text, more=dict.fromkeys(names, math.nan))
    parts = split(expression)
    if parts is None:
        message = "q may only have a sign and an offset: q, -q, q + pi/2, pi - q"
        if others:
            message += "; the variables of other joints may have factors, too: q - 2*q1"
        cells.report.error(path, message)
    return parts or Split(0, INVALID)


def _no_other(text: str, numbers: Mapping[int, int], row: int) -> tuple[str, Span] | None:
    """The mistake of a cell that calls its own variable, or a passive row's, by a number."""
    for found in _NUMBERED.finditer(text):
        number, part = int(found[1]), Span(found.start(), len(found[0]))
        if number == row:
            reason = f"the variable of this row is called q here: write q for {found[0]}"
            return f"{reason}; with its number it is called so in other rows", part
        if number not in numbers and 1 <= number <= max(numbers, default=0):
            return f"row {number} has no variable of its own: write what moves it", part
    return None
