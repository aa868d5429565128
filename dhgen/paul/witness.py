"""Witnesses: random configurations on which every equation of the pool is true.

A rule may fire only if its coefficients do not vanish on them. Half keep the arm's own lengths,
half take random ones, so that neither a coincidence of lengths nor of angles decides.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.algebra import POINT_NAMES, POSE_NAMES, POSE_PLACES, SHOULDER_NAMES

if TYPE_CHECKING:
    from collections.abc import Iterable

    from numpy.typing import NDArray

    from dhgen.kinematics.algebra import Algebra, AngleSum
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.pool import Pool

    Values = NDArray[np.float64]

COUNT = 4
LOOSE = 2
OWN_LENGTHS = slice(0, COUNT, 2)  # witnesses with the arm's own lengths
RIGHT_ANGLES = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))  # cosine and sine
VANISHING = 1e-9  # of the sum of the sizes of a polynomial's terms


@dataclass(frozen=True, slots=True)
class Witnesses:
    """The values of every generator on every witness.

    Attributes:
        values: Shape (generators, COUNT).
        loose: The same with the arm's own lengths and a pose that is no pose: what is constant
            here is so as a polynomial. Shape (generators, LOOSE).
    """

    algebra: Algebra
    values: Values
    loose: Values
    _seen: dict[Polynomial, bool] = field(default_factory=dict)
    _values: dict[Polynomial, Values] = field(default_factory=dict)
    _sizes: dict[Polynomial, Values] = field(default_factory=dict)
    _loose_values: dict[Polynomial, Values] = field(default_factory=dict)

    def evaluate(self, polynomial: Polynomial) -> Values:
        """The polynomial on every witness, shape (COUNT,)."""
        if polynomial not in self._values:
            self._values[polynomial] = np.sum(terms_on(polynomial, self.values), axis=0)
        return self._values[polynomial]

    def vanishes(self, polynomial: Polynomial) -> bool:
        """Whether the polynomial is zero on any witness."""
        if not polynomial:
            return True
        if polynomial not in self._seen:
            terms = terms_on(polynomial, self.values)
            sizes = np.sum(np.abs(terms), axis=0)
            small = np.abs(np.sum(terms, axis=0)) <= VANISHING * sizes
            self._seen[polynomial] = bool(np.any(small))
        return self._seen[polynomial]

    def surely_varies(self, products: Iterable[tuple[int, Polynomial, Polynomial]]) -> bool:
        """Whether the sum of n f g is surely not made of the arm's lengths alone."""
        total, sizes = np.zeros(LOOSE), np.zeros(LOOSE)
        for n, f, g in products:
            part = n * self._loosely(f) * self._loosely(g)
            total += part
            sizes += np.abs(part)
        return bool(np.ptp(total) > VANISHING * np.max(sizes))

    def _loosely(self, polynomial: Polynomial) -> Values:
        """The polynomial where the pose belongs to no configuration, shape (LOOSE,)."""
        if polynomial not in self._loose_values:
            self._loose_values[polynomial] = np.sum(terms_on(polynomial, self.loose), axis=0)
        return self._loose_values[polynomial]

    def sum_vanishes(self, products: Iterable[tuple[int, Polynomial, Polynomial]]) -> bool:
        """Whether the sum of n f g is zero on any witness, without multiplying it out."""
        total, sizes = np.zeros(COUNT), np.zeros(COUNT)
        for n, f, g in products:
            total += n * self.evaluate(f) * self.evaluate(g)
            sizes += abs(n) * self._size(f) * self._size(g)
        return bool(np.any(np.abs(total) <= VANISHING * sizes))

    def _size(self, polynomial: Polynomial) -> Values:
        """The sum of the sizes of a polynomial's terms on every witness."""
        if polynomial not in self._sizes:
            self._sizes[polynomial] = np.sum(np.abs(terms_on(polynomial, self.values)), axis=0)
        return self._sizes[polynomial]

    def stay_apart(self, *polynomials: Polynomial) -> bool:
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
        values = np.repeat(self.values[:, 1:2], len(corners), axis=1)
        for number, angle in enumerate(angles):
            values[self._places(angle)] = corners[:, number].T
        common = np.ones(len(corners), dtype=bool)
        for polynomial in polynomials:
            terms = terms_on(polynomial, values)
            common &= np.abs(terms.sum(axis=0)) <= VANISHING * np.abs(terms).sum(axis=0)
        return not common.any()

    def _places(self, angle: AngleSum) -> list[int]:
        return [self.algebra.index[angle.cosine], self.algebra.index[angle.sine]]


def terms_on(polynomial: Polynomial, values: Values) -> Values:
    """Every term on every column of `values`, shape (terms, columns)."""
    exponents = np.array(list(polynomial), dtype=np.int64).reshape(-1, len(values))
    factors = [int(c.numerator) / int(c.denominator) for c in polynomial.values()]
    used = np.flatnonzero(exponents.any(axis=0))
    powers = values[used] ** exponents[:, used, None]
    return np.asarray(np.array(factors)[:, None] * powers.prod(axis=1))


def build_witnesses(pool: Pool) -> Witnesses:
    """Random configurations of an arm; the same ones at every run."""
    algebra = pool.problem.algebra
    source = random.Random(20)  # noqa: S311 - configurations, not secrets
    values = np.zeros((len(algebra.ring.gens), COUNT))
    for column in range(COUNT):
        own = column in range(COUNT)[OWN_LENGTHS]
        named = _lengths(algebra, source, own=own) | _joints(algebra, source)
        for name, value in named.items():
            values[algebra.index[name], column] = value
    witnesses = Witnesses(algebra, values, _loose(algebra, source))
    _add_pose(pool, witnesses)
    return witnesses


def _loose(algebra: Algebra, source: random.Random) -> Values:
    values = np.zeros((len(algebra.ring.gens), LOOSE))
    for column in range(LOOSE):
        named = {name: source.uniform(-1.0, 1.0) for name in (*POSE_NAMES, *POINT_NAMES)}
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


def _add_pose(pool: Pool, witnesses: Witnesses) -> None:
    """U_0 and the named points, from the forward model."""
    problem = pool.problem
    index = problem.algebra.index
    for name in POSE_NAMES:
        entry = problem.forward.entry(*POSE_PLACES[name])
        witnesses.values[index[name]] = witnesses.evaluate(entry)
    for point in pool.points:
        for row, name in enumerate(point.names):
            place = sum(
                witnesses.evaluate(problem.forward.entry(row, column))
                * witnesses.evaluate(point.in_tool[column])
                for column in range(3)
            )
            witnesses.values[index[name]] = place + witnesses.evaluate(
                problem.forward.entry(row, 3)
            )
    if pool.plane is not None:
        for names, entries in zip(SHOULDER_NAMES, pool.plane.rotation, strict=True):
            for name, entry in zip(names, entries, strict=True):
                witnesses.values[index[name]] = witnesses.evaluate(entry)
    for base_point in pool.base_points:
        offset = [
            witnesses.evaluate(base_point.in_base[row])
            - witnesses.evaluate(problem.forward.entry(row, 3))
            for row in range(3)
        ]
        for column, name in enumerate(base_point.names):
            witnesses.values[index[name]] = sum(
                witnesses.evaluate(problem.forward.entry(row, column)) * offset[row]
                for row in range(3)
            )
