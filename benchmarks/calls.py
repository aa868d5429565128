"""What a call of `ik_into` takes: of numba, and of the C from Python, from numba, by ctypes.

    python -m benchmarks.calls [--arms NAME ...] [--rounds N]

CPU time of a pose in one process, all solutions without a seed, random poses in reach; everybody
takes turns, and the least counts. The C is built as `dhgen_native` builds it. Arms whose values the
caller gives are left out.
"""

from __future__ import annotations

import importlib
import sys
import time
from typing import TYPE_CHECKING, Any

import numpy as np
from numba import njit

from benchmarks.arms import CASES, read_arm
from benchmarks.options import parser, show
from benchmarks.report import table, time_text
from benchmarks.solvers import GENERATED, generated

if TYPE_CHECKING:
    from collections.abc import Callable

POSES = 512
HEAD = ("arm", "numba", "C", "C from numba", "C by ctypes")


def main(arguments: list[str]) -> None:
    """Prints one line an arm."""
    options = parser("benchmarks.calls", __doc__, [case.name for case in CASES])
    options.add_argument("--rounds", type=int, default=25)
    chosen = options.parse_args(arguments)
    rows = []
    for name in chosen.arms:
        rows.append((name, *map(time_text, measure(name, chosen.rounds))))
        print(*rows[-1], flush=True)
    show(table(HEAD, rows), "calls", write=chosen.write)


def measure(name: str, rounds: int) -> list[float]:
    """The least time of a call in each of the ways [ns]."""
    case = next(case for case in CASES if case.name == name)
    T = np.ascontiguousarray(read_arm(case).random_poses(POSES))
    python = generated(name)
    q, status = np.empty((python.MAX_SOLUTIONS, python.DOF)), np.empty(python.MAX_SOLUTIONS, "u1")
    native, by_ctypes = _native(python, extends=True), _native(python, extends=False)
    in_c = native.ik_into

    @njit
    def from_numba(T: Any, q: Any, status: Any) -> None:  # noqa: ANN401
        for k in range(len(T)):
            in_c(T[k], q, status)

    def one_by_one(solve: Callable[..., int]) -> Callable[[], None]:
        def run() -> None:
            for pose in T:
                solve(pose, q, status)

        return run

    ways = [one_by_one(each.ik_into) for each in (python, native)]
    ways += [lambda: from_numba(T, q, status), one_by_one(by_ctypes.ik_into)]
    taken: list[list[int]] = [[] for _ in ways]
    for _ in range(rounds + 1):  # the first one compiles
        for way, times in zip(ways, taken, strict=True):
            start = time.process_time_ns()
            way()
            times.append(time.process_time_ns() - start)
    return [min(times[1:]) / POSES for times in taken]


def _native(python: Any, *, extends: bool) -> Any:  # noqa: ANN401
    """The module with its C, as an extension of Python or not."""
    if str(GENERATED) not in sys.path:
        sys.path.append(str(GENERATED))
    helper: Any = importlib.import_module("dhgen_native")
    able, helper.EXTENDS = helper.EXTENDS, extends and helper.EXTENDS
    try:
        return helper.native(python)
    finally:
        helper.EXTENDS = able


if __name__ == "__main__":
    main(sys.argv[1:])
