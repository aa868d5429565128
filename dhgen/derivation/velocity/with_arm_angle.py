"""The determinant of a seven-joint arm's Jacobian with one more row, the rate of the arm angle.

The wrist centre's velocity and the arm angle do not depend on joints 5 to 7. Along the line from
the shoulder to the wrist joint 4 alone moves the wrist; across it, and about it, the shoulder's
angular velocity does. So the determinant is that of axes 1 to 3, times that of axes 5 to 7, times
the length of the line and half the derivative of its square by joint 4.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.sections.jacobian import derivative
from dhgen.derivation.text.formula import Symbol, times
from dhgen.derivation.velocity.columns import view_from
from dhgen.derivation.velocity.determinant import (
    Determinant,
    Powers,
    determinant,
    factors_with_powers,
    written,
)
from dhgen.paul.arm_plane import SHOULDER

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story

LINE = Symbol(r"\lVert \mathbf{v} \rVert", "‖v‖")


def determinant_with_arm_angle(story: Story, places: Sequence[Singularity]) -> Determinant | None:
    """In factors; None where no arm angle is given, or one fills pages."""
    algebra, plane = story.algebra, story.derivation.pool.plane
    if plane is None:
        return None
    stretch = algebra.normal(sum((x**2 for x in plane.wrist), algebra.ring.zero))
    elbow = algebra.chain.joints[SHOULDER]
    parts = [elbow.sign * derivative(algebra, stretch, elbow.number) / 2]
    for frame, joints in ((2, range(SHOULDER)), (5, range(SHOULDER + 1, story.dof))):
        columns = view_from(story, frame).columns(frame)
        spins = tuple(zip(*(columns[joint][1] for joint in joints), strict=True))
        parts.append(determinant(algebra, spins))
    still, powers = algebra.ring.one, Powers()
    for part in parts:
        if part is None:
            return None
        scale, found = factors_with_powers(algebra, part)
        still *= scale
        powers += found
    constant, factors = written(story, places, still, powers)
    return Determinant(times(constant, LINE), factors, story.dof)
