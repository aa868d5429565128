"""What the types of a derivation's steps are: their equations in general, by their numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.steps import has_number_in_002, step_blocks
from dhgen.derivation.text.blocks import Table, joined, paragraph, say
from dhgen.derivation.text.formula import Listing, Symbol
from dhgen.derivation.text.walk import symbols_of
from dhgen.kinematics.transform import identity
from dhgen.paul.kind import Kind

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose

CAPITALS = frozenset("KPQRVWXYZ")  # those of matrices and of signed roots are others
FRAME_APART = "; the base frame, {} too, is a matrix"
_SPELLED = (
    ("\\theta", "θ"),
    ("\\", ""),
    ("-", "−"),
    ("^2", "²"),
    ("_1", "₁"),
    ("_2", "₂"),
    ("_i", "ᵢ"),
    ("_j", "ⱼ"),
)


def types_table(story: Story) -> list[Block]:
    """A line for every type that a step is of."""
    kinds = sorted({step.kind for step in story.steps}, key=lambda kind: kind.number)
    header = tuple(say(word) for word in ("type", "equations", "steps"))
    rows = tuple(_row(story, kind) for kind in kinds)
    new = [f"type {kind.number}" for kind in kinds if not kind.value.in_003]
    beyond = f"; {' and '.join(new)} {'is' if len(new) == 1 else 'are'} not in it" if new else ""
    has_length = any("r" in each for kind in kinds for each in kind.value.equations)
    slides = [Symbol("r", "r")] if has_length else []
    length = "{} is an unknown length, " if slides else ""
    text = (
        "The types that occur here, numbered as in document 003, which has the table of W. Khalil "
        f"and E. Dombre (2002{beyond}): {length}{{}} and {{}} are the cosine "
        "and sine of an unknown angle, and capitals are known."
    )
    turned = [str(k.number) for k in kinds if k in {Kind.TWO_ANGLES, Kind.TWO_ANGLES_TURNED}]
    if turned:
        text += f" An angle of type {' or '.join(turned)} may be one that is counted backwards."
    own = sorted({each.text[0] for each in symbols_of(_steps(story))} & CAPITALS)
    chain = story.algebra.chain
    frame = "Z" in own and chain.base != identity(chain.ring)
    if own:
        text += f" Each step defines {{}} anew{FRAME_APART if frame else ''}."
    if any(has_number_in_002(story, number) for number in range(1, len(story.steps) + 1)):
        text += " Document 002 counts four types in its own way; its number stands in parentheses."
    letters = *slides, Symbol("c_i", "cᵢ"), Symbol("s_i", "sᵢ")
    capitals = [joined([say("{}", Symbol(each, each)) for each in own])] if own else []
    apart = [Symbol("Z", "Z")] if frame else []
    return [paragraph(text, *letters, *capitals, *apart), Table(header, rows)]


def _steps(story: Story) -> list[Block]:
    numbers = range(1, len(story.steps) + 1)
    return [block for number in numbers for block in step_blocks(story, number)[0]]


def _row(story: Story, kind: Kind) -> tuple[Prose, ...]:
    steps = [str(n) for n, step in enumerate(story.steps, start=1) if step.kind is kind]
    return (
        say(str(kind.number)),
        say("{}", Listing(tuple(map(_spelled, kind.value.equations)))),
        say(", ".join(steps)),
    )


def _spelled(equation: str) -> Symbol:
    """An equation's LaTeX, and how a terminal spells it."""
    text = equation
    for latex, plain in _SPELLED:
        text = text.replace(latex, plain)
    return Symbol(equation, text)
