"""Where an equation of type 2 says nothing of its angle."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.conditions import condition_in_joints, other_combination, vanishing
from dhgen.derivation.effects import free_effect
from dhgen.derivation.joint_space import meaning_of_free
from dhgen.derivation.known_side import by_joints
from dhgen.derivation.never_zero import are_never_zero
from dhgen.derivation.notation.names import theta
from dhgen.derivation.step_context import Singularity, StepText, type_letter
from dhgen.derivation.text.blocks import paragraph, say
from dhgen.derivation.text.formula import (
    ZERO,
    Formula,
    equal,
)
from dhgen.derivation.types.second import ADDED, Second

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.story import Remembered
    from dhgen.derivation.text.blocks import Block, Prose

X, Y, Z = type_letter("X"), type_letter("Y"), type_letter("Z")


def free_without_right_side(context: StepContext, second: Second | None) -> Singularity:
    """Where X s + Y c = 0 holds for every angle."""
    names = [name for name in "XY" if context.polynomial(name)]
    condition: Formula = equal(X, Y, ZERO)
    if context.are_short(*names):
        values = [context.value(name) for name in names]
        condition = equal(*(v.operand if hasattr(v, "operand") else v for v in values), ZERO)
    joints = other_combination(context)
    stated = condition_in_joints(context, joints)
    meaning = meaning_of_free(context, joints)
    if second is not None:
        condition, stated = equal(*ADDED.values(), ZERO), second.condition(joints)
        meaning = say("neither equation says anything about {}", theta(context.angle))
    return Singularity(
        context.number,
        condition,
        stated,
        meaning,
        free_effect(context),
        frees=True,
    )


def cancelled(context: StepContext, blocks: list[Block], remembered: Remembered) -> StepText:
    """Lengths that cancel: the root is zero only where X and Y are, and with them the equation."""
    joints = other_combination(context)
    free = Singularity(
        context.number,
        equal(remembered.letter, ZERO),
        condition_in_joints(context, joints),
        meaning_of_free(context, joints),
        free_effect(context),
        frees=True,
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
