# SPDX-License-Identifier: MIT
"""How a solution joins the ones found before, inside limits if it can."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from ..rigid import take
from ..tolerances import LIMIT, PROMISED
from .descent import descend, descend_towards, measure_miss, wrap_angles
from .family import clamp, go_to_nearest_member
from .goal import GOAL
from .places import EQUATIONS, HIGHEST, LIMITED, LOWEST, RECORD, ROWS, SOLVED
from .solutions import AHEAD, continuum, enough_beside, find_known, is_same

if TYPE_CHECKING:
    from ..arrays import Floats, Ints
    from .goal import Goal
    from .solutions import Ahead

OWN = of_file(__file__)
apart, inner = OWN.apart, OWN.inner

# Where a solution beyond a limit is one of two that nearly meet the other lies across a singular
# place, and steps from the limit may go back to it: how far to go on, as parts of the way there.
FARTHER_ON = (0.0, 1.0, 3.0, 7.0, 15.0)


@apart(f"boolean(float64[::1], {GOAL}, float64[::1], float64[::1], float64[::1], float64[::1])")
def _leads_inside(arm: Floats, goal: Goal, q: Floats, near: Floats, u: Floats, end: Floats) -> bool:
    """Takes joint values on a way from u to a solution inside the limits; whether it can.

    It is as exact as a row has to be, and farther on if steps return to the first one.
    """
    solved = int(arm[SOLVED])
    way, start, inside = np.empty(solved), end.copy(), np.empty(solved)
    for j in range(solved):
        way[j] = start[j] - u[j]
    wrap_angles(arm, way)
    for part in FARTHER_ON:
        for j in range(solved):
            end[j] = start[j] + part * way[j]
        if descend(arm, goal, q, end) <= PROMISED and clamp(arm, end, near, inside) <= LIMIT:
            return True
    return False


@apart(
    f"void(float64[::1], {GOAL}, float64[::1], float64[::1], float64[:, ::1], int64[::1], "
    "int64, boolean, float64, float64[::1])"
)
def _move_inside(
    arm: Floats,
    goal: Goal,
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

    If one is found on the way to the seed inside the limits, from there or from the seed; an
    isolated solution to one that counts as the same and is as exact as a row has to be.
    """
    solved = int(arm[SOLVED])
    end, low, high = np.empty(solved), np.empty(solved), np.empty(solved)
    if clamp(arm, u, near, end) <= LIMIT:
        return
    for j in range(solved):
        low[j], high[j] = arm[LOWEST + RECORD * j], arm[HIGHEST + RECORD * j]
    for from_seed in range(2):
        clamp(arm, near if from_seed else u, near, end)
        if descend_towards(arm, goal, q, end, near, low, high) > enough:
            continue
        if alone and not _leads_inside(arm, goal, q, near, u, end):
            continue
        new = find_known(arm, goal, q, kept, kinds, count, end, True) < 0
        if new and (not alone or is_same(arm, goal, q, u, end, True)):
            take(u, end)
            return


@inner
def _takes_place(
    arm: Floats, goal: Goal, q: Floats, near: Floats, u: Floats, known: Floats
) -> bool:
    """Whether a solution is kept instead of a known one that it is taken for.

    It is inside the limits, and as exact as a row has to be; the other one is not inside.
    """
    end = np.empty(int(arm[SOLVED]))
    if clamp(arm, known, near, end) <= LIMIT or clamp(arm, u, near, end) > LIMIT:
        return False
    e, A = np.empty(int(arm[EQUATIONS])), np.empty((int(arm[EQUATIONS]), int(arm[SOLVED])))
    return measure_miss(arm, goal, q, u, e, A) <= PROMISED


@apart(
    f"int64(float64[::1], {GOAL}, float64[::1], float64[::1], float64[:, ::1], int64[::1], "
    f"int64, float64[::1], {AHEAD})"
)
def keep(
    arm: Floats,
    goal: Goal,
    q: Floats,
    near: Floats,
    kept: Floats,
    kinds: Ints,
    count: int,
    u: Floats,
    ahead: Ahead,
) -> int:
    """Adds a solution to the ones kept, unless it is one of them; returns how many there are.

    Where one is exact the pose has not been rounded: then all have to be exact. What is ahead and
    of the same continuum is marked.
    """
    enough = enough_beside(arm, goal, q, u)
    before = enough_beside(arm, goal, q, kept[0]) if count else enough
    if before < enough:
        return count
    if before > enough:
        count = 0
    if count == int(arm[ROWS]) or find_known(arm, goal, q, kept, kinds, count, u, False) >= 0:
        return count
    limited = arm[LIMITED] > 0.0
    kind = continuum(arm, goal, q, u, enough)
    if kind == 1:
        go_to_nearest_member(arm, goal, q, near, enough, u, ahead)
    if limited and kind >= 0:
        _move_inside(arm, goal, q, near, kept, kinds, count, kind == 0, enough, u)
    wrap_angles(arm, u)
    k = find_known(arm, goal, q, kept, kinds, count, u, kind >= 0)
    if k >= 0 and not (limited and _takes_place(arm, goal, q, near, u, kept[k])):
        return count
    k = count if k < 0 else k
    kinds[k] = kind
    take(kept[k], u)
    return max(count, k + 1)
