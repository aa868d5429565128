"""The figures of a derivation, and where its document shows them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.derivation.figures.arm import arm_figure
from dhgen.derivation.figures.postures import postures_figure
from dhgen.derivation.figures.workspace import workspace_figure

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.derivation.figures.figure import Figure
    from dhgen.derivation.story import Story


@dataclass(frozen=True, slots=True)
class Figures:
    """What is drawn of an arm.

    Attributes:
        arm: Its axes, frames and lengths.
        workspace: What it reaches, where a plane shows that.
        postures: The solutions of the example, where they differ to the eye.
    """

    arm: Figure
    workspace: Figure | None
    postures: Figure | None

    def __iter__(self) -> Iterator[Figure]:
        """The figures that there are, in the document's order."""
        for each in (self.arm, self.workspace, self.postures):
            if each is not None:
                yield each


def figures_of(story: Story) -> Figures:
    """All figures of an arm."""
    return Figures(arm_figure(story), workspace_figure(story), postures_figure(story))
