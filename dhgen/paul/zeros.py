"""Whether one function of the joints stays where another vanishes, by trying."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.paul.samples import terms_on

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial


TRIED = 40  # ways through the space of joints, of which some cross a zero
HALVINGS = 60
APART = 1e-3  # of its usual size: what is surely not zero where a zero is known to rounding


def outlasts(algebra: Algebra, other: Polynomial, first: Polynomial) -> bool:
    """Whether `other` is not zero everywhere where `first` is.

    Both are polynomials in cosines, sines and lengths. Zeros of `first` are found by halving ways
    between random configurations on which it changes its sign; the same ones at every run.
    """
    random = np.random.default_rng(29)
    low, high = random.uniform(-3.0, 3.0, (2, algebra.chain.dof, TRIED))
    usual = np.max(np.abs(_at(algebra, other, low)))
    start = _at(algebra, first, low)
    crossing = start * _at(algebra, first, high) < 0.0
    low, high, start = low[:, crossing], high[:, crossing], start[crossing]
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        same = _at(algebra, first, middle) * start > 0.0
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return bool(np.any(np.abs(_at(algebra, other, low)) > APART * usual))


def _at(algebra: Algebra, polynomial: Polynomial, q: FloatArray) -> FloatArray:
    """A polynomial on joint values of shape (dof, n)."""
    return np.asarray(terms_on(polynomial, values_at(algebra, q)).sum(axis=0))


def values_at(algebra: Algebra, q: FloatArray) -> FloatArray:
    """The generators of an arm but those of the pose, (generators, n).

    Args:
        algebra: The arm's ring.
        q: The angles and lengths that it sees, those in arm sizes, (dof, n).
    """
    values = np.zeros((len(algebra.ring.gens), q.shape[1]))
    for constant in algebra.chain.constants:
        values[algebra.index[constant.name]] = constant.value
    for angle in algebra.angles:
        total = sum((sign * q[joint - 1] for joint, sign in angle.terms), np.zeros(q.shape[1]))
        values[algebra.index[angle.cosine]] = np.cos(total)
        values[algebra.index[angle.sine]] = np.sin(total)
    for joint, name in algebra.slides.items():
        values[algebra.index[name]] = algebra.chain.size * q[joint - 1]
    return values
