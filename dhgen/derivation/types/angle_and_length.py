"""Type 5: X1 s = Y1 + Z1 r, X2 c = Y2 + Z2 r."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.effects import merged_effect
from dhgen.derivation.notation.names import cosine, letter, sine, theta, unknown_symbol
from dhgen.derivation.step_context import Singularity, StepText, type_letter
from dhgen.derivation.text.blocks import display, paragraph, say
from dhgen.derivation.text.formula import (
    ONE,
    ZERO,
    add,
    atan2,
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
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.text.formula import Formula

V1, W1, V2, W2 = (type_letter(name) for name in ("V1", "W1", "V2", "W2"))
A, B, C, D = (letter(name, name) for name in "ABCD")


def print_angle_and_length(context: StepContext) -> StepText:
    """The squares of sine and cosine give a quadratic equation in r."""
    r = unknown_symbol(context.step.unknowns[1])
    s, c = sine(context.angle), cosine(context.angle)
    s_value, c_value = add(V1, times(W1, r)), add(V2, times(W2, r))
    quadratic = equal(add(times(A, square(r)), times(number(2), B, r), C), ZERO)
    met = Singularity(
        context.number,
        equal(D, ZERO),
        equal(add(times(W1, s), times(W2, c)), ZERO),
        say("the link stands at a right angle to the slide"),
        merged_effect(context),
    )
    blocks = (
        paragraph(
            "Divided by the factors of {} and {} they are {} and {} with",
            s,
            c,
            equal(s, s_value),
            equal(c, c_value),
        ),
        display(*_quotients(context)),
        paragraph("The squares add up to 1, a quadratic equation in {}: {} with", r, quadratic),
        display(*_letters()),
        paragraph("Its roots, and the angle that goes with each:"),
        display(
            equal(r, over(subtract(times(context.sign, root(D)), B), A)),
            equal(theta(context.angle), atan2(s_value, c_value)),
        ),
        paragraph(
            "No solution when {}: the point is farther from the slide than the link reaches. The "
            "two solutions meet when {}: {}. Then {}.",
            relation(D, "<", ZERO),
            met.condition,
            met.meaning,
            met.effect,
        ),
    )
    return StepText(blocks, (met,))


def _quotients(context: StepContext) -> list[Formula]:
    value = context.value
    return [
        equal(V1, over(value("Y1"), value("X1"))),
        equal(W1, over(value("Z1"), value("X1"))),
        equal(V2, over(value("Y2"), value("X2"))),
        equal(W2, over(value("Z2"), value("X2"))),
    ]


def _letters() -> list[Formula]:
    across = subtract(times(V1, W2), times(V2, W1))
    return [
        equal(A, add(square(W1), square(W2))),
        equal(B, add(times(V1, W1), times(V2, W2))),
        equal(C, subtract(add(square(V1), square(V2)), ONE)),
        equal(D, subtract(square(B), times(A, C)), subtract(A, square(across))),
    ]
