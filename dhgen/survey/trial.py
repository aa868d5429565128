"""A compiled solver and how far its answers are from right, by the oracle's forward model."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.oracle.arm_angle import given_values
from dhgen.oracle.forward import forward
from dhgen.oracle.problem import task_entries
from dhgen.oracle.search import solve
from dhgen.status import HELD

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.oracle.arm import Arm
    from dhgen.oracle.search import Found
    from dhgen.robot.robot import Robot
    from dhgen.verify.native import CompiledSolver


@dataclass(frozen=True, slots=True)
class Trial:
    """A solver at work.

    Attributes:
        robot: What it is for.
        model: The robot as numbers.
        size: Of the arm [file's unit].
        solver: The written C, compiled.
    """

    robot: Robot
    model: Arm
    size: float
    solver: CompiledSolver

    def poses(self, q: FloatArray) -> FloatArray:
        """T (N, 4, 4) of joint values (N, n)."""
        return np.ascontiguousarray(forward(self.model, q), dtype=float)

    def given(self, q: FloatArray) -> FloatArray | None:
        """The values of the free joints, or the arm angle, where there are any."""
        values = given_values(self.robot, q)
        return values if values.shape[-1] else None

    def solve(self, T: FloatArray, q: FloatArray) -> tuple[FloatArray, NDArray[np.uint8]]:
        """The rows (k, n) that hold joint values, and their statuses; the seed is q (n,)."""
        rows, status = self.solver.ik(T, np.ascontiguousarray(q), self.given(q))
        held = np.isin(status, HELD)
        return rows[held], status[held]

    def search(self, T: FloatArray, q: FloatArray, *, seed: int = 0, at_least: int = 0) -> Found:
        """What the oracle finds for a pose, with the free joints' values from q (n,)."""
        values = tuple(given_values(self.robot, q))
        return solve(self.robot, T, values, seed=seed, at_least=at_least)

    def residuals(self, rows: FloatArray, T: FloatArray) -> FloatArray:
        """The largest miss of an entry that the task names, of each row: lengths in arm sizes."""
        miss = np.abs(forward(self.model, rows) - T)[:, :3]
        miss[..., 3] /= max(self.size, float(np.abs(T[:3, 3]).max()))
        named = miss.reshape(len(rows), 12)[:, task_entries(self.robot.task)]
        return np.asarray(np.where(np.isnan(named), np.inf, named).max(axis=1))

    def apart(self, rows: FloatArray, q: FloatArray) -> FloatArray:
        """The largest difference of joint values, whole turns aside, lengths in arm sizes."""
        off = rows - q
        miss = np.abs(off @ self.model.shares.T if self.model.is_coupled else off)
        turned = np.abs(miss - 2 * np.pi * np.round(miss / (2 * np.pi)))
        return np.asarray(np.where(self.model.turns, turned, miss / self.size).max(axis=-1))
