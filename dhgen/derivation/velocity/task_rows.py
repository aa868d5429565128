"""The rows of the Jacobian that a task names, seen from the frames that leave most zeros.

The determinant is the same in every frame, and for the velocity of every point that moves with the
tool, if the whole angular velocity counts as well. Of a direction the task names two numbers, of
a yaw or a pitch one: a turn that changes nothing that the task names, with a column of its own,
makes the rows those of the whole angular velocity.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.derivation.velocity.columns import WORLD, crossed, view_from
from dhgen.derivation.velocity.posture import level_axis
from dhgen.derivation.velocity.triangle import triangle_of
from dhgen.kinematics.transform import dot, turn_between
from dhgen.robot.task import Directions, TaskKind

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.derivation.story import Story
    from dhgen.derivation.velocity.columns import Vector, View
    from dhgen.derivation.velocity.triangle import Triangle

Rows = tuple["Vector", ...]
LONGEST = 200  # terms of an arm as a frame sees it; beyond, its rows would fill pages
LEVEL = (0, 1), (0, 1, 2), (2,)  # coordinates that turning about z mixes with no others


@dataclass(frozen=True, slots=True)
class Seen:
    """A square matrix with the determinant of the Jacobian.

    Attributes:
        frame: In which it is written; -1 is that of the poses.
        centre: The frame with the origin of which the tool's velocity is taken; the last is the
            tool's.
        rows: Without those of zeros.
        triangle: The blocks that they are made of.
        has_velocities: Whether the first three rows are a point's velocity.
        is_of_poses: Whether with the tool's velocity, and in the frame of poses, rows are as many.
    """

    frame: int
    centre: int
    rows: Rows
    triangle: Triangle
    has_velocities: bool
    is_of_poses: bool = False

    @property
    def length(self) -> tuple[int, int, int, int]:
        """Small blocks, then few terms."""
        terms = sum(len(entry) for row in self.rows for entry in row)
        return self.triangle.effort, terms, self.frame, self.centre

    def are_velocities(self, rows: Sequence[int]) -> bool:
        """Whether some rows are a point's velocity."""
        return self.has_velocities and tuple(rows) == (0, 1, 2)


def ways_to_see(story: Story, *, by_position: bool = False) -> list[Seen]:
    """The shortest matrices first; none where the rows are not known, or not as many as columns.

    Args:
        story: The derivation.
        by_position: Whether the rows are those of the position alone.
    """
    chain = story.algebra.chain
    if any(each.apart for each in chain.passive):
        return []
    named = Directions.NONE if by_position else chain.task.directions
    coordinates = chain.task.position_rows
    solved = [joint.number - 1 for joint in chain.solved]
    is_level = len(coordinates) + named.dimension > len(solved)  # some rows are zero
    turns_freely = len(coordinates) in {0, 3} and not is_level
    found = []
    for frame in (*range(chain.dof + 1), WORLD):
        view = view_from(story, frame)
        level = frame == WORLD or (coordinates in LEVEL and turn_between(view.world.rotation) == 1)
        if view.length > LONGEST:
            continue
        own = _left_open(story, view, named) if turns_freely or level else None
        if own is None:
            continue
        last = len(view.frames) - 1
        first = 0 if len(coordinates) == 3 and named is not Directions.NONE else last
        for centre in range(first, last + 1):
            every = view.columns(centre)
            columns = [every[place] for place in solved] + _about_the_tool(view, own, centre)
            spins = range(3) if named is not Directions.NONE else range(0)
            every_column = [
                (*(moved[row] for row in coordinates), *(spin[row] for row in spins))
                for moved, spin in columns
            ]
            every_row = tuple(zip(*every_column, strict=True))
            rows = tuple(filter(any, every_row))
            if rows and len(rows) == len(rows[0]) and (triangle := triangle_of(rows)) is not None:
                velocities = len(coordinates) == 3 and all(map(any, every_row[:3]))
                found.append(Seen(frame, centre, rows, triangle, velocities))
    whole = len(coordinates) + named.dimension == len(solved)
    if whole or any((each.frame, each.centre) == (WORLD, chain.dof + 1) for each in found):
        found = [replace(each, is_of_poses=True) for each in found]
    elif chain.task.kind is not TaskKind.POSE or by_position:
        return []
    else:
        found = [each for each in found if each.frame != WORLD]
    # origins that are one point give one matrix, of frame 0 rather than of equal poses'
    different = {each.rows: each for each in reversed(found)}
    return sorted(different.values(), key=lambda each: each.length)


def _left_open(story: Story, view: View, named: Directions) -> list[Vector] | None:
    """Axes about which the tool may turn; None where no axes always are such.

    With what the task names before them they are at right angles and right-handed.
    """
    normal = story.algebra.normal
    x, z = view.frames[-1].column(0), view.frames[-1].column(2)
    up = view.world.column(2)
    match named:
        case Directions.POINTING:
            return [z]
        case Directions.TILT:
            return [up]
        case Directions.YAW if not dot(x, up, normal):
            return [x, crossed(story.algebra, up, x)]
        case Directions.PITCH if (frame := level_axis(story)) is not None:
            return [x, crossed(story.algebra, view.frames[frame].column(2), x)]
        case Directions.NONE | Directions.ROTATION:
            return []
    return None


def _about_the_tool(view: View, axes: list[Vector], centre: int) -> list[tuple[Vector, Vector]]:
    """Columns of turns about the tool's origin."""
    tool, tip = view.frames[-1].translation, view.frames[centre].translation
    return [(view.turned(axis, tool, tip), axis) for axis in axes]
