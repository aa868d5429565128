"""Type 11: X1 r_i + Y1 r_j = Z1, X2 r_i + Y2 r_j = Z2."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.effects import free_effect
from dhgen.derivation.notation.names import letter, unknown_symbol
from dhgen.derivation.step_context import Singularity, StepText, type_letter
from dhgen.derivation.text.blocks import display, paragraph, say
from dhgen.derivation.text.formula import ZERO, add, equal, over, subtract, times

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.text.blocks import Block

X1, Y1, Z1, X2, Y2, Z2 = (type_letter(name) for name in ("X1", "Y1", "Z1", "X2", "Y2", "Z2"))
DELTA = letter(r"\Delta", "Δ")


def print_two_lengths(context: StepContext) -> StepText:
    """Cramer's rule."""
    first, second = (unknown_symbol(unknown) for unknown in context.step.unknowns)
    determinant, delta = context.determinant, subtract(times(X1, Y2), times(X2, Y1))
    blocks: list[Block] = [
        paragraph(
            "These are {} and {} with",
            equal(add(times(X1, first), times(Y1, second)), Z1),
            equal(add(times(X2, first), times(Y2, second)), Z2),
        ),
        display(*map(context.definition, ("X1", "Y1", "Z1", "X2", "Y2", "Z2"))),
        paragraph("By Cramer's rule, with the determinant {},", DELTA),
        display(
            equal(DELTA, delta, context.story.write(determinant, context.number)),
            equal(first, over(subtract(times(Z1, Y2), times(Z2, Y1)), DELTA)),
            equal(second, over(subtract(times(X1, Z2), times(X2, Z1)), DELTA)),
        ),
    ]
    if context.story.algebra.is_constant(determinant):
        return StepText(tuple(blocks))
    meaning = say(
        "the slides move the tool in fewer directions than there are slides; all {} and {} on a "
        "line work if both equations name the same line, and none otherwise",
        first,
        second,
    )
    free = Singularity(
        context.number, equal(DELTA, ZERO), None, meaning, free_effect(context), frees=True
    )
    text = "Degenerate when {}: {}. If they do, {}."
    blocks.append(paragraph(text, equal(DELTA, ZERO), meaning, free.effect))
    return StepText(tuple(blocks), (free,))
