"""Rows of arms near a structure: the nearest arm's, by the posture of each solution."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.kinematics.numeric import numeric_arm
from dhgen.program.interpret import interpret, outputs
from dhgen.runtime import c_runtime_files
from dhgen.runtime.python.calibration import FACING, MORE
from dhgen.verify.calibrated import FleetArm, poses_of
from tests.compiling import library, written
from tests.nominal.fleets import (
    EACH,
    compiled,
    count_alike,
    kind,
    random_joints,
    table_of,
    turned,
)
from tests.nominal.twins import coupled, geared, seven, twin
from tests.structures import quick_first

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.program.ir import Program
    from dhgen.program.regular.unguarded import Regular

POSES = 600
STEPS = 400
CLEAR = 1e-2  # of a determinant's largest size on a way: nearer to zero its sign may be rounding's


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where kinds' C is written, with the runtime beside it."""
    made = tmp_path_factory.mktemp("postures")
    write_files(made, c_runtime_files())
    return made


def fleet(folder: Path, name: str, noise: float, *flags: str) -> FleetArm:
    return FleetArm(compiled(folder, name, *flags), kind(name), table_of(name, noise))


def nominal_values(arm: FleetArm, q: np.ndarray) -> np.ndarray:
    """Joint values of the nominal arm whose zeros are where the arm's are."""
    return q + arm.numbers[FACING : FACING + 6] * arm.numbers[MORE : MORE + 6]


def assert_by_posture(
    rows: np.ndarray,
    values: np.ndarray,
    poses: np.ndarray,
    solver: Program,
    regular: Regular,
    given: np.ndarray,
) -> int:
    """Solutions of a pose stand in the rows in which the nearest arm has them; how many do not.

    Another solution has that row first, or the nearest arm's formulas leave the pose.

    Args:
        rows: Of joint values, (16, n).
        values: What they are in the nearest arm's closed form, (16, n).
        poses: Of the nearest arm there, (16, 4, 4).
        solver: The closed form.
        regular: The same of regular poses.
        given: What the caller gives, (16, g).
    """
    there, begin = ~np.isnan(rows[:, 0]), solver.rows
    found = interpret(solver, np.nan_to_num(poses), np.nan_to_num(values), given).q
    off = turned(found, values[:, None]).max(axis=2)
    own = [row for row in np.flatnonzero(there) if row < begin]
    assert all(off[row, row] < 1e-6 for row in own)
    behind = [row for row in np.flatnonzero(there) if row >= begin]
    exactly = np.concatenate([given, np.zeros((len(rows), 2))], axis=1)
    doubts = outputs(regular.program, np.nan_to_num(poses), free=exactly)[len(regular.joints) :]
    left = np.any([each.reshape(len(rows), -1).any(axis=1) for each in doubts], axis=0)
    for row in behind:
        posture = int(np.nan_to_num(off[row], nan=np.inf).argmin())
        comes_first = there[posture] and tuple(rows[posture]) < tuple(rows[row])
        assert comes_first or left[row] or off[row, posture] > 1e-6
    return len(behind)


@pytest.mark.parametrize("noise", quick_first([1e-3, 1e-4]))
@pytest.mark.parametrize("name", EACH)
def test_rows_are_postures(name: str, noise: float, folder: Path) -> None:
    """Those of the general algorithm, too: the nominal solver's rows are those of the IR."""
    arm, of = fleet(folder, name, noise), kind(name)
    assert of.module.branches[: of.nominal.solver.rows] == of.nominal.branches
    T = poses_of(of, table_of(name, noise), random_joints(POSES))
    further, nominal, none = 0, np.array(of.table.rows), np.zeros((16, 0))
    for rows, _ in zip(*arm.batch(T), strict=True):
        values = nominal_values(arm, rows)
        poses = poses_of(of, nominal, values)
        further += assert_by_posture(rows, values, poses, of.nominal.solver, of.regular, none)
    assert further < 0.1 * POSES


@pytest.mark.parametrize("name", EACH)
def test_solutions_keep_their_rows_along_ways(name: str, folder: Path) -> None:
    """As long as the nominal arm crosses no singular pose, and no other one has the posture."""
    of, noise = kind(name), 1e-3
    arm = fleet(folder, name, noise)
    alone = fleet(folder, name, noise, f"-D{of.module.name.upper()}_PLAIN")
    nominal, begin_further = numeric_arm(of.nominal.chain), of.nominal.solver.rows
    left = changed = 0
    for number in range(4):
        begin, end = random_joints(2, seed=number)
        q = begin + np.linspace(0.0, 1.0, STEPS)[:, None] * (end - begin)
        T = poses_of(of, table_of(name, noise), q)
        rows, _ = arm.batch(T)
        left += count_alike(rows, alone.batch(T)[0])
        off = np.nan_to_num(turned(rows, q[:, None]).max(axis=2), nan=np.inf)
        own = off.argmin(axis=1)
        np.testing.assert_allclose(off.min(axis=1), 0.0, atol=1e-7)
        J = np.array([nominal.jacobian(each) for each in nominal_values(arm, q)])
        determinant = np.linalg.det(J)
        clear = np.abs(determinant) > CLEAR * np.abs(determinant).max()
        for k in range(STEPS - 1):
            if clear[k] and clear[k + 1] and determinant[k] * determinant[k + 1] > 0.0:
                row, other = sorted(own[k : k + 2])
                behind = rows[k if own[k] == other else k + 1]
                is_taken = row < begin_further <= other and not np.isnan(behind[row, 0])
                assert row == other or is_taken, (number, k)
                changed += row != other
    assert 0 < left < 3 * STEPS  # both ways are taken
    assert changed <= 0.01 * 4 * STEPS


@pytest.mark.slow
@pytest.mark.parametrize(
    "text",
    [
        twin("puma560", 1e-3),
        coupled(twin("puma560", 1e-4)),
        geared(twin("kuka_kr6_r900", 1e-3)),
        seven("wrist_missed"),
    ],
)
def test_rows_are_postures_of_the_nearest_arm(text: str, tmp_path: Path) -> None:
    """At compile time: with coupled drives, and with a joint whose value is given."""
    path = tmp_path / "twin.yaml"
    path.write_text(text, encoding="utf-8")
    module = written(path, tmp_path).module
    nominal, chain = module.nominal, module.chain
    assert nominal is not None
    assert module.branches[: nominal.solver.rows] == nominal.solver.branches
    q = np.random.default_rng(4).uniform(-np.pi, np.pi, (POSES, chain.dof))
    free = [number - 1 for number in chain.free]
    given = q[:, free] if free else None
    T, own = numeric_arm(chain).pose(q), numeric_arm(nominal.chain)
    for rows in library(module, tmp_path).batch(T, given)[0]:
        values = chain.drives.values(rows) + np.array(nominal.nearest.offsets)
        values[:, free] = rows[:, free]
        solver, regular = nominal.solver, nominal.regular
        assert_by_posture(
            rows, values, own.pose(values), solver, regular, np.nan_to_num(rows[:, free])
        )
