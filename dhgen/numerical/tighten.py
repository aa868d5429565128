"""Rows of a closed form whose last digits are wrong: Gauss-Newton on the whole miss of the pose.

A row is taken from some of the pose's entries only. Where an angle comes from a short vector, or
from roots that nearly meet, it is good to few digits, and the entries that were not read say so.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.numerical import kernel as constants
from dhgen.numerical.descent import descended, escaped
from dhgen.numerical.miss import miss, pose_miss
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.numerical.kernel import NumericalKernel


def tighten(kernel: NumericalKernel, T: FloatArray, q: FloatArray, psi: FloatArray) -> FloatArray:
    """The rows of poses where damped least squares lead; exact ones stay as they are.

    Those that miss the pose then are NaN: they were a little out of reach, and are by themselves.
    Where the pose may be one that the arm cannot take, rows that can't be made exact stay as they
    were if they fit, for the pose may have been rounded; if one is exact it has not been, and all
    have to be exact. So are those NaN that were moved to where others are.

    Args:
        kernel: The arm.
        T: Poses (N, 4, 4); entries that the task does not name are ignored.
        q: Joint values (N, B, n), NaN where there is no solution; given joints stay as they are.
        psi: The arm angles (N,), where the caller gives them.
    """
    told = np.asarray(~np.isnan(q).any(axis=-1))
    rows = np.where(told[..., None], q, np.nan)
    first = np.full(told.shape, np.inf)
    places = np.nonzero(told)
    first[places] = np.nan_to_num(_missed(kernel, T[places[0]], q[places]), nan=np.inf)
    exact = exactness(kernel, T)
    inexact = told & (first > exact[:, None])
    for k in np.flatnonzero(inexact.any(axis=1)):
        rows[k] = _led(kernel, T[k], rows[k], first[k], float(exact[k]), float(psi[k]))
    return rows


def _led(
    kernel: NumericalKernel,
    T: FloatArray,
    q: FloatArray,
    first: FloatArray,
    exact: float,
    psi: float,
) -> FloatArray:
    """The same of one pose's rows (B, n), by how much each misses being known."""
    rows, misses, moved = q.copy(), first.copy(), np.zeros(len(q), dtype=bool)
    for place in np.flatnonzero(np.isfinite(first) & (first > exact)):
        rows[place], misses[place] = _tightened(
            kernel, T, q[place], float(first[place]), exact, psi
        )
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


def exactness(kernel: NumericalKernel, T: FloatArray) -> FloatArray:
    """What exact rows of poses (..., 4, 4) may miss [arm sizes, rad]: far away rounding is more."""
    distance = np.abs(T[..., list(kernel.position), 3]).max(axis=-1, initial=0.0)
    return np.asarray(TOLERANCES.exact * np.maximum(1.0, distance / kernel.arm.chain.size))


def _missed(kernel: NumericalKernel, T: FloatArray, q: FloatArray) -> FloatArray:
    """By how much rows (N, n) miss their poses [arm sizes, rad]: their arm angles are right."""
    return np.asarray(np.linalg.norm(pose_miss(kernel, T, kernel.arm.pose(q)), axis=1))


def _tightened(
    kernel: NumericalKernel, T: FloatArray, q: FloatArray, first: float, exact: float, psi: float
) -> tuple[FloatArray, float]:
    """A row (n,) that is not exact, and by how much it misses the pose [arm sizes, rad]."""
    turned = miss(kernel, T, q[None], psi)[0][0, kernel.entries :]
    if (np.abs(turned) > TOLERANCES.doubtful).any():
        return q, np.inf  # out of reach: it was not led here by rounding
    if not kernel.checked:
        end = escaped(kernel, T, q, exact, psi)
        return end.q, end.miss
    end = descended(kernel, T, q, exact, psi=psi)
    # otherwise the pose is rounded, or this is no solution
    return (end.q, end.miss) if end.miss <= exact else (q, first)
