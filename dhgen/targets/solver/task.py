"""What of a pose counts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from dhgen.robot.task import Task


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
