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
    DIRECTION = "direction"  # the tool's z axis alone
    LIST = "list"  # some of x, y, z and of roll, pitch, yaw


class Directions(Enum):
    """What counts of a rotation R = Rz(yaw) Ry(pitch) Rx(roll); the runtime has equal names."""

    NONE = "none"
    POINTING = "pointing"  # its third column: the tool's z axis
    ROTATION = "rotation"  # all of it
    YAW = "yaw"  # the direction of the tool's x axis, seen from above
    PITCH = "pitch"  # how steep the tool's x axis is
    TILT = "tilt"  # its third row, roll and pitch: which way is up, seen from the tool

    @property
    def dimension(self) -> int:
        """How many independent numbers fix what counts."""
        single = {Directions.NONE: 0, Directions.YAW: 1, Directions.PITCH: 1}
        return single.get(self, 3 if self is Directions.ROTATION else 2)


ARM_ANGLE = "arm_angle"  # what `free` of a robot file holds instead of joints
ARM_ANGLE_JOINTS = 7  # of arms that have one
COORDINATES = ("x", "y", "z")
ANGLES = {
    (): Directions.NONE,
    ("yaw",): Directions.YAW,
    ("pitch",): Directions.PITCH,
    ("roll", "pitch"): Directions.TILT,
}
"""The angles that a list may hold, in this order."""

_OF_KINDS = {
    TaskKind.POSE: Directions.ROTATION,
    TaskKind.ORIENTATION: Directions.ROTATION,
    TaskKind.POINTING: Directions.POINTING,
    TaskKind.DIRECTION: Directions.POINTING,
}


@dataclass(frozen=True, slots=True)
class Task:
    """What of T the caller means; coordinates and angles are filled for TaskKind.LIST only.

    Attributes:
        kind: Which entries.
        coordinates: Out of "x", "y", "z", in this order.
        angles: A key of `ANGLES`.
    """

    kind: TaskKind
    coordinates: tuple[str, ...] = ()
    angles: tuple[str, ...] = ()

    @property
    def directions(self) -> Directions:
        """What counts of the orientation."""
        return _OF_KINDS.get(self.kind, ANGLES[self.angles])

    @property
    def names_rotation(self) -> bool:
        """Whether the whole orientation counts."""
        return self.directions is Directions.ROTATION

    @property
    def position_rows(self) -> tuple[int, ...]:
        """Which of x, y, z count, from 0: rows of the last column."""
        match self.kind:
            case TaskKind.ORIENTATION | TaskKind.DIRECTION:
                return ()
            case TaskKind.LIST:
                return tuple(COORDINATES.index(name) for name in self.coordinates)
            case _:
                return 0, 1, 2

    @property
    def dimension(self) -> int:
        """How many independent numbers count: two fix a direction."""
        return len(self.position_rows) + self.directions.dimension

    @property
    def text(self) -> str:
        """The task as a robot file writes it."""
        listed = ", ".join((*self.coordinates, *self.angles))
        return f"[{listed}]" if self.kind is TaskKind.LIST else self.kind.value
