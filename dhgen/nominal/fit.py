"""The numbers of a table that take the tool to nearly the same poses as an arm does.

Least squares over the lengths that are not zero, the angles' offsets, and the frames at both ends:
these take up what they can of what the structure takes away.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.arrays import FloatArray
    from dhgen.nominal.table import Table

JOINTS = 6
POSES = 48
ROUNDS = 8  # of Gauss and Newton: what is missed is little, so that each gains several digits
STEP = 1e-6  # of difference quotients [rad, arm sizes]
DIGITS = 10  # [rad, arm sizes] of results; further ones differ from machine to machine
UNDETERMINED = 1e-9  # singular values below this part of the largest count as zero


@dataclass(frozen=True, slots=True)
class Fit:
    """An arm with a structure: T = base J(θ1) K1 J(θ2) ... K5 J(θ6) tool.

    Attributes:
        base: B, (4, 4).
        links: The five links between axes, (5, 4, 4).
        tool: E, (4, 4).
        lengths: Those of the table that are not zero.
        offsets: What the angles 2 to 5 of the table are more than the arm's.
    """

    base: FloatArray
    links: FloatArray
    tool: FloatArray
    lengths: FloatArray
    offsets: FloatArray

    def pose(self, angles: FloatArray) -> FloatArray:
        """T of angles (..., 6)."""
        T = self.base @ _turns(angles[..., 0])
        for place, link in enumerate(self.links):
            T = T @ link @ _turns(angles[..., place + 1])
        return T @ self.tool


def fitted(
    table: Table,
    start: tuple[FloatArray, FloatArray, FloatArray],
    pose: Callable[[FloatArray], FloatArray],
    size: float,
) -> Fit:
    """The table's best numbers.

    Args:
        table: What is zero in it stays so, and twists stay as they are.
        start: The frame of the base, the tool, and the offsets of angles 2 to 5.
        pose: What the arm takes angles (n, 6) to, (n, 4, 4).
        size: The length that counts as much as 1 rad.
    """
    angles = np.random.default_rng(0).uniform(-np.pi, np.pi, (POSES, JOINTS))
    wanted = pose(angles)
    base, tool, offsets = start
    lengths = table.lengths

    def moved(x: FloatArray) -> Fit:
        grown, turned = lengths + size * x[12 : 12 + len(lengths)], offsets + x[12 + len(lengths) :]
        ends = base @ _motion(x[:6], size), _motion(x[6:12], size) @ tool
        return Fit(ends[0], table.links(grown, turned), ends[1], grown, turned)

    def missed(x: FloatArray) -> FloatArray:
        return _missed(moved(x).pose(angles), wanted, size)

    x = np.zeros(12 + len(lengths) + len(offsets))
    for _ in range(ROUNDS):
        steps = STEP * np.eye(len(x))
        slopes = [(missed(x + step) - missed(x - step)) / (2.0 * STEP) for step in steps]
        x = x - np.linalg.lstsq(np.array(slopes).T, missed(x), rcond=UNDETERMINED)[0]
    return moved(np.round(x, DIGITS))


def _missed(found: FloatArray, wanted: FloatArray, size: float) -> FloatArray:
    """By what poses miss others: translations in arm sizes, and entries of the rotations."""
    off = found[:, :3] - wanted[:, :3]
    off[..., 3] /= size
    return off.reshape(-1)


def _turns(angles: FloatArray) -> FloatArray:
    turns = np.zeros((*angles.shape, 4, 4))
    turns[..., 0, 0] = turns[..., 1, 1] = np.cos(angles)
    turns[..., 1, 0] = np.sin(angles)
    turns[..., 0, 1] = -turns[..., 1, 0]
    turns[..., 2, 2] = turns[..., 3, 3] = 1.0
    return turns


def _motion(x: FloatArray, size: float) -> FloatArray:
    """A little motion: a rotation by Cayley's formula, and a translation."""
    a, b, c = map(float, 0.5 * x[:3])
    skew = np.array([[0.0, -c, b], [c, 0.0, -a], [-b, a, 0.0]])
    motion = np.eye(4)
    motion[:3, :3] += 2.0 / (1.0 + a * a + b * b + c * c) * (skew + skew @ skew)
    motion[:3, 3] = size * x[3:6]
    return motion
