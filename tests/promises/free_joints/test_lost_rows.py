"""Where a pose fixes few joints, or several solutions meet, it has a row all the same."""

from __future__ import annotations

import numpy as np
import pytest

from tests.structures import first_of
from tests.targets.calling import FREE_JOINT, HELD, LANGUAGES, OUT_OF_LIMITS, Solver
from tests.targets.made import poses_of, residual

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

NAME = "two_free"
COUNT = 40
FEW = 10  # in plain Python, which is slow


def upright() -> np.ndarray:
    """The tool points along axis 1: it does not matter how joints 1 and 2 share their turn."""
    q = np.random.default_rng(12).uniform(-3.0, 3.0, (COUNT, 4))
    q[:, 2] = np.where(np.arange(COUNT) % 2, np.pi / 2, -np.pi / 2)
    return q


@pytest.mark.parametrize("language", first_of(LANGUAGES))
def test_every_pose_has_a_row_whatever_the_seed(language: str) -> None:
    solver, q = Solver(NAME, language), upright()
    source = np.random.default_rng(13)
    for values, T in zip(q, poses_of(NAME, q), strict=True):
        for seed in (values, np.zeros(4), source.uniform(-3.0, 3.0, 4)):
            rows, status = solver.all(T, seed)
            held = rows[np.isin(status, HELD)]
            assert len(held), (values.tolist(), seed.tolist())
            assert residual(NAME, held, T) < 1e-11


@pytest.mark.parametrize("language", first_of(LANGUAGES))
def test_what_is_out_of_reach_stays_so(language: str) -> None:
    solver, q = Solver(NAME, language), upright()
    for T in poses_of(NAME, q)[:10]:
        far = T.copy()
        far[:3, 3] += [9.0, 0.0, 0.0]
        rows, status = solver.all(far, np.zeros(4))
        assert not np.isin(status, HELD).any()
        assert np.isnan(rows).all()


@pytest.mark.parametrize("language", first_of(LANGUAGES))
def test_a_free_turn_before_a_slide_that_it_leaves_open(language: str) -> None:
    """At q5 = +-90 degrees zero would do for joint 3, but leaves no length for the telescope."""
    q = np.random.default_rng(14).choice([-np.pi / 2, 0.0, np.pi / 2, np.pi], (COUNT, 6))
    q[:, [0, 3]] = np.random.default_rng(15).choice([-1.0, 0.5, 1.0], (COUNT, 2))
    q[:, 4] = np.where(np.arange(COUNT) % 2, np.pi / 2, -np.pi / 2)
    solver = Solver("telescope", language)
    for values, T in zip(q, poses_of("telescope", q), strict=True):
        for seed in (values, np.zeros(6)):
            rows, status = solver.all(T, seed)
            held = rows[np.isin(status, HELD)]
            assert len(held), (values.tolist(), seed.tolist())
            assert residual("telescope", held, T) < 1e-11


@pytest.mark.parametrize("language", first_of(LANGUAGES))
def test_where_four_solutions_meet(language: str) -> None:
    """The arm is stretched and vertical: its turn is free, and steps get slow beside solutions."""
    source = np.random.default_rng(16)
    q = source.choice([-np.pi / 2, 0.0, np.pi / 2, np.pi], (COUNT, 7))
    q[:, :2] = source.uniform(-0.25, 0.25, (COUNT, 2))
    q[:, 3:6] = [np.pi / 2, 0.0, 0.0]
    solver = Solver("trolley", language)
    q = q if language == "C" else q[:: COUNT // FEW]
    for values, T in zip(q, poses_of("trolley", q), strict=True):
        rows, status = solver.all(T, np.zeros(7), values[:1])
        held = rows[np.isin(status, HELD)]
        assert len(held), values.tolist()
        assert residual("trolley", held, T) < 1e-11


@pytest.mark.parametrize("language", LANGUAGES)
def test_joints_that_keep_their_limits_only_together(language: str) -> None:
    """The turn is free, but only half a turn lets the slides keep their limits, at few lengths."""
    source, solver = np.random.default_rng(17), Solver("turret", language)
    for length in np.linspace(0.3, 0.55, 6):
        q = np.array([0.02, source.choice([-np.pi, np.pi]), length, 0.0, source.uniform(-3, 3)])
        q[3] = source.choice([-np.pi / 2, np.pi / 2])
        T = poses_of("turret", q[None])[0]
        rows, status = solver.all(T, np.zeros(5), q[4:])
        assert FREE_JOINT in status, q.tolist()
        assert OUT_OF_LIMITS not in status
        assert residual("turret", rows[np.isin(status, HELD)], T) < 1e-11
