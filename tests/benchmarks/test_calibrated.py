"""Solutions of arms whose tables come at run time, counted against those of another way."""

from __future__ import annotations

import numpy as np

from benchmarks.arms import robot_path
from benchmarks.calibrated import ARMS, read_kind, unlike, without_partner
from benchmarks.calibrated_recall import SAME, wrong_rows
from dhgen.verify.calibrated import poses_of


def test_solutions_that_others_lack() -> None:
    rows = np.array([[0.1, np.pi, 0.2], [0.1, 3.0, 0.2], [0.4, -1.0, 2.0]])
    others = rows[[2, 0]] + [[0.0, 2.0 * np.pi, 0.0], [0.0, -2.0 * np.pi, 1e-9]]
    assert unlike(rows, others) == 1
    assert unlike(others, rows) == 0
    assert unlike(rows, np.zeros((0, 3))) == 3
    assert unlike(np.zeros((0, 3)), rows) == 0


def test_arms_have_robot_files() -> None:
    assert all(robot_path(name).exists() for name in ARMS)


def test_solutions_without_a_partner() -> None:
    nothing = np.full(3, np.nan)
    rows = np.array([[[0.1, np.pi, 0.2], [0.1, 3.0, 0.2], nothing]])
    others = np.array([[nothing, [0.1, -np.pi, 0.2 + 1e-9]]])
    assert without_partner(rows, others, SAME).tolist() == [[False, True, False]]
    assert without_partner(others, rows, SAME).tolist() == [[False, False]]


def test_rows_that_miss_their_pose() -> None:
    kind = read_kind("puma560")
    numbers, q = np.array(kind.table.rows), np.zeros((1, 2, 6))
    T = poses_of(kind, numbers, q[0, :1])
    assert wrong_rows(kind, numbers, T, q) == 0
    q[0, 1, 5] = 1e-7
    assert wrong_rows(kind, numbers, T, q) == 1
    q[0, 1] = np.nan
    assert wrong_rows(kind, numbers, T, q) == 0
