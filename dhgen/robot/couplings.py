"""Couplings: other joints' variables in a row, and what is wrong with those of all rows."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.exact import rational
from dhgen.robot.robot import Coupling, JointKind

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dhgen.robot.cells import Cells
    from dhgen.robot.expression import Expression
    from dhgen.robot.reader import Path
    from dhgen.robot.robot import DhRow

LARGEST_FACTOR = 1e6  # beyond, a drive's rounding would be the other joint's turn
LARGEST_WHOLE = 10**6  # of a ratio: gears have fewer teeth


def numbers_of(rows: Sequence[int]) -> dict[int, int]:
    """The joints' numbers by their rows' numbers, as cells have them: passive rows are no joints.

    Args:
        rows: The numbers, from 1, of all rows with a variable of their own.
    """
    return {row: joint for joint, row in enumerate(rows, start=1)}


def read_couplings(
    cells: Cells, path: Path, factors: Mapping[int, Expression], numbers: Mapping[int, int]
) -> tuple[Coupling, ...]:
    """The multiples of other joints' variables in a cell; mistakes are reported.

    Args:
        cells: Reads the cells, and reports.
        path: The place of the cell.
        factors: What multiplies the variable of each row, from 1.
        numbers: The joints' numbers by those of their rows.
    """
    found = []
    for row, factor in sorted(factors.items()):
        value = cells.value(factor)
        if not abs(value) <= LARGEST_FACTOR:
            message = f"q{row} is taken {value:.6g} times: at most {LARGEST_FACTOR:.0e} can be"
            cells.report.error(path, message)
        elif value:
            found.append(Coupling(numbers[row], factor, value))
    return tuple(found)


def check_couplings(
    cells: Cells, table: Path, rows: Sequence[DhRow], numbers: Sequence[int]
) -> bool:
    """Reports couplings that are no ratio, and joints that hang on each other in a circle.

    Args:
        cells: Reports.
        table: The place of the table.
        rows: The table.
        numbers: The numbers, from 1, of all rows with a variable of their own.

    Returns:
        Whether all is well.
    """
    cell = {JointKind.REVOLUTE: "theta", JointKind.PRISMATIC: "d"}
    paths: list[Path] = [(*table, place, cell[row.kind]) for place, row in enumerate(rows)]
    checked = [
        _has_ratio(cells, path, (row, rows[numbers[coupling.joint - 1] - 1]), coupling, numbers)
        for path, row in zip(paths, rows, strict=True)
        for coupling in row.couplings
    ]
    circle = _circle({j: rows[row - 1].couplings for j, row in enumerate(numbers, start=1)})
    if circle:
        along = [numbers[joint - 1] for joint in circle]
        links = ", ".join(
            f"joint {a} by q{b}" for a, b in zip(along, [*along[1:], along[0]], strict=True)
        )
        message = f"these joints are moved by each other's drives: {links}"
        end = "one of them has to be moved by its own drive alone"
        cells.report.error(paths[along[0] - 1], f"{message}; {end}")
    return all(checked) and not circle


def _has_ratio(
    cells: Cells,
    path: Path,
    rows: tuple[DhRow, DhRow],
    coupling: Coupling,
    numbers: Sequence[int],
) -> bool:
    """Turns by turns are in a ratio of whole numbers, or else whole turns would never meet."""
    turns = all(row.kind is JointKind.REVOLUTE for row in rows)
    if not turns or is_ratio(cells, coupling.factor):
        return True
    times = f"q{numbers[coupling.joint - 1]} is taken {coupling.value:.6g} times"
    message = (
        f"{times}, but an angle follows another one in a ratio of whole numbers: write the teeth "
        "of the gears, e.g. 3/2*q2"
    )
    cells.report.error(path, message)
    return False


def is_ratio(cells: Cells, factor: Expression) -> bool:
    """Whether a factor is one of whole numbers that a gear may have."""
    ratio = rational(factor, cells.ratios)
    return ratio is not None and max(abs(ratio.numerator), ratio.denominator) <= LARGEST_WHOLE


def _circle(couplings: Mapping[int, Sequence[Coupling]]) -> list[int]:
    """Joints each of which is moved by the drive of the next, and the last by the first one's."""
    done: set[int] = set()
    for first in couplings:
        way, pending = [first], [iter(couplings[first])]
        while pending:
            step = next(pending[-1], None)
            if step is None:
                done.add(way.pop())
                pending.pop()
            elif step.joint in way:
                return way[way.index(step.joint) :]
            elif step.joint not in done:
                way.append(step.joint)
                pending.append(iter(couplings[step.joint]))
    return []
