"""A column of a form of T, seen from one link after the other: what it is, and its values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.chain import Fixed, Slide, Turn
from dhgen.kinematics.product import product
from dhgen.kinematics.transform import Transform, dot
from dhgen.program.lowering.vectors import inner, plus

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering

    Vector = tuple[Polynomial, ...]

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
        if sum(isinstance(element, Turn) for element in stretch) > 1:
            return self._moved(product(stretch, self._algebra), column)
        for element in reversed(stretch):
            column = self._before(element, column)
        return column

    def _before(self, element: Element, column: Column) -> Column:
        match element:
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
