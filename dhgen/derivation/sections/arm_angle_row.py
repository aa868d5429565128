"""Where an arm angle has no plane to be measured from, for the table of singular configurations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.conditions import unsigned, without_lengths
from dhgen.derivation.known_side import by_joints
from dhgen.derivation.notation.names import single
from dhgen.derivation.sections.shoulder import PSI, wrist_from_shoulder
from dhgen.derivation.step_context import Singularity
from dhgen.derivation.text.blocks import say
from dhgen.derivation.text.formula import ZERO, Symbol, equal
from dhgen.kinematics.ring import used_places

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.constants import Polynomial


def arm_angle_places(story: Story) -> list[Singularity]:
    """Where the line from the shoulder to the wrist is axis 1; step 0 stands for the angle."""
    plane = story.derivation.pool.plane
    if plane is None:
        return []
    axis = "xy"[plane.reference]
    v, z = wrist_from_shoulder(story, plane), plane.first
    across = [v[i] * z[j] - v[j] * z[i] for i, j in ((0, 1), (2, 0), (1, 2))]
    left = [story.algebra.normal(entry) for entry in across if entry]
    meaning = say(
        "the wrist lies on axis 1: the line from the shoulder to it is that axis, and no plane is "
        "fixed by both"
    )
    effect = say(
        "{} takes the place of {}; close by, small motions of the tool turn the elbow far about "
        "that line while {} stays the same",
        Symbol(rf"\mathbf{{z}} \times \mathbf{{{axis}}}", f"z × {axis}"),
        Symbol(r"\mathbf{g} \times \mathbf{z}", "g × z"),
        PSI,
    )
    named = _named(story)
    condition = equal(*(named.get(entry) or unsigned(story, entry) for entry in left), ZERO)
    return [Singularity(0, condition, _in_joints(story, left), meaning, effect)]


def _named(story: Story) -> dict[Polynomial, Symbol]:
    """The coordinates of named points, and their opposites, by what they are in the pose."""
    target = story.derivation.problem.target
    found: dict[Polynomial, Symbol] = {}
    for point in story.derivation.pool.points:
        for row, name in enumerate(point.names):
            value = target.entry(row, 3)
            for column, length in enumerate(point.in_tool):
                value += target.entry(row, column) * length
            found |= dict.fromkeys((value, -value), story.letters[name])
    return found


def _in_joints(story: Story, across: list[Polynomial]) -> Formula | None:
    """The same without joint 1, which turns the two about axis 1, where that is upright."""
    algebra = story.algebra
    c, s = (algebra.generator(name) for name in (single(1).cosine, single(1).sine))
    if len(across) != 2:
        return None
    y, x = across
    turned = [by_joints(story, form) for form in (c * x + s * y, s * x - c * y)]
    shown = [without_lengths(algebra, form) for form in turned if form]
    first = {algebra.index[single(1).cosine], algebra.index[single(1).sine]}
    if not shown or any(used_places(form) & first for form in shown):
        return None
    return equal(*(unsigned(story, form) for form in shown), ZERO)
