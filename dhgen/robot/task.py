"""What of the tool's pose the caller means, and what follows for everything that is asked of it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class TaskKind(Enum):
    """What of the tool's pose the caller means."""

    POSE = "pose"
    POSITION = "position"
    ORIENTATION = "orientation"
    POINTING = "pointing"  # position and the tool's z axis
    COORDINATES = "coordinates"  # a list out of x, y, z


@dataclass(frozen=True, slots=True)
class Task:
    """What of T the caller means; `coordinates` is filled for TaskKind.COORDINATES only.

    Attributes:
        kind: Which entries.
        coordinates: Out of "x", "y", "z", in this order.
    """

    kind: TaskKind
    coordinates: tuple[str, ...] = ()

    @property
    def names_rotation(self) -> bool:
        """Whether the whole orientation counts."""
        return self.kind in {TaskKind.POSE, TaskKind.ORIENTATION}

    @property
    def names_direction(self) -> bool:
        """Whether the direction of the tool's z axis counts, alone or with the others."""
        return self.names_rotation or self.kind is TaskKind.POINTING

    @property
    def position_rows(self) -> tuple[int, ...]:
        """Which of x, y, z count, from 0: rows of the last column."""
        match self.kind:
            case TaskKind.ORIENTATION:
                return ()
            case TaskKind.COORDINATES:
                return tuple("xyz".index(name) for name in self.coordinates)
            case _:
                return 0, 1, 2

    @property
    def dimension(self) -> int:
        """How many independent numbers count: two fix a direction."""
        turns = 3 if self.names_rotation else 2 if self.names_direction else 0
        return len(self.position_rows) + turns
