"""Arrays that begin where a cache line does.

Allocators put large arrays at any multiple of 16 bytes. Vectors of 64 bytes that are written across
the ends of lines cost a batch a tenth to a third: by luck, which differs from run to run.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

LINE = 64  # bytes


def room(shape: tuple[int, ...]) -> FloatArray:
    """Zeros of this shape."""
    count = int(np.prod(shape))
    memory = np.zeros(count + LINE // 8)
    first = -memory.ctypes.data % LINE // memory.itemsize
    return memory[first : first + count].reshape(shape)


def lined_up(values: FloatArray) -> FloatArray:
    """A copy of numbers."""
    copy = room(values.shape)
    copy[:] = values
    return copy
