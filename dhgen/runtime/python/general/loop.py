# SPDX-License-Identifier: MIT
"""The arm as a closed loop J(q1) K0 J(q2) ... K4 J(q6) = P, in units of the arm's size; P = L T R.

Rigid transforms are twelve numbers, row by row. A slide's length replaces the sine of a turn.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from ..numerical.places import GIVEN
from ..rigid import follow, invert, slide, take, take_from, turn
from .places import (
    COSINE_VANISHES,
    FORMULATION_RECORD,
    FORMULATION_SIGN,
    FORMULATIONS,
    GIVEN_RECORD,
    GIVEN_VALUES,
    INSIDE_RECORD,
    LENGTH,
    LINK_COUNT,
    LINK_RECORD,
    LINKS,
    PER_SIZE,
    SLIDES,
    SPECIAL,
    SPECIAL_RECORD,
)

if TYPE_CHECKING:
    from ..arrays import Floats, Ints

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner


TINY = 1e-300  # keeps quotients of zeros finite; beside any other number it is nothing
# The squares of a cosine and a sine without these bounds would vanish or overflow: nothing of the
# angle is left in them.
LEAST_LENGTH = 1e-150
POSE = 5  # place of P among the loop's transforms


@inner
def move(arm: Floats, T: Floats, joint: int, c: float, s: float) -> None:
    """Multiplies T by a joint's motion, by cosine and sine or by a length in the sine's place."""
    if arm[SLIDES + joint] > 0.0:
        slide(T, s)
    else:
        turn(T, c, s)


@inner
def _given_value(arm: Floats, q_free: Floats, place: int) -> float:
    """Returns the angle or length of a joint whose value the caller gives."""
    count = int(arm[GIVEN])
    at = int(arm[GIVEN_VALUES]) + (GIVEN_RECORD + count) * place
    value = arm[at] * q_free[place] + arm[at + 1]
    for k in range(count):
        if arm[at + GIVEN_RECORD + k] != 0.0:
            value += arm[at + GIVEN_RECORD + k] * q_free[k]
    return float(value)


@apart("float64[:, ::1](float64[::1], float64[::1], float64[::1])")
def close(arm: Floats, T: Floats, q_free: Floats) -> Floats:
    """Returns the loop (7, 12): K0 ... K4, its pose P = L T R in arm sizes, and R."""
    links, constant = np.empty((LINK_COUNT, 12)), np.empty(12)
    at = int(arm[LINKS])
    for i in range(LINK_COUNT):
        inside = int(arm[at])
        take_from(links[i], arm, at + 1)
        at += LINK_RECORD
        for _ in range(inside):
            place, factor = int(arm[at]), arm[at + 2]
            value = _given_value(arm, q_free, place)
            if arm[at + 1] > 0.0:
                slide(links[i], factor * value)
            else:
                turn(links[i], math.cos(value), factor * math.sin(value))
            take_from(constant, arm, at + 3)
            follow(links[i], constant)
            at += INSIDE_RECORD
    follow(links[POSE], T)
    follow(links[POSE], links[6])
    for i in range(3):
        links[POSE, 4 * i + 3] *= arm[PER_SIZE]
    return links


@apart("int64(float64[::1], float64[::1])")
def vanishing(arm: Floats, q_free: Floats) -> int:
    """Returns bits: bit i is set if formulation i vanishes at the values that the caller gives."""
    useless, at = 0, int(arm[SPECIAL])
    if arm[GIVEN] == 0.0:
        return useless
    for _ in range(int(arm[at])):
        value = _given_value(arm, q_free, int(arm[at + 1]))
        off, ahead = value, 1.0
        if arm[at + 2] != LENGTH:
            c, s = math.cos(value), math.sin(value)
            off, ahead = (c, s) if arm[at + 2] == COSINE_VANISHES else (s, c)
            ahead *= arm[at + 3]
        if abs(off) <= arm[at + 4] and ahead > 0.0:
            useless |= int(arm[at + 5])
        at += SPECIAL_RECORD
    return useless


@inner
def unit(c: float, s: float) -> tuple[float, float]:
    """Returns a cosine and a sine without their common factor, as far as this has a square."""
    length = math.sqrt(c * c + s * s)
    if not LEAST_LENGTH < length < math.inf:
        return 1.0, 0.0
    return c / length, s / length


@inner
def reflect(M: Floats, first: int, rest: int, column: int) -> float:
    """Reflects the first row and the rows from `rest` on so that only the first keeps `column`.

    Returns what that is then.
    """
    rows, columns = M.shape
    head = M[first, column]
    square = head * head
    for i in range(rest, rows):
        square += M[i, column] * M[i, column]
    length = math.copysign(math.sqrt(square), head)
    head += length
    factor = 1.0 / (length * head + TINY)
    for j in range(column + 1, columns):
        total = head * M[first, j]
        for i in range(rest, rows):
            total += M[i, column] * M[i, j]
        total *= factor
        M[first, j] -= head * total
        for i in range(rest, rows):
            M[i, j] -= M[i, column] * total
    for i in range(rest, rows):
        M[i, column] = 0.0
    M[first, column] = -length
    return -length


@inner
def joints_of(arm: Floats, form: int) -> Ints:
    """Returns the joints of a formulation, the hidden one first."""
    joints, at = np.empty(6, np.int64), int(arm[FORMULATIONS]) + FORMULATION_RECORD * form
    for i in range(6):
        joints[i] = int(arm[at + i])
    return joints


@inner
def sign_of(arm: Floats, form: int) -> float:
    """Returns the sign with which a formulation reads the loop."""
    return arm[int(arm[FORMULATIONS]) + FORMULATION_RECORD * form + FORMULATION_SIGN]


@apart("float64[:, ::1](float64[::1], int64, float64[:, ::1])")
def around(arm: Floats, form: int, loop: Floats) -> Floats:
    """Returns the links L0 ... L5 of a formulation."""
    links, joints, sign = np.empty((6, 12)), joints_of(arm, form), sign_of(arm, form)
    for i in range(6):
        joint = joints[i]
        if sign > 0.0:
            take(links[i], loop[joint] if joint < POSE else invert(loop[POSE]))
        else:
            take(links[i], invert(loop[joint - 1]) if joint > 0 else loop[POSE])
    return links
