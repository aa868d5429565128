"""The kernels: one closed form for each equation type, with what happens where it degenerates.

Sources: the table of types of document 003 (after W. Khalil and E. Dombre, Modeling, Identification
and Control of Robots, 2002, chapter 4); the forms without division are those of DESIGN, section 3.
"""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.forms import Length
from dhgen.paul.step import Kind
from dhgen.program.quartic import lower_circle
from dhgen.program.roots import (
    finish,
    finish_direction,
    is_short,
    is_short_square,
    keep_one,
    letters,
    named,
    remember,
    signed_root,
)

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.paul.step import Step
    from dhgen.program.graph import Node
    from dhgen.program.lower import Lowering


def lower_length(context: Lowering, step: Step) -> None:
    """Type 1: r = Y / X."""
    (unknown,) = step.unknowns
    assert isinstance(unknown, Length)
    y, x = letters(context, step, "Y X")
    context.angles.solved_slide(unknown.name, context.builder.div(y, x))


def lower_angle(context: Lowering, step: Step) -> None:
    """Type 2: X s + Y c = Z."""
    (angle,) = step.unknowns
    assert isinstance(angle, AngleSum)
    builder = context.builder
    factors = step.coefficient("X"), step.coefficient("Y")
    x = builder.name(context.lower(factors[0]), f"X{angle.suffix}")
    y = builder.name(context.lower(factors[1]), f"Y{angle.suffix}")
    degree = context.scales.degree(*factors)
    if not step.coefficient("Z"):
        _lower_homogeneous(context, step, (x, y), degree)
        return
    z = builder.name(context.lower(step.coefficient("Z")), f"Z{angle.suffix}")
    square = builder.name(builder.add(builder.square(x), builder.square(y)), f"N{angle.suffix}")
    discriminant = builder.name(builder.sub(square, builder.square(z)), f"D{angle.suffix}")
    fixed = context.are_constant(*factors)
    free = None if fixed else is_short_square(context, square, degree, angle)
    twice = builder.mul(builder.integer(2), builder.absolute(z))
    limits = [
        builder.mul(delta, builder.add(twice, delta))  # (|Z| + delta)^2 - Z^2
        for delta in context.scales.distances(degree)
    ]
    inside = builder.apply("at_most", builder.neg(limits[0]), discriminant)
    apart = builder.apply("less", limits[1], discriminant)
    root = signed_root(context, angle, discriminant, inside, apart, free)
    safe = square if free is None else builder.select(free, builder.integer(1), square)
    builder.hint(safe, f"divisor{angle.suffix}")
    inverse = builder.hint(builder.div(builder.integer(1), safe), f"inverse{angle.suffix}")
    sine = builder.add(builder.mul(x, z), builder.mul(y, root))
    cosine = builder.sub(builder.mul(y, z), builder.mul(x, root))
    finish(context, angle, builder.mul(cosine, inverse), builder.mul(sine, inverse), free)
    remember(context, step, angle, z, root)


def _lower_homogeneous(
    context: Lowering, step: Step, vector: tuple[Node, Node], degree: int
) -> None:
    """Type 2 with Z = 0: the angle of a vector or its opposite, always solvable."""
    (angle,) = step.unknowns
    assert isinstance(angle, AngleSum)
    builder = context.builder
    x, y = vector
    square = builder.add(builder.square(x), builder.square(y))
    length = builder.name(builder.apply("sqrt", square), f"w{angle.suffix}")
    free = is_short(context, length, degree, angle)
    sign = context.new_sign()
    keep_one(context, sign, free)
    factor = _over(context, sign, length, free, angle.suffix)
    direction = builder.neg(builder.mul(x, factor)), builder.mul(y, factor)
    if degree == 0 and len(angle.terms) == 1 and context.may_be_lost:
        finish_direction(context, angle, direction, length, free)
    else:
        finish(context, angle, *direction, free)
    root = builder.hint(builder.mul(sign, length), f"root{angle.suffix}")
    remember(context, step, angle, builder.integer(0), root)


def _over(context: Lowering, sign: Node, length: Node, free: Node, suffix: str) -> Node:
    """sign / length, where the length may be none."""
    builder = context.builder
    safe = builder.hint(builder.select(free, builder.integer(1), length), f"divisor{suffix}")
    return builder.hint(builder.div(sign, safe), f"factor{suffix}")


def lower_angle_pair(context: Lowering, step: Step) -> None:
    """Type 3: Cramer's rule, made a unit vector where rounding or the pose may spoil it."""
    (angle,) = step.unknowns
    assert isinstance(angle, AngleSum)
    builder = context.builder
    x1, y1, z1, x2, y2, z2 = letters(context, step, "X1 Y1 Z1 X2 Y2 Z2")
    determinant = builder.sub(builder.mul(x1, y2), builder.mul(x2, y1))
    sine = builder.sub(builder.mul(z1, y2), builder.mul(z2, y1))
    cosine = builder.sub(builder.mul(x1, z2), builder.mul(x2, z1))
    builder.hint(sine, f"S{angle.suffix}")
    builder.hint(cosine, f"C{angle.suffix}")
    factors = [step.coefficient(letter) for letter in ("X1", "Y1", "X2", "Y2")]
    if context.are_constant(*factors) and not context.redundant:
        sine, cosine = builder.div(sine, determinant), builder.div(cosine, determinant)
        finish(context, angle, cosine, sine)
        return
    sides = step.coefficient("Z1"), step.coefficient("Z2")
    degree = context.scales.degree(*factors) + context.scales.degree(*sides)
    facing = _sign_of(context, determinant, step)
    length = builder.apply("sqrt", builder.add(builder.square(sine), builder.square(cosine)))
    length = builder.name(length, f"w{angle.suffix}")
    # the product of two vectors of equal length, which vanish together
    free = is_short_square(context, length, degree // 2, angle)
    factor = _over(context, facing, length, free, angle.suffix)
    finish(context, angle, builder.mul(cosine, factor), builder.mul(sine, factor), free)


def _sign_of(context: Lowering, determinant: Node, step: Step) -> Node:
    """+1 or -1 as the determinant, which is known where X2, Y2 is X1, Y1 turned."""
    builder = context.builder
    x1, y1, x2, y2 = (step.coefficient(letter) for letter in ("X1", "Y1", "X2", "Y2"))
    if (x2, y2) == (-y1, x1):
        return builder.integer(1)
    if (x2, y2) == (y1, -x1):
        return builder.integer(-1)
    negative = builder.apply("less", determinant, builder.integer(0))
    return builder.select(negative, builder.integer(-1), builder.integer(1))


def lower_polar(context: Lowering, step: Step) -> None:
    """Type 4: r and its angle are polar coordinates, or the opposite ones."""
    angle, unknown = step.unknowns
    assert isinstance(angle, AngleSum)
    assert isinstance(unknown, Length)
    builder = context.builder
    x1, y1, x2, y2 = letters(context, step, "X1 Y1 X2 Y2")
    u, v = builder.div(y1, x1), builder.div(y2, x2)
    length = builder.apply("sqrt", builder.add(builder.square(u), builder.square(v)))
    length = builder.name(length, f"w{unknown.joint}")
    free = is_short(context, length, 1, angle)
    sign = context.new_sign()
    keep_one(context, sign, free)
    factor = _over(context, sign, length, free, angle.suffix)
    finish(context, angle, builder.mul(v, factor), builder.mul(u, factor), free)
    context.angles.solved_slide(unknown.name, builder.mul(sign, length))


def lower_angle_and_length(context: Lowering, step: Step) -> None:
    """Type 5: a quadratic in r, then the angle.

    Its discriminant b^2 - a c is written a - (V x W)^2, which loses nothing where it is small.
    """
    angle, unknown = step.unknowns
    assert isinstance(angle, AngleSum)
    assert isinstance(unknown, Length)
    builder = context.builder
    x1, y1, z1, x2, y2, z2 = letters(context, step, "X1 Y1 Z1 X2 Y2 Z2")
    quotients = builder.div(y1, x1), builder.div(z1, x1), builder.div(y2, x2), builder.div(z2, x2)
    for letter, node in zip(("V1", "W1", "V2", "W2"), quotients, strict=True):
        builder.hint(node, named(letter, angle.suffix))
    v1, w1, v2, w2 = quotients
    a = builder.add(builder.square(w1), builder.square(w2))
    b = builder.name(builder.add(builder.mul(v1, w1), builder.mul(v2, w2)), f"B{unknown.joint}")
    off = builder.sub(builder.mul(v1, w2), builder.mul(v2, w1))
    discriminant = builder.name(builder.sub(a, builder.square(off)), f"D{unknown.joint}")
    reach, merge = (
        builder.mul(builder.mul(builder.integer(2), a), delta)
        for delta in context.scales.distances(0)
    )
    inside = builder.apply("at_most", builder.neg(reach), discriminant)
    apart = builder.apply("less", merge, discriminant)
    root = signed_root(context, angle, discriminant, inside, apart)
    r = builder.name(builder.div(builder.sub(root, b), a), unknown.name)
    context.angles.solved_slide(unknown.name, r)
    sine = builder.add(v1, builder.mul(w1, r))
    cosine = builder.add(v2, builder.mul(w2, r))
    finish(context, angle, cosine, sine)


def lower_two_angles(context: Lowering, step: Step) -> None:
    """Types 6, 7, 8 for the difference of the angles: the law of cosines.

    For one of the angles themselves, what is left is of type 2, X s + Y c = Z. With H and L the
    squares of the longest and shortest reach, D = (H - |Z|^2)(|Z|^2 - L) is accurate also where
    the arm is nearly folded.
    """
    if step.has("Z"):
        lower_angle(context, step)
        return
    (angle,) = step.unknowns
    assert isinstance(angle, AngleSum)
    builder = context.builder
    z1, z2 = letters(context, step, "Z1 Z2")
    reach = builder.name(builder.add(builder.square(z1), builder.square(z2)), f"N{angle.suffix}")
    x, y, n = letters(context, step, "X Y N")
    k = builder.name(builder.sub(reach, n), f"K{angle.suffix}")
    square = builder.add(builder.square(x), builder.square(y))
    extremes = partial(context.scales.extreme_reach, step, angle.suffix)
    longest, shortest = extremes("square of the {} reach")
    discriminant = builder.mul(builder.sub(longest, reach), builder.sub(reach, shortest))
    builder.name(discriminant, f"D{angle.suffix}")
    far, near = extremes("the {}, with what rounding adds", context.scales.tolerances.reach)
    inside = builder.apply(
        "and", builder.apply("at_most", near, reach), builder.apply("at_most", reach, far)
    )
    below, above = extremes("the {}, where branches merge", -context.scales.tolerances.merge)
    apart = builder.apply(
        "and", builder.apply("less", above, reach), builder.apply("less", reach, below)
    )
    root = signed_root(context, angle, discriminant, inside, apart)
    if builder.is_zero(x):
        sine, cosine = builder.div(root, y), builder.div(k, y)
    else:
        sine = builder.div(builder.add(builder.mul(x, k), builder.mul(y, root)), square)
        cosine = builder.div(builder.sub(builder.mul(y, k), builder.mul(x, root)), square)
    finish(context, angle, cosine, sine)


KERNELS: dict[Kind, Callable[[Lowering, Step], None]] = {
    Kind.LENGTH: lower_length,
    Kind.ANGLE: lower_angle,
    Kind.ANGLE_PAIR: lower_angle_pair,
    Kind.POLAR: lower_polar,
    Kind.ANGLE_AND_LENGTH: lower_angle_and_length,
    Kind.TWO_ANGLES: lower_two_angles,
    Kind.TWO_ANGLES_TURNED: lower_two_angles,
    Kind.ANGLE_AND_SUM: lower_two_angles,
    Kind.CIRCLE: lower_circle,
}
