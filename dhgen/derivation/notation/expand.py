"""Sums of angles written out: c12 becomes c1 c2 - s1 s2 (document 003, expanded form)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import single
from dhgen.kinematics.ring import substitute

if TYPE_CHECKING:
    from dhgen.kinematics.algebra import Algebra, AngleSum
    from dhgen.kinematics.constants import Polynomial


def expanded(algebra: Algebra, polynomial: Polynomial) -> Polynomial:
    """The polynomial with cosines and sines of single joints only."""
    change: dict[int, Polynomial] = {}
    for angle in algebra.angles:
        if len(angle.terms) > 1:
            cosine, sine = of_single(algebra, angle)
            change[algebra.index[angle.cosine]] = cosine
            change[algebra.index[angle.sine]] = sine
    return algebra.normal(substitute(polynomial, change)) if change else polynomial


def of_single(algebra: Algebra, angle: AngleSum) -> tuple[Polynomial, Polynomial]:
    """Cosine and sine of an angle sum by those of its joints."""
    cosine, sine = algebra.ring.one, algebra.ring.zero
    for joint, sign in angle.terms:
        c = algebra.generator(single(joint).cosine)
        s = sign * algebra.generator(single(joint).sine)
        cosine, sine = cosine * c - sine * s, sine * c + cosine * s
    return cosine, sine
