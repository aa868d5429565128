"""Limits of sums of joints' variables, listed beside the joints."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.robot.angles import LARGEST_ANGLE, LARGEST_LENGTH
from dhgen.robot.cells import INVALID
from dhgen.robot.couplings import is_ratio, read_couplings
from dhgen.robot.expression import ZERO
from dhgen.robot.robot import JointKind, SumLimit
from dhgen.robot.source import quoted
from dhgen.robot.units import split

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dhgen.robot.cells import Cells
    from dhgen.robot.reader import Path
    from dhgen.robot.robot import Coupling
    from dhgen.robot.schema import SumEntry


def read_sum(
    cells: Cells,
    path: Path,
    entry: SumEntry,
    kinds: Sequence[JointKind],
    numbers: Mapping[int, int],
) -> SumLimit | None:
    """A sum and its limits; mistakes are reported.

    Args:
        cells: Reads the cells, and reports.
        path: The place of the entry.
        entry: Its keys.
        kinds: How the joints move.
        numbers: The joints' numbers by those of their rows.
    """
    terms = _terms(cells, (*path, "of"), entry.of, numbers)
    if not terms:
        return None
    moving = {kinds[term.joint - 1] for term in terms}
    if len(moving) > 1:
        message = f"{quoted(entry.of.strip())} adds angles to lengths: a sum is of one of both"
        cells.report.error((*path, "of"), message)
        return None
    (kind,) = moving
    if kind is JointKind.REVOLUTE and not all(is_ratio(cells, term.factor) for term in terms):
        message = "angles are added in ratios of whole numbers: q2 + q3, q2 - 1/2*q3"
        cells.report.error((*path, "of"), message)
    low = _end(cells, (*path, "from"), entry.least, kind)
    high = _end(cells, (*path, "to"), entry.most, kind)
    if low >= high:
        message = f"the lower limit {entry.least.strip()} is not below {entry.most.strip()}"
        cells.report.error((*path, "from"), message)
    return SumLimit(terms, (low, high), kind)


def check_once(
    cells: Cells,
    path: Path,
    limit: SumLimit,
    others: tuple[Sequence[SumLimit], Sequence[tuple[float, float] | None]],
) -> None:
    """Reports limits of what has some already: the same sum, or a single drive in its row.

    Args:
        cells: Reports.
        path: The place of the entry.
        limit: Its contents.
        others: The sums before it, and the limits in the joints' rows.
    """
    sums, rows = others
    terms = _values(limit)
    if any(_values(each) == terms for each in sums):
        cells.report.error(
            (*path, "of"), "this sum has limits in an entry above: leave one of both"
        )
    elif len(terms) == 1 and rows[limit.of[0].joint - 1] is not None:
        message = "a single variable has its limits in its row, and this one has some there"
        cells.report.error((*path, "of"), message)


def _values(limit: SumLimit) -> set[tuple[int, float]]:
    return {(term.joint, term.value) for term in limit.of}


def _terms(cells: Cells, path: Path, text: str, numbers: Mapping[int, int]) -> tuple[Coupling, ...]:
    names = [f"q{row}" for row in numbers]
    expression = cells.parse(path, text, more=dict.fromkeys(names, math.nan))
    if expression == INVALID:
        return ()
    found = split(expression)
    if found is None or found.offset != ZERO or not any(map(cells.value, found.others.values())):
        message = f"{quoted(text.strip())} is no sum of joints' variables: q2 + q3, q2 - 1/2*q3"
        cells.report.error(path, message)
        return ()
    return read_couplings(cells, path, found.others, numbers)


def _end(cells: Cells, path: Path, text: str, kind: JointKind) -> float:
    turns = kind is JointKind.REVOLUTE
    expression = cells.parse(path, text)
    value = cells.value(cells.radians(expression) if turns else expression)
    if turns:
        cells.note_unit(path, text, expression)
    else:
        cells.refuse_degrees(path, text, expression)
    if abs(value) > (LARGEST_ANGLE if turns else LARGEST_LENGTH):
        cells.report.error(path, f"{quoted(text.strip())} limits nothing: it is too far away")
    return value
