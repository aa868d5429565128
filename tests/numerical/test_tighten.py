"""Rows that are good to few digits become exact, or end."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.numerical.kernel import NumericalKernel, numerical_kernel
from dhgen.numerical.tighten import tighten
from dhgen.paul.derive import derive
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import lower
from dhgen.robot.load import load
from dhgen.tolerances import TOLERANCES
from tests.kinematics.values import table
from tests.targets.made import ROBOTS

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

Q = np.array([0.4, -0.7, 0.5, 0.9, 0.8])
OTHER = np.array([0.4, 2.4, -2.5, 0.9, 0.8])


def kernel(name: str, *, checked: bool) -> NumericalKernel:
    chain = build_chain(load(ROBOTS / f"{name}.yaml"))
    return replace(numerical_kernel(chain, redundant=False), checked=checked)


def tightened(arm: NumericalKernel, T: FloatArray, rows: FloatArray) -> FloatArray:
    return np.asarray(tighten(arm, T[None], rows[None], np.zeros(1))[0])


def misses(arm: NumericalKernel, T: FloatArray, rows: FloatArray) -> FloatArray:
    return np.asarray(np.abs(arm.arm.pose(rows) - T).max(axis=(1, 2)))


@pytest.mark.parametrize("off", [1e-10, 1e-7, 1e-4])
def test_a_row_becomes_exact(off: float) -> None:
    arm = kernel("xarm5", checked=True)
    T = arm.arm.pose(Q)
    (row,) = tightened(arm, T, (Q + off)[None])
    assert misses(arm, T, row[None]) < TOLERANCES.exact
    assert np.abs(row - Q).max() < 1e-10


def test_an_exact_row_stays_as_it_is() -> None:
    arm = kernel("xarm5", checked=True)
    assert (tightened(arm, arm.arm.pose(Q), Q[None]) == Q).all()


def test_beside_an_exact_row_what_is_not_exact_is_none() -> None:
    arm = kernel("xarm5", checked=True)
    T = arm.arm.pose(Q)
    rows = tightened(arm, T, np.array([OTHER, Q, np.full(5, np.nan)]))
    assert np.isnan(rows).all(axis=1).tolist() == [True, False, True]


def test_a_rounded_pose_keeps_its_row() -> None:
    """Five joints cannot take it exactly; what they miss it by is of the size of the rounding."""
    arm = kernel("xarm5", checked=True)
    T = arm.arm.pose(Q)
    T[:3, 3] += 1e-7
    (row,) = tightened(arm, T, Q[None])
    assert TOLERANCES.exact < misses(arm, T, row[None])[0] < 1e-6
    T[:3, 3] += 1e-3
    assert np.isnan(tightened(arm, T, Q[None])).all()


def test_rows_that_become_the_same_are_told_once() -> None:
    arm = kernel("xarm5", checked=True)
    rows = np.array([Q + 1e-6, Q + 2 * np.pi - 1e-6, Q])
    kept = ~np.isnan(tightened(arm, arm.arm.pose(Q), rows)).any(axis=1)
    assert kept.tolist() == [False, False, True]


def test_a_row_that_stays_out_of_reach_ends() -> None:
    arm = kernel("cuspidal_3r", checked=False)
    T = arm.arm.pose(Q[:3])
    T[:3, 3] *= 10.0
    assert np.isnan(tightened(arm, T, Q[None, :3])).all()


def test_far_away_rounding_is_more() -> None:
    """A slide that is far out moves the tool by more than a short arm's rounding."""
    arm = kernel("bartell_rprpr", checked=True)
    q = np.array([0.4, 1e4 * arm.arm.chain.size, 0.6, 0.2, 0.3])
    T = arm.arm.pose(q)
    near = q + np.array([0.0, 0.0, 0.0, 1e-9, 0.0])
    assert (tightened(arm, T, near[None]) == near).all()


# Where axis 4 is parallel to axes 1 and 2 the sum of joints 1 and 2 is free but for the position.
FREE_BUT_FOR_THE_POSITION = (
    "theta: q, d: 0.07, a: 0.42",
    "theta: q, a: 0.4, alpha: -pi/2",
    "theta: q, d: 0.24, a: 0.37, alpha: pi/2",
    "theta: q, alpha: -pi/2",
)


def test_a_seed_beside_what_serves_is_left_for_it() -> None:
    """It fits the pose as it would a rounded one, but this one was not rounded."""
    chain = build_chain(table(*FREE_BUT_FOR_THE_POSITION))
    arm = numerical_kernel(chain, redundant=False)
    T = arm.arm.pose(np.array([0.0, -1e-6, np.pi, 0.0]))
    rows = interpret(lower(derive(chain)), T[None], np.zeros((1, 4)))
    assert rows.solved.any()
    assert misses(arm, T, rows.q[rows.solved]).max() <= TOLERANCES.exact
