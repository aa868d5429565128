"""Arms whose tables come at run time: how long a pose takes in C, and how many are left.

    python -m benchmarks.calibrated [--arms NAME ...] [--poses N] [--write]

Tables are those of data sheets with normal errors in every number. CPU time of one process, the C
of a kind of arms at -O3 -march=native, all solutions of random poses. Every pose is solved five
times, in five passes over all of them; its least time counts, and the quantiles are taken over the
poses. At how many poses a row of the nominal arm may end, so that they are left, stands beside it,
and the general algorithm alone. Solutions that only one of the two has are counted.
`--write` puts the table into docs/benchmarks.md.
"""

from __future__ import annotations

import ctypes
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from benchmarks.arms import robot_path
from benchmarks.native import NATIVE, Interface, compiled
from benchmarks.options import parser, show
from benchmarks.report import table, time_text
from dhgen.atomic_write import write_files
from dhgen.calibrated import kind_of
from dhgen.compiler import worked_out
from dhgen.nominal.nominal import left_poses
from dhgen.robot_files import RobotFile
from dhgen.runtime import c_runtime_files
from dhgen.runtime.python.calibration import LEFT, MARGIN, MOVED, RIGHT, TURNED
from dhgen.targets.c.calibrated import kind_files
from dhgen.targets.reserved import RESERVED
from dhgen.verify.calibrated import FleetArm, poses_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from benchmarks.native import Native
    from dhgen.arrays import FloatArray
    from dhgen.targets.calibrated import Kind

ARMS = ("ur5e", "puma560", "kuka_kr6_r900", "abb_irb120")
ERRORS = (1e-6, 1e-4, 1e-3)  # [rad, arm sizes]
PASSES = 5
SAME = 1e-6  # [rad] solutions that differ by less are one
SHIM = """#include "{name}.h"
static {name}_calibration arm;
void choose(const double *table);
void choose(const double *table)
{{
    {name}_calibrate(table, &arm);
}}
static int solve(const double *T, double *q)
{{
    unsigned char status[{rows}];
    return {name}_ik(&arm, T, NULL, (double (*)[{dof}])q, status);
}}
"""
HEAD = ("arm", "errors", "mean", "median", "99 %", "slowest", "left", "general alone", "differ")


def main(arguments: list[str]) -> None:
    """Prints one line an arm and an error."""
    options = parser("benchmarks.calibrated", __doc__, ARMS)
    options.add_argument("--poses", type=int, default=2000)
    chosen = options.parse_args(arguments)
    lines = []
    with tempfile.TemporaryDirectory(prefix="dhgen-bench-") as folder:
        write_files(Path(folder), c_runtime_files())
        for name in chosen.arms:
            kind = read_kind(name)
            write_files(Path(folder), kind_files(kind))
            solvers = [solver_of(kind, Path(folder), plain=plain) for plain in (False, True)]
            for error in ERRORS:
                lines.append((name, f"{error:g}", *measure(kind, solvers, error, chosen.poses)))
                print(*lines[-1], flush=True)
    show(table(HEAD, lines), "calibrated", write=chosen.write)


def read_kind(name: str) -> Kind:
    """The kind of arms of a robot file."""
    file = RobotFile.read(robot_path(name))
    return kind_of(file.robot, worked_out(file)[1], RESERVED)


def measure(kind: Kind, solvers: list[Native], error: float, count: int) -> tuple[str, ...]:
    """The cells of a line.

    Args:
        kind: The kind of the arm.
        solvers: Its C, and the general algorithm alone.
        error: The standard deviation of errors in its table [rad, arm sizes].
        count: How many poses.
    """
    source = np.random.default_rng(1)
    numbers = with_errors(kind, source, error)
    q = source.uniform(-np.pi, np.pi, (count, kind.module.chain.dof))
    T = poses_of(kind, numbers, q)
    for solver in solvers:
        choose(solver, numbers)
    own, plain = solvers
    seconds, alone = own.each(T, PASSES), plain.each(T, PASSES)
    rows, others = own.rows(T), plain.rows(T)
    left = np.mean(doubted_poses(kind, FleetArm(own.library, kind, numbers), T))
    differ = unlike(rows, others) + unlike(others, rows)
    times = [seconds.mean(), *np.quantile(seconds, [0.5, 0.99, 1.0])]
    told = [time_text(1e9 * each) for each in (*times, alone.mean())]
    return (*told[:4], f"{100.0 * left:.1f} %", told[4], str(differ))


def doubted_poses(kind: Kind, arm: FleetArm, T: FloatArray) -> NDArray[np.bool_]:
    """Which poses (N, 4, 4) of an arm are left, since a row of the nominal arm may end near by."""
    lower, of = [[0.0, 0.0, 0.0, 1.0]], arm.numbers
    left, right = (
        np.concatenate([of[place : place + 12].reshape(3, 4), lower]) for place in (LEFT, RIGHT)
    )
    apart = np.tile(of[MARGIN] * of[[TURNED, MOVED]], (len(T), 1))
    return left_poses(kind.regular, left @ T @ right, apart)


def with_errors(kind: Kind, source: np.random.Generator, error: float) -> FloatArray:
    """The table of the data sheet with normal errors in every number [rad, arm sizes]."""
    nominal, size = np.array(kind.table.rows), kind.nominal.chain.size
    errors = source.normal(0.0, error, nominal.shape) * [1.0, size, size, 1.0]
    return np.asarray(nominal + errors)


def choose(solver: Native, numbers: FloatArray) -> None:
    """Makes a table that of a solver's arm."""
    solver.library.choose(np.ascontiguousarray(numbers).ctypes.data_as(ctypes.c_void_p))


def solver_of(kind: Kind, folder: Path, *, plain: bool) -> Native:
    """The C of a kind as it lies in a folder; `plain` is the general algorithm alone."""
    name, rows, dof = kind.module.name, kind.module.solver.rows, kind.module.chain.dof
    interface = Interface(SHIM.format(name=name, rows=rows, dof=dof), rows, dof)
    flags = (f"-D{name.upper()}_PLAIN",) if plain else ()
    return compiled(folder / f"{name}.c", interface, (*NATIVE, *flags), folder)


def holding(rows: FloatArray) -> NDArray[np.bool_]:
    """Which rows (..., n) hold joint values."""
    return np.asarray(~np.isnan(rows).any(axis=-1))


def without_partner(rows: FloatArray, others: FloatArray, same: float) -> NDArray[np.bool_]:
    """Which rows (..., k, n) hold a solution that is not among others (..., l, n).

    Args:
        rows: NaN where there is none.
        others: Likewise.
        same: Solutions that differ by no more are one [rad].
    """
    missing = holding(rows)
    for i in range(others.shape[-2]):
        apart = rows - others[..., i : i + 1, :]
        off = np.abs(apart - 2.0 * np.pi * np.round(apart / (2.0 * np.pi)))
        missing &= ~(off.max(axis=-1) <= same)
    return missing


def unlike(rows: FloatArray, others: FloatArray) -> int:
    """How many solutions are not among others."""
    return int(without_partner(rows, others, SAME).sum())


if __name__ == "__main__":
    main(sys.argv[1:])
