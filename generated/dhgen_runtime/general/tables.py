# SPDX-License-Identifier: MIT
"""Numbers that belong to no arm, with the same digits on every machine.

Cosines and sines are computed in decimal arithmetic and rounded once; a machine's own library may
round the last digit of a cosine differently.
"""

from __future__ import annotations

from decimal import Decimal, localcontext
from functools import cache
from math import pi, sqrt
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from ..arrays import Floats

DEGREE = 8  # of a trigonometric polynomial: it has twice as many roots
SAMPLES = 24  # 17 determine f; the harmonics beyond the eighth measure the rounding
CELLS = 256  # of the circle, in which roots are looked for
HALF_CELLS = CELLS // 2
WIDTH = 2 * pi / CELLS
PRECISION = 50  # decimal digits

# How far [rad, arm sizes], and where to, a pose is moved when the formulations fail: where roots
# crowd, they come apart only at some distance.
NUDGE_LENGTHS = (1e-3, 3e-3, 1e-2, 3e-2, 3e-2)
NUDGE_DIRECTIONS = (
    (0.41, -0.37, 0.29, 0.53, 0.71, -0.47),
    (-0.23, 0.43, 0.31, -0.61, 0.29, 0.67),
    (0.39, 0.33, -0.45, 0.59, -0.43, 0.31),
    (-0.47, 0.27, -0.35, 0.37, 0.61, 0.57),
    (0.33, 0.49, 0.23, -0.51, -0.67, 0.41),
)
# Where the iteration for null vectors starts: anything that none is orthogonal to.
STARTS = np.array([[0.61, -0.37, 0.53, 0.29, 0.71, -0.43], [-0.31, 0.47, 0.59, 0.67, -0.23, 0.41]])


@cache
def sample_cosines() -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Returns cosines and sines of the 24 sample angles 2 pi k / 24, from square roots alone."""
    quarter = (
        (1.0, 0.0),
        ((sqrt(6.0) + sqrt(2.0)) / 4, (sqrt(6.0) - sqrt(2.0)) / 4),
        (sqrt(3.0) / 2, 0.5),
        (sqrt(0.5), sqrt(0.5)),
        (0.5, sqrt(3.0) / 2),
        ((sqrt(6.0) - sqrt(2.0)) / 4, (sqrt(6.0) + sqrt(2.0)) / 4),
    )
    around = []
    for quadrant in range(4):
        for c, s in quarter:
            around.append(((c, s), (-s, c), (-c, -s), (s, -c))[quadrant])
    cosines, sines = zip(*around, strict=True)
    return cosines, sines


def _circle() -> list[tuple[Decimal, Decimal]]:
    """Returns cosine and sine of 2 pi i / 256."""
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


def _grid() -> tuple[Floats, Floats]:
    """Returns cos m phi and sin m phi, m = 1 ... 8, at phi = 2 pi i / 256 for i = 0 ... 127."""
    circle = _circle()
    turns = [[circle[m * i % CELLS] for i in range(HALF_CELLS)] for m in range(1, DEGREE + 1)]
    cosines = [[float(c) for c, _ in row] for row in turns]
    sines = [[float(s) for _, s in row] for row in turns]
    return np.array(cosines), np.array(sines)


def _harmonics(cosines: tuple[float, ...], sines: tuple[float, ...]) -> Floats:
    """Returns the matrix from samples to a0, a1 ... a8, b1 ... b8 and seven harmonics beyond.

    These are a9, a10, a11, a12, b9, b10, b11 and would be zero without rounding. One row of 24 for
    each sample.
    """
    rows = []
    for k in range(SAMPLES):
        row = [1.0 / SAMPLES]
        row += [cosines[m * k % SAMPLES] / 12.0 for m in range(1, 9)]
        row += [sines[m * k % SAMPLES] / 12.0 for m in range(1, 9)]
        row += [cosines[m * k % SAMPLES] / 12.0 for m in range(9, 13)]
        row += [sines[m * k % SAMPLES] / 12.0 for m in range(9, 12)]
        rows.append(row)
    return np.array(rows)


def _nudge(x: float, y: float, z: float, t: tuple[float, ...]) -> tuple[float, ...]:
    """Returns twelve numbers: the rotation of the quaternion (1, x, y, z), and a translation."""
    n = 1.0 + x * x + y * y + z * z
    return (
        *(1 - 2 * (y * y + z * z) / n, 2 * (x * y - z) / n, 2 * (x * z + y) / n, t[0]),
        *(2 * (x * y + z) / n, 1 - 2 * (x * x + z * z) / n, 2 * (y * z - x) / n, t[1]),
        *(2 * (x * z - y) / n, 2 * (y * z + x) / n, 1 - 2 * (x * x + y * y) / n, t[2]),
    )


def _nudges() -> Floats:
    """Returns small motions of growing size, there and back, twelve numbers each."""
    return np.array(
        [
            _nudge(size * a, size * b, size * c, (size * x, size * y, size * z))
            for distance, (a, b, c, x, y, z) in zip(NUDGE_LENGTHS, NUDGE_DIRECTIONS, strict=True)
            for size in (distance, -distance)
        ]
    )


COSINES, SINES = sample_cosines()
SAMPLE_C, SAMPLE_S = np.array(COSINES), np.array(SINES)
HARMONICS = _harmonics(COSINES, SINES)
GRID_C, GRID_S = _grid()
NUDGES = _nudges()
