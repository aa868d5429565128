"""Arms with an offset wrist: the polynomial of the sixth angle in closed form.

Axes 1 and 2 meet at right angles in S, axes 2 and 3 are parallel, axes 4 and 5 meet at right angles
in W, and axis 4 lies in the plane through S across axis 2. Given θ6, W and z5 are known, and E, the
elbow, is where two circles of that plane meet: S, E and W form a triangle with sides a2 and r.
Axis 4 makes a fixed angle with E→W and has to be at right angles to z5.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.general.loop import Loop


EXACT = 1e-9  # what counts as parallel, at right angles, meeting [arm sizes, rad]


@dataclass(frozen=True, slots=True)
class OffsetWrist:
    """The numbers of such an arm, in arm sizes.

    Attributes:
        shoulder: S on axis 1.
        elbow: E on axis 3.
        wrist_4: W on axis 4.
        wrist_5: W on axis 5.
        upper: a2, the distance from S to E.
        lower: r, the distance from E to W.
        cosine: Of the angle from E→W to axis 4, about axis 3.
        sine: The same; zero when axis 4 goes through E, and f has degree 4 then.
        flip: +1 when axes 2 and 3 have the same direction, −1 otherwise.
    """

    shoulder: float
    elbow: float
    wrist_4: float
    wrist_5: float
    upper: float
    lower: float
    cosine: float
    sine: float
    flip: float

    @property
    def solutions_per_root(self) -> int:
        """How many of the four ways share each root."""
        return 1 if self.sine else 2


def offset_wrist(loop: Loop) -> OffsetWrist | None:
    """The arm as one with an offset wrist, or None when it isn't."""
    if loop.slides or any(link.rest for link in loop.links):
        return None
    K0, K1, K2, K3, _ = (link.first for link in loop.links)
    flip = 1.0 if K1[2][2] > 0.0 else -1.0
    # where axes 1 and 2 meet, and the plane's height on axes 2 and 3
    height = -(K0[0][3] * K0[0][2] + K0[1][3] * K0[1][2])
    elbow = (height - K1[2][3]) * flip
    wrist_4 = K3[2][3]
    wrist_5 = -(K3[0][3] * K3[0][2] + K3[1][3] * K3[1][2])
    misses = (
        K0[2][2],
        K0[0][3] * K0[1][2] - K0[1][3] * K0[0][2],
        _hypot(K1[0][2], K1[1][2]),
        K2[2][2],
        K2[2][3] - elbow,
        K3[2][2],
        K3[0][3] * K3[1][2] - K3[1][3] * K3[0][2],
    )
    x, y = (K2[i][3] + wrist_4 * K2[i][2] for i in range(2))
    upper, lower = _hypot(K1[0][3], K1[1][3]), _hypot(x, y)
    if max(map(abs, misses)) > EXACT or min(upper, lower) < EXACT:
        return None
    cosine = (x * K2[0][2] + y * K2[1][2]) / lower
    sine = (x * K2[1][2] - y * K2[0][2]) / lower
    sine = sine if abs(sine) > EXACT else 0.0
    return OffsetWrist(K0[2][3], elbow, wrist_4, wrist_5, upper, lower, cosine, sine, flip)


def _hypot(x: float, y: float) -> float:
    """The length of a plane vector; a library's own may round differently elsewhere."""
    return sqrt(x * x + y * y)
