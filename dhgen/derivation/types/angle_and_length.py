"""Types 4 and 5: an angle and a length, as polar coordinates or by two linear equations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.conditions import vanishing
from dhgen.derivation.effects import free_effect, merged_effect, nothing_said
from dhgen.derivation.notation.names import cosine, letter, sine, theta, unknown_symbol
from dhgen.derivation.step_context import Singularity, StepText, type_letter
from dhgen.derivation.text.blocks import Given, display, paragraph, say
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
    from dhgen.derivation.text.blocks import Prose
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
    full = context.in_full(context.polynomial("Y" + number))
    return over(full, below), over(context.value("Y" + number), below)


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
        _at_right_angles(context),
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


def _at_right_angles(context: StepContext) -> Formula | Prose | None:
    """W_1 s + W_2 c = 0 by joints."""
    algebra = context.story.algebra
    s, c = (algebra.generator(name) for name in (context.angle.sine, context.angle.cosine))
    x1, z1, x2, z2 = (context.polynomial(name) for name in ("X1", "Z1", "X2", "Z2"))
    return vanishing(context, algebra.normal(z1 * x2 * s + z2 * x1 * c))


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
