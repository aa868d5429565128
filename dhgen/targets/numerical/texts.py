"""What the templates of the numerical solver loop over."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
from typing import TYPE_CHECKING

from dhgen.numerical.miss import ANY_AXIS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.numerical.both_sides import Turning


@dataclass(frozen=True, slots=True)
class PositionRow:
    """A coordinate that the task names.

    Attributes:
        equation: Which of the equations it gives.
        row: Its row in a pose.
        place: Its place in a pose, row-major.
    """

    equation: int
    row: int
    place: int


@dataclass(frozen=True, slots=True)
class TurningPlace:
    """A joint that turns a root: its place in the arm, from 0, and + or -."""

    place: int
    sign: str


@dataclass(frozen=True, slots=True)
class TurnComponent:
    """A component of half a turn about some axis [rad]."""

    place: int
    angle: str


def position_rows(rows: Sequence[int]) -> tuple[PositionRow, ...]:
    """The coordinates in these rows of the translation."""
    return tuple(PositionRow(equation, row, 4 * row + 3) for equation, row in enumerate(rows))


def turning_places(turning: Turning) -> tuple[TurningPlace, ...]:
    """The joints, given from 1, that turn a root."""
    return tuple(TurningPlace(joint - 1, "+" if sign > 0 else "-") for joint, sign in turning)


def any_turn() -> tuple[TurnComponent, ...]:
    """Half a turn that serves where every axis does."""
    return tuple(TurnComponent(place, repr(pi * part)) for place, part in enumerate(ANY_AXIS))
