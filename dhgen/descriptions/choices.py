"""What is free in a Denavit-Hartenberg table, as lists of candidates.

Signs of z and x; where along parallel axes a common normal is, and its direction where they are one
line; where a slide's line is, of which only the direction matters; the first and the last frame.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise, product
from typing import TYPE_CHECKING

from dhgen.descriptions.cost import (
    BACKWARDS,
    frame_cost,
    link_cost,
    row_cost,
)
from dhgen.descriptions.lines import across, angle_about, are_parallel, common_normal, foot_on
from dhgen.descriptions.rotations import (
    STILL,
    cross,
    dot,
    inverse,
    minus,
    placed,
    plus,
    times,
    transposed,
    unit,
)

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from dhgen.descriptions.lines import Arm
    from dhgen.descriptions.model import Vector
    from dhgen.descriptions.rotations import Placed, Rotation

ORIGIN: Vector = (0.0, 0.0, 0.0)
HERE: Placed = (STILL, ORIGIN)


@dataclass(frozen=True, slots=True)
class Line:
    """A joint's axis as the table takes it.

    Attributes:
        point: One of it.
        z: Its direction, or the other way round.
        sign: Which of both.
    """

    point: Vector
    z: Vector
    sign: int


@dataclass(frozen=True, slots=True)
class Passage:
    """From one axis to the next along a common normal; also before the first or after the last.

    Attributes:
        before: The axis that it starts on; None of the first.
        after: The axis that it ends on; None of the last.
        x: Its direction.
        foot: Where it starts.
        landing: Where it ends.
        length: From foot to landing along x.
        twist: From z to z about x.
        frame: Base or tool, of the first or the last.
        cost: Of all that.
    """

    before: Line | None
    after: Line | None
    x: Vector
    foot: Vector
    landing: Vector
    length: float = 0.0
    twist: float = 0.0
    frame: Placed = HERE
    cost: float = 0.0


class Choices:
    """All candidates for the table of an arm."""

    def __init__(self, arm: Arm) -> None:
        self.arm = arm
        self.lines = [self._lines(number) for number in range(len(arm.axes))]
        self.points: list[Vector] = [ORIGIN, arm.tip[1]]
        self.directions: list[Vector] = [*STILL, *transposed(arm.tip[0])]
        for befores, afters in pairwise(self.lines):
            for before, after in product(befores, afters):
                if before.sign > 0 and after.sign > 0:
                    self._note_normal(before, after)
        self.points = _distinct(self.points, arm.negligible)
        self.directions = _distinct(self.directions, max(arm.near, 1e-9))

    def _lines(self, number: int) -> list[Line]:
        axis = self.arm.axes[number]
        if axis.turns:
            back = times(axis.direction, -1.0)
            return [Line(axis.point, axis.direction, 1), Line(axis.point, back, -1)]
        points = (foot_on(p, axis.direction, ORIGIN) for p in self._slide_points(number))
        return [
            Line(point, axis.direction, 1) for point in _distinct([*points], self.arm.negligible)
        ]

    def _slide_points(self, number: int) -> list[Vector]:
        """Where a slide's line may lie: through what turns beside it, if anything does."""
        axes = self.arm.axes
        before = next((axis for axis in reversed(axes[:number]) if axis.turns), None)
        after = next((axis for axis in axes[number + 1 :] if axis.turns), None)
        found = []
        if before and after and not are_parallel(before.direction, after.direction, self.arm.near):
            _, foot, landing = common_normal(
                (before.point, before.direction), (after.point, after.direction)
            )
            found += [landing, foot]
        found += [each.point for each in (after, before) if each]
        return [*found, ORIGIN, self.arm.tip[1], axes[number].point]

    def _note_normal(self, before: Line, after: Line) -> None:
        if are_parallel(before.z, after.z, self.arm.near):
            apart = across(before.z, minus(after.point, before.point))
            if math.hypot(*apart) > self.arm.negligible:
                self.directions.append(unit(apart))
            return
        x, foot, landing = common_normal((before.point, before.z), (after.point, after.z))
        self.directions.append(x)
        self.points += [foot, landing]

    def starts(self, *, modified: bool) -> Iterator[Passage]:
        """Frames before the first joint.

        Args:
            modified: Whether a length and a twist may come before it.
        """
        for line in self.lines[0]:
            for landing in self._heights(line):
                for x in self._square(line.z):
                    frame = (_rotation(x, line.z), landing)
                    yield self._start(line, x, landing, frame)
                x = STILL[0]
                if modified and abs(dot(x, line.z)) < self.arm.near:
                    length = dot(landing, x)
                    frame = (STILL, plus(landing, x, -length))
                    twist = angle_about(x, STILL[2], line.z)
                    yield self._start(line, x, landing, frame, length, twist)

    def _start(
        self,
        line: Line,
        x: Vector,
        landing: Vector,
        frame: Placed,
        length: float = 0.0,
        twist: float = 0.0,
    ) -> Passage:
        cost = frame_cost(frame, self.arm) + link_cost(length, twist, self.arm) + _backwards(line)
        return Passage(None, line, x, landing, landing, length, twist, frame, cost)

    def passages(self, number: int) -> Iterator[Passage]:
        """Common normals from a joint, counted from zero, to the next."""
        for before, after in product(self.lines[number], self.lines[number + 1]):
            for x, foot, landing in self._normals(before, after):
                length = dot(minus(landing, foot), x)
                twist = angle_about(x, before.z, after.z)
                cost = link_cost(length, twist, self.arm) + _backwards(after)
                yield Passage(before, after, x, foot, landing, length, twist, HERE, cost)

    def _normals(self, before: Line, after: Line) -> Iterator[tuple[Vector, Vector, Vector]]:
        if not are_parallel(before.z, after.z, self.arm.near):
            x, foot, landing = common_normal((before.point, before.z), (after.point, after.z))
            yield x, foot, landing
            yield times(x, -1.0), foot, landing
            return
        apart = across(before.z, minus(after.point, before.point))
        if math.hypot(*apart) > self.arm.negligible:
            directions = [unit(apart), times(unit(apart), -1.0)]
        else:
            directions = self._square(before.z)
        for foot in self._heights(before):
            for x in directions:
                yield x, foot, foot_on(after.point, after.z, foot)

    def ends(self, last: Passage, *, modified: bool) -> Iterator[Passage]:
        """Frames after the last joint.

        Args:
            last: The choice before it.
            modified: Whether length and twist must be zero.
        """
        line, (R, origin) = last.after, self.arm.tip
        assert line is not None
        level = foot_on(line.point, line.z, origin)
        tip = transposed(R)
        for foot in _distinct([last.landing, level], self.arm.negligible):
            for x in _distinct([last.x, *self._square(line.z, tip)], self.arm.near or 1e-9):
                yield self._end(line, x, foot, foot, (x, line.z))
                if not modified and math.dist(x, tip[0]) < self.arm.near:
                    landing = plus(foot, x, dot(minus(origin, foot), x))
                    yield self._end(line, x, foot, landing, (x, tip[2]))

    def _end(
        self, line: Line, x: Vector, foot: Vector, landing: Vector, axes: tuple[Vector, Vector]
    ) -> Passage:
        tool = placed(inverse((_rotation(*axes), landing)), self.arm.tip)
        length, twist = dot(minus(landing, foot), x), angle_about(x, line.z, axes[1])
        cost = frame_cost(tool, self.arm) + link_cost(length, twist, self.arm)
        return Passage(line, None, x, foot, landing, length, twist, tool, cost)

    def _heights(self, line: Line) -> list[Vector]:
        """Points of a line that are level with something."""
        return _distinct(
            [foot_on(line.point, line.z, point) for point in self.points], self.arm.negligible
        )

    def _square(self, z: Vector, among: Sequence[Vector] = ()) -> list[Vector]:
        """Directions square to a line, both ways each."""
        found = [x for x in among or self.directions if abs(dot(x, z)) < self.arm.near]
        exact = [unit(across(z, x)) for x in found]
        both = [side for x in exact for side in (x, times(x, -1.0))]
        if not both:
            side = min(STILL, key=lambda each: abs(dot(each, z)))
            both = [unit(across(z, side))]
        return _distinct(both, max(self.arm.near, 1e-9))


def turn_cost(before: Passage, after: Passage, arm: Arm, number: int) -> float:
    """What the row of a joint, counted from zero, has along its axis, between two passages."""
    line = before.after
    assert line is not None
    turn = angle_about(line.z, before.x, after.x)
    offset = dot(minus(after.foot, before.landing), line.z)
    return row_cost(turn, offset, arm, number)


def _backwards(line: Line) -> float:
    return BACKWARDS if line.sign < 0 else 0.0


def _rotation(x: Vector, z: Vector) -> Rotation:
    """The frame with these axes."""
    return transposed((x, cross(z, x), z))


def _distinct(vectors: Iterable[Vector], near: float) -> list[Vector]:
    """Each direction once, the first of nearly equal ones."""
    found: list[Vector] = []
    for vector in vectors:
        if all(math.dist(vector, other) > near for other in found):
            found.append(vector)
    return found
