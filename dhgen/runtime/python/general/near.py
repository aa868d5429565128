# SPDX-License-Identifier: MIT
"""The nearest arm with a structure: joint values that lead to all solutions."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ..jit import of_file
from ..rigid import follow
from ..status import OK

if TYPE_CHECKING:
    from ..arrays import Floats, Ints

OWN = of_file(__file__)
inner = OWN.inner


@inner
def near_pose(pose: tuple[float, ...], left: Floats, right: Floats, kept: Floats) -> None:
    """Fills the first entries of `kept` with left T right: the pose of the nearest arm."""
    T = np.empty(12)
    for i in range(12):
        T[i] = pose[i]
        kept[i] = left[i]
    follow(kept, T)
    follow(kept, right)


@inner
def near_solutions(filled: Floats, places: Ints, offsets: Floats) -> Floats:
    """Returns the angles of the loop in the rows that hold a solution, (k, 6).

    Args:
        filled: What the formulas of regular poses fill in: joints' values, then statuses.
        places: Of the values of the loop's joints in each row, (rows, 6).
        offsets: What angles of the nearest arm are more than those of the loop.
    """
    rows, count = len(places), 0
    nearby = np.empty((rows, 6))
    for row in range(rows):
        if filled[len(filled) - rows + row] == OK:
            for i in range(6):
                nearby[count, i] = filled[places[row, i]] - offsets[i]
            count += 1
    return nearby[:count]
