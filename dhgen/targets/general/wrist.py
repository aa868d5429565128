"""The numbers of an offset wrist."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.general.runtime_loop import wrist_numbers
from dhgen.targets.general.numbers import row

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel


@dataclass(frozen=True, slots=True)
class Wrist:
    """An offset wrist; lengths in arm sizes.

    Attributes:
        shoulder: Along axis 1 to S, where axes 1 and 2 meet.
        wrist_5: Along axis 5 to W, where axes 4 and 5 meet.
        upper_square: The square of the distance from S to the elbow.
        lower: From the elbow to W.
        lower_square: Its square.
        cosine: Of the angle between the lower arm and axis 4.
        sine: Of the same.
        flip: On which side axis 4 leaves the lower arm.
        bent: Whether it leaves it at all, as 1 or 0.
        per_root: Solutions at a simple root of the polynomial of joint 6.
        sources: What the turns of joints 1 ... 4 bring into line with axis 3, the elbow, W and
            axis 5.
    """

    shoulder: float
    wrist_5: float
    upper_square: float
    lower: float
    lower_square: float
    cosine: float
    sine: float
    flip: float
    bent: int
    per_root: int
    sources: str


def wrist(kernel: GeneralKernel) -> Wrist | None:
    """The offset wrist of an arm, where it has one."""
    arm, of = wrist_numbers(kernel), kernel.wrist
    if arm is None or of is None:
        return None
    return Wrist(
        shoulder=arm.shoulder,
        wrist_5=arm.wrist,
        upper_square=arm.upper * arm.upper,
        lower=arm.lower,
        lower_square=arm.lower * arm.lower,
        cosine=arm.cosine,
        sine=arm.sine,
        flip=arm.flip,
        bent=int(bool(arm.sine)),
        per_root=of.solutions_per_root,
        sources=row(arm.sources),
    )
