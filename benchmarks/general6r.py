"""How long the general 6R kernel takes in C, for each arm: mean, median and 99 % quantile.

Run as `python -m benchmarks.general6r [poses]` from the checkout. CPU time of one process, the
least of five runs of a pose, all solutions, random poses within reach.
"""

from __future__ import annotations

import ctypes
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.emit import c_source
from dhgen.general.setup import setup
from tests.general.arms import TABLES, Row, constants, forward

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.general.kernel import GeneralKernel

FLAGS = [
    "-std=c99",
    "-O3",
    "-march=native",
    "-fno-math-errno",
    "-fno-trapping-math",
    "-ffp-contract=fast",
]
RANDOM_ARMS = 4
HARNESS = """
void bench(int n, const double *T, double *seconds, int *count);
void bench(int n, const double *T, double *seconds, int *count)
{
    double q[16][6], residual[16];
    struct timespec a, b;
    for (int i = 0; i < n; i++) {
        seconds[i] = 1e30;
        for (int run = 0; run < 5; run++) {
            double took;
            clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &a);
            count[i] = arm_general(T + 16 * i, q, residual);
            clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &b);
            took = (double)(b.tv_sec - a.tv_sec) + 1e-9 * (double)(b.tv_nsec - a.tv_nsec);
            seconds[i] = took < seconds[i] ? took : seconds[i];
        }
    }
}
"""


def arms() -> dict[str, tuple[Row, ...]]:
    """The arms of the tests and some random ones."""
    found = dict(TABLES)
    for seed in range(RANDOM_ARMS):
        numbers = np.random.default_rng(seed).uniform(-1, 1, (6, 4)) * [3.0, 0.5, 0.5, 3.0]
        found[f"random_{seed}"] = tuple((a, b, c, d) for a, b, c, d in numbers.tolist())
    return found


def measure(kernel: GeneralKernel, T: np.ndarray, folder: Path) -> tuple[np.ndarray, np.ndarray]:
    """Seconds and solutions of every pose (N, 4, 4)."""
    head = "#define _POSIX_C_SOURCE 199309L\n#include <math.h>\n#include <time.h>\n"
    (folder / "arm.c").write_text(head + c_source(kernel, "arm") + HARNESS, encoding="utf-8")
    command = ["gcc", *FLAGS, "-shared", "-fPIC", "arm.c", "-o", "arm.so", "-lm"]
    subprocess.run(command, check=True, cwd=folder)
    library = ctypes.CDLL(str(folder / "arm.so"))
    seconds, count = np.empty(len(T)), np.empty(len(T), dtype=np.int32)
    arrays = (np.ascontiguousarray(T), seconds, count)
    library.bench(len(T), *(array.ctypes.data_as(ctypes.c_void_p) for array in arrays))
    return seconds, np.where(count < 0, -1 - count, count)


def poses(table: Sequence[Row], count: int) -> np.ndarray:
    """Random poses (count, 4, 4)."""
    q = np.random.default_rng(0).uniform(-np.pi, np.pi, (count, 6))
    return np.array([forward(table, row) for row in q])


def main() -> None:
    """Print one line for each arm."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    print(f"{'arm':14} {'solutions':>9} {'mean':>8} {'p50':>8} {'p99':>8}   [microseconds]")
    for name, table in arms().items():
        kernel = setup(constants(table))
        if kernel is None:
            print(f"{name:14} no formulation")
            continue
        with tempfile.TemporaryDirectory() as folder:
            seconds, found = measure(kernel, poses(table, count), Path(folder))
        mean, median, late = 1e6 * np.array([seconds.mean(), *np.quantile(seconds, [0.5, 0.99])])
        print(f"{name:14} {found.mean():9.2f} {mean:8.2f} {median:8.2f} {late:8.2f}")


if __name__ == "__main__":
    main()
