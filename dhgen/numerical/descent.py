"""Steps of damped least squares from joint values to the solution beside them.

Where many solutions meet steps get slow: those to a single root square the miss, those to several
roots leave a part of it. The arm is singular at what they come through (D. W. Decker, H. B. Keller,
C. T. Kelley, Convergence rates for Newton's method at singular points, 1983), and rounding ends
them far from the root. They lead further from both sides of such a place.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.numerical import kernel as constants
from dhgen.numerical.miss import miss
from dhgen.runtime.python.numerical.arm import strides

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.numerical.kernel import NumericalKernel


@dataclass(frozen=True, slots=True)
class End:
    """Where steps from a row lead.

    Attributes:
        q: Joint values (n,), angles in (-pi, pi].
        miss: By how much they miss the pose [arm sizes, rad].
        ahead: How long another step would be [rad, arm sizes].
    """

    q: FloatArray
    miss: float
    ahead: float

    def solves(self, exact: float) -> bool:
        """Whether this is a solution.

        Beside a singular place joint values may miss a pose by next to nothing and be far from any.
        """
        return self.miss <= exact and self.ahead <= constants.SURE


def descended(
    kernel: NumericalKernel,
    T: FloatArray,
    q: FloatArray,
    exact: float,
    steps: int = constants.TIGHTENINGS,
    psi: float = 0.0,
) -> End:
    """Takes a row (n,) as far as steps of damped least squares help.

    Half of the square of a step may be left by the curvature of the motion. Beside a singular place
    a step that is right may be long, and what it leaves far more than was missed.
    """
    solved, units = list(kernel.solved), np.array(kernel.units)
    best, least, there, ahead = q.copy(), np.inf, q.copy(), np.inf
    last, left = np.inf, 0.0  # the miss before a step, and what its curvature leaves
    for _ in range(steps + 1):
        e, length, A = miss(kernel, T, there[None], psi)
        step = damped_step(e, length, A, constants.FINE)[0]
        slow = not length[0] <= max(0.5 * last, left)
        if length[0] < least:
            least, best = float(length[0]), there.copy()
            ahead = float(np.abs(step).max())
        if slow or (least <= constants.SPARE * exact and ahead <= constants.SURE):
            break
        step = shortened(step)
        last, left = float(length[0]), 0.5 * float(np.abs(step).sum()) ** 2
        there[solved] += units * step
    turning = [place for place, turns in zip(solved, kernel.turns, strict=True) if turns]
    best[turning] -= 2 * np.pi * np.ceil(best[turning] / (2 * np.pi) - 0.5)
    return End(best, least, ahead)


def escaped(
    kernel: NumericalKernel, T: FloatArray, q: FloatArray, exact: float, psi: float = 0.0
) -> End:
    """Takes a row (n,) as far as steps help, also from both sides of where they get slow.

    A root of four is missed by the fourth power of the way to it.
    """
    solved, units = list(kernel.solved), np.array(kernel.units)
    best = descended(kernel, T, q, exact, psi=psi)
    for _ in range(constants.ESCAPES):
        if best.miss <= exact:
            break
        along, length = sideways(miss(kernel, T, best.q[None], psi)[2])
        if length <= constants.SINGULAR:
            break
        aside = np.zeros_like(q)
        aside[solved] = best.miss**0.25 * units * along
        sides = (best.q + aside, best.q - aside)
        end = min(
            (descended(kernel, T, side, exact, psi=psi) for side in sides),
            key=lambda end: end.miss,
        )
        if not end.miss < constants.STUCK * best.miss:
            break
        best = end
    return best


def damped_step(
    e: FloatArray, length: FloatArray, A: FloatArray, floor: float | FloatArray
) -> FloatArray:
    """The damped least squares step, A' (A A' + damping)^-1 e, by singular values.

    `floor` is the least damping.
    """
    damping = constants.DAMPING * np.minimum(length**2, 1.0) + floor
    U, values, across = np.linalg.svd(A, full_matrices=False)
    parts = (np.swapaxes(U, 1, 2) @ e[..., None])[..., 0]
    parts *= values / (values**2 + damping[..., None])
    return np.asarray((parts[:, None, :] @ across)[:, 0])


def sideways(A: FloatArray) -> tuple[FloatArray, float]:
    """The part of a generic direction (k,) that leaves the tool where it is, to first order.

    It is made one long; the second is how long it was. `A` (1, m, k) tells how joints move the
    tool.
    """
    direction = np.array(strides(A.shape[-1]))
    step = damped_step(A @ direction, np.zeros(1), A, constants.FLOOR)[0]
    along = direction - step
    length = float(np.linalg.norm(along))
    return along / length if length else along, length


def shortened(steps: FloatArray) -> FloatArray:
    """Steps (..., k), no longer than they may be."""
    longest = np.abs(steps).max(axis=-1, initial=constants.LONGEST)
    return np.asarray(steps * (constants.LONGEST / longest)[..., None])
