"""Type 4: X1 r s = Y1, X2 r c = Y2."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.effects import free_effect, nothing_said
from dhgen.derivation.notation.names import cosine, sine, theta, unknown_symbol
from dhgen.derivation.step_context import Singularity, StepText
from dhgen.derivation.text.blocks import Given, display, paragraph, say
from dhgen.derivation.text.formula import ZERO, add, atan2, equal, over, root, square, times

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.text.formula import Formula


def print_polar(context: StepContext) -> StepText:
    """Polar coordinates, or the opposite ones."""
    r = unknown_symbol(context.step.unknowns[1])
    s, c = sine(context.angle), cosine(context.angle)
    (full_u, u), (full_v, v) = _quotient(context, "1"), _quotient(context, "2")
    axis = Given(str(context.angle.terms[-1][0]))
    text = "the slide is drawn in as far as axis {}, and " + nothing_said(context)
    meaning = say(text, axis, theta(context.angle))
    zero = equal(r, ZERO)
    free = Singularity(context.number, zero, zero, meaning, free_effect(context), frees=True)
    blocks = (
        paragraph("Length and angle are the polar coordinates of a known vector,"),
        display(equal(times(r, s), full_u, u), equal(times(r, c), full_v, v)),
        paragraph("or, with the opposite length, those of the opposite vector:"),
        display(
            equal(r, times(context.sign, root(add(square(u), square(v))))),
            equal(theta(context.angle), atan2(times(context.sign, u), times(context.sign, v))),
        ),
        paragraph(
            "There is always a solution. Degenerate when {}: {}. Then {}.",
            zero,
            meaning,
            free.effect,
        ),
    )
    return StepText(blocks, (free,))


def _quotient(context: StepContext, number: str) -> tuple[Formula, Formula]:
    """Y / X in full, and with the letters of earlier steps."""
    below = context.value("X" + number)
    full = context.story.write(context.polynomial("Y" + number))
    return over(full, below), over(context.value("Y" + number), below)
