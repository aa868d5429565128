# SPDX-License-Identifier: MIT
"""All solutions of the loop: formulations, then poses close by, then starts from anywhere."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from ..numerical.solutions import TIE, order_blocks, order_of
from ..rigid import follow
from ..tolerances import EXACT
from .attempts import try_closed_form, try_formulation
from .candidates import PLACES, count_singular, from_loop, gap_between, in_loop, offer, rank
from .correct import MIDDLE_SIZE, correct, look_from_middle
from .loop import POSE, close, vanishing
from .places import CLOSED, ELIMINATIONS, MOST, REACH, SIZE_OF_LOOP, SLIDES
from .tables import NUDGES

WELL_APART = 0.01  # [rad] solutions of which some joint differs by more are not about to meet

if TYPE_CHECKING:
    from ..arrays import Floats, Ints

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

STARTS = 128  # where everything else fails


@apart(
    "Tuple((boolean, int64))(float64[::1], float64[:, ::1], int64, float64[:, ::1], float64[::1], "
    "int64[::1], int64[::1])"
)
def _try(
    arm: Floats,
    loop: Floats,
    useless: int,
    q: Floats,
    residual: Floats,
    marks: Ints,
    doubles_met: Ints,
) -> tuple[bool, int]:
    """Finds what the methods find, one after the other, until that is certainly everything.

    Returns whether it is, and the count.
    """
    for i in range(PLACES):
        marks[i] = 0
    complete, count = False, 0
    for which in range(int(arm[CLOSED])):
        if not complete:
            complete, count = try_closed_form(
                arm, which, loop, q, residual, marks, doubles_met, count
            )
    for form in range(int(arm[ELIMINATIONS])):
        if not complete and not useless >> form & 1:
            complete, count = try_formulation(
                arm, form, loop, q, residual, marks, doubles_met, count
            )
    return complete, count


@apart(
    "Tuple((boolean, int64))(float64[::1], float64[:, ::1], int64, float64[:, ::1], float64[::1], "
    "int64[::1], int64)"
)
def _from_nearby(
    arm: Floats,
    loop: Floats,
    useless: int,
    q: Floats,
    residual: Floats,
    marks: Ints,
    count: int,
) -> tuple[bool, int]:
    """Solves poses close by, and follows their solutions back: (whether that is all, the count).

    Where two solutions meet they are on one side only: both sides have to have as many as are
    found. Around a singular pose none of them has to have all solutions: then all are looked at.
    """
    followed = False
    before = -1
    c, s = np.empty(6), np.empty(6)
    other, ignored = np.empty((PLACES, 6)), np.empty(PLACES)
    other_marks = np.zeros(PLACES, dtype=np.int64)
    for n in range(len(NUDGES)):
        nearby = loop.copy()
        follow(nearby[POSE], NUDGES[n])
        complete, found = _try(
            arm, nearby, useless, other, ignored, other_marks, np.zeros(1, dtype=np.int64)
        )
        met = np.zeros(PLACES, dtype=np.int64)
        singular_here = False
        for i in range(found):
            in_loop(arm, other[i], c, s)
            place, count = offer(arm, loop, c, s, True, True, q, residual, marks, count)
            if place < 0:
                complete = False
            else:
                met[place] = 1
                singular_here = singular_here or marks[place] & 1 == 1
        singular = count_singular(marks)
        agreed = -1
        if complete and found > 0:
            agreed = found if count_singular(met) == found else -1
            followed = followed or singular_here
        alike = n % 2 == 1 and before == count and agreed == count
        if alike and singular == 0 and count % 2 == 0:
            return True, count
        before = agreed
    return followed and (count - count_singular(marks)) % 2 == 0, count


@inner
def _from_anywhere(
    arm: Floats, loop: Floats, q: Floats, residual: Floats, marks: Ints, count: int
) -> int:
    """Offers starts all over the joint space; returns the count."""
    seed = 1
    c, s, start = np.empty(6), np.empty(6), np.empty(6)
    for _ in range(STARTS):
        for i in range(6):
            seed = (seed * 1103515245 + 12345) % 2147483648
            start[i] = (seed / 1073741824.0 - 1.0) * math.pi
        in_loop(arm, start, c, s)
        _, count = offer(arm, loop, c, s, True, True, q, residual, marks, count)
    return count


@inner
def _in_order(arm: Floats, q: Floats, ranks: Ints, count: int) -> Ints:
    """Returns the places of solutions in their order.

    By rank, then by the first angle, angles that agree to rounding by the next.
    """
    order, first, value = np.empty(PLACES, np.int64), np.zeros(PLACES, np.bool_), np.empty(PLACES)
    for i in range(count):
        order[i], value[i] = i, ranks[i]
    single = order_blocks(value, 0.0, count, order, first)
    for k in range(6):
        if not single:
            for i in range(count):
                value[i] = order_of(q[i, k], arm[SLIDES + k] == 0.0)
            single = order_blocks(value, TIE, count, order, first)
    return order


@apart("boolean(float64[::1], float64[::1], float64[::1], float64[:, ::1])")
def corrected(arm: Floats, T: Floats, q_free: Floats, angles: Floats) -> bool:
    """Takes angles (k, 6) that are near solutions to these, of an arm without slides.

    Returns whether all are exact, and no two of them near one another; if not, nothing is known.
    """
    loop = close(arm, T, q_free)
    c, s, middle = np.empty(6), np.empty(6), np.empty(MIDDLE_SIZE)
    look_from_middle(loop, middle)
    for k in range(len(angles)):
        in_loop(arm, angles[k], c, s)
        if not correct(loop, middle, c, s) <= EXACT:
            return False
        from_loop(arm, c, s, angles[k])
        for i in range(k):
            if gap_between(arm, angles[i], angles[k]) < WELL_APART:
                return False
    return True


@apart("int64(float64[::1], float64[::1], float64[::1], float64[:, ::1], float64[::1])")
def solve_loop(arm: Floats, T: Floats, q_free: Floats, q: Floats, residual: Floats) -> int:
    """Finds all solutions of T = C0 J(q1) C1 ... J(q6) C6.

    Args:
        arm: The numbers of the arm.
        T: A rigid transform, twelve numbers.
        q_free: Values of the joints that the caller gives.
        q: (PLACES, 6), takes the angles, in (-pi, pi], or length; rows in the order of q1, rows
            whose q1 agree to TIE in the order of q2, and so on, those where the arm is singular or
            nearly so behind all others.
        residual: (PLACES,), takes by how much the loop is open, in radians and arm sizes.

    Returns:
        How many, no more than MOST but for members of continua; -1 - count when it is not certain
        that these are all: for want of a certificate (where every polynomial vanishes identically
        there may be a continuum, which poses close by do not have), or because roots met or the arm
        is singular at a solution, or nearly, so that steps did not make it exact.
    """
    loop, most = close(arm, T, q_free), int(arm[MOST])
    P = loop[POSE]
    if P[3] * P[3] + P[7] * P[7] + P[11] * P[11] > arm[REACH]:
        return 0
    found, missing = np.empty((PLACES, 6)), np.empty(PLACES)
    marks, doubles_met = np.zeros(PLACES, dtype=np.int64), np.zeros(1, dtype=np.int64)
    useless = vanishing(arm, q_free)
    certified, count = _try(arm, loop, useless, found, missing, marks, doubles_met)
    complete = certified
    if not complete:
        complete, count = _from_nearby(arm, loop, useless, found, missing, marks, count)
    if not complete:
        count = _from_anywhere(arm, loop, found, missing, marks, count)
    regular = count_singular(marks) == 0 and doubles_met[0] == 0
    rank(arm, found, marks, count)
    order = _in_order(arm, found, marks, count)
    certified = certified and count <= most
    members = 0
    for i in range(count):
        members += marks[i] < 2
    count = min(count, max(most, members))
    for i in range(count):
        for k in range(6):
            unit = arm[SIZE_OF_LOOP] if arm[SLIDES + k] > 0.0 else 1.0
            q[i, k] = found[order[i], k] * unit
        residual[i] = missing[order[i]]
        regular = regular and residual[i] <= EXACT
    return count if certified and regular else -1 - count
