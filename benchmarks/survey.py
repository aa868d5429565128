"""How complete the solvers are: `dhgen survey` over robots/, as the table in the README.

    python -m benchmarks.survey [--arms NAME ...] [--poses N] [--write]

`--write` puts the table into the README; of arms that are not named the lines there are kept. CPU
time is from the robot file to the text of the solver.
"""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

# Every core has its own arm; the library reads this when it is imported.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from benchmarks.arms import robot_path
from benchmarks.options import parallel_names, parser, robot_names
from benchmarks.report import README, place, placed, table
from dhgen.survey.survey import survey
from dhgen.survey.table import HEAD, cells

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

MARK = "survey"
POSES = 200
SHORT = ("method", "arms", "found/expected", "spurious", "residual", "singular poses", "CPU s")
NAME, METHOD, CPU, FOUND, SPURIOUS, RESIDUAL, SINGULAR = (
    HEAD.index(name)
    for name in (
        "arm",
        "method",
        "CPU s",
        "found/expected",
        "spurious",
        "residual",
        "singular poses",
    )
)
Row = tuple[str, ...]


def main(arguments: list[str]) -> None:
    """Surveys, prints the table and writes it if asked to."""
    every = sorted([*robot_names(), *parallel_names()])
    options_of = parser("benchmarks.survey", __doc__, every)
    options_of.add_argument("--poses", type=int, default=POSES, metavar="N")
    options = options_of.parse_args(arguments)
    lines = survey([robot_path(name) for name in options.arms], options.poses, progress=print)
    new = {line.name: padded(cells(line)) for line in lines}
    known = {row[NAME]: row for row in written(README.read_text(encoding="utf-8"))}
    rows = {**known, **new} if options.write else new
    text = report([rows[name] for name in every if name in rows])
    print(f"\n{text}")
    if options.write:
        place(README, MARK, text)


def padded(row: Row) -> Row:
    """A line of all columns, also where there is no solver."""
    return (*row, *["-"] * (len(HEAD) - len(row)))


def written(text: str) -> list[Row]:
    """The arms' lines that stand in a document."""
    return [row for row in placed(text, MARK) if len(row) == len(HEAD) and row != HEAD]


def report(rows: Sequence[Row]) -> str:
    """Totals by method, and every arm's line."""
    return "\n".join(
        [
            table(SHORT, _totals(rows)),
            "",
            f"<details><summary>Every arm: {len(rows)}</summary>",
            "",
            table(HEAD, rows),
            "",
            "</details>",
        ]
    )


def _totals(rows: Sequence[Row]) -> list[Row]:
    """Of every method, and of all arms."""
    of = {row[NAME]: row[METHOD].split(":")[0] for row in rows}
    methods = [(name, [row for row in rows if of[row[NAME]] == name]) for name in set(of.values())]
    return [_total(name, group) for name, group in [*sorted(methods), ("all", list(rows))]]


def _total(name: str, rows: Sequence[Row]) -> Row:
    solved = [row for row in rows if row[FOUND] != "-"]
    return (
        name,
        str(len(rows)),
        _sum(row[FOUND] for row in solved),
        str(sum(int(row[SPURIOUS]) for row in solved)),
        max((row[RESIDUAL] for row in solved), key=float, default="-"),
        _sum(row[SINGULAR] for row in solved),
        max((row[CPU] for row in solved), key=float, default="-"),
    )


def _sum(shares: Iterable[str]) -> str:
    """3/4 and 5/5 are 8/9."""
    counts = [tuple(map(int, share.split("/"))) for share in shares]
    return "/".join(str(sum(column)) for column in zip((0, 0), *counts, strict=True))


if __name__ == "__main__":
    main(sys.argv[1:])
