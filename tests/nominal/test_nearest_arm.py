"""The nearest arm with a structure: what it is, and that no pose is farther away than it says."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.nominal.nearest import Nearest, nearest_arms
from dhgen.robot.load import load, load_text
from tests.nominal.twins import ROBOTS, SIX, seven, twin

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain


def turn(angle: float, axis: str) -> np.ndarray:
    c, s = math.cos(angle), math.sin(angle)
    i, j = {"z": (0, 1), "x": (1, 2)}[axis]
    matrix = np.eye(4)
    matrix[i, i], matrix[i, j], matrix[j, i], matrix[j, j] = c, -s, s, c
    return matrix


def moved(x: float, z: float) -> np.ndarray:
    matrix = np.eye(4)
    matrix[0, 3], matrix[2, 3] = x, z
    return matrix


def pose(nearest: Nearest, q: np.ndarray) -> np.ndarray:
    """T of the nearest arm at joint values of the arm, factor by factor."""
    T, table = np.linalg.inv(np.array(nearest.left)), nearest.table
    angles = q + np.array(nearest.offsets)
    for angle, d, a, alpha in zip(angles, table.d, table.a, table.alpha, strict=False):
        T = T @ turn(angle, "z") @ moved(a, d) @ turn(alpha, "x")
    return np.asarray(T @ turn(angles[-1], "z") @ np.linalg.inv(np.array(nearest.right)))


def most_apart(chain: Chain, nearest: Nearest) -> np.ndarray:
    """The most that the tools are turned and moved by [rad, length] at random joint values."""
    rng, most, arm = np.random.default_rng(2), np.zeros(2), numeric_arm(chain)
    for _ in range(300):
        angles = rng.uniform(-np.pi, np.pi, chain.dof)
        T = arm.pose(np.array(chain.drives.back(list(angles))))
        off = pose(nearest, angles)
        chord = np.linalg.norm(T[:3, :3] - off[:3, :3]) / math.sqrt(2.0)
        angle = 2.0 * math.asin(0.5 * chord)
        most = np.maximum(most, np.array([angle, np.linalg.norm(T[:3, 3] - off[:3, 3])]))
    return most


@pytest.mark.parametrize("noise", [1e-6, 1e-4, 1e-3])
@pytest.mark.parametrize("name", ["ur5e", "puma560", "kuka_kr6_r900", "staubli_tx40"])
def test_no_pose_is_farther_away(name: str, noise: float) -> None:
    """Offsets of the joints are nobody's: q counts from where the arm's angles are zero."""
    chain = build_chain(load_text(twin(name, noise), "twin.yaml"))
    nearest = nearest_arms(chain)[-1]
    most = most_apart(chain, nearest)
    bound = np.array([nearest.deviation.angle, nearest.deviation.length])
    assert (most < bound).all()
    assert (most > 0.2 * bound).all()  # the bound is not an idle one
    assert (bound < 10.0 * noise).all()


@pytest.mark.parametrize(
    ("name", "missed"), [("shoulder_missed", 0.00088), ("wrist_missed", 0.0003)]
)
def test_what_lengths_miss_a_point_by_adds_up(name: str, missed: float) -> None:
    """Lengths that differ, and nothing else, move the tool by their sum at most."""
    chain = build_chain(load_text(seven(name), "seven.yaml"))
    nearest = nearest_arms(chain)[-1]
    assert nearest.deviation.length == pytest.approx(missed, abs=2e-9)
    assert nearest.deviation.angle == pytest.approx(0.0, abs=2e-9)
    assert 0.8 * missed < most_apart(chain, nearest)[1] < nearest.deviation.length


@pytest.mark.parametrize(
    ("text", "missed"), [(SIX, [0.0003, 0.0013]), (seven("shoulder_missed"), [0.00044, 0.00088])]
)
def test_arms_that_keep_a_length_come_first(text: str, missed: list[float]) -> None:
    """A shoulder's offset is no miss of a wrist; of two offsets one may be enough."""
    chain = build_chain(load_text(text, "kept.yaml"))
    found = nearest_arms(chain)
    told = [each.deviation.length for each in found]
    assert told[0] == pytest.approx(missed[0], abs=2e-9)
    assert told[-1] == pytest.approx(missed[1], abs=2e-9)
    assert told == sorted(told)
    for nearest, bound in zip(found, told, strict=True):
        assert 0.8 * bound < most_apart(chain, nearest)[1] < bound


def test_structures() -> None:
    """Twists and lengths that are nearly so are exact; the others are near the data sheet's."""
    chain = build_chain(load_text(twin("ur5e", 1e-4), "twin.yaml"))
    nearest = nearest_arms(chain)[-1]
    assert nearest.table.quarters == (1, 0, 0, 1, 1)
    np.testing.assert_allclose(nearest.table.a, [0.0, 0.425, 0.3922, 0.0, 0.0], atol=3e-4)
    np.testing.assert_allclose(nearest.table.d, [0.0, 0.0, 0.0, 0.1333, 0.0997], atol=5e-4)
    assert [each for each in nearest.table.a if not each] == [0.0] * 3
    assert [each for each in nearest.table.d if not each] == [0.0] * 3


def test_what_only_rounds_a_twist_is_undone() -> None:
    """Of an arm with one twist of four digits nothing but that twist is missed."""
    text = (ROBOTS / "puma560.yaml").read_text("utf-8").replace("alpha: pi/2", "alpha: 1.5708", 1)
    nearest = nearest_arms(build_chain(load_text(text, "puma560.yaml")))[-1]
    np.testing.assert_allclose(nearest.table.alpha[0], np.pi / 2.0, rtol=0.0, atol=1e-15)
    assert 0.0 < nearest.deviation.angle < 1e-5


@pytest.mark.parametrize("name", ["ur5e", "puma560"])
def test_nothing_is_near_an_arm_with_a_structure(name: str) -> None:
    assert nearest_arms(build_chain(load(ROBOTS / f"{name}.yaml"))) == []
