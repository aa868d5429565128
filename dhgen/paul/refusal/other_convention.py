"""Whether a refused table is one of the other Denavit-Hartenberg convention."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.kinematics.build import build_chain
from dhgen.paul.mobility import surplus
from dhgen.robot.robot import Convention, DhTable

if TYPE_CHECKING:
    from dhgen.robot.robot import Robot

OTHER = {
    Convention.STANDARD: (Convention.MODIFIED, "Rx(alpha) Tx(a) Rz(theta) Tz(d)"),
    Convention.MODIFIED: (Convention.STANDARD, "Rz(theta) Tz(d) Tx(a) Rx(alpha)"),
}


def other_convention(robot: Robot) -> list[str]:
    """A line on the other convention, if every joint matters in that one and not in this.

    Most standard tables end with a twist and a length of zero, which in a modified one put the last
    two axes on one line; most modified ones begin so, which puts the first two there.
    """
    table = robot.geometry
    if not isinstance(table, DhTable) or not surplus(build_chain(robot)).count:
        return []
    other, rows = OTHER[table.convention]
    if surplus(build_chain(replace(robot, geometry=replace(table, convention=other)))).count:
        return []
    meant = f"are its rows {rows}?"
    return [
        f"with `convention: {other.value}` this table is an arm whose joints all count: {meant}"
    ]
