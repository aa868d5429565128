"""A whole pose for a tool that only points: any turn about its own axis serves."""

from __future__ import annotations

from math import copysign
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray


def any_turn(T: FloatArray) -> FloatArray:
    """A rigid transform with the z axis and the position of T.

    T. Duff et al., Building an orthonormal basis, revisited (2017): the axes x and y without a
    root and without a choice, whatever z is.

    Args:
        T: (4, 4); its columns z, of length one, and position count.
    """
    x, y, z = T[:3, 2].tolist()
    side = copysign(1.0, z)
    a = -1.0 / (side + z)
    whole = np.eye(4)
    whole[:3, 0] = 1.0 + side * x * x * a, side * x * y * a, -side * x
    whole[:3, 1] = x * y * a, side + y * y * a, -y
    whole[:3, 2:] = T[:3, 2:]
    return whole
