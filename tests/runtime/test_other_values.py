"""Other values of a joint that the equations leave to the rest of the pose.

The planar arm of `arms.py` takes joint 1 from the seed and joint 2 from the height of its tool; how
far that is then decides on joint 1. Both solutions may be in one row, or each in another one.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from dhgen.runtime.python.arm import arm_numbers
from dhgen.runtime.python.numerical.arm import arm_numbers as descent_numbers
from dhgen.runtime.python.status import FREE_JOINT, OK, UNREACHABLE
from tests.runtime.arms import ENDLESS, arm_of, called, elbow, links_of, planar, pose_at
from tests.runtime.plain import KINDS

pytestmark = pytest.mark.parametrize("kind", KINDS)
STEPS = ("retries", "checks", "completes", "adds others")


def arm_with(rows: int, *more: str) -> Any:
    arm = arm_of(
        "RR", (ENDLESS, ENDLESS), rows=rows, steps=(*STEPS, *more), choosable=(0,), cuts=72
    )
    return arm_numbers(arm, descent_numbers(links_of(rows=rows)))


def function(kind: str, name: str) -> Any:
    return called(kind, "numerical.other_values", name)


def test_values_beside_the_middle_lie_closer(kind: str) -> None:
    """The step is pi / 32, and 21 steps of the root of 2 nearer than that."""
    value, arm, step = function(kind, "fan_value"), arm_with(2), math.pi / 32
    assert value(arm, 0, 0) == 0.0
    assert value(arm, 0, 21) == pytest.approx(step)
    assert value(arm, 0, -52) == pytest.approx(-math.pi)
    assert value(arm, 0, 20) == pytest.approx(step / math.sqrt(2.0))
    assert value(arm, 0, -1) == pytest.approx(-step * 2.0**-10)
    values = [value(arm, 0, k) for k in range(-52, 53)]
    assert values == sorted(values)


@pytest.mark.parametrize("target", [[0.2, 0.9], [0.2, 0.05], [-0.5, 2.0]])
def test_the_other_solution_gets_the_empty_row(kind: str, target: list[float]) -> None:
    """Also of two that are near to each other."""
    q = np.array([target, [math.nan] * 2])
    status = np.array([FREE_JOINT, UNREACHABLE], np.uint8)
    task = arm_with(2), planar(kind), pose_at(target), np.zeros(0)
    function(kind, "add_others")(task, q, status)
    assert list(status) == [FREE_JOINT, FREE_JOINT]
    np.testing.assert_array_equal(q[0], target)
    np.testing.assert_allclose(q[1], elbow(target, -1.0), atol=1e-9)


def test_rows_that_chose_nothing_have_no_others(kind: str) -> None:
    q = np.array([[0.2, 0.9], [math.nan] * 2])
    status = np.array([OK, UNREACHABLE], np.uint8)
    task = arm_with(2), planar(kind), pose_at([0.2, 0.9]), np.zeros(0)
    function(kind, "add_others")(task, q, status)
    assert list(status) == [OK, UNREACHABLE]


def test_a_value_with_others_beside_it_is_not_alone(kind: str) -> None:
    """Where only the height counts any value of joint 1 serves."""
    arm = arm_of("RR", (ENDLESS, ENDLESS), steps=STEPS, choosable=(0,), cuts=72, entries=(7,))
    numbers = arm_numbers(arm, descent_numbers(links_of()))
    task = numbers, planar(kind), pose_at([0.2, 0.9]), np.zeros(0)
    others = np.empty((2, 2))
    find = function(kind, "find_other_values")
    assert find(task, np.array([0.2, 0.9]), 0.0, others) == 0
    task = arm_with(2), planar(kind), pose_at([0.2, 0.9]), np.zeros(0)
    assert find(task, np.array([0.2, 0.9]), 0.0, others) == 1


def joined(kind: str, arm: Any, rows: list[float | None], values: float, other: float) -> Any:
    """The first joints of rows, some without a solution, with one more solution."""
    q = np.array([[math.nan] * 2 if x is None else [x, 0.0] for x in rows])
    status = np.array([UNREACHABLE if x is None else OK for x in rows], np.uint8)
    function(kind, "join_row")(
        arm, np.array([values, 0.0]), np.array([other, 0.0]), FREE_JOINT, q, status
    )
    return [None if s == UNREACHABLE else float(x) for x, s in zip(q[:, 0], status, strict=True)]


def test_a_solution_joins_beside_its_neighbour_where_rows_ascend(kind: str) -> None:
    rows = [0.1, 0.4, 0.8, None, None]
    arm = arm_with(5, "ascends")
    assert joined(kind, arm, rows, 0.2, 0.1) == [0.1, 0.2, 0.4, 0.8, None]
    assert joined(kind, arm_with(5), rows, 0.2, 0.1) == [0.1, 0.4, 0.8, 0.2, None]
    assert joined(kind, arm, [None, None, 0.1, 0.4, 0.8], 0.5, 0.4) == [None, 0.1, 0.4, 0.5, 0.8]


def test_a_solution_that_has_a_row_or_finds_none_does_not_join(kind: str) -> None:
    arm = arm_with(3)
    assert joined(kind, arm, [0.1, 0.2, None], 0.2 + 1e-4, 0.1) == [0.1, 0.2, None]
    assert joined(kind, arm, [0.1, 0.2, 0.3], 0.4, 0.1) == [0.1, 0.2, 0.3]
