"""What solving costs: the operations of the solvers of robots/, as the table in docs/costs.md.

    python -m benchmarks.costs [--arms NAME ...] [--write]

`--write` puts the table into docs/costs.md; of arms that are not named the lines there are kept.
"""

from __future__ import annotations

import sys
from dataclasses import astuple
from typing import TYPE_CHECKING

from benchmarks.arms import CHECKOUT, robot_path
from benchmarks.options import parser, robot_names
from benchmarks.report import place, placed, table
from dhgen.compiler import worked_out
from dhgen.program.count import count_operations
from dhgen.program.regular.regular import regular
from dhgen.program.walk import whole_arm
from dhgen.robot_files import RobotFile
from dhgen.workers import side_by_side

if TYPE_CHECKING:
    from dhgen.program.ir import Program

DOCUMENT = CHECKOUT / "docs" / "costs.md"
MARK = "costs"
HEAD = ("arm", "rows", "poses", "+ -", "×", "÷", "√", "atan2", "sin, cos")
Row = tuple[str, ...]


def main(arguments: list[str]) -> None:
    """Counts, prints the table and writes it if asked to."""
    options = parser("benchmarks.costs", __doc__).parse_args(arguments)
    new = dict(zip(options.arms, side_by_side(_of_file, options.arms), strict=True))
    known = written(DOCUMENT.read_text(encoding="utf-8"))
    rows = {**known, **new} if options.write else new
    text = table(HEAD, [row for name in robot_names() for row in rows.get(name, ())])
    print(f"\n{text}")
    if options.write:
        place(DOCUMENT, MARK, text)


def _of_file(name: str) -> list[Row]:
    _, module = worked_out(RobotFile.read(robot_path(name)))
    return costs(name, module.solver)


def costs(name: str, solver: Program) -> list[Row]:
    """The lines of an arm: all poses, and regular ones; none where no steps solve it."""
    if whole_arm(solver) is not None:
        return []
    lines = [_line(name, str(solver.rows), "all", solver)]
    quick = regular(solver)
    return lines if quick is None else [*lines, _line("", "", "regular", quick.program)]


def _line(name: str, rows: str, poses: str, program: Program) -> Row:
    return (name, rows, poses, *map(str, astuple(count_operations(program))))


def written(text: str) -> dict[str, list[Row]]:
    """The lines that stand in a document, by arms."""
    found: dict[str, list[Row]] = {}
    name = ""
    for row in placed(text, MARK):
        name = row[0] or name
        if row != HEAD:
            found.setdefault(name, []).append(row)
    return found


if __name__ == "__main__":
    main(sys.argv[1:])
