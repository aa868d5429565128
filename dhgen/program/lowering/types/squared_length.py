"""Type 10: a length from its square."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.program.lowering.letters import letters
from dhgen.program.lowering.roots import reach_of, signed_root

if TYPE_CHECKING:
    from dhgen.paul.step import Step
    from dhgen.program.lowering.context import Lowering


def lower_squared_length(context: Lowering, step: Step) -> None:
    """Type 10: a quadratic in r.

    Rounding of Z moves a root by itself over the distance of both. A length that may be nothing
    else is zero: what it gives a direction to is free then, and not anywhere.
    """
    unknown = step.length
    builder, suffix = context.builder, str(unknown.joint)
    x, y, z = letters(context, step, "X Y Z")
    half = builder.hint(builder.div(y, builder.mul(builder.integer(2), x)), f"H{suffix}")
    square = builder.add(builder.square(half), builder.div(z, x))
    discriminant = builder.name(square, f"D{suffix}")
    within = reach_of(context, discriminant, context.scales.distances(2), 1)
    root = signed_root(context, suffix, within)
    length = builder.sub(root, half)
    size = builder.absolute(length)
    apart = builder.apply("maximum", builder.absolute(root), size)
    noise = context.scales.tolerance(context.scales.tolerances.nothing, 2, "nothing")
    none = builder.apply("at_most", builder.mul(size, apart), noise)
    length = builder.select(none, builder.integer(0), length)
    context.angles.solved_slide(unknown.name, length)
