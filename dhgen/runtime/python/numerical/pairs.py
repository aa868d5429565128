# SPDX-License-Identifier: MIT
"""Pairs of solutions that nearly meet: where one is a row the other becomes one, too.

Between them the arm is singular, so that steps from anywhere may converge to one of the two, or to
half way between. Along the motion v that leaves the tool where it is, nearly, the pose is missed by

    e(t) = e - s t + b t^2 / 2,

measured along what v moves: both solutions are near its zeros.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from ..rigid import take
from ..tolerances import LIMIT
from .descent import descend, measure_miss, null_part, sideways, wrap_angles
from .family import clamp
from .goal import GOAL
from .keep import keep
from .places import EQUATIONS, LIMITED, RESIDUAL, SOLVED
from .solutions import find_known, nothing_ahead

if TYPE_CHECKING:
    from ..arrays import Floats, Ints
    from .goal import Goal

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

# How fast that motion moves the tool, at most: a solution as regular as this has enough digits to
# be distinct from others as found. At least: of singular solutions it is rounding.
SLOWEST_REGULAR = 1e-3
STILL = 1e-13
# How far along that motion the second derivative b is measured: rounding of it is 1e-10 then.
BEND_STEP = 1e-3
# Zeros farther away than this are none of a parabola [rad, arm sizes]; up to here they are starts,
# and along nearly a continuum the only ones from which it is found.
FARTHEST_OTHER = 1.0


@apart(f"boolean(float64[::1], {GOAL}, float64[::1], float64[::1], float64[::1], float64[::1])")
def find_pair(arm: Floats, goal: Goal, q: Floats, u: Floats, along: Floats, zeros: Floats) -> bool:
    """Computes the zeros of the miss along that motion, the nearer one first, and the motion.

    Returns whether there is a parabola, as bent as that both are near.
    """
    solved, equations = int(arm[SOLVED]), int(arm[EQUATIONS])
    e, A = np.empty(equations), np.empty((equations, solved))
    moved, beside, square, missed, bend = np.empty(equations), np.empty(solved), 0.0, 0.0, 0.0
    measure_miss(arm, goal, q, u, e, A)
    sideways(arm, A, along)
    null_part(A, along)
    for i in range(equations):
        moved[i] = 0.0
        for j in range(solved):
            moved[i] += A[i, j] * along[j]
        square += moved[i] * moved[i]
    speed = math.sqrt(square)
    if not STILL < speed < SLOWEST_REGULAR:
        return False
    for i in range(equations):
        missed += e[i] * moved[i] / speed
    for side in (-1.0, 1.0):
        for j in range(solved):
            beside[j] = u[j] + side * BEND_STEP * along[j]
        measure_miss(arm, goal, q, beside, e, A)
        for i in range(equations):
            bend += e[i] * moved[i] / speed
    bend = (bend - 2.0 * missed) / (BEND_STEP * BEND_STEP)
    spread = speed * speed - 2.0 * bend * missed
    if not spread > 0.0:
        return False
    total = speed + math.sqrt(spread)
    if not total < FARTHEST_OTHER * abs(bend):
        return False
    zeros[0], zeros[1] = 2.0 * missed / total, total / bend
    return True


@apart(
    f"int64(float64[::1], {GOAL}, float64[::1], float64[::1], float64[:, ::1], int64[::1], int64, "
    "int64, float64[::1])"
)
def _sharpen(
    arm: Floats,
    goal: Goal,
    q: Floats,
    near: Floats,
    kept: Floats,
    kinds: Ints,
    count: int,
    k: int,
    start: Floats,
) -> int:
    """Takes row k, where it can be more exact, to the solution that steps from `start` converge to.

    Such a row may lie half way between two solutions. It is dropped where another row has that.
    Returns how many rows there are.
    """
    solved = int(arm[SOLVED])
    e, A = np.empty(int(arm[EQUATIONS])), np.empty((int(arm[EQUATIONS]), solved))
    miss, inside = descend(arm, goal, q, start), np.empty(solved)
    if miss > 0.5 * measure_miss(arm, goal, q, kept[k], e, A):
        return count
    beyond = arm[LIMITED] > 0.0 and clamp(arm, start, near, inside) > LIMIT
    if beyond and clamp(arm, kept[k], near, inside) <= LIMIT:
        return count
    known = find_known(arm, goal, q, kept, kinds, count, start, False)
    wrap_angles(arm, start)
    if known in (-1, k):
        take(kept[k], start)
        return count
    take(kept[k], kept[count - 1])
    kinds[k] = kinds[count - 1]
    return count - 1


@apart(
    f"int64(float64[::1], {GOAL}, float64[::1], float64[::1], float64[:, ::1], int64[::1], int64)"
)
def complete_pairs(
    arm: Floats, goal: Goal, q: Floats, near: Floats, kept: Floats, kinds: Ints, count: int
) -> int:
    """Adds the other one of each pair of solutions that nearly meet; returns how many rows are."""
    solved, k = int(arm[SOLVED]), 0
    along, zeros, one, other = np.empty(solved), np.empty(2), np.empty(solved), np.empty(solved)
    while k < count:
        if kinds[k] == 1 or not find_pair(arm, goal, q, kept[k], along, zeros):
            k += 1
            continue
        for j in range(solved):
            one[j] = kept[k, j] + zeros[0] * along[j]
            other[j] = kept[k, j] + zeros[1] * along[j]
        before, count = count, _sharpen(arm, goal, q, near, kept, kinds, count, k, one)
        if count < before:  # the pair of the row that has it is completed, too
            continue
        k += 1
        if descend(arm, goal, q, other) <= arm[RESIDUAL]:
            count = keep(arm, goal, q, near, kept, kinds, count, other, nothing_ahead(arm))
    return count
