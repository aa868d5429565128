"""Type 2: X s + Y c = Z, from the identity (X s + Y c)^2 + (Y s - X c)^2 = X^2 + Y^2."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.derivation.blocks import display, paragraph, say
from dhgen.targets.derivation.effects import free_effect, merged_effect
from dhgen.targets.derivation.formula import (
    ZERO,
    Formula,
    Listing,
    add,
    atan2,
    equal,
    minus,
    over,
    relation,
    root,
    square,
    subtract,
    times,
)
from dhgen.targets.derivation.joint_space import joint_form, meaning_of_free, meaning_of_root
from dhgen.targets.derivation.lines import width
from dhgen.targets.derivation.names import cosine, sine, theta
from dhgen.targets.derivation.step_context import Singularity, StepText, type_letter
from dhgen.targets.derivation.story import other_form, remembered_letter

if TYPE_CHECKING:
    from dhgen.targets.derivation.blocks import Block
    from dhgen.targets.derivation.step_context import StepContext

X, Y, Z = type_letter("X"), type_letter("Y"), type_letter("Z")
SHORT = 14  # visible characters of a letter's value that may stand in the solution itself


def print_angle(context: StepContext) -> StepText:
    """Z = 0, a fixed cosine or sine, or the general case."""
    if not context.polynomial("Z"):
        return _homogeneous(context)
    if not context.polynomial("X") or not context.polynomial("Y"):
        return _single(context)
    return _general(context)


def _homogeneous(context: StepContext) -> StepText:
    s, c = sine(context.angle), cosine(context.angle)
    sign = context.sign
    values = context.value("X"), context.value("Y")
    general = atan2(times(sign, Y), minus(times(sign, X)))
    short = all(width(value) <= SHORT for value in values)
    special = atan2(times(sign, values[1]), minus(times(sign, values[0]))) if short else general
    blocks: list[Block] = [
        paragraph(
            "This is {} with", equal(add(times(X, s), times(Y, c)), ZERO)
        ),
        display(context.definition("X"), context.definition("Y")),
        paragraph("The angle of a vector, or the opposite one:"),
        display(equal(theta(context.angle), general, special)),
    ]
    length = root(add(square(X), square(Y)))
    if context.is_used_later():
        blocks.append(paragraph("Later steps use the other combination of {} and {},", s, c))
        blocks.append(display(_remembered(context, times(sign, length))))
    free = _free(context)
    text = "There always is a solution. Degenerate when {}: {}. Then {}."
    blocks.append(paragraph(text, free.condition, free.meaning, free.effect))
    return StepText(tuple(blocks), (free,))


def _remembered(context: StepContext, value: Formula) -> Formula:
    """D = Y s - X c = ... = e sqrt(...)."""
    s, c = sine(context.angle), cosine(context.angle)
    form = context.story.write(other_form(context.story.algebra, context.step))
    full = subtract(times(Y, s), times(X, c))
    return equal(remembered_letter(context.step), full, form, value)


def _free(context: StepContext) -> Singularity:
    condition = Listing((equal(X, ZERO), equal(Y, ZERO)))
    values = [context.value(name) for name in "XY" if context.polynomial(name)]
    if all(width(value) <= SHORT for value in values):
        positive = [v.operand if hasattr(v, "operand") and width(v) > 1 else v for v in values]
        condition = Listing(tuple(equal(value, ZERO) for value in positive))
        condition_: Formula = condition if len(positive) > 1 else equal(positive[0], ZERO)
    else:
        condition_ = equal(X, Y, ZERO)
    joints = joint_form(context)
    return Singularity(
        context.number,
        condition_,
        None if joints is None else equal(context.story.write_forward(joints), ZERO),
        meaning_of_free(context, joints),
        free_effect(context),
    )


def _single(context: StepContext) -> StepText:
    """Y c = Z or X s = Z."""
    known, other = (cosine, sine) if not context.polynomial("X") else (sine, cosine)
    name = "Y" if not context.polynomial("X") else "X"
    sign = context.sign if name == "Y" else minus(context.sign)
    factor, z = context.value(name), context.value("Z")
    c, s = known(context.angle), other(context.angle)
    radicand = subtract(_one(), square(c))
    sine_sign = times(sign, root(radicand))
    if _is_negative(context, name):
        sine_sign = minus(sine_sign)
    solution = atan2(sine(context.angle), cosine(context.angle))
    far = relation(square(c), ">", _one())
    meets = equal(square(c), _one())
    met = Singularity(
        context.number, meets, equal(s, ZERO), meaning_of_root(context, None), merged_effect(context)
    )
    blocks = (
        display(Listing((equal(c, over(z, factor)), equal(s, sine_sign), equal(theta(context.angle), solution)))),
        paragraph(
            "No solution when {}. The two solutions meet when {}; then {}.", far, meets, met.effect
        ),
    )
    return StepText(blocks, (met,))


def _one() -> Formula:
    from dhgen.targets.derivation.formula import ONE  # noqa: PLC0415

    return ONE


def _is_negative(context: StepContext, name: str) -> bool:
    """Whether a constant factor is negative with the arm's own lengths."""
    from dhgen.targets.derivation.values import constant_value  # noqa: PLC0415

    return constant_value(context.story.algebra, context.polynomial(name)) < 0.0


def _general(context: StepContext) -> StepText:
    s, c = sine(context.angle), cosine(context.angle)
    d = remembered_letter(context.step)
    radicand = subtract(add(square(X), square(Y)), square(Z))
    blocks: list[Block] = [
        paragraph("This is {} with", equal(add(times(X, s), times(Y, c)), Z)),
        display(*(context.definition(name) for name in "XYZ")),
        paragraph(
            "The squares of {} and of {} add up to {}, so the second is known but for its sign:",
            add(times(X, s), times(Y, c)), subtract(times(Y, s), times(X, c)),
            add(square(X), square(Y)),
        ),
        display(_remembered(context, times(context.sign, root(radicand)))),
        paragraph("Both combinations together give {} and {}, each times {}:", s, c, add(square(X), square(Y))),
        display(equal(
            theta(context.angle),
            atan2(add(times(X, Z), times(Y, d)), subtract(times(Y, Z), times(X, d))),
        )),
    ]
    squares = add(square(X), square(Y))
    joints = joint_form(context)
    shown = None if joints is None else equal(context.story.write_forward(joints), ZERO)
    met = Singularity(
        context.number, equal(d, ZERO), shown, meaning_of_root(context, joints), merged_effect(context)
    )
    blocks.append(
        paragraph(
            "No solution when {}. The two solutions meet when {}: {}; then {}.",
            relation(squares, "<", square(Z)), met.condition, met.meaning, met.effect,
        )
    )
    found = [met]
    if not context.is_constant("X", "Y"):
        free = Singularity(
            context.number,
            Listing((equal(X, ZERO), equal(Y, ZERO), equal(Z, ZERO))),
            None,
            say("the equation says nothing about {}", theta(context.angle)),
            free_effect(context),
        )
        if not context.is_constant("Z"):
            blocks.append(paragraph("Degenerate when {}: {}; then {}.", equal(X, Y, Z, ZERO), free.meaning, free.effect))
            found.append(free)
    return StepText(tuple(blocks), tuple(found))
