"""Type 2: X s + Y c = Z, from the identity (X s + Y c)^2 + (Y s - X c)^2 = X^2 + Y^2."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.conditions import (
    NEVER,
    are_never_zero,
    condition_in_joints,
    other_combination,
    vanishing,
)
from dhgen.derivation.effects import (
    free_effect,
    meaning_of_free,
    meaning_of_root,
    merged_effect,
    sum_of_free,
)
from dhgen.derivation.known_functions import by_joints
from dhgen.derivation.notation.names import cosine, sine, theta
from dhgen.derivation.step_context import Singularity, StepText, type_letter
from dhgen.derivation.sums_left import read_off
from dhgen.derivation.text.blocks import Paragraph, display, paragraph, say, sentences
from dhgen.derivation.text.formula import (
    ZERO,
    Formula,
    Listing,
    add,
    atan2,
    equal,
    minus,
    relation,
    root,
    square,
    subtract,
    times,
)
from dhgen.derivation.types.fallback_equation import ADDED, Fallback
from dhgen.derivation.types.two_angles import by_one_function

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.story import Remembered
    from dhgen.derivation.text.blocks import Block, Prose


X, Y, Z = type_letter("X"), type_letter("Y"), type_letter("Z")
SQUARES = add(square(X), square(Y))


def print_angle(context: StepContext) -> StepText:
    """Z = 0, a fixed cosine or sine, or the general case."""
    if not context.polynomial("Z"):
        return _homogeneous(context)
    for absent, factor in (("X", "Y"), ("Y", "X")):
        if not context.polynomial(absent) and context.is_constant(factor):
            return _single(context)
    return _general(context)


def _letters(context: StepContext, right: Formula, *names: str) -> list[Block]:
    """This is X s + Y c = Z with ..."""
    functions = {"X": sine(context.angle), "Y": cosine(context.angle)}
    parts = [times(type_letter(name), functions[name]) for name in names if name in functions]
    read = equal(add(*parts), right)
    this_is = "This is" if context.quotes[0].facing > 0 else "This is, with the opposite sign,"
    if context.are_short(*names):
        listed = Listing(tuple(context.definition(name) for name in names))
        return [paragraph(f"{this_is} {{}} with {{}}.", read, listed)]
    return [
        paragraph(f"{this_is} {{}} with", read),
        display(*(context.definition(name) for name in names)),
    ]


def _homogeneous(context: StepContext) -> StepText:
    sign = context.sign
    second = Fallback.of(context)
    general = atan2(times(sign, Y), minus(times(sign, X)))
    special = general
    if context.are_short("X", "Y"):
        x, y = context.value("X"), context.value("Y")
        special = atan2(times(sign, y), minus(times(sign, x)))
    blocks = [
        *_letters(context, ZERO, "X", "Y"),
        paragraph(
            "{} and {} are proportional to {} and {}, with either sign:",
            sine(context.angle),
            cosine(context.angle),
            Y,
            minus(X),
        ),
        display(equal(theta(context.angle), general, special)),
        *([] if second is None else second.blocks(sign)),
    ]
    remembered = context.remembered
    if remembered is not None:
        s, c = sine(context.angle), cosine(context.angle)
        blocks.append(paragraph("Later steps use the other combination of {} and {},", s, c))
        blocks.append(display(_combination(context, remembered, root(SQUARES))))
    if second is None and are_never_zero(
        context.story.algebra, *(context.polynomial(name) for name in "XY")
    ):
        return StepText((*blocks, paragraph("There is always a solution.")))
    free = free_without_right_side(context, second)
    text = "There is always a solution. Degenerate when {}: {}. Then {}."
    told = [say(text, free.condition, free.meaning, free.effect)]
    if free.left is not None:
        told += filter(None, [read_off(context.story, context.number, free.left)])
    return StepText((*blocks, Paragraph(sentences(told))), (free,))


def _combination(context: StepContext, remembered: Remembered, size: Formula) -> Formula:
    """D = Y s - X c = ... = e sqrt(...)."""
    s, c = sine(context.angle), cosine(context.angle)
    written = context.in_full(remembered.form)
    return equal(
        remembered.letter, subtract(times(Y, s), times(X, c)), written, times(context.sign, size)
    )


def _single(context: StepContext) -> StepText:
    """Y c = Z or X s = Z: the cosine or the sine is known, the other up to its sign."""
    by_cosine = not context.polynomial("X")
    name, other = ("Y", sine) if by_cosine else ("X", cosine)
    letter = type_letter(name)
    meets = equal(square(Z), square(letter))
    met = Singularity(
        context.number,
        meets,
        equal(other(context.angle), ZERO),
        meaning_of_root(context),
        merged_effect(context),
    )
    blocks = (
        *_letters(context, Z, name, "Z"),
        display(*by_one_function(context, letter, Z, by_cosine=by_cosine)),
        paragraph(
            "No solution when {}. The two solutions meet when {}: {}. Then {}.",
            relation(square(Z), ">", square(letter)),
            meets,
            met.meaning,
            met.effect,
        ),
    )
    return StepText(blocks, (met,))


def _general(context: StepContext) -> StepText:
    s, c = sine(context.angle), cosine(context.angle)
    remembered = context.story.combination(context.number)
    radicand = root(subtract(SQUARES, square(Z)))
    d = remembered.letter
    blocks: list[Block] = [
        *_letters(context, Z, "X", "Y", "Z"),
        paragraph(
            "The squares of {} and {} add up to {}, so the second is known up to its sign,",
            add(times(X, s), times(Y, c)),
            subtract(times(Y, s), times(X, c)),
            SQUARES,
        ),
        display(_combination(context, remembered, radicand)),
        paragraph(
            "and both together give {} and {}, each times {}, which does not change the angle:",
            s,
            c,
            SQUARES,
        ),
        display(
            equal(
                theta(context.angle),
                atan2(add(times(X, Z), times(Y, d)), subtract(times(Y, Z), times(X, d))),
            )
        ),
    ]
    if context.vanishes("Z") and not context.is_constant("X", "Y"):
        return cancelled(context, blocks, remembered)
    free = free_with_right_side(context)
    meaning = meaning_of_root(context)
    if free is not None and free.joints != NEVER:
        meaning = say("{}, unless {}", meaning, free.condition)
    met = Singularity(
        context.number,
        equal(remembered.letter, ZERO),
        condition_in_joints(context, other_combination(context)),
        meaning,
        merged_effect(context),
    )
    text = "No solution when {}. The two solutions meet when {}: {}. Then {}."
    far = relation(SQUARES, "<", square(Z))
    blocks.append(paragraph(text, far, met.condition, met.meaning, met.effect))
    if free is None:
        return StepText(tuple(blocks), (met,))
    text = "Degenerate when {}: {}. Then {}."
    blocks.append(paragraph(text, free.condition, free.meaning, free.effect))
    return StepText(tuple(blocks), (met, free))


X, Y, Z = type_letter("X"), type_letter("Y"), type_letter("Z")


def free_without_right_side(context: StepContext, second: Fallback | None) -> Singularity:
    """Where X s + Y c = 0 holds for every angle."""
    names = [name for name in "XY" if context.polynomial(name)]
    condition: Formula = equal(X, Y, ZERO)
    if context.are_short(*names):
        values = [context.value(name) for name in names]
        condition = equal(*(v.operand if hasattr(v, "operand") else v for v in values), ZERO)
    joints = other_combination(context)
    stated = condition_in_joints(context, joints)
    left = sum_of_free(context, joints)
    meaning = meaning_of_free(context, left)
    if second is not None:
        left = None
        condition, stated = equal(*ADDED.values(), ZERO), second.condition(joints)
        meaning = say("neither equation says anything about {}", theta(context.angle))
    return Singularity(
        context.number,
        condition,
        stated,
        meaning,
        free_effect(context),
        frees=True,
        left=left,
    )


def cancelled(context: StepContext, blocks: list[Block], remembered: Remembered) -> StepText:
    """Lengths that cancel: the root is zero only where X and Y are, and with them the equation."""
    joints = other_combination(context)
    left = sum_of_free(context, joints)
    free = Singularity(
        context.number,
        equal(remembered.letter, ZERO),
        condition_in_joints(context, joints),
        meaning_of_free(context, left),
        free_effect(context),
        frees=True,
        left=left,
    )
    text = (
        "With the numbers of this arm {}, so there is always a solution, and {} only when {}. "
        "Degenerate when {}: {}. Then {}."
    )
    none, vanishing = equal(Z, ZERO), equal(X, Y, ZERO)
    shown = none, free.condition, vanishing, free.condition, free.meaning, free.effect
    return StepText((*blocks, paragraph(text, *shown)), (free,))


def free_with_right_side(context: StepContext) -> Singularity | None:
    """Where X, Y and Z vanish together, if they may."""
    factors = [context.polynomial(name) for name in "XYZ"]
    if are_never_zero(context.story.algebra, *factors):
        return None
    return Singularity(
        context.number,
        equal(X, Y, Z, ZERO),
        _nothing_said(context),
        say("the equation says nothing about {}", theta(context.angle)),
        free_effect(context),
        frees=True,
    )


def _nothing_said(context: StepContext) -> Formula | Prose | None:
    """X = Y = Z = 0 by joints: X and Y themselves, or else Z and the other combination.

    The squares of those add up to X^2 + Y^2.
    """
    story = context.story
    x, y = context.polynomial("X"), context.polynomial("Y")
    if by_joints(story, x) == x and by_joints(story, y) == y:
        return vanishing(context, x, y)
    other = other_combination(context) or story.combination(context.number).form
    return vanishing(context, context.polynomial("Z"), other)
