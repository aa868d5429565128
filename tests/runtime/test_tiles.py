"""Many poses: what is told of those side by side is what is told of one, and all are solved."""

from __future__ import annotations

import math

import numpy as np
import pytest

from dhgen.runtime.python.pose import LAST_ROW, ORTHONORMAL, ROTATION
from tests.runtime.arms import called
from tests.runtime.plain import KINDS, part

WIDTH = 3
TASKS = ("pose", "orientation", "pointing", "pitch", "tilt", "position")


def some_pose(off: float) -> np.ndarray:
    """A pose whose rotation is too long by a part."""
    a, b = 0.7, -1.1
    about_z = np.array(
        [[math.cos(a), -math.sin(a), 0.0], [math.sin(a), math.cos(a), 0.0], [0, 0, 1]]
    )
    about_x = np.array(
        [[1, 0, 0], [0.0, math.cos(b), -math.sin(b)], [0.0, math.sin(b), math.cos(b)]]
    )
    T = np.eye(4)
    T[:3, :3] = (1.0 + off) * about_z @ about_x
    T[:3, 3] = 0.3, -0.2, 0.5
    return T


def miss_of(kind: str, task: str, T: np.ndarray) -> float:
    """What is said of a pose among others, which are no poses."""
    kept = np.full(WIDTH * 16, math.nan)
    kept[1::WIDTH] = T.reshape(16)
    return float(called(kind, "pose", f"miss_of_{task}")(kept, 1, WIDTH))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("task", TASKS)
def test_a_pose_among_others_is_judged_as_one_alone(task: str, kind: str) -> None:
    read = called(kind, "pose", f"read_{task}")
    for off in (0.0, 1e-14, 1e-11, 1e-7, 1e-5, 1e-3):
        T = some_pose(off)
        miss, (valid, rows) = miss_of(kind, task, T), read(T)
        assert valid == (miss <= ROTATION)
        assert (rows == tuple(T[:3].reshape(12))) == (miss <= ORTHONORMAL or not valid)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("over", [0.0, 1e-14, 1e-7, 1e-5, 1e-3, math.nan, math.inf])
@pytest.mark.parametrize("end", [1.0, -1.0])
def test_the_sine_of_a_pitch_is_one_at_most(end: float, over: float, kind: str) -> None:
    T = some_pose(0.0)
    T[2, 0] = end * (1.0 + over)
    miss, (valid, rows) = miss_of(kind, "pitch", T), called(kind, "pose", "read_pitch")(T)
    assert valid == (miss <= ROTATION) == (over < 1e-4)
    if valid:
        assert rows[8] == (T[2, 0] if miss <= ORTHONORMAL else end)


@pytest.mark.parametrize("kind", KINDS)
def test_a_yaw_is_told_by_any_length_but_none(kind: str) -> None:
    read, T = called(kind, "pose", "read_yaw"), some_pose(0.0)
    for x, y, made in (
        (3.0, -4.0, (0.6, -0.8)),
        (0.6, -0.8, (0.6, -0.8)),
        (2e-6, 0.0, (1.0, 0.0)),
        (0.0, -9e-7, (0.0, 0.0)),
    ):
        T[0, 0], T[1, 0] = x, y
        valid, rows = read(T)
        assert valid
        assert (rows[0], rows[4], rows[8]) == pytest.approx((*made, 0.0), abs=1e-15)
        assert miss_of(kind, "yaw", T) == 0.0
    for wrong in (math.nan, math.inf, 1e200):
        T[1, 0] = wrong
        assert not read(T)[0]
        assert math.isnan(miss_of(kind, "yaw", T))


@pytest.mark.parametrize("kind", KINDS)
def test_the_last_row_counts_where_all_of_a_pose_does(kind: str) -> None:
    T = some_pose(0.0)
    T[3, 1] = 2.0 * LAST_ROW
    assert miss_of(kind, "pose", T) == pytest.approx(2.0 * LAST_ROW)
    assert miss_of(kind, "orientation", T) <= ORTHONORMAL
    assert miss_of(kind, "pose", np.full((4, 4), math.nan)) != 0.0


@pytest.mark.parametrize("kind", KINDS)
def test_a_tile_is_two_of_the_widest_vectors(kind: str) -> None:
    """The formulas pad what one pose takes to vectors of eight; a tile needs no padding."""
    assert part(kind, "tiles").TILE % 8 == 0
