"""Type 3: an angle from two equations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.ring import constant_value
from dhgen.paul.types.angle_pair import stretch
from dhgen.program.lowering.coefficients import letters
from dhgen.program.lowering.roots import over
from dhgen.program.lowering.set_angle import finish
from dhgen.program.lowering.thresholds import is_nearly_short, is_short_square

if TYPE_CHECKING:
    from dhgen.paul.step import Step
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering


def lower_angle_pair(context: Lowering, step: Step) -> None:
    """Type 3: Cramer's rule, made a unit vector where rounding or the pose may spoil it."""
    angle = step.angle
    builder = context.builder
    x1, y1, z1, x2, y2, z2 = letters(context, step, "X1 Y1 Z1 X2 Y2 Z2")
    determinant = builder.sub(builder.mul(x1, y2), builder.mul(x2, y1))
    sine = builder.sub(builder.mul(z1, y2), builder.mul(z2, y1))
    cosine = builder.sub(builder.mul(x1, z2), builder.mul(x2, z1))
    builder.hint(sine, f"S{angle.suffix}")
    builder.hint(cosine, f"C{angle.suffix}")
    factors = [step.coefficient(letter) for letter in ("X1", "Y1", "X2", "Y2")]
    if context.are_constant(*factors) and not context.overdetermined:
        sine, cosine = builder.div(sine, determinant), builder.div(cosine, determinant)
        finish(context, angle, cosine, sine)
        return
    sides = step.coefficient("Z1"), step.coefficient("Z2")
    degree = context.scales.degree(*factors) + context.scales.degree(*sides)
    facing = _sign_of(context, determinant, step)
    length = builder.apply("sqrt", builder.add(builder.square(sine), builder.square(cosine)))
    length = builder.name(length, f"w{angle.suffix}")
    # the product of two vectors of equal length, which vanish together
    free = is_short_square(context, length, degree // 2, angle)
    if context.mends_roots:
        context.short.append(is_nearly_short(context, length, degree // 2, angle))
    factor = over(context, facing, length, free, angle.suffix)
    finish(context, angle, builder.mul(cosine, factor), builder.mul(sine, factor), free)


def _sign_of(context: Lowering, determinant: Node, step: Step) -> Node:
    """+1 or -1 as the determinant, which is known where X2, Y2 is X1, Y1 turned and stretched.

    And where it is made of the arm's lengths and twists alone.
    """
    builder = context.builder
    x1, y1, x2, y2 = (step.coefficient(letter) for letter in ("X1", "Y1", "X2", "Y2"))
    factor = stretch(x1, y1, x2, y2)
    if factor is None and context.are_constant(x1, y1, x2, y2):
        factor = x1 * y2 - x2 * y1
    if factor is not None and context.are_constant(factor):
        return builder.integer(1 if constant_value(context.algebra, factor) > 0.0 else -1)
    negative = builder.apply("less", determinant, builder.integer(0))
    return builder.select(negative, builder.integer(-1), builder.integer(1))
