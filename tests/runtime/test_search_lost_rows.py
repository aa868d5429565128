"""Lost rows are searched, and all that follows where rows may miss their pose."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from dhgen.runtime.python.arm import arm_numbers
from dhgen.runtime.python.numerical.arm import Joint
from dhgen.runtime.python.numerical.arm import arm_numbers as descent_numbers
from dhgen.runtime.python.status import FREE_JOINT, OK, UNREACHABLE
from tests.runtime.arms import ENDLESS, arm_of, called, elbow, links_of, planar, pose_at
from tests.runtime.plain import KINDS

pytestmark = pytest.mark.parametrize("kind", KINDS)
NONE = np.zeros(0)
Q = np.array([0.4, 0.9])
LOST = [math.nan] * 2
INSIDE = (ENDLESS, (0.0, 2.0))  # one of two solutions keeps these limits

FITTED = False  # whether rows were taken to the least miss of a pose that may be rounded


def arm_with(*steps: str, limits: Any = (ENDLESS, ENDLESS), **others: Any) -> Any:
    arm = arm_of("RR", limits, steps=("completes", *steps))
    ends = [{"lowest": low, "highest": high} for low, high in limits]
    joints = tuple(Joint(place, **each) for place, each in enumerate(ends))
    return arm_numbers(arm, descent_numbers(links_of(joints=joints, **others)))


def searched(
    kind: str, arm: Any, rows: Any, status: list[int], pose: Any = None
) -> tuple[Any, list[int]]:
    q, held = np.array(rows), np.array(status, np.uint8)
    task = arm, planar(kind), pose_at(Q) if pose is None else pose, NONE
    called(kind, "numerical.search_lost_rows", "search_lost_rows")(
        task, np.zeros(2), 1, FITTED, q, held
    )
    return q, list(held)


def test_faults_add_up(kind: str) -> None:
    fault = called(kind, "numerical.search_lost_rows", "fault")
    arm, beyond = arm_with("keeps limits", limits=INSIDE), np.array([0.0, -1.0])
    assert [fault(arm, miss, 1e-12, Q) for miss in (0.0, 1e-9)] == [0, 2]
    assert [fault(arm, miss, 1e-12, beyond) for miss in (0.0, 1e-9)] == [1, 3]
    assert fault(arm_with(), 0.0, 1e-12, beyond) == 0


def test_a_lost_pose_gets_one_row(kind: str) -> None:
    rows, status = searched(kind, arm_with(), [LOST, LOST], [UNREACHABLE] * 2)
    assert status == [UNREACHABLE, FREE_JOINT]
    assert min(np.abs(rows[1] - elbow(Q, sign)).max() for sign in (1.0, -1.0)) < 1e-9
    assert np.isnan(rows[0]).all()


def test_what_keeps_limits_is_preferred(kind: str) -> None:
    for target in (Q, elbow(Q, -1.0)):
        arm, pose = arm_with("keeps limits", limits=INSIDE), pose_at(target)
        rows, status = searched(kind, arm, [LOST, LOST], [UNREACHABLE] * 2, pose)
        assert status == [UNREACHABLE, FREE_JOINT]
        np.testing.assert_allclose(rows[1], Q, atol=1e-9)


def test_where_only_limits_are_at_fault_the_row_that_chose_is_replaced(kind: str) -> None:
    beyond, arm = elbow(Q, -1.0), arm_with("keeps limits", limits=INSIDE)
    rows, status = searched(kind, arm, [beyond, beyond], [FREE_JOINT, OK])
    assert status == [FREE_JOINT, OK]
    np.testing.assert_allclose(rows, [Q, beyond], atol=1e-9)
    rows, status = searched(kind, arm, [beyond, beyond], [OK, OK])
    np.testing.assert_array_equal(rows, [beyond, beyond])  # none that has chosen


def test_where_no_row_is_exact_one_that_is_replaces_all(kind: str) -> None:
    """A pose that is checked, and none was rounded: a joint was free and took a wrong value."""
    rough = [Q + 1e-7, Q + 2e-7]
    rows, status = searched(kind, arm_with(checked=True), rough, [FREE_JOINT, OK])
    assert status == [UNREACHABLE, FREE_JOINT]
    np.testing.assert_allclose(rows[1], min(elbow(Q, 1.0), rows[1], key=lambda q: q[0]), atol=1.0)
    assert min(np.abs(rows[1] - elbow(Q, sign)).max() for sign in (1.0, -1.0)) < 1e-9


def test_out_of_reach_nothing_is_found(kind: str) -> None:
    pose = (*pose_at(Q)[:3], 2.0, *pose_at(Q)[4:])
    rows, status = searched(kind, arm_with(), [LOST, LOST], [UNREACHABLE] * 2, pose)
    assert status == [UNREACHABLE] * 2
    assert np.isnan(rows).all()


def test_an_elbow_on_the_other_side_is_none(kind: str) -> None:
    """Joint 1 stands for the arm angle: with that given there is one solution, or none."""
    arm, robot = arm_with(arm_angle=True), planar(kind)
    search = called(kind, "numerical.search_lost_rows", "search_lost_rows")
    for angle, found in ((Q[0], True), (Q[0] + 0.4, False)):
        q, status = np.array([LOST, LOST]), np.array([UNREACHABLE] * 2, np.uint8)
        search((arm, robot, pose_at(Q), np.array([angle])), np.zeros(2), 0, FITTED, q, status)
        assert list(status) == [FREE_JOINT if found else UNREACHABLE, UNREACHABLE]
        if found:
            np.testing.assert_allclose(q[0], Q, atol=1e-9)


@pytest.mark.parametrize(
    ("steps", "begun", "kind_of_row"),
    [
        ((), -1, UNREACHABLE),
        (("equations end all",), -1, FREE_JOINT),
        ((), 0, FREE_JOINT),
    ],
)
def test_rows_are_searched_where_equations_may_have_ended_them(
    kind: str, steps: tuple[str, ...], begun: int, kind_of_row: int
) -> None:
    q, status = np.array([LOST, LOST]), np.array([UNREACHABLE] * 2, np.uint8)
    complete = called(kind, "complete", "complete_rows")
    complete(arm_with(*steps), planar(kind), pose_at(Q), NONE, np.zeros(2), begun, q, status)
    assert list(status) == [kind_of_row, UNREACHABLE]


def test_rows_are_refined_before_any_is_searched(kind: str) -> None:
    q, status = np.array([Q + 1e-6, LOST]), np.array([OK, UNREACHABLE], np.uint8)
    complete = called(kind, "complete", "complete_rows")
    complete(arm_with(), planar(kind), pose_at(Q), NONE, np.zeros(2), 0, q, status)
    assert list(status) == [OK, UNREACHABLE]
    np.testing.assert_allclose(q[0], Q, atol=1e-11)
