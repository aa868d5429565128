"""Newton's method on the loop, for candidates that are nearly solutions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.recover import EZ, motion

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray


@dataclass(frozen=True, slots=True)
class Target:
    """What the loop's joints have to reach.

    Attributes:
        links: K0 ... K4 [arm sizes], (4, 4) each.
        P: The pose of the loop, (4, 4).
        slides: Which of the six joints slide, from 0.
    """

    links: tuple[FloatArray, ...]
    P: FloatArray
    slides: tuple[int, ...] = ()


# The smallest singular value of the Jacobian over the largest: where it is below this the arm is
# singular, to the accuracy to which a double root is known.
SINGULAR = 1e-6
# Below this it is nearly singular: copies of a singular solution, as far away from it as a miss of
# 1e-10 leaves them, are no less so.
NEARLY_SINGULAR = 1e-4
# Singular values below this part of the largest count as zero: Newton then moves in the rest
# only, instead of leaping along a direction that the pose does not determine.
RANK = 1e-9
DAMPING = 1e-2
# Emitted code adds this to the damped squares that it divides by; singular values want nothing.
SMALLEST_SQUARE = 1e-30
GOOD_ENOUGH = 1e-29  # the square of a residual that is rounding: steps end


def regularity(target: Target, theta: FloatArray) -> float:
    """The smallest singular value of the Jacobian over the largest."""
    _, J = _linearised(target, theta)
    values = np.linalg.svd(J, compute_uv=False)
    return float(values[-1] / values[0])


def polish(
    target: Target, theta: FloatArray, steps: int, *, afar: bool = False
) -> tuple[FloatArray, float]:
    """The best iterate and its residual.

    Args:
        target: The loop.
        theta: Joint angles, (6,) [rad]; a slide's length [arm sizes].
        steps: How many steps at most.
        afar: Damp the steps (Levenberg and Marquardt, the damping falling with the square of the
            error): for starts far away, and for singular solutions.
    """
    best, least = theta, np.inf
    for _ in range(steps + 1):
        miss, J = _linearised(target, theta)
        residual = float(np.linalg.norm(miss))
        if residual < least:
            best, least = theta, residual
        if residual * residual < GOOD_ENOUGH:
            break
        if afar:
            damped = np.sqrt(DAMPING) * min(residual, 1.0) * np.eye(6)
            step, *_ = np.linalg.lstsq(np.vstack([J, damped]), np.append(miss, np.zeros(6)))
        else:
            step, *_ = np.linalg.lstsq(J, miss, rcond=RANK)
        theta = theta + np.clip(step, -1.0, 1.0)
    return best, least


def _linearised(target: Target, theta: FloatArray) -> tuple[FloatArray, FloatArray]:
    T, P = np.eye(4), target.P
    axes, points = [], []
    for i, value in enumerate(theta):
        if i:
            T = T @ target.links[i - 1]
        axes.append(T[:3, :3] @ EZ)
        points.append(T[:3, 3])
        T = T @ motion(value, slides=i in target.slides)
    spin = P[:3, :3] @ T[:3, :3].T
    rotation = [spin[2, 1] - spin[1, 2], spin[0, 2] - spin[2, 0], spin[1, 0] - spin[0, 1]]
    half = np.array(rotation) / 2
    # half a turn away the skew part vanishes too: the trace tells
    half = half + np.where(np.trace(spin[:3, :3]) < 0, 1.0, 0.0)
    J = np.array([[*np.cross(z, T[:3, 3] - o), *z] for z, o in zip(axes, points, strict=True)]).T
    for place in target.slides:
        J[:, place] = [*axes[place], 0.0, 0.0, 0.0]
    return np.concatenate([P[:3, 3] - T[:3, 3], half]), J
