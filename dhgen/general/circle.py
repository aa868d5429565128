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


def trigonometric(samples: FloatArray) -> Trigonometric:
    """The polynomial from its values (24,) at the sample angles."""
    values = samples.tolist()
    scale = max(map(abs, values)) or 1.0
    a, b = [], []
    for m in range(DEGREE + 4):
        weight = 1.0 / SAMPLES if m == 0 else 2.0 / SAMPLES
        total_c = total_s = 0.0
        for k, value in enumerate(values):
            total_c += value * COSINES[m * k % SAMPLES]
            total_s += value * SINES[m * k % SAMPLES]
        a.append(weight * total_c)
        b.append(weight * total_s)
    noise = max(abs(x) for x in a[DEGREE + 1 :] + b[DEGREE + 1 :]) / scale
    return Trigonometric(np.array(a[: DEGREE + 1]), np.array(b[: DEGREE + 1]), scale, noise)
