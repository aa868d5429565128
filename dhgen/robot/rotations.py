"""Rotation matrices as nine expressions, row by row, from roll-pitch-yaw and from quaternions."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.robot.angles import cosine, sine
from dhgen.robot.expression import ONE, ZERO, Expression
from dhgen.robot.simplify import add, multiply, negate, number, subtract

if TYPE_CHECKING:
    from collections.abc import Sequence
    from fractions import Fraction

Rows = tuple[tuple[float, float, float], tuple[float, float, float], tuple[float, float, float]]

IDENTITY: tuple[Expression, ...] = (ONE, ZERO, ZERO, ZERO, ONE, ZERO, ZERO, ZERO, ONE)


def from_rpy(angles: Sequence[Expression], values: Sequence[float]) -> tuple[Expression, ...]:
    """R = Rz(yaw) Ry(pitch) Rx(roll), rotations about fixed axes as in URDF.

    Args:
        angles: Roll, pitch, yaw in radians.
        values: The same as floats.
    """
    cr, cp, cy = (cosine(angle, value) for angle, value in zip(angles, values, strict=True))
    sr, sp, sy = (sine(angle, value) for angle, value in zip(angles, values, strict=True))
    return (
        multiply(cy, cp),
        subtract(multiply(multiply(cy, sp), sr), multiply(sy, cr)),
        add(multiply(multiply(cy, sp), cr), multiply(sy, sr)),
        multiply(sy, cp),
        add(multiply(multiply(sy, sp), sr), multiply(cy, cr)),
        subtract(multiply(multiply(sy, sp), cr), multiply(cy, sr)),
        negate(sp),
        multiply(cp, sr),
        multiply(cp, cr),
    )


def from_quaternion(x: Fraction, y: Fraction, z: Fraction, w: Fraction) -> tuple[Fraction, ...]:
    """The rotation of a quaternion of any length but zero.

    Dividing by the squared norm instead of normalising needs no square root: the matrix of a
    rational quaternion is rational, and exactly orthonormal.
    """
    n = x * x + y * y + z * z + w * w
    return (
        1 - 2 * (y * y + z * z) / n,
        2 * (x * y - z * w) / n,
        2 * (x * z + y * w) / n,
        2 * (x * y + z * w) / n,
        1 - 2 * (x * x + z * z) / n,
        2 * (y * z - x * w) / n,
        2 * (x * z - y * w) / n,
        2 * (y * z + x * w) / n,
        1 - 2 * (x * x + y * y) / n,
    )


def to_quaternion(rows: Rows) -> tuple[float, float, float, float]:
    """The quaternion x, y, z, w of a rotation, by its largest component (Shepperd 1978)."""
    (a, b, c), (d, e, f), (g, h, i) = rows
    squares = (1 + a - e - i, 1 - a + e - i, 1 - a - e + i, 1 + a + e + i)
    largest = max(range(4), key=lambda k: squares[k])
    candidates = (
        (squares[0], b + d, c + g, h - f),
        (b + d, squares[1], f + h, c - g),
        (c + g, f + h, squares[2], d - b),
        (h - f, c - g, d - b, squares[3]),
    )
    x, y, z, w = candidates[largest]
    norm = math.sqrt(x * x + y * y + z * z + w * w)
    return x / norm, y / norm, z / norm, w / norm


def nearest_rotation(rows: Rows) -> Rows:
    """The rotation nearest to a nearly orthonormal matrix: Newton's iteration for its polar factor.

    X becomes (X + X^-T)/2 (Higham 1986); three steps take an error of 1e-6 below rounding.
    """
    x = rows
    for _ in range(4):
        cofactors = _cofactors(x)
        size = dot(x[0], cofactors[0])
        r0, r1, r2 = (
            tuple((p + q / size) / 2 for p, q in zip(row, minors, strict=True))
            for row, minors in zip(x, cofactors, strict=True)
        )
        x = ((r0[0], r0[1], r0[2]), (r1[0], r1[1], r1[2]), (r2[0], r2[1], r2[2]))
    return x


def dot(a: Sequence[float], b: Sequence[float]) -> float:
    """The inner product."""
    return sum(p * q for p, q in zip(a, b, strict=True))


def determinant(rows: Rows) -> float:
    """The determinant; +1 for a rotation, -1 for a mirror."""
    return dot(rows[0], _cofactors(rows)[0])


def _cofactors(rows: Rows) -> Rows:
    (a, b, c), (d, e, f), (g, h, i) = rows
    return (
        (e * i - f * h, f * g - d * i, d * h - e * g),
        (c * h - b * i, a * i - c * g, b * g - a * h),
        (b * f - c * e, c * d - a * f, a * e - b * d),
    )


def numbers(values: Sequence[Fraction]) -> tuple[Expression, ...]:
    """Fractions as expressions."""
    return tuple(number(value) for value in values)
