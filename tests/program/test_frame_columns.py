"""Columns carried along known links: the same solutions in fewer operations for odd twists."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.given import given_values
from dhgen.kinematics.numeric import numeric_arm
from dhgen.oracle.forward import forward
from dhgen.program.count import count_operations
from dhgen.program.interpret import interpret
from dhgen.program.lowering import lower as lowering
from dhgen.program.lowering import polynomials
from dhgen.robot.load import load_text
from tests.derivation.stories import story
from tests.derived import derived
from tests.robots.cases import ROBOTS
from tests.structures import first_of

if TYPE_CHECKING:
    from dhgen.paul.derivation import Derivation
    from dhgen.robot.robot import Robot

# Additions and multiplications of all rows, carried and multiplied out. The columns of the arm with
# a general wrist begin at joints that are solved late, which costs more than it saves.
COUNTS = {
    "franka_panda": ((347, 651), (664, 1129)),
    "spherical_wrist_general_arm": ((443, 914), (443, 914)),
}


@cache
def arm(name: str) -> tuple[Robot, Derivation]:
    """A robot with twists as data sheets write them, and its derivation."""
    text = Path(ROBOTS / f"{name}.yaml").read_text(encoding="utf-8")
    robot = load_text(re.sub(r"(alpha: -?)pi/2", r"\g<1>1.5708", text), f"{name}.yaml")
    return robot, derived(build_chain(robot))


@pytest.mark.breadth
@pytest.mark.parametrize("name", COUNTS)
def test_operations(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    best, long = COUNTS[name]
    assert all(count <= most for count, most in zip(counted(name), best, strict=True))
    monkeypatch.setattr(lowering, "LONG", 10_000)
    assert counted(name) == long


def counted(name: str) -> tuple[int, int]:
    found = count_operations(lowering.lower(arm(name)[1]))
    return found.additions, found.multiplications


@pytest.mark.breadth
def test_rows_are_those_of_what_is_multiplied_out(monkeypatch: pytest.MonkeyPatch) -> None:
    robot, derivation = arm("franka_panda")
    q = np.random.default_rng(3).uniform(-1.5, 1.5, (200, len(robot.joints)))
    T = np.asarray(forward(robot, q), dtype=float)
    free = q[:, [joint - 1 for joint in robot.free]]
    carried = interpret(lowering.lower(derivation), T, np.zeros_like(q), free)
    monkeypatch.setattr(lowering, "LONG", 10_000)
    multiplied_out = interpret(lowering.lower(derivation), T, np.zeros_like(q), free)
    assert (carried.solved == multiplied_out.solved).all()
    apart = np.remainder(carried.q - multiplied_out.q + np.pi, 2 * np.pi) - np.pi
    assert np.nanmax(np.abs(apart)) < 1e-8
    apart = np.remainder(carried.q - q[:, None] + np.pi, 2 * np.pi) - np.pi
    assert np.nanmin(np.abs(apart).max(axis=-1), axis=1).max() < 1e-8


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    first_of(
        [
            *("stanford", "scorbot_pointing", "welding_5r", "ur5", "kuka_iiwa14_arm_angle"),
            *("prismatic_2_wrist", "rrprrr", "spherical_wrist_general_arm"),
        ],
        count=3,
    ),
)
def test_every_kind_of_column(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Slides, sums of angles, points by name, inverted forms: as if coefficients were long."""
    derivation = story(name).derivation
    model = numeric_arm(derivation.problem.algebra.chain)
    q = np.random.default_rng(5).uniform(-1.5, 1.5, (100, derivation.problem.algebra.chain.dof))
    T, free = model.pose(q), given_values(model, q)
    expected = interpret(lowering.lower(derivation), T, np.zeros_like(q), free)
    for module in (polynomials, lowering):
        monkeypatch.setattr(module, "LONG", 3)
    monkeypatch.setattr(lowering, "WORTH", np.inf)
    monkeypatch.setattr(lowering, "SHORTER", np.inf)
    carried = interpret(lowering.lower(derivation), T, np.zeros_like(q), free)
    assert (carried.solved == expected.solved).all()
    assert carried.solved.any(axis=1).mean() > 0.9
    apart = np.remainder(carried.q - expected.q + np.pi, 2 * np.pi) - np.pi
    assert np.nanmax(np.abs(apart)) < 1e-8
