"""Where a joint is free it takes a value that keeps every limit, the nearest to the seed's."""

from __future__ import annotations

import numpy as np
import pytest

from tests.targets.calling import FREE_JOINT, LANGUAGES, OK, OUT_OF_LIMITS, Solver
from tests.targets.made import poses_of, residual, robot

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

WRIST, RAIL = "hard_stops", "short_rail"
COUNT = 25
TURN = 2 * np.pi
STEP = 1e-4  # between values of the oracle [rad]


def limits(name: str) -> np.ndarray:
    """Lowest and highest value of each joint, (2, n)."""
    none = (-np.inf, np.inf)
    return np.array([joint.limits or none for joint in robot(name).joints], dtype=float).T


def straight(count: int = COUNT) -> np.ndarray:
    """Joint vectors inside the limits with a straight wrist: only q4 + q6 tells in the pose."""
    low, high = limits(WRIST)
    q = np.random.default_rng(6).uniform(low, high, (count, 6))
    q[:, 4] = 0.0
    return q


def seeds(name: str) -> list[np.ndarray]:
    """Anywhere, inside the limits or not."""
    source = np.random.default_rng(7)
    q: np.ndarray = source.uniform(-4.0, 4.0, (COUNT, len(robot(name).joints)))
    return [np.zeros(q.shape[1]), np.full(q.shape[1], 1e9), *q]


def turned(angle: np.ndarray) -> np.ndarray:
    return np.asarray(angle - TURN * np.round(angle / TURN))


def nearest_inside(total: float, seed: float) -> float:
    """How far q4 has to be from the seed's value so that it and q6 = total - q4 keep the limits."""
    low, high = limits(WRIST)
    fourth = np.arange(low[3], high[3] + STEP, STEP)
    sixth = total - fourth
    sixth = sixth - TURN * np.floor((sixth - low[5]) / TURN)  # the copy above the lower limit
    return float(np.abs(turned(fourth[sixth <= high[5]] - seed)).min())


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_straight_wrist_keeps_its_stops(language: str) -> None:
    solver, (low, high) = Solver(WRIST, language), limits(WRIST)
    q = straight()
    for values, T in zip(q, poses_of(WRIST, q), strict=True):
        for seed in seeds(WRIST)[:6]:
            rows, status = solver.all(T, seed)
            assert status.tolist().count(FREE_JOINT) == 1
            (row,) = rows[status == FREE_JOINT]
            assert ((low - 1e-9 <= row) & (row <= high + 1e-9)).all()
            assert residual(WRIST, row[None], T) < 1e-12
            least = nearest_inside(values[3] + values[5], seed[3])
            assert abs(turned(row[3] - seed[3])) <= least + 2 * STEP


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_slide_that_is_free_stays_on_its_rail(language: str) -> None:
    """Joint 1 is free where joint 2 has laid the arm's plane across the rail."""
    solver, (low, high) = Solver(RAIL, language), limits(RAIL)
    q = np.random.default_rng(8).uniform(-2.0, 2.0, (COUNT, 5))
    q[:, 0], q[:, 1] = np.linspace(0.51, 2.99, COUNT), -np.pi / 2
    for values, T in zip(q, poses_of(RAIL, q), strict=True):
        for seed in [values, *seeds(RAIL)[:4]]:
            rows, status = solver.all(T, seed)
            inside = rows[status == FREE_JOINT]
            assert len(inside), (values.tolist(), seed.tolist())
            assert (low[0] - 1e-9 <= inside[:, 0]).all()
            assert (inside[:, 0] <= high[0] + 1e-9).all()
            assert residual(RAIL, inside, T) < 1e-11


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_no_value_keeps_is_beyond_the_limits(language: str) -> None:
    """The wrist is straight, but the gantry is not long enough: a free joint mends nothing."""
    solver, q = Solver(WRIST, language), straight(6)
    q[:, 0] = 6.5
    for values, T in zip(q, poses_of(WRIST, q), strict=True):
        rows, status = solver.all(T, values)
        (row,) = rows[status == OUT_OF_LIMITS]
        assert row[0] == pytest.approx(6.5)
        assert turned(row[3] - values[3]) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(
    ("name", "given", "inside"),
    [
        ("given_turns", 7.0, 7.0 - TURN),
        ("given_turns", -3.4, -3.4),
        ("given_turns", 40.0, 40.0 - 6 * TURN),
        ("given_short", 0.3 + TURN, 0.3),
        ("given_short", -3.4, TURN - 3.4),
    ],
)
def test_given_values_are_moved_into_limits(
    name: str, given: float, inside: float, language: str
) -> None:
    """By whole turns, where they are beyond them; a batch does the same."""
    T = poses_of(name, np.array([[inside, 0.4, 0.5]]))[0]
    rows, status = Solver(name, language).all(T, free=np.array([given]))
    assert status.tolist() == [OK, OK]
    np.testing.assert_allclose(rows[:, 0], inside, rtol=0, atol=1e-12)
    np.testing.assert_allclose(rows[0], [inside, 0.4, 0.5], rtol=0, atol=1e-12)
    together, kinds = Solver(name, language).batch(T[None], np.array([[given]]))
    np.testing.assert_allclose(together[0], rows, rtol=0, atol=1e-12)
    assert kinds[0].tolist() == [OK, OK]


@pytest.mark.parametrize("language", LANGUAGES)
def test_given_values_that_no_turn_brings_inside(language: str) -> None:
    T = poses_of("given_short", np.array([[3.05, 0.4, 0.5]]))[0]
    _, status = Solver("given_short", language).all(T, free=np.array([3.05]))
    assert status.tolist() == [OUT_OF_LIMITS, OUT_OF_LIMITS]
