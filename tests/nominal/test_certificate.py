"""Where the nearest arm's rows are said to lead to all, no other branch has any near by."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.nominal.nominal import Nominal, nominal_arm
from dhgen.program.interpret import outputs
from dhgen.program.ir import Apply, Integer, Let
from dhgen.robot.load import load, load_text
from dhgen.targets.reserved import RESERVED
from tests.nominal.twins import ROBOTS, seven, twin
from tests.structures import first_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.program.ir import Expression

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

POSES = 3000


def rotations(rng: np.random.Generator, angle: float, count: int) -> np.ndarray:
    """Rotations by an angle about random axes, (count, 3, 3), by Rodrigues' formula."""
    axes = rng.normal(size=(count, 3))
    axes /= np.linalg.norm(axes, axis=1)[:, None]
    K = np.zeros((count, 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        K[:, k, j], K[:, j, k] = axes[:, i], -axes[:, i]
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * (K @ K))


def solved(nominal: Nominal, poses: np.ndarray, free: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Which rows there are, (N, rows), and at which poses they are said to be all."""
    found = outputs(nominal.regular.program, poses, free=free)
    dof = nominal.chain.dof
    rows = np.broadcast_arrays(*found[:dof])
    exists = ~np.isnan(np.array(rows)).any(axis=0).reshape(len(poses), -1)
    doubts = [each.reshape(len(poses), -1).any(axis=1) for each in found[dof:]]
    return exists, ~np.any(doubts, axis=0)


@pytest.mark.parametrize(
    "text",
    first_of(
        [
            twin("puma560", 3e-4),
            seven("shoulder_missed"),
            twin("ur5e", 1e-4),
            seven("wrist_missed"),
        ],
        count=2,
    ),
    ids=["puma560", "shoulder", "ur5e", "wrist"],
)
def test_no_other_branch_has_solutions_near_by(text: str) -> None:
    chain = build_chain(load_text(text, "twin.yaml"))
    nominal = nominal_arm(chain, RESERVED)
    assert nominal is not None
    rng, nearest = np.random.default_rng(3), nominal.nearest
    q = rng.uniform(-np.pi, np.pi, (POSES, chain.dof))
    given = q[:, [number - 1 for number in chain.free]]
    deviation = np.broadcast_to([nearest.deviation.angle, nearest.deviation.length], (POSES, 2))
    free = np.concatenate([given, deviation], axis=1)
    T = np.array(nearest.left) @ numeric_arm(chain).pose(q) @ np.array(nearest.right)
    exists, certain = solved(nominal, T, free)
    assert 0.5 < certain.mean() < 0.97
    begins = np.zeros(POSES, bool)
    for _ in range(20):
        other = T.copy()
        other[:, :3, :3] = rotations(rng, nearest.deviation.angle, POSES) @ T[:, :3, :3]
        way = rng.normal(size=(POSES, 3))
        way *= nearest.deviation.length / np.linalg.norm(way, axis=1)[:, None]
        other[:, :3, 3] += way
        begins |= (solved(nominal, other, free)[0] & ~exists).any(axis=1)
    assert not begins[certain].any()
    assert begins[~certain].sum() > 5  # poses at which branches begin near by are found at all


def test_no_condition_asks_whether_a_value_is_exactly_zero() -> None:
    """What given values alone determine, as this arm's N4, is the same at both arms' poses."""
    nominal = nominal_arm(build_chain(load(ROBOTS / "kinova_gen3_7.yaml")), RESERVED)
    assert nominal is not None
    program = nominal.regular.program
    lets = [each.expression for each in program.body if isinstance(each, Let)]
    compared = [each for let in lets for each in _compared(let)]
    assert compared
    assert Integer(0) not in compared


def _compared(expression: Expression) -> Iterator[Expression]:
    """What conditions compare values with."""
    if isinstance(expression, Apply):
        if expression.operator in {"at_most", "less"}:
            yield expression.operands[1]
        for operand in expression.operands:
            yield from _compared(operand)
