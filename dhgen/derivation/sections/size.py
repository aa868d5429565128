"""What the arm's size is, to which tolerances and weights are relative."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain


def size_in_words(chain: Chain) -> str:
    """Where the size comes from, as `arm_size` finds it."""
    slides = [joint for joint in chain.joints if joint.kind is JointKind.PRISMATIC]
    ends = [abs(end) for slide in slides for end in slide.limits or ()]
    if chain.size in ends:
        return "the farthest limit of a slide"
    return "the sum of all its lengths"
