# SPDX-License-Identifier: MIT
"""A lens on the circle, for polynomials whose roots crowd on one side of it.

Near the boundary of reach all solutions have nearly the same hidden angle. Around sixteen roots
that lie together f is the sixteenth power of what it is elsewhere, and drowns in the rounding of
its samples. The Moebius map e^(i phi) = (w + a) / (1 + conj(a) w) with a = x + i y, |a| < 1, maps
the circle of w = e^(i psi) to itself and shows what lies around the direction of a larger; f(phi)
|1 + conj(a) w|^16 is again a trigonometric polynomial of degree 8, in psi. Sampled there it has its
digits where the roots are.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..jit import of_file
from .loop import TINY
from .tables import DEGREE, SAMPLE_C, SAMPLE_S, SAMPLES

if TYPE_CHECKING:
    from ..arrays import Floats, Ints

OWN = of_file(__file__)
inner = OWN.inner

# How far the mean of the roots is from the circle's middle: not at all when they are spread evenly,
# by one when they lie together. Beyond this there is a lens, of this strength at most.
CROWDED = 0.35
STRONGEST = 0.9
MEAN_PER_HARMONIC = -1.0 / (SAMPLES * DEGREE)  # the mean of the roots over a harmonic of log |f|


@inner
def through(x: float, y: float, c: float, s: float) -> tuple[float, float, float]:
    """Returns cosine and sine of phi from cosine and sine of psi, and |1 + conj(a) w|^16."""
    u, v, d, e = c + x, s + y, 1.0 + x * c + y * s, x * s - y * c
    square = d * d + e * e
    return (u * d + v * e) / square, (v * d - u * e) / square, square**8


@inner
def spread(samples: Floats) -> tuple[float, float]:
    """Returns the lens under which the roots are spread, from samples without one.

    0, 0 when they are already. log |f| is a sum over the roots z, and the first harmonic of
    log |e^(i phi) - z| is -z for z inside the circle, that of its mirror image for z outside.
    """
    x = y = 0.0
    for k in range(12):
        ratio = math.log((abs(samples[k]) + TINY) / (abs(samples[k + 12]) + TINY))
        x += ratio * SAMPLE_C[k]
        y += ratio * SAMPLE_S[k]
    x, y = MEAN_PER_HARMONIC * x, MEAN_PER_HARMONIC * y
    square = x * x + y * y
    if not square > CROWDED * CROWDED:
        return 0.0, 0.0
    part = min(1.0, STRONGEST / math.sqrt(square))
    return part * x, part * y


@inner
def without_lens(x: float, y: float, roots: Floats, counts: Ints) -> None:
    """Replaces roots psi by phi."""
    for kind in range(3):
        for i in range(counts[kind]):
            c, s, _ = through(x, y, math.cos(roots[kind, i]), math.sin(roots[kind, i]))
            roots[kind, i] = math.atan2(s, c)
