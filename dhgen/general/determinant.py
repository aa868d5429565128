"""The equations and the determinant of the hidden joint, and the null vectors where it vanishes.

The six equations, times the half-angle tangent x3 of one partner and as they are, are twelve
equations in the twelve products x3^i x2^j, i = 0 ... 3, j = 0 ... 2. With A2, A1, A0 the 6x3 blocks
of x3², x3, 1 the matrix is [A2 A1 A0 0; 0 A2 A1 A0]. Reflections fold it twice, to 6x6, without a
division that could fail. All arrays have the angles on their last axis ("lanes"), and everything
is done element by element, so that rounding is the same on every machine.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.hidden_slide import on_circle
from dhgen.general.monomials import MONOMIALS, act, slide, start, turn

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray


EQUATIONS = 6
TINY = 1e-300  # keeps the reflection of a zero column finite; it then changes nothing


def inverses(K: FloatArray) -> FloatArray:
    """The inverses of rigid transforms (..., 4, 4)."""
    result = np.zeros_like(K)
    result[..., 3, 3] = 1.0
    for i in range(3):
        x = [K[..., j, i] for j in range(3)]
        result[..., i, 3] = -(x[0] * K[..., 0, 3] + x[1] * K[..., 1, 3] + x[2] * K[..., 2, 3])
        for j in range(3):
            result[..., i, j] = x[j]
    return result


def equations(links: Sequence[FloatArray], slides: Sequence[bool]) -> FloatArray:
    """The six equations of a formulation.

    Args:
        links: L0 ... L5, (N, 4, 4) each, in arm sizes.
        slides: Which of φ1 ... φ6 is a length; not the fourth.

    Returns:
        (3, 6, 3, 3, N): the coefficients by 1, c1, s1, equation, x3², x3, 1 and x2², x2, 1 with
        x = tan(φ/2), or x = d where the joint slides; all times (1 + x²) for every turn. Where the
        first is a length, c1 and s1 belong to the angle that represents it.
    """
    K = [np.moveaxis(link, 0, -1) for link in links]
    count = K[0].shape[-1]
    right = start(count)
    for link, slides_here in ((links[3], slides[4]), (links[4], slides[5])):
        right = act(np.moveaxis(inverses(link), 0, -1), right)
        right = _spread(right, slide(right) if slides_here else turn(right))
    left = left_side([K[0], K[1], K[2], K[5]], slides)
    both = np.empty((MONOMIALS - 1, 8 + 27, count))
    both[:, :8] = right[1:, 1:]
    # the constant column of the right side goes over to the left, times every (1 + x²)
    both[:, 8:] = left[1:] - right[1:, :1] * left[:1]
    for column in range(8):
        reflect(both[column:], column)
    rows = both[8:, 8:].reshape(EQUATIONS, 3, 3, 3, -1)  # equation, φ1, φ2, φ3
    return rows.transpose(1, 0, 3, 2, 4)


def left_side(K: Sequence[FloatArray], slides: Sequence[bool]) -> FloatArray:
    """The monomials of the left side by 1, c1, s1, then x2², x2, 1, then x3², x3, 1: (15, 27, N).

    Args:
        K: L0, L1, L2 and L5, (4, 4, N) each, in arm sizes.
        slides: Which of φ1, φ2, φ3 is a length.
    """
    left = start(K[0].shape[-1])
    for at in (2, 1):
        left = act(K[at], left)
        left = _spread(left, _powers(left, slides=slides[at]))
    left = act(K[0], left)
    return act(K[3], _spread(left, on_circle(left) if slides[0] else turn(left)))


def _powers(x: FloatArray, *, slides: bool) -> FloatArray:
    """The coefficients of x², x and 1 instead of 1, cos φ, sin φ or 1, d, d²."""
    if slides:
        return slide(x)[::-1]
    one, cosine, sine = turn(x)
    return np.stack([one - cosine, 2.0 * sine, one + cosine])


def _spread(x: FloatArray, parts: FloatArray) -> FloatArray:
    """Three columns for each column of monomials: (15, 3 k, N), the joint's own index first."""
    return np.swapaxes(parts, 0, 1).reshape(MONOMIALS, 3 * x.shape[1], -1)


def reflect(rows: FloatArray, column: int) -> None:
    """Reflect rows (m, n, N) so that below the first one, `column` becomes zero; in place.

    Columns before it are left alone: they have to be zero already.
    """
    axis = rows[:, column].copy()
    square = axis[0] * axis[0]
    for x in axis[1:]:
        square = square + x * x
    length = np.copysign(np.sqrt(square), axis[0])
    axis[0] += length
    factor = 1.0 / (length * axis[0] + TINY)
    others = rows[:, column + 1 :]
    total = axis[0] * others[0]
    for x, row in zip(axis[1:], others[1:], strict=True):
        total += x * row
    total *= factor
    for i, x in enumerate(axis):
        others[i] -= x * total
    rows[0, column] = -length
    rows[1:, column] = 0.0


def fold(E: FloatArray, cosine: FloatArray, sine: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The determinant and what it was read off.

    Args:
        E: The equations, (3, 6, 3, 3, N) or with a last axis of 1.
        cosine: Of the hidden angle, (N,).
        sine: The same.

    Returns:
        The determinant (N,), and the upper triangular 6x6 factor (6, 6, N) whose null vectors are
        (x3, 1) ⊗ (x2², x2, 1).
    """
    M = (E[0] + E[1] * cosine + E[2] * sine).reshape(EQUATIONS, 9, -1)
    for column in range(3):
        reflect(M[column:], column)
    determinant = M[0, 0] * M[1, 1] * M[2, 2]
    # [A2; ...] is now [R B1 B0; 0 D1 D0]: the second shift has R under D1
    upper, lower = M[:3], M[3:]
    N = M.shape[-1]
    work = np.zeros((6, 9, N))
    work[:3] = upper
    work[3:, :3], work[3:, 3:6] = lower[:, 3:6], lower[:, 6:9]
    for column in range(3):
        rows = work[[column, 3, 4, 5]]
        reflect(rows, column)
        work[[column, 3, 4, 5]] = rows
        determinant = determinant * work[column, column]
    factor = np.zeros((6, 6, N))
    factor[:3] = work[3:, 3:]
    factor[3:] = lower[:, 3:9]
    for column in range(5):
        reflect(factor[column:], column)
    for i in range(6):
        determinant = determinant * factor[i, i]
    return determinant, factor
