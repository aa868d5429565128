"""Whole turns, and the solution nearest to a seed."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from dhgen.runtime.python import tolerances
from dhgen.runtime.python.arm import arm_numbers
from dhgen.runtime.python.status import OK, OUT_OF_LIMITS, UNREACHABLE
from dhgen.runtime.python.turns import TURN
from dhgen.tolerances import DOUBLE
from tests.runtime.arms import ENDLESS, arm_of
from tests.runtime.plain import KINDS, part

LIMITS = ((-4.0, 4.0), ENDLESS, (-0.2, 0.3))
ARM = arm_numbers(arm_of("RRP", LIMITS))
WEIGHTS = np.array([1.0, 1.0, 4.0])


def called(kind: str, name: str) -> Any:
    """A function of `turns` that only compiled code may call, from Python."""
    function = getattr(part(kind, "turns"), name)
    return function.py_func if kind == "compiled" else function


def test_one_table_of_tolerances() -> None:
    """What the compiler decides by, under its names."""
    same = {
        "limit": "LIMIT",
        "exact": "EXACT",
        "promised": "PROMISED",
        "free": "FREE",
        "merge": "MERGE",
        "doubtful": "DOUBTFUL",
        "distinct": "APART_BY",
        "far": "FAR_ANGLE",
        "fine": "FINE",
        "double": "DOUBLE_ROOT",
        "simple": "SIMPLE_ROOT",
    }
    for ours, theirs in same.items():
        assert getattr(DOUBLE.tolerances, ours) == getattr(tolerances, theirs)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(
    ("joint", "given", "towards", "expected"),
    [
        (0, 3.0, 3.5, 3.0),
        (0, 3.0, -3.5, 3.0 - TURN),
        (0, 5.0, 5.0, 5.0 - TURN),
        (0, 1.0, 9.0, 1.0),  # its copy near 9 is beyond the limit, and so is turned back
        (1, 1.0, 40.0, 1.0 + 6 * TURN),
        (1, 1.0, 1e6, 1.0),
        (2, 7.0, 0.0, 7.0),
    ],
)
def test_whole_turns_inside_limits(
    kind: str, joint: int, given: float, towards: float, expected: float
) -> None:
    value = called(kind, "turned")(ARM, joint, given, towards)
    assert value == pytest.approx(expected, abs=1e-12)


def test_what_no_turns_take_inside_its_limits_stays() -> None:
    narrow = arm_numbers(arm_of("R", ((-0.5, 0.5),)))
    assert called("plain", "turned")(narrow, 0, 2.0, 0.0) == 2.0


def near_by_trying(joint: int, value: float, seed: float, *, limits: bool) -> float:
    """The copy of a joint value that is nearest to the seed's: all of them tried."""
    lowest, highest = LIMITS[joint]
    copies = value + (joint < 2) * TURN * np.arange(-3, 4)
    inside = copies[(lowest <= copies) & (copies <= highest)] if limits else copies
    return float(inside[np.argmin(np.abs(inside - seed))])


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("limits", [True, False])
def test_the_nearest_is_found_as_by_trying_all(kind: str, *, limits: bool) -> None:
    """Against every copy of every row, by numpy."""
    nearest = part(kind, "nearest").nearest
    draw = np.random.default_rng(4)
    for _ in range(50):
        rows = draw.uniform([-3.0, -3.0, -0.2], [3.0, 3.0, 0.3], (4, 3))
        status = draw.choice([OK, OUT_OF_LIMITS, UNREACHABLE], 4, p=[0.6, 0.2, 0.2]).astype(
            np.uint8
        )
        seed = draw.uniform([-4.0, -9.0, -0.2], [4.0, 9.0, 0.3])
        counted = (status == OK) | ((status == OUT_OF_LIMITS) & (not limits))
        best, answer = math.inf, np.zeros(3)
        for row in rows[counted]:
            one = np.array([near_by_trying(i, row[i], seed[i], limits=limits) for i in range(3)])
            distance = float(WEIGHTS @ (one - seed) ** 2)
            if distance < best:
                best, answer = distance, one
        q = np.full(3, 9.0)
        assert nearest(ARM, rows.copy(), status, seed, limits, q) == counted.any()
        if counted.any():
            np.testing.assert_allclose(q, answer, atol=1e-12)
