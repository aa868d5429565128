"""Rows in order, whatever the order they were found in: values that agree to rounding are equal."""

from __future__ import annotations

import ctypes
from itertools import permutations

import numpy as np
import pytest

from dhgen.runtime.plain import plain
from tests.runtime.test_general_c import library, pointer

PYTHON = plain("numerical.solutions")
TIE = PYTHON.TIE
languages = pytest.mark.parametrize("language", ["C", "Python"])


def in_order(language: str, rows: list[list[float]]) -> list[list[float]]:
    count = len(rows)
    order: np.ndarray = np.arange(count)
    first = np.zeros(count, np.bool_)
    places, begins = np.arange(count, dtype=np.int32), np.zeros(count, np.uint8)
    for column in np.array(rows).T:
        values = np.ascontiguousarray(column)
        if language == "Python":
            single = PYTHON.order_blocks(values, TIE, count, order, first)
        else:
            single = library("").run_order(
                pointer(values), ctypes.c_double(TIE), count, pointer(places), pointer(begins)
            )
            order = places
        if single:
            break
    return [rows[place] for place in order]


def counted(language: str, value: float, *, turns: bool) -> float:
    if language == "Python":
        return float(PYTHON.order_of(value, turns))
    return float(library("").run_order_of(ctypes.c_double(value), int(turns)))


@languages
def test_the_first_value_that_differs_decides(language: str) -> None:
    rows = [[1.0, 2.0], [1.0, -2.0], [-1.0, 3.0]]
    assert in_order(language, rows) == [[-1.0, 3.0], [1.0, -2.0], [1.0, 2.0]]


@languages
def test_values_that_agree_through_others_are_equal(language: str) -> None:
    """The first and the last differ by more than a tie: which came first must not matter."""
    rows = [[0.0, 3.0], [0.7 * TIE, 2.0], [1.4 * TIE, 1.0], [5.0, 0.0]]
    expected = [rows[2], rows[1], rows[0], rows[3]]
    for each in permutations(rows):
        assert in_order(language, list(each)) == expected


@languages
def test_minus_half_a_turn_counts_as_half_a_turn(language: str) -> None:
    assert counted(language, -np.pi, turns=True) == np.pi
    assert counted(language, -np.pi, turns=False) == -np.pi
    assert counted(language, 2.0 * TIE - np.pi, turns=True) < 0.0
