"""Solutions from joint values that are said to be near them, in C and in plain Python."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from tests.general.arms import compiled, gap, kernel, one_by_one, poses
from tests.general.solved import solve_slowly
from tests.structures import first_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.general.arms import Answer

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

ARMS = ("general", "xarm6", "manseur_doty")
OFF = 1e-3


def solver(name: str, how: str) -> Callable[..., Answer]:
    return compiled(name) if how == "lanes" else one_by_one(kernel(name))


@pytest.mark.parametrize("how", ["lanes", "one"])
@pytest.mark.parametrize("name", first_of(ARMS))
def test_from_near_all(name: str, how: str) -> None:
    """Those that the elimination finds; but for rounding these are other numbers."""
    rng, moved, solve = np.random.default_rng(1), 0, solver(name, how)
    for number, (_, T) in enumerate(poses(name, 40)):
        wanted, _, certain = compiled(name)(T)
        if not certain:
            continue
        nearby = wanted + rng.uniform(-OFF, OFF, wanted.shape)
        found, _, certain = solve(T, nearby)
        assert certain
        assert len(found) == len(wanted)
        np.testing.assert_allclose(gap(found, wanted), 0.0, atol=1e-9)
        moved += not np.array_equal(found, wanted)
        if number < 3 and how == "lanes":
            slowly = solve_slowly(T, kernel(name), (), nearby)
            assert slowly.certain
            assert len(slowly.q) == len(wanted)
            np.testing.assert_allclose(gap(slowly.q, found), 0.0, atol=1e-10)
    assert moved > 20


@pytest.mark.parametrize("name", first_of(ARMS))
def test_two_that_lead_to_one_are_not_all(name: str) -> None:
    """Then the elimination has the last word, to the last digit."""
    for number, (_, T) in enumerate(poses(name, 10)):
        wanted, _, certain = compiled(name)(T)
        if len(wanted) < 2:
            continue
        nearby = wanted + OFF
        nearby[1] = wanted[0] - OFF
        found, _, sure = compiled(name)(T, nearby)
        np.testing.assert_array_equal(found, wanted)
        assert sure == certain
        if number < 2:
            slowly = solve_slowly(T, kernel(name), (), nearby)
            np.testing.assert_allclose(gap(slowly.q, wanted), 0.0, atol=1e-8)


@pytest.mark.parametrize("name", first_of(ARMS))
def test_what_leads_nowhere(name: str) -> None:
    """As many as there are solutions, from anywhere, and no numbers at all."""
    rng = np.random.default_rng(2)
    for _, T in poses(name, 10):
        wanted, _, _ = compiled(name)(T)
        starts = np.full((1, 6), np.nan), rng.uniform(-np.pi, np.pi, (16, 6))
        for nearby in starts:
            found, _, _ = compiled(name)(T, nearby)
            np.testing.assert_array_equal(found, wanted)
