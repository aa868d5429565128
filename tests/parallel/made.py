"""Parallel robots of the project: their files as committed, compiled, and what checks them."""

from __future__ import annotations

import shutil
import tempfile
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from dhgen.parallel.compile import ParallelCompilation, compile_file
from dhgen.parallel.verify import Native, are_inside, compiled
from dhgen.parallel.worked import reached, square
from dhgen.robot_files import read_file
from dhgen.survey.oracle.forward import forward
from tests.serial import PARALLEL, ROBOTS

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

GENERATED = ROBOTS.parent / "generated"
NAMES = PARALLEL
OK = 0
COUNT = 100  # poses
_KEPT: list[tempfile.TemporaryDirectory[str]] = []


@cache
def compilation(name: str) -> ParallelCompilation:
    """What the compiler makes of a robot file."""
    made = compile_file(read_file(ROBOTS / f"{name}.yaml"), out=GENERATED)
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
def native(name: str) -> Native:
    """The committed C of a robot and its legs."""
    for stem in (name, *(chain.name for chain in compilation(name).robot.chains)):
        for suffix in (".c", ".h"):
            shutil.copy(GENERATED / f"{stem}{suffix}", folder())
    made = compiled(compilation(name).module, folder())
    assert made is not None
    return made


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
    legs = compilation(name).module.legs
    return np.array([q[i, joint] for i, leg in enumerate(legs) for joint in leg.driven])


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
