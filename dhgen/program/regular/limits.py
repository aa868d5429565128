"""Limits of joints in a program: angles moved by whole turns into them, and what is outside.

An angle comes in (-pi, pi], unless it is given. Limits that are wider than this cost nothing.
Where one is outside by so little that rounding may have put it there, it may be clamped to its
limit: such a pose is doubtful.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import reduce
from typing import TYPE_CHECKING, Literal

from dhgen.program.building.tolerance_constants import tolerance_constant
from dhgen.program.role import LIMIT_SLACK, LimitEnd, Source

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node


@dataclass(frozen=True, slots=True)
class Limits:
    """The limits of a joint, with what rounding may add.

    Attributes:
        low: The lowest value.
        high: The highest value.
        turns: Whether the joint turns, so that whole turns may be added.
        size: What counts as one [1 rad or the arm's size].
        is_asked: Whether the joint's value is asked for: of an angle that is not, the sine and the
            cosine are enough to compare.
    """

    low: float
    high: float
    turns: bool
    size: float = 1.0
    is_asked: bool = True


@dataclass(frozen=True, slots=True)
class ArmLimits:
    """The limits of all joints.

    Attributes:
        joints: Of every joint, None for one without; empty if they don't matter.
        limit_slack: Half of what rounding may take a joint beyond its limits where it is clamped
            for that elsewhere [rad, arm sizes]; None if it isn't.
    """

    joints: tuple[Limits | None, ...] = ()
    limit_slack: float | None = None


NO_LIMITS = ArmLimits()
_SHARES = (("middle_cosine", math.cos), ("middle_sine", math.sin))
_HALF_SHARES = (("range_cosine", math.cos), ("range_sine", math.sin))


class Limiting:
    """Brings the values of joints inside their limits.

    Args:
        builder: Where values go.
        limits: Of all joints.
    """

    def __init__(self, builder: Builder, limits: ArmLimits) -> None:
        self._builder = builder
        self._limits = limits
        self._beyond: list[Node] = []  # how far each joint is
        self._outside: list[Node] = []  # whether each joint is that has no value

    def _of(self, joint: int) -> Limits | None:
        return self._limits.joints[joint - 1] if self._limits.joints else None

    def limited(self, joint: int, value: Node) -> Node:
        """A joint's value inside its limits, or as it was."""
        limits = self._of(joint)
        if limits is None or (limits.turns and limits.low <= -math.pi and limits.high >= math.pi):
            return value
        builder = self._builder
        moved = value
        if limits.turns:
            low, high = self._ends(joint, limits)
            turn = whole_turn(builder)
            zero = builder.integer(0)
            for _ in range(_turns_up(limits)):
                short = builder.select(builder.apply("less", moved, low), turn, zero)
                moved = builder.add(moved, short)
            for _ in range(_turns_down(limits)):
                long = builder.select(builder.apply("less", high, moved), turn, zero)
                moved = builder.sub(moved, long)
        beyond = self._how_far(joint, moved, limits)
        if _most_turns(limits) == 1:
            beyond = self._nearer(beyond, self._before_the_turn(joint, value, limits))
        self._beyond.append(beyond)
        return builder.select(self._positive(beyond), value, moved)

    def _before_the_turn(self, joint: int, value: Node, limits: Limits) -> Node:
        """How far a value is beyond the end that it may be moved from, negative if it is not.

        If it is by so little that rounding may have put it there, it may be clamped to that end.
        """
        low, high = self._ends(joint, limits)
        below, above = self._builder.sub(low, value), self._builder.sub(value, high)
        return below if limits.high > math.pi else above

    def _nearer(self, beyond: Node, other: Node) -> Node:
        return self._builder.select(self._builder.apply("less", other, beyond), other, beyond)

    def is_outside(self, joint: int, value: Node) -> Node | None:
        """Whether a value is outside, where no whole turns are added; None without limits."""
        limits = self._of(joint)
        return None if limits is None else self._positive(self._how_far(joint, value, limits))

    def is_compared_by_direction(self, joint: int) -> bool:
        """Whether a joint's limits take no angle."""
        limits = self._of(joint)
        return limits is not None and limits.turns and not limits.is_asked

    def take_direction(self, joint: int, y: Node, x: Node) -> Node | None:
        """Compares the limits of a joint with the direction (x, y) of its angle, of any length.

        Turned by the middle of the range, the angle's size is beyond half the range where the sine
        of their difference is positive: both are in [0, pi].

        Returns:
            Whether the angle is at an end of the range but for rounding; None if it is no matter.
        """
        limits, builder = self._of(joint), self._builder
        if limits is None or limits.high - limits.low >= 2 * math.pi:
            return None
        middle, half = (limits.low + limits.high) / 2, (limits.high - limits.low) / 2
        if middle:
            c, s = (self._share(joint, part, of, middle) for part, of in _SHARES)
            y, x = (
                builder.sub(builder.mul(y, c), builder.mul(x, s)),
                builder.add(builder.mul(x, c), builder.mul(y, s)),
            )
        c, s = (self._share(joint, part, of, half) for part, of in _HALF_SHARES)
        beyond = builder.sub(builder.mul(c, builder.absolute(y)), builder.mul(s, x))
        self._outside.append(self._positive(beyond))
        if self._limits.limit_slack is None:
            return None
        length = builder.add(builder.absolute(y), builder.absolute(x))
        near = builder.constant(f"near{joint}", 2.0 * self._limits.limit_slack, "")
        return builder.apply("at_most", builder.absolute(beyond), builder.mul(near, length))

    def _share(self, joint: int, name: str, of: Callable[[float], float], angle: float) -> Node:
        return self._builder.constant(f"{name}{joint}", of(angle), "")

    def _how_far(self, joint: int, value: Node, limits: Limits) -> Node:
        """How far a value is beyond its limits [rad, arm sizes]; negative inside."""
        low, high = self._ends(joint, limits)
        builder = self._builder
        if limits.low == -limits.high:
            beyond = builder.sub(builder.absolute(value), high)
        else:
            beyond = builder.apply("maximum", builder.sub(low, value), builder.sub(value, high))
        if limits.size == 1.0:
            return beyond
        meaning = "slides beyond limits count in the arm's size"
        return builder.mul(builder.constant("per_size", 1.0 / limits.size, meaning, -1), beyond)

    def _positive(self, value: Node) -> Node:
        return self._builder.apply("less", self._builder.integer(0), value)

    def _ends(self, joint: int, limits: Limits) -> tuple[Node, Node]:
        return self._end(joint, limits, "low"), self._end(joint, limits, "high")

    def _end(self, joint: int, limits: Limits, end: Literal["low", "high"]) -> Node:
        meaning, power = f"{end}est value of joint {joint}, with what rounding adds", 1
        if limits.turns:
            meaning, power = f"{meaning} [rad]", 0
        value = limits.low if end == "low" else limits.high
        role = LimitEnd(joint, end)
        return self._builder.constant(f"{end}{joint}", value, meaning, power, role)

    def outside(self) -> Node | None:
        """Whether any joint is outside, of a row that has a solution; None without limits."""
        found = [*self._outside, *([self._positive(self._farthest())] if self._beyond else [])]
        return reduce(lambda a, b: self._builder.apply("or", a, b), found) if found else None

    def within_slack(self) -> Node | None:
        """Whether any joint is outside, but none by more than rounding; None if it is no matter."""
        if not self._beyond or self._limits.limit_slack is None:
            return None
        middle = tolerance_constant(self._builder, LIMIT_SLACK, self._limits.limit_slack)
        off = self._builder.absolute(self._builder.sub(self._farthest(), middle))
        return self._builder.apply("at_most", off, middle)

    def _farthest(self) -> Node:
        """How far the joint is outside that is it most."""
        builder = self._builder
        narrow_first = sorted(self._beyond, key=lambda each: len(builder.axes_of(each)))
        farthest = reduce(lambda a, b: builder.apply("maximum", a, b), narrow_first)
        return builder.hint(farthest, "excess")


def whole_turn(builder: Builder) -> Node:
    """2 pi, by a name."""
    return builder.constant("turn", 2 * math.pi, "2 pi [rad]", role=Source.FILE)


def half_turn(builder: Builder) -> Node:
    """Pi, by a name."""
    return builder.constant("half_turn", math.pi, "pi [rad]", role=Source.FILE)


def _most_turns(limits: Limits) -> int:
    return _turns_up(limits) + _turns_down(limits) if limits.turns else 0


def _turns_up(limits: Limits) -> int:
    """How many turns take an angle in (-pi, pi] inside at most, where it is below."""
    return _turns(limits.low + math.pi) if limits.high > math.pi else 0


def _turns_down(limits: Limits) -> int:
    return _turns(math.pi - limits.high) if limits.low < -math.pi else 0


def _turns(distance: float) -> int:
    """How many whole turns cover a distance."""
    return max(math.ceil(distance / (2 * math.pi)), 0)
