"""Passive rows: the drives of other joints move them, `theta: -q3`; they have none of their own."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from dhgen.robot.angles import exact_angle, twelfths
from dhgen.robot.couplings import LARGEST_WHOLE
from dhgen.robot.exact import add, multiply, number
from dhgen.robot.expression import Name, evaluate, parts
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.robot.cells import Cells
    from dhgen.robot.expression import Expression
    from dhgen.robot.reader import Path
    from dhgen.robot.robot import Coupling, DhRow

_VARIABLE = re.compile(r"\bq(\d*)\b", re.ASCII)
MOST_TIMES = 8  # that a passive slide follows another: more stages no telescope has


@dataclass(frozen=True, slots=True)
class Followed:
    """What a passive row follows.

    Attributes:
        terms: The joints, from 1, whose angles or lengths add up to the row's, and how often.
        offset: What is added to them.
    """

    terms: tuple[tuple[int, Fraction], ...]
    offset: Expression


def is_passive(row: object, number: int, count: int) -> bool:
    """Whether a row as written holds variables of other rows, and none of its own.

    Its own one is q; who calls it by its number has made a mistake.

    Args:
        row: Its cells.
        number: Which row it is, from 1.
        count: How many there are.
    """
    if not isinstance(row, dict):
        return False
    held = set(_VARIABLE.findall(" ".join(str(row.get(cell, "")) for cell in ("theta", "d"))))
    others = {str(other) for other in range(1, count + 1)}
    return not held.isdisjoint(others) and held.isdisjoint({"", str(number)})


def followed(row: DhRow, driven: Sequence[DhRow]) -> Followed:
    """The angle or length of a passive row, by the joints' angles and lengths.

    The values of the drives are replaced, one after another, by what they are of the angles and
    lengths: a drive that moves no other joint of those that are left comes first.

    Args:
        row: A passive one.
        driven: The joints, of which none hangs on itself.
    """
    left = {each.joint: _ratio(each) for each in row.couplings}
    terms: dict[int, Fraction] = {}
    offset = row.offset
    while left:
        joint = next(j for j in sorted(left) if not _moves_one_of(j, left, driven))
        own = driven[joint - 1]
        times = left.pop(joint) * own.sign
        if not times:
            continue
        terms[joint] = times
        offset = add(offset, multiply(number(-times), own.offset))
        for each in own.couplings:
            left[each.joint] = left.get(each.joint, Fraction(0)) - times * _ratio(each)
    return Followed(tuple(sorted(terms.items())), _simple(offset))


def _simple(offset: Expression) -> Expression:
    """Multiples of pi/12 that are added up as one."""
    if any(isinstance(part, Name) for part in parts(offset)):
        return offset
    k = twelfths(evaluate(offset, {}))
    return offset if k is None else exact_angle(k)


def _moves_one_of(joint: int, left: dict[int, Fraction], driven: Sequence[DhRow]) -> bool:
    """Whether a drive has a share, by way of others too, in one of some joints."""
    pending, seen = [each for each in left if each != joint], {joint}
    while pending:
        other = pending.pop()
        shares = [each.joint for each in driven[other - 1].couplings]
        if joint in shares:
            return True
        pending += [each for each in shares if each not in seen]
        seen.update(shares)
    return False


def _ratio(coupling: Coupling) -> Fraction:
    """A factor as the ratio of whole numbers that it is."""
    return Fraction(coupling.value).limit_denominator(LARGEST_WHOLE)


def check_passive(cells: Cells, path: Path, row: DhRow) -> None:
    """Reports a passive row that does not move.

    Args:
        cells: Reports.
        path: The place of the row.
        row: The row.
    """
    if not row.couplings:
        cell = (*path, "theta" if row.kind is JointKind.REVOLUTE else "d")
        cells.report.error(cell, "this row does not move: what it follows is taken zero times")


def why_apart(place: int, rows: Sequence[DhRow]) -> str:
    """What makes a passive row's equations unlike the joints'; empty if nothing does.

    Args:
        place: Which row it is, from zero.
        rows: All rows, none of which hangs on itself.
    """
    row, driven = rows[place], [each for each in rows if each.sign]
    turns = row.kind is JointKind.REVOLUTE
    if {driven[each.joint - 1].kind for each in row.couplings} != {row.kind}:
        what = "an angle that follows a length" if turns else "a length that follows an angle"
        return f"{what} makes the equations transcendental where it has no q of its own"
    found = followed(row, driven)
    before = sum(bool(each.sign) for each in rows[:place])
    if any(joint > before for joint, _ in found.terms):
        return "a row without q follows joints before it, and this one follows a joint behind it"
    most = 1 if turns else MOST_TIMES
    for _, times in found.terms:
        if times.denominator > 1 or abs(times) > most:
            what = "angle" if turns else "length"
            reason = "makes the equations of another degree" if turns else "is out of proportion"
            return (
                f"without q the {what} follows that of another joint {times} times, which {reason}"
            )
    return ""
