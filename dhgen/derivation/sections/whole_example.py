"""A pose of an arm that is solved as a whole: its polynomial, its roots, a row from its root."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.notation.names import letter
from dhgen.derivation.sections.example import all_rows, laid_out, pose_blocks
from dhgen.derivation.sections.general import joint_symbol as loop_symbol
from dhgen.derivation.sections.roots import GREEK, alternatives
from dhgen.derivation.text.blocks import Display, Heading, joined, paragraph, say
from dhgen.derivation.text.formula import Symbol, equal
from dhgen.derivation.values import degrees, figures
from dhgen.derivation.whole_example import HARMONICS, find_whole_example, hidden_joint
from dhgen.program.interpret import wrap

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Relation
    from dhgen.derivation.whole_example import WholeExample
    from dhgen.general.kernel import GeneralKernel

PHI = Symbol(r"\varphi", "φ")
FIFTH = 5  # decimals of coefficients, the largest being one


def whole_example_section(story: Story, kernel: GeneralKernel) -> list[Block]:
    """The example; nothing where no pose that was tried has simple roots only."""
    example = find_whole_example(story, kernel)
    if example is None:
        return []
    roots = [degrees(float(root)) for root in example.roots]
    angle = loop_symbol(kernel, hidden_joint(kernel)) if kernel.wrist is not None else PHI
    listed = list(_coefficients(example))
    unlisted = "and those that are not listed are zero to five decimals"
    if len(listed) == len(example.coefficients):
        unlisted = "to five decimals"
    return [
        Heading(2, say("An example")),
        *pose_blocks(story, example),
        paragraph(
            "The coefficients of the polynomial in {}, all divided by the largest, are", angle
        ),
        Display(tuple(laid_out(listed))),
        paragraph(
            f"{unlisted}. Its real roots are {{}}.",
            alternatives(angle, roots),
        ),
        paragraph(
            f"Row {example.followed}{_posture(story, example.followed)} comes from {{}}{{}}",
            equal(angle, roots[example.taken]),
            _followed(kernel, example),
        ),
        *all_rows(story, example),
    ]


def _posture(story: Story, row: int) -> str:
    """The name of a row, where rows have some."""
    return f", {story.branch_names[row]}," if story.has_named_rows else ""


def _coefficients(example: WholeExample) -> Iterable[Relation]:
    """lambda_0, lambda_1, mu_1 and so on, without negligible ones."""
    even, uneven = example.coefficients[: HARMONICS + 1], example.coefficients[HARMONICS + 1 :]
    for m in range(HARMONICS + 1):
        values = [even[m], *([uneven[m - 1]] if m else [])]
        for greek, value in zip(GREEK, values, strict=False):
            decimals = round(float(value), FIFTH)
            if decimals:
                yield equal(letter(*greek, str(m)), figures(decimals))


def _followed(kernel: GeneralKernel, example: WholeExample) -> Prose:
    """What the root gives, in the order of the steps."""

    def values(*places: int) -> Prose:
        return joined([say("{}", _value(kernel, example, place)) for place in places])

    _, one, two, idle, fifth, sixth = kernel.first.joints
    hidden = hidden_joint(kernel)
    named = say(", which stands for {}" if kernel.hides_a_slide else ", that is {}", values(hidden))
    if kernel.wrist is not None:
        named = say("")
    if kernel.wrist is not None or not kernel.eliminations:
        others = values(*(place for place in range(6) if place != hidden))
        return say("{}. With it {}.", named, others)
    return say(
        "{}. The null vector of the matrix gives {}, the linear system {}, and what is left of the "
        "loop {}.",
        named,
        values(one, two),
        values(fifth, sixth),
        values(idle),
    )


def _value(kernel: GeneralKernel, example: WholeExample, place: int) -> Relation:
    """The angle or length of a joint of the loop."""
    value = float(example.loop[place])
    if place in kernel.loop.slides:
        return equal(loop_symbol(kernel, place), figures(value, kernel.loop.size))
    return equal(loop_symbol(kernel, place), degrees(float(wrap(np.array(value)))))
