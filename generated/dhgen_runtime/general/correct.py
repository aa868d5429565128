# SPDX-License-Identifier: MIT
"""From joint values that are near all solutions to these, for arms without slides.

Newton's method in the frame of joint 3: there axis 3 is z, and axis 4 is fixed: what is across both
twists is four equations in the other joints.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..jit import carray, of_file, room
from ..rigid import follow, invert, turn
from .loop import POSE
from .refine import turn_by

if TYPE_CHECKING:
    from ..arrays import Floats

OWN = of_file(__file__)
apart, inner, merged = OWN.apart, OWN.inner, OWN.merged

CORRECTIONS = 8  # steps at most
LAST_MISS = 1e-5  # what so short a step may take back [rad, arm sizes]: the loop is two long
LAST_CORRECTION = 1e-7  # the longest step that is the last one [rad]: the next one is its square
# The longest step [rad], to which longer ones are cut: from a row near its solution none is.
LONGEST_CORRECTION = 0.25
# Places in what the pose's solutions have in common: the inverses of K1 and K0; the twist of axis 4
# divided by its largest entry but the last; the place of that entry, those of the others, and its
# inverse.
BACK_1, BACK_0, AXIS_4, PIVOT, OTHER, PER_PIVOT, MIDDLE_SIZE = 0, 12, 24, 30, 31, 35, 36


@inner
def look_from_middle(loop: Floats, middle: Floats) -> None:
    """Fills what the pose's solutions have in common."""
    back_1, back_0, K = invert(loop[1]), invert(loop[0]), loop[2]
    for i in range(12):
        middle[BACK_1 + i], middle[BACK_0 + i] = back_1[i], back_0[i]
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        middle[AXIS_4 + i] = K[4 * j + 3] * K[4 * k + 2] - K[4 * k + 3] * K[4 * j + 2]
        middle[AXIS_4 + 3 + i] = K[4 * i + 2]
    pivot, others = 0, 0
    for i in range(1, 5):
        if abs(middle[AXIS_4 + i]) > abs(middle[AXIS_4 + pivot]):
            pivot = i
    for i in range(5):
        if i != pivot:
            middle[OTHER + others] = i
            others += 1
    middle[PIVOT], middle[PER_PIVOT] = pivot, 1.0 / middle[AXIS_4 + pivot]
    for i in range(6):
        middle[AXIS_4 + i] *= middle[PER_PIVOT]


@merged
def _twist(T: Floats, column: int, A: Floats) -> None:
    """Fills a column of the Jacobian: the twist of the z axis of a frame."""
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        A[i, column] = T[4 * j + 3] * T[4 * k + 2] - T[4 * k + 3] * T[4 * j + 2]
        A[3 + i, column] = T[4 * i + 2]


@merged
def _middle_miss(loop: Floats, middle: Floats, c: Floats, s: Floats, A: Floats) -> float:
    """Returns the square of what the loop misses.

    It fills the last column of A as a twist; the first ones are the twists of joints 1, 2, 5 and 6.
    """
    U, W, R = carray(room(12), 12), carray(room(12), 12), carray(room(9), (3, 3))
    for j in range(4):
        U[j] = c[2] * middle[BACK_1 + j] + s[2] * middle[BACK_1 + 4 + j]
        U[4 + j] = c[2] * middle[BACK_1 + 4 + j] - s[2] * middle[BACK_1 + j]
        U[8 + j] = middle[BACK_1 + 8 + j]
    _twist(U, 1, A)
    turn(U, c[1], -s[1])
    follow(U, middle[BACK_0:AXIS_4])
    _twist(U, 0, A)
    turn(U, c[0], -s[0])
    follow(U, loop[POSE])
    for i in range(12):
        W[i] = loop[2, i]
    turn(W, c[3], s[3])
    follow(W, loop[3])
    _twist(W, 2, A)
    turn(W, c[4], s[4])
    follow(W, loop[4])
    _twist(W, 3, A)
    turn(W, c[5], s[5])
    for i in range(3):
        for j in range(3):
            R[i, j] = (
                U[4 * i] * W[4 * j] + U[4 * i + 1] * W[4 * j + 1] + U[4 * i + 2] * W[4 * j + 2]
            )
        A[i, 4] = U[4 * i + 3] - (R[i, 0] * W[3] + R[i, 1] * W[7] + R[i, 2] * W[11])
    A[3, 4] = 0.5 * (R[2, 1] - R[1, 2])
    A[4, 4] = 0.5 * (R[0, 2] - R[2, 0])
    A[5, 4] = 0.5 * (R[1, 0] - R[0, 1])
    square = 0.0
    for i in range(6):
        square += A[i, 4] * A[i, 4]
    # half a turn away the skew part vanishes too: the trace shows it
    return square + 1.0 if R[0, 0] + R[1, 1] + R[2, 2] < 0.0 else square


@merged
def _solve_four(M: Floats, x: Floats) -> None:
    """Solves four equations, the last column of M the right side, by minors of two rows."""
    a, b = carray(room(6), 6), carray(room(6), 6)
    u, w = carray(room(4), 4), carray(room(4), 4)
    k = 0
    for i in range(4):
        for j in range(i + 1, 4):
            a[k] = M[0, i] * M[1, j] - M[1, i] * M[0, j]
            b[k] = M[2, i] * M[3, j] - M[3, i] * M[2, j]
            k += 1
        u[i] = M[1, i] * M[0, 4] - M[0, i] * M[1, 4]
        w[i] = M[3, i] * M[2, 4] - M[2, i] * M[3, 4]
    determinant = a[0] * b[5] - a[1] * b[4] + a[2] * b[3] + a[3] * b[2] - a[4] * b[1] + a[5] * b[0]
    x[0] = (u[1] * b[5] - u[2] * b[4] + u[3] * b[3]) + (w[1] * a[5] - w[2] * a[4] + w[3] * a[3])
    x[1] = (u[2] * b[2] - u[0] * b[5] - u[3] * b[1]) + (w[2] * a[2] - w[0] * a[5] - w[3] * a[1])
    x[2] = (u[0] * b[4] - u[1] * b[2] + u[3] * b[0]) + (w[0] * a[4] - w[1] * a[2] + w[3] * a[0])
    x[3] = (u[1] * b[1] - u[0] * b[3] - u[2] * b[0]) + (w[1] * a[1] - w[0] * a[3] - w[2] * a[0])
    per_determinant = 1.0 / determinant if determinant != 0.0 else math.inf
    for i in range(4):
        x[i] *= per_determinant


@merged
def _correction(middle: Floats, A: Floats, x: Floats) -> None:
    """Computes the step of Newton's method for all joints."""
    M, y = carray(room(20), (4, 5)), carray(room(4), 4)
    pivot = int(middle[PIVOT])
    for i in range(4):
        row = int(middle[OTHER + i])
        for j in range(5):
            M[i, j] = A[row, j] - A[pivot, j] * middle[AXIS_4 + row]
    _solve_four(M, y)
    along, about = A[pivot, 4], A[5, 4]
    for j in range(4):
        along -= A[pivot, j] * y[j]
        about -= A[5, j] * y[j]
    x[0], x[1] = y[0], y[1]
    x[2], x[3] = about - along * middle[AXIS_4 + 5], along * middle[PER_PIVOT]
    x[4], x[5] = y[2], y[3]


@apart("float64(float64[:, ::1], float64[::1], float64[::1], float64[::1])")
def correct(loop: Floats, middle: Floats, c: Floats, s: Floats) -> float:
    """Takes cosines and sines of the joints from near to a solution to it.

    Returns the miss, no less than it is: that before the last step is taken back by it up to its
    square.
    """
    A, x, most = carray(room(30), (6, 5)), carray(room(6), 6), 1.0
    total, square = 1.0, 1.0
    for _ in range(CORRECTIONS):
        if not most > LAST_CORRECTION:
            break
        square = _middle_miss(loop, middle, c, s, A)
        _correction(middle, A, x)
        most, total = 0.0, 0.0
        for i in range(6):
            if abs(x[i]) > LONGEST_CORRECTION:
                x[i] = math.copysign(LONGEST_CORRECTION, x[i])
            turn_by(c, s, i, x[i])
            most = max(most, abs(x[i]))
            total += abs(x[i])
    return total * total if square <= LAST_MISS * LAST_MISS else 1.0
