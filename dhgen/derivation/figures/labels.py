"""Letters beside what they name: off each other, off joints and, where there is room, off lines."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.derivation.figures.sheet import BELOW, HEIGHT, settled, width_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.derivation.figures.sheet import Box, Point, Sheet

TURNS = (0, 180, 30, -30, 60, -60, 150, -150, 100, -100)  # about a point, in degrees
FAR = {4.0: 0.0, 9.0: 1.5, 15.0: 6.0, 22.0: 13.5, 30.0: 36.0, 39.0: 46.0}
"""And how far from it [pixels], with what a place costs for that."""
ON_LETTERS, ON_BODY, ON_LINE = 60.0, 25.0, 9.0  # what it costs besides
ELSEWHERE = 26.0, 1.0  # and not beside the first of some points, and for each one more


def label(
    sheet: Sheet, at: Sequence[Point], text: str, kind: str, first: float, gap: float = 0.0
) -> None:
    """Letters near a point.

    Args:
        sheet: Where they are drawn.
        at: What they name: the point, and others that serve where there is no room beside it.
        text: The letters.
        kind: Their class.
        first: The direction in which they would best be, in degrees clockwise from the right.
        gap: How far from the point they are at least.
    """
    size = width_of(text), HEIGHT + BELOW
    best, least = None, math.inf
    for place, point in enumerate(at):
        away = ELSEWHERE[0] + place * ELSEWHERE[1] if place else 0.0
        for box, near in _places(point, size, first, gap):
            cost = _cost(sheet, box, near + away, least)
            if cost < least:
                best, least = box, cost
    assert best is not None
    left, _, _, bottom = best
    sheet.words((left, bottom - BELOW), text, kind)
    sheet.letters.append(best)


def _places(
    at: Point, size: tuple[float, float], first: float, gap: float
) -> Iterable[tuple[Box, float]]:
    """Boxes about a point with what they cost for being where they are."""
    wide, high = size[0] / 2.0, size[1] / 2.0
    for far, costs in FAR.items():
        for place, turn in enumerate(TURNS):
            angle = math.radians(first + turn)
            x = at[0] + math.cos(angle) * (gap + far + wide)
            y = at[1] + math.sin(angle) * (gap + far + high)
            box = x - wide, y - high, x + wide, y + high
            yield _settled(box), costs + 0.4 * place


def _settled(box: Box) -> Box:
    left, top, right, bottom = (settled(side) for side in box)
    return left, top, right, bottom


def _cost(sheet: Sheet, box: Box, near: float, enough: float) -> float:
    """What a place costs, or some cost that is no less than enough."""
    cost = near
    cost += ON_LETTERS * sum(_meet(box, other) for other in sheet.letters)
    cost += ON_BODY * sum(_meet(box, other) for other in sheet.boxes)
    if cost < enough:
        cost += ON_LINE * sum(_crosses(box, *line) for line in sheet.lines)
    return round(cost, 3)


def _meet(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def _crosses(box: Box, start: Point, end: Point, half: float) -> bool:
    """Whether a line goes through a box (Liang and Barsky)."""
    low, high = 0.0, 1.0
    box = box[0] - half, box[1] - half, box[2] + half, box[3] + half
    around = (
        min(start[0], end[0]),
        min(start[1], end[1]),
        max(start[0], end[0]),
        max(start[1], end[1]),
    )
    if around[0] > box[2] or around[1] > box[3] or around[2] < box[0] or around[3] < box[1]:
        return False
    for k in (0, 1):
        step = end[k] - start[k]
        ends = box[k] - start[k], box[k + 2] - start[k]
        if abs(step) < 1e-6:
            if ends[0] > 0.0 or ends[1] < 0.0:
                return False
            continue
        first, last = sorted((ends[0] / step, ends[1] / step))
        low, high = max(low, first), min(high, last)
    return low <= high
