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

from benchmarks.arms import BESIDE, Case, read_arm, robot_path
from benchmarks.native import NATIVE, Interface, compiled
from benchmarks.options import parser, robot_names, show
from benchmarks.report import table, time_text
from benchmarks.solvers import GENERATED, ONE_SHIM, generated
from dhgen.atomic_write import write_files
from dhgen.compiler import worked_out
from dhgen.robot_files import RobotFile
from dhgen.runtime import c_runtime_files
from dhgen.targets.emit import emit

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
    """The arms whose C uses the general algorithm, and those that are measured alone."""
    sources = {name: GENERATED / f"{name}.h" for name in robot_names()}
    general = [
        name
        for name, source in sources.items()
        if source.exists() and '_METHOD "general 6R"' in source.read_text(encoding="utf-8")
    ]
    return sorted([*general, *(path.stem for path in BESIDE.glob("*.yaml"))])


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
    given = ", ".join([repr(value)] * len(arm.robot.free))
    shim = GIVEN_SHIM if given else ONE_SHIM
    with tempfile.TemporaryDirectory(prefix="dhgen-bench-") as folder:
        source, rows = source_of(name, Path(folder))
        text = shim.format(name=name, rows=rows, dof=arm.dof, given=given)
        native = compiled(source, Interface(text, rows, arm.dof), NATIVE, Path(folder))
        return native.each(T, PASSES), sum(map(len, native.solve(T))) / count


def source_of(name: str, folder: Path) -> tuple[Path, int]:
    """The C of an arm, made in the folder where it is not among the generated, and its rows."""
    path = GENERATED / f"{name}.c"
    if path.exists():
        return path, generated(name).MAX_SOLUTIONS
    _, module = worked_out(RobotFile.read(robot_path(name)))
    write_files(folder, {**c_runtime_files(), **emit(module, None, None)})
    return folder / path.name, module.solver.rows


if __name__ == "__main__":
    main(sys.argv[1:])
