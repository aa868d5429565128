"""Columns that are carried along known links: what long coefficients are sums of.

Where twists are no right angles an entry of a form of T that is multiplied out has hundreds of
terms. Its column, seen from one known link after the other, takes four products
a turn, and coefficients are short sums of its entries.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.kinematics.chain import Fixed, Passive, Slide, Turn, parallel_groups
from dhgen.kinematics.product import product, reversed_elements
from dhgen.kinematics.ring import by_powers, used_places
from dhgen.kinematics.transform import Transform, dot, inverse
from dhgen.paul.equation import MOMENT
from dhgen.program.lowering.polynomials import Part
from dhgen.program.lowering.vectors import inner, plus

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering

    Vector = tuple[Polynomial, ...]
    from collections.abc import Callable, Iterable, Iterator, Sequence

    from dhgen.paul.equation import Origin
    from dhgen.paul.step import Step

    PartsOf = Callable[[Lowering, Step], Iterator[Part]]


Stretch = tuple["Element", ...] | Transform  # of a chain about parallel axes, or U_0


@dataclass(frozen=True, slots=True)
class Column:
    """A column, seen from somewhere on the arm.

    Attributes:
        entries: Its three entries.
        values: Their values.
        is_point: Whether it is an origin, which links move, or a direction.
    """

    entries: Vector
    values: tuple[Node, ...]
    is_point: bool


class Columns:
    """Carries columns along links that are known."""

    def __init__(self, context: Lowering) -> None:
        self._context = context
        self._builder = context.builder
        self._algebra = context.algebra
        self._normal = context.algebra.normal

    def start(self, column: int) -> Column:
        """A column, from 1 to 4, of no motion."""
        ring = self._algebra.ring
        entries = tuple(ring.one if column == row else ring.zero for row in (1, 2, 3))
        values = tuple(self._builder.integer(int(column == row)) for row in (1, 2, 3))
        return Column(entries, values, column == 4)

    def seen(self, stretch: Stretch, column: Column) -> Column:
        """A column from before a stretch."""
        if isinstance(stretch, Transform):
            return self._named(self._moved(stretch, column), column)
        if sum(isinstance(element, Turn | Passive) for element in stretch) > 1:
            return self._moved(product(stretch, self._algebra), column)
        for element in reversed(stretch):
            column = self._before(element, column)
        return column

    def _before(self, element: Element, column: Column) -> Column:
        match element:
            case Passive():
                return self._moved(product((element,), self._algebra), column)
            case Fixed(transform):
                return self._moved(transform, column)
            case Turn(joint, sign):
                cosine, sine = self._algebra.cosine_sine(((joint, sign),))
                return self._turned(cosine, sine, column)
            case Slide(joint, sign):
                zero = self._algebra.ring.zero
                length = self._algebra.generator(self._algebra.slides[joint]) * sign
                return self._plus((zero, zero, length), column)

    def _moved(self, transform: Transform, column: Column) -> Column:
        builder, lower = self._builder, self._context.lower
        turned = Column(
            tuple(dot(row, column.entries, self._normal) for row in transform.rotation),
            tuple(
                inner(builder, list(map(lower, row)), column.values) for row in transform.rotation
            ),
            column.is_point,
        )
        return self._plus(transform.translation, turned)

    def _plus(self, translation: Vector, column: Column) -> Column:
        if not column.is_point:
            return column
        lengths = list(map(self._context.lower, translation))
        return Column(
            tuple(a + b for a, b in zip(column.entries, translation, strict=True)),
            tuple(plus(self._builder, column.values, lengths)),
            is_point=True,
        )

    def _turned(self, cosine: Polynomial, sine: Polynomial, column: Column) -> Column:
        builder, normal = self._builder, self._normal
        (x, y, z), (u, v, w) = column.entries, column.values
        c, s = map(self._context.lower, (cosine, sine))
        return Column(
            (
                normal.products(((1, cosine, x), (-1, sine, y))),
                normal.products(((1, sine, x), (1, cosine, y))),
                z,
            ),
            (
                builder.sub(builder.mul(c, u), builder.mul(s, v)),
                builder.add(builder.mul(s, u), builder.mul(c, v)),
                w,
            ),
            column.is_point,
        )

    def _named(self, seen: Column, before: Column) -> Column:
        """A point that is fixed to the tool or to the base, by its names in the equations."""
        pool = self._context.pool
        fixed = [(point.in_tool, point.names) for point in pool.points]
        fixed += [(point.in_base, point.names) for point in pool.base_points]
        names = next((names for place, names in fixed if place == before.entries), None)
        if not seen.is_point or names is None:
            return seen
        entries = tuple(
            self._algebra.generator(name) if len(entry) > 1 else entry
            for name, entry in zip(names, seen.entries, strict=True)
        )
        return Column(entries, tuple(map(self._context.lower, entries)), is_point=True)


def no_parts(_: Lowering, __: Step) -> Iterator[Part]:
    """Nothing: coefficients are what they are multiplied out."""
    yield from ()


def parts_of(context: Lowering, step: Step) -> Iterator[Part]:
    """Sums in the columns that hold a step's equations, each side seen from the unknown."""
    carrier = _Carrier(context)
    steps = (step,) if step.fallback is None else (step, step.fallback)
    for form in (form for each in steps for form in each.forms):
        for origin in _places(form.equation.origin):
            for side in carrier.sides(origin):
                yield from carrier.parts(side, origin)


def _places(origin: Origin) -> Iterator[Origin]:
    """The places of an equation; a rotation's place in the inverted form, too, transposed."""
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
        """Elements up to the next that turns about another direction."""
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
            return  # nothing is known, or U_0 is beyond the unknown
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
