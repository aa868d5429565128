"""What rows of arms as delivered are called: as the data sheet's arm calls their postures."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.nominal.nominal import nominal_arm
from dhgen.paul.derive import derive
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import lower
from dhgen.robot.load import load, load_text
from dhgen.targets.reserved import RESERVED
from tests.nominal.twins import ROBOTS, twin
from tests.structures import quick_first

if TYPE_CHECKING:
    from dhgen.program.ir import Program

POSES = 40
# A shoulder on axis 1, so that an error moves it before or behind that; then some that stand apart
# from it, before it or beside it.
ARMS = ["abb_irb120", "arm_6r", "staubli_rx90", "denso_vs060", "kuka_kr6_r900", "puma560"]
SEEN = {"front", "back", "left", "right", "up", "down"}


def words(program: Program, T: np.ndarray, q: np.ndarray) -> list[set[str]]:
    """Of each pose what a person sees of the row that has its joint values."""
    rows = interpret(program, T, None, None).q
    apart = np.abs((rows - q[:, None] + np.pi) % (2.0 * np.pi) - np.pi).max(axis=-1)
    nearest = np.nanargmin(apart, axis=1)
    assert np.nanmin(apart, axis=1).max() < 1e-6
    return [SEEN & set(program.branches[row].split("-")) for row in nearest]


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize("name", quick_first(ARMS, count=2))
def test_an_arm_keeps_its_words(name: str, seed: int) -> None:
    chain = build_chain(load(ROBOTS / f"{name}.yaml"))
    built = build_chain(load_text(twin(name, 3e-4, seed), name))
    near = nominal_arm(built, RESERVED)
    assert near is not None
    q = np.random.default_rng(3).uniform(-2.5, 2.5, (POSES, chain.dof))
    zeros = [
        joint.offset + more for joint, more in zip(built.joints, near.nearest.offsets, strict=True)
    ]
    values = q * [joint.sign for joint in built.joints] + zeros
    sheet = words(lower(derive(chain)), numeric_arm(chain).pose(q), q)
    assert words(near.solver, numeric_arm(near.chain).pose(values), values) == sheet
