"""Answers are judged by the forward model; found solutions are counted over everybody's."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.arms import CASES, Arm, read_arm
from benchmarks.contestant import Contestant
from benchmarks.quality import RIGHT, judge_all

POSES = 20


@pytest.fixture(scope="module")
def planar() -> Arm:
    """The SCARA: q2 is positive or negative, and both answers are easily written down."""
    return read_arm(next(case for case in CASES if case.name == "scara"))


def joints(count: int) -> np.ndarray:
    draw = np.random.default_rng(1)
    return draw.uniform([-2, 0.3, -0.2, -2], [2, 2.2, 0, 2], (count, 4))


def mirrored(q: np.ndarray) -> np.ndarray:
    """The other elbow: links of 0.4 and 0.3, the angle of the tool kept."""
    lean = np.arctan2(0.3 * np.sin(q[:, 1]), 0.4 + 0.3 * np.cos(q[:, 1]))
    first = q[:, 0] + 2 * lean
    return np.stack([first, -q[:, 1], q[:, 2], q[:, 3] + q[:, 0] + 2 * q[:, 1] - first], axis=1)


def entry(*answers: np.ndarray) -> Contestant:
    rows = list(np.stack(answers, axis=1))
    return Contestant("x", "faked", lambda T: rows[: len(T)], lambda _: lambda _: 1.0)


def test_found_is_the_share_of_what_anybody_found(planar: Arm) -> None:
    q = joints(POSES)
    T = planar.model.pose(q)
    both, one = judge_all(planar, [entry(q, mirrored(q)), entry(q)], T, T)
    assert (both.found, one.found) == (1.0, 0.5)
    assert both.wrong == one.wrong == 0.0
    assert 0.0 < both.residual < 1e-14


def test_a_solution_said_twice_counts_once(planar: Arm) -> None:
    q = joints(POSES)
    T = planar.model.pose(q)
    again, both = judge_all(
        planar, [entry(q, q + np.array([0, 2 * np.pi, 0, -2 * np.pi])), entry(q, mirrored(q))], T, T
    )
    assert (again.found, both.found) == (0.5, 1.0)


def test_rows_that_miss_the_pose_are_wrong_and_find_nothing(planar: Arm) -> None:
    q = joints(POSES)
    T = planar.model.pose(q)
    off = q + np.array([0, 0, 10 * RIGHT, 0])
    half, none = judge_all(planar, [entry(q, off), entry(off)], T, T)
    assert (half.found, half.wrong, half.aligned) == (1.0, 0.5, 1.0)
    assert (none.found, none.wrong, none.aligned) == (0.0, 1.0, 0.0)


def test_no_rows_are_no_answer(planar: Arm) -> None:
    q = joints(POSES)
    T = planar.model.pose(q)
    silent = Contestant("x", "faked", lambda T: [np.empty((0, 0))] * len(T), lambda _: lambda _: 1)
    answer, nothing = judge_all(planar, [entry(q), silent], T, T)
    assert (answer.aligned, nothing.aligned) == (1.0, 0.0)
    assert (nothing.found, nothing.wrong) == (0.0, 0.0)
