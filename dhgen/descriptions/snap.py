"""Numbers of a description that are nearly right: angles, directions, lengths of nearly zero."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.descriptions.lines import size_of
from dhgen.descriptions.rotations import unit
from dhgen.robot.angles import SNAP

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.descriptions.model import Joint, Vector

# What 1.5708 and 3.1416 are off by is 4e-6 and 7e-6; a calibration moves angles by 1e-4 and more.
DEFAULT = 1e-5  # [rad]
NEGLIGIBLE = 1e-7  # [arm sizes] what programs leave of a zero; a calibration has micrometres
LEAST = SNAP  # what robot files take as exact anyway
MOST = 1e-2
_TWELFTH = math.pi / 12
NOTHING = 1e-13  # [rad, m] what is not worth a word


@dataclass(frozen=True, slots=True)
class Snapped:
    """Joints with exact numbers in place of nearly exact ones.

    Attributes:
        joints: From base to tip.
        angles: The angles that were replaced, as they were, each once.
        lengths: The lengths that were taken as zero, each once.
    """

    joints: tuple[Joint, ...]
    angles: tuple[float, ...]
    lengths: tuple[float, ...]


def snap(joints: Sequence[Joint], near: float, negligible: float) -> Snapped:
    """Replaces what is nearer to an exact value than a tolerance.

    Args:
        joints: From base to tip.
        near: The tolerance of angles [rad].
        negligible: That of lengths [arm sizes].
    """
    least = negligible * size_of(joints)
    angles: dict[float, None] = {}
    lengths: dict[float, None] = {}
    exact = []
    for joint in joints:
        rpy = _each(joint.rpy, lambda angle: _angle(angle, near, angles))
        xyz = _each(joint.xyz, lambda length: _length(length, least, lengths))
        axis = _direction(joint.axis, near) if joint.motion.is_actuated else joint.axis
        exact.append(replace(joint, rpy=rpy, xyz=xyz, axis=axis))
    return Snapped(tuple(exact), tuple(angles), tuple(lengths))


def _each(vector: Vector, change: object) -> Vector:
    assert callable(change)
    x, y, z = map(change, vector)
    return x, y, z


def _angle(angle: float, near: float, replaced: dict[float, None]) -> float:
    nearest = round(angle / _TWELFTH) * _TWELFTH
    off = abs(angle - nearest)
    if off > near:
        return angle
    if off > NOTHING * max(1.0, abs(angle)):
        replaced[angle] = None
    return nearest


def _length(length: float, negligible: float, replaced: dict[float, None]) -> float:
    if abs(length) > negligible:
        return length
    if abs(length) > NOTHING:
        replaced[length] = None
    return 0.0


def _direction(axis: Vector, near: float) -> Vector:
    direction = unit(axis)
    return unit(_each(direction, lambda part: 0.0 if abs(part) <= near else part))
