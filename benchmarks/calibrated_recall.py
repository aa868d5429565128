"""Whether solvers whose tables come at run time find all solutions, on very many random poses.

    python -m benchmarks.calibrated_recall [--arms NAME ...] [--poses N] [--write]

Every arm of six joints whose nominal one has a closed form, each with four tables: that of the
data sheet with normal errors in every number. Lost are poses whose own joint values are not among
the rows; `lacks` and `more` count solutions that only the general algorithm alone or only the
solver has, `wrong` the rows that miss their pose, by a forward model that shares nothing with
either. `--write` puts the table into docs/benchmarks.md.
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

import numpy as np

from benchmarks.calibrated import (
    choose,
    holding,
    read_kind,
    solver_of,
    with_errors,
    without_partner,
)
from benchmarks.options import parser, show
from benchmarks.report import table
from dhgen.atomic_write import write_files
from dhgen.errors import DhgenError
from dhgen.runtime import c_runtime_files
from dhgen.targets.c.calibrated import kind_files
from dhgen.verify.calibrated import poses_of
from dhgen.workers import side_by_side

if TYPE_CHECKING:
    from benchmarks.native import Native
    from dhgen.arrays import FloatArray
    from dhgen.targets.calibrated import Kind

POSES = 200_000
ERRORS = (1e-6, 1e-5, 1e-4, 1e-3)  # [rad, arm sizes]
AT_ONCE = 2000  # poses
# Solutions that differ by no more are one [rad]: the root of what a row may miss its pose by.
SAME = 1e-5
MEETS = 1e-9  # [rad, arm sizes] a row that misses its pose by more is wrong
HEAD = ("arm", "errors", "poses", "solutions", "lost", "lacks", "more", "wrong")


def main(arguments: list[str]) -> None:
    """Prints a line for each arm and error, and the table."""
    options = parser("benchmarks.calibrated_recall", __doc__)
    options.add_argument("--poses", type=int, default=POSES, metavar="N")
    chosen = options.parse_args(arguments)
    lines = []
    for found in side_by_side(partial(recalled, count=chosen.poses), chosen.arms):
        lines += found
        for line in found:
            print(*line, flush=True)
    counts = np.array([line[2:] for line in lines], dtype=int).reshape(-1, len(HEAD) - 2)
    total = (f"{len(lines)} tables", "", *map(str, counts.sum(axis=0)))
    show(table(HEAD, [*lines, total]), "calibrated recall", write=chosen.write)


def recalled(name: str, count: int) -> list[tuple[str, ...]]:
    """The lines of an arm; none where it has no nominal closed form."""
    try:
        kind = read_kind(name)
    except DhgenError:
        return []
    with tempfile.TemporaryDirectory(prefix="dhgen-recall-") as folder:
        write_files(Path(folder), {**c_runtime_files(), **kind_files(kind)})
        own, alone = (solver_of(kind, Path(folder), plain=plain) for plain in (False, True))
        return [(name, f"{error:g}", *_counts(kind, own, alone, error, count)) for error in ERRORS]


def _counts(kind: Kind, own: Native, alone: Native, error: float, count: int) -> tuple[str, ...]:
    """The numbers of a line, from the third on."""
    source = np.random.default_rng(2)
    numbers = with_errors(kind, source, error)
    for solver in (own, alone):
        choose(solver, numbers)
    total = np.zeros(len(HEAD) - 2, dtype=int)
    for start in range(0, count, AT_ONCE):
        q = source.uniform(-np.pi, np.pi, (min(AT_ONCE, count - start), kind.module.chain.dof))
        T = poses_of(kind, numbers, q)
        rows, others = own.rows(T), alone.rows(T)
        total += (
            len(q),
            holding(rows).sum(),
            without_partner(q[:, None], rows, SAME).sum(),
            without_partner(others, rows, SAME).sum(),
            without_partner(rows, others, SAME).sum(),
            wrong_rows(kind, numbers, T, rows),
        )
    return tuple(map(str, total))


def wrong_rows(kind: Kind, numbers: FloatArray, T: FloatArray, rows: FloatArray) -> int:
    """How many rows miss their pose."""
    held = holding(rows)
    miss = np.abs(poses_of(kind, numbers, rows[held]) - np.repeat(T, held.sum(axis=1), axis=0))
    miss[:, :3, 3] /= kind.nominal.chain.size
    return int((miss.max(axis=(1, 2), initial=0.0) > MEETS).sum())


if __name__ == "__main__":
    main(sys.argv[1:])
