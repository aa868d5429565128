"""A lens on the circle, for polynomials whose roots crowd on one side of it.

Near the boundary of reach all solutions have nearly the same hidden angle. Around sixteen roots
that lie together f is the sixteenth power of what it is elsewhere, and drowns in the rounding of
its samples. The Möbius map e^{iφ} = (w + a) / (1 + ā w), |a| < 1, maps the circle of w = e^{iψ} to
itself and shows what lies around the direction of a larger; f(φ) |1 + ā w|^16 is again a
trigonometric polynomial of degree 8, in ψ. Sampled there it has its digits where the roots are.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, cos, log, sin, sqrt
from typing import TYPE_CHECKING

import numpy as np

from dhgen.runtime.python.general.tables import DEGREE, SAMPLES, sample_cosines

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from dhgen.arrays import FloatArray

    At = Callable[[FloatArray, FloatArray], FloatArray]


HALF = SAMPLES // 2
# How far the mean of the roots is from the circle's middle: not at all when they are spread evenly,
# by one when they lie together. Beyond this there is a lens, of this strength at most.
CROWDED = 0.35
STRONGEST = 0.9
# The mean of the roots over the first harmonic of log |f|.
MEAN_PER_HARMONIC = -1.0 / (SAMPLES * DEGREE)
NOTHING = 1e-300  # keeps logarithms of zero finite
# Samples that are no larger are rounding of zero, also where that is as smooth as a polynomial and
# its harmonics don't tell; elsewhere the largest are above 1e-20, even of arms that nearly have
# double roots at every pose.
VANISHING = 1e-26


@dataclass(frozen=True, slots=True)
class Lens:
    """The map from ψ to φ.

    Attributes:
        x: Real part of a.
        y: Its imaginary part.
    """

    x: float = 0.0
    y: float = 0.0

    def through(
        self, cosine: FloatArray, sine: FloatArray
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Cosine and sine of φ from those of ψ, and |1 + ā w|²."""
        u, v = cosine + self.x, sine + self.y
        d, e = 1.0 + self.x * cosine + self.y * sine, self.x * sine - self.y * cosine
        square = d * d + e * e
        return (u * d + v * e) / square, (v * d - u * e) / square, square

    def samples(self, at: At) -> FloatArray:
        """A polynomial's samples (24,) in ψ, |1 + ā w|^16 times its values."""
        cosines, sines, square = self.through(*np.array(sample_cosines()))
        return at(cosines, sines) * square**DEGREE

    def angle(self, psi: float) -> float:
        """φ from ψ."""
        cosine, sine, _ = self.through(np.array(cos(psi)), np.array(sin(psi)))
        return atan2(sine, cosine)


def spreading(samples: Sequence[float]) -> Lens:
    """The lens under which the roots are spread, none where they are already.

    log |f| is a sum over the roots z, and the first harmonic of log |e^{iφ} − z| is −z for z inside
    the circle, that of its mirror image for z outside.

    Args:
        samples: f at the 24 sample angles.
    """
    x = y = 0.0
    for k, (cosine, sine) in enumerate(zip(*sample_cosines(), strict=True)):
        if k < HALF:
            ratio = (abs(samples[k]) + NOTHING) / (abs(samples[k + HALF]) + NOTHING)
            x += log(ratio) * cosine
            y += log(ratio) * sine
    x, y = MEAN_PER_HARMONIC * x, MEAN_PER_HARMONIC * y
    mean = sqrt(x * x + y * y)
    if mean <= CROWDED:
        return Lens()
    part = min(1.0, STRONGEST / mean)
    return Lens(part * x, part * y)


def sampled(at: At) -> tuple[FloatArray, Lens]:
    """A polynomial's samples (24,), through the lens that spreads its roots, and that lens.

    Of one that vanishes but for rounding they are zero.

    Args:
        at: The polynomial's values from the cosines and sines of its angle, (24,) each.
    """
    samples = at(*np.array(sample_cosines()))
    if np.abs(samples).max() <= VANISHING:
        return np.zeros(SAMPLES), Lens()
    lens = spreading(samples.tolist())
    return (samples if lens == Lens() else lens.samples(at)), lens
