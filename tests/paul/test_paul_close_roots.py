"""Arms that nearly have a structure: the roots of their quartics lie in pairs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from dhgen.kinematics.build import build_chain
from dhgen.method import Method
from dhgen.paul.close_roots import OFTEN, close_share
from dhgen.paul.derive import derive
from dhgen.paul.further_forms import with_inverse_forms
from dhgen.paul.kind import Kind
from dhgen.paul.pool import build_pool
from dhgen.paul.problem import build_problem
from dhgen.paul.search import Search
from dhgen.paul.types import QUARTIC
from tests.kinematics.values import algebra_of, table
from tests.robots.cases import robot
from tests.structures import first_of

if TYPE_CHECKING:
    from dhgen.robot.robot import Robot

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files


def nearly_meeting(miss: float) -> Robot:
    """An iiwa 14 whose axes 1, 2, 3 miss one point, as in a published URDF; joint 3 is given."""
    return table(
        f"theta: q + pi, d: 0.36, a: {miss}, alpha: pi/2",
        "theta: q + pi, alpha: pi/2",
        f"theta: q, d: 0.42, a: {miss}, alpha: pi/2",
        "theta: q + pi, alpha: pi/2",
        "theta: q, d: 0.4, alpha: pi/2",
        "theta: q + pi, alpha: pi/2",
        "theta: q, d: 0.126",
        free="[3]",
    )


def share(arm: Robot) -> float:
    """Of the close roots of its quartic."""
    pool = with_inverse_forms(build_pool(build_problem(algebra_of(arm))))
    route = Search(pool, QUARTIC).best()
    assert route is not None
    (step,) = (step for step in route.steps if step.kind is Kind.CIRCLE)
    return close_share(pool, step)


@pytest.mark.breadth
def test_the_less_axes_miss_a_point_by_the_more_roots_are_close() -> None:
    """Two roots become one where they meet: they are apart by what the axes miss."""
    shares = [share(nearly_meeting(miss)) for miss in (0.0002, 0.00043624, 0.002, 0.05)]
    assert shares == sorted(shares, reverse=True)
    assert shares[0] > 3 * OFTEN
    assert shares[-1] < OFTEN / 3


@pytest.mark.parametrize(
    ("miss", "method"),
    first_of(
        [
            (0.0, Method.CLOSED_FORM),
            (0.00043624, Method.GENERAL_6R),
            (0.05, Method.QUARTIC),
        ],
        count=2,
    ),
)
def test_what_would_often_be_split_is_left_to_a_general_algorithm(
    miss: float, method: Method
) -> None:
    assert derive(build_chain(nearly_meeting(miss))).method is method


@pytest.mark.parametrize(
    "name",
    first_of(["welding_5r", "concurrent_345", "parallel_123", "spherical_wrist_general_arm"]),
)
def test_roots_of_robots_that_have_a_quartic_are_seldom_close(name: str) -> None:
    assert share(robot(name)) < OFTEN / 10
