# SPDX-License-Identifier: MIT
"""Newton's steps on the loop: from a candidate to a solution.

`c` and `s` are cosines and sines of the joints in the loop; a slide's length replaces the sine.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..jit import carray, of_file, room
from ..rigid import follow, take, turn
from .loop import POSE, move, reflect
from .places import ANY_SLIDE, SLIDES

if TYPE_CHECKING:
    from ..arrays import Floats

OWN = of_file(__file__)
apart, inner, merged = OWN.apart, OWN.inner, OWN.merged

STEPS = 4  # for a candidate; two are enough unless a root is nearly double
STEPS_FROM_AFAR = 40
GOOD_ENOUGH = 1e-29  # the square of a residual that is rounding: steps end [arm sizes, rad]
# Singular values below this part of the largest count as zero: Newton then moves in the rest only,
# instead of leaping along a direction that the pose does not determine.
RANK = 1e-9
DAMPING = 1e-2  # times the square of the error: of steps from afar
SMALLEST_SQUARE = 1e-30  # always added to the damping: the square of rounding


@merged
def _next_axis(links: Floats, k: int, T: Floats, J: Floats) -> None:
    """Takes T to joint k, whose axis and a point of it go into column k of J."""
    if k:
        follow(T, links[k - 1])
    for i in range(3):
        J[3 + i, k] = T[4 * i + 2]
        J[i, k] = T[4 * i + 3]


@merged
def _velocities(T: Floats, J: Floats) -> None:
    """Makes of axes and points the columns of joints that turn."""
    for k in range(6):
        z0, z1, z2 = J[3, k], J[4, k], J[5, k]
        r0, r1, r2 = T[3] - J[0, k], T[7] - J[1, k], T[11] - J[2, k]
        J[0, k], J[1, k], J[2, k] = z1 * r2 - z2 * r1, z2 * r0 - z0 * r2, z0 * r1 - z1 * r0


@merged
def _missing(P: Floats, T: Floats, J: Floats) -> float:
    """Returns the square of the error; translation and rotation vector go into the last column."""
    S = carray(room(9), (3, 3))
    for i in range(3):
        for j in range(3):
            S[i, j] = (
                P[4 * i] * T[4 * j] + P[4 * i + 1] * T[4 * j + 1] + P[4 * i + 2] * T[4 * j + 2]
            )
        J[i, 6] = P[4 * i + 3] - T[4 * i + 3]
    J[3, 6] = 0.5 * (S[2, 1] - S[1, 2])
    J[4, 6] = 0.5 * (S[0, 2] - S[2, 0])
    J[5, 6] = 0.5 * (S[1, 0] - S[0, 1])
    square = 0.0
    for i in range(6):
        square += J[i, 6] * J[i, 6]
    # half a turn away the skew part vanishes too: the trace shows it
    return square + 1.0 if S[0, 0] + S[1, 1] + S[2, 2] < 0.0 else square


@inner
def _turning_error(links: Floats, c: Floats, s: Floats, J: Floats) -> float:
    """Returns the square of the loop's error, of an arm without slides; J as of `loop_error`."""
    P = links[POSE]
    T = carray(room(12), 12)
    T[:] = 0.0
    T[0] = T[5] = T[10] = 1.0
    for k in range(6):
        _next_axis(links, k, T, J)
        turn(T, c[k], s[k])
    _velocities(T, J)
    return _missing(P, T, J)


@inner
def _sliding_error(arm: Floats, links: Floats, c: Floats, s: Floats, J: Floats) -> float:
    """Returns the square of the loop's error, of an arm with slides; J as of `loop_error`."""
    P = links[POSE]
    T = carray(room(12), 12)
    T[:] = 0.0
    T[0] = T[5] = T[10] = 1.0
    for k in range(6):
        _next_axis(links, k, T, J)
        move(arm, T, k, c[k], s[k])
    _velocities(T, J)
    for k in range(6):
        if arm[SLIDES + k] > 0.0:
            for i in range(3):
                J[i, k], J[3 + i, k] = J[3 + i, k], 0.0
    return _missing(P, T, J)


@inner
def loop_error(arm: Floats, links: Floats, c: Floats, s: Floats, J: Floats) -> float:
    """Returns the square of the loop's error.

    J takes the Jacobian with the error, translation and rotation vector, as seventh column.
    """
    if arm[ANY_SLIDE] > 0.0:
        return _sliding_error(arm, links, c, s, J)
    return _turning_error(links, c, s, J)


@inner
def newton_step(J: Floats, x: Floats) -> float:
    """Computes the least-squares solution of J x = error by reflections.

    Where a diagonal is next to nothing the step is zero instead of leaping. Returns the smallest
    diagonal over the largest.
    """
    for column in range(5):
        reflect(J, column, column + 1, column)
    most = least = abs(J[0, 0])
    for i in range(1, 6):
        most, least = max(most, abs(J[i, i])), min(least, abs(J[i, i]))
    for i in range(5, -1, -1):
        total = J[i, 6]
        for j in range(i + 1, 6):
            total -= J[i, j] * x[j]
        x[i] = 0.0
        if abs(J[i, i]) > most * RANK:
            x[i] = max(min(total / J[i, i], 1.0), -1.0)
    return least / most if most > 0.0 else 0.0


@inner
def _damped_step(J: Floats, damping: float, x: Floats) -> None:
    """Computes the solution of (J' J + d) x = J' error, for starts from afar."""
    A = carray(room(42), (6, 7))
    for i in range(6):
        for j in range(i, 7):
            total = 0.0
            for k in range(6):
                total += J[k, i] * J[k, j]
            A[i, j] = total
        A[i, i] += damping + SMALLEST_SQUARE
    for i in range(6):
        for j in range(i + 1, 6):
            factor = A[i, j] / A[i, i]
            for k in range(j, 7):
                A[j, k] -= factor * A[i, k]
    for i in range(5, -1, -1):
        total = A[i, 6]
        for j in range(i + 1, 6):
            total -= A[i, j] * x[j]
        x[i] = max(min(total / A[i, i], 1.0), -1.0)


@merged
def _step(J: Floats, afar: bool, now: float, x: Floats) -> None:
    """Computes the next step."""
    if afar:
        _damped_step(J, DAMPING * min(now, 1.0), x)
    else:
        newton_step(J, x)


@merged
def turn_by(c: Floats, s: Floats, i: int, x: float) -> None:
    """Adds 2 atan(x/2) to an angle, without trigonometry."""
    u = 0.25 * x * x
    dc, ds = (1.0 - u) / (1.0 + u), x / (1.0 + u)
    c[i], s[i] = c[i] * dc - s[i] * ds, s[i] * dc + c[i] * ds


@inner
def refine_turning(links: Floats, c: Floats, s: Floats, afar: bool) -> float:
    """Takes c and s to the best iterate of Newton's method on the loop; returns its error.

    Of an arm without slides, by itself: what slides need would make this slower by half.
    """
    J, x = carray(room(42), (6, 7)), carray(room(6), 6)
    tc, ts = carray(room(6), 6), carray(room(6), 6)
    take(tc, c)
    take(ts, s)
    least = now = _turning_error(links, c, s, J)
    for _ in range(STEPS_FROM_AFAR if afar else STEPS):
        if least < GOOD_ENOUGH:
            break
        _step(J, afar, now, x)
        for i in range(6):
            turn_by(tc, ts, i, x[i])
        now = _turning_error(links, tc, ts, J)
        if now < least:
            least = now
            for i in range(6):
                c[i], s[i] = tc[i], ts[i]
    return math.sqrt(least)


@apart("float64(float64[::1], float64[:, ::1], float64[::1], float64[::1], boolean)")
def refine_sliding(arm: Floats, links: Floats, c: Floats, s: Floats, afar: bool) -> float:
    """Takes c and s to the best iterate of Newton's method on the loop; returns its error."""
    J, x = carray(room(42), (6, 7)), carray(room(6), 6)
    tc, ts = carray(room(6), 6), carray(room(6), 6)
    take(tc, c)
    take(ts, s)
    least = now = _sliding_error(arm, links, c, s, J)
    for _ in range(STEPS_FROM_AFAR if afar else STEPS):
        if least < GOOD_ENOUGH:
            break
        _step(J, afar, now, x)
        for i in range(6):
            if arm[SLIDES + i] > 0.0:
                ts[i] += x[i]
            else:
                turn_by(tc, ts, i, x[i])
        now = _sliding_error(arm, links, tc, ts, J)
        if now < least:
            least = now
            for i in range(6):
                c[i], s[i] = tc[i], ts[i]
    return math.sqrt(least)


@apart("float64(float64[::1], float64[:, ::1], float64[::1], float64[::1])")
def pivot(arm: Floats, links: Floats, c: Floats, s: Floats) -> float:
    """Returns the smallest diagonal of the reflected Jacobian over the largest."""
    J, x = carray(room(42), (6, 7)), carray(room(6), 6)
    loop_error(arm, links, c, s, J)
    return newton_step(J, x)
