"""dhgen's own contestants: the generated C in several builds, and the generated Python."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

import numpy as np

from benchmarks.arms import CHECKOUT
from benchmarks.contestant import Absentee, AbsentError, Contestant, imported, timed
from benchmarks.memory import lined_up, room
from benchmarks.native import AVX2, NATIVE, Interface, compiled

if TYPE_CHECKING:
    from pathlib import Path

    from benchmarks.arms import Arm
    from benchmarks.contestant import Run
    from dhgen.arrays import FloatArray

TOOL = "dhgen"
GENERATED = CHECKOUT / "generated"
PORTABLE = ("-std=c99", "-O2")

ONE_SHIM = """#include "{name}.h"
static int solve(const double *T, double *q)
{{
    unsigned char status[{rows}];
    return {name}_ik(T, NULL, (double (*)[{dof}])q, status);
}}
"""
BATCH_SHIM = """#include "{name}.h"
#include <stdlib.h>
/* The statuses are kept from call to call: writing to fresh memory would be measured too. */
static void solve_all(size_t n, const double *T, double *q)
{{
    static unsigned char *status;
    static size_t room;
    if (n > room)
        status = realloc(status, {rows} * (room = n));
    {name}_ik_batch(n, T, q, status);
}}
"""


def solvers(arm: Arm, folder: Path) -> tuple[list[Contestant], list[Absentee]]:
    """Every way of calling what dhgen made of an arm, and which of them can't run here."""
    present, absent = [], []
    module = generated(arm.case.name)
    one = Interface(_shim(ONE_SHIM, arm, module), module.MAX_SOLUTIONS, arm.dof)
    batch = Interface(_shim(BATCH_SHIM, arm, module), module.MAX_SOLUTIONS, arm.dof, batch=True)
    for way, interface, flags in (
        ("C, -O2", one, PORTABLE),
        ("C, scalar", one, (*NATIVE, f"-D{arm.case.name.upper()}_LIBM")),
        ("C, one pose, AVX2", one, AVX2),
        ("C, one pose", one, NATIVE),
        ("C, batch, AVX2", batch, AVX2),
        ("C, batch", batch, NATIVE),
    ):
        try:
            native = compiled(GENERATED / f"{arm.case.name}.c", interface, flags, folder)
        except AbsentError as error:
            absent.append(Absentee(f"{TOOL}, {way}", str(error)))
        else:
            present.append(Contestant(TOOL, way, native.solve, native.prepare, ours=True))
    return present + _python(module), absent


def generated(name: str) -> Any:  # noqa: ANN401 - a generated module
    """The generated module of an arm, imported as its users do."""
    if str(GENERATED) not in sys.path:
        sys.path.append(str(GENERATED))
    return imported(name)


def _shim(text: str, arm: Arm, module: Any) -> str:  # noqa: ANN401 - a generated module
    return text.format(name=arm.case.name, rows=module.MAX_SOLUTIONS, dof=arm.dof)


def _python(module: Any) -> list[Contestant]:  # noqa: ANN401 - a generated module
    """The generated module, as numba makes it."""

    def single(T: FloatArray) -> list[FloatArray]:
        return [_held(module.ik_all(pose)[0]) for pose in T]

    def together(T: FloatArray) -> list[FloatArray]:
        return [_held(rows) for rows in module.ik_batch(T)[0]]

    def into(T: FloatArray) -> Run:
        q = np.empty((module.MAX_SOLUTIONS, module.DOF))
        status = np.empty(module.MAX_SOLUTIONS, np.uint8)
        poses = [np.ascontiguousarray(pose) for pose in T]

        def work() -> None:
            for pose in poses:
                module.ik_into(pose, q, status)

        return timed(work)

    def fresh(T: FloatArray) -> Run:
        poses = [np.ascontiguousarray(pose) for pose in T]

        def work() -> None:
            for pose in poses:
                module.ik_all(pose)

        return timed(work)

    def batch(T: FloatArray) -> Run:
        # As a loop holds them: fresh memory would be measured too.
        out = (
            room((len(T), module.MAX_SOLUTIONS, module.DOF)),
            np.empty((len(T), module.MAX_SOLUTIONS), np.uint8),
        )
        poses = lined_up(T)
        return timed(lambda: module.ik_batch(poses, out=out))

    ways = (("ik_into", single, into), ("ik_all", single, fresh), ("ik_batch", together, batch))
    return [
        Contestant(TOOL, f"Python, {way}", solve, prepare, ours=True)
        for way, solve, prepare in ways
    ]


def _held(rows: FloatArray) -> FloatArray:
    """The rows that hold joint values."""
    kept: FloatArray = rows[~np.isnan(rows).any(axis=1)]
    return kept
