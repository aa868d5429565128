"""The forward model in floating point, from the chain: what emitted code is measured against."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.chain import Chain, Fixed, Passive
from dhgen.kinematics.ring import terms_in_numbers

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Slide, Turn
    from dhgen.kinematics.transform import Transform


@dataclass(frozen=True, slots=True)
class NumericArm:
    """A chain with its constant transforms as matrices.

    Attributes:
        chain: The arm.
        base: Z, shape (4, 4).
        tool: E, shape (4, 4).
        elements: For every element its constant matrix, or the number of its joint; passive rows
            are numbered behind the joints.
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
        directions, points = self.all_axes(q)
        return directions[..., : self.chain.dof, :], points[..., : self.chain.dof, :]

    def all_axes(self, q: FloatArray) -> tuple[FloatArray, FloatArray]:
        """As `axes`, with those of passive rows behind them."""
        frames = self._frames(q)[1]
        return frames[..., :3, 2], frames[..., :3, 3]

    def passive_behind(self, joint: int) -> int | None:
        """The number of the passive row that follows a joint next; None where a joint does."""
        numbers = [element for element in self.elements if isinstance(element, int)]
        number = next(iter(numbers[numbers.index(joint) + 1 :]), 0)
        return number if number > self.chain.dof else None

    def jacobian(self, q: FloatArray) -> FloatArray:
        """The geometric Jacobian (..., 6, n): velocity of the tool's origin, angular velocity."""
        return self.moved(q)[1]

    def moved(self, q: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Pose (..., 4, 4) and geometric Jacobian (..., 6, n) of joint values (..., n)."""
        T, frames = self._frames(q)
        directions, points = frames[..., :3, 2], frames[..., :3, 3]
        turns = self.turning[:, None]
        velocities = np.cross(directions, T[..., None, :3, 3] - points)
        columns = np.concatenate(
            [np.where(turns, velocities, directions), np.where(turns, directions, 0.0)], axis=-1
        )
        columns = np.swapaxes(columns, -1, -2)
        dof, passive = self.chain.dof, self.chain.passive
        J = self.chain.drives.rates(columns[..., :dof])
        return T, J + columns[..., dof:] @ _factors(passive, dof) if passive else J

    def steps(self, q: FloatArray) -> FloatArray:
        """What the joints' own transforms are for joint values (..., n), (..., n, 4, 4).

        Behind them are those of passive rows.
        """
        turns, values = self.turning, self.values(q)
        angles = np.where(turns, values, 0.0)
        steps = np.zeros((*values.shape, 4, 4))
        steps[..., 0, 0] = steps[..., 1, 1] = np.cos(angles)
        steps[..., 1, 0] = np.sin(angles)
        steps[..., 0, 1] = -steps[..., 1, 0]
        steps[..., 2, 2] = steps[..., 3, 3] = 1.0
        steps[..., 2, 3] = np.where(turns, 0.0, values)
        return steps

    def values(self, q: FloatArray) -> FloatArray:
        """Angles and slides of the joints' axes, with those of passive rows behind them."""
        passive, values = self.chain.passive, self.chain.drives.values(q)
        if not passive:
            return values
        moved = q @ _factors(passive, self.chain.dof).T + [each.offset for each in passive]
        return np.concatenate([values, moved], axis=-1)

    @property
    def turning(self) -> NDArray[np.bool_]:
        """Which of the axes that joints and passive rows have are turned about."""
        passive = (each.turns for each in self.chain.passive)
        return np.array([*self.chain.turning, *passive])

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
        _matrix(element.transform, values)
        if isinstance(element, Fixed)
        else _number(element, chain)
        for link in chain.links
        for element in link
    )
    return NumericArm(chain, _matrix(chain.base, values), _matrix(chain.tool, values), elements)


def _number(element: Turn | Slide | Passive, chain: Chain) -> int:
    return chain.dof + 1 + element.place if isinstance(element, Passive) else element.joint


def _factors(passive: Sequence[Passive], dof: int) -> FloatArray:
    """What drives' values are multiplied by for those of passive rows, (rows, n)."""
    factors = np.zeros((len(passive), dof))
    for row, each in zip(factors, passive, strict=True):
        for share in each.shares:
            row[share.drive - 1] = share.factor
    return factors


def _matrix(transform: Transform, values: dict[str, float]) -> FloatArray:
    matrix = np.eye(4)
    for row in range(3):
        for column in range(4):
            matrix[row, column] = sum(terms_in_numbers(transform.entry(row, column), values))
    return matrix
