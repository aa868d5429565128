"""The order of a derivation's sections, and the course texts that it cites."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.sections.calibrated import calibrated_section
from dhgen.derivation.sections.choosing import choosing_section
from dhgen.derivation.sections.closing import (
    singular_section,
    solutions_section,
)
from dhgen.derivation.sections.drives import drives_section
from dhgen.derivation.sections.elements import element_blocks, known_side_blocks
from dhgen.derivation.sections.example import example_section, singular_blocks
from dhgen.derivation.sections.forward import forward_in_short, forward_section
from dhgen.derivation.sections.general import general_section
from dhgen.derivation.sections.inverse import inverse_beginning
from dhgen.derivation.sections.joints import joint_values
from dhgen.derivation.sections.listing import listing_blocks
from dhgen.derivation.sections.nearest import nearest_blocks
from dhgen.derivation.sections.numerical import numerical_section
from dhgen.derivation.sections.other_ways import other_way
from dhgen.derivation.sections.robot import opening, robot_section
from dhgen.derivation.sections.shoulder import arm_angle_places
from dhgen.derivation.sections.velocity import velocity_section
from dhgen.derivation.sections.whole_example import whole_example_section
from dhgen.derivation.sections.wrist import wrist_blocks
from dhgen.derivation.steps import step_blocks
from dhgen.derivation.story import COURSE_TEXT
from dhgen.derivation.text.blocks import Given, Paragraph, Prose, paragraph, unfolded
from dhgen.derivation.text.walk import symbols_of
from dhgen.derivation.text.words import many
from dhgen.general.kernel import GeneralKernel

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from dhgen.derivation.figures.all import Figures
    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block


def document_blocks(story: Story, figures: Figures | None = None) -> list[Block]:
    """The whole derivation, with figures where there are any to show."""
    shown = _Pictures(figures)
    beginning, model = opening(story), _sections(story, shown)
    robot = [*robot_section(story, symbols_of(model)), *shown.arm, *shown.workspace]
    rest = [*robot, *drives_section(story), *model]
    return [*beginning, *cited_documents([*beginning, *rest]), *rest]


class _Pictures:
    """The places of figures, empty where there are none."""

    def __init__(self, figures: Figures | None) -> None:
        self.arm = [figures.arm.picture] if figures else []
        self.workspace = [figures.workspace.picture] if figures and figures.workspace else []
        self.postures = [figures.postures.picture] if figures and figures.postures else []


def _sections(story: Story, shown: _Pictures) -> list[Block]:
    """What follows the robot."""
    whole = story.derivation.whole
    if whole is not None:
        if isinstance(whole, GeneralKernel):
            nearest = nearest_blocks(story)
            example = whole_example_section(story, whole)
            inverse = general_section(story, whole, nearest, example)
            return [*forward_section(story), *inverse, *velocity_section(story, [])]
        inverse = numerical_section(story, whole)
        return [*forward_in_short(story), *inverse, *velocity_section(story, [])]
    steps = [step_blocks(story, number) for number in range(1, len(story.steps) + 1)]
    places = [*arm_angle_places(story), *(each for _, found in steps for each in found)]
    return [
        *forward_section(story),
        *inverse_beginning(story),
        *_steps(story, [blocks for blocks, _ in steps]),
        *joint_values(story),
        *solutions_section(story),
        *listing_blocks(story),
        *example_section(story),
        *shown.postures,
        *choosing_section(story),
        *singular_section(story, places),
        *singular_blocks(story, places),
        *calibrated_section(story),
        *velocity_section(story, places),
    ]


def _steps(story: Story, steps: Sequence[Sequence[Block]]) -> Iterator[Block]:
    for number, blocks in enumerate(steps, start=1):
        yield from known_side_blocks(story, number)
        yield from wrist_blocks(story, number)
        yield from element_blocks(story, number)
        yield from blocks
        yield from other_way(story, number)


def singular_places(story: Story) -> list[Singularity]:
    """Where the steps give other than their usual number of values."""
    found = (step_blocks(story, number)[1] for number in range(1, len(story.steps) + 1))
    return [each for places in found for each in places]


TITLES = {
    "000": '"Modélisation d\'un robot manipulateur", on forward and inverse models',
    "001": '"Cinématique", on rotations and axes in the reference position',
    "002": '"Modélisation et commande des robots de manipulation" (Université des Frères Mentouri, '
    "Constantine), on Paul's method",
    "003": '"Modèle géométrique", on Denavit-Hartenberg tables and Paul\'s method',
    "004": "an inverse model worked out, without a title",
}


def cited_documents(blocks: Iterable[Block]) -> list[Block]:
    """A paragraph on the documents that paragraphs cite; none where they cite none."""
    cited = sorted({number for text in _texts(blocks) for number in COURSE_TEXT.findall(text)})
    known = [number for number in cited if number in TITLES]
    if not known:
        return []
    subject = f"{many('document', known).capitalize()}, cited here by number,"
    if not known[1:]:
        return [paragraph(f"{subject} is a course text in French: {TITLES[known[0]]}.")]
    titles = "; ".join(f"{number}: {TITLES[number]}" for number in known)
    return [paragraph(f"{subject} are course texts in French. {titles}.")]


def _texts(blocks: Iterable[Block]) -> Iterable[str]:
    for block in unfolded(blocks):
        if isinstance(block, Paragraph):
            yield from _words(block.prose)
            yield from _words(block.lead) if block.lead else ()


def _words(prose: Prose) -> Iterable[str]:
    yield prose.text
    for part in prose.parts:
        if isinstance(part, Given):
            yield part.text
        elif isinstance(part, Prose):
            yield from _words(part)
