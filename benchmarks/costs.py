"""What solving costs: the operations of the solvers of robots/, as the table in docs/costs.md.

    python -m benchmarks.costs [--arms NAME ...] [--write]

`--write` puts the table into docs/costs.md; of arms that are not named the lines there are kept.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from benchmarks.arms import CHECKOUT, robot_path
from benchmarks.options import parser, robot_names
from benchmarks.report import place, table
from dhgen.compiler import worked_out
from dhgen.program.count import count_operations
from dhgen.program.regular.regular import regular
from dhgen.program.walk import whole_arm
from dhgen.robot_files import RobotFile
from dhgen.workers import side_by_side

if TYPE_CHECKING:
    from collections.abc import Iterable

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
    _, module, _ = worked_out(RobotFile.read(robot_path(name)))
    return costs(name, module.solver)


def costs(name: str, solver: Program) -> list[Row]:
    """The lines of an arm: all poses, and regular ones; none where no steps solve it."""
    if whole_arm(solver) is not None:
        return []
    lines = [_line(name, str(solver.rows), "all", solver)]
    quick = regular(solver)
    return lines if quick is None else [*lines, _line("", "", "regular", quick.program)]


def _line(name: str, rows: str, poses: str, program: Program) -> Row:
    count = count_operations(program)
    numbers = (
        count.additions,
        count.multiplications,
        count.divisions,
        count.square_roots,
        count.arctangents,
        count.sines_cosines,
    )
    return (name, rows, poses, *map(str, numbers))


def written(text: str) -> dict[str, list[Row]]:
    """The lines that stand in a document, by arms."""
    inside = text.split(f"<!-- {MARK} -->")[1].split(f"<!-- /{MARK} -->", maxsplit=1)[0]
    found: dict[str, list[Row]] = {}
    name = ""
    for line in _lines(inside):
        name = line[0] or name
        found.setdefault(name, []).append(line)
    return found


def _lines(text: str) -> Iterable[Row]:
    rows = (line for line in text.splitlines() if line.startswith("|"))
    cells = (tuple(cell.strip() for cell in line.strip("|").split("|")) for line in rows)
    return [each for each in cells if each != HEAD and set(each[0]) != {"-"}]


if __name__ == "__main__":
    main(sys.argv[1:])
