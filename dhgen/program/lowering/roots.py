"""What kernels share: signed roots and their guards, free joints, and the end of a step."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.program.ir import Failure

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


@dataclass(frozen=True, slots=True)
class Reach:
    """What a square root is taken of, and what is known of its sign.

    Attributes:
        discriminant: D.
        inside: Whether D is not negative, up to rounding.
        apart: Whether D is positive beyond rounding: the roots are two.
        clear: The same beyond rounding of what is good to few digits.
    """

    discriminant: Node
    inside: Node
    apart: Node
    clear: Node


def signed_root(context: Lowering, suffix: str, reach: Reach, free: Node | None = None) -> Node:
    """e sqrt(D): the guard for D < 0, the new sign, and the guard where both roots meet.

    Beside a place where an earlier angle is good to few digits only, roots that meet come out a
    little apart; they are then told once, as they are.

    Args:
        context: The program in the making.
        suffix: For names.
        reach: D.
        free: Whether the step fixes nothing, so that one root is enough.
    """
    builder = context.builder
    builder.guard(reach.inside, Failure.REACH, reach.discriminant, context.angles.options())
    apart = builder.name(reach.apart, f"apart{suffix}")
    kept = builder.select(apart, reach.discriminant, builder.integer(0))
    length = builder.name(builder.apply("sqrt", kept), f"w{suffix}")
    sign = context.new_sign()
    met = builder.apply("not", apart)
    for near in context.angles.near:
        blurred = builder.apply("and", near, builder.apply("not", reach.clear))
        met = builder.apply("or", met, blurred)
    keep_one(context, sign, met if free is None else builder.apply("or", met, free))
    return builder.hint(builder.mul(sign, length), f"root{suffix}")


def keep_one(context: Lowering, sign: Node, met: Node) -> None:
    """Where both signs give the same, only + keeps it."""
    builder = context.builder
    plus = builder.apply("less", builder.integer(0), sign)
    keep = builder.apply("or", plus, builder.apply("not", met))
    builder.guard(keep, Failure.MERGED)


def is_short(context: Lowering, length: Node, degree: int, name: str) -> Node:
    """Whether a vector is too short to fix an angle, or a factor too small to fix a length."""
    limit = context.scales.tolerance(context.scales.tolerances.free, degree, "free")
    short = context.builder.apply("at_most", length, limit)
    return context.builder.name(short, name)


def is_short_square(context: Lowering, square: Node, degree: int, angle: AngleSum) -> Node:
    """The same from the square of its length, or the product of two that vanish together."""
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
    if context.redundant:
        kind, relative = "consistent", tolerances.consistent
    limit = scales.tolerance(relative, scales.degree(of), kind)
    return context.builder.apply("at_most", context.builder.absolute(value), limit)


def is_within_reach(context: Lowering, value: Node, factor: Node) -> Node:
    """Whether |value / factor| is not longer than any slide."""
    scales, builder = context.scales, context.builder
    longest = scales.tolerance(scales.tolerances.longest, 1, "longest")
    product = builder.mul(longest, builder.absolute(factor))
    return builder.apply("at_most", builder.absolute(value), product)


def finish(
    context: Lowering, angle: AngleSum, cosine: Node, sine: Node, free: Node | None = None
) -> None:
    """The angle is known; where it is free the seed's value stands for it."""
    builder = context.builder
    if free is not None:
        seed = context.angles.seed(angle)
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
    the vector is as good as the angle itself, so it is taken; `choose_again` looks for one.
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
    """The angle of type 2 where the equation may say little about it, as in `finish_direction`.

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

    There the seed's value stands for it if it is off by rounding alone, and on the same side;
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


def remember(context: Lowering, step: Step, angle: AngleSum, z: Node, root: Node) -> None:
    """X s + Y c is Z and Y s - X c is the signed root: later steps need not compute them."""
    x, y = step.coefficient("X"), step.coefficient("Y")
    s, c = context.generators(angle)
    context.polynomials.remember(x * s + y * c, z)
    context.polynomials.remember(y * s - x * c, root)
