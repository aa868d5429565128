"""Type 3: two equations in one angle, by Cramer's rule."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.conditions import are_never_zero, vanishing
from dhgen.derivation.effects import free_effect, nothing_said, others_decide, point_name
from dhgen.derivation.notation.names import cosine, letter, sine, theta
from dhgen.derivation.step_context import Singularity, StepText, type_letter
from dhgen.derivation.text.blocks import display, paragraph, say
from dhgen.derivation.text.formula import (
    ONE,
    ZERO,
    Call,
    Formula,
    add,
    atan2,
    equal,
    minus,
    over,
    square,
    subtract,
    times,
)
from dhgen.kinematics.ring import constant_value
from dhgen.paul.types.angle_pair import link_lengths, stretch

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.kinematics.constants import Polynomial

X1, Y1, Z1, X2, Y2, Z2 = (type_letter(name) for name in ("X1", "Y1", "Z1", "X2", "Y2", "Z2"))
DELTA = letter(r"\Delta", "Δ")
CLOSE = 1e-9  # two links nearer in length than this, relative to their sum, are equal


def print_angle_pair(context: StepContext) -> StepText:
    """Sine and cosine alone, or Cramer's rule."""
    if is_direct(context):
        return _direct(context)
    return _cramer(context)


def is_direct(context: StepContext) -> bool:
    """Whether each equation holds only the sine or only the cosine, with a constant factor."""
    zeros = [not context.polynomial(name) for name in ("X1", "Y1", "X2", "Y2")]
    alone = zeros in ([True, False, False, True], [False, True, True, False])
    return alone and context.is_constant("X1", "Y1", "X2", "Y2")


def _direct(context: StepContext) -> StepText:
    s, c = sine(context.angle), cosine(context.angle)
    number = "1" if context.polynomial("X1") else "2"
    other = "2" if number == "1" else "1"
    lines = []
    for symbol, factor, value in ((s, "X" + number, "Z" + number), (c, "Y" + other, "Z" + other)):
        full = over(context.in_full(context.polynomial(value)), context.value(factor))
        lines.append(equal(symbol, full, over(context.value(value), context.value(factor))))
    solution = equal(theta(context.angle), atan2(s, c))
    return StepText((display(*lines, solution),))


def _cramer(context: StepContext) -> StepText:
    s, c = sine(context.angle), cosine(context.angle)
    first, second = add(times(X1, s), times(Y1, c)), add(times(X2, s), times(Y2, c))
    stretched = _stretched(context)
    turned, together = _turned(stretched), stretched is not None
    delta, parts = _solution(context, turned, stretched)
    blocks: list[Block] = [
        paragraph("These are {} and {} with", equal(first, Z1), equal(second, Z2)),
        display(*_definitions(context, turned)),
        paragraph(
            "The determinant is {}. By Cramer's rule, without the positive factor that sine and "
            "cosine share,",
            delta,
        ),
        display(equal(theta(context.angle), atan2(*parts))),
    ]
    if context.is_constant("X1", "Y1", "X2", "Y2"):
        return StepText(tuple(blocks))
    if (why := _never_vanishes(context, together=together)) is not None:
        size = add(square(X1), square(Y1)) if together else DELTA
        return StepText((*blocks, paragraph("{} is never zero: {}.", size, why)))
    free = _free(context, together=together)
    blocks.append(
        paragraph(
            "Degenerate when {}: {}. Then {}.",
            _vanishing(together=together),
            free.meaning,
            free.effect,
        )
    )
    return StepText(tuple(blocks), (free,))


def _solution(
    context: StepContext, turned: int, stretched: Polynomial | None
) -> tuple[Formula, tuple[Formula, Formula]]:
    """The determinant, and sine and cosine times its size."""
    delta = subtract(times(X1, Y2), times(X2, Y1))
    squares = add(square(X1), square(Y1))
    if turned:
        return equal(delta, times(_one(turned), squares)), _turned_parts(turned)
    if stretched is not None:
        sign = 1 if constant_value(context.story.algebra, stretched) > 0.0 else -1
        parts = _facing(sign, (Z1, Y2), (Z2, Y1)), _facing(sign, (X1, Z2), (X2, Z1))
        return equal(delta, times(context.in_full(stretched), squares)), parts
    facing = Call("sgn", (DELTA,))
    sine_part, cosine_part = _facing(1, (Z1, Y2), (Z2, Y1)), _facing(1, (X1, Z2), (X2, Z1))
    parts = times(facing, sine_part), times(facing, cosine_part)
    return equal(DELTA, delta, context.story.write(context.determinant, context.number)), parts


def _never_vanishes(context: StepContext, *, together: bool) -> Prose | None:
    """Why the determinant is never zero, if it is not."""
    links = _links(context)
    if links is not None and not _are_equal(*links):
        return say("the two links differ in length")
    names = [name for name in ("X1", "Y1") if context.polynomial(name)]
    if together and (fixed := [name for name in names if _is_fixed(context, name)]):
        return say("{} is fixed", type_letter(fixed[0]))
    algebra = context.story.algebra
    factors = [context.polynomial(name) for name in names] if together else [context.determinant]
    if not are_never_zero(algebra, *factors):
        return None
    return say("the numbers of this arm do not allow it")


def _is_fixed(context: StepContext, name: str) -> bool:
    return context.is_constant(name) and not context.vanishes(name)


def _free(context: StepContext, *, together: bool) -> Singularity:
    """Where the angle is free: vectors vanish together, or at least the determinant does."""
    about = context.angle.terms[0][0] if len(context.angle.terms) == 1 else None
    works = nothing_said(context)
    if context.step.degenerate:
        works = f"these equations hold for every {{}}, and {others_decide(context)}"
    meaning = say(works, theta(context.angle))
    if about is not None and together and all(o.column == 4 for o in context.step.origins):
        meaning = say(f"{{}} lies on axis {about}, and {{}}", point_name(context), meaning)
    return Singularity(
        context.number,
        equal(Z1, Z2, ZERO) if together else equal(DELTA, ZERO),
        _in_joints(context, together=together),
        say("{}{}", meaning, _only_if(context)),
        free_effect(context),
        frees=True,
    )


def _in_joints(context: StepContext, *, together: bool) -> Formula | Prose | None:
    """Where the equations lose the angle, by the joints that are known before it."""
    if together:
        return vanishing(context, context.polynomial("X1"), context.polynomial("Y1"))
    return vanishing(context, context.determinant)


def _vanishing(*, together: bool) -> Formula:
    if not together:
        return equal(DELTA, ZERO)
    return equal(add(square(X1), square(Y1)), add(square(Z1), square(Z2)), ZERO)


def _only_if(context: StepContext) -> Prose:
    """That two links must be equal, where these equations gave the angle between them."""
    if _links(context) is None:
        return say("")
    return say(" (possible only with two links of equal length, as this arm has)")


def _links(context: StepContext) -> tuple[float, float] | None:
    """How long two links are, where these equations gave the angle between them."""
    story = context.story
    return link_lengths(story.algebra, story.steps[: context.number - 1], context.step)


def _are_equal(first: float, second: float) -> bool:
    return abs(first - second) <= CLOSE * (first + second)


def _facing(sign: int, first: tuple[Formula, Formula], second: tuple[Formula, Formula]) -> Formula:
    """A determinant, or its opposite."""
    more, less = (first, second) if sign > 0 else (second, first)
    return subtract(times(*more), times(*less))


def _one(sign: int) -> Formula:
    return minus(ONE) if sign < 0 else ONE


def _turned_parts(turned: int) -> tuple[Formula, Formula]:
    if turned > 0:
        return subtract(times(X1, Z1), times(Y1, Z2)), add(times(X1, Z2), times(Y1, Z1))
    return add(times(X1, Z1), times(Y1, Z2)), subtract(times(Y1, Z1), times(X1, Z2))


def _definitions(context: StepContext, turned: int) -> list[Formula]:
    """The letters; a repeated one is given by the first."""
    lines: list[Formula] = [context.definition(name) for name in ("X1", "Y1", "Z1")]
    if turned:
        lines += [equal(X2, times(_one(-turned), Y1)), equal(Y2, times(_one(turned), X1))]
    else:
        lines += [context.definition("X2"), context.definition("Y2")]
    return [*lines, context.definition("Z2")]


def _turned(stretched: Polynomial | None) -> int:
    """+1 or -1 when the second row is the first one turned by a right angle, else 0."""
    return next((sign for sign in (1, -1) if stretched == sign), 0)


def _stretched(context: StepContext) -> Polynomial | None:
    """The constant by which the second row is longer than the first one turned, if it is."""
    factor = stretch(*(context.polynomial(name) for name in ("X1", "Y1", "X2", "Y2")))
    return factor if factor is not None and context.story.algebra.is_constant(factor) else None
