# SPDX-License-Identifier: MIT
"""Whole turns: a joint value moved by them inside its limits, and near to another one.

An arm's joints are a table, a row each, with the columns that are named here.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .jit import of_file

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

LOWEST, HIGHEST = 0, 1  # the limits, with the slack for rounding added [rad or length]
TURNS = 2  # 1 for a joint that turns, 0 for one that slides
WEIGHT = 3  # of squared differences: 1, for slides 1 / size^2 of the arm

TURN = 2.0 * math.pi  # [rad]
# A seed's angle that is not below this has no copy of another angle near to it that keeps its
# digits: angles are not moved there [rad].
FAR = 1e5

_HOW = of_file(__file__)


@_HOW.inner
def turned(joints: NDArray[np.float64], joint: int, given: float, towards: float) -> float:
    """A joint value moved by whole turns, near to another value but inside its limits.

    Args:
        joints: The arm's joints.
        joint: Which of them, from 0.
        given: The value.
        towards: The other value.

    Returns:
        The value moved, or as it was given where no whole turns take it inside its limits.
    """
    if joints[joint, TURNS] == 0.0:
        return given
    low, high = joints[joint, LOWEST], joints[joint, HIGHEST]
    value = given
    if abs(towards) < FAR:
        value += TURN * math.floor((towards - given) / TURN + 0.5)
    if value > high:
        value -= TURN * math.ceil((value - high) / TURN)
    if value < low:
        value += TURN * math.ceil((low - value) / TURN)
    return value if value <= high else given


@_HOW.inner
def near(joints: NDArray[np.float64], joint: int, value: float, towards: float) -> float:
    """A joint value moved by whole turns near to another value, limits aside."""
    if joints[joint, TURNS] == 0.0 or not abs(towards) < FAR:
        return value
    return value + TURN * math.floor((towards - value) / TURN + 0.5)
