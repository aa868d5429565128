"""Polynomials in the joints and the entries of their pose: where they vanish together.

Such places are found by trying: descents (Gauss-Newton, J. Nocedal and S. Wright, Numerical
Optimization, 2006, section 10.3) from random joint values, the same ones at every run.
"""

from __future__ import annotations

from itertools import chain
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.algebra import POSE_NAMES, POSE_PLACES, SHOULDER_NAMES
from dhgen.paul.samples import Sums, terms_on

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.pool import Pool


class PoseValues:
    """What the forward model of an arm gives; made ready once for many places."""

    def __init__(self, pool: Pool) -> None:
        """Reads the links, the points and the shoulder of an arm."""
        problem = pool.problem
        links = [problem.spans.product(place, place + 1) for place in range(len(problem.links))]
        points, base_points = pool.points, pool.base_points
        shoulder = () if pool.plane is None else pool.plane.rotation
        self._links = Sums(link.entry(*place) for link in links for place in POSE_PLACES.values())
        self._in_tool = Sums(chain.from_iterable(point.in_tool for point in points))
        self._in_base = Sums(chain.from_iterable(point.in_base for point in base_points))
        self._shoulder = Sums(chain.from_iterable(shoulder))
        names = chain(
            POSE_NAMES,
            *(point.names for point in points),
            *(point.names for point in base_points),
            *SHOULDER_NAMES[: len(shoulder)],
        )
        self._places = [problem.algebra.index[name] for name in names]

    def fill(self, values: FloatArray) -> None:
        """Puts them where they belong.

        Args:
            values: Of every generator, (generators, places); joints and lengths have theirs.
        """
        count = values.shape[1]
        T = self._forward(values)
        rotation, origin = T[:, :3, :3], T[:, :3, 3:]
        in_tool, in_base = (
            each(values).reshape(-1, 3, count).T for each in (self._in_tool, self._in_base)
        )
        found = (
            T[:, :3].reshape(count, -1).T,
            _columns(_times(rotation, in_tool) + origin),
            _columns(_times(rotation.swapaxes(1, 2), in_base - origin)),
            self._shoulder(values),
        )
        values[self._places] = np.concatenate(found)

    def _forward(self, values: FloatArray) -> FloatArray:
        """A_1 ... A_n, (places, 4, 4): its entries have many terms, those of links few."""
        links = self._links(values).reshape(-1, 3, 4, values.shape[1])
        T = np.broadcast_to(np.eye(4), (values.shape[1], 4, 4))
        for link in np.moveaxis(links, -1, 1):
            A = np.broadcast_to(np.eye(4), T.shape).copy()
            A[:, :3] = link
            T = _times(T, A)
        return T


def _columns(vectors: FloatArray) -> FloatArray:
    """Vectors (places, 3, n) below each other, (3 n, places)."""
    return vectors.T.reshape(-1, len(vectors))


def _times(first: FloatArray, second: FloatArray) -> FloatArray:
    """Products of matrices, (places, n, k), by sums whose order no machine's library chooses."""
    return np.asarray((first[..., None] * second[:, None]).sum(axis=2))


STARTS = 8
ITERATIONS = 40
LONGEST = 0.5  # of a descent's steps [rad or arm sizes]
DIFFERENCE = 1e-7  # of the joints, for slopes
NO_SLOPE = 1e-6  # of the steepest one: a direction that does not count
FLAT = 1e-5  # a slope in usual sizes that is one of rounding, or of differences
ZERO = 1e-12  # of their usual sizes


class Factors:
    """Some polynomials, in their usual sizes, as functions of angles and lengths (dof, n).

    Lengths count in arm sizes.
    """

    def __init__(self, pool: Pool, polynomials: Sequence[Polynomial]) -> None:
        """Makes them and the pose ready for many places."""
        self._algebra = pool.problem.algebra
        self._pose = PoseValues(pool)
        self._sums = Sums(polynomials)
        source, dof = np.random.default_rng(31), self._algebra.chain.dof
        self._starts, usual = source.uniform(-3.0, 3.0, (2, dof, STARTS))
        self._usual = np.max(np.abs(self._at(usual)), axis=1)

    def zeros(self) -> FloatArray:
        """Some places where all vanish, (dof, n)."""
        q = self._starts
        for _ in range(ITERATIONS):
            missed, slopes = self._with_slopes(q)
            if np.all(np.abs(missed) < ZERO):
                break
            step = (np.linalg.pinv(slopes, rcond=NO_SLOPE) @ missed[..., None])[..., 0]
            longest = np.abs(step).max(axis=1, keepdims=True)
            q = q - (step * np.minimum(1.0, LONGEST / np.maximum(longest, LONGEST))).T
        return np.asarray(q[:, np.all(np.abs(missed) < ZERO, axis=1)])

    def conditions(self, q: FloatArray) -> int:
        """How many conditions make them vanish: the least rank of slopes at zeros (dof, n)."""
        return int(np.linalg.matrix_rank(self._with_slopes(q)[1], tol=FLAT).min())

    def _with_slopes(self, q: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Values (n, polynomials) and their slopes (n, polynomials, dof)."""
        dof, places = q.shape
        aside = np.concatenate([np.zeros((dof, 1)), DIFFERENCE * np.eye(dof)], axis=1)
        around = (q[:, :, None] + aside[:, None]).reshape(dof, -1)
        values = (self._at(around) / self._usual[:, None]).reshape(len(self._usual), places, -1)
        slopes = (values[..., 1:] - values[..., :1]) / DIFFERENCE
        return values[..., 0].T, np.moveaxis(slopes, 1, 0)

    def _at(self, q: FloatArray) -> FloatArray:
        """Values (polynomials, n), as they are."""
        values = values_at(self._algebra, q)
        self._pose.fill(values)
        return self._sums(values)


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
    """The generators of an arm without the pose's, (generators, n).

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
