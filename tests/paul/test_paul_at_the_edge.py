"""Poses at the edge of reach, behind an angle that is good to few digits: rows all the same."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.paul.derive import derive
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import lower
from dhgen.robot.load import load
from dhgen.verify.measures import Measures

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.kinematics.chain import Chain

ABOUT = 1e-6  # [rad]: the vector that fixes an angle is this short

# Folded, its tool nearly along the parallel axes: theta123 is good to 1e-6.
FOLDED = """
name: arm
convention: modified
task: pointing
joints:
  - {theta: q, a: 0.031, alpha: pi/2}
  - {theta: q, d: 0.425, a: 0.132}
  - {theta: q - pi/2, d: 0.286, a: 0.54}
  - {theta: q, d: 0.44, alpha: pi/2}
  - {theta: pi/2, d: q, a: 0.502, alpha: -pi/2}
tool: {xyz: [0, 0, 0.588]}
"""
# A slide that is nearly in: its length, from its square, is good to 1e-4 of itself.
DRAWN_IN = """
name: arm
task: pointing
joints:
  - {theta: q, d: 0.048, alpha: -pi/2}
  - {theta: q, alpha: -60 deg}
  - {theta: pi/2, d: q, alpha: 45 deg}
  - {theta: q, alpha: pi/2}
  - {theta: q, alpha: -pi/2}
"""
# The same where twists of 1.57079 part its two lengths by some micrometres.
PARTED = """
name: arm
task: position
joints:
  - {theta: q, d: 0.573, alpha: 1.57079}
  - {theta: q, d: 0.221, alpha: 1.57079}
  - {d: q}
"""
# Two roots meet one after the other: theta1 is good to 1e-8 there, which takes theta6 out of reach.
TWICE = """
name: arm
task: pose
joints:
  - {theta: q + 0.4, d: 0.465, a: 0.147, alpha: -pi/2}
  - {theta: q, alpha: pi/2}
  - {theta: q, a: 0.53, alpha: pi/2}
  - {theta: pi/2, d: q, alpha: pi/2}
  - {theta: q, a: 0.573}
  - {theta: q}
"""


def chain_of(folder: Path, text: str) -> Chain:
    (folder / "arm.yaml").write_text(text, encoding="utf-8")
    return build_chain(load(folder / "arm.yaml"))


@pytest.mark.parametrize(
    ("text", "q"),
    [
        (FOLDED, (-1.2375837618997092, -ABOUT, np.pi, -np.pi / 2 - 1e-10, 2.944)),
        (DRAWN_IN, (-0.9788532381458758, np.pi - 1e-10, -ABOUT, -0.908462, 0.119999)),
        (PARTED, (1.3402059921510396, 3.055345808163856, -1.4061616723291422e-06)),
        (TWICE, (-2.9832770451812705, -0.80308361736, -1e-10, -1.293479089437, -ABOUT, 1.57079532)),
    ],
)
def test_there_are_rows_and_they_are_exact(tmp_path: Path, text: str, q: tuple[float, ...]) -> None:
    chain = chain_of(tmp_path, text)
    arm = numeric_arm(chain)
    T = np.asarray(arm.pose(np.array(q)))
    for seed in (np.array(q), np.zeros(len(q))):
        rows = interpret(lower(derive(chain)), T[None], seed[None])
        assert rows.solved.any()
        assert Measures(chain).residual(rows.q[0][rows.solved[0]], T) < 1e-11


@pytest.mark.parametrize("longer", [1e-6, 1e-9])
def test_a_little_out_of_reach_is_out_of_reach(tmp_path: Path, longer: float) -> None:
    """The edge is widened for rows that can be made exact, and for no others."""
    q = np.array([0.3, 0.0, 0.4, 0.7, 0.2])
    other = chain_of(tmp_path, FOLDED.replace("a: 0.54", f"a: {0.54 + longer}"))
    T = np.asarray(numeric_arm(other).pose(q))
    chain = chain_of(tmp_path, FOLDED)
    program = lower(derive(chain))
    assert program.completion is not None
    for pose, reached in ((numeric_arm(chain).pose(q), True), (T, False)):
        rows = interpret(program, np.asarray(pose)[None], q[None])
        near = np.abs(rows.q[0][rows.solved[0]] - q).max(axis=1) < 1e-2
        assert near.any() == reached
