"""Solvers made in the tests: compiled robots, their C as a library, their Python without numba.

Those of structures and of robots made up for the tests are made by the compiler as it is; of the
project's other robots the written files serve, which it takes seconds to make anew.
"""

from __future__ import annotations

import re
import sys
import tempfile
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.oracle.arm import arm, arm_size
from dhgen.oracle.arm_angle import given_values
from dhgen.oracle.forward import forward
from dhgen.oracle.problem import task_entries
from dhgen.robot.load import load
from dhgen.robot.robot import JointKind
from dhgen.runtime import runtime_files
from dhgen.verify.native import PORTABLE, Build, CompiledSolver, compile_solver, import_module
from tests.compiling import library, sharing, write_new, written
from tests.structures import STRUCTURES, says

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.compiler import Compilation
    from dhgen.oracle.arm import Arm
    from dhgen.robot.robot import Robot

ROBOTS = Path(__file__).resolve().parents[2] / "robots"
GENERATED = ROBOTS.parent / "generated"
# Which of a family of solutions damped least squares find, rounding decides: see tests/numerical.
NAMES = [name for name in STRUCTURES if not says(ROBOTS / f"{name}.yaml", "numerical: true")]
MADE_UP = Path(__file__).parent / "robots"
# Whole turns of these hang together, which most tests know nothing of.
COUPLED = Path(__file__).parent / "coupled"
# Asked for whole poses, which few of their limits allow.
ROUNDED = Path(__file__).parent / "rounded"
MADE_UP_NAMES = sorted(path.stem for path in MADE_UP.glob("*.yaml"))


@cache
def folder() -> Path:
    """Where this process puts its files."""
    kept = tempfile.TemporaryDirectory(prefix="dhgen-tests-")
    _KEPT.append(kept)
    return Path(kept.name)


_KEPT: list[tempfile.TemporaryDirectory[str]] = []


def robot_path(name: str) -> Path:
    """The robot's file, of the project or made up for these tests."""
    paths = [folder / f"{name}.yaml" for folder in (ROBOTS, MADE_UP, COUPLED, ROUNDED)]
    return next(path for path in paths if path.exists())


@cache
def robot(name: str) -> Robot:
    """What the file says."""
    return load(robot_path(name))


@cache
def model(name: str) -> Arm:
    """Its numbers: worked out for each call they took longer than what is asked of them."""
    return arm(robot(name))


@cache
def size(name: str) -> float:
    """How large it is."""
    return arm_size(robot(name))


@cache
def made(name: str) -> Compilation:
    """A robot's files, written to the folder."""
    return written(robot_path(name), folder())


def made_up(name: str, rows: Sequence[str], rest: str, convention: str = "standard") -> Compilation:
    """The same of an arm that is in no file, with these rows and what else a file may say.

    Each has a name of its own: a library that is open can't be written anew.
    """
    joints = "".join(f"  - {{{row}}}\n" for row in rows)
    text = (
        f"name: {name}\ntitle: made up\nsource: made up\nconvention: {convention}\n"
        f"joints:\n{joints}{rest}"
    )
    assert name not in _MADE_UP or _MADE_UP[name][0] == text, f"{name} is another arm's name"
    if name not in _MADE_UP:
        path = folder() / f"{name}.yaml"
        path.write_text(text, encoding="utf-8")
        _MADE_UP[name] = text, written(path, folder())
    return _MADE_UP[name][1]


_MADE_UP: dict[str, tuple[str, Compilation]] = {}  # whose files lie in the folder, by their names


@cache
def is_written(name: str) -> bool:
    """Whether the files in `generated/` serve."""
    return (ROBOTS / f"{name}.yaml").exists() and name not in STRUCTURES


@cache
def in_c(name: str, build: Build = PORTABLE) -> CompiledSolver:
    """Its C, compiled."""
    if not is_written(name):
        return library(made(name).module, folder(), build)
    source, robot_of = GENERATED / f"{name}.c", robot(name)
    rows = re.search(rf"{name.upper()}_ROWS = (\d+)", source.with_suffix(".h").read_text())
    assert rows is not None
    shape = len(robot_of.joints), int(rows[1]), len(robot_of.free) + robot_of.arm_angle
    solver = compile_solver(source, folder(), name, *shape, sharing(source, build))
    assert solver is not None, "the tests need a C compiler"
    return solver


@cache
def single_in_c(name: str) -> CompiledSolver:
    """Its C in single precision, compiled."""
    module = made(name).single
    assert module is not None
    return library(module, folder())


@cache
def in_python(name: str) -> Any:
    """Its Python, run where numba is absent."""
    if is_written(name):
        return without_numba((GENERATED / f"{name}.py").read_text(encoding="utf-8"), name)
    return without_numba(made(name).files[f"{name}.py"], name)


def without_numba(text: str, name: str) -> Any:
    """A module of this text, imported where numba is absent."""
    path = folder() / "plain" / f"{name}.py"
    write_new(path.parent, {**runtime_files(), path.name: text})
    hidden = {key: sys.modules.pop(key) for key in list(sys.modules) if key.startswith("numba")}
    sys.modules["numba"] = None  # type: ignore[assignment]
    try:
        return import_module(path)
    finally:
        del sys.modules["numba"]
        sys.modules.update(hidden)


def solving(compiled: Compilation, language: str) -> Any:
    """What gives all rows of a pose: `ik` of the C, `ik_all` of the Python without numba."""
    name, text = compiled.robot.name, compiled.files[f"{compiled.robot.name}.py"]
    if (text, language) not in _SOLVING:
        if language == "C":
            _SOLVING[text, language] = library(compiled.module, folder()).ik
        else:
            _SOLVING[text, language] = without_numba(text, name).ik_all
    return _SOLVING[text, language]


_SOLVING: dict[tuple[str, str], Any] = {}  # what was compiled, by the text of the module


def poses_of(name: str, q: FloatArray) -> FloatArray:
    """The poses of joint vectors by the oracle, which shares nothing with the compiler."""
    return np.asarray(forward(model(name), q), dtype=float)


def given(name: str, q: FloatArray) -> list[FloatArray]:
    """The argument for free joints or the arm angle, where there are any."""
    values = given_values(robot(name), q)
    return [values] if values.shape[-1] else []


@cache
def entries(name: str) -> NDArray[np.bool_]:
    """Which of the upper three rows of a pose the task names, (3, 4)."""
    return task_entries(robot(name).task).reshape(3, 4)


@cache
def turning(name: str) -> NDArray[np.bool_]:
    """Which joints turn, (n,)."""
    return np.array([joint.kind is JointKind.REVOLUTE for joint in robot(name).joints])


def apart(name: str, rows: FloatArray, others: FloatArray) -> FloatArray:
    """Differences of joint values, whole turns aside, lengths in arm sizes."""
    miss = np.abs(rows - others)
    turned = np.abs(miss - 2 * np.pi * np.round(miss / (2 * np.pi)))
    return np.where(turning(name), turned, miss / size(name))


def residual(name: str, rows: FloatArray, T: FloatArray) -> float:
    """The largest miss of a pose by joint vectors (N, n), lengths in arm sizes."""
    miss = np.abs(poses_of(name, rows) - T)[:, :3]
    miss[..., 3] /= size(name)
    return float(miss[:, entries(name)].max(initial=0.0))
