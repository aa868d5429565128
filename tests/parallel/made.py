"""Parallel robots, as committed and of the tests: compiled, and what checks them."""

from __future__ import annotations

import shutil
import tempfile
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from dhgen.atomic_write import write_files
from dhgen.oracle.forward import forward
from dhgen.parallel.compile import ParallelCompilation, compile_file
from dhgen.parallel.native import Native, compiled
from dhgen.parallel.verify import are_inside
from dhgen.parallel.worked import reached, square
from dhgen.robot_files import read_file
from dhgen.runtime.python.platform import drives_of
from dhgen.verify.native import import_module
from tests.serial import PARALLEL, ROBOTS

if TYPE_CHECKING:
    from types import ModuleType

    from dhgen.arrays import FloatArray

GENERATED = ROBOTS.parent / "generated"
HERE = Path(__file__).with_name("robots")
NAMES = PARALLEL
OWN = tuple(sorted(path.stem for path in HERE.glob("*.yaml")))
OK = 0
COUNT = 100  # poses
_KEPT: list[tempfile.TemporaryDirectory[str]] = []


@cache
def compilation(name: str) -> ParallelCompilation:
    """What the compiler makes of a robot file."""
    path = (HERE if name in OWN else ROBOTS) / f"{name}.yaml"
    made = compile_file(read_file(path), out=GENERATED)
    assert isinstance(made, ParallelCompilation)
    return made


@cache
def folder() -> Path:
    """Where this process compiles what is committed."""
    kept = tempfile.TemporaryDirectory(prefix="dhgen-parallel-")
    _KEPT.append(kept)
    to = Path(kept.name)
    shutil.copytree(GENERATED / "dhgen", to / "dhgen")
    return to


@cache
def written(name: str) -> Path:
    """Where a robot's files and those of its legs lie: as committed, or as compiled here."""
    if name in OWN:
        write_files(folder(), compilation(name).files)
        return folder()
    for stem in (name, *(chain.name for chain in compilation(name).robot.chains)):
        for suffix in (".c", ".h"):
            shutil.copy(GENERATED / f"{stem}{suffix}", folder())
    return GENERATED


@cache
def native(name: str) -> Native:
    """The C of a robot and its legs."""
    written(name)
    made = compiled(compilation(name).module, folder())
    assert made is not None
    return made


@cache
def python(name: str) -> ModuleType:
    """The module of a robot."""
    return import_module(written(name) / f"{name}.py")


def both(name: str, drives: FloatArray, seed: FloatArray) -> list[tuple[FloatArray, int]]:
    """What the direct model finds in C and in Python: a pose and a status."""
    told, found, _ = native(name).fk(np.ascontiguousarray(drives), seed)
    pose, _, status = python(name).fk(drives, seed)
    return [(found, told), (pose, status)]


@cache
def poses(name: str) -> FloatArray:
    """Poses of the platform that all legs reach within their limits."""
    module, batch = compilation(name).module, native(name).batch
    return reached(module, lambda T: are_inside(batch(T)[1]), COUNT, seed=7)


def mode(name: str, T: FloatArray, row: int = 0) -> FloatArray:
    """Joint values (legs, joints) of a working mode: of each leg one of its good rows."""
    _, q, status = native(name).ik(T)
    good = [rows[told == OK] for rows, told in zip(q, status, strict=True)]
    return np.array([rows[row % len(rows)] for rows in good])


def drives(name: str, q: FloatArray) -> FloatArray:
    """The driven ones of joint values (legs, joints)."""
    return drives_of(compilation(name).module.driven_joints, q)


def miss(name: str, T: FloatArray, q: FloatArray) -> float:
    """By how much joint values (legs, joints) leave the platform, by the oracle [robot sizes]."""
    module = compilation(name).module
    lengths = [row for row in module.freedoms if row < 3]
    worst = 0.0
    for leg, own in zip(module.legs, q, strict=True):
        end = square(leg.leg.base) @ forward(leg.leg.chain, own[: leg.solver.chain.dof])
        off = (end - T @ square(leg.leg.end))[lengths, 3]
        worst = max(worst, float(np.abs(off).max()) / module.size)
    return worst
