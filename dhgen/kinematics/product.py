"""Products of chain elements, in reduced form: angles of parallel axes appear as their sums.

Along a run of parallel axes the product is Rz(sum) C with a translation w, where C is constant
and keeps or reverses z; only where an axis turns away are matrices multiplied. The inverse of a
stretch of chain is the product of the inverse elements in reverse, so it is reduced in the same
way.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from dhgen.kinematics.chain import Fixed, Passive, Slide, Turn, added_up
from dhgen.kinematics.transform import (
    Transform,
    compose,
    dot,
    identity,
    inverse,
    rotation_z,
    turn_between,
)

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial


def reversed_elements(elements: Iterable[Element], algebra: Algebra) -> tuple[Element, ...]:
    """The elements of the inverse transform."""
    turned: list[Element] = []
    for element in reversed(tuple(elements)):
        match element:
            case Turn(joint, sign):
                turned.append(Turn(joint, -sign))
            case Slide(joint, sign):
                turned.append(Slide(joint, -sign))
            case Passive():
                turned.append(replace(element, sign=-element.sign))
            case Fixed(transform):
                turned.append(Fixed(inverse(transform, algebra.normal)))
    return tuple(turned)


def product(elements: Iterable[Element], algebra: Algebra) -> Transform:
    """The product of chain elements (their constants in the algebra's ring), in normal form."""
    scan = _Scan(algebra)
    for element in elements:
        scan.append(element)
    return scan.result()


@dataclass(frozen=True, slots=True)
class Spans:
    """Products of consecutive links A_1 ... A_n, none worked out twice.

    Attributes:
        links: The elements of every link, their constants in the algebra's ring.
        algebra: The ring.
    """

    links: tuple[tuple[Element, ...], ...]
    algebra: Algebra
    _products: dict[tuple[int, int], Transform] = field(default_factory=dict, compare=False)
    _inverses: dict[tuple[int, int], Transform] = field(default_factory=dict, compare=False)

    def product(self, m: int, k: int) -> Transform:
        """A_{m+1} ... A_k: frame k seen from frame m."""
        if (m, k) not in self._products:
            self._products[m, k] = product(self._elements(m, k), self.algebra)
        return self._products[m, k]

    def inverse(self, m: int, k: int) -> Transform:
        """(A_{m+1} ... A_k)^-1: frame m seen from frame k."""
        if (m, k) not in self._inverses:
            elements = reversed_elements(self._elements(m, k), self.algebra)
            self._inverses[m, k] = product(elements, self.algebra)
        return self._inverses[m, k]

    def _elements(self, m: int, k: int) -> list[Element]:
        return [element for link in self.links[m:k] for element in link]


class _Scan:
    """The product so far: prefix, then a run Rz(sum) `after` with translation `origin`."""

    def __init__(self, algebra: Algebra) -> None:
        self._algebra = algebra
        self._prefix: Transform | None = None
        self._begin(())

    def _begin(self, terms: tuple[tuple[int, int], ...]) -> None:
        still = identity(self._algebra.ring)
        self._terms = terms
        self._ends = False
        self._after = still.rotation
        self._origin = still.translation

    def append(self, element: Element) -> None:
        """One element more."""
        match element:
            case Turn(joint, sign):
                self._turn(((joint, sign),))
            case Slide(joint, sign):
                self._slide(((joint, sign),))
            case Passive() if element.apart and element.turns:
                self._begin_alone(element.signed)
            case Passive():
                (self._turn if element.turns else self._slide)(element.signed)
            case Fixed(transform):
                self._move(transform.translation)
                still = identity(self._algebra.ring)
                turned = Transform(self._after, still.translation)
                constant = Transform(transform.rotation, still.translation)
                self._after = compose(turned, constant, self._algebra.normal).rotation

    def _turn(self, terms: tuple[tuple[int, int], ...]) -> None:
        facing = 0 if self._ends else turn_between(self._after)
        if not facing:
            self._prefix = self.result()
            self._begin(terms)
        else:
            self._terms = added_up((*self._terms, *((j, sign * facing) for j, sign in terms)))

    def _begin_alone(self, terms: tuple[tuple[int, int], ...]) -> None:
        """An angle with a letter of its own, which is added to no other."""
        self._prefix = self.result()
        self._begin(terms)
        self._ends = True

    def _slide(self, terms: tuple[tuple[int, int], ...]) -> None:
        zero = self._algebra.ring.zero
        slides = ((self._algebra.generator(self._algebra.slides[j]), n) for j, n in terms)
        self._move((zero, zero, sum((length * times for length, times in slides), zero)))

    def _move(self, vector: tuple[Polynomial, ...]) -> None:
        if not any(vector):
            return
        algebra = self._algebra
        turned = tuple(dot(row, vector, algebra.normal) for row in self._after)
        turned = tuple(dot(row, turned, algebra.normal) for row in self._spin())
        self._origin = tuple(a + b for a, b in zip(self._origin, turned, strict=True))

    def _spin(self) -> tuple[tuple[Polynomial, ...], ...]:
        ring = self._algebra.ring
        if not self._terms:
            return identity(ring).rotation
        return rotation_z(ring, *self._algebra.cosine_sine(self._terms)).rotation

    def result(self) -> Transform:
        """The whole product."""
        still = identity(self._algebra.ring)
        normal = self._algebra.normal
        spin = Transform(self._spin(), still.translation)
        after = Transform(self._after, still.translation)
        run = Transform(compose(spin, after, normal).rotation, self._origin)
        return run if self._prefix is None else compose(self._prefix, run, normal)
