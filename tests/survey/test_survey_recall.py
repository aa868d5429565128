"""Recall: a pose whose own joint values are in no row is noticed, unless it is singular."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import pytest

from dhgen.oracle.arm import arm, arm_size
from dhgen.oracle.poses import random_joints
from dhgen.survey import recall
from dhgen.survey.recall import ask_recall
from dhgen.survey.trial import Trial
from dhgen.verify.native import NATIVE, CompiledSolver, compile_solver
from tests.robots.cases import ROBOTS, robot

if TYPE_CHECKING:
    from collections.abc import Callable

NAME = "puma560"
COUNT = 12_345  # more than one batch, and the last one not full


@pytest.fixture(scope="module")
def good(tmp_path_factory: pytest.TempPathFactory) -> CompiledSolver:
    source = ROBOTS.parent / "generated" / f"{NAME}.c"
    solver = compile_solver(source, tmp_path_factory.mktemp("recall"), NAME, 6, 8, 0, NATIVE)
    assert solver is not None
    return solver


@dataclass(frozen=True)
class Spoiled:
    """A solver whose batches are changed."""

    solver: CompiledSolver
    change: Callable[[np.ndarray], None]

    def batch(self, T: np.ndarray, free: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
        rows, status = self.solver.batch(T, free)
        self.change(rows)
        return rows, status


def trial(solver: Any) -> Trial:
    each = robot(NAME)
    return Trial(each, arm(each), arm_size(each), cast("CompiledSolver", solver))


def test_a_good_solver_recalls_every_pose(good: CompiledSolver) -> None:
    asked = ask_recall(trial(good), COUNT)
    assert (asked.poses, asked.recalled, asked.faults) == (COUNT, COUNT, ())


def lose_bent_wrists(rows: np.ndarray) -> None:
    """Rows with joint 5 between 0.500 and 0.503, as a step that degenerates there would."""
    rows[(np.abs(rows[..., 4] - 0.5015) < 0.0015)] = np.nan


def test_a_hole_of_half_a_thousandth_is_counted(good: CompiledSolver) -> None:
    asked = ask_recall(trial(Spoiled(good, lose_bent_wrists)), COUNT)
    q = random_joints(robot(NAME), COUNT, seed=7)
    lost = np.flatnonzero(np.abs(q[:, 4] - 0.5015) < 0.0015)
    assert 0 < len(lost) < COUNT / 1000
    assert asked.recalled == COUNT - len(lost)
    assert str(q[lost[0]].tolist()) in asked.faults[0]


def nudge(rows: np.ndarray) -> None:
    rows[..., 2] += 1e-4


def test_rows_beside_the_joint_values_are_none(
    good: CompiledSolver, monkeypatch: pytest.MonkeyPatch
) -> None:
    bent = np.random.default_rng(5).uniform(0.2, 1.0, (100, 6))  # far from singular places
    monkeypatch.setattr(recall, "random_joints", lambda *_, **__: bent)
    asked = ask_recall(trial(Spoiled(good, nudge)), 100)
    assert asked.recalled == 0
    assert asked.faults[-1] == f"recall: and {100 - recall.SHOWN} more"


def lose_all(rows: np.ndarray) -> None:
    rows[:] = np.nan


def test_a_singular_pose_is_not_counted_as_lost(
    good: CompiledSolver, monkeypatch: pytest.MonkeyPatch
) -> None:
    straight = random_joints(robot(NAME), 50, seed=3)
    straight[:25, 4] = 1e-9  # wrist axes 4 and 6 on one line
    monkeypatch.setattr(recall, "random_joints", lambda *_, **__: straight)
    asked = ask_recall(trial(Spoiled(good, lose_all)), 50)
    assert asked.recalled == 25
