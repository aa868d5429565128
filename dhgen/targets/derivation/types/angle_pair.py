"""Type 3: two equations in one angle, by Cramer's rule."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.derivation.blocks import display, paragraph, say
from dhgen.targets.derivation.effects import free_effect
from dhgen.targets.derivation.formula import (
    ZERO,
    Call,
    Formula,
    Listing,
    add,
    atan2,
    equal,
    minus,
    over,
    square,
    subtract,
    times,
)
from dhgen.targets.derivation.joint_space import point_name
from dhgen.targets.derivation.names import cosine, sine, theta
from dhgen.targets.derivation.step_context import Singularity, StepText, type_letter

if TYPE_CHECKING:
    from dhgen.targets.derivation.blocks import Block
    from dhgen.targets.derivation.step_context import StepContext

X1, Y1, Z1, X2, Y2, Z2 = (type_letter(name) for name in ("X1", "Y1", "Z1", "X2", "Y2", "Z2"))
DELTA = type_letter("Δ")


def print_angle_pair(context: StepContext) -> StepText:
    """Sine and cosine alone, or Cramer's rule."""
    if is_direct(context):
        return _direct(context)
    return _cramer(context)


def is_direct(context: StepContext) -> bool:
    """Whether each equation holds only the sine or only the cosine, with a constant factor."""
    zeros = [not context.polynomial(name) for name in ("X1", "Y1", "X2", "Y2")]
    return zeros in ([True, False, False, True], [False, True, True, False]) and context.is_constant(
        "X1", "Y1", "X2", "Y2"
    )


def _direct(context: StepContext) -> StepText:
    s, c = sine(context.angle), cosine(context.angle)
    number = "1" if context.polynomial("X1") else "2"
    other = "2" if number == "1" else "1"
    lines = []
    for symbol, factor, value in ((s, "X" + number, "Z" + number), (c, "Y" + other, "Z" + other)):
        full = over(context.story.write(context.polynomial(value)), context.value(factor))
        short = over(context.value(value), context.value(factor))
        lines.append(equal(symbol, full, short))
    return StepText(
        (
            paragraph("Sine and cosine stand alone,"),
            display(*lines),
            display(equal(theta(context.angle), atan2(s, c))),
        )
    )


def _cramer(context: StepContext) -> StepText:
    s, c = sine(context.angle), cosine(context.angle)
    first, second = add(times(X1, s), times(Y1, c)), add(times(X2, s), times(Y2, c))
    delta, turned = _determinant(context)
    above = subtract(times(Z1, Y2), times(Z2, Y1)), subtract(times(X1, Z2), times(X2, Z1))
    if turned > 0:
        above = subtract(times(X1, Z1), times(Y1, Z2)), add(times(X1, Z2), times(Y1, Z1))
    elif turned < 0:
        above = add(times(X1, Z1), times(Y1, Z2)), subtract(times(Y1, Z1), times(X1, Z2))
    facing: Formula | None = None if turned else Call("sgn", (DELTA,))
    parts = [a if facing is None else times(facing, a) for a in above]
    blocks: list[Block] = [
        paragraph("These are {} and {} with", equal(first, Z1), equal(second, Z2)),
        display(*_definitions(context, turned)),
        paragraph("The determinant is {}, so Cramer's rule gives", delta),
        display(equal(theta(context.angle), atan2(*parts))),
    ]
    if context.is_constant("X1", "Y1", "X2", "Y2"):
        return StepText(tuple(blocks))
    condition = Listing((equal(Z1, ZERO), equal(Z2, ZERO))) if turned else equal(DELTA, ZERO)
    meaning = say(f"{point_name(context)} is where {{}} does not move it", theta(context.angle))
    free = Singularity(context.number, condition, None, meaning, free_effect(context))
    size = add(square(Z1), square(Z2))
    both = equal(add(square(X1), square(Y1)), size)
    text = "Degenerate when {}: then {}, and {}."
    shown: Formula = equal(*both.sides, ZERO) if turned else condition
    blocks.append(paragraph(text, shown, free.meaning, free.effect))
    return StepText(tuple(blocks), (free,))


def _definitions(context: StepContext, turned: int) -> list[Formula]:
    """The letters; those that repeat another are given by it."""
    names = ["X1", "Y1", "Z1", "Z2"] if turned else ["X1", "Y1", "Z1", "X2", "Y2", "Z2"]
    lines = [context.definition(name) for name in names]
    if turned:
        x, y = (minus(Y1), X1) if turned > 0 else (Y1, minus(X1))
        lines.insert(3, Listing((equal(X2, x), equal(Y2, y))))
    return lines


def _determinant(context: StepContext) -> tuple[Formula, int]:
    """X1 Y2 - X2 Y1, and +1 or -1 when the second row is the first one turned."""
    x1, y1, x2, y2 = (context.polynomial(name) for name in ("X1", "Y1", "X2", "Y2"))
    full = subtract(times(X1, Y2), times(X2, Y1))
    if (x2, y2) == (-y1, x1):
        return equal(full, add(square(X1), square(Y1))), 1
    if (x2, y2) == (y1, -x1):
        return equal(full, minus(add(square(X1), square(Y1)))), -1
    determinant = context.story.algebra.normal(x1 * y2 - x2 * y1)
    return equal(DELTA, full, context.story.write(determinant, context.number)), 0
