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
# Values of a joint: of two joints, of the first two of three, of the third.
FINE, COARSE, SLICES = 121, 49, 25
ASIDE = 0.3819  # of a cell: borders that lie evenly do not pass through the middle of cells
SURE = 7  # decimals of a cell that rounding leaves right


@dataclass(frozen=True, slots=True)
class Raster:
    """What is reached.

    Attributes:
        held: Whether the middle of each cell is reached, by rows from the lowest, (rows, columns).
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
    corners = np.take_along_axis(corners[..., :2], order[..., None], axis=1)
    heights = np.round(np.take_along_axis(heights, order, axis=1), SURE)
    row, one, other = _cut(corners.transpose(1, 2, 0), heights.T)
    low, high = _extremes(one, other, flat=flat)
    begin = np.ceil(np.round((low - origin[0]) / cell, SURE)).astype(int)
    end = np.floor(np.round((high - origin[0]) / cell, SURE)).astype(int) + 1
    some = end > begin
    start = row[some] * counts.shape[1]  # of the row among all cells
    for place, sign in ((start + begin[some], 1), (start + end[some], -1)):
        counts += sign * np.bincount(place, minlength=counts.size).reshape(counts.shape)


def _cut(
    corners: FloatArray, heights: FloatArray
) -> tuple[NDArray[np.int64], FloatArray, FloatArray]:
    """Where rows meet triangles, (3, 2, N), of whose corners these are the heights, ascending.

    Returns:
        The row of each piece (M,), and the two points where it enters and leaves, (2, M) each.
    """
    first, last = np.ceil(heights[0]).astype(int), np.floor(heights[2]).astype(int)
    number = np.maximum(last - first + 1, 0)
    triangle = np.repeat(np.arange(len(number)), number)
    row = np.arange(len(triangle)) - np.repeat(np.cumsum(number) - number, number) + first[triangle]
    # the long side of every triangle, then the lower of the others, then the upper
    pairs = (0, 2), (0, 1), (1, 2)
    span = np.concatenate([heights[j] - heights[i] for i, j in pairs])
    along = np.concatenate([corners[j] - corners[i] for i, j in pairs], axis=1)
    slope = along / np.where(span == 0.0, 1.0, span)
    begin = np.concatenate([corners[i] for i, _ in pairs], axis=1)
    height = np.concatenate([heights[i] for i, _ in pairs])
    middle = heights[1, triangle]
    below = (row <= middle) & (middle > heights[0, triangle])
    sides = triangle, triangle + np.where(below, 1, 2) * len(number)
    one, other = (
        begin.take(side, axis=1) + (row - height[side]) * slope.take(side, axis=1) for side in sides
    )
    return row, one, other


def _extremes(one: FloatArray, other: FloatArray, *, flat: bool) -> tuple[FloatArray, FloatArray]:
    """The least and the greatest x, or distance from the axis, on the way between two points."""
    if flat:
        return np.minimum(one[0], other[0]), np.maximum(one[0], other[0])
    (x, y), (u, v) = one, other - one
    square = u * u + v * v
    t = np.clip(-(x * u + y * v) / np.where(square == 0.0, 1.0, square), 0.0, 1.0)
    near = np.sqrt((x + t * u) ** 2 + (y + t * v) ** 2)
    return near, np.sqrt(np.maximum(x * x + y * y, other[0] ** 2 + other[1] ** 2))
