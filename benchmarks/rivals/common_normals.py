"""A standard Denavit-Hartenberg table from the axes of an arm, for rivals that take only that."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from benchmarks.screws import Screws
    from dhgen.arrays import FloatArray

PARALLEL = 1e-9

Link = tuple[float, float, float, float]  # theta, d, a, alpha


def standard_table(frame: Screws) -> tuple[FloatArray, list[Link], FloatArray]:
    """Base (4, 4), a row for every joint with theta at q = 0, and tool (4, 4).

    The frame before the first joint and the one after the last are laid so that nothing but the
    joint's own angle is left of these rows.
    """
    axes = list(zip(frame.directions, frame.points, strict=True))
    origin = frame.points[0]
    normals, feet, origins = [], [], []
    for (u, p), (v, q) in pairwise(axes):
        normal, foot, origin = _common_normal(u, p, v, q, origin)
        normals.append(normal)
        feet.append(foot)
        origins.append(origin)
    count = len(axes)
    x = [normals[0], *normals, normals[-1]]  # of the frames 0 to n
    o = [feet[0], *origins, origins[-1]]
    foot_of = [*feet, origins[-1]]
    z = [*frame.directions, frame.directions[-1]]
    rows = [
        (
            _angle(x[i], x[i + 1], z[i]),
            float((foot_of[i] - o[i]) @ z[i]),
            float((o[i + 1] - foot_of[i]) @ x[i + 1]),
            _angle(z[i], z[i + 1], x[i + 1]),
        )
        for i in range(count)
    ]
    last = _placed(x[-1], z[-1], o[-1])
    return _placed(x[0], z[0], o[0]), rows, np.asarray(np.linalg.inv(last) @ frame.home)


def _common_normal(
    u: FloatArray, p: FloatArray, v: FloatArray, q: FloatArray, near: FloatArray
) -> tuple[FloatArray, ...]:
    """Direction from axis p + s u to axis q + t v, and its feet on both."""
    cross, gap = np.cross(u, v), q - p
    if np.linalg.norm(cross) < PARALLEL:
        foot = p + ((near - p) @ u) * u
        across = (q - foot) - ((q - foot) @ u) * u
        length = np.linalg.norm(across)
        normal = across / length if length > PARALLEL else _perpendicular(u)
        return normal, foot, foot + across
    square = cross @ cross
    s, t = np.cross(gap, v) @ cross / square, np.cross(gap, u) @ cross / square
    return cross / np.sqrt(square), p + s * u, q + t * v


def _perpendicular(u: FloatArray) -> FloatArray:
    other = np.cross(u, np.eye(3)[np.argmin(np.abs(u))])
    return np.asarray(other / np.linalg.norm(other))


def _angle(start: FloatArray, end: FloatArray, about: FloatArray) -> float:
    return float(np.arctan2(np.cross(start, end) @ about, start @ end))


def _placed(x: FloatArray, z: FloatArray, origin: FloatArray) -> FloatArray:
    T = np.eye(4)
    T[:3, 0], T[:3, 1], T[:3, 2], T[:3, 3] = x, np.cross(z, x), z, origin
    return T
