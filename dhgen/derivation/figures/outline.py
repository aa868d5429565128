"""The border of what a raster holds, as closed lines with few corners."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray

NEAR = 0.35  # cells: how far a line may pass from the corners that it leaves out
LEAST = 12  # cells around: smaller ones are grains of the grid
# from the middle of one side of a square of four cells to that of another, what is held on the left
_SOUTH, _EAST, _NORTH, _WEST = (0.0, -0.5), (0.5, 0.0), (0.0, 0.5), (-0.5, 0.0)
_TURNS = {
    # corners that are held: 1 lower left, 2 lower right, 4 upper right, 8 upper left
    1: ((_SOUTH, _WEST),),
    2: ((_EAST, _SOUTH),),
    3: ((_EAST, _WEST),),
    4: ((_NORTH, _EAST),),
    5: ((_SOUTH, _WEST), (_NORTH, _EAST)),
    6: ((_NORTH, _SOUTH),),
    7: ((_NORTH, _WEST),),
    8: ((_WEST, _NORTH),),
    9: ((_SOUTH, _NORTH),),
    10: ((_EAST, _SOUTH), (_WEST, _NORTH)),
    11: ((_EAST, _NORTH),),
    12: ((_WEST, _EAST),),
    13: ((_SOUTH, _EAST),),
    14: ((_WEST, _SOUTH),),
}


def outlines(held: NDArray[np.bool_]) -> list[FloatArray]:
    """Closed lines (k, 2) in cells, columns and rows, around all that is held and its holes."""
    return [_simple(_smooth(line)) for line in _lines(held) if len(line) >= LEAST]


def _lines(held: NDArray[np.bool_]) -> list[FloatArray]:
    """The lines between cells that are held and such that are not."""
    padded = np.pad(held, 1).astype(int)
    codes = padded[:-1, :-1] + 2 * padded[:-1, 1:] + 4 * padded[1:, 1:] + 8 * padded[1:, :-1]
    following = {}
    for row, column in np.argwhere((codes > 0) & (codes < 15)):
        x, y = float(column) - 0.5, float(row) - 0.5
        for (sx, sy), (ex, ey) in _TURNS[int(codes[row, column])]:
            following[x + sx, y + sy] = (x + ex, y + ey)
    found = []
    while following:
        start = at = next(iter(following))
        line = []
        while at in following:
            line.append(at)
            at = following.pop(at)
        assert at == start, "borders are closed"
        found.append(np.array(line))
    return found


def _smooth(line: FloatArray) -> FloatArray:
    """Every corner between its neighbours: the raster's steps are gone."""
    for _ in range(2):
        line = (np.roll(line, 1, axis=0) + 2.0 * line + np.roll(line, -1, axis=0)) / 4.0
    return line


def _simple(line: FloatArray) -> FloatArray:
    """Without corners that lie next to the line through others (Douglas and Peucker)."""
    far = int(np.argmax(np.round(np.linalg.norm(line - line[0], axis=1), 6)))
    closed = np.vstack([line, line[:1]])
    kept = {0, far}
    open_ends = [(0, far), (far, len(line))]
    while open_ends:
        first, last = open_ends.pop()
        step = closed[last] - closed[first]
        length = float(np.hypot(*step)) or 1.0
        between = closed[first + 1 : last] - closed[first]
        off = np.round(np.abs(between[:, 0] * step[1] - between[:, 1] * step[0]) / length, 6)
        if len(off) and off.max() > NEAR:
            middle = first + 1 + int(np.argmax(off))
            kept.add(middle)
            open_ends += [(first, middle), (middle, last)]
    return np.asarray(line[sorted(kept - {len(line)})])
