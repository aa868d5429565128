"""The axes of an arm in its reference position (all joints zero), and common normals of lines."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.descriptions.rotations import (
    STILL,
    cross,
    dot,
    from_rpy,
    minus,
    placed,
    plus,
    times,
    turned,
    unit,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.descriptions.model import Joint, Vector
    from dhgen.descriptions.rotations import Placed


NO_LENGTH = 1e-6  # m


@dataclass(frozen=True, slots=True)
class Axis:
    """A joint's axis in the base link's frame.

    Attributes:
        joint: The joint.
        direction: Of length one.
        point: The origin of the joint's frame; a slide's line may be anywhere else.
        turns: Whether the joint rotates.
    """

    joint: Joint
    direction: Vector
    point: Vector
    turns: bool


@dataclass(frozen=True, slots=True)
class Arm:
    """Axes from base to tip, and the tip's frame, all joints zero.

    Attributes:
        axes: One for each joint that moves.
        tip: The tip link's frame in the base link's.
        size: Sum of the distances from joint to joint, to the tip; 1 without any [length].
        near: What is nearer to parallel or right counts as that [rad].
        little: A length that counts as zero.
    """

    axes: tuple[Axis, ...]
    tip: Placed
    size: float
    near: float
    little: float


def arm_of(joints: Sequence[Joint], near: float, little: float) -> Arm:
    """The arm of the joints from base to tip.

    Args:
        joints: Fixed ones too.
        near: See `Arm`.
        little: See `Arm`; in arm sizes.
    """
    frame: Placed = (STILL, (0.0, 0.0, 0.0))
    axes = []
    for joint in joints:
        frame = placed(frame, (from_rpy(joint.rpy), joint.xyz))
        if joint.motion.is_actuated:
            direction = turned(frame[0], unit(joint.axis))
            axes.append(Axis(joint, direction, frame[1], joint.motion.turns))
    size = size_of(joints)
    return Arm(tuple(axes), frame, size, near, little * size)


def size_of(joints: Sequence[Joint]) -> float:
    """How long an arm is, stretched from joint to joint; 1 where that is dirt on zeros."""
    size = math.fsum(math.hypot(*joint.xyz) for joint in joints[1:])
    return size if size > NO_LENGTH else 1.0


def across(direction: Vector, vector: Vector) -> Vector:
    """The part of a vector that is square to a direction."""
    return plus(vector, direction, -dot(vector, direction))


def foot_on(point: Vector, direction: Vector, other: Vector) -> Vector:
    """The point of a line that is nearest to another point."""
    return plus(point, direction, dot(minus(other, point), direction))


def are_parallel(one: Vector, other: Vector, near: float) -> bool:
    """Whether two unit vectors point along one line, either way."""
    return math.hypot(*cross(one, other)) < near


def common_normal(
    one: tuple[Vector, Vector], other: tuple[Vector, Vector]
) -> tuple[Vector, Vector, Vector]:
    """Direction, start and end of the common normal of two lines that are not parallel.

    Args:
        one: Point and direction of the line that it starts on.
        other: Of the line that it ends on.
    """
    (p, u), (r, v) = one, other
    normal, between = cross(u, v), minus(r, p)
    squared = dot(normal, normal)
    foot = plus(p, u, dot(cross(between, v), normal) / squared)
    landing = plus(r, v, dot(cross(between, u), normal) / squared)
    return times(normal, 1.0 / math.sqrt(squared)), foot, landing


def angle_about(axis: Vector, start: Vector, end: Vector) -> float:
    """The turn about an axis from one direction square to it to another [rad]."""
    return math.atan2(dot(cross(start, end), axis), dot(start, end))
