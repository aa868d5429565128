"""The numbers of an offset wrist."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

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
        bent: Whether it leaves it at all.
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
    bent: bool
    per_root: int
    sources: str


def wrist(kernel: GeneralKernel) -> Wrist | None:
    """The offset wrist of an arm, where it has one."""
    arm = kernel.wrist
    if arm is None:
        return None
    K0, K1, K2, K3, _ = (link.first for link in kernel.loop.links)
    elbow = [K1[i][3] + arm.elbow * K1[i][2] for i in range(2)]
    centre = [K2[i][3] + arm.wrist_4 * K2[i][2] for i in range(2)]
    return Wrist(
        shoulder=arm.shoulder,
        wrist_5=arm.wrist_5,
        upper_square=arm.upper * arm.upper,
        lower=arm.lower,
        lower_square=arm.lower * arm.lower,
        cosine=arm.cosine,
        sine=arm.sine,
        flip=arm.flip,
        bent=bool(arm.sine),
        per_root=arm.solutions_per_root,
        sources=row([K0[0][2], K0[1][2], *elbow, *centre, K3[0][2], K3[1][2]]),
    )
