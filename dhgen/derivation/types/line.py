"""How a line in two lengths is put into the squared length of the same: types 1 and 10 of both."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import unknown_symbol
from dhgen.derivation.text.blocks import display, paragraph
from dhgen.derivation.text.formula import ONE, equal, over, subtract, times
from dhgen.paul.types.length_on_a_line import line_of

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula


def put_in(context: StepContext, left: Formula, right: Formula) -> list[Block]:
    """What the line gives, and the equation that the other becomes with it, up to a factor."""
    write, r = context.story.write, context.unknown
    length, (v, w, z) = line_of(context.step)
    gone, factor = unknown_symbol(length), write(v**2)
    if v.is_ground:
        v, w, z = v / v, w / v, z / v
    blocks: list[Block] = [
        paragraph("The first equation is linear in {} and {}, and gives", gone, r),
        display(equal(gone, over(subtract(write(z), times(write(w), r)), write(v)))),
    ]
    told = "With it the other holds {} alone. "
    if factor == ONE:
        return [*blocks, paragraph(told + "It is {} with", r, equal(left, right))]
    return [*blocks, paragraph(told + "Times {} it is {} with", r, factor, equal(left, right))]
