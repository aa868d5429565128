"""The joint values at which the arm itself is drawn: its reference position where that shows it.

Angles are zero there, and slides too unless nothing would be seen of them. An arm whose links then
lie over each other is drawn as in its example, or with equal angles.
"""

from __future__ import annotations

import math
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.figures.skeleton import Part
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.derivation.figures.skeleton import Member, Skeleton, Skeletons
    from dhgen.derivation.story import Story
    from dhgen.kinematics.chain import ChainJoint

SHORT = 0.12  # of the arm's size: a slide of which little is seen
LONG = 0.3  # of the arm's size: a slide without limits
OVER = 0.05  # of the arm's size, that members may lie over each other
ANGLE = math.radians(30.0)  # of all joints


def drawn_position(story: Story, arms: Skeletons) -> FloatArray:
    """The joint values that the figure of the arm shows."""
    chain = story.algebra.chain
    rest = np.array([_value(joint, chain.size) for joint in chain.joints])
    candidates = [rest]
    if story.example is not None:
        candidates.append(story.example.q)
    candidates.append(np.where(chain.turning, ANGLE, rest))
    plain = (q for q in candidates if not _is_folded(arms.at(q), chain.size))
    return next(plain, rest)


def _value(joint: ChainJoint, size: float) -> float:
    """Zero, but for a slide of which nothing would be seen or that can't be there."""
    if joint.kind is JointKind.REVOLUTE:
        return 0.0
    low, high = joint.limits or (0.0, 2.0 * LONG * size)
    middle = low + (high - low) / 2.0
    places = (0.0, middle, low + 0.8 * (high - low))
    seen = (
        q for q in places if low <= q <= high and abs(joint.sign * q + joint.offset) >= SHORT * size
    )
    digits = 1 - math.floor(math.log10(size))
    return round(next(seen, middle), digits)


def _is_folded(arm: Skeleton, size: float) -> bool:
    """Whether two members lie over each other."""
    parts = [each for each in arm.members if each.part in {Part.LINK, Part.SLIDE}]
    return any(_overlap(one, other) > OVER * size for one, other in combinations(parts, 2))


def _overlap(one: Member, other: Member) -> float:
    """How much of two members is at one place [length]."""
    length = float(np.linalg.norm(one.along))
    direction = one.along / length
    ends = [point - one.start for point in (other.start, other.end)]
    along = [float(end @ direction) for end in ends]
    off = max(
        float(np.linalg.norm(end - at * direction)) for end, at in zip(ends, along, strict=True)
    )
    shared = min(max(along), length) - max(min(along), 0.0)
    return shared if off < 0.02 * max(length, shared) else 0.0
