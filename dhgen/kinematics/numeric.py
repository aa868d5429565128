"""The forward model in floating point, from the chain: what emitted code is measured against."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.chain import Chain, Fixed, Turn
from dhgen.kinematics.ring import terms_in_numbers
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.kinematics.transform import Transform

    Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class NumericArm:
    """A chain with its constant transforms as matrices.

    Attributes:
        chain: The arm.
        base: Z, shape (4, 4).
        tool: E, shape (4, 4).
        elements: For every element its constant matrix, or its joint and whether it turns.
    """

    chain: Chain
    base: Array
    tool: Array
    elements: tuple[Array | tuple[int, bool], ...]

    def pose(self, q: Array) -> Array:
        """T of joint values, shape (..., n) to (..., 4, 4)."""
        q = np.asarray(q, np.float64)
        T = np.broadcast_to(self.base, (*q.shape[:-1], 4, 4))
        for element in self.elements:
            T = T @ self.step(q, element)
        return np.asarray(T @ self.tool)

    def axes(self, q: Array) -> tuple[Array, Array]:
        """Directions and points (..., n, 3) of the joints' axes at joint values (..., n)."""
        q = np.asarray(q, np.float64)
        T = np.broadcast_to(self.base, (*q.shape[:-1], 4, 4))
        directions, points = [], []
        for element in self.elements:
            if isinstance(element, tuple):
                directions.append(T[..., :3, 2])
                points.append(T[..., :3, 3])
            T = T @ self.step(q, element)
        return np.stack(directions, axis=-2), np.stack(points, axis=-2)

    def jacobian(self, q: Array) -> Array:
        """The geometric Jacobian (..., 6, n): velocity of the tool's origin, angular velocity."""
        directions, points = self.axes(q)
        tip = self.pose(q)[..., None, :3, 3]
        columns = np.concatenate([np.cross(directions, tip - points), directions], axis=-1)
        for place, joint in enumerate(self.chain.joints):
            if joint.kind is JointKind.PRISMATIC:
                columns[..., place, :3] = directions[..., place, :]
                columns[..., place, 3:] = 0.0
            columns[..., place, :] *= joint.sign
        return np.swapaxes(columns, -1, -2)

    def step(self, q: Array, element: Array | tuple[int, bool]) -> Array:
        """The transform of one of `elements` for joint values (..., n)."""
        return self._joint(q, *element) if isinstance(element, tuple) else element

    def _joint(self, q: Array, number: int, turns: bool) -> Array:  # noqa: FBT001
        known = self.chain.joints[number - 1]
        value = known.sign * q[..., number - 1] + known.offset
        step = np.zeros((*q.shape[:-1], 4, 4))
        step[..., range(4), range(4)] = 1.0
        if turns:
            cosine, sine = np.cos(value), np.sin(value)
            step[..., 0, 0] = step[..., 1, 1] = cosine
            step[..., 1, 0], step[..., 0, 1] = sine, -sine
        else:
            step[..., 2, 3] = value
        return step


def numeric_arm(chain: Chain) -> NumericArm:
    """The numeric arm of a chain."""
    values = {constant.name: constant.value for constant in chain.constants}
    elements = tuple(
        _matrix(element.transform, values)
        if isinstance(element, Fixed)
        else (element.joint, isinstance(element, Turn))
        for link in chain.links
        for element in link
    )
    return NumericArm(chain, _matrix(chain.base, values), _matrix(chain.tool, values), elements)


def _matrix(transform: Transform, values: dict[str, float]) -> Array:
    matrix = np.eye(4)
    for row in range(3):
        for column in range(4):
            matrix[row, column] = sum(terms_in_numbers(transform.entry(row, column), values))
    return matrix
