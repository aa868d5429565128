"""Arms without structure whose tool only points: five joints, and a turn that nobody asks for."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.general.arm import general_kernel
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.robot.load import load
from dhgen.runtime.plain import plain
from tests.general.files import SLIDE, TURNS, alike, skew
from tests.general.solved import joint_values, solve
from tests.oracle.sets import all_solutions

if TYPE_CHECKING:
    from pathlib import Path


POSES = 2
PARALLEL = """name: arm
task: pointing
tool: {{xyz: [0.05, 0, 0.2], rpy: [0, 45 deg, 0]}}
joints:
  - {{theta: q, d: 0.4, a: 0.1, alpha: pi/2}}
  - {{theta: q, d: 0, a: 0.5, alpha: 0}}
  - {{theta: q, d: 0, a: 0.45, alpha: 0}}
  - {{theta: q + pi/2, d: {}, a: 0, alpha: pi/2}}
  - {{theta: q, d: 0.12, a: 0, alpha: 0}}
"""


@pytest.mark.slow
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
        assert found.certain
        expected = all_solutions(arm, T, values)
        rows_found = joint_values(found.q, chain)
        solved = [joint for joint in range(chain.dof) if joint + 1 not in given]
        assert len(rows_found) == len(expected)
        for row in expected[:, solved]:
            turns = np.remainder(rows_found - row + np.pi, 2 * np.pi) - np.pi
            assert np.abs(turns).max(axis=1).min() < 1e-6


# q: where two and four of a pose's solutions used to be found
@pytest.mark.slow
@pytest.mark.parametrize(
    ("d4", "q"),
    [
        (0.08, (1.0075, -1.5987, 1.6871, -1.8116, 2.0815)),
        (0.0, (0.742, 2.783, 1.732, -1.727, -1.256)),
    ],
)
def test_each_formulation_finds_both_elbows(
    tmp_path: Path, d4: float, q: tuple[float, ...]
) -> None:
    """Axes 2 to 4 are parallel: on the right side of a formulation they leave two solutions."""
    path = tmp_path / "arm.yaml"
    path.write_text(PARALLEL.format(d4), encoding="utf-8")
    arm = load(path)
    chain = build_chain(arm)
    kernel, T = general_kernel(chain), numeric_arm(chain).pose(np.array(q))
    assert kernel is not None
    expected = all_solutions(arm, T)
    assert len(kernel.formulations) == 2
    for formulation in kernel.formulations:
        found = solve(T, replace(kernel, formulations=(formulation,)))
        assert found.certain
        same = alike(joint_values(found.q, chain), expected, np.full(5, fill_value=True))
        np.testing.assert_array_equal(same.sum(axis=0), 1)
        np.testing.assert_array_equal(same.sum(axis=1), 1)


@pytest.mark.parametrize(
    "z", [(0.0, 0.0, 1.0), (0.0, 0.0, -1.0), (0.6, 0.0, -0.8), (0.0, 1.0, -0.0)]
)
def test_the_turn_is_a_rotation(z: tuple[float, float, float]) -> None:
    T = np.full((4, 4), np.nan)
    T[:, 2:] = [[z[0], 1.0], [z[1], 2.0], [z[2], 3.0], [0.0, 1.0]]
    whole = T[:3].copy()
    plain("general.rows").any_turn(T, whole.reshape(12))
    np.testing.assert_allclose(whole[:, :3] @ whole[:, :3].T, np.eye(3), atol=1e-15)
    assert np.linalg.det(whole[:, :3]) == pytest.approx(1.0)
    np.testing.assert_array_equal(whole[:, 2:], T[:3, 2:])
