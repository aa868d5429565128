"""Type 10: X r^2 + Y r = Z."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.effects import merged_effect
from dhgen.derivation.notation.names import letter
from dhgen.derivation.step_context import Singularity, StepText, type_letter
from dhgen.derivation.text.blocks import display, paragraph, say
from dhgen.derivation.text.formula import (
    ZERO,
    add,
    equal,
    number,
    over,
    relation,
    root,
    square,
    subtract,
    times,
)
from dhgen.derivation.types.line import put_in

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext

X, Y, Z = (type_letter(name) for name in "XYZ")
D = letter("D", "D")
NEARER = "the point is nearer than the slide can come"
NEAREST = "the slide stands where it comes nearest to the other end of that length"
APART = "no two lengths fulfil both equations"
TOUCHING = "the line that the first equation is touches the curve that the second is"


def print_squared_length(context: StepContext) -> StepText:
    """A quadratic equation in r."""
    r, one = context.unknown, len(context.step.forms) == 1
    half = over(Y, times(number(2), X))
    met = Singularity(
        context.number,
        equal(D, ZERO),
        None,
        say(NEAREST if one else TOUCHING),
        merged_effect(context),
    )
    left = add(times(X, square(r)), times(Y, r))
    told = "The squared length of a vector is {}, a quadratic equation, with"
    given = [paragraph(told, equal(left, Z))] if one else put_in(context, left, Z)
    blocks = (
        *given,
        display(context.definition("X"), context.definition("Y"), context.definition("Z")),
        paragraph("Its roots:"),
        display(
            equal(D, add(square(half), over(Z, X))),
            equal(r, subtract(times(context.sign, root(D)), half)),
        ),
        paragraph(
            f"No solution when {{}}: {NEARER if one else APART}. The two solutions meet when {{}}: "
            "{}. Then {}.",
            relation(D, "<", ZERO),
            met.condition,
            met.meaning,
            met.effect,
        ),
    )
    return StepText(blocks, (met,))
