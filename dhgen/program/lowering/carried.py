"""Columns that are carried along known links: what long coefficients are sums of.

Where twists are no right angles an entry of a form of T that is multiplied out has hundreds of
terms. The column that it stands in, seen from one known link after the other, takes four products
a turn, and coefficients are short sums of its entries.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.kinematics.chain import Turn, parallel_groups
from dhgen.kinematics.product import product, reversed_elements
from dhgen.kinematics.ring import by_powers, used_places
from dhgen.kinematics.transform import Transform, dot, inverse
from dhgen.paul.equation import MOMENT
from dhgen.program.lowering.columns import Columns
from dhgen.program.lowering.polynomials import Part
from dhgen.program.lowering.vectors import inner

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Iterator, Sequence

    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.equation import Origin
    from dhgen.paul.step import Step
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.columns import Column, Stretch
    from dhgen.program.lowering.context import Lowering

    PartsOf = Callable[[Lowering, Step], Iterator[Part]]


def no_parts(_: Lowering, __: Step) -> Iterator[Part]:
    """Nothing: coefficients are what they are multiplied out."""
    yield from ()


def parts_of(context: Lowering, step: Step) -> Iterator[Part]:
    """What the columns say in which a step's equations stand, each side seen from the unknown."""
    carrier = _Carrier(context)
    steps = (step,) if step.second is None else (step, step.second)
    for form in (form for each in steps for form in each.forms):
        for origin in _places(form.equation.origin):
            for side in carrier.sides(origin):
                yield from carrier.parts(side, origin)


def _places(origin: Origin) -> Iterator[Origin]:
    """Where an equation stands; that of a rotation in the inverted form, too, transposed."""
    if not origin.row or origin.column == MOMENT or origin.shoulder:
        return
    yield origin
    if origin.column < 4:
        yield replace(origin, row=origin.column, column=origin.row, inverse=not origin.inverse)


class _Carrier:
    def __init__(self, context: Lowering) -> None:
        self._context = context
        self._columns = Columns(context)
        self._builder = context.builder
        self._algebra = context.algebra
        self._normal = context.algebra.normal
        self._groups = {
            joint: number
            for number, group in enumerate(parallel_groups(context.chain))
            for joint, _ in group
        }

    def sides(self, origin: Origin) -> Iterator[list[Stretch]]:
        """Both sides of an equation: the one with U_0, and that of the links between."""
        problem = self._context.problem
        links, target = problem.links, problem.target
        before, between, after = (
            [element for link in part for element in link]
            for part in (links[: origin.m], links[origin.m : origin.k], links[origin.k :])
        )
        if origin.inverse:
            back = inverse(target, self._normal)
            yield [*self._stretches(after), back, *self._stretches(before)]
            yield self._stretches(reversed_elements(between, self._algebra))
        else:
            left, right = (reversed_elements(each, self._algebra) for each in (before, after))
            yield [*self._stretches(left), target, *self._stretches(right)]
            yield self._stretches(between)

    def _stretches(self, elements: Iterable[Element]) -> list[Stretch]:
        """Elements up to those that turn about another direction."""
        found: list[list[Element]] = []
        group = None
        for element in elements:
            turns = self._groups[element.joint] if isinstance(element, Turn) else group
            if not found or turns != group:
                found.append([])
            group = turns
            found[-1].append(element)
        return [tuple(stretch) for stretch in found]

    def parts(self, side: list[Stretch], origin: Origin) -> Iterator[Part]:
        """The sums of a carried column's entries in one entry of a side."""
        column, rest = self._columns.start(origin.column), list(side)
        while rest and self._is_known(rest[-1]):
            column = self._columns.seen(rest.pop(), column)
        links = [stretch for stretch in rest if isinstance(stretch, tuple)]
        if rest == side or len(links) < len(rest):
            return  # nothing is known, or U_0 stands beyond the unknown
        between = product((element for link in links for element in link), self._algebra)
        row = between.rotation[origin.row - 1]
        places = tuple(sorted(self._unknown(row)))
        if not places:
            yield self._part(row, column)
            return
        by_unknowns = [by_powers(factor, places) for factor in row]
        zero = self._algebra.ring.zero
        for powers in sorted({key for each in by_unknowns for key in each}):
            yield self._part([each.get(powers, zero) for each in by_unknowns], column)

    def _part(self, factors: Sequence[Polynomial], column: Column) -> Part:
        """factors . column, without what all factors hold."""
        exponents = [monomial for factor in factors for monomial in factor]
        common = tuple(map(min, zip(*exponents, strict=True)))
        ring = self._algebra.ring
        factors = [factor.quo(ring.from_dict({common: ring.domain.one})) for factor in factors]

        def value() -> Node:
            return inner(self._builder, list(map(self._context.lower, factors)), column.values)

        return Part(dot(factors, column.entries, self._normal), value)

    def _unknown(self, polynomials: Iterable[Polynomial]) -> set[int]:
        return {
            place
            for polynomial in polynomials
            for place in used_places(polynomial)
            if not self._context.polynomials.is_known(place)
        }

    def _is_known(self, stretch: Stretch) -> bool:
        if isinstance(stretch, Transform):
            return True
        whole = product(stretch, self._algebra)
        return not self._unknown((*whole.translation, *(e for row in whole.rotation for e in row)))
