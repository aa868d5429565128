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

from dhgen.kinematics.algebra import POSE_NAMES

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.kinematics.algebra import Algebra, AngleSum
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.pool import Pool

    Values = NDArray[np.float64]

COUNT = 4
OWN_LENGTHS = slice(0, COUNT, 2)  # witnesses with the arm's own lengths
RIGHT_ANGLES = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))  # cosine and sine
VANISHING = 1e-9  # of the sum of the sizes of a polynomial's terms


@dataclass(frozen=True, slots=True)
class Witnesses:
    """The values of every generator on every witness.

    Attributes:
        values: Shape (generators, COUNT).
    """

    algebra: Algebra
    values: Values
    _seen: dict[Polynomial, bool] = field(default_factory=dict)
    _values: dict[Polynomial, Values] = field(default_factory=dict)

    def evaluate(self, polynomial: Polynomial) -> Values:
        """The polynomial on every witness, shape (COUNT,)."""
        if polynomial not in self._values:
            self._values[polynomial] = np.sum(_terms(polynomial, self.values), axis=0)
        return self._values[polynomial]

    def vanishes(self, polynomial: Polynomial) -> bool:
        """Whether the polynomial is zero on any witness."""
        if not polynomial:
            return True
        if polynomial not in self._seen:
            terms = _terms(polynomial, self.values)
            sizes = np.sum(np.abs(terms), axis=0)
            small = np.abs(np.sum(terms, axis=0)) <= VANISHING * sizes
            self._seen[polynomial] = bool(np.any(small))
        return self._seen[polynomial]

    def varies(self, values: Values, sizes: Values) -> bool:
        """Whether a value is surely not made of the arm's lengths alone.

        Args:
            values: On every witness, shape (COUNT,).
            sizes: Of the terms that it is the sum of, shape (COUNT,).
        """
        own = values[OWN_LENGTHS]
        return bool(np.ptp(own) > VANISHING * np.max(sizes[OWN_LENGTHS]))

    def stays_positive(self, polynomial: Polynomial) -> bool:
        """Whether a sum of squares in cosines, sines and lengths is nowhere zero at right angles.

        Tried on every combination of multiples of pi/2, with random lengths, which is where the
        factors of a determinant vanish if they do. False when pose entries occur.
        """
        used = {p for monomial in polynomial for p, exponent in enumerate(monomial) if exponent}
        angles = [a for a in self.algebra.angles if used.intersection(self._places(a))]
        inner = {p for a in angles for p in self._places(a)}
        first = len(self.algebra.ring.gens) - len(self.algebra.chain.ring.gens)
        if any(place < first and place not in inner for place in used):
            return False
        for turns in product(RIGHT_ANGLES, repeat=len(angles)):
            values = self.values[:, 1:2].copy()
            for angle, turn in zip(angles, turns, strict=True):
                values[self._places(angle), 0] = turn
            terms = _terms(polynomial, values)
            if np.sum(terms) <= VANISHING * np.sum(np.abs(terms)):
                return False
        return True

    def _places(self, angle: AngleSum) -> list[int]:
        return [self.algebra.index[angle.cosine], self.algebra.index[angle.sine]]


def _terms(polynomial: Polynomial, values: Values) -> Values:
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
    witnesses = Witnesses(algebra, values)
    _add_pose(pool, witnesses)
    return witnesses


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
        entry = problem.forward.entry(int(name[1]) - 1, int(name[2]) - 1)
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
