"""Solvers with a fault are caught, each by its own number."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import pytest

from dhgen.oracle.arm import arm, arm_size
from dhgen.survey.ask import Random, Singular, ask_random, ask_singular
from dhgen.survey.trial import Trial
from dhgen.verify.native import CompiledSolver, compile_solver
from tests.robots.cases import ROBOTS, robot

if TYPE_CHECKING:
    from collections.abc import Callable

    Rows = tuple[np.ndarray, np.ndarray]

BOUND = 1e-11
NAME = "puma560"


@pytest.fixture(scope="module")
def good(tmp_path_factory: pytest.TempPathFactory) -> CompiledSolver:
    source = ROBOTS.parent / "generated" / f"{NAME}.c"
    solver = compile_solver(source, tmp_path_factory.mktemp("survey"), NAME, 6, 8, 0)
    assert solver is not None
    return solver


@dataclass(frozen=True)
class Spoiled:
    """A solver whose answers are changed."""

    solver: CompiledSolver
    change: Callable[[np.ndarray, np.ndarray], None]

    def ik(self, T: np.ndarray, seed: np.ndarray, free: np.ndarray | None = None) -> Rows:
        rows, status = self.solver.ik(T, seed, free)
        self.change(rows, status)
        return rows, status


def trial(solver: Any) -> Trial:
    each = robot(NAME)
    return Trial(each, arm(each), arm_size(each), cast("CompiledSolver", solver))


def counts(result: Random | Singular) -> tuple[int, ...]:
    if isinstance(result, Random):
        return result.found, result.expected, result.spurious, result.unmet
    return result.answered, result.poses


def lose_the_first(rows: np.ndarray, status: np.ndarray) -> None:
    rows[0], status[0] = np.nan, 1


def repeat_the_first(rows: np.ndarray, status: np.ndarray) -> None:
    rows[1], status[1] = rows[0], status[0]


def turn_a_wrist(rows: np.ndarray, status: np.ndarray) -> None:
    rows[0, 5] += 1e-6 * (status[0] != 1)


def lose_all(rows: np.ndarray, status: np.ndarray) -> None:
    rows[:], status[:] = np.nan, 1


def test_the_good_one(good: CompiledSolver) -> None:
    assert counts(ask_random(trial(good), 5, BOUND)) == (40, 40, 0, 0)
    singular = ask_singular(trial(good), 5, BOUND)
    assert singular.answered == singular.poses > 30
    assert singular.residual < BOUND
    assert not singular.faults


def test_a_missing_row(good: CompiledSolver) -> None:
    result = ask_random(trial(Spoiled(good, lose_the_first)), 5, BOUND)
    assert counts(result) == (35, 40, 0, 0)
    assert len(result.faults) == 4
    assert result.faults[0].startswith("random: 1 of 8 missed, q = [")
    assert result.faults[3] == "random: and 2 more"


def test_a_row_twice(good: CompiledSolver) -> None:
    result = ask_random(trial(Spoiled(good, repeat_the_first)), 5, BOUND)
    assert counts(result) == (35, 40, 5, 0)


def test_a_row_that_is_off(good: CompiledSolver) -> None:
    result = ask_random(trial(Spoiled(good, turn_a_wrist)), 5, BOUND)
    assert counts(result) == (35, 40, 5, 0)
    assert 1e-7 < result.residual < 1e-5
    result = ask_random(trial(Spoiled(good, turn_a_wrist)), 5, 1e-5)
    assert counts(result) == (40, 40, 0, 0)


def test_singular_poses_without_an_answer(good: CompiledSolver) -> None:
    result = ask_singular(trial(Spoiled(good, lose_all)), 2, BOUND)
    assert result.answered == 0
    assert any("no row" in fault for fault in result.faults)


def test_singular_poses_with_a_wrong_answer(good: CompiledSolver) -> None:
    result = ask_singular(trial(Spoiled(good, turn_a_wrist)), 2, BOUND)
    assert result.answered == 0
    assert all("residual" in fault for fault in result.faults if " more" not in fault)


def test_right_angles_with_a_missing_row(good: CompiledSolver) -> None:
    """Another posture's row than that of the joints asked for: only the oracle misses it."""
    result = ask_singular(trial(Spoiled(good, lose_the_first)), 12, BOUND)
    missed = [fault for fault in result.faults if " missed, q = [" in fault]
    assert missed
    assert all(fault.split(":")[0].endswith("right angles") for fault in missed)


def test_the_same_at_every_run(good: CompiledSolver) -> None:
    assert ask_random(trial(good), 3, BOUND) == ask_random(trial(good), 3, BOUND)
    assert ask_singular(trial(good), 3, BOUND) == ask_singular(trial(good), 3, BOUND)
