"""The axes of an arm of six turning joints as lines, and the feet of their common normals."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.descriptions.misses import TILT

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray


@dataclass(frozen=True, slots=True)
class Neighbours:
    """How an axis lies to the one before it.

    Attributes:
        alpha: The angle between them about the common normal [rad].
        a: The length of the common normal.
        d: How far its foot on the first axis is behind the foot of the normal before.
        normal: The direction of the common normal.
        foot: Its foot on the second axis.
    """

    alpha: float
    a: float
    d: float
    normal: FloatArray
    foot: FloatArray


def neighbours(directions: FloatArray, points: FloatArray) -> tuple[Neighbours, ...] | None:
    """How each axis lies to the one before; None where one lies on it.

    Common normals of nearly parallel axes are anywhere: there the foot is kept.

    Args:
        directions: Unit vectors along the axes, (n, 3).
        points: Points of them, (n, 3).
    """
    found: list[Neighbours] = []
    for place in range(len(directions) - 1):
        u, v = directions[place], directions[place + 1]
        p, r = points[place], points[place + 1]
        before = found[-1].foot if found else None
        across = np.cross(u, v)
        sine, cosine = float(np.linalg.norm(across)), float(u @ v)
        if sine < math.sin(TILT):
            foot = p if before is None else before
            between = r - foot
            between = between - (between @ u) * u
            length = float(np.linalg.norm(between))
            if not length:
                return None
            landing = foot + between
            landing = r + ((landing - r) @ v) * v
            found.append(
                Neighbours(math.atan2(sine, cosine), length, 0.0, between / length, landing)
            )
            continue
        s, t = _feet(p, u, r, v)
        foot, landing, normal = p + s * u, r + t * v, across / sine
        d = 0.0 if before is None else float((foot - before) @ u)
        a = float((landing - foot) @ normal)
        found.append(Neighbours(math.atan2(sine, cosine), a, d, normal, landing))
    return tuple(found)


def _feet(p: FloatArray, u: FloatArray, r: FloatArray, v: FloatArray) -> tuple[float, float]:
    """How far from points of two lines the feet of their common normal are, along each."""
    between, along = r - p, float(u @ v)
    squared = 1.0 - along * along
    first, second = float(between @ u), float(between @ v)
    return (first - along * second) / squared, (along * first - second) / squared
