"""The search for an order of steps: cheapest first over states of knowledge, with backtracking.

A state is what is known, not how it came to be known; the equations that a state offers depend on
nothing else. The cost of an order counts the number of solutions it multiplies up to first, then
how well conditioned and how short its steps are.
"""

from __future__ import annotations

import heapq
from dataclasses import dataclass
from itertools import chain, combinations, count
from typing import TYPE_CHECKING

import numpy as np

from dhgen.errors import UnsolvedError
from dhgen.paul.form_reader import FormReader
from dhgen.paul.kind import Kind
from dhgen.paul.knowledge import initial_knowledge
from dhgen.paul.step import View, learn, steps_of
from dhgen.paul.witness import VANISHING, build_witnesses

if TYPE_CHECKING:
    from collections.abc import Container, Iterator, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.equation import Equation, Line
    from dhgen.paul.form import Form, Unknown
    from dhgen.paul.knowledge import Knowledge, State
    from dhgen.paul.pool import Pool
    from dhgen.paul.step import EquationType, Step


PAIR = 2  # equations
SHORTEST = 8  # of equations from anywhere, only the shortest are paired
DOUBLING = 10_000  # a step with two roots costs more than any number of clumsy steps with one
DEGENERATE = 5_000  # more than any length: of a step that may lose an angle that is not free


@dataclass(frozen=True, slots=True)
class Route:
    """An order of steps that makes every joint known.

    Attributes:
        steps: In order.
        offers: At each step, all that were possible, cheapest first.
    """

    steps: tuple[Step, ...]
    offers: tuple[tuple[Step, ...], ...]


class Search:
    """The states of knowledge of one arm and the steps between them."""

    def __init__(self, pool: Pool, types: tuple[EquationType, ...]) -> None:
        pairs = tuple(each for each in types if each.arity == PAIR)
        self._single = tuple(each for each in types if each.arity == 1)
        self._beside = pairs
        self._turned = tuple(each for each in pairs if each.ordered)
        self._anywhere = tuple(each for each in pairs if each.anywhere)
        self._reader = FormReader(pool)
        self._start = initial_knowledge(pool.problem.algebra)
        self._witnesses = build_witnesses(pool)
        self._offers: dict[State, tuple[Step, ...]] = {}
        self._steps_of: dict[tuple[int, ...], tuple[Step, ...]] = {}
        self._degenerate: set[tuple[State, int]] = set()
        self._partners: set[frozenset[int]] = set()
        self._places = {id(equation): place for place, equation in enumerate(pool.equations)}
        self._lines = _lines(pool.equations)
        self.deepest: Knowledge = self._start

    def best(self, numbers: Sequence[int] = ()) -> Route | None:
        """The cheapest order to a complete state; None where there is none.

        Args:
            numbers: Which of their offers the first steps are, from 1.
        """
        tie = count()
        queue = [(0, next(tie), *self._chosen(numbers))]
        closed: set[State] = set()
        while queue:
            cost, _, knowledge, steps = heapq.heappop(queue)
            if knowledge.complete:
                return self._route(steps)
            if knowledge.state in closed:
                continue
            closed.add(knowledge.state)
            if knowledge.missing < self.deepest.missing:
                self.deepest = knowledge
            for price, step in self._cheapest(knowledge):
                state = learn(knowledge, step)
                heapq.heappush(queue, (cost + price, next(tie), state, (*steps, step)))
        return None

    def _chosen(self, numbers: Sequence[int]) -> tuple[Knowledge, tuple[Step, ...]]:
        """What is known after the steps that were chosen by their numbers, and these steps."""
        knowledge = self._start
        steps: list[Step] = []
        for place, number in enumerate(numbers, start=1):
            offers = self.offers(knowledge)
            if number > len(offers):
                raise UnsolvedError(
                    f"steps: step {place} has {len(offers)} equations to choose from, not {number}"
                    "; `dhgen explain --alternatives` lists those of the steps that are taken"
                )
            steps.append(offers[number - 1])
            knowledge = learn(knowledge, steps[-1])
        return knowledge, tuple(steps)

    def _cheapest(self, knowledge: Knowledge) -> list[tuple[int, Step]]:
        """Of the steps to each next state the first of the cheapest, with its price."""
        found: dict[tuple[Unknown, ...], tuple[int, int, Step]] = {}
        for place, step in enumerate(self.offers(knowledge)):
            price = step.penalty + DOUBLING * (step.roots - 1)
            price += DEGENERATE if (knowledge.state, id(step)) in self._degenerate else 0
            known = found.get(step.unknowns)
            if known is None or price < known[0]:
                found[step.unknowns] = price, place, step
        in_order = sorted(found.values(), key=lambda each: each[1])
        return [(price, step) for price, _, step in in_order]

    def avoid(self, route: Route, places: Container[int]) -> bool:
        """Makes steps of a route cost more at their places; whether any did not before."""
        known = len(self._degenerate)
        knowledge = self._start
        for place, step in enumerate(route.steps):
            if place in places:
                self._degenerate.add((knowledge.state, id(step)))
            knowledge = learn(knowledge, step)
        return len(self._degenerate) > known

    def offers(self, knowledge: Knowledge) -> tuple[Step, ...]:
        """The steps that a state allows, cheapest first."""
        if knowledge.state not in self._offers:
            view = self.view(knowledge)
            groups = self.groups(self._reader.forms(knowledge))
            self._witnesses.learn(chain.from_iterable(group for group, _ in groups))
            offered = [step for group, types in groups for step in self._steps(group, types, view)]
            found = without_needless_degeneracy(offered, view)
            found.sort(key=lambda step: (step.roots, step.penalty))
            self._offers[knowledge.state] = tuple(found)
        return self._offers[knowledge.state]

    def _steps(
        self, group: tuple[Form, ...], types: tuple[EquationType, ...], view: View
    ) -> tuple[Step, ...]:
        """The steps that equations give; equal forms at another state give equal steps."""
        key = tuple(map(id, group))
        found = self._steps_of.get(key)
        if found is None:
            found = steps_of(equation_type.steps(group, view) for equation_type in types)
            self._steps_of[key] = found
            if found and types is self._anywhere:
                self._partners.add(frozenset(id(form.equation) for form in group))
        return found

    def forms(self, knowledge: Knowledge, most: int) -> list[Form]:
        """The equations of a state with at most so many unknowns, for explanations."""
        return self._reader.every(knowledge, most)

    def view(self, knowledge: Knowledge) -> View:
        """What types look at in a state."""
        return View(knowledge, self._witnesses)

    def groups(self, forms: list[Form]) -> list[tuple[tuple[Form, ...], tuple[EquationType, ...]]]:
        """Forms with one unknown, and pairs with equal unknowns, and the types tried on each.

        Args:
            forms: In the pool's order.
        """
        by_unknowns: dict[tuple[Unknown, ...], list[Form]] = {}
        for form in forms:
            by_unknowns.setdefault(form.unknowns, []).append(form)
        groups: list[tuple[tuple[Form, ...], tuple[EquationType, ...]]] = [
            ((form,), self._single) for form in forms if len(form.unknowns) == 1
        ]
        for alike in by_unknowns.values():
            for first, second in self._pairs(alike):
                groups.append(((first, second), self._beside))
                groups.append(((second, first), self._turned))
            if self._anywhere:
                short = sorted(alike, key=lambda form: len(form.equation.difference))[:SHORTEST]
                short.sort(key=lambda form: self._places[id(form.equation)])
                groups += [
                    (pair, self._anywhere)
                    for pair in combinations(short, 2)
                    if not any(self._pairs(pair))
                ]
        return groups

    def _pairs(self, forms: Sequence[Form]) -> Iterator[tuple[Form, Form]]:
        """Groups whose equations are in one column or row, or have been solved together."""
        partners, keys = self._partners, [id(form.equation) for form in forms]
        placed = [(key, self._lines[key], form) for key, form in zip(keys, forms, strict=True)]
        for (one, lines, first), (other, its, second) in combinations(placed, 2):
            if lines & its or (partners and frozenset((one, other)) in partners):
                yield first, second

    def _route(self, steps: tuple[Step, ...]) -> Route:
        knowledge = self._start
        offers = []
        for step in steps:
            offers.append(self.offers(knowledge))
            knowledge = learn(knowledge, step)
        return Route(steps, tuple(offers))


def _lines(equations: tuple[Equation, ...]) -> dict[int, int]:
    """For each equation, by its identity, the lines that hold it: one bit for each."""
    numbers: dict[Line, int] = {}
    return {
        id(equation): sum(1 << numbers.setdefault(line, len(numbers)) for line in equation.lines)
        for equation in equations
    }


def without_needless_degeneracy(steps: list[Step], view: View) -> list[Step]:
    """The steps without X s + Y c = Z whose X and Y may vanish where others' are constant.

    That is so where X or Y is zero in both, and where the equation is a multiple of the constant
    one, be it for another angle.
    """
    angles = [step for step in steps if step.kind is Kind.ANGLE]
    sure = [step for step in angles if all(map(view.is_constant, _factors(step)))]
    safe = set(map(id, sure))
    doubtful = [step for step in angles if id(step) not in safe]
    if not sure or not doubtful:
        return steps
    places = np.stack([_place(step, view) for step in sure])
    degenerate = {
        id(step)
        for step in doubtful
        if any(_are_single(step, other) for other in sure) or _is_among(_place(step, view), places)
    }
    return [step for step in steps if id(step) not in degenerate]


def _factors(step: Step) -> tuple[Polynomial, Polynomial]:
    return step.coefficient("X"), step.coefficient("Y")


def _are_single(step: Step, other: Step) -> bool:
    """Whether both hold the sine or the cosine of one angle alone."""
    alone = not all(_factors(step)) and not all(_factors(other))
    return alone and step.unknowns == other.unknowns


def _is_among(place: FloatArray, places: FloatArray) -> bool:
    """Whether an equation of type 2 is a multiple of one of others, which are in rows.

    Then the solution is as far from the direction of (X, Y) in both, whatever their angles are.
    """
    return bool(np.any(np.max(np.abs(places - place), axis=1) <= VANISHING))


def _place(step: Step, view: View) -> FloatArray:
    """(X c - Y s)^2 / (X^2 + Y^2) on the witnesses."""
    angle = step.angle
    algebra, on = view.knowledge.runs.algebra, view.witnesses.evaluate
    x, y = map(on, _factors(step))
    c, s = (on(algebra.generator(name)) for name in (angle.cosine, angle.sine))
    return (x * c - y * s) ** 2 / (x * x + y * y)
