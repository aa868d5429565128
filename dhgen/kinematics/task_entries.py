"""Which entries of the pose a task names."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from dhgen.robot.task import Task

_COORDINATES = {"x": "t14", "y": "t24", "z": "t34"}
_ROTATION = frozenset(f"t{row}{column}" for row in (1, 2, 3) for column in (1, 2, 3))
_POSITION = frozenset(_COORDINATES.values())
_APPROACH = frozenset({"t13", "t23", "t33"})
_SECOND = frozenset({"t12", "t22", "t32"})


def task_entries(task: Task) -> frozenset[str]:
    """Names of the entries of U_0 that a task gives."""
    match task.kind:
        case TaskKind.POSE:
            return _ROTATION | _POSITION
        case TaskKind.POSITION:
            return _POSITION
        case TaskKind.ORIENTATION:
            return _ROTATION
        case TaskKind.POINTING:
            return _POSITION | _APPROACH
        case TaskKind.COORDINATES:
            return frozenset(_COORDINATES[name] for name in task.coordinates)


def telling_entries(task: Task) -> frozenset[str]:
    """Those of them that have to be compared: two columns of a rotation leave none for the third.

    With those two off by no more than a small d each, the second is off by less than 3 d.
    """
    return task_entries(task) - _SECOND
