"""What the types of a derivation's steps are: their equations in general, by their numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.steps import has_number_in_002, step_blocks
from dhgen.derivation.text.blocks import Table, joined, paragraph, say
from dhgen.derivation.text.formula import Listing, Symbol
from dhgen.derivation.text.walk import symbols_of
from dhgen.kinematics.transform import identity
from dhgen.paul.step import Kind

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose

_FORMS = {
    Kind.LENGTH: (Symbol("X r = Y", "X r = Y"),),
    Kind.ANGLE: (Symbol("X s_i + Y c_i = Z", "X sᵢ + Y cᵢ = Z"),),
    Kind.ANGLE_PAIR: (
        Symbol("X_1 s_i + Y_1 c_i = Z_1", "X₁ sᵢ + Y₁ cᵢ = Z₁"),
        Symbol("X_2 s_i + Y_2 c_i = Z_2", "X₂ sᵢ + Y₂ cᵢ = Z₂"),
    ),
    Kind.POLAR: (
        Symbol("X_1 r s_i = Y_1", "X₁ r sᵢ = Y₁"),
        Symbol("X_2 r c_i = Y_2", "X₂ r cᵢ = Y₂"),
    ),
    Kind.ANGLE_AND_LENGTH: (
        Symbol("X_1 s_i = Y_1 + Z_1 r", "X₁ sᵢ = Y₁ + Z₁ r"),
        Symbol("X_2 c_i = Y_2 + Z_2 r", "X₂ cᵢ = Y₂ + Z₂ r"),
    ),
    Kind.TWO_ANGLES: (
        Symbol("W s_j = X c_i + Y s_i + Z_1", "W sⱼ = X cᵢ + Y sᵢ + Z₁"),
        Symbol("W c_j = X s_i - Y c_i + Z_2", "W cⱼ = X sᵢ − Y cᵢ + Z₂"),
    ),
    Kind.TWO_ANGLES_TURNED: (
        Symbol("W_1 c_j + W_2 s_j = X c_i + Y s_i + Z_1", "W₁ cⱼ + W₂ sⱼ = X cᵢ + Y sᵢ + Z₁"),
        Symbol("W_1 s_j - W_2 c_j = X s_i - Y c_i + Z_2", "W₁ sⱼ − W₂ cⱼ = X sᵢ − Y cᵢ + Z₂"),
    ),
    Kind.ANGLE_AND_SUM: (
        Symbol(r"X c_i + Y \cos(\theta_i + \theta_j) = Z_1", "X cᵢ + Y cos(θᵢ + θⱼ) = Z₁"),
        Symbol(r"X s_i + Y \sin(\theta_i + \theta_j) = Z_2", "X sᵢ + Y sin(θᵢ + θⱼ) = Z₂"),
    ),
    Kind.CIRCLE: (
        Symbol("X_1 s_i + Y_1 c_i + V_1 s_j + W_1 c_j = Z_1", "X₁ sᵢ + Y₁ cᵢ + V₁ sⱼ + W₁ cⱼ = Z₁"),
        Symbol("X_2 s_i + Y_2 c_i + V_2 s_j + W_2 c_j = Z_2", "X₂ sᵢ + Y₂ cᵢ + V₂ sⱼ + W₂ cⱼ = Z₂"),
    ),
    Kind.SQUARED_LENGTH: (Symbol("X r^2 + Y r = Z", "X r² + Y r = Z"),),
    Kind.TWO_LENGTHS: (
        Symbol("X_1 r_i + Y_1 r_j = Z_1", "X₁ rᵢ + Y₁ rⱼ = Z₁"),
        Symbol("X_2 r_i + Y_2 r_j = Z_2", "X₂ rᵢ + Y₂ rⱼ = Z₂"),
    ),
}

CAPITALS = frozenset("KPQRVWXYZ")  # those of matrices and of signed roots are others
FRAME_APART = "; the base frame, {} too, is a matrix"
_BEYOND = {Kind.CIRCLE, Kind.SQUARED_LENGTH, Kind.TWO_LENGTHS}


def types_table(story: Story) -> list[Block]:
    """A line for every type that a step is of."""
    kinds = sorted({step.kind for step in story.steps}, key=lambda kind: kind.value)
    header = tuple(say(word) for word in ("type", "equations", "steps"))
    rows = tuple(_row(story, kind) for kind in kinds)
    new = [f"type {kind.value}" for kind in kinds if kind in _BEYOND]
    beyond = f"; {' and '.join(new)} {'is' if len(new) == 1 else 'are'} not in it" if new else ""
    has_length = any("r" in form.text for kind in kinds for form in _FORMS[kind])
    slides = [Symbol("r", "r")] if has_length else []
    length = "{} is an unknown length, " if slides else ""
    text = (
        "The types that occur here, numbered as in document 003, which has the table of W. Khalil "
        f"and E. Dombre (2002{beyond}): {length}{{}} and {{}} are the cosine "
        "and sine of an unknown angle, and capitals are known."
    )
    turned = [str(k.value) for k in kinds if k in {Kind.TWO_ANGLES, Kind.TWO_ANGLES_TURNED}]
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
    return say(str(kind.value)), say("{}", Listing(_FORMS[kind])), say(", ".join(steps))
