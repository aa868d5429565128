"""Types 1, 10 and 11: a length by itself, by its square, and two lengths by two equations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.conditions import vanishing
from dhgen.derivation.effects import free_effect, is_left_to_the_pose, merged_effect, others_decide
from dhgen.derivation.notation.names import letter, unknown_symbol
from dhgen.derivation.step_context import Singularity, StepText, type_letter
from dhgen.derivation.text.blocks import display, paragraph, say
from dhgen.derivation.text.formula import (
    ONE,
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
from dhgen.paul.types.lengths import line_of

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula


X, Y = type_letter("X"), type_letter("Y")


def print_length(context: StepContext) -> StepText:
    """r = Y / X."""
    r = context.unknown
    one = len(context.step.forms) == 1
    if one and context.is_number("X"):
        (quote,) = context.quotes
        x = context.value("X")
        full = over(context.in_full(context.polynomial("Y")), x)
        solved = equal(r, full, over(context.value("Y"), x))
        quoted = equal(*(context.in_full(s) for s in (quote.left, quote.right)))
        if solved == quoted:
            return StepText((paragraph("Here the unknown already stands alone."),))
        return StepText((display(solved),))
    left = times(X, r)
    given = [paragraph("This is {} with", equal(left, Y))] if one else put_in(context, left, Y)
    blocks: list[Block] = [
        *given,
        display(context.definition("X"), context.definition("Y")),
        display(equal(r, over(Y, X))),
    ]
    if context.is_constant("X"):
        return StepText(tuple(blocks))
    none = equal(Y, ZERO)
    meaning = say("every {} works if {}, and none otherwise", r, none)
    if is_left_to_the_pose(context):
        sentence = f"this equation holds for every {{}} if {{}}, and {others_decide(context)}"
        meaning = say(f"{sentence}; otherwise none works", r, none)
    free = Singularity(
        context.number, equal(X, ZERO), None, meaning, free_effect(context), frees=True
    )
    text = "Degenerate when {}: {}. If it works, {}."
    blocks.append(paragraph(text, equal(X, ZERO), meaning, free.effect))
    return StepText(tuple(blocks), (free,))


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
        _where_roots_meet(context),
        say(NEAREST if one else TOUCHING),
        merged_effect(context),
    )
    left = add(times(X, square(r)), times(Y, r))
    sentence = "The squared length of a vector is {}, a quadratic equation, with"
    given = [paragraph(sentence, equal(left, Z))] if one else put_in(context, left, Z)
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


def _where_roots_meet(context: StepContext) -> Formula | Prose | None:
    """2 X r + Y = 0 by joints."""
    r = context.story.algebra.generator(context.step.length.name)
    return vanishing(context, 2 * context.polynomial("X") * r + context.polynomial("Y"))


X1, Y1, Z1, X2, Y2, Z2 = (type_letter(name) for name in ("X1", "Y1", "Z1", "X2", "Y2", "Z2"))
DELTA = letter(r"\Delta", "Δ")


def print_two_lengths(context: StepContext) -> StepText:
    """Cramer's rule."""
    first, second = (unknown_symbol(unknown) for unknown in context.step.unknowns)
    determinant, delta = context.determinant, subtract(times(X1, Y2), times(X2, Y1))
    blocks: list[Block] = [
        paragraph(
            "These are {} and {} with",
            equal(add(times(X1, first), times(Y1, second)), Z1),
            equal(add(times(X2, first), times(Y2, second)), Z2),
        ),
        display(*map(context.definition, ("X1", "Y1", "Z1", "X2", "Y2", "Z2"))),
        paragraph("By Cramer's rule, with the determinant {},", DELTA),
        display(
            equal(DELTA, delta, context.story.write(determinant, context.number)),
            equal(first, over(subtract(times(Z1, Y2), times(Z2, Y1)), DELTA)),
            equal(second, over(subtract(times(X1, Z2), times(X2, Z1)), DELTA)),
        ),
    ]
    if context.story.algebra.is_constant(determinant):
        return StepText(tuple(blocks))
    meaning = say(
        "the slides move the tool in fewer directions than there are slides; all {} and {} on a "
        "line work if both equations name the same line, and none otherwise",
        first,
        second,
    )
    free = Singularity(
        context.number, equal(DELTA, ZERO), None, meaning, free_effect(context), frees=True
    )
    text = "Degenerate when {}: {}. If they do, {}."
    blocks.append(paragraph(text, equal(DELTA, ZERO), meaning, free.effect))
    return StepText(tuple(blocks), (free,))


def put_in(context: StepContext, left: Formula, right: Formula) -> list[Block]:
    """What the line gives, and the equation that the other becomes with it, up to a factor."""
    write, r = context.story.write, context.unknown
    length, (v, w, z) = line_of(context.step)
    gone, factor = unknown_symbol(length), write(v**2)
    if v.is_ground:
        v, w, z = v / v, w / v, z / v
    blocks: list[Block] = [
        paragraph("The first equation is linear in {} and {}, and gives", gone, r),
        display(equal(gone, over(subtract(write(z), times(write(w), r)), write(v)))),
    ]
    sentence = "With it the other holds {} alone. "
    if factor == ONE:
        return [*blocks, paragraph(sentence + "It is {} with", r, equal(left, right))]
    return [*blocks, paragraph(sentence + "Times {} it is {} with", r, factor, equal(left, right))]
