"""Equations as they look at one point of a derivation: linear in one or two unknowns.

What is known (pose, lengths, solved joints) goes into the coefficients; the unknowns of a run of
parallel axes are written by their representatives, so that c23 with theta2 known counts as theta3.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.knowledge import Knowledge
    from dhgen.paul.pool import Equation, Pool

MOST_UNKNOWNS = 2


@dataclass(frozen=True, slots=True, order=True)
class Length:
    """The unknown of a prismatic joint."""

    joint: int
    name: str


Unknown = AngleSum | Length
Monomial = tuple[str, ...]  # names of unknown generators, e.g. ("c2", "r3"); () is the constant


@dataclass(frozen=True, slots=True)
class Form:
    """An equation, sum of coefficient times unknown monomial = 0.

    Attributes:
        equation: Where it comes from.
        unknowns: At most two, in the order of the joints.
        terms: The coefficient of every unknown monomial.
    """

    equation: Equation
    unknowns: tuple[Unknown, ...]
    terms: Mapping[Monomial, Polynomial]

    @property
    def only_angle(self) -> AngleSum | None:
        """The unknown, when it is one angle sum."""
        match self.unknowns:
            case (AngleSum() as angle,):
                return angle
        return None

    @property
    def only_length(self) -> Length | None:
        """The unknown, when it is one length."""
        match self.unknowns:
            case (Length() as length,):
                return length
        return None

    @property
    def angle_and_length(self) -> tuple[AngleSum, Length] | None:
        """The unknowns, when they are an angle sum and a length."""
        match self.unknowns:
            case (AngleSum() as angle, Length() as length):
                return angle, length
        return None

    @property
    def two_angles(self) -> tuple[AngleSum, AngleSum] | None:
        """The unknowns, when they are two angle sums."""
        match self.unknowns:
            case (AngleSum() as first, AngleSum() as second):
                return first, second
        return None

    def coefficient(self, *names: str) -> Polynomial:
        """The coefficient of a monomial, zero if it does not occur."""
        return self.terms.get(tuple(sorted(names)), self.equation.difference.ring.zero)

    def within(self, allowed: Iterable[Monomial]) -> bool:
        """Whether no other monomials occur."""
        return set(self.terms) <= {tuple(sorted(monomial)) for monomial in allowed}


class FormReader:
    """Reads the pool at any state of knowledge."""

    def __init__(self, pool: Pool) -> None:
        algebra = pool.problem.algebra
        self._pool = pool
        self._angle_of: dict[int, AngleSum] = {}
        self._slide_of: dict[int, Length] = {}
        for angle in algebra.angles:
            self._angle_of[algebra.index[angle.cosine]] = angle
            self._angle_of[algebra.index[angle.sine]] = angle
        for joint, name in algebra.slides.items():
            self._slide_of[algebra.index[name]] = Length(joint, name)
        self._seen: dict[object, Form] = {}
        self._unknown_places = sorted([*self._angle_of, *self._slide_of])
        self._used = [
            frozenset(p for p in self._unknown_places if any(m[p] for m in e.difference))
            for e in pool.equations
        ]

    def forms(self, knowledge: Knowledge) -> list[Form]:
        """Every equation with one or two unknowns, rewritten; in the order of the pool."""
        names: dict[AngleSum, AngleSum | None] = {}
        for angle in self._angle_of.values():
            names[angle] = None if knowledge.knows(angle) else knowledge.representative(angle)
        found = []
        for equation, used in zip(self._pool.equations, self._used, strict=True):
            unknowns = self._unknowns(used, names, knowledge)
            if 0 < len(unknowns) <= MOST_UNKNOWNS:
                found.append(self._seen_form(equation, unknowns, used, names, knowledge))
        return found

    def _seen_form(
        self,
        equation: Equation,
        unknowns: tuple[Unknown, ...],
        used: frozenset[int],
        names: Mapping[AngleSum, AngleSum | None],
        knowledge: Knowledge,
    ) -> Form:
        """The form, made once for all states at which the equation looks the same."""
        angles = tuple(names[self._angle_of[p]] for p in sorted(used) if p in self._angle_of)
        key = (id(equation), unknowns, angles)
        if key not in self._seen:
            self._seen[key] = self._form(equation, unknowns, used, names, knowledge)
        return self._seen[key]

    def _unknowns(
        self,
        used: frozenset[int],
        names: Mapping[AngleSum, AngleSum | None],
        knowledge: Knowledge,
    ) -> tuple[Unknown, ...]:
        angles = {names[self._angle_of[p]] for p in used if p in self._angle_of} - {None}
        slides = {self._slide_of[p] for p in used if p in self._slide_of}
        open_slides = {slide for slide in slides if slide.joint not in knowledge.slides}
        return (*sorted(a for a in angles if a), *sorted(open_slides))

    def _form(
        self,
        equation: Equation,
        unknowns: tuple[Unknown, ...],
        used: frozenset[int],
        names: Mapping[AngleSum, AngleSum | None],
        knowledge: Knowledge,
    ) -> Form:
        """Rewrites where two angle sums stand for one unknown, then collects.

        A lone angle sum stays as the file's frames gave it (theta12, not theta2 with theta1 known):
        fewer products, and the reader finds the equation as it stands in U_i.
        """
        difference = equation.difference
        in_use = {self._angle_of[p] for p in used if p in self._angle_of}
        open_angles = sorted(a for a in in_use if names[a] is not None)
        crowded = {
            names[a] for a in open_angles if sum(names[b] == names[a] for b in open_angles) > 1
        }
        final: list[Unknown] = [u for u in unknowns if isinstance(u, Length)]
        for angle in open_angles:
            if names[angle] in crowded:
                difference = self._rewrite(difference, angle, knowledge)
        kept = {names[a] if names[a] in crowded else a for a in open_angles}
        angles = sorted(a for a in kept if a is not None)
        places = {
            p
            for p in self._unknown_places
            if (p in self._angle_of and names[self._angle_of[p]] is not None)
            or (p in self._slide_of and self._slide_of[p].joint not in knowledge.slides)
        }
        terms = _collect(difference, sorted(places))
        return Form(equation, (*angles, *final), terms)

    def _rewrite(self, polynomial: Polynomial, angle: AngleSum, knowledge: Knowledge) -> Polynomial:
        algebra = self._pool.problem.algebra
        if knowledge.representative(angle) == angle:
            return polynomial
        cosine, sine = knowledge.rewritten(angle)
        change = {algebra.index[angle.cosine]: cosine, algebra.index[angle.sine]: sine}
        return algebra.normal(substitute(polynomial, change))


def substitute(polynomial: Polynomial, change: Mapping[int, Polynomial]) -> Polynomial:
    """The polynomial with some generators replaced."""
    ring = polynomial.ring
    total = ring.zero
    for monomial, coefficient in polynomial.terms():
        rest = tuple(0 if place in change else e for place, e in enumerate(monomial))
        part = ring.from_dict({rest: coefficient})
        for place, value in change.items():
            if monomial[place]:
                part = part * value ** monomial[place]
        total += part
    return total


def _collect(polynomial: Polynomial, places: list[int]) -> dict[Monomial, Polynomial]:
    ring = polynomial.ring
    names = {place: str(ring.symbols[place]) for place in places}
    grouped: dict[Monomial, dict[tuple[int, ...], object]] = {}
    unknown = set(places)
    for monomial, coefficient in polynomial.terms():
        key = tuple(sorted(names[place] for place in places for _ in range(monomial[place])))
        rest = tuple(0 if place in unknown else e for place, e in enumerate(monomial))
        grouped.setdefault(key, {})[rest] = coefficient
    return {key: ring.from_dict(group) for key, group in grouped.items()}
