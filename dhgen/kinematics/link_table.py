"""A robot's table, or its axes, in numbers: what the frames of its links are computed from."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.robot.expression import evaluate
from dhgen.robot.robot import DhTable, JointKind

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dhgen.robot.expression import Expression
    from dhgen.robot.robot import AxisJoint, DhRow, Frame, Robot

AXES = "axes"

Placement = tuple[float, ...]  # the upper three rows of a 4x4 matrix


@dataclass(frozen=True, slots=True)
class LinkTable:
    """The table of a robot.

    Attributes:
        convention: `standard` or `modified` for Denavit-Hartenberg rows, or `axes`.
        types: R or P for every row.
        rows: Of each joint at q = 0 theta, d, a, alpha; of an axis the unit vector along it, and a
            point of it.
        drives: What joint values are multiplied by for the angles and lengths of the rows; empty
            where these are the same. Passive rows are rows without a joint.
        base: Z, the arm's base in the caller's frame.
        tool: E, the tool in the last frame; with axes its pose at q = 0.
    """

    convention: str
    types: str
    rows: tuple[tuple[float, ...], ...]
    drives: tuple[tuple[float, ...], ...]
    base: Placement
    tool: Placement


def link_table(robot: Robot) -> LinkTable:
    """The table of a robot as it was written."""
    values = {parameter.name: parameter.value for parameter in robot.parameters}
    base, tool = (_placement(frame, values) for frame in (robot.base, robot.tool))
    if isinstance(robot.geometry, DhTable):
        rows = tuple(
            tuple(evaluate(cell, values) for cell in (row.theta, row.d, row.a, row.alpha))
            for row in robot.geometry.rows
        )
        factors, types = robot.geometry.drive_factors, _types(robot.geometry.rows)
        same = tuple(tuple(float(i == j) for j in range(len(rows))) for i in range(len(rows)))
        drives = () if factors == same else factors
        return LinkTable(robot.geometry.convention.value, types, rows, drives, base, tool)
    axes = tuple(_axis(axis, values) for axis in robot.geometry.axes)
    home = _placement(robot.geometry.home, values)
    return LinkTable(AXES, _types(robot.geometry.axes), axes, (), base, _product(home, tool))


def _types(joints: Sequence[DhRow | AxisJoint]) -> str:
    return "".join("R" if joint.kind is JointKind.REVOLUTE else "P" for joint in joints)


def _axis(axis: AxisJoint, values: Mapping[str, float]) -> tuple[float, ...]:
    direction = [evaluate(each, values) for each in axis.direction]
    length = math.hypot(*direction)
    return (*(each / length for each in direction), *(evaluate(p, values) for p in axis.point))


def _placement(frame: Frame, values: Mapping[str, float]) -> Placement:
    def number(cell: Expression) -> float:
        return evaluate(cell, values) + 0.0  # no -0.0

    rotation, xyz = list(map(number, frame.rotation)), list(map(number, frame.xyz))
    return tuple(
        entry for row in range(3) for entry in (*rotation[3 * row : 3 * row + 3], xyz[row])
    )


def _product(left: Placement, right: Placement) -> Placement:
    rows = [*(right[4 * row : 4 * row + 4] for row in range(3)), (0.0, 0.0, 0.0, 1.0)]
    return tuple(
        math.fsum(left[4 * i + k] * rows[k][j] for k in range(4)) + 0.0
        for i in range(3)
        for j in range(4)
    )
