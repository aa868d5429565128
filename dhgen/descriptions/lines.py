"""The axes of an arm in its reference position (all joints zero), and common normals of lines."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
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
LEAST, NOTHING = 1e-9, 1e-12  # [rad, m] what rounding leaves of one line


@dataclass(frozen=True, slots=True)
class Axis:
    """A joint's axis in the base link's frame.

    Attributes:
        joint: The joint.
        direction: Of length one.
        point: The origin of the joint's frame; a slide's line may be anywhere else.
        turns: Whether the joint rotates.
        shares: Names of joints that it follows, and how often; a driven one besides its own value.
        offset: What is added to that [rad or length].
    """

    joint: Joint
    direction: Vector
    point: Vector
    turns: bool
    shares: tuple[tuple[str, float], ...] = ()
    offset: float = 0.0

    @property
    def totals(self) -> dict[str, float]:
        """The shares added up: of joints on one line several may follow the same one."""
        found: dict[str, float] = {}
        for name, factor in self.shares:
            found[name] = found.get(name, 0.0) + factor
        return found


@dataclass(frozen=True, slots=True)
class Arm:
    """Axes from base to tip, and the tip's frame, all joints zero.

    Attributes:
        axes: One for each joint that moves, but for those that follow others about, or along, the
            axis of their neighbour.
        tip: The tip link's frame in the base link's.
        size: Sum of the distances from joint to joint, to the tip; 1 without any [length].
        near: What is nearer to parallel or right counts as that [rad].
        negligible: A length that counts as zero.
    """

    axes: tuple[Axis, ...]
    tip: Placed
    size: float
    near: float
    negligible: float


def arm_of(joints: Sequence[Joint], near: float, negligible: float) -> Arm:
    """The arm of the joints from base to tip.

    Args:
        joints: Fixed ones too.
        near: See `Arm`.
        negligible: See `Arm`; in arm sizes.
    """
    frame: Placed = (STILL, (0.0, 0.0, 0.0))
    axes = []
    for joint in joints:
        frame = placed(frame, (from_rpy(joint.rpy), joint.xyz))
        if joint.motion.is_actuated:
            direction = turned(frame[0], unit(joint.axis))
            axes.append(_axis(joint, direction, frame[1]))
    size = size_of(joints)
    return Arm(
        _merged(axes, max(near, LEAST), negligible * size), frame, size, near, negligible * size
    )


def _axis(joint: Joint, direction: Vector, point: Vector) -> Axis:
    axis = Axis(joint, direction, point, joint.motion.turns)
    if joint.mimics is None:
        return axis
    share = joint.mimics.joint, joint.mimics.multiplier
    return replace(axis, shares=(share,), offset=joint.mimics.offset)


def _merged(axes: Sequence[Axis], near: float, negligible: float) -> tuple[Axis, ...]:
    """Axes, merged where one follows others and its neighbour is on its line."""
    found: list[Axis] = []
    for axis in axes:
        before = found[-1] if found else None
        if (
            before is None
            or (before.joint.is_driven and axis.joint.is_driven)
            or _follows(before, axis)
            or _follows(axis, before)
            or not _is_same_line(before, axis, near, negligible)
        ):
            found.append(axis)
        else:
            kept, other = (before, axis) if before.joint.is_driven else (axis, before)
            sign = 1.0 if dot(kept.direction, other.direction) > 0.0 else -1.0
            shares = tuple((name, sign * times) for name, times in other.shares)
            found[-1] = replace(
                kept, shares=(*kept.shares, *shares), offset=kept.offset + sign * other.offset
            )
    return tuple(found)


def _follows(one: Axis, other: Axis) -> bool:
    """Whether a joint follows another one: in that one's own row the drive would count twice."""
    return any(name == other.joint.name for name, _ in one.shares)


def _is_same_line(one: Axis, other: Axis, near: float, negligible: float) -> bool:
    """Whether two joints turn about one line, or slide in one direction."""
    if one.turns is not other.turns or not are_parallel(one.direction, other.direction, near):
        return False
    apart = across(one.direction, minus(other.point, one.point))
    return not one.turns or math.hypot(*apart) <= max(negligible, NOTHING)


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
