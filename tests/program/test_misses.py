"""Rows are compared with their pose in the frame from where that is least work."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.paul.derive import derive
from dhgen.program.interpret import interpret
from dhgen.program.lowering.checks import Checks
from dhgen.program.lowering.context import Lowering
from dhgen.program.lowering.final_check import misses
from dhgen.program.lowering.lower import lower
from dhgen.program.lowering.types import KERNELS
from dhgen.tolerances import TOLERANCES
from tests.kinematics.values import table

if TYPE_CHECKING:
    from dhgen.paul.derivation import Derivation

SLANTING = (  # four turns cannot take most poses, and the slant makes entries of their product long
    "theta: q, d: 0.2, alpha: -pi/2",
    "theta: q, d: 0.1, alpha: 0.7",
    "theta: q, a: 0.4, d: 0.3",
    "theta: q, d: 0.25",
)
OFF = 1e-3  # [rad and arm sizes]


@cache
def slanting() -> Derivation:
    return derive(build_chain(table(*SLANTING)))


def operations(*, moved: bool) -> int:
    """What comparing takes beyond the steps."""
    derivation = slanting()
    context = Lowering(derivation, TOLERANCES, Checks(rows=True, moved=moved))
    for number, step in enumerate(derivation.steps, start=1):
        context.step_number = number
        KERNELS[step.kind](context, step)
    before = len(context.builder.entries)
    return context.builder.operations([miss for miss, _ in misses(context)], before)


def test_another_frame_is_less_work() -> None:
    assert operations(moved=True) < operations(moved=False)


def test_rows_are_those_of_poses_that_the_arm_can_take() -> None:
    chain = slanting().problem.algebra.chain
    arm = numeric_arm(chain)
    q = np.random.default_rng(3).uniform(-2.5, 2.5, (200, chain.dof))
    program, poses = lower(slanting()), arm.pose(q)
    rows = interpret(program, poses, q)
    gaps = np.abs(np.angle(np.exp(1j * (rows.q - q[:, None])))).max(axis=2)
    assert (np.where(rows.solved, gaps, np.inf).min(axis=1) < 1e-9).all()
    reached = arm.pose(np.where(rows.solved[..., None], rows.q, 0.0))
    assert np.abs(reached - poses[:, None])[rows.solved].max() < 1e-11
    for place in ((0, 3), (1, 3), (2, 3)):
        off = poses.copy()
        off[:, *place] += OFF
        assert not interpret(program, off, q).solved.any()
    c, s = np.cos(OFF), np.sin(OFF)
    turned = poses.copy()
    turned[:, :3, :3] = turned[:, :3, :3] @ np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
    assert not interpret(program, turned, q).solved.any()
