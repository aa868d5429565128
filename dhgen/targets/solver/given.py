"""What the caller gives besides the pose: values of free joints, or the arm angle."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain


@dataclass(frozen=True, slots=True)
class Given:
    """Values that the caller gives.

    Attributes:
        count: How many they are.
        sentence: What they are, as the beginning of a sentence.
        comment: The same in a comment.
        fault: What is at fault where one is not finite.
    """

    count: int
    sentence: str
    comment: str
    fault: str


def given_of(chain: Chain) -> Given:
    """What the caller of an arm gives."""
    joints = ", ".join(map(str, chain.free))
    angle = bool(chain.arm_angle)
    return Given(
        count=chain.given,
        sentence="The arm angle [rad]" if angle else f"Values of the joints {joints}",
        comment=(
            "the arm angle, which the caller gives [rad]"
            if angle
            else f"free joints, whose values the caller gives: {joints}"
        ),
        fault="the arm angle" if angle else "a free joint's value",
    )
