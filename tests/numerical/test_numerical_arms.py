"""Arms that are solved numerically, from their files to C and Python."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.verify.native import NATIVE, PORTABLE, Build
from tests.compiling import compile_file, library, written
from tests.structures import first_of
from tests.targets.made import without_numba

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.compiler import Compilation
    from dhgen.verify.native import CompiledSolver

HEAD = "name: {name}\nconvention: standard\nnumerical: true\n"
SKEW = (
    "{theta: q, d: 0.3, a: 0.2, alpha: 80 deg}",
    "{theta: q, d: 0.1, a: 0.4, alpha: 25 deg}",
    "{theta: 0.3, d: q, a: 0.15, alpha: 70 deg, limits: [-0.5, 0.8]}",
    "{theta: q, d: 0.2, a: 0.1, alpha: 95 deg}",
    "{theta: q, d: 0.15, a: 0.05, alpha: 50 deg, limits: [-3, 3]}",
    "{theta: q + 0.2, d: 0.1, a: 0.02, alpha: 10 deg}",
    "{theta: -q, d: 0.1, a: 0.02, alpha: 90 deg}",
)
LINK = "{theta: q, a: 0.3, limits: [-2, 2]}"
FOUR = (SKEW[0], SKEW[1], SKEW[3], SKEW[4])
# Mounted askew and asked for x and z: both equations hold both unknowns, and the eliminations
# want at least a position and a direction.
TWO = ("{theta: q, d: 0.3, a: 0.2, alpha: 50 deg}", SKEW[2])
ASKEW = "task: [x, z]\nbase: {rpy: [0.4, 0.3, 0]}"
ARMS = {
    "two": (TWO, ASKEW),
    "pointing": ((SKEW[0], SKEW[1], *SKEW[3:7]), "task: pointing"),
    "orientation": (FOUR, "task: orientation"),
    "seven": (SKEW, ""),
    "planar": ((LINK,) * 4, "task: [x, y]"),
    "three": ((LINK,) * 3, "task: [x, y]"),
    "yaw": ((LINK,) * 4, "task: [x, y, yaw]"),
    "pitch": (SKEW[:6], "task: [x, y, z, pitch]"),
    "tilt": (SKEW[:6], "task: [x, y, z, roll, pitch]"),
    "direction": (FOUR, "task: direction"),
    "given": ((*TWO, SKEW[5]), f"{ASKEW}\nfree: [3]"),
}
FINITE = ("two",)
REDUNDANT = tuple(name for name in ARMS if name not in FINITE and name != "given")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("numerical")


@cache
def made(name: str, folder: Path) -> Compilation:
    rows, rest = ARMS[name]
    path = folder / f"{name}.yaml"
    joints = "\n".join(f"  - {row}" for row in rows)
    path.write_text(f"{HEAD.format(name=name)}joints:\n{joints}\n{rest}\n", encoding="utf-8")
    return written(path, folder)


@cache
def in_c(name: str, folder: Path) -> CompiledSolver:
    return library(made(name, folder).module, folder)


def in_python(name: str, folder: Path) -> Any:
    return without_numba(made(name, folder).files[f"{name}.py"], name)


def joints(name: str, folder: Path, count: int) -> np.ndarray:
    """Random joint values inside the limits."""
    random = np.random.default_rng(5)
    ranges = [j.limits or (-2.5, 2.5) for j in made(name, folder).module.chain.joints]
    return np.array([[random.uniform(*pair) for pair in ranges] for _ in range(count)])


def miss(name: str, rows: np.ndarray, T: np.ndarray, solver: CompiledSolver) -> float:
    """By how much rows miss what the task names, by the emitted forward model."""
    reached = np.array([solver.fk(np.ascontiguousarray(row)) for row in rows]) - T
    entries = {
        **dict.fromkeys(("two", "given"), (slice(0, 3, 2), slice(3, 4))),
        "pointing": (slice(0, 3), slice(2, 4)),
        "orientation": (slice(0, 3), slice(0, 3)),
        **dict.fromkeys(("planar", "three"), (slice(0, 2), slice(3, 4))),
        "yaw": (slice(0, 2), slice(0, 4, 3)),
        "pitch": (slice(0, 3), slice(3, 4)),
        "tilt": (slice(0, 3), slice(3, 4)),
        "direction": (slice(0, 3), slice(2, 3)),
    }.get(name, (slice(0, 3), slice(0, 4)))
    if name in {"pitch", "tilt"}:
        third = reached[:, 2, : 1 if name == "pitch" else 3]
        assert np.abs(third).max(initial=0.0) < 1e-9
    return float(np.abs(reached[(slice(None), *entries)]).max(initial=0.0))


@pytest.mark.parametrize("name", first_of(ARMS, count=4))
def test_method_is_said(name: str, folder: Path) -> None:
    made(name, folder)
    files = compile_file(folder / f"{name}.yaml").files
    assert 'METHOD = "numerical"' in files[f"{name}.py"]
    assert f'#define {name.upper()}_METHOD "numerical"' in files[f"{name}.h"]
    assert "nothing proves that there are no solutions besides those found" in files[f"{name}.md"]


@pytest.mark.parametrize("name", first_of(REDUNDANT, count=4))
def test_redundant_arms_stay_near_the_seed(name: str, folder: Path) -> None:
    solver, random = in_c(name, folder), np.random.default_rng(1)
    weights = np.array(made(name, folder).module.weights)
    for q in joints(name, folder, 40):
        T = solver.fk(q)
        low, high = np.array(
            [j.limits or (-9, 9) for j in made(name, folder).module.chain.joints]
        ).T
        seed = np.clip(q + 0.2 * random.normal(size=len(q)), low, high)
        rows, status = solver.ik(T, seed)
        assert status.tolist() == [0]
        assert miss(name, rows, T, solver) < 1e-9
        nearest = solver.nearest(T, seed)
        # the generating joints are one of the solutions; there may be nearer ones
        distances = [np.sqrt(weights @ (each - seed) ** 2) for each in (nearest, q)]
        assert distances[0] <= 1.01 * distances[1]
        np.testing.assert_allclose(solver.nearest(T, q), q, atol=1e-7)


def test_limits_of_redundant_arms(folder: Path) -> None:
    """From a seed beyond what the limits allow, the solution is still inside them."""
    solver = in_c("planar", folder)
    T = solver.fk(np.array([1.9, -1.9, 1.9, 0.3]))
    random = np.random.default_rng(3)
    near, far = random.uniform(-2.0, 2.0, (30, 4)), random.uniform(-12.0, 12.0, (60, 4))
    for seed in np.vstack([near, far]):
        q = solver.nearest(T, seed)
        assert np.abs(q).max() <= 2.0 + 1e-9
        assert miss("planar", q[None], T, solver) < 1e-9
    T[:2, 3] = [1.3, 0.0]
    assert solver.ik(T, np.zeros(4))[1].tolist() == [1]


@pytest.mark.parametrize("name", FINITE)
def test_all_solutions_that_the_program_finds(name: str, folder: Path) -> None:
    solver, python = in_c(name, folder), in_python(name, folder)
    turns = np.array(made(name, folder).module.chain.turning)
    for number, q in enumerate(joints(name, folder, 30)):
        T = solver.fk(q)
        rows, status = solver.ik(T, np.zeros(len(q)))
        held = rows[status != 1]
        assert miss(name, held, T, solver) < 1e-9
        gaps = held - q
        gaps[:, turns] = np.remainder(gaps[:, turns] + np.pi, 2 * np.pi) - np.pi
        assert np.abs(gaps).max(axis=1).min() < 1e-6
        assert (np.diff(held[:, 0]) > -1e-9).all()
        if number < 1:
            others, other_status = python.ik_all(T)
            np.testing.assert_allclose(others[other_status != 1], held, atol=1e-8)


def test_free_joints_are_given(folder: Path) -> None:
    solver, python = in_c("given", folder), in_python("given", folder)
    for number, q in enumerate(joints("given", folder, 10)):
        T = solver.fk(q)
        rows, status = solver.ik(T, q, q[[2]])
        held = rows[status != 1]
        np.testing.assert_allclose(held[:, [2]], np.tile(q[[2]], (len(held), 1)))
        assert miss("given", held, T, solver) < 1e-9
        assert np.abs(held - q).max(axis=1).min() < 1e-6
        if number < 1:
            np.testing.assert_allclose(python.ik(T, q[[2]], q), q, atol=1e-6)


def test_what_is_no_pose(folder: Path) -> None:
    solver = in_c("planar", folder)
    assert solver.ik(np.full((4, 4), np.nan), np.zeros(4))[1].tolist() == [4]
    far = np.eye(4)
    far[0, 3] = 9.0
    assert solver.ik(far, np.zeros(4))[1].tolist() == [1]


@pytest.mark.slow
@pytest.mark.parametrize("build", [PORTABLE, NATIVE], ids=lambda build: build.name)
def test_arms_of_three_joints_compile_without_a_warning(build: Build, folder: Path) -> None:
    """In loops so short compilers look for values that are not set."""
    solver, q = library(made("three", folder).module, folder, build), np.array([0.3, 0.4, -0.5])
    rows, status = solver.ik(solver.fk(q), q)
    assert status.tolist() == [0]
    assert miss("three", rows, solver.fk(q), solver) < 1e-9
