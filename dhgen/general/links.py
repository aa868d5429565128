"""The links of an arm's loop: constant, or with joints inside that are held at a given value."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt
from typing import TYPE_CHECKING

from dhgen.kinematics.rigid import Matrix, along_z, dot, inverse, multiply, scaled, turn

if TYPE_CHECKING:
    from collections.abc import Sequence


@dataclass(frozen=True, slots=True)
class Value:
    """The angle, with its cosine and sine, or the length of a joint that is held."""

    value: float
    cosine: float
    sine: float


@dataclass(frozen=True, slots=True)
class Held:
    """A joint whose value the caller gives: about or along z by its angle or length.

    Attributes:
        place: Which of the values that are given, from 0.
        slides: Whether it is prismatic.
        factor: +1, or -1 where it is undone; of a slide in arm sizes the same over the arm's size.
    """

    place: int
    slides: bool
    factor: float

    def motion(self, given: Sequence[Value]) -> Matrix:
        """The joint's transform."""
        own = given[self.place]
        if self.slides:
            return along_z(self.factor * own.value)
        return turn(own.cosine, self.factor * own.sine)


@dataclass(frozen=True, slots=True)
class Link:
    """A rigid transform between two joints that are solved for.

    Attributes:
        first: What is constant before the first joint that is held, or all of it.
        rest: Every joint that is held, with the constant transform behind it.
    """

    first: Matrix
    rest: tuple[tuple[Held, Matrix], ...] = ()

    @property
    def constants(self) -> tuple[Matrix, ...]:
        """Its constant transforms, one after another."""
        return (self.first, *(behind for _, behind in self.rest))

    def at(self, given: Sequence[Value]) -> Matrix:
        """The transform for given joint values."""
        total = self.first
        for held, behind in self.rest:
            total = multiply(multiply(total, held.motion(given)), behind)
        return total

    def between(self, before: Matrix, after: Matrix) -> Link:
        """Before · link · after."""
        if not self.rest:
            return Link(multiply(multiply(before, self.first), after))
        *inner, (held, last) = self.rest
        return Link(multiply(before, self.first), (*inner, (held, multiply(last, after))))

    def inverse(self) -> Link:
        """The inverse transform."""
        backwards = [inverse(K) for K in reversed(self.constants)]
        held = [Held(h.place, h.slides, -h.factor) for h, _ in reversed(self.rest)]
        return Link(backwards[0], tuple(zip(held, backwards[1:], strict=True)))

    def scaled(self, factor: float) -> Link:
        """The loop with all lengths multiplied by a factor."""
        rest = tuple(
            (Held(h.place, h.slides, h.factor * (factor if h.slides else 1.0)), scaled(K, factor))
            for h, K in self.rest
        )
        return Link(scaled(self.first, factor), rest)

    @property
    def longest(self) -> float | None:
        """A bound of its length for every given value; None where a slide is held."""
        if any(held.slides for held, _ in self.rest):
            return None
        lengths = ([K[i][3] for i in range(3)] for K in self.constants)
        return sum(sqrt(dot(t, t)) for t in lengths)
