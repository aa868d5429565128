# SPDX-License-Identifier: MIT
"""What becomes of a candidate: a solution that is new, one that is known, or none.

`marks` holds for each solution whether the arm is singular there (bit 0), or nearly so (bit 1).
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import carray, of_file, room
from ..numerical.descent import SOLUTION
from ..turns import TURN
from .places import ADVANCE_C, ADVANCE_S, ANY_SLIDE, MOST, SLIDES
from .refine import pivot, refine_sliding, refine_turning

if TYPE_CHECKING:
    from ..arrays import Floats, Ints

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

PLACES = 64  # many candidates come near to a singular solution; the last are for regular ones
SAME = (
    1e-6  # solutions closer than this are one [rad, arm sizes]: roots are known to 1e-8 or better
)
TOGETHER = 1e-3  # singular ones closer than this may be one, which their last digits show
# The smallest diagonal of the reflected Jacobian over the largest: where it is below this the arm
# is singular, to the accuracy to which a double root is known.
SINGULAR = 1e-6
# Below this it is nearly singular: copies of a singular solution, as far away from it as a miss of
# 1e-10 leaves them, are no less so.
NEARLY_SINGULAR = 1e-4
ALMOST_PI = math.pi - 1e-14  # half a turn is +pi, whatever rounding makes of it


@inner
def count_singular(marks: Ints) -> int:
    """Returns how many marks of the first kind are set."""
    count = 0
    for mark in marks:
        count += mark & 1
    return count


@inner
def gap_between(arm: Floats, a: Floats, b: Floats) -> float:
    """Returns the largest difference of two joint vectors, modulo turns."""
    most = 0.0
    if arm[ANY_SLIDE] == 0.0:
        for i in range(6):
            gap = abs(a[i] - b[i])
            most = max(most, min(gap, TURN - gap))
        return most
    for i in range(6):
        gap = abs(a[i] - b[i])
        most = max(most, gap if arm[SLIDES + i] > 0.0 else min(gap, TURN - gap))
    return most


@inner
def rank(arm: Floats, q: Floats, marks: Ints, count: int) -> None:
    """Replaces marks by ranks: what comes first where there are more solutions than rows.

    0 for regular solutions, 1 for singular ones or nearly so, 2 for those that lie together with
    one of these and may be the same, which only its last digits show.
    """
    for i in range(count):
        marks[i] = 1 if marks[i] else 0
        for j in range(i):
            if marks[i] == 1 and marks[j] == 1 and gap_between(arm, q[i], q[j]) < TOGETHER:
                marks[i] = 2


@inner
def in_loop(arm: Floats, q: Floats, c: Floats, s: Floats) -> None:
    """Computes the cosines and sines in the loop of joint values."""
    for i in range(6):
        cosine, sine = math.cos(q[i]), q[i] if arm[SLIDES + i] > 0.0 else math.sin(q[i])
        c[i] = cosine * arm[ADVANCE_C + i] + sine * arm[ADVANCE_S + i]
        s[i] = sine * arm[ADVANCE_C + i] - cosine * arm[ADVANCE_S + i]


@inner
def from_loop(arm: Floats, c: Floats, s: Floats, q: Floats) -> None:
    """Computes joint values, angles in (-pi, pi], from their cosines and sines in the loop."""
    for i in range(6):
        cosine, sine = arm[ADVANCE_C + i], arm[ADVANCE_S + i]
        q[i] = math.atan2(s[i] * cosine + c[i] * sine, c[i] * cosine - s[i] * sine)
        if q[i] < -ALMOST_PI:
            q[i] = math.pi
    if arm[ANY_SLIDE] > 0.0:
        for i in range(6):
            if arm[SLIDES + i] > 0.0:
                q[i] = s[i]


@inner
def keep_solution(
    arm: Floats,
    c: Floats,
    s: Floats,
    missing: float,
    least: float,
    q: Floats,
    residual: Floats,
    marks: Ints,
    count: int,
) -> tuple[int, int]:
    """Keeps a solution unless it is known or none: (its place or -1, the count).

    Args:
        arm: The numbers of the arm.
        c: Cosines of its joints in the loop.
        s: Sines.
        missing: By how much the loop is open.
        least: The smallest pivot of the Jacobian over the largest.
        q: The solutions so far.
        residual: Their misses.
        marks: What is true of them.
        count: How many they are.
    """
    if not missing <= SOLUTION:
        return -1, count
    theta = carray(room(6), 6)
    from_loop(arm, c, s, theta)
    place = count
    for k in range(count):
        if gap_between(arm, q[k], theta) < SAME:
            place = k
            break
    singular, nearly = 1 if least < SINGULAR else 0, 1 if least < NEARLY_SINGULAR else 0
    if place == count and count >= PLACES - nearly * int(arm[MOST]):
        return -1, count
    if place == count:
        count += 1
        marks[place] = 0
        residual[place] = np.inf
    if missing < residual[place]:
        residual[place] = missing
        for i in range(6):
            q[place, i] = theta[i]
    marks[place] |= singular | nearly << 1
    return place, count


@apart(
    "UniTuple(int64, 2)(float64[::1], float64[:, ::1], float64[::1], float64[::1], boolean, "
    "boolean, float64[:, ::1], float64[::1], int64[::1], int64)"
)
def offer(
    arm: Floats,
    links: Floats,
    c: Floats,
    s: Floats,
    afar: bool,
    doubtful: bool,
    q: Floats,
    residual: Floats,
    marks: Ints,
    count: int,
) -> tuple[int, int]:
    """Refines a candidate and keeps it unless it is known or none: (its place or -1, the count).

    Where one is singular many come near to it: there is room for more than there are solutions, the
    last of it for regular ones.
    """
    if arm[ANY_SLIDE] > 0.0:
        missing = refine_sliding(arm, links, c, s, afar)
    else:
        missing = refine_turning(links, c, s, afar)
    least = pivot(arm, links, c, s) if doubtful and missing <= SOLUTION else 1.0
    return keep_solution(arm, c, s, missing, least, q, residual, marks, count)
