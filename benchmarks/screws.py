"""An arm by its axes at some joint values, as rivals want it that take no table."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from benchmarks.contestant import AbsentError

if TYPE_CHECKING:
    from benchmarks.arms import Arm
    from dhgen.arrays import FloatArray


@dataclass(frozen=True, slots=True)
class Screws:
    """FK(q) = Rot(axis 1, q1) ... Rot(axis n, qn) home.

    Attributes:
        directions: Unit vectors in the base frame (n, 3).
        points: A point of every axis (n, 3).
        home: The tool's pose (4, 4).
    """

    directions: FloatArray
    points: FloatArray
    home: FloatArray

    @property
    def offsets(self) -> FloatArray:
        """From the base over the axes to the tool, (n + 1, 3)."""
        places = np.vstack([np.zeros(3), self.points, self.home[:3, 3]])
        return np.diff(places, axis=0)

    def without_home_rotation(self, T: FloatArray) -> FloatArray:
        """Poses (N, 4, 4) of a tool frame that is parallel to the base at these joint values."""
        poses = T.copy()
        poses[:, :3, :3] = T[:, :3, :3] @ self.home[:3, :3].T
        return poses


def screws(arm: Arm, at: tuple[float, ...] | None = None) -> Screws:
    """The axes at given joint values, zeros if none are given.

    Raises:
        AbsentError: A joint slides.
    """
    if not all(arm.turning):
        raise AbsentError("takes revolute joints only")
    q = np.zeros(arm.dof) if at is None else np.array(at)
    directions, points = arm.model.axes(q)
    signs = np.array([[joint.sign] for joint in arm.model.chain.joints])
    return Screws(signs * directions, points, arm.model.pose(q))
