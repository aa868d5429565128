"""What the pose tells, written by the joints: the forward model put into a step's letters."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import POSE_PLACES, SHOULDER_NAMES
from dhgen.kinematics.ring import substitute, used_places
from dhgen.kinematics.transform import compose, translation

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.kinematics.constants import Polynomial


def by_joints(story: Story, polynomial: Polynomial) -> Polynomial | None:
    """A polynomial in joints alone; None where it holds what the arm angle gives."""
    algebra = story.algebra
    used = used_places(polynomial)
    shoulder = [name for names in SHOULDER_NAMES for name in names]
    if algebra.chain.arm_angle and used & {algebra.index[name] for name in shoulder}:
        return None
    values = _values(story, {algebra.ring.symbols[place].name for place in used})
    change = {algebra.index[name]: value for name, value in values.items()}
    return algebra.normal(substitute(polynomial, change)) if change else polynomial


def _values(story: Story, used: set[str]) -> dict[str, Polynomial]:
    """The pose entries and the coordinates of named points, as far as they are used."""
    algebra, problem = story.algebra, story.derivation.problem
    whole = 0, len(problem.links)
    forward = problem.spans.product(*whole)
    values = {name: forward.entry(*place) for name, place in POSE_PLACES.items() if name in used}
    pool = story.derivation.pool
    seen = [(p.names, p.in_tool, forward) for p in pool.points if used & {*p.names}]
    back = problem.spans.inverse(*whole)
    seen += [(p.names, p.in_base, back) for p in pool.base_points if used & {*p.names}]
    for names, coordinates, transform in seen:
        point = compose(transform, translation(algebra.ring, coordinates), algebra.normal)
        values |= {
            name: at for name, at in zip(names, point.translation, strict=True) if name in used
        }
    return values
