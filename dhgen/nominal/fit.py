"""The numbers of a table that take the tool to nearly an arm's poses.

Where a frame is on its axis, and how it is turned about it, is free: an arm is constants between
such frames, C0 J(q1) C1 ... J(qn) Cn. What the constants of two arms differ by adds up to a bound
of what their poses differ by. It is the least over the lengths that are not zero, the angles'
offsets, the frames at both ends, and those on the axes. A sum of lengths of vectors is least where
the sum of their squares is, each over its length (E. Weiszfeld 1937): least squares with weights.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray
    from dhgen.nominal.table import Table

ROUNDS = 8  # of weighted least squares: the sums of all twins of the tests have ten digits then
STEP = 1e-6  # of difference quotients [rad, arm sizes]
DIGITS = 10  # [rad, arm sizes] of results; further ones differ from machine to machine
UNDETERMINED = 1e-9  # singular values below this part of the largest count as zero
SHORTEST = 1e-8  # [arm sizes] vectors are weighted as if they were no shorter


@dataclass(frozen=True, slots=True)
class Fit:
    """An arm with a structure: T = base J(θ1) K1 J(θ2) ... J(θn) tool.

    Attributes:
        table: Its table, but for its lengths.
        base: B, (4, 4).
        tool: E, (4, 4).
        lengths: Those of the table that are not zero.
        offsets: What the angles 2 to n - 1 of the table are more than the arm's.
        moved: How far along its axis each frame is from the table's, (n,).
        turned: By how much it is turned about it, (n,) [rad].
    """

    table: Table
    base: FloatArray
    tool: FloatArray
    lengths: FloatArray
    offsets: FloatArray
    moved: FloatArray
    turned: FloatArray

    @property
    def constants(self) -> FloatArray:
        """C0 ... Cn, (n + 1, 4, 4)."""
        screws = _screws(self.moved, self.turned)
        ahead = np.array([self.base, *self.table.links(self.lengths, self.offsets)]) @ screws
        behind = np.array([np.eye(4), *np.linalg.inv(screws)])
        constants: FloatArray = behind @ np.array([*ahead, self.tool])
        return constants


def fitted(start: Fit, wanted: FloatArray, size: float) -> Fit:
    """The best numbers.

    Args:
        start: Numbers near them. Zeros of its table and twists are kept.
        wanted: C0 ... Cn of the arm, (n + 1, 4, 4).
        size: The length that counts as much as 1 rad.
    """
    joints, lengths = start.table.joints, len(start.lengths)
    ends = np.cumsum([6, 6, lengths, joints - 2, joints, joints])

    def moved(x: FloatArray) -> Fit:
        at_base, at_tool, grown, offset, along, about, _ = np.split(x, ends)
        return Fit(
            start.table,
            start.base @ _motion(at_base, size),
            _motion(at_tool, size) @ start.tool,
            start.lengths + size * grown,
            start.offsets + offset,
            start.moved + size * along,
            start.turned + about,
        )

    behind = lengths_behind(wanted) / size

    def missed(x: FloatArray) -> FloatArray:
        return _missed(moved(x).constants, wanted, size, behind)

    x: FloatArray = np.zeros(int(ends[-1]))
    for _ in range(ROUNDS):
        off = missed(x)
        weights = np.maximum(np.linalg.norm(off, axis=-1, keepdims=True), SHORTEST) ** -0.5
        steps = STEP * np.eye(len(x))
        slopes = [
            (weights * (missed(x + step) - missed(x - step))).reshape(-1) / (2.0 * STEP)
            for step in steps
        ]
        flat = (weights * off).reshape(-1)
        x = x - np.linalg.lstsq(np.array(slopes).T, flat, rcond=UNDETERMINED)[0]
    return moved(np.round(x, DIGITS))


def lengths_behind(constants: FloatArray) -> FloatArray:
    """How far away the tool may be at most behind each of C0 ... Cn, (n + 1,)."""
    lengths = np.linalg.norm(constants[:, :3, 3], axis=-1)
    behind: FloatArray = np.cumsum(lengths[::-1])[::-1] - lengths
    return behind


def _missed(found: FloatArray, wanted: FloatArray, size: float, behind: FloatArray) -> FloatArray:
    """What the sum is made of, (2 n + 2, 3), in arm sizes.

    Translations, and turns by their vectors, at the length behind them and as much as the arm's
    size more: what turns the tool counts, too.
    """
    off = (found[:, :3, 3] - wanted[:, :3, 3]) / size
    R = np.swapaxes(wanted[:, :3, :3], -1, -2) @ found[:, :3, :3]
    skew = 0.5 * (R - np.swapaxes(R, -1, -2))
    turns = np.stack([skew[:, 2, 1], skew[:, 0, 2], skew[:, 1, 0]], axis=-1)
    return np.concatenate([off, turns * (1.0 + behind[:, None])])


def _screws(along: Sequence[float] | FloatArray, about: Sequence[float] | FloatArray) -> FloatArray:
    """Motions along and about z, (n, 4, 4)."""
    screws = np.zeros((len(along), 4, 4))
    screws[:, 0, 0] = screws[:, 1, 1] = np.cos(about)
    screws[:, 1, 0] = np.sin(about)
    screws[:, 0, 1] = -screws[:, 1, 0]
    screws[:, 2, 2] = screws[:, 3, 3] = 1.0
    screws[:, 2, 3] = along
    return screws


def _motion(x: FloatArray, size: float) -> FloatArray:
    """A little motion: a rotation by Cayley's formula, and a translation."""
    a, b, c = map(float, 0.5 * x[:3])
    skew = np.array([[0.0, -c, b], [c, 0.0, -a], [-b, a, 0.0]])
    motion = np.eye(4)
    motion[:3, :3] += 2.0 / (1.0 + a * a + b * b + c * c) * (skew + skew @ skew)
    motion[:3, 3] = size * x[3:6]
    return motion
