from __future__ import annotations

import numpy as np

from dhgen.kinematics.build import build_chain
from dhgen.robot.load import load
from dhgen.verify.measures import Measures
from tests.robots.cases import ROBOTS

ROWS = np.array([3.1, 0.2, 0.4, 1.0, 1e-6, -3.0])
OTHERS = np.array([-3.1, 0.2, 0.4, 1.0, 0.0, 3.0])


def test_ways_from_a_solution_to_another_take_the_short_way_round() -> None:
    ways = Measures(build_chain(load(ROBOTS / "puma560.yaml"))).ways(ROWS, OTHERS)
    for way in ways:
        np.testing.assert_array_equal(way[0], ROWS)
        gap = np.remainder(way[-1] - OTHERS + np.pi, 2 * np.pi) - np.pi
        np.testing.assert_allclose(gap, 0.0, rtol=0, atol=1e-14)
        assert np.ptp(way, axis=0).max() < 0.3


def test_joints_that_differ_by_little_may_move_first() -> None:
    _, bent = Measures(build_chain(load(ROBOTS / "puma560.yaml"))).ways(ROWS, OTHERS)
    rest = (bent[:, 4] == 0.0).nonzero()[0]
    assert (bent[: rest[0], [0, 5]] == ROWS[[0, 5]]).all()
