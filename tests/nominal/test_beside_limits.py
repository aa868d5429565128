"""Rows that are beyond a limit by little, of arms whose tables come at run time."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.runtime import c_runtime_files
from dhgen.status import Status
from dhgen.verify.calibrated import FleetArm, poses_of
from tests.nominal.fleets import (
    assert_alike,
    compiled,
    file_of,
    kind,
    random_joints,
    table_of,
)
from tests.structures import quick_first

if TYPE_CHECKING:
    from pathlib import Path

OFFS = (1e-12, 1e-7, 5e-5, 2e-4, 5e-3, 2e-2)  # [rad]


@pytest.mark.parametrize("name", quick_first(["puma560", "abb_irb120"]))
def test_statuses_beside_limits(name: str, tmp_path: Path) -> None:
    """The general algorithm alone has the same ones, and moves no row to a limit that it misses."""
    write_files(tmp_path, c_runtime_files())
    table, upper = table_of(name, 1e-4), kind(name).module.name.upper()
    near, alone = (
        FleetArm(compiled(tmp_path, name, *flags), kind(name), table)
        for flags in ((), (f"-D{upper}_PLAIN",))
    )
    joints = file_of(name).robot.joints
    asked = 0
    for i, joint in enumerate(joints):
        low, high = joint.limits or (-np.inf, np.inf)
        if high - low > 6.0:
            continue  # next to no gap, or none
        for off in OFFS:
            q = random_joints(4, seed=i)
            q[:, i] = [low - off, high + off, low + off, high - off]
            T = poses_of(kind(name), table, q)
            found, wanted = near.batch(T), alone.batch(T)
            assert_alike(found, wanted)
            own, other = (np.sort(rows[..., i], axis=1) for rows, _ in (found, wanted))
            np.testing.assert_allclose(own, other, rtol=0.0, atol=1e-7)
            for row, (rows, status) in enumerate(zip(*found, strict=True)):
                own = np.abs(np.nan_to_num(rows[:, i], nan=9.0) - q[row, i]) < 1e-8
                beyond = off > 1e-8 and row < 2
                asked += own.sum()
                assert (status[own] == Status.OUT_OF_LIMITS).all() or not beyond
    assert asked >= len(OFFS)
