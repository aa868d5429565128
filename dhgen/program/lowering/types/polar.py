"""Type 4: an angle and a length that are polar coordinates."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.program.lowering.finish import finish
from dhgen.program.lowering.letters import letters
from dhgen.program.lowering.roots import keep_one, over
from dhgen.program.lowering.short import is_short

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
    sign = context.new_sign()
    keep_one(context, sign, free)
    factor = over(context, sign, length, free, angle.suffix)
    finish(context, angle, builder.mul(v, factor), builder.mul(u, factor), free)
    context.angles.solved_slide(unknown.name, builder.mul(sign, length))
