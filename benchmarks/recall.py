"""Whether solvers find the joint values that made a pose, on very many random poses.

    python -m benchmarks.recall [--arms NAME ...] [--poses N] [--seeds S ...] [--write]

Arms are those of robots/ and, for each seed, one arm of every random structure: three axes that
meet or are parallel at each place, with all other joints turning and with each of them sliding.
Poses at which the Jacobian is singular to 1e-7 are not counted as lost. `--write` puts the table
into docs/benchmarks.md: arms that lost a pose or are not solved, and the totals.
"""

from __future__ import annotations

import os
import sys
import tempfile
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

# Every core has its own arm; the library reads this when it is imported.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from benchmarks.arms import robot_path
from benchmarks.options import parser, show
from benchmarks.report import table
from benchmarks.structures import write_structures
from dhgen.survey.sources import Source
from dhgen.survey.survey import survey_arm
from dhgen.workers import side_by_side

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.survey.table import Line

POSES = 200_000
SEEDS = (1, 2, 3)
HEAD = ("arms", "solved", "poses", "lost")


def main(arguments: list[str]) -> None:
    """Prints a line for each arm, and the table."""
    options_of = parser("benchmarks.recall", __doc__)
    options_of.add_argument("--poses", type=int, default=POSES, metavar="N")
    options_of.add_argument("--seeds", type=int, nargs="*", default=SEEDS, metavar="S")
    options = options_of.parse_args(arguments)
    with tempfile.TemporaryDirectory(prefix="dhgen-recall-") as folder:
        groups = {"robots/": [robot_path(name) for name in options.arms]}
        for seed in options.seeds:
            groups[f"random structures, seed {seed}"] = write_structures(Path(folder), seed)
        rows, faults = [], []
        for name, paths in groups.items():
            sources = [Source(path, path.stem) for path in paths]
            lines: list[Line] = []
            for line in side_by_side(partial(survey_arm, poses=1, recall=options.poses), sources):
                lines.append(line)
                print(*_told(line), sep="\n", flush=True)
            rows.append((name, *_totals(lines)))
            faults += [told for line in lines for told in _told(line)[1:]]
    text = table(("from", *HEAD), rows)
    show("\n".join([text, "", *(f"- {fault}" for fault in faults)]), "recall", write=options.write)


def _told(line: Line) -> list[str]:
    """What became of an arm; then each fault, or why there is no solver."""
    if line.answers is None:
        return [line.name, f"{line.name}: not solved: {line.reason}"]
    lost = line.answers.tried - line.answers.recalled
    faults = [fault for fault in line.answers.faults if fault.startswith("recall")]
    return [
        f"{line.name}: {line.answers.method}, {lost} of {line.answers.tried} lost",
        *(f"{line.name}: {fault}" for fault in faults),
    ]


def _totals(lines: Sequence[Line]) -> tuple[str, ...]:
    solved = [line.answers for line in lines if line.answers is not None]
    tried = sum(answers.tried for answers in solved)
    lost = tried - sum(answers.recalled for answers in solved)
    return tuple(map(str, (len(lines), len(solved), tried, lost)))


if __name__ == "__main__":
    main(sys.argv[1:])
