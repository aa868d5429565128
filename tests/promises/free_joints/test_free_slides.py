"""A slide is free where another is parallel to it: it takes the seed's value, as a turn does."""

from __future__ import annotations

import numpy as np
import pytest

from tests.structures import first_of
from tests.targets.calling import FREE_JOINT, HELD, LANGUAGES, OK, UNREACHABLE, Solver
from tests.targets.made import poses_of, residual, robot

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

NAME = "folding_slides"  # slides 1 and 4 are parallel at q3 = 90 degrees
COUNT = 30


def joints(third: float) -> np.ndarray:
    q = np.random.default_rng(3).uniform(-0.9, 0.9, (COUNT, 5))
    q[:, 2] = third
    return q


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("third", [np.pi / 2, -np.pi / 2])
def test_parallel(language: str, third: float) -> None:
    solver, q = Solver(NAME, language), joints(third)
    for values, T in zip(q, poses_of(NAME, q), strict=True):
        seed = values + 0.2
        rows, status = solver.all(T, seed)
        free = rows[status == FREE_JOINT]
        assert len(free) == 1
        assert free[0, 3] == seed[3]
        assert residual(NAME, free, T) < 1e-12
        assert status[status != FREE_JOINT].tolist() == [UNREACHABLE]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("off", [1e-6, 1e-8, 1e-10])
def test_nearly_parallel(language: str, off: float) -> None:
    """Only what lies beside the joints that made the pose is near enough to be a solution."""
    solver, q = Solver(NAME, language), joints(np.pi / 2 + off)
    for values, T in zip(q, poses_of(NAME, q), strict=True):
        rows, status = solver.all(T, values)
        held = rows[np.isin(status, HELD)]
        assert len(held) == 1
        assert residual(NAME, held, T) < 1e-12
        assert abs(held[0, 2] - values[2]) < 1e-9


@pytest.mark.parametrize("language", first_of(LANGUAGES))
def test_a_slide_that_would_be_endless_gets_another_value_of_the_free_joint(language: str) -> None:
    """Slide 4 is a quotient by the sine of joint 3, which is free and zero without a seed."""
    name = "slide_by_quotient"
    low, high = np.array([joint.limits or (0.0, 0.0) for joint in robot(name).joints]).T
    source, solver = np.random.default_rng(5), Solver(name, language)
    for _ in range(6 if language == "Python" else 60):
        q = source.uniform(low, high)
        q[4] = source.choice([-np.pi / 2, np.pi / 2])
        T = poses_of(name, q[None])[0]
        for seed in (None, np.where(np.arange(6) == 2, 0.0, q)):
            rows, status = solver.all(T, seed)
            inside = rows[np.isin(status, (OK, FREE_JOINT))]
            assert len(inside) > 0
            assert (inside >= low - 2e-9).all()
            assert (inside <= high + 2e-9).all()
            assert residual(name, inside, T) < 1e-11
