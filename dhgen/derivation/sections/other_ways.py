"""What else a step could have been, and why it is not: one line, in a teacher's words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import element_of
from dhgen.derivation.notation.names import unknown_symbol
from dhgen.derivation.quotes import quotes_of
from dhgen.derivation.text.blocks import joined, paragraph, say
from dhgen.derivation.text.formula import equal
from dhgen.derivation.text.lines import width
from dhgen.derivation.text.words import counted, numeral
from dhgen.paul.kind import Kind

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Relation
    from dhgen.paul.step import Step

SHORT = 40  # visible characters of an equation that may be in a line of text


def other_step(story: Story, number: int) -> Step | None:
    """The best step that could replace one; None where only steps that follow could.

    Another equation for the same unknown comes before those for others.

    Args:
        story: The arm and its derivation.
        number: The step, from 1.
    """
    others = list(_others(story, number))
    unknowns = story.steps[number - 1].unknowns
    same = [other for other in others if other.unknowns == unknowns]
    return (same or others)[0] if others else None


def other_way(story: Story, number: int) -> list[Block]:
    """That step, and why it is not taken; nothing where there is none."""
    step, other = story.steps[number - 1], other_step(story, number)
    if other is None:
        return []
    unknowns = joined([say("{}", unknown_symbol(unknown)) for unknown in other.unknowns])
    elements = joined([say("{}", element_of(origin)) for origin in other.origins])
    chosen = number <= len(story.robot.steps)
    why = "but the robot file chooses this step" if chosen else _difference(step, other)
    same = other.unknowns == step.unknowns
    place = "Also possible" if same else "Also possible instead of this step"
    text = f"{place}: {{}} from {{}}, type {other.kind.number}, {why}"
    equations = _short_equations(story, number, other) if same else []
    if not equations:
        return [paragraph(f"{text}.", unknowns, elements)]
    return [paragraph(f"{text}: {{}} and {{}}.", unknowns, elements, *equations)]


def _short_equations(story: Story, number: int, other: Step) -> list[Relation]:
    """The equations of type 6 that a step could take, as courses do, where they are short."""
    if other.kind is not Kind.TWO_ANGLES:
        return []
    shown = [
        equal(story.write_forward(quote.left), story.write_quoted(quote.right, number))
        for quote in quotes_of(story.derivation, other)
    ]
    return shown if all(width(each) <= SHORT for each in shown) else []


def _others(story: Story, number: int) -> Iterator[Step]:
    """The offers that no step of the derivation takes, cheapest first."""
    taken = [_what(step) for step in story.steps]
    for offer in story.derivation.offers[number - 1]:
        if _what(offer) not in taken:
            yield offer


def _what(step: Step) -> object:
    return step.kind, step.unknowns, frozenset(step.origins)


def _difference(step: Step, other: Step) -> str:
    """The drawback of the other one, of what the search weighs: values, then the equations."""
    if other.roots > step.roots:
        return f"with {counted(other.roots, 'value')} instead of {numeral(step.roots)}"
    if (other.unknowns, other.roots) == (step.unknowns, step.roots) and (
        other.penalty > step.penalty
    ):
        return "which is longer or worse conditioned"
    return (
        "but a whole solution that begins so is rated no better (degenerate cases, values, length)"
    )
