"""The C on a small controller: solved in QEMU, with no heap, no static memory and only libm."""

from __future__ import annotations

import subprocess
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.status import HELD, Status
from dhgen.tolerances import SINGLE
from tests.embedded.board import CORTEX_M4, CORTEX_M7, MISSING, answers, compiled
from tests.structures import BREADTH, first_of, says
from tests.targets.made import NAMES, apart, folder, made, poses_of, residual, robot, robot_path

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.arrays import FloatArray


pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(bool(MISSING), reason=f"not installed: {', '.join(MISSING)}"),
]

POSES = 24
SMALL = sorted(
    (name for name in NAMES if says(robot_path(name), "float32: true")),
    key=lambda name: name != "scara",
)
BOARDS = {"Cortex-M4": CORTEX_M4, "Cortex-M7": CORTEX_M7}
# What the floating-point unit knows, and for one arm what it does not, or knows besides.
SOLVED = [
    pytest.param(
        name, board, real, id=f"{name}-{board}-{word}", marks=BREADTH if name != "scara" else ()
    )
    for name in SMALL
    for board, real, word in (
        ("Cortex-M4", np.float32, "float"),
        ("Cortex-M7", np.float64, "double"),
        ("Cortex-M4", np.float64, "double"),
        ("Cortex-M7", np.float32, "float"),
    )
    if name == "scara" or (word == "float") == (board == "Cortex-M4")
]
# Of the arm's size: what rows may miss a pose by, and what the generating joints may be off by.
ENOUGH: dict[type, tuple[float, float]] = {np.float64: (1e-11, 1e-6), np.float32: (5e-5, 1e-2)}
LIBM = {"atan2", "ceil", "cos", "fabs", "floor", "fmod", "fmax", "fmin", "hypot", "sin", "sqrt"}
COPYING = {"memcpy", "memset"}  # a compiler may call these for any assignment
STATIC = {".data", ".bss", ".tdata", ".tbss", "COMMON"}


def written(name: str, folder: Path) -> None:
    write_files(folder, made(name).files)


@cache
def targets(name: str) -> tuple[FloatArray, FloatArray]:
    """Joint values inside the limits, some at right angles, and their poses by the oracle."""
    draw = np.random.default_rng(5)
    limits = [joint.limits or (-np.pi, np.pi) for joint in robot(name).joints]
    low, high = np.array(limits).clip(-np.pi, np.pi).T
    q = draw.uniform(low, high, (POSES, len(limits)))
    right = np.clip(draw.integers(-1, 2, q.shape) * np.pi / 2, low, high)
    q[2 * POSES // 3 :] = np.where(draw.random(q.shape) < 0.4, right, q)[2 * POSES // 3 :]
    return q, poses_of(name, q)


@pytest.mark.parametrize(("name", "board", "real"), SOLVED)
def test_solves_on_the_board(name: str, board: str, real: type, tmp_path: Path) -> None:
    written(name, tmp_path)
    q, T = targets(name)
    suffix = SINGLE.suffix if real is np.float32 else ""
    rows = made(name).module.solver.rows
    said = answers(BOARDS[board], tmp_path / f"{name}{suffix}.c", rows, q, T, real)
    miss, off = ENOUGH[real]
    assert len(said) == POSES
    for answer, joints, pose in zip(said, q, T, strict=True):
        held = answer.q[np.isin(answer.status, HELD)]
        assert len(held) > 0
        assert answer.count == np.isin(answer.status, (Status.OK, Status.FREE_JOINT)).sum()
        assert residual(name, held, pose) < miss
        assert apart(name, held, joints).max(axis=1).min() < off
        assert apart(name, answer.nearest, joints).max() < off
        np.testing.assert_allclose(answer.T, pose, atol=10 * miss)


@cache
def object_of(name: str, suffix: str) -> Path:
    """For a Cortex-M4; in single precision nothing may become double by itself."""
    source = folder() / f"{made(name).module.name}{suffix}.c"
    warnings = ("-Wdouble-promotion", "-Wfloat-conversion") if suffix else ()
    return compiled(CORTEX_M4, source, source.with_suffix(".m4.o"), "-O2", *warnings)


@pytest.mark.parametrize("name", first_of(SMALL))
def test_needs_nothing_but_libm(name: str) -> None:
    """What the object leaves undefined is libm's, the compiler's arithmetic, or copying."""
    for suffix, functions in (("", LIBM), (SINGLE.suffix, {f"{each}f" for each in LIBM})):
        wanted = undefined(object_of(name, suffix))
        arithmetic = {each for each in wanted if each.startswith("__aeabi_")}
        assert wanted - functions - COPYING <= arithmetic
        assert functions & wanted


@pytest.mark.parametrize("name", first_of(SMALL))
def test_single_precision_never_becomes_double(name: str) -> None:
    """No soft arithmetic of doubles where the processor has none."""
    wanted = undefined(object_of(name, SINGLE.suffix))
    assert [each for each in wanted if each.startswith("__aeabi_d")] == []


@pytest.mark.parametrize("name", first_of(SMALL))
def test_uses_no_static_memory(name: str) -> None:
    """Constants lie with the code; nothing that could be written to is kept between calls."""
    for suffix in ("", SINGLE.suffix):
        sizes = sections(object_of(name, suffix))
        assert sizes[".text"] > 0
        assert {each: size for each, size in sizes.items() if each in STATIC and size} == {}


def undefined(path: Path) -> set[str]:
    """Symbols that an object wants from elsewhere."""
    return set(told("arm-none-eabi-nm", "-u", "-j", str(path)).split())


def sections(path: Path) -> dict[str, int]:
    """The sections of an object and their sizes."""
    lines = told("arm-none-eabi-size", "-A", str(path)).splitlines()
    cells = [line.split() for line in lines]
    return {each[0]: int(each[1]) for each in cells if len(each) == 3 and each[1].isdigit()}


def told(*command: str) -> str:
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout
