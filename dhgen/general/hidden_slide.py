"""A hidden slide: its length as an angle, and the determinant where the length is infinite.

A polynomial of degree 16 in a length d is one of degree 8 on the circle: with d = UNIT tan(ψ'/2)
and times cos^16(ψ'/2), or less where the degree is lower. The twelve rows of the determinant are of
degree two in d each, and give cos^24: what is too much is divided out, away from d = ∞, where none
of the angles that are sampled lies without a lens as long as ψ = ψ' − ADVANCE is the angle. Lenses
towards it lose digits, so that poses with the slide some arm sizes out may have no certificate.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray


UNIT = 2.5  # arm sizes; the length at a quarter of a turn, about how far slides go
# Cosine and sine: half of the way from one sample angle to the next, nearly.
ADVANCE = (112 / 113, 15 / 113)
# Half the order of the determinant's zero at d = ∞: four leave degree 8 on the circle, and eight
# the degree 4 of arms with eight solutions.
ORDERS = (8, 7, 6, 5, 4)


def stand_in(length: float) -> tuple[float, float]:
    """Cosine and sine of the angle ψ that represents d [arm sizes]."""
    x = length / UNIT
    c, s = ADVANCE
    cosine, sine = (1.0 - x * x) / (1.0 + x * x), 2.0 * x / (1.0 + x * x)
    return cosine * c + sine * s, sine * c - cosine * s


def nearness(cosine: FloatArray, sine: FloatArray) -> FloatArray:
    """1 + cos ψ' from cosine and sine of ψ: what vanishes where d is infinite."""
    c, s = ADVANCE
    return 1.0 + c * cosine - s * sine
