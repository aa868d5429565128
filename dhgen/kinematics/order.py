"""Which of two solutions comes first: the same in reference solvers and in what is emitted."""

from __future__ import annotations

from functools import cmp_to_key
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

TIE = 1e-9  # values closer than this don't decide which of two solutions comes first


def _ascending(first: FloatArray, second: FloatArray) -> int:
    """Negative when the joint values `first` (n,) come before `second`."""
    gaps = first - second
    apart = np.flatnonzero(np.abs(gaps) > TIE)
    return 0 if not len(apart) else int(np.sign(gaps[apart[0]]))


in_order = cmp_to_key(_ascending)  # a key to sort by
