"""Arms whose tables come at run time: what the template `calibrated.md.jinja` names."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.text.template import blocks_of
from dhgen.robot.robot import FLEET

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block


def calibrated_section(story: Story) -> list[Block]:
    """How arms with tables of their own are solved; nothing where they aren't asked for."""
    robot = story.robot
    return blocks_of("calibrated", name=robot.name + FLEET) if robot.calibration else []
