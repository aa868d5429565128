"""What the pose tells, written by the joints: the forward model put into a step's letters."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import POSE_PLACES, SHOULDER_NAMES
from dhgen.kinematics.ring import substitute, used_places
from dhgen.kinematics.transform import compose, inverse, translation

if TYPE_CHECKING:
    from dhgen.kinematics.constants import Polynomial
    from dhgen.targets.derivation.story import Story


def by_joints(story: Story, polynomial: Polynomial) -> Polynomial | None:
    """A polynomial in joints alone; None where it holds what the arm angle gives."""
    algebra = story.algebra
    used = used_places(polynomial)
    shoulder = [name for names in SHOULDER_NAMES for name in names]
    if algebra.chain.arm_angle and used & {algebra.index[name] for name in shoulder}:
        return None
    values = _values(story)
    change = {algebra.index[name]: value for name, value in values.items()}
    change = {place: value for place, value in change.items() if place in used}
    return algebra.normal(substitute(polynomial, change)) if change else polynomial


def _values(story: Story) -> dict[str, Polynomial]:
    """The pose entries and the coordinates of named points."""
    algebra, problem = story.algebra, story.derivation.problem
    forward = problem.spans.product(0, len(problem.links))
    values = {name: forward.entry(*place) for name, place in POSE_PLACES.items()}
    back = inverse(forward, algebra.normal)
    seen = [(point.names, point.in_tool, forward) for point in story.derivation.pool.points]
    seen += [(point.names, point.in_base, back) for point in story.derivation.pool.base_points]
    for names, coordinates, transform in seen:
        point = compose(transform, translation(algebra.ring, coordinates), algebra.normal)
        values |= dict(zip(names, point.translation, strict=True))
    return values
