# SPDX-License-Identifier: MIT
"""What callers give besides a pose, left to the seed: joint values, or the arm angle."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from .retry import HALVINGS

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from numpy.typing import NDArray

    FloatArray = NDArray[np.float64]

FAN = 64  # values that are tried to each side of the seed's in half a turn, or a slide's stroke


def nearest_that_works(
    attempt: Callable[[float], FloatArray | None],
    value: float,
    reach: float,
    within: tuple[float, float],
) -> FloatArray | None:
    """The solution with the value nearest to the seed's that has one; None if none is found.

    A fan of values shows where it works, bisection the end that is nearest to the seed; of two that
    are equally near the lower one. What works only between two values of the fan is overlooked.
    Values beyond the limits are not tried: they would be moved by whole turns, which is far.

    Args:
        attempt: The solution with a value, or None.
        value: The seed's.
        reach: Half a turn, or a slide's stroke [rad or length].
        within: The limits of the value, infinite where there are none.
    """
    low, high = within
    start = min(max(value, low), high)
    if start != value and (first := attempt(start)) is not None:
        return first
    limited = math.isfinite(low) or math.isfinite(high)
    for k in range(1, (2 * FAN if limited else FAN) + 1):
        for side in (-1.0, 1.0):
            ends = [start + side * reach * j / FAN for j in (k, k - 1)]
            outer, inner = (min(max(end, low), high) for end in ends)
            found = attempt(outer) if outer != inner else None
            if found is not None:
                return _nearest_end(attempt, inner, outer, found)
    return None


def _nearest_end(
    attempt: Callable[[float], FloatArray | None], inner: float, outer: float, found: FloatArray
) -> FloatArray:
    """The solution at the end of values that work, between one that does not and one that does."""
    for _ in range(HALVINGS):
        middle = 0.5 * (inner + outer)
        between = attempt(middle)
        if between is None:
            inner = middle
        else:
            outer, found = middle, between
    return found
