"""A trigonometric polynomial of degree 8 from samples, by which formulations are scored.

f(φ) = Σ a_m cos mφ + b_m sin mφ, m = 0 ... 8. Everything is summed in a fixed order, so that scores
are the same on every machine.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.runtime.python.general.tables import COSINES, DEGREE, SAMPLES, SINES

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

HARMONICS = DEGREE + 4  # three more than f has, which show its noise
ANGLES = np.outer(range(SAMPLES), range(HARMONICS))[..., np.newaxis] % SAMPLES  # m φ, as places
WEIGHTS = np.array([1.0 / SAMPLES, *[2.0 / SAMPLES] * (HARMONICS - 1)])[:, np.newaxis]


@dataclass(frozen=True, slots=True)
class Trigonometric:
    """f(φ) = Σ a_m cos mφ + b_m sin mφ.

    Attributes:
        cosine: a_0 ... a_8, (9,).
        sine: b_0 = 0, b_1 ... b_8, (9,).
        scale: The largest sample.
        noise: The harmonics 9 to 11, over `scale`.
    """

    cosine: FloatArray
    sine: FloatArray
    scale: float
    noise: float

    def at(self, cosine: float, sine: float) -> tuple[float, float, float]:
        """f, f' and f'' at the angle with this cosine and sine."""
        value = first = second = 0.0
        c, s = 1.0, 0.0
        for m, (a, b) in enumerate(zip(self.cosine.tolist(), self.sine.tolist(), strict=True)):
            even, odd = a * c + b * s, b * c - a * s
            value += even
            first += m * odd
            second -= m * m * even
            c, s = c * cosine - s * sine, s * cosine + c * sine
        return value, first, second


def trigonometric(samples: FloatArray) -> list[Trigonometric]:
    """The polynomials from their values (N, 24) at the sample angles."""
    cosines, sines = np.zeros((2, HARMONICS, len(samples)))
    for values, places in zip(samples.T, ANGLES, strict=True):
        cosines += values * np.array(COSINES)[places]
        sines += values * np.array(SINES)[places]
    cosines *= WEIGHTS
    sines *= WEIGHTS
    scales = np.abs(samples).max(axis=1)
    scales[scales == 0.0] = 1.0
    left = np.abs([cosines[DEGREE + 1 :], sines[DEGREE + 1 :]]).max(axis=(0, 1)) / scales
    parts = cosines[: DEGREE + 1].T, sines[: DEGREE + 1].T, scales.tolist(), left.tolist()
    return [Trigonometric(*each) for each in zip(*parts, strict=True)]
