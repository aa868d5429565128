"""What the words in the names of rows stand for."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import branch_sign, unknown_symbol
from dhgen.derivation.text.blocks import Paragraph, Prose, joined, say
from dhgen.derivation.text.formula import ONE, equal, minus

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.program.ir import Axis

LOOKS = (
    " Each sign chooses one of the two values that its step finds. Which of two looks like its "
    "name depends on how the arm is built and mounted; what a row means never changes."
)


def branch_legend(story: Story) -> list[Block]:
    """The words of every choice, with its sign, its step and what the step gives."""
    if story.derivation.whole is not None or not story.has_branch_words:
        return []
    choices = [_choice(story, place, axis) for place, axis in enumerate(story.program.axes)]
    signed = any(axis.count == 2 for axis in story.program.axes)
    text = f"In these names {'; '.join('{}' for _ in choices)}.{LOOKS if signed else ''}"
    return [Paragraph(Prose(text, tuple(choices)))]


def _choice(story: Story, place: int, axis: Axis) -> Prose:
    unknowns = story.steps[axis.step - 1].unknowns
    unknown = joined([say("{}", unknown_symbol(each)) for each in unknowns])
    if axis.count != 2:
        first, last = axis.meaning[0], axis.meaning[-1]
        return say(f"{first} to {last} are the roots of step {axis.step} for {{}}", unknown)
    plus, opposite = axis.meaning
    sign = branch_sign(place)
    return say(
        f"{plus} is {{}} and {opposite} is {{}} in step {axis.step}, which gives {{}}",
        equal(sign, ONE),
        equal(sign, minus(ONE)),
        unknown,
    )
