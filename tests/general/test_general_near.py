"""Solutions from joint values that are near them, in C and in plain Python."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from tests.general.arms import compiled, correcting, gap, kernel, poses, without_lanes
from tests.general.solved import correct_slowly
from tests.structures import first_of

if TYPE_CHECKING:
    from collections.abc import Callable

    from tests.general.arms import Corrected

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

ARMS = ("general", "xarm6", "manseur_doty")
OFF = 1e-3
WELL_APART = 0.01


def corrector(name: str, how: str) -> Callable[[np.ndarray, np.ndarray], Corrected]:
    return correcting(name) if how == "lanes" else correcting(name, *without_lanes())


@pytest.mark.parametrize("how", ["lanes", "one"])
@pytest.mark.parametrize("name", first_of(ARMS))
def test_from_near_all(name: str, how: str) -> None:
    """Those that the elimination finds; but for rounding these are other numbers."""
    rng, moved, correct = np.random.default_rng(1), 0, corrector(name, how)
    for number, (_, T) in enumerate(poses(name, 40)):
        wanted, _, certain = compiled(name)(T)
        if not certain:
            continue
        nearby = wanted + rng.uniform(-OFF, OFF, wanted.shape)
        found, is_sure = correct(T, nearby)
        apart = [gap(q, other) for k, q in enumerate(wanted) for other in wanted[:k]]
        assert is_sure == (min(apart, default=np.inf) > WELL_APART)
        if not is_sure:
            continue
        np.testing.assert_allclose(gap(found, wanted), 0.0, atol=1e-9)
        moved += not np.array_equal(found, wanted)
        if number < 3 and how == "lanes":
            slowly, is_sure = correct_slowly(T, kernel(name), nearby)
            assert is_sure
            np.testing.assert_allclose(gap(slowly, found), 0.0, atol=1e-10)
    assert moved > 20


@pytest.mark.parametrize("name", first_of(ARMS))
def test_two_that_lead_to_one_are_not_all(name: str) -> None:
    for number, (_, T) in enumerate(poses(name, 10)):
        wanted, _, _ = compiled(name)(T)
        if len(wanted) < 2:
            continue
        nearby = wanted + OFF
        nearby[1] = wanted[0] - OFF
        assert not correcting(name)(T, nearby)[1]
        if number < 2:
            assert not correct_slowly(T, kernel(name), nearby)[1]


@pytest.mark.parametrize("name", first_of(ARMS))
def test_what_leads_nowhere(name: str) -> None:
    """No numbers at all, and poses out of reach."""
    for q, T in poses(name, 10):
        assert not correcting(name)(T, np.full((1, 6), np.nan))[1]
        far = T.copy()
        far[:3, 3] += 100.0
        assert not correcting(name)(far, q[None])[1]
