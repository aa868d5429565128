"""Whether a robot file is the arm that was described: both at many random joint values."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.descriptions.forward import described_pose, robot_pose

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray
    from dhgen.descriptions.model import Joint
    from dhgen.robot.robot import Robot

SAMPLES = 1000
FAITHFUL = 1e-12  # arm sizes, and rad: what is less is rounding


@dataclass(frozen=True, slots=True)
class Difference:
    """The largest differences of two models.

    Attributes:
        moved: Of the tool's origin [length].
        turned: Of the tool's rotation [rad].
        size: Of the arm [length].
    """

    moved: float
    turned: float
    size: float

    @property
    def relative(self) -> float:
        """The larger of both, in arm sizes and rad."""
        return max(self.moved / self.size, self.turned)

    @property
    def is_rounding(self) -> bool:
        """Whether both models are one."""
        return self.relative <= FAITHFUL


def difference(joints: Sequence[Joint], robot: Robot, size: float) -> Difference:
    """Compares a description with the robot file made of it.

    Args:
        joints: From base to tip, as described.
        robot: The file, read again.
        size: Of the arm.
    """
    q = _samples([joint for joint in joints if joint.is_driven], size)
    one, other = described_pose(joints, q), robot_pose(robot, q)
    moved = np.linalg.norm(one[..., :3, 3] - other[..., :3, 3], axis=-1).max()
    apart = np.linalg.norm(one[..., :3, :3] - other[..., :3, :3], axis=(-2, -1)).max()
    return Difference(float(moved), float(apart) / math.sqrt(2.0), size)


def _samples(joints: Sequence[Joint], size: float) -> FloatArray:
    """Anywhere: a model has to agree outside the limits, too."""
    rng = np.random.default_rng(7)
    reach = np.array([math.pi if joint.motion.turns else size for joint in joints])
    return rng.uniform(-reach, reach, (SAMPLES, len(joints)))
