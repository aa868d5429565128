"""The coefficients of a step's type, and below which size they count as nothing."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum

if TYPE_CHECKING:
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.step import Step
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering


def letters(context: Lowering, step: Step, names: str) -> tuple[Node, ...]:
    """The values of some of the type's letters, named with spaces between."""
    unknown = step.unknowns[0]
    suffix = unknown.suffix if isinstance(unknown, AngleSum) else str(unknown.joint)
    return tuple(
        context.builder.hint(context.lower(step.coefficient(name)), named(name, suffix))
        for name in names.split()
    )


def named(letter: str, suffix: str) -> str:
    """A letter of a type at a step: X5, and X1_5 for X1."""
    return f"{letter}_{suffix}" if letter[-1].isdigit() else letter + suffix


def remember(context: Lowering, step: Step, angle: AngleSum, z: Node, root: Node) -> None:
    """X s + Y c is Z and Y s - X c is the signed root: later steps need not compute them."""
    x, y = step.coefficient("X"), step.coefficient("Y")
    s, c = context.generators(angle)
    context.polynomials.remember(x * s + y * c, z)
    context.polynomials.remember(y * s - x * c, root)


def is_short(context: Lowering, length: Node, degree: int, name: str) -> Node:
    """Whether a vector is too short to fix an angle, or a factor too small to fix a length."""
    limit = context.scales.tolerance(context.scales.tolerances.free, degree, "free")
    short = context.builder.apply("at_most", length, limit)
    return context.builder.name(short, name)


def is_short_square(context: Lowering, square: Node, degree: int, angle: AngleSum) -> Node:
    """Whether a vector is short, from its square or the product of two that vanish together."""
    limit = context.scales.tolerance(context.scales.tolerances.free**2, 2 * degree, "free_square")
    short = context.builder.apply("at_most", square, limit)
    return context.builder.name(short, f"free{angle.suffix}")


def is_nearly_short(context: Lowering, square: Node, degree: int, angle: AngleSum) -> Node:
    """Whether few digits of a vector's direction are right, from the square of its length."""
    relative = context.scales.tolerances.near**2
    limit = context.scales.tolerance(relative, 2 * degree, "near_square")
    return context.builder.name(
        context.builder.apply("at_most", square, limit), f"near{angle.suffix}"
    )


def vanishes(context: Lowering, value: Node, of: Polynomial) -> Node:
    """Whether an equation holds without its unknown.

    As well as the task allows where the pose is checked at the end, up to rounding otherwise.
    """
    scales, tolerances = context.scales, context.scales.tolerances
    kind, relative = "free", tolerances.free
    if context.overdetermined:
        kind, relative = "consistent", tolerances.consistent
    limit = scales.tolerance(relative, scales.degree(of), kind)
    return context.builder.apply("at_most", context.builder.absolute(value), limit)


def is_within_reach(context: Lowering, value: Node, factor: Node) -> Node:
    """Whether |value / factor| is not longer than any slide."""
    scales, builder = context.scales, context.builder
    longest = scales.tolerance(scales.tolerances.longest, 1, "longest")
    product = builder.mul(longest, builder.absolute(factor))
    return builder.apply("at_most", builder.absolute(value), product)
