"""The sines and cosines of angles that a step has found, as later steps take them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import cosine, sine, theta
from dhgen.derivation.sections.joints import as_sum, solved_sums
from dhgen.derivation.text.blocks import Display, paragraph
from dhgen.derivation.text.formula import Call, Relation
from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.ring import used_places

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.text.blocks import Block
    from dhgen.paul.step import Step

TAKEN = (
    "Later steps use {} and {}: the two arguments, divided by the square root of the sum of their "
    "squares."
)


def with_functions(context: StepContext, blocks: Iterable[Block]) -> list[Block]:
    """The blocks of a step; behind the arctangent what its sine and cosine are, if needed."""
    every = list(blocks)
    angles = [u for u in context.step.unknowns if isinstance(u, AngleSum)]
    for angle in angles:
        defined = {first for block in every for first in _first_sides(block)}
        place = next((n for n, block in enumerate(every) if _gives(block, angle)), None)
        if place is None or {sine(angle), cosine(angle)} & defined or not _used(context, angle):
            continue
        every.insert(place + 1, paragraph(TAKEN, sine(angle), cosine(angle)))
    return every


def implied(context: StepContext) -> list[Block]:
    """Joints' angles that follow from a step's by addition, where later steps need them."""
    story = context.story
    before, now = story.knowledge[context.number - 1 : context.number + 1]
    solved = solved_sums(story, context.number)
    later = set().union(*(places_of(step) for step in story.steps[context.number :]))
    blocks: list[Block] = []
    for angle in story.algebra.angles:
        places = {story.algebra.index[name] for name in (angle.cosine, angle.sine)}
        if len(angle.terms) > 1 or angle in solved or not places & later:
            continue
        if now.knows(angle) and not before.knows(angle):
            found = theta(context.step.angle)
            blocks.append(
                paragraph("With {}, {} is known, too.", found, as_sum(story, angle, solved))
            )
    return blocks


def places_of(step: Step) -> set[int]:
    """The generators that a step's coefficients hold."""
    return set().union(*(used_places(form) for _, form in step.coefficients))


def _first_sides(block: Block) -> Iterable[object]:
    if isinstance(block, Display):
        yield from (f.sides[0] for f in block.formulas if isinstance(f, Relation))


def _gives(block: Block, angle: AngleSum) -> bool:
    """Whether the angle is an arctangent here."""
    return isinstance(block, Display) and any(
        isinstance(formula, Relation)
        and formula.sides[0] == theta(angle)
        and isinstance(formula.sides[1], Call)
        for formula in block.formulas
    )


def _used(context: StepContext, angle: AngleSum) -> bool:
    """Whether a later step holds them, or those of a sum that the angle is part of."""
    story = context.story
    algebra = story.algebra
    later = story.steps[context.number :]
    own = {unknown for step in story.steps for unknown in step.unknowns} - {angle}
    joints = {joint for joint, _ in angle.terms}
    parts = [a for a in algebra.angles if joints <= {j for j, _ in a.terms} and a not in own]
    places = {algebra.index[name] for part in parts for name in (part.cosine, part.sine)}
    return any(places & places_of(step) for step in later)
