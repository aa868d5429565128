"""Roots on the circle of many polynomials, by the runtime: the meaning of `Roots`."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.runtime.python.circle_roots import circle_roots
from dhgen.runtime.python.jit import of_file

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray

OWN = of_file(__file__)


@OWN.jit
def roots_of(polynomials: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
    """The roots of each polynomial of degree 2 on the circle, and which are close.

    Args:
        polynomials: What `circle_roots` takes: a0, a1, b1, a2, b2 and rounding, shape (N, 6).

    Returns:
        Angles, ascending in (-pi, pi], NaN where there are fewer, and whether one is double or has
        another close to it, both of shape (N, 4).
    """
    roots = np.empty((len(polynomials), 4))
    close = np.empty((len(polynomials), 4), np.bool_)
    for k in range(len(polynomials)):
        a0, a1, b1, a2, b2, rounding = polynomials[k]
        roots[k], close[k] = circle_roots(a0, a1, b1, a2, b2, rounding, 0.0)
    return roots, close
