"""Types 1, 10 and 11: a length, a length from its square, and two lengths."""

from __future__ import annotations

from functools import reduce
from typing import TYPE_CHECKING

from dhgen.paul.types.lengths import determinant
from dhgen.program.ir import Failure
from dhgen.program.lowering.coefficients import is_short, is_within_reach, letters, vanishes
from dhgen.program.lowering.roots import reach_of, signed_root

if TYPE_CHECKING:
    from dhgen.paul.step import Step
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering

    Row = tuple[Node, Node, Node]  # X, Y, Z


def lower_length(context: Lowering, step: Step) -> None:
    """Type 1: r = Y / X; where X may vanish, the seed's r if Y vanishes too."""
    unknown = step.length
    builder = context.builder
    y, x = letters(context, step, "Y X")
    if context.are_constant(step.coefficient("X")):
        context.angles.solved_slide(unknown.name, builder.div(y, x))
        return
    degree = context.scales.degree(step.coefficient("X"))
    free = is_short(context, builder.absolute(x), degree, f"free{unknown.joint}")
    near = vanishes(context, y, step.coefficient("Y"))
    within = is_within_reach(context, y, x)
    condition = builder.select(free, near, within)
    margin = builder.select(free, _margin(builder, near), _margin(builder, within))
    builder.guard(condition, Failure.ENDLESS, margin, context.angles.options())
    safe = builder.hint(builder.select(free, builder.integer(1), x), f"divisor{unknown.joint}")
    seed = context.angles.chosen_slide(unknown.joint, free)
    length = builder.select(free, seed, builder.div(y, safe))
    context.angles.solved_slide(unknown.name, length)


def _margin(builder: Builder, condition: Node) -> Node:
    """By how much x <= limit holds."""
    x, limit = builder.entries[condition].operands
    return builder.sub(limit, x)


def lower_squared_length(context: Lowering, step: Step) -> None:
    """Type 10: a quadratic in r.

    Rounding of Z moves a root by itself over the distance of both. A length that may be nothing
    else is zero: what it gives a direction to is free then, and not anywhere.
    """
    unknown = step.length
    builder, suffix = context.builder, str(unknown.joint)
    x, y, z = letters(context, step, "X Y Z")
    half = builder.hint(builder.div(y, builder.mul(builder.integer(2), x)), f"H{suffix}")
    square = builder.add(builder.square(half), builder.div(z, x))
    discriminant = builder.name(square, f"D{suffix}_squared")
    within = reach_of(context, discriminant, context.scales.distances(2), 1)
    root = signed_root(context, suffix, within)
    length = builder.sub(root, half)
    size = builder.absolute(length)
    apart = builder.apply("maximum", builder.absolute(root), size)
    noise = context.scales.tolerance(context.scales.tolerances.nothing, 2, "nothing")
    none = builder.apply("at_most", builder.mul(size, apart), noise)
    length = builder.select(none, builder.integer(0), length)
    context.angles.solved_slide(unknown.name, length)


def lower_two_lengths(context: Lowering, step: Step) -> None:
    """Type 11: Cramer's rule.

    Where the determinant may vanish both equations are one and the same line there, or none: then
    the lengths on it that are nearest to the seed's.
    """
    builder = context.builder
    x1, y1, z1, x2, y2, z2 = letters(context, step, "X1 Y1 Z1 X2 Y2 Z2")
    divisor = builder.sub(builder.mul(x1, y2), builder.mul(x2, y1))
    over = (
        builder.sub(builder.mul(z1, y2), builder.mul(z2, y1)),
        builder.sub(builder.mul(x1, z2), builder.mul(x2, z1)),
    )
    if context.are_constant(determinant(step, context.algebra)):
        found = [builder.div(part, divisor) for part in over]
    else:
        rows = (x1, y1, z1), (x2, y2, z2)
        found = _where_it_may_vanish(context, step, rows, divisor, over)
    for unknown, length in zip(step.lengths, found, strict=True):
        context.angles.solved_slide(unknown.name, length)


def _where_it_may_vanish(
    context: Lowering,
    step: Step,
    rows: tuple[Row, Row],
    divisor: Node,
    over: tuple[Node, Node],
) -> list[Node]:
    """Both lengths, by the determinant or, where that is nothing, by the seed."""
    builder, unknowns = context.builder, step.lengths
    suffix = str(unknowns[0].joint)
    builder.hint(divisor, f"D{suffix}")
    degree = context.scales.degree(determinant(step, context.algebra))
    free = is_short(context, builder.absolute(divisor), degree, f"free{suffix}")
    seeds = tuple(context.angles.chosen_slide(each.joint, free) for each in unknowns)
    near = _nearest(context, step, rows, (seeds[0], seeds[1]))
    holds = builder.apply(
        "and",
        vanishes(context, _missed(context, rows[0], near), step.coefficient("Z1")),
        vanishes(context, _missed(context, rows[1], near), step.coefficient("Z2")),
    )
    within = builder.apply("and", *(is_within_reach(context, part, divisor) for part in over))
    builder.guard(builder.select(free, holds, within), Failure.REACH)
    safe = builder.select(free, builder.integer(1), divisor)
    builder.hint(safe, f"divisor{suffix}")
    return [
        builder.select(free, chosen, builder.div(part, safe))
        for part, chosen in zip(over, near, strict=True)
    ]


def _nearest(
    context: Lowering, step: Step, rows: tuple[Row, Row], seeds: tuple[Node, Node]
) -> tuple[Node, Node]:
    """The lengths nearest to the seed's where both rows are one line.

    With A the rows and e what the seeds miss them by, these are s + A' e / |A|^2.
    """
    builder = context.builder
    (x1, y1, _), (x2, y2, _) = rows
    e1, e2 = (_missed(context, row, seeds) for row in rows)
    degree = context.scales.degree(*(step.coefficient(name) for name in ("X1", "Y1", "X2", "Y2")))
    square = reduce(builder.add, map(builder.square, (x1, y1, x2, y2)))
    limit = context.scales.tolerance(context.scales.tolerances.free**2, 2 * degree, "free_square")
    none = builder.apply("at_most", square, limit)
    safe = builder.select(none, builder.integer(1), square)
    first, second = (
        builder.div(builder.add(builder.mul(one, e1), builder.mul(other, e2)), safe)
        for one, other in ((x1, x2), (y1, y2))
    )
    return builder.add(seeds[0], first), builder.add(seeds[1], second)


def _missed(context: Lowering, row: Row, lengths: tuple[Node, Node]) -> Node:
    """By how much lengths miss an equation."""
    builder, (x, y, z) = context.builder, row
    first, second = lengths
    return builder.sub(z, builder.add(builder.mul(x, first), builder.mul(y, second)))
