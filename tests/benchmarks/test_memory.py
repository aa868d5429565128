"""Arrays that are measured begin where a cache line does."""

from __future__ import annotations

import numpy as np
import pytest

from benchmarks.memory import LINE, lined_up, room


@pytest.mark.parametrize("shape", [(1, 1, 1), (7, 4, 4), (2000, 8, 6), (33, 2, 4)])
def test_room_begins_at_a_line(shape: tuple[int, ...]) -> None:
    arrays = [room(shape) for _ in range(9)]
    assert {array.ctypes.data % LINE for array in arrays} == {0}
    assert all(array.shape == shape and array.flags.c_contiguous for array in arrays)


def test_a_copy_has_the_values() -> None:
    values = np.arange(24.0).reshape(2, 3, 4)
    copy = lined_up(values[:, ::-1])
    assert np.array_equal(copy, values[:, ::-1])
    assert copy.ctypes.data % LINE == 0
