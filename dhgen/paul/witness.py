"""Witnesses: random configurations on which every equation of the pool is true.

A rule may fire only if its coefficients do not vanish on them. Half keep the arm's own lengths,
half take random ones, so that neither a coincidence of lengths nor of angles decides.
"""

from __future__ import annotations

import random
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain, product
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.algebra import POSE_NAMES, SHOULDER_NAMES
from dhgen.paul.common_zeros import PoseValues
from dhgen.paul.samples import Samples, terms_on

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.algebra import Algebra, AngleSum
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.form import Form
    from dhgen.paul.pool import Pool


COUNT = 4
LOOSE = 2
OWN_LENGTHS = slice(0, COUNT, 2)  # witnesses with the arm's own lengths
RANDOM_LENGTHS = slice(1, COUNT, 2)  # and the others
RIGHT_ANGLES = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))  # cosine and sine
VANISHING = 1e-9  # of the sum of the sizes of a polynomial's terms


@dataclass(frozen=True, slots=True)
class Witnesses:
    """What polynomials are on every witness.

    Attributes:
        algebra: The arm's ring.
        samples: The values of every generator on the COUNT witnesses.
        loose: The same with the arm's own lengths and a pose that is no pose, LOOSE times: what is
            constant here is so as a polynomial.
    """

    algebra: Algebra
    samples: Samples
    loose: Samples

    def evaluate(self, polynomial: Polynomial) -> FloatArray:
        """The polynomial on every witness, shape (COUNT,)."""
        return self.samples.value(polynomial)

    def learn(self, forms: Iterable[Form]) -> None:
        """Works out the coefficients of many forms together, before they are asked for."""
        each_once = {id(form): form for form in forms}.values()
        self.samples.learn(chain.from_iterable(form.terms.values() for form in each_once))
        single = (form.terms.items() for form in each_once if len(form.unknowns) == 1)
        self.loose.learn(factor for terms in single for unknown, factor in terms if unknown)

    def largest(self, factors: Sequence[Polynomial], among: slice, unit: float) -> float:
        """The largest that the factors of one equation are on some witnesses, lengths in a unit."""
        found = (self.samples.numbers(factor)[0][among] for factor in factors)
        largest = max(abs(value) for values in found for value in values)
        return largest / unit ** self.algebra.degree(*factors)

    def vanishes(self, polynomial: Polynomial) -> bool:
        """Whether the polynomial is zero on any witness."""
        values, sizes = self.samples.numbers(polynomial)
        return any(map(is_rounding, values, sizes))

    def surely_varies(self, products: Iterable[tuple[int, Polynomial, Polynomial]]) -> bool:
        """Whether the sum of n f g is surely not made of the arm's lengths alone."""
        totals, sizes = [0.0] * LOOSE, [0.0] * LOOSE
        for n, f, g in products:
            if f and g:
                first, second = self.loose.numbers(f)[0], self.loose.numbers(g)[0]
                for place in range(LOOSE):
                    part = n * first[place] * second[place]
                    totals[place] += part
                    sizes[place] += abs(part)
        return max(totals) - min(totals) > VANISHING * max(sizes)

    def sum_vanishes(self, products: Iterable[tuple[int, Polynomial, Polynomial]]) -> bool:
        """Whether the sum of n f g is zero on any witness, without multiplying it out."""
        return any(self._are_zero(products))

    def sum_vanishes_always(self, products: Iterable[tuple[int, Polynomial, Polynomial]]) -> bool:
        """Whether it is zero on every witness."""
        return all(self._are_zero(products))

    def _are_zero(self, products: Iterable[tuple[int, Polynomial, Polynomial]]) -> list[bool]:
        totals, sizes = [0.0] * COUNT, [0.0] * COUNT
        for n, f, g in products:
            if f and g:
                (first, most), (second, most_too) = self.samples.numbers(f), self.samples.numbers(g)
                for place in range(COUNT):
                    totals[place] += n * first[place] * second[place]
                    sizes[place] += abs(n) * most[place] * most_too[place]
        return list(map(is_rounding, totals, sizes))

    def have_no_common_zero(self, *polynomials: Polynomial) -> bool:
        """Whether polynomials in cosines, sines and lengths have no common zero at right angles.

        Tried on every combination of multiples of pi/2, with random lengths, which is where the
        factors of a determinant vanish if they do. False when pose entries occur.
        """
        used = {
            place
            for polynomial in polynomials
            for monomial in polynomial
            for place, exponent in enumerate(monomial)
            if exponent
        }
        angles = [a for a in self.algebra.angles if used.intersection(self._places(a))]
        inner = {p for a in angles for p in self._places(a)}
        first = len(self.algebra.ring.gens) - len(self.algebra.chain.ring.gens)
        if any(place < first and place not in inner for place in used):
            return False
        corners = np.array(list(product(RIGHT_ANGLES, repeat=len(angles))))
        values = np.repeat(self.samples.values[:, 1:2], len(corners), axis=1)
        for number, angle in enumerate(angles):
            values[self._places(angle)] = corners[:, number].T
        common = np.ones(len(corners), dtype=bool)
        for polynomial in polynomials:
            terms = terms_on(polynomial, values)
            common &= np.abs(terms.sum(axis=0)) <= VANISHING * np.abs(terms).sum(axis=0)
        return not common.any()

    def _places(self, angle: AngleSum) -> list[int]:
        return [self.algebra.index[angle.cosine], self.algebra.index[angle.sine]]


def is_rounding(value: float, size: float) -> bool:
    """Whether a sum is zero but for rounding, the sizes of its terms adding up to so much."""
    return abs(value) <= VANISHING * size


def build_witnesses(pool: Pool) -> Witnesses:
    """Random configurations of an arm; equal at every run."""
    algebra = pool.problem.algebra
    source = random.Random(20)  # noqa: S311 - configurations, not secrets
    values = np.zeros((len(algebra.ring.gens), COUNT))
    for column in range(COUNT):
        own = column in range(COUNT)[OWN_LENGTHS]
        named = _lengths(algebra, source, own=own) | _joints(algebra, source)
        for name, value in named.items():
            values[algebra.index[name], column] = value
    PoseValues(pool).fill(values)
    return Witnesses(algebra, Samples(values), Samples(_loose(algebra, source)))


def _loose(algebra: Algebra, source: random.Random) -> FloatArray:
    values = np.zeros((len(algebra.ring.gens), LOOSE))
    for column in range(LOOSE):
        named = {name: source.uniform(-1.0, 1.0) for name in (*POSE_NAMES, *algebra.coordinates)}
        named |= _lengths(algebra, source, own=True) | _joints(algebra, source)
        if algebra.chain.arm_angle:
            named |= {name: source.uniform(-1.0, 1.0) for row in SHOULDER_NAMES for name in row}
        for name, value in named.items():
            values[algebra.index[name], column] = value
    return values


def _lengths(algebra: Algebra, source: random.Random, *, own: bool) -> dict[str, float]:
    drawn = {}
    for constant in algebra.chain.constants:
        value = float(Fraction(source.randint(200, 900), 1000)) * (algebra.chain.size / 2)
        drawn[constant.name] = constant.value if own or not constant.is_length else value
    return drawn


def _joints(algebra: Algebra, source: random.Random) -> dict[str, float]:
    half = {j.number: source.randint(-900, 900) / 500 for j in algebra.chain.joints}
    turns = {j: complex(1 - t * t, 2 * t) / (1 + t * t) for j, t in half.items()}
    drawn = {}
    for angle in algebra.angles:
        turn = _turn(angle, turns)
        drawn[angle.cosine], drawn[angle.sine] = turn.real, turn.imag
    for joint, name in algebra.slides.items():
        drawn[name] = algebra.chain.size * (half[joint] / 2 + 2)
    return drawn


def _turn(angle: AngleSum, turns: dict[int, complex]) -> complex:
    result = complex(1, 0)
    for joint, sign in angle.terms:
        result *= turns[joint] if sign > 0 else turns[joint].conjugate()
    return result
