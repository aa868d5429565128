"""Null spaces in plain floats: the same digits on every machine."""

from __future__ import annotations

from math import sqrt
from typing import TYPE_CHECKING

from dhgen.general.rigid import dot

if TYPE_CHECKING:
    from collections.abc import Sequence

# A column that is shorter than this after the ones before it counts as dependent on them.
DEPENDENT = 1e-11


def left_null_space(columns: Sequence[Sequence[float]], dimension: int) -> list[list[float]]:
    """Orthonormal rows that annihilate the columns.

    Args:
        columns: Vectors of n components each.
        dimension: How many rows are wanted, at most n minus the number of columns.

    Returns:
        The last `dimension` rows of Qᵀ of the columns' QR decomposition by reflections.
    """
    n = len(columns[0])
    work = [list(column) for column in columns]
    reflections: list[tuple[int, list[float]]] = []
    for i, column in enumerate(work):
        tail = column[i:]
        length = sqrt(dot(tail, tail))
        if length < DEPENDENT:
            continue
        tail[0] += length if tail[0] >= 0.0 else -length
        reflections.append((i, tail))
        for later in work[i + 1 :]:
            _reflect(later, i, tail)
    rows = []
    for i in range(n - dimension, n):
        row = [float(i == j) for j in range(n)]
        for start, tail in reversed(reflections):
            _reflect(row, start, tail)
        rows.append(row)
    return rows


def _reflect(vector: list[float], start: int, axis: Sequence[float]) -> None:
    """Reflect a vector's components from `start` on at the plane across an axis."""
    factor = 2.0 * dot(axis, vector[start:]) / dot(axis, axis)
    for i, x in enumerate(axis):
        vector[start + i] -= factor * x
