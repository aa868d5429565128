"""Twists of 1.5708 instead of pi/2: all rows, and all their digits."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.paul.derive import derive
from dhgen.paul.kind import Kind
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import lower
from dhgen.robot.load import load
from tests.robots.cases import ROBOTS
from tests.structures import first_of

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.kinematics.chain import Chain

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

POSES = 40


def nearly_right(folder: Path, name: str) -> Chain:
    """An arm of robots/ with rounded twists."""
    text = (ROBOTS / f"{name}.yaml").read_text(encoding="utf-8")
    path = folder / f"{name}.yaml"
    path.write_text(text.replace("alpha: pi/2", "alpha: 1.5708"), encoding="utf-8")
    return build_chain(load(path))


@pytest.mark.parametrize("name", first_of(["abb_irb120", "ur5", "stanford"]))
def test_digits_and_rows(tmp_path: Path, name: str) -> None:
    chain = nearly_right(tmp_path, name)
    arm, source = numeric_arm(chain), np.random.default_rng(21)
    q = source.uniform(-2.0, 2.0, (POSES, chain.dof))
    poses = arm.pose(q)
    derivation = derive(chain)
    assert Kind.CIRCLE not in {step.kind for step in derivation.steps}
    rows = interpret(lower(derivation), poses, q, np.empty((POSES, 0)))
    reached = arm.pose(np.where(rows.solved[..., None], rows.q, 0.0))
    misses = np.abs(reached - poses[:, None]).max(axis=(2, 3))
    assert misses[rows.solved].max() < 1e-12
    away = np.abs(np.remainder(rows.q - q[:, None] + np.pi, 2 * np.pi) - np.pi).max(axis=2)
    assert np.where(rows.solved, away, np.inf).min(axis=1).max() < 1e-8


# Twists of 1.57079 part the roots of its slide's squared length by some micrometres.
STANFORD = """
name: arm
joints:
  - {theta: q, d: 0.072, alpha: -1.57079}
  - {theta: q, d: 0.581, alpha: 1.57079}
  - {theta: 0, d: q}
  - {theta: q, alpha: -1.57079}
  - {theta: q, alpha: 1.57079}
  - {theta: q, d: 0.317}
"""


def test_a_slide_that_is_drawn_in_leaves_a_joint_free(tmp_path: Path) -> None:
    """Its length is rounding of its square divided by those micrometres, and tells no direction."""
    (tmp_path / "arm.yaml").write_text(STANFORD, encoding="utf-8")
    chain = build_chain(load(tmp_path / "arm.yaml"))
    q = np.array([[np.pi / 2, second, 0.0, -np.pi / 2, 0.3, -np.pi / 2] for second in (0.0, 0.7)])
    rows = interpret(lower(derive(chain)), numeric_arm(chain).pose(q), q)
    away = np.abs(rows.q - q[:, None]).max(axis=2)
    assert np.where(rows.free, away, np.inf).min(axis=1).max() < 1e-9


# Its slide and joint 2 are polar coordinates of a vector of which two of three components tell, one
# of them by the cosine of a twist.
SLANTED = """
name: arm
convention: modified
joints:
  - {theta: q, a: 0.2, alpha: 1.571}
  - {theta: q, alpha: -1.5708}
  - {theta: 0, d: q, alpha: pi/2}
  - {theta: q, alpha: pi/2}
  - {theta: q, alpha: 1.5708}
  - {theta: q, d: 0.1, alpha: -1.5708}
"""


def test_polar_coordinates_are_not_divided_by_next_to_nothing(tmp_path: Path) -> None:
    (tmp_path / "arm.yaml").write_text(SLANTED, encoding="utf-8")
    chain = build_chain(load(tmp_path / "arm.yaml"))
    arm, source = numeric_arm(chain), np.random.default_rng(6)
    q = source.uniform(-2.0, 2.0, (POSES, chain.dof))
    poses = arm.pose(q)
    rows = interpret(replace(lower(derive(chain)), completion=None), poses, q)
    reached = arm.pose(np.where(rows.solved[..., None], rows.q, 0.0))
    assert np.abs(reached - poses[:, None]).max(axis=(2, 3))[rows.solved].max() < 1e-13


@pytest.mark.breadth
def test_rows_that_would_miss_are_refined(tmp_path: Path) -> None:
    """Seven twists: what is left of the digits is too little at right angles."""
    assert lower(derive(nearly_right(tmp_path, "kuka_iiwa14"))).completion is not None


@pytest.mark.parametrize(
    "joints",
    [
        # a wrist and a planar arm whose twists are off by a calibration of 1e-7
        ("alpha: pi/2 - 7.8873e-8", "alpha: -pi/2", "alpha: -4.1773e-8"),
        (
            "a: 0.4, alpha: 4e-8, d: 2e-8",
            "a: 0.3, alpha: 6e-8, d: 5e-8",
            "a: 0.1, alpha: -3e-8, d: 6e-8",
        ),
    ],
)
def test_what_only_noise_says_is_not_divided_by(tmp_path: Path, joints: tuple[str, ...]) -> None:
    """All digits, although some elements are made of next to nothing but noise."""
    path = tmp_path / "arm.yaml"
    rows = "".join(f"  - {{theta: q, {joint}}}\n" for joint in joints)
    task = "pose" if "a: 0.4" in joints[0] else "orientation"
    path.write_text(f"name: arm\ntask: {task}\njoints:\n{rows}", encoding="utf-8")
    chain = build_chain(load(path))
    arm = numeric_arm(chain)
    q = np.random.default_rng(5).uniform(-2.0, 2.0, (POSES, 3))
    rows_found = interpret(lower(derive(chain)), arm.pose(q), q, np.empty((POSES, 0)))
    away = np.abs(np.remainder(rows_found.q - q[:, None] + np.pi, 2 * np.pi) - np.pi).max(axis=2)
    assert np.where(rows_found.solved, away, np.inf).min(axis=1).max() < 1e-12


@pytest.mark.parametrize(
    "joints",
    first_of(
        [
            (joints,)
            for joints in [
                (
                    "theta: q, d: 0.57, a: -1e-7, alpha: 1.5707964",
                    "theta: q, d: 0.48, a: 0.56, alpha: -4.6e-7",
                    "theta: q, a: 0.49",
                ),
                (
                    "theta: q, a: 0.44, alpha: 1.5707963",
                    "theta: q, d: 0.26, a: 0.45, alpha: 1.57079635",
                    "theta: 0, d: q",
                ),
            ]
        ]
    ),
)
def test_roots_that_a_calibration_parts_are_roots(tmp_path: Path, joints: tuple[str, ...]) -> None:
    """The quartic's would be double ones of the arm that was drawn, which is not this one."""
    rows = "".join(f"  - {{{joint}}}\n" for joint in joints)
    (tmp_path / "arm.yaml").write_text(f"name: arm\ntask: position\njoints:\n{rows}", "utf-8")
    chain = build_chain(load(tmp_path / "arm.yaml"))
    q = np.random.default_rng(5).uniform(-2.0, 2.0, (POSES, 3))
    rows_found = interpret(lower(derive(chain)), numeric_arm(chain).pose(q), q)
    away = np.abs(np.remainder(rows_found.q - q[:, None] + np.pi, 2 * np.pi) - np.pi).max(axis=2)
    assert np.where(rows_found.solved, away, np.inf).min(axis=1).max() < 1e-6


# What is drawn has no length but the slide's.
SLIDE = """
name: arm
task: [x, y]
joints:
  - {theta: q + pi/2, d: 8.7e-8, a: 9.2e-8, alpha: pi/2 + 4.7e-8}
  - {theta: 0, d: q, a: 4.8e-8, limits: [0, 1]}
"""


SLIDE_BY_AXES = """
name: arm
task: [x, y]
axes:
  - {type: revolute, direction: [0, 0, 1], point: [0, 0, 8.7e-8]}
  - {type: prismatic, direction: [1, 0, 0], point: [0, 9.2e-8, 0], limits: [0, 1]}
"""


@pytest.mark.parametrize("text", [SLIDE, SLIDE_BY_AXES])
def test_a_slide_is_not_too_long_for_what_a_calibration_adds(text: str, tmp_path: Path) -> None:
    (tmp_path / "arm.yaml").write_text(text, encoding="utf-8")
    chain = build_chain(load(tmp_path / "arm.yaml"))
    q = np.random.default_rng(5).uniform((-2.0, 0.1), (2.0, 1.0), (POSES, 2))
    rows = interpret(lower(derive(chain)), numeric_arm(chain).pose(q), q)
    away = np.abs(rows.q - q[:, None]).max(axis=2)
    assert np.where(rows.solved, away, np.inf).min(axis=1).max() < 1e-12
