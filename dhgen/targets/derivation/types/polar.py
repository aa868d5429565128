"""Type 4: X1 r s = Y1, X2 r c = Y2."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.derivation.blocks import display, paragraph, say
from dhgen.targets.derivation.effects import free_effect
from dhgen.targets.derivation.formula import ZERO, add, atan2, equal, over, root, square, times
from dhgen.targets.derivation.names import cosine, sine, theta, unknown_symbol
from dhgen.targets.derivation.step_context import Singularity, StepText

if TYPE_CHECKING:
    from dhgen.targets.derivation.step_context import StepContext


def print_polar(context: StepContext) -> StepText:
    """Polar coordinates, or the opposite ones."""
    r = unknown_symbol(context.step.unknowns[1])
    s, c = sine(context.angle), cosine(context.angle)
    u = over(context.value("Y1"), context.value("X1"))
    v = over(context.value("Y2"), context.value("X2"))
    full_u = over(context.story.write(context.polynomial("Y1")), context.value("X1"))
    full_v = over(context.story.write(context.polynomial("Y2")), context.value("X2"))
    length = root(add(square(u), square(v)))
    sign = context.sign
    free = Singularity(
        context.number,
        equal(r, ZERO),
        equal(r, ZERO),
        say("the slide is drawn in to the axis of joint {}", _joint(context)),
        free_effect(context),
    )
    blocks = (
        paragraph("The length and the angle are polar coordinates of a known vector,"),
        display(equal(times(r, s), full_u, u), equal(times(r, c), full_v, v)),
        paragraph("or the opposite length and angle:"),
        display(
            equal(r, times(sign, length)),
            equal(theta(context.angle), atan2(times(sign, u), times(sign, v))),
        ),
        paragraph(
            "There always is a solution. Degenerate when {}: {} Then {}.",
            equal(r, ZERO), say("every {} serves.", theta(context.angle)), free.effect,
        ),
    )
    return StepText(blocks, (free,))


def _joint(context: StepContext) -> object:
    from dhgen.targets.derivation.blocks import Given  # noqa: PLC0415

    return Given(str(context.angle.terms[-1][0]))
