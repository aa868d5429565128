"""Poses where arms are singular, or nearly: how long they take in C, and the slowest ones.

    python -m benchmarks.singular [--arms NAME ...] [--poses N] [--write]

At most of them a careful solver looks for the value that a free joint can have, puts joints on
their limits, and finds the solution next to the seed. CPU time of one process, the generated C at
-O3 -march=native, all solutions, with the joint values that belong to the pose as the seed. The
poses are those of the survey: joints at multiples of a quarter turn, on limits, or moved until the
Jacobian loses rank, and 1e-10 to 1e-3 rad beside. Every pose is solved five times, in five passes
over all of them; its least time counts. `--write` puts the table into docs/benchmarks.md.
"""

from __future__ import annotations

import ctypes
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from benchmarks.arms import Case, read_arm
from benchmarks.native import NATIVE, Interface, compiled
from benchmarks.options import parser, show
from benchmarks.report import table, time_text
from benchmarks.solvers import GENERATED, generated
from dhgen.oracle.arm_angle import given_values
from dhgen.survey.singular import singular_sets

if TYPE_CHECKING:
    from benchmarks.arms import Arm
    from dhgen.arrays import FloatArray

PASSES = 5
# A pose is one of those asked for: where it stands among them says what belongs to it.
SHIM = """#include "{name}.h"
static const double *asked, *values, *seeds;
void bench_asked(const double *T, const double *given, const double *q);
void bench_asked(const double *T, const double *given, const double *q)
{{
    asked = T;
    values = given;
    seeds = q;
}}
static int solve(const double *T, double *q)
{{
    const size_t k = (size_t)(T - asked) / 16;
    unsigned char status[{rows}];
    return {name}_ik(T, {given}seeds + {dof} * k, (double (*)[{dof}])q, status);
}}
"""
HEAD = ("arm", "method", "poses", "median", "99 %", "slowest")


def main(arguments: list[str]) -> None:
    """Prints one line an arm."""
    options = parser("benchmarks.singular", __doc__)
    options.add_argument("--poses", type=int, default=30, help="of each kind")
    chosen = options.parse_args(arguments)
    rows = []
    for name in chosen.arms:
        seconds = measure(read_arm(Case(name, "")), chosen.poses)
        times = (time_text(1e9 * each) for each in np.quantile(seconds, [0.5, 0.99, 1.0]))
        rows.append((name, generated(name).METHOD, str(len(seconds)), *times))
        print(*rows[-1], flush=True)
    show(table(HEAD, rows), "singular", write=chosen.write)


def measure(arm: Arm, count: int) -> FloatArray:
    """The time of every pose [s], of at most so many poses of each kind."""
    name = arm.case.name
    q = np.concatenate(list(singular_sets(arm.robot, count).values()))
    T, given = (np.ascontiguousarray(each) for each in (arm.model.pose(q), _given(arm, q)))
    rows, width = generated(name).MAX_SOLUTIONS, given.shape[-1]
    values = f"values + {width} * k, " if width else ""
    text = SHIM.format(name=name, rows=rows, dof=arm.dof, given=values)
    with tempfile.TemporaryDirectory(prefix="dhgen-bench-") as folder:
        source = GENERATED / f"{name}.c"
        native = compiled(source, Interface(text, rows, arm.dof), NATIVE, Path(folder))
        native.library.bench_asked(*map(_pointer, (T, given, q)))
        return native.each(T, PASSES)


def _given(arm: Arm, q: FloatArray) -> FloatArray:
    return np.asarray(given_values(arm.robot, q), dtype=float)


def _pointer(array: FloatArray) -> ctypes.c_void_p:
    return array.ctypes.data_as(ctypes.c_void_p)


if __name__ == "__main__":
    main(sys.argv[1:])
