"""Rows that do not reproduce their pose are left out, also where an equation falls silent."""

from __future__ import annotations

from itertools import product

import numpy as np

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.paul.derive import derive
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import lower
from tests.kinematics.values import table

LENGTH = -0.23
RAIL = (
    f"theta: 0, d: q, a: {LENGTH}",
    "theta: q, alpha: -pi/2",
    "theta: q, alpha: pi/2",
    f"theta: q - pi/2, d: {LENGTH}, a: {LENGTH}, alpha: pi/2",
    f"theta: -q, a: {LENGTH}, alpha: -pi/2",
    "theta: -q + pi/2, d: 0.06",
)


def test_no_row_misses_a_pose_at_right_angles() -> None:
    chain = build_chain(table(*RAIL))
    program = lower(derive(chain))
    turns = np.array(list(product((-np.pi / 2, 0.0, np.pi), repeat=5)))
    q = np.concatenate([np.full((len(turns), 1), 0.3), turns], axis=1)
    arm = numeric_arm(chain)
    poses = arm.pose(q)
    rows = interpret(program, poses, q)
    reached = arm.pose(np.where(rows.solved[..., None], rows.q, 0.0))
    miss = np.abs(reached - poses[:, None]).max(axis=(2, 3))
    assert rows.solved.any(axis=1).all()
    assert miss[rows.solved].max() < 1e-5
