"""What part of a plane a point of the arm reaches: a grid of joint values, laid over a raster.

A grid's cells are pairs of triangles in space, and every row of the raster cuts them in pieces of
lines, of which the least and the greatest r or x are known.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.figures.reach import Section

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.derivation.figures.reach import Reach
    from dhgen.kinematics.chain import ChainJoint

CELLS = 320  # of the longer side
FINE, COARSE, SLICES = (
    121,
    49,
    25,
)  # values of a joint: of two, of the first two of three, the third
ASIDE = 0.3819  # of a cell: borders that lie evenly do not pass through the middle of cells
SURE = 7  # decimals of a cell that rounding leaves right


@dataclass(frozen=True, slots=True)
class Raster:
    """What is reached.

    Attributes:
        held: Whether the middle of a cell is, by rows from the lowest, (rows, columns).
        origin: The middle of the first cell, (2,).
        cell: The side of a cell [length].
    """

    held: NDArray[np.bool_]
    origin: FloatArray
    cell: float

    def holds(self, points: FloatArray, within: int) -> NDArray[np.bool_]:
        """Whether points (N, 2) lie in cells that are reached, or so many cells beside one."""
        padded = np.pad(self.held, 2 * within + 1)
        column, row = np.rint((points - self.origin) / self.cell).astype(int).T + 2 * within + 1
        row, column = (
            np.clip(place, within, side - within - 1)
            for place, side in zip((row, column), padded.shape, strict=True)
        )
        beside = range(-within, within + 1)
        near = [padded[row + i, column + j] for i in beside for j in beside]
        return np.asarray(np.any(near, axis=0))


def reached(reach: Reach) -> Raster:
    """The raster of what a point reaches in its plane."""
    slices = [reach.points(q) for q in _grid(reach)]
    flat = reach.section is Section.ABOVE
    corners = [_flat(points) if flat else points for points in slices]
    ends = np.array([_ends(points, flat=flat) for points in corners])
    low, high = ends[:, 0].min(axis=0), ends[:, 1].max(axis=0)
    cell = float((high - low).max()) / CELLS or 1.0
    origin = low - cell * (2.0 + ASIDE)
    columns, rows = (math.ceil(side / cell) + 5 for side in high - low)
    counts = np.zeros((rows, columns + 1), np.int64)
    for points in corners:
        _count(counts, points, origin, cell, flat=flat)
    return Raster(np.asarray(counts.cumsum(axis=1)[:, :-1] > 0), origin, cell)


def _flat(points: FloatArray) -> FloatArray:
    """(x, y) as (x, 0, y)."""
    return np.stack([points[..., 0], np.zeros(points.shape[:-1]), points[..., 1]], axis=-1)


def _ends(points: FloatArray, *, flat: bool) -> tuple[FloatArray, FloatArray]:
    """The least and the greatest coordinates; r counts from the axis, also where none is near."""
    across = points[..., 0] if flat else np.hypot(points[..., 0], points[..., 1])
    both = np.stack([across, points[..., 2]], axis=-1).reshape(-1, 2)
    low = both.min(axis=0)
    return (low if flat else low * (0.0, 1.0)), both.max(axis=0)


def _grid(reach: Reach) -> list[FloatArray]:
    """Joint values on grids of two joints, one for each value of a third, (m, k, n) each."""
    chain = reach.arm.chain
    first, second, *third = (chain.joints[number - 1] for number in _spread(reach))
    count = COARSE if third else FINE
    q = np.zeros((count, count, chain.dof))
    q[..., first.number - 1] = _values(first, count, turns=chain.turning[first.number - 1])[:, None]
    q[..., second.number - 1] = _values(second, count, turns=chain.turning[second.number - 1])
    if not third:
        return [q]
    (last,) = third
    slices = []
    for value in _values(last, SLICES, turns=chain.turning[last.number - 1]):
        q = q.copy()
        q[..., last.number - 1] = value
        slices.append(q)
    return slices


def _spread(reach: Reach) -> tuple[int, ...]:
    """The joints, from 1: two that sweep areas of the plane, then the third."""
    orders = [(*pair, *sorted({*reach.movers} - {*pair})) for pair in combinations(reach.movers, 2)]
    return max(orders, key=lambda order: round(reach.swept(order[0], order[1]), SURE))


def _values(joint: ChainJoint, count: int, *, turns: bool) -> FloatArray:
    low, high = joint.limits or (-math.pi, math.pi)
    if turns and high - low > 2.0 * math.pi:
        low, high = -math.pi, math.pi
    return np.linspace(low, high, count)


def _count(
    counts: NDArray[np.int64], points: FloatArray, origin: FloatArray, cell: float, *, flat: bool
) -> None:
    """Adds the triangles of a grid of points (m, k, 3): +1 where a piece begins, -1 behind it."""
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[:-1, 1:], points[1:, 1:]
    corners = np.concatenate(
        [np.stack(each, axis=2).reshape(-1, 3, 3) for each in ((a, b, c), (d, b, c))]
    )
    heights = (corners[..., 2] - origin[1]) / cell
    order = np.argsort(heights, axis=1, kind="stable")
    corners = np.take_along_axis(corners, order[..., None], axis=1)
    heights = np.round(np.take_along_axis(heights, order, axis=1), SURE)
    first, last = np.ceil(heights[:, 0]).astype(int), np.floor(heights[:, 2]).astype(int)
    number = np.maximum(last - first + 1, 0)
    which = np.repeat(np.arange(len(number)), number)
    row = np.arange(len(which)) - np.repeat(np.cumsum(number) - number, number) + first[which]
    one, other = _cut(corners[which, :, :2], heights[which], row)
    low, high = _extremes(one, other, flat=flat)
    begin = np.ceil(np.round((low - origin[0]) / cell, SURE)).astype(int)
    end = np.floor(np.round((high - origin[0]) / cell, SURE)).astype(int) + 1
    some = end > begin
    np.add.at(counts, (row[some], begin[some]), 1)
    np.add.at(counts, (row[some], end[some]), -1)


def _cut(
    corners: FloatArray, heights: FloatArray, row: NDArray[np.int64]
) -> tuple[FloatArray, FloatArray]:
    """Where a row meets triangles (N, 3, 2) whose corners are ordered by height: two points."""

    def between(i: int, j: int) -> FloatArray:
        span = heights[:, j] - heights[:, i]
        t = (row - heights[:, i]) / np.where(span == 0.0, 1.0, span)
        return np.asarray(corners[:, i] + t[:, None] * (corners[:, j] - corners[:, i]))

    below = (row <= heights[:, 1]) & (heights[:, 1] > heights[:, 0])
    return between(0, 2), np.where(below[:, None], between(0, 1), between(1, 2))


def _extremes(one: FloatArray, other: FloatArray, *, flat: bool) -> tuple[FloatArray, FloatArray]:
    """The least and the greatest x, or distance from the axis, on the way between two points."""
    if flat:
        return np.minimum(one[:, 0], other[:, 0]), np.maximum(one[:, 0], other[:, 0])
    step = other - one
    square = (step * step).sum(axis=1)
    t = np.clip(-(one * step).sum(axis=1) / np.where(square == 0.0, 1.0, square), 0.0, 1.0)
    nearest = one + t[:, None] * step
    far = np.maximum(np.hypot(*one.T), np.hypot(*other.T))
    return np.hypot(*nearest.T), far
