"""How far answers are from right, by the independent forward model: lengths count in arm sizes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.algebra import POSE_PLACES
from dhgen.kinematics.numeric import NumericArm, numeric_arm
from dhgen.kinematics.task import task_entries, task_rates

if TYPE_CHECKING:
    from collections.abc import Iterator

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain


STEP = 1e-5  # [rad or length] of the differences
WAY = 17  # joint values on the way from one solution to another
ONTO = 3  # steps from a straight way onto a curve of solutions beside it
NULL = 1e-6  # of the largest singular value: directions that these steps leave alone
LEAP = 3.0  # times as far as on the straight way: neighbours that are farther apart are no way
SLIGHTLY = 1e-3  # [rad or arm sizes] a double solution moves by less with rounding


def filled(rows: FloatArray) -> NDArray[np.bool_]:
    """Which of some rows (..., n) hold joint values."""
    return np.asarray(np.isfinite(rows).all(axis=-1))


class Measures:
    """Measures of one arm.

    Attributes:
        arm: The independent forward model.
    """

    def __init__(self, chain: Chain) -> None:
        self.arm: NumericArm = numeric_arm(chain)
        self._chain = chain
        self._turns = np.array(chain.turning)

    def pose_miss(self, got: FloatArray, T: FloatArray) -> FloatArray:
        """The largest difference of two poses' entries, relative to how far the pose is away.

        Poses (..., 4, 4), to (...).
        """
        scale = np.ones_like(T)
        scale[..., :3, 3] = self._away(T)[..., None]
        return np.asarray(np.abs((got - T) / scale).max(axis=(-2, -1)))

    def jacobian_miss(self, got: FloatArray, wanted: FloatArray) -> FloatArray:
        """The largest difference of two Jacobians (..., 6, n), relative to their size: (...)."""
        miss, size = (np.abs(each).max(axis=(-2, -1)) for each in (got - wanted, wanted))
        return np.asarray(miss / np.maximum(1.0, size))

    def _away(self, T: FloatArray) -> FloatArray:
        """How far poses (..., 4, 4) are away, at least the size of the arm."""
        return np.asarray(np.maximum(self._chain.size, np.abs(T[..., :3, 3]).max(axis=-1)))

    def joint_miss(self, rows: FloatArray, others: FloatArray) -> FloatArray:
        """Differences of joint values, whole turns aside."""
        miss = np.abs(self._short_way(rows - others))
        return np.asarray(np.where(self._turns, miss, miss / self._chain.size))

    def ways(self, row: FloatArray, q: FloatArray) -> FloatArray:
        """Joint values (2, WAY, n) on ways from a row to others, the short way round.

        The straight one, and one on which the joints that differ slightly move first.
        """
        moved, slightly = self._short_way(q - row), self.joint_miss(row, q) <= SLIGHTLY
        part = np.linspace(0.0, 1.0, WAY)[:, None]
        bent = np.where(slightly, np.minimum(2.0 * part, 1.0), np.maximum(2.0 * part - 1.0, 0.0))
        return np.asarray(row + np.stack([part * moved, bent * moved]))

    def curves(self, row: FloatArray, q: FloatArray, T: FloatArray) -> Iterator[FloatArray]:
        """The ways from a row to others, bent onto solutions of the pose beside them.

        Solutions of which a joint is free, or nearly, are seldom on a straight way. Those that leap
        are left out.
        """
        for way in self.ways(row, q):
            curve = way.copy()
            for _ in range(ONTO):
                curve[1:-1] += self._step_onto(curve[1:-1], T)
            steps = np.abs(np.diff(curve, axis=0)).max(axis=1)
            if steps.max() <= LEAP * np.abs(np.diff(way, axis=0)).max():
                yield curve

    def _step_onto(self, q: FloatArray, T: FloatArray) -> FloatArray:
        """Least-squares steps from joint values (N, n) to a pose, across what is nearly free."""
        reached, J = self.arm.moved(q)
        columns = np.swapaxes(reached[:, :3, :3], 1, 2)
        turned = np.cross(J[:, None, 3:].swapaxes(2, 3), columns[:, :, None])  # (N, column, n, 3)
        rates = np.concatenate([turned, J[:, None, :3].swapaxes(2, 3) / self._chain.size], axis=1)
        missed = (T - reached)[:, :3] / [1.0, 1.0, 1.0, self._chain.size]
        names = sorted(task_entries(self._chain.task))
        rows, entries = zip(*(POSE_PLACES[name] for name in names), strict=True)
        solved = [joint.number - 1 for joint in self._chain.solved]
        slopes = rates[:, entries, :, rows].swapaxes(0, 1)[..., solved]
        step = np.zeros_like(q)
        inverse = np.linalg.pinv(slopes, rcond=NULL)
        step[:, solved] = (inverse @ missed[:, rows, entries][..., None])[..., 0]
        return step

    def _short_way(self, moved: FloatArray) -> FloatArray:
        """Differences of joint values without whole turns of the joints.

        Those of a joint may move several drives.
        """
        drives = self._chain.drives
        if drives.are_coupled:
            off = moved @ drives.matrix.T
            turns = np.where(self._turns, 2.0 * np.pi * np.round(off / (2.0 * np.pi)), 0.0)
            return np.asarray(moved - turns @ drives.inverse.T)
        turns = 2.0 * np.pi * np.round(moved / (2.0 * np.pi))
        return np.asarray(moved - np.where(self._turns, turns, 0.0))

    def residual(self, rows: FloatArray, T: FloatArray) -> float:
        """The largest miss of the pose's entries that the task names, by any row.

        Args:
            rows: Joint values (..., n).
            T: Their poses, (4, 4) or (..., 4, 4).
        """
        off = np.abs(self.arm.pose(rows) - T)
        off[..., :3, 3] /= self._away(T)[..., None]
        i, j = zip(*(POSE_PLACES[name] for name in task_entries(self._chain.task)), strict=True)
        worst = float(off[..., i, j].max(initial=0.0))
        return np.inf if np.isnan(worst) else worst

    def fixed(self, q: FloatArray) -> float:
        """How well poses fix joint values (..., n): the task's least singular value of all."""
        return float(np.linalg.svd(task_rates(self.arm, q), compute_uv=False)[..., -1].min())

    def jacobians(self, q: FloatArray, T: FloatArray) -> FloatArray:
        """By central differences, for joint values (N, n) and their poses (N, 4, 4): (N, 6, n)."""
        moves = STEP * np.eye(self._chain.dof)
        there, back = (self.arm.pose(q[:, None] + way * moves) for way in (1.0, -1.0))
        rates = (there - back) / (2.0 * STEP)
        spins = rates[..., :3, :3] @ np.swapaxes(T, 1, 2)[:, None, :3, :3]
        turns = np.stack([spins[..., 2, 1], spins[..., 0, 2], spins[..., 1, 0]], axis=-1)
        return np.swapaxes(np.concatenate([rates[..., :3, 3], turns], axis=-1), 1, 2)
