"""Rows of a closed form whose last digits are wrong: Gauss-Newton on the whole miss of the pose.

A row is taken from some of the pose's entries only. Where an angle comes from a short vector, or
from roots that nearly meet, it is good to few digits, and the entries that were not read say so.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.numerical import kernel as constants
from dhgen.numerical.miss import miss
from dhgen.numerical.reference import damped_step, shortened
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.numerical.kernel import NumericalKernel

    FloatArray = NDArray[np.float64]


def tighten(kernel: NumericalKernel, T: FloatArray, q: FloatArray, psi: float = 0.0) -> FloatArray:
    """The rows of a pose where damped least squares lead; exact ones stay as they are.

    Those that miss the pose then are NaN: they were a little out of reach, and are by themselves.
    Where the pose may be one that the arm cannot take, rows that can't be made exact stay as they
    were if they fit, for the pose may have been rounded; if one is exact it has not been, and all
    have to be exact. So are those NaN that were moved to where others are.

    Args:
        kernel: The arm.
        T: Pose (4, 4); entries that the task does not name are ignored.
        q: Joint values (N, n), NaN where there is no solution; given joints stay as they are.
        psi: The arm angle, where the caller gives it.
    """
    exact = exactness(kernel, T)
    rows = q.copy()
    misses, moved = np.full(len(q), np.inf), np.zeros(len(q), dtype=bool)
    first = misses.copy()
    for place in np.flatnonzero(~np.isnan(q).any(axis=1)):
        first[place] = _missed(kernel, T, q[place])
        rows[place], misses[place] = _tightened(kernel, T, q[place], exact, psi)
        moved[place] = bool((rows[place] != q[place]).any())
    rows[misses > _enough(kernel, misses, exact)] = np.nan
    for place in np.flatnonzero(moved):
        if _repeats(kernel, rows, first, int(place)):
            rows[place] = np.nan
    return rows


def _enough(kernel: NumericalKernel, misses: FloatArray, exact: float) -> float:
    """What rows that miss a pose by so much may miss [arm sizes, rad]."""
    if not kernel.checked:
        return constants.LOOSE * exact
    return exact if misses.min(initial=np.inf) <= exact else kernel.residual


def _repeats(kernel: NumericalKernel, q: FloatArray, first: FloatArray, place: int) -> bool:
    """Whether a row that was moved came to lie on one that missed by less at first."""
    tied = (first == first[place]) & (np.arange(len(q)) < place)
    others = (first < first[place]) | tied
    return bool((gaps(kernel, q[others], q[place]) < constants.SAME).any())


def gaps(kernel: NumericalKernel, q: FloatArray, row: FloatArray) -> FloatArray:
    """By how much joint values (N, n) differ from others (n,) at most [rad, arm sizes]."""
    found = (q - row)[:, list(kernel.solved)] / np.array(kernel.units)
    turns = np.array(kernel.turns)
    found = np.where(turns, found - 2 * np.pi * np.ceil(found / (2 * np.pi) - 0.5), found)
    return np.asarray(np.abs(found).max(axis=1, initial=0.0))


def exactness(kernel: NumericalKernel, T: FloatArray) -> float:
    """What an exact row may miss [arm sizes, rad]: far away rounding is more."""
    distance = np.abs(T[list(kernel.position), 3]).max(initial=0.0) / kernel.arm.chain.size
    return TOLERANCES.exact * max(1.0, float(distance))


@dataclass(frozen=True, slots=True)
class End:
    """Where steps from a row lead.

    Attributes:
        q: Joint values (n,), angles in (-pi, pi].
        miss: By how much they miss the pose [arm sizes, rad].
        ahead: How long another step would be [rad, arm sizes].
    """

    q: FloatArray
    miss: float
    ahead: float

    def solves(self, exact: float) -> bool:
        """Whether this is a solution.

        Beside a singular place joint values may miss a pose by next to nothing and be far from any.
        """
        return self.miss <= exact and self.ahead <= constants.SURE


def descended(
    kernel: NumericalKernel,
    T: FloatArray,
    q: FloatArray,
    exact: float,
    steps: int = constants.TIGHTENINGS,
    psi: float = 0.0,
) -> End:
    """Takes a row (n,) as far as steps of damped least squares help.

    Half of the square of a step may be left by the curvature of the motion. Beside a singular place
    a step that is right may be long, and what it leaves far more than was missed.
    """
    solved, units = list(kernel.solved), np.array(kernel.units)
    best, least, there, ahead = q.copy(), np.inf, q.copy(), np.inf
    last, left = np.inf, 0.0  # the miss before a step, and what its curvature leaves
    for _ in range(steps + 1):
        e, length, A = miss(kernel, T, there[None], psi)
        step = damped_step(e, length, A, constants.FINE)[0]
        slow = not length[0] <= max(0.5 * last, left)
        if length[0] < least:
            least, best = float(length[0]), there.copy()
            ahead = float(np.abs(step).max())
        if slow or (least <= constants.SPARE * exact and ahead <= constants.SURE):
            break
        step = shortened(step)
        last, left = float(length[0]), 0.5 * float(np.abs(step).sum()) ** 2
        there[solved] += units * step
    turning = [place for place, turns in zip(solved, kernel.turns, strict=True) if turns]
    best[turning] -= 2 * np.pi * np.ceil(best[turning] / (2 * np.pi) - 0.5)
    return End(best, least, ahead)


def _missed(kernel: NumericalKernel, T: FloatArray, q: FloatArray) -> float:
    """By how much a row (n,) misses the pose [arm sizes, rad]: its arm angle is right."""
    return float(np.linalg.norm(miss(kernel, T, q[None])[0][0, : kernel.entries]))


def _tightened(
    kernel: NumericalKernel, T: FloatArray, q: FloatArray, exact: float, psi: float
) -> tuple[FloatArray, float]:
    """A row (n,) and by how much it misses the pose [arm sizes, rad]."""
    first = _missed(kernel, T, q)
    if first <= exact:
        return q, first
    turned = miss(kernel, T, q[None], psi)[0][0, kernel.entries :]
    if (np.abs(turned) > TOLERANCES.doubtful).any():
        return q, np.inf  # out of reach: it was not led here by rounding
    end = descended(kernel, T, q, exact, psi=psi)
    if kernel.checked and end.miss > exact:
        return q, first  # the pose is rounded, or this is no solution
    return end.q, end.miss
