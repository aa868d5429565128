"""Limits of joints in a program: angles moved by whole turns into them, and what is outside.

An angle comes in (-pi, pi], unless it is given. Limits that are wider than this cost nothing.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import reduce
from typing import TYPE_CHECKING

from dhgen.program.role import LimitEnd, Source

if TYPE_CHECKING:
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node


@dataclass(frozen=True, slots=True)
class Limits:
    """The limits of a joint, with what rounding may add.

    Attributes:
        low: The lowest value.
        high: The highest value.
        turns: Whether the joint turns, so that whole turns may be added.
    """

    low: float
    high: float
    turns: bool


class Limiting:
    """Brings the values of joints inside their limits.

    Args:
        builder: Where values go.
    """

    def __init__(self, builder: Builder) -> None:
        self._builder = builder
        self._outside: list[Node] = []

    def limited(self, joint: int, value: Node, limits: Limits | None) -> Node:
        """A joint's value inside its limits, or as it was."""
        if limits is None or (limits.turns and limits.low <= -math.pi and limits.high >= math.pi):
            return value
        builder = self._builder
        moved = value
        if limits.turns:
            low, high = self._ends(joint, limits)
            turn = whole_turn(builder)
            zero = builder.integer(0)
            for _ in range(_turns(limits.low + math.pi) if limits.high > math.pi else 0):
                short = builder.select(builder.apply("less", moved, low), turn, zero)
                moved = builder.add(moved, short)
            for _ in range(_turns(math.pi - limits.high) if limits.low < -math.pi else 0):
                long = builder.select(builder.apply("less", high, moved), turn, zero)
                moved = builder.sub(moved, long)
        outside = self.beyond(joint, moved, limits)
        self._outside.append(outside)
        return builder.select(outside, value, moved)

    def beyond(self, joint: int, value: Node, limits: Limits) -> Node:
        """Whether a value is outside, where no whole turns are added."""
        low, high = self._ends(joint, limits)
        builder = self._builder
        if limits.low == -limits.high:
            return builder.apply("less", high, builder.absolute(value))
        below = builder.apply("less", value, low)
        return builder.apply("or", below, builder.apply("less", high, value))

    def _ends(self, joint: int, limits: Limits) -> tuple[Node, Node]:
        low = self._builder.constant(f"low{joint}", limits.low, "", role=LimitEnd(joint, "low"))
        high = self._builder.constant(f"high{joint}", limits.high, "", role=LimitEnd(joint, "high"))
        return low, high

    def outside(self) -> Node | None:
        """Whether any joint is outside; None without limits. False where values are NaN."""
        if not self._outside:
            return None
        return reduce(lambda a, b: self._builder.apply("or", a, b), self._outside)


def whole_turn(builder: Builder) -> Node:
    """2 pi, by a name."""
    return builder.constant("turn", 2 * math.pi, "2 pi [rad]", role=Source.FILE)


def half_turn(builder: Builder) -> Node:
    """Pi, by a name."""
    return builder.constant("half_turn", math.pi, "pi [rad]", role=Source.FILE)


def _turns(distance: float) -> int:
    """How many whole turns cover a distance."""
    return max(math.ceil(distance / (2 * math.pi)), 0)
