"""The sines and cosines of angles that a step has found, as later steps take them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import cosine, sine, theta
from dhgen.derivation.sections.joints import as_sum, solved_sums
from dhgen.derivation.text.blocks import Display, paragraph
from dhgen.derivation.text.formula import Call, Relation
from dhgen.kinematics.algebra import POSE_PLACES, SHOULDER_NAMES, AngleSum
from dhgen.kinematics.ring import substitute, used_places
from dhgen.kinematics.transform import compose, translation

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.step import Step


TAKEN = (
    "From here on {} and {} are the two arguments, divided by the square root of the sum of their "
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
    """Whether a later step holds cosine or sine, or a sum's that the angle is part of."""
    story = context.story
    algebra = story.algebra
    later = story.steps[context.number :]
    own = {unknown for step in story.steps for unknown in step.unknowns} - {angle}
    joints = {joint for joint, _ in angle.terms}
    parts = [a for a in algebra.angles if joints <= {j for j, _ in a.terms} and a not in own]
    places = {algebra.index[name] for part in parts for name in (part.cosine, part.sine)}
    return any(places & places_of(step) for step in later)


def by_joints(story: Story, polynomial: Polynomial) -> Polynomial | None:
    """A polynomial in joints alone; None where it holds what the arm angle gives."""
    algebra = story.algebra
    used = used_places(polynomial)
    shoulder = [name for names in SHOULDER_NAMES for name in names]
    if algebra.chain.arm_angle and used & {algebra.index[name] for name in shoulder}:
        return None
    values = pose_by_joints(story, {algebra.ring.symbols[place].name for place in used})
    change = {algebra.index[name]: value for name, value in values.items()}
    return algebra.normal(substitute(polynomial, change)) if change else polynomial


def pose_by_joints(story: Story, used: set[str]) -> dict[str, Polynomial]:
    """The pose entries and the coordinates of named points by joints, as far as they are used."""
    algebra, problem = story.algebra, story.derivation.problem
    whole = 0, len(problem.links)
    forward = problem.spans.product(*whole)
    values = {name: forward.entry(*place) for name, place in POSE_PLACES.items() if name in used}
    pool = story.derivation.pool
    seen = [(p.names, p.in_tool, forward) for p in pool.points if used & {*p.names}]
    back = problem.spans.inverse(*whole)
    seen += [(p.names, p.in_base, back) for p in pool.base_points if used & {*p.names}]
    for names, coordinates, transform in seen:
        point = compose(transform, translation(algebra.ring, coordinates), algebra.normal)
        values |= {
            name: at for name, at in zip(names, point.translation, strict=True) if name in used
        }
    return values
