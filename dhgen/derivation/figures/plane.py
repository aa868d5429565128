"""The plane in which an arm's postures are best seen."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.figures.view import ELEVATION, View, seen_from

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.arrays import FloatArray
    from dhgen.derivation.figures.skeleton import Skeleton
    from dhgen.derivation.story import Story

LEVEL = 1e-9  # of a cosine: directions that are parallel
NEAR = 1e-6  # of the arm's size: a point on an axis
UP = np.array([0.0, 0.0, 1.0])


@dataclass(frozen=True, slots=True)
class Plane:
    """A direction of sight and what it is called.

    Attributes:
        view: The projection.
        seen: Its name in a sentence.
        upright: Whether what is above is up.
    """

    view: View
    seen: str
    upright: bool


def arm_plane(story: Story, arm: Skeleton) -> Plane:
    """From above where all axes are upright, in the arm's plane where the first one is."""
    axes = [axis for axis in arm.axes if axis.turns]
    if axes and are_parallel([*(axis.z for axis in axes), UP]):
        x, y = np.eye(3)[:2]
        return Plane(View(x, y, UP), "seen from above", upright=False)
    if axes and are_parallel([axes[0].z, UP]):
        wrist = story.wrist
        aim = arm.tool[:3, 3] if wrist is None else arm.axes[wrist[1] - 1].origin
        out = (aim - axes[0].origin) * (1.0, 1.0, 0.0)
        far = float(np.linalg.norm(out))
        right = out / far if far > NEAR * story.algebra.chain.size else np.eye(3)[0]
        name = "the tool" if wrist is None else "the wrist centre"
        seen = f"in the plane through axis {axes[0].number} and {name}"
        return Plane(View(right, UP, np.cross(right, UP)), seen, upright=True)
    return Plane(seen_from(-60.0, ELEVATION), "seen from the side and from above", upright=False)


def are_parallel(directions: Iterable[FloatArray]) -> bool:
    """Whether all unit vectors have one direction or the opposite."""
    first, *others = directions
    return all(abs(abs(float(first @ other)) - 1.0) < LEVEL for other in others)
