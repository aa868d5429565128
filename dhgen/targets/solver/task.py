"""What of a pose counts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.task import COORDINATES, Directions, TaskKind

if TYPE_CHECKING:
    from dhgen.robot.task import Task

_DIRECTIONS = {
    Directions.POINTING: "the tool's z axis T[0:3, 2]",
    Directions.ROTATION: "the orientation T[0:3, 0:3]",
    Directions.YAW: "the yaw atan2(T[1, 0], T[0, 0])",
    Directions.PITCH: "the pitch asin(-T[2, 0])",
    Directions.TILT: "roll and pitch, T[2, 0:3],",
}


def meaning(task: Task) -> str:
    """What of a pose counts, as a sentence."""
    if task.kind is TaskKind.POSE:
        return "Every entry of a pose counts."
    rows = task.position_rows
    meant = [f"{COORDINATES[row]} = T[{row}, 3]" for row in rows]
    if task.kind is not TaskKind.LIST:
        meant = ["the position T[0:3, 3]"] if rows else []
    if task.directions is not Directions.NONE:
        meant.append(_DIRECTIONS[task.directions])
    return f"Of a pose, {' and '.join(meant)} counts; other entries are ignored."
