"""Steps to a solution next to joint values, and what is done with them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from dhgen.runtime.python.arm import arm_numbers
from dhgen.runtime.python.status import FREE_JOINT, OK, OUT_OF_LIMITS, UNREACHABLE
from tests.runtime.arms import (
    ENDLESS,
    arm_of,
    called,
    elbow,
    planar,
    pose_at,
    position,
    tilting,
)
from tests.runtime.plain import KINDS

pytestmark = pytest.mark.parametrize("kind", KINDS)
FREE = arm_numbers(arm_of("RR", (ENDLESS, ENDLESS)))
LIMITED = arm_numbers(
    arm_of("RR", ((-1.0, 1.0), (-2.0, 2.0)), steps=("clamps", "clamps far", "follows seed"))
)
NONE = np.zeros(2)


def test_a_miss_is_the_difference_of_poses(kind: str) -> None:
    """The angle's part is the sine of half of the skew part: against the rotation itself."""
    arm = arm_numbers(arm_of("RR", (ENDLESS,) * 2, directions="rotation", miss_weights=(2.0,) * 6))
    q, target, e = np.array([0.3, 0.8]), np.array([0.2, 0.7]), np.empty(6)
    miss = called(kind, "refine", "measure_miss")(arm, planar(kind), pose_at(target), q, e)
    np.testing.assert_allclose(e[:2], 2.0 * (position(target) - position(q)), atol=1e-15)
    np.testing.assert_allclose(e[2:], [0.0, 0.0, 0.0, math.sin(-0.2)], atol=1e-15)
    angle = 2.0 * math.sin(0.1)  # of a turn by 0.2, as the distance of two rotations
    assert miss == pytest.approx(math.hypot(*e[:2], angle), abs=1e-14)


def test_a_step_is_that_of_damped_least_squares(kind: str) -> None:
    """Against J' (J J' + d)^-1 e by numpy."""
    q, e, damping = np.array([0.3, 0.8]), np.array([1e-3, -2e-3, 0.0, 0.0, 0.0, 0.0]), 0.05
    c, s = np.cos(0.3 + 0.8), np.sin(0.3 + 0.8)
    J = 2.0 * np.array(
        [[-0.5 * np.sin(0.3) - 0.4 * s, -0.4 * s], [0.5 * np.cos(0.3) + 0.4 * c, 0.4 * c]]
    )
    step = J.T @ np.linalg.solve(J @ J.T + damping * np.eye(2), e[:2])
    held, end = np.zeros(2, np.bool_), q.copy()
    called(kind, "refine", "add_step")(FREE, planar(kind), held, damping, e.copy(), end)
    np.testing.assert_allclose(end - q, step, rtol=1e-10)


@pytest.mark.parametrize(
    ("directions", "weights", "told"),
    [
        ("pitch", (1.0, 0.0, 0.0), lambda q: -math.sin(q[0])),
        ("tilt", (1.0, 1.0, 0.0), lambda q: [-math.sin(q[0]), math.cos(q[0]) * math.sin(q[1])]),
    ],
)
def test_pitch_and_roll_are_refined(
    kind: str, directions: str, weights: tuple[float, ...], told: Any
) -> None:
    """From beside; of a pitch alone, the roll stays."""
    numbers = arm_of("RR", (ENDLESS,) * 2, directions=directions, miss_weights=(0, 0, 0, *weights))
    target, q = np.array([0.4, -0.7]), np.array([0.42, -0.69])
    c, s, d, r = math.cos(0.4), math.sin(0.4), math.cos(-0.7), math.sin(-0.7)
    pose = (c, s * r, s * d, 0.0, 0.0, d, -r, 0.0, -s, c * r, c * d, 0.0)
    arm, robot = arm_numbers(numbers), tilting(kind)
    miss = called(kind, "refine", "measure_miss")(arm, robot, pose, q, np.empty(6))
    apart = np.linalg.norm(np.subtract(told(target), told(q)))
    assert miss == pytest.approx(apart, rel=0.02)
    assert called(kind, "refine", "refine")(arm, robot, pose, 1e-13, 0.15, q)
    np.testing.assert_allclose(told(q), told(target), atol=1e-13)
    assert q[1] == pytest.approx(-0.69 if directions == "pitch" else -0.7, abs=1e-12)


def test_a_yaw_is_refined_unless_the_pose_has_none(kind: str) -> None:
    weights = (2.0, 0.0, 0.0, 0.0, 0.0, 1.0)
    arm = arm_numbers(arm_of("RR", (ENDLESS,) * 2, directions="yaw", miss_weights=weights))
    target, q = np.array([0.4, 0.7]), np.array([0.41, 0.72])
    pose, near = pose_at(target), q.copy()
    assert called(kind, "refine", "refine")(arm, planar(kind), pose, 1e-13, 0.15, q)
    np.testing.assert_allclose(q, target, atol=1e-12)
    upright = (0.0, *pose[1:4], 0.0, *pose[5:])
    assert called(kind, "refine", "refine")(arm, planar(kind), upright, 1e-13, 0.15, near)
    np.testing.assert_allclose(position(near)[0], position(target)[0], atol=1e-12)
    assert abs(near - target).max() > 1e-3


@pytest.mark.parametrize("bend", [0.7, 1e-9, 3.0])
def test_values_beside_a_solution_are_taken_to_it(kind: str, bend: float) -> None:
    target = np.array([0.4, bend])
    q = target + np.array([2e-3, -1e-3])
    assert called(kind, "refine", "refine")(FREE, planar(kind), pose_at(target), 1e-12, 0.15, q)
    np.testing.assert_allclose(position(q), position(target), atol=1e-12)


def test_what_is_far_from_a_solution_is_left(kind: str) -> None:
    q = np.array([0.4, 0.7])
    pose = pose_at(np.array([1.4, -0.7]))
    assert not called(kind, "refine", "refine")(FREE, planar(kind), pose, 1e-12, 0.15, q)
    np.testing.assert_array_equal(q, [0.4, 0.7])


def test_a_joint_just_beyond_its_limit_is_put_on_it(kind: str) -> None:
    """Where the arm is stretched joints may move by the root of rounding."""
    rows = np.array([[1.0 + 1e-8, -2e-8], [math.nan, math.nan]])
    status = np.array([OK, UNREACHABLE], np.uint8)
    pose, no = pose_at(rows[0]), False
    clamp = called(kind, "clamp", "clamp_to_limits")
    assert clamp(LIMITED, planar(kind), pose, 0, no, rows, status)
    assert rows[0, 0] == pytest.approx(1.0, abs=1e-9)
    np.testing.assert_allclose(position(rows[0]), [pose[3], pose[7]], atol=1e-12)


def test_no_joint_is_put_on_a_limit_that_the_pose_is_far_from(kind: str) -> None:
    rows = np.array([[1.2, 0.9], [math.nan, math.nan]])
    status, before = np.array([OK, UNREACHABLE], np.uint8), rows.copy()
    clamp = called(kind, "clamp", "clamp_to_limits")
    for far in (False, True):
        assert not clamp(LIMITED, planar(kind), pose_at(rows[0]), 0, far, rows, status)
    np.testing.assert_array_equal(rows, before)


@pytest.mark.parametrize(("bend", "one"), [(1e-8, 1), (1e-3, 0)])
def test_rows_that_rounding_alone_tells_apart_are_one(kind: str, bend: float, one: int) -> None:
    target = np.array([0.4, bend])
    rows = np.array([elbow(target, 1.0), elbow(target, -1.0)])
    if one:  # as far apart as rounding leaves them
        rows = np.array([target, [0.4 + 8e-9 / 9, -bend]])
    status = np.array([OK, OK], np.uint8)
    called(kind, "duplicates", "remove_duplicates")(
        FREE, planar(kind), pose_at(target), rows, status
    )
    assert list(status) == [OK, UNREACHABLE if one else OK]
    assert np.isnan(rows[1]).all() == one


def following(kind: str, target: Any, seed: Any) -> tuple[Any, list[int]]:
    rows = np.array([elbow(target, 1.0), elbow(target, -1.0)])
    status = np.array([OK, OK], np.uint8)
    called(kind, "follow_seed", "follow_seed")(
        LIMITED, planar(kind), pose_at(target), NONE, seed, rows, status
    )
    return rows, list(status)


def test_a_seed_that_is_no_solution_changes_nothing(kind: str) -> None:
    target = np.array([0.4, 0.9])
    rows, status = following(kind, target, np.array([0.0, 0.3]))
    np.testing.assert_array_equal(rows, [elbow(target, 1.0), elbow(target, -1.0)])
    assert status == [OK, OK]


def test_a_seed_on_a_row_leaves_it_as_it_is(kind: str) -> None:
    target = np.array([0.4, 0.9])
    rows, status = following(kind, target, target)
    np.testing.assert_allclose(rows[0], target, atol=1e-12)
    assert status == [OK, OK]


def test_a_seed_that_solves_an_ambiguous_pose_is_gone_on_with(kind: str) -> None:
    """Nearly stretched all elbows that are bent by less than the root of rounding serve."""
    seed = np.array([0.4 - 4e-7 / 0.9, 1e-6])
    rows, status = following(kind, np.array([0.4, 0.0]), seed)
    assert min(np.abs(row - seed).max() for row in rows) < 2e-6
    assert OUT_OF_LIMITS not in status
    assert set(status) <= {OK, FREE_JOINT}
