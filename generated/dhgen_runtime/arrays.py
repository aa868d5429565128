# SPDX-License-Identifier: MIT
"""Types of arrays by what they hold, for annotations, and makers of arrays to be filled."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .jit import of_file

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]
Bytes = NDArray[np.uint8]

NONE_GIVEN = np.zeros(0)  # of values that the caller gives

OWN = of_file(__file__)


@OWN.inner
def zeros(rows: int, columns: int) -> Floats:
    """Returns a matrix of zeros: numba takes long to compile NumPy's own into every caller."""
    return np.zeros((rows, columns))
