"""The committed files at work: modules imported where they lie, C compiled elsewhere."""

from __future__ import annotations

import sys
import tempfile
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dhgen.oracle.arm_angle import given_values
from dhgen.robot.load import load
from dhgen.verify.native import PORTABLE, CompiledSolver, compile_solver
from tests.compiling import shared
from tests.serial import SERIAL
from tests.structures import COMPILED
from tests.targets.made import without_numba

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Robot

ROOT = Path(__file__).resolve().parents[2]
GENERATED = ROOT / "generated"
ROBOTS = ROOT / "robots"
NAMES = SERIAL
_KEPT: list[tempfile.TemporaryDirectory[str]] = []


@cache
def folder() -> Path:
    """Where this process puts what it makes."""
    kept = tempfile.TemporaryDirectory(prefix="dhgen-generated-")
    _KEPT.append(kept)
    return Path(kept.name)


@cache
def robot(name: str) -> Robot:
    """What the robot file says."""
    return load(ROBOTS / f"{name}.yaml")


@cache
def module(name: str) -> Any:
    """The module, numba and all; what numba makes of it is kept in __pycache__ for other runs."""
    if str(GENERATED) not in sys.path:
        sys.path.append(str(GENERATED))
    return import_module(name)


@cache
def short_module(name: str) -> Any:
    """The module as numba makes it of few arms, of others as it is written: numba takes long."""
    if name in COMPILED:
        return module(name)
    return without_numba((GENERATED / f"{name}.py").read_text(encoding="utf-8"), name)


@cache
def library(name: str) -> CompiledSolver:
    """The C, compiled with warnings as errors; its runtime once for all."""
    python, count = module(name), len(robot(name).free) + robot(name).arm_angle
    source = GENERATED / f"{name}.c"
    shape = python.DOF, python.MAX_SOLUTIONS, count
    compiled = compile_solver(source, folder(), name, *shape, shared(source, PORTABLE))
    assert compiled is not None, "the tests need a C compiler"
    return compiled


def given(name: str, q: FloatArray) -> list[FloatArray]:
    """The argument for free joints or the arm angle, where there are any."""
    values = given_values(robot(name), q)
    return [values] if values.shape[-1] else []
