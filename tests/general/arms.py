"""Arms that Paul's closed forms do not solve, and ways to call what is generated for them."""

from __future__ import annotations

import ctypes
import math
import subprocess
import tempfile
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from dhgen import runtime
from dhgen.atomic_write import write_files
from dhgen.general.links import Link
from dhgen.general.setup import setup
from dhgen.runtime.python.general.candidates import PLACES
from dhgen.targets.c.general import general_sizes, general_source
from tests.general.solved import solve, solve_slowly
from tests.kept import made_once

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.rigid import Matrix

Row = tuple[float, float, float, float]  # theta [quarter turns, or rad], d, a, alpha of standard DH
Answer = tuple[np.ndarray, np.ndarray, bool]  # q (k, 6), residual (k,), certain
Corrected = tuple[np.ndarray, bool]  # q (k, 6), whether these are exact and apart

QUARTER = {-1: (0.0, -1.0), 0: (1.0, 0.0), 1: (0.0, 1.0), 2: (-1.0, 0.0)}
C_RUNTIME = Path(runtime.__file__).parent / "c"
# -O1: compiling takes the time of these tests; test_silent_c and the generated arms have more.
FLAGS = ("-std=c99", "-O1", "-march=native", "-fno-math-errno", "-fno-trapping-math", "-fPIC")
COMMAND = ("gcc", *FLAGS, f"-I{C_RUNTIME}")
STRICT = ("-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror")
RUN = """
int run(const double *T, double *q, double *residual);
int run(const double *T, double *q, double *residual)
{
    return dhgen_general_solutions(&general, T, 0, (double (*)[6])q, residual);
}
int correct(const double *T, double *nearby, int count);
int correct(const double *T, double *nearby, int count)
{
    return dhgen_general_correct(&general, T, 0, (double (*)[6])nearby, count);
}
"""

# Angles that are integers count quarter turns.
TABLES: dict[str, tuple[Row, ...]] = {
    "manseur_doty": (
        (0, 0.0, 0.3, 1),
        (0, 0.0, 1.0, math.radians(1.0)),
        (0, 0.2, 0.0, 1),
        (0, 0.0, 1.5, math.radians(1.0)),
        (0, 0.0, 0.0, 1),
        (0, 0.0, 0.0, math.radians(1.0)),
    ),
    "general": (
        (2.137, -0.035, 0.416, 1.353),
        (-2.341, -0.257, -0.339, 2.932),
        (-1.611, -0.272, 0.075, -2.507),
        (0.482, 0.262, -0.28, -2.04),
        (0.126, -0.167, -0.136, 0.145),
        (1.904, -0.477, 0.175, 1.432),
    ),
    "xarm6": (
        (2, 0.267, 0.0, 1),
        (1.756674780719604, 0.0, 0.2894866145437471, 0),
        (1.3849178728701894, 0.0, 0.0775, -1),
        (0, 0.3425, 0.0, 1),
        (0, 0.0, 0.076, -1),
        (0, 0.097, 0.0, 0),
    ),
    "jaco2": (
        (0, 0.2755, 0.0, 1),
        (-1, 0.0, 0.41, 2),
        (1, -0.0098, 0.0, 1),
        (0, -0.24918, 0.0, math.pi / 3),
        (0, -0.083811, 0.0, math.pi / 3),
        (0, -0.21058, 0.0, 2),
    ),
}


def constants(table: Sequence[Row]) -> tuple[Matrix, ...]:
    """C0 ... C6 of a standard table."""
    links = [np.eye(4)]
    for theta, d, a, alpha in table:
        (ct, st), (ca, sa) = _circle(theta), _circle(alpha)
        turn = np.array([[ct, -st, 0, 0], [st, ct, 0, 0], [0, 0, 1, d], [0, 0, 0, 1.0]])
        twist = np.array([[1.0, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
        links.append(turn @ twist)
    return tuple(tuple(map(tuple, link.tolist())) for link in links)


def _circle(angle: float) -> tuple[float, float]:
    if isinstance(angle, int):
        return QUARTER[angle]
    return math.cos(angle), math.sin(angle)


def forward(table: Sequence[Row], q: Sequence[float] | np.ndarray) -> np.ndarray:
    """The poses of the tool (..., 4, 4) at joint vectors (..., 6)."""
    first, *links = constants(table)
    T = np.array(first)
    for angle, link in zip(np.moveaxis(np.asarray(q), -1, 0), links, strict=True):
        turn = np.broadcast_to(np.eye(4), (*angle.shape, 4, 4)).copy()
        turn[..., 0, 0] = turn[..., 1, 1] = np.cos(angle)
        turn[..., 1, 0] = np.sin(angle)
        turn[..., 0, 1] = -np.sin(angle)
        T = T @ turn @ np.array(link)
    return T


@cache
def kernel(name: str) -> GeneralKernel:
    found = setup([Link(C) for C in constants(TABLES[name])])
    assert found is not None
    return found


def poses(name: str, count: int, seed: int = 0) -> list[tuple[np.ndarray, np.ndarray]]:
    """Random joint vectors and their poses."""
    q = np.random.default_rng(seed).uniform(-np.pi, np.pi, (count, 6))
    return list(zip(q, forward(TABLES[name], q), strict=True))


def gap(q: np.ndarray, other: np.ndarray) -> np.ndarray:
    """The largest difference of two joint vectors, modulo turns."""
    wrapped = np.remainder(np.asarray(q) - other + np.pi, 2 * np.pi) - np.pi
    return np.asarray(np.abs(wrapped).max(axis=-1))


@cache
def compiled(name: str, *flags: str) -> Callable[..., Answer]:
    """The C kernel of an arm."""
    return in_c(kernel(name), name, *flags)


@cache
def correcting(name: str, *flags: str) -> Callable[[np.ndarray, np.ndarray], Corrected]:
    """What takes joint values near solutions of a pose to these."""
    return partial(_corrected, library(kernel(name), name, *flags).correct)


def in_c(known: GeneralKernel, name: str, *flags: str) -> Callable[..., Answer]:
    """The same of any kernel, with what its traits leave of the runtime."""
    return partial(_answer, library(known, name, *flags).run)


def library(known: GeneralKernel, name: str, *flags: str) -> ctypes.CDLL:
    """The C of a kernel, with the functions above."""
    sizes = ["#define DHGEN_DOF 6", f"#define DHGEN_ROWS {known.rows}"]
    sizes += general_sizes(name.upper(), known)
    text = "\n".join([*sizes, '#include "dhgen/general.h"', general_source(known), RUN])
    folder = Path(tempfile.mkdtemp())
    write_files(folder, {"arm.c": text})
    command = [*COMMAND, *STRICT, *flags, "-shared", "arm.c", "-o", "arm.so", "-lm"]
    subprocess.run(command, check=True, cwd=folder)
    return ctypes.CDLL(str(folder / "arm.so"))


def one_by_one(known: GeneralKernel) -> Callable[..., Answer]:
    """The same without lanes, by a runtime that is compiled once for all kernels."""
    return in_c(known, "arm", *without_lanes())


@cache
def without_lanes() -> tuple[str, ...]:
    """What a runtime without lanes is linked by."""
    parts = ("dhgen", "general")
    command = (*COMMAND, "-DDHGEN_SHARED", "-DDHGEN_GENERAL_LANES=1", "-c")

    def compile_parts(folder: Path) -> None:
        for part in parts:
            source = C_RUNTIME / "dhgen" / f"{part}.c"
            own = (str(source), "-o", str(folder / f"{part}.o"))
            subprocess.run([*command, *own], check=True)

    folder = made_once(command, compile_parts)
    return ("-DDHGEN_SHARED", *(str(folder / f"{part}.o") for part in parts))


def doubtful_in_all_languages(known: GeneralKernel, poses: Sequence[np.ndarray]) -> int:
    """Of how many poses it is not certain that these are all solutions; C has the same as Python.

    In lanes and one by one; by numba, and in plain Python for the first pose.
    """
    in_lanes, alone, doubtful = in_c(known, "arm"), one_by_one(known), 0
    for number, T in enumerate(poses):
        q, residual, certain = in_lanes(T)
        assert (residual < 1e-10).all()
        doubtful += not certain
        np.testing.assert_allclose(alone(T)[0], q, atol=1e-8)
        np.testing.assert_allclose(solve(T, known).q, q, atol=1e-8)
        if number == 0:
            np.testing.assert_allclose(solve_slowly(T, known).q, q, atol=1e-8)
    return doubtful


def _answer(run: Callable[..., int], T: np.ndarray) -> Answer:
    q, residual = np.empty((PLACES, 6)), np.empty(PLACES)
    arrays = np.ascontiguousarray(T, dtype=float), q, residual
    count = run(*(ctypes.c_void_p(each.ctypes.data) for each in arrays))
    found = count if count >= 0 else -1 - count
    return q[:found], residual[:found], count >= 0


def _corrected(correct: Callable[..., int], T: np.ndarray, nearby: np.ndarray) -> Corrected:
    pose, q = np.ascontiguousarray(T, dtype=float), np.array(nearby, dtype=float)
    said = correct(*(ctypes.c_void_p(each.ctypes.data) for each in (pose, q)), len(q))
    return q, bool(said)
