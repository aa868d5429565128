"""The equation types, one module each, in the order in which they are tried.

`CLOSED` are the types of the books and two more, with roots of squares only; `QUARTIC` adds type 9,
for arms that `CLOSED` does not solve.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.types.angle import Angle
from dhgen.paul.types.angle_and_length import AngleAndLength, Polar
from dhgen.paul.types.angle_pair import AnglePair
from dhgen.paul.types.circle import Circle
from dhgen.paul.types.lengths import LengthOnALine, SingleLength, SquaredLength, TwoLengths
from dhgen.paul.types.two_angles import TwoAngles

if TYPE_CHECKING:
    from dhgen.paul.step import EquationType

CLOSED: tuple[EquationType, ...] = (
    SingleLength(),
    Angle(),
    AnglePair(),
    Polar(),
    AngleAndLength(),
    TwoAngles(),
    SquaredLength(),
    LengthOnALine(),
    TwoLengths(),
)
QUARTIC: tuple[EquationType, ...] = (*CLOSED, Circle())
