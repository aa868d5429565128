"""The forward model in floating point, from the chain: what emitted code is measured against."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.chain import Chain, Fixed
from dhgen.kinematics.ring import terms_in_numbers

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.transform import Transform


@dataclass(frozen=True, slots=True)
class NumericArm:
    """A chain with its constant transforms as matrices.

    Attributes:
        chain: The arm.
        base: Z, shape (4, 4).
        tool: E, shape (4, 4).
        elements: For every element its constant matrix, or the number of its joint.
    """

    chain: Chain
    base: FloatArray
    tool: FloatArray
    elements: tuple[FloatArray | int, ...]

    def pose(self, q: FloatArray) -> FloatArray:
        """T of joint values, shape (..., n) to (..., 4, 4)."""
        return self._frames(q)[0]

    def axes(self, q: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Directions and points (..., n, 3) of the joints' axes at joint values (..., n)."""
        frames = self._frames(q)[1]
        return frames[..., :3, 2], frames[..., :3, 3]

    def jacobian(self, q: FloatArray) -> FloatArray:
        """The geometric Jacobian (..., 6, n): velocity of the tool's origin, angular velocity."""
        return self.moved(q)[1]

    def moved(self, q: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Pose (..., 4, 4) and geometric Jacobian (..., 6, n) of joint values (..., n)."""
        T, frames = self._frames(q)
        directions, points = frames[..., :3, 2], frames[..., :3, 3]
        turns = np.array(self.chain.turning)[:, None]
        velocities = np.cross(directions, T[..., None, :3, 3] - points)
        columns = np.concatenate(
            [np.where(turns, velocities, directions), np.where(turns, directions, 0.0)], axis=-1
        )
        return T, self.chain.drives.rates(np.swapaxes(columns, -1, -2))

    def steps(self, q: FloatArray) -> FloatArray:
        """What the joints' own transforms are for joint values (..., n), (..., n, 4, 4)."""
        turns = self.chain.turning
        values = self.chain.drives.values(q)
        angles = np.where(turns, values, 0.0)
        steps = np.zeros((*q.shape, 4, 4))
        steps[..., 0, 0] = steps[..., 1, 1] = np.cos(angles)
        steps[..., 1, 0] = np.sin(angles)
        steps[..., 0, 1] = -steps[..., 1, 0]
        steps[..., 2, 2] = steps[..., 3, 3] = 1.0
        steps[..., 2, 3] = np.where(turns, 0.0, values)
        return steps

    def _frames(self, q: FloatArray) -> tuple[FloatArray, FloatArray]:
        """The pose (..., 4, 4), and the frames that the joints move in (..., n, 4, 4)."""
        steps = self.steps(np.asarray(q, np.float64))
        frames = np.empty_like(steps)
        T = self.base
        for element in self.elements:
            if isinstance(element, int):
                frames[..., element - 1, :, :] = T
                T = T @ steps[..., element - 1, :, :]
            else:
                T = T @ element
        return T @ self.tool, frames


def numeric_arm(chain: Chain) -> NumericArm:
    """The numeric arm of a chain."""
    values = {constant.name: constant.value for constant in chain.constants}
    elements = tuple(
        _matrix(element.transform, values) if isinstance(element, Fixed) else element.joint
        for link in chain.links
        for element in link
    )
    return NumericArm(chain, _matrix(chain.base, values), _matrix(chain.tool, values), elements)


def _matrix(transform: Transform, values: dict[str, float]) -> FloatArray:
    matrix = np.eye(4)
    for row in range(3):
        for column in range(4):
            matrix[row, column] = sum(terms_in_numbers(transform.entry(row, column), values))
    return matrix
