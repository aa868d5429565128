# SPDX-License-Identifier: MIT
"""The member of a continuum of solutions that is nearest to the seed.

A continuum gives one row, whichever of its members was found: which one that is rounding decides,
as it does where a descent ends that is drawn to the seed along a bend.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from ..rigid import take
from ..tolerances import BESIDE_SEED, DOUBTFUL, LIMIT
from ..turns import TURN
from .descent import (
    descend,
    descend_towards,
    measure_miss,
    null_part,
    sideways,
    wrap_angles,
)
from .goal import GOAL
from .places import EQUATIONS, HIGHEST, LIMITED, LOWEST, RECORD, SOLVED, TURNS
from .solutions import AHEAD, SINGULAR, pass_by

if TYPE_CHECKING:
    from ..arrays import Floats
    from .goal import Goal
    from .solutions import Ahead

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

# From member to member [rad, arm sizes], and how many to each side: a closed family is mostly less
# than two turns long.
WALK_STEP = 0.2
WALK_STEPS = 120
# The walk has come round when its beginning is just behind, no farther than this part of a step,
# and the direction is about the same.
WALK_CLOSED = 1.2
# Steps to where the distance from the seed is least; one below the length is the last.
LEAST_STEPS = 40
LEAST_SETTLED = 1e-11
# Two members are equally near to the seed when the squares of their distances differ by less; then
# values that differ by more than the second decide [rad, arm sizes].
EQUALLY_NEAR = 1e-7
MEMBER_TIE = 1e-6
# What is known of a walk besides where it is: how the distance from the seed falls along it; the
# square of that of the best member where it is least, and whether that is inside the limits, -1
# where there is none; the square of that of the nearest one inside that the walk came by.
FALL, BEST_SQUARE, BEST_INSIDE, INSIDE_SQUARE = range(4)


@inner
def clamp(arm: Floats, u: Floats, seen: Floats, inside: Floats) -> float:
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


@inner
def _shortest_way(arm: Floats, start: Floats, end: Floats, way: Floats) -> float:
    """Computes the way from joint values to others, whole turns aside; the square of its length."""
    square = 0.0
    for j in range(len(way)):
        way[j] = end[j] - start[j]
    wrap_angles(arm, way)
    for j in range(len(way)):
        square += way[j] * way[j]
    return square


@inner
def _product(a: Floats, b: Floats) -> float:
    total = 0.0
    for j in range(len(a)):
        total += a[j] * b[j]
    return total


@apart(
    f"boolean(float64[::1], {GOAL}, float64[::1], float64[::1], float64, float64, "
    "float64[::1], float64[::1], float64[::1])"
)
def _walk_on(
    arm: Floats,
    goal: Goal,
    q: Floats,
    near: Floats,
    step: float,
    enough: float,
    u: Floats,
    along: Floats,
    walk: Floats,
) -> bool:
    """Goes from a member of a continuum to another, so far along it; not where that ends."""
    solved = int(arm[SOLVED])
    e, A, way = np.empty(int(arm[EQUATIONS])), np.empty((int(arm[EQUATIONS]), solved)), u.copy()
    for j in range(solved):
        u[j] += step * along[j]
    if descend(arm, goal, q, u) > enough:
        return False
    measure_miss(arm, goal, q, u, e, A)
    length = null_part(A, along)
    _shortest_way(arm, u, near, way)
    walk[FALL] = _product(way, along)
    return bool(length > SINGULAR)


@inner
def _keep_nearer(arm: Floats, near: Floats, u: Floats, walk: Floats, best: Floats) -> None:
    """Keeps of a member and the best one so far that which is nearer to the seed.

    Inside the limits if one is, and of two that are equally near the one that rows would begin
    with.
    """
    other = u.copy()
    square = _shortest_way(arm, u, near, other)
    inside = 1.0 if arm[LIMITED] == 0.0 or clamp(arm, u, near, other) <= LIMIT else 0.0
    wrap_angles(arm, u)
    better = square < walk[BEST_SQUARE]
    if abs(square - walk[BEST_SQUARE]) <= EQUALLY_NEAR:
        for j in range(len(u) - 1, -1, -1):
            if abs(u[j] - best[j]) > MEMBER_TIE:
                better = u[j] < best[j]
    if inside != walk[BEST_INSIDE]:
        better = inside > walk[BEST_INSIDE]
    if better:
        take(best, u)
        walk[BEST_SQUARE], walk[BEST_INSIDE] = square, inside


@apart(
    f"void(float64[::1], {GOAL}, float64[::1], float64[::1], float64, float64[::1], "
    "float64[::1], float64[::1], float64[::1])"
)
def _walk_to_least(
    arm: Floats,
    goal: Goal,
    q: Floats,
    near: Floats,
    enough: float,
    u: Floats,
    along: Floats,
    walk: Floats,
    best: Floats,
) -> None:
    """Goes to where the distance from the seed is least, nearby: a secant method."""
    per_fall = 1.0
    for _ in range(LEAST_STEPS):
        before = walk[FALL]
        step = min(max(per_fall * before, -WALK_STEP), WALK_STEP)
        if not _walk_on(arm, goal, q, near, step, enough, u, along, walk):
            return
        if abs(step) < LEAST_SETTLED:
            break
        change = before - walk[FALL]
        per_fall = step / change if step * change > 0.0 else 1.0
    _keep_nearer(arm, near, u, walk, best)


@inner
def _note_inside(arm: Floats, near: Floats, u: Floats, walk: Floats, kept: Floats) -> None:
    """Keeps where the walk is if that is the nearest to the seed inside the limits so far."""
    other = u.copy()
    square = _shortest_way(arm, u, near, other)
    if square < walk[INSIDE_SQUARE] and clamp(arm, u, near, other) <= LIMIT:
        walk[INSIDE_SQUARE] = square
        take(kept, other)


@inner
def _walk_along(
    arm: Floats,
    goal: Goal,
    q: Floats,
    near: Floats,
    enough: float,
    u: Floats,
    first: Floats,
    walk: Floats,
    best: Floats,
    inside: Floats,
    ahead: Ahead,
) -> bool:
    """Looks for the nearest members to one side, and marks solutions ahead that it comes by.

    Returns whether the walk came round.
    """
    start, along, way, closed = u.copy(), first.copy(), u.copy(), WALK_CLOSED * WALK_STEP
    _shortest_way(arm, start, near, way)
    walk[FALL] = _product(way, along)
    for k in range(WALK_STEPS):
        before = walk[FALL]
        if not _walk_on(arm, goal, q, near, WALK_STEP, enough, u, along, walk):
            return False
        pass_by(arm, goal, q, u, ahead)
        after = walk[FALL]
        if before >= 0.0 > after:
            _walk_to_least(arm, goal, q, near, enough, u.copy(), along.copy(), walk, best)
            walk[FALL] = after
        if arm[LIMITED] > 0.0:
            _note_inside(arm, near, u, walk, inside)
        behind = _shortest_way(arm, u, start, way) < closed * closed and _product(way, along) <= 0.0
        if k > 1 and behind and _product(along, first) > 0.5:
            return True
    return False


@apart(f"void(float64[::1], {GOAL}, float64[::1], float64[::1], float64, float64[::1], {AHEAD})")
def go_to_nearest_member(
    arm: Floats, goal: Goal, q: Floats, near: Floats, enough: float, u: Floats, ahead: Ahead
) -> None:
    """Takes a member of a continuum to the one that is nearest to the seed.

    Inside the limits if it can. Marks the others of it that are ahead.
    """
    solved = int(arm[SOLVED])
    e, A = np.empty(int(arm[EQUATIONS])), np.empty((int(arm[EQUATIONS]), solved))
    first, best, inside = np.empty(solved), u.copy(), u.copy()
    walk = np.array([0.0, math.inf, -1.0, math.inf])
    measure_miss(arm, goal, q, u, e, A)
    sideways(arm, A, first)
    for side in range(2):
        for j in range(solved):
            first[j] = -first[j] if side else first[j]
        if _walk_along(arm, goal, q, near, enough, u.copy(), first, walk, best, inside, ahead):
            break
    take(u, best)
    if walk[BEST_INSIDE] < 1.0 and walk[INSIDE_SQUARE] < math.inf:
        low, high = np.empty(solved), np.empty(solved)
        for j in range(solved):
            low[j], high[j] = arm[LOWEST + RECORD * j], arm[HIGHEST + RECORD * j]
        if descend_towards(arm, goal, q, inside, near, low, high) <= enough:
            take(u, inside)
