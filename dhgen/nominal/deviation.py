"""By how much two arms differ at most, at any joint values."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray


@dataclass(frozen=True, slots=True)
class Deviation:
    """What the tool of an arm may be away from where that of another arm is.

    Attributes:
        angle: The most that it is turned [rad].
        length: The most that its origin is moved.
    """

    angle: float
    length: float


def most_deviation(
    arm: tuple[FloatArray, FloatArray, FloatArray],
    other: tuple[FloatArray, FloatArray, FloatArray],
) -> Deviation:
    """A bound for all joint values.

    Where a frame is on its axis, and how it is turned about it, is free: each axis of the other arm
    has its frame as near as can be to that of the arm. The arms then are C0 J(q1) C1 ... J(q6) C6,
    and what each pair of constants differs by adds up, a rotation at the length of what is behind.

    Args:
        arm: Directions (6, 3) and points (6, 3) of the axes, and the tool's pose (4, 4), all angles
            zero.
        other: The same of the other arm.
    """
    ours = _frames(arm[0], arm[1], np.roll(arm[0], 1, axis=0))
    nearest = _projected(ours, *other[:2])
    one, two = _constants(ours, arm[2]), _constants(nearest, other[2])
    angle = length = behind = 0.0
    for C, D in reversed(list(zip(one, two, strict=True))):
        turned = _angle_between(C[:3, :3], D[:3, :3])
        length += turned * behind + float(np.linalg.norm(C[:3, 3] - D[:3, 3]))
        behind += float(np.linalg.norm(D[:3, 3]))
        angle += turned
    return Deviation(angle, length)


def _frames(directions: FloatArray, points: FloatArray, beside: FloatArray) -> list[FloatArray]:
    """A frame on every axis, whose z it is; x is across another direction, or any."""
    return [
        _frame(z, _across(z, other), p)
        for z, p, other in zip(directions, points, beside, strict=True)
    ]


def _across(z: FloatArray, other: FloatArray) -> FloatArray:
    x = np.cross(other, z)
    if np.linalg.norm(x) > 0.5:
        return x
    return np.cross(np.eye(3)[int(np.argmin(np.abs(z)))], z)


def _projected(
    frames: list[FloatArray], directions: FloatArray, points: FloatArray
) -> list[FloatArray]:
    """The frames on other axes that are nearest to these."""
    found = []
    for frame, z, p in zip(frames, directions, points, strict=True):
        x, o = frame[:3, 0], frame[:3, 3]
        found.append(_frame(z, x - (x @ z) * z, p + ((o - p) @ z) * z))
    return found


def _frame(z: FloatArray, x: FloatArray, origin: FloatArray) -> FloatArray:
    x = x / np.linalg.norm(x)
    frame = np.eye(4)
    frame[:3, 0], frame[:3, 1], frame[:3, 2], frame[:3, 3] = x, np.cross(z, x), z, origin
    return frame


def _constants(frames: list[FloatArray], tool: FloatArray) -> list[FloatArray]:
    """C0 ... C6 from one frame to the next."""
    ends = [np.eye(4), *frames, tool]
    return [np.linalg.inv(A) @ B for A, B in pairwise(ends)]


def _angle_between(R: FloatArray, S: FloatArray) -> float:
    """The angle of the rotation between two; by its chord, which has all digits of a small one."""
    chord = float(np.linalg.norm(R - S)) / np.sqrt(2.0)
    return float(2.0 * np.arcsin(min(0.5 * chord, 1.0)))
