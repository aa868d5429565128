"""Whether a refused table is one of the other Denavit-Hartenberg convention."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.kinematics.build import build_chain
from dhgen.paul.mobility import axes_on_one_line, crowded_axes, surplus
from dhgen.robot.robot import Convention, DhTable

if TYPE_CHECKING:
    from dhgen.robot.robot import Robot

OTHER = {
    Convention.STANDARD: (Convention.MODIFIED, "Rx(alpha) Tx(a) Rz(theta) Tz(d)"),
    Convention.MODIFIED: (Convention.STANDARD, "Rz(theta) Tz(d) Tx(a) Rx(alpha)"),
}


def other_convention(robot: Robot) -> list[str]:
    """A line on the other convention, if that makes a proper arm of the table and this does not.

    Most standard tables end with a twist and a length of zero, which in a modified one put the last
    two axes on one line; most modified ones begin so, which puts the first two there. With a joint
    more than the task fixes such an arm still reaches every pose.
    """
    table = robot.geometry
    if not isinstance(table, DhTable):
        return []
    other, rows = OTHER[table.convention]
    here = build_chain(robot)
    there = build_chain(replace(robot, geometry=replace(table, convention=other)))
    spare, left = surplus(here).count, surplus(there).count
    if spare and not left:
        better = "this table is an arm whose joints all count"
    elif spare and left <= spare and axes_on_one_line(here) and not crowded_axes(there):
        better = "no two neighbouring axes of this table are the same line"
    else:
        return []
    return [f"with `convention: {other.value}` {better}: are its rows {rows}?"]
