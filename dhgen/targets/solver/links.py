"""The comment on the table of a robot's links, in any language."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.link_table import AXES
from dhgen.targets.layout import paragraph

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule


def about_table(module: SolverModule, indent: str) -> str:
    """What its rows are."""
    unit, convention = module.length_unit, module.links.convention
    if convention == AXES:
        text = f"The axes at q = 0: a unit vector along each, and a point of it [{unit}]."
    else:
        cells = f"theta [rad], d [{unit}], a [{unit}], alpha [rad]"
        text = f"The table at q = 0, {convention}: {cells}."
    return paragraph(text, indent)
