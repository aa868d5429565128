# SPDX-License-Identifier: MIT
"""Angles: the arctangent, and an angle moved by whole turns to (-pi, pi]."""

from __future__ import annotations

import math

import numpy as np

from .jit import of_file
from .turns import TURN

_HOW = of_file(__file__)


@_HOW.njit(fastmath={"contract"})
def atan2(y: float, x: float) -> float:
    """math.atan2 by a polynomial: without branches, within 3 units in the last place.

    With r the smaller of |x| and |y| over the larger, or (far - near) / (far + near) where that is
    above tan(pi/8): atan r = r + r u p(u), u = r^2. p interpolates
    (atan sqrt(u) - sqrt(u)) / u^(3/2) at Chebyshev's nodes of [0, 0.1716], above tan(pi/8)^2.
    """
    along, across = abs(x), abs(y)
    far = max(across, along)
    near = min(along, across)
    steep = near > 0.41421356237309515 * far  # tan(pi/8)
    divisor = near + far if steep else far
    r = (near - far if steep else near) / (1.0 if divisor == 0.0 else divisor)
    u = r * r
    p = -0.01917454359469326
    p = p * u + 0.039229744582632814
    p = p * u - 0.050853834915688644
    p = p * u + 0.05858136252639731
    p = p * u - 0.0666450998991572
    p = p * u + 0.07692183087347286
    p = p * u - 0.0909090457366891
    p = p * u + 0.11111111015146682
    p = p * u - 0.14285714284665177
    p = p * u + 0.19999999999995513
    p = p * u - 0.3333333333333333
    angle = r + r * u * p + (0.7853981633974483 if steep else 0.0)
    angle = 1.5707963267948966 - angle if across > along else angle
    angle = 3.141592653589793 - angle if math.copysign(1.0, x) < 0.0 else angle
    return math.copysign(angle, y)


@_HOW.inner
def wrap(angle: float) -> float:
    """An angle moved by whole turns to (-pi, pi]."""
    wrapped: float = angle - TURN * np.ceil(angle / TURN - 0.5)
    return wrapped
