"""Type 11: three slides with turns between them, two of which are solved for together."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.paul.derive import derive
from dhgen.paul.kind import Kind
from tests.oracle.sets import all_solutions
from tests.targets.calling import FREE_JOINT, HELD, LANGUAGES, Solver
from tests.targets.made import in_c, poses_of, residual, robot

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

NAME = "coupled_slides"
SLIDES = [0, 2, 4]


def directions(q: FloatArray) -> FloatArray:
    """The slides' directions, as columns."""
    found: FloatArray = np.asarray(in_c(NAME).jacobian(q), dtype=float)[:3, SLIDES]
    return found


def flat() -> FloatArray:
    """Joint values at which the slides move in one plane: theta4 between two of either volume."""
    q = np.array([0.3, 0.7, -0.2, 0.0, 0.4, 1.1])
    turns = np.linspace(-3.0, 3.0, 25)

    def volume(turn: float) -> float:
        q[3] = turn
        return float(np.linalg.det(directions(q)))

    low, high = next((a, b) for a, b in pairwise(turns) if volume(a) * volume(b) < 0.0)
    for _ in range(80):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if volume(low) * volume(middle) > 0.0 else (low, middle)
    q[3] = low
    return q


def test_the_type_is_11() -> None:
    steps = derive(build_chain(robot(NAME))).steps
    assert [step.kind for step in steps].count(Kind.TWO_LENGTHS) == 1


@pytest.mark.parametrize("language", LANGUAGES)
def test_all_solutions(language: str) -> None:
    solver = Solver(NAME, language)
    source = np.random.default_rng(3)
    q = source.uniform(-1.0, 1.0, (20, 6)) * [1.2, 3.0, 1.2, 3.0, 1.2, 3.0]
    for T in poses_of(NAME, q):
        rows, status = solver.all(T, np.zeros(6))
        found = rows[np.isfinite(rows).all(axis=1)]
        expected = all_solutions(robot(NAME), T)
        assert len(found) == len(expected)
        assert residual(NAME, found, T) < 1e-12
        off = found[:, None] - expected
        off[..., 1::2] = np.remainder(off[..., 1::2] + np.pi, 2 * np.pi) - np.pi
        assert np.abs(off).max(axis=2).min(axis=0).max() < 1e-9
        assert set(status.tolist()) <= {*HELD, 1, 3}


@pytest.mark.parametrize("language", LANGUAGES)
def test_in_one_plane_they_stay_by_the_seed(language: str) -> None:
    q = flat()
    assert abs(np.linalg.det(directions(q))) < 1e-14
    (T,) = poses_of(NAME, q[None])
    null = np.linalg.svd(directions(q))[2][-1]
    solver = Solver(NAME, language)
    for distance in (0.0, 0.05, -0.1):
        seed = q.copy()
        seed[SLIDES] += distance * null
        rows, status = solver.all(T, seed)
        free = rows[status == FREE_JOINT]
        assert residual(NAME, free, T) < 1e-11
        assert np.abs(free - seed).max(axis=1).min() < 1e-6


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("off", [1e-3, 1e-6, 1e-9, 1e-12])
def test_beside_one_plane(language: str, off: float) -> None:
    q = flat()
    q[3] += off
    (T,) = poses_of(NAME, q[None])
    rows, status = Solver(NAME, language).all(T, q)
    held = rows[np.isin(status, HELD)]
    assert residual(NAME, held, T) < 1e-11
    assert np.abs(held - q).max(axis=1).min() < 1e-3
