"""Type 10: X r^2 + Y r = Z."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.derivation.effects import merged_effect
from dhgen.targets.derivation.notation.names import letter
from dhgen.targets.derivation.step_context import Singularity, StepText, type_letter
from dhgen.targets.derivation.text.blocks import display, paragraph, say
from dhgen.targets.derivation.text.formula import (
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

if TYPE_CHECKING:
    from dhgen.targets.derivation.step_context import StepContext

X, Y, Z = (type_letter(name) for name in "XYZ")
D = letter("D", "D")


def print_squared_length(context: StepContext) -> StepText:
    """A quadratic equation in r."""
    r = context.unknown
    half = over(Y, times(number(2), X))
    met = Singularity(
        context.number,
        equal(D, ZERO),
        None,
        say("the slide stands where it comes nearest to the other end of that length"),
        merged_effect(context),
    )
    blocks = (
        paragraph(
            "The squared length of a vector is {}, a quadratic equation, with",
            equal(add(times(X, square(r)), times(Y, r)), Z),
        ),
        display(context.definition("X"), context.definition("Y"), context.definition("Z")),
        paragraph("Its roots:"),
        display(
            equal(D, add(square(half), over(Z, X))),
            equal(r, subtract(times(context.sign, root(D)), half)),
        ),
        paragraph(
            "No solution when {}: the point is nearer than the slide can come. The two solutions "
            "meet when {}: {}. Then {}.",
            relation(D, "<", ZERO),
            met.condition,
            met.meaning,
            met.effect,
        ),
    )
    return StepText(blocks, (met,))
