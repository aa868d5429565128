"""A task that gives the tool's z axis gives the point at which that meets the last axis."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.method import Method
from tests.derived import derived
from tests.kinematics.values import constant_values, matrix, table

if TYPE_CHECKING:
    from dhgen.paul.derivation import Derivation

ROWS = (
    "theta: q, d: 0.2, alpha: pi/2",
    "theta: q, a: 0.19",
    "theta: q, a: 0.139",
    "theta: q - pi/2, alpha: -pi/2",
    "theta: q, d: 0.15",
)


def five_joints(tool: str) -> Derivation:
    return derived(build_chain(table(*ROWS, tool=tool, task="pointing")))


@pytest.mark.parametrize(
    ("tool", "back"),
    [
        ("{xyz: [0.05, 0, 0.12], rpy: [0, 30 deg, 0]}", 0.1),  # 0.05 / sin 30
        ("{xyz: [0, 0.06, 0.12], rpy: [60 deg, 0, 0]}", -0.12 / np.sqrt(3.0)),  # -0.06 / sin 60
        ("{xyz: [0.05, 0, 0.12], rpy: [0, 90 deg, 0]}", 0.05),
        ("{xyz: [0.05, 0, 0.12]}", 0.0),  # parallel
        ("{xyz: [0.05, 0.01, 0.12], rpy: [0, 30 deg, 0]}", 0.0),  # 0.01 beside it
    ],
)
def test_how_far_the_tool_is_from_where_its_axis_meets_the_last_one(tool: str, back: float) -> None:
    problem = five_joints(tool).pool.problem
    moved = matrix(problem.tool_left, constant_values(problem.algebra.chain))
    expected = np.eye(4)
    expected[2, 3] = back
    np.testing.assert_allclose(moved, expected, atol=1e-15)


def test_a_tilted_tool_has_as_many_rows_as_one_on_the_axis() -> None:
    """Two shoulders, two wrists and two elbows; joint 5 took a quartic, and half of the rows."""
    beside, on_it = (
        five_joints(f"{{xyz: [{x}, 0, 0.12], rpy: [0, 30 deg, 0]}}") for x in ("0.05", "0")
    )
    assert beside.branches == on_it.branches == 8
    assert beside.method is on_it.method is Method.CLOSED_FORM
