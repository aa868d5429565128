"""Rows in order, whatever the order they were found in: values that agree to rounding are equal."""

from __future__ import annotations

from itertools import permutations

import numpy as np

from dhgen.runtime.plain import plain

SOLUTIONS = plain("numerical.solutions")
TIE = SOLUTIONS.TIE


def in_order(rows: list[list[float]]) -> list[list[float]]:
    count = len(rows)
    order, first = np.arange(count), np.zeros(count, np.bool_)
    for values in np.array(rows).T:
        if SOLUTIONS.order_blocks(values, TIE, count, order, first):
            break
    return [rows[place] for place in order]


def test_the_first_value_that_differs_decides() -> None:
    rows = [[1.0, 2.0], [1.0, -2.0], [-1.0, 3.0]]
    assert in_order(rows) == [[-1.0, 3.0], [1.0, -2.0], [1.0, 2.0]]


def test_values_that_agree_through_others_are_equal() -> None:
    """The first and the last differ by more than a tie: which came first must not matter."""
    rows = [[0.0, 3.0], [0.7 * TIE, 2.0], [1.4 * TIE, 1.0], [5.0, 0.0]]
    expected = [rows[2], rows[1], rows[0], rows[3]]
    for each in permutations(rows):
        assert in_order(list(each)) == expected


def test_minus_half_a_turn_counts_as_half_a_turn() -> None:
    assert SOLUTIONS.order_of(-np.pi, turns=True) == np.pi
    assert SOLUTIONS.order_of(-np.pi, turns=False) == -np.pi
    assert SOLUTIONS.order_of(2.0 * TIE - np.pi, turns=True) < 0.0
