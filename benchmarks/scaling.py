"""Cost and memory from one pose to ten million.

    python -m benchmarks.scaling [--arms NAME ...] [--most N] [--write]

Batches of growing size through the generated C and through numba, on one core. Poses and answers
stay in arrays of at most BLOCK poses, as a caller that handles millions would keep them; `grown`
is by how much the largest memory of the process grew since the first line. `--write` puts the
table into docs/benchmarks.md.
"""

from __future__ import annotations

import ctypes
import os
import resource
import sys
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

os.environ.update(NUMBA_NUM_THREADS="1")

import numpy as np

from benchmarks.arms import CASES, read_arm
from benchmarks.native import NATIVE, Interface, compiled
from benchmarks.options import parser, show
from benchmarks.report import table, time_text
from benchmarks.solvers import GENERATED, generated

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.arrays import FloatArray


BLOCK = 100_000
LEAST = 0.05  # seconds that a measurement of few poses should take together
NOTHING = "static int solve(const double *T, double *q) { (void)T; (void)q; return 0; }"
HEAD = ("poses", "C", "a pose", "grown", "numba", "a pose", "grown")


def main(arguments: list[str]) -> None:
    """Prints one line for each number of poses."""
    options = parser("benchmarks.scaling", __doc__, [case.name for case in CASES])
    options.set_defaults(arms=["kuka_kr6_r900"])
    options.add_argument("--most", type=int, default=10_000_000)
    chosen = options.parse_args(arguments)
    parts = [f"{name}\n\n{grown(name, chosen.most)}" for name in chosen.arms]
    show("\n\n".join(parts), "scaling", write=chosen.write)


def grown(name: str, most: int) -> str:
    """The table of an arm."""
    T = read_arm(next(case for case in CASES if case.name == name)).random_poses(BLOCK)
    with tempfile.TemporaryDirectory(prefix="dhgen-bench-") as folder:
        in_c = _grow(_native(name, T, Path(folder)), most)
        in_python = _grow(_numba(name, T), most)
    rows = [(f"{c[0]:,}", *c[1:], *p[1:]) for c, p in zip(in_c, in_python, strict=True)]
    return table(HEAD, rows)


def _grow(solve: Callable[[int], None], most: int) -> list[tuple[Any, ...]]:
    """Poses, and as text the time, the time a pose, and the memory, for 1, 10, 100 ..."""
    solve(BLOCK)
    memory = _memory()
    rows, count = [], 1
    while count <= most:
        took = _time(solve, count)
        grown = f"{(_memory() - memory) / 1e6:.1f} MB"
        rows.append((count, time_text(1e9 * took), time_text(1e9 * took / count), grown))
        count *= 10
    return rows


def _time(solve: Callable[[int], None], count: int) -> float:
    """CPU seconds for that many poses; the least of several tries where there is time for them."""
    best, spent = float("inf"), 0.0
    while spent < LEAST:
        start = time.process_time()
        solve(count)
        took = time.process_time() - start
        best, spent = min(best, took), spent + max(took, 1e-6)
    return best


def _memory() -> float:
    """The largest resident memory of this process so far, in bytes."""
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return float(peak if sys.platform == "darwin" else 1024 * peak)


def _blocks(count: int) -> list[int]:
    whole, rest = divmod(count, BLOCK)
    return [BLOCK] * whole + ([rest] if rest else [])


def _native(name: str, T: FloatArray, folder: Path) -> Callable[[int], None]:
    """The C's batch, on the caller's arrays."""
    module = generated(name)
    library = compiled(GENERATED / f"{name}.c", Interface(NOTHING, 1, 1), NATIVE, folder).library
    batch = library[f"{name}_ik_batch"]
    batch.restype = None
    q = np.zeros((BLOCK, module.MAX_SOLUTIONS, module.DOF))
    status = np.zeros((BLOCK, module.MAX_SOLUTIONS), np.uint8)
    pointers = [array.ctypes.data_as(ctypes.c_void_p) for array in (T, q, status)]

    def solve(count: int) -> None:
        for block in _blocks(count):
            batch(ctypes.c_size_t(block), *pointers)

    return solve


def _numba(name: str, T: FloatArray) -> Callable[[int], None]:
    """Python's batch, on the caller's arrays."""
    module = generated(name)
    q, status = module.ik_batch(T)

    def solve(count: int) -> None:
        for block in _blocks(count):
            module.ik_batch(T[:block], out=(q[:block], status[:block]))

    return solve


if __name__ == "__main__":
    main(sys.argv[1:])
