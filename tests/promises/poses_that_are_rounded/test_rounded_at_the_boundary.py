"""Rounded poses on the boundary of reach, for an arm of five joints with a slide."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.compiling import library
from tests.targets.calling import HELD
from tests.targets.made import folder, made_up

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Robot

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

NAME = "five_with_a_slide"
ROWS = (
    "theta: q, d: 0.3, a: 0.1, alpha: -pi/2",
    "theta: 0.2, d: q, a: 0.15, alpha: pi/2",
    "theta: q, d: 0.1, a: 0.08, alpha: -pi/2",
    "theta: q, d: 0.43, alpha: pi/2",
    "theta: q, d: 0.08",
)
TOOL = 0.08  # from the wrist, along z


def turned_to_the_top(robot: Robot, q: FloatArray, side: float) -> FloatArray:
    """Joint 3 where the wrist is highest, or lowest: there its two values meet."""
    at, width = 0.0, np.pi
    for _ in range(4):
        tried = np.repeat(q[None], 2001, axis=0)
        tried[:, 2] = at + np.linspace(-width, width, len(tried))
        T = forward(robot, tried)
        at, width = tried[np.argmax(side * (T[:, 2, 3] - TOOL * T[:, 2, 2])), 2], 1e-2 * width
    return np.array([*q[:2], at, *q[3:]])


@pytest.mark.breadth
def test_what_rounding_puts_out_of_reach_is_led_back() -> None:
    """Rows are refined: branches end far outside of where they meet, also for fast code."""
    compilation = made_up(NAME, ROWS, "")
    solver, source = library(compilation.module, folder()), np.random.default_rng(0)
    for _ in range(60):
        q = source.uniform(-2.0, 2.0, 5) * np.array([1.0, 0.25, 1.0, 1.0, 1.0])
        q = turned_to_the_top(compilation.robot, q, source.choice([-1.0, 1.0]))
        T = np.array(forward(compilation.robot, q))
        T[:3, 3] = np.round(T[:3, 3], 6)
        _, status = solver.ik(T, q)
        assert np.isin(status, HELD).any()
