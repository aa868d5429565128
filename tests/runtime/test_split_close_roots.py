"""Roots that nearly meet: an arm in the plane whose rows come from the angle to its tool.

That angle lies in the middle of the two solutions, and so does its row, which is stretched.
"""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest

from dhgen.runtime.python.arm import arm_numbers
from dhgen.runtime.python.numerical.arm import arm_numbers as descent_numbers
from dhgen.runtime.python.status import CLOSE, OK, UNREACHABLE
from tests.runtime.arms import ENDLESS, arm_of, called, elbow, links_of, planar, pose_at, position
from tests.runtime.plain import KINDS, part

pytestmark = pytest.mark.parametrize("kind", KINDS)
ARM = arm_numbers(
    arm_of("RR", (ENDLESS, ENDLESS), root_turns=((0, 1.0),)), descent_numbers(links_of())
)
NONE = np.zeros(0)


@cache
def rooted(kind: str) -> Any:
    """The planar arm with another solver: both rows have the root, or the seed's value for it."""
    how, arm = part(kind, "jit").of_file(__file__), part(kind, "arm")

    @how.apart(arm.SOLVES)  # type: ignore[untyped-decorator]
    def from_root(pose: Any, q_free: Any, seed: Any, moved: Any, q: Any, status: Any) -> None:  # noqa: ARG001
        x, y = pose[3], pose[7]
        root = math.atan2(y, x)
        if abs(seed[0] - root) < 1e-2:
            root = seed[0]
        root += moved
        for row in range(2):
            q[row, 0] = root
            q[row, 1] = math.atan2(y - 0.5 * math.sin(root), x - 0.5 * math.cos(root)) - root
            status[row] = 64

    given = how.addresses("from_root", None, None, None, None)
    if kind == "plain":
        return given()[:1] + planar(kind)[1:]
    from numba import njit  # noqa: PLC0415  only where there is one

    return njit(lambda: given())()[:1] + planar(kind)[1:]  # noqa: PLW0108  numba wants one


def split(kind: str, target: Any, seed: Any, rows: Any, status: list[int]) -> tuple[Any, list[int]]:
    task, q, held = (
        (ARM, rooted(kind), pose_at(target), NONE),
        np.array(rows),
        np.array(status, np.uint8),
    )
    called(kind, "numerical.split_close_roots", "split_close_roots")(task, seed, q, held)
    return q, list(held)


@pytest.mark.parametrize("bend", [1e-2, 2e-3])
def test_both_solutions_are_found_from_their_middle(kind: str, bend: float) -> None:
    target = np.array([0.3, bend])
    middle = [math.atan2(*position(target)[::-1]), 0.0]
    rows, status = split(kind, target, np.zeros(2), [middle, middle], [CLOSE, CLOSE])
    assert status == [OK, OK]
    rows = rows[np.argsort(rows[:, 1])]
    np.testing.assert_allclose(rows, [elbow(target, -1.0), elbow(target, 1.0)], atol=1e-8)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_other_one_of_the_seeds_is_found(kind: str, sign: float) -> None:
    """Both rows took the seed's value: it hides the middle."""
    target = np.array([0.3, 4e-3])
    seed = elbow(target, sign)
    rows, status = split(kind, target, seed, [seed, seed], [CLOSE, CLOSE])
    assert status == [OK, OK]
    rows = rows[np.argsort(rows[:, 1])]
    np.testing.assert_allclose(rows, [elbow(target, -1.0), elbow(target, 1.0)], atol=1e-8)


def test_a_solution_that_another_row_has_is_not_found_again(kind: str) -> None:
    target = np.array([0.3, 4e-3])
    middle, known = [math.atan2(*position(target)[::-1]), 0.0], elbow(target, 1.0)
    rows, status = split(kind, target, np.zeros(2), [middle, known], [CLOSE, OK])
    assert status == [OK, OK]
    np.testing.assert_allclose(rows, [elbow(target, -1.0), known], atol=1e-8)


def test_rows_that_are_solutions_or_not_close_stay(kind: str) -> None:
    """Where the arm is stretched the row of the root is its only solution."""
    target = np.array([0.3, 0.0])
    rows, status = split(kind, target, np.zeros(2), [target, [math.nan] * 2], [CLOSE, UNREACHABLE])
    assert status[1] == UNREACHABLE
    assert status[0] == OK
    np.testing.assert_allclose(rows[0], target, atol=1e-12)
    rough = [target + 1e-3, target - 1e-3]
    rows, status = split(kind, target, np.zeros(2), rough, [OK, OK])
    np.testing.assert_array_equal(rows, rough)
    assert status == [OK, OK]


def test_a_solution_lies_where_no_longer_step_leads_elsewhere(kind: str) -> None:
    """Beside a stretched arm the pose is missed by next to nothing, and the step is long."""
    solves = called(kind, "numerical.split_close_roots", "is_solution")
    target = np.array([0.3, 0.0])
    T = np.array(pose_at(target)).reshape(3, 4)
    goal, links = (T, NONE, 0), descent_numbers(links_of())
    assert not solves(links, goal, 0, 1e-12, target + np.array([-1e-6 * 0.4 / 0.9, 1e-6]) * 400.0)
    assert not solves(links, goal, 0, 1e-12, target + np.array([-1e-4, 2e-4]))
    bent = np.array([0.3, 0.9])
    goal = np.array(pose_at(bent)).reshape(3, 4), NONE, 0
    assert solves(links, goal, 0, 1e-12, bent.copy())


def test_the_root_is_the_sum_of_its_joints(kind: str) -> None:
    arm = arm_numbers(arm_of("RR", (ENDLESS, ENDLESS), root_turns=((1, -1.0), (0, 1.0))))
    off = called(kind, "numerical.split_close_roots", "root_between")
    assert off(arm, np.zeros(2), np.array([0.3, 0.5])) == pytest.approx(-0.2)
    assert off(arm, np.zeros(2), np.array([2.0, -2.0])) == pytest.approx(4.0 - 2 * np.pi)
