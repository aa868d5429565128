"""The equation types, one module each, in the order in which they are tried.

`CLOSED` are the types of the books and two more, with roots of squares only; `QUARTIC` adds type 9,
for arms that `CLOSED` does not solve.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.types.angle import Angle
from dhgen.paul.types.angle_and_length import AngleAndLength
from dhgen.paul.types.angle_pair import AnglePair
from dhgen.paul.types.circle import Circle
from dhgen.paul.types.length import SingleLength
from dhgen.paul.types.length_on_a_line import LengthOnALine
from dhgen.paul.types.polar import Polar
from dhgen.paul.types.squared_length import SquaredLength
from dhgen.paul.types.two_angles import TwoAngles
from dhgen.paul.types.two_lengths import TwoLengths

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
