"""What compiling takes: every figure is measured where it is asked for."""

from __future__ import annotations

import math

import pytest

from benchmarks.sizes import CALLS, HEAD, measure


@pytest.mark.breadth
def test_first_calls_and_those_from_the_cache() -> None:
    figures = measure("planar_rr", with_numba=True)
    assert len(figures) == len(HEAD) - 1
    assert all(figure > 0.0 for figure in figures)
    *first, cached = figures[-len(CALLS) :]
    assert cached < sum(first)


def test_without_numba() -> None:
    assert list(map(math.isnan, measure("planar_rr", with_numba=False)[-len(CALLS) :])) == [
        True
    ] * len(CALLS)
