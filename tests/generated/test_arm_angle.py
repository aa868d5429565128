"""Solvers that are given the arm angle, asked by geometry that is not theirs."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.arm_angle import arm_angle, elbow_of, given_values
from dhgen.oracle.poses import random_joints
from dhgen.status import HELD, Status
from tests.generated.asking import trial
from tests.generated.solvers import NAMES, ROBOTS, library, robot, short_module
from tests.structures import says

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

GIVEN = [name for name in NAMES if says(ROBOTS / f"{name}.yaml", "free: arm_angle")]
POSES = 200
RESIDUAL = 1e-11
SAME = 1e-9
IIWA = "kuka_iiwa14_arm_angle"


def apart(angles: FloatArray, other: FloatArray | float) -> float:
    """The largest difference of angles, whole turns aside."""
    return float(np.abs(np.remainder(angles - other + np.pi, 2 * np.pi) - np.pi).max())


def solved(name: str, T: FloatArray, psi: float) -> FloatArray:
    """The rows (k, 7) that hold joint values."""
    rows, status = library(name).ik(T, np.zeros(7), np.array([psi]))
    held = rows[np.isin(status, HELD)]
    assert trial(name).residuals(held, T).max(initial=0.0) < RESIDUAL
    return held


@pytest.mark.parametrize("name", GIVEN)
def test_the_arm_angle_of_joint_values_finds_them_again(name: str) -> None:
    asked = trial(name)
    q = random_joints(robot(name), POSES, seed=81)
    psi = arm_angle(robot(name), q)
    for joints, T, angle in zip(q, asked.poses(q), psi, strict=True):
        assert asked.apart(solved(name, T, angle), joints).min() < SAME


@pytest.mark.parametrize("name", GIVEN)
def test_every_row_has_the_arm_angle_that_was_asked_for(name: str) -> None:
    """Any arm angle does, and the elbow is where it says."""
    asked = trial(name)
    source = np.random.default_rng(82)
    q = random_joints(robot(name), POSES, seed=83)
    found = 0
    for T in asked.poses(q):
        angle = source.uniform(-10.0, 10.0)
        rows = solved(name, T, angle)
        found += len(rows)
        assert apart(arm_angle(robot(name), rows), angle) < SAME
        assert np.isfinite(elbow_of(robot(name), T, angle)).all()
    assert found == 8 * POSES


@pytest.mark.parametrize("name", GIVEN)
def test_the_files_know_the_arm_angle_of_joint_values(name: str) -> None:
    q = random_joints(robot(name), POSES, seed=84)
    psi = given_values(robot(name), q)[:, 0]
    python = short_module(name).arm_angle
    assert apart(np.array([python(each) for each in q]), psi) < SAME
    assert apart(np.array([library(name).arm_angle(each) for each in q]), psi) < SAME
    with pytest.raises(ValueError, match=r"q must have shape \(7,\), not"):
        python(np.zeros(6))


def test_a_stretched_arm_keeps_its_arm_angle() -> None:
    """The elbow is on the line then, and the plane is the one of an arm that is hardly bent."""
    asked = trial(IIWA)
    q = random_joints(robot(IIWA), 20, seed=85)
    q[:, 3] = 0.0
    psi = arm_angle(robot(IIWA), q)
    for joints, T, angle in zip(q, asked.poses(q), psi, strict=True):
        rows = solved(IIWA, T, angle)
        assert len(rows) == 4
        assert asked.apart(rows, joints).min() < 1e-6
        for other in (0.0, angle + 1.0, np.pi):
            rows = solved(IIWA, T, other)
            assert len(rows) == 4
            assert apart(arm_angle(robot(IIWA), rows), other) < 1e-6


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_nearly_stretched_arm_is_found_again(side: float) -> None:
    """Where its two elbows merge, and where it has a side, are two places; between, it was lost."""
    asked = trial(IIWA)
    for bent in np.concatenate([np.geomspace(1e-8, 1e-5, 61), np.linspace(3e-7, 6e-7, 101)]):
        q = random_joints(robot(IIWA), 5, seed=87)
        q[:, [1, 5]] = 0.3 + 0.5 * np.abs(q[:, [1, 5]])  # of other joints, none is singular
        q[:, 3] = side * bent
        psi = [library(IIWA).arm_angle(each) for each in q]
        for joints, T, angle in zip(q, asked.poses(q), psi, strict=True):
            assert asked.apart(solved(IIWA, T, angle), joints).min() < 2e-6
            values = np.array([angle])
            rows, status = short_module(IIWA).ik_all(T, values, joints)
            assert asked.apart(rows[np.isin(status, HELD)], joints).min() < 2e-6


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("off", [0.0, 1e-13, 1e-9, 1e-6])
def test_a_wrist_above_or_below_the_shoulder(side: float, off: float) -> None:
    """There the plane of axis 1 and the arm is lost; angles count from x of the base."""
    asked = trial(IIWA)
    T = asked.poses(random_joints(robot(IIWA), 1, seed=86))[0]
    T[:3, 3] = [off, 0.0, 0.36 + side * 0.6] + 0.126 * T[:3, 2]
    for psi in (0.0, 0.7, -np.pi / 2, np.pi):
        rows = solved(IIWA, T, psi)
        assert len(rows) == 8
        assert apart(arm_angle(robot(IIWA), rows), psi) < 1e-6
    if off == 0.0:
        elbow = elbow_of(robot(IIWA), T, 0.0)
        assert side * elbow[0] > 0.1
        assert abs(elbow[1]) < 1e-12


def test_an_arm_angle_that_is_no_number() -> None:
    T = trial(IIWA).poses(np.full((1, 7), 0.4))[0]
    for psi in (np.nan, np.inf):
        _, status = library(IIWA).ik(T, np.zeros(7), np.array([psi]))
        assert (status == Status.INVALID_POSE).all()
        _, status = short_module(IIWA).ik_all(T, np.array([psi]))
        assert (status == Status.INVALID_POSE).all()


def test_poses_out_of_reach_are_so_for_every_arm_angle() -> None:
    T = trial(IIWA).poses(np.full((1, 7), 0.4))[0]
    T[:3, 3] *= 3.0
    _, status = library(IIWA).ik(T, np.zeros(7), np.array([0.3]))
    assert (status == Status.UNREACHABLE).all()
