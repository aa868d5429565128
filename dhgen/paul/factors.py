"""Polynomials in the joints and the entries of their pose: where they vanish together.

Such places are found by trying: descents (Gauss-Newton, J. Nocedal and S. Wright, Numerical
Optimization, 2006, section 10.3) from random joint values, the same ones at every run.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.paul.pose_values import PoseValues
from dhgen.paul.samples import Sums
from dhgen.paul.zeros import values_at

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.pool import Pool

STARTS = 8
ITERATIONS = 40
LONGEST = 0.5  # of a descent's steps [rad or arm sizes]
DIFFERENCE = 1e-7  # of the joints, for slopes
NO_SLOPE = 1e-6  # of the steepest one: a direction that does not count
FLAT = 1e-5  # a slope in usual sizes that is one of rounding, or of differences
ZERO = 1e-12  # of their usual sizes


class Factors:
    """Some polynomials, in their usual sizes, as functions of angles and lengths (dof, n).

    Lengths count in arm sizes.
    """

    def __init__(self, pool: Pool, polynomials: Sequence[Polynomial]) -> None:
        """Makes them and the pose ready for many places."""
        self._algebra = pool.problem.algebra
        self._pose = PoseValues(pool)
        self._sums = Sums(polynomials)
        source, dof = np.random.default_rng(31), self._algebra.chain.dof
        self._starts, usual = source.uniform(-3.0, 3.0, (2, dof, STARTS))
        self._usual = np.max(np.abs(self._at(usual)), axis=1)

    def zeros(self) -> FloatArray:
        """Some places where all vanish, (dof, n)."""
        q = self._starts
        for _ in range(ITERATIONS):
            missed, slopes = self._with_slopes(q)
            if np.all(np.abs(missed) < ZERO):
                break
            step = (np.linalg.pinv(slopes, rcond=NO_SLOPE) @ missed[..., None])[..., 0]
            longest = np.abs(step).max(axis=1, keepdims=True)
            q = q - (step * np.minimum(1.0, LONGEST / np.maximum(longest, LONGEST))).T
        return np.asarray(q[:, np.all(np.abs(missed) < ZERO, axis=1)])

    def conditions(self, q: FloatArray) -> int:
        """How many conditions make them vanish: the least rank of slopes at zeros (dof, n)."""
        return int(np.linalg.matrix_rank(self._with_slopes(q)[1], tol=FLAT).min())

    def _with_slopes(self, q: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Values (n, polynomials) and their slopes (n, polynomials, dof)."""
        dof, places = q.shape
        aside = np.concatenate([np.zeros((dof, 1)), DIFFERENCE * np.eye(dof)], axis=1)
        around = (q[:, :, None] + aside[:, None]).reshape(dof, -1)
        values = (self._at(around) / self._usual[:, None]).reshape(len(self._usual), places, -1)
        slopes = (values[..., 1:] - values[..., :1]) / DIFFERENCE
        return values[..., 0].T, np.moveaxis(slopes, 1, 0)

    def _at(self, q: FloatArray) -> FloatArray:
        """Values (polynomials, n), as they are."""
        values = values_at(self._algebra, q)
        self._pose.fill(values)
        return self._sums(values)
