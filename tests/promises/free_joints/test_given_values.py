"""Values of a given joint at which axes become parallel cost no solution."""

from __future__ import annotations

import numpy as np
import pytest

from tests.targets.calling import HELD, LANGUAGES, OK, Solver, gap
from tests.targets.made import poses_of, residual

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

ARM, GIVEN = "upright_shoulder", 2  # the joint, from 0
ELBOW = 3


@pytest.mark.parametrize("value", [0.0, 1e-12, -1e-9, np.pi / 2, np.pi])
@pytest.mark.parametrize("language", LANGUAGES)
def test_both_elbows_are_found(language: str, value: float) -> None:
    """Axes 2 and 4 are parallel at 0 and pi: the elbow may point either way, as elsewhere."""
    q = np.random.default_rng(19).uniform(-2.0, 2.0, (40, 7))
    q[:, GIVEN] = value
    for joints, T in zip(q, poses_of(ARM, q), strict=True):
        rows, status = Solver(ARM, language).all(T, np.zeros(7), joints[[GIVEN]])
        held = np.isin(status, HELD)
        assert (status[held] == OK).all()
        assert gap(rows[held], joints).min() < 1e-8
        assert residual(ARM, rows[held], T) < 1e-11
        if value in {0.0, np.pi}:
            assert np.sort(np.sin(rows[held][:, ELBOW]))[[0, -1]].prod() < 0.0


# Near both: axes 1 and 3 in one line, and the arm stretched.
RIGHT, LITTLE = np.pi / 2 + 1e-10, 1e-8
IN_LINE = (-RIGHT, LITTLE - np.pi / 2, -RIGHT, LITTLE, 0.7535013100473, RIGHT, -RIGHT)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("seed", [np.zeros(7), np.full(7, 0.7)])
def test_rows_are_exact_whatever_the_seed(seed: np.ndarray, language: str) -> None:
    """A nearly free joint takes the seed's value, and the others what makes up for it."""
    name, q = "given_shoulder", np.array(IN_LINE)
    T = poses_of(name, q[None])[0]
    rows, status = Solver(name, language).all(T, seed, q[[1]])
    held = np.isin(status, HELD)
    assert held.any()
    assert residual(name, rows[held], T) < 1e-11
