# SPDX-License-Identifier: MIT
"""Four turns and two slides: a polynomial of degree 4 in one of the turns, in closed form.

J(phi1) L0 J(phi2) L1 ... J(phi6) L5 = 1 with phi1 a turn. Slides leave directions alone: Rz(phi1) A
Rz Rz B Rz C Rz D = 1 for the rotations between the turns. With phi1 given, Rz N Rz = M =
A' Rz(-phi1) D', N = B Rz C. Both have the same entry zz, which gives the middle turn, a square
root; what turns N's third column and row to those of M are the others. The translation is linear in
the slides' lengths: the determinant of it and of their directions is zero. Numbers
x + y sqrt(delta), with delta the discriminant, are pairs of x and y.

`links` are L0 ... L5, `between` A, B, C and D: what is no rotation of these means nothing.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from ..rigid import follow
from .loop import TINY, unit
from .places import SLIDES

if TYPE_CHECKING:
    from ..arrays import Floats, Ints

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

# At a root the better branch is taken, and the other one too where its determinant is this small: a
# double root may be one of each.
NEARLY_FLAT = 1e-2
# Where the slides are parallel, and the translation is farther than this from being along them [arm
# sizes], they would have to reach to infinity: such roots belong to no solution, and arms at right
# angles have them always. Beside parallel slides a solution needs no longer ones than elsewhere.
ALONG = 1e-6
FARTHEST = 1e4  # times the sine between the slides: as far as they reach [arm sizes]
# Rounding over the size of the determinants, which are small where the slides are nearly parallel
# all around the circle: its root is how far a double root may be off.
MOVED = 1e-14
# Where the third turn's axis is parallel to the one before or behind it, the entry zz does not give
# this turn, and roots don't determine solutions: the square of the product of the sines between
# these axes.
NO_ANGLE = 1e-18
# Where the axes of the second and the fourth turn are parallel only the sum of these angles is
# known, and the third is a double root: the square of the sine between these axes.
ALIGNED = 1e-6
PARALLEL = 1e-30  # the square of what rounding leaves of the normal of slides that are parallel


@inner
def split_links(arm: Floats, joints: Ints, links: Floats, between: Floats) -> None:
    """Computes A, B, C and D of the links of a formulation."""
    turn = -1
    for i in range(6):
        if arm[SLIDES + joints[i]] > 0.0:
            follow(between[turn], links[i])
        else:
            turn += 1
            for k in range(12):
                between[turn, k] = links[i, k]


@inner
def shows_all(between: Floats, roots: Floats, counts: Ints) -> bool:
    """Whether every solution has a root, and every root determines its solution."""
    B, C = between[1], between[2]
    plain = bool((B[8] * B[8] + B[9] * B[9]) * (C[2] * C[2] + C[6] * C[6]) > NO_ANGLE)
    for double in range(2):
        for i in range(counts[double]):
            c, s = math.cos(roots[double, i]), math.sin(roots[double, i])
            plain = plain and _linkage(between, c, s)[1] > ALIGNED
    return plain


@inner
def _product(a: tuple[float, float], b: tuple[float, float], delta: float) -> tuple[float, float]:
    """Returns the product of two numbers x + y sqrt(delta)."""
    return a[0] * b[0] + delta * a[1] * b[1], a[0] * b[1] + a[1] * b[0]


@inner
def _linkage(between: Floats, c: float, s: float) -> tuple[float, float, Floats]:
    """Returns delta, a factor of the polynomial, and the cosines and sines (3, 2, 2) of turns."""
    A, B, C, D = between[0], between[1], between[2], between[3]
    M = np.empty((3, 3))
    for j in range(3):
        x, y = c * D[4 * j] + s * D[4 * j + 1], c * D[4 * j + 1] - s * D[4 * j]
        for i in range(3):
            M[i, j] = A[i] * x + A[4 + i] * y + A[8 + i] * D[4 * j + 2]
    b, a = B[8] * C[2] + B[9] * C[6], B[9] * C[2] - B[8] * C[6]
    q = a * a + b * b + TINY
    k = M[2, 2] - B[10] * C[10]
    w = M[0, 2] * M[0, 2] + M[1, 2] * M[1, 2] + TINY
    turns = np.empty((3, 2, 2))
    turns[1, 0, 0], turns[1, 0, 1] = b * k / q, -a / q
    turns[1, 1, 0], turns[1, 1, 1] = a * k / q, b / q
    for i in range(2):
        cosine, sine = turns[1, 0, i], turns[1, 1, i]
        one = 1.0 - i
        # third column and row of B Rz C
        x, y, z = C[2] * cosine - C[6] * sine, C[2] * sine + C[6] * cosine, C[10] * one
        column_x, column_y = B[0] * x + B[1] * y + B[2] * z, B[4] * x + B[5] * y + B[6] * z
        x, y, z = B[8] * cosine + B[9] * sine, B[9] * cosine - B[8] * sine, B[10] * one
        row_x, row_y = C[0] * x + C[4] * y + C[8] * z, C[1] * x + C[5] * y + C[9] * z
        turns[0, 0, i] = (M[0, 2] * column_x + M[1, 2] * column_y) / w
        turns[0, 1, i] = (M[1, 2] * column_x - M[0, 2] * column_y) / w
        turns[2, 0, i] = (M[2, 0] * row_x + M[2, 1] * row_y) / w
        turns[2, 1, i] = (M[2, 0] * row_y - M[2, 1] * row_x) / w
    return a * a + b * b - k * k, w, turns


@inner
def _determinant(vectors: Floats, delta: float) -> tuple[float, float]:
    """Returns the determinant of three vectors of numbers x + y sqrt(delta)."""
    U = V = 0.0
    for i in range(3):
        i1, i2 = (i + 1) % 3, (i + 2) % 3
        first = _product(vectors[0, i1], vectors[1, i2], delta)
        second = _product(vectors[0, i2], vectors[1, i1], delta)
        normal = (first[0] - second[0], first[1] - second[1])
        term = _product(normal, vectors[2, i], delta)
        U += term[0]
        V += term[1]
    return U, V


@apart(
    "Tuple((float64, float64, float64[:, :, ::1], float64[:, :, ::1], float64, float64))"
    "(float64[::1], int64[::1], float64[:, ::1], float64[:, ::1], float64, float64)"
)
def _around_once(
    arm: Floats, joints: Ints, links: Floats, between: Floats, c: float, s: float
) -> tuple[float, float, Floats, Floats, float, float]:
    """Goes once around the loop, from a hidden turn.

    Returns delta, a factor of the polynomial, cosines and sines of the other turns (3, 2, 2), the
    directions of the slides and the translation (3, 3, 2), and the determinant of these.
    """
    delta, w, turns = _linkage(between, c, s)
    T = np.zeros((2, 12))
    T[0, 0] = T[0, 5] = c
    T[0, 1], T[0, 4], T[0, 10] = -s, s, 1.0
    vectors = np.empty((3, 3, 2))
    turn = slide = 0
    for i in range(6):
        if arm[SLIDES + joints[i]] > 0.0:
            for j in range(3):
                vectors[slide, j, 0], vectors[slide, j, 1] = T[0, 4 * j + 2], T[1, 4 * j + 2]
            slide += 1
        elif i > 0:
            cosine, sine = turns[turn, 0], turns[turn, 1]
            for j in range(0, 12, 4):
                x, y = (T[0, j], T[1, j]), (T[0, j + 1], T[1, j + 1])
                xc, xs = _product(x, cosine, delta), _product(x, sine, delta)
                yc, ys = _product(y, cosine, delta), _product(y, sine, delta)
                for k in range(2):
                    T[k, j], T[k, j + 1] = xc[k] + ys[k], yc[k] - xs[k]
            turn += 1
        for k in range(2):
            at = T[k].copy()
            for row in range(0, 12, 4):
                for j in range(4):
                    T[k, row + j] = (
                        at[row] * links[i, j]
                        + at[row + 1] * links[i, 4 + j]
                        + at[row + 2] * links[i, 8 + j]
                    )
                T[k, row + 3] += at[row + 3]
    for i in range(3):
        vectors[2, i, 0], vectors[2, i, 1] = T[0, 4 * i + 3], T[1, 4 * i + 3]
    U, V = _determinant(vectors, delta)
    return delta, w, turns, vectors, U, V


@inner
def four_turns_polynomial(
    arm: Floats, joints: Ints, links: Floats, between: Floats, c: float, s: float
) -> float:
    """Returns the polynomial of the hidden turn, of degree 4: the product over both branches."""
    delta, w, _, _, U, V = _around_once(arm, joints, links, between, c, s)
    return w * (U * U - V * V * delta)


@inner
def _lengths(vectors: Floats, root: float, U: float, V: float) -> tuple[bool, float, float]:
    """Returns whether the slides would have to reach too far, and their lengths."""
    square, first, second = PARALLEL, 0.0, 0.0
    sine = across = 0.0
    for i in range(3):
        i1, i2 = (i + 1) % 3, (i + 2) % 3
        u1 = vectors[0, i1, 0] + root * vectors[0, i1, 1]
        u2 = vectors[0, i2, 0] + root * vectors[0, i2, 1]
        v1 = vectors[1, i1, 0] + root * vectors[1, i1, 1]
        v2 = vectors[1, i2, 0] + root * vectors[1, i2, 1]
        x1 = vectors[2, i1, 0] + root * vectors[2, i1, 1]
        x2 = vectors[2, i2, 0] + root * vectors[2, i2, 1]
        normal, other = u1 * v2 - u2 * v1, x1 * u2 - x2 * u1
        sine, across = max(sine, abs(normal)), max(across, abs(other))
        # x + d u + e v = 0 times v and u; their scalar products would lose digits of the sine
        square += normal * normal
        first += normal * (v1 * x2 - v2 * x1)
        second += normal * other
    moved = math.sqrt(MOVED / (abs(U) + abs(V * root) + TINY))
    too_far = across > max(ALONG, moved, FARTHEST * sine)
    return too_far, first / square, second / square


@inner
def four_turns_joints(
    arm: Floats,
    joints: Ints,
    links: Floats,
    between: Floats,
    way: int,
    c1: float,
    s1: float,
    c: Floats,
    s: Floats,
) -> int:
    """Computes the cosines and sines of all turns and the lengths of the slides.

    They follow from the hidden turn. Way 0 is the better branch. Returns 1 if it is to be tried:
    way 1, the other one, where its determinant is small, too, as a double root may be one of each.
    2 if the slides are parallel, and as the translation is not along them, they would have to reach
    too far.
    """
    delta, _, turns, vectors, U, V = _around_once(arm, joints, links, between, c1, s1)
    root = math.sqrt(max(delta, 0.0))
    better = -1.0 if (U < 0.0) == (V < 0.0) else 1.0
    if way == 1:
        better = -better
        if not abs(U + better * V * root) < NEARLY_FLAT:
            return 0
    root *= better
    too_far, first, second = _lengths(vectors, root, U, V)
    if too_far:
        return 2
    c[joints[0]], s[joints[0]] = c1, s1
    turn = slide = 0
    for i in range(1, 6):
        joint = joints[i]
        if arm[SLIDES + joint] > 0.0:
            c[joint], s[joint] = 1.0, first if slide == 0 else second
            slide += 1
        else:
            c[joint], s[joint] = unit(
                turns[turn, 0, 0] + root * turns[turn, 0, 1],
                turns[turn, 1, 0] + root * turns[turn, 1, 1],
            )
            turn += 1
    return 1
