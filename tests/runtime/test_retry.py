"""Other values of free joints: a robot whose first joint is taken from the seed."""

from __future__ import annotations

import math

import numpy as np
import pytest

from dhgen.runtime.python.arm import arm_numbers
from dhgen.runtime.python.status import FREE_JOINT, OUT_OF_LIMITS, UNREACHABLE
from tests.runtime.arms import ENDLESS, LENGTHS, arm_of, called, planar
from tests.runtime.plain import KINDS

pytestmark = pytest.mark.parametrize("kind", KINDS)
NONE = np.zeros(2)


def at_height(y: float) -> tuple[float, ...]:
    return (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, y, 0.0, 0.0, 1.0, 0.0)


def height(q: np.ndarray) -> float:
    return float(LENGTHS @ np.sin(np.cumsum(q)))


def solved(kind: str, steps: tuple[str, ...], limits: object, y: float, seed: list[float]):  # type: ignore[no-untyped-def]
    arm = arm_of("RR", limits, steps=steps, choosable=(0,), cuts=52)  # type: ignore[arg-type]
    rows, status = np.empty((2, 2)), np.empty(2, np.uint8)
    count = called(kind, "careful", "careful_ik")(
        arm_numbers(arm), planar(kind), at_height(y), NONE, np.array(seed), rows, status
    )
    return rows, status, count


def test_the_nearest_value_that_reaches_is_taken(kind: str) -> None:
    """The tool at height 0.8 needs 0.5 sin q1 >= 0.4: by hand."""
    rows, status, count = solved(kind, ("retries",), (ENDLESS,) * 2, 0.8, [0.1, 0.0])
    assert count == 2
    assert set(status) == {FREE_JOINT}
    np.testing.assert_allclose(rows[:, 0], math.asin(0.8), atol=1e-9)
    for row in rows:
        assert height(row) == pytest.approx(0.8, abs=1e-9)


def test_without_the_step_such_rows_are_lost(kind: str) -> None:
    """The driver leaves rows as the solver noted them; robots have the step where they do."""
    rows, status, count = solved(kind, ("retries",), (ENDLESS,) * 2, 1.2, [0.1, 0.0])
    assert (count, set(status)) == (0, {UNREACHABLE})
    assert np.isnan(rows).all()


@pytest.mark.parametrize(("seed", "low"), [(-2.0, -1.0), (0.2, 0.2)])
def test_limits_are_kept_by_the_nearest_value(kind: str, seed: float, low: float) -> None:
    limits = ((-1.0, 1.0), ENDLESS)
    rows, status, count = solved(kind, ("keeps limits",), limits, -0.1, [seed, 0.0])
    assert count == 2
    assert set(status) == {FREE_JOINT}
    np.testing.assert_allclose(rows[:, 0], low, atol=2e-9)


def test_what_no_value_brings_inside_is_said_to_be_beyond(kind: str) -> None:
    """With joint 1 between its limits the tool is above height 0.05."""
    limits = ((2.0, 2.1), ENDLESS)
    _, status, count = solved(kind, ("keeps limits",), limits, -0.3, [-0.2, 0.0])
    assert (count, set(status)) == (0, {OUT_OF_LIMITS})
