"""The steps: heading, the elements with their equations, then what the type's printer adds."""

from __future__ import annotations

from functools import lru_cache, partial
from typing import TYPE_CHECKING

from dhgen.derivation.known_functions import implied, with_functions
from dhgen.derivation.notation.names import cosine, sine, unknown_symbol
from dhgen.derivation.quotes import where_from
from dhgen.derivation.step_context import StepContext
from dhgen.derivation.text.blocks import Paragraph, display, joined, paragraph, say
from dhgen.derivation.text.formula import Formula, Listing, equal
from dhgen.derivation.text.words import numeral
from dhgen.derivation.types import PRINTERS
from dhgen.derivation.types.angle_pair import is_direct
from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.kind import Kind

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Relation
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.form import Form


HOMOGENEOUS_IN_002 = 1  # document 002 has a type of its own for X s + Y c = 0


@lru_cache(maxsize=32)  # several sections read the steps' blocks
def step_blocks(story: Story, number: int) -> tuple[tuple[Block, ...], tuple[Singularity, ...]]:
    """One step, with the singular places it brings."""
    step = story.steps[number - 1]
    context = StepContext(story, number, step)
    blocks: list[Block]
    text = PRINTERS[step.kind](context)
    where, rewriting = where_from(story, step), _rewriting(context)
    direct = step.kind is Kind.ANGLE_PAIR and is_direct(context)
    if direct and not rewriting and all(origin.row for origin in step.origins):
        # the elements have the equations, of which these are the solved form
        where = say("{}, each with the sine or the cosine alone:", where)
        blocks = [Paragraph(where, lead=_lead(context)), *text.blocks, *implied(context)]
        return tuple(blocks), text.singularities
    intro = [paragraph("Each equation holds the sine or the cosine alone:")] if direct else []
    blocks = [
        Paragraph(say("{}:", where), lead=_lead(context)),
        display(*quoted(story, number)),
        *rewriting,
        *intro,
    ]
    blocks += [*with_functions(context, text.blocks), *implied(context)]
    return tuple(blocks), text.singularities


def leaves_a_joint_free(story: Story) -> bool:
    """Whether a step has a place where a joint takes the seed's value."""
    steps = range(1, len(story.steps) + 1)
    return any(each.frees for number in steps for each in step_blocks(story, number)[1])


def has_signed_roots(story: Story) -> bool:
    """Whether a step with a sign mentions poses for which its square root has no value."""
    signed = [n for n, step in enumerate(story.steps, start=1) if step.roots == 2]
    blocks = (block for number in signed for block in step_blocks(story, number)[0])
    return any(
        isinstance(block, Paragraph) and block.prose.text.startswith("No solution when")
        for block in blocks
    )


def _lead(context: StepContext) -> Prose:
    step = context.step
    count = numeral(step.roots)
    values = f"{'up to ' * (step.roots > 2)}{count} value{'' if step.roots == 1 else 's'}"
    names = joined([say("{}", unknown_symbol(unknown)) for unknown in step.unknowns])
    other = _document_002_number(context)
    also = f" (document 002: type {other})" if other else ""
    return say(f"{context.number}. {{}}, {values} — type {step.kind.number}{also}.", names)


def has_number_in_002(story: Story, number: int) -> bool:
    """Whether a step's equations have a number in document 002 too."""
    context = StepContext(story, number, story.steps[number - 1])
    return _document_002_number(context) is not None


def _document_002_number(context: StepContext) -> int | None:
    """The number of the step's equations in document 002, which has four types."""
    if not context.story.cites_courses:
        return None
    kind = context.step.kind
    if kind is Kind.ANGLE and not context.step.coefficient("Z"):
        return HOMOGENEOUS_IN_002
    if kind is Kind.ANGLE_PAIR and not is_direct(context):
        return None
    return kind.value.document_002


def quoted(story: Story, number: int) -> list[Relation]:
    """The equations as quoted: the joints' side first, as the documents write them."""
    lines = []
    for quote in story.quotes[number - 1]:
        left: Callable[[Polynomial], Formula] = story.write_forward
        right: Callable[[Polynomial], Formula] = partial(story.write_quoted, step=number)
        if not quote.joints_left:
            left, right = right, left
        lines.append(equal(left(quote.left), right(quote.right)))
    return lines


def _rewriting(context: StepContext) -> list[Block]:
    """Sums of angles of which a part is known, when the step writes them by what is not."""
    story = context.story
    angles = [
        angle
        for angle in story.algebra.angles
        if any(_changed(story, form, angle) for form in context.step.forms)
    ]
    lines: list[Formula] = []
    before = story.knowledge[context.number - 1]
    for angle in angles:
        c, s = before.rewritten(angle)
        lines.append(
            Listing(
                (
                    equal(cosine(angle), story.write(c)),
                    equal(sine(angle), story.write(s)),
                )
            )
        )
    if not lines:
        return []
    known = [
        say("{}", unknown_symbol(AngleSum(((joint, 1),))))
        for joint in sorted({joint for angle in angles for joint, _ in angle.terms})
        if before.knows(AngleSum(((joint, 1),)))
    ]
    text = "{} is known by now, so" if len(known) == 1 else "{} are known by now, so"
    if not known:
        return [paragraph("With what is known by now,"), display(*lines)]
    return [paragraph(text, joined(known)), display(*lines)]


def _changed(story: Story, form: Form, angle: AngleSum) -> bool:
    """Whether an angle sum of the equation is no longer in its ordered form."""
    algebra = story.algebra
    places = (algebra.index[angle.cosine], algebra.index[angle.sine])
    stands = any(monomial[place] for monomial in form.equation.difference for place in places)
    if not stands:
        return False
    kept = any(angle.cosine in key or angle.sine in key for key in form.terms)
    inside = any(m[place] for p in form.terms.values() for m in p for place in places)
    return not kept and not inside
