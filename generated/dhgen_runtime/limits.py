# SPDX-License-Identifier: MIT
"""Joint values and their limits."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .coupled_turns import coupled_beyond, turns_coupled
from .jit import of_file
from .places import (
    COUPLING,
    DOF,
    HIGHEST,
    LOWEST,
    RANGE_EXCEEDS_A_TURN,
    RECORD,
    SLACK,
    TURNS,
    WEIGHT,
)
from .tolerances import BESIDE_SEED, DOUBTFUL
from .turns import TURN, turned

if TYPE_CHECKING:
    from .arrays import Floats

OWN = of_file(__file__)

# Ranges wider than this leave next to no gap [rad]: near a singular pose rounding crosses it.
NEARLY_A_TURN = TURN - 0.1


@OWN.inner
def ends_of(arm: Floats, joint: int) -> tuple[float, float]:
    """The limits of a joint, without slack."""
    at = RECORD * joint
    return arm[LOWEST + at] + arm[SLACK + at], arm[HIGHEST + at] - arm[SLACK + at]


@OWN.inner
def overshoot(arm: Floats, joint: int, value: float) -> float:
    """How far a joint value is beyond its limits, whole turns aside; negative below."""
    low, high = ends_of(arm, joint)
    if low <= value <= high:
        return 0.0
    off: float = value - high if value > high else value - low
    if arm[TURNS + RECORD * joint] > 0.0:
        gap, over = TURN - (high - low), value - high
        rest = over - TURN * math.floor(over / TURN)
        off = 0.0 if rest >= gap else rest if rest <= gap - rest else rest - gap
    return 0.0 if abs(off) <= 0.5 * arm[SLACK + RECORD * joint] else off


@OWN.inner
def beyond_limits(arm: Floats, q: Floats) -> float:
    """How far joint values, and sums of them, are beyond limits [rad, arm sizes].

    Whole turns aside.
    """
    total = coupled_beyond(arm, q) if arm[COUPLING] > 0.0 else 0.0
    for i in range(int(arm[DOF])):
        if turns_coupled(arm, i):
            continue
        total += abs(overshoot(arm, i, q[i])) * math.sqrt(arm[WEIGHT + RECORD * i])
    return total


@OWN.inner
def past_an_end(arm: Floats, joint: int, value: float) -> float:
    """How far a joint value is past an end of its range; negative below.

    Where the range is nearly a turn the value is not turned: that would take it across the gap.
    """
    at = RECORD * joint
    if arm[RANGE_EXCEEDS_A_TURN] == 0.0 or arm[HIGHEST + at] - arm[LOWEST + at] < NEARLY_A_TURN:
        return overshoot(arm, joint, value)
    low, high = ends_of(arm, joint)
    off: float = value - min(max(value, low), high)
    return 0.0 if abs(off) <= 0.5 * arm[SLACK + at] else off


@OWN.inner
def past_ends(arm: Floats, q: Floats) -> float:
    """How far joint values are past the ends of their ranges [rad, arm sizes]."""
    total = 0.0
    for i in range(int(arm[DOF])):
        total += abs(past_an_end(arm, i, q[i])) * math.sqrt(arm[WEIGHT + RECORD * i])
    return total


@OWN.inner
def at_an_end(arm: Floats, joint: int, value: float, seed: float) -> float:
    """A joint value turned inside its limits, or next to the end that it and the seed are at."""
    if arm[TURNS + RECORD * joint] == 0.0:
        return value
    near = value + TURN * math.floor((seed - value) / TURN + 0.5)
    if 0.0 < abs(past_an_end(arm, joint, near)) < DOUBTFUL and abs(near - seed) < BESIDE_SEED:
        return near
    off = overshoot(arm, joint, value)
    if off == 0.0 or abs(off) > DOUBTFUL:
        return turned(arm, joint, value, value)
    low, high = ends_of(arm, joint)
    return off + (high if off > 0.0 else low)
