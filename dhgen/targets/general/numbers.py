"""Numbers as C writes them."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.kinematics.rigid import Matrix


def row(numbers: Iterable[float]) -> str:
    """Numbers between commas."""
    return ", ".join(map(repr, numbers))


def rows(matrix: Iterable[Iterable[float]]) -> tuple[str, ...]:
    """The rows of a matrix."""
    return tuple(map(row, matrix))


def rigid(K: Matrix) -> str:
    """The upper three rows of a rigid transform, one after another."""
    return row(x for each in K[:3] for x in each)
