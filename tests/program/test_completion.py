"""Rows of a program that miss their pose are completed where it is interpreted."""

from __future__ import annotations

import numpy as np

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.numerical.kernel import numerical_kernel
from dhgen.paul.derive import derive
from dhgen.program.completion import Completion
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import lower
from dhgen.robot.load import load
from dhgen.tolerances import TOLERANCES
from tests.kinematics.values import table
from tests.targets.made import ROBOTS

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
    arm = numeric_arm(chain)
    T = arm.pose(np.array([0.0, -1e-6, np.pi, 0.0]))
    rows = interpret(lower(derive(chain)), T[None], np.zeros((1, 4)))
    assert rows.solved.any()
    missed = np.abs(arm.pose(rows.q[rows.solved]) - T).max(axis=(1, 2))
    assert missed.max() <= TOLERANCES.exact


def test_rows_may_miss_by_what_counts_of_a_pose() -> None:
    """A row without a solution misses nothing; the rotation of the tool's z axis does not count."""
    chain = build_chain(load(ROBOTS / "welding_5r.yaml"))
    completion = Completion(numerical_kernel(chain, redundant=False), 3, ())
    q = np.array([0.4, -0.7, 0.5, 0.9, 0.8])
    T, c, s = numeric_arm(chain).pose(q), np.cos(0.3), np.sin(0.3)
    T[:3, :2] = T[:3, :2] @ np.array([[c, -s], [s, c]])
    rows = np.array([q, q, np.full(5, np.nan)])
    rows[1, 0] += 1e-9
    assert completion.may_miss(T[None], rows[None]).tolist() == [[False, True, False]]
