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

import numpy as np

from dhgen.general.recover import rigid_inverse, turn

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.general.loop import Loop


EXACT = 1e-9  # what counts as parallel, at right angles, meeting [arm sizes, rad]
# Of the four ways to place the plane and the elbow, those are tried for which axis 4 is this
# nearly at right angles to z5: another one may have its root close by.
NEARLY_RIGHT = 1e-2
BARELY = 1e-12  # W is this close to axis 1, or to S: the plane is not determined


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

    def values(
        self, links: Sequence[FloatArray], P: FloatArray, cosines: FloatArray, sines: FloatArray
    ) -> FloatArray:
        """The polynomial, (N,), from cosines and sines of the sixth angle."""
        every = zip(cosines, sines, strict=True)
        return np.array([polynomial(self, *wrist_at(self, links[4], P, *x)[1:]) for x in every])

    def tells_all(
        self, _links: Sequence[FloatArray], _P: FloatArray, _roots: Sequence[float]
    ) -> bool:
        """Whether every solution has a root, and every root tells its solutions."""
        return True

    def candidates(
        self, links: Sequence[FloatArray], P: FloatArray, angle: float
    ) -> Iterator[FloatArray | None]:
        """Joint angles (6,) near solutions whose sixth angle is a root."""
        frame, W, z5 = wrist_at(self, links[4], P, np.cos(angle), np.sin(angle))
        w, rho = float(W @ W), _hypot(W[0], W[1])
        if rho < BARELY:
            return
        D = 4 * self.upper**2 * w - (self.upper**2 - self.lower**2 + w) ** 2
        part, side = (w - self.upper**2 + self.lower**2) / (2 * w), np.sqrt(max(D, 0.0)) / (2 * w)
        for tau in (1.0, -1.0):
            x = tau * np.array([W[0], W[1], 0.0]) / rho
            across = np.array([0.0, 0.0, tau * rho]) - W[2] * x  # W turned about axis 3
            for elbow in (1.0, -1.0):
                # E→W and the same turned
                reach, turned = part * W - elbow * side * across, part * across + elbow * side * W
                z4 = (self.cosine * reach + self.sine * turned) / self.lower
                if abs(z4 @ z5) < NEARLY_RIGHT:
                    S = np.array([0.0, 0.0, self.shoulder])
                    normal = np.array([x[1], -x[0], 0.0])
                    yield _angles(self, links, frame, (S + W - reach, S + W, normal), angle)


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


def wrist_at(
    arm: OffsetWrist, K4: FloatArray, P: FloatArray, cosine: float, sine: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Frame 5 before its own turn, W from S, and z5, for a sixth angle."""
    back = turn(0.0)
    back[:2, :2] = [[cosine, sine], [-sine, cosine]]
    frame: FloatArray = P @ back @ rigid_inverse(K4)
    W = frame[:3, 3] + arm.wrist_5 * frame[:3, 2] - [0.0, 0.0, arm.shoulder]
    return frame, W, frame[:3, 2]


def _hypot(x: float, y: float) -> float:
    """The length of a plane vector; a library's own may round differently elsewhere."""
    return sqrt(x * x + y * y)


def polynomial(arm: OffsetWrist, W: FloatArray, z5: FloatArray) -> float:
    """f(θ6), of degree 8, or of degree 4 when axis 4 goes through the elbow.

    The condition z4·z5 = 0 is c ρ (C P + S ε√D) + τ m (S P − C ε√D) = 0 with the sign τ of the
    plane and ε of the elbow; f is the product over both signs.
    """
    C, S = arm.cosine, arm.sine
    w, c = float(W @ W), float(W @ z5)
    h, k = W[2], z5[2]
    across = w - h * h
    m = k * w - h * c
    P = w - arm.upper**2 + arm.lower**2
    D = 4 * arm.upper**2 * w - (arm.upper**2 - arm.lower**2 + w) ** 2
    first, second = c * c * across, m * m
    U = first * (C * C * P * P + S * S * D) - second * (S * S * P * P + C * C * D)
    if not S:
        return float(U / w)
    V = 2 * C * S * P * (first + second)
    return float((U * U - V * V * D) / (w * w))


def _angles(
    arm: OffsetWrist,
    links: Sequence[FloatArray],
    frame: FloatArray,
    places: tuple[FloatArray, FloatArray, FloatArray],
    theta_6: float,
) -> FloatArray:
    """All angles, from E, W and the direction of axis 3."""
    E, W, normal = places
    theta = np.empty(6)
    T = np.eye(4)
    targets = (arm.flip * normal, E, W, frame[:3, 2])
    sources = (
        links[0][:3, 2],
        links[1][:3, 3] + arm.elbow * links[1][:3, 2],
        links[2][:3, 3] + arm.wrist_4 * links[2][:3, 2],
        links[3][:3, 2],
    )
    for i, (target, source) in enumerate(zip(targets, sources, strict=True)):
        is_point = i in {1, 2}
        local = T[:3, :3].T @ (target - T[:3, 3] if is_point else target)
        theta[i] = np.arctan2(
            source[0] * local[1] - source[1] * local[0],
            source[0] * local[0] + source[1] * local[1],
        )
        T = T @ turn(theta[i]) @ links[i]
    rest = rigid_inverse(T) @ frame
    theta[4] = np.arctan2(rest[1, 0] - rest[0, 1], rest[0, 0] + rest[1, 1])
    theta[5] = theta_6
    return theta
