"""Compiled solvers behind one small driver: called, and timed without Python in the way."""

from __future__ import annotations

import ctypes
import hashlib
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from benchmarks.contestant import AbsentError
from benchmarks.memory import lined_up, room
from dhgen.verify.native import c_compiler

if TYPE_CHECKING:
    from benchmarks.contestant import Run
    from dhgen.arrays import FloatArray

FLAGS = ("-std=c99", "-O3", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=fast")
NATIVE = (*FLAGS, "-march=native")
AVX2 = (*FLAGS, "-mavx2", "-mfma")

DRIVER = """#define _POSIX_C_SOURCE 199309L
#include <stddef.h>
#include <time.h>
{shim}
double bench_time(size_t n, size_t repeats, const double *T, double *q);
void bench_solve(size_t n, const double *T, double *q);
void bench_each(size_t n, size_t passes, const double *T, double *seconds, double *q);

static double now(void)
{{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}}

/* CPU seconds of solving n poses one after another, so many times. */
double bench_time(size_t n, size_t repeats, const double *T, double *q)
{{
    const double start = now();
    for (size_t k = 0; k < repeats; k++)
        {timed}
    return now() - start;
}}

/* All rows of n poses; the caller has filled q with NaN. */
void bench_solve(size_t n, const double *T, double *q)
{{
    {solved}
}}

/* CPU seconds that asking for the time takes, at least. */
static double of_clock(void)
{{
    double least = 1.0;
    for (int k = 0; k < 1000; k++) {{
        const double start = now(), taken = now() - start;
        least = taken < least ? taken : least;
    }}
    return least;
}}

/* CPU seconds of every pose alone, in so many passes over all of them. */
void bench_each(size_t n, size_t passes, const double *T, double *seconds, double *q)
{{
    const double clock = of_clock();
    for (size_t k = 0; k < passes * n; k++) {{
        const double start = now();
        {single}
        seconds[k] = now() - start - clock;
    }}
}}
"""
ONE = "for (size_t i = 0; i < n; i++)\n            (void)solve(T + 16 * i, q);"
EACH = "for (size_t i = 0; i < n; i++)\n        (void)solve(T + 16 * i, q + {size} * i);"
ALL = "solve_all(n, T, q);"
SINGLE = "(void)solve(T + 16 * (k % n), q);"
SINGLE_ALL = "solve_all(1, T + 16 * (k % n), q);"


@dataclass(frozen=True, slots=True)
class Interface:
    """How the driver calls a solver.

    Attributes:
        shim: C text with `static int solve(const double *T, double *q)`, or for a batch
            `static void solve_all(size_t n, const double *T, double *q)`.
        rows: Rows of q for one pose.
        dof: Joint values in a row.
        batch: Which of the two.
    """

    shim: str
    rows: int
    dof: int
    batch: bool = False

    def driver(self) -> str:
        """The driver's text."""
        each = EACH.format(size=self.rows * self.dof)
        timed, solved, single = (ALL, ALL, SINGLE_ALL) if self.batch else (ONE, each, SINGLE)
        return DRIVER.format(shim=self.shim, timed=timed, solved=solved, single=single)


@dataclass(frozen=True, slots=True)
class Native:
    """A compiled solver.

    Attributes:
        library: The shared library.
        interface: How it is called.
    """

    library: Any
    interface: Interface

    def solve(self, T: FloatArray) -> list[FloatArray]:
        """All rows of poses (N, 4, 4) that hold joint values."""
        return [rows[~np.isnan(rows).any(axis=1)] for rows in self.rows(T)]

    def rows(self, T: FloatArray) -> FloatArray:
        """All rows of poses (N, 4, 4), NaN where there is no solution: (N, rows, dof)."""
        q = np.full((len(T), self.interface.rows, self.interface.dof), np.nan)
        poses = np.ascontiguousarray(T)
        self.library.bench_solve(ctypes.c_size_t(len(T)), _pointer(poses), _pointer(q))
        return q

    def each(self, T: FloatArray, passes: int) -> FloatArray:
        """The least CPU time of every pose (N, 4, 4) alone [s], of so many passes over all (N,)."""
        poses, seconds = np.ascontiguousarray(T), np.empty((passes, len(T)))
        q = np.empty((self.interface.rows, self.interface.dof))
        sizes = ctypes.c_size_t(len(T)), ctypes.c_size_t(passes)
        self.library.bench_each(*sizes, *map(_pointer, (poses, seconds, q)))
        return np.asarray(seconds.min(axis=0))

    def prepare(self, T: FloatArray) -> Run:
        """Solves the poses (N, 4, 4) again and again, and tells the CPU time."""
        poses = lined_up(T)
        count = len(T) if self.interface.batch else 1
        q = room((count, self.interface.rows, self.interface.dof))

        def run(repeats: int) -> float:
            sizes = ctypes.c_size_t(len(poses)), ctypes.c_size_t(repeats)
            return float(self.library.bench_time(*sizes, _pointer(poses), _pointer(q)))

        return run


def compiled(source: Path, interface: Interface, flags: tuple[str, ...], folder: Path) -> Native:
    """Compiles a solver and the driver apart, as a caller would, and loads them.

    Raises:
        AbsentError: There is no compiler, it refuses the source, or the processor lacks what the
            flags ask for.
    """
    compiler = c_compiler()
    if compiler is None:
        raise AbsentError("there is no C compiler")
    if "-mavx2" in flags and not _supports(compiler, "avx2", folder):
        raise AbsentError("the processor has no AVX2")
    made = hashlib.sha256("".join([source.name, interface.driver(), *flags]).encode()).hexdigest()
    driver = folder / f"driver_{made[:16]}.c"
    driver.write_text(interface.driver(), encoding="utf-8")
    library = driver.with_suffix(".so")
    link = ["-shared", "-fPIC", f"-I{source.parent}", "-o", str(library), "-lm"]
    _build([compiler, *flags, str(source), str(driver), *link])
    loaded = ctypes.CDLL(str(library))
    loaded.bench_time.restype = ctypes.c_double
    loaded.bench_solve.restype = None
    return Native(loaded, interface)


def _supports(compiler: str, feature: str, folder: Path) -> bool:
    source = folder / f"has_{feature}.c"
    source.write_text(
        f'int has(void);\nint has(void)\n{{\n    return __builtin_cpu_supports("{feature}");\n}}\n',
        encoding="utf-8",
    )
    library = source.with_suffix(".so")
    try:
        _build([compiler, "-shared", "-fPIC", str(source), "-o", str(library)])
    except AbsentError:
        return False
    return bool(ctypes.CDLL(str(library)).has())


def _build(command: list[str]) -> None:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        errors = [line for line in done.stderr.splitlines() if "error" in line] or ["failed"]
        raise AbsentError(f"{Path(command[0]).name}: {errors[0]}")


def _pointer(array: FloatArray) -> Any:  # noqa: ANN401 - ctypes has no type for it
    return array.ctypes.data_as(ctypes.c_void_p)
