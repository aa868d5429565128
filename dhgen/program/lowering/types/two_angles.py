"""Types 6, 7 and 8: two angles."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.kinematics.ring import constant_value
from dhgen.program.lowering.arm_scale import Extremes
from dhgen.program.lowering.coefficients import letters
from dhgen.program.lowering.distances import reached
from dhgen.program.lowering.roots import signed_root
from dhgen.program.lowering.set_angle import finish
from dhgen.program.lowering.types.angle import lower_angle

if TYPE_CHECKING:
    from dhgen.paul.step import Step
    from dhgen.program.lowering.context import Lowering


def lower_two_angles(context: Lowering, step: Step) -> None:
    """Types 6, 7, 8 for the difference of the angles: the law of cosines.

    For one of the angles themselves, what is left is of type 2, X s + Y c = Z. With H and L the
    squares of the longest and shortest reach, D = (H - |Z|^2)(|Z|^2 - L) is accurate also where
    the arm is nearly folded.
    """
    if step.has("Z"):
        lower_angle(context, step)
        return
    angle = step.angle
    builder = context.builder
    z1, z2 = letters(context, step, "Z1 Z2")
    reach = builder.name(builder.add(builder.square(z1), builder.square(z2)), f"N{angle.suffix}")
    x, y, n = letters(context, step, "X Y N")
    k = builder.name(builder.sub(reach, n), f"K{angle.suffix}")
    square = builder.add(builder.square(x), builder.square(y))
    v, w = (
        math.hypot(
            *(constant_value(context.algebra, step.coefficient(letter + part)) for part in "12")
        )
        for letter in "VW"
    )
    ends = Extremes(v + w, abs(v - w))
    root = signed_root(context, angle.suffix, reached(context, reach, ends, angle.suffix))
    if builder.is_zero(x):
        sine, cosine = builder.div(root, y), builder.div(k, y)
    else:
        sine = builder.div(builder.add(builder.mul(x, k), builder.mul(y, root)), square)
        cosine = builder.div(builder.sub(builder.mul(y, k), builder.mul(x, root)), square)
    finish(context, angle, cosine, sine)
