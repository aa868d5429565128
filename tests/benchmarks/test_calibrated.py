"""Solutions of arms whose tables come at run time, counted against those of another way."""

from __future__ import annotations

import numpy as np

from benchmarks.arms import robot_path
from benchmarks.calibrated import ARMS, unlike


def test_solutions_that_others_lack() -> None:
    rows = np.array([[0.1, np.pi, 0.2], [0.1, 3.0, 0.2], [0.4, -1.0, 2.0]])
    others = rows[[2, 0]] + [[0.0, 2.0 * np.pi, 0.0], [0.0, -2.0 * np.pi, 1e-9]]
    assert unlike(rows, others) == 1
    assert unlike(others, rows) == 0
    assert unlike(rows, np.zeros((0, 3))) == 3
    assert unlike(np.zeros((0, 3)), rows) == 0


def test_arms_have_robot_files() -> None:
    assert all(robot_path(name).exists() for name in ARMS)
