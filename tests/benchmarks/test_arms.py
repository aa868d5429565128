"""What rivals are told about an arm describes the same arm."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from benchmarks.arms import CASES, Arm, Case, read_arm, robot_path
from benchmarks.contestant import AbsentError
from benchmarks.rivals import RIVALS, rivals
from benchmarks.rivals.common_normals import standard_table
from benchmarks.rivals.opw import AXES
from benchmarks.rivals.toolbox import standard
from benchmarks.screws import Screws, screws

if TYPE_CHECKING:
    from pathlib import Path

PRESENT = [case for case in CASES if robot_path(case.name).exists()]
TURNING = [case for case in PRESENT if case.name not in {"scara", "stanford"}]


def rotation(direction: np.ndarray, point: np.ndarray, angle: float) -> np.ndarray:
    """About an axis that need not pass through the origin (Rodrigues)."""
    x, y, z = direction
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    T = np.eye(4)
    T[:3, :3] += np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    T[:3, 3] = point - T[:3, :3] @ point
    return T


def pose(frame: Screws, q: np.ndarray) -> np.ndarray:
    T = np.eye(4)
    for direction, point, angle in zip(frame.directions, frame.points, q, strict=True):
        T = T @ rotation(direction, point, angle)
    return T @ frame.home


@pytest.mark.parametrize("case", TURNING, ids=lambda case: case.name)
def test_screws_are_the_arm(case: Case) -> None:
    arm = read_arm(case)
    at = np.array(case.upright or np.zeros(arm.dof))
    frame = screws(arm, tuple(at))
    for q in np.random.default_rng(3).uniform(-3, 3, (5, arm.dof)):
        np.testing.assert_allclose(pose(frame, q), arm.model.pose(at + q), atol=1e-13)
    assert np.allclose(np.cumsum(frame.offsets, axis=0)[:-1], frame.points)


@pytest.mark.parametrize("case", [c for c in PRESENT if c.upright], ids=lambda case: case.name)
def test_upright_is_upright(case: Case) -> None:
    frame = screws(read_arm(case), case.upright)
    assert np.allclose(np.abs(np.sum(frame.directions * AXES, axis=1)), 1.0)
    assert np.allclose(frame.points[3:, :2], frame.points[4, :2])


def link(theta: float, d: float, a: float, alpha: float) -> np.ndarray:
    x, z = np.array([1.0, 0, 0]), np.array([0, 0, 1.0])
    turned, twisted = rotation(z, np.zeros(3), theta), rotation(x, np.zeros(3), alpha)
    turned[2, 3], twisted[0, 3] = d, a
    return np.asarray(turned @ twisted)


@pytest.mark.parametrize("name", ["arm_6r", "ur5", "kuka_kr6_r900", "wrist_zyz", "planar_rrr"])
def test_a_table_of_common_normals_is_the_arm(name: str) -> None:
    """Axes that are parallel, that meet, that are skew."""
    arm = read_arm(Case(name, ""))
    base, rows, tool = standard_table(screws(arm))
    for q in np.random.default_rng(4).uniform(-3, 3, (5, arm.dof)):
        T = base
        for value, (theta, d, a, alpha) in zip(q, rows, strict=True):
            T = T @ link(theta + value, d, a, alpha)
        np.testing.assert_allclose(T @ tool, arm.model.pose(q), atol=1e-13)


@pytest.mark.parametrize("name", ["arm_6r", "rrprrr", "stanford", "kuka_kr6_r900", "puma"])
def test_the_toolbox_is_told_of_the_same_arm(name: str) -> None:
    """Standard and modified tables, and axes."""
    arm = read_arm(Case(name, ""))
    table = standard(arm)
    for q in np.random.default_rng(4).uniform(-3, 3, (5, 6)):
        T = table.base
        for value, turns, sign, (theta, d, a, alpha) in zip(
            q, arm.turning, table.signs, table.links, strict=True
        ):
            turned, slid = (sign * value, 0.0) if turns else (0.0, sign * value)
            T = T @ link(theta + turned, d + slid, a, alpha)
        np.testing.assert_allclose(T @ table.tool, arm.model.pose(q), atol=1e-13)


def test_the_toolbox_takes_six_joints(scara: Arm) -> None:
    with pytest.raises(AbsentError, match="six joints"):
        standard(scara)


@pytest.fixture(scope="module")
def scara() -> Arm:
    return read_arm(next(case for case in CASES if case.name == "scara"))


def test_a_sliding_joint_has_no_screws_of_this_kind(scara: Arm) -> None:
    with pytest.raises(AbsentError, match="revolute"):
        screws(scara)


def test_everybody_is_there_or_is_missed(scara: Arm, tmp_path: Path) -> None:
    present, absent = rivals(scara, tmp_path)
    assert present == []  # nobody else takes a SCARA
    assert [each.tool for each in absent] == list(RIVALS)
    assert all(each.why for each in absent)


def test_aligned_poses_are_of_quarter_turns(scara: Arm) -> None:
    T = scara.aligned_poses(10)
    assert np.allclose(T[:, :2, :2], np.round(T[:, :2, :2]))
    assert len(np.unique(np.round(T, 9), axis=0)) > 5
