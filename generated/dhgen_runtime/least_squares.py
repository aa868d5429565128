# SPDX-License-Identifier: MIT
"""Damped least squares: of a few equations that may have no solution, or many."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from .jit import of_file

if TYPE_CHECKING:
    from .arrays import Floats

OWN = of_file(__file__)


@OWN.apart("void(float64[:, ::1], float64, float64[::1], float64[::1])")
def least_squares(A: Floats, damping: float, y: Floats, x: Floats) -> None:
    """Computes x = A' (A A' + damping)^-1 y.

    The rows of A, each with its share of the damping's root behind it, are made orthonormal one
    after another (modified Gram-Schmidt; used as by A. Bjorck, Numerics of Gram-Schmidt
    orthogonalization, 1994): the product A A' would lose half of the digits.
    """
    equations, unknowns = A.shape
    width = equations + unknowns
    rows, right = np.zeros((equations, width)), np.empty(equations)
    total = np.zeros(width)
    for i in range(equations):
        for j in range(unknowns):
            rows[i, j] = A[i, j]
        rows[i, unknowns + i] = math.sqrt(damping)
        right[i] = y[i]
        for k in range(i):
            along = 0.0
            for j in range(width):
                along += rows[k, j] * rows[i, j]
            for j in range(width):
                rows[i, j] -= along * rows[k, j]
            right[i] -= along * right[k]
        square = 0.0
        for j in range(width):
            square += rows[i, j] * rows[i, j]
        inverse = 1.0 / math.sqrt(square)
        right[i] *= inverse
        for j in range(width):
            rows[i, j] *= inverse
    for i in range(equations - 1, -1, -1):
        missing = right[i]
        for j in range(width):
            missing -= rows[i, j] * total[j]
        for j in range(width):
            total[j] += missing * rows[i, j]
    for j in range(unknowns):
        x[j] = total[j]
