"""Where the coefficients of the runtime's arctangent come from.

It is a polynomial without branches, the same in every language.

With L the longer and S the shorter of |x| and |y|, r = S / L, or (S - L) / (S + L) where S / L is
above tan(pi/8), so that |r| <= tan(pi/8) always; then atan r = r + r u p(u), u = r^2, moved by a
multiple of an eighth of a turn with few roundings: the error is below 3 units in the last place
(tests). NaN gives NaN, signed zeros give what C's atan2 gives; infinite
arguments do not occur.
"""

from __future__ import annotations

import math
from fractions import Fraction
from functools import cache

TERMS = 11  # the polynomial then misses by 7e-18 of the angle
_TOP = Fraction(1716, 10000)  # above tan^2(pi/8)
STEEP = math.sqrt(2.0) - 1.0  # tan(pi/8)


@cache
def arctangent_coefficients() -> tuple[float, ...]:
    """The coefficients of p in atan r = r + r u p(u), lowest power first.

    p interpolates (atan sqrt(u) - sqrt(u)) / u^(3/2) at Chebyshev's nodes in exact arithmetic: the
    same digits on every machine.
    """
    # the nodes may be rounded: only the interpolation has to be exact
    angles = [(2 * i + 1) * math.pi / (2 * TERMS) for i in range(TERMS)]
    nodes = [_TOP / 2 * (1 + Fraction(round(math.cos(angle), 6))) for angle in angles]
    differences = [_wanted(u) for u in nodes]
    for step in range(1, TERMS):
        for i in reversed(range(step, TERMS)):
            differences[i] = (differences[i] - differences[i - 1]) / (nodes[i] - nodes[i - step])
    coefficients = [Fraction(0)] * TERMS
    for node, difference in zip(reversed(nodes), reversed(differences), strict=True):
        shifted = [Fraction(0), *coefficients[:-1]]
        coefficients = [s - node * c for s, c in zip(shifted, coefficients, strict=True)]
        coefficients[0] += difference
    return tuple(float(c) for c in coefficients)


def _wanted(u: Fraction) -> Fraction:
    """The series (-1)^(k+1) u^k / (2k + 3), until it no longer matters."""
    total, power = Fraction(0), Fraction(1)
    for k in range(40):
        total += (-1) ** (k + 1) * power / (2 * k + 3)
        power *= u
    return total
