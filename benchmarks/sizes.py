"""What the generated files weigh, and what compiling them takes: CPU time of gcc and of numba.

    python -m benchmarks.sizes [--arms NAME ...] [--numba [NAME ...]] [--write]

C is compiled with -O3 -march=native, the object is measured without symbols. numba starts from an
empty cache; `ik_all` is the first call of one pose, `ik_into` and `ik_batch` the first calls of
theirs after it, `all` what `warm_up` adds to these, and `cached` all of it in another process. That
takes 5 to 40 s an arm, half an hour for all of robots/; it is done for the arms that `--numba`
names, for all without it. `--write` puts the table into docs/benchmarks.md.
"""

from __future__ import annotations

import math
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from benchmarks.native import NATIVE
from benchmarks.options import parser, robot_names, show
from benchmarks.report import table
from benchmarks.solvers import GENERATED
from dhgen.verify.native import c_compiler

FIRST_CALLS = """
import sys, time
sys.path.insert(0, sys.argv[1])
import numpy, numba
from importlib import import_module
solver = import_module(sys.argv[2])
count = 1 if hasattr(solver, "arm_angle") else len(getattr(solver, "FREE_JOINTS", ()))
free = [numpy.zeros(count)] if count else []
T = solver.fk(numpy.full(solver.DOF, 0.3))
times = [time.process_time()]
q, status = solver.ik_all(T, *free)
times.append(time.process_time())
solver.ik_into(T, *free, q, status)
times.append(time.process_time())
solver.ik_batch(T[None], *(each[None] for each in free))
times.append(time.process_time())
solver.warm_up()
times.append(time.process_time())
print(*numpy.diff(times))
"""
CALLS = ("ik_all", "ik_into", "ik_batch", "all", "cached")
HEAD = ("arm", "C source", "gcc", "object", "Python source", *CALLS)


def main(arguments: list[str]) -> None:
    """Prints one line an arm, and the largest of everything."""
    allowed = parser("benchmarks.sizes", __doc__)
    names = robot_names()
    allowed.add_argument("--numba", nargs="*", choices=names, default=names, metavar="NAME")
    options = allowed.parse_args(arguments)
    measured = {}
    for name in options.arms:
        measured[name] = measure(name, with_numba=name in options.numba)
        print(name, *_texts(measured[name]), flush=True)
    largest = tuple(np.nanmax(list(measured.values()), axis=0))
    rows = [(name, *_texts(each)) for name, each in measured.items()]
    show(table(HEAD, [*rows, ("largest", *_texts(largest))]), "sizes", write=options.write)


def measure(name: str, *, with_numba: bool) -> tuple[float, ...]:
    """Bytes of C, seconds of gcc, bytes of machine code, bytes of Python, seconds of numba.

    NaN stands for what is not measured.
    """
    with tempfile.TemporaryDirectory(prefix="dhgen-bench-") as folder:
        return (
            float((GENERATED / f"{name}.c").stat().st_size),
            *_compiled(name, Path(folder)),
            float((GENERATED / f"{name}.py").stat().st_size),
            *(_first_calls(name, folder) if with_numba else (math.nan,) * len(CALLS)),
        )


def _compiled(name: str, folder: Path) -> tuple[float, float]:
    compiler = c_compiler()
    if compiler is None:
        return math.nan, math.nan
    made = folder / f"{name}.o"
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [compiler, *NATIVE, "-s", "-c", str(GENERATED / f"{name}.c"), "-o", str(made)]
    subprocess.run(command, check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    took = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return took, float(made.stat().st_size)


def _first_calls(name: str, folder: str) -> tuple[float, ...]:
    """Seconds of the first calls without a cache, and of all of them with one."""
    made, kept = (_in_a_process(name, folder) for _ in range(2))
    return *made, sum(kept)


def _in_a_process(name: str, folder: str) -> tuple[float, ...]:
    done = subprocess.run(
        [sys.executable, "-c", FIRST_CALLS, str(GENERATED), name],
        env={**os.environ, "NUMBA_CACHE_DIR": folder},
        capture_output=True,
        text=True,
        check=True,
    )
    return tuple(map(float, done.stdout.split()))


def _texts(values: tuple[float, ...]) -> tuple[str, ...]:
    units = (("kB", 1e3, 1), ("s", 1.0, 2), ("kB", 1e3, 1), ("kB", 1e3, 1), ("s", 1.0, 1))
    return tuple(
        "-" if math.isnan(value) else f"{value / size:.{digits}f} {unit}"
        for value, (unit, size, digits) in zip(
            values, [*units[:-1], *[units[-1]] * len(CALLS)], strict=True
        )
    )


if __name__ == "__main__":
    main(sys.argv[1:])
