"""A root that follows another loses digits where that one nearly vanishes: no row gets lost by it.

With its elbow nearly stretched a Panda's joint 4 is good to few digits, and with joint 5 at a right
angle these say on which side of the boundary of reach the arm is. So does the elbow of a UR where
its shoulder is singular.
"""

from __future__ import annotations

import numpy as np
import pytest

from tests.targets.calling import HELD, LANGUAGES, UNREACHABLE, Solver, gap
from tests.targets.made import poses_of

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

PANDA, UR = "franka_panda", "ur5"
# where the points on axes 3 and 5 that are next to axis 4 are in line with it, from the data sheet
STRETCHED = -(np.arctan2(0.0825, 0.316) + np.arctan2(0.0825, 0.384))
COUNT = 60
EXACT = 1e-11


def near_both(off: float, count: int) -> np.ndarray:
    """Joint values of a Panda within 1e-3 of the one place, so far from the other."""
    source = np.random.default_rng(5)
    q = source.uniform(-1.5, 1.5, (count, 7))
    q[:, 3] = STRETCHED + source.uniform(-1e-3, 1e-3, count)
    q[:, 4] = source.choice([-1, 1], count) * np.pi / 2 + source.choice([-1, 1], count) * off
    q[:, 5] = source.uniform(0.5, 3.0, count)
    return q


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("off", [0.0, 1e-8, 1e-6, 1e-5, 1e-4])
def test_near_two_singular_places_at_once(language: str, off: float) -> None:
    solver, q = Solver(PANDA, language), near_both(off, COUNT if language == "C" else 6)
    for joints, T in zip(q, poses_of(PANDA, q), strict=True):
        for seed, close in ((joints, 2e-6), (None, 1e-2)):
            rows, status = solver.all(T, seed, joints[6:])
            held = rows[~np.isnan(rows).any(axis=1)]
            assert np.isin(status, HELD).any() or seed is None
            assert gap(held, joints).min() < close
            assert np.abs(poses_of(PANDA, held) - T).max() < EXACT


@pytest.mark.parametrize("language", LANGUAGES)
def test_out_of_reach_by_more_than_rounding(language: str) -> None:
    """Farther than the whole arm is long by 1e-8 of it: steps lead nowhere."""
    solver, q = Solver(UR, language), np.zeros((1, 6))
    q[0] = 0.3, -0.4, 0.0, -np.pi / 2, 1.2, 0.5
    (T,) = poses_of(UR, q)
    rows, status = solver.all(T)
    assert np.isin(status, HELD).any()
    centre = T[:3, 3] - T[:3, 2] * 0.0823  # of the wrist, link 6 back along its axis
    outwards = np.array([centre[0], centre[1], centre[2] - 0.089159])
    T[:3, 3] += 1e-8 * outwards / np.linalg.norm(outwards)
    rows, status = solver.all(T)
    assert gap(rows, q[0]).min(initial=9.0, where=~np.isnan(gap(rows, q[0]))) > 0.1
    assert (status == UNREACHABLE).any()
