"""Whether a joint is outside its limits, and whether rounding may be why."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.program.building.builder import Builder
from dhgen.program.interpret import interpret
from dhgen.program.ir import Apply
from dhgen.program.regular.limits import ArmLimits, Limiting, Limits
from dhgen.program.walk import expressions

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.building.graph import Node
    from dhgen.program.ir import Program

ENDS = [(-1.0, 1.0), (-1.0, 0.5), (0.5, 2.0), (-2.0, -0.5), (0.0, 0.0)]
ROUNDING = 1e-6


def asked(limits: Sequence[Limits], given: Sequence[float]) -> tuple[bool, bool]:
    """Whether joints with these values are outside their limits, and whether by rounding alone."""
    builder = Builder()
    limiting = Limiting(builder, ArmLimits(tuple(limits), 0.5 * ROUNDING))
    for place in range(len(limits)):
        limiting.limited(place + 1, builder.pose(1, place + 1))
    found = limiting.outside(), limiting.within_slack()
    program = truths(builder, [node for node in found if node is not None])
    pose = np.eye(4)
    pose[0, : len(given)] = given
    outside, within_slack = interpret(program, pose[None]).q[0, 0]
    return bool(outside), bool(within_slack)


def truths(builder: Builder, nodes: Sequence[Node]) -> Program:
    """A program that gives 1 where each of these holds, else 0."""
    zero, one = builder.integer(0), builder.integer(1)
    told = {f"q{k + 1}": builder.select(node, one, zero) for k, node in enumerate(nodes)}
    return builder.finish("t", told, [])


@pytest.mark.parametrize(("low", "high"), ENDS)
def test_a_value_is_outside_beyond_either_end(low: float, high: float) -> None:
    for given in (-3.0, low, np.nextafter(low, -9), 0.0, high, np.nextafter(high, 9), 3.0):
        outside, _ = asked([Limits(low, high, turns=False)], [given])
        assert outside == (given < low or high < given)


@pytest.mark.parametrize(("low", "high"), ENDS[:-1])
def test_rounding_is_to_blame_for_little(low: float, high: float) -> None:
    limits = [Limits(low, high, turns=False)]
    for end, way in ((low, -1.0), (high, 1.0)):
        for off, within_slack in ((-1e-9, False), (1e-9, True), (0.9e-6, True), (1.1e-6, False)):
            assert asked(limits, [end + way * off])[1] == within_slack


def test_one_joint_that_is_far_outside_says_all() -> None:
    limits = [Limits(-1.0, 1.0, turns=False), Limits(-2.0, 1.0, turns=False)]
    assert asked(limits, [1.0 + 1e-8, 0.0]) == (True, True)
    assert asked(limits, [1.0 + 1e-8, 1.0 + 1e-7]) == (True, True)
    assert asked(limits, [1.0 + 1e-8, 1.1]) == (True, False)


def test_slides_are_outside_in_arm_sizes() -> None:
    turn, slide = Limits(-1.0, 1.0, turns=True), Limits(0.0, 500.0, turns=False, size=2000.0)
    assert asked([turn, slide], [0.0, 500.0 + 1e-3]) == (True, True)
    assert asked([turn, slide], [0.0, 500.0 + 3e-3]) == (True, False)
    assert asked([turn, slide], [1.0 + 3e-3, 500.0 + 1e-3]) == (True, False)


def test_rounding_is_no_matter_where_joints_are_not_put_onto_limits() -> None:
    builder = Builder()
    limiting = Limiting(builder, ArmLimits((Limits(-1.0, 1.0, turns=True),)))
    limiting.limited(1, builder.pose(1, 1))
    assert limiting.outside() is not None
    assert limiting.within_slack() is None


def test_limits_that_are_alike_on_both_sides_hold_for_both_signs_at_once() -> None:
    builder = Builder()
    sign = builder.sign(("up", "down"), 1)
    angle = builder.mul(sign, builder.mul(builder.pose(1, 1), builder.pose(1, 2)))
    ends = (Limits(-1.0, 1.0, turns=False), Limits(-1.0, 2.0, turns=False))
    limiting = Limiting(builder, ArmLimits(ends))
    alike, other = limiting.is_outside(1, angle), limiting.is_outside(2, angle)
    assert alike is not None
    assert other is not None
    assert builder.axes_of(alike) == ()
    assert builder.axes_of(other) != ()
    program = builder.finish("t", {"q1": builder.select(alike, angle, builder.neg(angle))}, [])
    compared = [e for e in expressions(program) if isinstance(e, Apply) and e.operator == "less"]
    assert len(compared) == 1


@pytest.mark.parametrize(
    ("low", "high", "end", "way"),
    [
        (-0.0175, 3.7525, -0.0175, -1.0),
        (0.0, 6.1, 0.0, -1.0),
        (-3.7525, 0.0175, 0.0175, 1.0),
    ],
)
def test_rounding_is_to_blame_where_a_turn_would_lead_past_the_other_end(
    low: float, high: float, end: float, way: float
) -> None:
    limits = [Limits(low, high, turns=True)]
    for off, within_slack in ((1e-9, True), (0.9e-6, True), (1.1e-6, False), (0.1, False)):
        assert asked(limits, [end + way * off]) == (True, within_slack)
    assert asked(limits, [end - way * 1e-9]) == (False, False)
