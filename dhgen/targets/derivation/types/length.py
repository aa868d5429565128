"""Type 1: X r = Y."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.derivation.blocks import display, paragraph
from dhgen.targets.derivation.formula import equal, over, relation, times
from dhgen.targets.derivation.formula import ZERO
from dhgen.targets.derivation.step_context import StepText, type_letter

if TYPE_CHECKING:
    from dhgen.targets.derivation.step_context import StepContext


def print_length(context: StepContext) -> StepText:
    """r = Y / X."""
    r = context.unknown
    x, y = context.value("X"), context.value("Y")
    if context.is_number("X"):
        return StepText((display(equal(r, over(y, x))),))
    general = over(type_letter("Y"), type_letter("X"))
    blocks = [
        paragraph("This is {} with", equal(times(type_letter("X"), r), type_letter("Y"))),
        display(context.definition("X"), context.definition("Y")),
        display(equal(r, general)),
    ]
    if not context.is_constant("X"):
        blocks.append(paragraph("Undetermined where {}.", relation(type_letter("X"), "=", ZERO)))
    return StepText(tuple(blocks))
