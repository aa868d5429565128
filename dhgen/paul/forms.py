"""Equations as they look at one point of a derivation: linear in one or two unknowns.

What is known (pose, lengths, solved joints) goes into the coefficients; the unknowns of a run of
parallel axes are written by their representatives, so that c23 with theta2 known counts as theta3.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from itertools import chain
from operator import itemgetter
from typing import TYPE_CHECKING, Any

from dhgen.kinematics.algebra import SHOULDER_NAMES, AngleSum

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.equation import Equation
    from dhgen.paul.knowledge import Knowledge
    from dhgen.paul.pool import Pool

MOST_UNKNOWNS = 2


@dataclass(frozen=True, slots=True, order=True)
class Length:
    """The unknown of a prismatic joint."""

    joint: int
    name: str


Unknown = AngleSum | Length
Exponents = tuple[int, ...]
Monomial = tuple[str, ...]  # names of unknown generators, e.g. ("c2", "r3"); () is the constant


@dataclass(frozen=True, slots=True)
class Form:
    """An equation, sum of coefficient times unknown monomial = 0.

    Attributes:
        equation: Where it comes from.
        unknowns: In the order of the joints, angles first.
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
        found = self.terms.get(names if len(names) < 2 else tuple(sorted(names)))
        return self.equation.difference.ring.zero if found is None else found

    def within(self, allowed: Iterable[Monomial]) -> bool:
        """Whether no other monomials occur."""
        return self.terms.keys() <= {tuple(sorted(monomial)) for monomial in allowed}


def unknown_name(unknown: Unknown) -> str:
    """How a message calls an angle sum or a length."""
    return f"theta{unknown.suffix}" if isinstance(unknown, AngleSum) else unknown.name


def common_angle_and_length(forms: Sequence[Form]) -> tuple[AngleSum, Length] | str:
    """The unknowns of both equations, or why they are not one angle and one length."""
    first, second = forms
    if first.unknowns != second.unknowns or len(first.unknowns) != 2:
        return "not the same two unknowns"
    return first.angle_and_length or "the unknowns are not an angle and a length"


@dataclass(frozen=True, slots=True)
class _Content:
    """What an equation holds: places in `Algebra.angles`, and lengths."""

    angles: tuple[int, ...]
    lengths: tuple[Length, ...]


class FormReader:
    """Reads the pool at any state of knowledge."""

    def __init__(self, pool: Pool) -> None:
        algebra = pool.problem.algebra
        self._algebra = algebra
        self._names = tuple(algebra.index)
        self._number = {angle: number for number, angle in enumerate(algebra.angles)}
        self._places = [(algebra.index[a.cosine], algebra.index[a.sine]) for a in algebra.angles]
        self._lengths = {Length(j, name): algebra.index[name] for j, name in algebra.slides.items()}
        self._equations = [(equation, self._content(equation)) for equation in pool.equations]
        self._late = _places_of_late(pool)
        self._elbow = None if pool.plane is None else pool.plane.elbow_angle
        self._seen: dict[object, Form] = {}
        self._turns: dict[tuple[int, int], tuple[Polynomial, Polynomial]] = {}

    def forms(self, knowledge: Knowledge, most: int = MOST_UNKNOWNS) -> list[Form]:
        """Every equation with a few unknowns, rewritten; in the order of the pool.

        Args:
            knowledge: The state.
            most: How many unknowns an equation may hold.
        """
        names = [self._name(angle, knowledge) for angle in self._algebra.angles]
        found = []
        late = self._elbow is not None and not knowledge.knows(self._elbow)
        for place, (equation, content) in enumerate(self._equations):
            if late and place in self._late:
                continue
            read = tuple([names[number] for number in content.angles])
            lengths = tuple([u for u in content.lengths if u.joint not in knowledge.slides])
            count = len({abs(name) for name in read if name}) + len(lengths)
            if 0 < count <= most:
                key = (place, read, lengths)  # states that agree in it see the same form
                if key not in self._seen:
                    self._seen[key] = self._form(
                        equation, content.angles, names, lengths, knowledge
                    )
                found.append(self._seen[key])
        return found

    def _content(self, equation: Equation) -> _Content:
        columns = list(zip(*equation.difference, strict=True))
        return _Content(
            tuple(n for n, pair in enumerate(self._places) if any(any(columns[p]) for p in pair)),
            tuple(sorted(u for u, place in self._lengths.items() if any(columns[place]))),
        )

    def _name(self, angle: AngleSum, knowledge: Knowledge) -> int:
        """0 for a known angle sum, else one for its representative, negative when reversed."""
        if knowledge.knows(angle):
            return 0
        name = 1 + self._number[knowledge.representative(angle)]
        return name if knowledge.runs_along(angle) else -name

    def _form(
        self,
        equation: Equation,
        content: tuple[int, ...],
        names: Sequence[int],
        lengths: tuple[Length, ...],
        knowledge: Knowledge,
    ) -> Form:
        """Rewrites where two angle sums stand for one unknown, then collects.

        A lone angle sum stays as the file's frames gave it (theta12, not theta2 with theta1
        known): fewer products, and the reader finds the equation as it stands in U_i.
        """
        difference = equation.difference
        open_angles = [number for number in content if names[number]]
        count = Counter(abs(names[number]) for number in open_angles)
        kept = set()
        for number in open_angles:
            name = abs(names[number])
            kept.add(number if count[name] == 1 else name - 1)
            if count[name] > 1 and number != name - 1:
                change = self._rewritten(number, names[number], knowledge)
                difference = substitute(difference, self._places[number], change)
                difference = self._algebra.normal(difference)
        angles = sorted(self._algebra.angles[number] for number in kept)
        places = [place for number in kept for place in self._places[number]]
        places += [self._lengths[length] for length in lengths]
        terms = self._collected(difference, sorted(places))
        return Form(equation, (*angles, *lengths), terms)

    def _rewritten(
        self, number: int, name: int, knowledge: Knowledge
    ) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of an angle sum by its representative; all states with it agree."""
        if (number, name) not in self._turns:
            self._turns[number, name] = knowledge.rewritten(self._algebra.angles[number])
        return self._turns[number, name]

    def _collected(
        self, polynomial: Polynomial, places: Sequence[int]
    ) -> dict[Monomial, Polynomial]:
        """The coefficient of every monomial in the generators at some places."""
        names = [self._names[place] for place in places]
        collected = {}
        for exponents, part in _split(polynomial, places).items():
            powers = ([name] * exponent for name, exponent in zip(names, exponents, strict=True))
            collected[tuple(sorted(chain.from_iterable(powers)))] = part
        return collected


def _places_of_late(pool: Pool) -> frozenset[int]:
    """The equations of the shoulder, which is known from the arm angle once the elbow is."""
    if pool.plane is None:
        return frozenset()
    index = pool.problem.algebra.index
    names = [index[name] for row in SHOULDER_NAMES for name in row]
    return frozenset(
        place
        for place, equation in enumerate(pool.equations)
        if any(monomial[name] for monomial in equation.difference for name in names)
    )


def is_multiple(
    polynomial: Mapping[Exponents, Any], other: Mapping[Exponents, Any], sign: int
) -> bool:
    """Whether a polynomial, as its coefficients by exponents, is another one times +1 or -1."""
    return len(polynomial) == len(other) and all(
        other.get(exponents) == sign * coefficient for exponents, coefficient in polynomial.items()
    )


def substitute(
    polynomial: Polynomial, places: Sequence[int], values: Sequence[Polynomial]
) -> Polynomial:
    """The polynomial with the generators at some places replaced."""
    ring = polynomial.ring
    total = ring.zero
    for exponents, rest in _split(polynomial, places).items():
        part = rest
        for value, exponent in zip(values, exponents, strict=True):
            if exponent:
                part = part * value**exponent
        total += part
    return total


def _split(polynomial: Polynomial, places: Sequence[int]) -> dict[tuple[int, ...], Polynomial]:
    """A polynomial by the exponents of the generators at some places."""
    ring = polynomial.ring
    parts: dict[tuple[int, ...], Polynomial] = {}
    exponents_of = itemgetter(*places, *places)  # at least two places make tuples
    for monomial, coefficient in polynomial.items():
        exponents = exponents_of(monomial)[: len(places)]
        part = parts.get(exponents)
        if part is None:
            part = parts[exponents] = ring.zero
        rest = list(monomial)
        for place in places:
            rest[place] = 0
        part[tuple(rest)] = coefficient
    return parts
