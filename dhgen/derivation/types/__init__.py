"""One printer for each equation type; `PRINTERS` is the table."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.types.angle import print_angle
from dhgen.derivation.types.angle_and_length import print_angle_and_length, print_polar
from dhgen.derivation.types.angle_pair import print_angle_pair
from dhgen.derivation.types.circle import print_circle
from dhgen.derivation.types.lengths import print_length, print_squared_length, print_two_lengths
from dhgen.derivation.types.two_angles import print_two_angles
from dhgen.paul.kind import Kind

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.derivation.step_context import StepContext, StepText

PRINTERS: dict[Kind, Callable[[StepContext], StepText]] = {
    Kind.LENGTH: print_length,
    Kind.ANGLE: print_angle,
    Kind.ANGLE_PAIR: print_angle_pair,
    Kind.POLAR: print_polar,
    Kind.ANGLE_AND_LENGTH: print_angle_and_length,
    Kind.TWO_ANGLES: print_two_angles,
    Kind.TWO_ANGLES_TURNED: print_two_angles,
    Kind.ANGLE_AND_SUM: print_two_angles,
    Kind.CIRCLE: print_circle,
    Kind.SQUARED_LENGTH: print_squared_length,
    Kind.TWO_LENGTHS: print_two_lengths,
}
