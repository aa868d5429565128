"""Solutions from joint values that are said to be near them, in C and in plain Python."""

from __future__ import annotations

import ctypes
import subprocess
import tempfile
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.runtime import c_runtime_files
from dhgen.runtime.plain import plain
from dhgen.targets.c.general import general_sizes, general_source
from tests.general.arms import FLAGS, STRICT, compiled, gap, kernel, poses
from tests.general.solved import numbers

ARMS = ("general", "xarm6", "manseur_doty")
OFF = 1e-3
DRIVER = """
int run(const double *T, double *nearby, int count, double *q, double *residual);
int run(const double *T, double *nearby, int count, double *q, double *residual)
{
    double (*const starts)[6] = (double (*)[6])nearby, (*const rows)[6] = (double (*)[6])q;
    return dhgen_general_solutions(&general, T, 0, starts, count, rows, residual);
}
"""


@cache
def library(name: str, *flags: str) -> ctypes.CDLL:
    known = kernel(name)
    sizes = ["#define DHGEN_DOF 6", f"#define DHGEN_ROWS {known.rows}"]
    sizes += general_sizes("ARM", known)
    text = "\n".join([*sizes, '#include "dhgen/general.h"', general_source(known), DRIVER])
    folder = Path(tempfile.mkdtemp())
    write_files(folder, {"arm.c": text, **c_runtime_files()})
    command = ["gcc", *FLAGS, *flags, "-shared", "-fPIC", "arm.c", "-o", "arm.so", "-lm"]
    subprocess.run(command, check=True, cwd=folder)
    return ctypes.CDLL(str(folder / "arm.so"))


def in_c(name: str, T: np.ndarray, nearby: np.ndarray, *flags: str) -> tuple[np.ndarray, int]:
    q, residual = np.empty((16, 6)), np.empty(16)
    T, nearby = np.ascontiguousarray(T), np.ascontiguousarray(nearby)
    pointers = [ctypes.c_void_p(each.ctypes.data) for each in (T, nearby, q, residual)]
    count = library(name, *flags).run(*pointers[:2], len(nearby), *pointers[2:])
    return q[: count if count >= 0 else -1 - count], count


def in_python(name: str, T: np.ndarray, nearby: np.ndarray) -> tuple[np.ndarray, int]:
    q, residual = np.empty((16, 6)), np.empty(16)
    arm, flat = numbers(kernel(name)), np.ascontiguousarray(T[:3]).ravel()
    with np.errstate(divide="ignore", invalid="ignore"):  # as compiled code divides
        count = plain("general.search").solve_loop(
            arm, flat, np.zeros(0), np.ascontiguousarray(nearby), q, residual
        )
    return q[: count if count >= 0 else -1 - count], count


@pytest.mark.parametrize("flags", [STRICT, ("-DARM_LANES=1",)], ids=["lanes", "one"])
@pytest.mark.parametrize("name", ARMS)
def test_from_near_all(name: str, flags: tuple[str, ...]) -> None:
    """Those that the elimination finds; but for rounding these are other numbers."""
    rng, moved = np.random.default_rng(1), 0
    for number, (_, T) in enumerate(poses(name, 40)):
        wanted, _, certain = compiled(name)(T)
        if not certain:
            continue
        nearby = wanted + rng.uniform(-OFF, OFF, wanted.shape)
        found, count = in_c(name, T, nearby, *flags)
        assert count == len(wanted)
        np.testing.assert_allclose(gap(found, wanted), 0.0, atol=1e-9)
        moved += not np.array_equal(found, wanted)
        if number < 3:
            slowly, count = in_python(name, T, nearby)
            assert count == len(wanted)
            np.testing.assert_allclose(gap(slowly, found), 0.0, atol=1e-10)
    assert moved > 20


@pytest.mark.parametrize("name", ARMS)
def test_two_that_lead_to_one_are_not_all(name: str) -> None:
    """Then the elimination has the last word, to the last digit."""
    for number, (_, T) in enumerate(poses(name, 10)):
        wanted, _, certain = compiled(name)(T)
        if len(wanted) < 2:
            continue
        nearby = wanted + OFF
        nearby[1] = wanted[0] - OFF
        found, count = in_c(name, T, nearby)
        np.testing.assert_array_equal(found, wanted)
        assert (count >= 0) == certain
        if number < 2:
            slowly, _ = in_python(name, T, nearby)
            np.testing.assert_allclose(gap(slowly, wanted), 0.0, atol=1e-8)


@pytest.mark.parametrize("name", ARMS)
def test_what_leads_nowhere(name: str) -> None:
    """As many as there are solutions, from anywhere, and no numbers at all."""
    rng = np.random.default_rng(2)
    for _, T in poses(name, 10):
        wanted, _, _ = compiled(name)(T)
        starts = np.full((1, 6), np.nan), rng.uniform(-np.pi, np.pi, (16, 6))
        for nearby in starts:
            found, _ = in_c(name, T, nearby)
            np.testing.assert_array_equal(found, wanted)
