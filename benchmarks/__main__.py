"""dhgen and everybody else who solves such arms in closed form, on the same poses in one run.

    pip install '.[bench]'
    python -m benchmarks [--arms NAME ...] [--rounds N] [--poses N] [--write]

All solutions of a pose, CPU time of this process on one core; everybody takes short turns in
rotation, and the least and the median of a turn count. Every row is put through one forward model:
`found` is the share of the solutions that anybody found, `wrong` the share of rows that miss the
pose by more than 1e-6, `residual` the largest error of the others, `aligned` the share of poses
with all joints at multiples of a quarter turn that got an answer. Conversions between conventions
are done beforehand and are not measured. Who can't take part is listed with the reason.

`--write` puts the tables into docs/benchmarks.md and README.md and draws docs/benchmarks.svg.
"""

from __future__ import annotations

import os
import sys
import tempfile
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

# One core for everybody; libraries read this when they are imported.
os.environ.update(NUMBA_NUM_THREADS="1", OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")

from benchmarks.arms import CASES, read_arm
from benchmarks.options import parser
from benchmarks.quality import judge_all
from benchmarks.report import DOCUMENT, README, place
from benchmarks.results import (
    Entry,
    Result,
    arm_table,
    machine,
    summary_table,
    target_table,
)
from benchmarks.rivals import rivals
from benchmarks.rounds import time_all, try_all
from benchmarks.solvers import solvers
from dhgen.errors import RobotFileError

if TYPE_CHECKING:
    from argparse import Namespace

    from benchmarks.arms import Case

PICTURE = DOCUMENT.with_suffix(".svg")
CHECKED = 200  # poses whose answers are judged
ALIGNED = 64
WAYS = (
    ("C, scalar", "C, scalar"),
    ("C, one pose", "C, one pose"),
    ("AVX2", "C, one pose, AVX2"),
    ("C, batch", "C, batch"),
    ("`ik_into`", "Python, ik_into"),
    ("`ik_batch`", "Python, ik_batch"),
)


def main(arguments: list[str]) -> None:
    """Runs the comparison and prints it arm by arm."""
    options = _options(arguments)
    warnings.simplefilter("ignore")  # other people's deprecations
    print(f"{machine()}; {options.rounds} rounds\n")
    results = []
    for case in CASES:
        if case.name not in options.arms:
            continue
        try:
            result = compare(case, options.poses, options.rounds)
        except RobotFileError as error:
            print(f"### {case.name}\n\n- left out: {error.args[0]}\n", flush=True)
            continue
        results.append(result)
        print(f"### {case.name}: {case.kind}\n\n{arm_table(result)}\n", flush=True)
    print(f"### Targets\n\n{target_table(results)}\n\n{summary_table(results, WAYS)}")
    if options.write:
        write(results, options.rounds)


def compare(case: Case, poses: int, rounds: int) -> Result:
    """Everybody on one arm."""
    arm = read_arm(case)
    with tempfile.TemporaryDirectory(prefix="dhgen-bench-") as folder:
        theirs, absent = rivals(arm, Path(folder))
        ours, missing = solvers(arm, Path(folder))
        T = arm.random_poses(poses)
        everybody, broken = try_all(theirs + ours, T)
        timings = time_all(everybody, T, rounds)
        qualities = judge_all(arm, everybody, T[:CHECKED], arm.aligned_poses(ALIGNED))
    entries = tuple(map(Entry, everybody, timings, qualities))
    return Result(case, entries, (*absent, *missing, *broken))


def write(results: list[Result], rounds: int) -> None:
    """Puts the results into the documents."""
    from benchmarks.plot import draw  # noqa: PLC0415 - only who writes needs matplotlib

    parts = [f"{machine()}; {rounds} rounds."]
    parts += [f"### {r.case.name}: {r.case.kind}\n\n{arm_table(r)}" for r in results]
    place(DOCUMENT, "arms", "\n\n".join([*parts, f"### Targets\n\n{target_table(results)}"]))
    place(README, "benchmarks", summary_table(results, WAYS))
    draw(results, PICTURE)


def _options(arguments: list[str]) -> Namespace:
    options = parser("benchmarks", __doc__, [case.name for case in CASES])
    options.add_argument("--rounds", type=int, default=30)
    options.add_argument("--poses", type=int, default=1000)
    return options.parse_args(arguments)


if __name__ == "__main__":
    main(sys.argv[1:])
