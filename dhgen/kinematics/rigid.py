"""Rigid transforms as nested tuples of floats, with a fixed order of every sum.

Everything the compiler prints must come out the same on every machine; array libraries leave the
order of a sum to the processor, plain floats don't.
"""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

Vector = tuple[float, ...]
Matrix = tuple[Vector, ...]

IDENTITY: Matrix = tuple(tuple(float(i == j) for j in range(4)) for i in range(4))


def dot(a: Sequence[float], b: Sequence[float]) -> float:
    """The sum of products, from the first to the last."""
    total = 0.0
    for x, y in zip(a, b, strict=True):
        total += x * y
    return total


def multiply(A: Matrix, B: Matrix) -> Matrix:
    """The matrix product."""
    columns = tuple(zip(*B, strict=True))
    return tuple(tuple(dot(row, column) for column in columns) for row in A)


def inverse(A: Matrix) -> Matrix:
    """The inverse of a rigid transform (4, 4)."""
    columns = [[A[i][j] for i in range(3)] for j in range(4)]
    rows = [(*columns[j], -dot(columns[j], columns[3])) for j in range(3)]
    return (*rows, (0.0, 0.0, 0.0, 1.0))


def along_z(length: float) -> Matrix:
    """A translation along z."""
    return (*IDENTITY[:2], (0.0, 0.0, 1.0, length), IDENTITY[3])


def turn(c: float, s: float) -> Matrix:
    """A rotation about z by the angle with this cosine and sine."""
    return ((c, -s, 0.0, 0.0), (s, c, 0.0, 0.0), *IDENTITY[2:])


def scaled(A: Matrix, factor: float) -> Matrix:
    """A rigid transform with its translation multiplied by a factor."""
    return tuple((*row[:3], row[3] * (factor if i < 3 else 1.0)) for i, row in enumerate(A))


def orthonormal(A: Matrix) -> Matrix:
    """The transform with its rotation's columns made orthonormal, the third one first."""
    x, _, z, p = ([A[i][j] for i in range(3)] for j in range(4))
    z = _unit(z)
    along = dot(x, z)
    x = _unit([a - along * b for a, b in zip(x, z, strict=True)])
    y = cross(z, x)
    return (*((x[i], y[i], z[i], p[i]) for i in range(3)), (0.0, 0.0, 0.0, 1.0))


def cross(a: Sequence[float], b: Sequence[float]) -> Vector:
    """The vector product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _unit(v: Sequence[float]) -> list[float]:
    length = sqrt(dot(v, v))
    return [x / length for x in v]
