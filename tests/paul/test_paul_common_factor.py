"""A quartic whose coefficients shared a factor that the pose gives: none may be left in them.

The three first axes meet, and joint 4 slides. Both equations for joints 5 and 6 hold the point
where they meet as seen from the tool; where its y is zero, the Jacobian is regular, and yet every
coefficient vanished with the fourth power of it.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from dhgen.program.interpret import interpret
from tests.structures import first_of
from tests.targets.made import made_up

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.compiler import Compilation

JOINTS = (
    "theta: q, d: 0.3, a: 0, alpha: pi/2",
    "theta: q, d: 0, a: 0, alpha: -pi/2",
    "theta: q, d: 0.35, a: 0.05, alpha: pi/2",
    "theta: 0.3, d: q, a: 0.3, alpha: 1.2217304763960306",
    "theta: q, d: 0.12, a: 0.2, alpha: pi/2",
    "theta: q, d: 0.1, a: 0.15, alpha: 0",
)
MEETING = np.array([0.0, 0.0, 0.3, 1.0])  # of axes 1, 2 and 3, in the base
COUNT = 40


@cache
def compiled() -> Compilation:
    compilation = made_up("common_factor", JOINTS, "", convention="standard")
    assert compilation.module.method == "quartic"
    return compilation


def poses_of(q: FloatArray) -> FloatArray:
    return np.asarray(forward(compiled().robot, q), dtype=float)


def seen_from_tool(q: FloatArray) -> FloatArray:
    return np.asarray(np.linalg.inv(poses_of(q)) @ MEETING)


def with_the_point_at(height: float) -> FloatArray:
    """Joint vectors for which the y of the point, as seen from the tool, is this [m].

    Joint 6 turns the point about the tool's z axis; its x beside that axis is moved by a_6.
    """
    q: FloatArray = np.random.default_rng(11).uniform(-2.5, 2.5, (COUNT, 6))
    q[:, 3] = np.abs(q[:, 3])
    q[:, 5] = 0.0
    x, y = seen_from_tool(q)[:, 0] + 0.15, seen_from_tool(q)[:, 1]
    q[:, 5] = np.arctan2(y, x) - np.arcsin(height / np.hypot(x, y))
    np.testing.assert_allclose(seen_from_tool(q)[:, 1], height, atol=1e-12)
    return q


@pytest.mark.parametrize("height", [0.0, 1e-12, 1e-9, 1e-6, 1e-3])
def test_the_joint_values_that_made_a_pose_are_among_its_rows(height: float) -> None:
    q = with_the_point_at(height)
    poses = poses_of(q)
    found = interpret(compiled().module.solver, poses, np.zeros(6))
    off = found.q - q[:, None]
    turning = [0, 1, 2, 4, 5]
    off[..., turning] = np.remainder(off[..., turning] + np.pi, 2 * np.pi) - np.pi
    gaps = np.where(found.solved, np.abs(off).max(axis=-1), np.inf).min(axis=1)
    assert gaps.max() < 1e-6


def test_the_pose_that_was_reported_has_eight_solutions() -> None:
    """Six of them were missing; an independent search had found eight."""
    T = [
        [0.34745968660546905, 0.4657564327687933, 0.8138444025233064, 0.878798695241903],
        [-0.8195271383752596, 0.572610753896934, 0.02218544541005431, 0.5679174745188639],
        [-0.4556830429700968, -0.6746761221920285, 0.5806591896228283, 1.3942802470284512],
        [0.0, 0.0, 0.0, 1.0],
    ]
    found = interpret(compiled().module.solver, np.array([T]), np.zeros(6))
    rows = found.q[0][found.solved[0]]
    assert len(rows) == 8
    np.testing.assert_allclose(poses_of(rows), [T] * 8, atol=1e-10)


OBLIQUE = (
    "theta: q, d: 0.175, a: 0, alpha: -pi/2",
    "theta: q, d: 0, a: 0, alpha: pi/2",
    "theta: q, d: 0.068, a: 0.288, alpha: -pi/2",
    "theta: 1.14, d: q, a: 0.317, alpha: 0.56",
    "theta: q, d: 0.279, a: 0.28, alpha: 1.053",
    "theta: q, d: 0.357, a: 0.404, alpha: -0.492",
)


LOST = (
    (
        "-2.0710887181859823 -0.5266295604637588 1.0070537179939043 "
        "-0.20303899842543038 1.4044061585371912 -2.6086802234479736"
    ),
    (
        "1.0350456277582039 1.2478834463777844 -0.8655716170976600 "
        "-1.0691083406537187 -3.0279863037522823 -0.5663135593000597"
    ),
    (
        "2.9373014051470187 0.23331935636513146 -1.25170124632318 "
        "-0.20291579070231225 1.3618168674080504 1.9076090474190526"
    ),
)


@pytest.mark.parametrize("values", first_of(LOST))
def test_a_factor_that_is_a_complex_number(values: str) -> None:
    """V1 and V2 shared one whose parts have nothing in common: recall showed where it is small."""
    q = np.array(values.split(), dtype=float)
    compilation = made_up("oblique_factor", OBLIQUE, "", convention="standard")
    T = np.asarray(forward(compilation.robot, q), dtype=float)
    found = interpret(compilation.module.solver, T[None], np.zeros(6))
    rows = found.q[0][found.solved[0]]
    assert np.abs(rows - q).max(axis=1).min() < 1e-6
