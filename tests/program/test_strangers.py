"""Rows that do not reproduce their pose are left out, also where an equation falls silent."""

from __future__ import annotations

from itertools import product

import numpy as np

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.paul.derive import derive
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import lower
from dhgen.status import Status
from tests.compiling import library
from tests.kinematics.values import table
from tests.targets.made import folder, made_up

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


# Two equations of the orientation leave strangers here, which the whole pose keeps out; beside
# right angles joints are nearly free, and rows of the quartic miss the pose by more than rounding.
WRIST = (
    "theta: q, a: -0.25, alpha: pi",
    "theta: q, alpha: pi/2",
    "theta: pi/2, d: q, a: 0.1",
    "theta: q, d: 0.2, a: 0.1, alpha: -pi/2",
    "theta: q, d: 0.151, a: 0.2, alpha: pi/2",
    "theta: q, d: -0.25, a: 0.2, alpha: pi",
    "theta: q, d: 0.202, a: 0.1",
)
BESIDE = (-np.pi / 2 - 1e-8, -1.254, 1.3115, np.pi, -np.pi / 2 - 1e-6, 2.1682, -np.pi / 2 - 1e-10)


def test_rows_are_exact_where_the_arm_can_take_any_pose() -> None:
    """That rows are compared with the pose does not mean that it may have been rounded."""
    compilation = made_up("strangers", WRIST, "task: pose\nfree: [6]\n")
    solver, q = library(compilation.module, folder()), np.array(BESIDE)
    T = numeric_arm(compilation.module.chain).pose(q)
    for seed in (np.zeros(7), q):
        rows, status = solver.ik(T, seed, q[[5]])
        held = rows[status != Status.UNREACHABLE]
        assert len(held)
        reached = numeric_arm(compilation.module.chain).pose(held)
        np.testing.assert_allclose(reached, np.tile(T, (len(held), 1, 1)), atol=1e-11)
