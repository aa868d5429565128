# SPDX-License-Identifier: MIT
"""Which solutions are one, which belong to a continuum, and which are kept."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from .descent import (
    EXACT,
    FLOOR,
    SOLUTION,
    TURN,
    damped_step,
    descend,
    descend_towards,
    measure_miss,
    sideways,
    wrap_angles,
)
from .forward import take
from .places import (
    CHECKED,
    EQUATIONS,
    HIGHEST,
    LIMITED,
    LOWEST,
    PLACE,
    RECORD,
    RESIDUAL,
    ROWS,
    SOLVED,
    TURNS,
    UNIT,
)

if TYPE_CHECKING:
    from ..arrays import Bools, Floats, Ints

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner


SAME = (
    1e-6  # solutions closer than this are one [rad, arm sizes]: roots are known to 1e-8 or better
)
# Singular solutions closer than this [rad, arm sizes] are one if what lies between them solves,
# too: from these parts of the way a few steps lead to solutions that are nearer to where they began
# than this part of it.
NEIGHBOURS = 0.1
BETWEEN = (0.25, 0.5, 0.75)
STEPS_ASIDE = 4
STAYS = 1 / 16
# What is left of a generic direction when all that moves the tool is taken away [of its length]: by
# less it is what damping leaves at a regular solution.
SINGULAR = 1e-4
FEELER = 0.05  # how far a continuum is looked for in that direction [rad, arm sizes]
FELT = 0.01  # how far from where it began, and from the other side, a solution must then be
# Where a solution beyond a limit is one of two that nearly meet the other lies across a singular
# place, and from the limit steps may lead back: how far to go on, as parts of the way there.
FARTHER_ON = (0.0, 1.0, 3.0, 7.0, 15.0)
# Just beyond an end of its range a joint is taken for one on that end, not for one that turned to
# the other, if the seed is nearer than this [rad].
BESIDE_SEED = 0.15
# Just beyond an end is by less than this [rad]: an angle taken from a vector that hardly fixes it
# is good to 1e-3.
DOUBTFUL = 1e-2
PROMISED = 1e-11  # a row misses its pose by no more [arm sizes, rad]
LIMIT = 1e-9  # a joint value may miss its limit by this [rad, arm sizes]: rounding of the angle
TIE = 1e-9  # values closer than this don't decide which of two rows comes first [rad or length]


@apart("int64(float64[::1], float64[:, ::1], float64[::1], float64[::1], float64)")
def continuum(arm: Floats, T: Floats, q: Floats, u: Floats, enough: float) -> int:
    """Returns whether u is one of a continuum of solutions: 1 if there are others to both sides.

    They miss the pose by no more than `enough`. 0 if it is a singular solution that stands alone,
    -1 if it is a regular one.
    """
    solved = int(arm[SOLVED])
    e, A = np.empty(int(arm[EQUATIONS])), np.empty((int(arm[EQUATIONS]), solved))
    along, end, other = np.empty(solved), np.empty(solved), np.full(solved, np.inf)
    measure_miss(arm, T, q, u, e, A)
    if sideways(arm, A, along) <= SINGULAR:
        return -1
    for side in (1.0, -1.0):
        gap = across = 0.0
        for j in range(solved):
            end[j] = u[j] + side * FEELER * along[j]
        miss = descend(arm, T, q, end)
        for j in range(solved):
            gap, across = max(gap, abs(end[j] - u[j])), max(across, abs(end[j] - other[j]))
        if miss > enough or min(gap, across) <= FELT:
            return 0
        take(other, end)
    return 1


@apart("float64(float64[::1], float64[:, ::1], float64[::1], float64[::1])")
def enough_beside(arm: Floats, T: Floats, q: Floats, u: Floats) -> float:
    """Returns what others may miss beside a solution: an exact one leaves exact ones only."""
    if arm[CHECKED] == 0.0:
        return SOLUTION
    e, A = np.empty(int(arm[EQUATIONS])), np.empty((int(arm[EQUATIONS]), int(arm[SOLVED])))
    return SOLUTION if measure_miss(arm, T, q, u, e, A) <= SOLUTION else arm[RESIDUAL]


@apart("boolean(float64[::1], float64[:, ::1], float64[::1], float64[::1], float64[::1], float64)")
def _solves_between(
    arm: Floats, T: Floats, q: Floats, u: Floats, way: Floats, length: float
) -> bool:
    """Whether solutions lie all along the way from one to another.

    Where many roots meet, joint values beside the solution miss the pose by next to nothing.
    """
    solved = int(arm[SOLVED])
    e, A = np.empty(int(arm[EQUATIONS])), np.empty((int(arm[EQUATIONS]), solved))
    end, step = np.empty(solved), np.empty(solved)
    enough = enough_beside(arm, T, q, u)
    for part in BETWEEN:
        for j in range(solved):
            end[j] = u[j] + part * way[j]
        miss = measure_miss(arm, T, q, end, e, A)
        for _ in range(STEPS_ASIDE):
            if miss > enough:
                damped_step(A, e, miss, FLOOR, step)
                for j in range(solved):
                    end[j] += step[j]
                miss = measure_miss(arm, T, q, end, e, A)
        if miss > enough:
            return False
        for j in range(solved):
            if abs(u[j] + part * way[j] - end[j]) > STAYS * length:
                return False
    return True


@apart("boolean(float64[::1], float64[:, ::1], float64[::1], float64[::1], float64[::1], boolean)")
def is_same(arm: Floats, T: Floats, q: Floats, known: Floats, u: Floats, loose: bool) -> bool:
    """Whether a solution is taken for one that is known; loosely where both are singular."""
    solved = int(arm[SOLVED])
    between, gap = np.empty(solved), 0.0
    for j in range(solved):
        between[j] = u[j] - known[j]
    wrap_angles(arm, between)
    for j in range(solved):
        gap = max(gap, abs(between[j]))
    if gap < SAME:
        return True
    return loose and gap < NEIGHBOURS and _solves_between(arm, T, q, known, between, gap)


@apart(
    "int64(float64[::1], float64[:, ::1], float64[::1], float64[:, ::1], int64[::1], int64, "
    "float64[::1], boolean)"
)
def find_known(
    arm: Floats,
    T: Floats,
    q: Floats,
    kept: Floats,
    kinds: Ints,
    count: int,
    u: Floats,
    singular: bool,
) -> int:
    """Returns which of those found before a solution is; -1 for none."""
    for k in range(count):
        if is_same(arm, T, q, kept[k], u, singular and kinds[k] >= 0):
            return k
    return -1


@inner
def _clamp(arm: Floats, u: Floats, seen: Floats, inside: Floats) -> float:
    """Returns how far joint values exceed their limits; the nearest inside go into `inside`.

    Whole turns aside, but next to the seed's where they are just beyond an end there.
    """
    most = 0.0
    for j in range(int(arm[SOLVED])):
        at = RECORD * j
        low, high = arm[LOWEST + at], arm[HIGHEST + at]
        near, middle = u[j], 0.5 * (low + high)
        if arm[TURNS + at] > 0.0 and math.isfinite(middle):
            near -= TURN * math.floor((near - seen[j]) / TURN + 0.5)
            past = max(low - near, near - high)
            if past >= DOUBTFUL or abs(near - seen[j]) >= BESIDE_SEED:
                near -= TURN * math.ceil((near - middle) / TURN - 0.5)
        inside[j] = min(max(near, low), high)
        most = max(most, abs(inside[j] - near))
    return most


@apart(
    "boolean(float64[::1], float64[:, ::1], float64[::1], float64[::1], float64[::1], float64[::1])"
)
def _leads_inside(arm: Floats, T: Floats, q: Floats, near: Floats, u: Floats, end: Floats) -> bool:
    """Takes joint values on a way from u to a solution inside the limits; whether it can.

    It is as exact as a row has to be, and farther on if steps lead back.
    """
    solved = int(arm[SOLVED])
    way, start, inside = np.empty(solved), end.copy(), np.empty(solved)
    for j in range(solved):
        way[j] = start[j] - u[j]
    wrap_angles(arm, way)
    for part in FARTHER_ON:
        for j in range(solved):
            end[j] = start[j] + part * way[j]
        if descend(arm, T, q, end) <= PROMISED and _clamp(arm, end, near, inside) <= LIMIT:
            return True
    return False


@apart(
    "void(float64[::1], float64[:, ::1], float64[::1], float64[::1], float64[:, ::1], int64[::1], "
    "int64, boolean, float64, float64[::1])"
)
def _move_inside(
    arm: Floats,
    T: Floats,
    q: Floats,
    near: Floats,
    kept: Floats,
    kinds: Ints,
    count: int,
    alone: bool,
    enough: float,
    u: Floats,
) -> None:
    """Replaces a solution that is beyond a limit by one that keeps all of them.

    If the way to the seed inside the limits leads to one, from there or from the seed; where it
    stands alone to one that is taken for it and as exact as a row has to be.
    """
    solved = int(arm[SOLVED])
    end, low, high = np.empty(solved), np.empty(solved), np.empty(solved)
    if _clamp(arm, u, near, end) <= LIMIT:
        return
    for j in range(solved):
        low[j], high[j] = arm[LOWEST + RECORD * j], arm[HIGHEST + RECORD * j]
    for from_seed in range(2):
        _clamp(arm, near if from_seed else u, near, end)
        if descend_towards(arm, T, q, end, near, low, high) > enough:
            continue
        if alone and not _leads_inside(arm, T, q, near, u, end):
            continue
        new = find_known(arm, T, q, kept, kinds, count, end, True) < 0
        if new and (not alone or is_same(arm, T, q, u, end, True)):
            take(u, end)
            return


@inner
def _takes_place(arm: Floats, T: Floats, q: Floats, near: Floats, u: Floats, known: Floats) -> bool:
    """Whether a solution is kept instead of a known one that it is taken for.

    It is inside the limits, and as exact as a row has to be; the other one is not inside.
    """
    end = np.empty(int(arm[SOLVED]))
    if _clamp(arm, known, near, end) <= LIMIT or _clamp(arm, u, near, end) > LIMIT:
        return False
    e, A = np.empty(int(arm[EQUATIONS])), np.empty((int(arm[EQUATIONS]), int(arm[SOLVED])))
    return measure_miss(arm, T, q, u, e, A) <= PROMISED


@apart(
    "int64(float64[::1], float64[:, ::1], float64[::1], float64[::1], float64[:, ::1], int64[::1], "
    "int64, float64[::1])"
)
def keep(
    arm: Floats,
    T: Floats,
    q: Floats,
    near: Floats,
    kept: Floats,
    kinds: Ints,
    count: int,
    u: Floats,
) -> int:
    """Adds a solution to those found before, unless it is one of them; returns how many there are.

    Where one is exact the pose has not been rounded: then all have to be exact.
    """
    enough = enough_beside(arm, T, q, u)
    before = enough_beside(arm, T, q, kept[0]) if count else enough
    if before < enough:
        return count
    if before > enough:
        count = 0
    if count == int(arm[ROWS]) or find_known(arm, T, q, kept, kinds, count, u, False) >= 0:
        return count
    limited = arm[LIMITED] > 0.0
    kind = continuum(arm, T, q, u, enough)
    if kind == 1:
        end, everywhere = u.copy(), np.full(len(u), np.inf)
        descend_towards(arm, T, q, end, near, -everywhere, everywhere)
        if descend(arm, T, q, end) <= enough:
            take(u, end)
    if limited and kind >= 0:
        _move_inside(arm, T, q, near, kept, kinds, count, kind == 0, enough, u)
    wrap_angles(arm, u)
    k = find_known(arm, T, q, kept, kinds, count, u, kind >= 0)
    if k >= 0 and not (limited and _takes_place(arm, T, q, near, u, kept[k])):
        return count
    k = count if k < 0 else k
    kinds[k] = kind
    take(kept[k], u)
    return max(count, k + 1)


@inner
def _comes_before(a: Floats, b: Floats) -> bool:
    """Whether a row of joint values comes before another."""
    for i in range(len(a)):
        if abs(a[i] - b[i]) > TIE:
            return bool(a[i] < b[i])
    return False


@apart(
    "void(float64[::1], float64[:, ::1], int64[::1], int64, float64[::1], float64[:, ::1], "
    "boolean[::1], boolean[::1])"
)
def sort_rows(
    arm: Floats,
    kept: Floats,
    kinds: Ints,
    count: int,
    joints: Floats,
    q: Floats,
    found: Bools,
    chosen: Bools,
) -> None:
    """Fills rows by the first joint, then by the second and so on."""
    for k in range(count):
        row = k
        for j in range(int(arm[SOLVED])):
            at = RECORD * j
            joints[int(arm[PLACE + at])] = arm[UNIT + at] * kept[k, j]
        while row > 0 and _comes_before(joints, q[row - 1]):
            take(q[row], q[row - 1])
            chosen[row] = chosen[row - 1]
            row -= 1
        take(q[row], joints)
        chosen[row] = kinds[k] == 1
        found[k] = True


__all__ = ["EXACT", "SOLUTION", "continuum", "find_known", "is_same", "keep", "sort_rows"]
