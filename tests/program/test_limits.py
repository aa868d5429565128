"""Whether a joint is outside its limits, by as few comparisons as they need."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.program.building.builder import Builder
from dhgen.program.interpret import interpret
from dhgen.program.ir import Apply
from dhgen.program.regular.limits import Limiting, Limits
from dhgen.program.walk import expressions

ENDS = [(-1.0, 1.0), (-1.0, 0.5), (0.5, 2.0), (-2.0, -0.5), (0.0, 0.0)]


@pytest.mark.parametrize(("low", "high"), ENDS)
def test_a_value_is_outside_beyond_either_end(low: float, high: float) -> None:
    for given in (-3.0, low, np.nextafter(low, -9), 0.0, high, np.nextafter(high, 9), 3.0):
        builder = Builder()
        limits = Limits(low, high, turns=False)
        outside = Limiting(builder).beyond(1, builder.pose(1, 1), limits)
        zero, one = builder.integer(0), builder.integer(1)
        program = builder.finish("t", {"q1": builder.select(outside, one, zero)}, [])
        pose = np.eye(4)
        pose[0, 0] = given
        assert interpret(program, pose[None]).q[0, 0, 0] == (given < low or high < given)


def test_limits_that_are_alike_on_both_sides_hold_for_both_signs_at_once() -> None:
    builder = Builder()
    sign = builder.sign(("up", "down"), 1)
    angle = builder.mul(sign, builder.mul(builder.pose(1, 1), builder.pose(1, 2)))
    alike = Limiting(builder).beyond(1, angle, Limits(-1.0, 1.0, turns=False))
    other = Limiting(builder).beyond(2, angle, Limits(-1.0, 2.0, turns=False))
    assert builder.axes_of(alike) == ()
    assert builder.axes_of(other) != ()
    program = builder.finish("t", {"q1": builder.select(alike, angle, builder.neg(angle))}, [])
    compared = [e for e in expressions(program) if isinstance(e, Apply) and e.operator == "less"]
    assert len(compared) == 1
