"""One kernel for each equation type, a closed form with what happens where it degenerates.

Sources: the table of types of document 003 (after W. Khalil and E. Dombre, Modeling, Identification
and Control of Robots, 2002, chapter 4). An angle is found as its cosine and sine, which later steps
take; its value is taken from both of them. `KERNELS` is the table.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.kind import Kind
from dhgen.program.lowering.types.angle import lower_angle, lower_angle_pair
from dhgen.program.lowering.types.angle_and_length import lower_angle_and_length, lower_polar
from dhgen.program.lowering.types.circle import lower_circle
from dhgen.program.lowering.types.lengths import (
    lower_length,
    lower_squared_length,
    lower_two_lengths,
)
from dhgen.program.lowering.types.two_angles import lower_two_angles

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.paul.step import Step
    from dhgen.program.lowering.context import Lowering

KERNELS: dict[Kind, Callable[[Lowering, Step], None]] = {
    Kind.LENGTH: lower_length,
    Kind.ANGLE: lower_angle,
    Kind.ANGLE_PAIR: lower_angle_pair,
    Kind.POLAR: lower_polar,
    Kind.ANGLE_AND_LENGTH: lower_angle_and_length,
    Kind.TWO_ANGLES: lower_two_angles,
    Kind.TWO_ANGLES_TURNED: lower_two_angles,
    Kind.ANGLE_AND_SUM: lower_two_angles,
    Kind.CIRCLE: lower_circle,
    Kind.SQUARED_LENGTH: lower_squared_length,
    Kind.TWO_LENGTHS: lower_two_lengths,
}
