"""Constants of the generated code that belong to no arm, the same digits on every machine.

They are computed in decimal arithmetic and rounded once; a machine's own library may round the last
digit of a cosine differently.
"""

from __future__ import annotations

from decimal import Decimal, localcontext
from fractions import Fraction
from functools import cache

from dhgen.general.circle import CELLS, DEGREE, SAMPLES, sample_cosines

PRECISION = 50
HALF_CELLS = CELLS // 2
ARCTANGENT_TERMS = 13  # atan r = r + r³ p(r²) for |r| ≤ tan(π/8): 1e-17 with this many


@cache
def grid() -> tuple[tuple[tuple[float, ...], ...], tuple[tuple[float, ...], ...]]:
    """cos mφ and sin mφ, m = 1 ... 8, at φ = 2πi/256 for i = 0 ... 127: (8, 128) each."""
    circle = _circle()
    cosines, sines = [], []
    for m in range(1, DEGREE + 1):
        turns = [circle[m * i % CELLS] for i in range(HALF_CELLS)]
        cosines.append(tuple(float(c) for c, _ in turns))
        sines.append(tuple(float(s) for _, s in turns))
    return tuple(cosines), tuple(sines)


def _circle() -> list[tuple[Decimal, Decimal]]:
    """Cosine and sine of 2πi/256."""
    with localcontext() as context:
        context.prec = PRECISION
        cosine = Decimal(0)
        angles = 4
        while angles < CELLS:  # from a quarter turn, halved six times
            cosine = ((1 + cosine) / 2).sqrt()
            angles *= 2
        sine = (1 - cosine * cosine).sqrt()
        quarter = [(Decimal(1), Decimal(0))]
        for _ in range(CELLS // 4 - 1):
            c, s = quarter[-1]
            quarter.append((c * cosine - s * sine, s * cosine + c * sine))
        turned = [(-s, c) for c, s in quarter]
        half = quarter + turned
        return half + [(-c, -s) for c, s in half]


@cache
def harmonics() -> tuple[tuple[float, ...], ...]:
    """From 24 samples to a0, a1 ... a8, b1 ... b8 and the harmonics 9, 10, 11 with cosine 12.

    One row of 24 for each sample.
    """
    cosines, sines = sample_cosines()
    rows = []
    for k in range(SAMPLES):
        row = [1.0 / SAMPLES]
        row += [cosines[m * k % SAMPLES] / 12.0 for m in range(1, 9)]
        row += [sines[m * k % SAMPLES] / 12.0 for m in range(1, 9)]
        row += [cosines[m * k % SAMPLES] / 12.0 for m in range(9, 13)]
        row += [sines[m * k % SAMPLES] / 12.0 for m in range(9, 12)]
        rows.append(tuple(row))
    return tuple(rows)


@cache
def arctangent() -> tuple[float, ...]:
    """The coefficients of p in atan r = r + r³ p(r²), for |r| ≤ tan(π/8).

    p interpolates (atan √u − √u) / u^(3/2) at Chebyshev's nodes in exact arithmetic.
    """
    n = ARCTANGENT_TERMS
    top = Fraction(1716, 10000)  # tan²(π/8)
    # the nodes may be rounded: only the interpolation has to be exact
    circle = _circle()
    nodes = []
    for i in range(n):
        angle = round((2 * i + 1) * CELLS / (4 * n))
        nodes.append(top / 2 * (1 + Fraction(round(float(circle[angle][0]), 6))))
    differences = [_arctangent_part(u) for u in nodes]
    for step in range(1, n):
        for i in reversed(range(step, n)):
            differences[i] = (differences[i] - differences[i - 1]) / (nodes[i] - nodes[i - step])
    coefficients = [Fraction(0)] * n
    for node, difference in zip(reversed(nodes), reversed(differences), strict=True):
        shifted = [Fraction(0), *coefficients[:-1]]
        coefficients = [s - node * c for s, c in zip(shifted, coefficients, strict=True)]
        coefficients[0] += difference
    return tuple(float(c) for c in coefficients)


def _arctangent_part(u: Fraction) -> Fraction:
    """Σ (−1)^(k+1) u^k / (2k + 3), until it no longer matters."""
    total, power = Fraction(0), Fraction(1)
    for k in range(40):
        total += (-1) ** (k + 1) * power / (2 * k + 3)
        power *= u
    return total
