"""A parallel robot as its file describes it: legs, each a serial robot, and what they carry."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.errors import Diagnostic
    from dhgen.robot.robot import Robot
    from dhgen.robot.task import Task

Rows = tuple[float, ...]
"""A frame as numbers: three rows of four."""

ORIGIN = (3, 7, 11)  # where among these numbers a frame has its origin


@dataclass(frozen=True, slots=True)
class Leg:
    """A leg: a serial chain between two places.

    Attributes:
        chain: The chain in the frame of its base; its task is what it carries, seen from there.
        base: Where its base is on the robot's.
        end: The frame, or the point, of the platform that it carries, in the platform's frame.
        driven: Its joints that are driven, from 0: `actuated` in the file, from 1 there.
        carries_frame: Whether its last link is fixed to the platform; else a joint at a point is.
    """

    chain: Robot
    base: Rows
    end: Rows
    driven: tuple[int, ...]
    carries_frame: bool


@dataclass(frozen=True, slots=True)
class ParallelRobot:
    """A validated robot file with legs.

    Attributes:
        name: Identifier that names the files and the C functions.
        title: What a person calls the robot.
        source: Where its numbers come from.
        legs: All of them; those that are alike share a chain, and its name.
        task: What of the platform's pose the legs move.
        length_unit: How lengths are called.
        notices: What was snapped to an exact value, looks like a slip, or is of no use.
        doubts: What may be why the solvers do not pass, if they do not.
    """

    name: str
    title: str
    source: str
    legs: tuple[Leg, ...]
    task: Task
    length_unit: str = "m"
    notices: tuple[Diagnostic, ...] = ()
    doubts: tuple[Diagnostic, ...] = ()

    @property
    def chains(self) -> tuple[Robot, ...]:
        """The legs' chains, each once, in the order of the legs."""
        return tuple({leg.chain.name: leg.chain for leg in self.legs}.values())

    @property
    def drives(self) -> int:
        """How many joints are driven."""
        return sum(len(leg.driven) for leg in self.legs)

    def with_numerical(self) -> ParallelRobot:
        """The robot with chains that the numerical solver may take."""
        legs = (replace(leg, chain=replace(leg.chain, numerical=True)) for leg in self.legs)
        return replace(self, legs=tuple(legs))


def inverse(frame: Rows) -> Rows:
    """The inverse of a frame; no entry is a negative zero."""
    entries: list[float] = []
    for i in range(3):
        column = [frame[4 * k + i] for k in range(3)]
        entries += [*column, -sum(column[k] * frame[4 * k + 3] for k in range(3))]
    return tuple(entry + 0.0 for entry in entries)
