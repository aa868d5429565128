# SPDX-License-Identifier: MIT
"""The offset wrist: a polynomial of degree 8 or 4 in joint 6, in closed form.

Axes 1 and 2 meet at right angles in S, 2 and 3 are parallel, 4 and 5 meet at right angles in W,
axis 4 lies in the plane through S across axis 2. With q6 given, W and z5 are known, and S, the
elbow E and W form a triangle; axis 4 has to be at right angles to z5.

`back` is what goes from frame 6 to frame 5.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..jit import carray, of_file, room
from ..rigid import follow, take, turn
from .loop import POSE, TINY, unit
from .places import (
    BEND_C,
    BEND_S,
    BENT,
    FLIP,
    LOWER,
    LOWER_SQUARE,
    SHOULDER,
    SOURCES,
    UPPER_SQUARE,
    WRIST,
)

if TYPE_CHECKING:
    from ..arrays import Floats

OWN = of_file(__file__)
inner = OWN.inner

# Of the four ways to place the plane and the elbow, those are tried for which axis 4 is this nearly
# at right angles to z5 [cosine]: another one may have its root close by.
NEARLY_RIGHT = 1e-2
BARELY = 1e-12  # W is this close to axis 1, or to S: the plane is not determined [arm sizes]


@inner
def _wrist_at(
    arm: Floats, loop: Floats, back: Floats, c: float, s: float, frame: Floats
) -> tuple[float, float, float, float, float]:
    """Returns W from S, the square of its length, and the discriminant of the elbow.

    They follow from a sixth angle; frame takes frame 5 before its own turn.
    """
    take(frame, loop[POSE])
    turn(frame, c, -s)
    follow(frame, back)
    x = frame[3] + arm[WRIST] * frame[2]
    y = frame[7] + arm[WRIST] * frame[6]
    z = frame[11] + arm[WRIST] * frame[10] - arm[SHOULDER]
    w = x * x + y * y + z * z
    twice = w + arm[UPPER_SQUARE] - arm[LOWER_SQUARE]
    return x, y, z, w, 4.0 * arm[UPPER_SQUARE] * w - twice * twice


@inner
def wrist_polynomial(arm: Floats, loop: Floats, back: Floats, c: float, s: float) -> float:
    """Returns the polynomial of q6: of degree 8, or 4 where axis 4 does not leave the lower arm."""
    frame = carray(room(12), 12)
    x, y, z, w, D = _wrist_at(arm, loop, back, c, s, frame)
    along = x * frame[2] + y * frame[6] + z * frame[10]
    m = frame[10] * w - z * along
    part = w - arm[UPPER_SQUARE] + arm[LOWER_SQUARE]
    first, second = along * along * (x * x + y * y), m * m
    if arm[BENT] > 0.0:
        C, S = arm[BEND_C], arm[BEND_S]
        U = first * (C * C * part * part + S * S * D) - second * (S * S * part * part + C * C * D)
        V = 2.0 * C * S * part * (first + second)
        return (U * U - V * V * D) / (w * w + TINY)
    return (first * part * part - second * D) / (w + TINY)


@inner
def _targets(
    arm: Floats,
    frame: Floats,
    W: tuple[float, float, float],
    w: float,
    D: float,
    way: int,
    target: Floats,
) -> float:
    """Computes where axis 3, the elbow, W and z5 are, and returns the slant of axis 4.

    It is the cosine between axis 4 and z5, times the lower arm; infinite where W is on axis 1 or in
    S. A way is a sign of the plane and of the elbow.
    """
    tau, elbow = 1.0 if way % 2 else -1.0, 1.0 if way > 1 else -1.0
    wx, wy, wz = W
    rho = math.sqrt(wx * wx + wy * wy)
    if rho < BARELY:
        return math.inf
    z5 = (frame[2], frame[6], frame[10])
    x0, x1 = tau * wx / rho, tau * wy / rho
    up = (-wz * x0, -wz * x1, tau * rho)  # W turned about axis 3
    part = 0.5 * (w - arm[UPPER_SQUARE] + arm[LOWER_SQUARE]) / w
    side = 0.5 * elbow * math.sqrt(max(D, 0.0)) / w
    target[0, 2] = 0.0
    target[0, 0], target[0, 1] = arm[FLIP] * x1, arm[FLIP] * -x0
    slant = 0.0
    for i in range(3):
        reach, turned = part * W[i] - side * up[i], part * up[i] + side * W[i]
        slant += (arm[BEND_C] * reach + arm[BEND_S] * turned) * z5[i]
        target[2, i] = W[i] + (arm[SHOULDER] if i == 2 else 0.0)
        target[1, i] = target[2, i] - reach
        target[3, i] = z5[i]
    return slant


@inner
def wrist_joints(
    arm: Floats,
    loop: Floats,
    back: Floats,
    way: int,
    cosine_6: float,
    sine_6: float,
    c: Floats,
    s: Floats,
) -> int:
    """Computes the cosines and sines of all joints from cosine and sine of q6.

    Returns 1 where axis 4 is nearly at right angles to z5, 0 elsewhere.
    """
    c[5], s[5] = cosine_6, sine_6
    frame, target = carray(room(12), 12), carray(room(12), (4, 3))
    wx, wy, wz, w, D = _wrist_at(arm, loop, back, cosine_6, sine_6, frame)
    slant = _targets(arm, frame, (wx, wy, wz), w, D, way, target)
    if not abs(slant) < arm[LOWER] * NEARLY_RIGHT:
        return 0
    T = carray(room(12), 12)
    T[:] = 0.0
    T[0] = T[5] = T[10] = 1.0
    local = carray(room(2), 2)
    for k in range(4):
        for j in range(2):
            local[j] = 0.0
            for i in range(3):
                v = target[k, i] - T[4 * i + 3] if k in (1, 2) else target[k, i]
                local[j] += T[4 * i + j] * v
        a, b = arm[SOURCES + 2 * k], arm[SOURCES + 2 * k + 1]
        c[k], s[k] = unit(a * local[0] + b * local[1], a * local[1] - b * local[0])
        turn(T, c[k], s[k])
        follow(T, loop[k])
    cosine = sine = 0.0
    for i in range(3):
        cosine += T[4 * i] * frame[4 * i] + T[4 * i + 1] * frame[4 * i + 1]
        sine += T[4 * i + 1] * frame[4 * i] - T[4 * i] * frame[4 * i + 1]
    c[4], s[4] = unit(cosine, sine)
    return 1
