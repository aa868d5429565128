"""Type 1: X r = Y."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.derivation.blocks import display, paragraph
from dhgen.targets.derivation.formula import ZERO, equal, over, times
from dhgen.targets.derivation.step_context import StepText, type_letter

if TYPE_CHECKING:
    from dhgen.targets.derivation.blocks import Block
    from dhgen.targets.derivation.step_context import StepContext

X, Y = type_letter("X"), type_letter("Y")


def print_length(context: StepContext) -> StepText:
    """r = Y / X."""
    r = context.unknown
    if context.is_number("X"):
        (quote,) = context.quotes
        x = context.value("X")
        full = over(context.story.write(context.polynomial("Y")), x)
        solved = equal(r, full, over(context.value("Y"), x))
        quoted = equal(*(context.story.write(s) for s in (quote.left, quote.right)))
        if solved == quoted:
            return StepText((paragraph("The unknown stands alone already."),))
        return StepText((display(solved),))
    blocks: list[Block] = [
        paragraph("This is {} with", equal(times(X, r), Y)),
        display(context.definition("X"), context.definition("Y")),
        display(equal(r, over(Y, X))),
    ]
    if not context.is_constant("X"):
        blocks.append(paragraph("Undetermined where {}.", equal(X, ZERO)))
    return StepText(tuple(blocks))
