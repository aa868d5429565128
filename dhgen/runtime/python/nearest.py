# SPDX-License-Identifier: MIT
"""The solution nearest to a seed."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .jit import of_file
from .places import RECORD, WEIGHT
from .status import OUT_OF_LIMITS, UNREACHABLE
from .turns import near, turned

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

_HOW = of_file(__file__)


@_HOW.jit
def nearest(
    arm: NDArray[np.float64],
    rows: NDArray[np.float64],
    status: NDArray[np.uint8],
    seed: NDArray[np.float64],
    limits: bool,
    q: NDArray[np.float64],
) -> bool:
    """The solution nearest to the seed into q; whether there is one.

    Args:
        arm: The arm's numbers.
        rows: Solutions; their angles are moved by whole turns.
        status: What each of them holds.
        seed: Where the arm is.
        limits: Whether joint limits count.
        q: Is filled.
    """
    best, least = -1, math.inf
    for row in range(len(rows)):
        if status[row] == UNREACHABLE or (limits and status[row] == OUT_OF_LIMITS):
            continue
        distance = 0.0
        for i in range(len(q)):
            if limits:
                rows[row, i] = turned(arm, i, rows[row, i], seed[i])
            else:
                rows[row, i] = near(arm, i, rows[row, i], seed[i])
            moved = rows[row, i] - seed[i]
            distance += arm[WEIGHT + RECORD * i] * moved * moved
        if best < 0 or distance < least:
            best, least = row, distance
    for i in range(len(q)):
        q[i] = rows[best, i]
    return best >= 0
