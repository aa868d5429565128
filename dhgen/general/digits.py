"""Constants of the generated code that belong to no arm, the same digits on every machine.

They are computed in decimal arithmetic and rounded once; a machine's own library may round the last
digit of a cosine differently.
"""

from __future__ import annotations

from decimal import Decimal, localcontext
from functools import cache

from dhgen.general.circle import CELLS, DEGREE, SAMPLES, sample_cosines

PRECISION = 50
HALF_CELLS = CELLS // 2


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
