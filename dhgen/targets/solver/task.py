"""What of a pose counts, and what is checked of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from dhgen.robot.task import Task


@dataclass(frozen=True, slots=True)
class PoseChecks:
    """What is checked of a pose.

    Attributes:
        checks_rotation: Whether all of the rotation is.
        checks_approach: Whether the tool's z axis alone is.
    """

    checks_rotation: bool
    checks_approach: bool


def pose_checks(task: Task) -> PoseChecks:
    """What a task needs."""
    return PoseChecks(
        checks_rotation=task.names_rotation,
        checks_approach=task.kind is TaskKind.POINTING,
    )


def meaning(task: Task) -> str:
    """What of a pose counts, as a sentence."""
    match task.kind:
        case TaskKind.POSE:
            return "Every entry of a pose counts."
        case TaskKind.POSITION:
            meant = "the position T[0:3, 3]"
        case TaskKind.ORIENTATION:
            meant = "the orientation T[0:3, 0:3]"
        case TaskKind.POINTING:
            meant = "the position T[0:3, 3] and the tool's z axis T[0:3, 2]"
        case TaskKind.COORDINATES:
            places = zip(task.coordinates, task.position_rows, strict=True)
            meant = " and ".join(f"{name} = T[{row}, 3]" for name, row in places)
    return f"Of a pose, {meant} counts; other entries are ignored."
