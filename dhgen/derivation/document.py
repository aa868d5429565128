"""The order of a derivation's sections."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.sections.arm_angle_row import arm_angle_places
from dhgen.derivation.sections.closing import (
    cost_section,
    singular_section,
    solutions_section,
)
from dhgen.derivation.sections.documents import cited_documents
from dhgen.derivation.sections.forward import forward_in_short, forward_section
from dhgen.derivation.sections.general import general_section
from dhgen.derivation.sections.inverse import inverse_beginning
from dhgen.derivation.sections.joints import joint_values
from dhgen.derivation.sections.numerical import numerical_section
from dhgen.derivation.sections.robot import opening, robot_section
from dhgen.derivation.steps import step_blocks
from dhgen.derivation.text.walk import symbols_of
from dhgen.general.kernel import GeneralKernel

if TYPE_CHECKING:
    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block


def document_blocks(story: Story) -> list[Block]:
    """The whole derivation."""
    beginning, model = opening(story), _sections(story)
    rest = [*robot_section(story, symbols_of(model)), *model]
    return [*beginning, *cited_documents([*beginning, *rest]), *rest]


def _sections(story: Story) -> list[Block]:
    """What follows the robot."""
    whole = story.derivation.whole
    if whole is not None:
        if isinstance(whole, GeneralKernel):
            inverse = general_section(whole, story.algebra.chain, story.robot.length_unit)
            return [*forward_section(story), *inverse]
        return [*forward_in_short(story), *numerical_section(whole, story.algebra.chain)]
    steps = [step_blocks(story, number) for number in range(1, len(story.steps) + 1)]
    return [
        *forward_section(story),
        *inverse_beginning(story),
        *(block for blocks, _ in steps for block in blocks),
        *joint_values(story),
        *solutions_section(story),
        *singular_section(
            [*arm_angle_places(story), *(each for _, found in steps for each in found)]
        ),
        *cost_section(story),
    ]


def singular_places(story: Story) -> list[Singularity]:
    """Where the steps give other than their usual number of values."""
    found = (step_blocks(story, number)[1] for number in range(1, len(story.steps) + 1))
    return [each for places in found for each in places]
