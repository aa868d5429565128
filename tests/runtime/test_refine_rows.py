"""Rows that miss their pose are taken to solutions, in plain Python and compiled."""

from __future__ import annotations

import math
from itertools import product
from typing import Any

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.numerical.kernel import numerical_kernel
from dhgen.numerical.runtime_arm import runtime_arm
from dhgen.robot.load import load
from dhgen.runtime.python.arm import arm_numbers
from dhgen.runtime.python.numerical.arm import arm_numbers as descent_numbers
from dhgen.runtime.python.status import FREE_JOINT, OK, UNREACHABLE
from dhgen.tolerances import TOLERANCES
from tests.runtime.arms import (
    ENDLESS,
    arm_of,
    called,
    elbow,
    links_of,
    planar,
    pose_at,
    position,
)
from tests.runtime.plain import KINDS
from tests.targets.made import robot_path

pytestmark = pytest.mark.parametrize("kind", KINDS)
NONE = np.zeros(0)
LINKS = descent_numbers(links_of())
CHECKED = descent_numbers(links_of(checked=True))
Q = np.array([0.4, 0.9])


def function(kind: str, name: str) -> Any:
    return called(kind, "numerical.refine_rows", name)


def goal_at(x: float, y: float) -> tuple[Any, Any, int]:
    T = np.zeros((3, 4))
    T[0, 3], T[1, 3] = x, y
    return T, NONE, 0


def test_far_away_rounding_is_more(kind: str) -> None:
    exactness = function(kind, "exactness")
    assert exactness(LINKS, goal_at(0.3, -0.4)[0]) == TOLERANCES.exact
    assert exactness(LINKS, goal_at(0.3, -5.0)[0]) == pytest.approx(10.0 * TOLERANCES.exact)


def test_without_steps_a_row_stays_and_the_step_is_known(kind: str) -> None:
    """The step is that of Newton, J^-1 e."""
    target, q = Q + np.array([1e-3, -2e-3]), Q.copy()
    miss, ahead = function(kind, "approach")(LINKS, goal_at(*position(target)), 0, 1e-12, q)
    e = position(target) - position(Q)
    (s0, s), (c0, c) = np.sin(np.cumsum(Q)), np.cos(np.cumsum(Q))
    J = np.array([[-0.5 * s0 - 0.4 * s, -0.4 * s], [0.5 * c0 + 0.4 * c, 0.4 * c]])
    np.testing.assert_allclose(q, Q, atol=1e-15)
    assert miss == pytest.approx(np.linalg.norm(e) / 0.5)
    assert ahead == pytest.approx(np.abs(np.linalg.solve(J, e)).max(), rel=1e-5)


@pytest.mark.parametrize("bend", [0.9, 1e-3, 0.0])
def test_steps_lead_to_a_solution(kind: str, bend: float) -> None:
    """Also to an arm that is stretched, where a step leaves a quarter of the miss."""
    q, target = np.array([0.4, bend + 0.02]), np.array([0.4, bend])
    miss, _ = function(kind, "approach")(LINKS, goal_at(*position(target)), 72, 1e-12, q)
    assert miss <= TOLERANCES.exact
    np.testing.assert_allclose(position(q), position(target), atol=1e-12)


@pytest.mark.slow
def test_steps_lead_to_where_four_solutions_meet(kind: str) -> None:
    """Some get slow far from there, at joint values that are singular."""
    upright = np.array([0.7, -0.7, np.pi, np.pi / 2, 0.0, 0.0, -np.pi / 2])
    kernel = numerical_kernel(build_chain(load(robot_path("trolley"))), redundant=False)
    numbers, slow = descent_numbers(runtime_arm(kernel)), 0
    goal = kernel.arm.pose(upright)[:3].copy(), NONE, 0
    for signs in product([1.0, -1.0], repeat=3):
        start = upright + 0.05 * np.array([0.0, 1.0, signs[0], signs[1], 0.6, signs[2], 0.8])
        slow += function(kind, "approach")(numbers, goal, 72, 1e-12, start.copy())[0] > 1e-9
        assert function(kind, "escape")(numbers, goal, 1e-12, start) < TOLERANCES.promised
        np.testing.assert_allclose(kernel.arm.pose(start)[:3], goal[0], atol=1e-10)
    assert slow


def test_out_of_reach_a_row_comes_nearer_unless_the_pose_may_be_rounded(kind: str) -> None:
    """An arm of length 0.9 misses a point at 1.0 by 0.2 arm sizes at least."""
    first, goal = 2.0 * float(np.linalg.norm(position([0.1, 0.3]) - [1.0, 0.0])), goal_at(1.0, 0.0)
    q = np.array([0.1, 0.3])
    assert function(kind, "refine_row")(CHECKED, goal, 1e-12, first, q) == (first, False)
    np.testing.assert_array_equal(q, [0.1, 0.3])
    miss, moved = function(kind, "refine_row")(LINKS, goal, 1e-12, first, q)
    assert moved
    assert 0.2 <= miss < 0.5 * first
    assert miss == pytest.approx(2.0 * np.linalg.norm(position(q) - [1.0, 0.0]))


def test_an_exact_row_stays(kind: str) -> None:
    q = Q + 1e-3
    assert function(kind, "refine_row")(LINKS, goal_at(*position(Q)), 1e-12, 1e-13, q) == (
        1e-13,
        False,
    )
    np.testing.assert_array_equal(q, Q + 1e-3)


def test_rows_differ_by_what_they_differ_most_but_for_turns(kind: str) -> None:
    links = links_of(joints=(links_of().joints[0], type(links_of().joints[0])(1, turns=False)))
    apart = function(kind, "rows_apart")
    assert apart(LINKS, Q, Q + np.array([2 * np.pi, -0.1])) == pytest.approx(0.1)
    assert apart(descent_numbers(links), Q, Q + np.array([0.1, 0.3])) == pytest.approx(0.6)


def test_an_arm_angle_is_one_more_equation(kind: str) -> None:
    """Joint 1 stands for it."""
    numbers = descent_numbers(links_of(arm_angle=True))
    goal = (*goal_at(*position(Q))[:1], np.array([0.1]), planar(kind)[4])
    e, A = np.empty(3), np.empty((3, 2))
    miss = called(kind, "numerical.descent", "measure_miss")(numbers, goal, Q.copy(), Q, e, A)
    np.testing.assert_allclose(e, [0.0, 0.0, -0.3], atol=1e-15)
    np.testing.assert_array_equal(A[2], [1.0, 0.0])
    assert miss == pytest.approx(0.3)
    # rounding did not lead that far from it
    assert function(kind, "refine_row")(numbers, goal, 1e-12, 1e-9, Q.copy()) == (math.inf, False)


def refined(kind: str, target: Any, rows: Any, links: Any = LINKS) -> tuple[Any, list[int]]:
    count = len(rows)
    arm = arm_numbers(arm_of("RR", (ENDLESS, ENDLESS), rows=count), links)
    q, status = np.array(rows), np.full(count, OK, np.uint8)
    status[np.isnan(q[:, 0])] = UNREACHABLE
    pose = pose_at(target) if len(target) == 2 else target
    function(kind, "refine_rows")((arm, planar(kind), pose, NONE), q, status)
    assert (np.isnan(q).all(axis=1) == (status == UNREACHABLE)).all()
    return q, list(status)


def test_rows_become_exact_and_those_out_of_reach_end(kind: str) -> None:
    other, no = elbow(Q, -1.0), [math.nan] * 2
    rows, status = refined(kind, Q, [Q + 1e-5, no, other])
    assert status == [OK, UNREACHABLE, OK]
    np.testing.assert_allclose(rows[0], Q, atol=1e-11)
    np.testing.assert_array_equal(rows[2], other)
    far = (*pose_at(Q)[:3], 2.0, *pose_at(Q)[4:])
    assert refined(kind, far, [Q, other])[1] == [UNREACHABLE] * 2


def test_of_rows_that_become_one_the_nearest_is_kept(kind: str) -> None:
    rows, status = refined(kind, Q, [Q + 1e-6, Q + 2 * np.pi - 1e-6, Q])
    assert status == [UNREACHABLE, UNREACHABLE, OK]
    np.testing.assert_array_equal(rows[2], Q)


def test_a_pose_that_is_checked_may_be_rounded_but_not_if_a_row_is_exact(kind: str) -> None:
    """A point just out of reach is met by what it may be rounded, and by no row exactly."""
    x, _ = position([0.0, 0.0])
    pose = (*pose_at(Q)[:3], x + 1e-7, *pose_at(Q)[4:7], 0.0, *pose_at(Q)[8:])
    stretched = [0.0, 0.0]
    assert refined(kind, pose, [stretched, stretched], CHECKED)[1] == [OK, OK]
    assert refined(kind, pose, [stretched, stretched])[1] == [UNREACHABLE] * 2
    enough = function(kind, "enough_in_rows")
    assert enough(CHECKED, np.array([1e-7, math.inf]), 1e-12) == TOLERANCES.consistent
    assert enough(CHECKED, np.array([1e-7, 1e-13]), 1e-12) == 1e-12
    assert enough(LINKS, np.array([1e-7, 1e-13]), 1e-12) == TOLERANCES.promised


def test_what_a_row_holds_stays_in_words(kind: str) -> None:
    arm = arm_numbers(arm_of("RR", (ENDLESS, ENDLESS)), LINKS)
    q, status = np.array([Q + 1e-5, Q + 1.0]), np.array([FREE_JOINT, UNREACHABLE], np.uint8)
    function(kind, "refine_rows")((arm, planar(kind), pose_at(Q), NONE), q, status)
    assert list(status) == [FREE_JOINT, UNREACHABLE]
    assert np.isnan(q[1]).all()
