"""Rotations and vectors of three in plain numbers; right angles have exact cosines and sines."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.descriptions.model import Vector

    Rotation = tuple[Vector, Vector, Vector]  # row by row
    Placed = tuple[Rotation, Vector]  # a frame: its rotation and its origin

STILL: Rotation = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
_NOTHING = 1e-15  # what the sine of the nearest double to pi is not zero by, and less


def dot(a: Vector, b: Vector) -> float:
    """The inner product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """The vector product."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def plus(a: Vector, b: Vector, factor: float = 1.0) -> Vector:
    """A vector and a multiple of another one."""
    return a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]


def minus(a: Vector, b: Vector) -> Vector:
    """From b to a."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def times(a: Vector, factor: float) -> Vector:
    """A multiple of a vector."""
    return a[0] * factor, a[1] * factor, a[2] * factor


def unit(a: Vector) -> Vector:
    """The direction of a vector; one along an axis is exactly that."""
    size = math.hypot(*a)
    return a[0] / size, a[1] / size, a[2] / size


def turned(R: Rotation, a: Vector) -> Vector:
    """R a."""
    return dot(R[0], a), dot(R[1], a), dot(R[2], a)


def transposed(R: Rotation) -> Rotation:
    """The inverse of a rotation."""
    a, b, c = zip(*R, strict=True)
    return a, b, c


def product(one: Rotation, other: Rotation) -> Rotation:
    """Two rotations one after the other."""
    columns = transposed(other)
    a, b, c = ((dot(row, columns[0]), dot(row, columns[1]), dot(row, columns[2])) for row in one)
    return a, b, c


def placed(frame: Placed, inner: Placed) -> Placed:
    """A frame that is given in another one."""
    (R, p), (S, t) = frame, inner
    return product(R, S), plus(p, turned(R, t))


def inverse(frame: Placed) -> Placed:
    """The frame that undoes one."""
    R = transposed(frame[0])
    return R, times(turned(R, frame[1]), -1.0)


def cosine_sine(angle: float) -> tuple[float, float]:
    """Exact where the angle is a double next to a multiple of a right one."""
    c, s = math.cos(angle), math.sin(angle)
    if abs(c) < _NOTHING:
        return 0.0, math.copysign(1.0, s)
    if abs(s) < _NOTHING:
        return math.copysign(1.0, c), 0.0
    return c, s


def from_rpy(rpy: Vector) -> Rotation:
    """Rz(yaw) Ry(pitch) Rx(roll)."""
    (cr, sr), (cp, sp), (cy, sy) = map(cosine_sine, rpy)
    return (
        (cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr),
        (sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr),
        (-sp, cp * sr, cp * cr),
    )


def from_quaternion(quaternion: Sequence[float]) -> Rotation:
    """The rotation of a unit quaternion w x y z."""
    w, x, y, z = map(float, quaternion)
    return (
        (1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w), 2.0 * (x * z + y * w)),
        (2.0 * (x * y + z * w), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w)),
        (2.0 * (x * z - y * w), 2.0 * (y * z + x * w), 1.0 - 2.0 * (x * x + y * y)),
    )


def to_rpy(R: Rotation) -> Vector:
    """Roll, pitch and yaw; no yaw where the pitch is right and one of both is free."""
    level = math.hypot(R[0][0], R[1][0])
    pitch = math.atan2(-R[2][0], level)
    if level < 1e-9:
        return math.atan2(math.copysign(1.0, -R[2][0]) * R[0][1], R[1][1]), pitch, 0.0
    return math.atan2(R[2][1], R[2][2]), pitch, math.atan2(R[1][0], R[0][0])


def about(axis: Vector, angle: float) -> Rotation:
    """The turn about a unit vector (Rodrigues)."""
    c, s = cosine_sine(angle)
    x, y, z = axis
    v = 1.0 - c
    return (
        (c + x * x * v, x * y * v - z * s, x * z * v + y * s),
        (y * x * v + z * s, c + y * y * v, y * z * v - x * s),
        (z * x * v - y * s, z * y * v + x * s, c + z * z * v),
    )
