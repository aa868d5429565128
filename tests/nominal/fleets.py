"""Kinds of arms whose tables come at run time, compiled once for all tests of a process."""

from __future__ import annotations

import math
import re
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from dhgen.atomic_write import write_files
from dhgen.calibrated import kind_of
from dhgen.robot.load import load_text
from dhgen.robot_files import RobotFile
from dhgen.targets.c.calibrated import kind_files
from dhgen.targets.reserved import RESERVED
from dhgen.verify.native import Build, compile_solver
from tests.compiling import shared, worked_out_once
from tests.nominal.twins import ROBOTS
from tests.structures import first_of

if TYPE_CHECKING:
    from pathlib import Path
    from typing import Any

    from dhgen.targets.calibrated import Kind

# Every other joint counts backwards, between a base and a tool that turn all axes.
PLACED = "_placed"
BASE = "base: {xyz: [0.3, -0.2, 0.5], rpy: [0.4, -0.3, 2.0]}"
TOOL = "tool: {xyz: [0.02, -0.05, 0.15], rpy: [0.5, 0.3, -1.2]}"
THOUSAND = "_thousand"
TURNED = (f"puma560{PLACED}", f"kuka_kr210{PLACED}")  # a standard table, and a modified one
# Parallel axes, a wrist, and a wrist of a modified table that is placed; then those of the same
# structures with limits, with a tool, and of a standard table that is placed.
NAMES = ("ur5e", "puma560", TURNED[1], "kuka_kr6_r900", "abb_irb120", TURNED[0])
EACH = first_of(NAMES, count=3)


@cache
def file_of(name: str) -> RobotFile:
    """A robot file, or one that is placed elsewhere, or one in millimetres."""
    path = ROBOTS / f"{name.removesuffix(PLACED).removesuffix(THOUSAND)}.yaml"
    text = path.read_text("utf-8").replace(f"name: {path.stem}", f"name: {name}")
    if name.endswith(THOUSAND):
        text = re.sub(r"(?<=[ad]\d: )[\d.]+", lambda found: f"{found[0]} * 1000", text)
    if name.endswith(PLACED):
        head, *rows = text.split("theta: q")
        signs = ("-q", "q", "-q", "q", "-q", "q")
        text = head + "".join(f"theta: {q}{row}" for q, row in zip(signs, rows, strict=True))
        kept = [line for line in text.splitlines() if not line.startswith("tool:")]
        text = "\n".join([*kept, BASE, TOOL, ""])
    return RobotFile(path.with_stem(name), load_text(text, name), text)


@cache
def kind(name: str) -> Kind:
    """The kind of arms of a robot file."""
    file = file_of(name)
    return kind_of(file.robot, worked_out_once(file)[1], RESERVED)


@cache
def compiled(folder: Path, name: str, *flags: str) -> Any:
    """The library of a kind."""
    module = kind(name).module
    write_files(folder, kind_files(kind(name)))
    source = folder / f"{module.name}.c"
    build = Build("_".join(["fleet", *(flag.strip("-") for flag in flags)]), ("-O1", *flags))
    solver = compile_solver(source, folder, module.name, 6, 16, 0, shared(source, build))
    assert solver is not None, "the tests need a C compiler"
    return solver.library


def table_of(name: str, noise: float, seed: int = 1) -> np.ndarray:
    """The data sheet's table with errors in every number [rad, arm sizes]."""
    nominal, size = np.array(kind(name).table.rows), kind(name).nominal.chain.size
    errors = np.random.default_rng(seed).normal(0.0, noise, nominal.shape)
    return np.asarray(nominal + errors * [1.0, size, size, 1.0])


def screw(axis: int, angle: float, length: float) -> np.ndarray:
    """A turn about x, y or z (0, 1, 2), and a move along it."""
    T, j, k = np.eye(4), (axis + 1) % 3, (axis + 2) % 3
    T[j, j] = T[k, k] = math.cos(angle)
    T[k, j] = math.sin(angle)
    T[j, k] = -T[k, j]
    T[axis, 3] = length
    return T


def random_joints(count: int, seed: int = 4) -> np.ndarray:
    return np.random.default_rng(seed).uniform(-np.pi, np.pi, (count, 6))


def turned(q: np.ndarray, other: np.ndarray) -> np.ndarray:
    """How far angles are apart, whole turns aside."""
    return np.asarray(np.abs(np.mod(q - other + np.pi, 2.0 * np.pi) - np.pi))


def assert_alike(
    found: tuple[np.ndarray, np.ndarray], wanted: tuple[np.ndarray, np.ndarray]
) -> None:
    """The same solutions with the same statuses, in any rows."""
    for rows, status, others, kinds in zip(*found, *wanted, strict=True):
        np.testing.assert_array_equal(np.sort(status), np.sort(kinds))
        own, other = ~np.isnan(rows[:, 0]), ~np.isnan(others[:, 0])
        if own.any():
            apart = turned(rows[own][:, None], others[other][None]).max(axis=2)
            np.testing.assert_allclose(apart.min(axis=0), 0.0, atol=1e-8)
            np.testing.assert_allclose(apart.min(axis=1), 0.0, atol=1e-8)
            np.testing.assert_array_equal(status[own], kinds[other][apart.argmin(axis=1)])


def count_alike(rows: np.ndarray, others: np.ndarray) -> int:
    """At how many poses solutions are bit for bit those of another solver, in any rows."""
    return sum(set(map(bytes, a)) == set(map(bytes, b)) for a, b in zip(rows, others, strict=True))
