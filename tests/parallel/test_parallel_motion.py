"""The committed C of parallel robots: closure, both models along motions, singular poses."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.parallel.verify import moved_pose
from tests.parallel.made import NAMES, OK, compilation, drives, miss, mode, native, poses

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

FREE, UNREACHABLE, OUT, INVALID = 2, 1, 3, 4


@pytest.mark.parametrize("name", NAMES)
def test_every_row_closes_its_leg(name: str) -> None:
    for T in poses(name)[:30]:
        count, q, status = native(name).ik(T)
        assert count == np.prod([(told == OK).sum() for told in status])
        assert count >= 1
        reached = (status == OK) | (status == OUT)
        assert reached.any(axis=1).all()
        # of every leg each of its rows, the others in one that they have
        some = np.array([rows[has][0] for rows, has in zip(q, reached, strict=True)])
        for leg, row in np.argwhere(reached):
            own = some.copy()
            own[leg] = q[leg, row]
            assert miss(name, T, own) < 1e-12


def test_the_inverse_model_of_cylinders_has_one_answer() -> None:
    """Document 001: given the place and the turn of the platform, their lengths are determined."""
    feet = np.array([[0, 0], [1.2, 0], [0.5, 1.1]])
    points = np.array([[-0.2, -0.1], [0.25, -0.1], [0, 0.25]])
    for T in poses("parallel_3rpr"):
        count, _, _ = native("parallel_3rpr").ik(T)
        lengths = np.linalg.norm(points @ T[:2, :2].T + T[:2, 3] - feet, axis=1)
        assert count == 1
        found = drives("parallel_3rpr", mode("parallel_3rpr", T))
        np.testing.assert_allclose(found, lengths, rtol=0, atol=1e-15)


@pytest.mark.parametrize("name", NAMES)
def test_both_models_are_each_other_s_inverse_along_a_motion(name: str) -> None:
    """From one pose towards others, in small steps, as long as the mode is within limits."""
    module = compilation(name).module
    followed = 0
    for start in poses(name)[:6]:
        T, q = start, mode(name, start)
        for step in range(40):
            freedom = module.freedoms[step % len(module.freedoms)]
            goal = moved_pose(T, freedom, 0.004 * (module.size if freedom < 3 else 1.0))
            told, nearest = native(name).nearest(goal, q)
            if told != OK or min(native(name).singularities(goal, nearest)) < 0.02:
                break
            told, found, again = native(name).fk(drives(name, nearest), T)
            assert told == OK
            np.testing.assert_allclose(found, goal, rtol=0, atol=1e-9)
            np.testing.assert_allclose(np.cos(again - nearest), 1.0, rtol=0, atol=1e-12)
            T, q, followed = found, nearest, followed + 1
    assert followed > 60


def test_a_stretched_leg_takes_a_motion_away() -> None:
    """First kind: the crank and the rod of leg 1 in one line, the platform can't go further out."""
    T = np.eye(4)
    direction = np.array([np.cos(1.1), np.sin(1.1)])
    T[:2, 3] = [-0.1, 0] + 0.5 * direction
    count, q, status = native("five_bar").ik(T)
    assert count > 0
    held = np.array([rows[told == OK][0] for rows, told in zip(q, status, strict=True)])
    first, second = native("five_bar").singularities(T, held)
    assert first < 1e-7
    assert second > 0.01
    A, B = native("five_bar").velocities(T, held)
    np.testing.assert_allclose(np.abs(A[0]), np.abs(direction), rtol=0, atol=1e-7)
    assert abs(B[0, 0]) < 1e-7


def test_cylinders_that_point_at_one_point_let_the_platform_turn() -> None:
    """Second kind: a platform whose cylinders' lines meet in a point may turn about it."""
    name = "parallel_3rpr"
    feet = np.array([[0, 0], [1.2, 0], [0.5, 1.1]])
    points = np.array([[-0.2, -0.1], [0.25, -0.1], [0, 0.25]])

    def crossing(T: FloatArray) -> float:
        ends = points @ T[:2, :2].T + T[:2, 3]
        u = (ends - feet) / np.linalg.norm(ends - feet, axis=1)[:, None]
        rows = np.column_stack([u, feet[:, 0] * u[:, 1] - feet[:, 1] * u[:, 0]])
        return float(np.linalg.det(rows))

    def between(one: FloatArray, other: FloatArray, share: float) -> FloatArray:
        angles = [np.arctan2(T[1, 0], T[0, 0]) for T in (one, other)]
        angle = angles[0] + share * (angles[1] - angles[0])
        T = np.eye(4)
        T[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
        T[:2, 3] = one[:2, 3] + share * (other - one)[:2, 3]
        return T

    found = 0
    for one, other in zip(poses(name)[:40:2], poses(name)[1:40:2], strict=True):
        sign = crossing(one)
        if sign * crossing(other) > 0.0:
            continue
        low, high = 0.0, 1.0
        for _ in range(60):
            middle = 0.5 * (low + high)
            same = crossing(between(one, other, middle)) * sign > 0.0
            low, high = (middle, high) if same else (low, middle)
        T = between(one, other, low)
        if native(name).ik(T)[0] != 1:
            continue
        q = mode(name, T)
        first, second = native(name).singularities(T, q)
        assert second < 1e-12
        assert first > 0.1
        told, refined, _ = native(name).fk(drives(name, q), T)
        assert told == FREE
        np.testing.assert_allclose(refined, T, rtol=0, atol=1e-6)
        found += 1
    assert found >= 3


@pytest.mark.parametrize("name", NAMES)
def test_what_is_no_pose_is_refused(name: str) -> None:
    T = poses(name)[0].copy()
    T[0, 3] = np.nan
    count, q, status = native(name).ik(T)
    assert count == -INVALID
    assert (status == INVALID).all()
    assert np.isnan(q).all()
    told, found, _ = native(name).fk(np.ones(compilation(name).robot.drives), T)
    assert told == -INVALID
    assert np.isnan(found).all()


def test_a_direct_model_that_does_not_close_says_so() -> None:
    """Cylinders that are too short to meet the platform."""
    T = poses("parallel_3rpr")[0]
    told, found, _ = native("parallel_3rpr").fk(np.full(3, 0.05), T)
    assert told == -UNREACHABLE
    assert np.isnan(found).all()


@pytest.mark.parametrize("name", ["parallel_3rpr", "stewart"])
@pytest.mark.parametrize("drive", [1e160, 1.7e308])
def test_drives_at_which_numbers_overflow_have_no_pose(name: str, drive: float) -> None:
    T = poses(name)[0]
    own = drives(name, mode(name, T))
    for each in (np.full(len(own), drive), np.array([drive, *own[1:]])):
        told, found, q = native(name).fk(each, T)
        assert told == -UNREACHABLE
        assert np.isnan(found).all()
        assert np.isnan(q).all()


@pytest.mark.parametrize("name", NAMES)
def test_what_is_no_posture_has_no_velocities(name: str) -> None:
    T = poses(name)[0]
    q = mode(name, T)
    for place in np.ndindex(q.shape):
        none = q.copy()
        none[place] = np.nan
        assert np.isnan(native(name).singularities(T, none)).all()
        assert np.isnan(native(name).velocities(T, none)).all()
    tilted = T.copy()
    tilted[0, 3] = np.nan
    assert np.isnan(native(name).velocities(tilted, q)).all()
    assert np.isfinite(native(name).velocities(T, q)).all()
