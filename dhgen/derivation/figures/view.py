"""From where the arm is seen: a parallel projection, and the choice of its direction."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.figures.sheet import settled

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray
    from dhgen.derivation.figures.sheet import Point

# directions from which x points to the right or towards the reader; the first is the usual one
AZIMUTHS = (-60, -40, 30, 50, 120, 150)
ELEVATION = 22
BETTER = 0.12  # by so much has another direction to be better than the usual one


@dataclass(frozen=True, slots=True)
class View:
    """A direction of sight.

    Attributes:
        right: The direction to the right, (3,).
        up: The direction upwards, (3,).
        towards: The direction towards the reader, (3,).
    """

    right: FloatArray
    up: FloatArray
    towards: FloatArray

    def point(self, at: FloatArray) -> Point:
        """A point of space on paper."""
        return settled(at @ self.right), settled(-(at @ self.up))

    def depth(self, along: FloatArray) -> float:
        """How far a vector points towards the reader."""
        return settled(along @ self.towards)


def seen_from(azimuth: float, elevation: float) -> View:
    """The view from a direction, in degrees."""
    a, e = math.radians(azimuth), math.radians(elevation)
    return View(
        right=np.array([-math.sin(a), math.cos(a), 0.0]),
        up=np.array([-math.sin(e) * math.cos(a), -math.sin(e) * math.sin(a), math.cos(e)]),
        towards=np.array([math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)]),
    )


def best_view(members: Sequence[FloatArray], axes: Sequence[FloatArray]) -> View:
    """The usual view, or another one that shortens members and axes much less.

    Args:
        members: Vectors along what the arm is made of.
        axes: Directions of its joints' axes.
    """
    views = [seen_from(azimuth, ELEVATION) for azimuth in AZIMUTHS]
    worth = [_worth(view, members) + _worth(view, axes) for view in views]
    best = max(range(len(views)), key=lambda place: worth[place])
    return views[best] if worth[best] > worth[0] + BETTER else views[0]


def _worth(view: View, vectors: Sequence[FloatArray]) -> float:
    """What is seen of the length of vectors, and of the shortest one."""
    shown = [_shown(view, vector) for vector in vectors] or [1.0]
    return round(sum(shown) / len(shown) + 0.5 * min(shown), 3)


def _shown(view: View, vector: FloatArray) -> float:
    length = float(np.linalg.norm(vector)) or 1.0
    return math.hypot(*view.point(vector / length))
