"""What is noted of cells, beside each other where there are several of a kind.

The parameters that they use, exact values in their place, slips, degrees in a file of radians.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import takewhile
from typing import TYPE_CHECKING

from dhgen.robot.angles import is_half_turns
from dhgen.robot.expression import ZERO, Expression, Name, parts, to_text
from dhgen.robot.report import LEGS, within_leg
from dhgen.robot.source import quoted

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.robot.angles import Near
    from dhgen.robot.reader import Path
    from dhgen.robot.report import Report

FURTHEST = 6.3  # degrees; as radians, a turn, rounded
ALONE = 5  # so many notes of a kind are given one by one; of more the first, with a list


class UsedNames:
    """The names in the cells that have been read."""

    def __init__(self) -> None:
        self._arm: set[str] = set()
        self._of: dict[str, set[str]] = {}

    def note(self, path: Path, expression: Expression) -> None:
        """A cell has been read."""
        if path[0] == "parameters":
            self._of[str(path[1])] = names(expression)
        else:
            self._arm |= names(expression)

    def unused(self) -> tuple[str, ...]:
        """The parameters that no cell of the arm uses, not even by way of others."""
        used: set[str] = set()
        pending = sorted(self._arm)
        while pending:
            name = pending.pop()
            if name not in used:
                used.add(name)
                pending += self._of.get(name, ())
        return tuple(name for name in self._of if name not in used)


def names(expression: Expression) -> set[str]:
    """The names that occur."""
    return {part.name for part in parts(expression) if isinstance(part, Name)}


LISTS = ("joints", "axes")


@dataclass(frozen=True, slots=True)
class Taken:
    """Such a cell.

    Attributes:
        place: What it is: "a of joint 2".
        text: Its text.
        exact: The exact value that was meant.
    """

    place: str
    text: str
    exact: str


def taken(path: Path, text: str, variable: str, exact: Expression) -> Taken:
    """A cell and what it is taken as; `variable` is the joint's with its sign if it holds one."""
    value = to_text(exact)
    if variable and exact == ZERO:
        value = variable
    elif variable:
        sign = "-" if value.startswith("-") else "+"
        value = f"{variable} {sign} {value.removeprefix('-')}"
    return Taken(_place(path), text, value)


@dataclass(frozen=True, slots=True)
class NearCell:
    """A cell that nearly is an exact value, or an offset in it that is.

    Attributes:
        path: Where it is.
        text: Its text.
        near: What it nearly is.
        is_offset: Whether only the offset in it is.
    """

    path: Path
    text: str
    near: Near
    is_offset: bool = False


def note_slips(report: Report, cells: Sequence[NearCell]) -> None:
    """Reports angles that look like right angles written with too few digits."""
    if len(cells) > ALONE:
        head = f"{len(cells)} angles are nearly, but not exactly, multiples of a right angle"
        report.notice(cells[0].path, f"{head}: write {_listed(cells)}, if that is meant")
        return
    for cell in cells:
        off, of, written = cell.near
        what = "the offset of " * cell.is_offset + quoted(cell.text)
        message = f"{what} is {off:.1e} away from {of}: write {written} if that is meant"
        report.notice(cell.path, message)


def note_snapped(report: Report, cells: Sequence[NearCell]) -> None:
    """Reports cells in whose place an exact value is taken."""
    if len(cells) > ALONE:
        within = max(cell.near.off for cell in cells)
        head = f"{len(cells)} cells are within {within:.1e} of exact values"
        report.notice(cells[0].path, f"{head} and taken as these: {_listed(cells)}")
        return
    for cell in cells:
        off, of, _ = cell.near
        message = f"{quoted(cell.text)} is {off:.1e} away from {of} and taken as {of}"
        report.notice(cell.path, message)


@dataclass(frozen=True, slots=True)
class ManyTurns:
    """A plain number of many turns.

    Attributes:
        path: Where it is.
        message: The message about it alone.
        value: Its value [rad].
    """

    path: Path
    message: str
    value: float

    @property
    def may_be_degrees(self) -> bool:
        """Whether nobody would have meant radians: 62.83 rad are ten turns of a wrist."""
        return not is_half_turns(self.value)


def note_turns(report: Report, turned: Sequence[ManyTurns], *, in_radians: bool) -> None:
    """Reports angles of many turns; several are a mistake, unless the file asks for rad.

    Args:
        report: Where mistakes and notices go.
        turned: Such angles.
        in_radians: Whether the file names the unit.
    """
    doubtful = [each for each in turned if each.may_be_degrees]
    if len(doubtful) > 1 and not in_radians:
        path, message = doubtful[0].path, doubtful[0].message
        head = f"{message.split(':')[0]}, and {_more(len(doubtful) - 1)} many turns, too"
        units = "`units: {angle: deg}` if degrees are meant, `units: {angle: rad}` if not"
        report.error(path, f"{head}: write {units}")
        return
    joints: set[Path] = set()  # of whose ends one is reported: they are mended together
    for each in turned:
        limits = each.path[:-1]
        if limits not in joints:
            report.notice(each.path, each.message)
        if limits[-1] == "limits":
            joints.add(limits)


@dataclass(frozen=True, slots=True)
class PlainLimit:
    """An end of a turning joint's way that a file of degrees gives as a plain number.

    Attributes:
        path: Where it is.
        text: Its text.
        degrees: Its value.
    """

    path: Path
    text: str
    degrees: float


def note_tiny_limits(report: Report, limits: Sequence[PlainLimit]) -> None:
    """Reports an arm in degrees of which no joint can turn further than radians go.

    Twists in degrees beside limits in radians are not rare: these come from a URDF or a data sheet.
    One joint may be so narrow, and ends that hold pi or deg are as meant.
    """
    joints = {limit.path[:-1] for limit in limits}
    if len(joints) < 2 or not all(abs(limit.degrees) <= FURTHEST for limit in limits):
        return
    first = next((limit for limit in limits if limit.degrees), limits[0])
    most = max(abs(limit.degrees) for limit in limits)
    text, meant = quoted(first.text.strip()), math.degrees(first.degrees)
    message = f"all these limits are within {most:.4g} degrees: write {meant:.6g} for {text}"
    report.notice(first.path, f"{message}, and the others so, if they are in rad")


def _more(count: int) -> str:
    return "one more angle is of" if count == 1 else f"{count} more angles are of"


def _listed(cells: Sequence[NearCell]) -> str:
    """What to write for which texts, and where these are: pi/2 for '1.57' (alpha of joint 2)."""
    places: dict[tuple[str, str], list[str]] = {}
    for cell in cells:
        places.setdefault((cell.near.written, cell.text), []).append(_place(cell.path))
    return ", ".join(
        f"{written} for {quoted(text)} ({', '.join(where)})"
        for (written, text), where in places.items()
    )


def _place(path: Path) -> str:
    """The place of a cell: "a of joint 2", "entry 3 of xyz of tool", "entry 1,4 of tool"."""
    words: list[str] = []
    leg = f"leg {int(path[1]) + 1}" if path[0] == LEGS and len(path) > 2 else ""
    path = within_leg(path)
    if path[0] in LISTS:
        words.append(f"joint {int(path[1]) + 1}")
        path = path[2:]
    while path:
        numbers = list(takewhile(lambda step: isinstance(step, int), path))
        if numbers:
            words.append(f"entry {','.join(str(int(number) + 1) for number in numbers)}")
        else:
            words.append(str(path[0]))
        path = path[len(numbers) or 1 :]
    return " of ".join([*reversed(words), *([leg] if leg else [])])
