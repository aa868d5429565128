"""Types 4 and 5: an angle and a length, as polar coordinates or by two linear equations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.program.lowering.coefficients import is_short, letters, named
from dhgen.program.lowering.roots import keep_one, over, reach_of, signed_root
from dhgen.program.lowering.set_angle import finish

if TYPE_CHECKING:
    from dhgen.paul.step import Step
    from dhgen.program.lowering.context import Lowering


def lower_polar(context: Lowering, step: Step) -> None:
    """Type 4: r and its angle are polar coordinates, or the opposite ones."""
    angle, unknown = step.angle, step.length
    builder = context.builder
    x1, y1, x2, y2 = letters(context, step, "X1 Y1 X2 Y2")
    u, v = builder.div(y1, x1), builder.div(y2, x2)
    length = builder.apply("sqrt", builder.add(builder.square(u), builder.square(v)))
    length = builder.name(length, f"w{unknown.joint}")
    free = is_short(context, length, 1, f"free{angle.suffix}")
    sign = context.new_sign(angle.suffix)
    keep_one(context, sign, free)
    factor = over(context, sign, length, free, angle.suffix)
    finish(context, angle, builder.mul(v, factor), builder.mul(u, factor), free)
    context.angles.solved_slide(unknown.name, builder.mul(sign, length))


def lower_angle_and_length(context: Lowering, step: Step) -> None:
    """Type 5: a quadratic in r, then the angle.

    Its discriminant b^2 - a c is written a - (V x W)^2, which loses nothing where it is small.
    """
    angle, unknown = step.angle, step.length
    builder = context.builder
    x1, y1, z1, x2, y2, z2 = letters(context, step, "X1 Y1 Z1 X2 Y2 Z2")
    quotients = builder.div(y1, x1), builder.div(z1, x1), builder.div(y2, x2), builder.div(z2, x2)
    for letter, node in zip(("V1", "W1", "V2", "W2"), quotients, strict=True):
        builder.hint(node, named(letter, angle.suffix))
    v1, w1, v2, w2 = quotients
    a = builder.add(builder.square(w1), builder.square(w2))
    b = builder.name(builder.add(builder.mul(v1, w1), builder.mul(v2, w2)), f"B{unknown.joint}")
    off = builder.sub(builder.mul(v1, w2), builder.mul(v2, w1))
    discriminant = builder.name(builder.sub(a, builder.square(off)), f"D{unknown.joint}_squared")
    reach, merge, blur = (
        builder.mul(builder.mul(builder.integer(2), a), delta)
        for delta in context.scales.distances(0)
    )
    within = reach_of(context, discriminant, (reach, merge, blur), 0)
    root = signed_root(context, angle.suffix, within)
    r = builder.name(builder.div(builder.sub(root, b), a), unknown.name)
    context.angles.solved_slide(unknown.name, r)
    sine = builder.add(v1, builder.mul(w1, r))
    cosine = builder.add(v2, builder.mul(w2, r))
    finish(context, angle, cosine, sine)
