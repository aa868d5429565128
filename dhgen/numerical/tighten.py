"""Rows of a closed form whose last digits are wrong: Gauss-Newton on the whole miss of the pose.

A row is taken from some of the pose's entries only. Where an angle comes from a short vector, or
from roots that nearly meet, it is good to few digits, and the entries that were not read say so.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.numerical import kernel as constants
from dhgen.numerical.miss import miss
from dhgen.numerical.reference import damped_step
from dhgen.program.tolerances import TOLERANCES

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.numerical.kernel import NumericalKernel

    FloatArray = NDArray[np.float64]


def tighten(kernel: NumericalKernel, T: FloatArray, q: FloatArray) -> FloatArray:
    """The rows of a pose where damped least squares lead; exact ones stay as they are.

    Where the pose may be one that the arm cannot take, rows that can't be made exact stay, too: the
    pose may have been rounded. Those that do not fit are NaN; if one is exact the pose has not been
    rounded, and all have to be exact. So are those that were moved to where others are.

    Args:
        kernel: The arm.
        T: Pose (4, 4); entries that the task does not name are ignored.
        q: Joint values (N, n), NaN where there is no solution; given joints stay as they are.
    """
    exact = _exact(kernel, T)
    rows = q.copy()
    misses, moved = np.full(len(q), np.inf), np.zeros(len(q), dtype=bool)
    for place in np.flatnonzero(~np.isnan(q).any(axis=1)):
        rows[place], misses[place] = _tightened(kernel, T, q[place], exact)
        moved[place] = bool((rows[place] != q[place]).any())
    if kernel.checked:
        rounded = misses.min(initial=np.inf) > exact
        rows[misses > (kernel.residual if rounded else exact)] = np.nan
    for place in np.flatnonzero(moved):
        if _repeats(kernel, rows, moved, int(place)):
            rows[place] = np.nan
    return rows


def _repeats(kernel: NumericalKernel, q: FloatArray, moved: NDArray[np.bool_], place: int) -> bool:
    """Whether a row that was moved came to lie on another."""
    others = ~moved | (np.arange(len(q)) < place)
    others[place] = False
    gaps = (q[others] - q[place])[:, list(kernel.solved)] / np.array(kernel.units)
    turns = np.array(kernel.turns)
    gaps = np.where(turns, gaps - 2 * np.pi * np.ceil(gaps / (2 * np.pi) - 0.5), gaps)
    return bool((np.abs(gaps) < constants.SAME).all(axis=1).any())


def _exact(kernel: NumericalKernel, T: FloatArray) -> float:
    """What an exact row may miss [arm sizes, rad]: far away rounding is more."""
    distance = np.abs(T[list(kernel.position), 3]).max(initial=0.0) / kernel.arm.chain.size
    return TOLERANCES.exact * max(1.0, float(distance))


def _tightened(
    kernel: NumericalKernel, T: FloatArray, q: FloatArray, exact: float
) -> tuple[FloatArray, float]:
    """A row (n,) and by how much it misses the pose [arm sizes, rad]."""
    solved, units = list(kernel.solved), np.array(kernel.units)
    best, least, there = q.copy(), np.inf, q.copy()
    for _ in range(constants.TIGHTENINGS + 1):
        e, length, A = miss(kernel, T, there[None])
        slow = not length[0] <= 0.5 * least
        if length[0] < least:
            least, best = float(length[0]), there.copy()
        if slow or least <= exact:
            break
        there[solved] += units * damped_step(e, length, A)[0]
    first = float(miss(kernel, T, q[None])[1][0])
    if kernel.checked and least > exact:
        return q, first  # the pose is rounded, or this is no solution
    turning = [place for place, turns in zip(solved, kernel.turns, strict=True) if turns]
    best[turning] -= 2 * np.pi * np.ceil(best[turning] / (2 * np.pi) - 0.5)
    return best, least
