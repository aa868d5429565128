"""Roots that nearly meet: the solutions to both sides of a row.

Beside a place where a joint would be free two solutions may differ in that joint by anything and
in all others by next to nothing. Their root is a double one but for a billionth of its square,
which is beyond the digits of the polynomial; a row of the root between them is not exact, and its
free joint has nothing to do with theirs. Steps from there lead to one of them. The double root
lies in the middle of both: the row of a root as far to its other side leads to the other one.

A row may have taken the seed's value for its root, where that is one as far as rounding tells. It
is then one of the two solutions, and hides the middle: the roots' own rows are asked for with a
seed that is turned away.
"""

from __future__ import annotations

from functools import partial
from itertools import islice
from typing import TYPE_CHECKING

import numpy as np

from dhgen.numerical import kernel as constants
from dhgen.numerical.descent import descended
from dhgen.numerical.tighten import exactness, gaps

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.numerical.kernel import NumericalKernel

    Moved = Callable[[FloatArray], FloatArray]
    Turning = tuple[tuple[int, int], ...]


def both_sides(
    kernel: NumericalKernel,
    T: FloatArray,
    q: FloatArray,
    close: NDArray[np.bool_],
    turning: Turning,
    moved: Moved,
) -> FloatArray:
    """The rows of a pose, with solutions for those that stand between two.

    Args:
        kernel: The arm.
        T: Pose (4, 4).
        q: Joint values (N, n), NaN where there is no solution.
        close: Which rows come from roots that nearly meet (N,).
        turning: The joints, from 1, whose values add up to the root, each with its sign.
        moved: The rows (M, N, n) with all roots moved by each of some angles (M,), for a seed
            that is turned away.
    """
    rows, exact = q.copy(), float(exactness(kernel, T))
    own = moved(np.zeros(1))[0]
    own = np.where(np.isnan(own).any(axis=1, keepdims=True), q, own)
    doubtful = [
        row
        for row in np.flatnonzero(close)
        if not descended(kernel, T, own[row], exact, steps=0).solves(exact)
    ]
    known = [q[row] for row in range(len(q)) if row not in doubtful and not np.isnan(q[row]).any()]
    news: list[FloatArray] = []
    for row in doubtful:
        at_row = partial(_moved, moved, int(row))
        for end in _ends(kernel, T, (q[row], own[row]), known, turning, at_row):
            rows[row] = np.nan
            if _is_new(kernel, [*known, *news], end):
                news.append(end)
    for end in news:
        spare = np.flatnonzero(np.isnan(rows).any(axis=1))
        if len(spare):  # whichever roots rounding told apart: the row that was nearest
            off = np.nan_to_num(gaps(kernel, q[spare], end), nan=np.inf)
            rows[spare[np.argmin(off)]] = end
    return rows


def _moved(moved: Moved, row: int, parts: tuple[float, ...], angle: float) -> FloatArray:
    """One row (M, n) with all roots moved by parts of an angle, where it is a row at all."""
    starts = moved(angle * np.array(parts))[:, row]
    return np.asarray(starts[~np.isnan(starts).any(axis=1)])


def _is_new(kernel: NumericalKernel, known: list[FloatArray], end: FloatArray) -> bool:
    return not (gaps(kernel, np.array(known).reshape(-1, len(end)), end) < constants.TOGETHER).any()


def _ends(
    kernel: NumericalKernel,
    T: FloatArray,
    row: tuple[FloatArray, FloatArray],
    known: list[FloatArray],
    turning: Turning,
    moved: Callable[[tuple[float, ...], float], FloatArray],
) -> Iterator[FloatArray]:
    """Where a row (n,) leads, and where it does when its root is moved to the other side.

    It comes with the root's own row. Those that are `known` belong to other roots: long steps may
    lead there.
    """
    q, own = row
    exact = float(exactness(kernel, T))

    def ends(starts: Iterable[FloatArray]) -> Iterator[FloatArray]:
        for start in starts:
            end = descended(kernel, T, start, exact)
            if end.solves(exact) and _is_new(kernel, known, end.q):
                yield end.q

    first = next(ends([q]), None)
    if first is None:
        first = next(ends(moved(constants.BESIDE, 1.0)), None)
    if first is None:
        return
    yield first
    off = sum(sign * (first[joint - 1] - own[joint - 1]) for joint, sign in turning)
    off -= 2 * np.pi * np.ceil(off / (2 * np.pi) - 0.5)
    others = ends(moved(constants.ACROSS, off))
    yield from islice((end for end in others if _is_new(kernel, [first], end)), 1)
