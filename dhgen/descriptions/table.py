"""The Denavit-Hartenberg table of an arm that costs its reader least.

What a row costs depends on the passage before and after its joint alone, so the cheapest table is
the cheapest way through all candidates (Viterbi), found exactly.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.descriptions.choices import Choices, turn_cost
from dhgen.descriptions.lines import angle_about
from dhgen.descriptions.rotations import dot, minus
from dhgen.robot.robot import Convention

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.descriptions.choices import Passage
    from dhgen.descriptions.lines import Arm, Axis
    from dhgen.descriptions.model import Vector
    from dhgen.descriptions.rotations import Placed

SHORTER = 0.25  # so much a modified table has to be better to be taken


@dataclass(frozen=True, slots=True)
class Row:
    """A row of a table in numbers.

    Attributes:
        axis: Of its joint.
        sign: Of the joint's variable.
        turn: The angle beside the variable, or a slide's angle [rad].
        offset: The length along the axis, or what is beside a slide's variable.
        length: Along the common normal: after the joint, or before it in a modified table.
        twist: About it [rad].
    """

    axis: Axis
    sign: int
    turn: float
    offset: float
    length: float
    twist: float


@dataclass(frozen=True, slots=True)
class Table:
    """A table in numbers, with the frames before and after it."""

    convention: Convention
    base: Placed
    rows: tuple[Row, ...]
    tool: Placed


def cheapest_table(arm: Arm) -> Table:
    """The table of an arm, standard, or modified where that is shorter."""
    choices = Choices(arm)
    standard, cost = _cheapest(choices, modified=False)
    modified, other = _cheapest(choices, modified=True)
    if other < cost - SHORTER:
        return _table(arm, modified, Convention.MODIFIED)
    return _table(arm, standard, Convention.STANDARD)


def _cheapest(choices: Choices, *, modified: bool) -> tuple[list[Passage], float]:
    """The passages of the cheapest table, the first and the last included, and its cost."""
    arm = choices.arm
    ways = [(start.cost, [start]) for start in choices.starts(modified=modified)]
    for number in range(len(arm.axes) - 1):
        ways = _onward(ways, choices.passages(number), arm, number)
    best: tuple[float, list[Passage]] | None = None
    for cost, way in ways:
        for end in choices.ends(way[-1], modified=modified):
            total = cost + end.cost + turn_cost(way[-1], end, arm, len(arm.axes) - 1)
            if best is None or total < best[0] - 1e-9:
                best = total, [*way, end]
    assert best is not None
    return best[1], best[0]


def _onward(
    ways: list[tuple[float, list[Passage]]], passages: Iterable[Passage], arm: Arm, number: int
) -> list[tuple[float, list[Passage]]]:
    """The cheapest way to every passage, of passages that differ for what follows."""
    by_line: dict[object, list[tuple[float, list[Passage]]]] = {}
    for cost, way in ways:
        by_line.setdefault(way[-1].after, []).append((cost, way))
    onward: dict[object, tuple[float, list[Passage]]] = {}
    for passage in passages:
        best: tuple[float, list[Passage]] | None = None
        for cost, way in by_line[passage.before]:
            total = cost + passage.cost + turn_cost(way[-1], passage, arm, number)
            if best is None or total < best[0] - 1e-9:
                best = total, way
        assert best is not None
        end = passage.after, _rounded(passage.x), _rounded(passage.landing)
        if end not in onward or best[0] < onward[end][0] - 1e-9:
            onward[end] = best[0], [*best[1], passage]
    return list(onward.values())


def _rounded(vector: Vector) -> Vector:
    x, y, z = (round(part, 9) + 0.0 for part in vector)
    return x, y, z


def _table(arm: Arm, way: list[Passage], convention: Convention) -> Table:
    rows = []
    for number, axis in enumerate(arm.axes):
        before, after = way[number], way[number + 1]
        line = before.after
        assert line is not None
        link = before if convention is Convention.MODIFIED else after
        rows.append(
            Row(
                axis=axis,
                sign=line.sign,
                turn=angle_about(line.z, before.x, after.x),
                offset=dot(minus(after.foot, before.landing), line.z),
                length=link.length,
                twist=link.twist,
            )
        )
    return Table(convention, way[0].frame, tuple(rows), way[-1].frame)


def farthest_offset(table: Table) -> float:
    """The largest offset along an axis: common normals of nearly parallel axes are far away."""
    return max((abs(row.offset) for row in table.rows), default=math.nan)
