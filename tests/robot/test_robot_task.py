"""What a task names."""

from __future__ import annotations

import pytest

from dhgen.robot.task import Task, TaskKind

XYZ = (0, 1, 2)


@pytest.mark.parametrize(
    ("task", "rotation", "direction", "rows", "dimension"),
    [
        (Task(TaskKind.POSE), True, True, XYZ, 6),
        (Task(TaskKind.POSITION), False, False, XYZ, 3),
        (Task(TaskKind.ORIENTATION), True, True, (), 3),
        (Task(TaskKind.POINTING), False, True, XYZ, 5),
        (Task(TaskKind.COORDINATES, ("x", "z")), False, False, (0, 2), 2),
    ],
    ids=lambda value: value.kind.value if isinstance(value, Task) else "",
)
def test_what_counts(
    task: Task, *, rotation: bool, direction: bool, rows: tuple[int, ...], dimension: int
) -> None:
    assert (task.names_rotation, task.names_direction) == (rotation, direction)
    assert (task.position_rows, task.dimension) == (rows, dimension)
