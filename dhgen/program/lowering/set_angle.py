"""The end of a step: its angle is set, or indeterminate, or known to few digits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.lowering.coefficients import is_nearly_short

if TYPE_CHECKING:
    from dhgen.kinematics.algebra import AngleSum
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering


def finish(
    context: Lowering, angle: AngleSum, cosine: Node, sine: Node, free: Node | None = None
) -> None:
    """The angle is known; where it is free it takes the seed's value."""
    builder = context.builder
    if free is not None:
        seed = context.angles.seed(angle)
        if free not in builder.impossible:
            context.angles.chosen(angle, free)
        cosine = builder.select(free, builder.apply("cos", seed), cosine)
        sine = builder.select(free, builder.apply("sin", seed), sine)
    context.angles.solved(angle, cosine, sine)


def finish_direction(
    context: Lowering, angle: AngleSum, direction: tuple[Node, Node], length: Node, free: Node
) -> None:
    """The angle of a vector that may be short, before a guard that depends on it.

    The shorter the vector, the fewer digits of its direction are right, and an arm that is
    stretched is then out of reach by the wrong ones. A seed that is the angle up to rounding of
    the vector is as good as the angle itself, so it is taken; the runtime's retries look for one.
    """
    builder, scales = context.builder, context.scales
    cosine, sine = direction
    limit = scales.tolerance(scales.tolerances.near, 0, "near")
    near = builder.name(builder.apply("at_most", length, limit), f"near{angle.suffix}")
    c, s = _seed_direction(context, angle)
    across = builder.absolute(builder.sub(builder.mul(cosine, s), builder.mul(sine, c)))
    along = builder.add(builder.mul(cosine, c), builder.mul(sine, s))
    off = builder.select(near, builder.mul(across, length), builder.integer(1))
    ahead = builder.select(near, along, builder.integer(-1))
    ahead = builder.name(ahead, f"ahead{angle.suffix}")
    same_side = builder.apply("less", builder.integer(0), ahead)
    _finish_near(context, angle, direction, near, (off, same_side, 0), free)


@dataclass(frozen=True, slots=True)
class NearlyFree:
    """An equation of type 2 whose factors may both be small, and its right side with them.

    Attributes:
        factors: X, Y and Z of X s + Y c = Z.
        root: Y s - X c, with the branch's sign.
        square: X^2 + Y^2.
        degree: How many lengths are multiplied in X and Y.
    """

    factors: tuple[Node, Node, Node]
    root: Node
    square: Node
    degree: int


def finish_nearly_free(
    context: Lowering,
    angle: AngleSum,
    direction: tuple[Node, Node],
    equation: NearlyFree,
    free: Node,
) -> None:
    """The angle of type 2 where the equation may nearly degenerate, as in `finish_direction`.

    Of roots that nearly meet there even fewer digits are right (UR5 with twists of 1.5708 and a
    straight wrist): an angle that satisfies the equation up to rounding is as good.
    """
    builder = context.builder
    x, y, z = equation.factors
    degree = equation.degree
    near = is_nearly_short(context, equation.square, degree, angle)
    c, s = _seed_direction(context, angle)
    miss = builder.sub(builder.add(builder.mul(x, s), builder.mul(y, c)), z)
    side = builder.mul(equation.root, builder.sub(builder.mul(y, s), builder.mul(x, c)))
    off = builder.select(near, builder.absolute(miss), builder.integer(1))
    ahead = builder.select(near, side, builder.integer(-1))
    ahead = builder.name(ahead, f"ahead{angle.suffix}")
    same_side = builder.apply("at_most", builder.integer(0), ahead)
    _finish_near(context, angle, direction, near, (off, same_side, degree), free)


def _seed_direction(context: Lowering, angle: AngleSum) -> tuple[Node, Node]:
    """Cosine and sine of the seed's value."""
    seed = context.angles.seed(angle)
    return context.builder.apply("cos", seed), context.builder.apply("sin", seed)


def _finish_near(
    context: Lowering,
    angle: AngleSum,
    direction: tuple[Node, Node],
    near: Node,
    seen: tuple[Node, Node, int],
    free: Node,
) -> None:
    """The angle is known, to few digits near to where it is free.

    There it takes the seed's value if that is off by rounding alone, and on the same side;
    `seen` is by how much it is off, whether it is on that side, and the degree of the former.
    """
    builder, scales = context.builder, context.scales
    off, same_side, degree = seen
    rounding = scales.tolerance(scales.tolerances.free, degree, "free")
    off = builder.name(off, f"off{angle.suffix}")
    agrees = builder.apply("and", builder.apply("at_most", off, rounding), same_side)
    same = builder.name(builder.apply("and", near, agrees), f"same{angle.suffix}")
    held = builder.name(builder.apply("or", free, same), f"held{angle.suffix}")
    context.angles.chosen(angle, free)
    c, s = _seed_direction(context, angle)
    cosine, sine = direction
    context.angles.solved(angle, builder.select(held, c, cosine), builder.select(held, s, sine))
    # other values are looked for beside its own: the seed's may be far off, and yet be rounding
    ((joint, _),) = angle.terms
    context.angles.nearly_chosen(joint, near, builder.apply("atan2", sine, cosine))
