"""What a task names."""

from __future__ import annotations

import pytest

from dhgen.robot.task import Directions, Task, TaskKind

XYZ = (0, 1, 2)


@pytest.mark.parametrize(
    ("task", "directions", "rows", "dimension"),
    [
        (Task(TaskKind.POSE), "rotation", XYZ, 6),
        (Task(TaskKind.POSITION), "none", XYZ, 3),
        (Task(TaskKind.ORIENTATION), "rotation", (), 3),
        (Task(TaskKind.POINTING), "pointing", XYZ, 5),
        (Task(TaskKind.DIRECTION), "pointing", (), 2),
        (Task(TaskKind.LIST, ("x", "z")), "none", (0, 2), 2),
        (Task(TaskKind.LIST, ("x", "y"), ("yaw",)), "yaw", (0, 1), 3),
        (Task(TaskKind.LIST, ("x", "y", "z"), ("pitch",)), "pitch", XYZ, 4),
        (Task(TaskKind.LIST, ("x", "y", "z"), ("roll", "pitch")), "tilt", XYZ, 5),
    ],
    ids=lambda value: value.text if isinstance(value, Task) else "",
)
def test_what_counts(task: Task, directions: str, rows: tuple[int, ...], dimension: int) -> None:
    assert task.directions is Directions(directions)
    assert task.names_rotation == (directions == "rotation")
    assert (task.position_rows, task.dimension) == (rows, dimension)
