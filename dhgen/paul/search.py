"""The search for an order of steps: cheapest first over states of knowledge, with backtracking.

A state is what is known, not how it came to be known; the equations that a state offers depend on
nothing else. The cost of an order counts the number of solutions it multiplies up to first, then
how well conditioned and how short its steps are.
"""

from __future__ import annotations

import heapq
from dataclasses import dataclass
from itertools import combinations, count
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.forms import FormReader
from dhgen.paul.knowledge import initial_knowledge
from dhgen.paul.step import View
from dhgen.paul.types import TYPES
from dhgen.paul.witness import build_witnesses

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.paul.forms import Form, Unknown
    from dhgen.paul.knowledge import Knowledge
    from dhgen.paul.pool import Pool
    from dhgen.paul.step import Step

DOUBLING = 10_000  # a step with two roots costs more than any number of clumsy steps with one


@dataclass(frozen=True, slots=True)
class Route:
    """An order of steps that makes every joint known.

    Attributes:
        steps: In order.
        alternatives: At each step, the other steps that were possible, cheapest first.
    """

    steps: tuple[Step, ...]
    alternatives: tuple[tuple[Step, ...], ...]


class Search:
    """The states of knowledge of one arm and the steps between them."""

    def __init__(self, pool: Pool) -> None:
        self._reader = FormReader(pool)
        self._witnesses = build_witnesses(pool)
        self._start = initial_knowledge(pool.problem.algebra)
        self._offers: dict[Knowledge, tuple[Step, ...]] = {}
        self._steps_of: dict[tuple[int, ...], tuple[Step, ...]] = {}
        self.deepest: Knowledge = self._start

    def routes(self) -> Iterator[Route]:
        """Every cheapest order to a complete state, cheapest first (one for each last state)."""
        tie = count()
        start: tuple[int, int, Knowledge, tuple[Step, ...]] = (0, next(tie), self._start, ())
        queue = [start]
        closed: set[object] = set()
        while queue:
            cost, _, knowledge, steps = heapq.heappop(queue)
            key = (knowledge.components, knowledge.slides)
            if knowledge.complete:
                yield self._route(steps)
                continue
            if key in closed:
                continue
            closed.add(key)
            self.deepest = knowledge
            for step in self.offers(knowledge):
                price = cost + step.penalty + DOUBLING * (step.roots - 1)
                heapq.heappush(queue, (price, next(tie), learn(knowledge, step), (*steps, step)))

    def offers(self, knowledge: Knowledge) -> tuple[Step, ...]:
        """The steps that a state allows, cheapest first."""
        view = View(knowledge, self._witnesses)
        forms = self._reader.forms(knowledge)
        groups: list[tuple[Form, ...]] = [(form,) for form in forms if len(form.unknowns) == 1]
        groups += _pairs(forms)
        found = [step for group in groups for step in self._steps(group, view)]
        found.sort(key=lambda step: (step.roots, step.penalty))
        return tuple(found)

    def _steps(self, group: tuple[Form, ...], view: View) -> tuple[Step, ...]:
        """What equations give; the same forms at another state give the same."""
        key = tuple(map(id, group))
        if key not in self._steps_of:
            self._steps_of[key] = tuple(
                step
                for equation_type in TYPES
                if equation_type.arity == len(group) and equation_type.why_not(group, view) is None
                for step in equation_type.steps(group, view)
            )
        return self._steps_of[key]

    def forms(self, knowledge: Knowledge) -> list[Form]:
        """The equations of a state, for explanations."""
        return self._reader.forms(knowledge)

    def _route(self, steps: tuple[Step, ...]) -> Route:
        knowledge = self._start
        others = []
        for step in steps:
            others.append(tuple(o for o in self.offers(knowledge) if o != step))
            knowledge = learn(knowledge, step)
        return Route(steps, tuple(others))


def learn(knowledge: Knowledge, step: Step) -> Knowledge:
    """The state after a step."""
    for unknown in step.unknowns:
        if isinstance(unknown, AngleSum):
            knowledge = knowledge.with_angle(unknown)
        else:
            knowledge = knowledge.with_slide(unknown.joint)
    return knowledge


def _pairs(forms: list[Form]) -> Iterator[tuple[Form, ...]]:
    """Ordered pairs from one column or one row of one matrix."""
    by_unknowns: dict[tuple[Unknown, ...], list[Form]] = {}
    for form in forms:
        by_unknowns.setdefault(form.unknowns, []).append(form)
    for group in by_unknowns.values():
        for first, second in combinations(group, 2):
            if _side_by_side(first, second):
                yield first, second
                yield second, first


def _side_by_side(first: Form, second: Form) -> bool:
    return any(
        one.m == other.m
        and one.k == other.k
        and one.row
        and other.row
        and (one.column == other.column or one.row == other.row)
        for one in first.equation.origins
        for other in second.equation.origins
    )
