"""Roots that nearly meet: the solutions to both sides of a row.

Beside a place where a joint would be free two solutions may differ in that joint by anything and
in all others by next to nothing. Their root is a double one but for a billionth of its square,
which is beyond the digits of the polynomial; a row of the root between them is not exact, and its
free joint has nothing to do with theirs. Rows of roots a little to both sides lead there.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.numerical import kernel as constants
from dhgen.numerical.tighten import descended, exactness, gaps

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from numpy.typing import NDArray

    from dhgen.numerical.kernel import NumericalKernel

    FloatArray = NDArray[np.float64]


def both_sides(
    kernel: NumericalKernel,
    T: FloatArray,
    q: FloatArray,
    close: NDArray[np.bool_],
    moved: Callable[[FloatArray], FloatArray],
) -> FloatArray:
    """The rows of a pose, with solutions for those that stand between two.

    Args:
        kernel: The arm.
        T: Pose (4, 4).
        q: Joint values (N, n), NaN where there is no solution.
        close: Which rows come from roots that nearly meet (N,).
        moved: The rows (M, N, n) with all roots moved by each of some angles (M,).
    """
    rows, exact = q.copy(), exactness(kernel, T)
    doubtful = [
        row
        for row in np.flatnonzero(close)
        if not descended(kernel, T, q[row], exact, steps=0).solves(exact)
    ]
    if not doubtful:
        return rows
    starts = moved(np.array([angle for move in constants.MOVES for angle in (move, -move)]))
    known = [q[row] for row in range(len(q)) if row not in doubtful and not np.isnan(q[row]).any()]
    news: list[FloatArray] = []
    for row in doubtful:
        for end in _ends(kernel, T, starts[:, row], exact):
            rows[row] = np.nan
            others = np.array([*known, *news]).reshape(-1, len(end))
            if not (gaps(kernel, others, end) < constants.TOGETHER).any():
                news.append(end)
    spare = np.flatnonzero(np.isnan(rows).any(axis=1))
    for place, end in zip(spare, news, strict=False):
        rows[place] = end
    return rows


def _ends(
    kernel: NumericalKernel, T: FloatArray, starts: FloatArray, exact: float
) -> Iterator[FloatArray]:
    """Where a row leads when its root is moved: from joint values (M, n)."""
    for q in starts[~np.isnan(starts).any(axis=1)]:
        end = descended(kernel, T, q, exact)
        if end.solves(exact):
            yield end.q
