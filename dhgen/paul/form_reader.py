"""Reads the equations of a pool as they look at one point of a derivation.

What is known (pose, lengths, solved joints) goes into the coefficients; the unknowns of a run of
parallel axes are written by their representatives, so that c23 with theta2 known counts as theta3.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from itertools import chain
from operator import itemgetter
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import SHOULDER_NAMES, AngleSum
from dhgen.kinematics.ring import by_powers, substitute
from dhgen.paul.form import Form, Length, Monomial

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence

    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.equation import Equation
    from dhgen.paul.knowledge import Knowledge
    from dhgen.paul.pool import Pool

MOST_UNKNOWNS = 2
ENOUGH = 48  # so many equations for the same unknowns hold the best step: hundreds are longer ones


@dataclass(frozen=True, slots=True)
class _Content:
    """What an equation holds: places in `Algebra.angles`, and lengths."""

    angles: tuple[int, ...]
    lengths: tuple[Length, ...]


@dataclass(frozen=True, slots=True, order=True)
class _Look:
    """What of an equation is not known at some state.

    Attributes:
        place: Of the equation in the pool.
        angles: For each of its angle sums 0 if it is known, else one for its representative,
            negative when reversed.
        lengths: Its unknown lengths.
    """

    place: int
    angles: tuple[int, ...]
    lengths: tuple[Length, ...]

    @property
    def unknowns(self) -> frozenset[int]:
        """The representatives of its unknown angle sums."""
        return frozenset(map(abs, self.angles)) - {0}


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
        self._seen: dict[_Look, Form] = {}
        self._turns: dict[tuple[int, int], tuple[Polynomial, Polynomial]] = {}

    def forms(self, knowledge: Knowledge) -> list[Form]:
        """The simplest equations for the same one or two unknowns, rewritten; in the pool's order.

        Args:
            knowledge: The state.
        """
        names = self._all_names(knowledge)
        alike: dict[tuple[frozenset[int], tuple[Length, ...]], list[_Look]] = {}
        for look in self._looks(names, knowledge, MOST_UNKNOWNS):
            alike.setdefault((look.unknowns, look.lengths), []).append(look)
        simplest = sorted(chain.from_iterable(map(self._simplest, alike.values())))
        return [self._read(look, names, knowledge) for look in simplest]

    def every(self, knowledge: Knowledge, most: int) -> list[Form]:
        """Every equation with at most so many unknowns, rewritten; in the pool's order."""
        names = self._all_names(knowledge)
        looks = self._looks(names, knowledge, most)
        return [self._read(look, names, knowledge) for look in looks]

    def _all_names(self, knowledge: Knowledge) -> list[int]:
        """What every angle sum goes by."""
        return [self._name(angle, knowledge) for angle in self._algebra.angles]

    def _looks(self, names: Sequence[int], knowledge: Knowledge, most: int) -> Iterator[_Look]:
        """What every equation with at most so many unknowns holds that is not known."""
        late = self._elbow is not None and not knowledge.knows(self._elbow)
        for place, (_, content) in enumerate(self._equations):
            if late and place in self._late:
                continue
            angles = tuple([names[number] for number in content.angles])
            lengths = tuple([u for u in content.lengths if u.joint not in knowledge.slides])
            look = _Look(place, angles, lengths)
            if 0 < len(look.unknowns) + len(lengths) <= most:
                yield look

    def _simplest(self, looks: Sequence[_Look]) -> Iterable[_Look]:
        """The equations with the fewest terms, and with the fewest terms that hold an unknown."""
        if len(looks) <= ENOUGH:
            return looks
        return _fewest(looks, self._size) | _fewest(looks, self._holding)

    def _size(self, look: _Look) -> int:
        """Terms of an equation."""
        return len(self._equations[look.place][0].difference)

    def _holding(self, look: _Look) -> int:
        """Terms that hold an unknown."""
        equation, content = self._equations[look.place]
        unknown = zip(content.angles, look.angles, strict=True)
        places = [place for number, name in unknown if name for place in self._places[number]]
        places += [self._lengths[length] for length in look.lengths]
        exponents_of = itemgetter(*places, *places)  # at least two places make tuples
        return sum(map(any, map(exponents_of, equation.difference)))

    def _read(self, look: _Look, names: Sequence[int], knowledge: Knowledge) -> Form:
        """States that agree in how they look at an equation see the same form."""
        if look not in self._seen:
            self._seen[look] = self._form(look, names, knowledge)
        return self._seen[look]

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

    def _form(self, look: _Look, names: Sequence[int], knowledge: Knowledge) -> Form:
        """Rewrites where two angle sums have one unknown, then collects.

        A lone angle sum is left as the file's frames gave it (theta12, not theta2 with theta1
        known): fewer products, and the reader finds the equation as it is in U_i.
        """
        equation, content = self._equations[look.place]
        difference = equation.difference
        open_angles = [number for number in content.angles if names[number]]
        count = Counter(abs(names[number]) for number in open_angles)
        kept = set()
        for number in open_angles:
            name = abs(names[number])
            kept.add(number if count[name] == 1 else name - 1)
            if count[name] > 1 and number != name - 1:
                turned = self._rewritten(number, names[number], knowledge)
                change = dict(zip(self._places[number], turned, strict=True))
                difference = substitute(difference, change)
                difference = self._algebra.normal(difference)
        angles = sorted(self._algebra.angles[number] for number in kept)
        places = [place for number in kept for place in self._places[number]]
        places += [self._lengths[length] for length in look.lengths]
        terms = self._collected(difference, sorted(places))
        return Form(equation, (*angles, *look.lengths), terms)

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
        for exponents, part in by_powers(polynomial, places).items():
            powers = ([name] * exponent for name, exponent in zip(names, exponents, strict=True))
            collected[tuple(sorted(chain.from_iterable(powers)))] = part
        return collected


def _fewest(looks: Iterable[_Look], count: Callable[[_Look], int]) -> set[_Look]:
    """The ENOUGH of which a count is smallest, and all with an equal count."""
    counts = {look: count(look) for look in looks}
    most = sorted(counts.values())[ENOUGH - 1]
    return {look for look, each in counts.items() if each <= most}


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
