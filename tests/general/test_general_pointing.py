"""Arms without structure whose tool only points: five joints, and a turn that nobody asks for."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.general.arm import general_kernel, joint_values
from dhgen.general.pointing import any_turn
from dhgen.general.reference import solve
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.survey.oracle.newton import all_solutions
from tests.general.files import SLIDE, TURNS, skew

if TYPE_CHECKING:
    from pathlib import Path


POSES = 2


@pytest.mark.parametrize(
    ("place", "free"), [*((place, None) for place in range(6)), (0, 1), (0, 6), (3, 6)]
)
def test_all_solutions(tmp_path: Path, place: int, free: int | None) -> None:
    """Without a slide (place 0) and with one at each place; and on a joint that is given."""
    rows = TURNS if place == 0 else (*TURNS[: place - 1], SLIDE, *TURNS[place:])
    given = [] if free is None else [free]
    if free is not None:
        rows = (*rows, TURNS[0]) if free == len(rows) + 1 else (SLIDE, *rows)
    arm = skew(tmp_path, rows, given, "pointing")
    chain = build_chain(arm)
    kernel, forward = general_kernel(chain), numeric_arm(chain)
    assert kernel is not None
    for q in np.random.default_rng(place).uniform(-1.5, 1.5, (POSES, chain.dof)):
        T = forward.pose(q)
        T[:3, :2] = np.nan  # nobody names them
        values = [q[number - 1] for number in given]
        found = solve(T, kernel, values)
        assert found.complete
        expected = all_solutions(arm, T, values)
        rows_found = joint_values(found.q, chain)
        solved = [joint for joint in range(chain.dof) if joint + 1 not in given]
        assert len(rows_found) == len(expected)
        for row in expected[:, solved]:
            turns = np.remainder(rows_found - row + np.pi, 2 * np.pi) - np.pi
            assert np.abs(turns).max(axis=1).min() < 1e-6


@pytest.mark.parametrize(
    "z", [(0.0, 0.0, 1.0), (0.0, 0.0, -1.0), (0.6, 0.0, -0.8), (0.0, 1.0, -0.0)]
)
def test_the_turn_is_a_rotation(z: tuple[float, float, float]) -> None:
    T = np.full((4, 4), np.nan)
    T[:, 2:] = [[z[0], 1.0], [z[1], 2.0], [z[2], 3.0], [0.0, 1.0]]
    whole = any_turn(T)
    np.testing.assert_allclose(whole[:3, :3] @ whole[:3, :3].T, np.eye(3), atol=1e-15)
    assert np.linalg.det(whole[:3, :3]) == pytest.approx(1.0)
    np.testing.assert_array_equal(whole[:, 2:], T[:, 2:])
