"""Arms without a closed form: how long a pose takes in C on the mean, and the slowest ones.

    python -m benchmarks.general6r [--arms NAME ...] [--poses N] [--write]

CPU time of one process, the generated C at -O3 -march=native, all solutions of random poses within
reach. Every pose is solved five times, in five passes over all of them; its least time counts, and
the quantiles are taken over the poses. Joints whose values the caller gives stand at zero, as they
mostly do, and once more at one radian. `--write` puts the table into docs/benchmarks.md.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from benchmarks.arms import Case, read_arm
from benchmarks.native import NATIVE, Interface, compiled
from benchmarks.options import parser, robot_names, show
from benchmarks.report import table, time_text
from benchmarks.solvers import GENERATED, ONE_SHIM, generated

if TYPE_CHECKING:
    from benchmarks.arms import Arm
    from dhgen.arrays import FloatArray

PASSES = 5
GIVEN = (0.0, 1.0)  # [rad]
GIVEN_SHIM = """#include "{name}.h"
static int solve(const double *T, double *q)
{{
    static const double given[] = {{ {given} }};
    unsigned char status[{rows}];
    return {name}_ik(T, given, NULL, (double (*)[{dof}])q, status);
}}
"""
HEAD = ("arm", "solutions", "mean", "median", "99 %", "slowest")


def main(arguments: list[str]) -> None:
    """Prints one line an arm."""
    options = parser("benchmarks.general6r", __doc__, general_arms())
    options.add_argument("--poses", type=int, default=1000)
    chosen = options.parse_args(arguments)
    rows = []
    for name in chosen.arms:
        arm = read_arm(Case(name, "general 6R"))
        for value in GIVEN if arm.robot.free else (0.0,):
            seconds, solutions = measure(arm, chosen.poses, value)
            times = [seconds.mean(), *np.quantile(seconds, [0.5, 0.99, 1.0])]
            title = f"{name}, joint {arm.robot.free[0]} at {value:g}" if arm.robot.free else name
            rows.append((title, f"{solutions:.2f}", *(time_text(1e9 * each) for each in times)))
            print(*rows[-1], flush=True)
    show(table(HEAD, rows), "general6r", write=chosen.write)


def general_arms() -> list[str]:
    """The arms whose C uses the general algorithm."""
    sources = {name: GENERATED / f"{name}.h" for name in robot_names()}
    return [
        name
        for name, source in sources.items()
        if source.exists() and '_METHOD "general 6R"' in source.read_text(encoding="utf-8")
    ]


def measure(arm: Arm, count: int, value: float) -> tuple[FloatArray, float]:
    """The time of every pose [s], and how many solutions there are on the mean.

    Args:
        arm: The arm.
        count: How many poses.
        value: Of the joints whose values the caller gives.
    """
    name, q = arm.case.name, arm.random_joints(count)
    q[:, [number - 1 for number in arm.robot.free]] = value
    T = np.ascontiguousarray(arm.model.pose(q))
    rows = generated(name).MAX_SOLUTIONS
    given = ", ".join([repr(value)] * len(arm.robot.free))
    shim = GIVEN_SHIM if given else ONE_SHIM
    text = shim.format(name=name, rows=rows, dof=arm.dof, given=given)
    interface = Interface(text, rows, arm.dof)
    with tempfile.TemporaryDirectory(prefix="dhgen-bench-") as folder:
        native = compiled(GENERATED / f"{name}.c", interface, NATIVE, Path(folder))
        return native.each(T, PASSES), sum(map(len, native.solve(T))) / count


if __name__ == "__main__":
    main(sys.argv[1:])
