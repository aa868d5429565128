"""The determinant of the hidden joint, and the null vectors where it vanishes.

The six equations, times the half-angle tangent x3 of one partner and as they are, are twelve
equations in the twelve products x3^i x2^j, i = 0 ... 3, j = 0 ... 2. With A2, A1, A0 the 6x3 blocks
of x3², x3, 1 the matrix is [A2 A1 A0 0; 0 A2 A1 A0]. Reflections fold it twice, to 6x6, without a
division that could fail. All arrays have the angles on their last axis ("lanes"), and everything
is done element by element, so that rounding is the same on every machine.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.rigid import Matrix, inverse

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from dhgen.general.formulation import Formulation

    FloatArray = NDArray[np.float64]

EQUATIONS = 6
TINY = 1e-300  # keeps the reflection of a zero column finite; it then changes nothing


def pose_monomials(P: FloatArray, *, inverted: bool) -> FloatArray:
    """The 35 monomials (35, N) of poses (N, 4, 4) or of their inverses, as in `features`."""
    R, t = np.moveaxis(P[:, :3, :3], 0, -1), P[:, :3, 3].T
    if inverted:
        t = np.stack([-(R[0, j] * t[0] + R[1, j] * t[1] + R[2, j] * t[2]) for j in range(3)])
        R = np.swapaxes(R, 0, 1)
    square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2]
    back = [R[0, j] * t[0] + R[1, j] * t[1] + R[2, j] * t[2] for j in range(3)]
    flat = [R[i, j] for i in range(3) for j in range(3)]
    turned = [
        t[(i + 1) % 3] * R[(i + 2) % 3, j] - t[(i + 2) % 3] * R[(i + 1) % 3, j]
        for i in range(3)
        for j in range(3)
    ]
    mirrored = [square * R[i, j] - 2.0 * (t[i] * back[j]) for i in range(3) for j in range(3)]
    return np.stack([np.ones_like(square), *flat, *t, square, *back, *turned, *mirrored])


def equations(formulation: Formulation, P: FloatArray) -> FloatArray:
    """The six equations of poses P (N, 4, 4) in arm sizes: (3, 6, 3, 3, N), as in `Formulation`."""
    # forwards the loop contains P⁻¹; the right side contains the inverse of its links
    inverted = (formulation.sign > 0) != formulation.splits_each_pose
    values = pose_monomials(P, inverted=inverted)
    rows = _times(formulation.table, values)
    if not formulation.splits_each_pose:
        return rows.reshape(3, EQUATIONS, 3, 3, -1)
    right = rows.reshape(9, 14, -1)
    left = np.array(formulation.left).reshape(3, 3, 3, 14)
    both = np.empty((14, 8 + 27, len(P)))
    both[:, :8] = np.swapaxes(right[1:], 0, 1)
    both[:, 8:] = np.moveaxis(left, -1, 0).reshape(14, 27, 1)
    for i in (0, 2):
        for j in (0, 2):
            both[:, 8 + 3 * i + j] -= right[0]
    for column in range(8):
        reflect(both[column:], column)
    return np.swapaxes(both[8:, 8:].reshape(EQUATIONS, 3, 3, 3, -1), 0, 1)


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
    for j in range(column + 1, rows.shape[1]):
        total = axis[0] * rows[0, j]
        for x, row in zip(axis[1:], rows[1:, j], strict=True):
            total = total + x * row
        total = total * factor
        for i, x in enumerate(axis):
            rows[i, j] -= x * total
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


def _times(table: Sequence[Sequence[float]], values: FloatArray) -> FloatArray:
    """A constant matrix (m, k) times lanes (k, N), summed from the first to the last."""
    matrix = np.array(table)
    total = np.zeros((len(matrix), values.shape[1]))
    for k, value in enumerate(values):
        total += matrix[:, k : k + 1] * value
    return total


def as_array(K: Matrix, *, inverted: bool = False) -> FloatArray:
    """A rigid transform as an array."""
    return np.array(inverse(K) if inverted else K)
