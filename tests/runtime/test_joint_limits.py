"""Joint values and their limits, by trying all whole turns."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest

from dhgen.runtime.python.arm import STEPS, arm_numbers
from dhgen.runtime.python.limits import NEARLY_A_TURN
from dhgen.runtime.python.places import DESCENTS, RETRIES
from dhgen.runtime.python.turns import TURN
from tests.runtime.arms import arm_of, called
from tests.runtime.plain import KINDS

LIMITS = ((-2.0, 2.5), (-3.1, 3.1), (-4.0, 4.0), (-0.2, 0.3), (-math.inf, math.inf))
ARM = arm_of("RRRPR", LIMITS, steps=("range exceeds a turn",))
VALUES = np.linspace(-9.0, 9.0, 361)


def beyond_by_trying(joint: int, value: float) -> float:
    """How far the nearest copy of a value is beyond the limits."""
    low, high = LIMITS[joint]
    copies = value + (ARM.types[joint] == "R") * TURN * np.arange(-4, 5)
    return float(np.maximum(np.maximum(copies - high, low - copies), 0.0).min())


@pytest.mark.parametrize("kind", KINDS)
def test_beyond_limits_as_by_trying_all_turns(kind: str) -> None:
    numbers, overshoot = arm_numbers(ARM), called(kind, "limits", "overshoot")
    for joint in range(5):
        for value in VALUES:
            off = overshoot(numbers, joint, value)
            assert abs(off) == pytest.approx(beyond_by_trying(joint, value), abs=1e-9)


@pytest.mark.parametrize("kind", KINDS)
def test_a_row_is_as_far_beyond_as_its_joints_together(kind: str) -> None:
    """Lengths count in arm sizes: the slide of this arm weighs four times."""
    q = np.array([3.0, 0.0, 0.0, 0.5, 7.0])
    total = called(kind, "limits", "beyond_limits")(arm_numbers(ARM), q)
    assert total == pytest.approx(0.5 + 2.0 * 0.2)


@pytest.mark.parametrize("kind", KINDS)
def test_only_ranges_of_nearly_a_turn_are_left_as_they_are(kind: str) -> None:
    past, numbers = called(kind, "limits", "past_an_end"), arm_numbers(ARM)
    for joint, (low, high) in enumerate(LIMITS[:3]):
        turned = past(numbers, joint, high + TURN - 0.01)
        as_it_is = high - low > NEARLY_A_TURN
        assert turned == pytest.approx(TURN - 0.01 if as_it_is else 0.0)


@pytest.mark.parametrize("kind", KINDS)
def test_next_to_the_end_that_the_seed_is_at(kind: str) -> None:
    there, numbers = called(kind, "limits", "at_an_end"), arm_numbers(ARM)
    for value in (3.105 - TURN, 3.105):
        assert there(numbers, 1, value, 3.1) == pytest.approx(3.105)
    assert there(numbers, 1, 3.178, -3.1) == pytest.approx(3.178 - TURN)
    assert there(numbers, 0, 1.0 + TURN, 0.0) == pytest.approx(1.0)
    assert there(numbers, 3, 7.0, 0.0) == 7.0


def test_a_step_without_a_name_is_refused() -> None:
    with pytest.raises(ValueError, match="levitates"):
        arm_numbers(arm_of("R", LIMITS[:1], steps=("levitates",)))


def test_every_step_has_a_place_of_its_own() -> None:
    numbers = [arm_numbers(arm_of("R", LIMITS[:1], steps=(step,))) for step in STEPS]
    places = [int(np.flatnonzero(each[RETRIES:DESCENTS])[0]) for each in numbers]
    assert places == sorted(set(places))
    assert all(b == a + 1 for a, b in pairwise(places))
