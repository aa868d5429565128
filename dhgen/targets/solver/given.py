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
        comment: What they are, in a comment.
        fault: What is at fault where one is not finite.
    """

    count: int
    comment: str
    fault: str


def given_of(chain: Chain) -> Given:
    """What the caller of an arm gives."""
    joints = ", ".join(map(str, chain.free))
    angle = bool(chain.arm_angle)
    return Given(
        count=chain.given,
        comment=(
            "the arm angle, which the caller gives [rad]"
            if angle
            else f"free joints, whose values the caller gives: {joints}"
        ),
        fault="the arm angle" if angle else "a free joint's value",
    )
