"""Where the nearest arm's rows are said to be all it has the same ones at all poses near by."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.nominal.nominal import Nominal, nominal_arm
from dhgen.program.interpret import outputs
from dhgen.robot.load import load_text
from dhgen.targets.reserved import RESERVED
from tests.nominal.twins import twin

POSES = 3000


def rotations(rng: np.random.Generator, angle: float, count: int) -> np.ndarray:
    """Rotations by an angle about random axes, (count, 3, 3), by Rodrigues' formula."""
    axes = rng.normal(size=(count, 3))
    axes /= np.linalg.norm(axes, axis=1)[:, None]
    K = np.zeros((count, 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        K[:, k, j], K[:, j, k] = axes[:, i], -axes[:, i]
    return np.asarray(np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * (K @ K))


def solved(nominal: Nominal, poses: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Which rows there are, (N, rows), and at which poses they are said to be all."""
    found = outputs(nominal.regular.program, poses)
    rows = np.broadcast_arrays(*found[:6])
    exists = ~np.isnan(np.array(rows)).any(axis=0).reshape(len(poses), -1)
    doubts = [each.reshape(len(poses), -1).any(axis=1) for each in found[6:]]
    return exists, ~np.any(doubts, axis=0)


@pytest.mark.parametrize(("name", "noise"), [("ur5e", 1e-4), ("puma560", 3e-4)])
def test_rows_are_the_same_all_around(name: str, noise: float) -> None:
    chain = build_chain(load_text(twin(name, noise), "twin.yaml"))
    nominal = nominal_arm(chain, RESERVED)
    assert nominal is not None
    rng, nearest = np.random.default_rng(3), nominal.nearest
    q = rng.uniform(-np.pi, np.pi, (POSES, 6))
    T = np.array(nearest.left) @ numeric_arm(chain).pose(q) @ np.array(nearest.right)
    exists, certain = solved(nominal, T)
    assert 0.5 < certain.mean() < 0.97
    differs = np.zeros(POSES, bool)
    for _ in range(20):
        other = T.copy()
        other[:, :3, :3] = rotations(rng, nearest.deviation.angle, POSES) @ T[:, :3, :3]
        way = rng.normal(size=(POSES, 3))
        way *= nearest.deviation.length / np.linalg.norm(way, axis=1)[:, None]
        other[:, :3, 3] += way
        differs |= (solved(nominal, other)[0] != exists).any(axis=1)
    assert not differs[certain].any()
    assert differs[~certain].sum() > 5  # poses at which branches end near by are found at all
