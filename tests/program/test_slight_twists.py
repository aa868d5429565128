"""Twists that are nearly right angles fix by little what those would leave free."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.paul.derive import derive
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import lower
from tests.kinematics.values import table

TWIST = 1.571  # 2e-4 beside a right angle
WRIST = (
    f"theta: q, a: 0.255, alpha: -{TWIST}",
    "theta: q, d: 0.365, a: 0.567",
    f"theta: q, a: 0.309, alpha: -{TWIST}",
    f"theta: q, d: 0.099, alpha: {TWIST}",
    f"theta: q, alpha: -{TWIST}",
    "theta: q",
)
COUNT = 150
NEAR = 1e-3  # [rad] two solutions meet here


@pytest.mark.breadth
def test_joints_that_a_slight_twist_fixes_are_found() -> None:
    """Joint 4 turns a vector of 4e-4 to the edge of its reach, by angles that were rounded."""
    chain = build_chain(table(*WRIST, tool="{xyz: [0.065, 0, 0.049], rpy: [0, 30 deg, 0]}"))
    q = np.random.default_rng(5).uniform(-3.0, 3.0, (COUNT, chain.dof))
    q[:, [1, 2, 4, 5]] = np.pi
    rows = interpret(lower(derive(chain)), numeric_arm(chain).pose(q), q)
    off = np.abs(np.remainder(rows.q - q[:, None] + np.pi, 2 * np.pi) - np.pi).max(axis=2)
    nearest = np.where(rows.solved, off, np.inf).min(axis=1)
    assert nearest.max() < NEAR, q[nearest.argmax()]
