"""A joint on its limit where a general arm is nearly singular.

Axes 2 and 3 of the arm are 2.6e-6 rad from parallel. Twists within 1e-10 of right angles are taken
as such, which moves the model by 1e-11: beside a singular pose a joint on its limit comes out 1e-7
beyond, and the pose is missed by 1e-11 if it is clamped.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from dhgen.robot.load import load
from tests.compiling import written
from tests.targets.calling import FREE_JOINT, OK, OUT_OF_LIMITS
from tests.targets.made import folder, solving

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.compiler import Compilation

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

ARM = Path(__file__).with_name("near_parallel.yaml")
RIGHT = np.pi / 2
REPORTED = (0.0, 0.0, RIGHT, -RIGHT, -RIGHT, RIGHT)


@cache
def compiled() -> Compilation:
    return written(ARM, folder())


def anywhere(count: int) -> FloatArray:
    """Joint values inside the limits."""
    limits = np.array([joint.limits for joint in load(ARM).joints], np.float64)
    return np.random.default_rng(3).uniform(limits[:, 0], limits[:, 1], (count, 6))


def on_limits(count: int) -> FloatArray:
    """Joint values inside the limits: joint 4 on one or at a right angle, joint 5 at one."""
    q, source, limits = anywhere(count), np.random.default_rng(4), load(ARM).joints[3].limits
    assert limits is not None
    q[:, 3] = source.choice([*limits, RIGHT, -RIGHT], count)
    q[:, 4] = source.choice([RIGHT, -RIGHT], count)
    return q


@pytest.mark.parametrize(("language", "count"), [("C", 100), ("Python", 1)])
def test_a_row_is_inside_the_limits(language: str, count: int) -> None:
    """By the file's own numbers the joint values that made the pose are."""
    robot = load(ARM)
    for q in (np.array(REPORTED), *on_limits(count)):
        T = np.array(forward(robot, q))
        rows, status = solving(compiled(), language)(T, q)
        inside = np.isin(status, (OK, FREE_JOINT))
        assert inside.any(), q
        np.testing.assert_allclose(forward(robot, rows[inside]) - T, 0.0, atol=2e-10)


def test_what_is_beyond_a_limit_by_more_than_rounding_is_told() -> None:
    """Regular poses, joint 1 a millionth beyond: only another solution brings the tool there."""
    robot, high = load(ARM), load(ARM).joints[0].limits
    assert high is not None
    for q in anywhere(30):
        q[0] = high[1] + 1e-6
        rows, status = solving(compiled(), "C")(np.array(forward(robot, q)), q)
        near = np.abs(rows - q).max(axis=1) < 1e-4
        assert list(status[near]) == [OUT_OF_LIMITS]
