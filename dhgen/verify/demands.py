"""What joint values have to be, by the independent forward model."""

from __future__ import annotations

import math
from itertools import chain
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.errors import VerificationError
from dhgen.kinematics.given import given_values
from dhgen.kinematics.task import task_jacobian, units
from dhgen.program.walk import whole_arm
from dhgen.tolerances import TOLERANCES
from dhgen.verify.measures import Measures, filled

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.targets.module import SolverModule


RESIDUAL = TOLERANCES.promised  # of the arm's size: what a row may miss its pose by
GENERAL_RESIDUAL = 1e-9  # the same where roots of a polynomial are refined
AGREEMENT = 1e-12  # between targets, where the branch is well conditioned
FOUND = 1e-6  # [rad or arm sizes] the generating joint values on random poses
FOUND_SINGULAR = 1e-3  # the same where a pose hardly fixes them
FIXED = 1e-12  # least singular value: with a smaller one rounding moves joint values that far
MET = math.sqrt(TOLERANCES.merge)  # what lies between two branches that have met misses by less
JACOBIAN = 1e-6  # against central differences
UNDAMPED = 0.02  # twice the least singular value with which joint velocities are exact


class Demands:
    """Demands on the rows of an arm; what is not met is a VerificationError.

    Attributes:
        measures: Of the arm.
        has_branches: Whether rows are branches: with a general algorithm they are not.
        residual: The largest miss of a row so far, in arm sizes.
    """

    def __init__(self, module: SolverModule) -> None:
        self.measures = Measures(module.chain)
        self.has_branches = whole_arm(module.solver) is None
        self.residual = 0.0
        self._chain = module.chain

    def forward(self, solver: Any, q: FloatArray, T: FloatArray, J: FloatArray, where: str) -> None:  # noqa: ANN401
        """A language's poses, Jacobians and joint velocities are right.

        Args:
            solver: Its functions.
            q: Joint values (N, n).
            T: Their poses (N, 4, 4).
            J: Their Jacobians (N, 6, n).
            where: Begins the message, before the joint values.
        """
        if not len(q):
            return
        got = np.array([solver.fk(each) for each in q])
        self._all_at_most(self.measures.pose_miss(got, T), AGREEMENT, q, f"{where} fk is off")
        got = np.array([solver.jacobian(each) for each in q])
        misses = self.measures.jacobian_miss(got, J)
        self._all_at_most(misses, JACOBIAN, q, f"{where} Jacobian is off")
        misses = self._velocity_miss(solver, q)
        self._all_at_most(misses, AGREEMENT, q, f"{where} joint velocities are off")

    def _velocity_miss(self, solver: Any, q: FloatArray) -> FloatArray:  # noqa: ANN401
        """By how much joint velocities miss twists that the arm can do, where it is regular."""
        arm, scale = self.measures.arm, units(self._chain)
        rates = task_jacobian(arm, q)
        regular = np.linalg.svd(rates, compute_uv=False)[:, -1] > UNDAMPED
        twists = arm.jacobian(q) @ scale
        misses = np.zeros(len(q))
        for k in np.flatnonzero(regular):
            found = solver.joint_velocities(q[k], twists[k])
            misses[k] = np.abs(rates[k] @ (found / scale - 1.0)).max()
        return misses

    def agree(
        self, rows: FloatArray, others: FloatArray, T: FloatArray, what: str, where: str
    ) -> None:
        """Joint values reproduce their pose and agree up to rounding, as far as that fixes them.

        Where two branches meet near a place where a joint is free, the row that both have
        represents joint values that may be far apart.
        """
        if not len(rows):
            return
        missed = self.reproduce(rows, T, f"{where}, Python")
        missed = max(missed, self.reproduce(others, T, f"{where}, {what}"))
        misses, enough = self._compared(rows, others, T, missed)
        self.at_most(float(misses.max()), enough, f"{where}: Python and {what} differ")

    def _compared(
        self, rows: FloatArray, others: FloatArray, T: FloatArray, missed: float
    ) -> tuple[FloatArray, float]:
        """By how much joint values differ, 0 where they are one solution; and what is enough."""
        misses, enough = self.measures.joint_miss(rows, others).max(axis=1), AGREEMENT
        if not misses.max() <= enough:
            enough = max(enough, missed) / min(max(self.measures.fixed(rows), 1e-9), 1.0)
            misses[[self._stand_for_one(*pair, T) for pair in zip(rows, others, strict=True)]] = 0.0
        return misses, enough

    def hold_the_same(
        self, rows: FloatArray, others: FloatArray, T: FloatArray, where: str
    ) -> bool:
        """Whether two languages' rows (branches, n) are the same solutions, in whatever rows.

        Where the arm is singular rounding decides in which row a solution is, and which of the
        solutions that differ by a free joint. Rows elsewhere are compared one by one.
        """
        held, its = filled(rows), filled(others)
        missed = max(self.reproduce(each, T, where) for each in (rows[held], others[its]))
        apart = held != its
        if (both := held & its).any():
            misses, enough = self._compared(rows[both], others[both], T, missed)
            apart[both] = ~(misses <= enough)
        return self._are_among(rows[held & apart], others[its], T) and self._are_among(
            others[its & apart], rows[held], T
        )

    def _are_among(self, rows: FloatArray, others: FloatArray, T: FloatArray) -> bool:
        """Whether each of some rows at an edge represents one of others."""
        return all(any(self._stand_for_one(row, other, T) for other in others) for row in rows)

    def reproduce(self, rows: FloatArray, T: FloatArray, where: str) -> float:
        """Every row reproduces its pose; by how much they miss it at most.

        Args:
            rows: Joint values (R, n).
            T: Their pose (4, 4), or a pose for each (R, 4, 4).
            where: Begins the message.
        """
        if not len(rows):
            return 0.0
        miss = self.measures.residual(rows, T)
        self.residual = max(self.residual, miss)
        enough = RESIDUAL if self.has_branches else GENERAL_RESIDUAL
        self.at_most(miss, enough, f"{where}: a row misses the pose, in arm sizes")
        return miss

    def recover(self, rows: FloatArray, q: FloatArray, enough: float, where: str) -> None:
        """The generating joint values are among the rows: free joints took them from the seed."""
        miss = self._nearest_miss(rows, q)
        self.at_most(miss, enough, f"{where}: q is not among the solutions, the nearest is off")

    def has(self, rows: FloatArray, q: FloatArray, enough: float) -> bool:
        """Whether joint values are among rows."""
        return self._nearest_miss(rows, q) <= enough

    def _nearest_miss(self, rows: FloatArray, q: FloatArray) -> float:
        return float(self.measures.joint_miss(rows, q).max(axis=1).min())

    def is_as_good(self, rows: FloatArray, q: FloatArray, T: FloatArray) -> bool:
        """Whether joint values differ from a row with no free joint by less than a pose fixes.

        Of an arm that is singular there rounding moves them: where two solutions meet beside a
        place where a joint is free, as far as all joint values in between reach the pose. Where
        the arm is at the edge of its reach, too, those are not on the straight way.
        """
        if self.measures.fixed(q) > FIXED:
            return False
        return any(self._lead(row, q, T, GENERAL_RESIDUAL) for row in rows[filled(rows)])

    def _stand_for_one(self, row: FloatArray, other: FloatArray, T: FloatArray) -> bool:
        """Whether branches have met where these are."""
        return self.are_at_an_edge(row[None]) and self._lead(row, other, T, MET)

    def _lead(self, row: FloatArray, q: FloatArray, T: FloatArray, enough: float) -> bool:
        """Whether all joint values on a way from a row to others nearly reach the pose."""
        ways = chain(self.measures.ways(row, q), self.measures.curves(row, q, T))
        return any(self.measures.residual(way, T) <= enough for way in ways)

    def are_at_an_edge(self, rows: FloatArray) -> bool:
        """Whether the arm is so singular at each of these that rounding may decide on them."""
        return all(self.measures.fixed(row) <= TOLERANCES.distinct for row in rows)

    def nearest(self, found: FloatArray, q: FloatArray, where: str) -> None:
        """The generating joint values are the nearest to themselves."""
        miss = float(np.abs(found - q).max()) / max(1.0, self._chain.size)
        self.at_most(miss, FOUND, f"{where} is off")

    def arm_angle(self, angles: FloatArray, asked: FloatArray, where: str) -> None:
        """Arm angles are the one that was asked for."""
        miss = float(np.abs(np.remainder(angles - asked + np.pi, 2.0 * np.pi) - np.pi).max())
        self.at_most(miss, FOUND, f"{where}: an arm angle is off")

    def values(self, q: FloatArray) -> FloatArray:
        """The values of free joints, or the arm angle, (..., k)."""
        return given_values(self.measures.arm, q)

    def given(self, q: FloatArray) -> list[FloatArray]:
        """The argument for them, where there are any."""
        return [self.values(q)] if self._chain.given else []

    def _all_at_most(self, misses: FloatArray, enough: float, q: FloatArray, what: str) -> None:
        """The misses at joint values (N, n) are small enough."""
        worst = int(np.argmax(np.where(np.isnan(misses), np.inf, misses)))
        self.at_most(float(misses[worst]), enough, f"{what} at q = {q[worst].tolist()}")

    def at_most(self, miss: float, enough: float, what: str) -> None:
        """A miss is small enough."""
        if not miss <= enough:
            raise VerificationError(f"{what} by {miss:.1e}")
