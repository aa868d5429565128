"""Type 1: X r = Y."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.effects import free_effect, is_left_to_the_pose, others_decide
from dhgen.derivation.step_context import Singularity, StepText, type_letter
from dhgen.derivation.text.blocks import display, paragraph, say
from dhgen.derivation.text.formula import ZERO, equal, over, times
from dhgen.derivation.types.line import put_in

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.text.blocks import Block

X, Y = type_letter("X"), type_letter("Y")


def print_length(context: StepContext) -> StepText:
    """r = Y / X."""
    r = context.unknown
    one = len(context.step.forms) == 1
    if one and context.is_number("X"):
        (quote,) = context.quotes
        x = context.value("X")
        full = over(context.story.write(context.polynomial("Y")), x)
        solved = equal(r, full, over(context.value("Y"), x))
        quoted = equal(*(context.story.write(s) for s in (quote.left, quote.right)))
        if solved == quoted:
            return StepText((paragraph("Here the unknown already stands alone."),))
        return StepText((display(solved),))
    left = times(X, r)
    given = [paragraph("This is {} with", equal(left, Y))] if one else put_in(context, left, Y)
    blocks: list[Block] = [
        *given,
        display(context.definition("X"), context.definition("Y")),
        display(equal(r, over(Y, X))),
    ]
    if context.is_constant("X"):
        return StepText(tuple(blocks))
    none = equal(Y, ZERO)
    meaning = say("every {} works if {}, and none otherwise", r, none)
    if is_left_to_the_pose(context):
        told = f"this equation holds for every {{}} if {{}}, and {others_decide(context)}"
        meaning = say(f"{told}; otherwise none works", r, none)
    free = Singularity(
        context.number, equal(X, ZERO), None, meaning, free_effect(context), frees=True
    )
    text = "Degenerate when {}: {}. If it works, {}."
    blocks.append(paragraph(text, equal(X, ZERO), meaning, free.effect))
    return StepText(tuple(blocks), (free,))
