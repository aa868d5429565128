# SPDX-License-Identifier: MIT
"""Whole turns: a joint value moved by them inside its limits, and near to another one."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .jit import of_file
from .places import HIGHEST, LOWEST, RECORD, TURNS
from .tolerances import FAR_ANGLE

if TYPE_CHECKING:
    from .arrays import Floats

TURN = 2.0 * math.pi  # [rad]

OWN = of_file(__file__)


@OWN.inner
def turned(arm: Floats, joint: int, given: float, towards: float) -> float:
    """A joint value moved by whole turns, near to another value but inside its limits.

    Args:
        arm: The arm's numbers.
        joint: Which of its joints, from 0.
        given: The value.
        towards: The other value.

    Returns:
        The value moved, or as it was given where no whole turns take it inside its limits.
    """
    at = RECORD * joint
    if arm[TURNS + at] == 0.0:
        return given
    low, high = arm[LOWEST + at], arm[HIGHEST + at]
    value = given
    if abs(towards) < FAR_ANGLE:
        value += TURN * math.floor((towards - given) / TURN + 0.5)
    if value > high:
        value -= TURN * math.ceil((value - high) / TURN)
    if value < low:
        value += TURN * math.ceil((low - value) / TURN)
    return value if value <= high else given


@OWN.inner
def near(arm: Floats, joint: int, value: float, towards: float) -> float:
    """A joint value moved by whole turns near to another value, limits aside."""
    if arm[TURNS + RECORD * joint] == 0.0 or not abs(towards) < FAR_ANGLE:
        return value
    return value + TURN * math.floor((towards - value) / TURN + 0.5)


@OWN.inner
def without_turns(angle: float) -> float:
    """An angle without its whole turns, beside which a search would lose small moves."""
    return math.copysign(abs(angle) % TURN, angle)
