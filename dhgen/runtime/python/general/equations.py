# SPDX-License-Identifier: MIT
"""The six equations of a formulation, and their determinant at many hidden angles at once."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import carray, of_file, room
from ..rigid import invert
from .loop import TINY, reflect
from .places import HIDDEN_SLIDE, LEFT_SLIDE, SLIDES
from .tables import SAMPLES

if TYPE_CHECKING:
    from ..arrays import Floats, Ints

OWN = of_file(__file__)
apart, inner, merged = OWN.apart, OWN.inner, OWN.merged


UNIT = 2.5  # length of a hidden slide at a quarter of a turn, about how far slides go [arm sizes]
SQUARE = UNIT * UNIT
# Cosine and sine of what is added to the angle of a length: half of the way from one sample angle
# to the next, nearly, so that no sample is an infinite length.
COSINE, SINE = 112 / 113, 15 / 113


@apart("void(float64[::1], float64[:, ::1])")
def act(K: Floats, x: Floats) -> None:
    """Moves monomials of a point p and a direction l by a rigid motion, in place, column by column.

    They are 1, l, p, p.p, p.l, p x l and (p.p) l - 2 (p.l) p: 15 numbers.
    """
    t0, t1, t2 = K[3], K[7], K[11]
    square = t0 * t0 + t1 * t1 + t2 * t2
    for k in range(x.shape[1]):
        for at in (1, 4, 9, 12):
            a, b, c = x[at, k], x[at + 1, k], x[at + 2, k]
            for i in range(3):
                x[at + i, k] = K[4 * i] * a + K[4 * i + 1] * b + K[4 * i + 2] * c
        u0, u1, u2, q0, q1, q2 = x[1, k], x[2, k], x[3, k], x[4, k], x[5, k], x[6, k]
        v0, v1, v2, one = x[9, k], x[10, k], x[11, k], x[0, k]
        along = t0 * u0 + t1 * u1 + t2 * u2
        x[7, k] += 2.0 * (t0 * q0 + t1 * q1 + t2 * q2) + square * one
        x[8, k] += along
        twice = 2.0 * x[8, k]
        x[4, k] += t0 * one
        x[5, k] += t1 * one
        x[6, k] += t2 * one
        x[9, k] += t1 * u2 - t2 * u1
        x[10, k] += t2 * u0 - t0 * u2
        x[11, k] += t0 * u1 - t1 * u0
        x[12, k] += square * u0 - twice * t0 - 2.0 * (t1 * v2 - t2 * v1)
        x[13, k] += square * u1 - twice * t1 - 2.0 * (t2 * v0 - t0 * v2)
        x[14, k] += square * u2 - twice * t2 - 2.0 * (t0 * v1 - t1 * v0)


@inner
def _slid(arm: Floats, x: Floats, to: Floats) -> None:
    """Computes what a slide's length makes of monomials: the coefficients of its powers.

    Powers of a partner are in the order d^2, d, 1, others in the order 1, d, d^2.
    """
    n = x.shape[1]
    one = 2 * n if arm[LEFT_SLIDE] > 0.0 else 0
    two = 2 * n - one
    for k in range(n):
        square, first = to[:, two + k], to[:, n + k]
        for i in range(15):
            to[i, one + k] = x[i, k]
        first[6], square[7] = x[0, k], x[0, k]
        first[7], first[8], first[9], first[10] = 2.0 * x[6, k], x[3, k], -x[2, k], x[1, k]
        first[12], first[13], first[14] = 2.0 * x[10, k], -2.0 * x[9, k], -2.0 * x[8, k]
        square[12], square[13], square[14] = x[1, k], x[2, k], -x[3, k]
        if arm[HIDDEN_SLIDE] > 0.0:
            # by 1, cos and sin of psi instead, where d = UNIT tan(psi'/2), times 1 + cos psi'; psi'
            # is psi and an advance
            for i in range(15):
                constant, sine = x[i, k], UNIT * first[i]
                cosine = constant - SQUARE * square[i]
                to[i, k] = constant + SQUARE * square[i]
                first[i] = COSINE * cosine + SINE * sine
                square[i] = COSINE * sine - SINE * cosine


@apart("float64[:, ::1](float64[::1], float64[::1], float64[:, ::1], int64, boolean)")
def pass_link(arm: Floats, K: Floats, x: Floats, joint: int, powers: bool) -> Floats:
    """Returns monomials behind a link and the joint before it, three columns for each of them.

    They are the coefficients of 1, cos and sin of the joint's angle, or with `powers` of y^2, y and
    1 for y = tan(phi/2), times 1 + y^2, or for the length of a slide. Column a columns + k is part
    a of column k.
    """
    n = x.shape[1]
    act(K, x)
    to = np.zeros((15, 3 * n))
    if arm[SLIDES + joint] > 0.0:
        _slid(arm, x, to)
        return to
    for i in range(15):
        for k in range(n):
            to[i, k] = x[i, k]
    for at in (1, 4, 9, 12):
        for k in range(n):
            to[at, k] = to[at + 1, k] = 0.0
            to[at, n + k] = to[at + 1, 2 * n + k] = x[at, k]
            to[at + 1, n + k] = x[at + 1, k]
            to[at, 2 * n + k] = -x[at + 1, k]
    if powers:
        for i in range(15):
            for k in range(n):
                one, cosine, sine = to[i, k], to[i, n + k], to[i, 2 * n + k]
                to[i, k], to[i, n + k], to[i, 2 * n + k] = one - cosine, 2.0 * sine, one + cosine
    return to


@apart("float64[:, ::1](float64[::1], int64[::1], float64[:, ::1])")
def equations(arm: Floats, joints: Ints, links: Floats) -> Floats:
    """Returns the six equations of a formulation.

    Columns 9 a + 3 j + i belong to 1, c1, s1 (a), the powers x3^2, x3, 1 (i) and x2^2, x2, 1 (j) of
    the partners' half-angle tangents or lengths.
    """
    right, left = np.zeros((15, 1)), np.zeros((15, 1))
    right[0, 0] = right[3, 0] = left[0, 0] = left[3, 0] = 1.0  # the origin and z
    for i in (3, 4):
        right = pass_link(arm, invert(links[i]), right, joints[i + 1], False)
    for i in (2, 1, 0):
        left = pass_link(arm, links[i], left, joints[i], i > 0)
    act(links[5], left)
    work = np.empty((14, 35))
    for i in range(14):
        for k in range(8):
            work[i, k] = right[1 + i, 1 + k]
        for k in range(27):
            # the constant column of the right side, times 1 + x2^2 and 1 + x3^2
            work[i, 8 + k] = left[1 + i, k] - right[1 + i, 0] * left[0, k]
    for column in range(8):
        reflect(work, column, column + 1, column)
    E = np.empty((6, 27))
    for i in range(6):
        for k in range(27):
            E[i, k] = work[8 + i, 8 + k]
    return E


@merged
def _reflect_all(
    M: Floats, columns: int, first: int, rest: int, column: int, determinant: Floats
) -> None:
    """Reflects, at all angles at once, the first row and the rows from `rest` on.

    That clears `column` in the rows from `rest` on, where its entries are not written.
    """
    head = carray(room(SAMPLES), SAMPLES)
    factor = carray(room(SAMPLES), SAMPLES)
    for k in range(SAMPLES):
        square = M[first, column, k] * M[first, column, k]
        for i in range(rest, 6):
            square += M[i, column, k] * M[i, column, k]
        length = math.copysign(math.sqrt(square), M[first, column, k])
        head[k] = M[first, column, k] + length
        factor[k] = 1.0 / (length * head[k] + TINY)
        determinant[k] *= -length
        M[first, column, k] = -length
    for j in range(column + 1, columns):
        for k in range(SAMPLES):
            total = head[k] * M[first, j, k]
            for i in range(rest, 6):
                total += M[i, column, k] * M[i, j, k]
            total *= factor[k]
            M[first, j, k] -= head[k] * total
            for i in range(rest, 6):
                M[i, j, k] -= M[i, column, k] * total


@apart("float64[:, :, ::1](float64[:, ::1], float64[::1], float64[::1], float64[::1])")
def fold(E: Floats, c: Floats, s: Floats, determinant: Floats) -> Floats:
    """Returns upper triangular matrices (6, 6, 24) whose null vectors are (x3, 1) x (x2^2, x2, 1).

    One for each of 24 hidden angles; their determinants go to the last argument. With A2, A1, A0
    the blocks of x3^2, x3, 1 the matrix is [A2 A1 A0 0; 0 A2 A1 A0]; reflections fold it to 9x9 and
    to 6x6. Each reflection is written out: with its rows known the loops over angles become
    vectors.
    """
    M, W, factor = np.empty((6, 9, SAMPLES)), np.zeros((6, 9, SAMPLES)), np.empty((6, 6, SAMPLES))
    for r in range(6):
        for j in range(9):
            at = 3 * (j % 3) + j // 3
            one, cosine, sine = E[r, at], E[r, 9 + at], E[r, 18 + at]
            for k in range(SAMPLES):
                M[r, j, k] = one + cosine * c[k] + sine * s[k]
    for k in range(SAMPLES):
        determinant[k] = 1.0
    _reflect_all(M, 9, 0, 1, 0, determinant)
    _reflect_all(M, 9, 1, 2, 1, determinant)
    _reflect_all(M, 9, 2, 3, 2, determinant)
    # now M is [R B1 B0; 0 D1 D0]; the other shift has R B1 B0 under D1 D0 0
    for r in range(3):
        for j in range(9):
            for k in range(SAMPLES):
                W[r, j, k] = M[r, j, k]
        for j in range(6):
            for k in range(SAMPLES):
                W[3 + r, j, k] = factor[3 + r, j, k] = M[3 + r, 3 + j, k]
    _reflect_all(W, 9, 0, 3, 0, determinant)
    _reflect_all(W, 9, 1, 3, 1, determinant)
    _reflect_all(W, 9, 2, 3, 2, determinant)
    for r in range(3):
        for j in range(6):
            for k in range(SAMPLES):
                factor[r, j, k] = W[3 + r, 3 + j, k]
    _reflect_all(factor, 6, 0, 1, 0, determinant)
    _reflect_all(factor, 6, 1, 2, 1, determinant)
    _reflect_all(factor, 6, 2, 3, 2, determinant)
    _reflect_all(factor, 6, 3, 4, 3, determinant)
    _reflect_all(factor, 6, 4, 5, 4, determinant)
    for k in range(SAMPLES):
        determinant[k] *= factor[5, 5, k]
    return factor


@inner
def nearness(c: float, s: float) -> float:
    """Returns 1 + cos psi', which vanishes where the length of a hidden slide is infinite."""
    return 1.0 + COSINE * c - SINE * s


@inner
def hidden_length(c: float, s: float) -> float:
    """Returns the length of a hidden slide from cosine and sine of psi."""
    above = nearness(c, s)
    sine = SINE * c + COSINE * s
    return UNIT * sine * above / (above * above + TINY)


@inner
def independence(E: Floats, c: float, s: float) -> float:
    """Returns how far the columns that are cleared first are from depending on each other.

    The square of the least singular value of A2 over that of the norm of [A2 A1 A0], or a third of
    it, from determinant and minors of A2' A2. Where x3 is nearly infinite they do depend on each
    other if the matrix is singular, and the factor does not show it.
    """
    A, G, squares = np.empty((6, 3)), np.zeros((3, 3)), 0.0
    for r in range(6):
        for k in range(9):
            x = E[r, k] + E[r, 9 + k] * c + E[r, 18 + k] * s
            squares += x * x
            if k % 3 == 0:
                A[r, k // 3] = x
    for r in range(6):
        for i in range(3):
            for j in range(3):
                G[i, j] += A[r, i] * A[r, j]
    first = G[1, 1] * G[2, 2] - G[1, 2] * G[1, 2]
    minors = first + G[0, 0] * G[2, 2] - G[0, 2] * G[0, 2] + G[0, 0] * G[1, 1] - G[0, 1] * G[0, 1]
    det = G[0, 0] * first - G[0, 1] * (G[0, 1] * G[2, 2] - G[1, 2] * G[0, 2])
    det += G[0, 2] * (G[0, 1] * G[1, 2] - G[1, 1] * G[0, 2])
    return det / (minors * squares + TINY)
