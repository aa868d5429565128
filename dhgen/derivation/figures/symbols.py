"""Cylinders, boxes, arrows, frames and the ground, in parallel projection."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.figures.places import HALF, RADIUS
from dhgen.derivation.figures.sheet import number, path, settled

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.derivation.figures.sheet import Point, Sheet
    from dhgen.derivation.figures.view import View

FLAT = 0.02  # the part of an axis that is seen, below which it points at the reader
HEAD = 7.0  # of an arrow [pixels]
ARC = 14.0  # radius of the arrow about an axis
GROUND = 26.0  # half the side of the ground


def cylinder(sheet: Sheet, view: View, at: FloatArray, z: FloatArray) -> None:
    """A joint that turns."""
    if view.depth(z) < 0.0:
        z = -z
    near, far = view.point(at + HALF * z), view.point(at - HALF * z)
    deep = number(RADIUS * view.depth(z))
    dx, dy = near[0] - far[0], near[1] - far[1]
    seen = math.hypot(dx, dy)
    if seen > 2.0 * HALF * FLAT:
        across = (-dy / seen * RADIUS, dx / seen * RADIUS)
        slant = number(math.degrees(math.atan2(across[1], across[0])))
    else:
        across, slant = (RADIUS, 0.0), "0"
    ends = [_moved(p, across, k) for p, k in ((near, 1), (far, 1), (far, -1), (near, -1))]
    texts = [f"{number(x)} {number(y)}" for x, y in ends]
    arc = f"A{number(RADIUS)} {deep} {slant} 0"
    side = f"M{texts[0]}L{texts[1]}{arc} 1 {texts[2]}L{texts[3]}"
    cap = f"M{texts[0]}{arc} 1 {texts[3]}{arc} 1 {texts[0]}"
    sheet.area(f"{side}{arc} 0 {texts[0]}Z{cap}Z", _round(view, at), "body")
    _take(sheet, view, at, z)


def box(sheet: Sheet, view: View, at: FloatArray, z: FloatArray, x: FloatArray) -> None:
    """A joint that slides."""
    sides = (RADIUS * x, RADIUS * np.cross(z, x), 1.3 * HALF * z)
    faces = []
    for k, side in enumerate(sides):
        if abs(view.depth(side)) < FLAT * RADIUS:
            continue
        middle = at + side * math.copysign(1.0, view.depth(side))
        one, other = sides[(k + 1) % 3], sides[(k + 2) % 3]
        corners = [middle + i * one + j * other for i, j in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
        faces.append([view.point(corner) for corner in corners])
    data = "".join(path(face) + "Z" for face in faces)
    sheet.area(data, [point for face in faces for point in face], "body")
    _take(sheet, view, at, z)


def arrow(sheet: Sheet, start: Point, end: Point, kind: str) -> None:
    """A line with a head."""
    sheet.line([start, end], kind)
    angle = math.atan2(end[1] - start[1], end[0] - start[0])
    wings = [
        (end[0] - HEAD * math.cos(angle + turn), end[1] - HEAD * math.sin(angle + turn))
        for turn in (0.4, -0.4)
    ]
    sheet.area(path([wings[0], end, wings[1]]), [end], kind)


def turning(sheet: Sheet, view: View, at: FloatArray, z: FloatArray, x: FloatArray) -> None:
    """An arrow about an axis, in the sense in which its angle grows."""
    y = np.cross(z, x)
    angles = [math.radians(20.0 * k) for k in range(-7, 9)]
    points = [view.point(at + ARC * (math.cos(a) * x + math.sin(a) * y)) for a in angles]
    sheet.area(path(points), points, "z")
    start, end = points[-3], points[-1]
    angle = math.atan2(end[1] - start[1], end[0] - start[0])
    wings = [
        (end[0] - 5.0 * math.cos(angle + turn), end[1] - 5.0 * math.sin(angle + turn))
        for turn in (0.5, -0.5)
    ]
    sheet.area(path([wings[0], end, wings[1]]), points, "z")
    sheet.bar(points[::5])


def ground(sheet: Sheet, view: View, frame: FloatArray) -> None:
    """The ground below the base: a square across the z axis of its frame, hatched."""
    at, x, y = frame[:3, 3], GROUND * frame[:3, 0], GROUND * frame[:3, 1]
    corners = [view.point(at + i * x + j * y) for i, j in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
    data = path(corners) + "Z"
    for c in (-1.2, -0.6, 0.0, 0.6, 1.2):
        low, high = max(-1.0, -1.0 - c), min(1.0, 1.0 - c)
        data += path([view.point(at + i * x + (i + c) * y) for i in (low, high)])
    sheet.area(data, corners, "ink", is_faint=True)
    sheet.bar([*corners, corners[0]])


def _moved(point: Point, by: Point, times: int) -> Point:
    return point[0] + times * by[0], point[1] + times * by[1]


def _round(view: View, at: FloatArray) -> list[Point]:
    x, y = view.point(at)
    far = HALF + RADIUS
    return [(x - far, y - far), (x + far, y + far)]


def _take(sheet: Sheet, view: View, at: FloatArray, z: FloatArray) -> None:
    """Letters keep off a joint's body."""
    x, y = view.point(at)
    shown = view.point(z)
    wide = settled(RADIUS + (HALF - RADIUS + 2.0) * abs(shown[0]))
    high = settled(RADIUS + (HALF - RADIUS + 2.0) * abs(shown[1]))
    sheet.take((x - wide, y - high, x + wide, y + high))
