"""Poses beside a straight wrist, of arms whose wrist is missed by one length alone.

There a branch of the nominal arm has three solutions, not one, before it ends.
"""

from __future__ import annotations

import shutil
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.kinematics.numeric import numeric_arm
from dhgen.runtime import c_runtime_files
from dhgen.runtime.python.calibrate import TAKEN
from dhgen.verify.calibrated import FleetArm, poses_of
from dhgen.verify.native import PORTABLE
from tests.compiling import library, written
from tests.nominal.fleets import assert_alike, compiled, kind, turned
from tests.nominal.twins import SIX

if TYPE_CHECKING:
    from pathlib import Path

POSES = 3000
TOGETHER = 1e-4  # [rad] solutions nearer than this may be one row beside a singular pose


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the kind's C is written, with the runtime beside it."""
    made = tmp_path_factory.mktemp("straight")
    write_files(made, c_runtime_files())
    return made


def straight(count: int) -> np.ndarray:
    """Joint values with joint 5 next to zero, or to half a turn."""
    source = np.random.default_rng(21)
    q = source.uniform(-np.pi, np.pi, (count, 6))
    off = source.choice([-1.0, 1.0], count) * 10.0 ** source.uniform(-5.0, -2.0, count)
    q[:, 4] = source.choice([0.0, np.pi], count) + off
    return np.asarray(q)


def assert_found(rows: np.ndarray, q: np.ndarray) -> None:
    for each, joints in zip(rows, q, strict=True):
        solutions = each[~np.isnan(each[:, 0])]
        assert turned(solutions, joints).max(axis=1).min() < TOGETHER


# d of row 5 and a of rows 4 and 5: each parts two of the wrist's axes.
@pytest.mark.slow
@pytest.mark.parametrize(("row", "column", "by"), [(4, 1, 2e-4), (4, 2, -1e-4), (3, 2, 3e-4)])
def test_fleets_have_all_solutions(row: int, column: int, by: float, folder: Path) -> None:
    name, q = "puma560", straight(POSES)
    table = np.array(kind(name).table.rows)
    table[row, column] += by
    arm, plain = (
        FleetArm(made, kind(name), table)
        for made in (compiled(folder, name), compiled(folder, name, "-DPUMA560_FLEET_PLAIN"))
    )
    assert arm.fault == plain.fault == TAKEN
    T = poses_of(kind(name), table, q)
    rows, status = arm.batch(T)
    assert_alike((rows, status), plain.batch(T))
    assert_found(rows, q)


@pytest.mark.slow
def test_an_arm_of_its_own_has_the_solutions_of_the_general_algorithm(tmp_path: Path) -> None:
    path = tmp_path / "six.yaml"
    path.write_text(SIX, encoding="utf-8")
    module = written(path, tmp_path).module
    assert module.nominal is not None
    plain = replace(PORTABLE, flags=(*PORTABLE.flags, "-DSIX_PLAIN"))
    (tmp_path / "plain").mkdir()
    shutil.copytree(tmp_path, tmp_path / "plain", dirs_exist_ok=True, ignore=lambda *_: ["plain"])
    fast, general = library(module, tmp_path), library(module, tmp_path / "plain", plain)
    poses = numeric_arm(module.chain).pose(straight(POSES))
    assert_alike(fast.batch(poses), general.batch(poses))
